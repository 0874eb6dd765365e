//! Paths: segments of any degrees, shapes, SVG, what closed curves enclose.
#![cfg(all(feature = "std", feature = "bspline"))]
#![allow(unreachable_pub)]

mod approximation;
mod enclosed;
mod offsets;
#[allow(dead_code)] // shared with other tests
#[path = "../../../tests/src/random.rs"]
mod random;
mod segments;
mod shapes;
mod simplification;
mod svg;

use basis_runtime::{Path, PathSegment};
use random::Random;

/// A closed path of that many segments of random degrees, some of them rational.
fn closed(random: &mut Random, segments: usize) -> Path<[f64; 2]> {
    let mut point = || [random.between(-3.0, 5.0), random.between(-4.0, 2.0)];
    let corners: Vec<[f64; 2]> = (0..segments).map(|_| point()).collect();
    let all = (0..segments).map(|k| {
        let inner = random.below(5);
        let mut points = vec![corners[k]];
        points.extend((0..inner).map(|_| [random.between(-3.0, 5.0), random.between(-4.0, 2.0)]));
        points.push(corners[(k + 1) % segments]);
        if random.below(2) == 0 {
            PathSegment::polynomial(points).unwrap()
        } else {
            let weights: Vec<f64> = points.iter().map(|_| random.between(0.1, 3.0)).collect();
            PathSegment::rational(points, weights).unwrap()
        }
    });
    Path::new(all.collect()).unwrap()
}

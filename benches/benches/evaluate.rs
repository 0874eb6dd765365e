//! Generated evaluators beside kurbo's cubic Bézier curve, point by point over 4096 parameters.

use basis_benches::parameters;
use basis_runtime::{Curve, basis};
use divan::{Bencher, black_box};
use kurbo::{CubicBez, ParamCurve};

basis!("../../specs/quartic.basis");
basis!("../../specs/bernstein.basis", Bernstein(3));

fn main() {
    divan::main();
}

const COUNT: u32 = 4096;
const POINTS: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]];

/// The peer: kurbo's cubic, two dimensions.
#[divan::bench]
fn kurbo_cubic(bencher: Bencher<'_, '_>) {
    let [a, b, c, d] = POINTS.map(|[x, y]| kurbo::Point::new(x, y));
    let curve = black_box(CubicBez::new(a, b, c, d));
    let parameters = parameters(COUNT);
    let mut out = vec![kurbo::Point::ZERO; COUNT as usize];
    bencher.counter(COUNT).bench_local(|| {
        for (point, t) in out.iter_mut().zip(&parameters) {
            *point = curve.eval(*t);
        }
        black_box(out.as_ptr())
    });
}

/// The cubic Bernstein family, bound to the same points.
#[divan::bench]
fn bernstein_cubic(bencher: Bencher<'_, '_>) {
    let curve = black_box(Curve::new(Bernstein::new(), POINTS));
    let parameters = parameters(COUNT);
    let mut out = vec![[0.0; 2]; COUNT as usize];
    bencher.counter(COUNT).bench_local(|| {
        for (point, t) in out.iter_mut().zip(&parameters) {
            *point = curve.eval(*t);
        }
        black_box(out.as_ptr())
    });
}

/// The quartic family, bound: one degree more than the peer.
#[divan::bench]
fn quartic_bound(bencher: Bencher<'_, '_>) {
    let family = QuarticBernstein::new(0.5).expect("0.5 is in the declared range");
    let curve = black_box(Curve::new(family, POINTS));
    let parameters = parameters(COUNT);
    let mut out = vec![[0.0; 2]; COUNT as usize];
    bencher.counter(COUNT).bench_local(|| {
        for (point, t) in out.iter_mut().zip(&parameters) {
            *point = curve.eval(*t);
        }
        black_box(out.as_ptr())
    });
}

/// The values of the four quartic functions.
#[divan::bench]
fn quartic_values(bencher: Bencher<'_, '_>) {
    let family = black_box(QuarticBernstein::new(0.5).expect("0.5 is in the declared range"));
    let parameters = parameters(COUNT);
    let mut out = vec![[0.0; 4]; COUNT as usize];
    bencher.counter(COUNT).bench_local(|| {
        for (values, t) in out.iter_mut().zip(&parameters) {
            *values = family.values(*t);
        }
        black_box(out.as_ptr())
    });
}

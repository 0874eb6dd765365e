//! Figures of "Two classes of triangular quasi-Bézier surfaces with two shape parameters": both types over one net
//! each, with one parameter growing and the other fixed. The paper prints no control points, so the nets are our own.

use std::error::Error;

use basis_runtime::{ScalarOf, Surface, TriangleIndex, TriangularBasis, TriangularPatch};

use super::families::{TriangularI, TriangularII};
use crate::draw::scene::{Point3d, Scene, View};
use crate::figure::{Drawing, Facts, Figure, Picture};

const VIEW: View = View { azimuth: -70.0, elevation: 24.0 };

/// All figures of the paper.
pub(crate) fn figures() -> Vec<Figure> {
    let mut figures = Vec::new();
    let first = [
        (1.0, 4.0),
        (2.0, 4.0),
        (3.0, 4.0),
        (4.0, 4.0),
        (2.0, 0.0),
        (2.0, 5.0 / 3.0),
        (2.0, 10.0 / 3.0),
        (2.0, 5.0),
    ];
    for (k, (a, b)) in first.into_iter().enumerate() {
        figures.push(Figure::new(
            format!("tri-fig-type1-{}", k + 1),
            format!("Type I, order 2, λ₁ = {}, λ₂ = {}", short(a), short(b)),
            move || patch(TriangularI::new(a, b)?, TriangularI::new(2.0, 4.0)?, 2, [a, b]),
        ));
    }
    let second = [
        (0.0, 2.0),
        (1.0, 2.0),
        (2.0, 2.0),
        (3.0, 2.0),
        (2.0, 0.0),
        (2.0, 2.0 / 3.0),
        (2.0, 4.0 / 3.0),
        (2.0, 2.0),
    ];
    for (k, (a, b)) in second.into_iter().enumerate() {
        figures.push(Figure::new(
            format!("tri-fig-type2-{}", k + 1),
            format!("Type II, order 3, λ₁ = {}, λ₂ = {}", short(a), short(b)),
            move || {
                // The paper draws λ1 = 0, which its own definition leaves out (0 < λ1); here it is the smallest float
                // above 0.
                let inside = if a > 0.0 { a } else { f64::MIN_POSITIVE };
                patch(TriangularII::new(inside, b)?, TriangularII::new(3.0, 2.0)?, 3, [a, b])
            },
        ));
    }
    figures
}

fn short(x: f64) -> String {
    if x.fract() == 0.0 { format!("{x}") } else { format!("{}/3", (3.0 * x).round()) }
}

/// Control points of an order: a triangle whose middle rises.
fn net(order: usize) -> Vec<Point3d> {
    let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.3], [1.4, 3.6, -0.2]];
    TriangleIndex::all(order)
        .map(|index| {
            let index = index.components();
            let weight = index.map(|i| i as f64 / order as f64);
            let flat = [0, 1, 2].map(|c| (0..3).map(|k| weight[k] * corners[k][c]).sum::<f64>());
            let corner = index.contains(&order);
            let inner = index.iter().all(|&i| i > 0);
            let rise = if corner {
                0.0
            } else if inner {
                2.6
            } else {
                1.7
            };
            [flat[0], flat[1], flat[2] + rise]
        })
        .collect()
}

fn patch<B>(basis: B, bezier: B, order: usize, [a, b]: [f64; 2]) -> Result<Drawing, Box<dyn Error>>
where
    B: TriangularBasis<Scalar = f64>,
{
    let points = net(order);
    let patch = TriangularPatch::from_slice(basis, &points)?;
    let bezier = TriangularPatch::from_slice(bezier, &points)?;
    let mut scene = Scene::default();
    let surface = patch.to_tensor_surface();
    let mesh = scene.surfaces(&[surface])?;
    let centre = patch.eval(1.0 / 3.0, 1.0 / 3.0);
    let height = centre[2] - bezier.eval(1.0 / 3.0, 1.0 / 3.0)[2];
    let (low, high) = deviations(&surface, &bezier.to_tensor_surface());
    let facts = Facts::default()
        .with("area", mesh.area())
        .with("triangles", mesh.triangles.len())
        .with("centre", centre.to_vec())
        .with("height of the centre over the Bézier patch of the net", height)
        .with("least height over that patch", low)
        .with("greatest height over that patch", high);
    for line in lines(order) {
        scene.polygon(&line.iter().map(|index| points[index.position()]).collect::<Vec<_>>());
    }
    Ok(Drawing {
        picture: Picture::Surfaces(scene, VIEW),
        params: Facts::default()
            .with("λ₁", a)
            .with("λ₂", b)
            .with("n", order)
            .with("points", points.iter().map(|p| p.to_vec()).collect::<serde_json::Value>()),
        facts,
        note: String::from(if a > 0.0 {
            "λ₁ moves the surface and its boundary curves, λ₂ only the inside."
        } else {
            "λ₁ = 0 is drawn in the paper, but its definition asks for λ₁ > 0; this is the limit: the edges are straight."
        }),
    })
}

/// The smallest and the largest difference of height of two surfaces at equal parameters.
fn deviations<S: Surface<Point = Point3d>>(a: &S, b: &S) -> (ScalarOf<S>, ScalarOf<S>) {
    let mut range = (f64::INFINITY, f64::NEG_INFINITY);
    for i in 0..=24 {
        for j in 0..=24 {
            let (u, v) = (f64::from(i) / 24.0, f64::from(j) / 24.0);
            let difference = a.eval(u, v)[2] - b.eval(u, v)[2];
            range = (range.0.min(difference), range.1.max(difference));
        }
    }
    range
}

/// The lines of a triangular net, in the three directions.
fn lines(order: usize) -> Vec<Vec<TriangleIndex>> {
    let mut lines = Vec::new();
    for fixed in 0..3 {
        for level in 0..order {
            let line = (0..=order - level).map(|k| {
                let mut index = [0; 3];
                index[fixed] = level;
                index[(fixed + 1) % 3] = k;
                index[(fixed + 2) % 3] = order - level - k;
                TriangleIndex::new(index)
            });
            lines.push(line.collect());
        }
    }
    lines
}

//! Compares the methods of splicing on the same pairs of surfaces: spans needed, change of shape, time.
//!
//! `cargo run --release -p basis-runtime --features nalgebra --example compare_splices`

use std::time::Instant;

use basis_runtime::bspline::{
    BSplineSurface, Edge, EdgeKnots, EdgePair, KnotVector, Method, Net, SecondRow, SpliceError, SpliceOptions,
};

type P3 = [f64; 3];

/// A surface whose net follows a function of the Greville abscissae.
fn over(degree: usize, across: &[f64], along: &[f64], shape: impl Fn(f64, f64) -> P3) -> BSplineSurface<P3> {
    let [u, v] = [across, along].map(|b| KnotVector::clamped(degree, b).expect("increasing breakpoints"));
    let (gu, gv) = (u.greville(), v.greville());
    let net = Net::from_fn(gu.len(), gv.len(), |i, j| shape(gu[i], gv[j])).expect("not empty");
    BSplineSurface::new(u, v, net).expect("the right size")
}

struct Case {
    name: &'static str,
    surface: BSplineSurface<P3>,
    target: BSplineSurface<P3>,
}

fn cases() -> Vec<Case> {
    let across = [0.0, 0.25, 0.5, 0.75, 1.0];
    let five = [0.0, 0.22, 0.41, 0.63, 0.8, 1.0];
    let eight = [0.0, 0.09, 0.2, 0.37, 0.45, 0.6, 0.78, 0.9, 1.0];
    let wave = |v: f64| 0.3 * (4.2 * v + 0.4).sin();
    let hill = |v: f64, height: f64, width: f64| height * (-((v - 0.55) / width).powi(2)).exp();
    let left =
        move |degree, spans: &[f64]| over(degree, &across, spans, |u, v| [u, v, wave(v) * (0.6 + 0.4 * u)]);
    let right = move |degree, height, width| {
        over(degree, &across, &eight, move |u, v| {
            let z = wave(v) * (1.0 - 0.35 * u) + hill(v, height, width) * (1.0 - 0.6 * u) + 0.15 * u;
            [1.0 + u + 0.08 * (5.0 * v).sin(), v + 0.05 * u * v, z]
        })
    };
    let slanted = over(3, &across, &eight, |u, v| [1.0 + u, v + 0.5 * u, wave(v) + 0.2 * u * u]);
    let fan = over(3, &across, &eight, |u, v| {
        let (radius, turn) = (1.0 + u, 0.9 * v * (u - 0.3));
        [radius + 1.4 * u * (v - 0.5), v + 0.2 * turn, wave(v) + 0.3 * u * u]
    });
    let straight = over(3, &across, &eight, |u, v| [1.0 + u, v, u * wave(v)]);
    vec![
        Case { name: "mild, cubic", surface: left(3, &five), target: right(3, 0.05, 0.3) },
        Case { name: "harsh, cubic", surface: left(3, &five), target: right(3, 0.22, 0.13) },
        Case { name: "mild, quadratic to cubic", surface: left(2, &five), target: right(3, 0.05, 0.3) },
        Case { name: "mild, quintic to cubic", surface: left(5, &five), target: right(3, 0.05, 0.3) },
        Case { name: "slanted", surface: left(3, &five), target: slanted },
        Case { name: "widths from 0.3 to 1.7", surface: left(3, &five), target: fan },
        Case { name: "straight edge", surface: left(3, &five), target: straight },
    ]
}

fn main() {
    let edges = EdgePair::along(Edge::UStart, Edge::UEnd);
    let least = SpliceOptions::default().method(Method::LeastSquares);
    let own = least.edge_knots(EdgeKnots::Own);
    let kept = own.second_row(SecondRow::Kept);
    let methods = [
        ("paper", kept.method(Method::Midpoints)),
        ("paper, carried", own.method(Method::Midpoints)),
        ("paper, carried, merged", least.method(Method::Midpoints)),
        ("least squares", kept),
        ("least squares, carried", own),
        ("least squares, carried, merged", least),
        ("exact", least.method(Method::Exact)),
    ];
    println!("| case | method | spans | rounds | gap | angle | change | time |");
    println!("| --- | --- | --- | --- | --- | --- | --- | --- |");
    for case in cases() {
        for (method, options) in &methods {
            let run = || {
                let start = Instant::now();
                let result = case.target.continued_within(edges, options, &case.surface);
                (result, start.elapsed().as_secs_f64() * 1e3)
            };
            // The best time of several; the result is the same each time.
            let (result, first) = run();
            let time = (0..8).map(|_| run().1).fold(first, f64::min);
            let name = case.name;
            match result {
                Ok(s) => println!(
                    "| {name} | {method} | {} | {} | {:.1e} | {:.1e} | {:.4} | {time:.2} ms |",
                    s.spans, s.rounds, s.joint.gap, s.joint.angle, s.change
                ),
                Err(SpliceError::NotReached { achieved, spans, .. }) => println!(
                    "| {name} | {method} | not with {spans} | | {:.1e} | {:.1e} | | {time:.0} ms |",
                    achieved.gap, achieved.angle
                ),
                Err(error) => println!("| {name} | {method} | {error} | | | | | |"),
            }
        }
    }
}

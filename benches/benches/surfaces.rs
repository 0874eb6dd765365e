//! Grids of surfaces beside the naive sum and curvo, on the same work in the same run:
//! `cargo bench -p basis-benches --bench surfaces`.
//!
//! Prints a table in Markdown. The surface is bicubic, three dimensions in f64, on a grid of 1000 × 1000 parameters;
//! ours is the generated family `Bernstein(3)`, and the quartic surface with five shape parameters. All contestants
//! take turns; the fastest of several rounds counts. A million points are 24 megabytes, so that `eval_grid` waits for
//! the memory: filling the grid with one point takes as long. What the arithmetic costs shows where each row goes to
//! the same place, which stays in the cache.

use std::time::Instant;

use basis_runtime::{Basis, Point, Surface, TensorSurface, basis};
use curvo::prelude::{KnotVector, NurbsSurface3D};
use divan::black_box;
use nalgebra::Point4;

basis!("../../specs/quartic.basis");
basis!("../../specs/bernstein.basis", Bernstein(3));

const SIDE: usize = 1000;
const ROUNDS: usize = 5;

fn main() {
    let net: [[[f64; 3]; 4]; 4] = core::array::from_fn(|i| {
        core::array::from_fn(|j| [i as f64, j as f64, ((i * 3 + j * 5) % 4) as f64])
    });
    let bicubic = black_box(TensorSurface::new(Bernstein::new(), Bernstein::new(), net));
    let shape = |value| QuarticBernstein::new(value).expect("in the declared range");
    let quartic = black_box(TensorSurface::with_rows(shape(0.5), [0.1, -0.4, 0.9, -1.2].map(shape), net));
    let knots = || KnotVector::from(vec![0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0]);
    let weighted =
        net.iter().map(|row| row.iter().map(|&[x, y, z]| Point4::new(x, y, z, 1.0)).collect()).collect();
    let peer: NurbsSurface3D<f64> = black_box(NurbsSurface3D::new(3, 3, knots(), knots(), weighted));

    let ts: Vec<f64> = (0..SIDE).map(|k| k as f64 / (SIDE - 1) as f64).collect();
    let mut out = vec![[0.0; 3]; SIDE * SIDE];
    let mut peer_out = vec![nalgebra::Point3::origin(); SIDE * SIDE];

    let mut row = vec![[0.0; 3]; SIDE];
    let mut best = [f64::MAX; 10];
    for _ in 0..ROUNDS {
        let mut time = |index: usize, work: &mut dyn FnMut()| {
            let start = Instant::now();
            work();
            best[index] = best[index].min(start.elapsed().as_nanos() as f64 / (SIDE * SIDE) as f64);
        };
        time(0, &mut || each(&ts, &mut peer_out, |u, v| peer.point_at(u, v)));
        time(1, &mut || each(&ts, &mut out, |u, v| naive(&bicubic, u, v)));
        time(2, &mut || each(&ts, &mut out, |u, v| bicubic.eval(u, v)));
        time(3, &mut || bicubic.eval_grid(&ts, &ts, &mut out).expect("one place for each pair"));
        time(4, &mut || out.fill(black_box([1.0; 3])));
        time(5, &mut || rows(&ts, &mut row, |u, row| points(u, &ts, row, |u, v| naive(&bicubic, u, v))));
        time(6, &mut || {
            rows(&ts, &mut row, |u, row| bicubic.eval_grid(&[u], &ts, row).expect("one place for each pair"))
        });
        time(7, &mut || each(&ts, &mut out, |u, v| naive(&quartic, u, v)));
        time(8, &mut || quartic.eval_grid(&ts, &ts, &mut out).expect("one place for each pair"));
        time(9, &mut || {
            rows(&ts, &mut row, |u, row| quartic.eval_grid(&[u], &ts, row).expect("one place for each pair"))
        });
        black_box(&out);
        black_box(&peer_out);
    }
    println!(
        "| surface, 1000 × 1000 points | ns per point | faster than curvo | faster than the naive sum |"
    );
    println!("| --- | --- | --- | --- |");
    let names = [
        "curvo, bicubic",
        "bicubic, naive double sum",
        "bicubic, `eval`",
        "bicubic, `eval_grid`",
        "one point written everywhere",
        "bicubic, naive double sum, row after row in one place",
        "bicubic, `eval_grid`, row after row in one place",
        "quartic with five parameters, naive double sum",
        "quartic with five parameters, `eval_grid`",
        "quartic with five parameters, `eval_grid`, row after row in one place",
    ];
    for (k, name) in names.iter().enumerate() {
        let sum = if k < 7 { best[1] } else { best[7] };
        println!("| {name} | {:.2} | {:.1}× | {:.1}× |", best[k], best[0] / best[k], sum / best[k]);
    }
}

fn each<P>(ts: &[f64], out: &mut [P], point: impl Fn(f64, f64) -> P) {
    for (&u, row) in ts.iter().zip(out.chunks_mut(ts.len())) {
        points(u, ts, row, &point);
    }
}

fn points<P>(u: f64, vs: &[f64], row: &mut [P], point: impl Fn(f64, f64) -> P) {
    for (&v, slot) in vs.iter().zip(row) {
        *slot = point(u, v);
    }
}

/// Every row of the grid written to the same place, as for a consumer that takes rows one by one.
fn rows<P>(us: &[f64], row: &mut [P], fill: impl Fn(f64, &mut [P])) {
    for &u in us {
        fill(u, row);
        black_box(&row);
    }
}

/// `Σ_i Σ_j b_i(u) c_j(v) P_ij`, with the functions evaluated again for each point.
fn naive<U, V>(surface: &TensorSurface<U, V, [f64; 3]>, u: f64, v: f64) -> [f64; 3]
where
    U: Basis<Scalar = f64>,
    V: Basis<Scalar = f64>,
{
    let weights = surface.u_basis().values(u);
    let mut sum = [0.0; 3];
    for (row, &b) in surface.rows().iter().zip(weights.as_ref()) {
        let values = row.basis().values(v);
        for (&point, &c) in row.control_points().iter().zip(values.as_ref()) {
            sum = sum.add_weighted(point, b * c);
        }
    }
    sum
}

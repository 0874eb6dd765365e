//! B-splines beside curvo's, and the splice as the spans grow: `cargo bench -p basis-benches --bench splines`.
//!
//! curvo's curves are always rational, so ours stand here in both forms: `polynomial` does the work that was asked for,
//! `rational` the same work as curvo. `splines.py` asks scipy.

use basis_benches::parameters;
use basis_runtime::Surface;
use basis_runtime::bspline::{
    BSplineCurve, BSplineSurface, Direction, Edge, EdgePair, KnotVector, Method, Net, NurbsCurve,
    SpliceOptions,
};
use curvo::prelude::{NurbsCurve3D, NurbsSurface3D};
use divan::{Bencher, black_box};
use nalgebra::Point4;

type P3 = [f64; 3];

const COUNT: u32 = 4096;
const SPANS: usize = 64;

fn main() {
    divan::main();
}

fn knots(degree: usize, spans: usize) -> KnotVector<f64> {
    KnotVector::uniform(degree, spans).expect("a positive number of spans")
}

fn point(i: usize, j: usize) -> P3 {
    let (x, y) = (i as f64, j as f64);
    [x, y + 0.3 * (0.7 * x).sin(), (0.4 * x).cos() * (0.3 * y).sin()]
}

fn ours() -> BSplineCurve<P3> {
    let knots = knots(3, SPANS);
    let points: Vec<P3> = (0..knots.functions()).map(|i| point(i, 0)).collect();
    BSplineCurve::new(knots, points).expect("as many points as functions")
}

fn curvos() -> NurbsCurve3D<f64> {
    let ours = ours();
    let points = ours.control_points().iter().map(|[x, y, z]| Point4::new(*x, *y, *z, 1.0)).collect();
    NurbsCurve3D::try_new(3, points, ours.knots().as_slice().to_vec()).expect("valid for curvo too")
}

fn surface(spans: usize) -> BSplineSurface<P3> {
    let knots = knots(3, spans);
    let net = Net::from_fn(spans + 3, spans + 3, point).expect("not empty");
    BSplineSurface::new(knots.clone(), knots, net).expect("the right size")
}

fn curvo_surface(spans: usize) -> NurbsSurface3D<f64> {
    let ours = surface(spans);
    let row = |i: usize| ours.net().row(i).iter().map(|[x, y, z]| Point4::new(*x, *y, *z, 1.0)).collect();
    let knots = || ours.knots(Direction::U).as_slice().to_vec();
    NurbsSurface3D::new(3, 3, knots(), knots(), (0..spans + 3).map(row).collect())
}

/// The same for each parameter; the results are used.
fn each<T>(parameters: &[f64], mut work: impl FnMut(f64) -> T) {
    for &t in parameters {
        black_box(work(t));
    }
}

mod curve_points {
    use super::{Bencher, COUNT, NurbsCurve, black_box, curvos, each, ours, parameters};

    #[divan::bench]
    fn polynomial(bencher: Bencher<'_, '_>) {
        let (curve, parameters) = (black_box(ours()), parameters(COUNT));
        let mut out = vec![[0.0; 3]; COUNT as usize];
        bencher.counter(COUNT).bench_local(|| {
            curve.eval_into(&parameters, &mut out).expect("both have one length");
            black_box(out.as_ptr())
        });
    }

    #[divan::bench]
    fn rational(bencher: Bencher<'_, '_>) {
        let (curve, parameters) = (black_box(NurbsCurve::from(ours())), parameters(COUNT));
        bencher.counter(COUNT).bench_local(|| each(&parameters, |t| curve.eval(t)));
    }

    #[divan::bench]
    fn curvo(bencher: Bencher<'_, '_>) {
        let (curve, parameters) = (black_box(curvos()), parameters(COUNT));
        bencher.counter(COUNT).bench_local(|| each(&parameters, |t| curve.point_at(t)));
    }

    /// Its evaluator reuses memory from point to point.
    #[divan::bench]
    fn curvo_evaluator(bencher: Bencher<'_, '_>) {
        let (curve, parameters) = (black_box(curvos()), parameters(COUNT));
        bencher.counter(COUNT).bench_local(|| {
            let mut evaluator = curve.evaluator();
            each(&parameters, |t| evaluator.point_at(t));
        });
    }
}

mod curve_derivatives {
    use super::{Bencher, COUNT, NurbsCurve, black_box, curvos, each, ours, parameters};

    #[divan::bench]
    fn polynomial(bencher: Bencher<'_, '_>) {
        let (curve, parameters) = (black_box(ours()), parameters(COUNT));
        bencher.counter(COUNT).bench_local(|| {
            each(&parameters, |t| curve.eval_with_derivs::<3>(t));
        });
    }

    #[divan::bench]
    fn rational(bencher: Bencher<'_, '_>) {
        let (curve, parameters) = (black_box(NurbsCurve::from(ours())), parameters(COUNT));
        bencher.counter(COUNT).bench_local(|| {
            each(&parameters, |t| curve.eval_with_derivs::<3>(t));
        });
    }

    #[divan::bench]
    fn curvo(bencher: Bencher<'_, '_>) {
        let (curve, parameters) = (black_box(curvos()), parameters(COUNT));
        bencher.counter(COUNT).bench_local(|| {
            each(&parameters, |t| curve.rational_derivatives(t, 2));
        });
    }
}

mod surface_points {
    use super::{Bencher, Surface, black_box, curvo_surface, each, parameters, surface};

    const SIDE: u32 = 64;

    #[divan::bench]
    fn polynomial(bencher: Bencher<'_, '_>) {
        let (surface, parameters) = (black_box(surface(16)), parameters(SIDE));
        bencher.counter(SIDE * SIDE).bench_local(|| {
            for &u in &parameters {
                each(&parameters, |v| surface.eval(u, v));
            }
        });
    }

    #[divan::bench]
    fn polynomial_grid(bencher: Bencher<'_, '_>) {
        let (surface, parameters) = (black_box(surface(16)), parameters(SIDE));
        let mut out = vec![[0.0; 3]; (SIDE * SIDE) as usize];
        bencher.counter(SIDE * SIDE).bench_local(|| {
            surface.eval_grid(&parameters, &parameters, &mut out).expect("one place for each pair");
            black_box(out[0]);
        });
    }

    #[divan::bench]
    fn polynomial_normals(bencher: Bencher<'_, '_>) {
        let (surface, parameters) = (black_box(surface(16)), parameters(SIDE));
        bencher.counter(SIDE * SIDE).bench_local(|| {
            for &u in &parameters {
                each(&parameters, |v| surface.normal(u, v));
            }
        });
    }

    #[divan::bench]
    fn curvo(bencher: Bencher<'_, '_>) {
        let (surface, parameters) = (black_box(curvo_surface(16)), parameters(SIDE));
        bencher.counter(SIDE * SIDE).bench_local(|| {
            for &u in &parameters {
                each(&parameters, |v| surface.point_at(u, v));
            }
        });
    }

    #[divan::bench]
    fn curvo_normals(bencher: Bencher<'_, '_>) {
        let (surface, parameters) = (black_box(curvo_surface(16)), parameters(SIDE));
        bencher.counter(SIDE * SIDE).bench_local(|| {
            for &u in &parameters {
                each(&parameters, |v| surface.normal_at(u, v));
            }
        });
    }
}

/// One knot, or the middle of every span, into a curve of 64 spans.
mod insertion {
    use super::{Bencher, SPANS, black_box, curvos, ours};

    fn middles() -> Vec<f64> {
        (0..SPANS).map(|i| (i as f64 + 0.5) / SPANS as f64).collect()
    }

    #[divan::bench]
    fn one(bencher: Bencher<'_, '_>) {
        let curve = black_box(ours());
        bencher.bench_local(|| black_box(curve.insert_knots(&[0.503])));
    }

    #[divan::bench]
    fn one_curvo(bencher: Bencher<'_, '_>) {
        let curve = black_box(curvos());
        bencher.bench_local(|| {
            let mut curve = curve.clone();
            curve.try_add_knot(0.503).expect("inside of the domain");
            black_box(curve)
        });
    }

    #[divan::bench]
    fn all_middles(bencher: Bencher<'_, '_>) {
        let (curve, middles) = (black_box(ours()), middles());
        bencher.bench_local(|| black_box(curve.insert_knots(&middles)));
    }

    #[divan::bench]
    fn all_middles_curvo(bencher: Bencher<'_, '_>) {
        let (curve, middles) = (black_box(curvos()), middles());
        bencher.bench_local(|| {
            let mut curve = curve.clone();
            curve.try_refine_knot(middles.clone()).expect("inside of the domain");
            black_box(curve)
        });
    }
}

/// The nearest point of a curve with 64 spans from points around it. curvo's search is local and has no bound.
mod nearest {
    use super::{Bencher, P3, SPANS, black_box, curvos, ours};

    const POINTS: u32 = 256;

    fn targets() -> Vec<P3> {
        let target = |i: u32| {
            let x = f64::from(i) / f64::from(POINTS) * SPANS as f64;
            [x, 2.0 * (1.7 * x).sin(), 0.25]
        };
        (0..POINTS).map(target).collect()
    }

    #[divan::bench]
    fn with_bound(bencher: Bencher<'_, '_>) {
        let (curve, targets) = (black_box(ours()), targets());
        bencher.counter(POINTS).bench_local(|| {
            for &target in &targets {
                black_box(basis_runtime::ParametricCurve::nearest(&curve, target, 1e-9));
            }
        });
    }

    #[divan::bench]
    fn curvo(bencher: Bencher<'_, '_>) {
        let (curve, targets) = (black_box(curvos()), targets());
        bencher.counter(POINTS).bench_local(|| {
            for &target in &targets {
                let _ = black_box(curve.find_closest_parameter(&nalgebra::Point3::from(target)));
            }
        });
    }
}

/// Two surfaces, with as many spans along the joint and one more, to 1e-5 and 1e-4.
mod splicing {
    use super::{BSplineSurface, Bencher, Edge, EdgePair, Method, Net, P3, SpliceOptions, black_box, knots};

    fn pair(spans: usize) -> [BSplineSurface<P3>; 2] {
        let sheet = |spans: usize, from: f64| {
            let (u, v) = (knots(3, 4), knots(3, spans));
            let (gu, gv) = (u.greville(), v.greville());
            let net = Net::from_fn(gu.len(), gv.len(), |i, j| {
                let (x, y): (f64, f64) = (from + gu[i], gv[j]);
                [x, y, 0.2 * (4.0 * y + x).sin()]
            });
            BSplineSurface::new(u, v, net.expect("not empty")).expect("the right size")
        };
        [sheet(spans, -1.0), sheet(spans + 1, 0.0)]
    }

    fn run(bencher: Bencher<'_, '_>, spans: usize, method: Method) {
        let [surface, target] = pair(spans);
        let edges = EdgePair::along(Edge::UStart, Edge::UEnd);
        let options = SpliceOptions::default().method(method);
        bencher.bench_local(|| black_box(target.continued_within(edges, &options, &surface)));
    }

    #[divan::bench(args = [8, 16, 32, 64, 128])]
    fn exact(bencher: Bencher<'_, '_>, spans: usize) {
        run(bencher, spans, Method::Exact);
    }

    #[divan::bench(args = [8, 16, 32, 64, 128])]
    fn least_squares(bencher: Bencher<'_, '_>, spans: usize) {
        run(bencher, spans, Method::LeastSquares);
    }

    #[divan::bench(args = [8, 16, 32, 64, 128])]
    fn published(bencher: Bencher<'_, '_>, spans: usize) {
        run(bencher, spans, Method::Midpoints);
    }
}

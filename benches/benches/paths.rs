//! Parallel curves, strokes and simplification beside kurbo's, and fits: `cargo bench -p basis-benches --bench paths`.
//!
//! The numbers of segments stand above the times. `benches/splines.py` asks scipy for the fits of splines.

use basis_runtime::bspline::KnotVector;
use basis_runtime::{BernsteinBasis, Bezier, Fit, FitEnd, ParametricCurve, Path, Stroke};
use divan::{Bencher, black_box};
use kurbo::{BezPath, CubicBez, Point, Shape, StrokeOpts};

type P2 = [f64; 2];

/// A curve with a stretch in which the radius of curvature is below the distance.
const CUBIC: [P2; 4] = [[0.0, 0.0], [4.0, 3.0], [-1.0, 3.0], [3.0, 0.0]];
const DISTANCE: f64 = 0.5;
const TOLERANCES: [f64; 3] = [1e-2, 1e-4, 1e-6];

fn main() {
    for tolerance in TOLERANCES {
        let ours = ours().offset(DISTANCE, tolerance).expect("finite");
        let ours: usize = ours.iter().map(|path| path.segments().len()).sum();
        let kurbos = kurbo_offset(tolerance).elements().len() - 1;
        println!("offset to {tolerance:e}: {ours} segments, kurbo's {kurbos}");
    }
    divan::main();
}

fn ours() -> Bezier<P2, 4> {
    Bezier::from_points(CUBIC)
}

fn kurbos() -> CubicBez {
    let [a, b, c, d] = CUBIC.map(|[x, y]| Point::new(x, y));
    CubicBez::new(a, b, c, d)
}

/// kurbo's distances are to the other side.
fn kurbo_offset(tolerance: f64) -> BezPath {
    let mut path = BezPath::new();
    kurbo::offset::offset_cubic(kurbos(), -DISTANCE, tolerance, &mut path);
    path
}

mod offset {
    use super::{Bencher, DISTANCE, ParametricCurve, TOLERANCES, black_box, kurbo_offset, ours};

    #[divan::bench(args = TOLERANCES)]
    fn proved(bencher: Bencher<'_, '_>, tolerance: f64) {
        let curve = black_box(ours());
        bencher.bench_local(|| black_box(curve.offset(DISTANCE, tolerance)));
    }

    #[divan::bench(args = TOLERANCES)]
    fn kurbo(bencher: Bencher<'_, '_>, tolerance: f64) {
        bencher.bench_local(|| black_box(kurbo_offset(black_box(tolerance))));
    }
}

mod stroke {
    use super::{Bencher, DISTANCE, Shape, Stroke, StrokeOpts, TOLERANCES, black_box, kurbos, ours};

    #[divan::bench(args = TOLERANCES)]
    fn proved(bencher: Bencher<'_, '_>, tolerance: f64) {
        let (curve, stroke) = (black_box(ours()), Stroke::new(2.0 * DISTANCE, tolerance).expect("positive"));
        bencher.bench_local(|| black_box(stroke.of(&curve)));
    }

    #[divan::bench(args = TOLERANCES)]
    fn kurbo(bencher: Bencher<'_, '_>, tolerance: f64) {
        let (curve, style) = (black_box(kurbos()), kurbo::Stroke::new(2.0 * DISTANCE));
        let path = curve.into_path(tolerance);
        bencher.bench_local(|| {
            black_box(kurbo::stroke(
                path.elements().iter().copied(),
                &style,
                &StrokeOpts::default(),
                tolerance,
            ))
        });
    }
}

/// A cubic in 32 pieces.
mod simplify {
    use kurbo::ParamCurve;
    use kurbo::simplify::{SimplifyOptions, simplify_bezpath};

    use super::{Bencher, BezPath, Path, TOLERANCES, black_box, kurbos, ours};

    const PIECES: usize = 32;

    fn range(k: usize) -> core::ops::Range<f64> {
        k as f64 / PIECES as f64..(k + 1) as f64 / PIECES as f64
    }

    #[divan::bench(args = TOLERANCES)]
    fn proved(bencher: Bencher<'_, '_>, tolerance: f64) {
        let curve = ours();
        let mut path = Path::from_curve(&curve.subsegment(range(0)).expect("inside"));
        for k in 1..PIECES {
            path.append(&curve.subsegment(range(k)).expect("inside"));
        }
        bencher.bench_local(|| black_box(path.simplified(tolerance)));
    }

    #[divan::bench(args = TOLERANCES)]
    fn kurbo(bencher: Bencher<'_, '_>, tolerance: f64) {
        let curve = kurbos();
        let path = BezPath::from_path_segments((0..PIECES).map(|k| curve.subsegment(range(k)).into()));
        bencher.bench_local(|| black_box(simplify_bezpath(&path, tolerance, &SimplifyOptions::default())));
    }
}

/// A thousand points of a wave.
mod fit {
    use super::{Bencher, BernsteinBasis, Fit, FitEnd, KnotVector, P2, black_box};

    fn wave() -> Vec<P2> {
        (0..1000).map(|i| f64::from(i) / 100.0).map(|x| [x, x.sin()]).collect()
    }

    #[divan::bench]
    fn cubic(bencher: Bencher<'_, '_>) {
        let points = &wave()[..300];
        let fit = Fit::new(points).ends([FitEnd::Interpolated; 2]);
        bencher.bench_local(|| black_box(fit.curve(BernsteinBasis::<f64, 4>::default())));
    }

    #[divan::bench]
    fn cubic_orthogonal(bencher: Bencher<'_, '_>) {
        let points = &wave()[..300];
        let fit = Fit::new(points).ends([FitEnd::Interpolated; 2]).orthogonal(10);
        bencher.bench_local(|| black_box(fit.curve(BernsteinBasis::<f64, 4>::default())));
    }

    #[divan::bench]
    fn spline_over_knots(bencher: Bencher<'_, '_>) {
        let points = wave();
        let knots = KnotVector::uniform(3, 20).expect("a positive number of spans");
        bencher.bench_local(|| black_box(Fit::new(&points).spline(knots.clone())));
    }

    #[divan::bench]
    fn spline_within(bencher: Bencher<'_, '_>) {
        let points = wave();
        bencher.bench_local(|| black_box(Fit::new(&points).spline_within(3, 1e-3)));
    }
}

//! Curves with sines and exponentials at many parameters, beside one sine and cosine of the standard library for each.

use basis_benches::parameters;
use basis_runtime::{Point, RationalBasis, RationalCurve, basis};
use divan::{Bencher, black_box};

basis!(library "trigonometric/han", CubicTrigonometricBezier);
basis!(library "trigonometric/end_angle", CBezierQuadratic, HBezierQuadratic, ExponentialBernstein(3));
basis!(library "trigonometric/mixed", CBezierCubic);
basis!(library "rational/bezier", RationalQuadratic);

fn main() {
    divan::main();
}

const COUNT: u32 = 4096;

/// Parameters of a domain, both ends included.
fn along([lo, hi]: [f64; 2]) -> Vec<f64> {
    parameters(COUNT).into_iter().map(|x| (lo * (1.0 - x) + hi * x).clamp(lo, hi)).collect()
}

/// What a curve is compared with.
#[divan::bench]
fn sin_cos(bencher: Bencher<'_, '_>) {
    let ts = along([0.0, std::f64::consts::FRAC_PI_2]);
    let mut out = vec![[0.0; 2]; COUNT as usize];
    bencher.counter(COUNT).bench_local(|| {
        for (point, t) in out.iter_mut().zip(&ts) {
            let (sin, cos) = black_box(*t).sin_cos();
            *point = [cos, sin];
        }
        black_box(out.as_ptr())
    });
}

fn slice<B: RationalBasis<Scalar = f64>, P: Point<Scalar = f64>>(
    bencher: Bencher<'_, '_>,
    curve: RationalCurve<B, P>,
) {
    let (curve, ts) = (black_box(curve), along(curve.domain()));
    let mut out = vec![P::zero(); COUNT as usize];
    bencher.counter(COUNT).bench_local(|| {
        curve.eval_into(&ts, &mut out).expect("as many points as parameters");
        black_box(out.as_ptr())
    });
}

const FOUR: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]];
const THREE: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 2.0], [3.0, 0.0]];

/// Of degree 6 in the tangent.
#[divan::bench]
fn trigonometric_cubic(bencher: Bencher<'_, '_>) {
    slice(bencher, CubicTrigonometricBezier::new(0.5, -0.25).expect("inside").curve(FOUR));
}

/// The same in space.
#[divan::bench]
fn trigonometric_cubic_in_space(bencher: Bencher<'_, '_>) {
    let points = FOUR.map(|[x, y]| [x, y, x - y]);
    slice(bencher, CubicTrigonometricBezier::new(0.5, -0.25).expect("inside").curve(points));
}

/// Points one by one.
#[divan::bench]
fn trigonometric_cubic_points(bencher: Bencher<'_, '_>) {
    let curve = black_box(CubicTrigonometricBezier::new(0.5, -0.25).expect("inside").curve(FOUR));
    let ts = along(curve.domain());
    let mut out = vec![[0.0; 2]; COUNT as usize];
    bencher.counter(COUNT).bench_local(|| {
        for (point, t) in out.iter_mut().zip(&ts) {
            *point = curve.eval(*t);
        }
        black_box(out.as_ptr())
    });
}

#[divan::bench]
fn c_bezier_quadratic(bencher: Bencher<'_, '_>) {
    slice(bencher, CBezierQuadratic::new(1.0).expect("inside").curve(THREE));
}

#[divan::bench]
fn h_bezier_quadratic(bencher: Bencher<'_, '_>) {
    slice(bencher, HBezierQuadratic::new(1.0).expect("inside").curve(THREE));
}

#[divan::bench]
fn exponential_cubic(bencher: Bencher<'_, '_>) {
    slice(bencher, ExponentialBernstein::new(1.0).expect("inside").curve(FOUR));
}

#[divan::bench]
fn rational_quadratic(bencher: Bencher<'_, '_>) {
    slice(bencher, RationalQuadratic::new(1.0, 0.5, 1.0).expect("inside").curve(THREE));
}

/// With t beside sin t.
#[divan::bench]
fn c_bezier_cubic(bencher: Bencher<'_, '_>) {
    slice(bencher, CBezierCubic::new(1.0).expect("inside").curve(FOUR));
}

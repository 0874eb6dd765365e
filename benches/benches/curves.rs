//! Curves beside those of other crates, on the same work in the same run:
//! `cargo bench -p basis-benches --bench curves`.
//!
//! Prints a table in Markdown. All contestants of a row take turns, so that what else runs on the machine hits all of
//! them; the fastest of many rounds counts. The curve is always the same cubic, with the scalar type and the dimension
//! of the peer; ours is the generated family `Bernstein(3)` and, one degree higher, `QuarticBernstein` with λ = 1/2.

use std::time::Instant;

use basis_benches::Random;
use basis_runtime::{Basis, Curve, Point, Scalar, basis};
use bevy_math::cubic_splines::CubicSegment;
use divan::black_box;
use enterpolation::Signal;
use glam::DVec3;
use kurbo::{CubicBez, ParamCurve, ParamCurveArclen, ParamCurveDeriv, ParamCurveNearest};

basis!("../../specs/quartic.basis");
basis!("../../specs/bernstein.basis", Bernstein(3));

const COUNT: usize = 4000; // no power of two: results at equal offsets of a page would hinder each other
const ROUNDS: usize = 60;
const POINTS: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 2.0, -1.0], [3.0, 2.5, 0.5], [4.0, 0.0, 1.0]];
const ACCURACY: f64 = 1e-9;

fn main() {
    println!("| work | peer | its time | ours, one at a time | ours, slices | quartic family, slices |");
    println!("| --- | --- | --- | --- | --- | --- |");
    points();
    derivatives();
    lengths();
    nearest();
    println!();
    errors();
    bound_of_the_machine();
}

type Contestant<'a> = Box<dyn FnMut() + 'a>;

/// The best time of each contestant in nanoseconds for one of `units` in a call.
fn race(units: usize, mut contestants: Vec<Contestant<'_>>) -> Vec<f64> {
    let mut best = vec![f64::MAX; contestants.len()];
    for _ in 0..ROUNDS {
        for (contestant, best) in contestants.iter_mut().zip(&mut best) {
            let start = Instant::now();
            contestant();
            *best = best.min(start.elapsed().as_nanos() as f64 / units as f64);
        }
    }
    best
}

/// The peer's time, and for the others the time and how many times faster than the peer they are.
fn row(work: &str, peer: &str, times: &[f64]) {
    let ours = times[1..].iter().map(|time| format!("{time:.2} ns, {:.1}×", times[0] / time));
    println!("| {work} | {peer} | {:.2} ns | {} |", times[0], ours.collect::<Vec<_>>().join(" | "));
}

fn control_points<P: Point, const N: usize>() -> [P; N] {
    core::array::from_fn(|i| P::from_components(|d| P::Scalar::of(POINTS[i][d])))
}

fn cubic<P: Point>() -> Curve<Bernstein<P::Scalar>, P> {
    black_box(Curve::new(Bernstein::new(), control_points()))
}

fn quartic<P: Point>() -> Curve<QuarticBernstein<P::Scalar>, P> {
    let family = QuarticBernstein::new(P::Scalar::of(0.5)).expect("0.5 is in the declared range");
    black_box(Curve::new(family, control_points()))
}

fn parameters<S: Scalar>() -> Vec<S> {
    (0..COUNT).map(|i| S::from_usize(i) / S::from_usize(COUNT - 1)).collect()
}

/// Calls `at` for all parameters and keeps the results.
fn each<'a, T: Copy, R: Copy + 'a>(ts: &'a [T], zero: R, at: impl Fn(T) -> R + 'a) -> Contestant<'a> {
    let mut out = vec![zero; ts.len()];
    Box::new(move || {
        for (out, &t) in out.iter_mut().zip(ts) {
            *out = at(t);
        }
        black_box(out.as_ptr());
    })
}

fn slices<'a, B, P>(curve: Curve<B, P>, ts: &'a [B::Scalar]) -> Contestant<'a>
where
    B: Basis + 'a,
    P: Point<Scalar = B::Scalar> + 'a,
{
    let mut out = vec![P::zero(); ts.len()];
    Box::new(move || {
        curve.eval_into(ts, &mut out).expect("as many points as parameters");
        black_box(out.as_ptr());
    })
}

fn derivative_slices<'a, B, P, const K: usize>(curve: Curve<B, P>, ts: &'a [B::Scalar]) -> Contestant<'a>
where
    B: Basis + 'a,
    P: Point<Scalar = B::Scalar, Vector = P> + 'a,
{
    let mut out: [Vec<P>; K] = core::array::from_fn(|_| vec![P::zero(); ts.len()]);
    Box::new(move || {
        let slices = out.each_mut().map(Vec::as_mut_slice);
        curve.eval_with_derivs_into(ts, slices).expect("as many points as parameters");
        black_box(out.as_ptr());
    })
}

fn kurbo_cubic() -> CubicBez {
    let [a, b, c, d] = POINTS.map(|[x, y, _]| kurbo::Point::new(x, y));
    black_box(CubicBez::new(a, b, c, d))
}

fn curvo_cubic() -> curvo::prelude::NurbsCurve3D<f64> {
    black_box(curvo::prelude::NurbsCurve::bezier(&POINTS.map(nalgebra::Point3::from)))
}

fn bevy_cubic() -> CubicSegment<bevy_math::Vec3> {
    black_box(CubicSegment::new_bezier(POINTS.map(|p| bevy_math::Vec3::from_array(p.map(|c| c as f32)))))
}

macro_rules! enterpolation_cubic {
    () => {
        enterpolation::bezier::Bezier::builder()
            .elements(POINTS.map(DVec3::from_array))
            .normalized::<f64>()
            .constant::<4>()
            .build()
            .expect("four points")
    };
}

fn points() {
    let (ts, ts_f32) = (&parameters::<f64>(), &parameters::<f32>());
    let ours2 = || -> Vec<Contestant<'_>> {
        let curve = cubic::<[f64; 2]>();
        vec![each(ts, [0.0; 2], move |t| curve.eval(t)), slices(curve, ts), slices(quartic::<[f64; 2]>(), ts)]
    };
    let ours3 = || -> Vec<Contestant<'_>> {
        let curve = cubic::<[f64; 3]>();
        vec![each(ts, [0.0; 3], move |t| curve.eval(t)), slices(curve, ts), slices(quartic::<[f64; 3]>(), ts)]
    };
    let ours_f32 = || -> Vec<Contestant<'_>> {
        let curve = cubic::<[f32; 3]>();
        vec![
            each(ts_f32, [0.0; 3], move |t| curve.eval(t)),
            slices(curve, ts_f32),
            slices(quartic::<[f32; 3]>(), ts_f32),
        ]
    };
    let run = |peer: &str, first: Contestant<'_>, ours: Vec<Contestant<'_>>| {
        row("a point", peer, &race(COUNT, [first].into_iter().chain(ours).collect()));
    };
    let curve = kurbo_cubic();
    run("kurbo, f64 2D", each(ts, kurbo::Point::ZERO, move |t| curve.eval(t)), ours2());
    let curve = enterpolation_cubic!();
    run("enterpolation, f64 3D", each(ts, DVec3::ZERO, move |t| curve.eval(t)), ours3());
    let curve = curvo_cubic();
    run("curvo, f64 3D", each(ts, nalgebra::Point3::origin(), move |t| curve.point_at(t)), ours3());
    let curve = bevy_cubic();
    run("bevy_math, f32 3D", each(ts_f32, bevy_math::Vec3::ZERO, move |t| curve.position(t)), ours_f32());
}

fn ours_with_derivatives<'a, P: Point<Vector = P> + 'a, const K: usize>(
    ts: &'a [P::Scalar],
) -> Vec<Contestant<'a>> {
    let curve = cubic::<P>();
    vec![
        each(ts, [P::zero(); K], move |t| curve.eval_with_derivs::<K>(t)),
        derivative_slices::<_, _, K>(curve, ts),
        derivative_slices::<_, _, K>(quartic::<P>(), ts),
    ]
}

fn derivatives() {
    let (ts, ts_f32) = (&parameters::<f64>(), &parameters::<f32>());
    let run = |work: &str, peer: &str, first: Contestant<'_>, ours: Vec<Contestant<'_>>| {
        row(work, peer, &race(COUNT, [first].into_iter().chain(ours).collect()));
    };
    // Its gen_with_deriatives::<3> panics for a cubic (0.3.0).
    let curve = enterpolation_cubic!();
    let at = move |t| curve.gen_with_tangent(t);
    let work = "a point and one derivative";
    run(
        work,
        "enterpolation, f64 3D",
        each(ts, [DVec3::ZERO; 2], at),
        ours_with_derivatives::<[f64; 3], 2>(ts),
    );
    let work = "a point and two derivatives";
    let curve = kurbo_cubic();
    let (first, second) = (curve.deriv(), curve.deriv().deriv());
    let at = move |t| [curve.eval(t), first.eval(t), second.eval(t)];
    run(
        work,
        "kurbo, f64 2D",
        each(ts, [kurbo::Point::ZERO; 3], at),
        ours_with_derivatives::<[f64; 2], 3>(ts),
    );
    let curve = curvo_cubic();
    let at = move |t| {
        let derivatives = curve.rational_derivatives(t, 2);
        [derivatives[0], derivatives[1], derivatives[2]]
    };
    run(
        work,
        "curvo, f64 3D",
        each(ts, [nalgebra::Vector3::zeros(); 3], at),
        ours_with_derivatives::<[f64; 3], 3>(ts),
    );
    let curve = bevy_cubic();
    let at = move |t| [curve.position(t), curve.velocity(t), curve.acceleration(t)];
    run(
        work,
        "bevy_math, f32 3D",
        each(ts_f32, [bevy_math::Vec3::ZERO; 3], at),
        ours_with_derivatives::<[f32; 3], 3>(ts_f32),
    );
}

/// How many curves there are, with different ends.
const CURVES: usize = 64;

fn shifted(i: usize) -> [[f64; 3]; 4] {
    let shift = i as f64 / CURVES as f64;
    let [a, b, [x, y, z], d] = POINTS;
    [a, b, [x + shift, y - 2.0 * shift, z], d]
}

fn lengths() {
    let numbers: Vec<usize> = (0..CURVES).collect();
    let peer = each(&numbers, 0.0, |i| {
        let [a, b, c, d] = shifted(i).map(|[x, y, _]| kurbo::Point::new(x, y));
        CubicBez::new(a, b, c, d).arclen(ACCURACY)
    });
    let ours = each(&numbers, 0.0, |i| {
        Curve::new(Bernstein::new(), shifted(i).map(|[x, y, _]| [x, y])).arclen(ACCURACY)
    });
    row("arc length to 1e-9", "kurbo, f64 2D", &race(CURVES, vec![peer, ours]));
    let mut random = Random::default();
    let random: Vec<[[f64; 2]; 4]> = numbers.iter().map(|_| random.cubic()).collect();
    let peer = each(&numbers, 0.0, |i| {
        let [a, b, c, d] = random[i].map(|[x, y]| kurbo::Point::new(x, y));
        CubicBez::new(a, b, c, d).arclen(ACCURACY)
    });
    let ours = each(&numbers, 0.0, |i| Curve::new(Bernstein::new(), random[i]).arclen(ACCURACY));
    row("arc length to 1e-9, random cubics", "kurbo, f64 2D", &race(CURVES, vec![peer, ours]));
    let peer = each(&numbers, 0.0, |i| {
        let curve = curvo::prelude::NurbsCurve3D::<f64>::bezier(&shifted(i).map(nalgebra::Point3::from));
        curve.try_length().expect("a length")
    });
    let ours = each(&numbers, 0.0, |i| Curve::new(Bernstein::new(), shifted(i)).arclen(ACCURACY));
    row("arc length to 1e-9", "curvo, f64 3D (19 nodes, no bound)", &race(CURVES, vec![peer, ours]));
}

fn nearest() {
    let numbers: Vec<usize> = (0..CURVES).collect();
    let target = |i: usize| {
        let angle = i as f64 / CURVES as f64 * std::f64::consts::TAU;
        [2.0 + 2.0 * angle.cos(), 1.0 + 2.0 * angle.sin(), 0.25]
    };
    let curve = kurbo_cubic();
    let peer = each(&numbers, 0.0, move |i| {
        let [x, y, _] = target(i);
        curve.nearest(kurbo::Point::new(x, y), ACCURACY).t
    });
    let curve = cubic::<[f64; 2]>();
    let ours = each(&numbers, 0.0, move |i| {
        let [x, y, _] = target(i);
        curve.nearest([x, y], ACCURACY).map_or(f64::NAN, |found| found.at)
    });
    row("nearest point to 1e-9", "kurbo, f64 2D", &race(CURVES, vec![peer, ours]));
    let curve = curvo_cubic();
    let peer = each(&numbers, 0.0, move |i| {
        curve.find_closest_parameter(&nalgebra::Point3::from(target(i))).unwrap_or(f64::NAN)
    });
    let curve = cubic::<[f64; 3]>();
    let ours =
        each(&numbers, 0.0, move |i| curve.nearest(target(i), ACCURACY).map_or(f64::NAN, |found| found.at));
    row("nearest point to 1e-9", "curvo, f64 3D (local)", &race(CURVES, vec![peer, ours]));
}

/// The largest errors of single points and their derivatives in f32, beside those of bevy_math, in ε of the largest
/// coefficient of the derivative in Bernstein form.
fn errors() {
    let exact = cubic::<[f64; 3]>();
    let (curve, peer) = (cubic::<[f32; 3]>(), bevy_cubic());
    let mut largest = [[0.0_f64; 3]; 2];
    let size = [4.0, 7.5, 18.0];
    for t in (0..1_u32 << 16).map(|k| k as f32 / 65_535.0) {
        let truth = exact.eval_with_derivs::<3>(f64::from(t));
        let ours = curve.eval_with_derivs::<3>(t);
        let theirs = [peer.position(t), peer.velocity(t), peer.acceleration(t)].map(|v| v.to_array());
        for (largest, found) in largest.iter_mut().zip([theirs, ours]) {
            for order in 0..3 {
                for axis in 0..3 {
                    let error = (f64::from(found[order][axis]) - truth[order][axis]).abs();
                    largest[order] = largest[order].max(error / size[order] / f64::from(f32::EPSILON));
                }
            }
        }
    }
    println!("| largest error in f32, in ε | bevy_math | ours |");
    println!("| --- | --- | --- |");
    for (order, what) in ["point", "first derivative", "second derivative"].iter().enumerate() {
        println!("| {what} | {:.2} | {:.2} |", largest[0][order], largest[1][order]);
    }
    let ends = |t: f32, k: usize| {
        let off = |p: [f32; 3]| (0..3).any(|d| p[d] != POINTS[k][d] as f32);
        [off(peer.position(t).to_array()), off(curve.eval(t))].map(|off| if off { "no" } else { "yes" })
    };
    let [start, end] = [ends(0.0, 0), ends(1.0, 3)];
    println!("| exact at the ends | {}, {} | {}, {} |", start[0], end[0], start[1], end[1]);
}

/// How near slices come to what the units for fused multiplications and additions allow: the loop does nothing but as many of
/// these as the points of a cubic in three dimensions need, 15 each, on numbers that stay in registers.
fn bound_of_the_machine() {
    #[cfg(target_arch = "x86_64")]
    if std::is_x86_feature_detected!("avx512f") || std::is_x86_feature_detected!("fma") {
        const NEEDED: usize = 15;
        let ts = &parameters::<f64>();
        let fused: Contestant<'_> = Box::new(|| x86_64::fused(COUNT * NEEDED));
        let times =
            race(COUNT, vec![fused, slices(cubic::<[f64; 3]>(), ts), slices(quartic::<[f64; 3]>(), ts)]);
        println!();
        println!(
            "| f64 3D slices | nothing but {NEEDED} fused operations a point | cubic | quartic family |"
        );
        println!("| --- | --- | --- | --- |");
        let ours = times[1..].iter().map(|time| format!("{time:.2} ns, {:.2} of it", time / times[0]));
        println!("| a point | {:.2} ns | {} |", times[0], ours.collect::<Vec<_>>().join(" | "));
    }
}

#[cfg(target_arch = "x86_64")]
#[allow(unsafe_code)] // instructions that the processor need not have
mod x86_64 {
    use std::hint::black_box;

    /// Runs that many fused operations on numbers of 64 bits, with the widest vectors.
    pub(super) fn fused(count: usize) {
        if std::is_x86_feature_detected!("avx512f") {
            // SAFETY: the processor has the feature.
            unsafe { avx512(count) }
        } else {
            // SAFETY: the caller has asked for the feature.
            unsafe { avx2(count) }
        }
    }

    #[target_feature(enable = "avx512f")]
    fn avx512(count: usize) {
        use core::arch::x86_64::{_mm512_fmadd_pd, _mm512_set1_pd};
        let (a, b) = (_mm512_set1_pd(black_box(0.5)), _mm512_set1_pd(black_box(1.0)));
        let mut sums = [_mm512_set1_pd(black_box(1.0)); 12];
        for _ in 0..count / (sums.len() * 8) {
            for sum in &mut sums {
                *sum = _mm512_fmadd_pd(*sum, a, b);
            }
        }
        black_box(sums);
    }

    #[target_feature(enable = "avx2,fma")]
    fn avx2(count: usize) {
        use core::arch::x86_64::{_mm256_fmadd_pd, _mm256_set1_pd};
        let (a, b) = (_mm256_set1_pd(black_box(0.5)), _mm256_set1_pd(black_box(1.0)));
        let mut sums = [_mm256_set1_pd(black_box(1.0)); 12];
        for _ in 0..count / (sums.len() * 4) {
            for sum in &mut sums {
                *sum = _mm256_fmadd_pd(*sum, a, b);
            }
        }
        black_box(sums);
    }
}

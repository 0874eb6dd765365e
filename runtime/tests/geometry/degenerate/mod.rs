//! Where random and degenerate curves meet themselves and each other, beside a search by boxes alone and places that are
//! known because the curves were made to meet there: nothing is missed, nothing is invented, nothing is said twice.
//! `CASES=10000` tests that many of each kind, and `SEED=7` others.

mod cases;
mod judge;

use basis_runtime::ParametricCurve;
use basis_runtime::bspline::{BSplineCurve, NurbsCurve};
use basis_test_support::cases as usually;

use crate::random::Random;
use cases::{KINDS, OWN_KINDS, Points, own, pair, random_curve};
use judge::{Asked, covers, judge};

type Dynamic<'a, const D: usize> = &'a dyn ParametricCurve<Point = [f64; D]>;

fn asked_for<T: core::str::FromStr>(name: &str, usual: T) -> T {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
}

/// Calls `ask` with the curve in a scale, of the simplest type.
fn scaled<const D: usize, T>(
    (points, weights): &Points<D>,
    scale: f64,
    ask: impl FnOnce(Dynamic<'_, D>) -> T,
) -> T {
    let points: Vec<[f64; D]> = points.iter().map(|p| p.map(|x| scale * x)).collect();
    let spline = BSplineCurve::from_bezier(points.clone()).unwrap();
    if weights.iter().all(|&w| w == 1.0) {
        ask(&spline)
    } else {
        ask(&NurbsCurve::new(spline.knots().clone(), points, weights.clone()).unwrap())
    }
}

/// The wrong answers of a run.
struct Wrong {
    seed: u64,
    all: Vec<String>,
    met: usize,
}

impl Wrong {
    fn new(usual: u64) -> Self {
        Self { seed: asked_for("SEED", usual), all: Vec::new(), met: 0 }
    }

    fn add(&mut self, what: &str, verdict: Result<usize, String>) {
        match verdict {
            Ok(met) => self.met += met,
            Err(why) => self.all.push(format!("{what}: {why}")),
        }
    }

    fn report(&self) {
        let some = self.all.iter().take(10).cloned().collect::<Vec<_>>().join("\n\n");
        assert!(self.all.is_empty(), "{} wrong answers of seed {}:\n{some}", self.all.len(), self.seed);
        assert!(self.met > 0);
    }
}

fn pairs_in<const D: usize>(seed: u64, count: usize) {
    let mut wrong = Wrong::new(seed);
    let random = &mut Random::new(wrong.seed);
    for kind in 0..KINDS {
        for number in 0..asked_for("CASES", usually(count)) {
            let case = pair::<D>(random, kind);
            let scale = 2.0_f64.powi([0, 0, 0, 30, -30, 400, -400][random.below(7)]);
            // Curves that run along each other take the longer the smaller it is.
            let accuracy = if case.along { 1e-3 } else { [1e-3, 1e-6, 1e-9][random.below(3)] };
            let [a, b] = &case.curves;
            let found = scaled(a, scale, |first| {
                scaled(b, scale, |second| first.intersections(second, accuracy * scale).unwrap())
            });
            let verdict = judge(&case, &found, scale, accuracy, Asked::Two);
            let what = format!("kind {kind}, {number}, within {accuracy:e}");
            wrong.add(&what, verdict.map_err(|why| format!("{why}\n{case:?}\n{found:?}")));
        }
    }
    wrong.report();
}

#[test]
fn pairs_in_the_plane() {
    pairs_in::<2>(1911, 20);
}

#[test]
fn pairs_in_space() {
    pairs_in::<3>(1912, 12);
}

fn with_themselves<const D: usize>(seed: u64, count: usize) {
    let mut wrong = Wrong::new(seed);
    let random = &mut Random::new(wrong.seed);
    for kind in 0..OWN_KINDS {
        for number in 0..asked_for("CASES", usually(count)) {
            let case = own::<D>(random, kind);
            let scale = 2.0_f64.powi([0, 0, 30, -400][random.below(4)]);
            let accuracy = if kind == 4 { 1e-3 } else { [1e-3, 1e-6, 1e-9][random.below(3)] };
            let found =
                scaled(&case.curves[0], scale, |curve| curve.self_intersections(accuracy * scale).unwrap());
            let verdict = judge(&case, &found, scale, accuracy, Asked::Itself);
            let what = format!("kind {kind}, {number}, within {accuracy:e}");
            wrong.add(&what, verdict.map_err(|why| format!("{why}\n{case:?}\n{found:?}")));
        }
    }
    wrong.report();
}

#[test]
fn curves_with_themselves_in_the_plane() {
    with_themselves::<2>(1913, 20);
}

#[test]
fn curves_with_themselves_in_space() {
    with_themselves::<3>(1915, 12);
}

/// The end of a curve that rounding has left beside another one.
#[test]
fn ends_beside_curves() {
    let random = &mut Random::new(1914);
    for _ in 0..asked_for("CASES", usually(200)) {
        let (a, mut b) = (random_curve::<2>(random, 3, false), random_curve::<2>(random, 3, false));
        let s: f64 = random.between(0.1, 0.9);
        let (point, tangent) = scaled(&a, 1.0, |curve| (curve.eval(s), curve.tangent(s).unwrap()));
        let side = [-tangent[1], tangent[0]];
        // From the side, so that it does not cross before its end.
        b.0 = [3.0, 2.0, 1.0, 1e-7].map(|x| core::array::from_fn(|d| point[d] + x * side[d])).to_vec();
        let found = scaled(&a, 1.0, |a| scaled(&b, 1.0, |b| a.intersections(b, 1e-6).unwrap()));
        assert!(
            found.iter().any(|m| covers(m, [s, 1.0], 1e-4) && m.distance <= 1e-6),
            "{s} {found:?}\n{a:?}"
        );
        let found = scaled(&a, 1.0, |a| scaled(&b, 1.0, |b| a.intersections(b, 1e-9).unwrap()));
        assert!(!found.iter().any(|m| covers(m, [s, 1.0], 1e-6)), "{found:?}");
    }
}

/// In space the place where the projections of both curves cross is far from where they are near each other.
#[test]
fn near_in_space_beside_a_crossing_of_projections() {
    let steep = |x: f64| vec![[0.0, 0.0, 0.0], [x, 0.0, 1.0], [2.0 * x, 0.0, 0.0]];
    let across = |x: f64, z: f64| (vec![[x, -0.5, z], [x, 0.5, z]], vec![1.0; 2]);
    let a = (steep(0.02), vec![1.0; 3]);
    for (b, at) in [(across(5e-5, 0.0), [0.0, 0.5]), (across(0.004, 0.1825), [0.1, 0.5])] {
        let found = scaled(&a, 1.0, |a| scaled(&b, 1.0, |b| a.intersections(b, 5e-4).unwrap()));
        assert!(found.iter().any(|m| covers(m, at, 5e-3) && m.distance <= 5e-4), "{found:?}");
    }
}

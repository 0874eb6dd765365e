//! Boxes, extrema, inflections and polygons: where curves are, and where they turn.

use basis_runtime::{Basis, Bezier, Curve, CurveError};

use crate::families::{Bernstein7, Constant, Linear, QuarticBernstein, UniformCubic};
use crate::random::Random;

fn boxes_are_tight<B: Basis<Scalar = f64>>(basis: B, random: &mut Random) {
    use basis_runtime::Array;
    let points = B::Points::from_fn(|_| [random.between(-1.0, 1.0), random.between(-1.0, 1.0)]);
    let curve: Curve<B, [f64; 2]> = Curve::new(basis, points);
    let ([low, high], [outer_low, outer_high]) = (curve.bounding_box(), curve.control_box());
    for d in 0..2 {
        let samples = || curve.samples(5001).map(|p| p[d]);
        let (min, max) = (samples().fold(f64::MAX, f64::min), samples().fold(f64::MIN, f64::max));
        assert!(low[d] <= min + 1e-15 && min <= low[d] + 1e-5, "{curve:?}");
        assert!(high[d] >= max - 1e-15 && max >= high[d] - 1e-5, "{curve:?}");
        assert!(outer_low[d] <= low[d] + 1e-15 && outer_high[d] >= high[d] - 1e-15);
    }
    // Between two extrema every component is monotone.
    let [lo, hi] = curve.domain();
    let mut ends = curve.extrema();
    ends.insert(0, lo);
    ends.push(hi);
    assert!(ends.is_sorted());
    for pair in ends.windows(2) {
        let part: Vec<[f64; 2]> = curve.subsegment(pair[0]..pair[1]).unwrap().samples(50).collect();
        for d in 0..2 {
            let rising = part[0][d] <= part[49][d];
            for step in part.windows(2) {
                let change = step[1][d] - step[0][d];
                assert!(if rising { change >= -1e-13 } else { change <= 1e-13 }, "{curve:?} {pair:?}");
            }
        }
    }
}

#[test]
fn of_all_families() {
    let random = &mut Random::new(81);
    for _ in 0..30 {
        boxes_are_tight(QuarticBernstein::new(random.between(-3.0, 1.0)).unwrap(), random);
        boxes_are_tight(UniformCubic::new(), random);
        boxes_are_tight(Bernstein7::new(), random);
        boxes_are_tight(Linear::default(), random);
        boxes_are_tight(Constant::default(), random);
    }
}

#[test]
fn boxes_of_infinite_curves() {
    let curve = Bezier::from_points([[0.0, 1.0], [f64::NAN, 3.0], [1.0, 2.0]]);
    assert!(curve.bounding_box().iter().chain(&curve.control_box()).all(|corner| corner[0].is_nan()));
    assert_eq!(curve.control_box().map(|corner| corner[1]), [1.0, 3.0]);
    let [low, high] = curve.bounding_box().map(|corner| corner[1]);
    assert!(low == 1.0 && (high - 7.0 / 3.0).abs() < 1e-15);
    assert!(Bezier::from_points([[0.0, f64::INFINITY]; 2]).bounding_box()[0][1].is_nan());
}

/// y = x³ - x over -1..1 turns at 0; y = x⁴ does not, although its curvature vanishes there.
#[test]
fn inflections() {
    let cubic =
        Bezier::from_points([[-1.0_f64, 0.0], [-1.0 / 3.0, 2.0 / 3.0], [1.0 / 3.0, -2.0 / 3.0], [1.0, 0.0]]);
    let found = cubic.inflections().unwrap();
    assert!(found.len() == 1 && (found[0] - 0.5).abs() < 1e-15, "{found:?}");
    let quartic = Bezier::from_points([[-1.0, 1.0], [-0.5, -1.0], [0.0, 1.0], [0.5, -1.0], [1.0, 1.0]]);
    assert_eq!(quartic.inflections(), Ok(vec![]));
    let random = &mut Random::new(82);
    for _ in 0..100 {
        let points = core::array::from_fn(|_| [random.between(-1.0, 1.0), random.between(-1.0, 1.0)]);
        let curve = Curve::new(QuarticBernstein::new(random.between(-2.9, 1.0)).unwrap(), points);
        let mut ends = curve.inflections().unwrap();
        ends.insert(0, 0.0);
        ends.push(1.0);
        let mut last = None;
        for pair in ends.windows(2) {
            let turns: Vec<f64> = (1..20)
                .map(|i| curve.curvature(pair[0] + (pair[1] - pair[0]) * f64::from(i) / 20.0))
                .collect();
            let left = turns[9] > 0.0;
            assert!(turns.iter().all(|&turn| (turn > 0.0) == left), "{curve:?}");
            assert_ne!(last.replace(left), Some(left), "{curve:?} {ends:?}");
        }
    }
}

#[test]
fn no_inflections() {
    assert_eq!(
        Bezier::from_points([[0.1, 0.3], [0.2, 0.6], [0.7, 2.1], [0.5, 1.5_f64]]).inflections(),
        Ok(vec![])
    );
    assert_eq!(Bezier::from_points([[0.0, 1.0]; 5]).inflections(), Ok(vec![]));
    assert_eq!(Bezier::from_points([[0.0, 1.0]]).inflections(), Ok(vec![]));
    let error = Bezier::from_points([[0.0_f64; 3]; 4]).inflections().unwrap_err();
    assert_eq!(error, CurveError::Dimension { expected: 2, found: 3 });
}

/// A line with equal steps has second differences that are rounding errors only.
#[test]
fn straight_up_to_rounding() {
    for [start, end] in
        [[[0.1, 0.7], [0.33, 0.15]], [[0.1, 0.2], [0.4, 0.5]], [[1e6, 3e6 + 0.7], [1e6 + 0.3, 3e6]]]
    {
        let line = Bezier::from_points([start, end]);
        assert_eq!(line.elevate::<6>().inflections(), Ok(vec![]));
        assert_eq!(line.elevate::<13>().inflections(), Ok(vec![]));
    }
    assert!(Bezier::from_points([0.1, 0.1]).elevate::<6>().extrema().is_empty());
    let level = Bezier::from_points([[0.0, 0.1], [1.0, 0.1]]).elevate::<8>();
    assert!(level.extrema().is_empty());
}

/// Neither products of large differences overflow nor do those of small ones vanish.
#[test]
fn turns_and_boxes_of_any_size() {
    for size in [1e-300, 1e-170, 1e-60, 1e60, 1e170, 1e300] {
        let wave = Bezier::from_points(
            [[0.0, 0.0], [1.0, 1.0], [2.0, -1.0], [3.0, 0.0]].map(|p| p.map(|c| c * size)),
        );
        let found = wave.inflections().unwrap();
        assert!(found.len() == 1 && (found[0] - 0.5_f64).abs() < 1e-15, "{size}: {found:?}");
    }
    for size in [1e308, 1.5e308] {
        let arch = Bezier::from_points([-size, size, -size]);
        assert_eq!(arch.bounding_box(), [-size, 0.0]);
        assert_eq!(arch.extrema(), [0.5]);
    }
}

fn distance_to_polygon(p: [f64; 2], corners: &[[f64; 2]]) -> f64 {
    let to_segment = |pair: &[[f64; 2]]| {
        let [a, b] = [pair[0], pair[1]];
        let (along, gap) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
        let square = along[0] * along[0] + along[1] * along[1];
        let foot = if square > 0.0 {
            ((gap[0] * along[0] + gap[1] * along[1]) / square).clamp(0.0, 1.0)
        } else {
            0.0
        };
        (gap[0] - foot * along[0]).hypot(gap[1] - foot * along[1])
    };
    corners.windows(2).map(to_segment).fold(f64::MAX, f64::min)
}

#[test]
fn polygons_stay_within_the_tolerance() {
    let random = &mut Random::new(83);
    for _ in 0..20 {
        let points = core::array::from_fn(|_| [random.between(-1.0, 1.0), random.between(-1.0, 1.0)]);
        let curve = Curve::new(Bernstein7::new(), points);
        let mut last = 0;
        for tolerance in [1.0_f64, 1e-2, 1e-4] {
            let corners = curve.flatten(tolerance).unwrap();
            assert_eq!([corners[0], corners[corners.len() - 1]], [curve.start(), curve.end()]);
            assert!(
                corners.len() >= last && (corners.len() as f64) < 6.0 / tolerance.sqrt() + 8.0,
                "{}",
                corners.len()
            );
            last = corners.len();
            for sample in curve.samples(200) {
                assert!(distance_to_polygon(sample, &corners) <= tolerance * (1.0 + 1e-9));
            }
            for pair in corners.windows(2).step_by(7) {
                let middle = [0.5 * (pair[0][0] + pair[1][0]), 0.5 * (pair[0][1] + pair[1][1])];
                assert!(curve.nearest(middle, 1e-9).unwrap().distance <= tolerance + 1e-9);
            }
        }
    }
}

/// Where the rounding errors of the points are larger than the tolerance, halving does not help.
#[test]
fn polygons_far_from_the_origin() {
    let arch = |x: f64| Bezier::from_points([[x, x], [x + 1.0, x + 2.0], [x + 3.0, x + 2.0], [x + 4.0, x]]);
    let corners = arch(0.0).flatten(1e-7).unwrap().len();
    for x in [1e7, 1e9, 1e12] {
        assert!(arch(x).flatten(1e-7).unwrap().len() <= 2 * corners);
    }
}

#[test]
fn polygons_of_degenerate_curves() {
    let line = Bezier::from_points([[0.0, 0.0], [0.5, 0.5], [1.0, 1.0]]);
    assert_eq!(line.flatten(1e-12), Ok(vec![[0.0, 0.0], [1.0, 1.0]]));
    assert_eq!(Bezier::from_points([[1.0, 2.0]; 4]).flatten(1e-300), Ok(vec![[1.0, 2.0]; 2]));
    for value in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(line.flatten(value), Err(CurveError::Tolerance { value }));
    }
    assert!(line.flatten(f64::NAN).is_err());
    assert_eq!(Bezier::from_points([0.0, f64::NAN]).flatten(1.0), Err(CurveError::NotFinite));
    let wide = Bezier::from_points([[0.0, 0.0], [1e9, 1e9], [2e9, 0.0]]);
    assert!(matches!(wide.flatten(1e-12), Err(CurveError::TooManyPoints { needed }) if needed > 1e10));
}

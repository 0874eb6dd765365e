//! Knot vectors, B-spline curves and surfaces, polynomial and rational, and what is made of them. The names begin with
//! the type.

use basis_runtime::bspline::{
    BSplineCurve, BSplineSurface, ConstructionError, Direction, Edge, EdgeKnots, EdgePair, FollowOptions,
    Homogeneous, KnotVector, Method, Net, Network, NurbsCurve, NurbsSurface, PointConstraint, SecondRow,
    Spacing, SpliceOptions, parameters,
};

use basis_runtime::{Contact, CurveError, ParametricCurve, Surface};

use crate::{Case, P, check, is_finite, is_length, is_nan, pair};

/// Whether a construction was refused because a control point would not be finite.
fn not_finite(error: ConstructionError) -> bool {
    error == ConstructionError::Curve(CurveError::NotFinite)
}

fn all_finite(surface: &BSplineSurface<P>) -> bool {
    surface.net().as_slice().iter().all(|&p| is_finite(p))
}

type C = BSplineCurve<P>;
type S = BSplineSurface<P>;
type RationalCurve = NurbsCurve<P>;
type RationalSurface = NurbsSurface<P>;

const BOTH: [Direction; 2] = [Direction::U, Direction::V];

/// Of degree 2 with a double knot: five functions.
fn knots() -> KnotVector<f64> {
    KnotVector::new(2, [0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0]).unwrap()
}

/// Of degree 3, not clamped: five functions.
fn unclamped() -> KnotVector<f64> {
    KnotVector::new(3, [-0.5, -0.25, -0.125, 0.0, 0.25, 1.0, 1.0, 1.5, 2.0]).unwrap()
}

fn surface(net: fn(usize) -> P) -> S {
    S::new(knots(), unclamped(), Net::from_fn(5, 5, |i, j| net(5 * i + j)).unwrap()).unwrap()
}

/// The curve with these weights at both ends, or as it is if they are none.
fn with_end_weights(curve: &RationalCurve, first: f64, last: f64) -> RationalCurve {
    let mut weights = curve.weights();
    let end = weights.len() - 1;
    (weights[0], weights[end]) = (first, last);
    NurbsCurve::new(curve.knots().clone(), curve.control_points(), weights).unwrap_or_else(|_| curve.clone())
}

/// Whether a costly question is asked: a few of the numbers, of every kind.
fn few(a: f64, b: f64) -> bool {
    [0.375, 1e300, f64::MAX, f64::INFINITY, f64::NAN].iter().any(|x| x.to_bits() == a.to_bits())
        && (a.to_bits() == b.to_bits() || b == 3.0 || b == 0.0)
}

const KNOTS: &[Case<KnotVector<f64>>] = &[
    ("KnotVector::new", |_, a, b| {
        let found = KnotVector::new(1, [0.0, 0.0, a, b, b]);
        found.is_err() || (a >= 0.0 && a <= b && b > 0.0 && b.is_finite())
    }),
    ("KnotVector::clamped", |_, a, b| {
        let found = KnotVector::clamped(2, &[a, b]);
        found.is_ok() == (a < b && (b - a).is_finite()) && KnotVector::<f64>::clamped(2, &[]).is_err()
    }),
    ("KnotVector::periodic", |_, a, b| {
        let found = KnotVector::periodic(2, &[0.0, a, b]);
        found.map_or(!(0.25..1.0).contains(&a) || b != 1.0, |k| k.domain() == [0.0, b] && a <= b)
            && KnotVector::<f64>::periodic(usize::MAX, &[0.0, 1.0]).is_err()
    }),
    ("KnotVector::uniform", |_, _, _| {
        KnotVector::<f64>::uniform(3, 0).is_err()
            && KnotVector::<f64>::uniform(3, usize::MAX).is_err()
            && KnotVector::<f64>::uniform(usize::MAX, 1).is_err()
    }),
    ("KnotVector::to_f64", |k, _, _| k.to_f64() == *k),
    ("KnotVector::degree", |k, _, _| k.degree() <= 3),
    ("KnotVector::as_slice", |k, _, _| k.as_slice().is_sorted()),
    ("KnotVector::functions", |k, _, _| k.functions() + k.degree() + 1 == k.as_slice().len()),
    ("KnotVector::domain", |k, _, _| k.domain() == [0.0, 1.0]),
    ("KnotVector::breakpoints", |k, _, _| k.breakpoints().len() == k.spans().count() + 1),
    ("KnotVector::spans", |k, _, _| k.spans().all(|span| k.as_slice()[span] < k.as_slice()[span + 1])),
    ("KnotVector::multiplicity", |k, a, _| k.multiplicity(a) <= 3),
    ("KnotVector::span", |k, a, _| k.spans().any(|span| span == k.span(a))),
    ("KnotVector::greville", |k, _, _| k.greville().len() == k.functions()),
    ("KnotVector::is_clamped", |k, _, _| k.is_clamped() == (k.degree() == 2)),
    ("KnotVector::mapped", |k, a, b| {
        k.mapped([a, b]).map_or(true, |mapped| a < b && mapped.domain() == [a, b])
    }),
    ("KnotVector::reversed", |k, _, _| k.reversed().domain() == k.domain()),
    ("KnotVector::check", |k, a, _| k.check(a).is_ok() == (0.0..=1.0).contains(&a)),
    ("KnotVector::clamp", |k, a, _| a.is_nan() || (0.0..=1.0).contains(&k.clamp(a))),
    ("KnotVector::values", |k, a, _| {
        k.values(a).map_or(!(0.0..=1.0).contains(&a), |(_, values)| values.len() == k.degree() + 1)
    }),
    ("KnotVector::derivatives", |k, a, _| {
        [0, 1, 5, usize::MAX].into_iter().all(|order| k.derivatives(a, order).is_ok() == k.check(a).is_ok())
    }),
];

const CURVE: &[Case<C>] = &[
    ("BSplineCurve::new", |c, _, _| C::new(c.knots().clone(), vec![[0.0; 3]; 4]).is_err()),
    ("BSplineCurve::from_bezier", |c, _, _| {
        C::from_bezier(Vec::new()).is_err() && C::from_bezier(c.control_points()).is_ok()
    }),
    ("BSplineCurve::degree", |c, _, _| c.degree() == 2),
    ("BSplineCurve::knots", |c, _, _| c.knots().functions() == 5),
    ("BSplineCurve::control_points", |c, _, _| c.control_points().len() == 5),
    ("BSplineCurve::control_points_mut", |c, _, _| c.clone().control_points_mut().len() == 5),
    ("BSplineCurve::domain", |c, _, _| c.domain() == [0.0, 1.0]),
    ("BSplineCurve::start", |c, _, _| c.start() == c.eval(0.0) || !is_finite(c.start())),
    ("BSplineCurve::end", |c, _, _| c.end() == c.eval(1.0) || !is_finite(c.end())),
    ("BSplineCurve::eval", |c, a, _| !a.is_nan() || is_nan(c.eval(a))),
    ("BSplineCurve::eval_checked", |c, a, _| c.eval_checked(a).is_ok() == (0.0..=1.0).contains(&a)),
    ("BSplineCurve::eval_clamped", |c, a, _| !a.is_nan() || is_nan(c.eval_clamped(a))),
    ("BSplineCurve::eval_into", |c, a, b| {
        let mut points = [[0.0; 3]; 3];
        c.eval_into(&[a, b], &mut points).is_err()
            && c.eval_into(&[a, b], &mut points[..2]).is_ok()
            && points[2] == [0.0; 3]
    }),
    ("BSplineCurve::eval_with_derivs", |c, a, _| {
        c.eval_with_derivs::<5>(a)[3..].iter().all(|&p| p == [0.0; 3] || is_nan(p) || !is_finite(p))
    }),
    ("BSplineCurve::derivative", |c, a, _| {
        let _ = [0, 1, 3, usize::MAX].map(|order| c.derivative(a, order));
        true
    }),
    ("BSplineCurve::insert_knots", |c, a, b| {
        c.insert_knots(&[a, b]).map_or(true, |finer| finer.control_points().len() == 7)
            && c.insert_knots(&[0.5; 9]).is_err()
    }),
    ("BSplineCurve::refined", |c, _, _| c.refined().control_points().len() > 5),
    ("BSplineCurve::remove_knot", |c, a, b| {
        c.remove_knot(0.5, 2, a).is_ok()
            && c.remove_knot(a, usize::MAX, b).map_or(true, |(c, n)| n <= c.degree() + 1)
    }),
    ("BSplineCurve::elevate", |c, _, _| c.elevate().is_ok_and(|c| c.degree() == 3)),
    ("BSplineCurve::clamped", |c, _, _| c.clamped().knots().is_clamped()),
    ("BSplineCurve::split", |c, a, _| c.split(a).is_ok() == (a > 0.0 && a < 1.0)),
    ("BSplineCurve::subsegment", |c, a, b| {
        let inside = |t: f64| (0.0..=1.0).contains(&t);
        c.subsegment(a..b).is_ok() == (inside(a) && inside(b) && a != b)
    }),
    ("BSplineCurve::to_bezier", |c, _, _| c.to_bezier().len() == 2),
    ("BSplineCurve::merged", |c, _, _| c.merged(c).is_ok()),
    ("BSplineCurve::reversed", |c, _, _| c.reversed().domain() == c.domain()),
    ("BSplineCurve::interpolate", |c, _, _| {
        [0, 1, 3, 9, usize::MAX].into_iter().all(|degree| {
            [Spacing::Uniform, Spacing::Chord, Spacing::Centripetal].into_iter().all(|spacing| {
                C::interpolate(degree, c.control_points(), spacing).map_or(true, |c| c.degree() == degree)
            })
        })
    }),
    ("BSplineCurve::periodic", |c, a, b| {
        let points = &c.control_points()[..2];
        C::periodic(3, &[0.0, a, b], points).map_or(true, |c| c.control_points().len() == 5)
            && C::periodic(3, &[0.0, 0.5, 0.75, 1.0], points).is_err()
            && C::periodic(3, &[], points).is_err()
    }),
    ("BSplineCurve::map", |c, a, b| c.map(|p| [a, b, p[0]]).control_points().len() == 5),
    ("BSplineCurve::interpolate_closed", |c, _, _| {
        [0, 1, 2, 3, 9, usize::MAX].into_iter().all(|degree| {
            [Spacing::Uniform, Spacing::Chord, Spacing::Centripetal].into_iter().all(|spacing| {
                C::interpolate_closed(degree, c.control_points(), spacing)
                    .map_or(true, |c| c.degree() == degree)
            })
        })
    }),
    ("BSplineSurface::extruded", |c, a, b| {
        S::extruded(c, [a, b, 1.0]).map_or_else(not_finite, |s| s.degrees() == [2, 1] && all_finite(&s))
    }),
    ("BSplineSurface::ruled", |c, _, _| {
        S::ruled(c, &c.reversed())
            .map_or_else(not_finite, |s| s.domain().ranges() == [[0.0, 1.0]; 2] && all_finite(&s))
    }),
    ("BSplineSurface::translated", |c, _, _| {
        S::translated(c, c).map_or_else(not_finite, |s| s.degrees() == [2, 2] && all_finite(&s))
    }),
    ("BSplineSurface::lofted", |c, a, _| {
        let sections =
            [c.clone(), c.map(|p| [p[0], p[1], p[2] + a]), c.map(|p| [p[1], p[0], p[2] - 2.0 * a])];
        [0, 1, 2, 3, usize::MAX].into_iter().all(|degree| {
            S::lofted(&sections, degree, Spacing::Uniform).map_or(true, |s| s.degrees() == [2, degree])
        }) && S::lofted(&[], 1, Spacing::Chord).is_err()
    }),
    ("BSplineSurface::coons", |c, a, _| {
        let moved = c.map(|p| [p[0], p[1] + a, p[2]]);
        let side = |from: P, to: P| C::from_bezier([from, to]).unwrap();
        let sides = [side(c.start(), moved.start()), side(c.end(), moved.end())];
        let found = S::coons([c, &moved], [&sides[0], &sides[1]], 1e-9);
        found.map_or(true, |s| s.degrees() == [2, 1]) && S::coons([c, c], [c, c], f64::NAN).is_err()
    }),
    ("BSplineSurface::swept", |c, a, _| {
        let path = c.map(|p| [p[0], p[1] + a, p[2]]);
        [0, 1, 2, 5, usize::MAX]
            .into_iter()
            .all(|count| S::swept(c, &path, count, Some([a, 0.0, 1.0])).map_or(true, |s| s.degrees()[0] == 2))
    }),
    ("BSplineCurve::interpolate_at", |c, a, b| {
        C::interpolate_at(c.knots().clone(), &[0.0, a, 0.5, b, 1.0], c.control_points())
            .map_or(true, |_| a < b)
    }),
    ("BSplineCurve::fit", |c, a, b| {
        let weights = [1.0, a, b, 1.0, a];
        C::fit(c.knots().clone(), &[0.0, a, 0.5, 0.75, 1.0], c.control_points(), Some(&weights))
            .map_or(true, |_| (0.0..=1.0).contains(&a) && b.is_finite())
    }),
    ("parameters", |c, _, _| {
        parameters(c.control_points(), Spacing::Centripetal)
            .map_or(true, |all| all[0] == 0.0 && all[4] == 1.0)
    }),
    ("Homogeneous::new", |c, a, _| {
        Homogeneous::new(c.control_points()[1], a).weight.to_bits() == a.to_bits()
    }),
    ("Homogeneous::project", |c, a, _| {
        let _ = Homogeneous::new(c.control_points()[1], a).project();
        true
    }),
];

const NURBS_CURVE: &[Case<RationalCurve>] = &[
    ("NurbsCurve::new", |c, a, b| {
        let weights = vec![1.0, a, b, 1.0, 1.0];
        RationalCurve::new(c.knots().clone(), c.control_points(), weights)
            .map_or(true, |_| a > 0.0 && b > 0.0 && (a + b).is_finite() || a == f64::MAX)
    }),
    ("NurbsCurve::from_homogeneous", |c, _, _| {
        RationalCurve::from_homogeneous(c.homogeneous().clone()).is_ok()
    }),
    ("NurbsCurve::map", |c, a, b| c.map(|p| [a, b, p[0]]).weights() == c.weights()),
    ("NurbsSurface::extruded", |c, a, b| {
        NurbsSurface::extruded(c, [a, b, 1.0]).map_or_else(not_finite, |s| s.degrees() == [2, 1])
    }),
    ("NurbsSurface::ruled", |c, _, _| {
        NurbsSurface::ruled(c, &c.reversed()).map_or(true, |s| s.domain().ranges() == [[0.0, 1.0]; 2])
    }),
    ("NurbsSurface::translated", |c, a, b| {
        [c, &with_end_weights(c, a, b)].iter().all(|path| {
            NurbsSurface::translated(c, path).map_or(true, |s| {
                s.degrees() == [2, 2] && s.weights().as_slice().iter().all(|&w| w > 0.0 && w.is_finite())
            })
        })
    }),
    ("NurbsSurface::lofted", |c, a, b| {
        let sections = [c.clone(), c.map(|p| [p[0], p[1], p[2] + a]), with_end_weights(c, a, b)];
        [0, 1, 2, 3, usize::MAX].into_iter().all(|degree| {
            NurbsSurface::lofted(&sections, degree, Spacing::Uniform)
                .map_or(true, |s| s.degrees() == [2, degree])
        }) && RationalSurface::lofted(&[], 1, Spacing::Chord).is_err()
    }),
    ("NurbsSurface::coons", |c, a, b| {
        let moved = with_end_weights(c, a, b).map(|p| [p[0], p[1] + a, p[2]]);
        let line = KnotVector::uniform(1, 1).unwrap();
        let side = |from: P, to: P| NurbsCurve::new(line.clone(), [from, to], [1.0, 0.25]).unwrap();
        let sides = [side(c.start(), moved.start()), side(c.end(), moved.end())];
        let found = NurbsSurface::coons([c, &moved], [&sides[0], &sides[1]], 1e-9);
        found.map_or(true, |s| s.degrees() == [2, 1])
            && NurbsSurface::coons([c, c], [c, c], f64::NAN).is_err()
    }),
    ("NurbsSurface::swept", |c, a, b| {
        let path = with_end_weights(c, b, a).map(|p| [p[0], p[1] + a, p[2]]);
        [0, 1, 2, 5, usize::MAX].into_iter().all(|count| {
            NurbsSurface::swept(c, &path, count, Some([a, 0.0, 1.0])).map_or(true, |s| s.degrees()[0] == 2)
        })
    }),
    ("NurbsCurve::homogeneous", |c, _, _| c.homogeneous().degree() == 2),
    ("NurbsCurve::degree", |c, _, _| c.degree() == 2),
    ("NurbsCurve::knots", |c, _, _| c.knots().functions() == 5),
    ("NurbsCurve::control_points", |c, _, _| c.control_points().len() == 5),
    ("NurbsCurve::weights", |c, _, _| c.weights().iter().all(|&w| w > 0.0)),
    ("NurbsCurve::domain", |c, _, _| c.domain() == [0.0, 1.0]),
    ("NurbsCurve::eval", |c, a, _| !a.is_nan() || is_nan(c.eval(a))),
    ("NurbsCurve::eval_checked", |c, a, _| c.eval_checked(a).is_ok() == (0.0..=1.0).contains(&a)),
    ("NurbsCurve::eval_with_derivs", |c, a, _| !a.is_nan() || is_nan(c.eval_with_derivs::<4>(a)[0])),
    ("NurbsCurve::insert_knots", |c, a, b| c.insert_knots(&[a, b]).map_or(true, |c| c.weights().len() == 7)),
    ("NurbsCurve::elevate", |c, _, _| c.elevate().is_ok_and(|c| c.degree() == 3)),
    ("NurbsCurve::split", |c, a, _| c.split(a).is_ok() == (a > 0.0 && a < 1.0)),
    ("NurbsCurve::remove_knot", |c, a, b| {
        let _ = (c.remove_knot(0.5, 1, a), c.remove_knot(a, 1, b));
        true
    }),
    ("NurbsCurve::refined", |c, _, _| c.refined().weights().len() > 5),
    ("NurbsCurve::clamped", |c, _, _| c.clamped().knots().is_clamped()),
    ("NurbsCurve::merged", |c, _, _| c.merged(c).is_ok()),
    ("NurbsCurve::reversed", |c, _, _| c.reversed().domain() == c.domain()),
    ("NurbsCurve::to_bezier", |c, _, _| c.to_bezier().len() == 2),
    ("NurbsCurve::to_rational_bezier", |c, _, _| c.to_rational_bezier().len() == 2),
    ("NurbsSurface::revolved", |c, a, b| {
        let turned = NurbsSurface::revolved(c, [a, 0.0, 0.0], [0.0, b, 1.0], a);
        turned.map_or(true, |surface| surface.degrees() == [2, 2])
    }),
];

const SURFACE: &[Case<S>] = &[
    ("BSplineSurface::new", |s, _, _| S::new(knots(), knots(), s.net().clone()).is_ok()),
    ("BSplineSurface::from_bezier", |s, _, _| S::from_bezier(s.net().clone()).is_ok()),
    ("BSplineSurface::map", |s, a, _| s.map(|p| [p[0], a]).degrees() == [2, 3]),
    ("BSplineSurface::degrees", |s, _, _| s.degrees() == [2, 3]),
    ("BSplineSurface::knots", |s, _, _| BOTH.iter().all(|&d| s.knots(d).functions() == 5)),
    ("BSplineSurface::net", |s, _, _| s.net().rows() == 5),
    ("BSplineSurface::control_points_mut", |s, _, _| s.clone().control_points_mut().len() == 25),
    ("BSplineSurface::domain", |s, _, _| s.domain().ranges() == [[0.0, 1.0]; 2]),
    ("BSplineSurface::eval", |s, a, b| !(a.is_nan() || b.is_nan()) || is_nan(s.eval(a, b))),
    ("BSplineSurface::eval_checked", |s, a, b| {
        s.eval_checked(a, b).is_ok() == ((0.0..=1.0).contains(&a) && (0.0..=1.0).contains(&b))
    }),
    ("BSplineSurface::eval_clamped", |s, a, b| !a.is_nan() || is_nan(s.eval_clamped(a, b))),
    ("BSplineSurface::partial", |s, a, b| {
        let _ = [[0, 0], [1, 1], [9, 0], [usize::MAX; 2]].map(|orders| s.partial(a, b, orders));
        true
    }),
    ("BSplineSurface::eval_grid", |s, a, b| {
        let mut grid = [[0.5; 3]; 3];
        s.eval_grid(&[a, b], &[b], &mut grid[..2]).is_ok()
            && s.eval_grid(&[], &[a], &mut grid[2..]).is_err()
            && grid[2] == [0.5; 3]
    }),
    ("BSplineSurface::isocurve", |s, a, _| {
        BOTH.iter().all(|&d| s.isocurve(d, a).control_points().len() == 5)
    }),
    ("BSplineSurface::boundary", |s, _, _| {
        Edge::ALL.iter().all(|&edge| s.boundary(edge).control_points().len() == 5)
    }),
    ("BSplineSurface::insert_knots", |s, a, b| {
        BOTH.iter().all(|&d| s.insert_knots(d, &[a, b]).map_or(true, |s| s.knots(d).functions() == 7))
    }),
    ("BSplineSurface::refined", |s, _, _| BOTH.iter().all(|&d| s.refined(d).knots(d).functions() > 5)),
    ("BSplineSurface::remove_knot", |s, a, b| {
        let _ = BOTH.map(|d| (s.remove_knot(d, 0.5, 1, a), s.remove_knot(d, a, 9, b)));
        true
    }),
    ("BSplineSurface::elevate", |s, _, _| BOTH.iter().all(|&d| s.elevate(d).is_ok())),
    ("BSplineSurface::clamped", |s, _, _| s.clamped().knots(Direction::V).is_clamped()),
    ("BSplineSurface::split", |s, a, _| BOTH.iter().all(|&d| s.split(d, a).is_ok() == (a > 0.0 && a < 1.0))),
    ("BSplineSurface::subpatch", |s, a, b| {
        let inside = |t: f64| (0.0..=1.0).contains(&t);
        s.subpatch(a..b, b..a).is_ok() == (inside(a) && inside(b) && a != b)
    }),
    ("BSplineSurface::to_bezier", |s, _, _| s.to_bezier().len() == 4),
    ("BSplineSurface::merged", |s, _, _| s.merged(s).is_ok()),
    ("BSplineSurface::transposed", |s, _, _| s.transposed().degrees() == [3, 2]),
    ("BSplineSurface::reversed", |s, _, _| BOTH.iter().all(|&d| s.reversed(d).domain() == s.domain())),
    ("BSplineSurface::nearest", |s, a, b| {
        !few(a, b)
            || s.nearest([a, 0.25, b], b).is_none_or(|found| {
                let inside = found.at.iter().all(|x| (0.0..=1.0).contains(x));
                inside && found.at_least <= found.distance && is_length(found.distance)
            })
    }),
    ("BSplineSurface::pass_through", |s, a, b| {
        let constraints = [PointConstraint::At([a, 0.5], [b; 3]), PointConstraint::At([0.25, b], [a; 3])];
        s.pass_through(&constraints)
            .map_or(true, |found| found.surface.net().as_slice().iter().all(|&p| is_finite(p)))
    }),
    ("BSplineSurface::pass_through_holding", |s, a, b| {
        !few(a, b)
            || s.pass_through_holding(&[PointConstraint::Nearest([a, b, 0.0])], |i, _| i > 0)
                .map_or(true, |found| is_length(found.change))
    }),
    ("BSplineSurface::interpolate", |s, _, _| {
        let _ =
            [[0, 1], [3, 3], [9, usize::MAX]].map(|degrees| S::interpolate(degrees, s.net(), Spacing::Chord));
        true
    }),
    ("BSplineSurface::fit", |s, a, b| {
        let (u, v) = ([0.0, a, 0.5, 0.75, 1.0], [0.0, 0.25, b, 0.75, 1.0]);
        S::fit([knots(), knots()], [&u, &v], s.net()).map_or(true, |_| (0.0..=1.0).contains(&a))
    }),
    ("EdgePair::nearest", |s, _, _| EdgePair::nearest(s, Edge::UEnd, s, Edge::VStart).second == Edge::VStart),
    ("BSplineSurface::joint_bounds", |s, a, b| {
        let [edge, target] = [a, b].map(|x| if x > 0.0 { Edge::UEnd } else { Edge::VStart });
        let joint = pair(edge, target, a > b);
        s.joint_bounds(joint, s).map_or(true, |m| m.gap >= 0.0 && (0.0..=3.2).contains(&m.angle))
    }),
    ("JointBounds::geometric_order", |s, a, b| {
        let joint = s.joint_bounds(EdgePair::along(Edge::UEnd, Edge::UStart), s);
        joint.map_or(true, |joint| joint.geometric_order(a, b).is_none_or(|k| k <= 1))
    }),
    ("BSplineSurface::continued", |s, a, b| {
        let joint = pair(Edge::UEnd, Edge::VStart, b > 0.0);
        [0, 1, 2, 3, usize::MAX].into_iter().all(|order| {
            let contact =
                if order == 2 { Contact::Curvature { f: a, c: b } } else { Contact::Scaled { order, f: a } };
            s.continued(joint, contact, s).map_or(true, |next| order <= next.degrees()[1])
        })
    }),
    ("BSplineSurface::continued_within", |s, a, b| {
        let joint = pair(Edge::UEnd, Edge::VStart, b > 0.0);
        [Method::LeastSquares, Method::Exact].into_iter().all(|method| {
            let options = SpliceOptions::default().method(method).gap(a).angle(b).spans(6);
            s.continued_within(joint.swapped(), &options, s)
                .map_or(true, |found| found.joint.gap <= a && found.joint.angle <= b)
        })
    }),
    ("SpliceOptions::second_row", |s, a, b| {
        let joint = pair(Edge::UEnd, Edge::VStart, a > 0.0);
        let options = SpliceOptions::default().method(Method::LeastSquares).second_row(SecondRow::Kept);
        let options = options.gap(a).angle(b).spans(6);
        s.continued_within(joint.swapped(), &options, s)
            .map_or(true, |found| found.joint.gap <= a && found.joint.angle <= b)
    }),
    ("SpliceOptions::edge_knots", |s, a, b| {
        let joint = pair(Edge::UEnd, Edge::VStart, a > 0.0);
        let options = SpliceOptions::default().method(Method::LeastSquares).edge_knots(EdgeKnots::Own);
        let options = options.gap(a).angle(b).spans(6);
        s.continued_within(joint.swapped(), &options, s)
            .map_or(true, |found| found.joint.gap <= a && found.joint.angle <= b)
    }),
    ("Network::new", |s, _, _| Network::new(vec![s.clone()], Vec::new()).is_ok()),
    ("Network::grid", |s, _, _| {
        let patches = || vec![s.clone(), s.clone()];
        Network::grid(patches(), 0).is_err() && Network::grid(patches(), 3).is_err()
    }),
    ("Network::patches", |s, _, _| {
        Network::grid(vec![s.clone(); 2], 2).is_ok_and(|n| n.patches().len() == 2)
    }),
    ("Network::seams", |s, _, _| Network::grid(vec![s.clone(); 2], 1).is_ok_and(|n| n.seams().len() == 1)),
    ("Network::joint_bounds", |s, _, _| {
        let network = Network::grid(vec![s.clone(); 2], 2).unwrap();
        network.joint_bounds(usize::MAX).is_err() && network.joint_bounds(0).map_or(true, |m| m.gap >= 0.0)
    }),
    ("Network::follow", |s, a, b| {
        let network = Network::grid(vec![s.clone(); 2], 2).unwrap();
        let options = FollowOptions::default().gap(a).angle(b).spans(6);
        let moved = s.map(|p| [p[0], p[1] + a, p[2]]);
        network.follow(9, &moved, &options).is_err()
            && network.follow(0, &moved, &options).map_or(true, |found| found.changed[0] == 0)
    }),
    ("Net::from_rows", |s, _, _| {
        Net::<P>::from_rows([[[0.0; 3]; 0]; 2]).is_err()
            && Net::from_rows([vec![[0.0; 3]; 2], vec![[0.0; 3]]]).is_err()
            && Net::from_rows([s.net().row(0)]).is_ok()
    }),
    ("Net::from_fn", |_, a, _| {
        Net::from_fn(0, 3, |_, _| [a; 3]).is_err() && Net::from_fn(usize::MAX, usize::MAX, |_, _| a).is_err()
    }),
    ("Net::rows", |s, _, _| s.net().rows() == 5),
    ("Net::columns", |s, _, _| s.net().columns() == 5),
    ("Net::row", |s, _, _| s.net().row(4).len() == 5),
    ("Net::column", |s, _, _| s.net().column(4).count() == 5),
    ("Net::as_slice", |s, _, _| s.net().as_slice().len() == 25),
    ("Net::as_mut_slice", |s, _, _| s.net().clone().as_mut_slice().len() == 25),
    ("Net::transposed", |s, _, _| s.net().transposed().rows() == 5),
    ("Net::map", |s, a, _| s.net().map(|_| a).as_slice().len() == 25),
];

const NURBS_SURFACE: &[Case<RationalSurface>] = &[
    ("NurbsSurface::new", |s, a, b| {
        let weights = Net::from_fn(5, 5, |i, j| if i > j { a } else { b }).unwrap();
        let made = RationalSurface::new(knots(), unclamped(), &s.net(), &weights);
        made.map_or(true, |_| a > 0.0 && b > 0.0)
    }),
    ("NurbsSurface::map", |s, a, b| s.map(|p| [a, b, p[0]]).weights() == s.weights()),
    ("NurbsSurface::from_homogeneous", |s, _, _| {
        RationalSurface::from_homogeneous(s.homogeneous().clone()).is_ok()
    }),
    ("NurbsSurface::continued", |s, a, b| {
        let joint = pair(Edge::UEnd, Edge::VStart, b > 0.0);
        [0, 1, 2, 3, usize::MAX].into_iter().all(|order| {
            let contact =
                if order == 2 { Contact::Curvature { f: a, c: b } } else { Contact::Scaled { order, f: a } };
            s.continued(joint, contact, s).map_or(true, |next| {
                order <= 3 && next.weights().as_slice().iter().all(|&w| w > 0.0 && w.is_finite())
            })
        })
    }),
    ("NurbsSurface::homogeneous", |s, _, _| s.homogeneous().degrees() == [2, 3]),
    ("NurbsSurface::degrees", |s, _, _| s.degrees() == [2, 3]),
    ("NurbsSurface::knots", |s, _, _| BOTH.iter().all(|&d| s.knots(d).functions() == 5)),
    ("NurbsSurface::net", |s, _, _| s.net().rows() == 5),
    ("NurbsSurface::weights", |s, _, _| s.weights().as_slice().iter().all(|&w| w > 0.0)),
    ("NurbsSurface::domain", |s, _, _| s.domain().ranges() == [[0.0, 1.0]; 2]),
    ("NurbsSurface::eval", |s, a, b| !(a.is_nan() || b.is_nan()) || is_nan(s.eval(a, b))),
    ("NurbsSurface::eval_checked", |s, a, b| {
        s.eval_checked(a, b).is_ok() == ((0.0..=1.0).contains(&a) && (0.0..=1.0).contains(&b))
    }),
    ("NurbsSurface::insert_knots", |s, a, b| {
        BOTH.iter().all(|&d| s.insert_knots(d, &[a, b]).map_or(true, |s| s.knots(d).functions() == 7))
    }),
    ("NurbsSurface::elevate", |s, _, _| BOTH.iter().all(|&d| s.elevate(d).is_ok())),
    ("NurbsSurface::split", |s, a, _| BOTH.iter().all(|&d| s.split(d, a).is_ok() == (a > 0.0 && a < 1.0))),
    ("NurbsSurface::subpatch", |s, a, b| {
        let inside = |t: f64| (0.0..=1.0).contains(&t);
        s.subpatch(a..b, b..a).is_ok() == (inside(a) && inside(b) && a != b)
    }),
    ("NurbsSurface::remove_knot", |s, a, b| {
        let _ = BOTH.map(|d| (s.remove_knot(d, 0.5, 1, a), s.remove_knot(d, a, 9, b)));
        true
    }),
    ("NurbsSurface::to_bezier", |s, _, _| s.to_bezier().len() == 4),
    ("NurbsSurface::isocurve", |s, a, _| BOTH.iter().all(|&d| s.isocurve(d, a).weights().len() == 5)),
    ("NurbsSurface::boundary", |s, _, _| Edge::ALL.iter().all(|&edge| s.boundary(edge).weights().len() == 5)),
    ("NurbsSurface::refined", |s, _, _| BOTH.iter().all(|&d| s.refined(d).knots(d).functions() > 5)),
    ("NurbsSurface::clamped", |s, _, _| s.clamped().knots(Direction::V).is_clamped()),
    ("NurbsSurface::merged", |s, _, _| s.merged(s).is_ok()),
    ("NurbsSurface::transposed", |s, _, _| s.transposed().degrees() == [3, 2]),
    ("NurbsSurface::reversed", |s, _, _| BOTH.iter().all(|&d| s.reversed(d).domain() == s.domain())),
];

/// The names of all tables.
pub(crate) fn names() -> Vec<&'static str> {
    fn of<T>(cases: &[Case<T>]) -> impl Iterator<Item = &'static str> + '_ {
        cases.iter().map(|(name, _)| *name)
    }
    let surfaces = of(SURFACE).chain(of(NURBS_SURFACE)).chain(crate::patches::of_splines());
    of(KNOTS).chain(of(CURVE)).chain(of(NURBS_CURVE)).chain(surfaces).collect()
}

#[test]
fn knot_vectors() {
    for (name, call) in KNOTS {
        for knots in [knots(), unclamped()] {
            for (a, b) in (0..3).flat_map(crate::pairs) {
                assert!(call(&knots, a, b), "{name} with {a:e} and {b:e}: {knots:?}");
            }
        }
    }
}

#[test]
fn spline_curves() {
    check(CURVE, |net| C::new(knots(), (0..5).map(net).collect::<Vec<_>>()).ok());
}

#[test]
fn rational_spline_curves() {
    for weight in [2.0, 1e-300, f64::MAX] {
        check(NURBS_CURVE, |net| {
            let weights = (0..5).map(|i| if i % 2 == 1 { weight } else { 1.0 }).collect::<Vec<_>>();
            RationalCurve::new(knots(), (0..5).map(net).collect::<Vec<_>>(), weights).ok()
        });
    }
}

#[test]
fn spline_surfaces() {
    check(SURFACE, |net| Some(surface(net)));
}

#[test]
fn rational_spline_surfaces() {
    check(NURBS_SURFACE, |net| {
        let weights = Net::from_fn(5, 5, |i, j| if (i + j) % 3 == 1 { 2.0 } else { 1.0 }).unwrap();
        RationalSurface::new(knots(), unclamped(), surface(net).net(), &weights).ok()
    });
}

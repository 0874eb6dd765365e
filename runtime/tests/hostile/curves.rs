//! Curves and curves of several segments.

use basis_runtime::{
    Basis as _, BernsteinBasis, BernsteinForm, Bezier, Contact, Curve, EndpointForm, Form as _,
    ParametricCurve as _, PiecewiseCurve, basis,
};

use crate::{Case, NUMBERS, P, check, is_box, is_finite, is_length, is_nan, is_unit};

basis!("../../../specs/quartic.basis");

type Quartic = Curve<QuarticBernstein, P>;

fn finite(curve: &Quartic) -> bool {
    curve.control_points().iter().all(|&p| is_finite(p))
}

/// Whether all numbers of the curve can be squared and multiplied.
fn moderate(curve: &Quartic) -> bool {
    curve.control_points().iter().flatten().all(|c| *c == 0.0 || (1e-60..1e60).contains(&c.abs()))
}

const CURVE: &[Case<Quartic>] = &[
    ("new", |_, a, _| QuarticBernstein::new(a).is_ok() == (-3.0..=1.0).contains(&a)),
    ("from_slice", |c, _, _| {
        Quartic::from_slice(c.basis(), c.control_points()).is_ok()
            && Quartic::from_slice(c.basis(), &c.control_points()[1..]).is_err()
    }),
    ("with_basis", |c, _, _| c.with_basis(QuarticBernstein::new(1.0).unwrap()).basis() != c.basis()),
    ("map", |c, a, b| c.map(|p| [p[0], a, b]).control_points().len() == 4),
    ("eval", |c, a, _| !a.is_nan() || is_nan(c.eval(a))),
    ("eval_checked", |c, a, _| c.eval_checked(a).is_ok() == (0.0..=1.0).contains(&a)),
    ("eval_clamped", |c, a, _| {
        let p = c.eval_clamped(a);
        if a.is_nan() { is_nan(p) } else { !moderate(c) || is_finite(p) }
    }),
    ("eval_with_derivs", |c, a, _| {
        c.eval_with_derivs::<7>(a)[5..] == [[0.0; 3]; 2] || !moderate(c) || !a.is_finite()
    }),
    ("derivative", |c, a, _| {
        let _ = [0, 1, 4, 5, 90, usize::MAX].map(|order| c.derivative(a, order));
        true
    }),
    ("derivatives_into", |c, a, _| {
        c.derivatives_into(a, &mut []);
        c.derivatives_into(a, &mut [[0.0; 3]; 9]);
        true
    }),
    ("start", |c, _, _| c.start() == c.eval(0.0) || !moderate(c)),
    ("end", |c, _, _| c.end() == c.eval(1.0) || !moderate(c)),
    ("domain", |c, _, _| c.domain() == [0.0, 1.0]),
    ("basis", |c, _, _| c.basis().values(0.0)[0] == 1.0),
    ("control_points", |c, _, _| c.control_points().len() == 4),
    ("to_bernstein", |c, _, _| c.to_bernstein().len() == 5),
    ("control_box", |c, _, _| is_box(c.control_box())),
    ("form", |c, _, _| !moderate(c) || is_finite(c.form().eval(0.5))),
    ("points", |c, a, _| {
        let form = BernsteinForm::new(c.to_bernstein());
        form.points().len() == 5 && (!a.is_nan() || is_nan(form.eval(a)))
    }),
    ("ends", |c, a, b| {
        let form = EndpointForm::new([c.start(), c.end()], [[b; 3]; 2]);
        form.ends().len() == 2 && (!a.is_nan() || is_nan(form.eval(a)))
    }),
    ("inner", |c, a, _| EndpointForm::new([c.start(), c.end()], [[a; 3]; 3]).inner().len() == 3),
    ("extrema", |c, _, _| c.extrema().iter().all(|t| (0.0..=1.0).contains(t))),
    ("bounding_box", |c, _, _| is_box(c.bounding_box())),
    ("inflections", |c, _, _| c.inflections().is_err()),
    ("order", |_, a, b| {
        Contact::Curvature { f: a, c: b }.order() == 2 && Contact::<f64>::Parametric { order: 9 }.order() == 9
    }),
    ("flatten", |c, a, _| {
        // The number of points grows with the root of what is asked for.
        let tolerance = if a.abs() < 1e-6 { a.signum() * 1e-6 } else { a };
        let scaled = !moderate(c) || c.control_points().iter().flatten().any(|x| x.abs() > 1e3);
        scaled && tolerance > 0.0 && tolerance < 1e3
            || c.flatten(tolerance).map_or(true, |points| points.len() >= 2)
    }),
    ("tangent", |c, a, _| c.tangent(a).is_none_or(is_unit)),
    ("curvature", |c, a, _| is_length(c.curvature(a))),
    ("torsion", |c, a, _| c.torsion(a).is_nan() || !a.is_nan()),
    ("frenet_frame", |c, a, _| {
        c.frenet_frame(a).map_or(true, |f| is_unit(f.tangent) && is_unit(f.normal) && is_unit(f.binormal))
    }),
    ("rotation_minimizing_frames", |c, a, b| {
        [0, 1, 2, 5].into_iter().all(|count| {
            [None, Some([a, b, 1.0])].into_iter().all(|normal| {
                c.rotation_minimizing_frames(count, normal).map_or(true, |frames| frames.len() == count)
            })
        })
    }),
    ("rotation_minimizing_frames_into", |c, a, b| {
        c.rotation_minimizing_frames_into(Some([a, b, 0.0]), &mut []).map_or(true, |()| true)
    }),
    ("geometric_order", |c, a, b| c.joint(c).geometric_order(a, b, a).is_none_or(|k| k <= 2)),
    ("parametric_order", |c, a, b| c.joint(c).parametric_order(a, [b, a, b]).is_none_or(|k| k <= 3)),
    ("joint", |c, _, _| is_length(c.joint(c).gap) && is_length(c.joint(c).angle)),
    ("arclen", |c, a, _| is_length(c.arclen(a)) && (finite(c) || c.arclen(a).is_nan())),
    ("inv_arclen", |c, a, b| {
        let t = c.inv_arclen(a, b);
        (0.0..=1.0).contains(&t) || a.is_nan() || c.arclen(1.0).is_nan()
    }),
    ("arclen_parameters", |c, a, _| {
        [0, 1, 2, 7].into_iter().all(|count| {
            let parameters = c.arclen_parameters(count, a);
            parameters.len() == count && (parameters.is_sorted() || parameters.iter().all(|t| t.is_nan()))
        })
    }),
    ("samples_by_arclen", |c, a, _| {
        [0, 1, 2, 7].into_iter().all(|count| c.samples_by_arclen(count, a).len() == count)
    }),
    ("nearest", |c, a, b| {
        c.nearest([a, b, 0.25], b).is_none_or(|found| {
            (0.0..=1.0).contains(&found.at) && found.distance >= found.at_least && found.at_least >= 0.0
        })
    }),
    ("from_points", |c, _, _| Bezier::<P, 5>::from_points(c.to_bernstein()).control_points().len() == 5),
    ("to_bezier", |c, _, _| c.to_bezier().domain() == [0.0, 1.0]),
    ("elevate", |c, _, _| c.elevate::<9>().control_points().len() == 9),
    ("split", |c, a, _| {
        let Ok([left, right]) = c.split(a) else { return !(a > 0.0 && a < 1.0) };
        a > 0.0 && a < 1.0 && (left.end() == right.start() || !finite(c) || !moderate(c))
    }),
    ("subsegment", |c, a, b| {
        let inside = |t: f64| (0.0..=1.0).contains(&t);
        let Ok(part) = c.subsegment(a..b) else { return !inside(a) || !inside(b) || a == b };
        inside(a) && inside(b) && (a != 0.0 || b != 1.0 || !finite(c) || part == c.to_bezier())
    }),
    ("reversed", |c, _, _| !moderate(c) || c.reversed().reversed() == c.to_bezier()),
    ("hodograph", |c, a, _| !a.is_nan() || is_nan(c.hodograph().eval(a))),
    ("eval_into", |c, a, b| {
        let mut out = [[0.0; 3]; 2];
        c.eval_into(&[a, b], &mut out).is_ok()
            && c.eval_into(&[a], &mut out).is_err()
            && c.eval_into(&[], &mut []).is_ok()
    }),
    ("eval_with_derivs_into", |c, a, b| {
        let (mut points, mut velocities) = ([[0.0; 3]; 2], [[0.0; 3]; 2]);
        c.eval_with_derivs_into(&[a, b], [&mut points, &mut velocities]).is_ok()
            && c.eval_with_derivs_into(&[a, b], [&mut points, &mut velocities[..1]]).is_err()
    }),
    ("eval_components_into", |c, a, b| {
        let [mut x, mut y, mut z] = [[0.0; 2]; 3];
        c.eval_components_into(&[a, b], &mut [&mut x, &mut y, &mut z]).is_ok()
            && c.eval_components_into(&[a, b], &mut [&mut x, &mut y]).is_err()
    }),
    ("component", |c, a, _| !a.is_nan() || c.component(2).eval(a).is_nan()),
    ("samples", |c, _, _| {
        [0, 1, 2, 9].into_iter().all(|count| c.samples(count).rev().count() == count)
            && c.samples(usize::MAX).next().is_some()
    }),
    ("samples_into", |c, _, _| {
        c.samples_into(&mut []);
        c.samples_into(&mut [[0.0; 3]; 1]);
        true
    }),
    ("curve_after", |c, a, b| {
        let contacts = [
            Contact::Parametric { order: 0 },
            Contact::Parametric { order: 2 },
            Contact::Parametric { order: usize::MAX },
            Contact::Tangent { f: a },
            Contact::Curvature { f: a, c: b },
        ];
        contacts.into_iter().all(|contact| {
            let points = [[0.0; 3], [1.0; 3], [a; 3], [b; 3]];
            let found = [-3.0, 0.5]
                .map(|shape| QuarticBernstein::new(shape).unwrap().curve_after(c, contact, points));
            found.iter().flatten().all(finite)
        })
    }),
    ("curve_before", |c, a, b| {
        let basis = BernsteinBasis::<f64, 4>::new();
        basis
            .curve_before(c, Contact::Curvature { f: a, c: b }, [[a; 3]; 4])
            .map_or(true, |curve| curve.control_points().iter().all(|&p| is_finite(p)))
    }),
];

type Piecewise = PiecewiseCurve<Curve<QuarticBernstein, P>>;

const PIECEWISE: &[Case<Piecewise>] = &[
    ("new", |_, _, _| Piecewise::new(Vec::new()).is_err()),
    ("push", |c, _, _| {
        let mut c = c.clone();
        c.push(c.segments()[0]);
        c.segments().len() == 3
    }),
    ("continued", |c, a, b| {
        let contact = Contact::Curvature { f: a, c: b };
        let draft = Quartic::new(QuarticBernstein::new(0.0).unwrap(), [[1.0; 3]; 4]);
        let next = c.continued(contact, &Piecewise::from(draft));
        next.map_or(true, |next| next.segments()[0].control_points().iter().all(|&p| is_finite(p)))
    }),
    ("append", |c, _, _| {
        let mut twice = c.clone();
        twice.append(c);
        twice.domain() == [0.0, 4.0]
    }),
    ("segments", |c, _, _| c.segments().len() == 2),
    ("domain", |c, _, _| c.domain() == [0.0, 2.0]),
    ("locate", |c, a, _| c.locate(a).0 < 2),
    ("eval", |c, a, _| !a.is_nan() || is_nan(c.eval(a))),
    ("eval_checked", |c, a, _| c.eval_checked(a).is_ok() == (0.0..=2.0).contains(&a)),
    ("eval_clamped", |c, a, _| !a.is_nan() || is_nan(c.eval_clamped(a))),
    ("eval_with_derivs", |c, a, _| !a.is_nan() || is_nan(c.eval_with_derivs::<3>(a)[0])),
    ("start", |c, _, _| c.start() == c.segments()[0].start() || is_nan(c.start()) || !is_finite(c.start())),
    ("end", |c, _, _| c.end() == c.segments()[1].end() || !is_finite(c.end())),
    ("joints", |c, _, _| c.joints().len() == 1),
    ("closing_joint", |c, _, _| is_length(c.closing_joint().gap)),
    ("continuity", |c, a, b| c.continuity(a, b, a).len() == 1),
    ("to_bezier", |c, _, _| c.to_bezier().segments().len() == 2),
    ("reversed", |c, _, _| c.reversed().segments().len() == 2),
    ("split", |c, a, _| {
        let Ok(parts) = c.split(a) else { return !(a > 0.0 && a < 2.0) };
        let count: usize = parts.iter().map(|part| part.segments().len()).sum();
        a > 0.0 && a < 2.0 && count == if a == 1.0 { 2 } else { 3 }
    }),
    ("subsegment", |c, a, b| {
        let inside = |t: f64| (0.0..=2.0).contains(&t);
        c.subsegment(a..b).is_ok() == (inside(a) && inside(b) && a != b)
    }),
    ("arclen", |c, a, _| is_length(c.arclen(a))),
    ("inv_arclen", |c, a, b| {
        let u = c.inv_arclen(a, b);
        (0.0..=2.0).contains(&u) || u.is_nan()
    }),
    ("samples_by_arclen", |c, a, _| {
        [0, 1, 2, 5].into_iter().all(|count| c.samples_by_arclen(count, a).len() == count)
    }),
    ("samples", |c, _, _| [0, 1, 2, 5].into_iter().all(|count| c.samples(count).count() == count)),
    ("nearest", |c, a, b| c.nearest([a, 0.5, b], b).is_none_or(|found| (0.0..=2.0).contains(&found.at))),
    ("bounding_box", |c, _, _| is_box(c.bounding_box())),
    ("control_box", |c, _, _| is_box(c.control_box())),
    ("flatten", |c, a, _| (a > 0.0 && a < 1e3) || c.flatten(a).map_or(true, |points| points.len() >= 2)),
    ("curvature", |c, a, _| is_length(c.curvature(a))),
    ("tangent", |c, a, _| c.tangent(a).is_none_or(is_unit)),
];

/// In the plane.
const PLANE: &[Case<Curve<QuarticBernstein, [f64; 2]>>] = &[
    ("inflections", |c, _, _| {
        c.inflections().map_or(true, |ts| ts.is_sorted() && ts.iter().all(|t| (0.0..=1.0).contains(t)))
    }),
    ("curvature", |c, a, _| c.curvature(a).is_nan() || !a.is_nan()),
];

pub(crate) const NAMES: &[&str] = &{
    let mut names = [""; CURVE.len() + PIECEWISE.len()];
    let mut k = 0;
    while k < names.len() {
        names[k] = if k < CURVE.len() { CURVE[k].0 } else { PIECEWISE[k - CURVE.len()].0 };
        k += 1;
    }
    names
};

fn quartic(net: fn(usize) -> P, shape: f64) -> Quartic {
    Curve::new(QuarticBernstein::new(shape).unwrap(), core::array::from_fn(net))
}

#[test]
fn curves() {
    for shape in [0.5, -3.0] {
        check(CURVE, |net| Some(quartic(net, shape)));
    }
}

#[test]
fn curves_in_the_plane() {
    check(PLANE, |net| {
        let points = core::array::from_fn(|i| [net(i)[0], net(i)[1]]);
        Some(Curve::new(QuarticBernstein::new(0.25).unwrap(), points))
    });
}

#[test]
fn curves_of_several_segments() {
    check(PIECEWISE, |net| Piecewise::new(vec![quartic(net, 0.5), quartic(net, -1.0)]).ok());
}

/// A curve that is one point, whatever its parameter.
#[test]
fn curves_of_degree_zero() {
    let point = Bezier::<P, 1>::from_points([[1.0, 2.0, 3.0]]);
    for a in NUMBERS {
        assert!(a.is_nan() || !a.is_finite() || point.eval(a) == [1.0, 2.0, 3.0]);
        assert_eq!(point.derivative(a, 1), [0.0; 3]);
        assert_eq!(point.arclen(a), 0.0);
        assert_eq!(point.tangent(a), None);
        assert_eq!(point.inv_arclen(1.0, a), 1.0);
        assert_eq!(point.nearest([1.0, 2.0, 5.0], a).unwrap().distance, 2.0);
        let _ = (point.curvature(a), point.torsion(a), point.frenet_frame(a), point.split(a));
        let _ = (point.extrema(), point.flatten(a), point.rotation_minimizing_frames(3, None));
    }
    assert_eq!(point.bounding_box(), [[1.0, 2.0, 3.0]; 2]);
}

/// Segments of other crates are exact or refused, whatever the control points.
#[test]
#[cfg(all(feature = "kurbo", feature = "lyon_geom"))]
fn segments_of_other_crates() {
    use basis_runtime::CurveError;

    for shape in [-3.0, 0.0, 0.5] {
        for net in crate::NETS {
            let points = core::array::from_fn(|i| [net(i)[0], net(i)[1]]);
            let curve = Curve::new(QuarticBernstein::new(shape).unwrap(), points);
            let cubics = [
                kurbo::CubicBez::try_from(&curve).map(|_| ()),
                lyon_geom::CubicBezierSegment::try_from(&curve).map(|_| ()),
                kurbo::PathSeg::try_from(&curve).map(|_| ()),
                kurbo::BezPath::try_from(&PiecewiseCurve::from(curve)).map(|_| ()),
            ];
            for found in cubics {
                assert!(matches!(found, Ok(()) | Err(CurveError::Degree { most: 3, found: 4 })), "{found:?}");
            }
            assert!(kurbo::Line::try_from(&quartic(net, shape)).is_err());
            assert!(lyon_geom::LineSegment::try_from(&quartic(net, shape)).is_err());
        }
    }
}

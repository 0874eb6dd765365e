//! Where curves, rays and lines meet surfaces: nothing is missed, and what is answered is there.

use core::f64::consts::PI;

use basis_runtime::bspline::{BSplineSurface, KnotVector, Net, NurbsCurve, NurbsSurface};
use basis_runtime::{
    BernsteinBasis, Bezier, BoundedSurface, MeetingKind, ParametricCurve, Surface, SurfaceMeeting,
    SurfaceOfRevolution, TensorSurface, TriangularBezier,
};

use crate::queries::{distance, nurbs};
use crate::random::Random;

type P3 = [f64; 3];
type Bicubic = TensorSurface<BernsteinBasis<f64, 4>, BernsteinBasis<f64, 4>, P3>;
type Bilinear = TensorSurface<BernsteinBasis<f64, 2>, BernsteinBasis<f64, 2>, P3>;

/// The circle about the point at that distance from the axis, turned about the z axis: a sphere or a torus.
fn turned(from: usize, to: usize, middle: f64) -> NurbsSurface<P3> {
    let h = 0.5_f64.sqrt();
    let corners =
        [[0., -1.], [1., -1.], [1., 0.], [1., 1.], [0., 1.], [-1., 1.], [-1., 0.], [-1., -1.], [0., -1.]];
    let points: Vec<P3> = corners[from..=to].iter().map(|[x, z]| [middle + x, 0.0, *z]).collect();
    let weights: Vec<f64> = (from..=to).map(|k| if k % 2 == 0 { 1.0 } else { h }).collect();
    let breaks = (0..=(to - from) / 2).flat_map(|k| {
        let inner = k > 0 && k < (to - from) / 2;
        core::iter::repeat_n(k as f64, if inner { 2 } else { 1 })
    });
    let knots = KnotVector::clamped(2, &breaks.collect::<Vec<f64>>()).unwrap();
    let circle = NurbsCurve::new(knots, points, weights).unwrap();
    NurbsSurface::revolved(&circle, [0.0; 3], [0.0, 0.0, 1.0], 2.0 * PI).unwrap()
}

fn sphere() -> NurbsSurface<P3> {
    turned(0, 4, 0.0)
}

fn torus() -> NurbsSurface<P3> {
    turned(0, 8, 2.0)
}

fn bilinear(corners: [P3; 4]) -> Bilinear {
    let [a, b, c, d] = corners;
    TensorSurface::new(BernsteinBasis::new(), BernsteinBasis::new(), [[a, b], [c, d]])
}

fn square() -> Bilinear {
    bilinear([[0.0; 3], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]])
}

fn random_point(random: &mut Random) -> P3 {
    [(); 3].map(|()| random.between(-1.0, 1.0))
}

fn bicubic(random: &mut Random) -> Bicubic {
    let net = [(); 4].map(|()| [(); 4].map(|()| random_point(random)));
    TensorSurface::new(BernsteinBasis::new(), BernsteinBasis::new(), net)
}

/// Whether an answer holds these parameters.
fn holds(meeting: &SurfaceMeeting<P3>, [t, u, v]: P3) -> bool {
    let within = |[lo, hi]: [f64; 2], t: f64| t >= lo - 1e-6 && t <= hi + 1e-6;
    within(meeting.curve, t) && within(meeting.surface[0], u) && within(meeting.surface[1], v)
}

/// All answers are where they say, within a distance.
fn truthful(
    surface: &dyn BoundedSurface<Point = P3>,
    curve: &dyn Fn(f64) -> P3,
    found: &[SurfaceMeeting<P3>],
    within: f64,
) {
    for meeting in found {
        let [u, v] = meeting.surface_at;
        assert!(distance(curve(meeting.at), meeting.point) < 1e-12, "{meeting:?}");
        let away = distance(surface.eval(u, v), meeting.point);
        assert!((meeting.distance - away).abs() < 1e-14 && away <= within, "{meeting:?}");
        assert!(holds(meeting, [meeting.at, u, v]), "{meeting:?}");
    }
    assert!(found.windows(2).all(|pair| pair[0].at <= pair[1].at), "{found:?}");
}

fn line(start: P3, along: P3) -> impl Fn(f64) -> P3 {
    move |t| [0, 1, 2].map(|d| start[d] + t * along[d])
}

#[test]
fn of_lines_and_a_sphere() {
    let (random, sphere) = (&mut Random::new(2301), sphere());
    let mut total = 0;
    for _ in 0..300 {
        let (start, along) = (random_point(random).map(|x| 2.0 * x), random_point(random));
        let dot = |a: P3, b: P3| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let (a, b, c) = (dot(along, along), dot(start, along), dot(start, start) - 1.0);
        let root = b * b - a * c;
        let expected =
            if root < 0.0 { vec![] } else { [-1.0, 1.0].map(|s| (s * root.sqrt() - b) / a).to_vec() };
        let found = sphere.line_intersections(start, along, 1e-9).unwrap();
        truthful(&sphere, &line(start, along), &found, 1e-9);
        assert_eq!(found.len(), expected.len(), "{start:?} {along:?} {found:?}");
        for (meeting, t) in found.iter().zip(&expected) {
            assert!((meeting.at - t).abs() < 1e-9 && meeting.kind == MeetingKind::Crossing, "{meeting:?}");
        }
        let ahead = sphere.ray_intersections(start, along, 1e-9).unwrap();
        assert_eq!(ahead.len(), expected.iter().filter(|t| **t > 0.0).count());
        total += found.len();
    }
    assert!(total > 100, "{total}");
}

/// Up to four points of a line, where a polynomial changes its sign.
#[test]
fn of_lines_and_a_torus() {
    let (random, torus) = (&mut Random::new(2302), torus());
    let height = |[x, y, z]: P3| (x.hypot(y) - 2.0).hypot(z) - 1.0;
    let mut counts = [0; 5];
    for _ in 0..200 {
        let (start, along) = (random_point(random).map(|x| 3.0 * x), random_point(random));
        let at = line(start, along);
        let far = 9.0 / distance(along, [0.0; 3]);
        let ts: Vec<f64> = (0..=4000).map(|k| far * (f64::from(k) / 2000.0 - 1.0)).collect();
        let heights: Vec<f64> = ts.iter().map(|&t| height(at(t))).collect();
        let expected: Vec<f64> =
            (1..ts.len()).filter(|&k| (heights[k] > 0.0) != (heights[k - 1] > 0.0)).map(|k| ts[k]).collect();
        let found = torus.line_intersections(start, along, 1e-9).unwrap();
        truthful(&torus, &at, &found, 1e-9);
        // Between two samples a line may go in and out.
        let grazes = heights.iter().any(|h| h.abs() < 1e-4);
        assert!(grazes || found.len() == expected.len(), "{start:?} {along:?} {found:?} {expected:?}");
        for &t in &expected {
            assert!(found.iter().any(|meeting| (meeting.at - t).abs() < far / 1000.0), "{t} {found:?}");
        }
        counts[expected.len().min(4)] += 1;
    }
    assert!(counts[0] > 9 && counts[2] > 9 && counts[4] > 0, "{counts:?}");
}

/// Curves through points of surfaces: that point is an answer, and all others are points of both.
#[test]
fn of_curves_through_a_point() {
    let random = &mut Random::new(2303);
    let spline = {
        let (u, v) =
            (KnotVector::uniform(2, 3).unwrap(), KnotVector::clamped(3, &[-1.0, 0.5, 0.5, 2.0]).unwrap());
        let net = Net::from_fn(u.functions(), v.functions(), |i, j| {
            let [x, y, z] = random_point(random);
            [i as f64 + 0.3 * x, j as f64 + 0.3 * y, z]
        });
        BSplineSurface::new(u, v, net.unwrap()).unwrap()
    };
    let profile = Bezier::from_points([[0.0, 1.0], [1.0, 2.5], [2.0, 0.5], [3.0, 1.0]]);
    let vase = SurfaceOfRevolution::about_x(&profile, 5.0).unwrap();
    let patches = vase.to_rational_patches();
    let rational = NurbsSurface::revolved(&nurbs(random), [0.0; 3], [0.0, 0.0, 1.0], 4.0).unwrap();
    let triangle = TriangularBezier::<P3, 4, 10>::from_points(core::array::from_fn(|_| random_point(random)));
    let surfaces: [&dyn BoundedSurface<Point = P3>; 5] = [&spline, &vase, &patches[0], &rational, &triangle];
    for round in 0..42 {
        let random_patch = bicubic(random);
        let surface =
            surfaces.get(round % 7).map_or(&random_patch as &dyn BoundedSurface<Point = P3>, |s| *s);
        let (u, v) = surface.domain().at(random.between(0.0, 1.0), random.between(0.0, 1.0));
        let t = random.between(0.0, 1.0);
        let (point, points) = (surface.eval(u, v), [(); 4].map(|()| random_point(random)));
        let from = Bezier::from_points(points).eval(t);
        let curve = Bezier::from_points(points.map(|p| [0, 1, 2].map(|d| p[d] + point[d] - from[d])));
        let found = curve.surface_intersections(surface, 1e-9).unwrap();
        truthful(surface, &|t| curve.eval(t), &found, 2e-9);
        assert!(found.iter().any(|meeting| holds(meeting, [t, u, v])), "{round} {t} {u} {v} {found:?}");
        // Away from all of them there is nothing more.
        for k in 0..=25 {
            let t = f64::from(k) / 25.0;
            let nearest = surface.nearest(curve.eval(t), 1e-3).unwrap();
            let beside = found.iter().any(|m| m.curve[0] <= t + 0.02 && m.curve[1] >= t - 0.02);
            assert!(nearest.distance > 1e-9 || beside, "{t} {nearest:?} {found:?}");
        }
    }
}

#[test]
fn through_edges_corners_seams_and_poles() {
    let (sphere, torus, square) = (sphere(), torus(), square());
    // Where four patches meet: once.
    let found = sphere.line_intersections([0.0, -3.0, 0.0], [0.0, 1.0, 0.0], 1e-9).unwrap();
    assert_eq!(found.iter().map(|m| m.at).collect::<Vec<_>>(), [2.0, 4.0]);
    // On the seam: each of both parameters.
    let found = torus.ray_intersections([2.0, 0.0, 0.5], [1.0, 0.0, -0.5], 1e-9).unwrap();
    assert!(found.len() == 2 && found.iter().all(|m| (m.at - 1.0).abs() < 1e-14), "{found:?}");
    let mut angles = [found[0].surface_at[1], found[1].surface_at[1]];
    angles.sort_by(f64::total_cmp);
    assert_eq!(angles, [0.0, 2.0 * PI]);
    // A pole has all angles.
    let found = sphere.line_intersections([0.0, 0.0, -3.0], [0.0, 0.0, 1.0], 1e-9).unwrap();
    assert_eq!(found.len(), 2, "{found:?}");
    for (meeting, t) in found.iter().zip([2.0, 4.0]) {
        assert!((meeting.at - t).abs() < 1e-9 && meeting.distance < 1e-9);
        assert_eq!(meeting.surface[1], [0.0, 2.0 * PI]);
    }
    // The border of a surface belongs to it.
    for [x, y] in [[0.0, 0.0], [1.0, 0.0], [0.3, 0.0], [1.0, 0.7], [0.6, 1.0]] {
        for along in [[0.0, 0.0, -1.0], [0.2, 0.1, -3.0], [-1.0, 2.0, -0.01]] {
            let start = line([x, y, 0.0], along)(-1.0);
            let [found] = square.ray_intersections(start, along, 1e-9).unwrap().try_into().unwrap();
            assert!((found.at - 1.0).abs() < 1e-12 && distance(found.point, [x, y, 0.0]) < 1e-12);
        }
    }
    let beyond = square.ray_intersections([0.5, -1e-6, 1.0], [0.0, 0.0, -1.0], 1e-9).unwrap();
    assert_eq!(beyond, []);
    // A ray that begins on the surface.
    assert_eq!(square.ray_intersections([0.5, 0.5, 0.0], [0.0, 0.3, 1.0], 1e-9).unwrap().len(), 1);
}

#[test]
fn tangents() {
    let (sphere, torus) = (sphere(), torus());
    let q = 1.0 / 3.0_f64.sqrt();
    for accuracy in [1e-4, 1e-6, 1e-9, 0.0] {
        for (start, along) in [
            ([0.0, 1.0, 0.0], [1.0, 0.0, 0.0]),
            ([0.0, 0.0, 1.0], [1.0, 0.3, 0.0]),
            ([q; 3], [1.0, -1.0, 0.0]),
        ] {
            let [touch] = sphere.line_intersections(start, along, accuracy).unwrap().try_into().unwrap();
            assert_eq!(touch.kind, MeetingKind::Contact, "{touch:?}");
            assert!(touch.curve[0] <= 1e-12 && touch.curve[1] >= -1e-12, "{touch:?}");
            let wide = 8.0 * f64::sqrt(accuracy.max(1e-13));
            assert!(touch.curve[1] - touch.curve[0] < wide && touch.distance < accuracy.max(1e-12));
            // A thousandth outside of it there is nothing; a millionth inside there are two.
            let moved = |by: f64| start.map(|x| x * (1.0 + by));
            assert_eq!(sphere.line_intersections(moved(1e-3), along, accuracy.min(1e-5)).unwrap(), []);
            if accuracy < 1e-7 {
                let two = sphere.line_intersections(moved(-1e-6), along, accuracy).unwrap();
                assert_eq!(two.len(), 2, "{two:?}");
                let half = 2e-6_f64.sqrt() / distance(along, [0.0; 3]);
                assert!((two[0].at + half).abs() < 1e-8 && (two[1].at - half).abs() < 1e-8, "{two:?}");
            }
        }
    }
    // The plane z = 1 touches the torus along a circle, which this line meets twice.
    let found = torus.line_intersections([0.0, 0.5, 1.0], [1.0, 0.0, 0.0], 1e-9).unwrap();
    let [before, after] = found.try_into().unwrap();
    let half = 3.75_f64.sqrt();
    assert!((before.at + half).abs() < 1e-6 && (after.at - half).abs() < 1e-6);
}

#[test]
fn along_surfaces() {
    let generatrix = Bezier::from_points([[-1.0_f64, 1.0], [1.0, 1.0]]);
    let cylinder = SurfaceOfRevolution::about_x(&generatrix, 6.0).unwrap();
    let [ruling] =
        cylinder.ray_intersections([-5.0, 0.6, 0.8], [1.0, 0.0, 0.0], 1e-9).unwrap().try_into().unwrap();
    assert_eq!(ruling.kind, MeetingKind::Overlap);
    assert!((ruling.curve[0] - 4.0).abs() < 2e-9 && (ruling.curve[1] - 6.0).abs() < 2e-9, "{ruling:?}");
    assert_eq!(ruling.surface[0], [0.0, 1.0]);
    let square = square();
    // Across the square, along its border, and past its corner.
    for (start, along, ends) in [
        ([-1.0, -0.9, 0.0], [1.0, 1.0, 0.0], [1.0, 1.9]),
        ([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 2.0]),
        ([-1.0, 0.4, 1e-10], [1.0, 0.1, 0.0], [1.0, 2.0]),
    ] {
        let [overlap] = square.ray_intersections(start, along, 1e-9).unwrap().try_into().unwrap();
        assert_eq!(overlap.kind, MeetingKind::Overlap);
        assert!((0..2).all(|k| (overlap.curve[k] - ends[k]).abs() < 3e-9), "{overlap:?}");
    }
    let [corner] =
        square.ray_intersections([-1.0, 1.0, 0.0], [1.0, -1.0, 0.0], 1e-9).unwrap().try_into().unwrap();
    assert!(corner.kind == MeetingKind::Contact && (corner.at - 1.0).abs() < 1e-8, "{corner:?}");
    // Curves in surfaces, one of them beyond its border.
    let saddle = bilinear([[0.0; 3], [0.0, 1.0, 1.0], [1.0, 0.0, 1.0], [1.0, 1.0, 0.0]]);
    let diagonal = Bezier::from_points([[0.0; 3], [0.5, 0.5, 1.0], [1.0, 1.0, 0.0]]);
    let longer = diagonal.subsegment(0.25..1.0).unwrap();
    for accuracy in [1e-3, 1e-5] {
        let random = &mut Random::new(2304);
        let patch = bicubic(random);
        let isocurve = patch.along_u(0.37);
        let cases: [(&dyn ParametricCurve<Point = P3>, &dyn BoundedSurface<Point = P3>); 3] =
            [(&diagonal, &saddle), (&longer, &saddle), (&isocurve, &patch)];
        for (curve, surface) in cases {
            let found = curve.surface_intersections(surface, accuracy).unwrap();
            let [lo, hi] = curve.domain();
            assert!(found.iter().any(|m| m.kind == MeetingKind::Overlap && m.curve == [lo, hi]), "{found:?}");
            assert!(found.iter().all(|m| m.distance < 3.0 * accuracy));
        }
    }
}

#[test]
fn of_degenerate_surfaces() {
    let start = [-1.0, 0.0, 0.0];
    let point = bilinear([[0.5, 0.0, 0.0]; 4]);
    let [touch] = point.ray_intersections(start, [1.0, 0.0, 0.0], 1e-9).unwrap().try_into().unwrap();
    assert!(touch.kind == MeetingKind::Contact && (touch.at - 1.5).abs() < 1e-8, "{touch:?}");
    assert_eq!(point.ray_intersections([-1.0, 0.1, 0.0], [1.0, 0.0, 0.0], 1e-9), Some(vec![]));
    let segment = bilinear([[0.0; 3], [0.0; 3], [1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]);
    let across = segment.ray_intersections([0.3, -1.0, 0.0], [0.0, 1.0, 0.0], 1e-9).unwrap();
    let [across] = across.try_into().unwrap();
    assert!((across.at - 1.0).abs() < 1e-8 && (across.surface_at[0] - 0.3).abs() < 1e-8, "{across:?}");
    let [along] = segment.ray_intersections(start, [1.0, 0.0, 0.0], 1e-3).unwrap().try_into().unwrap();
    assert!(along.kind == MeetingKind::Overlap && along.curve[0] <= 1.0 && along.curve[1] >= 2.0);
    // The apex of a cone, and its axis.
    let cone = SurfaceOfRevolution::about_x(&Bezier::from_points([[0.0, 0.0], [1.0, 1.0]]), 6.0).unwrap();
    for along in [[1.0, 0.0, 0.0], [0.3, 1.0, 0.0], [0.0, 1.0, -0.3]] {
        let start = line([0.0; 3], along)(-1.0);
        let [apex] = cone.ray_intersections(start, along, 1e-9).unwrap().try_into().unwrap();
        assert!((apex.at - 1.0).abs() < 1e-8 && apex.distance < 1e-9, "{along:?} {apex:?}");
    }
    // A curve that is a point.
    let stays = Bezier::from_points([[0.25, 0.5, 0.0]; 3]);
    let found = stays.surface_intersections(&square(), 1e-9).unwrap();
    assert!(found.len() == 1 && distance(found[0].point, [0.25, 0.5, 0.0]) == 0.0, "{found:?}");
}

/// A curve in a plane that meets the surface along one of its own isocurves: one parameter is known at once.
#[test]
fn of_a_curve_across_an_isocurve() {
    let cone = SurfaceOfRevolution::about_x(&Bezier::from_points([[0.0, 0.0], [2.0, 2.0]]), 6.0).unwrap();
    let arch = Bezier::from_points([[1.0, -2.0, 0.0], [1.0, 0.0, 1.0], [1.0, 2.0, 0.0]]);
    let found = arch.surface_intersections(&cone, 1e-9).unwrap();
    truthful(&cone, &|t| arch.eval(t), &found, 1e-14);
    assert_eq!(found.iter().map(|m| m.kind).collect::<Vec<_>>(), [MeetingKind::Crossing; 2]);
    assert!(found.iter().all(|m| (m.surface_at[0] - 0.5).abs() < 1e-14));
}

/// Nets of small integers and places between them: most that can coincide does.
#[test]
fn of_integers() {
    let random = &mut Random::new(2305);
    for _ in 0..120 {
        let mut integer = || [(); 3].map(|()| random.below(3) as f64 - 1.0);
        let net = [(); 3].map(|()| [(); 3].map(|()| integer()));
        let points = [(); 3].map(|()| integer());
        let surface = TensorSurface::new(BernsteinBasis::<f64, 3>::new(), BernsteinBasis::new(), net);
        let [t, u, v] = [(); 3].map(|()| random.below(5) as f64 / 4.0);
        let (point, from) = (surface.eval(u, v), Bezier::from_points(points).eval(t));
        let curve = Bezier::from_points(points.map(|p| [0, 1, 2].map(|d| p[d] + point[d] - from[d])));
        let found = curve.surface_intersections(&surface, 1e-4).unwrap();
        assert!(found.iter().any(|m| holds(m, [t, u, v])), "{net:?} {points:?} {t} {u} {v} {found:?}");
        truthful(&surface, &|t| curve.eval(t), &found, 1e-3);
    }
}

#[test]
fn of_hostile_sizes() {
    for size in [1e-300, 1e-9, 1e9, 1e150, 1e300] {
        let patch = bilinear([[0.0; 3], [0.0, size, 0.0], [size, 0.0, 0.0], [size; 3]]);
        let start = [0.3 * size, 0.4 * size, -size];
        let [found] = patch.ray_intersections(start, [0.0, 0.0, size], 0.0).unwrap().try_into().unwrap();
        assert!((found.at - 1.12).abs() < 1e-14 && distance(found.surface_at, [0.3, 0.4]) < 1e-14);
    }
    let square = square();
    let [far] =
        square.ray_intersections([0.3, 0.3, 1e8], [0.0, 0.0, -1.0], 1e-9).unwrap().try_into().unwrap();
    assert_eq!(far.at, 1e8);
    assert_eq!(square.ray_intersections([0.0; 3], [0.0; 3], 1e-9), None);
    for bad in [f64::NAN, f64::INFINITY] {
        assert_eq!(square.ray_intersections([bad, 0.0, 0.0], [1.0, 0.0, 0.0], 1e-9), None);
        assert_eq!(square.line_intersections([0.0; 3], [1.0, bad, 0.0], 1e-9), None);
        let broken = bilinear([[0.0; 3], [0.0, bad, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]]);
        assert_eq!(broken.ray_intersections([0.0; 3], [1.0, 0.0, 0.0], 1e-9), None);
    }
    for accuracy in [f64::INFINITY, f64::NAN, -1.0] {
        assert_eq!(square.ray_intersections([0.3, 0.3, 1.0], [0.0, 0.0, -1.0], accuracy).unwrap().len(), 1);
    }
    // In single precision.
    let profile = Bezier::from_points([[0.0_f32, 1.0], [1.0, 2.5], [2.0, 0.5], [3.0, 1.0]]);
    let vase = SurfaceOfRevolution::about_x(&profile, 6.0).unwrap();
    let found = vase.line_intersections([1.0, -5.0, 0.3], [0.0, 1.0, 0.0], 1e-4).unwrap();
    assert!(found.len() == 2 && found.iter().all(|m| m.distance < 1e-5), "{found:?}");
}

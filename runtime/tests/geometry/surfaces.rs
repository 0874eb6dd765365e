//! Surfaces of every type answer boxes, nearest points and partial derivatives, and are meshed.

use core::f64::consts::PI;

use basis_runtime::bspline::{BSplineSurface, KnotVector, Net, NurbsSurface};
use basis_runtime::{
    Bezier, BoundedSurface, CurveError, Direction, Edge, Isocurve, ParametricCurve, Surface, SurfaceDomain,
    SurfaceOfRevolution, SurfacePiece, Tessellation,
};

use crate::queries::{distance, nurbs};
use crate::random::Random;

type P3 = [f64; 3];

fn spline(random: &mut Random) -> BSplineSurface<P3> {
    let (u, v) =
        (KnotVector::uniform(2, 3).unwrap(), KnotVector::clamped(3, &[-1.0, 0.5, 0.5, 2.0]).unwrap());
    let net = Net::from_fn(u.functions(), v.functions(), |i, j| {
        let [x, y, z]: P3 = [random.between(0.0, 0.5), random.between(0.0, 0.5), random.between(-1.0, 1.0)];
        [i as f64 + x, j as f64 + y, z]
    });
    BSplineSurface::new(u, v, net.unwrap()).unwrap()
}

pub(crate) fn against_samples(surface: &dyn BoundedSurface<Point = P3>, random: &mut Random) {
    const COUNT: usize = 121;
    let domain = surface.domain();
    let [[u0, u1], _] = domain.ranges();
    let at = |n: usize| {
        let [x, y] = [n / COUNT, n % COUNT].map(|k| k as f64 / (COUNT - 1) as f64);
        domain.at(x, y)
    };
    let points: Vec<P3> = (0..COUNT * COUNT).map(at).map(|(u, v)| surface.eval(u, v)).collect();
    let ([low, high], [far_low, far_high]) = (surface.bounding_box(), surface.control_box());
    for d in 0..3 {
        let least = points.iter().map(|p| p[d]).fold(f64::MAX, f64::min);
        let largest = points.iter().map(|p| p[d]).fold(f64::MIN, f64::max);
        assert!(low[d] <= least + 1e-13 && low[d] > least - 2e-2, "{low:?} {least}");
        assert!(high[d] >= largest - 1e-13 && high[d] < largest + 2e-2, "{high:?} {largest}");
        assert!(far_low[d] <= low[d] + 1e-12 && far_high[d] >= high[d] - 1e-12);
    }
    for _ in 0..4 {
        let target = [(); 3].map(|()| random.between(-1.0, 4.0));
        let found = surface.nearest(target, 1e-7).unwrap();
        let sampled = points.iter().map(|&p| distance(p, target)).fold(f64::MAX, f64::min);
        assert!(found.distance <= sampled + 1e-7 && found.at_least <= sampled, "{found:?} {sampled}");
        assert!(found.distance - found.at_least <= 1.01e-7, "{found:?}");
        let [u, v] = found.at;
        assert!(domain.contains(u, v) && distance(surface.eval(u, v), found.point) < 1e-13);
    }
    assert_eq!(surface.nearest([f64::NAN; 3], 1e-6), None);
    // Partial derivatives one by one, and all at once.
    let (u, v) = at(4_321);
    let mut partials = [[0.0; 3]; 16];
    surface.partials_into(u, v, 4, &mut partials).unwrap();
    for (n, &partial) in partials.iter().enumerate() {
        let [i, j] = [n / 4, n % 4];
        assert!(
            distance(surface.partial(u, v, [i, j]), partial) < 1e-9 * (1.0 + distance(partial, [0.0; 3]))
        );
        if i > 0 && i + j <= 3 {
            let h = 1e-5 * (u1 - u0);
            let [a, b] = [u - h, u + h].map(|u| surface.partial(u, v, [i - 1, j]));
            let difference = [0, 1, 2].map(|d| (b[d] - a[d]) / (2.0 * h));
            let size = 1.0 + distance(partial, [0.0; 3]);
            assert!(distance(difference, partial) < 1e-3 * size, "{i} {j}: {difference:?} {partial:?}");
        }
    }
    assert!(surface.partial(u, v, [0, 9]).iter().all(|c| c.is_finite()));
}

/// A curve with a constant parameter, and its parts, are on the surface at the parameters that they say.
pub(crate) fn isocurves(surface: &dyn BoundedSurface<Point = P3>, random: &mut Random) {
    let ranges = surface.domain().ranges();
    for (direction, across) in [(Direction::U, 0), (Direction::V, 1)] {
        let [a, b] = ranges[across];
        let at = random.between(a, b);
        let [lo, hi] = surface.domain().range(direction, at);
        let curve = Isocurve::new(surface, direction, at);
        assert_eq!(curve.domain(), [lo, hi]);
        let middle = random.between(lo, hi);
        let [before, after] = curve.split(middle).unwrap();
        let backwards = curve.subsegment(hi..middle).unwrap();
        assert_eq!((backwards.domain(), backwards.reversed().domain()), ([middle, hi], [middle, hi]));
        let whole = curve.arclen(1e-9);
        assert!((before.arclen(1e-9) + backwards.arclen(1e-9) - whole).abs() < 4e-9);
        assert!((after.arclen(1e-9) - backwards.arclen(1e-9)).abs() < 3e-9);
        for _ in 0..8 {
            let t = random.between(lo, hi);
            let place = |t: f64| if direction == Direction::U { (at, t) } else { (t, at) };
            let (u, v) = place(t);
            assert_eq!((curve.eval(t), curve.surface_parameters(t)), (surface.eval(u, v), (u, v)));
            let orders = |n: usize| if direction == Direction::U { [0, n] } else { [n, 0] };
            assert_eq!(curve.derivative(t, 2), surface.partial(u, v, orders(2)));
            // From the pieces: the parameter of a point, of parts that run backwards too.
            let found = curve.nearest(surface.eval(u, v), 1e-9).unwrap();
            assert!(found.distance < 1e-7, "{found:?}");
            let length = curve.subsegment(lo..t).unwrap().arclen(1e-10);
            assert!((curve.inv_arclen(length, 1e-10) - t).abs() < 1e-7 * (hi - lo), "{direction:?} {t}");
            let s = random.between(middle, hi);
            let (u, v) = backwards.surface_parameters(s);
            assert!(distance(backwards.eval(s), surface.eval(u, v)) < 1e-14);
            let other = backwards.nearest(backwards.eval(s), 1e-9).unwrap();
            assert!(distance(backwards.eval(other.at), backwards.eval(s)) < 1e-7, "{other:?} {s}");
            let mirrored = middle + hi - s;
            let turned = backwards.derivative(s, 1);
            let along = curve.derivative(mirrored, 1);
            assert!([0, 1, 2].iter().all(|&d| (turned[d] + along[d]).abs() < 1e-12 * (1.0 + along[d].abs())));
        }
    }
}

#[test]
fn derivatives_of_isocurves_where_they_jump() {
    // A ridge at u = 1, of a spline with a double knot.
    let (u, v) =
        (KnotVector::clamped(1, &[0.0, 1.0, 2.0]).unwrap(), KnotVector::clamped(1, &[0.0, 1.0]).unwrap());
    let net = Net::from_fn(3, 2, |i, j| [i as f64, j as f64, [0.0, 1.0, 0.0][i]]).unwrap();
    let roof = BSplineSurface::new(u, v, net).unwrap();
    let ridge = Isocurve::new(&roof, Direction::V, 0.5);
    assert_eq!(ridge.derivative(1.0, 1), [1.0, 0.0, -1.0]);
    assert_eq!(ridge.reversed().derivative(1.0, 1), [-1.0, 0.0, -1.0]);
    assert_eq!(ridge.subsegment(0.5..1.0).unwrap().derivative(1.0, 1), [1.0, 0.0, 1.0]);
    assert_eq!(ridge.subsegment(1.0..0.5).unwrap().derivative(1.0, 1), [-1.0, 0.0, -1.0]);
    assert_eq!(ridge.subsegment(1.0..2.0).unwrap().reversed().derivative(2.0, 1), [-1.0, 0.0, 1.0]);
}

#[test]
fn boundaries_are_the_ends_of_the_domain() {
    let random = &mut Random::new(1807);
    let profile = Bezier::from_points([[0.0, 1.0], [1.0, 2.5], [2.0, 0.5], [3.0, 1.0]]);
    let vase = SurfaceOfRevolution::about_x(&profile, 5.0).unwrap();
    let surface = spline(random);
    for edge in Edge::ALL {
        let (u, v) = vase.domain().on_edge(edge, 0.25);
        let curve = vase.boundary(edge);
        assert_eq!(curve.eval(if edge.runs_along_u() { u } else { v }), vase.eval(u, v));
        let (mine, general) = (surface.boundary(edge), BoundedSurface::boundary(&surface, edge));
        assert_eq!(mine.domain(), general.domain());
        for point in general.samples(9) {
            assert!(mine.nearest(point, 1e-9).unwrap().distance < 1e-8);
        }
    }
}

/// The area by the rectangle rule on a fine grid.
pub(crate) fn summed_area(surface: &dyn BoundedSurface<Point = P3>) -> f64 {
    const COUNT: usize = 400;
    let [u, v] = surface.domain().ranges().map(|[lo, hi]| hi - lo);
    let mut sum = 0.0;
    for n in 0..COUNT * COUNT {
        let [x, y] = [n / COUNT, n % COUNT].map(|k| (k as f64 + 0.5) / COUNT as f64);
        let size = if surface.domain() == SurfaceDomain::Triangle { 1.0 - x } else { u * v };
        let (u, v) = surface.domain().at(x, y);
        let [a, b] = [surface.partial(u, v, [1, 0]), surface.partial(u, v, [0, 1])];
        let cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        sum += size * distance(cross, [0.0; 3]);
    }
    sum / (COUNT * COUNT) as f64
}

#[test]
fn areas() {
    let random = &mut Random::new(1808);
    let profile = Bezier::from_points([[0.0, 1.0], [1.0, 2.5], [2.0, 0.5], [3.0, 1.0]]);
    let vase = SurfaceOfRevolution::about_x(&profile, 5.0).unwrap();
    let rational = NurbsSurface::revolved(&nurbs(random), [0.0; 3], [0.0, 0.0, 1.0], 4.0).unwrap();
    let polynomial = spline(random);
    let surfaces: [&dyn BoundedSurface<Point = P3>; 3] = [&vase, &rational, &polynomial];
    for surface in surfaces {
        let [rough, fine] = [1e-3, 1e-8].map(|accuracy| surface.area(accuracy).unwrap());
        assert!(rough.error <= 1e-3 && fine.error <= 1e-8, "{rough:?} {fine:?}");
        assert!((rough.value - fine.value).abs() <= rough.error + fine.error);
        let sum = summed_area(surface);
        assert!((sum - fine.value).abs() < 1e-3 * sum, "{fine:?} {sum}");
    }
}

#[test]
fn areas_that_are_known() {
    // A sphere with two poles, as a surface of revolution and as NURBS, of different sizes.
    let half = 0.5_f64.sqrt();
    for radius in [1e-150, 1.0, 1e150] {
        let points = [[0.0, -1.0], [1.0, -1.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let points = points.map(|[x, z]| [x * radius, 0.0, z * radius]);
        let knots = KnotVector::clamped(2, &[0.0, 1.0, 1.0, 2.0]).unwrap();
        let arc =
            basis_runtime::bspline::NurbsCurve::new(knots, points, [1.0, half, 1.0, half, 1.0]).unwrap();
        let sphere = NurbsSurface::revolved(&arc, [0.0; 3], [0.0, 0.0, 1.0], 2.0 * PI).unwrap();
        for accuracy in [1e-2, 1e-6, 1e-9] {
            let area = sphere.area(accuracy * radius * radius).unwrap();
            let exact = 4.0 * PI * radius * radius;
            assert!((area.value - exact).abs() <= area.error + 1e-13 * exact, "{area:?} {exact}");
            assert!(area.error <= accuracy * radius * radius, "{area:?}");
        }
    }
    // In the plane, folded once: twice the area of 1/2 · 2 that is below the fold.
    let point = |x: f64, y: f64| [x, y];
    let folded = [
        [point(0.0, 0.0), point(0.0, 1.0)],
        [point(2.0, 0.0), point(2.0, 1.0)],
        [point(0.0, 0.0), point(0.0, 1.0)],
    ];
    let folded = BSplineSurface::from_bezier(Net::from_rows(folded).unwrap()).unwrap();
    let area = folded.area(1e-6).unwrap();
    assert!((area.value - 2.0).abs() <= area.error && area.error <= 1e-6, "{area:?}");
    let point = BSplineSurface::from_bezier(Net::from_fn(3, 3, |_, _| [1.0, 2.0, 3.0]).unwrap()).unwrap();
    assert_eq!(point.area(1e-9).map(|area| (area.value, area.error)), Some((0.0, 0.0)));
    let bad = BSplineSurface::from_bezier(Net::from_fn(2, 2, |_, _| [f64::NAN; 3]).unwrap()).unwrap();
    assert_eq!(bad.area(1e-9), None);
    let line = BSplineSurface::from_bezier(Net::from_fn(3, 3, |i, j| (i * j) as f64).unwrap()).unwrap();
    assert_eq!(line.area(1e-9).unwrap().value, 0.0);
}

#[test]
fn of_every_type() {
    let random = &mut Random::new(1801);
    let polynomial = spline(random);
    let rational = NurbsSurface::revolved(&nurbs(random), [0.0; 3], [0.0, 0.0, 1.0], 4.0).unwrap();
    let profile = Bezier::from_points([[0.0, 1.0], [1.0, 2.5], [2.0, 0.5], [3.0, 1.0]]);
    let vase = SurfaceOfRevolution::about_x(&profile, 5.0).unwrap();
    let patches = vase.to_rational_patches();
    let surfaces: [&dyn BoundedSurface<Point = P3>; 4] = [&polynomial, &rational, &vase, &patches[1]];
    for surface in surfaces {
        against_samples(surface, random);
        isocurves(surface, random);
    }
}

/// A torus: the distance from any point is known.
#[test]
fn of_a_torus() {
    let half = 0.5_f64.sqrt();
    let points = [[3.0, 0.0, 0.0], [3.0, 0.0, 1.0], [2.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 0.0, 0.0]];
    let knots = KnotVector::clamped(2, &[0.0, 1.0, 1.0, 2.0]).unwrap();
    let arc = basis_runtime::bspline::NurbsCurve::new(knots, points, [1.0, half, 1.0, half, 1.0]).unwrap();
    let upper = NurbsSurface::revolved(&arc, [0.0; 3], [0.0, 0.0, 1.0], 2.0 * PI).unwrap();
    let random = &mut Random::new(1802);
    for _ in 0..10 {
        let [x, y, z]: P3 = [random.between(-4.0, 4.0), random.between(-4.0, 4.0), random.between(0.1, 3.0)];
        let found = upper.nearest([x, y, z], 1e-9).unwrap();
        let exact = ((x.hypot(y) - 2.0).hypot(z) - 1.0).abs();
        assert!(
            (found.distance - exact).abs() < 1e-9 && found.at_least <= exact + 1e-12,
            "{found:?} {exact}"
        );
    }
    let [low, high] = upper.bounding_box();
    assert!(distance(low, [-3.0, -3.0, 0.0]) < 1e-2 && distance(high, [3.0, 3.0, 1.0]) < 1e-2);
    let mesh = Tessellation::new(0.05).unwrap().with(&upper).mesh().unwrap();
    let area = 2.0 * PI * PI * 2.0;
    assert!((mesh.area() - area).abs() < 0.05 * area && mesh.is_oriented(), "{} {area}", mesh.area());
}

#[test]
fn pieces_of_a_type_of_ones_own() {
    let square = [[0.0, 0.0], [1.0, 1.0]];
    let points = [[0.0; 3], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]];
    let piece = SurfacePiece::polynomial([[0.0, 1.0]; 2], 2, &points).unwrap();
    assert_eq!((piece.degrees(), piece.domain()), ([1, 1], [[0.0, 1.0]; 2]));
    assert!(matches!(SurfacePiece::polynomial(square, 3, &points), Err(CurveError::Length { .. })));
    assert!(matches!(SurfacePiece::polynomial(square, 0, &points), Err(CurveError::Length { .. })));
    assert!(matches!(SurfacePiece::rational(square, 2, &points, &[1.0; 3]), Err(CurveError::Length { .. })));
    let bad = SurfacePiece::rational(square, 2, &points, &[1.0, 1.0, 0.0, 1.0]);
    assert!(matches!(bad, Err(CurveError::Weight { index: 2, .. })));
}

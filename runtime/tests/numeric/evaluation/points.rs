//! Every type of point gives the same curve.

use basis_runtime::{Bezier, Curve, Point, Scalar};

use crate::families::QuarticBernstein;

/// Points of small whole components, so that the curve at t = 1/4 is exact in every type.
fn net<P: Point>() -> [P; 4] {
    core::array::from_fn(|k| P::from_components(|i| P::Scalar::from_usize(k * k + i * k)))
}

fn is_a_point<P: Point>(dim: usize) {
    assert_eq!(P::DIM, dim);
    let point = P::from_components(|i| P::Scalar::from_usize(i + 1));
    for i in 0..dim {
        let (component, two) = (P::Scalar::from_usize(i + 1), P::Scalar::of(2.0));
        assert_eq!(point.component(i), component);
        assert_eq!(P::zero().component(i), P::Scalar::ZERO);
        assert_eq!(point.scale(two).component(i), component * two);
        assert_eq!(point.minus(point.scale(two)).component(i), -component);
        assert_eq!(point.add_weighted(point, two).component(i), component * P::Scalar::of(3.0));
    }
    let curve = Curve::new(QuarticBernstein::new(P::Scalar::of(0.5)).unwrap(), net::<P>());
    let along = Curve::new(QuarticBernstein::new(0.5).unwrap(), net::<[f64; 4]>());
    let t = 0.25;
    let points = curve.eval_with_derivs::<3>(P::Scalar::of(t));
    for (point, expected) in points.iter().zip(along.eval_with_derivs::<3>(t)) {
        for (i, expected) in expected.into_iter().enumerate().take(dim) {
            assert_eq!(point.component(i).to_f64(), expected);
        }
    }
}

#[test]
fn scalars_and_arrays() {
    is_a_point::<f32>(1);
    is_a_point::<f64>(1);
    is_a_point::<[f32; 3]>(3);
    is_a_point::<[f64; 1]>(1);
    is_a_point::<[f64; 4]>(4);
    assert_eq!(<[f64; 0]>::zero(), [0.0; 0]);
}

#[test]
#[cfg(feature = "glam")]
fn glam_vectors() {
    is_a_point::<glam::Vec2>(2);
    is_a_point::<glam::Vec3>(3);
    is_a_point::<glam::Vec3A>(3);
    is_a_point::<glam::Vec4>(4);
    is_a_point::<glam::DVec2>(2);
    is_a_point::<glam::DVec3>(3);
    is_a_point::<glam::DVec4>(4);

    let [p0, p1, p2, p3] = net::<glam::Vec3>();
    let curve = Curve::new(QuarticBernstein::new(-2.0).unwrap(), [p0, p1, p2, p3]);
    assert_eq!(curve.eval(1.0), p3);
}

/// Other versions of glam, those of Bevy among them; several at once.
macro_rules! versions_of_glam {
    ($($feature:literal $glam:ident;)+) => {$(
        #[test]
        #[cfg(feature = $feature)]
        fn $glam() {
            use $glam::{DVec2, DVec3, DVec4, Vec2, Vec3, Vec3A, Vec4};

            is_a_point::<Vec2>(2);
            is_a_point::<Vec3>(3);
            is_a_point::<Vec3A>(3);
            is_a_point::<Vec4>(4);
            is_a_point::<DVec2>(2);
            is_a_point::<DVec3>(3);
            is_a_point::<DVec4>(4);
            normals_are_vectors::<Vec3>();
        }
    )+};
}
versions_of_glam! {
    "glam_030" glam_030;
    "glam_032" glam_032;
    "glam_033" glam_033;
}

#[test]
#[cfg(feature = "mint")]
fn mint_vectors_and_points() {
    is_a_point::<mint::Point2<f32>>(2);
    is_a_point::<mint::Point3<f64>>(3);
    is_a_point::<mint::Vector2<f64>>(2);
    is_a_point::<mint::Vector3<f32>>(3);
    is_a_point::<mint::Vector4<f32>>(4);
    normals_are_vectors::<mint::Point3<f32>>();
    let normal: mint::Vector3<f64> = normals_are_vectors::<mint::Point3<f64>>();
    assert_eq!([normal.x, normal.y, normal.z], [0.0, 0.0, 1.0]);
}

/// The normal of the plane of x and y.
#[cfg(any(feature = "glam_030", feature = "glam_032", feature = "glam_033", feature = "mint"))]
fn normals_are_vectors<P: basis_runtime::Point3>() -> P::Vector {
    use basis_runtime::{BernsteinBasis, Surface, TensorSurface};

    let linear = BernsteinBasis::<P::Scalar, 2>::new();
    let corner = |i: usize, j: usize| P::from_components(|c| P::Scalar::from_usize([i, j, 0][c]));
    let plane =
        TensorSurface::new(linear, linear, [[corner(0, 0), corner(0, 1)], [corner(1, 0), corner(1, 1)]]);
    let half = P::Scalar::of(0.5);
    let normal = plane.normal(half, half).unwrap();
    assert_eq!(normal.component(2), P::Scalar::ONE);
    normal
}

#[test]
#[cfg(feature = "nalgebra")]
fn nalgebra_vectors_and_points() {
    is_a_point::<nalgebra::Vector2<f32>>(2);
    is_a_point::<nalgebra::Vector3<f64>>(3);
    is_a_point::<nalgebra::Point3<f64>>(3);
    is_a_point::<nalgebra::Point2<f32>>(2);

    let [p0, p1, p2, p3] = net::<nalgebra::Point3<f64>>();
    let curve = Curve::new(QuarticBernstein::new(-2.0).unwrap(), [p0, p1, p2, p3]);
    assert_eq!(curve.eval(1.0), p3);
}

/// Where points and vectors are two types, directions are vectors, and the same as those of arrays.
#[test]
#[cfg(all(feature = "nalgebra", feature = "bspline"))]
fn directions_of_points_are_vectors() {
    use basis_runtime::bspline::{BSplineCurve, BSplineSurface};
    use basis_runtime::{
        Bezier, BoundedSurface, Frame, ParametricCurve, RevolutionError, Surface, SurfaceOfRevolution,
    };
    use nalgebra::{Point3, Rotation3, Vector3};

    let arrays = Bezier::from_points([[0.0, 1.0, 0.0], [1.0, 2.0, 0.5], [3.0, 1.0, -1.0], [4.0, 3.0, 2.0]]);
    let curve = arrays.map(Point3::from);
    let tangent: Vector3<f64> = curve.tangent(0.3).unwrap();
    assert_eq!(tangent, Vector3::from(arrays.tangent(0.3).unwrap()));
    let frame: Frame<Point3<f64>> = curve.frenet_frame(0.3).unwrap();
    let expected = arrays.frenet_frame(0.3).unwrap();
    assert_eq!((frame.point, frame.normal), (expected.point.into(), expected.normal.into()));
    let first: Frame<Point3<f64>> = curve.rotation_minimizing_frames(3, Some(Vector3::z())).unwrap()[0];
    assert!(first.normal.dot(&first.tangent).abs() < 1e-15);
    let found = curve.plane_intersections(Point3::new(2.0, 0.0, 0.0), Vector3::x()).unwrap();
    assert!((found[0].point.x - 2.0).abs() < 1e-14);

    let axis = Vector3::new(0.0, 0.0, 2.0);
    let vase = SurfaceOfRevolution::new(&curve, Point3::new(-1.0, 0.0, 0.0), axis, 2.0).unwrap();
    assert_eq!(vase.axis(), (Point3::new(-1.0, 0.0, 0.0), axis));
    let normal: Vector3<f64> = vase.normal(0.4, 0.5).unwrap();
    let bend = vase.curvature(0.4, 0.5).unwrap();
    assert!((bend.normal - normal).norm() < 1e-15 && bend.directions[0].dot(&normal).abs() < 1e-15);
    let (start, along) = (vase.eval(0.4, 0.5) + normal, -normal);
    let ahead = vase.ray_intersections(start, along, 1e-9).unwrap();
    assert!(ahead.iter().any(|meeting| (meeting.at - 1.0).abs() < 1e-9));
    let spline = BSplineCurve::from_bezier(curve.control_points()).unwrap();
    let wall = BSplineSurface::extruded(&spline, Vector3::z()).unwrap();
    assert!((wall.eval(1.0, 1.0) - (curve.end() + Vector3::z())).norm() < 1e-15);

    // The image of a surface of revolution is one about the image of its axis; also in a mirror.
    let turn = Rotation3::from_axis_angle(&Vector3::y_axis(), 0.7);
    for mirror in [1.0, -1.0] {
        let image = |p: Point3<f64>| turn * Point3::new(p.x * 3.0, p.y * 3.0 * mirror, p.z * 3.0 + 1.0);
        let moved = vase.map(image).unwrap();
        for (u, v) in [(0.0, 0.0), (0.3, 1.1), (1.0, 2.0)] {
            assert!((moved.eval(u, v) - image(vase.eval(u, v))).norm() < 1e-13);
        }
    }
    let squeezed = vase.map(|p| Point3::new(p.x, p.y, p.z * 1.001));
    assert_eq!(squeezed.unwrap_err(), RevolutionError::NoSimilarity);
    let slanted = vase.map(|p| Point3::new(p.x + 1e-3 * p.z, p.y, p.z));
    assert_eq!(slanted.unwrap_err(), RevolutionError::NoSimilarity);
}

/// So are differences, derivatives and partial derivatives, on every way to them.
#[test]
#[cfg(all(feature = "nalgebra", feature = "bspline"))]
fn derivatives_of_points_are_vectors() {
    use basis_runtime::bspline::{BSplineCurve, BSplineSurface, Net, NurbsCurve, NurbsSurface};
    use basis_runtime::{
        AnyCurve, Bezier, ParametricCurve, Path, PiecewiseCurve, RationalBezier, RationalSurface, Surface,
        SurfaceOfRevolution, TensorSurface, TriangularBezier,
    };
    use nalgebra::{Point3, Vector3};

    type P = Point3<f64>;
    type V = Vector3<f64>;

    let (a, b) = (Point3::new(1.0, 2.0, 3.0), Point3::new(0.5, 0.0, -1.0));
    let difference: V = Point::minus(a, b);
    assert_eq!((difference, b.add_scaled(difference, 1.0)), (a - b, a));
    assert_eq!((a.to_vector(), P::from_vector(a.coords)), (a.coords, a));

    let points = [[0.0, 1.0, 0.0], [1.0, 2.0, 0.5], [3.0, 1.0, -1.0], [4.0, 3.0, 2.0]];
    let arrays = Bezier::from_points(points);
    let curve = arrays.map(Point3::from);
    let [place, velocity]: [V; 2] = curve.eval_with_derivs(0.3);
    assert_eq!(P::from_vector(place), curve.eval(0.3));
    assert!((velocity - V::from(arrays.derivative(0.3, 1))).norm() < 1e-14);
    let mut velocities = [V::zeros(); 3];
    let mut places = velocities;
    curve.eval_with_derivs_into(&[0.1, 0.3, 0.8], [&mut places, &mut velocities]).unwrap();
    assert!((velocities[1] - velocity).norm() < 1e-14 && (places[1] - place).norm() < 1e-14);

    let spline = BSplineCurve::from_bezier(curve.control_points()).unwrap();
    let weights = [1.0, 2.0, 0.5, 1.0];
    let rational = RationalBezier::new(curve.control_points(), weights).unwrap();
    let (nurbs, path) = (NurbsCurve::from(spline.clone()), Path::from_curve(&rational));
    let pieces = PiecewiseCurve::new(vec![AnyCurve::new(curve), AnyCurve::new(rational.clone())]).unwrap();
    let curves: [&dyn ParametricCurve<Point = P>; 6] = [&curve, &spline, &nurbs, &rational, &path, &pieces];
    for curve in curves {
        let (h, mut found) = (1e-6, [V::zeros(); 3]);
        curve.derivatives_into(0.3, &mut found);
        let step: V = (curve.eval(0.3 + h) - curve.eval(0.3 - h)) / (2.0 * h);
        assert_eq!(P::from_vector(found[0]), curve.eval(0.3));
        assert!((step - found[1]).norm() < 1e-8 && (curve.derivative(0.3, 2) - found[2]).norm() < 1e-12);
    }

    let net = |i: usize, j: usize| Point3::new(i as f64, j as f64, (i * j) as f64 - 0.3 * j as f64);
    let linear = basis_runtime::BernsteinBasis::<f64, 2>::new();
    let rows = [[net(0, 0), net(0, 1)], [net(1, 0), net(1, 1)]];
    let tensor = TensorSurface::new(linear, linear, rows);
    let quotient = RationalSurface::new(linear, linear, rows, [[1.0, 2.0], [1.0, 0.5]]);
    let spline = BSplineSurface::from_bezier(Net::from_fn(4, 3, net).unwrap()).unwrap();
    let nurbs = NurbsSurface::from(spline.clone());
    let vase = SurfaceOfRevolution::new(&curve, Point3::new(-1.0, 0.0, 0.0), V::z(), 2.0).unwrap();
    let triangle = TriangularBezier::<P, 2, 3>::from_points([net(0, 0), net(0, 2), net(2, 1)]);
    let surfaces: [&dyn Surface<Point = P>; 6] = [&tensor, &quotient, &spline, &nurbs, &vase, &triangle];
    for surface in surfaces {
        let (h, u, v) = (1e-6, 0.3, 0.4);
        let along: V = surface.partial(u, v, [0, 1]);
        let step: V = (surface.eval(u, v + h) - surface.eval(u, v - h)) / (2.0 * h);
        let mut found = [V::zeros(); 4];
        surface.partials_into(u, v, 2, &mut found).unwrap();
        assert!((step - along).norm() < 1e-8 && (found[1] - along).norm() < 1e-12);
        assert!((P::from_vector(found[0]) - surface.eval(u, v)).norm() < 1e-15);
    }
}

#[test]
fn the_maps_of_every_library_move_curves() {
    let (angle, shift) = (0.3_f64, [2.0, -1.0]);
    let expected = |[x, y]: [f64; 2]| {
        [angle.cos() * x - angle.sin() * y + shift[0], angle.sin() * x + angle.cos() * y + shift[1]]
    };
    let points = [[0.0, 0.0], [1.0, 2.0], [3.0, -1.0]];
    let moved = Bezier::from_points(points.map(expected)).eval(0.375);
    let check = |found: [f64; 2]| {
        assert!(found.iter().zip(&moved).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?} {moved:?}");
    };
    #[cfg(feature = "glam")]
    {
        let map = glam::DAffine2::from_angle_translation(angle, shift.into());
        let curve = Bezier::from_points(points.map(glam::DVec2::from));
        check(curve.map(|p| map.transform_point2(p)).eval(0.375).to_array());
    }
    #[cfg(feature = "nalgebra")]
    {
        let map = nalgebra::Isometry2::new(shift.into(), angle);
        let curve = Bezier::from_points(points.map(nalgebra::Point2::from));
        check(curve.map(|p| map * p).eval(0.375).into());
    }
    #[cfg(feature = "kurbo")]
    {
        let map = kurbo::Affine::rotate(angle).then_translate((shift[0], shift[1]).into());
        let image = |[x, y]: [f64; 2]| {
            let p = map * kurbo::Point::new(x, y);
            [p.x, p.y]
        };
        check(Bezier::from_points(points).map(image).eval(0.375));
    }
    #[cfg(feature = "lyon_geom")]
    {
        let map = lyon_geom::Transform::<f64>::rotation(lyon_geom::Angle::radians(angle))
            .then_translate(shift.into());
        let curve = Bezier::from_points(points);
        check(curve.map(|p| map.transform_point(p.into()).to_array()).eval(0.375));
    }
}

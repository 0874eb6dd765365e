//! Curves and surfaces under the affine maps of each library of points: the image of a point is the point of the image.
#![cfg(feature = "geometry")]

use basis_runtime::{
    AffineMap, BernsteinBasis, Bezier, Curve, Path, Point, RationalBezier, RevolutionError, Surface,
    SurfaceOfRevolution, TensorSurface, TriangularBezier,
};

/// The image of a curve and of a triangle with these points, which has the images of their points.
#[track_caller]
fn check<P: Point>(points: [P; 3], by: &impl AffineMap<P>, exact: impl Fn(P) -> P) {
    let near = |a: P, b: P| {
        let size = (0..P::DIM).fold(1.0, |size: f64, d| size.max(a.component(d).to_f64().abs()));
        let tolerance = 16.0 * P::Scalar::EPSILON.to_f64() * size;
        assert!(
            (0..P::DIM).all(|d| (a.component(d) - b.component(d)).to_f64().abs() <= tolerance),
            "{a:?} {b:?}"
        );
    };
    for point in points {
        near(by.image(point), exact(point));
    }
    let curve = Curve::new(BernsteinBasis::<P::Scalar, 3>::new(), points);
    let triangle = TriangularBezier::<P, 2, 3>::from_points(points);
    let [t, s] = [0.375, 0.25].map(P::Scalar::of);
    near(curve.transform(by).eval(t), exact(curve.eval(t)));
    near(triangle.transform(by).eval(t, s), exact(triangle.eval(t, s)));
    near(Path::from_curve(&curve).transform(by).eval(t), exact(curve.eval(t)));
    let weights = [1.0, 2.0, 0.5].map(P::Scalar::of);
    let conic = RationalBezier::new(points, weights).unwrap();
    near(conic.transform(by).eval(t), exact(conic.eval(t)));
}

use basis_runtime::{ParametricCurve as _, Scalar as _};

#[test]
fn by_arrays() {
    let points = [[1.0, 2.0], [-0.5, 0.25], [3.0, 1.5]];
    check(points, &[[0.0, -2.0], [1.0, 0.5]], |[x, y]| [-2.0 * y, x + 0.5 * y]);
    check(points, &[[0.0, -2.0, 3.0], [1.0, 0.5, -1.0]], |[x, y]| [-2.0 * y + 3.0, x + 0.5 * y - 1.0]);
    let points = [[1.0_f32, 2.0, 0.5], [-0.5, 0.25, 2.0], [3.0, 1.5, -1.0]];
    check(points, &[[1.0, 2.0, 0.0], [0.0, 1.0, 0.0], [0.5, 0.0, -1.0]], |[x, y, z]| {
        [x + 2.0 * y, y, 0.5 * x - z]
    });
    let by = [[1.0, 2.0, 0.0, 4.0], [0.0, 1.0, 0.0, 5.0], [0.5, 0.0, -1.0, 6.0]];
    check(points, &by, |[x, y, z]| [x + 2.0 * y + 4.0, y + 5.0, 0.5 * x - z + 6.0]);
}

#[test]
fn of_surfaces() {
    let linear = BernsteinBasis::<f64, 2>::new();
    let saddle =
        TensorSurface::new(linear, linear, [[[0.0; 3], [0.0, 1.0, 1.0]], [[1.0, 0.0, 1.0], [1.0, 1.0, 0.0]]]);
    let turn = [[0.0, -1.0, 0.0, 2.0], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
    let [x, y, z] = saddle.eval(0.25, 0.5);
    assert_eq!(saddle.transform(&turn).eval(0.25, 0.5), [2.0 - y, x, z]);
    let cone = SurfaceOfRevolution::about_x(&Bezier::from_points([[0.0, 0.0], [2.0, 1.0]]), 3.0).unwrap();
    let ([x, y, z], moved) = (cone.eval(0.5, 1.0), cone.transform(&turn).unwrap().eval(0.5, 1.0));
    assert!(moved.iter().zip([2.0 - y, x, z]).all(|(a, b): (&f64, f64)| (a - b).abs() < 1e-15));
    let flattened = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.5]];
    assert_eq!(cone.transform(&flattened).unwrap_err(), RevolutionError::NoSimilarity);
}

#[cfg(feature = "glam")]
#[test]
fn by_glam() {
    use glam::{
        Affine2, Affine3A, DAffine2, DAffine3, DMat2, DMat3, DMat4, DQuat, DVec2, DVec3, DVec4, Mat2, Mat3,
        Mat3A, Mat4, Quat, Vec2, Vec3, Vec3A, Vec4,
    };

    macro_rules! plane {
        ($vec:ident $affine:ident $linear:ident $homogeneous:ident) => {{
            let points = [[1.0, 2.0], [-0.5, 0.25], [3.0, 1.5]].map($vec::from_array);
            let (half, by) = (0.5, $vec::new(3.0, -1.0));
            let turned = |p: $vec| $vec::new(-2.0 * p.y, p.x + half * p.y);
            let linear = $linear::from_cols($vec::new(0.0, 1.0), $vec::new(-2.0, half));
            check(points, &linear, turned);
            check(points, &$affine::from_mat2_translation(linear, by), |p| turned(p) + by);
            let affine = $affine::from_mat2_translation(linear, by);
            check(points, &$homogeneous::from(affine), |p| turned(p) + by);
        }};
    }
    plane!(Vec2 Affine2 Mat2 Mat3);
    plane!(DVec2 DAffine2 DMat2 DMat3);

    macro_rules! space {
        ($vec:ident $vec4:ident $affine:ident $linear:ident $homogeneous:ident $quat:ident) => {{
            let points = [[1.0, 2.0, 0.5], [-0.5, 0.25, 2.0], [3.0, 1.5, -1.0]].map($vec::from_array);
            let by = $vec::new(4.0, 5.0, 6.0);
            let turned = |p: $vec| $vec::new(-p.y, p.x, p.z);
            let linear = $linear::from_cols(
                $vec::new(0.0, 1.0, 0.0),
                $vec::new(-1.0, 0.0, 0.0),
                $vec::new(0.0, 0.0, 1.0),
            );
            check(points, &linear, turned);
            let quarter = $quat::from_xyzw(0.0, 0.0, (0.5_f64).sqrt() as _, (0.5_f64).sqrt() as _);
            check(points, &quarter, turned);
            let homogeneous = $homogeneous::from_rotation_translation(quarter, by.into());
            check(points, &homogeneous, |p| turned(p) + by);
            check(points, &$affine::from_rotation_translation(quarter, by.into()), |p| turned(p) + by);
            let four = points.map(|p| $vec4::new(p.x, p.y, p.z, 2.0));
            check(four, &homogeneous, |p| $vec4::new(-p.y + 8.0, p.x + 10.0, p.z + 12.0, 2.0));
        }};
    }
    space!(Vec3 Vec4 Affine3A Mat3 Mat4 Quat);
    space!(Vec3A Vec4 Affine3A Mat3A Mat4 Quat);
    space!(DVec3 DVec4 DAffine3 DMat3 DMat4 DQuat);
}

#[cfg(feature = "nalgebra")]
#[test]
fn by_nalgebra() {
    use nalgebra::{
        Affine2, Isometry3, Matrix2, Matrix3, Point2, Point3, Rotation3, Scale3, Similarity3, Translation3,
        UnitComplex, UnitQuaternion, Vector3,
    };

    let points = [Point3::new(1.0, 2.0, 0.5), Point3::new(-0.5, 0.25, 2.0), Point3::new(3.0, 1.5, -1.0)];
    let turned = |p: Point3<f64>| Point3::new(-p.y, p.x, p.z);
    let by = Vector3::new(4.0, 5.0, 6.0);
    let angle = Vector3::z() * core::f64::consts::FRAC_PI_2;
    check(points, &Rotation3::new(angle), turned);
    check(points, &UnitQuaternion::new(angle), turned);
    check(points, &Matrix3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0), turned);
    check(points, &Translation3::from(by), |p| p + by);
    check(points, &Scale3::new(2.0, 1.0, 0.5), |p| Point3::new(2.0 * p.x, p.y, 0.5 * p.z));
    check(points, &Isometry3::new(by, angle), |p| turned(p) + by);
    check(points, &Similarity3::new(by, angle, 3.0), |p| turned(p) * 3.0 + by);
    // Vectors stand for places, which a translation moves.
    check(points.map(|p| p.coords), &Isometry3::new(by, angle), |p| turned(p.into()).coords + by);
    let plane = [Point2::new(1.0_f32, 2.0), Point2::new(-0.5, 0.25), Point2::new(3.0, 1.5)];
    check(plane, &UnitComplex::new(core::f32::consts::FRAC_PI_2), |p| Point2::new(-p.y, p.x));
    check(plane, &Matrix2::new(0.0, -2.0, 1.0, 0.5), |p| Point2::new(-2.0 * p.y, p.x + 0.5 * p.y));
    let affine = Affine2::from_matrix_unchecked(Matrix3::new(0.0, -2.0, 3.0, 1.0, 0.5, -1.0, 0.0, 0.0, 1.0));
    check(plane, &affine, |p| Point2::new(-2.0 * p.y + 3.0, p.x + 0.5 * p.y - 1.0));
}

#[cfg(feature = "kurbo")]
#[test]
fn by_kurbo() {
    use kurbo::{Affine, Point, TranslateScale, Vec2};

    let points = [Point::new(1.0, 2.0), Point::new(-0.5, 0.25), Point::new(3.0, 1.5)];
    let by = Affine::new([0.0, 1.0, -2.0, 0.5, 3.0, -1.0]);
    check(points, &by, |p| Point::new(-2.0 * p.y + 3.0, p.x + 0.5 * p.y - 1.0));
    check(points.map(Point::to_vec2), &by, |p| Vec2::new(-2.0 * p.y + 3.0, p.x + 0.5 * p.y - 1.0));
    check(points, &TranslateScale::new(Vec2::new(3.0, 4.0), 2.0), |p| {
        Point::new(2.0 * p.x + 3.0, 2.0 * p.y + 4.0)
    });
}

#[cfg(feature = "lyon_geom")]
#[test]
fn by_lyon_geom() {
    use lyon_geom::{Transform, point};

    let points = [point(1.0, 2.0), point(-0.5, 0.25), point(3.0, 1.5)];
    let by = Transform::new(0.0, 1.0, -2.0, 0.5, 3.0, -1.0);
    check(points, &by, |p| point(-2.0 * p.y + 3.0, p.x + 0.5 * p.y - 1.0));
    check(points, &by, |p| by.transform_point(p));
}

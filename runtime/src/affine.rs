//! Affine maps: those of the libraries of points, and arrays.

use crate::{Point, Scalar};

/// An affine map of points, `p ↦ L p + b`, by which curves and surfaces of all types are moved: `transform`.
///
/// | of | maps | points |
/// | --- | --- | --- |
/// | arrays | `[[S; D]; D]`, the rows of `L`; `[[S; 3]; 2]` and `[[S; 4]; 3]`, the rows of `L` with those of `b` behind them | `[S; D]` |
/// | glam, each version | `Affine2`, `Affine3A`, `Mat2`, `Mat3`, `Mat3A`, `Mat4`, `Quat`, and those in `f64`; with one dimension more than the points have, homogeneous, with the last row of an affine map | `Vec2`, `Vec3`, `Vec3A`, `Vec4`, `DVec2`, `DVec3`, `DVec4` |
/// | nalgebra | `SMatrix`, `Rotation`, `UnitComplex`, `UnitQuaternion`, `Scale`, `Translation`, `Isometry`, `Similarity`, `Affine2`, `Affine3` | `Point`; `SVector`, as places |
/// | kurbo | `Affine`, `TranslateScale` | `Point`; `Vec2`, as places |
/// | lyon_geom | `Transform` | `Point`; `Vector`, as places |
///
/// Other maps are closures, which `map` takes. One of your own has one function:
///
/// ```
/// use basis_runtime::{AffineMap, Bezier};
///
/// struct Doubled;
///
/// impl AffineMap<[f64; 2]> for Doubled {
///     fn image(&self, [x, y]: [f64; 2]) -> [f64; 2] {
///         [2.0 * x, 2.0 * y]
///     }
/// }
///
/// let line = Bezier::from_points([[1.0, 0.0], [2.0, 1.0]]);
/// assert_eq!(line.transform(&Doubled).end(), [4.0, 2.0]);
/// // x' = -y + 3, y' = x
/// assert_eq!(line.transform(&[[0.0, -1.0, 3.0], [1.0, 0.0, 0.0]]).end(), [2.0, 2.0]);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not known as an affine map of `{P}`",
    note = "`map` takes any closure: `curve.map(|point| …)`"
)]
pub trait AffineMap<P: Point> {
    /// The image `L p + b` of a point.
    fn image(&self, point: P) -> P;
}

/// Linear maps, by rows.
impl<S: Scalar, const D: usize> AffineMap<[S; D]> for [[S; D]; D] {
    fn image(&self, point: [S; D]) -> [S; D] {
        self.map(|row| crate::vector::dot(row, point))
    }
}

/// Rows of a linear map, each with the component of the translation behind it.
macro_rules! rows {
    ($($rows:literal $columns:literal;)+) => {$(
        impl<S: Scalar> AffineMap<[S; $rows]> for [[S; $columns]; $rows] {
            fn image(&self, point: [S; $rows]) -> [S; $rows] {
                self.map(|row| (0..$rows).fold(row[$rows], |sum, k| sum + row[k] * point[k]))
            }
        }
    )+};
}
rows! { 2 3; 3 4; }

/// `transform` of a type that has a `map`.
macro_rules! transform {
    () => {
        /// The image under an affine map of the library of the points, see [`AffineMap`](crate::AffineMap); as by `map`.
        #[must_use]
        pub fn transform(&self, by: &impl crate::AffineMap<P>) -> Self {
            self.map(|point| by.image(point))
        }
    };
}
pub(crate) use transform;

/// Maps with a method for points.
#[cfg(any(feature = "glam", feature = "glam_030", feature = "glam_032", feature = "glam_033"))]
macro_rules! by_method {
    ($library:ident: $($map:ident $method:ident $point:ident;)+) => {$(
        impl AffineMap<$library::$point> for $library::$map {
            #[inline]
            fn image(&self, point: $library::$point) -> $library::$point {
                self.$method(point)
            }
        }
    )+};
}

#[cfg(any(feature = "glam", feature = "glam_030", feature = "glam_032", feature = "glam_033"))]
macro_rules! glam {
    ($($(#[$feature:meta])* $library:ident;)+) => {$(
        $(#[$feature])*
        by_method! { $library:
            Affine2 transform_point2 Vec2; Mat2 mul_vec2 Vec2; Mat3 transform_point2 Vec2;
            Affine3A transform_point3 Vec3; Mat3 mul_vec3 Vec3; Mat4 transform_point3 Vec3; Quat mul_vec3 Vec3;
            Affine3A transform_point3a Vec3A; Mat3A mul_vec3a Vec3A; Mat4 transform_point3a Vec3A; Quat mul_vec3a Vec3A;
            Mat4 mul_vec4 Vec4;
            DAffine2 transform_point2 DVec2; DMat2 mul_vec2 DVec2; DMat3 transform_point2 DVec2;
            DAffine3 transform_point3 DVec3; DMat3 mul_vec3 DVec3; DMat4 transform_point3 DVec3; DQuat mul_vec3 DVec3;
            DMat4 mul_vec4 DVec4;
        }
    )+};
}
#[cfg(any(feature = "glam", feature = "glam_030", feature = "glam_032", feature = "glam_033"))]
glam! {
    #[cfg(feature = "glam")]
    glam;
    #[cfg(feature = "glam_030")]
    glam_030;
    #[cfg(feature = "glam_032")]
    glam_032;
    #[cfg(feature = "glam_033")]
    glam_033;
}

#[cfg(feature = "nalgebra")]
mod nalgebra {
    use nalgebra::{
        AbstractRotation, Affine2, Affine3, Isometry, Point, Rotation, SMatrix, SVector, Scale, Similarity,
        Translation, UnitComplex, UnitQuaternion,
    };

    use super::AffineMap;

    /// Each map of points, and of vectors as places.
    macro_rules! of_points {
        ($scalar:ident: $([$($generics:tt)*] $map:ty, $dim:tt;)+) => {$(
            impl<$($generics)*> AffineMap<Point<$scalar, $dim>> for $map {
                #[inline]
                fn image(&self, point: Point<$scalar, $dim>) -> Point<$scalar, $dim> {
                    self * point
                }
            }

            impl<$($generics)*> AffineMap<SVector<$scalar, $dim>> for $map {
                #[inline]
                fn image(&self, point: SVector<$scalar, $dim>) -> SVector<$scalar, $dim> {
                    (self * Point::from(point)).coords
                }
            }
        )+};
    }
    macro_rules! of_scalars {
        ($($scalar:ident)+) => {$(
            of_points! { $scalar:
                [const D: usize] SMatrix<$scalar, D, D>, D;
                [const D: usize] Rotation<$scalar, D>, D;
                [const D: usize] Scale<$scalar, D>, D;
                [const D: usize] Translation<$scalar, D>, D;
                [R: AbstractRotation<$scalar, D>, const D: usize] Isometry<$scalar, R, D>, D;
                [R: AbstractRotation<$scalar, D>, const D: usize] Similarity<$scalar, R, D>, D;
                [] UnitComplex<$scalar>, 2;
                [] UnitQuaternion<$scalar>, 3;
                [] Affine2<$scalar>, 2;
                [] Affine3<$scalar>, 3;
            }
        )+};
    }
    of_scalars! { f32 f64 }
}

#[cfg(feature = "kurbo")]
mod kurbo {
    use kurbo::{Affine, Point, TranslateScale, Vec2};

    use super::AffineMap;

    macro_rules! of_points {
        ($($map:ident)+) => {$(
            impl AffineMap<Point> for $map {
                #[inline]
                fn image(&self, point: Point) -> Point {
                    *self * point
                }
            }

            impl AffineMap<Vec2> for $map {
                #[inline]
                fn image(&self, point: Vec2) -> Vec2 {
                    (*self * point.to_point()).to_vec2()
                }
            }
        )+};
    }
    of_points! { Affine TranslateScale }
}

#[cfg(feature = "lyon_geom")]
mod lyon {
    use lyon_geom::{Point, Transform, Vector};

    use super::{AffineMap, Scalar};

    impl<S: Scalar> AffineMap<Point<S>> for Transform<S> {
        #[inline]
        fn image(&self, point: Point<S>) -> Point<S> {
            let Vector { x, y, .. } = self.image(point.to_vector());
            Point::new(x, y)
        }
    }

    impl<S: Scalar> AffineMap<Vector<S>> for Transform<S> {
        #[inline]
        fn image(&self, Vector { x, y, .. }: Vector<S>) -> Vector<S> {
            Vector::new(x * self.m11 + y * self.m21 + self.m31, x * self.m12 + y * self.m22 + self.m32)
        }
    }
}

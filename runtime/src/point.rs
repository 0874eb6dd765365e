//! What a control point must be able to do, and which types can.

use core::fmt::Debug;

use crate::scalar::{FUSED_HERE, Scalar};

/// A point of an affine space, as components: what control points and points of a curve are.
///
/// Implemented for `f32` and `f64` (dimension one), `[S; D]`, with the features `glam`, `glam_030`, `glam_032` and
/// `glam_033` for the float vectors of four versions of glam, and with the features `nalgebra` and `mint` for their
/// vectors and points. Points are added up with weights component by component; the difference of two points is a
/// [`Vector`](Self::Vector), and so are derivatives, tangents, normals, axes and other directions.
///
/// Two types and two functions make a type of your own a point:
///
/// ```
/// use basis_runtime::Point;
///
/// #[derive(Clone, Copy, Debug, PartialEq)]
/// struct Colour { red: f32, green: f32, blue: f32 }
///
/// impl Point for Colour {
///     type Scalar = f32;
///     type Vector = Self;
///     const DIM: usize = 3;
///     fn from_components(mut component: impl FnMut(usize) -> f32) -> Self {
///         Colour { red: component(0), green: component(1), blue: component(2) }
///     }
///     fn component(&self, index: usize) -> f32 {
///         [self.red, self.green, self.blue][index]
///     }
/// }
///
/// let grey = Colour { red: 0.5, green: 0.5, blue: 0.5 };
/// assert_eq!(Colour::zero().add_scaled(grey, 2.0).green, 1.0);
/// ```
pub trait Point: Copy + PartialEq + Debug {
    /// The type of the components.
    type Scalar: Scalar;

    /// The type of differences of points, of derivatives, tangents, normals and axes. Where points and vectors are different
    /// types, as in nalgebra, the vector; otherwise the type itself.
    type Vector: Point<Scalar = Self::Scalar, Vector = Self::Vector>;

    /// The number of components.
    const DIM: usize;

    /// The point whose components are `component(0), …, component(DIM - 1)`, asked for in this order.
    fn from_components(component: impl FnMut(usize) -> Self::Scalar) -> Self;

    /// The component of that index.
    ///
    /// # Panics
    /// If `index` is not less than [`DIM`](Self::DIM).
    fn component(&self, index: usize) -> Self::Scalar;

    /// The point whose components are all zero.
    #[inline]
    fn zero() -> Self {
        Self::from_components(|_| Self::Scalar::ZERO)
    }

    /// `self * factor`.
    #[inline]
    fn scale(self, factor: Self::Scalar) -> Self {
        Self::from_components(|i| self.component(i) * factor)
    }

    /// The vector from the origin to this point: the same components.
    #[inline]
    fn to_vector(self) -> Self::Vector {
        Self::Vector::from_components(|i| self.component(i))
    }

    /// The point to which a vector from the origin goes: the same components.
    #[inline]
    fn from_vector(vector: Self::Vector) -> Self {
        Self::from_components(|i| vector.component(i))
    }

    /// `self - point`, the vector from `point` to this point.
    #[inline]
    fn minus(self, point: Self) -> Self::Vector {
        Self::Vector::from_components(|i| self.component(i) - point.component(i))
    }

    /// `self + vector * factor`.
    #[inline]
    fn add_scaled(self, vector: Self::Vector, factor: Self::Scalar) -> Self {
        self.add_weighted(Self::from_vector(vector), factor)
    }

    /// `self + point * weight`, a step of a weighted sum `Σ w[i] P[i]` of points.
    #[inline]
    fn add_weighted(self, point: Self, weight: Self::Scalar) -> Self {
        Self::from_components(|i| point.component(i).fma::<FUSED_HERE>(weight, self.component(i)))
    }
}

/// Of a type whose vectors are the type itself.
macro_rules! itself {
    () => {
        #[inline]
        fn to_vector(self) -> Self {
            self
        }

        #[inline]
        fn from_vector(vector: Self) -> Self {
            vector
        }
    };
}

macro_rules! scalars {
    ($($scalar:ident)+) => {$(
        impl Point for $scalar {
            type Scalar = $scalar;
            type Vector = Self;
            const DIM: usize = 1;

            #[inline]
            fn from_components(mut component: impl FnMut(usize) -> $scalar) -> Self {
                component(0)
            }

            #[inline]
            fn component(&self, index: usize) -> $scalar {
                [*self][index]
            }

            itself!();
        }
    )+};
}
scalars!(f32 f64);

impl<S: Scalar, const D: usize> Point for [S; D] {
    type Scalar = S;
    type Vector = Self;
    const DIM: usize = D;

    #[inline]
    fn from_components(component: impl FnMut(usize) -> S) -> Self {
        core::array::from_fn(component)
    }

    #[inline]
    fn component(&self, index: usize) -> S {
        self[index]
    }

    itself!();
}

/// The float vectors of one version of glam as points, with their own operators, which use the vector registers where
/// glam does.
#[cfg(any(feature = "glam", feature = "glam_030", feature = "glam_032", feature = "glam_033"))]
macro_rules! glam_points {
    ($glam:ident: $($point:ident($scalar:ident: $($index:literal)+);)+) => {$(
        impl Point for $glam::$point {
            type Scalar = $scalar;
            type Vector = Self;
            const DIM: usize = [$($index),+].len();

            #[inline]
            fn from_components(mut component: impl FnMut(usize) -> $scalar) -> Self {
                Self::new($(component($index)),+)
            }

            #[inline]
            fn component(&self, index: usize) -> $scalar {
                self[index]
            }

            #[inline]
            fn scale(self, factor: $scalar) -> Self {
                self * factor
            }

            #[inline]
            fn minus(self, point: Self) -> Self {
                self - point
            }

            #[inline]
            fn add_weighted(self, point: Self, weight: $scalar) -> Self {
                if FUSED_HERE {
                    point.mul_add(Self::splat(weight), self)
                } else {
                    self + point * weight
                }
            }

            itself!();
        }
    )+};
    ($glam:ident) => {
        glam_points! {
            $glam:
            Vec2(f32: 0 1);
            Vec3(f32: 0 1 2);
            Vec3A(f32: 0 1 2);
            Vec4(f32: 0 1 2 3);
            DVec2(f64: 0 1);
            DVec3(f64: 0 1 2);
            DVec4(f64: 0 1 2 3);
        }
        impl crate::Point3 for $glam::Vec3 {}
        impl crate::Point3 for $glam::Vec3A {}
        impl crate::Point3 for $glam::DVec3 {}
    };
}
#[cfg(feature = "glam")]
glam_points!(glam);
#[cfg(feature = "glam_030")]
glam_points!(glam_030);
#[cfg(feature = "glam_032")]
glam_points!(glam_032);
#[cfg(feature = "glam_033")]
glam_points!(glam_033);

#[cfg(feature = "mint")]
mod mint {
    use mint::{Point2, Point3, Vector2, Vector3, Vector4};

    use super::{Point, Scalar};

    macro_rules! mint_points {
        ($($point:ident, $vector:ident: $($component:ident $index:literal)+;)+) => {$(
            impl<S: Scalar> Point for $point<S> {
                type Scalar = S;
                type Vector = $vector<S>;
                const DIM: usize = [$($index),+].len();

                #[inline]
                fn from_components(mut component: impl FnMut(usize) -> S) -> Self {
                    Self { $($component: component($index)),+ }
                }

                #[inline]
                fn component(&self, index: usize) -> S {
                    [$(self.$component),+][index]
                }
            }
        )+};
    }
    mint_points! {
        Point2, Vector2: x 0 y 1;
        Point3, Vector3: x 0 y 1 z 2;
        Vector2, Vector2: x 0 y 1;
        Vector3, Vector3: x 0 y 1 z 2;
        Vector4, Vector4: x 0 y 1 z 2 w 3;
    }

    impl<S: Scalar> crate::Point3 for Point3<S> {}
    impl<S: Scalar> crate::Point3 for Vector3<S> {}
}

#[cfg(feature = "nalgebra")]
mod nalgebra {
    use nalgebra::{Point as AffinePoint, SVector};

    use super::{Point, Scalar};

    impl<S: Scalar, const D: usize> Point for SVector<S, D> {
        type Scalar = S;
        type Vector = Self;
        const DIM: usize = D;

        #[inline]
        fn from_components(mut component: impl FnMut(usize) -> S) -> Self {
            Self::from_fn(|index, _| component(index))
        }

        #[inline]
        fn component(&self, index: usize) -> S {
            self[index]
        }
    }

    impl<S: Scalar, const D: usize> Point for AffinePoint<S, D> {
        type Scalar = S;
        type Vector = SVector<S, D>;
        const DIM: usize = D;

        #[inline]
        fn from_components(component: impl FnMut(usize) -> S) -> Self {
            SVector::<S, D>::from_components(component).into()
        }

        #[inline]
        fn component(&self, index: usize) -> S {
            self[index]
        }
    }
}

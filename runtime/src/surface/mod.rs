//! Surfaces over a rectangle or a triangle of two parameters.

#[cfg(feature = "geometry")]
mod area;
mod bounds;
mod curvature;
mod domain;
mod edges;
#[cfg(feature = "geometry")]
mod isocurve;
mod limit;
#[cfg(feature = "alloc")]
pub(crate) mod nearest;
#[cfg(feature = "alloc")]
mod net;
mod parts;
#[cfg(feature = "geometry")]
mod piece;
#[cfg(feature = "geometry")]
mod pieces;
mod rational;
mod tensor;
mod triangle;

#[cfg(feature = "geometry")]
pub use area::Area;
pub use curvature::Curvature;
pub use domain::SurfaceDomain;
#[cfg(feature = "bspline")]
pub(crate) use edges::factor_of_weights;
pub use edges::{Direction, Edge, EdgeJoint, EdgePair, JoinError, Orientation};
#[cfg(feature = "alloc")]
pub(crate) use edges::{beyond, possible, solved};
#[cfg(feature = "geometry")]
pub use isocurve::Isocurve;
pub use parts::BezierPatchOf;
#[cfg(feature = "geometry")]
pub use piece::SurfacePiece;
#[cfg(feature = "geometry")]
pub use pieces::BoundedSurface;
#[cfg(feature = "geometry")]
pub(crate) use pieces::forward_boxes;
pub use rational::{RationalPatchOf, RationalSurface};
pub use tensor::TensorSurface;

use crate::vector::{cross, direction, largest_component, safe_unit};
use crate::{CurveError, Point, Point3, Scalar};
use limit::{limit_normal, rounding};

/// A smooth surface `S(u, v)` over a rectangle, `lo_u <= u <= hi_u`, `lo_v <= v <= hi_v`, or over a triangle, where `u`
/// and `v` are two barycentric coordinates, `u >= 0`, `v >= 0`, `u + v <= 1`: see [`SurfaceDomain`].
///
/// Parameters are not clamped: outside of the domain the formula is continued. If a parameter is NaN so is the point.
/// Generic code asks the domain for parameters, [`SurfaceDomain::at`], and so is right for both.
///
/// A surface of your own provides three functions. All that is not marked `Self: Sized` can be asked of a
/// `&dyn Surface<Point = P>` too:
///
/// ```
/// use basis_runtime::{BernsteinBasis, Bezier, Surface, SurfaceOfRevolution, TensorSurface};
///
/// let linear = BernsteinBasis::<f64, 2>::new();
/// let plane = TensorSurface::new(linear, linear, [[[0.0; 3], [0.0, 1.0, 0.0]], [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0]]]);
/// let cone = SurfaceOfRevolution::about_x(&Bezier::from_points([[0.0, 0.0], [1.0, 1.0]]), 1.0)?;
/// let document: [Box<dyn Surface<Point = [f64; 3]>>; 2] = [Box::new(plane), Box::new(cone)];
/// assert_eq!(document[0].normal(0.5, 0.5), Some([0.0, 0.0, 1.0]));
/// assert_eq!(document[1].partial(0.5, 0.0, [1, 0]), [1.0, 1.0, 0.0]);
/// # Ok::<(), basis_runtime::RevolutionError>(())
/// ```
pub trait Surface {
    /// The type of the points of the surface.
    type Point: Point;

    /// The parameters of the surface.
    fn domain(&self) -> SurfaceDomain<ScalarOf<Self>>;

    /// The point `S(u, v)`.
    fn eval(&self, u: ScalarOf<Self>, v: ScalarOf<Self>) -> Self::Point;

    /// The partial derivative `∂ⁱ⁺ʲ S / ∂uⁱ ∂vʲ` at `(u, v)` of the orders `[i, j]`; for `[0, 0]` the vector from the
    /// origin to the point.
    fn partial(&self, u: ScalarOf<Self>, v: ScalarOf<Self>, orders: [usize; 2]) -> VectorOf<Self>;

    /// The partial derivatives `out[i * count + j]` = `∂ⁱ⁺ʲ S / ∂uⁱ ∂vʲ` at `(u, v)` for all `i, j < count`.
    ///
    /// # Errors
    /// [`CurveError::Length`] if the length of `out` is not `count²`.
    fn partials_into(
        &self,
        u: ScalarOf<Self>,
        v: ScalarOf<Self>,
        count: usize,
        out: &mut [VectorOf<Self>],
    ) -> Result<(), CurveError> {
        one_for_each([count, count], out)?;
        for (n, out) in out.iter_mut().enumerate() {
            *out = self.partial(u, v, [n / count, n % count]);
        }
        Ok(())
    }

    /// The partial derivatives `[i][j]` = `∂ⁱ⁺ʲ S / ∂uⁱ ∂vʲ` at `(u, v)` for all `i, j < K`; `[0][0]` is the vector from
    /// the origin to the point, [`Point::from_vector`].
    fn eval_with_partials<const K: usize>(
        &self,
        u: ScalarOf<Self>,
        v: ScalarOf<Self>,
    ) -> [[VectorOf<Self>; K]; K]
    where
        Self: Sized,
    {
        let mut partials = [[VectorOf::<Self>::zero(); K]; K];
        let filled = self.partials_into(u, v, K, partials.as_flattened_mut());
        debug_assert_eq!(filled, Ok(()), "the slice has K² places");
        partials
    }

    /// The point `S(u, v)`, if these are parameters of the surface.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if they are not, or NaN.
    fn eval_checked(&self, u: ScalarOf<Self>, v: ScalarOf<Self>) -> Result<Self::Point, CurveError> {
        self.domain().check(u, v)?;
        Ok(self.eval(u, v))
    }

    /// The point at the parameters of the surface that are nearest to these.
    fn eval_clamped(&self, u: ScalarOf<Self>, v: ScalarOf<Self>) -> Self::Point {
        let (u, v) = self.domain().clamped(u, v);
        self.eval(u, v)
    }

    /// The points of a grid, `out[i * vs.len() + j] = S(us[i], vs[j])`.
    ///
    /// On a [`TensorSurface`] much faster than point by point.
    ///
    /// ```
    /// use basis_runtime::{BernsteinBasis, Surface, TensorSurface};
    ///
    /// let linear = BernsteinBasis::<f64, 2>::new();
    /// let saddle = TensorSurface::new(linear, linear, [[0.0, 1.0], [1.0, 0.0]]);
    /// let mut heights = [0.0; 6];
    /// saddle.eval_grid(&[0.0, 0.5], &[0.0, 0.25, 1.0], &mut heights)?;
    /// assert_eq!(heights, [0.0, 0.25, 1.0, 0.5, 0.5, 0.5]);
    /// assert!(saddle.eval_grid(&[0.0, 0.5], &[0.0, 0.25], &mut heights).is_err());
    /// # Ok::<(), basis_runtime::CurveError>(())
    /// ```
    ///
    /// # Errors
    /// [`CurveError::Length`] if the length of `out` is not `us.len() * vs.len()`.
    fn eval_grid(
        &self,
        us: &[ScalarOf<Self>],
        vs: &[ScalarOf<Self>],
        out: &mut [Self::Point],
    ) -> Result<(), CurveError> {
        one_for_each([us.len(), vs.len()], out)?;
        let pairs = us.iter().flat_map(|&u| vs.iter().map(move |&v| (u, v)));
        for (point, (u, v)) in out.iter_mut().zip(pairs) {
            *point = self.eval(u, v);
        }
        Ok(())
    }

    /// The unit normal at `(u, v)`: the direction of `S_u × S_v`, or where that vanishes, its limit.
    ///
    /// At a pole, where a whole edge of the domain is one point, the product vanishes and the limit is that over all
    /// parameters near `(u, v)` in the domain. `None` if there is no limit: at the apex where two such edges meet,
    /// in general; on a surface that has shrunk to a curve or a point; on a fold across which the normal flips; and
    /// where the surface is infinite or NaN. The limit is found from the Taylor polynomial of `S_u × S_v` up to the
    /// fourth order, and what vanishes to a higher order has no normal here. The point at which the product vanishes is
    /// recognised up to rounding errors.
    ///
    /// ```
    /// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
    /// # fn main() -> Result<(), basis_runtime::ShapeError> {
    /// use basis_runtime::{Surface, TensorSurface};
    ///
    /// // All of the first row is one point, a pole.
    /// let net: [[[f64; 3]; 4]; 4] = core::array::from_fn(|i| core::array::from_fn(|j| {
    ///     let (i, j) = (i as f64, j as f64);
    ///     [i, i * (j - 1.5), 0.0]
    /// }));
    /// let fan = TensorSurface::new(QuarticBernstein::new(0.5)?, QuarticBernstein::new(0.0)?, net);
    /// let [[_, along_the_pole], _] = fan.eval_with_partials(0.0, 0.3);
    /// assert_eq!(along_the_pole, [0.0; 3]);
    /// assert_eq!(fan.normal(0.0, 0.3), Some([0.0, 0.0, 1.0]));
    /// # Ok(())
    /// # }
    /// ```
    fn normal(&self, u: ScalarOf<Self>, v: ScalarOf<Self>) -> Option<VectorOf<Self>>
    where
        Self::Point: Point3,
    {
        let domain = self.domain();
        let mut first = [[VectorOf::<Self>::zero(); 2]; 2];
        self.partials_into(u, v, 2, first.as_flattened_mut()).ok()?;
        regular_normal(&first, domain.widths()).or_else(|| {
            let mut partials = [[VectorOf::<Self>::zero(); 6]; 6];
            self.partials_into(u, v, 6, partials.as_flattened_mut()).ok()?;
            limit_normal(&partials, domain, [u, v])
        })
    }

    /// How the surface bends at `(u, v)`; `None` where `S_u × S_v` vanishes or anything is not finite.
    fn curvature(&self, u: ScalarOf<Self>, v: ScalarOf<Self>) -> Option<Curvature<Self::Point>>
    where
        Self::Point: Point3,
    {
        let widths = self.domain().widths();
        let mut partials = [[VectorOf::<Self>::zero(); 3]; 3];
        self.partials_into(u, v, 3, partials.as_flattened_mut()).ok()?;
        let first = [[partials[0][0], partials[0][1]], [partials[1][0], partials[1][1]]];
        Curvature::new(&partials, regular_normal(&first, widths)?)
    }

    /// How smoothly `next`, a surface of any type, continues this one along an edge of each, at `samples` evenly spaced
    /// parameters (at least two).
    ///
    /// The parameters along the edges correspond by the affine map. Between samples the figures may be larger; those of
    /// polynomial surfaces of low degree differ little from the largest with 65 samples.
    ///
    /// ```
    /// use basis_runtime::{BernsteinBasis, Edge, EdgePair, Orientation, Surface, TensorSurface};
    ///
    /// // Two sides of a roof.
    /// let linear = BernsteinBasis::<f64, 2>::new();
    /// let side = |net: [[[f64; 3]; 2]; 2]| TensorSurface::new(linear, linear, net);
    /// let left = side([[[0.0, 0.0, 0.0], [0.0, 1.0, 1.0]], [[1.0, 0.0, 0.0], [1.0, 1.0, 1.0]]]);
    /// let right = side([[[0.0, 1.0, 1.0], [0.0, 2.0, 0.0]], [[1.0, 1.0, 1.0], [1.0, 2.0, 0.0]]]);
    /// let ridge = left.joint(EdgePair::along(Edge::VEnd, Edge::VStart), &right, 9);
    /// assert_eq!(ridge.gap, 0.0);
    /// assert!((ridge.angle - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    /// assert_eq!(ridge.normals, Orientation::Same);
    /// assert_eq!(ridge.geometric_order(1e-9, 1e-6, 1e-3), Some(0));
    /// ```
    fn joint(
        &self,
        edges: EdgePair,
        next: &dyn Surface<Point = Self::Point>,
        samples: usize,
    ) -> EdgeJoint<ScalarOf<Self>>
    where
        Self::Point: Point3,
    {
        edges::measured(self, edges, next, samples)
    }
}

/// A reference to a surface and a box of one are surfaces too, also of a `dyn Surface`.
macro_rules! surface_behind {
    ($($(#[$feature:meta])* $pointer:ty;)+) => {$(
        $(#[$feature])*
        impl<T: Surface + ?Sized> Surface for $pointer {
            type Point = T::Point;

            fn domain(&self) -> SurfaceDomain<ScalarOf<T>> {
                (**self).domain()
            }

            fn eval(&self, u: ScalarOf<T>, v: ScalarOf<T>) -> T::Point {
                (**self).eval(u, v)
            }

            fn partial(&self, u: ScalarOf<T>, v: ScalarOf<T>, orders: [usize; 2]) -> VectorOf<T> {
                (**self).partial(u, v, orders)
            }

            fn partials_into(
                &self,
                u: ScalarOf<T>,
                v: ScalarOf<T>,
                count: usize,
                out: &mut [VectorOf<T>],
            ) -> Result<(), CurveError> {
                (**self).partials_into(u, v, count, out)
            }

            fn eval_grid(
                &self,
                us: &[ScalarOf<T>],
                vs: &[ScalarOf<T>],
                out: &mut [T::Point],
            ) -> Result<(), CurveError> {
                (**self).eval_grid(us, vs, out)
            }

            fn normal(&self, u: ScalarOf<T>, v: ScalarOf<T>) -> Option<VectorOf<T>>
            where
                T::Point: Point3,
            {
                (**self).normal(u, v)
            }

            fn curvature(&self, u: ScalarOf<T>, v: ScalarOf<T>) -> Option<Curvature<T::Point>>
            where
                T::Point: Point3,
            {
                (**self).curvature(u, v)
            }
        }
    )+};
}

surface_behind! {
    &T;
    #[cfg(feature = "alloc")]
    alloc::boxed::Box<T>;
}

/// [`Surface::partials_into`] of a type with an `eval_with_partials` of its own: the numbers that normals and
/// curvatures ask for go through it, others one by one.
macro_rules! partials_by_number {
    () => {
        #[inline]
        fn partials_into(
            &self,
            u: P::Scalar,
            v: P::Scalar,
            count: usize,
            out: &mut [P::Vector],
        ) -> Result<(), $crate::CurveError> {
            $crate::surface::one_for_each([count, count], out)?;
            match count {
                2 => out.copy_from_slice(self.eval_with_partials::<2>(u, v).as_flattened()),
                3 => out.copy_from_slice(self.eval_with_partials::<3>(u, v).as_flattened()),
                6 => out.copy_from_slice(self.eval_with_partials::<6>(u, v).as_flattened()),
                _ => {
                    for (n, out) in out.iter_mut().enumerate() {
                        *out = self.partial(u, v, [n / count, n % count]);
                    }
                }
            }
            Ok(())
        }
    };
}
pub(crate) use partials_by_number;

/// The error of a slice that has not one place for each pair of a grid.
pub(crate) fn one_for_each<T>([rows, columns]: [usize; 2], out: &[T]) -> Result<(), CurveError> {
    let (expected, found) = (rows.saturating_mul(columns), out.len());
    if expected == found { Ok(()) } else { Err(CurveError::Length { expected, found }) }
}

/// The scalar type of a surface.
pub type ScalarOf<T> = <<T as Surface>::Point as Point>::Scalar;

/// The type of the partial derivatives and normals of a surface.
pub type VectorOf<T> = <<T as Surface>::Point as Point>::Vector;

/// The direction of `S_u × S_v`; `None` where it vanishes up to rounding errors, or is not finite.
pub(crate) fn regular_normal<P: Point>(first: &[[P; 2]; 2], widths: [P::Scalar; 2]) -> Option<P> {
    let (mut along_u, mut along_v) = (first[1][0].scale(widths[0]), first[0][1].scale(widths[1]));
    let [mut size, mut u_size, mut v_size] = [first[0][0], along_u, along_v].map(largest_component);
    size = [u_size, v_size].into_iter().fold(size, |a, b| if b > a { b } else { a });
    let unit = safe_unit(size, 1);
    if unit != P::Scalar::ONE {
        [along_u, along_v] = [along_u, along_v].map(|p| P::from_components(|c| p.component(c) / unit));
        [size, u_size, v_size] = [size, u_size, v_size].map(|size| size / unit);
    }
    let product = cross(along_u, along_v);
    let error = rounding(size) * (u_size + v_size);
    if largest_component(product) > error { direction(product) } else { None }
}

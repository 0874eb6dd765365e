//! Surfaces that consist of rational Bézier patches, whatever their type, and what follows from these.

use alloc::vec::Vec;

use super::area::{self, Area};
use super::bounds::largest_quotient;
use super::nearest::{Piece, nearest_of_pieces};
use super::net::Net;
use super::piece::PieceKind;
use super::{
    Direction, Edge, Isocurve, RationalSurface, ScalarOf, Surface, SurfacePiece, TensorSurface, VectorOf,
};
use crate::geometry::{SurfaceMeeting, of_line};
use crate::vector::distance;
use crate::{Basis, Nearest, Point, Point3, Scalar, SurfaceOfRevolution};

/// A surface that consists of rational Bézier patches, whose control points bound it.
///
/// Boxes, nearest points and meshes follow from the patches; a surface of your own needs to say only these.
pub trait BoundedSurface: Surface {
    /// The rational Bézier patches of which the surface consists.
    fn pieces(&self) -> Vec<SurfacePiece>;

    /// The smallest axis-parallel box around the Bézier control points, as its two extreme corners: cheap, and never
    /// too small up to rounding errors. Infinite if a weight of the Bézier form is not positive. NaN in a component in
    /// which a control point is NaN.
    fn control_box(&self) -> [Self::Point; 2] {
        let pieces = self.pieces();
        let side = |c: usize, sign: f64| {
            let mut extreme = f64::NEG_INFINITY;
            for piece in &pieces {
                let largest = piece.net.largest_of_points(c, sign);
                extreme = if extreme.is_nan() || largest.is_nan() { f64::NAN } else { extreme.max(largest) };
            }
            ScalarOf::<Self>::of(sign * extreme)
        };
        [Point::from_components(|c| side(c, -1.0)), Point::from_components(|c| side(c, 1.0))]
    }

    /// The smallest axis-parallel box around the surface, as its two extreme corners, up to rounding errors; found by
    /// subdivision as [`TensorSurface::bounding_box`]. NaN in a component in which a control point is infinite or NaN.
    fn bounding_box(&self) -> [Self::Point; 2] {
        let pieces = self.pieces();
        let side = |c: usize, sign: f64| {
            let mut extreme = f64::NEG_INFINITY;
            for piece in &pieces {
                let [rows, columns] = piece.degrees().map(|degree| degree + 1);
                let point = |n: usize| {
                    let (i, j) = (n / columns, n % columns);
                    [sign * piece.net.point(i, j)[c], piece.net.weight(j * rows + i)]
                };
                let largest = largest_quotient(Net::new((0..rows * columns).map(point).collect(), columns));
                extreme = if extreme.is_nan() || largest.is_nan() { f64::NAN } else { extreme.max(largest) };
            }
            ScalarOf::<Self>::of(sign * extreme)
        };
        [Point::from_components(|c| side(c, -1.0)), Point::from_components(|c| side(c, 1.0))]
    }

    /// The point of the surface that is nearest to `point`, among those with parameters in the domain.
    ///
    /// It is a global minimum: its distance exceeds [`at_least`](Nearest::at_least), which no point of the surface is
    /// nearer than, by no more than `accuracy`. An `accuracy` below some 64 `ε` times the greatest distance of a Bézier
    /// control point, also zero or NaN, asks for what the scalar type can give. Where very many points are almost
    /// equally near, such as around the centre of a sphere, the work ends earlier: the point is still a minimum, and
    /// `at_least` says how much is proved. `None` if the point, the surface or the distance is not finite, or a weight
    /// of the Bézier form is not positive.
    fn nearest(
        &self,
        point: Self::Point,
        accuracy: ScalarOf<Self>,
    ) -> Option<Nearest<Self::Point, [ScalarOf<Self>; 2]>> {
        let pieces = self.pieces();
        let components: Vec<f64> = (0..Self::Point::DIM).map(|c| point.component(c).to_f64()).collect();
        let epsilon = ScalarOf::<Self>::EPSILON.to_f64();
        let nets: Vec<&Piece> = pieces.iter().map(|piece| &piece.net).collect();
        let (piece, at, bound) = nearest_of_pieces(&nets, &components, accuracy.to_f64(), epsilon)?;
        let at = pieces[piece].parameters(at);
        let [u, v] = at.map(ScalarOf::<Self>::of);
        let (u, v) = self.domain().clamped(u, v);
        let found = self.eval(u, v);
        let distance = distance(found, point);
        let at_least = ScalarOf::<Self>::of(bound).min(distance);
        distance.is_finite().then_some(Nearest { at: [u, v], point: found, distance, at_least })
    }

    /// The curve on which one parameter is constant; `direction` is that of the constant parameter.
    ///
    /// Spline surfaces have a method of this name that gives a spline, [`TensorSurface::along_u`],
    /// [`TensorSurface::along_v`] and [`SurfaceOfRevolution::meridian`] curves over their family.
    ///
    /// ```
    /// use basis_runtime::{BernsteinBasis, BoundedSurface, Direction, ParametricCurve, TensorSurface};
    ///
    /// let linear = BernsteinBasis::<f64, 2>::new();
    /// let saddle = TensorSurface::new(linear, linear, [[[0.0; 3], [0.0, 1.0, 1.0]], [[1.0, 0.0, 1.0], [1.0, 1.0, 0.0]]]);
    /// let line = saddle.isocurve(Direction::U, 0.5);
    /// assert_eq!((line.start(), line.end()), ([0.5, 0.0, 0.5], [0.5, 1.0, 0.5]));
    /// assert_eq!(line.tangent(0.3), Some([0.0, 1.0, 0.0]));
    /// ```
    fn isocurve(&self, direction: Direction, at: ScalarOf<Self>) -> Isocurve<'_, Self>
    where
        Self: Sized,
    {
        Isocurve::new(self, direction, at)
    }

    /// The boundary curve along an edge, in the direction in which its parameter grows.
    fn boundary(&self, edge: Edge) -> Isocurve<'_, Self>
    where
        Self: Sized,
    {
        Isocurve::along(self, edge)
    }

    /// The area `∫∫ |S_u × S_v| du dv` of a surface in a space of any dimension; see [`Area`] for the bound of its
    /// error. `None` if anything is not finite, the area included, or a weight of the Bézier form is not positive.
    ///
    /// ```
    /// use basis_runtime::{Bezier, BoundedSurface, SurfaceOfRevolution};
    ///
    /// let cone = SurfaceOfRevolution::about_x(&Bezier::from_points([[0.0, 0.0], [3.0, 4.0]]), 2.0)?;
    /// let area = cone.area(1e-9).unwrap();
    /// assert!(area.error <= 1e-9 && (area.value - 20.0_f64).abs() <= area.error); // half of 2 · 4 · 5
    /// # Ok::<(), basis_runtime::RevolutionError>(())
    /// ```
    fn area(&self, accuracy: ScalarOf<Self>) -> Option<Area<ScalarOf<Self>>> {
        area::of_pieces(&self.pieces(), accuracy.to_f64(), ScalarOf::<Self>::EPSILON.to_f64())
    }

    /// All places at which the ray `origin + t direction`, `t >= 0`, meets the surface, the first one first.
    ///
    /// None is missed, and an `accuracy` is needed for those places only at which the ray touches the surface, runs along
    /// it or meets a pole: see
    /// [`ParametricCurve::surface_intersections`](crate::ParametricCurve::surface_intersections). `None` if the direction
    /// is zero, anything is not finite, or a weight of the Bézier form is not positive.
    ///
    /// ```
    /// use basis_runtime::{Bezier, BoundedSurface, SurfaceOfRevolution};
    ///
    /// let cylinder = SurfaceOfRevolution::about_x(&Bezier::from_points([[-2.0, 1.0], [2.0, 1.0]]), 6.0)?;
    /// let found = cylinder.ray_intersections([0.5, -3.0, 0.6], [0.0, 2.0, 0.0], 1e-9).unwrap();
    /// let [first, second] = found.try_into().unwrap();
    /// assert!((first.at - 1.1_f64).abs() < 1e-14 && (second.at - 1.9_f64).abs() < 1e-14);
    /// assert!((first.surface_at[0] - 0.625).abs() < 1e-14); // of the generatrix
    /// # Ok::<(), basis_runtime::RevolutionError>(())
    /// ```
    fn ray_intersections(
        &self,
        origin: Self::Point,
        direction: VectorOf<Self>,
        accuracy: ScalarOf<Self>,
    ) -> Option<Vec<SurfaceMeeting<Self::Point>>>
    where
        Self::Point: Point3,
    {
        of_line(self, origin, direction, 0.0, accuracy)
    }

    /// All places at which the line `point + t direction`, with any `t`, meets the surface, that with the smallest `t`
    /// first; see [`ray_intersections`](Self::ray_intersections).
    fn line_intersections(
        &self,
        point: Self::Point,
        direction: VectorOf<Self>,
        accuracy: ScalarOf<Self>,
    ) -> Option<Vec<SurfaceMeeting<Self::Point>>>
    where
        Self::Point: Point3,
    {
        of_line(self, point, direction, f64::NEG_INFINITY, accuracy)
    }
}

/// What a reference or a box refers to is asked.
macro_rules! bounded_behind {
    ($($pointer:ty),+) => {$(
        impl<T: BoundedSurface + ?Sized> BoundedSurface for $pointer {
            fn pieces(&self) -> Vec<SurfacePiece> {
                (**self).pieces()
            }

            fn control_box(&self) -> [T::Point; 2] {
                (**self).control_box()
            }

            fn bounding_box(&self) -> [T::Point; 2] {
                (**self).bounding_box()
            }

            fn nearest(
                &self,
                point: T::Point,
                accuracy: ScalarOf<T>,
            ) -> Option<Nearest<T::Point, [ScalarOf<T>; 2]>> {
                (**self).nearest(point, accuracy)
            }
        }
    )+};
}

bounded_behind!(&T, alloc::boxed::Box<T>);

/// Answers with the methods of the type, which have the same names.
macro_rules! forward_boxes {
    () => {
        #[inline]
        fn control_box(&self) -> [P; 2] {
            self.control_box()
        }

        #[inline]
        fn bounding_box(&self) -> [P; 2] {
            self.bounding_box()
        }
    };
}
pub(crate) use forward_boxes;

impl<U, V, P> BoundedSurface for TensorSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    fn pieces(&self) -> Vec<SurfacePiece> {
        let net = Net::of(self);
        let of = |n: usize, c: usize| net.points()[n].component(c).to_f64();
        let size = [U::DEGREE + 1, V::DEGREE + 1];
        alloc::vec![SurfacePiece::from_fn([U::domain(), V::domain()], size, P::DIM, P::DIM, of)]
    }

    #[inline]
    fn nearest(&self, point: P, accuracy: P::Scalar) -> Option<Nearest<P, [P::Scalar; 2]>> {
        self.nearest(point, accuracy)
    }

    forward_boxes!();
}

impl<U, V, P> BoundedSurface for RationalSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    fn pieces(&self) -> Vec<SurfacePiece> {
        let (points, weights) = (Net::of(self.numerator()), Net::of(self.weight()));
        // A whole surface of negative weights is that of their opposites.
        let sign = if weights.corners()[0] < P::Scalar::ZERO { -1.0 } else { 1.0 };
        let of = |n: usize, c: usize| {
            sign * if c == P::DIM { weights.points()[n] } else { points.points()[n].component(c) }.to_f64()
        };
        let size = [U::DEGREE + 1, V::DEGREE + 1];
        alloc::vec![SurfacePiece::from_fn([U::domain(), V::domain()], size, P::DIM, P::DIM + 1, of)]
    }

    forward_boxes!();
}

impl<B: Basis, P: Point3<Scalar = B::Scalar>> BoundedSurface for SurfaceOfRevolution<B, P> {
    fn pieces(&self) -> Vec<SurfacePiece> {
        let arcs = self.to_rational_patches();
        let mut pieces = Vec::with_capacity(arcs.len());
        for (k, arc) in arcs.iter().enumerate() {
            for mut piece in arc.pieces() {
                let [from, to] = [k, k + 1].map(|k| {
                    (self.angle() * B::Scalar::from_usize(k) / B::Scalar::from_usize(arcs.len())).to_f64()
                });
                piece.domain = [B::domain().map(Scalar::to_f64), [from, to]];
                piece.kind = PieceKind::Arc;
                pieces.push(piece);
            }
        }
        pieces
    }

    forward_boxes!();
}

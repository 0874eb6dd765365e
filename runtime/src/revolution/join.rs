//! Surfaces of revolution that continue another one across a circle.

use crate::surface::{beyond, possible, solved};
use crate::{
    Array, Basis, Contact, Curve, EdgePair, JoinError, Orientation, Point, Point3, Scalar,
    SurfaceOfRevolution,
};

impl<B: Basis, P: Point3<Scalar = B::Scalar>> SurfaceOfRevolution<B, P> {
    /// The surface `next`, moved so that it continues this one across a circle at an end of each, with that contact.
    ///
    /// The generatrix of `next` is moved so that it continues a meridian of this surface, as by
    /// [`ParametricCurve::continued`](crate::ParametricCurve::continued), and turns about the same axis by the same
    /// angle: in the other direction, from the last meridian on, if the edges run in opposite directions.
    ///
    /// ```
    /// use basis_runtime::{Bezier, Contact, Edge, EdgePair, Surface, SurfaceOfRevolution};
    ///
    /// let neck = SurfaceOfRevolution::about_x(&Bezier::from_points([[0.0, 1.0], [1.0, 1.0], [2.0, 2.0]]), 4.0)?;
    /// let draft = Bezier::from_points([[0.0, 0.0], [0.0, 0.0], [4.0, 3.0], [6.0, 1.0]]);
    /// let draft = SurfaceOfRevolution::about_x(&draft, 1.0)?;
    /// let edges = EdgePair::along(Edge::UEnd, Edge::UStart);
    /// let body = neck.continued(edges, Contact::Tangent { f: 1.0 }, &draft)?;
    /// assert_eq!(body.generatrix().control_points()[2..], [[4.0, 3.0, 0.0], [6.0, 1.0, 0.0]]);
    /// assert_eq!(neck.joint(edges, &body, 9).geometric_order(1e-14, 1e-7, 1e-9), Some(1));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`JoinError::Meridian`] if an edge is a meridian, [`Edge::VStart`](crate::Edge::VStart) or
    /// [`Edge::VEnd`](crate::Edge::VEnd); [`JoinError::Factor`] as for curves; [`JoinError::Contact`] if the order is
    /// not below the number of control points of `next`; [`JoinError::Undetermined`] if these do not determine the
    /// derivatives; [`JoinError::NotFinite`] if a computed control point is not finite.
    pub fn continued<C: Basis<Scalar = B::Scalar>>(
        &self,
        edges: EdgePair,
        contact: Contact<B::Scalar>,
        next: &SurfaceOfRevolution<C, P>,
    ) -> Result<SurfaceOfRevolution<C, P>, JoinError> {
        if edges.first.runs_along_u() || edges.second.runs_along_u() {
            return Err(JoinError::Meridian);
        }
        let order = possible(contact, C::LEN - 1)?;
        let (meridian, axis) = match edges.orientation {
            Orientation::Same => (self.generatrix, self.axis),
            Orientation::Opposite => (self.meridian(self.angle), self.axis.scale(-B::Scalar::ONE)),
        };
        let mut derivatives = alloc::vec![P::Vector::zero(); order + 1];
        meridian.derivatives_into(B::domain()[usize::from(edges.first.is_end())], &mut derivatives);
        let derivatives = derivatives.into_iter().map(P::from_vector).collect();
        let derivatives = beyond(edges, contact, derivatives)?;
        let basis = next.generatrix.basis();
        let points = Array::from_fn(|i| next.generatrix.control_points()[i]);
        let generatrix = Curve::new(basis, solved(basis, edges.second, &derivatives, points)?);
        SurfaceOfRevolution::new(&generatrix, self.point, axis, self.angle).map_err(|_| JoinError::NotFinite)
    }
}

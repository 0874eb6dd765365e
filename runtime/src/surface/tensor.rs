//! Tensor surfaces over two families.

use core::fmt::{self, Debug, Formatter};

use super::{one_for_each, partials_by_number};
use crate::basis::combination;
use crate::domain::{inverse_width, unit};
use crate::{Array, Basis, CountError, Curve, CurveError, Form, Point, Scalar, Surface, SurfaceDomain};

/// The number of parameters in `v` that are evaluated together.
const TILE: usize = 512;

/// The surface `S(u, v) = Σ_i b[i](u) Σ_j c_i[j](v) P[i][j]` over a net of control points.
///
/// The functions `b` in `u` and `c_i` in `v` are any two families. All rows of the net may have the same shape values,
/// as in a plain tensor product, or every row `i` shape values of its own: with the quartic family and a net of four
/// rows, the surface with the five shape parameters λ, γ0, …, γ3 ("Quartic generalized Bézier surfaces with multiple
/// shape parameters and their G1/G2 joins", Definition 2).
///
/// ```
/// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
/// # fn main() -> Result<(), basis_runtime::ShapeError> {
/// use basis_runtime::{Surface, TensorSurface};
///
/// let net: [[[f64; 3]; 4]; 4] = core::array::from_fn(|i| core::array::from_fn(|j| {
///     [i as f64, j as f64, if i % 3 > 0 && j % 3 > 0 { 2.0 } else { 0.0 }]
/// }));
/// let lambda = QuarticBernstein::new(0.5)?;
/// let gammas = [QuarticBernstein::new(0.0)?, QuarticBernstein::new(1.0)?, QuarticBernstein::new(-1.0)?, lambda];
/// let surface = TensorSurface::with_rows(lambda, gammas, net);
///
/// assert_eq!(surface.eval(1.0, 0.0), net[3][0]);
/// let [[point, along_v], [along_u, _]] = surface.eval_with_partials(0.0, 1.0);
/// assert_eq!(point, net[0][3]);
/// assert_eq!(along_u, [3.5, 0.0, 0.0]); // (3 + λ) (P[1][3] - P[0][3])
/// assert_eq!(along_v, [0.0, 3.0, 0.0]); // (3 + γ0) (P[0][3] - P[0][2])
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy)]
pub struct TensorSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    u_basis: U,
    rows: U::Points<Curve<V, P>>,
}

impl<U, V, P> TensorSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    /// The surface with one family in `u` and one in `v`; `net[i][j]` belongs to function `i` in `u` and `j` in `v`.
    #[inline]
    pub fn new(u_basis: U, v_basis: V, net: U::Points<V::Points<P>>) -> Self {
        Self { u_basis, rows: U::Points::from_fn(|i| Curve::new(v_basis, net.as_ref()[i])) }
    }

    /// The same from the points of the net in a slice, row by row.
    ///
    /// # Errors
    /// When the number of points is not the product of the numbers of functions.
    pub fn from_slice(u_basis: U, v_basis: V, net: &[P]) -> Result<Self, CountError> {
        let expected = U::LEN * V::LEN;
        if net.len() != expected {
            return Err(CountError::new(U::NAME, expected, net.len()));
        }
        let row = |i: usize| V::Points::from_fn(|j| net[i * V::LEN + j]);
        Ok(Self::new(u_basis, v_basis, U::Points::from_fn(row)))
    }

    /// The surface over the same net with other shape values, the same in all rows.
    #[must_use]
    pub fn with_bases(&self, u_basis: U, v_basis: V) -> Self {
        Self { u_basis, rows: U::Points::from_fn(|i| self.rows()[i].with_basis(v_basis)) }
    }

    /// The surface whose row `i` of the net has the family `v_bases[i]` in `v`.
    #[inline]
    pub fn with_rows(u_basis: U, v_bases: U::Points<V>, net: U::Points<V::Points<P>>) -> Self {
        Self { u_basis, rows: U::Points::from_fn(|i| Curve::new(v_bases.as_ref()[i], net.as_ref()[i])) }
    }

    #[inline]
    pub(crate) fn from_rows(u_basis: U, rows: U::Points<Curve<V, P>>) -> Self {
        Self { u_basis, rows }
    }

    /// The surface over the images of all control points: the image under an affine map if the functions sum to 1 in both
    /// directions, and always under a linear one.
    #[must_use]
    pub fn map<Q: Point<Scalar = U::Scalar>>(&self, mut image: impl FnMut(P) -> Q) -> TensorSurface<U, V, Q> {
        TensorSurface {
            u_basis: self.u_basis,
            rows: U::Points::from_fn(|i| self.rows.as_ref()[i].map(&mut image)),
        }
    }

    crate::affine::transform!();

    /// The family in `u`, with its shape values.
    #[inline]
    pub fn u_basis(&self) -> U {
        self.u_basis
    }

    /// The rows of the net as curves in `v`, each with its family and its control points.
    #[inline]
    pub fn rows(&self) -> &[Curve<V, P>] {
        self.rows.as_ref()
    }

    /// The control point `P[i][j]`; `None` outside of the net.
    #[inline]
    pub fn control_point(&self, i: usize, j: usize) -> Option<P> {
        self.rows().get(i)?.control_points().get(j).copied()
    }
}

impl<U, V, P> Surface for TensorSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    type Point = P;

    #[inline]
    fn domain(&self) -> SurfaceDomain<P::Scalar> {
        SurfaceDomain::Rectangle([U::domain(), V::domain()])
    }

    /// Exact at the corners of a net that they interpolate.
    #[inline]
    fn eval(&self, u: P::Scalar, v: P::Scalar) -> P {
        let weights = self.u_basis.values(u);
        combination(self.rows().iter().map(|row| row.eval(v)).zip(weights.as_ref().iter().copied()))
    }

    fn partial(&self, u: P::Scalar, v: P::Scalar, orders: [usize; 2]) -> P::Vector {
        match orders {
            [0, 0] => self.eval(u, v).to_vector(),
            [i, j] => Curve::new(self.u_basis, U::Points::from_fn(|r| self.rows()[r].derivative(v, j)))
                .derivative(u, i),
        }
    }

    partials_by_number!();

    #[inline]
    fn eval_with_partials<const K: usize>(&self, u: P::Scalar, v: P::Scalar) -> [[P::Vector; K]; K] {
        let rows = U::Points::<[P::Vector; K]>::from_fn(|i| self.rows()[i].eval_with_derivs(v));
        let [_, x] = unit(U::domain(), u);
        let inverse_width = inverse_width(U::domain());
        let mut partials = [[P::Vector::zero(); K]; K];
        for j in 0..K {
            let along = self.u_basis.bind(&U::Points::<P::Vector>::from_fn(|i| rows.as_ref()[i][j]));
            let mut scale = P::Scalar::ONE;
            for (row, derivative) in partials.iter_mut().zip(along.eval_with_derivs::<K>(x)) {
                row[j] = derivative.scale(scale);
                scale = scale * inverse_width;
            }
        }
        if K > 0 {
            partials[0][0] = self.eval(u, v).to_vector();
        }
        partials
    }

    /// For each `u` the rows are added up once to the curve `v ↦ S(u, v)`, which is evaluated along `v` with the widest
    /// vector instructions of the processor. Results can differ from [`eval`](Surface::eval) in the last digits;
    /// corners are exact.
    fn eval_grid(&self, us: &[P::Scalar], vs: &[P::Scalar], out: &mut [P]) -> Result<(), CurveError> {
        one_for_each([us.len(), vs.len()], out)?;
        if vs.is_empty() {
            return Ok(());
        }
        let mut ys = [P::Scalar::ZERO; TILE];
        for (tile, vs_here) in vs.chunks(TILE).enumerate() {
            let ys = &mut ys[..vs_here.len()];
            for (y, &v) in ys.iter_mut().zip(vs_here) {
                [_, *y] = unit(V::domain(), v);
            }
            for (&u, line) in us.iter().zip(out.chunks_mut(vs.len())) {
                let weights = self.u_basis.values(u);
                let terms =
                    self.rows().iter().zip(weights.as_ref()).map(|(row, &weight)| (*row.form(), weight));
                V::Form::combination(terms).eval_into(ys, &mut line[tile * TILE..]);
            }
        }
        Ok(())
    }
}

impl<U, V, P> PartialEq for TensorSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.u_basis == other.u_basis && self.rows() == other.rows()
    }
}

impl<U, V, P> Debug for TensorSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_struct("TensorSurface").field("u_basis", &self.u_basis).field("rows", &self.rows()).finish()
    }
}

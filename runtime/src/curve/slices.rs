//! Curves at many parameters.

use core::iter::FusedIterator;
use core::marker::PhantomData;
use core::ops::Range;

use crate::domain::{inverse_width, unit};
use crate::vector::vectors;
use crate::{Array, Basis, Curve, CurveError, Form, Point, Scalar};

/// The number of parameters that are mapped to the unit interval at a time.
const TILE: usize = 256;

impl<B: Basis, P: Point<Scalar = B::Scalar>> Curve<B, P> {
    /// The points `out[i] = C(ts[i])`.
    ///
    /// From 16 points on they are computed with the widest vector instructions of the processor; with the feature
    /// `std`, these are found when the program runs. The ends stay exact. Results can differ from [`eval`](Self::eval)
    /// in the last digits, where a product and a sum are rounded at once.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// let curve = Bezier::from_points([[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
    /// let mut points = [[0.0; 2]; 3];
    /// curve.eval_into(&[0.0, 0.5, 1.0], &mut points)?;
    /// assert_eq!(points, [[0.0, 0.0], [2.0, 1.5], [4.0, 0.0]]);
    /// # Ok::<(), basis_runtime::CurveError>(())
    /// ```
    ///
    /// # Errors
    /// [`CurveError::Length`] if the slices have different lengths.
    pub fn eval_into(&self, ts: &[B::Scalar], out: &mut [P]) -> Result<(), CurveError> {
        same_length(ts, out)?;
        for_each_tile::<B>(ts, |first, xs| self.form.eval_into(xs, &mut out[first..first + xs.len()]));
        Ok(())
    }

    /// The points and derivatives with respect to `t`, `out[k][i] = C⁽ᵏ⁾(ts[i])`, in one pass over the parameters.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// let curve = Bezier::from_points([0.0, 8.0, 4.0]);
    /// let (mut points, mut velocities) = ([0.0; 3], [0.0; 3]);
    /// curve.eval_with_derivs_into(&[0.0, 0.5, 1.0], [&mut points, &mut velocities])?;
    /// assert_eq!((points, velocities), ([0.0, 5.0, 4.0], [16.0, 4.0, -8.0]));
    /// # Ok::<(), basis_runtime::CurveError>(())
    /// ```
    ///
    /// # Errors
    /// [`CurveError::Length`] if the slices have different lengths.
    pub fn eval_with_derivs_into<const K: usize>(
        &self,
        ts: &[B::Scalar],
        mut out: [&mut [P::Vector]; K],
    ) -> Result<(), CurveError> {
        for out in &out {
            same_length(ts, out)?;
        }
        let rate = inverse_width(B::domain());
        let form: B::Form<P::Vector> = self.basis().bind(&vectors(self.control_points()));
        for_each_tile::<B>(ts, |first, xs| {
            let out = out.each_mut().map(|out| &mut out[first..first + xs.len()]);
            form.eval_with_derivs_into(xs, rate, out);
        });
        Ok(())
    }

    /// The components of the points in slices of their own: `out[d][i]` is the component `d` of `C(ts[i])`.
    ///
    /// # Errors
    /// [`CurveError::Dimension`] if there is not one slice for each component, [`CurveError::Length`] if a slice has
    /// not the length of `ts`.
    pub fn eval_components_into(
        &self,
        ts: &[B::Scalar],
        out: &mut [&mut [B::Scalar]],
    ) -> Result<(), CurveError> {
        if out.len() != P::DIM {
            return Err(CurveError::Dimension { expected: out.len(), found: P::DIM });
        }
        for (d, out) in out.iter_mut().enumerate() {
            self.component(d).eval_into(ts, out)?;
        }
        Ok(())
    }

    /// The curve of one component, a function of `t`.
    ///
    /// # Panics
    /// If the points have no such component.
    #[inline]
    pub fn component(&self, index: usize) -> Curve<B, B::Scalar> {
        Curve::new(self.basis, B::Points::from_fn(|i| self.points.as_ref()[i].component(index)))
    }

    /// `count` points at equal distances of the parameter, both ends included, exactly; for a count of 1, the start.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// let curve = Bezier::from_points([0.0, 8.0, 4.0]);
    /// assert!(curve.samples(3).eq([0.0, 5.0, 4.0]));
    /// ```
    #[inline]
    pub fn samples(&self, count: usize) -> Samples<P, B::Form<P>> {
        Samples { form: self.form, count, indices: 0..count, points: PhantomData }
    }

    /// [`samples`](Self::samples) that fill a slice, computed as in [`eval_into`](Self::eval_into).
    pub fn samples_into(&self, out: &mut [P]) {
        let count = out.len();
        let mut xs = [B::Scalar::ZERO; TILE];
        for (tile, out) in out.chunks_mut(TILE).enumerate() {
            let xs = &mut xs[..out.len()];
            for (i, x) in xs.iter_mut().enumerate() {
                *x = sample(tile * TILE + i, count);
            }
            self.form.eval_into(xs, out);
        }
    }
}

/// The parameter of a sample in the unit interval: a quotient, because a sum of steps would miss the end.
#[inline]
fn sample<S: Scalar>(index: usize, count: usize) -> S {
    S::from_usize(index) / S::from_usize(count.saturating_sub(1).max(1))
}

/// # Errors
/// [`CurveError::Length`] if the slices have different lengths.
pub(crate) fn same_length<S, P>(ts: &[S], out: &[P]) -> Result<(), CurveError> {
    if ts.len() == out.len() {
        Ok(())
    } else {
        Err(CurveError::Length { expected: ts.len(), found: out.len() })
    }
}

/// Calls `run(first, xs)` with the parameters in the unit interval.
#[inline]
fn for_each_tile<B: Basis>(ts: &[B::Scalar], mut run: impl FnMut(usize, &[B::Scalar])) {
    if B::domain() == [B::Scalar::ZERO, B::Scalar::ONE] {
        return run(0, ts);
    }
    let mut xs = [B::Scalar::ZERO; TILE];
    for (tile, ts) in ts.chunks(TILE).enumerate() {
        let xs = &mut xs[..ts.len()];
        for (x, &t) in xs.iter_mut().zip(ts) {
            [_, *x] = unit(B::domain(), t);
        }
        run(tile * TILE, xs);
    }
}

/// The iterator of [`Curve::samples`].
#[derive(Clone, Debug)]
pub struct Samples<P, F> {
    form: F,
    count: usize,
    indices: Range<usize>,
    points: PhantomData<P>,
}

impl<P: Point, F: Form<P>> Samples<P, F> {
    #[inline]
    fn at(&self, index: usize) -> P {
        self.form.eval(sample(index, self.count))
    }
}

impl<P: Point, F: Form<P>> Iterator for Samples<P, F> {
    type Item = P;

    #[inline]
    fn next(&mut self) -> Option<P> {
        self.indices.next().map(|index| self.at(index))
    }

    #[inline]
    fn nth(&mut self, n: usize) -> Option<P> {
        self.indices.nth(n).map(|index| self.at(index))
    }

    #[inline]
    fn size_hint(&self) -> (usize, Option<usize>) {
        self.indices.size_hint()
    }
}

impl<P: Point, F: Form<P>> DoubleEndedIterator for Samples<P, F> {
    #[inline]
    fn next_back(&mut self) -> Option<P> {
        self.indices.next_back().map(|index| self.at(index))
    }
}

impl<P: Point, F: Form<P>> ExactSizeIterator for Samples<P, F> {}
impl<P: Point, F: Form<P>> FusedIterator for Samples<P, F> {}

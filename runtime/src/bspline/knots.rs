//! Knot vectors: validated on construction, so that nothing after it can fail.

use alloc::vec::Vec;
use core::fmt::{self, Debug, Formatter};

use super::KnotError;
use crate::Scalar;

/// The highest degree of a spline, far above what floating-point numbers can make use of.
pub const MAX_DEGREE: usize = 1023;

/// A knot vector `t[0] <= t[1] <= …` together with the degree `k` of the splines over it.
///
/// There are `n = knots - k - 1` basis functions; the domain is `t[k] <= t <= t[n]`. Knots outside of the domain are
/// allowed (the vector is then *unclamped* at that end), and so are inner knots of multiplicity up to `k + 1`, at which
/// a spline may jump.
///
/// ```
/// use basis_runtime::bspline::{KnotError, KnotVector};
///
/// let knots = KnotVector::new(3, [0.0, 0.0, 0.0, 0.0, 0.4, 1.0, 1.0, 1.0, 1.0])?;
/// assert_eq!(knots.functions(), 5);
/// assert_eq!(knots.domain(), [0.0, 1.0]);
/// assert_eq!(knots, KnotVector::clamped(3, &[0.0, 0.4, 1.0])?);
///
/// let error = KnotVector::new(1, [0.0, 1.0, 0.5, 2.0]).unwrap_err();
/// assert_eq!(error, KnotError::Decreasing { index: 2 });
/// # Ok::<(), KnotError>(())
/// ```
#[derive(Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "crate::serialize::bspline::Knots<S>"))]
#[cfg_attr(
    feature = "serde",
    serde(bound(serialize = "S: serde::Serialize", deserialize = "S: Scalar + serde::Deserialize<'de>"))
)]
pub struct KnotVector<S> {
    degree: usize,
    knots: Vec<S>,
    /// The number of spans of the domain by its length, from which the span of a parameter is guessed.
    #[cfg_attr(feature = "serde", serde(skip_serializing))]
    rate: S,
}

#[allow(clippy::missing_fields_in_debug)] // the rate follows from the others
impl<S: Debug> Debug for KnotVector<S> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_struct("KnotVector").field("degree", &self.degree).field("knots", &self.knots).finish()
    }
}

impl<S: Scalar> KnotVector<S> {
    /// The knot vector of that degree with these knots.
    ///
    /// # Errors
    /// If a knot is not finite, is smaller than the one before it or occurs more than `degree + 1` times, if there are
    /// fewer than `2 (degree + 1)` knots, or if the domain has no length.
    pub fn new(degree: usize, knots: impl Into<Vec<S>>) -> Result<Self, KnotError> {
        let knots = knots.into();
        if degree > MAX_DEGREE {
            return Err(KnotError::Degree { degree });
        }
        if let Some(index) = knots.iter().position(|knot| !knot.is_finite()) {
            return Err(KnotError::NotFinite { index });
        }
        if let Some(index) = knots.windows(2).position(|pair| pair[1] < pair[0]) {
            return Err(KnotError::Decreasing { index: index + 1 });
        }
        let found = knots.len();
        if found / 2 <= degree {
            return Err(KnotError::TooFew { found, degree });
        }
        for group in knots.chunk_by(|a, b| a == b) {
            if group.len() > degree + 1 {
                return Err(KnotError::Multiplicity {
                    knot: group[0].to_f64(),
                    multiplicity: group.len(),
                    degree,
                });
            }
        }
        let (lo, hi) = (knots[degree], knots[found - degree - 1]);
        // Where subnormal numbers are flushed the difference of different knots can be 0.
        if lo >= hi || hi - lo <= S::ZERO {
            return Err(KnotError::EmptyDomain { at: lo.to_f64() });
        }
        if !(knots[found - 1] - knots[0]).is_finite() {
            return Err(KnotError::Overflow);
        }
        Ok(Self::with_rate(degree, knots))
    }

    /// The clamped knot vector with these breakpoints: each end `degree + 1` times, each inner one as often as it is
    /// listed.
    ///
    /// # Errors
    /// As [`new`](Self::new); [`KnotError::EmptyDomain`] for a single breakpoint.
    pub fn clamped(degree: usize, breakpoints: &[S]) -> Result<Self, KnotError> {
        let (first, inner, last) = match breakpoints {
            [] => return Err(KnotError::TooFew { found: 0, degree }),
            [only] => return Err(KnotError::EmptyDomain { at: only.to_f64() }),
            [first, inner @ .., last] => (first, inner, last),
        };
        if degree > MAX_DEGREE {
            return Err(KnotError::Degree { degree });
        }
        let ends = degree + 1;
        let mut knots = Vec::with_capacity(2 * ends + inner.len());
        knots.extend(core::iter::repeat_n(*first, ends));
        knots.extend_from_slice(inner);
        knots.extend(core::iter::repeat_n(*last, ends));
        Self::new(degree, knots)
    }

    /// The clamped knot vector over `0 <= t <= 1` with that many spans of equal length.
    ///
    /// # Errors
    /// [`KnotError::EmptyDomain`] if `spans` is 0; [`KnotError::Degree`] above [`MAX_DEGREE`]; [`KnotError::Memory`].
    pub fn uniform(degree: usize, spans: usize) -> Result<Self, KnotError> {
        if spans == 0 {
            return Err(KnotError::EmptyDomain { at: 0.0 });
        }
        let mut breakpoints = Vec::new();
        if breakpoints.try_reserve_exact(spans.saturating_add(1)).is_err() {
            return Err(KnotError::Memory);
        }
        breakpoints.extend((0..=spans).map(|i| S::from_usize(i) / S::from_usize(spans)));
        Self::clamped(degree, &breakpoints)
    }

    /// The knot vector of closed curves: these breakpoints, continued with their period to both sides by as many knots as
    /// the degree.
    ///
    /// A curve over it is closed and as smooth where its ends meet as at any knot, if its first `degree` control points are
    /// its last ones: [`BSplineCurve::periodic`](super::BSplineCurve::periodic).
    ///
    /// ```
    /// use basis_runtime::bspline::KnotVector;
    ///
    /// let knots = KnotVector::periodic(2, &[0.0, 1.0, 3.0, 4.0])?;
    /// assert_eq!(knots.as_slice(), [-3.0, -1.0, 0.0, 1.0, 3.0, 4.0, 5.0, 7.0]);
    /// assert_eq!((knots.domain(), knots.functions()), ([0.0, 4.0], 5));
    /// # Ok::<(), basis_runtime::bspline::KnotError>(())
    /// ```
    ///
    /// # Errors
    /// As [`new`](Self::new); [`KnotError::TooFew`] for fewer than two breakpoints.
    pub fn periodic(degree: usize, breakpoints: &[S]) -> Result<Self, KnotError> {
        if degree > MAX_DEGREE {
            return Err(KnotError::Degree { degree });
        }
        let (Some(&first), Some(&last), spans @ 1..) =
            (breakpoints.first(), breakpoints.last(), breakpoints.len().saturating_sub(1))
        else {
            return Err(KnotError::TooFew { found: breakpoints.len(), degree });
        };
        let period = last - first;
        // The breakpoint `i` places from the first, in whole turns and the rest.
        let above = |i: usize| breakpoints[i % spans] + period * S::from_usize(i / spans);
        let below = |i: usize| {
            let turns = i.div_ceil(spans);
            breakpoints[turns * spans - i] - period * S::from_usize(turns)
        };
        let mut knots: Vec<S> = (1..=degree).rev().map(below).collect();
        knots.extend_from_slice(breakpoints);
        knots.extend((1..=degree).map(|i| above(spans + i)));
        Self::new(degree, knots)
    }

    /// A vector that is known to be valid.
    pub(super) fn trusted(degree: usize, knots: Vec<S>) -> Self {
        debug_assert!(Self::new(degree, knots.clone()).is_ok(), "invalid knots: {knots:?}");
        Self::with_rate(degree, knots)
    }

    fn with_rate(degree: usize, knots: Vec<S>) -> Self {
        let n = knots.len() - degree - 1;
        let rate = S::from_usize(n - degree) / (knots[n] - knots[degree]);
        Self { degree, knots, rate }
    }

    /// The same knots in double precision.
    pub fn to_f64(&self) -> KnotVector<f64> {
        KnotVector::with_rate(self.degree, self.knots.iter().map(|knot| knot.to_f64()).collect())
    }

    /// The degree.
    #[inline]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The knots.
    #[inline]
    pub fn as_slice(&self) -> &[S] {
        &self.knots
    }

    /// The number of basis functions, and so of control points: `knots - degree - 1`.
    #[inline]
    pub fn functions(&self) -> usize {
        self.knots.len() - self.degree - 1
    }

    /// The ends `[t[k], t[n]]` of the domain.
    #[inline]
    pub fn domain(&self) -> [S; 2] {
        [self.knots[self.degree], self.knots[self.functions()]]
    }

    /// The different knots of the domain, both ends included, in increasing order.
    pub fn breakpoints(&self) -> Vec<S> {
        let mut breakpoints = self.knots[self.degree..=self.functions()].to_vec();
        breakpoints.dedup();
        breakpoints
    }

    /// The indices `i` of the spans `t[i] < t[i + 1]` of the domain that have a length, in increasing order.
    pub fn spans(&self) -> impl Iterator<Item = usize> + '_ {
        (self.degree..self.functions()).filter(|&i| self.knots[i] < self.knots[i + 1])
    }

    /// How often the number occurs among the knots.
    pub fn multiplicity(&self, knot: S) -> usize {
        let below = self.knots.partition_point(|&other| other < knot);
        self.knots[below..].iter().take_while(|&&other| other == knot).count()
    }

    /// The index `i` of the span with `t[i] <= t < t[i + 1]`: where it would be among even knots, or else by bisection.
    ///
    /// The last span includes its right end. Below the domain it is the first span, above it the last one; for NaN the
    /// first.
    #[inline]
    pub fn span(&self, t: S) -> usize {
        let (k, n) = (self.degree, self.functions());
        // The cast takes NaN to 0; to 32 bits it is the fastest, and more spans than that are found by bisection.
        let even = ((t - self.knots[k]) * self.rate).to_f64() as i32;
        let guess = k + (even.max(0) as usize).min(n - k - 1);
        match self.knots[guess..] {
            [from, to, ..] if from <= t && t < to => guess,
            _ => self.searched(t),
        }
    }

    /// The span by bisection. By itself, so that the way of even knots is short enough to be inlined.
    fn searched(&self, t: S) -> usize {
        let (k, n) = (self.degree, self.functions());
        let mut span = k + self.knots[k + 1..n].partition_point(|&knot| knot <= t);
        // At the ends of unclamped vectors the span that was found may have no length.
        while span > k && self.knots[span] == self.knots[n] {
            span -= 1;
        }
        while span + 1 < n && self.knots[span + 1] == self.knots[k] {
            span += 1;
        }
        span
    }

    /// The Greville abscissa of each basis function, the mean of its inner knots: `(t[i+1] + … + t[i+k]) / k`.
    ///
    /// At degree 0 it is the middle of the function's span. Always inside of the domain for clamped vectors.
    pub fn greville(&self) -> Vec<S> {
        let k = self.degree;
        let mean = |knots: &[S]| {
            // The mean of equal numbers is the number itself, so that both ends of a clamped vector are met exactly.
            let first = knots[0];
            let sum = knots.iter().fold(S::ZERO, |sum, &knot| sum + (knot - first));
            first + sum / S::from_usize(knots.len())
        };
        (0..self.functions())
            .map(|i| if k == 0 { mean(&self.knots[i..i + 2]) } else { mean(&self.knots[i + 1..=i + k]) })
            .collect()
    }

    /// Whether both ends of the domain have the multiplicity `k + 1`.
    pub fn is_clamped(&self) -> bool {
        let (k, n) = (self.degree, self.functions());
        self.knots[0] == self.knots[k] && self.knots[n] == self.knots[n + k]
    }

    /// The same knots mapped so that the domain becomes `[lo, hi]`, both of them exactly.
    ///
    /// # Errors
    /// If `lo` or `hi` is not finite or `lo >= hi`, or if different knots coincide after rounding so often that their
    /// multiplicity becomes too large.
    pub fn mapped(&self, [lo, hi]: [S; 2]) -> Result<Self, KnotError> {
        let [a, b] = self.domain();
        let map = |knot: S| {
            let mapped = lo + (hi - lo) * ((knot - a) / (b - a));
            if knot == b {
                hi
            } else if knot > a && knot < b {
                clamp(mapped, lo, hi)
            } else {
                mapped
            }
        };
        Self::new(self.degree, self.knots.iter().map(|&knot| map(knot)).collect::<Vec<_>>())
    }

    /// The knots of the mirrored parameter `lo + hi - t`, where `[lo, hi]` is the domain, which stays the same. If
    /// rounding would make different knots equal it is `-t`, which is exact, over the domain `[-hi, -lo]`.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let [lo, hi] = self.domain();
        let mirror = |knot: S| {
            if knot == lo {
                hi
            } else if knot > lo && knot < hi {
                clamp(lo + (hi - knot), lo, hi)
            } else {
                lo + (hi - knot)
            }
        };
        let mirrored = self.knots.iter().rev().map(|&knot| mirror(knot)).collect::<Vec<_>>();
        match Self::new(self.degree, mirrored) {
            Ok(mirrored) if mirrored.spans().count() == self.spans().count() => mirrored,
            // Exact, and valid because this vector is.
            _ => Self::with_rate(self.degree, self.knots.iter().rev().map(|&knot| -knot).collect()),
        }
    }

    /// The number, if it is inside of the domain.
    ///
    /// # Errors
    /// [`KnotError::Outside`], also for NaN.
    pub fn check(&self, t: S) -> Result<S, KnotError> {
        let [lo, hi] = self.domain();
        if t >= lo && t <= hi {
            Ok(t)
        } else {
            Err(KnotError::Outside { parameter: t.to_f64(), domain: [lo.to_f64(), hi.to_f64()] })
        }
    }

    /// The nearest number of the domain; NaN stays NaN.
    #[inline]
    pub fn clamp(&self, t: S) -> S {
        let [lo, hi] = self.domain();
        clamp(t, lo, hi)
    }
}

fn clamp<S: Scalar>(t: S, lo: S, hi: S) -> S {
    if t < lo {
        lo
    } else if t > hi {
        hi
    } else {
        t
    }
}

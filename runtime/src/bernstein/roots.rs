//! The real zeros of a polynomial in Bernstein form, isolated by Descartes' rule of signs.

use alloc::vec;
use alloc::vec::Vec;

use super::{eval, restrict, split};
use crate::Scalar;
use crate::numeric::binomial::row;

/// Below this depth a piece is narrower than the distance of two floats.
const DEPTH: u32 = 56;

/// A zero of a polynomial.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Root<S> {
    /// Where the zero is.
    pub x: S,
    /// What the polynomial does there.
    pub kind: RootKind,
}

/// What a polynomial does at one of its zeros.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum RootKind {
    /// It has different signs on both sides.
    Crossing,
    /// It has the same sign on both sides.
    Contact,
    /// The interval ends there.
    End,
}

/// The zeros on `[0, 1]`, in increasing order.
///
/// A piece whose coefficients have one sign holds no zero, one with a single change of sign holds exactly one; the
/// others are halved (Descartes' rule in Bernstein form). A piece on which the polynomial is as small as its rounding
/// error counts as one zero: so a zero of even order is found, once, where the derivative has its zero, to the last digits.
/// None for the zero polynomial, and none if a
/// coefficient is not finite.
///
/// ```
/// use basis_runtime::bernstein::{RootKind, roots};
///
/// let p = [2.0_f64, -3.0, 2.0]; // 10 x² - 10 x + 2
/// let [a, b] = roots(&p).try_into().unwrap();
/// assert!((a.x - 0.276393202250021).abs() < 1e-15 && (b.x - 0.723606797749979).abs() < 1e-15);
/// assert_eq!([a.kind, b.kind], [RootKind::Crossing; 2]);
/// ```
pub fn roots<S: Scalar>(coefficients: &[S]) -> Vec<Root<S>> {
    let finite = coefficients.iter().all(|c| c.is_finite());
    let largest = coefficients.iter().fold(S::ZERO, |largest, c| largest.max(c.abs()));
    if !finite || largest == S::ZERO {
        return Vec::new();
    }
    let noise = largest * S::EPSILON * S::from_usize(coefficients.len());
    let mut found = Found { zeros: Vec::new(), cluster: None };
    let mut pieces = vec![Piece { coefficients: coefficients.to_vec(), from: S::ZERO, to: S::ONE, depth: 0 }];
    while let Some(piece) = pieces.pop() {
        piece.search(noise, &mut pieces, &mut found);
    }
    found.close_cluster();
    if coefficients[coefficients.len() - 1] == S::ZERO {
        found.add(S::ONE);
    }
    crossings(coefficients, &merged(coefficients, &found.zeros, noise))
}

/// Zeros between which the polynomial never leaves its rounding error are one.
fn merged<S: Scalar>(coefficients: &[S], zeros: &[[S; 2]], noise: S) -> Vec<S> {
    let middle = |[from, to]: [S; 2]| from + (to - from) * S::of(0.5);
    let mut groups: Vec<[[S; 2]; 2]> = Vec::new();
    let mut between = coefficients.to_vec();
    for &zero in zeros {
        if let Some([_, last]) = groups.last_mut() {
            between.copy_from_slice(coefficients);
            restrict(&mut between, middle(*last), middle(zero));
            if between.iter().all(|c| c.abs() <= S::of(4.0) * noise) {
                *last = zero;
                continue;
            }
        }
        groups.push([zero; 2]);
    }
    let centre = |[first, last]: [[S; 2]; 2]| match [first, last].map(middle) {
        [x, _] if x == S::ZERO => x,
        [_, x] if x == S::ONE => x,
        ends => multiple(coefficients, [first[0], last[1]], noise).unwrap_or(middle(ends)),
    };
    groups.into_iter().map(centre).collect()
}

/// The multiple zero of a polynomial in an interval on which it is zero up to rounding: the simple zero of the first
/// derivative that has one there, whose place the rounding errors of the coefficients hardly move.
fn multiple<S: Scalar>(coefficients: &[S], [from, to]: [S; 2], mut noise: S) -> Option<S> {
    let width = to - from;
    if width <= S::ZERO {
        return None;
    }
    let [low, high] = [(from - width).max(S::ZERO), (to + width).min(S::ONE)];
    let mut derivative = coefficients.to_vec();
    while derivative.len() > 2 {
        noise = noise * S::of(2.0) * S::from_usize(derivative.len() - 1);
        let len = super::differentiate(&mut derivative).len();
        derivative.truncate(len);
        let mut part = derivative.clone();
        restrict(&mut part, low, high);
        for c in &mut part {
            if c.abs() <= noise {
                *c = S::ZERO;
            }
        }
        let ends = [part[0], part[part.len() - 1]];
        if ends.contains(&S::ZERO) || changes_of_sign(&part) != 1 {
            continue;
        }
        let x = low + (high - low) * simple_root(&part);
        return (x >= from && x <= to).then_some(x);
    }
    None
}

/// Says at which zeros the sign changes, from the values between them.
fn crossings<S: Scalar>(coefficients: &[S], zeros: &[S]) -> Vec<Root<S>> {
    let between = |a: S, b: S| eval(coefficients, a + (b - a) * S::of(0.5));
    let before = |k: usize| if k == 0 { S::ZERO } else { zeros[k - 1] };
    let after = |k: usize| zeros.get(k + 1).copied().unwrap_or(S::ONE);
    zeros
        .iter()
        .enumerate()
        .map(|(k, &x)| {
            let kind = if x <= S::ZERO || x >= S::ONE {
                RootKind::End
            } else if (between(before(k), x) < S::ZERO) != (between(x, after(k)) < S::ZERO) {
                RootKind::Crossing
            } else {
                RootKind::Contact
            };
            Root { x, kind }
        })
        .collect()
}

struct Found<S> {
    /// Intervals, most of them of length 0.
    zeros: Vec<[S; 2]>,
    /// An interval of neighbouring pieces on which the polynomial is zero up to rounding.
    cluster: Option<[S; 2]>,
}

impl<S: Scalar> Found<S> {
    fn add(&mut self, x: S) {
        self.close_cluster();
        if self.zeros.last() != Some(&[x; 2]) {
            self.zeros.push([x; 2]);
        }
    }

    fn add_cluster(&mut self, from: S, to: S) {
        match &mut self.cluster {
            Some([_, end]) if *end == from => *end = to,
            _ => {
                self.close_cluster();
                self.cluster = Some([from, to]);
            }
        }
    }

    fn close_cluster(&mut self) {
        self.zeros.extend(self.cluster.take());
    }
}

struct Piece<S> {
    coefficients: Vec<S>,
    from: S,
    to: S,
    depth: u32,
}

impl<S: Scalar> Piece<S> {
    fn search(mut self, noise: S, pieces: &mut Vec<Self>, found: &mut Found<S>) {
        if self.coefficients.iter().all(|c| c.abs() <= noise) {
            return found.add_cluster(self.from, self.to);
        }
        // A zero at the upper end is the lower end of the next piece.
        while self.coefficients[0] == S::ZERO {
            found.add(self.from);
            self.divide_by_x();
        }
        while self.coefficients[self.coefficients.len() - 1] == S::ZERO {
            self.coefficients.reverse();
            self.divide_by_x();
            self.coefficients.reverse();
        }
        match changes_of_sign(&self.coefficients) {
            0 => {}
            1 => found.add(self.from + (self.to - self.from) * simple_root(&self.coefficients)),
            _ if self.depth == DEPTH => found.add_cluster(self.from, self.to),
            _ => {
                let Self { mut coefficients, from, to, depth } = self;
                let depth = depth + 1;
                let middle = from + (to - from) * S::of(0.5);
                let mut right = coefficients.clone();
                split(&mut coefficients, S::of(0.5), &mut right);
                pieces.push(Self { coefficients: right, from: middle, to, depth });
                pieces.push(Self { coefficients, from, to: middle, depth });
            }
        }
    }

    /// `x q = p` has `q[i] = n / (i + 1) p[i + 1]`.
    fn divide_by_x(&mut self) {
        self.coefficients.remove(0);
        let degree = S::from_usize(self.coefficients.len());
        for (i, c) in self.coefficients.iter_mut().enumerate() {
            *c = *c * (degree / S::from_usize(i + 1));
        }
    }
}

/// How often the sign changes from one coefficient to the next; zeros have none.
#[inline]
pub(crate) fn changes_of_sign<S: Scalar>(coefficients: &[S]) -> usize {
    let mut signs = coefficients.iter().filter(|&&c| c != S::ZERO).map(|&c| c > S::ZERO);
    let Some(mut last) = signs.next() else { return 0 };
    signs.filter(|&sign| core::mem::replace(&mut last, sign) != sign).count()
}

/// The only zero of a polynomial with different signs at both ends.
fn simple_root<S: Scalar>(coefficients: &[S]) -> S {
    bracketed_root(&mut coefficients.to_vec(), &mut vec![S::ZERO; coefficients.len()])
}

/// The only zero inside of the interval of a polynomial whose coefficients change their sign once: Newton's method, and
/// halving where it leaves the bracket or does not halve it. Coefficients of zero at the ends, so zeros there, do not
/// matter. Overwrites the coefficients; `scratch` is not shorter.
#[inline] // callers know the degree
pub(crate) fn bracketed_root<S: Scalar>(values: &mut [S], scratch: &mut [S]) -> S {
    let half = S::of(0.5);
    let rising = values.iter().find(|&&c| c != S::ZERO).is_some_and(|&c| c < S::ZERO);
    let mut x = polygon_zero(values, rising);
    // With the binomial coefficients multiplied in, once: both evaluations are then free of divisions.
    let slopes = &mut scratch[..values.len()];
    slopes.copy_from_slice(values);
    let slopes = super::differentiate(slopes);
    multiply_binomials(slopes);
    multiply_binomials(values);
    let [mut lo, mut hi] = [S::ZERO, S::ONE];
    let (mut step, mut before) = (S::ONE, S::ZERO);
    for _ in 0..200 {
        let value = nested(values, x);
        if value == S::ZERO {
            return x;
        }
        if (value < S::ZERO) == rising {
            lo = x;
        } else {
            hi = x;
        }
        let newton = x - value / nested(slopes, x);
        let good = newton > lo && newton < hi && (newton - x).abs() <= step * half;
        let next = if good { newton } else { lo + (hi - lo) * half };
        step = (next - x).abs();
        x = next;
        // After two of Newton's steps, s[k+1] ≈ c s[k]² says that the next one would not change the number.
        let converged = step * step * step <= S::EPSILON * half * x * before * before;
        before = if good { step } else { S::ZERO };
        if converged
            || step <= S::EPSILON * half * x
            || hi - lo <= S::EPSILON * hi
            || next == lo
            || next == hi
        {
            break;
        }
    }
    x
}

/// Where the control polygon, whose corners are the coefficients at `k/n`, leaves its first sign: not where it is zero
/// at the start.
#[inline]
fn polygon_zero<S: Scalar>(coefficients: &[S], rising: bool) -> S {
    let first = |c: S| if rising { c < S::ZERO } else { c > S::ZERO };
    let Some(k) = coefficients.windows(2).position(|pair| first(pair[0]) && !first(pair[1])) else {
        return S::of(0.5);
    };
    let part = coefficients[k] / (coefficients[k] - coefficients[k + 1]);
    (S::from_usize(k) + part) / S::from_usize(coefficients.len() - 1)
}

/// Replaces `c[k]` by `binomial(n, k) c[k]`.
#[inline]
pub(crate) fn multiply_binomials<S: Scalar>(coefficients: &mut [S]) {
    let degree = coefficients.len().saturating_sub(1);
    for (c, binomial) in coefficients.iter_mut().zip(row(degree)) {
        *c = *c * S::of(binomial);
    }
}

/// `Σ (1-x)^(n-k) x^k c[k]`, without binomial coefficients.
#[inline]
fn nested<S: Scalar>(c: &[S], x: S) -> S {
    let Some((&first, rest)) = c.split_first() else { return S::ZERO };
    let s = S::ONE - x;
    let mut power = S::ONE;
    rest.iter().fold(first, |sum, &c| {
        power = power * x;
        sum * s + c * power
    })
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use super::RootKind::{self, Contact, Crossing, End};
    use super::{Root, roots};
    use crate::bernstein::multiply;

    /// The product of linear factors with these zeros.
    fn with_zeros(zeros: &[f64]) -> Vec<f64> {
        zeros.iter().fold(alloc::vec![1.0], |product, zero| {
            let mut next = alloc::vec![0.0; product.len() + 1];
            multiply(&product, &[-zero, 1.0 - zero], &mut next);
            next
        })
    }

    fn assert_roots(zeros: &[f64], expected: &[(f64, RootKind)], tolerance: f64) {
        let found = roots(&with_zeros(zeros));
        assert_eq!(found.len(), expected.len(), "{zeros:?}: {found:?}");
        for (root, &(x, kind)) in found.iter().zip(expected) {
            assert!((root.x - x).abs() <= tolerance, "{zeros:?}: {found:?}");
            assert_eq!(root.kind, kind, "{zeros:?}: {found:?}");
        }
    }

    #[test]
    fn simple_roots_to_the_last_digits() {
        assert_roots(
            &[0.125, 0.3, 0.5, 0.9],
            &[(0.125, Crossing), (0.3, Crossing), (0.5, Crossing), (0.9, Crossing)],
            1e-14,
        );
        assert_roots(&[-0.5, 1.5], &[], 0.0);
        assert_roots(&[1e-9, 0.5], &[(1e-9, Crossing), (0.5, Crossing)], 1e-15);
    }

    #[test]
    fn roots_at_the_ends() {
        assert_roots(&[0.0, 0.0, 1.0], &[(0.0, End), (1.0, End)], 0.0);
        assert_roots(&[0.0, 0.25, 1.0], &[(0.0, End), (0.25, Crossing), (1.0, End)], 1e-15);
    }

    #[test]
    fn multiple_roots_count_once() {
        assert_roots(&[0.5, 0.5], &[(0.5, Contact)], 1e-15);
        assert_roots(&[0.5, 0.5, 0.5], &[(0.5, Crossing)], 1e-15);
        assert_roots(&[0.25, 0.25, 0.25, 0.25, 0.75], &[(0.25, Contact), (0.75, Crossing)], 1e-12);
    }

    #[test]
    fn multiple_roots_to_the_last_digits() {
        let [root] = roots(&[25.0_f64, -35.0, 49.0]).try_into().unwrap(); // (5 - 12 x)²
        assert!((root.x - 5.0 / 12.0).abs() < 1e-16 && root.kind == Contact);
        let single: [Root<f32>; 1] = roots(&[25.0_f32, -35.0, 49.0]).try_into().unwrap();
        assert!((single[0].x - 5.0 / 12.0).abs() < 6e-8);
        // (a (1 - x) - b x)² (c (1 - x) - d x), three times, so that all coefficients are whole numbers.
        for (a, b, c, d) in
            [(5.0, 7.0, 1.0, 9.0), (1.0, 2.0, 3.0, 1.0), (13.0, 4.0, 2.0, 11.0), (3.0, 17.0, 6.0, 5.0)]
        {
            let square: [f64; 3] = [a * a, -a * b, b * b];
            let cubic = [
                3.0 * square[0] * c,
                2.0 * square[1] * c - square[0] * d,
                square[2] * c - 2.0 * square[1] * d,
                -3.0 * square[2] * d,
            ];
            let mut expected = [(a / (a + b), Contact), (c / (c + d), Crossing)];
            expected.sort_by(|a, b| a.0.total_cmp(&b.0));
            let found = roots(&cubic);
            assert_eq!(found.len(), 2, "{cubic:?}: {found:?}");
            for (root, (x, kind)) in found.iter().zip(expected) {
                assert!((root.x - x).abs() < 1e-15 && root.kind == kind, "{cubic:?}: {found:?}");
            }
        }
    }

    #[test]
    fn nothing_to_be_found() {
        let none: [Root<f64>; 0] = [];
        assert_eq!(roots::<f64>(&[]), none);
        assert_eq!(roots(&[0.0, 0.0]), none);
        assert_eq!(roots(&[1.0]), none);
        assert_eq!(roots(&[-1.0, f64::NAN, 1.0]), none);
        assert_eq!(roots(&[-1.0, f64::INFINITY]), none);
    }
}

//! Polynomials in several variables in scaled Bernstein form on boxes whose sides may be infinite.

use super::fibre::{self, Step};
use super::poly::{Poly, Var};
use super::range::Range;
use super::rational::{Rational, Words};
use super::work::Work;
use crate::collections::list::Mapped;

/// A side of a box: a closed interval with at least one finite end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Side {
    /// low ≤ x ≤ high, as x = low·r + high·s.
    Finite(Rational, Rational),
    /// x ≥ low, as x = low + s/r.
    Upwards(Rational),
    /// x ≤ high, as x = high − r/s.
    Downwards(Rational),
}

impl Side {
    /// The side of a cell with this range; `None` for a range without ends.
    pub fn of(range: &Range) -> Option<Self> {
        match (range.low.value(), range.high.value()) {
            (Some(a), Some(b)) => Some(Self::Finite(a.clone(), b.clone())),
            (Some(a), None) => Some(Self::Upwards(a.clone())),
            (None, Some(b)) => Some(Self::Downwards(b.clone())),
            (None, None) => None,
        }
    }

    /// The point s = 1/2.
    pub fn middle(&self) -> Rational {
        match self {
            Self::Finite(a, b) => &(a + b) * &Rational::new(1, 2),
            Self::Upwards(a) => a + &Rational::ONE,
            Self::Downwards(b) => b - &Rational::ONE,
        }
    }

    /// The parts with s ≤ 1/2 and s ≥ 1/2.
    pub fn halves(&self) -> (Self, Self) {
        let m = self.middle();
        match self {
            Self::Finite(a, b) => (Self::Finite(a.clone(), m.clone()), Self::Finite(m, b.clone())),
            Self::Upwards(a) => (Self::Finite(a.clone(), m.clone()), Self::Upwards(m)),
            Self::Downwards(b) => (Self::Downwards(m.clone()), Self::Finite(m, b.clone())),
        }
    }
}

/// A tensor of scaled Bernstein coefficients β, p = Σ β_k ∏ sᵢ^kᵢ rᵢ^(nᵢ−kᵢ) with rᵢ + sᵢ = 1, up to a positive
/// factor; on an infinite side p is multiplied by the power of r or s that makes it a polynomial.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Form {
    /// The degree by axis.
    degrees: Vec<usize>,
    /// Row by row, the last axis fastest.
    coefficients: Vec<Rational>,
}

/// The most coefficients of a form.
const MAX_SIZE: usize = 200_000;

impl Form {
    /// The form on a box; variables of the polynomial without a side must not occur.
    ///
    /// `None` when it is too large or the work is spent.
    pub fn new(poly: &Poly, sides: &[(Var, Side)], work: &mut Work) -> Option<Self> {
        let degrees: Vec<usize> = sides.mapped(|(v, _)| poly.degree(*v) as usize);
        let size =
            degrees.iter().try_fold(1_usize, |n, d| n.checked_mul(d + 1).filter(|n| *n <= MAX_SIZE))?;
        let content = poly.numeric_content();
        let factor = content.recip().unwrap_or(Rational::ONE);
        work.spend((size + 2 * poly.len()) as u64)?;
        let mut coefficients = vec![Rational::ZERO; size];
        for (m, c) in poly.terms() {
            let place = sides
                .iter()
                .zip(&degrees)
                .fold(0, |n, ((v, _), d)| n * (d + 1) + usize::from(m.exponent(*v)));
            coefficients[place] += &(c * &factor);
        }
        let mut form = Self { degrees, coefficients };
        for (axis, (_, side)) in sides.iter().enumerate() {
            let steps = match side {
                Side::Finite(a, b) => fibre::on_interval(a, b),
                Side::Upwards(a) => fibre::upwards(a),
                Side::Downwards(b) => fibre::downwards(b),
            };
            form.along(axis, &steps, work)?;
        }
        Some(form)
    }

    /// The form with these degrees and coefficients, as many as there are places.
    pub const fn of(degrees: Vec<usize>, coefficients: Vec<Rational>) -> Self {
        Self { degrees, coefficients }
    }

    /// The degrees by axis.
    pub fn degrees(&self) -> &[usize] {
        &self.degrees
    }

    /// The coefficients, row by row, the last axis fastest.
    pub fn coefficients(&self) -> &[Rational] {
        &self.coefficients
    }

    /// How far apart neighbours along an axis are.
    pub fn stride(&self, axis: usize) -> usize {
        self.degrees[axis + 1..].iter().map(|d| d + 1).product()
    }

    /// Changes the basis along an axis, fibre by fibre.
    fn along(&mut self, axis: usize, steps: &[Step], work: &mut Work) -> Option<()> {
        let (n, stride) = (self.degrees[axis], self.stride(axis));
        let words = Words::of(self.coefficients.iter());
        let bits = match words {
            Some(words) if words.denom == 1 => Rational::from(words.largest as i64).bits(),
            _ => self.coefficients.iter().map(Rational::bits).max().unwrap_or(0),
        };
        work.spend((self.coefficients.len() * (n + 2)) as u64 * (1 + bits / 64))?;
        if let Some(words) = words
            && let Some(steps) = fibre::word_steps(steps, n + 1, words.largest)
        {
            let mut tensor = self.coefficients.mapped(|c| words.word(c));
            each_fibre(&mut tensor, n, stride, &0, &mut |fibre| fibre::apply_words(&steps, fibre));
            self.coefficients = tensor.mapped(|word| words.number(*word));
        } else {
            each_fibre(&mut self.coefficients, n, stride, &Rational::ZERO, &mut |fibre| {
                fibre::apply(steps, fibre);
            });
        }
        Some(())
    }

    /// The forms on the two parts of the box that is cut in the middle of a side, [`Side::halves`]; `None` when the
    /// work is spent.
    pub fn halves(&self, axis: usize, side: &Side, work: &mut Work) -> Option<(Self, Self)> {
        let (mut low, mut high) = (self.clone(), self.clone());
        let (below, above) = match side {
            Side::Finite(..) => (fibre::lower_half(), fibre::upper_half()),
            _ => (fibre::lower_part(), fibre::upper_part()),
        };
        low.along(axis, &below, work)?;
        high.along(axis, &above, work)?;
        Some((low, high))
    }

    /// The place of a coefficient along an axis.
    fn index(&self, place: usize, axis: usize) -> usize {
        place / self.stride(axis) % (self.degrees[axis] + 1)
    }

    /// Whether a coefficient on a face is not zero; `ends` gives by axis whether the face lies at the high end or
    /// the low one, or runs along the axis.
    pub fn has_support(&self, ends: &[Option<bool>]) -> bool {
        let on_face = |place: usize| {
            ends.iter().enumerate().all(|(axis, end)| match end {
                None => true,
                Some(high) => self.index(place, axis) == if *high { self.degrees[axis] } else { 0 },
            })
        };
        self.coefficients.iter().enumerate().any(|(place, c)| !c.is_zero() && on_face(place))
    }

    /// Whether no coefficient is negative.
    pub fn is_nonnegative(&self) -> bool {
        !self.coefficients.iter().any(Rational::is_negative)
    }
}

/// Changes the fibres of a tensor along an axis with n + 1 places that are a stride apart; those of zeros stay.
fn each_fibre<T: Clone + PartialEq>(
    tensor: &mut [T],
    n: usize,
    stride: usize,
    zero: &T,
    change: &mut dyn FnMut(&mut [T]),
) {
    let mut fibre = vec![zero.clone(); n + 1];
    let mut start = 0;
    while start < tensor.len() {
        let mut any = false;
        let mut i = 0;
        while i <= n {
            let place = start + i * stride;
            any |= tensor[place] != *zero;
            fibre[i].clone_from(&tensor[place]);
            i += 1;
        }
        if any {
            change(&mut fibre);
            let mut i = 0;
            while i <= n {
                tensor[start + i * stride].clone_from(&fibre[i]);
                i += 1;
            }
        }
        start += 1;
        if start % stride == 0 {
            start += n * stride;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn x() -> Poly {
        Poly::var(Var(0))
    }
    fn y() -> Poly {
        Poly::var(Var(1))
    }
    fn n(k: i64) -> Rational {
        Rational::from(k)
    }
    fn unit() -> Side {
        Side::Finite(n(0), n(1))
    }

    #[test]
    fn coefficients_of_a_product() {
        // x (1 − x)² (3 + y) on [0, 1] × [−3, 1]
        let p = &(&x() * &(&Poly::one() - &x()).pow(2)) * &(&Poly::integer(3) + &y());
        let sides = [(Var(0), unit()), (Var(1), Side::Finite(n(-3), n(1)))];
        let form = Form::new(&p, &sides, &mut Work::unlimited()).expect("unlimited");
        assert_eq!(form.degrees(), [3, 1]);
        assert_eq!(form.coefficients(), [0, 0, 0, 4, 0, 0, 0, 0].map(n));
    }

    #[test]
    fn halves_are_the_forms_of_the_halves() {
        let p = &(&(&x().pow(3) * &y()) - &y().pow(2)) + &(&x() - &Poly::integer(2));
        for side in [Side::Finite(n(-1), n(2)), Side::Upwards(Rational::new(1, 2)), Side::Downwards(n(3))] {
            let sides = [(Var(0), side.clone()), (Var(1), unit())];
            let work = &mut Work::unlimited();
            let form = Form::new(&p, &sides, work).expect("unlimited");
            let (low, high) = form.halves(0, &side, work).expect("unlimited");
            let (s, t) = side.halves();
            for (half, side) in [(low, s), (high, t)] {
                let direct = Form::new(&p, &[(Var(0), side), (Var(1), unit())], work).expect("unlimited");
                let first =
                    direct.coefficients().iter().position(|c| !c.is_zero()).expect("not the zero form");
                let factor = &half.coefficients()[first] / &direct.coefficients()[first];
                assert!(factor.is_positive());
                let scaled: Vec<Rational> = direct.coefficients().iter().map(|c| c * &factor).collect();
                assert_eq!(half.coefficients(), scaled);
            }
        }
    }

    #[test]
    fn faces_and_fibres() {
        let p = &(&x() - &y()).pow(2) + &x();
        let form =
            Form::new(&p, &[(Var(0), unit()), (Var(1), unit())], &mut Work::unlimited()).expect("unlimited");
        assert!(!form.has_support(&[Some(false), Some(false)]));
        assert!(form.has_support(&[Some(false), None]));
        assert!(form.is_nonnegative() == form.coefficients().iter().all(|c| c.signum() >= 0));
        assert_eq!(Form::new(&p.pow(5), &[(Var(0), unit()), (Var(1), unit())], &mut Work::new(100)), None);
    }
}

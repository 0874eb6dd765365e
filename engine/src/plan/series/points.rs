//! Polynomials in place of functions on a domain that ends at numbers, such as t − sin t on 0 ≤ t ≤ π/2: span by span
//! from their power series, at both ends of the domain, at 0 and at knots between.
//!
//! Next to an end, and to 0, the first coefficients that are not zero are those of the function, so that a value keeps
//! its digits where the function vanishes; which ones are zero is decided exactly. A series is cut off where its
//! coefficients on the span have fallen below 2⁻⁵⁸ of the first one, or of the largest one on spans inside, and are
//! falling further; the numbers have 192 bits before they become floats. That the rest is as small as that is seen from
//! the coefficients; how far the polynomial is from the function is enclosed afterwards, for bounds of rounding errors
//! ([`residual`](super::residual)).

use basis_prover::collections::list::{Listed, Mapped};
use std::rc::Rc;

#[cfg(any(test, feature = "rounding"))]
use super::residual::Residual;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
#[cfg(any(test, feature = "rounding"))]
use crate::model::Truncation;
use crate::model::angle::{Analytic, Angle, Kind};
use crate::model::{Family, Function, Truncations};

/// The highest power of a series.
const LAST: usize = 30;

/// The highest degree of the polynomials.
const MAX_DEGREE: usize = 24;

/// Spans that are tried.
const SPANS: [i64; 3] = [2, 3, 6];

/// Bits of the numbers.
const BITS: u32 = 192;

/// Derivatives at an end that are looked at for zeros.
const ZEROS: usize = 6;

/// Terms of series of numbers.
const TERMS: i64 = 70;

/// A power series with coefficients that are polynomials in the shape parameters.
type Series = Vec<Poly>;

/// The family on a span as families on several spans whose functions are polynomials; `None` where the ends of the span
/// are parameters, or a shape parameter stands below a fraction line, or the functions have no power series of that
/// kind.
pub(super) fn in_polynomials(family: &Family, truncations: Truncations) -> Option<Vec<Rc<Family>>> {
    let (var, ..) = family.interval()?;
    let angle = family.analytic.angle(var).filter(|a| a.kind != Kind::Linear)?;
    if family.analytic.angles.len() > 1 {
        return None;
    }
    let numbers = Numbers::new(&family.analytic)?;
    let ends = [numbers.of(&angle.limits[0])?, numbers.of(&angle.limits[1])?];
    let source = Source { family, angle, numbers, truncations };
    SPANS.into_iter().find_map(|count| source.on_spans(&ends, count))
}

/// The numbers π, exp(r), tan(r) and tan(π/n) to many digits.
struct Numbers {
    values: Vec<(Var, Rational)>,
}

impl Numbers {
    fn new(analytic: &Analytic) -> Option<Self> {
        let mut values: Vec<(Var, Rational)> =
            analytic.pi.map(|var| (var, Analytic::pi())).into_iter().listed();
        if let Some((var, r)) = &analytic.exponential {
            values.push((*var, exp(r)?));
        }
        if let Some((var, r)) = &analytic.tangent {
            values.push((*var, tangent(Kind::Circular, r)?));
        }
        for root in &analytic.roots {
            let angle = &Analytic::pi() * &Rational::new(1, root.parts);
            values.push((root.var, tangent(Kind::Circular, &angle)?));
        }
        Some(Self { values })
    }

    fn of(&self, f: &Fraction) -> Option<Rational> {
        let put =
            |f: Fraction, (var, x): &(Var, Rational)| f.substitute(*var, &Fraction::constant(x.clone()));
        self.values.iter().try_fold(f.clone(), put)?.as_constant()
    }
}

/// A number with [`BITS`] bits after the point.
fn rounded(x: &Rational) -> Rational {
    let unit = Rational::from(2).pow(BITS);
    (x * &unit).floor().checked_div(&unit).unwrap_or(Rational::ZERO)
}

/// exp(x) for |x| ≤ 32.
fn exp(x: &Rational) -> Option<Rational> {
    if x.abs() > Rational::from(32) {
        return None;
    }
    let part = x * &Rational::new(1, 64);
    let (mut term, mut sum) = (Rational::ONE, Rational::ONE);
    for k in 1..TERMS {
        term = rounded(&(&(&term * &part) * &Rational::new(1, k)));
        sum += &term;
    }
    Some((0..6).fold(sum, |sum, _| rounded(&(&sum * &sum))))
}

/// tan or tanh of an angle below a half turn.
fn tangent(kind: Kind, x: &Rational) -> Option<Rational> {
    let sign = if kind == Kind::Circular { -Rational::ONE } else { Rational::ONE };
    let square = &rounded(&(x * x)) * &sign;
    let sum = |first: Rational, from: i64| {
        let (mut term, mut sum) = (first.clone(), first);
        for k in 0..TERMS {
            let n = from + 2 * k;
            term = rounded(&(&(&term * &square) * &Rational::new(1, (n + 1) * (n + 2))));
            sum += &term;
        }
        sum
    };
    sum(x.clone(), 1).checked_div(&sum(Rational::ONE, 0)).map(|x| rounded(&x))
}

struct Source<'f> {
    family: &'f Family,
    angle: &'f Angle,
    numbers: Numbers,
    truncations: Truncations,
}

/// A place between two spans.
struct Place {
    /// The variable there.
    at: Fraction,
    /// Where functions can be evaluated exactly.
    exact: Option<Exact>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Exact {
    /// At the lower or the upper end of the domain.
    End(usize),
    /// Where the angle is 0.
    Zero,
}

/// The power series of the products yⁱ·tʲ of which functions are made, by i and j, in the distance from a point.
struct Local(Vec<Vec<Vec<Rational>>>);

impl Source<'_> {
    /// The family on a number of spans, or on as many on both sides of 0.
    fn on_spans(&self, ends: &[Rational; 2], count: i64) -> Option<Vec<Rc<Family>>> {
        let limit =
            |side: usize| Place { at: self.angle.limits[side].clone(), exact: Some(Exact::End(side)) };
        let zero = || Place { at: Fraction::zero(), exact: Some(Exact::Zero) };
        let inside = ends[0].is_negative() && ends[1].is_positive() && self.angle.shift.is_zero();
        let parts = if inside {
            vec![
                (limit(0), zero(), [&ends[0], &Rational::ZERO]),
                (zero(), limit(1), [&Rational::ZERO, &ends[1]]),
            ]
        } else {
            vec![(limit(0), limit(1), [&ends[0], &ends[1]])]
        };
        let mut places: Vec<Place> = Vec::new();
        let mut from_above = Vec::new();
        for (first, last, [a, b]) in parts {
            places.pop();
            places.push(first);
            for k in 1..count {
                // Knots that are floats of any kind.
                let unit = Rational::from(64);
                let knot = a + &(&(b - a) * &Rational::new(k, count));
                let at = Fraction::constant((&knot * &unit).floor().checked_div(&unit)?);
                places.push(Place { at, exact: None });
            }
            places.push(last);
            from_above.extend((1..=count).map(|k| k == count));
        }
        let pieces = places.windows(2).zip(from_above);
        pieces.map(|(ends, above)| Some(Rc::new(self.piece(ends, above)?))).collect()
    }

    /// The functions on a span, by their series at its lower or its upper end.
    fn piece(&self, places: &[Place], from_above: bool) -> Option<Family> {
        let family = self.family;
        let ends = [places[0].at.clone(), places[1].at.clone()];
        let [low, high] = [self.numbers.of(&ends[0])?, self.numbers.of(&ends[1])?];
        let width = &high - &low;
        if !width.is_positive() {
            return None;
        }
        let exact = places[usize::from(from_above)].exact;
        let local = self.local(if from_above { &high } else { &low })?;
        // The distance from the point is the width times a number from 0 to 1, negative below the upper end.
        let step = if from_above { -&width } else { width.clone() };
        let var = self.angle.var;
        let y = Poly::var(var);
        let place = if from_above { &Poly::one() - &y } else { y };
        let (mut functions, mut truncations) = (Vec::new(), Vec::new());
        #[cfg(any(test, feature = "rounding"))]
        let residual = (self.truncations == Truncations::Found)
            .then(|| {
                let [first, last] = &ends;
                Residual::new(family, self.angle, if from_above { [last, first] } else { [first, last] })
            })
            .flatten();
        for f in &family.functions {
            let mut series = self.series(&f.value, &local)?;
            let zeros = match exact {
                Some(exact) => self.clear(&f.value, exact, &mut series)?,
                None => 0,
            };
            let mut power = Rational::ONE;
            for c in &mut series {
                *c = c.scale(&power);
                power = rounded(&(&power * &step));
            }
            let (degree, grain) = cut(&series, exact.is_some())?;
            let unit = grain.recip()?;
            for c in &mut series[..=degree] {
                let terms = c.terms().map(|(m, c)| (m.clone(), &(c * &grain).floor() * &unit)).listed();
                *c = Poly::from_terms(terms);
            }
            #[cfg(any(test, feature = "rounding"))]
            truncations.push(residual.as_ref().and_then(|residual| {
                let above = residual.most(f.value.numer(), f.value.denom(), &series[..=degree], zeros)?;
                let order = u32::try_from(zeros).ok()?;
                let ends = if from_above { [0, order] } else { [order, 0] };
                Some(Truncation { above, below: Rational::ZERO, ends, divisor: Poly::one() })
            }));
            #[cfg(not(any(test, feature = "rounding")))]
            {
                let _ = (zeros, self.truncations); // nobody asks without the feature
                truncations.push(None);
            }
            let value = series[..=degree].iter().rev().fold(Poly::zero(), |sum, c| &(&sum * &place) + c);
            functions.push(Function { value: Fraction::from(value), ..f.clone() });
        }
        let mut domain = family.domain.clone();
        let declared = &domain[0].range;
        let end = |own: &End, x: Rational, side: usize| {
            let is_outer = places[side].exact == Some(Exact::End(side));
            if is_outer && !own.is_included() { End::Excluded(x) } else { End::Included(x) }
        };
        domain[0].range =
            Range { low: end(&declared.low, Rational::ZERO, 0), high: end(&declared.high, Rational::ONE, 1) };
        let angle = Angle {
            kind: Kind::Linear,
            rate: Rational::ONE,
            turns: false,
            shift: Rational::ZERO,
            low: ends[0].clone(),
            width: &ends[1] - &ends[0],
            limits: ends,
            mirror: Vec::new(),
            ..self.angle.clone()
        };
        let analytic = Analytic { angles: vec![angle], ..family.analytic.clone() };
        let truncations = Some(truncations);
        Some(Family { domain, functions, analytic, over: Poly::one(), truncations, ..family.clone() })
    }

    /// The series of the variable of the tangent and of the angle itself, and of their powers.
    fn local(&self, at: &Rational) -> Option<Local> {
        let angle = self.angle;
        let pi = Analytic::pi();
        let rate = if angle.turns { &angle.rate * &pi } else { angle.rate.clone() };
        let shift = if angle.turns { angle.shift.clone() } else { &angle.shift * &pi };
        let x0 = tangent(angle.kind, &(&rate * &(at - &shift)))?;
        // x′ = rate·(1 ± x²)
        let sign = if angle.kind == Kind::Circular { Rational::ONE } else { -Rational::ONE };
        let mut x = vec![x0];
        for k in 0..LAST {
            let square = (0..=k).fold(Rational::ZERO, |sum, i| &sum + &(&x[i] * &x[k - i]));
            let one = if k == 0 { Rational::ONE } else { Rational::ZERO };
            let slope = &rate * &(&one + &(&sign * &square));
            x.push(rounded(&(&slope * &Rational::new(1, k as i64 + 1))));
        }
        let (low, width) = (self.numbers.of(&angle.low)?, self.numbers.of(&angle.width)?);
        x[0] -= &low;
        let per = width.recip()?;
        let y = x.mapped(|c| rounded(&(c * &per)));
        let mut t = vec![Rational::ZERO; LAST + 1];
        (t[0], t[1]) = (at.clone(), Rational::ONE);
        let polys = || {
            let own = |f: &Function| [f.value.numer().clone(), f.value.denom().clone()];
            self.family.functions.iter().flat_map(own)
        };
        let powers = |series: &[Rational], var: Var| {
            let degree = polys().map(|p| p.degree(var)).max().unwrap_or(0);
            let mut one = vec![Rational::ZERO; LAST + 1];
            one[0] = Rational::ONE;
            let mut all = vec![one];
            for k in 0..degree as usize {
                all.push(product(&all[k], series));
            }
            all
        };
        let variables = powers(&t, angle.itself);
        Some(Local(powers(&y, angle.var).mapped(|y| variables.mapped(|t| product(y, t)))))
    }

    /// The power series of a polynomial.
    fn of_poly(&self, p: &Poly, local: &Local) -> Series {
        let mut sum: Series = vec![Poly::zero(); LAST + 1];
        let own = [self.angle.var, self.angle.itself];
        for (m, c) in p.terms() {
            let mut factor = c.clone();
            let mut rest: Monomial = own.iter().fold(m.clone(), |m, var| m.with_exponent(*var, 0));
            for (var, x) in &self.numbers.values {
                factor = rounded(&(&factor * &x.pow(u32::from(m.exponent(*var)))));
                rest = rest.with_exponent(*var, 0);
            }
            let [i, j] = own.map(|var| usize::from(m.exponent(var)));
            for (sum, c) in sum.iter_mut().zip(&local.0[i][j]) {
                *sum = &*sum + &Poly::term(rest.clone(), c * &factor);
            }
        }
        sum
    }

    /// The power series of a quotient; `None` where its denominator vanishes or contains shape parameters.
    fn series(&self, f: &Fraction, local: &Local) -> Option<Series> {
        let above = self.of_poly(f.numer(), local);
        let below =
            self.of_poly(f.denom(), local).iter().map(Poly::as_constant).collect::<Option<Vec<_>>>()?;
        let first = below[0]
            .recip()
            .filter(|_| below[0].abs() > Rational::from(2).pow(40).recip().unwrap_or(Rational::ONE))?;
        let mut quotient: Series = Vec::new();
        for (k, c) in above.iter().enumerate() {
            let rest = (0..k).fold(c.clone(), |rest, i| &rest - &quotient[i].scale(&below[k - i]));
            let terms = rest.terms().map(|(m, c)| (m.clone(), rounded(&(c * &first)))).listed();
            quotient.push(Poly::from_terms(terms));
        }
        Some(quotient)
    }

    /// Makes the first coefficients 0 that are, and counts them.
    fn clear(&self, f: &Fraction, place: Exact, series: &mut Series) -> Option<usize> {
        let work = &mut Work::new(20_000_000);
        let mut derivative = f.clone();
        let mut zeros = 0;
        for c in series.iter_mut().take(ZEROS) {
            let value = match place {
                Exact::End(side) => self.family.at_end(&derivative, side == 1, work)?,
                Exact::Zero => {
                    let here = (-&self.angle.low).checked_div(&self.angle.width)?;
                    let value = derivative.substitute_within(self.angle.var, &here, work).ok()??;
                    value.substitute_within(self.angle.itself, &Fraction::zero(), work).ok()??
                }
            };
            if !value.is_zero() {
                break;
            }
            *c = Poly::zero();
            zeros += 1;
            derivative = self.family.derivative_within(&derivative, self.angle.var, work)?;
        }
        Some(zeros)
    }
}

fn product(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
    let coefficient = |k: usize| {
        let sum = (0..=k).fold(Rational::ZERO, |sum, i| {
            if a[i].is_zero() || b[k - i].is_zero() { sum } else { &sum + &(&a[i] * &b[k - i]) }
        });
        rounded(&sum)
    };
    (0..=LAST).map(coefficient).listed()
}

/// The degree at which a series on its span is cut off, and a power of 2 of which the coefficients may be made multiples when
/// it is inverted; `None` if the series does not fall fast enough.
fn cut(series: &[Poly], at_end: bool) -> Option<(usize, Rational)> {
    let size = |c: &Poly| c.terms().map(|(_, c)| c.abs()).max().unwrap_or(Rational::ZERO);
    let sizes: Vec<Rational> = series.iter().map(size).listed();
    let first = sizes.iter().find(|x| !x.is_zero());
    let scale = if at_end { first } else { sizes.iter().max() };
    let Some(scale) = scale.filter(|x| !x.is_zero()).cloned() else { return Some((0, Rational::ONE)) };
    let tiny = &scale * &Rational::from(2).pow(58).recip()?;
    // The last ones tell how the rest falls.
    let faint = &tiny * &Rational::new(1, 1 << 10);
    if sizes[LAST - 3..].iter().any(|x| *x > faint) {
        return None;
    }
    let degree = sizes.iter().rposition(|x| *x > tiny)?;
    let mut grain = Rational::from(2).pow(64);
    while &grain * &scale < Rational::from(2).pow(64) {
        grain = &grain + &grain;
    }
    (degree <= MAX_DEGREE).then_some((degree, grain))
}

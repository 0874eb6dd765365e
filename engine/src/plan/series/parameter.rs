//! Polynomials in place of functions on a domain that ends at a shape parameter α, beside sines or exponentials of t
//! and of α, such as (t − sin t)/(α − sin α) on 0 ≤ t ≤ α.
//!
//! Where t = α·ℓ(y) with ℓ of degree 1 and 0 ≤ y ≤ 1, the numerator and the denominator are power series in α,
//!
//! Σ αⁿ pₙ(ℓ(y)), each pₙ a polynomial of degree ≤ n.
//!
//! Their coefficients are exact. The power of α that numerator and denominator share is divided out, so that a value
//! keeps its digits where α is small, and each pₙ vanishes at an end of the domain where the function does, to the same
//! order. A series is cut off where its terms have fallen below 2⁻⁵⁸ of the first one for the largest α, and are
//! falling further. Then its highest terms are replaced by lower ones, in α and in y, as long as Chebyshev polynomials
//! show that this changes no more than that. How much all this changes at most is added up, for bounds of rounding
//! errors ([`Truncation`]), with what is missing beyond the last term ([`truncation`](super::truncation)).

use std::rc::Rc;

use basis_prover::collections::list::Listed;

use super::waves::{Waves, chebyshev, gcd, negligible};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::angle::{Angle, Kind};
use crate::model::bernstein::to_bernstein;
use crate::model::{Family, Function, Truncation, Truncations};

/// The total degrees in t and α at which the series may end, tried one after the other.
const LAST: [usize; 4] = [32, 48, 64, 80];

/// The highest degree of the polynomials.
const MAX_DEGREE: usize = 64;

/// The last terms of a series, which tell how the rest falls.
const TAIL: usize = 4;

/// The work for writing one function in tangents of t and α.
const WORK: u64 = 20_000_000;

/// The family on a span whose functions are polynomials as near as floats can tell; `None` where the domain does not
/// end at multiples of one shape parameter with a bounded range, or a sine of t stands below a fraction line.
pub(super) fn in_polynomials(family: &Family, truncations: Truncations) -> Option<Family> {
    let source = Source::new(family)?;
    let quotients = family.functions.iter().map(|f| source.quotient(&f.value)).collect::<Option<Vec<_>>>()?;
    LAST.into_iter().find_map(|last| source.of_degree(&quotients, last, truncations))
}

/// The work after which [`longest`] tries no further end.
const SEARCH: u64 = 5_000_000;

/// The ends of a range that [`longest`] tries.
const ENDS: [i64; 7] = [16, 12, 8, 6, 4, 2, 1];

/// The name of the shape parameter whose range is too long for such polynomials, or has no end, and the range with the
/// largest of some numbers as its end that is not; `None` where the range is not what they fail for.
pub(super) fn longest(family: &Family) -> Option<(String, String)> {
    let mut units = 0;
    ENDS.into_iter().find_map(|last| {
        if units > SEARCH {
            return None;
        }
        let last = Rational::from(last);
        let source = Source::within(family, Some(&last))?;
        let (found, done) = basis_prover::measured(&mut || {
            let quotients = family.functions.iter().map(|f| source.quotient(&f.value));
            let quotients = quotients.collect::<Option<Vec<_>>>()?;
            LAST.into_iter().find_map(|terms| source.of_degree(&quotients, terms, Truncations::LeftOut))
        });
        units += done;
        found?;
        let (name, parameter) = (&source.end.name, family.shapes.iter().find(|p| p.var == source.end.var)?);
        let sign = if parameter.range.low.is_included() { "<=" } else { "<" };
        Some((name.clone(), format!("{} {sign} {name} <= {last}", source.end.ends[0])))
    })
}

pub(super) struct Source<'f> {
    pub(super) family: &'f Family,
    /// t
    pub(super) angle: &'f Angle,
    /// α
    pub(super) end: &'f Angle,
    /// t = α·(low + (high − low)·y)
    pub(super) slopes: [Rational; 2],
    /// No |α| is larger.
    pub(super) largest: Rational,
    /// Whether α can be negative.
    is_signed: bool,
    /// The largest absolute values of all other variables; `None` for one without.
    pub(super) others: Vec<(Var, Option<Rational>)>,
}

/// A function as a quotient of sums of sinⁱψ·cosᵏ⁻ⁱψ·tʲ·sinᵖφ·cosᵐ⁻ᵖφ·α^q, φ being to α what ψ is to t.
pub(super) struct Sums {
    /// In tan ψ and tan φ: a numerator, and a denominator without t.
    above: Poly,
    below: Poly,
    /// k
    power: u32,
    /// m
    end_power: u32,
}

/// The coefficients pₙ of a power series in α.
pub(super) type Series = Vec<Poly>;

impl<'f> Source<'f> {
    fn new(family: &'f Family) -> Option<Self> {
        Self::within(family, None)
    }

    /// The same with another end of the range of α, which is above its lower end and below its own.
    fn within(family: &'f Family, last: Option<&Rational>) -> Option<Self> {
        let (var, ..) = family.interval()?;
        let analytic = &family.analytic;
        let plain = |a: &Angle| a.kind != Kind::Linear && !a.turns && a.shift.is_zero();
        let angle = analytic.angle(var).filter(|a| plain(a))?;
        let is_end = |a: &&Angle| a.var != var && angle.limits.iter().any(|limit| limit.depends_on(a.itself));
        let end = analytic.angles.iter().find(is_end).filter(|a| plain(a))?;
        // c·α, as c
        let slope = |limit: &Fraction| {
            limit.checked_div(&Fraction::var(end.itself)).and_then(|slope| slope.as_constant())
        };
        let slopes = [slope(&angle.limits[0])?, slope(&angle.limits[1])?];
        let limit = |side: usize| analytic.number(&end.limits[side]).filter(|_| !end.ends[side].is_empty());
        let low = limit(0)?;
        let high = match (last, limit(1)) {
            (None, high) => high?,
            (Some(last), high) if low < *last && high.as_ref().is_none_or(|high| last < high) => last.clone(),
            _ => return None,
        };
        // A number with few digits.
        let unit = Rational::from(64);
        let largest = &(&(&low.abs().max(high.abs()) * &unit).floor() + &Rational::ONE) * &unit.recip()?;
        let own = [angle.var, angle.itself, end.var, end.itself];
        let mut others = Vec::new();
        for (var, range) in &family.region().ranges {
            if !own.contains(var) {
                others.push((*var, range.finite().map(|(low, high)| low.abs().max(high.abs()))));
            }
        }
        Some(Self { family, angle, end, slopes, largest, is_signed: low.is_negative(), others })
    }

    /// A function in terms of the tangents themselves, wherever they are measured from.
    fn quotient(&self, f: &Fraction) -> Option<Sums> {
        let work = &mut Work::new(WORK);
        let mut f = f.clone();
        // What y is for t contains the tangent of α, which is replaced last.
        for angle in [self.angle, self.end] {
            let y = (&Fraction::var(angle.var) - &angle.low).checked_div(&angle.width)?;
            f = f.substitute_within(angle.var, &y, work).ok()??;
        }
        let x = Poly::var(self.angle.var);
        let (mut above, mut below) = (f.numer().clone(), f.denom().clone());
        let mut take_out = |factor: &Poly| {
            let mut count = 0;
            while let Some(rest) = below.div_exact(factor) {
                below = rest;
                count += 1;
            }
            count
        };
        let power = if self.angle.kind == Kind::Circular {
            2 * take_out(&(&Poly::one() + &(&x * &x)))
        } else {
            let (sum, difference) = (&Poly::one() + &x, &Poly::one() - &x);
            let [a, b] = [take_out(&sum), take_out(&difference)];
            above = &above * &if a < b { sum.pow(b - a) } else { difference.pow(a - b) };
            2 * a.max(b)
        };
        let entire = above.degree(self.angle.var) <= power
            && !below.depends_on(self.angle.var)
            && !below.depends_on(self.angle.itself);
        let end_power = above.degree(self.end.var).max(below.degree(self.end.var));
        entire.then_some(Sums { above, below, power, end_power })
    }

    /// The family with series up to a total degree; `None` if they do not fall fast enough.
    fn of_degree(&self, quotients: &[Sums], last: usize, asked: Truncations) -> Option<Family> {
        let family = self.family;
        let [low, high] = &self.slopes;
        let place = &Poly::constant(low.clone()) + &Poly::var(self.angle.var).scale(&(high - low));
        let (mut functions, mut truncations) = (Vec::new(), Vec::new());
        let mut waves = Vec::new();
        for (f, sums) in family.functions.iter().zip(quotients) {
            if sums.above.is_zero() {
                functions.push(f.clone());
                let zero = Rational::ZERO;
                truncations.push(Some(Truncation {
                    above: zero.clone(),
                    below: zero,
                    ends: [0, 0],
                    divisor: Poly::one(),
                }));
                continue;
            }
            let powers = [[sums.power, sums.end_power], [0, sums.end_power]];
            let above = self.series(&sums.above, powers[0], last, &mut waves);
            let below = self.series(&sums.below, powers[1], last, &mut waves);
            let first = |series: &Series| series.iter().position(|p| !p.is_zero());
            let common = first(&above)?.min(first(&below)?);
            let polynomial = |series: Series| {
                let terms = self.cut(&series[common..])?;
                // The lowest power of α stays the lowest.
                let from = first(&series)?;
                let lowest = Poly::var(self.end.itself).pow((from - common) as u32);
                let dropped = self.in_place(&series[common + terms..], &place);
                let (powers, mut series) =
                    self.without_ends(self.in_place(&series[from..common + terms], &place));
                let missing = self.missing(&series);
                let mut lost = Rational::ZERO;
                self.round(&mut series, &missing, &mut lost);
                self.shorten(&mut series, missing.clone(), &mut lost);
                self.lower_degree(&mut series, missing.clone(), &mut lost);
                self.round(&mut series, &missing, &mut lost);
                let end = Poly::var(self.end.itself);
                let sum = series.iter().rev().fold(Poly::zero(), |sum, p| &(&sum * &end) + p);
                let lost = &lost * &self.largest.pow((from - common) as u32);
                let lost = self.dropped(&dropped, powers, terms).map(|dropped| &lost + &dropped);
                Some((&(&sum * &lowest) * &self.ends(powers), powers, lost))
            };
            let (numer, ends, above) = polynomial(above)?;
            let (denom, _, below) = polynomial(below)?;
            let value = Fraction::normalized(&numer, &denom)?;
            let unit = self.largest.pow(common as u32).recip()?;
            functions.push(Function { value, ..f.clone() });
            if asked == Truncations::LeftOut {
                truncations.push(None);
                continue;
            }
            let ends = if self.vanishes(&f.value, ends) == Some(true) { ends } else { [0, 0] };
            let place = &place;
            let mut whole = |p: &Poly, dropped: Option<Rational>, powers, ends| {
                Some(&dropped? + &(&self.beyond(p, powers, last, ends, place, &mut waves)? * &unit))
            };
            let above = whole(&sums.above, above, powers[0], ends);
            let below = whole(&sums.below, below, powers[1], [0, 0]);
            let truncation = above.zip(below);
            truncations.push(truncation.map(|(above, below)| Truncation {
                above,
                below,
                ends,
                divisor: denom,
            }));
        }
        let truncations = Some(truncations);
        let mut domain = family.domain.clone();
        let declared = &domain[0].range;
        let end = |own: &End, x| if own.is_included() { End::Included(x) } else { End::Excluded(x) };
        domain[0].range =
            Range { low: end(&declared.low, Rational::ZERO), high: end(&declared.high, Rational::ONE) };
        let mut analytic = family.analytic.clone();
        for angle in &mut analytic.angles {
            if angle.var != self.angle.var && angle.var != self.end.var {
                continue;
            }
            (angle.kind, angle.rate) = (Kind::Linear, Rational::ONE);
            if angle.var == self.angle.var {
                (angle.low, angle.width) = (angle.limits[0].clone(), &angle.limits[1] - &angle.limits[0]);
                angle.mirror = Vec::new();
            } else {
                (angle.low, angle.width) = (Fraction::zero(), Fraction::constant(Rational::ONE));
            }
        }
        Some(Family { domain, functions, analytic, over: Poly::one(), truncations, ..family.clone() })
    }

    /// The power series in α of a numerator or denominator made of sines and cosines of t and of α; each coefficient is
    /// a polynomial in t. Each term has `powers[0]` factors that are sines or cosines of t, and `powers[1]` of α.
    pub(super) fn series(
        &self,
        p: &Poly,
        powers: [u32; 2],
        last: usize,
        known: &mut Vec<Rc<Waves>>,
    ) -> Series {
        let [of_angle, of_end] = [(self.angle, powers[0]), (self.end, powers[1])]
            .map(|(angle, power)| Waves::known(angle, power, last, known));
        let own = [self.angle.var, self.angle.itself, self.end.var, self.end.itself];
        // By the powers of the sine of t, and of t.
        let mut groups: Vec<([u32; 2], Series)> = Vec::new();
        for (m, c) in p.terms() {
            let [i, j, above, q] = own.map(|var| u32::from(m.exponent(var)));
            let rest = own.iter().fold(m.clone(), |m, var| m.with_exponent(*var, 0));
            let at = groups.iter().position(|(key, _)| *key == [i, j]).unwrap_or_else(|| {
                groups.push(([i, j], vec![Poly::zero(); last + 1]));
                groups.len() - 1
            });
            let wave = of_end.of(above).iter().enumerate().filter(|(_, c)| !c.is_zero());
            for (n, factor) in wave {
                if let Some(sum) = groups[at].1.get_mut(n + q as usize) {
                    *sum = &*sum + &Poly::term(rest.clone(), c * factor);
                }
            }
        }
        let mut series = vec![Poly::zero(); last + 1];
        for ([i, j], coefficients) in groups {
            for (k, factor) in of_angle.of(i).iter().enumerate().filter(|(_, c)| !c.is_zero()) {
                let from = k + j as usize;
                if from > last {
                    break;
                }
                let term = Poly::var(self.angle.itself).pow(from as u32).scale(factor);
                for (sum, c) in series[from..].iter_mut().zip(&coefficients) {
                    if !c.is_zero() {
                        *sum = &*sum + &(c * &term);
                    }
                }
            }
        }
        series
    }

    /// The number of terms that are kept.
    fn cut(&self, series: &[Poly]) -> Option<usize> {
        let reach = self.slopes[0].abs().max(self.slopes[1].abs());
        let mut power = Rational::ONE;
        let mut sizes = Vec::new();
        for p in series {
            let terms =
                p.terms().map(|(m, c)| &c.abs() * &reach.pow(u32::from(m.exponent(self.angle.itself))));
            sizes.push(&terms.fold(Rational::ZERO, |sum, x| &sum + &x) * &power);
            power = &power * &self.largest;
        }
        let tiny = negligible(sizes.iter().find(|x| !x.is_zero())?);
        let faint = &tiny * &Rational::new(1, 1 << 10);
        if sizes.len() <= TAIL || sizes[sizes.len() - TAIL..].iter().any(|x| *x > faint) {
            return None;
        }
        let terms = sizes.iter().rposition(|x| *x > tiny)? + 1;
        (terms <= MAX_DEGREE + 1).then_some(terms)
    }

    /// The powers i and j of a series in y that is yⁱ(1 − y)ʲ times another one, and this.
    fn without_ends(&self, mut series: Series) -> ([u32; 2], Series) {
        let mut powers = [0; 2];
        for (factor, power) in self.factors().iter().zip(&mut powers) {
            while series.iter().any(|p| !p.is_zero())
                && let Some(rest) = series.iter().map(|p| p.div_exact(factor)).collect::<Option<Series>>()
            {
                series = rest;
                *power += 1;
            }
        }
        (powers, series)
    }

    /// Coefficients in y in place of t/α.
    pub(super) fn in_place(&self, series: &[Poly], place: &Poly) -> Series {
        series.iter().map(|p| p.substitute(self.angle.itself, place)).listed()
    }

    /// y and 1 − y
    fn factors(&self) -> [Poly; 2] {
        let y = Poly::var(self.angle.var);
        [y.clone(), &Poly::one() - &y]
    }

    /// yⁱ(1 − y)ʲ
    pub(super) fn ends(&self, [i, j]: [u32; 2]) -> Poly {
        let [y, s] = self.factors();
        &y.pow(i) * &s.pow(j)
    }

    /// The largest absolute value of a polynomial in y on 0 ≤ y ≤ 1, at most: that of its Bernstein coefficients.
    pub(super) fn size(&self, p: &Poly) -> Rational {
        let own = p.coefficients_in(self.angle.var);
        let degree = own.len().saturating_sub(1) as u32;
        let sum =
            |p: &Poly| p.terms().fold(Rational::ZERO, |sum, (m, c)| &sum + &(&c.abs() * &self.of_others(m)));
        to_bernstein(&own, degree).iter().map(sum).max().unwrap_or(Rational::ZERO)
    }

    /// The largest absolute value of the other variables' part of a term; 1 for one without bounds.
    pub(super) fn of_others(&self, m: &Monomial) -> Rational {
        self.others.iter().fold(Rational::ONE, |product, (var, most)| match most {
            Some(most) => &product * &most.pow(u32::from(m.exponent(*var))),
            None => product,
        })
    }

    /// What may be missing of a series.
    fn missing(&self, series: &[Poly]) -> Rational {
        let first = series.iter().find(|p| !p.is_zero());
        first.map_or(Rational::ZERO, |p| negligible(&self.size(p)))
    }

    /// Replaces the last terms of a series by terms with lower powers of α, as long as no more than `left` is missing
    /// then.
    fn shorten(&self, series: &mut Series, mut left: Rational, lost: &mut Rational) {
        let missing = left.clone();
        let stride = (0..series.len()).filter(|n| !series[*n].is_zero()).fold(0, gcd);
        if stride == 0 || self.is_signed && stride % 2 == 1 {
            return;
        }
        // In w = (α/largest)^stride, which goes from 0 to 1.
        let unit = self.largest.pow(stride as u32);
        while let Some(last) = series.len().checked_sub(1).filter(|last| *last > 0) {
            let p = series[last].clone();
            if !p.is_zero() {
                let (lower, error) = chebyshev(last / stride);
                let mut scale = unit.pow((last / stride) as u32);
                let error = &(&self.size(&p) * &scale) * &error;
                left -= &error;
                if left.is_negative() {
                    return;
                }
                *lost += &error;
                for (i, c) in lower.iter().enumerate() {
                    series[i * stride] = &series[i * stride] + &p.scale(&(c * &scale));
                    scale = scale.checked_div(&unit).unwrap_or(Rational::ZERO);
                }
            }
            series.pop();
            self.round(series, &missing, lost);
        }
    }

    /// Replaces the highest powers of y by lower ones, as long as no more than `left` is missing then.
    fn lower_degree(&self, series: &mut Series, mut left: Rational, lost: &mut Rational) {
        let missing = left.clone();
        let mut table = series.iter().map(|p| p.coefficients_in(self.angle.var)).listed();
        let mut degree = table.iter().map(Vec::len).max().unwrap_or(0).saturating_sub(1);
        while degree > 0 {
            let mut leading =
                table.iter().map(|c| c.get(degree).cloned().unwrap_or_else(Poly::zero)).listed();
            let mut rounded = Rational::ZERO;
            self.round(&mut leading, &missing, &mut rounded);
            let sizes = leading.iter().map(|p| self.size(p));
            let size = sizes.rev().fold(Rational::ZERO, |sum, x| &(&sum * &self.largest) + &x);
            let (lower, error) = chebyshev(degree);
            let error = &size * &error;
            left -= &error;
            if left.is_negative() {
                break;
            }
            *lost += &(&error + &rounded);
            for (own, p) in table.iter_mut().zip(&leading) {
                own.resize(degree, Poly::zero());
                for (c, factor) in own.iter_mut().zip(&lower) {
                    *c = &*c + &p.scale(factor);
                }
            }
            degree -= 1;
        }
        let y = Poly::var(self.angle.var);
        *series =
            table.iter().map(|own| own.iter().rev().fold(Poly::zero(), |sum, c| &(&sum * &y) + c)).listed();
    }

    /// Makes the coefficients multiples of powers of 2, far below what may be missing, so that their numbers stay
    /// short.
    fn round(&self, series: &mut [Poly], missing: &Rational, lost: &mut Rational) {
        let two = Rational::from(2);
        let mut room = missing * &Rational::new(1, 1 << 12);
        let (mut grain, mut power) = (Rational::ONE, Rational::ONE);
        for p in series.iter_mut().filter(|_| !missing.is_zero()) {
            while &room * &grain < Rational::ONE {
                grain = &grain * &two;
            }
            let unit = grain.recip().unwrap_or(Rational::ONE);
            let mut terms = Vec::new();
            for (m, c) in p.terms() {
                let scaled = c * &grain;
                if !scaled.is_integer() {
                    *lost += &(&(&unit * &power) * &self.of_others(m));
                }
                terms.push((m.clone(), &scaled.floor() * &unit));
            }
            *p = Poly::from_terms(terms);
            power = &power * &self.largest;
            room = room.checked_div(&self.largest).unwrap_or(room);
        }
    }
}

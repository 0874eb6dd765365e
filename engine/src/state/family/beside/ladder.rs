//! The ladder of derivatives.
//!
//! **Theorems.** On [a, b] let g be continuous with a derivative inside.
//!
//! 1. *Rise.* g(a) ≥ 0 and g′ ≥ 0 show g ≥ 0, as do g(b) ≥ 0 and g′ ≤ 0. Where the end value is > 0, so is g; where it is 0, and
//!    g′ > 0 (g′ < 0), g > 0 without that end.
//! 2. *Rise and fall.* If g′ is first ≥ 0 and then ≤ 0, g is nowhere below both g(a) and g(b).
//! 3. *Order of signs.* If g′ is first ≥ 0 and then ≤ 0, and g(a) ≥ 0, then g is first ≥ 0 and then ≤ 0 as well. If g′ is first ≤ 0
//!    and then ≥ 0, and g(b) ≤ 0, the same is true of g. It is true of every g with g′ ≤ 0.
//! 4. *Positive factors.* g has the signs of g/A where A > 0. With A the coefficient of the highest power of t, one derivative
//!    of g/A lowers that power. A power of t itself is positive where t is.
//! 5. *Powers.* If k·g − t·g′ ≥ 0 for t > 0, g/tᵏ falls, and g(b) ≥ 0 shows g ≥ 0; at t = 0 by continuity.
//! 6. *Without t.* A quotient N/D with D > 0 is first ≥ 0 and then ≤ 0 if N/(uʲ·vᵏ), u = y − a, v = b − y, j, k ≥ 0, falls:
//!    N′·u·v − N·(j·v − k·u) ≤ 0. This is so if the Bernstein coefficients of N, of degree j + k or less, change their
//!    sign once, at j.
//!
//! Derivatives are in t; of the last one only signs are asked, so that it may be one in the tangent. Which rule is used where is
//! guessed from signs at some points.
//!
//! On the domain a ≤ t ≤ α with a parameter α above a, g ≥ 0 follows for each t > a from the first rule in α as well,
//! on the way from α = t on: from g ≥ 0 at t = α and dg/dα ≥ 0. At t = a it follows by continuity, and g > 0 there is
//! shown by itself.

use basis_prover::collections::list::Listed;

use super::sample::Sample;
use super::{Half, Step, named};
use crate::algebra::divisors::gcd::content;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Poly;
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::claim::Comparison;
use crate::model::angle::{Angle, Kind};
use crate::model::{Family, Function, Parameter};

/// Derivatives that are tried.
const MAX_DEPTH: usize = 7;

pub(super) struct Ladder<'f> {
    pub(super) family: &'f Family,
    pub(super) angle: &'f Angle,
    pub(super) range: &'f Range,
    pub(super) sample: &'f Sample<'f>,
    pub(super) found: Vec<Step>,
    /// The value of the variable where the angle is 0, if only one side of that is looked at.
    pub(super) zero: Option<(Fraction, Half)>,
    pub(super) along: Along,
}

/// What varies on a ladder.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Along {
    /// The variable of the domain, between its ends.
    Variable,
    /// The parameter at the upper end of the domain, from where the variable is on.
    Parameter,
}

/// A function with its name.
#[derive(Clone)]
struct Named {
    of: String,
    value: Fraction,
}

impl Named {
    fn negated(&self) -> Self {
        Self { of: named("-", &self.of), value: -&self.value }
    }
}

/// How the signs of a function follow one another, as far as some points tell.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Signs {
    Up,
    Down,
    UpDown,
    DownUp,
    Other,
}

fn signs_of(rows: &[Vec<i32>]) -> Signs {
    let (mut some, mut down_up, mut up, mut down, mut up_down) = (false, true, true, true, true);
    for row in rows {
        let (mut seen_down, mut seen_up) = (false, false);
        for sign in row.iter().filter(|s| **s != 0) {
            some = true;
            if *sign > 0 {
                (seen_up, down) = (true, false);
                up_down &= !seen_down;
            } else {
                (seen_down, up) = (true, false);
                down_up &= !seen_up;
            }
        }
    }
    match (some, up, down, up_down, down_up) {
        (_, true, ..) => Signs::Up,
        (_, _, true, ..) => Signs::Down,
        (_, _, _, true, _) => Signs::UpDown,
        (_, _, _, _, true) => Signs::DownUp,
        _ => Signs::Other,
    }
}

impl<'f> Ladder<'f> {
    pub(super) const fn new(
        family: &'f Family,
        angle: &'f Angle,
        range: &'f Range,
        sample: &'f Sample<'f>,
    ) -> Self {
        Self { family, angle, range, sample, found: Vec::new(), zero: None, along: Along::Variable }
    }

    /// What is enough for a function to be ≥ 0, or > 0.
    pub(super) fn start(&mut self, of: &str, value: &Fraction, strict: bool, work: &mut Work) -> Option<()> {
        self.positive(&Named { of: String::from(of), value: value.clone() }, strict, MAX_DEPTH, work)
    }

    fn push(&mut self, step: &Named, strict: bool, work: &mut Work) {
        if self.along == Along::Parameter
            && let Some(steps) = alone(self.family, &step.of, &step.value, strict, work)
        {
            self.found.extend(steps);
            return;
        }
        let comparison = if strict { Comparison::Greater } else { Comparison::GreaterEqual };
        self.found.push(Step::new(step.of.clone(), step.value.clone(), comparison));
    }

    fn slope(&self, g: &Named, work: &mut Work) -> Option<Named> {
        let value = self.family.derivative_within(&g.value, self.angle.var, work)?;
        Some(Named { of: format!("D({})", g.of), value })
    }

    /// The value at an end that belongs to the domain, or at which there is one.
    fn at(&self, g: &Named, side: usize, work: &mut Work) -> Option<Named> {
        if self.along == Along::Parameter {
            let value = self.family.at_end(&g.value, true, work).filter(|_| side == 0)?;
            return Some(Named { of: format!("{} at the end", g.of), value });
        }
        if self.angle.ends[side].is_empty() {
            return None;
        }
        if let Some((zero, half)) = &self.zero
            && side == usize::from(*half == Half::Below)
        {
            let value = g.value.substitute_within(self.angle.itself, &Fraction::zero(), work).ok()??;
            let value = value.substitute_within(self.angle.var, zero, work).ok()??;
            return Some(Named { of: format!("{} at 0", g.of), value });
        }
        let value = self.family.at_end(&g.value, side == 1, work)?;
        Some(Named { of: format!("{} at {}", g.of, self.angle.ends[side]), value })
    }

    fn is_included(&self, side: usize) -> bool {
        if self.along == Along::Parameter {
            return self.family.domain.first().is_none_or(|p| p.range.high.is_included());
        }
        let inner = self.zero.as_ref().is_some_and(|(_, half)| side == usize::from(*half == Half::Below));
        inner || [&self.range.low, &self.range.high][side].is_included()
    }

    fn signs(&self, g: &Named, work: &mut Work) -> Signs {
        self.sample.signs(&g.value, work).map_or(Signs::Other, |rows| signs_of(&rows))
    }

    fn may_be_nonnegative(&self, g: &Named, work: &mut Work) -> bool {
        matches!(self.signs(g, work), Signs::Up)
    }

    /// Tries something and forgets its steps if it leads nowhere.
    fn attempt(&mut self, what: impl FnOnce(&mut Self) -> Option<()>) -> Option<()> {
        let before = self.found.len();
        let done = what(self);
        if done.is_none() {
            self.found.truncate(before);
        }
        done
    }

    /// g ≥ 0, or g > 0.
    fn positive(&mut self, g: &Named, strict: bool, depth: usize, work: &mut Work) -> Option<()> {
        if !g.value.depends_on(self.angle.itself) {
            self.push(g, strict, work);
            return Some(());
        }
        let depth = depth.checked_sub(1)?;
        if !self.may_be_nonnegative(g, work) {
            return None;
        }
        if self.along == Along::Parameter && is_alone(self.family, &g.value) {
            self.push(g, strict, work);
            return Some(());
        }
        if g.value.denom().depends_on(self.angle.itself) {
            return self.attempt(|ladder| {
                let above = ladder.without_denominator(g, depth, work)?;
                ladder.positive(&above, strict, depth, work)
            });
        }
        if let Some((simpler, fine)) = self.without_power(g, strict) {
            return if fine { self.positive(&simpler, strict, depth, work) } else { None };
        }
        if !strict && let Some([factor, rest]) = self.product(g, work) {
            self.push(&factor, false, work);
            return self.positive(&rest, false, depth, work);
        }
        let done = self.attempt(|ladder| {
            let simpler = ladder.divided(g, work)?;
            ladder.by_slope(&simpler, strict, depth, work)
        });
        let done = done.or_else(|| self.attempt(|ladder| ladder.by_slope(g, strict, depth, work)));
        done.or_else(|| self.attempt(|ladder| ladder.by_power(g, strict, depth, work)))
    }

    /// g ≥ 0 since g falls when it is divided by the highest power of the variable in it, and is ≥ 0 at the upper end.
    fn by_power(&mut self, g: &Named, strict: bool, depth: usize, work: &mut Work) -> Option<()> {
        let var = self.angle.itself;
        let fits = self.along == Along::Variable && self.zero.is_none() && self.angle.limits[0].is_zero();
        if !fits || strict && self.is_included(0) {
            return None;
        }
        let power = g.value.numer().degree(var);
        let last = self.at(g, 1, work).filter(|v| self.may_be_nonnegative(v, work))?;
        let slope = self.slope(g, work)?;
        let all = g.value.mul_within(&Fraction::constant(Rational::from(i64::from(power))), work)?;
        let value = all.sub_within(&slope.value.mul_within(&Fraction::var(var), work)?, work)?;
        let falls = Named { of: format!("{power}*({}) - {}*{}", g.of, self.angle.name, slope.of), value };
        // Where the power has a factor that varies the next one is higher.
        if falls.value.numer().degree(var) >= power || self.signs(&falls, work) != Signs::Up {
            return None;
        }
        let open = strict && !self.is_included(1) && last.value.is_zero();
        self.push(&last, strict && !open, work);
        self.positive(&falls, open, depth, work)
    }

    /// The function as a product of a polynomial and of what its terms share, if that depends on the tangent: both ≥ 0, as far
    /// as some points tell.
    fn product(&self, g: &Named, work: &mut Work) -> Option<[Named; 2]> {
        let shared = content(g.value.numer(), self.angle.itself, work)?;
        if !shared.depends_on(self.angle.var) {
            return None;
        }
        let rest = g.value.numer().div_exact(&shared)?.into();
        let shared = Fraction::new(shared, g.value.denom().clone())?;
        let factor = Named { of: format!("a factor of {}", g.of), value: shared };
        let rest = Named { of: format!("({})/({})", g.of, factor.of), value: rest };
        match (self.signs(&factor, work), self.signs(&rest, work)) {
            (Signs::Up, Signs::Up) => Some([factor, rest]),
            (Signs::Down, Signs::Down) => Some([factor.negated(), rest.negated()]),
            _ => None,
        }
    }

    fn by_slope(&mut self, g: &Named, strict: bool, depth: usize, work: &mut Work) -> Option<()> {
        if !g.value.depends_on(self.angle.itself) {
            self.push(g, strict, work);
            return Some(());
        }
        let slope = self.slope(g, work)?;
        let (first, last) = (self.at(g, 0, work), self.at(g, 1, work));
        let monotone = match self.signs(&slope, work) {
            Signs::Up => Some((0, first.clone(), slope.clone())),
            Signs::Down => Some((1, last.clone(), slope.negated())),
            Signs::UpDown => None,
            Signs::DownUp | Signs::Other => return None,
        };
        if let Some((side, value, slope)) = monotone {
            let value = value.filter(|v| self.may_be_nonnegative(v, work))?;
            // Without the end itself it is enough that the derivative is positive.
            let open = strict && !self.is_included(side) && value.value.is_zero();
            self.push(&value, strict && !open, work);
            return self.positive(&slope, open, depth, work);
        }
        for value in [first?, last?] {
            if !self.may_be_nonnegative(&value, work) {
                return None;
            }
            self.push(&value, strict, work);
        }
        self.falls(&slope, depth, work)
    }

    /// g is first ≥ 0 and then ≤ 0.
    fn falls(&mut self, g: &Named, depth: usize, work: &mut Work) -> Option<()> {
        let depth = depth.checked_sub(1)?;
        match self.signs(g, work) {
            Signs::Up => return self.positive(g, false, depth, work),
            Signs::Down => return self.positive(&g.negated(), false, depth, work),
            Signs::UpDown => {}
            Signs::DownUp | Signs::Other => return None,
        }
        if !g.value.depends_on(self.angle.itself) {
            // Bounds for a parameter beside its sine go ill with the change of sign, which the slope does without.
            if is_beside(self.family, &g.value) {
                let slope = self.slope(g, work)?;
                if self.signs(&slope, work) == Signs::Down {
                    return self.positive(&slope.negated(), false, depth, work);
                }
            }
            return self.falls_without(g, work);
        }
        if g.value.denom().depends_on(self.angle.itself) {
            return self.attempt(|ladder| {
                let above = ladder.without_denominator(g, depth, work)?;
                ladder.falls(&above, depth, work)
            });
        }
        if let Some((simpler, true)) = self.without_power(g, false) {
            return self.falls(&simpler, depth, work);
        }
        let done = self.attempt(|ladder| {
            let simpler = ladder.divided(g, work)?;
            ladder.falls_by_slope(&simpler, depth, work)
        });
        done.or_else(|| self.attempt(|ladder| ladder.falls_by_slope(g, depth, work)))
    }

    fn falls_by_slope(&mut self, g: &Named, depth: usize, work: &mut Work) -> Option<()> {
        let slope = self.slope(g, work)?;
        match self.signs(&slope, work) {
            Signs::Down => self.positive(&slope.negated(), false, depth, work),
            Signs::UpDown => {
                let first = self.at(g, 0, work).filter(|v| self.may_be_nonnegative(v, work))?;
                self.push(&first, false, work);
                self.falls(&slope, depth, work)
            }
            Signs::DownUp => {
                let last = self.at(g, 1, work)?.negated();
                if !self.may_be_nonnegative(&last, work) {
                    return None;
                }
                self.push(&last, false, work);
                self.falls(&slope.negated(), depth, work)
            }
            Signs::Up | Signs::Other => None,
        }
    }

    /// The function without a power of the variable that all its terms share, where the variable is ≥ 0, or > 0 if needed.
    fn without_power(&self, g: &Named, strict: bool) -> Option<(Named, bool)> {
        let var = self.angle.itself;
        let power = g.value.numer().terms().map(|(m, _)| m.exponent(var)).min().unwrap_or(0);
        if power == 0 || g.value.denom().depends_on(var) {
            return None;
        }
        let above = g.value.numer().div_exact(&Poly::var(var).pow(u32::from(power)))?;
        let value = Fraction::new(above, g.value.denom().clone())?;
        let above = self.zero.as_ref().is_some_and(|(_, half)| *half == Half::Above);
        let from_zero = self.angle.limits[0].is_zero() || above;
        let is_positive = match self.along {
            Along::Variable => !self.is_included(0),
            Along::Parameter => !self.range.low.is_included(),
        };
        let fine = from_zero && (!strict || is_positive);
        from_zero.then(|| (Named { of: format!("({})/{}", g.of, self.angle.name), value }, fine))
    }

    /// What stands above the fraction line, with the sign of the function, where what stands below has one sign.
    fn without_denominator(&mut self, g: &Named, depth: usize, work: &mut Work) -> Option<Named> {
        let mut below =
            Named { of: format!("the denominator of {}", g.of), value: g.value.denom().clone().into() };
        let mut above =
            Named { of: format!("the numerator of {}", g.of), value: g.value.numer().clone().into() };
        match self.signs(&below, work) {
            Signs::Up => {}
            Signs::Down => (below, above) = (below.negated(), above.negated()),
            _ => return None,
        }
        self.positive(&below, true, depth, work)?;
        Some(above)
    }

    /// The function divided by the coefficient of the highest power of the variable, where that is positive.
    fn divided(&mut self, g: &Named, work: &mut Work) -> Option<Named> {
        let var = self.angle.itself;
        if g.value.denom().depends_on(var) {
            return None;
        }
        let leading = g.value.numer().coefficients_in(var).pop()?;
        let leading = Fraction::new(leading, g.value.denom().clone())?;
        if !leading.depends_on(self.angle.var) {
            return None;
        }
        let mut factor =
            Named { of: format!("the factor of {} in {}", self.angle.name, g.of), value: leading };
        let rows = self.sample.signs(&factor.value, work)?;
        if rows.iter().flatten().all(|s| *s < 0) {
            factor = factor.negated();
        } else if rows.iter().flatten().any(|s| *s <= 0) {
            return None;
        }
        self.push(&factor, true, work);
        let value = g.value.div_within(&factor.value, work).ok()??;
        Some(Named { of: format!("({})/({})", g.of, factor.of), value })
    }

    /// A function without the variable beside its sine is first ≥ 0 and then ≤ 0.
    fn falls_without(&mut self, g: &Named, work: &mut Work) -> Option<()> {
        if self.zero.is_some() {
            return None;
        }
        let var = self.angle.var;
        let (low, high) = self.range.finite()?;
        let mut below =
            Named { of: format!("the denominator of {}", g.of), value: g.value.denom().clone().into() };
        let mut above = g.value.numer().clone();
        match self.signs(&below, work) {
            Signs::Up => {}
            Signs::Down => (below, above) = (below.negated(), -&above),
            _ => return None,
        }
        let degree = above.degree(var).max(1);
        let j = [0, 2, 4, 8, 16]
            .into_iter()
            .find_map(|more| self.place_of_change(&above, degree + more, work))?;
        let (j, k) = j;
        let (u, v) =
            (&Poly::var(var) - &Poly::constant(low.clone()), &Poly::constant(high.clone()) - &Poly::var(var));
        let uv = &u * &v;
        let slope = above.derivative(var);
        work.spend_product(&slope, &uv)?;
        let change = &v.scale(&j) - &u.scale(&k);
        let value = &(&above * &change) - &(&slope * &uv);
        self.push(&below, true, work);
        self.push(
            &Named { of: format!("that {} changes its sign once", g.of), value: value.into() },
            false,
            work,
        );
        Some(())
    }

    /// The exponents j and k for the only change of sign of the Bernstein coefficients at all shape values that are looked at.
    fn place_of_change(&self, p: &Poly, degree: u32, work: &mut Work) -> Option<(Rational, Rational)> {
        let (low, high) = self.range.finite()?;
        let (mut after, mut before) = (0_usize, degree as usize);
        for coefficients in self.sample.bernstein(p, self.angle.var, (low, high), degree, work)? {
            let last = coefficients.iter().rposition(|s| *s > 0).unwrap_or(0);
            let first = coefficients.iter().position(|s| *s < 0).unwrap_or(degree as usize);
            if last >= first {
                return None;
            }
            (after, before) = (after.max(last), before.min(first));
        }
        if after > before {
            return None;
        }
        let j = Rational::new((after + before) as i64, 2);
        let k = &Rational::from(i64::from(degree)) - &j;
        Some((j, k))
    }
}

/// The shape parameters that stand beside their sines in a value.
pub(super) fn beside<'f>(family: &'f Family, value: &Fraction) -> Vec<(&'f Parameter, &'f Angle)> {
    let all = family.shapes.iter().filter_map(|p| family.analytic.angle(p.var).map(|angle| (p, angle)));
    let fits = |angle: &Angle| angle.kind != Kind::Linear && angle.itself != angle.var;
    all.filter(|(_, angle)| fits(angle) && value.depends_on(angle.itself)).listed()
}

/// Whether there is one.
fn is_beside(family: &Family, value: &Fraction) -> bool {
    !beside(family, value).is_empty()
}

/// Whether the variable of the domain plays no part.
pub(super) fn is_alone(family: &Family, value: &Fraction) -> bool {
    family.domain.iter().all(|p| {
        let itself = family.analytic.angle(p.var).map_or(p.var, |angle| angle.itself);
        !value.depends_on(p.var) && !value.depends_on(itself)
    })
}

/// What is enough for a function of shape parameters to be ≥ 0, or > 0, by derivatives in the one that stands beside its sine.
pub(super) fn alone(
    family: &Family,
    of: &str,
    value: &Fraction,
    strict: bool,
    work: &mut Work,
) -> Option<Vec<Step>> {
    if !is_alone(family, value) || !family.constraints.is_empty() {
        return None;
    }
    let all = beside(family, value);
    let [(own, angle)] = all.as_slice() else { return None };
    let (domain, shapes) = family.shapes.iter().cloned().partition(|p| p.var == own.var);
    let function = Function { index: Vec::new(), value: value.clone() };
    let along = Family {
        functions: vec![function],
        pieces: Vec::new(),
        over: Poly::one(),
        simplices: Vec::new(),
        shapes,
        domain,
        ..family.clone()
    };
    let sample = Sample::new(&along, work)?;
    let mut ladder = Ladder::new(&along, angle, &own.range, &sample);
    ladder.start(of, value, strict, work)?;
    let whole = (own.var, own.range.clone());
    Some(ladder.found.into_iter().map(|step| Step { ranges: vec![whole.clone()], ..step }).listed())
}

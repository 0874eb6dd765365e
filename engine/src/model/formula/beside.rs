//! What has to be decided of angles: that the distance between ends is positive, and that denominators in which a variable
//! stands beside its sine or exponential do not vanish.

use basis_prover::collections::list::Mapped;
use std::rc::Rc;

use basis_kernel::{Domain, Relation, Statement};
use basis_prover::simple;

use crate::algebra::divisors::gcd::content;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::decimals;
use crate::model::angle::enclosure::{self, Anchor, From};
use crate::model::angle::{Analytic, Angle, Kind};
use crate::model::chart::{self, Constraint};
use crate::model::obligation::{Goal, Open};
use crate::model::scope::Scope;

impl Scope<'_> {
    /// A denominator with all numbers between their bounds in place of angles beside their sines.
    pub(super) fn between_bounds(
        analytic: &Analytic,
        divisor: &Poly,
        mut domain: Domain,
    ) -> Option<(Poly, Rc<Domain>)> {
        const LEVEL: u32 = 5;
        const WORK: u64 = 20_000_000;
        let typical = domain.region.ranges.mapped(|(var, range)| (*var, simple(range)));
        let (mut p, work) = (divisor.clone(), &mut Work::new(WORK));
        for angle in analytic.angles.iter().rev() {
            if angle.kind != Kind::Linear && angle.itself != angle.var && p.depends_on(angle.itself) {
                let range = domain.region.range(angle.var);
                let from = From { anchor: Anchor::Zero, range: &range, n: LEVEL, typical: &typical };
                p = enclosure::without(&p, analytic, angle, &from, true, work)?.pop()?;
                domain.region.ranges.push((angle.itself, Range::unit()));
            }
        }
        Some((p, Rc::new(domain)))
    }

    /// A denominator for all positive values of parameters in exponentials whose ranges end at positive numbers: in
    /// terms of their own tangents, as exp(r) does not occur then. `None` where there is no such parameter.
    pub(super) fn for_all_positive(&self, divisor: &Poly, domain: &Domain) -> Option<(Poly, Rc<Domain>)> {
        let (mut value, mut analytic) = (Fraction::from(divisor.clone()), self.analytic.clone());
        let (mut domain, mut found) = (domain.clone(), false);
        for k in 0..analytic.angles.len() {
            let Angle { var, low, width, kind, .. } = analytic.angles[k].clone();
            let is_tangent = low.is_zero() && width.as_constant() == Some(Rational::ONE);
            if kind != Kind::Hyperbolic || self.domain.contains(&var) || is_tangent {
                continue;
            }
            self.analytic.number(&low).filter(|x| !x.is_negative())?;
            let y = (&Fraction::var(var) - &low).checked_div(&width)?;
            value = value.substitute(var, &y)?;
            for angle in &mut analytic.angles {
                (angle.low, angle.width) = (angle.low.substitute(var, &y)?, angle.width.substitute(var, &y)?);
            }
            let own = &mut analytic.angles[k];
            (own.low, own.width) = (Fraction::zero(), Fraction::constant(Rational::ONE));
            domain.region.ranges.retain(|(v, _)| *v != var);
            let open = |x: Rational| End::Excluded(x);
            domain.region.ranges.push((var, Range { low: open(Rational::ZERO), high: open(Rational::ONE) }));
            found = true;
        }
        if !found {
            return None;
        }
        Self::between_bounds(&analytic, value.numer(), domain)
    }

    /// A denominator in which an angle stands beside its sine as a factor without the tangent and the rest, as of sin(t)/t.
    pub(super) fn apart(&self, divisor: &Poly) -> Option<(Poly, Poly)> {
        const WORK: u64 = 1_000_000;
        let mixed = |a: &&Angle| a.kind != Kind::Linear && a.itself != a.var && divisor.depends_on(a.itself);
        let mut angles = self.analytic.angles.iter().filter(mixed).filter(|a| divisor.depends_on(a.var));
        angles.find_map(|angle| {
            let first = content(divisor, angle.var, &mut Work::new(WORK))?;
            let second = divisor.div_exact(&first)?;
            (first.as_constant().is_none() && second.as_constant().is_none()).then_some((first, second))
        })
    }

    /// A denominator that holds angles and not their tangents, with these running from end to end in their place; `None` of any
    /// other one.
    pub(super) fn without_tangents(&self, divisor: &Poly, domain: &Domain) -> Option<Poly> {
        let mut value = Fraction::from(divisor.clone());
        for angle in self.analytic.angles.iter().rev() {
            if angle.kind == Kind::Linear || angle.itself == angle.var || !value.depends_on(angle.itself) {
                continue;
            }
            if value.depends_on(angle.var) || angle.ends.iter().any(String::is_empty) {
                return None;
            }
            value = value.substitute(angle.itself, &angle.along(&domain.region.range(angle.var))?)?;
        }
        (value.numer() != divisor).then(|| value.numer().clone())
    }

    /// Where an angle that runs from end to end is at a value of its variable, as a number if it is one.
    pub(super) fn value_along(&self, var: Var, x: &Rational, domain: &Domain) -> Option<String> {
        let angle = self.analytic.angle(var)?;
        let place = angle.along(&domain.region.range(var))?;
        let place = place.substitute(var, &Fraction::constant(x.clone()))?;
        if let Some(x) = place.as_constant() {
            return Some(format!("{} = {x}", angle.name));
        }
        let number = self.analytic.number(&place)?;
        Some(format!("{} = {} (rounded)", angle.name, decimals::fixed(&number, 6)))
    }

    /// The end of the range of a variable beside its sine or exponential, if it belongs to it, at which a denominator is 0.
    pub(super) fn vanishing_end(&self, divisor: &Poly, domain: &Domain) -> Option<(&Angle, usize)> {
        let mixed = |a: &&Angle| a.kind != Kind::Linear && a.itself != a.var && divisor.depends_on(a.itself);
        let is_zero = |angle: &Angle, end: usize| {
            let range = domain.region.range(angle.var);
            let side = [&range.low, &range.high][end];
            let (true, Some(y)) = (side.is_included() && !angle.ends[end].is_empty(), side.value()) else {
                return false;
            };
            let there = Fraction::from(divisor.at(angle.var, y)).substitute(angle.itself, &angle.limits[end]);
            there.is_some_and(|f| self.analytic.reduced(f).is_zero())
        };
        let angles = self.analytic.angles.iter().filter(mixed);
        angles.flat_map(|angle| [(angle, 0), (angle, 1)]).find(|(angle, end)| is_zero(angle, *end))
    }

    /// Whether a function of shape parameters is positive on a box; where it is not, or that it is undecided.
    ///
    /// # Errors
    /// The point as text.
    pub(crate) fn is_positive(
        &mut self,
        value: &Fraction,
        region: &Region,
        constraints: &[Constraint],
    ) -> Result<(), String> {
        let constraints = constraints.mapped(|c| (c.value.clone(), c.relation));
        for piece in chart::pieces(&region.ranges, &constraints) {
            let (domain, relation) = (Rc::new(piece.domain()), Relation::Positive);
            let goal = |value| Goal::Holds(Statement::Sign { value, relation, domain });
            let of = format!("{} > 0", value.display(&self.names));
            match self.judge(of, piece.pull_back_fraction(value).map(goal), 1) {
                Ok(()) => {}
                Err(Open::Fails(point)) => {
                    return Err(format!("at {}", self.own(value.numer(), &piece.image(&point))));
                }
                Err(Open::Undecided(left)) => return Err(left),
            }
        }
        Ok(())
    }
}

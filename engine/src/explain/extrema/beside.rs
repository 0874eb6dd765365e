//! Zeros and extrema of functions in which a variable stands beside its sine or exponential.
//!
//! Between bounds of the angle a function has bounds. Where those of its derivative have a sign, the signs at two
//! points tell whether there is a zero between them. Next to an end at which the function and some of its derivatives
//! vanish, exactly, it has no other zero as far as the first derivative that does not vanish has a sign. What is
//! neither is cut in two.

use super::interval::{Interval, QuotientInTwo, values};
use super::multiples::{Exact, exact};
use super::numbers::about;
use super::{Extrema, Extremum, Found, put};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::Family;
use crate::model::angle::enclosure::{inverse, pi_bounds};
use crate::model::angle::{Analytic, Angle};
use basis_prover::collections::list::{Listed, Mapped};

/// The derivatives that are looked at.
const ORDER: usize = 6;
/// How many parts of the domain are looked at for the zeros of one function.
const PARTS: u32 = 250;
/// How often an interval with a zero is halved.
const HALVINGS: u32 = 44;
/// The level of the bounds of angles.
const LEVEL: u32 = 24;

/// What is known of a function, at the values that shape parameters have; `None` when the work is spent.
pub(super) fn of_function(
    family: &Family,
    (label, f): (&str, &Fraction),
    shapes: &[(Var, Rational)],
    work: &mut Work,
) -> Option<Found> {
    let (var, low, high) = family.interval()?;
    let open = || {
        Found::Open(String::from(
            "a variable stands in it beside its sine or exponential, and its zeros were not separated",
        ))
    };
    let Some(angle) = family.analytic.angle(var) else {
        return Some(Found::Open(String::from("it contains an angle of another variable")));
    };
    let fixed = shapes.iter().map(|(var, x)| (*var, Interval::point(x))).listed();
    let mut all =
        Derivatives { family, angle, ends: [low, high], all: Vec::new(), bounded: Vec::new(), fixed };
    all.fix_numbers();
    let mut derivative = put(f, shapes)?;
    for _ in 0..ORDER {
        let vars = [angle.var, angle.itself];
        match QuotientInTwo::new(&derivative, vars, &all.fixed) {
            Some(bounded) => all.bounded.push(bounded),
            None => return Some(open()),
        }
        all.all.push(derivative.clone());
        let next = family.derivative_within(&derivative, var, work)?;
        // The tangent between two ends brings them back.
        derivative = put(&next, shapes)?;
    }
    Some(all.found(label, work).unwrap_or_else(open))
}

/// A function and its derivatives.
struct Derivatives<'f> {
    family: &'f Family,
    angle: &'f Angle,
    /// Those of the range of the variable of the angle.
    ends: [&'f Rational; 2],
    all: Vec<Fraction>,
    /// The same for bounds of its variables.
    bounded: Vec<QuotientInTwo>,
    /// Bounds of the numbers, and of shape parameters.
    fixed: Vec<(Var, Interval)>,
}

/// A point: an end, or a short interval.
enum Place {
    Low,
    High,
    /// What it is exactly, if that is known.
    Between(Interval, Option<Exact>),
}

impl Derivatives<'_> {
    /// Adds bounds of the numbers, and of the shape parameters that stand beside their sines.
    fn fix_numbers(&mut self) {
        let analytic: &Analytic = &self.family.analytic;
        for var in analytic.numbers() {
            let range = analytic.ranges.iter().find(|(v, _)| *v == var).and_then(|(_, range)| range.finite());
            let bounds = if Some(var) == analytic.pi {
                pi_bounds().clone()
            } else {
                let Some((low, high)) = range else { continue };
                (low.clone(), high.clone())
            };
            self.fixed.retain(|(v, _)| *v != var);
            self.fixed.push((var, Interval::new(bounds.0, bounds.1)));
        }
        for angle in analytic.angles.iter().filter(|a| a.var != self.angle.var && a.itself != a.var) {
            let own = self.fixed.iter().find(|(v, _)| *v == angle.var).map(|(_, x)| x.clone());
            if let Some(bounds) = own.and_then(|y| self.itself(angle, &y)) {
                self.fixed.push((angle.itself, bounds));
            }
        }
    }

    /// Bounds of an angle for those of its variable.
    fn itself(&self, angle: &Angle, y: &Interval) -> Option<Interval> {
        let at = [&self.fixed[..], &[(angle.var, y.clone())]].concat();
        let x = values(&angle.tangent(), &at)?;
        let (low, high) = (inverse(angle.kind, &x.low, LEVEL)?.0, inverse(angle.kind, &x.high, LEVEL)?.1);
        let (below, above) = pi_bounds();
        let pi = Interval::new(below.clone(), above.clone());
        let shift = Interval::point(&angle.shift);
        let rate = Interval::point(&angle.rate);
        let (speed, shift) = if angle.turns { (pi.mul(&rate), shift) } else { (rate, shift.mul(&pi)) };
        Some(Interval::new(low, high).div(&speed)?.add(&shift))
    }

    /// Bounds of a derivative between two numbers.
    fn bounds(&self, order: usize, y: &Interval) -> Option<Interval> {
        self.bounded.get(order)?.values([y, &self.itself(self.angle, y)?])
    }

    /// The value at an end, exactly.
    fn at_end(&self, order: usize, upper: bool, work: &mut Work) -> Option<Fraction> {
        self.family.at_end(self.all.get(order)?, upper, work)
    }

    fn is_zero_at_end(&self, order: usize, upper: bool, work: &mut Work) -> Option<bool> {
        Some(self.at_end(order, upper, work)?.is_zero())
    }

    /// Whether a derivative is seen to have one sign between two numbers, the angle between two others: by its
    /// bounds, or by those of its slope.
    fn has_sign(&self, order: usize, y: &Interval, s: &Interval) -> bool {
        let of = |order: usize| self.bounded.get(order)?.values([y, s]);
        let is_signed = |x: Option<Interval>| x.and_then(|x| x.sign()).is_some_and(|sign| sign != 0);
        let by_slope = || {
            let middle = Interval::point(&y.middle());
            let at = self.itself(self.angle, &middle)?;
            let step = s.add(&Interval::point(&Rational::from(-1)).mul(&at));
            Some(self.bounded.get(order)?.values([&middle, &at])?.add(&of(order + 1)?.mul(&step)))
        };
        is_signed(of(order)) || is_signed(by_slope())
    }

    /// The zeros of a derivative inside of the domain.
    fn zeros(&self, order: usize, work: &mut Work) -> Option<Vec<Interval>> {
        let [low, high] = self.ends;
        // The first derivative that does not vanish at each end.
        let mut first = [order; 2];
        for (upper, first) in [false, true].into_iter().zip(&mut first) {
            while self.is_zero_at_end(*first, upper, work)? {
                *first += 1;
            }
        }
        let mut found = Vec::new();
        let mut waiting = vec![Interval::new(low.clone(), high.clone())];
        let mut parts = 0;
        while let Some(part) = waiting.pop() {
            parts += 1;
            work.spend(2_000)?;
            if parts > PARTS {
                return None;
            }
            let at_ends = [&part.low == low && first[0] > order, &part.high == high && first[1] > order];
            let itself = self.itself(self.angle, &part)?;
            let has_sign = |order: usize| self.has_sign(order, &part, &itself);
            let is_done = match at_ends {
                [false, false] => has_sign(order),
                [true, false] => has_sign(first[0]),
                [false, true] => has_sign(first[1]),
                [true, true] => false,
            };
            if is_done {
                continue;
            }
            if at_ends == [false, false] && has_sign(order + 1) {
                let sign = |x: &Rational| self.bounds(order, &Interval::point(x))?.sign().filter(|s| *s != 0);
                if sign(&part.low)? * sign(&part.high)? == -1 {
                    found.push(self.narrowed(order, part));
                }
                continue;
            }
            // Not in the middle, where a zero may be.
            let cut = &part.low + &(&(&part.high - &part.low) * &Rational::new(33, 64));
            waiting.push(Interval::new(cut.clone(), part.high));
            waiting.push(Interval::new(part.low, cut));
        }
        Some(found)
    }

    /// A shorter interval around a zero at which the sign changes.
    fn narrowed(&self, order: usize, mut part: Interval) -> Interval {
        let sign = |x: &Rational| self.bounds(order, &Interval::point(x)).and_then(|x| x.sign());
        let Some(first) = sign(&part.low) else { return part };
        for _ in 0..HALVINGS {
            let middle = part.middle();
            match sign(&middle) {
                Some(own) if own == first => part.low = middle,
                Some(own) if own == -first => part.high = middle,
                _ => break,
            }
        }
        part
    }

    /// What the only zero of a derivative between two numbers is exactly, if that is known.
    fn exact(&self, order: usize, y: &Interval, work: &mut Work) -> Option<Exact> {
        let s = self.itself(self.angle, y)?;
        exact((&self.family.analytic, self.angle), self.all.get(order)?, [y, &s], work)
    }

    fn found(&self, label: &str, work: &mut Work) -> Option<Found> {
        let zeros = self.zeros(0, work)?;
        let middle = &(self.ends[0] + self.ends[1]) * &Rational::new(1, 2);
        let at_middle = self.bounds(0, &Interval::point(&middle)).and_then(|x| x.sign());
        if zeros.is_empty() && at_middle == Some(1) {
            return Some(Found::Nonnegative);
        }
        let mut values = Vec::new();
        for (upper, place) in [(false, Place::Low), (true, Place::High)] {
            let exact = self.at_end(0, upper, work)?;
            let bounds = super::interval::values(&exact, &self.fixed)?;
            values.push((bounds, Some(exact), place));
        }
        for part in self.zeros(1, work)? {
            let bounds = self.bounds(0, &part)?;
            let known = self.exact(1, &part, work);
            let value = known.as_ref().and_then(|known| {
                let y = Fraction::constant(known.y.clone()?);
                let value = self.all.first()?.substitute_within(self.angle.var, &y, work).ok()??;
                value.substitute_within(self.angle.itself, &known.itself, work).ok()?
            });
            values.push((bounds, value, Place::Between(part, known)));
        }
        let least = values.iter().map(|(bounds, ..)| &bounds.high).min()?;
        if !least.is_negative() {
            return None;
        }
        let greatest = values.iter().map(|(bounds, ..)| &bounds.low).max()?;
        let minimum = self.extremum(&values.iter().filter(|(x, ..)| &x.low <= least).listed());
        let maximum = self.extremum(&values.iter().filter(|(x, ..)| &x.high >= greatest).listed());
        let mut places = Vec::new();
        for part in zeros {
            let known = self.exact(0, &part, work);
            places.push(Place::Between(part, known));
        }
        let mut zeros = places;
        if self.is_zero_at_end(0, false, work)? {
            zeros.insert(0, Place::Low);
        }
        if self.is_zero_at_end(0, true, work)? {
            zeros.push(Place::High);
        }
        let zeros = zeros.mapped(|place| self.place(place));
        Some(Found::Known(Box::new(Extrema { zeros, ..Extrema::new(label, minimum, maximum) })))
    }

    /// The value that some points have as far as their bounds tell.
    fn extremum(&self, all: &[&(Interval, Option<Fraction>, Place)]) -> Extremum {
        let exact = all.iter().find_map(|(_, exact, _)| exact.as_ref());
        let dependent = self.family.analytic.dependent();
        let numbers = self.family.analytic.numbers();
        let is_written =
            |f: &&Fraction| !dependent.iter().any(|var| f.depends_on(*var) && !numbers.contains(var));
        let value = match exact.filter(is_written) {
            Some(exact) => super::super::written(self.family, exact),
            None => all.first().map_or_else(String::new, |(bounds, ..)| about(&bounds.middle())),
        };
        Extremum { value, at: all.mapped(|(_, _, place)| self.place(place)), on: Vec::new() }
    }

    fn place(&self, place: &Place) -> String {
        let x = match place {
            Place::Low => self.angle.ends[0].clone(),
            Place::High => self.angle.ends[1].clone(),
            Place::Between(_, Some(known)) => known.text.clone(),
            Place::Between(y, None) => {
                self.itself(self.angle, y).map_or_else(String::new, |s| about(&s.middle()))
            }
        };
        format!("{} = {x}", self.angle.name)
    }
}

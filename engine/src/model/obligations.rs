//! What must hold everywhere on the declared ranges for a formula to mean something: denominators do not vanish, and
//! values that are put in place of a parameter stay in its range.

use super::budget::{SPLIT, TooLarge};
use super::scope::{Scope, Subject};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range, Region};
use crate::algebra::rational::Rational;
use crate::decide::{Budget, Coordinate, Decision, Relation, decide};
use crate::diagnostic::{Diagnostic, Place};

/// Something to be proved before a formula is used.
#[derive(Clone, Debug)]
pub(super) struct Obligation {
    pub(super) duty: Duty,
    pub(super) place: Place,
}

/// What is to be proved.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Duty {
    /// This stands below a fraction line.
    Nonzero(Poly),
    /// This value of a parameter stays in its range.
    Inside(Inside),
}

/// A value for a parameter.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Inside {
    pub(super) value: Fraction,
    /// The parameter.
    pub(super) name: String,
    pub(super) range: Range,
    /// The family that has the parameter, if it is another one.
    pub(super) family: Option<String>,
    /// Whether `assume` can narrow the ranges, as in theorems.
    pub(super) assumable: bool,
}

impl Inside {
    /// The error for a number that is not in the range.
    pub(super) fn outside(&self, value: &Rational, place: Place) -> Diagnostic {
        let Self { name, range, .. } = self;
        let message = format!(
            "{name} = {value} is outside of the declared range `{}`{}",
            range.display(name),
            self.of()
        );
        let help = match &self.family {
            Some(family) => format!("choose a value inside, or widen the range in `{family}`"),
            None => String::from(
                "claims are about the declared ranges; widen the range, or choose a value inside",
            ),
        };
        Diagnostic::error(place, message).help(help)
    }

    /// What to do about a value, as it is shown, that goes beyond an end of the range.
    fn help(&self, shown: &str, end: &End, above: bool) -> String {
        if !self.assumable {
            return String::from("narrow the ranges so that the value stays inside");
        }
        let symbol = match (above, end.is_included()) {
            (true, true) => "<=",
            (true, false) => "<",
            (false, true) => ">=",
            (false, false) => ">",
        };
        let limit = end.value().map_or_else(String::new, |bound| format!("{shown} {symbol} {bound}"));
        match self.value.numer().variables().as_slice() {
            [var] if self.value == Fraction::var(*var) => format!("restrict the scalar: `assume {limit};`"),
            _ => format!("restrict the scalars, such as by `assume`, so that {limit}"),
        }
    }

    fn of(&self) -> String {
        self.family.as_ref().map_or_else(String::new, |family| format!(" of `{family}`"))
    }
}

impl Duty {
    /// The same about other functions; `None` when one of them becomes meaningless.
    fn replace(&self, with: &dyn Fn(&Fraction) -> Option<Fraction>) -> Option<Self> {
        match self {
            Self::Nonzero(p) => Some(Self::Nonzero(with(&Fraction::from(p.clone()))?.numer().clone())),
            Self::Inside(inside) => {
                Some(Self::Inside(Inside { value: with(&inside.value)?, ..inside.clone() }))
            }
        }
    }
}

impl Scope<'_> {
    /// Notes that a value must stay in the range of a parameter.
    pub(super) fn must_stay_inside(&mut self, inside: Inside, place: Place) {
        self.obligations.push(Obligation { duty: Duty::Inside(inside), place });
    }

    /// Puts values in place of variables into the obligations from position `from` on: they are about these values only.
    pub(super) fn fix_obligations(&mut self, from: usize, vars: &[Var], by: &[Fraction]) {
        let put = |f: &Fraction| {
            let pairs = vars.iter().zip(by);
            pairs.into_iter().try_fold(f.clone(), |f, (var, value)| f.substitute(*var, value))
        };
        for obligation in &mut self.obligations[from..] {
            if let Some(duty) = obligation.duty.replace(&put) {
                obligation.duty = duty;
            }
        }
    }

    /// Proves what has been noted, on a box; reports what fails, and whether everything holds.
    pub(super) fn settle(&mut self, region: &Region, budget: u32) -> bool {
        let mut fine = true;
        for Obligation { duty, place } in core::mem::take(&mut self.obligations) {
            if self.settled.contains(&duty) {
                continue;
            }
            if self.budget.run().is_stopped() {
                return false;
            }
            let (before, at) = (crate::decide::spent(), place.clone());
            let error = match &duty {
                Duty::Nonzero(divisor) => self.check_divisor_on(divisor, place, region, budget),
                Duty::Inside(inside) => self.check_inside(inside, place, region, budget),
            };
            let spent = (crate::decide::spent() - before) / u64::from(budget.max(1));
            if let Err(TooLarge::Run(message)) = self.budget.run().decision(spent) {
                self.report(Diagnostic::error(at, message).help(SPLIT));
                return false;
            }
            fine &= error.is_none();
            match error {
                Some(error) => self.report(error),
                None => self.settled.push(duty),
            }
        }
        fine
    }

    /// A denominator must not vanish anywhere on the declared ranges.
    fn check_divisor_on(
        &self,
        divisor: &Poly,
        place: Place,
        region: &Region,
        budget: u32,
    ) -> Option<Diagnostic> {
        let shown = divisor.display(&self.names);
        Some(match zero(divisor, region, budget) {
            Zero::Nowhere => return None,
            Zero::At(point) => {
                // A value at which the denominator is zero, whatever the others are, says it best.
                let alone = point.iter().find_map(|(var, c)| match c {
                    Coordinate::Rational(x) if divisor.at(*var, x).is_zero() => Some((*var, x)),
                    _ => None,
                });
                let (at, help) = match alone {
                    Some((var, x)) => (
                        format!("{} = {x}", self.names[var.0]),
                        self.without_value(var, x, &region.range(var)),
                    ),
                    None => (
                        self.own(divisor, &point),
                        String::from("narrow the declared ranges so that they leave this value out"),
                    ),
                };
                Diagnostic::error(place, format!("the denominator vanishes at {at}"))
                    .label(format!("this is {shown}"))
                    .help(help)
            }
            Zero::Undecided(left) => Diagnostic::error(
                place,
                "it is undecided whether the denominator vanishes on the declared ranges",
            )
            .label(format!("this is {shown}"))
            .note(left)
            .help("raise the budget, such as `budget 10;`, or narrow the ranges"),
        })
    }

    /// How to leave a value out of the range of a parameter or scalar.
    fn without_value(&self, var: Var, value: &Rational, range: &Range) -> String {
        let name = &self.names[var.0];
        let at = |end: &End| end.value() == Some(value);
        if self.subject == Subject::Theorem && range.finite().is_none() && !at(&range.low) && !at(&range.high)
        {
            return format!("give it a range without {value}: `scalar {value} < {name};`");
        }
        let excluded = End::Excluded(value.clone());
        let (sign, narrowed) = if at(&range.high) {
            ("<", Range { high: excluded, ..range.clone() })
        } else {
            (">", Range { low: excluded, ..range.clone() })
        };
        if self.subject == Subject::Theorem {
            format!("leave this value out: `assume {name} {sign} {value};`")
        } else {
            format!("leave this value out: `shape {};`", narrowed.display(name))
        }
    }

    /// A value must stay in the range of the parameter that it stands for.
    fn check_inside(
        &self,
        inside: &Inside,
        place: Place,
        region: &Region,
        budget: u32,
    ) -> Option<Diagnostic> {
        let Inside { value, name, range, .. } = inside;
        let of = inside.of();
        if let Some(c) = value.as_constant() {
            return (!range.contains(&c)).then(|| inside.outside(&c, place));
        }
        for (end, above) in [(&range.low, false), (&range.high, true)] {
            let (bound, relation) = match end {
                End::Infinite => continue,
                End::Included(x) => (x, Relation::NonNegative),
                End::Excluded(x) => (x, Relation::Positive),
            };
            let distance = value - &Fraction::constant(bound.clone());
            let distance = if above { -&distance } else { distance };
            // The denominator does not vanish on the ranges: times its square is times a positive number.
            let sign = distance.numer() * distance.denom();
            let shown = value.display(&self.names);
            let declared = range.display(name);
            return Some(match decide(&sign, relation, region, &mut Budget::scaled(budget)) {
                Decision::Proved(_) => continue,
                Decision::Refuted(witness) => Diagnostic::error(
                    place,
                    format!("{name} = {shown} leaves the declared range `{declared}`{of}"),
                )
                .label(format!("at {}", self.own(&sign, &witness.point)))
                .help(inside.help(&shown, end, above)),
                Decision::Undecided(left) => Diagnostic::error(
                    place,
                    format!("it is undecided whether {name} = {shown} stays in the range `{declared}`{of}"),
                )
                .note(left)
                .help("raise the budget, such as `budget 10;`, or narrow the ranges"),
            });
        }
        None
    }

    /// The coordinates of a point that a polynomial depends on, as text.
    fn own(&self, p: &Poly, point: &[(Var, Coordinate)]) -> String {
        let own = point.iter().filter(|(v, _)| p.depends_on(*v));
        let parts: Vec<String> = own.map(|(v, c)| c.describe(&self.names[v.0])).collect();
        parts.join(", ")
    }
}

/// Whether and where a polynomial vanishes.
enum Zero {
    /// It is different from zero everywhere.
    Nowhere,
    /// It is zero here.
    At(Vec<(Var, Coordinate)>),
    /// The budget is spent; what is left to decide.
    Undecided(String),
}

/// A zero of a polynomial in a box: the box is connected, so that a polynomial without zeros has one sign.
fn zero(polynomial: &Poly, region: &Region, budget: u32) -> Zero {
    let positive = match decide(polynomial, Relation::Positive, region, &mut Budget::scaled(budget)) {
        Decision::Proved(_) => return Zero::Nowhere,
        Decision::Refuted(witness) => witness,
        Decision::Undecided(left) => return Zero::Undecided(left),
    };
    if positive.value.is_zero() {
        return Zero::At(positive.point);
    }
    let negative = match decide(&-polynomial, Relation::Positive, region, &mut Budget::scaled(budget)) {
        Decision::Proved(_) => return Zero::Nowhere,
        Decision::Refuted(witness) => witness,
        Decision::Undecided(left) => return Zero::Undecided(left),
    };
    if negative.value.is_zero() {
        return Zero::At(negative.point);
    }
    between(polynomial, &positive.point, &negative.point, budget)
}

/// A zero between two points at which the signs differ: on the way from one to the other along the axes, which
/// stays inside the box.
fn between(polynomial: &Poly, a: &[(Var, Coordinate)], b: &[(Var, Coordinate)], budget: u32) -> Zero {
    let mut at = a.to_vec();
    for k in 0..at.len() {
        let var = at[k].0;
        let next = b.iter().find(|(v, _)| *v == var).map_or_else(|| at[k].1.clone(), |(_, c)| c.clone());
        let (Coordinate::Rational(from), Coordinate::Rational(to)) = (at[k].1.clone(), next) else {
            return Zero::Undecided(String::from(
                "the sign of the denominator changes on the declared ranges",
            ));
        };
        let mut edge = polynomial.clone();
        for (other, c) in at.iter().filter(|(v, _)| *v != var) {
            if let Coordinate::Rational(c) = c {
                edge = edge.at(*other, c);
            }
        }
        let (low, high) = if from <= to { (from, to.clone()) } else { (to.clone(), from) };
        let range = Region { ranges: vec![(var, Range::closed(low, high))] };
        // The square is positive unless the denominator vanishes; for one variable this is always decided.
        match decide(&(&edge * &edge), Relation::Positive, &range, &mut Budget::scaled(budget)) {
            Decision::Refuted(witness) => {
                let zero = witness.point.into_iter().find(|(v, _)| *v == var);
                if let Some((_, c)) = zero {
                    at[k].1 = c;
                }
                return Zero::At(at);
            }
            Decision::Undecided(left) => return Zero::Undecided(left),
            Decision::Proved(_) => at[k].1 = Coordinate::Rational(to),
        }
    }
    Zero::Undecided(String::from("the sign of the denominator changes on the declared ranges"))
}

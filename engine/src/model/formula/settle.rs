//! What must hold everywhere on the declared ranges for a formula to mean something: denominators do not vanish, and
//! values that are put in place of a parameter stay in its range.

use basis_prover::collections::list::Listed;
use basis_prover::collections::sort::sort_by;
use std::rc::Rc;

use basis_kernel::{Domain, Relation, Statement};
use basis_prover::Coordinate;

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{DisplayRange as _, End, Range};
use crate::algebra::rational::Rational;
use crate::decimals;
use crate::diagnostic::{Diagnostic, Place};
use crate::model::angle::{Angle, Kind, without_brackets};
use crate::model::budget::{SPLIT, TooLarge};
use crate::model::chart::Piece;
use crate::model::obligation::{Goal, Obligation, Open};
use crate::model::scope::{Condition, Duty, Inside, Pending, Scope, Stage, Subject};

/// What is left where a value has too many terms in the variables of a box.
const TOO_LONG: &str = "ranges that depend on one another make the formula too long";

impl Scope<'_> {
    /// Notes that a value must stay in the range of a parameter.
    pub(crate) fn must_stay_inside(&mut self, inside: Inside, place: Place) {
        self.pending.push(Pending { duty: Duty::Inside(inside), place });
    }

    /// Puts values in place of variables into what has been noted from position `from` on: it is about these values
    /// only.
    pub(crate) fn fix_obligations(&mut self, from: usize, vars: &[Var], by: &[Fraction]) {
        let put = |f: &Fraction| {
            let pairs = vars.iter().zip(by);
            pairs.into_iter().try_fold(f.clone(), |f, (var, value)| f.substitute(*var, value))
        };
        for pending in &mut self.pending[from..] {
            if let Some(duty) = pending.duty.replace(&put) {
                pending.duty = duty;
            }
        }
    }

    /// Adds what holds of another family whose functions are used.
    pub(crate) fn inherit(&mut self, obligations: &[Obligation]) {
        for obligation in obligations {
            if self.obligations.iter().all(|known| known.goal != obligation.goal) {
                self.obligations.push(obligation.clone());
            }
        }
    }

    /// Has what has been noted decided; reports what fails, and whether everything holds. What no domain variable
    /// occurs in is decided on the parts of the shape values, anything else on those of the whole domain.
    pub(crate) fn settle(&mut self, parts: &dyn Fn(bool) -> Vec<(Piece, Rc<Domain>)>, budget: u32) -> bool {
        let mut fine = true;
        if self.pending.is_empty() {
            return true;
        }
        let (shapes, whole) = (parts(true), parts(false));
        for Pending { duty, place } in core::mem::take(&mut self.pending) {
            if self.settled.contains(&duty) {
                continue;
            }
            if self.budget.run().is_stopped() {
                return false;
            }
            let at = place.clone();
            // What is known is looked through first.
            let known = (self.settled.len() + self.obligations.len()) as u64 / 4;
            let whole_domain = match &duty {
                Duty::Nonzero(p) => self.is_over_domain(&Fraction::from(p.clone())),
                Duty::Inside(inside) => self.is_over_domain(&inside.value),
                Duty::Holds(condition) => self.is_over_domain(&condition.value),
            };
            let parts = if whole_domain { &whole } else { &shapes };
            // A raised budget does not raise what the whole run may take.
            let left = self.budget.run().decisions_left();
            let (error, units) = basis_prover::measured(&mut || {
                basis_prover::within(left, &mut || {
                    parts.iter().find_map(|part| match &duty {
                        Duty::Nonzero(divisor) => self.decide_divisor(divisor, &place, part, budget),
                        Duty::Inside(inside) => self.check_inside(inside, place.clone(), part, budget),
                        Duty::Holds(condition) => {
                            self.check_condition(condition, place.clone(), part, budget)
                        }
                    })
                })
            });
            if let Err(TooLarge::Run(message)) = self.budget.run().decision(known + units) {
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

    /// Has a goal decided, if it can be said; what the error is about if it does not hold.
    pub(super) fn judge(&mut self, of: String, goal: Option<Goal>, budget: u32) -> Result<(), Open> {
        let goal = goal.ok_or_else(|| Open::Undecided(String::from(TOO_LONG)))?;
        let ground = self.library.judge().judge(&goal, budget)?;
        self.inherit(&[Obligation { of, goal, ground }]);
        Ok(())
    }

    /// A denominator must not vanish anywhere on the declared ranges.
    fn decide_divisor(
        &mut self,
        divisor: &Poly,
        place: &Place,
        part @ (piece, domain): &(Piece, Rc<Domain>),
        budget: u32,
    ) -> Option<Diagnostic> {
        let mut shown = divisor.display(&self.names).to_string();
        if shown.starts_with('-') && self.domain.iter().any(|v| divisor.depends_on(*v)) {
            shown = (-divisor).display(&self.names).to_string(); // as it stands below a quotient in lowest terms
        }
        let known = self.library.text_at(place).is_some_and(|text| says_the_same(text, &shown));
        let label = if known { String::new() } else { format!("this is {shown}") };
        let labelled = |error: Diagnostic| error.label(label.clone());
        if let Some((first, second)) = self.apart(divisor) {
            let mut one = |factor: &Poly| self.decide_divisor(factor, place, part, budget);
            return one(&first).or_else(|| one(&second));
        }
        let alone = self.without_tangents(divisor, domain);
        let runs_along = alone.is_some();
        let written = divisor;
        let divisor = alone.as_ref().unwrap_or(divisor);
        let mixed = |a: &Angle| a.kind != Kind::Linear && a.itself != a.var && divisor.depends_on(a.itself);
        let beside_itself = self.analytic.angles.iter().any(mixed);
        if let Some((angle, end)) = self.vanishing_end(written, domain).filter(|_| beside_itself) {
            let [low, high] = &angle.ends;
            let range = domain.region.range(angle.var);
            let sign = |side: usize, of: &End| if side == end || !of.is_included() { "<" } else { "<=" };
            let (first, last) = (sign(0, &range.low), sign(1, &range.high));
            let name = &angle.name;
            let message = format!("the denominator vanishes at {name} = {}", angle.ends[end]);
            return Some(labelled(
                Diagnostic::error(place.clone(), message)
                    .help(format!("leave this end of the range out: `{low} {first} {name} {last} {high}`")),
            ));
        }
        let goal = if beside_itself {
            Self::between_bounds(&self.analytic, divisor, (**domain).clone())
                .and_then(|(p, domain)| Some((piece.pull_back(&p)?, domain)))
        } else {
            piece.pull_back(divisor).map(|p| (p, Rc::clone(domain)))
        };
        let wider = if beside_itself { self.for_all_positive(divisor, domain) } else { None };
        if let Some((p, domain)) = wider
            && self.judge(format!("{shown} != 0"), Some(Goal::Nonzero(p, domain)), budget).is_ok()
        {
            return None;
        }
        let goal = goal.map(|(p, domain)| Goal::Nonzero(without_positive(p, &domain), domain));
        let mut judged = self.judge(format!("{shown} != 0"), goal, budget);
        if matches!(judged, Err(Open::Fails(_))) && beside_itself {
            // The point need not be one: the variable and its tangent were taken apart.
            let why = "a variable stands beside its own sine or exponential in it";
            judged = Err(Open::Undecided(String::from(why)));
        }
        Some(match judged {
            Err(Open::Fails(point)) => {
                let point = piece.image(&point);
                // A value at which the denominator is zero, whatever the others are, says it best.
                let alone = point.iter().find_map(|(var, c)| match c {
                    Coordinate::Rational(x) if divisor.at(*var, x).is_zero() => Some((*var, x)),
                    _ => None,
                });
                let numbers = self.analytic.numbers();
                let only =
                    point.iter().filter(|(v, _)| divisor.depends_on(*v) && !numbers.contains(v)).listed();
                let along = match (&only[..], runs_along) {
                    ([(var, Coordinate::Rational(x))], true) => {
                        let help = || self.without_value(*var, x, &domain.region.range(*var));
                        self.value_along(*var, x, domain).map(|at| (at, help()))
                    }
                    _ => None,
                };
                let roughly = numbers.iter().any(|number| divisor.depends_on(*number));
                let along_is_open = along.is_none() && alone.is_none();
                let (at, help) = match (along, alone) {
                    (Some(along), _) => along,
                    (None, Some((var, x))) => (
                        self.value_named(var, x, &domain.region.range(var)),
                        self.without_value(var, x, &domain.region.range(var)),
                    ),
                    (None, None) if !domain.simplices.is_empty() => (
                        self.own(divisor, &point),
                        String::from(
                            "no part of a triangle or tetrahedron can be left out: choose a denominator that vanishes nowhere on it",
                        ),
                    ),
                    (None, None) => (
                        self.own(divisor, &point),
                        String::from("narrow the declared ranges so that they leave this value out"),
                    ),
                };
                // With π and exp(r) the point is only known between their bounds.
                let rough = match (&only[..], roughly && along_is_open) {
                    ([(var, Coordinate::Rational(x))], true) => {
                        Some(format!("near {} = {}", self.names[var.0], decimals::fixed(x, 6)))
                    }
                    _ => None,
                };
                let message = match rough {
                    Some(near) => format!("the denominator vanishes {near}"),
                    None => format!("the denominator vanishes at {at}"),
                };
                labelled(Diagnostic::error(place.clone(), message)).help(help)
            }
            Err(Open::Undecided(left)) => labelled(Diagnostic::error(
                place.clone(),
                "it is undecided whether the denominator vanishes on the declared ranges",
            ))
            .note(left)
            .help("raise the budget, such as `budget 10;`, or narrow the ranges"),
            Ok(()) => return None,
        })
    }

    /// Where a variable has a value; at an end of the range of an angle as that is written, `t = pi/2`.
    fn value_named(&self, var: Var, value: &Rational, range: &Range) -> String {
        self.analytic
            .value_named(var, value, range)
            .unwrap_or_else(|| format!("{} = {value}", self.names[var.0]))
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
        if let Some(angle) = self.analytic.angle(var) {
            let [low, high] = &angle.ends;
            let sign = |end: &End| if at(end) || !end.is_included() { "<" } else { "<=" };
            let (first, last) = (sign(&range.low), sign(&range.high));
            return if at(&range.low) || at(&range.high) {
                format!("leave this end of the range out: `{low} {first} {} {last} {high}`", angle.name)
            } else {
                format!("choose a range without this value of `{}`", angle.name)
            };
        }
        if self.domain.contains(&var) && !at(&range.low) && !at(&range.high) {
            return format!("choose a domain without {name} = {value}");
        }
        if self.subject == Subject::Theorem {
            return format!("leave this value out: `assume {name} {sign} {value};`");
        }
        // A claim is about the family as it is.
        let instead =
            if self.stage == Stage::Complete { "multiply the claim by the denominator, or " } else { "" };
        let word = if self.domain.contains(&var) { "domain" } else { "shape" };
        if !at(&range.low) && !at(&range.high) {
            let below = Range { high: End::Excluded(value.clone()), ..range.clone() };
            let above = Range { low: End::Excluded(value.clone()), ..range.clone() };
            return format!(
                "{instead}leave this value out, which takes a family for each side of it: `{word} {};` and `{word} {};`",
                below.display(name),
                above.display(name)
            );
        }
        format!("{instead}leave this value out: `{word} {};`", narrowed.display(name))
    }

    /// A value must stay in the range of the parameter that it stands for.
    fn check_inside(
        &mut self,
        inside: &Inside,
        place: Place,
        (piece, domain): &(Piece, Rc<Domain>),
        budget: u32,
    ) -> Option<Diagnostic> {
        let Inside { value, name, range, .. } = inside;
        let of = inside.of();
        if let Some(c) = value.as_constant() {
            return (!range.contains(&c)).then(|| inside.outside(&c, place));
        }
        let shown = value.display(&self.names);
        let name = without_brackets(name);
        let (given, declared) = inside
            .written
            .clone()
            .unwrap_or_else(|| (format!("{name} = {shown}"), range.display(name).to_string()));
        for (end, above) in [(&range.low, false), (&range.high, true)] {
            let (bound, relation) = match end {
                End::Infinite => continue,
                End::Included(x) => (x, Relation::NonNegative),
                End::Excluded(x) => (x, Relation::Positive),
            };
            let distance = value - &Fraction::constant(bound.clone());
            let distance = if above { -&distance } else { distance };
            let sign = distance.numer() * distance.denom();
            let domain = Rc::clone(domain);
            let goal = |value| Goal::Holds(Statement::Sign { value, relation, domain });
            let goal = piece.pull_back_fraction(&distance).map(goal);
            let symbol = match (above, relation) {
                (true, Relation::NonNegative) => "<=",
                (true, Relation::Positive) => "<",
                (false, Relation::NonNegative) => ">=",
                (false, Relation::Positive) => ">",
            };
            match self.judge(format!("{shown} {symbol} {bound}"), goal, budget) {
                Err(Open::Fails(point)) => {
                    let point = piece.image(&point);
                    return Some(
                        Diagnostic::error(
                            place,
                            format!("{given} leaves the declared range `{declared}`{of}"),
                        )
                        .label(format!("at {}", self.own(&sign, &point)))
                        .help(inside.help(&shown, end, above)),
                    );
                }
                Err(Open::Undecided(left)) => {
                    return Some(
                        Diagnostic::error(
                            place,
                            format!("it is undecided whether {given} stays in the range `{declared}`{of}"),
                        )
                        .note(left)
                        .help("raise the budget, such as `budget 10;`, or narrow the ranges"),
                    );
                }
                Ok(()) => {}
            }
        }
        None
    }

    /// A condition on the shape values of another family must hold.
    fn check_condition(
        &mut self,
        condition: &Condition,
        place: Place,
        (piece, domain): &(Piece, Rc<Domain>),
        budget: u32,
    ) -> Option<Diagnostic> {
        let Condition { value, relation, text, family } = condition;
        let message = format!("the shape values do not satisfy `{text}` of `{family}`");
        let help = "choose values that satisfy it, narrow the ranges, or `assume` it here";
        let sign = value.numer() * value.denom();
        let (relation, domain) = (*relation, Rc::clone(domain));
        let goal = |value| Goal::Holds(Statement::Sign { value, relation, domain });
        match self.judge(format!("{text} of {family}"), piece.pull_back_fraction(value).map(goal), budget) {
            Ok(()) => None,
            Err(Open::Fails(point)) => {
                let at = self.own(&sign, &piece.image(&point));
                let error = Diagnostic::error(place, message);
                Some(if at.is_empty() { error } else { error.label(format!("at {at}")) }.help(help))
            }
            Err(Open::Undecided(left)) => {
                let message =
                    format!("it is undecided whether the shape values satisfy `{text}` of `{family}`");
                Some(Diagnostic::error(place, message).note(left).help(help))
            }
        }
    }

    /// The coordinates of a point that a polynomial depends on, as text, without definite numbers if there are others.
    pub(super) fn own(&self, p: &Poly, point: &[(Var, Coordinate)]) -> String {
        let numbers = self.analytic.numbers();
        let any = point.iter().any(|(v, _)| p.depends_on(*v) && !numbers.contains(v));
        let own = point.iter().filter(|(v, _)| p.depends_on(*v) && !(any && numbers.contains(v)));
        let parts: Vec<String> = own.map(|(v, c)| c.describe(&self.names[v.0])).listed();
        parts.join(", ")
    }
}

/// Whether a sum that is written has the terms of a polynomial as it is shown, or their negatives, in whatever order: it
/// need not be shown then.
fn says_the_same(written: &str, shown: &str) -> bool {
    let (Some(mut a), Some(mut b)) = (terms(written), terms(shown)) else { return false };
    for (negative, _) in &mut b {
        *negative = !*negative;
    }
    let turned = b.clone();
    for (negative, _) in &mut b {
        *negative = !*negative;
    }
    let mut same = |mut b: Vec<(bool, Vec<String>)>| {
        sort_by(&mut b, Ord::cmp);
        sort_by(&mut a, Ord::cmp);
        a == b
    };
    same(b) || same(turned)
}

/// The terms of a sum without brackets, each with its sign and its factors in order.
fn terms(text: &str) -> Option<Vec<(bool, Vec<String>)>> {
    let text: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    let text = text.strip_prefix('(').and_then(|text| text.strip_suffix(')')).unwrap_or(&text);
    if text.contains(['(', ')', '[']) {
        return None;
    }
    let mut all: Vec<(bool, String)> = Vec::new();
    for c in text.chars() {
        match c {
            '+' | '-' => all.push((c == '-', String::new())),
            _ => {
                if all.is_empty() {
                    all.push((false, String::new()));
                }
                all.last_mut()?.1.push(c);
            }
        }
    }
    let factors = |term: &String| {
        let mut factors: Vec<String> = term.split('*').map(String::from).listed();
        sort_by(&mut factors, Ord::cmp);
        factors
    };
    Some(all.iter().map(|(negative, term)| (*negative, factors(term))).listed())
}

/// A polynomial without the factors that are positive at all points that count, because a premise says so: it vanishes where the
/// rest does.
fn without_positive(mut p: Poly, domain: &Domain) -> Poly {
    for (g, _) in
        domain.premises.iter().filter(|(g, sign)| *sign == Relation::Positive && g.as_constant().is_none())
    {
        while let Some(rest) = p.div_exact(g).filter(|_| !p.is_zero()) {
            p = rest;
        }
    }
    p
}

#[cfg(test)]
mod tests {
    use super::says_the_same;

    #[test]
    fn sums_that_need_not_be_shown_again() {
        for (written, shown) in
            [("2*t-1", "1 - 2*t"), ("(t + λ)", "λ + t"), ("1 - t*2", "1 - 2*t"), ("t^2 - 1", "-1 + t^2")]
        {
            assert!(says_the_same(written, shown), "{written}");
        }
        for (written, shown) in
            [("2*t - 1", "1 + 2*t"), ("w", "1 - 2*t"), ("(1 - t)*(1 - t)", "1 - 2*t + t^2"), ("t - t", "0")]
        {
            assert!(!says_the_same(written, shown), "{written}");
        }
    }
}

//! The tangent in which an angle is expanded, and the range of that.

use super::edges::{Edge, edge};
use super::limits::{Bound, Limits, Place, Tangent, declared, of_end, ordered, psi, stays_finite, sum_of};
use super::numbers::ranges;
use super::survey::Use;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::range::{End, Range, Region};
use crate::algebra::rational::Rational;
use crate::model::Parameter;
use crate::model::angle::{Angle, Kind, multiple_of_pi};
use crate::model::chart::Constraint;
use crate::model::scope::Scope;
use crate::syntax::RangeDecl;
use basis_kernel::Relation;
use basis_prover::collections::list::{Listed, Mapped};
/// A domain variable whose ends contain shape parameters or π: y runs from 0 to 1.
pub(super) fn linear(
    scope: &mut Scope<'_>,
    decl: &RangeDecl,
    at: &Place,
    limits: &Limits,
    count: usize,
    (known, constraints): (&[Parameter], &[Constraint]),
) -> Option<Range> {
    let name = &decl.name.text;
    let [Some(low), Some(high)] = limits else {
        let error = scope.error(decl.name.span, format!("the domain of `{name}` has no end on one side"));
        scope.report(error.help("write both ends, such as `domain 0 <= t <= α;`"));
        return None;
    };
    let (first, last) = (sum_of(scope, &low.value, count)?, sum_of(scope, &high.value, count)?);
    let width = &last - &first;
    let ranges = known.iter().map(|p| (p.var, p.range.clone())).chain(ranges(scope));
    let region = Region { ranges: ranges.listed() };
    if let Err(text) = scope.is_positive(&width, &region, constraints) {
        let message = format!("the ends of the domain of `{name}` are not in order");
        let error = scope.error(decl.name.span, message).label(text);
        scope.report(
            error.help("narrow the ranges of the parameters so that the lower end is below the upper one"),
        );
        return None;
    }
    let new = Angle {
        name: name.clone(),
        kind: Kind::Linear,
        var: at.slot,
        itself: at.itself,
        rate: Rational::ONE,
        turns: false,
        shift: Rational::ZERO,
        low: first.clone(),
        width,
        limits: [first.clone(), last.clone()],
        ends: [low.text.clone(), high.text.clone()],
        declared: declared(name, limits),
        mirror: Vec::new(),
    };
    let own = |f: &Fraction| {
        let text = f.display(&scope.names);
        if text.contains([' ', '*', '/']) { format!("({text})") } else { text }
    };
    let (from, width) = (first.display(&scope.names), own(&new.width));
    scope.names[at.slot.0] = match (new.low.is_zero(), from.strip_prefix('-')) {
        (true, _) => format!("{name}/{width}"),
        (false, Some(below)) if !below.contains(' ') => format!("({name} + {below})/{width}"),
        _ => format!("({name} - {})/{width}", own(&first)),
    };
    scope.analytic.angles.push(new);
    scope.ends.push((Fraction::zero(), Fraction::constant(Rational::ONE)));
    let end = |l: &Bound, x: Rational| if l.included { End::Included(x) } else { End::Excluded(x) };
    Some(Range { low: end(low, Rational::ZERO), high: end(high, Rational::ONE) })
}

/// Angles in the domain from which others can be measured: sin and cos of all multiples of them are 0, 1 or −1. First 0.
pub(super) fn shifts(unit: &Rational, turns: bool, ends: &[&Bound]) -> Vec<Rational> {
    const MOST: i64 = 32;
    let mut all = vec![Rational::ZERO];
    let value = |l: &Bound| if turns { l.value.number.clone() } else { l.value.pi.clone() };
    let ([low, high], Some(step)) = (ends, (unit + unit).recip()) else { return all };
    let first = value(low).checked_div(&step).map_or(Rational::ZERO, |n| -(-n).floor());
    for k in 0..MOST {
        let shift = &(&first + &Rational::from(k)) * &step;
        if shift <= value(high) && !shift.is_zero() {
            all.push(shift);
        }
    }
    all
}

/// Makes a variable an angle; the range of y.
pub(super) fn angle(
    scope: &mut Scope<'_>,
    decl: &RangeDecl,
    at: &Place,
    of: &Use,
    limits: &Limits,
    (all, count, known): (&[Option<Use>], usize, &[Parameter]),
    conditions: &mut Vec<Constraint>,
) -> Option<Range> {
    let name = &decl.name.text;
    let ends: Vec<&Bound> = limits.iter().flatten().listed();
    let circular = of.kind == Kind::Circular;
    let wrong = |scope: &Scope<'_>, message: String, help: &str| {
        scope.report(scope.error(decl.name.span, message).help(help));
    };
    if (at.is_domain || circular) && ends.len() < 2 {
        let help = if at.is_domain {
            "write both ends, such as `domain 0 <= t <= pi/2;`"
        } else {
            "write both ends, such as `shape 0 < α < pi;`"
        };
        wrong(scope, format!("the range of `{name}` has no end on one side"), help);
        return None;
    }
    let parametric: Vec<&(Var, Rational, bool)> = ends.iter().flat_map(|l| &l.value.parts).listed();
    if !at.is_domain && !parametric.is_empty() {
        wrong(
            scope,
            format!("the range of `{name}` depends on another parameter"),
            "give it numbers as ends",
        );
        return None;
    }
    let half = Rational::new(1, 2);
    // The rate: half of the unit, or a part of that, so that the tangent is finite, and rational at the ends; else what
    // takes their place.
    let mut chosen = None;
    let mut edges: [Option<Edge>; 2] = [None, None];
    if parametric.is_empty() {
        if circular && !of.turns && at.is_domain {
            let proper = |l: &&Bound| {
                l.value.number.is_zero()
                    && (&l.value.pi + &l.value.pi).is_integer()
                    && l.value.pi.abs() <= Rational::ONE
            };
            if let Some(end) = ends.iter().find(|l| !proper(l)) {
                let help = "ends of an angle are multiples of `pi/2` from `-pi` to `pi`, or a shape parameter: `shape 0 < α < pi; domain 0 <= θ <= α;`";
                wrong(
                    scope,
                    format!(
                        "the end {} of the angle `{name}` is not a multiple of pi/2 between -pi and pi",
                        end.text
                    ),
                    help,
                );
                return None;
            }
        }
        if circular && !of.turns && !at.is_domain {
            let proper = |l: &&Bound| l.value.number.is_zero() && l.value.pi.abs() <= Rational::ONE;
            if let Some(end) = ends.iter().find(|l| !proper(l)) {
                let help =
                    "ends of an angle are 0 and rational multiples of `pi` up to `pi`: `shape 0 < α < pi;`";
                wrong(
                    scope,
                    format!("the end {} of the angle `{name}` is not a multiple of pi", end.text),
                    help,
                );
                return None;
            }
        }
        let shifts =
            if circular && at.is_domain { shifts(&of.unit, of.turns, &ends) } else { vec![Rational::ZERO] };
        'search: for m in 1..=8 {
            let rate = &(&of.unit * &half) * &Rational::new(1, m);
            for shift in &shifts {
                let finite = |l: &&Bound| {
                    let psi = psi(&rate, of.turns, shift, l).abs();
                    psi < half || psi == half && !l.included && !at.is_domain && !of.beside
                };
                if circular && !ends.iter().all(finite) {
                    continue;
                }
                let mut tangents =
                    ends.iter().map(|l| Tangent::of(of.kind, &rate, of.turns, shift, &l.value));
                if !circular || !tangents.any(|t| matches!(t, Tangent::Irrational)) {
                    chosen = Some((rate, shift.clone()));
                    break 'search;
                }
            }
        }
        if chosen.is_none() && circular && !at.is_domain && !of.turns {
            let mut rates = (1..=8).map(|m| &(&of.unit * &half) * &Rational::new(1, m));
            let found = rates.find_map(|rate| Some((irrational_ends(at.slot, &rate, &ends)?, rate)));
            if let Some((found, rate)) = found {
                edges = found;
                chosen = Some((rate, Rational::ZERO));
            }
        }
        if chosen.is_none() {
            let texts: Vec<&str> = ends.mapped(|l| l.text.as_str());
            wrong(
                scope,
                format!(
                    "the functions of `{name}` have irrational values at the ends {} of its range",
                    texts.join(" and ")
                ),
                if at.is_domain {
                    "choose ends at which half of the smallest angle is a multiple of pi/4; a shape parameter may also be the end of the domain, `shape 0 < α <= pi/2; domain 0 <= t <= α;`"
                } else {
                    "let the range begin at 0, or choose ends at which half of the smallest angle is a multiple of pi/4"
                },
            );
            return None;
        }
    } else {
        // The rates of the parameters have been found: that of the variable is a multiple of them.
        let mut rates: Vec<(Rational, Rational)> = Vec::new();
        for (var, factor, _) in &parametric {
            let shape = all.get(var.0.checked_sub(count)?)?;
            shape.as_ref()?;
            let angle = scope.analytic.angles.iter().find(|a| a.itself == *var)?;
            rates.push((angle.rate.clone(), factor.abs()));
        }
        // The least common multiple of those that the ends ask for.
        let mut least: Option<Rational> = None;
        for (rate, factor) in &rates {
            let wanted = rate.checked_div(factor)?;
            least = Some(match &least {
                Some(known) => (known * &wanted).checked_div(&known.gcd(&wanted))?,
                None => wanted,
            });
        }
        let least = least?;
        let goes = |rate: &Rational| {
            let multiple = |(own, factor): &(Rational, Rational)| (rate * factor).checked_div(own);
            !of.turns && rates.iter().all(|known| multiple(known).is_some_and(|n| n.is_integer()))
        };
        // Where the variable is used with larger factors than the parameter, its rate is larger, too, if its tangent is
        // finite then.
        let own = (&of.unit * &half).checked_div(&least)?;
        let rate = match own.to_i64() {
            Some(n) if n > 1 && !of.beside => {
                let rate = &least * &own;
                let finite = ends.iter().all(|l| !circular || stays_finite(scope, &rate, l, known));
                if goes(&rate) && finite { rate } else { least }
            }
            _ => least,
        };
        if !goes(&rate) {
            wrong(
                scope,
                format!("the ends of the domain of `{name}` are not multiples of one angle"),
                "write `domain 0 <= t <= α;` or `domain -α <= t <= α;`",
            );
            return None;
        }
        // Beyond a quarter turn the tangent is another one.
        if let Some(end) = ends.iter().find(|l| circular && !stays_finite(scope, &rate, l, known)) {
            let reach = multiple_of_pi(&half.checked_div(&rate)?);
            wrong(
                scope,
                format!("the end {} of the angle `{name}` can be {reach} or more", end.text),
                "make one shape parameter the whole angle, `domain 0 <= t <= α;`, or narrow the ranges",
            );
            return None;
        }
        chosen = Some((rate, Rational::ZERO));
    }
    let (rate, shift) = chosen?;
    let one = Fraction::constant(Rational::ONE);
    let mut new = Angle {
        name: name.clone(),
        kind: of.kind,
        var: at.slot,
        itself: at.itself,
        rate,
        turns: of.turns,
        shift,
        low: Fraction::zero(),
        width: one.clone(),
        limits: [0, 1].map(|k| {
            limits[k].as_ref().and_then(|l| sum_of(scope, &l.value, count)).unwrap_or_else(Fraction::zero)
        }),
        ends: [0, 1].map(|k| limits[k].as_ref().map_or_else(String::new, |l| l.text.clone())),
        declared: declared(name, limits),
        mirror: Vec::new(),
    };
    scope.names[at.slot.0] = new.tangent_name();
    let exact = parametric.is_empty() && (circular || ends.iter().all(|l| l.value.number.is_zero()));
    let range = if exact {
        let end = |side: usize| match &limits[side] {
            Some(l) if edges[side].is_some() => {
                let beyond = edges[side].as_ref().map_or(Rational::ZERO, |edge| edge.beyond.clone());
                if l.included { End::Included(beyond) } else { End::Excluded(beyond) }
            }
            None => {
                // Only of a hyperbolic parameter.
                End::Excluded(Rational::from(if side == 0 { -1 } else { 1 }))
            }
            Some(l) => match Tangent::of(new.kind, &new.rate, new.turns, &new.shift, &l.value) {
                Tangent::Exact(x) if l.included => End::Included(x),
                Tangent::Exact(x) => End::Excluded(x),
                Tangent::Infinite | Tangent::Irrational => End::Infinite,
            },
        };
        Range { low: end(0), high: end(1) }
    } else {
        // x = low + width·y
        let mut values = Vec::new();
        for (limit, beyond) in limits.iter().zip([-1, 1]) {
            // Only a hyperbolic parameter has no end: its tangent goes to ±1.
            let Some(l) = limit else {
                values.push(Fraction::constant(Rational::from(beyond)));
                continue;
            };
            let mut sum = Fraction::constant(l.value.number.clone());
            for (var, factor, _) in &l.value.parts {
                sum = &sum + &(&Fraction::constant(factor.clone()) * &Fraction::var(*var));
            }
            if let Some(pi) = scope.analytic.pi {
                sum = &sum + &(&Fraction::constant(l.value.pi.clone()) * &Fraction::var(pi));
            }
            match scope.angle_at(&new, &sum, decl.name.span) {
                Ok(x) => values.push(x?),
                Err((message, help)) => {
                    wrong(scope, message, &help);
                    return None;
                }
            }
        }
        if at.is_domain && !ordered(scope, &ends, known) {
            wrong(
                scope,
                format!("the ends of the domain of `{name}` could not be proved to be in order"),
                "let the parameter at the end be positive: `shape 0 < α < pi; domain 0 <= t <= α;`",
            );
            return None;
        }
        new.low = values.first()?.clone();
        new.width = values.last()? - &new.low;
        // In brackets, as powers of it may be written.
        let of_end = |side: usize, beyond: &str| {
            limits[side].as_ref().map_or_else(|| String::from(beyond), |l| of_end(&new, l))
        };
        let (x, low, high) = (new.tangent_name(), of_end(0, "(-1)"), of_end(1, "1"));
        scope.names[at.slot.0] = if new.low.is_zero() {
            format!("({x}/{high})")
        } else {
            format!("(({x} - {low})/({high} - {low}))")
        };
        let end = |side: usize, y: Rational| {
            let included = limits[side].as_ref().is_some_and(|l| l.included);
            if included { End::Included(y) } else { End::Excluded(y) }
        };
        let order = |l: &Limits| {
            let [Some(low), Some(high)] = l else { return false };
            at.is_domain || low.value.number <= high.value.number
        };
        if ends.len() == 2 && !order(limits) {
            wrong(scope, format!("the range of `{name}` is empty"), "write the smaller end first");
            return None;
        }
        Range { low: end(0, Rational::ZERO), high: end(1, Rational::ONE) }
    };
    if range.is_empty() || at.is_domain && range.finite().is_none_or(|(a, b)| a >= b) {
        wrong(scope, format!("the range of `{name}` is empty"), "write the smaller end first");
        return None;
    }
    scope.analytic.angles.push(new);
    for (edge, limit) in edges.into_iter().zip(limits) {
        let (Some(edge), Some(limit)) = (edge, limit) else { continue };
        let relation = if limit.included { Relation::NonNegative } else { Relation::Positive };
        let text = declared(name, limits);
        conditions.push(Constraint { value: edge.inside, relation, text, is_end: true });
    }
    Some(range)
}

/// What takes the place of ends whose tangents are irrational; `None` where a tangent is infinite, or the conditions are
/// not.
pub(super) fn irrational_ends(var: Var, rate: &Rational, ends: &[&Bound]) -> Option<[Option<Edge>; 2]> {
    let [low, high] = ends else { return None };
    let psi = [low, high].map(|l| psi(rate, false, &Rational::ZERO, l));
    let is_finite = |psi: &Rational| psi.abs() < Rational::new(1, 2);
    let mut edges = [None, None];
    for side in 0..2 {
        if !is_finite(&psi[side]) || !is_finite(&psi[1 - side]) {
            return None;
        }
        if !(&psi[side] * &Rational::from(4)).is_integer() {
            edges[side] = Some(edge(var, &psi[side], &psi[1 - side])?);
        }
    }
    Some(edges)
}

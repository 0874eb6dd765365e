//! Equations and inequalities: the differences of neighbouring sides.

use proc_macro2::Span;

use super::Push;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::claim::{ClaimKind, Difference};
use crate::model::formula::Value;
use crate::model::formula::print::{Component, Printer};
use crate::model::scope::Scope;
use crate::syntax::{self, Comparison, Expr, Loops, Relation};
use basis_prover::collections::list::Mapped;

/// One equation or inequality, for each value of its index variables.
pub(super) fn relation(
    scope: &mut Scope<'_>,
    relation: &Relation,
    fixed: &[(Var, Fraction)],
    at: Option<&str>,
    push: &mut Push<'_>,
) {
    if relation.comparison == Comparison::NotEqual {
        let error = scope.error(relation.span, "a claim is an equation or an inequality");
        scope.report(error.help("write `refute … = …;` to say that two things differ, or claim `<` or `>`"));
        return;
    }
    let mut sides = core::iter::once(&relation.left).chain(signs(relation).map(|(_, side)| side));
    if !sides.any(|side| scope.mentions_variable(side)) {
        let error = scope.error(relation.span, "the claim names no function and no variable");
        scope.report(error.help(
            "claim something about the functions, such as `b[0] + b[1] = 1 - b[2]`, or `partition_of_unity`",
        ));
        return;
    }
    let mut any = false;
    let fine = scope.each(&relation.loops, &mut |scope| {
        any = true;
        let before = scope.pending.len();
        match all_differences(scope, relation, fixed) {
            Some(differences) => {
                let (vars, values): (Vec<Var>, Vec<Fraction>) = fixed.iter().cloned().unzip();
                scope.fix_obligations(before, &vars, &values);
                let printer = Printer { constants: &scope.constants, component: None };
                let mut text = printer.print(&relation.left);
                for (sign, side) in signs(relation) {
                    text += &format!(" {} {}", sign.symbol(), printer.print(side));
                }
                let kind =
                    ClaimKind::Relation { differences, fixed: fixed.to_vec(), at: at.map(String::from) };
                push(scope, text, kind)
            }
            None => {
                scope.pending.truncate(before);
                false
            }
        }
    });
    if fine && !any && scope.constants.is_empty() {
        nothing_claimed(scope, &relation.loops, relation.span);
    }
}

/// Reports a loop without rounds, or a condition that holds in none.
pub(super) fn nothing_claimed(scope: &Scope<'_>, loops: &Loops, span: Span) {
    let (message, help) = if loops.condition.is_some() {
        ("the condition does not hold: nothing is claimed", "leave the condition out, or the claim")
    } else {
        ("the loop is empty: nothing is claimed", "write the smaller bound first")
    };
    scope.report(scope.error(span, message).help(help));
}

/// The signs of a relation, each with the side behind it.
fn signs(relation: &Relation) -> impl Iterator<Item = (Comparison, &Expr)> {
    let first = core::iter::once((relation.comparison, &relation.right));
    first.chain(relation.chain.iter().map(|(sign, side)| (*sign, side)))
}

/// The differences of neighbouring sides, with the signs between them.
fn all_differences(
    scope: &mut Scope<'_>,
    relation: &Relation,
    fixed: &[(Var, Fraction)],
) -> Option<Vec<(Comparison, Difference)>> {
    let mut all = Vec::new();
    let (mut left, mut fine) = (&relation.left, true);
    for (sign, right) in signs(relation) {
        match differences(scope, relation.span, left, right, fixed) {
            Some(list) => all.extend(list.into_iter().map(|difference| (sign, difference))),
            None => fine = false,
        }
        left = right;
    }
    (fine && (relation.chain.is_empty() || !ends_cross(scope, relation)?)).then_some(all)
}

/// Whether no number lies between the two ends of a chain; then that is reported.
fn ends_cross(scope: &mut Scope<'_>, relation: &Relation) -> Option<bool> {
    let last = &relation.chain.last()?.1;
    let (Value::Scalar(first), Value::Scalar(end)) = (scope.value(&relation.left)?, scope.value(last)?)
    else {
        return Some(false);
    };
    let (Some(first), Some(end)) = (first.as_constant(), end.as_constant()) else { return Some(false) };
    let strict = signs(relation).any(|(sign, _)| matches!(sign, Comparison::Less | Comparison::Greater));
    let falls =
        signs(relation).any(|(sign, _)| matches!(sign, Comparison::Greater | Comparison::GreaterEqual));
    let (low, high) = if falls { (&end, &first) } else { (&first, &end) };
    let crosses = low > high || strict && low == high;
    if crosses {
        let error = scope.error(relation.span, "the ends of the chain cross: nothing lies between them");
        let why = if low > high { format!("{low} is above {high}") } else { format!("both are {low}") };
        scope.report(error.label(why).help("write the smaller end first, as in `-1 <= x <= 1`"));
    }
    Some(crosses)
}

/// Whether a list is one of `count` decimals with commas, `[0,5, 0,25]`: of twice as many whole numbers.
fn is_of_decimals(list: &Expr, count: usize) -> bool {
    let is_whole = |e: &Expr| matches!(&e.kind, syntax::ExprKind::Number(x) if x.is_integer());
    matches!(&list.kind, syntax::ExprKind::List(all) if all.len() == 2 * count && all.iter().all(is_whole))
}

/// Left side minus right side, component by component; a lone 0 stands for all components.
fn differences(
    scope: &mut Scope<'_>,
    span: Span,
    written_left: &Expr,
    written_right: &Expr,
    fixed: &[(Var, Fraction)],
) -> Option<Vec<Difference>> {
    let left = scope.value(written_left)?;
    let right = scope.value(written_right)?;
    let (left, right, is_list) = match (left, right) {
        (Value::Scalar(l), Value::Scalar(r)) => (vec![(Vec::new(), l)], vec![(Vec::new(), r)], false),
        (Value::List(l), Value::List(r)) => {
            if l.len() != r.len() {
                // A function whose formula went wrong is not there.
                if scope.cut_short {
                    return None;
                }
                let shown = if matches!(written_right.kind, syntax::ExprKind::List(_)) {
                    written_right.span
                } else {
                    span
                };
                let error = scope.error(
                    shown,
                    format!(
                        "wrong number of values: the left side has {}, the right side {}",
                        l.len(),
                        r.len()
                    ),
                );
                let family =
                    matches!(written_right.kind, syntax::ExprKind::Call(..) | syntax::ExprKind::Name(_));
                scope.report(error.help(match l.len() {
                    0 => String::from("write the values of the left side"),
                    n if family => {
                        format!("compare with a family of {}", crate::plural::count(n, "function"))
                    }
                    n if is_of_decimals(written_right, n) => {
                        let values = crate::plural::count(n, "value");
                        format!("write {values}; decimals have a point, `0.5`")
                    }
                    n => format!("write {}", crate::plural::count(n, "value")),
                }));
                return None;
            }
            (l, r, true)
        }
        (Value::List(l), Value::Scalar(r)) if r.is_zero() => {
            let zeros = l.mapped(|(i, _)| (i.clone(), Fraction::zero()));
            (l, zeros, true)
        }
        (Value::Scalar(l), Value::List(r)) if l.is_zero() => {
            let zeros = r.mapped(|(i, _)| (i.clone(), Fraction::zero()));
            (zeros, r, true)
        }
        (Value::List(list), _) | (_, Value::List(list)) => {
            let mistaken = |side: &syntax::Expr| matches!(&side.kind, syntax::ExprKind::Name(name) if scope.is_mistaken(name));
            if mistaken(written_left) || mistaken(written_right) {
                return None;
            }
            let error = scope
                .error(span, format!("a list of {} functions is compared with a single one", list.len()));
            scope.report(error.help(format!(
                "write a list of {} values, `[…]`; only 0 stands for all of them",
                list.len()
            )));
            return None;
        }
    };
    let (vars, values): (Vec<Var>, Vec<Fraction>) = fixed.iter().cloned().unzip();
    let (library, unit) = (scope.library, scope.unit);
    let mut all = Vec::new();
    for (position, ((index, l), (other, r))) in left.into_iter().zip(right).enumerate() {
        let difference = scope.fits(scope.budget.sub(&l, &r), span)?;
        let value =
            if vars.is_empty() { difference } else { scope.put(&difference, &vars, &values, span)? };
        let value = scope.analytic.reduced(value);
        let is_family = |name: &str| scope.variable(name).is_none() && library.knows(unit, name);
        let function_name = scope.function_name.as_str();
        // A plain list has positions for indices; the functions' own indices say more.
        let index = if index.len() >= other.len() { &index } else { &other };
        let component =
            is_list.then_some(Component { function_name, is_family: &is_family, position, index });
        let printer = Printer { constants: &scope.constants, component };
        let (left, right, text) = printer.difference(written_left, written_right);
        all.push(Difference { left, right, text, value });
    }
    Some(all)
}

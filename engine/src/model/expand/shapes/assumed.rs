//! What `assume` says of the values of shape parameters: inequalities, and equations that determine one of them.

use basis_kernel::Relation;
use basis_prover::collections::list::Listed;
use basis_prover::collections::map::SortedMap;
use proc_macro2::Span;

use super::{Shapes, constrain};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, PolyExt as _, Var};
use crate::algebra::rational::Rational;
use crate::model::chart::Constraint;
use crate::model::expand::names::attempt;
use crate::model::formula::print::Printer;
use crate::model::scope::Scope;
use crate::syntax::{Comparison, Relation as Written};

/// Reads an assumption, for all values of its index variables; whether all went well.
pub(in crate::model::expand) fn assume(
    scope: &mut Scope<'_>,
    relation: &Written,
    shapes: &mut Shapes,
) -> bool {
    let mut rounds = None;
    let depth = scope.constants.len();
    attempt(scope, &mut |scope| {
        let mut all = Vec::new();
        let fine = scope.each(&relation.loops, &mut |scope| {
            all.push(scope.constants[depth..].to_vec());
            true
        });
        rounds = Some((all, fine));
        Some(())
    });
    let Some((rounds, mut fine)) = rounds else { return false };
    for constants in rounds {
        scope.constants.extend(constants);
        fine &= assume_one(scope, relation, shapes).is_some();
        scope.constants.truncate(depth);
    }
    fine
}

fn assume_one(scope: &mut Scope<'_>, relation: &Written, shapes: &mut Shapes) -> Option<()> {
    let further = relation.chain.iter().map(|(_, side)| side);
    let mut sides = [&relation.left, &relation.right].into_iter().chain(further);
    if !sides.any(|side| scope.mentions_variable(side)) {
        let error = scope.error(relation.span, "an assumption is about shape parameters");
        scope.report(error.help("the range of orders is declared with the family, `family F(n in 2..=4)`; conditions on indices stand behind `if`"));
        return None;
    }
    let mut left = &relation.left;
    let first = core::iter::once((relation.comparison, &relation.right));
    for (sign, right) in first.chain(relation.chain.iter().map(|(sign, side)| (*sign, side))) {
        let a = attempt(scope, &mut |scope| scope.scalar(left))?;
        let b = attempt(scope, &mut |scope| scope.scalar(right))?;
        let printer = Printer { constants: &scope.constants, component: None };
        let text = format!("{} {} {}", printer.print(left), sign.symbol(), printer.print(right));
        let difference = scope.fits(scope.budget.sub(&a, &b), relation.span)?;
        match sign {
            Comparison::Equal => determine(scope, &difference, relation.span, &text, shapes)?,
            Comparison::NotEqual => {
                let error = scope.error(relation.span, "an assumption is an inequality or a linear equation");
                scope.report(error.help("narrow the range of a parameter, such as by `assume λ > 0;`"));
                return None;
            }
            _ => {
                let strict = matches!(sign, Comparison::Less | Comparison::Greater);
                let below = matches!(sign, Comparison::Less | Comparison::LessEqual);
                let value = if below { -&difference } else { difference };
                let relation_of = if strict { Relation::Positive } else { Relation::NonNegative };
                constrain(scope, &value, relation_of, text, relation.span, shapes)?;
            }
        }
        left = right;
    }
    Some(())
}

/// An equation that is linear in a parameter determines it: of several the one that is declared last.
fn determine(
    scope: &mut Scope<'_>,
    difference: &Fraction,
    span: Span,
    text: &str,
    shapes: &mut Shapes,
) -> Option<()> {
    let p = difference.numer();
    if let Some(c) = p.as_constant() {
        if !c.is_zero() {
            scope.impossible = Some((span, String::from(text)));
        }
        return Some(());
    }
    if scope.analytic.pi.is_some() {
        let error = scope.error(span, "an equation cannot determine a parameter beside angles, or ends of the domain that are parameters");
        scope.report(error.help("put the value of the parameter in its place"));
        return None;
    }
    let slope = |var: Var| p.derivative(var).as_constant().filter(|c| !c.is_zero());
    let found =
        shapes.parameters.iter().rev().find_map(|parameter| Some((parameter.var, slope(parameter.var)?)));
    let Some((var, slope)) = found else {
        let error = scope.error(span, "the equation is not linear in a shape parameter");
        scope.report(error.help(
            "an equation determines a parameter that has a number as its coefficient, as in `assume B + 2*C = 1;`; instead of `p*q = 1` write `let q = 1/p;`, otherwise inequalities",
        ));
        return None;
    };
    let value = p.at(var, &Rational::ZERO).scale(&-&slope.recip().unwrap_or(Rational::ONE));
    // The parameter is no variable any more, and those after it move up.
    let place = shapes.parameters.iter().position(|p| p.var == var)?;
    let parameter = shapes.parameters.remove(place);
    let moved = |v: Var| if v > var { Var(v.0 - 1) } else { v };
    let names: Vec<Var> = (0..scope.names.len()).map(|k| moved(Var(k))).listed();
    let put = |p: &Poly| p.substitute(var, &value).rename(&names);
    for constraint in &mut shapes.constraints {
        constraint.value = put(&constraint.value);
    }
    let value = value.rename(&names);
    for (_, known) in &mut scope.determined {
        if let Some(p) = known.as_poly() {
            *known = Fraction::from(put(p));
        }
    }
    for other in &mut shapes.parameters {
        other.var = moved(other.var);
    }
    scope.names.remove(var.0);
    // What has been evaluated already may mention the variables as they were.
    scope.lets = SortedMap::new();
    scope.determined.push((parameter.name.clone(), Fraction::from(value.clone())));
    scope.equations.push(String::from(text));
    for (end, above) in [(&parameter.range.low, false), (&parameter.range.high, true)] {
        let Some(bound) = end.value() else { continue };
        let distance = &value - &Poly::constant(bound.clone());
        let distance = if above { -&distance } else { distance };
        let relation = if end.is_included() { Relation::NonNegative } else { Relation::Positive };
        let sign = match (above, end.is_included()) {
            (false, true) => ">=",
            (false, false) => ">",
            (true, true) => "<=",
            (true, false) => "<",
        };
        let text = format!("{} {sign} {bound} by {text}", parameter.name);
        shapes.constraints.push(Constraint { value: distance, relation, text, is_end: false });
    }
    Some(())
}

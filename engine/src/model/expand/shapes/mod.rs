//! Shape parameters: their ranges, which may depend on one another (`chain`), and what `assume` says of their values
//! (`assumed`).

mod assumed;
mod chain;

use basis_kernel::{Relation, Statement as Proposition};
use basis_prover::collections::list::Mapped;
use proc_macro2::Span;
use std::rc::Rc;

pub(super) use self::assumed::assume;
#[cfg(feature = "angles")]
pub(super) use self::chain::without_indices;
use self::chain::{Others, declare, own_name};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{Range, Region};
use crate::model::Parameter;
use crate::model::budget::SPLIT;
use crate::model::chart::{self, Constraint, MAX_CONDITIONS, Piece};
use crate::model::obligation::Goal;
use crate::model::scope::Scope;
use crate::syntax::{self, ExprKind, StatementKind};

/// The shape parameters of a family, and what is assumed of them.
pub(super) struct Shapes {
    pub(super) parameters: Vec<Parameter>,
    pub(super) constraints: Vec<Constraint>,
}

/// Declares the shape parameters, which become variables 0, 1, …, and reads what is assumed of them.
pub(super) fn shapes(scope: &mut Scope<'_>, written: &syntax::Family) -> Option<Shapes> {
    let mut shapes = Shapes { parameters: Vec::new(), constraints: Vec::new() };
    let mut complete = true;
    let mut others = Others::new(written);
    for statement in &written.statements {
        let StatementKind::Shape(decls) = &statement.kind else { continue };
        for decl in decls {
            if let Some(place) = own_name(decl).and_then(|own| others.later.iter().position(|n| *n == own)) {
                others.later.remove(place);
            }
            if !declare(scope, decl, &statement.doc, &others, &mut shapes) {
                complete = false;
                // What follows from that is not another mistake.
                let names = decl.parts.iter().filter_map(syntax::Expr::named).map(String::from);
                scope.undeclared.borrow_mut().extend(names);
            }
            let with_index = decl.parts.iter().filter(|part| matches!(part.kind, ExprKind::Index(..)));
            for name in with_index.filter_map(syntax::Expr::named) {
                // Of an end of a range the name may be a list that `let` gives.
                let is_other = scope.planned.named(name).is_some() || scope.variable(name).is_some();
                if complete && !is_other && !scope.is_list_of_shapes(name) {
                    scope.empty_lists.push(String::from(name));
                }
            }
        }
    }
    let mut last = None;
    for statement in &written.statements {
        let StatementKind::Assume(relation) = &statement.kind else { continue };
        last = Some(relation.span);
        complete &= !complete || assume(scope, relation, &mut shapes);
    }
    if !complete {
        return None;
    }
    let first = written.statements.iter().find(|s| matches!(s.kind, StatementKind::Shape(_)));
    let span = last.or(first.map(|s| s.span)).unwrap_or_else(Span::call_site);
    has_values(scope, &shapes, span).then_some(shapes)
}

/// Whether there are shape values that satisfy all that is assumed; if not, that is reported.
pub(super) fn has_values(scope: &mut Scope<'_>, shapes: &Shapes, span: Span) -> bool {
    let ranges = shapes.parameters.mapped(|p| (p.var, p.range.clone()));
    let constraints = shapes.constraints.mapped(|c| (c.value.clone(), c.relation));
    let fixed = core::mem::take(&mut scope.impossible);
    match parts(scope, &ranges, &constraints, span) {
        None => return false,
        Some(pieces) if fixed.is_none() && !pieces.is_empty() => return true,
        Some(_) => {}
    }
    let texts = chart::texts(&shapes.constraints);
    let message = "no shape values satisfy all that is assumed";
    let Some((span, equation)) = fixed else {
        let error = scope.error(span, message);
        let error =
            if texts.is_empty() { error } else { error.note(format!("assumed is {}", texts.join(", "))) };
        scope.report(error.help("widen the ranges, or leave an assumption out"));
        return false;
    };
    // With the parameters that others determine it says that one number is another.
    let error = scope.error(span, message);
    let others = scope.equations.mapped(|other| format!("`{other}`"));
    let known = scope.determined.mapped(|(name, value)| format!("{name} = {}", value.display(&scope.names)));
    let error = if others.is_empty() {
        error.note(format!("`{equation}` is false for all values"))
    } else {
        let (others, known) = (crate::plural::list(&others), known.join(", "));
        error.note(format!("`{equation}` contradicts {others}, by which {known}"))
    };
    scope.report(error.help("leave one of the equations out, or correct it"));
    false
}

/// Notes that a value has a sign; it must be a polynomial.
fn constrain(
    scope: &Scope<'_>,
    value: &Fraction,
    relation: Relation,
    text: String,
    span: Span,
    shapes: &mut Shapes,
) -> Option<()> {
    if shapes.constraints.len() == MAX_CONDITIONS {
        let message = format!("a family has at most {MAX_CONDITIONS} conditions on its shape values");
        scope.report(scope.error(span, message).help("leave out those that follow from others"));
        return None;
    }
    let Some(value) = value.as_poly() else {
        let error = scope.error(span, "a denominator contains a parameter in a condition on shape values");
        scope.report(error.help("multiply by it: write the condition with polynomials"));
        return None;
    };
    shapes.constraints.push(Constraint { value: value.clone(), relation, text, is_end: false });
    Some(())
}

/// The values that satisfy conditions, in parts; none if it is known that there are no such values. `None` when that takes
/// too much work, which is reported.
pub(crate) fn parts(
    scope: &Scope<'_>,
    ranges: &[(Var, Range)],
    constraints: &[(Poly, Relation)],
    span: Span,
) -> Option<Vec<Piece>> {
    let (pieces, units) = basis_prover::measured(&mut || {
        let pieces = chart::pieces(ranges, constraints);
        if pieces.iter().all(|piece| is_empty(scope, piece)) { Vec::new() } else { pieces }
    });
    // Each variable that is eliminated is looked for in all conditions.
    let units = units + 20 * (ranges.len() * constraints.len()) as u64;
    scope.within(scope.budget.run().decision(units), span, SPLIT).map(|()| pieces)
}

/// Whether it is known that a part of the values has no points: one of its premises is false everywhere.
fn is_empty(scope: &Scope<'_>, piece: &Piece) -> bool {
    let domain = Rc::new(basis_kernel::Domain::of(Region { ranges: piece.ranges.clone() }));
    piece.premises.iter().any(|(p, relation)| {
        let Some(p) = piece.pull_back(p) else { return false };
        let (value, relation) = (basis_kernel::Quotient::from(-&p), basis_prover::of_negative(*relation));
        let never = Goal::Holds(Proposition::Sign { value, relation, domain: Rc::clone(&domain) });
        // Where proofs are checked later, nothing is known.
        matches!(scope.library.judge().judge(&never, 1), Ok(Some(_)))
    })
}

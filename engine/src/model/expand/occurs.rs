//! Whether a family needs angles: sin, cos, exp and the like, π, or a domain that ends at a shape parameter.

use proc_macro2::Span;

use crate::model::words::{PI, is_transcendental};
use crate::syntax::{self, ClaimKind, Expr, ExprKind, Factor, RangeDecl, StatementKind};

/// Where sin, cos, exp or the like, or π, occurs in a family first, or else a shape parameter at an end of the domain.
pub(super) fn first(written: &syntax::Family) -> Option<Span> {
    if written.statements.iter().any(|s| declares_pi(&s.kind)) {
        return None;
    }
    let mut found = None;
    each_expression(written, &mut |expr| found = found.or_else(|| mentioned(expr)));
    found.or_else(|| parametric_end(written))
}

/// Where a shape parameter stands at an end of the domain.
fn parametric_end(written: &syntax::Family) -> Option<Span> {
    let declared = |name: &String| {
        written
            .statements
            .iter()
            .any(|s| matches!(&s.kind, StatementKind::Shape(decls) if decls.iter().any(|d| d.names().contains(&&**name))))
    };
    let decls = written.statements.iter().flat_map(|s| match &s.kind {
        StatementKind::Domain(decls) => decls.as_slice(),
        _ => &[],
    });
    let mut limits = decls.flat_map(|d| d.low.iter().chain(&d.high));
    limits.find(|limit| limit.value.has_name(&declared)).map(|limit| limit.value.span)
}

/// Whether a statement gives the name of π another meaning.
fn declares_pi(kind: &StatementKind) -> bool {
    let is_pi = |name: &syntax::Name| PI.contains(&name.text.as_str());
    match kind {
        // Beside another name it is the number at the end of a range.
        StatementKind::Shape(decls) => decls.iter().any(|d| {
            let names = d.names();
            !names.is_empty() && names.iter().all(|name| PI.contains(name))
        }),
        StatementKind::Domain(decls) => decls.iter().any(|d| is_pi(&d.name)),
        StatementKind::Product(factors) => factors.iter().flat_map(Factor::names).any(is_pi),
        StatementKind::Let(def) => is_pi(&def.name),
        _ => false,
    }
}

/// Calls a function with every expression of a family.
fn each_expression(written: &syntax::Family, with: &mut dyn FnMut(&Expr)) {
    let range = |decl: &RangeDecl, with: &mut dyn FnMut(&Expr)| {
        for limit in decl.low.iter().chain(&decl.high) {
            with(&limit.value);
        }
    };
    for statement in &written.statements {
        match &statement.kind {
            StatementKind::Domain(decls) => decls.iter().for_each(|decl| range(decl, with)),
            StatementKind::Product(factors) => {
                factors.iter().filter_map(Factor::range).for_each(|decl| range(decl, with));
            }
            StatementKind::Shape(decls) => {
                decls.iter().flat_map(|d| &d.parts).for_each(&mut *with);
            }
            StatementKind::Assume(relation) => {
                with(&relation.left);
                with(&relation.right);
                relation.chain.iter().for_each(|(_, side)| with(side));
            }
            StatementKind::Let(def) => with(&def.value),
            StatementKind::Function(def) | StatementKind::Raise(def) => {
                with(&def.value);
                def.further.iter().for_each(&mut *with);
            }
            StatementKind::Base(_, functions) => functions.iter().for_each(|def| with(&def.value)),
            StatementKind::Claim(claim) => match &claim.kind {
                ClaimKind::Relation(r) => sides(r, with),
                ClaimKind::At(bindings, relations) => {
                    for b in bindings {
                        with(&b.value);
                    }
                    for r in relations {
                        sides(r, with);
                    }
                }
                ClaimKind::Independent(exceptions) => {
                    exceptions.iter().flatten().for_each(|b| with(&b.value));
                }
                _ => {}
            },
            StatementKind::Budget(_) => {}
        }
    }
}

/// The sides of a claim.
pub(super) fn sides(relation: &syntax::Relation, with: &mut dyn FnMut(&Expr)) {
    with(&relation.left);
    with(&relation.right);
    relation.chain.iter().for_each(|(_, side)| with(side));
}

/// Where an expression contains π, or a function of angles or exponentials.
fn mentioned(expr: &Expr) -> Option<Span> {
    let own = match &expr.kind {
        ExprKind::Name(name) => PI.contains(&name.as_str()),
        ExprKind::Call(callee, _) => matches!(&callee.kind, ExprKind::Name(name) if is_transcendental(name)),
        _ => false,
    };
    if own { Some(expr.span) } else { expr.parts().into_iter().find_map(mentioned) }
}

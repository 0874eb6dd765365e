//! From claims as they are written to exact differences.

use std::collections::BTreeSet;
use std::rc::Rc;

use proc_macro2::Span;

use super::fixed::{assumed_away, fixed};
use super::names::bound_name;
use super::{names, spans};
use crate::algebra::fraction::{Fraction, set_known_factors};
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::claim::{Claim, ClaimKind, Difference, Joint, Statement};
#[cfg(not(any(test, feature = "rounding")))]
use crate::diagnostic::Diagnostic;
use crate::diagnostic::Diagnostics;
use crate::model::angle::Anew;
use crate::model::formula::Value;
use crate::model::formula::print::{Component, Printer};
use crate::model::obligation::Obligation;
use crate::model::scope::{Inside, Scope};
use crate::model::{Family, Library, Parameter};
use crate::syntax::{self, Binding, Comparison, Expr, Loops, Relation, StatementKind};
use basis_prover::collections::list::Mapped;

/// Statements of a family whose claims are asked for.
pub(super) struct Wanted<'g> {
    /// Their numbers.
    pub(super) numbers: BTreeSet<usize>,
    /// With what the family is expanded.
    pub(super) anew: &'g Anew,
}

/// The claims of a family on one span, which has a number among those of all.
///
/// Statements that turn out to be mistaken are no longer wanted: a mistake is reported once.
pub(super) fn on_span<'a>(
    library: &'a Library<'a>,
    (unit, written): (usize, &'a syntax::Family),
    family: &Family,
    spans: Option<(usize, &[Rc<Family>])>,
    wanted: &mut Wanted<'_>,
) -> (Vec<Claim>, Vec<Obligation>, Diagnostics) {
    let mut scope = Scope::of_family(library, unit, family);
    scope.anew.clone_from(wanted.anew);
    scope.span = spans.map(|(k, all)| (k, all.len()));
    scope.siblings = spans.map(|(_, all)| (all.to_vec(), written));
    set_known_factors(family.analytic.denominators());
    names::plan(&mut scope, written);
    scope.inherit(&family.obligations);
    let mut all = Vec::new();
    for f in &family.functions {
        // What the scope has copied.
        let _ = scope.budget.copy(&f.value);
    }
    // The same values as before; their errors are reported already.
    for def in names::names(written) {
        names::declare(&mut scope, &def.name);
        names::force(&mut scope, &def.name.text);
    }
    for (number, statement) in written.statements.iter().enumerate() {
        match &statement.kind {
            StatementKind::Claim(_) if library.run().is_stopped() => {}
            StatementKind::Claim(_) if !wanted.numbers.contains(&number) => {}
            StatementKind::Claim(claim) => {
                scope.budget.refill();
                let first = all.len();
                let errors = scope.diagnostics.borrow().errors();
                one(&mut scope, family, claim, (number, statement), &mut all);
                if !scope.settle(&|shapes_only| family.parts(shapes_only), family.budget) {
                    all.truncate(first); // what they say has no meaning somewhere
                }
                if scope.diagnostics.borrow().errors() > errors {
                    wanted.numbers.remove(&number);
                }
                for claim in &mut all[first..] {
                    claim.doc.clone_from(&statement.doc);
                }
            }
            _ => {}
        }
    }
    (all, scope.obligations, scope.diagnostics.into_inner())
}

/// Reports what is wrong with the claims of a family that has errors already.
pub(crate) fn look_for_mistakes(scope: &mut Scope<'_>, written: &syntax::Family, family: &Family) {
    for (number, statement) in written.statements.iter().enumerate() {
        if let StatementKind::Claim(claim) = &statement.kind
            && is_about(scope, family, number)
        {
            one(scope, family, claim, (0, statement), &mut Vec::new());
        }
    }
}

/// Whether a statement is about a family as it is expanded, and not about one that is expanded anew.
fn is_about(scope: &Scope<'_>, family: &Family, number: usize) -> bool {
    let own = &scope.anew.statements;
    let mut others = family.analytic.finer.iter();
    own.contains(&number) || own.is_empty() && others.all(|group| !group.contains(&number))
}

/// Appends the claims that one statement makes, which has a number in the family.
fn one(
    scope: &mut Scope<'_>,
    family: &Family,
    claim: &syntax::Claim,
    (number, statement): (usize, &syntax::Statement),
    all: &mut Vec<Claim>,
) {
    let (span, last) = (statement.span, statement.last);
    let mut push =
        |scope: &Scope<'_>, text: String, (span, last): (Span, Span), by: Statement, kind: ClaimKind| {
            let run = scope.budget.run();
            let counted = run.claim(text.len()).and_then(|()| kind.kept(run));
            let fine = scope.fits(counted, span).is_some();
            if fine {
                let place = scope.library.place_to(scope.source, span, last);
                let (doc, expected) = (Vec::new(), claim.expected);
                all.push(Claim { text, doc, expected, place, statement: by, kind, about: None });
            }
            fine
        };
    let by = Statement { number: (number, 0), text: claim.text.clone(), range: "".into() };
    match &claim.kind {
        syntax::ClaimKind::Relation(relation) => {
            self::relation(scope, relation, &[], None, &mut |scope, text, kind| {
                push(scope, text, (span, last), by.clone(), kind)
            });
        }
        syntax::ClaimKind::At(bindings, relations) => {
            let Some(fixed) = fixed(scope, family, bindings) else { return };
            let printer = Printer { constants: &scope.constants, component: None };
            let part = |b: &Binding| format!("{} = {}", bound_text(&printer, b), printer.print(&b.value));
            let parts: Vec<String> = bindings.mapped(part);
            let at = parts.join(", ");
            for (equation, relation) in relations.iter().enumerate() {
                let (text, range) = (relation.text.clone(), relation.range.clone());
                let by = Statement { number: (number, equation), text, range };
                let place = (relation.span, relation.last);
                self::relation(scope, relation, &fixed, Some(&at), &mut |scope, text, kind| {
                    push(scope, format!("at {at}: {text}"), place, by.clone(), kind)
                });
            }
        }
        property => {
            let mut any = false;
            let fine = scope.each(&claim.loops, &mut |scope| {
                any = true;
                let made = self::property(scope, family, property, span);
                made.is_some_and(|(text, kind)| push(scope, text, (span, last), by.clone(), kind))
            });
            // A condition may well hold for other orders.
            if fine && !any && scope.constants.is_empty() {
                nothing_claimed(scope, &claim.loops, span);
            }
        }
    }
}

/// The claim of a property, as text and as what is claimed.
fn property(
    scope: &mut Scope<'_>,
    family: &Family,
    written: &syntax::ClaimKind,
    span: Span,
) -> Option<(String, ClaimKind)> {
    Some(match written {
        syntax::ClaimKind::PartitionOfUnity => {
            (String::from("partition_of_unity"), ClaimKind::PartitionOfUnity)
        }
        syntax::ClaimKind::Nonnegative => (String::from("nonnegative"), ClaimKind::Nonnegative),
        syntax::ClaimKind::Symmetric if scope.span.is_some() => {
            let (k, _) = scope.span?;
            let pieces = scope.siblings.as_ref().map(|(pieces, _)| &pieces[..])?;
            if !spans::are_symmetric(pieces) {
                let error = scope.error(span, "`symmetric` needs spans that are symmetric");
                scope.report(error.help("claim equations on the spans"));
                return None;
            }
            if k > 0 {
                return None; // said on the first span for all
            }
            (String::from("symmetric"), ClaimKind::Symmetric)
        }
        syntax::ClaimKind::Independent(_) if scope.span.is_some_and(|(k, _)| k > 0) => return None,
        syntax::ClaimKind::Continuity(..) if scope.span.is_some() => {
            let error = scope.error(span, "`continuity` is about segments of one span");
            scope.report(error.help("write `smooth(1)` for continuous derivatives at the inner knots"));
            return None;
        }
        syntax::ClaimKind::Smooth(order) => {
            let Some((k, _)) = scope.span else {
                let error = scope.error(span, "`smooth` is about the inner knots of several spans");
                scope.report(
                    error.help(
                        "name the domain variable once for each span: `domain 0 <= x <= 1, 1 <= x <= 3;`",
                    ),
                );
                return None;
            };
            let value = scope.whole(order, "the number of continuous derivatives")?;
            let Some(order) = u32::try_from(value).ok().filter(|k| *k <= crate::model::budget::MAX_DEGREE)
            else {
                let error = scope.error(order.span, format!("{value} continuous derivatives make no sense"));
                scope.report(error.help("write a number from 0 to the degree"));
                return None;
            };
            if k > 0 {
                return None; // said on the first span for all
            }
            (format!("smooth({order})"), ClaimKind::Smooth(order))
        }
        syntax::ClaimKind::Symmetric | syntax::ClaimKind::Continuity(..) if family.leaves_an_end_out() => {
            let name =
                if matches!(written, syntax::ClaimKind::Symmetric) { "symmetric" } else { "continuity" };
            let error = scope.error(span, format!("`{name}` is about a domain with both ends"));
            scope
                .report(error.help("include the ends of the domain, `<=`, or claim equations in its inside"));
            return None;
        }
        syntax::ClaimKind::Symmetric => (String::from("symmetric"), ClaimKind::Symmetric),
        syntax::ClaimKind::Independent(exceptions) => {
            let except = self::exceptions(scope, family, exceptions)?;
            let parts: Vec<String> = except.mapped(|values| describe_values(values, &family.names));
            let text = if parts.is_empty() {
                String::from("independent")
            } else {
                format!("independent except {}", parts.join(", "))
            };
            (text, ClaimKind::Independent(except))
        }
        syntax::ClaimKind::TotallyPositive => {
            if family.interval().is_none() || scope.span.is_some() {
                let error = scope.error(span, "`totally_positive` is about functions on one interval");
                scope.report(error.help(if scope.span.is_some() {
                    "of functions on several spans it is not decided; claim it of a family on one of them"
                } else {
                    "claim it of the factors of functions on a box"
                }));
                return None;
            }
            (String::from("totally_positive"), ClaimKind::TotallyPositive)
        }
        syntax::ClaimKind::Continuity(order, next) => {
            let value = scope.whole(order, "the number of continuous derivatives")?;
            let Some(order) = u32::try_from(value).ok().filter(|k| *k <= crate::model::budget::MAX_DEGREE)
            else {
                let error = scope.error(order.span, format!("{value} continuous derivatives make no sense"));
                scope.report(error.help("write a number from 0 to the degree"));
                return None;
            };
            if family.interval().is_none() || family.functions.iter().any(|f| f.index.len() != 1) {
                let error = scope.error(
                    span,
                    "only segments of curves have neighbours: `continuity` needs one domain variable and one index",
                );
                scope.report(error.help("claim in a `theorem` how two patches join"));
                return None;
            }
            let mut text = format!("continuity({order})");
            let mut joint = Joint { order, next: Vec::new(), free: Vec::new() };
            if !next.is_empty() {
                let printer = Printer { constants: &scope.constants, component: None };
                let part = |b: &Binding| format!("{} = {}", bound_text(&printer, b), printer.print(&b.value));
                text += &format!(" with {}", next.mapped(part).join(", "));
                joint = neighbour(scope, family, next, order, span)?;
            }
            (text, ClaimKind::Continuity(joint))
        }
        #[cfg(not(any(test, feature = "rounding")))]
        syntax::ClaimKind::Rounding(_) => {
            let place = scope.place(span);
            scope.report(Diagnostic::needs_feature(place, "claims about rounding need", "rounding"));
            return None;
        }
        #[cfg(any(test, feature = "rounding"))]
        syntax::ClaimKind::Rounding(bound) => {
            let value = scope.number(bound, "a bound of rounding errors")?;
            if !value.is_positive() {
                let error = scope.error(bound.span, "a bound of rounding errors is a positive number of ε");
                scope.report(error.help("`basis explain` shows the bound that can be proved"));
                return None;
            }
            (format!("rounding <= {value}"), ClaimKind::Rounding(value))
        }
        syntax::ClaimKind::Relation(_) | syntax::ClaimKind::At(..) => return None,
    })
}

/// A name that gets a value, as text.
fn bound_text(printer: &Printer<'_>, binding: &Binding) -> String {
    let indices = binding.indices.mapped(|i| printer.print(i)).join(",");
    let name = &binding.name.text;
    if indices.is_empty() { name.clone() } else { format!("{name}[{indices}]") }
}

/// The shape values of the next segment: those that are given, and free ones.
fn neighbour(
    scope: &mut Scope<'_>,
    family: &Family,
    next: &[Binding],
    order: u32,
    span: Span,
) -> Option<Joint> {
    if !family.constraints.is_empty() {
        let error = scope.error(span, "a neighbour with other shape values violates what is assumed");
        scope.report(error.help("state the joint in a `theorem`, or for equal shape values"));
        return None;
    }
    let mut given: Vec<(Var, Fraction)> = Vec::new();
    for binding in next {
        let name = bound_name(scope, binding)?;
        let Some(shape) = family.shapes.iter().find(|s| s.name == name) else {
            let known: Vec<String> = family.shapes.mapped(|s| s.name.clone());
            let error = scope.error(binding.name.span, format!("`{name}` is not a shape parameter"));
            scope.report(error.help(if known.is_empty() {
                String::from("the family has no shape parameters: leave `with` out")
            } else {
                format!("the next segment has {}", crate::plural::list(&known))
            }));
            return None;
        };
        if given.iter().any(|(v, _)| *v == shape.var) {
            let error = scope.error(binding.name.span, format!("`{name}` is given twice"));
            scope.report(error.help("on the left stands each shape parameter of the next segment once"));
            return None;
        }
        let value = scope.scalar(&binding.value)?;
        if let Some(var) = scope.domain.iter().find(|v| value.depends_on(**v)) {
            let message = format!("the value contains the domain variable `{}`", scope.names[var.0]);
            let error = scope.error(binding.value.span, message);
            scope.report(error.help("shape values of the next segment are made of those of this one"));
            return None;
        }
        let inside = Inside {
            value: value.clone(),
            name,
            range: shape.range.clone(),
            family: None,
            assumable: false,
            written: None,
        };
        let place = scope.place(binding.value.span);
        match value.as_constant() {
            Some(c) if !shape.range.contains(&c) => {
                scope.report(inside.outside(&c, place));
                return None;
            }
            Some(_) => {}
            None => scope.must_stay_inside(inside, place),
        }
        given.push((shape.var, value));
    }
    let mut joint = Joint { order, next: Vec::new(), free: Vec::new() };
    for shape in &family.shapes {
        let own = given.iter().find(|(v, _)| *v == shape.var).map(|(_, value)| value.clone());
        joint.next.push(own.unwrap_or_else(|| {
            let var = Var(family.names.len() + joint.free.len());
            joint.free.push(Parameter { name: format!("{}'", shape.name), var, ..shape.clone() });
            Fraction::var(var)
        }));
    }
    Some(joint)
}

fn describe_values(values: &[(Var, Rational)], names: &[String]) -> String {
    let parts: Vec<String> = values.mapped(|(v, x)| format!("{} = {x}", names[v.0]));
    if parts.len() == 1 { parts.concat() } else { format!("({})", parts.join(", ")) }
}

/// The shape values that an `except` lists.
fn exceptions(
    scope: &mut Scope<'_>,
    family: &Family,
    written: &[Vec<Binding>],
) -> Option<Vec<Vec<(Var, Rational)>>> {
    let mut all = Vec::new();
    for exception in written {
        let mut values: Vec<(Var, Rational)> = Vec::new();
        for binding in exception {
            let name = bound_name(scope, binding)?;
            let named = |s: &&Parameter| scope.names[scope.itself(s.var).0] == name;
            let found = family.shapes.iter().find(named);
            let angle = found.and_then(|s| family.analytic.angle(s.var)).cloned();
            let value = match &angle {
                Some(angle) => {
                    let value = scope.scalar(&binding.value)?;
                    let tangent = scope.angle_at(angle, &value, binding.value.span);
                    match tangent.map(|x| x.map(|x| x.as_constant())) {
                        Ok(x) => x??,
                        Err((message, help)) => {
                            scope.report(scope.error(binding.value.span, message).help(help));
                            return None;
                        }
                    }
                }
                None => scope.number(&binding.value, "an exceptional value")?,
            };
            let Some(shape) = found else {
                if scope.is_mistaken(&name) {
                    return None;
                }
                let known: Vec<String> = family.shapes.mapped(|s| scope.names[scope.itself(s.var).0].clone());
                let error = scope.error(binding.name.span, format!("`{name}` is not a shape parameter"));
                scope.report(if known.is_empty() {
                    error.help("the family has no shape parameters")
                } else {
                    error.help(format!("shape parameters are {}", crate::plural::list(&known)))
                });
                return None;
            };
            if !shape.range.contains(&value) {
                let range = family.declared(shape);
                let error = scope.error(
                    binding.value.span,
                    match &angle {
                        Some(angle) => {
                            format!("the value of {} is outside of the declared range `{range}`", angle.name)
                        }
                        None => {
                            format!("{} = {value} is outside of the declared range `{range}`", shape.name)
                        }
                    },
                );
                scope.report(error.help("only values inside the range can be exceptions"));
                return None;
            }
            if values.iter().any(|(v, _)| *v == shape.var) {
                scope.report(scope.error(binding.name.span, format!("`{}` is given twice", shape.name)));
                return None;
            }
            values.push((shape.var, value));
        }
        let fixed = values.mapped(|(v, x)| (*v, Fraction::constant(x.clone())));
        if let (Some(first), true) = (exception.first(), family.pieces(&fixed, &[], true).is_empty()) {
            assumed_away(scope, family, first.name.span, "an exception violates what is assumed");
            return None;
        }
        all.push(values);
    }
    Some(all)
}

/// Takes a claim; whether there is room for it.
type Push<'p> = dyn FnMut(&Scope<'_>, String, ClaimKind) -> bool + 'p;

/// One equation or inequality, for each value of its index variables.
fn relation(
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
fn nothing_claimed(scope: &Scope<'_>, loops: &Loops, span: Span) {
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

//! What theorems assume of their scalars: ranges, and relations between several of them.

use basis_kernel::Relation;
use proc_macro2::Span;

use super::draft::{Elaboration, Value, kind};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{PolyExt as _, Var};
use crate::algebra::range::{Range, Region};
use crate::model::chart::{Constraint, MAX_CONDITIONS, Piece};
use crate::model::formula::numbers::range_of;
use crate::model::formula::print::Printer;
use crate::model::{Family, Parameter, parts};
use crate::syntax::{Bounds, Comparison, Expr, ExprKind, Limit, Relation as Written};
use basis_prover::collections::list::{Listed, Mapped};

impl Elaboration<'_> {
    /// `scalar …;`: ends that are numbers make the range, others are relations to what they hold.
    pub(super) fn declared(&mut self, bounds: &Bounds, doc: &[String]) -> Option<()> {
        let numbers = |end: &'_ Option<Limit>| end.as_ref().is_some_and(|end| !self.depends(&end.value));
        let (low, high) = (numbers(&bounds.low), numbers(&bounds.high));
        let range = self.range_between(bounds, low, high);
        self.declare(&bounds.target, range.clone().unwrap_or(Range::all()), doc)?;
        range?;
        let limits = [(&bounds.low, low, true), (&bounds.high, high, false)];
        for (limit, is_number, is_low) in limits {
            let Some(limit) = limit.as_ref().filter(|_| !is_number) else { continue };
            let sign = if limit.included { Comparison::LessEqual } else { Comparison::Less };
            let (left, right) =
                if is_low { (&limit.value, &bounds.target) } else { (&bounds.target, &limit.value) };
            self.relate(left, sign, right, limit.value.span)?;
        }
        Some(())
    }

    /// `assume …;`: a range is narrowed by numbers, or scalars are related to one another.
    pub(super) fn assume(&mut self, written: &Written) -> Option<()> {
        if let Some((target, low, high)) = self.narrowed(written) {
            return self.narrow_by(&target, low, high);
        }
        let mut left = &written.left;
        let first = core::iter::once((written.comparison, &written.right));
        for (sign, right) in first.chain(written.chain.iter().map(|(sign, side)| (*sign, side))) {
            self.relate(left, sign, right, written.span)?;
            left = right;
        }
        Some(())
    }

    /// The scalar that an assumption compares with numbers, and these, below and above.
    fn narrowed(&self, written: &Written) -> Option<(Expr, Option<Limit>, Option<Limit>)> {
        // What `let` or a curve gives a value has no range.
        let is_name = |e: &Expr| {
            let name = match &e.kind {
                ExprKind::Index(base, _) => base,
                _ => e,
            };
            let ExprKind::Name(name) = &name.kind else { return false };
            let known = self.taken(name).is_some_and(|what| what != "a scalar");
            let entry = |own: &String| own.starts_with(name.as_str()) && own[name.len()..].starts_with('[');
            !known && !self.scope.lets.keys().any(entry)
        };
        let mut sides = vec![&written.left, &written.right];
        let mut signs = vec![written.comparison];
        for (sign, side) in &written.chain {
            sides.push(side);
            signs.push(*sign);
        }
        // Read upwards.
        if matches!(signs[0], Comparison::Greater | Comparison::GreaterEqual) {
            sides.reverse();
            signs.reverse();
        }
        let limit = |value: &Expr, sign: Comparison| {
            let included = matches!(sign, Comparison::LessEqual | Comparison::GreaterEqual);
            Some(Limit { value: value.clone(), included })
        };
        if signs.iter().any(|sign| matches!(sign, Comparison::Equal | Comparison::NotEqual)) {
            return None;
        }
        let number = |e: &Expr| !self.depends(e);
        match (&sides[..], &signs[..]) {
            ([a, b], [sign]) if is_name(a) && number(b) => Some(((*a).clone(), None, limit(b, *sign))),
            ([a, b], [sign]) if number(a) && is_name(b) => Some(((*b).clone(), limit(a, *sign), None)),
            ([a, b, c], [i, j]) if number(a) && is_name(b) && number(c) => {
                Some(((*b).clone(), limit(a, *i), limit(c, *j)))
            }
            _ => None,
        }
    }

    /// The scalar lies in another range, too.
    fn narrow_by(&mut self, target: &Expr, low: Option<Limit>, high: Option<Limit>) -> Option<()> {
        let name = self.target_name(target)?;
        let bounds = Bounds { target: target.clone(), low, high };
        let range = self.range_between(&bounds, true, true)?;
        let Some(at) = self.scope.variable(&name).and_then(|v| self.scalars.iter().position(|p| p.var == v))
        else {
            self.unknown(&name, target.span);
            return None;
        };
        // A parameter that was narrowed is known: it cannot be declared again.
        let var = self.scalars[at].var;
        self.implicit.retain(|p| p.var != var);
        self.narrow(at, &range, target.span)
    }

    /// Whether something else than numbers and index variables stands in an expression.
    fn depends(&self, expr: &Expr) -> bool {
        self.scope.mentions_variable(expr)
    }

    /// The range between those ends that are numbers.
    fn range_between(&mut self, bounds: &Bounds, low: bool, high: bool) -> Option<Range> {
        let (low, high) = (bounds.low.as_ref().filter(|_| low), bounds.high.as_ref().filter(|_| high));
        let name = Printer { constants: &self.scope.constants, component: None }.print(&bounds.target);
        range_of(&mut self.scope, bounds.target.span, (low, high), None, &|| name.clone())
    }

    /// A side of an assumption.
    fn assumed(&mut self, side: &Expr) -> Option<Fraction> {
        match self.definite(side)? {
            Value::Scalar(value) => Some(value),
            other => {
                let message = format!("an assumption is about scalars, this is {}", kind(&other));
                let error = self.scope.error(side.span, message);
                self.scope.report(error.help("a control point gets its value by `let Q[0] = P[3];`"));
                None
            }
        }
    }

    /// Notes that two sides compare in this way.
    fn relate(&mut self, left: &Expr, sign: Comparison, right: &Expr, span: Span) -> Option<()> {
        let (a, b) = (self.assumed(left)?, self.assumed(right)?);
        let printer = Printer { constants: &self.scope.constants, component: None };
        let text = format!("{} {} {}", printer.print(left), sign.symbol(), printer.print(right));
        let relation = match sign {
            Comparison::LessEqual | Comparison::GreaterEqual => Relation::NonNegative,
            Comparison::Less | Comparison::Greater => Relation::Positive,
            Comparison::Equal | Comparison::NotEqual => {
                let error = self.scope.error(span, "an assumption about scalars is an inequality");
                let help = if sign == Comparison::Equal {
                    "give a scalar its value by `let c = …;`"
                } else {
                    "assume on which side it is, `assume a > b;`, in a theorem for each side"
                };
                self.scope.report(error.help(help));
                return None;
            }
        };
        let (from, to) =
            if matches!(sign, Comparison::Less | Comparison::LessEqual) { (a, b) } else { (b, a) };
        let difference = self.fits(self.scope.budget.sub(&to, &from), span)?;
        self.constrain(&difference, relation, text, span)
    }

    /// Notes that a polynomial in scalars has a sign.
    fn constrain(&mut self, value: &Fraction, relation: Relation, text: String, span: Span) -> Option<()> {
        let Some(value) = value.as_poly() else {
            let error = self.scope.error(span, "a denominator contains a scalar in an assumption");
            self.scope.report(error.help("multiply by it: write the condition with polynomials"));
            return None;
        };
        if self.relations.len() == MAX_CONDITIONS {
            let message = format!("a theorem has at most {MAX_CONDITIONS} conditions on its scalars");
            self.scope
                .report(self.scope.error(span, message).help("leave out those that follow from others"));
            return None;
        }
        let is_scalar = |v: &Var| self.scalars.iter().any(|p| p.var == *v);
        if value.variables().iter().any(|v| !is_scalar(v)) {
            let error = self.scope.error(span, "an assumption is about scalars, not about points");
            self.scope.report(
                error.help("determine points by `let`, or give them coordinates that are scalars: `curve P = Bernstein(1) [(a, b), (c, d)];`"),
            );
            return None;
        }
        if value.as_constant().is_some_and(|c| !relation.holds(&c)) {
            self.impossible(span, &text);
            return None;
        }
        self.relations.push((Constraint { value: value.clone(), relation, text, is_end: false }, span));
        Some(())
    }

    /// What a family assumes of its shape values: of new names, which stand for its shape parameters, it is assumed
    /// here, too; of any others it is to be shown.
    pub(super) fn inherit(&mut self, family: &Family, values: &[Fraction], span: Span) -> Option<()> {
        let names = values.mapped(|value| value.as_var().filter(|var| self.shape_values.contains(var)));
        let mut open = Vec::new();
        for constraint in &family.constraints {
            let own = |p: &Parameter| constraint.value.depends_on(p.var);
            let mut used = family.shapes.iter().zip(&names).filter(|(p, _)| own(p));
            if constraint.is_end || used.any(|(_, name)| name.is_none()) {
                open.push(constraint);
                continue;
            }
            // Each parameter has its place in the list of the values.
            let mut renamed = vec![Var(0); family.names.len()];
            for (p, name) in family.shapes.iter().zip(&names) {
                renamed[p.var.0] = name.unwrap_or(Var(0));
            }
            let value = constraint.value.rename(&renamed);
            let same = |(p, name): (&Parameter, &Option<Var>)| {
                name.is_some_and(|name| self.scope.names[name.0] == p.name)
            };
            let text = if family.shapes.iter().zip(&names).all(same) {
                constraint.text.clone()
            } else {
                let sign = if constraint.relation == Relation::Positive { ">" } else { ">=" };
                format!("{} {sign} 0", value.display(&self.scope.names))
            };
            let relation = constraint.relation;
            self.relations.push((Constraint { value, relation, text, is_end: false }, span));
        }
        self.scope.must_hold(family, &open, values, span)
    }

    /// The values of the scalars in parts that are images of boxes; `None`, which is reported, if there are none.
    pub(super) fn parts(&mut self, region: &Region) -> Option<Vec<Piece>> {
        if self.relations.is_empty() {
            return Some(vec![Piece::plain(region.ranges.clone())]);
        }
        let constraints = self.relations.iter().map(|(c, _)| (c.value.clone(), c.relation)).listed();
        let (_, span) = self.relations.last()?;
        let pieces = parts(&self.scope, &region.ranges, &constraints, *span)?;
        if pieces.is_empty() {
            let texts = self.relations.iter().map(|(c, _)| c.text.clone()).listed();
            self.impossible(*span, &texts.join(", "));
            return None;
        }
        Some(pieces)
    }

    fn impossible(&self, span: Span, texts: &str) {
        let error = self.scope.error(span, "no values of the scalars satisfy all that is assumed");
        let error = error.note(format!("assumed is {texts}"));
        self.scope.report(error.help("widen the ranges, or leave an assumption out"));
    }
}

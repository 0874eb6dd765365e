//! Goes through the statements of a theorem in the order in which they are written.

use std::rc::Rc;

use proc_macro2::Span;

use super::draft::{Elaboration, OWN, PatchDef, Value, kind};
use super::{Origin, Theorem, TheoremKind, TheoremRelation};
use crate::advice::did_you_mean;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::range::{Range, Region};
use crate::ascii::lowercase;
use crate::claim::{Claim, ClaimKind, Comparison, Difference, Side, Statement};
use crate::diagnostic::Diagnostics;
use crate::model::Library;
use crate::model::chart::Piece;
use crate::model::formula::numbers::budget_value;
use crate::model::formula::print::Printer;
use crate::model::scope::{Scope, Subject};
use crate::source::SourceId;
use crate::subject::{Item, Subject as About};
use crate::syntax::{self, Assertion, Expr, ExprKind, TheoremStatement, TheoremStatementKind};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::sort::sort;

/// The most coordinates of a point.
const MAX_DIMENSION: i64 = 8;

/// The most variables of a theorem.
const MAX_VARIABLES: usize = 1024;

/// The theorems and joins of the spec that a library was asked for; those with errors are left out.
pub fn theorems(library: &Library<'_>) -> Vec<Item> {
    let mut items = Vec::new();
    library.each_theorem(&mut |unit, source, written| {
        let (item, diagnostics) = theorem(library, unit, source, written);
        items.extend(item.filter(|_| diagnostics.is_empty()));
        diagnostics
    });
    items
}

/// Reads a theorem; `None`, or anything with messages, cannot be used.
fn theorem(
    library: &Library<'_>,
    unit: usize,
    source: SourceId,
    written: &syntax::Theorem,
) -> (Option<Item>, Diagnostics) {
    let mut scope = Scope::new(library, unit, source);
    scope.subject = Subject::Theorem;
    scope.names = vec![String::new(); OWN];
    let mut all = Elaboration {
        scope,
        kind: written.kind,
        scalars: Vec::new(),
        relations: Vec::new(),
        implicit: Vec::new(),
        shape_values: Vec::new(),
        vectors: Vec::new(),
        patches: Vec::new(),
        incomplete: false,
        points: Vec::new(),
        dimension: None,
        products: Vec::new(),
    };
    let theorem = all.theorem(written);
    (theorem, all.scope.diagnostics.into_inner())
}

/// Statements in an order in which scalars are declared before they are used.
fn in_order(written: &[TheoremStatement]) -> Vec<&TheoremStatement> {
    let scalar = |(k, statement): (usize, &'_ TheoremStatement)| match &statement.kind {
        TheoremStatementKind::Scalar(bounds, _) => Some((String::from(bounds.target.named()?), k)),
        _ => None,
    };
    let mut scalars = written.iter().enumerate().filter_map(scalar).listed();
    sort(&mut scalars);
    let mut order: Vec<usize> = Vec::new();
    let mut is_placed = vec![false; written.len()];
    for (k, statement) in written.iter().enumerate() {
        let used: Vec<&Expr> = match &statement.kind {
            TheoremStatementKind::Patch(_, _, value) => vec![value],
            TheoremStatementKind::Let(target, value, _) => vec![target, value],
            TheoremStatementKind::Assume(relation) => vec![&relation.left, &relation.right],
            _ => Vec::new(),
        };
        let mut next = Vec::new();
        for name in used.into_iter().flat_map(Expr::names) {
            let first = scalars.partition_point(|(scalar, _)| scalar.as_str() < name);
            next.extend(
                scalars[first..].iter().take_while(|(scalar, _)| scalar == name).map(|(_, own)| *own),
            );
        }
        sort(&mut next);
        next.push(k);
        for own in next {
            if !core::mem::replace(&mut is_placed[own], true) {
                order.push(own);
            }
        }
    }
    order.into_iter().map(|k| &written[k]).listed()
}

impl Elaboration<'_> {
    fn theorem(&mut self, written: &syntax::Theorem) -> Option<Item> {
        self.scope.unread.clone_from(&written.unread);
        let dimension = self.find_dimension(&written.statements);
        let mut fine = dimension.is_some();
        let mut budget = 1;
        let mut claims = Vec::new();
        // Claims come last: they see every range as it is narrowed in the end, and every control point.
        for statement in in_order(&written.statements) {
            self.scope.budget.refill();
            fine &= self.statement(statement, &mut budget).is_some();
            let names = self.vectors.len() + self.patches.len() + self.scope.lets.len();
            if !self.scope.has_room(names, statement.span) {
                return None;
            }
            if self.scope.names.len() > MAX_VARIABLES {
                let message =
                    format!("a theorem has at most {MAX_VARIABLES} scalars, coordinates and dot products");
                let error = self.scope.error(statement.span, message);
                self.scope.report(error.help("state it for fewer control points, or without coordinates"));
                return None;
            }
        }
        // Without a statement that could not be read, claims would complain about names that it declares.
        if written.incomplete {
            return None;
        }
        for (number, statement) in written.statements.iter().enumerate() {
            if let TheoremStatementKind::Claim(assertion) = &statement.kind {
                self.scope.budget.refill();
                fine &= self.assertion((number, statement), assertion, &mut claims).is_some();
            }
        }
        if fine && claims.is_empty() {
            let what = written.kind.keyword();
            let message = format!("the {what} `{}` claims nothing", written.name.text);
            let error = self.scope.error(written.name.span, message);
            self.scope.report(error.help("write `prove … == …;`"));
        }
        if written.kind == TheoremKind::Join && fine {
            self.check_join(written, dimension.flatten());
        }
        if !fine {
            return None;
        }
        let silent: Vec<Var> = self.implicit.iter().filter(|p| !p.mentioned).map(|p| p.var).listed();
        let region = Region { ranges: self.scalars.mapped(|p| (p.var, p.range.clone())) };
        let with_domain = |piece: Piece| {
            let domain = Rc::new(piece.domain());
            (piece, domain)
        };
        let whole: Vec<_> = self.parts(&region)?.into_iter().map(with_domain).listed();
        self.scope.settle(&|_| whole.clone(), budget);
        self.scalars.retain(|p| !silent.contains(&p.var));
        let region = Region { ranges: self.scalars.mapped(|p| (p.var, p.range.clone())) };
        let parts = if self.relations.is_empty() { Vec::new() } else { self.parts(&region)? };
        let theorem = Theorem {
            kind: written.kind,
            name: written.name.text.clone(),
            doc: written.doc.clone(),
            source: self.scope.source,
            place: self.scope.place(written.name.span),
            names: self.scope.names.clone(),
            scalars: core::mem::take(&mut self.scalars),
            relations: self.relations.iter().map(|(c, _)| c.clone()).listed(),
            parts,
            part: Piece::default(),
            dimension: self.dimension,
            products: core::mem::take(&mut self.products),
            patches: core::mem::take(&mut self.patches).into_iter().map(PatchDef::finish).listed(),
            points: core::mem::take(&mut self.points),
            budget,
        };
        let obligations = core::mem::take(&mut self.scope.obligations);
        Some(Item { subject: About::Theorem(Rc::new(theorem)), obligations, claims })
    }

    /// A join determines points for any given ones.
    fn check_join(&self, written: &syntax::Theorem, coordinates: Option<Span>) {
        let name = &written.name;
        if let Some(span) = coordinates {
            let error = self.scope.error(span, "the points of a join have no coordinates");
            self.scope.report(
                error
                    .also(self.scope.place(name.span), "a join is for points of any space")
                    .help("leave this out; what is true of coordinates is stated in a `theorem`"),
            );
        } else if self.patches.iter().all(|p| p.points.iter().all(|p| p.origin != Origin::Determined)) {
            let error =
                self.scope.error(name.span, format!("the join `{}` determines no control point", name.text));
            self.scope.report(error.help("write `let Q[0] = P[2];`, or `theorem` in place of `join`"));
        }
    }

    /// Finds the number of coordinates: as declared, or that of the points that are written with coordinates; where
    /// that is said. `None` if the number makes no sense.
    #[expect(clippy::option_option, reason = "it can be fine without coordinates")]
    fn find_dimension(&mut self, statements: &[TheoremStatement]) -> Option<Option<Span>> {
        let mut declared = None;
        let mut seen = None;
        for statement in statements {
            match &statement.kind {
                TheoremStatementKind::Dimension(value) => {
                    let n = self.scope.whole(value, "the dimension")?;
                    if !(1..=MAX_DIMENSION).contains(&n) {
                        let error =
                            self.scope.error(value.span, format!("the dimension {n} is not supported"));
                        self.scope.report(error.help(format!("write a number from 1 to {MAX_DIMENSION}")));
                        return None;
                    }
                    declared = Some((n as usize, statement.span));
                }
                TheoremStatementKind::Patch(_, _, value) | TheoremStatementKind::Let(_, value, _) => {
                    seen = seen.or_else(|| coordinates(value));
                }
                TheoremStatementKind::Claim(claim) => {
                    seen = seen.or_else(|| coordinates(&claim.left)).or_else(|| coordinates(&claim.right));
                }
                _ => {}
            }
        }
        let found = declared.or(seen);
        self.dimension = found.map(|(n, _)| n);
        Some(found.map(|(_, span)| span))
    }

    fn statement(&mut self, statement: &TheoremStatement, budget: &mut u32) -> Option<()> {
        match &statement.kind {
            TheoremStatementKind::Patch(kind, name, value) => {
                let done = self.patch(*kind, name, value);
                self.incomplete |= done.is_none();
                if done.is_none() && self.taken(&name.text).is_none() {
                    // Known without a value, so that nothing more is said about it.
                    self.vectors.push((name.text.clone(), None));
                }
                done
            }
            TheoremStatementKind::Scalar(bounds, loops) => {
                self.each(loops, &mut |all| all.declared(bounds, &statement.doc))
            }
            TheoremStatementKind::Assume(written) => {
                self.each(&written.loops, &mut |all| all.assume(written))
            }
            TheoremStatementKind::Let(target, value, loops) => {
                self.each(loops, &mut |all| all.define(target, value))
            }
            TheoremStatementKind::Budget(value) => {
                *budget = budget_value(&mut self.scope, value)?;
                Some(())
            }
            TheoremStatementKind::Dimension(_) | TheoremStatementKind::Claim(_) => Some(()),
        }
    }

    /// `scalar …;`
    pub(super) fn declare(&mut self, target: &Expr, range: Range, doc: &[String]) -> Option<()> {
        let name = self.target_name(target)?;
        // The parameter of a patch may be declared, with a range of its own.
        if let Some(var) = self.scope.variable(&name)
            && let Some(at) = self.implicit.iter().position(|p| p.var == var)
        {
            self.implicit.remove(at);
            let scalar = self.scalars.iter_mut().find(|p| p.var == var)?;
            scalar.range = range;
            scalar.doc = doc.to_vec();
            return Some(());
        }
        self.check_free(&name, target.span)?;
        self.new_scalar(&name, range, doc, target.span);
        Some(())
    }

    /// `let name = …;` or `let P[i] = …;`
    fn define(&mut self, target: &Expr, value: &Expr) -> Option<()> {
        if let ExprKind::Index(base, indices) = &target.kind
            && let ExprKind::Name(name) = &base.kind
            && let Some(patch) = self.patches.iter().position(|p| p.name == *name)
        {
            let index = self.indices(indices)?;
            return self.define_point(patch, &index, target.span, value);
        }
        let name = self.target_name(target)?;
        self.check_free(&name, target.span)?;
        let value_of = self.definite(value);
        if let (true, ExprKind::Index(base, _), Some(Value::Vector(_))) =
            (self.kind == TheoremKind::Join, &target.kind, &value_of)
        {
            return self.no_patch(base, &name);
        }
        match value_of {
            Some(Value::Scalar(f)) => {
                self.scope.lets.insert(name, Some(crate::model::formula::Value::Scalar(f)));
            }
            other => {
                let fine = other.is_some();
                self.vectors.push((name, other));
                return fine.then_some(());
            }
        }
        Some(())
    }

    /// In a join a vector with an index is a control point, of a curve that has to be declared.
    fn no_patch(&self, base: &Expr, point: &str) -> Option<()> {
        let patches = self.patches.mapped(|p| p.name.as_str());
        let written = Printer { constants: &[], component: None }.print(base);
        // A curve or surface that could not be read.
        if self.vectors.iter().any(|(name, value)| *name == written && value.is_none())
            || self.scope.is_mistaken(&written)
        {
            return None;
        }
        let error = self.scope.error(base.span, format!("there is no curve or surface `{written}`"));
        let otherwise = || {
            format!(
                "declare it, `curve {written} = …;`, before its control point `{point}` is determined; other vectors have names without an index"
            )
        };
        self.scope.undeclared.borrow_mut().push(written.clone());
        let other_case = patches.iter().find(|p| lowercase(p) == lowercase(&written));
        self.scope.report(error.help(match other_case {
            Some(near) => format!("did you mean `{near}`?"),
            None => did_you_mean(&written, &patches, &otherwise),
        }));
        None
    }

    /// One claim, for each value of its index variables, by a statement with its number in the theorem.
    fn assertion(
        &mut self,
        (number, statement): (usize, &TheoremStatement),
        written: &Assertion,
        claims: &mut Vec<Claim>,
    ) -> Option<()> {
        self.each(&written.loops, &mut |all| {
            let printer = Printer { constants: &all.scope.constants, component: None };
            let texts = printer.difference(&written.left, &written.right);
            let text = format!("{} {} {}", texts.0, written.relation.symbol(), texts.1);
            let kind = all.claim(written, texts)?;
            let run = all.scope.budget.run();
            let counted = run.claim(text.len()).and_then(|()| kind.kept(run));
            all.fits(counted, statement.span)?;
            let place = all.scope.library.place_to(all.scope.source, statement.span, statement.last);
            let (doc, expected) = (statement.doc.clone(), written.expected);
            let by = Statement { number: (number, 0), text: written.text.clone(), range: "".into() };
            claims.push(Claim { text, doc, expected, place, statement: by, kind, about: None });
            Some(())
        })
    }

    /// What is claimed, with the texts of both sides and of their difference.
    fn claim(&mut self, written: &Assertion, texts: (String, String, String)) -> Option<ClaimKind> {
        let (left_text, right_text, text) = texts;
        let left = self.definite(&written.left)?;
        let right = self.definite(&written.right)?;
        let zero = |value: &Value| matches!(value, Value::Scalar(f) if f.is_zero());
        let comparison = match written.relation {
            TheoremRelation::Compare(Comparison::NotEqual) => {
                let error = self.scope.error(written.span, "a claim is an equation or an inequality");
                self.scope.report(error.help("write `refute … == …;` to say that two things differ"));
                return None;
            }
            TheoremRelation::Compare(comparison) => comparison,
            TheoremRelation::Parallel => {
                return match (left, right) {
                    (Value::Vector(a), Value::Vector(b)) | (Value::Outer(a), Value::Outer(b)) => {
                        Some(ClaimKind::Parallel {
                            left: Side { text: left_text, value: a },
                            right: Side { text: right_text, value: b },
                        })
                    }
                    (a, b) => self.mismatch(written.span, "have a direction in common", &a, &b),
                };
            }
        };
        let equal = comparison == Comparison::Equal;
        let is_vector = |value: &Value| matches!(value, Value::Vector(_));
        if !equal && (is_vector(&left) || is_vector(&right)) {
            let message = format!("vectors have no order: `{}` compares scalars", comparison.symbol());
            let error = self.scope.error(written.span, message);
            self.scope.report(error.help(
                "compare coordinates, `P(0)[0] >= 0`, or dot products, `dot(a, b) >= 0`; vectors compare by `==` and `parallel`",
            ));
            return None;
        }
        match (left, right) {
            (Value::Scalar(a), Value::Scalar(b)) => {
                let difference = self.scope.budget.sub(&a, &b);
                let value = self.fits(difference, written.span)?;
                let difference = Difference { left: left_text, right: right_text, text, value };
                Some(ClaimKind::Scalar { comparison, difference })
            }
            (Value::Vector(a), Value::Vector(b)) | (Value::Outer(a), Value::Outer(b)) if equal => {
                let mut difference = a;
                let minus = -&Fraction::constant(crate::algebra::rational::Rational::ONE);
                let done = difference.add_scaled(&b, &minus, &self.scope.budget);
                self.fits(done, written.span)?;
                Some(ClaimKind::Vector { text, value: difference })
            }
            (Value::Vector(form) | Value::Outer(form), other)
            | (other, Value::Vector(form) | Value::Outer(form))
                if equal && zero(&other) =>
            {
                Some(ClaimKind::Vector { text, value: form })
            }
            (a, b) => {
                self.mismatch(written.span, &format!("compare by `{}`", written.relation.symbol()), &a, &b)
            }
        }
    }

    fn mismatch<T>(&self, span: Span, what: &str, a: &Value, b: &Value) -> Option<T> {
        let (a, b) = (kind(a), kind(b));
        let both = if a == b {
            format!("two {}s", &a[a.find(' ').map_or(0, |k| k + 1)..])
        } else {
            format!("{a} and {b}")
        };
        let error = self.scope.error(span, format!("{both} do not {what}"));
        let outer = [a, b].contains(&"an outer product") && [a, b].contains(&"a scalar");
        self.scope.report(error.help(if outer && self.kind == TheoremKind::Theorem {
            "in the plane the cross product is a scalar: write `dimension 2;` at the beginning of the theorem"
        } else {
            "scalars compare by `==`, `<`, `<=`, `>`, `>=`; vectors by `==` and `parallel`; only 0 compares with both"
        }));
        None
    }
}

/// The first point in an expression that is written by its coordinates: their number, and where it stands.
fn coordinates(expr: &Expr) -> Option<(usize, Span)> {
    match &expr.kind {
        ExprKind::Tuple(parts) => Some((parts.len(), expr.span)),
        ExprKind::Number(_) | ExprKind::Name(_) => None,
        ExprKind::Neg(inner) | ExprKind::Each(inner, _) => coordinates(inner),
        ExprKind::Sum(parts) => parts.iter().find_map(|(_, e)| coordinates(e)),
        ExprKind::Product(parts) => parts.iter().find_map(|(_, e)| coordinates(e)),
        ExprKind::Power(base, _) => coordinates(base),
        ExprKind::Index(base, rest) | ExprKind::Call(base, rest) => {
            coordinates(base).or_else(|| rest.iter().find_map(coordinates))
        }
        ExprKind::List(parts) => parts.iter().find_map(coordinates),
    }
}

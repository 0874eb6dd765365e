//! Integrals over several spans: the sum of those over each, of the formulas that hold there.

use std::rc::Rc;

use proc_macro2::Span;

use crate::algebra::fraction::Fraction;
use crate::algebra::rational::Rational;
use crate::model::Family;
use crate::model::expand::names;
use crate::model::expand::spans::ends;
use crate::model::formula::Value;
use crate::model::scope::{CallSite, Inside, Scope, Stage};
use crate::syntax::Expr;
use basis_prover::collections::list::{Listed, Mapped};

/// How deep integrals over spans stand in one another at most: each looks at all spans.
const MAX_DEPTH: usize = 2;

/// Where a bound of an integral lies: a span, and whether it is its lower or upper end.
struct Located {
    piece: usize,
    end: Option<bool>,
}

impl Scope<'_> {
    /// Whether an integral over the domain variable is about the formulas of several spans, which this scope does not know all.
    pub(in crate::model::formula) fn is_of_spans(&self, f: &Expr, whole: bool) -> bool {
        self.span.is_some()
            && (self.siblings.is_some() || self.stage == Stage::Defining)
            && (whole || self.varies(f, self.planned.len()))
    }

    /// Whether an expression may have another formula on another span: it names functions, or an argument that is no variable.
    fn varies(&self, f: &Expr, depth: usize) -> bool {
        f.has_name(&|name| {
            if let Some((_, value)) = self.arguments.iter().find(|(n, _)| n == name) {
                let of_domain = |f: &Fraction| self.domain.iter().any(|v| self.occurs(f, *v));
                return match value {
                    Value::Scalar(f) => f.as_var().is_none() && of_domain(f),
                    Value::List(list) => list.iter().any(|(_, f)| of_domain(f)),
                };
            }
            if self.variable(name).is_some() || self.constants.iter().any(|(n, _)| n == name) {
                return false;
            }
            let planned = self.planned.named(name).filter(|_| depth > 0);
            *name == self.function_name || planned.is_some_and(|p| self.varies(p.value, depth - 1))
        })
    }

    /// The integral over several spans, the sum of those over each; between bounds over the parts that lie between them.
    pub(in crate::model::formula) fn over_spans(
        &mut self,
        f: &Expr,
        bounds: Option<&[Fraction; 2]>,
        span: Span,
    ) -> Option<Value> {
        let Some((pieces, written)) = self.siblings.clone() else {
            let error = self.error(span, "an integral over several spans is allowed in claims only");
            self.report(error.help("write the number that it is"));
            return None;
        };
        if self.integrals >= MAX_DEPTH {
            let error = self.error(span, "integrals over several spans stand too deep in one another");
            self.report(error.help(format!("at most {MAX_DEPTH}; claim what the inner one is by itself")));
            return None;
        }
        let mut scopes = Vec::new();
        for (k, piece) in pieces.iter().enumerate() {
            self.fits(self.budget.step(1 + piece.functions.len() as u64), span)?;
            let mut scope = Scope::of_family(self.library, self.unit, piece);
            scope.span = Some((k, pieces.len()));
            scope.siblings = Some((pieces.clone(), written));
            scope.integrals = self.integrals + 1;
            scope.order = self.order;
            names::plan(&mut scope, written);
            for def in names::names(written) {
                names::declare(&mut scope, &def.name);
                names::force(&mut scope, &def.name.text);
            }
            scopes.push(scope);
        }
        let sum = self.sum_of_spans(f, bounds, &pieces, &mut scopes, span);
        let mut fine = true;
        for (mut scope, piece) in scopes.into_iter().zip(&pieces) {
            fine &= scope.settle(&|shapes_only| piece.parts(shapes_only), piece.budget);
            self.inherit(&scope.obligations);
            for error in scope.diagnostics.into_inner().into_list() {
                self.report(error);
            }
        }
        sum.filter(|_| fine)
    }

    /// The sum over the spans, in a scope for each.
    fn sum_of_spans(
        &self,
        f: &Expr,
        bounds: Option<&[Fraction; 2]>,
        pieces: &[Rc<Family>],
        scopes: &mut [Self],
        span: Span,
    ) -> Option<Value> {
        let places = match bounds {
            Some([low, high]) => {
                let low = self.place_of(low, pieces, scopes, span)?;
                Some([low, self.place_of(high, pieces, scopes, span)?])
            }
            None => None,
        };
        // From the upper bound to the lower one the sign changes.
        let turned = places.as_ref().is_some_and(|[low, high]| low.piece > high.piece);
        let mut sum: Option<Value> = None;
        for (k, (piece, scope)) in pieces.iter().zip(scopes).enumerate() {
            let (mut low, mut high) = ends(piece)?;
            let mut is_whole = true;
            if let (Some([first, last]), Some([a, b])) = (&places, bounds) {
                let (first, last, a, b) = if turned { (last, first, b, a) } else { (first, last, a, b) };
                if k < first.piece || k > last.piece {
                    continue;
                }
                let (start, end) = (low.clone(), high.clone());
                if k == first.piece && first.end != Some(false) {
                    low = if first.end.is_some() { end.clone() } else { a.clone() };
                    is_whole = false;
                }
                if k == last.piece && last.end != Some(true) {
                    high = if last.end.is_some() { start } else { b.clone() };
                    is_whole = false;
                }
            }
            scope.take_arguments(&self.call_sites)?;
            scope.constants.clone_from(&self.constants);
            let var = piece.domain.first()?.var;
            let part = Some((var, low, high)).filter(|_| !is_whole);
            let mut value = scope.over_one(f, part, span)?;
            if turned {
                let minus = Fraction::constant(Rational::from(-1));
                let negative = |f: &Fraction| scope.fits(scope.budget.mul(f, &minus), span);
                value = match &value {
                    Value::Scalar(f) => Value::Scalar(negative(f)?),
                    Value::List(list) => Value::List(
                        list.iter().map(|(i, f)| Some((i.clone(), negative(f)?))).collect::<Option<_>>()?,
                    ),
                };
            }
            sum = Some(match (sum, value) {
                (None, value) => value,
                (Some(Value::Scalar(a)), Value::Scalar(b)) => {
                    Value::Scalar(self.fits(self.budget.add(&a, &b), span)?)
                }
                (Some(Value::List(a)), Value::List(b)) => {
                    let mut list = Vec::new();
                    for ((index, x), (_, y)) in a.into_iter().zip(b) {
                        list.push((index, self.fits(self.budget.add(&x, &y), span)?));
                    }
                    Value::List(list)
                }
                _ => return None,
            });
        }
        sum
    }

    /// The span in which a bound lies; where it depends on shape parameters it has to stay there for all of their values.
    fn place_of(
        &self,
        bound: &Fraction,
        pieces: &[Rc<Family>],
        scopes: &mut [Self],
        span: Span,
    ) -> Option<Located> {
        for (k, piece) in pieces.iter().enumerate() {
            let (low, high) = ends(piece)?;
            let end = if *bound == low { Some(false) } else { Some(true).filter(|_| *bound == high) };
            if end.is_some() {
                return Some(Located { piece: k, end });
            }
        }
        for (k, (piece, scope)) in pieces.iter().zip(scopes).enumerate() {
            let parameter = piece.domain.first()?;
            let y = match scope.analytic.angle(parameter.var).cloned() {
                // A value that is beyond the angles of this span lies in another one.
                Some(angle) => match scope.angle_at(&angle, bound, span) {
                    Ok(y) => y?,
                    Err(_) => continue,
                },
                None => bound.clone(),
            };
            if scope.lies_elsewhere(&y, &parameter.range, piece) {
                continue;
            }
            if scope.analytic.number(&y).is_none() {
                let name = piece.name_of(parameter);
                let written = format!("{name} = {}", bound.display(&self.names));
                let inside = Inside {
                    value: y,
                    name: parameter.name.clone(),
                    range: parameter.range.clone(),
                    family: None,
                    assumable: false,
                    written: Some((written, piece.declared(parameter))),
                };
                let place = scope.place(span);
                scope.must_stay_inside(inside, place);
            }
            return Some(Located { piece: k, end: None });
        }
        let name = pieces.first().and_then(|piece| Some(piece.name_of(piece.domain.first()?)))?;
        let shown = bound.display(&self.names);
        let error = self.error(span, format!("the bound {name} = {shown} lies outside of the domain"));
        self.report(
            error.help("there is no formula; choose bounds between the ends of the first and the last span"),
        );
        None
    }

    /// Evaluates the arguments of the names that are being evaluated, as they were written, with the formulas of this span.
    fn take_arguments(&mut self, sites: &[CallSite]) -> Option<()> {
        self.arguments = Vec::new();
        for site in sites {
            self.constants.clone_from(&site.constants);
            let values: Option<Vec<Value>> = site.arguments.iter().map(|e| self.value(e)).collect();
            let names = site.parameters.mapped(String::clone);
            self.arguments = names.into_iter().zip(values?).listed();
        }
        Some(())
    }
}

//! A theorem while it is read: its names, its curves and surfaces, and what is said about them so far.

use proc_macro2::Span;

use super::form::Form;
use super::{ControlPoint, GivenPoint, Patch, TheoremKind};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::range::{DisplayRange as _, End, Range};
use crate::model::budget::TooLarge;
use crate::model::chart::Constraint;
use crate::model::scope::Scope;
use crate::model::{Parameter, label};
use crate::syntax::{self, Expr, ExprKind, Loops, PatchKind};

/// The first variables stand for the parameters of every patch, until arguments take their places.
pub(super) const OWN: usize = 3;

/// What an expression of a theorem is.
#[derive(Clone, Debug)]
pub(super) enum Value {
    Scalar(Fraction),
    Vector(Form),
    /// An outer product in a space of any dimension.
    Outer(Form),
    /// A patch, and the variables by which it is differentiated.
    Map(usize, Vec<Var>),
}

/// The names of a theorem while it is read.
pub(super) struct Elaboration<'a> {
    pub(super) scope: Scope<'a>,
    pub(super) kind: TheoremKind,
    pub(super) scalars: Vec<Parameter>,
    /// What is assumed of several of them, and where.
    pub(super) relations: Vec<(Constraint, Span)>,
    /// Parameters of patches that are scalars only if something mentions them.
    pub(super) implicit: Vec<Implicit>,
    /// Scalars that were introduced as shape values: their ranges are those of all shape parameters that they stand
    /// for.
    pub(super) shape_values: Vec<Var>,
    /// Vectors that `let` defined.
    pub(super) vectors: Vec<(String, Option<Value>)>,
    pub(super) patches: Vec<PatchDef>,
    /// Whether a curve or surface could not be read, so that the names of its shape values are not known.
    pub(super) incomplete: bool,
    pub(super) points: Vec<GivenPoint>,
    pub(super) dimension: Option<usize>,
    pub(super) products: Vec<(Var, (usize, usize))>,
}

/// The parameter of a patch.
pub(super) struct Implicit {
    pub(super) var: Var,
    pub(super) mentioned: bool,
}

/// A patch while the theorem is read.
pub(super) struct PatchDef {
    pub(super) name: String,
    pub(super) written: String,
    pub(super) kind: PatchKind,
    /// The names of the parameters; the variables `0..` stand for them.
    pub(super) parameters: Vec<String>,
    /// The last barycentric coordinate.
    pub(super) dependent: Option<String>,
    /// The basis functions in these variables, with the shape values put in.
    pub(super) functions: Vec<(Vec<i64>, Fraction)>,
    pub(super) points: Vec<ControlPoint>,
    /// Where a point was first used while it was still given; listed points are not determined any more.
    pub(super) used: Vec<Option<Span>>,
}

impl PatchDef {
    pub(super) fn finish(self) -> Patch {
        let Self { name, written, kind, parameters, points, .. } = self;
        Patch { name, written, kind, parameters, points }
    }
}

impl Elaboration<'_> {
    /// Runs over all values of index variables.
    pub(super) fn each(
        &mut self,
        loops: &Loops,
        body: &mut dyn FnMut(&mut Self) -> Option<()>,
    ) -> Option<()> {
        let depth = self.scope.constants.len();
        let mut all = Vec::new();
        let fine = self.scope.each(loops, &mut |scope| {
            all.push(scope.constants[depth..].to_vec());
            true
        });
        if !fine {
            return None;
        }
        if let (true, Some(condition)) = (all.is_empty(), &loops.condition) {
            let error = self.scope.error(condition.first().span, "this is never true: nothing is said here");
            self.scope.report(
                error.help(
                    "conditions choose among the values of index variables, `for i in 0..=3 if i != 1`",
                ),
            );
            return None;
        }
        if let (true, Some(first)) = (all.is_empty(), loops.generators.first()) {
            let name = match first {
                syntax::Generator::Range(range) => Some(&range.name),
                syntax::Generator::Simplex(names, _) => names.first(),
            };
            let span = name.map_or_else(Span::call_site, |n| n.span);
            let error = self.scope.error(span, "the loop is empty");
            self.scope.report(error.help("write the smaller bound first, `0..=n` includes n"));
            return None;
        }
        for values in all {
            self.scope.constants.extend(values);
            let done = body(self);
            self.scope.constants.truncate(depth);
            done?;
        }
        Some(())
    }

    /// The name that a name, or a name with an index, stands for, such as `γ[1]`.
    pub(super) fn target_name(&mut self, target: &Expr) -> Option<String> {
        match &target.kind {
            ExprKind::Name(name) => Some(name.clone()),
            ExprKind::Index(base, indices) => {
                let ExprKind::Name(name) = &base.kind else { return None };
                let index = self.indices(indices)?;
                Some(label(name, &index))
            }
            _ => None,
        }
    }

    pub(super) fn indices(&mut self, indices: &[Expr]) -> Option<Vec<i64>> {
        indices.iter().map(|i| self.scope.whole(i, "an index")).collect()
    }

    /// What already has this name.
    pub(super) fn taken(&self, name: &str) -> Option<&'static str> {
        if ["cross", "dot"].contains(&name) {
            Some("a function of the language")
        } else if self.patches.iter().any(|p| p.name == name) {
            Some("a curve or surface")
        } else if self.vectors.iter().any(|(n, _)| n == name) {
            Some("a name given by `let`")
        } else {
            self.scope.taken(name)
        }
    }

    pub(super) fn check_free(&self, name: &str, span: Span) -> Option<()> {
        let Some(what) = self.taken(name) else { return Some(()) };
        let error = self.scope.error(span, format!("`{name}` is already {what}"));
        let help = if what == "a scalar" {
            format!("`assume` narrows the range of a scalar: `assume {name} > 0;`")
        } else {
            String::from("choose another name")
        };
        self.scope.report(error.label("declared again here").help(help));
        None
    }

    /// A new variable that is a scalar.
    pub(super) fn new_scalar(&mut self, name: &str, range: Range, doc: &[String], span: Span) -> Var {
        let var = self.new_variable(name.to_string());
        let place = self.scope.place(span);
        self.scalars.push(Parameter { name: name.to_string(), doc: doc.to_vec(), place, var, range });
        var
    }

    pub(super) fn new_variable(&mut self, name: String) -> Var {
        self.scope.names.push(name);
        Var(self.scope.names.len() - 1)
    }

    /// Keeps of the range of a scalar what lies in another range; reports when that is nothing.
    pub(super) fn narrow(&mut self, at: usize, range: &Range, span: Span) -> Option<()> {
        let old = &self.scalars[at];
        let both = intersection(&old.range, range);
        if both.is_empty() {
            let shown = old.range.display(&old.name).to_string();
            let error = self.scope.error(span, format!("nothing is left of the range `{shown}`"));
            self.scope.report(error.help("let the ranges have something in common"));
            return None;
        }
        self.scalars[at].range = both;
        Some(())
    }

    /// The control point with an index.
    pub(super) fn control_point(&mut self, patch: usize, index: &[i64], span: Span) -> Option<Form> {
        let def = &mut self.patches[patch];
        match def.points.iter().position(|p| p.index == index) {
            Some(at) => {
                def.used[at].get_or_insert(span);
                Some(def.points[at].value.clone())
            }
            None => {
                self.no_point(patch, index, span);
                None
            }
        }
    }

    pub(super) fn no_point(&self, patch: usize, index: &[i64], span: Span) {
        let def = &self.patches[patch];
        let wanted = label(&def.name, index);
        let error = self.scope.error(span, format!("there is no control point `{wanted}`"));
        self.scope.report(match def.points.last() {
            Some(last) if last.index.len() != index.len() => {
                let first =
                    def.points.first().map_or_else(String::new, |first| label(&def.name, &first.index));
                let has = crate::plural::indices(last.index.len());
                error.help(format!(
                    "its control points have {has}, from `{first}` to `{}`",
                    label(&def.name, &last.index)
                ))
            }
            Some(last) => error.help(format!("the last one is `{}`", label(&def.name, &last.index))),
            None => error,
        });
    }

    /// Notes that a point of a patch is used.
    pub(super) fn use_point(&mut self, patch: usize, at: usize, span: Span) {
        self.patches[patch].used[at].get_or_insert(span);
    }

    /// Passes on a result, or reports that a formula is too large.
    pub(super) fn fits<T>(&self, result: Result<T, TooLarge>, span: Span) -> Option<T> {
        self.scope.within(result, span, "lower the degree, or state the theorem in several steps")
    }
}

/// What a value is, with its article.
pub(super) const fn kind(value: &Value) -> &'static str {
    match value {
        Value::Scalar(_) => "a scalar",
        Value::Vector(_) => "a vector",
        Value::Outer(_) => "an outer product",
        Value::Map(..) => "a patch",
    }
}

/// The numbers that lie in both ranges.
fn intersection(a: &Range, b: &Range) -> Range {
    // The end that leaves less: the inner one, and of two equal ones that which is excluded.
    let pick = |a: &End, b: &End, high: bool| match (a.value(), b.value()) {
        (None, _) => b.clone(),
        (_, None) => a.clone(),
        (Some(x), Some(y)) if x == y => (if a.is_included() { b } else { a }).clone(),
        (Some(x), Some(y)) => (if (x > y) == high { b } else { a }).clone(),
    };
    Range { low: pick(&a.low, &b.low, false), high: pick(&a.high, &b.high, true) }
}

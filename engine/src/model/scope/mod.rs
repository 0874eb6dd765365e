//! What names mean while a family is being expanded, what is still to be decided about its formulas (`duty`), and the
//! errors found on the way. How an expression is evaluated is the business of `formula`.

use core::cell::RefCell;
use core::ops::Range;

use proc_macro2::Span;

use super::angle::{Analytic, Anew};
use super::budget::{Budget, SPLIT, TooLarge};
use super::family::label;
use super::formula::Value;
use super::obligation::Obligation;
use super::words::{BUILTINS, is_transcendental};
use super::{Barycentric, Family, Function, Library};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::ascii;
use crate::diagnostic::{Diagnostic, Diagnostics, Place, grouped};
use crate::model::words::PI;
use crate::source::SourceId;
use crate::syntax::{Expr, FunctionDef, Name};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::map::SortedMap;
use basis_prover::collections::sort::sort_by;

mod duty;
mod unknown;

pub(crate) use duty::{Condition, Duty, Inside, Pending};

/// The most names that `let` gives in a family, and curves, surfaces and `let` in a theorem.
const MAX_NAMES: usize = 5_000;

/// How far a family is.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stage {
    /// Its functions are being defined: the name alone has no meaning yet.
    Defining,
    /// All functions are defined, so that the name alone means all of them.
    Complete,
    /// It has errors, and its claims are only looked at for more mistakes.
    Broken,
}

/// What the names belong to.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Subject {
    /// Variables are shape parameters and domain variables.
    Family,
    /// Variables are scalars.
    Theorem,
}

/// An argument of sin, cos, exp or the like.
#[cfg(feature = "angles")]
pub(crate) struct Argument {
    /// The name of the function.
    pub(crate) name: String,
    pub(crate) value: Fraction,
    pub(crate) span: Span,
}

/// Variables and what takes their places.
pub(crate) type Fixed = Vec<(Var, Fraction)>;

/// What formulas contain.
#[cfg(feature = "angles")]
#[derive(Default)]
pub(crate) struct Recorded {
    pub(crate) arguments: Vec<Argument>,
    /// What takes the place of domain variables, as in `b[0](α/2)`.
    pub(crate) places: Vec<(Var, Fraction)>,
}

/// Where a function is defined.
pub(crate) struct Definition {
    /// Its place in the order of the definitions.
    pub(crate) place: usize,
    pub(crate) span: Span,
    /// Whether `permute` defines it, perhaps from another index.
    pub(crate) permuted: bool,
}

/// A name that `let` gives, as it is written.
#[derive(Clone, Copy)]
pub(crate) struct Planned<'a> {
    pub(crate) parameters: &'a [Name],
    pub(crate) value: &'a Expr,
    /// Whether its statement has been looked at, so that nothing else may take the name.
    pub(crate) is_declared: bool,
}

/// A name with arguments whose formula is evaluated, as it was written.
#[derive(Clone)]
pub(crate) struct CallSite {
    pub(crate) parameters: Vec<String>,
    pub(crate) arguments: Vec<Expr>,
    /// The index variables around it with their values.
    pub(crate) constants: Vec<(String, i64)>,
}

/// What has no value yet.
#[derive(Clone, PartialEq, Eq)]
pub(crate) enum Needed {
    /// A name that `let` gives.
    Name(String),
    /// A function of the family.
    Function(Vec<i64>),
}

/// A function that is to be evaluated.
pub(crate) struct PlannedFunction<'a> {
    pub(crate) def: &'a FunctionDef,
    /// The index in the definition; with `permute` another one may be meant.
    pub(crate) index: Vec<i64>,
    /// The index variables of its loops with their values.
    pub(crate) constants: Vec<(String, i64)>,
}

/// The names of one family while it is being expanded.
pub(crate) struct Scope<'a> {
    pub(crate) library: &'a Library<'a>,
    pub(crate) unit: usize,
    pub(crate) source: SourceId,
    pub(crate) subject: Subject,
    /// Index parameters and index variables of loops, the innermost last.
    pub(crate) constants: Vec<(String, i64)>,
    /// Shape parameters that an assumed equation determines, with their values.
    pub(crate) determined: Vec<(String, Fraction)>,
    /// With what the family is expanded anew for some of its claims.
    pub(crate) anew: Anew,
    /// The equations that are assumed and determine a parameter, as they are written.
    pub(crate) equations: Vec<String>,
    /// Where something is assumed that holds for no shape values, and what it is.
    pub(crate) impossible: Option<(Span, String)>,
    /// The number of those that are the index parameters of the family.
    pub(crate) order: usize,
    /// What `let` defined; `None` when that went wrong.
    pub(crate) lets: SortedMap<String, Option<Value>>,
    /// The names that `let` gives in a family, evaluated or not.
    pub(crate) planned: SortedMap<String, Planned<'a>>,
    /// The arguments of the name with arguments whose formula is evaluated.
    pub(crate) arguments: Vec<(String, Value)>,
    /// The functions that have no value yet.
    pub(crate) planned_functions: SortedMap<Vec<i64>, PlannedFunction<'a>>,
    /// The names with arguments whose formulas are being evaluated, the outermost first.
    pub(crate) calls: Vec<String>,
    /// What a formula needs that has no value yet, and where it says so.
    pub(crate) waits_for: Option<(Needed, Span)>,
    /// The names of the variables: shape parameters, then domain variables.
    pub(crate) names: Vec<String>,
    /// The independent domain variables.
    pub(crate) domain: Vec<Var>,
    /// The names of the domain variables, known before these are.
    pub(crate) coming: Vec<String>,
    /// The ends of their ranges, in the same order; of barycentric coordinates 0 and 1.
    pub(crate) ends: Vec<(Fraction, Fraction)>,
    /// The simplices among the factors of the domain.
    pub(crate) simplices: Vec<Barycentric>,
    /// What goes beyond quotients of polynomials: angles, π.
    pub(crate) analytic: Analytic,
    /// Which of several spans is expanded, and how many there are.
    pub(crate) span: Option<(usize, usize)>,
    /// The families on all spans, once they are expanded, with the text of the family.
    pub(crate) siblings: Option<(Vec<std::rc::Rc<Family>>, &'a crate::syntax::Family)>,
    /// Beside those, the calls of names with arguments around, the outermost first: on another span they have other
    /// values.
    pub(crate) call_sites: Vec<CallSite>,
    /// In how many integrals over several spans the formula stands.
    pub(crate) integrals: usize,
    /// The arguments of sin, cos, exp and the like, while only these are looked for.
    #[cfg(feature = "angles")]
    pub(crate) recorded: Option<Recorded>,
    pub(crate) function_name: String,
    /// The functions so far; `None` when the formula went wrong.
    pub(crate) functions: SortedMap<Vec<i64>, Option<Fraction>>,
    /// Where each of them is defined; the functions of the lowest order also after others are raised from them.
    pub(crate) defined: SortedMap<Vec<i64>, Definition>,
    /// The functions of the lowest order, once others are raised from them.
    pub(crate) base: Vec<Function>,
    /// While an order is raised: functions outside of the order before are 0.
    pub(crate) missing_is_zero: bool,
    /// The names in statements that could not be read, sorted.
    pub(crate) unread: Vec<String>,
    /// Names of shape parameters with an index of which there is none in this order.
    pub(crate) empty_lists: Vec<String>,
    /// The unknown names that are reported already.
    pub(crate) undeclared: RefCell<Vec<String>>,
    /// Whether an error has ended a loop over functions early.
    pub(crate) cut_short: bool,
    /// Whether what is evaluated has to be a number, such as the end of a loop.
    pub(crate) counts: bool,
    pub(crate) stage: Stage,
    pub(crate) budget: Budget,
    /// What is still to be proved for the formulas to mean something.
    pub(crate) pending: Vec<Pending>,
    /// What of that is proved.
    pub(crate) settled: Vec<Duty>,
    /// All that holds, and why.
    pub(crate) obligations: Vec<Obligation>,
    pub(crate) diagnostics: RefCell<Diagnostics>,
}

/// The indices in a name such as `λ[1,2]`, if it is of this list.
fn index_in(known: &str, list: &str) -> Option<Vec<i64>> {
    let inner = known.strip_prefix(list)?.strip_prefix('[')?.strip_suffix(']')?;
    inner.split(',').map(|i| i.parse().ok()).collect()
}

impl Scope<'_> {
    pub(crate) fn place(&self, span: Span) -> Place {
        self.library.place(self.source, span)
    }

    pub(crate) fn error(&self, span: Span, message: impl Into<String>) -> Diagnostic {
        Diagnostic::error(self.place(span), message)
    }

    /// Reports an error once.
    pub(crate) fn report(&self, diagnostic: Diagnostic) {
        self.diagnostics.borrow_mut().push(diagnostic);
    }

    /// Whether further errors are only counted, so that the words about them need not be found.
    pub(crate) fn is_full(&self) -> bool {
        self.library.is_full() || self.diagnostics.borrow().is_full()
    }

    /// Passes on a result, or reports that something is too large.
    pub(crate) fn within<T>(&self, result: Result<T, TooLarge>, span: Span, help: &str) -> Option<T> {
        match result {
            Ok(value) => return Some(value),
            Err(TooLarge::Formula(reason)) => {
                self.report(self.error(span, format!("the formula {reason}")).help(help));
            }
            Err(TooLarge::Run(message)) => self.report(self.error(span, message).help(SPLIT)),
            Err(TooLarge::Said) => {}
        }
        None
    }

    /// The variable with a name.
    pub(crate) fn variable(&self, name: &str) -> Option<Var> {
        self.names.iter().position(|n| n == name).map(Var)
    }

    /// Whether a name stands for shape parameters with an index, such as `λ` for `λ[1]`, `λ[2]`.
    pub(crate) fn is_list_of_shapes(&self, name: &str) -> bool {
        // Asked of every name with an index.
        let mut names = self.names.iter().chain(self.determined.iter().map(|(n, _)| n));
        let is_known = self.subject == Subject::Family && names.any(|known| index_in(known, name).is_some());
        is_known || self.empty_lists.iter().any(|n| n == name)
    }

    /// The shape parameters with an index that have a name, with their indices; also those that `assume` determines.
    pub(crate) fn shapes_of(&self, name: &str) -> Vec<(Vec<i64>, Fraction)> {
        let index = |n: &str| index_in(n, name);
        let variables = self.names.iter().enumerate().map(|(k, n)| (n, Fraction::var(Var(k))));
        let determined = self.determined.iter().map(|(n, value)| (n, value.clone()));
        let mut all: Vec<(Vec<i64>, Fraction)> =
            variables.chain(determined).filter_map(|(n, value)| Some((index(n)?, value))).listed();
        sort_by(&mut all, |a, b| a.0.cmp(&b.0));
        all
    }

    /// Whether a variable belongs to the domain.
    pub(crate) fn is_domain_variable(&self, var: Var) -> bool {
        let angle = self.analytic.angles.iter().find(|a| a.itself == var);
        let var = angle.map_or(var, |a| a.var);
        self.domain.contains(&var) || self.last_of(var).is_some()
    }

    /// Whether a function depends on the domain.
    pub(crate) fn is_over_domain(&self, f: &Fraction) -> bool {
        let angles = &self.analytic.angles;
        self.domain.iter().any(|v| f.depends_on(*v))
            || angles.iter().any(|a| f.depends_on(a.itself) && self.domain.contains(&a.var))
    }

    /// The variable itself where it is an angle.
    pub(crate) fn itself(&self, var: Var) -> Var {
        self.analytic.angle(var).map_or(var, |a| a.itself)
    }

    /// The value of an index parameter or index variable.
    pub(crate) fn constant(&self, name: &str) -> Option<i64> {
        self.constants.iter().rev().find(|(n, _)| n == name).map(|(_, v)| *v)
    }

    /// The simplex whose last barycentric coordinate a variable is.
    pub(crate) fn last_of(&self, var: Var) -> Option<&Barycentric> {
        self.simplices.iter().find(|s| s.last.var == var)
    }

    /// The simplex to which a variable belongs.
    pub(crate) fn simplex_of(&self, var: Var) -> Option<&Barycentric> {
        self.simplices.iter().find(|s| s.last.var == var || self.domain[s.places.clone()].contains(&var))
    }

    /// The last barycentric coordinate of a simplex: 1 minus the others.
    pub(crate) fn last_coordinate(&self, simplex: &Barycentric) -> Fraction {
        let one = Fraction::constant(Rational::ONE);
        let others = &self.domain[simplex.places.clone()];
        others.iter().fold(one, |rest, var: &Var| &rest - &Fraction::var(*var))
    }

    /// All domain variables in the order of the spec, of each simplex all barycentric coordinates: for each factor its
    /// variables.
    pub(crate) fn factors(&self) -> Vec<Vec<Var>> {
        let mut all = Vec::new();
        let mut k = 0;
        while let Some(var) = self.domain.get(k) {
            match self.simplices.iter().find(|s| s.places.start == k) {
                Some(simplex) => {
                    let mut own = self.domain[simplex.places.clone()].to_vec();
                    own.push(simplex.last.var);
                    all.push(own);
                    k = simplex.places.end;
                }
                None => {
                    all.push(vec![*var]);
                    k += 1;
                }
            }
        }
        all
    }

    /// For each factor of the domain the places of its coordinates in an index with one place for each coordinate; nothing
    /// where there is no simplex, or an index of this length numbers otherwise.
    pub(crate) fn index_places(&self, width: usize) -> Vec<Range<usize>> {
        if self.simplices.is_empty() || width != self.domain.len() + self.simplices.len() {
            return Vec::new();
        }
        let mut next = 0;
        self.factors()
            .into_iter()
            .map(|own| {
                next += own.len();
                next - own.len()..next
            })
            .listed()
    }

    /// What already has this name, for an error when it is declared again.
    pub(crate) fn taken(&self, name: &str) -> Option<&'static str> {
        if BUILTINS.contains(&name) || is_transcendental(name) {
            Some("a function of the language")
        } else if PI.contains(&name) {
            Some("a number of the language")
        } else if self.constant(name).is_some() {
            Some("an index")
        } else if self.arguments.iter().any(|(n, _)| n == name) {
            Some("an argument")
        } else if self.planned.named(name).is_some_and(|planned| planned.is_declared)
            || self.subject == Subject::Theorem && self.lets.named(name).is_some()
        {
            Some("a name given by `let`")
        } else if let Some(var) = self.variable(name) {
            Some(if self.subject == Subject::Theorem {
                "a scalar"
            } else if self.is_domain_variable(var) {
                "a domain variable"
            } else {
                "a shape parameter"
            })
        } else if self.determined.iter().any(|(n, _)| n == name) {
            Some("a shape parameter that `assume` determines")
        } else if self.is_list_of_shapes(name) {
            Some("a list of shape parameters")
        } else if self.function_name == name {
            Some("the name of the basis functions")
        } else {
            None
        }
    }

    /// Reports an index that no shape parameter of a list has.
    pub(crate) fn no_such_shape(&self, list: &str, written: &str, span: Span) {
        let all = self.shapes_of(list);
        let ends = all.first().zip(all.last());
        let error = self.error(span, format!("there is no shape parameter `{written}`"));
        self.report(match ends {
            Some(((first, _), (last, _))) => {
                error.help(format!("they run from `{}` to `{}`", label(list, first), label(list, last)))
            }
            None => error,
        });
    }

    /// Reports a name that is declared although it already means something; whether it is free.
    pub(crate) fn check_free(&self, name: &Name) -> bool {
        self.check_free_or(name, "choose another name")
    }

    /// As [`check_free`](Self::check_free), with what to write instead.
    pub(crate) fn check_free_or(&self, name: &Name, help: &str) -> bool {
        let Some(what) = self.taken(&name.text) else { return true };
        let error =
            self.error(name.span, format!("`{}` is already {what}", name.text)).label("declared again here");
        self.undeclared.borrow_mut().push(name.text.clone());
        self.report(error.help(help));
        false
    }

    /// Whether there is room for another name by `let`; reports the first one that is too many.
    pub(crate) fn has_room(&self, names: usize, span: Span) -> bool {
        if names == MAX_NAMES {
            let message = format!("more than {} names are given", grouped(MAX_NAMES));
            self.report(self.error(span, message).help(SPLIT));
        }
        names < MAX_NAMES
    }

    /// Whether an error is known that can be the reason why a name has no meaning: it stands where nothing could be
    /// read, a name is missing there, or it is reported already. Of `c[2]` the name is `c`.
    pub(crate) fn is_mistaken(&self, name: &str) -> bool {
        let base = |name: &str| name.split('[').next().unwrap_or_default().len();
        let name = &name[..base(name)];
        self.unread.first().is_some_and(String::is_empty)
            || self.unread.binary_search_by(|unread| unread.as_str().cmp(name)).is_ok()
            || self.library.is_unread(self.unit, name)
            || ascii::is_capitalised(name) && self.library.lacks_a_use(self.unit)
            || self.undeclared.borrow().iter().any(|known| known[..base(known)] == *name)
    }

    /// A new scope for a family, without any variables yet.
    pub(crate) fn new<'a>(library: &'a Library<'a>, unit: usize, source: SourceId) -> Scope<'a> {
        Scope {
            library,
            unit,
            source,
            subject: Subject::Family,
            constants: Vec::new(),
            determined: Vec::new(),
            anew: Anew::default(),
            equations: Vec::new(),
            impossible: None,
            order: 0,
            lets: SortedMap::new(),
            planned: SortedMap::new(),
            arguments: Vec::new(),
            planned_functions: SortedMap::new(),
            calls: Vec::new(),
            waits_for: None,
            names: Vec::new(),
            domain: Vec::new(),
            coming: Vec::new(),
            ends: Vec::new(),
            simplices: Vec::new(),
            analytic: Analytic::default(),
            span: None,
            siblings: None,
            call_sites: Vec::new(),
            integrals: 0,
            #[cfg(feature = "angles")]
            recorded: None,
            function_name: String::new(),
            functions: SortedMap::new(),
            defined: SortedMap::new(),
            base: Vec::new(),
            missing_is_zero: false,
            unread: Vec::new(),
            empty_lists: Vec::new(),
            undeclared: RefCell::default(),
            cut_short: false,
            counts: false,
            stage: Stage::Defining,
            budget: Budget::new(library.run()),
            pending: Vec::new(),
            obligations: Vec::new(),
            settled: Vec::new(),
            diagnostics: RefCell::default(),
        }
    }

    /// The scope of the claims of a family that is expanded.
    pub(crate) fn of_family<'a>(library: &'a Library<'a>, unit: usize, family: &Family) -> Scope<'a> {
        let mut scope = Self::new(library, unit, family.source);
        scope.constants.clone_from(&family.order);
        scope.order = scope.constants.len();
        scope.determined.clone_from(&family.determined);
        scope.names.clone_from(&family.names);
        scope.domain = family.domain.mapped(|p| p.var);
        scope.ends = family.ends();
        scope.simplices.clone_from(&family.simplices);
        scope.analytic.clone_from(&family.analytic);
        scope.budget.set_roots(&family.analytic.roots);
        scope.function_name.clone_from(&family.function_name);
        for f in &family.functions {
            scope.functions.insert(f.index.clone(), Some(f.value.clone()));
        }
        scope.stage = Stage::Complete;
        scope
    }
}

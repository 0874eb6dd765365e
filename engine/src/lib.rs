//! The symbolic half of the toolchain for polynomial basis families: reads specs, expands them exactly, proves
//! or refutes every claim, and generates evaluators.
//!
//! The whole pipeline, each stage a module that uses only the stages before it:
//!
//! ```text
//! text or tokens --source, syntax--> tree --model--> families and claims --prove--> verdicts --generate--> code
//! ```
//!
//! It is a pure function: one spec gives one set of verdicts, witnesses and tokens on every machine. All errors
//! of a spec are collected, and no input makes it panic or run without end.
//!
//! ```
//! use basis_engine::{Source, check};
//!
//! let spec = "family Linear { domain 0 <= t <= 1; b[0] = 1 - t; b[1] = t; prove partition_of_unity; }";
//! let report = check(Source::text("linear.basis", spec));
//! assert!(report.diagnostics.is_empty());
//! assert_eq!(report.items[0].claims.len(), 1);
//! ```

#![cfg_attr(docsrs, feature(doc_cfg))] // items say which feature they need

/// The Rust of the guide is tested with the engine.
#[cfg(all(doctest, feature = "tools"))]
#[doc = include_str!("../../guide/src/engine.md")]
mod guide {}

mod advice;
pub mod algebra;
pub mod ascii;
pub mod claim;
pub mod continuation;
mod decimals;
pub mod diagnostic;
#[cfg(any(test, feature = "tools"))]
pub mod emit;
#[cfg(any(test, feature = "tools"))]
pub mod explain;
#[cfg(any(test, feature = "tools"))]
pub mod formulas;
pub mod generate;
pub mod model;
pub mod plan;
pub mod plural;
#[cfg(any(test, feature = "tools"))]
pub mod published;
#[cfg(any(test, feature = "tools"))]
pub mod query;
#[cfg(any(test, feature = "rounding"))]
pub mod rounding;
pub mod source;
pub mod state;
#[cfg(any(test, feature = "rounding"))]
pub mod steps;
pub mod subject;
pub mod syntax;
pub mod theorem;
mod weights;

use basis_prover::collections::list::Listed;
use proc_macro2::{Ident, Span, TokenStream};

pub use advice::closest;
#[cfg(any(test, feature = "tools"))]
pub use basis_prover::Coordinate;
pub use claim::{Claim, ClaimKind};
pub use diagnostic::{Diagnostic, Diagnostics, Severity};
pub use model::{Family, Library, Selected};
pub use source::{Disk, Files, Source, Sources};
pub use state::{Evidence, Prover, Verdict, Witness};
pub use subject::{Item, Subject};
pub use theorem::{Theorem, TheoremKind};

/// A family, a theorem or a join with the verdicts of its claims.
#[derive(Clone, Debug)]
pub struct Checked {
    /// What the claims are about.
    pub subject: Subject,
    /// The claims, in the order in which they are written.
    pub claims: Vec<(Claim, Verdict)>,
}

/// Everything that checking a spec gives.
#[derive(Clone, Debug)]
pub struct Report {
    /// The families without errors in every order of their declared ranges, then the theorems and joins.
    pub items: Vec<Checked>,
    /// Errors and warnings, also for claims whose verdict is not the declared one; of very many errors the first.
    pub diagnostics: Vec<Diagnostic>,
    /// The specs that were read, for showing places.
    pub sources: Sources,
}

/// Checks a spec and everything that it uses from the disk.
pub fn check(source: Source) -> Report {
    let library = Library::from_source(&Disk, &Prover, source);
    let run = &mut state::Run::default();
    let (items, warnings) = expanded(&library, run);
    let items = decide_all(items, run);
    let mut diagnostics: Diagnostics = library.diagnostics().into_iter().collect();
    diagnostics.extend(warnings);
    diagnostics.extend(items.iter().flat_map(contradictions));
    Report { items, diagnostics: diagnostics.into_list(), sources: library.sources().clone() }
}

/// What a file states, its families in every order and then its theorems and joins, expanded with the work of a run; and
/// the warnings about numbers in the families that are no floats.
pub fn expanded(library: &Library<'_>, run: &mut state::Run) -> (Vec<Item>, Vec<Diagnostic>) {
    let mut items = run.expanding(&mut || library.items(Selected::EveryOrder));
    let warnings = generate::no_floats(&items);
    items.extend(run.expanding(&mut || theorem::theorems(library)));
    (items, warnings)
}

/// Decides all claims of an item.
pub fn decide(item: Item) -> Checked {
    decide_within(item, &mut state::Run::default())
}

/// Decides all claims of an item with the work that is left of a run.
pub fn decide_within(item: Item, run: &mut state::Run) -> Checked {
    let subject = item.subject.clone();
    decide_all(vec![item], run).pop().unwrap_or(Checked { subject, claims: Vec::new() })
}

/// Decides all claims of several items with the work that is left of a run.
pub fn decide_all(items: Vec<Item>, run: &mut state::Run) -> Vec<Checked> {
    let mut verdicts: Vec<Option<state::Verdict>> = Vec::new();
    {
        let claims = items.iter().flat_map(|item| item.claims.iter().map(|claim| (&item.subject, claim)));
        let claims = claims.listed();
        verdicts.resize_with(claims.len(), || None);
        run.decide_all(&claims, &mut |k, verdict| verdicts[k] = verdict);
    }
    let mut verdicts = verdicts.into_iter().flatten();
    let checked = |Item { subject, claims, .. }: Item| {
        let claims = claims.into_iter().zip(&mut verdicts).listed();
        Checked { subject, claims }
    };
    items.into_iter().map(checked).listed()
}

/// The errors for the claims whose verdict is not the declared one.
pub fn contradictions(checked: &Checked) -> Vec<Diagnostic> {
    let claims = checked.claims.iter();
    claims.filter_map(|(claim, verdict)| state::diagnose(&checked.subject, claim, verdict)).listed()
}

/// What is to be generated from a spec.
#[derive(Clone, Debug)]
pub struct Request {
    /// The families; when there are none, every family without index parameters.
    pub families: Vec<Requested>,
    /// The path of the runtime crate, such as `::basis_runtime`.
    pub runtime: TokenStream,
}

/// One family that is to be generated.
#[derive(Clone, Debug)]
pub struct Requested {
    /// Its name in the spec.
    pub name: String,
    /// Where it is asked for.
    pub span: Span,
    /// The values of its index parameters.
    pub order: Vec<i64>,
    /// The name of the generated type, if it is to be another one.
    pub rename: Option<Ident>,
}

/// The code for the requested families, and everything that is wrong with them.
pub fn expand(library: &Library<'_>, request: &Request) -> (TokenStream, Vec<Diagnostic>) {
    let mut code = TokenStream::new();
    let mut diagnostics = Vec::new();
    let mut items: Vec<(Item, Option<Ident>, Option<Span>)> = Vec::new();
    let mut wanted: Vec<(&Requested, &str)> = Vec::new();
    for requested in &request.families {
        if let Some(join) = library.join_name(&requested.name) {
            wanted.push((requested, join));
            continue;
        }
        match library.item(&requested.name, &requested.order) {
            Ok(item) => {
                items.push((item, requested.rename.clone(), Some(requested.span)));
            }
            Err(Some((message, help))) => {
                let place = diagnostic::Place::Token(requested.span, requested.span);
                diagnostics.push(Diagnostic::error(place, message).help(help));
            }
            Err(None) => {}
        }
    }
    if request.families.is_empty() {
        items.extend(library.items(Selected::WithoutOrder).into_iter().map(|item| (item, None, None)));
        let names = library.names();
        let alone = names.iter().all(|(_, indexed)| *indexed) && !library.has_theorems();
        if let (true, Some((name, _))) = (alone, names.first()) {
            let place = diagnostic::Place::Token(Span::call_site(), Span::call_site());
            let message = "every family of the spec has index parameters, and no order is chosen";
            let help = format!(
                "name the families with their orders: `basis!(\"…\", {name}(3))`; put a spec that stands in the call into a file"
            );
            diagnostics.push(Diagnostic::error(place, message).help(help));
        }
    }
    let run = &mut state::Run::default();
    // A list is about what it names; without one every theorem is decided.
    let all = request.families.is_empty();
    let theorems = if all || !wanted.is_empty() { theorem::theorems(library) } else { Vec::new() };
    #[cfg(feature = "joins")]
    let joins = joins(library, request, theorems, &wanted, run, &mut diagnostics);
    #[cfg(not(feature = "joins"))] // an error of the library, where there are any
    let (joins, _) = (TokenStream::new(), theorems);
    // The names of the types so far, each with what has it.
    let mut types: Vec<(String, String)> = Vec::new();
    if !joins.is_empty() {
        let module = generate::module_name(library.file());
        types.push((module, String::from("the module of the joins")));
    }
    for (item, rename, span) in items {
        let Subject::Family(family) = &item.subject else { continue };
        let name = match generate::type_name(family, rename.as_ref()) {
            Ok(mut name) => {
                if let Some(span) = span {
                    name.set_span(span);
                }
                name
            }
            Err(error) => {
                diagnostics.push(error);
                continue;
            }
        };
        let (place, shown) = (family.place.clone(), format!("the family `{}`", family.title()));
        let text = name.to_string();
        if let Some((_, other)) = types.iter().find(|(other, _)| *other == text) {
            let error =
                Diagnostic::error(place, format!("{other} and {shown} are both called `{text}` in Rust"));
            let help = "choose another name for one of them, or give one to the macro: `Family as OtherName`";
            diagnostics.push(error.help(help));
            continue;
        }
        types.push((text, shown));
        let name = Some(name);
        let checked = decide_within(item, run);
        diagnostics.extend(contradictions(&checked));
        let Subject::Family(family) = &checked.subject else { continue };
        let options = generate::Options::for_macro(request.runtime.clone(), name);
        match generate::family(family, &checked.claims, &options) {
            Ok(tokens) => code.extend(tokens),
            Err(errors) => diagnostics.extend(errors),
        }
    }
    code.extend(joins);
    let mut all: Diagnostics = library.diagnostics().into_iter().collect();
    all.extend(diagnostics);
    (code, all.into_list())
}

/// The functions of the joins: of all, or of those in the list.
#[cfg(feature = "joins")]
fn joins(
    library: &Library<'_>,
    request: &Request,
    theorems: Vec<Item>,
    wanted: &[(&Requested, &str)],
    run: &mut state::Run,
    diagnostics: &mut Vec<Diagnostic>,
) -> TokenStream {
    let mut functions = TokenStream::new();
    // The names of the functions so far, each with its join.
    let mut names: Vec<(String, String)> = Vec::new();
    for item in theorems {
        let requested = wanted.iter().find(|(_, name)| *name == item.subject.name()).map(|(r, _)| r);
        if requested.is_none() && !request.families.is_empty() {
            continue;
        }
        let checked = decide_within(item, run);
        diagnostics.extend(contradictions(&checked));
        let Subject::Theorem(theorem) = &checked.subject else { continue };
        if theorem.kind != TheoremKind::Join {
            continue;
        }
        let rename = requested.and_then(|r| r.rename.as_ref());
        let name = rename.map_or_else(|| generate::join::name(theorem), Ident::to_string);
        if let Some((_, other)) = names.iter().find(|(other, _)| *other == name && !name.is_empty()) {
            let message =
                format!("the joins `{other}` and `{}` are both called `{name}` in Rust", theorem.name);
            let error = Diagnostic::error(theorem.place.clone(), message);
            diagnostics.push(error.help("choose another name for one of them"));
            continue;
        }
        names.push((name, theorem.name.clone()));
        let options = generate::Options::for_macro(request.runtime.clone(), rename.cloned());
        match generate::join::join(theorem, &checked.claims, &options) {
            Ok(function) => functions.extend(function),
            Err(error) => diagnostics.push(error),
        }
    }
    if functions.is_empty() { functions } else { generate::joins(library.file(), &functions) }
}

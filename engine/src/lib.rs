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

mod advice;
pub mod algebra;
mod collections;
pub mod decide;
pub mod diagnostic;
#[cfg(any(test, feature = "tools"))]
pub mod explain;
pub mod generate;
pub mod model;
pub mod plural;
pub mod prove;
pub mod source;
pub mod syntax;

use std::rc::Rc;

use collections::list::Mapped;
use proc_macro2::{Ident, Span, TokenStream};

pub use advice::closest;
pub use collections::map::SortedMap;
pub use diagnostic::{Diagnostic, Diagnostics, Severity};
pub use model::theorem::{Theorem, TheoremClaim, TheoremKind};
pub use model::{Claim, Family, Item, Library, Selected};
pub use prove::{Verdict, Witness};
pub use source::{Disk, Files, Source, Sources};

/// A family with the verdicts of its claims.
#[derive(Clone, Debug)]
pub struct Checked {
    /// The family.
    pub family: Rc<Family>,
    /// Its claims, in the order in which they are written.
    pub claims: Vec<(Claim, Verdict)>,
}

/// A theorem or a join with the verdicts of its claims.
#[derive(Clone, Debug)]
pub struct CheckedTheorem {
    /// The theorem.
    pub theorem: Theorem,
    /// A verdict for each of its claims.
    pub verdicts: Vec<Verdict>,
}

/// Everything that checking a spec gives.
#[derive(Clone, Debug)]
pub struct Report {
    /// The families without errors, in every order of their declared ranges.
    pub items: Vec<Checked>,
    /// The theorems and joins without errors.
    pub theorems: Vec<CheckedTheorem>,
    /// Errors and warnings, also for claims whose verdict is not the declared one; of very many errors the first.
    pub diagnostics: Vec<Diagnostic>,
    /// The specs that were read, for showing places.
    pub sources: Sources,
}

/// Checks a spec and everything that it uses from the disk.
pub fn check(source: Source) -> Report {
    let library = Library::from_source(&Disk, source);
    let run = &mut prove::Run::default();
    let items = library.items(Selected::EveryOrder).into_iter();
    let items: Vec<Checked> = items.map(|item| decide_claims_within(item, run)).collect();
    let theorems = library.theorems().into_iter();
    let theorems: Vec<CheckedTheorem> = theorems.map(|theorem| decide_theorem_within(theorem, run)).collect();
    let mut diagnostics: Diagnostics = library.diagnostics().into_iter().collect();
    diagnostics.extend(generate::no_floats(items.iter().map(|item| &*item.family)));
    diagnostics.extend(items.iter().flat_map(contradictions));
    diagnostics.extend(theorems.iter().flat_map(theorem_contradictions));
    Report { items, theorems, diagnostics: diagnostics.into_list(), sources: library.sources().clone() }
}

/// Decides all claims of a theorem.
pub fn decide_theorem(theorem: Theorem) -> CheckedTheorem {
    decide_theorem_within(theorem, &mut prove::Run::default())
}

/// Decides all claims of a theorem with the work that is left of a run.
pub fn decide_theorem_within(theorem: Theorem, run: &mut prove::Run) -> CheckedTheorem {
    let verdicts = theorem.claims.mapped(|claim| run.theorem_claim(&theorem, claim));
    CheckedTheorem { theorem, verdicts }
}

/// The errors for the claims of a theorem whose verdict is not the declared one.
pub fn theorem_contradictions(checked: &CheckedTheorem) -> Vec<Diagnostic> {
    let CheckedTheorem { theorem, verdicts } = checked;
    let claims = theorem.claims.iter().zip(verdicts);
    claims.filter_map(|(claim, verdict)| prove::diagnose_theorem(theorem, claim, verdict)).collect()
}

/// Decides all claims of a family.
pub fn decide_claims(item: Item) -> Checked {
    decide_claims_within(item, &mut prove::Run::default())
}

/// Decides all claims of a family with the work that is left of a run.
pub fn decide_claims_within(item: Item, run: &mut prove::Run) -> Checked {
    let Item { family, claims } = item;
    let claims = claims
        .into_iter()
        .map(|claim| {
            let verdict = run.claim(&family, &claim);
            (claim, verdict)
        })
        .collect();
    Checked { family, claims }
}

/// The errors for the claims whose verdict is not the declared one.
pub fn contradictions(checked: &Checked) -> Vec<Diagnostic> {
    checked
        .claims
        .iter()
        .filter_map(|(claim, verdict)| prove::diagnose(&checked.family, claim, verdict))
        .collect()
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
                "name the families with their orders: `basis!(\"…\", {name}(3))`; a spec in place has no room for them, a file has"
            );
            diagnostics.push(Diagnostic::error(place, message).help(help));
        }
    }
    let run = &mut prove::Run::default();
    let joins = joins(library, request, &wanted, run, &mut diagnostics);
    // The names of the types so far, each with what has it.
    let mut types: Vec<(String, String)> = Vec::new();
    if !joins.is_empty() {
        let module = generate::module_name(library.file());
        types.push((module, String::from("the module of the joins")));
    }
    for (item, rename, span) in items {
        let name = match generate::type_name(&item.family, rename.as_ref()) {
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
        let (place, shown) = (item.family.place.clone(), format!("the family `{}`", item.family.title()));
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
        let checked = decide_claims_within(item, run);
        diagnostics.extend(contradictions(&checked));
        let options = generate::Options { runtime: request.runtime.clone(), name };
        match generate::family(&checked.family, &checked.claims, &options) {
            Ok(tokens) => code.extend(tokens),
            Err(errors) => diagnostics.extend(errors),
        }
    }
    code.extend(joins);
    let mut all: Diagnostics = library.diagnostics().into_iter().collect();
    all.extend(diagnostics);
    (code, all.into_list())
}

/// The functions of the joins: of all, or of those in the list. A list is about what it names only; without one every
/// theorem is decided.
fn joins(
    library: &Library<'_>,
    request: &Request,
    wanted: &[(&Requested, &str)],
    run: &mut prove::Run,
    diagnostics: &mut Vec<Diagnostic>,
) -> TokenStream {
    let mut functions = TokenStream::new();
    // The names of the functions so far, each with its join.
    let mut names: Vec<(String, String)> = Vec::new();
    if !request.families.is_empty() && wanted.is_empty() {
        return functions;
    }
    for theorem in library.theorems() {
        let requested = wanted.iter().find(|(_, name)| *name == theorem.name).map(|(requested, _)| requested);
        if requested.is_none() && !request.families.is_empty() {
            continue;
        }
        let checked = decide_theorem_within(theorem, run);
        diagnostics.extend(theorem_contradictions(&checked));
        if checked.theorem.kind != TheoremKind::Join {
            continue;
        }
        let rename = requested.and_then(|r| r.rename.as_ref());
        let name = rename.map_or_else(|| generate::join::name(&checked.theorem), Ident::to_string);
        if let Some((_, other)) = names.iter().find(|(other, _)| *other == name && !name.is_empty()) {
            let this = &checked.theorem.name;
            let message = format!("the joins `{other}` and `{this}` are both called `{name}` in Rust");
            let error = Diagnostic::error(checked.theorem.place.clone(), message);
            diagnostics.push(error.help("choose another name for one of them"));
            continue;
        }
        names.push((name, checked.theorem.name.clone()));
        match generate::join::join(&checked.theorem, &checked.verdicts, &request.runtime, rename) {
            Ok(function) => functions.extend(function),
            Err(error) => diagnostics.push(error),
        }
    }
    if functions.is_empty() { functions } else { generate::joins(library.file(), &functions) }
}

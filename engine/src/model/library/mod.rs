//! The specs of one run: the one asked for, those it uses, and the prelude; what can be found in them. `read` reads
//! them, `families` expands their families on demand and once.

mod families;
mod read;

use core::cell::{Cell, RefCell};
use std::rc::Rc;

use proc_macro2::Span;

use super::Family;
use super::budget::Run;
use super::obligation::Judge;
use crate::diagnostic::{Diagnostic, Diagnostics, Place};
use crate::source::{Files, SourceId, Sources};
use crate::syntax::{self, Spec};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::map::SortedMap;

pub use families::Selected;

/// One parsed spec.
struct Unit {
    source: SourceId,
    spec: Spec,
    /// The families by name, each with its place among the items: sorted, of one name the first.
    families: Vec<(String, usize)>,
    /// The units whose families it may name, apart from its own and the prelude's.
    uses: Vec<usize>,
    /// Whether one that it uses could not be read.
    lacks_a_use: bool,
}

impl Unit {
    /// The place of a family among the items.
    fn position(&self, name: &str) -> Option<usize> {
        let k = self.families.binary_search_by(|(known, _)| known.as_str().cmp(name)).ok()?;
        Some(self.families[k].1)
    }

    fn family(&self, position: usize) -> Option<&syntax::Family> {
        match self.spec.items.get(position)? {
            syntax::Item::Family(family) => Some(family),
            syntax::Item::Use(_) | syntax::Item::Theorem(_) => None,
        }
    }
}

/// Family by unit, item and order; `None` while it is being expanded and when it has errors.
type Expanded = SortedMap<(usize, usize, Vec<i64>), Option<Rc<Family>>>;

/// The specs of one run.
pub struct Library<'f> {
    files: &'f dyn Files,
    judge: &'f dyn Judge,
    sources: Sources,
    units: Vec<Unit>,
    expanded: RefCell<Expanded>,
    /// The families that are being expanded, the outermost first.
    active: RefCell<Vec<(usize, usize, Vec<i64>)>>,
    diagnostics: RefCell<Diagnostics>,
    run: Rc<Run>,
    /// The number of names with arguments that are being evaluated, one inside of the other.
    calls: Cell<usize>,
    /// Whether a spec was left out because all together are too long.
    is_too_long: bool,
}

/// The unit that was asked for.
const MAIN: usize = 0;

/// Names with arguments that use one another through more levels than this are refused.
const MAX_CALLS: usize = 16;

impl<'f> Library<'f> {
    /// Counts a name with arguments whose formula is being evaluated; `false` when there are too many.
    pub(crate) fn enter(&self) -> bool {
        let fine = self.calls.get() < MAX_CALLS;
        self.calls.set(self.calls.get() + usize::from(fine));
        fine
    }

    /// The formula of a name with arguments is evaluated.
    pub(crate) fn leave(&self) {
        self.calls.set(self.calls.get().saturating_sub(1));
    }

    fn families_of(&self, unit: usize) -> impl Iterator<Item = &syntax::Family> {
        self.units[unit].spec.items.iter().filter_map(|item| match item {
            syntax::Item::Family(family) => Some(family),
            syntax::Item::Use(_) | syntax::Item::Theorem(_) => None,
        })
    }

    fn theorems_of(&self, unit: usize) -> impl Iterator<Item = &syntax::Theorem> {
        self.units[unit].spec.items.iter().filter_map(|item| match item {
            syntax::Item::Theorem(theorem) => Some(theorem),
            syntax::Item::Use(_) | syntax::Item::Family(_) => None,
        })
    }

    /// What `let` names in a family or theorem: the names without arguments, and the statements without the word.
    #[cfg(any(test, feature = "tools"))]
    pub(crate) fn definitions(&self, name: &str) -> Vec<(String, String)> {
        let statement = |unit: usize, name: &str, span: Span, last: Span| {
            let written = self.text_at(&self.place_to(self.units[unit].source, span, last))?;
            let written = written.trim_start().strip_prefix("let")?.trim_end_matches(';').trim();
            Some((name.to_owned(), written.to_owned()))
        };
        if let Some((unit, position)) = self.find(MAIN, name) {
            let family = self.units[unit].family(position);
            let statements = family.map_or(&[][..], |family| &family.statements);
            let definition = |s: &syntax::Statement| match &s.kind {
                syntax::StatementKind::Let(def) => statement(unit, &def.name.text, s.span, s.last),
                _ => None,
            };
            return statements.iter().filter_map(definition).listed();
        }
        let theorem = self.theorems_of(MAIN).find(|theorem| theorem.name.text == name);
        let definition = |s: &syntax::TheoremStatement| match &s.kind {
            syntax::TheoremStatementKind::Let(target, ..) => statement(MAIN, target.named()?, s.span, s.last),
            _ => None,
        };
        theorem.map_or(&[][..], |theorem| &theorem.statements).iter().filter_map(definition).listed()
    }

    /// Decides what has to hold while formulas are read.
    pub(crate) const fn judge(&self) -> &'f dyn Judge {
        self.judge
    }

    /// The units in which a spec looks for a family: itself, what it uses, the prelude.
    fn search(&self, unit: usize) -> Vec<usize> {
        let mut units = vec![unit];
        units.extend(&self.units[unit].uses);
        units.push(self.units.len() - 1);
        units.dedup();
        units
    }

    /// The two specs that both define a family, where a third one uses both and defines it not itself.
    fn ambiguous(&self, unit: usize, name: &str) -> Option<[&str; 2]> {
        let defines = |u: usize| self.units[u].position(name).is_some();
        if defines(unit) {
            return None;
        }
        let mut homes: Vec<usize> = Vec::new();
        for u in self.units[unit].uses.iter().filter(|u| defines(**u)) {
            if !homes.contains(u) {
                homes.push(*u);
            }
        }
        let [first, second, ..] = homes[..] else { return None };
        Some([first, second].map(|u| self.sources.get(self.units[u].source).name.as_str()))
    }

    fn find(&self, unit: usize, name: &str) -> Option<(usize, usize)> {
        self.search(unit).into_iter().find_map(|u| Some((u, self.units[u].position(name)?)))
    }

    /// The names of all families that a spec can name.
    pub(crate) fn visible(&self, unit: usize) -> Vec<String> {
        let mut names: Vec<String> = Vec::new();
        for unit in self.search(unit) {
            for family in self.families_of(unit) {
                if !names.contains(&family.name.text) {
                    names.push(family.name.text.clone());
                }
            }
        }
        names
    }

    /// Whether a name may be that of an item that could not be read: it stands there, or the name is missing.
    pub(crate) fn is_unread(&self, unit: usize, name: &str) -> bool {
        self.search(unit).into_iter().any(|u| {
            let unread = &self.units[u].spec.unread;
            unread.first().is_some_and(String::is_empty)
                || unread.binary_search_by(|other| other.as_str().cmp(name)).is_ok()
        })
    }

    /// Whether a family of any name may be in a spec that is used and could not be read.
    pub(crate) fn lacks_a_use(&self, unit: usize) -> bool {
        self.units[unit].lacks_a_use
    }

    /// Whether a spec can name this family.
    pub(crate) fn knows(&self, unit: usize, name: &str) -> bool {
        self.find(unit, name).is_some()
    }

    /// The number of index parameters of a family; 0 for an unknown name.
    pub(crate) fn order_count(&self, unit: usize, name: &str) -> usize {
        self.find(unit, name)
            .and_then(|(u, k)| self.units[u].family(k))
            .map_or(0, |family| family.orders.len())
    }

    /// The name of a join of the spec that was asked for, if there is one of this name.
    pub fn join_name(&self, name: &str) -> Option<&str> {
        let mut joins = self.theorems_of(MAIN).filter(|t| t.kind == syntax::TheoremKind::Join);
        joins.find(|t| t.name.text == name).map(|t| t.name.text.as_str())
    }

    /// Whether the spec that was asked for states theorems or joins.
    pub fn has_theorems(&self) -> bool {
        self.theorems_of(MAIN).next().is_some()
    }

    /// The name of the file that was asked for, or of the spec of the library; empty for the tokens of a macro call.
    pub fn file(&self) -> &str {
        let source = self.sources.get(self.units[MAIN].source);
        match (&source.library, &source.text) {
            (Some(name), _) => name,
            (None, Some(_)) => &source.name,
            (None, None) => "",
        }
    }

    /// The doc comment of the spec that was asked for, one string a line.
    pub fn doc(&self) -> &[String] {
        &self.units[MAIN].spec.doc
    }

    /// The names of the families of the spec that was asked for, and whether they have index parameters.
    pub fn names(&self) -> Vec<(String, bool)> {
        self.families_of(MAIN).map(|f| (f.name.text.clone(), !f.orders.is_empty())).listed()
    }

    /// The names of the index parameters of a family that the spec can name; `None` for an unknown family.
    pub fn index_names(&self, family: &str) -> Option<Vec<String>> {
        let (home, position) = self.find(MAIN, family)?;
        let family = self.units[home].family(position)?;
        Some(family.orders.mapped(|order| order.name.text.clone()))
    }

    /// The place of a span in a source.
    pub(crate) fn place(&self, source: SourceId, span: Span) -> Place {
        if let Some(text) = &self.sources.get(source).text {
            let mut range = span.byte_range();
            // Of a token that stands for a longer character the whole of that.
            while range.end < text.len() && !text.is_char_boundary(range.end) {
                range.end += 1;
            }
            Place::Text(source, range)
        } else {
            Place::Token(span, span)
        }
    }

    /// The text at a place.
    pub(crate) fn text_at(&self, place: &Place) -> Option<&str> {
        match place {
            Place::Text(source, range) => self.sources.get(*source).text.as_deref()?.get(range.clone()),
            Place::Token(..) => None,
        }
    }

    /// The place of everything from the first token of a span to a last token.
    pub(crate) fn place_to(&self, source: SourceId, span: Span, last: Span) -> Place {
        match self.place(source, span) {
            Place::Token(first, _) => Place::Token(first, last),
            text @ Place::Text(..) => text,
        }
    }

    /// Keeps a message, unless the same one is kept for the same place; errors of one formula repeat for
    /// every index and order.
    fn report(&self, new: Diagnostic) {
        let same_place = |a: &Diagnostic, b: &Diagnostic| match (a.labels.first(), b.labels.first()) {
            (Some((Place::Text(s, r), _)), Some((Place::Text(t, q), _))) => s == t && r == q,
            (Some((Place::Token(a, _), _)), Some((Place::Token(b, _), _))) => {
                format!("{a:?}") == format!("{b:?}")
            }
            (None, None) => true,
            _ => false,
        };
        let mut all = self.diagnostics.borrow_mut();
        if !all.shown().iter().any(|d| {
            same_place(d, &new)
                && (d.message == new.message
                    || d.severity == new.severity && repeated(&d.message, &new.message))
        }) {
            all.push(new);
        }
    }

    /// Whether further errors are only counted.
    pub(crate) fn is_full(&self) -> bool {
        self.diagnostics.borrow().is_full()
    }

    /// What the run may still take.
    pub(crate) const fn run(&self) -> &Rc<Run> {
        &self.run
    }

    fn report_all(&self, diagnostics: Diagnostics) {
        for diagnostic in diagnostics.into_list() {
            self.report(diagnostic);
        }
    }

    /// All messages so far.
    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        self.diagnostics.borrow().clone().into_list()
    }

    /// The specs that were read.
    pub const fn sources(&self) -> &Sources {
        &self.sources
    }
}

/// Whether two messages differ in numbers only.
fn repeated(a: &str, b: &str) -> bool {
    let words = |text: &str| text.chars().filter(|c| !c.is_ascii_digit()).collect::<String>();
    words(a) == words(b)
}

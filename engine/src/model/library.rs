//! The specs of one run: the one asked for, those it uses, and the prelude; families are expanded on demand
//! and once.

use core::cell::RefCell;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use proc_macro2::{Span, TokenStream};

use super::theorem::{self, Theorem};
use super::{Claim, Family, build, claims};
use crate::SortedMap;
use crate::collections::list::Mapped;
use crate::diagnostic::{Diagnostic, Place};
use crate::source::{self, Files, ReadError, Source, SourceId, Sources};
use crate::syntax::{self, Home, Spec, SyntaxError};
use crate::words::did_you_mean;

/// Families that refer to one another through more levels than this are refused.
const MAX_DEPTH: usize = 48;

/// More orders of one family than this are refused.
const MAX_ORDERS: i64 = 1000;

/// A family of one order with its claims.
#[derive(Clone, Debug)]
pub struct Item {
    /// The family.
    pub family: Rc<Family>,
    /// Its claims, in the order in which they are written.
    pub claims: Vec<Claim>,
}

/// Which families of a spec are asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Selected {
    /// All, in every order of their declared ranges.
    EveryOrder,
    /// Those without index parameters.
    WithoutOrder,
}

/// One parsed spec.
struct Unit {
    source: SourceId,
    spec: Spec,
    /// The units whose families it may name, apart from its own and the prelude's.
    uses: Vec<usize>,
}

/// Family by unit, item and order; `None` while it is being expanded and when it has errors.
type Expanded = SortedMap<(usize, usize, Vec<i64>), Option<Rc<Family>>>;

/// The specs of one run.
pub struct Library<'f> {
    files: &'f dyn Files,
    sources: Sources,
    units: Vec<Unit>,
    expanded: RefCell<Expanded>,
    /// The families that are being expanded, the outermost first.
    active: RefCell<Vec<(usize, usize, Vec<i64>)>>,
    diagnostics: RefCell<Vec<Diagnostic>>,
}

/// The unit that was asked for.
const MAIN: usize = 0;

impl<'f> Library<'f> {
    /// Reads a spec from a text, with everything that it uses.
    pub fn from_source(files: &'f dyn Files, source: Source) -> Self {
        let mut library = Self::empty(files);
        library.add_text(source, &mut Vec::new());
        library.finish()
    }

    /// Reads a spec from the tokens of a macro call in the file `path`, with everything that it uses.
    pub fn from_tokens(files: &'f dyn Files, tokens: TokenStream, path: Option<PathBuf>) -> Self {
        let mut library = Self::empty(files);
        let id = library.sources.add(Source::tokens(path));
        let (spec, errors) = syntax::parse_tokens(tokens);
        library.add_unit(id, spec, errors, &mut Vec::new());
        library.finish()
    }

    fn empty(files: &'f dyn Files) -> Self {
        Self {
            files,
            sources: Sources::default(),
            units: Vec::new(),
            expanded: RefCell::default(),
            active: RefCell::default(),
            diagnostics: RefCell::default(),
        }
    }

    /// The prelude is the last unit.
    fn finish(mut self) -> Self {
        let prelude = Source::text("prelude.basis", include_str!("../prelude.basis"));
        self.add_text(prelude, &mut Vec::new());
        self
    }

    fn add_text(&mut self, source: Source, stack: &mut Vec<SourceId>) -> usize {
        let id = self.sources.add(source);
        let text = self.sources.get(id).text.clone().unwrap_or_default();
        let (spec, errors) = syntax::parse_text(&text);
        self.add_unit(id, spec, errors, stack)
    }

    fn add_unit(
        &mut self,
        source: SourceId,
        spec: Spec,
        errors: Vec<SyntaxError>,
        stack: &mut Vec<SourceId>,
    ) -> usize {
        for error in errors {
            let place = match error.place {
                syntax::SyntaxPlace::Bytes(range) => Place::Text(source, range),
                syntax::SyntaxPlace::Token(span) => self.place(source, span),
            };
            let mut diagnostic = Diagnostic::error(place, error.message);
            diagnostic.help = error.help;
            self.report(diagnostic);
        }
        let index = self.units.len();
        let requests: Vec<(Home, String, Span)> = spec
            .items
            .iter()
            .filter_map(|item| match item {
                syntax::Item::Use(u) => Some((u.home, u.path.clone(), u.span)),
                syntax::Item::Family(_) | syntax::Item::Theorem(_) => None,
            })
            .collect();
        self.units.push(Unit { source, spec, uses: Vec::new() });
        self.check_doubled(index);
        stack.push(source);
        for (home, path, span) in requests {
            if let Some(unit) = self.load(source, home, &path, span, stack) {
                self.units[index].uses.push(unit);
            }
        }
        stack.pop();
        index
    }

    /// Reads a spec that another one uses, unless it is read already.
    fn load(
        &mut self,
        from: SourceId,
        home: Home,
        path: &str,
        span: Span,
        stack: &mut Vec<SourceId>,
    ) -> Option<usize> {
        let mut source = match self.read(from, home, path) {
            Ok(source) => source,
            Err(e) => {
                let mut diagnostic = Diagnostic::error(self.place(from, span), e.message);
                diagnostic.notes = e.notes;
                diagnostic.help = e.help;
                self.report(diagnostic);
                return None;
            }
        };
        if let Some(id) = self.sources.find(&source) {
            if let Some(start) = stack.iter().position(|s| *s == id) {
                let mut names: Vec<&str> = stack[start..].mapped(|s| self.sources.get(*s).name.as_str());
                names.push(self.sources.get(id).name.as_str());
                let message = format!("cyclic `use`: {}", names.join(" uses "));
                let place = self.place(from, span);
                self.report(
                    Diagnostic::error(place, message)
                        .help("move the families that both need into a third file"),
                );
                return None;
            }
            return self.units.iter().position(|u| u.source == id);
        }
        // A file is shown relative to the file that uses it, as a reader would look for it.
        if source.library.is_none()
            && let Some(parent) =
                Path::new(&self.sources.get(from).name).parent().filter(|p| !p.as_os_str().is_empty())
        {
            source.name = parent.join(path).to_string_lossy().into_owned();
        }
        Some(self.add_text(source, stack))
    }

    /// A spec that another one uses; in a spec of the library a path stays in the library.
    fn read(&self, from: SourceId, home: Home, path: &str) -> Result<Source, ReadError> {
        let from = self.sources.get(from);
        match (home, &from.library) {
            (Home::Library, _) => source::library(self.files, path),
            (Home::Folder, Some(name)) => source::library(self.files, &source::beside(name, path)?),
            (Home::Folder, None) => {
                let folder = from.path.as_deref().and_then(Path::parent).map(Path::to_path_buf);
                let folders: Vec<PathBuf> = folder.into_iter().collect();
                source::read(self.files, path, &folders)
            }
        }
    }

    fn check_doubled(&self, unit: usize) {
        let mut seen: SortedMap<&str, Span> = SortedMap::new();
        let source = self.units[unit].source;
        for theorem in self.theorems_of(unit) {
            if let Some(first) = seen.insert(&theorem.name.text, theorem.name.span) {
                let place = self.place(source, theorem.name.span);
                let message = format!("`{}` is stated twice", theorem.name.text);
                self.report(
                    Diagnostic::error(place, message)
                        .label("stated again here")
                        .also(self.place(source, first), "first stated here"),
                );
            }
        }
        let mut seen: SortedMap<&str, Span> = SortedMap::new();
        for family in self.families_of(unit) {
            if super::scope::BUILTINS.contains(&family.name.text.as_str()) {
                let place = self.place(source, family.name.span);
                let message = format!("`{}` is a function of the language", family.name.text);
                self.report(Diagnostic::error(place, message).help("choose another name for the family"));
            }
            if let Some(first) = seen.insert(&family.name.text, family.name.span) {
                let place = self.place(source, family.name.span);
                self.report(
                    Diagnostic::error(place, format!("the family `{}` is defined twice", family.name.text))
                        .label("defined again here")
                        .also(self.place(source, first), "first defined here"),
                );
            }
        }
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

    /// The theorems and joins of the spec that was asked for; those with errors are left out.
    pub fn theorems(&self) -> Vec<Theorem> {
        let mut theorems = Vec::new();
        for written in self.theorems_of(MAIN) {
            let (theorem, diagnostics) = theorem::theorem(self, MAIN, self.units[MAIN].source, written);
            let clean = diagnostics.is_empty();
            self.report_all(diagnostics);
            theorems.extend(theorem.filter(|_| clean));
        }
        theorems
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
        let defines = |u: usize| self.families_of(u).any(|f| f.name.text == name);
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
        self.search(unit).into_iter().find_map(|u| {
            let position = self.families_of(u).position(|f| f.name.text == name)?;
            Some((u, position))
        })
    }

    /// The names of all families that a spec can name.
    pub(super) fn visible(&self, unit: usize) -> Vec<String> {
        self.search(unit).into_iter().flat_map(|u| self.families_of(u)).map(|f| f.name.text.clone()).collect()
    }

    /// Whether a spec can name this family.
    pub(super) fn knows(&self, unit: usize, name: &str) -> bool {
        self.find(unit, name).is_some()
    }

    /// How many index parameters a family has; 0 for an unknown name.
    pub(super) fn order_count(&self, unit: usize, name: &str) -> usize {
        self.find(unit, name)
            .and_then(|(u, k)| self.families_of(u).nth(k))
            .map_or(0, |family| family.orders.len())
    }

    /// The family of this name and order, expanded.
    ///
    /// # Errors
    /// What is wrong and what to write instead; `None` when its own errors are reported already.
    pub(super) fn family(
        &self,
        unit: usize,
        name: &str,
        order: &[i64],
    ) -> Result<Rc<Family>, Option<(String, String)>> {
        let Some((home, position)) = self.find(unit, name) else {
            let visible = self.visible(unit);
            let known: Vec<&str> = visible.mapped(String::as_str);
            let help =
                did_you_mean(name, &known, &|| format!("families here are {}", crate::words::list(&visible)));
            return Err(Some((format!("there is no family `{name}`"), help)));
        };
        if let Some([first, second]) = self.ambiguous(unit, name) {
            let message = format!("`{name}` is defined in `{first}` and in `{second}`");
            return Err(Some((
                message,
                String::from("use one of the two files, or rename one of the families"),
            )));
        }
        let family = self.families_of(home).nth(position).ok_or(None)?;
        if family.orders.len() != order.len() {
            let wanted: Vec<String> = family.orders.mapped(|g| g.name.text.clone());
            let help = if wanted.is_empty() {
                format!("write `{name}`")
            } else {
                format!("write `{name}({})` with numbers", wanted.join(", "))
            };
            let message = format!(
                "`{name}` has {}, {}",
                crate::words::count(wanted.len(), "index parameter"),
                crate::words::here(order.len())
            );
            return Err(Some((message, help)));
        }
        let key = (home, position, order.to_vec());
        if let Some(done) = self.expanded.borrow().get(&key) {
            return done.clone().ok_or(None);
        }
        if self.active.borrow().contains(&key) {
            return Err(Some((
                format!("`{name}` is defined by itself"),
                String::from("a formula may use only families that do not need this one"),
            )));
        }
        if self.active.borrow().len() >= MAX_DEPTH {
            return Err(Some((
                format!("`{name}` needs more than {MAX_DEPTH} other families, one inside the other"),
                String::from("give a closed formula"),
            )));
        }
        self.check_order(home, family, order)?;
        self.active.borrow_mut().push(key.clone());
        let (result, diagnostics) = build::family(self, home, self.units[home].source, family, order);
        self.active.borrow_mut().pop();
        let clean = diagnostics.is_empty();
        self.report_all(at_order(diagnostics, family, order));
        let result = result.filter(|_| clean).map(Rc::new);
        self.expanded.borrow_mut().insert(key, result.clone());
        result.ok_or(None)
    }

    fn check_order(
        &self,
        home: usize,
        family: &syntax::Family,
        order: &[i64],
    ) -> Result<(), Option<(String, String)>> {
        for (k, value) in order.iter().enumerate() {
            let (first, last) = self.order_range(home, family, &order[..k]).ok_or(None)?;
            if !(first..=last).contains(value) {
                let name = &family.orders[k].name.text;
                let message = format!(
                    "{name} = {value} is outside of the declared range {first}..={last} of `{}`",
                    family.name.text
                );
                return Err(Some((message, format!("widen the range `{name} in {first}..={last}`"))));
            }
        }
        Ok(())
    }

    /// The first and last value of the index parameter that follows those with values already; what is wrong with it is
    /// reported.
    fn order_range(&self, home: usize, family: &syntax::Family, before: &[i64]) -> Option<(i64, i64)> {
        let mut scope = super::scope::Scope::new(self, home, self.units[home].source);
        let generator = &family.orders[before.len()];
        let mut range = None;
        let known = family.orders.iter().zip(before).all(|(known, value)| {
            let free = scope.check_free(&known.name);
            scope.constants.push((known.name.text.clone(), *value));
            free
        });
        if known && scope.check_free(&generator.name) {
            range = scope.bounds(generator);
        }
        let name = &generator.name.text;
        if let Some((first, last)) = range {
            if first > last && before.is_empty() {
                let error = scope.error(generator.name.span, format!("the range of `{name}` is empty"));
                scope.report(error.help("write the smaller order first, such as `n in 1..=8`"));
                range = None;
            } else if last.saturating_sub(first) >= MAX_ORDERS {
                let message = format!("the range of `{name}` has more than {MAX_ORDERS} orders");
                scope.report(scope.error(generator.name.span, message));
                range = None;
            }
        }
        self.report_all(scope.diagnostics.into_inner());
        range
    }

    /// All orders of a family, in lexicographic order; the range of an index parameter may depend on those before it.
    fn orders(&self, home: usize, family: &syntax::Family) -> Option<Vec<Vec<i64>>> {
        let mut orders: Vec<Vec<i64>> = vec![Vec::new()];
        for _ in &family.orders {
            let mut longer = Vec::new();
            for order in &orders {
                let (first, last) = self.order_range(home, family, order)?;
                for value in first..=last {
                    longer.push(order.iter().copied().chain([value]).collect());
                }
                if longer.len() as i64 > MAX_ORDERS {
                    let place = self.place(self.units[home].source, family.name.span);
                    let message = format!(
                        "the index parameters of `{}` have more than {MAX_ORDERS} combinations",
                        family.name.text
                    );
                    self.report(Diagnostic::error(place, message).help("narrow their ranges"));
                    return None;
                }
            }
            orders = longer;
        }
        if orders.is_empty() {
            let place = self.place(self.units[home].source, family.name.span);
            let message = format!("the index parameters of `{}` have no values", family.name.text);
            self.report(Diagnostic::error(place, message).help("widen their ranges"));
        }
        Some(orders)
    }

    /// The families of the spec that was asked for, with their claims; families with errors are left out.
    pub fn items(&self, selected: Selected) -> Vec<Item> {
        let mut items = Vec::new();
        for family in self.families_of(MAIN) {
            if selected == Selected::WithoutOrder && !family.orders.is_empty() {
                continue;
            }
            let Some(orders) = self.orders(MAIN, family) else { continue };
            for order in &orders {
                if let Ok(item) = self.item(&family.name.text, order) {
                    items.push(item);
                }
            }
        }
        items
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
        self.families_of(MAIN).map(|f| (f.name.text.clone(), !f.orders.is_empty())).collect()
    }

    /// The names of the index parameters of a family that the spec can name; `None` for an unknown family.
    pub fn index_names(&self, family: &str) -> Option<Vec<String>> {
        let (home, position) = self.find(MAIN, family)?;
        let family = self.families_of(home).nth(position)?;
        Some(family.orders.mapped(|order| order.name.text.clone()))
    }

    /// One family of the spec that was asked for, with its claims.
    ///
    /// # Errors
    /// What is wrong and what to write instead; `None` when its own errors are reported already.
    pub fn item(&self, name: &str, order: &[i64]) -> Result<Item, Option<(String, String)>> {
        let family = self.family(MAIN, name, order)?;
        let (home, position) = self.find(MAIN, name).ok_or(None)?;
        let written = self.families_of(home).nth(position).ok_or(None)?;
        let (claims, diagnostics) = claims::claims(self, home, written, &family);
        self.report_all(at_order(diagnostics, written, order));
        Ok(Item { family, claims })
    }

    /// The place of a span in a source.
    pub(super) fn place(&self, source: SourceId, span: Span) -> Place {
        if self.sources.get(source).text.is_some() {
            Place::Text(source, span.byte_range())
        } else {
            Place::Token(span)
        }
    }

    /// Keeps a message, unless the same one is kept for the same place; errors of one formula repeat for
    /// every index and order.
    fn report(&self, new: Diagnostic) {
        let same_place = |a: &Diagnostic, b: &Diagnostic| match (a.labels.first(), b.labels.first()) {
            (Some((Place::Text(s, r), _)), Some((Place::Text(t, q), _))) => s == t && r == q,
            (Some((Place::Token(a), _)), Some((Place::Token(b), _))) => format!("{a:?}") == format!("{b:?}"),
            (None, None) => true,
            _ => false,
        };
        let mut all = self.diagnostics.borrow_mut();
        if !all.iter().any(|d| {
            same_place(d, &new)
                && (d.message == new.message
                    || d.severity == new.severity && repeated(&d.message, &new.message))
        }) {
            all.push(new);
        }
    }

    fn report_all(&self, diagnostics: Vec<Diagnostic>) {
        for diagnostic in diagnostics {
            self.report(diagnostic);
        }
    }

    /// All messages so far.
    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        self.diagnostics.borrow().clone()
    }

    /// The specs that were read.
    pub const fn sources(&self) -> &Sources {
        &self.sources
    }
}

/// Errors in a family with index parameters say at which values they were met.
fn at_order(mut diagnostics: Vec<Diagnostic>, family: &syntax::Family, order: &[i64]) -> Vec<Diagnostic> {
    if !order.is_empty() {
        let values: Vec<String> =
            family.orders.iter().zip(order).map(|(g, v)| format!("{} = {v}", g.name.text)).collect();
        for diagnostic in &mut diagnostics {
            diagnostic.notes.push(format!("for {}", values.join(", ")));
        }
    }
    diagnostics
}

/// Whether two messages differ in numbers only.
fn repeated(a: &str, b: &str) -> bool {
    let words = |text: &str| text.chars().filter(|c| !c.is_ascii_digit()).collect::<String>();
    words(a) == words(b)
}

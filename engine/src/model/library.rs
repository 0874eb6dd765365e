//! The specs of one run: the one asked for, those it uses, and the prelude; families are expanded on demand
//! and once.

use core::cell::RefCell;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use proc_macro2::{Span, TokenStream};

use super::budget::{Run, TooLarge};
use super::obligation::Judge;
use super::{Family, build, claims};
use crate::advice::did_you_mean;
use crate::diagnostic::{Diagnostic, Diagnostics, Place};
use crate::source::{self, Files, ReadError, Source, SourceId, Sources};
use crate::subject::{Item, Subject};
use crate::syntax::{self, Home, Name, Spec, SyntaxErrors};
use basis_kernel::collections::list::Mapped;
use basis_kernel::collections::sort::sort_by;
use basis_prover::map::SortedMap;

/// Families that refer to one another through more levels than this are refused.
const MAX_DEPTH: usize = 48;

/// More orders of one family than this are refused.
const MAX_ORDERS: i64 = 1000;

/// Which families of a spec are asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Selected {
    /// All, in every order of their declared ranges.
    EveryOrder,
    /// Those without index parameters.
    WithoutOrder,
}

/// The most bytes of all specs of a run.
const MAX_TOTAL_BYTES: usize = 4 << 20;

/// One parsed spec.
struct Unit {
    source: SourceId,
    spec: Spec,
    /// The families by name, each with its place among the items: sorted, of one name the first.
    families: Vec<(String, usize)>,
    /// The units whose families it may name, apart from its own and the prelude's.
    uses: Vec<usize>,
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
    /// Whether a spec was left out because all together are too long.
    is_too_long: bool,
}

/// The unit that was asked for.
const MAIN: usize = 0;

impl<'f> Library<'f> {
    /// Reads a spec from a text, with everything that it uses.
    pub fn from_source(files: &'f dyn Files, judge: &'f dyn Judge, source: Source) -> Self {
        let mut library = Self::empty(files, judge);
        library.add_text(source, &mut Vec::new());
        library.finish()
    }

    /// Reads a spec from the tokens of a macro call in the file `path`, with everything that it uses.
    pub fn from_tokens(
        files: &'f dyn Files,
        judge: &'f dyn Judge,
        tokens: TokenStream,
        path: Option<PathBuf>,
    ) -> Self {
        let mut library = Self::empty(files, judge);
        let id = library.sources.add(Source::tokens(path));
        let (spec, errors) = syntax::parse_tokens(tokens);
        library.add_unit(id, spec, errors, &mut Vec::new());
        library.finish()
    }

    fn empty(files: &'f dyn Files, judge: &'f dyn Judge) -> Self {
        Self {
            files,
            judge,
            sources: Sources::default(),
            units: Vec::new(),
            expanded: RefCell::default(),
            active: RefCell::default(),
            diagnostics: RefCell::default(),
            run: Rc::new(Run::new()),
            is_too_long: false,
        }
    }

    /// The prelude is the last unit.
    fn finish(mut self) -> Self {
        let prelude = Source::text("prelude.basis", include_str!("../prelude.basis"));
        self.add_text(prelude, &mut Vec::new());
        #[cfg(not(feature = "joins"))]
        self.refuse_theorems();
        self
    }

    /// What is not read must not look as if it were checked: the first theorem or join of all specs is an error.
    #[cfg(not(feature = "joins"))]
    fn refuse_theorems(&self) {
        for unit in 0..self.units.len() {
            let Some(first) = self.theorems_of(unit).next() else { continue };
            let message = "theorems and joins need the feature `joins` of basis-runtime, which is off";
            let help = "switch it on in `Cargo.toml`: `basis-runtime = { …, features = [\"joins\"] }`";
            let place = self.place(self.units[unit].source, first.name.span);
            self.report(Diagnostic::error(place, message).help(help));
            return;
        }
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
        errors: SyntaxErrors,
        stack: &mut Vec<SourceId>,
    ) -> usize {
        self.diagnostics.borrow_mut().leave_out(errors.unread());
        for error in errors.into_list() {
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
        let mut families: Vec<(String, usize)> = Vec::new();
        for (position, item) in spec.items.iter().enumerate() {
            if let syntax::Item::Family(family) = item {
                families.push((family.name.text.clone(), position));
            }
        }
        // Stable: of families of one name, which is an error, the first one stays.
        sort_by(&mut families, |a, b| a.0.cmp(&b.0));
        families.dedup_by(|later, first| later.0 == first.0);
        self.units.push(Unit { source, spec, families, uses: Vec::new() });
        self.check_doubled(index);
        stack.push(source);
        for (home, path, span) in requests {
            if let Some(unit) = self.load(source, home, &path, span, stack)
                && !self.units[index].uses.contains(&unit)
            {
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
        let mut source = None;
        let mut known = self.known(from, home, path);
        if known.is_none() {
            match self.read(from, home, path) {
                Ok(read) => {
                    known = self.sources.find(&read);
                    source = Some(read);
                }
                Err(e) => {
                    let mut diagnostic = Diagnostic::error(self.place(from, span), e.message);
                    diagnostic.notes = e.notes;
                    diagnostic.help = e.help;
                    self.report(diagnostic);
                    return None;
                }
            }
        }
        if let Some(id) = known {
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
        let mut source = source?;
        let read: usize = self.sources.iter().map(|(_, s)| s.text.as_deref().map_or(0, str::len)).sum();
        if read + source.text.as_deref().map_or(0, str::len) > MAX_TOTAL_BYTES {
            // The same is true of all that follow.
            if !core::mem::replace(&mut self.is_too_long, true) {
                let limit = MAX_TOTAL_BYTES >> 20;
                let message = format!("the spec and those that it uses are longer than {limit} MiB");
                let error = Diagnostic::error(self.place(from, span), message);
                self.report(error.help("use fewer files"));
            }
            return None;
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

    /// The file that another one uses, if it is read already.
    fn known(&self, from: SourceId, home: Home, path: &str) -> Option<SourceId> {
        let from = self.sources.get(from);
        if home == Home::Library || from.library.is_some() {
            return None;
        }
        let folder = from.path.as_deref().and_then(Path::parent).map(Path::to_path_buf);
        let mut file = Source::default();
        file.path = Some(self.files.canonical(&folder.unwrap_or_default().join(path)));
        self.sources.find(&file)
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
        let source = self.units[unit].source;
        for (again, first) in repeated_names(self.theorems_of(unit).map(|t| &t.name)) {
            let message = format!("`{}` is stated twice", again.text);
            self.report(
                Diagnostic::error(self.place(source, again.span), message)
                    .label("stated again here")
                    .also(self.place(source, first.span), "first stated here"),
            );
        }
        for family in self.families_of(unit) {
            if super::scope::BUILTINS.contains(&family.name.text.as_str()) {
                let place = self.place(source, family.name.span);
                let message = format!("`{}` is a function of the language", family.name.text);
                self.report(Diagnostic::error(place, message).help("choose another name for the family"));
            }
        }
        for (again, first) in repeated_names(self.families_of(unit).map(|f| &f.name)) {
            let message = format!("the family `{}` is defined twice", again.text);
            self.report(
                Diagnostic::error(self.place(source, again.span), message)
                    .label("defined again here")
                    .also(self.place(source, first.span), "first defined here"),
            );
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

    /// Calls a function with the number of the spec that was asked for, its source and each of its theorems and joins, and keeps
    /// the errors that it returns.
    #[cfg(feature = "joins")]
    pub(crate) fn each_theorem(
        &self,
        read: &mut dyn FnMut(usize, SourceId, &syntax::Theorem) -> Diagnostics,
    ) {
        for written in self.theorems_of(MAIN) {
            if self.counts_as_family(MAIN, written.name.span).is_none() {
                break;
            }
            self.report_all(read(MAIN, self.units[MAIN].source, written));
        }
    }

    /// Who decides what has to hold while formulas are read.
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
        self.search(unit).into_iter().flat_map(|u| self.families_of(u)).map(|f| f.name.text.clone()).collect()
    }

    /// Whether a name may be that of an item that could not be read: it stands there, or the name is missing.
    pub(super) fn is_unread(&self, unit: usize, name: &str) -> bool {
        self.search(unit).into_iter().any(|u| {
            let unread = &self.units[u].spec.unread;
            unread.first().is_some_and(String::is_empty)
                || unread.binary_search_by(|other| other.as_str().cmp(name)).is_ok()
        })
    }

    /// Whether a spec can name this family.
    pub(crate) fn knows(&self, unit: usize, name: &str) -> bool {
        self.find(unit, name).is_some()
    }

    /// How many index parameters a family has; 0 for an unknown name.
    pub(crate) fn order_count(&self, unit: usize, name: &str) -> usize {
        self.find(unit, name)
            .and_then(|(u, k)| self.units[u].family(k))
            .map_or(0, |family| family.orders.len())
    }

    /// The family of this name and order, expanded.
    ///
    /// # Errors
    /// What is wrong and what to write instead; `None` when its own errors are reported already.
    pub(crate) fn family(
        &self,
        unit: usize,
        name: &str,
        order: &[i64],
    ) -> Result<Rc<Family>, Option<(String, String)>> {
        let Some((home, position)) = self.find(unit, name) else {
            if self.is_unread(unit, name) {
                return Err(None);
            }
            if self.is_full() {
                return Err(Some((String::new(), String::new()))); // only counted
            }
            let visible = self.visible(unit);
            let known: Vec<&str> = visible.mapped(String::as_str);
            let help = did_you_mean(name, &known, &|| {
                format!("families here are {}", crate::plural::list(&visible))
            });
            return Err(Some((format!("there is no family `{name}`"), help)));
        };
        if let Some([first, second]) = self.ambiguous(unit, name) {
            let message = format!("`{name}` is defined in `{first}` and in `{second}`");
            return Err(Some((
                message,
                String::from("use one of the two files, or rename one of the families"),
            )));
        }
        let family = self.units[home].family(position).ok_or(None)?;
        if family.orders.len() != order.len() {
            let wanted: Vec<String> = family.orders.mapped(|g| g.name.text.clone());
            let help = if wanted.is_empty() {
                format!("write `{name}`")
            } else {
                format!("write `{name}({})` with numbers", wanted.join(", "))
            };
            let message = format!(
                "`{name}` has {}, {}",
                crate::plural::count(wanted.len(), "index parameter"),
                crate::plural::here(order.len())
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
        self.counts_as_family(home, family.name.span).ok_or(None)?;
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
                if self.run.is_stopped() {
                    return items;
                }
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
        let family = self.units[home].family(position)?;
        Some(family.orders.mapped(|order| order.name.text.clone()))
    }

    /// One family of the spec that was asked for, with its claims.
    ///
    /// # Errors
    /// What is wrong and what to write instead; `None` when its own errors are reported already.
    pub fn item(&self, name: &str, order: &[i64]) -> Result<Item, Option<(String, String)>> {
        let family = self.family(MAIN, name, order)?;
        let (home, position) = self.find(MAIN, name).ok_or(None)?;
        let written = self.units[home].family(position).ok_or(None)?;
        let (claims, obligations, diagnostics) = claims::claims(self, home, written, &family);
        self.report_all(at_order(diagnostics, written, order));
        Ok(Item { subject: Subject::Family(family), obligations, claims })
    }

    /// The place of a span in a source.
    pub(crate) fn place(&self, source: SourceId, span: Span) -> Place {
        if self.sources.get(source).text.is_some() {
            Place::Text(source, span.byte_range())
        } else {
            Place::Token(span, span)
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

    /// Counts a family of one order, or a theorem; `None` when there are too many.
    fn counts_as_family(&self, unit: usize, span: Span) -> Option<()> {
        match self.run.family() {
            Ok(()) => return Some(()),
            Err(TooLarge::Run(message)) => {
                let error = Diagnostic::error(self.place(self.units[unit].source, span), message);
                self.report(error.help(super::budget::SPLIT));
            }
            Err(TooLarge::Formula(_) | TooLarge::Said) => {}
        }
        None
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

/// Errors in a family with index parameters say at which values they were met.
fn at_order(mut diagnostics: Diagnostics, family: &syntax::Family, order: &[i64]) -> Diagnostics {
    if !order.is_empty() && !diagnostics.is_empty() {
        let values: Vec<String> =
            family.orders.iter().zip(order).map(|(g, v)| format!("{} = {v}", g.name.text)).collect();
        for diagnostic in diagnostics.shown_mut() {
            diagnostic.notes.push(format!("for {}", values.join(", ")));
        }
    }
    diagnostics
}

/// The names that stand a second time in a list, each with the first one, in the order of the list.
fn repeated_names<'n>(names: impl Iterator<Item = &'n Name>) -> Vec<(&'n Name, &'n Name)> {
    let mut sorted: Vec<(usize, &Name)> = names.enumerate().collect();
    sort_by(&mut sorted, |a, b| a.1.text.cmp(&b.1.text));
    let mut repeated = Vec::new();
    let mut first = 0;
    for k in 0..sorted.len() {
        if sorted[k].1.text == sorted[first].1.text {
            if k > first {
                repeated.push((sorted[k].0, sorted[k].1, sorted[first].1));
            }
        } else {
            first = k;
        }
    }
    sort_by(&mut repeated, |a, b| a.0.cmp(&b.0));
    repeated.into_iter().map(|(_, again, first)| (again, first)).collect()
}

/// Whether two messages differ in numbers only.
fn repeated(a: &str, b: &str) -> bool {
    let words = |text: &str| text.chars().filter(|c| !c.is_ascii_digit()).collect::<String>();
    words(a) == words(b)
}

//! The families of the specs, expanded on demand and once, in the orders of their declared ranges; theorems as they are
//! written.

use std::rc::Rc;

use proc_macro2::Span;

use super::{Library, MAIN};
use crate::advice::did_you_mean;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::Family;
use crate::model::budget::{SPLIT, TooLarge};
use crate::model::expand::whole;
use crate::model::scope::Scope;
use crate::model::unused;
use crate::model::words::BUILTINS;
use crate::subject::{Item, Subject};
use crate::syntax;
use basis_prover::collections::list::{Listed, Mapped};

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

impl Library<'_> {
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
            if self.is_unread(unit, name) || self.lacks_a_use(unit) {
                return Err(None);
            }
            if self.is_full() {
                return Err(Some((String::new(), String::new()))); // only counted
            }
            let visible = self.visible(unit);
            let known: Vec<&str> = visible.mapped(String::as_str);
            let help = did_you_mean(name, &known, &|| {
                let families = format!("families here are {}", crate::plural::list(&visible));
                if BUILTINS.contains(&name) {
                    return format!(
                        "the sum over control points goes without saying: name the family, `curve P = Bernstein(3);`; {families}"
                    );
                }
                families
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
            // Small values that all of them can have; of order 0 there is seldom more than one function.
            let mut small = Vec::new();
            while small.len() < wanted.len()
                && let Some((first, last)) = self.order_range(home, family, &small)
            {
                small.push(first.max(1).min(last));
            }
            let help = if wanted.is_empty() {
                format!("write `{name}`")
            } else if order.is_empty() && small.len() == wanted.len() {
                let small = small.mapped(i64::to_string).join(", ");
                format!("write `{name}({})` with numbers, such as `{name}({small})`", wanted.join(", "))
            } else if let Some((own, index)) = order.split_at_checked(wanted.len()) {
                let [own, index] = [own, index].map(|part| part.mapped(i64::to_string).join(", "));
                format!("the index of a function follows in square brackets: `{name}({own})[{index}]`")
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
            let active = self.active.borrow();
            let circle = active.iter().skip_while(|known| **known != key).chain([&key]);
            let title = |(home, position, order): &(usize, usize, Vec<i64>)| {
                let name = self.units[*home].family(*position).map_or("", |family| &family.name.text);
                let order = order.mapped(i64::to_string).join(", ");
                if order.is_empty() { String::from(name) } else { format!("{name}({order})") }
            };
            let circle = circle.map(title).listed();
            let through = if circle.len() > 2 {
                format!("; the circle is {}", circle.join(" -> "))
            } else {
                String::new()
            };
            return Err(Some((
                format!("`{name}` is defined by itself"),
                format!("a formula may use only families that do not need this one{through}"),
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
        let (result, diagnostics) = whole::family(self, home, self.units[home].source, family, order);
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
                let help = if *value < first {
                    format!(
                        "leave such cases out, `… if {name} > {first}`, or widen the range `{name} in {first}..={last}`"
                    )
                } else {
                    format!("widen the range `{name} in {first}..={last}`")
                };
                return Err(Some((message, help)));
            }
        }
        Ok(())
    }

    /// The first and last value of the index parameter that follows those with values already; what is wrong with it is
    /// reported.
    fn order_range(&self, home: usize, family: &syntax::Family, before: &[i64]) -> Option<(i64, i64)> {
        let mut scope = Scope::new(self, home, self.units[home].source);
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
                    longer.push(order.iter().copied().chain([value]).listed());
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
            // Of two with one name, which is an error, the one that the name stands for.
            let unit = &self.units[MAIN];
            let meant = unit.position(&family.name.text).and_then(|position| unit.family(position));
            if meant.is_none_or(|meant| !core::ptr::eq(meant, family)) {
                continue;
            }
            if selected == Selected::WithoutOrder && !family.orders.is_empty() {
                continue;
            }
            let Some(orders) = self.orders(MAIN, family) else { continue };
            let before = items.len();
            let errors = self.diagnostics.borrow().errors();
            for order in &orders {
                if self.run.is_stopped() {
                    return items;
                }
                if let Ok(item) = self.item(&family.name.text, order) {
                    items.push(item);
                }
            }
            if items.len() == before + orders.len() {
                let source = self.units[MAIN].source;
                let mut warnings = Diagnostics::default();
                warnings.extend(unused::warnings(family, &|span| self.place(source, span)));
                if self.diagnostics.borrow().errors() == errors {
                    let claims = items[before..].iter().flat_map(|item| &item.claims);
                    let made = claims.map(|claim| claim.statement.number.0).listed();
                    warnings.extend(unused::never_made(family, &made, &|span| self.place(source, span)));
                }
                self.report_all(warnings);
            }
        }
        items
    }

    /// One family of the spec that was asked for, with its claims.
    ///
    /// # Errors
    /// What is wrong and what to write instead; `None` when its own errors are reported already.
    pub fn item(&self, name: &str, order: &[i64]) -> Result<Item, Option<(String, String)>> {
        let family = self.family(MAIN, name, order)?;
        let (home, position) = self.find(MAIN, name).ok_or(None)?;
        let written = self.units[home].family(position).ok_or(None)?;
        let (claims, obligations, diagnostics) = whole::claims(self, home, written, &family);
        self.report_all(at_order(diagnostics, written, order));
        Ok(Item { subject: Subject::Family(family), obligations, claims })
    }

    /// A family of the spec that was asked for as it is written, and the number of the spec that has it.
    #[cfg(any(test, feature = "tools"))]
    pub(crate) fn written(&self, name: &str) -> Option<(usize, &syntax::Family)> {
        let (home, position) = self.find(MAIN, name)?;
        Some((home, self.units[home].family(position)?))
    }

    /// The spec that has a family and its place there, seen from a spec.
    #[cfg(any(test, feature = "tools"))]
    pub(crate) fn place_of(&self, unit: usize, name: &str) -> Option<(usize, usize)> {
        self.find(unit, name)
    }

    /// A family as it is written.
    #[cfg(any(test, feature = "tools"))]
    pub(crate) fn tree(&self, unit: usize, position: usize) -> Option<&syntax::Family> {
        self.units[unit].family(position)
    }

    /// Calls a function with the number of the spec that was asked for, its source and each of its theorems and joins,
    /// and keeps the errors that it returns.
    #[cfg(feature = "joins")]
    pub(crate) fn each_theorem(
        &self,
        read: &mut dyn FnMut(usize, crate::source::SourceId, &syntax::Theorem) -> Diagnostics,
    ) {
        for written in self.theorems_of(MAIN) {
            if self.counts_as_family(MAIN, written.name.span).is_none() {
                break;
            }
            let source = self.units[MAIN].source;
            let mut found = read(MAIN, source, written);
            if found.errors() == 0 {
                found.extend(unused::of_theorem(written, &|span| self.place(source, span)));
            }
            self.report_all(found);
        }
    }

    /// What is not decided must not look as if it were: the first theorem or join of the spec that was asked for is an
    /// error.
    #[cfg(not(feature = "joins"))]
    pub(crate) fn refuse_theorems(&self) {
        let Some(first) = self.theorems_of(MAIN).next() else { return };
        let place = self.place(self.units[MAIN].source, first.name.span);
        self.report(Diagnostic::needs_feature(place, "theorems and joins need", "joins"));
    }

    /// Counts a family of one order, or a theorem; `None` when there are too many.
    fn counts_as_family(&self, unit: usize, span: Span) -> Option<()> {
        match self.run.family() {
            Ok(()) => return Some(()),
            Err(TooLarge::Run(message)) => {
                let error = Diagnostic::error(self.place(self.units[unit].source, span), message);
                self.report(error.help(SPLIT));
            }
            Err(TooLarge::Formula(_) | TooLarge::Said) => {}
        }
        None
    }
}

/// Errors in a family with index parameters say at which values they were met.
fn at_order(mut diagnostics: Diagnostics, family: &syntax::Family, order: &[i64]) -> Diagnostics {
    if !order.is_empty() && !diagnostics.is_empty() {
        let values: Vec<String> =
            family.orders.iter().zip(order).map(|(g, v)| format!("{} = {v}", g.name.text)).listed();
        for diagnostic in diagnostics.shown_mut() {
            diagnostic.notes.push(format!("for {}", values.join(", ")));
        }
    }
    diagnostics
}

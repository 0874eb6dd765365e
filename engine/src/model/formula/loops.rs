//! Loops over index variables.

use crate::algebra::rational::Rational;
use crate::model::budget::SPLIT;
use crate::model::scope::{Scope, Stage, Subject};
use crate::model::tuples::multi_indices;
use crate::syntax::{Comparison, Condition, Expr, Generator, Loops, Name};
use basis_prover::collections::list::Listed;

/// Loops that run longer than this are refused.
const MAX_ITERATIONS: i64 = 20_000;

impl Scope<'_> {
    /// Runs over all values of the index variables; `false` when a bound or condition went wrong or the
    /// body said so.
    pub(crate) fn each(&mut self, loops: &Loops, body: &mut dyn FnMut(&mut Self) -> bool) -> bool {
        let depth = self.constants.len();
        for generator in &loops.generators {
            let names = match generator {
                Generator::Range(range) => core::slice::from_ref(&range.name),
                Generator::Simplex(names, _) => names,
            };
            if !names.iter().all(|name| self.check_loop_name(name)) {
                return false;
            }
        }
        let mut left = MAX_ITERATIONS;
        let fine = self.each_from(loops, 0, &mut left, body);
        self.constants.truncate(depth);
        fine
    }

    /// Whether a condition holds; `None` when a side went wrong. What follows after the answer is clear is not looked at.
    fn holds(&mut self, condition: &Condition) -> Option<bool> {
        match condition {
            Condition::Compare(a, sign, b) => {
                let (x, y) = (self.condition_side(a)?, self.condition_side(b)?);
                Some(match sign {
                    Comparison::Equal => x == y,
                    Comparison::NotEqual => x != y,
                    Comparison::Less => x < y,
                    Comparison::LessEqual => x <= y,
                    Comparison::Greater => x > y,
                    Comparison::GreaterEqual => x >= y,
                })
            }
            Condition::All(parts) => self.first(parts, false),
            Condition::Any(parts) => self.first(parts, true),
            Condition::Not(inner) => Some(!self.holds(inner)?),
        }
    }

    /// The number that a side of a condition is.
    fn condition_side(&mut self, side: &Expr) -> Option<Rational> {
        let value = self.scalar(side)?;
        if value.as_constant().is_none() {
            let error = self.error(side.span, "a side of a condition must be a number");
            self.report(error.label("this contains a variable").help(if self.subject == Subject::Theorem {
                "conditions choose among the values of index variables; `assume λ > 0;` narrows the range of a scalar"
            } else {
                "conditions choose among the values of index variables; `prove at t = 0 { … }` fixes a place, `at λ = μ { … }` shape values, `independent except λ = 1` leaves some out; on parts of the domain a function is given in spans, `domain 0 <= t <= 1, 1 <= t <= 2; b[0] = t | 2 - t;`"
            }));
        }
        value.as_constant()
    }

    /// Whether some part is as `wanted`, for `||`; the other way round for `&&`.
    fn first(&mut self, parts: &[Condition], wanted: bool) -> Option<bool> {
        for part in parts {
            if self.holds(part)? == wanted {
                return Some(wanted);
            }
        }
        Some(!wanted)
    }

    fn check_loop_name(&self, name: &Name) -> bool {
        match self.taken(&name.text) {
            None | Some("an index") => true,
            Some("a scalar") => {
                let error = self.error(name.span, format!("`{}` is a scalar, not an index", name.text));
                self.report(error.help(format!(
                    "a claim is about all values of its scalars: leave `for {} …` out; indices run over whole numbers",
                    name.text
                )));
                false
            }
            Some("a domain variable") => {
                self.undeclared.borrow_mut().push(name.text.clone());
                let name_of = &name.text;
                let error = self.error(name.span, format!("`{name_of}` is a domain variable, not an index"));
                self.report(error.help(if self.stage == Stage::Defining {
                    String::from("functions are given on the whole domain; an index variable has a name of its own, `b[i] = … for i in 0..=3`")
                } else {
                    format!("a claim is about the whole domain: leave `for {name_of} …` out; at one point it is claimed by `at {name_of} = 1/2 {{ … }}`, on a part of the domain of the function with another argument, `b[0]({name_of}/2) >= 0` for `0 <= {name_of} <= 1/2`")
                }));
                false
            }
            Some("a shape parameter") => self.check_free_or(name, "a claim is about all values of a shape parameter: narrow its range where it is declared; an index variable has a name of its own"),
            Some(_) => self.check_free(name),
        }
    }

    fn each_from(
        &mut self,
        loops: &Loops,
        level: usize,
        left: &mut i64,
        body: &mut dyn FnMut(&mut Self) -> bool,
    ) -> bool {
        let Some(generator) = loops.generators.get(level) else {
            return match loops.condition.as_ref().map(|condition| self.holds(condition)) {
                None | Some(Some(true)) => body(self),
                Some(Some(false)) => true,
                Some(None) => false,
            };
        };
        let (names, values) = match generator {
            Generator::Range(range) => {
                let Some((first, last)) = self.bounds(range) else { return false };
                let last = last.min(first.saturating_add(MAX_ITERATIONS));
                (core::slice::from_ref(&range.name), (first..=last).map(|v| vec![v]).listed())
            }
            Generator::Simplex(names, sum) => {
                let Some(sum) = self.whole(sum, "the sum of the indices") else { return false };
                (names.as_slice(), multi_indices(names.len(), sum, MAX_ITERATIONS as usize))
            }
        };
        for index in values {
            if self.within(self.budget.step(1), names[0].span, SPLIT).is_none() {
                return false;
            }
            *left -= 1;
            if *left < 0 {
                self.report(
                    self.error(names[0].span, format!("the loop runs more than {MAX_ITERATIONS} times")),
                );
                return false;
            }
            let depth = self.constants.len();
            self.constants.extend(names.iter().zip(index).map(|(name, value)| (name.text.clone(), value)));
            let fine = self.each_from(loops, level + 1, left, body);
            self.constants.truncate(depth);
            if !fine {
                return false;
            }
        }
        true
    }
}

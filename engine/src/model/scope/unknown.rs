//! Names without a meaning: what is meant by them.

use proc_macro2::Span;

use super::{Scope, Stage, Subject};
use crate::advice::{closest, did_you_mean};
use crate::ascii::lowercase;
use crate::model::words::{
    BINOMIALS, BUILTINS, CIRCULAR, ELSEWHERE, FUNCTIONS, HYPERBOLIC, OTHER_NAMES, PI, VARIABLES,
    is_transcendental,
};
use basis_prover::collections::list::Listed;

impl Scope<'_> {
    /// Reports an unknown name, with the known name that it resembles.
    pub(crate) fn unknown(&self, name: &str, span: Span) {
        // A declaration that could not be read may have been that of this name.
        if self.cut_short && self.domain.is_empty() || self.is_mistaken(name) {
            return;
        }
        let error = self.error(span, format!("the name `{name}` is not declared"));
        if self.is_full() {
            return self.report(error);
        }
        self.undeclared.borrow_mut().push(name.to_string());
        let mut known: Vec<&str> = BUILTINS.to_vec();
        // `D` is one letter away from every short name.
        known.retain(|builtin| *builtin != "D" || name == "d");
        known.extend(self.names.iter().map(String::as_str));
        known.extend(self.constants.iter().map(|(n, _)| n.as_str()));
        known.extend(self.lets.keys().map(String::as_str));
        known.extend(self.planned.keys().map(String::as_str));
        known.push(&self.function_name);
        let families = self.library.visible(self.unit);
        known.extend(families.iter().map(String::as_str));
        let glued = self.glued(name);
        let derivative =
            name.strip_prefix('d').filter(|rest| *rest == self.function_name && !rest.is_empty());
        let help = match name {
            _ if name.strip_prefix('d').is_some_and(|variable| self.variable(variable).is_some()) => String::from(
                "leave the differential out: `integral(x)` is over the whole domain, `integral(x, t, a, b)` between bounds",
            ),
            _ if name.strip_prefix(['C', 'G']).is_some_and(|order| order.parse::<u8>().is_ok()) => {
                format!("the order is a number: `continuity({0})`, `smooth({0})`", &name[1..])
            }
            "ε" | "eps" | "epsilon" | "ulp" | "ulps" => {
                String::from("a bound of rounding errors is a number, in units of ε: `rounding <= 5`")
            }
            _ if name.strip_prefix(self.function_name.as_str()).is_some_and(|rest| rest.starts_with('['))
                || FUNCTIONS.contains(&name) && self.functions.is_empty() =>
            {
                return self.report(
                    self.error(span, format!("`{name}` is no parameter"))
                        .help("ranges, assumptions and `at` are about shape parameters and the domain variable, not about functions"),
                );
            }
            _ if self.with_underscore(name).is_some() => self.with_underscore(name).unwrap_or_default(),
            "i" | "j" | "k" | "l" if !self.counts && self.subject != Subject::Theorem => format!(
                "an index variable is known in its own statement, `for {name} in 0..=3`; a name by `let` takes it as an argument, `let h(x, {name}) = …;`"
            ),
            "abs" if self.subject == Subject::Family && self.stage == Stage::Defining => String::from(
                "write what it is on each side of its zero, on spans: `domain 0 <= t <= 1/2, 1/2 <= t <= 1; b[0] = 1/2 - t | t - 1/2;`",
            ),
            "abs" => String::from("write `-1 <= x <= 1` for |x| <= 1"),
            "sqrt" => String::from(
                "roots are not in the language: claim something about the square, `x^2 = 2`, or let the root be a shape parameter",
            ),
            _ if name.strip_prefix('D').is_some_and(|order| order.parse::<u8>().is_ok()) => {
                format!("write `D(…, {})`", &name[1..])
            }
            _ if derivative.is_some() => {
                format!("write `D({}[0])` for the derivative of `{0}[0]`", self.function_name)
            }
            _ if ELSEWHERE.contains(&name) => String::from(
                "functions are quotients of polynomials, `sin`, `cos`, `tan`, `sinh`, `cosh`, `tanh` and `exp`",
            ),
            "pi" | "π" => String::from("numbers are rational in theorems: write a fraction such as 22/7"),
            "e" => String::from("write `exp(1)` for the number, `exp(t)` for a power of it"),
            _ if self.domain.is_empty() && self.coming.iter().any(|n| n == name) => {
                return self.report(
                    self.error(span, format!("`{name}` is a domain variable"))
                        .help("ranges and assumptions are made of shape parameters and numbers; the domain itself has the ends that it is declared with"),
                );
            }
            "infinity" | "inf" | "oo" => String::from(
                "leave the end of the range out: `0 < λ` has no upper end; of a domain put t = s/(1 - s) with `0 <= s < 1`",
            ),
            _ if FUNCTIONS.contains(&name) && !self.functions.is_empty() => {
                format!("the functions of this family are called `{}`", self.function_name)
            }
            _ if BINOMIALS.contains(&name) => String::from("write `binomial(n, i)`"),
            _ if glued.is_some() => glued.unwrap_or_default(),
            _ if self.with_index(name).is_some() => self.with_index(name).unwrap_or_default(),
            _ => spelled_out(name, &known).unwrap_or_else(|| did_you_mean(name, &known, &|| {
                if self.subject == Subject::Theorem {
                    return format!(
                        "indices and orders are numbers, or index variables: `for {name} in 0..=3`"
                    );
                }
                if self.counts {
                    format!(
                        "write a whole number, let `{name}` run at the end of the statement, `for {name} in 0..=3`, or declare an index parameter: `family Name({name} in 1..=8)`"
                    )
                } else if name.starts_with(|c: char| c.is_ascii_uppercase()) {
                    format!("families here are {}", crate::plural::list(&families))
                } else {
                    let variable = match self.domain.as_slice() {
                        [only] if VARIABLES.contains(&name) => {
                            format!("the variable of the domain is `{}`; or ", self.names[only.0])
                        }
                        _ => String::new(),
                    };
                    format!(
                        "{variable}declare it: `shape 0 <= {name} <= 1;` for a shape parameter, `family Name({name} in 1..=8)` for an index parameter, `let {name} = …;` for a name"
                    )
                }
            })),
        };
        self.report(error.help(help));
    }

    /// What to write for `λ` where there is `λ_1`.
    fn with_underscore(&self, name: &str) -> Option<String> {
        let digits = |rest: &str| !rest.is_empty() && rest.bytes().all(|b| b.is_ascii_digit());
        let mut alike = self.names.iter().filter(|known| {
            known.strip_prefix(name).and_then(|rest| rest.strip_prefix('_')).is_some_and(digits)
        });
        alike.next().map(|known| format!("did you mean `{known}`? Parameters with an index are declared by `shape {name}[i] for i in 1..=2;`"))
    }

    /// What to write for `λ1` where `λ[1]` is meant.
    fn with_index(&self, name: &str) -> Option<String> {
        let letters = name.trim_end_matches(|c: char| c.is_ascii_digit());
        let (base, index) = (letters.trim_end_matches('_'), &name[letters.len()..]);
        let entry = format!("{base}[{index}]");
        let function = base == self.function_name && !index.is_empty();
        (function || self.variable(&entry).is_some()).then(|| format!("write `{entry}`"))
    }

    /// What to write for a name such as `cosθ` or `πt`, in which a function or number and a name are one word.
    fn glued(&self, name: &str) -> Option<String> {
        let functions = CIRCULAR.iter().chain(&HYPERBOLIC);
        let known = |rest: &str| self.variable(rest).is_some() || rest == "pi" || rest == "π";
        for function in functions {
            if let Some(rest) = name.strip_prefix(function).filter(|rest| known(rest)) {
                return Some(format!("write `{function}({rest})`"));
            }
            // sin2t
            let number =
                |rest: &str| rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_digit()).len();
            let parts = name.strip_prefix(function).map(|rest| rest.split_at(number(rest)));
            if let Some((number, rest)) = parts.filter(|(number, rest)| !number.is_empty() && known(rest)) {
                return Some(format!("write `{function}({number}*{rest})`"));
            }
        }
        let rest = PI.iter().find_map(|pi| name.strip_prefix(pi)).filter(|rest| known(rest))?;
        Some(format!("write `pi*{rest}`"))
    }

    /// Whether a name without a meaning is that of a function of the language but for its capital letters, as in `Sin[t]`.
    pub(crate) fn is_capitalised(&self, name: &str) -> bool {
        let small = lowercase(name);
        small != name
            && (BUILTINS.contains(&small.as_str()) || is_transcendental(&small))
            && name != self.function_name
            && self.taken(name).is_none()
            && !self.library.knows(self.unit, name)
    }

    /// Reports an unknown name in front of arguments: it is meant as a function.
    pub(crate) fn unknown_function(&self, name: &str, span: Span) {
        if self.is_full() || self.is_mistaken(name) {
            return self.unknown(name, span);
        }
        if let Some((_, instead)) = OTHER_NAMES.iter().find(|(other, _)| *other == name) {
            self.undeclared.borrow_mut().push(name.to_string());
            let error = self.error(span, format!("there is no function `{name}`"));
            return self.report(error.help(format!("write `{instead}`")));
        }
        if self.is_capitalised(name) {
            self.undeclared.borrow_mut().push(name.to_string());
            let error = self.error(span, format!("there is no function `{name}`"));
            return self.report(error.help(format!("write `{}(…)`", lowercase(name))));
        }
        let families = self.library.visible(self.unit);
        let known: Vec<&str> = BUILTINS.iter().copied().chain(families.iter().map(String::as_str)).listed();
        let near = closest(name, &known).is_some();
        let elsewhere = ELSEWHERE.contains(&name) || BINOMIALS.contains(&name);
        let is_family = name.starts_with(|c: char| c.is_ascii_uppercase());
        if near || elsewhere || is_family {
            return self.unknown(name, span);
        }
        self.undeclared.borrow_mut().push(name.to_string());
        let error = self.error(span, format!("there is no function `{name}`"));
        let all = [&BUILTINS[..], &CIRCULAR, &HYPERBOLIC].concat().join("`, `");
        // A short name may be that of a factor.
        let product = if name.chars().count() > 2 {
            String::new()
        } else {
            format!("; write `{name}*(…)` for a product")
        };
        self.report(error.help(format!("functions of the language are `{all}`{product}")));
    }
}

/// The known name that differs only in Greek letters that are spelled out, `lambda` and `λ`.
fn spelled_out(name: &str, known: &[&str]) -> Option<String> {
    let ascii = crate::ascii::ascii;
    let same = known.iter().find(|known| ascii(known) == ascii(name))?;
    Some(format!("the name is written `{same}`"))
}

//! Code in the languages of users, from proved families: files that people read and check in.
//!
//! The macro writes Rust into a build; `basis emit` writes files, for Rust and for languages that have no `basis!`. Each
//! begins with a [`header`]: which spec it is made from, how it is written again, and under which licence. Before each
//! family and join stand its formulas and its claims with their verdicts, [`FamilyCode::documentation`].
//!
//! # How a target is added
//!
//! Rust is printed from plans, because it has our runtime: [`rust`]. Every other language is an implementation of
//! [`Language`], in a file of its own beside this one, and a name on the command line.
//!
//! | file | language |
//! | --- | --- |
//! | [`c`] | C and C++, a prefix of names for each family, loops over components |
//! | [`python`] | Python, a class for each family, whole arrays |
//! | [`typescript`] | TypeScript, a class for each family, loops over components |
//! | [`shader`] | WGSL and GLSL, a prefix of names, vectors of four components |
//! | `write` | what they share |
//!
//! A new language comes with a row of its own in `tests/targets`: its program prints what [`FamilyCode`] can compute, and
//! the room compares it with the steps bit for bit and with exact values within the proved bounds.
//!
//! - The leaves are how the language writes a comment and a number, and which words it keeps for itself.
//! - [`Language::family`] and [`Language::join`] lay out the functions. What these compute comes as
//!   [`Steps`](crate::steps::Steps): [`FamilyCode::steps`] has those of every evaluator, and [`Expressions`] makes of
//!   them named values and results in infix notation; inputs have the names of [`FamilyCode::input`]. A language whose
//!   operators are not infix walks the steps itself. Steps compute one component of a point; a target either loops over
//!   the components or computes with whole arrays.
//! - No target computes anything by other operations than the steps: they are what is tested bit for bit beside the
//!   compiled Rust, and what rounding bounds are proved for. A compiler may fuse products into additions, which leaves
//!   out roundings; it may not reassociate, and a target says so where a compiler can be told to.
//! - Names are those of Rust, [`ascii`](crate::ascii::ascii), with `_` appended where a word is reserved.
//! - Shape values are checked once, where they come in: [`Shape`] has the range, and its text for the message.

#![allow(clippy::format_collect)] // a file is written once

pub mod c;
mod code;
mod expressions;
pub mod python;
pub mod rust;
pub mod shader;
pub mod typescript;
mod write;

use crate::algebra::rational::Rational;
use crate::diagnostic::Diagnostic;
use crate::steps::Function;
use crate::subject::Subject;
use crate::{Checked, generate};

pub use code::{Assumption, FamilyCode, JoinCode, Knot, Net, Shape, is_input};
pub use expressions::{Expressions, Value, decimal, decimal_f32};

/// What the documentation of emitted code says about the time of the proofs.
pub const DECIDED: &str = "when this file was written";

/// A family or a join that is to be written.
#[derive(Clone, Debug)]
pub struct Wanted {
    /// The family or join, with the verdicts of its claims.
    pub checked: Checked,
    /// The name that it is to have in the file; `None` for its own.
    pub name: Option<String>,
}

/// What is to be written into a file.
#[derive(Clone, Copy, Debug)]
pub struct Job<'a> {
    /// The families and joins.
    pub items: &'a [Wanted],
    /// The spec as the user named it, such as `specs/quartic.basis` or `library:quartic`.
    pub spec: &'a str,
    /// The command that writes the file again.
    pub command: &'a str,
}

/// A language that has no runtime of ours.
pub trait Language {
    /// A comment of these lines, which may be Markdown; with a line end.
    fn comment(&self, lines: &[String]) -> String;

    /// A constant ≥ 0 as an expression of the scalar type: the `f64` nearest to it, rounded to that type. See
    /// [`decimal`].
    fn literal(&self, value: &Rational) -> String;

    /// An elementary function of an expression.
    fn call(&self, function: Function, argument: &str) -> String;

    /// 0 where the first two expressions are equal, else the third; all can stand beside an operator, and so can this.
    fn unless(&self, parts: &[String; 3]) -> String;

    /// 1 where the first of two expressions is less than the second, else 0: as [`unless`](Self::unless).
    fn less(&self, parts: &[String; 2]) -> String;

    /// A name, or 0 where its value is negative, as an expression of the form of a call.
    fn cut_off(&self, name: &str) -> String;

    /// Whether it computes with `f32` only, so that every constant has to be one.
    fn is_single(&self) -> bool;

    /// Whether its sines, exponentials and the like are as accurate as [bounds of rounding
    /// errors](crate::rounding::assumed) assume.
    fn has_accurate_functions(&self) -> bool {
        true
    }

    /// Whether a name cannot be that of a variable, a function or a type: keywords, and names that the file needs for
    /// something else.
    fn is_reserved(&self, name: &str) -> bool;

    /// The code of a family, without its documentation.
    ///
    /// # Errors
    /// Why there is none.
    fn family(&self, family: &FamilyCode<'_>) -> Result<String, Diagnostic>;

    /// The code of a join, without its documentation.
    ///
    /// # Errors
    /// Why there is none.
    fn join(&self, join: &JoinCode<'_>) -> Result<String, Diagnostic>;

    /// The whole file, from its header, a comment, and the code of all items.
    fn file(&self, header: &str, items: &[String]) -> String;

    /// A name that is not reserved and not taken: with as many `_` appended as it needs.
    fn free(&self, name: &str, taken: &[String]) -> String {
        let ascii = crate::ascii::ascii(name);
        // Where names that begin with `_` are reserved, more of them at the end help nothing.
        let begins = if self.is_reserved(&ascii) { ascii.trim_start_matches('_') } else { &ascii };
        let is_name = begins.starts_with(|c: char| c == '_' || c.is_ascii_alphabetic());
        let mut name = format!("{}{begins}", if is_name { "" } else { "v" });
        while self.is_reserved(&name) || taken.contains(&name) {
            name.push('_');
        }
        name
    }
}

/// The text of a file in a language.
///
/// # Errors
/// For each family and join that has no code, why.
pub fn emit(language: &dyn Language, job: &Job<'_>) -> Result<String, Vec<Diagnostic>> {
    let mut items = Vec::new();
    let mut errors = Vec::new();
    let mut names = Names::default();
    for wanted in job.items {
        let code = match &wanted.checked.subject {
            Subject::Family(family) => {
                generate::evaluated(family, &wanted.checked.claims).and_then(|evaluated| {
                    let code = FamilyCode::new(family, &evaluated, wanted, language)?;
                    names.insert(&code.name, &wanted.checked.subject)?;
                    Ok((code.documentation.clone(), language.family(&code)?))
                })
            }
            Subject::Theorem(theorem) => JoinCode::new(theorem, wanted, language).and_then(|code| {
                names.insert(&code.name, &wanted.checked.subject)?;
                Ok((code.documentation.clone(), language.join(&code)?))
            }),
        };
        match code {
            Ok((documentation, code)) => items.push(language.comment(&documentation) + &code),
            Err(error) => errors.push(error),
        }
    }
    errors.extend(names.clash());
    if !errors.is_empty() {
        return Err(errors);
    }
    Ok(language.file(&language.comment(&header(job)), &items))
}

/// The names of a file so far, with what has them.
#[derive(Default)]
struct Names(Vec<(String, String)>);

impl Names {
    /// # Errors
    /// When the name is taken.
    fn insert(&mut self, name: &str, subject: &Subject) -> Result<(), Diagnostic> {
        let (place, title) = match subject {
            Subject::Family(family) => (&family.place, family.title()),
            Subject::Theorem(theorem) => (&theorem.place, theorem.name.clone()),
        };
        if let Some((_, other)) = self.0.iter().find(|(taken, _)| taken == name) {
            let message = format!("`{other}` and `{title}` are both called `{name}` in the file");
            let help = format!("give one of them another name: '{title} as OtherName'");
            return Err(Diagnostic::error(place.clone(), message).help(help));
        }
        self.0.push((name.to_string(), title));
        Ok(())
    }
}

/// What stands behind the name of a family in names of a file: of the class of its curves or patches, and, after a `_`, of
/// functions and constants where a language has no scopes.
const CLASSES: [&str; 2] = ["Curve", "Patch"];
const MEMBERS: [&str; 28] = [
    "init",
    "check",
    "values",
    "derivatives",
    "second",
    "partials",
    "bind",
    "bound",
    "eval",
    "curve",
    "points",
    "at",
    "FUNCTIONS",
    "COEFFICIENTS",
    "LOW",
    "HIGH",
    "KNOTS",
    "shape",
    "derived",
    "sin",
    "cos",
    "tan",
    "tanh",
    "expm1",
    "ROUNDING",
    "after",
    "before",
    "domain",
];

impl Names {
    /// Whether a name is one that the file gives to a part of another item.
    fn clash(&self) -> Option<Diagnostic> {
        for (name, title) in &self.0 {
            for (other, other_title) in &self.0 {
                let Some(rest) = other.strip_prefix(name.as_str()).filter(|rest| !rest.is_empty()) else {
                    continue;
                };
                let member = rest.strip_prefix('_').or_else(|| name.ends_with('_').then_some(rest));
                let first = member.map(|rest| rest.split('_').next().unwrap_or(rest));
                let is_member = first.is_some_and(|word| MEMBERS.contains(&word));
                if CLASSES.contains(&rest) || is_member {
                    let message =
                        format!("`{other}`, the name of `{other_title}`, is needed for parts of `{title}`");
                    let help = format!("give one of them another name: '{other_title} as OtherName'");
                    return Some(Diagnostic::unplaced(message).help(help));
                }
            }
        }
        None
    }
}

/// The lines at the top of a file: what it is made from, how it is written again, and that no licence is claimed.
pub fn header(job: &Job<'_>) -> Vec<String> {
    [
        format!("Made from `{}` by the command", job.spec),
        String::new(),
        format!("    {}", job.command),
        String::new(),
        String::from("Edit the spec and run the command again; do not edit this file."),
        String::from(
            "Every claim below that is called proved was proved, in exact arithmetic, before it was written.",
        ),
        String::new(),
        String::from(
            "No rights are claimed on this file by the authors of basis: use it under any licence, without",
        ),
        String::from("warranty."),
    ]
    .to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Also where every name that begins with `_` is.
    #[test]
    fn names_that_are_reserved_get_others() {
        let taken = [String::from("c1")];
        assert_eq!(python::Python.free("_c1", &taken), "c1_");
        assert_eq!(python::Python.free("_", &[]), "v");
        assert_eq!(python::Python.free("lambda", &[]), "lambda_");
        let c = c::C(c::Scalar::F64);
        for (name, free) in [
            ("__x", "x"),
            ("__1", "v1"),
            ("_X", "X"),
            ("_x", "_x"),
            ("DBL_MAX", "DBL_MAX_"),
            ("size_t", "size_t_"),
        ] {
            assert_eq!(c.free(name, &[]), free);
        }
    }
}

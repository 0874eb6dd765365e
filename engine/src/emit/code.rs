//! What a target gets of a family and of a join: names, ranges, documentation, and steps.

use super::{DECIDED, Language, Wanted};
use crate::algebra::range::{DisplayRange as _, Range};
use crate::diagnostic::Diagnostic;
use crate::generate;
use crate::model::{Family, Parameter};
use crate::steps::{FamilySteps, JoinSteps};
use crate::theorem::Theorem;

/// A family, as a target writes it.
#[derive(Clone, Debug)]
pub struct FamilyCode<'a> {
    /// The family.
    pub family: &'a Family,
    /// Its name in the file: the one asked for, or that of the type in Rust.
    pub name: String,
    /// What stands before it: formulas, ranges, claims with their verdicts; Markdown, one string a line.
    pub documentation: Vec<String>,
    /// The shape parameters.
    pub shapes: Vec<Shape<'a>>,
    /// All that can be evaluated.
    pub steps: FamilySteps<'a>,
}

/// A join, as a target writes it.
#[derive(Clone, Debug)]
pub struct JoinCode<'a> {
    /// The join.
    pub theorem: &'a Theorem,
    /// Its name in the file: the one asked for, or that of the function in Rust.
    pub name: String,
    /// What stands before it: its claims with their verdicts, the formulas of the points; Markdown, one string a line.
    pub documentation: Vec<String>,
    /// The scalars that the points depend on.
    pub scalars: Vec<Shape<'a>>,
    /// The determined points.
    pub steps: JoinSteps<'a>,
}

/// A shape parameter or a scalar of a join: its value has to be finite and inside of the range.
#[derive(Clone, Debug)]
pub struct Shape<'a> {
    /// Its name in the file, in ASCII.
    pub name: String,
    /// Its name in the spec.
    pub written: &'a str,
    /// Its doc comment, one string a line.
    pub doc: &'a [String],
    /// The declared range.
    pub range: &'a Range,
    /// The range as text, such as `-3 <= λ <= 1`.
    pub shown: String,
}

impl<'a> FamilyCode<'a> {
    /// A family in a language.
    ///
    /// # Errors
    /// Why no code is generated for it.
    pub fn new(family: &'a Family, wanted: &Wanted, language: &dyn Language) -> Result<Self, Diagnostic> {
        if let Some(error) = generate::no_code(family) {
            return Err(error);
        }
        let (Some(steps), Some(documentation)) =
            (FamilySteps::new(family), generate::documentation(family, &wanted.checked.claims, DECIDED))
        else {
            return Err(generate::too_large(family));
        };
        if let Some(error) = generate::beyond_floats(family, &steps) {
            return Err(error);
        }
        let name = language.free(wanted.name.as_ref().unwrap_or(&family.name), &[]);
        let shapes = shapes(family.shapes.iter(), language);
        Ok(Self { family, name, documentation, shapes, steps })
    }
}

impl<'a> JoinCode<'a> {
    /// A join in a language.
    ///
    /// # Errors
    /// Why there is no function for it.
    pub fn new(theorem: &'a Theorem, wanted: &Wanted, language: &dyn Language) -> Result<Self, Diagnostic> {
        let Some(steps) = JoinSteps::new(theorem) else { return Err(generate::join::products(theorem)) };
        let own = generate::join::name(theorem);
        let name = language.free(wanted.name.as_ref().unwrap_or(&own), &[]);
        let documentation = generate::join::about(theorem, &wanted.checked.claims, DECIDED);
        let scalars = shapes(steps.scalars.iter().copied(), language);
        Ok(Self { theorem, name, documentation, scalars, steps })
    }
}

/// Parameters under names that differ.
fn shapes<'a>(parameters: impl Iterator<Item = &'a Parameter>, language: &dyn Language) -> Vec<Shape<'a>> {
    let mut names: Vec<String> = Vec::new();
    parameters
        .map(|parameter| {
            let name = language.free(&parameter.name.replace(['[', ']', ','], "_"), &names);
            names.push(name.clone());
            let shown = parameter.range.display(&parameter.name).to_string();
            Shape { name, written: &parameter.name, doc: &parameter.doc, range: &parameter.range, shown }
        })
        .collect()
}

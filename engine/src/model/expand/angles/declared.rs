//! A variable that is an angle: what is known of it before it has a tangent.

use super::limits::{Bound, Limits, Place};
use super::survey::Use;
use crate::model::Parameter;
use crate::model::angle::Kind;
use crate::model::scope::Scope;
use crate::syntax::RangeDecl;

/// A variable that is an angle, as it is declared and used.
pub(super) struct Declared<'a> {
    pub(super) decl: &'a RangeDecl,
    pub(super) at: &'a Place,
    pub(super) of: &'a Use,
    pub(super) limits: &'a Limits,
    /// The ends that there are.
    pub(super) ends: Vec<&'a Bound>,
    /// How each variable is used; those that are no angles, not at all.
    pub(super) all: &'a [Option<Use>],
    /// The number of names before those that stand for the variables themselves.
    pub(super) count: usize,
    /// The parameters before this one.
    pub(super) known: &'a [Parameter],
}

impl Declared<'_> {
    /// The name of the variable.
    pub(super) fn name(&self) -> &str {
        &self.decl.name.text
    }

    pub(super) fn is_circular(&self) -> bool {
        self.of.kind == Kind::Circular
    }

    /// Whether shape parameters stand at the ends.
    pub(super) fn is_parametric(&self) -> bool {
        self.ends.iter().any(|l| !l.value.parts.is_empty())
    }

    /// Reports an error at the name; always `None`.
    pub(super) fn wrong<T>(&self, scope: &Scope<'_>, message: String, help: &str) -> Option<T> {
        scope.report(scope.error(self.decl.name.span, message).help(help));
        None
    }

    /// `None`, with an error, where an end is missing, or a shape parameter has another one at an end.
    pub(super) fn has_its_ends(&self, scope: &Scope<'_>) -> Option<()> {
        let (name, is_domain) = (self.name(), self.at.is_domain);
        if (is_domain || self.is_circular()) && self.ends.len() < 2 {
            let help = if is_domain {
                "write both ends, such as `domain 0 <= t <= pi/2;`"
            } else {
                "write both ends, such as `shape 0 < α < pi;`"
            };
            return self.wrong(scope, format!("the range of `{name}` has no end on one side"), help);
        }
        if !is_domain && self.is_parametric() {
            let message = format!("the range of `{name}` depends on another parameter");
            return self.wrong(scope, message, "give it numbers as ends");
        }
        Some(())
    }
}

//! Stands for the angles of a family where the feature `angles` is off.

use proc_macro2::Span;

use super::domain::Domain;
use super::shapes::Shapes;
use crate::diagnostic::Diagnostic;
use crate::model::scope::Scope;
use crate::syntax;

/// Reports that the feature is off, at what needs it.
pub(super) fn declare(scope: &mut Scope<'_>, _: &syntax::Family, place: Span) -> Option<(Shapes, Domain)> {
    scope.report(Diagnostic::needs_feature(
        scope.place(place),
        "sines and exponentials, `pi`, and domains that end at a shape parameter need",
        "angles",
    ));
    None
}

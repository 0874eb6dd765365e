//! Stands for sines and exponentials, and integrals and denominators with them, where the feature `angles` is off: no family has
//! angles.

use std::rc::Rc;

use basis_kernel::Domain;
use proc_macro2::Span;

use super::AngleValue;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::diagnostic::Diagnostic;
use crate::model::angle::{Analytic, Angle};
use crate::model::scope::Scope;
use crate::syntax::Expr;

#[allow(clippy::unnecessary_wraps, clippy::unused_self)]
impl Scope<'_> {
    /// Reports that the feature is off; of a family that is done before its functions are read.
    pub(crate) fn transcendental(&mut self, name: &str, _: &Expr, span: Span) -> Option<Fraction> {
        let what = format!("`{name}` needs");
        self.report(Diagnostic::needs_feature(self.place(span), &what, "angles"));
        None
    }

    /// Nothing: no function of angles has to be known.
    pub(in crate::model::formula) const fn record_bound(&mut self, _: &Fraction, _: Span) {}

    /// Nothing: there is no angle.
    pub(crate) fn angle_at(
        &self,
        _: &Angle,
        _: &Fraction,
        _: Span,
    ) -> Result<Option<Fraction>, (String, String)> {
        Ok(None)
    }

    pub(super) fn over_angle(
        &self,
        _: &Fraction,
        _: &Angle,
        _: [&AngleValue; 2],
        _: Span,
    ) -> Option<Fraction> {
        None
    }

    pub(super) fn between_bounds(_: &Analytic, _: &Poly, _: Domain) -> Option<(Poly, Rc<Domain>)> {
        None
    }

    pub(super) fn for_all_positive(&self, _: &Poly, _: &Domain) -> Option<(Poly, Rc<Domain>)> {
        None
    }

    pub(super) fn apart(&self, _: &Poly) -> Option<(Poly, Poly)> {
        None
    }

    pub(super) fn without_tangents(&self, _: &Poly, _: &Domain) -> Option<Poly> {
        None
    }

    pub(super) fn value_along(&self, _: Var, _: &Rational, _: &Domain) -> Option<String> {
        None
    }

    pub(super) fn vanishing_end(&self, _: &Poly, _: &Domain) -> Option<(&Angle, usize)> {
        None
    }
}

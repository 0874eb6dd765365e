//! Families on an interval with denominators in the domain variable: values, and the tables of numerators and
//! denominator.

use proc_macro2::{Literal, TokenStream};
use quote::quote_spanned;

use super::code::docs;
use super::code::shell::Shell;
use super::code::tokens::{doc, number, site};
use super::formula::factored;
use super::rust::Body;
use crate::claim::Claim;
use crate::model::Family;
use crate::plan::form::RationalForm;
use crate::plan::{Plan, rational};
use crate::state::Verdict;
use basis_prover::collections::list::Listed;

/// The type of a rational family on an interval.
pub(super) fn emit(shell: &Shell<'_>, form: &RationalForm, verdicts: &[(Claim, Verdict)]) -> TokenStream {
    let Shell { family, name, runtime, .. } = shell;
    let emitter = Emitter { shell, family, form, runtime };
    let basis = emitter.basis(&shell.core());
    let traits = quote_spanned! {site()=>
        #[allow(clippy::all, clippy::pedantic)]
        impl<S: #runtime::Scalar> #runtime::RationalBasis for #name<S> {
            #basis
        }
    };
    let docs = docs::family(family, &formulas(family, form), &[], verdicts, shell.decided);
    shell.definition(&docs, &emitter.methods(), &traits)
}

/// The functions as products over the common denominator, for reading.
pub(super) fn formulas(family: &Family, form: &RationalForm) -> Vec<String> {
    let text = |f| factored(family, &form.numerators, f);
    let functions = form.numerators.functions.iter().enumerate();
    let mut lines = vec![format!("w = {}", text(&form.denominator))];
    lines.extend(functions.map(|(k, f)| format!("{} = {}/w", family.function_label(k), text(f))));
    lines
}

struct Emitter<'a> {
    shell: &'a Shell<'a>,
    family: &'a Family,
    form: &'a RationalForm,
    runtime: &'a TokenStream,
}

impl Emitter<'_> {
    fn len(&self) -> Literal {
        Literal::usize_unsuffixed(self.form.numerators.len())
    }

    fn terms(&self) -> Literal {
        Literal::usize_unsuffixed(self.form.numerators.degree as usize + 1)
    }

    /// The methods that users call; the trait has the same for generic code.
    fn methods(&self) -> TokenStream {
        let Self { runtime, form, .. } = self;
        let len = self.len();
        let names: Vec<String> = (0..form.numerators.len()).map(|k| self.family.function_label(k)).listed();
        let all = if names.len() > 6 {
            format!("{}, …, {}", names[0], names[names.len() - 1])
        } else {
            names.join(", ")
        };
        let t = &self.family.names[form.numerators.var.0];
        let values_doc = doc(&format!("The values `[{all}]` at `{t}`."));
        let derivatives_doc = doc(&format!("The derivatives of the given order in `{t}` of `[{all}]`."));
        let Body { lets, outputs } = self.body(&rational::values(self.family, form));
        quote_spanned! {site()=>
            #values_doc
            #[inline]
            #[must_use]
            pub fn values(&self, t: S) -> [S; #len] {
                #lets [#(#outputs),*]
            }

            #runtime::__with_alloc! {
                #derivatives_doc
                #[inline]
                #[must_use]
                pub fn derivatives(&self, t: S, order: usize) -> [S; #len] {
                    #runtime::RationalBasis::derivatives(self, t, order)
                }
            }

            /// The curve over these control points, one for each function.
            #[inline]
            #[must_use]
            pub fn curve<P: #runtime::Point<Scalar = S>>(&self, points: [P; #len]) -> #runtime::RationalCurve<Self, P> {
                #runtime::RationalCurve::new(*self, points)
            }
        }
    }

    fn basis(&self, core: &TokenStream) -> TokenStream {
        let Self { runtime, form, family, .. } = self;
        let (len, terms) = (self.len(), self.terms());
        let title = family.title();
        let (low, high) = (number(&form.numerators.low), number(&form.numerators.high));
        let Body { lets, outputs } = self.body(&rational::numerators(family, form));
        let rows = outputs.chunks(form.numerators.len().max(1));
        let rows = rows.map(|row| quote_spanned!(site()=> [#(#row),*]));
        let numerators = quote_spanned!(site()=> #lets [#(#rows),*]);
        let Body { lets, outputs } = self.body(&rational::denominator(family, form));
        quote_spanned! {site()=>
            type Scalar = S;
            type Values = [S; #len];
            type Points<T: #core::marker::Copy> = [T; #len];
            type Bernstein<T: #core::marker::Copy> = [T; #terms];

            const NAME: &'static str = #title;

            #[inline]
            fn chart(&self) -> #runtime::Chart<S> {
                #runtime::Chart::affine([#low, #high])
            }

            #[inline]
            fn values(&self, t: S) -> [S; #len] {
                Self::values(self, t)
            }

            #[inline]
            fn numerators(&self) -> [[S; #len]; #terms] {
                #numerators
            }

            #[inline]
            fn denominator(&self) -> [S; #terms] {
                #lets [#(#outputs),*]
            }
        }
    }

    /// The code of a plan in a method with the parameter `t`.
    fn body(&self, plan: &Plan) -> Body {
        self.shell.body(plan, &|_| quote_spanned!(site()=> t))
    }
}

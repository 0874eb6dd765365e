//! Families on an interval: values, tables, and the binding to control points.

use proc_macro2::{Literal, TokenStream};
use quote::quote_spanned;

use super::code::docs;
use super::code::shell::Shell;
use super::code::tokens::{doc, number, site};
use super::ends::Ends;
use super::formula::factored;
use super::rust::Body;
use super::{nonnegative, rounding};
use crate::claim::Claim;
use crate::model::Family;
use crate::plan::interval::form::IntervalForm;
use crate::plan::{Input, Plan, interval};
use crate::state::Verdict;
use basis_prover::collections::list::Listed;

/// The type of a family on an interval.
pub(super) fn emit(shell: &Shell<'_>, form: &IntervalForm, verdicts: &[(Claim, Verdict)]) -> TokenStream {
    let Shell { family, name, runtime, .. } = shell;
    let formulas = formulas(family, form);
    let emitter = Emitter { shell, family, form, runtime, ends: Ends::new(shell) };
    let proved = rounding::bounds(family);
    let basis = emitter.basis(&shell.core(), &rounding::constants(&proved, runtime));
    let traits = quote_spanned! {site()=>
        #[allow(clippy::all, clippy::pedantic)]
        impl<S: #runtime::Scalar> #runtime::Basis for #name<S> {
            #basis
        }
    };
    let bounds = [nonnegative::on_interval(family, form), rounding::lines(&proved, family)].concat();
    let docs = docs::family(family, &formulas, &bounds, verdicts, shell.decided);
    shell.definition(&docs, &emitter.methods(), &traits)
}

/// The functions as products, for reading.
pub(super) fn formulas(family: &Family, form: &IntervalForm) -> Vec<String> {
    let formula =
        |k: usize| format!("{} = {}", family.function_label(k), factored(family, form, &form.functions[k]));
    (0..form.len()).map(formula).listed()
}

struct Emitter<'a> {
    shell: &'a Shell<'a>,
    family: &'a Family,
    form: &'a IntervalForm,
    runtime: &'a TokenStream,
    ends: Ends<'a>,
}

impl Emitter<'_> {
    /// The methods that users call; the trait has the same for generic code.
    fn methods(&self) -> TokenStream {
        let Self { runtime, form, .. } = self;
        let (len, terms) =
            (Literal::usize_unsuffixed(form.len()), Literal::usize_unsuffixed(form.degree as usize + 1));
        let names: Vec<String> = (0..form.len()).map(|k| self.family.function_label(k)).listed();
        let all = if names.len() > 6 {
            format!("{}, …, {}", names[0], names[names.len() - 1])
        } else {
            names.join(", ")
        };
        let t = &self.family.names[form.var.0];
        let values_doc = doc(&format!("The values `[{all}]` at `{t}`."));
        let derivatives_doc = doc(&format!(
            "The derivatives of the given order in `{t}` of `[{all}]`; all zero above the degree {}.",
            form.degree
        ));
        let coefficients_doc =
            doc(&format!("The monomial coefficients of each function: entry `k` is the factor of `{t}^k`."));
        let values = self.values();
        let coefficients = self.coefficients();
        let continuations = self.ends.methods();
        quote_spanned! {site()=>
            #values_doc
            #[inline]
            #[must_use]
            pub fn values(&self, t: S) -> [S; #len] {
                #values
            }

            #derivatives_doc
            #[inline]
            #[must_use]
            pub fn derivatives(&self, t: S, order: usize) -> [S; #len] {
                #runtime::Basis::derivatives(self, t, order)
            }

            #coefficients_doc
            #[must_use]
            pub fn coefficients(&self) -> [[S; #terms]; #len] {
                #coefficients
            }

            /// The coefficients of each function in the Bernstein basis of the same degree on the domain.
            #[must_use]
            pub fn bernstein_coefficients(&self) -> [[S; #terms]; #len] {
                let weights = #runtime::Basis::bernstein_weights(self);
                #runtime::__private::core::array::from_fn(|i| #runtime::__private::core::array::from_fn(|j| weights[j][i]))
            }

            /// The control points that make the same curve in the Bernstein basis of the same degree.
            #[must_use]
            pub fn to_bernstein<P: #runtime::Point<Scalar = S>>(&self, points: &[P; #len]) -> [P; #terms] {
                #runtime::Basis::to_bernstein(self, points)
            }

            /// The mass matrix: the integrals of products of two functions over the domain.
            #[must_use]
            pub fn mass_matrix(&self) -> [[S; #len]; #len] {
                #runtime::Basis::mass_matrix(self)
            }

            /// The stiffness matrix: the integrals of products of their derivatives over the domain.
            #[must_use]
            pub fn stiffness_matrix(&self) -> [[S; #len]; #len] {
                #runtime::Basis::stiffness_matrix(self)
            }

            #continuations
        }
    }

    fn basis(&self, core: &TokenStream, rounding: &TokenStream) -> TokenStream {
        let Self { runtime, form, family, .. } = self;
        let (len, terms) =
            (Literal::usize_unsuffixed(form.len()), Literal::usize_unsuffixed(form.degree as usize + 1));
        let title = family.title();
        let (low, high) = (number(&form.low), number(&form.high));
        let weights = self.weights();
        let (form_type, bind) = self.bind();
        let solutions = self.ends.solutions();
        quote_spanned! {site()=>
            type Scalar = S;
            type Values = [S; #len];
            type Points<T: #core::marker::Copy> = [T; #len];
            type Bernstein<T: #core::marker::Copy> = [T; #terms];
            type Form<P: #runtime::Point<Scalar = S>> = #form_type;

            const NAME: &'static str = #title;

            #rounding

            #[inline]
            fn domain() -> [S; 2] {
                [#low, #high]
            }

            #[inline]
            fn values(&self, t: S) -> [S; #len] {
                Self::values(self, t)
            }

            #[inline]
            fn bernstein_weights(&self) -> [[S; #len]; #terms] {
                #weights
            }

            #[inline]
            fn bind<P: #runtime::Point<Scalar = S>>(&self, points: &[P; #len]) -> Self::Form<P> {
                #bind
            }

            #solutions
        }
    }

    /// The code of a plan in a method with the parameter `t` or the control points `points`.
    fn body(&self, plan: &Plan) -> Body {
        self.shell.body(plan, &|input| match input {
            Input::Point(k) => {
                let k = Literal::usize_unsuffixed(k);
                quote_spanned!(site()=> points[#k])
            }
            _ => quote_spanned!(site()=> t),
        })
    }

    fn values(&self) -> TokenStream {
        let Body { lets, outputs } = self.body(&interval::values(self.family, self.form));
        let constant = (self.form.degree == 0).then(|| quote_spanned!(site()=> let _ = t;));
        quote_spanned!(site()=> #constant #lets [#(#outputs),*])
    }

    /// A table in rows of that length.
    fn table(&self, plan: &Plan, row: usize) -> TokenStream {
        let Body { lets, outputs } = self.body(plan);
        let rows = outputs.chunks(row.max(1)).map(|row| quote_spanned!(site()=> [#(#row),*]));
        quote_spanned!(site()=> #lets [#(#rows),*])
    }

    /// The monomial coefficients, one row for each function.
    fn coefficients(&self) -> TokenStream {
        self.table(&interval::coefficients(self.family, self.form), self.form.degree as usize + 1)
    }

    /// The Bernstein coefficients, one column for each function.
    fn weights(&self) -> TokenStream {
        self.table(&interval::bernstein_weights(self.family, self.form), self.form.len())
    }

    /// The type of a bound curve and the code that makes one.
    fn bind(&self) -> (TokenStream, TokenStream) {
        let Self { runtime, form, .. } = self;
        let Some(plan) = interval::bind(self.family, form) else {
            let n = Literal::usize_unsuffixed(form.degree as usize + 1);
            let form_type = quote_spanned!(site()=> #runtime::BernsteinForm<P, #n>);
            let body = quote_spanned!(site()=> #runtime::BernsteinForm::new(self.to_bernstein(points)));
            return (form_type, body);
        };
        let Body { lets, outputs } = self.body(&plan);
        let (ends, inner) = outputs.split_at(2);
        let n = Literal::usize_unsuffixed(inner.len());
        let form_type = quote_spanned!(site()=> #runtime::EndpointForm<P, #n>);
        let body = quote_spanned!(site()=> #lets #runtime::EndpointForm::new([#(#ends),*], [#(#inner),*]));
        (form_type, body)
    }
}

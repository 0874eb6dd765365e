//! Families on an interval: values, tables, and the binding to control points.

use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote_spanned};

use super::code::docs;
use super::code::powers::Powers;
use super::code::scalar::{self, ScalarCode};
use super::code::shell::Shell;
use super::code::tokens::{doc, number, site};
use super::ends::Ends;
use super::form::{Factored, IntervalForm, MAX_ENDPOINT_DEGREE};
use super::formula::factored;
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::claim::Claim;
use crate::model::Family;
use crate::state::Verdict;
use basis_prover::collections::list::{Listed, Mapped};

/// The type of a family on an interval.
pub(super) fn emit(shell: &Shell<'_>, form: &IntervalForm, verdicts: &[(Claim, Verdict)]) -> TokenStream {
    let Shell { family, name, runtime, .. } = shell;
    let formulas: Vec<String> = form
        .functions
        .iter()
        .enumerate()
        .map(|(k, f)| format!("{} = {}", family.function_label(k), factored(family, form, f)))
        .listed();
    let emitter = Emitter { shell, family, form, runtime, ends: Ends::new(shell) };
    let basis = emitter.basis(&shell.core());
    let traits = quote_spanned! {site()=>
        #[allow(clippy::all, clippy::pedantic)]
        impl<S: #runtime::Scalar> #runtime::Basis for #name<S> {
            #basis
        }
    };
    shell.definition(&docs::family(family, &formulas, verdicts), &emitter.methods(), &traits)
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

            #continuations
        }
    }

    fn basis(&self, core: &TokenStream) -> TokenStream {
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

    fn scalars(&self) -> ScalarCode {
        self.shell.scalars()
    }

    /// x^a s^b g(s, x) for every function, powers shared; with g in Bernstein form no step is negative where
    /// its coefficients are not.
    fn values(&self) -> TokenStream {
        let runtime = self.runtime;
        let mut code = self.scalars();
        let mut powers = Powers::default();
        let values: Vec<TokenStream> =
            self.form.functions.mapped(|f| self.value(&f.factored, &f.denom, &mut code, &mut powers));
        let (lets, powers) = (code.lets(), powers.lets());
        let unit = quote_spanned! {site()=>
            let [s, x] = #runtime::__private::unit(<Self as #runtime::Basis>::domain(), t);
        };
        let unit = if self.form.degree == 0 { quote_spanned!(site()=> let _ = t;) } else { unit };
        quote_spanned! {site()=>
            #unit
            #powers
            #lets
            [#(#values),*]
        }
    }

    fn value(&self, f: &Factored, denom: &Poly, code: &mut ScalarCode, powers: &mut Powers) -> TokenStream {
        let runtime = self.runtime;
        let mut product: Vec<TokenStream> = Vec::new();
        if !f.content.is_one() {
            product.push(number(&f.content));
        }
        match f.inner.as_slice() {
            [] => return number(&Rational::ZERO),
            [one] if one.is_one() => {}
            [one] => product.push(code.scalar(one)),
            many => {
                let entries = many.mapped(|p| code.scalar(p));
                product.push(quote_spanned!(site()=> #runtime::__private::bernstein([#(#entries),*], s, x)));
            }
        }
        let (s, x) = (powers.get("s", f.s_power), powers.get("x", f.x_power));
        match (s, x) {
            (Some(s), Some(x)) => product.push(quote_spanned!(site()=> (#s * #x))),
            (Some(one), None) | (None, Some(one)) => product.push(one.to_token_stream()),
            (None, None) => {}
        }
        if let Some(reciprocal) = code.reciprocal(denom) {
            product.push(reciprocal);
        }
        scalar::product(product)
    }

    /// The monomial coefficients, one row for each function.
    fn coefficients(&self) -> TokenStream {
        let functions = &self.form.functions;
        self.table(functions.mapped(|f| f.monomial.mapped(|p| (p, &f.denom))))
    }

    /// The Bernstein coefficients, one column for each function.
    fn weights(&self) -> TokenStream {
        let functions = &self.form.functions;
        let row = |j: usize| functions.mapped(|f| (&f.bernstein[j], &f.denom));
        self.table((0..=self.form.degree as usize).map(row).listed())
    }

    /// A table of quotients in the shape values.
    fn table(&self, rows: Vec<Vec<(&Poly, &Poly)>>) -> TokenStream {
        let mut code = self.scalars();
        let rows: Vec<TokenStream> = rows
            .into_iter()
            .map(|row| {
                let entries: Vec<TokenStream> =
                    row.into_iter().map(|(p, denom)| code.quotient(p, denom)).listed();
                quote_spanned!(site()=> [#(#entries),*])
            })
            .listed();
        let lets = code.lets();
        quote_spanned!(site()=> #lets [#(#rows),*])
    }

    /// The type of a bound curve and the code that makes one.
    fn bind(&self) -> (TokenStream, TokenStream) {
        let Self { runtime, form, .. } = self;
        let mut code = self.scalars();
        if form.degree > MAX_ENDPOINT_DEGREE {
            let n = Literal::usize_unsuffixed(form.degree as usize + 1);
            let form_type = quote_spanned!(site()=> #runtime::BernsteinForm<P, #n>);
            let body = quote_spanned!(site()=> #runtime::BernsteinForm::new(self.to_bernstein(points)));
            return (form_type, body);
        }
        let inner_len = form.degree.saturating_sub(1);
        let mut combination = |weights: Vec<(&Poly, &Poly)>| {
            let unit = weights.iter().filter(|(p, _)| !p.is_zero()).count() == 1;
            if let (true, Some(k)) = (unit, weights.iter().position(|(p, d)| p == d)) {
                let k = Literal::usize_unsuffixed(k);
                return quote_spanned!(site()=> points[#k]);
            }
            let weights = weights.into_iter().map(|(p, d)| code.quotient(p, d)).listed();
            quote_spanned!(site()=> #runtime::__private::combine(points, [#(#weights),*]))
        };
        let mut column = |k: usize| combination(form.functions.mapped(|f| (&f.endpoint[k], &f.denom)));
        let (start, end) = (column(0), column(1));
        let inner: Vec<TokenStream> = (0..inner_len as usize).map(|k| column(k + 2)).listed();
        let lets = code.lets();
        let n = Literal::usize_unsuffixed(inner_len as usize);
        let form_type = quote_spanned!(site()=> #runtime::EndpointForm<P, #n>);
        let body = quote_spanned!(site()=> #lets #runtime::EndpointForm::new([#start, #end], [#(#inner),*]));
        (form_type, body)
    }
}

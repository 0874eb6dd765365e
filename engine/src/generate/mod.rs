//! From a family and its verdicts to Rust code.
//!
//! The code is small: the shape values, the functions in factored form, the tables that bind control points.
//! Everything that does not depend on the family is in the runtime. What kind of numbers stand in the code is
//! decided here; what the formulas are is decided in [`form`], which other targets can share.

mod docs;
pub mod form;
mod formula;
mod names;
mod scalar;

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, quote_spanned};

use crate::algebra::poly::Poly;
use crate::algebra::range::End;
use crate::algebra::rational::Rational;
use crate::diagnostic::Diagnostic;
use crate::model::{Claim, Family};
use crate::prove::Verdict;
use form::{Factored, IntervalForm, MAX_ENDPOINT_DEGREE};
#[cfg(any(test, feature = "tools"))]
pub(crate) use formula::factored;
pub use names::ascii;
use scalar::ScalarCode;

/// How to emit a family.
#[derive(Clone, Debug)]
pub struct Options {
    /// The path of the runtime crate, such as `::basis_runtime`.
    pub runtime: TokenStream,
    /// The name of the type; `None` for the family's own name.
    pub name: Option<Ident>,
}

/// The type of a family, with its documentation and evaluators.
///
/// # Errors
/// When names of the spec cannot become names of Rust, or evaluators for this domain cannot be emitted.
pub fn family(
    family: &Family,
    verdicts: &[(Claim, Verdict)],
    options: &Options,
) -> Result<TokenStream, Diagnostic> {
    let Some(form) = IntervalForm::new(family) else {
        let message = format!("evaluators for the domain of `{}` cannot be generated", family.name);
        return Err(Diagnostic::error(family.place.clone(), message)
            .help("generated evaluators need one domain variable, such as `domain 0 <= t <= 1;`"));
    };
    let name = match &options.name {
        Some(name) => name.clone(),
        None => names::type_name(family)?,
    };
    let fields = names::fields(family)?;
    let code = Emitter { family, form, name: name.clone(), fields, runtime: &options.runtime }.emit(verdicts);
    Ok(in_module(&name, &code))
}

/// Puts the code of a type into a module of its own, in which no name of the caller has a meaning: a constant `t`, a type
/// `f64` or a macro-made `Result` of the caller would otherwise change what the code says.
fn in_module(name: &Ident, code: &TokenStream) -> TokenStream {
    let module = Ident::new(&format!("__basis_{}", name.to_string().trim_start_matches("r#")), site());
    quote_spanned! {site()=>
        #[doc(hidden)]
        #[allow(non_snake_case, unreachable_pub)]
        mod #module {
            #code
        }
        #[doc(inline)]
        #[allow(unused_imports, unreachable_pub)]
        pub use #module::#name;
    }
}

/// Locals of the emitted code do not see names of the caller.
fn site() -> Span {
    Span::mixed_site()
}

struct Emitter<'a> {
    family: &'a Family,
    form: IntervalForm,
    name: Ident,
    /// The Rust names of the shape parameters.
    fields: Vec<Ident>,
    runtime: &'a TokenStream,
}

impl Emitter<'_> {
    fn emit(&self, verdicts: &[(Claim, Verdict)]) -> TokenStream {
        let Self { name, fields, runtime, .. } = self;
        let docs = docs::family(self.family, &self.form, verdicts).into_iter().map(|line| doc(&line));
        let core = quote_spanned!(site()=> #runtime::__private::core);
        let field_types = fields.iter().map(|f| quote_spanned!(site()=> #f: S));
        let body = if fields.is_empty() {
            quote_spanned!(site()=> { scalar: #core::marker::PhantomData<S> })
        } else {
            quote_spanned!(site()=> { #(#field_types),* })
        };
        let constructor = self.constructor(&core);
        let default = fields.is_empty().then(|| {
            quote_spanned! {site()=>
                impl<S: #runtime::Scalar> #core::default::Default for #name<S> {
                    fn default() -> Self {
                        Self::new()
                    }
                }
            }
        });
        let methods = self.methods();
        let basis = self.basis(&core);
        quote_spanned! {site()=>
            #(#docs)*
            #[derive(#core::clone::Clone, #core::marker::Copy, #core::fmt::Debug, #core::cmp::PartialEq)]
            #[allow(non_camel_case_types, non_snake_case)]
            pub struct #name<S = f64> #body

            #[allow(non_snake_case, clippy::all, clippy::pedantic)]
            impl<S: #runtime::Scalar> #name<S> {
                #constructor
                #methods
            }

            #default

            #[allow(clippy::all, clippy::pedantic)]
            impl<S: #runtime::Scalar> #runtime::Basis for #name<S> {
                #basis
            }
        }
    }

    /// `new`, and one accessor for each shape parameter.
    fn constructor(&self, core: &TokenStream) -> TokenStream {
        let Self { fields, runtime, family, .. } = self;
        let title = family.title();
        if fields.is_empty() {
            let new = doc(&format!("The family `{title}`; it has no shape parameters."));
            return quote_spanned! {site()=>
                #new
                #[inline]
                #[must_use]
                pub const fn new() -> Self {
                    Self { scalar: #core::marker::PhantomData }
                }
            };
        }
        let ranges: Vec<String> =
            family.shapes.iter().map(|p| p.range.display(&p.name).to_string()).collect();
        let checks = family.shapes.iter().zip(fields).zip(&ranges).map(|((p, field), range)| {
            let (low, high) = (bound(&p.range.low, core), bound(&p.range.high, core));
            let parameter = &p.name;
            quote_spanned! {site()=>
                #field: #runtime::__private::check_shape(#title, #parameter, #field, #low, #high, #range)?
            }
        });
        let arguments = fields.iter().map(|f| quote_spanned!(site()=> #f: S));
        let new = doc(&format!(
            "The family `{title}` with shape values in the declared ranges: `{}`.",
            ranges.join("`, `")
        ));
        let accessors = family.shapes.iter().zip(fields).zip(&ranges).map(|((p, field), range)| {
            let mut lines = vec![format!("The shape parameter `{}`, `{range}`.", p.name)];
            if !p.doc.is_empty() {
                lines.push(String::new());
                lines.extend(p.doc.iter().cloned());
            }
            let docs = lines.iter().map(|line| doc(line));
            quote_spanned! {site()=>
                #(#docs)*
                #[inline]
                #[must_use]
                pub fn #field(&self) -> S {
                    self.#field
                }
            }
        });
        quote_spanned! {site()=>
            #new
            ///
            /// # Errors
            /// When a value is outside of its declared range, infinite, or NaN.
            #[inline]
            pub fn new(#(#arguments),*) -> #core::result::Result<Self, #runtime::ShapeError> {
                #core::result::Result::Ok(Self { #(#checks),* })
            }
            #(#accessors)*
        }
    }

    /// The methods for people; the trait has the same for generic code.
    fn methods(&self) -> TokenStream {
        let Self { runtime, form, .. } = self;
        let (len, terms) =
            (Literal::usize_unsuffixed(form.len()), Literal::usize_unsuffixed(form.degree as usize + 1));
        let names: Vec<String> = (0..form.len()).map(|k| self.family.function_label(k)).collect();
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
        }
    }

    fn scalars(&self) -> ScalarCode<'_> {
        ScalarCode::new(self.family, &self.fields)
    }

    /// x^a s^b g(s, x) for every function, powers shared; with g in Bernstein form no step is negative where
    /// its coefficients are not.
    fn values(&self) -> TokenStream {
        let runtime = self.runtime;
        let mut code = self.scalars();
        let mut powers = Powers::default();
        let values: Vec<TokenStream> = self
            .form
            .functions
            .iter()
            .map(|f| self.value(&f.factored, &f.denom, &mut code, &mut powers))
            .collect();
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

    fn value(
        &self,
        f: &Factored,
        denom: &Poly,
        code: &mut ScalarCode<'_>,
        powers: &mut Powers,
    ) -> TokenStream {
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
                let entries = many.iter().map(|p| code.scalar(p)).collect::<Vec<_>>();
                product.push(quote_spanned!(site()=> #runtime::__private::bernstein([#(#entries),*], s, x)));
            }
        }
        let (s, x) = (powers.get('s', f.s_power), powers.get('x', f.x_power));
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
        self.table(functions.iter().map(|f| f.monomial.iter().map(|p| (p, &f.denom)).collect()).collect())
    }

    /// The Bernstein coefficients, one column for each function.
    fn weights(&self) -> TokenStream {
        let functions = &self.form.functions;
        let row = |j: usize| functions.iter().map(|f| (&f.bernstein[j], &f.denom)).collect();
        self.table((0..=self.form.degree as usize).map(row).collect())
    }

    /// A table of quotients in the shape values.
    fn table(&self, rows: Vec<Vec<(&Poly, &Poly)>>) -> TokenStream {
        let mut code = self.scalars();
        let rows: Vec<TokenStream> = rows
            .into_iter()
            .map(|row| {
                let entries: Vec<TokenStream> =
                    row.into_iter().map(|(p, denom)| code.quotient(p, denom)).collect();
                quote_spanned!(site()=> [#(#entries),*])
            })
            .collect();
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
            let weights = weights.into_iter().map(|(p, d)| code.quotient(p, d)).collect::<Vec<_>>();
            quote_spanned!(site()=> #runtime::__private::combine(points, [#(#weights),*]))
        };
        let mut column =
            |k: usize| combination(form.functions.iter().map(|f| (&f.endpoint[k], &f.denom)).collect());
        let (start, end) = (column(0), column(1));
        let inner: Vec<TokenStream> = (0..inner_len as usize).map(|k| column(k + 2)).collect();
        let lets = code.lets();
        let n = Literal::usize_unsuffixed(inner_len as usize);
        let form_type = quote_spanned!(site()=> #runtime::EndpointForm<P, #n>);
        let body = quote_spanned!(site()=> #lets #runtime::EndpointForm::new([#start, #end], [#(#inner),*]));
        (form_type, body)
    }
}

/// The powers of s and x that the functions share.
#[derive(Default)]
struct Powers {
    known: Vec<(char, u32)>,
    lets: TokenStream,
}

impl Powers {
    /// The power of a letter; `None` for the exponent 0.
    fn get(&mut self, letter: char, exponent: u32) -> Option<Ident> {
        if exponent == 0 {
            return None;
        }
        if exponent == 1 {
            return Some(Ident::new(&letter.to_string(), site()));
        }
        let name = Ident::new(&format!("{letter}{exponent}"), site());
        if !self.known.contains(&(letter, exponent)) {
            let (a, b) = (self.get(letter, exponent / 2), self.get(letter, exponent - exponent / 2));
            self.lets.extend(quote_spanned!(site()=> let #name = #a * #b;));
            self.known.push((letter, exponent));
        }
        Some(name)
    }

    fn lets(self) -> TokenStream {
        self.lets
    }
}

/// A number of the scalar type.
fn number(value: &Rational) -> TokenStream {
    let literal = Literal::f64_unsuffixed(value.abs().to_f64());
    if value.is_negative() {
        quote_spanned!(site()=> -S::of(#literal))
    } else {
        quote_spanned!(site()=> S::of(#literal))
    }
}

fn bound(end: &End, core: &TokenStream) -> TokenStream {
    let literal = |value: &Rational| {
        let literal = Literal::f64_unsuffixed(value.abs().to_f64());
        if value.is_negative() {
            quote_spanned!(site()=> -#literal)
        } else {
            quote_spanned!(site()=> #literal)
        }
    };
    match end {
        End::Infinite => quote_spanned!(site()=> #core::ops::Bound::Unbounded),
        End::Included(value) => {
            let value = literal(value);
            quote_spanned!(site()=> #core::ops::Bound::Included(#value))
        }
        End::Excluded(value) => {
            let value = literal(value);
            quote_spanned!(site()=> #core::ops::Bound::Excluded(#value))
        }
    }
}

/// `/// line`
fn doc(line: &str) -> TokenStream {
    let line = if line.is_empty() { String::new() } else { format!(" {line}") };
    quote_spanned!(site()=> #[doc = #line])
}

//! What all generated types share: the definition, the constructor that checks shape values, their accessors.

use basis_kernel::Relation;
use proc_macro2::{Ident, TokenStream};
use quote::quote_spanned;

use super::names::arguments;
use super::tokens::{doc, float, number, site};
use crate::algebra::poly::Var;
use crate::algebra::range::End;
use crate::algebra::rational::Rational;
use crate::generate::rust::{self, Body, Surroundings};
use crate::model::chart::Constraint;
use crate::model::{Family, Parameter};
use crate::plan::reach::{self, FLOATS, Reach};
use crate::plan::{Input, Plan};
use basis_prover::collections::list::Mapped;

/// A family as a type.
pub(in crate::generate) struct Shell<'a> {
    pub(in crate::generate) family: &'a Family,
    pub(in crate::generate) name: Ident,
    /// The Rust names of the shape parameters.
    pub(in crate::generate) fields: Vec<Ident>,
    pub(in crate::generate) runtime: &'a TokenStream,
    /// How far floats reach in the shape parameters.
    pub(in crate::generate) reaches: Vec<Option<Reach>>,
    /// When the claims were decided.
    pub(in crate::generate) decided: &'static str,
}

impl Shell<'_> {
    /// The path of `core`.
    pub(in crate::generate) fn core(&self) -> TokenStream {
        let runtime = self.runtime;
        quote_spanned!(site()=> #runtime::__private::core)
    }

    /// The code of a plan in a method of the type; all inputs but shape values have the code that `input` gives.
    pub(in crate::generate) fn body(&self, plan: &Plan, input: &dyn Fn(Input) -> TokenStream) -> Body {
        self.body_by(plan, input, rust::BERNSTEIN[0])
    }

    /// The same with a function for polynomials in Bernstein form.
    pub(in crate::generate) fn body_by(
        &self,
        plan: &Plan,
        input: &dyn Fn(Input) -> TokenStream,
        bernstein: &'static str,
    ) -> Body {
        let input = |which: Input| match which {
            Input::Shape(k) if k < self.fields.len() => {
                let field = &self.fields[k];
                quote_spanned!(site()=> self.#field)
            }
            _ => input(which),
        };
        let points = Some(self.family.functions.len());
        let surroundings =
            Surroundings { runtime: self.runtime, input: &input, taken: &[], points, bernstein };
        rust::body(plan, &surroundings)
    }

    /// The definition of the type with its documentation, methods, and the implementations of traits.
    pub(in crate::generate) fn definition(
        &self,
        docs: &[String],
        methods: &TokenStream,
        traits: &TokenStream,
    ) -> TokenStream {
        let Self { name, fields, runtime, .. } = self;
        let core = self.core();
        let docs = docs.iter().map(|line| doc(line));
        let body = if fields.is_empty() {
            quote_spanned!(site()=> { scalar: #core::marker::PhantomData<S> })
        } else {
            quote_spanned!(site()=> { #(#fields: S),* })
        };
        let constructor = self.constructor(&core);
        let title = self.family.title();
        let labels = fields.iter().map(|field| field.to_string().trim_start_matches("r#").to_owned());
        let default = fields.is_empty().then(|| {
            quote_spanned! {site()=>
                impl<S: #runtime::Scalar> #core::default::Default for #name<S> {
                    fn default() -> Self {
                        Self::new()
                    }
                }
            }
        });
        // Where `new` takes arrays, how they are made of the fields.
        let all = arguments(self.family, fields);
        let order = all.iter().any(|a| a.is_array).then(|| {
            let parts = all.iter().map(|a| {
                let own = &fields[a.places.clone()];
                if a.is_array {
                    quote_spanned!(site()=> [#(#own),*])
                } else {
                    quote_spanned!(site()=> #(#own),*)
                }
            });
            quote_spanned!(site()=> , (#(#parts),*))
        });
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

            #runtime::__serialize_shape!(#name, #title, [#(#fields #labels),*] #order);

            #traits
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
        let ranges: Vec<String> = family.shapes.mapped(|p| family.declared(p));
        let checks = family.shapes.iter().zip(fields).zip(&ranges).zip(&self.reaches);
        let checks = checks.map(|(((p, field), range), reach)| {
            let [low, high] = shape_ends(family, p).map(|end| bound(&end, core));
            let parameter = family.name_of(p);
            let value = quote_spanned! {site()=>
                #runtime::__private::check_shape(#title, #parameter, #field, #low, #high, #range)?
            };
            let Some(reach) = reach else { return quote_spanned!(site()=> #field: #value) };
            let ends = [
                (&reach.high, "<=", Ident::new("check_reach", site())),
                (&reach.low, ">=", Ident::new("check_reach_below", site())),
            ];
            let mut checked = value;
            for (ends, sign, function) in ends {
                let Some(ends) = ends else { continue };
                let reaches = FLOATS.iter().zip(ends).map(|((floats, ..), end)| {
                    let last = reach::decimal(end);
                    let text = if range == parameter {
                        format!("{parameter} {sign} {last}, as far as {floats} reaches")
                    } else {
                        format!("{range}, of which {floats} reaches {parameter} {sign} {last}")
                    };
                    let end = signed(end);
                    quote_spanned!(site()=> (#end, #text))
                });
                checked = quote_spanned! {site()=>
                    #runtime::__private::#function(#title, #parameter, #checked, [#(#reaches),*])?
                };
            }
            quote_spanned!(site()=> #field: #checked)
        });
        let all = arguments(family, fields);
        let declared = all.iter().map(|a| {
            let (name, len) = (&a.name, a.places.len());
            if a.is_array {
                quote_spanned!(site()=> #name: [S; #len])
            } else {
                quote_spanned!(site()=> #name: S)
            }
        });
        let taken = all.iter().filter(|a| a.is_array).map(|a| {
            let (name, fields) = (&a.name, &fields[a.places.clone()]);
            quote_spanned!(site()=> let [#(#fields),*] = #name;)
        });
        let new = doc(&format!(
            "The family `{title}` with shape values in the declared ranges: `{}`.",
            ranges.join("`, `")
        ));
        let (assumed, assumptions) = self.assumptions();
        let accessors = all.iter().map(|argument| {
            let (field, p) = (&argument.name, &family.shapes[argument.places.start]);
            let own = ranges[argument.places.clone()].join("`, `");
            let mut lines = vec![if argument.is_array {
                format!("The shape parameters `{}`: `{own}`.", argument.written)
            } else {
                format!("The shape parameter `{}`, `{own}`.", family.name_of(p))
            }];
            if argument.is_array {
                let (fields, len) = (&fields[argument.places.clone()], argument.places.len());
                if !p.doc.is_empty() {
                    lines.push(String::new());
                    lines.extend(p.doc.iter().cloned());
                }
                let docs = lines.iter().map(|line| doc(line));
                return quote_spanned! {site()=>
                    #(#docs)*
                    #[inline]
                    #[must_use]
                    pub fn #field(&self) -> [S; #len] {
                        [#(self.#fields),*]
                    }
                };
            }
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
        let errors = String::from("When a value is outside of its declared range, infinite, or NaN")
            + if self.reaches.iter().any(Option::is_some) { ", or beyond what floats reach" } else { "" }
            + if assumptions.is_empty() { "" } else { ", or the values do not satisfy that" };
        let errors = doc(&(errors + "."));
        quote_spanned! {site()=>
            #new
            #assumed
            ///
            /// # Errors
            #errors
            #[inline]
            pub fn new(#(#declared),*) -> #core::result::Result<Self, #runtime::ShapeError> {
                #(#taken)*
                #(#assumptions)*
                #core::result::Result::Ok(Self { #(#checks),* })
            }
            #(#accessors)*
        }
    }

    /// What is assumed of the shape values, as documentation, and its checks.
    fn assumptions(&self) -> (TokenStream, Vec<TokenStream>) {
        let Self { fields, runtime, family, .. } = self;
        let title = family.title();
        let mut docs = TokenStream::new();
        let texts: Vec<String> = family.assumed().map(|c| c.text.clone()).collect();
        if !texts.is_empty() {
            let line = doc(&format!("They satisfy `{}`.", texts.join("`, `")));
            docs = quote_spanned!(site()=> #[doc = ""] #line);
        }
        let values = family.shapes.iter().zip(fields).map(|(shape, field)| {
            let value = quote_spanned!(site()=> #field);
            (shape.var, value)
        });
        let values: Vec<(Var, TokenStream)> = values.collect();
        let check = |c: &Constraint| check_assumed(runtime, &title, c, &family.names, &values);
        (docs, family.assumed().map(check).collect())
    }
}

/// The check that a polynomial in some values has its sign.
pub(crate) fn check_assumed(
    runtime: &TokenStream,
    title: &str,
    c: &Constraint,
    names: &[String],
    values: &[(Var, TokenStream)],
) -> TokenStream {
    let core = quote_spanned!(site()=> #runtime::__private::core);
    let terms = c.value.terms().map(|(m, coefficient)| {
        let mut term = number(coefficient);
        for (var, value) in values {
            for _ in 0..m.exponent(*var) {
                term = quote_spanned!(site()=> #term * #value);
            }
        }
        term
    });
    let (of, text) = (c.value.display(names).to_string(), &c.text);
    let zero = End::Included(Rational::ZERO);
    let low = if c.relation == Relation::Positive { End::Excluded(Rational::ZERO) } else { zero };
    let (low, high) = (bound(&low, &core), bound(&End::Infinite, &core));
    quote_spanned! {site()=>
        #runtime::__private::check_shape(#title, #of, #(#terms)+*, #low, #high, #text)?;
    }
}

/// The ends of the range of a shape parameter. That of an angle is known as the range of its tangent.
pub(crate) fn shape_ends(family: &Family, parameter: &Parameter) -> [End; 2] {
    let own = [&parameter.range.low, &parameter.range.high];
    let Some(angle) = family.analytic.angle(parameter.var) else { return own.map(End::clone) };
    core::array::from_fn(|k| {
        match family.analytic.number(&angle.limits[k]).filter(|_| !angle.ends[k].is_empty()) {
            Some(end) if own[k].is_included() => End::Included(end),
            Some(end) => End::Excluded(end),
            None => End::Infinite,
        }
    })
}

/// A number as a float.
fn signed(value: &Rational) -> TokenStream {
    let literal = float(value);
    if value.is_negative() { quote_spanned!(site()=> -#literal) } else { quote_spanned!(site()=> #literal) }
}

pub(in crate::generate) fn bound(end: &End, core: &TokenStream) -> TokenStream {
    match end {
        End::Infinite => quote_spanned!(site()=> #core::ops::Bound::Unbounded),
        End::Included(value) => {
            let value = signed(value);
            quote_spanned!(site()=> #core::ops::Bound::Included(#value))
        }
        End::Excluded(value) => {
            let value = signed(value);
            quote_spanned!(site()=> #core::ops::Bound::Excluded(#value))
        }
    }
}

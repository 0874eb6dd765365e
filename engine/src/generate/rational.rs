//! Families on an interval with denominators in the domain variable, with angles or exponentials, or with shape parameters
//! at the ends: values, the tables of numerators and denominator, and the map of the domain to the unit interval.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote_spanned};

use super::code::shell::Shell;
use super::code::tokens::{doc, float, number, site};
use super::code::{docs, reach};
use super::formula::{factored, is_sum};
use super::rust::{BERNSTEIN, Body};
use super::{nonnegative, rounding};
use crate::algebra::rational::Rational;
use crate::claim::Claim;
use crate::model::Family;
use crate::model::angle::{Analytic, Angle, Kind};
use crate::plan::digits::split;
use crate::plan::interval::form::RationalForm;
use crate::plan::interval::rational;
use crate::plan::{Input, Plan};
use crate::state::Verdict;
use basis_prover::collections::list::{Listed, Mapped};

/// The type of a family that is evaluated by quotients, one form for each span; `told` is the family as its documentation has
/// it.
pub(super) fn emit(
    shell: &Shell<'_>,
    told: &Family,
    forms: &[RationalForm],
    verdicts: &[(Claim, Verdict)],
) -> TokenStream {
    let Shell { family, name, runtime, .. } = shell;
    let spans = if family.pieces.is_empty() {
        vec![OnSpan { shell, family, form: &forms[0], runtime }]
    } else {
        let pieces = family.pieces.iter().zip(forms);
        pieces.map(|(piece, form)| OnSpan { shell, family: piece, form, runtime }).listed()
    };
    let emitter = Emitter { shell, spans };
    let proved = rounding::of_told(told, family);
    let (which, basis) = emitter.basis(&shell.core(), &rounding::constants(&proved, runtime));
    let traits = quote_spanned! {site()=>
        #[allow(clippy::all, clippy::pedantic)]
        impl<S: #runtime::Scalar> #runtime::#which for #name<S> {
            #basis
        }
    };
    let formulas = formulas(told, family, forms);
    let (signs, reaches) = (nonnegative::of_quotients(family, forms), reach::lines(family, &shell.reaches));
    let bounds = [signs, reaches, rounding::lines(&proved, family)].concat();
    let docs = docs::family(told, &formulas, &bounds, verdicts, shell.decided);
    shell.definition(&docs, &emitter.methods(), &traits)
}

/// The functions of the family that is `told` of, as products over the common denominator where they are quotients of
/// polynomials, for reading; nothing where sines and exponentials are read best as they are written. Then what is evaluated in
/// their place.
pub(super) fn formulas(told: &Family, family: &Family, forms: &[RationalForm]) -> Vec<String> {
    let mut formulas = exact_formulas(told, forms);
    if told.pieces.len() != family.pieces.len() {
        let on = if forms.len() > 1 { format!(" on {} spans", forms.len()) } else { String::new() };
        formulas.extend((!formulas.is_empty()).then(String::new));
        formulas.push(format!("evaluated as polynomials{on}, as near to these as floats are"));
    }
    formulas
}

fn exact_formulas(family: &Family, forms: &[RationalForm]) -> Vec<String> {
    if !family.analytic.is_empty() && !family.written.is_empty() {
        return Vec::new();
    }
    let labels = (0..family.functions.len()).map(|k| (k, family.function_label(k)));
    if !family.pieces.is_empty() {
        let text = |k: usize, piece: &Family| piece.functions[k].value.display(&piece.names);
        let on_all = |k: usize| family.pieces.iter().map(|piece| text(k, piece)).listed().join(" | ");
        return labels.map(|(k, label)| format!("{label} = {}", on_all(k))).listed();
    }
    if !family.is_rational() || !family.analytic.is_empty() {
        return labels
            .map(|(k, label)| format!("{label} = {}", family.functions[k].value.display(&family.names)))
            .listed();
    }
    let form = &forms[0];
    let text = |f| factored(family, &form.numerators, f);
    // A name that the family does not have.
    let taken = |name: &str| family.names.iter().any(|known| known == name) || family.function_name == name;
    let below = ["w", "d", "q", "below"].into_iter().find(|name| !taken(name)).unwrap_or("denominator");
    let function = |(k, label)| {
        let f = &form.numerators.functions[k];
        let above = if is_sum(&form.numerators, f) { format!("({})", text(f)) } else { text(f) };
        format!("{label} = {above}/{below}")
    };
    let mut lines: Vec<String> = labels.map(function).listed();
    lines.push(format!("where {below} = {}", text(&form.denominator)));
    lines
}

struct Emitter<'a> {
    shell: &'a Shell<'a>,
    /// At least one.
    spans: Vec<OnSpan<'a>>,
}

/// A span of the domain.
struct OnSpan<'a> {
    shell: &'a Shell<'a>,
    /// The functions on the span.
    family: &'a Family,
    form: &'a RationalForm,
    runtime: &'a TokenStream,
}

impl Emitter<'_> {
    fn len(&self) -> Literal {
        Literal::usize_unsuffixed(self.shell.family.functions.len())
    }

    /// The methods that users call; the trait has the same for generic code.
    fn methods(&self) -> TokenStream {
        let Shell { runtime, family, .. } = self.shell;
        let len = self.len();
        let names: Vec<String> = (0..family.functions.len()).map(|k| family.function_label(k)).listed();
        let all = if names.len() > 6 {
            format!("{}, …, {}", names[0], names[names.len() - 1])
        } else {
            names.join(", ")
        };
        let t = family.domain.first().map_or("t", |p| family.name_of(p));
        let values_doc = doc(&format!("The values `[{all}]` at `{t}`."));
        let derivatives_doc = doc(&format!("The derivatives of the given order in `{t}` of `[{all}]`."));
        let (which, curve, values) = match self.spans.as_slice() {
            [only] => ("RationalBasis", "RationalCurve", only.values()),
            _ => (
                "SpannedBasis",
                "SpannedCurve",
                quote_spanned!(site()=> #runtime::SpannedBasis::values(self, t)),
            ),
        };
        let [which, curve] = [which, curve].map(|name| Ident::new(name, site()));
        quote_spanned! {site()=>
            #values_doc
            #[inline]
            #[must_use]
            pub fn values(&self, t: S) -> [S; #len] {
                #values
            }

            #runtime::__with_alloc! {
                #derivatives_doc
                #[inline]
                #[must_use]
                pub fn derivatives(&self, t: S, order: usize) -> [S; #len] {
                    #runtime::#which::derivatives(self, t, order)
                }
            }

            /// The curve over these control points, one for each function.
            #[inline]
            #[must_use]
            pub fn curve<P: #runtime::Point<Scalar = S>>(&self, points: [P; #len]) -> #runtime::#curve<Self, P> {
                #runtime::#curve::new(*self, points)
            }
        }
    }

    /// The name of the trait, and what stands in its implementation.
    fn basis(&self, core: &TokenStream, bounds: &TokenStream) -> (Ident, TokenStream) {
        let Shell { runtime, family, .. } = self.shell;
        let len = self.len();
        let terms = Literal::usize_unsuffixed(self.spans[0].form.numerators.degree as usize + 1);
        let title = family.title();
        let types = quote_spanned! {site()=>
            type Scalar = S;
            type Values = [S; #len];
            type Points<T: #core::marker::Copy> = [T; #len];
            type Bernstein<T: #core::marker::Copy> = [T; #terms];
        };
        let name = quote_spanned!(site()=> const NAME: &'static str = #title; #bounds);
        if let [only] = self.spans.as_slice() {
            let (chart, numerators, denominator) = (only.chart(), only.numerators(), only.denominator());
            let code = quote_spanned! {site()=>
                #types
                #name

                #[inline]
                fn chart(&self) -> #runtime::Chart<S> {
                    #chart
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
                    #denominator
                }
            };
            return (Ident::new("RationalBasis", site()), code);
        }
        let count = Literal::usize_unsuffixed(self.spans.len());
        let charts = self.spans.mapped(OnSpan::chart);
        let values = self.on_each(&|span| span.values());
        let (numerators, denominators) =
            (self.on_each(&|span| span.numerators()), self.on_each(&|span| span.denominator()));
        let code = quote_spanned! {site()=>
            #types
            type Spans<T: #core::marker::Copy> = [T; #count];
            #name

            #[inline]
            fn charts(&self) -> [#runtime::Chart<S>; #count] {
                [#({ #charts }),*]
            }

            #[inline]
            fn values_on(&self, span: usize, t: S) -> [S; #len] {
                #values
            }

            fn numerators_on(&self, span: usize) -> [[S; #len]; #terms] {
                #numerators
            }

            fn denominator_on(&self, span: usize) -> [S; #terms] {
                #denominators
            }
        };
        (Ident::new("SpannedBasis", site()), code)
    }

    /// Code that depends on the span.
    fn on_each(&self, of: &dyn Fn(&OnSpan<'_>) -> TokenStream) -> TokenStream {
        let last = self.spans.len() - 1;
        let arms = self.spans.iter().enumerate().map(|(k, span)| {
            let code = of(span);
            let pattern = if k == last {
                quote_spanned!(site()=> _)
            } else {
                Literal::usize_unsuffixed(k).to_token_stream()
            };
            quote_spanned!(site()=> #pattern => { #code })
        });
        quote_spanned!(site()=> match span { #(#arms)* })
    }
}

impl OnSpan<'_> {
    fn values(&self) -> TokenStream {
        let Self { form, family, runtime, shell } = self;
        if form.is_tabulated {
            let chart = self.chart();
            let table = if shell.family.pieces.len() > 1 {
                quote_spanned!(site()=> #runtime::SpannedBasis::numerators_on(self, span))
            } else {
                quote_spanned!(site()=> #runtime::RationalBasis::numerators(self))
            };
            let function = Ident::new(self.bernstein(), site());
            let values = quote_spanned!(site()=> #runtime::__private::#function(#table, s, x));
            let nonnegative = self.nonnegative();
            let values = if nonnegative.is_empty() {
                values
            } else {
                quote_spanned! {site()=>
                    let mut values = #values;
                    #(values[#nonnegative] = #runtime::__private::cut_off(values[#nonnegative]);)*
                    values
                }
            };
            return quote_spanned! {site()=>
                let [s, x] = { #chart }.coordinates(t);
                #values
            };
        }
        let Body { lets, outputs } = self.body(&rational::values(family, form));
        let coordinates = (!family.analytic.is_empty()).then(|| {
            let chart = self.chart();
            quote_spanned!(site()=> let [s, x] = { #chart }.coordinates(t);)
        });
        quote_spanned!(site()=> let _ = t; #coordinates #lets let _ = (s, x); [#(#outputs),*])
    }

    /// The positions of the functions that are proved to be nonnegative.
    fn nonnegative(&self) -> Vec<Literal> {
        let marks = self.family.nonnegative.iter().enumerate().filter(|(_, mark)| **mark);
        marks.map(|(k, _)| Literal::usize_unsuffixed(k)).listed()
    }

    fn numerators(&self) -> TokenStream {
        let Self { form, family, .. } = self;
        let Body { lets, outputs } = self.body(&rational::numerators(family, form));
        let rows = outputs.chunks(form.numerators.len().max(1));
        let rows = rows.map(|row| quote_spanned!(site()=> [#(#row),*]));
        quote_spanned!(site()=> #lets [#(#rows),*])
    }

    fn denominator(&self) -> TokenStream {
        let Body { lets, outputs } = self.body(&rational::denominator(self.family, self.form));
        quote_spanned!(site()=> #lets [#(#outputs),*])
    }

    /// The map of the domain to the unit interval.
    fn chart(&self) -> TokenStream {
        let mut code = self.map();
        for p in &self.family.domain {
            if !p.range.low.is_included() {
                code = quote_spanned!(site()=> { #code }.without_start());
            }
            if !p.range.high.is_included() {
                code = quote_spanned!(site()=> { #code }.without_end());
            }
        }
        code
    }

    /// The map of the closed domain.
    fn map(&self) -> TokenStream {
        let Self { runtime, form, family, .. } = self;
        let numerators = &form.numerators;
        let Some(angle) = family.analytic.angle(numerators.var) else {
            let (low, high) = (number(&numerators.low), number(&numerators.high));
            return quote_spanned!(site()=> #runtime::Chart::affine([#low, #high]));
        };
        let known = angle.limits.each_ref().map(|end| family.analytic.number(end));
        let Body { lets, outputs } = self.body(&rational::ends(family, angle));
        let lets = if known.iter().all(Option::is_some) { TokenStream::new() } else { lets };
        let ends: Vec<TokenStream> =
            outputs.into_iter().zip(&known).map(|(code, known)| known.as_ref().map_or(code, number)).listed();
        let map = match angle.kind {
            Kind::Linear => {
                let missing =
                    known.each_ref().map(|end| end.as_ref().map_or(Rational::ZERO, |x| split(x, 53).1));
                let exact = missing.iter().any(|rest| !rest.is_zero()).then(|| {
                    let float = |end: &Option<Rational>| {
                        literal(&end.as_ref().map_or(Rational::ZERO, |x| split(x, 53).0))
                    };
                    let (floats, rests) = (known.each_ref().map(float), missing.each_ref().map(literal));
                    quote_spanned!(site()=> .with_exact_ends([#(#floats),*], [#(#rests),*]))
                });
                let exact = exact.or_else(|| self.sums_as_ends(angle));
                return quote_spanned!(site()=> #lets #runtime::Chart::affine([#(#ends),*]) #exact);
            }
            Kind::Circular => quote_spanned!(site()=> circular),
            Kind::Hyperbolic => quote_spanned!(site()=> hyperbolic),
        };
        let pi = Analytic::pi();
        let rate = angle.speed();
        let shift = if angle.turns { angle.shift.clone() } else { &angle.shift * &pi };
        // The argument of the tangent at both ends.
        let turn = ends
            .iter()
            .zip(&known)
            .map(|(code, known)| match known {
                Some(end) => number(&(&rate * &(end - &shift))),
                None => {
                    // Only an angle with numbers as ends is measured from elsewhere.
                    let rate = number(&rate);
                    quote_spanned!(site()=> #rate * (#code))
                }
            })
            .listed();
        let missing = match &known {
            [Some(low), Some(high)] => {
                let [low, high] = [low, high].map(|end| split(end, 53));
                let missing = [&low, &high].into_iter().any(|(float, rest)| {
                    let short = float.is_integer() && float.abs() < Rational::from(1 << 24);
                    !rest.is_zero() || !short
                });
                missing.then(|| {
                    let (floats, rests) = ([&low.0, &high.0].map(literal), [&low.1, &high.1].map(literal));
                    quote_spanned!(site()=> .with_exact_ends([#(#floats),*], [#(#rests),*]))
                })
            }
            _ => None,
        };
        let missing = missing.or_else(|| self.sums_as_ends(angle));
        let rate = number(&rate);
        quote_spanned! {site()=>
            #lets #runtime::Chart::#map([#(#ends),*], #rate, [#(#turn),*]) #missing
        }
    }

    /// That the ends of the domain are sums of multiples of shape parameters, where these are not floats themselves.
    fn sums_as_ends(&self, angle: &Angle) -> Option<TokenStream> {
        let sums = rational::sums(self.family, angle)?;
        let [low, high] = sums.map(|terms| {
            let terms = terms.iter().map(|(c, of)| {
                let of = match of.map(|k| &self.shell.fields[k]) {
                    None => quote_spanned!(site()=> S::ONE),
                    Some(field) => quote_spanned!(site()=> self.#field),
                };
                let c = literal(c);
                quote_spanned!(site()=> (#c, #of))
            });
            quote_spanned!(site()=> &[#(#terms),*])
        });
        Some(quote_spanned!(site()=> .with_sums_as_ends([#low, #high])))
    }

    /// The code of a plan in a method with the parameter `t`, or the coordinates `s` and `x`.
    fn body(&self, plan: &Plan) -> Body {
        let analytic = &self.family.analytic;
        let shapes = self.shell.fields.len();
        let input = |input| match input {
            Input::Coordinate(0) if analytic.is_empty() => quote_spanned!(site()=> t),
            Input::Coordinate(0) => quote_spanned!(site()=> s),
            Input::Shape(k) => {
                let angle = &analytic.angles[(k - shapes) % analytic.angles.len()];
                let argument = self.argument(angle);
                let negative = quote_spanned!(site()=> -(#argument));
                match (k - shapes) / analytic.angles.len() {
                    0 => self.tangent(angle, ["tan", "tanh"], &argument),
                    1 => self.tangent(angle, ["tan_complement", "tanh_complement"], &argument),
                    // 1 + tanh x = 1 − tanh(−x)
                    _ => self.tangent(angle, ["tan_complement", "tanh_complement"], &negative),
                }
            }
            _ => quote_spanned!(site()=> x),
        };
        self.shell.body_by(plan, &input, self.bernstein())
    }

    /// The function of the runtime for polynomials in Bernstein form; where the functions are polynomials in the variable, its
    /// coordinates sum to 1.
    fn bernstein(&self) -> &'static str {
        BERNSTEIN[usize::from(!self.form.divides(self.family) && !self.family.analytic.is_empty())]
    }

    /// What stands in the tangent of a shape parameter.
    fn argument(&self, angle: &Angle) -> TokenStream {
        let field = self.family.shapes.iter().position(|p| p.var == angle.var);
        let field = field.map(|k| &self.shell.fields[k]);
        let rate = angle.speed();
        let rate = number(&rate);
        quote_spanned!(site()=> #rate * self.#field)
    }

    /// A tangent by one of two functions of the runtime, for circular and for hyperbolic ones.
    fn tangent(
        &self,
        angle: &Angle,
        [circular, hyperbolic]: [&str; 2],
        argument: &TokenStream,
    ) -> TokenStream {
        let runtime = self.runtime;
        let function = if angle.kind == Kind::Hyperbolic { hyperbolic } else { circular };
        let function = Ident::new(function, site());
        quote_spanned!(site()=> #runtime::__private::#function(#argument))
    }
}

/// A number as an `f64`.
fn literal(value: &Rational) -> TokenStream {
    let literal = float(value);
    if value.is_negative() { quote_spanned!(site()=> -#literal) } else { literal }
}

//! Families on an interval with denominators in the domain variable, with angles or exponentials, or with shape parameters
//! at the ends: values, the tables of numerators and denominator, and the map of the domain to the unit interval.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote_spanned;

use super::code::docs;
use super::code::shell::Shell;
use super::code::tokens::{doc, float, number, site};
use super::formula::factored;
use super::rust::Body;
use crate::algebra::rational::Rational;
use crate::claim::Claim;
use crate::model::Family;
use crate::model::angle::{Analytic, Angle, Kind};
use crate::plan::form::RationalForm;
use crate::plan::{Input, Plan, rational};
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
    if !family.analytic.is_empty() {
        let text = |k: usize| {
            format!("{} = {}", family.function_label(k), family.functions[k].value.display(&family.names))
        };
        return (0..family.functions.len()).map(text).listed();
    }
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
        let Self { runtime, form, family, .. } = self;
        let len = self.len();
        let names: Vec<String> = (0..form.numerators.len()).map(|k| family.function_label(k)).listed();
        let all = if names.len() > 6 {
            format!("{}, …, {}", names[0], names[names.len() - 1])
        } else {
            names.join(", ")
        };
        let t = family.domain.first().map_or("t", |p| family.name_of(p));
        let values_doc = doc(&format!("The values `[{all}]` at `{t}`."));
        let derivatives_doc = doc(&format!("The derivatives of the given order in `{t}` of `[{all}]`."));
        let Body { lets, outputs } = self.body(&rational::values(family, form));
        let coordinates = (!family.analytic.is_empty()).then(
            || quote_spanned!(site()=> let [s, x] = #runtime::RationalBasis::chart(self).coordinates(t);),
        );
        let constant = (form.numerators.degree == 0).then(|| quote_spanned!(site()=> let _ = t;));
        quote_spanned! {site()=>
            #values_doc
            #[inline]
            #[must_use]
            pub fn values(&self, t: S) -> [S; #len] {
                #constant #coordinates #lets [#(#outputs),*]
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
        let chart = self.chart();
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
                #lets [#(#outputs),*]
            }
        }
    }

    /// The map of the domain to the unit interval.
    fn chart(&self) -> TokenStream {
        let Self { runtime, form, family, .. } = self;
        let numerators = &form.numerators;
        let Some(angle) = family.analytic.angle(numerators.var) else {
            let (low, high) = (number(&numerators.low), number(&numerators.high));
            return quote_spanned!(site()=> #runtime::Chart::affine([#low, #high]));
        };
        let known = angle.limits.each_ref().map(|end| family.analytic.number(end));
        let Body { lets, outputs } = self.body(&rational::ends(family, angle));
        let ends: Vec<TokenStream> =
            outputs.into_iter().zip(&known).map(|(code, known)| known.as_ref().map_or(code, number)).listed();
        let map = match angle.kind {
            Kind::Linear => {
                return quote_spanned!(site()=> #lets #runtime::Chart::affine([#(#ends),*]));
            }
            Kind::Circular => quote_spanned!(site()=> circular),
            Kind::Hyperbolic => quote_spanned!(site()=> hyperbolic),
        };
        let pi = Analytic::pi();
        let rate = if angle.turns { &angle.rate * &pi } else { angle.rate.clone() };
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
                let [low, high] = [low, high].map(split);
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
        let rate = number(&rate);
        quote_spanned! {site()=>
            #lets #runtime::Chart::#map([#(#ends),*], #rate, [#(#turn),*]) #missing
        }
    }

    /// The code of a plan in a method with the parameter `t`, or the coordinates `s` and `x`.
    fn body(&self, plan: &Plan) -> Body {
        let analytic = &self.family.analytic;
        let shapes = self.shell.fields.len();
        self.shell.body(plan, &|input| match input {
            Input::Coordinate(0) if analytic.is_empty() => quote_spanned!(site()=> t),
            Input::Coordinate(0) => quote_spanned!(site()=> s),
            Input::Shape(k) => match analytic.angles.get(k - shapes) {
                Some(angle) => self.tangent(angle, "tan", "tanh"),
                None => self.tangent(
                    &analytic.angles[k - shapes - analytic.angles.len()],
                    "tan",
                    "tanh_complement",
                ),
            },
            _ => quote_spanned!(site()=> x),
        })
    }

    /// The tangent of a shape parameter, by one of two functions of the runtime.
    fn tangent(&self, angle: &Angle, circular: &str, hyperbolic: &str) -> TokenStream {
        let Self { runtime, family, shell, .. } = self;
        let field = family.shapes.iter().position(|p| p.var == angle.var).map(|k| &shell.fields[k]);
        let rate = if angle.turns { &angle.rate * &Analytic::pi() } else { angle.rate.clone() };
        let rate = number(&rate);
        let function = if angle.kind == Kind::Hyperbolic { hyperbolic } else { circular };
        let function = Ident::new(function, site());
        quote_spanned!(site()=> #runtime::__private::#function(#rate * self.#field))
    }
}

/// A number as the nearest float and what is missing to it.
fn split(value: &Rational) -> (Rational, Rational) {
    let mut unit = Rational::ONE;
    let (half, two) = (Rational::new(1, 2), Rational::from(2));
    // The float is a multiple of the unit, by a number of 53 bits.
    let (low, high) = (Rational::from(1 << 52), Rational::from(1 << 53));
    let size = value.abs();
    while !size.is_zero() && &high * &unit <= size {
        unit = &unit * &two;
    }
    while !size.is_zero() && size < &low * &unit {
        unit = &unit * &half;
    }
    let steps = value.checked_div(&unit).unwrap_or(Rational::ZERO);
    let nearest = &(&steps + &half).floor() * &unit;
    let rest = value - &nearest;
    (nearest, rest)
}

/// A number as an `f64`.
fn literal(value: &Rational) -> TokenStream {
    let literal = float(value);
    if value.is_negative() { quote_spanned!(site()=> -#literal) } else { literal }
}

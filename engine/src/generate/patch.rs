//! Families on triangles, tetrahedra and boxes: values, and the table from which everything else follows.
//!
//! A family that is raised from a lowest order is emitted as the functions of that order and the steps, written out, to
//! its own; each step is a sum of products of nonnegative coordinates with functions, so it keeps signs and small
//! relative errors.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote_spanned;

use super::code::docs;
use super::code::powers::Powers;
use super::code::scalar::{self, ScalarCode};
use super::code::shell::Shell;
use super::code::tokens::{doc, number, site};
use super::formula::factored_on_box;
use super::patch_form::{PatchForm, PatchFunction, exponents, factored_text, multi_indices, raised};
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::claim::Claim;
use crate::diagnostic::Diagnostic;
use crate::model::{Family, Function, label};
use crate::state::Verdict;
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::map::SortedMap;

/// The type of a family on a simplex or a box.
///
/// # Errors
/// When the family is too large.
pub(super) fn emit(shell: &Shell<'_>, verdicts: &[(Claim, Verdict)]) -> Result<TokenStream, Diagnostic> {
    let family = shell.family;
    let steps = recursion(family);
    let functions = if steps > 0 { &family.base } else { &family.functions };
    let Some(form) = PatchForm::of_functions(family, functions) else {
        let message = format!("`{}` has too many coefficients to be generated", family.title());
        return Err(Diagnostic::error(family.place.clone(), message)
            .help("choose a lower order, or functions of lower degree"));
    };
    let emitter = Emitter { shell, form, steps };
    let formulas = emitter.formulas(functions);
    Ok(shell.definition(&docs::family(family, &formulas, verdicts), &emitter.methods(), &emitter.traits()))
}

/// How many steps b[I] = Σ_j x_j b[I − e_j] lead from the functions of the lowest order to those of the family; 0 when
/// its recursion is another one.
fn recursion(family: &Family) -> u32 {
    let corners = family.domain.len() + 1;
    if !family.is_simplex() || !lattice(&family.base, corners) || !lattice(&family.functions, corners) {
        return 0;
    }
    let order = |functions: &[Function]| functions.first().map_or(0, |f| f.index.iter().sum::<i64>());
    let steps = order(&family.functions) - order(&family.base);
    let mut functions = family.base.clone();
    for _ in 0..steps {
        functions = raised(family, &functions);
    }
    let same = functions.iter().zip(&family.functions).all(|(a, b)| a.index == b.index && a.value == b.value);
    if steps > 0 && same { steps as u32 } else { 0 }
}

/// Whether the functions are those of all indices (i, j, …) with one sum.
fn lattice(functions: &[Function], corners: usize) -> bool {
    let Some(first) = functions.first().filter(|f| f.index.len() == corners) else { return false };
    // The model has checked that there is no gap.
    u32::try_from(first.index.iter().sum::<i64>())
        .is_ok_and(|order| multi_indices(corners, order).len() == functions.len())
}

/// Longer sums are not written out.
const MAX_TERMS: usize = 15;

struct Emitter<'a> {
    shell: &'a Shell<'a>,
    /// The form of the functions, or of those of the lowest order.
    form: PatchForm,
    /// How often they are raised.
    steps: u32,
}

impl Emitter<'_> {
    /// The formulas for the documentation.
    fn formulas(&self, functions: &[Function]) -> Vec<String> {
        let family = self.shell.family;
        let mut lines: Vec<String> = functions
            .iter()
            .zip(&self.form.functions)
            .map(|(f, form)| {
                let formula = if family.is_simplex() {
                    factored_text(family, form, &self.form)
                } else {
                    factored_on_box(family, &self.form, form)
                };
                format!("{} = {formula}", label(&family.function_name, &f.index))
            })
            .listed();
        if self.steps > 0 {
            let letters: Vec<String> = ["i", "j", "k", "l"][..self.corners()].mapped(ToString::to_string);
            let term = |(j, x): (usize, &str)| {
                let mut index = letters.clone();
                index[j] += "-1";
                format!("{x}*{}[{}]", family.function_name, index.join(","))
            };
            let names = family.domain_variables().map(|p| p.name.as_str());
            let terms: Vec<String> = names.enumerate().map(term).listed();
            let steps = if self.steps == 1 { String::from("once") } else { format!("{} times", self.steps) };
            lines.push(String::new());
            let left = format!("{}[{}]", family.function_name, letters.join(","));
            lines.push(format!("{left} = {} of the order before, {steps}", terms.join(" + ")));
        }
        lines
    }

    /// How many coordinates a point of the domain has.
    fn corners(&self) -> usize {
        let family = self.shell.family;
        family.domain.len() + usize::from(family.is_simplex())
    }

    /// The degrees of the functions of the family.
    fn degrees(&self) -> Vec<u32> {
        self.form.degrees.mapped(|d| d + self.steps)
    }

    /// The lowest order of the recursion.
    fn lowest(&self) -> Literal {
        let functions = &self.shell.family.base;
        Literal::i64_unsuffixed(functions.first().map_or(0, |f| f.index.iter().sum()))
    }

    /// The number of functions, and of Bernstein coefficients of each.
    fn lengths(&self) -> (Literal, Literal) {
        let terms = exponents(&self.form.groups, &self.degrees()).len();
        (Literal::usize_unsuffixed(self.shell.family.functions.len()), Literal::usize_unsuffixed(terms))
    }

    /// The methods that users call; the trait has the same for generic code.
    fn methods(&self) -> TokenStream {
        let Shell { runtime, family, .. } = self.shell;
        let simplex = family.is_simplex();
        let (len, terms) = self.lengths();
        let (k, orders) =
            (Literal::usize_unsuffixed(self.corners()), Literal::usize_unsuffixed(family.domain.len()));
        let names: Vec<&str> = family.domain_variables().map(|p| p.name.as_str()).listed();
        let (at, independent) = (names.join(", "), names[..family.domain.len()].join(", "));
        let (first, last) = (family.function_label(0), family.function_label(family.functions.len() - 1));
        let values_doc = doc(&format!("The values `[{first}, …, {last}]` at `[{at}]`."));
        let partials_doc = doc(&if simplex {
            let rest = names[..family.domain.len()].join(" − ");
            let last = names[family.domain.len()];
            format!("The partial derivatives of these orders in `{independent}`, with `{last} = 1 − {rest}`.")
        } else {
            format!("The partial derivatives of these orders in `{independent}`.")
        });
        let basis = self.basis();
        let along = simplex.then(|| {
            quote_spanned! {site()=>
                /// The derivatives of the given order along a direction, a difference of two points in barycentric
                /// coordinates: `[1, -1, 0]` is the edge from the second corner to the first.
                #[inline]
                #[must_use]
                pub fn derivatives(&self, at: [S; #k], along: [S; #k], order: usize) -> [S; #len] {
                    #basis::derivatives(self, at, along, order)
                }
            }
        });
        let values = self.values();
        quote_spanned! {site()=>
            #values_doc
            #[inline]
            #[must_use]
            #[allow(unused_variables)]
            pub fn values(&self, at: [S; #k]) -> [S; #len] {
                #values
            }

            #along

            #partials_doc
            #[inline]
            #[must_use]
            pub fn partials(&self, at: [S; #k], orders: [usize; #orders]) -> [S; #len] {
                #basis::partials(self, at, orders)
            }

            /// The coefficients of each function in the Bernstein basis of the same degree on the domain.
            #[must_use]
            pub fn bernstein_coefficients(&self) -> [[S; #terms]; #len] {
                let weights = #basis::bernstein_weights(self);
                #runtime::__private::core::array::from_fn(|i| #runtime::__private::core::array::from_fn(|j| weights[j][i]))
            }

            /// The control points of the same patch in the Bernstein basis of the same degree.
            #[must_use]
            pub fn to_bernstein<P: #runtime::Point<Scalar = S>>(&self, points: &[P; #len]) -> [P; #terms] {
                #basis::to_bernstein(self, points)
            }
        }
    }

    /// The path of the trait.
    fn basis(&self) -> TokenStream {
        let runtime = self.shell.runtime;
        if self.shell.family.is_simplex() {
            quote_spanned!(site()=> #runtime::SimplexBasis)
        } else {
            quote_spanned!(site()=> #runtime::BoxBasis)
        }
    }

    fn traits(&self) -> TokenStream {
        let Shell { runtime, name, family, .. } = self.shell;
        let (basis, core) = (self.basis(), self.shell.core());
        let (len, terms) = self.lengths();
        let (k, orders) =
            (Literal::usize_unsuffixed(self.corners()), Literal::usize_unsuffixed(family.domain.len()));
        let title = family.title();
        let weights = self.weights();
        let degrees: Vec<Literal> = self.degrees().into_iter().map(Literal::u32_unsuffixed).listed();
        let shape = if family.is_simplex() {
            let order = if lattice(&family.functions, self.corners()) {
                let order = Literal::i64_unsuffixed(family.functions[0].index.iter().sum());
                quote_spanned!(site()=> #core::option::Option::Some(#order))
            } else {
                quote_spanned!(site()=> #core::option::Option::None)
            };
            let degree = &degrees[0];
            quote_spanned! {site()=>
                const DEGREE: usize = #degree;
                const MULTINOMIALS: &'static [f64] = &#runtime::__private::multinomials::<#terms>(#k, #degree);
                const ORDER: #core::option::Option<usize> = #order;
            }
        } else {
            let ranges = || family.domain.iter().filter_map(|p| p.range.finite());
            let low = ranges().map(|(low, _)| number(low));
            let high = ranges().map(|(_, high)| number(high));
            quote_spanned! {site()=>
                const DEGREES: &'static [usize] = &[#(#degrees),*];

                #[inline]
                fn domain() -> [[S; #k]; 2] {
                    [[#(#low),*], [#(#high),*]]
                }
            }
        };
        let triangle = (self.corners() == 3 && family.is_simplex()).then(|| self.triangle());
        quote_spanned! {site()=>
            #[allow(clippy::all, clippy::pedantic)]
            impl<S: #runtime::Scalar> #basis for #name<S> {
                type Scalar = S;
                type Coordinates = [S; #k];
                type Orders = [usize; #orders];
                type Values = [S; #len];
                type Points<T: #core::marker::Copy> = [T; #len];
                type Bernstein<T: #core::marker::Copy> = [T; #terms];

                const NAME: &'static str = #title;
                #shape

                #[inline]
                fn values(&self, at: [S; #k]) -> [S; #len] {
                    Self::values(self, at)
                }

                fn bernstein_weights(&self) -> [[S; #len]; #terms] {
                    #weights
                }
            }

            #triangle
        }
    }

    /// What only a triangle has: edges. When on every edge the functions of its control points alone are different from
    /// zero, an edge of a patch is a curve over these points, else over the Bernstein points of the edge.
    fn triangle(&self) -> TokenStream {
        let Shell { runtime, name, family, .. } = self.shell;
        let core = self.shell.core();
        let functions = if self.steps > 0 { &family.base } else { &family.functions };
        let own = lattice(functions, 3)
            && functions.iter().zip(&self.form.functions).all(|(f, form)| {
                form.inner.is_empty()
                    || f.index.iter().zip(&form.powers).all(|(i, power)| *i == 0 || *power > 0)
            });
        let degree = self.degrees()[0] as usize + 1;
        let points = if own { family.functions[0].index.iter().sum::<i64>() as usize + 1 } else { degree };
        let (degree, points) = (Literal::usize_unsuffixed(degree), Literal::usize_unsuffixed(points));
        quote_spanned! {site()=>
            #[allow(clippy::all, clippy::pedantic)]
            impl<S: #runtime::Scalar> #runtime::TriangularBasis for #name<S> {
                type EdgeValues = [S; #points];
                type EdgePoints<T: #core::marker::Copy> = [T; #points];
                type EdgeBernstein<T: #core::marker::Copy> = [T; #degree];
                type EdgeForm<P: #runtime::Point<Scalar = S>> = #runtime::BernsteinForm<P, #degree>;

                const OWN_EDGES: bool = #own;

                #[inline]
                fn edge_form<P: #runtime::Point<Scalar = S>>(points: &[P; #degree]) -> Self::EdgeForm<P> {
                    #runtime::BernsteinForm::new(*points)
                }
            }
        }
    }

    /// The names of all coordinates, group by group, and the code that gives them their values.
    fn coordinates(&self) -> (Vec<String>, TokenStream) {
        let Shell { runtime, family, .. } = self.shell;
        let ident = |name: &String| Ident::new(name, site());
        if family.is_simplex() {
            let names: Vec<String> = (0..self.corners()).map(|k| format!("x{k}")).listed();
            let idents = names.iter().map(ident);
            let code = quote_spanned!(site()=> let [#(#idents),*] = at;);
            return (names, code);
        }
        let mut names = Vec::new();
        let mut code = TokenStream::new();
        for (k, parameter) in family.domain.iter().enumerate() {
            let Some((low, high)) = parameter.range.finite() else { continue };
            let (x, s) = (format!("x{k}"), format!("s{k}"));
            let (low, high, place) = (number(low), number(high), Literal::usize_unsuffixed(k));
            let (x_ident, s_ident) = (ident(&x), ident(&s));
            code.extend(quote_spanned! {site()=>
                let [#s_ident, #x_ident] = #runtime::__private::unit([#low, #high], at[#place]);
            });
            names.extend([x, s]);
        }
        (names, code)
    }

    fn values(&self) -> TokenStream {
        let (names, coordinates) = self.coordinates();
        let mut code = self.shell.scalars();
        let mut powers = Powers::default();
        let values: Vec<TokenStream> =
            self.form.functions.mapped(|f| self.value(f, &names, &mut code, &mut powers));
        let (lets, powers) = (code.lets(), powers.lets());
        let mut values = quote_spanned!(site()=> [#(#values),*]);
        if self.steps > 0 {
            let raised = self.raised(&names);
            values = quote_spanned!(site()=> let b = #values; #raised b);
        }
        quote_spanned!(site()=> #coordinates #powers #lets #values)
    }

    /// The steps of the recursion, written out: `let b = [x2*b[0], x1*b[0] + x2*b[1], …];` for each order.
    fn raised(&self, names: &[String]) -> TokenStream {
        let mut code = TokenStream::new();
        let lowest = self.shell.family.base.first().map_or(0, |f| f.index.iter().sum::<i64>());
        for step in 0..self.steps {
            let order = lowest as u32 + step;
            let before = multi_indices(names.len(), order);
            let entries = multi_indices(names.len(), order + 1).into_iter().map(|mut index| {
                let mut terms: Vec<TokenStream> = Vec::new();
                for (j, name) in names.iter().enumerate().filter(|(j, _)| index[*j] > 0).listed() {
                    index[j] -= 1;
                    let place = before.binary_search(&index).unwrap_or(0);
                    index[j] += 1;
                    let (x, place) = (Ident::new(name, site()), Literal::usize_unsuffixed(place));
                    terms.push(quote_spanned!(site()=> #x * b[#place]));
                }
                quote_spanned!(site()=> #(#terms)+*)
            });
            code.extend(quote_spanned!(site()=> let b = [#(#entries),*];));
        }
        code
    }

    /// content · powers · Σ inner · monomial, over the denominator.
    fn value(
        &self,
        f: &PatchFunction,
        names: &[String],
        code: &mut ScalarCode,
        powers: &mut Powers,
    ) -> TokenStream {
        let mut product: Vec<TokenStream> = Vec::new();
        if !f.content.is_one() {
            product.push(number(&f.content));
        }
        match f.inner.as_slice() {
            [] => return number(&Rational::ZERO),
            [one] if one.is_one() => {}
            [one] => product.push(code.scalar(one)),
            _ => product.push(self.inner(f, names, code, powers)),
        }
        product.extend(powers.product(names, &f.powers));
        product.extend(code.reciprocal(&f.denom));
        scalar::product(product)
    }

    /// The sum: written out as long as it is short, which is faster, else by nested multiplication in a loop.
    fn inner(
        &self,
        f: &PatchFunction,
        names: &[String],
        code: &mut ScalarCode,
        powers: &mut Powers,
    ) -> TokenStream {
        let runtime = self.shell.runtime;
        let present = f.inner.iter().filter(|c| !c.is_zero()).count();
        if present > MAX_TERMS {
            let entries: Vec<TokenStream> = f.inner.mapped(|c| code.scalar(c));
            let degrees = f.inner_degrees.iter().map(|d| Literal::u32_unsuffixed(*d));
            return if self.shell.family.is_simplex() {
                quote_spanned!(site()=> #runtime::__private::simplex_sum(&[#(#entries),*], at, #(#degrees)*))
            } else {
                let units = names.chunks(2).map(|pair| {
                    let (x, s) = (Ident::new(&pair[0], site()), Ident::new(&pair[1], site()));
                    quote_spanned!(site()=> [#s, #x])
                });
                quote_spanned!(site()=> #runtime::__private::box_sum([#(#entries),*], [#(#degrees),*], [#(#units),*]))
            };
        }
        let mut sum = TokenStream::new();
        let terms = f.inner.iter().zip(exponents(&self.form.groups, &f.inner_degrees));
        for (c, e) in terms.filter(|(c, _)| !c.is_zero()) {
            let negative = c.as_constant().is_some_and(|c| c.is_negative());
            let c = if negative { -c } else { c.clone() };
            let monomial = powers.product(names, &e);
            let factor = (!c.is_one() || monomial.is_none()).then(|| code.scalar(&c));
            let term = scalar::product(factor.into_iter().chain(monomial).listed());
            sum.extend(match (sum.is_empty(), negative) {
                (true, false) => term,
                (false, false) => quote_spanned!(site()=> + #term),
                (_, true) => quote_spanned!(site()=> - #term),
            });
        }
        if present == 1 { sum } else { quote_spanned!(site()=> (#sum)) }
    }

    /// The Bernstein coefficients, one column for each function: the different ones, and which of them stands where as
    /// a string of bytes, the shortest code for a table.
    fn weights(&self) -> TokenStream {
        let runtime = self.shell.runtime;
        let mut code = self.shell.scalars();
        let mut known: SortedMap<(&Poly, &Poly), usize> = SortedMap::new();
        let mut entries: Vec<TokenStream> = Vec::new();
        let (zero, one) = (Poly::zero(), Poly::one());
        let mut places: Vec<usize> = Vec::new();
        for row in 0..self.form.coefficients() {
            for f in &self.form.functions {
                let c = &f.bernstein[row];
                let key = if c.is_zero() { (&zero, &one) } else { (c, &f.denom) };
                let place = *known.get_or_insert_with(key, || {
                    entries.push(code.quotient(key.0, key.1));
                    entries.len() - 1
                });
                places.push(place);
            }
        }
        // Two bytes for each entry when one is not enough.
        let bytes: Vec<u8> = if entries.len() <= 256 {
            places.mapped(|p| *p as u8)
        } else {
            places.iter().flat_map(|p| (*p as u16).to_le_bytes()).listed()
        };
        let (lets, bytes) = (code.lets(), Literal::byte_string(&bytes));
        let table = quote_spanned!(site()=> #runtime::__private::table(&[#(#entries),*], #bytes));
        if self.steps == 0 {
            return quote_spanned!(site()=> #lets #table);
        }
        let (len, terms) = (
            Literal::usize_unsuffixed(self.form.functions.len()),
            Literal::usize_unsuffixed(self.form.coefficients()),
        );
        let (corners, steps) =
            (Literal::usize_unsuffixed(self.corners()), Literal::u32_unsuffixed(self.steps));
        let (order, degree) = (self.lowest(), Literal::u32_unsuffixed(self.form.degrees[0]));
        quote_spanned! {site()=>
            #lets
            let table: [[S; #len]; #terms] = #table;
            #runtime::__private::raise_weights(table, #corners, [#order, #degree], #steps)
        }
    }
}

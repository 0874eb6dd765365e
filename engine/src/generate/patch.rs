//! Families on triangles, tetrahedra, boxes and products of these: values, and the table from which everything else follows.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote_spanned};

use super::code::docs;
use super::code::shell::Shell;
use super::code::tokens::{doc, number, site};
use super::formula::factored_on_box;
use super::rust::Body;
use super::{nonnegative, rounding};
use crate::claim::Claim;
use crate::diagnostic::Diagnostic;
use crate::model::{Factor, label};
use crate::plan::Input;
use crate::plan::patch::form::factored_text;
use crate::plan::patch::{PatchPlans, Table, lattice};
use crate::plural::list;
use crate::state::Verdict;
use basis_prover::collections::list::{Listed, Mapped};

/// The type of a family on a simplex, a box or a product of simplices and intervals.
///
/// # Errors
/// When the family is too large.
pub(super) fn emit(shell: &Shell<'_>, verdicts: &[(Claim, Verdict)]) -> Result<TokenStream, Diagnostic> {
    let family = shell.family;
    let Some(plans) = PatchPlans::new(family) else {
        return Err(super::too_large(family));
    };
    let emitter = Emitter { shell, plans };
    let proved = rounding::bounds(family);
    let bounds = [nonnegative::on_patch(&emitter.plans), rounding::lines(&proved, family)].concat();
    let docs = docs::family(family, &formulas(&emitter.plans), &bounds, verdicts, shell.decided);
    let constants = rounding::constants(&proved, shell.runtime);
    Ok(shell.definition(&docs, &emitter.methods(), &emitter.traits(&constants)))
}

/// The functions as products, for reading, and how they are raised.
pub(super) fn formulas(plans: &PatchPlans<'_>) -> Vec<String> {
    let PatchPlans { family, form: all, steps } = plans;
    let mut lines: Vec<String> = plans
        .functions()
        .iter()
        .zip(&all.functions)
        .map(|(f, form)| {
            let formula = if family.is_simplex() {
                factored_text(family, form, all)
            } else {
                factored_on_box(family, all, form)
            };
            format!("{} = {formula}", label(&family.function_name, &f.index))
        })
        .listed();
    if *steps > 0 {
        let letters: Vec<String> = ["i", "j", "k", "l"][..plans.corners()].mapped(ToString::to_string);
        let term = |(j, x): (usize, &str)| {
            let mut index = letters.clone();
            index[j] += "-1";
            format!("{x}*{}[{}]", family.function_name, index.join(","))
        };
        let names = family.domain_variables().map(|p| p.name.as_str());
        let terms: Vec<String> = names.enumerate().map(term).listed();
        lines.push(String::new());
        let left = format!("{}[{}]", family.function_name, letters.join(","));
        let (lowest, highest) = (plans.lowest(), plans.lowest() + steps);
        let raised = format!("from order {lowest} up to order {highest}");
        if family.written.is_empty() {
            lines.push(format!("{left} = {}, {raised}", terms.join(" + ")));
        } else {
            // The recursion stands above.
            lines.push(format!("and all others by `raise`, {raised}"));
        }
    }
    lines
}

struct Emitter<'a> {
    shell: &'a Shell<'a>,
    plans: PatchPlans<'a>,
}

impl Emitter<'_> {
    /// How many coordinates a point of the domain has.
    fn corners(&self) -> usize {
        self.plans.corners()
    }

    /// The number of functions, and of Bernstein coefficients of each.
    fn lengths(&self) -> (Literal, Literal) {
        let (functions, terms) = (self.shell.family.functions.len(), self.plans.coefficients());
        (Literal::usize_unsuffixed(functions), Literal::usize_unsuffixed(terms))
    }

    /// The methods that users call; the trait has the same for generic code.
    fn methods(&self) -> TokenStream {
        let Shell { runtime, family, .. } = self.shell;
        let simplex = family.is_simplex();
        let (len, terms) = self.lengths();
        let (k, orders) =
            (Literal::usize_unsuffixed(self.corners()), Literal::usize_unsuffixed(family.domain.len()));
        let names: Vec<&str> = family.domain_variables().map(|p| p.name.as_str()).listed();
        let own: Vec<&str> = family.domain.mapped(|p| p.name.as_str());
        let (at, independent) = (names.join(", "), own.join(", "));
        let (first, last) = (family.function_label(0), family.function_label(family.functions.len() - 1));
        let values_doc = doc(&format!("The values `[{first}, …, {last}]` at `[{at}]`."));
        let last = family
            .simplices
            .mapped(|s| format!("`{} = 1 − {}`", s.last.name, own[s.places.clone()].join(" − ")));
        let partials_doc = doc(&if last.is_empty() {
            format!("The partial derivatives of these orders in `{independent}`.")
        } else {
            let last = list(&last);
            format!("The partial derivatives of these orders in `{independent}`, with {last}.")
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

            /// The mass matrix: the integrals of products of two functions over the domain; of a simplex the reference simplex.
            #[must_use]
            pub fn mass_matrix(&self) -> [[S; #len]; #len] {
                #basis::mass_matrix(self)
            }

            /// The stiffness matrix: the integrals of products of their gradients over the domain; of a simplex the reference simplex.
            #[must_use]
            pub fn stiffness_matrix(&self) -> [[S; #len]; #len] {
                #basis::stiffness_matrix(self)
            }
        }
    }

    /// The path of the trait.
    fn basis(&self) -> TokenStream {
        let runtime = self.shell.runtime;
        if self.shell.family.is_simplex() {
            quote_spanned!(site()=> #runtime::SimplexBasis)
        } else if self.shell.family.is_product() {
            quote_spanned!(site()=> #runtime::ProductBasis)
        } else {
            quote_spanned!(site()=> #runtime::BoxBasis)
        }
    }

    fn traits(&self, rounding: &TokenStream) -> TokenStream {
        let Shell { runtime, name, family, .. } = self.shell;
        let (basis, core) = (self.basis(), self.shell.core());
        let (len, terms) = self.lengths();
        let (k, orders) =
            (Literal::usize_unsuffixed(self.corners()), Literal::usize_unsuffixed(family.domain.len()));
        let title = family.title();
        let weights = self.weights();
        let degrees: Vec<Literal> = self.plans.degrees().into_iter().map(Literal::u32_unsuffixed).listed();
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
        } else if family.is_product() {
            let factors = family.factors().into_iter().zip(&degrees).map(|(factor, degree)| match factor {
                Factor::Interval(_) => {
                    quote_spanned!(site()=> #runtime::DomainFactor::Interval { degree: #degree })
                }
                Factor::Simplex([_, _], _) => {
                    quote_spanned!(site()=> #runtime::DomainFactor::Triangle { degree: #degree })
                }
                Factor::Simplex(..) => {
                    quote_spanned!(site()=> #runtime::DomainFactor::Tetrahedron { degree: #degree })
                }
            });
            let factors = factors.listed();
            let ranges = || family.domain_variables().filter_map(|p| p.range.finite());
            let low = ranges().map(|(low, _)| number(low));
            let high = ranges().map(|(_, high)| number(high));
            quote_spanned! {site()=>
                const FACTORS: &'static [#runtime::DomainFactor] = &[#(#factors),*];

                #[inline]
                fn domain() -> [[S; #k]; 2] {
                    [[#(#low),*], [#(#high),*]]
                }
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

                #rounding

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
        let functions = self.plans.functions();
        let own = lattice(functions, 3)
            && functions.iter().zip(&self.plans.form.functions).all(|(f, form)| {
                form.inner.is_empty()
                    || f.index.iter().zip(&form.powers).all(|(i, power)| *i == 0 || *power > 0)
            });
        let degree = self.plans.degrees()[0] as usize + 1;
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

    fn values(&self) -> TokenStream {
        let simplex = self.shell.family.is_simplex();
        let x = |k: usize| Ident::new(&format!("x{k}"), site());
        let plan = self.plans.values();
        let Body { lets, outputs } = self.shell.body(&plan, &|input| match input {
            Input::Coordinate(k) if simplex => x(k).to_token_stream(),
            Input::Coordinate(k) => {
                let k = Literal::usize_unsuffixed(k);
                quote_spanned!(site()=> at[#k])
            }
            _ => TokenStream::new(),
        });
        let coordinates = simplex.then(|| {
            let all = (0..self.corners()).map(x);
            quote_spanned!(site()=> let [#(#all),*] = at;)
        });
        match outputs.as_slice() {
            [list] if self.plans.steps > 0 => quote_spanned!(site()=> #coordinates #lets #list),
            all => quote_spanned!(site()=> #coordinates #lets [#(#all),*]),
        }
    }

    /// The Bernstein coefficients, one column for each function: the different ones, and which of them stands where as
    /// a string of bytes, the shortest code for a table.
    fn weights(&self) -> TokenStream {
        let PatchPlans { form, steps, .. } = &self.plans;
        let runtime = self.shell.runtime;
        let Table { entries, places } = self.plans.table();
        let Body { lets, outputs: entries } = self.shell.body(&entries, &|_| TokenStream::new());
        // Two bytes for each entry when one is not enough.
        let bytes: Vec<u8> = if entries.len() <= 256 {
            places.mapped(|p| *p as u8)
        } else {
            places.iter().flat_map(|p| (*p as u16).to_le_bytes()).listed()
        };
        let bytes = Literal::byte_string(&bytes);
        let table = quote_spanned!(site()=> #runtime::__private::table(&[#(#entries),*], #bytes));
        if *steps == 0 {
            return quote_spanned!(site()=> #lets #table);
        }
        let (len, terms) =
            (Literal::usize_unsuffixed(form.functions.len()), Literal::usize_unsuffixed(form.coefficients()));
        let (corners, steps) = (Literal::usize_unsuffixed(self.corners()), Literal::u32_unsuffixed(*steps));
        let order = Literal::u32_unsuffixed(self.plans.lowest());
        let degree = Literal::u32_unsuffixed(form.degrees[0]);
        quote_spanned! {site()=>
            #lets
            let table: [[S; #len]; #terms] = #table;
            #runtime::__private::raise_weights(table, #corners, [#order, #degree], #steps)
        }
    }
}

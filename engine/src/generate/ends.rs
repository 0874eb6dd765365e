//! Curves that continue curves: the control points next to an end as formulas in the derivatives there, and the
//! documented methods that use them.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote_spanned};

use super::code::shell::Shell;
use super::code::tokens::{doc, site};
use super::rust::Body;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Poly;
use crate::algebra::range::Region;
use crate::continuation::EndPoints;
use crate::model::{Family, Parameter, label};
use crate::plan::Input;
use crate::plan::ends::end_points;
use crate::weights::{combination, zero, zeros};
use basis_prover::collections::list::{Listed, Mapped};

/// Derivatives up to this order are solved for by formulas.
const ORDER: u32 = 2;

/// The control points next to both ends of a curve, for the derivatives up to each order there.
pub(super) struct Ends<'a> {
    shell: &'a Shell<'a>,
    start: Vec<Solved>,
    end: Vec<Solved>,
}

/// The control points next to an end, and the polynomials in the shape values that must not be zero.
struct Solved {
    points: EndPoints,
    zeros: Vec<Poly>,
}

impl<'a> Ends<'a> {
    pub(super) fn new(shell: &'a Shell<'a>) -> Self {
        let family = shell.family;
        let range = |p: &Parameter| (p.var, p.range.clone());
        let region = Region { ranges: family.shapes.mapped(range) };
        let solved = |at_start: bool| -> Vec<Solved> {
            let points = EndPoints::up_to(family, ORDER, at_start).into_iter();
            points
                .map(|points| Solved { zeros: zeros(&points.determinant, &region, family.budget), points })
                .listed()
        };
        Self { shell, start: solved(true), end: solved(false) }
    }

    /// The methods that users call: curves that continue a curve.
    pub(super) fn methods(&self) -> TokenStream {
        let runtime = self.shell.runtime;
        let core = self.shell.core();
        let len = Literal::usize_unsuffixed(self.shell.family.functions.len());
        let method = |name: &str, at_start: bool| {
            let name = Ident::new(name, site());
            let lines = self.documentation(at_start);
            let lines = lines.iter().map(|line| doc(line));
            quote_spanned! {site()=>
                #(#lines)*
                pub fn #name<B: #runtime::Basis<Scalar = S>, P: #runtime::Point<Scalar = S>>(
                    &self,
                    curve: &#runtime::Curve<B, P>,
                    contact: #runtime::Contact<S>,
                    points: [P; #len],
                ) -> #core::result::Result<#runtime::Curve<Self, P>, #runtime::CurveError> {
                    #runtime::Basis::#name(self, curve, contact, points)
                }
            }
        };
        let (after, before) = (method("curve_after", true), method("curve_before", false));
        quote_spanned!(site()=> #after #before)
    }

    fn documentation(&self, at_start: bool) -> Vec<String> {
        let family = self.shell.family;
        let (what, which, solved) = if at_start {
            ("continues the curve P, `curve`, where that ends", "first", &self.start)
        } else {
            ("ends where the curve P, `curve`, starts", "last", &self.end)
        };
        let mut lines = vec![
            format!("The curve Q over this family that {what}, in the given contact."),
            String::new(),
            format!(
                "Its {which} control points, one more than the order of the contact, are computed from the"
            ),
            String::from("derivatives of P, a curve of any family; the others are taken from `points`."),
            String::new(),
            String::from("```text"),
            String::from("Where they meet, Q = P and"),
            String::from("    C1, C2: Q' = P', Q'' = P''"),
            String::from("    G1, G2: Q' = P'/f, Q'' = (P'' - c*Q')/f^2"),
        ];
        let mut exceptions: Vec<String> = Vec::new();
        let names = &family.names;
        let mut shown: Vec<Row<'_>> = Vec::new();
        for solved in solved {
            let rows = solved.rows();
            let order = rows.len() - 1;
            if order > 0 {
                // Points that are the same as for a lower order are not repeated, if all of them are.
                let kept = !shown.is_empty() && shown.iter().all(|row| rows.contains(row));
                let new = rows.iter().filter(|row| !(kept && shown.contains(row)));
                let also = if kept { " also" } else { "" };
                lines.extend([String::new(), format!("C{order}, G{order}{also}:")]);
                lines.extend(new.map(|row| format!("    {}", row.formula(family))));
                shown = rows;
            }
            let found = solved.zeros.iter().map(|factor| format!("`{}`", zero(factor, names)));
            exceptions.extend(found.filter(|text| !exceptions.contains(text)).listed());
        }
        lines.extend(["```", "", "# Errors", ""].map(String::from));
        let at = if exceptions.is_empty() { String::new() } else { format!(": {}", exceptions.join(", ")) };
        lines.push(format!(
            "When `f` is not positive or a number is not finite, and where the control points do not determine the \
             derivatives{at}."
        ));
        lines
    }

    /// The methods of the trait that solve for control points; none where no formula is known.
    pub(super) fn solutions(&self) -> TokenStream {
        let (start, end) = (self.solution(true), self.solution(false));
        quote_spanned!(site()=> #start #end)
    }

    fn solution(&self, at_start: bool) -> TokenStream {
        let Shell { family, runtime, .. } = self.shell;
        let (name, solved) = if at_start { ("start_points", &self.start) } else { ("end_points", &self.end) };
        if solved.is_empty() {
            return TokenStream::new();
        }
        let arms = solved.iter().map(|solved| solved.arm(self.shell));
        let core = self.shell.core();
        let len = Literal::usize_unsuffixed(family.functions.len());
        let (name, at_end) = (Ident::new(name, site()), !at_start);
        quote_spanned! {site()=>
            fn #name<P: #runtime::Point<Scalar = S>>(
                &self,
                derivatives: &[P],
                mut points: [P; #len],
            ) -> #core::result::Result<[P; #len], #runtime::CurveError> {
                match *derivatives {
                    #(#arms)*
                    _ => return #runtime::__private::end_points(self, derivatives, points, #at_end),
                }
                #core::result::Result::Ok(points)
            }
        }
    }
}

impl Solved {
    /// The determined points as combinations of the derivatives d0, d1, … and of the other points.
    fn arm(&self, shell: &Shell<'_>) -> TokenStream {
        let Shell { family, runtime, .. } = shell;
        let (positions, divisors) = (&self.points.positions, &self.zeros);
        let derivative = |k: usize| Ident::new(&format!("d{k}"), site());
        let plan = end_points(family, &self.points, divisors);
        let Body { lets, outputs } = shell.body(&plan, &|input| match input {
            Input::Derivative(k) => derivative(k).to_token_stream(),
            Input::Point(k) => {
                let k = Literal::usize_unsuffixed(k);
                quote_spanned!(site()=> points[#k])
            }
            _ => TokenStream::new(),
        });
        let (points, values) = outputs.split_at(positions.len());
        let derivatives = (0..positions.len()).map(derivative);
        let positions = positions.iter().map(|k| Literal::usize_unsuffixed(*k));
        let (title, conditions) = (family.title(), Literal::usize_unsuffixed(points.len()));
        let at = divisors.iter().map(|factor| zero(factor, &family.names));
        quote_spanned! {site()=>
            [#(#derivatives),*] => {
                #lets
                #(#runtime::__private::check_end(#title, #conditions, #at, #values)?;)*
                #(points[#positions] = #points;)*
            }
        }
    }

    fn rows(&self) -> Vec<Row<'_>> {
        let end = &self.points;
        let row = |(row, position): (usize, &usize)| {
            let weights = end.inverse[row].iter().enumerate().filter(|(_, w)| !w.is_zero());
            Row { position: *position, derivatives: weights.listed(), others: &end.others[row] }
        };
        end.positions.iter().enumerate().map(row).listed()
    }
}

/// A determined point as a combination of derivatives and of other points.
#[derive(PartialEq)]
struct Row<'a> {
    position: usize,
    derivatives: Vec<(usize, &'a Fraction)>,
    others: &'a [(usize, Fraction)],
}

impl Row<'_> {
    /// As text, such as `Q[1] = Q + 1/(2 + λ)*Q'`.
    fn formula(&self, family: &Family) -> String {
        let name = |k: usize| label("Q", &family.functions[k].index);
        let derivatives = self.derivatives.iter().map(|(k, w)| (format!("Q{}", "'".repeat(*k)), *w));
        let others = self.others.iter().map(|(k, w)| (name(*k), w));
        let terms: Vec<(String, &Fraction)> = derivatives.chain(others).listed();
        let value = combination(terms.iter().map(|(term, w)| (term.as_str(), *w)), &family.names);
        format!("{} = {value}", name(self.position))
    }
}

//! Plans as Rust code: the bodies of functions.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote_spanned};

use super::code::tokens::{number, site};
use crate::plan::{Input, Node, Plan, Ref};
use basis_prover::collections::list::Mapped;

/// What a plan needs to know about the function in which its code stands.
pub(super) struct Surroundings<'a> {
    /// The path of the runtime crate.
    pub(super) runtime: &'a TokenStream,
    /// The code of an input.
    pub(super) input: &'a dyn Fn(Input) -> TokenStream,
    /// Names that the inputs use: no local variable may have one of them.
    pub(super) taken: &'a [String],
    /// How many control points there are, when `points` is the array of all of them.
    pub(super) points: Option<usize>,
    /// The function of the runtime for polynomials in Bernstein form.
    pub(super) bernstein: &'static str,
}

/// That function for any two coordinates, and the one with smaller errors for coordinates with the sum 1.
pub(super) const BERNSTEIN: [&str; 2] = ["bernstein", "affine_bernstein"];

/// The local variables of a plan and its results.
pub(super) struct Body {
    /// `let name = …;` for each variable.
    pub(super) lets: TokenStream,
    /// The results.
    pub(super) outputs: Vec<TokenStream>,
}

/// The code of a plan.
pub(super) fn body(plan: &Plan, surroundings: &Surroundings<'_>) -> Body {
    let mut printer = Printer { plan, surroundings, names: vec![None; plan.nodes.len()] };
    let mut lets = TokenStream::new();
    for binding in &plan.lets {
        let value = printer.expression(binding.value);
        let names = binding.names.mapped(|name| printer.free(name));
        let pattern = match names.as_slice() {
            [name] => name.to_token_stream(),
            pair => quote_spanned!(site()=> [#(#pair),*]),
        };
        lets.extend(quote_spanned!(site()=> let #pattern = #value;));
        printer.names[binding.value.position()] = Some(names);
    }
    let outputs = plan.outputs.mapped(|output| printer.code(*output));
    Body { lets, outputs }
}

struct Printer<'a> {
    plan: &'a Plan,
    surroundings: &'a Surroundings<'a>,
    /// The names of the nodes that have some so far.
    names: Vec<Option<Vec<Ident>>>,
}

/// How tightly an expression holds together.
#[derive(Clone, Copy, PartialEq)]
enum Form {
    Sum,
    Product,
    Signed,
    Atom,
}

impl Printer<'_> {
    /// A name for a local variable.
    fn free(&self, name: &str) -> Ident {
        let mut name = name.to_string();
        while self.surroundings.taken.contains(&name) {
            name.push('_');
        }
        Ident::new(&name, site())
    }

    /// The name of a node, or its expression.
    fn code(&self, at: Ref) -> TokenStream {
        match self.names[at.position()].as_deref() {
            Some([name]) => name.to_token_stream(),
            _ => self.expression(at),
        }
    }

    fn codes(&self, all: &[Ref]) -> Vec<TokenStream> {
        all.mapped(|at| self.code(*at))
    }

    fn expression(&self, at: Ref) -> TokenStream {
        let Surroundings { runtime, input, points: count, .. } = self.surroundings;
        match &self.plan.nodes[at.position()] {
            Node::Input(which) => input(*which),
            Node::Number(value) => number(value),
            Node::Neg(a) => {
                // -a * b is (-a) * b, which is the same float as -(a * b).
                let a = self.within(*a, &[Form::Sum, Form::Signed]);
                quote_spanned!(site()=> -#a)
            }
            Node::Sum(a, b) => {
                let (a, b) = (self.code(*a), self.within(*b, &[Form::Sum, Form::Signed]));
                quote_spanned!(site()=> #a + #b)
            }
            Node::Difference(a, b) => {
                let (a, b) = (self.code(*a), self.within(*b, &[Form::Sum, Form::Signed]));
                quote_spanned!(site()=> #a - #b)
            }
            Node::Product(a, b) => {
                let a = self.within(*a, &[Form::Sum]);
                let b = self.within(*b, &[Form::Sum, Form::Product, Form::Signed]);
                quote_spanned!(site()=> #a * #b)
            }
            Node::Reciprocal(a) => {
                let a = self.within(*a, &[Form::Sum, Form::Product]);
                quote_spanned!(site()=> S::of(1.0) / #a)
            }
            Node::Quotient(a, b) => {
                let a = self.within(*a, &[Form::Sum]);
                let b = self.within(*b, &[Form::Sum, Form::Product, Form::Signed]);
                quote_spanned!(site()=> #a / #b)
            }
            Node::Unit { low, high, t } => {
                let (low, high, t) = (number(low), number(high), self.code(*t));
                quote_spanned!(site()=> #runtime::__private::unit([#low, #high], #t))
            }
            Node::CutOff(a) => {
                let a = self.code(*a);
                quote_spanned!(site()=> #runtime::__private::cut_off(#a))
            }
            Node::InversePowerOfTwo(a) => {
                let a = self.code(*a);
                quote_spanned!(site()=> #runtime::__private::inverse_power_of_two(#a))
            }
            Node::List(all) => {
                let all = self.codes(all);
                quote_spanned!(site()=> [#(#all),*])
            }
            Node::Part(whole, k) => match self.names[whole.position()].as_deref() {
                Some([_, _]) | None => self.element(*whole, *k),
                Some(_) => {
                    let (whole, k) = (self.code(*whole), Literal::usize_unsuffixed(*k));
                    quote_spanned!(site()=> #whole[#k])
                }
            },
            Node::Bernstein { coefficients, s, x } => {
                let (coefficients, s, x) = (self.codes(coefficients), self.code(*s), self.code(*x));
                let function = Ident::new(self.surroundings.bernstein, site());
                quote_spanned!(site()=> #runtime::__private::#function([#(#coefficients),*], #s, #x))
            }
            Node::Combine { points, weights } => {
                let weights = self.codes(weights);
                let points = if self.is_all(points, *count) {
                    quote_spanned!(site()=> points)
                } else {
                    let points = self.codes(points);
                    quote_spanned!(site()=> &[#(#points),*])
                };
                quote_spanned!(site()=> #runtime::__private::combine(#points, [#(#weights),*]))
            }
            Node::SimplexSum { coefficients, at, degree } => {
                let (coefficients, at) = (self.codes(coefficients), self.codes(at));
                let degree = Literal::u32_unsuffixed(*degree);
                quote_spanned!(site()=> #runtime::__private::simplex_sum(&[#(#coefficients),*], [#(#at),*], #degree))
            }
            Node::BoxSum { coefficients, degrees, units } => {
                let coefficients = self.codes(coefficients);
                let degrees = degrees.mapped(|d| Literal::u32_unsuffixed(*d));
                let units = units.mapped(|unit| {
                    let unit = self.codes(unit);
                    quote_spanned!(site()=> [#(#unit),*])
                });
                quote_spanned!(site()=> #runtime::__private::box_sum([#(#coefficients),*], [#(#degrees),*], [#(#units),*]))
            }
        }
    }

    /// An element of a pair with two names, or of a list without a name.
    fn element(&self, whole: Ref, k: usize) -> TokenStream {
        if let Some(name) = self.names[whole.position()].as_ref().and_then(|names| names.get(k)) {
            return name.to_token_stream();
        }
        let (whole, k) = (self.expression(whole), Literal::usize_unsuffixed(k));
        quote_spanned!(site()=> #whole[#k])
    }

    /// Whether these are all control points in their order.
    fn is_all(&self, points: &[Ref], count: Option<usize>) -> bool {
        let is = |k: usize, at: Ref| matches!(self.plan.nodes[at.position()], Node::Input(Input::Point(p)) if p == k);
        count == Some(points.len()) && (0..points.len()).all(|k| is(k, points[k]))
    }

    /// A node as a part of an expression, in parentheses if it has one of these forms.
    fn within(&self, at: Ref, apart: &[Form]) -> TokenStream {
        let code = self.code(at);
        if apart.contains(&self.form(at)) { quote_spanned!(site()=> (#code)) } else { code }
    }

    fn form(&self, at: Ref) -> Form {
        if self.names[at.position()].is_some() {
            return Form::Atom;
        }
        match &self.plan.nodes[at.position()] {
            Node::Sum(..) | Node::Difference(..) => Form::Sum,
            Node::Product(..) | Node::Reciprocal(_) | Node::Quotient(..) => Form::Product,
            Node::Neg(_) => Form::Signed,
            Node::Number(value) if value.is_negative() => Form::Signed,
            _ => Form::Atom,
        }
    }
}

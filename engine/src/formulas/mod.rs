//! The formulas of a family and of its claims as they are written, for other proof assistants: index variables are
//! replaced by their values and loops are written out, but nothing is expanded.
//!
//! The engine itself decides nothing by them. They are read from the spec a second time, by code that shares only the
//! syntax tree with the expansion in `model`; where the two read differently, what is exported is not proved.

mod claims;
mod integrals;
#[cfg(feature = "joins")]
mod points;
mod read;
mod scope;
mod spans;
mod value;

use std::rc::Rc;

pub use crate::syntax::{Comparison, Role, Sign};
pub use claims::polynomial;
#[cfg(feature = "joins")]
pub use points::{PointClaim, PointFormulas, Quantity, coordinate, coordinate_variable, of_theorem};
pub use read::of;

use crate::algebra::rational::Rational;

/// A function of an angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Circular {
    /// The sine.
    Sin,
    /// The cosine.
    Cos,
}

/// A formula.
#[derive(Clone, Debug, PartialEq)]
pub enum Term {
    /// A number.
    Number(Rational),
    /// A variable: of a definition one of its parameters by its place, or the variable of a derivative around.
    Variable(usize),
    /// −x.
    Neg(Rc<Term>),
    /// Terms with their signs, at least one; that of the first one is plus.
    Sum(Vec<(Sign, Term)>),
    /// Factors and divisors, at least one; the first one is a factor.
    Product(Vec<(Role, Term)>),
    /// The number π.
    Pi,
    /// The sine or cosine of an angle.
    Circular(Circular, Rc<Term>),
    /// A power with a whole exponent ≥ 0.
    Power(Rc<Term>, u32),
    /// The value of a definition, by its place in [`Formulas::definitions`].
    Call(usize, Vec<Term>),
    /// The derivative of a body in its variable, at a place.
    Derivative {
        /// What is differentiated.
        body: Rc<Term>,
        /// The variable of the body by which it is differentiated; it has a meaning in the body only.
        bound: usize,
        /// The value of the variable.
        at: Rc<Term>,
    },
    /// The integral of a body in its variable, between bounds.
    Integral {
        /// What is integrated.
        body: Rc<Term>,
        /// The variable of the body by which it is integrated; it has a meaning in the body only.
        bound: usize,
        /// The lower bound.
        low: Rc<Term>,
        /// The upper bound.
        high: Rc<Term>,
    },
}

impl Term {
    /// A whole number.
    pub fn integer(value: i64) -> Self {
        Self::Number(Rational::from(value))
    }

    /// Terms in place of variables, all at once.
    pub fn put(&self, by: &dyn Fn(usize) -> Option<Self>) -> Self {
        match self {
            Self::Number(_) | Self::Pi => self.clone(),
            Self::Circular(f, x) => Self::Circular(*f, Rc::new(x.put(by))),
            Self::Variable(v) => by(*v).unwrap_or_else(|| self.clone()),
            Self::Neg(x) => Self::Neg(Rc::new(x.put(by))),
            Self::Sum(parts) => Self::Sum(parts.iter().map(|(sign, x)| (*sign, x.put(by))).collect()),
            Self::Product(parts) => Self::Product(parts.iter().map(|(role, x)| (*role, x.put(by))).collect()),
            Self::Power(x, n) => Self::Power(Rc::new(x.put(by)), *n),
            Self::Call(f, args) => Self::Call(*f, args.iter().map(|x| x.put(by)).collect()),
            // Every derivative and integral has a variable of its own, so that nothing is captured.
            Self::Derivative { body, bound, at } => {
                let inner = |v: usize| if v == *bound { None } else { by(v) };
                let (body, at) = (Rc::new(body.put(&inner)), Rc::new(at.put(by)));
                Self::Derivative { body, bound: *bound, at }
            }
            Self::Integral { body, bound, low, high } => {
                let inner = |v: usize| if v == *bound { None } else { by(v) };
                let [low, high] = [low, high].map(|end| Rc::new(end.put(by)));
                Self::Integral { body: Rc::new(body.put(&inner)), bound: *bound, low, high }
            }
        }
    }

    /// x − y.
    pub fn minus(self, other: Self) -> Self {
        Self::Sum(vec![(Sign::Plus, self), (Sign::Minus, other)])
    }

    /// x·y.
    pub fn by(self, other: Self) -> Self {
        Self::Product(vec![(Role::Factor, self), (Role::Factor, other)])
    }
}

/// A function with a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Definition {
    /// The family and order that it belongs to, such as `Bernstein(3)`.
    pub family: String,
    /// What it is called there, such as `b[0]` or the name that a `let` gives.
    pub name: String,
    /// Of a family on several spans the number of the one for which it is.
    pub span: Option<usize>,
    /// The names of its parameters.
    pub parameters: Vec<String>,
    /// Its value.
    pub value: Term,
}

/// An equation or inequality, one of those that make a claim.
#[derive(Clone, Debug, PartialEq)]
pub struct Compared {
    /// The left side, in the variables of the family.
    pub left: Term,
    /// What stands between the sides.
    pub comparison: Comparison,
    /// The right side.
    pub right: Term,
    /// The number of the span on which it is said, of those of the family; 0 on a domain of one.
    pub span: usize,
}

impl Compared {
    /// A comparison on a domain of one span.
    pub(crate) fn new(left: Term, comparison: Comparison, right: Term) -> Self {
        Self { left, comparison, right, span: 0 }
    }
}

/// A claim.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Claimed {
    /// The values at which an `at` block looks, by variable.
    pub fixed: Vec<(usize, Term)>,
    /// What has to be true, in the order of [`crate::state::statements`]; nothing for independence, which is no
    /// comparison.
    pub all: Vec<Compared>,
}

/// The formulas of a family of one order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Formulas {
    /// Functions, each after those that it calls.
    pub definitions: Vec<Definition>,
    /// The definitions of the basis functions, in the order of their indices; of several spans those on the first one.
    pub functions: Vec<usize>,
    /// Of several spans the same for each of them.
    pub spans: Vec<Vec<usize>>,
    /// The claims, in the order of the item; nothing for one without a counterpart, such as total positivity.
    pub claims: Vec<Option<Claimed>>,
}

//! Expressions as they are written: the part of the syntax tree that formulas are made of.

use proc_macro2::Span;

use super::Loops;
use crate::algebra::rational::Rational;

/// An expression and where it stands.
#[derive(Clone, Debug)]
pub struct Expr {
    /// Where it stands.
    pub span: Span,
    /// What it is.
    pub kind: ExprKind,
}

impl Expr {
    /// The name that it is, perhaps with an index, which is left out.
    pub fn named(&self) -> Option<&str> {
        let base = match &self.kind {
            ExprKind::Index(base, _) => base,
            _ => self,
        };
        match &base.kind {
            ExprKind::Name(name) => Some(name),
            _ => None,
        }
    }

    /// The expressions of which it consists.
    pub fn parts(&self) -> Vec<&Self> {
        match &self.kind {
            ExprKind::Number(_) | ExprKind::Name(_) => Vec::new(),
            ExprKind::Neg(inner) | ExprKind::Each(inner, _) => vec![inner],
            ExprKind::Sum(terms) => terms.iter().map(|(_, e)| e).collect(),
            ExprKind::Product(factors) => factors.iter().map(|(_, e)| e).collect(),
            ExprKind::Power(base, exponent) => vec![base, exponent],
            ExprKind::Index(base, rest) | ExprKind::Call(base, rest) => {
                core::iter::once(&**base).chain(rest).collect()
            }
            ExprKind::List(all) | ExprKind::Tuple(all) => all.iter().collect(),
        }
    }

    /// The expression with numbers in place of index variables.
    pub fn with_indices(&self, constants: &[(String, i64)]) -> Self {
        let put = |e: &Self| e.with_indices(constants);
        let boxed = |e: &Self| Box::new(put(e));
        let all = |list: &[Self]| list.iter().map(put).collect();
        let kind = match &self.kind {
            ExprKind::Name(name) => match constants.iter().rev().find(|(n, _)| n == name) {
                Some((_, value)) => ExprKind::Number(Rational::from(*value)),
                None => ExprKind::Name(name.clone()),
            },
            ExprKind::Neg(inner) => ExprKind::Neg(boxed(inner)),
            ExprKind::Sum(terms) => ExprKind::Sum(terms.iter().map(|(sign, e)| (*sign, put(e))).collect()),
            ExprKind::Product(factors) => {
                ExprKind::Product(factors.iter().map(|(role, e)| (*role, put(e))).collect())
            }
            ExprKind::Power(base, exponent) => ExprKind::Power(boxed(base), boxed(exponent)),
            ExprKind::Index(base, rest) => ExprKind::Index(base.clone(), all(rest)),
            ExprKind::Call(base, rest) => ExprKind::Call(base.clone(), all(rest)),
            ExprKind::List(list) => ExprKind::List(all(list)),
            ExprKind::Tuple(list) => ExprKind::Tuple(all(list)),
            // Loops inside of an end of a range have index variables of their own.
            ExprKind::Number(_) | ExprKind::Each(..) => self.kind.clone(),
        };
        Self { kind, ..self.clone() }
    }

    /// The names that stand in it, but for those in loops.
    pub fn names(&self) -> Vec<&str> {
        let own = match &self.kind {
            ExprKind::Name(name) => Some(name.as_str()),
            _ => None,
        };
        own.into_iter().chain(self.parts().into_iter().flat_map(Self::names)).collect()
    }

    /// Whether one of some names stands in it.
    pub fn has_name(&self, is_one: &dyn Fn(&String) -> bool) -> bool {
        matches!(&self.kind, ExprKind::Name(name) if is_one(name))
            || self.parts().into_iter().any(|part| part.has_name(is_one))
    }
}

/// The sign in front of a term.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// `+`
    Plus,
    /// `-`
    Minus,
}

/// What a part of a product does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// It multiplies.
    Factor,
    /// It divides: it stands below the fraction line.
    Divisor,
}

/// The kinds of expressions. Sums and products are flat, so that long formulas do not nest deeply.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// An exact number.
    Number(Rational),
    /// A name.
    Name(String),
    /// −x.
    Neg(Box<Expr>),
    /// Terms with their signs; that of the first one is plus.
    Sum(Vec<(Sign, Expr)>),
    /// Factors and divisors; the first one is a factor.
    Product(Vec<(Role, Expr)>),
    /// base ^ exponent.
    Power(Box<Expr>, Box<Expr>),
    /// x[i, j].
    Index(Box<Expr>, Vec<Expr>),
    /// f(x, y).
    Call(Box<Expr>, Vec<Expr>),
    /// [x, y, z].
    List(Vec<Expr>),
    /// (x, y): a point by its coordinates.
    Tuple(Vec<Expr>),
    /// An expression for each value of index variables: the argument of `sum` and `product`, or a list.
    Each(Box<Expr>, Loops),
}

//! Inequalities between dot products, for all points of a space of any dimension.
//!
//! With coordinates, an expression is one in dot products if it is the same form in the coordinates of each axis.

use std::rc::Rc;

use basis_kernel::{Products, Relation, Statement};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::map::SortedMap;
use basis_prover::collections::sort::sort_unique;
use basis_prover::semidefinite;
use basis_prover::{Coordinate, Failure, Symmetries, decide, minor_signs};

use super::net::Net;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Monomial, Poly, PolyExt, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::theorem::Theorem;

/// A dot product: two given points, the first not after the second.
type Pair = (usize, usize);

/// The work for the sums of minors, and for points at which they are negative.
const WORK: u64 = 2_000_000;

/// A polynomial as a sum of dot products of given points, with the variables that stand for them; `None` when it is of
/// another kind, or none occurs.
fn sum(theorem: &Theorem, polynomial: &Poly) -> Option<(Poly, Products)> {
    let mut constant = Poly::zero();
    // One form for each axis; without coordinates one in all.
    let mut forms: Vec<SortedMap<Pair, Poly>> = vec![SortedMap::new(); theorem.dimension.unwrap_or(1)];
    for (monomial, coefficient) in polynomial.terms() {
        let (scalars, factors) = split(theorem, monomial);
        let term = Poly::term(scalars, coefficient.clone());
        match factors[..] {
            [] => constant = &constant + &term,
            [(axis, pair)] => {
                let sum = forms.get_mut(axis)?.get_or_insert_with(pair, Poly::zero);
                *sum = &*sum + &term;
            }
            _ => return None,
        }
    }
    let form = forms.first()?;
    if form.is_empty() || forms.iter().any(|other| other != form) {
        return None;
    }
    let mut value = constant;
    let mut products = Products::new();
    for (k, (pair, factor)) in form.iter().enumerate() {
        let var = Var(theorem.names.len() + k);
        products.push((var, *pair));
        value = &value + &(factor * &Poly::var(var));
    }
    Some((value, products))
}

/// The statement that a polynomial is ≥ 0 (> 0) as a sum of dot products; `None` when it is of another kind, or its
/// sums of minors are too much work.
pub(super) fn statement(theorem: &Theorem, polynomial: &Poly, relation: Relation) -> Option<Statement> {
    let (value, products) = sum(theorem, polynomial)?;
    let domain = theorem.scalar_domain();
    if value.variables().iter().any(|v| v.0 < theorem.names.len()) {
        minor_signs(&value, relation, &products, &mut Work::new(WORK)).ok()?;
    }
    Some(Statement::Products { value, relation, products, domain })
}

/// Values of the scalars and control points at which a sum of dot products is not as claimed.
pub(super) fn counterexample(
    theorem: &Theorem,
    statement: &Statement,
    budget: u32,
) -> Option<(Vec<(Var, Coordinate)>, Net)> {
    let Statement::Products { value, relation, products, domain } = statement else { return None };
    let mut points: Vec<usize> = products.iter().flat_map(|(_, (p, q))| [*p, *q]).listed();
    sort_unique(&mut points);
    let signs = minor_signs(value, *relation, products, &mut Work::new(WORK)).ok()?;
    for (sum, relation) in signs {
        let value = Fraction::from(sum).quotient();
        let sign = Statement::Sign { value, relation, domain: Rc::clone(domain) };
        let Err(Failure::Refuted(found)) = decide(sign, &Symmetries::new(), budget) else { continue };
        let mut at = vec![Rational::ZERO; theorem.names.len() + products.len()];
        let mut rational = true;
        for (var, c) in &found.point {
            match c {
                Coordinate::Rational(x) => at[var.0] = x.clone(),
                Coordinate::Algebraic(_) => rational = false,
            }
        }
        if !rational {
            // Where it takes irrational values of scalars, all points are at the origin.
            if relation == Relation::Positive {
                return Some((found.point, Net::on_a_line(theorem, &[])));
            }
            continue;
        }
        let constant =
            products.iter().fold(value_at_origin(statement), |p, (v, _)| p.at(*v, &Rational::ZERO));
        let constant = constant.eval(&at);
        let entry = |p: &usize, q: &usize| {
            let mut entry = Rational::ZERO;
            for (var, (a, b)) in products {
                if (a.min(b), a.max(b)) == (p.min(q), p.max(q)) {
                    let factor = value_at_origin(statement).derivative(*var).eval(&at);
                    entry += &(if p == q { factor } else { &factor * &Rational::new(1, 2) });
                }
            }
            entry
        };
        let matrix = points.mapped(|p| points.mapped(|q| entry(p, q)));
        if let Some(line) = negative(&constant, &matrix) {
            let line: Vec<(usize, Rational)> = points.iter().copied().zip(line).listed();
            return Some((found.point, Net::on_a_line(theorem, &line)));
        }
    }
    None
}

/// The polynomial of a statement about dot products.
fn value_at_origin(statement: &Statement) -> Poly {
    match statement {
        Statement::Products { value, .. } => value.clone(),
        _ => Poly::zero(),
    }
}

/// Places of the points on a line at which c + xᵀA x is not as claimed, where c or A is the reason for it.
fn negative(constant: &Rational, matrix: &[Vec<Rational>]) -> Option<Vec<Rational>> {
    let Err(direction) = semidefinite(matrix, &mut Work::new(WORK))? else {
        return Some(matrix.mapped(|_| Rational::ZERO));
    };
    let mut form = Rational::ZERO;
    for (row, x) in matrix.iter().zip(&direction) {
        for (a, y) in row.iter().zip(&direction) {
            form += &(&(a * x) * y);
        }
    }
    if !constant.is_positive() {
        return Some(direction);
    }
    // m = c/|f| + 1 times as far out m²f outweighs the constant c.
    let far = &Rational::ONE - &constant.checked_div(&form)?;
    Some(direction.mapped(|x| x * &far))
}

/// The part of a monomial in the scalars, and dot products with the axis to which they belong; coordinates that are no
/// part of a dot product stand there as several.
fn split(theorem: &Theorem, monomial: &Monomial) -> (Monomial, Vec<(usize, Pair)>) {
    let mut scalars = monomial.clone();
    let mut factors = Vec::new();
    for (var, pair) in &theorem.products {
        for _ in 0..monomial.exponent(*var) {
            factors.push((0, *pair));
        }
        scalars = scalars.with_exponent(*var, 0);
    }
    let mut single: Vec<(usize, usize)> = Vec::new();
    for (number, point) in theorem.points.iter().enumerate() {
        for (axis, var) in point.coordinates.iter().enumerate() {
            for _ in 0..monomial.exponent(*var) {
                single.push((axis, number));
            }
            scalars = scalars.with_exponent(*var, 0);
        }
    }
    match single[..] {
        [] => {}
        [(axis, p), (other, q)] if axis == other => factors.push((axis, (p.min(q), p.max(q)))),
        // Not a dot product: more than one factor is refused.
        _ => factors.extend([(0, (0, 0)), (0, (0, 0))]),
    }
    (scalars, factors)
}

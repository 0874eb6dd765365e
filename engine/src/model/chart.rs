//! Ranges that depend on other parameters, and what `assume` says, as images of boxes.
//!
//! A parameter x between bounds L and U that hold the parameters before it is L + (U − L)·s with s from 0 to 1, and what is
//! said of all its values is said of all s. Of several bounds each is the greatest lower, or the least upper one, on a
//! part of the values: the set is the union of these parts. That a lower bound is below an upper one is a condition on the
//! parameters before it, so that parameters are eliminated from the last to the first (Fourier and Motzkin).

use basis_kernel::{Domain, Relation};
use basis_prover::{Coordinate, value_at};

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::range::{End, Range, Region};
use crate::algebra::rational::Rational;
use basis_prover::algebra::number::square_root;
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::sort::sort_by;

/// What is assumed of the parameters: a polynomial has a sign.
#[derive(Clone, Debug, PartialEq)]
pub struct Constraint {
    /// The polynomial.
    pub value: Poly,
    /// Whether it is ≥ 0 or > 0.
    pub relation: Relation,
    /// The condition as it is written, such as `q < p`.
    pub text: String,
    /// Whether it is an end of the declared range of an angle, whose tangent is irrational.
    pub is_end: bool,
}

/// A part of the values as the image of a box, whose variables have the names of those that they stand for.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Piece {
    /// Variables as polynomials in themselves, as variables of the box, and in those before them.
    pub steps: Vec<(Var, Poly)>,
    /// The box.
    pub ranges: Vec<(Var, Range)>,
    /// Polynomials in the parameters themselves that have the sign stated; what could not be made part of the box.
    pub premises: Vec<(Poly, Relation)>,
}

impl Piece {
    /// A box as it is.
    pub fn plain(ranges: Vec<(Var, Range)>) -> Self {
        Self { ranges, ..Self::default() }
    }

    /// A polynomial in the parameters as one in the variables of the box; `None` when that has too many terms.
    pub fn pull_back(&self, p: &Poly) -> Option<Poly> {
        let mut result = p.clone();
        for (var, by) in self.steps.iter().rev() {
            let terms =
                |(m, _): (&Monomial, &Rational)| (by.len() as u64).saturating_pow(m.exponent(*var).into());
            if result.terms().map(terms).fold(0, u64::saturating_add) > MAX_TERMS {
                return None;
            }
            result = result.substitute(*var, by);
        }
        Some(result)
    }

    /// A quotient in the same way; in lowest terms or not, so that it is 0/0 nowhere where it was not.
    pub fn pull_back_fraction(&self, f: &Fraction) -> Option<basis_kernel::Quotient> {
        let mut quotient = f.quotient();
        if !self.steps.is_empty() {
            quotient.numerator = self.pull_back(&quotient.numerator)?;
            quotient.denominator = self.pull_back(&quotient.denominator)?;
        }
        Some(quotient)
    }

    /// The box, and what has to be true of its points to count.
    pub fn domain(&self) -> Domain {
        let mut domain = Domain::of(Region { ranges: self.ranges.clone() });
        // Pieces are made so that no premise has too many terms.
        let premise = |(p, relation): &(Poly, Relation)| self.pull_back(p).map(|p| (p, *relation));
        domain.premises = self.premises.iter().filter_map(premise).listed();
        domain
    }

    /// The point of the set that is the image of a point of the box; variables of which it is not known are left out.
    pub fn image(&self, point: &[(Var, Coordinate)]) -> Vec<(Var, Coordinate)> {
        let is_step = |var: Var| self.steps.iter().any(|(v, _)| *v == var);
        let mut image = point.iter().filter(|(var, _)| !is_step(*var)).cloned().listed();
        let rational = |point: &[(Var, Coordinate)], var: Var| {
            point.iter().find(|(v, _)| *v == var).and_then(|(_, c)| match c {
                Coordinate::Rational(x) => Some(x.clone()),
                Coordinate::Algebraic(_) => None,
            })
        };
        for (var, by) in &self.steps {
            // A step holds its own variable, as one of the box, and images of variables before it.
            let put = |p: Poly, v: Var| match rational(if v == *var { point } else { &image }, v) {
                Some(x) => p.at(v, &x),
                None => p,
            };
            let value = by.variables().into_iter().fold(by.clone(), put).as_constant();
            let value = value.map(Coordinate::Rational);
            let value = value.or_else(|| value_at(&self.pull_back(&Poly::var(*var))?, point));
            image.extend(value.map(|x| (*var, x)));
        }
        image
    }

    /// Whether the image of every point of the box is a point of the set.
    pub const fn is_exact(&self) -> bool {
        self.premises.is_empty()
    }
}

/// The most conditions on the values of the parameters of a family, or of the scalars of a theorem.
pub(crate) const MAX_CONDITIONS: usize = 300;

/// More parts than this are not made: what they would be made for stays a premise.
const MAX_PIECES: usize = 24;

/// Nor are more choices of bounds tried to find them.
const MAX_CHOICES: usize = 2_000;

/// Beyond this many terms for one variable the variables are eliminated in the other order as well.
const MANY_TERMS: usize = 64;

/// No polynomial in the variables of a box has more terms.
const MAX_TERMS: u64 = 20_000;

/// A bound of a variable, and whether it is left out.
#[derive(Clone, PartialEq)]
struct Bound {
    at: Poly,
    strict: bool,
}

/// A set that is defined by constraints, while its variables are eliminated.
struct Elimination<'a> {
    vars: Vec<(Var, &'a Range)>,
    /// What is found, together with the number of variables that are left to eliminate.
    pieces: Vec<Piece>,
    choices: usize,
    too_many: bool,
}

/// The parts of the points of a box at which all constraints hold; none if there are no such points. Variables that are
/// listed first depend on none that come later.
pub fn pieces(vars: &[(Var, Range)], constraints: &[(Poly, Relation)]) -> Vec<Piece> {
    let point = |range: &Range| range.finite().is_some_and(|(a, b)| a == b);
    if constraints.is_empty() && !vars.iter().any(|(_, range)| point(range)) {
        return vec![Piece::plain(vars.to_vec())];
    }
    let order = vars.iter().map(|(var, range)| (*var, range)).listed();
    let forward = in_order(order.clone(), constraints);
    if let Some(pieces) = forward.as_ref().filter(|pieces| are_short(pieces, vars)) {
        return pieces.clone();
    }
    // Of h₀ ≤ h₁ ≤ … ≤ 1 the last one is 1 − ∏(1 − yₖ) if it comes last, and y if it comes first, those before it
    // being products.
    let backward = in_order(order.into_iter().rev().listed(), constraints);
    let backward = backward.filter(|pieces| forward.is_none() || are_short(pieces, vars));
    let plain = || vec![Piece { premises: constraints.to_vec(), ..Piece::plain(vars.to_vec()) }];
    let mut best = backward.or(forward).unwrap_or_else(plain);
    for piece in &mut best {
        let place = |var: Var| vars.iter().position(|(v, _)| *v == var);
        sort_by(&mut piece.ranges, |(a, _), (b, _)| place(*a).cmp(&place(*b)));
    }
    best
}

/// The parts as they are found if the variables are eliminated from the last one to the first; `None` when there are too many.
fn in_order(vars: Vec<(Var, &Range)>, constraints: &[(Poly, Relation)]) -> Option<Vec<Piece>> {
    let mut all = Elimination { vars, pieces: Vec::new(), choices: 0, too_many: false };
    all.eliminate(all.vars.len(), constraints.to_vec(), Piece::default());
    let said = |piece: &Piece| piece.premises.iter().all(|(p, _)| piece.pull_back(p).is_some());
    (!all.too_many && all.pieces.iter().all(said)).then_some(all.pieces)
}

/// Whether the polynomials that stand for the variables have few terms.
fn are_short(pieces: &[Piece], vars: &[(Var, Range)]) -> bool {
    // A variable doubles the terms of those after it at most.
    if vars.len() <= 6 {
        return true;
    }
    let short =
        |piece: &Piece, var: Var| piece.pull_back(&Poly::var(var)).is_some_and(|p| p.len() <= MANY_TERMS);
    pieces.iter().all(|piece| vars.iter().all(|(var, _)| short(piece, *var)))
}

/// Linear conditions in place of one of the second degree in one variable alone that says a range with rational ends, such
/// as `3*x - 2 - x^2 >= 0`, or a single value, or none; any other condition as it is.
fn as_bounds((p, relation): (Poly, Relation)) -> Vec<(Poly, Relation)> {
    let bounds = || {
        let [var] = p.variables()[..] else { return None };
        let coefficients = p.coefficients_in(var);
        let [c, b, a] = &coefficients.iter().map(Poly::as_constant).collect::<Option<Vec<_>>>()?[..] else {
            return None;
        };
        if !a.is_negative() {
            return None;
        }
        let discriminant = &(b * b) - &(&Rational::from(4) * &(a * c));
        if discriminant.is_negative() {
            return Some(vec![(Poly::constant(Rational::from(-1)), relation)]);
        }
        let root = square_root(&discriminant)?;
        let scale = (&Rational::from(2) * a).recip()?;
        let x = Poly::var(var);
        let end = |root: &Rational| Poly::constant(&(root - b) * &scale);
        // The slope 2·a·x + b is √D at the lower end.
        Some(vec![(&x - &end(&root), relation), (&end(&-&root) - &x, relation)])
    };
    bounds().unwrap_or_else(|| vec![(p, relation)])
}

impl Elimination<'_> {
    /// Eliminates the first `count` variables, the last of them first; `done` is what is known of those after them.
    fn eliminate(&mut self, count: usize, constraints: Vec<(Poly, Relation)>, mut done: Piece) {
        self.choices += 1 + constraints.len() / 8;
        self.too_many |= self.choices > MAX_CHOICES;
        let mut open = Vec::new();
        for (p, relation) in constraints.into_iter().flat_map(as_bounds) {
            match p.as_constant() {
                Some(c) if !relation.holds(&c) => return,
                Some(_) => {}
                None if open.iter().any(|(q, r)| *q == p && *r == relation) => {}
                None => open.push((p, relation)),
            }
        }
        let Some(last) = count.checked_sub(1) else {
            // What is left holds variables of no range.
            done.premises.extend(open);
            done.steps.reverse();
            done.ranges.reverse();
            self.too_many |= self.pieces.len() >= MAX_PIECES;
            if !self.too_many {
                self.pieces.push(done);
            }
            return;
        };
        let (var, range) = self.vars[last];
        let end = |end: &End| {
            end.value().map(|x| Bound { at: Poly::constant(x.clone()), strict: !end.is_included() })
        };
        let mut lows: Vec<Bound> = end(&range.low).into_iter().listed();
        let mut highs: Vec<Bound> = end(&range.high).into_iter().listed();
        let mut rest = Vec::new();
        for (p, relation) in open {
            let slope = p.derivative(var);
            match slope.as_constant() {
                _ if !p.depends_on(var) => rest.push((p, relation)),
                Some(slope) => {
                    let factor = slope.recip().unwrap_or(Rational::ONE);
                    let at = -&p.at(var, &Rational::ZERO).scale(&factor);
                    let bound = Bound { at, strict: relation == Relation::Positive };
                    if slope.is_negative() { highs.push(bound) } else { lows.push(bound) }
                }
                None if is_plain(&p, relation, &self.vars) => {}
                None => done.premises.push((p, relation)),
            }
        }
        let (lows, highs) =
            (extreme(lows, false, &self.vars[..last]), extreme(highs, true, &self.vars[..last]));
        for low in 0..lows.len().max(1) {
            for high in 0..highs.len().max(1) {
                if self.too_many {
                    return;
                }
                let mut constraints = rest.clone();
                for (bounds, own, sign) in [(&lows, low, 1), (&highs, high, -1)] {
                    let Some(chosen) = bounds.get(own) else { continue };
                    for other in bounds.iter().filter(|other| *other != chosen) {
                        // Where both are the same, the one that is left out counts.
                        let relation = if other.strict && !chosen.strict {
                            Relation::Positive
                        } else {
                            Relation::NonNegative
                        };
                        let distance = (&chosen.at - &other.at).scale(&Rational::from(sign));
                        constraints.push((distance, relation));
                    }
                }
                let mut piece = done.clone();
                let box_range = match (lows.get(low), highs.get(high)) {
                    (Some(low), Some(high)) => {
                        let strict = low.strict || high.strict;
                        let relation = if strict { Relation::Positive } else { Relation::NonNegative };
                        constraints.push((&high.at - &low.at, relation));
                        let (a, b) = (low.at.as_constant(), high.at.as_constant());
                        match (a, b) {
                            (Some(a), Some(b)) if a == b => {
                                piece.steps.push((var, low.at.clone()));
                                Range::closed(a, b)
                            }
                            (Some(a), Some(b)) => {
                                Range { low: end_at(a, low.strict), high: end_at(b, high.strict) }
                            }
                            _ => {
                                let by = &low.at + &(&(&high.at - &low.at) * &Poly::var(var));
                                piece.steps.push((var, by));
                                Range {
                                    low: end_at(Rational::ZERO, low.strict),
                                    high: end_at(Rational::ONE, high.strict),
                                }
                            }
                        }
                    }
                    (Some(low), None) => match low.at.as_constant() {
                        Some(a) => Range { low: end_at(a, low.strict), high: End::Infinite },
                        None => {
                            piece.steps.push((var, &low.at + &Poly::var(var)));
                            Range { low: end_at(Rational::ZERO, low.strict), high: End::Infinite }
                        }
                    },
                    (None, Some(high)) => match high.at.as_constant() {
                        Some(b) => Range { low: End::Infinite, high: end_at(b, high.strict) },
                        None => {
                            piece.steps.push((var, &high.at - &Poly::var(var)));
                            Range { low: end_at(Rational::ZERO, high.strict), high: End::Infinite }
                        }
                    },
                    (None, None) => Range::all(),
                };
                piece.ranges.push((var, box_range));
                self.eliminate(last, constraints, piece);
            }
        }
    }
}

fn end_at(value: Rational, strict: bool) -> End {
    if strict { End::Excluded(value) } else { End::Included(value) }
}

/// The bounds of which each can be the extreme one: of those that are numbers one is left, and none that another one is
/// beyond for all values of some variables.
fn extreme(bounds: Vec<Bound>, least: bool, vars: &[(Var, &Range)]) -> Vec<Bound> {
    let mut all: Vec<Bound> = Vec::new();
    let mut number: Option<(Rational, bool)> = None;
    for bound in bounds {
        match bound.at.as_constant() {
            Some(x) => {
                number = Some(match number {
                    Some((y, strict)) if x == y => (x, strict || bound.strict),
                    Some((y, strict)) if (y > x) != least => (y, strict),
                    _ => (x, bound.strict),
                });
            }
            None => match all.iter_mut().find(|known| known.at == bound.at) {
                Some(known) => known.strict |= bound.strict,
                None => all.push(bound),
            },
        }
    }
    all.extend(number.map(|(x, strict)| Bound { at: Poly::constant(x), strict }));
    let beyond = |a: &Bound, b: &Bound| {
        let distance = if least { &a.at - &b.at } else { &b.at - &a.at };
        smallest(&distance, vars)
            .is_some_and(|(x, open)| x.is_positive() || x.is_zero() && (open || b.strict || !a.strict))
    };
    let mut k = all.len();
    while k > 0 {
        k -= 1;
        if all.iter().enumerate().any(|(other, bound)| other != k && beyond(&all[k], bound)) {
            all.remove(k);
        }
    }
    all
}

/// The number that a polynomial of degree 1 is not below on a box, and whether it stays above it; `None` of any other one, or
/// where the box has no end.
fn smallest(p: &Poly, vars: &[(Var, &Range)]) -> Option<(Rational, bool)> {
    let (mut sum, mut open) = (Rational::ZERO, false);
    for (m, c) in p.terms() {
        if m.total_degree() == 0 {
            sum = &sum + c;
            continue;
        }
        if m.total_degree() > 1 {
            return None;
        }
        let (_, range) = vars.iter().find(|(var, _)| m.exponent(*var) == 1)?;
        let end = if c.is_negative() { &range.high } else { &range.low };
        sum = &sum + &(c * end.value()?);
        open |= !end.is_included();
    }
    Some((sum, open))
}

/// Whether a polynomial has its sign at a glance: no term is negative on the box.
fn is_plain(p: &Poly, relation: Relation, vars: &[(Var, &Range)]) -> bool {
    let nonnegative = |var: Var| {
        let range = vars.iter().find(|(v, _)| *v == var).map(|(_, range)| *range);
        range.is_some_and(|range| range.low.value().is_some_and(|x| !x.is_negative()))
    };
    let term = |m: &Monomial, c: &Rational| {
        !c.is_negative()
            && p.variables().into_iter().all(|v| m.exponent(v).is_multiple_of(2) || nonnegative(v))
    };
    relation == Relation::NonNegative && p.terms().all(|(m, c)| term(m, c))
}

/// The texts of constraints.
pub fn texts(constraints: &[Constraint]) -> Vec<String> {
    constraints.mapped(|c| c.text.clone())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::poly::PolyExt as _;

    fn x(k: usize) -> Poly {
        Poly::var(Var(k))
    }

    fn holds(piece: &Piece, point: &[Rational]) -> bool {
        // Whether a point is the image of one of the box: each variable solved for its own step.
        let mut values: Vec<(Var, Rational)> = Vec::new();
        for (var, range) in &piece.ranges {
            let step = piece.steps.iter().find(|(v, _)| v == var);
            let value = point[var.0].clone();
            let inner = match step {
                None => Some(value.clone()),
                Some((_, by)) => {
                    let by = values.iter().fold(by.clone(), |p, (v, x)| p.at(*v, x));
                    let at = by.at(*var, &Rational::ZERO).as_constant().expect("a number");
                    let slope = by.derivative(*var).as_constant().expect("a number");
                    match slope.recip() {
                        Some(factor) => Some(&(&value - &at) * &factor),
                        None if at == value => range.low.value().cloned().or(range.high.value().cloned()),
                        None => None,
                    }
                }
            };
            let fits = inner.is_some_and(|s| {
                range.contains(&s)
                    || piece.steps.iter().any(|(v, by)| {
                        v == var && {
                            let by = values.iter().fold(by.clone(), |p, (v, x)| p.at(*v, x));
                            by.derivative(*var).is_zero()
                        }
                    })
            });
            if !fits {
                return false;
            }
            values.push((*var, value));
        }
        true
    }

    /// The pieces together have the points of the set, and no others.
    fn check(vars: &[(Var, Range)], constraints: &[(Poly, Relation)], grid: &[(i64, i64)]) -> usize {
        let all = pieces(vars, constraints);
        assert!(all.iter().all(Piece::is_exact));
        let mut points = vec![Vec::new()];
        for _ in vars {
            points = points
                .into_iter()
                .flat_map(|p: Vec<Rational>| {
                    grid.iter().map(move |(n, d)| [p.as_slice(), &[Rational::new(*n, *d)]].concat())
                })
                .collect();
        }
        for point in points {
            let inside = vars.iter().all(|(v, r)| r.contains(&point[v.0]))
                && constraints.iter().all(|(p, r)| r.holds(&p.eval(&point)));
            assert_eq!(all.iter().any(|piece| holds(piece, &point)), inside, "{point:?} {all:?}");
        }
        all.len()
    }

    #[test]
    fn sets_are_unions_of_images_of_boxes() {
        let grid = [(-1, 1), (-1, 2), (0, 1), (1, 4), (1, 2), (3, 4), (1, 1), (3, 2), (2, 1)];
        let closed = |a: i64, b: i64| Range::closed(Rational::from(a), Rational::from(b));
        let one = Poly::one();
        // q < p in (0, 1].
        let half_open = Range { low: End::Excluded(Rational::ZERO), high: End::Included(Rational::ONE) };
        let vars = [(Var(0), half_open.clone()), (Var(1), half_open)];
        assert_eq!(check(&vars, &[(&x(1) - &x(0), Relation::Positive)], &grid), 1);
        // 0 ≤ μ ≤ λ, λ from −1.
        let vars = [(Var(0), closed(-1, 1)), (Var(1), Range::all())];
        assert_eq!(
            check(&vars, &[(x(1), Relation::NonNegative), (&x(0) - &x(1), Relation::NonNegative)], &grid),
            1
        );
        // 1/2 ≤ x + y ≤ 3/2 in the unit square: a hexagon.
        let half = Poly::constant(Rational::new(1, 2));
        let sum = &x(0) + &x(1);
        let band = [(&sum - &half, Relation::NonNegative), (&(&one + &half) - &sum, Relation::NonNegative)];
        let vars = [(Var(0), closed(0, 1)), (Var(1), closed(0, 1))];
        assert!(check(&vars, &band, &grid) >= 2);
        // |x| + |y| < 1, and z between them.
        let vars = [(Var(0), closed(-1, 1)), (Var(1), closed(-1, 1)), (Var(2), Range::all())];
        let mut all = Vec::new();
        for (a, b) in [(1, 1), (1, -1), (-1, 1), (-1, -1)] {
            let p = &(&one - &x(0).scale(&Rational::from(a))) - &x(1).scale(&Rational::from(b));
            all.push((p, Relation::Positive));
        }
        all.push((&x(2) - &x(0), Relation::NonNegative));
        all.push((&x(1) - &x(2), Relation::Positive));
        assert!(check(&vars, &all, &grid) >= 1);
    }

    #[test]
    fn an_empty_set_has_no_pieces() {
        let vars = [(Var(0), Range::unit()), (Var(1), Range::unit())];
        let sum = &(&x(0) + &x(1)) - &Poly::integer(3);
        assert_eq!(pieces(&vars, &[(sum.clone(), Relation::NonNegative)]), []);
        let equal = [(&x(0) - &x(1), Relation::Positive), (&x(1) - &x(0), Relation::NonNegative)];
        assert_eq!(pieces(&vars, &equal), []);
        // A disk is left as a premise.
        let disk = &Poly::one() - &(&(&x(0) * &x(0)) + &(&x(1) * &x(1)));
        assert_eq!(pieces(&vars, &[(disk, Relation::NonNegative)])[0].premises.len(), 1);
    }
}

//! Inequalities between dot products: c + Σ mᵢⱼ pᵢ·pⱼ is nonnegative for all points pᵢ, in a space of any dimension, exactly
//! where c ≥ 0 and the symmetric matrix of the mᵢⱼ is positive semidefinite. With all points at the origin the value is c, and
//! far out on one line it is a multiple of a value of the form in numbers. c > 0 makes it positive, and is needed.
//!
//! A symmetric matrix is positive semidefinite exactly if all elementary symmetric functions of its eigenvalues are nonnegative,
//! which are the sums of its principal minors of one size: polynomials in the scalars, as many as there are points.

use super::gram::Gram;
use super::net::{Net, on_net};
use super::theorem::{coordinates, counterexample};
use super::{Evidence, Step, StepProof, Verdict};
use crate::algebra::fraction::Fraction;
use crate::algebra::gcd::checked_product;
use crate::algebra::matrix::Rows;

use crate::algebra::poly::{Monomial, Poly};
use crate::algebra::range::Region;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::collections::list::Mapped;
use crate::collections::map::SortedMap;
use crate::collections::sort::sort_unique;
use crate::decide::{self, Budget, Coordinate, Decision, Relation};
use crate::model::theorem::{Theorem, TheoremClaim};

/// A dot product: two given points, the first not after the second.
type Pair = (usize, usize);

/// The work for the sums of minors.
const WORK: u64 = 2_000_000;

/// A scalar and a quadratic form in points.
pub(super) struct Quadratic {
    /// The given points that occur.
    points: Vec<usize>,
    /// The symmetric matrix, by the places of the points in that list.
    matrix: Rows<Poly>,
    /// The value with all points at the origin.
    constant: Poly,
    /// The sums of the principal minors of one size, those of size 1 first, without the last ones that are zero.
    minors: Vec<Poly>,
}

impl Quadratic {
    /// `None` when the polynomial is of another kind, or the minors are too much work.
    pub(super) fn new(theorem: &Theorem, polynomial: &Poly) -> Option<Self> {
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
        let mut points: Vec<usize> = form.keys().flat_map(|(p, q)| [*p, *q]).collect();
        sort_unique(&mut points);
        let entry = |p: &usize, q: &usize| {
            let value = form.get(&(*p.min(q), *p.max(q))).cloned().unwrap_or_else(Poly::zero);
            if p == q { value } else { value.scale(&Rational::new(1, 2)) }
        };
        let matrix = points.mapped(|p| points.mapped(|q| entry(p, q)));
        let minors = minors(&matrix, &mut Work::new(WORK))?;
        Some(Self { points, matrix, constant, minors })
    }

    /// What has to be shown.
    pub(super) fn statements(&self, of: &str, relation: Relation) -> Vec<(String, Poly, Relation)> {
        let mut all = Vec::new();
        if relation == Relation::Positive || !self.constant.is_zero() {
            all.push((format!("{of} with all points at the origin"), self.constant.clone(), relation));
        }
        for (k, sum) in self.minors.iter().enumerate().filter(|(_, sum)| !sum.is_zero()) {
            let size = k + 1;
            let of = format!("the principal {size} × {size} minors of {of}, summed");
            all.push((of, sum.clone(), Relation::NonNegative));
        }
        all
    }

    /// Decides the inequality; `value` is what is compared with zero, which has the sign of the form, or the other one.
    pub(super) fn decide(
        &self,
        theorem: &Theorem,
        claim: &TheoremClaim,
        relation: Relation,
        value: &Fraction,
    ) -> Verdict {
        let of = claim.difference.as_str();
        let region = scalars(theorem);
        let (mut steps, mut methods, mut open) = (Vec::new(), Vec::new(), None);
        for (of_step, polynomial, needed) in self.statements(of, relation) {
            match decide::decide(&polynomial, needed, &region, &mut Budget::scaled(theorem.budget)) {
                Decision::Proved(proof) => {
                    let method = proof.method.to_string();
                    if !methods.contains(&method) {
                        methods.push(method);
                    }
                    steps.push(Step { of: of_step, proof: StepProof::Sign(proof) });
                }
                Decision::Refuted(witness) => {
                    // Where it takes irrational values of scalars, all points are at the origin.
                    let rational = witness.point.iter().all(|(_, c)| matches!(c, Coordinate::Rational(_)));
                    let net = (rational || needed == Relation::Positive)
                        .then(|| self.net(theorem, relation, &witness));
                    if let Some(net) = net.flatten() {
                        return counterexample(theorem, claim, &net, &on_net(theorem, value, &net), &witness);
                    }
                    open = Some(format!("`{of_step}` is negative, but at irrational points only"));
                }
                Decision::Undecided(left) => open = Some(format!("`{of_step}`: {left}")),
            }
        }
        let method = format!("a positive semidefinite matrix ({})", methods.join(", "));
        open.map_or(Verdict::Proved(Evidence { method, steps }), Verdict::Undecided)
    }

    /// Control points with which the inequality fails where the scalars have the values of a witness for one of the statements.
    fn net(&self, theorem: &Theorem, relation: Relation, witness: &decide::Witness) -> Option<Net> {
        if witness.point.iter().any(|(_, c)| matches!(c, Coordinate::Algebraic(_))) {
            return Some(Net::on_a_line(theorem, &[]));
        }
        let at = coordinates(theorem, &witness.point);
        let matrix = self.matrix.mapped(|row| row.mapped(|p| p.eval(&at)));
        let gram = Gram::new(self.constant.eval(&at), self.points.clone(), matrix);
        let line = gram.decide(relation).err()?;
        Some(Net::on_a_line(theorem, &line))
    }
}

/// The scalars of a theorem with their ranges.
pub(super) fn scalars(theorem: &Theorem) -> Region {
    Region { ranges: theorem.scalars.mapped(|p| (p.var, p.range.clone())) }
}

/// The part of a monomial in the scalars, and dot products with the axis to which they belong; coordinates that are no part of
/// a dot product stand there as several.
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

/// The sums of the principal minors of each size of a symmetric matrix A, by Faddeev and LeVerrier: with N₀ = I,
/// eₖ = tr(A Nₖ₋₁)/k and Nₖ = eₖ I - A Nₖ₋₁. `None` when the work is spent.
fn minors(matrix: &Rows<Poly>, work: &mut Work) -> Option<Vec<Poly>> {
    let size = matrix.len();
    let mut product = matrix.clone();
    let mut sums = Vec::new();
    for k in 1..=size {
        if product.iter().flatten().all(Poly::is_zero) {
            break;
        }
        let trace = (0..size).fold(Poly::zero(), |sum, i| &sum + &product[i][i]);
        let sum = trace.scale(&Rational::new(1, k as i64));
        let mut next = vec![vec![Poly::zero(); size]; size];
        for (i, row) in next.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry = checked_product(&matrix[i][j], &sum, work)?;
                for (a, b) in matrix[i].iter().zip(&product) {
                    *entry = &*entry - &checked_product(a, &b[j], work)?;
                }
            }
        }
        sums.push(sum);
        product = next;
    }
    Some(sums)
}

//! Step 3: the factors of a square-free decomposition, each decided for itself.

use super::outcome::{Outcome, Prove};
use super::problem::{Point, Problem, as_rational, rational, value};
use super::{univariate, witness};
use crate::algebra::divisors::gcd::{square_free, square_root};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::budget::Budget;
use crate::collections::list::Listed;
use crate::method::Method;
use basis_kernel::{FactorSign, Relation, SignProof, Signed};

/// Decides by the signs of the factors; `None` when the polynomial has no factors that are worth it, and when the
/// factors alone do not give a counterexample.
///
/// Complete as far as the parts are: on a box, a product with one sign is a product of polynomials that have one
/// sign each, apart from even powers.
pub(super) fn by_factors(
    problem: &Problem,
    relation: Relation,
    budget: &mut Budget,
    prove: Prove,
) -> Option<Outcome> {
    if relation == Relation::NonNegative {
        let positive = problem.poly.leading_term()?.1.is_positive();
        let root = square_root(&problem.poly.normalized(), &mut budget.work);
        if let Some(root) = root.filter(|_| positive) {
            // Whatever the factors of the root are.
            let factors = vec![(root, FactorSign::Any)];
            let rest = Box::new(Signed::Positive(SignProof::direct()));
            return Some(Outcome::Proved(Method::Factors, SignProof::Factors { factors, rest }));
        }
    }
    let parts = square_free(&problem.poly, &mut budget.work)?;
    if parts.len() == 1 && parts[0].1 == 1 {
        return None;
    }
    let number = lead_quotient(&problem.poly, &parts)?;
    let mut hardest = Method::Factors;
    let mut factors: Vec<(Poly, u32, FactorSign)> = Vec::new();
    let mut sign = number.signum();
    for (base, exponent) in parts {
        if relation == Relation::NonNegative && exponent % 2 == 0 {
            factors.push((base, exponent, FactorSign::Any));
            continue;
        }
        let part = problem.with(base.clone());
        let sample = part.nonzero_point(&base)?;
        let negative = value(&base, &sample).is_negative();
        let part = problem.with(if negative { -&base } else { base.clone() });
        if negative && exponent % 2 == 1 {
            sign = -sign;
        }
        match prove(&part, relation, budget) {
            Outcome::Proved(method, proof) => {
                hardest = hardest.max(method);
                let signed = if negative { Signed::Negative(proof) } else { Signed::Positive(proof) };
                factors.push((base, exponent, FactorSign::Known(Box::new(signed))));
            }
            Outcome::Refuted(point) => return changed_sign(problem, relation, &part, sample, point, budget),
            unknown @ Outcome::Unknown(_) => return Some(unknown),
        }
    }
    if sign < 0 {
        // Negative wherever it is not zero.
        let point = problem.nonzero_point(&problem.poly)?;
        return Some(Outcome::Refuted(rational(point)));
    }
    // The longest factor is what is left after division by the others, and need not be written.
    let length = |(base, exponent, sign): &(Poly, u32, FactorSign)| match sign {
        FactorSign::Known(_) if *exponent == 1 => base.len(),
        _ => 0,
    };
    let longest =
        (0..factors.len()).max_by_key(|k| length(&factors[*k])).filter(|k| length(&factors[*k]) > 0);
    let rest = match longest.map(|k| factors.remove(k)) {
        Some((_, _, FactorSign::Known(signed))) if number.is_negative() => match *signed {
            Signed::Positive(proof) => Signed::Negative(proof),
            Signed::Negative(proof) => Signed::Positive(proof),
        },
        Some((_, _, FactorSign::Known(signed))) => *signed,
        _ if number.is_negative() => Signed::Negative(SignProof::direct()),
        _ => Signed::Positive(SignProof::direct()),
    };
    let factors = factors.into_iter().map(|(base, _, sign)| (base, sign)).listed();
    Some(Outcome::Proved(hardest, SignProof::Factors { factors, rest: Box::new(rest) }))
}

/// The number c with p = c·∏ fᵉ: leading terms multiply.
fn lead_quotient(p: &Poly, parts: &[(Poly, u32)]) -> Option<Rational> {
    let mut number = p.leading_term()?.1.clone();
    for (f, e) in parts {
        number = number.checked_div(&f.leading_term()?.1.pow(*e))?;
    }
    Some(number)
}

/// A counterexample from a factor that is positive at a point and not as claimed at another.
fn changed_sign(
    problem: &Problem,
    relation: Relation,
    part: &Problem,
    sample: Vec<(Var, Rational)>,
    point: Point,
    budget: &mut Budget,
) -> Option<Outcome> {
    let Some(bad) = as_rational(&point) else {
        // An irrational point is a zero of the factor.
        return (relation == Relation::Positive).then(|| Outcome::Refuted(problem.complete(point)));
    };
    let full = |p: Vec<(Var, Rational)>| as_rational(&problem.complete(rational(p)));
    for p in [bad.clone(), sample.clone()] {
        let p = full(p)?;
        if witness::violates(problem, relation, &p) {
            return Some(Outcome::Refuted(rational(p)));
        }
    }
    if relation == Relation::NonNegative {
        return None;
    }
    // On the way from one point to the other along the axes the factor vanishes, and with it the product.
    let mut at = sample;
    for (var, to) in bad {
        let k = at.iter().position(|(v, _)| *v == var)?;
        let from = core::mem::replace(&mut at[k].1, to.clone());
        if !value(&part.poly, &at).is_positive() {
            let mut edge = part.poly.clone();
            for (v, x) in at.iter().filter(|(v, _)| *v != var) {
                edge = edge.at(*v, x);
            }
            let range = if from < to { Range::closed(from, to) } else { Range::closed(to, from) };
            let edge = Problem { poly: edge, ranges: vec![(var, range)] };
            let zero = univariate::some_zero(&edge, &mut budget.work)?;
            let mut point = rational(at);
            point[k].1 = zero;
            return Some(Outcome::Refuted(problem.complete(point)));
        }
    }
    None
}

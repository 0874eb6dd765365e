//! Projections of sets of polynomials, for cylindrical decompositions.

use crate::algebra::divisors::gcd::{checked_gcd, content, leading_coefficient, square_free};
use crate::algebra::divisors::resultant::{discriminant, resultant};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::real::roots::{Root, isolate};
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;
use crate::collections::list::Listed;
use crate::collections::sort::sort_by;

/// A sequence of projections.
#[derive(Clone, Debug)]
pub(crate) struct Levels {
    /// The variables from the lowest level to the highest.
    pub(crate) order: Vec<Var>,
    /// By level square-free polynomials without common factors, in the variable of the level and lower ones.
    pub(crate) sets: Vec<Vec<Poly>>,
}

/// Projects polynomials down to one variable, `base` if it is given; `None` when the work is spent.
///
/// With `trailing` the projections contain the trailing coefficients too, so that by Lazard's theorem the polynomials
/// are invariant not only over open cells.
pub(crate) fn levels(
    polys: &[Poly],
    ranges: &[(Var, Range)],
    base: Option<Var>,
    trailing: bool,
    work: &mut Work,
) -> Option<Levels> {
    let mut left = ranges.to_vec();
    let mut current = basis(polys, work)?;
    let (mut order, mut sets) = (Vec::new(), Vec::new());
    while left.len() > 1 {
        // A low degree makes few and small resultants.
        let degree = |v: Var| current.iter().map(|p| p.degree(v)).max().unwrap_or(0);
        let choices = (0..left.len()).filter(|k| Some(left[*k].0) != base);
        let (var, range) = left.remove(choices.min_by_key(|k| (degree(left[*k].0), core::cmp::Reverse(*k)))?);
        let (mut set, mut below) = (Vec::new(), Vec::new());
        for p in current {
            if !p.depends_on(var) {
                below.push(p);
                continue;
            }
            let lower = content(&p, var, work)?;
            let mut rest = if lower.as_constant().is_some() { p } else { p.div_exact(&lower)?.normalized() };
            below.push(lower);
            // A factor that is zero at an end of the range would make the restriction to it zero.
            for end in [&range.low, &range.high] {
                let Some(x) = end.value() else { continue };
                if rest.at(var, x).is_zero() {
                    let linear = (&Poly::var(var) - &Poly::constant(x.clone())).normalized();
                    rest = rest.div_exact(&linear)?.normalized();
                    set.push(linear);
                }
            }
            if rest.depends_on(var) {
                set.push(rest);
            } else {
                below.push(rest);
            }
        }
        below.extend(project(&set, var, &range, trailing, work)?);
        current = basis(&below, work)?;
        order.push(var);
        sets.push(set);
    }
    order.push(left.first()?.0);
    sets.push(current);
    order.reverse();
    sets.reverse();
    Some(Levels { order, sets })
}

/// The leading coefficients, discriminants, resultants of pairs and restrictions to the ends of the range.
fn project(set: &[Poly], var: Var, range: &Range, trailing: bool, work: &mut Work) -> Option<Vec<Poly>> {
    let mut result = Vec::new();
    for (k, p) in set.iter().enumerate() {
        result.push(leading_coefficient(p, var));
        if trailing {
            result.push(p.at(var, &Rational::ZERO));
        }
        for end in [&range.low, &range.high] {
            if let Some(x) = end.value() {
                result.push(p.at(var, x));
            }
        }
        if p.degree(var) > 1 {
            result.push(discriminant(p, var, work)?);
        }
        for q in &set[k + 1..] {
            result.push(resultant(p, q, var, work)?);
        }
    }
    // Zero is only the value of a linear polynomial at its own root.
    result.retain(|p| p.as_constant().is_none());
    Some(result)
}

/// Square-free polynomials without common factors that have the same zeros.
pub(crate) fn basis(polys: &[Poly], work: &mut Work) -> Option<Vec<Poly>> {
    let mut result: Vec<Poly> = Vec::new();
    for p in polys {
        let mut waiting: Vec<Poly> = square_free(p, work)?.into_iter().map(|(f, _)| f).listed();
        while let Some(mut f) = waiting.pop() {
            if result.contains(&f) {
                continue;
            }
            let mut k = 0;
            while k < result.len() && f.as_constant().is_none() {
                let common = checked_gcd(&f, &result[k], work)?;
                if common.as_constant().is_none() {
                    // The known one splits; of f only the rest is new.
                    let rest = result[k].div_exact(&common)?.normalized();
                    f = f.div_exact(&common)?.normalized();
                    result[k] = common;
                    if rest.as_constant().is_none() {
                        result.push(rest);
                    }
                }
                k += 1;
            }
            if f.as_constant().is_none() {
                result.push(f);
            }
        }
    }
    sort_by(&mut result, |a, b| (a.total_degree(), a.len(), a).cmp(&(b.total_degree(), b.len(), b)));
    Some(result)
}

/// The roots of several polynomials without common roots in an open interval, in increasing order; with each the
/// index of its polynomial. The intervals of roots of different polynomials do not touch.
pub(crate) fn all_roots(polys: &[Univariate], range: &Range, work: &mut Work) -> Option<Vec<(usize, Root)>> {
    let mut roots = Vec::new();
    for (k, p) in polys.iter().enumerate() {
        let found = isolate(p, range.low.value(), range.high.value(), work)?;
        roots.extend(found.into_iter().map(|root| (k, root)));
    }
    loop {
        sort_by(&mut roots, |(_, a), (_, b)| (a.low(), a.high()).cmp(&(b.low(), b.high())));
        let mut apart = true;
        for k in 1..roots.len() {
            let (left, right) = roots.split_at_mut(k);
            let (Some((i, a)), Some((j, b))) = (left.last_mut(), right.first_mut()) else { continue };
            if a.high() > b.low() || i != j && a.high() == b.low() {
                apart = false;
                a.refine(&polys[*i], work)?;
                b.refine(&polys[*j], work)?;
            }
        }
        if apart {
            return Some(roots);
        }
    }
}

/// The polynomials of a level in its variable, constants left out; `None` if another variable is left.
pub(crate) fn univariates(set: &[Poly], var: Var) -> Option<Vec<Univariate>> {
    let all: Option<Vec<Univariate>> = set.iter().map(|p| Univariate::from_poly(p, var)).collect();
    Some(all?.into_iter().filter(|p| !p.is_constant()).map(|p| p.primitive()).listed())
}

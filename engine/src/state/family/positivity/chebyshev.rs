//! Total positivity of functions that are no quotients of polynomials, such as those of the span of 1, t, sin t and cos t.
//!
//! **Theorem.** On [a, b] let b[i], i = 0, …, n, vanish i times at a, with a derivative of order i that is > 0, and n − i times at b.
//! Let E₀ be their span, wₖ > 0 on [a, b] a function of Eₖ, and Eₖ₊₁ the derivatives of f/wₖ for all f of Eₖ, k = 0, …, n. Then all
//! minors of the functions are ≥ 0.
//!
//! *Proof.* From Eₖ to Eₖ₊₁ the multiples of wₖ are lost, so that those of wₙ are all of Eₙ. By Rolle's theorem a function of E₀ with
//! n + 1 zeros in [a, b], each counted as often as the function vanishes there, gives one of E₁ with n zeros, …, and one of Eₙ with
//! one: only 0 has one. A combination of b[i], …, b[i + k] that vanishes k + 1 times inside would have n + 1 zeros with those at
//! a and b. So the Wronskian of these functions has no zero inside, and next to a it is > 0: it begins there with the product of
//! their first derivatives that do not vanish, times a Vandermonde determinant of i, …, i + k. As all Wronskians of neighbouring
//! functions are > 0, so are those of all functions in ascending order (M. Fekete), and all minors at points inside (S. Karlin, "Total
//! Positivity", 1968, chapter 2). At the ends it follows by continuity.
//!
//! Other functions are combinations of such ones, b = A·c, and the minors of a product are sums of products of minors: A is to be
//! totally nonnegative, as in `minors`.
//!
//! The zeros are found exactly. For wₖ the number 1 is taken where it is in Eₖ, otherwise a sum of functions that vanish at a and b as
//! the b[i] do, only less often.

use basis_prover::collections::list::Listed;

use super::minors::elimination;
use crate::algebra::fraction::Fraction;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::claim::Comparison;
use crate::model::Family;

/// Derivatives of higher order at the ends are not looked at.
const MAX_FUNCTIONS: usize = 7;

/// What is left to decide where there is no proof; minors of such functions are not looked at.
pub(in crate::state::family) const OPEN: &str = "no functions of the span were found that vanish at the ends as Bernstein polynomials do, of which these are made by a totally \
     nonnegative matrix, nor could the Wronskians of neighbouring functions be shown to be positive";

/// Whether a variable or a shape parameter stands beside its sine or exponential in a function.
pub(in crate::state::family) fn is_mixed(family: &Family) -> bool {
    family.functions.iter().any(|f| family.analytic.beside(&f.value).next().is_some())
}

/// What is enough for all minors to be ≥ 0, each with its name; `None` where no functions of the span vanish at the ends as the
/// theorem has it, or the work is spent.
pub(in crate::state::family) fn conditions(
    family: &Family,
    work: &mut Work,
) -> Option<Vec<(String, Fraction, Comparison)>> {
    let last = family.functions.len().checked_sub(1).filter(|last| *last < MAX_FUNCTIONS)?;
    let [low, _] = family.end_texts()?;
    let mut ends = [Vec::new(), Vec::new()];
    for f in &family.functions {
        for (upper, end) in [false, true].into_iter().zip(&mut ends) {
            end.push(family.derivatives_at_end(&f.value, last as u32, upper, work)?);
        }
    }
    let [first, second] = &ends;
    let vanishes = |i: usize| {
        first[i][..i].iter().all(Fraction::is_zero) && second[i][..last - i].iter().all(Fraction::is_zero)
    };
    let mut all = Vec::new();
    let mut space = Vec::new();
    if (0..=last).all(vanishes) {
        for (i, f) in family.functions.iter().enumerate() {
            let of = format!("D({}, {i}) at {low}", family.function_label(i));
            all.push((of, first[i][i].clone(), Comparison::Greater));
            space.push(f.value.clone());
        }
    } else {
        let mut jets = Vec::new();
        for k in 0..=last {
            let (f, jet) = vanishing(family, k, [first, second], work)?;
            space.push(f);
            jets.push(jet);
        }
        let steps = elimination(conversion(family, first, &jets, work)?, work)?;
        for (k, step) in steps.into_iter().enumerate() {
            let of = format!("step {} of the elimination", k + 1);
            all.push((of, step, Comparison::GreaterEqual));
        }
    }
    for k in 0..=last {
        let (weight, next) = reduced(family, space, work)?;
        if let Some(weight) = weight {
            all.push((format!("weight {k}"), weight, Comparison::Greater));
        }
        space = next;
    }
    Some(all)
}

/// The combination of all functions that vanishes k times at the lower end, as often as the theorem has it at the upper one, and
/// with 1 as its derivative of order k; with its derivatives at the lower end. `None` where there is not just one.
fn vanishing(
    family: &Family,
    k: usize,
    [first, second]: [&Vec<Vec<Fraction>>; 2],
    work: &mut Work,
) -> Option<(Fraction, Vec<Fraction>)> {
    let column = |end: &Vec<Vec<Fraction>>, order: usize, value: Fraction| {
        end.iter().map(|jet| jet[order].clone()).chain([value]).listed()
    };
    let zero = Fraction::zero;
    let mut rows = (0..k).map(|order| column(first, order, zero())).listed();
    rows.extend((0..first.len() - 1 - k).map(|order| column(second, order, zero())));
    rows.push(column(first, k, Fraction::constant(Rational::ONE)));
    let numbers = solution(family, rows, work)?;
    let combined = |values: &[Fraction], work: &mut Work| {
        let mut sum = Fraction::zero();
        for (x, f) in numbers.iter().zip(values) {
            sum = sum.add_within(&x.mul_within(f, work)?, work)?;
        }
        Some(family.analytic.reduced(sum))
    };
    let values = family.functions.iter().map(|f| f.value.clone()).listed();
    let f = combined(&values, work)?;
    let mut jet = Vec::new();
    for order in 0..first.len() {
        let column = first.iter().map(|jet| jet[order].clone()).listed();
        jet.push(combined(&column, work)?);
    }
    Some((f, jet))
}

/// The solution of linear equations, with the right sides in the last column; `None` where there is not just one.
fn solution(family: &Family, mut rows: Vec<Vec<Fraction>>, work: &mut Work) -> Option<Vec<Fraction>> {
    for k in 0..rows.len() {
        let pivot = (k..rows.len()).find(|r| !rows[*r][k].is_zero())?;
        rows.swap(k, pivot);
        let per = rows[k][k].clone();
        for x in &mut rows[k][k..] {
            *x = family.analytic.reduced(x.div_within(&per, work).ok()??);
        }
        let own = rows[k].clone();
        for (r, row) in rows.iter_mut().enumerate() {
            let factor = row[k].clone();
            if r == k || factor.is_zero() {
                continue;
            }
            for (x, y) in row[k..].iter_mut().zip(&own[k..]) {
                *x = family.analytic.reduced(x.sub_within(&factor.mul_within(y, work)?, work)?);
            }
        }
    }
    Some(rows.into_iter().filter_map(|mut row| row.pop()).listed())
}

/// The functions, by rows, in terms of those that vanish at the ends, from the derivatives of both at the lower end.
fn conversion(
    family: &Family,
    first: &[Vec<Fraction>],
    jets: &[Vec<Fraction>],
    work: &mut Work,
) -> Option<Vec<Vec<Fraction>>> {
    let mut rows = Vec::new();
    for jet in first {
        let mut row: Vec<Fraction> = Vec::new();
        for (k, value) in jet.iter().enumerate() {
            let mut rest = value.clone();
            for (x, other) in row.iter().zip(jets) {
                rest = rest.sub_within(&x.mul_within(&other[k], work)?, work)?;
            }
            row.push(family.analytic.reduced(rest));
        }
        rows.push(row);
    }
    Some(rows)
}

/// A function of a space that is to be > 0, unless it is 1, and the derivatives of the quotients by it. The functions that span the
/// space vanish at the lower end 0, 1, … times; so do those that are left.
fn reduced(
    family: &Family,
    space: Vec<Fraction>,
    work: &mut Work,
) -> Option<(Option<Fraction>, Vec<Fraction>)> {
    let (var, ..) = family.interval()?;
    let one = Fraction::constant(Rational::ONE);
    let sum = |parts: &[Fraction], work: &mut Work| {
        let total = parts.iter().try_fold(Fraction::zero(), |sum, f| sum.add_within(f, work))?;
        Some(family.analytic.reduced(total))
    };
    let (mut parts, mut weight) = (space, None);
    if sum(&parts, work)? != one {
        let mut functions = Vec::new();
        for (k, f) in parts.iter().enumerate() {
            let first = family.derivatives_at_end(f, k as u32, false, work)?.pop()?;
            functions.push(family.analytic.reduced(f.div_within(&first, work).ok()??));
        }
        let ones = multiples(family, &functions, work)?;
        parts = if sum(&ones, work)? == one {
            ones
        } else {
            weight = Some(sum(&functions, work)?);
            functions
        };
    }
    let mut next = Vec::new();
    for k in 1..parts.len() {
        let mut rest = sum(&parts[k..], work)?;
        if let Some(weight) = &weight {
            rest = rest.div_within(weight, work).ok()??;
        }
        next.push(family.analytic.reduced(family.derivative_within(&rest, var, work)?));
    }
    Some((weight, next))
}

/// Multiples of functions that vanish 0, 1, … times at the lower end: their sum has the derivatives of 1 there.
fn multiples(family: &Family, functions: &[Fraction], work: &mut Work) -> Option<Vec<Fraction>> {
    let order = functions.len().checked_sub(1)? as u32;
    let mut all: Vec<Fraction> = Vec::new();
    // What is left of the derivatives of 1.
    let mut left = vec![Fraction::zero(); functions.len()];
    left[0] = Fraction::constant(Rational::ONE);
    for (k, f) in functions.iter().enumerate() {
        let own = family.derivatives_at_end(f, order, false, work)?;
        let factor = family.analytic.reduced(left[k].div_within(&own[k], work).ok()??);
        for (left, own) in left.iter_mut().zip(&own) {
            *left = left.sub_within(&own.mul_within(&factor, work)?, work)?;
        }
        all.push(family.analytic.reduced(f.mul_within(&factor, work)?));
    }
    Some(all)
}

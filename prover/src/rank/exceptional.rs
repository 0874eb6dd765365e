//! The parameter values at which functions become dependent.

use basis_kernel::Values;

use super::cut::Cut;
use super::exception::{Exception, Generic, dependent, generic};
use super::independent::{Independence, independent};
use super::irrational::{Irrational, irrational};
use super::table::{Table, at, complete};
use crate::algebra::matrix::{nonzero_minors, vanishing_combination};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::real::roots::isolate;
use crate::algebra::univariate::{ToPoly, Univariate};
use crate::algebra::work::Work;
use crate::budget::Budget;
use crate::collections::list::{Listed, Mapped};
use crate::collections::sort::{sort_by, sort_unique};
use crate::coordinate::Coordinate;
use crate::sign::problem::as_rational;
use crate::sign::univariate;

/// The exceptional set of functions on a region: where they are dependent.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ExceptionalSet {
    /// Values of parameters at which the functions are dependent, the parameters that are not mentioned being free.
    pub exceptions: Vec<Exceptional>,
    /// What is left to decide, in words; `None` when the list is complete.
    pub open: Option<String>,
}

/// Values at which functions are dependent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exceptional {
    /// The values; none when the functions are dependent everywhere.
    pub values: Vec<(Var, Coordinate)>,
    /// Polynomials cᵢ in the free parameters, without common factor, with Σ cᵢ fᵢ = 0; `None` at an irrational value.
    pub combination: Option<Vec<Poly>>,
}

/// The most exceptions that are looked for.
const MAX_EXCEPTIONS: usize = 24;

/// Finds the points of a region, with `factor` times the usual work, at which the rows of a matrix are dependent: the
/// real zeros that all maximal minors have in common.
///
/// Complete for one parameter; for several as long as the zeros are flats on which some of them have fixed rational
/// values, else `open` says what is left.
pub fn exceptional_set(table: Table<'_>, region: &Region, factor: u32) -> ExceptionalSet {
    let budget = &mut Budget::scaled(factor);
    let rows = table.rows;
    let region = complete(rows, region);
    let mut set = ExceptionalSet::default();
    if region.ranges.iter().any(|(_, r)| r.is_empty()) {
        return set;
    }
    match generic(rows, &region, &mut budget.work) {
        Some(Generic::Independent(_)) => {}
        Some(Generic::Dependent(combination)) => {
            set.exceptions.push(Exceptional { values: Vec::new(), combination: Some(combination) });
            return set;
        }
        None => {
            set.open = Some(String::from("the budget is spent on the rank of the coefficients"));
            return set;
        }
    }
    let mut parameters: Vec<Var> = rows.iter().flatten().flat_map(Poly::variables).listed();
    sort_unique(&mut parameters);
    match &parameters[..] {
        [] => {}
        [only] => {
            if one_parameter(table, *only, &region, budget, &mut set.exceptions).is_none() {
                set.open =
                    Some(String::from("the budget is spent on the zeros of a minor of the coefficients"));
            }
        }
        _ => several_parameters(table, &region, factor, &mut set),
    }
    set
}

/// The zeros of one minor are finitely many: each is tested. `None` when the work is spent.
fn one_parameter(
    table: Table<'_>,
    var: Var,
    region: &Region,
    budget: &mut Budget,
    found: &mut Vec<Exceptional>,
) -> Option<()> {
    let rows = table.rows;
    let range = region.range(var);
    for point in candidates(table, var, &range, &mut budget.work)? {
        let combination = match &point {
            Coordinate::Rational(x) => {
                match vanishing_combination(&at(rows, &[(var, x.clone())]), &mut budget.work).ok()? {
                    Some(c) => Some(c.into_iter().map(Poly::constant).listed()),
                    None => continue,
                }
            }
            Coordinate::Algebraic(_) => match irrational(rows, &[(var, point.clone())], &mut budget.work)? {
                Irrational::Independent(_) => continue,
                Irrational::Dependent => None,
            },
        };
        found.push(Exceptional { values: vec![(var, point)], combination });
    }
    let key = |e: &Exceptional| match &e.values[0].1 {
        Coordinate::Rational(x) => x.clone(),
        Coordinate::Algebraic(x) => x.low().clone(),
    };
    sort_by(found, |a, b| key(a).cmp(&key(b)));
    Some(())
}

/// The values in a range at which a minor vanishes, each once: rows that are dependent are so at one of them.
fn candidates(table: Table<'_>, var: Var, range: &Range, work: &mut Work) -> Option<Vec<Coordinate>> {
    // The product of one minor of each block is a minor of the whole, or a combination of minors.
    let of_blocks = Cut::new(table.rows, table.symmetries).and_then(|cut| {
        let first =
            |rows: &[Vec<Poly>], work: &mut Work| Some(nonzero_minors(rows, work)?.into_iter().next()?.value);
        cut.blocks.iter().map(|b| first(&cut.block(b), work)).collect::<Option<Vec<Poly>>>()
    });
    let minors = match of_blocks {
        Some(minors) => minors,
        None => vec![nonzero_minors(table.rows, work)?.into_iter().next()?.value],
    };
    let mut product = Univariate::new(vec![Rational::ONE]);
    for minor in minors {
        let minor = Univariate::from_poly(&minor, var)?;
        if !minor.is_constant() {
            let minor = minor.square_free_part(work)?;
            let both = &product.to_poly(var) * &minor.to_poly(var);
            product = Univariate::from_poly(&both, var)?.square_free_part(work)?;
        }
    }
    let mut points: Vec<Coordinate> = Vec::new();
    if product.is_constant() {
        return Some(points);
    }
    let mut ends: Vec<&Rational> = [range.low.value(), range.high.value()].into_iter().flatten().listed();
    ends.dedup();
    let zero = |x: &&&Rational| range.contains(x) && product.sign_at(x) == 0;
    points.extend(ends.iter().filter(zero).map(|x| Coordinate::Rational((*x).clone())));
    for mut root in isolate(&product, range.low.value(), range.high.value(), work)? {
        root.detect_rational(&product, work)?;
        points.push(univariate::coordinate(&product, &root, work)?);
    }
    Some(points)
}

/// Takes a flat out of the region for each dependence that is found, until independence is proved.
fn several_parameters(table: Table<'_>, region: &Region, budget: u32, set: &mut ExceptionalSet) {
    let mut flats: Vec<Values> = Vec::new();
    while flats.len() < MAX_EXCEPTIONS {
        let point = match independent(table, &flats, region, budget) {
            Independence::Proved(_) => {
                sort_by(&mut flats, Ord::cmp);
                return;
            }
            Independence::Undecided(left) => {
                set.open = Some(left);
                return;
            }
            Independence::Dependent(point) => point,
            Independence::NoException(..) => {
                set.open = Some(String::from("there may be other exceptions"));
                return;
            }
        };
        let Some(exact) = as_rational(&point) else {
            set.exceptions.push(Exceptional { values: point, combination: None });
            set.open =
                Some(String::from("there is a dependence at irrational values, and there may be others"));
            return;
        };
        let (flat, combination) = largest_flat(table, &exact, region, &mut Budget::scaled(budget));
        let values = flat.mapped(|(v, x)| (*v, Coordinate::Rational(x.clone())));
        set.exceptions.push(Exceptional { values, combination });
        flats.push(flat);
    }
    set.open = Some(String::from("there are many exceptions, and there may be others"));
}

/// As few of the coordinates of a point as make the functions dependent.
fn largest_flat(
    table: Table<'_>,
    point: &Values,
    region: &Region,
    budget: &mut Budget,
) -> (Values, Option<Vec<Poly>>) {
    let n = point.len().min(8);
    for size in 1..=n {
        // The subsets of the first coordinates, as bits.
        for subset in (1_u32..1 << n).filter(|s| s.count_ones() as usize == size) {
            let flat: Values = (0..n).filter(|k| subset >> k & 1 == 1).map(|k| point[k].clone()).listed();
            if let Exception::Dependent(combination) = dependent(table, &flat, region, budget) {
                return (flat, Some(combination));
            }
        }
    }
    (point.clone(), None)
}

//! The parameter values at which functions become dependent.

use super::budget::Budget;
use super::independence::{
    Exception, Independence, Irrational, Values, at, complete, dependent, independent, irrational,
};
use super::problem::as_rational;
use super::{Coordinate, univariate};
use crate::algebra::matrix::{nonzero_minors, polynomial_combination, vanishing_combination};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Region};
use crate::algebra::roots::isolate;
use crate::algebra::univariate::Univariate;
use crate::sorting::{sort_by, sort_unique};

/// The exceptional set of functions on a region: where they are dependent.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ExceptionalSet {
    /// Values of parameters at which the functions are dependent, the parameters that are not mentioned being free.
    pub exceptions: Vec<Exceptional>,
    /// What is left to decide, for people; `None` when the list is complete.
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

/// Finds the points of a region at which the rows of a matrix are dependent: the real zeros that all maximal minors have
/// in common.
///
/// Complete for one parameter; for several as long as the zeros are flats on which some of them have fixed rational
/// values, else `open` says what is left.
pub fn exceptional_set(rows: &[Vec<Poly>], region: &Region, budget: &mut Budget) -> ExceptionalSet {
    let region = complete(rows, region);
    let mut set = ExceptionalSet::default();
    if region.ranges.iter().any(|(_, r)| r.is_empty()) {
        return set;
    }
    let Some(combination) = polynomial_combination(rows, &mut budget.work) else {
        set.open = Some(String::from("the budget is spent on the rank of the coefficients"));
        return set;
    };
    if !combination.is_empty() {
        set.exceptions.push(Exceptional { values: Vec::new(), combination: Some(combination) });
        return set;
    }
    let mut parameters: Vec<Var> = rows.iter().flatten().flat_map(Poly::variables).collect();
    sort_unique(&mut parameters);
    match &parameters[..] {
        [] => {}
        [only] => {
            if one_parameter(rows, *only, &region, budget, &mut set.exceptions).is_none() {
                set.open =
                    Some(String::from("the budget is spent on the zeros of a minor of the coefficients"));
            }
        }
        _ => several_parameters(rows, &region, budget, &mut set),
    }
    set
}

/// The zeros of one minor are finitely many: each is tested. `None` when the work is spent.
fn one_parameter(
    rows: &[Vec<Poly>],
    var: Var,
    region: &Region,
    budget: &mut Budget,
    found: &mut Vec<Exceptional>,
) -> Option<()> {
    let minor = nonzero_minors(rows, &mut budget.work)?.into_iter().next()?;
    let minor = Univariate::from_poly(&minor.value, var)?;
    let range = region.range(var);
    let mut points: Vec<Coordinate> = Vec::new();
    let mut push_end = |end: &End| {
        if let Some(x) = end.value().filter(|x| range.contains(x) && minor.sign_at(x) == 0) {
            points.push(Coordinate::Rational(x.clone()));
        }
    };
    push_end(&range.low);
    if range.low != range.high {
        push_end(&range.high);
    }
    if !minor.is_constant() {
        let square_free = minor.square_free_part(&mut budget.work)?;
        for mut root in isolate(&square_free, range.low.value(), range.high.value(), &mut budget.work)? {
            root.detect_rational(&square_free, &mut budget.work)?;
            points.push(univariate::coordinate(&square_free, &root, &mut budget.work)?);
        }
    }
    for point in points {
        let combination = match &point {
            Coordinate::Rational(x) => match vanishing_combination(&at(rows, &[(var, x.clone())])) {
                Some(c) => Some(c.into_iter().map(Poly::constant).collect()),
                None => continue,
            },
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

/// Takes a flat out of the region for each dependence that is found, until independence is proved.
fn several_parameters(rows: &[Vec<Poly>], region: &Region, budget: &mut Budget, set: &mut ExceptionalSet) {
    let mut flats: Vec<Values> = Vec::new();
    while flats.len() < MAX_EXCEPTIONS {
        let point = match independent(rows, &flats, region, budget) {
            Independence::Proved(_) => {
                sort_by(&mut flats, Ord::cmp);
                return;
            }
            Independence::Undecided(left) => {
                set.open = Some(left);
                return;
            }
            Independence::Refuted(dependence) => dependence.point,
        };
        let Some(exact) = as_rational(&point) else {
            set.exceptions.push(Exceptional { values: point, combination: None });
            set.open =
                Some(String::from("there is a dependence at irrational values, and there may be others"));
            return;
        };
        let (flat, combination) = largest_flat(rows, &exact, region, budget);
        let values = flat.iter().map(|(v, x)| (*v, Coordinate::Rational(x.clone()))).collect();
        set.exceptions.push(Exceptional { values, combination });
        flats.push(flat);
    }
    set.open = Some(String::from("there are many exceptions, and there may be others"));
}

/// As few of the coordinates of a point as make the functions dependent.
fn largest_flat(
    rows: &[Vec<Poly>],
    point: &Values,
    region: &Region,
    budget: &mut Budget,
) -> (Values, Option<Vec<Poly>>) {
    let n = point.len().min(8);
    for size in 1..=n {
        // The subsets of the first coordinates, as bits.
        for subset in (1_u32..1 << n).filter(|s| s.count_ones() as usize == size) {
            let flat: Values = (0..n).filter(|k| subset >> k & 1 == 1).map(|k| point[k].clone()).collect();
            if let Exception::Dependent(combination) = dependent(rows, &flat, region, budget) {
                return (flat, Some(combination));
            }
        }
    }
    (point.clone(), None)
}

//! Linear independence: the rank of the coefficient table and the shape values at which it drops.
//!
//! The functions are dependent at a shape value exactly where the sum of the squares of all maximal minors of their
//! coefficient table vanishes. Elimination with constant pivots first leaves of the table what really depends on shape
//! values, usually one row.

use std::collections::BTreeMap;

use super::{Evidence, Step, StepProof, Verdict, Witness, named_point, point};
use crate::algebra::elimination::{Reduced, dependency, determinant, gram_determinant, reduce};
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::range::{End, Range, Region};
use crate::algebra::rational::{Rational, binomial};
use crate::algebra::work::Work;
use crate::decide::{self, Budget, Coordinate, Decision, Relation};
use crate::model::Family;

/// The work that elimination and determinants may take, in products of terms, for a budget of 1.
const WORK: u64 = 400_000;

/// Why functions are independent for all shape values in a region.
#[derive(Clone, Debug)]
pub struct RankProof {
    /// The region.
    pub region: Region,
    /// Rows, columns and values of pivots that vanish nowhere in the region; together with the rest they show full rank.
    pub pivots: Vec<(usize, usize, Poly)>,
    /// The sum of the squares of the maximal minors of what elimination leaves.
    pub minors: Poly,
    /// Why that sum is positive in the region.
    pub positive: decide::Proof,
}

/// Independence on the declared ranges except for the listed shape values; at each of these the functions must be
/// dependent.
pub(super) fn independent(family: &Family, except: &[Vec<(Var, Rational)>]) -> Verdict {
    let table = coefficient_table(family);
    for values in except {
        if let Some(verdict) = contradicted(family, &table, values) {
            return verdict;
        }
    }
    let mut steps = Vec::new();
    let mut undecided = None;
    for region in pieces(&family.shape_region(), except) {
        match on_region(family, &table, &region) {
            Rank::Full(proof) => {
                steps.push(Step { of: String::from("rank"), proof: StepProof::Independence(proof) });
            }
            Rank::Deficient(point) => return Verdict::Refuted(dependent_at(family, &table, &point)),
            Rank::Undecided(left) => undecided = undecided.or(Some(left)),
        }
    }
    match undecided {
        Some(left) => Verdict::Undecided(left),
        None => Verdict::Proved(Evidence { method: String::from("minors"), steps }),
    }
}

/// The rank of the coefficient table on a region.
enum Rank {
    Full(RankProof),
    Deficient(Vec<(Var, Coordinate)>),
    Undecided(String),
}

fn on_region(family: &Family, table: &[Vec<Poly>], region: &Region) -> Rank {
    let too_large = || Rank::Undecided(String::from("the minors of the coefficient table are too large"));
    let mut work = Work::new(WORK * u64::from(family.budget));
    let fixed: Vec<(Var, Rational)> =
        region.ranges.iter().filter_map(|(v, r)| Some((*v, single(r)?))).collect();
    let at = |p: &Poly| fixed.iter().fold(p.clone(), |p, (v, x)| p.at(*v, x));
    let table: Vec<Vec<Poly>> = table.iter().map(|row| row.iter().map(&at).collect()).collect();
    let mut known: BTreeMap<Poly, bool> = BTreeMap::new();
    let mut nonzero =
        |p: &Poly| *known.entry(p.normalized()).or_insert_with_key(|p| vanishes_nowhere(p, region));
    let Some(reduced) = reduce(table.clone(), &mut nonzero, &mut work) else { return too_large() };
    if !reduced.rest.is_empty()
        && let Some(corner) = deficient_corner(&table, region)
    {
        return Rank::Deficient(corner);
    }
    let Some(minors) = minors(&reduced, &mut work) else { return too_large() };
    match decide::decide(&minors, Relation::Positive, region, &mut Budget::scaled(family.budget)) {
        Decision::Proved(positive) => {
            Rank::Full(RankProof { region: region.clone(), pivots: reduced.pivots, minors, positive })
        }
        Decision::Refuted(witness) => Rank::Deficient(witness.point),
        Decision::Undecided(left) => Rank::Undecided(left),
    }
}

/// Whether a polynomial is positive or negative on the whole region.
fn vanishes_nowhere(p: &Poly, region: &Region) -> bool {
    [p.clone(), -p].iter().any(|p| {
        matches!(decide::decide(p, Relation::Positive, region, &mut Budget::scaled(1)), Decision::Proved(_))
    })
}

/// A corner of the region, its included ends only, at which the rank is not full: where most families fail first.
fn deficient_corner(table: &[Vec<Poly>], region: &Region) -> Option<Vec<(Var, Coordinate)>> {
    let mut corners: Vec<Vec<(Var, Rational)>> = vec![Vec::new()];
    for (var, range) in &region.ranges {
        let mut ends: Vec<Rational> = vec![point::simple(range)];
        ends.extend(
            [&range.low, &range.high]
                .into_iter()
                .filter(|e| e.is_included())
                .filter_map(|e| e.value().cloned()),
        );
        corners = corners
            .into_iter()
            .flat_map(|c| {
                ends.iter().map(|e| [c.as_slice(), &[(*var, e.clone())]].concat()).collect::<Vec<_>>()
            })
            .take(32)
            .collect();
    }
    corners.into_iter().find_map(|corner| {
        let len = corner.iter().map(|(v, _)| v.0 + 1).max().unwrap_or(0);
        let corner: Vec<(Var, Coordinate)> =
            corner.into_iter().map(|(v, x)| (v, Coordinate::Rational(x))).collect();
        let coordinates = point::coordinates(&corner, len);
        let numbers: Vec<Vec<Rational>> =
            table.iter().map(|row| row.iter().map(|p| p.eval(&coordinates)).collect()).collect();
        dependency(&numbers).map(|_| corner)
    })
}

/// The value of a range of one number.
fn single(range: &Range) -> Option<Rational> {
    range.finite().filter(|(a, b)| a == b).map(|(a, _)| a.clone())
}

/// The coefficients of all functions, one row for each; denominators, which vanish nowhere, are left out. On an interval
/// in the Bernstein basis, on a simplex in homogeneous monomials, in which more of them are numbers.
fn coefficient_table(family: &Family) -> Vec<Vec<Poly>> {
    if let Some(form) = crate::generate::form::IntervalForm::new(family) {
        return form.functions.into_iter().map(|f| f.bernstein).collect();
    }
    let first = family.shapes.len();
    let split = |m: &Monomial| {
        let e = m.exponents();
        let at = first.min(e.len());
        (e[at..].to_vec(), Monomial::new(e[..at].to_vec()))
    };
    let domain_degree = |m: &Monomial| split(m).0.iter().map(|e| u32::from(*e)).sum::<u32>();
    let degree =
        family.functions.iter().flat_map(|f| f.value.numer().terms().map(|(m, _)| domain_degree(m))).max();
    let rows: Vec<BTreeMap<Vec<u16>, Poly>> = family
        .functions
        .iter()
        .map(|f| {
            let mut row: BTreeMap<Vec<u16>, Poly> = BTreeMap::new();
            for (m, c) in f.value.numer().terms() {
                let (mut domain, shape) = split(m);
                domain.resize(family.domain.len(), 0);
                if !family.is_simplex() {
                    row.entry(domain).or_default().add_term(shape, c);
                    continue;
                }
                // Times (u + v + w)^missing = 1.
                let missing = degree.unwrap_or(0) - domain_degree(m);
                for (raise, factor) in power_of_sum(family.domain.len() + 1, missing) {
                    let column: Vec<u16> = raise
                        .iter()
                        .enumerate()
                        .map(|(i, e)| domain.get(i).copied().unwrap_or(0) + *e as u16)
                        .collect();
                    row.entry(column).or_default().add_term(shape.clone(), &(c * &factor));
                }
            }
            row
        })
        .collect();
    let mut columns: Vec<&Vec<u16>> = rows.iter().flat_map(BTreeMap::keys).collect();
    columns.sort_unstable();
    columns.dedup();
    rows.iter()
        .map(|row| columns.iter().map(|c| row.get(*c).cloned().unwrap_or_default()).collect())
        .collect()
}

/// The terms of (x₁ + … + x_len)^power: exponents with their multinomial coefficients.
fn power_of_sum(len: usize, power: u32) -> Vec<(Vec<u32>, Rational)> {
    if len == 1 {
        return vec![(vec![power], Rational::ONE)];
    }
    (0..=power)
        .flat_map(|first| {
            let chosen = binomial(power, first);
            power_of_sum(len - 1, power - first)
                .into_iter()
                .map(move |(rest, factor)| ([&[first], rest.as_slice()].concat(), &factor * &chosen))
        })
        .collect()
}

/// The sum of the squares of the maximal minors of what elimination leaves; 1 when nothing is left, 0 when there are too
/// few columns; `None` when the work is spent.
fn minors(reduced: &Reduced, work: &mut Work) -> Option<Poly> {
    let width = reduced.rest.first().map_or(0, Vec::len);
    match reduced.rest.as_slice() {
        [] => Some(Poly::one()),
        rows if width < rows.len() => Some(Poly::zero()),
        // A square table has one minor.
        rows if width == rows.len() => {
            let minor = determinant(rows.to_vec(), work)?;
            work.spend_product(&minor, &minor)?;
            Some(&minor * &minor)
        }
        rows => gram_determinant(rows, work),
    }
}

/// The same for a whole table, with constant pivots only.
fn minors_everywhere(family: &Family, table: Vec<Vec<Poly>>) -> Option<Poly> {
    let mut work = Work::new(WORK * u64::from(family.budget));
    let reduced = reduce(table, &mut |_| false, &mut work)?;
    minors(&reduced, &mut work)
}

/// The refutation when the functions are not dependent at a listed exception.
fn contradicted(family: &Family, table: &[Vec<Poly>], values: &[(Var, Rational)]) -> Option<Verdict> {
    let at = |p: &Poly| values.iter().fold(p.clone(), |p, (v, x)| p.at(*v, x));
    let fixed = table.iter().map(|row| row.iter().map(&at).collect()).collect();
    let Some(minors) = minors_everywhere(family, fixed) else {
        return Some(Verdict::Undecided(String::from("the minors of the coefficient table are too large")));
    };
    if minors.is_zero() {
        return None;
    }
    let mut full = point::nonzero(family, &minors)?;
    for (var, x) in values {
        full.retain(|(v, _)| v != var);
        full.push((*var, Coordinate::Rational(x.clone())));
    }
    let value = minors.eval(&point::coordinates(&full, family.names.len()));
    let described: Vec<String> = values.iter().map(|(v, x)| format!("{} = {x}", family.names[v.0])).collect();
    Some(Verdict::Refuted(Witness {
        of: String::from("sum of the squares of the maximal minors"),
        at: named_point(family, &full, &[]),
        value,
        notes: vec![format!("at {} the functions are independent: it is no exception", described.join(", "))],
    }))
}

/// The combination of the functions that vanishes at a point of the shape parameters.
fn dependent_at(family: &Family, table: &[Vec<Poly>], point: &[(Var, Coordinate)]) -> Witness {
    let exact = point.iter().all(|(_, c)| matches!(c, Coordinate::Rational(_)));
    let coordinates = point::coordinates(point, family.names.len());
    let numbers: Vec<Vec<Rational>> =
        table.iter().map(|row| row.iter().map(|p| p.eval(&coordinates)).collect()).collect();
    let combination = if exact { dependency(&numbers) } else { None };
    let place = |of: String, notes: Vec<String>| Witness {
        of,
        at: named_point(family, point, &[]),
        value: Rational::ZERO,
        notes,
    };
    let described: Vec<String> = point
        .iter()
        .filter(|(v, _)| family.shapes.iter().any(|s| s.var == *v))
        .map(|(v, c)| c.describe(&family.names[v.0]))
        .collect();
    let at = if described.is_empty() { String::new() } else { format!(" at {}", described.join(", ")) };
    match combination {
        Some(factors) => {
            // The rows are numerators; a function is its numerator over its denominator.
            let scaled =
                factors.iter().zip(&family.functions).map(|(c, f)| c * &f.value.denom().eval(&coordinates));
            let of = combination_text(family, &scaled.collect::<Vec<_>>());
            let note = format!("`{of}` vanishes identically{at}");
            place(of, vec![note])
        }
        None => place(
            String::from("sum of the squares of the maximal minors"),
            vec![format!("the functions are linearly dependent{at}")],
        ),
    }
}

/// `b[1] - 2*b[2]`, the numbers made whole.
fn combination_text(family: &Family, factors: &[Rational]) -> String {
    let content = factors.iter().fold(Rational::ZERO, |g, c| g.gcd(c));
    let mut text = String::new();
    for (k, factor) in factors.iter().enumerate().filter(|(_, c)| !c.is_zero()) {
        let whole = factor.checked_div(&content).unwrap_or(Rational::ONE);
        text += match (text.is_empty(), whole.is_negative()) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        if !whole.abs().is_one() {
            text += &format!("{}*", whole.abs());
        }
        text += &family.function_label(k);
    }
    text
}

/// A box without some points, lines and planes, as boxes.
fn pieces(region: &Region, except: &[Vec<(Var, Rational)>]) -> Vec<Region> {
    let Some(((var, value), rest)) =
        except.first().and_then(|e| e.split_first()).map(|(f, r)| (f.clone(), r))
    else {
        return vec![region.clone()];
    };
    let range = region.range(var);
    let with = |range: Range| {
        let mut part = region.clone();
        part.ranges.retain(|(v, _)| *v != var);
        part.ranges.push((var, range));
        part.ranges.sort_by_key(|(v, _)| *v);
        part
    };
    let below = Range { low: range.low.clone(), high: End::Excluded(value.clone()) };
    let above = Range { low: End::Excluded(value.clone()), high: range.high.clone() };
    let others = &except[1..];
    let mut all = Vec::new();
    for side in [below, above].into_iter().filter(|r| !r.is_empty()) {
        // Exceptions at other values of this variable may still cut the piece.
        let inside = |e: &Vec<(Var, Rational)>| e.iter().all(|(v, x)| *v != var || side.contains(x));
        let cutting: Vec<Vec<(Var, Rational)>> = others.iter().filter(|e| inside(e)).cloned().collect();
        all.extend(pieces(&with(side.clone()), &cutting));
    }
    if !rest.is_empty() {
        // On the plane var = value the exceptions lose this variable; one that says nothing else removes the plane.
        let mut on_plane = vec![rest.to_vec()];
        for e in others.iter().filter(|e| e.iter().all(|(v, x)| *v != var || *x == value)) {
            on_plane.push(e.iter().filter(|(v, _)| *v != var).cloned().collect());
        }
        if on_plane.iter().all(|e| !e.is_empty()) {
            all.extend(pieces(&with(Range::closed(value.clone(), value)), &on_plane));
        }
    }
    all
}

/// The shape values at which the functions are dependent, as text, one line for each: isolated values of one parameter,
/// the others arbitrary; `None` when the minors are too large to compute.
pub fn exceptional_set(family: &Family) -> Option<Vec<String>> {
    let minors = minors_everywhere(family, coefficient_table(family))?;
    if minors.is_zero() {
        return Some(vec![String::from("dependent for all shape values")]);
    }
    let mut lines = Vec::new();
    for shape in &family.shapes {
        // The factor that depends on this parameter alone: the common divisor of the coefficients in the others.
        let mut common = Poly::zero();
        for (_, coefficient) in grouped(&minors, shape.var) {
            common = crate::algebra::gcd::gcd(&common, &coefficient);
        }
        let region = Region { ranges: vec![(shape.var, shape.range.clone())] };
        let mut zeros = Vec::new();
        let mut parts = vec![region];
        // Each zero that is found splits the range for the next ones.
        while let Some(part) = parts.pop() {
            let positive = &common * &common;
            let Decision::Refuted(witness) =
                decide::decide(&positive, Relation::Positive, &part, &mut Budget::scaled(family.budget))
            else {
                continue;
            };
            match witness.point.first() {
                Some((_, Coordinate::Rational(x))) => {
                    zeros.push((x.clone(), witness.point[0].1.clone()));
                    parts.extend(pieces(&part, &[vec![(shape.var, x.clone())]]));
                }
                Some((_, c)) => {
                    lines.push(c.describe(&shape.name));
                }
                None => {}
            }
        }
        zeros.sort_by(|a, b| a.0.cmp(&b.0));
        lines.extend(zeros.into_iter().map(|(_, c)| c.describe(&shape.name)));
    }
    Some(lines)
}

/// The coefficients of a polynomial as polynomials in one variable, by the monomials in the others.
fn grouped(poly: &Poly, var: Var) -> Vec<(Monomial, Poly)> {
    let mut groups: Vec<(Monomial, Poly)> = Vec::new();
    for (m, c) in poly.terms() {
        let others = m.with_exponent(var, 0);
        let own = Monomial::one().with_exponent(var, m.exponent(var));
        match groups.iter_mut().find(|(n, _)| *n == others) {
            Some((_, p)) => p.add_term(own, c),
            None => groups.push((others, Poly::term(own, c.clone()))),
        }
    }
    groups
}

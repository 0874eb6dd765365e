//! Linear independence of the rows of a matrix of polynomials.
//!
//! **Theorems.** Rows are independent at a point if after a change to other bases they are. If the rows fall into
//! blocks, each of them zero in the chosen columns of all later blocks, and in each block one of some minors is not
//! zero, they are independent. A minor of whole numbers that is not zero modulo a prime is not zero. If Σ cᵢ·(row i) =
//! 0 with polynomials cᵢ that are not all zero, all maximal minors vanish, also where the cᵢ do.

use super::pieces::pieces;
use super::sign::signed;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Region;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::certificate::{Certificate, ChangeOfBasis, Combination, Minors, Piece, Rank};
use crate::collections::list::Mapped;
use crate::refusal::{Refusal, fits, shown};
use crate::statement::{Relation, Values};

/// The most parts into which exceptions cut a box.
const MAX_PIECES: usize = 10_000;
/// The most minors of a block.
const MAX_MINORS: usize = 50;

/// Checks that the rows are independent on the box but for the exceptions, and dependent at these.
pub(super) fn independent(
    rows: &[Vec<Poly>],
    except: &[Values],
    region: &Region,
    certificate: &Certificate,
    work: &mut Work,
) -> Result<(), Refusal> {
    let width = rows.first().map_or(0, Vec::len);
    fits(rows.iter().all(|r| r.len() == width), "the rows have different lengths")?;
    let rank = match certificate {
        Certificate::Direct => {
            fits(except.is_empty(), "nothing is said about the exceptions")?;
            if region.ranges.iter().any(|(_, r)| r.is_empty()) {
                return Ok(());
            }
            let numbers: Option<Vec<Vec<Rational>>> =
                rows.iter().map(|row| row.iter().map(Poly::as_constant).collect()).collect();
            let numbers = numbers.ok_or(Refusal::Unproved("the table does not consist of numbers"))?;
            return shown(are_independent(&numbers, work).ok_or(Refusal::Spent)?, "the rows are dependent");
        }
        Certificate::Rank(rank) => rank,
        _ => return Err(Refusal::Unfit("the certificate is not one of independence")),
    };
    exceptions(rows, except, region, rank, work)?;
    let parts = pieces(region, except, MAX_PIECES).ok_or(Refusal::Spent)?;
    fits(parts.len() == rank.pieces.len(), "there is not one proof for each part of the box")?;
    for (part, proof) in parts.iter().zip(&rank.pieces) {
        piece(rows, part, proof, work)?;
    }
    Ok(())
}

/// Primes, and if all minors vanish modulo each of them, independence of rows of numbers is not seen.
const PRIMES: [i64; 3] = [2_147_483_647, 2_147_483_629, 2_147_483_587];

/// Whether rows of numbers are seen to be independent; `None` when the work is spent.
pub(crate) fn are_independent(rows: &[Vec<Rational>], work: &mut Work) -> Option<bool> {
    let mut whole = Vec::new();
    for row in rows {
        // The row times a number is whole, without a common factor.
        let bits = row.iter().map(Rational::bits).max().unwrap_or(0);
        work.spend(row.len() as u64 * (8 + bits / 8 + bits * bits / 1024))?;
        let content = row.iter().fold(Rational::ZERO, |g, x| g.gcd(x));
        let Some(factor) = content.recip() else { return Some(false) };
        work.spend(row.len() as u64 * (4 + factor.bits() * factor.bits() / 4096))?;
        whole.push(row.mapped(|x| x * &factor));
    }
    for p in PRIMES {
        let residue = |x: &Rational| match x.to_i64() {
            Some(x) => x.rem_euclid(p),
            None => (x - &(&(x / &p.into()).floor() * &p.into())).to_i64().unwrap_or(0),
        };
        let mut left: Vec<Vec<i64>> = whole.mapped(|row: &Vec<Rational>| row.mapped(residue));
        while let Some(pivot) = left.pop() {
            let Some(column) = pivot.iter().position(|x| *x != 0) else { break };
            work.spend((left.len() * pivot.len()) as u64 + 1)?;
            for row in &mut left {
                let (a, b) = (pivot[column], row[column]);
                for (x, y) in row.iter_mut().zip(&pivot) {
                    *x = (*x * a - b * y).rem_euclid(p);
                }
            }
            if left.is_empty() {
                return Some(true);
            }
        }
    }
    Some(rows.is_empty())
}

/// The polynomial where some variables have values.
fn at(p: &Poly, values: &[(Var, Rational)], work: &mut Work) -> Result<Poly, Refusal> {
    let mut p = p.clone();
    for (v, x) in values {
        if p.depends_on(*v) {
            work.spend_at(&p, *v, x).ok_or(Refusal::Spent)?;
            p = p.at(*v, x);
        }
    }
    Ok(p)
}

/// Checks that at each exception a combination of the rows vanishes.
fn exceptions(
    rows: &[Vec<Poly>],
    except: &[Values],
    region: &Region,
    rank: &Rank,
    work: &mut Work,
) -> Result<(), Refusal> {
    fits(rank.exceptions.len() == except.len(), "there is not one combination for each exception")?;
    for (values, combination) in except.iter().zip(&rank.exceptions) {
        if values.iter().any(|(v, x)| !region.range(*v).contains(x)) {
            fits(combination.is_empty(), "an exception outside of the ranges has a combination")?;
            continue;
        }
        fits(combination.len() == rows.len(), "a combination has not one factor for each row")?;
        let fixed = |c: &Poly| values.iter().any(|(v, _)| c.depends_on(*v));
        fits(!combination.iter().any(fixed), "a combination contains a fixed variable")?;
        fits(!combination.iter().all(Poly::is_zero), "all factors of a combination are zero")?;
        for column in 0..rows.first().map_or(0, Vec::len) {
            let mut sum = Poly::zero();
            for (factor, row) in combination.iter().zip(rows) {
                let entry = at(&row[column], values, work)?;
                work.spend_product(factor, &entry).ok_or(Refusal::Spent)?;
                sum = &sum + &(factor * &entry);
            }
            shown(sum.is_zero(), "a combination does not vanish at its exception")?;
        }
    }
    Ok(())
}

/// Checks a part of the box: all rows stand in blocks, zero in the columns of later ones, and no block is dependent.
fn piece(rows: &[Vec<Poly>], region: &Region, proof: &Piece, work: &mut Work) -> Result<(), Refusal> {
    // Variables with a single value are replaced by it.
    let single: Values = region
        .ranges
        .iter()
        .filter_map(|(v, r)| r.finite().filter(|(a, b)| a == b).map(|(a, _)| (*v, a.clone())))
        .collect();
    let mut fixed: Vec<Vec<Poly>> = rows.to_vec();
    for p in fixed.iter_mut().flatten().filter(|_| !single.is_empty()) {
        *p = at(p, &single, work)?;
    }
    let rows = match &proof.change {
        None => fixed,
        Some(change) => changed(&fixed, change, work)?,
    };
    let mut seen = vec![false; rows.len()];
    for row in proof.blocks.iter().flat_map(|b| &b.rows) {
        let new = seen.get_mut(*row).is_some_and(|s| !core::mem::replace(s, true));
        fits(new, "a row stands in two blocks, or does not exist")?;
    }
    fits(seen.iter().all(|s| *s), "a row stands in no block")?;
    let width = rows.first().map_or(0, Vec::len);
    for (k, block) in proof.blocks.iter().enumerate() {
        let columns = || block.columns.iter().flatten();
        fits(columns().all(|c| *c < width), "a minor has a column that does not exist")?;
        let increasing = |list: &Vec<usize>| list.windows(2).all(|w| w[0] < w[1]);
        fits(block.columns.iter().all(increasing), "columns are not in increasing order")?;
        let mut earlier = proof.blocks[..k].iter().flat_map(|b| &b.rows);
        shown(
            earlier.all(|r| columns().all(|c| rows[*r][*c].is_zero())),
            "a row is not zero in the columns of a later block",
        )?;
        minors(&rows, block, region, work)?;
    }
    Ok(())
}

/// The rows in other bases; the new rows must span the old ones.
fn changed(rows: &[Vec<Poly>], change: &ChangeOfBasis, work: &mut Work) -> Result<Vec<Vec<Poly>>, Refusal> {
    let (height, width) = (rows.len(), rows.first().map_or(0, Vec::len));
    fits(change.rows.len() == height, "the new basis has not as many rows")?;
    fits(change.columns.len() <= width, "the new basis has more columns")?;
    let known = |c: &Combination, len: usize| c.iter().all(|(k, _)| *k < len);
    let all = change.rows.iter().all(|c| known(c, height)) && change.columns.iter().all(|c| known(c, width));
    fits(all, "a basis combines a row or column that does not exist")?;
    let dense = |c: &Combination| {
        let mut row = vec![Rational::ZERO; height];
        for (k, x) in c {
            row[*k] += x;
        }
        row
    };
    let full = are_independent(&change.rows.mapped(dense), work).ok_or(Refusal::Spent)?;
    shown(full, "the rows of the new basis are dependent")?;
    let mut result = Vec::new();
    for row in &change.rows {
        let mut combined = vec![Poly::zero(); width];
        for (k, factor) in row {
            for (x, p) in combined.iter_mut().zip(&rows[*k]) {
                work.spend((x.len() + p.len()) as u64 + 1).ok_or(Refusal::Spent)?;
                *x = &*x + &p.scale(factor);
            }
        }
        let mut new = Vec::new();
        for column in &change.columns {
            let mut sum = Poly::zero();
            for (k, factor) in column {
                work.spend((sum.len() + combined[*k].len()) as u64 + 1).ok_or(Refusal::Spent)?;
                sum = &sum + &combined[*k].scale(factor);
            }
            new.push(sum);
        }
        result.push(new);
    }
    Ok(result)
}

/// Checks that minors do not vanish together: a single one has a sign, or the sum of the squares of several is
/// positive.
fn minors(rows: &[Vec<Poly>], block: &Minors, region: &Region, work: &mut Work) -> Result<(), Refusal> {
    fits(block.columns.len() <= MAX_MINORS, "a block has too many minors")?;
    let rows: Vec<&[Poly]> = block.rows.iter().map(|r| &rows[*r][..]).collect();
    let mut minors = Vec::new();
    for columns in &block.columns {
        minors.push(minor(&rows, columns, work)?);
    }
    let value = match &minors[..] {
        [] => return Err(Refusal::Unfit("a block has no minor")),
        [only] => only.clone(),
        several => {
            let mut sum = Poly::zero();
            for m in several {
                work.spend_product(m, m).ok_or(Refusal::Spent)?;
                sum = &sum + &(m * m);
            }
            sum
        }
    };
    signed(&value, Relation::Positive, region, &block.sign, work).map(|_| ())
}

/// The determinant of some columns.
///
/// # Errors
/// When there are not as many columns as rows, or the work is spent.
pub fn minor(rows: &[&[Poly]], columns: &[usize], work: &mut Work) -> Result<Poly, Refusal> {
    fits(columns.len() == rows.len(), "a minor has not as many columns as rows")?;
    let mut matrix: Vec<Vec<Poly>> = Vec::new();
    for row in rows {
        let picked: Option<Vec<Poly>> = columns.iter().map(|c| row.get(*c).cloned()).collect();
        matrix.push(picked.ok_or(Refusal::Unfit("a minor has a column that does not exist"))?);
    }
    let mut determinant = Poly::one();
    let mut last = Poly::one();
    let mut plain = true;
    while !matrix.is_empty() {
        // Numbers first: with them as pivots, plain elimination needs no division of polynomials; then as Bareiss does.
        work.spend((matrix.len() * matrix.len()) as u64).ok_or(Refusal::Spent)?;
        let zeros: Vec<usize> = matrix.iter().map(|r| r.iter().filter(|p| p.is_zero()).count()).collect();
        let places =
            || matrix.iter().enumerate().flat_map(|(i, r)| r.iter().enumerate().map(move |(j, p)| (i, j, p)));
        let number = places().filter(|(_, _, p)| plain && !p.is_zero() && p.as_constant().is_some());
        let place = number.max_by_key(|(i, _, _)| zeros[*i]);
        plain = place.is_some();
        let found =
            place.or_else(|| places().filter(|(_, _, p)| !p.is_zero()).min_by_key(|(_, _, p)| p.len()));
        let Some((i, j, _)) = found else { return Ok(Poly::zero()) };
        // Every exchange with the first row or column changes the sign.
        let negative = (i + j) % 2 == 1;
        let mut pivot = matrix.remove(i);
        let head = pivot.remove(j);
        for row in &mut matrix {
            let factor = row.remove(j);
            for (x, p) in row.iter_mut().zip(&pivot) {
                work.spend_product(p, &factor).ok_or(Refusal::Spent)?;
                if plain {
                    let quotient = factor.div_exact(&head).unwrap_or_default();
                    *x = &*x - &(p * &quotient);
                } else {
                    work.spend_product(x, &head).ok_or(Refusal::Spent)?;
                    let difference = &(&*x * &head) - &(p * &factor);
                    let quotient = difference.div_exact(&last);
                    *x = quotient.ok_or(Refusal::Unproved("an elimination leaves a remainder"))?;
                }
            }
        }
        if plain {
            determinant = &determinant * &head;
        } else {
            last = head;
        }
        if negative {
            determinant = -&determinant;
        }
    }
    Ok(&determinant * &last)
}

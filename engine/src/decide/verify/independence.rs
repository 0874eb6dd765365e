//! Checks proofs of independence: that the parts cover the region, and that the minors do not vanish together.

use core::cmp::Ordering;

use super::{Computed, check, verify};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range, Region};
use crate::algebra::rational::Rational;
use crate::decide::Relation;
use crate::decide::independence::{Minors, Piece, Values};
use crate::decide::symmetry::{ChangeOfBasis, Combination};

/// The most cells into which the ends of ranges and exceptions cut the region.
const MAX_CELLS: usize = 100_000;
/// The most minors of a block.
const MAX_MINORS: usize = 50;

/// Checks that the rows of a matrix are independent at every point of a region that has not all values of one of the
/// exceptions, with `budget` times the usual work for each certificate.
///
/// # Errors
/// What is wrong with the proof, in a sentence.
pub fn verify_independence(
    rows: &[Vec<Poly>],
    except: &[Values],
    region: &Region,
    pieces: &[Piece],
    budget: u32,
) -> Result<Computed, String> {
    let width = rows.first().map_or(0, Vec::len);
    check(rows.iter().all(|r| r.len() == width), || "the rows have different lengths".into())?;
    covered(rows, except, region, pieces)?;
    let mut computed = Computed::default();
    for piece in pieces {
        let changed = match &piece.change {
            None => None,
            Some(change) => Some(changed(rows, change)?),
        };
        blocks(changed.as_deref().unwrap_or(rows), piece, budget, &mut computed)?;
    }
    Ok(computed)
}

/// The rows in other bases; the new rows must span the old ones.
fn changed(rows: &[Vec<Poly>], change: &ChangeOfBasis) -> Result<Vec<Vec<Poly>>, String> {
    let (height, width) = (rows.len(), rows.first().map_or(0, Vec::len));
    check(change.rows.len() == height, || "the new basis has not as many rows".into())?;
    check(change.columns.len() <= width, || "the new basis has more columns".into())?;
    let known = |c: &Combination, len: usize| c.iter().all(|(k, _)| *k < len);
    let all = change.rows.iter().all(|c| known(c, height)) && change.columns.iter().all(|c| known(c, width));
    check(all, || "a basis combines a row or column that does not exist".into())?;
    check(spans(&change.rows), || "the rows of the new basis are dependent".into())?;
    let mut result = Vec::new();
    for row in &change.rows {
        let mut combined = vec![Poly::zero(); width];
        for (k, factor) in row {
            for (x, p) in combined.iter_mut().zip(&rows[*k]) {
                *x = &*x + &p.scale(factor);
            }
        }
        let column = |c: &Combination| c.iter().fold(Poly::zero(), |s, (k, f)| &s + &combined[*k].scale(f));
        result.push(change.columns.iter().map(column).collect());
    }
    Ok(result)
}

/// Whether as many combinations of as many things are independent.
fn spans(combinations: &[Combination]) -> bool {
    let mut rows: Vec<Vec<Rational>> = combinations
        .iter()
        .map(|c| {
            let mut row = vec![Rational::ZERO; combinations.len()];
            for (k, x) in c {
                row[*k] += x;
            }
            row
        })
        .collect();
    let mut columns: Vec<usize> = (0..rows.len()).collect();
    while let Some(pivot) = rows.pop() {
        let Some(place) = columns.iter().position(|c| !pivot[*c].is_zero()) else { return false };
        let column = columns.swap_remove(place);
        for row in rows.iter_mut().filter(|r| !r[column].is_zero()) {
            let factor = &row[column] / &pivot[column];
            for (x, p) in row.iter_mut().zip(&pivot).filter(|(_, p)| !p.is_zero()) {
                *x -= &(p * &factor);
            }
        }
    }
    true
}

/// Checks the blocks of a part: all rows, zero in the columns of later blocks, and not dependent in their own.
fn blocks(rows: &[Vec<Poly>], piece: &Piece, budget: u32, computed: &mut Computed) -> Result<(), String> {
    let mut all: Vec<usize> = piece.blocks.iter().flat_map(|b| b.rows.iter().copied()).collect();
    all.sort_unstable();
    check(all.iter().copied().eq(0..rows.len()), || "a function is in no block or in several".into())?;
    let width = rows.first().map_or(0, Vec::len);
    for (k, block) in piece.blocks.iter().enumerate() {
        let columns = || block.columns.iter().flatten();
        check(columns().all(|c| *c < width), || "a minor has a column that does not exist".into())?;
        let increasing = |list: &Vec<usize>| list.windows(2).all(|w| w[0] < w[1]);
        check(increasing(&block.rows) && block.columns.iter().all(increasing), || {
            "rows or columns are not in increasing order".into()
        })?;
        let repeated = |(k, m): (usize, &Vec<usize>)| block.columns[..k].contains(m);
        check(!block.columns.iter().enumerate().any(repeated), || "two minors are the same".into())?;
        let mut earlier = piece.blocks[..k].iter().flat_map(|b| &b.rows);
        check(earlier.all(|r| columns().all(|c| rows[*r][*c].is_zero())), || {
            "a function is not zero in the columns of a later block".into()
        })?;
        let part: Vec<&[Poly]> = block.rows.iter().map(|r| &rows[*r][..]).collect();
        let found = minors(&part, block, &piece.region, budget)?;
        computed.cells.extend(found.cells);
        computed.minors.extend(found.minors);
    }
    Ok(())
}

/// Checks that minors do not vanish together.
fn minors(rows: &[&[Poly]], block: &Minors, region: &Region, budget: u32) -> Result<Computed, String> {
    check(block.columns.len() <= MAX_MINORS, || format!("there are more than {MAX_MINORS} minors"))?;
    let mut minors = Vec::new();
    for columns in &block.columns {
        minors.push(minor(rows, columns)?);
    }
    let claim = match &minors[..] {
        [] => return Err("there is no minor".into()),
        [only] => {
            // With one of the two signs.
            if let Ok(cells) = verify(only, Relation::Positive, region, &block.certificate, budget) {
                return Ok(Computed { cells, minors });
            }
            -only
        }
        _ => minors.iter().fold(Poly::zero(), |sum, m| &sum + &(m * m)),
    };
    let cells = verify(&claim, Relation::Positive, region, &block.certificate, budget)?;
    Ok(Computed { cells, minors })
}

/// Checks that every point of the region is in a part or is an exception.
fn covered(rows: &[Vec<Poly>], except: &[Values], region: &Region, pieces: &[Piece]) -> Result<(), String> {
    for (k, piece) in pieces.iter().enumerate() {
        let inside = region.ranges.iter().all(|(v, r)| is_inside(&piece.region.range(*v), r));
        check(inside, || "a part goes beyond the region".into())?;
        check(pieces[..k].iter().all(|p| p.region != piece.region), || "two parts are the same".into())?;
    }
    let mut vars: Vec<Var> = rows.iter().flatten().flat_map(Poly::variables).collect();
    let all = region.ranges.iter().chain(pieces.iter().flat_map(|p| &p.region.ranges)).map(|(v, _)| *v);
    vars.extend(all.chain(except.iter().flatten().map(|(v, _)| *v)));
    vars.sort();
    vars.dedup();
    // Whether a part or an exception contains a point depends only on how its coordinates compare with these numbers.
    let mut points: Vec<Vec<(Var, Rational)>> = vec![Vec::new()];
    for var in vars {
        let range = region.range(var);
        let ends = |r: &Range| [r.low.value().cloned(), r.high.value().cloned()];
        let mut cuts: Vec<Rational> =
            pieces.iter().flat_map(|p| ends(&p.region.range(var))).flatten().collect();
        cuts.extend(ends(&range).into_iter().flatten());
        cuts.extend(except.iter().flatten().filter(|(v, _)| *v == var).map(|(_, x)| x.clone()));
        cuts.sort();
        cuts.dedup();
        let mut samples = cuts.clone();
        samples.extend(cuts.windows(2).map(|w| &(&w[0] + &w[1]) * &Rational::new(1, 2)));
        samples.extend(cuts.first().map(|x| x - &Rational::ONE));
        samples.extend(cuts.last().map(|x| x + &Rational::ONE));
        if samples.is_empty() {
            samples.push(Rational::ZERO);
        }
        samples.retain(|x| range.contains(x));
        check(points.len() * samples.len() <= MAX_CELLS, || "there are too many parts".into())?;
        let with = |p: &Vec<(Var, Rational)>, x: &Rational| [&p[..], &[(var, x.clone())]].concat();
        points = points.iter().flat_map(|p| samples.iter().map(move |x| with(p, x))).collect();
    }
    for point in points {
        let exception = except.iter().any(|e| e.iter().all(|value| point.contains(value)));
        let in_part = |p: &Piece| point.iter().all(|(v, x)| p.region.range(*v).contains(x));
        check(exception || pieces.iter().any(in_part), || "a point of the region is in no part".into())?;
    }
    Ok(())
}

/// Whether a range is a part of another one, with ends that are included only if those of the other are.
fn is_inside(part: &Range, whole: &Range) -> bool {
    let end = |x: &End, end: &End, order: Ordering| match (x, end) {
        (_, End::Infinite) => true,
        (End::Infinite, _) => false,
        (End::Included(a), End::Excluded(b)) => a.cmp(b) == order,
        (End::Included(a) | End::Excluded(a), End::Included(b) | End::Excluded(b)) => {
            a.cmp(b) != order.reverse()
        }
    };
    end(&part.low, &whole.low, Ordering::Greater) && end(&part.high, &whole.high, Ordering::Less)
}

/// The determinant of some columns, up to its sign.
fn minor(rows: &[&[Poly]], columns: &[usize]) -> Result<Poly, String> {
    check(columns.len() == rows.len(), || "a minor has not as many columns as there are functions".into())?;
    let mut matrix: Vec<Vec<Poly>> = Vec::new();
    for row in rows {
        let picked: Option<Vec<Poly>> = columns.iter().map(|c| row.get(*c).cloned()).collect();
        matrix.push(picked.ok_or("a minor has a column that does not exist")?);
    }
    let mut determinant = Poly::one();
    let mut last = Poly::one();
    let mut plain = true;
    while !matrix.is_empty() {
        // Numbers first: with them as pivots, plain elimination needs no division of polynomials.
        let places =
            || matrix.iter().enumerate().flat_map(|(i, r)| r.iter().enumerate().map(move |(j, p)| (i, j, p)));
        let number = places().filter(|(_, _, p)| plain && p.as_constant().is_some_and(|c| !c.is_zero()));
        let zeros = |i: usize| matrix[i].iter().filter(|p| p.is_zero()).count();
        let place = number.max_by_key(|(i, _, _)| zeros(*i)).map(|(i, j, _)| (i, j));
        plain = place.is_some();
        let found = place.or_else(|| {
            places().filter(|(_, _, p)| !p.is_zero()).min_by_key(|(_, _, p)| p.len()).map(|(i, j, _)| (i, j))
        });
        let Some((i, j)) = found else { return Ok(Poly::zero()) };
        let mut pivot = matrix.remove(i);
        let head = pivot.remove(j);
        for row in &mut matrix {
            let factor = row.remove(j);
            for (x, p) in row.iter_mut().zip(&pivot) {
                if plain {
                    let quotient = factor.div_exact(&head).unwrap_or_default();
                    *x = &*x - &(p * &quotient);
                } else {
                    let difference = &(&*x * &head) - &(p * &factor);
                    *x = difference.div_exact(&last).ok_or("an elimination leaves a remainder")?;
                }
            }
        }
        if plain {
            determinant = &determinant * &head;
        } else {
            last = head;
        }
    }
    Ok(&determinant * &last)
}

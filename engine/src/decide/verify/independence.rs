//! Checks proofs of independence: that the parts cover the region, and that the minors do not vanish together.

use super::{check, verify};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{Range, Region};
use crate::algebra::rational::Rational;
use crate::decide::Relation;
use crate::decide::independence::{Piece, Values};

/// The most cells into which the ends of ranges and exceptions cut the region.
const MAX_CELLS: usize = 100_000;

/// Checks that the rows of a matrix are independent at every point of a region that has not all values of one of the
/// exceptions.
///
/// # Errors
/// What is wrong with the proof, in a sentence.
pub fn verify_independence(
    rows: &[Vec<Poly>],
    except: &[Values],
    region: &Region,
    pieces: &[Piece],
) -> Result<(), String> {
    covered(rows, except, region, pieces)?;
    for Piece { region, minors, certificate } in pieces {
        let mut values = Vec::new();
        for columns in minors {
            values.push(minor(rows, columns)?);
        }
        let claim = match &values[..] {
            [] => return Err("there is no minor".into()),
            [only] => {
                // With one of the two signs.
                if verify(only, Relation::Positive, region, certificate).is_ok() {
                    continue;
                }
                -only
            }
            _ => values.iter().fold(Poly::zero(), |sum, m| &sum + &(m * m)),
        };
        verify(&claim, Relation::Positive, region, certificate)?;
    }
    Ok(())
}

/// Checks that every point of the region is in a part or is an exception.
fn covered(rows: &[Vec<Poly>], except: &[Values], region: &Region, pieces: &[Piece]) -> Result<(), String> {
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

/// The determinant of some columns, up to its sign.
fn minor(rows: &[Vec<Poly>], columns: &[usize]) -> Result<Poly, String> {
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

//! The points of a domain at which a polynomial is 0: lines, curves, planes and surfaces, and points beside them.

use std::rc::Rc;

use super::domain::{Product, at};
use super::numbers;
use super::point::Point;
use super::stationary::stationary;
use super::{Locus, LocusKind};
use crate::algebra::divisors::factor::checked_factor;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;
use basis_kernel::{Relation, Statement};
use basis_prover::collections::list::Listed;
use basis_prover::{Failure, decide};

/// The steps of the lattice on which signs are looked at.
const STEPS: i64 = 6;

/// Where a polynomial is 0.
#[derive(Debug, Default)]
pub(super) struct Level {
    /// Lines, curves and so on.
    pub(super) loci: Vec<Locus>,
    /// Points that lie on none of them.
    pub(super) points: Vec<Point>,
    /// Whether there may be more.
    pub(super) open: bool,
}

/// Where a polynomial is 0; `known` are these points but for those on curves, or nothing if they are not known. The functions of
/// the family have `free` further variables.
pub(super) fn level(
    domain: &Product,
    p: &Poly,
    known: Option<&[Point]>,
    free: usize,
    work: &mut Work,
) -> Option<Level> {
    let mut found = Level::default();
    let mut on: Vec<Poly> = Vec::new();
    let mut points: Vec<Point> = known.map(<[Point]>::to_vec).unwrap_or_default();
    let size = domain.dimension() + free;
    for (factor, _) in checked_factor(p, work)?.1 {
        if factor.total_degree() == 1 {
            let corners = domain.corners();
            let signs = corners.iter().filter_map(|corner| Some(at(&factor, corner)?.signum())).listed();
            let zeros = corners.iter().zip(&signs).filter(|(_, sign)| **sign == 0).map(|(c, _)| c).listed();
            let changes = signs.contains(&1) && signs.contains(&-1);
            let own = if changes { domain.dimension() - 1 } else { dimension(&zeros) };
            match (changes, &zeros[..]) {
                (false, []) => {}
                (false, [corner]) => points.push(Point::rational(corner)),
                _ => {
                    let equation = domain.equation(&factor);
                    found.loci.push(Locus { kind: LocusKind::new(own + free, true), equation });
                    on.push(factor);
                }
            }
            continue;
        }
        if let Some((name, var, single)) = domain.of_one(&factor) {
            // On the whole range of a coordinate there are points.
            let (low, high) = domain.range(var)?;
            for root in numbers::roots(&Univariate::from_poly(&single, var)?, &low, &high, work)? {
                let equation = format!("{name} = {}", numbers::text(&root));
                found.loci.push(Locus { kind: LocusKind::new(size - 1, true), equation });
            }
            on.push(factor);
            continue;
        }
        match sign(domain, &factor) {
            Sign::Changes => {
                let equation = domain.equation(&factor);
                found.loci.push(Locus { kind: LocusKind::new(size - 1, false), equation });
                on.push(factor);
            }
            Sign::Positive => {}
            _ if known.is_some() => {}
            Sign::Unknown => found.open = true,
            Sign::NonNegative => match stationary(domain, &Fraction::from(factor.clone()), true, work) {
                Some(all) => {
                    found.open |= all.others;
                    for mut point in all.points {
                        let value = point.eval(&factor, work)?;
                        if point.sign(&value, work)? == 0 {
                            points.push(point);
                        }
                    }
                }
                None => found.open = true,
            },
        }
    }
    for mut point in points {
        let mut is_on = false;
        for factor in &on {
            let value = point.eval(factor, work)?;
            is_on = is_on || point.sign(&value, work)? == 0;
        }
        if !is_on {
            found.points.push(point);
        }
    }
    Some(found)
}

/// The dimension of the face that has these corners.
fn dimension(corners: &[&Vec<(Var, Rational)>]) -> usize {
    let Some((first, others)) = corners.split_first() else { return 0 };
    // Corners of a product of simplices: differences of coordinates, brought to steps.
    let mut rows: Vec<Vec<Rational>> = Vec::new();
    for corner in others {
        let mut row = corner.iter().zip(first.iter()).map(|((_, x), (_, y))| x - y).listed();
        for known in &rows {
            let Some(k) = known.iter().position(|x| !x.is_zero()) else { continue };
            let factor = &row[k] / &known[k];
            for (x, y) in row.iter_mut().zip(known) {
                *x -= &(y * &factor);
            }
        }
        if row.iter().any(|x| !x.is_zero()) {
            rows.push(row);
        }
    }
    rows.len()
}

/// What signs a polynomial, or its negative, has.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Sign {
    Positive,
    NonNegative,
    Changes,
    Unknown,
}

fn sign(domain: &Product, p: &Poly) -> Sign {
    let mut signs = Vec::new();
    for point in domain.corners().into_iter().chain(domain.lattice(STEPS)) {
        match at(p, &point).map_or(0, |x| x.signum()) {
            0 => {}
            sign if signs.contains(&-sign) => return Sign::Changes,
            sign => signs.push(sign),
        }
    }
    let p = if signs.contains(&-1) { -p } else { p.clone() };
    let all = domain.domain();
    let is_so = |relation: Relation| {
        let sign = Statement::Sign { value: p.clone().into(), relation, domain: Rc::clone(&all) };
        decide(sign, &Vec::new(), 1)
    };
    if is_so(Relation::Positive).is_ok() {
        return Sign::Positive;
    }
    match is_so(Relation::NonNegative) {
        Ok(_) => Sign::NonNegative,
        Err(Failure::Refuted(_)) => Sign::Changes,
        Err(Failure::Undecided(_)) => Sign::Unknown,
    }
}

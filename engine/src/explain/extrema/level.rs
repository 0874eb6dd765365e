//! The points of a domain at which a polynomial is 0: lines, curves, planes and surfaces, and points beside them.

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
use basis_kernel::Relation;
use basis_prover::Failure;
use basis_prover::collections::list::Listed;
use basis_prover::collections::sort::sort;

/// The work for the sign of a factor.
const WORK: u64 = 1_000_000;

/// Where a polynomial is 0.
#[derive(Debug, Default)]
pub(super) struct Level {
    /// Lines, curves and so on.
    pub(super) loci: Vec<Locus>,
    /// The polynomials that vanish on each of them.
    pub(super) equations: Vec<Vec<Poly>>,
    /// Points that lie on none of them.
    pub(super) points: Vec<Point>,
    /// Whether it has a factor, not of degree 1, that does not change its sign.
    pub(super) touches: bool,
    /// Whether there may be more.
    pub(super) open: bool,
}

/// Where a polynomial is 0. For one that does not change its sign, `known` are these points but for those on curves;
/// else nothing. The domain of the family has `free` further dimensions.
pub(super) fn level(
    domain: &Product,
    p: &Poly,
    known: Option<&[Point]>,
    free: usize,
    work: &mut Work,
) -> Option<Level> {
    let mut found = Level::default();
    let mut points: Vec<Point> = known.map(<[Point]>::to_vec).unwrap_or_default();
    let size = domain.dimension() + free;
    for (factor, exponent) in checked_factor(p, work)?.1 {
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
                    // A part of the boundary is given by all of its facets.
                    let equation = if changes { domain.equation(&factor) } else { facets(domain, &zeros) };
                    found.loci.push(Locus { kind: LocusKind::new(own + free, true), equation });
                    found.equations.push(vec![factor]);
                }
            }
            continue;
        }
        if let [var] = factor.variables()[..] {
            // On the whole range of a coordinate there are points.
            let (low, high) = domain.range(var)?;
            for root in numbers::roots(&Univariate::from_poly(&factor, var)?, &low, &high, work)? {
                let equation = format!("{} = {}", domain.name(var), numbers::text(&root));
                found.loci.push(Locus { kind: LocusKind::new(size - 1, true), equation });
                found.equations.push(vec![factor.clone()]);
            }
            continue;
        }
        // At an extreme value only squares change their sign.
        let own =
            if known.is_some() && exponent % 2 == 1 { Sign::NonNegative } else { sign(domain, &factor) };
        found.touches |= own == Sign::NonNegative;
        match own {
            Sign::Changes => {
                let equation = domain.equation(&factor);
                found.loci.push(Locus { kind: LocusKind::new(size - 1, false), equation });
                found.equations.push(vec![factor]);
            }
            Sign::Positive => {}
            Sign::Unknown => found.open = true,
            // On facets there may be lines and curves.
            Sign::NonNegative if known.is_some() => on_facets(domain, &factor, free, &mut found, work)?,
            Sign::NonNegative => match stationary(domain, &Fraction::from(factor.clone()), true, work) {
                Some(all) => {
                    on_facets(domain, &factor, free, &mut found, work)?;
                    found.open |= all.others || all.on_lines.iter().any(Rational::is_zero);
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
        for equations in &found.equations {
            let mut holds = true;
            for p in equations {
                let value = point.eval(p, work)?;
                holds = holds && point.sign(&value, work)? == 0;
            }
            is_on = is_on || holds;
        }
        if !is_on {
            found.points.push(point);
        }
    }
    Some(found)
}

/// Lines and curves in space at whose points a polynomial that is not negative is 0: those on facets.
fn on_facets(domain: &Product, p: &Poly, free: usize, found: &mut Level, work: &mut Work) -> Option<()> {
    if domain.dimension() < 3 {
        return Some(());
    }
    for facet in domain.facets() {
        let (var, value) = &facet.fixed;
        let own = level(&facet.domain, &p.substitute(*var, value), Some(&[]), free, work)?;
        found.open |= own.open;
        let at_facet = &Poly::var(*var) - value;
        for (locus, mut polys) in own.loci.into_iter().zip(own.equations) {
            polys.push(at_facet.clone());
            let mut equations = [&facet.equation[..], &locus.equation];
            sort(&mut equations);
            let equation = equations.join(", ");
            if found.loci.iter().all(|known| known.equation != equation) {
                found.loci.push(Locus { equation, ..locus });
                found.equations.push(polys);
            }
        }
    }
    Some(())
}

/// The equations of the facets on which some corners lie.
fn facets(domain: &Product, corners: &[&Vec<(Var, Rational)>]) -> String {
    let mut all = Vec::new();
    for facet in domain.facets() {
        let (var, value) = &facet.fixed;
        let difference = &Poly::var(*var) - value;
        if corners.iter().all(|corner| at(&difference, corner).is_some_and(|x| x.is_zero())) {
            all.push(facet.equation);
        }
    }
    all.join(", ")
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
    let signs = domain.signs(p);
    if signs.len() > 1 {
        return Sign::Changes;
    }
    let p = if signs.contains(&-1) { -p } else { p.clone() };
    let decided = |relation: Relation| domain.decide(p.clone().into(), relation, WORK);
    if decided(Relation::Positive).is_ok() {
        return Sign::Positive;
    }
    match decided(Relation::NonNegative) {
        Ok(()) => Sign::NonNegative,
        Err(Failure::Refuted(_)) => Sign::Changes,
        Err(Failure::Undecided(_)) => Sign::Unknown,
    }
}

//! Where a function of several variables may be least or greatest: corners of the domain, and stationary points on
//! all of its faces.

use super::domain::{Face, Product};
use super::point::Point;
use super::system::System;
use crate::algebra::divisors::factor::checked_factor;
use crate::algebra::divisors::gcd::checked_gcd;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use basis_prover::collections::list::Listed;

/// What is known of these points.
#[derive(Debug, Default)]
pub(super) struct Stationary {
    /// Corners and isolated points in the domain; the same point may occur more than once.
    pub(super) points: Vec<Point>,
    /// The values on ovals of stationary points.
    pub(super) values: Vec<Rational>,
    /// Whether there are more of them on lines and curves in space, of which no factor of a level tells, and the
    /// values there.
    pub(super) others: bool,
    pub(super) on_lines: Vec<Rational>,
    /// Whether there are curves of them that reach the ends of the domain, on which the function is not 0.
    pub(super) curves: bool,
}

/// Points among which a function is least and greatest on its domain; zeros of the function that are no corners only
/// with `zeros`. `None` where they are out of reach.
///
/// Where a function does not depend on a variable of a face, or where a curve of stationary points is unbounded, its
/// values are those at other faces, too.
pub(super) fn stationary(domain: &Product, f: &Fraction, zeros: bool, work: &mut Work) -> Option<Stationary> {
    let mut all = Stationary::default();
    for face in domain.faces() {
        on_face(domain, &face, f, zeros, &mut all, work)?;
    }
    Some(all)
}

fn on_face(
    domain: &Product,
    face: &Face,
    f: &Fraction,
    zeros: bool,
    all: &mut Stationary,
    work: &mut Work,
) -> Option<()> {
    let own = face.restricted(f)?;
    if face.free.is_empty() {
        all.points.push(face.image(Point::rational(&[]), work)?);
        return Some(());
    }
    if face.free.iter().any(|(var, ..)| !own.depends_on(*var)) {
        // Lines on a facet, which no function of fewer variables explains.
        let is_line = face.free.iter().any(|(var, ..)| own.depends_on(*var));
        all.curves |=
            is_line && face.free.iter().any(|(var, ..)| f.depends_on(*var) && !own.depends_on(*var));
        return Some(());
    }
    let mut equations = Vec::new();
    for (var, ..) in &face.free {
        equations.push(own.derivative_within(*var, work)?.numer().clone());
    }
    // A factor that all of them share is a curve of stationary points.
    if let [first, others @ ..] = &equations[..]
        && !others.is_empty()
    {
        let mut common = first.clone();
        for p in others {
            common = checked_gcd(&common, p, work)?;
        }
        let is_curve = common.as_constant().is_none();
        if is_curve {
            for oval in bounded(&common, own.numer(), work)? {
                // Only of the whole domain it is looked whether there are such points.
                if face.free.len() < domain.dimension() || !domain.changes_sign(&oval) {
                    return None;
                }
                all.values.push(modulo(own.as_poly()?, &oval)?.as_constant()?);
            }
        }
        all.curves |= is_curve && own.numer().div_exact(&common).is_none();
        if is_curve {
            equations = equations.iter().map(|p| p.div_exact(&common).unwrap_or_else(Poly::zero)).listed();
        }
    }
    let nonzero = if zeros { Poly::one() } else { own.numer().clone() };
    let system = System { equations, nonzero, ranges: face.free.clone() };
    let found = system.solutions(work)?;
    // On facets, and for factors of a level, others are known.
    for graph in found.graphs.into_iter().filter(|_| face.free.len() > 2) {
        let put = |f: Fraction, (var, x): &(Var, Fraction)| f.substitute_within(*var, x, work).ok()?;
        match graph.and_then(|graph| graph.iter().try_fold(own.clone(), put)).and_then(|f| f.as_constant()) {
            Some(value) => all.on_lines.push(value),
            None => all.others = true,
        }
    }
    for point in found.points {
        let mut point = face.image(point, work)?;
        if domain.contains(&mut point, work)? {
            all.points.push(point);
        }
    }
    Some(())
}

/// The factors of a polynomial that have degree 1 in no variable, and are no factors of a function, which is 0 where
/// they are.
fn bounded(p: &Poly, of: &Poly, work: &mut Work) -> Option<Vec<Poly>> {
    let factors = checked_factor(p, work)?.1.into_iter().map(|(f, _)| f);
    let is_graph = |f: &Poly| f.variables().iter().any(|var| f.degree(*var) == 1);
    Some(factors.filter(|f| !is_graph(f) && of.div_exact(f).is_none()).listed())
}

/// The remainder on division by a polynomial whose leading coefficient in a variable is a number; `None` if there is
/// none.
fn modulo(p: &Poly, by: &Poly) -> Option<Poly> {
    let leading = |var: &Var| Some((*var, by.coefficients_in(*var).last()?.as_constant()?.recip()?));
    let (var, unit) = by.variables().iter().find_map(leading)?;
    let mut rest = p.clone();
    while rest.degree(var) >= by.degree(var) && !rest.is_zero() {
        let top = rest.coefficients_in(var).last()?.scale(&unit);
        let shift = Poly::var(var).pow(rest.degree(var) - by.degree(var));
        rest = &rest - &(&(&top * &shift) * by);
    }
    Some(rest)
}

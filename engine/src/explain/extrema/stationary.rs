//! Where a function of several variables may be least or greatest: corners of the domain, and stationary points on all of its faces.

use super::domain::{Face, Product};
use super::point::Point;
use super::system::System;
use crate::algebra::divisors::factor::checked_factor;
use crate::algebra::divisors::gcd::checked_gcd;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Poly;
use crate::algebra::work::Work;
use basis_prover::collections::list::Listed;

/// What is known of these points.
#[derive(Debug, Default)]
pub(super) struct Stationary {
    /// Corners and isolated points in the domain; the same point may occur more than once.
    pub(super) points: Vec<Point>,
    /// Whether there are more of them on lines and curves in space, which no factor of a level tells.
    pub(super) others: bool,
    /// Whether there are curves of them that reach the ends of the domain, on which the function is not 0.
    pub(super) curves: bool,
}

/// Points among which a function is least and greatest on its domain; zeros of the function that are no corners only with
/// `zeros`. `None` where they are out of reach.
///
/// Where a function does not depend on a variable of a face, or where a curve of stationary points is unbounded, its values are
/// those at other faces, too.
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
        all.others |= domain.dimension() > 2 && face.free.iter().any(|(var, ..)| own.depends_on(*var));
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
        if is_curve && !is_unbounded(&common, own.numer(), work)? {
            return None;
        }
        all.curves |= is_curve && own.numer().div_exact(&common).is_none();
        if is_curve {
            equations = equations.iter().map(|p| p.div_exact(&common).unwrap_or_else(Poly::zero)).listed();
        }
    }
    let nonzero = if zeros { Poly::one() } else { own.numer().clone() };
    let system = System { equations, nonzero, ranges: face.free.clone() };
    let found = system.solutions(work)?;
    all.others |= found.unbounded && domain.dimension() > 2;
    for point in found.points {
        let mut point = face.image(point, work)?;
        if domain.contains(&mut point, work)? {
            all.points.push(point);
        }
    }
    Some(())
}

/// Whether every factor of a polynomial has degree 1 in a variable, or is one of a function, which is 0 there.
fn is_unbounded(p: &Poly, of: &Poly, work: &mut Work) -> Option<bool> {
    let factors = checked_factor(p, work)?.1;
    let linear = |f: &Poly| f.variables().iter().any(|var| f.degree(*var) == 1);
    Some(factors.iter().all(|(f, _)| linear(f) || of.div_exact(f).is_some()))
}

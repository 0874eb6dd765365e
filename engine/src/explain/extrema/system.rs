//! Systems of polynomial equations: their solutions where variables can be put in place of one another, and of two
//! variables by a resultant.
//!
//! Equations are split into factors. One of degree 1 in a variable is solved for it; where its coefficient vanishes,
//! that is an equation of its own. Where there is none, roots of an equation in one variable are put in the others,
//! over the field that they generate, and two equations in two variables have a resultant in one.

use super::numbers;
use super::point::{Point, constant};
use crate::algebra::divisors::factor::checked_factor;
use crate::algebra::divisors::resultant::resultant;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::real::algebraic::Algebraic;
use crate::algebra::real::field::Element;
use crate::algebra::univariate::{ToPoly as _, Univariate};
use crate::algebra::work::Work;
use basis_prover::Coordinate;
use basis_prover::collections::list::Listed;
use basis_prover::collections::sort::sort_unique;

/// Resultants of a higher degree are left alone.
const MAX_DEGREE: u32 = 24;

/// The solutions of a system.
#[derive(Debug, Default)]
pub(super) struct Solutions {
    /// Those that are isolated.
    pub(super) points: Vec<Point>,
    /// Lines and graphs of solutions beside them, which reach the ends of every domain: what is put in place of
    /// variables, in order; nothing where that is irrational.
    pub(super) graphs: Vec<Option<Vec<(Var, Fraction)>>>,
}

/// Equations p = 0 where another polynomial is not zero.
#[derive(Clone)]
pub(super) struct System {
    /// The polynomials p.
    pub(super) equations: Vec<Poly>,
    /// What is not zero at the solutions that are looked for.
    pub(super) nonzero: Poly,
    /// The variables, with the numbers between which solutions are looked for.
    pub(super) ranges: Vec<(Var, Rational, Rational)>,
}

/// What is known on the way to a solution.
#[derive(Clone, Default)]
struct Known {
    /// Variables in terms of those that were solved for later, or not at all.
    solved: Vec<(Var, Fraction)>,
    /// Roots.
    roots: Vec<(Var, Coordinate)>,
}

impl System {
    /// The solutions; `None` when they are out of reach.
    pub(super) fn solutions(self, work: &mut Work) -> Option<Solutions> {
        let mut found = Solutions::default();
        self.solve(Known::default(), &mut found, work)?;
        Some(found)
    }

    fn solve(mut self, known: Known, found: &mut Solutions, work: &mut Work) -> Option<()> {
        let Some(equations) = self.split(&known, found, work)? else { return Some(()) };
        self.equations = equations;
        if let Some((k, var)) = self.linear(true) {
            let equation = self.equations.remove(k);
            return self.put(&equation, var, known, found, work);
        }
        if let Some((k, var)) = self.linear(false) {
            let equation = self.equations.remove(k);
            let parts = equation.coefficients_in(var);
            let mut other = self.clone();
            other.equations.extend(parts);
            other.solve(known.clone(), found, work)?;
            return self.put(&equation, var, known, found, work);
        }
        let single = |p: &Poly| if let [var] = p.variables()[..] { Some(var) } else { None };
        let position = self.equations.iter().position(|p| single(p).is_some());
        if let Some((k, var)) = position.and_then(|k| Some((k, single(self.equations.get(k)?)?))) {
            let equation = self.equations.remove(k);
            return self.put_roots(&equation, var, &known, found, work);
        }
        if self.equations.is_empty() {
            return self.finish(known, found, work);
        }
        self.eliminate(known, found, work)
    }

    /// The equations in factors of which none matters less than the others; nothing inside if there is no solution,
    /// or where the cases of an equation with several factors have been looked at.
    #[expect(clippy::option_option, reason = "the work may be spent")]
    fn split(&self, known: &Known, found: &mut Solutions, work: &mut Work) -> Option<Option<Vec<Poly>>> {
        if self.nonzero.is_zero() {
            return Some(None);
        }
        let mut single: Vec<Poly> = Vec::new();
        for (k, p) in self.equations.iter().enumerate().filter(|(_, p)| !p.is_zero()) {
            let factors = checked_factor(p, work)?.1;
            let matters = |f: &Poly| self.nonzero.div_exact(f).is_none();
            let own = factors.into_iter().map(|(f, _)| f).filter(matters).listed();
            match &own[..] {
                [] => return Some(None),
                [one] if single.contains(one) => {}
                [one] => single.push(one.clone()),
                several => {
                    for factor in several {
                        let mut system = self.clone();
                        system.equations[k] = factor.clone();
                        system.solve(known.clone(), found, work)?;
                    }
                    return Some(None);
                }
            }
        }
        Some(Some(single))
    }

    /// The shortest equation of degree 1 in a variable, with a number as its coefficient or not.
    fn linear(&self, by_number: bool) -> Option<(usize, Var)> {
        let variable = |p: &Poly| {
            let is_linear = |var: &Var| {
                let parts = p.coefficients_in(*var);
                parts.len() == 2 && (parts[1].as_constant().is_some() == by_number)
            };
            p.variables().into_iter().find(is_linear)
        };
        let all = self.equations.iter().enumerate();
        let all = all.filter_map(|(k, p)| Some((p.total_degree(), p.len(), k, variable(p)?)));
        all.min().map(|(_, _, k, var)| (k, var))
    }

    /// Solves an equation for a variable.
    fn put(
        mut self,
        equation: &Poly,
        var: Var,
        mut known: Known,
        found: &mut Solutions,
        work: &mut Work,
    ) -> Option<()> {
        let [rest, slope] = <[Poly; 2]>::try_from(equation.coefficients_in(var)).ok()?;
        let value = Fraction::from(-&rest).div_within(&Fraction::from(slope), work).ok()??;
        for p in self.equations.iter_mut().chain([&mut self.nonzero]) {
            let put = Fraction::from(p.clone()).substitute_within(var, &value, work).ok()?;
            *p = put?.numer().clone();
        }
        known.solved.push((var, value));
        self.solve(known, found, work)
    }

    /// Puts the roots of an equation in one variable in its place.
    fn put_roots(
        mut self,
        equation: &Poly,
        var: Var,
        known: &Known,
        found: &mut Solutions,
        work: &mut Work,
    ) -> Option<()> {
        let mut equation = Univariate::from_poly(equation, var)?;
        // Others in the same variable have the roots in common.
        let others = self.equations.iter().filter_map(|p| Univariate::from_poly(p, var)).listed();
        self.equations.retain(|p| Univariate::from_poly(p, var).is_none());
        for other in &others {
            equation = equation.gcd(other, work)?;
        }
        let (_, low, high) = self.ranges.iter().find(|(v, ..)| *v == var)?;
        for root in numbers::roots(&equation, low, high, work)? {
            let (mut system, mut known) = (self.clone(), known.clone());
            known.roots.push((var, root.clone()));
            match root {
                Coordinate::Rational(x) => {
                    for p in system.equations.iter_mut().chain([&mut system.nonzero]) {
                        *p = p.at(var, &x);
                    }
                    system.solve(known, found, work)?;
                }
                Coordinate::Algebraic(_) => {
                    let (own, others) =
                        core::mem::take(&mut system.equations).into_iter().partition(|p| p.depends_on(var));
                    system.equations = others;
                    let own: Vec<Poly> = own;
                    if own.is_empty() {
                        system.solve(known, found, work)?;
                    } else {
                        system.over_field(&own, &known, found, work)?;
                    }
                }
            }
        }
        Some(())
    }

    /// Solves equations for the only variable beside those that have irrational values.
    fn over_field(&self, own: &[Poly], known: &Known, found: &mut Solutions, work: &mut Work) -> Option<()> {
        let has_root = |var: &Var| known.roots.iter().any(|(v, _)| v == var);
        let mut others = own.iter().flat_map(Poly::variables).filter(|v| !has_root(v)).listed();
        others.dedup();
        let (Some(var), true) = (others.first().copied(), self.equations.is_empty()) else { return None };
        if others.iter().any(|v| *v != var) {
            return None;
        }
        let mut point = known.point(work)?;
        let mut common: Option<Vec<Element>> = None;
        for p in own {
            let mut coefficients = Vec::new();
            for c in p.coefficients_in(var) {
                coefficients.push(point.eval(&c, work)?);
            }
            let before = common.unwrap_or_default();
            common = Some(point.field()?.common_divisor(before, coefficients, work)?);
        }
        let common = common?;
        if let [c, d] = &common[..] {
            let field = point.field()?;
            let inverse = field.inverse(d, work)?;
            let x = field.mul(&c.scale(&Rational::from(-1)), &inverse, work)?;
            self.complete(known, point.with(var, x), found, work)?;
            return Some(());
        }
        if common.len() < 2 {
            return Some(());
        }
        // The roots of all conjugates, of which those remain at which the equations hold.
        let (x, z) = (var, Var(var.0 + 1));
        let mut whole = Poly::zero();
        for (k, c) in common.iter().enumerate() {
            whole = &whole + &(&c.to_poly(z) * &Poly::var(x).pow(k as u32));
        }
        let norm = resultant(&point.field()?.root().polynomial().to_poly(z), &whole, z, work)?;
        let (_, low, high) = self.ranges.iter().find(|(v, ..)| *v == var)?;
        let norm = Univariate::from_poly(&norm, x)?;
        for root in numbers::roots(&norm, low, high, work)? {
            let mut point = match &root {
                Coordinate::Rational(r) => point.clone().with(var, constant(r)),
                Coordinate::Algebraic(r) => point.clone().with_root(var, r, work)?,
            };
            let mut holds = true;
            for p in own {
                let value = point.eval(p, work)?;
                holds = holds && point.sign(&value, work)? == 0;
            }
            if holds {
                self.complete(known, point, found, work)?;
            }
        }
        Some(())
    }

    /// All equations have been solved.
    fn finish(&self, known: Known, found: &mut Solutions, work: &mut Work) -> Option<()> {
        let is_known = |var: Var| {
            known.solved.iter().any(|(v, _)| *v == var) || known.roots.iter().any(|(v, _)| *v == var)
        };
        if self.ranges.iter().any(|(var, ..)| !is_known(*var)) {
            let rational = |(var, x): &(Var, Coordinate)| match x {
                Coordinate::Rational(x) => Some((*var, Fraction::constant(x.clone()))),
                Coordinate::Algebraic(_) => None,
            };
            let roots: Option<Vec<_>> = known.roots.iter().map(rational).collect();
            found.graphs.push(roots.map(|roots| [known.solved, roots].concat()));
            return Some(());
        }
        let point = known.point(work)?;
        self.complete(&known, point, found, work)
    }

    /// Adds the solution that has these coordinates.
    fn complete(
        &self,
        known: &Known,
        mut point: Point,
        found: &mut Solutions,
        work: &mut Work,
    ) -> Option<()> {
        for (var, value) in known.solved.iter().rev() {
            // Where the denominator vanishes there is another case.
            let Some(x) = point.quotient(value, work)? else { return Some(()) };
            point = point.with(*var, x);
        }
        if self.ranges.iter().all(|(var, ..)| point.has(*var)) {
            found.points.push(point);
        } else {
            found.graphs.push(None);
        }
        Some(())
    }

    /// Adds a resultant of two equations.
    fn eliminate(mut self, known: Known, found: &mut Solutions, work: &mut Work) -> Option<()> {
        let mut variables = self.equations.iter().flat_map(Poly::variables).listed();
        sort_unique(&mut variables);
        let ([first, second, ..], [x, y]) = (&self.equations[..], &variables[..]) else { return None };
        let degree = |var: Var| first.degree(var) * second.degree(var);
        let (x, _) = if degree(*x) <= degree(*y) { (*x, *y) } else { (*y, *x) };
        if first.total_degree() * second.total_degree() > MAX_DEGREE {
            return None;
        }
        let eliminated = resultant(first, second, x, work)?;
        if eliminated.is_zero() {
            return None;
        }
        self.equations.push(eliminated);
        self.solve(known, found, work)
    }
}

impl Known {
    /// The roots as a point.
    fn point(&self, work: &mut Work) -> Option<Point> {
        let mut roots: Vec<(Var, Algebraic)> = Vec::new();
        let mut rational = Vec::new();
        for (var, root) in &self.roots {
            match root {
                Coordinate::Rational(x) => rational.push((*var, constant(x))),
                Coordinate::Algebraic(x) => roots.push((*var, x.clone())),
            }
        }
        let point = Point::irrational(&roots, work)?;
        Some(rational.into_iter().fold(point, |point, (var, x)| point.with(var, x)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use basis_prover::collections::list::Mapped as _;

    fn solved(equations: &[Poly]) -> Vec<Vec<String>> {
        let range = |k: usize| (Var(k), Rational::from(-10), Rational::from(10));
        let system =
            System { equations: equations.to_vec(), nonzero: Poly::one(), ranges: vec![range(0), range(1)] };
        let work = &mut Work::unlimited();
        let found = system.solutions(work).expect("within reach");
        assert!(found.graphs.is_empty());
        let mut all = found.points.mapped(|point| {
            let of = |k: usize| {
                numbers::text(&point.number(&point.element(Var(k)), &mut Work::unlimited()).unwrap())
            };
            vec![of(0), of(1)]
        });
        all.sort();
        all.dedup();
        all
    }

    #[test]
    fn circles_and_lines() {
        let (x, y) = (Poly::var(Var(0)), Poly::var(Var(1)));
        let n = Poly::integer;
        let circle = &(&(&x * &x) + &(&y * &y)) - &n(4);
        assert_eq!(solved(&[circle.clone(), &x - &y]), [["-sqrt(2)", "-sqrt(2)"], ["sqrt(2)", "sqrt(2)"]]);
        // x·y = 1 has the coefficient x.
        let found = solved(&[circle.clone(), &(&x * &y) - &n(1)]);
        assert_eq!(found.len(), 4);
        // Neither is linear: x² + y² = 4 and x² = y² + y, where y = (−1 ± √33)/4.
        let other = &(&x * &x) - &(&(&y * &y) + &y);
        let found = solved(&[circle.clone(), other]);
        assert_eq!(found.len(), 4, "{found:?}");
        assert!(found.iter().filter(|p| p[1] == "-1/4 + 1/4*sqrt(33)").count() == 2, "{found:?}");
        // x² = 2 and y² = 3 in a field of degree 4.
        let found = solved(&[&(&x * &x) - &n(2), &(&y * &y) - &n(3)]);
        assert_eq!(found.len(), 4);
        assert_eq!(found[0], ["-sqrt(2)", "-sqrt(3)"]);
        assert!(solved(&[circle, &x - &n(3)]).is_empty());
    }
}

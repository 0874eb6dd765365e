//! Zeros, least and greatest values of functions of several variables.

use core::cmp::Ordering;

use super::bounds;
use super::domain::{Product, at};
use super::level::{Level, level};
use super::numbers;
use super::point::Point;
use super::stationary::{Stationary, stationary};
use super::{Extrema, Extremum, Found, Locus, LocusKind};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::Family;
use basis_kernel::{Relation, Statement};
use basis_prover::collections::list::Listed;
use basis_prover::{Coordinate, decide};

/// The steps of the lattice on which a negative value is looked for.
const STEPS: i64 = 4;

/// What is known of a function, whose shape parameters have values, under its name.
pub(super) fn of_function(family: &Family, label: &str, f: &Fraction, work: &mut Work) -> Found {
    let Some(domain) = Product::of(family, f) else {
        return Found::Open(String::from("an end of its domain is not finite"));
    };
    let vars = domain.vars();
    let only = |p: &Poly| p.variables().iter().all(|var| vars.contains(var));
    if !only(f.numer()) || !only(f.denom()) {
        return Found::Open(String::from("it contains a number that is not rational"));
    }
    if family.analytic.angles.iter().any(|angle| vars.contains(&angle.var)) {
        return Found::Open(String::from(
            "a variable stands in a sine or an exponential, or between ends that are not rational",
        ));
    }
    if let Some(value) = f.as_constant() {
        if !value.is_negative() {
            return Found::Nonnegative;
        }
        let everywhere = Locus { kind: LocusKind::Domain, equation: String::new() };
        let extremum = Extremum { value: value.to_string(), at: Vec::new(), on: vec![everywhere] };
        return Found::Known(Box::new(Extrema::new(label, extremum.clone(), extremum)));
    }
    let signs = |relation: Relation, p: &Poly| {
        let sign = Statement::Sign { value: p.clone().into(), relation, domain: domain.domain() };
        decide(sign, &Vec::new(), 1).is_ok()
    };
    // With a denominator that is positive.
    let (numer, denom) = if f.denom().as_constant().is_some() || signs(Relation::Positive, f.denom()) {
        (f.numer().clone(), f.denom().clone())
    } else if signs(Relation::Positive, &-f.denom()) {
        (-f.numer(), -f.denom())
    } else {
        return Found::Open(String::from("its denominator vanishes at the end of its domain"));
    };
    let points = domain.corners().into_iter().chain(domain.lattice(STEPS));
    let is_negative = points.filter_map(|point| at(&numer, &point)).any(|x| x.is_negative());
    if !is_negative && signs(Relation::NonNegative, &numer) {
        return Found::Nonnegative;
    }
    let free = family.domain.len() - domain.dimension();
    let problem = Problem { domain, numer, denom, free };
    match problem.exact(label, f, work) {
        Some(found) => found,
        None => problem.between(label, work),
    }
}

/// A function on a domain, its denominator positive.
struct Problem {
    domain: Product,
    numer: Poly,
    denom: Poly,
    /// The dimensions of the family's domain beside those of this one.
    free: usize,
}

impl Problem {
    fn exact(&self, label: &str, f: &Fraction, work: &mut Work) -> Option<Found> {
        let found = stationary(&self.domain, f, false, work)?;
        let least = self.extreme(f, &found, Ordering::Less, work)?;
        let zero = Coordinate::Rational(Rational::ZERO);
        if numbers::compare(&least.0, &zero, work)? != Ordering::Less {
            return Some(Found::Nonnegative);
        }
        let greatest = self.extreme(f, &found, Ordering::Greater, work)?;
        let (minimum, open) = self.extremum(least, &found, work)?;
        let (maximum, also_open) = self.extremum(greatest, &found, work)?;
        let mut all = Extrema::new(label, minimum, maximum);
        all.is_open = open || also_open;
        self.put_zeros(&mut all, work)?;
        Some(Found::Known(Box::new(all)))
    }

    /// The zeros.
    fn put_zeros(&self, all: &mut Extrema, work: &mut Work) -> Option<()> {
        let zeros = level(&self.domain, &self.numer, None, self.free, work)?;
        all.zeros_are_open = zeros.open;
        (all.zeros, all.zeros_on) = self.written(zeros, work)?;
        Some(())
    }

    /// The extreme value of some, and the points that have it.
    fn extreme(
        &self,
        f: &Fraction,
        found: &Stationary,
        wanted: Ordering,
        work: &mut Work,
    ) -> Option<(Coordinate, Vec<Point>)> {
        let mut values = Vec::new();
        for point in &found.points {
            let mut point = point.clone();
            let Some(value) = point.quotient(f, work)? else { continue };
            let bounds = point.bounds(&value, work)?;
            values.push((bounds, value, point));
        }
        // Those that are seen not to be extreme are not computed.
        let best = match wanted {
            Ordering::Less => values.iter().map(|((_, high), ..)| high).min()?.clone(),
            _ => values.iter().map(|((low, _), ..)| low).max()?.clone(),
        };
        values
            .retain(|((low, high), ..)| if wanted == Ordering::Less { low <= &best } else { high >= &best });
        let mut extreme: Option<(Coordinate, Vec<Point>)> = None;
        for (_, value, point) in values {
            let value = point.number(&value, work)?;
            match &mut extreme {
                None => extreme = Some((value, vec![point])),
                Some((known, at)) => match numbers::compare(&value, known, work)? {
                    Ordering::Equal => at.push(point),
                    order if order == wanted => extreme = Some((value, vec![point])),
                    _ => {}
                },
            }
        }
        extreme
    }

    /// A value with the points that have it, and whether there may be more of them.
    fn extremum(
        &self,
        (value, points): (Coordinate, Vec<Point>),
        found: &Stationary,
        work: &mut Work,
    ) -> Option<(Extremum, bool)> {
        let (at, open) = match &value {
            Coordinate::Rational(c) => {
                let p = &self.numer - &self.denom.scale(c);
                // Where a function is 0 it has other stationary points.
                let known = if c.is_zero() { None } else { Some(&points[..]) };
                let at = level(&self.domain, &p, known, self.free, work)?;
                let open = at.open || found.others;
                (at, open)
            }
            Coordinate::Algebraic(_) => match self.domain.of_one(&self.numer) {
                Some((name, ..)) if self.denom.as_constant().is_some() && self.domain.dimension() > 1 => {
                    let mut loci: Vec<Locus> = Vec::new();
                    for point in &points {
                        let x = point.number(&self.domain.coordinate(&name, point)?, work)?;
                        let equation = format!("{name} = {}", numbers::text(&x));
                        let kind = LocusKind::new(self.domain.dimension() + self.free - 1, true);
                        if loci.iter().all(|known| known.equation != equation) {
                            loci.push(Locus { kind, equation });
                        }
                    }
                    (Level { loci, ..Level::default() }, false)
                }
                _ => (Level { points, ..Level::default() }, found.others || found.curves),
            },
        };
        let (at, on) = self.written(at, work)?;
        Some((Extremum { value: numbers::text(&value), at, on }, open))
    }

    /// Points, each once, and loci; points as loci where further variables are free.
    fn written(&self, found: Level, work: &mut Work) -> Option<(Vec<String>, Vec<Locus>)> {
        let mut at: Vec<String> = Vec::new();
        for point in &found.points {
            let text = self.domain.written(point, work)?;
            if !at.contains(&text) {
                at.push(text);
            }
        }
        if self.free == 0 {
            return Some((at, found.loci));
        }
        let loci = at.into_iter().map(|equation| Locus { kind: LocusKind::new(self.free, true), equation });
        let loci = found.loci.into_iter().chain(loci).listed();
        Some((Vec::new(), loci))
    }

    /// Proved bounds of the extreme values.
    fn between(&self, label: &str, work: &mut Work) -> Found {
        let bound = |negative: bool| {
            let numer = if negative { -&self.numer } else { self.numer.clone() };
            bounds::least(&self.domain, &numer, &self.denom)
        };
        let (least, greatest) = (bound(false), bound(true));
        let between = |(low, high): (Rational, Rational)| Extremum {
            value: format!("between {} and {}", numbers::short(&low), numbers::short(&high)),
            at: Vec::new(),
            on: Vec::new(),
        };
        let (Some(least), Some((low, high))) = (least, greatest) else {
            return Found::Open(String::from("its stationary points are out of reach"));
        };
        if !least.1.is_negative() {
            return Found::Open(String::from("it is not decided whether it is negative somewhere"));
        }
        let mut all = Extrema::new(label, between(least), between((-high, -low)));
        all.are_bounds = true;
        if self.put_zeros(&mut all, work).is_none() {
            all.zeros_are_open = true;
        }
        Found::Known(Box::new(all))
    }
}

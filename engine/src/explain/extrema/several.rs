//! Zeros, least and greatest values of functions of several variables.

use core::cmp::Ordering;

use super::bounds;
use super::domain::{Product, at};
use super::level::{Level, level};
use super::numbers;
use super::point::{Point, constant};
use super::stationary::{Stationary, stationary};
use super::{Extrema, Extremum, Found, Locus, LocusKind};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::Family;
use basis_kernel::{Quotient, Relation};
use basis_prover::Coordinate;
use basis_prover::collections::list::Listed;
use basis_prover::collections::sort::sort_by;

/// The steps of the lattice on which a negative value is looked for.
const STEPS: i64 = 4;
/// Domains of more dimensions have too many faces.
const MAX_DIMENSION: usize = 3;
/// The work for the sign of a function.
const SIGN: u64 = 1_000_000;
/// The work for the zeros of a function whose stationary points take too much.
const ZEROS: u64 = 300_000;

/// What is known of a function, whose shape parameters have values, under its name.
pub(super) fn of_function(family: &Family, label: &str, f: &Fraction, work: &mut Work) -> Found {
    let Some((domain, f)) = Product::of(family, f) else {
        return Found::Open(String::from("an end of its domain is not finite"));
    };
    let vars = domain.vars();
    let only = |p: &Poly| p.variables().iter().all(|var| vars.contains(var));
    if !only(f.numer()) || !only(f.denom()) {
        return Found::Open(String::from("it contains a number that is not rational"));
    }
    if let Some(value) = f.as_constant() {
        if !value.is_negative() {
            return Found::Nonnegative;
        }
        let everywhere = Locus { kind: LocusKind::Domain, equation: String::new() };
        let extremum = Extremum { value: value.to_string(), at: Vec::new(), on: vec![everywhere] };
        return Found::Known(Box::new(Extrema::new(label, extremum.clone(), extremum)));
    }
    let is_so = |relation: Relation, value: Quotient| domain.decide(value, relation, SIGN).is_ok();
    if family.domain.len() > MAX_DIMENSION {
        if is_so(Relation::NonNegative, f.quotient()) {
            return Found::Nonnegative;
        }
        return Found::Open(format!("its domain has more than {MAX_DIMENSION} dimensions"));
    }
    let signs = |relation: Relation, p: &Poly| is_so(relation, p.clone().into());
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
    match problem.exact(label, &f, work) {
        Some(found) => found,
        None => problem.between(label),
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
        let least = extreme(f, &found, Ordering::Less, work)?;
        let zero = Coordinate::Rational(Rational::ZERO);
        if numbers::compare(&least.0, &zero, work)? != Ordering::Less {
            return Some(Found::Nonnegative);
        }
        let mut greatest = extreme(f, &found, Ordering::Greater, work)?;
        let zeros = level(&self.domain, &self.numer, None, self.free, work)?;
        if numbers::compare(&greatest.0, &zero, work)? == Ordering::Less {
            // Stationary points that are zeros have been left out.
            if zeros.open {
                return None;
            }
            if !zeros.loci.is_empty() || !zeros.points.is_empty() {
                greatest = (zero, Vec::new());
            }
        }
        let (minimum, open) = self.extremum(least, &found, work)?;
        let (maximum, also_open) = self.extremum(greatest, &found, work)?;
        let mut all = Extrema::new(label, minimum, maximum);
        all.is_open = open || also_open;
        self.put_zeros(&mut all, zeros, work)?;
        Some(Found::Known(Box::new(all)))
    }

    /// The zeros.
    fn put_zeros(&self, all: &mut Extrema, zeros: Level, work: &mut Work) -> Option<()> {
        all.zeros_are_open = zeros.open;
        (all.zeros, all.zeros_on) = self.written(zeros, work)?;
        Some(())
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
                let open = at.open || at.touches && (found.others || found.on_lines.contains(c));
                (at, open)
            }
            Coordinate::Algebraic(_) => (Level { points, ..Level::default() }, found.others || found.curves),
        };
        let (at, on) = self.written(at, work)?;
        Some((Extremum { value: numbers::text(&value), at, on }, open))
    }

    /// Points, each once, and loci; points as loci where further variables are free.
    fn written(&self, found: Level, work: &mut Work) -> Option<(Vec<String>, Vec<Locus>)> {
        let mut at: Vec<String> = Vec::new();
        let mut loci = found.loci;
        let is_used = |var: &Var| self.numer.depends_on(*var) || self.denom.depends_on(*var);
        let used = self.domain.vars().into_iter().filter(is_used).listed();
        let further = self.domain.dimension() - used.len();
        for mut point in found.points {
            // The function does not depend on some coordinates.
            if self.free > 0 || further > 0 && self.domain.is_line(&used, &mut point, work)? {
                let mut equations = Vec::new();
                for var in &used {
                    let x = point.number(&point.element(*var), work)?;
                    equations.push(self.domain.at(*var, &x));
                }
                let kind = LocusKind::new(self.free + further, true);
                let locus = Locus { kind, equation: equations.join(", ") };
                if !loci.contains(&locus) {
                    loci.push(locus);
                }
                continue;
            }
            let text = self.domain.written(&point, work)?;
            if !at.contains(&text) {
                at.push(text);
            }
        }
        sort_by(&mut loci, |a, b| {
            let key = |l: &Locus| (l.equation.chars().count(), l.equation.clone());
            key(a).cmp(&key(b))
        });
        Some((at, loci))
    }

    /// Proved bounds of the extreme values.
    fn between(&self, label: &str) -> Found {
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
        let work = &mut Work::new(ZEROS);
        let zeros = level(&self.domain, &self.numer, None, self.free, work);
        if zeros.and_then(|zeros| self.put_zeros(&mut all, zeros, work)).is_none() {
            all.zeros_are_open = true;
        }
        Found::Known(Box::new(all))
    }
}

/// The extreme value of some, and the points that have it.
fn extreme(
    f: &Fraction,
    found: &Stationary,
    wanted: Ordering,
    work: &mut Work,
) -> Option<(Coordinate, Vec<Point>)> {
    let mut values = Vec::new();
    for value in &found.values {
        values.push(((value.clone(), value.clone()), constant(value), None));
    }
    for point in &found.points {
        let mut point = point.clone();
        let Some(value) = point.quotient(f, work)? else { continue };
        let bounds = point.bounds(&value, work)?;
        values.push((bounds, value, Some(point)));
    }
    // Those that are seen not to be extreme are not computed.
    let best = match wanted {
        Ordering::Less => values.iter().map(|((_, high), ..)| high).min()?.clone(),
        _ => values.iter().map(|((low, _), ..)| low).max()?.clone(),
    };
    values.retain(|((low, high), ..)| if wanted == Ordering::Less { low <= &best } else { high >= &best });
    let mut extreme: Option<(Coordinate, Vec<Point>)> = None;
    for (_, value, point) in values {
        let value = match &point {
            Some(point) => point.number(&value, work)?,
            None => Coordinate::Rational(value.leading()),
        };
        let own = point.into_iter();
        match &mut extreme {
            None => extreme = Some((value, own.listed())),
            Some((known, at)) => match numbers::compare(&value, known, work)? {
                Ordering::Equal => at.extend(own),
                order if order == wanted => extreme = Some((value, own.listed())),
                _ => {}
            },
        }
    }
    extreme
}

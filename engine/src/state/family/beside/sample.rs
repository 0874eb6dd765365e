//! Points of a domain with an angle at which functions are looked at: their signs there, and where they may be smallest.

use basis_kernel::{Domain, Quotient, Relation, Statement};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::{Coordinate, Counterexample, Symmetries, candidates, decide, refute, typical};
use std::rc::Rc;

use super::values::{ENCLOSURE, Enclosures, PRODUCT, Values, between, cost, enclosures, of_poly, put};
use super::{Half, Where};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::Family;
use crate::model::angle::{Angle, Kind};
use basis_prover::collections::sort::sort_by;

/// Combinations of shape values, at most.
const MAX_SHAPES: usize = 16;

/// Places in the domain between its ends, and values of a parameter.
const PLACES: i64 = 16;
const SHAPES: i64 = 8;

/// The parts of a range that lie between an end that is left out and the parameters next to it.
const NEXT_TO_ENDS: [i64; 2] = [1 << 12, 1 << 20];

/// The common denominator of the numbers that stand for π, exp(r) and the like.
const NEAR: i64 = 1 << 40;

/// Work above which the signs of a function are looked at in fewer places.
const LOOKING: u64 = 150_000;

/// Of points at which a function is looked at anyway, how many are tried first where it may be below 0.
const SIMPLE: usize = 8;

/// How often the distance to a place where a function is small is halved.
const NEARER: u32 = 6;

/// Points of a family at which functions are looked at.
pub(in crate::state::family) struct Sample<'f> {
    family: &'f Family,
    /// By values of the shape parameters points of the domain from its lower to its upper end.
    rows: Vec<Vec<(Values, Enclosures)>>,
    /// What has to be true of a point to count.
    premises: Vec<(Poly, Relation)>,
}

impl<'f> Sample<'f> {
    /// Points for functions of a family, without a domain variable that is fixed.
    pub(in crate::state::family) fn new(family: &'f Family, work: &mut Work) -> Option<Self> {
        Self::at(Where::Everywhere, family, work)
    }

    /// The same for some parameters.
    pub(super) fn at(at: Where, family: &'f Family, work: &mut Work) -> Option<Self> {
        let (var, low, high) = family.interval()?;
        let own = |range: &Range| {
            let mut all: Vec<Rational> = match range.finite() {
                Some((a, b)) => {
                    [0, 1, 4, 7, 8].into_iter().map(|k| a + &(&(b - a) * &Rational::new(k, SHAPES))).listed()
                }
                None => candidates(range, 4),
            };
            all.retain(|x| range.contains(x));
            // The middle first, and of a range without an end what is far out or next to the other one.
            let middle = all.len() / 2;
            all.rotate_left(middle);
            if range.finite().is_none() {
                let far = [(64, 1), (1, 16), (1 << 12, 1), (1, 1 << 12), (-64, 1), (-1, 16)];
                let far = far.map(|(above, below)| Rational::new(above, below));
                all.extend(far.into_iter().filter(|x| range.contains(x)));
            }
            if let (Where::NextToEnds, Some((a, b))) = (at, range.finite()) {
                all.truncate(1);
                for share in NEXT_TO_ENDS {
                    let step = &(b - a) * &Rational::new(1, share);
                    all.extend((!range.low.is_included()).then(|| a + &step));
                    all.extend((!range.high.is_included()).then(|| b - &step));
                }
            }
            // Where exponentials have no largest value, far out as well: tanh(a/2) = 63/64 at a = 4.84, and a = 13.9.
            let far = family.analytic.angles.iter().any(|angle| {
                let fits = angle.kind == Kind::Hyperbolic && range.high == End::Excluded(Rational::ONE);
                fits && angle.ends[1].is_empty() && family.region().range(angle.var) == *range
            });
            if far {
                all.extend([15, 63, (1 << 20) - 1].map(|k| Rational::new(k, k + 1)));
            }
            all
        };
        let mut shapes: Vec<Values> = vec![Vec::new()];
        for parameter in &family.shapes {
            let values = own(&parameter.range);
            let mut next: Vec<Values> = Vec::new();
            // Of many parameters not all combinations, but each value with some of the others.
            for (k, x) in values.iter().enumerate() {
                for (i, shape) in shapes.iter().enumerate() {
                    if shapes.len() * values.len() <= MAX_SHAPES || (i + k) % values.len() == 0 || i == 0 {
                        next.push([shape.as_slice(), &[(parameter.var, x.clone())]].concat());
                    }
                }
            }
            next.truncate(MAX_SHAPES);
            shapes = next;
        }
        let range = &family.domain.first()?.range;
        let places: Vec<Rational> = (0..=PLACES)
            .map(|k| low + &(&(high - low) * &Rational::new(k, PLACES)))
            .filter(|x| range.contains(x))
            .listed();
        let all = (shapes.len() * places.len()) as u64;
        work.spend(all * ENCLOSURE * family.analytic.angles.len() as u64)?;
        let mut rows = Vec::new();
        for shape in shapes {
            let mut row = Vec::new();
            for place in &places {
                let point = [shape.as_slice(), &[(var, place.clone())]].concat();
                if let Some(found) = enclosures(family, &point) {
                    row.push((point, found));
                }
            }
            rows.push(row);
        }
        Some(Self { family, rows, premises: Vec::new() })
    }

    /// The points at which the premises of a statement hold.
    pub(super) fn under(mut self, premises: &[(Poly, Relation)]) -> Self {
        self.premises = premises.to_vec();
        for row in &mut self.rows {
            row.retain(|(point, _)| hold(premises, point));
        }
        self.rows.retain(|row| !row.is_empty());
        self
    }

    /// Counts the work of looking at a function at all points.
    fn look_at(&self, f: &Fraction, work: &mut Work) -> Option<()> {
        let points: usize = self.rows.iter().map(Vec::len).sum();
        work.spend(points as u64 * cost(self.family, f))
    }

    /// The points on one side of the angle 0; `None` if there are none.
    pub(super) fn half(&self, angle: &Angle, half: Half, work: &mut Work) -> Option<Self> {
        self.look_at(&angle.tangent(), work)?;
        let fits = |(point, found): &&(Values, Enclosures)| {
            let sign =
                between(&angle.tangent(), point, &found.between).map(|(a, b)| (a.signum(), b.signum()));
            matches!((sign, half), (Some((_, -1)), Half::Below) | (Some((1, _)), Half::Above))
        };
        let rows = self.rows.mapped(|row| row.iter().filter(fits).cloned().listed());
        let some = rows.iter().all(|row| !row.is_empty());
        some.then_some(Self { family: self.family, rows, premises: self.premises.clone() })
    }

    /// The signs of a function by shape values along the domain; what is not seen, or not defined, is left out. Long
    /// functions are looked at in fewer places.
    pub(super) fn signs(&self, f: &Fraction, work: &mut Work) -> Option<Vec<Vec<i32>>> {
        let (points, each) = (self.rows.iter().map(Vec::len).sum::<usize>() as u64, cost(self.family, f));
        let stride = [1, 2, 4].into_iter().find(|n| points / n * each <= LOOKING).unwrap_or(4);
        work.spend(points / stride * each)?;
        let sign = |(point, found): &(Values, Enclosures)| {
            let f = found.exact.iter().rev().try_fold(f.clone(), |f, (var, x)| {
                if f.depends_on(*var) { put(&f, *var, x) } else { Some(f) }
            })?;
            let (low, high) = between(&f, point, &found.between)?;
            match (low.signum(), high.signum()) {
                (1, _) => Some(1),
                (_, -1) => Some(-1),
                (0, 0) => Some(0),
                _ => None,
            }
        };
        Some(self.rows.mapped(|row| row.iter().step_by(stride as usize).filter_map(sign).listed()))
    }

    /// By shape values the signs of the Bernstein coefficients of a polynomial, raised to a degree; 0 for what is not
    /// seen.
    pub(super) fn bernstein(
        &self,
        p: &Poly,
        var: Var,
        (low, high): (&Rational, &Rational),
        degree: u32,
        work: &mut Work,
    ) -> Option<Vec<Vec<i32>>> {
        let sums = u64::from(degree + 1).pow(2) * PRODUCT;
        work.spend(self.rows.len() as u64 * (cost(self.family, &Fraction::from(p.clone())) + sums))?;
        // p(low + width·x) = Σ cᵢ·xⁱ = Σ bᵢ·B(n, i), bᵢ = Σ binomial(i, k)/binomial(n, k)·cₖ.
        let moved = &Poly::constant(low.clone()) + &Poly::var(var).scale(&(high - low));
        let power = p.substitute(var, &moved).coefficients_in(var);
        let mut all = Vec::new();
        for row in &self.rows {
            let Some((point, found)) = row.get(row.len() / 2) else { continue };
            let c = power.mapped(|c| of_poly(c, point, &found.between));
            let mut signs = Vec::new();
            for i in 0..=degree {
                let mut sum = Some((Rational::ZERO, Rational::ZERO));
                let mut factor = Rational::ONE;
                for (k, c) in (0..=i).zip(&c) {
                    sum = sum
                        .zip(c.as_ref())
                        .map(|(sum, c)| (&sum.0 + &(&c.0 * &factor), &sum.1 + &(&c.1 * &factor)));
                    factor = &factor * &Rational::new(i64::from(i - k), i64::from((degree - k).max(1)));
                }
                signs.push(sum.map_or(0, |(a, b)| match (a.signum(), b.signum()) {
                    (1, _) => 1,
                    (_, -1) => -1,
                    _ => 0,
                }));
            }
            all.push(signs);
        }
        Some(all)
    }

    /// The points at which a function may be smallest: by shape values the one with the smallest value if that may be
    /// below 0, then points nearer and nearer to one with a smaller value.
    pub(super) fn lowest(&self, f: &Fraction, work: &mut Work) -> Option<Vec<Values>> {
        work.spend(cost(self.family, f))?;
        let near = with_numbers_near(self.family, f);
        let f = near.as_ref().unwrap_or(f);
        // Long functions are looked at in fewer places.
        let each = cost(self.family, f);
        let all_work =
            |n: usize| self.rows.iter().map(|row| row.len().div_ceil(n)).sum::<usize>() as u64 * each;
        let stride = [1, 2, 4, 8, 16].into_iter().find(|n| all_work(*n) <= work.left() / 4);
        if stride != Some(1) {
            basis_prover::done_less_often();
        }
        let stride = stride?;
        work.spend(all_work(stride))?;
        let nearer = ENCLOSURE * self.family.analytic.angles.len() as u64 + each;
        // Along the domain variable, and along the parameters between numbers.
        let region = self.family.region();
        let along = |(k, (var, _)): (usize, &(Var, Rational))| {
            let range = region.range(*var);
            let (low, high) = range.finite()?;
            let own = self.family.domain.iter().any(|p| p.var == *var);
            let width = &(high - low) * &Rational::new(1, if own { 2 * PLACES } else { 2 * SHAPES });
            Some((k, range.clone(), width))
        };
        let point = self.rows.iter().flatten().next().map(|(point, _)| point.as_slice()).unwrap_or_default();
        let ways = point.iter().enumerate().rev().filter_map(along).listed();
        // As often as half of the work that is left allows; the other half is for the proof.
        let round = 2 * (self.rows.len() * ways.len().max(1)) as u64 * nearer;
        let rounds = u64::from(NEARER).min(work.left() / 2 / round.max(1));
        if rounds < u64::from(NEARER) {
            basis_prover::done_less_often();
        }
        work.spend(rounds * round)?;
        let value = |point: &Values, found: &Enclosures| {
            let (low, high) = between(f, point, &found.between)?;
            Some((&low + &high, low.is_positive()))
        };
        let mut first: Vec<(Rational, Values)> = Vec::new();
        let mut all: Vec<(Rational, Values)> = Vec::new();
        for row in &self.rows {
            let mut best: Option<(Rational, Values, bool)> = None;
            for (point, found) in row.iter().step_by(stride) {
                let Some((x, is_above)) = value(point, found) else { continue };
                if best.as_ref().is_none_or(|(least, ..)| x < *least) {
                    best = Some((x, point.clone(), is_above));
                }
            }
            let Some((mut least, mut point, is_above)) = best else { continue };
            // What seems to be lower next to an end may be so by the width of its enclosure only.
            if !is_above {
                first.push((least.clone(), point.clone()));
            }
            for halved in 0..rounds {
                for (k, range, width) in &ways {
                    let step = width * &Rational::new(1, 1 << halved);
                    for sign in [-1, 1] {
                        let mut next = point.clone();
                        next[*k].1 += &(&step * &Rational::from(sign));
                        if !range.contains(&next[*k].1) || !hold(&self.premises, &next) {
                            continue;
                        }
                        let Some(found) = enclosures(self.family, &next) else { continue };
                        if let Some((x, _)) = value(&next, &found).filter(|(x, _)| *x < least) {
                            (least, point) = (x, next);
                        }
                    }
                }
            }
            all.push((least, point));
        }
        // Those with short coordinates first.
        let bits = |point: &Values| point.iter().map(|(_, x)| x.bits()).sum::<u64>();
        sort_by(&mut first, |a, b| (bits(&a.1), &a.0).cmp(&(bits(&b.1), &b.0)));
        sort_by(&mut all, |a, b| a.0.cmp(&b.0));
        Some(first.into_iter().take(SIMPLE).chain(all).map(|(_, point)| point).listed())
    }

    /// A point of the domain.
    pub(super) fn typical(&self) -> Values {
        let region = self.family.region();
        region.ranges.iter().map(|(var, range)| (*var, middle(range))).listed()
    }
}

/// A function with rational numbers next to π, exp(r) and the like in place of these: about where it is small.
fn with_numbers_near(family: &Family, f: &Fraction) -> Option<Fraction> {
    let numbers = family.analytic.numbers();
    let occurring = |(var, _): &&(Var, Range)| numbers.contains(var) && f.depends_on(*var);
    family.analytic.ranges.iter().filter(occurring).try_fold(f.clone(), |f, (var, range)| {
        let scaled = &middle(range) * &Rational::from(NEAR);
        let near = &scaled.floor() / &Rational::from(NEAR);
        put(&f, *var, &Fraction::constant(near))
    })
}

/// Whether polynomials have their signs at a point; those with a variable that has no value there do not.
fn hold(premises: &[(Poly, Relation)], point: &Values) -> bool {
    let at = |p: &Poly| point.iter().fold(p.clone(), |p, (var, x)| p.at(*var, x)).as_constant();
    premises.iter().all(|(p, relation)| at(p).is_some_and(|value| relation.holds(&value)))
}

/// The middle of a range, or another point of it.
pub(super) fn middle(range: &Range) -> Rational {
    range.finite().map_or_else(|| typical(range), |(a, b)| &(a + b) * &Rational::new(1, 2))
}

/// A statement about a sign at one point, with all values of the variables that are not rational there between their
/// bounds, and what is to be shown of these for the statement to be false; `None` where the point is none of the
/// domain.
pub(in crate::state::family) fn at_point(
    family: &Family,
    statement: &Statement,
    point: &Values,
) -> Option<[Statement; 2]> {
    let Statement::Sign { value, relation, domain } = statement else { return None };
    let found = enclosures(family, point)?;
    let mut value = Fraction::new(value.numerator.clone(), value.denominator.clone())?;
    // The end of the domain may be a parameter at the end of its own range.
    for (var, x) in found.exact.iter().rev() {
        value = put(&value, *var, x)?;
    }
    let mut ranges = Vec::new();
    for (var, range) in &domain.region.ranges {
        if let Some((_, x)) = point.iter().find(|(v, _)| v == var) {
            if !range.contains(x) {
                return None;
            }
            ranges.push((*var, Range::closed(x.clone(), x.clone())));
        } else if family.analytic.numbers().contains(var) {
            ranges.push((*var, range.clone()));
        } else if value.depends_on(*var) {
            return None;
        }
    }
    // An angle itself is what its tangent says, which need not occur.
    for (var, x) in point.iter().filter(|(var, _)| domain.region.ranges.iter().all(|(v, _)| v != var)) {
        if !family.region().range(*var).contains(x) {
            return None;
        }
        ranges.push((*var, Range::closed(x.clone(), x.clone())));
    }
    for (var, (low, high)) in found.between {
        if value.depends_on(var) && ranges.iter().all(|(v, _)| *v != var) {
            ranges.push((var, Range::closed(low, high)));
        }
    }
    let domain = Rc::new(Domain { region: Region { ranges }, ..(**domain).clone() });
    let opposite = basis_prover::of_negative(*relation);
    let negation =
        Statement::Sign { value: (-&value).quotient(), relation: opposite, domain: Rc::clone(&domain) };
    let narrow = Statement::Sign { value: value.quotient(), relation: *relation, domain };
    Some([narrow, negation])
}

/// The refutation of a statement about a sign at a point, with the proof that it fails for all values between the bounds.
pub(super) fn refuted_at(
    family: &Family,
    statement: &Statement,
    point: &Values,
    work: &mut Work,
) -> Option<(Counterexample, basis_kernel::Proof)> {
    let [narrow, negation] = at_point(family, statement, point)?;
    let Statement::Sign { value: Quotient { numerator, denominator }, domain, .. } = &narrow else {
        return None;
    };
    let free = |var: Var| numerator.depends_on(var) || denominator.depends_on(var);
    let coordinates = domain
        .region
        .ranges
        .iter()
        .filter(|(var, _)| free(*var) || point.iter().any(|(v, _)| v == var))
        .map(|(var, range)| (*var, Coordinate::Rational(middle(range))))
        .listed();
    let found = refute(&Rc::new(narrow.clone()), &coordinates, work)?;
    let shown = decide(negation, &Symmetries::new(), 1).ok()?;
    Some((found, shown.proof))
}

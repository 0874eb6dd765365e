//! The laws of families of several coordinates, whatever the domain.

use super::random::Random;
use super::{Checks, Law, Place, Violation, size, step, within_hull};
use crate::domain::from_unit;
use crate::{Array, DomainFactor, Scalar};

/// A family of several coordinates: what the laws ask of it.
pub(super) trait Patches: Copy {
    type Scalar: Scalar;
    type Coordinates: Array<Self::Scalar>;
    type Values: AsRef<[Self::Scalar]>;
    type Points: Array<Self::Scalar>;

    const NAME: &'static str;

    /// The factors of the domain, one after the other.
    fn factor(index: usize) -> Option<DomainFactor>;

    /// The lowest and the highest value of a coordinate.
    fn range(coordinate: usize) -> [Self::Scalar; 2];

    /// The derivatives of these orders in the independent coordinates.
    fn partials(&self, at: Self::Coordinates, orders: &[usize]) -> Self::Values;

    fn values(&self, at: Self::Coordinates) -> Self::Values;

    /// The derivative of the patch over these control points, `None` for its points.
    fn patch(&self, points: Self::Points, at: Self::Coordinates, orders: Option<&[usize]>) -> Self::Scalar;

    /// The largest Bernstein coefficient of the patch over these control points.
    fn largest(&self, points: Self::Points) -> Self::Scalar;
}

/// The most independent coordinates.
const MOST: usize = 16;

/// One of the independent coordinates: its place among all of them, that of the one that depends on it, and the degree.
struct Variable {
    place: usize,
    last: Option<usize>,
    degree: usize,
}

fn variables<F: Patches>() -> impl Iterator<Item = Variable> {
    let mut start = 0;
    let factors = (0..).map_while(F::factor);
    let all = factors.flat_map(move |factor| {
        let (all, independent) = factor.coordinates();
        let first = start;
        start += all;
        let last = (independent < all).then_some(first + independent);
        (first..first + independent).map(move |place| Variable { place, last, degree: factor.degree() })
    });
    all.take(MOST)
}

/// A point of the domain: in every fourth round some coordinates lie at the ends of their ranges.
fn point<F: Patches>(random: &mut Random, round: usize) -> F::Coordinates {
    /// A whole number of steps between 0 and 1, so that barycentric coordinates sum to 1 exactly, also in `f32`.
    const STEPS: f64 = 1_048_576.0;
    let mut values = F::Coordinates::from_fn(|_| F::Scalar::ZERO);
    let mut start = 0;
    for factor in (0..).map_while(F::factor) {
        let (all, independent) = factor.coordinates();
        let mut cuts = [0_u32; 4];
        for cut in &mut cuts[..independent] {
            let x: f64 = random.unit();
            let near_end = x * x * x * x;
            *cut = match (round % 8, all) {
                (0, _) => 0,
                (4, 1) => STEPS as u32,
                (2, _) => (near_end * STEPS) as u32,
                _ => (x * STEPS) as u32,
            };
            // Corners, and not one corner alone.
            if round.is_multiple_of(8) && x > 0.5 {
                *cut = STEPS as u32;
            }
        }
        cuts[..independent].sort_unstable();
        let mut below = 0;
        for (i, value) in values.as_mut().iter_mut().skip(start).take(all).enumerate() {
            let cut = if i < independent { cuts[i] } else { STEPS as u32 };
            let share = F::Scalar::of(f64::from(cut - below) / STEPS);
            *value = from_unit(F::range(start + i), share);
            below = if independent < all { cut } else { 0 };
        }
        start += all;
    }
    values
}

/// The point with one coordinate moved, and in a simplex the last one against it.
fn moved<F: Patches>(mut at: F::Coordinates, variable: &Variable, step: F::Scalar) -> F::Coordinates {
    let values = at.as_mut();
    values[variable.place] = values[variable.place] + step;
    if let Some(last) = variable.last {
        values[last] = values[last] - step;
    }
    at
}

fn points<F: Patches>(checks: &Checks) -> impl Iterator<Item = F::Coordinates> {
    let mut random = Random(!checks.seed);
    (0..checks.samples).map(move |round| point::<F>(&mut random, round))
}

/// `Σ values[i] points[i]`
fn along<F: Patches>(values: &F::Values, points: &F::Points) -> F::Scalar {
    let terms = values.as_ref().iter().zip(points.as_ref());
    terms.fold(F::Scalar::ZERO, |sum, (&b, &p)| sum + b * p)
}

fn degree<F: Patches>() -> usize {
    (0..).map_while(F::factor).map(DomainFactor::degree).sum()
}

fn close<F: Patches>(
    law: Law,
    at: F::Coordinates,
    [found, expected, size]: [F::Scalar; 3],
    checks: &Checks,
) -> Result<(), Violation> {
    let near = checks.accept(found, expected, size, degree::<F>());
    if near { Ok(()) } else { Err(broken::<F>(law, at, found, expected)) }
}

fn broken<F: Patches>(law: Law, at: F::Coordinates, found: F::Scalar, expected: F::Scalar) -> Violation {
    let at = Place::new(at.as_ref());
    Violation { law, family: F::NAME, at, found: found.to_f64(), expected: expected.to_f64() }
}

pub(super) fn form<F: Patches>(family: F, checks: &Checks) -> Result<(), Violation> {
    let mut random = Random(checks.seed);
    for at in points::<F>(checks) {
        let control: F::Points = random.numbers();
        let sum = along::<F>(&family.values(at), &control);
        let size = family.largest(control);
        close::<F>(Law::Form, at, [family.patch(control, at, None), sum, size], checks)?;
    }
    Ok(())
}

pub(super) fn derivatives<F: Patches>(family: F, checks: &Checks) -> Result<(), Violation> {
    let mut random = Random(checks.seed);
    for at in points::<F>(checks) {
        let control: F::Points = random.numbers();
        for (index, variable) in variables::<F>().enumerate() {
            let count = variables::<F>().count();
            let mut orders = [0; MOST];
            let [lo, hi] = F::range(variable.place);
            let (width, degree) = (hi - lo, F::Scalar::from_usize(variable.degree.max(1)));
            let growth = F::Scalar::of(2.0) * degree / width;
            let mut bound = family.largest(control);
            for order in 1..=variable.degree + 1 {
                let h = width * step::<F::Scalar>() / degree;
                orders[index] = order - 1;
                let below = |step: F::Scalar| {
                    let at = moved::<F>(at, &variable, step);
                    along::<F>(&family.partials(at, &orders[..count]), &control)
                };
                let difference = (below(h) - below(-h)) / (h + h);
                orders[index] = order;
                let found = along::<F>(&family.partials(at, &orders[..count]), &control);
                let scale = bound * growth * step::<F::Scalar>() * step::<F::Scalar>() / F::Scalar::EPSILON;
                close::<F>(Law::Derivatives, at, [found, difference, scale], checks)?;
                bound = bound * growth;
                let of_patch = family.patch(control, at, Some(&orders[..count]));
                close::<F>(Law::Derivatives, at, [of_patch, found, bound], checks)?;
            }
            let above = along::<F>(&family.partials(at, &orders[..count]), &control);
            if above != F::Scalar::ZERO {
                return Err(broken::<F>(Law::Derivatives, at, above, F::Scalar::ZERO));
            }
        }
    }
    Ok(())
}

pub(super) fn partition_of_unity<F: Patches>(family: F, checks: &Checks) -> Result<(), Violation> {
    for at in points::<F>(checks) {
        let values = family.values(at);
        let sum = values.as_ref().iter().fold(F::Scalar::ZERO, |sum, &b| sum + b);
        close::<F>(Law::PartitionOfUnity, at, [sum, F::Scalar::ONE, size(values.as_ref())], checks)?;
    }
    Ok(())
}

pub(super) fn nonnegative<F: Patches>(family: F, checks: &Checks) -> Result<(), Violation> {
    for at in points::<F>(checks) {
        for &b in family.values(at).as_ref() {
            if b < F::Scalar::ZERO || b.is_nan() {
                return Err(broken::<F>(Law::Nonnegative, at, b, F::Scalar::ZERO));
            }
        }
    }
    Ok(())
}

pub(super) fn convex_hull<F: Patches>(family: F, checks: &Checks) -> Result<(), Violation> {
    let mut random = Random(checks.seed);
    for at in points::<F>(checks) {
        // The components of the points in a random direction are random numbers.
        let control: F::Points = random.numbers();
        let found = family.patch(control, at, None);
        let expected = within_hull(found, control.as_ref());
        close::<F>(Law::ConvexHull, at, [found, expected, size(control.as_ref())], checks)?;
    }
    Ok(())
}

pub(super) fn affine_invariance<F: Patches>(family: F, checks: &Checks) -> Result<(), Violation> {
    let mut random = Random(checks.seed);
    for at in points::<F>(checks) {
        let [x, y]: [F::Points; 2] = [random.numbers(), random.numbers()];
        let [a, b, c]: [F::Scalar; 3] = core::array::from_fn(|_| random.between_ones());
        // One row of the map; the other is another round.
        let map = |x: F::Scalar, y: F::Scalar| a * x + b * y + c;
        let mapped = F::Points::from_fn(|i| map(x.as_ref()[i], y.as_ref()[i]));
        let of = |points| family.patch(points, at, None);
        let size = family.largest(mapped).max(F::Scalar::of(3.0));
        close::<F>(Law::AffineInvariance, at, [of(mapped), map(of(x), of(y)), size], checks)?;
    }
    Ok(())
}

//! Mass and stiffness matrices: integrals of products of basis functions, and of their derivatives, from those of the
//! Bernstein polynomials, which are fractions.
//!
//! On the simplex `x₁ + … + x_d <= 1`, with `x₀ = 1 - x₁ - … - x_d`,
//!
//! `B_α B_β = ∏ binomial(α_k + β_k, α_k) / binomial(2n, n) · B_(α+β)`, `∫ B_γ = m!/(m + d)!` for the degree m of `B_γ`,
//!
//! and `∂B_α/∂x_k = n (B_(α - e_k) - B_(α - e_0))`. An interval is a simplex with d = 1, a box a product of intervals.

use crate::numeric::binomial::binomial;
use crate::{Array, DomainFactor, Point, Scalar, SimplexIndex};

/// `∫ B_a B_b` over the simplex, for two indices with the same sum.
fn product<S: Scalar, const K: usize>(a: [usize; K], b: [usize; K]) -> S {
    let degree: usize = a.iter().sum();
    let above = a.iter().zip(b).fold(S::ONE, |product, (&a, b)| product * binomial::<S>(a + b, a));
    let below = (1..K).fold(binomial::<S>(2 * degree, degree), |p, k| p * S::from_usize(2 * degree + k));
    above / below
}

/// `Σ_k ∫ ∂B_a/∂x_k ∂B_b/∂x_k`, the last component of an index being that of `x₀`.
fn slope<S: Scalar, const K: usize>(a: [usize; K], b: [usize; K]) -> S {
    let lower = |index: [usize; K], place: usize| {
        let mut lower = index;
        lower[place] = index[place].checked_sub(1)?;
        Some(lower)
    };
    let pair = |i: usize, j: usize| match (lower(a, i), lower(b, j)) {
        (Some(a), Some(b)) => product::<S, K>(a, b),
        _ => S::ZERO,
    };
    let last = K - 1;
    let sum = (0..last)
        .fold(S::ZERO, |sum, k| sum + (pair(k, k) - pair(k, last)) + (pair(last, last) - pair(last, k)));
    let degree = S::from_usize(a.iter().sum());
    sum * degree * degree
}

/// What is integrated.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Products of functions.
    Mass,
    /// Scalar products of gradients.
    Stiffness,
}

/// The integral for two Bernstein polynomials of a degree on the unit interval.
fn on_interval<S: Scalar>(kind: Kind, degree: usize, a: usize, b: usize) -> S {
    let (a, b) = ([a, degree - a], [b, degree - b]);
    if kind == Kind::Mass { product::<S, 2>(a, b) } else { slope::<S, 2>(a, b) }
}

/// The matrix on the interval with these ends, of the functions with these Bernstein weights.
pub(crate) fn interval<V, M>(kind: Kind, net: &[V], [low, high]: [V::Scalar; 2]) -> M
where
    V: Point + Array<V::Scalar>,
    M: Array<V>,
{
    let (degree, width) = (net.len() - 1, high - low);
    matrix(net, &|a, b| {
        let value = on_interval::<V::Scalar>(kind, degree, a, b);
        if kind == Kind::Mass { value * width } else { value / width }
    })
}

/// The matrix on the reference simplex with K corners.
pub(crate) fn simplex<V, M, const K: usize>(kind: Kind, net: &[V], degree: usize) -> M
where
    V: Point + Array<V::Scalar>,
    M: Array<V>,
{
    matrix(net, &|a, b| on_simplex::<V::Scalar, K>(kind, degree, a, b))
}

/// The integral for two Bernstein polynomials of a degree on the reference simplex, by their places.
fn on_simplex<S: Scalar, const K: usize>(kind: Kind, degree: usize, a: usize, b: usize) -> S {
    match (SimplexIndex::<K>::at(degree, a), SimplexIndex::<K>::at(degree, b)) {
        (Some(a), Some(b)) if kind == Kind::Mass => product::<S, K>(a.components(), b.components()),
        (Some(a), Some(b)) => slope::<S, K>(a.components(), b.components()),
        _ => S::ZERO,
    }
}

/// The matrix on the box with these corners.
pub(crate) fn on_box<V, M>(
    kind: Kind,
    net: &[V],
    degrees: &[usize],
    low: &[V::Scalar],
    high: &[V::Scalar],
) -> M
where
    V: Point + Array<V::Scalar>,
    M: Array<V>,
{
    // The product of integrals in each coordinate, in one of them perhaps of derivatives.
    let along = |a: usize, b: usize, differentiated: Option<usize>| {
        let (mut a, mut b, mut value) = (a, b, V::Scalar::ONE);
        for (axis, &degree) in degrees.iter().enumerate().rev() {
            let (j, k) = (a % (degree + 1), b % (degree + 1));
            (a, b) = (a / (degree + 1), b / (degree + 1));
            let width = high[axis] - low[axis];
            value = value
                * if differentiated == Some(axis) {
                    on_interval::<V::Scalar>(Kind::Stiffness, degree, j, k) / width
                } else {
                    on_interval::<V::Scalar>(Kind::Mass, degree, j, k) * width
                };
        }
        value
    };
    matrix(net, &|a, b| match kind {
        Kind::Mass => along(a, b, None),
        Kind::Stiffness => {
            (0..degrees.len()).fold(V::Scalar::ZERO, |sum, axis| sum + along(a, b, Some(axis)))
        }
    })
}

/// The integral for two Bernstein polynomials on a factor of a domain with these ends, by their places.
fn on_factor<S: Scalar>(kind: Kind, factor: DomainFactor, [a, b]: [usize; 2], [low, high]: [S; 2]) -> S {
    match factor {
        DomainFactor::Interval { degree } => {
            let (value, width) = (on_interval::<S>(kind, degree, a, b), high - low);
            if kind == Kind::Mass { value * width } else { value / width }
        }
        DomainFactor::Triangle { degree } => on_simplex::<S, 3>(kind, degree, a, b),
        DomainFactor::Tetrahedron { degree } => on_simplex::<S, 4>(kind, degree, a, b),
    }
}

/// The matrix on a product of simplices and intervals, with the ends of all coordinates.
pub(crate) fn on_product<V, M>(
    kind: Kind,
    net: &[V],
    factors: &[DomainFactor],
    low: &[V::Scalar],
    high: &[V::Scalar],
) -> M
where
    V: Point + Array<V::Scalar>,
    M: Array<V>,
{
    // The product of integrals over each factor, over one of them perhaps of derivatives.
    let along = |a: usize, b: usize, differentiated: Option<usize>| {
        let (mut a, mut b, mut value, mut coordinate) = (a, b, V::Scalar::ONE, low.len());
        for (place, &factor) in factors.iter().enumerate().rev() {
            coordinate -= factor.coordinates().0;
            let size = factor.size();
            let kind = if differentiated == Some(place) { Kind::Stiffness } else { Kind::Mass };
            let ends = [low[coordinate], high[coordinate]];
            value = value * on_factor(kind, factor, [a % size, b % size], ends);
            (a, b) = (a / size, b / size);
        }
        value
    };
    matrix(net, &|a, b| match kind {
        Kind::Mass => along(a, b, None),
        Kind::Stiffness => {
            (0..factors.len()).fold(V::Scalar::ZERO, |sum, place| sum + along(a, b, Some(place)))
        }
    })
}

/// `Σ_a Σ_b net[a][i] integral(a, b) net[b][j]`, symmetric to the last bit.
fn matrix<V, M>(net: &[V], integral: &dyn Fn(usize, usize) -> V::Scalar) -> M
where
    V: Point + Array<V::Scalar>,
    M: Array<V>,
{
    let mut matrix = M::from_fn(|_| V::zero());
    let rows = matrix.as_mut();
    for (a, weights) in net.iter().enumerate() {
        let mut sum = V::zero();
        for (b, other) in net.iter().enumerate() {
            sum = sum.add_weighted(*other, integral(a, b));
        }
        for (row, &weight) in rows.iter_mut().zip(weights.as_ref()) {
            *row = row.add_weighted(sum, weight);
        }
    }
    for i in 0..rows.len() {
        for j in 0..i {
            rows[i].as_mut()[j] = rows[j].as_ref()[i];
        }
    }
    matrix
}

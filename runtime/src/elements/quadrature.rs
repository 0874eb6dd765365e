//! Rules of quadrature on intervals, boxes, simplices and their products.

use alloc::vec::Vec;
use core::error::Error;
use core::fmt::{self, Display, Formatter};

use super::symmetric;
use crate::numeric::gauss::jacobi;
use crate::{DomainFactor, Point, Scalar};

/// Rules of a higher degree are refused.
const MOST_DEGREE: usize = 1_023;

/// Rules with more points are refused.
const MOST_POINTS: usize = 1 << 22;

/// A rule of quadrature on a cell: points `x[q]` inside of it and positive weights `w[q]`, so that `Σ w[q] f(x[q])` is
/// the integral of `f` over the cell, exactly (but for rounding) for polynomials up to its [`degree`](Self::degree).
///
/// `X` is what a family on the cell takes: a parameter on an interval, coordinates on a box, barycentric coordinates on a
/// simplex. There the integral is that over the coordinates but the last, so that the weights have the sum `1/2` on a
/// triangle and `1/6` on a tetrahedron: the same variables in which
/// [`partials`](crate::SimplexBasis::partials) and [`tabulate`](crate::SimplexBasis::tabulate) differentiate. On a product such as
/// a wedge, [`ProductBasis::quadrature`](crate::ProductBasis::quadrature), a point has the coordinates of all factors. The
/// integral over a cell in space that is the image of this one has the factor `|det J|` with the matrix `J` of these
/// derivatives.
///
/// ```
/// use basis_runtime::Quadrature;
///
/// # fn main() -> Result<(), basis_runtime::QuadratureError> {
/// let rule = Quadrature::on_simplex(4)?; // six points, exact for all polynomials of degree 4
/// let integral = rule.integrate(|[u, v, w]: [f64; 3]| u * u * v * w);
/// assert!((integral - 1.0 / 360.0).abs() < 1e-17); // 2! 1! 1! / 6!
///
/// let rule = Quadrature::on_box([[0.0, 0.0], [2.0, 1.0]], 3)?; // 2 × 2 points
/// assert_eq!((rule.len(), rule.degree()), (4, 3));
/// assert!((rule.integrate(|[x, y]: [f64; 2]| x * x * x * y * y) - 4.0 / 3.0).abs() < 1e-15);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Quadrature<X: Point> {
    points: Vec<X>,
    weights: Vec<X::Scalar>,
    degree: usize,
}

impl<S: Scalar> Quadrature<S> {
    /// Gauss's rule on an interval `[lo, hi]`, with `⌊degree/2⌋ + 1` points in increasing order, exact for polynomials of
    /// that degree.
    ///
    /// # Errors
    /// [`QuadratureError::Domain`] if `lo < hi` is not so or an end is not finite, [`QuadratureError::Degree`] for a
    /// degree above 1023.
    pub fn on_interval(domain: [S; 2], degree: usize) -> Result<Self, QuadratureError> {
        let count = count(degree, 1)?;
        let width = width(domain)?;
        let rule = jacobi(count, 0);
        let place = |x| S::of(between(domain, x));
        Ok(Self {
            points: rule.iter().map(|&[x, _]| place(x)).collect(),
            weights: rule.iter().map(|&[_, w]| S::of(w * width)).collect(),
            degree: 2 * count - 1,
        })
    }
}

impl<S: Scalar, const K: usize> Quadrature<[S; K]> {
    /// The product of Gauss's rules on a box with these lowest and highest corners, exact for polynomials of that degree
    /// in each coordinate: `(⌊degree/2⌋ + 1)^K` points, the last coordinate fastest.
    ///
    /// # Errors
    /// [`QuadratureError::Domain`] if a side of the box has not a finite length above zero,
    /// [`QuadratureError::Degree`] for a degree above 1023, or where the points would be more than 2²².
    pub fn on_box([low, high]: [[S; K]; 2], degree: usize) -> Result<Self, QuadratureError> {
        let count = count(degree, K)?;
        let mut volume = 1.0;
        for d in 0..K {
            volume *= width([low[d], high[d]])?;
        }
        let rule = jacobi(count, 0);
        let (points, weights) = grid(count, |places: &[usize; K]| {
            let at = core::array::from_fn(|d| S::of(between([low[d], high[d]], rule[places[d]][0])));
            (at, S::of(places.iter().map(|&i| rule[i][1]).product::<f64>() * volume))
        });
        Ok(Self { points, weights, degree: 2 * count - 1 })
    }

    /// A rule on the simplex with `K` corners (triangle: 3, tetrahedron: 4) in barycentric coordinates, exact for
    /// polynomials of that total degree, with all points inside and all weights positive.
    ///
    /// On triangles up to the degree 10 and on tetrahedra up to the degree 6 it has the symmetries of the cell and as few
    /// points as are known with them (1, 3, 6, 6, 7, 12, 15, 16, 19, 25 and 1, 4, 8, 14, 14, 24); above, and in other
    /// dimensions, it is the collapsed product of Gauss–Jacobi rules with `(⌊degree/2⌋ + 1)^(K - 1)` points (A. H.
    /// Stroud, "Approximate Calculation of Multiple Integrals", 1971, section 2.4).
    ///
    /// # Errors
    /// [`QuadratureError::Degree`] for a degree above 1023, or where the points would be more than 2²².
    pub fn on_simplex(degree: usize) -> Result<Self, QuadratureError> {
        const { assert!(K > 0, "a simplex has at least one corner") };
        if let Some(rule) = symmetric::rule(K, degree) {
            let volume = (1..K).fold(1.0, |volume, d| volume / d as f64);
            let coordinate = |at: &[f64]| core::array::from_fn(|d| S::of(at[d]));
            return Ok(Self {
                points: rule.points.chunks_exact(K).map(coordinate).collect(),
                weights: rule.weights.iter().map(|w| S::of(w * volume)).collect(),
                degree: rule.degree,
            });
        }
        let count = count(degree, K - 1)?;
        // The coordinate d is y[d] (1 - y[0]) … (1 - y[d-1]); the Jacobian is ∏ (1 - y[d])^(K - 2 - d).
        let rules: Vec<Vec<[f64; 2]>> = (0..K - 1).map(|d| jacobi(count, K - 2 - d)).collect();
        let (points, weights) = grid_of(count, K - 1, |places: &[usize]| {
            let (mut rest, mut weight, mut at) = (1.0, 1.0, [S::ZERO; K]);
            for (d, &i) in places.iter().enumerate() {
                let [y, w] = rules[d][i];
                at[d] = S::of(y * rest);
                rest *= 1.0 - y;
                weight *= w;
            }
            at[K - 1] = S::of(rest);
            (at, S::of(weight))
        });
        Ok(Self { points, weights, degree: 2 * count - 1 })
    }
}

impl<S: Scalar, const K: usize> Quadrature<[S; K]> {
    /// The product of rules on the factors of a domain with these lowest and highest coordinates, exact for polynomials of
    /// that degree in the coordinates of each factor.
    pub(crate) fn on_product(
        factors: &[DomainFactor],
        [low, high]: [&[S]; 2],
        degree: usize,
    ) -> Result<Self, QuadratureError> {
        count(degree, factors.iter().map(|factor| factor.coordinates().1).sum())?;
        let (mut start, mut exact) = (0, usize::MAX);
        let mut all = alloc::vec![([S::ZERO; K], S::ONE)];
        for factor in factors {
            let (rule, own): (Vec<([S; 4], S)>, usize) = match factor {
                DomainFactor::Interval { .. } => {
                    let rule = Quadrature::on_interval([low[start], high[start]], degree)?;
                    (rule.iter().map(|(x, w)| ([x, S::ZERO, S::ZERO, S::ZERO], w)).collect(), rule.degree)
                }
                DomainFactor::Triangle { .. } => {
                    let rule = Quadrature::<[S; 3]>::on_simplex(degree)?;
                    (
                        rule.iter().map(|([u, v, w], weight)| ([u, v, w, S::ZERO], weight)).collect(),
                        rule.degree,
                    )
                }
                DomainFactor::Tetrahedron { .. } => {
                    let rule = Quadrature::<[S; 4]>::on_simplex(degree)?;
                    (rule.iter().collect(), rule.degree)
                }
            };
            exact = exact.min(own);
            let (coordinates, _) = factor.coordinates();
            let with = |(mut point, weight): ([S; K], S), (at, factor): ([S; 4], S)| {
                point[start..start + coordinates].copy_from_slice(&at[..coordinates]);
                (point, weight * factor)
            };
            all = all.iter().flat_map(|&one| rule.iter().map(move |&next| with(one, next))).collect();
            start += coordinates;
        }
        let (points, weights) = all.into_iter().unzip();
        Ok(Self { points, weights, degree: exact })
    }
}

impl<X: Point> Quadrature<X> {
    /// The points of the rule, all inside of the cell.
    pub fn points(&self) -> &[X] {
        &self.points
    }

    /// The weights, one for each point, all positive; their sum is the measure of the cell.
    pub fn weights(&self) -> &[X::Scalar] {
        &self.weights
    }

    /// The degree up to which the rule is exact, at least the one that was asked for: on boxes in each coordinate, on
    /// simplices in all together, on products in each factor.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The number of points.
    #[allow(clippy::len_without_is_empty)] // no rule is empty
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// The points with their weights.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (X, X::Scalar)> {
        self.points.iter().copied().zip(self.weights.iter().copied())
    }

    /// `Σ w[q] f(x[q])`, the integral of a function with values that are numbers or points.
    pub fn integrate<Y: Point<Scalar = X::Scalar>>(&self, mut f: impl FnMut(X) -> Y) -> Y {
        self.iter().fold(Y::zero(), |sum, (x, w)| sum.add_weighted(f(x), w))
    }
}

/// A rule of quadrature that cannot be made.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum QuadratureError {
    /// The ends of the interval, or of a side of the box, are not finite numbers in increasing order, or too far apart.
    Domain {
        /// The ends.
        ends: [f64; 2],
    },
    /// A rule of that degree would have too many points.
    Degree {
        /// The degree asked for.
        degree: usize,
        /// The highest degree on such a cell.
        most: usize,
    },
}

impl Display for QuadratureError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Domain { ends: [lo, hi] } => {
                write!(f, "the cell from {lo} to {hi} has no finite length above zero")
            }
            Self::Degree { degree, most } => {
                write!(
                    f,
                    "a rule of degree {degree} has too many points: the highest degree on this cell is {most}"
                )
            }
        }
    }
}

impl Error for QuadratureError {}

/// The number of points in each direction.
#[inline]
fn count(degree: usize, directions: usize) -> Result<usize, QuadratureError> {
    let fits = |count: usize| {
        u32::try_from(directions)
            .ok()
            .and_then(|directions| count.checked_pow(directions))
            .is_some_and(|points| points <= MOST_POINTS)
    };
    let count = degree / 2 + 1;
    if degree <= MOST_DEGREE && fits(count) {
        return Ok(count);
    }
    let largest = (1..=MOST_DEGREE / 2 + 1).rev().find(|&count| fits(count));
    Err(QuadratureError::Degree { degree, most: largest.map_or(0, |count| 2 * count - 1) })
}

/// The length of an interval.
#[inline]
fn width<S: Scalar>(domain: [S; 2]) -> Result<f64, QuadratureError> {
    let ends = domain.map(Scalar::to_f64);
    let width = ends[1] - ends[0];
    if width > 0.0 && width.is_finite() { Ok(width) } else { Err(QuadratureError::Domain { ends }) }
}

#[inline]
fn between<S: Scalar>(domain: [S; 2], x: f64) -> f64 {
    let [lo, hi] = domain.map(Scalar::to_f64);
    lo * (1.0 - x) + hi * x
}

/// A point and a weight for each place `0 <= i < count` in each of `K` directions, the last fastest.
fn grid<X, S, const K: usize>(count: usize, mut at: impl FnMut(&[usize; K]) -> (X, S)) -> (Vec<X>, Vec<S>) {
    grid_of(count, K, |places| at(&core::array::from_fn(|d| places[d])))
}

fn grid_of<X, S>(
    count: usize,
    directions: usize,
    mut at: impl FnMut(&[usize]) -> (X, S),
) -> (Vec<X>, Vec<S>) {
    let mut places = alloc::vec![0; directions];
    let (mut points, mut weights) = (Vec::new(), Vec::new());
    loop {
        let (point, weight) = at(&places);
        points.push(point);
        weights.push(weight);
        let Some(last) = places.iter().rposition(|&i| i + 1 < count) else { return (points, weights) };
        places[last] += 1;
        places[last + 1..].fill(0);
    }
}

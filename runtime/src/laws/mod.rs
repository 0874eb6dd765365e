//! Laws of families of basis functions, checked with numbers: for families that were not written as a spec.
//!
//! What [`basis!`](crate::basis!) generates is proved. A [`Basis`] that was written by hand, or that wraps another
//! library, is not; these checks find its mistakes in a test. They draw parameters and control points from a generator
//! with a fixed seed, so that every run checks the same numbers.
//!
//! ```
//! # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
//! # fn main() -> Result<(), Box<dyn core::error::Error>> {
//! use basis_runtime::laws::{self, Checks};
//!
//! let checks = Checks::default();
//! for lambda in [-3.0, -1.0, 0.0, 0.5, 1.0] {
//!     let basis = QuarticBernstein::new(lambda)?;
//!     laws::consistent(&basis, &checks)?; // the parts of the implementation agree with each other
//!     laws::geometric(&basis, &checks)?;  // its curves depend on their control points as those of Bézier curves do
//! }
//! # Ok(())
//! # }
//! ```
//!
//! | laws | every family | |
//! | --- | --- | --- |
//! | [`form`] | yes | curves, values and Bernstein coefficients are the same functions |
//! | [`derivatives`] | yes | derivatives agree with differences |
//! | [`split`] | yes | parts of a curve are the curve |
//! | [`partition_of_unity`] | | the functions sum to 1 |
//! | [`nonnegative`] | | no function is negative |
//! | [`convex_hull`] | | curves stay in the convex hull of their control points |
//! | [`affine_invariance`] | | an affine map of the control points maps the curve |
//!
//! The same for families on triangles and tetrahedra is in [`simplices`], on boxes in [`boxes`], on prisms and other products
//! in [`products`]: `laws::simplices::consistent(&basis, &checks)?`. There are no laws of parts there.

mod domains;
mod patches;
mod random;

use core::error::Error;
use core::fmt::{self, Display, Formatter};

pub use domains::{boxes, products, simplices};

use crate::domain::from_unit;
use crate::{Array, Basis, Curve, Scalar};
use random::Random;

/// How thoroughly the laws are checked.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Checks {
    /// The number of parameters, and of sets of control points; both ends of the domain are always among the
    /// parameters.
    pub samples: usize,
    /// Where the generator of numbers starts.
    pub seed: u64,
    /// The error that is allowed, in units of `ε (n + 1)` times the size of the numbers that are added up, for degree
    /// `n`.
    pub tolerance: f64,
}

impl Checks {
    /// With that number of parameters and of sets of control points.
    #[must_use]
    pub fn samples(self, samples: usize) -> Self {
        Self { samples, ..self }
    }

    /// With numbers from that start of the generator.
    #[must_use]
    pub fn seed(self, seed: u64) -> Self {
        Self { seed, ..self }
    }

    /// With that error allowed, in the units of [`tolerance`](Self::tolerance).
    #[must_use]
    pub fn tolerance(self, tolerance: f64) -> Self {
        Self { tolerance, ..self }
    }

    /// Whether a difference is rounding: at most `tolerance` units of `size` for each of `degree + 1` operations. NaN is
    /// no small difference.
    fn accept<S: Scalar>(&self, found: S, expected: S, size: S, degree: usize) -> bool {
        let unit = S::EPSILON * S::from_usize(degree + 1);
        (found - expected).abs() <= S::of(self.tolerance) * unit * size
    }
}

impl Default for Checks {
    fn default() -> Self {
        Self { samples: 200, seed: 1, tolerance: 32.0 }
    }
}

/// A law of this module.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Law {
    /// [`form`]
    Form,
    /// [`derivatives`]
    Derivatives,
    /// [`split`]
    Split,
    /// [`partition_of_unity`]
    PartitionOfUnity,
    /// [`nonnegative`]
    Nonnegative,
    /// [`convex_hull`]
    ConvexHull,
    /// [`affine_invariance`]
    AffineInvariance,
}

impl Display for Law {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Form => "curves, values and Bernstein coefficients are the same functions",
            Self::Derivatives => "derivatives agree with differences",
            Self::Split => "the parts of a curve are the curve",
            Self::PartitionOfUnity => "the functions sum to 1",
            Self::Nonnegative => "no function is negative",
            Self::ConvexHull => "curves stay in the convex hull of their control points",
            Self::AffineInvariance => "an affine map of the control points maps the curve",
        })
    }
}

/// The coordinates of a point of a domain: one parameter, or several coordinates, of which the first eight are kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    values: [f64; 8],
    count: usize,
}

impl Place {
    fn new<S: Scalar>(coordinates: &[S]) -> Self {
        let of = |i: usize| coordinates.get(i).map_or(0.0, |x| x.to_f64());
        Self { values: core::array::from_fn(of), count: coordinates.len().min(8) }
    }

    /// The coordinates.
    pub fn coordinates(&self) -> &[f64] {
        &self.values[..self.count]
    }
}

impl Display for Place {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self.coordinates() {
            [t] => write!(f, "{t}"),
            all => {
                for (i, x) in all.iter().enumerate() {
                    write!(f, "{}{x}", if i == 0 { "(" } else { ", " })?;
                }
                f.write_str(")")
            }
        }
    }
}

/// A law that a family breaks, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Violation {
    /// The law.
    pub law: Law,
    /// The name of the family.
    pub family: &'static str,
    /// Where: the parameter, or the coordinates of a point of the domain.
    pub at: Place,
    /// The number that was found.
    pub found: f64,
    /// The number that the law asks for, or the bound that it sets.
    pub expected: f64,
}

impl Display for Violation {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self { law, family, at, found, expected } = self;
        write!(f, "{family} breaks the law that {law}: {found} instead of {expected} at {at}")
    }
}

impl Error for Violation {}

/// The laws that every implementation of [`Basis`] keeps: [`form`], [`derivatives`], [`split`].
///
/// # Errors
/// The first violation.
pub fn consistent<B: Basis>(basis: &B, checks: &Checks) -> Result<(), Violation> {
    form(basis, checks)?;
    derivatives(basis, checks)?;
    split(basis, checks)
}

/// The laws of bases for modelling: [`partition_of_unity`], [`nonnegative`], [`convex_hull`], [`affine_invariance`].
///
/// # Errors
/// The first violation.
pub fn geometric<B: Basis>(basis: &B, checks: &Checks) -> Result<(), Violation> {
    partition_of_unity(basis, checks)?;
    nonnegative(basis, checks)?;
    convex_hull(basis, checks)?;
    affine_invariance(basis, checks)
}

/// A curve is `Σ b[i](t) P[i]`, and so is the Bézier curve over its Bernstein control points; both ends are exact.
///
/// # Errors
/// The first violation.
pub fn form<B: Basis>(basis: &B, checks: &Checks) -> Result<(), Violation> {
    let mut random = Random(checks.seed);
    for t in parameters::<B>(checks) {
        let points = random.numbers::<B::Scalar, B::Points<B::Scalar>>();
        let curve = Curve::new(*basis, points);
        let values = basis.values(t);
        let terms = || values.as_ref().iter().zip(points.as_ref()).map(|(&b, &p)| b * p);
        let sum = terms().fold(B::Scalar::ZERO, |sum, term| sum + term);
        let size =
            size(curve.to_bernstein().as_ref()).max(terms().fold(B::Scalar::ZERO, |a, b| a.max(b.abs())));
        let near = |found, expected| close::<B>(Law::Form, t, found, expected, size, checks);
        near(curve.eval(t), sum)?;
        near(curve.to_bezier().eval(crate::domain::unit(B::domain(), t)[1]), sum)?;
        let [start, end] = B::domain().map(|t| curve.eval(t));
        exact::<B>(Law::Form, B::domain()[0], start, curve.start())?;
        exact::<B>(Law::Form, B::domain()[1], end, curve.end())?;
    }
    Ok(())
}

/// The derivative of each order is the limit of differences of the order below it; zero above the degree. Derivatives
/// of curves are `Σ dᵏb[i]/dtᵏ P[i]`.
///
/// # Errors
/// The first violation.
pub fn derivatives<B: Basis>(basis: &B, checks: &Checks) -> Result<(), Violation> {
    let mut random = Random(checks.seed);
    let [lo, hi] = B::domain();
    let width = hi - lo;
    let degree = B::Scalar::from_usize(B::DEGREE.max(1));
    for t in parameters::<B>(checks) {
        let points = random.numbers::<B::Scalar, B::Points<B::Scalar>>();
        let curve = Curve::new(*basis, points);
        // A bound for the derivative of each order: that many differences of Bernstein coefficients.
        let mut bound = size(curve.to_bernstein().as_ref());
        for order in 1..=B::DEGREE + 1 {
            let below = |t| along::<B>(basis, &points, t, order - 1);
            // With a step of h the difference is off by about h²/6 times the third derivative, and by 2 ε/h.
            let growth = B::Scalar::of(2.0) * degree / width;
            let h = width * step::<B::Scalar>() / degree;
            let difference = (below(t + h) - below(t - h)) / (h + h);
            let found = along::<B>(basis, &points, t, order);
            let scale = bound * growth * step::<B::Scalar>() * step::<B::Scalar>() / B::Scalar::EPSILON;
            close::<B>(Law::Derivatives, t, found, difference, scale, checks)?;
            bound = bound * growth;
            close::<B>(Law::Derivatives, t, curve.derivative(t, order), found, bound, checks)?;
        }
        exact::<B>(Law::Derivatives, t, along::<B>(basis, &points, t, B::DEGREE + 1), B::Scalar::ZERO)?;
    }
    Ok(())
}

/// Both halves of a curve, any part of it, and the reversed curve have the points of the curve.
///
/// # Errors
/// The first violation.
pub fn split<B: Basis>(basis: &B, checks: &Checks) -> Result<(), Violation> {
    let mut random = Random(checks.seed);
    for t in parameters::<B>(checks) {
        let curve = Curve::new(*basis, random.numbers::<B::Scalar, B::Points<B::Scalar>>());
        let size = size(curve.to_bernstein().as_ref());
        let x = crate::domain::unit(B::domain(), t)[1];
        let [a, b] = [random.unit::<B::Scalar>(), random.unit()];
        let at = |x| from_unit(B::domain(), x);
        let near =
            |found, x: B::Scalar| close::<B>(Law::Split, at(x), found, curve.eval(at(x)), size, checks);
        let ys = [B::Scalar::ZERO, B::Scalar::of(0.375), B::Scalar::ONE];
        // At an end of the domain there are no two parts, and over an empty range there is none.
        if let Ok([left, right]) = curve.split(t) {
            exact::<B>(Law::Split, t, left.end(), right.start())?;
            for y in ys {
                near(left.eval(y), x * y)?;
                near(right.eval(y), x + (B::Scalar::ONE - x) * y)?;
            }
        }
        if let Ok(part) = curve.subsegment(at(a)..at(b)) {
            for y in ys {
                near(part.eval(y), a + (b - a) * y)?;
            }
        }
        for y in ys {
            near(curve.reversed().eval(y), B::Scalar::ONE - y)?;
        }
    }
    Ok(())
}

/// `Σ b[i](t) = 1`
///
/// # Errors
/// The first violation.
pub fn partition_of_unity<B: Basis>(basis: &B, checks: &Checks) -> Result<(), Violation> {
    for t in parameters::<B>(checks) {
        let values = basis.values(t);
        let sum = values.as_ref().iter().fold(B::Scalar::ZERO, |sum, &b| sum + b);
        close::<B>(Law::PartitionOfUnity, t, sum, B::Scalar::ONE, size(values.as_ref()), checks)?;
    }
    Ok(())
}

/// `b[i](t) >= 0`, without any tolerance.
///
/// # Errors
/// The first violation.
pub fn nonnegative<B: Basis>(basis: &B, checks: &Checks) -> Result<(), Violation> {
    for t in parameters::<B>(checks) {
        for &b in basis.values(t).as_ref() {
            if b < B::Scalar::ZERO || b.is_nan() {
                return Err(violation::<B>(Law::Nonnegative, t, b, B::Scalar::ZERO));
            }
        }
    }
    Ok(())
}

/// Curves stay in the convex hull of their control points: in every direction between the smallest and the largest of
/// them.
///
/// # Errors
/// The first violation.
pub fn convex_hull<B: Basis>(basis: &B, checks: &Checks) -> Result<(), Violation> {
    let mut random = Random(checks.seed);
    for t in parameters::<B>(checks) {
        // The components of the points in a random direction are random numbers.
        let points = random.numbers::<B::Scalar, B::Points<B::Scalar>>();
        let found = Curve::new(*basis, points).eval(t);
        let expected = within_hull(found, points.as_ref());
        close::<B>(Law::ConvexHull, t, found, expected, size(points.as_ref()), checks)?;
    }
    Ok(())
}

/// The curve over the points `A P[i] + v` is `A C(t) + v`, in the plane.
///
/// # Errors
/// The first violation.
pub fn affine_invariance<B: Basis>(basis: &B, checks: &Checks) -> Result<(), Violation> {
    let mut random = Random(checks.seed);
    for t in parameters::<B>(checks) {
        let [x, y] = [
            random.numbers::<B::Scalar, B::Points<B::Scalar>>(),
            random.numbers::<B::Scalar, B::Points<B::Scalar>>(),
        ];
        let [a, b, c]: [B::Scalar; 3] = core::array::from_fn(|_| random.between_ones());
        // One row of the map; the other is another round.
        let map = |x: B::Scalar, y: B::Scalar| a * x + b * y + c;
        let mapped: B::Points<B::Scalar> = B::Points::from_fn(|i| map(x.as_ref()[i], y.as_ref()[i]));
        let at = |points| Curve::new(*basis, points).eval(t);
        let size = size(Curve::new(*basis, mapped).to_bernstein().as_ref()).max(B::Scalar::of(3.0));
        close::<B>(Law::AffineInvariance, t, at(mapped), map(at(x), at(y)), size, checks)?;
    }
    Ok(())
}

/// `Σ dᵏb[i]/dtᵏ(t) P[i]`
fn along<B: Basis>(basis: &B, points: &B::Points<B::Scalar>, t: B::Scalar, order: usize) -> B::Scalar {
    let values = basis.derivatives(t, order);
    let terms = values.as_ref().iter().zip(points.as_ref());
    terms.fold(B::Scalar::ZERO, |sum, (&b, &p)| sum + b * p)
}

/// About the cube root of ε, and a power of two.
fn step<S: Scalar>() -> S {
    let mut step = S::ONE;
    while step * step * step > S::EPSILON {
        step = step * S::of(0.5);
    }
    step
}

/// The number nearest to `found` between the smallest and the largest control point; NaN stays NaN.
fn within_hull<S: Scalar>(found: S, points: &[S]) -> S {
    let [low, high] = crate::bernstein::bounds(points);
    if found < low {
        low
    } else if found > high {
        high
    } else {
        found
    }
}

/// The largest absolute value.
fn size<S: Scalar>(values: &[S]) -> S {
    values.iter().fold(S::ZERO, |size, value| size.max(value.abs()))
}

fn close<B: Basis>(
    law: Law,
    t: B::Scalar,
    found: B::Scalar,
    expected: B::Scalar,
    size: B::Scalar,
    checks: &Checks,
) -> Result<(), Violation> {
    let near = checks.accept(found, expected, size, B::DEGREE);
    if near { Ok(()) } else { Err(violation::<B>(law, t, found, expected)) }
}

fn exact<B: Basis>(law: Law, t: B::Scalar, found: B::Scalar, expected: B::Scalar) -> Result<(), Violation> {
    if found == expected { Ok(()) } else { Err(violation::<B>(law, t, found, expected)) }
}

fn violation<B: Basis>(law: Law, t: B::Scalar, found: B::Scalar, expected: B::Scalar) -> Violation {
    let at = Place::new(&[t]);
    Violation { law, family: B::NAME, at, found: found.to_f64(), expected: expected.to_f64() }
}

/// Both ends of the domain, then random parameters, every fourth close to an end.
fn parameters<B: Basis>(checks: &Checks) -> impl Iterator<Item = B::Scalar> {
    let mut random = Random(!checks.seed);
    let [lo, hi] = B::domain();
    let inner = (0..checks.samples).map(move |round| {
        let x: B::Scalar = random.unit();
        let x = match round % 8 {
            0 => x * x * x * x,
            4 => B::Scalar::ONE - x * x * x * x,
            _ => x,
        };
        from_unit([lo, hi], x)
    });
    [lo, hi].into_iter().chain(inner)
}

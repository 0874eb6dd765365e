//! Every family of the library on a triangle, a tetrahedron or a box, and some on prisms, generated in this crate as in
//! any other.

use basis_engine::algebra::fraction::Fraction;
use basis_engine::algebra::rational::{Rational, ToFloat as _};
use basis_engine::model::Factor;
use basis_runtime::{
    BoxBasis, BoxPatch, DomainFactor, ProductBasis, ProductPatch, Scalar, ShapeError, SimplexBasis,
    SimplexPatch, basis,
};

use crate::exact::{Reference, fraction};
use crate::random::Random;

basis!(library "elements");
basis!(library "lagrange", Bilinear, Serendipity);
basis!(library "lagrange", TriangularLagrange(1) as P1, TriangularLagrange(4) as P4);
basis!(
    library "lagrange",
    TetrahedralLagrange(1) as Tetrahedral1,
    TetrahedralLagrange(2) as Tetrahedral2
);
basis!(library "triangular", TriangularBernstein(1) as TriangularLinear, TriangularBernstein(3));
basis!(
    library "triangular",
    TriangularI(2),
    TriangularI(3) as TriangularI3,
    TriangularI(8) as TriangularI8
);
basis!(
    library "triangular",
    TriangularII(3),
    TriangularII(5) as TriangularII5,
    TriangularII(8) as TriangularII8
);
basis!(library "triangles/prisms", QuadraticWedge, TriquadraticWedge);
basis!("../specs/good/patches.basis");
basis!("../specs/good/double_zeros.basis", TouchingTriangle, TouchingBox);

/// A generated type, with what it needs to be compared with its spec; the same for simplices, boxes and products.
pub trait ShippedPatch: Copy {
    /// The scalar type.
    type Scalar: Scalar;

    /// The file, the family and its order.
    fn reference() -> Reference;

    /// The family with shape values.
    ///
    /// # Errors
    /// As `new`.
    fn with(shape: &[Self::Scalar]) -> Result<Self, ShapeError>;

    /// The values at a point with all coordinates.
    fn values(&self, at: &[Self::Scalar]) -> Vec<Self::Scalar>;

    /// The partial derivatives in the independent coordinates.
    fn partials(&self, at: &[Self::Scalar], orders: &[usize]) -> Vec<Self::Scalar>;

    /// The partial derivative of these orders of the patch over control points that are numbers; the point for orders
    /// 0.
    fn patch(&self, points: &[Self::Scalar], at: &[Self::Scalar], orders: &[usize]) -> Self::Scalar;

    /// As the method of the type.
    fn bernstein_coefficients(&self) -> Vec<Vec<Self::Scalar>>;

    /// The highest degree.
    fn degree() -> usize;

    /// Coordinates whose exact sum on a simplex is 1: often on an edge or very close to one.
    fn point(reference: &Reference, random: &mut Random) -> Vec<Self::Scalar> {
        let family = &reference.family;
        let unit = if size_of::<Self::Scalar>() == 4 { 1_u64 << 23 } else { 1 << 52 };
        let whole = |k: u64| Self::Scalar::of(k as f64 / unit as f64);
        let mut all = Vec::new();
        for factor in family.factors() {
            let corners = match factor {
                Factor::Interval(p) => {
                    let (low, high) = p.range.finite().expect("two ends");
                    let x: f64 = random.unit();
                    all.push(Self::Scalar::of(low.to_f64() + (high.to_f64() - low.to_f64()) * x));
                    continue;
                }
                Factor::Simplex(independent, _) => independent.len() + 1,
            };
            let mut rest = unit;
            let mut point: Vec<Self::Scalar> = Vec::new();
            for _ in 1..corners {
                let part = match random.below(5) {
                    0 => 0,
                    1 => rest,
                    2 => random.below(8) as u64,
                    _ => random.below(rest as usize + 1) as u64,
                };
                let part = part.min(rest);
                rest -= part;
                point.push(whole(part));
            }
            point.push(whole(rest));
            let turn = random.below(point.len());
            point.rotate_left(turn);
            all.extend(point);
        }
        all
    }
}

/// The exact partial derivatives of these orders of all functions, at a point with all coordinates.
///
/// # Panics
/// When a denominator vanishes.
pub fn exact<S: Scalar>(reference: &Reference, shape: &[S], at: &[S], orders: &[usize]) -> Vec<Rational> {
    let family = &reference.family;
    let mut coordinates: Vec<Rational> = vec![Rational::ZERO; family.names.len() + 1];
    let variables = family.shapes.iter().chain(family.domain_variables());
    for (p, x) in variables.zip(shape.iter().chain(at)) {
        coordinates[p.var.0] = fraction(*x);
    }
    let derivative = |f: &Fraction| {
        family
            .domain
            .iter()
            .zip(orders)
            .fold(f.clone(), |f, (p, order)| (0..*order).fold(f, |f, _| f.derivative(p.var)))
    };
    let one = |f: &basis_engine::model::Function| derivative(&f.value).eval(&coordinates).expect("no pole");
    family.functions.iter().map(one).collect()
}

/// The degree in the coordinates of a factor.
fn degree(factor: &DomainFactor) -> usize {
    match *factor {
        DomainFactor::Interval { degree }
        | DomainFactor::Triangle { degree }
        | DomainFactor::Tetrahedron { degree } => degree,
        _ => unreachable!("another factor"),
    }
}

macro_rules! patches {
    ($($kind:ident $type:ident: $file:literal $name:ident $order:expr, ($($shape:ident),*) => $new:expr;)+) => {$(
        impl<S: Scalar> ShippedPatch for $type<S> {
            type Scalar = S;
            fn reference() -> Reference {
                Reference::new($file, stringify!($name), &$order)
            }
            fn with(shape: &[S]) -> Result<Self, ShapeError> {
                let [$($shape),*] = *shape else { panic!("wrong number of shape values") };
                $new
            }
            fn values(&self, at: &[S]) -> Vec<S> {
                $type::values(self, at.try_into().expect("all coordinates")).to_vec()
            }
            fn partials(&self, at: &[S], orders: &[usize]) -> Vec<S> {
                let at = at.try_into().expect("all coordinates");
                $type::partials(self, at, orders.try_into().expect("all orders")).to_vec()
            }
            fn patch(&self, points: &[S], at: &[S], orders: &[usize]) -> S {
                let points = points.try_into().expect("all points");
                let at = at.try_into().expect("all coordinates");
                patches!(@patch $kind *self, points, at, orders)
            }
            fn bernstein_coefficients(&self) -> Vec<Vec<S>> {
                $type::bernstein_coefficients(self).iter().map(|row| row.to_vec()).collect()
            }
            fn degree() -> usize {
                patches!(@degree $kind Self)
            }
        }
    )+};
    (@patch simplex $basis:expr, $points:ident, $at:ident, $orders:ident) => {{
        let patch = SimplexPatch::new($basis, $points);
        match $orders.iter().all(|order| *order == 0) {
            true => patch.eval_at($at),
            false => patch.partial_at($at, $orders.try_into().expect("all orders")),
        }
    }};
    (@patch box $basis:expr, $points:ident, $at:ident, $orders:ident) => {
        BoxPatch::new($basis, $points).partial_at($at, $orders.try_into().expect("all orders"))
    };
    (@patch product $basis:expr, $points:ident, $at:ident, $orders:ident) => {
        ProductPatch::new($basis, $points).partial_at($at, $orders.try_into().expect("all orders"))
    };
    (@degree product $type:ty) => {
        <$type as ProductBasis>::FACTORS.iter().map(degree).max().unwrap_or(0)
    };
    (@degree simplex $type:ty) => { <$type as SimplexBasis>::DEGREE };
    (@degree box $type:ty) => { <$type as BoxBasis>::DEGREES.iter().copied().max().unwrap_or(0) };
}
patches! {
    simplex CrouzeixRaviart: "elements.basis" CrouzeixRaviart [], () => Ok(Self::new());
    simplex HermiteTriangle: "elements.basis" HermiteTriangle [], () => Ok(Self::new());
    box Trilinear: "elements.basis" Trilinear [], () => Ok(Self::new());
    box Bilinear: "lagrange.basis" Bilinear [], () => Ok(Self::new());
    box Serendipity: "lagrange.basis" Serendipity [], () => Ok(Self::new());
    simplex P1: "lagrange.basis" TriangularLagrange [1], () => Ok(Self::new());
    simplex P4: "lagrange.basis" TriangularLagrange [4], () => Ok(Self::new());
    simplex Tetrahedral1: "lagrange.basis" TetrahedralLagrange [1], () => Ok(Self::new());
    simplex Tetrahedral2: "lagrange.basis" TetrahedralLagrange [2], () => Ok(Self::new());
    simplex TriangularLinear: "triangular.basis" TriangularBernstein [1], () => Ok(Self::new());
    simplex TriangularBernstein: "triangular.basis" TriangularBernstein [3], () => Ok(Self::new());
    simplex TriangularI: "triangular.basis" TriangularI [2], (a, b) => Self::new(a, b);
    simplex TriangularI3: "triangular.basis" TriangularI [3], (a, b) => Self::new(a, b);
    simplex TriangularI8: "triangular.basis" TriangularI [8], (a, b) => Self::new(a, b);
    simplex TriangularII: "triangular.basis" TriangularII [3], (a, b) => Self::new(a, b);
    simplex TriangularII5: "triangular.basis" TriangularII [5], (a, b) => Self::new(a, b);
    simplex TriangularII8: "triangular.basis" TriangularII [8], (a, b) => Self::new(a, b);
    product QuadraticWedge: "triangles/prisms.basis" QuadraticWedge [], () => Ok(Self::new());
    product TriquadraticWedge: "triangles/prisms.basis" TriquadraticWedge [], () => Ok(Self::new());
    simplex Bubble: "../tests/specs/good/patches.basis" Bubble [], (mu) => Self::new(mu);
    simplex Quotients: "../tests/specs/good/patches.basis" Quotients [], (mu) => Self::new(mu);
    box Brick: "../tests/specs/good/patches.basis" Brick [], (lambda) => Self::new(lambda);
    simplex TouchingTriangle: "../tests/specs/good/double_zeros.basis" TouchingTriangle [], (m) => Self::new(m);
    box TouchingBox: "../tests/specs/good/double_zeros.basis" TouchingBox [], (m, n) => Self::new(m, n);
    product Column: "../tests/specs/good/patches.basis" Column [], (lambda) => Self::new(lambda);
}

/// Calls a function, generic over [`ShippedPatch`], for every family on a simplex or a box with that scalar type but the two
/// with double zeros, whose values have no small relative errors.
#[macro_export]
macro_rules! each_patch {
    ($scalar:ty, $visit:ident $(, $argument:expr)*) => {
        $crate::each_patch!(@ $scalar, $visit, ($($argument),*),
            CrouzeixRaviart HermiteTriangle Trilinear Bilinear Serendipity P1 P4 Tetrahedral1 Tetrahedral2 TriangularLinear TriangularBernstein TriangularI
            TriangularI3 TriangularI8 TriangularII TriangularII5 TriangularII8 QuadraticWedge TriquadraticWedge Bubble Quotients Brick Column)
    };
    (@ $scalar:ty, $visit:ident, $arguments:tt, $($type:ident)+) => {
        $($crate::each_patch!(% $visit::<$crate::patches::$type<$scalar>>, $arguments);)+
    };
    (% $visit:expr, ($($argument:expr),*)) => { $visit($($argument),*) };
}

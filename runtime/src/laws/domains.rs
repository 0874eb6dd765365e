//! The laws of families of several coordinates, by domain.

use super::patches::{self, Patches};
use super::{Checks, Violation, size};
use crate::{
    Array, BoxBasis, BoxPatch, DomainFactor, ProductBasis, ProductPatch, SimplexBasis, SimplexPatch,
};

/// A family with its domain.
#[derive(Clone, Copy)]
struct OnSimplex<B>(B);

#[derive(Clone, Copy)]
struct OnBox<B>(B);

#[derive(Clone, Copy)]
struct OnProduct<B>(B);

/// What all three say alike.
macro_rules! patches {
    ($($wrapper:ident: $basis:ident, $patch:ident, $low:expr, $high:expr, $factor:expr;)+) => {$(
        impl<B: $basis> Patches for $wrapper<B> {
            type Scalar = B::Scalar;
            type Coordinates = B::Coordinates;
            type Values = B::Values;
            type Points = B::Points<B::Scalar>;

            const NAME: &'static str = B::NAME;

            fn factor(index: usize) -> Option<DomainFactor> {
                $factor(index)
            }

            fn range(coordinate: usize) -> [B::Scalar; 2] {
                [$low, $high].map(|of| of(coordinate))
            }

            fn partials(&self, at: B::Coordinates, orders: &[usize]) -> B::Values {
                self.0.partials(at, B::Orders::from_fn(|i| orders[i]))
            }

            fn values(&self, at: B::Coordinates) -> B::Values {
                self.0.values(at)
            }

            fn patch(
                &self,
                points: B::Points<B::Scalar>,
                at: B::Coordinates,
                orders: Option<&[usize]>,
            ) -> B::Scalar {
                let patch = $patch::new(self.0, points);
                match orders {
                    Some(orders) => patch.partial_at(at, B::Orders::from_fn(|i| orders[i])),
                    None => patch.eval_at(at),
                }
            }

            fn largest(&self, points: B::Points<B::Scalar>) -> B::Scalar {
                size(self.0.to_bernstein(&points).as_ref())
            }
        }
    )+};
}

fn simplex<B: SimplexBasis>(index: usize) -> Option<DomainFactor> {
    let degree = B::DEGREE;
    let factor = match <B::Coordinates as Array<B::Scalar>>::LEN {
        3 => DomainFactor::Triangle { degree },
        _ => DomainFactor::Tetrahedron { degree },
    };
    (index == 0).then_some(factor)
}

patches! {
    OnSimplex: SimplexBasis, SimplexPatch,
        |_| crate::Scalar::ZERO, |_| crate::Scalar::ONE, simplex::<B>;
    OnBox: BoxBasis, BoxPatch,
        |i: usize| B::domain()[0].as_ref()[i], |i: usize| B::domain()[1].as_ref()[i],
        |index: usize| B::DEGREES.get(index).map(|&degree| DomainFactor::Interval { degree });
    OnProduct: ProductBasis, ProductPatch,
        |i: usize| B::domain()[0].as_ref()[i], |i: usize| B::domain()[1].as_ref()[i],
        |index: usize| B::FACTORS.get(index).copied();
}

macro_rules! laws {
    ($($module:ident: $basis:ident, $wrapper:ident, $on:literal;)+) => {$(
        #[doc = concat!("The laws of families on ", $on, ".")]
        pub mod $module {
            use super::{$basis, $wrapper, Checks, Violation, patches};

            /// The laws that every implementation keeps: [`form`], [`derivatives`].
            ///
            /// # Errors
            /// The first violation.
            pub fn consistent<B: $basis>(basis: &B, checks: &Checks) -> Result<(), Violation> {
                form(basis, checks)?;
                derivatives(basis, checks)
            }

            /// The laws of bases for modelling: [`partition_of_unity`], [`nonnegative`], [`convex_hull`],
            /// [`affine_invariance`].
            ///
            /// # Errors
            /// The first violation.
            pub fn geometric<B: $basis>(basis: &B, checks: &Checks) -> Result<(), Violation> {
                partition_of_unity(basis, checks)?;
                nonnegative(basis, checks)?;
                convex_hull(basis, checks)?;
                affine_invariance(basis, checks)
            }

            /// A patch is `Σ b[i] P[i]`, and so is the one over its Bernstein net.
            ///
            /// # Errors
            /// The first violation.
            pub fn form<B: $basis>(basis: &B, checks: &Checks) -> Result<(), Violation> {
                patches::form($wrapper(*basis), checks)
            }

            /// The derivative of each order in each coordinate is the limit of differences of the order below it; zero
            /// above the degree. Derivatives of patches are sums of those of the functions.
            ///
            /// # Errors
            /// The first violation.
            pub fn derivatives<B: $basis>(basis: &B, checks: &Checks) -> Result<(), Violation> {
                patches::derivatives($wrapper(*basis), checks)
            }

            /// `Σ b[i] = 1`
            ///
            /// # Errors
            /// The first violation.
            pub fn partition_of_unity<B: $basis>(basis: &B, checks: &Checks) -> Result<(), Violation> {
                patches::partition_of_unity($wrapper(*basis), checks)
            }

            /// `b[i] >= 0`, without any tolerance.
            ///
            /// # Errors
            /// The first violation.
            pub fn nonnegative<B: $basis>(basis: &B, checks: &Checks) -> Result<(), Violation> {
                patches::nonnegative($wrapper(*basis), checks)
            }

            /// Patches stay in the convex hull of their control points.
            ///
            /// # Errors
            /// The first violation.
            pub fn convex_hull<B: $basis>(basis: &B, checks: &Checks) -> Result<(), Violation> {
                patches::convex_hull($wrapper(*basis), checks)
            }

            /// The patch over the points `A P[i] + v` is the image of the patch, in the plane.
            ///
            /// # Errors
            /// The first violation.
            pub fn affine_invariance<B: $basis>(basis: &B, checks: &Checks) -> Result<(), Violation> {
                patches::affine_invariance($wrapper(*basis), checks)
            }
        }
    )+};
}

laws! {
    simplices: SimplexBasis, OnSimplex, "triangles and tetrahedra";
    boxes: BoxBasis, OnBox, "boxes";
    products: ProductBasis, OnProduct, "products of simplices and intervals";
}

//! The scalar types, `f32` and `f64`, behind one trait.

use core::fmt::Display;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::Point;

/// Whether this build fuses `a * b + c` into one instruction everywhere: the target always has it.
///
/// A `mul_add` on a target without the instruction is a library call, more than ten times slower than two operations.
pub const FUSED_HERE: bool = cfg!(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64")));

/// A floating-point number: `f32` or `f64`.
///
/// A scalar is also a [`Point`] of dimension one, so a curve may be scalar-valued.
///
/// ```
/// use basis_runtime::Scalar;
///
/// fn midpoint<S: Scalar>(a: S, b: S) -> S {
///     (a + b) * S::of(0.5)
/// }
/// assert_eq!(midpoint(1.0_f32, 4.0), 2.5);
/// ```
pub trait Scalar:
    sealed::Sealed
    + Point<Scalar = Self>
    + PartialOrd
    + Display
    + Default
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;
    /// The distance from 1 to the next larger number.
    const EPSILON: Self;
    /// A full half-turn, π.
    const PI: Self;
    /// The smallest positive number that still has all its digits.
    const MIN_POSITIVE: Self;
    /// Positive infinity.
    const INFINITY: Self;
    /// Not a number.
    const NAN: Self;

    /// The scalar nearest to `value`.
    fn of(value: f64) -> Self;

    /// The scalar nearest to `count`.
    fn from_usize(count: usize) -> Self;

    /// The same number as `f64`, exactly.
    fn to_f64(self) -> f64;

    /// Whether the number is neither infinite nor NaN.
    fn is_finite(self) -> bool;

    /// Whether the number is NaN.
    fn is_nan(self) -> bool;

    /// The absolute value.
    fn abs(self) -> Self;

    /// The smaller of both; the other one if one of them is NaN.
    fn min(self, other: Self) -> Self;

    /// The larger of both; the other one if one of them is NaN.
    fn max(self, other: Self) -> Self;

    /// The square root; NaN of a negative number.
    fn sqrt(self) -> Self;

    /// The sine and the cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);

    /// The angle of the point `(x, self)` in radians, from -π to π.
    fn atan2(self, x: Self) -> Self;

    /// `exp(self) - 1`, with a small relative error also near zero.
    fn exp_m1(self) -> Self;

    /// The natural logarithm of `1 + self`, with a small relative error also near zero.
    fn ln_1p(self) -> Self;

    /// `self * factor + addend`, rounded once if `FUSED` and twice otherwise.
    ///
    /// `FUSED` belongs inside functions compiled for a target feature that has the instruction; everywhere else it is
    /// [`FUSED_HERE`]. Without the feature `std` the result is always rounded twice.
    fn fma<const FUSED: bool>(self, factor: Self, addend: Self) -> Self;
}

mod sealed {
    pub trait Sealed: core::fmt::Debug {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

macro_rules! scalars {
    ($($scalar:ident: $sqrt:ident $sincos:ident $atan2:ident $expm1:ident $log1p:ident;)+) => {$(
        impl Scalar for $scalar {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const EPSILON: Self = $scalar::EPSILON;
            const PI: Self = core::$scalar::consts::PI;
            const MIN_POSITIVE: Self = $scalar::MIN_POSITIVE;
            const INFINITY: Self = $scalar::INFINITY;
            const NAN: Self = $scalar::NAN;

            #[inline]
            fn of(value: f64) -> Self {
                value as $scalar
            }

            #[inline]
            fn from_usize(count: usize) -> Self {
                count as $scalar
            }

            #[inline]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }

            #[inline]
            fn is_finite(self) -> bool {
                self.is_finite()
            }

            #[inline]
            fn is_nan(self) -> bool {
                self.is_nan()
            }

            #[inline]
            fn abs(self) -> Self {
                self.abs()
            }

            #[inline]
            fn min(self, other: Self) -> Self {
                self.min(other)
            }

            #[inline]
            fn max(self, other: Self) -> Self {
                self.max(other)
            }

            #[inline]
            fn sqrt(self) -> Self {
                #[cfg(feature = "std")]
                return self.sqrt();
                #[cfg(all(feature = "libm", not(feature = "std")))]
                return libm::$sqrt(self);
                #[cfg(not(any(feature = "std", feature = "libm")))]
                return Self::NAN; // such a build is refused in lib.rs
            }

            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                #[cfg(feature = "std")]
                return self.sin_cos();
                #[cfg(all(feature = "libm", not(feature = "std")))]
                return libm::$sincos(self);
                #[cfg(not(any(feature = "std", feature = "libm")))]
                return (Self::NAN, Self::NAN); // such a build is refused in lib.rs
            }

            #[inline]
            fn atan2(self, x: Self) -> Self {
                #[cfg(feature = "std")]
                return self.atan2(x);
                #[cfg(all(feature = "libm", not(feature = "std")))]
                return libm::$atan2(self, x);
                #[cfg(not(any(feature = "std", feature = "libm")))]
                return self * x; // such a build is refused in lib.rs
            }

            #[inline]
            fn exp_m1(self) -> Self {
                #[cfg(feature = "std")]
                return self.exp_m1();
                #[cfg(all(feature = "libm", not(feature = "std")))]
                return libm::$expm1(self);
                #[cfg(not(any(feature = "std", feature = "libm")))]
                return Self::NAN; // such a build is refused in lib.rs
            }

            #[inline]
            fn ln_1p(self) -> Self {
                #[cfg(feature = "std")]
                return self.ln_1p();
                #[cfg(all(feature = "libm", not(feature = "std")))]
                return libm::$log1p(self);
                #[cfg(not(any(feature = "std", feature = "libm")))]
                return Self::NAN; // such a build is refused in lib.rs
            }

            #[inline]
            fn fma<const FUSED: bool>(self, factor: Self, addend: Self) -> Self {
                #[cfg(feature = "std")]
                if FUSED {
                    return self.mul_add(factor, addend);
                }
                self * factor + addend
            }
        }
    )+};
}
scalars! {
    f32: sqrtf sincosf atan2f expm1f log1pf;
    f64: sqrt sincos atan2 expm1 log1p;
}

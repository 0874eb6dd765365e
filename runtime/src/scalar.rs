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
    + Point<Scalar = Self, Vector = Self>
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
    /// What [`elementary`](crate::elementary) knows of a type.
    pub trait Sealed: core::fmt::Debug + Copy + 'static {
        /// π without [`Scalar::PI`](super::Scalar::PI).
        const PI_REST: Self;
        /// `sin w = w + w³ P(w²)` on `0 <= w <= π/2`: the coefficients of P.
        const SINE: &'static [Self];
        /// `exp r - 1 = r + r² Q(r)` for `|r| <= ln 2 / 2`: the coefficients of Q.
        const EXP: &'static [Self];
        /// Below this exp is taken for exp of this.
        const LEAST_EXPONENT: Self;
        /// ln 2 as a number with few digits and the rest.
        const LN_2: [Self; 2];
        /// 1 / ln 2.
        const LOG2_E: Self;
        /// A number whose neighbours are at distance 1.
        const TO_WHOLE: Self;

        /// The numbers in which the coordinates of charts and tangents of shape parameters are computed, as they count
        /// in every value and to a high power: with `std` those of double precision. Without it those of the type
        /// itself; small processors have no others.
        type Wide: super::Scalar;
        /// The same number.
        fn wide(self) -> Self::Wide;
        /// The nearest number of this type.
        fn narrow(wide: Self::Wide) -> Self;

        /// `2^k` of the sum of `k` and [`TO_WHOLE`](Self::TO_WHOLE), if it has all its digits.
        fn power_of_two(self) -> Self;

        /// The power of two by which a positive number becomes one from 1 to 2, or the nearest to it that is a float.
        fn inverse_power_of_two(self) -> Self;
    }

    impl Sealed for f32 {
        const PI_REST: Self = -8.742_278e-8;
        // To 0.1 ε.
        const SINE: &'static [Self] = &[-0.166_666_6, 0.008_333_066, -0.000_198_095_77, 2.605_72e-6];
        // To 0.01 ε.
        const EXP: &'static [Self] =
            &[0.5, 0.166_666_67, 0.041_666_463, 0.008_333_311, 0.001_393_390_1, 0.000_198_912_69];
        const LEAST_EXPONENT: Self = -86.0;
        const LN_2: [Self; 2] = [355.0 / 512.0, -2.121_944_4e-4];
        const LOG2_E: Self = core::f32::consts::LOG2_E;
        const TO_WHOLE: Self = 12_582_912.0; // 3/2 2²³

        #[cfg(feature = "std")]
        type Wide = f64;
        #[cfg(not(feature = "std"))]
        type Wide = Self;

        #[inline]
        fn wide(self) -> Self::Wide {
            Self::Wide::from(self)
        }

        #[inline]
        fn narrow(wide: Self::Wide) -> Self {
            wide as Self
        }

        #[inline(always)]
        #[allow(clippy::inline_always)]
        fn power_of_two(self) -> Self {
            // The last bits of the mantissa are k, which belongs where the exponent of 1 is.
            Self::from_bits((self.to_bits() << 23).wrapping_add(1.0_f32.to_bits()))
        }

        #[inline]
        fn inverse_power_of_two(self) -> Self {
            let exponent = (self.to_bits() >> 23) & 255;
            Self::from_bits(254_u32.saturating_sub(exponent).max(1) << 23)
        }
    }

    impl Sealed for f64 {
        const PI_REST: Self = 1.224_646_799_147_353_2e-16;
        // To 0.003 ε.
        const SINE: &'static [Self] = &[
            -0.166_666_666_666_666_66,
            0.008_333_333_333_333_194,
            -0.000_198_412_698_412_090_7,
            2.755_731_921_110_889e-6,
            -2.505_210_687_032_315_7e-8,
            1.605_893_957_826_036e-10,
            -7.642_988_092_708_263e-13,
            2.721_138_442_410_517_7e-15,
        ];
        // To 0.005 ε.
        const EXP: &'static [Self] = &[
            0.5,
            0.166_666_666_666_666_7,
            0.041_666_666_666_666_67,
            0.008_333_333_333_325_973,
            0.001_388_888_888_888_363_3,
            0.000_198_412_698_753_854_8,
            2.480_158_732_595_111e-5,
            2.755_725_468_572_88e-6,
            2.755_727_313_289_604e-7,
            2.510_551_354_184_708_5e-8,
            2.091_489_872_917_552_4e-9,
        ];
        const LEAST_EXPONENT: Self = -700.0;
        const LN_2: [Self; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];
        const LOG2_E: Self = core::f64::consts::LOG2_E;
        const TO_WHOLE: Self = 6_755_399_441_055_744.0; // 3/2 2⁵²

        type Wide = Self;

        #[inline]
        fn wide(self) -> Self {
            self
        }

        #[inline]
        fn narrow(wide: Self) -> Self {
            wide
        }

        #[inline(always)]
        #[allow(clippy::inline_always)]
        fn power_of_two(self) -> Self {
            Self::from_bits((self.to_bits() << 52).wrapping_add(1.0_f64.to_bits()))
        }

        #[inline]
        fn inverse_power_of_two(self) -> Self {
            let exponent = (self.to_bits() >> 52) & 2047;
            Self::from_bits(2046_u64.saturating_sub(exponent).max(1) << 52)
        }
    }
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

//! Runs a loop over a slice with the widest vector instructions that the processor has.
//!
//! Loops are written once, in portable code; the compiler vectorises them, once for each set of instructions. This is
//! the only place of the crate with `unsafe` code.

/// The number of points from which on choosing the instructions costs less than it saves.
pub(crate) const WORTHWHILE: usize = 16;

/// A loop over a slice.
pub(crate) trait Kernel {
    /// Runs the loop. `FUSED` says that `a * b + c` is one instruction; pass it on to
    /// [`Scalar::fma`](crate::Scalar::fma).
    ///
    /// An implementation is marked `#[inline(always)]` and so is all that it calls: only what is inlined into the
    /// functions of this module is compiled for their instructions.
    fn run<const FUSED: bool>(self);
}

/// Runs a kernel over `len` points.
#[inline]
pub(crate) fn dispatch(len: usize, kernel: impl Kernel) {
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    if len >= WORTHWHILE {
        return x86_64::dispatch(kernel);
    }
    // NEON is part of every 64-bit ARM processor: there FUSED_HERE is true.
    let _ = len;
    kernel.run::<{ crate::FUSED_HERE }>();
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[allow(unsafe_code)]
mod x86_64 {
    use std::is_x86_feature_detected;

    use super::Kernel;

    #[inline]
    pub(super) fn dispatch(kernel: impl Kernel) {
        // The answer is cached by the standard library: one load and one comparison each.
        let avx2 = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
        #[cfg(has_avx512)]
        if avx2 && is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512vl") {
            // SAFETY: the processor has the features that the function is compiled for.
            return unsafe { avx512(kernel) };
        }
        if avx2 {
            // SAFETY: the processor has the features that the function is compiled for.
            unsafe { avx2_fma(kernel) }
        } else {
            kernel.run::<{ crate::FUSED_HERE }>();
        }
    }

    #[cfg(has_avx512)] // from rustc 1.89 on, says build.rs
    #[target_feature(enable = "avx512f,avx512vl,avx2,fma")]
    fn avx512(kernel: impl Kernel) {
        kernel.run::<true>();
    }

    #[target_feature(enable = "avx2,fma")]
    fn avx2_fma(kernel: impl Kernel) {
        kernel.run::<true>();
    }
}

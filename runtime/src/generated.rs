//! What files call that `basis emit --to rust` has written.
//!
//! Such a file has the code that [`basis!`](crate::basis!) would make, without the macro: a crate that holds one builds
//! no engine. `basis emit --check` says whether it is what the spec gives now.

/// The functions that the code calls. None of them goes or changes; code of a later version may call others.
pub mod v1 {
    pub use crate::__private::{
        affine_bernstein, bernstein, box_sum, check_end, check_point, check_reach, check_reach_below,
        check_shape, combine, cut_off, end_points, inverse_power_of_two, multinomials, powers, raise_weights,
        simplex_sum, table, tan, tan_complement, tanh, tanh_complement, unit,
    };
}

/// Stops the build with a message when a spec is not the one from which a file was written: when FNV-1a of its bytes but
/// for carriage returns, which some checkouts add, is not `digest`.
///
/// ```
/// const _: () = basis_runtime::generated::unchanged(b"a\r\n", 0x089b_dc07_b544_e7b2, "the text is another one");
/// ```
///
/// # Panics
/// With the message; in a constant that is an error of the compiler.
pub const fn unchanged(spec: &[u8], digest: u64, message: &str) {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    let mut k = 0;
    while k < spec.len() {
        if spec[k] != b'\r' {
            hash = (hash ^ spec[k] as u64).wrapping_mul(0x0100_0000_01b3);
        }
        k += 1;
    }
    assert!(hash == digest, "{}", message);
}

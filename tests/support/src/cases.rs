//! How many cases a test takes.

/// Whether all cases are asked for, `BASIS_TESTS=all`, as by the gate. Without it `cargo test` leaves out random cases
/// that most likely tell nothing new: the numbers of a run are always the same.
pub fn all_cases() -> bool {
    std::env::var_os("BASIS_TESTS").is_some_and(|value| value == "all")
}

/// `all` cases where all are asked for, otherwise the first quarter.
pub fn cases(all: usize) -> usize {
    if all_cases() { all } else { all.div_ceil(4) }
}

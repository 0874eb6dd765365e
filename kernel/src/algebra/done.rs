//! Notes what operations have taken, for those that compute before there is a limit; no proof depends on it.

std::thread_local! {
    static DONE: core::cell::Cell<u64> = const { core::cell::Cell::new(0) };
}

/// The units that polynomials and long numbers have taken on this thread, roughly, counted in advance or not.
pub fn done() -> u64 {
    DONE.get()
}

/// Notes an operation.
pub(super) fn did(units: u64) {
    DONE.set(DONE.get().saturating_add(units));
}

//! `cargo xtask nightly [STEP…]`: the checks that take too long for every change. The gate for every change is `.ci/run`.
//!
//! Each step prints what it does; a step whose tools cannot be had is reported as skipped, and never as passed. The exit
//! code is 1 if a step fails.

mod nightly;

use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.split_first() {
        Some((command, steps)) if command == "nightly" => nightly::run(steps),
        _ => {
            eprintln!("usage: cargo xtask nightly [STEP…]; the steps are\n{}", nightly::list());
            ExitCode::from(2)
        }
    }
}

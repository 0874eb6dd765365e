//! Leaves out of the installed command what only unwinding needs, an eighth of it.
//!
//! The profile `release` of this workspace aborts where a panic would unwind. The compiler writes the tables of
//! unwinding all the same, for backtraces, of which a command without symbols shows numbers alone; no profile can
//! switch them off, but a linker can drop them.

use std::env::var;
use std::fs::write;
use std::path::Path;

/// What the linker is told beside its own rules.
const SCRIPT: &str = "SECTIONS { /DISCARD/ : { *(.eh_frame) } } INSERT AFTER .text;\n";

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let is = |name, value| var(name).is_ok_and(|v| v == value);
    // Cargo does not tell a build script whether panics abort; of our profiles those do that are compiled to be small.
    let aborts = is("OPT_LEVEL", "z");
    // GNU's linker and LLVM's, one of which is the default here, know such scripts; gold and mold refuse them.
    let linker_is_default = is("TARGET", "x86_64-unknown-linux-gnu")
        && is("CARGO_ENCODED_RUSTFLAGS", "")
        && var("RUSTC_LINKER").is_err();
    if aborts && linker_is_default {
        let script = Path::new(&var("OUT_DIR").expect("Cargo sets it")).join("without_unwinding.ld");
        write(&script, SCRIPT).expect("Cargo has made the folder");
        println!("cargo::rustc-link-arg-bins=-Wl,-T,{}", script.display());
    }
}

//! Writes a spec that uses a second one, and one of the library.

use std::path::PathBuf;
use std::{env, fs};

fn main() {
    let folder = PathBuf::from(env::var_os("OUT_DIR").expect("Cargo sets it"));
    let write =
        |name: &str, text: &str| fs::write(folder.join(name), text).expect("the folder can be written");
    write(
        "ease.basis",
        "use \"line.basis\";\nuse library \"quartic\";\nfamily Ease {\n    domain 0 <= t <= 1;\n\
         \x20   b[0] = Line[0]^3*(1 + 3*t);\n    b[1] = 1 - b[0];\n    prove partition_of_unity;\n\
         \x20   prove b[0] - QuarticBernstein(1)[0] = 4*t*(1 - t)^3;\n}\n",
    );
    write("line.basis", "family Line {\n    domain 0 <= t <= 1;\n    b[0] = 1 - t;\n    b[1] = t;\n}\n");
    println!("cargo::rerun-if-changed=build.rs");
}

//! What the compiler prints for a wrong macro call, and calls that it accepts.
//!
//! `TRYBUILD=overwrite cargo test -p basis-tests-ui` writes the output of today into the `.stderr` files.

#[test]
fn errors_of_the_compiler() {
    let cases = trybuild::TestCases::new();
    cases.pass("pass/*.rs");
    cases.compile_fail("files/*.rs");
    cases.compile_fail("inline/*.rs");
}

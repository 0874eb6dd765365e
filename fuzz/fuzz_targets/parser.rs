#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| basis_fuzz::parser(data));

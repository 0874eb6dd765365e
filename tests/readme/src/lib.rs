//! Every block of Rust in the README, and on a page of the guide, compiles and runs as it stands there; `build.rs` says
//! what each builds on.

#![allow(mixed_script_confusables)] // a family has its angle as θ

#[cfg(test)]
mod tests {
    #[allow(unused, clippy::all, clippy::pedantic)] // a block shows what there is, and not all that is done with it
    mod readme {
        include!(concat!(env!("OUT_DIR"), "/readme.rs"));
    }

    #[test]
    fn curves() {
        readme::curves().expect("it runs");
    }

    #[test]
    fn triangles() {
        readme::triangles().expect("it runs");
    }

    #[test]
    fn surfaces() {
        // It writes a file.
        let folder = tempfile::tempdir().expect("a temporary folder can be made");
        std::env::set_current_dir(folder.path()).expect("the folder is there");
        readme::surfaces().expect("it runs");
    }

    #[test]
    fn splices() {
        readme::splices().expect("it runs");
    }

    #[test]
    fn angles() {
        readme::angles().expect("it runs");
    }
}

//! The macro [`basis!`]: finds the spec, calls the engine, hands back code or errors.
//!
//! Depend on `basis-runtime`, which exports the macro together with what the generated code needs.

mod errors;
mod input;
mod path;

use std::path::PathBuf;

use basis_engine::source;
use basis_engine::{Disk, Library, Prover, Source};
use proc_macro2::{Span, TokenStream};
use quote::quote;

use input::{Input, Spec};
use path::SpecPath;

/// Reads families of polynomial basis functions from a spec, proves their claims during compilation, and
/// defines a type with evaluators for each family.
///
/// ```ignore
/// basis!("specs/quartic.basis");                                    // every family without index parameters
/// basis!("specs/bernstein.basis", Bernstein(3), Bernstein(5) as Quintic);   // families of these orders
/// basis!(library "lagrange", TriangularLagrange(2));                // from the library that comes with the package
/// basis!(concat!(env!("OUT_DIR"), "/mine.basis"));                  // a spec that a build script writes
/// basis!("specs/quartic.basis", crate = my_crate::basis_runtime);   // a renamed or re-exported runtime: the name of
///                                                     // a dependency, or a path from crate, self or super
/// basis! { family Line { domain 0 <= t <= 1; b[0] = 1 - t; b[1] = t; } }    // the spec in place
/// ```
///
/// Where basis-runtime has another name in `Cargo.toml`, or another crate re-exports it, say so with `crate = …`, in a
/// spec in place before the families: `basis! { crate = curves; family … }`. Without it the compiler finds no
/// `basis_runtime` in the crate root.
///
/// Orders are chosen for specs in files; of a spec in place every family without index parameters is taken, which may
/// use the others. Its letters are those of the calling crate: rustc warns (`mixed_script_confusables`) where a crate
/// has no other Greek letters than such as `κ` and `α` that look like Latin ones; spelled out, `kappa`, or in a file,
/// it has nothing to say.
///
/// A path is relative to the file that calls the macro, or else to the folder of `Cargo.toml`. It is a string,
/// `env!("NAME")`, or `concat!(…)` of strings, numbers and such. The specs of the library are those of the package
/// [`basis-specs`](https://docs.rs/basis-specs). The build stops with an error when a claim of a chosen family is not
/// as the spec declares it.
///
#[doc = include_str!("../SPEC.md")]
#[proc_macro]
pub fn basis(tokens: proc_macro::TokenStream) -> proc_macro::TokenStream {
    let call_site = Span::call_site();
    match syn::parse::<Input>(tokens) {
        Ok(input) => expand(input, call_site),
        Err(error) => error.into_compile_error(),
    }
    .into()
}

fn expand(input: Input, call_site: Span) -> TokenStream {
    let caller = call_site.local_file();
    let mut variables = TokenStream::new();
    let (library, place) = match input.spec {
        Spec::File(path) => {
            variables = watch_variables(&path);
            match source::read(&Disk, &path.value, &folders(caller)) {
                Ok(mut source) => {
                    source.name = shown(&source);
                    (Library::from_source(&Disk, &Prover, source), path.span)
                }
                Err(error) => {
                    let error = syn::Error::new(path.span, error).into_compile_error();
                    return quote!(#error #variables);
                }
            }
        }
        Spec::Library(name) => match source::library(&Disk, &name.value()) {
            Ok(source) => (Library::from_source(&Disk, &Prover, source), name.span()),
            Err(error) => return syn::Error::new(name.span(), error).into_compile_error(),
        },
        Spec::Inline(tokens) => (Library::from_tokens(&Disk, &Prover, tokens, caller), call_site),
    };
    let request = basis_engine::Request { families: input.families, runtime: input.runtime };
    let (code, diagnostics) = basis_engine::expand(&library, &request);
    let errors = errors::compile_errors(&diagnostics, library.sources(), place);
    let watched = watch(&library);
    quote!(#code #errors #watched #variables)
}

/// The path of a spec as a terminal or an editor opens it: relative to the folder in which the compiler runs, as its
/// own messages are, or else absolute.
fn shown(source: &Source) -> String {
    let Some(path) = &source.path else { return source.name.clone() };
    let here = std::env::current_dir().and_then(|folder| folder.canonicalize());
    let relative = here.ok().and_then(|folder| path.strip_prefix(folder).ok().map(PathBuf::from));
    relative.as_ref().unwrap_or(path).display().to_string()
}

/// Where relative paths start: next to the calling file, then next to `Cargo.toml`.
fn folders(caller: Option<PathBuf>) -> Vec<PathBuf> {
    let beside = caller.and_then(|file| file.parent().map(PathBuf::from));
    // Cargo sets the variable; other build systems may not.
    let manifest = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from);
    beside.into_iter().chain(manifest).collect()
}

/// Makes the compiler run the macro again when a spec changes, also when it has errors now.
fn watch(library: &Library<'_>) -> TokenStream {
    let paths = library
        .sources()
        .iter()
        .filter(|(_, source)| source.text.is_some())
        .filter_map(|(_, source)| source.path.as_deref()?.to_str());
    quote!(#(const _: &[::core::primitive::u8] = ::core::include_bytes!(#paths);)*)
}

/// Makes Cargo build the crate again when an environment variable of the path changes.
fn watch_variables(path: &SpecPath) -> TokenStream {
    let names = &path.variables;
    quote!(#(
        const _: ::core::option::Option<&'static ::core::primitive::str> = ::core::option_env!(#names);
    )*)
}

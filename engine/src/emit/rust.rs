//! Rust as a file: the code of the macro with paths that people read, and a digest of each spec, so that an edited spec
//! stops the build.

use proc_macro2::{Group, Ident, Spacing, Span, TokenStream, TokenTree};
use quote::quote;

use super::{DECIDED, Job, Names};
use crate::diagnostic::Diagnostic;
use crate::generate::{self, Options};
use crate::subject::Subject;

/// The module of the runtime with the functions that the code calls: a further version of the runtime may add another
/// one, and keeps this.
const SUPPORT: &str = "v1";

/// A spec that the code is made from.
#[derive(Clone, Debug)]
pub struct Digest {
    /// Its path from the folder of the file that is written, with `/` between folders.
    pub path: String,
    /// [`digest`] of its bytes.
    pub digest: u64,
}

/// A number that another text is very unlikely to have: FNV-1a of the bytes but for carriage returns, which some
/// checkouts add. `basis_runtime::generated::unchanged` computes the same.
pub fn digest(bytes: &[u8]) -> u64 {
    let text = bytes.iter().filter(|byte| **byte != b'\r');
    text.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
}

/// The items of the file, without its header; for `prettyplease`, which formats them.
///
/// # Errors
/// For each family and join that has no code, why.
pub fn items(job: &Job<'_>, specs: &[Digest]) -> Result<TokenStream, Vec<Diagnostic>> {
    let mut errors = Vec::new();
    let mut names = Names::default();
    let (mut families, mut joins) = (TokenStream::new(), TokenStream::new());
    let mut functions = Names::default();
    for wanted in job.items {
        let (runtime, claims) = (quote!(::basis_runtime), &wanted.checked.claims);
        let Ok(name) = wanted.name.as_deref().map(syn::parse_str::<Ident>).transpose() else {
            let name = wanted.name.as_deref().unwrap_or_default();
            let error = Diagnostic::unplaced(format!("`{name}` cannot be a name in Rust"));
            errors.push(error.help("write letters, digits and `_`, and no keyword of Rust"));
            continue;
        };
        let options = Options { runtime, name, decided: DECIDED };
        let code = match &wanted.checked.subject {
            Subject::Family(family) => generate::type_name(family, options.name.as_ref())
                .and_then(|name| names.insert(&name.to_string(), &wanted.checked.subject).map(|()| name))
                .map_err(|error| vec![error])
                .and_then(|name| generate::definition(family, claims, name, &options))
                .map(|code| families.extend(code)),
            Subject::Theorem(theorem) => {
                let name = wanted.name.clone().unwrap_or_else(|| generate::join::name(theorem));
                functions
                    .insert(&name, &wanted.checked.subject)
                    .and_then(|()| generate::join::join(theorem, claims, &options))
                    .map(|code| joins.extend(code))
                    .map_err(|error| vec![error])
            }
        };
        errors.extend(code.err().unwrap_or_default());
    }
    if !errors.is_empty() {
        return Err(errors);
    }
    let support = names.0.iter().all(|(name, _)| name != SUPPORT).then(|| {
        quote! {
            #[allow(unused_imports)]
            use ::basis_runtime::generated::v1;
        }
    });
    let taken: Vec<String> = names.0.into_iter().map(|(name, _)| name).collect();
    let checks = specs.iter().map(|spec| check(spec, job.command));
    let code = quote! {
        #support
        #(#checks)*
        #families
        #joins
    };
    Ok(readable(code, &taken))
}

/// An edited spec stops the build with the command that has to be run.
fn check(spec: &Digest, command: &str) -> TokenStream {
    let Digest { path, digest } = spec;
    let message = format!("the spec `{path}` was edited after this file was written; run `{command}`");
    let hexadecimal: String = format!("{digest:016x}")
        .as_bytes()
        .chunks(4)
        .map(String::from_utf8_lossy)
        .collect::<Vec<_>>()
        .join("_");
    // Digits of base sixteen are a number.
    let number: TokenStream = format!("0x{hexadecimal}").parse().unwrap_or_default();
    quote! {
        const _: () = ::basis_runtime::generated::unchanged(include_bytes!(#path), #number, #message);
    }
}

/// The same code with short paths: of the prelude's names alone where no type of the file has them, of the support
/// functions behind `v1`, and no `::` before a crate.
fn readable(code: TokenStream, taken: &[String]) -> TokenStream {
    let tokens: Vec<TokenTree> = code.into_iter().collect();
    let mut result: Vec<TokenTree> = Vec::new();
    let mut k = 0;
    while k < tokens.len() {
        if let Some((path, after)) = path(&tokens, k) {
            result.extend(short(&path, taken));
            k = after;
            continue;
        }
        result.push(match &tokens[k] {
            TokenTree::Group(group) => {
                let mut inner = Group::new(group.delimiter(), readable(group.stream(), taken));
                inner.set_span(group.span());
                TokenTree::Group(inner)
            }
            other => other.clone(),
        });
        k += 1;
    }
    result.into_iter().collect()
}

/// The names of a path that begins with `::basis_runtime`, and the position after it.
fn path(tokens: &[TokenTree], start: usize) -> Option<(Vec<String>, usize)> {
    // After a name it goes on with a path; after a keyword it begins one.
    if let Some(TokenTree::Ident(before)) = start.checked_sub(1).and_then(|k| tokens.get(k))
        && syn::parse_str::<Ident>(&before.to_string()).is_ok()
    {
        return None;
    }
    let mut names: Vec<String> = Vec::new();
    let mut k = start;
    while is_double_colon(tokens, k)
        && let Some(TokenTree::Ident(name)) = tokens.get(k + 2)
    {
        names.push(name.to_string());
        k += 3;
    }
    (names.first()? == "basis_runtime").then_some((names, k))
}

fn is_double_colon(tokens: &[TokenTree], k: usize) -> bool {
    let colon = |k: usize, spacing: Option<Spacing>| match tokens.get(k) {
        Some(TokenTree::Punct(p)) => p.as_char() == ':' && spacing.is_none_or(|s| p.spacing() == s),
        _ => false,
    };
    colon(k, Some(Spacing::Joint)) && colon(k + 1, None)
}

/// Names of the prelude, by the modules of `core` in which they are.
const PRELUDE: [(&str, &str); 10] = [
    ("result::Result::Ok", "Ok"),
    ("result::Result", "Result"),
    ("option::Option::Some", "Some"),
    ("option::Option::None", "None"),
    ("option::Option", "Option"),
    ("marker::Copy", "Copy"),
    ("clone::Clone", "Clone"),
    ("default::Default", "Default"),
    ("cmp::PartialEq", "PartialEq"),
    ("fmt::Debug", "Debug"), // the macro that derives it
];

fn short(path: &[String], taken: &[String]) -> TokenStream {
    let free = |name: &str| taken.iter().all(|taken| taken != name);
    let names: Vec<&str> = path.iter().map(String::as_str).collect();
    let names: Vec<&str> = match names.as_slice() {
        ["basis_runtime", "__private", "core", rest @ ..] => {
            let whole = rest.join("::");
            let known = PRELUDE.iter().find(|(long, short)| *long == whole && free(short));
            known.map_or_else(|| [&["core"], rest].concat(), |(_, short)| vec![*short])
        }
        ["basis_runtime", "__private", rest @ ..] if free(SUPPORT) => [&[SUPPORT], rest].concat(),
        ["basis_runtime", "__private", rest @ ..] => {
            [&["basis_runtime", "generated", SUPPORT], rest].concat()
        }
        other => other.to_vec(),
    };
    let crate_name = matches!(names[0], "core" | "basis_runtime");
    let idents = names.iter().map(|name| Ident::new(name, Span::call_site()));
    if crate_name && !free(names[0]) { quote!(::#(#idents)::*) } else { quote!(#(#idents)::*) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_become_short() {
        let long = quote! {
            impl ::basis_runtime::Basis for F {}
            fn f() -> ::basis_runtime::__private::core::result::Result<::basis_runtime::Curve, u8> {
                ::basis_runtime::__private::core::ops::Bound::Unbounded;
                ::basis_runtime::__private::combine::<3>(a::b, ::other::basis_runtime)
            }
        };
        let short = |taken: &[String]| readable(long.clone(), taken).to_string().replace(' ', "");
        assert_eq!(
            short(&[]),
            "implbasis_runtime::BasisforF{}fnf()->Result<basis_runtime::Curve,u8>{core::ops::Bound::Unbounded;v1::combine::<3>(a::b,::other::basis_runtime)}"
        );
        assert_eq!(
            short(&["Result", "core", "v1"].map(String::from)),
            "implbasis_runtime::BasisforF{}fnf()->::core::result::Result<basis_runtime::Curve,u8>{::core::ops::Bound::Unbounded;\
             basis_runtime::generated::v1::combine::<3>(a::b,::other::basis_runtime)}"
        );
    }

    #[test]
    fn line_ends_do_not_change_a_digest() {
        assert_eq!(digest(b"a\nb\n"), digest(b"a\r\nb\r\n"));
        assert_ne!(digest(b"a\nb\n"), digest(b"a\nc\n"));
        assert_eq!(digest(b"a"), 0xaf63_dc4c_8601_ec8c); // the published value
    }
}

//! What stands between the brackets of `basis!`.

use basis_engine::Requested;
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream};
use syn::{Ident, LitInt, LitStr, Result, Token};

use crate::path::{SpecPath, is_macro_call};

/// The spec, which families are wanted, and where the runtime is.
pub(crate) struct Input {
    pub(crate) spec: Spec,
    pub(crate) families: Vec<Requested>,
    pub(crate) runtime: TokenStream,
}

/// Where the spec is.
pub(crate) enum Spec {
    /// In a file.
    File(SpecPath),
    /// In the library, under this name.
    Library(LitStr),
    /// In the macro call itself.
    Inline(TokenStream),
}

impl Parse for Input {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let mut runtime = None;
        if input.peek(Token![crate]) && input.peek2(Token![=]) {
            runtime = Some(runtime_path(input)?);
            if input.peek(Token![,]) {
                input.parse::<Token![,]>()?;
            } else {
                input.parse::<Token![;]>()?;
            }
        }
        let spec = if input.peek(LitStr) || is_macro_call(input) {
            Spec::File(input.parse()?)
        } else if input.peek(library) {
            Spec::Library(in_library(input)?)
        } else if is_path(input) {
            let help = "the path of a spec is written in quotation marks: `basis!(\"specs/name.basis\")`";
            return Err(input.error(help));
        } else {
            let spec = Spec::Inline(input.parse()?);
            return Ok(Self { spec, families: Vec::new(), runtime: runtime.unwrap_or_else(default_runtime) });
        };
        let mut families = Vec::new();
        while !input.is_empty() {
            input.parse::<Token![,]>()?;
            if input.is_empty() {
                break;
            }
            if input.peek(Token![crate]) {
                let span = input.span();
                if runtime.replace(runtime_path(input)?).is_some() {
                    return Err(syn::Error::new(span, "`crate = …` is given twice"));
                }
            } else {
                let new: Requested = requested(input)?;
                if families.iter().any(|other| type_name(other) == type_name(&new)) {
                    let name = type_name(&new);
                    let message = format!("two types are called `{name}`: write `{} as OtherName`", new.name);
                    return Err(syn::Error::new(new.span, message));
                }
                families.push(new);
            }
        }
        Ok(Self { spec, families, runtime: runtime.unwrap_or_else(default_runtime) })
    }
}

syn::custom_keyword!(library);

/// `library "quartic"`
fn in_library(input: ParseStream<'_>) -> Result<LitStr> {
    input.parse::<library>()?;
    input.parse().map_err(|e| {
        let help =
            "the name of a spec of the library is written in quotation marks: `basis!(library \"quartic\")`";
        syn::Error::new(e.span(), help)
    })
}

/// Whether this looks like a path without quotation marks, `specs/name.basis`.
fn is_path(input: ParseStream<'_>) -> bool {
    input.peek(Ident) && (input.peek2(Token![/]) || input.peek2(Token![.]))
        || input.peek(Token![.])
        || input.peek(Token![/])
}

fn default_runtime() -> TokenStream {
    quote!(::basis_runtime)
}

/// `crate = some::path`: the name of a dependency, or a path from `crate`, `self` or `super`. The generated code stands
/// in a module of its own, from which the last two are one step further away.
fn runtime_path(input: ParseStream<'_>) -> Result<TokenStream> {
    input.parse::<Token![crate]>()?;
    input.parse::<Token![=]>()?;
    let mut path = TokenStream::new();
    if input.peek(Token![::]) {
        input.parse::<Token![::]>()?.to_tokens(&mut path);
    }
    if path.is_empty() && (input.peek(Token![self]) || input.peek(Token![super])) {
        path.extend(quote!(super));
        if input.peek(Token![super]) {
            path.extend(quote!(::));
        } else {
            input.parse::<Token![self]>()?;
            if !input.peek(Token![::]) {
                return Ok(path);
            }
            input.parse::<Token![::]>()?.to_tokens(&mut path);
        }
    }
    loop {
        input.call(Ident::parse_any)?.to_tokens(&mut path);
        if !input.peek(Token![::]) {
            return Ok(path);
        }
        input.parse::<Token![::]>()?.to_tokens(&mut path);
    }
}

/// The name of the type that is asked for.
fn type_name(family: &Requested) -> String {
    family.rename.as_ref().map_or_else(|| family.name.clone(), Ident::to_string)
}

/// `Bernstein(5) as Quintic`
fn requested(input: ParseStream<'_>) -> Result<Requested> {
    let name: Ident = input.parse().map_err(|e| {
        syn::Error::new(e.span(), "expected a family, such as `Bernstein(3)`, or `crate = path`")
    })?;
    let mut order = Vec::new();
    if input.peek(syn::token::Paren) {
        let content;
        syn::parenthesized!(content in input);
        while !content.is_empty() {
            let minus = content.parse::<Option<Token![-]>>()?.is_some();
            let value: LitInt = content.parse().map_err(|e| {
                syn::Error::new(e.span(), format!("expected the order as a number, such as `{name}(3)`"))
            })?;
            let value: i64 = value.base10_parse()?;
            order.push(if minus { -value } else { value });
            if !content.is_empty() {
                content.parse::<Token![,]>()?;
            }
        }
    }
    let mut rename = None;
    if input.peek(Token![as]) {
        input.parse::<Token![as]>()?;
        rename = Some(input.parse()?);
    }
    Ok(Requested { name: name.to_string(), span: name.span(), order, rename })
}

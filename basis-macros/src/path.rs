//! The path of a spec: a string, or `concat!` and `env!` of strings, which a macro sees before the compiler expands
//! them.

use std::env::{self, VarError};

use proc_macro2::Span;
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream};
use syn::{Ident, Lit, LitStr, Result, Token, parenthesized, token};

/// The path of a spec, worked out.
pub(crate) struct SpecPath {
    pub(crate) value: String,
    /// Where it begins.
    pub(crate) span: Span,
    /// The environment variables that it depends on.
    pub(crate) variables: Vec<LitStr>,
}

impl Parse for SpecPath {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let mut path = Self { value: String::new(), span: input.span(), variables: Vec::new() };
        path.part(input, Text::Only)?;
        Ok(path)
    }
}

/// Whether a macro call follows: `concat!`, `std::env!`. No spec begins like that.
pub(crate) fn is_macro_call(input: ParseStream<'_>) -> bool {
    input.peek(Token![::])
        || input.peek(Ident::peek_any) && (input.peek2(Token![!]) || input.peek2(Token![::]))
}

/// What a part of a path may be.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Text {
    /// A string.
    Only,
    /// Any literal, as in `concat!`.
    OrLiteral,
}

const EXPECTED: &str = "the path of a spec is a string, `env!(\"NAME\")`, or `concat!(…)` of such";

impl SpecPath {
    /// Reads a string or a macro call, and adds what it stands for.
    fn part(&mut self, input: ParseStream<'_>, text: Text) -> Result<()> {
        if !is_macro_call(input) {
            let span = input.span();
            self.value += &match input.parse::<Lit>() {
                Ok(Lit::Str(text)) => text.value(),
                Ok(Lit::Char(c)) if text == Text::OrLiteral => c.value().to_string(),
                Ok(Lit::Int(n)) if text == Text::OrLiteral => n.base10_digits().to_string(),
                Ok(Lit::Bool(b)) if text == Text::OrLiteral => b.value.to_string(),
                _ => return Err(syn::Error::new(span, EXPECTED)),
            };
            return Ok(());
        }
        let name = macro_name(input)?;
        let content;
        if input.peek(token::Paren) {
            parenthesized!(content in input);
        } else if input.peek(token::Bracket) {
            syn::bracketed!(content in input);
        } else {
            syn::braced!(content in input);
        }
        match name.to_string().as_str() {
            "concat" => self.concat(&content),
            "env" => self.env(&content, name.span()),
            _ => Err(syn::Error::new(name.span(), EXPECTED)),
        }
    }

    /// `concat!(part, part, …)`
    fn concat(&mut self, content: ParseStream<'_>) -> Result<()> {
        while !content.is_empty() {
            self.part(content, Text::OrLiteral)?;
            if !content.is_empty() {
                content.parse::<Token![,]>()?;
            }
        }
        Ok(())
    }

    /// `env!("NAME")`, `env!("NAME", "what to say without it")`
    fn env(&mut self, content: ParseStream<'_>, span: Span) -> Result<()> {
        let name: LitStr = content.parse()?;
        let mut message = None;
        if !content.is_empty() {
            content.parse::<Token![,]>()?;
            message = content.parse::<Option<LitStr>>()?;
            content.parse::<Option<Token![,]>>()?;
        }
        if !content.is_empty() {
            return Err(content.error("expected the end of `env!(…)`"));
        }
        match env::var(name.value()) {
            Ok(value) => self.value += &value,
            Err(error) => {
                return Err(syn::Error::new(span, missing(&name.value(), &error, message.as_ref())));
            }
        }
        self.variables.push(name);
        Ok(())
    }
}

/// `concat!`, `std::concat!`, `::core::env!`: the name of the macro.
fn macro_name(input: ParseStream<'_>) -> Result<Ident> {
    input.parse::<Option<Token![::]>>()?;
    loop {
        let name = input.call(Ident::parse_any)?;
        if input.parse::<Option<Token![!]>>()?.is_some() {
            return Ok(name);
        }
        if input.parse::<Option<Token![::]>>()?.is_none() {
            return Err(syn::Error::new(name.span(), EXPECTED));
        }
    }
}

/// What is wrong with an environment variable.
fn missing(name: &str, error: &VarError, message: Option<&LitStr>) -> String {
    match (error, message) {
        (VarError::NotPresent, Some(message)) => message.value(),
        (VarError::NotPresent, None) if name == "OUT_DIR" => String::from(
            "the environment variable `OUT_DIR` is not set\nCargo sets it for packages with a build script, `build.rs`",
        ),
        (VarError::NotPresent, None) => {
            format!("the environment variable `{name}` is not set while the crate is compiled")
        }
        (VarError::NotUnicode(_), _) => format!("the environment variable `{name}` is not Unicode"),
    }
}

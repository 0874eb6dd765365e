//! Names of the spec as names of Rust: ASCII, no keywords, none twice.

use basis_prover::collections::list::Listed as _;
use proc_macro2::Ident;

use super::tokens::site;
use crate::ascii::ascii;
use crate::diagnostic::Diagnostic;
use crate::model::Family;

/// Methods that every generated type has.
const METHODS: [&str; 15] = [
    "curve",
    "partials",
    "new",
    "values",
    "derivatives",
    "coefficients",
    "bernstein_coefficients",
    "to_bernstein",
    "mass_matrix",
    "stiffness_matrix",
    "bind",
    "start_points",
    "end_points",
    "curve_after",
    "curve_before",
];

/// Words that are keywords in some edition but not in all: what the calling crate has is not known here.
const SOME_EDITIONS: [&str; 4] = ["async", "await", "dyn", "gen"];

/// The identifier, raw where it is a keyword of any edition; `None` for the few words that cannot be one.
fn ident(name: &str) -> Option<Ident> {
    if !SOME_EDITIONS.contains(&name)
        && let Ok(mut ident) = syn::parse_str::<Ident>(name)
    {
        ident.set_span(site());
        return Some(ident);
    }
    let usable = !["self", "Self", "super", "crate", "_"].contains(&name);
    usable.then(|| Ident::new_raw(name, site()))
}

/// `G1SurfaceUU` as the name of a function, `g1_surface_uu`.
#[cfg(feature = "joins")]
pub(in crate::generate) fn function(name: &str) -> Option<Ident> {
    ident(&snake(name))
}

/// `g1_surface_uu` as the first part of the name of a type, `G1SurfaceUu`.
#[cfg(feature = "joins")]
pub(in crate::generate) fn camel(function: &str) -> String {
    let word = |word: &str| {
        let mut letters = word.chars();
        let first = letters.next().map(|c| c.to_ascii_uppercase());
        first.into_iter().chain(letters).collect::<String>()
    };
    function.split('_').map(word).collect()
}

/// A name of the spec as that of an argument: `λ1` becomes `lambda1`, `P[1]` becomes `p_1`.
#[cfg(feature = "joins")]
pub(in crate::generate) fn argument(name: &str) -> Option<Ident> {
    let parts: Vec<&str> = name.split(['[', ']', ',']).filter(|part| !part.is_empty()).collect();
    ident(&snake(&parts.join("_")))
}

/// The last part of a path as the name of a module: `specs/quadratic.basis` becomes `quadratic`.
pub(in crate::generate) fn module(path: &str) -> Option<Ident> {
    let stem = path.rsplit(['/', '\\']).next()?;
    let stem = stem.split_once('.').map_or(stem, |(stem, _)| stem);
    let name: String = ascii(stem).chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    let name = snake(&name);
    match name.chars().next()? {
        '0'..='9' => ident(&format!("spec_{name}")),
        _ => ident(&name),
    }
}

/// Lower case with `_` where a word begins.
fn snake(name: &str) -> String {
    let mut result = String::new();
    let mut before = '_';
    for c in ascii(name).chars() {
        if c.is_ascii_uppercase() && before.is_ascii_lowercase() | before.is_ascii_digit() {
            result.push('_');
        }
        result.push(c.to_ascii_lowercase());
        before = c;
    }
    result
}

/// Names that the generated code needs for something else: its type parameters, and the primitive types.
const TAKEN: [&str; 20] = [
    "S", "P", "T", "bool", "char", "f32", "f64", "i8", "i16", "i32", "i64", "i128", "isize", "str", "u8",
    "u16", "u32", "u64", "u128", "usize",
];

/// The name of the type of a family: as the macro call has it, `wanted`, or else the family's own.
pub(in crate::generate) fn type_name(family: &Family, wanted: Option<&Ident>) -> Result<Ident, Diagnostic> {
    let name = wanted.map_or_else(|| ascii(&family.name), plain);
    let found = match wanted {
        // The span is that of the name in the call.
        Some(wanted) => ident(&name).map(|mut ident| {
            ident.set_span(wanted.span());
            ident
        }),
        None => ident(&name),
    };
    match found {
        Some(ident) if !TAKEN.contains(&name.as_str()) => Ok(ident),
        _ => {
            let error = Diagnostic::error(
                family.place.clone(),
                format!("`{name}` cannot be the name of a Rust type"),
            );
            let help = "choose another name for the family, or give one to the macro: `Family as OtherName`";
            Err(error.help(help))
        }
    }
}

/// A name without the mark of a raw one.
pub(in crate::generate) fn plain(ident: &Ident) -> String {
    ident.to_string().trim_start_matches("r#").to_string()
}

/// The name of a shape parameter in Rust; `λ[1]` becomes `lambda_1`.
fn field(name: &str) -> String {
    let parts: Vec<&str> = name.split(['[', ']', ',']).filter(|part| !part.is_empty()).listed();
    ascii(&parts.join("_"))
}

/// Shape parameters that a constructor takes as one argument: with an index and of one name, as an array, or one alone.
pub(in crate::generate) struct Argument {
    /// The name of the argument and of the method that returns it.
    pub(in crate::generate) name: Ident,
    /// The name as the spec has it.
    pub(in crate::generate) written: String,
    /// The places of the parameters.
    pub(in crate::generate) places: core::ops::Range<usize>,
    /// Whether they come as an array.
    pub(in crate::generate) is_array: bool,
}

/// The arguments of a constructor, from the names of the fields.
pub(in crate::generate) fn arguments(family: &Family, fields: &[Ident]) -> Vec<Argument> {
    let mut all: Vec<Argument> = Vec::new();
    for (k, (shape, field)) in family.shapes.iter().zip(fields).enumerate() {
        match family.name_of(shape).split_once('[') {
            None => {
                let (name, written) = (field.clone(), family.name_of(shape).to_string());
                all.push(Argument { name, written, places: k..k + 1, is_array: false });
            }
            Some((base, _)) => match all.last_mut() {
                Some(last) if last.is_array && last.written == base => last.places.end = k + 1,
                _ => {
                    let name = ident(&ascii(base)).unwrap_or_else(|| field.clone());
                    all.push(Argument { name, written: base.to_string(), places: k..k + 1, is_array: true });
                }
            },
        }
    }
    all
}

/// The names of the shape parameters as fields, arguments and methods.
///
/// # Errors
/// All names that cannot be such names.
pub(in crate::generate) fn fields(family: &Family) -> Result<Vec<Ident>, Vec<Diagnostic>> {
    let mut fields: Vec<Ident> = Vec::new();
    let mut errors = Vec::new();
    for (k, shape) in family.shapes.iter().enumerate() {
        let written = family.name_of(shape);
        let name = field(written);
        // Of parameters with an index the array has the name without one.
        let (base, indexed) = written.split_once('[').map_or((written, false), |(base, _)| (base, true));
        let error = |message: String| Diagnostic::error(shape.place.clone(), message);
        let help = "choose another name for the parameter";
        if METHODS.contains(&ascii(base).as_str()) {
            let message =
                format!("the shape parameter `{written}` has the name of a method of the generated type");
            errors.push(error(message).help(help));
        } else if let Some(other) = family.shapes[..k].iter().find(|other| {
            let other = field(family.name_of(other));
            other == name || indexed && other == ascii(base)
        }) {
            let message = format!(
                "the shape parameters `{}` and `{written}` are both called `{name}` in Rust",
                family.name_of(other)
            );
            errors.push(error(message).also(other.place.clone(), "the other one").help(help));
        } else {
            match ident(&name) {
                Some(ident) => fields.push(ident),
                None => errors.push(error(format!("`{name}` cannot be a name in Rust")).help(help)),
            }
        }
    }
    if errors.is_empty() { Ok(fields) } else { Err(errors) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_in_rust() {
        assert_eq!(
            ["G1", "G2SurfaceUU", "C2", "λ1", "P"].map(snake),
            ["g1", "g2_surface_uu", "c2", "lambda1", "p"]
        );
        assert_eq!(argument("P[1]").map(|i| i.to_string()).as_deref(), Some("p_1"));
        assert_eq!(module("../specs/bell shape.basis").map(|i| i.to_string()).as_deref(), Some("bell_shape"));
        assert_eq!(module("3d.basis").map(|i| i.to_string()).as_deref(), Some("spec_3d"));
        assert_eq!(module(""), None);
        assert_eq!(ident("type").map(|i| i.to_string()).as_deref(), Some("r#type"));
    }
}

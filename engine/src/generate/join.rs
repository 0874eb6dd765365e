//! From a join to a function that computes the control points that it determines.

use crate::algebra::poly::Var;
use crate::algebra::range::DisplayRange as _;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote_spanned;

use super::Options;
use super::code::tokens::{doc, site};
use super::code::{docs, floats, names, shell};
use super::rust::{self, Body, Surroundings};
use crate::claim::Claim;
use crate::diagnostic::Diagnostic;
use crate::model::chart::Constraint;
use crate::model::{Parameter, label};
use crate::plan::Input;
use crate::plan::join::{self as plan, Determined};
use crate::state::Verdict;
use crate::theorem::{Form, GivenPoint, Origin, Patch, Theorem, Unit};
use crate::weights;
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::map::SortedMap;

/// An argument that is a number, or an array of numbers for a name with the indices 0, 1, …
struct ScalarArgument<'a> {
    name: Ident,
    scalars: Vec<&'a Parameter>,
    array: bool,
}

/// The scalars of a join as a struct: one more in the spec is a field that callers lack, and no other argument shifts.
struct Fields<'a> {
    /// The function, as it is linked to.
    function: String,
    name: Ident,
    argument: Ident,
    scalars: &'a [ScalarArgument<'a>],
}

/// An argument with control points: the whole net of a patch whose points are all given, or one point.
struct PointArgument<'a> {
    name: Ident,
    patch: &'a Patch,
    single: Option<&'a GivenPoint>,
}

/// The name of the function of a join; empty where it cannot be one.
pub(crate) fn name(theorem: &Theorem) -> String {
    names::function(&theorem.name).map_or_else(String::new, |name| name.to_string())
}

/// The function of a join, with its documentation.
///
/// # Errors
/// When names of the spec cannot become names of Rust, two of them are the same, or the points depend on dot products.
pub(crate) fn join(
    theorem: &Theorem,
    verdicts: &[(Claim, Verdict)],
    options: &Options,
) -> Result<TokenStream, Diagnostic> {
    let Options { runtime, name: rename, decided } = options;
    let error = |message: String| Diagnostic::error(theorem.place.clone(), message);
    let determined = plan::determined(theorem);
    let forms = || determined.iter().flat_map(|(_, points)| points.iter().map(|(_, form)| *form));
    let coefficients = || forms().flat_map(|form| form.terms.values());
    if theorem.products.iter().any(|(var, _)| coefficients().any(|f| f.depends_on(*var))) {
        return Err(products(theorem));
    }
    let used = plan::used(theorem, &determined);
    let points = point_arguments(theorem, &used)?;
    let scalars = scalar_arguments(theorem, &|p: &Parameter| coefficients().any(|f| f.depends_on(p.var)))?;
    let mut taken: Vec<&Ident> = Vec::new();
    for name in points.iter().map(|p| &p.name).chain(scalars.iter().map(|s| &s.name)) {
        if taken.contains(&name) {
            return Err(error(format!("two arguments of the function are called `{name}`"))
                .help("names of Rust are lower-case ASCII; choose other names"));
        }
        taken.push(name);
    }
    let name = match rename {
        Some(name) => name.clone(),
        None => names::function(&theorem.name)
            .ok_or_else(|| error(format!("`{}` cannot be the name of a Rust function", theorem.name)))?,
    };
    let core = quote_spanned!(site()=> #runtime::__private::core);
    let values: Vec<(&Parameter, TokenStream)> =
        scalars.iter().flat_map(|a| (0..a.scalars.len()).map(|k| (a.scalars[k], a.value(k)))).listed();
    let title = &theorem.name;
    let checks = values.iter().map(|(parameter, value)| {
        let shown = &parameter.name;
        let range = parameter.range.display(shown).to_string();
        let (low, high) =
            (shell::bound(&parameter.range.low, &core), shell::bound(&parameter.range.high, &core));
        quote_spanned! {site()=>
            #runtime::__private::check_shape(#title, #shown, #value, #low, #high, #range)?;
        }
    });
    let known: Vec<(Var, TokenStream)> = values.iter().map(|(p, value)| (p.var, value.clone())).listed();
    let related = related(theorem, &values.mapped(|(parameter, _)| *parameter));
    let related = related.map(|c| shell::check_assumed(runtime, title, c, &theorem.names, &known));
    let checks =
        checks.chain(related).fold(TokenStream::new(), |all, check| quote_spanned!(site()=> #all #check));
    let given: Vec<TokenStream> = used.mapped(|k| given(&points, &theorem.points[*k]));
    let points_plan = plan::points(&values.mapped(|(parameter, _)| *parameter), &used, forms());
    let input = |input: Input| match input {
        Input::Shape(k) => values[k].1.clone(),
        Input::Point(k) => given[k].clone(),
        _ => TokenStream::new(),
    };
    let names = points.iter().map(|p| &p.name).chain(scalars.iter().map(|s| &s.name));
    let mut names: Vec<String> = names.map(names::plain).listed();
    let fields = (!scalars.is_empty()).then(|| Fields::new(&name, &scalars, &names));
    names.extend(fields.iter().map(|fields| fields.argument.to_string()));
    let surroundings =
        Surroundings { runtime, input: &input, taken: &names, points: None, bernstein: rust::BERNSTEIN[0] };
    let Body { lets, outputs } = rust::body(&points_plan, &surroundings);
    let mut outputs = outputs.iter();
    let results = determined.mapped(|(_, points)| {
        let values = outputs.by_ref().take(points.len());
        let values =
            values.map(|point| quote_spanned!(site()=> #runtime::__private::check_point(#point)?)).listed();
        arranged(points, &values)
    });
    let (types, values): (Vec<TokenStream>, Vec<TokenStream>) = results.into_iter().unzip();
    let (result, value) = match (types.as_slice(), values.as_slice()) {
        ([one], [value]) => (one.clone(), value.clone()),
        _ => (quote_spanned!(site()=> (#(#types),*)), quote_spanned!(site()=> (#(#values),*))),
    };
    let arguments =
        points.iter().map(PointArgument::declaration).chain(fields.iter().map(Fields::declaration));
    let taken_apart = fields.iter().map(Fields::taken_apart);
    let definition = fields.as_ref().map(|fields| fields.definition(&core));
    let lines = documentation(theorem, verdicts, &points, fields.as_ref(), &determined, decided);
    let lines = lines.iter().map(|line| doc(line));
    if floats::misses_a_number(&checks) || floats::misses_a_number(&lets) || floats::misses_a_number(&value) {
        let message = format!("{} `{}` has numbers beyond f64", floats::ERROR, theorem.title());
        return Err(error(message).help(floats::HELP));
    }
    Ok(quote_spanned! {site()=>
        #definition
        #(#lines)*
        #[allow(clippy::all, clippy::pedantic, unused_variables)]
        pub fn #name<S: #runtime::Scalar, P: #runtime::Point<Scalar = S>>(
            #(#arguments),*
        ) -> #core::result::Result<#result, #runtime::CurveError> {
            #(#taken_apart)*
            #checks
            #lets
            #core::result::Result::Ok(#value)
        }
    })
}

/// What is assumed of several of some scalars; what is said of others does not matter to the points.
pub(crate) fn related<'t>(
    theorem: &'t Theorem,
    scalars: &[&Parameter],
) -> impl Iterator<Item = &'t Constraint> + use<'t> {
    let vars = scalars.mapped(|p| p.var);
    theorem.relations.iter().filter(move |c| c.value.variables().iter().all(|v| vars.contains(v)))
}

/// The error for a join whose points depend on dot products.
pub(crate) fn products(theorem: &Theorem) -> Diagnostic {
    let message = format!("the points of `{}` depend on dot products", theorem.name);
    let error = Diagnostic::error(theorem.place.clone(), message);
    error.help("a function is emitted for points that are linear in the given ones; write a `theorem`")
}

impl ScalarArgument<'_> {
    fn value(&self, k: usize) -> TokenStream {
        let name = &self.name;
        if self.array {
            let k = Literal::usize_unsuffixed(k);
            quote_spanned!(site()=> #name[#k])
        } else {
            quote_spanned!(site()=> #name)
        }
    }

    fn field(&self) -> TokenStream {
        let (name, count) = (&self.name, Literal::usize_unsuffixed(self.scalars.len()));
        let about = doc(&self.about());
        if self.array {
            quote_spanned!(site()=> #about pub #name: [S; #count])
        } else {
            quote_spanned!(site()=> #about pub #name: S)
        }
    }

    /// The range, and what the spec says about it.
    fn about(&self) -> String {
        let range = |p: &&Parameter| match (p.range.low.value(), p.range.high.value()) {
            (None, None) => String::from("any number"),
            _ => format!("`{}`", p.range.display(&p.name)),
        };
        let ranges: Vec<String> = self.scalars.mapped(range);
        let about: Vec<&str> = self.scalars.iter().take(1).flat_map(|p| &p.doc).map(String::as_str).listed();
        let about = if about.is_empty() { String::new() } else { format!(": {}", about.join(" ")) };
        format!("{}{about}", ranges.join(", "))
    }
}

impl<'a> Fields<'a> {
    fn new(function: &Ident, scalars: &'a [ScalarArgument<'a>], taken: &[String]) -> Self {
        let function = names::plain(function);
        let name = Ident::new(&format!("{}Scalars", names::camel(&function)), site());
        let is_taken = taken.iter().any(|name| name == "scalars");
        let argument = Ident::new(if is_taken { "scalars_of_the_join" } else { "scalars" }, site());
        Self { function, name, argument, scalars }
    }

    fn definition(&self, core: &TokenStream) -> TokenStream {
        let name = &self.name;
        let about = doc(&format!("The scalars of [`{}`].", self.function));
        let fields = self.scalars.iter().map(ScalarArgument::field);
        quote_spanned! {site()=>
            #about
            #[derive(#core::clone::Clone, #core::marker::Copy, #core::fmt::Debug, #core::cmp::PartialEq)]
            #[allow(clippy::all, clippy::pedantic)]
            pub struct #name<S> {
                #(#fields),*
            }
        }
    }

    fn declaration(&self) -> TokenStream {
        let (argument, name) = (&self.argument, &self.name);
        quote_spanned!(site()=> #argument: #name<S>)
    }

    fn taken_apart(&self) -> TokenStream {
        let (argument, name) = (&self.argument, &self.name);
        let fields = self.scalars.iter().map(|scalar| &scalar.name);
        quote_spanned!(site()=> let #name { #(#fields),* } = #argument;)
    }
}

impl PointArgument<'_> {
    fn declaration(&self) -> TokenStream {
        let name = &self.name;
        if self.single.is_some() {
            return quote_spanned!(site()=> #name: P);
        }
        let net = match grid(self.patch.points.iter().map(|p| p.index.as_slice())) {
            Some((rows, columns)) => {
                let (rows, columns) = (Literal::usize_unsuffixed(rows), Literal::usize_unsuffixed(columns));
                quote_spanned!(site()=> [[P; #columns]; #rows])
            }
            None => {
                let count = Literal::usize_unsuffixed(self.patch.points.len());
                quote_spanned!(site()=> [P; #count])
            }
        };
        quote_spanned!(site()=> #name: &#net)
    }
}

/// Whole nets where all points are given, and single points.
fn point_arguments<'a>(theorem: &'a Theorem, used: &[usize]) -> Result<Vec<PointArgument<'a>>, Diagnostic> {
    let mut all: Vec<PointArgument<'a>> = Vec::new();
    for (k, patch) in theorem.patches.iter().enumerate() {
        let mut used = used.iter().map(|u| &theorem.points[*u]).filter(|p| p.patch == k).peekable();
        if used.peek().is_none() {
            continue;
        }
        if patch.points.iter().all(|p| p.origin == Origin::Given) {
            let name = argument(theorem, &patch.name)?;
            all.push(PointArgument { name, patch, single: None });
            continue;
        }
        for point in used {
            let name = argument(theorem, &point.name)?;
            all.push(PointArgument { name, patch, single: Some(point) });
        }
    }
    Ok(all)
}

/// The scalars that are used, in the order of their declaration; γ[0], γ[1], … become one array.
fn scalar_arguments<'a>(
    theorem: &'a Theorem,
    used: &dyn Fn(&Parameter) -> bool,
) -> Result<Vec<ScalarArgument<'a>>, Diagnostic> {
    let mut groups: Vec<(&str, SortedMap<i64, &Parameter>)> = Vec::new();
    for scalar in &theorem.scalars {
        let indexed = scalar.name.strip_suffix(']').and_then(|n| n.split_once('['));
        let (base, index) = match indexed.and_then(|(base, k)| Some((base, k.parse::<i64>().ok()?))) {
            Some((base, index)) => (base, index),
            None => (scalar.name.as_str(), -1),
        };
        match groups.iter_mut().find(|(name, _)| *name == base) {
            Some((_, members)) => {
                members.insert(index, scalar);
            }
            None => {
                let mut members = SortedMap::new();
                members.insert(index, scalar);
                groups.push((base, members));
            }
        }
    }
    let mut all = Vec::new();
    for (base, members) in groups {
        if !members.values().any(|p| used(p)) {
            continue;
        }
        let array = members.keys().copied().eq(0..members.len() as i64);
        if array {
            let (name, scalars) = (argument(theorem, base)?, members.into_values());
            all.push(ScalarArgument { name, scalars, array });
            continue;
        }
        for scalar in members.into_values().into_iter().filter(|p| used(p)) {
            all.push(ScalarArgument { name: argument(theorem, &scalar.name)?, scalars: vec![scalar], array });
        }
    }
    Ok(all)
}

fn argument(theorem: &Theorem, name: &str) -> Result<Ident, Diagnostic> {
    names::argument(name).ok_or_else(|| {
        let message = format!("`{name}` cannot be the name of an argument in Rust");
        Diagnostic::error(theorem.place.clone(), message).help("choose another name")
    })
}

/// A given point as an element of the arguments.
fn given(arguments: &[PointArgument<'_>], point: &GivenPoint) -> TokenStream {
    for argument in arguments {
        let name = &argument.name;
        match argument.single {
            Some(single) if single.name == point.name => return quote_spanned!(site()=> #name),
            None if label(&argument.patch.name, &point.index) == point.name => {
                let points = &argument.patch.points;
                if let (Some(_), [i, j]) =
                    (grid(points.iter().map(|p| p.index.as_slice())), point.index.as_slice())
                {
                    let (i, j) = (Literal::i64_unsuffixed(*i), Literal::i64_unsuffixed(*j));
                    return quote_spanned!(site()=> #name[#i][#j]);
                }
                let at = points.iter().position(|p| p.index == point.index).unwrap_or(0);
                let at = Literal::usize_unsuffixed(at);
                return quote_spanned!(site()=> #name[#at]);
            }
            _ => {}
        }
    }
    TokenStream::new()
}

/// Rows and columns, when the indices are all pairs (i, j) of two ranges, row by row.
fn grid<'i>(indices: impl Iterator<Item = &'i [i64]>) -> Option<(usize, usize)> {
    let pairs: Option<Vec<(i64, i64)>> =
        indices.map(|index| if let [i, j] = index { Some((*i, *j)) } else { None }).collect();
    let pairs = pairs?;
    let (first, last) = (pairs.first()?, pairs.last()?);
    let (rows, columns) = (first.0..=last.0, first.1..=last.1);
    let all = rows.clone().flat_map(|i| columns.clone().map(move |j| (i, j)));
    all.eq(pairs.iter().copied()).then(|| (rows.count(), columns.count()))
}

/// The determined points of a patch: rows where they form a grid, else one after the other.
fn arranged(points: &[(&[i64], &Form)], values: &[TokenStream]) -> (TokenStream, TokenStream) {
    let count = Literal::usize_unsuffixed(values.len());
    match grid(points.iter().map(|(index, _)| *index)) {
        Some((rows, columns)) => {
            let lines = values.chunks(columns).map(|row| quote_spanned!(site()=> [#(#row),*]));
            let (rows, columns) = (Literal::usize_unsuffixed(rows), Literal::usize_unsuffixed(columns));
            (quote_spanned!(site()=> [[P; #columns]; #rows]), quote_spanned!(site()=> [#(#lines),*]))
        }
        None => (quote_spanned!(site()=> [P; #count]), quote_spanned!(site()=> [#(#values),*])),
    }
}

fn documentation(
    theorem: &Theorem,
    verdicts: &[(Claim, Verdict)],
    points: &[PointArgument<'_>],
    fields: Option<&Fields<'_>>,
    determined: &[Determined<'_>],
    decided: &str,
) -> Vec<String> {
    let mut lines = first_lines(theorem);
    lines.extend(["", "# Arguments", ""].map(String::from));
    for argument in points {
        let (name, patch) = (&argument.name, argument.patch);
        lines.push(match argument.single {
            Some(point) => format!("- `{name}`: the control point `{}` of `{}`", point.name, patch.written),
            None => format!("- `{name}`: the control points of `{} = {}`", patch.name, patch.written),
        });
    }
    if let Some(fields) = fields {
        lines.push(format!("- `{}`: the scalars, by name", fields.argument));
        for scalar in fields.scalars {
            lines.push(format!("  - `{}`: {}", scalar.name, scalar.about()));
        }
    }
    let arguments = fields.iter().flat_map(|fields| fields.scalars);
    let used = arguments.flat_map(|argument| &argument.scalars).copied().listed();
    let texts = related(theorem, &used).map(|c| format!("`{}`", c.text)).listed();
    if !texts.is_empty() {
        lines.extend([String::new(), format!("They satisfy {}.", texts.join(", "))]);
    }
    lines.extend(result(theorem, determined));
    let errors = if texts.is_empty() {
        "When a scalar is outside of its range, infinite, or NaN, and when a computed point is not finite."
    } else {
        "When a scalar is outside of its range, infinite, or NaN, when they are not related as they have to be, and when a computed point is not finite."
    };
    lines.extend(["", "# Errors", "", errors].map(String::from));
    lines.extend(docs::claims(verdicts, decided));
    lines
}

/// The determined points as formulas, with a heading.
fn result(theorem: &Theorem, determined: &[Determined<'_>]) -> Vec<String> {
    let mut lines = ["", "# Result", "", "```text"].map(String::from).to_vec();
    for (patch, points) in determined {
        for (index, form) in points {
            let terms = form.terms.iter().filter_map(|(unit, weight)| match unit {
                Unit::Point(p) => Some((theorem.points[*p].name.as_str(), weight)),
                Unit::Pair(..) => None,
            });
            let formula = weights::combination(terms, &theorem.names);
            lines.push(format!("{} = {formula}", label(&patch.name, index)));
        }
    }
    let written: Vec<String> = determined.mapped(|(p, _)| format!("`{} = {}`", p.name, p.written));
    lines.push(String::from("```"));
    lines.extend([String::new(), format!("of {}.", written.join(", "))]);
    lines
}

/// What the join says, for code that has arguments of its own: what it determines, by which formulas, and its claims.
#[cfg(any(test, feature = "tools"))]
pub(crate) fn about(theorem: &Theorem, verdicts: &[(Claim, Verdict)], decided: &str) -> Vec<String> {
    let mut lines = first_lines(theorem);
    lines.extend(result(theorem, &plan::determined(theorem)));
    lines.extend(docs::claims(verdicts, decided));
    lines
}

fn first_lines(theorem: &Theorem) -> Vec<String> {
    if theorem.doc.is_empty() {
        return vec![format!("The control points that the join `{}` determines.", theorem.name)];
    }
    theorem.doc.clone()
}

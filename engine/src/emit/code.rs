//! What a target gets of a family and of a join: names, ranges, documentation, and steps.

use super::{DECIDED, Language, Wanted};
use crate::algebra::range::{DisplayRange as _, End, Range};
use crate::algebra::rational::{Rational, ToFloat as _};
use crate::diagnostic::{Diagnostic, Place};
use crate::generate;
use crate::model::chart::Constraint;
use crate::model::{Factor, Family, Parameter, label};
use crate::plan::Input;
use crate::plan::digits::split;
use crate::plan::interval::form::RationalForm;
use crate::plan::reach::{Reach, decimal};
use crate::rounding::{Error, NEAREST, has_ends_beside_floats, needs_functions};
use crate::steps::{Builder, FamilySteps, JoinSteps, Step, Steps};
use crate::theorem::{Origin, Theorem};
use basis_kernel::Relation;

/// A family, as a target writes it.
#[derive(Clone, Debug)]
pub struct FamilyCode<'a> {
    /// The family.
    pub family: &'a Family,
    /// Its name in the file: the one asked for, or that of the type in Rust.
    pub name: String,
    /// What stands before it: formulas, ranges, claims with their verdicts; Markdown, one string a line.
    pub documentation: Vec<String>,
    /// The shape parameters.
    pub shapes: Vec<Shape<'a>>,
    /// What is assumed of the shape values together.
    pub assumptions: Vec<Assumption<'a>>,
    /// The names of the coordinates of a point of the domain: t, all barycentric coordinates, the variables of a box.
    pub coordinates: Vec<String>,
    /// The labels of the functions, such as `b[2]`.
    pub labels: Vec<String>,
    /// Bounds of the rounding errors of the values, one for each function; `None` where none is proved.
    pub rounding: Vec<Option<Error>>,
    /// A bound of the rounding errors of each component of a point of a curve or patch, from its control points, relative to
    /// the largest absolute value of that component of a control point; `None` where none is proved.
    pub point_rounding: Option<Error>,
    /// The names of what is computed once from the shape values: the inputs [`Input::Shape`] after these.
    pub derived: Vec<String>,
    /// All that can be evaluated.
    pub steps: FamilySteps<'a>,
}

/// An end of a span.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Knot {
    /// A number.
    Number(Rational),
    /// A shape value, or one that is computed from these.
    Shape(usize),
}

/// A join, as a target writes it.
#[derive(Clone, Debug)]
pub struct JoinCode<'a> {
    /// The join.
    pub theorem: &'a Theorem,
    /// Its name in the file: the one asked for, or that of the function in Rust.
    pub name: String,
    /// What stands before it: its claims with their verdicts, the formulas of the points; Markdown, one string a line.
    pub documentation: Vec<String>,
    /// The arguments with control points: a whole net where all points of a curve or surface are given, or one point.
    pub points: Vec<Net>,
    /// Where the points stand that [`Input::Point`] means: an argument, and a position in it.
    pub given: Vec<(usize, usize)>,
    /// The scalars that the points depend on.
    pub scalars: Vec<Shape<'a>>,
    /// How these have to be related.
    pub assumptions: Vec<Assumption<'a>>,
    /// The results, one net for each curve or surface with determined points.
    pub results: Vec<Net>,
    /// The determined points, of all results one after the other.
    pub steps: JoinSteps<'a>,
}

/// Control points of a join.
#[derive(Clone, Debug)]
pub struct Net {
    /// Its name in the file.
    pub name: String,
    /// The names of the points in the spec, such as `Q[1]`.
    pub labels: Vec<String>,
    /// Whether it is one point and not a list.
    pub single: bool,
}

/// A condition on several shape values, or on several scalars of a join.
#[derive(Clone, Debug)]
pub struct Assumption<'a> {
    /// The polynomial with the sign, in the shape values or scalars.
    pub steps: Steps,
    /// Whether it is positive, or else not negative.
    pub strict: bool,
    /// The condition as it is written, such as `q < p`.
    pub text: &'a str,
}

/// A shape parameter or a scalar of a join: its value has to be finite and inside of the range.
#[derive(Clone, Debug)]
pub struct Shape<'a> {
    /// Its name in the file, in ASCII.
    pub name: String,
    /// Its name in the spec.
    pub written: &'a str,
    /// Its doc comment, one string a line.
    pub doc: &'a [String],
    /// The declared range, as far as the floats of the language reach: see [`reach`](crate::plan::reach).
    pub range: Range,
    /// The smallest and the largest value that `f32` reaches, where a language has both kinds of floats, and these do not reach
    /// all of the range.
    pub single: [Option<Rational>; 2],
    /// The range as text, such as `-3 <= λ <= 1`.
    pub shown: String,
    /// The same with the name in the file, in ASCII.
    pub condition: String,
}

impl<'a> FamilyCode<'a> {
    /// A family in a language: as its documentation has it, and as it is evaluated.
    ///
    /// # Errors
    /// Why no code is generated for it.
    pub fn new(
        told: &Family,
        family: &'a Family,
        wanted: &Wanted,
        language: &dyn Language,
    ) -> Result<Self, Diagnostic> {
        let is_bounded = language.has_accurate_functions() || !needs_functions(family);
        let proved =
            if is_bounded { generate::bounds_of_told(told, family) } else { generate::Bounds::default() };
        let (Some(steps), Some(documentation)) = (
            FamilySteps::new(family),
            generate::documentation(told, family, &proved, &wanted.checked.claims, DECIDED),
        ) else {
            return Err(generate::too_large(family));
        };
        let generate::Bounds { values: mut rounding, point: point_rounding } = proved;
        rounding.resize(family.functions.len(), None);
        if let Some(error) = generate::beyond_floats(family, &steps) {
            return Err(error);
        }
        let evaluators: Vec<Steps> = (0..steps.spans())
            .map(|span| steps.on_span(span))
            .flat_map(|steps| [steps.values(), steps.bernstein_weights(), steps.bind()])
            .collect();
        let message = |number: &Rational| {
            format!("`{}` has the number {number}, which is beyond what f32 holds", family.title())
        };
        single(evaluators.iter(), language, &family.place, &message)?;
        let name = named(wanted.name.as_ref().unwrap_or(&family.name), language)?;
        let reaches = generate::reaches(family, RationalForm::of_family(family).as_deref());
        if let Some(error) = generate::out_of_reach(family, &reaches, usize::from(language.is_single())) {
            return Err(error);
        }
        let shapes = shapes(family.shapes.iter(), Some((family, &reaches)), language);
        let mut taken: Vec<String> = shapes.iter().map(|shape| shape.name.clone()).collect();
        let derived = steps.derived().map_or(&[][..], |derived| &derived.names);
        let derived: Vec<String> = derived
            .iter()
            .map(|name| {
                let name = language.free(name, &taken);
                taken.push(name.clone());
                name
            })
            .collect();
        let coordinates: Vec<String> = family
            .domain_variables()
            .map(|variable| {
                let name = language.free(family.name_of(variable), &taken);
                taken.push(name.clone());
                name
            })
            .collect();
        let labels = (0..family.functions.len()).map(|k| family.function_label(k)).collect();
        let assumptions = assumptions(family.assumed(), &family.shapes.iter().collect::<Vec<_>>());
        Ok(Self {
            family,
            name,
            documentation,
            shapes,
            assumptions,
            coordinates,
            labels,
            rounding,
            point_rounding,
            derived,
            steps,
        })
    }

    /// The name of an input inside of a function: that of a shape value or of a coordinate, and `P0`, `D0`, `B0` for a
    /// component of a control point, of a derivative, of a bound coefficient. No language lets anything else have such
    /// a name: [`is_input`].
    pub fn input(&self, input: Input) -> String {
        match input {
            Input::Shape(k) => match self.shapes.get(k) {
                Some(shape) => shape.name.clone(),
                None => self.derived[k - self.shapes.len()].clone(),
            },
            Input::Coordinate(k) => self.coordinates[k].clone(),
            Input::Point(k) => format!("P{k}"),
            Input::Derivative(k) => format!("D{k}"),
            Input::Bound(k) => format!("B{k}"),
        }
    }

    /// The names of the shape values, of what is computed from these, and of the coordinates.
    pub fn taken(&self) -> Vec<String> {
        let shapes = self.shapes.iter().map(|shape| shape.name.clone());
        shapes.chain(self.derived.iter().cloned()).chain(self.coordinates.iter().cloned()).collect()
    }

    /// The number of functions.
    pub fn count(&self) -> usize {
        self.labels.len()
    }

    /// Whether it is a family on an interval, whose curves have derivatives in one parameter.
    pub fn is_curve(&self) -> bool {
        self.family.interval().is_some()
    }

    /// The orders of all first and second partial derivatives on a simplex or box, by independent coordinate.
    pub fn orders(&self) -> Vec<Vec<usize>> {
        let count = self.family.domain.len();
        let unit = |places: &[usize]| -> Vec<usize> {
            (0..count).map(|k| places.iter().filter(|place| **place == k).count()).collect()
        };
        let first = (0..count).map(|k| unit(&[k]));
        let second = (0..count).flat_map(|i| (i..count).map(move |j| (i, j))).map(|(i, j)| unit(&[i, j]));
        first.chain(second).collect()
    }

    /// The coordinates along which a partial derivative is taken, joined by `_`: `u_v` for ∂²/∂u∂v.
    pub fn along(&self, orders: &[usize]) -> String {
        let names = orders.iter().zip(self.independent());
        let names = names.flat_map(|(order, name)| std::iter::repeat_n(name, *order));
        names.collect::<Vec<_>>().join("_")
    }

    /// The names of the independent coordinates: of a simplex all but the last one.
    pub fn independent(&self) -> Vec<&str> {
        let mut names = self.coordinates.iter().map(String::as_str);
        let mut all = Vec::new();
        for factor in self.family.factors() {
            let independent =
                if let Factor::Simplex(independent, _) = factor { independent.len() } else { 1 };
            let simplex = matches!(factor, Factor::Simplex(..));
            all.extend(names.by_ref().take(independent));
            if simplex {
                names.next();
            }
        }
        all
    }

    /// The ends of the domain of a curve with the knots between its spans.
    pub fn knots(&self) -> Vec<Knot> {
        let knots = self.steps.knots();
        let one = |output: &usize| match &knots.steps[*output] {
            Step::Constant(value) => Knot::Number(value.clone()),
            Step::Input(Input::Shape(k)) => Knot::Shape(*k),
            other => unreachable!("a knot is no {other:?}"),
        };
        knots.outputs.iter().map(one).collect()
    }

    /// The two ends of the domain of a curve, where they are not numbers.
    pub fn moving_ends(&self) -> Option<[Knot; 2]> {
        let knots = self.knots();
        let ends = [knots.first()?.clone(), knots.last()?.clone()];
        ends.iter().any(|end| matches!(end, Knot::Shape(_))).then_some(ends)
    }

    /// The lower and upper end of each domain variable that belongs to no simplex; nothing where they depend on shape values.
    pub fn ends(&self) -> Vec<(Rational, Rational)> {
        if self.is_curve() {
            return match self.knots().as_slice() {
                [Knot::Number(low), .., Knot::Number(high)] => vec![(low.clone(), high.clone())],
                _ => Vec::new(),
            };
        }
        let ends = self.intervals().filter_map(|variable| variable.range.finite());
        ends.map(|(low, high)| (low.clone(), high.clone())).collect()
    }

    /// As [`ends`](Self::ends), with the names of the variables.
    pub fn named_ends(&self) -> Vec<(&str, (Rational, Rational))> {
        let named = self.family.domain_variables().zip(&self.coordinates);
        let names = named.filter(|(variable, _)| self.intervals().any(|other| other.var == variable.var));
        names.map(|(_, name)| name.as_str()).zip(self.ends()).collect()
    }

    /// The domain variables that belong to no simplex.
    fn intervals(&self) -> impl Iterator<Item = &Parameter> {
        self.family.factors().into_iter().filter_map(|factor| match factor {
            Factor::Interval(variable) => Some(variable),
            Factor::Simplex(..) => None,
        })
    }

    /// Whether bounds of rounding errors are proved that assume something of elementary functions.
    pub fn assumes_functions(&self) -> bool {
        needs_functions(self.family) && self.rounding.iter().any(Option::is_some)
    }

    /// A sentence on what bounds of rounding errors take a float for next to an end or a knot that is none.
    pub fn assumed_of_ends(&self) -> Option<String> {
        let is_assumed = has_ends_beside_floats(self.family) && self.rounding.iter().any(Option::is_some);
        is_assumed.then(|| format!("The {NEAREST}."))
    }

    /// Whether the distance to an end of the domain is computed from a number in parts, as no float has it exactly.
    pub fn has_ends_in_parts(&self) -> bool {
        let in_parts = |end: &Rational| !split(end, 24).1.is_zero();
        let numbers = self.ends().into_iter().flat_map(|(low, high)| [low, high]);
        !self.family.analytic.is_empty()
            || self.steps.is_quotient() && numbers.into_iter().any(|end| in_parts(&end))
    }

    /// The labels of the functions in a sentence: all of a few, the first and the last of many.
    pub fn listed(&self) -> String {
        match self.labels.as_slice() {
            [first, .., last] if self.labels.len() > 6 => format!("{first}, ..., {last}"),
            labels => labels.join(", "),
        }
    }
}

/// The name of an item in a file.
///
/// # Errors
/// When it has characters that no identifier has.
fn named(wanted: &str, language: &dyn Language) -> Result<String, Diagnostic> {
    let name = language.free(wanted, &[]);
    let mut characters = name.chars();
    let starts = characters.next().is_some_and(|c| c.is_ascii_alphabetic() || c == '_');
    if starts && characters.all(|c| c.is_ascii_alphanumeric() || c == '_') && name.chars().any(|c| c != '_') {
        return Ok(name);
    }
    let error = Diagnostic::unplaced(format!("`{wanted}` cannot be a name in the file"));
    Err(error.help("write letters, digits and `_`, first a letter"))
}

/// # Errors
/// When a constant is infinite or 0 as an `f32`, and that is what the language computes with.
fn single<'s>(
    all: impl Iterator<Item = &'s Steps>,
    language: &dyn Language,
    place: &Place,
    message: &dyn Fn(&Rational) -> String,
) -> Result<(), Diagnostic> {
    if !language.is_single() {
        return Ok(());
    }
    for step in all.flat_map(|steps| &steps.steps) {
        if let Step::Constant(value) = step {
            let float = value.to_f64() as f32;
            if float.is_infinite() || (float == 0.0 && !value.is_zero()) {
                let error = Diagnostic::error(place.clone(), message(value));
                return Err(
                    error.help("choose `--scalar f64` with a language that has it, or scale the functions")
                );
            }
        }
    }
    Ok(())
}

/// What is assumed of variables; each is the input at its position.
fn assumptions<'c>(
    constraints: impl Iterator<Item = &'c Constraint>,
    variables: &[&Parameter],
) -> Vec<Assumption<'c>> {
    let one = |constraint: &Constraint| {
        let mut builder = Builder::default();
        let mut sum = builder.constant(Rational::ZERO);
        for (monomial, coefficient) in constraint.value.terms() {
            let mut term = builder.constant(coefficient.clone());
            for (k, variable) in variables.iter().enumerate() {
                for _ in 0..monomial.exponent(variable.var) {
                    let factor = builder.input(Input::Shape(k));
                    term = builder.mul(term, factor);
                }
            }
            sum = builder.add(sum, term);
        }
        builder.finish(&[sum])
    };
    constraints
        .map(|c| Assumption { steps: one(c), strict: c.relation == Relation::Positive, text: &c.text })
        .collect()
}

impl<'a> JoinCode<'a> {
    /// A join in a language.
    ///
    /// # Errors
    /// Why there is no function for it.
    pub fn new(theorem: &'a Theorem, wanted: &Wanted, language: &dyn Language) -> Result<Self, Diagnostic> {
        let Some(steps) = JoinSteps::new(theorem) else { return Err(generate::join::products(theorem)) };
        let message = |number: &Rational| {
            format!("`{}` has the number {number}, which is beyond what f32 holds", theorem.name)
        };
        single([&steps.steps].into_iter(), language, &theorem.place, &message)?;
        let own = generate::join::name(theorem);
        let own = own.strip_prefix("r#").unwrap_or(&own).to_string();
        let name = named(wanted.name.as_ref().unwrap_or(&own), language)?;
        let documentation = generate::join::about(theorem, &wanted.checked.claims, DECIDED);
        let scalars = shapes(steps.scalars.iter().copied(), None, language);
        let assumptions = assumptions(generate::join::related(theorem, &steps.scalars), &steps.scalars);
        let mut taken: Vec<String> = scalars.iter().map(|scalar| scalar.name.clone()).collect();
        let mut net = |written: &str, labels: Vec<String>, single: bool| {
            let name = language.free(&plain(written), &taken);
            taken.push(name.clone());
            Net { name, labels, single }
        };
        let mut points: Vec<Net> = Vec::new();
        let mut given = vec![(0, 0); steps.given.len()];
        for (k, patch) in theorem.patches.iter().enumerate() {
            let used: Vec<usize> =
                (0..given.len()).filter(|place| theorem.points[steps.given[*place]].patch == k).collect();
            let labels = || patch.points.iter().map(|point| label(&patch.name, &point.index)).collect();
            if !used.is_empty() && patch.points.iter().all(|point| point.origin == Origin::Given) {
                for place in used {
                    let index = &theorem.points[steps.given[place]].index;
                    let at = patch.points.iter().position(|point| point.index == *index).unwrap_or(0);
                    given[place] = (points.len(), at);
                }
                points.push(net(&patch.name, labels(), false));
                continue;
            }
            for place in used {
                let point = &theorem.points[steps.given[place]];
                given[place] = (points.len(), 0);
                points.push(net(&point.name, vec![point.name.clone()], true));
            }
        }
        let results = steps.determined.iter().map(|(patch, points)| {
            let labels = points.iter().map(|(index, _)| label(&patch.name, index)).collect();
            net(&patch.name, labels, false)
        });
        let results = results.collect();
        Ok(Self { theorem, name, documentation, points, given, scalars, assumptions, results, steps })
    }

    /// The name of an input inside of the function: that of a scalar, and `P0`, `P1`, … for a component of a point.
    pub fn input(&self, input: Input) -> String {
        match input {
            Input::Shape(k) => self.scalars[k].name.clone(),
            Input::Point(k) => format!("P{k}"),
            other => unreachable!("a join has no input {other:?}"),
        }
    }

    /// The names of the arguments and results.
    pub fn taken(&self) -> Vec<String> {
        let nets = self.points.iter().chain(&self.results).map(|net| net.name.clone());
        nets.chain(self.scalars.iter().map(|scalar| scalar.name.clone())).collect()
    }
}

/// Whether a name is that of a component of a point: a letter P, D or B with a number.
pub fn is_input(name: &str) -> bool {
    let digits = name.strip_prefix(['P', 'D', 'B']);
    digits.is_some_and(|digits| !digits.is_empty() && digits.chars().all(|c| c.is_ascii_digit()))
}

/// A name of the spec without brackets: `h[0]` becomes `h_0`.
fn plain(name: &str) -> String {
    name.split(['[', ']', ',', ' ']).filter(|part| !part.is_empty()).collect::<Vec<_>>().join("_")
}

/// Parameters under names that differ: of a family with how far floats reach, or the scalars of a join.
fn shapes<'a>(
    parameters: impl Iterator<Item = &'a Parameter>,
    family: Option<(&'a Family, &[Option<Reach>])>,
    language: &dyn Language,
) -> Vec<Shape<'a>> {
    let mut names: Vec<String> = Vec::new();
    let floats = usize::from(language.is_single());
    parameters
        .enumerate()
        .map(|(k, parameter)| {
            let reach = family.and_then(|(_, reaches)| reaches[k].as_ref());
            let angle = family.and_then(|(family, _)| family.analytic.angle(parameter.var));
            let written = family.map_or(parameter.name.as_str(), |(family, _)| family.name_of(parameter));
            let name = language.free(&plain(written), &names);
            names.push(name.clone());
            let (range, is_short) = match family {
                Some((family, _)) => generate::within(family, parameter, reach, floats),
                None => (parameter.range.clone(), [false; 2]),
            };
            let mut ends = angle.map(|angle| angle.ends.clone());
            for ((end, range), is_short) in
                ends.iter_mut().flatten().zip([&range.low, &range.high]).zip(is_short)
            {
                if let (true, Some(reach)) = (is_short, range.value()) {
                    *end = decimal(reach);
                }
            }
            let single = |ends: fn(&Reach) -> &Option<[Rational; 2]>| {
                let ends = reach.filter(|_| !language.is_single()).and_then(|reach| ends(reach).as_ref());
                ends.map(|[_, single]| single.clone())
            };
            let single = [single(|reach| &reach.low), single(|reach| &reach.high)];
            let shown = |name: &str| match &ends {
                Some(ends) => angle_range(&range, ends, name),
                None => range.display(name).to_string(),
            };
            let (shown, condition) = (shown(written), shown(&name));
            Shape { name, written, doc: &parameter.doc, range, single, shown, condition }
        })
        .collect()
}

/// The range of an angle with its ends as they are written, such as `0 < α <= pi/2`.
fn angle_range(range: &Range, ends: &[String; 2], name: &str) -> String {
    let sign = |end: &End| if end.is_included() { "<=" } else { "<" };
    let mut text = String::from(name);
    if !ends[0].is_empty() {
        text = format!("{} {} {text}", ends[0], sign(&range.low));
    }
    if !ends[1].is_empty() {
        text += &format!(" {} {}", sign(&range.high), ends[1]);
    }
    text
}

//! What emitted code has to give, whatever its language: floats of the steps, and exact values with proved bounds.
//!
//! A test writes a program in a language that calls the emitted functions on the inputs of a [`Case`] in a fixed order
//! and prints the results as hexadecimal bits of `f64`, one a line. [`Case::expected`] has what these may be.

pub mod truth;

use std::borrow::Cow;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::rc::Rc;

use basis_engine::algebra::rational::{Rational, ToFloat as _};
use basis_engine::emit::{self, FamilyCode, Job, Language, Wanted};
use basis_engine::model::Factor;
use basis_engine::plan::Input;
use basis_engine::rounding::Error;
use basis_engine::state::{point_error, value_errors};
use basis_engine::steps::{EndSteps, FamilySteps, JoinSteps, Number, Step, Steps};
use basis_engine::theorem::theorems;
use basis_engine::{Disk, Family, Library, Prover, Source, Subject, decide, generate, source};

/// The families of these tests only.
pub const OWN: &str = include_str!("../specs/curves.basis");

/// How many components the control points have.
pub const DIMENSION: usize = 2;

/// A family with shape values.
#[derive(Clone, Debug)]
pub struct Case {
    /// The family, as it is evaluated.
    pub family: Rc<Family>,
    /// Its name in the file.
    pub name: &'static str,
    /// The shape values; every one is an `f32`.
    pub shapes: Vec<f64>,
    /// The text of the family, when it is emitted again.
    wanted: Wanted,
}

/// The kind of floats that a program computes with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Floats {
    /// `f32`
    Single,
    /// `f64`
    Double,
}

impl Floats {
    fn epsilon(self) -> Rational {
        Rational::new(1, 2).pow(if self == Self::Single { 23 } else { 52 })
    }

    /// The nearest float, as an `f64`.
    fn nearest(self, value: f64) -> f64 {
        if self == Self::Single { f64::from(value as f32) } else { value }
    }

    /// The next float above or below.
    fn next(self, value: f64, up: bool) -> f64 {
        match (self, up) {
            (Self::Single, true) => f64::from((value as f32).next_up()),
            (Self::Single, false) => f64::from((value as f32).next_down()),
            (Self::Double, true) => value.next_up(),
            (Self::Double, false) => value.next_down(),
        }
    }
}

/// A result of a program.
#[derive(Clone, Debug)]
pub struct Expected {
    /// What it is, for messages.
    pub what: String,
    /// The float that the steps give without fused operations.
    pub float: f64,
    /// The exact value with the largest error that is proved possible.
    pub exact: Option<(Rational, Rational)>,
}

/// The families that are tested in every language; with an environment variable `CASES`, those among the names in it.
pub fn cases() -> Vec<Case> {
    let mut all = all_cases();
    if let Ok(names) = std::env::var("CASES") {
        all.retain(|case| names.split_whitespace().any(|name| name == case.name));
    }
    all
}

fn all_cases() -> Vec<Case> {
    let own = |name, shapes: &[f64]| case(None, name, &[], name, shapes);
    let of = |file, name, order: &[i64], shapes: &[f64]| case(Some(file), name, order, name, shapes);
    let bernstein = |degree: i64, name| case(Some("bernstein"), "Bernstein", &[degree], name, &[]);
    vec![
        of("quartic", "QuarticBernstein", &[], &[-3.0]),
        case(Some("quartic"), "QuarticBernstein", &[], "Quartic1", &[1.0]),
        case(Some("quartic"), "QuarticBernstein", &[], "Quartic2", &[-0.40625]),
        of("quadratic", "QuadraticBezier", &[], &[0.75]),
        bernstein(1, "Linear"),
        bernstein(3, "Cubic"),
        bernstein(5, "Quintic"),
        bernstein(12, "Twelve"),
        of("beta_spline", "BetaSpline", &[], &[0.5, 3.0]),
        of("kochanek_bartels", "KochanekBartels", &[], &[0.25, -0.5, 0.75]),
        of("cardinal", "Cardinal", &[], &[0.5]),
        of("ball", "BallAlphaBeta", &[], &[0.75, -1.25]),
        of("lagrange", "Lagrange", &[4], &[]),
        of("hermite", "QuinticHermite", &[], &[]),
        own("Thirds", &[0.375]),
        own("double", &[1.5, 0.25]),
        own("Signs", &[]),
        own("Touching", &[0.333_251_953_125, 0.0]),
        own("Meeting", &[0.25, -0.5]),
        own("Grazing", &[0.5]),
        own("Slab", &[3.0]),
        case(Some("triangular"), "TriangularII", &[3], "Triangle", &[0.5, 0.25]),
        of("lagrange", "TriangularLagrange", &[2], &[]),
        of("lagrange", "TetrahedralLagrange", &[2], &[]),
        of("elements", "Trilinear", &[], &[]),
        of("triangles/prisms", "QuadraticWedge", &[], &[]),
        own("Column", &[0.75]),
        own("Weighted", &[0.75]),
        of("rational/bezier", "Conic", &[], &[3.0]),
        own("Reaching", &[]),
        own("Moving", &[2.5]),
        own("Pieces", &[]),
        own("Uneven", &[0.75, 1.5]),
        own("Quarter", &[0.625]),
        own("Turning", &[2.25]),
        own("Falling", &[]),
        own("Tense", &[1.5]),
        own("Waves", &[]),
        own("Cycloidal", &[2.25]),
        case(None, "Cycloidal", &[], "Narrow", &[0.015_625]),
        own("Beside", &[0.5]),
        own("Bounded", &[2.5]),
        own("Tension", &[0.75]),
        own("Arc", &[2.875]),
        own("Half", &[]),
        own("DBL_MAX", &[0.5, 0.75]),
        own("Straight", &[3.140_625]),
        case(None, "Arc", &[], "NearlyHalf", &[3.0]),
        own("Peak", &[0.375, 0.5]),
        of("trigonometric/han", "QuadraticTrigonometric", &[], &[0.5]),
    ]
}

fn case(file: Option<&str>, name: &str, order: &[i64], as_name: &'static str, shapes: &[f64]) -> Case {
    let source = match file {
        Some(file) => source::library(&Disk, file).expect("a file of the library"),
        None => Source::text("curves.basis", OWN),
    };
    case_of(source, name, order, as_name, shapes)
}

/// A family of a text, with as many shape values.
///
/// # Panics
/// When it is none, or has no code.
pub fn case_of(source: Source, name: &str, order: &[i64], as_name: &'static str, shapes: &[f64]) -> Case {
    let library = Library::from_source(&Disk, &Prover, source);
    let errors: Vec<String> = library.diagnostics().into_iter().map(|d| d.message.clone()).collect();
    let item = library.item(name, order).unwrap_or_else(|_| panic!("{name}{order:?}: {errors:?}"));
    let checked = decide(item);
    let wrong: Vec<String> =
        basis_engine::contradictions(&checked).into_iter().map(|d| d.message.clone()).collect();
    assert!(wrong.is_empty(), "{name}: {wrong:?}");
    let Subject::Family(family) = checked.subject.clone() else { panic!("{name} is no family") };
    let family = match generate::evaluated(&family, &checked.claims) {
        Ok(Cow::Owned(evaluated)) => Rc::new(evaluated),
        Ok(Cow::Borrowed(_)) => family,
        Err(error) => panic!("{name}: {}", error.message),
    };
    assert_eq!(family.shapes.len(), shapes.len(), "{name}");
    let wanted = Wanted { checked, name: Some(String::from(as_name)) };
    Case { family, name: as_name, shapes: shapes.to_vec(), wanted }
}

impl Case {
    /// The file with the family.
    ///
    /// # Panics
    /// When there is no code for it.
    pub fn emit(&self, language: &dyn Language) -> String {
        let items = [self.wanted.clone()];
        let job = Job { items: &items, spec: "curves.basis", command: "basis emit" };
        emit::emit(language, &job).unwrap_or_else(|errors| panic!("{}: {}", self.name, errors[0].message))
    }

    /// The family as a language writes it.
    ///
    /// # Panics
    /// When there is no code for it.
    pub fn code(&self, language: &dyn Language) -> FamilyCode<'_> {
        let Subject::Family(told) = &self.wanted.checked.subject else {
            panic!("{} is no family", self.name)
        };
        FamilyCode::new(told, &self.family, &self.wanted, language)
            .unwrap_or_else(|e| panic!("{}", e.message))
    }

    /// What can be evaluated.
    ///
    /// # Panics
    /// When there is no code for it.
    pub fn steps(&self) -> FamilySteps<'_> {
        FamilySteps::new(&self.family).expect("a family with code")
    }

    /// Whether it is a family on an interval.
    pub fn is_curve(&self) -> bool {
        self.family.interval().is_some()
    }

    /// The coordinates of points of the domain: ends, points next to them, and points inside.
    pub fn samples(&self, floats: Floats) -> Vec<Vec<f64>> {
        let steps = self.steps();
        if steps.is_quotient() {
            return self.on_quotients(floats);
        }
        let factors: Vec<Vec<Vec<f64>>> = self
            .family
            .factors()
            .into_iter()
            .map(|factor| match factor {
                Factor::Interval(p) => {
                    self.parameters(&p.range, floats).into_iter().map(|t| vec![t]).collect()
                }
                Factor::Simplex(independent, _) => on_simplex(independent.len() + 1),
            })
            .collect();
        match factors.as_slice() {
            [only] => only.clone(),
            // Not all combinations: every point of a factor with two of the others.
            _ => {
                let longest = factors.iter().map(Vec::len).max().unwrap_or(0);
                let point = |k: usize, shift: usize| -> Vec<f64> {
                    factors
                        .iter()
                        .enumerate()
                        .flat_map(|(place, points)| points[(k + place * shift) % points.len()].clone())
                        .collect()
                };
                (0..longest).flat_map(|k| [point(k, 0), point(k, 1), point(k, 3)]).collect()
            }
        }
    }

    /// The shape values, and what is computed from them in a kind of floats.
    fn scalars<N: Number>(&self, floats: Floats, derived_in: Floats, of: &dyn Fn(f64) -> N) -> Vec<N> {
        fn derived<M: Number>(steps: &Steps, shapes: &[M]) -> Vec<M> {
            let input = |input: Input| match input {
                Input::Shape(k) => shapes[k].clone(),
                other => panic!("{other:?}"),
            };
            steps.evaluate(input).expect("floats divide")
        }
        let mut all: Vec<N> = self.shapes.iter().map(|shape| of(*shape)).collect();
        let steps = self.steps();
        if let Some(computed) = steps.derived() {
            let computed = if floats == derived_in {
                derived(&computed.steps, &all)
            } else {
                let shapes: Vec<f64> = self.shapes.iter().map(|shape| floats.nearest(*shape)).collect();
                derived(&computed.steps, &shapes).into_iter().map(of).collect()
            };
            all.extend(computed);
        }
        all
    }

    /// The ends of the domain and the knots between its spans, as a program has them.
    fn knots(&self, floats: Floats) -> Vec<f64> {
        fn knots<N: Number>(case: &Case, floats: Floats, of: &dyn Fn(f64) -> N) -> Vec<N> {
            let scalars = case.scalars(floats, floats, of);
            let input = |input: Input| match input {
                Input::Shape(k) => scalars[k].clone(),
                other => panic!("{other:?}"),
            };
            case.steps().knots().evaluate(input).expect("floats divide")
        }
        match floats {
            Floats::Single => knots(self, floats, &|x| x as f32).into_iter().map(f64::from).collect(),
            Floats::Double => knots(self, floats, &|x| x),
        }
    }

    /// Parameters on each span: its ends that belong to it, their neighbours, and some between.
    fn on_quotients(&self, floats: Floats) -> Vec<Vec<f64>> {
        let knots = self.knots(floats);
        let range = &self.family.domain[0].range;
        let included = [range.low.is_included(), range.high.is_included()];
        let mut all = Vec::new();
        for (k, pair) in knots.windows(2).enumerate() {
            let (start, end) = (pair[0], pair[1]);
            if k > 0 || included[0] {
                all.push(start);
            }
            let near = floats.nearest(start + (end - start) / 1024.0);
            all.extend([if start == 0.0 { near } else { floats.next(start, true) }, near]);
            let parts = [0.0625, 0.25, 0.398_437_5, 0.5, 0.710_937_5, 0.9375];
            all.extend(parts.map(|part| floats.nearest(start + (end - start) * part)));
            all.push(floats.next(end, false));
        }
        if included[1] {
            all.extend(knots.last());
        }
        all.into_iter().map(|t| vec![t]).collect()
    }

    /// What is computed and what it is held against, of quotients on each span; nothing for other families.
    fn on_spans<'a>(&'a self, family: &FamilySteps<'_>) -> Vec<OnSpan<'a>> {
        if !family.is_quotient() {
            return Vec::new();
        }
        let one = |span: usize| {
            let steps = family.on_span(span);
            let curve = |count: usize| steps.curve(count).expect("a curve");
            OnSpan {
                functions: [steps.values(), steps.derivatives(&[1]), steps.derivatives(&[2])],
                point: curve(1),
                derivatives: curve(3),
                formulas: truth::Formulas::new(self.family.pieces.get(span).unwrap_or(&self.family)),
            }
        };
        (0..family.spans()).map(one).collect()
    }

    /// Whether sines and the like are computed, which every library rounds in its own way.
    pub fn calls(&self) -> bool {
        let steps = self.steps();
        let calls = |steps: &Steps| steps.steps.iter().any(|step| matches!(step, Step::Call(..)));
        steps.derived().is_some_and(|derived| calls(&derived.steps)) || calls(&steps.values())
    }

    fn parameters(&self, range: &basis_engine::algebra::range::Range, floats: Floats) -> Vec<f64> {
        let (low, high) = range.finite().expect("a domain has ends");
        let inside = |value: f64| {
            let exact = fraction(value);
            exact >= *low && exact <= *high
        };
        let [start, end] = [low, high].map(|end| floats.nearest(end.to_f64()));
        // So near to zero that no power of it underflows.
        let degree = self.family.functions.iter().map(|f| f.value.numer().total_degree()).max().unwrap_or(1);
        let exponent = (100 / degree.max(1)).min(60) as i32;
        let near = floats.nearest(start + 2.0_f64.powi(-exponent));
        let next = if start == 0.0 { near } else { floats.next(start, true) };
        let last = floats.next(end, false).min(end - (end - start) * 2.0_f64.powi(-exponent));
        let parts = [0.0625, 0.25, 0.398_437_5, 0.5, 0.710_937_5, 0.9375];
        let inner = parts.map(|part| floats.nearest(start + (end - start) * part));
        let ends = [start, next, near, floats.nearest(last), end];
        ends.into_iter().chain(inner).filter(|t| inside(*t)).collect()
    }

    /// Control points, one component after the other of each; every one is an `f32`.
    pub fn points(&self) -> Vec<f64> {
        let count = self.family.functions.len() * DIMENSION;
        (0..count).map(|k| ((k * 37 + 11) % 64) as f64 / 16.0 - 1.5).collect()
    }

    /// The derivatives of another curve at its end, and the factors of a contact.
    pub fn contact(&self) -> (Vec<f64>, f64, f64) {
        (vec![0.5, -1.25, 2.0, 0.75, -3.0, 1.5], 2.0, 0.75)
    }

    /// All that a program prints, in this order: for each sample the values, then of a family on an interval the first
    /// and second derivatives of the functions, the point, and the point again with two derivatives; of another one the
    /// partial derivatives of the functions and those of the patch after the point. At last for each order of contact,
    /// after and before, the control points with those that it determines.
    ///
    /// What depends on the shape values only is computed in `derived_in`.
    pub fn expected(&self, floats: Floats, derived_in: Floats) -> Vec<Expected> {
        match floats {
            Floats::Single => self.results::<f32>(floats, derived_in, &|x| x as f32, &|x| f64::from(*x)),
            Floats::Double => self.results::<f64>(floats, derived_in, &|x| x, &|x| *x),
        }
    }

    fn results<N: Number>(
        &self,
        floats: Floats,
        derived_in: Floats,
        of: &dyn Fn(f64) -> N,
        to: &dyn Fn(&N) -> f64,
    ) -> Vec<Expected> {
        let whole_family = self.steps();
        let mut all = Vec::new();
        let scalars = self.scalars(floats, derived_in, of);
        let on_spans = self.on_spans(&whole_family);
        let knots = if on_spans.is_empty() { Vec::new() } else { self.knots(floats) };
        let exact_shapes: Vec<Rational> = self.shapes.iter().map(|shape| fraction(*shape)).collect();
        let value_bounds: Vec<Option<Error>> =
            value_errors(&self.family).into_iter().map(|known| known.map(|(error, _)| error)).collect();
        let point_bound = point_error(&self.family).map(|(error, _)| error);
        let points = self.points();
        let largest = |axis: usize| -> f64 {
            points.iter().skip(axis).step_by(DIMENSION).fold(0.0, |most, p| f64::max(most, p.abs()))
        };
        let bind = whole_family.bind();
        let bound: Vec<Vec<f64>> = (0..DIMENSION)
            .map(|axis| {
                let input = |input: Input| match input {
                    Input::Shape(k) => scalars[k].clone(),
                    Input::Point(k) => of(points[k * DIMENSION + axis]),
                    other => panic!("{other:?}"),
                };
                bind.evaluate(input).expect("floats divide").iter().map(to).collect()
            })
            .collect();
        for at in self.samples(floats) {
            let (span, place) =
                if on_spans.is_empty() { (0, truth::At::End(0)) } else { place(&knots, at[0]) };
            let family = &whole_family;
            let number = |steps: &Steps, axis: usize| -> Vec<f64> {
                let input = |input: Input| match input {
                    Input::Shape(k) => scalars[k].clone(),
                    Input::Coordinate(k) => of(at[k]),
                    Input::Bound(k) => of(bound[axis][k]),
                    other => panic!("{other:?}"),
                };
                steps.evaluate(input).expect("floats divide").iter().map(to).collect()
            };
            let exact = |steps: &Steps, axis: usize| -> Vec<Rational> {
                let input = |input: Input| match input {
                    Input::Shape(k) => fraction(self.shapes[k]),
                    Input::Coordinate(k) => fraction(at[k]),
                    Input::Point(k) => fraction(points[k * DIMENSION + axis]),
                    other => panic!("{other:?}"),
                };
                steps.evaluate::<Rational>(input).expect("inside of the domain")
            };
            let mut push = |what: String, float: f64, exact: Option<(Rational, Rational)>| {
                all.push(Expected { what: format!("{}: {what} at {at:?}", self.name), float, exact });
            };
            if let Some(OnSpan { functions, point, derivatives, formulas }) = on_spans.get(span) {
                let truths = formulas.at(&exact_shapes, &place);
                // Differences of Bernstein coefficients times the degree, divided by the length of the span.
                let grows = |order: usize| formulas.growth(&exact_shapes).pow(order as u32);
                for (order, (steps, truths)) in functions.iter().zip(&truths).enumerate() {
                    let least = if order == 0 { Rational::ONE } else { grows(order) };
                    let largest = truths.iter().fold(least, |sum, value| &sum + &value.abs());
                    for (k, (float, truth)) in number(steps, 0).into_iter().zip(truths).enumerate() {
                        let tolerance = match value_bounds.get(k).cloned().flatten().filter(|_| order == 0) {
                            Some(Error::Relative(bound)) => &bound * &truth.abs(),
                            Some(Error::Absolute(bound)) => bound,
                            None if order == 0 => &measured() * &truth.abs(),
                            None => &measured() * &largest,
                        };
                        let tolerance = &tolerance * &floats.epsilon();
                        let what = format!("derivative {order} of function {k}");
                        push(what, float, Some((truth.clone(), tolerance)));
                    }
                }
                let component = |order: usize, axis: usize| {
                    let terms = truths[order].iter().enumerate();
                    let terms: Vec<Rational> =
                        terms.map(|(k, value)| value * &fraction(points[k * DIMENSION + axis])).collect();
                    let sum = |terms: &[Rational], of: fn(&Rational) -> Rational| {
                        terms.iter().fold(Rational::ZERO, |sum, term| &sum + &of(term))
                    };
                    let least = if order == 0 { Rational::ONE } else { grows(order) };
                    let size = &sum(&terms, Rational::abs) + &(&least * &fraction(largest(axis)));
                    let tolerance = match &point_bound {
                        Some(bound) if order == 0 => bound.epsilons() * &fraction(largest(axis)),
                        _ => &measured() * &size,
                    };
                    (sum(&terms, Rational::clone), &tolerance * &floats.epsilon())
                };
                for axis in 0..DIMENSION {
                    let exact = Some(component(0, axis));
                    push(format!("component {axis} of the point"), number(point, axis)[0], exact);
                }
                for order in 0..3 {
                    for axis in 0..DIMENSION {
                        let float = number(derivatives, axis)[order];
                        let what = format!("component {axis} of derivative {order}");
                        push(what, float, Some(component(order, axis)));
                    }
                }
                continue;
            }
            let values = family.values();
            let truth = exact(&values, 0);
            for (k, (float, truth)) in number(&values, 0).into_iter().zip(truth).enumerate() {
                let tolerance = value_bounds.get(k).cloned().flatten().map(|error| match error {
                    Error::Relative(bound) => &(&bound * &floats.epsilon()) * &truth.abs(),
                    Error::Absolute(bound) => &bound * &floats.epsilon(),
                });
                push(format!("value {k}"), float, tolerance.map(|tolerance| (truth, tolerance)));
            }
            let orders: Vec<Vec<usize>> =
                if self.is_curve() { vec![vec![1], vec![2]] } else { orders(self.family.domain.len()) };
            for order in &orders {
                for (k, float) in number(&family.derivatives(order), 0).into_iter().enumerate() {
                    push(format!("derivative {order:?} of function {k}"), float, None);
                }
            }
            if let (Some(point), Some(derivatives)) = (family.curve(1), family.curve(3)) {
                let whole = family.on_control_points(&point);
                for axis in 0..DIMENSION {
                    let tolerance = point_bound.as_ref().map(|bound| {
                        let bound = bound.epsilons();
                        &(bound * &floats.epsilon()) * &fraction(largest(axis))
                    });
                    let exact = tolerance.map(|tolerance| (exact(&whole, axis)[0].clone(), tolerance));
                    push(format!("component {axis} of the point"), number(&point, axis)[0], exact);
                }
                let components: Vec<Vec<f64>> =
                    (0..DIMENSION).map(|axis| number(&derivatives, axis)).collect();
                for k in 0..3 {
                    for (axis, component) in components.iter().enumerate() {
                        push(format!("component {axis} of derivative {k}"), component[k], None);
                    }
                }
                continue;
            }
            let none = vec![0; self.family.domain.len()];
            for order in std::iter::once(&none).chain(&orders) {
                let steps = family.patch(order).expect("a patch");
                let bound = point_bound.as_ref().filter(|_| order.iter().all(|k| *k == 0));
                let whole = bound.map(|bound| (bound.epsilons(), family.on_control_points(&steps)));
                for axis in 0..DIMENSION {
                    let exact = whole.as_ref().map(|(bound, whole)| {
                        let tolerance = &(*bound * &floats.epsilon()) * &fraction(largest(axis));
                        (exact(whole, axis)[0].clone(), tolerance)
                    });
                    push(format!("component {axis} of partial {order:?}"), number(&steps, axis)[0], exact);
                }
            }
        }
        for at_start in [true, false] {
            for end in self.ends(at_start) {
                let (derivatives, f, c) = self.contact();
                let mut solved = points.clone();
                for axis in 0..DIMENSION {
                    // As the runtime's `Contact::transform`.
                    let [p, d1, d2] = [0, 1, 2].map(|k| of(derivatives[k * DIMENSION + axis]));
                    let inverse = of(1.0).div(&of(f)).expect("floats divide");
                    let d1 = d1.mul(&inverse);
                    let d2 = d2.add(&d1.mul(&of(-c))).mul(&inverse.mul(&inverse));
                    let input = |input: Input| match input {
                        Input::Shape(k) => of(self.shapes[k]),
                        Input::Point(k) => of(points[k * DIMENSION + axis]),
                        Input::Derivative(k) => [&p, &d1, &d2][k].clone(),
                        other => panic!("{other:?}"),
                    };
                    let outputs = end.steps.evaluate(input).expect("floats divide");
                    for (position, output) in end.positions.iter().zip(&outputs) {
                        solved[position * DIMENSION + axis] = to(output);
                    }
                }
                let order = end.positions.len() - 1;
                let what = format!("{}: point of contact {order}, after: {at_start}", self.name);
                let one = |float: f64| Expected { what: what.clone(), float, exact: None };
                all.extend(solved.into_iter().map(one));
            }
        }
        all
    }

    /// The orders of contact that determine control points for these shape values, at the start or else at the end.
    pub fn contacts(&self, at_start: bool) -> Vec<usize> {
        self.ends(at_start).iter().map(|end| end.positions.len() - 1).collect()
    }

    fn ends(&self, at_start: bool) -> Vec<EndSteps> {
        let mut all = self.steps().ends(2, at_start);
        all.retain(|end| {
            let divisors = end.steps.evaluate::<f64>(|input| match input {
                Input::Shape(k) => self.shapes[k],
                _ => 1.0,
            });
            divisors
                .is_some_and(|outputs| outputs[end.positions.len()..].iter().all(|divisor| *divisor != 0.0))
        });
        all
    }
}

/// The join of these tests, with what it is called with.
#[derive(Clone, Debug)]
pub struct Join {
    /// The scalar δ.
    pub delta: f64,
    /// The control points of P, four.
    pub points: Vec<f64>,
    wanted: Wanted,
}

impl Join {
    /// The join `Smooth`.
    ///
    /// # Panics
    /// When it is not there.
    pub fn new() -> Self {
        let wanted = wanted_join("Smooth");
        let points = vec![0.5, 1.25, -2.0, 3.5, 1.75, 0.125, -0.375, 2.5];
        Self { delta: 1.625, points, wanted }
    }

    /// The file with the join.
    ///
    /// # Panics
    /// When there is no code for it.
    pub fn emit(&self, language: &dyn Language) -> String {
        emit_join(&self.wanted, language)
    }

    /// The determined points Q\[0] and Q\[1], component by component.
    ///
    /// # Panics
    /// When it has other inputs than one scalar and points.
    pub fn expected(&self) -> Vec<Expected> {
        let Subject::Theorem(theorem) = &self.wanted.checked.subject else { panic!("a join is a theorem") };
        let join = JoinSteps::new(theorem).expect("points that are linear in the given ones");
        let component = |axis: usize| -> Vec<f64> {
            let input = |input: Input| match input {
                Input::Shape(0) => self.delta,
                Input::Point(k) => self.points[join.given[k] * DIMENSION + axis],
                other => panic!("{other:?}"),
            };
            join.steps.evaluate(input).expect("floats divide")
        };
        let components: Vec<Vec<f64>> = (0..DIMENSION).map(component).collect();
        let point = |k: usize| components.iter().map(move |component| component[k]);
        let one = |float| Expected { what: String::from("a point of the join"), float, exact: None };
        (0..2).flat_map(point).map(one).collect()
    }
}

fn wanted_join(name: &str) -> Wanted {
    let library = Library::from_source(&Disk, &Prover, Source::text("curves.basis", OWN));
    let item = theorems(&library).into_iter().find(|item| item.subject.name() == name);
    Wanted { checked: decide(item.expect("in the file")), name: None }
}

fn emit_join(wanted: &Wanted, language: &dyn Language) -> String {
    let items = [wanted.clone()];
    let job = Job { items: &items, spec: "curves.basis", command: "basis emit" };
    emit::emit(language, &job).unwrap_or_else(|errors| panic!("{}", errors[0].message))
}

/// The file with the join `Related`, whose scalars are related to one another. With P = 0, 1, 3 and the scalars
/// [`RELATED`] it gives 3, 4; each list of [`UNRELATED`] does not satisfy one of its three relations.
pub fn related_join(language: &dyn Language) -> String {
    emit_join(&wanted_join("Related"), language)
}

/// Scalars that satisfy what the join `Related` assumes.
pub const RELATED: &str = "2.0, 1.0, 0.5, 0.5";

/// Scalars that do not, the relations in their order.
pub const UNRELATED: [&str; 3] = ["1.0, 2.0, 0.5, 0.5", "2.0, 1.0, 1.0, 0.75", "2.0, 1.0, -0.8125, 1.0"];

impl Default for Join {
    fn default() -> Self {
        Self::new()
    }
}

/// Corners of a simplex, points next to them and one inside, all barycentric coordinates.
fn on_simplex(count: usize) -> Vec<Vec<f64>> {
    let small = 1.0 / 1024.0;
    let mut all = Vec::new();
    for k in 0..count {
        let mut corner = vec![0.0; count];
        corner[k] = 1.0;
        all.push(corner.clone());
        corner[k] = 1.0 - small;
        corner[(k + 1) % count] = small;
        all.push(corner.clone());
        corner[(k + 1) % count] = small / 2.0;
        corner[(k + 2) % count] = small / 2.0;
        all.push(corner);
    }
    let mut inner = vec![0.125; count];
    inner[0] = 1.0 - 0.125 * (count - 1) as f64;
    all.push(inner);
    all
}

/// The orders of all first and second partial derivatives, as emitted code has them.
pub fn orders(count: usize) -> Vec<Vec<usize>> {
    let unit = |places: &[usize]| -> Vec<usize> {
        (0..count).map(|k| places.iter().filter(|place| **place == k).count()).collect()
    };
    let first = (0..count).map(|k| unit(&[k]));
    let second = (0..count).flat_map(|i| (i..count).map(move |j| [i, j])).map(|pair| unit(&pair));
    first.chain(second).collect()
}

/// The fraction that a float is.
///
/// # Panics
/// When it is infinite or NaN.
pub fn fraction(value: f64) -> Rational {
    assert!(value.is_finite(), "{value} is not a number");
    let (bits, exponent) = (value.to_bits() & ((1 << 52) - 1), value.to_bits() >> 52 & 0x7ff);
    let mantissa = if exponent == 0 { bits } else { bits | 1 << 52 };
    let power = Rational::from(2).pow(exponent.max(1).abs_diff(1075) as u32);
    let size = Rational::from(mantissa as i64);
    let size = if exponent < 1075 { &size / &power } else { &size * &power };
    if value < 0.0 { -size } else { size }
}

/// The listing of the guide in a language, and its family as a file.
///
/// # Panics
/// When the guide has no such listing.
pub fn guide(info: &str, language: &dyn Language) -> (String, String) {
    let page = include_str!("../../../guide/src/code.md");
    let start = format!("```{info}\n");
    let listing = page.split(start.as_str()).nth(1).and_then(|rest| rest.split("```").next());
    let quartic = case(Some("quartic"), "QuarticBernstein", &[], "QuarticBernstein", &[0.5]);
    (listing.expect("the guide has it").to_string(), quartic.emit(language))
}

/// A span of a family of quotients.
struct OnSpan<'a> {
    /// The values, first and second derivatives of the functions.
    functions: [Steps; 3],
    point: Steps,
    derivatives: Steps,
    formulas: truth::Formulas<'a>,
}

/// The span of a parameter, and where in it the parameter is.
fn place(knots: &[f64], t: f64) -> (usize, truth::At) {
    let span = knots[1..knots.len() - 1].iter().filter(|knot| t >= **knot).count();
    let at = match t {
        _ if t == knots[span] => truth::At::End(0),
        _ if t == knots[span + 1] => truth::At::End(1),
        _ => truth::At::Inside(fraction(t)),
    };
    (span, at)
}

/// The number of ε by which what has no proved bound may be off, of the value itself for functions: those with angles or
/// several spans, and derivatives. Measured, with a reserve.
pub fn measured() -> Rational {
    Rational::from(48)
}

/// How a program rounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounds {
    /// As the steps: every result is compared bit for bit, but for the sign of a zero.
    EveryStep,
    /// Products may be fused into sums.
    Fused,
}

/// Compares what a program printed, one `f64` in hexadecimal digits a line, with what is expected; the error is the
/// first difference.
///
/// # Errors
/// Where a value is beyond the proved bound, or another float than that of the steps.
pub fn compare(printed: &str, expected: &[Expected], rounds: Rounds) -> Result<(), String> {
    let lines: Vec<&str> = printed.lines().collect();
    if lines.len() != expected.len() {
        return Err(format!("{} results in place of {}", lines.len(), expected.len()));
    }
    for (line, Expected { what, float, exact }) in lines.iter().zip(expected) {
        let bits = u64::from_str_radix(line, 16).map_err(|e| format!("{what}: `{line}`: {e}"))?;
        let found = f64::from_bits(bits);
        if !found.is_finite() {
            return Err(format!("{what}: {found}"));
        }
        if rounds == Rounds::EveryStep && found != *float {
            return Err(format!("{what}: {found:e} in place of {float:e}"));
        }
        if let Some((exact, tolerance)) = exact
            && (&fraction(found) - exact).abs() > *tolerance
        {
            return Err(format!("{what}: {found:e} is farther from {exact} than {tolerance}"));
        }
    }
    Ok(())
}

/// Runs a command in a folder and returns what it printed.
///
/// # Panics
/// When it cannot be started or fails.
pub fn run(folder: &Path, program: &str, arguments: &[&str]) -> String {
    let output = Command::new(program).args(arguments).current_dir(folder).output();
    let output = output.unwrap_or_else(|e| panic!("{program}: {e}"));
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    let said = text(&output.stderr) + &text(&output.stdout);
    assert!(output.status.success(), "{program} {arguments:?}: {said}");
    text(&output.stdout)
}

/// Whether a program can be started; otherwise it is said that its tests are skipped.
pub fn has(program: &str, arguments: &[&str]) -> bool {
    let found = Command::new(program).args(arguments).output().is_ok_and(|output| output.status.success());
    if !found {
        eprintln!("skipped: `{program} {}` does not run here", arguments.join(" "));
    }
    found
}

/// A path that is written.
///
/// # Panics
/// When it cannot be written.
pub fn write(folder: &Path, name: &str, text: &str) -> PathBuf {
    let path = folder.join(name);
    std::fs::write(&path, text).expect("the folder can be written to");
    path
}

/// Numbers as a list between commas, each as the shortest decimal that is read as the same `f64`.
pub fn list(numbers: &[f64], suffix: &str) -> String {
    numbers.iter().map(|x| format!("{x:?}{suffix}")).collect::<Vec<_>>().join(", ")
}

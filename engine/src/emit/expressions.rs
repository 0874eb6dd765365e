//! Steps as expressions of a language in infix notation: named values, and the results.

use super::Language;
use crate::algebra::rational::{Rational, ToFloat as _};
use crate::decimals;
use crate::plan::Input;
use crate::steps::{Step, Steps};

/// A line is not made longer than this by putting one expression into another.
const WIDTH: usize = 72;

/// The body of a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Expressions {
    /// Names with their values, in the order in which they are computed.
    pub lets: Vec<(String, Value)>,
    /// The results.
    pub outputs: Vec<Value>,
}

/// An expression.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Value {
    /// Its text.
    pub text: String,
    /// Whether it depends on a component of points, so that each component of a point has its own.
    pub of_points: bool,
    /// Whether it depends on a coordinate of the point of the domain.
    pub of_domain: bool,
}

/// How tightly an expression holds together.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    Sum,
    Product,
    Signed,
    /// Of a function: needs no parentheses, and is computed.
    Call,
    Atom,
}

struct Text {
    value: Value,
    form: Form,
}

impl Expressions {
    /// The operations of `steps` in their association, on inputs that have names. What is used twice has a name: that of
    /// the plan, such as `s2` or `c0`, or else `v0`, `v1`, …; no name is one of `taken` or a word of the language. A
    /// quotient by a power of two is a product, which is the same float.
    pub fn new(
        steps: &Steps,
        language: &dyn Language,
        input: &dyn Fn(Input) -> String,
        taken: &[String],
    ) -> Self {
        let mut uses = vec![0_usize; steps.steps.len()];
        for operand in steps.steps.iter().flat_map(Step::operands).chain(steps.outputs.iter().copied()) {
            uses[operand] += 1;
        }
        // What is cut off is compared and taken.
        for step in &steps.steps {
            if let Step::CutOff(a) = step {
                uses[*a] += 1;
            }
        }
        let mut names = taken.to_vec();
        let mut unnamed = 0;
        let mut lets = Vec::new();
        let mut texts: Vec<Text> = Vec::new();
        for (k, step) in steps.steps.iter().enumerate() {
            let constant = |k: usize| match &steps.steps[k] {
                Step::Constant(value) => Some(value),
                _ => None,
            };
            let mut text = expression(step, &texts, language, input, &constant);
            let computed = text.form != Form::Atom;
            let name = steps.name(k).filter(|_| computed);
            let cut_off = steps.steps.contains(&Step::CutOff(k));
            let signed = matches!(step, Step::Neg(_)) && uses[k] < 3 && !cut_off;
            if name.is_some() || (computed && !signed && uses[k] > 1) || text.value.text.len() > WIDTH {
                let name = match name {
                    Some(name) => language.free(name, &names),
                    None => {
                        unnamed += 1;
                        language.free(&format!("v{}", unnamed - 1), &names)
                    }
                };
                names.push(name.clone());
                lets.push((name.clone(), text.value.clone()));
                text = Text { value: Value { text: name, ..text.value }, form: Form::Atom };
            }
            texts.push(text);
        }
        let outputs = steps.outputs.iter().map(|output| texts[*output].value.clone()).collect();
        Self { lets, outputs }
    }
}

fn expression<'a>(
    step: &Step,
    texts: &[Text],
    language: &dyn Language,
    input: &dyn Fn(Input) -> String,
    constant: &dyn Fn(usize) -> Option<&'a Rational>,
) -> Text {
    let within = |k: usize, apart: &[Form]| {
        let Text { value, form } = &texts[k];
        if apart.contains(form) { format!("({})", value.text) } else { value.text.clone() }
    };
    let (first_of_sum, second_of_sum) = ([].as_slice(), [Form::Sum, Form::Signed].as_slice());
    // A language may give a sign another rank than Rust does: a signed factor stands in parentheses.
    let first_factor = [Form::Sum, Form::Signed].as_slice();
    let second_factor = [Form::Sum, Form::Product, Form::Signed].as_slice();
    let pair = |a: usize, left: &[Form], sign: &str, b: usize, right: &[Form]| {
        format!("{} {sign} {}", within(a, left), within(b, right))
    };
    let (text, form) = match step {
        Step::Input(which) => (input(*which), Form::Atom),
        Step::Constant(value) if value.is_negative() => {
            (format!("-{}", language.literal(&value.abs())), Form::Signed)
        }
        Step::Constant(value) => (language.literal(value), Form::Atom),
        Step::Neg(a) => (format!("-{}", within(*a, &[Form::Sum, Form::Product, Form::Signed])), Form::Signed),
        Step::Add(a, b) => (pair(*a, first_of_sum, "+", *b, second_of_sum), Form::Sum),
        Step::Sub(a, b) => (pair(*a, first_of_sum, "-", *b, second_of_sum), Form::Sum),
        Step::Mul(a, b) => (pair(*a, first_factor, "*", *b, second_factor), Form::Product),
        Step::Div(a, b) => {
            match constant(*b).filter(|value| is_power_of_two(value)).and_then(Rational::recip) {
                Some(factor) => {
                    (format!("{} * {}", within(*a, first_factor), language.literal(&factor)), Form::Product)
                }
                None => (pair(*a, first_factor, "/", *b, second_factor), Form::Product),
            }
        }
        Step::Call(function, a) => (language.call(*function, &texts[*a].value.text), Form::Call),
        Step::Unless(a, b, c) => {
            (language.unless(&[*a, *b, *c].map(|k| within(k, first_factor))), Form::Call)
        }
        Step::Less(a, b) => (language.less(&[*a, *b].map(|k| within(k, first_factor))), Form::Call),
        Step::CutOff(a) => (language.cut_off(&texts[*a].value.text), Form::Call),
    };
    let depends = |which: fn(&Value) -> bool| step.operands().iter().any(|k| which(&texts[*k].value));
    let (of_points, of_domain) = match step {
        Step::Input(Input::Coordinate(_)) => (false, true),
        Step::Input(Input::Shape(_)) => (false, false),
        Step::Input(_) => (true, false),
        _ => (depends(|value| value.of_points), depends(|value| value.of_domain)),
    };
    Text { value: Value { text, of_points, of_domain }, form }
}

/// Whether a number is a power of two, not too large or small for any float.
fn is_power_of_two(value: &Rational) -> bool {
    let part = |n: Option<i64>| n.is_some_and(|n| n > 0 && n.count_ones() == 1);
    part(value.numer().to_i64()) && part(value.denom().to_i64())
}

/// The shortest decimal that a program reads as the `f64` nearest to a number ≥ 0, with a decimal point: `0.25`,
/// `3.0`, `1e-30`.
pub fn decimal(value: &Rational) -> String {
    decimals::of_f64(value.to_f64())
}

/// As [`decimal`] for the `f32` nearest to that `f64`.
pub fn decimal_f32(value: &Rational) -> String {
    decimals::of_f32(value.to_f64() as f32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Diagnostic;
    use crate::emit::{FamilyCode, JoinCode, Wanted};
    use crate::source;
    use crate::steps::Function;
    use crate::{Disk, Family, Library, Prover, Source, Subject, decide};

    /// The language of specs: what is written is read again by the engine, exactly.
    struct Spec(Vec<String>);

    impl Language for Spec {
        fn comment(&self, lines: &[String]) -> String {
            lines.iter().map(|line| format!("// {line}\n")).collect::<Vec<_>>().concat()
        }
        fn literal(&self, value: &Rational) -> String {
            if value.is_integer() { value.to_string() } else { format!("({value})") }
        }
        fn is_single(&self) -> bool {
            false
        }
        fn is_reserved(&self, name: &str) -> bool {
            ["b", "t", "v", "w", "x", "s"].contains(&name)
        }
        fn call(&self, function: Function, _: &str) -> String {
            panic!("{function:?} is not written here")
        }
        fn unless(&self, parts: &[String; 3]) -> String {
            panic!("{parts:?} is not written here")
        }
        fn less(&self, parts: &[String; 2]) -> String {
            panic!("{parts:?} is not written here")
        }
        fn cut_off(&self, name: &str) -> String {
            name.to_string()
        }
        fn family(&self, code: &FamilyCode<'_>) -> Result<String, Diagnostic> {
            let Expressions { lets, outputs } = Expressions::new(
                &code.steps.values(),
                self,
                &|input| match input {
                    Input::Shape(k) => self.0[k].clone(),
                    Input::Coordinate(k) => ["t", "v", "w", "x"][k].to_string(),
                    other => panic!("{other:?}"),
                },
                &self.0,
            );
            let domain = if code.family.is_simplex() {
                let names = ["t", "v", "w", "x"][..code.steps.coordinates()].join(", ");
                let kind = if code.steps.coordinates() == 3 { "triangle" } else { "tetrahedron" };
                format!("domain {kind} ({names});")
            } else {
                String::from("domain 0 <= t <= 1;")
            };
            let mut lines = vec![domain];
            for (shape, name) in code.shapes.iter().zip(&self.0) {
                lines.push(format!("shape {};", shape.shown.replace(shape.written, name)));
            }
            lines.extend(lets.iter().map(|(name, value)| format!("let {name} = {};", value.text)));
            lines.extend(outputs.iter().enumerate().map(|(k, value)| format!("b[{k}] = {};", value.text)));
            Ok(format!("family {} {{\n{}\n}}\n", code.name, lines.join("\n")))
        }
        fn join(&self, join: &JoinCode<'_>) -> Result<String, Diagnostic> {
            panic!("{} is not written here", join.name)
        }
        fn file(&self, header: &str, items: &[String]) -> String {
            header.to_string() + &items.concat()
        }
    }

    fn family(source: Source, name: &str, order: &[i64]) -> std::rc::Rc<Family> {
        let library = Library::from_source(&Disk, &Prover, source);
        let errors: Vec<String> = library.diagnostics().into_iter().map(|d| d.message.clone()).collect();
        let item = library.item(name, order).unwrap_or_else(|_| panic!("{name}: {errors:?}"));
        match item.subject {
            Subject::Family(family) => family,
            Subject::Theorem(_) => panic!("{name} is a theorem"),
        }
    }

    #[test]
    fn expressions_mean_what_the_steps_do() {
        for (file, name, order) in [
            ("quartic", "QuarticBernstein", &[][..]),
            ("beta_spline", "BetaSpline", &[]),
            ("kochanek_bartels", "KochanekBartels", &[]),
            ("lagrange", "Lagrange", &[5]),
            ("lagrange", "TriangularLagrange", &[3]),
            ("lagrange", "TetrahedralLagrange", &[2]),
            ("triangular", "TriangularII", &[5]),
        ] {
            let original = family(source::library(&Disk, file).expect("in the library"), name, order);
            let shapes: Vec<String> = (0..original.shapes.len()).map(|k| format!("a{k}")).collect();
            let checked = decide(crate::Item {
                subject: Subject::Family(original.clone()),
                claims: Vec::new(),
                obligations: Vec::new(),
            });
            let job_items = [Wanted { checked, name: Some(String::from("s")) }];
            let job = crate::emit::Job { items: &job_items, spec: file, command: "basis emit" };
            let text = crate::emit::emit(&Spec(shapes), &job).expect("there is code");
            // The name `s` is reserved here.
            let again = family(Source::text("again.basis", &text), "s_", &[]);
            for (a, b) in original.functions.iter().zip(&again.functions) {
                assert_eq!(a.value, b.value, "{text}");
            }
        }
    }

    #[test]
    fn decimals_are_read_as_the_same_float() {
        let third = Rational::new(1, 3);
        assert_eq!(decimal(&third), "0.3333333333333333");
        assert_eq!(decimal_f32(&third), "0.33333334");
        assert_eq!([decimal(&Rational::new(3, 1)), decimal(&Rational::new(1, 4))], ["3.0", "0.25"]);
        let small = Rational::new(1, 10).pow(30);
        assert_eq!(decimal(&small).parse::<f64>(), Ok(1e-30));
    }
}

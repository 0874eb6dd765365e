//! Steps as expressions of a language in infix notation: named values, and the results.

use super::Language;
use crate::algebra::rational::Rational;
use crate::steps::{Step, Steps};

/// A line is not made longer than this by putting one expression into another.
const WIDTH: usize = 72;

/// The body of a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Expressions {
    /// Names with their values, in the order in which they are computed.
    pub lets: Vec<(String, String)>,
    /// The results.
    pub outputs: Vec<String>,
}

/// How tightly an expression holds together.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    Sum,
    Product,
    Signed,
    Atom,
}

struct Text {
    text: String,
    form: Form,
}

impl Expressions {
    /// The operations of `steps` in their association. What is used twice has a name: that of the plan, such as `s2` or
    /// `c0`, or else `v0`, `v1`, …; no name is one of `taken` or a word of the language.
    pub fn new(steps: &Steps, language: &dyn Language, taken: &[String]) -> Self {
        let mut uses = vec![0_usize; steps.steps.len()];
        for operand in steps.steps.iter().flat_map(Step::operands).chain(steps.outputs.iter().copied()) {
            uses[operand] += 1;
        }
        let mut names = taken.to_vec();
        let mut unnamed = 0;
        let mut lets = Vec::new();
        let mut texts: Vec<Text> = Vec::new();
        for (k, step) in steps.steps.iter().enumerate() {
            let mut text = expression(step, &texts, language);
            let computed = text.form != Form::Atom;
            let name = steps.name(k).filter(|_| computed);
            let signed = matches!(step, Step::Neg(_)) && uses[k] < 3;
            if name.is_some() || (computed && !signed && uses[k] > 1) || text.text.len() > WIDTH {
                let name = match name {
                    Some(name) => language.free(name, &names),
                    None => {
                        unnamed += 1;
                        language.free(&format!("v{}", unnamed - 1), &names)
                    }
                };
                names.push(name.clone());
                lets.push((name.clone(), text.text));
                text = Text { text: name, form: Form::Atom };
            }
            texts.push(text);
        }
        let outputs = steps.outputs.iter().map(|output| texts[*output].text.clone()).collect();
        Self { lets, outputs }
    }
}

fn expression(step: &Step, texts: &[Text], language: &dyn Language) -> Text {
    let within = |k: usize, apart: &[Form]| {
        let Text { text, form } = &texts[k];
        if apart.contains(form) { format!("({text})") } else { text.clone() }
    };
    let (first_of_sum, second_of_sum) = ([].as_slice(), [Form::Sum, Form::Signed].as_slice());
    // A language may give a sign another rank than Rust does: a signed factor stands in parentheses.
    let first_factor = [Form::Sum, Form::Signed].as_slice();
    let second_factor = [Form::Sum, Form::Product, Form::Signed].as_slice();
    let pair = |a: usize, left: &[Form], sign: &str, b: usize, right: &[Form]| {
        format!("{} {sign} {}", within(a, left), within(b, right))
    };
    let (text, form) = match step {
        Step::Input(input) => (language.input(*input), Form::Atom),
        Step::Constant(value) if value.is_negative() => {
            (format!("-{}", language.literal(&value.abs())), Form::Signed)
        }
        Step::Constant(value) => (language.literal(value), Form::Atom),
        Step::Neg(a) => (format!("-{}", within(*a, &[Form::Sum, Form::Product, Form::Signed])), Form::Signed),
        Step::Add(a, b) => (pair(*a, first_of_sum, "+", *b, second_of_sum), Form::Sum),
        Step::Sub(a, b) => (pair(*a, first_of_sum, "-", *b, second_of_sum), Form::Sum),
        Step::Mul(a, b) => (pair(*a, first_factor, "*", *b, second_factor), Form::Product),
        Step::Div(a, b) => (pair(*a, first_factor, "/", *b, second_factor), Form::Product),
    };
    Text { text, form }
}

/// The shortest decimal that a program reads as the `f64` nearest to a number ≥ 0, with a decimal point: `0.25`,
/// `3.0`, `1e-30`.
pub fn decimal(value: &Rational) -> String {
    let text = format!("{:?}", value.to_f64());
    if text.contains(['.', 'e', 'i', 'N']) { text } else { text + ".0" }
}

/// As [`decimal`] for the `f32` nearest to that `f64`.
pub fn decimal_f32(value: &Rational) -> String {
    let text = format!("{:?}", value.to_f64() as f32);
    if text.contains(['.', 'e', 'i', 'N']) { text } else { text + ".0" }
}

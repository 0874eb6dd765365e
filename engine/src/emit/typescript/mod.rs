//! TypeScript as an ES module: classes on numbers and `Float64Array`, strict, without dependencies.
//!
//! Points have any number of components, `dimension`, one after the other in one array. Results go into an array that
//! can be given, so that a loop allocates nothing.

mod class;

use super::write::{comment_line, indented, inside, join_assumption, join_body, join_components};
use super::{Expressions, FamilyCode, JoinCode, Language, Shape, decimal, is_input};
use crate::algebra::rational::Rational;
use crate::diagnostic::Diagnostic;
use crate::steps::Function;
use class::Class;

/// TypeScript, checked strictly.
#[derive(Clone, Copy, Debug)]
pub struct TypeScript;

/// Words of the language, globals that the code uses, and names of the file and of the functions in it.
const RESERVED: &str = "abstract any arguments as async await bigint boolean break case catch class const constructor \
    continue debugger declare default delete do else enum eval export extends false finally for from function get \
    global globalThis if implements import in infer instanceof interface is keyof let module namespace never new null \
    number object of package private protected public readonly require return satisfies set static string super \
    switch symbol this throw true try type typeof undefined unique unknown var void while with yield \
    Array ArrayLike Float64Array Infinity Math NaN Number Object RangeError Error String Touching Rounding checkLength \
    bind curve curveAfter curveBefore partials derivatives1 derivatives2 domain knots points dimension bound values \
    derivatives point at count order orders f c axis row inverse result family \
    coefficients";

/// What every file begins with.
const SUPPORT: &str = r"/** A proved bound of a rounding error, in units of 2 ** -52: of |value| where it is relative; none is proved where it is unknown. */
export interface Rounding {
    readonly kind: 'relative' | 'absolute' | 'unknown';
    readonly epsilons: number;
}

/** The end of a curve of any family where another one touches it. */
export interface Touching {
    readonly dimension: number;
    readonly domain: readonly [number, number];
    evalWithDerivatives(t: number): Float64Array;
}

function checkLength(what: string, found: number, needed: number): void {
    if (found !== needed) {
        throw new RangeError(`${what} has ${found} numbers in place of ${needed}`);
    }
}
";

impl TypeScript {
    fn signed(self, value: &Rational) -> String {
        let sign = if value.is_negative() { "-" } else { "" };
        format!("{sign}{}", self.literal(&value.abs()))
    }

    /// The lines that check a shape value.
    fn check(self, of: &str, shape: &Shape<'_>) -> String {
        let inside = inside(shape, &self, "&&", ("<=", "Number.MAX_VALUE"));
        let text =
            format!("{of}: {} = ${{{}}} is not finite with {}", shape.written, shape.name, shape.shown);
        format!("if (!({inside})) {{\n    throw new RangeError({});\n}}\n", template(&text))
    }

    /// The named values that are the same for all components.
    fn scalar_lets(expressions: &Expressions) -> String {
        let lets = expressions.lets.iter().filter(|(_, value)| !value.of_points);
        lets.map(|(name, value)| format!("const {name} = {};\n", value.text)).collect()
    }

    /// An error with this message where a condition does not hold.
    fn checked(expressions: &Expressions, condition: &str, message: &str) -> String {
        let inner = Self::scalar_lets(expressions)
            + &format!("if (!({condition})) {{\n    throw new RangeError({});\n}}\n", quoted(message));
        format!("{{\n{}}}\n", indented(&inner, "    "))
    }

    /// A loop over the components of points: inputs as names with their values, and where the results go.
    fn on_components(
        expressions: &Expressions,
        inputs: &[(String, String)],
        outputs: &[String],
        is_checked: bool,
    ) -> String {
        let mut lines = String::new();
        for (name, value) in inputs {
            lines += &format!("const {name} = {value};\n");
        }
        for (name, value) in expressions.lets.iter().filter(|(_, value)| value.of_points) {
            lines += &format!("const {name} = {};\n", value.text);
        }
        for (place, value) in outputs.iter().zip(&expressions.outputs) {
            lines += &format!("{place} = {};\n", value.text);
        }
        if is_checked {
            let all: Vec<String> = outputs.iter().map(|place| format!("!Number.isFinite({place})")).collect();
            let condition = all.join(" ||\n    ");
            lines += &format!(
                "if ({condition}) {{\n    throw new RangeError('a computed point is not finite');\n}}\n"
            );
        }
        let head = "for (let axis = 0; axis < dimension; axis++) {\n";
        format!("{}{head}{}}}\n", Self::scalar_lets(expressions), indented(&lines, "    "))
    }
}

/// A text between back quotes in which `${name}` is a value; the text has no other `$`.
fn template(text: &str) -> String {
    let text: String = text.chars().filter(|c| !c.is_control()).collect();
    format!("`{}`", text.replace('\\', "\\\\").replace('`', "\\`"))
}

/// A text as a string.
fn quoted(text: &str) -> String {
    let text: String = text.chars().filter(|c| !c.is_control()).collect();
    format!("'{}'", text.replace('\\', "\\\\").replace('\'', "\\'"))
}

/// The component of the point number `place` of an array.
fn place(array: &str, place: usize) -> String {
    match place {
        0 => format!("{array}[axis]"),
        1 => format!("{array}[dimension + axis]"),
        _ => format!("{array}[{place} * dimension + axis]"),
    }
}

/// The same as a value: the lengths were checked.
fn element(array: &str, at: usize) -> String {
    place(array, at) + "!"
}

/// A function or method with its documentation.
fn function(head: &str, doc: &str, lines: &str) -> String {
    let doc = if doc.is_empty() { String::new() } else { documented(&[doc.to_string()]) };
    format!("{doc}{head} {{\n{}}}\n", indented(lines, "    "))
}

fn documented(lines: &[String]) -> String {
    let lines: Vec<String> = lines.iter().map(|line| comment_line(line).replace("*/", "*\u{2215}")).collect();
    match lines.as_slice() {
        [one] => format!("/** {one} */\n"),
        _ => {
            let lines: String =
                lines.iter().map(|line| format!(" * {line}").trim_end().to_string() + "\n").collect();
            format!("/**\n{lines} */\n")
        }
    }
}

/// An error where an array has another length.
fn length(what: &str, array: &str, needed: &str) -> String {
    format!("checkLength({}, {array}.length, {needed});\n", quoted(what))
}

impl Language for TypeScript {
    fn comment(&self, lines: &[String]) -> String {
        documented(lines)
    }

    fn literal(&self, value: &Rational) -> String {
        decimal(value)
    }

    fn call(&self, function: Function, argument: &str) -> String {
        let name = match function {
            Function::InversePowerOfTwo => {
                return format!("(2 ** Math.min(1022, -Math.floor(Math.log2({argument}))))");
            }
            Function::Sin => "sin",
            Function::Cos => "cos",
            Function::Tan => "tan",
            Function::Tanh => "tanh",
            Function::Expm1 => "expm1",
        };
        format!("Math.{name}({argument})")
    }

    fn unless(&self, [a, b, c]: &[String; 3]) -> String {
        format!("({a} === {b} ? 0.0 : {c})")
    }

    fn less(&self, [a, b]: &[String; 2]) -> String {
        let [one, zero] = [Rational::ONE, Rational::ZERO].map(|x| self.literal(&x));
        format!("({a} < {b} ? {one} : {zero})")
    }

    fn cut_off(&self, name: &str) -> String {
        format!("Math.max(0.0, {name})")
    }

    fn is_single(&self) -> bool {
        false
    }

    fn is_reserved(&self, name: &str) -> bool {
        is_input(name) || RESERVED.split_whitespace().any(|word| word == name)
    }

    fn family(&self, code: &FamilyCode<'_>) -> Result<String, Diagnostic> {
        Ok(Class { code, language: *self }.whole())
    }

    fn join(&self, join: &JoinCode<'_>) -> Result<String, Diagnostic> {
        let mut arguments = vec![String::from("dimension: number")];
        arguments.extend(join.points.iter().map(|net| format!("{}: ArrayLike<number>", net.name)));
        arguments.extend(join.scalars.iter().map(|scalar| format!("{}: number", scalar.name)));
        let mut lines: String = join.scalars.iter().map(|scalar| self.check(&join.name, scalar)).collect();
        for assumption in &join.assumptions {
            let (expressions, condition) = join_assumption(join, assumption, self);
            let message = format!("{}: the scalars do not satisfy {}", join.name, assumption.text);
            lines += &Self::checked(&expressions, &condition, &message);
        }
        for net in &join.points {
            lines += &length(&net.name, &net.name, &format!("{} * dimension", net.labels.len()));
        }
        for net in &join.results {
            lines += &format!("const {} = new Float64Array({} * dimension);\n", net.name, net.labels.len());
        }
        let (inputs, outputs) = join_components(join, element, place);
        lines += &Self::on_components(&join_body(join, self), &inputs, &outputs, true);
        let names: Vec<&str> = join.results.iter().map(|net| net.name.as_str()).collect();
        lines += &format!("return {{ {} }};\n", names.join(", "));
        let types: Vec<String> = names.iter().map(|name| format!("{name}: Float64Array")).collect();
        let results: Vec<String> =
            join.results.iter().map(|net| format!("{} has {}", net.name, net.labels.join(", "))).collect();
        let nets: Vec<String> =
            join.points.iter().map(|net| format!("{} has {}", net.name, net.labels.join(", "))).collect();
        let doc = format!(
            "Points have `dimension` components, one after the other: {}; of the result {}.",
            nets.join("; "),
            results.join("; ")
        );
        let head =
            format!("export function {}({}): {{ {} }}", join.name, arguments.join(", "), types.join("; "));
        Ok(function(&head, &doc, &lines))
    }

    fn file(&self, header: &str, items: &[String]) -> String {
        let mut text = format!("{header}\n{SUPPORT}");
        for item in items {
            text += "\n";
            text += item;
        }
        text
    }
}

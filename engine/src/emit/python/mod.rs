//! Python: classes on numbers and on arrays that follow numpy's protocol, without an import but `math`, for sines of
//! numbers.
//!
//! But for sines and exponentials the code has operators only, so that floats, numpy's arrays of any type of float and
//! JAX's traced arrays take the same path. Points are numbers, arrays, or tuples of numbers; the last are computed
//! component by component.

mod class;

use super::write::{comment_line, indented, inside, join_assumption, join_body};
use super::{FamilyCode, JoinCode, Language, Net, Shape, Value, decimal, is_input};
use crate::algebra::rational::Rational;
use crate::diagnostic::Diagnostic;
use crate::plan::reach::decimal as reach_text;
use crate::steps::Function;
use class::Class;

/// Python 3.9 and later.
#[derive(Clone, Copy, Debug)]
pub struct Python;

/// Keywords, builtins that the code calls, and names of the file and of the functions in it.
const RESERVED: &str = "False None True and as assert async await break case class continue def del elif else except \
    finally for from global if import in is lambda match nonlocal not or pass raise return try type while with yield \
    abs bool float getattr hasattr isinstance len list range str tuple zip TypeError ValueError INFINITY \
    math self points bound order curve derivatives point at f c family values column columns evaluate bind partials \
    curve_after curve_before DOMAIN KNOTS FUNCTIONS ROUNDING ROUNDING_POINT";

/// What every file begins with.
const SUPPORT: &str = r#"INFINITY = float("inf")


def _check(message, value, inside):
    """Raises ValueError unless `inside` is true, or true of all elements of an array."""
    inside = inside.all() if hasattr(inside, "all") else inside
    try:
        known = bool(inside)
    except TypeError:  # a value that JAX traces is not known yet
        return
    if not known:
        raise ValueError(f"{message}; got {value!r}")


def _finite(points):
    """The points, which must be finite."""
    for point in points:
        for number in point if isinstance(point, (list, tuple)) else (point,):
            _check("a computed point must be finite", point, abs(number) < INFINITY)
    return points


def _combine(function, points):
    """What a function of numbers or arrays makes of points; of tuples each component by itself."""
    if not isinstance(points[0], (list, tuple)):
        return function(*points)
    if any(len(point) != len(points[0]) for point in points):
        raise ValueError("the points have different numbers of components")
    return tuple(zip(*(function(*column) for column in zip(*points))))


def _evaluate(function, bound, *at):
    """The results of a function of bound coefficients at a point of the domain."""
    if isinstance(bound[0], (list, tuple)):
        return tuple(zip(*(function(*column, *at) for column in zip(*bound))))
    most = max(getattr(x, "ndim", 0) for x in at)
    if getattr(bound[0], "ndim", 0) == 1 and most:  # components first: few long loops in place of many short ones
        bound = [b.reshape(b.shape + (1,) * most) for b in bound]
        return tuple(value.transpose((*range(1, most + 1), 0)) for value in function(*bound, *at))
    if getattr(bound[0], "ndim", 0):  # one axis more, for the components of the points
        at = tuple(x[..., None] if getattr(x, "ndim", 0) else x for x in at)
    return function(*bound, *at)


def _end(curve, last, order, f, c, points, count):
    """The derivatives that the end of a curve Q has where it touches `curve`, and the points of Q."""
    if len(points) != count:
        raise ValueError(f"{count} control points are needed; got {len(points)}")
    _check("f must be positive and finite", f, (f > 0.0) & (f < INFINITY))
    _check("c must be finite", c, (c > -INFINITY) & (c < INFINITY))
    t = curve.family.DOMAIN[1 if last else 0]
    derivatives = list(curve.eval_with_derivatives(t)[: order + 1])
    inverse = 1.0 / f

    def moved(d0, *rest):
        d = [d0, *rest]
        if order > 0:
            d[1] = d[1] * inverse
        if order > 1:
            d[2] = (d[2] - d[1] * c) * (inverse * inverse)
        return d

    # A determined point may be anything, even nothing.
    points = [derivatives[0] if point is None else point for point in points]
    return list(_combine(moved, derivatives)), points
"#;

/// What a file with angles or exponentials has beside that.
const CALL: &str = r#"

def _call(name, x):
    """A function such as sin, expm1 or frexp of a number, and of an array as its own library has it."""
    if hasattr(x, "__array_namespace__"):
        return getattr(x.__array_namespace__(), name)(x)
    if type(x).__module__ == "numpy":  # before numpy 2
        import numpy

        return getattr(numpy, name)(x)
    try:
        return getattr(math, name)(x)
    except OverflowError:
        return INFINITY
"#;

/// What a file with a family in two coordinates of any size has beside that.
const INVERSE_POWER_OF_TWO: &str = r#"

def _inverse_power_of_two(x):
    """The power of two by which a positive number becomes one from 1 to 2."""
    part = _call("frexp", x)[0]
    return (part + part) / x
"#;

/// What a file with a family whose shape values overflow earlier in `float32` has beside that.
const IS_SINGLE: &str = r#"

def _is_single(x):
    """Whether a shape value is of the type float32; a float of Python becomes that later, beside such arrays."""
    return str(getattr(x, "dtype", "")).endswith("float32")
"#;

/// What a file with a family on several spans has beside that.
const ON_SPANS: &str = r#"

def _on_spans(t, knots, functions):
    """The results of the function of the span in which t lies, at a knot of the later one."""
    try:
        later = sum(bool(t >= knot) for knot in knots)
    except (TypeError, ValueError):  # an array, or a value that JAX traces
        pass
    else:
        return functions[later](t)
    sums = None
    for k, function in enumerate(functions):
        inside = t < knots[0] if k == 0 else t >= knots[k - 1]
        if 0 < k < len(knots):
            inside = inside & (t < knots[k])
        # Elsewhere at a knot of the span, so that nothing overflows.
        values = function(t * inside + (t * 0.0 + knots[max(k - 1, 0)]) * (inside ^ True))
        values = [value * inside for value in values]
        sums = values if sums is None else [a + b for a, b in zip(sums, values)]
    return tuple(sums)
"#;

impl Python {
    fn signed(self, value: &Rational) -> String {
        let sign = if value.is_negative() { "-" } else { "" };
        format!("{sign}{}", self.literal(&value.abs()))
    }

    /// The line that checks a shape value.
    fn check(self, of: &str, shape: &Shape<'_>) -> String {
        let mut inside = inside(shape, &self, "&", ("<", "INFINITY"));
        let mut message = format!("{of}: `{}` must be finite, with {}", shape.written, shape.shown);
        for ((single, sign), words) in shape.single.iter().zip([">=", "<="]).zip(["at least", "at most"]) {
            let Some(single) = single else { continue };
            let name = &shape.name;
            inside += &format!(" & (({name} {sign} {}) | (not _is_single({name})))", self.signed(single));
            message += &format!(", and {words} {} in float32", reach_text(single));
        }
        let message = quoted(&message);
        format!("_check({message}, {}, {inside})\n", shape.name)
    }

    /// Named values.
    fn lets(lets: &[(String, Value)]) -> String {
        lets.iter().map(|(name, value)| format!("{name} = {}\n", value.text)).collect()
    }
}

/// A text as a string of Python.
fn quoted(text: &str) -> String {
    let text: String = text.chars().filter(|c| !c.is_control()).collect();
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

/// A text that can stand in a docstring.
fn docstring(text: &str) -> String {
    format!("\"\"\"{}\"\"\"\n", comment_line(text).replace('\\', "\\\\").replace("\"\"\"", "'''"))
}

/// A tuple of expressions, with a line for each where it is long.
fn tuple(values: &[String]) -> String {
    let line = match values {
        [one] => format!("({one},)"),
        _ => format!("({})", values.join(", ")),
    };
    if line.len() <= 80 {
        return line;
    }
    let lines: String = values.iter().map(|value| format!("    {value},\n")).collect();
    format!("(\n{lines})")
}

fn function(head: &str, doc: &str, lines: &str) -> String {
    let doc = if doc.is_empty() { String::new() } else { docstring(doc) };
    format!("def {head}:\n{}", indented(&(doc + lines), "    "))
}

/// 1 where a comparison holds, else 0: of the type of what is compared, whatever it is multiplied with.
fn comparison(a: &str, sign: &str, b: &str) -> String {
    format!("(({a} {sign} {b}) * ({a} * 0.0 + 1.0))")
}

impl Language for Python {
    fn comment(&self, lines: &[String]) -> String {
        lines.iter().map(|line| format!("# {}", comment_line(line)).trim_end().to_string() + "\n").collect()
    }

    fn literal(&self, value: &Rational) -> String {
        decimal(value)
    }

    fn call(&self, function: Function, argument: &str) -> String {
        let name = match function {
            Function::InversePowerOfTwo => return format!("_inverse_power_of_two({argument})"),
            Function::Sin => "sin",
            Function::Cos => "cos",
            Function::Tan => "tan",
            Function::Tanh => "tanh",
            Function::Expm1 => "expm1",
        };
        format!("_call(\"{name}\", {argument})")
    }

    fn unless(&self, [a, b, c]: &[String; 3]) -> String {
        format!("({c} * {})", comparison(a, "!=", b))
    }

    fn less(&self, [a, b]: &[String; 2]) -> String {
        comparison(a, "<", b)
    }

    fn cut_off(&self, name: &str) -> String {
        // At 0 with the derivative of what is cut off.
        format!("({name} * ({name} >= 0.0))")
    }

    fn is_single(&self) -> bool {
        false
    }

    fn is_reserved(&self, name: &str) -> bool {
        name.starts_with('_') || is_input(name) || RESERVED.split_whitespace().any(|word| word == name)
    }

    fn family(&self, code: &FamilyCode<'_>) -> Result<String, Diagnostic> {
        Ok(Class { code, language: *self }.whole())
    }

    fn join(&self, join: &JoinCode<'_>) -> Result<String, Diagnostic> {
        let mut arguments: Vec<String> = join.points.iter().map(|net| net.name.clone()).collect();
        arguments.extend(join.scalars.iter().map(|scalar| format!("{}: float", scalar.name)));
        let mut lines: String = join.scalars.iter().map(|scalar| self.check(&join.name, scalar)).collect();
        for assumption in &join.assumptions {
            let (expressions, condition) = join_assumption(join, assumption, self);
            let names: Vec<String> = join.scalars.iter().map(|scalar| scalar.name.clone()).collect();
            let message = quoted(&format!("{}: the scalars have to satisfy {}", join.name, assumption.text));
            lines += &Self::lets(&expressions.lets);
            lines += &format!("_check({message}, {}, {condition})\n", tuple(&names));
        }
        for net in join.points.iter().filter(|net| !net.single) {
            let (name, count) = (&net.name, net.labels.len());
            let message = quoted(&format!("{}: {count} control points `{name}` are needed", join.name));
            lines += &format!("_check({message}, len({name}), len({name}) == {count})\n");
        }
        let expressions = join_body(join, self);
        let inputs: Vec<String> = (0..join.given.len()).map(|k| format!("P{k}")).collect();
        let outputs: Vec<String> = expressions.outputs.iter().map(|value| value.text.clone()).collect();
        let inner = Self::lets(&expressions.lets) + &format!("return {}\n", tuple(&outputs));
        lines += &format!("\n{}\n", function(&format!("points({})", inputs.join(", ")), "", &inner));
        let given: Vec<String> = join
            .given
            .iter()
            .map(|(net, place)| {
                let Net { name, single, .. } = &join.points[*net];
                if *single { name.clone() } else { format!("{name}[{place}]") }
            })
            .collect();
        lines += &format!("computed = _finite(_combine(points, {}))\n", tuple(&given));
        let mut start = 0;
        let mut parts = Vec::new();
        for net in &join.results {
            parts.push(format!("computed[{start}:{}]", start + net.labels.len()));
            start += net.labels.len();
        }
        lines += &match parts.as_slice() {
            [_] => String::from("return computed\n"),
            _ => format!("return {}\n", parts.join(", ")),
        };
        let results: Vec<String> = join.results.iter().map(|net| net.labels.join(", ")).collect();
        let doc = format!("The control points {}.", results.join("; "));
        Ok(function(&format!("{}({})", join.name, arguments.join(", ")), &doc, &lines))
    }

    fn file(&self, header: &str, items: &[String]) -> String {
        let all = items.concat();
        let calls = all.contains("_call(") || all.contains("_inverse_power_of_two(");
        let import = if calls { "import math\n\n" } else { "" };
        let mut text =
            format!("{header}#\n# `float` stands for a number or an array of numbers.\n\n{import}{SUPPORT}");
        text += if calls { CALL } else { "" };
        text += if all.contains("_inverse_power_of_two(") { INVERSE_POWER_OF_TWO } else { "" };
        text += if all.contains("_is_single(") { IS_SINGLE } else { "" };
        text += if all.contains("_on_spans(") { ON_SPANS } else { "" };
        for item in items {
            text += "\n\n";
            text += item;
        }
        text
    }
}

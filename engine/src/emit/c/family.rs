//! The functions of a family in C.

use crate::algebra::rational::Rational;
use crate::emit::write::{
    body, bound, bound_text, comment_line, condition, coordinate, derivative, indented, knot_text, member,
    on_spans, point, slashes, used, used_shapes,
};
use crate::emit::{FamilyCode, Knot, Language};
use crate::plan::Input;
use crate::steps::{EndSteps, FamilySteps, Steps};

use super::{C, Check, element, function};

/// A family that is being written.
pub(super) struct Family<'a> {
    pub(super) code: &'a FamilyCode<'a>,
    pub(super) language: C,
}

impl Family<'_> {
    pub(super) fn whole(&self) -> String {
        let code = self.code;
        let mut parts = vec![self.constants(), self.values()];
        parts.splice(1..1, self.init());
        if code.is_curve() {
            parts.extend(self.derivatives());
            parts.push(self.bind());
            parts.extend(self.curve());
            parts.extend(self.continuations());
        } else {
            for orders in code.orders() {
                let of = code.along(&orders);
                let name = member(&code.name, &format!("partials_{of}"));
                let about =
                    format!("The partial derivatives along {} of {}.", of.replace('_', ", "), code.listed());
                parts.push(self.functions(&name, "derivatives", &about, &|steps| steps.derivatives(&orders)));
            }
            parts.push(self.bind());
            parts.extend(self.patch());
        }
        parts.join("\n")
    }

    fn member(&self, name: &str) -> String {
        member(&self.code.name, name)
    }

    /// The argument with the shape values, if there are any.
    fn arguments(&self, others: &[String]) -> Vec<String> {
        let shapes = (!self.code.shapes.is_empty()).then(|| format!("{} family", self.code.name));
        shapes.into_iter().chain(others.iter().cloned()).collect()
    }

    /// The coordinates as arguments.
    fn coordinates(&self) -> Vec<String> {
        self.code.coordinates.iter().map(|name| format!("{} {name}", self.language.scalar())).collect()
    }

    /// The shape values that steps use as constants, and a mention of the family where they use none.
    fn inputs(&self, steps: &Steps) -> String {
        if self.code.shapes.is_empty() {
            return String::new();
        }
        let used = used_shapes(steps);
        if used.is_empty() { String::from("(void)family;\n") } else { self.named_shapes(&used) }
    }

    fn named_shapes(&self, used: &[usize]) -> String {
        let t = self.language.scalar();
        let names = used.iter().map(|k| self.code.input(Input::Shape(*k)));
        names.map(|name| format!("const {t} {name} = family.{name};\n")).collect()
    }

    /// Lines for each span.
    fn on_spans(&self, lines: &dyn Fn(&FamilySteps<'_>) -> String) -> String {
        on_spans(self.code, &self.language, "family.", lines)
    }

    /// Whether points need the shape values.
    fn points_need_shapes(&self) -> bool {
        self.code.steps.is_quotient() && !self.code.shapes.is_empty()
    }

    fn unused_coordinates(&self, steps: &Steps) -> String {
        let used = used(steps, coordinate);
        let unused = self.code.coordinates.iter().enumerate().filter(|(k, _)| !used.contains(k));
        unused.map(|(_, name)| format!("(void){name};\n")).collect()
    }

    fn constants(&self) -> String {
        let code = self.code;
        let define = |name: &str, value: String| format!("#define {} {value}\n", self.member(name));
        let mut text = String::new();
        text += &define("FUNCTIONS", code.count().to_string());
        text += &define("COEFFICIENTS", code.steps.bound().to_string());
        for (name, (low, high)) in code.named_ends() {
            let own = if code.is_curve() { String::new() } else { format!("_{name}") };
            text += &define(&format!("LOW{own}"), format!("({})", self.language.signed(&low)));
            text += &define(&format!("HIGH{own}"), format!("({})", self.language.signed(&high)));
        }
        let all = code.knots();
        if code.steps.spans() > 1 && all.iter().all(|knot| matches!(knot, Knot::Number(_))) {
            let all: Vec<String> = all.iter().map(|knot| knot_text(code, knot, &self.language)).collect();
            let all: Vec<&str> = all.iter().map(String::as_str).collect();
            text += &wrapped_define(&self.member("KNOTS"), &all);
        }
        let epsilon = format!("{}_EPSILON", self.language.limits());
        text += "// Rounding errors of the values in units of ";
        text += &format!("{epsilon}: of |value| where ROUNDING_RELATIVE is 1, else absolute.\n");
        text += "// They hold for fused operations too, as long as nothing overflows; a product that underflows is off by\n";
        text += "// half the smallest number, which a division after it may enlarge.\n";
        if code.assumes_functions() {
            text += "// They assume that sin, cos, tan and expm1 are within one unit in the last place, tanh within two.\n";
        }
        if let Some(assumed) = code.assumed_of_ends() {
            text += &format!("// {assumed}\n");
        }
        let bounds = code.rounding.iter().map(|error| bound_text(error.as_ref()));
        let bounds: Vec<(bool, String)> =
            bounds.map(|b| b.unwrap_or((false, String::from("INFINITY")))).collect();
        let values: Vec<&str> = bounds.iter().map(|(_, text)| text.as_str()).collect();
        let relative: Vec<&str> =
            bounds.iter().map(|(relative, _)| if *relative { "1" } else { "0" }).collect();
        if !values.is_empty() {
            text += &wrapped_define(&self.member("ROUNDING"), &values);
            text += &wrapped_define(&self.member("ROUNDING_RELATIVE"), &relative);
        }
        if let Some((_, bound)) = bound_text(code.point_rounding.as_ref()) {
            text +=
                "// The same of a component of a point, times the largest |component| of a control point.\n";
            text += &define("ROUNDING_POINT", bound);
        }
        text
    }

    /// The struct with the shape values, and what fills and checks it.
    fn init(&self) -> Vec<String> {
        let (code, t) = (self.code, self.language.scalar());
        if code.shapes.is_empty() {
            return Vec::new();
        }
        let mut fields = String::new();
        for shape in &code.shapes {
            let doc = if shape.doc.is_empty() { String::new() } else { format!(": {}", shape.doc.join(" ")) };
            fields += &format!("{t} {}; // {}\n", shape.name, comment_line(&format!("{}{doc}", shape.shown)));
        }
        for name in &code.derived {
            fields += &format!("{t} {name}; // computed from these\n");
        }
        let definition = format!("typedef struct {0} {{\n{1}}} {0};\n", code.name, indented(&fields, "    "));
        let mut lines = String::from("int wrong = 0;\n");
        let mut messages = Vec::new();
        for (k, shape) in code.shapes.iter().enumerate() {
            let start = if k == 0 { "if" } else { "else if" };
            lines += &format!("{start} (!({})) wrong = {};\n", self.language.finite(shape), k + 1);
            messages.push(shape.condition.clone());
        }
        for (k, assumption) in code.assumptions.iter().enumerate() {
            let expressions = body(code, &assumption.steps, &self.language);
            // Values on the way are written out: a condition is short.
            let mut inner = self.language.scalar_lets(&expressions);
            let condition = condition(assumption, &expressions, &self.language);
            let number = code.shapes.len() + k + 1;
            inner += &format!("if (wrong == 0 && !({condition})) wrong = {number};\n");
            lines += &format!("{{\n{}}}\n", indented(&inner, "    "));
            messages.push(assumption.text.to_string());
        }
        for shape in &code.shapes {
            lines += &format!("family->{0} = wrong ? ({t})NAN : {0};\n", shape.name);
        }
        if let Some(derived) = code.steps.derived() {
            // They count in every value, and to a high power.
            let double = C(super::Scalar::F64);
            let expressions = body(code, &derived.steps, &double);
            let mut inner = double.scalar_lets(&expressions);
            for (name, value) in code.derived.iter().zip(&expressions.outputs) {
                let text = &value.text;
                let value = if self.language.is_single() { format!("(float)({text})") } else { text.clone() };
                inner += &format!("family->{name} = wrong ? ({t})NAN : {value};\n");
            }
            lines += &format!("{{\n{}}}\n", indented(&inner, "    "));
        }
        lines += "return wrong;\n";
        let mut arguments = vec![format!("{} *family", code.name)];
        arguments.extend(code.shapes.iter().map(|shape| format!("{t} {}", shape.name)));
        let about = [
            String::from(
                "Sets the shape values. Returns 0, or k when the k-th of these conditions is not met:",
            ),
            format!("{}.", messages.join("; ")),
            String::from(
                "Infinite values and NaN meet none. Then all shape values become NaN, and so does what is computed.",
            ),
        ];
        let mut parts = vec![
            definition,
            slashes(&about) + &function(&format!("int {}", self.member("init")), &arguments, &lines),
        ];
        if let Some(ends) = code.moving_ends() {
            let mut lines = String::new();
            for (k, end) in ends.iter().enumerate() {
                let value = knot_text(code, end, &self.language);
                let of = if matches!(end, Knot::Shape(_)) { "family." } else { "" };
                lines += &format!("ends[{k}] = {of}{value};\n");
            }
            let arguments = [format!("{} family", code.name), format!("{t} *ends")];
            let about = [String::from("The two ends of the domain.")];
            parts.push(
                slashes(&about) + &function(&format!("void {}", self.member("domain")), &arguments, &lines),
            );
        }
        parts
    }

    /// A function that computes a number for each function of the family.
    fn functions(
        &self,
        name: &str,
        array: &str,
        about: &str,
        of: &dyn Fn(&FamilySteps<'_>) -> Steps,
    ) -> String {
        let lines = self.on_spans(&|on_span| {
            let steps = of(on_span);
            let expressions = body(self.code, &steps, &self.language);
            let mut lines = self.inputs(&steps) + &self.unused_coordinates(&steps);
            lines += &self.language.scalar_lets(&expressions);
            for (k, value) in expressions.outputs.iter().enumerate() {
                lines += &format!("{array}[{k}] = {};\n", value.text);
            }
            lines
        });
        let mut others = self.coordinates();
        others.push(format!("{} {array}[{}]", self.language.scalar(), self.code.count()));
        slashes(&[about.to_string()]) + &function(&format!("void {name}"), &self.arguments(&others), &lines)
    }

    fn values(&self) -> String {
        let about = format!("The values of {}.", self.code.listed());
        self.functions(&self.member("values"), "values", &about, &|steps| steps.values())
    }

    fn derivatives(&self) -> Vec<String> {
        let of = self.code.listed();
        let t = &self.code.coordinates[0];
        let one = |name: &str, word: &str, order: usize| {
            let about = format!("The {word} derivatives of {of} by {t}.");
            self.functions(&self.member(name), "derivatives", &about, &|steps| steps.derivatives(&[order]))
        };
        vec![one("derivatives", "first", 1), one("second_derivatives", "second", 2)]
    }

    /// Named components of the elements of an array.
    fn elements(array: &str, prefix: &str, used: &[usize]) -> Vec<(String, String)> {
        used.iter().map(|k| (format!("{prefix}{k}"), element(array, *k))).collect()
    }

    fn bind(&self) -> String {
        let (code, t) = (self.code, self.language.scalar());
        let steps = code.steps.bind();
        let expressions = body(code, &steps, &self.language);
        let inputs = Self::elements("points", "P", &used(&steps, point));
        let outputs: Vec<String> = (0..code.steps.bound()).map(|k| element("bound", k)).collect();
        let lines = self.inputs(&steps)
            + &self.language.on_components(&expressions, &inputs, &outputs, Check::Nothing);
        let others = [String::from("size_t dimension"), format!("const {t} *points"), format!("{t} *bound")];
        let about = [
            format!(
                "Binds {} control points of `dimension` components each, one after the other: `bound` becomes",
                code.count()
            ),
            format!(
                "{} coefficients of as many components, from which points are computed.",
                code.steps.bound()
            ),
        ];
        slashes(&about)
            + &function(&format!("void {}", self.member("bind")), &self.arguments(&others), &lines)
    }

    /// A function from bound coefficients to points.
    fn evaluator(
        &self,
        name: &str,
        about: &[String],
        of: &dyn Fn(&FamilySteps<'_>) -> Option<Steps>,
        result: &str,
    ) -> Option<String> {
        of(&self.code.steps)?;
        let t = self.language.scalar();
        let lines = self.on_spans(&|on_span| {
            let Some(steps) = of(on_span) else { return String::new() };
            let expressions = body(self.code, &steps, &self.language);
            let inputs = Self::elements("bound", "B", &used(&steps, bound));
            let outputs: Vec<String> = (0..expressions.outputs.len()).map(|k| element(result, k)).collect();
            let mut lines = if self.points_need_shapes() { self.inputs(&steps) } else { String::new() };
            lines += &self.unused_coordinates(&steps);
            if inputs.is_empty() {
                lines += "(void)bound;\n";
            }
            lines + &self.language.on_components(&expressions, &inputs, &outputs, Check::Nothing)
        });
        let mut others = vec![String::from("size_t dimension"), format!("const {t} *bound")];
        if self.points_need_shapes() {
            others.insert(0, format!("{} family", self.code.name));
        }
        others.extend(self.coordinates());
        others.push(format!("{t} *{result}"));
        Some(slashes(about) + &function(&format!("void {}", self.member(name)), &others, &lines))
    }

    /// The loop over points of the domain.
    fn slices(&self) -> String {
        let t = self.language.scalar();
        let count = self.code.coordinates.len();
        let at: Vec<String> = (0..count)
            .map(|k| match (count, k) {
                (1, _) => String::from("at[row]"),
                (_, 0) => format!("at[{count} * row]"),
                _ => format!("at[{count} * row + {k}]"),
            })
            .collect();
        let lines = format!(
            "for (size_t row = 0; row < count; row++) {{\n    {}({}dimension, bound, {}, points + row * dimension);\n}}\n",
            self.member("eval"),
            if self.points_need_shapes() { "family, " } else { "" },
            at.join(", ")
        );
        let mut others = vec![
            String::from("size_t dimension"),
            format!("const {t} *bound"),
            String::from("size_t count"),
            format!("const {t} *at"),
            format!("{t} *points"),
        ];
        if self.points_need_shapes() {
            others.insert(0, format!("{} family", self.code.name));
        }
        let about = if count == 1 {
            String::from("The points at `count` parameters `at`, one after the other.")
        } else {
            let names = self.code.coordinates.join(", ");
            format!(
                "The points at `count` points `at` of the domain, each given by {names}, one after the other."
            )
        };
        slashes(&[about]) + &function(&format!("void {}", self.member("eval_n")), &others, &lines)
    }

    fn curve(&self) -> Vec<String> {
        let t = &self.code.coordinates[0];
        let mut parts = Vec::new();
        let about = [format!("The point of the curve at {t}.")];
        parts.extend(self.evaluator("eval", &about, &|steps| steps.curve(1), "point"));
        let about = [format!(
            "The point of the curve at {t}, and the first and second derivatives by {t}, 3 * dimension numbers."
        )];
        parts.extend(self.evaluator("eval_with_derivatives", &about, &|steps| steps.curve(3), "derivatives"));
        parts.push(self.slices());
        parts
    }

    fn patch(&self) -> Vec<String> {
        let none = vec![0; self.code.family.domain.len()];
        let mut parts = Vec::new();
        for orders in std::iter::once(none).chain(self.code.orders()) {
            let of = self.code.along(&orders);
            let (name, about) = if of.is_empty() {
                (String::from("eval"), String::from("The point of the patch."))
            } else {
                let about = format!("The partial derivative of the patch along {}.", of.replace('_', ", "));
                (format!("eval_partial_{of}"), about)
            };
            parts.extend(self.evaluator(&name, &[about], &|steps| steps.patch(&orders), "point"));
        }
        parts.push(self.slices());
        parts
    }

    /// `curve_after` and `curve_before`.
    fn continuations(&self) -> Vec<String> {
        let both = [("curve_after", true), ("curve_before", false)];
        both.iter().filter_map(|(name, at_start)| self.continuation(name, *at_start)).collect()
    }

    fn continuation(&self, name: &str, at_start: bool) -> Option<String> {
        let all = self.code.steps.ends(2, at_start);
        if all.is_empty() {
            return None;
        }
        let t = self.language.scalar();
        let [zero, one] = [Rational::ZERO, Rational::ONE].map(|value| self.language.literal(&value));
        let largest = format!("{}_MAX", self.language.limits());
        let mut cases = String::new();
        for end in &all {
            cases += &format!(
                "case {}: {{\n{}    break;\n}}\n",
                end.positions.len() - 1,
                indented(&self.end(end), "    ")
            );
        }
        let mut lines = String::from("int result = 0;\n");
        if cases.contains("inverse") {
            lines += &format!("const {t} inverse = {one} / f;\n");
        }
        let used: Vec<usize> = all.iter().flat_map(|end| used_shapes(&end.steps)).collect();
        if !self.code.shapes.is_empty() {
            for (k, shape) in self.code.shapes.iter().enumerate().filter(|(k, _)| used.contains(k)) {
                let _ = k;
                lines += &format!("const {t} {0} = family.{0};\n", shape.name);
            }
            if used.is_empty() {
                lines += "(void)family;\n";
            }
        }
        lines += &format!("if (!(f > {zero} && f <= {largest})) return 2;\n");
        lines += &format!("if (!(c >= -{largest} && c <= {largest})) return 3;\n");
        if !self.code.shapes.is_empty() {
            let name = &self.code.shapes[0].name;
            lines +=
                &format!("if (!(family.{name} >= -{largest} && family.{name} <= {largest})) return 4;\n");
        }
        lines += &format!("switch (order) {{\n{cases}default:\n    return 1;\n}}\nreturn result;\n");
        let others = [
            String::from("int order"),
            format!("{t} f"),
            format!("{t} c"),
            String::from("size_t dimension"),
            format!("const {t} *derivatives"),
            format!("{t} *points"),
        ];
        let (which, ends) =
            if at_start { ("first", "ends; Q starts there") } else { ("last", "starts; Q ends there") };
        let mut about = vec![
            format!(
                "The control points of a curve Q that continues a curve P of any family where that {ends}."
            ),
            format!(
                "`derivatives` are the point of P there and its derivatives up to `order`, 0, 1 or 2; the {which} order + 1"
            ),
            String::from(
                "of `points` are computed, the others are given. Q' = P'/f and Q'' = (P'' - c Q')/f^2: f = 1 and c = 0 for",
            ),
            String::from(
                "parametric contact, any f > 0 and c for geometric contact. Returns 0; 1 for an order that there is not; 2 when",
            ),
            String::from(
                "f is not positive and finite; 3 when c is not finite; 4 when the shape values were refused; 5 where the derivatives",
            ),
            String::from("do not determine the points; -1 when a computed point is not finite."),
        ];
        let mut zeros: Vec<&str> = Vec::new();
        for zero in all.iter().flat_map(|end| &end.undetermined) {
            if !zeros.contains(&zero.as_str()) {
                zeros.push(zero);
            }
        }
        if !zeros.is_empty() {
            about.push(format!("They do not at {}.", zeros.join(", ")));
        }
        let head = format!("int {}", self.member(name));
        Some(slashes(&about) + &function(&head, &self.arguments(&others), &lines))
    }

    /// One order of contact.
    fn end(&self, end: &EndSteps) -> String {
        let t = self.language.scalar();
        let expressions = body(self.code, &end.steps, &self.language);
        let zero = self.language.literal(&Rational::ZERO);
        let divisors = &expressions.outputs[end.positions.len()..];
        let derivatives = used(&end.steps, derivative);
        let mut inputs = Vec::new();
        let highest = derivatives.iter().max().copied().unwrap_or(0);
        for k in 0..=highest {
            let value = element("derivatives", k);
            let value = match k {
                0 => value,
                1 => format!("{value} * inverse"),
                _ => format!("({value} - D1 * c) * (inverse * inverse)"),
            };
            if k == 1 || derivatives.contains(&k) {
                inputs.push((format!("D{k}"), value));
            }
        }
        // D1 is needed by D2 only, or not at all.
        if highest == 1 && !derivatives.contains(&1) {
            inputs.retain(|(name, _)| name != "D1");
        }
        inputs.extend(Self::elements("points", "P", &used(&end.steps, point)));
        let outputs: Vec<String> = end.positions.iter().map(|k| element("points", *k)).collect();
        let mut lines = String::new();
        let loops = self.language.on_components(&expressions, &inputs, &outputs, Check::Finite);
        let (lets, rest) = loops.split_at(self.language.scalar_lets(&expressions).len());
        lines += lets;
        for divisor in divisors {
            lines += &format!("if ({} == {zero}) return 5;\n", divisor.text);
        }
        let _ = t;
        lines + rest
    }
}

/// A macro with a list, on several lines where it is long.
fn wrapped_define(name: &str, values: &[&str]) -> String {
    let lines: Vec<String> = values.chunks(12).map(|line| line.join(", ")).collect();
    if lines.len() == 1 {
        return format!("#define {name} {{{}}}\n", lines[0]);
    }
    format!("#define {name} {{ \\\n    {} \\\n}}\n", lines.join(", \\\n    "))
}

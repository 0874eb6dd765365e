//! The functions of a family in a shader.

use crate::algebra::rational::Rational;
use crate::emit::write::{
    body, bound_text, condition, inner_knots, knot_text, member, on_spans, slashes, used_shapes,
};
use crate::emit::{FamilyCode, Knot, Language};
use crate::rounding::needs_functions;
use crate::steps::{EndSteps, FamilySteps, Steps};

use super::{HELPERS, SERIES, Shader, helper};

/// A family that is being written.
pub(super) struct Functions<'a> {
    pub(super) code: &'a FamilyCode<'a>,
    pub(super) language: Shader,
}

impl Functions<'_> {
    fn member(&self, name: &str) -> String {
        member(&self.code.name, name)
    }

    pub(super) fn whole(&self) -> String {
        let (code, language) = (self.code, self.language);
        let mut parts = vec![self.constants()];
        if !code.shapes.is_empty() {
            let assumptions: Vec<(String, String)> = code
                .assumptions
                .iter()
                .map(|assumption| {
                    let expressions = body(code, &assumption.steps, &language);
                    (language.lets(&expressions), condition(assumption, &expressions, &language))
                })
                .collect();
            let texts: Vec<&str> = code.assumptions.iter().map(|assumption| assumption.text).collect();
            parts.push(language.check(&code.name, &code.shapes, &assumptions, &texts));
        }
        parts.extend(self.derive());
        parts.extend(self.domain());
        let about = format!("The values of {}.", code.listed());
        parts.push(self.numbers("values", &about, &|steps| steps.values()));
        if code.is_curve() {
            let t = &code.coordinates[0];
            for (name, word, order) in [("derivatives", "first", 1), ("second_derivatives", "second", 2)] {
                let about = format!("The {word} derivatives of {} by {t}.", code.listed());
                parts.push(self.numbers(name, &about, &|steps| steps.derivatives(&[order])));
            }
        } else {
            for orders in code.orders() {
                let of = code.along(&orders);
                let about =
                    format!("The partial derivatives along {} of {}.", of.replace('_', ", "), code.listed());
                parts.push(
                    self.numbers(&format!("partials_{of}"), &about, &|steps| steps.derivatives(&orders)),
                );
            }
        }
        parts.push(self.bind());
        if code.is_curve() {
            let t = &code.coordinates[0];
            let about = format!("The point of the curve at {t}.");
            parts.extend(self.evaluator("eval", &about, &|steps| steps.curve(1)));
            let about = format!("The point of the curve at {t} and its first and second derivative by {t}.");
            parts.extend(self.evaluator("eval_with_derivatives", &about, &|steps| steps.curve(3)));
            for (name, at_start) in [("after", true), ("before", false)] {
                for end in code.steps.ends(2, at_start) {
                    parts.push(self.continuation(name, at_start, &end));
                }
            }
        } else {
            let zeros = vec![0; code.family.domain.len()];
            for orders in std::iter::once(zeros).chain(code.orders()) {
                let of = code.along(&orders);
                let (name, about) = if of.is_empty() {
                    (String::from("eval"), String::from("The point of the patch."))
                } else {
                    (
                        format!("eval_partial_{of}"),
                        format!("The partial derivative of the patch along {}.", of.replace('_', ", ")),
                    )
                };
                parts.extend(self.evaluator(&name, &about, &|steps| steps.patch(&orders)));
            }
        }
        if language == Shader::Wgsl {
            parts.push(self.kernel());
        }
        let text = parts.join("\n");
        // Each family has functions of its own, so that several files can be put into one shader.
        let text = language.helpers(&text) + &text;
        SERIES.iter().fold(text, |text, (function, _)| {
            let name = helper(*function).0;
            let own = self.member(name.trim_start_matches(HELPERS));
            text.replace(&format!("{name}("), &format!("{own}("))
        })
    }

    /// The compute shader over points of the domain.
    fn kernel(&self) -> String {
        let count = self.code.coordinates.len();
        let of = if count == 1 { "f32" } else { "vec4f" };
        let at: Vec<String> = match count {
            1 => vec![format!("{}[id.x]", self.member("at"))],
            _ => ["x", "y", "z", "w"][..count]
                .iter()
                .map(|c| format!("{}[id.x].{c}", self.member("at")))
                .collect(),
        };
        let [bound, at_name, points, eval, kernel] =
            ["bound", "at", "points", "eval", "eval_n"].map(|n| self.member(n));
        let shapes = if self.points_need_shapes() {
            let (name, count) = (self.member("shape"), self.code.shapes.len());
            let all: String = (0..count).map(|k| format!("{name}[{k}], ")).collect();
            (format!("@group(0) @binding(3) var<storage, read> {name}: array<f32, {count}>;\n"), all)
        } else {
            (String::new(), String::new())
        };
        let about = if count == 1 {
            String::from("A compute shader for the points at many parameters.")
        } else {
            format!(
                "A compute shader for many points of the domain, each given by {}.",
                self.code.coordinates.join(", ")
            )
        };
        slashes(&[about])
            + &format!(
                "@group(0) @binding(0) var<storage, read> {bound}: array<vec4f, {}>;\n",
                self.code.steps.bound()
            )
            + &format!("@group(0) @binding(1) var<storage, read> {at_name}: array<{of}>;\n")
            + &format!("@group(0) @binding(2) var<storage, read_write> {points}: array<vec4f>;\n")
            + &shapes.0
            + "\n"
            + &format!(
                "@compute @workgroup_size(64)\nfn {kernel}(@builtin(global_invocation_id) id: vec3u) {{\n"
            )
            + &format!("    if (id.x < arrayLength(&{at_name})) {{\n")
            + &format!(
                "        {points}[id.x] = {eval}({}{bound}, {});\n    }}\n}}\n",
                shapes.1,
                at.join(", ")
            )
    }

    fn constants(&self) -> String {
        let (code, language) = (self.code, self.language);
        let float = language.float();
        let mut text = String::new();
        for (name, (low, high)) in code.named_ends() {
            let own = if code.is_curve() { String::new() } else { format!("_{name}") };
            text += &language.constant(&self.member(&format!("LOW{own}")), float, &language.signed(&low));
            text += &language.constant(&self.member(&format!("HIGH{own}")), float, &language.signed(&high));
        }
        let suffix = if language == Shader::Wgsl { "f" } else { "" };
        let bounds: Vec<(bool, String)> = code
            .rounding
            .iter()
            .map(|error| bound_text(error.as_ref()).unwrap_or((false, String::from("-1.0"))))
            .collect();
        if !bounds.is_empty() {
            text += "// Rounding errors of the values in units of 2^-23, proved: of |value| where ROUNDING_RELATIVE is true, else\n";
            text += "// absolute; -1 where none is known.\n";
            if needs_functions(code.family) {
                text += "// None is known here: sines and exponentials of shaders may be wrong by many units in the last place.\n";
            }
            if Shader::divides(&code.steps.values()) {
                text += "// The functions divide: the bounds assume quotients that are rounded correctly.\n";
            }
            if code.has_ends_in_parts() {
                text += "// Compilers of shaders may reassociate sums: next to an end that is no float, such as pi/2, errors are\n";
                text += "// small beside 1, not beside the value.\n";
            }
            let values: Vec<String> = bounds.iter().map(|(_, bound)| format!("{bound}{suffix}")).collect();
            let relative: Vec<String> = bounds.iter().map(|(relative, _)| relative.to_string()).collect();
            let name = self.member("ROUNDING");
            let array = language.array(float, values.len());
            text += &language.constant(&name, &array, &language.list(float, &values));
            let name = self.member("ROUNDING_RELATIVE");
            text += &language.constant(
                &name,
                &language.array("bool", relative.len()),
                &language.list("bool", &relative),
            );
        }
        if let Some((_, bound)) = bound_text(code.point_rounding.as_ref()) {
            text +=
                "// The same of a component of a point, times the largest |component| of a control point.\n";
            text += &language.constant(&self.member("ROUNDING_POINT"), float, &format!("{bound}{suffix}"));
        }
        text
    }

    fn shapes(&self) -> Vec<String> {
        let float = self.language.float();
        self.code.shapes.iter().map(|shape| self.language.argument(&shape.name, float)).collect()
    }

    fn coordinates(&self) -> Vec<String> {
        let float = self.language.float();
        self.code.coordinates.iter().map(|name| self.language.argument(name, float)).collect()
    }

    /// What is computed from the shape values, if these steps or the inner knots need it.
    fn derived(&self, steps: &[Steps]) -> String {
        let used: Vec<usize> = steps.iter().flat_map(used_shapes).chain(inner_knots(self.code)).collect();
        self.derived_if(used.iter().any(|k| *k >= self.code.shapes.len()))
    }

    fn derived_if(&self, needed: bool) -> String {
        let (code, language) = (self.code, self.language);
        if !needed {
            return String::new();
        }
        let shapes: Vec<&str> = code.shapes.iter().map(|shape| shape.name.as_str()).collect();
        let call = format!("{}({})", self.member("derived"), shapes.join(", "));
        let array = language.array("float", code.derived.len());
        let mut lines = language.named("derived", &array, &call);
        for (k, name) in code.derived.iter().enumerate() {
            lines += &language.named(name, "float", &format!("derived[{k}]"));
        }
        lines
    }

    /// The function with what is computed from the shape values.
    fn derive(&self) -> Option<String> {
        let (code, language) = (self.code, self.language);
        let expressions = body(code, &code.steps.derived()?.steps, &language);
        let outputs: Vec<String> = expressions.outputs.iter().map(|value| value.text.clone()).collect();
        let lines =
            language.lets(&expressions) + &format!("return {};\n", language.list(language.float(), &outputs));
        let result = language.array(language.float(), outputs.len());
        let about =
            format!("What the other functions need of the shape values: {}.", code.derived.join(", "));
        let function = language.function(&self.member("derived"), &self.shapes(), &result, &lines);
        Some(slashes(&[about]) + &function)
    }

    /// All steps of a kind, one for each span.
    fn all(&self, of: &dyn Fn(&FamilySteps<'_>) -> Steps) -> Vec<Steps> {
        let steps = &self.code.steps;
        (0..steps.spans()).map(|span| of(&steps.on_span(span))).collect()
    }

    /// Whether points need the shape values.
    fn points_need_shapes(&self) -> bool {
        self.code.steps.is_quotient() && !self.code.shapes.is_empty()
    }

    /// The function with the ends of the domain, where these are no constants.
    fn domain(&self) -> Option<String> {
        let (code, language) = (self.code, self.language);
        let ends = code.moving_ends()?;
        let is_derived = |end: &Knot| matches!(end, Knot::Shape(k) if *k >= code.shapes.len());
        let outputs = ends.each_ref().map(|end| knot_text(code, end, &language));
        let lines = self.derived_if(ends.iter().any(is_derived))
            + &format!("return {};\n", language.list(language.float(), &outputs));
        let result = language.array(language.float(), 2);
        let function = language.function(&self.member("domain"), &self.shapes(), &result, &lines);
        Some(slashes(&[String::from("The two ends of the domain.")]) + &function)
    }

    fn numbers(&self, name: &str, about: &str, of: &dyn Fn(&FamilySteps<'_>) -> Steps) -> String {
        let language = self.language;
        let lines = on_spans(self.code, &language, "", &|on_span| {
            let expressions = body(self.code, &of(on_span), &language);
            let outputs: Vec<String> = expressions.outputs.iter().map(|value| value.text.clone()).collect();
            language.lets(&expressions) + &format!("return {};\n", language.list(language.float(), &outputs))
        });
        let lines = self.derived(&self.all(of)) + &lines;
        let arguments = [self.shapes(), self.coordinates()].concat();
        let result = language.array(language.float(), self.code.count());
        slashes(&[about.to_string()]) + &language.function(&self.member(name), &arguments, &result, &lines)
    }

    fn bind(&self) -> String {
        let (code, language) = (self.code, self.language);
        let steps = code.steps.bind();
        let lines = self.elements("P", "points", code.count());
        let points = language.argument("points", &language.array(language.vector(), code.count()));
        let arguments = [self.shapes(), vec![points]].concat();
        let about = format!(
            "Binds {} control points: the coefficients from which points are computed.",
            code.count()
        );
        let lines = self.derived(std::slice::from_ref(&steps)) + &lines;
        self.with_vectors("bind", &about, &arguments, &steps, &lines)
    }

    /// Named elements of an array.
    fn elements(&self, prefix: &str, array: &str, count: usize) -> String {
        let one = |k: usize| {
            self.language.named(&format!("{prefix}{k}"), self.language.vector(), &format!("{array}[{k}]"))
        };
        (0..count).map(one).collect()
    }

    /// A function whose result is a vector or several.
    fn with_vectors(
        &self,
        name: &str,
        about: &str,
        arguments: &[String],
        steps: &Steps,
        inputs: &str,
    ) -> String {
        let language = self.language;
        let lines = inputs.to_string() + &self.vectors(name, steps);
        let count = steps.outputs.len();
        let result = if count == 1 && name.starts_with("eval") {
            language.vector().to_string()
        } else {
            language.array(language.vector(), count)
        };
        slashes(&[about.to_string()]) + &language.function(&self.member(name), arguments, &result, &lines)
    }

    /// The lines that compute vectors and return them.
    fn vectors(&self, name: &str, steps: &Steps) -> String {
        let language = self.language;
        let expressions = body(self.code, steps, &language);
        let outputs = language.vectors(&expressions.outputs);
        let value = if outputs.len() == 1 && name.starts_with("eval") {
            outputs[0].clone()
        } else {
            language.list(language.vector(), &outputs)
        };
        language.lets(&expressions) + &format!("return {value};\n")
    }

    fn evaluator(
        &self,
        name: &str,
        about: &str,
        of: &dyn Fn(&FamilySteps<'_>) -> Option<Steps>,
    ) -> Option<String> {
        let (code, language) = (self.code, self.language);
        let first = of(&code.steps)?;
        let count = code.steps.bound();
        let bound = language.argument("bound", &language.array(language.vector(), count));
        let shapes = if self.points_need_shapes() { self.shapes() } else { Vec::new() };
        let arguments = [shapes, vec![bound], self.coordinates()].concat();
        if code.steps.spans() == 1 {
            let lines = self.derived(std::slice::from_ref(&first)) + &self.elements("B", "bound", count);
            return Some(self.with_vectors(name, about, &arguments, &first, &lines));
        }
        let of = |on_span: &FamilySteps<'_>| of(on_span).unwrap_or_else(|| first.clone());
        let lines = on_spans(code, &language, "", &|on_span| {
            let steps = of(on_span);
            let one = |k: &usize| language.named(&format!("B{k}"), language.vector(), &format!("bound[{k}]"));
            let inputs: String =
                crate::emit::write::used(&steps, crate::emit::write::bound).iter().map(one).collect();
            inputs + &self.vectors(name, &steps)
        });
        let lines = self.derived(&self.all(&of)) + &lines;
        let result = if first.outputs.len() == 1 {
            language.vector().to_string()
        } else {
            language.array(language.vector(), first.outputs.len())
        };
        Some(
            slashes(&[about.to_string()])
                + &language.function(&self.member(name), &arguments, &result, &lines),
        )
    }

    /// The determined control points for one order of contact.
    fn continuation(&self, name: &str, at_start: bool, end: &EndSteps) -> String {
        let (code, language) = (self.code, self.language);
        let order = end.positions.len() - 1;
        let mut steps = end.steps.clone();
        steps.outputs.truncate(end.positions.len());
        let (vector, float) = (language.vector(), language.float());
        let mut lines = language.named("D0", vector, "derivatives[0]");
        if order > 0 {
            let one = language.literal(&Rational::ONE);
            lines += &language.named("inverse_f", float, &format!("{one} / f"));
            lines += &language.named("D1", vector, "derivatives[1] * inverse_f");
        }
        if order > 1 {
            lines += &language.named("D2", vector, "(derivatives[2] - D1 * c) * (inverse_f * inverse_f)");
        }
        let others: Vec<usize> = crate::emit::write::used(&steps, crate::emit::write::point);
        for k in &others {
            lines += &language.named(&format!("P{k}"), vector, &format!("points[{k}]"));
        }
        let mut arguments = self.shapes();
        arguments.push(language.argument("derivatives", &language.array(vector, order + 1)));
        if order > 0 {
            arguments.push(language.argument("f", float));
        }
        if order > 1 {
            arguments.push(language.argument("c", float));
        }
        if !others.is_empty() {
            arguments.push(language.argument("points", &language.array(vector, code.count())));
        }
        let numbers: Vec<String> = end.positions.iter().map(ToString::to_string).collect();
        let side = if at_start {
            "ends, of a curve Q that starts there"
        } else {
            "starts, of a curve Q that ends there"
        };
        let conditions =
            ["Q = P", "Q = P, Q' = P'/f", "Q = P, Q' = P'/f, Q'' = (P'' - c Q')/f^2"][order.min(2)];
        let mut about = format!(
            "The control points {} where a curve P {side}: {conditions}, from the derivatives of P there",
            numbers.join(", ")
        );
        if end.undetermined.is_empty() {
            about += ".";
        } else {
            about += &format!("; not determined at {}.", end.undetermined.join(", "));
        }
        self.with_vectors(&format!("points_{name}_{order}"), &about, &arguments, &steps, &lines)
    }
}

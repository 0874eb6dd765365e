//! The class of a family in TypeScript.

use crate::emit::write::{
    body, bound, condition, coordinate, derivative, indented, knot_text, on_spans, point, used, used_shapes,
};
use crate::emit::{FamilyCode, Knot};
use crate::plan::Input;
use crate::rounding::{Error, decimal as hundredths};
use crate::steps::{EndSteps, FamilySteps, Steps};

use super::{TypeScript, documented, element, function, length, place, quoted};

/// A family that is being written.
pub(super) struct Class<'a> {
    pub(super) code: &'a FamilyCode<'a>,
    pub(super) language: TypeScript,
}

impl Class<'_> {
    fn bound_name(&self) -> String {
        let kind = if self.code.is_curve() { "Curve" } else { "Patch" };
        format!("{}{kind}", self.code.name)
    }

    pub(super) fn whole(&self) -> String {
        let code = self.code;
        let mut parts = vec![self.constants()];
        parts.extend(self.constructor());
        parts.push(
            self.numbers("values", "", &format!("The values of {}.", code.listed()), &|steps| steps.values()),
        );
        let sized = format!("result: Float64Array = new Float64Array({})", code.count());
        let names = code.coordinates.join(", ");
        if code.is_curve() {
            let t = &code.coordinates[0];
            let lines = format!(
                "switch (order) {{\n    case 0: return this.values({t}, result);\n    case 1: return this.derivatives1({t}, result);\n    \
                 case 2: return this.derivatives2({t}, result);\n    \
                 default: throw new RangeError(`the order of a derivative is 0, 1 or 2; got ${{String(order)}}`);\n}}\n"
            );
            parts.push(function(
                &format!("derivatives({t}: number, order: 0 | 1 | 2 = 1, {sized}): Float64Array"),
                &format!("The derivatives of the functions by {t}, of order 0, 1 or 2."),
                &lines,
            ));
            parts.push(self.numbers("derivatives1", "private ", "", &|steps| steps.derivatives(&[1])));
            parts.push(self.numbers("derivatives2", "private ", "", &|steps| steps.derivatives(&[2])));
        } else {
            let doc = format!(
                "The partial derivatives of the functions, `orders` in {}, with a sum of at most 2.",
                self.independent()
            );
            let head =
                format!("partials({}, orders: readonly number[], {sized}): Float64Array", self.typed());
            parts.push(function(&head, &doc, &self.choice(&names)));
            for orders in code.orders() {
                let name = format!("partials{}", suffix(&orders));
                parts.push(self.numbers(&name, "private ", "", &|steps| steps.derivatives(&orders)));
            }
        }
        parts.push(self.bind());
        if code.is_curve() {
            parts.extend(
                [("curveAfter", true), ("curveBefore", false)]
                    .iter()
                    .filter_map(|(n, s)| self.continuation(n, *s)),
            );
        }
        let class = format!("export class {} {{\n{}}}\n", code.name, indented(&parts.join("\n"), "    "));
        class + "\n" + &self.bound()
    }

    fn typed(&self) -> String {
        let coordinates = self.code.coordinates.iter().map(|name| format!("{name}: number"));
        coordinates.collect::<Vec<_>>().join(", ")
    }

    fn independent(&self) -> String {
        self.code.independent().join(", ")
    }

    /// The method for given orders of derivatives.
    fn choice(&self, names: &str) -> String {
        let mut lines = String::from("switch (orders.join()) {\n");
        let zeros = vec![0; self.code.family.domain.len()];
        lines += &format!("    case '{}': return this.values({names}, result);\n", joined(&zeros));
        for orders in self.code.orders() {
            let name = format!("partials{}", suffix(&orders));
            lines += &format!("    case '{}': return this.{name}({names}, result);\n", joined(&orders));
        }
        lines
            + "    default: throw new RangeError(`the orders of a partial derivative sum to at most 2; got ${orders.join()}`);\n}\n"
    }

    fn constants(&self) -> String {
        let code = self.code;
        let mut text = format!("static readonly functions = {};\n", code.count());
        let ends: Vec<String> = code
            .ends()
            .iter()
            .map(|(low, high)| format!("[{}, {}]", self.language.signed(low), self.language.signed(high)))
            .collect();
        match ends.as_slice() {
            [] => {}
            [one] => text += &format!("static readonly domain: readonly [number, number] = {one};\n"),
            _ => {
                text += &format!(
                    "static readonly domain: readonly (readonly [number, number])[] = [{}];\n",
                    ends.join(", ")
                );
            }
        }
        let knots = code.knots();
        if code.steps.spans() > 1 && knots.iter().all(|knot| matches!(knot, Knot::Number(_))) {
            let knots: Vec<String> = knots.iter().map(|knot| knot_text(code, knot, &self.language)).collect();
            text += &format!("static readonly knots: readonly number[] = [{}];\n", knots.join(", "));
        }
        let mut about = vec![String::from(
            "Rounding errors of the values, proved. They hold as long as nothing overflows; a product that underflows is off by half the smallest number, which a division after it may enlarge.",
        )];
        if code.assumes_functions() {
            about.push(String::from(
                "They assume that Math.sin, cos, tan and expm1 are within one unit in the last place, Math.tanh within two.",
            ));
        }
        about.extend(code.assumed_of_ends());
        text += &documented(&about);
        let one = |error: Option<&Error>| match error {
            Some(Error::Relative(bound)) => {
                format!("{{ kind: 'relative', epsilons: {} }}", hundredths(bound))
            }
            Some(Error::Absolute(bound)) => {
                format!("{{ kind: 'absolute', epsilons: {} }}", hundredths(bound))
            }
            None => String::from("{ kind: 'unknown', epsilons: Infinity }"),
        };
        let bounds: String =
            code.rounding.iter().map(|error| format!("    {},\n", one(error.as_ref()))).collect();
        text += &format!("static readonly rounding: readonly Rounding[] = [\n{bounds}];\n");
        if let Some(bound) = &code.point_rounding {
            text += &documented(&[String::from(
                "The same of a component of a point, in units of 2 ** -52 times the largest |component| of a control point.",
            )]);
            text += &format!("static readonly roundingPoint = {};\n", hundredths(bound.epsilons()));
        }
        text
    }

    fn constructor(&self) -> Option<String> {
        let code = self.code;
        if code.shapes.is_empty() {
            return None;
        }
        let mut text = String::new();
        for shape in &code.shapes {
            let doc = if shape.doc.is_empty() { String::new() } else { format!(": {}", shape.doc.join(" ")) };
            text += &documented(&[format!("{}{doc}", shape.shown)]);
            text += &format!("readonly {}: number;\n", shape.name);
        }
        for name in &code.derived {
            text += &format!("readonly {name}: number;\n");
        }
        if code.moving_ends().is_some() {
            text += &documented(&[String::from("The two ends of the domain.")]);
            text += "readonly domain: readonly [number, number];\n";
        }
        let mut lines: String = code.shapes.iter().map(|s| self.language.check(&code.name, s)).collect();
        for assumption in &code.assumptions {
            let expressions = body(code, &assumption.steps, &self.language);
            let condition = condition(assumption, &expressions, &self.language);
            let message = format!("{}: the shape values do not satisfy {}", code.name, assumption.text);
            lines += &TypeScript::checked(&expressions, &condition, &message);
        }
        lines += &code.shapes.iter().map(|s| format!("this.{0} = {0};\n", s.name)).collect::<String>();
        if let Some(derived) = code.steps.derived() {
            let expressions = body(code, &derived.steps, &self.language);
            lines += &TypeScript::scalar_lets(&expressions);
            for (name, value) in code.derived.iter().zip(&expressions.outputs) {
                lines += &format!("this.{name} = {};\n", value.text);
            }
        }
        if let Some(ends) = code.moving_ends() {
            let ends = ends.map(|end| {
                let of = if matches!(end, Knot::Shape(_)) { "this." } else { "" };
                format!("{of}{}", knot_text(code, &end, &self.language))
            });
            lines += &format!("this.domain = [{}];\n", ends.join(", "));
        }
        let arguments: Vec<String> = code.shapes.iter().map(|s| format!("{}: number", s.name)).collect();
        let doc = "Throws a RangeError for shape values outside of their ranges, infinite ones, and NaN.";
        Some(text + "\n" + &function(&format!("constructor({})", arguments.join(", ")), doc, &lines))
    }

    /// The shape values that steps use as local names, and a mention of coordinates that they do not use.
    fn inputs(&self, steps: &Steps, of: &str) -> String {
        self.named_shapes(&used_shapes(steps), of)
    }

    fn named_shapes(&self, used: &[usize], of: &str) -> String {
        let names = used.iter().map(|k| self.code.input(Input::Shape(*k)));
        names.map(|name| format!("const {name} = {of}.{name};\n")).collect()
    }

    /// Lines for each span, with the knots that are shape values.
    fn on_spans(&self, of: &str, lines: &dyn Fn(&FamilySteps<'_>) -> String) -> String {
        on_spans(self.code, &self.language, &format!("{of}."), lines)
    }

    fn unused(&self, steps: &Steps) -> String {
        let used = used(steps, coordinate);
        let unused = self.code.coordinates.iter().enumerate().filter(|(k, _)| !used.contains(k));
        unused.map(|(_, name)| format!("void {name};\n")).collect()
    }

    /// A method that computes a number for each function.
    fn numbers(
        &self,
        name: &str,
        visible: &str,
        doc: &str,
        of: &dyn Fn(&FamilySteps<'_>) -> Steps,
    ) -> String {
        let mut lines = self.on_spans("this", &|on_span| {
            let steps = of(on_span);
            let expressions = body(self.code, &steps, &self.language);
            let mut lines =
                self.inputs(&steps, "this") + &self.unused(&steps) + &TypeScript::scalar_lets(&expressions);
            for (k, value) in expressions.outputs.iter().enumerate() {
                lines += &format!("result[{k}] = {};\n", value.text);
            }
            lines
        });
        lines += "return result;\n";
        let result = if visible.is_empty() {
            format!("result: Float64Array = new Float64Array({})", self.code.count())
        } else {
            String::from("result: Float64Array")
        };
        function(&format!("{visible}{name}({}, {result}): Float64Array", self.typed()), doc, &lines)
    }

    fn elements(array: &str, prefix: &str, used: &[usize]) -> Vec<(String, String)> {
        used.iter().map(|k| (format!("{prefix}{k}"), element(array, *k))).collect()
    }

    fn bind(&self) -> String {
        let (code, own) = (self.code, self.bound_name());
        let doc = format!(
            "Binds {} control points of `dimension` components each, one after the other.",
            code.count()
        );
        function(
            &format!("bind(dimension: number, points: ArrayLike<number>): {own}"),
            &doc,
            &format!("return new {own}(this, dimension, points);\n"),
        )
    }

    /// The class of what is bound.
    fn bound(&self) -> String {
        let (code, own) = (self.code, self.bound_name());
        let mut fields = format!(
            "readonly family: {};\nreadonly dimension: number;\nreadonly points: Float64Array;\nprivate readonly bound: Float64Array;\n",
            code.name
        );
        if code.is_curve() {
            fields += &if code.moving_ends().is_some() {
                String::from("readonly domain: readonly [number, number];\n")
            } else {
                format!("readonly domain: readonly [number, number] = {}.domain;\n", code.name)
            };
        }
        let steps = code.steps.bind();
        let expressions = body(code, &steps, &self.language);
        let inputs = Self::elements("points", "P", &used(&steps, point));
        let outputs: Vec<String> = (0..code.steps.bound()).map(|k| place("bound", k)).collect();
        let lines = length(
            &format!("points of {}", code.name),
            "points",
            &format!("{} * dimension", code.count()),
        ) + "this.family = family;\nthis.dimension = dimension;\nthis.points = Float64Array.from(points);\n"
            + if code.moving_ends().is_some() { "this.domain = family.domain;\n" } else { "" }
            + &format!(
                "const bound = new Float64Array({} * dimension);\nthis.bound = bound;\n",
                code.steps.bound()
            )
            + &self.inputs(&steps, "family")
            + &TypeScript::on_components(&expressions, &inputs, &outputs, false);
        let constructor = function(
            &format!("constructor(family: {}, dimension: number, points: ArrayLike<number>)", code.name),
            "",
            &lines,
        );
        let mut parts = vec![fields, constructor];
        let sized = "point: Float64Array = new Float64Array(this.dimension)";
        if code.is_curve() {
            let t = &code.coordinates[0];
            let head = format!("eval({}, {sized}): Float64Array", self.typed());
            let doc = format!("The point of the curve at {t}.");
            parts.extend(self.evaluator(&head, &doc, &|steps| steps.curve(1)));
            let head = format!(
                "evalWithDerivatives({}, point: Float64Array = new Float64Array(3 * this.dimension)): Float64Array",
                self.typed()
            );
            let doc = format!(
                "The point of the curve at {t}, and its first and second derivative by {t}, one after the other."
            );
            parts.extend(self.evaluator(&head, &doc, &|steps| steps.curve(3)));
        } else {
            let names = code.coordinates.join(", ");
            let zeros = vec![0; code.family.domain.len()];
            let head = format!("eval({}, {sized}): Float64Array", self.typed());
            parts.extend(self.evaluator(&head, "The point of the patch.", &|steps| steps.patch(&zeros)));
            let mut lines = format!(
                "switch (orders.join()) {{\n    case '{}': return this.eval({names}, point);\n",
                joined(&zeros)
            );
            for orders in code.orders() {
                lines += &format!(
                    "    case '{}': return this.partial{}({names}, point);\n",
                    joined(&orders),
                    suffix(&orders)
                );
            }
            lines += "    default: throw new RangeError(`the orders of a partial derivative sum to at most 2; got ${orders.join()}`);\n}\n";
            let doc = format!(
                "A partial derivative of the patch, `orders` in {}, with a sum of at most 2.",
                self.independent()
            );
            let head = format!("partial({}, orders: readonly number[], {sized}): Float64Array", self.typed());
            parts.push(function(&head, &doc, &lines));
            for orders in code.orders() {
                let head = format!(
                    "private partial{}({}, point: Float64Array): Float64Array",
                    suffix(&orders),
                    self.typed()
                );
                parts.extend(self.evaluator(&head, "", &|steps| steps.patch(&orders)));
            }
        }
        parts.push(self.slices());
        let doc = documented(&[format!("Control points that are bound to a family `{}`.", code.name)]);
        format!("{doc}export class {own} {{\n{}}}\n", indented(&parts.join("\n"), "    "))
    }

    /// A method from bound coefficients to points.
    fn evaluator(
        &self,
        head: &str,
        doc: &str,
        of: &dyn Fn(&FamilySteps<'_>) -> Option<Steps>,
    ) -> Option<String> {
        of(&self.code.steps)?;
        let lines = self.on_spans("this.family", &|on_span| {
            let Some(steps) = of(on_span) else { return String::new() };
            let expressions = body(self.code, &steps, &self.language);
            let needed = used(&steps, bound);
            let inputs = Self::elements("bound", "B", &needed);
            let outputs: Vec<String> = (0..expressions.outputs.len()).map(|k| place("point", k)).collect();
            let bound = if needed.is_empty() { "" } else { "const bound = this.bound;\n" };
            bound.to_string()
                + &self.inputs(&steps, "this.family")
                + &self.unused(&steps)
                + &TypeScript::on_components(&expressions, &inputs, &outputs, false)
        });
        Some(function(head, doc, &format!("const dimension = this.dimension;\n{lines}return point;\n")))
    }

    fn slices(&self) -> String {
        let count = self.code.coordinates.len();
        let at: Vec<String> = (0..count)
            .map(|k| match (count, k) {
                (1, _) => String::from("at[row]!"),
                (_, 0) => format!("at[{count} * row]!"),
                _ => format!("at[{count} * row + {k}]!"),
            })
            .collect();
        let rows = if count == 1 { String::from("at.length") } else { format!("at.length / {count}") };
        let lines = format!(
            "const dimension = this.dimension;\nconst count = Math.floor({rows});\n\
             const point = new Float64Array(dimension);\n\
             for (let row = 0; row < count; row++) {{\n    this.eval({}, point);\n    points.set(point, row * dimension);\n}}\n\
             return points;\n",
            at.join(", ")
        );
        let size =
            if count == 1 { String::from("at.length") } else { format!("Math.floor(at.length / {count})") };
        let head = format!(
            "evalN(at: ArrayLike<number>, points: Float64Array = new Float64Array({size} * this.dimension)): Float64Array"
        );
        let doc = if count == 1 {
            String::from("The points at the parameters `at`, one after the other.")
        } else {
            format!(
                "The points at the points `at` of the domain, each given by {}, one after the other.",
                self.code.coordinates.join(", ")
            )
        };
        function(&head, &doc, &lines)
    }

    fn continuation(&self, name: &str, at_start: bool) -> Option<String> {
        let code = self.code;
        let all = code.steps.ends(2, at_start);
        if all.is_empty() {
            return None;
        }
        let orders: Vec<String> = all.iter().map(|end| (end.positions.len() - 1).to_string()).collect();
        let end = usize::from(at_start);
        let mut lines =
            length(&format!("points of {}", code.name), "points", &format!("{} * dimension", code.count()));
        lines =
            String::from("const { order, f = 1, c = 0 } = contact;\nconst dimension = curve.dimension;\n")
                + &lines;
        lines += "if (!(f > 0 && f <= Number.MAX_VALUE)) {\n    throw new RangeError(`f = ${f} is not positive and finite`);\n}\n";
        lines += "if (!Number.isFinite(c)) {\n    throw new RangeError(`c = ${c} is not finite`);\n}\n";
        lines += &format!(
            "const derivatives = curve.evalWithDerivatives(curve.domain[{end}]);\nconst result = Float64Array.from(points);\n"
        );
        let mut cases = String::new();
        for end in &all {
            cases += &format!(
                "case {}: {{\n{}    break;\n}}\n",
                end.positions.len() - 1,
                indented(&self.end(end), "    ")
            );
        }
        if cases.contains("inverse") {
            lines += "const inverse = 1 / f;\n";
        }
        cases += "default: throw new RangeError(`there is no contact of order ${String(order)}`);\n";
        lines += &format!(
            "switch (order) {{\n{}}}\nreturn this.bind(dimension, result);\n",
            indented(&cases, "    ")
        );
        let (side, which) = if at_start {
            ("continues `curve` where that ends", "first")
        } else {
            ("ends where `curve` starts", "last")
        };
        let doc = format!(
            "The curve Q that {side}: Q = P, Q' = P'/f, Q'' = (P'' - c Q')/f^2 up to the order. The {which} order + 1 of `points` \
             are computed, the others are given; `curve` is of any family."
        );
        let head = format!(
            "{name}(curve: Touching, contact: {{ order: {}; f?: number; c?: number }}, points: ArrayLike<number>): {}",
            orders.join(" | "),
            self.bound_name()
        );
        Some(function(&head, &doc, &lines))
    }

    fn end(&self, end: &EndSteps) -> String {
        let code = self.code;
        let expressions = body(code, &end.steps, &self.language);
        let derivatives = used(&end.steps, derivative);
        let highest = derivatives.iter().max().copied().unwrap_or(0);
        let mut inputs = Vec::new();
        for k in 0..=highest {
            let value = element("derivatives", k);
            let value = match k {
                0 => value,
                1 => format!("{value} * inverse"),
                _ => format!("({value} - D1 * c) * (inverse * inverse)"),
            };
            if derivatives.contains(&k) || (k == 1 && highest > 1) {
                inputs.push((format!("D{k}"), value));
            }
        }
        inputs.extend(used(&end.steps, point).iter().map(|k| (format!("P{k}"), element("result", *k))));
        let outputs: Vec<String> = end.positions.iter().map(|k| place("result", *k)).collect();
        let loops = TypeScript::on_components(&expressions, &inputs, &outputs, true);
        let (lets, rest) = loops.split_at(TypeScript::scalar_lets(&expressions).len());
        let mut lines = self.inputs(&end.steps, "this") + lets;
        for (divisor, at) in expressions.outputs[end.positions.len()..].iter().zip(&end.undetermined) {
            let message =
                quoted(&format!("{}: the derivatives do not determine the points at {at}", code.name));
            lines += &format!("if ({} === 0) {{\n    throw new RangeError({message});\n}}\n", divisor.text);
        }
        lines + rest
    }
}

/// Orders of derivatives between commas.
fn joined(orders: &[usize]) -> String {
    orders.iter().map(ToString::to_string).collect::<Vec<_>>().join(",")
}

/// Orders of derivatives in a name: `_1_0`.
fn suffix(orders: &[usize]) -> String {
    orders.iter().map(|order| format!("_{order}")).collect()
}

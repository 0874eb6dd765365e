//! The class of a family in Python.

use crate::emit::write::{body, bound_text, condition, indented, inner_knots, knot_text, used_shapes};
use crate::emit::{FamilyCode, Knot, Value};
use crate::plan::Input;
use crate::plan::reach::decimal as reach_text;
use crate::steps::{EndSteps, FamilySteps, Steps};

use super::{Python, docstring, function, quoted, tuple};

/// A family that is being written.
pub(super) struct Class<'a> {
    pub(super) code: &'a FamilyCode<'a>,
    pub(super) language: Python,
}

impl Class<'_> {
    pub(super) fn whole(&self) -> String {
        let code = self.code;
        let mut parts = vec![self.constants(), self.init(), self.values()];
        if code.is_curve() {
            parts.extend(self.derivatives());
        } else {
            parts.extend(self.partials());
        }
        parts.push(self.bind());
        if code.is_curve() {
            parts.extend(self.continuations());
        }
        let domain = &code.coordinates.join(", ");
        let doc = docstring(&format!("The basis functions {}, of {domain}.", code.listed()));
        let class = format!("class {}:\n{}", code.name, indented(&(doc + "\n" + &parts.join("\n")), "    "));
        class + "\n\n" + &self.bound()
    }

    fn curve_name(&self) -> String {
        let kind = if self.code.is_curve() { "Curve" } else { "Patch" };
        format!("{}{kind}", self.code.name)
    }

    fn constants(&self) -> String {
        let code = self.code;
        let mut text = format!("FUNCTIONS = {}\n", code.count());
        let ends: Vec<String> = code
            .ends()
            .iter()
            .map(|(low, high)| format!("({}, {})", self.language.signed(low), self.language.signed(high)))
            .collect();
        match ends.as_slice() {
            [] => {}
            [one] if code.steps.spans() > 1 => {
                text += &format!("DOMAIN = {one}\n");
                let knots = code.knots();
                if knots.iter().all(|knot| matches!(knot, Knot::Number(_))) {
                    let knots: Vec<String> =
                        knots.iter().map(|knot| knot_text(code, knot, &self.language)).collect();
                    text += &format!("KNOTS = {}\n", tuple(&knots));
                }
            }
            [one] => text += &format!("DOMAIN = {one}\n"),
            _ => text += &format!("DOMAIN = {}\n", tuple(&ends)),
        }
        text += "# Rounding errors of the values, proved, in units of 2**-52, or 2**-23 for float32: of |value| where relative. They\n";
        text += "# hold as long as nothing overflows; a product that underflows is off by half the smallest number, which a\n# division after it may enlarge.\n";
        if code.assumes_functions() {
            text += "# They assume that sin, cos, tan and expm1 are within one unit in the last place, tanh within two.\n";
        }
        if let Some(assumed) = code.assumed_of_ends() {
            text += &format!("# {assumed}\n");
        }
        let bounds = code.rounding.iter().map(|error| match bound_text(error.as_ref()) {
            Some((true, bound)) => format!("(\"relative\", {bound})"),
            Some((false, bound)) => format!("(\"absolute\", {bound})"),
            None => String::from("(\"unknown\", INFINITY)"),
        });
        text += &format!("ROUNDING = {}\n", tuple(&bounds.collect::<Vec<_>>()));
        if let Some((_, bound)) = bound_text(code.point_rounding.as_ref()) {
            text +=
                "# The same of a component of a point, times the largest |component| of a control point.\n";
            text += &format!("ROUNDING_POINT = {bound}\n");
        }
        text
    }

    fn init(&self) -> String {
        let code = self.code;
        let arguments: String = code.shapes.iter().map(|shape| format!(", {}: float", shape.name)).collect();
        let mut lines: String = code.shapes.iter().map(|s| self.language.check(&code.name, s)).collect();
        for assumption in &code.assumptions {
            let expressions = body(code, &assumption.steps, &self.language);
            lines += &Python::lets(&expressions.lets);
            let message =
                quoted(&format!("{}: the shape values have to satisfy {}", code.name, assumption.text));
            let names: Vec<String> = code.shapes.iter().map(|shape| shape.name.clone()).collect();
            let condition = condition(assumption, &expressions, &self.language);
            lines += &format!("_check({message}, {}, {condition})\n", tuple(&names));
        }
        lines += &code.shapes.iter().map(|s| format!("self.{0} = {0}\n", s.name)).collect::<String>();
        if let Some(derived) = code.steps.derived() {
            let expressions = body(code, &derived.steps, &self.language);
            lines += &Python::lets(&expressions.lets);
            for (name, value) in code.derived.iter().zip(&expressions.outputs) {
                lines += &format!("self.{name} = {}\n", value.text);
            }
        }
        if let Some(ends) = code.moving_ends() {
            let ends = ends.map(|end| {
                let of = if matches!(end, Knot::Shape(_)) { "self." } else { "" };
                format!("{of}{}", knot_text(code, &end, &self.language))
            });
            lines += &format!("self.DOMAIN = {}\n", tuple(&ends));
        }
        let doc = if code.shapes.is_empty() {
            lines += "pass\n";
            String::from("There are no shape parameters.")
        } else {
            let shown: Vec<String> = code
                .shapes
                .iter()
                .map(|s| {
                    let single = s.single.iter().zip(["at least", "at most"]).filter_map(|(end, words)| {
                        let end = reach_text(end.as_ref()?);
                        Some(format!(", {words} {end} where it or a coordinate is a float32"))
                    });
                    let about =
                        if s.doc.is_empty() { String::new() } else { format!(" ({})", s.doc.join(" ")) };
                    s.shown.clone() + &single.collect::<String>() + &about
                })
                .collect();
            format!("{}. Raises ValueError for other shape values.", shown.join("; "))
        };
        function(&format!("__init__(self{arguments}) -> None"), &doc, &lines)
    }

    /// The shape values that steps use as local names.
    fn shapes(&self, steps: &Steps) -> String {
        self.named_shapes(&used_shapes(steps))
    }

    fn named_shapes(&self, used: &[usize]) -> String {
        let names = used.iter().map(|k| self.code.input(Input::Shape(*k)));
        names.map(|name| format!("{name} = self.{name}\n")).collect()
    }

    /// The inner knots as a tuple.
    fn knots(&self) -> String {
        let knots = self.code.knots();
        let inner = &knots[1..knots.len() - 1];
        let texts: Vec<String> =
            inner.iter().map(|knot| knot_text(self.code, knot, &self.language)).collect();
        tuple(&texts)
    }

    /// The names of shape values that a point needs beside its coordinates.
    fn point_shapes(&self) -> Vec<String> {
        let code = self.code;
        let count = if code.steps.is_quotient() { code.shapes.len() + code.derived.len() } else { 0 };
        (0..count).map(|k| code.input(Input::Shape(k))).collect()
    }

    /// Results that do not depend on the point of the domain, or on points, get the shape of those that do.
    fn spread(&self, values: &[Value], points: Option<&str>) -> Vec<String> {
        let sum = self.code.coordinates.join(" + ");
        let sum = if self.code.coordinates.len() > 1 { format!("({sum})") } else { sum };
        values
            .iter()
            .map(|value| {
                let mut text = value.text.clone();
                if !value.of_domain {
                    text = format!("{text} + 0.0 * {sum}");
                }
                match points {
                    Some(point) if !value.of_points => format!("{text} + 0.0 * {point}"),
                    _ => text,
                }
            })
            .collect()
    }

    fn numbers(&self, name: &str, doc: &str, of: &dyn Fn(&FamilySteps<'_>) -> Steps) -> String {
        let spans = self.code.steps.spans();
        if spans == 1 {
            return self.numbers_on(name, doc, &of(&self.code.steps));
        }
        let t = &self.code.coordinates[0];
        let own = name.trim_start_matches('_');
        let each: Vec<String> = (0..spans).map(|span| format!("self._{own}_on_{span}")).collect();
        let lines = self.named_shapes(&inner_knots(self.code))
            + &format!("return _on_spans({t}, {}, {})\n", self.knots(), tuple(&each));
        let mut text = function(&format!("{name}(self, {t}: float) -> \"tuple[float, ...]\""), doc, &lines);
        for span in 0..spans {
            text += "\n";
            text += &self.numbers_on(&format!("_{own}_on_{span}"), "", &of(&self.code.steps.on_span(span)));
        }
        text
    }

    fn numbers_on(&self, name: &str, doc: &str, steps: &Steps) -> String {
        let expressions = body(self.code, steps, &self.language);
        let mut lines = self.shapes(steps) + &Python::lets(&expressions.lets);
        lines += &format!("return {}\n", tuple(&self.spread(&expressions.outputs, None)));
        let coordinates: Vec<String> =
            self.code.coordinates.iter().map(|name| format!("{name}: float")).collect();
        let head = format!("{name}(self, {}) -> \"tuple[float, ...]\"", coordinates.join(", "));
        function(&head, doc, &lines)
    }

    fn values(&self) -> String {
        let doc = format!("The values of {}.", self.code.listed());
        self.numbers("values", &doc, &|steps| steps.values())
    }

    fn derivatives(&self) -> Vec<String> {
        let t = &self.code.coordinates[0];
        let head = format!("derivatives(self, {t}: float, order: int = 1) -> \"tuple[float, ...]\"");
        let doc = format!("The derivatives of the functions by {t}, of order 0, 1 or 2.");
        let lines = format!(
            "if order == 1:\n    return self._derivatives_1({t})\nif order == 2:\n    return self._derivatives_2({t})\n\
             if order == 0:\n    return self.values({t})\n\
             raise ValueError(f\"the order of a derivative is 0, 1 or 2; got {{order!r}}\")\n"
        );
        vec![
            function(&head, &doc, &lines),
            self.numbers("_derivatives_1", "", &|steps| steps.derivatives(&[1])),
            self.numbers("_derivatives_2", "", &|steps| steps.derivatives(&[2])),
        ]
    }

    /// A choice by orders of derivatives, and the error for others.
    fn choice(&self, of: &str, arguments: &str, first: &str) -> String {
        let zeros = order_tuple(&vec![0; self.code.family.domain.len()]);
        let mut lines = format!("orders = tuple(orders)\nif orders == {zeros}:\n    return {first}\n");
        for orders in self.code.orders() {
            let (text, name) = (order_tuple(&orders), suffix(&orders));
            lines += &format!(
                "if orders == {text}:\n    return {}\n",
                of.replace("{}", &name).replace("()", arguments)
            );
        }
        lines + "raise ValueError(f\"the orders of a partial derivative sum to at most 2; got {orders!r}\")\n"
    }

    fn partials(&self) -> Vec<String> {
        let code = self.code;
        let names = code.coordinates.join(", ");
        let typed: Vec<String> = code.coordinates.iter().map(|name| format!("{name}: float")).collect();
        let head = format!("partials(self, {}, orders) -> \"tuple[float, ...]\"", typed.join(", "));
        let doc = format!(
            "The partial derivatives of the functions, `orders` in {}, with a sum of at most 2.",
            code.independent().join(", ")
        );
        let choice =
            self.choice("self._partials{}()", &format!("({names})"), &format!("self.values({names})"));
        let mut parts = vec![function(&head, &doc, &choice)];
        for orders in code.orders() {
            let name = format!("_partials{}", suffix(&orders));
            parts.push(self.numbers(&name, "", &|steps| steps.derivatives(&orders)));
        }
        parts
    }

    fn bind(&self) -> String {
        let code = self.code;
        let steps = code.steps.bind();
        let expressions = body(code, &steps, &self.language);
        let points: Vec<String> = (0..code.count()).map(|k| format!("P{k}")).collect();
        let outputs: Vec<String> = expressions
            .outputs
            .iter()
            .map(
                |value| {
                    if value.of_points { value.text.clone() } else { format!("{} + 0.0 * P0", value.text) }
                },
            )
            .collect();
        let lines =
            self.shapes(&steps) + &Python::lets(&expressions.lets) + &format!("return {}\n", tuple(&outputs));
        let kind = if code.is_curve() { "curve" } else { "patch" };
        let doc = format!(
            "The {kind} with {} control points: numbers, arrays of components, or tuples of components.",
            code.count()
        );
        let name = self.curve_name();
        function(
            &format!("bind(self, points) -> \"{name}\""),
            &doc,
            &format!("return {name}(self, points)\n"),
        ) + "\n"
            + &function(&format!("_bind(self, {})", points.join(", ")), "", &lines)
    }

    /// The class of what is bound.
    fn bound(&self) -> String {
        let code = self.code;
        let count = code.count();
        let doc = format!("Control points that are bound to a family `{}`.", code.name);
        let init = format!(
            "points = list(points)\nif len(points) != {count}:\n    \
             raise ValueError(f\"{}: {count} control points are needed; got {{len(points)}}\")\n\
             self.family = family\nself.points = points\nself.bound = _combine(family._bind, points)\n",
            code.name
        );
        let mut parts =
            vec![function(&format!("__init__(self, family: {}, points) -> None", code.name), "", &init)];
        let coordinates: Vec<String> = code.coordinates.iter().map(|name| format!("{name}: float")).collect();
        let (names, typed) = (code.coordinates.join(", "), coordinates.join(", "));
        let own = self.curve_name();
        let shapes: String = self.point_shapes().iter().map(|name| format!(", self.family.{name}")).collect();
        let call = |name: &str| format!("_evaluate(_{own}{name}, self.bound, {names}{shapes})");
        let arrays =
            "for arrays of coordinates an array of points, whose last axis is that of the components";
        let mut functions = Vec::new();
        if code.is_curve() {
            let t = &code.coordinates[0];
            parts.push(function(
                &format!("eval(self, {typed})"),
                &format!("The point at {t}; {arrays}."),
                &format!("return {}[0]\n", call("_point")),
            ));
            parts.push(function(
                &format!("eval_with_derivatives(self, {typed})"),
                &format!("The point at {t} and the first and second derivatives by {t}."),
                &format!("return {}\n", call("_derivatives")),
            ));
            functions.extend(self.evaluator("_point", &|steps| steps.curve(1)));
            functions.extend(self.evaluator("_derivatives", &|steps| steps.curve(3)));
        } else {
            parts.push(function(
                &format!("eval(self, {typed})"),
                &format!("The point of the patch; {arrays}."),
                &format!("return {}[0]\n", call("_point")),
            ));
            let choice = self.choice(
                &format!("_evaluate(_{own}{{}}, self.bound, {names})[0]"),
                "()",
                &format!("self.eval({names})"),
            );
            let independent = code.independent().join(", ");
            parts.push(function(
                &format!("partial(self, {typed}, orders)"),
                &format!(
                    "A partial derivative of the patch, `orders` in {independent}, with a sum of at most 2."
                ),
                &choice,
            ));
            let zeros = vec![0; code.family.domain.len()];
            functions.extend(self.evaluator("_point", &|steps| steps.patch(&zeros)));
            for orders in code.orders() {
                functions.extend(self.evaluator(&suffix(&orders), &|steps| steps.patch(&orders)));
            }
        }
        let class =
            format!("class {own}:\n{}", indented(&(docstring(&doc) + "\n" + &parts.join("\n")), "    "));
        class + "\n\n" + &functions.join("\n\n")
    }

    /// A function of bound coefficients and coordinates.
    fn evaluator(&self, name: &str, of: &dyn Fn(&FamilySteps<'_>) -> Option<Steps>) -> Option<String> {
        let code = self.code;
        let first = of(&code.steps)?;
        let mut arguments: Vec<String> = (0..code.steps.bound()).map(|k| format!("B{k}")).collect();
        arguments.extend(code.coordinates.iter().cloned());
        arguments.extend(self.point_shapes());
        let (name, arguments) = (format!("_{}{name}", self.curve_name()), arguments.join(", "));
        let on = |name: &str, steps: &Steps| {
            let expressions = body(code, steps, &self.language);
            let lines = Python::lets(&expressions.lets)
                + &format!("return {}\n", tuple(&self.spread(&expressions.outputs, Some("B0"))));
            function(&format!("{name}({arguments})"), "", &lines)
        };
        let spans = code.steps.spans();
        if spans == 1 {
            return Some(on(&name, &first));
        }
        let mut parts = Vec::new();
        let mut calls = Vec::new();
        let t = &code.coordinates[0];
        for span in 0..spans {
            let own = format!("{name}_on_{span}");
            parts.push(on(&own, &of(&code.steps.on_span(span))?));
            calls.push(format!("lambda {t}: {own}({arguments})"));
        }
        let lines = format!("return _on_spans({t}, {}, {})\n", self.knots(), tuple(&calls));
        parts.push(function(&format!("{name}({arguments})"), "", &lines));
        Some(parts.join("\n\n"))
    }

    fn continuations(&self) -> Vec<String> {
        let after = self.continuation("curve_after", true);
        let before = self.continuation("curve_before", false);
        [after, before].into_iter().flatten().collect()
    }

    fn continuation(&self, name: &str, at_start: bool) -> Option<String> {
        let code = self.code;
        let all = code.steps.ends(2, at_start);
        if all.is_empty() {
            return None;
        }
        let mut lines = String::new();
        let orders: Vec<String> = all.iter().map(|end| (end.positions.len() - 1).to_string()).collect();
        lines += &format!(
            "if order not in {}:\n    raise ValueError(f\"the order of contact is {}; got {{order!r}}\")\n",
            tuple(&orders),
            orders.join(", ")
        );
        let last = if at_start { "True" } else { "False" };
        lines += &format!(
            "derivatives, points = _end(curve, {last}, order, f, c, list(points), {})\n",
            code.count()
        );
        let solvers: Vec<String> =
            orders.iter().map(|order| format!("{order}: self._{name}_{order}")).collect();
        lines += &format!("solve = {{{}}}[order]\n", solvers.join(", "));
        lines += "solved = _finite(list(_combine(solve, derivatives + points)))\n";
        lines += &format!("return {}(self, solved)\n", self.curve_name());
        let (side, which) = if at_start {
            ("continues `curve` where that ends", "first")
        } else {
            ("ends where `curve` starts", "last")
        };
        let doc = format!(
            "The curve Q that {side}: Q = P, Q' = P'/f, Q'' = (P'' - c Q')/f^2 up to `order`. The {which} order + 1 of `points` \
             are computed and may be None; `curve` is of any family."
        );
        let head = format!(
            "{name}(self, curve, points, order: int = 1, f: float = 1.0, c: float = 0.0) -> \"{}\"",
            self.curve_name()
        );
        let mut text = function(&head, &doc, &lines);
        for end in &all {
            text += "\n";
            text += &self.end(name, end);
        }
        Some(text)
    }

    fn end(&self, name: &str, end: &EndSteps) -> String {
        let code = self.code;
        let order = end.positions.len() - 1;
        let expressions = body(code, &end.steps, &self.language);
        let mut lines = self.shapes(&end.steps);
        let (solved, divisors) = expressions.outputs.split_at(end.positions.len());
        // Before the first quotient by it: Python's own division by zero is another error.
        let checks = |name: Option<&str>| -> String {
            let all = divisors.iter().zip(&end.undetermined).filter(|(divisor, _)| {
                let own = divisor.text.trim_start_matches('-');
                match name {
                    Some(name) => own == name,
                    None => expressions.lets.iter().all(|(name, _)| own != name),
                }
            });
            all.map(|(divisor, at)| {
                let of = &code.name;
                let message = quoted(&format!("{of}: the derivatives do not determine the points at {at}"));
                format!("_check({message}, {0}, {0} != 0.0)\n", divisor.text)
            })
            .collect()
        };
        lines += &checks(None);
        for (name, value) in &expressions.lets {
            lines += &format!("{name} = {}\n", value.text);
            lines += &checks(Some(name));
        }
        let points: Vec<String> = (0..code.count())
            .map(|k| match end.positions.iter().position(|position| *position == k) {
                Some(place) => solved[place].text.clone(),
                None => format!("P{k}"),
            })
            .collect();
        lines += &format!("return {}\n", tuple(&points));
        let arguments =
            (0..=order).map(|k| format!("D{k}")).chain((0..code.count()).map(|k| format!("P{k}")));
        let arguments: Vec<String> = arguments.collect();
        function(&format!("_{name}_{order}(self, {})", arguments.join(", ")), "", &lines)
    }
}

/// Orders of derivatives as a tuple.
fn order_tuple(orders: &[usize]) -> String {
    tuple(&orders.iter().map(ToString::to_string).collect::<Vec<_>>())
}

/// Orders of derivatives in a name: `_1_0`.
fn suffix(orders: &[usize]) -> String {
    orders.iter().map(|order| format!("_{order}")).collect()
}

//! WGSL and GLSL: functions to paste into a shader, and for WGSL a compute kernel.
//!
//! Both compute with single floats. A point is a `vec4`, of which a caller uses as many components as points have. There
//! are no errors on a graphics processor: `Bell_check` says whether shape values may be used.

use super::write::{body, bound_text, indented, inside, join_body, member, slashes};
use super::{Expressions, FamilyCode, JoinCode, Language, Shape, Value, decimal_f32, is_input};
use crate::algebra::rational::Rational;
use crate::diagnostic::Diagnostic;
use crate::steps::{EndSteps, Step, Steps};

/// A language of shaders.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shader {
    /// The WebGPU shading language.
    Wgsl,
    /// The OpenGL shading language, from 3.30 or ES 3.00.
    Glsl,
}

/// Keywords and reserved words of WGSL, its types and builtin functions that the code uses, and names of the file.
const WGSL: &str = "alias break case const const_assert continue continuing default diagnostic discard else enable \
    false fn for if let loop override requires return struct switch true var while NULL Self abstract active alignas \
    alignof as asm asm_fragment async attribute auto await become cast catch class co_await co_return co_yield coherent \
    column_major common compile compile_fragment concept const_cast consteval constexpr constinit crate debugger decltype \
    delete demote demote_to_helper do dynamic_cast enum explicit export extends extern external fallthrough filter final \
    finally friend from fxgroup get goto groupshared highp impl implements import inline instanceof interface layout lowp \
    macro macro_rules match mediump meta mod module move mut mutable namespace new nil noexcept noinline nointerpolation \
    non_coherent noncoherent noperspective null nullptr of operator package packoffset partition pass patch pixelfragment \
    precise precision premerge priv protected pub public readonly ref regardless register reinterpret_cast require \
    resource restrict self set shared sizeof smooth snorm static static_assert static_cast std subroutine super target \
    template this thread_local throw trait try type typedef typeid typename typeof union unless unorm unsafe unsized use \
    using varying virtual volatile wgsl where with writeonly yield \
    array bool f16 f32 i32 u32 vec2 vec3 vec4 vec2f vec3f vec4f mat2x2 mat3x3 mat4x4 atomic ptr sampler bitcast abs all \
    any arrayLength ceil clamp cos cross cosh degrees determinant distance dot exp exp2 floor fma fract frexp ldexp length \
    log log2 max min mix modf normalize pow quantizeToF16 radians reflect refract round saturate select sign sin sinh \
    smoothstep sqrt step tan tanh transpose trunc acos asin atan atan2 acosh asinh atanh";

/// Keywords and reserved words of GLSL, and builtin functions.
const GLSL: &str = "attribute const uniform varying buffer shared coherent volatile restrict readonly writeonly layout \
    centroid flat smooth noperspective patch sample invariant precise break continue do for while switch case default if \
    else subroutine in out inout int void bool true false float double discard return vec2 vec3 vec4 ivec2 ivec3 ivec4 \
    bvec2 bvec3 bvec4 uint uvec2 uvec3 uvec4 dvec2 dvec3 dvec4 mat2 mat3 mat4 lowp mediump highp precision struct common \
    partition active asm class union enum typedef template this resource goto inline noinline public static extern \
    external interface long short half fixed unsigned superp input output hvec2 hvec3 hvec4 fvec2 fvec3 fvec4 filter \
    sizeof cast namespace using sampler1D sampler2D sampler3D samplerCube image1D image2D main abs acos acosh all any asin \
    asinh atan atanh ceil clamp cos cosh cross dFdx dFdy degrees determinant distance dot equal exp exp2 faceforward floor \
    fma fract frexp fwidth inverse inversesqrt isinf isnan ldexp length lessThan log log2 matrixCompMult max min mix mod \
    modf noise1 normalize not notEqual outerProduct pow radians reflect refract round roundEven sign sin sinh smoothstep \
    sqrt step tan tanh texture transpose trunc mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 NULL";

/// Stands for the end of a range that has none.
const UNBOUNDED: &str = "UNBOUNDED";

/// Names inside of the functions.
const OWN: &str = "points bound derivatives f c inverse_f id at result";

impl Shader {
    const fn float(self) -> &'static str {
        if matches!(self, Self::Wgsl) { "f32" } else { "float" }
    }

    const fn vector(self) -> &'static str {
        if matches!(self, Self::Wgsl) { "vec4f" } else { "vec4" }
    }

    /// The type of an array.
    fn array(self, of: &str, count: usize) -> String {
        if self == Self::Wgsl { format!("array<{of}, {count}>") } else { format!("{of}[{count}]") }
    }

    /// A parameter.
    fn argument(self, name: &str, of: &str) -> String {
        if self == Self::Wgsl { format!("{name}: {of}") } else { format!("{of} {name}") }
    }

    /// An array of values.
    fn list(self, of: &str, values: &[String]) -> String {
        let head = self.array(of, values.len());
        let line = format!("{head}({})", values.join(", "));
        if line.len() <= 90 {
            return line;
        }
        let lines: Vec<String> = values.iter().map(|value| format!("    {value}")).collect();
        format!("{head}(\n{}\n)", lines.join(",\n"))
    }

    fn function(self, name: &str, arguments: &[String], result: &str, lines: &str) -> String {
        let arguments = arguments.join(", ");
        let head = match self {
            Self::Wgsl => format!("fn {name}({arguments}) -> {result}"),
            Self::Glsl => format!("{result} {name}({arguments})"),
        };
        format!("{head} {{\n{}}}\n", indented(lines, "    "))
    }

    /// Named values.
    fn lets(self, expressions: &Expressions) -> String {
        let one = |(name, value): &(String, Value)| match (self, value.of_points) {
            (Self::Wgsl, _) => format!("let {name} = {};\n", value.text),
            (Self::Glsl, true) => format!("vec4 {name} = {};\n", value.text),
            (Self::Glsl, false) => format!("float {name} = {};\n", value.text),
        };
        expressions.lets.iter().map(one).collect()
    }

    /// A named value that is not one of the steps.
    fn named(self, name: &str, of: &str, value: &str) -> String {
        match self {
            Self::Wgsl => format!("let {name} = {value};\n"),
            Self::Glsl => format!("{of} {name} = {value};\n"),
        }
    }

    fn constant(self, name: &str, of: &str, value: &str) -> String {
        match self {
            Self::Wgsl => format!("const {name}: {of} = {value};\n"),
            Self::Glsl => format!("const {of} {name} = {value};\n"),
        }
    }

    fn signed(self, value: &Rational) -> String {
        let sign = if value.is_negative() { "-" } else { "" };
        format!("{sign}{}", self.literal(&value.abs()))
    }

    /// Results as vectors: one that depends on no point is the same in all components.
    fn vectors(self, values: &[Value]) -> Vec<String> {
        let vector = |value: &Value| {
            if value.of_points { value.text.clone() } else { format!("{}({})", self.vector(), value.text) }
        };
        values.iter().map(vector).collect()
    }

    /// Whether a value is in its range and finite: by its bits, because a compiler may assume that there is no NaN.
    fn is_valid(self, shape: &Shape<'_>) -> String {
        let bits = match self {
            Self::Wgsl => format!("(bitcast<u32>({}) & 0x7f800000u) != 0x7f800000u", shape.name),
            Self::Glsl => format!("(floatBitsToUint({}) & 0x7f800000u) != 0x7f800000u", shape.name),
        };
        let inside = inside(shape, &self, "&&", ("<=", UNBOUNDED));
        let kept = inside.split(" && ").filter(|part| !part.ends_with(UNBOUNDED));
        kept.chain([bits.as_str()]).collect::<Vec<_>>().join(" && ")
    }

    /// The function that says whether scalars may be used.
    fn check(self, name: &str, shapes: &[Shape<'_>], assumptions: &[(String, String)]) -> String {
        let arguments: Vec<String> = shapes.iter().map(|s| self.argument(&s.name, self.float())).collect();
        let mut all: Vec<String> = shapes.iter().map(|shape| self.is_valid(shape)).collect();
        let lets: String = assumptions.iter().map(|(lets, _)| lets.as_str()).collect();
        all.extend(assumptions.iter().map(|(_, condition)| condition.clone()));
        let lines = format!("{lets}return {};\n", all.join("\n    && "));
        let ranges: Vec<String> = shapes.iter().map(|shape| shape.shown.clone()).collect();
        let about = format!(
            "Whether the values are finite and satisfy {}; no others may be used.",
            ranges.join(", ")
        );
        slashes(&[about]) + &self.function(&member(name, "check"), &arguments, "bool", &lines)
    }

    /// Whether steps divide by something that is no power of two, for which a graphics processor may be less exact.
    fn divides(steps: &Steps) -> bool {
        steps.steps.iter().any(|step| match step {
            Step::Div(_, b) => !matches!(&steps.steps[*b], Step::Constant(value) if is_power_of_two(value)),
            _ => false,
        })
    }
}

fn is_power_of_two(value: &Rational) -> bool {
    let part = |n: Option<i64>| n.is_some_and(|n| n > 0 && n.count_ones() == 1);
    part(value.numer().to_i64()) && part(value.denom().to_i64())
}

impl Language for Shader {
    fn comment(&self, lines: &[String]) -> String {
        slashes(lines)
    }

    fn literal(&self, value: &Rational) -> String {
        let text = decimal_f32(value);
        if *self == Self::Wgsl { text + "f" } else { text }
    }

    fn is_single(&self) -> bool {
        true
    }

    fn is_reserved(&self, name: &str) -> bool {
        let words = if *self == Self::Wgsl { WGSL } else { GLSL };
        is_input(name)
            || name == "_"
            || name.starts_with("__")
            || name.starts_with("gl_")
            || words.split_whitespace().chain(OWN.split_whitespace()).any(|word| word == name)
    }

    fn free(&self, name: &str, taken: &[String]) -> String {
        let mut name = crate::generate::ascii(name);
        // Two in a row are reserved in GLSL.
        while name.contains("__") {
            name = name.replace("__", "_");
        }
        while self.is_reserved(&name) || taken.contains(&name) {
            name.push(if name.ends_with('_') { 'x' } else { '_' });
        }
        name
    }

    fn family(&self, code: &FamilyCode<'_>) -> Result<String, Diagnostic> {
        Ok(Functions { code, language: *self }.whole())
    }

    fn join(&self, join: &JoinCode<'_>) -> Result<String, Diagnostic> {
        let vector = self.vector();
        let expressions = join_body(join, self);
        let mut arguments: Vec<String> = Vec::new();
        for net in &join.points {
            let of = if net.single { vector.to_string() } else { self.array(vector, net.labels.len()) };
            arguments.push(self.argument(&net.name, &of));
        }
        arguments.extend(join.scalars.iter().map(|scalar| self.argument(&scalar.name, self.float())));
        let mut lines = String::new();
        for (k, (net, place)) in join.given.iter().enumerate() {
            let net = &join.points[*net];
            let value = if net.single { net.name.clone() } else { format!("{}[{place}]", net.name) };
            lines += &self.named(&format!("P{k}"), vector, &value);
        }
        lines += &self.lets(&expressions);
        let outputs = self.vectors(&expressions.outputs);
        lines += &format!("return {};\n", self.list(vector, &outputs));
        let labels: Vec<String> = join.results.iter().flat_map(|net| net.labels.clone()).collect();
        let nets: Vec<String> = join
            .points
            .iter()
            .filter(|net| !net.single)
            .map(|net| format!("`{}` has {}", net.name, net.labels.join(", ")))
            .collect();
        let about = [format!("The control points {}. {}", labels.join(", "), nets.join("; "))];
        let function = self.function(&join.name, &arguments, &self.array(vector, outputs.len()), &lines);
        let check = if join.scalars.is_empty() {
            String::new()
        } else {
            self.check(&join.name, &join.scalars, &[]) + "\n"
        };
        Ok(check + &slashes(&about) + &function)
    }

    fn file(&self, header: &str, items: &[String]) -> String {
        let about = match self {
            Self::Wgsl => [
                "The bounds of rounding errors hold as long as nothing overflows or underflows. WGSL lets an implementation",
                "reassociate and fuse operations only where that is at least as accurate; its quotients may be wrong by 2.5",
                "units in the last place, which is said where it matters.",
            ],
            Self::Glsl => [
                "The bounds of rounding errors hold as long as nothing overflows or underflows and operations are rounded as",
                "IEEE 754 says. GLSL lets a compiler reassociate: declare what you compute from these functions `precise`",
                "where the version has it. Use highp in ES.",
            ],
        };
        let mut text = header.to_string() + "//\n" + &slashes(&about.map(String::from));
        for item in items {
            text += "\n";
            text += item;
        }
        text
    }
}

/// A family that is being written.
struct Functions<'a> {
    code: &'a FamilyCode<'a>,
    language: Shader,
}

impl Functions<'_> {
    fn member(&self, name: &str) -> String {
        member(&self.code.name, name)
    }

    fn whole(&self) -> String {
        let (code, language) = (self.code, self.language);
        let mut parts = vec![self.constants()];
        if !code.shapes.is_empty() {
            let assumptions: Vec<(String, String)> = code
                .assumptions
                .iter()
                .map(|assumption| {
                    let expressions = body(code, &assumption.steps, &language);
                    let sign = if assumption.strict { ">" } else { ">=" };
                    let zero = language.literal(&Rational::ZERO);
                    (language.lets(&expressions), format!("{} {sign} {zero}", expressions.outputs[0].text))
                })
                .collect();
            // One assumption's names would meet another's.
            parts.push(language.check(&code.name, &code.shapes, &assumptions));
        }
        parts.push(self.numbers(
            "values",
            &format!("The values of {}.", code.listed()),
            &code.steps.values(),
        ));
        if code.is_curve() {
            let t = &code.coordinates[0];
            for (name, word, order) in [("derivatives", "first", 1), ("second_derivatives", "second", 2)] {
                let about = format!("The {word} derivatives of {} by {t}.", code.listed());
                parts.push(self.numbers(name, &about, &code.steps.derivatives(&[order])));
            }
        } else {
            for orders in code.orders() {
                let of = code.along(&orders);
                let about =
                    format!("The partial derivatives along {} of {}.", of.replace('_', ", "), code.listed());
                parts.push(self.numbers(&format!("partials_{of}"), &about, &code.steps.derivatives(&orders)));
            }
        }
        parts.push(self.bind());
        if code.is_curve() {
            let t = &code.coordinates[0];
            let point = code.steps.curve(1);
            parts.extend(
                point.map(|steps| self.evaluator("eval", &format!("The point of the curve at {t}."), &steps)),
            );
            let about = format!("The point of the curve at {t} and its first and second derivative by {t}.");
            let all = code.steps.curve(3);
            parts.extend(all.map(|steps| self.evaluator("eval_with_derivatives", &about, &steps)));
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
                parts.extend(code.steps.patch(&orders).map(|steps| self.evaluator(&name, &about, &steps)));
            }
        }
        if language == Shader::Wgsl {
            parts.push(self.kernel());
        }
        parts.join("\n")
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
            + &format!("@group(0) @binding(2) var<storage, read_write> {points}: array<vec4f>;\n\n")
            + &format!(
                "@compute @workgroup_size(64)\nfn {kernel}(@builtin(global_invocation_id) id: vec3u) {{\n"
            )
            + &format!("    if (id.x < arrayLength(&{at_name})) {{\n")
            + &format!("        {points}[id.x] = {eval}({bound}, {});\n    }}\n}}\n", at.join(", "))
    }

    fn constants(&self) -> String {
        let (code, language) = (self.code, self.language);
        let float = language.float();
        let mut text = String::new();
        for (name, (low, high)) in code.coordinates.iter().zip(code.ends()) {
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
            if Shader::divides(&code.steps.values()) {
                text += "// The functions divide: the bounds assume quotients that are rounded correctly.\n";
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

    fn numbers(&self, name: &str, about: &str, steps: &Steps) -> String {
        let language = self.language;
        let expressions = body(self.code, steps, &language);
        let outputs: Vec<String> = expressions.outputs.iter().map(|value| value.text.clone()).collect();
        let lines =
            language.lets(&expressions) + &format!("return {};\n", language.list(language.float(), &outputs));
        let arguments = [self.shapes(), self.coordinates()].concat();
        let result = language.array(language.float(), outputs.len());
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
        let expressions = body(self.code, steps, &language);
        let outputs = language.vectors(&expressions.outputs);
        let is_one = outputs.len() == 1 && name.starts_with("eval");
        let (result, value) = if is_one {
            (language.vector().to_string(), outputs[0].clone())
        } else {
            (language.array(language.vector(), outputs.len()), language.list(language.vector(), &outputs))
        };
        let lines = format!("{inputs}{}return {value};\n", language.lets(&expressions));
        slashes(&[about.to_string()]) + &language.function(&self.member(name), arguments, &result, &lines)
    }

    fn evaluator(&self, name: &str, about: &str, steps: &Steps) -> String {
        let (code, language) = (self.code, self.language);
        let count = code.steps.bound();
        let lines = self.elements("B", "bound", count);
        let bound = language.argument("bound", &language.array(language.vector(), count));
        let arguments = [vec![bound], self.coordinates()].concat();
        self.with_vectors(name, about, &arguments, steps, &lines)
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
        let others: Vec<usize> = super::write::used(&steps, super::write::point);
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

//! WGSL and GLSL: functions to paste into a shader, and for WGSL a compute kernel.
//!
//! Both compute with single floats. A point is a `vec4`, of which a caller uses as many components as points have. There
//! are no errors on a graphics processor: `Bell_check` says whether shape values may be used.

use super::write::{
    body, bound_text, condition, indented, inner_knots, inside, join_assumption, join_body, knot_text,
    member, on_spans, slashes, used_shapes,
};
use super::{Expressions, FamilyCode, JoinCode, Knot, Language, Shape, Value, decimal_f32, is_input};
use crate::algebra::rational::Rational;
use crate::diagnostic::Diagnostic;
use crate::rounding::needs_functions;
use crate::steps::{EndSteps, FamilySteps, Function, Step, Steps};

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
const OWN: &str = "points bound derivatives f c inverse_f id at result derived";

/// What the names of functions begin with that a family has of its own, until its name takes the place of it.
const HELPERS: &str = "basis_";

/// The name of a function, and what it is made of.
const fn helper(function: Function) -> (&'static str, &'static [Function]) {
    match function {
        Function::Sin => ("basis_sin", &[]),
        Function::Cos => ("basis_cos", &[]),
        Function::Tan => ("basis_tan", &[Function::Sin, Function::Cos]),
        Function::Tanh => ("basis_tanh", &[Function::Expm1]),
        Function::Expm1 => ("basis_expm1", &[]),
    }
}

/// Functions whose errors are relative, for |x| < pi; those of the languages have absolute errors.
const SERIES: [(Function, &str); 5] = [
    (
        Function::Sin,
        "LET h = 0.5 * x;
LET q = h * h;
LET s = h + h * q * (-0.16666667 + q * (0.008333334 + q * (-0.0001984127 + q * (2.7557319e-6 + q * (-2.505211e-8 + q * 1.6059044e-10)))));
LET c = 1.0 + q * (-0.5 + q * (0.041666668 + q * (-0.0013888889 + q * (2.4801588e-5 + q * (-2.755732e-7 + q * 2.0876756e-9)))));
return 2.0 * s * c;
",
    ),
    (
        Function::Cos,
        "LET h = 0.5 * x;
LET q = h * h;
LET s = h + h * q * (-0.16666667 + q * (0.008333334 + q * (-0.0001984127 + q * (2.7557319e-6 + q * (-2.505211e-8 + q * 1.6059044e-10)))));
LET c = 1.0 + q * (-0.5 + q * (0.041666668 + q * (-0.0013888889 + q * (2.4801588e-5 + q * (-2.755732e-7 + q * 2.0876756e-9)))));
return (c - s) * (c + s);
",
    ),
    (Function::Tan, "return basis_sin(x) / basis_cos(x);\n"),
    (
        Function::Expm1,
        "if (abs(x) > 0.7) {
    return exp(x) - 1.0;
}
return x + x * x * (0.5 + x * (0.16666667 + x * (0.041666668 + x * (0.008333334 + x * (0.0013888889 + x * (0.0001984127 + x * (2.4801588e-5 + x * (2.7557319e-6 + x * 2.755732e-7))))))));
",
    ),
    (
        Function::Tanh,
        "LET e = basis_expm1(2.0 * clamp(x, -20.0, 20.0));
return e / (e + 2.0);
",
    ),
];

impl Shader {
    /// The functions of [`SERIES`] that a text needs.
    fn helpers(self, text: &str) -> String {
        let calls = |function: Function| text.contains(&format!("{}(", helper(function).0));
        let all = SERIES.map(|(function, _)| function);
        let needed = |function: Function| {
            calls(function) || all.iter().any(|other| calls(*other) && helper(*other).1.contains(&function))
        };
        let mut functions = Vec::new();
        for (function, lines) in SERIES.iter().filter(|(function, _)| needed(*function)) {
            let lines = lines.replace("LET", if self == Self::Wgsl { "let" } else { "float" });
            let (name, argument) = (helper(*function).0, self.argument("x", self.float()));
            functions.push(self.function(name, &[argument], self.float(), &lines));
        }
        if functions.is_empty() {
            return String::new();
        }
        let about = [
            String::from(
                "By series, so that the error is relative, next to 0 too, for |x| < pi: that of the language's own",
            ),
            String::from("functions is absolute."),
        ];
        slashes(&about) + &functions.join("\n") + "\n"
    }

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
    fn check(
        self,
        name: &str,
        shapes: &[Shape<'_>],
        assumptions: &[(String, String)],
        texts: &[&str],
    ) -> String {
        let arguments: Vec<String> = shapes.iter().map(|s| self.argument(&s.name, self.float())).collect();
        let mut all: Vec<String> = shapes.iter().map(|shape| self.is_valid(shape)).collect();
        let mut lines = String::new();
        for (lets, condition) in assumptions {
            if lets.is_empty() {
                all.push(condition.clone());
            } else {
                // In a block: one assumption's names would meet another's.
                let inner = format!("{lets}if (!({condition})) {{\n    return false;\n}}\n");
                lines += &format!("{{\n{}}}\n", indented(&inner, "    "));
            }
        }
        lines += &format!("return {};\n", all.join("\n    && "));
        let ranges: Vec<String> = shapes
            .iter()
            .map(|shape| shape.shown.clone())
            .chain(texts.iter().map(|text| (*text).to_string()))
            .collect();
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

    fn has_accurate_functions(&self) -> bool {
        false
    }

    fn call(&self, function: Function, argument: &str) -> String {
        format!("{}({argument})", helper(function).0)
    }

    fn unless(&self, [a, b, c]: &[String; 3]) -> String {
        match self {
            Self::Wgsl => format!("select({c}, 0.0f, {a} == {b})"),
            Self::Glsl => format!("({a} == {b} ? 0.0 : {c})"),
        }
    }

    fn cut_off(&self, name: &str) -> String {
        format!("max({name}, {})", self.literal(&Rational::ZERO))
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
            || name.starts_with(HELPERS)
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
            let conditions: Vec<(String, String)> = join
                .assumptions
                .iter()
                .map(|assumption| {
                    let (expressions, condition) = join_assumption(join, assumption, self);
                    (self.lets(&expressions), condition)
                })
                .collect();
            let texts: Vec<&str> = join.assumptions.iter().map(|assumption| assumption.text).collect();
            self.check(&join.name, &join.scalars, &conditions, &texts) + "\n"
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
            let inputs: String = super::write::used(&steps, super::write::bound).iter().map(one).collect();
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

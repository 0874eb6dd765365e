//! WGSL and GLSL: functions to paste into a shader, and for WGSL a compute kernel.
//!
//! Both compute with single floats. A point is a `vec4`, of which a caller uses as many components as points have. There
//! are no errors on a graphics processor: `Bell_check` says whether shape values may be used.

mod functions;

use super::write::{indented, inside, join_assumption, join_body, member, slashes};
use super::{Expressions, FamilyCode, JoinCode, Language, Shape, Value, decimal_f32, is_input};
use crate::algebra::rational::Rational;
use crate::ascii::ascii;
use crate::diagnostic::Diagnostic;
use crate::steps::{Function, Step, Steps};
use functions::Functions;

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
        Function::InversePowerOfTwo => ("basis_inverse_power_of_two", &[]),
    }
}

/// Functions whose errors are relative, for |x| < pi; those of the languages have absolute errors.
const SERIES: [(Function, &str); 6] = [
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
    (Function::InversePowerOfTwo, "return FROM_BITS((254u - min((TO_BITS(x) >> 23u) & 255u, 253u)) << 23u);\n"),
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
            let [named, to_bits, from_bits] = match self {
                Self::Wgsl => ["let", "bitcast<u32>", "bitcast<f32>"],
                Self::Glsl => ["float", "floatBitsToUint", "uintBitsToFloat"],
            };
            let lines = lines.replace("LET", named);
            let lines = lines.replace("TO_BITS", to_bits).replace("FROM_BITS", from_bits);
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

    fn less(&self, [a, b]: &[String; 2]) -> String {
        match self {
            Self::Wgsl => format!("select(0.0f, 1.0f, {a} < {b})"),
            Self::Glsl => format!("({a} < {b} ? 1.0 : 0.0)"),
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
        let mut name = ascii(name);
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

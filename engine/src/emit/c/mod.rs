//! C as a header: C99 to C23 and C++17, without a library but for limits of floats.
//!
//! A family is a prefix of names: `Bell_values`. Shape values are checked by `Bell_init`, which fills a struct; points
//! have any number of components, `dimension`, one after the other; nothing is allocated.

mod family;

use super::write::{
    indented, inside, join_assumption, join_body, join_components, point, slashes, used, used_shapes,
};
use super::{Expressions, FamilyCode, JoinCode, Language, Shape, decimal, decimal_f32, is_input};
use crate::algebra::rational::Rational;
use crate::diagnostic::Diagnostic;
use crate::steps::Function;
use family::Family;

/// The scalar type of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scalar {
    /// `float`
    F32,
    /// `double`
    F64,
}

/// C and C++.
#[derive(Clone, Copy, Debug)]
pub struct C(pub Scalar);

/// Keywords of C and C++, macros of compilers and of the included headers, and names of the standard library that may not
/// be defined again.
const RESERVED: &str = "alignas alignof and and_eq asm auto bitand bitor bool break case catch char char8_t char16_t \
    char32_t class co_await co_return co_yield compl concept const const_cast consteval constexpr constinit continue \
    decltype default delete do double dynamic_cast else enum explicit export extern false final float for friend goto \
    if import inline int long module mutable namespace new noexcept not not_eq nullptr operator or or_eq override \
    private protected public register reinterpret_cast requires restrict return short signed sizeof static \
    static_assert static_cast struct switch template this thread_local throw true try typedef typeid typename typeof \
    typeof_unqual union unsigned using virtual void volatile wchar_t while xor xor_eq \
    unix linux i386 near far small interface I NULL NAN INFINITY HUGE_VAL EOF errno assert stdin stdout stderr main \
    size_t ptrdiff_t max_align_t offsetof float_t double_t div ldiv abs labs exp exp2 log log2 log10 log1p logb pow \
    sqrt cbrt sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh floor ceil round trunc rint fabs fmod fma \
    fmin fmax fdim frexp ldexp modf hypot erf erfc tgamma lgamma gamma nan signbit isnan isinf isfinite isnormal \
    isgreater isless fpclassify j0 j1 jn y0 y1 yn drem scalb significand remainder remquo copysign nextafter \
    nexttoward ilogb lrint llrint lround llround scalbn scalbln nearbyint expm1 time clock signal index rindex rand \
    uint ushort ulong quad random srandom drand48 select alloca atof atoi atol atoll strtod a64l l64a ecvt fcvt gcvt \
    mktemp mkstemp mkdtemp putenv setenv unsetenv clearenv realpath rpmatch signgam pow10 sincos canonicalize \
    fromfp ufromfp roundeven nextup nextdown llogb fmaxmag fminmag totalorder getpayload setpayload isunordered \
    issignaling issubnormal iszero iseqsig RAND_MAX MB_CUR_MAX BIG_ENDIAN LITTLE_ENDIAN BYTE_ORDER \
    DOMAIN SING OVERFLOW UNDERFLOW PLOSS TLOSS MAXFLOAT X_TLOSS \
    free malloc calloc realloc exit abort atexit getenv system qsort bsearch \
    family dimension points bound values derivatives point at count order f c axis row inverse result wrong low high";

impl C {
    const fn scalar(self) -> &'static str {
        match self.0 {
            Scalar::F32 => "float",
            Scalar::F64 => "double",
        }
    }

    /// The prefix of the macros that tell about the type.
    const fn limits(self) -> &'static str {
        match self.0 {
            Scalar::F32 => "FLT",
            Scalar::F64 => "DBL",
        }
    }

    fn signed(self, value: &Rational) -> String {
        let sign = if value.is_negative() { "-" } else { "" };
        format!("{sign}{}", self.literal(&value.abs()))
    }

    fn finite(self, shape: &Shape<'_>) -> String {
        inside(shape, &self, "&&", ("<=", &format!("{}_MAX", self.limits())))
    }
}

impl Language for C {
    fn comment(&self, lines: &[String]) -> String {
        slashes(lines)
    }

    fn literal(&self, value: &Rational) -> String {
        match self.0 {
            Scalar::F32 => decimal_f32(value) + "f",
            Scalar::F64 => decimal(value),
        }
    }

    fn call(&self, function: Function, argument: &str) -> String {
        let suffix = if self.0 == Scalar::F32 { "f" } else { "" };
        let name = match function {
            Function::InversePowerOfTwo => {
                let one = self.literal(&Rational::ONE);
                let least = format!("{}_MIN", self.limits());
                return format!(
                    "({one} / fmax{suffix}(scalbn{suffix}({one}, ilogb{suffix}({argument})), {least}))"
                );
            }
            Function::Sin => "sin",
            Function::Cos => "cos",
            Function::Tan => "tan",
            Function::Tanh => "tanh",
            Function::Expm1 => "expm1",
        };
        format!("{name}{suffix}({argument})")
    }

    fn unless(&self, [a, b, c]: &[String; 3]) -> String {
        format!("({a} == {b} ? {} : {c})", self.literal(&Rational::ZERO))
    }

    fn less(&self, [a, b]: &[String; 2]) -> String {
        let [one, zero] = [Rational::ONE, Rational::ZERO].map(|x| self.literal(&x));
        format!("({a} < {b} ? {one} : {zero})")
    }

    fn cut_off(&self, name: &str) -> String {
        let zero = self.literal(&Rational::ZERO);
        format!("({name} < {zero} ? {zero} : {name})")
    }

    fn is_single(&self) -> bool {
        self.0 == Scalar::F32
    }

    fn is_reserved(&self, name: &str) -> bool {
        // Macros of the headers, and types of those that C++ includes with them; none of them ends with `_`.
        let of_headers =
            ["FLT_", "DBL_", "LDBL_", "DECIMAL_", "M_", "FP_", "HUGE_", "MATH_", "math_err", "SNAN"];
        let reserved_prefix = name.starts_with("__")
            || (name.starts_with('_') && name[1..].starts_with(|c: char| c.is_ascii_uppercase()))
            || of_headers.iter().any(|prefix| name.starts_with(prefix) && !name.ends_with('_'))
            || name.ends_with("_t");
        reserved_prefix || is_input(name) || RESERVED.split_whitespace().any(|word| word == name)
    }

    fn family(&self, code: &FamilyCode<'_>) -> Result<String, Diagnostic> {
        Ok(Family { code, language: *self }.whole())
    }

    fn join(&self, join: &JoinCode<'_>) -> Result<String, Diagnostic> {
        let t = self.scalar();
        let mut arguments = vec![String::from("size_t dimension")];
        arguments.extend(join.points.iter().map(|net| format!("const {t} *{}", net.name)));
        arguments.extend(join.scalars.iter().map(|scalar| format!("{t} {}", scalar.name)));
        arguments.extend(join.results.iter().map(|net| format!("{t} *{}", net.name)));
        let mut about = Vec::new();
        for net in &join.points {
            about.push(format!("`{}`: the control points {}.", net.name, net.labels.join(", ")));
        }
        for scalar in &join.scalars {
            about.push(format!("`{}`: {}. {}", scalar.name, scalar.condition, scalar.doc.join(" ")));
        }
        for net in &join.results {
            about.push(format!("`{}` becomes {}.", net.name, net.labels.join(", ")));
        }
        about.push(String::from(
            "Points have `dimension` components, one after the other. Returns 0; k when the k-th scalar is outside of its",
        ));
        about.push(String::from("range, infinite or NaN; -1 when a computed point is not finite."));
        for (k, assumption) in join.assumptions.iter().enumerate() {
            let code = join.scalars.len() + k + 1;
            about.push(format!("Returns {code} when the scalars do not satisfy {}.", assumption.text));
        }
        let mut lines = String::new();
        let expressions = join_body(join, self);
        lines += "int result = 0;\n";
        for (k, scalar) in join.scalars.iter().enumerate() {
            lines += &format!("if (!({})) return {};\n", self.finite(scalar), k + 1);
        }
        for (k, assumption) in join.assumptions.iter().enumerate() {
            let (expressions, condition) = join_assumption(join, assumption, self);
            let code = join.scalars.len() + k + 1;
            let inner = self.scalar_lets(&expressions) + &format!("if (!({condition})) return {code};\n");
            lines += &format!("{{\n{}}}\n", indented(&inner, "    "));
        }
        for unused in unused_scalars(join) {
            lines += &format!("(void){unused};\n");
        }
        let (inputs, outputs) = join_components(join, element, element);
        let unused: Vec<String> = (0..join.points.len())
            .filter(|net| used(&join.steps.steps, point).iter().all(|k| join.given[*k].0 != *net))
            .map(|net| join.points[net].name.clone())
            .collect();
        lines += &unused.iter().map(|name| format!("(void){name};\n")).collect::<String>();
        lines += &self.on_components(&expressions, &inputs, &outputs, Check::Finite);
        lines += "return result;\n";
        Ok(slashes(&about) + &function(&format!("int {}", join.name), &arguments, &lines))
    }

    fn file(&self, header: &str, items: &[String]) -> String {
        let all = items.concat();
        let names: Vec<&str> = all
            .lines()
            .filter_map(|line| line.strip_prefix("#define ")?.split_once("_FUNCTIONS ").map(|(name, _)| name))
            .collect();
        let digest = super::rust::digest((header.to_string() + &all).as_bytes());
        let guard = format!("BASIS_{}_{digest:016X}_H", names.first().copied().unwrap_or("JOINS"));
        let guard = guard.replace("__", "_");
        let mut text = format!("{header}\n#ifndef {guard}\n#define {guard}\n");
        text += "
// Reassociated or reciprocal arithmetic voids the bounds of rounding errors, and NaN is what the checks look for.
#if defined(__FAST_MATH__) || defined(_M_FP_FAST) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error \"compile without -ffast-math, /fp:fast and their parts\"
#endif
#if defined(__FINITE_MATH_ONLY__)
#if __FINITE_MATH_ONLY__
#error \"compile without -ffinite-math-only\"
#endif
#endif

#include <float.h>
#include <math.h>
#include <stddef.h>
";
        for item in items {
            text += "\n";
            text += item;
        }
        text + &format!("\n#endif // {guard}\n")
    }
}

/// The scalars of a join that no step uses, which a compiler would warn of.
fn unused_scalars(join: &JoinCode<'_>) -> Vec<String> {
    let used = used_shapes(&join.steps.steps);
    // All are compared with their ranges.
    (0..join.scalars.len()).filter(|k| !used.contains(k)).map(|k| join.scalars[k].name.clone()).collect()
}

/// The component of the point number `place` of an array.
fn element(array: &str, place: usize) -> String {
    match place {
        0 => format!("{array}[axis]"),
        1 => format!("{array}[dimension + axis]"),
        _ => format!("{array}[{place} * dimension + axis]"),
    }
}

/// A function with its arguments and the lines of its body.
fn function(head: &str, arguments: &[String], lines: &str) -> String {
    let whole = format!("static inline {head}({})", arguments.join(", "));
    let head = if whole.len() <= 100 {
        whole
    } else {
        let separate: Vec<String> = arguments.iter().map(|argument| format!("\n    {argument}")).collect();
        format!("static inline {head}({})", separate.join(","))
    };
    format!("{head}\n{{\n{}}}\n", indented(lines, "    "))
}

/// What is asked of the results of a loop over components.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Check {
    /// Nothing.
    Nothing,
    /// `result` becomes -1 where one is not finite.
    Finite,
}

impl C {
    /// The named values that are the same for all components.
    fn scalar_lets(self, expressions: &Expressions) -> String {
        let lets = expressions.lets.iter().filter(|(_, value)| !value.of_points);
        lets.map(|(name, value)| format!("const {} {name} = {};\n", self.scalar(), value.text)).collect()
    }

    /// A loop over the components of points: inputs as names with their values, and where the results go.
    fn on_components(
        self,
        expressions: &Expressions,
        inputs: &[(String, String)],
        outputs: &[String],
        check: Check,
    ) -> String {
        let t = self.scalar();
        let mut lines = String::new();
        for (name, value) in inputs {
            lines += &format!("const {t} {name} = {value};\n");
        }
        for (name, value) in expressions.lets.iter().filter(|(_, value)| value.of_points) {
            lines += &format!("const {t} {name} = {};\n", value.text);
        }
        for (place, value) in outputs.iter().zip(&expressions.outputs) {
            lines += &format!("{place} = {};\n", value.text);
        }
        if check == Check::Finite {
            for place in outputs {
                let largest = format!("{}_MAX", self.limits());
                lines += &format!("if (!({place} >= -{largest} && {place} <= {largest})) result = -1;\n");
            }
        }
        let head = "for (size_t axis = 0; axis < dimension; axis++) {\n";
        format!("{}{head}{}}}\n", self.scalar_lets(expressions), indented(&lines, "    "))
    }
}

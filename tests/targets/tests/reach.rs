//! Shape values with whose exponentials floats would overflow are refused, and up to there nothing does.

use std::fmt::Write as _;

use basis_engine::Source;
use basis_engine::algebra::rational::{Rational, ToFloat as _};
use basis_engine::emit::Language;
use basis_engine::emit::c::{C, Scalar};
use basis_engine::emit::python::Python;
use basis_tests_targets::{Case, Floats, case_of, has, run, write};

/// Denominators that fall like different powers of an exponential, and one on both sides of 0; numbers such as exp(300) as common
/// factors; two parameters.
const FAMILIES: &str = "
family Two { shape 0 < α; domain 0 <= t <= α;
    b[0] = (cosh(α - t) - 1)/(cosh(α) - 1); b[1] = 1 - b[0] - b[2]; b[2] = (cosh(t) - 1)/(cosh(α) - 1); }
family Six { shape 0 < α; domain 0 <= t <= α;
    b[i] = binomial(6, i)*((exp(t) - 1)/(exp(α) - 1))^i*((exp(α) - exp(t))/(exp(α) - 1))^(6 - i) for i in 0..=6; }
family Middle { shape 0 < α; domain -α <= t <= α;
    b[0] = (exp(α) - exp(t))/(exp(α) - exp(-α)); b[1] = (exp(t) - exp(-α))/(exp(α) - exp(-α)); }
family Ending { shape 0 < α <= 300; domain 0 <= t <= α;
    b[0] = (exp(α) - exp(t))/(exp(α) - 1); b[1] = (exp(t) - 1)/(exp(α) - 1); }
family Rational { shape 0 < α, 0 < β; domain 0 <= t <= α;
    b[0] = sinh(α - t)/(sinh(α - t) + exp(β)*sinh(t)); b[1] = 1 - b[0]; }
family Pair { shape 0 < α, 0 < β; domain 0 <= t <= 1;
    b[0] = (1 - t)*exp(-β)/(t + exp(-2*α) + exp(-β)); b[1] = (t + exp(-2*α) + t*exp(-β))/(t + exp(-2*α) + exp(-β)); }
family Lifted { shape 0 < α, 0 <= λ <= 1; domain 0 <= t <= 1;
    b[0] = exp(-α)/(λ*(1 - t) + t + exp(-α)); b[1] = (λ*(1 - t) + t)/(λ*(1 - t) + t + exp(-α)); }
family Steep { shape 0 < α; domain 0 <= t <= 1; b[0] = 1/(t + exp(-α)); b[1] = (t + exp(-α) - 1)/(t + exp(-α)); }
family Logistic { shape k; domain 0 <= t <= 1;
    b[0] = (1 - t)/(exp(k)*t + 1 - t); b[1] = exp(k)*t/(exp(k)*t + 1 - t); }
family Quick { shape 0 < α <= 1/1000; domain 0 <= t <= α;
    b[0] = sinh(50000*t)/sinh(50000*α); b[1] = (sinh(50000*α) - sinh(50000*t))/sinh(50000*α); }
";

/// The shape values of a case, and others that are refused.
struct Ends {
    /// All at their ends.
    inside: Vec<Vec<f64>>,
    /// One of them beyond it.
    outside: Vec<Vec<f64>>,
    /// Where the first end of the domain is the negative of the first shape value.
    is_symmetric: bool,
    /// Whether the other end of the domain is that.
    is_moving: bool,
}

/// The families, as a language takes their shape values.
fn families(language: &dyn Language, floats: Floats) -> Vec<(Case, Ends)> {
    let of = |(name, count): (&'static str, usize)| {
        let case = case_of(Source::text("reach.basis", FAMILIES), name, &[], name, &vec![1.0; count]);
        let code = case.code(language);
        // Each shape value with what is beyond; one that has a side is at both.
        let mut inside: Vec<Vec<f64>> = vec![Vec::new()];
        let mut beyond = Vec::new();
        for (k, shape) in code.shapes.iter().enumerate() {
            let declared = [shape.range.low.value(), shape.range.high.value()];
            let mut values = Vec::new();
            for (side, (single, declared)) in shape.single.iter().zip(declared).enumerate() {
                let end = single.as_ref().filter(|_| floats == Floats::Single).or(declared);
                let Some(end) = end.map(Rational::to_f64) else { continue };
                // Not next to nothing: exp(α) to the power 12 is a float.
                let largest = if floats == Floats::Single { 126.0 } else { 1022.0 };
                let is_far = end.abs() > largest / 12.0 * core::f64::consts::LN_2 * 0.7;
                assert!(is_far || end == 0.0 || matches!(name, "Lifted" | "Quick"), "{name} {end}");
                if end != 0.0 || shape.written == "λ" {
                    values.push(end);
                    beyond.push((k, next(end, side == 1, floats)));
                    if end != 0.0 {
                        beyond.extend([(k, 2.0 * end), (k, 1e4 * end)]);
                    }
                }
            }
            assert!(!values.is_empty(), "{name} {}", shape.written);
            inside =
                inside.iter().flat_map(|all| values.iter().map(|x| [&all[..], &[*x]].concat())).collect();
        }
        let outside = beyond.into_iter().map(|(k, value)| {
            let mut all = inside[inside.len() - 1].clone();
            all[k] = value;
            all
        });
        let outside = outside.collect();
        let moves = matches!(name, "Two" | "Six" | "Middle" | "Ending" | "Rational" | "Quick");
        (case, Ends { inside, outside, is_symmetric: name == "Middle", is_moving: moves })
    };
    let all = [("Two", 1), ("Six", 1), ("Middle", 1), ("Ending", 1), ("Rational", 2), ("Pair", 2)];
    let more = [("Lifted", 2), ("Steep", 1), ("Logistic", 1), ("Quick", 1)];
    all.into_iter().chain(more).map(of).collect()
}

impl Ends {
    /// The ends of the domain for shape values.
    fn domain(&self, shapes: &[f64]) -> [f64; 2] {
        let high = if self.is_moving { shapes[0] } else { 1.0 };
        [if self.is_symmetric { -high } else { 0.0 }, high]
    }
}

/// The next float beyond an end.
fn next(end: f64, up: bool, floats: Floats) -> f64 {
    match (floats, up) {
        (Floats::Single, true) => f64::from((end as f32).next_up()),
        (Floats::Single, false) => f64::from((end as f32).next_down()),
        (Floats::Double, true) => end.next_up(),
        (Floats::Double, false) => end.next_down(),
    }
}

/// Places in the domain between 0 and 1, many of them near the ends.
fn places() -> Vec<f64> {
    let near = (1..30).map(|k| 0.5_f64.powi(k));
    let mut all: Vec<f64> = near.clone().chain(near.map(|x| 1.0 - x)).chain([0.0, 1.0]).collect();
    all.extend((1..40).map(|k| f64::from(k) / 40.0));
    all
}

#[test]
#[ignore = "needs gcc"]
fn c_refuses_what_overflows() {
    if !has("gcc", &["--version"]) {
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    for (floats, scalar) in [(Floats::Double, Scalar::F64), (Floats::Single, Scalar::F32)] {
        let t = if floats == Floats::Double { "double" } else { "float" };
        for (case, ends) in families(&C(scalar), floats) {
            let (name, count) = (case.name, case.family.functions.len());
            write(folder, "family.h", &case.emit(&C(scalar)));
            let mut text = String::from("#include \"family.h\"\n#include <stdio.h>\nint main(void) {\n");
            let arguments =
                |all: &[f64]| all.iter().map(|x| format!("({t}){x:?}")).collect::<Vec<_>>().join(", ");
            let _ = writeln!(text, "{name} family;");
            for outside in &ends.outside {
                let _ = writeln!(text, "if ({name}_init(&family, {}) == 0) return 1;", arguments(outside));
            }
            for shapes in &ends.inside {
                let _ = writeln!(text, "if ({name}_init(&family, {}) != 0) return 2;", arguments(shapes));
                let [low, high] = ends.domain(shapes);
                for place in places() {
                    let at = (high - low) * place + low;
                    let _ = writeln!(text, "{{ {t} v[{count}], sum = 0, size = 1; {t} at = ({t}){at:?};");
                    for part in ["second_derivatives", "derivatives", "values"] {
                        let _ = writeln!(text, "{name}_{part}(family, at, v);");
                        let _ = writeln!(
                            text,
                            "for (int k = 0; k < {count}; k++) if (!isfinite(v[k])) return 3;"
                        );
                    }
                    let _ = writeln!(text, "for (int k = 0; k < {count}; k++) sum += v[k];");
                    let _ = writeln!(
                        text,
                        "for (int k = 0; k < {count}; k++) if (fabs(v[k]) > size) size = ({t})fabs(v[k]);"
                    );
                    text += "if (!(fabs(sum - 1) < 0.0001*size)) return 4; }\n";
                }
            }
            text += "return 0; }\n";
            write(folder, "main.c", &text);
            run(folder, "gcc", &["-std=c99", "-Wall", "-Werror", "main.c", "-o", "main", "-lm"]);
            run(folder, "./main", &[]);
        }
    }
}

#[test]
#[ignore = "needs python3 with numpy"]
fn python_refuses_what_overflows() {
    if !has("python3", &["-c", "import numpy"]) {
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    for (floats, kind) in
        [(Floats::Double, "float"), (Floats::Double, "numpy.float64"), (Floats::Single, "numpy.float32")]
    {
        for (case, ends) in families(&Python, floats) {
            let name = case.name;
            write(folder, &format!("{name}.py"), &case.emit(&Python));
            let mut text = format!("import numpy, math\nfrom {name} import {name}\nkind = {kind}\n");
            let _ = writeln!(text, "for outside in {:?}:", ends.outside);
            let _ = writeln!(text, "    try:\n        {name}(*map(kind, outside))");
            text += "    except ValueError as error:\n        assert 'must be finite, with' in str(error), error\n";
            text += "    else:\n        raise AssertionError(outside)\n";
            let inside = ends.inside.iter().map(|shapes| (shapes, ends.domain(shapes)));
            let inside: Vec<String> =
                inside.map(|(shapes, [low, high])| format!("({shapes:?}, {low:?}, {high:?})")).collect();
            let _ = writeln!(text, "for shapes, low, high in [{}]:", inside.join(", "));
            let _ = writeln!(
                text,
                "    family = {name}(*map(kind, shapes))\n    low, high = kind(low), kind(high)"
            );
            let _ = writeln!(text, "    for place in {:?}:", places());
            text += "        t = min(max(low + (high - low)*kind(place), low), high)\n";
            text += "        values = family.values(t)\n        size = max(1, *map(abs, values))\n";
            text += "        assert abs(sum(values) - 1) < 1e-4*size, (t, values)\n        for order in (0, 1, 2):\n";
            text += "            values = family.derivatives(t, order)\n";
            text += "            assert all(math.isfinite(x) for x in values), (shapes, t, order, values)\n";
            write(folder, "main.py", &text);
            run(folder, "python3", &["-W", "ignore", "main.py"]);
        }
    }
}

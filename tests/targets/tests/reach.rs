//! Shape values with whose exponentials floats would overflow are refused, and up to there nothing does.

use std::fmt::Write as _;

use basis_engine::Source;
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
";

/// The families with the largest value that a language lets all shape parameters have.
fn families(language: &dyn Language, floats: Floats) -> Vec<(Case, f64)> {
    let of = |(name, count): (&'static str, usize)| {
        let case = case_of(Source::text("reach.basis", FAMILIES), name, &[], name, &vec![1.0; count]);
        let code = case.code(language);
        let ends = code.shapes.iter().map(|shape| match (&shape.single, floats) {
            (Some(single), Floats::Single) => single.to_f64(),
            _ => shape.range.high.value().expect("it ends").to_f64(),
        });
        let end = ends.fold(f64::INFINITY, f64::min);
        (case, end)
    };
    [("Two", 1), ("Six", 1), ("Middle", 1), ("Ending", 1), ("Rational", 2)].map(of).into_iter().collect()
}

fn above(end: f64, floats: Floats) -> f64 {
    if floats == Floats::Single { f64::from((end as f32).next_up()) } else { end.next_up() }
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
        let (t, largest) = if floats == Floats::Double { ("double", 1022.0) } else { ("float", 126.0) };
        for (case, end) in families(&C(scalar), floats) {
            let (name, count) = (case.name, case.family.functions.len());
            // Not next to nothing: exp(α) to the power 12 is a float.
            assert!(end > largest / 12.0 * core::f64::consts::LN_2 * 0.7 && end < largest, "{name} {end}");
            write(folder, "family.h", &case.emit(&C(scalar)));
            let mut text = String::from("#include \"family.h\"\n#include <stdio.h>\nint main(void) {\n");
            let arguments = |value: f64| vec![format!("({t}){value:?}"); case.shapes.len()].join(", ");
            let _ = writeln!(text, "{name} family;");
            for outside in [above(end, floats), 2.0 * end, 1e4] {
                let _ = writeln!(text, "if ({name}_init(&family, {}) != 1) return 1;", arguments(outside));
            }
            let _ = writeln!(text, "if ({name}_init(&family, {}) != 0) return 2;", arguments(end));
            let low = if name == "Middle" { -end } else { 0.0 };
            for place in places() {
                let at = (end - low) * place + low;
                let _ = writeln!(text, "{{ {t} v[{count}], sum = 0; {t} at = ({t}){at:?};");
                for part in ["second_derivatives", "derivatives", "values"] {
                    let _ = writeln!(text, "{name}_{part}(family, at, v);");
                    let _ =
                        writeln!(text, "for (int k = 0; k < {count}; k++) if (!isfinite(v[k])) return 3;");
                }
                let _ = writeln!(text, "for (int k = 0; k < {count}; k++) sum += v[k];");
                text += "if (!(sum > 0.9999 && sum < 1.0001)) return 4; }\n";
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
        for (case, end) in families(&Python, floats) {
            let name = case.name;
            write(folder, &format!("{name}.py"), &case.emit(&Python));
            let mut text = format!("import numpy, math\nfrom {name} import {name}\nkind = {kind}\n");
            let arguments = |value: &str| vec![value; case.shapes.len()].join(", ");
            let outside = above(end, floats);
            let _ = writeln!(text, "for outside in ({outside:?}, {:?}, 1e4):", 2.0 * end);
            text += "    outside = kind(outside)\n    try:\n";
            let _ = writeln!(text, "        {name}({})", arguments("outside"));
            text += "    except ValueError as error:\n        assert 'must be finite, with' in str(error), error\n";
            text += "    else:\n        raise AssertionError(outside)\n";
            let _ = writeln!(text, "end = kind({end:?})\nfamily = {name}({})", arguments("end"));
            let low = if name == "Middle" { "-end" } else { "kind(0.0)" };
            let _ = writeln!(text, "low = {low}\nfor place in {:?}:", places());
            text +=
                "    t = min(max(low + (end - low)*kind(place), low), end)\n    values = family.values(t)\n";
            text += "    assert abs(sum(values) - 1) < 1e-4, (t, values)\n    for order in (0, 1, 2):\n";
            text += "        values = family.derivatives(t, order)\n";
            text += "        assert all(math.isfinite(x) for x in values), (t, order, values)\n";
            write(folder, "main.py", &text);
            run(folder, "python3", &["-W", "ignore", "main.py"]);
        }
    }
}

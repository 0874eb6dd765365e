//! Python: floats, numpy's arrays of both kinds, and JAX where it is installed.

use std::fmt::Write as _;

use basis_engine::emit::FamilyCode;
use basis_engine::emit::python::Python;
use basis_tests_targets::{
    Case, DIMENSION, Floats, Join, RELATED, Rounds, UNRELATED, cases, compare, guide, has, orders,
    related_join, run, write,
};

/// A program that prints all results; `number` makes numbers of a kind from floats.
fn program(case: &Case, floats: Floats, code: &FamilyCode<'_>, numpy: bool) -> String {
    let name = &code.name;
    let mut text = String::from("import struct\n");
    if numpy {
        let kind = if floats == Floats::Single { "float32" } else { "float64" };
        text += &format!("import numpy\nkind = numpy.{kind}\n");
        text += "number = kind\npoint = lambda p: numpy.array(p, kind)\n";
    } else {
        text += "number = float\npoint = tuple\n";
    }
    text += "def show(values):\n    for x in values:\n        assert type(x) is number, type(x)\n        print('%016x' % struct.unpack('<Q', struct.pack('<d', float(x)))[0])\n";
    let _ = writeln!(
        text,
        "from {} import {name}, {name}{}",
        case.name,
        if case.is_curve() { "Curve" } else { "Patch" }
    );
    let shapes: Vec<String> = case.shapes.iter().map(|x| format!("number({x:?})")).collect();
    let _ = writeln!(text, "family = {name}({})", shapes.join(", "));
    let numbers =
        |values: &[f64]| values.iter().map(|x| format!("number({x:?})")).collect::<Vec<_>>().join(", ");
    let points: Vec<String> =
        case.points().chunks(DIMENSION).map(|p| format!("point([{}])", numbers(p))).collect();
    let points = points.join(", ");
    let _ = writeln!(text, "points = [{points}]");
    let _ = writeln!(text, "bound = family.bind(points)");
    let _ = writeln!(text, "samples = []");
    for at in case.samples(floats) {
        let at: Vec<String> = at.iter().map(|x| format!("number({x:?})")).collect();
        let _ = writeln!(text, "samples.append(({},))", at.join(", "));
    }
    text += "for at in samples:\n    show(family.values(*at))\n";
    if case.is_curve() {
        text += "    show(family.derivatives(*at))\n    show(family.derivatives(*at, 2))\n";
        text +=
            "    show(bound.eval(*at))\n    for d in bound.eval_with_derivatives(*at):\n        show(d)\n";
    } else {
        let orders = orders(case.family.domain.len());
        for order in &orders {
            let _ = writeln!(text, "    show(family.partials(*at, orders={order:?}))");
        }
        text += "    show(bound.eval(*at))\n";
        for order in &orders {
            let _ = writeln!(text, "    show(bound.partial(*at, orders={order:?}))");
        }
    }
    if numpy {
        // Arrays of coordinates: the same numbers, of the same kind.
        text += "at = [numpy.array(x, kind) for x in zip(*samples)]\n";
        text +=
            "for values, many in zip(zip(*(family.values(*at) for at in samples)), family.values(*at)):\n";
        text += "    assert many.dtype == kind and many.shape == (len(samples),), many\n";
        // numpy's sines of many numbers are not those of one.
        let rest = if case.calls() { "1e3 * numpy.finfo(kind).eps" } else { "0.0" };
        let _ = writeln!(
            text,
            "    assert numpy.allclose(many, numpy.array(values, kind), {rest}, {rest}), many"
        );
        let _ = writeln!(
            text,
            "many = bound.eval(*at)\nassert many.dtype == kind and many.shape == (len(samples), {DIMENSION})"
        );
        let _ = writeln!(
            text,
            "for at, row in zip(samples, many):\n    assert numpy.allclose(bound.eval(*at), row, {rest}, {rest})"
        );
    }
    let (derivatives, f, c) = case.contact();
    let derivatives: Vec<String> =
        derivatives.chunks(DIMENSION).map(|p| format!("point([{}])", numbers(p))).collect();
    text += "class Other:\n    class family:\n        DOMAIN = (0.0, 1.0)\n    def eval_with_derivatives(self, t):\n";
    let _ = writeln!(text, "        return ({})", derivatives.join(", "));
    for (part, at_start) in [("curve_after", true), ("curve_before", false)] {
        for order in case.contacts(at_start) {
            let _ = writeln!(
                text,
                "for point_ in family.{part}(Other(), points, order={order}, f=number({f:?}), c=number({c:?})).points:\n    show(point_)"
            );
        }
    }
    text
}

fn all_cases(numpy: bool, kinds: &[Floats]) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    let mut wrong = Vec::new();
    for case in cases() {
        let code = case.code(&Python);
        write(folder, &format!("{}.py", case.name), &case.emit(&Python));
        for floats in kinds {
            write(folder, "main.py", &program(&case, *floats, &code, numpy));
            let printed = run(folder, "python3", &["-W", "error", "main.py"]);
            // Python computes constants with each other as `f64`, also where arrays are of `float32`: fewer roundings.
            let own_sines = numpy && case.calls();
            let rounds =
                if *floats == Floats::Single || own_sines { Rounds::Fused } else { Rounds::EveryStep };
            if let Err(error) = compare(&printed, &case.expected(*floats, *floats), rounds) {
                wrong.push(format!("{floats:?}: {error}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
#[ignore = "needs python3"]
fn floats_are_those_of_the_steps() {
    if has("python3", &["--version"]) {
        all_cases(false, &[Floats::Double]);
    }
}

#[test]
#[ignore = "needs python3 and numpy"]
fn arrays_keep_their_type() {
    if has("python3", &["-c", "import numpy"]) {
        all_cases(true, &[Floats::Single, Floats::Double]);
    }
}

/// Traced values have no truth value; gradients by shape values and parameters are those of the formulas.
#[test]
#[ignore = "needs python3 and jax"]
fn jax_traces_the_same_code() {
    if !has("python3", &["-c", "import jax"]) {
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    let quartic = cases().into_iter().find(|case| case.name == "QuarticBernstein").expect("among the cases");
    write(folder, "quartic.py", &quartic.emit(&Python));
    let program = "\
import jax, jax.numpy as jnp
from quartic import QuarticBernstein as Q
b1 = jax.jit(lambda l, t: Q(l).values(t)[1])
assert float(b1(0.5, 0.5)) == (3 + 0.5 - 0.25) * 0.125
# D(b[1], t) and D(b[1], λ) at λ = 1/2, t = 1/2: b1 = (3 + l - l t) t (1 - t)^2.
g = jax.grad(lambda l, t: Q(l).values(t)[1], argnums=(0, 1))
by_l, by_t = g(0.5, 0.5)
assert float(by_l) == 0.0625 and float(by_t) == -0.875 + 0.0, (by_l, by_t)
many = jax.vmap(b1, (None, 0))(0.5, jnp.linspace(0.0, 1.0, 9))
assert many.shape == (9,)
points = jnp.array([[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]])
curve = jax.jit(lambda l, p, t: Q(l).bind(p).eval(t))
assert curve(0.0, points, jnp.linspace(0.0, 1.0, 5)).shape == (5, 2)
assert curve(0.0, points, 0.5).tolist() == [2.0, 1.5]
assert jnp.asarray(jax.jacobian(curve, 1)(0.0, points, 0.5)).shape == (2, 4, 2)
";
    write(folder, "main.py", program);
    run(folder, "python3", &["main.py"]);
}

/// Sines are those of JAX, and spans are chosen without a branch.
#[test]
#[ignore = "needs python3 and jax"]
fn jax_traces_sines_and_spans() {
    if !has("python3", &["-c", "import jax"]) {
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    for name in ["Quarter", "Pieces"] {
        let case = cases().into_iter().find(|case| case.name == name).expect("among the cases");
        write(folder, &format!("{name}.py"), &case.emit(&Python));
    }
    let program = "\
import jax, jax.numpy as jnp, math
from Quarter import Quarter
from Pieces import Pieces
first = jax.jit(lambda l, t: Quarter(l).values(t)[0])
assert abs(float(first(0.5, 0.25)) - (1 - math.sin(0.25))*(1 - math.sin(0.25)/2)) < 1e-6
assert abs(float(jax.grad(first, 1)(0.5, 0.25)) - Quarter(0.5).derivatives(0.25)[0]) < 1e-5
# At both ends too, where coordinates are 0.
for end in (0.0, math.pi/2):
    for k, slope in enumerate(Quarter(0.5).derivatives(end)):
        found = float(jax.grad(lambda t: Quarter(0.5).values(t)[k])(end))
        assert abs(found - slope) < 1e-5, (end, k, found, slope)
at = [0.0, 0.5, 1.0, 2.0, 3.0, 3.5, 4.0]
bump = jax.jit(lambda t: Pieces().values(t)[0])
for t, value in zip(at, bump(jnp.array(at))):
    assert abs(float(value) - Pieces().values(t)[0]) < 1e-6 and abs(float(bump(t) - value)) < 1e-6
slopes = jax.vmap(jax.grad(bump))(jnp.array(at[1:2] + at[3:4] + at[5:6]))
assert jnp.allclose(slopes, jnp.array([1/6, 0.0, -1/6]), 0, 1e-5), slopes
";
    write(folder, "main.py", program);
    run(folder, "python3", &["main.py"]);
}

#[test]
#[ignore = "needs python3"]
fn joins_are_those_of_the_steps() {
    if !has("python3", &["--version"]) {
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (folder, join) = (folder.path(), Join::new());
    write(folder, "join.py", &join.emit(&Python));
    let points: Vec<String> =
        join.points.chunks(DIMENSION).map(|p| format!("({:?}, {:?})", p[0], p[1])).collect();
    let program = format!(
        "import struct\nfrom join import smooth\npoints = [{}]\nfor bad in (0.0, -1.0, float('nan'), float('inf')):\n    \
         try: smooth(points, bad)\n    except ValueError: continue\n    raise SystemExit(bad)\n\
         for point in smooth(points, {:?}):\n    for x in point: print('%016x' % struct.unpack('<Q', struct.pack('<d', x))[0])\n",
        points.join(", "),
        join.delta
    );
    write(folder, "main.py", &program);
    let printed = run(folder, "python3", &["main.py"]);
    compare(&printed, &join.expected(), Rounds::EveryStep).unwrap_or_else(|e| panic!("{e}"));
}

#[test]
#[ignore = "needs python3"]
fn joins_check_how_scalars_are_related() {
    if !has("python3", &["--version"]) {
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    write(folder, "join.py", &related_join(&Python));
    let mut program = format!(
        "from join import related\nP = [0.0, 1.0, 3.0]\nassert list(related(P, {RELATED})) == [3.0, 4.0]\n"
    );
    for scalars in UNRELATED {
        let _ = writeln!(
            program,
            "try: related(P, {scalars})\nexcept ValueError: pass\nelse: raise SystemExit('{scalars}')"
        );
    }
    write(folder, "main.py", &program);
    run(folder, "python3", &["main.py"]);
}

/// All families in one file: where names meet, or a name has two types, mypy says so.
#[test]
#[ignore = "needs mypy"]
fn type_hints_agree() {
    if !has("python3", &["-m", "mypy", "--version"]) {
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    let mut files = Vec::new();
    for case in cases() {
        let name = format!("{}_of_case.py", case.name);
        write(folder, &name, &case.emit(&Python));
        files.push(name);
    }
    let mut arguments = vec!["-m", "mypy", "--python-version", "3.10"];
    arguments.extend(files.iter().map(String::as_str));
    run(folder, "python3", &arguments);
}

/// What is wrong is an error, of Python's own kind.
#[test]
#[ignore = "needs python3"]
fn wrong_values_raise() {
    if !has("python3", &["--version"]) {
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    for name in ["QuarticBernstein", "double", "Slab"] {
        let case = cases().into_iter().find(|case| case.name == name).expect("among the cases");
        write(folder, &format!("{name}.py"), &case.emit(&Python));
    }
    let program = "\
from QuarticBernstein import QuarticBernstein as Q
from double import double
from Slab import Slab
nan, inf = float('nan'), float('inf')
def refused(call, *a, **k):
    try: call(*a, **k)
    except ValueError as e: return str(e)
    raise SystemExit(f'{a} {k} was accepted')
for bad in (-3.5, 1.25, nan, inf, -inf):
    assert 'λ' in refused(Q, bad)
for bad in (0.0, -1.0, nan, inf): refused(Slab, bad)
assert 'while <= int' in refused(double, 0.5, 0.75)
q = Q(-3.0)
points = [(0.0, 0.0), (1.0, 2.0), (3.0, 2.0), (4.0, 0.0)]
refused(q.bind, points[:3]); refused(q.bind, [*points[:3], (1.0,)]); refused(q.derivatives, 0.5, 3)
curve = q.bind(points)
for bad in (0.0, -1.0, nan, inf): refused(Q(0.5).curve_after, curve, points, f=bad)
refused(Q(0.5).curve_after, curve, points, c=nan); refused(Q(0.5).curve_after, curve, points, order=3)
assert 'λ = -3' in refused(q.curve_after, curve, points)
assert Q(0.5).curve_after(curve, [None, None, (5.0, 5.0), (6.0, 5.0)]).points[0] == (4.0, 0.0)
refused(Slab(1.0).partials, 0.5, 0.5, (3, 0))
";
    write(folder, "main.py", program);
    run(folder, "python3", &["main.py"]);
}

#[test]
#[ignore = "needs python3"]
fn the_guide_is_true() {
    if !has("python3", &["--version"]) {
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (listing, module) = guide("python", &Python);
    write(folder.path(), "quartic.py", &module);
    write(folder.path(), "main.py", &listing);
    run(folder.path(), "python3", &["main.py"]);
}

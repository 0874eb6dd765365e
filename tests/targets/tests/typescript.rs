//! TypeScript: accepted with all strict options, and run by node.

use std::fmt::Write as _;
use std::path::Path;

use basis_engine::emit::typescript::TypeScript;
use basis_tests_targets::{
    Case, DIMENSION, Floats, RELATED, Rounds, UNRELATED, cases, compare, has, list, orders, related_join,
    run, write,
};

/// The compiler, of the packages that `npm ci` installs beside the manifest; none where it is not installed.
fn compiler() -> Option<String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("node_modules/typescript/bin/tsc");
    let path = path.to_string_lossy().into_owned();
    (has("node", &["--version"]) && has("node", &[&path, "--version"])).then_some(path)
}

const OPTIONS: &str = "\
--strict --noUnusedLocals --noUnusedParameters --noUncheckedIndexedAccess --noImplicitReturns --noImplicitOverride \
--noFallthroughCasesInSwitch --exactOptionalPropertyTypes --target es2020 --module es2020 --moduleResolution bundler";

/// A program that prints all results.
fn program(case: &Case) -> String {
    let own = case.code(&TypeScript).name;
    let floats = Floats::Double;
    let mut text = format!("import {{ {own} }} from './{}.js';\n", case.name);
    text += "const word = new DataView(new ArrayBuffer(8));\nconst lines = [];\n";
    text += "function show(values) { for (const x of values) { word.setFloat64(0, x); lines.push(word.getBigUint64(0).toString(16).padStart(16, '0')); } }\n";
    let _ = writeln!(text, "const family = new {own}({});", list(&case.shapes, ""));
    let _ = writeln!(
        text,
        "const points = [{}];\nconst bound = family.bind({DIMENSION}, points);",
        list(&case.points(), "")
    );
    let samples = case.samples(floats);
    let _ = writeln!(text, "const all = bound.evalN([{}]);", list(&samples.concat(), ""));
    for (k, at) in samples.iter().enumerate() {
        let at = list(at, "");
        let _ = writeln!(text, "show(family.values({at}));");
        let again = format!(
            "if (bound.eval({at}).some((x, axis) => x !== all[{k} * {DIMENSION} + axis])) throw new Error('evalN');"
        );
        if case.is_curve() {
            let _ = writeln!(text, "show(family.derivatives({at})); show(family.derivatives({at}, 2));");
            let _ = writeln!(text, "show(bound.eval({at})); show(bound.evalWithDerivatives({at})); {again}");
        } else {
            let orders = orders(case.family.domain.len());
            for order in &orders {
                let _ = writeln!(text, "show(family.partials({at}, {order:?}));");
            }
            let _ = writeln!(text, "show(bound.eval({at})); {again}");
            for order in &orders {
                let _ = writeln!(text, "show(bound.partial({at}, {order:?}));");
            }
        }
    }
    let (derivatives, f, c) = case.contact();
    let _ = writeln!(
        text,
        "const other = {{ dimension: {DIMENSION}, domain: [0, 1], evalWithDerivatives: () => new Float64Array([{}]) }};",
        list(&derivatives, "")
    );
    for (part, at_start) in [("curveAfter", true), ("curveBefore", false)] {
        for order in case.contacts(at_start) {
            let _ = writeln!(
                text,
                "show(family.{part}(other, {{ order: {order}, f: {f:?}, c: {c:?} }}, points).points);"
            );
        }
    }
    text + "console.log(lines.join('\\n'));\n"
}

#[test]
#[ignore = "needs node, and typescript from `npm ci` in tests/targets"]
fn node_computes_what_the_steps_say() {
    let Some(compiler) = compiler() else { return };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    write(folder, "package.json", "{ \"type\": \"module\" }\n");
    let cases = cases();
    let files: Vec<String> = cases
        .iter()
        .map(|case| {
            let name = format!("{}.ts", case.name);
            write(folder, &name, &case.emit(&TypeScript));
            name
        })
        .collect();
    let mut arguments = vec![compiler.as_str()];
    arguments.extend(OPTIONS.split_whitespace());
    arguments.extend(files.iter().map(String::as_str));
    run(folder, "node", &arguments);
    let mut wrong = Vec::new();
    for case in &cases {
        write(folder, "main.js", &program(case));
        let printed = run(folder, "node", &["main.js"]);
        let rounds = if case.calls() { Rounds::Fused } else { Rounds::EveryStep };
        if let Err(error) = compare(&printed, &case.expected(Floats::Double, Floats::Double), rounds) {
            wrong.push(error);
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
#[ignore = "needs node, and typescript from `npm ci` in tests/targets"]
fn wrong_values_throw() {
    let Some(compiler) = compiler() else { return };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    write(folder, "package.json", "{ \"type\": \"module\" }\n");
    let emitted = |name: &str| {
        let case = cases().into_iter().find(|case| case.name == name).expect("among the cases");
        case.emit(&TypeScript)
    };
    let joins = ("join", related_join(&TypeScript));
    let families = ["QuarticBernstein", "double", "Slab"].map(|name| (name, emitted(name)));
    for (name, text) in families.into_iter().chain([joins]) {
        write(folder, &format!("{name}.ts"), &text);
        run(folder, "node", &[&compiler, "--target", "es2020", "--module", "es2020", &format!("{name}.ts")]);
    }
    let program = "\
import { QuarticBernstein as Q } from './QuarticBernstein.js';
import { double } from './double.js';
import { Slab } from './Slab.js';
import { related } from './join.js';
function refused(call) {
    try { call(); } catch (error) { if (error instanceof RangeError) return error.message; throw error; }
    throw new Error(`${call} was accepted`);
}
for (const bad of [-3.5, 1.25, NaN, Infinity, -Infinity, undefined]) refused(() => new Q(bad));
for (const bad of [0, -1, NaN, Infinity]) refused(() => new Slab(bad));
if (!refused(() => new double(0.5, 0.75)).includes('while <= int')) throw new Error('the assumption');
const points = [0, 0, 1, 2, 3, 2, 4, 0];
const q = new Q(-3), curve = q.bind(2, points);
refused(() => q.bind(2, points.slice(1))); refused(() => q.derivatives(0.5, 3));
for (const f of [0, -1, NaN, Infinity]) refused(() => new Q(0.5).curveAfter(curve, { order: 1, f }, points));
refused(() => new Q(0.5).curveAfter(curve, { order: 2, c: NaN }, points));
refused(() => new Q(0.5).curveAfter(curve, { order: 3 }, points));
if (!refused(() => q.curveAfter(curve, { order: 1 }, points)).includes('λ = -3')) throw new Error('undetermined');
const next = new Q(0.5).curveAfter(curve, { order: 1 }, points);
if (next.points[0] !== 4 || next.points[1] !== 0) throw new Error('the end');
refused(() => new Slab(1).partials(0.5, 0.5, [3, 0]));
";
    let mut program = String::from(program);
    program += &format!("if (related(1, [0, 1, 3], {RELATED}).Q[1] !== 4) throw new Error('a join');\n");
    for scalars in UNRELATED {
        program += &format!("refused(() => related(1, [0, 1, 3], {scalars}));\n");
    }
    write(folder, "main.js", &program);
    run(folder, "node", &["main.js"]);
}

#!/usr/bin/env bash
# What a user pays: processor seconds (user + system) of clean builds in the dev profile of small crates outside of
# this repository, beside two derives that also bring a parser. All in one run, `ROUNDS` times (3), each with its own
# target folder; the smallest counts, because what else the machine does only adds to it.
#
#     benches/build.sh            all rows
#     ROUNDS=1 benches/build.sh   fewer rounds
#
# Our crates are built from the folders of this repository; Cargo gives path dependencies incremental compilation, registry
# dependencies not, so it is switched off for all.
#
# The budget is about the first two rows: polynomials and quotients on intervals, simplices and their products, without what
# the default features `angles`, `rounding` and those of the runtime bring. Whoever wants little switches the defaults off;
# the row of the default features is what the others pay.
set -euo pipefail
cd "$(dirname "$0")/.."

root=$PWD
rounds=${ROUNDS:-3}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export CARGO_INCREMENTAL=0 CARGO_TERM_QUIET=true

# has PACKAGE-FOLDER FEATURE: whether a package has a feature.
has() { sed -n '/^\[features\]/,/^\[/p' "$root/$1/Cargo.toml" | grep -q "^$2 = "; }

# crate NAME DEPENDENCIES: a crate in the scratch folder; its code is read from standard input.
crate() {
    mkdir -p "$scratch/$1/src"
    cat >"$scratch/$1/src/main.rs"
    cat >"$scratch/$1/Cargo.toml" <<END
[package]
name = "$1"
version = "0.0.0"
edition = "2024"

[workspace]

[dependencies]
$2
END
}

# runtime FEATURES: the dependency on the runtime with these features alone, as far as it has them.
runtime() {
    local feature list=
    for feature in "$@"; do
        if has runtime "$feature"; then list+="\"$feature\", "; fi
    done
    echo "basis-runtime = { path = \"$root/runtime\", default-features = false, features = [${list%, }] }"
}

spec='family Quadratic {
    domain 0 <= t <= 1;
    shape -2 <= λ <= 1;
    b[0] = (1 - λ*t) * (1 - t)^2;
    b[1] = (2 + λ) * t * (1 - t);
    b[2] = (1 - λ + λ*t) * t^2;
    prove partition_of_unity;
    prove nonnegative;
}'
with_macro="basis_runtime::basis! { $spec }
fn main() { println!(\"{:?}\", Quadratic::new(0.5).map(|b| b.values(0.25_f64))); }"
without_macro='fn main() {
    let curve = basis_runtime::Bezier::from_points([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]]);
    println!("{:?}", curve.eval(0.25));
}'

rows=()
# row NAME WHAT
row() { rows+=("$1|$2"); }

crate macro "$(runtime std macros joins)" <<<"$with_macro"
row macro 'one `basis!`, runtime with `std`, `macros` and `joins`'
if has runtime joins; then
    crate without-joins "$(runtime std macros)" <<<"$with_macro"
    row without-joins 'the same without `joins`'
fi
crate defaults "basis-runtime = { path = \"$root/runtime\" }" <<<"$with_macro"
row defaults 'one `basis!`, default features of the runtime'
if has runtime angles; then
    crate angles "$(runtime std macros joins angles)" <<<"$with_macro"
    row angles 'the first with `angles` as well'
fi
if has runtime macros; then
    crate alone "$(runtime std)" <<<"$without_macro"
    row alone 'runtime with `std`, without the macro'
fi
crate pest 'pest = "2"
pest_derive = "2"' <<'END'
#[derive(pest_derive::Parser)]
#[grammar_inline = "number = @{ ASCII_DIGIT+ }\nsum = { number ~ (\"+\" ~ number)* }"]
struct Sums;

fn main() {
    println!("{}", <Sums as pest::Parser<Rule>>::parse(Rule::sum, "1+2").is_ok());
}
END
row pest '`pest_derive` with a grammar of two rules'
crate askama 'askama = "0.16"' <<'END'
use askama::Template;

#[derive(Template)]
#[template(source = "{% for n in numbers %}{{ n }} {% endfor %}", ext = "txt")]
struct Numbers { numbers: Vec<u32> }

fn main() {
    println!("{}", Numbers { numbers: vec![1, 2] }.render().is_ok());
}
END
row askama '`askama` with a template of one line'

for entry in "${rows[@]}"; do
    name=${entry%%|*}
    if [[ $name != pest && $name != askama ]]; then cp "$root/Cargo.lock" "$scratch/$name/Cargo.lock"; fi
    cargo fetch --manifest-path "$scratch/$name/Cargo.toml"
done

# seconds NAME: processor seconds of one clean build.
seconds() {
    local TIMEFORMAT='%U %S' said times
    rm -rf "$scratch/$1/target"
    said=$scratch/$1.log
    { times=$({ time cargo build --offline --manifest-path "$scratch/$1/Cargo.toml" >"$said" 2>&1; } 2>&1); } ||
        { cat "$said" >&2; return 1; }
    awk '{ printf "%.1f", $1 + $2 }' <<<"$times"
}

declare -A best
for ((round = 1; round <= rounds; round++)); do
    for entry in "${rows[@]}"; do
        name=${entry%%|*}
        echo "round $round of $rounds: $name" >&2
        took=$(seconds "$name")
        best[$name]=$(awk -v a="${best[$name]:-1e9}" -v b="$took" 'BEGIN { printf "%.1f", (b < a) ? b : a }')
    done
done

echo "$(rustc --version), $(nproc 2>/dev/null || getconf _NPROCESSORS_ONLN) cores, smallest of $rounds"
echo
echo '| a clean build in the dev profile of | CPU-s | of pest |'
echo '| --- | --- | --- |'
for entry in "${rows[@]}"; do
    name=${entry%%|*}
    awk -v what="${entry#*|}" -v t="${best[$name]}" -v p="${best[pest]}" \
        'BEGIN { printf "| %s | %.1f | %.2f |\n", what, t, t / p }'
done

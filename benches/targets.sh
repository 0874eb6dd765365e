#!/usr/bin/env bash
# What emitted code costs beside hand-written code: C of the same form, and numpy. A table in Markdown.
#
#     benches/targets.sh          CC=clang benches/targets.sh
set -euo pipefail
cd "$(dirname "$0")/.."

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cargo build --quiet -p basis-cli
basis=${CARGO_TARGET_DIR:-target}/debug/basis
"$basis" emit library:quartic --to c -o "$scratch/quartic.h"
"$basis" emit library:rational/bezier Conic --to c -o "$scratch/conic.h"
"$basis" emit library:quartic --to python -o "$scratch/quartic.py"
"${CC:-gcc}" -std=c99 -O3 -march=native -Wall -Wextra -I "$scratch" benches/targets.c -o "$scratch/targets" -lm

echo '| work | emitted | by hand | ratio |'
echo '| --- | --- | --- | --- |'
"$scratch/targets"
if python3 -c 'import numpy' 2>/dev/null; then
    PYTHONPATH=$scratch python3 -B benches/targets.py
fi

#!/usr/bin/env python3
"""Hostile specs of 1 MiB: each family with each claim, written as often as a spec may have claims.

    python3 benches/hostile.py target/release/basis [STEP]

prints CPU-seconds and MB of `basis check -q` for every STEP-th file, the slowest last. The budget is 5 s and 512 MB on one core.
"""
import os
import subprocess
import sys
import tempfile

SIZE, CLAIMS = 1 << 20, 19_900

UNIT = "domain 0 <= t <= 1; "


def box(sides):
    return "domain " + ", ".join(f"0 <= x{i} <= 1" for i in range(sides)) + "; "


def joined(count, sign, power=""):
    return sign.join(f"x{i}{power}" for i in range(count))


FAMILIES = {
    "lines": UNIT + "b[0] = 1 - t; b[1] = t;",
    "Bernstein functions of degree 60": UNIT + "b[i] = binomial(60, i)*t^i*(1 - t)^(60 - i) for i in 0..=60;",
    "powers of sums": UNIT + "b[i] = (t + i/7)^30 for i in 0..=30;",
    "512 functions": UNIT + "b[i] = t + i for i in 0..=511;",
    "large numbers": UNIT + "b[0] = t^2*10^300 + 1/10^300; b[1] = (10^200 + t)^3; b[2] = t*3^500;",
    "shape parameters": UNIT + "shape 0 <= x <= 1, 0 <= y <= 1, 0 <= z <= 1; b[0] = (1 - t)^3*(1 + x*t);"
    " b[1] = t*(1 - t)*(x + y*t + z*t^2) + x*t^2; b[2] = 1 - b[0] - b[1];",
    "a condition": UNIT + "shape -1 <= x <= 1, -1 <= y <= 1; assume x^2 + y^2 <= 1; b[0] = t*x + y; b[1] = t^5 - x*t^3 + y;",
    "quotients": UNIT + "shape 0 < x <= 3; let w = (1 - t)^2 + x*t*(1 - t) + t^2;"
    " b[0] = (1 - t)^2/w; b[1] = x*t*(1 - t)/w; b[2] = t^2/w;",
    "a quarter turn": "domain 0 <= t <= pi/2; shape 0 <= x <= 1; b[0] = (1 - sin(t))*(1 - x*sin(t));"
    " b[2] = (1 - cos(t))*(1 - x*cos(t)); b[1] = 1 - b[0] - b[2];",
    "an irrational angle": "domain 0 <= t <= pi/2; b[i] = (sin(t) + i*sin(pi/8))^5 for i in 0..=20; b[21] = sin(t);",
    "an angle as parameter": "shape 0 < α < pi; domain 0 <= t <= α; b[0] = sin((α - t)/2)^2/sin(α/2)^2;"
    " b[2] = sin(t/2)^2/sin(α/2)^2; b[1] = 1 - b[0] - b[2];",
    "exponentials": "shape 0 < α; domain 0 <= t <= α; b[0] = cosh(t); b[1] = sinh(t); b[2] = t; b[3] = 1;",
    "spans": "domain 0 <= t <= 1, 1 <= t <= 2, 2 <= t <= 3; b[0] = [t^2/2, (-2*t^2 + 6*t - 3)/2, (3 - t)^2/2];"
    " b[1] = [1 - t, 0, 0];",
    "a triangle": "domain triangle(u, v, w); b[i,j,k] = factorial(8)/(factorial(i)*factorial(j)*factorial(k))*u^i*v^j*w^k"
    " for i, j, k in simplex(8);",
    "a box": box(3) + "b[i,j,k] = binomial(4, i)*x0^i*(1 - x0)^(4 - i)*binomial(4, j)*x1^j*(1 - x1)^(4 - j)"
    "*binomial(4, k)*x2^k*(1 - x2)^(4 - k) for i in 0..=4, j in 0..=4, k in 0..=4;",
    "a box of twelve sides": box(12) + f"b[0] = {joined(12, '*')}; b[1] = 1 - b[0]; b[2] = {joined(12, ' + ', '^2')};",
    "a box of forty sides": box(40) + f"b[0] = 1; b[1] = {joined(40, ' + ')};",
    "a product on a box of forty sides": box(40) + f"b[i] = {joined(10, '*')} for i in 0..=1;",
}

STATEMENTS = [
    "prove nonnegative;",
    "prove partition_of_unity;",
    "prove independent;",
    "refute independent;",
    "prove symmetric;",
    "prove totally_positive;",
    "prove smooth(2);",
    "prove rounding <= 50;",
    "prove b[0]^2*b[1]^2 >= -1/10^9;",
    "prove b[0] + b[1] <= 7/5;",
    "prove D(b[1], 2)*b[0] <= 1000;",
    "prove integral(b[0]*b[1]) >= 0;",
    "prove b[0]*b[1] = b[1]*b[0] + b[0] - b[0];",
    "refute b[0]^6 >= b[1]^5;",
    "prove at t = 1/3 { b[0] >= 0; }",
    "prove at t = pi/4 { b[0] = sin(pi/4); }",
    "prove (t^3 - 1/3)^2 >= 1/10^20;",
    "prove (b[0] - 1/3)^4 >= 1/10^30;",
    "prove sin(t) + cos(t) <= 2*sin(pi/4);",
]


# Functions that stand for b[0] and b[1] in the statements.
STANDING = {"a triangle": ("b[0,0,8]", "b[0,1,7]"), "a box": ("b[0,0,0]", "b[0,1,0]")}


def spec(family, statement):
    for name, own in zip(("b[0]", "b[1]"), STANDING.get(family, ())):
        statement = statement.replace(name, own)
    head, tail = f"family F {{ {FAMILIES[family]} ", "}"
    count = (SIZE - len((head + tail).encode())) // len(statement)
    return head + statement * min(count, CLAIMS) + tail


def measured(command, file):
    """CPU-seconds, MB, and the first line of the answer."""
    child = subprocess.Popen([command, "check", "-q", file], stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    first = child.stdout.readline().decode(errors="replace").strip()
    for _ in child.stdout:
        pass
    _, _, used = os.wait4(child.pid, 0)
    return used.ru_utime + used.ru_stime, used.ru_maxrss // 1024, first


def main():
    command, step = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 1
    os.sched_setaffinity(0, {0})
    kinds = [(f, s) for f in FAMILIES for s in STATEMENTS][::step]
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for family, statement in kinds:
            file = os.path.join(folder, "hostile.basis")
            with open(file, "w", encoding="utf-8") as f:
                f.write(spec(family, statement))
            rows.append((*measured(command, file), family, statement))
    for seconds, memory, first, family, statement in sorted(rows):
        print(f"{seconds:6.2f} s {memory:5} MB  {family}: {statement}  {first[:60]}")
    slow = sum(seconds > 5 or memory > 512 for seconds, memory, *_ in rows)
    print(f"{len(rows)} files, {slow} above 5 s or 512 MB")


if __name__ == "__main__":
    main()

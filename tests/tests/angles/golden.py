#!/usr/bin/env python3
"""Writes golden.json: families with angles and exponentials, evaluated by mpmath at floats, for the tests in main.rs.

    pip install mpmath numpy && python3 golden.py
"""

import json
import random
import struct
from pathlib import Path

import numpy as np
from mpmath import binomial, cos, cosh, diff, exp, mp, mpf, pi, sin

mp.dps = 90
random.seed(22)


def quadratic(t, lam):
    s, c = sin(pi * t / 2), cos(pi * t / 2)
    return [(1 - s) * (1 - lam * s), (1 + lam) * (s + c - 1), (1 - c) * (1 - lam * c)]


def cubic(t, lam, mu):
    s, c = sin(t), cos(t)
    return [
        (1 - lam * s) * (1 - s) ** 2,
        s * (1 - s) * (2 + lam - lam * s),
        c * (1 - c) * (2 + mu - mu * c),
        (1 - mu * c) * (1 - c) ** 2,
    ]


def c_bezier(t, a):
    first, last = (1 - cos(a - t)) / (1 - cos(a)), (1 - cos(t)) / (1 - cos(a))
    return [first, 1 - first - last, last]


def h_bezier(t, a):
    first, last = (cosh(a - t) - 1) / (cosh(a) - 1), (cosh(t) - 1) / (cosh(a) - 1)
    return [first, 1 - first - last, last]


def normalised(t, a):
    u, v, c = sin((a - t) / 2) / sin(a / 2), sin(t / 2) / sin(a / 2), cos(a / 2)
    return [u**4, 4 * c * u**3 * v, (2 + 4 * c**2) * u**2 * v**2, 4 * c * u * v**3, v**4]


def line(t):
    return [(exp(1) - exp(t)) / (exp(1) - 1), (exp(t) - 1) / (exp(1) - 1)]


def exponential(t, a):
    x, s = (exp(t) - 1) / (exp(a) - 1), (exp(a) - exp(t)) / (exp(a) - 1)
    return [binomial(3, i) * x**i * s ** (3 - i) for i in range(4)]


def bits(value):
    """A float as a whole number: not every reader of JSON keeps the last digit."""
    return struct.unpack("<Q", struct.pack("<d", value))[0]


# Ranges of the shape values; None for the end of the domain where it is the last of them.
FAMILIES = {
    "QuadraticTrigonometric": (quadratic, [(-0.9, 1)], 1),
    "CubicTrigonometricBezier": (cubic, [(-2, 1), (-2, 1)], np.pi / 2),
    "CBezierQuadratic": (c_bezier, [(0.01, 3)], None),
    "TrigonometricBBasis": (normalised, [(0.01, 3)], None),
    "HBezierQuadratic": (h_bezier, [(0.01, 6)], None),
    "ExponentialLine": (line, [], 1),
    "ExponentialBernstein": (exponential, [(0.01, 6)], None),
}
PLACES = [1e-12, 1e-7, 1e-4, 0.03, 0.3, 0.5]


def cases(float_type):
    for name, (functions, ranges, end) in FAMILIES.items():
        for _ in range(3 if ranges else 1):
            shape = [float(float_type(random.uniform(*r))) for r in ranges]
            hi = float_type(shape[-1] if end is None else end)
            lo = float_type(0)
            points = [np.nextafter(lo, hi) * float_type(2) ** 40, np.nextafter(hi, lo)]
            for place in PLACES:
                points += [float_type(float(hi) * place), float_type(float(hi) * (1 - place))]
            points = sorted({float(t) for t in points if 0 < t < hi})
            exact = [mpf(value) for value in shape]
            rows = []
            for t in points:
                orders = []
                for order in range(3):
                    at = lambda k: diff(lambda x: functions(x, *exact)[k], mpf(t), order)
                    count = len(functions(mpf(t), *exact))
                    orders.append([float(at(k)) for k in range(count)])
                rows.append([bits(t), orders])
            yield {"family": name, "shape": [bits(value) for value in shape], "points": rows}


golden = {"f32": list(cases(np.float32)), "f64": list(cases(np.float64))}
path = Path(__file__).with_name("golden.json")
path.write_text(json.dumps(golden, separators=(",", ":")).replace('{"family"', '\n{"family"') + "\n")

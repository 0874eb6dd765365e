#!/usr/bin/env python3
"""Writes bspline.json: splines, evaluated, refined and fitted by scipy, for the tests in ../bspline.

    pip install scipy numpy && python3 bspline.py
"""

import json
from pathlib import Path

import numpy as np
from scipy.interpolate import BSpline, NdBSpline, make_interp_spline, make_lsq_spline

random = np.random.default_rng(20240607)


def inner_knots(degree, spans):
    """Inner knots with random multiplicities from 1 to degree."""
    breaks = np.sort(random.uniform(0.0, 1.0, spans - 1))
    return np.repeat(breaks, random.integers(1, degree + 1, len(breaks)))


def knots(degree, spans, clamped):
    """A knot vector over the domain [0, 1]."""
    if clamped:
        before, after = np.zeros(degree + 1), np.ones(degree + 1)
    else:
        before = np.r_[np.sort(random.uniform(-1.0, 0.0, degree)), 0.0]
        after = np.r_[1.0, np.sort(random.uniform(1.0, 2.0, degree))]
    return np.r_[before, inner_knots(degree, spans), after]


def parameters(t, degree, count=13):
    """Random parameters, both ends, all knots of the domain, and one on each side outside of it."""
    inside = t[degree : len(t) - degree]
    return np.r_[-0.05, 1.05, np.unique(inside), random.uniform(0.0, 1.0, count)]


def curves():
    for degree in range(0, 8):
        for clamped in (True, False):
            t = knots(max(degree, 1), 6, clamped) if degree else np.linspace(0.0, 1.0, 7)
            c = random.normal(size=(len(t) - degree - 1, 3))
            spline = BSpline(t, c, degree)
            x = parameters(t, degree)
            yield {
                "degree": degree,
                "knots": t.tolist(),
                "points": c.tolist(),
                "parameters": x.tolist(),
                "derivatives": [spline(x, nu=order).tolist() for order in range(0, 4)],
            }


def surfaces():
    for degrees in ((1, 1), (1, 3), (2, 3), (3, 3), (4, 2), (5, 4)):
        for clamped in (True, False):
            t = [knots(degree, 4, clamped) for degree in degrees]
            shape = [len(t[i]) - degrees[i] - 1 for i in range(2)]
            c = random.normal(size=(*shape, 3))
            spline = NdBSpline(tuple(t), c, degrees)
            x = random.uniform(0.0, 1.0, (8, 2))
            orders = [(0, 0), (1, 0), (0, 1), (1, 1), (2, 0), (0, 2)]
            yield {
                "degrees": degrees,
                "u": t[0].tolist(),
                "v": t[1].tolist(),
                "net": c.tolist(),
                "parameters": x.tolist(),
                "orders": orders,
                "partials": [spline(x, nu=order).tolist() for order in orders],
            }


def insertions():
    for degree in range(1, 6):
        t = knots(degree, 5, True)
        spline = BSpline(t, random.normal(size=(len(t) - degree - 1, 2)), degree)
        x = float(random.uniform(0.05, 0.95))
        times = int(random.integers(1, degree + 1))
        finer = spline.insert_knot(x, times)
        count = len(t) + times - degree - 1
        yield {
            "degree": degree,
            "knots": t.tolist(),
            "points": spline.c.tolist(),
            "inserted": [x] * times,
            "finer": finer.c[:count].tolist(),
        }


def fits():
    for degree in range(1, 6):
        x = np.sort(random.uniform(0.0, 1.0, 20))
        x[0], x[-1] = 0.0, 1.0
        y = random.normal(size=(20, 2))
        exact = make_interp_spline(x, y, k=degree)
        inner = np.linspace(0.0, 1.0, 6)[1:-1]
        t = np.r_[np.zeros(degree + 1), inner, np.ones(degree + 1)]
        weights = random.uniform(0.5, 2.0, 20)
        near = make_lsq_spline(x, y, t, k=degree, w=weights)
        yield {
            "degree": degree,
            "parameters": x.tolist(),
            "data": y.tolist(),
            "weights": weights.tolist(),
            "interpolating": {"knots": exact.t.tolist(), "points": exact.c.tolist()},
            "least_squares": {"knots": near.t.tolist(), "points": near.c.tolist()},
        }


golden = {
    "curves": list(curves()),
    "surfaces": list(surfaces()),
    "insertions": list(insertions()),
    "fits": list(fits()),
}
Path(__file__).with_suffix(".json").write_text(json.dumps(golden, separators=(",", ":")) + "\n")

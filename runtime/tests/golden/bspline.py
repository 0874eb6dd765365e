#!/usr/bin/env python3
"""Writes bspline.json: splines, evaluated, refined and fitted by scipy, and rows of splices, for the tests in ../bspline.

    pip install scipy numpy && python3 bspline.py
"""

import json
from pathlib import Path

import numpy as np
from scipy.interpolate import BSpline, NdBSpline, make_interp_spline, make_lsq_spline, make_smoothing_spline

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


def samples(t, degree):
    """Both ends of the domain, and the middle of every span."""
    breaks = np.unique(t[degree : len(t) - degree])
    return np.r_[breaks[0], (breaks[1:] + breaks[:-1]) / 2, breaks[-1]]


def collocation(t, degree, x, order):
    return BSpline(t, np.eye(len(t) - degree - 1), degree)(x, nu=order)


def kkt(hessian, gradient, a, right):
    """The least change x that minimises xᵀ H x / 2 + gᵀ x subject to A x = b: all at once, as the paper writes it."""
    system = np.block([[hessian, a.T], [a, np.zeros((len(a), len(a)))]])
    return np.linalg.lstsq(system, np.r_[-gradient, right], rcond=1e-13)[0][: len(hessian)]


def splices():
    """spl-G0 and spl-G1 for one round: the row on the edge and the one next to it."""
    for degree, other, spans, straight in ((2, 3, 4, False), (3, 3, 5, False), (3, 2, 6, True), (4, 3, 4, False)):
        simple = lambda k, n: np.r_[np.zeros(k + 1), np.sort(random.uniform(0.05, 0.95, n - 1)), np.ones(k + 1)]
        v, t = simple(degree, spans), simple(other, spans + 2)
        along = [np.array([np.mean(x[i + 1 : i + 1 + k]) for i in range(len(x) - k - 1)]) for x, k in ((v, degree), (t, other))]
        row = lambda y, x, height: np.stack([x + 0 * y, y, height], axis=1)
        edge = row(along[0], -0.03, 0.3 * np.sin(3.0 * along[0]))
        inner = row(along[0], -0.25, 0.25 * np.sin(2.5 * along[0]) + 0.05)
        wave = 0.37 * along[1] if straight else 0.3 * np.sin(3.4 * along[1])
        target = [row(along[1], 0.013 * along[1] if straight else 0.0, wave), row(along[1], 0.3, 0.35 * np.sin(3.1 * along[1]) - 0.1)]

        q = samples(v, degree)
        a, slopes = (collocation(v, degree, q, order) for order in (0, 1))
        points, tangents = (BSpline(t, target[0], other)(q, nu=order) for order in (0, 1))
        across = BSpline(t, target[1] - target[0], other)(q)
        size = len(v) - degree - 1
        each = np.kron(a, np.eye(3))
        hessian = np.zeros((3 * size, 3 * size))
        for slope, c in zip(slopes, tangents):
            hessian += 2 * np.kron(np.outer(slope, slope), c @ c * np.eye(3) - np.outer(c, c))
        moved = edge + kkt(hessian, hessian @ edge.ravel(), each, (points - a @ edge).ravel()).reshape(-1, 3)

        normals = np.cross(across, tangents)
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        out = a @ (moved - inner)
        wanted = np.sum(out * normals, axis=1)[:, None] * normals
        turned = inner + kkt(2 * np.eye(3 * size), np.zeros(3 * size), each, wanted.ravel()).reshape(-1, 3)
        yield {
            "degrees": [degree, other],
            "knots": [v.tolist(), t.tolist()],
            "rows": [edge.tolist(), inner.tolist()],
            "target": [row.tolist() for row in target],
            "spliced": [moved.tolist(), turned.tolist()],
        }


def smoothings():
    for factor in (1e-6, 1e-3, 1.0):
        x = np.sort(random.uniform(-1.0, 3.0, 15))
        y = np.sin(2.0 * x) + 0.1 * random.normal(size=15)
        weights = random.uniform(0.5, 2.0, 15)
        spline = make_smoothing_spline(x, y, w=weights**2, lam=factor)
        at = np.linspace(x[0], x[-1], 30)
        yield {
            "factor": factor,
            "parameters": x.tolist(),
            "data": y.tolist(),
            "weights": weights.tolist(),
            "at": at.tolist(),
            "values": spline(at).tolist(),
        }


golden = {
    "curves": list(curves()),
    "surfaces": list(surfaces()),
    "insertions": list(insertions()),
    "fits": list(fits()),
    "splices": list(splices()),
    "smoothings": list(smoothings()),
}
Path(__file__).with_suffix(".json").write_text(json.dumps(golden, separators=(",", ":")) + "\n")

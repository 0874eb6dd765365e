"""The work of benches/splines.rs in SciPy: python3 benches/splines.py (needs numpy and scipy; one thread is enough).

SciPy is called once for all parameters. The best of many rounds.
"""

import time

import numpy as np
from scipy.interpolate import BSpline, NdBSpline, make_lsq_spline, splprep

COUNT, SPANS, SIDE = 4096, 64, 64


def best(units, work, rounds=60):
    """The best time in nanoseconds for one of `units` in a call."""
    times = []
    for _ in range(rounds):
        start = time.perf_counter_ns()
        work()
        times.append((time.perf_counter_ns() - start) / units)
    return min(times)


def knots(spans):
    return np.r_[[0.0] * 3, np.linspace(0.0, 1.0, spans + 1), [1.0] * 3]


def net(rows, columns):
    x, y = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    return np.stack([x, y + 0.3 * np.sin(0.7 * x), np.cos(0.4 * x) * np.sin(0.3 * y)], axis=-1).astype(float)


def main():
    ts = np.linspace(0.0, 1.0, COUNT)
    curve = BSpline(knots(SPANS), net(SPANS + 3, 1)[:, 0], 3)
    first, second = curve.derivative(), curve.derivative(2)
    surface = NdBSpline((knots(16), knots(16)), net(19, 19), 3)
    side = np.linspace(0.0, 1.0, SIDE)
    pairs = np.stack(np.meshgrid(side, side, indexing="ij"), axis=-1)
    middles = (np.arange(SPANS) + 0.5) / SPANS

    def refine():
        finer = curve
        for t in middles:
            finer = finer.insert_knot(t)

    print("| work | SciPy |\n| --- | --- |")
    print(f"| a point of a curve | {best(COUNT, lambda: curve(ts)):.1f} ns |")
    three = best(COUNT, lambda: (curve(ts), first(ts), second(ts)))
    print(f"| a point and two derivatives | {three:.1f} ns |")
    print(f"| a point of a surface | {best(SIDE * SIDE, lambda: surface(pairs)):.1f} ns |")
    print(f"| inserting one knot | {best(1, lambda: curve.insert_knot(0.503)) / 1e3:.2f} µs |")
    x = np.arange(1000) / 100
    wave = np.stack([x, np.sin(x)], axis=-1)

    def chords():
        steps = np.hypot(*np.diff(wave, axis=0).T)
        return np.r_[0.0, np.cumsum(steps)] / steps.sum()

    def over_knots():
        return make_lsq_spline(chords(), wave, knots(20), 3)

    def within():
        # The sum of squares that a largest distance of 1e-3 allows at most; the distance itself cannot be asked for.
        return splprep(wave.T, s=len(wave) * 1e-6, k=3)

    print(f"| a cubic along 1000 points over 20 spans | {best(1, over_knots) / 1e6:.2f} ms |")
    print(f"| within 1e-3 in the mean square | {best(1, within) / 1e6:.2f} ms |")
    print(f"| inserting 64 knots, one after the other | {best(1, refine, 20) / 1e3:.1f} µs |")


main()

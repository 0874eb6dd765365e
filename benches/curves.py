"""The work of benches/curves.rs in SciPy: python3 benches/curves.py (needs numpy and scipy; one thread is enough).

SciPy is called once for 4000 parameters. Nanoseconds for one point, length or nearest point, the best of many rounds.
"""

import time

import numpy as np
from scipy.integrate import quad
from scipy.interpolate import BPoly, BSpline
from scipy.optimize import minimize_scalar

COUNT = 4000
POINTS = np.array([[0.0, 0.0, 0.0], [1.0, 2.0, -1.0], [3.0, 2.5, 0.5], [4.0, 0.0, 1.0]])


def best(units, work, rounds=60):
    """The best time in nanoseconds for one of `units` in a call."""
    times = []
    for _ in range(rounds):
        start = time.perf_counter_ns()
        work()
        times.append((time.perf_counter_ns() - start) / units)
    return min(times)


def main():
    ts = np.linspace(0.0, 1.0, COUNT)
    bezier = BPoly(POINTS[:, np.newaxis, :], [0.0, 1.0])
    spline = BSpline([0.0] * 4 + [1.0] * 4, POINTS, 3)
    print("| work | SciPy | time |\n| --- | --- | --- |")
    for name, curve in (("BPoly", bezier), ("BSpline", spline)):
        first, second = curve.derivative(), curve.derivative(2)
        print(f"| a point | {name}, f64 3D | {best(COUNT, lambda: curve(ts)):.1f} ns |")
        three = best(COUNT, lambda: (curve(ts), first(ts), second(ts)))
        print(f"| a point and two derivatives | {name}, f64 3D | {three:.1f} ns |")
    velocity = bezier.derivative()
    length = best(1, lambda: quad(lambda t: np.linalg.norm(velocity(t)), 0.0, 1.0, epsabs=1e-9), 20)
    print(f"| arc length to 1e-9 | quad, f64 3D | {length:.0f} ns |")
    target = np.array([2.0, 3.0, 0.25])
    distance = lambda t: np.sum((bezier(t) - target) ** 2)
    nearest = best(1, lambda: minimize_scalar(distance, bounds=(0.0, 1.0), method="bounded", options={"xatol": 1e-9}), 20)
    print(f"| nearest point to 1e-9 | minimize_scalar, f64 3D (local) | {nearest:.0f} ns |")


if __name__ == "__main__":
    main()

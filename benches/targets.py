"""Values and points by emitted Python beside hand-written numpy, in ns each; see targets.sh."""

import time

import numpy
from quartic import QuarticBernstein

COUNT = 100_000


def shortest(work):
    times = []
    for _ in range(30):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return min(times) * 1e9 / COUNT


def values_by_hand(t, l):
    s = 1 - t
    return (
        (1 - l * t) * s**3,
        (3 + l - l * t) * t * s**2,
        (3 + l * t) * t**2 * s,
        (1 - l + l * t) * t**3,
    )


def values_by_better_hand(t, l):
    s = 1 - t
    s2, t2, lt = s * s, t * t, l * t
    return (1 - lt) * (s2 * s), (3 + l - lt) * (t * s2), (3 + lt) * (t2 * s), (1 - l + lt) * (t2 * t)


family = QuarticBernstein(0.5)
points = numpy.array([[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]])
curve = family.bind(points)
t = numpy.linspace(0.0, 1.0, COUNT)


def point_by_hand(t):
    return sum(b[..., None] * p for b, p in zip(values_by_better_hand(t, 0.5), points))


for what, ours, hand in [
    ("values, as the formulas are written", lambda: family.values(t), lambda: values_by_hand(t, 0.5)),
    ("values, powers shared", lambda: family.values(t), lambda: values_by_better_hand(t, 0.5)),
    ("a point of a quartic curve", lambda: curve.eval(t), lambda: point_by_hand(t)),
]:
    ours, hand = shortest(ours), shortest(hand)
    print(f"| Python, {what} | {ours:.2f} ns | {hand:.2f} ns | {ours / hand:.2f} |")

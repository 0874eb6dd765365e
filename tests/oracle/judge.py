#!/usr/bin/env python3
"""Independent judges: random families, theorems and joins, and verdicts of `basis check` on them held against values that
are computed here: `judge.py BASIS [--claims 1000] [--seed N] [--kind product] [--keep DIR]`.

Nothing of the engine is used but its verdicts. A claim that is proved is evaluated at many points, one that is refuted at the
point that the counterexample names. Where the truth is known, by construction or because sympy counts roots or
determines ranks, the verdict has to be that. The seed is printed; with the same seed and number of claims, the same claims
are made. The exit code is 1 if a verdict is wrong. With `--lie`, refuted claims are taken for proved ones, to see how many
false verdicts would be noticed.
"""

import argparse
import json
import random
import re
import subprocess
import sys
import tempfile
import time
from collections import Counter
from fractions import Fraction
from itertools import combinations
from pathlib import Path

import mpmath
import sympy

from algebra import rank
from formula import Call, Derivative, Formula, Member, Name, Number, formula, to_float

mpmath.mp.dps = 60
TINY = mpmath.mpf(10) ** -40


def is_zero(x):
    return abs(x) < TINY if isinstance(x, mpmath.mpf) else x == 0


def holds(relation, x):
    """Whether a value is as claimed; of floats, whether it can be."""
    if relation == '=':
        return is_zero(x)
    if isinstance(x, mpmath.mpf):
        return x > -TINY
    return x > 0 if relation == '>' else x >= 0


class Range:
    """A range of numbers; an end is a number or `None`."""

    def __init__(self, low, high, low_in=True, high_in=True):
        self.low, self.high = low, high
        self.low_in, self.high_in = low_in and low is not None, high_in and high is not None

    def text(self, name):
        left = '' if self.low is None else f'{self.low} {"<=" if self.low_in else "<"} '
        right = '' if self.high is None else f' {"<=" if self.high_in else "<"} {self.high}'
        return f'{left}{name}{right}'

    def contains(self, x):
        low, high = self.low, self.high
        if any(isinstance(y, mpmath.mpf) for y in (x, low, high)):
            x, low, high = map(to_float, (x, low, high))
        above = low is None or x > low or self.low_in and x == low
        return above and (high is None or x < high or self.high_in and x == high)

    def ends(self):
        return [x for x, own in [(self.low, self.low_in), (self.high, self.high_in)] if own]

    def sample(self, r):
        ends = self.ends()
        if ends and r.random() < 0.25:
            return r.choice(ends)
        s = Fraction(r.randint(1, 40), 41)
        if self.low is not None and self.high is not None:
            return self.low + (self.high - self.low) * s
        far = s / (1 - s) * r.choice([1, 1, 3])
        if self.low is not None:
            return self.low + far
        return self.high - far if self.high is not None else far * r.choice([-1, 1])


def number(r, size=4):
    return Fraction(r.randint(-size, size), r.choice([1, 1, 1, 2, 3]))


def any_range(r):
    low = number(r)
    high = low + Fraction(r.randint(1, 6), r.choice([1, 2, 3]))
    kind = r.random()
    if kind < 0.12:
        high = None
    elif kind < 0.18:
        low = None
    return Range(low, high, r.random() < 0.8, r.random() < 0.8)


def polynomial(r, names, degree=3, terms=4):
    total = formula(number(r))
    for _ in range(r.randint(1, terms)):
        term = formula(number(r))
        for name in names:
            e = r.randint(0, degree)
            if e:
                term = term * (Name(name) ** e if e > 1 else Name(name))
        total = total + term
    return total


def square_sum(r, names):
    """A sum of squares and a number that is about zero: near misses."""
    total = formula(r.choice([0, 0, Fraction(1, 1000), Fraction(-1, 1000), Fraction(1, 10**9), 1]))
    for _ in range(r.randint(1, 2)):
        total = total + polynomial(r, names, 2, 2) ** 2
    return total


class Family:
    """A family with its domain: `domain` has a range for each variable, `simplices` those that are barycentric."""

    def __init__(self, r, name):
        self.r, self.name = r, name
        self.shapes, self.domain, self.lines, self.functions = {}, {}, [], {}
        self.recursive = self.floats = False
        self.simplices = []
        self.spans = None
        self.orders = [None]

    def shape(self, r, most=2):
        for name in ['k', 'm'][:r.randint(0, most)]:
            self.shapes[name] = any_range(r)
        return list(self.shapes)

    def function(self, index, env):
        return self.functions[index].eval(env)

    def members(self):
        return [Member(self, index) for index in self.functions]

    def text(self):
        shapes = ''.join(f'    shape {s.text(n)};\n' for n, s in self.shapes.items())
        own = ''.join(f'    b[{",".join(map(str, i))}] = {f.text()};\n' for i, f in self.functions.items())
        return f'family {self.name} {{\n    {self.domain_text()}\n{shapes}{own}'

    def domain_text(self):
        factors = {n: s.text(n) for n, s in self.domain.items()}
        for names in self.simplices:
            kind = {3: 'triangle', 4: 'tetrahedron'}[len(names)]
            for name in names[1:]:
                del factors[name]
            factors[names[0]] = f'{kind} ({", ".join(names)})'
        return f'domain {", ".join(factors.values())};'

    def sample(self, r):
        """A point of the domain with shape values."""
        env = {n: s.sample(r) for n, s in self.shapes.items()}
        for names in self.simplices:
            weights = [r.choice([0, 0, 1, 1, 2, 3, 5]) for _ in names]
            if not any(weights):
                weights[0] = 1
            env.update({n: Fraction(w, sum(weights)) for n, w in zip(names, weights)})
        env.update({n: s.sample(r) for n, s in self.domain.items() if n not in env})
        return env

    def contains(self, env):
        if not all(s.contains(env[n]) for n, s in self.shapes.items()):
            return False
        return all(s.contains(env[n]) for n, s in self.domain.items()) and all(
            is_zero(sum(env[n] for n in names) - 1) for names in self.simplices)

    def integral(self, f):
        """The integral of a polynomial over the domain, as a polynomial in the shape parameters."""
        x = sympy.expand(f.eval(self.symbols()))
        for n, s in self.domain.items():
            if not any(n in names for names in self.simplices):
                x = sympy.integrate(x, (n, sympy.Rational(str(s.low)), sympy.Rational(str(s.high))))
        for names in self.simplices:
            rest = sympy.Integer(1) - sum(map(sympy.Symbol, names[:-1]))
            for n in names[-2::-1]:
                rest = rest + sympy.Symbol(n)
                x = sympy.integrate(x, (n, 0, rest))
        return sympy.expand(x)

    def symbols(self):
        """Symbols for all variables, of each simplex the last one expressed by the others."""
        at = {n: sympy.Symbol(n) for n in [*self.domain, *self.shapes]}
        for names in self.simplices:
            at[names[-1]] = 1 - sum(at[n] for n in names[:-1])
        return at


class Spans(Family):
    """A family on neighbouring spans: `functions` has a list of formulas for each index."""

    def spans_at(self, env):
        return [k for k, (low, high) in enumerate(zip(self.knots, self.knots[1:])) if low <= env['t'] <= high]

    def function(self, index, env):
        x, formulas = env[self.variable], self.functions[index]
        while hasattr(x, 'a'):
            x = x.a
        span = env.get('span')
        if span is None:
            span = next(k for k, b in enumerate(self.knots[1:]) if x <= b)
        return formulas[span].eval(env)

    def text(self):
        shapes = ''.join(f'    shape {s.text(n)};\n' for n, s in self.shapes.items())
        own = ''.join(f'    b[{i[0]}] = {" | ".join(f.text() for f in fs)};\n' for i, fs in self.functions.items())
        v, k = self.variable, self.knots
        domain = ', '.join(f'{a} <= {v} <= {b}' for a, b in zip(k, k[1:]))
        return f'family {self.name} {{\n    domain {domain};\n{shapes}{own}'


class Arcs(Spans):
    """A family on spans between multiples of an angle that is a shape parameter, or between numbers, with sin and cos or
    exponentials."""

    def unit(self, env):
        return env['a'] if 'a' in self.shapes else 1

    def function(self, index, env):
        x, formulas = env['t'], self.functions[index]
        while hasattr(x, 'a'):
            x = x.a
        span = env.get('span')
        if span is None:
            unit = self.unit(env)
            span = next((k for k, b in enumerate(self.knots[1:]) if x <= to_float(b) * unit), len(formulas) - 1)
        return formulas[span].eval(env)

    def end(self, knot):
        if 'a' not in self.shapes or knot == 0:
            return str(knot)
        return 'a' if knot == 1 else f'{knot}*a'

    def text(self):
        shapes = ''.join(f'    shape {s.text(n)};\n' for n, s in self.shapes.items())
        own = ''.join(f'    b[{i[0]}] = {" | ".join(f.text() for f in fs)};\n' for i, fs in self.functions.items())
        k = self.knots
        domain = ', '.join(f'{self.end(a)} <= t <= {self.end(b)}' for a, b in zip(k, k[1:]))
        return f'family {self.name} {{\n{shapes}    domain {domain};\n{own}'

    def sample(self, r):
        env = {n: to_float(s.sample(r)) for n, s in self.shapes.items()}
        env['t'] = to_float(Range(self.knots[0], self.knots[-1]).sample(r)) * self.unit(env)
        return env

    def spans_at(self, env):
        t, unit = to_float(env['t']), to_float(self.unit(env))
        knots = [to_float(knot) * unit for knot in self.knots]
        return [k for k, (low, high) in enumerate(zip(knots, knots[1:])) if low - TINY <= t <= high + TINY]

    def contains(self, env):
        return bool(self.spans_at(env)) and all(s.contains(env[n]) for n, s in self.shapes.items())

    def mirrored(self):
        total = self.knots[0] + self.knots[-1]
        return Name('t') * -1 + (Name('a') * total if 'a' in self.shapes else total)


def arcs(r, own):
    """Sines of an angle whose range ends at any multiple of pi, or exponentials; on one span, or on several of different
    lengths."""
    own.floats = True
    t = Name('t')
    count = r.randint(1, 3)
    own.knots = [Fraction(0)]
    for _ in range(count):
        own.knots.append(own.knots[-1] + r.choice([1, 1, 2]))
    if r.random() < 0.4:
        scale = r.choice([1, 1, 2])
        own.knots = [k / scale for k in own.knots]
        s, c = Call('exp', t), Call('exp', t * -1)
        parts = [s, c, t, formula(1)]
        bumps = [lambda x: Call('exp', x) - 1, lambda x: Call('cosh', x) - 1, lambda x: Call('sinh', x) - x]
    else:
        if count == 1:
            own.knots = [Fraction(0), Fraction(1)]
        # The last knot stays below a half turn.
        turns = own.knots[-1]
        highs = [h for h in ['pi', '2*pi/3', 'pi/2', '2*pi/5', 'pi/3', 'pi/4', 'pi/6', 'pi/12'] if ENDS[h]() * to_float(turns) < 3.1415926536]
        own.shapes['a'] = Range('0', r.choice(highs), False, False)
        if r.random() < 0.3:
            high = Fraction(r.randint(1, 12), 4) / turns
            own.shapes['a'] = Range(Fraction(r.choice([0, 0, 1]), 2 * turns) if high * turns > 1 else Fraction(0), high,
                                    False, r.random() < 0.5)
        s, c = Call('sin', t), Call('cos', t)
        parts = [s, c, Call('sin', Name('a')) * c, formula(1) - c, formula(1)]
        bumps = [lambda x: Call('sin', x), lambda x: formula(1) - Call('cos', x),
                 lambda x: Call('sin', x) * (formula(1) - Call('cos', x))]
    for i in range(2):
        pieces = [r.choice(parts) * number(r) + r.choice(parts) * r.choice(parts)]
        for knot in own.knots[1:-1]:
            # The k-th bump has k derivatives that vanish; or a jump, or nothing.
            x = t + (Name('a') * -knot if 'a' in own.shapes else -knot)
            step = r.choice([formula(0), formula(0), formula(Fraction(1, 3)), *[bump(x) for bump in bumps]])
            pieces.append(pieces[-1] + step)
        own.functions[(i,)] = pieces


class Constant(Formula):
    """A number that is not rational, such as pi."""

    def __init__(self, written, value):
        self.written, self.value = written, value

    def text(self):
        return self.written

    def eval(self, env):
        return self.value


def turns(r, own):
    """Sines of parts of an angle with tangents that are irrational at an end of the domain, and numbers made of them."""
    own.floats = True
    pi = Constant('pi', mpmath.pi * 1)
    if r.random() < 0.5:
        own.domain['t'] = Range(Fraction(r.choice([0, 0, -1])), Fraction(1))
        rate = Fraction(*r.choice([(1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (2, 3), (3, 4), (3, 8), (1, 12), (1, 7)]))
        angle = pi * Name('t') * rate
    else:
        own.domain['t'] = r.choice([Range('0', 'pi/2'), Range('0', 'pi'), Range('-pi/2', 'pi/2'), Range('-pi/2', 'pi')])
        angle = Name('t') * Fraction(*r.choice([(1, 1), (1, 2), (1, 3), (2, 3), (3, 2), (1, 4), (1, 5)]))
    n = r.choice([3, 4, 5, 6, 8, 12])
    number_ = Call(r.choice(['sin', 'cos']), pi / n)
    s, c = Call('sin', angle), Call('cos', angle)
    parts = [s, c, s * c, c - number_, s - number_, Call('sin', angle + pi / n), formula(1)]
    if r.random() < 0.3:
        parts += [Name('t') * number_, Name('t') - s]
    for i in range(r.randint(2, 3)):
        own.functions[(i,)] = r.choice(parts) * number(r) + r.choice(parts) * r.choice(parts)


def place_claim(r, own):
    """A value of a function, or of its slope, at a part of a turn."""
    s, part = own.domain['t'], Fraction(r.randint(-12, 12), r.choice([2, 3, 4, 5, 6, 8, 12]))
    in_turns = isinstance(s.low, Fraction)
    x, written = (part, str(part)) if in_turns else (mpmath.pi * to_float(part), f'{part.numerator}*pi/{part.denominator}')
    if not s.contains(x):
        return None
    index = r.choice(list(own.functions))
    f = Member(own, index)
    own_value = re.sub(r'\bt\b', f'({written})', own.functions[index].text())
    env = floats(own, {'t': x})
    g = Constant(own_value, f.eval(env))
    if r.random() < 0.4:
        f, g = Derivative(f, 't'), formula(0)
    v = f.eval(env)
    if r.random() < 0.4:
        g = formula(Fraction(int(mpmath.floor(v * 1000)) + r.choice([0, 1]), 1000))
    else:
        g = g + r.choice([formula(0), formula(0), formula(Fraction(r.choice([-1, 1]), 10**9)), Constant('sin(pi/5)/10^9', mpmath.sin(mpmath.pi / 5) / 10**9)])
    relation, d = r.choice(['=', '=', '>=', '>']), v - g.eval(env)
    truth = abs(d) < TINY and relation != '>' or relation != '=' and d > TINY
    return Claim(f'at t = {written} {{ {f.text()} {relation} {g.text()}; }}', [(relation, f - g, {'t': x})], truth)


class Related(Family):
    """A family whose shape parameters depend on one another, by a chain or by what is assumed; `between` are those at the ends
    of the domain, if there are any."""

    between = None

    def __init__(self, r, name):
        super().__init__(r, name)
        self.declared, self.conditions = [], []

    def text(self):
        shapes = ''.join(f'    {line};\n' for line in self.declared)
        own = ''.join(f'    b[{i[0]}] = {f.text()};\n' for i, f in self.functions.items())
        domain = f'domain {" <= t <= ".join(self.between)};' if self.between else self.domain_text()
        return f'family {self.name} {{\n    {domain}\n{shapes}{own}'

    def fits(self, env):
        return all(holds(relation, f.eval(env)) for relation, f in self.conditions)

    def sample(self, r):
        while True:
            env = {n: s.sample(r) for n, s in self.shapes.items()}
            if self.fits(env):
                break
        if self.between:
            low, high = (env[n] for n in self.between)
            env['t'] = Range(low, high).sample(r)
        else:
            env['t'] = self.domain['t'].sample(r)
        return env

    def contains(self, env):
        shapes = all(s.contains(env[n]) for n, s in self.shapes.items()) and self.fits(env)
        if self.between:
            low, high = (env[n] for n in self.between)
            return shapes and low <= env['t'] <= high
        return shapes and self.domain['t'].contains(env['t'])

    def integral(self, f):
        t = sympy.Symbol('t')
        x = sympy.expand(f.eval(self.symbols()))
        s = self.domain.get('t')
        low, high = map(sympy.Symbol, self.between) if self.between else (sympy.Rational(str(e)) for e in (s.low, s.high))
        return sympy.expand(sympy.integrate(x, (t, low, high)))


def related(r, own):
    k, m = Name('k'), Name('m')
    low, size = number(r), Fraction(r.randint(1, 4), r.choice([1, 2]))
    kind = r.choice(['chain', 'ends', 'chain', 'linear', 'disk', 'product'])
    own.shapes = {n: Range(low, low + size) for n in 'km'}
    if kind in ('chain', 'ends'):
        strict = [r.random() < 0.4 for _ in range(3)]
        strict[1] |= kind == 'ends'
        signs = ['<' if s else '<=' for s in strict]
        own.declared = [f'shape {low} {signs[0]} k {signs[1]} m {signs[2]} {low + size}']
        own.shapes['k'] = Range(low, low + size, not strict[0], not strict[1] and not strict[2])
        own.shapes['m'] = Range(low, low + size, not strict[0] and not strict[1], not strict[2])
        own.conditions = [('>' if strict[1] else '>=', m - k)]
    else:
        own.declared = [f'shape {own.shapes[n].text(n)}' for n in 'km']
        middle = low + size / 2
        if kind == 'linear':
            a, b = r.choice([(1, 1), (1, 2), (-1, 1), (2, -1)])
            x = k * a + m * b - (a + b) * middle
            x = x + Fraction(r.randint(0, 2), 3)
        elif kind == 'disk':
            x = formula(size * size * Fraction(1, 4)) - (k - middle) ** 2 - (m - middle) ** 2
        else:
            x = (k - low) * (m - low) - size * size * Fraction(r.randint(0, 3), 4)
        relation = r.choice(['>=', '>='] if kind == 'disk' else ['>=', '>'])
        if kind == 'product' and relation == '>':
            x = x + size * size * Fraction(1, 100)
        own.declared.append(f'assume {x.text()} {relation} 0')
        own.conditions = [(relation, x)]
    if kind == 'ends':
        own.between, own.domain = ('k', 'm'), {'t': Range(low, low + size)}
        t, parts = Name('t'), [Name('t') - k, m - Name('t'), m - k, formula(1)]
    else:
        own.domain = {'t': Range(Fraction(0), Fraction(1))}
        t, parts = Name('t'), [Name('t'), formula(1) - Name('t'), k, m, m - k, formula(1)]
        parts += [x for _, x in own.conditions]
    for i in range(2):
        f = r.choice(parts) * r.choice(parts) * r.choice(parts)
        own.functions[(i,)] = f + (polynomial(r, ['t', 'k', 'm'], 1, 1) if r.random() < 0.5 else 0)
    if r.random() < 0.3:
        own.functions[(2,)] = formula(1) - Member(own, (0,)) - Member(own, (1,))


def positive(r, own):
    """Combinations of Bernstein polynomials by products of bidiagonal matrices, whose minors are nonnegative, or nearly so."""
    n = r.randint(1, 3)
    t = Name('t')
    own.domain['t'] = Range(Fraction(0), Fraction(1))
    row = [[Fraction(int(i == j)) for j in range(n + 1)] for i in range(n + 1)]
    for _ in range(r.randint(0, 3)):
        k, x = r.randrange(n), Fraction(r.choice([0, 1, 1, 2, 3, -1]), r.choice([1, 2]))
        a, b = (k, k + 1) if r.random() < 0.5 else (k + 1, k)
        row = [[row[i][j] + (x * row[i][a] if j == b else 0) for j in range(n + 1)] for i in range(n + 1)]
    if r.random() < 0.3:
        i = r.randrange(n)
        row[i], row[i + 1] = row[i + 1], row[i]
    for j in range(n + 1):
        total = formula(0)
        for i in range(n + 1):
            if row[i][j]:
                total = total + (formula(1) - t) ** (n - i) * t**i * (row[i][j] * binomial(n, i))
        own.functions[(j,)] = total


class Raised(Family):
    """A family of one order n of a recursion b[i] = p·b[i] + q·b[i − 1]."""

    def function(self, index, env):
        return self.of_order(self.order, index[0], env)

    def of_order(self, n, i, env):
        if i < 0 or i > n:
            return 0
        if n == 1:
            return self.lowest[i].eval(env)
        return self.p.eval(env) * self.of_order(n - 1, i, env) + self.q.eval(env) * self.of_order(n - 1, i - 1, env)

    def text(self):
        shapes = ''.join(f'    shape {s.text(n)};\n' for n, s in self.shapes.items())
        return (
            f'family {self.name}(n in {self.order}..={self.order}) {{\n    {self.domain_text()}\n{shapes}'
            f'    base n = 1 {{ b[0] = {self.lowest[0].text()}; b[1] = {self.lowest[1].text()}; }}\n'
            f'    raise b[i] = {self.p.text()}*b[i] + {self.q.text()}*b[i - 1];\n'
        )


def basis_like(r, t, names, low, high):
    """A product as it occurs in families: powers of the distances from the ends times a linear factor."""
    f = formula(number(r))
    if low is not None:
        f = f + 1 if r.random() < 0.3 else formula(1)
        f = f * (t - low) ** r.randint(0, 2)
    if high is not None:
        f = f * (Number(high) - t) ** r.randint(0, 2)
    if names and r.random() < 0.7:
        f = f * (formula(number(r)) + Name(r.choice(names)) * r.choice([t, formula(1)]))
    return f


def family(r, name, kind=None):
    """A random family, of any kind or of this one."""
    kind = kind or r.choices(['poly', 'rational', 'box', 'triangle', 'tetrahedron', 'product', 'angle', 'exp', 'spans',
                              'raise', 'arcs', 'related', 'positive', 'turns'], [7, 3, 2, 2, 1, 2, 3, 2, 3, 2, 4, 4, 1, 3])[0]
    own = {'spans': Spans, 'raise': Raised, 'arcs': Arcs, 'related': Related}.get(kind, Family)(r, name)
    own.kind = kind
    n = r.randint(2, 3)
    if kind in ('poly', 'rational'):
        names = own.shape(r, 1 if kind == 'rational' else 2)
        low = number(r)
        high = low + Fraction(r.randint(1, 4), r.choice([1, 2]))
        own.domain['t'] = Range(low, high, r.random() < 0.9, r.random() < 0.9)
        t, s = Name('t'), own.domain['t']
        for i in range(n):
            f = basis_like(r, t, names, s.low, s.high) if r.random() < 0.6 else polynomial(r, ['t'] + names, 2)
            own.functions[(i,)] = f
        if kind == 'rational':
            if r.random() < 0.7:
                below = polynomial(r, ['t'] + names, 1, 1) ** 2 + Fraction(1, r.choice([1, 2, 100]))
            else:
                below = polynomial(r, ['t'] + names, 2, 2)
            own.denominator = below
            own.functions = {i: f / below for i, f in own.functions.items()}
    elif kind == 'box':
        names = own.shape(r, 1)
        own.domain = {'u': Range(number(r), None), 'v': Range(Fraction(0), Fraction(1))}
        own.domain['u'] = Range(own.domain['u'].low, own.domain['u'].low + r.randint(1, 3), r.random() < 0.9)
        for i in range(n):
            own.functions[(i,)] = polynomial(r, ['u', 'v'] + names, 1, 3)
    elif kind in ('triangle', 'tetrahedron'):
        names = own.shape(r, 1)
        variables = ['u', 'v', 'w', 'x'][:3 if kind == 'triangle' else 4]
        own.simplices = [variables]
        own.domain = {v: Range(Fraction(0), Fraction(1)) for v in variables}
        indices = [tuple(int(i == j) for j in range(len(variables))) for i in range(len(variables))]
        for k, i in enumerate(indices):
            own.functions[i] = Name(variables[k]) + polynomial(r, variables + names, 1, 2) * r.choice([0, 1])
    elif kind == 'product':
        names = own.shape(r, 1)
        low = number(r, 2)
        z = ('z', Range(low, low + r.randint(1, 3), r.random() < 0.9, r.random() < 0.9))
        unit = Range(Fraction(0), Fraction(1))
        first, second = [(v, unit) for v in 'uvw'], [(v, unit) for v in 'pqr'[:3]]
        factors = r.choice([[first, [z]], [[z], first], [first, second], [[z], [*first, ('x', unit)]],
                            [first, [z], [('y', unit)]]])
        own.domain = {n: s for factor in factors for n, s in factor}
        own.simplices = [[n for n, _ in factor] for factor in factors if len(factor) > 1]
        for i in range(n):
            f = polynomial(r, r.sample(list(own.domain), 2) + names, 1, 3)
            if r.random() < 0.5:
                f = f * polynomial(r, r.sample(list(own.domain), 2), 1, 1)
            own.functions[(i,)] = f
    elif kind == 'angle':
        names, own.floats = own.shape(r, 1), True
        own.domain['t'] = r.choice([Range(Fraction(0), 'pi/2'), Range(Fraction(0), 'pi'), Range('-pi/2', 'pi/2')])
        # Multiples of the angle; and the angle itself, for which inequalities are proved by their derivatives.
        t = r.choice([Name('t'), Name('t'), Name('t') * 2])
        if own.domain['t'].high == 'pi' and r.random() < 0.3:
            t = Name('t') / 2
        s, c = Call('sin', t), Call('cos', t)
        parts = [s, c, formula(1) - s, formula(1) - c, s * c] + [formula(1) + Name(k) * s for k in names]
        if r.random() < 0.4:
            parts = [s, c, Name('t'), Name('t') - s, formula(1) - c, Name('t') ** 2]
        for i in range(n):
            own.functions[(i,)] = r.choice(parts) * r.choice(parts) + number(r) * r.choice([0, 1])
    elif kind == 'exp':
        names, own.floats = own.shape(r, 1), True
        own.domain['t'] = Range(Fraction(0), Fraction(r.randint(1, 2)))
        t = Name('t')
        parts = [Call('exp', t), Call('cosh', t) - 1, Call('sinh', t), formula(2)] + [Name(k) for k in names]
        if r.random() < 0.4:
            parts = [Call('exp', t), Call('exp', t) - 1 - t, t, formula(1) + t, Call('sinh', t) - t]
        for i in range(n):
            own.functions[(i,)] = r.choice(parts) * number(r) + r.choice(parts) * r.choice(parts)
    elif kind == 'arcs':
        own.domain['t'] = Range(Fraction(0), Fraction(1))
        arcs(r, own)
    elif kind == 'turns':
        turns(r, own)
    elif kind == 'related':
        related(r, own)
    elif kind == 'positive':
        positive(r, own)
    elif kind == 'spans':
        own.variable = 't'
        names = own.shape(r, 1)
        knots = [number(r)]
        for _ in range(r.randint(2, 3)):
            knots.append(knots[-1] + Fraction(r.randint(1, 3), r.choice([1, 2])))
        own.knots = knots
        own.domain['t'] = Range(knots[0], knots[-1])
        for i in range(2):
            pieces = [polynomial(r, ['t'], 2, 2)]
            for knot in knots[1:-1]:
                # Continuous with some derivatives, or not.
                e = r.choice([0, 1, 2, 3])
                step = (Name('t') - knot) ** e * number(r) if e else formula(number(r))
                pieces.append(pieces[-1] + step)
            own.functions[(i,)] = [p + Name(names[0]) * Name('t') if names and i else p for p in pieces]
    else:
        own.order = r.randint(2, 3)
        names = own.shape(r, 1)
        own.domain['t'] = Range(Fraction(0), Fraction(1))
        t = Name('t')
        own.lowest = [formula(1) - t, t] if r.random() < 0.6 else [polynomial(r, ['t'] + names, 1, 2) for _ in 'ab']
        own.p, own.q = formula(1) - t, t
        if r.random() < 0.4:
            own.p, own.q = polynomial(r, ['t'], 1, 1), polynomial(r, ['t'], 1, 1)
        own.functions = {(i,): None for i in range(own.order + 1)}
    if kind in ('poly', 'box', 'product') and r.random() < 0.4:
        last = list(own.functions)[-1]
        rest = formula(1)
        for i, f in own.functions.items():
            if i != last:
                rest = rest - f
        own.functions[last] = rest
    return own


ENDS = {'pi': lambda: mpmath.pi * 1, '-pi/2': lambda: -mpmath.pi / 2, '0': lambda: mpmath.mpf(0),
        '2*pi/3': lambda: mpmath.pi * 2 / 3, '2*pi/5': lambda: mpmath.pi * 2 / 5,
        **{f'pi/{n}': lambda n=n: mpmath.pi / n for n in (2, 3, 4, 6, 12)}}


class Claim:
    """A claim: its text, parts (relation, formula, fixed values), and the truth if it is known."""

    def __init__(self, text, parts, truth=None):
        self.text, self.parts, self.truth = text, parts, truth


def relation_claim(r, own, f, relation, g):
    """f ≥ g, f > g, f = g on the whole domain."""
    return Claim(f'{f.text()} {relation} {g.text()}', [(relation, f - g, {})], decided(own, relation, f - g))


def decided(own, relation, f):
    """Whether f ≥ 0 (> 0) on an interval, or f = 0; `None` where sympy is not asked."""
    if own.simplices and relation == '=':
        return sympy.expand(f.eval(own.symbols())) == 0
    if own.kind not in ('poly', 'raise') or own.shapes and relation != '=':
        return None
    t = sympy.Symbol('t')
    symbols = {n: sympy.Symbol(n) for n in own.shapes}
    p = sympy.expand(f.eval({'t': t, **symbols}))
    if relation == '=':
        return p == 0
    s = own.domain['t']
    q = sympy.Poly(p, t)
    if q.is_zero:
        return relation != '>'
    low, high = sympy.Rational(str(s.low)), sympy.Rational(str(s.high))
    # One number between any two neighbouring roots in the range, and the ends.
    square_free = sympy.Poly(sympy.quo(q, sympy.gcd(q, q.diff(t)), t), t)
    roots = [root for root in sympy.real_roots(square_free) if low < root < high] if q.degree() else []
    points = [low] + roots + [high]
    between = [(sympy.Rational(str(sympy.N(a, 30))) + sympy.Rational(str(sympy.N(b, 30)))) / 2
               for a, b in zip(points, points[1:])]
    if any(q.eval(x) < 0 for x in between):
        return False
    zeros = len(roots) + (s.low_in and q.eval(low) == 0) + (s.high_in and q.eval(high) == 0)
    return relation != '>' or zeros == 0


def claims(r, own):
    """Random claims about a family."""
    members = own.members()
    names = list(own.domain) + list(own.shapes)
    result = [TotallyPositive(own)] if own.kind == 'positive' else []
    if own.kind == 'turns':
        replace_ends(own)
        result += [claim for _ in range(4) if (claim := place_claim(r, own))]
    for _ in range(r.randint(4, 7)):
        kind = r.choice(['order', 'order', 'order', 'square', 'equal', 'unity', 'nonnegative', 'independent', 'at',
                         'slope', 'symmetric', 'smooth'] + ['face', 'partial', 'integral', 'swap'] * bool(own.simplices) + ['integral', 'parameters'] * (own.kind == 'related'))
        f = r.choice(members)
        if kind == 'order':
            g = r.choice([formula(number(r)), r.choice(members), formula(0)])
            result.append(relation_claim(r, own, f, r.choice(['>=', '>', '>=']), g))
        elif kind == 'square' and not own.floats and own.kind != 'spans':
            squares = square_sum(r, r.sample(names, min(len(names), r.randint(1, 2))))
            if re.search('[a-z]', squares.text()):
                result.append(relation_claim(r, own, squares, r.choice(['>=', '>']), formula(0)))
        elif kind == 'equal':
            g, h = r.choice(members), r.choice(members)
            p, q = f * (g + h), f * g + f * h
            if r.random() < 0.5:
                result.append(Claim(f'{p.text()} = {q.text()}', [('=', p - q, {})], True))
            else:
                q = q + r.choice(members) * Fraction(1, r.choice([1, 10**6]))
                result.append(Claim(f'{p.text()} = {q.text()}', [('=', p - q, {})]))
        elif kind == 'unity':
            total = formula(-1)
            for m in members:
                total = total + m
            result.append(Claim('partition_of_unity', [('=', total, {})], decided(own, '=', total)))
        elif kind == 'nonnegative':
            known = [decided(own, '>=', m) for m in members]
            truth = False if False in known else None if None in known else True
            result.append(Claim('nonnegative', [('>=', m, {}) for m in members], truth))
        elif kind == 'independent' and not own.simplices and own.kind not in ('box', 'related'):
            result.append(Independent(own))
        elif kind == 'slope' and len(own.domain) == 1:
            d = Derivative(f, 't')
            if r.random() < 0.3:
                d = Derivative(d, 't')
            if own.kind == 'arcs' or r.random() < 0.5 and own.kind != 'spans':
                result.append(relation_claim(r, own, d, r.choice(['>=', '>']), formula(r.choice([0, number(r)]))))
            elif own.kind in ('poly', 'raise', 'rational') and own.domain['t'].low_in:
                x = own.domain['t'].low
                env = {'t': x, **{n: Fraction(1, 7) for n in own.shapes}}
                if not own.shapes:
                    try:
                        v = d.eval(env) + r.choice([0, 0, Fraction(1, 1000)])
                        truth = v == d.eval(env)
                    except ZeroDivisionError:
                        continue
                    text = f'at t = {x} {{ {d.text()} = {Number(v).text()}; }}'
                    result.append(Claim(text, [('=', d - v, {'t': x})], truth))
        elif kind == 'at' and own.shapes and not own.floats:
            name, s = r.choice(list(own.shapes.items()))
            x = own.sample(r)[name] if own.kind == 'related' else s.sample(r)
            g = formula(number(r))
            relation = r.choice(['>=', '=', '>'])
            text = f'at {name} = {x} {{ {f.text()} {relation} {g.text()}; }}'
            result.append(Claim(text, [(relation, f - g, {name: x})]))
        elif kind == 'symmetric' and own.kind in ('poly', 'raise', 'rational', 'spans'):
            s = own.domain['t']
            if s.low_in and s.high_in:
                mirrored = Name('t') * -1 + (s.low + s.high)
                parts = [('=', Difference(a, b, mirrored), {}) for a, b in zip(members, members[::-1])]
                if own.kind != 'spans':
                    result.append(Claim('symmetric', parts))
        elif kind == 'face':
            # A coordinate of a simplex, or a variable, has a fixed value: an end, mostly.
            name, s = r.choice(list(own.domain.items()))
            x = r.choice(s.ends() or [s.sample(r)])
            relation, g = r.choice(['>=', '=', '>']), formula(number(r))
            text = f'at {name} = {x} {{ {f.text()} {relation} {g.text()}; }}'
            result.append(Claim(text, [(relation, f - g, Fixed(own, name, x))]))
        elif kind == 'partial':
            result.append(partial_claim(r, own, f))
        elif kind == 'parameters':
            # About the parameters alone.
            k, m = Name('k'), Name('m')
            g = r.choice([k, m, m - k, k * m, k * k + m * m, m * m - k, *[x for _, x in own.conditions]])
            result.append(relation_claim(r, own, g, r.choice(['>=', '>', '=']), formula(number(r))))
        elif kind == 'integral' and own.kind == 'related':
            value = own.integral(f) + r.choice([0, 0, sympy.Rational(1, 1000)])
            truth = sympy.expand(value - own.integral(f)) == 0
            text = str(value).replace('**', '^')
            result.append(Claim(f'integral({f.text()}) = {text}', [], truth))
        elif kind == 'integral':
            value = own.integral(f)
            if not value.free_symbols:
                value = Fraction(str(value)) + r.choice([0, 0, Fraction(1, 1000)])
                truth = own.integral(f) == sympy.Rational(str(value))
                result.append(Claim(f'integral({f.text()}) = {Number(value).text()}', [('=', Integral(own, f, value), {})], truth))
        elif kind == 'swap':
            # The function with two coordinates of a simplex exchanged, written with arguments.
            names = r.choice(own.simplices)
            a, b = r.sample(names, 2)
            g = r.choice(members)
            arguments = [b if n == a else a if n == b else n for n in own.domain]
            p = Moved(g, dict(zip(own.domain, map(Name, arguments))))
            relation = r.choice(['=', '>='])
            result.append(Claim(f'{f.text()} {relation} {g.text()}({", ".join(arguments)})', [(relation, f - p, {})],
                                decided(own, relation, f - p)))
        elif kind == 'symmetric' and own.kind == 'arcs':
            if all(a + b == own.knots[-1] for a, b in zip(own.knots, own.knots[::-1])):
                parts = [('=', Difference(a, b, own.mirrored(), len(own.knots) - 1), {})
                         for a, b in zip(members, members[::-1])]
                result.append(Claim('symmetric', parts))
        elif kind == 'smooth' and own.kind == 'arcs' and len(own.knots) > 2:
            result.append(SmoothArcs(own, r.randint(0, 3)))
        elif kind == 'smooth' and own.kind == 'spans':
            result.append(Smooth(own, r.randint(0, 2)))
    seen = set()
    return [c for c in result if not (c.text in seen or seen.add(c.text))]


class Difference:
    """a(t) − b(mirrored t)."""

    def __init__(self, a, b, mirrored, spans=1):
        self.a, self.b, self.mirrored, self.spans = a, b, mirrored, spans

    def eval(self, env):
        there = {**env, 't': self.mirrored.eval(env)}
        if env.get('span') is not None:
            there['span'] = self.spans - 1 - env['span']
        return self.a.eval(env) - self.b.eval(there)


class Moved(Formula):
    """f at formulas in place of the variables."""

    def __init__(self, f, by):
        self.f, self.by = f, by

    def eval(self, env):
        return self.f.eval({**env, **{n: g.eval(env) for n, g in self.by.items()}})


class Integral(Formula):
    """The integral of f over the domain, less a number."""

    def __init__(self, own, f, value):
        self.x = own.integral(f) - sympy.Rational(str(value))

    def eval(self, env):
        return Fraction(str(self.x))


class Fixed(dict):
    """A value of a domain variable; on a simplex the others are scaled to what it leaves."""

    def __init__(self, own, name, x):
        super().__init__({name: x})
        self.others = [n for names in own.simplices if name in names for n in names if n != name]
        self.left = 1 - x

    def of(self, env):
        env = {**env, **self}
        total = sum(env[n] for n in self.others)
        for n in self.others:
            env[n] = self.left * env[n] / total if total else self.left / len(self.others)
        return env


def partial_claim(r, own, f):
    """D(f, x) ≥ c or = g, for a variable of an interval or a coordinate of a simplex but the last."""
    x = r.choice([n for n in own.domain if not any(n == names[-1] for names in own.simplices)])
    last = [names[-1] for names in own.simplices if x in names]
    # Along the edge from the last corner its coordinate falls as the other one grows.
    d = Derivative(f, x, x)
    if last:
        d = Derivative(Moved(f, {last[0]: Falling(x, last[0])}), x)
        d.text = lambda: f'D({f.text()}, {x})'
    relation, g = r.choice(['>=', '=', '>']), formula(number(r))
    if relation == '=' and r.random() < 0.5:
        return Claim(f'D({f.text()} + {x}, {x}) = {d.text()} + 1', [('=', formula(0), {})], True)
    return Claim(f'{d.text()} {relation} {g.text()}', [(relation, d - g, {})])


class Falling(Formula):
    """A coordinate w, which is 1 minus the others, as one of them, u, moves: w + u − (u with its derivative)."""

    def __init__(self, x, last):
        self.x, self.last = x, last

    def eval(self, env):
        x = env[self.x]
        base = x
        while hasattr(base, 'a'):
            base = base.a
        return env[self.last] + (base - x)


class Smooth(Claim):
    """The derivatives up to an order agree at the inner knots."""

    def __init__(self, own, order):
        super().__init__(f'smooth({order})', [])
        self.own, self.order = own, order
        t = sympy.Symbol('t')
        symbols = {n: sympy.Symbol(n) for n in own.shapes}
        agree = []
        for formulas in own.functions.values():
            pieces = [sympy.expand(p.eval({'t': t, **symbols})) for p in formulas]
            for knot, a, b in zip(own.knots[1:-1], pieces, pieces[1:]):
                x = sympy.Rational(str(knot))
                for k in range(order + 1):
                    agree.append(sympy.expand(sympy.diff(a - b, t, k).subs(t, x)) == 0)
        self.truth = all(agree)


class SmoothArcs(Smooth):
    """The same with sines and exponentials: to 50 digits, at some values of the parameter."""

    def __init__(self, own, order):
        Claim.__init__(self, f'smooth({order})', [])
        agree = []
        for share in ('0.317', '0.739') if 'a' in own.shapes else ('1',):
            env = {}
            if 'a' in own.shapes:
                s = own.shapes['a']
                env['a'] = s.low + (s.high - s.low) * mpmath.mpf(share)
            for formulas in own.functions.values():
                for knot, before, after in zip(own.knots[1:-1], formulas, formulas[1:]):
                    at = {**env, 't': to_float(knot) * own.unit(env), 'float': to_float}
                    for _ in range(order + 1):
                        agree.append(is_zero((before - after).eval(at)))
                        before, after = Derivative(before, 't'), Derivative(after, 't')
        self.truth = all(agree)


class TotallyPositive(Claim):
    """No minor of values at points in order is negative."""

    def __init__(self, own):
        super().__init__('totally_positive', [])
        self.own = own

    def negative(self, r, tries):
        """Points and functions with a negative minor, as far as they are met with."""
        own, members = self.own, self.own.members()
        for _ in range(tries):
            size = r.randint(1, len(members))
            chosen = sorted(r.sample(range(len(members)), size))
            points = sorted({Fraction(r.choice([0, 1, r.randint(0, 60), r.randint(0, 60), 60, 59]), 60) for _ in range(size)})
            if len(points) < size:
                continue
            rows = [[members[j].eval({'t': x}) for j in chosen] for x in points]
            if sympy.Matrix([[sympy.Rational(x.numerator, x.denominator) for x in map(Fraction, row)] for row in rows]).det() < 0:
                return points, chosen
        return None


class Independent(Claim):
    """The functions are independent: by ranks of tables of values."""

    def __init__(self, own):
        super().__init__('independent', [])
        self.own = own
        if own.kind in ('poly', 'raise') and len(own.shapes) <= 1:
            self.truth = self.exact()

    def exact(self):
        """By the common roots of the maximal minors of the table of coefficients."""
        t, k = sympy.Symbol('t'), sympy.Symbol('k')
        own = self.own
        polys = [sympy.Poly(m.eval({'t': t, 'k': k}), t) for m in own.members()]
        width = max(p.degree() for p in polys if not p.is_zero) + 1 if any(not p.is_zero for p in polys) else 0
        if width < len(polys):
            return False
        rows = sympy.Matrix([[p.coeff_monomial(t**e) for e in range(width)] for p in polys])
        common = sympy.Integer(0)
        for columns in combinations(range(width), len(polys)):
            common = sympy.gcd(common, sympy.expand(rows[:, list(columns)].det()))
        if common == 0:
            return False
        if 'k' not in own.shapes or not sympy.sympify(common).has(k):
            return True
        s = own.shapes['k']
        q = sympy.Poly(common, k)
        low = None if s.low is None else sympy.Rational(str(s.low))
        high = None if s.high is None else sympy.Rational(str(s.high))
        count = q.count_roots(low, high)
        count -= int(low is not None and not s.low_in and q.eval(low) == 0)
        count -= int(high is not None and not s.high_in and q.eval(high) == 0)
        return count == 0

    def full(self, shapes, r):
        """Whether the values at many points have full rank; of floats, whether they clearly have or lack it."""
        own, rows = self.own, []
        members = own.members()
        for _ in range(12 + 4 * len(members)):
            env = {**own.sample(r), **shapes}
            env = floats(own, env)
            rows.append([m.eval(env) for m in members])
        if any(isinstance(x, mpmath.mpf) for row in rows for x in row):
            matrix = mpmath.matrix([[to_float(x) for x in row] for row in rows])
            least = min(mpmath.svd_r(matrix, compute_uv=False))
            return least > mpmath.mpf(10) ** -25
        return rank(rows) == len(members)


def floats(own, env):
    """Floats in place of rational numbers where sines and exponentials are taken, or a coordinate is irrational."""
    if own.floats or any(isinstance(x, mpmath.mpf) for x in env.values()):
        env = {n: x if n == 'span' else to_float(x) for n, x in env.items()}
        env['float'] = to_float
    return env


def replace_ends(own):
    for s in [*own.domain.values(), *own.shapes.values()]:
        for end in ('low', 'high'):
            x = getattr(s, end)
            if isinstance(x, str):
                setattr(s, end, ENDS[x]())


# The tangent of an angle on its way from that at one end of a range to that at the other one.
BETWEEN = (r'\(tan\((\w+)(?:/(\d+))?\) - tan\((\d+)(?:/(\d+))?\)\)'
           r'/\(tan\((\d+)(?:/(\d+))?\) - tan\(\d+(?:/\d+)?\)\)')


def witness_point(own, at):
    """The point of a counterexample: fractions, or floats for irrational coordinates; `None` if it is not understood."""
    env = {}
    for name, text in at.items():
        if re.fullmatch(r'-?\d+(/\d+)?', text):
            value = Fraction(text)
        elif match := re.fullmatch(r'root of (.*) between (\S+) and (\S+)', text):
            bare = match[1].replace(name, 'zz')
            letters = sorted(set(re.findall(r'[A-Za-z]\w*', bare)))
            if len(letters) != 1:
                return None
            x = sympy.Symbol(letters[0])
            p = sympy.Poly(sympy.sympify(bare.replace('^', '**'), rational=True), x)
            low, high = sympy.Rational(match[2]), sympy.Rational(match[3])
            found = [z for z in p.nroots(n=70, maxsteps=500) if abs(sympy.im(z)) < 1e-40]
            wide = sympy.Rational(1, 10**5)
            found = [z for z in found if low - wide <= sympy.re(z) <= high + wide]
            if len(found) != 1:
                return None
            value = mpmath.mpf(str(sympy.re(found[0])))
        else:
            return None
        if match := re.fullmatch(r'(tan|tanh)\((\w+)(?:/(\d+))?\)(?:/\1\((\d+)(?:/(\d+))?\))?', name):
            value, function = to_float(value), mpmath.tan if match[1] == 'tan' else mpmath.tanh
            if match[4]:
                value *= function(mpmath.mpf(int(match[4])) / int(match[5] or 1))
            value = (mpmath.atan if match[1] == 'tan' else mpmath.atanh)(value) * int(match[3] or 1)
            name = match[2]
        elif match := re.fullmatch(BETWEEN, name):
            low, high = (mpmath.tan(mpmath.mpf(int(match[k])) / int(match[k + 1] or 1)) for k in (3, 5))
            value = mpmath.atan(low + to_float(value) * (high - low)) * int(match[2] or 1)
            name = match[1]
        elif match := re.fullmatch(r'tan\(\(?(\w+) - pi(?:/(\d+))?\)?(?:/(\d+))?\)', name):
            value = mpmath.pi / int(match[2] or 1) + mpmath.atan(to_float(value)) * int(match[3] or 1)
            name = match[1]
        elif own.kind == 'turns' and not re.fullmatch(r'\w+', name):
            name, value = 't', along(own.domain['t'], name, to_float(value))
        if value is None or not re.fullmatch(r'\w+', name):
            return None
        env[name] = value
    return env


def along(s, written, value):
    """Where in a range a formula in t, which grows, has a value; `None` where it is not understood."""
    t = sympy.Symbol('t')
    f = sympy.lambdify(t, sympy.sympify(written), 'mpmath')
    low, high = to_float(s.low), to_float(s.high)
    if not f(low) - TINY < value < f(high) + TINY:
        return None
    for _ in range(220):
        middle = (low + high) / 2
        low, high = (low, middle) if f(middle) > value else (middle, high)
    return (low + high) / 2


def judge_claim(own, claim, answer, r):
    """`None`, or what is wrong with a verdict."""
    verdict = answer['verdict']
    if verdict == 'undecided':
        return None
    if claim.truth is not None and claim.truth != (verdict == 'proved'):
        return f'it is {claim.truth}, and said to be {verdict}'
    if isinstance(claim, Smooth) or own.kind == 'related' and not claim.parts:
        return None
    if isinstance(claim, TotallyPositive):
        found = claim.negative(r, 60 if verdict == 'proved' else 2000)
        if verdict == 'proved':
            return found and f'a minor is negative: {found}'
        return None if found else NOT_READ
    if verdict == 'proved':
        if isinstance(claim, Independent):
            for _ in range(6):
                shapes = {n: s.sample(r) for n, s in own.shapes.items()}
                if not claim.full(shapes, r):
                    return f'the functions are dependent at {shapes}'
            return None
        for relation, f, fixed in claim.parts:
            for _ in range(6 if relation == '=' else 40):
                env = own.sample(r)
                env = floats(own, fixed.of(env) if isinstance(fixed, Fixed) else {**env, **fixed})
                if own.kind == 'related' and not own.contains(env):
                    continue
                try:
                    x = f.eval(env)
                except ZeroDivisionError:
                    continue  # in lower terms there is a value; `vanishing` looks for other zeros
                if not holds(relation, x):
                    return f'the value is {x} at {env}'
        return None
    witness = answer.get('witness')
    if not witness:
        return 'it is refuted without a witness'
    env = witness_point(own, witness['at'])
    if env is None:
        return NOT_READ
    for name in list(own.shapes) + list(own.domain):
        if name not in env and own.kind == 'related':
            return NOT_READ
        if name not in env:
            env[name] = (own.shapes.get(name) or own.domain[name]).sample(r)
    if isinstance(claim, Independent):
        shapes = {n: env[n] for n in own.shapes}
        if not all(s.contains(shapes[n]) for n, s in own.shapes.items()):
            return f'the point {shapes} lies outside'
        if any(isinstance(x, mpmath.mpf) for x in shapes.values()):
            return None
        return 'the functions are independent there' if claim.full(shapes, r) else None
    exact = not any(isinstance(x, mpmath.mpf) for x in env.values())
    if exact and not own.contains(env):
        return f'the point {env} lies outside'
    values = []
    for relation, f, fixed in claim.parts:
        if any(n in env and not is_zero(to_float(env[n]) - to_float(x)) for n, x in fixed.items()):
            return f'the point {env} does not have the fixed values'
        for span in own.spans_at(env) if own.kind in ('spans', 'arcs') else [None]:
            try:
                values.append((relation, f.eval(floats(own, {**env, 'span': span}))))
            except ZeroDivisionError:
                return NOT_READ  # in lower terms there is a value
    said = witness.get('value')
    for relation, x in values:
        if isinstance(x, mpmath.mpf):
            if relation == '=' and abs(x) > TINY or relation == '>=' and x < -TINY or relation == '>' and x < TINY:
                return None
        elif not holds(relation, x):
            if said is None or not re.fullmatch(r'-?\d+(/\d+)?', said) or abs(Fraction(said)) == abs(x):
                return None
    return f'nothing fails at {env}: {[str(x) for _, x in values]}, said is {said}'


NOT_READ = 'the witness is not understood here'


# Theorems and joins.


class Theorem:
    """Claims about curves over Bernstein families, whose truth is known."""

    kind = 'theorem'

    def __init__(self, r, name):
        self.name, self.claims = name, []
        n, m = r.randint(2, 4), r.randint(2, 4)
        lines = [f'curve P = Bern({n});', f'curve Q = Bern({m});']
        bern = lambda n, i, x: Fraction(binomial(n, i)) * x**i * (1 - x) ** (n - i)
        slope = lambda n, i, x: n * ((bern(n - 1, i - 1, x) if i else 0) - (bern(n - 1, i, x) if i < n else 0))
        self.join = r.random() < 0.4
        if self.join:
            contact, off = Fraction(n, m), r.choice([0, 0, Fraction(1, 7), -2 * Fraction(n, m)])
            lines += ['scalar 0 < d;', f'let Q[0] = P[{n}];']
            lines += [f'let Q[1] = Q[0] + ({contact + off})/d*(P[{n}] - P[{n - 1}]);']
            self.put('P(1) == Q(0)', True)
            self.put('D(P)(1) == d*D(Q)(0)', off == 0)
            self.put('D(P)(1) parallel D(Q)(0)', contact + off > 0)
        else:
            lines += ['scalar -1 <= c <= 2;', 'scalar 0 <= e;']
            for _ in range(3):
                x = Fraction(r.randint(-2, 5), r.choice([1, 2, 3]))
                off = r.choice([0, 0, Fraction(1, 10**6)])
                what, weight = r.choice([('P', bern), ('D(P)', slope)])
                ws = [weight(n, i, x) for i in range(n + 1)]
                ws[r.randint(0, n)] += off
                total = ' + '.join(f'({w})*P[{i}]' for i, w in enumerate(ws))
                self.put(f'{what}({x}) == {total}', off == 0)
            # f·P parallel g·P exactly if f and g have the same sign everywhere.
            for _ in range(2):
                f, g = polynomial(r, ['c'], 2, 2), polynomial(r, ['c'], 2, 2)
                if r.random() < 0.4:
                    g = f * (Name('c') ** 2 + r.choice([0, 1, Fraction(1, 100)]))
                self.put(f'{f.text()}*P[0] parallel {g.text()}*P[0]', same_signs(f, g))
            a = [[r.randint(-2, 2) for _ in range(3)] for _ in range(2)]
            matrix = sympy.Matrix(3, 3, lambda i, j: sum(row[i] * row[j] for row in a))
            matrix[r.randint(0, 2), 0] += r.choice([0, 0, -1, 1])
            matrix = (matrix + matrix.T) / 2
            total = ' + '.join(f'({matrix[i, j]})*dot(P[{i}], Q[{j}])'.replace('Q', 'P')
                               for i in range(3) for j in range(3))
            self.put(f'{total} >= 0', bool(matrix.is_positive_semidefinite))
            self.put(f'{total} + 1 > 0', bool(matrix.is_positive_semidefinite))
        self.lines = lines

    def put(self, text, truth):
        self.claims.append(Claim(text, [], truth))

    def text(self):
        word = 'join' if self.join else 'theorem'
        own = ''.join(f'    {line}\n' for line in self.lines)
        bernstein = ('family Bern(n in 1..=4) {\n    domain 0 <= t <= 1;\n'
                     '    b[i] = binomial(n, i)*t^i*(1 - t)^(n - i) for i in 0..=n;\n}\n')
        return f'{bernstein}{word} {self.name} {{\n{own}'


def binomial(n, k):
    result = 1
    for i in range(k):
        result = result * (n - i) // (i + 1)
    return result


def same_signs(f, g):
    """Whether two polynomials in c have the same sign everywhere on −1 ≤ c ≤ 2."""
    c = sympy.Symbol('c')
    p, q = (sympy.Poly(h.eval({'c': c}), c) for h in (f, g))
    sign = lambda h, x: sympy.sign(sympy.simplify(h.as_expr().subs(c, x)))
    roots = sorted({x for h in (p, q) if h.degree() > 0 for x in sympy.real_roots(h) if -1 <= x <= 2})
    points = sorted({sympy.Integer(-1), sympy.Integer(2), *roots}, key=lambda x: sympy.N(x, 40))
    between = [(sympy.Rational(str(sympy.N(a, 30))) + sympy.Rational(str(sympy.N(b, 30)))) / 2
               for a, b in zip(points, points[1:])]
    return all(sign(p, x) == sign(q, x) for x in points + between)


def judge_theorem(theorem, claim, answer):
    verdict = answer['verdict']
    if verdict != 'undecided' and claim.truth != (verdict == 'proved'):
        return f'it is {claim.truth}, and said to be {verdict}'
    return None


def subject(r, name, kind=None):
    own = Theorem(r, name) if not kind and r.random() < 0.12 else family(r, name, kind)
    if not isinstance(own, Theorem):
        text = own.text()
        replace_ends(own)
        try:
            own.claims = claims(r, own)
        except ZeroDivisionError:
            own.claims = []
    else:
        text = own.text()
    body = ''.join(f'    prove {c.text}{"" if c.text.endswith("}") else ";"}\n' for c in own.claims)
    own.spec = f'{text}{body}}}\n'
    return own


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('basis')
    parser.add_argument('--claims', type=int, default=1000)
    parser.add_argument('--seed', type=int, default=int(time.time()))
    parser.add_argument('--kind', help='families of one kind only, such as product')
    parser.add_argument('--keep', help='a folder for the specs')
    parser.add_argument('--lie', action='store_true', help='turn every refuted into proved: this has to be noticed')
    options = parser.parse_args()
    print(f'seed {options.seed}', flush=True)
    r = random.Random(options.seed)
    scratch = tempfile.TemporaryDirectory()
    folder = Path(options.keep or scratch.name)
    folder.mkdir(parents=True, exist_ok=True)
    counts, wrong, done = Counter(), 0, 0
    while done < options.claims:
        batch = [subject(r, f'F{k}', options.kind) for k in range(min(40, 1 + (options.claims - done) // 4))]
        paths = []
        for k, own in enumerate(batch):
            path = folder / f'{done}-{k}.basis'
            path.write_text(own.spec, encoding='utf-8')
            paths.append(path)
        said = subprocess.run([options.basis, 'check', '--format', 'json', *paths], capture_output=True, check=False)
        if said.returncode not in (0, 1):
            print(f'basis check ends with {said.returncode}: {said.stderr.decode()[-2000:]}')
            return 1
        files = {f['path']: f for f in json.loads(said.stdout)['files']}
        for path, own in zip(paths, batch):
            file = files[str(path)]
            item = next((i for i in file['items'] if i['name'] == own.name), None)
            if item is None:
                counts['families refused'] += 1
                messages = [d['message'].split('\n')[0] for d in file['diagnostics'] if d['severity'] == 'error']
                problem = refusal(own, messages, r)
                if problem:
                    wrong += 1
                    print(f'WRONG: {problem}\n{own.spec}')
                continue
            answers = item['claims']
            if own.kind == 'rational':
                problem = vanishing(own, r)
                if problem:
                    wrong += 1
                    print(f'WRONG: {problem}\n{own.spec}')
            claims = own.claims
            if len(answers) != len(claims):
                errors = [d['message'] for d in file['diagnostics'] if d['severity'] == 'error']
                messages = [m for m in errors if 'the claim `' not in m]
                # Single claims may be refused; the others are answered.
                if refusal(own, messages, r):
                    wrong += 1
                    print(f'WRONG: {len(answers)} claims instead of {len(claims)}: {messages}\n{own.spec}')
                    continue
                lines = [n for n, line in enumerate(own.spec.split('\n'), 1) if line.lstrip().startswith('prove ')]
                by_line = dict(zip(lines, claims))
                counts['claims refused'] += len(claims) - len(answers)
                claims = [by_line[answer['line']] for answer in answers]
            for claim, answer in zip(claims, answers):
                done += 1
                if options.lie:
                    if answer['verdict'] != 'refuted':
                        continue
                    answer['verdict'] = 'proved'
                counts[f'{own.kind}: {answer["verdict"]}'] += 1
                counts[answer['verdict']] += 1
                counts['truth known'] += claim.truth is not None
                if own.kind == 'theorem':
                    problem = judge_theorem(own, claim, answer)
                else:
                    problem = judge_claim(own, claim, answer, r)
                if problem == NOT_READ:
                    counts['witnesses not read'] += 1
                elif problem:
                    wrong += 1
                    if options.lie:
                        continue
                    print(f'WRONG: `{claim.text}`: {problem}\n  {json.dumps(answer, ensure_ascii=False)}\n{own.spec}')
    for what, n in sorted(counts.items()):
        print(f'{n:8} {what}')
    if options.lie:
        print(f'of {counts["proved"]} false verdicts {wrong} are noticed')
        return 0 if wrong > 0.8 * counts['proved'] else 1
    print(f'{done} claims, {wrong} wrong, seed {options.seed}')
    return 1 if wrong else 0


def vanishing(own, r):
    """The denominators of an accepted family, in lowest terms, have one sign wherever they are looked at."""
    values = [own.denominator.eval(own.sample(r)) for _ in range(60)]
    if all(v > 0 for v in values) or all(v < 0 for v in values):
        return None
    symbols = {n: sympy.Symbol(n) for n in [*own.domain, *own.shapes]}
    for f in own.functions.values():
        below = sympy.fraction(sympy.cancel(f.eval(symbols)))[1]
        values = []
        for _ in range(60):
            at = {symbols[n]: sympy.Rational(str(x)) for n, x in own.sample(r).items()}
            values.append(sympy.sympify(below).subs(at))
        if not (all(v > 0 for v in values) or all(v < 0 for v in values)):
            return 'a denominator that changes its sign is accepted'
    return None


def refusal(own, messages, r):
    """Only a denominator that vanishes, or may, is a reason to refuse a family."""
    if own.kind == 'arcs' and all(re.search('too much work|the highest degree', m) for m in messages):
        return None
    if own.kind == 'turns' and all(re.search('irrational|too much work|the highest degree', m) for m in messages):
        return None  # too many numbers of different kinds
    if own.kind == 'rational' and all(m == 'division by zero' for m in messages):
        values = [own.denominator.eval(own.sample(r)) for _ in range(9)]
        return f'the family is refused: {messages}' if any(values) else None
    if own.kind != 'rational' or not all('denominator' in m for m in messages) or not messages:
        return f'the family is refused: {messages}'
    named = re.search(r'vanishes at ([^:]*)', messages[0])
    if named and (pairs := re.findall(r'(\w+) = (-?\d+(?:/\d+)?)(?=,|$| )', named[1])):
        env = {n: Fraction(x) for n, x in pairs}
        if set(env) >= set(own.domain) | set(own.shapes) and own.denominator.eval(env) != 0:
            return f'the denominator does not vanish there: {messages[0]}'
    return None


if __name__ == '__main__':
    sys.exit(main())

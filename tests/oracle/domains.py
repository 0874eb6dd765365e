"""Numbers, ranges and polynomials at random, and families by the kinds of their domains, with what they are worth at a point."""

from fractions import Fraction

import mpmath

from formula import Member, Name, formula, to_float
from polynomials import Poly

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


def binomial(n, k):
    result = 1
    for i in range(k):
        result = result * (n - i) // (i + 1)
    return result


class Family:
    """A family with its domain: `domain` has a range for each variable, `simplices` those that are barycentric."""

    def __init__(self, r, name):
        self.r, self.name = r, name
        self.shapes, self.domain, self.lines, self.functions = {}, {}, [], {}
        self.recursive = self.floats = False
        self.simplices = []
        self.spans = None
        self.denominator = None
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

    def sample(self, r, shapes=None):
        """A point of the domain with shape values, those that are given or random ones."""
        env = dict(shapes or {n: s.sample(r) for n, s in self.shapes.items()})
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
        x = Poly.of(f.eval(self.polynomials()))
        for n, s in self.domain.items():
            if not any(n in names for names in self.simplices):
                x = x.integral(n, s.low, s.high)
        for names in self.simplices:
            rest = 1 - sum(Poly.variables(names[:-1]).values())
            for n in names[-2::-1]:
                rest = rest + Poly.variables([n])[n]
                x = x.integral(n, 0, rest)
        return x

    def polynomials(self):
        """All variables as polynomials, of each simplex the last one expressed by the others."""
        at = Poly.variables([*self.domain, *self.shapes])
        for names in self.simplices:
            at[names[-1]] = 1 - sum(at[n] for n in names[:-1])
        return at


class Spans(Family):
    """A family on neighbouring spans: `functions` has a list of formulas for each index."""

    def spans_at(self, env):
        return [k for k, (low, high) in enumerate(zip(self.knots, self.knots[1:])) if low <= env['t'] <= high]

    def integral(self, f):
        at = Poly.variables([*self.shapes, 't'])
        ends = [k.eval(at) if hasattr(k, 'eval') else k for k in self.knots]
        total = Poly({})
        for span, (low, high) in enumerate(zip(ends, ends[1:])):
            total = total + Poly.of(f.eval({**at, 'span': span})).integral('t', low, high)
        return total

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


def floats(own, env):
    """Floats in place of rational numbers where sines and exponentials are taken, or a coordinate is irrational."""
    if own.floats or any(isinstance(x, mpmath.mpf) for x in env.values()):
        env = {n: x if n == 'span' else to_float(x) for n, x in env.items()}
        env['float'] = to_float
    return env

"""Random claims about families, with the truth where it is known: by construction, or because sympy counts roots or
determines ranks."""

import re
from fractions import Fraction
from itertools import combinations

import mpmath
import sympy

from algebra import rank
from angles import Constant, replace_ends
from domains import TINY, floats, is_zero, number, square_sum
from formula import Derivative, Formula, Member, Name, Number, formula, to_float
from polynomials import Poly


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
        return Poly.of(f.eval(own.polynomials())).is_zero()
    if own.kind not in ('poly', 'raise') or own.shapes and relation != '=':
        return None
    p = Poly.of(f.eval(own.polynomials()))
    if relation == '=':
        return p.is_zero()
    s = own.domain['t']
    if p.is_zero():
        return relation != '>'
    if p.number() is not None:
        return p.number() > 0
    t = sympy.Symbol('t')
    q = sympy.Poly([rational(c.number()) for c in p.coefficients('t')[::-1]], t)
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


def rational(x):
    x = Fraction(x)
    return sympy.Rational(x.numerator, x.denominator)


def claims(r, own):
    """Random claims about a family."""
    members = own.members()
    names = list(own.domain) + list(own.shapes)
    result = [TotallyPositive(own)] if own.kind == 'positive' else []
    if own.kind == 'segments':
        result += [Continuity(own, r) for _ in range(4)]
    if own.kind == 'turns':
        replace_ends(own)
        result += [claim for _ in range(4) if (claim := place_claim(r, own))]
    for _ in range(r.randint(4, 7)):
        kind = r.choice(['order', 'order', 'order', 'square', 'equal', 'unity', 'nonnegative', 'independent', 'at',
                         'slope', 'symmetric', 'smooth'] + ['face', 'partial', 'integral', 'swap'] * bool(own.simplices) + ['integral', 'parameters'] * (own.kind == 'related') + ['integral'] * (own.kind in ('poly', 'box', 'spans', 'knots', 'indexed'))
                        + ['at'] * (own.kind == 'indexed'))
        f = r.choice(members)
        if kind == 'integral' and own.denominator is not None:
            continue
        if kind == 'order':
            g = r.choice([formula(number(r)), r.choice(members), formula(0)])
            result.append(relation_claim(r, own, f, r.choice(['>=', '>', '>=']), g))
        elif kind == 'square' and not own.floats and own.kind not in ('spans', 'knots'):
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
        elif kind == 'independent' and not own.simplices and own.kind not in ('box', 'knots', 'indexed', 'segments'):
            result.append(Independent(own))
        elif kind == 'slope' and len(own.domain) == 1:
            d = Derivative(f, 't')
            if r.random() < 0.3:
                d = Derivative(d, 't')
            if own.kind == 'arcs' or r.random() < 0.5 and own.kind not in ('spans', 'knots'):
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
        elif kind == 'at' and own.shapes and not own.floats and own.kind != 'knots':
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
            bound = formula(number(r))
            if r.random() < 0.6:
                # Next to a value near the least or the greatest one.
                found = sorted(g.eval(own.sample(r)) for _ in range(30))
                bound = formula(r.choice([found[0], found[-1], found[15]]) + r.choice([-1, 1]) * Fraction(1, r.choice([20, 1000])))
            g, bound = (g, bound) if r.random() < 0.5 else (formula(0) - g, formula(0) - bound)
            result.append(relation_claim(r, own, g, r.choice(['>=', '>', '=']), bound))
        elif kind == 'integral' and own.kind in ('related', 'spans', 'knots', 'poly', 'box', 'indexed'):
            extra = r.choice([0, 0, Fraction(1, 1000)])
            text = (own.integral(f) + extra).text()
            result.append(Integrated(f'integral({f.text()}) = {text}', [], not extra))
        elif kind == 'integral':
            value = own.integral(f).number()
            if value is not None:
                extra = r.choice([0, 0, Fraction(1, 1000)])
                text = f'integral({f.text()}) = {Number(value + extra).text()}'
                result.append(Claim(text, [('=', Number(-extra), {})], not extra))
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
        elif kind == 'smooth' and own.kind in ('spans', 'knots') and len(own.knots) > 2:
            result.append(Smooth(own, r.randint(0, 2)))
    seen = set()
    return [c for c in result if not (c.text in seen or seen.add(c.text))]


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
        at = Poly.variables([*own.shapes, 't'])
        agree = []
        for formulas in own.functions.values():
            pieces = [Poly.of(p.eval(at)) for p in formulas]
            for knot, a, b in zip(own.knots[1:-1], pieces, pieces[1:]):
                x, difference = knot.eval(at) if hasattr(knot, 'eval') else knot, a - b
                for _ in range(order + 1):
                    agree.append(difference.put('t', x).is_zero())
                    difference = difference.derivative('t')
        self.truth = all(agree)


class Integrated(Claim):
    """The value of an integral, of which sympy says whether it is right."""


class Continuity(Claim):
    """`continuity(r) with k = m`: the functions at the lower end, where parameters that are named have the values of this segment
    and others any, are the functions before them at the upper end."""

    def __init__(self, own, r):
        order = r.randint(0, 2)
        given = r.choice([{}, {'k': 'm'}, {'m': 'k'}, {'k': 'm', 'm': 'k'}, {'k': 'k', 'm': 'm'}])
        name = ', '.join(f'{a} = {b}' for a, b in given.items())
        super().__init__(f'continuity({order})' + (f' with {name}' if given else ''), [])
        here = Poly.variables([*own.shapes, 't'])
        free = Poly.variables([f'next_{n}' for n in own.shapes])
        there = {'t': here['t'], **{n: here[given[n]] if n in given else free[f'next_{n}'] for n in own.shapes}}

        def ends(at, x):
            rows = []
            for f in own.functions.values():
                derivatives = [Poly.of(f.eval(at))]
                for _ in range(order):
                    derivatives.append(derivatives[-1].derivative('t'))
                rows.append([d.put('t', x) for d in derivatives])
            return rows

        none = [[Poly({})] * (order + 1)]
        before, after = none + ends(there, 0), ends(here, 1) + none
        self.truth = all((a - b).is_zero() for x, y in zip(before, after) for a, b in zip(x, y))


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
        members = self.own.members()
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


def has_floats(rows):
    return any(isinstance(x, mpmath.mpf) for row in rows for x in row)


class Independent(Claim):
    """The functions are independent: by ranks of tables of values."""

    def __init__(self, own):
        super().__init__('independent', [])
        self.own = own
        if own.kind in ('poly', 'raise') and len(own.shapes) <= 1:
            self.truth = self.exact()

    def exact(self):
        """By the common roots of the maximal minors of the table of coefficients."""
        k, own = sympy.Symbol('k'), self.own
        polys = [Poly.of(m.eval(own.polynomials())).coefficients('t') for m in own.members()]
        width = max(map(len, polys))
        polys = [p + [Poly({})] * (width - len(p)) for p in polys]
        numbers = [[c.number() for c in p] for p in polys]
        if all(c is not None for row in numbers for c in row):
            return rank(numbers) == len(polys)
        if width < len(polys):
            return False
        rows = sympy.Matrix([[sum(rational(c.number()) * k**e for e, c in enumerate(p.coefficients('k')))
                              for p in row] for row in polys])
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
        for count in range(12 + 4 * len(members)):
            env = floats(own, own.sample(r, shapes))
            try:
                rows.append([m.eval(env) for m in members])
            except ZeroDivisionError:
                continue  # in lower terms there is a value
            # A few points are enough where the rank is full.
            if count == len(members) + 1 and not has_floats(rows) and rank(rows) == len(members):
                return True
        if len(rows) < len(members):
            return True  # the formulas have no values at most points
        if has_floats(rows):
            matrix = mpmath.matrix([[to_float(x) for x in row] for row in rows])
            least = min(mpmath.svd_r(matrix, compute_uv=False))
            return least > mpmath.mpf(10) ** -25
        return rank(rows) == len(members)

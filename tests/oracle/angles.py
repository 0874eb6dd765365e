"""Random families in sines and exponentials: on arcs that end at parameters, and at parts of a turn."""

from fractions import Fraction

import mpmath

from domains import Range, Spans, TINY, number
from formula import Call, Formula, Name, formula, to_float

ENDS = {'pi': lambda: mpmath.pi * 1, '-pi/2': lambda: -mpmath.pi / 2, '0': lambda: mpmath.mpf(0),
        '2*pi/3': lambda: mpmath.pi * 2 / 3, '2*pi/5': lambda: mpmath.pi * 2 / 5,
        **{f'pi/{n}': lambda n=n: mpmath.pi / n for n in (2, 3, 4, 6, 12)}}


def replace_ends(own):
    for s in [*own.domain.values(), *own.shapes.values()]:
        for end in ('low', 'high'):
            x = getattr(s, end)
            if isinstance(x, str):
                setattr(s, end, ENDS[x]())


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

    def sample(self, r, shapes=None):
        shapes = shapes or {n: s.sample(r) for n, s in self.shapes.items()}
        env = {n: to_float(x) for n, x in shapes.items()}
        # Each span as often as the others, however short it is.
        k = r.randrange(len(self.knots) - 1)
        env['t'] = to_float(Range(self.knots[k], self.knots[k + 1]).sample(r)) * self.unit(env)
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

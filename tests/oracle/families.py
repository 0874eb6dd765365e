"""Random families of every kind."""

from fractions import Fraction

from angles import Arcs, arcs, turns
from domains import TINY, Family, Range, Spans, binomial, holds, number, polynomial
from formula import Call, Member, Name, Number, formula, to_float
from polynomials import Poly


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

    def sample(self, r, shapes=None):
        while True:
            env = dict(shapes or {n: s.sample(r) for n, s in self.shapes.items()})
            if shapes or self.fits(env):
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
        at = self.polynomials()
        s = self.domain.get('t')
        low, high = (at[n] for n in self.between) if self.between else (s.low, s.high)
        return Poly.of(f.eval(at)).integral('t', low, high)


def related(r, own):
    k, m = Name('k'), Name('m')
    low, size = number(r), Fraction(r.randint(1, 4), r.choice([1, 2]))
    kind = r.choice(['chain', 'ends', 'chain', 'linear', 'disk', 'product', 'several', 'several'])
    own.shapes = {n: Range(low, low + size) for n in 'km'}
    if kind in ('chain', 'ends'):
        strict = [r.random() < 0.4 for _ in range(3)]
        strict[1] |= kind == 'ends'
        signs = ['<' if s else '<=' for s in strict]
        own.declared = [f'shape {low} {signs[0]} k {signs[1]} m {signs[2]} {low + size}']
        own.shapes['k'] = Range(low, low + size, not strict[0], not strict[1] and not strict[2])
        own.shapes['m'] = Range(low, low + size, not strict[0] and not strict[1], not strict[2])
        own.conditions = [('>' if strict[1] else '>=', m - k)]
    elif kind == 'several':
        own.declared = [f'shape {own.shapes[n].text(n)}' for n in 'km']
        several(r, own, low, size)
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
        parts = [Name('t') - k, m - Name('t'), m - k, formula(1)]
    else:
        own.domain = {'t': Range(Fraction(0), Fraction(1))}
        parts = [Name('t'), formula(1) - Name('t'), k, m, m - k, formula(1)]
        parts += [x for _, x in own.conditions]
        parts += [Name(n) - (low + size * Fraction(r.randint(1, 15), 16)) for n in 'km'] * (kind == 'several')
    for i in range(2):
        f = r.choice(parts) * r.choice(parts) * r.choice(parts)
        own.functions[(i,)] = f + (polynomial(r, ['t', 'k', 'm'], 1, 1) if r.random() < 0.5 else 0)
    if kind not in ('chain', 'ends') and r.random() < 0.35:
        own.denominator = away_from_zero(r, own, low, size)
        own.functions = {i: f / own.denominator for i, f in own.functions.items()}
    if r.random() < 0.3:
        own.functions[(2,)] = formula(1) - Member(own, (0,)) - Member(own, (1,))


def away_from_zero(r, own, low, size):
    """A polynomial that is positive, or nearly so, where the shape parameters are, and mostly not in all of their ranges."""
    k, m = Name('k'), Name('m')
    f = formula(0)
    for part in r.sample([k, m, k * m, k * k, m * m, *[x for _, x in own.conditions]], r.randint(1, 2)):
        f = f + part * Fraction(r.choice([-2, -1, 1, 1, 2, 3]), r.choice([1, 2]))
    places = [low + size * Fraction(i, 16) for i in range(17)]
    inside = [env for env in ({'k': k, 'm': m} for k in places for m in places) if own.fits(env)]
    least = min((f.eval(env) for env in inside), default=Fraction(0))
    f = f + (Fraction(r.choice([-10, 0, 1, 10, 10, 50]), 100) - least)
    return f + Name('t') * r.choice([0, 0, 1]) if r.random() < 0.3 else f


def several(r, own, low, size):
    """Two or three conditions on single parameters, which mostly end at irrational numbers."""
    while True:
        own.conditions = []
        for _ in range(r.randint(2, 3)):
            x, at = Name(r.choice('kkkm')), low + size * Fraction(r.randint(0, 8), 8)
            a, b, c = (Fraction(r.randint(-4, 4), r.choice([1, 2, 3])) for _ in 'abc')
            f = lambda x: x * x * x * c + x * x * a + x * b
            margin = abs(a) * size * size * Fraction(r.randint(0, 6), 8)
            own.conditions.append((r.choice(['>=', '>=', '>']), f(x) - f(at) + margin))
        places = [low + size * Fraction(i, 16) for i in range(17)]
        inside = sum(own.fits({'k': k, 'm': m}) for k in places for m in places)
        if inside > 20:
            break
    own.declared += [f'assume {x.text()} {relation} 0' for relation, x in own.conditions]


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


class Knots(Spans):
    """A family on spans between knots that are sums and multiples of shape parameters: `knots` are formulas."""

    variable = 't'

    def at(self, env):
        return [knot.eval(env) for knot in self.knots]

    def domain_text(self):
        k = [knot.text() for knot in self.knots]
        return 'domain ' + ', '.join(f'{a} <= t <= {b}' for a, b in zip(k, k[1:])) + ';'

    def text(self):
        shapes = ''.join(f'    shape {s.text(n)};\n' for n, s in self.shapes.items())
        own = ''.join(f'    b[{i[0]}] = {" | ".join(f.text() for f in fs)};\n' for i, fs in self.functions.items())
        return f'family {self.name} {{\n{shapes}    {self.domain_text()}\n{own}'

    def function(self, index, env):
        x, span = env['t'], env.get('span')
        while hasattr(x, 'a'):
            x = x.a
        if span is None:
            span = next((k for k, b in enumerate(self.at(env)[1:]) if x <= b), len(self.functions[index]) - 1)
        return self.functions[index][span].eval(env)

    def sample(self, r, shapes=None):
        env = dict(shapes or {n: s.sample(r) for n, s in self.shapes.items()})
        knots = self.at(env)
        # Each span as often as the others, however short it is.
        k = r.randrange(len(knots) - 1)
        env['t'] = r.choice([knots[0], *(Range(knots[k], knots[k + 1]).sample(r) for _ in range(4))])
        return env

    def spans_at(self, env):
        knots = [to_float(x) for x in self.at(env)]
        t = to_float(env['t'])
        return [k for k, (low, high) in enumerate(zip(knots, knots[1:])) if low - TINY <= t <= high + TINY]

    def contains(self, env):
        return bool(self.spans_at(env)) and all(s.contains(env[n]) for n, s in self.shapes.items())


def moving(r, own):
    """Polynomials, and quotients by the length of the domain, on one to three spans; continuous with some derivatives at the
    knots, or not."""
    high = Fraction(r.randint(1, 4), r.choice([1, 2]))
    own.shapes = {n: Range(Fraction(0), high * r.choice([1, 2]), False, r.random() < 0.7) for n in 'km'}
    k, m = Name('k'), Name('m')
    steps = r.choice([[k, m], [k, k, m], [m, k], [k + m], [k, m, k], [k * 2, m], [k / 2, m]])
    own.knots = [formula(r.choice([0, 0, 0, 1]))]
    for step in steps:
        last = own.knots[-1]
        own.knots.append(step if isinstance(last, Number) and last.x == 0 else last + step)
    t = Name('t') - own.knots[0]
    whole = own.knots[-1] - own.knots[0]
    parts = [t, t * t, k, formula(1), whole - t, t / whole, t * t / (whole * k)]
    for i in range(r.randint(1, 2)):
        pieces = [r.choice(parts) * number(r) + r.choice(parts) * r.choice(parts)]
        for knot in own.knots[1:-1]:
            x, e = Name('t') - knot, r.choice([0, 1, 2, 3])
            pieces.append(pieces[-1] + (x**e * number(r) if e else formula(number(r))))
        own.functions[(i,)] = pieces
    own.domain['t'] = Range(Fraction(0), Fraction(1))  # the names of the domain; ranges are those of `knots`


def segments(r, own):
    """Segments of curves over neighbouring control points, which join if a parameter of one is another one of the next."""
    own.domain['t'] = Range(Fraction(0), Fraction(1))
    own.shapes = {n: Range(Fraction(0), Fraction(2)) for n in 'km'}
    t, k, m = Name('t'), Name('k'), Name('m')
    s = formula(1) - t
    kind = r.randrange(4)
    if kind == 0:
        functions = [k * s, m * t]
    elif kind == 1:
        functions = [s * s / 2, formula(Fraction(1, 2)) + t * s, t * t / 2]
    elif kind == 2:
        functions = [k * s * s, s * t * r.choice([k, m, formula(1)]), m * t * t]
    else:
        bump = s * s * t * t * r.choice([k, m, k - m])
        functions = [s * s / 2 + bump, formula(Fraction(1, 2)) + t * s - bump, t * t / 2]
    if r.random() < 0.3:
        functions[r.randrange(len(functions))] += s * t * r.choice([k, m, formula(1)])
    own.functions = {(i,): f for i, f in enumerate(functions)}


class Indexed(Family):
    """A family with a shape parameter for each index, all of one range or each between numbers that depend on the index."""

    def text(self):
        own = ''.join(f'    b[{i[0]}] = {f.text()};\n' for i, f in self.functions.items())
        return f'family {self.name} {{\n    {self.domain_text()}\n    shape {self.declared};\n{own}'


def indexed(r, own):
    count, low, size = r.randint(1, 3), number(r, 2), r.randint(1, 3)
    names = [f'p[{i}]' for i in range(count)]
    signs = [r.choice(['<=', '<=', '<']) for _ in 'ab']
    if r.random() < 0.4:
        own.declared = f'{low} - i {signs[0]} p[i] {signs[1]} {low + size} + i for i in 0..{count}'
        ranges = [(low - i, low + size + i) for i in range(count)]
    else:
        own.declared = f'{low} {signs[0]} p[i] {signs[1]} {low + size} for i in 0..={count - 1}'
        ranges = [(low, low + size)] * count
    for name, (a, b) in zip(names, ranges):
        own.shapes[name] = Range(a, b, signs[0] == '<=', signs[1] == '<=')
    own.domain['t'] = Range(Fraction(0), Fraction(1))
    t = Name('t')
    for i in range(r.randint(2, 3)):
        p = Name(r.choice(names))
        f = r.choice([t, formula(1) - t, formula(1), t * t]) * r.choice([p, p + 1, formula(1)])
        own.functions[(i,)] = f + (polynomial(r, ['t', *names], 1, 2) if r.random() < 0.6 else formula(0))


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
                              'raise', 'arcs', 'related', 'positive', 'turns', 'knots', 'indexed', 'segments'],
                            [7, 3, 2, 2, 1, 2, 3, 2, 3, 2, 4, 4, 1, 3, 3, 2, 2])[0]
    own = {'spans': Spans, 'raise': Raised, 'arcs': Arcs, 'related': Related, 'knots': Knots,
           'indexed': Indexed}.get(kind, Family)(r, name)
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
    elif kind == 'knots':
        moving(r, own)
    elif kind == 'indexed':
        indexed(r, own)
    elif kind == 'segments':
        segments(r, own)
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

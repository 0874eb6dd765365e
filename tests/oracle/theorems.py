"""Random theorems and joins, whose truth is known."""

from fractions import Fraction

import sympy

from claims import Claim
from domains import binomial, polynomial
from formula import Name


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
            # Points and partial derivatives of a surface.
            lines.append(f'surface S = Bern({n})(u) * Bern({m})(v);')
            for _ in range(2):
                x, y = (Fraction(r.randint(0, 3), r.choice([1, 2, 3])) for _ in 'uv')
                what, by_u, by_v = r.choice([('S', bern, bern), ('D(S, u)', slope, bern), ('D(S, u, v)', slope, slope)])
                off = r.choice([0, 0, Fraction(1, 10**6)])
                ws = [[by_u(n, i, x) * by_v(m, j, y) for j in range(m + 1)] for i in range(n + 1)]
                ws[r.randint(0, n)][r.randint(0, m)] += off
                total = ' + '.join(f'({w})*S[{i},{j}]' for i, row in enumerate(ws) for j, w in enumerate(row))
                self.put(f'{what}({x}, {y}) == {total}', off == 0)
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

"""Formulas that can be written as text of a spec and evaluated without the engine: on fractions, on floats of any
precision, on symbols, and on dual numbers for derivatives."""

from fractions import Fraction

import mpmath


class Dual:
    """a + b·ε with ε² = 0: a value with its derivative; a and b may be dual numbers themselves."""

    def __init__(self, a, b):
        self.a, self.b = a, b

    @staticmethod
    def of(x):
        return x if isinstance(x, Dual) else Dual(x, 0)

    def __add__(self, other):
        other = Dual.of(other)
        return Dual(self.a + other.a, self.b + other.b)

    def __sub__(self, other):
        other = Dual.of(other)
        return Dual(self.a - other.a, self.b - other.b)

    def __mul__(self, other):
        other = Dual.of(other)
        return Dual(self.a * other.a, self.a * other.b + self.b * other.a)

    def __truediv__(self, other):
        other = Dual.of(other)
        return Dual(self.a / other.a, (self.b * other.a - self.a * other.b) / (other.a * other.a))

    def __radd__(self, other):
        return Dual.of(other) + self

    def __rsub__(self, other):
        return Dual.of(other) - self

    def __rmul__(self, other):
        return Dual.of(other) * self

    def __rtruediv__(self, other):
        return Dual.of(other) / self

    def __neg__(self):
        return Dual(-self.a, -self.b)


def to_float(x):
    return mpmath.mpf(x.numerator) / x.denominator if isinstance(x, Fraction) else x


FUNCTIONS = {
    'sin': (mpmath.sin, lambda x: call('cos', x)),
    'cos': (mpmath.cos, lambda x: -call('sin', x)),
    'exp': (mpmath.exp, lambda x: call('exp', x)),
    'sinh': (mpmath.sinh, lambda x: call('cosh', x)),
    'cosh': (mpmath.cosh, lambda x: call('sinh', x)),
}


def call(name, x):
    if isinstance(x, Dual):
        return Dual(call(name, x.a), x.b * FUNCTIONS[name][1](x.a))
    return FUNCTIONS[name][0](x)


class Formula:
    def __add__(self, other):
        return Binary('+', self, formula(other))

    def __sub__(self, other):
        return Binary('-', self, formula(other))

    def __mul__(self, other):
        return Binary('*', self, formula(other))

    def __truediv__(self, other):
        return Binary('/', self, formula(other))

    def __pow__(self, n):
        return Power(self, n)


class Number(Formula):
    def __init__(self, x):
        self.x = Fraction(x)

    def text(self):
        return str(self.x) if self.x >= 0 and self.x.denominator == 1 else f'({self.x})'

    def eval(self, env):
        return env['float'](self.x) if 'float' in env else self.x


class Name(Formula):
    def __init__(self, name):
        self.name = name

    def text(self):
        return self.name

    def eval(self, env):
        return env[self.name]


class Binary(Formula):
    def __init__(self, op, a, b):
        self.op, self.a, self.b = op, a, b

    def text(self):
        return f'({self.a.text()} {self.op} {self.b.text()})'

    def eval(self, env):
        a, b = self.a.eval(env), self.b.eval(env)
        if self.op == '+':
            return a + b
        if self.op == '-':
            return a - b
        return a * b if self.op == '*' else a / b


class Power(Formula):
    def __init__(self, a, n):
        self.a, self.n = a, n

    def text(self):
        return f'{self.a.text() if isinstance(self.a, Name) else "(" + self.a.text() + ")"}^{self.n}'

    def eval(self, env):
        a, result = self.a.eval(env), 1
        for _ in range(self.n):
            result = a * result
        return result


class Call(Formula):
    """sin(c·x) and its like."""

    def __init__(self, name, argument):
        self.name, self.argument = name, argument

    def text(self):
        return f'{self.name}({self.argument.text()})'

    def eval(self, env):
        return call(self.name, self.argument.eval(env))


class Member(Formula):
    """A basis function: evaluated by its family."""

    def __init__(self, family, index):
        self.family, self.index = family, index

    def text(self):
        return f'b[{",".join(map(str, self.index))}]'

    def eval(self, env):
        return self.family.function(self.index, env)


class Derivative(Formula):
    """The derivative in a domain variable."""

    def __init__(self, f, variable, written=None):
        self.f, self.variable, self.written = f, variable, written

    def text(self):
        return f'D({self.f.text()}{", " + self.written if self.written else ""})'

    def eval(self, env):
        x = self.f.eval({**env, self.variable: Dual(env[self.variable], 1)})
        return x.b if isinstance(x, Dual) else 0


def formula(x):
    return x if isinstance(x, Formula) else Number(x)

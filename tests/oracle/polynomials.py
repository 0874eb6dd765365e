"""Quotients of polynomials with operators, in which formulas can be evaluated. They are not brought into lowest terms."""

from fractions import Fraction

from algebra import ONE, add, coefficients, constant, derivative, multiply, number, scale, variable


class Poly:
    """A polynomial above a fraction line and one below."""

    def __init__(self, above, below=ONE):
        self.above, self.below = above, below

    @staticmethod
    def of(x):
        return x if isinstance(x, Poly) else Poly(constant(x))

    @staticmethod
    def variables(names):
        return {n: Poly(variable(n)) for n in names}

    def __add__(self, other):
        other = Poly.of(other)
        if self.below == other.below:
            return Poly(add(self.above, other.above), self.below)
        above = add(multiply(self.above, other.below), multiply(other.above, self.below))
        return Poly(above, multiply(self.below, other.below))

    def __neg__(self):
        return Poly(scale(self.above, -1), self.below)

    def __sub__(self, other):
        return self + -Poly.of(other)

    def __rsub__(self, other):
        return Poly.of(other) - self

    def __mul__(self, other):
        other = Poly.of(other)
        return Poly(multiply(self.above, other.above), multiply(self.below, other.below))

    def __truediv__(self, other):
        other = Poly.of(other)
        if not other.above:
            raise ZeroDivisionError
        x = number(other.above)
        if x is None:
            return self * Poly(other.below, other.above)
        return self * Poly(scale(other.below, 1 / Fraction(x)))

    def __rtruediv__(self, other):
        return Poly.of(other) / self

    __radd__, __rmul__ = __add__, __mul__

    def is_zero(self):
        return not self.above

    def number(self):
        """The number that it is, or `None`."""
        above, below = number(self.above), number(self.below)
        return None if above is None or below is None else Fraction(above) / below

    def put(self, name, x):
        """A quotient in place of a variable."""
        x, parts = Poly.of(x), []
        for p in (self.above, self.below):
            value, factor = Poly({}), Poly(ONE)
            for c in coefficients(p, name):
                value, factor = value + Poly(c) * factor, factor * x
            parts.append(value)
        return parts[0] / parts[1]

    def derivative(self, name):
        below = derivative(self.below, name)
        if not below:
            return Poly(derivative(self.above, name), self.below)
        above = add(multiply(derivative(self.above, name), self.below), multiply(self.above, below), -1)
        return Poly(above, multiply(self.below, self.below))

    def coefficients(self, name):
        """The coefficients of 1, x, x², … where x is not below the fraction line."""
        assert not derivative(self.below, name)
        return [Poly(c, self.below) for c in coefficients(self.above, name)]

    def integral(self, name, low, high):
        """The integral in a variable that is not below the fraction line."""
        low, high = Poly.of(low), Poly.of(high)
        total, a, b = Poly({}), low, high
        for k, c in enumerate(self.coefficients(name)):
            total, a, b = total + c * (b - a) / (k + 1), a * low, b * high
        return total

    def text(self):
        def written(p):
            parts = ['*'.join([f'({c})', *(f'{v}^{e}' for v, e in monomial)]) for monomial, c in sorted(p.items())]
            return ' + '.join(parts) or '0'

        return written(self.above) if self.below == ONE else f'({written(self.above)})/({written(self.below)})'

"""Exact polynomials for the checker in `verify.py`: fractions and dictionaries, nothing else.

A polynomial is a dictionary from monomials to numbers different from zero. A monomial is a tuple of pairs (variable,
exponent) in increasing order of variables, exponents positive; a number is an `int` or a `Fraction`.
"""

from fractions import Fraction

ZERO, ONE = {}, {(): 1}


def plain(x):
    """The number as an `int` where it is whole: arithmetic with these is faster."""
    return x.numerator if isinstance(x, Fraction) and x.denominator == 1 else x


def constant(x):
    return {(): x} if x else {}


def variable(v):
    return {((v, 1),): 1}


def add(p, q, factor=1):
    """p + factor·q."""
    result = dict(p)
    for m, c in q.items():
        total = result.get(m, 0) + factor * c
        if total:
            result[m] = total
        else:
            result.pop(m, None)
    return result


def scale(p, factor):
    return {m: c * factor for m, c in p.items()} if factor else {}


def times(m, n):
    """The product of two monomials."""
    if not m:
        return n
    if not n:
        return m
    exponents = dict(m)
    for v, e in n:
        exponents[v] = exponents.get(v, 0) + e
    return tuple(sorted(exponents.items()))


def multiply(p, q):
    result = {}
    for m, c in p.items():
        for n, d in q.items():
            k = times(m, n)
            result[k] = result.get(k, 0) + c * d
    return {m: c for m, c in result.items() if c}


def power(p, n):
    result = ONE
    for _ in range(n):
        result = multiply(result, p)
    return result


def variables(p):
    return sorted({v for m in p for v, _ in m})


def degree(p, v):
    return max((e for m in p for w, e in m if w == v), default=0)


def number(p):
    """The number that a polynomial is, or `None`."""
    if not p:
        return 0
    return p[()] if len(p) == 1 and () in p else None


def coefficients(p, v):
    """The coefficients of 1, v, v², … as polynomials in the other variables, at least one."""
    result = [{} for _ in range(degree(p, v) + 1)]
    for m, c in p.items():
        e = dict(m).get(v, 0)
        result[e][tuple(pair for pair in m if pair[0] != v)] = c
    return result


def at(p, v, x):
    """p with a number in place of a variable."""
    result = {}
    for m, c in p.items():
        rest = []
        for w, e in m:
            if w == v:
                c = c * x**e
            else:
                rest.append((w, e))
        rest = tuple(rest)
        result[rest] = result.get(rest, 0) + c
    return {m: plain(c) for m, c in result.items() if c}


def substitute(p, v, q):
    """p with a polynomial in place of a variable."""
    result, factor = ZERO, ONE
    for c in coefficients(p, v):
        result = add(result, multiply(c, factor))
        factor = multiply(factor, q)
    return result


def derivative(p, v):
    result = {}
    for m, c in p.items():
        exponents = dict(m)
        e = exponents.get(v, 0)
        if e:
            exponents[v] = e - 1
            result[tuple(sorted(pair for pair in exponents.items() if pair[1]))] = c * e
    return result


def order(m):
    """A key that is the smaller, the greater a monomial is lexicographically."""
    return [(v, -e) for v, e in m] + [(float('inf'), 0)]


def quotient(p, q):
    """p/q if q divides p, else `None`."""
    lead = min(q, key=order)
    result = {}
    while p:
        top = min(p, key=order)
        exponents = dict(top)
        for v, e in lead:
            if exponents.get(v, 0) < e:
                return None
            exponents[v] -= e
        m = tuple(sorted(pair for pair in exponents.items() if pair[1]))
        c = plain(Fraction(p[top]) / q[lead])
        result[m] = c
        p = add(p, multiply({m: c}, q), -1)
    return result


def determinant(rows):
    """The determinant of a square matrix of polynomials (Bareiss)."""
    rows = [list(row) for row in rows]
    last, negative = ONE, False
    for k in range(len(rows)):
        pivots = [i for i in range(k, len(rows)) if rows[i][k]]
        if not pivots:
            return ZERO
        pivot = min(pivots, key=lambda i: len(rows[i][k]))
        if pivot != k:
            rows[k], rows[pivot] = rows[pivot], rows[k]
            negative = not negative
        for i in range(k + 1, len(rows)):
            for j in range(k + 1, len(rows)):
                value = add(multiply(rows[i][j], rows[k][k]), multiply(rows[i][k], rows[k][j]), -1)
                rows[i][j] = quotient(value, last)
        last = rows[k][k]
    return scale(last, -1) if negative else last


def resultant(p, q, v):
    """The determinant of the Sylvester matrix of two polynomials of positive degree in v."""
    a, b = coefficients(p, v)[::-1], coefficients(q, v)[::-1]
    m, n = len(a) - 1, len(b) - 1
    shifted = lambda c, k: [ZERO] * k + c + [ZERO] * (m + n - k - len(c))
    return determinant([shifted(a, k) for k in range(n)] + [shifted(b, k) for k in range(m)])


def rank(rows):
    """The rank of a matrix of numbers."""
    rows = [[Fraction(x) for x in row] for row in rows]
    found = 0
    for column in range(len(rows[0]) if rows else 0):
        pivot = next((i for i in range(found, len(rows)) if rows[i][column]), None)
        if pivot is None:
            continue
        rows[found], rows[pivot] = rows[pivot], rows[found]
        for i in range(found + 1, len(rows)):
            factor = rows[i][column] / rows[found][column]
            if factor:
                rows[i] = [x - factor * y for x, y in zip(rows[i], rows[found])]
        found += 1
    return found


# Polynomials in one variable: lists of numbers, constant first, the last one not zero.


def trimmed(p):
    p = list(p)
    while p and not p[-1]:
        p.pop()
    return p


def value(p, x):
    result = 0
    for c in reversed(p):
        result = result * x + c
    return result


def slope(p):
    return [k * c for k, c in enumerate(p)][1:]


def divide(p, q):
    """Quotient and remainder."""
    p, whole = [Fraction(c) for c in p], [Fraction(0)] * max(len(p) - len(q) + 1, 0)
    while len(p) >= len(q):
        k, c = len(p) - len(q), p[-1] / q[-1]
        whole[k] = c
        p = trimmed([x - c * (q[i - k] if i >= k else 0) for i, x in enumerate(p[:-1])])
    return trimmed(whole), p


def common_divisor(p, q):
    while q:
        p, q = q, divide(p, q)[1]
    return p


def product(p, q):
    result = [0] * (len(p) + len(q) - 1) if p and q else []
    for i, x in enumerate(p):
        for j, y in enumerate(q):
            result[i + j] += x * y
    return trimmed(result)


def sturm(p):
    """The Sturm sequence of the square-free part of a polynomial."""
    p = divide(p, common_divisor(p, slope(p)))[0] if len(p) > 1 else p
    sequence = [p, slope(p)]
    while sequence[-1]:
        sequence.append([-c for c in divide(sequence[-2], sequence[-1])[1]])
    return sequence[:-1]


def variations(sequence, x):
    """Changes of sign at a number, or below (`'-'`) or above (`'+'`) all roots."""
    if x == '+':
        values = [p[-1] for p in sequence]
    elif x == '-':
        values = [p[-1] * (-1) ** (len(p) - 1) for p in sequence]
    else:
        values = [value(p, x) for p in sequence]
    signs = [v > 0 for v in values if v]
    return sum(a != b for a, b in zip(signs, signs[1:]))


def roots_between(sequence, low, high):
    """The number of roots strictly between two numbers, `None` for no limit."""
    count = variations(sequence, '-' if low is None else low) - variations(sequence, '+' if high is None else high)
    return count - (high is not None and value(sequence[0], high) == 0)

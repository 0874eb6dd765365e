"""Reads the texts of statements, certificates and witnesses (grammar: `kernel/src/text`, `tests/support`)."""

import re
from fractions import Fraction

import algebra


class Refused(Exception):
    """Why something is not accepted."""


def need(holds, reason):
    if not holds:
        raise Refused(reason)


MAX_PLACE, MAX_VARIABLE = 1_000_000, 4096
NUMBER = re.compile(r'(-?)(0|[1-9][0-9]*)(?:/([1-9][0-9]*))?', re.ASCII)
INDEX = re.compile(r'0|[1-9][0-9]*', re.ASCII)


def tree(text):
    """Nested lists of words; single blanks between the elements of a list and nowhere else."""
    need(re.fullmatch(r'[^\s]+( [^\s]+)*', text), 'blanks stand where none are written')
    need('( ' not in text and ' )' not in text and ')(' not in text, 'blanks stand where none are written')
    open_lists = [[]]
    for token in re.findall(r'[()]|[^() ]+', text):
        if token == '(':
            open_lists.append([])
        elif token == ')':
            need(len(open_lists) > 1, 'a bracket is closed that is not open')
            done = open_lists.pop()
            open_lists[-1].append(done)
        else:
            open_lists[-1].append(token)
    need(len(open_lists) == 1 and len(open_lists[0]) == 1, 'the text is not one list or word')
    need(not re.search(r'[^( ]\(|\)[^) ]', text), 'blanks are missing')
    return open_lists[0][0]


def word(t):
    need(isinstance(t, str), 'a word is expected')
    return t


def items(t):
    need(isinstance(t, list), 'a list is expected')
    return t


def number(t):
    found = NUMBER.fullmatch(word(t))
    need(found, 'a number is expected')
    sign, above, below = found.groups()
    x = Fraction(int(above), int(below or 1))
    need(int(above) == x.numerator and int(below or 1) == x.denominator, 'a number is not in lowest terms')
    need(below != '1' and not (sign and x == 0), 'a number is written in another way')
    return algebra.plain(-x if sign else x)


def place(t):
    need(INDEX.fullmatch(word(t)) and int(t) <= MAX_PLACE, 'a whole number is expected')
    return int(t)


def variable(t):
    w = word(t)
    need(w[:1] == 'x' and INDEX.fullmatch(w[1:]) and int(w[1:]) <= MAX_VARIABLE, 'a variable is expected')
    return int(w[1:])


def polynomial(t):
    """An expanded sum by increasing total degree, within a degree the lexicographically greater monomial first."""
    w = word(t)
    if w == '0':
        return {}
    result, before = {}, None
    for k, (sign, term) in enumerate(re.findall(r'([+-]?)([^+-]*)', w)[:-1]):
        need(term and (sign or k == 0) and not (k == 0 and sign == '+'), 'a polynomial is expected')
        factors = term.split('*')
        c = 1
        if factors[0][0:1].isdigit():
            c = number(factors[0])
            need(c != 0 and (c != 1 or len(factors) == 1), 'a coefficient is written in another way')
            factors = factors[1:]
        monomial = []
        for factor in factors:
            name, _, exponent = factor.partition('^')
            v = variable(name)
            need('^' not in factor or (INDEX.fullmatch(exponent) and 2 <= int(exponent) < 1 << 16), 'an exponent')
            need(not monomial or monomial[-1][0] < v, 'variables are in another order')
            monomial.append((v, int(exponent or 1)))
        monomial = tuple(monomial)
        here = (sum(e for _, e in monomial), algebra.order(monomial))
        need(before is None or before < here, 'terms are in another order')
        before = here
        result[monomial] = -c if sign == '-' else c
    need(result, 'a polynomial is expected')
    return result


def head(t):
    return t[0] if isinstance(t, list) and t and isinstance(t[0], str) else None


def signed(t):
    """(whether it is the opposite, proof)."""
    if t in ('+', '-'):
        return t == '-', '.'
    need(head(t) in ('+', '-') and len(t) == 2, 'a sign is expected')
    need(t[1] != '.', 'a sign is written in another way')
    return t[0] == '-', t[1]


def pairs(ts):
    need(len(ts) % 2 == 0, 'an index with its factor is expected')
    return [(place(k), number(x)) for k, x in zip(ts[::2], ts[1::2])]


def univariate(t):
    """A number, or a list of at least two coefficients of which the last is not zero."""
    if isinstance(t, str):
        return algebra.trimmed([number(t)])
    cs = [number(c) for c in t]
    # The polynomial 0 and numbers are written as one number.
    need(len(cs) > 1 and cs[-1] != 0, 'a value is written in another way')
    return cs


# Well-formedness: every part of a certificate is read, also one on which nothing depends.


def check_proof(t):
    if t == '.':
        return
    kind = head(t)
    if kind == 'cut':
        check_cuts(t)
    elif kind == 'corners':
        need(len(t) in (4, 6), 'corners')
        variable(t[1])
        for part in t[2:4] + t[5:]:
            check_proof(part)
        if len(t) == 6:
            number(t[4])
    elif kind == 'factors':
        need(len(t) >= 2, 'factors')
        for factor in t[1:-1]:
            need(len(items(factor)) == 2, 'a factor with its sign is expected')
            polynomial(factor[0])
            if factor[1] != '^':
                check_proof(signed(factor[1])[1])
        check_proof(signed(t[-1])[1])
    elif kind == 'squares':
        need(len(t) >= 2, 'squares')
        for square in t[1:-1]:
            need(len(items(square)) == 2, 'a number with a polynomial is expected')
            number(square[0])
            polynomial(square[1])
        check_proof(t[-1])
    elif kind == 'faces':
        for part in t[1:]:
            check_proof(part)
    elif kind == 'cells':
        need(len(t) == 4, 'cells')
        check_levels(t[1], t[2])
        for sample in items(t[3]):
            check_sample(sample)
    elif kind == 'slices':
        need(len(t) == 3, 'slices')
        for base in items(t[1]):
            need(len(items(base)) == 4, 'the slices along one variable are expected')
            check_levels(base[0], base[1])
            for section in items(base[2]):
                if head(section) == '=':
                    need(len(section) == 3, 'a section is expected')
                    number(section[1])
                    check_proof(section[2])
                else:
                    need(len(items(section)) == 2, 'a section is expected')
                    number(section[0]), number(section[1])
            for sector in items(base[3]):
                need(len(items(sector)) == 2, 'a number with a proof is expected')
                number(sector[0])
                check_proof(sector[1])
        for box in items(t[2]):
            need(len(items(box)) % 2 == 0, 'two ends are expected')
            for x in box:
                number(x)
    else:
        raise Refused('there is no such proof of a sign')


def check_cuts(t):
    if t == '.':
        return
    need(head(t) == 'cut' and len(t) == 4, 'a cell or a cut is expected')
    variable(t[1])
    check_cuts(t[2])
    check_cuts(t[3])


def check_levels(order, levels):
    for v in items(order):
        variable(v)
    for level in items(levels):
        for p in items(level):
            polynomial(p)


def check_sample(t):
    if isinstance(t, str):
        number(t)
        return
    need(len(t) > 1, 'a sample is expected')
    number(t[0])
    for above in t[1:]:
        check_sample(above)


def certificate(text):
    t = tree(text)
    if t == 'direct':
        return t
    kind = head(t)
    if kind == 'sign':
        need(len(t) == 3, 'a sign')
        if t[1] != '_':
            check_proof(signed(t[1])[1])
        check_proof(t[2])
    elif kind == 'minors':
        for proof in t[1:]:
            check_proof(proof)
    elif kind == 'rank':
        need(len(t) == 3, 'a rank')
        for piece in items(t[1]):
            blocks = items(piece)
            if head(piece) == 'change':
                need(len(piece) >= 3, 'other bases')
                for basis in piece[1:3]:
                    for combination in items(basis):
                        pairs(items(combination))
                blocks = piece[3:]
            for block in blocks:
                need(len(items(block)) == 3, 'a block is expected')
                for lists in [[block[0]], items(block[1])]:
                    for places in lists:
                        for k in items(places):
                            place(k)
                check_proof(signed(block[2])[1])
        for combination in items(t[2]):
            for p in items(combination):
                polynomial(p)
    else:
        raise Refused('there is no such certificate')
    return t


def point(t):
    """(root or `None`, coordinates): root is (polynomial, low, high), coordinates pairs of variable and value."""
    need(head(t) == 'at', 'a point is expected')
    parts, root = t[1:], None
    if parts and head(parts[0]) == 'root' and len(parts[0]) == 4:
        _, m, low, high = parts[0]
        need(isinstance(m, list), 'a polynomial is expected')
        cs = [number(c) for c in m]
        need(not cs or cs[-1] != 0, 'a polynomial is written in another way')
        root, parts = (cs, number(low), number(high)), parts[1:]
    coordinates = []
    for part in parts:
        need(len(items(part)) == 2, 'a coordinate is expected')
        coordinates.append((variable(part[0]), univariate(part[1])))
    return root, coordinates


def witness(text):
    """(kind, point, the rest)."""
    t = tree(text)
    kind = head(t)
    if kind == 'at':
        return kind, point(t), None
    need(kind in ('dependent', 'independent', 'line') and len(t) > 1, 'there is no such witness')
    rest = t[2:]
    if kind == 'dependent':
        rest = [univariate(c) for c in rest]
    elif kind == 'line':
        rest = pairs(rest)
    else:
        need(len(rest) == 1, 'the number of an exception is expected')
        rest = place(rest[0])
    return kind, point(t[1]), rest


# Statements.


def end(t):
    """(number or `None`, whether it belongs to the range)."""
    if t == '_':
        return None, False
    return (number(t[1:]), True) if t.startswith('=') else (number(t), False)


def ranges(t):
    return [(variable(v), (end(low), end(high))) for v, low, high in t]


def domain(t):
    box, simplices, premises = t
    return (
        ranges(box),
        [(number(s[0]), [variable(v) for v in s[1:]]) for s in simplices],
        [(relation, polynomial(p)) for relation, p in premises],
    )


def statement(text):
    t = tree(text)
    if t[0] == 'zero':
        return 'zero', polynomial(t[1]), polynomial(t[2]), domain(t[3])
    if t[0] == 'sign':
        return 'sign', t[1], polynomial(t[2]), polynomial(t[3]), domain(t[4])
    if t[0] == 'products':
        products = [(variable(v), place(p), place(q)) for v, p, q in t[3]]
        return 'products', t[1], polynomial(t[2]), products, domain(t[4])
    rows = [[polynomial(p) for p in row] for row in t[1]]
    exceptions = [[(variable(v), number(x)) for v, x in values] for values in t[2]]
    return 'independent', rows, exceptions, ranges(t[3])

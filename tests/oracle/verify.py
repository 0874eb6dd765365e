#!/usr/bin/env python3
"""A second checker of certificates, which shares no line with the kernel: `verify.py FILE`.

FILE has a JSON object on each line: `statement`, `certificate` or `witness` as texts, and `kernel`: `true` if the kernel
accepts it, else why it does not. The texts are described in `kernel/src/text` and `tests/support/src/statement.rs`, the
rules with their theorems in `kernel/src/check`. This file was written from these descriptions, with fractions and nothing
else; where the kernel computes modulo primes, or by interpolation, it computes exactly and by determinants.

Nothing is counted here: what the kernel refuses because it takes too much work or is too large, is not compared. The
exit code is 1 if the two disagree anywhere else.
"""

import json
import sys
from collections import Counter
from fractions import Fraction
from math import lcm

import text
from algebra import (
    ONE, ZERO, add, at, coefficients, constant, degree, derivative, determinant, divide, multiply, number, plain, power,
    product, quotient, rank, resultant, roots_between, scale, sturm, substitute, trimmed, value, variable, variables,
)
from text import Refused, head, items, need, pairs, polynomial, signed

EVERYWHERE = ((None, False), (None, False))


def sign(x):
    return (x > 0) - (x < 0)


def as_claimed(relation, x):
    return x > 0 if relation == '>' else x >= 0


# Ranges and boxes. A range is a pair of ends, an end a number or `None`, and whether it belongs to the range; a box is a
# list of pairs of variable and range.


def contains(r, x):
    (a, a_in), (b, b_in) = r
    return (a is None or a < x or a_in and a == x) and (b is None or x < b or b_in and x == b)


def inside(r, x):
    """Whether a number lies in a range and is not one of its ends."""
    (a, _), (b, _) = r
    return (a is None or a < x) and (b is None or x < b)


def empty(r):
    (a, a_in), (b, b_in) = r
    return a is not None and b is not None and (a > b or a == b and not (a_in and b_in))


def range_of(box, v):
    return next((r for w, r in box if w == v), EVERYWHERE)


def single(r):
    (a, _), (b, _) = r
    return a is not None and a == b and not empty(r)


# Signs.


def sign_on_box(p, relation, box, proof):
    """p ≥ 0 (> 0) on a box."""
    if any(empty(r) for _, r in box):
        need(proof == '.', 'nothing has to be proved on an empty box')
        return
    for v, r in box:
        if single(r):
            p = at(p, v, r[0][0])
    sign_of_part(p, relation, [(v, range_of(box, v)) for v in variables(p)], proof)


def restricted(p, box):
    """The ranges of the variables that occur."""
    occurring = variables(p)
    need(all(any(v == w for w, _ in box) for v in occurring), 'a part has other variables than the whole')
    return [(v, r) for v, r in box if v in occurring]


def sign_of_part(p, relation, box, proof):
    """p ≥ 0 (> 0) on a box of exactly the variables of p."""
    c = number(p)
    if c is not None:
        need(proof == '.', 'a number needs no proof')
        need(as_claimed(relation, c), 'a number is not as claimed')
        return
    kind = head(proof)
    if proof == '.' or kind == 'cut':
        cuts(p, relation, box, proof)
    elif kind == 'corners':
        corners(p, relation, box, proof)
    elif kind == 'factors':
        factors(p, relation, box, proof)
    elif kind == 'squares':
        squares(p, relation, box, proof)
    elif kind == 'faces':
        faces(p, relation, box, proof[1:])
    elif kind == 'cells':
        cells(p, relation, box, proof)
    else:
        slices(p, relation, box, proof)


def part(p, relation, box, proof):
    sign_of_part(p, relation, restricted(p, box), proof)


def opposite_is_shown(p, relation, box, proof, check=part):
    """Checks the sign of p or of −p, and says whether it is −p."""
    negative, own = signed(proof)
    check(scale(p, -1) if negative else p, relation, box, own)
    return negative


def cuts(p, relation, box, tree):
    """Bernstein coefficients on the cells; sides without ends are cut at 0 first."""
    for k, (v, r) in enumerate(box):
        if r[0][0] is None and r[1][0] is None:
            need(tree == '.' or text.variable(tree[1]) == v, 'a side without ends has to be cut first')
            low, high = ('.', '.') if tree == '.' else tree[2:]
            zero = (0, True)
            cuts(p, relation, box[:k] + [(v, (r[0], zero))] + box[k + 1:], low)
            cuts(p, relation, box[:k] + [(v, (zero, r[1]))] + box[k + 1:], high)
            return
    cell(p, relation, box, tree)


def cell(p, relation, box, tree):
    if tree != '.':
        v = text.variable(tree[1])
        need(any(v == w for w, _ in box), 'a cell is cut along a variable that does not occur')
        (a, a_in), (b, b_in) = range_of(box, v)
        if a is None:
            middle = b - 1
        elif b is None:
            middle = a + 1
        else:
            middle = plain(Fraction(a + b) / 2)
        half = lambda r: [(w, r if w == v else s) for w, s in box]
        cell(p, relation, half(((a, a_in), (middle, True))), tree[2])
        cell(p, relation, half(((middle, True), (b, b_in))), tree[3])
        return
    coefficients_of_cell = bernstein(p, box)
    need(all(c >= 0 for c in coefficients_of_cell.values()), 'a Bernstein coefficient is negative')
    if relation == '>':
        # The smallest faces that belong to the box: by axis the places of their coefficients.
        faces_of_cell = [()]
        for v, ((_, low), (_, high)) in box:
            n = degree(p, v)
            own = [{0}] * low + [{n}] * high or [set(range(n + 1))]
            faces_of_cell = [face + (places,) for face in faces_of_cell for places in own]
        for face in faces_of_cell:
            on_face = lambda index: all(i in places for i, places in zip(index, face))
            need(any(c and on_face(i) for i, c in coefficients_of_cell.items()), 'p vanishes on a face of a cell')


def side_matrix(n, r):
    """What one variable of degree n becomes on a side: row i has xⁱ as coefficients of sᵏ rⁿ⁻ᵏ, r + s = 1, up to a
    positive factor."""
    (a, _), (b, _) = r
    if a is None:
        above, below = [-1, b], [0, 1]  # x = (b·s − r)/s
    elif b is None:
        above, below = [a, 1], [1, 0]  # x = (a·r + s)/r
    else:
        above, below = [a, b], [1, 1]  # x = (a·r + b·s)/(r + s)
        m = lcm(Fraction(a).denominator, Fraction(b).denominator)
        above, below = [plain(Fraction(x) * m) for x in above], [m, m]
    rows = []
    for i in range(n + 1):
        row = [1]
        for factor in [above] * i + [below] * (n - i):
            row = [
                (row[k] * factor[0] if k < len(row) else 0) + (row[k - 1] * factor[1] if k else 0)
                for k in range(len(row) + 1)
            ]
        rows.append(row)
    return rows


def bernstein(p, box):
    """The coefficients by their places, up to one positive factor and the binomial coefficients."""
    common = lcm(*(Fraction(c).denominator for c in p.values()))
    axes = [v for v, _ in box]
    tensor = {tuple(dict(m).get(v, 0) for v in axes): plain(c * common) for m, c in p.items()}
    for axis, (v, r) in enumerate(box):
        rows = side_matrix(degree(p, v), r)
        changed = {}
        for index, c in tensor.items():
            for k, factor in enumerate(rows[index[axis]]):
                if factor:
                    place = index[:axis] + (k,) + index[axis + 1:]
                    changed[place] = changed.get(place, 0) + c * factor
        tensor = changed
    return tensor


def corners(p, relation, box, proof):
    """p has degree 1 in a variable and lies between its values at the ends of the range."""
    v = text.variable(proof[1])
    need(any(v == w for w, _ in box), 'a variable does not occur')
    (a, a_in), (b, b_in) = r = range_of(box, v)
    need(degree(p, v) == 1, 'p is not of degree 1 in the variable of the corners')
    need(a is not None or b is not None, 'a range without ends has no corners')
    slope_in_v = derivative(p, v)
    for x, own, belongs, direction in [(a, proof[2], a_in, -1), (b, proof[3], b_in, 1)]:
        restriction = scale(slope_in_v, direction) if x is None else at(p, v, x)
        part(restriction, relation if belongs else '>=', box, own)
    strict = a_in or b_in
    if len(proof) == 6:
        x = text.number(proof[4])
        need(inside(r, x), 'the middle is not strictly inside its range')
        part(at(p, v, x), relation, box, proof[5])
        strict = True
    need(strict or relation == '>=', 'nothing shows that the value is not zero')


def divided(p, q):
    """What is left of p, not zero, after division by q, and how often it could be divided."""
    count = 0
    while (left := quotient(p, q)) is not None:
        p, count = left, count + 1
    return p, count


def factors(p, relation, box, proof):
    negative = False
    for f, known in proof[1:-1]:
        f = polynomial(f)
        need(number(f) is None, 'a factor is a number')
        p, exponent = divided(p, f)
        need(exponent > 0, 'a factor does not divide p')
        if known == '^':
            need(exponent % 2 == 0 and relation == '>=', 'the sign of a factor is open')
        else:
            negative ^= opposite_is_shown(f, relation, box, known) and exponent % 2 == 1
    negative ^= opposite_is_shown(p, relation, box, proof[-1])
    need(not negative, 'the product of the signs is negative')


def squares(p, relation, box, proof):
    """p is a sum of squares, each times a positive number, and of something that is as claimed."""
    for c, f in proof[1:-1]:
        c, f = text.number(c), polynomial(f)
        need(c > 0, 'a square is multiplied by a number that is not positive')
        p = add(p, multiply(f, f), -c)
    part(p, relation, box, proof[-1])


def faces(p, relation, box, proofs):
    """p > 0 on every relatively open face; for each variable the open range, the lower end, the upper end."""
    need(relation == '>', 'faces are for p > 0 only')
    # Pairs of the restriction of p and the ranges of the face.
    found = [(p, [])]
    for v, ((a, a_in), (b, b_in)) in box:
        found = [
            (q, rest + [(v, ((a, False), (b, False)))]) if x is None else (at(q, v, x), rest)
            for q, rest in found
            for x in [None] + [a] * a_in + [b] * b_in
        ]
    need(len(found) == len(proofs), 'the number of faces is another one')
    for (q, rest), proof in zip(found, proofs):
        part(q, relation, rest, proof)


# Cylindrical decompositions.


def made_of(p, lower):
    """p is a number different from 0 times powers of given polynomials."""
    need(p, 'a projection is zero')
    for level in reversed(lower):
        for f in level:
            p = divided(p, f)[0]
    need(number(p) is not None, 'a projection has a factor that the levels lack')


def projections(p, box, order, levels, trailing):
    need(sorted(order) == [v for v, _ in box], 'the order of the variables lacks one or has another')
    need(len(levels) == len(order), 'there is not one level for each variable')
    for k, level in enumerate(levels):
        for i, f in enumerate(level):
            need(f not in level[:i], 'a polynomial occurs twice')
            occurring = variables(f)
            need(order[k] in occurring and set(occurring) <= set(order[:k + 1]), 'a polynomial is on the wrong level')
    made_of(p, levels)
    for k in range(len(order) - 1, 0, -1):
        v, below = order[k], levels[:k]
        (a, _), (b, _) = range_of(box, v)
        for i, f in enumerate(levels[k]):
            cs = coefficients(f, v)
            made_of(cs[-1], below)
            for x in [a, b]:
                if x is not None:
                    restriction = at(f, v, x)
                    linear = add(variable(v), constant(x), -1)
                    whole = quotient(f, linear) if not restriction else None
                    # The end itself may be a root everywhere.
                    if whole is None or number(whole) is None:
                        made_of(restriction, below)
            if trailing and not (len(cs) == 2 and not cs[0]):
                made_of(cs[0], below)
            if len(cs) > 2:
                made_of(resultant(f, derivative(f, v), v), below)
            for g in levels[k][i + 1:]:
                made_of(resultant(f, g, v), below)


def sequences(level, v):
    """Sturm sequences of polynomials in one variable."""
    result = []
    for f in level:
        need(f, 'a polynomial of a level vanishes over a sample')
        need(set(variables(f)) <= {v}, 'a polynomial of a level depends on a higher variable')
        result.append(sturm([c.get((), 0) for c in coefficients(f, v)]))
    return result


def is_root(found, x):
    return any(value(s[0], x) == 0 for s in found)


def count(found, low, high):
    return sum(roots_between(s, low, high) for s in found)


def separated(found, numbers, r):
    """The numbers are in different ones of the intervals into which the roots cut a range, one in each."""
    need(all(inside(r, x) for x in numbers), 'a sample is outside of its range')
    need(not any(is_root(found, x) for x in numbers), 'a sample is a root')
    need(all(x < y for x, y in zip(numbers, numbers[1:])), 'samples are not in increasing order')
    need(numbers, 'there is no sample')
    outside = count(found, r[0][0], numbers[0]) + count(found, numbers[-1], r[1][0])
    need(outside == 0, 'an outer interval is without a sample')
    need(all(count(found, x, y) == 1 for x, y in zip(numbers, numbers[1:])), 'not one root between samples')


def levels_of(order, levels):
    return [text.variable(v) for v in order], [[polynomial(f) for f in level] for level in levels]


def cells(p, relation, box, proof):
    need(relation == '>=', 'open cells are for p ≥ 0 only')
    order, levels = levels_of(proof[1], proof[2])
    projections(p, box, order, levels, False)
    samples(p, box, order, levels, proof[3])


def samples(p, box, order, levels, found):
    if not order:
        need(not found, 'there are samples above the highest level')
        need(number(p) is not None and number(p) >= 0, 'p is negative at a sample')
        return
    v = order[0]
    split = [(text.number(s), []) if isinstance(s, str) else (text.number(s[0]), s[1:]) for s in found]
    separated(sequences(levels[0], v), [x for x, _ in split], range_of(box, v))
    for x, above in split:
        samples(at(p, v, x), box, order[1:], [[at(f, v, x) for f in level] for level in levels[1:]], above)


def slices(p, relation, box, proof):
    need(relation == '>' and all(not a_in and not b_in for _, ((_, a_in), (_, b_in)) in box), 'slices: open boxes')
    need(len(box) > 1, 'slices are for two variables or more')
    along = [base(p, relation, box, b) for b in proof[1]]
    if len(along) == 1:
        need(not along[0][2], 'a variable is not cut into slices')
    else:
        need([v for v, _, _ in along] == [v for v, _ in box], 'a variable is not cut into slices')
    combinations = [[]]
    for v, found, irrational in along:
        combinations = [c + [(v, found, ends)] for c in combinations for ends in irrational]
    boxes = proof[2]
    need(len(combinations) == len(boxes), 'the number of boxes is another one')
    for combination, ends in zip(combinations, boxes):
        need(len(ends) == 2 * len(combination), 'a box has another dimension')
        sides = []
        for (v, found, (low, high)), a, b in zip(combination, ends[::2], ends[1::2]):
            a, b = text.number(a), text.number(b)
            need(low <= a < b <= high and not is_root(found, a) and not is_root(found, b), 'a box misses its point')
            need(count(found, a, b) == 1, 'a box misses its point')
            sides.append((v, ((a, True), (b, True))))
        places = 1
        for v, _ in sides:
            places *= degree(p, v) + 1
        tensor = bernstein(p, sides)
        need(len(tensor) == places and all(c > 0 for c in tensor.values()), 'a coefficient is not positive')


def base(p, relation, box, parts):
    """The slices along one variable: the variable, its roots, and the intervals of the irrational sections."""
    order, levels = levels_of(parts[0], parts[1])
    projections(p, box, order, levels, len(box) > 2)
    need(order, 'there is no level')
    v = order[0]
    r = range_of(box, v)
    found = sequences(levels[0], v)
    sectors = [(text.number(x), proof) for x, proof in parts[3]]
    numbers = [x for x, _ in sectors]
    separated(found, numbers, r)
    need(len(parts[2]) + 1 == len(numbers), 'there is not one section between neighbouring slices')
    for x, proof in sectors:
        part(at(p, v, x), relation, box, proof)
    irrational = []
    for section, low, high in zip(parts[2], numbers, numbers[1:]):
        if head(section) == '=':
            x = text.number(section[1])
            need(low < x < high and inside(r, x) and is_root(found, x), 'a section is not a root')
            part(at(p, v, x), relation, box, section[2])
        else:
            a, b = map(text.number, section)
            need(low <= a < b <= high and not is_root(found, a) and not is_root(found, b), 'no root is isolated')
            need(count(found, a, b) == 1, 'no root is isolated')
            irrational.append((a, b))
    return v, found, irrational


# Statements about quotients.


def chart(domain, polynomials):
    """Simplices as images of unit boxes: the box, and the polynomials with its variables."""
    box, simplices, _ = domain
    if not simplices:
        return box, polynomials
    occurring = [v for p in polynomials for v in variables(p)] + [v for v, _ in box]
    occurring += [v for _, vs in simplices for v in vs]
    fresh = max(occurring, default=-1) + 1
    box, done = list(box), {v for v, _ in box}
    for total, vs in simplices:
        need(vs and total >= 0, 'a simplex has no points')
        rest = constant(total)
        for v in vs:
            need(v not in done, 'a variable of a simplex has a range beside')
            done.add(v)
            s = variable(fresh)
            box.append((fresh, ((0, True), (1, True))))
            by = multiply(rest, add(ONE, s, -1))
            polynomials = [substitute(p, v, by) for p in polynomials]
            rest = multiply(rest, s)
            fresh += 1
    return box, polynomials


def check_sign(relation, above, below, domain, certificate):
    need(below, 'a denominator is zero everywhere')
    box, (above, below) = chart(domain, [above, below])
    number_below = number(below)
    if certificate == 'direct':
        proof = '.'
        if number_below is not None:
            negative = number_below < 0
        else:
            try:
                negative = opposite_is_shown(below, '>=', box, '+', sign_on_box)
            except Refused:
                negative = opposite_is_shown(below, '>=', box, '-', sign_on_box)
    else:
        need(head(certificate) == 'sign', 'the certificate is not one of a sign')
        _, of_denominator, proof = certificate
        if number_below is not None:
            need(of_denominator == '_', 'the denominator is a number, its sign needs no proof')
            negative = number_below < 0
        else:
            need(of_denominator != '_', 'the sign of the denominator is not proved')
            negative = opposite_is_shown(below, '>=', box, of_denominator, sign_on_box)
    sign_on_box(scale(above, -1) if negative else above, relation, box, proof)


def gram(p, products):
    """The constant and the matrix of a sum of dot products."""
    points = sorted({k for _, i, j in products for k in (i, j)})
    matrix = [[ZERO] * len(points) for _ in points]
    rest = ZERO
    for m, c in p.items():
        own = [(v, i, j) for v, i, j in products if v in dict(m)]
        if not own:
            rest = add(rest, {m: c})
            continue
        need(len(own) == 1 and dict(m)[own[0][0]] == 1, 'the value is not linear in the dot products')
        v, i, j = own[0]
        i, j = points.index(i), points.index(j)
        half = {tuple(pair for pair in m if pair[0] != v): Fraction(c) / 2}
        matrix[i][j] = add(matrix[i][j], half)
        matrix[j][i] = add(matrix[j][i], half)
    return rest, matrix


def sums_of_minors(matrix):
    """Of a symmetric matrix the sums of its principal minors of sizes 1, 2, …: by Faddeev and LeVerrier."""
    n = len(matrix)
    sums, product_before = [], matrix
    for k in range(1, n + 1):
        trace = ZERO
        for i in range(n):
            trace = add(trace, product_before[i][i])
        e = scale(trace, Fraction(1, k))
        sums.append(e)
        following = [[multiply(x, e) for x in row] for row in matrix]
        for i in range(n):
            for j in range(n):
                for m in range(n):
                    following[i][j] = add(following[i][j], multiply(matrix[i][m], product_before[m][j]), -1)
        product_before = following
    return sums


def check_products(relation, p, products, domain, certificate):
    rest, matrix = gram(p, products)
    sums = sums_of_minors(matrix)
    numbers = [number(s) for s in sums]
    plain_numbers = number(rest) is not None and all(number(x) is not None for row in matrix for x in row)
    if certificate == 'direct' and plain_numbers:
        need(as_claimed(relation, number(rest)), 'with all points at the origin the value is not as claimed')
        # Semidefinite exactly if no sum of principal minors is negative.
        need(all(x >= 0 for x in numbers), 'the sum of dot products is negative somewhere')
        return
    claims = [(rest, relation)] + [(s, '>=') for s in sums]
    proofs = ['.'] * len(claims)
    if certificate != 'direct':
        need(head(certificate) == 'minors', 'the certificate is not one of a sum of dot products')
        proofs = certificate[1:]
    need(len(proofs) == len(claims), 'there is not one proof for each sum of minors')
    for (s, own), proof in zip(claims, proofs):
        box, (s,) = chart(domain, [s])
        sign_on_box(s, own, box, proof)


# Linear independence.


def parts_of(box, exceptions):
    """The parts of a box in which no point has all values of an exception, as described in `check/pieces.rs`."""
    parts = [] if any(empty(r) for _, r in box) else [box]
    for values in exceptions:
        cut = []
        for rest in parts:
            if not all(contains(range_of(rest, v), x) for v, x in values):
                cut.append(rest)
                continue
            for v, x in values:
                low, high = range_of(rest, v)
                for r in [(low, (x, False)), ((x, False), high)]:
                    if not empty(r):
                        cut.append(with_range(rest, v, r))
                rest = with_range(rest, v, ((x, True), (x, True)))
        parts = cut
    return parts


def with_range(box, v, r):
    return sorted([(w, s) for w, s in box if w != v] + [(v, r)], key=lambda pair: pair[0])


def check_independent(rows, exceptions, box, certificate):
    need(len({len(row) for row in rows}) <= 1, 'the rows have different lengths')
    if certificate == 'direct':
        need(not exceptions, 'nothing is said about the exceptions')
        if any(empty(r) for _, r in box):
            return
        numbers = [[number(p) for p in row] for row in rows]
        need(all(x is not None for row in numbers for x in row), 'the table does not consist of numbers')
        need(rank(numbers) == len(rows), 'the rows are dependent')
        return
    need(head(certificate) == 'rank', 'the certificate is not one of independence')
    _, pieces, combinations = certificate
    need(len(combinations) == len(exceptions), 'there is not one combination for each exception')
    for values, combination in zip(exceptions, combinations):
        check_exception(rows, values, box, [polynomial(p) for p in combination])
    parts = parts_of(box, exceptions)
    need(len(parts) == len(pieces), 'there is not one proof for each part of the box')
    for own, piece in zip(parts, pieces):
        check_piece(rows, own, piece)


def with_values(p, values):
    for v, x in values:
        p = at(p, v, x)
    return p


def check_exception(rows, values, box, combination):
    if not all(contains(range_of(box, v), x) for v, x in values):
        need(not combination, 'an exception outside of the ranges has a combination')
        return
    need(len(combination) == len(rows), 'a combination has not one factor for each row')
    fixed = {v for v, _ in values}
    need(not any(fixed & set(variables(c)) for c in combination), 'a combination contains a fixed variable')
    need(any(combination), 'all factors of a combination are zero')
    for column in range(len(rows[0]) if rows else 0):
        total = ZERO
        for c, row in zip(combination, rows):
            total = add(total, multiply(c, with_values(row[column], values)))
        need(not total, 'a combination does not vanish at its exception')


def check_piece(rows, box, piece):
    fixed = [(v, r[0][0]) for v, r in box if single(r)]
    rows = [[with_values(p, fixed) for p in row] for row in rows]
    blocks = piece
    if head(piece) == 'change':
        rows = changed(rows, [pairs(c) for c in piece[1]], [pairs(c) for c in piece[2]])
        blocks = piece[3:]
    blocks = [([int(k) for k in r], [[int(k) for k in c] for c in cs], own) for r, cs, own in blocks]
    everywhere = sorted(k for r, _, _ in blocks for k in r)
    need(everywhere == list(range(len(rows))), 'not every row stands in exactly one block')
    width = len(rows[0]) if rows else 0
    earlier = []
    for own_rows, minors, proof in blocks:
        for columns in minors:
            need(all(k < width for k in columns), 'a minor has a column that does not exist')
            need(all(a < b for a, b in zip(columns, columns[1:])), 'columns are not in increasing order')
            zero = all(not rows[i][k] for i in earlier for k in columns)
            need(zero, 'a row is not zero in the columns of a later block')
        need(minors, 'a block has no minor')
        found = []
        for columns in minors:
            need(len(columns) == len(own_rows), 'a minor has not as many columns as rows')
            found.append(determinant([[rows[i][k] for k in columns] for i in own_rows]))
        total = found[0]
        if len(found) > 1:
            total = ZERO
            for minor in found:
                total = add(total, power(minor, 2))
        opposite_is_shown(total, '>', box, proof, sign_on_box)
        earlier += own_rows


def changed(rows, new_rows, new_columns):
    height, width = len(rows), len(rows[0]) if rows else 0
    need(len(new_rows) == height, 'the new basis has not as many rows')
    need(len(new_columns) <= width, 'the new basis has more columns')
    known = all(k < height for c in new_rows for k, _ in c) and all(k < width for c in new_columns for k, _ in c)
    need(known, 'a basis combines a row or column that does not exist')
    dense = [[sum(x for k, x in c if k == i) for i in range(height)] for c in new_rows]
    need(rank(dense) == height, 'the rows of the new basis are dependent')

    def combined(vectors, combination):
        total = [ZERO] * len(vectors[0]) if vectors else []
        for k, x in combination:
            total = [add(p, q, x) for p, q in zip(total, vectors[k])]
        return total

    rows = [combined(rows, c) for c in new_rows]
    columns = [list(column) for column in zip(*rows)]
    columns = [combined(columns, c) for c in new_columns]
    return [[column[i] for column in columns] for i in range(height)]


# Points at which something fails.


class Point:
    """Coordinates in Q, or in Q(θ) for a root θ of m between two numbers; values are polynomials in θ."""

    def __init__(self, described):
        self.root, coordinates = described
        size = 1
        if self.root is not None:
            m, low, high = self.root
            opposite = low < high and value(m, low) * value(m, high) < 0
            need(opposite, 'a polynomial is not seen to have a root in its interval')
            size = len(m) - 1
        need(all(len(x) <= size for _, x in coordinates), 'a coordinate is not reduced')
        self.coordinates = dict(coordinates)
        need(len(self.coordinates) == len(coordinates), 'a coordinate is given twice')

    def product(self, a, b):
        c = product(a, b)
        return divide(c, self.root[0])[1] if self.root else c

    def value(self, p):
        vs = variables(p)
        if not vs:
            return trimmed([number(p)])
        need(vs[-1] in self.coordinates, 'a point lacks a coordinate')
        x = self.coordinates[vs[-1]]
        if len(x) <= 1:
            return self.value(at(p, vs[-1], x[0] if x else 0))
        total = []
        for c in reversed(coefficients(p, vs[-1])):
            total = sum_of(self.product(total, x), self.value(c))
        return total

    def sign(self, x):
        """The sign of a value: 0 only for the value 0, otherwise from an interval that contains it."""
        if len(x) <= 1:
            return sign(x[0]) if x else 0
        need(self.root, 'a coordinate contains a root that is not given')
        _, low, high = self.root
        least = most = 0
        for c in reversed(x):
            products = [least * low, least * high, most * low, most * high]
            least, most = min(products) + c, max(products) + c
        need(least > 0 or most < 0, 'the sign of a value is not seen in the interval of the root')
        return 1 if least > 0 else -1

    def sign_of(self, p):
        return self.sign(self.value(p))

    def lies_in(self, domain):
        box, simplices, premises = domain
        for v, r in box:
            if v not in self.coordinates:
                need(sum(w == v for w, _ in box) == 1 and not empty(r), 'a range is empty')
                continue
            (a, a_in), (b, b_in) = r
            for x, belongs, direction in [(a, a_in, 1), (b, b_in, -1)]:
                if x is not None:
                    s = self.sign_of(add(variable(v), constant(x), -1)) * direction
                    need(s > 0 or belongs and s == 0, 'a point lies outside of its ranges')
        for total, vs in simplices:
            rest = constant(total)
            for v in vs:
                if v in self.coordinates:
                    need(self.sign(self.coordinates[v]) >= 0, 'a point lies outside of its simplex')
                    rest = add(rest, variable(v), -1)
            need(self.sign_of(rest) >= 0, 'a point lies outside of its simplex')
        for relation, p in premises:
            need(as_claimed(relation, self.sign_of(p)), 'a premise does not hold at the point')

    def sign_of_quotient(self, above, below):
        s = self.sign_of(below)
        need(s != 0, 'a denominator vanishes at the point')
        return self.sign_of(above) * s


def sum_of(a, b):
    n = max(len(a), len(b))
    return trimmed([(a[k] if k < len(a) else 0) + (b[k] if k < len(b) else 0) for k in range(n)])


def check_failure(statement, witness):
    """Checks that a statement fails where the witness says."""
    (kind, described, rest), what = witness, statement[0]
    if what in ('zero', 'sign'):
        need(kind == 'at', 'the witness is one against another kind of statement')
        relation, above, below, domain = statement[1:] if what == 'sign' else ('0', *statement[1:])
        point = Point(described)
        point.lies_in(domain)
        s = point.sign_of_quotient(above, below)
        need(s != 0 if what == 'zero' else not as_claimed(relation, s), 'the value is as claimed at the point')
    elif what == 'products':
        need(kind == 'line', 'the witness is one against another kind of statement')
        _, relation, p, products, domain = statement
        point = Point(described)
        point.lies_in(domain)
        names = [v for v, _, _ in products]
        known = set(point.coordinates) | {v for v, _ in domain[0]} | {v for _, vs in domain[1] for v in vs}
        need(len(set(names)) == len(names) and not known & set(names), 'a dot product is given twice')
        where = {}
        for k, x in rest:
            where.setdefault(k, x)
        for v, i, j in products:
            p = at(p, v, where.get(i, 0) * where.get(j, 0))
        need(not as_claimed(relation, point.sign_of(p)), 'the value is as claimed at the point')
    else:
        _, rows, exceptions, box = statement
        need(kind in ('dependent', 'independent'), 'the witness is one against another kind of statement')
        point = Point(described)
        point.lies_in((box, [], []))
        if kind == 'dependent':
            for values in exceptions:
                apart = [point.sign_of(add(variable(v), constant(x), -1)) != 0 for v, x in values]
                need(any(apart), 'the point is an exception')
            need(len(rest) == len(rows), 'there is not one factor for each row')
            need(any(len(c) == 1 for c in rest), 'no factor is a number different from 0')
            for column in range(len(rows[0]) if rows else 0):
                total = []
                for c, row in zip(rest, rows):
                    if c:
                        total = sum_of(total, point.product(c, point.value(row[column])))
                need(not total, 'the combination does not vanish at the point')
        else:
            need(rest < len(exceptions), 'there is no such exception')
            for v, x in exceptions[rest]:
                need(point.coordinates.get(v) == trimmed([x]), 'the point is not one of the exception')
            numbers = [[point.value(p) for p in row] for row in rows]
            need(all(len(x) <= 1 for row in numbers for x in row), 'the point is irrational')
            full = rank([[x[0] if x else 0 for x in row] for row in numbers]) == len(rows)
            need(full, 'the rows are dependent at the point')


def check_proof(statement, certificate):
    """Checks that a certificate proves a statement."""
    what = statement[0]
    if what == 'zero':
        need(certificate == 'direct', 'the certificate is one of another kind of statement')
        need(statement[2], 'a denominator is zero everywhere')
        need(not statement[1], 'the expanded difference is not zero')
    elif what == 'sign':
        check_sign(*statement[1:], certificate)
    elif what == 'products':
        check_products(*statement[1:], certificate)
    else:
        check_independent(*statement[1:], certificate)


# Reasons of the kernel that are limits of its size or work.
LIMITS = ('more work', 'too large', 'too many', 'too deeply', 'too long')


def main(path):
    sys.setrecursionlimit(20_000)
    counts, wrong = Counter(), 0
    known = {}
    with open(path, encoding='utf-8') as lines:
        for line in lines:
            entry = json.loads(line)
            kernel = entry['kernel']
            if kernel is not True and any(limit in kernel for limit in LIMITS):
                counts['beyond the limits of the kernel'] += 1
                continue
            said = entry['statement']
            if said not in known:
                known.clear()
                known[said] = text.statement(said)
            statement = known[said]
            try:
                if 'certificate' in entry:
                    check_proof(statement, text.certificate(entry['certificate']))
                else:
                    check_failure(statement, text.witness(entry['witness']))
                here = True
            except Refused as refusal:
                here = str(refusal)
            kind = 'certificate' if 'certificate' in entry else 'witness'
            if (here is True) == (kernel is True):
                counts[f'{kind} {"accepted" if here is True else "refused"} by both'] += 1
            else:
                wrong += 1
                if wrong <= 20:
                    print(f'DISAGREEMENT: kernel: {kernel}, here: {here}\n  {line.strip()[:2000]}')
    for kind, n in sorted(counts.items()):
        print(f'{n} {kind}')
    print(f'{wrong} disagreements')
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))

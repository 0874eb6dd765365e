#!/usr/bin/env python3
"""Recomputes the verdicts of specs without the engine: an own reader of the language, SymPy and mpmath.

    tests/oracle/library.py specs/curves specs/trigonometric --command target/debug/basis

Equations, inequalities, sums, symmetry, joints and minors are evaluated with 40 digits at points of the domain and shape values,
ends included; independence is a rank. A claim that is declared false is looked for in the same way, and otherwise evaluated at the
counterexample that the command prints. This does not prove anything again: it contradicts what is wrong. Of families with an index
parameter the first two orders are taken. Theorems, rounding bounds and conjectures are left out, and counted.
"""

import argparse
import itertools
import json
import math
import pathlib
import random
import re
import subprocess
import sys

import mpmath
import sympy as sp

mpmath.mp.dps = 40
SMALL = mpmath.mpf(10) ** -25
SPECS = pathlib.Path(__file__).resolve().parents[2] / "specs"
TOKEN = re.compile(r"\s+|//[^\n]*|/\*.*?\*/|(\d+\.\d+|\d+(?!\.\d)|[^\W\d]\w*|\.\.=|\.\.|<=|>=|==|!=|&&|\|\||\"[^\"]*\"|.)", re.S)


class Unknown(Exception):
    """A construct that this reader does not know."""


def tokens(text):
    return [m.group(1) for m in TOKEN.finditer(text) if m.group(1)] + [""]


class Reader:
    """Recursive descent over the tokens of a spec."""

    def __init__(self, text):
        self.t, self.i = tokens(text), 0

    def peek(self, k=0):
        return self.t[min(self.i + k, len(self.t) - 1)]

    def take(self):
        self.i += 1
        return self.t[self.i - 1]

    def accept(self, *which):
        return self.take() if self.peek() in which else None

    def expect(self, token):
        if self.take() != token:
            raise Unknown(f"expected {token}, found {self.t[self.i - 1]} after {' '.join(self.t[self.i - 9:self.i - 1])}")

    # Formulas: tuples of an operation and its operands.
    def formula(self):
        left = self.term()
        while op := self.accept("+", "-"):
            left = (op, left, self.term())
        return left

    def term(self):
        left = self.unary()
        while op := self.accept("*", "/"):
            left = (op, left, self.unary())
        return left

    def unary(self):
        if self.accept("-"):
            return ("neg", self.unary())
        return self.power()

    def power(self):
        base = self.postfix()
        return ("^", base, self.unary()) if self.accept("^") else base

    def postfix(self):
        node = self.atom()
        while self.peek() in ("(", "["):
            if self.take() == "(":
                node = ("call", node, self.arguments(")"))
            else:
                node = ("index", node, self.arguments("]"))
        return node

    def arguments(self, close):
        found = []
        while not self.accept(close):
            found.append(self.formula())
            if self.peek() == "for":
                found[-1] = ("loop", found[-1], self.loops())
            self.accept(",")
        return found

    def atom(self):
        token = self.take()
        if token == "(":
            node = self.formula()
            self.expect(")")
            return node
        if token == "[":
            return ("list", self.arguments("]"))
        if token[:1].isdigit():
            return ("number", sp.Rational(token))
        if re.match(r"[^\W\d]", token):
            return ("name", token)
        raise Unknown(f"unexpected {token!r}")

    def loops(self):
        loops = []
        if self.accept("for"):
            while True:
                names = [self.take()]
                while self.accept(","):
                    names.append(self.take())
                self.expect("in")
                if self.peek() == "simplex":
                    self.take()
                    self.expect("(")
                    loops.append((names, "simplex", self.formula(), None))
                    self.expect(")")
                else:
                    low = self.formula()
                    kind = self.take()
                    loops.append((names, kind, low, self.formula()))
                if not self.accept(","):
                    break
        condition = self.condition() if self.accept("if") else None
        return (loops, condition)

    def condition(self):
        node = self.conjunction()
        while self.accept("||"):
            node = ("||", node, self.conjunction())
        return node

    def conjunction(self):
        node = self.negation()
        while self.accept("&&"):
            node = ("&&", node, self.negation())
        return node

    def negation(self):
        if self.accept("!"):
            return ("!", self.negation())
        start = self.i
        try:
            return self.chain()
        except Unknown:
            self.i = start
            self.expect("(")
            node = self.condition()
            self.expect(")")
            return node

    def chain(self):
        parts = [self.formula()]
        while op := self.accept("<=", ">=", "<", ">", "==", "=", "!="):
            parts += [op, self.formula()]
        if len(parts) == 1:
            raise Unknown("no comparison")
        return ("chain", parts)

    # Statements.
    def spec(self):
        families, uses = [], []
        while self.peek():
            word = self.take()
            if word == "use":
                library = bool(self.accept("library"))
                uses.append((library, self.take().strip('"')))
                self.expect(";")
            elif word == "family":
                families.append(self.family())
            elif word in ("theorem", "join"):
                while self.take() != "{":
                    pass
                depth = 1
                while depth:
                    depth += {"{": 1, "}": -1}.get(self.take(), 0)
            else:
                raise Unknown(f"statement {word}")
        return families, uses

    def family(self):
        family = {"name": self.take(), "orders": [], "body": [], "base": None}
        if self.accept("("):
            while not self.accept(")"):
                name = self.take()
                self.expect("in")
                low = self.formula()
                kind = self.take()
                family["orders"].append((name, low, kind, self.formula()))
                self.accept(",")
        self.expect("{")
        while not self.accept("}"):
            family["body"].append(self.statement())
        return family

    def statement(self):
        word = self.peek()
        if word == "domain":
            self.take()
            if self.peek() in ("triangle", "tetrahedron"):
                self.take()
                self.expect("(")
                names, spans = [n[1] for n in self.arguments(")")], []
            else:
                names, spans = [], [self.chain()]
            while self.accept(","):
                spans.append(self.chain())
            self.expect(";")
            return ("domain", names, spans)
        if word == "shape":
            self.take()
            chains = [self.chain()]
            while self.accept(","):
                chains.append(self.chain())
            loops = self.loops()
            self.expect(";")
            return ("shape", chains, loops)
        if word == "assume":
            self.take()
            node = self.chain()
            self.expect(";")
            return ("assume", node)
        if word == "budget":
            self.take(), self.formula(), self.expect(";")
            return ("nothing",)
        if word == "base":
            while self.take() != "{":
                pass
            body = []
            while not self.accept("}"):
                body.append(self.statement())
            return ("base", body, None)
        if word == "let":
            self.take()
            target = self.postfix()
            self.expect("=")
            node = self.formula()
            self.expect(";")
            return ("let", target, node)
        if word in ("prove", "refute", "conjecture"):
            self.take()
            node = self.claim()
            return ("claim", word, node)
        kind = self.take() if word in ("permute", "raise") else "function"
        target = self.postfix()
        self.expect("=")
        pieces = [self.formula()]
        while self.accept("|"):
            pieces.append(self.formula())
        loops = self.loops()
        self.expect(";")
        return (kind, target, pieces, loops)

    def claim(self):
        if self.accept("at"):
            fixed = [self.chain()]
            while self.accept(","):
                fixed.append(self.chain())
            self.expect("{")
            claims = []
            while not self.accept("}"):
                node = self.chain()
                claims.append((node, self.loops()))
                self.accept(";")
            outer = self.loops()
            self.accept(";")
            return ("at", fixed, claims, outer)
        word = self.peek()
        if word in ("partition_of_unity", "nonnegative", "symmetric", "totally_positive", "independent"):
            self.take()
            exceptions = []
            if self.accept("except"):
                while True:
                    if self.accept("("):
                        joint = [self.chain()]
                        while self.accept(","):
                            joint.append(self.chain())
                        self.expect(")")
                        exceptions.append(joint)
                    else:
                        exceptions.append([self.chain()])
                    if not self.accept(","):
                        break
            loops = self.loops()
            self.expect(";")
            return (word, exceptions, loops)
        if word in ("smooth", "continuity", "rounding"):
            self.take()
            if word == "rounding":
                while self.take() != ";":
                    pass
                return (word, None, ([], None))
            self.expect("(")
            order = self.formula()
            self.expect(")")
            if self.peek() == "with":
                raise Unknown("continuity with")
            loops = self.loops()
            self.expect(";")
            return (word, order, loops)
        node = self.chain()
        loops = self.loops()
        self.expect(";")
        return ("compare", node, loops)


def symbol(name):
    return sp.Symbol(name, real=True)


NUMBERS = {
    "binomial": lambda n, k: sp.binomial(n, k) if k >= 0 else sp.Integer(0),
    "factorial": sp.factorial, "floor": sp.floor, "ceil": sp.ceiling, "min": sp.Min, "max": sp.Max,
    "sin": sp.sin, "cos": sp.cos, "tan": sp.tan, "sinh": sp.sinh, "cosh": sp.cosh, "tanh": sp.tanh, "exp": sp.exp,
}


class Family:
    """One family at one order: its functions as SymPy expressions, one list for each span."""

    def __init__(self, shelf, family, order):
        self.shelf, self.source, self.order = shelf, family, order
        self.indices = {symbol_name: sp.Integer(v) for symbol_name, v in order.items()}
        self.lets, self.shapes, self.conditions, self.lists = {}, [], [], {}
        # The coordinates of the simplex, if there is one, then the variables of the intervals.
        self.coordinates, self.variables, self.spans = [], [], []
        self.name, self.span = None, 0
        for s in family["body"]:
            if s[0] == "domain":
                self.coordinates = [symbol(n) for n in s[1]]
                self.variables = list(self.coordinates)
            elif s[0] == "shape":
                for env in self.rounds(s[2], {}):
                    for c in s[1]:
                        self.shape(c[1], env)
        lets = [s for s in family["body"] if s[0] == "let"]
        for _, target, node in lets:
            if target[0] == "name":
                self.lets[target[1]] = ([], node)
            else:
                self.lets[target[1][1]] = ([a[1] for a in target[2]], node)
        for s in family["body"]:
            if s[0] == "domain":
                for c in s[2]:
                    parts = c[1]
                    at = next(i for i in range(0, len(parts), 2) if parts[i][0] == "name" and self.is_variable(parts, i))
                    v = symbol(parts[at][1])
                    if v not in self.variables:
                        self.variables.append(v)
                    self.spans.append((v, self.value(parts[at - 2]), self.value(parts[at + 2]), parts[at - 1] == "<", parts[at + 1] == "<"))
            if s[0] == "assume":
                self.conditions.append(s[1])
        self.count = len(self.spans) if len(self.variables) == 1 else 1
        self.functions = [self.expand(i) for i in range(self.count)]
        self.keys = sorted(self.functions[0])

    @staticmethod
    def is_variable(parts, at):
        return 0 < at < len(parts) - 1

    def shape(self, parts, env):
        names = [i for i in range(0, len(parts), 2) if parts[i][0] in ("name", "index") and not self.number(parts[i], env)]
        for i in names:
            name = self.shape_name(parts[i], env)
            if symbol(name) not in self.shapes:
                self.shapes.append(symbol(name))
                if parts[i][0] == "index":
                    self.lists.setdefault(parts[i][1][1], {})[int(name.split("[")[1][:-1])] = symbol(name)
        self.conditions.append(("chain", parts, env))

    def number(self, node, env):
        return node[0] == "name" and (node[1] in ("pi", "π") or node[1] in self.indices or node[1] in env or node[1] in self.lets)

    def shape_name(self, node, env):
        if node[0] == "name":
            return node[1]
        return f"{node[1][1]}[{', '.join(str(self.value(a, env)) for a in node[2])}]"

    def rounds(self, loops, env):
        """All values of index variables, as environments."""
        found = [dict(env)]
        for names, kind, low, high in loops[0]:
            more = []
            for e in found:
                a = int(self.value(low, e))
                if kind == "simplex":
                    rows = [r for r in itertools.product(range(a + 1), repeat=len(names)) if sum(r) == a]
                    rows.sort(reverse=True)
                else:
                    b = int(self.value(high, e)) + (kind == "..=")
                    rows = itertools.product(range(a, b), repeat=len(names))
                more += [{**e, **{n: sp.Integer(v) for n, v in zip(names, row)}} for row in rows]
            found = more
        return [e for e in found if loops[1] is None or self.true(loops[1], e)]

    def true(self, node, env):
        if node[0] == "!":
            return not self.true(node[1], env)
        if node[0] == "&&":
            return self.true(node[1], env) and self.true(node[2], env)
        if node[0] == "||":
            return self.true(node[1], env) or self.true(node[2], env)
        parts = node[1]
        values = [self.value(p, env) for p in parts[::2]]
        return all(COMPARE[op](values[i] - values[i + 1]) for i, op in enumerate(parts[1::2]))

    def expand(self, span):
        self.span, found, self.raised = span, {}, None
        body = self.source["body"]
        self.pending = []
        base = next((s for s in body if s[0] == "base"), None)
        if base is not None:
            name, low, _, _ = self.source["orders"][0]
            start = int(self.value(low))
            wanted = int(self.indices[name])
            self.indices[name] = sp.Integer(start)
            self.define(base[1], found, span)
            for n in range(start + 1, wanted + 1):
                self.indices[name] = sp.Integer(n)
                new = {}
                rule = [s for s in body if s[0] == "raise"]
                self.raised = self.table = found
                for _, target, pieces, loops in rule:
                    self.name = target[1][1]
                    variables = [a[1] for a in target[2]]
                    width = len(next(iter(found)))
                    if width == 1 and not loops[0]:
                        places = [(i,) for i in range(max(k[0] for k in found) + 2)]
                    elif loops[0]:
                        places = [tuple(int(e[v]) for v in variables) for e in self.rounds(loops, {})]
                    else:
                        places = [p for p in itertools.product(range(n + 1), repeat=width) if sum(p) == n]
                    for place in places:
                        env = {v: sp.Integer(p) for v, p in zip(variables, place)}
                        new[place] = self.value(pieces[0], env)
                found = new
            self.raised = None
            self.table = found
            return found
        self.define([s for s in body if s[0] in ("function", "permute")], found, span)
        return found

    def define(self, statements, found, span):
        self.table = found
        self.todo = {}
        for kind, target, pieces, loops in statements:
            self.name = target[1][1]
            for env in self.rounds(loops, {}):
                place = tuple(int(self.value(a, env)) for a in target[2])
                node = pieces[min(span, len(pieces) - 1)]
                if kind == "permute":
                    value = self.value(node, env)
                    for order in itertools.permutations(range(len(place))):
                        moved = tuple(place[o] for o in order)
                        swap = {self.variables[o]: self.variables[i] for i, o in enumerate(order)}
                        found[moved] = value.subs(swap, simultaneous=True)
                else:
                    self.todo[place] = (node, env)
        for place in list(self.todo):
            self.function(place)

    def function(self, place):
        if place not in self.table:
            if self.raised is not None:
                return sp.Integer(0)
            if place not in self.todo:
                raise Unknown(f"no function {place}")
            node, env = self.todo[place]
            self.table[place] = self.value(node, env)
        return self.table[place]

    def value(self, node, env=None):
        """The value of a formula: a SymPy expression, a list of them, or a reference to a family."""
        env = env or {}
        op = node[0]
        if op == "number":
            return node[1]
        if op == "name":
            return self.named(node[1], env)
        if op == "neg":
            return each(lambda x: -x, self.value(node[1], env))
        if op in "+-*/^" and len(node) == 3:
            a, b = self.value(node[1], env), self.value(node[2], env)
            return zipped(OPERATIONS[op], a, b)
        if op == "list":
            return [x for item in node[1] for x in (self.items(item, env))]
        if op == "index":
            return self.indexed(node, env)
        if op == "call":
            return self.called(node, env)
        raise Unknown(op)

    def items(self, node, env):
        if node[0] == "loop":
            return [self.value(node[1], e) for e in self.rounds(node[2], env)]
        return [self.value(node, env)]

    def named(self, name, env):
        if name in env:
            return env[name]
        if name in self.indices:
            return self.indices[name]
        if name in ("pi", "π"):
            return sp.pi
        if name in self.lists:
            return [self.lists[name][k] for k in sorted(self.lists[name])]
        if symbol(name) in self.shapes or symbol(name) in self.variables:
            return symbol(name)
        if name in self.lets:
            return self.value(self.lets[name][1], {})
        if name == self.name:
            if hasattr(self, "functions"):
                return [self.functions[self.span][k] for k in self.keys]
            for place in list(getattr(self, "todo", {})):
                self.function(place)
            return [self.table[k] for k in sorted(self.table)]
        return self.shelf.reference(self, name)

    def indexed(self, node, env):
        places = [self.value(a, env) for a in node[2]]
        if node[1][0] == "name" and node[1][1] == self.name and node[1][1] not in env:
            place = tuple(int(p) for p in places)
            if hasattr(self, "functions"):
                return self.functions[self.span][place]
            return self.function(place)
        if node[1][0] == "name" and node[1][1] in self.lists:
            return self.lists[node[1][1]][int(places[0])]
        inner = self.value(node[1], env)
        if isinstance(inner, Reference):
            return inner.at(tuple(int(p) for p in places))
        return inner[int(places[0])]

    def called(self, node, env):
        if node[1][0] == "name":
            name = node[1][1]
            if name in ("sum", "product"):
                values = [x for item in node[2] for x in self.items(item, env)]
                if len(values) == 1 and isinstance(values[0], (list, Reference)):
                    values = values[0] if isinstance(values[0], list) else values[0].all()
                result = sp.Integer(0 if name == "sum" else 1)
                for v in values:
                    result = result + v if name == "sum" else result * v
                return result
            if name == "D":
                return self.derivative(node[2], env)
            if name == "integral":
                return self.integral(node[2], env)
            if name in NUMBERS:
                return NUMBERS[name](*[self.value(a, env) for a in node[2]])
            if name in self.lets and self.lets[name][0]:
                arguments = [self.value(a, env) for a in node[2]]
                return self.value(self.lets[name][1], dict(zip(self.lets[name][0], arguments)))
        arguments = [self.value(a, env) for a in node[2]]
        if node[1][0] == "index":
            outer = self.value(node[1][1], env) if node[1][1] != ("name", self.name) else None
            if isinstance(outer, Reference):
                return outer.bound(tuple(int(self.value(a, env)) for a in node[1][2])).call(arguments)
        inner = self.value(node[1], env)
        if isinstance(inner, Reference):
            return inner.call(arguments)
        swap = dict(zip(self.variables, arguments))
        return each(lambda x: x.subs(swap, simultaneous=True), inner)

    def reduced(self, x):
        """On a simplex, without its last coordinate."""
        return x.subs(self.coordinates[-1], 1 - sum(self.coordinates[:-1])) if self.coordinates else x

    def derivative(self, nodes, env):
        x = self.value(nodes[0], env)
        if isinstance(x, Reference):
            x = x.all()
        steps = []
        for node in nodes[1:]:
            v = self.value(node, env)
            if v.is_Symbol:
                steps.append([v, 1])
            elif steps:
                steps[-1][1] = int(v)
            else:
                steps.append([self.variables[0], int(v)])
        steps = steps or [[self.variables[0], 1]]

        def one(e):
            for v, k in steps:
                if v in self.coordinates:
                    e = self.reduced(e)
                e = sp.diff(e, v, k) if k else e
            return e
        return each(one, x)

    def integral(self, nodes, env):
        if len(nodes) == 4:
            v, a, b = (self.value(n, env) for n in nodes[1:])
            if self.count > 1 and v == self.spans[0][0]:
                return self.up_to(nodes[0], b, env) - self.up_to(nodes[0], a, env)
            return sp.integrate(sp.expand(self.value(nodes[0], env)), (v, a, b))
        if len(self.variables) > 1:
            return each(self.over_the_domain, self.value(nodes[0], env))
        kept, total = self.span, sp.Integer(0)
        for i, (v, a, b, _, _) in enumerate(self.spans):
            self.span = i
            total += sp.integrate(sp.expand(self.value(nodes[0], env)), (v, a, b))
        self.span = kept
        return total

    def up_to(self, node, end, env):
        """An integral over several spans from the first knot to a value, each part with the formula of its span."""
        kept, total = self.span, sp.Integer(0)
        last = self.span_of(end)
        for i, (v, a, b, _, _) in enumerate(self.spans[: last + 1]):
            self.span = i
            total += sp.integrate(sp.expand(self.value(node, env)), (v, a, end if i == last else b))
        self.span = kept
        return total

    def span_of(self, value):
        """The span in which a value lies: with symbols as a knot, or as two samples of their values say."""
        for i, (_, a, b, _, _) in enumerate(self.spans):
            if sp.simplify(value - b) == 0 or i == 0 and sp.simplify(value - a) == 0:
                return i
        found = set()
        for sample in (1, 2):
            def at(x):
                x = sp.sympify(x)
                return x.subs({s: sample for s in x.free_symbols})
            found.add(next((i for i, s in enumerate(self.spans) if at(s[1]) <= at(value) <= at(s[2])), None))
        if len(found) > 1 or None in found:
            raise Unknown("the span of a bound")
        return found.pop()

    def over_the_domain(self, x):
        """An integral over a simplex, a box or their product."""
        x, rest = self.reduced(x), self.coordinates[:-1]
        for k, v in reversed(list(enumerate(rest))):
            x = sp.integrate(sp.expand(x), (v, 0, 1 - sum(rest[:k])))
        for v, a, b, _, _ in self.spans:
            x = sp.integrate(sp.expand(x), (v, a, b))
        return x


class Bound:
    """One function of another family, to be given arguments."""

    def __init__(self, expression, variables):
        self.expression, self.variables = expression, variables

    def call(self, arguments):
        return self.expression.subs(dict(zip(self.variables, arguments)), simultaneous=True)


class Reference:
    """Another family: first its order, then its shape values."""

    def __init__(self, user, shelf, family):
        self.user, self.shelf, self.family = user, shelf, family
        self.order, self.values = None, None

    def call(self, arguments):
        new = Reference(self.user, self.shelf, self.family)
        new.order, new.values = self.order, self.values
        if self.family["orders"] and self.order is None:
            new.order = {o[0]: int(a) for o, a in zip(self.family["orders"], arguments)}
        else:
            new.values = arguments
        return new

    def made(self):
        return self.shelf.made(self.family, self.order or {})

    def all(self):
        made = self.made()
        return [self.expression(made, k) for k in made.keys]

    def at(self, place):
        return self.expression(self.made(), place)

    def __iter__(self):
        return iter(self.all())

    def __getitem__(self, i):
        return self.all()[i]

    def __len__(self):
        return len(self.all())

    def expression(self, made, place):
        x = made.functions[0][place]
        swap = {}
        for s, v in zip(made.shapes, flat(self.values or [])):
            swap[s] = v
        swap.update(zip(made.coordinates, self.user.coordinates))
        if made.spans:
            if len(made.variables) == len(self.user.variables):
                for (v, a, b, _, _), (w, c, d, _, _) in zip(made.spans, self.user.spans):
                    same = sp.simplify(a - c) == 0 and sp.simplify(b - d) == 0
                    swap[v] = w if same else a + (w - c) * (b - a) / (d - c)
            else:
                raise Unknown("a family with other variables, without arguments")
        return x.subs(swap, simultaneous=True)

    def bound(self, place):
        made = self.made()
        x = made.functions[0][place].subs(dict(zip(made.shapes, flat(self.values or []))), simultaneous=True)
        return Bound(x, made.variables)


def flat(values):
    return [x for v in values for x in (v if isinstance(v, list) else [v])]


def listed(x):
    return x.all() if isinstance(x, Reference) else x


def each(f, x):
    x = listed(x)
    return [each(f, y) for y in x] if isinstance(x, list) else f(x)


def zipped(f, a, b):
    a, b = listed(a), listed(b)
    if isinstance(a, list) and isinstance(b, list):
        return [zipped(f, x, y) for x, y in zip(a, b)]
    if isinstance(a, list):
        return [zipped(f, x, b) for x in a]
    if isinstance(b, list):
        return [zipped(f, a, y) for y in b]
    return f(a, b)


OPERATIONS = {
    "+": lambda a, b: a + b, "-": lambda a, b: a - b, "*": lambda a, b: a * b, "/": lambda a, b: a / b, "^": lambda a, b: a**b,
}
COMPARE = {
    "=": lambda d: d == 0, "==": lambda d: d == 0, "!=": lambda d: d != 0, "<=": lambda d: d <= 0, ">=": lambda d: d >= 0,
    "<": lambda d: d < 0, ">": lambda d: d > 0,
}
NUMERIC = {
    "=": lambda d: abs(d) < SMALL, "==": lambda d: abs(d) < SMALL, "<=": lambda d: d < SMALL, ">=": lambda d: d > -SMALL,
    "<": lambda d: d < -SMALL, ">": lambda d: d > SMALL,
}


class Shelf:
    """All families by file, each made once for an order."""

    def __init__(self):
        self.files, self.cache = {}, {}
        builtin = ("family Bernstein(n in 0..=99) { domain 0 <= t <= 1; b[i] = binomial(n, i)*t^i*(1 - t)^(n - i) for i in 0..=n; }"
                   "family TriangularBernstein(n in 0..=99) { domain triangle (u, v, w);"
                   "b[i,j,k] = factorial(n)/(factorial(i)*factorial(j)*factorial(k))*u^i*v^j*w^k for i, j, k in simplex(n); }")
        self.builtin = {f["name"]: f for f in Reader(builtin).spec()[0]}

    def open(self, path):
        path = path.resolve()
        if path not in self.files:
            families, uses = Reader(path.read_text()).spec()
            visible = {f["name"]: f for f in families}
            for library, name in uses:
                other = SPECS / (name + ".basis") if library else path.parent / name
                visible = {**{f["name"]: f for f in self.open(other)[0]}, **visible}
            for f in families:
                f["visible"] = visible
            self.files[path] = (families, visible)
        return self.files[path]

    def reference(self, user, name):
        family = user.source.get("visible", {}).get(name) or self.builtin.get(name)
        if family is None:
            raise Unknown(f"name {name}")
        return Reference(user, self, family)

    def made(self, family, order):
        key = (id(family), tuple(sorted(order.items())))
        if key not in self.cache:
            self.cache[key] = Family(self, family, order)
        return self.cache[key]


class Checker:
    """Judges the claims of one family at one order."""

    def __init__(self, family, witnesses):
        self.f, self.witnesses = family, witnesses
        self.random = random.Random(family.source["name"])
        self.numeric = {}

    # Places.
    def shape_values(self, count, fixed=None):
        """Shape values that satisfy all conditions, ends included."""
        f, found, fixed = self.f, [], fixed or {}
        if not f.shapes:
            return [{}]
        conditions = [(c[1], c[2] if len(c) > 2 else {}) for c in f.conditions]
        conditions = [([f.value(p, env) for p in parts[::2]], parts[1::2]) for parts, env in conditions]
        ends = {s: set() for s in f.shapes}
        for values, _ in conditions:
            numbers = [v for v in values if v.is_number]
            for v in values:
                if v in ends:
                    ends[v].update(numbers)
        tries = 0
        while len(found) < count and tries < 4000:
            tries += 1
            point = {}
            for s in f.shapes:
                numbers = sorted(ends[s], key=lambda x: float(x))
                low = numbers[0] if numbers else sp.Integer(-2)
                high = numbers[-1] if len(numbers) > 1 else low + self.random.choice([1, 3, 12])
                pick = self.random.random()
                if pick < 0.15:
                    point[s] = low
                elif pick < 0.3:
                    point[s] = high
                else:
                    point[s] = low + (high - low) * sp.Rational(self.random.randrange(1, 97), 97)
            point.update({k: v for k, v in fixed.items() if v.is_number})
            point.update({k: v.subs(point) for k, v in fixed.items()})
            if all(COMPARE_NUMBER(vs, ops, point) for vs, ops in conditions):
                found.append(point)
        return found

    def points(self, count, span=0):
        """Points of the domain, ends first; of angles also, as fractions of the interval."""
        f, found, d = self.f, [], len(self.f.coordinates)
        spans = [f.spans[span]] if len(f.variables) == 1 else f.spans
        corners = max(d, 1) * 2 ** len(spans)
        for k in range(count):
            if k < corners:
                weights, corner = [sp.Integer(k % d == i) for i in range(d)], k // max(d, 1)
            else:
                cut = sorted(self.random.randrange(0, 30) for _ in range(d - 1))
                weights = [sp.Rational(b - a, 29) for a, b in zip([0] + cut, cut + [29])]
            point = dict(zip(f.coordinates, weights))
            for j, (v, a, b, open_a, open_b) in enumerate(spans):
                r = sp.Rational(k, 12) if len(f.variables) == 1 and k <= 12 else sp.Rational(self.random.randrange(0, 25), 24)
                if len(f.variables) > 1 and k < corners:
                    r = sp.Integer(corner >> j & 1)
                if r == 0 and open_a or r == 1 and open_b:
                    r = sp.Rational(1, 97)
                point[v] = a + (b - a) * r
            found.append(point)
        return found

    def number(self, x, point):
        """The value at a point, with 40 digits; None where it is not defined."""
        x = sp.sympify(x)
        key = x
        if key not in self.numeric:
            names = sorted(x.free_symbols, key=str)
            self.numeric[key] = (names, sp.lambdify(names, x, "mpmath"))
        names, f = self.numeric[key]
        try:
            return mpmath.mpf(f(*[point[n] for n in names])) if names else mpmath.mpf(sp.N(x, 40))
        except (ZeroDivisionError, TypeError, OverflowError, ValueError):
            return None

    def places(self, fixed=None, span=0, shapes=6, points=14):
        """Numbers for all shape parameters and domain variables."""
        f, fixed = self.f, fixed or {}
        for shape in self.shape_values(shapes, {k: v for k, v in fixed.items() if k in f.shapes}):
            for place in self.points(points, span):
                point = {**place, **{k: v for k, v in fixed.items() if k in f.variables}}
                if f.coordinates:
                    chosen = {k: v for k, v in fixed.items() if k in f.coordinates}
                    if chosen:
                        free = [v for v in f.coordinates if v not in chosen]
                        rest = 1 - sum(chosen.values())
                        weights = [place[v] for v in free]
                        total = sum(weights)
                        for v, w in zip(free, weights):
                            point[v] = rest * w / total if total else rest / len(free)
                numbers = {k: mpmath.mpf(sp.N(v, 45)) for k, v in shape.items()}
                for k, v in point.items():
                    numbers[k] = mpmath.mpf(sp.N(sp.sympify(v).subs(shape), 45))
                yield numbers

    # Verdicts: True where no place contradicts, False with one that does, None where nothing was decided.
    def everywhere(self, x, op, fixed=None, span=0, **more):
        seen = False
        for place in self.places(fixed, span, **more):
            value = self.number(x, place)
            if value is None:
                continue
            seen = True
            if not NUMERIC[op](value):
                return False
        return True if seen else None

    def compare(self, node, env, fixed, span):
        f = self.f
        f.span = span
        parts = node[1]
        values = [listed(f.value(p, env)) for p in parts[::2]]
        verdict = True
        for i, op in enumerate(parts[1::2]):
            a, b = values[i], values[i + 1]
            if isinstance(a, list) and not isinstance(b, list):
                b = [b] * len(flat_all(a))
            if isinstance(b, list) and not isinstance(a, list):
                a = [a] * len(flat_all(b))
            left = flat_all(a) if isinstance(a, list) else [a]
            right = flat_all(b) if isinstance(b, list) else [b]
            if len(left) != len(right):
                raise Unknown("lists of different lengths")
            for x, y in zip(left, right):
                one = self.everywhere(x - y, op, fixed, span)
                if one is False:
                    return False
                verdict = verdict and one
        return verdict

    def fixed(self, chains):
        f, swap = self.f, {}
        for c in chains:
            names, value = c[1][:-1:2], f.value(c[1][-1])
            for node in names:
                x = f.value(node)
                for s in x if isinstance(x, list) else [x]:
                    swap[s] = value
        return {k: sp.sympify(v).subs(swap) for k, v in swap.items()}

    def judge(self, claim):
        """One verdict for each instance of a claim."""
        f, kind = self.f, claim[0]
        if kind == "at":
            fixed = self.fixed(claim[1])
            for outer in f.rounds(claim[3], {}):
                for node, loops in claim[2]:
                    for env in f.rounds(loops, outer):
                        spans = range(f.count)
                        variable = [v for v in fixed if v in f.variables]
                        if f.count > 1 and variable:
                            spans = [i for i in spans if self.inside(fixed[variable[0]], i)]
                        yield all_of(self.compare(node, env, fixed, s) for s in spans)
            return
        if kind == "compare":
            for env in f.rounds(claim[2], {}):
                yield all_of(self.compare(claim[1], env, {}, s) for s in range(f.count))
            return
        if not f.rounds(claim[2], {}):
            return
        yield getattr(self, kind)(claim[1])

    def inside(self, value, span):
        v, a, b, _, _ = self.f.spans[span]
        for shape in self.shape_values(2):
            x, lo, hi = (float(sp.sympify(y).subs(shape)) for y in (value, a, b))
            if not lo - 1e-12 <= x <= hi + 1e-12:
                return False
        return True

    def list(self, span=0):
        return [self.f.functions[span][k] for k in self.f.keys]

    def partition_of_unity(self, _):
        return all_of(self.everywhere(sum(self.list(s)) - 1, "=", None, s) for s in range(self.f.count))

    def nonnegative(self, _):
        return all_of(self.everywhere(x, ">=", None, s, shapes=8, points=25) for s in range(self.f.count) for x in self.list(s))

    def symmetric(self, _):
        f, functions = self.f, self.list()
        if f.coordinates:
            moves = [dict(zip(f.coordinates, p)) for p in itertools.permutations(f.coordinates)]
            moves += [{v: a + b - v} for v, a, b, _, _ in f.spans]
        else:
            if f.count > 1:
                lo, hi = f.spans[0][1], f.spans[-1][2]
                move = {f.variables[0]: lo + hi - f.variables[0]}
                last = f.count - 1
                return all_of(self.everywhere(f.functions[s][(k,)] - f.functions[last - s][(len(f.keys) - 1 - k,)].subs(move), "=", None, s)
                              for s in range(f.count) for k in range(len(f.keys)))
            moves = [{v: a + b - v} for v, a, b, _, _ in f.spans]
            if len(f.keys[0]) == 1 and len(f.variables) == 1:
                n = len(functions) - 1
                return all_of(self.everywhere(functions[i] - functions[n - i].subs(moves[0]), "=") for i in range(n + 1))
        places = list(itertools.islice(self.places(shapes=4, points=6), 24))

        def row(x):
            return [self.number(x, p) for p in places]
        rows = [row(x) for x in functions]
        for move in moves:
            for x in functions:
                moved = row(x.subs(move, simultaneous=True))
                if not any(all(u is None or v is None or abs(u - v) < SMALL for u, v in zip(moved, r)) for r in rows):
                    return False
        return True

    def dependent(self, shape):
        f, rows = self.f, []
        for span in range(f.count):
            for place in self.points(12 + 3 * len(f.keys) // f.count, span):
                point = {k: mpmath.mpf(sp.N(sp.sympify(v).subs(shape), 45)) for k, v in place.items()}
                point.update({k: mpmath.mpf(sp.N(v, 45)) for k, v in shape.items()})
                row = [self.number(x, point) for x in self.list(span)]
                if None not in row:
                    rows.append(row)
        # Echelon form with full pivots: the last pivot says whether the rank is full.
        matrix, rank = mpmath.matrix(rows), 0
        m = [list(matrix[i, :]) for i in range(matrix.rows)]
        for _ in range(len(f.keys)):
            best = max(((abs(m[i][j]), i, j) for i in range(rank, len(m)) for j in range(rank, len(f.keys))), default=(0, 0, 0))
            if best[0] < mpmath.mpf(10) ** -18:
                return True
            _, i, j = best
            m[rank], m[i] = m[i], m[rank]
            for r in m:
                r[rank], r[j] = r[j], r[rank]
            for r in range(rank + 1, len(m)):
                q = m[r][rank] / m[rank][rank]
                m[r] = [x - q * y for x, y in zip(m[r], m[rank])]
            rank += 1
        return False

    def independent(self, exceptions):
        fixed = [self.fixed(e) for e in exceptions]
        for swap in fixed:
            for shape in self.shape_values(2, swap):
                if not self.dependent(shape):
                    return False
        for shape in self.shape_values(5):
            if any(all(sp.sympify(shape[k] - v) == 0 for k, v in swap.items()) for swap in fixed):
                continue
            if self.dependent(shape):
                return False
        return True

    def smooth(self, order):
        f, k = self.f, int(self.f.value(order))
        for s in range(f.count - 1):
            v, _, knot, _, _ = f.spans[s]
            for key in f.keys:
                for d in range(k + 1):
                    gap = sp.diff(f.functions[s][key] - f.functions[s + 1][key], v, d).subs(v, knot)
                    if self.everywhere(gap, "=") is False:
                        return False
        return True

    def continuity(self, order):
        f, k, functions = self.f, int(self.f.value(order)), self.list()
        v, a, b, _, _ = f.spans[0]
        for d in range(k + 1):
            ends = [sp.diff(x, v, d) for x in functions]
            left = [x.subs(v, b) for x in ends] + [sp.Integer(0)]
            right = [sp.Integer(0)] + [x.subs(v, a) for x in ends]
            if not all_of(self.everywhere(x - y, "=") for x, y in zip(left, right)):
                return False
        return True

    def totally_positive(self, _):
        f, functions = self.f, self.list()
        for shape in self.shape_values(5):
            for _ in range(8):
                ts = sorted(self.random.sample(range(0, 61), min(len(functions), 7)))
                v, a, b, _, _ = f.spans[0]
                numbers = {k: mpmath.mpf(sp.N(x, 45)) for k, x in shape.items()}
                rows = []
                for t in ts:
                    at = (a + (b - a) * sp.Rational(t, 60)).subs(shape) if hasattr(a, "subs") else t
                    rows.append([self.number(x, {**numbers, v: mpmath.mpf(sp.N(at, 45))}) for x in functions])
                if any(None in row for row in rows):
                    continue
                for size in (1, 2, 3):
                    for r in itertools.combinations(range(len(rows)), size):
                        for c in itertools.combinations(range(len(functions)), size):
                            if determinant([[rows[i][j] for j in c] for i in r]) < -SMALL:
                                return False
        return True

    def at_witness(self, witness, claim):
        """Whether the engine's counterexample contradicts the claim, evaluated here; None where it cannot be read."""
        f = self.f
        point = {}
        for name, value in witness["at"].items():
            try:
                value = sp.Rational(value)
            except (TypeError, ValueError):
                return None
            if (m := re.fullmatch(r"(tanh?|exp)\((.*)\)", name)) is not None:
                argument = sp.sympify(m.group(2).replace("π", "pi"), locals={str(s): s for s in f.variables + f.shapes})
                inverse = {"tan": sp.atan, "tanh": sp.atanh, "exp": sp.log}[m.group(1)](value)
                point.update(sp.solve(argument - inverse, [s for s in argument.free_symbols if s not in point][:1], dict=True)[0])
            else:
                point[symbol(name)] = value
        if claim[0] == "independent":
            return self.dependent({s: point.get(s, v) for s, v in self.shape_values(1)[0].items()})
        nodes = []
        if claim[0] == "compare":
            nodes = [(claim[1], env) for env in f.rounds(claim[2], {})]
        if claim[0] == "at":
            nodes = [(node, env) for outer in f.rounds(claim[3], {}) for node, loops in claim[2] for env in f.rounds(loops, outer)]
            if any(k in point and sp.sympify(point[k] - v) != 0 for k, v in self.fixed(claim[1]).items()):
                return None
        for node, env in nodes:
            parts = node[1]
            for s in range(f.count):
                f.span = s
                for shape in self.shape_values(2, {k: v for k, v in point.items() if k in f.shapes}):
                    full = {k: mpmath.mpf(sp.N(v, 45)) for k, v in {**shape, **point}.items()}
                    if f.coordinates and f.coordinates[-1] not in full:
                        continue
                    values = [listed(f.value(p, env)) for p in parts[::2]]
                    for i, op in enumerate(parts[1::2]):
                        d = zipped(OPERATIONS["-"], values[i], values[i + 1])
                        for x in flat_all(d) if isinstance(d, list) else [d]:
                            try:
                                value = self.number(x, full)
                            except KeyError:
                                continue
                            if value is not None and not NUMERIC[op](value):
                                return True
        return None


def COMPARE_NUMBER(values, ops, point):
    numbers = [v.subs(point, simultaneous=True) for v in values]
    return all(COMPARE[op](sp.N(numbers[i] - numbers[i + 1], 30)) for i, op in enumerate(ops))


def flat_all(x):
    return [z for y in x for z in (flat_all(y) if isinstance(y, list) else [y])]


def determinant(rows):
    if len(rows) == 1:
        return rows[0][0]
    rest = [row[1:] for row in rows]
    return sum((-1) ** i * row[0] * determinant(rest[:i] + rest[i + 1:]) for i, row in enumerate(rows))


def all_of(verdicts):
    result = True
    for v in verdicts:
        if v is False:
            return False
        result = None if v is None else result
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("paths", nargs="+", type=pathlib.Path)
    parser.add_argument("--command", default="basis", help="the command, for its counterexamples")
    parser.add_argument("--orders", type=int, default=2)
    args = parser.parse_args()
    files = sorted(f for p in args.paths for f in ([p] if p.is_file() else p.rglob("*.basis")))
    report = json.loads(subprocess.run([args.command, "check", "--format", "json", *map(str, files)], capture_output=True, text=True).stdout)
    witnesses = {}
    for file in report["files"]:
        for item in file["items"]:
            for claim in item["claims"]:
                if claim["verdict"] == "refuted" and claim["witness"]:
                    key = (file["path"], item["name"], json.dumps(item["order"] or {}), claim["claim"].split(" except ")[0])
                    witnesses.setdefault(key, claim["witness"])
    shelf, counts, contradictions = Shelf(), {"agreed": 0, "not decided": 0, "left out": 0}, []
    for path in files:
        try:
            families, _ = shelf.open(path)
        except Unknown as error:
            contradictions.append(f"{path}: this reader has to learn: {error}")
            print(contradictions[-1])
            continue
        for source in families:
            ranges = []
            for name, low, kind, high in source["orders"]:
                ends = [int(n[1]) if n[0] == "number" else None for n in (low, high)]
                ranges.append([(name, v) for v in range(ends[0], ends[1] + (kind == "..="))][: args.orders])
            for order in map(dict, itertools.product(*ranges)):
                label = f"{path}: {source['name']} {order or ''}".strip()
                try:
                    family = shelf.made(source, order)
                except (Unknown, KeyError, TypeError, AttributeError) as error:
                    print(f"{label}: not read: {error!r}")
                    counts["left out"] += 1
                    continue
                checker = Checker(family, witnesses)
                for statement in source["body"]:
                    if statement[0] != "claim":
                        continue
                    _, declared, claim = statement
                    if declared == "conjecture" or claim[0] == "rounding":
                        counts["left out"] += 1
                        continue
                    try:
                        verdicts = list(checker.judge(claim))
                    except (Unknown, KeyError, TypeError, AttributeError, NotImplementedError, IndexError) as error:
                        print(f"{label}: left out: {describe(claim)}: {error!r}")
                        counts["left out"] += 1
                        continue
                    for verdict in verdicts:
                        if declared == "refute" and verdict is not False:
                            found = None
                            for key, witness in witnesses.items():
                                if key[0] == str(path) and key[1] == source["name"] and json.loads(key[2]) == order:
                                    if claim[0] in ("compare", "at") or key[3] == claim[0]:
                                        try:
                                            found = found or checker.at_witness(witness, claim)
                                        except (KeyError, IndexError, TypeError, AttributeError):
                                            continue
                            verdict = False if found else None
                        wanted = declared == "prove"
                        if verdict is None:
                            counts["not decided"] += 1
                            print(f"{label}: not decided: {declared} {describe(claim)}")
                        elif verdict == wanted:
                            counts["agreed"] += 1
                        else:
                            contradictions.append(f"{label}: {declared} {describe(claim)}")
                            print("CONTRADICTION", contradictions[-1])
    print(", ".join(f"{n} {k}" for k, n in counts.items()), f"- {len(contradictions)} contradictions")
    return 1 if contradictions else 0


def describe(claim):
    return claim[0] if claim[0] not in ("compare", "at") else str(claim)[:160]


if __name__ == "__main__":
    sys.exit(main())

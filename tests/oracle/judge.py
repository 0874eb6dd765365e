#!/usr/bin/env python3
"""Independent judges: random families, theorems and joins, and verdicts of `basis check` on them held against values that
are computed here: `judge.py BASIS [--claims 1000] [--seed N] [--kind product] [--keep DIR]`.

Nothing of the engine is used but its verdicts. A claim that is proved is evaluated at many points, one that is refuted at the
point that the counterexample names. Where the truth is known, by construction or because sympy counts roots or
determines ranks, the verdict has to be that. The seed is printed; with the same seed and number of claims, the same claims
are made. The exit code is 1 if a verdict is wrong. With `--lie`, refuted claims are taken for proved ones, to see how many
false verdicts would be noticed.
"""

import argparse
import json
import random
import re
import subprocess
import sys
import tempfile
import time
from collections import Counter
from fractions import Fraction
from pathlib import Path

import mpmath
import sympy

from angles import replace_ends
from claims import Continuity, Fixed, Independent, Integrated, Smooth, TotallyPositive, claims
from domains import TINY, floats, holds, is_zero
from families import Related, family
from formula import to_float
from theorems import Theorem, judge_theorem

# The tangent of an angle on its way from that at one end of a range to that at the other one.
BETWEEN = (r'\(tan\((\w+)(?:/(\d+))?\) - tan\((\d+)(?:/(\d+))?\)\)'
           r'/\(tan\((\d+)(?:/(\d+))?\) - tan\(\d+(?:/\d+)?\)\)')


def witness_point(own, at):
    """The point of a counterexample: fractions, or floats for irrational coordinates; `None` if it is not understood."""
    env = {}
    for name, text in at.items():
        if re.fullmatch(r'-?\d+(/\d+)?', text):
            value = Fraction(text)
        elif match := re.fullmatch(r'root of (.*) between (\S+) and (\S+)', text):
            bare = match[1].replace(name, 'zz')
            letters = sorted(set(re.findall(r'[A-Za-z]\w*', bare)))
            if len(letters) != 1:
                return None
            x = sympy.Symbol(letters[0])
            p = sympy.Poly(sympy.sympify(bare.replace('^', '**'), rational=True), x)
            low, high = sympy.Rational(match[2]), sympy.Rational(match[3])
            found = [z for z in p.nroots(n=70, maxsteps=500) if abs(sympy.im(z)) < 1e-40]
            wide = sympy.Rational(1, 10**5)
            found = [z for z in found if low - wide <= sympy.re(z) <= high + wide]
            if len(found) != 1:
                return None
            value = mpmath.mpf(str(sympy.re(found[0])))
        else:
            return None
        if match := re.fullmatch(r'(tan|tanh)\((\w+)(?:/(\d+))?\)(?:/\1\((\d+)(?:/(\d+))?\))?', name):
            value, function = to_float(value), mpmath.tan if match[1] == 'tan' else mpmath.tanh
            if match[4]:
                value *= function(mpmath.mpf(int(match[4])) / int(match[5] or 1))
            value = (mpmath.atan if match[1] == 'tan' else mpmath.atanh)(value) * int(match[3] or 1)
            name = match[2]
        elif match := re.fullmatch(BETWEEN, name):
            low, high = (mpmath.tan(mpmath.mpf(int(match[k])) / int(match[k + 1] or 1)) for k in (3, 5))
            value = mpmath.atan(low + to_float(value) * (high - low)) * int(match[2] or 1)
            name = match[1]
        elif match := re.fullmatch(r'tan\(\(?(\w+) - pi(?:/(\d+))?\)?(?:/(\d+))?\)', name):
            value = mpmath.pi / int(match[2] or 1) + mpmath.atan(to_float(value)) * int(match[3] or 1)
            name = match[1]
        elif own.kind == 'turns' and not re.fullmatch(r'\w+', name):
            name, value = 't', along(own.domain['t'], name, to_float(value))
        if value is None or not re.fullmatch(r'\w+(\[\d+\])?', name):
            return None
        env[name] = value
    return env


def along(s, written, value):
    """Where in a range a formula in t, which grows, has a value; `None` where it is not understood."""
    t = sympy.Symbol('t')
    f = sympy.lambdify(t, sympy.sympify(written), 'mpmath')
    low, high = to_float(s.low), to_float(s.high)
    if not f(low) - TINY < value < f(high) + TINY:
        return None
    for _ in range(220):
        middle = (low + high) / 2
        low, high = (low, middle) if f(middle) > value else (middle, high)
    return (low + high) / 2


def judge_claim(own, claim, answer, r):
    """`None`, or what is wrong with a verdict."""
    verdict = answer['verdict']
    if verdict == 'undecided':
        return None
    if claim.truth is not None and claim.truth != (verdict == 'proved'):
        return f'it is {claim.truth}, and said to be {verdict}'
    if isinstance(claim, (Smooth, Continuity, Integrated)):
        return None
    if isinstance(claim, TotallyPositive):
        found = claim.negative(r, 60 if verdict == 'proved' else 2000)
        if verdict == 'proved':
            return found and f'a minor is negative: {found}'
        return None if found else NOT_READ
    if verdict == 'proved':
        if isinstance(claim, Independent):
            for _ in range(6):
                point = own.sample(r)
                shapes = {n: point[n] for n in own.shapes}
                if not claim.full(shapes, r):
                    return f'the functions are dependent at {shapes}'
            return None
        for relation, f, fixed in claim.parts:
            for _ in range(6 if relation == '=' else 40):
                env = own.sample(r)
                env = floats(own, fixed.of(env) if isinstance(fixed, Fixed) else {**env, **fixed})
                if own.kind == 'related' and not own.contains(env):
                    continue
                try:
                    x = f.eval(env)
                except ZeroDivisionError:
                    continue  # in lower terms there is a value; `vanishing` looks for other zeros
                if not holds(relation, x):
                    return f'the value is {x} at {env}'
        return None
    witness = answer.get('witness')
    if not witness:
        return 'it is refuted without a witness'
    env = witness_point(own, witness['at'])
    if env is None:
        return NOT_READ
    for name in list(own.shapes) + list(own.domain):
        if name not in env and own.kind == 'related':
            return NOT_READ
        if name not in env:
            env[name] = (own.shapes.get(name) or own.domain[name]).sample(r)
    if isinstance(claim, Independent):
        shapes = {n: env[n] for n in own.shapes}
        if not all(s.contains(shapes[n]) for n, s in own.shapes.items()):
            return f'the point {shapes} lies outside'
        if any(isinstance(x, mpmath.mpf) for x in shapes.values()):
            return None
        return 'the functions are independent there' if claim.full(shapes, r) else None
    exact = not any(isinstance(x, mpmath.mpf) for x in env.values())
    if exact and not own.contains(env):
        return f'the point {env} lies outside'
    values = []
    for relation, f, fixed in claim.parts:
        if any(n in env and not is_zero(to_float(env[n]) - to_float(x)) for n, x in fixed.items()):
            return f'the point {env} does not have the fixed values'
        for span in own.spans_at(env) if own.kind in ('spans', 'arcs', 'knots') else [None]:
            try:
                values.append((relation, f.eval(floats(own, {**env, 'span': span}))))
            except ZeroDivisionError:
                return NOT_READ  # in lower terms there is a value
    said = witness.get('value')
    for relation, x in values:
        if isinstance(x, mpmath.mpf):
            if relation == '=' and abs(x) > TINY or relation == '>=' and x < -TINY or relation == '>' and x < TINY:
                return None
        elif not holds(relation, x):
            if said is None or not re.fullmatch(r'-?\d+(/\d+)?', said) or abs(Fraction(said)) == abs(x):
                return None
    return f'nothing fails at {env}: {[str(x) for _, x in values]}, said is {said}'


NOT_READ = 'the witness is not understood here'


def subject(r, name, kind=None):
    own = Theorem(r, name) if not kind and r.random() < 0.12 else family(r, name, kind)
    if not isinstance(own, Theorem):
        text = own.text()
        replace_ends(own)
        try:
            own.claims = claims(r, own)
        except ZeroDivisionError:
            own.claims = []
    else:
        text = own.text()
    body = ''.join(f'    prove {c.text}{"" if c.text.endswith("}") else ";"}\n' for c in own.claims)
    own.spec = f'{text}{body}}}\n'
    return own


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('basis')
    parser.add_argument('--claims', type=int, default=1000)
    parser.add_argument('--seed', type=int, default=int(time.time()))
    parser.add_argument('--kind', help='families of one kind only, such as product')
    parser.add_argument('--keep', help='a folder for the specs')
    parser.add_argument('--lie', action='store_true', help='turn every refuted into proved: this has to be noticed')
    options = parser.parse_args()
    print(f'seed {options.seed}', flush=True)
    r = random.Random(options.seed)
    scratch = tempfile.TemporaryDirectory()
    folder = Path(options.keep or scratch.name)
    folder.mkdir(parents=True, exist_ok=True)
    counts, wrong, done = Counter(), 0, 0
    while done < options.claims:
        batch = [subject(r, f'F{k}', options.kind) for k in range(min(40, 1 + (options.claims - done) // 4))]
        paths = []
        for k, own in enumerate(batch):
            path = folder / f'{done}-{k}.basis'
            path.write_text(own.spec, encoding='utf-8')
            paths.append(path)
        said = subprocess.run([options.basis, 'check', '--format', 'json', *paths], capture_output=True, check=False)
        if said.returncode not in (0, 1):
            print(f'basis check ends with {said.returncode}: {said.stderr.decode()[-2000:]}')
            return 1
        files = {f['path']: f for f in json.loads(said.stdout)['files']}
        for path, own in zip(paths, batch):
            file = files[str(path)]
            item = next((i for i in file['items'] if i['name'] == own.name), None)
            if item is None:
                counts['families refused'] += 1
                messages = [d['message'].split('\n')[0] for d in file['diagnostics'] if d['severity'] == 'error']
                counts['of these undecided'] += 'undecided' in ''.join(messages)
                problem = refusal(own, messages, r)
                if problem:
                    wrong += 1
                    print(f'WRONG: {problem}\n{own.spec}')
                continue
            answers = item['claims']
            if getattr(own, 'denominator', None) is not None:
                problem = vanishing(own, r)
                if problem:
                    wrong += 1
                    print(f'WRONG: {problem}\n{own.spec}')
            claims = own.claims
            if len(answers) != len(claims):
                errors = [d['message'] for d in file['diagnostics'] if d['severity'] == 'error']
                messages = [m for m in errors if 'the claim `' not in m]
                # Single claims may be refused; the others are answered.
                if refusal(own, messages, r):
                    wrong += 1
                    print(f'WRONG: {len(answers)} claims instead of {len(claims)}: {messages}\n{own.spec}')
                    continue
                lines = [n for n, line in enumerate(own.spec.split('\n'), 1) if line.lstrip().startswith('prove ')]
                by_line = dict(zip(lines, claims))
                counts['claims refused'] += len(claims) - len(answers)
                claims = [by_line[answer['line']] for answer in answers]
            for claim, answer in zip(claims, answers):
                done += 1
                if options.lie:
                    if answer['verdict'] != 'refuted':
                        continue
                    answer['verdict'] = 'proved'
                counts[f'{own.kind}: {answer["verdict"]}'] += 1
                counts[answer['verdict']] += 1
                counts['truth known'] += claim.truth is not None
                if own.kind == 'theorem':
                    problem = judge_theorem(own, claim, answer)
                else:
                    problem = judge_claim(own, claim, answer, r)
                if problem == NOT_READ:
                    counts['witnesses not read'] += 1
                elif problem:
                    wrong += 1
                    if options.lie:
                        continue
                    print(f'WRONG: `{claim.text}`: {problem}\n  {json.dumps(answer, ensure_ascii=False)}\n{own.spec}')
    for what, n in sorted(counts.items()):
        print(f'{n:8} {what}')
    if options.lie:
        print(f'of {counts["proved"]} false verdicts {wrong} are noticed')
        return 0 if wrong > 0.8 * counts['proved'] else 1
    print(f'{done} claims, {wrong} wrong, seed {options.seed}')
    return 1 if wrong else 0


def vanishing(own, r):
    """The denominators of an accepted family, in lowest terms, have one sign wherever they are looked at; where assumptions
    may leave several parts they are nowhere 0."""
    if isinstance(own, Related) and len(own.conditions) > 1:
        values = [own.denominator.eval(own.sample(r)) for _ in range(60)]
        return None if all(values) else 'a denominator that vanishes is accepted'
    values = [own.denominator.eval(own.sample(r)) for _ in range(60)]
    if all(v > 0 for v in values) or all(v < 0 for v in values):
        return None
    symbols = {n: sympy.Symbol(n) for n in [*own.domain, *own.shapes]}
    for f in own.functions.values():
        below = sympy.fraction(sympy.cancel(f.eval(symbols)))[1]
        values = []
        for _ in range(60):
            at = {symbols[n]: sympy.Rational(str(x)) for n, x in own.sample(r).items()}
            values.append(sympy.sympify(below).subs(at))
        if not (all(v > 0 for v in values) or all(v < 0 for v in values)):
            return 'a denominator that changes its sign is accepted'
    return None


def number(text):
    """A fraction, or an irrational number as `-9/4 + 1/12*sqrt(753)` to many digits."""
    value = sympy.sympify(text, rational=True)
    return Fraction(int(value.p), int(value.q)) if value.is_Rational else mpmath.mpf(str(value.n(60)))


# What a formula may take to expand.
LIMITS = 'too much work|the highest degree|takes more than'


def refusal(own, messages, r):
    """Only a denominator that vanishes, or may, is a reason to refuse a family."""
    if own.kind == 'arcs' and all(re.search(LIMITS, m) for m in messages):
        return None
    if own.kind == 'turns' and all(re.search(f'irrational|{LIMITS}', m) for m in messages):
        return None  # too many numbers of different kinds
    if own.denominator is not None and all(m == 'division by zero' for m in messages):
        values = [own.denominator.eval(own.sample(r)) for _ in range(9)]
        return f'the family is refused: {messages}' if any(values) else None
    if own.denominator is None or not all('denominator' in m for m in messages) or not messages:
        return f'the family is refused: {messages}'
    named = re.search(r'vanishes at ([^:]*)', messages[0])
    if named:
        # Fractions, and irrational numbers with square roots.
        pairs = (pair.split(' = ') for pair in named[1].split(', '))
        env = {n: number(x.strip()) for n, x in pairs if 'root of' not in x}
        if set(env) >= set(own.domain) | set(own.shapes) and not is_zero(own.denominator.eval(env)):
            return f'the denominator does not vanish there: {messages[0]}'
    return None


if __name__ == '__main__':
    sys.exit(main())

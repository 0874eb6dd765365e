//! The steps of families that are evaluated as quotients, span by span: those with denominators, angles or exponentials,
//! with several spans, without an end of their domain, or with shape parameters at the ends.
//!
//! They do what `Chart` and `RationalCurve` of the runtime do: N(s, x)/W(s, x) in
//! coordinates s, x that keep their digits at the ends of a span. What depends on the shape values only and needs more
//! than operations, tangents and the numbers of a chart, is computed once: [`Derived`] values, which are inputs of all
//! other steps, after the shape values.

use super::{Builder, Function, Steps, lower};
use crate::algebra::rational::Rational;
use crate::model::Family;
use crate::model::angle::{Analytic, Angle, Kind};
use crate::plan::denominator::Sign;
use crate::plan::digits::split;
use crate::plan::interval::form::RationalForm;
use crate::plan::interval::rational;
use crate::plan::{Input, Plan};
use basis_prover::collections::list::Listed;

/// Numbers that depend on the shape values and are computed once for them.
#[derive(Clone, Debug)]
pub struct Derived {
    /// What they are called; no two are the same.
    pub names: Vec<String>,
    /// Their values, from the shape values.
    pub steps: Steps,
}

/// A family that is evaluated as quotients.
#[derive(Clone, Debug)]
pub(super) struct Quotients<'a> {
    spans: Vec<Span<'a>>,
    pub(super) derived: Derived,
}

#[derive(Clone, Debug)]
struct Span<'a> {
    /// The functions on the span.
    family: &'a Family,
    form: RationalForm,
    /// The inputs that the plans have after the shape values: where they stand among all.
    tangents: Vec<usize>,
    ends: [Scalar; 2],
    kind: Kind,
    /// Of a kind with angles.
    turn: Option<Turn>,
    /// The Bernstein coefficients of the numerators, one row for each, where these are computed in one place.
    table: Option<Vec<Vec<Scalar>>>,
}

/// A number that is known, or an input.
#[derive(Clone, Debug)]
enum Scalar {
    Known(Rational),
    Input(Input),
}

/// How the angle runs, as `Turn` of the runtime.
#[derive(Clone, Debug)]
struct Turn {
    rate: Rational,
    factors: [Scalar; 2],
    slopes: [Scalar; 3],
    /// `Chart::balance`.
    balance: Scalar,
}

/// What is computed of the tangent x of a shape parameter.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    /// x
    Whole,
    /// 1 − x
    Rest,
    /// 1 + x
    Rise,
}

/// Makes the derived values of all spans.
struct Deriving {
    builder: Builder,
    shapes: usize,
    names: Vec<String>,
    outputs: Vec<usize>,
}

impl Deriving {
    /// A step as a number for other steps.
    fn keep(&mut self, step: usize, name: &str) -> Scalar {
        if let Some(value) = self.builder.constant_at(step) {
            return Scalar::Known(value.clone());
        }
        Scalar::Input(Input::Shape(self.position(step, name)))
    }

    /// The position of a step among shape values and derived values.
    fn position(&mut self, step: usize, name: &str) -> usize {
        if let Some(k) = (0..self.shapes).find(|k| self.builder.input(Input::Shape(*k)) == step) {
            return k;
        }
        let known = self.outputs.iter().position(|output| *output == step);
        let place = known.unwrap_or_else(|| {
            let mut name = String::from(name);
            while self.names.contains(&name) {
                name.push('x');
            }
            self.names.push(name);
            self.outputs.push(step);
            self.outputs.len() - 1
        });
        self.shapes + place
    }

    /// The tangent of a shape parameter, or what is missing from it to 1, or 1 plus it.
    fn tangent(&mut self, family: &Family, angle: &Angle, part: Part) -> usize {
        let shape = family.shapes.iter().position(|p| p.var == angle.var).unwrap_or(0);
        let rate = self.builder.constant(angle.speed());
        let input = self.builder.input(Input::Shape(shape));
        let argument = self.builder.mul(rate, input);
        let name = family.name_of(&family.shapes[shape]);
        if angle.kind == Kind::Circular {
            let tangent = self.builder.call(Function::Tan, argument);
            if part == Part::Rest {
                let rest = self.builder.tan_complement(argument, tangent);
                return self.position(rest, &format!("rest_{name}"));
            }
            return self.position(tangent, &format!("tan_{name}"));
        }
        if part == Part::Whole {
            let tangent = self.builder.call(Function::Tanh, argument);
            return self.position(tangent, &format!("tanh_{name}"));
        }
        // 1 minus the hyperbolic tangent, without the difference; 1 plus it is the same of −x.
        let argument = if part == Part::Rise { self.builder.neg(argument) } else { argument };
        let two = self.builder.integer(2);
        let double = self.builder.mul(two, argument);
        let exponential = self.builder.call(Function::Expm1, double);
        let below = self.builder.add(two, exponential);
        let rest = self.builder.div(two, below);
        self.position(rest, &format!("{}_{name}", if part == Part::Rise { "rise" } else { "rest" }))
    }

    fn span<'a>(&mut self, family: &'a Family, form: RationalForm, number: &str) -> Span<'a> {
        let shapes = self.shapes;
        let analytic = &family.analytic;
        let used = |k: usize| {
            let plans: [Plan; 3] = [
                rational::values(family, &form),
                rational::numerators(family, &form),
                rational::denominator(family, &form),
            ];
            plans.iter().any(|plan| lower(plan).inputs().contains(&Input::Shape(shapes + k)))
        };
        let count = analytic.angles.len();
        let mut tangents = Vec::new();
        for (j, part) in [Part::Whole, Part::Rest, Part::Rise].into_iter().enumerate() {
            for (k, angle) in analytic.angles.iter().enumerate() {
                let place = if used(j * count + k) { self.tangent(family, angle, part) } else { 0 };
                tangents.push(place);
            }
        }
        let low_and_high = [format!("low{number}"), format!("high{number}")];
        let Some(angle) = analytic.angle(form.numerators.var) else {
            let ends = [&form.numerators.low, &form.numerators.high].map(|end| Scalar::Known(end.clone()));
            let table = self.table(family, &form, &tangents, number);
            return Span { family, form, tangents, ends, kind: Kind::Linear, turn: None, table };
        };
        let known = angle.limits.each_ref().map(|end| analytic.number(end));
        let computed = self.builder.inline(&lower(&rational::ends(family, angle)), &|_| None);
        let mut ends = Vec::new();
        for k in 0..2 {
            let step = known[k].clone().map_or(computed[k], |end| self.builder.constant(end));
            ends.push((step, self.keep(step, &low_and_high[k])));
        }
        let steps = [ends[0].0, ends[1].0];
        let ends = [ends[0].1.clone(), ends[1].1.clone()];
        let turn = (angle.kind != Kind::Linear).then(|| self.turn(angle, steps, number));
        let table = self.table(family, &form, &tangents, number);
        Span { family, form, tangents, ends, kind: angle.kind, turn, table }
    }

    /// The table of a span whose values are computed from it.
    fn table(
        &mut self,
        family: &Family,
        form: &RationalForm,
        tangents: &[usize],
        number: &str,
    ) -> Option<Vec<Vec<Scalar>>> {
        if !form.is_tabulated {
            return None;
        }
        let shapes = self.shapes;
        let outputs = &self.outputs;
        let at = |input: Input| match input {
            Input::Shape(k) if k >= shapes => outputs.get(tangents[k - shapes].checked_sub(shapes)?).copied(),
            _ => None,
        };
        let entries = self.builder.inline(&lower(&rational::numerators(family, form)), &at);
        let mut rows = Vec::new();
        for (j, row) in entries.chunks(form.numerators.len().max(1)).enumerate() {
            let row = row.iter().enumerate();
            rows.push(row.map(|(k, entry)| self.keep(*entry, &format!("c{number}_{j}_{k}"))).listed());
        }
        Some(rows)
    }

    /// As `Chart::circular` and `Chart::hyperbolic`.
    fn turn(&mut self, angle: &Angle, ends: [usize; 2], number: &str) -> Turn {
        let rate = angle.speed();
        let b = &mut self.builder;
        let shift = if angle.turns { angle.shift.clone() } else { &angle.shift * &Analytic::pi() };
        let (by, shift) = (b.constant(rate.clone()), b.constant(shift));
        // Only an angle with numbers as ends is measured from elsewhere.
        let turn = ends.map(|end| {
            let from = if b.constant_at(end).is_some() { b.sub(end, shift) } else { end };
            b.mul(by, from)
        });
        let width = b.sub(turn[1], turn[0]);
        let (factors, slopes) = if angle.kind == Kind::Circular {
            let cos = turn.map(|end| b.call(Function::Cos, end));
            let (sin, middle) = (b.call(Function::Sin, width), b.call(Function::Cos, width));
            let scale = b.call(Function::InversePowerOfTwo, sin);
            let factors = cos.map(|cos| b.mul(cos, scale));
            let one = b.integer(1);
            let end = b.div(one, sin);
            (factors, [end, b.div(middle, sin), end])
        } else {
            let [one, two] = [1, 2].map(|n| b.integer(n));
            let below = b.decay(width);
            let below = b.neg(below);
            let ends = turn.map(|end| {
                let decay = b.decay(end);
                b.add(two, decay)
            });
            let scale = b.call(Function::InversePowerOfTwo, below);
            let factors = ends.map(|end| b.mul(end, scale));
            let falls = b.falling(width);
            let [first, last] = ends.map(|end| {
                let part = b.div(end, below);
                b.mul(two, part)
            });
            let (slope, back) = (b.div(last, ends[0]), b.div(first, ends[1]));
            let sum = b.add(one, falls);
            (factors, [slope, b.div(sum, below), b.mul(back, falls)])
        };
        let slopes = slopes.map(|slope| b.mul(slope, by));
        let balance = match angle.kind {
            Kind::Circular => b.div(factors[1], factors[0]),
            _ => b.integer(1),
        };
        let balance = self.keep(balance, &format!("balance{number}"));
        let factors = [0, 1].map(|k| self.keep(factors[k], &format!("factor{number}_{k}")));
        let slopes = [0, 1, 2].map(|k| self.keep(slopes[k], &format!("slope{number}_{k}")));
        Turn { rate, factors, slopes, balance }
    }
}

impl<'a> Quotients<'a> {
    /// Of a family that is evaluated so; `None` for others.
    pub(super) fn new(family: &'a Family) -> Option<Self> {
        let forms = RationalForm::of_family(family)?;
        let shapes = family.shapes.len();
        let mut deriving =
            Deriving { builder: Builder::folding(), shapes, names: Vec::new(), outputs: Vec::new() };
        let mut spans = Vec::new();
        for (k, form) in forms.into_iter().enumerate() {
            let (family, number) = match family.pieces.get(k) {
                Some(piece) => (&**piece, k.to_string()),
                None => (family, String::new()),
            };
            spans.push(deriving.span(family, form, &number));
        }
        let Deriving { builder, names, outputs, .. } = deriving;
        Some(Self { spans, derived: Derived { names, steps: builder.finish(&outputs) } })
    }

    /// The number of spans.
    pub(super) fn len(&self) -> usize {
        self.spans.len()
    }

    /// The ends of all spans in order, each once.
    pub(super) fn knots(&self) -> Steps {
        let mut builder = Builder::default();
        let mut outputs = vec![builder.scalar(&self.spans[0].ends[0])];
        for span in &self.spans {
            outputs.push(builder.scalar(&span.ends[1]));
        }
        builder.finish(&outputs)
    }

    pub(super) fn values(&self, span: usize) -> Steps {
        let span = &self.spans[span];
        let mut builder = Builder::default();
        let pair = (!span.family.analytic.is_empty()).then(|| span.coordinates(&mut builder));
        if span.table.is_some()
            && let Some([s, x]) = pair
        {
            let rows = span.rows(&mut builder);
            let column = |k: usize| rows.iter().map(|row| row[k]).listed();
            let mut outputs =
                (0..span.form.numerators.len()).map(|k| builder.affine_bernstein(&column(k), s, x)).listed();
            for (output, is_nonnegative) in outputs.iter_mut().zip(&span.family.nonnegative) {
                if *is_nonnegative {
                    *output = builder.cut_off(*output);
                }
            }
            return builder.finish(&outputs);
        }
        let outputs = span.inline(&mut builder, &rational::values(span.family, &span.form), pair);
        builder.finish(&outputs)
    }

    /// The Bernstein coefficients of the numerators and of the denominator.
    pub(super) fn tables(&self, span: usize) -> Steps {
        let mut builder = Builder::default();
        let mut outputs = self.spans[span].rows(&mut builder).concat();
        outputs.extend(self.spans[span].weights(&mut builder).unwrap_or_default());
        builder.finish(&outputs)
    }

    /// The Bernstein coefficients of the numerators of a curve, span after span.
    pub(super) fn bind(&self) -> Steps {
        let mut builder = Builder::default();
        let mut outputs = Vec::new();
        for span in &self.spans {
            let points: Vec<usize> =
                (0..span.form.numerators.len()).map(|k| builder.input(Input::Point(k))).collect();
            for row in span.rows(&mut builder) {
                outputs.push(builder.combination(&points, &row));
            }
        }
        builder.finish(&outputs)
    }

    /// The derivatives of all functions of order 1 or 2.
    pub(super) fn derivatives(&self, span: usize, order: usize) -> Steps {
        let span = &self.spans[span];
        let mut builder = Builder::default();
        let mut rows = span.rows(&mut builder);
        let mut weights = span.weights(&mut builder);
        if let Some(powers) = span.powers(&mut builder, rows.len()) {
            for (power, row) in powers.iter().zip(&mut rows) {
                for entry in row {
                    *entry = builder.mul(*entry, *power);
                }
            }
            weights = weights.map(|weights| builder.scaled(&weights, &powers));
        }
        let pair = span.coordinates(&mut builder);
        let place = span.place(&mut builder, pair);
        let slopes = span.slopes(&mut builder, place);
        let mut outputs = Vec::new();
        for k in 0..span.form.numerators.len() {
            let column = rows.iter().map(|row| row[k]).listed();
            let below = weights.as_deref().map(|weights| (weights, &span.form.sign));
            let all = builder.quotient(&column, below, place, slopes, order + 1);
            outputs.push(all[order]);
        }
        builder.finish(&outputs)
    }

    /// The point of a curve and its derivatives, `count` values in all, from what binding gave.
    pub(super) fn curve(&self, span: usize, count: usize) -> Steps {
        let terms = self.spans[0].form.numerators.degree as usize + 1;
        let first = span * terms;
        let span = &self.spans[span];
        let mut builder = Builder::default();
        let bound: Vec<usize> = (first..first + terms).map(|k| builder.input(Input::Bound(k))).collect();
        let weights = span.weights(&mut builder);
        let pair = span.coordinates(&mut builder);
        let [s, x] = pair;
        builder.name(s, "s");
        builder.name(x, "x");
        let above = builder.bernstein(&bound, s, x);
        let point = match &weights {
            Some(weights) => {
                let below = builder.bernstein(weights, s, x);
                let below = builder.kept(below, &span.form.sign);
                builder.name(below, "w");
                builder.div(above, below)
            }
            None => above,
        };
        let mut outputs = vec![point];
        if count > 1 {
            let place = span.place(&mut builder, pair);
            let slopes = span.slopes(&mut builder, place);
            let (mut bound, mut weights) = (bound, weights);
            if let Some(powers) = span.powers(&mut builder, terms) {
                bound = builder.scaled(&bound, &powers);
                weights = weights.map(|weights| builder.scaled(&weights, &powers));
            }
            let below = weights.as_deref().map(|weights| (weights, &span.form.sign));
            let all = builder.quotient(&bound, below, place, slopes, count);
            outputs.extend_from_slice(&all[1..]);
        }
        builder.finish(&outputs)
    }
}

impl Span<'_> {
    /// The outputs of a plan; its coordinates are these two, or else there is the parameter alone.
    fn inline(&self, builder: &mut Builder, plan: &Plan, pair: Option<[usize; 2]>) -> Vec<usize> {
        let shapes = self.family.shapes.len();
        let inputs: Vec<(Input, usize)> = lower(plan)
            .inputs()
            .into_iter()
            .filter_map(|input| match (input, pair) {
                (Input::Coordinate(k), Some(pair)) => Some((input, pair[k])),
                (Input::Shape(k), _) if k >= shapes => {
                    Some((input, builder.input(Input::Shape(self.tangents[k - shapes]))))
                }
                _ => None,
            })
            .collect();
        let at = |input: Input| inputs.iter().find(|(other, _)| *other == input).map(|(_, step)| *step);
        // As the runtime does: of polynomials in the domain variable the coordinates have the sum 1.
        let is_polynomial = !self.form.divides(self.family) && pair.is_some();
        let mut own = if is_polynomial { Builder::of_sums_to_one() } else { Builder::default() };
        let outputs = own.plan(plan);
        builder.inline(&own.finish(&outputs), &at)
    }

    /// The Bernstein coefficients of the numerators, one row for each.
    fn rows(&self, builder: &mut Builder) -> Vec<Vec<usize>> {
        if let Some(table) = &self.table {
            return table.iter().map(|row| row.iter().map(|c| builder.scalar(c)).listed()).listed();
        }
        let entries = self.inline(builder, &rational::numerators(self.family, &self.form), None);
        entries.chunks(self.form.numerators.len().max(1)).map(<[usize]>::to_vec).collect()
    }

    /// The Bernstein coefficients of the denominator; `None` where it is 1.
    fn weights(&self, builder: &mut Builder) -> Option<Vec<usize>> {
        self.form
            .divides(self.family)
            .then(|| self.inline(builder, &rational::denominator(self.family, &self.form), None))
    }

    /// `Chart::coordinates`: `[s, x]` of the parameter.
    fn coordinates(&self, builder: &mut Builder) -> [usize; 2] {
        let t = builder.input(Input::Coordinate(0));
        let ends = self.ends.each_ref().map(|end| builder.scalar(end));
        // Whether a float of any kind has the end exactly.
        let is_exact = |end: &Scalar| match end {
            Scalar::Known(end) => split(end, 24).1.is_zero(),
            Scalar::Input(_) => true,
        };
        let Some(turn) = &self.turn else {
            if self.ends.iter().all(is_exact) {
                return builder.unit(ends, t);
            }
            let width = match &self.ends {
                [Scalar::Known(low), Scalar::Known(high)] => builder.constant(high - low),
                _ => builder.sub(ends[1], ends[0]),
            };
            let [after, before] = self.distances(builder, t);
            return [before, after].map(|distance| builder.div(distance, width));
        };
        let rate = builder.constant(turn.rate.clone());
        let [after, before] = self.distances(builder, t).map(|distance| builder.mul(rate, distance));
        let sines = if self.kind == Kind::Circular {
            [before, after].map(|argument| builder.call(Function::Sin, argument))
        } else {
            // sinh(b) : sinh(a) = 1 − exp(−2b) : exp(2a) − 1, both times a power of two near exp(−2a).
            let [one, two] = [1, 2].map(|n| builder.integer(n));
            let argument = builder.mul(two, after);
            let risen = builder.call(Function::Expm1, argument);
            let decay = builder.decay(before);
            let left = builder.neg(decay);
            let grown = builder.add(one, risen);
            let size = builder.call(Function::InversePowerOfTwo, grown);
            [builder.mul(left, size), builder.mul(risen, size)]
        };
        [0, 1].map(|k| {
            let factor = builder.scalar(&turn.factors[k]);
            builder.mul(sines[k], factor)
        })
    }

    /// t − low and high − t: ends that are numbers in parts. An end is what its float stands for: there the distance is
    /// 0, and what is added to it, which is 0 everywhere, has its derivative.
    fn distances(&self, builder: &mut Builder, t: usize) -> [usize; 2] {
        [0, 1].map(|k| {
            let end = builder.scalar(&self.ends[k]);
            let parts = match &self.ends[k] {
                Scalar::Known(number) => builder.parts(number).to_vec(),
                Scalar::Input(_) => vec![end],
            };
            let difference = |builder: &mut Builder, end: usize| {
                if k == 0 { builder.sub(t, end) } else { builder.sub(end, t) }
            };
            let first = difference(builder, parts[0]);
            let distance = parts[1..].iter().fold(first, |sum, part| {
                if k == 0 { builder.sub(sum, *part) } else { builder.add(sum, *part) }
            });
            if parts[1..].iter().all(|part| builder.constant_at(*part).is_some_and(Rational::is_zero)) {
                return distance;
            }
            let [elsewhere, there] = [distance, difference(builder, end)];
            let [elsewhere, not_there] = [elsewhere, there].map(|step| builder.unless(t, end, step));
            let there = builder.sub(there, not_there);
            builder.add(elsewhere, there)
        })
    }

    /// The powers of `Chart::balance` by which Bernstein coefficients are multiplied for derivatives; `None` where all
    /// are 1.
    fn powers(&self, builder: &mut Builder, count: usize) -> Option<Vec<usize>> {
        let balance = builder.scalar(&self.turn.as_ref()?.balance);
        if builder.constant_at(balance).is_some_and(Rational::is_one) {
            return None;
        }
        let mut powers = vec![builder.integer(1)];
        while powers.len() < count {
            let last = powers[powers.len() - 1];
            powers.push(builder.mul(last, balance));
        }
        Some(powers)
    }

    /// `[1 − y, y]` for the balanced place y of the parameter, from its coordinates.
    fn place(&self, builder: &mut Builder, [s, x]: [usize; 2]) -> [usize; 2] {
        if self.form.is_affine {
            return [s, x];
        }
        let balance = self.turn.as_ref().map(|turn| builder.scalar(&turn.balance));
        let x = match balance.filter(|step| !builder.constant_at(*step).is_some_and(Rational::is_one)) {
            Some(balance) => builder.div(x, balance),
            None => x,
        };
        let sum = builder.add(s, x);
        [s, x].map(|part| builder.div(part, sum))
    }

    /// dy/dt and d²y/dt² at a balanced place; the second is `None` where it is 0.
    fn slopes(&self, builder: &mut Builder, [s, x]: [usize; 2]) -> (usize, Option<usize>) {
        let Some(turn) = &self.turn else {
            let ends = self.ends.each_ref().map(|end| builder.scalar(end));
            return (builder.inverse_width(ends), None);
        };
        // a = q0 s² + 2 q1 s y + q2 y², and its derivative by y.
        let q = turn.slopes.each_ref().map(|slope| builder.scalar(slope));
        let first = builder.bernstein(&q, s, x);
        let by_x = builder.bernstein_derivative(&q, 1, s, x);
        (first, Some(builder.mul(first, by_x)))
    }
}

impl Builder {
    fn scalar(&mut self, scalar: &Scalar) -> usize {
        match scalar {
            Scalar::Known(value) => self.constant(value.clone()),
            Scalar::Input(input) => self.input(*input),
        }
    }

    /// A number as a sum: the nearest float of 24 bits, and with the second part that of 53 bits or more, so that next to
    /// the number the difference of a float and the part before is exact, and what is lost of the next part is as small
    /// beside the distance as u.
    fn parts(&mut self, number: &Rational) -> [usize; 3] {
        let (first, rest) = split(number, 24);
        let (second, third) = split(&rest, 29);
        [first, second, third].map(|part| self.constant(part))
    }

    /// 1 − tan x without the difference, which has no digits near π/4: tan(π/4 − x) (1 + tan x).
    fn tan_complement(&mut self, x: usize, tangent: usize) -> usize {
        let [first, second, third] = self.parts(&(&Analytic::pi() * &Rational::new(1, 4)));
        let rest = self.sub(first, x);
        let rest = self.add(rest, second);
        let rest = self.add(rest, third);
        let rest = self.call(Function::Tan, rest);
        let one = self.integer(1);
        let sum = self.add(one, tangent);
        self.mul(rest, sum)
    }

    /// Coefficients, each times a number.
    fn scaled(&mut self, coefficients: &[usize], powers: &[usize]) -> Vec<usize> {
        coefficients.iter().zip(powers).map(|(c, power)| self.mul(*c, *power)).listed()
    }

    /// As the plan's, of a denominator in Bernstein form.
    fn kept(&mut self, denominator: usize, sign: &Sign) -> usize {
        match sign {
            Sign::Kept | Sign::Unknown => denominator,
            Sign::Positive => self.cut_off(denominator),
            Sign::Negative => {
                let size = self.neg(denominator);
                let size = self.cut_off(size);
                self.neg(size)
            }
        }
    }

    /// exp(−2x) − 1
    fn decay(&mut self, x: usize) -> usize {
        let factor = self.constant(Rational::from(-2));
        let argument = self.mul(x, factor);
        self.call(Function::Expm1, argument)
    }

    /// exp(−2x), with a small relative error: 1/(1 + (exp(2x) − 1)).
    fn falling(&mut self, x: usize) -> usize {
        let [one, two] = [1, 2].map(|n| self.integer(n));
        let argument = self.mul(x, two);
        let exponential = self.call(Function::Expm1, argument);
        let below = self.add(one, exponential);
        self.div(one, below)
    }

    /// N/W and its derivatives in t, at most two, from the Bernstein coefficients in x: with c = N/W,
    /// c' = (N' − c W')/W and c'' = (N'' − 2 c' W' − c W'')/W in x, and the chain rule.
    fn quotient(
        &mut self,
        numerator: &[usize],
        denominator: Option<(&[usize], &Sign)>,
        [s, x]: [usize; 2],
        (slope, curvature): (usize, Option<usize>),
        count: usize,
    ) -> Vec<usize> {
        let n = (0..count).map(|order| self.bernstein_derivative(numerator, order, s, x)).listed();
        let c = match denominator {
            None => n,
            Some((denominator, sign)) => {
                let mut w =
                    (0..count).map(|order| self.bernstein_derivative(denominator, order, s, x)).listed();
                w[0] = self.kept(w[0], sign);
                let mut c = vec![self.div(n[0], w[0])];
                if count > 1 {
                    let known = self.mul(c[0], w[1]);
                    let rest = self.sub(n[1], known);
                    c.push(self.div(rest, w[0]));
                }
                if count > 2 {
                    let two = self.integer(2);
                    let (twice, last) = (self.mul(c[1], w[1]), self.mul(c[0], w[2]));
                    let twice = self.mul(twice, two);
                    let rest = self.sub(n[2], twice);
                    let rest = self.sub(rest, last);
                    c.push(self.div(rest, w[0]));
                }
                c
            }
        };
        let mut results = vec![c[0]];
        if count > 1 {
            results.push(self.mul(c[1], slope));
        }
        if count > 2 {
            let square = self.mul(slope, slope);
            let mut second = self.mul(c[2], square);
            if let Some(curvature) = curvature {
                let rest = self.mul(c[1], curvature);
                second = self.add(second, rest);
            }
            results.push(second);
        }
        results
    }
}

//! The coordinates of a parameter on a span, as `Chart` of the runtime computes them.

use super::derived::{Deriving, Scalar};
use super::{Builder, Function, lower};
use crate::algebra::rational::Rational;
use crate::model::Family;
use crate::model::angle::{Analytic, Angle, Kind};
use crate::plan::Input;
use crate::plan::digits::split;
use crate::plan::interval::form::RationalForm;
use crate::plan::interval::rational::{self, Term};

/// The number of powers of two of which the factor of a shape parameter in an end is made, at most.
const MOST_PARTS: usize = 4;

/// The map from a span to the unit interval.
#[derive(Clone, Debug)]
pub(super) struct Chart {
    pub(super) ends: [Scalar; 2],
    /// The terms of ends that are sums, which floats round: powers of two times shape parameters, which no float rounds.
    sums: Option<[Vec<Term>; 2]>,
    kind: Kind,
    /// Of a kind with angles.
    turn: Option<Turn>,
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

impl Deriving {
    /// The map of a span; `number` tells the names of its numbers from those of other spans.
    pub(super) fn chart(&mut self, family: &Family, form: &RationalForm, number: &str) -> Chart {
        let analytic = &family.analytic;
        let Some(angle) = analytic.angle(form.numerators.var) else {
            let ends = [&form.numerators.low, &form.numerators.high].map(|end| Scalar::Known(end.clone()));
            return Chart { ends, sums: None, kind: Kind::Linear, turn: None };
        };
        let low_and_high = [format!("low{number}"), format!("high{number}")];
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
        Chart { ends, sums: sums(family, angle), kind: angle.kind, turn }
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

/// The terms of the ends of a domain that are sums, with powers of two as factors; `None` where both ends are floats, or
/// there are too many terms.
pub(crate) fn sums(family: &Family, angle: &Angle) -> Option<[Vec<Term>; 2]> {
    let [low, high] = rational::sums(family, angle)?;
    Some([in_powers(&low)?, in_powers(&high)?])
}

fn in_powers(terms: &[Term]) -> Option<Vec<Term>> {
    let mut all = Vec::new();
    for (c, of) in terms {
        let mut left = c.clone();
        for _ in 0..MOST_PARTS {
            if left.is_zero() {
                break;
            }
            let (power, rest) = split(&left, 1);
            all.push((power, *of));
            left = rest;
        }
        if !left.is_zero() {
            return None;
        }
    }
    Some(all)
}

impl Chart {
    /// `Chart::coordinates`: `[s, x]` of the parameter.
    pub(super) fn coordinates(&self, builder: &mut Builder) -> [usize; 2] {
        let t = builder.input(Input::Coordinate(0));
        let ends = self.ends.each_ref().map(|end| builder.scalar(end));
        // Whether a float of any kind has the end exactly.
        let is_exact = |end: &Scalar| match end {
            Scalar::Known(end) => split(end, 24).1.is_zero(),
            Scalar::Input(_) => true,
        };
        let Some(turn) = &self.turn else {
            if self.sums.is_none() && self.ends.iter().all(is_exact) {
                return builder.unit(ends, t);
            }
            let width = match (&self.ends, &self.sums) {
                ([Scalar::Known(low), Scalar::Known(high)], _) => builder.constant(high - low),
                (_, None) => builder.sub(ends[1], ends[0]),
                (_, Some(sums)) => {
                    let tails = [0, 1].map(|k| builder.lost(ends[k], &sums[k]));
                    let (width, rest) = (builder.sub(ends[1], ends[0]), builder.sub(tails[1], tails[0]));
                    builder.add(width, rest)
                }
            };
            return [1, 0].map(|k| {
                let distance = self.distance(builder, t, k);
                let own = builder.div(distance, width);
                let other = builder.scalar(&self.ends[1 - k]);
                if self.sums.is_none() && is_exact(&self.ends[1 - k]) {
                    return own;
                }
                // 1 at the float that stands for the other end: what is missing from there on short spans.
                let one = builder.integer(1);
                let at_other = self.distance_elsewhere(builder, other, k);
                let at_other = builder.div(at_other, width);
                let missing = builder.sub(one, at_other);
                let is_elsewhere = builder.unless(t, other, one);
                let is_there = builder.sub(one, is_elsewhere);
                let added = builder.mul(missing, is_there);
                builder.add(own, added)
            });
        };
        let rate = builder.constant(turn.rate.clone());
        let [after, before] = [0, 1].map(|k| {
            let distance = self.distance(builder, t, k);
            builder.mul(rate, distance)
        });
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

    /// t − low for k = 0, high − t for k = 1. An end is what its float stands for: there the distance is 0, and what is added
    /// to it, which is 0 everywhere, has its derivative.
    fn distance(&self, builder: &mut Builder, t: usize, k: usize) -> usize {
        let distance = self.distance_elsewhere(builder, t, k);
        let end = builder.scalar(&self.ends[k]);
        let there = if k == 0 { builder.sub(t, end) } else { builder.sub(end, t) };
        if distance == there {
            return distance;
        }
        let [elsewhere, not_there] = [distance, there].map(|step| builder.unless(t, end, step));
        let there = builder.sub(there, not_there);
        builder.add(elsewhere, there)
    }

    /// The same where t is not the float of the end: ends that are numbers in parts, sums with what floats lose of them.
    fn distance_elsewhere(&self, builder: &mut Builder, t: usize, k: usize) -> usize {
        let end = builder.scalar(&self.ends[k]);
        let parts = match (&self.ends[k], &self.sums) {
            (_, Some(sums)) => vec![end, builder.lost(end, &sums[k])],
            (Scalar::Known(number), None) => builder.parts(number).to_vec(),
            (Scalar::Input(_), None) => vec![end],
        };
        let (first, others) = (parts[0], &parts[1..]);
        let first = if k == 0 { builder.sub(t, first) } else { builder.sub(first, t) };
        others
            .iter()
            .fold(first, |sum, part| if k == 0 { builder.sub(sum, *part) } else { builder.add(sum, *part) })
    }

    /// The powers of `Chart::balance` by which Bernstein coefficients are multiplied for derivatives; `None` where all
    /// are 1.
    pub(super) fn powers(&self, builder: &mut Builder, count: usize) -> Option<Vec<usize>> {
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
    pub(super) fn place(&self, builder: &mut Builder, [s, x]: [usize; 2]) -> [usize; 2] {
        if self.turn.is_none() {
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
    pub(super) fn slopes(&self, builder: &mut Builder, [s, x]: [usize; 2]) -> (usize, Option<usize>) {
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
    /// Σ terms − end in twice the precision, by the sums of Knuth: what is to be added to an end, which floats round.
    fn lost(&mut self, end: usize, terms: &[Term]) -> usize {
        // A float itself.
        if terms.len() < 2 {
            return self.integer(0);
        }
        let (mut high, mut low) = (self.neg(end), self.integer(0));
        for (power, shape) in terms {
            let power = self.constant(power.clone());
            let term = match shape {
                Some(shape) => {
                    let shape = self.input(Input::Shape(*shape));
                    self.mul(power, shape)
                }
                None => power,
            };
            let sum = self.add(high, term);
            let own = self.sub(sum, high);
            let before = self.sub(sum, own);
            let (error, rest) = (self.sub(high, before), self.sub(term, own));
            let error = self.add(error, rest);
            low = self.add(low, error);
            high = sum;
        }
        self.add(high, low)
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
    pub(super) fn tan_complement(&mut self, x: usize, tangent: usize) -> usize {
        let [first, second, third] = self.parts(&(&Analytic::pi() * &Rational::new(1, 4)));
        let rest = self.sub(first, x);
        let rest = self.add(rest, second);
        let rest = self.add(rest, third);
        let rest = self.call(Function::Tan, rest);
        let one = self.integer(1);
        let sum = self.add(one, tangent);
        self.mul(rest, sum)
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
}

use super::*;
use crate::steps::{Step, Steps};

/// A list of steps that is being written.
#[derive(Default)]
struct Writer(Vec<Step>);

impl Writer {
    fn push(&mut self, step: Step) -> usize {
        if let Some(at) = self.0.iter().position(|s| *s == step) {
            return at;
        }
        self.0.push(step);
        self.0.len() - 1
    }

    fn number(&mut self, n: i64) -> usize {
        self.push(Step::Constant(Rational::from(n)))
    }

    fn product(&mut self, a: usize, b: usize) -> usize {
        if self.0[a] == Step::Constant(Rational::ONE) {
            return b;
        }
        if self.0[b] == Step::Constant(Rational::ONE) {
            return a;
        }
        self.push(Step::Mul(a, b))
    }

    /// Nested in s, as the runtime does it.
    fn bernstein(&mut self, c: &[usize], s: usize, x: usize) -> usize {
        let (mut total, mut power) = (c[0], x);
        for k in 1..c.len() {
            if k > 1 {
                power = self.product(power, x);
            }
            let binomial = crate::algebra::number::binomial(c.len() as u32 - 1, k as u32);
            let binomial = self.push(Step::Constant(binomial));
            let weight = self.product(power, binomial);
            let term = self.product(c[k], weight);
            let first = self.product(total, s);
            total = self.push(Step::Add(first, term));
        }
        total
    }
}

fn quartic() -> Steps {
    let mut w = Writer::default();
    let lambda = w.push(Step::Input(Input::Shape(0)));
    let t = w.push(Step::Input(Input::Coordinate(0)));
    let (one, three) = (w.number(1), w.number(3));
    let (s, x) = (w.push(Step::Sub(one, t)), t);
    let s2 = w.product(s, s);
    let s3 = w.product(s, s2);
    let x2 = w.product(x, x);
    let x3 = w.product(x, x2);
    let c0 = w.push(Step::Sub(one, lambda));
    let c1 = w.push(Step::Add(three, lambda));
    let mut outputs = Vec::new();
    for (c, a, b) in [([one, c0], s3, one), ([c1, three], s2, x), ([three, c1], s, x2), ([c0, one], one, x3)]
    {
        let inner = w.bernstein(&c, s, x);
        let powers = w.product(a, b);
        outputs.push(w.product(inner, powers));
    }
    Steps { steps: w.0, names: Vec::new(), outputs }
}

/// The bounds of the outputs, with one shape parameter in a range and t from 0 to 1.
fn of(steps: &Steps, shape: Range) -> Vec<String> {
    let inputs = Inputs {
        region: Region { ranges: vec![(Var(0), shape), (Var(1), Range::unit())] },
        shapes: vec![Var(0)],
        coordinates: vec![Var(1)],
        of_intervals: vec![Var(1)],
        simplices: Vec::new(),
        points: Vec::new(),
        off: Vec::new(),
    };
    let mut spans = [OnSpan { exact: Exact::new(steps, &inputs).unwrap(), steps, inputs: &inputs }];
    let work = &mut Work::unlimited();
    let bounds = (0..steps.outputs.len()).map(|k| value(&mut spans, k, u64::MAX, work));
    bounds.map(|bound| bound.unwrap().error.to_string()).collect()
}

#[test]
fn bounds_of_the_quartic_family_are_those_of_an_independent_program() {
    let bounds = of(&quartic(), Range::closed(Rational::from(-3), Rational::ONE));
    // 44/5, 9, 7 and 7 u, and what is of second order.
    assert_eq!(bounds, [4.41, 4.51, 3.51, 3.51].map(|bound| format!("{bound} ε of the value")));
}

//! Random claims: every verdict must check out, and the steps of the cascade must agree with each other.

use super::*;
use crate::algebra::range::{End, Range};

/// A small deterministic generator (Knuth's MMIX constants).
struct Random(u64);

impl Random {
    fn next(&mut self, below: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % below
    }
    fn between(&mut self, low: i64, high: i64) -> i64 {
        low + self.next((high - low + 1) as u64) as i64
    }
    fn rational(&mut self) -> Rational {
        Rational::new(self.between(-6, 6), self.between(1, 3))
    }
    fn poly(&mut self, variables: usize, degree: u16, terms: u64) -> Poly {
        let mut p = Poly::zero();
        for _ in 0..=self.next(terms) {
            let exponents = (0..variables).map(|_| self.next(u64::from(degree) + 1) as u16).collect();
            p.add_term(crate::algebra::poly::Monomial::new(exponents), &self.rational());
        }
        p
    }
    fn range(&mut self) -> Range {
        let mut ends = [self.rational(), self.rational()];
        ends.sort();
        let [a, b] = ends;
        let b = if a == b { &b + &Rational::ONE } else { b };
        let mut end = |x: Rational| match self.next(8) {
            0 => End::Infinite,
            1 | 2 => End::Excluded(x),
            _ => End::Included(x),
        };
        Range { low: end(a), high: end(b) }
    }
    fn region(&mut self, variables: usize) -> Region {
        Region { ranges: (0..variables).map(|k| (Var(k), self.range())).collect() }
    }
    /// A number of a range.
    fn number(&mut self, range: &Range) -> Rational {
        let parts = 7;
        let k = self.between(1, parts - 1);
        match (range.low.value(), range.high.value()) {
            (Some(a), Some(b)) => a + &(&(b - a) * &Rational::new(k, parts)),
            (Some(a), None) => a + &Rational::new(k * k, 3),
            (None, Some(b)) => b - &Rational::new(k * k, 3),
            (None, None) => self.rational(),
        }
    }
}

/// A claim of one of several kinds, many of them nearly false or nearly true.
fn claim(random: &mut Random) -> (Poly, Relation, Region) {
    let variables = if random.next(6) == 0 { 3 } else { 1 + random.next(2) as usize };
    let degree = if variables == 3 { 1 } else { 2 };
    let region = random.region(variables);
    let p = match random.next(7) {
        0 => random.poly(variables, degree, 6),
        1 => random.poly(variables, degree, 4).pow(2),
        2 => &random.poly(variables, degree, 3).pow(2) + &random.poly(variables, degree, 3).pow(2),
        3 => {
            let shift = Poly::constant(Rational::new(random.between(-2, 2), 1000));
            &random.poly(variables, degree, 3).pow(2) + &shift
        }
        4 => &random.poly(variables, 1, 3) * &random.poly(variables, degree, 3),
        5 => {
            // A sum of squares that vanish at a point of the region.
            let mut p = Poly::zero();
            for (v, range) in &region.ranges {
                let linear = &Poly::var(*v) - &Poly::constant(random.number(range));
                p = &p + &(&linear * &random.poly(variables, 1, 2)).pow(2);
                p = &p + &linear.pow(2);
            }
            p
        }
        _ => {
            // Products with the distances to the ends.
            let mut p = random.poly(variables, 1, 3).pow(2);
            for (v, range) in &region.ranges {
                if let Some(a) = range.low.value() {
                    p = &p * &(&Poly::var(*v) - &Poly::constant(a.clone()));
                }
            }
            p
        }
    };
    let relation = if random.next(2) == 0 { Relation::NonNegative } else { Relation::Positive };
    (p, relation, region)
}

/// Checks whatever a decision says; whether it is proved or refuted.
fn checked(p: &Poly, relation: Relation, region: &Region, budget: &mut Budget) -> Option<bool> {
    match decide(p, relation, region, budget) {
        Decision::Proved(proof) => {
            assert_eq!(
                verify(p, relation, region, &proof.certificate).err(),
                None,
                "{p:?} {region:?} {proof:?}"
            );
            Some(true)
        }
        Decision::Refuted(witness) => {
            check_witness(p, relation, region, &witness);
            Some(false)
        }
        Decision::Undecided(_) => None,
    }
}

#[test]
fn steps_agree_and_verdicts_check_out() {
    let counts = run(1, 120);
    assert!(counts[0] > 40 && counts[1] > 40 && counts[2] < 4, "{counts:?}");
}

#[test]
#[ignore = "minutes in an unoptimised build"]
fn steps_agree_and_verdicts_check_out_many_times() {
    let counts = run(2, 3000);
    assert!(counts[0] > 1000 && counts[1] > 1000 && counts[2] < 100, "{counts:?}");
}

/// Checks random claims; how many are proved, refuted and undecided.
fn run(seed: u64, rounds: usize) -> [usize; 3] {
    let mut random = Random(seed);
    let mut counts = [0; 3];
    for round in 0..rounds {
        let (p, relation, region) = claim(&mut random);
        let all = checked(&p, relation, &region, &mut Budget::default().take(1_000_000));
        counts[match all {
            Some(true) => 0,
            Some(false) => 1,
            None => 2,
        }] += 1;
        let left_out: &[&[Method]] = &[
            &[Method::Coefficients],
            &[Method::Coefficients, Method::Corners, Method::Subdivision],
            &[Method::Coefficients, Method::Corners, Method::Subdivision, Method::Factors],
            &[Method::Cells],
        ];
        for methods in left_out {
            let mut budget = methods.iter().fold(Budget::default(), |b, m| b.without(*m)).take(100_000);
            let some = checked(&p, relation, &region, &mut budget);
            if let (Some(a), Some(b)) = (all, some) {
                assert_eq!(a, b, "round {round}: {p:?} {relation:?} {region:?} without {methods:?}");
            }
        }
        if all == Some(true) {
            for _ in 0..20 {
                let point: Vec<Rational> = region.ranges.iter().map(|(_, r)| random.number(r)).collect();
                if region.ranges.iter().zip(&point).all(|((_, r), x)| r.contains(x)) {
                    assert!(relation.holds(&p.eval(&point)));
                }
            }
        }
    }
    counts
}

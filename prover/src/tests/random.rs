//! Random claims: every verdict must check out, and the steps of the cascade must agree with each other.

use basis_test_support::Random;

use super::*;
use crate::algebra::poly::PolyExt;

/// Exact numbers, polynomials and ranges from a generator.
trait Exact {
    fn rational(&mut self) -> Rational;
    fn poly(&mut self, variables: usize, degree: u16, terms: usize) -> Poly;
    fn range(&mut self) -> Range;
    fn region(&mut self, variables: usize) -> Region;
    /// A number of a range.
    fn number(&mut self, range: &Range) -> Rational;
}

impl Exact for Random {
    fn rational(&mut self) -> Rational {
        Rational::new(self.between(-6, 6), self.between(1, 3))
    }
    fn poly(&mut self, variables: usize, degree: u16, terms: usize) -> Poly {
        let mut p = Poly::zero();
        for _ in 0..=self.below(terms) {
            let exponents = (0..variables).map(|_| self.below(usize::from(degree) + 1) as u16).collect();
            p = &p + &Poly::term(crate::algebra::poly::Monomial::new(exponents), self.rational());
        }
        p
    }
    fn range(&mut self) -> Range {
        let mut ends = [self.rational(), self.rational()];
        ends.sort();
        let [a, b] = ends;
        let b = if a == b { &b + &Rational::ONE } else { b };
        let mut end = |x: Rational| match self.below(8) {
            0 => End::Infinite,
            1 | 2 => End::Excluded(x),
            _ => End::Included(x),
        };
        Range { low: end(a), high: end(b) }
    }
    fn region(&mut self, variables: usize) -> Region {
        Region { ranges: (0..variables).map(|k| (Var(k), self.range())).collect() }
    }
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
    let variables = if random.below(6) == 0 { 3 } else { 1 + random.below(2) };
    let degree = if variables == 3 { 1 } else { 2 };
    let region = random.region(variables);
    let p = match random.below(7) {
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
    let relation = if random.below(2) == 0 { Relation::NonNegative } else { Relation::Positive };
    (p, relation, region)
}

/// Whether a claim is proved or refuted; the kernel checks either.
fn checked(p: &Poly, relation: Relation, region: &Region, budget: &mut Budget) -> Option<bool> {
    match accepted(p, relation, region, budget) {
        Ok(_) => Some(true),
        Err(found) => found.map(|_| false),
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
    let mut random = Random::new(seed);
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

/// Up to three rows of small polynomials; often they are dependent somewhere, sometimes everywhere.
fn table(random: &mut Random, parameters: usize) -> Vec<Vec<Poly>> {
    let height = 1 + random.below(3);
    let width = height + random.below(2);
    let entry = |random: &mut Random| match random.below(3) {
        0 => Poly::constant(random.rational()),
        _ => random.poly(parameters, 1, 2),
    };
    let mut rows: Vec<Vec<Poly>> = (0..height).map(|_| (0..width).map(|_| entry(random)).collect()).collect();
    if random.below(2) == 0 && height > 1 {
        // The last row is a multiple of the first wherever a polynomial vanishes.
        let (zero, factor) = (random.poly(parameters, 2, 2), random.rational());
        rows[height - 1] =
            (0..width).map(|k| &rows[0][k].scale(&factor) + &(&zero * &rows[height - 1][k])).collect();
    }
    rows
}

/// The rank by elimination.
fn rank(mut rows: Vec<Vec<Rational>>) -> usize {
    let mut rank = 0;
    for column in 0..rows.first().map_or(0, Vec::len) {
        let Some(pivot) = (rank..rows.len()).find(|r| !rows[*r][column].is_zero()) else { continue };
        rows.swap(rank, pivot);
        let (done, rest) = rows.split_at_mut(rank + 1);
        for row in rest {
            let factor = &row[column] / &done[rank][column];
            for (x, p) in row.iter_mut().zip(&done[rank]) {
                *x -= &(p * &factor);
            }
        }
        rank += 1;
    }
    rank
}

/// Points of a region: random ones and corners that belong to it.
fn points(random: &mut Random, region: &Region) -> Vec<Vec<Rational>> {
    let mut all = Vec::new();
    for k in 0..20 {
        let number = |(_, r): &(Var, Range), random: &mut Random| {
            let end = [&r.low, &r.high][random.below(2)].value().filter(|x| r.contains(x));
            end.filter(|_| k % 2 == 0).cloned().unwrap_or_else(|| random.number(r))
        };
        all.push(region.ranges.iter().map(|r| number(r, random)).collect());
    }
    all.retain(|p: &Vec<Rational>| region.ranges.iter().zip(p).all(|((_, r), x)| r.contains(x)));
    all
}

#[test]
fn independence_agrees_with_ranks_at_points() {
    let mut random = Random::new(7);
    let mut counts = [0; 3];
    for round in 0..150 {
        let parameters = 1 + random.below(2);
        let region = random.region(parameters);
        let rows = table(&mut random, parameters);
        let at = |point: &[Rational]| -> Vec<Vec<Rational>> {
            rows.iter().map(|row| row.iter().map(|p| p.eval(point)).collect()).collect()
        };
        let statement =
            Statement::Independent { rows: rows.clone(), except: Vec::new(), region: region.clone() };
        match decide(statement, &Vec::new(), 1) {
            Ok(_) => {
                counts[0] += 1;
                for point in points(&mut random, &region) {
                    assert_eq!(rank(at(&point)), rows.len(), "round {round}: {rows:?} at {point:?}");
                }
            }
            Err(Failure::Refuted(found)) => {
                counts[1] += 1;
                let exact = |(_, c): &(Var, Coordinate)| match c {
                    Coordinate::Rational(x) => Some(x.clone()),
                    Coordinate::Algebraic(_) => None,
                };
                let Some(point) = found.point.iter().map(exact).collect::<Option<Vec<_>>>() else { continue };
                assert!(region.ranges.iter().zip(&point).all(|((_, r), x)| r.contains(x)));
                assert!(rank(at(&point)) < rows.len(), "round {round}: {rows:?} at {point:?}");
            }
            Err(Failure::Undecided(_)) => counts[2] += 1,
        }
    }
    assert!(counts[0] > 40 && counts[1] > 40 && counts[2] < 8, "{counts:?}");
}

#[test]
fn joint_exceptions_are_proved_by_certificates_that_are_accepted() {
    // Dependent at a joint value of the parameters, for which exceptions name both; the entries vanish in many ways.
    let mut random = Random::new(11);
    let mut proved = 0;
    for round in 0..150 {
        let (x, y) = (Poly::var(Var(0)), Poly::var(Var(1)));
        let (a, b) = (random.rational(), random.rational());
        let (p, q) = (&x - &Poly::constant(a.clone()), &y - &Poly::constant(b.clone()));
        let small = |random: &mut Random| Poly::constant(Rational::from(random.between(-2, 2)));
        let mut rows = vec![
            vec![&p * &small(&mut random), &q * &small(&mut random), &p + &q],
            vec![small(&mut random), small(&mut random), Poly::zero()],
        ];
        rows.swap(0, random.below(2));
        let except = vec![vec![(Var(0), a), (Var(1), b)]];
        let ranges = vec![(Var(0), Range::all()), (Var(1), Range::all())];
        let statement = Statement::Independent { rows: rows.clone(), except, region: Region { ranges } };
        match decide(statement, &Vec::new(), 1) {
            Ok(_) => proved += 1,
            Err(Failure::Refuted(_)) => {}
            Err(Failure::Undecided(left)) => panic!("round {round}: {rows:?}: {left}"),
        }
    }
    assert!(proved > 10, "{proved}");
}

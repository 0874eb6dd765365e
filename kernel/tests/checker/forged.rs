//! Forged certificates: random changes of real ones, and random ones, for statements that are false by construction, and
//! random witnesses against statements that are true. None of them may be accepted.
//!
//! A million from a fresh seed, or from the one in `SEED`:
//! `cargo test --release -p basis-kernel --test checker -- --ignored --nocapture a_million`.

use std::rc::Rc;

use basis_kernel::algebra::poly::{Monomial, Poly, Var};
use basis_kernel::algebra::range::{End, Range, Region};
use basis_kernel::algebra::rational::Rational;
use basis_kernel::algebra::univariate::Univariate;
use basis_kernel::algebra::work::Work;
use basis_kernel::{
    Cells, Certificate, ChangeOfBasis, Cuts, Domain, FactorSign, Minors, Piece, Point, Proof, Quotient, Rank,
    Refutation, Relation, Root, Sample, Section, SignProof, Signed, Statement, Witness, text,
};
use basis_test_support::Random;

use crate::signs::{CASES, Case, IRRATIONAL};
use crate::text::sign;

/// How many are offered of each kind.
const TRIES: usize = 30_000;
const SEED: u64 = 20_261_122;

/// Exact numbers, polynomials and ranges from a generator.
trait Exact {
    fn number(&mut self) -> Rational;
    fn poly(&mut self, variables: usize) -> Poly;
    fn around(&mut self, x: &Rational) -> Range;
}

impl Exact for Random {
    fn number(&mut self) -> Rational {
        Rational::new(self.below(13) as i64 - 6, 1 + self.below(3) as i64)
    }
    fn poly(&mut self, variables: usize) -> Poly {
        let mut p = Poly::constant(self.number());
        for _ in 0..=self.below(4) {
            let exponents = (0..variables).map(|_| self.below(3) as u16).collect();
            p = &p + &Poly::term(Monomial::new(exponents), self.number());
        }
        p
    }
    /// A range that contains a number.
    fn around(&mut self, x: &Rational) -> Range {
        let mut end = |step: i64| match self.below(5) {
            0 => End::Infinite,
            1 => End::Included(x.clone()),
            2 => End::Included(x + &Rational::from(step)),
            _ => End::Excluded(x + &Rational::new(step, 1 + self.below(3) as i64)),
        };
        Range { low: end(-1), high: end(1) }
    }
}

/// A statement that is false at a point: p ≥ 0 with a negative value, or p > 0 with the value 0.
fn lowered(p: &Poly, point: &[Rational], domain: &Domain, random: &mut Random) -> Statement {
    let (below, relation) = match random.below(4) {
        0 => (Rational::ZERO, Relation::Positive),
        1 => (Rational::ONE, Relation::Positive),
        2 => (Rational::ONE, Relation::NonNegative),
        _ => (Rational::new(1, 10).pow(30), Relation::NonNegative),
    };
    let value = &crate::value(p, point) + &below;
    let value = Quotient::from(p - &Poly::constant(value));
    Statement::Sign { value, relation, domain: Rc::new(domain.clone()) }
}

/// Polynomials to put into certificates: some that fit to a statement, and some that do not.
fn ingredients(p: &Poly, random: &mut Random) -> Vec<Poly> {
    let mut all = vec![p.clone(), p.normalized(), random.poly(2)];
    for var in p.variables() {
        all.extend([p.derivative(var), p.at(var, &random.number()), Poly::var(var)]);
        all.push(&Poly::var(var) - &Poly::constant(random.number()));
    }
    all.retain(|p| p.as_constant().is_none());
    all
}

/// Random changes of a proof.
struct Forger<'r> {
    random: &'r mut Random,
    polys: Vec<Poly>,
}

impl Forger<'_> {
    fn poly(&mut self) -> Poly {
        self.polys[self.random.below(self.polys.len())].clone()
    }

    fn rarely(&mut self) -> bool {
        self.random.below(8) == 0
    }

    fn fresh(&mut self, depth: usize) -> SignProof {
        let boxed = |f: &mut Self| Box::new(f.fresh(depth + 1));
        match self.random.below(if depth > 3 { 2 } else { 8 }) {
            0 | 1 => SignProof::Cuts(self.cuts(0)),
            2 => SignProof::Corners {
                var: Var(self.random.below(2)),
                low: boxed(self),
                high: boxed(self),
                middle: (self.random.below(2) == 0).then(|| (self.random.number(), boxed(self))),
            },
            3 => {
                let sign = match self.random.below(2) {
                    0 => FactorSign::Any,
                    _ => FactorSign::Known(Box::new(self.signed(depth))),
                };
                SignProof::Factors { factors: vec![(self.poly(), sign)], rest: Box::new(self.signed(depth)) }
            }
            4 => SignProof::Squares {
                squares: (0..self.random.below(3)).map(|_| (self.random.number(), self.poly())).collect(),
                rest: boxed(self),
            },
            5 | 6 => SignProof::Faces((0..=self.random.below(9)).map(|_| self.fresh(depth + 1)).collect()),
            _ => {
                let level = |f: &mut Self| (0..f.random.below(4)).map(|_| f.poly()).collect();
                let levels = vec![level(self), level(self)];
                let above = |f: &mut Self| Sample { value: f.random.number(), above: Vec::new() };
                let samples = (0..=self.random.below(3))
                    .map(|_| Sample { value: self.random.number(), above: vec![above(self)] })
                    .collect();
                SignProof::Cells(Cells { order: vec![Var(0), Var(1)], levels, samples })
            }
        }
    }

    fn signed(&mut self, depth: usize) -> Signed {
        let proof = self.fresh(depth + 1);
        if self.random.below(2) == 0 { Signed::Positive(proof) } else { Signed::Negative(proof) }
    }

    fn cuts(&mut self, depth: usize) -> Cuts {
        if depth > 3 || self.random.below(2) == 0 {
            return Cuts::None;
        }
        let (low, high) = (Box::new(self.cuts(depth + 1)), Box::new(self.cuts(depth + 1)));
        Cuts::At { var: Var(self.random.below(2)), low, high }
    }

    fn list<T: Clone>(&mut self, list: &mut Vec<T>) {
        if list.is_empty() || !self.rarely() {
            return;
        }
        let k = self.random.below(list.len());
        match self.random.below(3) {
            0 => drop(list.remove(k)),
            1 => list.push(list[k].clone()),
            _ => list.swap(0, k),
        }
    }

    fn number(&mut self, x: &mut Rational) {
        if self.rarely() {
            *x = match self.random.below(3) {
                0 => self.random.number(),
                1 => &*x + &Rational::new(1, 1000),
                _ => -&*x,
            };
        }
    }

    fn levels(&mut self, levels: &mut [Vec<Poly>], order: &mut Vec<Var>) {
        self.list(order);
        for level in levels {
            self.list(level);
            for p in level.iter_mut() {
                if self.rarely() {
                    *p = self.poly();
                }
            }
            if self.rarely() {
                level.push(self.poly());
            }
        }
    }

    fn samples(&mut self, samples: &mut Vec<Sample>) {
        self.list(samples);
        for sample in samples {
            self.number(&mut sample.value);
            self.samples(&mut sample.above);
        }
    }

    fn change_signed(&mut self, signed: &mut Signed) {
        let (Signed::Positive(proof) | Signed::Negative(proof)) = signed;
        self.change(proof);
        if self.rarely() {
            let proof = proof.clone();
            *signed = match signed {
                Signed::Positive(_) => Signed::Negative(proof),
                Signed::Negative(_) => Signed::Positive(proof),
            };
        }
    }

    fn change(&mut self, proof: &mut SignProof) {
        if self.random.below(20) == 0 {
            *proof = self.fresh(1);
            return;
        }
        match proof {
            SignProof::Cuts(cuts) => {
                if self.rarely() {
                    *cuts = self.cuts(0);
                }
            }
            SignProof::Corners { low, high, middle, .. } => {
                self.change(low);
                self.change(high);
                if let Some((x, proof)) = middle {
                    self.number(x);
                    self.change(proof);
                }
                if self.rarely() {
                    *middle = None;
                }
            }
            SignProof::Factors { factors, rest } => {
                self.list(factors);
                for (base, sign) in factors {
                    if self.rarely() {
                        *base = self.poly();
                    }
                    if let FactorSign::Known(signed) = sign {
                        self.change_signed(signed);
                    }
                }
                self.change_signed(rest);
            }
            SignProof::Squares { squares, rest } => {
                self.list(squares);
                for (factor, base) in squares {
                    self.number(factor);
                    if self.rarely() {
                        *base = self.poly();
                    }
                }
                self.change(rest);
            }
            SignProof::Faces(faces) => {
                self.list(faces);
                for face in faces {
                    self.change(face);
                }
            }
            SignProof::Cells(cells) => {
                self.levels(&mut cells.levels, &mut cells.order);
                self.samples(&mut cells.samples);
            }
            SignProof::Slices(slices) => {
                self.list(&mut slices.bases);
                for base in &mut slices.bases {
                    self.levels(&mut base.levels, &mut base.order);
                    self.list(&mut base.sections);
                    self.list(&mut base.sectors);
                    for section in &mut base.sections {
                        match section {
                            Section::Exact(x, proof) => {
                                self.number(x);
                                self.change(proof);
                            }
                            Section::Between(a, b) => {
                                self.number(a);
                                self.number(b);
                            }
                        }
                    }
                    for (x, proof) in &mut base.sectors {
                        self.number(x);
                        self.change(proof);
                    }
                }
                self.list(&mut slices.boxes);
                for (a, b) in slices.boxes.iter_mut().flatten() {
                    self.number(a);
                    self.number(b);
                }
            }
        }
    }
}

/// The work for one forgery: enough for the real certificates.
const WORK: u64 = 20_000;

fn accepted(statement: &Rc<Statement>, certificate: Certificate) -> bool {
    Proof::new(Rc::clone(statement), certificate, &mut Work::new(WORK)).is_ok()
}

#[test]
fn changed_certificates_do_not_prove_what_is_false() {
    changed(SEED, TRIES);
}

fn changed(seed: u64, most: usize) {
    let random = &mut Random::new(seed);
    let mut tries = 0;
    let own =
        |c: &Case| accepted(&sign(c.claim, c.on), text::certificate(c.certificate).expect("a certificate"));
    let mut cases: Vec<&Case> = CASES.iter().chain([&IRRATIONAL]).collect();
    cases.retain(|c| !c.point.is_empty() && !c.claim.contains("//") && own(c));
    assert_eq!(cases.len(), 10);
    while tries < most {
        for case in &cases {
            let Statement::Sign { value, domain, .. } = &*sign(case.claim, case.on) else { continue };
            let point: Vec<Rational> = case.point.iter().map(|(n, d)| Rational::new(*n, *d)).collect();
            let real = match text::certificate(case.certificate) {
                Ok(Certificate::Sign { numerator, .. }) => numerator,
                _ => SignProof::direct(),
            };
            let statement = Rc::new(lowered(&value.numerator, &point, domain, random));
            let Statement::Sign { value, .. } = &*statement else { continue };
            let polys = ingredients(&value.numerator, random);
            for _ in 0..40 {
                let mut proof = real.clone();
                Forger { random, polys: polys.clone() }.change(&mut proof);
                // What is made of p takes part with the p that is claimed.
                let own = if random.below(2) == 0 { proof } else { renewed(proof, value) };
                let certificate = Certificate::Sign { denominator: None, numerator: own };
                tries += 1;
                assert!(
                    !accepted(&statement, certificate.clone()),
                    "seed {seed}, try {tries}: {statement:?} by {}",
                    text::certificate_text(&certificate)
                );
            }
        }
    }
}

/// With the claimed polynomial on the highest level of a decomposition.
fn renewed(mut proof: SignProof, value: &Quotient) -> SignProof {
    let highest = match &mut proof {
        SignProof::Cells(cells) => cells.levels.last_mut(),
        SignProof::Slices(slices) => slices.bases.first_mut().and_then(|b| b.levels.last_mut()),
        _ => None,
    };
    if let Some(level) = highest {
        *level = vec![value.numerator.clone()];
    }
    proof
}

#[test]
fn random_certificates_do_not_prove_what_is_false() {
    from_nothing(SEED + 1, TRIES);
}

fn from_nothing(seed: u64, most: usize) {
    let random = &mut Random::new(seed);
    let mut tries = 0;
    while tries < most {
        let variables = 1 + random.below(2);
        let point: Vec<Rational> = (0..variables).map(|_| random.number()).collect();
        let ranges = point.iter().enumerate().map(|(k, x)| (Var(k), random.around(x))).collect();
        let domain = Domain::of(Region { ranges });
        // Mostly what is nearly true: squares that vanish at the point.
        let p = match random.below(3) {
            0 => random.poly(variables),
            1 => random.poly(variables).pow(2),
            _ => point.iter().enumerate().fold(Poly::zero(), |p, (k, x)| {
                &p + &(&(&Poly::var(Var(k)) - &Poly::constant(x.clone())) * &random.poly(1)).pow(2)
            }),
        };
        let inside = domain.region.ranges.iter().zip(&point).all(|((_, r), x)| r.contains(x));
        if !inside {
            continue;
        }
        let statement = Rc::new(lowered(&p, &point, &domain, random));
        let Statement::Sign { value, .. } = &*statement else { continue };
        let polys = ingredients(&value.numerator, random);
        if polys.is_empty() {
            continue;
        }
        for _ in 0..20 {
            let numerator = Forger { random, polys: polys.clone() }.fresh(0);
            let certificate = Certificate::Sign { denominator: None, numerator };
            tries += 1;
            assert!(
                !accepted(&statement, certificate.clone()),
                "seed {seed}, try {tries}: {statement:?} by {}",
                text::certificate_text(&certificate)
            );
        }
    }
}

/// Rows that are dependent at a point of their box.
fn dependent(random: &mut Random) -> Statement {
    let variables = 1 + random.below(2);
    let point: Vec<Rational> = (0..variables).map(|_| random.number()).collect();
    let mut ranges: Vec<(Var, Range)> =
        point.iter().enumerate().map(|(k, x)| (Var(k), random.around(x))).collect();
    for ((_, range), x) in ranges.iter_mut().zip(&point) {
        if !range.contains(x) {
            *range = Range::all();
        }
    }
    let (height, width) = (1 + random.below(3), 1 + random.below(3));
    let entry = |random: &mut Random| {
        if random.below(3) == 0 { Poly::constant(random.number()) } else { random.poly(variables) }
    };
    let mut rows: Vec<Vec<Poly>> = (0..height).map(|_| (0..width).map(|_| entry(random)).collect()).collect();
    let factors: Vec<Rational> = (0..height - 1).map(|_| random.number()).collect();
    for column in 0..width {
        let mut sum = Rational::ZERO;
        for (factor, row) in factors.iter().zip(&rows) {
            sum = &sum + &(factor * &crate::value(&row[column], &point));
        }
        let last = &mut rows[height - 1][column];
        *last = &*last - &Poly::constant(&crate::value(last, &point) - &sum);
    }
    // An exception beside the point.
    let beside = (Var(0), &point[0] + &Rational::ONE);
    let except = if random.below(4) == 0 { vec![vec![beside]] } else { Vec::new() };
    Statement::Independent { rows, except, region: Region { ranges } }
}

/// A sum of dot products that is negative for some points.
fn negative_somewhere(random: &mut Random) -> Statement {
    let places = [(0, 0), (0, 1), (1, 1), (0, 2), (2, 2)];
    let count = 1 + random.below(places.len());
    let products: Vec<(Var, (usize, usize))> =
        places[..count].iter().enumerate().map(|(k, p)| (Var(k + 1), *p)).collect();
    let along: Vec<Rational> = [1, 1, 1].map(|low| Rational::from(random.between(low, 3))).to_vec();
    let mut value = Poly::constant(random.number());
    for (var, _) in &products {
        value = &value + &Poly::var(*var).scale(&random.number());
    }
    if random.below(2) == 0 {
        value = &value + &(&Poly::var(Var(0)) * &Poly::var(Var(1)));
    }
    // Where x₀ is 0 and the points are these numbers times a large one, the products together are negative.
    let mut sum = Rational::ZERO;
    for (var, (p, q)) in &products {
        let slope = value.derivative(*var).at(Var(0), &Rational::ZERO);
        let slope = slope.as_constant().unwrap_or(Rational::ZERO);
        sum = &sum + &(&slope * &(&along[*p] * &along[*q]));
    }
    if !sum.is_negative() {
        let first = &along[0] * &along[0];
        let less = &(&sum + &Rational::new(1, 1000)) / &first;
        value = &value - &Poly::var(Var(1)).scale(&less);
    }
    let region = Region { ranges: vec![(Var(0), Range::closed(Rational::ZERO, Rational::ONE))] };
    let relation = if random.below(2) == 0 { Relation::Positive } else { Relation::NonNegative };
    Statement::Products { value, relation, products, domain: Rc::new(Domain::of(region)) }
}

impl Forger<'_> {
    fn indices(&mut self, below: usize) -> Vec<usize> {
        (0..below).filter(|_| self.random.below(2) == 0).collect()
    }

    fn combinations(&mut self, count: usize, below: usize) -> Vec<Vec<(usize, Rational)>> {
        let one = |f: &mut Self, k: usize| {
            let other = (f.random.below(below), f.random.number());
            if f.random.below(3) == 0 { vec![other] } else { vec![(k % below.max(1), Rational::ONE), other] }
        };
        (0..count).map(|k| one(self, k)).collect()
    }

    /// A certificate of independence of rows.
    fn rank(&mut self, height: usize, width: usize, pieces: usize) -> Rank {
        let piece = |f: &mut Self| {
            let change = (f.random.below(3) == 0).then(|| ChangeOfBasis {
                rows: f.combinations(height, height),
                columns: f.combinations(width, width),
            });
            // Each row in one block, mostly.
            let mut left: Vec<usize> = (0..height).collect();
            let mut blocks = Vec::new();
            while !left.is_empty() {
                let mut rows = Vec::new();
                for _ in 0..=f.random.below(left.len()) {
                    rows.push(left.remove(f.random.below(left.len())));
                    if left.is_empty() {
                        break;
                    }
                }
                if f.random.below(20) == 0 {
                    rows.pop();
                }
                let minor = |f: &mut Self| loop {
                    let columns = f.indices(width);
                    if columns.len() == rows.len() || f.random.below(9) == 0 {
                        return columns;
                    }
                };
                let columns = (0..=f.random.below(2)).map(|_| minor(f)).collect();
                let sign = match f.random.below(4) {
                    0 => f.signed(1),
                    1 => Signed::Negative(SignProof::direct()),
                    _ => Signed::Positive(SignProof::direct()),
                };
                blocks.push(Minors { rows, columns, sign });
            }
            Piece { change, blocks }
        };
        let exceptions = (0..pieces / 2).map(|_| (0..height).map(|_| self.poly()).collect()).collect();
        Rank { pieces: (0..pieces).map(|_| piece(self)).collect(), exceptions }
    }
}

#[test]
fn tables_and_dot_products_are_not_proved_by_chance() {
    tables(SEED + 3, TRIES);
}

fn tables(seed: u64, most: usize) {
    let random = &mut Random::new(seed);
    let mut tries = 0;
    while tries < most {
        let statement =
            Rc::new(if random.below(3) == 0 { negative_somewhere(random) } else { dependent(random) });
        let polys = vec![Poly::var(Var(0)), Poly::one(), random.poly(2), random.poly(1)];
        for _ in 0..20 {
            let mut forger = Forger { random, polys: polys.clone() };
            let certificate = match &*statement {
                Statement::Independent { rows, except, .. } if forger.random.below(30) > 0 => {
                    let pieces = if except.is_empty() { 1 } else { 1 + forger.random.below(3) };
                    Certificate::Rank(forger.rank(rows.len(), rows[0].len(), pieces))
                }
                Statement::Products { .. } if forger.random.below(5) > 0 => {
                    Certificate::Minors((0..=1 + forger.random.below(3)).map(|_| forger.fresh(2)).collect())
                }
                _ => Certificate::Direct,
            };
            tries += 1;
            assert!(
                !accepted(&statement, certificate.clone()),
                "seed {seed}, try {tries}: {statement:?} by {}",
                text::certificate_text(&certificate)
            );
        }
    }
}

/// A statement that is true everywhere: a sum of squares, 1 + squares, an identity, or rows with a triangle of ones.
fn true_everywhere(random: &mut Random) -> Statement {
    let squares = &random.poly(2).pow(2) + &random.poly(2).pow(2);
    let domain = Rc::new(Domain::default());
    match random.below(5) {
        0 => Statement::Zero {
            value: Quotient { numerator: Poly::zero(), denominator: random.poly(1) },
            domain,
        },
        1 => {
            let value = Quotient { numerator: squares.clone(), denominator: &squares + &Poly::one() };
            Statement::Sign { value, relation: Relation::NonNegative, domain }
        }
        2 => {
            let value = Quotient::from(&squares + &Poly::constant(Rational::new(1, 1_000_000)));
            Statement::Sign { value, relation: Relation::Positive, domain }
        }
        3 => {
            let products = vec![(Var(2), (0, 0)), (Var(3), (0, 1)), (Var(4), (1, 1))];
            let (a, b) = (Poly::constant(random.number()), Poly::constant(random.number()));
            // |a p + b q|² + squares
            let cross = (&a * &b).scale(&Rational::from(2));
            let form = &(&(&a * &a) * &Poly::var(Var(2))) + &(&cross * &Poly::var(Var(3)));
            let value = &(&form + &(&(&b * &b) * &Poly::var(Var(4)))) + &squares;
            Statement::Products { value, relation: Relation::NonNegative, products, domain }
        }
        _ => {
            let mut rows = Vec::new();
            for i in 0..3 {
                let row = (0..3).map(|j| match i.cmp(&j) {
                    core::cmp::Ordering::Less => random.poly(2),
                    core::cmp::Ordering::Equal => Poly::one(),
                    core::cmp::Ordering::Greater => Poly::zero(),
                });
                rows.push(row.collect());
            }
            Statement::Independent { rows, except: Vec::new(), region: Region::default() }
        }
    }
}

/// A random witness, often with irrational coordinates.
fn random_witness(random: &mut Random) -> Witness {
    let size = if random.below(2) == 0 { 1 } else { 2 + random.below(2) };
    let value = |random: &mut Random| Univariate::new((0..size).map(|_| random.number()).collect());
    let root = (size > 1).then(|| Root {
        polynomial: Univariate::new((0..=size).map(|_| random.number()).collect()),
        low: random.number(),
        high: random.number(),
    });
    let coordinates = (0..2).map(|k| (Var(k), value(random))).collect();
    let point = Point { root, coordinates };
    match random.below(4) {
        0 => {
            let mut factors: Vec<Univariate> = (0..3).map(|_| value(random)).collect();
            factors[random.below(3)] = Univariate::integers(&[1]);
            Witness::Dependent(point, factors)
        }
        1 => Witness::OnLine(point, (0..2).map(|k| (k, random.number())).collect()),
        _ => Witness::At(point),
    }
}

#[test]
fn what_is_true_is_not_refuted_by_chance() {
    witnesses(SEED + 4, TRIES);
}

fn witnesses(seed: u64, most: usize) {
    let random = &mut Random::new(seed);
    let mut tries = 0;
    while tries < most {
        let statement = Rc::new(true_everywhere(random));
        for _ in 0..40 {
            let witness = random_witness(random);
            tries += 1;
            let refuted = Refutation::new(Rc::clone(&statement), witness.clone(), &mut Work::new(WORK));
            assert!(
                refuted.is_err(),
                "seed {seed}, try {tries}: {statement:?} by {}",
                text::witness_text(&witness)
            );
        }
    }
}

#[test]
#[ignore = "minutes: a million forgeries, to be run with --release"]
fn a_million() {
    let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).expect("after 1970");
    let seed = std::env::var("SEED").ok().and_then(|seed| seed.parse().ok()).unwrap_or(now.as_secs());
    println!("SEED={seed}");
    changed(seed, 300_000);
    from_nothing(seed + 1, 300_000);
    tables(seed + 2, 300_000);
    witnesses(seed + 3, 300_000);
}

/// The forger can do it: with a claim that is true it finds certificates that are accepted.
#[test]
fn true_claims_are_proved_by_chance() {
    let random = &mut Random::new(SEED + 2);
    let statement = sign("x0^2 - x0 + 1/3 > 0", "0 <= x0 <= 1");
    let polys = vec![crate::text::poly("x0")];
    let mut found = 0;
    for _ in 0..2000 {
        let numerator = Forger { random, polys: polys.clone() }.fresh(0);
        found += usize::from(accepted(&statement, Certificate::Sign { denominator: None, numerator }));
    }
    assert!(found > 20, "{found}");
    let table = crate::tables::independent("x0 + 2, 1, 0; 0, 1 - x0, 1", "", "0 <= x0 < 1");
    let polys = vec![Poly::one()];
    let mut found = 0;
    for _ in 0..2000 {
        let rank = Forger { random, polys: polys.clone() }.rank(2, 3, 1);
        found += usize::from(accepted(&table, Certificate::Rank(rank)));
    }
    assert!(found > 20, "{found}");
    let irrational = sign(IRRATIONAL.claim, IRRATIONAL.on);
    let Ok(certificate) = text::certificate(IRRATIONAL.certificate.trim()) else { panic!("a certificate") };
    assert!(Proof::new(irrational, certificate, &mut Work::usual(1)).is_ok());
}

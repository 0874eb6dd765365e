//! Forged certificates: random changes of real ones, and random ones, for statements that are false by construction.
//! None of them may be accepted.

use std::rc::Rc;

use basis_kernel::algebra::poly::{Monomial, Poly, Var};
use basis_kernel::algebra::range::{End, Range, Region};
use basis_kernel::algebra::rational::Rational;
use basis_kernel::algebra::work::Work;
use basis_kernel::{
    Cells, Certificate, Cuts, Domain, FactorSign, Proof, Quotient, Relation, Sample, Section, SignProof,
    Signed, Statement, text,
};
use basis_test_support::Random;

use crate::signs::{CASES, Case, IRRATIONAL};
use crate::text::sign;

/// How many certificates are offered.
const TRIES: usize = 100_000;
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
        match self.random.below(if depth > 3 { 2 } else { 7 }) {
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
            4 | 5 => SignProof::Faces((0..=self.random.below(9)).map(|_| self.fresh(depth + 1)).collect()),
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
    let random = &mut Random::new(SEED);
    let mut tries = 0;
    let own =
        |c: &Case| accepted(&sign(c.claim, c.on), text::certificate(c.certificate).expect("a certificate"));
    let mut cases: Vec<&Case> = CASES.iter().chain([&IRRATIONAL]).collect();
    cases.retain(|c| !c.point.is_empty() && !c.claim.contains("//") && own(c));
    assert_eq!(cases.len(), 10);
    while tries < TRIES / 2 {
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
                    "seed {SEED}, try {tries}: {statement:?} by {}",
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
    let random = &mut Random::new(SEED + 1);
    let mut tries = 0;
    while tries < TRIES / 2 {
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
                "seed {}, try {tries}: {statement:?} by {}",
                SEED + 1,
                text::certificate_text(&certificate)
            );
        }
    }
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
    let irrational = sign(IRRATIONAL.claim, IRRATIONAL.on);
    let Ok(certificate) = text::certificate(IRRATIONAL.certificate.trim()) else { panic!("a certificate") };
    assert!(Proof::new(irrational, certificate, &mut Work::usual(1)).is_ok());
}

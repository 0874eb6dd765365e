//! The kernel's numbers and polynomials against arithmetic that is as simple as it can be: fractions of two big integers, and
//! maps from lists of exponents to them.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use basis_kernel::algebra::poly::{Monomial, Poly, Var};
use basis_kernel::algebra::rational::Rational;
use basis_kernel::algebra::univariate::Univariate;
use basis_kernel::algebra::work::Work;
use basis_test_support::Random;
use num_bigint::BigInt;
use num_integer::Integer as _;

/// Numerator and denominator in lowest terms, the denominator positive.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Fraction(BigInt, BigInt);

impl Fraction {
    fn new(n: BigInt, d: BigInt) -> Self {
        let zero = BigInt::from(0);
        assert!(d != zero);
        let common = if d < zero { -n.gcd(&d) } else { n.gcd(&d) };
        Self(n / &common, d / common)
    }
    fn whole(n: impl Into<BigInt>) -> Self {
        Self(n.into(), BigInt::from(1))
    }
    fn add(&self, other: &Self) -> Self {
        Self::new(&self.0 * &other.1 + &other.0 * &self.1, &self.1 * &other.1)
    }
    fn neg(&self) -> Self {
        Self(-&self.0, self.1.clone())
    }
    fn mul(&self, other: &Self) -> Self {
        Self::new(&self.0 * &other.0, &self.1 * &other.1)
    }
    fn pow(&self, exponent: u32) -> Self {
        Self(self.0.pow(exponent), self.1.pow(exponent))
    }
    fn sign(&self) -> i32 {
        match self.0.cmp(&BigInt::from(0)) {
            Ordering::Less => -1,
            Ordering::Equal => 0,
            Ordering::Greater => 1,
        }
    }
    fn text(&self) -> String {
        if self.1 == BigInt::from(1) { self.0.to_string() } else { format!("{}/{}", self.0, self.1) }
    }
    /// The kernel's number.
    fn number(&self) -> Rational {
        Rational::parse(&self.text()).expect("a fraction")
    }
    /// What the kernel's number is.
    fn of(number: &Rational) -> Self {
        let text = number.to_string();
        let (n, d) = text.split_once('/').unwrap_or((&text, "1"));
        let all = [n, d].map(|part| part.parse::<BigInt>().expect("digits"));
        let [n, d] = all;
        let fraction = Self(n, d);
        assert_eq!(Self::new(fraction.0.clone(), fraction.1.clone()), fraction, "not in lowest terms");
        assert_eq!(&fraction.number(), number, "equal numbers are equal as data");
        fraction
    }
}

/// Numbers around the limits of machine words, short ones and long ones, of both signs.
fn numbers() -> Vec<Fraction> {
    let one = BigInt::from(1);
    let mut whole = vec![BigInt::from(0)];
    for shift in [0_usize, 1, 5, 31, 32, 62, 63, 64, 65, 127, 128, 200] {
        for near in -1..=1 {
            let n: BigInt = (&one << shift) + near;
            whole.extend([-&n, n]);
        }
    }
    let denominators = [1_i64, 2, 3, 15, 1 << 40, i64::MAX]
        .map(BigInt::from)
        .into_iter()
        .chain([&one << 64, (&one << 90) - 1]);
    let mut all = Vec::new();
    for (k, d) in denominators.enumerate() {
        // Every third number with each denominator but 1, another third each time.
        let some = whole.iter().enumerate().filter(|(i, _)| k == 0 || i % 3 == k % 3);
        all.extend(some.map(|(_, n)| Fraction::new(n.clone(), d.clone())));
    }
    all
}

#[test]
fn numbers_are_fractions() {
    let all = numbers();
    for a in &all {
        let x = a.number();
        assert_eq!(&Fraction::of(&x), a);
        assert_eq!((x.signum(), x.is_zero()), (a.sign(), a.sign() == 0));
        assert_eq!((x.is_negative(), x.is_positive()), (a.sign() < 0, a.sign() > 0));
        let (one, is_whole) = (BigInt::from(1), a.1 == BigInt::from(1));
        assert_eq!((x.is_one(), x.is_integer()), (is_whole && a.0 == one, is_whole));
        assert_eq!(x.to_whole(), is_whole.then(|| a.0.clone()));
        let word = i64::try_from(&a.0).ok().filter(|n| is_whole && *n != i64::MIN);
        assert_eq!(x.to_i64(), word);
        assert_eq!((x.numer().to_whole(), x.denom().to_whole()), (Some(a.0.clone()), Some(a.1.clone())));
        assert_eq!(x.bits(), a.0.bits() + a.1.bits(), "{x}");
        assert_eq!(Fraction::of(&x.abs()), if a.sign() < 0 { a.neg() } else { a.clone() });
        assert_eq!(Fraction::of(&-&x), a.neg());
        assert_eq!(Fraction::of(&x.floor()), Fraction::whole(a.0.div_floor(&a.1)));
        assert_eq!(x.recip().is_none(), a.sign() == 0);
        for e in [0, 1, 2, 3, 6] {
            assert_eq!(Fraction::of(&x.pow(e)), a.pow(e));
        }
        assert_eq!(Rational::from(a.0.clone()), Fraction::whole(a.0.clone()).number());
        assert_eq!(
            Rational::ratio(&a.0 * 6, &a.1 * -4),
            a.mul(&Fraction::new(3.into(), (-2).into())).number()
        );
    }
    for n in [0, 1, -1, i64::MAX, i64::MIN + 1, i64::MIN] {
        assert_eq!(Rational::from(n), Fraction::whole(n).number());
        for d in [1, -1, 6, i64::MAX, i64::MIN] {
            assert_eq!(Rational::new(n, d), Fraction::new(n.into(), d.into()).number());
        }
    }
    for wrong in ["", "1/", "/2", "1/0", "a", "1.5", "1/x"] {
        assert_eq!(Rational::parse(wrong), None, "{wrong}");
    }
}

#[test]
fn operations_on_numbers_are_those_on_fractions() {
    let all = numbers();
    for (k, a) in all.iter().enumerate() {
        for b in all.iter().skip(k % 29).step_by(29) {
            let (x, y) = (a.number(), b.number());
            assert_eq!(Fraction::of(&(&x + &y)), a.add(b));
            assert_eq!(Fraction::of(&(&x - &y)), a.add(&b.neg()));
            assert_eq!(Fraction::of(&(&x * &y)), a.mul(b));
            assert_eq!(x.cmp(&y), (&a.0 * &b.1).cmp(&(&b.0 * &a.1)), "{x} {y}");
            let quotient = (b.sign() != 0).then(|| Fraction::new(&a.0 * &b.1, &a.1 * &b.0));
            assert_eq!(x.checked_div(&y).map(|q| Fraction::of(&q)), quotient);
            let common = Fraction::new((&a.0 * &b.1).gcd(&(&b.0 * &a.1)), &a.1 * &b.1);
            assert_eq!(Fraction::of(&x.gcd(&y)), common, "{x} {y}");
            let mut z = x.clone();
            z += &y;
            z *= &y;
            z -= &x;
            assert_eq!(Fraction::of(&z), a.add(b).mul(b).add(&a.neg()));
        }
    }
}

/// A polynomial as a map from exponents, without zeros at the end, to coefficients that are not 0.
#[derive(Clone, Debug, Default, PartialEq)]
struct Plain(BTreeMap<Vec<u16>, Fraction>);

impl Plain {
    fn insert(&mut self, mut exponents: Vec<u16>, c: &Fraction) {
        while exponents.last() == Some(&0) {
            exponents.pop();
        }
        let sum = self.0.remove(&exponents).map_or_else(|| c.clone(), |d| d.add(c));
        if sum.sign() != 0 {
            self.0.insert(exponents, sum);
        }
    }
    fn constant(c: i64) -> Self {
        let mut p = Self::default();
        p.insert(Vec::new(), &Fraction::whole(c));
        p
    }
    fn add(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        for (e, c) in &other.0 {
            sum.insert(e.clone(), c);
        }
        sum
    }
    fn neg(&self) -> Self {
        Self(self.0.iter().map(|(e, c)| (e.clone(), c.neg())).collect())
    }
    fn mul(&self, other: &Self) -> Self {
        let mut product = Self::default();
        for (e, c) in &self.0 {
            for (f, d) in &other.0 {
                let len = e.len().max(f.len());
                let of = |all: &[u16], k: usize| all.get(k).copied().unwrap_or(0);
                product.insert((0..len).map(|k| of(e, k) + of(f, k)).collect(), &c.mul(d));
            }
        }
        product
    }
    fn pow(&self, exponent: u32) -> Self {
        (0..exponent).fold(Self::constant(1), |power, _| power.mul(self))
    }
    /// The exponent of a variable in a monomial, and the monomial without it.
    fn split(exponents: &[u16], var: usize) -> (u16, Vec<u16>) {
        let mut rest = exponents.to_vec();
        (rest.get_mut(var).map_or(0, std::mem::take), rest)
    }
    fn substitute(&self, var: usize, value: &Self) -> Self {
        let mut sum = Self::default();
        for (exponents, c) in &self.0 {
            let (e, rest) = Self::split(exponents, var);
            let mut term = Self::default();
            term.insert(rest, c);
            sum = sum.add(&term.mul(&value.pow(e.into())));
        }
        sum
    }
    fn derivative(&self, var: usize) -> Self {
        let mut sum = Self::default();
        for (exponents, c) in &self.0 {
            let (e, _) = Self::split(exponents, var);
            if e > 0 {
                let mut lower = exponents.clone();
                lower[var] -= 1;
                sum.insert(lower, &c.mul(&Fraction::whole(e)));
            }
        }
        sum
    }
    fn poly(&self) -> Poly {
        Poly::from_terms(self.0.iter().rev().map(|(e, c)| (Monomial::new(e.clone()), c.number())))
    }
    fn of(poly: &Poly) -> Self {
        let listed: Vec<Vec<u16>> = poly.terms().map(|(m, _)| m.exponents()).collect();
        assert!(listed.windows(2).all(|pair| pair[0] < pair[1]), "terms in order: {listed:?}");
        assert!(poly.terms().all(|(_, c)| !c.is_zero()), "no term is zero");
        Self(poly.terms().map(|(m, c)| (m.exponents(), Fraction::of(c))).collect())
    }
}

/// Exponents of every kind: few and low ones, those beyond a byte, and those of many variables.
fn exponents(random: &mut Random) -> Vec<u16> {
    match random.below(12) {
        0 => (0..3).map(|_| [0, 1, 127, 128, 200, 255, 256, 700][random.below(8)]).collect(),
        1 => (0..17 + random.below(3)).map(|_| random.below(3) as u16).collect(),
        2 => (0..16).map(|_| random.below(2) as u16 * 128).collect(),
        _ => (0..random.below(4)).map(|_| random.below(4) as u16).collect(),
    }
}

fn fraction(random: &mut Random) -> Fraction {
    let long = BigInt::from(random.below(1 << 30)) << [0, 0, 0, 70][random.below(4)];
    let n = if random.below(3) == 0 { long } else { BigInt::from(random.below(7)) };
    let sign = if random.below(2) == 0 { 1 } else { -1 };
    Fraction::new(n * sign, BigInt::from(1 + random.below(3)))
}

fn polynomial(terms: usize, random: &mut Random) -> Plain {
    let mut p = Plain::default();
    for _ in 0..random.below(terms + 1) {
        p.insert(exponents(random), &fraction(random));
    }
    p
}

/// Few terms with low exponents: what is put in place of a variable.
fn short(random: &mut Random) -> Plain {
    let mut p = Plain::default();
    for _ in 0..random.below(6) {
        p.insert((0..3).map(|_| random.below(3) as u16 / 2).collect(), &fraction(random));
    }
    p
}

#[test]
fn monomials_are_lists_of_exponents() {
    let random = &mut Random::new(20_261_128);
    let mut all: Vec<Vec<u16>> = vec![vec![128; 16], vec![255; 16], vec![0; 15], vec![1]];
    all.extend((0..80).map(|_| exponents(random)));
    let of = |e: &[u16], k: usize| e.get(k).copied().unwrap_or(0);
    for e in &all {
        let m = Monomial::new(e.clone());
        let width = e.iter().rposition(|e| *e > 0).map_or(0, |last| last + 1);
        assert_eq!((m.width(), m.exponents()), (width, e[..width].to_vec()));
        assert_eq!(m.total_degree(), e.iter().map(|e| u32::from(*e)).sum::<u32>());
        assert_eq!(m.is_one(), width == 0);
        for k in 0..20 {
            assert_eq!(m.exponent(Var(k)), of(e, k));
            for other in [0, 1, 255, 256] {
                let mut changed = e.clone();
                changed.resize(20, 0);
                changed[k] = other;
                assert_eq!(m.with_exponent(Var(k), other), Monomial::new(changed), "{m:?}");
            }
        }
        for f in &all {
            let n = Monomial::new(f.clone());
            let len = e.len().max(f.len());
            let padded = |e: &[u16]| (0..len).map(|k| of(e, k)).collect::<Vec<_>>();
            assert_eq!(m.cmp(&n), padded(e).cmp(&padded(f)), "{m:?} {n:?}");
            assert_eq!(m == n, padded(e) == padded(f));
            let quotient = (0..len).map(|k| of(e, k).checked_sub(of(f, k))).collect::<Option<Vec<_>>>();
            assert_eq!(m.checked_div(&n), quotient.map(Monomial::new), "{m:?} / {n:?}");
        }
    }
}

#[test]
fn operations_on_polynomials_are_those_on_maps() {
    let random = &mut Random::new(20_261_129);
    for _ in 0..300 {
        let (p, q) = (polynomial(9, random), polynomial(5, random));
        let (a, b) = (p.poly(), q.poly());
        assert_eq!(Plain::of(&a), p);
        assert_eq!(Plain::of(&(&a + &b)), p.add(&q));
        assert_eq!(Plain::of(&(&a - &b)), p.add(&q.neg()));
        assert_eq!(Plain::of(&-&a), p.neg());
        assert_eq!(Plain::of(&(&a * &b)), p.mul(&q));
        assert_eq!(&a - &a, Poly::zero());
        let c = fraction(random);
        let mut number = Plain::default();
        number.insert(Vec::new(), &c);
        assert_eq!(Plain::of(&Poly::constant(c.number())), number);
        assert_eq!(Plain::of(&a.scale(&c.number())), p.mul(&number));
        for e in [0, 1, 2, 3] {
            assert_eq!(Plain::of(&b.pow(e)), q.pow(e));
        }
        for k in [0, 2, 17] {
            assert_eq!(Plain::of(&a.derivative(Var(k))), p.derivative(k));
            let degree = p.0.keys().map(|e| Plain::split(e, k).0).max().unwrap_or(0);
            assert_eq!((a.degree(Var(k)), a.depends_on(Var(k))), (degree.into(), degree > 0));
            let listed = a.coefficients_in(Var(k));
            assert_eq!(listed.len(), usize::from(degree) + 1);
            let x = Poly::var(Var(k));
            let sum = listed.iter().rev().fold(Poly::zero(), |sum, c| &(&sum * &x) + c);
            assert_eq!(sum, a);
            assert!(listed.iter().all(|c| !c.depends_on(Var(k))));
            // The value of a high power of a long number is longer than this test is patient.
            if degree < 10 {
                assert_eq!(Plain::of(&a.at(Var(k), &c.number())), p.substitute(k, &number));
                let value = short(random);
                assert_eq!(
                    Plain::of(&a.substitute(Var(k), &value.poly())),
                    p.substitute(k, &value),
                    "{value:?}"
                );
            }
        }
        let total = p.0.keys().map(|e| e.iter().map(|e| u32::from(*e)).sum::<u32>()).max().unwrap_or(0);
        let width = p.0.keys().map(Vec::len).max().unwrap_or(0);
        let variables: Vec<Var> = (0..width).map(Var).filter(|v| a.depends_on(*v)).collect();
        assert_eq!((a.total_degree(), a.variables()), (total, variables));
        let bits = p.0.values().map(|c| c.0.bits() + c.1.bits()).max().unwrap_or(0);
        assert_eq!(
            (a.len(), a.is_zero(), a.is_empty(), a.max_bits()),
            (p.0.len(), p.0.is_empty(), p.0.is_empty(), bits)
        );
        assert_eq!(a.leading_term().map(|(m, c)| (m.exponents(), Fraction::of(c))), p.0.clone().pop_last());
        let constant = if p.0.is_empty() { Some(Fraction::whole(0)) } else { p.0.get(&Vec::new()).cloned() };
        assert_eq!(a.as_constant().map(|c| Fraction::of(&c)), constant.filter(|_| p.0.len() <= 1));
        assert_eq!(a.is_one(), p == Plain::constant(1));
    }
    assert!(Poly::one().is_one() && !Poly::integer(2).is_one() && !Poly::var(Var(0)).is_one());
    assert_eq!(Poly::from_terms([(Monomial::one(), Rational::ZERO)]), Poly::zero());
}

#[test]
fn exact_division_undoes_a_product() {
    let random = &mut Random::new(20_261_130);
    for round in 0..300 {
        let (p, q) = (polynomial([5, 12][round % 2], random).poly(), polynomial(9, random).poly());
        let product = &p * &q;
        assert_eq!(product.div_exact(&q), (!q.is_zero()).then(|| p.clone()));
        if q.as_constant().is_none() {
            assert_eq!((&product + &Poly::one()).div_exact(&q), None);
        }
        let content = p.numeric_content();
        let whole = |p: &Poly| {
            p.terms().map(|(_, c)| c.to_whole().expect("whole")).fold(BigInt::from(0), |g, c| g.gcd(&c))
        };
        let normal = p.normalized();
        if p.is_zero() {
            assert!(content.is_zero() && normal.is_zero());
            continue;
        }
        assert!(content.is_positive());
        assert_eq!(whole(&p.scale(&content.recip().expect("positive"))), BigInt::from(1));
        assert_eq!(whole(&normal), BigInt::from(1));
        let lead = normal.leading_term().expect("not 0").1;
        assert!(lead.is_positive());
        let sign = Rational::from(i64::from(p.leading_term().expect("not 0").1.signum()));
        assert_eq!(normal.scale(&(&content * &sign)), p);
    }
}

/// A polynomial in one variable, of at most this degree.
fn univariate(degree: usize, random: &mut Random) -> Univariate {
    Univariate::new((0..=random.below(degree + 1)).map(|_| fraction(random).number()).collect())
}

/// The same in the sparse representation.
fn sparse(p: &Univariate) -> Poly {
    let term = |(k, c): (usize, &Rational)| (Monomial::new(vec![0, k as u16]), c.clone());
    Poly::from_terms(p.coefficients().iter().enumerate().map(term))
}

#[test]
fn dense_polynomials_are_sparse_ones() {
    let (random, x) = (&mut Random::new(20_261_131), Var(1));
    let back = |p: &Poly| Univariate::from_poly(p, x).expect("one variable");
    for _ in 0..300 {
        let (a, b) = (univariate(6, random), univariate(4, random));
        let (p, q) = (sparse(&a), sparse(&b));
        assert_eq!(back(&p), a);
        assert_eq!((a.add(&b), a.mul(&b)), (back(&(&p + &q)), back(&(&p * &q))));
        assert_eq!((a.derivative(), a.degree()), (back(&p.derivative(x)), p.degree(x) as usize));
        let constant = p.as_constant();
        assert_eq!((a.is_zero(), a.is_constant()), (p.is_zero(), constant.is_some()));
        let lead = p.leading_term().map_or(Rational::ZERO, |(_, c)| c.clone());
        assert_eq!((a.leading(), a.max_bits()), (lead.clone(), p.max_bits()));
        let number = fraction(random).number();
        assert_eq!(a.scale(&number), back(&p.scale(&number)));
        assert_eq!(a.sign_at(&number), p.at(x, &number).as_constant().expect("a number").signum());
        let odd = if a.degree() % 2 == 1 { -1 } else { 1 };
        assert_eq!(
            (a.sign_at_infinity(true), a.sign_at_infinity(false)),
            (lead.signum(), odd * lead.signum())
        );
        let normal = back(&p.normalized());
        let sign = Rational::from(i64::from(lead.signum()));
        assert_eq!((a.normalized(), a.primitive()), (normal.clone(), normal.scale(&sign)));
        let work = &mut Work::unlimited();
        assert_eq!(a.mul(&b).div_exact(&b), (!b.is_zero()).then(|| a.clone()));
        let (rest, multiple) = (a.modulo(&b, work), a.remainder(&b, work));
        if b.is_zero() {
            assert_eq!((rest, multiple), (None, None));
            continue;
        }
        let (rest, multiple) = (rest.expect("unlimited"), multiple.expect("unlimited"));
        assert!(rest.is_zero() || rest.degree() < b.degree());
        assert!((&p - &sparse(&rest)).div_exact(&q).is_some());
        assert_eq!(multiple, rest.primitive());
        if !b.is_constant() {
            assert_eq!(a.mul(&b).add(&Univariate::integers(&[1])).div_exact(&b), None);
        }
    }
    let other = &Poly::var(Var(0)) * &Poly::var(x);
    assert_eq!(Univariate::from_poly(&other, x), None);
    assert_eq!(Univariate::from_poly(&Poly::var(Var(2)), x), None);
}

#[test]
fn common_factors_are_those_that_were_put_in() {
    let (random, work) = (&mut Random::new(20_261_132), &mut Work::unlimited());
    // Different irreducible polynomials: linear ones, x² + k with k ≥ 1, and x³ − 2.
    let prime = |k: usize| match k {
        0..5 => Univariate::integers(&[[-1, 2], [1, 1], [3, 5], [-7, 1], [0, 1]][k]),
        5..8 => Univariate::integers(&[k as i64, 0, 1]),
        _ => Univariate::integers(&[-2, 0, 0, 1]),
    };
    for _ in 0..200 {
        let (mut a, mut b) = (Univariate::integers(&[1]), Univariate::integers(&[1]));
        let (mut common, mut free) = (a.clone(), a.clone());
        for k in 0..9 {
            let (i, j) = (random.below(8) / 5, random.below(8) / 5);
            let times = |p: Univariate, e: usize| (0..e).fold(p, |p, _| p.mul(&prime(k)));
            (a, b, common, free) = (times(a, i), times(b, j), times(common, i.min(j)), times(free, i.min(1)));
        }
        let (u, v) = (Rational::from(-6), Rational::new(3, 4));
        let (a, b) = (a.scale(&u), b.mul(&b).scale(&v));
        let square = common.mul(&common);
        let expected = a.gcd(&b, work).expect("unlimited");
        assert!(a.div_exact(&expected).is_some() && b.div_exact(&expected).is_some());
        assert!(expected.div_exact(&common).is_some(), "{expected:?}");
        assert_eq!(a.mul(&a).gcd(&b, work), Some(square.normalized()));
        assert_eq!(a.mul(&a).square_free_part(work), Some(free.normalized()));
        assert_eq!(a.gcd(&Univariate::default(), work), Some(a.normalized()));
        assert_eq!(Univariate::default().gcd(&a, work), Some(a.normalized()));
    }
}

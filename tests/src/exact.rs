//! Exact reference values of families: straight from the formulas of the spec, by rational arithmetic.

use std::borrow::Cow;
use std::rc::Rc;

use basis_engine::algebra::number::binomial;
use basis_engine::algebra::poly::{Poly, PolyExt};
use basis_engine::algebra::rational::{Rational, ToFloat as _};
use basis_engine::{ClaimKind, Disk, Family, Library, Prover, Subject, decide, generate, source};
use basis_runtime::Scalar;

use crate::random::Random;

/// The fraction that a float is.
///
/// # Panics
/// When it is infinite or NaN.
pub fn fraction(value: impl Scalar) -> Rational {
    let value = value.to_f64();
    assert!(value.is_finite(), "{value} is not a number");
    // The mantissa is a whole number below 2⁵³ times 2^−1074 for the smallest exponents, 0 and 1.
    let (bits, exponent) = (value.to_bits() & ((1 << 52) - 1), value.to_bits() >> 52 & 0x7ff);
    let mantissa = if exponent == 0 { bits } else { bits | 1 << 52 };
    let power = Rational::from(2).pow(exponent.abs_diff(1075).min(1074) as u32);
    let size = Rational::from(mantissa as i64);
    let size = if exponent < 1075 { &size / &power } else { &size * &power };
    if value < 0.0 { -size } else { size }
}

/// The fractions that floats are.
pub fn fractions<S: Scalar>(values: impl AsRef<[S]>) -> Vec<Rational> {
    values.as_ref().iter().map(|v| fraction(*v)).collect()
}

/// The distance from 1 to the next float.
pub fn epsilon<S: Scalar>() -> f64 {
    if size_of::<S>() == 4 { f64::from(f32::EPSILON) } else { f64::EPSILON }
}

/// The largest float.
pub fn largest<S: Scalar>() -> f64 {
    if size_of::<S>() == 4 { f64::from(f32::MAX) } else { f64::MAX }
}

/// A family of one order, as the engine understands its spec, with the functions marked that are proved to be nonnegative.
#[derive(Clone, Debug)]
pub struct Reference {
    /// The family.
    pub family: Rc<Family>,
}

impl Reference {
    /// The family of that name and order in a file of the library.
    ///
    /// # Panics
    /// When the file cannot be read or has no such family.
    pub fn new(file: &str, name: &str, order: &[i64]) -> Self {
        let path = crate::spec(file).to_string_lossy().into_owned();
        let source = source::read(&Disk, &path, &[]).unwrap_or_else(|e| panic!("{e}"));
        let library = Library::from_source(&Disk, &Prover, source);
        let mut item = library.item(name, order).unwrap_or_else(|e| panic!("{name}{order:?}: {e:?}"));
        item.claims.retain(|claim| matches!(claim.kind, ClaimKind::Nonnegative | ClaimKind::Relation { .. }));
        let checked = decide(item);
        let Subject::Family(family) = &checked.subject else { panic!("{name} is a theorem") };
        match generate::evaluated(family, &checked.claims) {
            Ok(Cow::Owned(evaluated)) => Self { family: Rc::new(evaluated) },
            _ => Self { family: Rc::clone(family) },
        }
    }

    /// Shape values inside the declared ranges, often at an end; between -30 and 30 where a range has no end.
    pub fn shape<S: Scalar>(&self, random: &mut Random) -> Vec<S> {
        let one = |p: &basis_engine::model::Parameter, random: &mut Random| {
            let low = p.range.low.value().map_or(-30.0, Rational::to_f64);
            let high = p.range.high.value().map_or(30.0, Rational::to_f64);
            loop {
                let value: S = S::of(low + (high - low) * random.unit::<f64>());
                if p.range.contains(&fraction(value)) {
                    return value;
                }
            }
        };
        self.family.shapes.iter().map(|p| one(p, random)).collect()
    }

    /// Several shape values as [`shape`](Self::shape) gives them; once the empty list for a family without any.
    pub fn shapes<S: Scalar>(&self, count: usize, random: &mut Random) -> Vec<Vec<S>> {
        let count = if self.family.shapes.is_empty() { 1 } else { count };
        (0..count).map(|_| self.shape(random)).collect()
    }

    /// The functions with these shape values.
    ///
    /// # Panics
    /// When there are several domain variables, or a denominator vanishes.
    pub fn at<S: Scalar>(&self, shape: &[S]) -> Functions {
        let family = &self.family;
        let (var, low, high) = family.interval().expect("one domain variable");
        let mut point = vec![Rational::ZERO; family.names.len()];
        let mut sizes = point.clone();
        for (parameter, value) in family.shapes.iter().zip(shape) {
            point[parameter.var.0] = fraction(*value);
            sizes[parameter.var.0] = point[parameter.var.0].abs();
        }
        let rows = |of: &dyn Fn(&Poly) -> Rational| -> Vec<Vec<Rational>> {
            let one = |f: &basis_engine::model::Function| {
                let denom = f.value.denom().eval(&point).recip().expect("no pole");
                let mut row: Vec<Rational> =
                    f.value.numer().coefficients_in(var).iter().map(|c| &of(c) * &denom).collect();
                row.resize(family.degree(var) as usize + 1, Rational::ZERO);
                row
            };
            family.functions.iter().map(one).collect()
        };
        let positive = |p: &Poly| Poly::from_terms(p.terms().map(|(m, c)| (m.clone(), c.abs())));
        Functions {
            domain: [low.clone(), high.clone()],
            coefficients: rows(&|c| c.eval(&point)),
            sizes: rows(&|c| positive(c).eval(&sizes)),
        }
    }
}

/// The functions of a family for some shape values, as polynomials in the domain variable.
#[derive(Clone, Debug)]
pub struct Functions {
    /// The ends of the domain.
    pub domain: [Rational; 2],
    /// The coefficients of `1, t, t², …` of every function.
    pub coefficients: Vec<Vec<Rational>>,
    /// The same with all terms of the formulas taken as positive: what rounding errors are proportional to.
    pub sizes: Vec<Vec<Rational>>,
}

impl Functions {
    /// The values of all functions.
    pub fn values(&self, t: &Rational) -> Vec<Rational> {
        self.coefficients.iter().map(|row| value(row, t)).collect()
    }

    /// The derivatives of that order of all functions.
    pub fn derivatives(&self, t: &Rational, order: usize) -> Vec<Rational> {
        self.coefficients.iter().map(|row| value(&derivative(row, order), t)).collect()
    }

    /// The coefficients of every function in the Bernstein basis of the same degree on the domain:
    /// `c[j] = Σ_k binomial(j, k) / binomial(n, k) · a[k]` for `Σ_k a[k] x^k`, `a[k]` from the Taylor series at the
    /// lower end.
    pub fn bernstein_coefficients(&self) -> Vec<Vec<Rational>> {
        let [low, high] = &self.domain;
        let width = high.clone() - low.clone();
        let convert = |row: &Vec<Rational>| -> Vec<Rational> {
            let n = row.len() as u32 - 1;
            let mut scale = Rational::ONE;
            let taylor: Vec<Rational> = (0..=n)
                .map(|k| {
                    let a = &value(&derivative(row, k as usize), low) * &scale;
                    scale = &(&scale * &width) / &Rational::from(i64::from(k) + 1);
                    a
                })
                .collect();
            let term = |j: u32, k: u32| &taylor[k as usize] * &(&binomial(j, k) / &binomial(n, k));
            (0..=n).map(|j| (0..=j).fold(Rational::ZERO, |sum, k| sum + term(j, k))).collect()
        };
        self.coefficients.iter().map(convert).collect()
    }
}

/// The coefficients of the derivative of that order.
fn derivative(row: &[Rational], order: usize) -> Vec<Rational> {
    let factor = |k: usize| (0..order).fold(Rational::ONE, |f, i| &f * &Rational::from((k - i) as i64));
    row.iter().enumerate().skip(order).map(|(k, c)| c * &factor(k)).collect()
}

/// Σ row[k] t^k by Horner's scheme on whole numbers, which need no common factors to be found.
fn value(row: &[Rational], t: &Rational) -> Rational {
    let common = row.iter().fold(Rational::ONE, |l, c| {
        let d = c.denom();
        &(&l * &d) / &l.gcd(&d)
    });
    let (a, d) = (t.numer(), t.denom());
    let (mut sum, mut power) = (Rational::ZERO, Rational::ONE);
    for c in row.iter().rev() {
        sum = &(&sum * &a) + &(&(c * &common) * &power);
        power = &power * &d;
    }
    // Now power = dⁿ⁺¹ where dⁿ is wanted.
    &(&sum * &d) / &(&power * &common)
}

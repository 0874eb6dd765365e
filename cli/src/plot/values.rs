//! Values of functions at many points, exact and then rounded; of functions with angles, in floating point.

use basis_engine::Family;
use basis_engine::algebra::fraction::Fraction;
use basis_engine::algebra::poly::{Monomial, Poly, Var};
use basis_engine::algebra::rational::{Rational, ToFloat as _};
use basis_engine::model::angle::{Angle, Kind};

/// The families on the spans of the domain; of a domain of one span the family itself.
pub(super) fn pieces(family: &Family) -> Vec<&Family> {
    if family.pieces.is_empty() { vec![family] } else { family.pieces.iter().map(AsRef::as_ref).collect() }
}

/// The functions at some shape values.
pub(super) struct Functions {
    formulas: Vec<Fraction>,
    /// How many variables there are, shape parameters included.
    width: usize,
    /// The domain variables.
    domain: Vec<Var>,
    /// What stands in sin, exp and the like, and the functions; nothing for quotients of polynomials.
    angles: Option<(Angles, Vec<Quotient>)>,
}

/// The values of all variables of a family with angles, by variable, and the angle of the domain variable.
struct Angles {
    base: Vec<f64>,
    domain: Option<Angle>,
}

impl Functions {
    /// The functions of a family; one whose denominator vanishes is left out of all pictures.
    pub(super) fn new(family: &Family, shapes: &[Rational]) -> Self {
        let at = |f: &Fraction| {
            let mut value = f.clone();
            for (shape, x) in family.shapes.iter().zip(shapes) {
                value = value
                    .substitute(shape.var, &Fraction::constant(x.clone()))
                    .unwrap_or_else(Fraction::zero);
            }
            value
        };
        let width = family.names.len();
        let formulas: Vec<Fraction> = family.functions.iter().map(|f| at(&f.value)).collect();
        let angles = (!family.analytic.is_empty())
            .then(|| (Angles::new(family, shapes), formulas.iter().map(Quotient::new).collect()));
        Self { formulas, width, domain: family.domain.iter().map(|p| p.var).collect(), angles }
    }

    /// Where a value of the only domain variable stands on the axis: the angle, if it is one.
    pub(super) fn axis(&self, y: &Rational) -> f64 {
        let angle = self.angles.as_ref().and_then(|(a, _)| Some((a, a.domain.as_ref()?)));
        angle.map_or_else(|| y.to_f64(), |(angles, angle)| angles.itself(angle, y.to_f64()))
    }

    /// Values of the only domain variable, both ends included, that stand at equal distances on the axis.
    pub(super) fn along(&self, low: &Rational, high: &Rational, count: i64) -> Vec<Rational> {
        let mut all = between(low, high, count);
        let angle = self.angles.as_ref().and_then(|(a, _)| Some((a, a.domain.as_ref()?)));
        let Some((angles, angle)) = angle else { return all };
        let (start, end) = (self.axis(low), self.axis(high));
        if !start.is_finite() || !end.is_finite() {
            return all;
        }
        for (k, y) in all.iter_mut().enumerate().skip(1).take(count as usize - 1) {
            let place = angles.variable(angle, start + (end - start) * k as f64 / count as f64);
            let fine = (1_i64 << 52) as f64;
            // Next to an infinite tangent the places at equal distances in the variable are good enough.
            if place.abs() < 1024.0 {
                *y = Rational::new((place * fine / 1024.0) as i64, 1 << 42);
            }
        }
        all
    }

    /// The value of a function at a point of the domain; nothing where its denominator vanishes.
    pub(super) fn value(&self, function: usize, at: &[Rational]) -> Option<f64> {
        let formula = self.formulas.get(function)?;
        let value = match &self.angles {
            Some((angles, quotients)) => angles.value(quotients.get(function)?, &self.domain, at),
            None => {
                let mut point = vec![Rational::ZERO; self.width];
                for (var, x) in self.domain.iter().zip(at) {
                    point[var.0] = x.clone();
                }
                formula.eval(&point)?.to_f64()
            }
        };
        value.is_finite().then_some(value)
    }

    /// The values of all functions at a point.
    pub(super) fn values(&self, at: &[Rational]) -> Vec<Option<f64>> {
        (0..self.formulas.len()).map(|k| self.value(k, at)).collect()
    }
}

impl Angles {
    fn new(family: &Family, shapes: &[Rational]) -> Self {
        let analytic = &family.analytic;
        let mut all = Self { base: vec![0.0; family.names.len()], domain: None };
        let put = |base: &mut Vec<f64>, var: Var, value: f64| {
            if base.len() <= var.0 {
                base.resize(var.0 + 1, 0.0);
            }
            base[var.0] = value;
        };
        for (shape, value) in family.shapes.iter().zip(shapes) {
            put(&mut all.base, shape.var, value.to_f64());
        }
        for (var, value) in analytic.floats() {
            put(&mut all.base, var, value);
        }
        for angle in &analytic.angles {
            if family.domain.iter().any(|p| p.var == angle.var) {
                put(&mut all.base, angle.itself, 0.0);
                all.domain = Some(angle.clone());
            } else {
                let y = all.base.get(angle.var.0).copied().unwrap_or(0.0);
                let itself = all.itself(angle, y);
                put(&mut all.base, angle.itself, itself);
            }
        }
        all
    }

    /// The angle s where its variable is y: x = low + width·y is tan ψ, tanh ψ or ψ itself, ψ = v·(s − shift).
    fn itself(&self, angle: &Angle, y: f64) -> f64 {
        let x = quotient(&angle.low, &self.base) + quotient(&angle.width, &self.base) * y;
        let (rate, shift) = speed(angle);
        match angle.kind {
            Kind::Circular => shift + x.atan() / rate,
            Kind::Hyperbolic => shift + x.atanh() / rate,
            Kind::Linear => x,
        }
    }

    /// Where the variable of an angle is when the angle is s.
    fn variable(&self, angle: &Angle, s: f64) -> f64 {
        let (low, width) = (quotient(&angle.low, &self.base), quotient(&angle.width, &self.base));
        let (rate, shift) = speed(angle);
        let x = match angle.kind {
            Kind::Circular => ((s - shift) * rate).tan(),
            Kind::Hyperbolic => ((s - shift) * rate).tanh(),
            Kind::Linear => s,
        };
        (x - low) / width
    }

    fn value(&self, formula: &Quotient, domain: &[Var], at: &[Rational]) -> f64 {
        let mut base = self.base.clone();
        for (var, x) in domain.iter().zip(at) {
            base[var.0] = x.to_f64();
        }
        if let (Some(angle), Some(y)) = (&self.domain, at.first()) {
            base[angle.itself.0] = self.itself(angle, y.to_f64());
            base[angle.var.0] = y.to_f64();
        }
        formula.value(&base)
    }
}

/// The v and the shift of an angle.
fn speed(angle: &Angle) -> (f64, f64) {
    let (rate, shift) = (angle.rate.to_f64(), angle.shift.to_f64());
    let pi = core::f64::consts::PI;
    if angle.turns { (rate * pi, shift) } else { (rate, shift * pi) }
}

/// A fraction in floating point. The tangent of a shape value has many digits, and its powers more than a float has room
/// for: numerator and denominator are divided by their largest coefficient.
struct Quotient {
    numer: Vec<(Monomial, f64)>,
    denom: Vec<(Monomial, f64)>,
}

impl Quotient {
    fn new(f: &Fraction) -> Self {
        let all = f.numer().terms().chain(f.denom().terms());
        let largest = all.map(|(_, c)| c.abs()).max().unwrap_or(Rational::ONE);
        let floats = |poly: &Poly| poly.terms().map(|(m, c)| (m.clone(), (c / &largest).to_f64())).collect();
        Self { numer: floats(f.numer()), denom: floats(f.denom()) }
    }

    fn value(&self, at: &[f64]) -> f64 {
        sum(&self.numer, at) / sum(&self.denom, at)
    }
}

fn quotient(f: &Fraction, at: &[f64]) -> f64 {
    Quotient::new(f).value(at)
}

fn sum(terms: &[(Monomial, f64)], at: &[f64]) -> f64 {
    let term = |(monomial, coefficient): &(Monomial, f64)| {
        let powers = at.iter().enumerate().map(|(k, x)| x.powi(i32::from(monomial.exponent(Var(k)))));
        coefficient * powers.product::<f64>()
    };
    terms.iter().map(term).sum()
}

/// Numbers at equal distances, both ends included.
pub(super) fn between(low: &Rational, high: &Rational, count: i64) -> Vec<Rational> {
    (0..=count).map(|k| low + &(&(high - low) * &Rational::new(k, count))).collect()
}

//! Values of functions at many points, exact and then rounded.

use basis_engine::Family;
use basis_engine::algebra::fraction::Fraction;
use basis_engine::algebra::poly::Var;
use basis_engine::algebra::rational::Rational;

use super::settings::Setting;

/// The functions at some shape values.
pub(super) struct Functions {
    formulas: Vec<Fraction>,
    /// How many variables there are, shape parameters included.
    width: usize,
    /// The domain variables.
    domain: Vec<Var>,
}

impl Functions {
    /// The functions of a family; one whose denominator vanishes is left out of all pictures.
    pub(super) fn new(family: &Family, setting: &Setting) -> Self {
        let at = |f: &Fraction| {
            let mut value = f.clone();
            for (shape, x) in family.shapes.iter().zip(&setting.values) {
                value = value
                    .substitute(shape.var, &Fraction::constant(x.clone()))
                    .unwrap_or_else(Fraction::zero);
            }
            value
        };
        Self {
            formulas: family.functions.iter().map(|f| at(&f.value)).collect(),
            width: family.names.len(),
            domain: family.domain.iter().map(|p| p.var).collect(),
        }
    }

    /// The value of a function at a point of the domain; nothing where its denominator vanishes.
    pub(super) fn value(&self, function: usize, at: &[Rational]) -> Option<f64> {
        let mut point = vec![Rational::ZERO; self.width];
        for (var, x) in self.domain.iter().zip(at) {
            point[var.0] = x.clone();
        }
        let value = self.formulas.get(function)?.eval(&point)?.to_f64();
        value.is_finite().then_some(value)
    }

    /// The values of all functions at a point.
    pub(super) fn values(&self, at: &[Rational]) -> Vec<Option<f64>> {
        (0..self.formulas.len()).map(|k| self.value(k, at)).collect()
    }
}

/// Numbers at equal distances, both ends included.
pub(super) fn between(low: &Rational, high: &Rational, count: i64) -> Vec<Rational> {
    (0..=count).map(|k| low + &(&(high - low) * &Rational::new(k, count))).collect()
}

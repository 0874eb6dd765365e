//! How far floats reach in the shape parameters that stand in sinh, cosh and exp: beyond, an evaluator overflows.
//!
//! Of such a parameter α, coefficients are polynomials in T = tanh(v·α) and R = 1 − T, which is between exp(−2v·α) and
//! 2·exp(−2v·α). The *order* of a coefficient is the power of R that can be divided out of it: as α grows, a
//! coefficient of order e falls like R^e, and the rest goes to its value at T = 1. With Bernstein coefficients w of a
//! denominator W and n of a numerator N, all of degree d and w of one sign, and c = N/W:
//!
//! - |W| is at least the smallest |w|. It has to be a float with all its digits: the largest order of w counts.
//! - |W′/W| ≤ d·max |Δw|/min(wⱼ, wⱼ₊₁), because W is Σ (s·wⱼ + x·wⱼ₊₁) B(d−1, j), and |N′/W| is alike: what counts is the
//!   largest difference of orders between neighbours, of w below to w or n above. The same with second differences and three
//!   neighbours for |N″/W| and |W″/W|.
//! - c′ = N′/W − c·W′/W, and c″ = N″/W − 2c′·W′/W − c·W″/W, so that twice the order of c′ counts as well.
//! - exp(2v·α) itself is computed for R, and exp(2v·(t − low)) for the coordinates of t.
//!
//! Each of these is at most 2ᵇ·exp(Σ q·α) with numbers q ≥ 0, one for each parameter, which is a float where Σ q·α is at most
//! (B − b)·ln 2, B being the largest exponent of the floats. The number b of bits is that of quotients of coefficients without
//! their powers of R, and of what d multiplies.

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::model::angle::{Angle, Kind};
use crate::model::{Family, Parameter};
use crate::plan::form::RationalForm;
use basis_prover::collections::list::Listed;

/// Floats: their name, and the largest exponent with which a number and its reciprocal have all their digits.
pub const FLOATS: [(&str, i64); 2] = [("f64", 1022), ("f32", 126)];

/// Bits for roundings, and for small factors such as those of the coordinates.
const SLACK: i64 = 2;

/// The largest values of a shape parameter with which nothing overflows, in the order of [`FLOATS`]; each is a float of
/// both kinds.
pub type Reach = [Rational; 2];

/// The orders of a coefficient in all shape parameters with exponentials.
type Orders = Vec<i64>;

/// How far floats reach in each shape parameter of a family that is evaluated in these forms, one for each span; `None` where
/// nothing grows with it, or where its declared range ends before.
pub fn reaches(family: &Family, forms: &[RationalForm]) -> Vec<Option<Reach>> {
    let grows = |p: &Parameter| family.analytic.angle(p.var).filter(|a| a.kind == Kind::Hyperbolic);
    let angles: Vec<&Angle> = family.shapes.iter().filter_map(grows).listed();
    let mut needs = Needs { angles: &angles, family, all: Vec::new() };
    if !angles.is_empty() && !forms.is_empty() {
        needs.of_tangents();
        for (k, form) in forms.iter().enumerate() {
            let on_span = family.pieces.get(k).map_or(family, |piece| &**piece);
            needs.of_chart(on_span, form);
            needs.of_form(form);
        }
    }
    let mut places = 0..angles.len();
    let one = |p: &Parameter| {
        let angle = grows(p)?;
        let place = places.next()?;
        let reach = [needs.largest(place, FLOATS[0].1)?, needs.largest(place, FLOATS[1].1)?];
        let high = family.analytic.number(&angle.limits[1]).filter(|_| !angle.ends[1].is_empty());
        let is_short = high.is_none_or(|high| reach.iter().any(|reach| *reach < high));
        is_short.then_some(reach)
    };
    family.shapes.iter().map(one).listed()
}

/// What has to be a float.
struct Needs<'a> {
    angles: &'a [&'a Angle],
    family: &'a Family,
    /// The numbers q, one for each parameter, and b.
    all: Vec<(Vec<Rational>, i64)>,
}

impl Needs<'_> {
    /// The largest value of a parameter, the same for all that grow together.
    fn largest(&self, place: usize, exponent: i64) -> Option<Rational> {
        // Not above ln 2.
        let ln_2 = Rational::new(6931, 10_000);
        let own = self.all.iter().filter(|(q, _)| q[place].is_positive());
        let least = own.filter_map(|(q, bits)| {
            let room = &Rational::from((exponent - bits).max(0)) * &ln_2;
            room.checked_div(&q.iter().fold(Rational::ZERO, |sum, q| &sum + q))
        });
        least.min().map(|least| short(&least))
    }

    /// A power of all R: of none that is negative.
    fn of_orders(&mut self, orders: &Orders, bits: i64) {
        let q = orders
            .iter()
            .zip(self.angles)
            .map(|(order, angle)| &(&angle.speed() * &Rational::from(2)) * &Rational::from((*order).max(0)));
        let q = q.listed();
        self.all.push((q, bits));
    }

    /// Each R.
    fn of_tangents(&mut self) {
        for place in 0..self.angles.len() {
            let orders = (0..self.angles.len()).map(|k| i64::from(k == place)).listed();
            self.of_orders(&orders, SLACK);
        }
    }

    /// The coordinates of t between hyperbolic ends: exp(2Δ), and what is beside exp(−2ψ0) in powers up to the degree.
    fn of_chart(&mut self, family: &Family, form: &RationalForm) {
        let chart = family.analytic.angle(form.numerators.var).filter(|a| a.kind == Kind::Hyperbolic);
        let Some(chart) = chart else { return };
        let twice = &chart.speed() * &Rational::from(2);
        let slopes = |end: &Fraction| self.angles.iter().map(|a| slope(end, a.itself)).listed();
        let [low, high] = chart.limits.each_ref().map(slopes);
        let width = low.iter().zip(&high).map(|(low, high)| &twice * &(high - low).abs()).listed();
        let degree = Rational::from(i64::from(form.numerators.degree.max(2)));
        let below = low.iter().map(|low| &(&twice * &degree) * &(-low).max(Rational::ZERO)).listed();
        self.all.extend([(width, SLACK), (below, SLACK)]);
    }

    /// The denominator, and the values with two derivatives.
    fn of_form(&mut self, form: &RationalForm) {
        let degree = i64::from(form.numerators.degree);
        let (mut least, mut most) = (i64::MAX, i64::MIN);
        let mut table = |coefficients: &[Poly], below: &Poly, divides: bool| {
            let (below, [smallest, largest]) = self.order(below)?;
            let one = |p: &Poly| {
                let (above, [low, high]) = self.order(p)?;
                if divides {
                    least = least.min(low - largest);
                }
                most = most.max(high - smallest);
                Some(above.iter().zip(&below).map(|(above, below)| above - below).listed())
            };
            Some(coefficients.iter().map(one).listed())
        };
        let Some(w) = table(&form.denominator.bernstein, &form.denominator.denom, true) else { return };
        let rows = form.numerators.functions.iter();
        let rows = rows.filter_map(|f| table(&f.bernstein, &f.denom, false)).listed();
        if least > most {
            return;
        }
        let denoms = form.numerators.functions.iter().map(|f| &f.denom).chain([&form.denominator.denom]);
        let divisors = denoms.filter_map(|denom| self.order(denom)).listed();
        for orders in w.iter().flatten() {
            self.of_orders(orders, (-least).max(0) + SLACK);
        }
        for (orders, [low, _]) in &divisors {
            self.of_orders(orders, (-low).max(0) + SLACK);
        }
        // |c′| ≤ 4d·2ᵇ and |c″| ≤ 8d²·2ᵇ + 16d²·4ᵇ, with 2ᵇ for quotients of coefficients.
        let (bits, factor) = (most - least, i64::from(64 - degree.leading_zeros()));
        let bits = [bits, bits + factor + 2, 2 * bits.max(0) + 2 * factor + 5].map(|b| b.max(0) + SLACK);
        let mut growth = [0, 1, 2].map(|_| vec![0; self.angles.len()]);
        for row in rows.iter().chain([&w]) {
            for (derivative, growth) in growth.iter_mut().enumerate() {
                let places = w.len().saturating_sub(derivative);
                for j in 0..places {
                    let below = w[j..=j + derivative].iter().flatten();
                    let above = below.clone().chain(row[j..=j + derivative].iter().flatten());
                    let (below, above) = (extreme(below, i64::max), extreme(above, i64::min));
                    let (Some(below), Some(above)) = (below, above) else { continue };
                    for (k, growth) in growth.iter_mut().enumerate() {
                        *growth = (*growth).max(below[k] - above[k]);
                    }
                }
            }
        }
        let [value, first, second] = growth;
        let twice = first.iter().zip(&second).map(|(first, second)| (2 * first).max(*second)).listed();
        for (orders, bits) in [value, first, twice].iter().zip(bits) {
            self.of_orders(orders, bits);
        }
    }

    /// The orders of a coefficient, and the binary exponents between which the rest is; `None` of 0.
    fn order(&self, p: &Poly) -> Option<(Orders, [i64; 2])> {
        if p.is_zero() {
            return None;
        }
        let mut rest = p.clone();
        let mut orders = Vec::new();
        for angle in self.angles {
            let complement = &Poly::one() - &Poly::var(angle.var);
            let mut order = 0;
            while let Some(quotient) = rest.div_exact(&complement) {
                rest = quotient;
                order += 1;
            }
            orders.push(order);
        }
        let end = self.angles.iter().fold(rest.clone(), |rest, a| rest.at(a.var, &Rational::ONE));
        let size = match self.family.analytic.number(&Fraction::from(end)) {
            Some(value) => size(&value),
            // Of other shape values as well: as where these are 1.
            None => rest.terms().map(|(_, c)| size(c)).reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])?,
        };
        Some((orders, size))
    }
}

/// The largest or smallest order in each parameter.
fn extreme<'a>(all: impl Iterator<Item = &'a Orders>, which: fn(i64, i64) -> i64) -> Option<Orders> {
    all.cloned().reduce(|a, b| a.iter().zip(&b).map(|(a, b)| which(*a, *b)).listed())
}

/// Numbers with 2^a ≤ |x| ≤ 2^b.
fn size(x: &Rational) -> [i64; 2] {
    let bits = |n: Rational| i64::try_from(n.bits()).unwrap_or(i64::MAX / 8);
    let (above, below) = (bits(x.numer()), bits(x.denom()));
    [above - below - 1, above - below + 1]
}

/// The factor of a variable in an end of a domain.
fn slope(end: &Fraction, var: Var) -> Rational {
    let Some(end) = end.as_poly() else { return Rational::ZERO };
    let own = end.terms().find(|(m, _)| m.total_degree() == 1 && m.exponent(var) == 1);
    own.map_or(Rational::ZERO, |(_, c)| c.clone())
}

/// Not above a number, and short to write: quarters from 8 on, below these 64ths, which every float has.
fn short(x: &Rational) -> Rational {
    let parts = Rational::from(if *x < Rational::from(8) { 64 } else { 4 });
    (x * &parts).floor().checked_div(&parts).unwrap_or(Rational::ZERO)
}

/// A reach as a decimal number.
pub fn decimal(reach: &Rational) -> String {
    // It has few binary digits.
    reach.to_f64().to_string()
}

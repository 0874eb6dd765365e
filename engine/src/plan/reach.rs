//! How far floats reach in the shape parameters that stand in sinh, cosh and exp: beyond, an evaluator overflows.
//!
//! Of such a parameter α, coefficients are polynomials in T = tanh(v·α). Where α may grow without end, R = 1 − T falls with it,
//! between exp(−2v·α) and 2·exp(−2v·α); where it may fall without end, 1 + T does so as well, with −α for α. Such an end of a range
//! is a *side*, and R its distance from T; all R are at most 2, and evaluators compute them without differences.
//!
//! Above a coefficient c stands a product Π R^a of the powers of R that can be divided out: |c| ≤ 2ʰ·Π R^a. Below it stands another
//! one, |c| ≥ 2ˡ·Π R^e. The rest after these divisions
//!
//! - is not 0 at any corner, where each T is at its end: then e = a, as the rest goes to a number other than 0;
//! - or it is, such as 1 − T₁T₂. It is Σ c(k) Π s^(d−k) x^k in the distances s, x from both ends, with c(k) ≥ 0 for all shape values,
//!   and so is at least each of its terms. Every term with a number c(k) > 0 gives an e: of R₁ + T₁R₂ there are two, (1, 0)
//!   and (0, 1), and any of them may be used. Evaluators compute that very sum (file `corners`), so that its digits
//!   are there; the numbers x = T that are not distances from a side go to 1.
//! - Where the signs of c(k) are not known, every monomial in R has to be seen beside 1: what follows holds with e = a and the
//!   number of digits in place of the largest exponent.
//!
//! With Bernstein coefficients w of a denominator W and n of a numerator N, all of degree d and w of one sign, and c = N/W:
//!
//! - |W| is at least the smallest |w|, which has to be a float with all its digits.
//! - |c| is at most the largest |n|/|w| of one place, as N/W = Σ (n/w)·wB / Σ wB.
//! - |W′/W| ≤ d·max |Δw|/min(wⱼ, wⱼ₊₁), because W is Σ (s·wⱼ + x·wⱼ₊₁) B(d−1, j), and |N′/W| is alike: what counts is the
//!   largest quotient between neighbours. The same with second differences and three neighbours for |N″/W| and |W″/W|.
//! - c′ = N′/W − c·W′/W is computed as (N′ − c·W′)/W, and c″ as (N″ − 2c′·W′ − c·W″)/W. With V for the larger of |c| and 1, and F and S
//!   for the first and second quotients, the terms of c′ are at most V·F, and those of c″ at most V·F² and V·S.
//! - 1/R = (1 + exp(2v·α))/2 itself is computed for R, and exp(2v·(t − low)) for the coordinates of t. Derivatives in t are
//!   multiplied by powers of the slope of a coordinate, the rate v or the reciprocal of the domain's width.
//!
//! Each of these is at most 2ᵇ·exp(Σ q·|α|) with numbers q ≥ 0, one for each side, which is a float where Σ q·|α| is at most
//! (B − b)·ln 2, B being the largest exponent of the floats. With Σ q the sum over the parameters, of each the larger of its
//! sides, that holds where each |α| is at most (B − b)·ln 2/Σ q. The number b of bits is that of quotients of coefficients without
//! their powers of R, and of what d multiplies.

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::rational::{Rational, ToFloat as _};
use crate::decimals;
use crate::model::angle::{Angle, Kind};
use crate::model::{Family, Parameter};
use crate::plan::corners::{Corners, by_distances, tangent_ends};
use crate::plan::interval::form::RationalForm;
use crate::plan::sign::has_one_sign;
use basis_prover::collections::list::Listed;

/// Floats: their name, the largest exponent with which a number and its reciprocal have all their digits, and the number of
/// these.
pub const FLOATS: [(&str, i64, i64); 2] = [("f64", 1022, 52), ("f32", 126, 23)];

/// Bits for roundings, and for small factors such as those of the coordinates.
const SLACK: i64 = 2;

/// The smallest and the largest values of a shape parameter with which nothing overflows, each in the order of [`FLOATS`], and
/// each a float of both kinds; `None` where the declared range ends before.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reach {
    /// From where on.
    pub low: Option<[Rational; 2]>,
    /// Up to where.
    pub high: Option<[Rational; 2]>,
}

/// The orders of a coefficient, one for each side.
type Orders = Vec<i64>;

/// How far floats reach in each shape parameter of a family that is evaluated in these forms, one for each span; `None` where
/// nothing grows with it, or where its declared range ends before.
pub fn reaches(family: &Family, forms: &[RationalForm]) -> Vec<Option<Reach>> {
    let grows = |p: &Parameter| family.analytic.angle(p.var).filter(|a| a.kind == Kind::Hyperbolic);
    let mut sides = Vec::new();
    for p in &family.shapes {
        let Some(angle) = grows(p) else { continue };
        for is_high in [false, true] {
            if !tangent_ends(p)[usize::from(is_high)].is_zero() {
                sides.push(Side { angle, is_high });
            }
        }
    }
    let mut needs =
        Needs { sides: &sides, family, corners: Corners::of(family), all: Vec::new(), beside: Vec::new() };
    if !sides.is_empty() && !forms.is_empty() {
        needs.of_tangents();
        for (k, form) in forms.iter().enumerate() {
            let on_span = family.pieces.get(k).map_or(family, |piece| &**piece);
            needs.of_chart(on_span, form);
            needs.of_form(form);
        }
    }
    let one = |p: &Parameter| {
        let angle = grows(p)?;
        let [low, high] = [false, true].map(|is_high| {
            let place =
                sides.iter().position(|side| side.angle.var == angle.var && side.is_high == is_high)?;
            let [double, single] = &FLOATS;
            let reach = [needs.largest(place, double)?, needs.largest(place, single)?];
            let end = usize::from(is_high);
            let limit = family.analytic.number(&angle.limits[end]).filter(|_| !angle.ends[end].is_empty());
            let is_short = limit.is_none_or(|limit| {
                let far = if is_high { limit } else { -&limit };
                reach.iter().any(|reach| *reach < far)
            });
            is_short
                .then(|| reach.each_ref().map(|reach| if is_high { short(reach) } else { -&short(reach) }))
        });
        (low.is_some() || high.is_some()).then_some(Reach { low, high })
    };
    family.shapes.iter().map(one).listed()
}

/// An end of the range of a tangent at 1 or −1.
struct Side<'a> {
    angle: &'a Angle,
    is_high: bool,
}

impl Side<'_> {
    /// R
    fn distance(&self) -> Poly {
        let tangent = Poly::var(self.angle.var);
        if self.is_high { &Poly::one() - &tangent } else { &Poly::one() + &tangent }
    }
}

/// What bounds a coefficient.
struct Size {
    /// |c| ≤ 2^h Π R^a.
    above: Orders,
    /// |c| ≥ 2^l Π R^e for each of these.
    below: Vec<Orders>,
    /// l and h.
    bits: [i64; 2],
}

/// What has to be a float.
struct Needs<'a> {
    sides: &'a [Side<'a>],
    family: &'a Family,
    corners: Corners,
    /// The numbers q, one for each side, and b.
    all: Vec<(Vec<Rational>, i64)>,
    /// The same of what has to be seen beside 1.
    beside: Vec<(Vec<Rational>, i64)>,
}

impl Needs<'_> {
    /// The largest size of a parameter on a side, the same for all that grow together.
    fn largest(&self, place: usize, &(_, exponent, digits): &(&str, i64, i64)) -> Option<Rational> {
        // Not above ln 2.
        let ln_2 = Rational::new(6931, 10_000);
        let largest = |most: i64, (q, bits): &(Vec<Rational>, i64)| {
            if !q[place].is_positive() {
                return None;
            }
            (&Rational::from((most - bits).max(0)) * &ln_2).checked_div(&self.total(q))
        };
        let within = self.all.iter().filter_map(|need| largest(exponent, need));
        let beside = self.beside.iter().filter_map(|need| largest(digits, need));
        within.chain(beside).min()
    }

    /// Of each parameter the larger of its sides, and the sum of these.
    fn total(&self, q: &[Rational]) -> Rational {
        let mut sum = Rational::ZERO;
        for (k, side) in self.sides.iter().enumerate() {
            let other = self.sides[..k].iter().position(|other| other.angle.var == side.angle.var);
            let known = other.map_or(&Rational::ZERO, |other| &q[other]);
            sum += &(&q[k] - known).max(Rational::ZERO);
        }
        sum
    }

    /// The numbers q of a product of powers of 1/R, of which those that are not positive are left out.
    fn rates(&self, orders: &[i64]) -> Vec<Rational> {
        let twice = |side: &Side<'_>| &side.angle.speed() * &Rational::from(2);
        let rates = orders.iter().zip(self.sides);
        rates.map(|(order, side)| &twice(side) * &Rational::from((*order).max(0))).listed()
    }

    fn of_orders(&mut self, orders: &[i64], bits: i64) {
        let q = self.rates(orders);
        self.all.push((q, bits));
    }

    /// Each R.
    fn of_tangents(&mut self) {
        for place in 0..self.sides.len() {
            let orders = (0..self.sides.len()).map(|k| i64::from(k == place)).listed();
            self.of_orders(&orders, SLACK);
        }
    }

    /// The coordinates of t between hyperbolic ends: exp(2Δ), and what is beside exp(−2ψ0) in powers up to the degree.
    fn of_chart(&mut self, family: &Family, form: &RationalForm) {
        let chart = family.analytic.angle(form.numerators.var).filter(|a| a.kind == Kind::Hyperbolic);
        let Some(chart) = chart else { return };
        let twice = &chart.speed() * &Rational::from(2);
        // Outwards on each side.
        let slopes = |end: &Fraction| {
            let one = |side: &Side<'_>| {
                let slope = slope(end, side.angle.itself);
                if side.is_high { slope } else { -slope }
            };
            self.sides.iter().map(one).listed()
        };
        let [low, high] = chart.limits.each_ref().map(slopes);
        let width = low.iter().zip(&high).map(|(low, high)| &twice * &(high - low).abs()).listed();
        let degree = Rational::from(i64::from(form.numerators.degree.max(2)));
        let below = low.iter().map(|low| &(&twice * &degree) * &(-low).max(Rational::ZERO)).listed();
        self.all.extend([(width, SLACK), (below, SLACK)]);
    }

    /// Bits of the slope of a coordinate of t, if that is more than 1.
    fn slope_bits(&self, form: &RationalForm) -> i64 {
        let slope = match self.family.analytic.angle(form.numerators.var) {
            Some(chart) if chart.kind != Kind::Linear => &chart.speed() * &Rational::from(2),
            // Between ends that grow it falls.
            Some(_) => Rational::ONE,
            None => (&form.numerators.high - &form.numerators.low).recip().unwrap_or(Rational::ONE),
        };
        size(&slope)[1].max(0)
    }

    /// The denominator, and the values with two derivatives.
    fn of_form(&mut self, form: &RationalForm) {
        let degree = i64::from(form.numerators.degree);
        let (mut least, mut most) = (i64::MAX, i64::MIN);
        let mut beside = Vec::new();
        let mut of = |p: &Poly| self.size(p, &mut beside);
        let mut table = |coefficients: &[Poly], below: &Poly, divides: bool| {
            let divisor = of(below)?;
            let mut one = |p: &Poly| {
                let size = of(p)?;
                if divides {
                    least = least.min(size.bits[0] - divisor.bits[1]);
                }
                most = most.max(size.bits[1] - divisor.bits[0]);
                let by = |orders: &Orders, divisor: &Orders| {
                    orders.iter().zip(divisor).map(|(a, b)| a - b).listed()
                };
                // A divisor has factors only, and no other bounds.
                let above = divisor.below.first().map_or_else(|| size.above.clone(), |b| by(&size.above, b));
                let below = size.below.iter().map(|e| by(e, &divisor.above)).listed();
                Some(Size { above, below, bits: size.bits })
            };
            Some(coefficients.iter().map(&mut one).listed())
        };
        let Some(w) = table(&form.denominator.bernstein, &form.denominator.denom, true) else { return };
        let mut rows = Vec::new();
        for f in &form.numerators.functions {
            rows.extend(table(&f.bernstein, &f.denom, false));
        }
        if least > most {
            return;
        }
        let denoms = form.numerators.functions.iter().map(|f| &f.denom).chain([&form.denominator.denom]);
        let divisors = denoms.filter_map(&mut of).listed();
        self.beside.extend(beside);
        for size in w.iter().flatten() {
            self.of_orders(&self.least(size, &vec![0; self.sides.len()]), (-least).max(0) + SLACK);
        }
        for size in &divisors {
            self.of_orders(&self.least(size, &vec![0; self.sides.len()]), (-size.bits[0]).max(0) + SLACK);
        }
        // |c| ≤ V, V|F| ≤ 2d·4ᵇ, and V|F|² ≤ 8d²·8ᵇ, with 2ᵇ for quotients of coefficients.
        let (bits, factor) = ((most - least).max(0), i64::from(64 - degree.leading_zeros()));
        let slope = self.slope_bits(form);
        let bits = [bits, 2 * bits + factor + slope + 2, 3 * bits + 2 * (factor + slope) + 5];
        let mut growth = [0, 1, 2].map(|_| vec![0; self.sides.len()]);
        for row in rows.iter().chain([&w]) {
            for (derivative, growth) in growth.iter_mut().enumerate() {
                for j in 0..w.len().saturating_sub(derivative) {
                    let near = j..=j + derivative;
                    let others = if derivative == 0 { &[][..] } else { &w[near.clone()] };
                    for below in w[near.clone()].iter().flatten() {
                        // Divided by itself it is 1.
                        let above = row[near.clone()].iter().chain(others).flatten();
                        for above in above.filter(|above| !core::ptr::eq(*above, below)) {
                            let quotient = self.least(below, &above.above);
                            for (growth, order) in growth.iter_mut().zip(quotient) {
                                *growth = (*growth).max(order);
                            }
                        }
                    }
                }
            }
        }
        let [value, first, second] = growth;
        let sum = |a: &Orders, b: &Orders| a.iter().zip(b).map(|(a, b)| a + b).listed();
        let twice = first.iter().zip(&second).map(|(first, second)| (2 * first).max(*second)).listed();
        let (first, second) = (sum(&value, &first), sum(&value, &twice));
        for (orders, bits) in [value, first, second].iter().zip(bits) {
            self.of_orders(orders, bits + SLACK);
        }
    }

    /// The orders of 1/c · Π R^a, those that are positive: with the bound below c that lets them grow least.
    fn least(&self, size: &Size, above: &Orders) -> Orders {
        let all = size.below.iter();
        let all = all.map(|below| below.iter().zip(above).map(|(e, a)| (e - a).max(0)).listed());
        let growth = |orders: &Orders| self.total(&self.rates(orders));
        all.min_by(|a, b| growth(a).cmp(&growth(b))).unwrap_or_else(|| vec![0; self.sides.len()])
    }

    /// The bounds of a coefficient; `None` of 0. What has to be seen beside 1 is added to a list.
    fn size(&self, p: &Poly, beside: &mut Vec<(Vec<Rational>, i64)>) -> Option<Size> {
        if p.is_zero() {
            return None;
        }
        let mut rest = p.clone();
        let mut above = Vec::new();
        for side in self.sides {
            let distance = side.distance();
            let mut order = 0;
            while let Some(quotient) = rest.div_exact(&distance) {
                rest = quotient;
                order += 1;
            }
            above.push(order);
        }
        // Each R may be 2.
        let twos: i64 = above.iter().sum();
        if !self.corners.cancels(&rest) {
            let [low, high] = self.at_corners(&rest)?;
            return Some(Size { below: vec![above.clone()], above, bits: [low, high + twos] });
        }
        let terms = if self.corners.is_short(&rest) {
            self.by_distances(rest.clone())
        } else {
            vec![(vec![0; self.sides.len()], rest.clone())]
        };
        let coefficients = terms.iter().map(|(_, c)| c.clone()).listed();
        let (mut below, mut bits) = (Vec::new(), [i64::MAX, i64::MIN]);
        let is_known = terms.len() > 1 && has_one_sign(&coefficients, &self.family.shape_region());
        for (orders, c) in &terms {
            let Some([low, high]) = self.at_corners(c) else { continue };
            bits[1] = bits[1].max(high + orders.iter().sum::<i64>());
            if is_known && !self.corners.vanishes(c, &rest) {
                bits[0] = bits[0].min(low);
                below.push(above.iter().zip(orders).map(|(a, order)| a + order).listed());
            }
        }
        // The number of terms.
        bits[1] += i64::from(64 - terms.len().leading_zeros()) + twos;
        if below.is_empty() {
            let degrees = self.sides.iter().map(|side| i64::from(rest.degree(side.angle.var))).listed();
            beside.push((self.rates(&degrees), SLACK));
            bits[0] = self.at_corners(&rest).map_or(bits[1], |[low, _]| low);
            below.push(above.clone());
        }
        Some(Size { above, below, bits })
    }

    /// A polynomial as a sum of products of distances with coefficients that have no tangents: the orders in R, and these.
    fn by_distances(&self, p: Poly) -> Vec<(Orders, Poly)> {
        let mut all = vec![(vec![0; self.sides.len()], p)];
        while let Some(k) = all.iter().position(|(_, p)| self.corners.tangent(p).is_some()) {
            let (orders, p) = all.swap_remove(k);
            let Some((var, ends)) = self.corners.tangent(&p) else { continue };
            let coefficients = by_distances(&p, var, ends);
            let degree = coefficients.len() - 1;
            for (k, c) in coefficients.into_iter().enumerate().filter(|(_, c)| !c.is_zero()) {
                let mut orders = orders.clone();
                for (order, side) in orders.iter_mut().zip(self.sides).filter(|(_, s)| s.angle.var == var) {
                    *order += if side.is_high { degree - k } else { k } as i64;
                }
                all.push((orders, c));
            }
        }
        all
    }

    /// Binary exponents between which a polynomial is at the corners where it is not 0; `None` where it is 0 at all.
    fn at_corners(&self, p: &Poly) -> Option<[i64; 2]> {
        let values = self.corners.values(p);
        let of_values = values.iter().filter(|value| !value.is_zero()).map(size);
        let wider = |a: [i64; 2], b: [i64; 2]| [a[0].min(b[0]), a[1].max(b[1])];
        // With too many corners the coefficients.
        let of_terms = || p.terms().map(|(_, c): (&Monomial, &Rational)| size(c)).reduce(wider);
        of_values.reduce(wider).or_else(of_terms)
    }
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

/// Not above a number, and short to write: quarters from 8 on, below these 64ths, and of numbers below 1 about ten binary digits.
/// Every float has them.
fn short(x: &Rational) -> Rational {
    /// Smaller numbers are 0.
    const LEAST: i64 = -100;
    let parts = if *x >= Rational::from(8) {
        Rational::from(4)
    } else if *x >= Rational::ONE || !x.is_positive() {
        Rational::from(64)
    } else {
        let exponent = size(x)[1].clamp(LEAST, 0);
        Rational::from(2).pow(u32::try_from(10 - exponent).unwrap_or(10))
    };
    (x * &parts).floor().checked_div(&parts).unwrap_or(Rational::ZERO)
}

/// A reach as a decimal number.
pub fn decimal(reach: &Rational) -> String {
    // It has few binary digits.
    decimals::of_float(reach.to_f64()).trim_end_matches(".0").to_string()
}

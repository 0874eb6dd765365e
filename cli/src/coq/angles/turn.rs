//! The angle of a family, linear in the domain variable, and sin and cos of it in the tangent of its half.

use std::rc::Rc;

use basis_engine::Family;
use basis_engine::algebra::rational::Rational;
use basis_engine::formulas::{Circular, Role, Sign, Term};
use basis_engine::model::angle::Angle;

use super::super::formula::Writer;

/// The angle of a family: φ = a·t + b, where t is the domain variable.
pub(in crate::coq) struct Turn<'a> {
    pub(super) angle: &'a Angle,
    /// a without π, and whether π is a factor.
    rate: Rational,
    turns: bool,
    /// b/π.
    pub(super) shift: Rational,
}

impl<'a> Turn<'a> {
    /// The only angle of a family, if it has one.
    pub(in crate::coq) fn of(family: &'a Family) -> Option<Self> {
        let [angle] = family.analytic.angles.as_slice() else { return None };
        let rate = &angle.rate + &angle.rate;
        let shift = -&(&rate * &angle.shift);
        Some(Self { angle, rate, turns: angle.turns, shift })
    }

    /// a as a formula.
    pub(super) fn slope(&self) -> Term {
        let rate = Term::Number(self.rate.clone());
        if self.turns { rate.by(Term::Pi) } else { rate }
    }

    /// a and b as texts.
    pub(super) fn factors(&self) -> (String, String) {
        let writer = Writer { definitions: &[], variables: &|_| None };
        let shift = Term::Number(self.shift.clone()).by(Term::Pi);
        (writer.argument(&self.slope()), writer.argument(&shift))
    }

    /// a·t + b as text.
    pub(super) fn text(&self, t: &str) -> String {
        let (slope, shift) = self.factors();
        format!("{slope} * {t} + {shift}")
    }

    /// tan(φ/2) as text.
    pub(super) fn tangent_text(&self, t: &str) -> String {
        format!("tan (({}) / 2)", self.text(t))
    }

    /// k if an angle, linear in the domain variable, is k·φ.
    pub(super) fn multiple(&self, argument: &Linear) -> Option<i64> {
        let own = if self.turns { &argument.turning } else { &argument.plain };
        let other = if self.turns { &argument.plain } else { &argument.turning };
        let k = own.checked_div(&self.rate)?;
        let fits = other.is_zero() && argument.number.is_zero() && argument.pi == &k * &self.shift;
        if fits { k.to_i64() } else { None }
    }

    /// tan(φ/2) at a place that is a number, where that is −1, 0 or 1.
    pub(super) fn tangent_at(&self, at: &Linear) -> Option<i64> {
        if !at.plain.is_zero() || !at.turning.is_zero() {
            return None;
        }
        let (own, other) = if self.turns { (&at.number, &at.pi) } else { (&at.pi, &at.number) };
        if !other.is_zero() {
            return None;
        }
        let quarters = &(&(own * &self.rate) + &self.shift) * &Rational::from(2);
        quarters.to_i64().filter(|k| (-1..=1).contains(k))
    }

    /// k if the angle at a place c − t is k·π/2 − φ, where that is −1, 0 or 1.
    pub(super) fn reflection(&self, at: &Linear) -> Option<i64> {
        let (own, other) = if self.turns { (&at.number, &at.pi) } else { (&at.pi, &at.number) };
        if !at.turning.is_zero() || at.plain != -&Rational::ONE || !other.is_zero() {
            return None;
        }
        let twice = &self.shift + &self.shift;
        let quarters = &(&(own * &self.rate) + &twice) * &Rational::from(2);
        quarters.to_i64().filter(|k| (-1..=1).contains(k))
    }
}

/// tan((k·π/2 − φ)/2) = (tan(k·π/4) − x)/(1 + tan(k·π/4)·x), as a formula in x.
pub(super) fn reflected(k: i64, x: &Term) -> Term {
    let product = Term::integer(k).by(x.clone());
    let below = Term::Sum(vec![(Sign::Plus, Term::integer(1)), (Sign::Plus, product)]);
    Term::Product(vec![(Role::Factor, Term::integer(k).minus(x.clone())), (Role::Divisor, below)])
}

/// p·t + q·π·t + r·π + s.
#[derive(Clone)]
pub(super) struct Linear {
    plain: Rational,
    turning: Rational,
    pi: Rational,
    number: Rational,
}

impl Linear {
    const ZERO: Self =
        Self { plain: Rational::ZERO, turning: Rational::ZERO, pi: Rational::ZERO, number: Rational::ZERO };

    /// A formula as a sum of these; `None` for any other.
    pub(super) fn of(term: &Term, variable: usize) -> Option<Self> {
        Some(match term {
            Term::Number(n) => Self { number: n.clone(), ..Self::ZERO },
            Term::Pi => Self { pi: Rational::ONE, ..Self::ZERO },
            Term::Variable(v) if *v == variable => Self { plain: Rational::ONE, ..Self::ZERO },
            Term::Neg(x) => Self::of(x, variable)?.scaled(&-&Rational::ONE),
            Term::Sum(parts) => {
                let mut sum = Self::ZERO;
                for (sign, part) in parts {
                    let sign = if *sign == Sign::Minus { -&Rational::ONE } else { Rational::ONE };
                    let part = Self::of(part, variable)?.scaled(&sign);
                    sum.plain += &part.plain;
                    sum.turning += &part.turning;
                    sum.pi += &part.pi;
                    sum.number += &part.number;
                }
                sum
            }
            Term::Product(parts) => {
                let mut product = Self { number: Rational::ONE, ..Self::ZERO };
                for (role, part) in parts {
                    let part = Self::of(part, variable)?;
                    product = match role {
                        Role::Factor => product.times(&part)?,
                        Role::Divisor => product.scaled(&part.as_number()?.recip()?),
                    };
                }
                product
            }
            _ => return None,
        })
    }

    fn as_number(&self) -> Option<&Rational> {
        (self.plain.is_zero() && self.turning.is_zero() && self.pi.is_zero()).then_some(&self.number)
    }

    fn scaled(&self, by: &Rational) -> Self {
        Self {
            plain: &self.plain * by,
            turning: &self.turning * by,
            pi: &self.pi * by,
            number: &self.number * by,
        }
    }

    fn times(&self, other: &Self) -> Option<Self> {
        if let Some(n) = other.as_number() {
            return Some(self.scaled(n));
        }
        if let Some(n) = self.as_number() {
            return Some(other.scaled(n));
        }
        // π·t and no other product.
        let is_pi = |x: &Self| x.plain.is_zero() && x.turning.is_zero() && x.number.is_zero();
        let (pi, t) = if is_pi(self) { (self, other) } else { (other, self) };
        let only = is_pi(pi) && t.turning.is_zero() && t.pi.is_zero() && t.number.is_zero();
        only.then(|| Self { turning: &pi.pi * &t.plain, ..Self::ZERO })
    }
}

/// 2x/(1 + x²), (1 − x²)/(1 + x²), and the same of twice the angle.
pub(super) fn circular(f: Circular, k: i64, x: &Term) -> Option<Term> {
    let square = Term::Power(Rc::new(x.clone()), 2);
    let below = || Term::Sum(vec![(Sign::Plus, Term::integer(1)), (Sign::Plus, square.clone())]);
    let over = |above: Vec<(Role, Term)>| {
        Term::Product(above.into_iter().chain([(Role::Divisor, below())]).collect())
    };
    let sine = || over(vec![(Role::Factor, Term::integer(2)), (Role::Factor, x.clone())]);
    let cosine = || over(vec![(Role::Factor, Term::integer(1).minus(square.clone()))]);
    let squared = |x: Term| Term::Power(Rc::new(x), 2);
    Some(match (f, k) {
        (Circular::Sin, 1) => sine(),
        (Circular::Cos, 1) => cosine(),
        (Circular::Sin, 2) => Term::Product(vec![
            (Role::Factor, Term::integer(2)),
            (Role::Factor, sine()),
            (Role::Factor, cosine()),
        ]),
        (Circular::Cos, 2) => squared(cosine()).minus(squared(sine())),
        _ => return None,
    })
}

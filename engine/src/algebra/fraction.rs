//! Rational functions: quotients of polynomials in lowest terms.

use core::cell::RefCell;
use core::ops::{Add, Mul, Neg, Sub};

use basis_kernel::Quotient;

use super::divisors::gcd::{checked_gcd, checked_quotient, content};
use super::poly::{Poly, PolyExt, Var};
use super::rational::Rational;
use super::work::{Spent, Work};

/// numerator / denominator.
///
/// The denominator is not zero, has whole coefficients without a common factor and a positive leading
/// coefficient, and shares no factor with the numerator; so equal functions are equal as data.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fraction {
    numer: Poly,
    denom: Poly,
}

impl Fraction {
    /// 0.
    pub fn zero() -> Self {
        Self::from(Poly::zero())
    }

    /// A number.
    pub fn constant(value: Rational) -> Self {
        Self::from(Poly::constant(value))
    }

    /// A variable.
    pub fn var(var: Var) -> Self {
        Self::from(Poly::var(var))
    }

    /// The quotient of two polynomials; `None` when the divisor is zero.
    pub fn new(numer: Poly, denom: Poly) -> Option<Self> {
        if denom.is_zero() {
            return None;
        }
        Self::reduced(numer, denom, &mut Work::unlimited())
    }

    /// The quotient of two polynomials, the divisor not zero; `None` when the work is spent.
    fn reduced(numer: Poly, denom: Poly, work: &mut Work) -> Option<Self> {
        if let Some(c) = denom.as_constant() {
            return Some(Self::from(if c.is_one() { numer } else { numer.scale(&c.recip()?) }));
        }
        if let Some(quotient) = checked_quotient(&numer, &denom, work).ok()? {
            return Some(Self::from(quotient));
        }
        let Split { numer, denom, apart } = Split::new(numer, denom, work)?;
        let common = checked_gcd(&numer, &denom, work)?;
        let (numer, denom) = if common.is_one() {
            (numer, denom)
        } else {
            // The greatest common divisor divides both.
            (numer.div_exact(&common)?, denom.div_exact(&common)?)
        };
        Self::normalized(&numer, &apart.iter().fold(denom, |denom, factor| &denom * factor))
    }

    /// The quotient of two polynomials without a common divisor.
    pub(crate) fn normalized(numer: &Poly, denom: &Poly) -> Option<Self> {
        let whole = denom.normalized();
        // `denom` is a number times `whole`.
        let factor = denom.div_exact(&whole)?.as_constant()?.recip()?;
        Some(Self { numer: numer.scale(&factor), denom: whole })
    }

    /// The polynomial above the fraction line.
    pub const fn numer(&self) -> &Poly {
        &self.numer
    }

    /// The polynomial below the fraction line.
    pub const fn denom(&self) -> &Poly {
        &self.denom
    }

    /// As the kernel has it.
    pub fn quotient(&self) -> Quotient {
        Quotient { numerator: self.numer().clone(), denominator: self.denom().clone() }
    }

    /// Whether the function is 0.
    pub fn is_zero(&self) -> bool {
        self.numer.is_zero()
    }

    /// The polynomial that the function is, if nothing stands below the fraction line.
    pub fn as_poly(&self) -> Option<&Poly> {
        self.denom.is_one().then_some(&self.numer)
    }

    /// The number that the function is, if no variable occurs.
    pub fn as_constant(&self) -> Option<Rational> {
        self.as_poly()?.as_constant()
    }

    /// The variable that the function is, if it is one.
    pub fn as_var(&self) -> Option<Var> {
        let poly = self.as_poly().filter(|p| p.len() == 1)?;
        let (m, c) = poly.leading_term()?;
        (c.is_one() && m.total_degree() == 1).then(|| Var(m.width() - 1))
    }

    /// Whether a variable occurs.
    pub fn depends_on(&self, var: Var) -> bool {
        self.numer.depends_on(var) || self.denom.depends_on(var)
    }

    /// The quotient; `None` when `other` is 0.
    pub fn checked_div(&self, other: &Self) -> Option<Self> {
        self.div_within(other, &mut Work::unlimited()).unwrap_or_default()
    }

    /// The quotient; `None` when `other` is 0.
    ///
    /// # Errors
    /// When the work is spent.
    pub fn div_within(&self, other: &Self, work: &mut Work) -> Result<Option<Self>, Spent> {
        Self::divided((&self.numer, &self.denom), (&other.numer, &other.denom), work)
    }

    /// (a/b) / (c/d); `None` when c is 0.
    fn divided(
        (a, b): (&Poly, &Poly),
        (c, d): (&Poly, &Poly),
        work: &mut Work,
    ) -> Result<Option<Self>, Spent> {
        if c.is_zero() {
            return Ok(None);
        }
        work.spend_product(a, d).ok_or(Spent)?;
        work.spend_product(b, c).ok_or(Spent)?;
        Self::reduced(a * d, b * c, work).map(Some).ok_or(Spent)
    }

    /// The sum; `None` when the work is spent.
    pub fn add_within(&self, other: &Self, work: &mut Work) -> Option<Self> {
        self.combine(other, |a, b| a + b, work)
    }

    /// The difference; `None` when the work is spent.
    pub fn sub_within(&self, other: &Self, work: &mut Work) -> Option<Self> {
        self.combine(other, |a, b| a - b, work)
    }

    /// The product; `None` when the work is spent.
    pub fn mul_within(&self, other: &Self, work: &mut Work) -> Option<Self> {
        work.spend_product(&self.numer, &other.numer)?;
        if self.denom.is_one() && other.denom.is_one() {
            return Some(Self::from(&self.numer * &other.numer));
        }
        // p·(n/d): only p and d can have a common factor, because n/d is in lowest terms.
        if self.denom.is_one() || other.denom.is_one() {
            let (poly, fraction) = if self.denom.is_one() { (self, other) } else { (other, self) };
            let rest = Self::reduced(poly.numer.clone(), fraction.denom.clone(), work)?;
            return Some(Self { numer: &rest.numer * &fraction.numer, denom: rest.denom });
        }
        work.spend_product(&self.denom, &other.denom)?;
        // A product of denominators is not zero.
        Self::reduced(&self.numer * &other.numer, &self.denom * &other.denom, work)
    }

    /// The power with a whole exponent.
    pub fn pow(&self, exponent: u32) -> Self {
        Self { numer: self.numer.pow(exponent), denom: self.denom.pow(exponent) }
    }

    /// The partial derivative in a variable, (n′d − nd′)/d².
    pub fn derivative(&self, var: Var) -> Self {
        // Without a bound on the work there is always a result.
        self.derivative_within(var, &mut Work::unlimited()).unwrap_or_else(Self::zero)
    }

    /// The partial derivative in a variable; `None` when the work is spent.
    pub fn derivative_within(&self, var: Var, work: &mut Work) -> Option<Self> {
        self.derivative_of_order(var, 1, work)
    }

    /// The partial derivative of an order in a variable; `None` when the work is spent.
    ///
    /// With the denominator c·p, where c is without the variable, and r the product of the irreducible factors of p, the
    /// derivative of order k is n[k]/(c·p·rᵏ), n[k + 1] = n[k]′·r − n[k]·(r·p′/p + k·r′). No factor of p divides n[k]: only
    /// one with c is to be looked for.
    pub(crate) fn derivative_of_order(&self, var: Var, order: u32, work: &mut Work) -> Option<Self> {
        let mut numer = self.numer.clone();
        if order == 0 || !self.denom.depends_on(var) {
            for _ in 0..order {
                if numer.is_zero() {
                    break;
                }
                numer = numer.derivative(var);
            }
            return Self::reduced(numer, self.denom.clone(), work);
        }
        let content = content(&self.denom, var, work)?;
        let primitive = self.denom.div_exact(&content)?;
        let slope = primitive.derivative(var);
        let common = checked_gcd(&primitive, &slope, work)?;
        let (radical, mut change) = (primitive.div_exact(&common)?, slope.div_exact(&common)?);
        let further = radical.derivative(var);
        let mut denom = primitive;
        for _ in 0..order {
            let slope = numer.derivative(var);
            work.spend_product(&slope, &radical)?;
            work.spend_product(&numer, &change)?;
            work.spend_product(&denom, &radical)?;
            numer = &(&slope * &radical) - &(&numer * &change);
            denom = &denom * &radical;
            change = &change + &further;
        }
        let rest = Self::reduced(numer, content, work)?;
        if rest.is_zero() {
            return Some(rest);
        }
        work.spend_product(&denom, &rest.denom)?;
        Self::normalized(&rest.numer, &(&denom * &rest.denom))
    }

    /// The function with another put in place of a variable; `None` when that makes the denominator zero.
    pub fn substitute(&self, var: Var, value: &Self) -> Option<Self> {
        self.substitute_within(var, value, &mut Work::unlimited()).unwrap_or_default()
    }

    /// The function with another put in place of a variable; `None` when that makes the denominator zero.
    ///
    /// # Errors
    /// When the work is spent.
    pub fn substitute_within(&self, var: Var, value: &Self, work: &mut Work) -> Result<Option<Self>, Spent> {
        if self.denom.is_one()
            && let Some(poly) = value.as_poly()
        {
            return Ok(Some(Self::from(self.numer.substitute(var, poly))));
        }
        let ((n, below_n), (d, below_d)) = self.put(var, value);
        Self::divided((&n, &below_n), (&d, &below_d), work)
    }

    /// Whether the function with another put in place of a variable is a third one: by products, without a common divisor.
    pub fn is_with(&self, var: Var, value: &Self, third: &Self) -> bool {
        let ((n, below_n), (d, below_d)) = self.put(var, value);
        !d.is_zero() && &(&n * &below_d) * &third.denom == &(&d * &below_n) * &third.numer
    }

    /// Numerator and denominator with a function in place of a variable, each over a denominator: that of the function to the
    /// degree of the polynomial.
    fn put(&self, var: Var, value: &Self) -> ((Poly, Poly), (Poly, Poly)) {
        let put = |p: &Poly| match value.as_poly() {
            Some(poly) => (p.substitute(var, poly), Poly::one()),
            None => {
                let degree = p.degree(var);
                let mut sum = Poly::zero();
                for (k, c) in p.coefficients_in(var).iter().enumerate() {
                    let k = k as u32;
                    sum = &sum + &(c * &(&value.numer.pow(k) * &value.denom.pow(degree - k)));
                }
                (sum, value.denom.pow(degree))
            }
        };
        (put(&self.numer), put(&self.denom))
    }

    /// The function with variables renamed, by their index; no two may get the same name.
    pub fn rename(&self, names: &[Var]) -> Self {
        // A new order of variables may change the sign that makes the denominator's leading coefficient positive.
        Self::new(self.numer.rename(names), self.denom.rename(names)).unwrap_or_else(Self::zero)
    }

    /// The exact value at a point; `None` where the denominator is zero.
    pub fn eval(&self, point: &[Rational]) -> Option<Rational> {
        self.numer.eval(point).checked_div(&self.denom.eval(point))
    }

    /// The function for reading, with these names of the variables.
    pub fn display(&self, names: &[String]) -> String {
        let part = |p: &Poly| {
            let text = p.display(names).to_string();
            if p.len() > 1 { format!("({text})") } else { text }
        };
        // As one writes it: without a minus sign in front of what stands below.
        if self.denom.len() > 1 && self.denom.display(names).to_string().starts_with('-') {
            return Self { numer: -&self.numer, denom: -&self.denom }.display(names);
        }
        match self.as_poly() {
            Some(p) => p.display(names).to_string(),
            None => {
                // 1/(2*p), not 1/2/p.
                let number = self.numer.as_constant().filter(|c| !c.is_integer());
                if let Some(c) = number {
                    let whole = c.denom();
                    let below = match self.denom.len() {
                        1 => self.denom.scale(&whole).display(names).to_string(),
                        _ => format!("{whole}*{}", part(&self.denom)),
                    };
                    return format!("{}/({below})", c.numer());
                }
                let (above, below) = (part(&self.numer), part(&self.denom));
                let product = self.denom.len() == 1 && below.contains('*');
                if product { format!("{above}/({below})") } else { format!("{above}/{below}") }
            }
        }
    }
}

thread_local! {
    static KNOWN: RefCell<Vec<Poly>> = const { RefCell::new(Vec::new()) };
}

/// Names irreducible polynomials that will often stand below a fraction line, such as 1 + tan². They change how a
/// quotient is brought into lowest terms, not what it is.
pub(crate) fn set_known_factors(factors: Vec<Poly>) {
    KNOWN.with_borrow_mut(|known| *known = factors);
}

/// A quotient from whose parts the known factors are taken: those that both parts share are gone, and what the
/// denominator has more of them stands apart.
struct Split {
    numer: Poly,
    denom: Poly,
    apart: Vec<Poly>,
}

impl Split {
    fn new(mut numer: Poly, mut denom: Poly, work: &mut Work) -> Option<Self> {
        let mut apart = Vec::new();
        let known = KNOWN.with_borrow(Vec::clone);
        for factor in &known {
            let mut divides = true;
            while let Some(rest) = checked_quotient(&denom, factor, work).ok()? {
                denom = rest;
                if divides {
                    if let Some(rest) = checked_quotient(&numer, factor, work).ok()? {
                        numer = rest;
                        continue;
                    }
                    divides = false;
                }
                apart.push(factor.clone());
            }
        }
        Some(Self { numer, denom, apart })
    }
}

impl From<Poly> for Fraction {
    fn from(numer: Poly) -> Self {
        Self { numer, denom: Poly::one() }
    }
}

impl Neg for &Fraction {
    type Output = Fraction;
    fn neg(self) -> Fraction {
        Fraction { numer: -&self.numer, denom: self.denom.clone() }
    }
}

impl Fraction {
    fn combine(&self, other: &Self, with: fn(&Poly, &Poly) -> Poly, work: &mut Work) -> Option<Self> {
        if self.denom.is_one() && other.denom.is_one() {
            return Some(Self::from(with(&self.numer, &other.numer)));
        }
        // n/d + p = (n + p·d)/d is in lowest terms because n/d is.
        if self.denom.is_one() || other.denom.is_one() {
            let (poly, denom) =
                if self.denom.is_one() { (&self.numer, &other.denom) } else { (&other.numer, &self.denom) };
            work.spend_product(poly, denom)?;
            let whole = poly * denom;
            let numer =
                if self.denom.is_one() { with(&whole, &other.numer) } else { with(&self.numer, &whole) };
            return Some(Self { numer, denom: denom.clone() });
        }
        let (numer, denom) = if self.denom == other.denom {
            (with(&self.numer, &other.numer), self.denom.clone())
        } else {
            work.spend_product(&self.numer, &other.denom)?;
            work.spend_product(&other.numer, &self.denom)?;
            work.spend_product(&self.denom, &other.denom)?;
            (with(&(&self.numer * &other.denom), &(&other.numer * &self.denom)), &self.denom * &other.denom)
        };
        // A product of denominators is not zero.
        Self::reduced(numer, denom, work)
    }
}

// Without a bound on the work there is always a result.

impl Add for &Fraction {
    type Output = Fraction;
    fn add(self, other: &Fraction) -> Fraction {
        self.add_within(other, &mut Work::unlimited()).unwrap_or_else(Fraction::zero)
    }
}

impl Sub for &Fraction {
    type Output = Fraction;
    fn sub(self, other: &Fraction) -> Fraction {
        self.sub_within(other, &mut Work::unlimited()).unwrap_or_else(Fraction::zero)
    }
}

impl Mul for &Fraction {
    type Output = Fraction;
    fn mul(self, other: &Fraction) -> Fraction {
        self.mul_within(other, &mut Work::unlimited()).unwrap_or_else(Fraction::zero)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arithmetic_stays_in_lowest_terms() {
        let x = Fraction::var(Var(0));
        let one = Fraction::constant(Rational::ONE);
        let a = one.checked_div(&(&one + &x)).expect("not zero");
        let b = x.checked_div(&(&one + &x)).expect("not zero");
        assert_eq!(&a + &b, one);
        assert_eq!(a.derivative(Var(0)), -&(&a * &a));
        let two = Fraction::constant(Rational::from(2));
        let c = two.checked_div(&(&(&two * &x) + &two)).expect("not zero");
        assert_eq!(c, a);
        assert_eq!(a.substitute(Var(0), &Fraction::constant(Rational::from(-1))), None);
        assert_eq!(b.substitute(Var(0), &a), one.checked_div(&(&two + &x)));
        assert_eq!(a.display(&[String::from("x")]), "1/(1 + x)");
    }

    /// Against the quotient rule, with powers below and a factor without the variable.
    #[test]
    fn derivatives_of_higher_orders() {
        let (x, y) = (Poly::var(Var(0)), Poly::var(Var(1)));
        let one = Poly::one();
        let square = &(&x * &x) + &y;
        let above = [&one + &x, &square * &(&x - &y), &(&x * &y) - &one];
        let below =
            [&square * &square, &(&y + &one) * &(&x + &one).pow(3), &y * &(&square * &(&x - &one)), x.pow(2)];
        for n in &above {
            for d in &below {
                let f = Fraction::new(n.clone(), d.clone()).expect("a denominator");
                let mut by_rule = f.clone();
                for order in 1..=3 {
                    let (n, d) = (by_rule.numer().clone(), by_rule.denom().clone());
                    let slope = &(&n.derivative(Var(0)) * &d) - &(&n * &d.derivative(Var(0)));
                    by_rule = Fraction::new(slope, &d * &d).expect("a denominator");
                    let found = f.derivative_of_order(Var(0), order, &mut Work::unlimited());
                    assert_eq!(found.as_ref(), Some(&by_rule), "{n:?} / {d:?}");
                }
            }
        }
    }
}

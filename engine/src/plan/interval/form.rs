//! The formulas that are emitted, still exact: factored values, Bernstein tables, the endpoint form.

use basis_prover::collections::list::{Listed, Mapped};

use crate::plan::denominator::{Completed, Sign};
use crate::plan::sign::has_one_sign;

use crate::algebra::divisors::gcd::square_free;
use crate::algebra::number::binomial;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Region;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::Family;
use crate::model::angle::Kind;
use crate::model::bernstein::{affine, to_bernstein};

/// Up to this degree a curve is evaluated in endpoint form, above in Bernstein form, which takes longer for a single
/// point, but has a proved bound of rounding errors that is smaller by a fifth at degree 5 and by two thirds at
/// degree 12: the table is in `benches/README.md`.
pub const MAX_ENDPOINT_DEGREE: u32 = 4;

/// A common factor of more bits than this is no help to readers or floats.
pub(in crate::plan) const MAX_CONTENT: u64 = 60;

/// All functions of a family on an interval, rewritten for evaluation in x = (t − low)/(high − low), s = 1 − x.
#[derive(Clone, Debug)]
pub struct IntervalForm {
    /// The domain variable t.
    pub var: Var,
    /// The lower end of the domain.
    pub low: Rational,
    /// The upper end of the domain.
    pub high: Rational,
    /// The highest degree of the functions in t.
    pub degree: u32,
    /// The functions.
    pub functions: Vec<FunctionForm>,
}

/// One function; every table is to be divided by `denom`, which contains shape parameters only.
#[derive(Clone, Debug)]
pub struct FunctionForm {
    /// What stands below the fraction line.
    pub denom: Poly,
    /// The coefficients of t⁰, t¹, …
    pub monomial: Vec<Poly>,
    /// The coefficients in the Bernstein basis of the family's degree on the domain.
    pub bernstein: Vec<Poly>,
    /// The function as a product.
    pub factored: Factored,
    /// E0, E1, R0, R1, … of b = s·E0 + x·E1 + s·x·(R0 + R1·y + R2·y² + …), y = x − s; none above
    /// [`MAX_ENDPOINT_DEGREE`].
    pub endpoint: Vec<Poly>,
}

/// content · x^a · s^b · h² · g, with g and h in the Bernstein bases of their own degrees.
#[derive(Clone, Debug)]
pub struct Factored {
    /// A number.
    pub content: Rational,
    /// The power of x.
    pub x_power: u32,
    /// The power of s.
    pub s_power: u32,
    /// The Bernstein coefficients of h; none if that is 1. A square is taken out where Bernstein coefficients without it
    /// are not all of one sign: next to a double zero they would give values of both signs.
    pub square: Vec<Poly>,
    /// The Bernstein coefficients of g; none for the function 0.
    pub inner: Vec<Poly>,
}

impl IntervalForm {
    /// The form of a family; `None` when it has several domain variables.
    pub fn new(family: &Family) -> Option<Self> {
        let (var, low, high) = family.interval()?;
        let degree = family.degree(var);
        let functions = family
            .functions
            .mapped(|f| FunctionForm::new(family, f.value.numer(), f.value.denom(), degree, false));
        let functions = functions.into_iter().collect::<Option<Vec<_>>>()?;
        Some(Self { var, low: low.clone(), high: high.clone(), degree, functions })
    }

    /// The number of functions.
    pub fn len(&self) -> usize {
        self.functions.len()
    }

    /// Whether there are no functions.
    pub fn is_empty(&self) -> bool {
        self.functions.is_empty()
    }
}

/// All functions of a family as quotients of polynomials of one degree, in the domain variable or in its tangent.
#[derive(Clone, Debug)]
pub struct RationalForm {
    /// The numerators.
    pub numerators: IntervalForm,
    /// The common denominator.
    pub denominator: FunctionForm,
    /// What rounding could do to its sign.
    pub sign: Sign,
    /// The denominator with a completed square, where its Bernstein coefficients have both signs and it has such a form.
    pub completed: Option<Completed>,
    /// Whether the coordinates s and x add up to 1: they do not where they are made of sines.
    pub is_affine: bool,
    /// The number ρ of a denominator that is a power of s + ρ·x: values are computed in s and y = ρ·x, both times one
    /// power of two, so that no power of s + y underflows; the factored forms of the functions are in these.
    pub ratio: Option<Poly>,
    /// Whether values are computed from the table of Bernstein coefficients of the numerators, as points of curves are:
    /// where these are long polynomials in the shape values, which are better computed in one place. Otherwise from
    /// factored forms.
    pub is_tabulated: bool,
}

/// With more terms in all, the Bernstein coefficients of polynomial functions are computed in one place.
const MAX_TERMS: usize = 300;

impl RationalForm {
    /// Whether the functions of a family are evaluated as quotients, or span by span.
    pub(crate) fn is_of(family: &Family) -> bool {
        family.is_rational()
            || !family.analytic.is_empty()
            || !family.pieces.is_empty()
            || family.interval().is_some() && family.leaves_an_end_out()
    }

    /// The quotients of a family that is evaluated by them, one for each span.
    pub(crate) fn of_family(family: &Family) -> Option<Vec<Self>> {
        if !Self::is_of(family) {
            return None;
        }
        if family.pieces.is_empty() { Some(vec![Self::new(family, 0)?]) } else { Self::of_spans(family) }
    }

    /// Whether the functions are quotients in their coordinates, not polynomials in coordinates with the sum 1.
    pub(crate) fn divides(&self, family: &Family) -> bool {
        !self.is_affine || !family.over.is_one()
    }

    /// The forms of a family on several spans, of one degree.
    pub fn of_spans(family: &Family) -> Option<Vec<Self>> {
        let mut least = 0;
        for piece in &family.pieces {
            least = Self::new(piece, least)?.numerators.degree;
        }
        let mut all = Vec::new();
        for piece in &family.pieces {
            all.push(Self::new(piece, least)?);
        }
        Some(all)
    }

    /// The form of a family on one span, with at least that degree; `None` when it has several domain variables.
    pub fn new(family: &Family, least: u32) -> Option<Self> {
        let (var, low, high) = family.interval()?;
        let degree = family.degree(var).max(family.over.degree(var)).max(least);
        let is_affine = family.analytic.angle(var).is_none_or(|angle| angle.kind == Kind::Linear);
        let form = |p: &Poly, q: &Poly| FunctionForm::new(family, p, q, degree, !is_affine);
        let one = Poly::one();
        let functions = if family.is_rational() {
            family.numerators().mapped(|p| form(p, &one))
        } else {
            family.functions.mapped(|f| form(f.value.numer(), f.value.denom()))
        };
        let functions = functions.into_iter().collect::<Option<Vec<_>>>()?;
        let terms: usize = functions.iter().flat_map(|f| &f.bernstein).map(Poly::len).sum();
        let is_tabulated = is_affine && family.over.is_one() && terms > MAX_TERMS;
        let mut numerators = IntervalForm { var, low: low.clone(), high: high.clone(), degree, functions };
        let mut denominator = form(&family.over, &one)?;
        let sign = Sign::of(family, &denominator.bernstein);
        let has_unit = family.analytic.is_empty() || (low.is_zero() && high.is_one());
        let completes = is_affine && has_unit && sign != Sign::Kept;
        let completed = completes.then(|| Completed::of(family)).flatten();
        let ratio = if is_affine { None } else { ratio(&denominator.bernstein) };
        let forms = || numerators.functions.iter().chain([&denominator]);
        let factored = ratio.as_ref().and_then(|ratio| {
            forms().map(|f| f.in_ratio(ratio, var, &family.region())).collect::<Option<Vec<_>>>()
        });
        let ratio = ratio.filter(|_| factored.is_some());
        let forms = numerators.functions.iter_mut().chain([&mut denominator]);
        for (form, factored) in forms.zip(factored.into_iter().flatten()) {
            form.factored = factored;
        }
        Some(Self { numerators, denominator, sign, completed, is_affine, ratio, is_tabulated })
    }
}

/// The quotient of each of some numbers and the one before it, where it is always the same and not 1.
fn ratio(numbers: &[Poly]) -> Option<Poly> {
    let (first, others) = numbers.split_first()?;
    let ratio = others.first()?.div_exact(first).filter(|ratio| !ratio.is_one() && !ratio.is_zero())?;
    numbers.windows(2).all(|pair| pair[1] == &pair[0] * &ratio).then_some(ratio)
}

impl FunctionForm {
    /// `homogeneous` factors have the degree of the family, all others their own; `None` when it has several domain
    /// variables.
    fn new(family: &Family, numer: &Poly, denom: &Poly, degree: u32, homogeneous: bool) -> Option<Self> {
        let (var, low, high) = family.interval()?;
        let terms = degree as usize + 1;
        let (numer, denom) = &in_reach(numer, denom);
        let mut monomial = numer.coefficients_in(var);
        monomial.resize(terms, Poly::zero());
        // t = low + (high − low) x
        let unit = affine(&numer.coefficients_in(var), low, &(high - low));
        let own_degree = unit.iter().rposition(|c| !c.is_zero()).unwrap_or(0);
        let bernstein = to_bernstein(&unit, degree);
        let own = if homogeneous {
            bernstein.clone()
        } else {
            to_bernstein(&unit[..=own_degree], own_degree as u32)
        };
        let factored = Factored::new(own).without_square(var, &family.region());
        let endpoint = if degree <= MAX_ENDPOINT_DEGREE { endpoint(&unit, degree) } else { Vec::new() };
        Some(Self { denom: denom.clone(), monomial, bernstein, factored, endpoint })
    }

    /// The function as a product in s and ratio·x; `None` where that has other coefficients than polynomials.
    fn in_ratio(&self, ratio: &Poly, var: Var, region: &Region) -> Option<Factored> {
        let mut power = Poly::one();
        let mut own = Vec::new();
        for c in &self.bernstein {
            own.push(c.div_exact(&power)?);
            power = &power * ratio;
        }
        Some(Factored::new(own).without_square(var, region))
    }
}

impl Factored {
    /// Takes out the powers of x and s, and the numeric content, of Σ c_j binomial(n, j) s^(n−j) x^j.
    fn new(mut c: Vec<Poly>) -> Self {
        let (mut x_power, mut s_power) = (0, 0);
        if c.iter().all(Poly::is_zero) {
            let none = Vec::new;
            return Self { content: Rational::ZERO, x_power, s_power, square: none(), inner: none() };
        }
        while c.len() > 1 && c[0].is_zero() {
            let n = c.len() as i64 - 1;
            c.remove(0);
            for (j, p) in c.iter_mut().enumerate() {
                *p = p.scale(&Rational::new(n, j as i64 + 1));
            }
            x_power += 1;
        }
        while c.len() > 1 && c[c.len() - 1].is_zero() {
            let n = c.len() as i64 - 1;
            c.pop();
            for (j, p) in c.iter_mut().enumerate() {
                *p = p.scale(&Rational::new(n, n - j as i64));
            }
            s_power += 1;
        }
        let (content, inner) = without_content(&c);
        Self { content, x_power, s_power, square: Vec::new(), inner }
    }

    /// With h² taken out of g, where that helps; the shape parameters lie in `region`.
    fn without_square(mut self, var: Var, region: &Region) -> Self {
        if has_one_sign(&self.inner, region) {
            return self;
        }
        // g is homogeneous in s and x: with s = 1 a polynomial in x, here `var`.
        let n = self.inner.len() as u32 - 1;
        let terms = self.inner.iter().zip(0..);
        let whole = terms
            .fold(Poly::zero(), |sum, (c, j)| &sum + &(&Poly::var(var).pow(j) * c).scale(&binomial(n, j)));
        let Some((square, rest)) = square_factor(&whole, &[var]) else { return self };
        let table = |p: &Poly| {
            let own = p.coefficients_in(var);
            let degree = own.len() as u32 - 1;
            let scaled = own
                .iter()
                .zip(0..)
                .map(|(c, j)| c.scale(&binomial(degree, j).recip().unwrap_or(Rational::ONE)));
            scaled.listed()
        };
        let (content, inner) = without_content(&table(&rest));
        let content = &self.content * &content;
        if content.bits() <= MAX_CONTENT {
            (self.content, self.square, self.inner) = (content, table(&square), inner);
        }
        self
    }

    /// g expanded in t, for reading: content · (t − low)^a · (high − t)^b · h² · g is the function.
    pub fn inner_monomial(&self, form: &IntervalForm) -> Poly {
        let width = &form.high - &form.low;
        // x^a s^b = (t − low)^a (high − t)^b / width^(a + b); the ends of an interval are different.
        let unit = width.recip().unwrap_or(Rational::ONE);
        expanded(&self.inner, form).scale(&unit.pow(self.x_power + self.s_power))
    }

    /// h expanded in t, for reading; nothing if it is 1.
    pub fn square_monomial(&self, form: &IntervalForm) -> Option<Poly> {
        (!self.square.is_empty()).then(|| expanded(&self.square, form))
    }
}

/// A quotient whose denominator has numbers beyond the range of floats with its lowest coefficient made 1.
fn in_reach(numer: &Poly, denom: &Poly) -> (Poly, Poly) {
    let lowest = denom.terms().map(|(m, c)| (m.total_degree(), c)).min_by_key(|(degree, _)| *degree);
    match lowest.and_then(|(_, c)| c.recip()).filter(|_| denom.max_bits() > MAX_CONTENT) {
        Some(factor) => (numer.scale(&factor), denom.scale(&factor)),
        None => (numer.clone(), denom.clone()),
    }
}

/// The numeric content of coefficients, negative if all of them are, and the coefficients without it.
fn without_content(c: &[Poly]) -> (Rational, Vec<Poly>) {
    let mut content = c.iter().fold(Rational::ZERO, |g, p| g.gcd(&p.numeric_content()));
    if c.iter().all(|p| p.leading_term().is_none_or(|(_, c)| c.is_negative())) {
        content = -content;
    }
    if content.bits() > MAX_CONTENT {
        // What is left would be beyond the range of floats.
        content = Rational::from(i64::from(content.signum()));
    }
    let factor = content.recip().unwrap_or(Rational::ONE);
    (content, c.mapped(|p| p.scale(&factor)))
}

/// Σ c_j binomial(n, j) s^(n−j) x^j in t.
fn expanded(coefficients: &[Poly], form: &IntervalForm) -> Poly {
    let n = coefficients.len().saturating_sub(1) as u32;
    let unit = (&form.high - &form.low).recip().unwrap_or(Rational::ONE);
    let x = (&Poly::var(form.var) - &Poly::constant(form.low.clone())).scale(&unit);
    let s = &Poly::one() - &x;
    let mut sum = Poly::zero();
    for (c, j) in coefficients.iter().zip(0..) {
        sum = &sum + &(&(&s.pow(n - j) * &x.pow(j)).scale(&binomial(n, j)) * c);
    }
    sum
}

/// The work for the common divisors of one function.
const SQUARE: u64 = 2_000_000;

/// h and g with p = h²·g, the coefficients of h being whole numbers without a common divisor; `None` where h would be
/// without these variables.
pub(in crate::plan) fn square_factor(p: &Poly, vars: &[Var]) -> Option<(Poly, Poly)> {
    let depends = |p: &Poly| vars.iter().any(|var| p.depends_on(*var));
    let factors = square_free(p, &mut Work::new(SQUARE))?;
    let factors = factors.iter().filter(|(factor, _)| depends(factor));
    let square = factors.fold(Poly::one(), |h, (factor, e)| &h * &factor.pow(e / 2));
    if !depends(&square) {
        return None;
    }
    let square = square.scale(&square.numeric_content().recip()?);
    let rest = p.div_exact(&(&square * &square))?;
    Some((square, rest))
}

/// E0, E1, R0, R1, …: b − s·E0 − x·E1 vanishes at both ends; divided by s·x it is written in y = x − s.
fn endpoint(unit: &[Poly], degree: u32) -> Vec<Poly> {
    let start = unit[0].clone();
    let end = unit.iter().fold(Poly::zero(), |sum, c| &sum + c);
    let mut rest = unit.to_vec();
    rest.resize(degree.max(1) as usize + 1, Poly::zero());
    // s·E0 + x·E1 = E0 + (E1 − E0)·x
    rest[0] = Poly::zero();
    rest[1] = &rest[1] - &(&end - &start);
    // Divided by x, then by 1 − x: q_k = p_k + q_(k−1).
    let mut quotient: Vec<Poly> = Vec::new();
    for p in &rest[1..rest.len() - 1] {
        let next = quotient.last().map_or_else(|| p.clone(), |q| q + p);
        quotient.push(next);
    }
    // x = (1 + y)/2
    let half = Rational::new(1, 2);
    let inner = affine(&quotient, &half, &half);
    [start, end].into_iter().chain(inner).listed()
}

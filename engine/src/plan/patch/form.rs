//! The exact formulas that are emitted for families on simplices and boxes: factored values and Bernstein tables.
//!
//! A domain is a product of simplices: a triangle is one group of coordinates (u, v, w) with the sum 1, a box one group
//! (x, s), x = (t − low)/(high − low), for each of its variables. In every group a function is made homogeneous with
//! the powers of the sum, which is 1; its coefficients are then those of the Bernstein form, up to multinomial factors.

use crate::algebra::number::binomial;
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::range::Region;
use crate::algebra::rational::Rational;
use crate::model::{Factor, Family, Function};
use crate::plan::interval::form::{MAX_CONTENT, square_factor};
use crate::plan::sign::has_one_sign;
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::map::SortedMap;
use basis_prover::collections::sort::sort_by;

/// More Bernstein coefficients, for all functions together, are not emitted.
const MAX_COEFFICIENTS: usize = 1 << 16;

/// Units of work for a term of a form.
const TERM: u64 = 20;
/// Units of work for a tuple of exponents.
const TUPLE: u64 = 2;

/// All functions of a family on a simplex or a box, rewritten for evaluation.
#[derive(Clone, Debug)]
pub struct PatchForm {
    /// The groups of coordinates.
    pub groups: Vec<Group>,
    /// The highest degree of the functions in each group.
    pub degrees: Vec<u32>,
    /// The functions.
    pub functions: Vec<PatchFunction>,
}

/// Coordinates with the sum 1.
#[derive(Clone, Debug)]
pub struct Group {
    /// The independent variables; the last coordinate is 1 minus their sum.
    pub vars: Vec<Var>,
    /// The range of the variable of a box.
    pub range: Option<(Rational, Rational)>,
}

/// One function; every coefficient is to be divided by `denom`, which contains shape parameters only.
///
/// The function is content · (powers of the coordinates) · h² · Σ `inner[α]` · (the monomial with the exponents α), h = 1 or
/// the sum of `square`.
#[derive(Clone, Debug)]
pub struct PatchFunction {
    /// What stands below the fraction line.
    pub denom: Poly,
    /// A number.
    pub content: Rational,
    /// The powers of all coordinates, group by group.
    pub powers: Vec<u32>,
    /// The degrees of what is left, by group.
    pub inner_degrees: Vec<u32>,
    /// Its coefficients, in the order of [`exponents`]; none for the function 0.
    pub inner: Vec<Poly>,
    /// The degrees of h and its coefficients, likewise, where the coefficients without a square are not all of one sign.
    pub square: Option<(Vec<u32>, Vec<Poly>)>,
    /// The coefficients of the function in the Bernstein basis of the family's degrees, in the same order.
    pub bernstein: Vec<Poly>,
}

impl PatchForm {
    /// The form of a family; `None` when it is too large.
    pub fn new(family: &Family) -> Option<Self> {
        Self::of_functions(family, &family.functions)
    }

    /// The form of functions on the domain of a family, in its variables.
    pub fn of_functions(family: &Family, functions: &[Function]) -> Option<Self> {
        let groups = groups(family);
        let numers: Vec<Poly> = functions.mapped(|f| in_units(f.value.numer(), &groups));
        let own: Vec<Vec<u32>> = numers.mapped(|p| degrees(p, &groups));
        let degrees: Vec<u32> =
            (0..groups.len()).map(|g| own.iter().map(|d| d[g]).max().unwrap_or(0)).listed();
        let count = lattice_size(&groups, &degrees)?.checked_mul(functions.len())?;
        if count > MAX_COEFFICIENTS {
            return None;
        }
        let lattice = exponents(&groups, &degrees);
        let shapes = family.shape_region();
        let functions = functions
            .iter()
            .zip(&numers)
            .zip(&own)
            .map(|((f, numer), own)| {
                let all = homogeneous(numer, &groups, &degrees);
                let bernstein = lattice
                    .mapped(|e| all.get(e).map_or_else(Poly::zero, |c| c.scale(&reciprocal(e, &groups))));
                let (content, powers, inner_degrees, inner) =
                    factored(&homogeneous(numer, &groups, own), &groups, own);
                let denom = f.value.denom().clone();
                let square = None;
                PatchFunction { denom, content, powers, inner_degrees, inner, square, bernstein }
                    .without_square(&groups, &shapes)
            })
            .listed();
        Some(Self { groups, degrees, functions })
    }

    /// The number of Bernstein coefficients of a function.
    pub fn coefficients(&self) -> usize {
        lattice_size(&self.groups, &self.degrees).unwrap_or(usize::MAX)
    }
}

impl PatchFunction {
    /// With h² taken out of the sum, where that helps; the shape parameters lie in `shapes`.
    fn without_square(mut self, groups: &[Group], shapes: &Region) -> Self {
        if self.inner_degrees.iter().sum::<u32>() < 2 || has_one_sign(&self.inner, shapes) {
            return self;
        }
        let coordinates =
            groups.iter().flat_map(|group| Group::with_last(group.vars.mapped(|v| Poly::var(*v)))).listed();
        let whole = sum(&self.inner, &exponents(groups, &self.inner_degrees), &coordinates);
        let vars = groups.iter().flat_map(|group| group.vars.iter().copied()).listed();
        let Some((square, rest)) = square_factor(&whole, &vars) else { return self };
        let own = degrees(&rest, groups);
        let (content, powers, inner_degrees, inner) =
            factored(&homogeneous(&rest, groups, &own), groups, &own);
        let content = &self.content * &content;
        if content.bits() > MAX_CONTENT {
            return self;
        }
        let own = degrees(&square, groups);
        let terms = homogeneous(&square, groups, &own);
        let root = exponents(groups, &own).mapped(|e| terms.get(e).cloned().unwrap_or_else(Poly::zero));
        let powers = self.powers.iter().zip(powers).map(|(a, b)| a + b).listed();
        (self.content, self.powers, self.inner_degrees, self.inner) = (content, powers, inner_degrees, inner);
        self.square = Some((own, root));
        self
    }

    /// h in the independent variables, for reading; nothing if it is 1.
    pub fn square_polynomial(&self, form: &PatchForm) -> Option<Poly> {
        let (degrees, root) = self.square.as_ref()?;
        let coordinates: Vec<Poly> = form.groups.iter().flat_map(Group::coordinates).listed();
        Some(sum(root, &exponents(&form.groups, degrees), &coordinates))
    }

    /// content · Σ `inner[α]` · (the monomial with the exponents α) in the independent variables, for reading.
    pub fn inner_polynomial(&self, form: &PatchForm) -> Poly {
        let coordinates: Vec<Poly> = form.groups.iter().flat_map(Group::coordinates).listed();
        sum(&self.inner, &exponents(&form.groups, &self.inner_degrees), &coordinates).scale(&self.content)
    }
}

/// Σ c·(the monomial with these exponents in the coordinates).
fn sum(coefficients: &[Poly], exponents: &[Vec<u32>], coordinates: &[Poly]) -> Poly {
    let mut sum = Poly::zero();
    for (c, e) in coefficients.iter().zip(exponents) {
        if !c.is_zero() {
            let term = coordinates.iter().zip(e).fold(c.clone(), |term, (x, e)| &term * &x.pow(*e));
            sum = &sum + &term;
        }
    }
    sum
}

impl Group {
    /// Its coordinates in the independent variables.
    fn coordinates(&self) -> Vec<Poly> {
        let mut all: Vec<Poly> = self.vars.iter().map(|v| Poly::var(*v)).listed();
        if let (Some((low, high)), Some(first)) = (&self.range, all.first_mut()) {
            let unit = (high - low).recip().unwrap_or(Rational::ONE);
            *first = (&*first - &Poly::constant(low.clone())).scale(&unit);
        }
        Self::with_last(all)
    }

    /// Coordinates with the last one, which is 1 minus their sum.
    fn with_last(mut all: Vec<Poly>) -> Vec<Poly> {
        let last = all.iter().fold(Poly::one(), |rest, x| &rest - x);
        all.push(last);
        all
    }
}

/// One group for each factor of the domain: a simplex, or the variable of an interval.
fn groups(family: &Family) -> Vec<Group> {
    family.factors().mapped(|factor| match factor {
        Factor::Simplex(independent, _) => Group { vars: independent.mapped(|p| p.var), range: None },
        Factor::Interval(p) => Group {
            vars: vec![p.var],
            range: p.range.finite().map(|(low, high)| (low.clone(), high.clone())),
        },
    })
}

/// The variables t of a box replaced by x, t = low + (high − low) x.
fn in_units(numer: &Poly, groups: &[Group]) -> Poly {
    groups.iter().fold(numer.clone(), |p, group| match &group.range {
        Some((low, high)) if !(low.is_zero() && high.is_one()) => {
            let x = Poly::var(group.vars[0]).scale(&(high - low));
            p.substitute(group.vars[0], &(&Poly::constant(low.clone()) + &x))
        }
        _ => p,
    })
}

/// The degrees in the groups.
fn degrees(numer: &Poly, groups: &[Group]) -> Vec<u32> {
    let of = |m: &Monomial, g: &Group| g.vars.iter().map(|v| u32::from(m.exponent(*v))).sum::<u32>();
    groups.mapped(|g| numer.terms().map(|(m, _)| of(m, g)).max().unwrap_or(0))
}

/// The coefficients, polynomials in the shape parameters, of the monomials in all coordinates, homogeneous of these
/// degrees.
///
/// One group after another, with like terms put together: a product over n intervals has 2ⁿ coefficients, and all of them
/// at once would be made of 3ⁿ terms.
fn homogeneous(numer: &Poly, groups: &[Group], degrees: &[u32]) -> SortedMap<Vec<u32>, Poly> {
    // The exponents in the coordinates of the groups so far, what is left of the monomial, and a number.
    let mut terms: Vec<(Vec<u32>, Monomial, Rational)> =
        numer.terms().map(|(m, c)| (Vec::new(), m.clone(), c.clone())).listed();
    for (group, degree) in groups.iter().zip(degrees) {
        if *degree == 0 {
            for (start, ..) in &mut terms {
                start.resize(start.len() + group.vars.len() + 1, 0);
            }
            continue;
        }
        let mut next = Vec::new();
        for (start, monomial, factor) in &terms {
            let own: Vec<u32> = group.vars.mapped(|v| u32::from(monomial.exponent(*v)));
            let rest = group.vars.iter().fold(monomial.clone(), |m, v| m.with_exponent(*v, 0));
            // The term times the missing power of the sum of the group.
            let missing = degree - own.iter().sum::<u32>();
            for power in multi_indices(own.len() + 1, missing) {
                let raised = own.iter().chain(&[0]).zip(&power).map(|(a, b)| a + b);
                let exponents = start.iter().copied().chain(raised).listed();
                next.push((exponents, rest.clone(), factor * &multinomial(&power)));
            }
        }
        basis_prover::charge(TERM * next.len() as u64);
        terms = like_terms(next);
    }
    let mut result: SortedMap<Vec<u32>, Vec<(Monomial, Rational)>> = SortedMap::new();
    for (exponents, monomial, factor) in terms {
        result.get_or_insert_with(exponents, Vec::new).push((monomial, factor));
    }
    let mut coefficients = SortedMap::new();
    for (exponents, terms) in result {
        coefficients.insert(exponents, Poly::from_terms(terms));
    }
    coefficients
}

/// Terms with the same exponents and the same monomial put together, in the order of their exponents.
fn like_terms(mut terms: Vec<(Vec<u32>, Monomial, Rational)>) -> Vec<(Vec<u32>, Monomial, Rational)> {
    sort_by(&mut terms, |a, b| (&a.0, &a.1).cmp(&(&b.0, &b.1)));
    terms.dedup_by(|next, first| {
        let is_like = next.0 == first.0 && next.1 == first.1;
        if is_like {
            first.2 += &next.2;
        }
        is_like
    });
    terms.retain(|(.., factor)| !factor.is_zero());
    terms
}

/// Takes out the powers of the coordinates and the numeric content.
fn factored(
    terms: &SortedMap<Vec<u32>, Poly>,
    groups: &[Group],
    degrees: &[u32],
) -> (Rational, Vec<u32>, Vec<u32>, Vec<Poly>) {
    let width = groups.iter().map(|g| g.vars.len() + 1).sum();
    let Some(first) = terms.keys().next() else {
        return (Rational::ZERO, vec![0; width], vec![0; groups.len()], Vec::new());
    };
    let powers = terms.keys().fold(first.clone(), |p, e| p.iter().zip(e).map(|(a, b)| *a.min(b)).listed());
    let mut content = terms.values().fold(Rational::ZERO, |g, p| g.gcd(&p.numeric_content()));
    if terms.values().all(|p| p.leading_term().is_none_or(|(_, c)| c.is_negative())) {
        content = -content;
    }
    let mut start = 0;
    let inner_degrees: Vec<u32> = groups
        .iter()
        .zip(degrees)
        .map(|(group, degree)| {
            let end = start + group.vars.len() + 1;
            let taken: u32 = powers[start..end].iter().sum();
            start = end;
            degree - taken
        })
        .listed();
    let factor = content.recip().unwrap_or(Rational::ONE);
    let inner = exponents(groups, &inner_degrees)
        .into_iter()
        .map(|e| {
            let e: Vec<u32> = e.iter().zip(&powers).map(|(a, b)| a + b).listed();
            terms.get(&e).map_or_else(Poly::zero, |c| c.scale(&factor))
        })
        .listed();
    (content, powers, inner_degrees, inner)
}

/// The exponents of all monomials that are homogeneous of these degrees in the groups, in lexicographic order.
pub fn exponents(groups: &[Group], degrees: &[u32]) -> Vec<Vec<u32>> {
    groups.iter().zip(degrees).fold(vec![Vec::new()], |all, (group, degree)| {
        let own = multi_indices(group.vars.len() + 1, *degree);
        basis_prover::charge(TUPLE * (all.len() * own.len()) as u64);
        all.iter()
            .flat_map(|start: &Vec<u32>| own.iter().map(move |e| [start.as_slice(), e].concat()))
            .listed()
    })
}

/// Their number; `None` for too many.
fn lattice_size(groups: &[Group], degrees: &[u32]) -> Option<usize> {
    groups.iter().zip(degrees).try_fold(1_usize, |size, (group, degree)| {
        let len = group.vars.len() as u32;
        let own = binomial(degree + len, len).to_i64().and_then(|n| usize::try_from(n).ok())?;
        size.checked_mul(own).filter(|size| *size <= MAX_COEFFICIENTS)
    })
}

/// All tuples of that length and sum, in lexicographic order.
pub fn multi_indices(len: usize, sum: u32) -> Vec<Vec<u32>> {
    if len == 1 {
        return vec![vec![sum]];
    }
    (0..=sum)
        .flat_map(|first| {
            multi_indices(len - 1, sum - first)
                .into_iter()
                .map(move |rest| [&[first], rest.as_slice()].concat())
        })
        .listed()
}

/// (Σ e)! / ∏ e!
fn multinomial(exponents: &[u32]) -> Rational {
    let mut sum = 0;
    exponents.iter().fold(Rational::ONE, |product, e| {
        sum += e;
        &product * &binomial(sum, *e)
    })
}

/// 1 over the product of the multinomials of the groups.
fn reciprocal(exponents: &[u32], groups: &[Group]) -> Rational {
    let mut start = 0;
    let product = groups.iter().fold(Rational::ONE, |product, group| {
        let end = start + group.vars.len() + 1;
        let factor = multinomial(&exponents[start..end]);
        start = end;
        &product * &factor
    });
    product.recip().unwrap_or(Rational::ONE)
}

/// The functions of the next order by the recursion b[I] = Σ_j x_j b[I − e_j] on a simplex, x_j the barycentric
/// coordinates.
pub(crate) fn raised(family: &Family, functions: &[Function]) -> Vec<Function> {
    use crate::algebra::fraction::Fraction;
    let mut known: SortedMap<&[i64], &Fraction> = SortedMap::new();
    for f in functions {
        known.insert(&f.index, &f.value);
    }
    let mut coordinates: Vec<Fraction> = family.domain.mapped(|p| Fraction::var(p.var));
    let one = Fraction::constant(Rational::ONE);
    coordinates.push(coordinates.iter().fold(one, |rest, x| &rest - x));
    let order = functions.first().map_or(0, |f| f.index.iter().sum::<i64>());
    multi_indices(coordinates.len(), u32::try_from(order + 1).unwrap_or(0))
        .into_iter()
        .map(|index| {
            let index: Vec<i64> = index.into_iter().map(i64::from).listed();
            let mut value = Fraction::zero();
            for (j, x) in coordinates.iter().enumerate() {
                let mut before = index.clone();
                before[j] -= 1;
                if let Some(b) = known.get(&before.as_slice()) {
                    value = &value + &(x * *b);
                }
            }
            Function { index, value }
        })
        .listed()
}

/// A function as a product in the coordinates of a simplex, for reading; what is left beside their powers is
/// homogeneous in all coordinates, or a polynomial in the independent ones where that is shorter.
pub fn factored_text(family: &Family, f: &PatchFunction, form: &PatchForm) -> String {
    let names: Vec<&str> = family.domain_variables().map(|p| p.name.as_str()).listed();
    let monomial = |exponents: &[u32]| {
        let factors: Vec<String> = exponents
            .iter()
            .zip(&names)
            .filter(|(e, _)| **e > 0)
            .map(|(e, name)| if *e == 1 { (*name).to_string() } else { format!("{name}^{e}") })
            .listed();
        factors.join("*")
    };
    let powers = monomial(&f.powers);
    // A number before the product, where the factor would have fractions.
    let outside = !powers.is_empty() && !f.content.is_integer();
    let (number, content) =
        if outside { (f.content.clone(), Rational::ONE) } else { (Rational::ONE, f.content.clone()) };
    let mut sum = String::new();
    let mut count = 0;
    for (c, e) in f.inner.iter().zip(exponents(&form.groups, &f.inner_degrees)).filter(|(c, _)| !c.is_zero())
    {
        let c = c.scale(&content);
        let (m, text) = (monomial(&e), c.display(&family.names).to_string());
        let (negative, text) = match text.strip_prefix('-') {
            Some(rest) if c.len() == 1 => (true, rest.to_string()),
            _ => (false, text),
        };
        sum += match (count, negative) {
            (0, false) => "",
            (0, true) => "-",
            (_, false) => " + ",
            (_, true) => " - ",
        };
        count += 1;
        sum += &match (text.as_str(), m.as_str()) {
            (_, "") => text,
            ("1", _) => m,
            _ if c.len() > 1 => format!("({text})*{m}"),
            _ => format!("{text}*{m}"),
        };
    }
    let square = f.square_polynomial(form).map(|h| format!("({})^2", h.display(&family.names)));
    let powers = match square {
        Some(square) if powers.is_empty() => square,
        Some(square) => format!("{powers}*{square}"),
        None => powers,
    };
    let mut several = count > 1 || f.inner.iter().any(|c| c.len() > 1);
    if several {
        let plain = f.inner_polynomial(form).scale(&number.recip().unwrap_or(Rational::ONE));
        let text = plain.display(&family.names).to_string();
        if text.chars().count() < sum.chars().count() {
            (sum, several) = (text, plain.len() > 1);
        }
    }
    let numer = match (powers.as_str(), sum.as_str()) {
        ("", "") => String::from("0"),
        ("", _) => sum,
        (_, "1") => powers,
        (_, "-1") => format!("-{powers}"),
        _ if several => format!("({sum})*{powers}"),
        _ => format!("{sum}*{powers}"),
    };
    let numer = if number.is_one() { numer } else { format!("{number}*{numer}") };
    if f.denom.is_one() { numer } else { format!("({numer})/({})", f.denom.display(&family.names)) }
}

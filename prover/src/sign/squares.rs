//! Step 5: sums of squares.
//!
//! A polynomial p is a sum of squares if and only if p = mᵀG m, where m is a list of monomials and G a positive
//! semidefinite matrix. Each product of two monomials gives an equation for the entries of G. Often they leave no choice;
//! where they do, G is the matrix with the least entries, in the sense of least squares, that maps m(z) to zero for every
//! zero z of p that has coordinates −1, 0 and 1.

use crate::algebra::matrix::independent_equations;
use crate::algebra::poly::{Monomial, Poly, PolyExt, Var};
use crate::algebra::range::End;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::collections::list::{Listed, Mapped};
use crate::collections::map::SortedMap;
use crate::semidefinite::semidefinite;
use basis_kernel::{Relation, SignProof};

use super::problem::Problem;

/// The most monomials in m.
const MAX_MONOMIALS: usize = 40;
/// The most monomials from which they are chosen.
const MAX_CANDIDATES: usize = 600;
/// Zeros are looked for in at most this number of variables.
const MAX_VARIABLES: usize = 6;
/// The parts of the constant that are left out of the squares where p > 0 is claimed.
const PARTS: [i64; 4] = [1, 2, 8, 64];

/// The exponents of a monomial, one for each variable.
type Exponents = Vec<u16>;

/// A proof that p is a sum of squares, or for p > 0 one with a positive number; `None` where none is found, and that says
/// nothing.
pub(super) fn by_squares(problem: &Problem, relation: Relation, work: &mut Work) -> Option<SignProof> {
    // On a bounded box other methods are at their best.
    if problem.ranges.iter().all(|(_, r)| r.low != End::Infinite && r.high != End::Infinite) {
        return None;
    }
    let squares = match relation {
        Relation::NonNegative => squares(&problem.poly, work)?,
        Relation::Positive => {
            let constant = problem.poly.terms().find(|(m, c)| m.is_one() && c.is_positive())?.1.clone();
            let part = |parts: &i64| &constant * &Rational::new(1, *parts);
            let rests = PARTS.iter().map(|parts| &problem.poly - &Poly::constant(part(parts)));
            rests.into_iter().find_map(|rest| squares(&rest, work))?
        }
    };
    Some(SignProof::Squares { squares, rest: Box::new(SignProof::direct()) })
}

/// The squares of polynomials whose sum is p, each with a positive factor.
fn squares(p: &Poly, work: &mut Work) -> Option<Vec<(Rational, Poly)>> {
    let variables = p.variables();
    let of = |monomial: &Monomial| variables.mapped(|v| monomial.exponent(*v));
    let mut terms = SortedMap::new();
    for (monomial, coefficient) in p.terms() {
        terms.insert(of(monomial), coefficient.clone());
    }
    let monomials = monomials(&terms, work)?;
    let form = Form::new(&monomials, &terms, work)?;
    let base = form.evenly();
    let entries = if form.is_definite() {
        base
    } else {
        let zeros = zeros(p, &variables, &monomials, work)?;
        form.least(base, &zeros, work)?
    };
    let found = semidefinite(&form.matrix(monomials.len(), &entries), work)?.ok()?;
    let polynomial = |row: &[Rational]| {
        let term = |(exponents, factor): (&Exponents, &Rational)| {
            let powers = variables.iter().zip(exponents);
            (powers.fold(Monomial::one(), |m, (v, e)| m.with_exponent(*v, *e)), factor.clone())
        };
        Poly::from_terms(monomials.iter().zip(row).map(term))
    };
    let square = |(factor, row): (Rational, Vec<Rational>)| {
        let base = polynomial(&row);
        // With whole numbers as coefficients.
        let content = base.numeric_content();
        let whole = base.scale(&content.recip()?);
        Some((&factor * &(&content * &content), whole))
    };
    found.into_iter().map(square).collect()
}

/// The sum of the exponents of two monomials.
fn product(a: &[u16], b: &[u16]) -> Exponents {
    a.iter().zip(b).map(|(a, b)| a + b).listed()
}

/// The monomials of which squares with this sum consist at most: those whose square occurs with a positive coefficient, or
/// is another product of two of them.
fn monomials(terms: &SortedMap<Exponents, Rational>, work: &mut Work) -> Option<Vec<Exponents>> {
    let total = |e: &Exponents| e.iter().map(|e| u32::from(*e)).sum::<u32>();
    let (lowest, highest) = (terms.keys().map(total).min()?, terms.keys().map(total).max()?);
    if lowest % 2 == 1 || highest % 2 == 1 {
        return None;
    }
    let count = terms.keys().next()?.len();
    let mut all: Vec<Exponents> = vec![Vec::new()];
    for k in 0..count {
        let degree = terms.keys().map(|e| e[k]).max()?;
        let mut longer = Vec::new();
        for start in &all {
            let used = 2 * total(start);
            for e in (0..=degree / 2).filter(|e| used + 2 * u32::from(*e) <= highest) {
                longer.push([&start[..], &[e]].concat());
            }
        }
        all = longer;
        work.spend(all.len() as u64)?;
        if all.len() > MAX_CANDIDATES {
            return None;
        }
    }
    all.retain(|e| 2 * total(e) >= lowest);
    loop {
        work.spend((all.len() * all.len()) as u64)?;
        let mut products = SortedMap::new();
        for (i, a) in all.iter().enumerate() {
            for b in &all[i + 1..] {
                products.insert(product(a, b), ());
            }
        }
        let before = all.len();
        all.retain(|e| {
            let square = product(e, e);
            terms.get(&square).is_some_and(Rational::is_positive) || products.contains_key(&square)
        });
        if all.len() == before {
            break;
        }
    }
    (!all.is_empty() && all.len() <= MAX_MONOMIALS).then_some(all)
}

/// The equations for the entries of G, those of its upper half.
struct Form {
    /// The entries by the products to which they belong, each as row and column.
    classes: Vec<Vec<(usize, usize)>>,
    /// What the entries of a class add up to, those beside the diagonal taken twice.
    sums: Vec<Rational>,
}

/// How often an entry occurs in G.
const fn weight((i, j): (usize, usize)) -> i64 {
    if i == j { 1 } else { 2 }
}

impl Form {
    /// `None` where a term is no product of two monomials.
    fn new(monomials: &[Exponents], terms: &SortedMap<Exponents, Rational>, work: &mut Work) -> Option<Self> {
        work.spend((monomials.len() * monomials.len()) as u64)?;
        let mut products: SortedMap<Exponents, Vec<(usize, usize)>> = SortedMap::new();
        for (i, a) in monomials.iter().enumerate() {
            for (j, b) in monomials.iter().enumerate().skip(i) {
                products.get_or_insert_with(product(a, b), Vec::new).push((i, j));
            }
        }
        if terms.keys().any(|e| !products.contains_key(e)) {
            return None;
        }
        let sums = products.keys().map(|e| terms.get(e).cloned().unwrap_or(Rational::ZERO)).listed();
        Some(Self { classes: products.into_values(), sums })
    }

    /// Whether the equations leave no choice.
    fn is_definite(&self) -> bool {
        self.classes.iter().all(|class| class.len() == 1)
    }

    /// The entries of all classes, one after the other.
    fn entries(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.classes.iter().flatten().copied()
    }

    /// How often the entries of a class occur together.
    fn weight_of(class: &[(usize, usize)]) -> Rational {
        Rational::from(class.iter().map(|place| weight(*place)).sum::<i64>())
    }

    /// The entries that are equal within each class.
    fn evenly(&self) -> Vec<Rational> {
        let even = |(class, sum): (&Vec<(usize, usize)>, &Rational)| {
            let entry = sum / &Self::weight_of(class);
            class.mapped(|_| entry.clone())
        };
        self.classes.iter().zip(&self.sums).flat_map(even).listed()
    }

    /// The least entries with G·z = 0 for some vectors z; `None` where there are none.
    fn least(
        &self,
        mut base: Vec<Rational>,
        zeros: &[Vec<Rational>],
        work: &mut Work,
    ) -> Option<Vec<Rational>> {
        // Equations Σ gₖ·vₖ·wₖ = c, the vectors v within the space in which the sums of the classes do not change.
        let mut rows: Vec<Vec<Rational>> = Vec::new();
        for zero in zeros {
            for i in 0..zero.len() {
                let row = self.row(i, zero);
                let weighted = self.entries().zip(row.iter().zip(&base));
                let value = weighted.fold(Rational::ZERO, |sum, (place, (v, g))| {
                    &sum + &(&(v * g) * &Rational::from(weight(place)))
                });
                work.spend(6 * base.len() as u64)?;
                rows.push(self.along(row).into_iter().chain([-value]).listed());
            }
        }
        let rows = independent_equations(rows, base.len(), work)?;
        let scalar = |a: &[Rational], b: &[Rational]| {
            let pairs = self.entries().zip(a.iter().zip(b));
            pairs.fold(Rational::ZERO, |sum, (place, (a, b))| {
                &sum + &(&(a * b) * &Rational::from(weight(place)))
            })
        };
        work.spend((3 * rows.len() * rows.len() * base.len()) as u64)?;
        let system = rows.mapped(|a| {
            let products = rows.iter().map(|b| scalar(a, b));
            products.chain([a[base.len()].clone()]).listed()
        });
        let count = rows.len();
        let solved = independent_equations(system, count, work)?;
        for (k, equation) in solved.iter().enumerate() {
            // In reduced echelon form, with the unknown number k in front of row k.
            for (entry, v) in base.iter_mut().zip(&rows[k]) {
                *entry += &(v * &equation[count]);
            }
        }
        Some(base)
    }

    /// The row i of G times z as Σ gₖ·vₖ·wₖ: the numbers v.
    fn row(&self, i: usize, z: &[Rational]) -> Vec<Rational> {
        let half = Rational::new(1, 2);
        self.entries()
            .map(|(a, b)| match (a == i, b == i) {
                (true, true) => z[i].clone(),
                (true, false) => &z[b] * &half,
                (false, true) => &z[a] * &half,
                (false, false) => Rational::ZERO,
            })
            .listed()
    }

    /// A vector without what changes the sums of the classes.
    fn along(&self, mut v: Vec<Rational>) -> Vec<Rational> {
        let mut start = 0;
        for class in &self.classes {
            let own = &mut v[start..start + class.len()];
            let weighted = class.iter().zip(own.iter());
            let sum = weighted
                .fold(Rational::ZERO, |sum, (place, v)| &sum + &(v * &Rational::from(weight(*place))));
            let mean = &sum / &Self::weight_of(class);
            for v in own {
                *v -= &mean;
            }
            start += class.len();
        }
        v
    }

    /// The matrix of these entries.
    fn matrix(&self, size: usize, entries: &[Rational]) -> Vec<Vec<Rational>> {
        let mut matrix = vec![vec![Rational::ZERO; size]; size];
        for ((i, j), entry) in self.entries().zip(entries) {
            matrix[i][j] = entry.clone();
            matrix[j][i] = entry.clone();
        }
        matrix
    }
}

/// The values of the monomials at zeros of p with coordinates −1, 0 and 1, each up to a factor once.
fn zeros(
    p: &Poly,
    variables: &[Var],
    monomials: &[Exponents],
    work: &mut Work,
) -> Option<Vec<Vec<Rational>>> {
    let mut found: Vec<Vec<Rational>> = Vec::new();
    if variables.len() > MAX_VARIABLES {
        return Some(found);
    }
    let last = variables.last()?.0;
    for number in 0..3_usize.pow(variables.len() as u32) {
        let mut rest = number;
        let coordinates = variables.mapped(|_| {
            let digit = rest % 3;
            rest /= 3;
            digit as i64 - 1
        });
        let mut at = vec![Rational::ZERO; last + 1];
        for (var, x) in variables.iter().zip(&coordinates) {
            at[var.0] = Rational::from(*x);
        }
        work.spend((p.len() * variables.len()) as u64)?;
        if !p.eval(&at).is_zero() {
            continue;
        }
        let value = |e: &Exponents| {
            let powers = coordinates.iter().zip(e).map(|(x, e)| x.pow(u32::from(*e)));
            powers.product::<i64>()
        };
        let values = monomials.mapped(value);
        // The other sense says the same.
        let sense = values.iter().find(|v| **v != 0).copied().unwrap_or(0);
        let values = values.mapped(|v| Rational::from(v * sense));
        if sense != 0 && !found.contains(&values) {
            found.push(values);
        }
    }
    Some(found)
}

//! Matrices of numbers and of polynomials: rank, determinants, combinations of rows that vanish.

use super::divisors::gcd::{checked_product, gcd_all};
use super::divisors::modular;
use super::poly::Poly;
use super::rational::Rational;
use super::work::{Spent, Work};
use crate::collections::list::{Listed, Mapped};
use crate::collections::sort::{sort, sort_by};

/// A matrix by rows.
pub type Rows<T> = Vec<Vec<T>>;

/// The columns in which an elimination of numbers finds its pivots: as many as the rank; `None` when the work is spent.
pub fn pivot_columns(rows: &[Vec<Rational>], work: &mut Work) -> Option<Vec<usize>> {
    // A minor that is not zero modulo a prime is not zero: nearly always this is all that is to be done.
    if let Some(columns) = modular::pivot_columns(rows, work).ok()?
        && columns.len() == rows.len()
    {
        return Some(columns);
    }
    let mut rows = rows.to_vec();
    let mut columns = Vec::new();
    let width = rows.first().map_or(0, Vec::len);
    for column in 0..width {
        let done = columns.len();
        let Some(pivot) = (done..rows.len()).find(|r| !rows[*r][column].is_zero()) else { continue };
        rows.swap(done, pivot);
        let (upper, lower) = rows.split_at_mut(done + 1);
        eliminate(&upper[done], lower.iter_mut(), column, work)?;
        columns.push(column);
    }
    Some(columns)
}

/// Subtracts multiples of a row, so that a column becomes zero in the others; `None` when the work is spent.
fn eliminate<'a>(
    pivot: &[Rational],
    others: impl Iterator<Item = &'a mut Vec<Rational>>,
    column: usize,
    work: &mut Work,
) -> Option<()> {
    for row in others {
        if row[column].is_zero() {
            continue;
        }
        let factor = &row[column] / &pivot[column];
        for (x, p) in row.iter_mut().zip(pivot) {
            if !p.is_zero() {
                work.spend_fractions(p.bits().max(x.bits()) + factor.bits())?;
                *x -= &(p * &factor);
            }
        }
    }
    Some(())
}

/// Equations with their right sides behind the factors of the unknowns, in reduced echelon form and without those that
/// follow from others; `None` when they contradict one another, or the work is spent.
pub fn independent_equations(
    equations: Rows<Rational>,
    unknowns: usize,
    work: &mut Work,
) -> Option<Rows<Rational>> {
    let mut reduced: Vec<(usize, Vec<Rational>)> = Vec::new();
    for mut row in equations {
        for (column, other) in &reduced {
            eliminate(other, core::iter::once(&mut row), *column, work)?;
        }
        let Some(column) = (0..unknowns).find(|k| !row[*k].is_zero()) else {
            if row[unknowns].is_zero() {
                continue;
            }
            return None;
        };
        let factor = row[column].recip()?;
        for x in &mut row {
            *x = &*x * &factor;
        }
        eliminate(&row, reduced.iter_mut().map(|(_, other)| other), column, work)?;
        reduced.push((column, row));
    }
    sort_by(&mut reduced, |a, b| a.0.cmp(&b.0));
    Some(reduced.into_iter().map(|(_, row)| row).listed())
}

/// The determinant of a square matrix of numbers; `None` when the work is spent.
pub fn determinant(mut rows: Rows<Rational>, work: &mut Work) -> Option<Rational> {
    let mut result = Rational::ONE;
    for column in 0..rows.len() {
        let Some(pivot) = (column..rows.len()).find(|r| !rows[*r][column].is_zero()) else {
            return Some(Rational::ZERO);
        };
        if pivot != column {
            rows.swap(pivot, column);
            result = -result;
        }
        result *= &rows[column][column];
        let (upper, lower) = rows.split_at_mut(column + 1);
        eliminate(&upper[column], lower.iter_mut(), column, work)?;
    }
    Some(result)
}

/// Whole numbers cᵢ without common factor, not all zero, with Σ cᵢ rowᵢ = 0; `None` when the rows are independent.
///
/// The first of them that is not zero is positive; of several combinations the one with the fewest and smallest numbers
/// that the elimination finds.
///
/// # Errors
/// When the work is spent.
pub fn vanishing_combination(
    rows: &[Vec<Rational>],
    work: &mut Work,
) -> Result<Option<Vec<Rational>>, Spent> {
    if modular::pivot_columns(rows, work)?.is_some_and(|columns| columns.len() == rows.len()) {
        return Ok(None);
    }
    let size = |row: &Vec<Rational>| {
        let count = row.iter().filter(|c| !c.is_zero()).count();
        (count, row.iter().fold(Rational::ZERO, |sum, c| &sum + &c.abs()))
    };
    // One row more than there are columns is enough for a combination.
    let enough = rows.len().min(rows.first().map_or(0, Vec::len) + 1);
    let all = vanishing_combinations(&rows[..enough], work).ok_or(Spent)?;
    let mut best = all.into_iter().min_by_key(size);
    if let Some(best) = &mut best {
        best.resize(rows.len(), Rational::ZERO);
    }
    Ok(best)
}

/// A basis of all combinations cᵢ with Σ cᵢ rowᵢ = 0, in reduced echelon form; each of whole numbers without common
/// factor, the first that is not zero positive. `None` when the work is spent.
pub fn vanishing_combinations(rows: &[Vec<Rational>], work: &mut Work) -> Option<Rows<Rational>> {
    // Each row is extended by its unit vector, which records the operations.
    let (height, width) = (rows.len(), rows.first().map_or(0, Vec::len));
    let unit = |i: usize| (0..height).map(move |k| if k == i { Rational::ONE } else { Rational::ZERO });
    let mut rows: Rows<Rational> =
        rows.iter().enumerate().map(|(i, row)| row.iter().cloned().chain(unit(i)).listed()).listed();
    let mut done = 0;
    for column in 0..width {
        let Some(pivot) = (done..height).find(|r| !rows[*r][column].is_zero()) else { continue };
        rows.swap(done, pivot);
        let (upper, lower) = rows.split_at_mut(done + 1);
        eliminate(&upper[done], lower.iter_mut(), column, work)?;
        done += 1;
    }
    // What is left of the other rows are independent combinations; reduced among themselves they are simple.
    let mut combinations: Rows<Rational> =
        rows.split_off(done).into_iter().map(|row| row[width..].to_vec()).listed();
    let mut reduced = 0;
    for column in 0..height {
        let Some(pivot) = (reduced..combinations.len()).find(|r| !combinations[*r][column].is_zero()) else {
            continue;
        };
        combinations.swap(reduced, pivot);
        let row = combinations[reduced].clone();
        let others = combinations.iter_mut().enumerate().filter(|(k, _)| *k != reduced).map(|(_, r)| r);
        eliminate(&row, others, column, work)?;
        reduced += 1;
    }
    let whole = |row: &Vec<Rational>| {
        let content = row.iter().fold(Rational::ZERO, |g, c| g.gcd(c));
        let lead = row.iter().find(|c| !c.is_zero())?;
        let factor = if lead.is_negative() { -content } else { content }.recip()?;
        Some(row.mapped(|c| c * &factor))
    };
    Some(combinations.iter().filter_map(whole).listed())
}

/// The determinant of the square matrix of some columns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Minor {
    /// The columns, in increasing order, as many as there are rows.
    pub columns: Vec<usize>,
    /// The determinant, up to its sign.
    pub value: Poly,
}

/// Maximal minors that are not the zero polynomial, the simplest first: those that differ in one column, the one that
/// elimination takes last. None when the rows are dependent for all values of the parameters; `None` when the work is
/// spent.
pub fn nonzero_minors(rows: &[Vec<Poly>], work: &mut Work) -> Option<Vec<Minor>> {
    let mut elimination = Elimination::new(rows);
    elimination.run(work)?;
    if elimination.columns.len() < rows.len() {
        return Some(Vec::new());
    }
    // After Bareiss a pivot is the determinant up to the factors that were taken out.
    let fixed = elimination.columns.split_last().map_or(&[][..], |(_, fixed)| fixed);
    let mut minors = Vec::new();
    for (column, pivot) in &elimination.last_choices {
        let mut columns = [fixed, &[*column]].concat();
        sort(&mut columns);
        let value =
            elimination.factors.iter().try_fold(pivot.clone(), |d, f| checked_product(&d, f, work))?;
        minors.push(Minor { columns, value });
    }
    if rows.is_empty() {
        minors.push(Minor { columns: Vec::new(), value: Poly::one() });
    }
    sort_by(&mut minors, |m, n| {
        (m.value.total_degree(), m.value.len()).cmp(&(n.value.total_degree(), n.value.len()))
    });
    Some(minors)
}

/// The determinant of the columns of a matrix, up to its sign; `None` when the work is spent or there are not as many
/// columns as rows.
pub fn minor(rows: &[Vec<Poly>], columns: &[usize], work: &mut Work) -> Option<Poly> {
    let square: Option<Rows<Poly>> =
        rows.iter().map(|row| columns.iter().map(|c| row.get(*c).cloned()).collect()).collect();
    if columns.len() != rows.len() {
        return None;
    }
    Some(nonzero_minors(&square?, work)?.pop().map_or_else(Poly::zero, |m| m.value))
}

/// The rank over the rational functions of the parameters: the rank for all values but exceptional ones.
pub fn generic_rank(rows: &[Vec<Poly>], work: &mut Work) -> Option<usize> {
    let mut elimination = Elimination::new(rows);
    elimination.run(work)?;
    Some(elimination.columns.len())
}

/// Polynomials cᵢ without common factor, not all zero, with Σ cᵢ rowᵢ = 0; none when the rows are independent.
///
/// `None` when the work is spent.
pub fn polynomial_combination(rows: &[Vec<Poly>], work: &mut Work) -> Option<Vec<Poly>> {
    let height = rows.len();
    let width = rows.first().map_or(0, Vec::len);
    let unit = |i: usize| (0..height).map(move |k| if k == i { Poly::one() } else { Poly::zero() });
    let extended: Rows<Poly> =
        rows.iter().enumerate().map(|(i, row)| row.iter().cloned().chain(unit(i)).listed()).listed();
    let mut elimination = Elimination::new(&extended);
    elimination.width = width;
    elimination.run(work)?;
    let Some(row) = elimination.left.first() else { return Some(Vec::new()) };
    let combination = &elimination.rows[*row][width..];
    let common = gcd_all(combination, work)?;
    let divided: Option<Vec<Poly>> = combination.iter().map(|p| p.div_exact(&common)).collect();
    let divided = divided?;
    let negative = divided.iter().find_map(Poly::leading_term).is_some_and(|(_, c)| c.is_negative());
    Some(if negative { divided.mapped(|p| -p) } else { divided })
}

/// An elimination in progress.
struct Elimination {
    rows: Rows<Poly>,
    /// The columns in which pivots are looked for.
    width: usize,
    /// The rows without a pivot so far.
    left: Vec<usize>,
    /// The columns of the pivots.
    columns: Vec<usize>,
    /// Factors of the determinant that were taken out of rows, and pivots that are numbers.
    factors: Vec<Poly>,
    /// The last pivot of the fraction-free part.
    last: Poly,
    /// The columns that could be that of the last pivot, with what it would be.
    last_choices: Vec<(usize, Poly)>,
}

impl Elimination {
    fn new(rows: &[Vec<Poly>]) -> Self {
        Self {
            rows: rows.to_vec(),
            width: rows.first().map_or(0, Vec::len),
            left: (0..rows.len()).listed(),
            columns: Vec::new(),
            factors: Vec::new(),
            last: Poly::one(),
            last_choices: Vec::new(),
        }
    }

    /// Eliminates until no pivot is left: first with pivots that are numbers, which make no entries grow, then by the
    /// fraction-free scheme of Bareiss.
    fn run(&mut self, work: &mut Work) -> Option<()> {
        while let Some((row, column)) = self.best_pivot(|p| p.as_constant().is_some()) {
            self.plain_step(row, column, work)?;
        }
        for row in self.left.clone() {
            self.take_content(row, work)?;
        }
        while let Some((row, column)) = self.best_pivot(|_| true) {
            self.bareiss_step(row, column, work)?;
        }
        Some(())
    }

    /// The entry among those allowed that is not zero and leads to the least work.
    fn best_pivot(&self, allowed: impl Fn(&Poly) -> bool) -> Option<(usize, usize)> {
        let free: Vec<usize> = (0..self.width).filter(|c| !self.columns.contains(c)).listed();
        let in_column: Vec<usize> = (0..self.width)
            .map(|c| self.left.iter().filter(|r| !self.rows[**r][c].is_zero()).count())
            .listed();
        let mut best = None;
        for row in &self.left {
            let in_row = free.iter().filter(|c| !self.rows[*row][**c].is_zero()).count();
            for column in &free {
                let entry = &self.rows[*row][*column];
                if !entry.is_zero() && allowed(entry) {
                    let cost = (entry.len(), entry.total_degree(), (in_row - 1) * (in_column[*column] - 1));
                    if best.as_ref().is_none_or(|(c, _)| cost < *c) {
                        best = Some((cost, (*row, *column)));
                    }
                }
            }
        }
        best.map(|(_, place)| place)
    }

    fn use_pivot(&mut self, row: usize, column: usize) -> Vec<Poly> {
        self.left.retain(|r| *r != row);
        self.columns.push(column);
        core::mem::take(&mut self.rows[row])
    }

    /// row_k := row_k − (a_k/a)·row for a number a.
    fn plain_step(&mut self, row: usize, column: usize, work: &mut Work) -> Option<()> {
        let inverse = self.rows[row][column].as_constant()?.recip()?;
        let pivot = self.use_pivot(row, column);
        if self.left.is_empty() {
            self.last_choices = vec![(column, pivot[column].clone())];
            return Some(());
        }
        self.factors.push(pivot[column].clone());
        for k in &self.left {
            let factor = self.rows[*k][column].scale(&inverse);
            if factor.is_zero() {
                continue;
            }
            for (x, p) in self.rows[*k].iter_mut().zip(&pivot) {
                if !p.is_zero() {
                    *x = &*x - &checked_product(p, &factor, work)?;
                }
            }
        }
        Some(())
    }

    /// Divides a row by the common factor of its entries.
    fn take_content(&mut self, row: usize, work: &mut Work) -> Option<()> {
        let common = gcd_all(&self.rows[row], work)?;
        if !common.is_zero() && !common.is_one() {
            for x in &mut self.rows[row] {
                *x = x.div_exact(&common)?;
            }
            self.factors.push(common);
        }
        Some(())
    }

    /// row_k := (a·row_k − a_k·row)/last, which is a polynomial.
    fn bareiss_step(&mut self, row: usize, column: usize, work: &mut Work) -> Option<()> {
        let pivot = self.use_pivot(row, column);
        if self.left.is_empty() {
            let free = (0..self.width).filter(|c| *c == column || !self.columns.contains(c));
            self.last_choices = free.filter(|c| !pivot[*c].is_zero()).map(|c| (c, pivot[c].clone())).listed();
            return Some(());
        }
        for k in &self.left {
            let factor = self.rows[*k][column].clone();
            for (x, p) in self.rows[*k].iter_mut().zip(&pivot) {
                if x.is_zero() && (p.is_zero() || factor.is_zero()) {
                    continue;
                }
                let scaled = checked_product(x, &pivot[column], work)?;
                let difference = &scaled - &checked_product(p, &factor, work)?;
                *x = difference.div_exact(&self.last)?;
            }
        }
        self.last = pivot[column].clone();
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::poly::Var;
    use crate::tests::letters::{n, x};

    fn numbers(rows: &[&[i64]]) -> Rows<Rational> {
        rows.iter().map(|r| r.iter().map(|c| Rational::from(*c)).collect()).collect()
    }
    fn work() -> Work {
        Work::unlimited()
    }

    #[test]
    fn numbers_rank_and_combination() {
        let m = numbers(&[&[1, 2, 3], &[2, 4, 6], &[0, 0, 5]]);
        let combination = |rows: &[&[i64]]| {
            let found = vanishing_combination(&numbers(rows), &mut work()).expect("unlimited");
            found.map(|c| c.iter().map(ToString::to_string).collect::<Vec<_>>().join(" "))
        };
        assert_eq!(pivot_columns(&m, &mut work()), Some(vec![0, 2]));
        assert_eq!(combination(&[&[1, 2, 3], &[2, 4, 6], &[0, 0, 5]]).as_deref(), Some("2 -1 0"));
        assert_eq!(combination(&[&[1, 0], &[0, 2]]), None);
        assert_eq!(combination(&[&[0, 0]]).as_deref(), Some("1"));
        assert_eq!(combination(&[]), None);
        // Three rows of two numbers are dependent, whatever comes after them.
        assert_eq!(combination(&[&[1, 0], &[0, 1], &[3, 2], &[7, 7]]).as_deref(), Some("3 2 -1 0"));
        let determinant = |rows: &[&[i64]]| determinant(numbers(rows), &mut work());
        assert_eq!(determinant(&[&[0, 2, 1], &[1, 0, 3], &[2, 1, 0]]), Some(Rational::from(13)));
        assert_eq!(determinant(&[&[1, 2], &[2, 4]]), Some(Rational::ZERO));
    }

    #[test]
    fn a_rank_that_a_prime_does_not_show() {
        // Modulo the prime the rows are the same.
        let p = modular::PRIME as i64;
        let m = numbers(&[&[1, 1], &[1, 1 + p]]);
        assert_eq!(modular::pivot_columns(&m, &mut work()), Ok(Some(vec![0])));
        assert_eq!(pivot_columns(&m, &mut work()), Some(vec![0, 1]));
        assert_eq!(vanishing_combination(&m, &mut work()), Ok(None));
        // It divides a denominator.
        let m = vec![vec![Rational::new(1, p), Rational::ONE]];
        assert_eq!(modular::pivot_columns(&m, &mut work()), Ok(None));
        assert_eq!(pivot_columns(&m, &mut work()), Some(vec![0]));
    }

    #[test]
    fn eliminations_of_large_numbers_end() {
        // Dependent, and with numbers that grow: seconds of work for the exact elimination.
        let entry = |i: i64, j: u32| Rational::new(i * i + 3, i + 2).pow(j);
        let m: Rows<Rational> =
            (0..60_i64).map(|i| (0..40).map(|j| &entry(i, j) + &Rational::ONE).collect()).collect();
        assert_eq!(vanishing_combination(&m, &mut Work::new(1_000_000)), Err(Spent));
        assert_eq!(pivot_columns(&m, &mut Work::new(1_000_000)), None);
        // Full rank needs no large numbers.
        let few = &m[..20];
        assert_eq!(pivot_columns(few, &mut Work::new(10_000)).map(|c| c.len()), Some(20));
    }

    #[test]
    fn determinants_of_polynomials() {
        // Vandermonde of x, 2, x²
        let row = |p: &Poly| vec![n(1), p.clone(), p.pow(2)];
        let m = vec![row(&x()), row(&n(2)), row(&x().pow(2))];
        let value = minor(&m, &[0, 1, 2], &mut work()).expect("unlimited");
        let expected = &(&(&n(2) - &x()) * &(&x().pow(2) - &x())) * &(&x().pow(2) - &n(2));
        assert_eq!(value.normalized(), expected.normalized());
        assert_eq!(minor(&m, &[0, 1], &mut work()), None);
        assert_eq!(minor(&m, &[0, 1, 2], &mut Work::new(10)), None);
        let dependent = vec![row(&x()), row(&n(2)), row(&x())];
        assert_eq!(minor(&dependent, &[0, 1, 2], &mut work()), Some(Poly::zero()));
        assert_eq!(generic_rank(&dependent, &mut work()), Some(2));
        assert_eq!(nonzero_minors(&dependent, &mut work()), Some(vec![]));
    }

    #[test]
    fn determinant_without_numbers_as_entries() {
        let (a, b, c) = (&x() + &n(1), &x() - &n(3), x().pow(2));
        let y = Poly::var(Var(1));
        let m = vec![
            vec![a.clone(), b.clone(), y.clone()],
            vec![b.clone(), &c + &y, a.clone()],
            vec![y.clone(), c.clone(), b.clone()],
        ];
        let [p, q, r] = [&m[0], &m[1], &m[2]];
        let two = |i: usize, j: usize| &(&q[i] * &r[j]) - &(&q[j] * &r[i]);
        let expected = &(&(&p[0] * &two(1, 2)) - &(&p[1] * &two(0, 2))) + &(&p[2] * &two(0, 1));
        let value = minor(&m, &[0, 1, 2], &mut work()).expect("unlimited");
        assert_eq!(value.normalized(), expected.normalized());
        assert_eq!(value.numeric_content(), expected.numeric_content());
    }

    #[test]
    fn combinations_of_polynomials() {
        let m = vec![vec![n(1), x()], vec![x(), n(1)], vec![n(1), n(1)]];
        let c = polynomial_combination(&m, &mut work()).expect("unlimited");
        let column = |j: usize| m.iter().zip(&c).fold(n(0), |s, (row, c)| &s + &(c * &row[j]));
        assert!(column(0).is_zero() && column(1).is_zero());
        // (x + 1)·(row 3) = row 1 + row 2
        assert_eq!(c, vec![n(1), n(1), -&(&x() + &n(1))]);
    }
}

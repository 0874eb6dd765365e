//! From a point that a search has found to a refutation that the kernel accepts.

use crate::collections::sort::sort_by_key;
use std::rc::Rc;

use basis_kernel::{Point, Quotient, Refusal, Refutation, Root, Statement, Witness};

use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::real::algebraic::Algebraic;
use crate::algebra::real::field::{Element, Field, field_of};
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;
use crate::coordinate::Coordinate;

/// A point at which a statement fails.
#[derive(Clone, Debug)]
pub struct Counterexample {
    /// The statement and where it fails, as the kernel has accepted it.
    pub refutation: Refutation,
    /// The coordinates of the point, each as a number of its own.
    pub point: Vec<(Var, Coordinate)>,
    /// The same in one field.
    pub(crate) exact: Exact,
}

impl Counterexample {
    /// The point with another coordinate, at which the statement need not fail; `None` where the work is spent.
    pub fn with(&self, var: Var, coordinate: Coordinate) -> Option<Self> {
        let work = &mut Work::new(EVALUATING);
        let mut point = self.point.clone();
        point.retain(|(v, _)| *v != var);
        point.push((var, coordinate));
        sort_by_key(&mut point, |(v, _)| *v);
        let exact = Exact::new(&point, work)?;
        Some(Self { point, exact, ..self.clone() })
    }

    /// The value that is not as claimed, or where it is irrational a number next to it, with its sign; and whether it is
    /// the value itself. `None` where there is no value, or the work is spent.
    pub fn value(&self) -> Option<(Rational, bool)> {
        if let Some(value) = self.refutation.value() {
            return Some((value.clone(), true));
        }
        let (Statement::Zero { value, .. } | Statement::Sign { value, .. }) = self.refutation.statement()
        else {
            return None;
        };
        match self.evaluate(value)? {
            Coordinate::Rational(x) => Some((x, true)),
            Coordinate::Algebraic(x) => next_to(x).map(|x| (x, false)),
        }
    }

    /// The value of a quotient at the point; `None` where it has none, or the work is spent.
    pub fn evaluate(&self, value: &Quotient) -> Option<Coordinate> {
        let work = &mut Work::new(EVALUATING);
        let mut exact = self.exact.clone();
        let below = exact.value(&value.denominator, work)?;
        if exact.is_zero(&below, work)? {
            return None;
        }
        let above = exact.value(&value.numerator, work)?;
        let Some(field) = &exact.field else {
            return Some(Coordinate::Rational(above.leading().checked_div(&below.leading())?));
        };
        let mut field = field.clone();
        let inverse = field.inverse(&below, work)?;
        let quotient = field.mul(&above, &inverse, work)?;
        number(Some(&field), &quotient, work)
    }
}

/// A rational number that differs from an irrational one by less than a millionth of it.
fn next_to(mut x: Algebraic) -> Option<Rational> {
    let work = &mut Work::new(EVALUATING);
    while x.low().signum() * x.high().signum() <= 0 {
        x.refine_below(&(x.high() - x.low()), work)?;
    }
    let size = x.low().abs().min(x.high().abs());
    x.refine_below(&(&size * &Rational::new(1, 1_000_000)), work)?;
    Some(x.low().clone())
}

/// The work for a value at a point.
const EVALUATING: u64 = 5_000_000;

/// The value of a polynomial at a point that has a coordinate for each of its variables; `None` where the work is spent.
pub fn value_at(poly: &Poly, point: &[(Var, Coordinate)]) -> Option<Coordinate> {
    let work = &mut Work::new(EVALUATING);
    let exact = Exact::new(point, work)?;
    let value = exact.value(poly, work)?;
    number(exact.field.as_ref(), &value, work)
}

/// How often the interval of an irrational number is shortened to a sixteenth until the kernel sees all signs.
const ROUNDS: usize = 40;

/// A point with coordinates in one field.
#[derive(Clone, Debug)]
pub(crate) struct Exact {
    /// The field; `None` when all coordinates are rational.
    pub(crate) field: Option<Field>,
    pub(crate) coordinates: Vec<(Var, Element)>,
}

impl Exact {
    /// The point with these coordinates; `None` when the work is spent.
    pub(crate) fn new(point: &[(Var, Coordinate)], work: &mut Work) -> Option<Self> {
        let mut numbers = Vec::new();
        for (_, c) in point {
            if let Coordinate::Algebraic(x) = c
                && !numbers.contains(x)
            {
                numbers.push(x.clone());
            }
        }
        let (field, elements) = match field_of(&numbers, work) {
            Some((field, elements)) => (Some(field), elements),
            None if numbers.is_empty() => (None, Vec::new()),
            None => return None,
        };
        let mut coordinates = Vec::new();
        for (var, c) in point {
            let element = match c {
                Coordinate::Rational(x) => Univariate::new(vec![x.clone()]),
                Coordinate::Algebraic(x) => elements.get(numbers.iter().position(|n| n == x)?).cloned()?,
            };
            coordinates.push((*var, element));
        }
        Some(Self { field, coordinates })
    }

    /// The value of a polynomial at the point.
    pub(crate) fn value(&self, poly: &Poly, work: &mut Work) -> Option<Element> {
        match &self.field {
            Some(field) => field.eval(poly, &self.coordinates, work),
            None => {
                let mut rest = poly.clone();
                for (var, x) in &self.coordinates {
                    rest = rest.at(*var, &x.leading());
                }
                Some(Univariate::new(vec![rest.as_constant()?]))
            }
        }
    }

    /// Whether a value is zero.
    pub(crate) fn is_zero(&mut self, value: &Element, work: &mut Work) -> Option<bool> {
        match &mut self.field {
            Some(field) => field.is_zero(value, work),
            None => Some(value.is_zero()),
        }
    }

    /// Adds coordinates that are polynomials in others, and takes away all that are not wanted.
    pub(crate) fn image(
        &mut self,
        by: &[(Var, Poly)],
        keep: &dyn Fn(Var) -> bool,
        work: &mut Work,
    ) -> Option<()> {
        let mut moved = Vec::new();
        for (var, poly) in by {
            moved.push((*var, self.value(poly, work)?));
        }
        self.coordinates.retain(|(var, _)| keep(*var));
        self.coordinates.extend(moved);
        sort_by_key(&mut self.coordinates, |(var, _)| *var);
        Some(())
    }

    /// The point as the kernel has it.
    fn point(&self, work: &mut Work) -> Option<Point> {
        let Some(field) = &self.field else {
            return Some(Point { root: None, coordinates: self.coordinates.clone() });
        };
        let mut coordinates = Vec::new();
        for (var, x) in &self.coordinates {
            coordinates.push((*var, field.reduce(x, work)?));
        }
        let root = field.root();
        let root = Root {
            polynomial: root.polynomial().clone(),
            low: root.low().clone(),
            high: root.high().clone(),
        };
        let irrational = coordinates.iter().any(|(_, x)| !x.is_constant());
        Some(Point { root: irrational.then_some(root), coordinates })
    }

    /// The coordinates as numbers.
    fn numbers(&self, work: &mut Work) -> Option<Vec<(Var, Coordinate)>> {
        let mut numbers = Vec::new();
        for (var, x) in &self.coordinates {
            numbers.push((*var, number(self.field.as_ref(), x, work)?));
        }
        Some(numbers)
    }

    /// The refutation at this point, with an interval of the root that is short enough for all signs to be seen; `None`
    /// when the kernel does not accept it.
    pub(crate) fn refute(
        &mut self,
        statement: &Rc<Statement>,
        witness: &dyn Fn(Point) -> Witness,
        work: &mut Work,
    ) -> Option<Refutation> {
        for _ in 0..ROUNDS {
            let witness = witness(self.point(work)?);
            match Refutation::new(Rc::clone(statement), witness, work) {
                Ok(refutation) => return Some(refutation),
                Err(Refusal::Vague) => {}
                Err(_) => return None,
            }
            let mut root = self.field.as_ref()?.root().clone();
            let width = &(root.high() - root.low()) * &Rational::new(1, 16);
            root.refine_below(&width, work)?;
            self.field = Some(Field::new(root));
        }
        None
    }
}

/// An element of a field as a number.
fn number(field: Option<&Field>, x: &Element, work: &mut Work) -> Option<Coordinate> {
    Some(match field {
        Some(field) => match field.number(&field.reduce(x, work)?, work)? {
            Ok(x) => Coordinate::Rational(x),
            Err(x) => Coordinate::Algebraic(x),
        },
        None => Coordinate::Rational(x.leading()),
    })
}

/// The refutation of a statement about a value at a point that has a coordinate for each of its variables; `None` when
/// it does not fail there, or the work is spent.
pub fn refute(
    statement: &Rc<Statement>,
    point: &[(Var, Coordinate)],
    work: &mut Work,
) -> Option<Counterexample> {
    let mut exact = Exact::new(point, work)?;
    at(statement, &mut exact, work)
}

/// As [`refute`], at a point in its field.
pub(crate) fn at(statement: &Rc<Statement>, exact: &mut Exact, work: &mut Work) -> Option<Counterexample> {
    if let Statement::Zero { value, .. } | Statement::Sign { value, .. } = &**statement {
        // Where the value is zero, the polynomial of the root has to divide it.
        let above = exact.value(&value.numerator, work)?;
        exact.is_zero(&above, work)?;
    }
    if let Statement::Sign { domain, .. } = &**statement {
        for (premise, _) in &domain.premises {
            let own = exact.value(premise, work)?;
            exact.is_zero(&own, work)?;
        }
        for simplex in &domain.simplices {
            let mut rest = Poly::constant(simplex.sum.clone());
            for var in &simplex.variables {
                rest = &rest - &Poly::var(*var);
                let own = exact.value(&Poly::var(*var), work)?;
                exact.is_zero(&own, work)?;
            }
            let left = exact.value(&rest, work)?;
            exact.is_zero(&left, work)?;
        }
    }
    // What plays no part has no place in the witness, but for what the statement is made for one value of: from that of a
    // tangent bounds for other variables come.
    let matters = |var: Var| match &**statement {
        Statement::Zero { value, domain } | Statement::Sign { value, domain, .. } => {
            let premises = domain.premises.iter().map(|(p, _)| p);
            let single = domain.region.range(var).finite().is_some_and(|(low, high)| low == high);
            single
                || [&value.numerator, &value.denominator]
                    .into_iter()
                    .chain(premises)
                    .any(|p| p.depends_on(var))
        }
        _ => true,
    };
    let mut own = exact.clone();
    own.coordinates.retain(|(var, _)| matters(*var));
    let refutation = own.refute(statement, &Witness::At, work)?;
    exact.field = own.field;
    let point = exact.numbers(work)?;
    Some(Counterexample { refutation, point, exact: exact.clone() })
}

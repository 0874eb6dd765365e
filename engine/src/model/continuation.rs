//! Curves that continue one another: the control points that an order of contact determines, for any family on an interval, from
//! the exact derivatives at the ends.

use super::theorem::{Form, GivenPoint, Unit};
use super::{Family, label};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::model::Parameter;

/// Which end of the given curve P is continued by the curve Q.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Q starts where P ends.
    After,
    /// Q ends where P starts.
    Before,
}

/// The control points of Q that a contact with P determines, both of one family:
/// Q = P, f·Q′ = P′ and f²·Q″ + c·Q′ = P″ where they meet, f > 0.
#[derive(Clone, Debug)]
pub struct Continuation {
    /// Which end is continued.
    pub side: Side,
    /// How many derivatives are concerned, 1 or 2.
    pub order: u32,
    /// The names of all variables: the shape parameters of P, those of Q, f, and c.
    pub names: Vec<String>,
    /// The variables with their ranges.
    pub scalars: Vec<Parameter>,
    /// The control points of P, then those of Q.
    pub points: Vec<GivenPoint>,
    /// The determined points of Q, by their positions among the functions, in terms of the other points.
    pub determined: Vec<(usize, Form)>,
    /// The derivatives at the end do not determine the points where this polynomial in the shape parameters of Q is zero.
    pub determinant: Poly,
}

/// The continuation with geometric continuity of an order; `None` for families on other domains and where the derivatives at
/// an end are linearly dependent for all shape values.
pub fn continuation(family: &Family, order: u32, side: Side) -> Option<Continuation> {
    let (var, low, high) = family.interval()?;
    let (shapes, len) = (family.shapes.len(), family.functions.len());
    let (here, there) = match side {
        Side::After => (high, low),
        Side::Before => (low, high),
    };
    // Shape parameters of P are variables 0, 1, …, those of Q follow, then f and c.
    let of = |offset: usize| -> Vec<Var> { (0..family.names.len()).map(|k| Var(k + offset)).collect() };
    let rows = |end: &Rational, names: &[Var]| -> Vec<Vec<Fraction>> {
        let mut functions: Vec<Fraction> = family.functions.iter().map(|f| f.value.clone()).collect();
        let mut rows = Vec::new();
        for _ in 0..=order {
            // A denominator has shape parameters only.
            let at = |f: &Fraction| {
                f.substitute(var, &Fraction::constant(end.clone())).unwrap_or_else(Fraction::zero)
            };
            rows.push(functions.iter().map(|f| at(f).rename(names)).collect());
            functions = functions.iter().map(|f| f.derivative(var)).collect();
        }
        rows
    };
    let (given, wanted) = (rows(here, &of(0)), rows(there, &of(shapes)));
    let columns = independent_columns(&wanted, side)?;
    let square: Vec<Vec<Fraction>> =
        wanted.iter().map(|row| columns.iter().map(|k| row[*k].clone()).collect()).collect();
    let (inverse, determinant) = inverse(square)?;
    // What f and c make of the derivatives of P, less what the other points of Q contribute.
    let (f, c) = (Var(2 * shapes), Var(2 * shapes + 1));
    let mut targets: Vec<Form> = Vec::new();
    for (k, row) in given.iter().enumerate() {
        let mut target = Form::default();
        add(&mut target, row.iter().enumerate().map(|(i, a)| (i, a.clone())));
        if k == 2 {
            let minus_c = -&Fraction::var(c);
            let first: Vec<(usize, Fraction)> = entries(&targets[1]);
            add(&mut target, first.into_iter().map(|(i, a)| (i, &a * &minus_c)));
        }
        let scale = Fraction::new(Poly::one(), Poly::var(f).pow(k as u32))?;
        let scaled: Vec<(usize, Fraction)> =
            entries(&target).into_iter().map(|(i, a)| (i, &a * &scale)).collect();
        let mut target = Form::default();
        add(&mut target, scaled.into_iter());
        targets.push(target);
    }
    for (target, row) in targets.iter_mut().zip(&wanted) {
        let others = (0..len).filter(|j| !columns.contains(j));
        add(target, others.map(|j| (len + j, -&row[j])));
    }
    let determined = columns
        .iter()
        .zip(&inverse)
        .map(|(column, row)| {
            let mut form = Form::default();
            for (target, factor) in targets.iter().zip(row) {
                add(&mut form, entries(target).into_iter().map(|(i, a)| (i, &a * factor)));
            }
            (*column, form)
        })
        .collect();
    let mut names = Vec::new();
    let mut scalars = Vec::new();
    for curve in ["P", "Q"] {
        for shape in &family.shapes {
            let (name, var) = (format!("{}_{curve}", shape.name), Var(names.len()));
            names.push(name.clone());
            let (doc, range, place) = (shape.doc.clone(), shape.range.clone(), shape.place.clone());
            scalars.push(Parameter { name, doc, place, var, range });
        }
    }
    for (name, var, range) in
        [("f", f, Range { low: End::Excluded(Rational::ZERO), high: End::Infinite }), ("c", c, Range::all())]
    {
        names.push(String::from(name));
        let place = family.place.clone();
        scalars.push(Parameter { name: String::from(name), doc: Vec::new(), place, var, range });
    }
    let points = ["P", "Q"].iter().enumerate().flat_map(|(patch, curve)| {
        family.functions.iter().map(move |f| {
            let (name, index) = (label(curve, &f.index), f.index.clone());
            GivenPoint { name, patch, index, coordinates: Vec::new() }
        })
    });
    let points = points.collect();
    Some(Continuation { side, order, names, scalars, points, determined, determinant })
}

fn entries(form: &Form) -> Vec<(usize, Fraction)> {
    let entry = |(unit, value): (&Unit, &Fraction)| match unit {
        Unit::Point(p) => Some((*p, value.clone())),
        Unit::Pair(..) => None,
    };
    form.terms.iter().filter_map(entry).collect()
}

fn add(form: &mut Form, parts: impl Iterator<Item = (usize, Fraction)>) {
    for (point, value) in parts {
        let unit = Unit::Point(point);
        let sum = &form.coefficient(unit) + &value;
        if sum.is_zero() {
            form.terms.remove(&unit);
        } else {
            form.terms.insert(unit, sum);
        }
    }
}

/// The first columns, from the start or from the end, that are linearly independent; as many as there are rows.
fn independent_columns(rows: &[Vec<Fraction>], side: Side) -> Option<Vec<usize>> {
    let len = rows.first()?.len();
    // Reduced columns with the row of the pivot of each.
    let mut basis: Vec<(usize, Vec<Fraction>)> = Vec::new();
    let mut columns = Vec::new();
    for k in 0..len {
        let k = if side == Side::After { k } else { len - 1 - k };
        let mut column: Vec<Fraction> = rows.iter().map(|row| row[k].clone()).collect();
        for (pivot, reduced) in &basis {
            let Some(factor) = column[*pivot].checked_div(&reduced[*pivot]) else { continue };
            for (x, y) in column.iter_mut().zip(reduced) {
                *x = &*x - &(&factor * y);
            }
        }
        if let Some(pivot) = column.iter().position(|x| !x.is_zero()) {
            basis.push((pivot, column));
            columns.push(k);
        }
        if columns.len() == rows.len() {
            columns.sort_unstable();
            return Some(columns);
        }
    }
    None
}

/// The inverse of a square matrix and the numerator of its determinant, by Gauss–Jordan elimination.
fn inverse(mut rows: Vec<Vec<Fraction>>) -> Option<(Vec<Vec<Fraction>>, Poly)> {
    let n = rows.len();
    let one = Fraction::constant(Rational::ONE);
    for (k, row) in rows.iter_mut().enumerate() {
        row.extend((0..n).map(|j| if j == k { one.clone() } else { Fraction::zero() }));
    }
    let mut determinant = one.clone();
    for k in 0..n {
        let pivot = (k..n).find(|r| !rows[*r][k].is_zero())?;
        rows.swap(k, pivot);
        let value = rows[k][k].clone();
        determinant = &determinant * &value;
        let reciprocal = one.checked_div(&value)?;
        for x in &mut rows[k] {
            *x = &*x * &reciprocal;
        }
        let pivot_row = rows[k].clone();
        for (r, row) in rows.iter_mut().enumerate() {
            let factor = row[k].clone();
            if r == k || factor.is_zero() {
                continue;
            }
            for (x, y) in row.iter_mut().zip(&pivot_row) {
                *x = &*x - &(&factor * y);
            }
        }
    }
    let inverse = rows.into_iter().map(|row| row[n..].to_vec()).collect();
    Some((inverse, determinant.numer().clone()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::theorem::Theorem;
    use crate::model::{Library, Selected};
    use crate::{Disk, Source};

    const QUADRATIC: &str = include_str!("../../../specs/quadratic.basis");
    const REVOLUTION: &str = include_str!("../../../specs/papers/revolution.basis");
    const BERNSTEIN: &str = "family Cubic { domain 0 <= t <= 1; b[i] = Bernstein(3)[i] for i in 0..=3; }";
    /// Twice as long an interval, functions that do not sum to 1, and one that matters at both ends.
    const UNEVEN: &str = "family Uneven {
        domain -1 <= t <= 1;
        shape 0 < α <= 2;
        b[0] = (1 - t)^3 + α*t; b[1] = (1 - t)^2*(1 + t); b[2] = t^2/α; b[3] = (1 + t)^3 - t;
    }";

    fn family(spec: &str) -> Family {
        let library = Library::from_source(&Disk, Source::text("spec.basis", spec));
        let family = library.items(Selected::EveryOrder).remove(0).family;
        assert!(library.diagnostics().is_empty());
        Family::clone(&family)
    }

    fn join(spec: &str, name: &str) -> Theorem {
        let library = Library::from_source(&Disk, Source::text("spec.basis", spec));
        library.theorems().into_iter().find(|t| t.name == name).expect("the join is there")
    }

    /// The determined points of a published join are the derived ones, with `by` in place of the variables of the latter.
    fn same(published: &Theorem, derived: &Continuation, by: &[(&str, Fraction)]) {
        let value = |name: &str| by.iter().find(|(n, _)| *n == name).map(|(_, f)| f.clone());
        let put = |weight: &Fraction| {
            // By way of variables that the join does not have, so that none is put into another.
            let aside = published.names.len();
            let names: Vec<Var> = (0..derived.names.len()).map(|k| Var(aside + k)).collect();
            derived.names.iter().enumerate().fold(weight.rename(&names), |w, (k, name)| {
                w.substitute(Var(aside + k), &value(name).expect("every variable has a value"))
                    .expect("not zero")
            })
        };
        for (position, form) in &derived.determined {
            let index = &derived.points[derived.points.len() / 2 + position].index;
            let point = published.patches[1].points.iter().find(|p| p.index == *index).expect("it is there");
            assert_eq!(form.terms.len(), point.value.terms.len());
            for (unit, weight) in &form.terms {
                let Unit::Point(p) = unit else { panic!("a point") };
                let name = &derived.points[*p].name;
                let q = published.points.iter().position(|g| g.name == *name).expect("it is given");
                assert_eq!(put(weight), point.value.coefficient(Unit::Point(q)), "{name}");
            }
        }
    }

    fn variable(theorem: &Theorem, name: &str) -> Fraction {
        Fraction::var(Var(theorem.names.iter().position(|n| n == name).expect("it is declared")))
    }

    #[test]
    fn published_joins_are_the_derived_ones() {
        let quadratic = family(QUADRATIC);
        for (name, order) in [("G1", 1), ("G2", 2)] {
            let published = join(QUADRATIC, name);
            let var = |name: &str| variable(&published, name);
            let c = if order == 2 { var("c") } else { Fraction::zero() };
            let by = [("λ_P", var("λ1")), ("λ_Q", var("λ2")), ("f", var("δ")), ("c", c)];
            same(&published, &continuation(&quadratic, order, Side::After).expect("derived"), &by);
        }
        // There the factor is on the other side: Q'(0) = α P'(1).
        let published = join(REVOLUTION, "G1");
        let var = |name: &str| variable(&published, name);
        let f = Fraction::constant(Rational::ONE).checked_div(&var("α")).expect("not zero");
        let by = [("λ_P", var("λ1")), ("λ_Q", var("λ2")), ("f", f), ("c", Fraction::zero())];
        same(&published, &continuation(&family(REVOLUTION), 1, Side::After).expect("derived"), &by);
    }

    #[test]
    fn the_determinant_tells_where_there_is_no_solution() {
        let quadratic = family(QUADRATIC);
        let shown = |order| {
            let derived = continuation(&quadratic, order, Side::After).expect("derived");
            derived.determinant.display(&derived.names).to_string()
        };
        assert_eq!([shown(1), shown(2)], ["2 + λ_Q", "4 - 2*λ_Q - 2*λ_Q^2"]);
    }

    #[test]
    fn cubic_bezier_curves() {
        let derived = continuation(&family(BERNSTEIN), 1, Side::Before).expect("derived");
        let (position, form) = &derived.determined[0];
        assert_eq!(*position, 2);
        let weights: Vec<String> = form.terms.values().map(|w| w.display(&derived.names)).collect();
        // Q[2] = P[0] - (P[1] - P[0])/f
        assert_eq!(weights, ["(1 + f)/f", "-1/f"]);
    }

    /// The conditions hold for every family: the derivatives of Q at its end are those that are asked for.
    #[test]
    fn the_conditions_hold() {
        for family in [family(QUADRATIC), family(REVOLUTION), family(BERNSTEIN), family(UNEVEN)] {
            for (order, side) in [(1, Side::After), (2, Side::After), (1, Side::Before), (2, Side::Before)] {
                let derived = continuation(&family, order, side).expect("derived");
                let len = family.functions.len();
                let (var, low, high) = family.interval().expect("an interval");
                let (here, there) = if side == Side::After { (high, low) } else { (low, high) };
                let shapes = family.shapes.len();
                let derivative = |end: &Rational, k: u32, offset: usize| -> Form {
                    let mut form = Form::default();
                    for (i, f) in family.functions.iter().enumerate() {
                        let f = (0..k).fold(f.value.clone(), |f, _| f.derivative(var));
                        let names: Vec<Var> =
                            (0..family.names.len()).map(|k| Var(k + offset * shapes)).collect();
                        let w = f
                            .substitute(var, &Fraction::constant(end.clone()))
                            .expect("a polynomial")
                            .rename(&names);
                        let point = derived.determined.iter().find(|(p, _)| offset == 1 && *p == i);
                        match point {
                            Some((_, value)) => {
                                add(&mut form, entries(value).into_iter().map(|(p, x)| (p, &x * &w)));
                            }
                            None => add(&mut form, core::iter::once((offset * len + i, w))),
                        }
                    }
                    form
                };
                let (f, c) = (Fraction::var(Var(2 * shapes)), Fraction::var(Var(2 * shapes + 1)));
                for k in 0..=order {
                    let mut difference = derivative(here, k, 0);
                    let scaled = |form: &Form, factor: Fraction| -> Vec<(usize, Fraction)> {
                        entries(form).into_iter().map(|(p, x)| (p, -&(&x * &factor))).collect()
                    };
                    add(&mut difference, scaled(&derivative(there, k, 1), f.pow(k)).into_iter());
                    if k == 2 {
                        add(&mut difference, scaled(&derivative(there, 1, 1), c.clone()).into_iter());
                    }
                    assert!(difference.is_zero(), "{}, order {order}, {side:?}, derivative {k}", family.name);
                }
            }
        }
    }
}

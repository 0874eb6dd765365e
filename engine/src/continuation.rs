//! Curves that continue one another: the control points that an order of contact determines, for any family on an
//! interval, from the exact derivatives at the ends.

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, PolyExt, Var};
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::{Family, Parameter, label};
use crate::theorem::{Form, GivenPoint, Unit};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::sort::sort;

/// The work for the control points at an end; formulas that take more are of no use to a reader.
const WORK: u64 = 200_000;

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
    /// The number of derivatives that are concerned, 1 or 2.
    pub order: u32,
    /// The names of all variables: the shape parameters of P, those of Q, f, and c.
    pub names: Vec<String>,
    /// The variables with their ranges.
    pub scalars: Vec<Parameter>,
    /// The control points of P, then those of Q.
    pub points: Vec<GivenPoint>,
    /// The determined points of Q, by their positions among the functions, in terms of the other points.
    pub determined: Vec<(usize, Form)>,
    /// The derivatives at the end do not determine the points where this polynomial in the shape parameters of Q is
    /// zero.
    pub determinant: Poly,
}

/// The control points next to an end of a curve C, in terms of its derivatives C, C′, … there and of its other control
/// points.
#[derive(Clone, Debug)]
pub struct EndPoints {
    /// The positions of the determined points among the functions, as many as there are derivatives.
    pub positions: Vec<usize>,
    /// The weights of the derivatives in each determined point.
    pub inverse: Vec<Vec<Fraction>>,
    /// The weights of other points in each determined point, with their positions; only those that are not zero.
    pub others: Vec<Vec<(usize, Fraction)>>,
    /// The derivatives do not determine the points where this polynomial in the shape parameters is zero.
    pub determinant: Poly,
}

impl EndPoints {
    /// The points that are determined by the derivatives up to each order from 0 on, at the start or else at the end of
    /// the domain. Left out is an order for which the derivatives are linearly dependent for all shape values, or the
    /// formulas would be too long; there are none for families on other domains.
    pub fn up_to(family: &Family, order: u32, at_start: bool) -> Vec<Self> {
        let work = &mut Work::new(WORK);
        let Some((var, low, high)) = family.interval() else { return Vec::new() };
        if family.leaves_an_end_out() {
            return Vec::new();
        }
        let end = if at_start { low } else { high };
        let Some(rows) = derivatives(family, var, end, order, work) else { return Vec::new() };
        (1..=rows.len()).filter_map(|count| Self::of(&rows[..count], at_start, work)).listed()
    }

    /// From the derivatives of all functions, one row for each order.
    fn of(rows: &[Vec<Fraction>], at_start: bool, work: &mut Work) -> Option<Self> {
        let positions = independent_columns(rows, at_start, work)?;
        let square = rows.mapped(|row| positions.mapped(|k| row[*k].clone()));
        let (inverse, determinant) = inverse(square, work)?;
        let mut others = Vec::new();
        for factors in &inverse {
            let mut weights = Vec::new();
            for k in (0..rows[0].len()).filter(|k| !positions.contains(k)) {
                let mut weight = Fraction::zero();
                for (factor, row) in
                    factors.iter().zip(rows).filter(|(f, row)| !f.is_zero() && !row[k].is_zero())
                {
                    weight = weight.sub_within(&factor.mul_within(&row[k], work)?, work)?;
                }
                if !weight.is_zero() {
                    weights.push((k, weight));
                }
            }
            others.push(weights);
        }
        Some(Self { positions, inverse, others, determinant })
    }
}

/// The derivatives of all functions at a number, one row for each order.
fn derivatives(
    family: &Family,
    var: Var,
    at: &Rational,
    order: u32,
    work: &mut Work,
) -> Option<Vec<Vec<Fraction>>> {
    let mut rows = vec![Vec::new(); order as usize + 1];
    for function in &family.functions {
        let (numer, denom) = (function.value.numer(), function.value.denom());
        if denom.depends_on(var) || !family.analytic.is_empty() {
            let mut derivative = function.value.clone();
            for (k, row) in rows.iter_mut().enumerate() {
                if k > 0 {
                    derivative = family.derivative_within(&derivative, var, work)?;
                }
                let value = derivative.substitute_within(var, &Fraction::constant(at.clone()), work);
                row.push(value.ok().flatten()?); // the denominator does not vanish on the domain
            }
            continue;
        }
        let coefficients = numer.coefficients_in(var);
        for (k, row) in rows.iter_mut().enumerate() {
            // Σ j!/(j-k)! at^(j-k) times the coefficient of the j-th power.
            let mut value = Poly::zero();
            for (j, coefficient) in coefficients.iter().enumerate().skip(k) {
                let power = at.pow((j - k) as u32);
                let factor = (0..k).fold(power, |product, i| &product * &Rational::from((j - i) as i64));
                if !factor.is_zero() {
                    work.spend(coefficient.len() as u64)?;
                    value = &value + &coefficient.scale(&factor);
                }
            }
            row.push(Fraction::new(value, denom.clone())?);
        }
    }
    Some(rows)
}

/// The continuation with geometric continuity of an order; `None` where there are no [`EndPoints`]. Of several spans one
/// curve ends on the last one, and the other starts on the first one.
pub fn continuation(family: &Family, order: u32, side: Side) -> Option<Continuation> {
    let (shapes, len) = (family.shapes.len(), family.functions.len());
    let (first, last) = outermost(family);
    let (of_p, of_q) = if side == Side::After { (last, first) } else { (first, last) };
    let ends = EndPoints::up_to(of_q, order, side == Side::After);
    let end = ends.into_iter().find(|end| end.positions.len() == order as usize + 1)?;
    let work = &mut Work::new(WORK);
    let (var, low, high) = of_p.interval()?;
    let given = derivatives(of_p, var, if side == Side::After { high } else { low }, order, work)?;
    // Shape parameters of P are variables 0, 1, …, those of Q follow, then f and c.
    let of_q: Vec<Var> = (0..family.names.len()).map(|k| Var(k + shapes)).listed();
    let (f, c) = (Var(2 * shapes), Var(2 * shapes + 1));
    // What f and c make of the derivatives of P: Q′ = P′/f, Q″ = (P″ − c·Q′)/f².
    let mut targets: Vec<Form> = Vec::new();
    for (k, row) in given.iter().enumerate() {
        let scale = Fraction::new(Poly::one(), Poly::var(f).pow(k as u32))?;
        let mut target = Form::default();
        for (i, weight) in row.iter().enumerate() {
            add(&mut target, i, weight, &scale, work)?;
        }
        if k == 2 {
            let factor = -&(&Fraction::var(c) * &scale);
            for (i, weight) in entries(&targets[1]) {
                add(&mut target, i, &weight, &factor, work)?;
            }
        }
        targets.push(target);
    }
    let one = Fraction::constant(Rational::ONE);
    let mut determined = Vec::new();
    for (row, position) in end.positions.iter().enumerate() {
        let mut form = Form::default();
        for (target, factor) in targets.iter().zip(&end.inverse[row]) {
            let factor = factor.rename(&of_q);
            for (i, weight) in entries(target) {
                add(&mut form, i, &weight, &factor, work)?;
            }
        }
        for (k, weight) in &end.others[row] {
            add(&mut form, len + k, &weight.rename(&of_q), &one, work)?;
        }
        determined.push((*position, form));
    }
    let determinant = end.determinant.rename(&of_q);
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
    let points = points.listed();
    Some(Continuation { side, order, names, scalars, points, determined, determinant })
}

/// The families on the first and on the last span.
pub(crate) fn outermost(family: &Family) -> (&Family, &Family) {
    match family.pieces.as_slice() {
        [] => (family, family),
        [first, .., last] => (first, last),
        [only] => (only, only),
    }
}

fn entries(form: &Form) -> Vec<(usize, Fraction)> {
    let entry = |(unit, value): (&Unit, &Fraction)| match unit {
        Unit::Point(p) => Some((*p, value.clone())),
        Unit::Pair(..) => None,
    };
    form.terms.iter().filter_map(entry).listed()
}

/// Adds weight·factor times a point; `None` when the work is spent.
fn add(form: &mut Form, point: usize, weight: &Fraction, factor: &Fraction, work: &mut Work) -> Option<()> {
    let unit = Unit::Point(point);
    let sum = form.coefficient(unit).add_within(&weight.mul_within(factor, work)?, work)?;
    if sum.is_zero() {
        form.terms.remove(&unit);
    } else {
        form.terms.insert(unit, sum);
    }
    Some(())
}

/// column − factor·other
fn subtract(column: &mut [Fraction], factor: &Fraction, other: &[Fraction], work: &mut Work) -> Option<()> {
    for (x, y) in column.iter_mut().zip(other) {
        if !y.is_zero() {
            *x = x.sub_within(&factor.mul_within(y, work)?, work)?;
        }
    }
    Some(())
}

/// The first columns, from the start or from the end, that are linearly independent; as many as there are rows.
fn independent_columns(rows: &[Vec<Fraction>], from_start: bool, work: &mut Work) -> Option<Vec<usize>> {
    let len = rows.first()?.len();
    // Reduced columns with the row of the pivot of each.
    let mut basis: Vec<(usize, Vec<Fraction>)> = Vec::new();
    let mut columns = Vec::new();
    for k in 0..len {
        let k = if from_start { k } else { len - 1 - k };
        let mut column: Vec<Fraction> = rows.mapped(|row| row[k].clone());
        for (pivot, reduced) in &basis {
            // A pivot is not zero.
            let factor = column[*pivot].div_within(&reduced[*pivot], work).ok().flatten()?;
            subtract(&mut column, &factor, reduced, work)?;
        }
        if let Some(pivot) = column.iter().position(|x| !x.is_zero()) {
            basis.push((pivot, column));
            columns.push(k);
        }
        if columns.len() == rows.len() {
            sort(&mut columns);
            return Some(columns);
        }
    }
    None
}

/// The inverse of a square matrix and the numerator of its determinant, by Gauss–Jordan elimination.
fn inverse(mut rows: Vec<Vec<Fraction>>, work: &mut Work) -> Option<(Vec<Vec<Fraction>>, Poly)> {
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
        determinant = determinant.mul_within(&value, work)?;
        let reciprocal = one.div_within(&value, work).ok().flatten()?;
        for x in &mut rows[k] {
            *x = x.mul_within(&reciprocal, work)?;
        }
        let pivot_row = rows[k].clone();
        for (r, row) in rows.iter_mut().enumerate() {
            let factor = row[k].clone();
            if r != k && !factor.is_zero() {
                subtract(row, &factor, &pivot_row, work)?;
            }
        }
    }
    let inverse = rows.into_iter().map(|row| row[n..].to_vec()).listed();
    Some((inverse, determinant.numer().clone()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Library, Selected};
    use crate::theorem::Theorem;
    use crate::theorem::theorems;
    use crate::{Disk, Prover, Source, Subject};

    const QUADRATIC: &str = include_str!("../../specs/quadratic.basis");
    const REVOLUTION: &str = include_str!("../../specs/papers/revolution.basis");
    const BERNSTEIN: &str = "family Cubic { domain 0 <= t <= 1; b[i] = Bernstein(3)[i] for i in 0..=3; }";
    /// Twice as long an interval, functions that do not sum to 1, and one that matters at both ends.
    const UNEVEN: &str = "family Uneven {
        domain -1 <= t <= 1;
        shape 0 < α <= 2;
        b[0] = (1 - t)^3 + α*t; b[1] = (1 - t)^2*(1 + t); b[2] = t^2/α; b[3] = (1 + t)^3 - t;
    }";

    fn family(spec: &str) -> Family {
        let library = Library::from_source(&Disk, &Prover, Source::text("spec.basis", spec));
        let family = library.items(Selected::EveryOrder).remove(0).subject;
        assert!(library.diagnostics().is_empty());
        match family {
            Subject::Family(family) => Family::clone(&family),
            Subject::Theorem(_) => panic!("a family"),
        }
    }

    fn join(library: &Library<'_>, name: &str) -> Theorem {
        let found = theorems(library).into_iter().find(|item| item.subject.name() == name);
        match found.expect("the join is there").subject {
            Subject::Theorem(theorem) => Theorem::clone(&theorem),
            Subject::Family(_) => panic!("a join"),
        }
    }

    /// The determined points of a published join are the derived ones, with `by` in place of the variables of the
    /// latter. `P` and `Q` say which points of the join the points of the curves are.
    fn same(
        published: &Theorem,
        derived: &Continuation,
        by: &[(&str, Fraction)],
        [p, q]: [&dyn Fn(i64) -> String; 2],
    ) {
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
            let name = q(*position as i64);
            let patch = &published.patches[1];
            let point =
                patch.points.iter().find(|p| label(&patch.name, &p.index) == name).expect("it is there");
            assert_eq!(form.terms.len(), point.value.terms.len());
            for (unit, weight) in &form.terms {
                let Unit::Point(k) = unit else { panic!("a point") };
                let of_p = derived.points[*k].patch == 0;
                let name = if of_p { p } else { q }(derived.points[*k].index[0]);
                let given = published.points.iter().position(|g| g.name == name).expect("it is given");
                assert_eq!(put(weight), point.value.coefficient(Unit::Point(given)), "{name}");
            }
        }
    }

    fn variable(theorem: &Theorem, name: &str) -> Fraction {
        Fraction::var(Var(theorem.names.iter().position(|n| n == name).expect("it is declared")))
    }

    #[test]
    fn published_joins_of_curves_are_the_derived_ones() {
        let (p, q) = (|k| format!("P[{k}]"), |k| format!("Q[{k}]"));
        let quadratic = family(QUADRATIC);
        for (name, order) in [("G1", 1), ("G2", 2)] {
            let published =
                join(&Library::from_source(&Disk, &Prover, Source::text("spec.basis", QUADRATIC)), name);
            let var = |name: &str| variable(&published, name);
            let c = if order == 2 { var("c") } else { Fraction::zero() };
            let by = [("λ_P", var("λ1")), ("λ_Q", var("λ2")), ("f", var("δ")), ("c", c)];
            same(&published, &continuation(&quadratic, order, Side::After).expect("derived"), &by, [&p, &q]);
        }
        // There the factor is on the other side: Q'(0) = α P'(1).
        let published =
            join(&Library::from_source(&Disk, &Prover, Source::text("spec.basis", REVOLUTION)), "G1");
        let var = |name: &str| variable(&published, name);
        let f = Fraction::constant(Rational::ONE).checked_div(&var("α")).expect("not zero");
        let by = [("λ_P", var("λ1")), ("λ_Q", var("λ2")), ("f", f), ("c", Fraction::zero())];
        let derived = continuation(&family(REVOLUTION), 1, Side::After).expect("derived");
        same(&published, &derived, &by, [&p, &q]);
    }

    /// Across a common edge a surface is joined curve by curve: rows of the net, columns, or a row with a column.
    #[test]
    fn published_joins_of_surfaces_are_the_derived_ones() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../specs/quartic_surface.basis");
        let source = crate::source::read(&Disk, path, &[]).expect("it is there");
        let library = Library::from_source(&Disk, &Prover, source);
        let quartic = family(include_str!("../../specs/quartic.basis"));
        for (order, kind) in [1, 2].into_iter().flat_map(|order| ["UU", "UV", "VV"].map(|kind| (order, kind)))
        {
            let published = join(&library, &format!("G{order}{kind}"));
            let derived = continuation(&quartic, order, Side::After).expect("derived");
            for i in 0..4 {
                let row = |name: &'static str| move |k| format!("{name}[{i},{k}]");
                let column = |name: &'static str| move |k| format!("{name}[{k},{i}]");
                let (s, t, [of_s, of_t]): (&dyn Fn(i64) -> String, &dyn Fn(i64) -> String, _) = match kind {
                    "UU" => (&row("S"), &row("T"), [format!("γ1[{i}]"), format!("γ2[{i}]")]),
                    "UV" => (&row("S"), &column("T"), [format!("γ1[{i}]"), String::from("λ2")]),
                    _ => (&column("S"), &column("T"), ["λ1", "λ2"].map(String::from)),
                };
                let var = |name: &str| variable(&published, name);
                let by = [("λ_P", var(&of_s)), ("λ_Q", var(&of_t)), ("f", var("f")), ("c", Fraction::zero())];
                same(&published, &derived, &by, [s, t]);
            }
        }
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
                        let one = Fraction::constant(Rational::ONE);
                        let parts = point.map_or_else(|| vec![(offset * len + i, one)], |(_, v)| entries(v));
                        for (p, x) in parts {
                            add(&mut form, p, &x, &w, &mut Work::unlimited()).expect("enough work");
                        }
                    }
                    form
                };
                let (f, c) = (Fraction::var(Var(2 * shapes)), Fraction::var(Var(2 * shapes + 1)));
                for k in 0..=order {
                    let mut difference = derivative(here, k, 0);
                    let mut subtract = |form: &Form, factor: &Fraction| {
                        for (p, x) in entries(form) {
                            add(&mut difference, p, &x, &-factor, &mut Work::unlimited())
                                .expect("enough work");
                        }
                    };
                    subtract(&derivative(there, k, 1), &f.pow(k));
                    if k == 2 {
                        subtract(&derivative(there, 1, 1), &c);
                    }
                    assert!(difference.is_zero(), "{}, order {order}, {side:?}, derivative {k}", family.name);
                }
            }
        }
    }
}

//! The point of a curve over quotients as steps of one component of all control points, binding included, from the
//! coordinates of the parameter: in the orders in which it is computed somewhere.

use super::{Builder, Steps, lower};
use crate::model::Family;
use crate::plan::Input;
use crate::plan::interval::form::RationalForm;
use crate::plan::interval::rational;
use basis_prover::collections::list::Listed;

/// What computes a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Association {
    /// The steps: binomial coefficients are factors of powers, and a denominator that is 1 is left out.
    Steps,
    /// `RationalCurve` of the runtime: binomial coefficients are factors of the bound coefficients, and there is always
    /// a denominator.
    Runtime,
}

/// The point inside of a span. Of a family without angles the coordinates s and x are computed from the parameter, of
/// others they are inputs.
pub(crate) fn of_curve(family: &Family, form: &RationalForm, association: Association) -> Steps {
    let mut builder = Builder::default();
    let [s, x] = if family.analytic.is_empty() {
        let t = builder.input(Input::Coordinate(0));
        let domain = [&form.numerators.low, &form.numerators.high].map(|end| builder.constant(end.clone()));
        builder.unit(domain, t)
    } else {
        [0, 1].map(|k| builder.input(Input::Coordinate(k)))
    };
    let points = points(&mut builder, form);
    let entries = builder.plan(&rational::numerators(family, form));
    let rows = entries.chunks(points.len().max(1));
    let bound = rows.map(|row| builder.combination(&points, row)).listed();
    let weights = form.divides(family).then(|| builder.plan(&rational::denominator(family, form)));
    let (above, below) = match (association, weights) {
        (Association::Steps, weights) => {
            (builder.bernstein(&bound, s, x), weights.map(|weights| builder.bernstein(&weights, s, x)))
        }
        (Association::Runtime, weights) => {
            let one = builder.integer(1);
            let weights = weights.unwrap_or_else(|| vec![one; bound.len()]);
            let [bound, weights] = [bound, weights].map(|own| builder.with_binomials(&own));
            (builder.nested_in_powers(&bound, s, x), Some(builder.nested_in_powers(&weights, s, x)))
        }
    };
    let point = match below {
        Some(below) => {
            let below = builder.kept(below, &form.sign);
            builder.div(above, below)
        }
        None => above,
    };
    builder.finish(&[point])
}

/// The point at the lower or at the upper end of a span as the runtime has it: the values of the functions there, times
/// the control points.
pub(crate) fn at_end(family: &Family, form: &RationalForm, is_upper: bool) -> Steps {
    let mut builder = Builder::without_scales();
    let points = points(&mut builder, form);
    let values = if form.is_tabulated {
        let entries = builder.plan(&rational::numerators(family, form));
        let row = if is_upper { form.numerators.degree as usize } else { 0 };
        let count = points.len();
        entries.into_iter().skip(row * count).take(count).listed()
    } else {
        let place = if family.analytic.is_empty() {
            let end = if is_upper { &form.numerators.high } else { &form.numerators.low };
            vec![builder.constant(end.clone())]
        } else {
            let x = usize::from(is_upper);
            [1 - x, x].map(|coordinate| builder.integer(coordinate)).to_vec()
        };
        builder.inline(&lower(&rational::values(family, form)), &|input| match input {
            Input::Coordinate(k) => place.get(k).copied(),
            _ => None,
        })
    };
    let point = builder.combination(&points, &values);
    builder.finish(&[point])
}

fn points(builder: &mut Builder, form: &RationalForm) -> Vec<usize> {
    (0..form.numerators.len()).map(|k| builder.input(Input::Point(k))).listed()
}

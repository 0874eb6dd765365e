//! The steps of all that can be evaluated of a family.

use super::derived::Derived;
use super::quotient::Quotients;
use super::runtime::NetFactor;
use super::{Builder, Steps, lower};
use crate::algebra::rational::Rational;
use crate::continuation::EndPoints;
use crate::model::Family;
use crate::plan::ends::end_points;
use crate::plan::evaluated::is_evaluated;
use crate::plan::interval::form::IntervalForm;
use crate::plan::patch::form::Group;
use crate::plan::patch::{PatchPlans, Table};
use crate::plan::{Input, interval};
use crate::weights::{zero, zeros};

/// What can be evaluated of a family, as steps. Their inputs are the shape values, the coordinates of a point of the
/// domain (t, all barycentric coordinates, the variables of a box, those of all factors of a product), and one
/// component of the control points or of what binding them gave.
#[derive(Clone, Debug)]
pub struct FamilySteps<'a> {
    family: &'a Family,
    form: Form<'a>,
}

#[derive(Clone, Debug)]
enum Form<'a> {
    Interval(IntervalForm),
    /// With the span that is meant.
    Quotient(Quotients<'a>, usize),
    Patch(PatchPlans<'a>),
}

/// The control points next to an end of a curve, as steps.
#[derive(Clone, Debug)]
pub struct EndSteps {
    /// The positions of the determined points among the control points, as many as there are derivatives.
    pub positions: Vec<usize>,
    /// The points, in the order of their positions, from [`Input::Derivative`], [`Input::Point`] and the shape values;
    /// after them the divisors.
    pub steps: Steps,
    /// Where a divisor is zero, such as `λ = -3`, one text for each: there the derivatives do not determine the points.
    pub undetermined: Vec<String>,
}

impl<'a> FamilySteps<'a> {
    /// The steps of a family; `None` when it is too large to be generated, or of a kind for which no code is generated.
    pub fn new(family: &'a Family) -> Option<Self> {
        if !is_evaluated(family) {
            return None;
        }
        let form = match (Quotients::new(family), IntervalForm::new(family)) {
            (Some(quotients), _) => Form::Quotient(quotients, 0),
            (None, Some(form)) => Form::Interval(form),
            (None, None) => Form::Patch(PatchPlans::new(family)?),
        };
        Some(Self { family, form })
    }

    /// The number of spans of the domain.
    pub fn spans(&self) -> usize {
        if let Form::Quotient(quotients, _) = &self.form { quotients.len() } else { 1 }
    }

    /// The same family, of which values, derivatives and points are those on a span of the domain.
    #[must_use]
    pub fn on_span(&self, span: usize) -> Self {
        let mut on_span = self.clone();
        if let Form::Quotient(_, at) = &mut on_span.form {
            *at = span;
        }
        on_span
    }

    /// Whether the functions are quotients or have spans, so that the shape values are needed for a point of a curve, too.
    pub fn is_quotient(&self) -> bool {
        matches!(self.form, Form::Quotient(..))
    }

    /// What is computed once from the shape values: the inputs [`Input::Shape`] after these.
    pub fn derived(&self) -> Option<&Derived> {
        let Form::Quotient(quotients, _) = &self.form else { return None };
        (!quotients.derived.names.is_empty()).then_some(&quotients.derived)
    }

    /// The ends of the domain with the knots between its spans; nothing on simplices and boxes.
    pub fn knots(&self) -> Steps {
        match &self.form {
            Form::Quotient(quotients, _) => quotients.knots(),
            Form::Interval(form) => {
                let mut builder = Builder::default();
                let ends = builder.domain(&form.low, &form.high);
                builder.finish(&ends)
            }
            Form::Patch(_) => Builder::default().finish(&[]),
        }
    }

    /// The number of coordinates of a point of the domain.
    pub fn coordinates(&self) -> usize {
        match &self.form {
            Form::Interval(_) | Form::Quotient(..) => 1,
            Form::Patch(plans) => plans.corners(),
        }
    }

    /// How many coefficients binding control points gives.
    pub fn bound(&self) -> usize {
        self.bind().outputs.len()
    }

    /// The values of all functions: `values`.
    pub fn values(&self) -> Steps {
        lower(&match &self.form {
            Form::Interval(form) => interval::values(self.family, form),
            Form::Quotient(quotients, span) => return quotients.values(*span),
            Form::Patch(plans) => plans.values(),
        })
    }

    /// The Bernstein weights: for each Bernstein coefficient one weight of each function. Of quotients those of the
    /// numerators on a span, and then the coefficients of the denominator.
    pub fn bernstein_weights(&self) -> Steps {
        if let Form::Quotient(quotients, span) = &self.form {
            return quotients.tables(*span);
        }
        let mut builder = Builder::default();
        let rows = self.weights(&mut builder);
        builder.finish(&rows.concat())
    }

    /// One row for each Bernstein coefficient, one column for each function.
    fn weights(&self, builder: &mut Builder) -> Vec<Vec<usize>> {
        match &self.form {
            Form::Interval(form) => {
                let entries = builder.plan(&interval::bernstein_weights(self.family, form));
                entries.chunks(form.len()).map(<[usize]>::to_vec).collect()
            }
            Form::Quotient(..) => Vec::new(),
            Form::Patch(plans) => {
                let Table { entries, places } = plans.table();
                let entries = builder.plan(&entries);
                let rows = places.chunks(plans.form.functions.len());
                let mut table: Vec<Vec<usize>> =
                    rows.map(|row| row.iter().map(|place| entries[*place]).collect()).collect();
                for step in 0..plans.steps {
                    let (order, degree) = (plans.lowest() + step, plans.form.degrees[0] + step);
                    table = builder.raised(&table, plans.corners(), order, degree);
                }
                table
            }
        }
    }

    /// The derivatives of all functions: of one order in t on an interval, `derivatives`; of one order in each
    /// independent coordinate on simplices and boxes, `partials`.
    pub fn derivatives(&self, orders: &[usize]) -> Steps {
        if orders.iter().all(|order| *order == 0) {
            return self.values();
        }
        if let Form::Quotient(quotients, span) = &self.form {
            return quotients.derivatives(*span, orders[0]);
        }
        let mut builder = Builder::default();
        let rows = self.weights(&mut builder);
        let columns: Vec<Vec<usize>> = (0..self.family.functions.len())
            .map(|column| rows.iter().map(|row| row[column]).collect())
            .collect();
        let at = self.point_of_domain(&mut builder);
        let outputs: Vec<usize> = match &self.form {
            Form::Interval(form) => {
                let order = orders[0];
                let domain = builder.domain(&form.low, &form.high);
                let [s, x] = builder.unit(domain, at[0]);
                let inverse = builder.inverse_width(domain);
                let mut scale = builder.integer(1);
                for _ in 0..order.min(form.degree as usize) {
                    scale = builder.mul(scale, inverse);
                }
                let of = |column: &Vec<usize>| {
                    let value = builder.bernstein_derivative(column, order, s, x);
                    builder.mul(value, scale)
                };
                columns.iter().map(of).collect()
            }
            Form::Quotient(..) => Vec::new(),
            Form::Patch(_) => {
                columns.iter().map(|net| self.patch_partial(&mut builder, net, &at, orders)).collect()
            }
        };
        builder.finish(&outputs)
    }

    /// What binding control points gives: E0, E1, R0, R1, … of an endpoint form, or else the Bernstein points; of quotients
    /// the Bernstein points of the numerators, span after span.
    pub fn bind(&self) -> Steps {
        if let Form::Interval(form) = &self.form
            && let Some(plan) = interval::bind(self.family, form)
        {
            return lower(&plan);
        }
        if let Form::Quotient(quotients, _) = &self.form {
            return quotients.bind();
        }
        let mut builder = Builder::default();
        let rows = self.weights(&mut builder);
        let points: Vec<usize> =
            (0..self.family.functions.len()).map(|k| builder.input(Input::Point(k))).collect();
        let outputs: Vec<usize> = rows.iter().map(|row| builder.combination(&points, row)).collect();
        builder.finish(&outputs)
    }

    /// The point of a curve and its derivatives in t, `count` values in all, from what binding gave: `Curve::eval` for
    /// one, `Curve::eval_with_derivs` for more. `None` on simplices and boxes.
    pub fn curve(&self, count: usize) -> Option<Steps> {
        if let Form::Quotient(quotients, span) = &self.form {
            return Some(quotients.curve(*span, count));
        }
        let Form::Interval(form) = &self.form else { return None };
        let mut builder = Builder::default();
        let t = builder.input(Input::Coordinate(0));
        let domain = builder.domain(&form.low, &form.high);
        let [_, x] = builder.unit(domain, t);
        builder.name(x, "x");
        let bound: Vec<usize> = (0..self.bound()).map(|k| builder.input(Input::Bound(k))).collect();
        let mut results = if interval::bind(self.family, form).is_some() {
            builder.endpoint([bound[0], bound[1]], &bound[2..], x, count)
        } else {
            builder.bernstein_form(&bound, x, count)
        };
        let inverse = builder.inverse_width(domain);
        let mut scale = builder.integer(1);
        for result in results.iter_mut().skip(1) {
            scale = builder.mul(scale, inverse);
            *result = builder.mul(*result, scale);
        }
        results.truncate(count);
        Some(builder.finish(&results))
    }

    /// The partial derivative of a patch from its Bernstein points, of one order in each independent coordinate:
    /// `eval_at` and `eval` of patches for orders 0, else `partial`. `None` on an interval.
    pub fn patch(&self, orders: &[usize]) -> Option<Steps> {
        let Form::Patch(plans) = &self.form else { return None };
        let mut builder = Builder::default();
        let at = self.point_of_domain(&mut builder);
        let net: Vec<usize> = (0..plans.coefficients()).map(|k| builder.input(Input::Bound(k))).collect();
        let value = match at.as_slice() {
            [u, v, w] if self.family.is_simplex() && orders.iter().all(|order| *order == 0) => {
                builder.triangle_point(&net, [*u, *v, *w], plans.degrees()[0] as usize)
            }
            _ => self.patch_partial(&mut builder, &net, &at, orders),
        };
        Some(builder.finish(&[value]))
    }

    fn patch_partial(&self, builder: &mut Builder, net: &[usize], at: &[usize], orders: &[usize]) -> usize {
        let Form::Patch(plans) = &self.form else { return builder.integer(0) };
        let degrees: Vec<usize> = plans.degrees().iter().map(|degree| *degree as usize).collect();
        if self.family.is_simplex() {
            return match builder.simplex_partial(net, degrees[0], orders) {
                Some((net, degree)) => builder.simplex_finish(&net, degree, at),
                None => builder.integer(0),
            };
        }
        let factor = |(group, degree): (&Group, usize)| match &group.range {
            Some((low, high)) => (degree, NetFactor::Interval(builder.domain(low, high))),
            None => (degree, NetFactor::Simplex(group.vars.len() + 1)),
        };
        let factors: Vec<(usize, NetFactor)> = plans.form.groups.iter().zip(degrees).map(factor).collect();
        builder.net_partial(net, &factors, at, orders)
    }

    /// Binding and evaluating in one: the first steps as the bound coefficients of the second.
    pub fn on_control_points(&self, evaluation: &Steps) -> Steps {
        let mut builder = Builder::default();
        let bound = builder.inline(&self.bind(), &|_| None);
        let outputs = builder.inline(evaluation, &|input| match input {
            Input::Bound(k) => bound.get(k).copied(),
            _ => None,
        });
        builder.finish(&outputs)
    }

    /// The control points next to an end, at the start or else at the end, from the derivatives there: for one
    /// derivative, for two, and so on up to this order, as far as they are determined; nothing for quotients.
    pub fn ends(&self, order: u32, at_start: bool) -> Vec<EndSteps> {
        if self.is_quotient() {
            return Vec::new();
        }
        let region = self.family.shape_region();
        let all = EndPoints::up_to(self.family, order, at_start).into_iter();
        all.map(|points| {
            let divisors = zeros(&points.determinant, &region, self.family.budget);
            let undetermined = divisors.iter().map(|divisor| zero(divisor, &self.family.names)).collect();
            let steps = lower(&end_points(self.family, &points, &divisors));
            EndSteps { positions: points.positions, steps, undetermined }
        })
        .collect()
    }

    fn point_of_domain(&self, builder: &mut Builder) -> Vec<usize> {
        (0..self.coordinates()).map(|k| builder.input(Input::Coordinate(k))).collect()
    }
}

impl Builder {
    /// The ends of a domain.
    fn domain(&mut self, low: &Rational, high: &Rational) -> [usize; 2] {
        [low, high].map(|end| self.constant(end.clone()))
    }
}

//! The steps of families that are evaluated as quotients, span by span: those with denominators, angles or exponentials,
//! with several spans, without an end of their domain, or with shape parameters at the ends.
//!
//! They do what `RationalCurve` of the runtime does: N(s, x)/W(s, x) in coordinates s, x, which are those of a [`Chart`].
//! What depends on the shape values only and needs more than operations, tangents and the numbers of a chart, is computed
//! once: [`Derived`] values, which are inputs of all other steps, after the shape values.

use super::chart::Chart;
use super::derived::{Derived, Deriving, Scalar};
use super::{Builder, Function, Steps, lower};
use crate::model::Family;
use crate::model::angle::{Angle, Kind};
use crate::plan::denominator::Sign;
use crate::plan::interval::form::RationalForm;
use crate::plan::interval::rational;
use crate::plan::{Input, Plan};
use basis_prover::collections::list::Listed;

/// A family that is evaluated as quotients.
#[derive(Clone, Debug)]
pub(super) struct Quotients<'a> {
    spans: Vec<Span<'a>>,
    pub(super) derived: Derived,
}

#[derive(Clone, Debug)]
struct Span<'a> {
    /// The functions on the span.
    family: &'a Family,
    form: RationalForm,
    /// The inputs that the plans have after the shape values: where they stand among all.
    tangents: Vec<usize>,
    chart: Chart,
    /// The Bernstein coefficients of the numerators, one row for each, where these are computed in one place.
    table: Option<Vec<Vec<Scalar>>>,
}

/// What is computed of the tangent x of a shape parameter.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    /// x
    Whole,
    /// 1 − x
    Rest,
    /// 1 + x
    Rise,
}

impl Deriving {
    /// The tangent of a shape parameter, or what is missing from it to 1, or 1 plus it.
    fn tangent(&mut self, family: &Family, angle: &Angle, part: Part) -> usize {
        let shape = family.shapes.iter().position(|p| p.var == angle.var).unwrap_or(0);
        let rate = self.builder.constant(angle.speed());
        let input = self.builder.input(Input::Shape(shape));
        let argument = self.builder.mul(rate, input);
        let name = family.name_of(&family.shapes[shape]);
        if angle.kind == Kind::Circular {
            let tangent = self.builder.call(Function::Tan, argument);
            if part == Part::Rest {
                let rest = self.builder.tan_complement(argument, tangent);
                return self.position(rest, &format!("rest_{name}"));
            }
            return self.position(tangent, &format!("tan_{name}"));
        }
        if part == Part::Whole {
            let tangent = self.builder.call(Function::Tanh, argument);
            return self.position(tangent, &format!("tanh_{name}"));
        }
        // 1 minus the hyperbolic tangent, without the difference; 1 plus it is the same of −x.
        let argument = if part == Part::Rise { self.builder.neg(argument) } else { argument };
        let two = self.builder.integer(2);
        let double = self.builder.mul(two, argument);
        let exponential = self.builder.call(Function::Expm1, double);
        let below = self.builder.add(two, exponential);
        let rest = self.builder.div(two, below);
        self.position(rest, &format!("{}_{name}", if part == Part::Rise { "rise" } else { "rest" }))
    }

    fn span<'a>(&mut self, family: &'a Family, form: RationalForm, number: &str) -> Span<'a> {
        let shapes = self.shapes;
        let analytic = &family.analytic;
        let used = |k: usize| {
            let plans: [Plan; 3] = [
                rational::values(family, &form),
                rational::numerators(family, &form),
                rational::denominator(family, &form),
            ];
            plans.iter().any(|plan| lower(plan).inputs().contains(&Input::Shape(shapes + k)))
        };
        let count = analytic.angles.len();
        let mut tangents = Vec::new();
        for (j, part) in [Part::Whole, Part::Rest, Part::Rise].into_iter().enumerate() {
            for (k, angle) in analytic.angles.iter().enumerate() {
                let place = if used(j * count + k) { self.tangent(family, angle, part) } else { 0 };
                tangents.push(place);
            }
        }
        let chart = self.chart(family, &form, number);
        let table = self.table(family, &form, &tangents, number);
        Span { family, form, tangents, chart, table }
    }

    /// The table of a span whose values are computed from it.
    fn table(
        &mut self,
        family: &Family,
        form: &RationalForm,
        tangents: &[usize],
        number: &str,
    ) -> Option<Vec<Vec<Scalar>>> {
        if !form.is_tabulated {
            return None;
        }
        let shapes = self.shapes;
        let outputs = &self.outputs;
        let at = |input: Input| match input {
            Input::Shape(k) if k >= shapes => outputs.get(tangents[k - shapes].checked_sub(shapes)?).copied(),
            _ => None,
        };
        let entries = self.builder.inline(&lower(&rational::numerators(family, form)), &at);
        let mut rows = Vec::new();
        for (j, row) in entries.chunks(form.numerators.len().max(1)).enumerate() {
            let row = row.iter().enumerate();
            rows.push(row.map(|(k, entry)| self.keep(*entry, &format!("c{number}_{j}_{k}"))).listed());
        }
        Some(rows)
    }
}

impl<'a> Quotients<'a> {
    /// Of a family that is evaluated so; `None` for others.
    pub(super) fn new(family: &'a Family) -> Option<Self> {
        let forms = RationalForm::of_family(family)?;
        let shapes = family.shapes.len();
        let mut deriving =
            Deriving { builder: Builder::folding(), shapes, names: Vec::new(), outputs: Vec::new() };
        let mut spans = Vec::new();
        for (k, form) in forms.into_iter().enumerate() {
            let (family, number) = match family.pieces.get(k) {
                Some(piece) => (&**piece, k.to_string()),
                None => (family, String::new()),
            };
            spans.push(deriving.span(family, form, &number));
        }
        let Deriving { builder, names, outputs, .. } = deriving;
        Some(Self { spans, derived: Derived { names, steps: builder.finish(&outputs) } })
    }

    /// The number of spans.
    pub(super) fn len(&self) -> usize {
        self.spans.len()
    }

    /// The ends of all spans in order, each once.
    pub(super) fn knots(&self) -> Steps {
        let mut builder = Builder::default();
        let mut outputs = vec![builder.scalar(&self.spans[0].chart.ends[0])];
        for span in &self.spans {
            outputs.push(builder.scalar(&span.chart.ends[1]));
        }
        builder.finish(&outputs)
    }

    pub(super) fn values(&self, span: usize) -> Steps {
        let span = &self.spans[span];
        let mut builder = Builder::default();
        let pair = (!span.family.analytic.is_empty()).then(|| span.chart.coordinates(&mut builder));
        if span.table.is_some()
            && let Some([s, x]) = pair
        {
            let rows = span.rows(&mut builder);
            let column = |k: usize| rows.iter().map(|row| row[k]).listed();
            let mut outputs =
                (0..span.form.numerators.len()).map(|k| builder.affine_bernstein(&column(k), s, x)).listed();
            for (output, is_nonnegative) in outputs.iter_mut().zip(&span.family.nonnegative) {
                if *is_nonnegative {
                    *output = builder.cut_off(*output);
                }
            }
            return builder.finish(&outputs);
        }
        let outputs = span.inline(&mut builder, &rational::values(span.family, &span.form), pair);
        builder.finish(&outputs)
    }

    /// The Bernstein coefficients of the numerators and of the denominator.
    pub(super) fn tables(&self, span: usize) -> Steps {
        let mut builder = Builder::default();
        let mut outputs = self.spans[span].rows(&mut builder).concat();
        outputs.extend(self.spans[span].weights(&mut builder).unwrap_or_default());
        builder.finish(&outputs)
    }

    /// The Bernstein coefficients of the numerators of a curve, span after span.
    pub(super) fn bind(&self) -> Steps {
        let mut builder = Builder::default();
        let mut outputs = Vec::new();
        for span in &self.spans {
            let points: Vec<usize> =
                (0..span.form.numerators.len()).map(|k| builder.input(Input::Point(k))).collect();
            for row in span.rows(&mut builder) {
                outputs.push(builder.combination(&points, &row));
            }
        }
        builder.finish(&outputs)
    }

    /// The derivatives of all functions of order 1 or 2.
    pub(super) fn derivatives(&self, span: usize, order: usize) -> Steps {
        let span = &self.spans[span];
        let mut builder = Builder::default();
        let mut rows = span.rows(&mut builder);
        let mut weights = span.weights(&mut builder);
        if let Some(powers) = span.chart.powers(&mut builder, rows.len()) {
            for (power, row) in powers.iter().zip(&mut rows) {
                for entry in row {
                    *entry = builder.mul(*entry, *power);
                }
            }
            weights = weights.map(|weights| builder.scaled(&weights, &powers));
        }
        let pair = span.chart.coordinates(&mut builder);
        let place = span.chart.place(&mut builder, pair);
        let slopes = span.chart.slopes(&mut builder, place);
        let mut outputs = Vec::new();
        for k in 0..span.form.numerators.len() {
            let column = rows.iter().map(|row| row[k]).listed();
            let below = weights.as_deref().map(|weights| (weights, &span.form.sign));
            let all = builder.quotient(&column, below, place, slopes, order + 1);
            outputs.push(all[order]);
        }
        builder.finish(&outputs)
    }

    /// The point of a curve and its derivatives, `count` values in all, from what binding gave.
    pub(super) fn curve(&self, span: usize, count: usize) -> Steps {
        let terms = self.spans[0].form.numerators.degree as usize + 1;
        let first = span * terms;
        let span = &self.spans[span];
        let mut builder = Builder::default();
        let bound: Vec<usize> = (first..first + terms).map(|k| builder.input(Input::Bound(k))).collect();
        let weights = span.weights(&mut builder);
        let pair = span.chart.coordinates(&mut builder);
        let [s, x] = pair;
        builder.name(s, "s");
        builder.name(x, "x");
        let above = builder.bernstein(&bound, s, x);
        let point = match &weights {
            Some(weights) => {
                let below = builder.bernstein(weights, s, x);
                let below = builder.kept(below, &span.form.sign);
                builder.name(below, "w");
                builder.div(above, below)
            }
            None => above,
        };
        let mut outputs = vec![point];
        if count > 1 {
            let place = span.chart.place(&mut builder, pair);
            let slopes = span.chart.slopes(&mut builder, place);
            let (mut bound, mut weights) = (bound, weights);
            if let Some(powers) = span.chart.powers(&mut builder, terms) {
                bound = builder.scaled(&bound, &powers);
                weights = weights.map(|weights| builder.scaled(&weights, &powers));
            }
            let below = weights.as_deref().map(|weights| (weights, &span.form.sign));
            let all = builder.quotient(&bound, below, place, slopes, count);
            outputs.extend_from_slice(&all[1..]);
        }
        builder.finish(&outputs)
    }
}

impl Span<'_> {
    /// The outputs of a plan; its coordinates are these two, or else there is the parameter alone.
    fn inline(&self, builder: &mut Builder, plan: &Plan, pair: Option<[usize; 2]>) -> Vec<usize> {
        let shapes = self.family.shapes.len();
        let inputs: Vec<(Input, usize)> = lower(plan)
            .inputs()
            .into_iter()
            .filter_map(|input| match (input, pair) {
                (Input::Coordinate(k), Some(pair)) => Some((input, pair[k])),
                (Input::Shape(k), _) if k >= shapes => {
                    Some((input, builder.input(Input::Shape(self.tangents[k - shapes]))))
                }
                _ => None,
            })
            .collect();
        let at = |input: Input| inputs.iter().find(|(other, _)| *other == input).map(|(_, step)| *step);
        // As the runtime does: of polynomials in the domain variable the coordinates have the sum 1.
        let is_polynomial = !self.form.divides(self.family) && pair.is_some();
        let mut own = if is_polynomial { Builder::of_sums_to_one() } else { Builder::default() };
        let outputs = own.plan(plan);
        builder.inline(&own.finish(&outputs), &at)
    }

    /// The Bernstein coefficients of the numerators, one row for each.
    fn rows(&self, builder: &mut Builder) -> Vec<Vec<usize>> {
        if let Some(table) = &self.table {
            return table.iter().map(|row| row.iter().map(|c| builder.scalar(c)).listed()).listed();
        }
        let entries = self.inline(builder, &rational::numerators(self.family, &self.form), None);
        entries.chunks(self.form.numerators.len().max(1)).map(<[usize]>::to_vec).collect()
    }

    /// The Bernstein coefficients of the denominator; `None` where it is 1.
    fn weights(&self, builder: &mut Builder) -> Option<Vec<usize>> {
        self.form
            .divides(self.family)
            .then(|| self.inline(builder, &rational::denominator(self.family, &self.form), None))
    }
}

impl Builder {
    /// Coefficients, each times a number.
    fn scaled(&mut self, coefficients: &[usize], powers: &[usize]) -> Vec<usize> {
        coefficients.iter().zip(powers).map(|(c, power)| self.mul(*c, *power)).listed()
    }

    /// As the plan's, of a denominator in Bernstein form.
    pub(super) fn kept(&mut self, denominator: usize, sign: &Sign) -> usize {
        match sign {
            Sign::Kept | Sign::Unknown => denominator,
            Sign::Positive => self.cut_off(denominator),
            Sign::Negative => {
                let size = self.neg(denominator);
                let size = self.cut_off(size);
                self.neg(size)
            }
        }
    }

    /// N/W and its derivatives in t, at most two, from the Bernstein coefficients in x: with c = N/W,
    /// c' = (N' − c W')/W and c'' = (N'' − 2 c' W' − c W'')/W in x, and the chain rule.
    fn quotient(
        &mut self,
        numerator: &[usize],
        denominator: Option<(&[usize], &Sign)>,
        [s, x]: [usize; 2],
        (slope, curvature): (usize, Option<usize>),
        count: usize,
    ) -> Vec<usize> {
        let n = (0..count).map(|order| self.bernstein_derivative(numerator, order, s, x)).listed();
        let c = match denominator {
            None => n,
            Some((denominator, sign)) => {
                let mut w =
                    (0..count).map(|order| self.bernstein_derivative(denominator, order, s, x)).listed();
                w[0] = self.kept(w[0], sign);
                let mut c = vec![self.div(n[0], w[0])];
                if count > 1 {
                    let known = self.mul(c[0], w[1]);
                    let rest = self.sub(n[1], known);
                    c.push(self.div(rest, w[0]));
                }
                if count > 2 {
                    let two = self.integer(2);
                    let (twice, last) = (self.mul(c[1], w[1]), self.mul(c[0], w[2]));
                    let twice = self.mul(twice, two);
                    let rest = self.sub(n[2], twice);
                    let rest = self.sub(rest, last);
                    c.push(self.div(rest, w[0]));
                }
                c
            }
        };
        let mut results = vec![c[0]];
        if count > 1 {
            results.push(self.mul(c[1], slope));
        }
        if count > 2 {
            let square = self.mul(slope, slope);
            let mut second = self.mul(c[2], square);
            if let Some(curvature) = curvature {
                let rest = self.mul(c[1], curvature);
                second = self.add(second, rest);
            }
            results.push(second);
        }
        results
    }
}

//! From a plan to steps.

use super::build::Manner;
use super::{Builder, Function, Steps};
use crate::algebra::rational::Rational;
use crate::plan::{Node, Plan, Ref};

/// The steps of a plan; an output that is a list gives all its elements.
pub fn lower(plan: &Plan) -> Steps {
    let mut builder = Builder::default();
    let outputs = builder.plan(plan);
    builder.finish(&outputs)
}

impl Builder {
    /// The outputs of a plan on its own inputs.
    pub fn plan(&mut self, plan: &Plan) -> Vec<usize> {
        // A pair or a list has several values.
        let mut values: Vec<Vec<usize>> = Vec::new();
        for node in &plan.nodes {
            let one = |at: &Ref| values[at.position()][0];
            let all = |list: &[Ref]| -> Vec<usize> { list.iter().map(one).collect() };
            let value = match node {
                Node::Input(input) => self.input(*input),
                Node::Number(value) => self.constant(value.clone()),
                Node::Neg(a) => self.neg(one(a)),
                Node::Sum(a, b) => self.add(one(a), one(b)),
                Node::Difference(a, b) => self.sub(one(a), one(b)),
                Node::Product(a, b) => self.mul(one(a), one(b)),
                Node::Reciprocal(a) => {
                    let top = self.constant(Rational::ONE);
                    self.div(top, one(a))
                }
                Node::Quotient(a, b) => self.div(one(a), one(b)),
                Node::Unit { low, high, t } => {
                    let domain = [low, high].map(|end| self.constant(end.clone()));
                    let pair = self.unit(domain, one(t));
                    values.push(pair.to_vec());
                    continue;
                }
                Node::CutOff(a) => self.cut_off(one(a)),
                Node::InversePowerOfTwo(a) => self.call(Function::InversePowerOfTwo, one(a)),
                Node::List(list) => {
                    let list = all(list);
                    values.push(list);
                    continue;
                }
                Node::Part(whole, k) => values[whole.position()][*k],
                Node::Bernstein { coefficients, s, x } => {
                    let (coefficients, s, x) = (all(coefficients), one(s), one(x));
                    match self.manner {
                        Manner::SumsToOne => self.affine_bernstein(&coefficients, s, x),
                        Manner::InCoordinate(k) => self.bernstein_in(k, &coefficients, s, x),
                        Manner::Plain | Manner::Folding | Manner::WithoutScales => {
                            self.bernstein(&coefficients, s, x)
                        }
                    }
                }
                Node::Combine { points, weights } => self.combination(&all(points), &all(weights)),
                Node::SimplexSum { coefficients, at, degree } => {
                    self.simplex_sum(&all(coefficients), &all(at), *degree as usize)
                }
                Node::BoxSum { coefficients, degrees, units } => {
                    let degrees: Vec<usize> = degrees.iter().map(|d| *d as usize).collect();
                    let units: Vec<[usize; 2]> = units.iter().map(|unit| unit.map(|at| one(&at))).collect();
                    self.box_sum(&all(coefficients), &degrees, &units)
                }
            };
            values.push(vec![value]);
        }
        for binding in &plan.lets {
            let values = &values[binding.value.position()];
            if values.len() == binding.names.len() {
                for (name, value) in binding.names.iter().zip(values) {
                    self.name(*value, name);
                }
            }
        }
        plan.outputs.iter().flat_map(|output| values[output.position()].clone()).collect()
    }
}

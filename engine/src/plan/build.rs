//! Puts nodes together to a plan.

use super::corners::Corners;
use super::{Input, Let, Node, Plan, Ref};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::model::Family;

/// A variable of expressions in scalars.
pub(super) struct Variable {
    pub(super) var: Var,
    pub(super) range: Range,
    pub(super) value: Ref,
    /// 1 minus the value, where that is known without a difference.
    pub(super) complement: Option<Ref>,
    /// 1 plus the value, likewise.
    pub(super) rise: Option<Ref>,
    /// Whether the value is compared with the ends of the range, and not computed.
    pub(super) is_given: bool,
}

/// A plan that is being made. Coordinates come first, then their powers, then expressions in shape values.
#[derive(Default)]
pub(super) struct Builder {
    nodes: Vec<Node>,
    /// What can stand in expressions in shape values.
    pub(super) variables: Vec<Variable>,
    /// The ends of their ranges, where some are tangents.
    pub(super) corners: Corners,
    /// The polynomials in shape values that have a name.
    pub(super) named: Vec<(Poly, Ref)>,
    /// The denominators whose reciprocals have a name.
    pub(super) reciprocals: Vec<(Poly, Ref)>,
    /// The coordinates with their names.
    pub(super) coordinates: Vec<(String, Ref)>,
    /// The powers of coordinates, by their positions among these.
    pub(super) powers: Vec<(usize, u32, Ref)>,
    /// The names of pairs of coordinates.
    pub(super) units: Vec<Let>,
    /// The names of powers.
    pub(super) power_lets: Vec<Let>,
    /// The names of expressions in shape values.
    pub(super) scalar_lets: Vec<Let>,
    /// The names of what is squared.
    pub(super) root_lets: Vec<Let>,
}

impl Builder {
    /// With the shape parameters of a family as variables.
    pub(super) fn of(family: &Family) -> Self {
        let mut builder = Self::default();
        for (k, shape) in family.shapes.iter().enumerate() {
            builder.variable(k, shape);
        }
        builder.tangents(family);
        builder
    }

    pub(super) fn push(&mut self, node: Node) -> Ref {
        self.nodes.push(node);
        Ref(self.nodes.len() - 1)
    }

    /// The number of nodes.
    pub(super) fn len(&self) -> usize {
        self.nodes.len()
    }

    pub(super) fn node(&self, at: Ref) -> &Node {
        &self.nodes[at.0]
    }

    pub(super) fn input(&mut self, input: Input) -> Ref {
        self.push(Node::Input(input))
    }

    pub(super) fn number(&mut self, value: Rational) -> Ref {
        self.push(Node::Number(value))
    }

    /// −a
    pub(super) fn neg(&mut self, a: Ref) -> Ref {
        match self.node(a) {
            Node::Number(value) => {
                let value = -value;
                self.number(value)
            }
            _ => self.push(Node::Neg(a)),
        }
    }

    /// The pair of coordinates `[s, x]` of a parameter on an interval, under these names.
    pub(super) fn unit(&mut self, [low, high]: [&Rational; 2], t: Ref, names: &[String; 2]) -> [Ref; 2] {
        let value = self.push(Node::Unit { low: low.clone(), high: high.clone(), t });
        self.units.push(Let { names: names.to_vec(), value });
        [self.push(Node::Part(value, 0)), self.push(Node::Part(value, 1))]
    }

    /// f·g·…, from the first to the last.
    pub(super) fn product(&mut self, factors: &[Ref]) -> Ref {
        let Some((first, rest)) = factors.split_first() else { return self.number(Rational::ONE) };
        let mut product = *first;
        for factor in rest {
            product = self.push(Node::Product(product, *factor));
        }
        product
    }

    pub(super) fn finish(self, outputs: Vec<Ref>) -> Plan {
        self.finish_with(Vec::new(), outputs)
    }

    /// The plan with further names, which come last.
    pub(super) fn finish_with(self, last: Vec<Let>, outputs: Vec<Ref>) -> Plan {
        let mut lets = self.units;
        lets.extend(self.power_lets);
        lets.extend(self.scalar_lets);
        lets.extend(self.root_lets);
        lets.extend(last);
        Plan { nodes: self.nodes, lets, outputs }
    }
}

//! What is computed, knowing no language: which operations, in which association, sharing what.
//!
//! Between the exact formulas of a family and the code of a language stands a [`Plan`]: a list of nodes, each made of
//! nodes before it. It fixes every operation, and so every rounding, but it keeps what a runtime library has a function
//! for as one node ([`Node::Bernstein`], [`Node::Combine`], …). Rust is printed from a plan. Where there is no such
//! library, [`crate::steps`] writes these nodes out as single operations, in the order in which the runtime does them.
//!
//! | file | plans of |
//! | --- | --- |
//! | `interval` | values, tables and bound curves of families on an interval |
//! | `interval/rational` | values and tables of families on an interval with denominators in the domain variable |
//! | `patch` | values and tables of families on simplices and boxes |
//! | `ends` | control points next to an end of a curve, from its derivatives there |
//! | `join` | the control points that a join of a spec determines |
//! | `scalars`, `powers` | what these are built of: expressions in shape values, powers of coordinates |
//! | `corners` | differences that have no digits where exponentials are large |
//! | `evaluated` | which families have evaluators, and in which form they are evaluated |
//! | `series` | polynomials in place of functions in which a variable stands beside its sine |
//! | `digits` | numbers as sums of floats |
//! | `sign` | which values rounding could make negative |
//! | `reach` | the shape values beyond which exponentials overflow |
//!
//! The exact formulas that are planned are in [`interval::form`] for families on an interval and in [`patch::form`] for
//! those on simplices and boxes.

mod build;
mod corners;
pub mod denominator;
pub(crate) mod digits;
pub mod ends;
pub(crate) mod evaluated;
pub mod interval;
#[cfg(feature = "joins")]
pub mod join;
pub mod patch;
mod powers;
pub mod reach;
mod scalars;
#[cfg(feature = "angles")]
pub(crate) mod series;
#[cfg(not(feature = "angles"))]
#[path = "no_series.rs"]
pub(crate) mod series;
mod sign;

use crate::algebra::rational::Rational;
use build::Builder;

/// A computation: nodes, the names of some of them, and what comes out.
#[cfg_attr(any(test, feature = "rounding"), derive(Clone, Debug, PartialEq))] // every user builds the rest
pub struct Plan {
    /// The nodes; each refers to nodes before it only.
    pub nodes: Vec<Node>,
    /// The nodes that are computed once and then known by names, in an order in which they can be computed.
    pub lets: Vec<Let>,
    /// The results; a [`Node::List`] stands for all its elements.
    pub outputs: Vec<Ref>,
}

/// A node of a plan, by its position.
#[derive(Clone, Copy)]
#[cfg_attr(any(test, feature = "rounding"), derive(Debug, PartialEq, Eq))]
pub struct Ref(usize);

impl Ref {
    /// The position among the nodes of the plan.
    pub const fn position(self) -> usize {
        self.0
    }
}

/// A node with a name.
#[cfg_attr(any(test, feature = "rounding"), derive(Clone, Debug, PartialEq))]
pub struct Let {
    /// The name, in ASCII; two names `[s, x]` for the two parts of a [`Node::Unit`]. The list `b` of a recursion takes
    /// the name of the list before it.
    pub names: Vec<String>,
    /// What is computed.
    pub value: Ref,
}

/// A number that is given from outside.
#[derive(Clone, Copy)]
#[cfg_attr(any(test, feature = "rounding"), derive(Debug, PartialEq, Eq, PartialOrd, Ord))]
pub enum Input {
    /// A coordinate of the point of the domain: the parameter t, a variable of a box, a barycentric coordinate.
    Coordinate(usize),
    /// The value of a shape parameter, or of a scalar of a join; after those of a family with angles the tangents of its
    /// parameters, at the positions of the angles in [`Analytic::angles`](crate::model::angle::Analytic), then what is
    /// missing from these to 1, then 1 plus these.
    Shape(usize),
    /// One component of a control point; all components are treated alike.
    Point(usize),
    /// One component of a derivative of that order, of a curve at an end.
    Derivative(usize),
    /// One component of a coefficient that binding control points gave, in the order of its results.
    Bound(usize),
}

/// One step of a plan.
#[cfg_attr(any(test, feature = "rounding"), derive(Clone, Debug, PartialEq))]
pub enum Node {
    /// A number from outside.
    Input(Input),
    /// A constant: the nearest float.
    Number(Rational),
    /// −a
    Neg(Ref),
    /// a + b
    Sum(Ref, Ref),
    /// a − b
    Difference(Ref, Ref),
    /// a·b
    Product(Ref, Ref),
    /// 1/a
    Reciprocal(Ref),
    /// a/b
    Quotient(Ref, Ref),
    /// The pair s = (high − t)/(high − low), x = (t − low)/(high − low).
    Unit {
        /// The lower end of the domain.
        low: Rational,
        /// The upper end of the domain.
        high: Rational,
        /// The parameter.
        t: Ref,
    },
    /// a, or 0 where a is negative: the value of something that is proved to be nonnegative.
    CutOff(Ref),
    /// The power of two by which a positive number becomes one from 1 to 2.
    InversePowerOfTwo(Ref),
    /// Several numbers.
    List(Vec<Ref>),
    /// An element of a pair or a list.
    Part(Ref, usize),
    /// Σ_j binomial(m, j) `coefficients[j]` s^(m−j) x^j with m + 1 coefficients, nested in s.
    Bernstein {
        /// The coefficients.
        coefficients: Vec<Ref>,
        /// The coordinate s.
        s: Ref,
        /// The coordinate x.
        x: Ref,
    },
    /// Σ `weights[i]`·`points[i]`, from the first to the last; a weight of zero is added like any other.
    Combine {
        /// The points, one component of each.
        points: Vec<Ref>,
        /// As many weights.
        weights: Vec<Ref>,
    },
    /// Σ `coefficients[α]` u^α₁ v^α₂ …, all α with the sum `degree` in lexicographic order, nested.
    SimplexSum {
        /// The coefficients.
        coefficients: Vec<Ref>,
        /// The barycentric coordinates, three or four.
        at: Vec<Ref>,
        /// The degree.
        degree: u32,
    },
    /// Σ `coefficients[α]` ∏ s^(n−k) x^k, the last index fastest, nested in each coordinate from the last.
    BoxSum {
        /// The coefficients.
        coefficients: Vec<Ref>,
        /// The degree in each coordinate.
        degrees: Vec<u32>,
        /// The coordinates `[s, x]` of each variable.
        units: Vec<[Ref; 2]>,
    },
}

//! What theorems and joins mean: curves and surfaces over families as linear forms in control points, scalars with
//! their ranges, and claims about them as exact differences.

#[cfg(feature = "joins")]
mod draft;
#[cfg(feature = "joins")]
mod elaborate;
#[cfg(feature = "joins")]
mod evaluate;
mod form;
#[cfg(feature = "joins")]
mod maps;
#[cfg(not(feature = "joins"))]
mod off;
#[cfg(feature = "joins")]
mod patch;
#[cfg(feature = "joins")]
mod relations;

#[cfg(feature = "joins")]
pub use elaborate::theorems;
pub use form::{Form, Unit};
#[cfg(not(feature = "joins"))]
pub use off::theorems;
#[cfg(all(feature = "joins", any(test, feature = "tools")))]
pub(crate) use patch::split_points;

use std::rc::Rc;

use basis_kernel::Domain;

use crate::algebra::poly::Var;
use crate::algebra::range::{DisplayRange as _, End, Range, Region};
use crate::algebra::rational::Rational;
use crate::diagnostic::Place;
use crate::model::Parameter;
use crate::model::chart::{Constraint, Piece};
use crate::source::SourceId;
pub use crate::syntax::{PatchKind, TheoremKind, TheoremRelation};
use basis_prover::collections::list::{Listed, Mapped};

/// A theorem or a join.
#[derive(Clone, Debug)]
pub struct Theorem {
    /// Whether it becomes a function.
    pub kind: TheoremKind,
    /// The name.
    pub name: String,
    /// The doc comment, one string a line.
    pub doc: Vec<String>,
    /// The spec that states it.
    pub source: SourceId,
    /// Where its name stands.
    pub place: Place,
    /// The names of all variables.
    pub names: Vec<String>,
    /// The scalars with their ranges: shape values, parameters at which curves are evaluated, factors.
    pub scalars: Vec<Parameter>,
    /// What is assumed of several scalars.
    pub relations: Vec<Constraint>,
    /// The values of the scalars that satisfy these, in parts that are images of boxes; none without relations.
    pub parts: Vec<Piece>,
    /// Of a theorem about one of the parts this part: the ranges of the scalars are those of its box.
    pub part: Piece,
    /// The number of coordinates of points; `None` when the claims are about points of any space.
    pub dimension: Option<usize>,
    /// Variables that stand for the dot products of two given points, in a space of any dimension.
    pub products: Vec<(Var, (usize, usize))>,
    /// The curves and surfaces.
    pub patches: Vec<Patch>,
    /// The given points, by the number that stands in [`Unit::Point`]; with coordinates a variable for each
    /// coordinate of each of them.
    pub points: Vec<GivenPoint>,
    /// The factor of the usual work that the provers may spend on a claim.
    pub budget: u32,
    /// Without the feature `joins` no theorem can be made, so that nothing has to be known of one.
    #[cfg(not(feature = "joins"))]
    pub never: core::convert::Infallible,
}

/// A control point that can be any point.
#[derive(Clone, Debug)]
pub struct GivenPoint {
    /// The name, such as `P[1]`.
    pub name: String,
    /// The patch to which it belongs.
    pub patch: usize,
    /// Its index there.
    pub index: Vec<i64>,
    /// Its coordinates, if points have coordinates.
    pub coordinates: Vec<Var>,
}

/// A curve or surface.
#[derive(Clone, Debug)]
pub struct Patch {
    /// The name.
    pub name: String,
    /// The families with their shape values, as they are written.
    pub written: String,
    /// Whether it is a curve or a surface.
    pub kind: PatchKind,
    /// The names of its parameters.
    pub parameters: Vec<String>,
    /// The control points.
    pub points: Vec<ControlPoint>,
}

/// A control point of a patch.
#[derive(Clone, Debug)]
pub struct ControlPoint {
    /// The index.
    pub index: Vec<i64>,
    /// The point, in terms of given points.
    pub value: Form,
    /// How it comes about.
    pub origin: Origin,
}

/// How a control point comes about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// It is given: it can be any point.
    Given,
    /// It stands in the list of the patch.
    Listed,
    /// `let` determines it.
    Determined,
}

impl Theorem {
    /// `theorem Name` or `join Name`.
    pub fn title(&self) -> String {
        format!("{} {}", self.kind.keyword(), self.name)
    }

    /// What holds of the scalars, as text: their ranges, and how they are related.
    pub fn conditions(&self) -> Vec<String> {
        let ranges = self.scalars.iter().map(|p| p.range.display(&p.name).to_string());
        ranges.chain(self.relations.iter().map(|c| c.text.clone())).listed()
    }

    /// The ranges of the scalars, and of the dot products of points with themselves; all other variables are unbounded.
    pub fn region(&self) -> Region {
        let scalars = self.scalars.iter().map(|p| (p.var, p.range.clone()));
        let squares = self.products.iter().filter(|(_, (p, q))| p == q);
        let nonnegative = Range { low: End::Included(Rational::ZERO), high: End::Infinite };
        Region { ranges: scalars.chain(squares.map(|(var, _)| (*var, nonnegative.clone()))).listed() }
    }

    /// The ranges of the scalars alone.
    pub fn scalar_region(&self) -> Region {
        Region { ranges: self.scalars.mapped(|p| (p.var, p.range.clone())) }
    }

    /// The values of the scalars, and of dot products of points with themselves; all other variables are unbounded.
    pub fn domain(&self) -> Rc<Domain> {
        Rc::new(Domain { premises: self.part.domain().premises, ..Domain::of(self.region()) })
    }

    /// The values of the scalars alone.
    pub fn scalar_domain(&self) -> Rc<Domain> {
        Rc::new(Domain { premises: self.part.domain().premises, ..Domain::of(self.scalar_region()) })
    }

    /// The range of a variable.
    pub fn range(&self, var: Var) -> Range {
        self.scalars.iter().find(|p| p.var == var).map_or(Range::all(), |p| p.range.clone())
    }
}

//! Networks of patches: after one is deformed its neighbours follow.

mod error;
mod follow;
mod transport;

use alloc::vec;
use alloc::vec::Vec;

pub use error::NetworkError;

use super::{BSplineSurface, Direction, Edge, EdgePair, JointBounds};
#[cfg(feature = "serde")]
use crate::serialize::{Read, Written};
use crate::{Point, Point3};

/// Two edges of patches that are one curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Seam {
    /// The patches, by their index in the network; they may be the same one, closed to a ring.
    pub patches: [usize; 2],
    /// The edge of each, and how their parameters run.
    pub edges: EdgePair,
}

impl Seam {
    /// The seam as seen from one of its patches, which is to be adjusted.
    fn joint(&self, side: usize) -> EdgePair {
        if side == 0 { self.edges } else { self.edges.swapped() }
    }
}

/// Patches that share edges.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "crate::serialize::bspline::Patches<P>"))]
#[cfg_attr(
    feature = "serde",
    serde(bound(serialize = "P: Written", deserialize = "P: crate::Point3 + Read<'de>"))
)]
pub struct Network<P: Point> {
    patches: Vec<BSplineSurface<P>>,
    seams: Vec<Seam>,
}

/// What a network is to keep while it follows: the defaults, and what is set otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct FollowOptions {
    /// The largest gap of a seam, in the unit of the points.
    pub gap: f64,
    /// The largest angle between the tangent planes along a seam, in radians.
    pub angle: f64,
    /// The most spans along an edge of a patch that follows.
    pub spans: usize,
}

impl Default for FollowOptions {
    /// Gap 1e-5, angle 1e-4, at most 400 spans.
    fn default() -> Self {
        Self { gap: 1e-5, angle: 1e-4, spans: 400 }
    }
}

super::setters! {
    FollowOptions;
    gap: f64, "With that largest gap of a seam, in the unit of the points.";
    angle: f64, "With that largest angle between the tangent planes along a seam, in radians.";
    spans: usize, "With at most that number of spans along an edge of a patch that follows.";
}

/// A network after one patch was deformed and its neighbours followed.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(serialize = "P: Written", deserialize = "P: crate::Point3 + Read<'de>"))
)]
#[non_exhaustive]
pub struct Followed<P: Point> {
    /// The network.
    pub network: Network<P>,
    /// The patches that changed, the deformed one first. All others are bit by bit the same.
    pub changed: Vec<usize>,
    /// The seams of these patches, with bounds of gap and angle of each, at parameters of the patch that followed.
    pub seams: Vec<(usize, JointBounds)>,
}

impl<P: Point3> Network<P> {
    /// The network of these patches, joined along these seams.
    ///
    /// # Errors
    /// [`NetworkError::Patch`] or [`NetworkError::EdgeTwice`].
    pub fn new(patches: Vec<BSplineSurface<P>>, seams: Vec<Seam>) -> Result<Self, NetworkError> {
        let mut taken = vec![[false; 4]; patches.len()];
        for (index, seam) in seams.iter().enumerate() {
            for (&patch, &edge) in seam.patches.iter().zip([&seam.edges.first, &seam.edges.second]) {
                let edges = taken.get_mut(patch).ok_or(NetworkError::Patch { patch })?;
                let place = Edge::ALL.iter().position(|&other| other == edge).unwrap_or(0); // it is one of them
                if core::mem::replace(&mut edges[place], true) {
                    return Err(NetworkError::EdgeTwice { seam: index });
                }
            }
        }
        Ok(Self { patches, seams })
    }

    /// A grid of patches, given by rows: each one's `UEnd` joins the `UStart` of the next row, its `VEnd` the `VStart`
    /// of the next one in its row.
    ///
    /// # Errors
    /// [`NetworkError::Grid`] if `columns` does not divide the number of patches.
    pub fn grid(patches: Vec<BSplineSurface<P>>, columns: usize) -> Result<Self, NetworkError> {
        let count = patches.len();
        if columns == 0 || !count.is_multiple_of(columns) {
            return Err(NetworkError::Grid { patches: count, columns });
        }
        let mut seams = Vec::new();
        for patch in 0..count {
            let mut join = |next: usize, first: Edge, second: Edge| {
                seams.push(Seam { patches: [patch, next], edges: EdgePair::along(first, second) });
            };
            if patch + columns < count {
                join(patch + columns, Edge::UEnd, Edge::UStart);
            }
            if !(patch + 1).is_multiple_of(columns) {
                join(patch + 1, Edge::VEnd, Edge::VStart);
            }
        }
        Self::new(patches, seams)
    }

    /// The patches.
    pub fn patches(&self) -> &[BSplineSurface<P>] {
        &self.patches
    }

    /// The seams.
    pub fn seams(&self) -> &[Seam] {
        &self.seams
    }

    /// Bounds of the gap and of the angle of a seam, for all of its parameters: [`BSplineSurface::joint_bounds`].
    ///
    /// # Errors
    /// [`NetworkError::NoSeam`], or [`NetworkError::Seam`] if there are none.
    pub fn joint_bounds(&self, seam: usize) -> Result<JointBounds, NetworkError> {
        let Some(&Seam { patches: [a, b], edges }) = self.seams.get(seam) else {
            return Err(NetworkError::NoSeam { seam });
        };
        self.patches[a]
            .joint_bounds(edges, &self.patches[b])
            .map_err(|error| NetworkError::Seam { seam, error })
    }

    /// Replaces a patch by a deformed one over the same domain, and lets its neighbours follow: along the seams, and
    /// around the corners where four patches meet.
    ///
    /// Around a corner of four patches the patch across is reached in two ways. Both ask for the same twist wherever
    /// the opposite edges pass through the corner in one direction; elsewhere they differ, the mean of both is taken,
    /// and the angle that remains falls with the length of the spans next to the corner, which are divided until the
    /// tolerance is met or [`NetworkError::Twist`] says why it is not.
    ///
    /// Each follower keeps the contact it had: the ratio and the slant of the derivatives across the seam. Only the two
    /// rows of control points along a seam change, over knots that are inserted until the tolerances are met; patches
    /// that share neither an edge nor a corner with the deformed one stay bit by bit the same.
    ///
    /// # Errors
    /// If a tolerance is not a positive number, a seam near the patch was not smooth before, the followers around a
    /// corner ask for different twists, or the tolerances cannot be met.
    pub fn follow(
        &self,
        deformed: usize,
        surface: &BSplineSurface<P>,
        options: &FollowOptions,
    ) -> Result<Followed<P>, NetworkError> {
        follow::follow(self, deformed, surface, options)
    }

    /// The seams of a patch, each with the side on which the patch is.
    fn seams_of(&self, patch: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
        let sides =
            |(index, seam): (usize, &Seam)| [(index, 0, seam.patches[0]), (index, 1, seam.patches[1])];
        let all = self.seams.iter().enumerate().flat_map(sides);
        all.filter(move |&(_, _, of)| of == patch).map(|(index, side, _)| (index, side))
    }
}

/// The knots that are inserted into each direction of each patch.
#[derive(Clone, Debug)]
struct Inserted<S> {
    knots: Vec<[Vec<S>; 2]>,
}

impl<S: Copy> Inserted<S> {
    fn new(patches: usize) -> Self {
        Self { knots: vec![[Vec::new(), Vec::new()]; patches] }
    }

    fn of(&self, patch: usize, direction: Direction) -> &Vec<S> {
        &self.knots[patch][usize::from(direction == Direction::V)]
    }

    fn add(&mut self, patch: usize, direction: Direction, knots: impl IntoIterator<Item = S>) {
        self.knots[patch][usize::from(direction == Direction::V)].extend(knots);
    }
}

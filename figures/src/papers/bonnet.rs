//! The bonnet of a car (spl-ex): two B-spline patches that share the centre line; the right one is deformed through
//! four points near it, and the left one follows.

use std::error::Error;

use basis_runtime::bspline::{
    BSplineSurface, Edge, EdgePair, KnotVector, Net, PointConstraint, SpliceOptions,
};

type Point3d = [f64; 3];
type Patch = BSplineSurface<Point3d>;

/// The bonnet before and after, and what was measured.
#[derive(Clone, Debug)]
pub(crate) struct Bonnet {
    /// Left and right patch, joined smoothly.
    pub(crate) before: [Patch; 2],
    /// The points through which the right patch is to pass.
    pub(crate) constraints: [Point3d; 4],
    /// The right patch deformed, the left one not yet following.
    pub(crate) apart: [Patch; 2],
    /// The left patch spliced to the right one.
    pub(crate) after: [Patch; 2],
    /// What was measured, with names: length of the gap and angle in radians of the joint, and more.
    pub(crate) facts: Vec<(&'static str, f64)>,
}

/// Heights of a smooth bonnet over `x` along the car, 0 at the windscreen and 1 at the nose, and `y` across, 0 on the
/// centre line and 1 at the wings.
fn shape(x: f64, y: f64) -> Point3d {
    let fall = 0.42 - 0.10 * x - 0.16 * x.powi(3);
    let arch = 1.0 - 0.55 * y.powi(2) - 0.15 * y.powi(4);
    let taper = 1.0 - 0.12 * x * x;
    [1.6 * x, 0.8 * y * taper, fall * arch]
}

/// A patch that interpolates the shape at the Greville abscissae; `side` is 1 on the right and -1 on the left.
fn patch(across: &KnotVector<f64>, along: &KnotVector<f64>, side: f64) -> Result<Patch, Box<dyn Error>> {
    let (u, v) = (across.greville(), along.greville());
    let grid = Net::from_fn(u.len(), v.len(), |i, j| {
        // The first parameter runs from left to right on both sides.
        let y = if side > 0.0 { u[i] } else { 1.0 - u[i] };
        let [x, y, z] = shape(v[j], y);
        [x, side * y, z]
    })?;
    Ok(BSplineSurface::fit([across.clone(), along.clone()], [&u, &v], &grid)?)
}

/// Builds the example; the tolerances are those of [`SpliceOptions`]: gap 1e-5, angle 1e-4.
pub(crate) fn bonnet() -> Result<Bonnet, Box<dyn Error>> {
    let across = KnotVector::uniform(3, 4)?;
    let coarse = KnotVector::clamped(3, &[0.0, 0.22, 0.41, 0.63, 0.8, 1.0])?;
    let fine = KnotVector::clamped(3, &[0.0, 0.09, 0.2, 0.37, 0.45, 0.6, 0.78, 0.9, 1.0])?;
    let options = SpliceOptions::default();
    let edges = EdgePair::along(Edge::UStart, Edge::UEnd);

    let right = patch(&across, &fine, 1.0)?;
    let left = right.continued_within(edges, &options, &patch(&across, &coarse, -1.0)?)?.surface;
    let first = right.joint_bounds(edges, &left)?;

    // A power dome: four points near the centre line, lifted.
    let lifted = [(0.24, 0.035), (0.42, 0.06), (0.6, 0.06), (0.78, 0.03)];
    let wanted = lifted.map(|(v, height)| {
        let [x, y, z] = right.eval(0.05, v);
        ([0.05, v], [x, y, z + height])
    });
    let at = wanted.map(|(at, point)| PointConstraint::At(at, point));
    // The outer half keeps its place.
    let deformed = right.pass_through_holding(&at, |row, _| row >= 4)?;
    let moved = deformed.surface.joint_bounds(edges, &left)?;
    let follows = deformed.surface.continued_within(edges, &options, &left)?;

    let constraints = wanted.map(|(_, point)| point);
    let facts = vec![
        ("gap", follows.joint.gap),
        ("angle", follows.joint.angle),
        ("gap before", first.gap),
        ("angle before", first.angle),
        ("gap without splicing", moved.gap),
        ("angle without splicing", moved.angle),
        ("distance from the constraints", deformed.miss),
        ("change of the right net", deformed.change),
        ("spans along the centre line", follows.spans as f64),
    ];
    Ok(Bonnet {
        before: [left.clone(), right],
        constraints,
        apart: [left, deformed.surface.clone()],
        after: [follows.surface, deformed.surface],
        facts,
    })
}

#[cfg(test)]
mod tests {
    use super::{Bonnet, bonnet};

    fn fact(bonnet: &Bonnet, name: &str) -> f64 {
        bonnet.facts.iter().find(|(fact, _)| *fact == name).expect("a fact of that name").1
    }

    #[test]
    fn both_tolerances_are_reached() {
        let bonnet = bonnet().expect("the example can be built");
        for when in ["", " before"] {
            assert!(fact(&bonnet, &format!("gap{when}")) <= 1e-5);
            assert!(fact(&bonnet, &format!("angle{when}")) <= 1e-4);
        }
        // The points pulled the joint apart, visibly.
        assert!(fact(&bonnet, "gap without splicing") > 1e-2);
        assert!(fact(&bonnet, "distance from the constraints") < 1e-12);
    }

    #[test]
    fn the_patches_meet_and_the_outer_edges_stay() {
        let bonnet = bonnet().expect("the example can be built");
        let [left, right] = &bonnet.after;
        for i in 0..=20 {
            let v = f64::from(i) / 20.0;
            let (p, q) = (left.eval(1.0, v), right.eval(0.0, v));
            assert!((0..3).all(|c| (p[c] - q[c]).abs() < 1e-12));
            for (after, before, u) in [(left, &bonnet.before[0], 0.0), (right, &bonnet.before[1], 1.0)] {
                let (p, q) = (after.eval(u, v), before.eval(u, v));
                assert!((0..3).all(|c| (p[c] - q[c]).abs() < 1e-12));
            }
        }
        assert!(bonnet.apart[1] == bonnet.after[1] && bonnet.apart[0] == bonnet.before[0]);
        assert_eq!(bonnet.constraints.len(), 4);
    }
}

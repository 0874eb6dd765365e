//! One patch leads, those along its edges follow, and then those at its corners.

use alloc::vec;
use alloc::vec::Vec;

use super::transport::Leader;
use super::{FollowOptions, Followed, Inserted, Network, NetworkError};
use crate::bspline::splice::AIM;
use crate::bspline::splice::measure::{Piece, measure, middles};
use crate::bspline::splice::strip::{Strip, Vector, along, place};
use crate::bspline::{
    BSplineSurface, Continuity, Direction, Edge, JointBounds, KnotError, SpliceError, rows,
};
use crate::vector::length;
use crate::{Point, Point3, Scalar};

/// The most rounds of inserting knots; each may halve all spans.
const ROUNDS: usize = 24;

/// All patches after a round, and how they came to be.
struct Round<P: Point> {
    /// The patches that changed.
    patches: Vec<Option<BSplineSurface<P>>>,
    /// Their indices, the leader first.
    changed: Vec<usize>,
    /// For each seam the side that followed the other one, if one did.
    followed: Vec<Option<usize>>,
    overlaps: Vec<Overlap>,
}

/// Control points of a follower that two seams move.
struct Overlap {
    patch: usize,
    seams: [usize; 2],
    /// How far the two places of a point are apart.
    mismatch: f64,
    /// The same, seen from the edge: the angle by which the tangent plane turns on the way from one to the other.
    angle: f64,
}

pub(super) fn follow<P: Point3>(
    network: &Network<P>,
    deformed: usize,
    surface: &BSplineSurface<P>,
    options: &FollowOptions,
) -> Result<Followed<P>, NetworkError> {
    let Some(old) = network.patches.get(deformed) else {
        return Err(NetworkError::Patch { patch: deformed });
    };
    for (a, b) in old.domain().ranges().into_iter().zip(surface.domain().ranges()) {
        if a != b {
            let domains = [a, b].map(|ends| ends.map(Scalar::to_f64));
            return Err(NetworkError::Domain(KnotError::Domains { domains }));
        }
    }
    for tolerance in [options.gap, options.angle] {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(NetworkError::Tolerance { tolerance });
        }
    }
    let mut inserted = Inserted::new(network.patches.len());
    for number in 0.. {
        let round = round(network, deformed, surface, &inserted)?;
        let figures = figures(network, &round)?;
        if number == 0 {
            for (seam, _, _) in &figures {
                let joint = network.joint_bounds(*seam)?;
                if joint.gap > options.gap || joint.angle > options.angle {
                    return Err(NetworkError::NotSmooth { seam: *seam, joint });
                }
            }
        }
        let excess = |m: &JointBounds| m.excess(options.gap, options.angle);
        let worst = figures.iter().max_by(|a, b| excess(&a.1).total_cmp(&excess(&b.1)));
        let Some(&(seam, achieved, _)) = worst.filter(|(_, measured, _)| excess(measured) > 1.0) else {
            return Ok(followed(network, &round, &figures));
        };
        if number == ROUNDS || !refine(network, &round, &figures, options, &mut inserted) {
            return Err(explain(network, &round, seam, achieved, options));
        }
    }
    Err(NetworkError::Patch { patch: deformed }) // not reached: the last round returns
}

/// All patches over the knots inserted so far.
fn round<P: Point3>(
    network: &Network<P>,
    deformed: usize,
    surface: &BSplineSurface<P>,
    inserted: &Inserted<P::Scalar>,
) -> Result<Round<P>, NetworkError> {
    let count = network.patches.len();
    let mut round = Round {
        patches: vec![None; count],
        changed: vec![deformed],
        followed: vec![None; network.seams.len()],
        overlaps: Vec::new(),
    };
    round.patches[deformed] = Some(surface.clone());
    let size = largest_change(&network.patches[deformed], surface);
    let mut leaders = vec![deformed];
    // Along the edges of the deformed patch, then around its corners.
    for _ in 0..2 {
        let mut requests: Vec<(usize, Vec<(usize, usize)>)> = Vec::new();
        for &leader in &leaders {
            for (seam, side) in network.seams_of(leader) {
                let follower = network.seams[seam].patches[1 - side];
                if round.patches[follower].is_some() {
                    continue;
                }
                let strips = strips(network, &round, seam, 1 - side, &network.patches[follower])?;
                if strips.change() <= 1e-13 * size {
                    continue;
                }
                match requests.iter_mut().find(|(patch, _)| *patch == follower) {
                    Some((_, seams)) => seams.push((seam, 1 - side)),
                    None => requests.push((follower, vec![(seam, 1 - side)])),
                }
            }
        }
        leaders.clear();
        let mut adjusted = Vec::new();
        for (follower, seams) in requests {
            let base = &network.patches[follower];
            adjusted.push((follower, adjust(network, &mut round, follower, base, &seams, inserted)?));
            for (seam, side) in seams {
                round.followed[seam] = Some(side);
            }
        }
        for (follower, patch) in adjusted {
            round.patches[follower] = Some(patch);
            round.changed.push(follower);
            leaders.push(follower);
        }
    }
    Ok(round)
}

/// The leader's strips, before and after, over the parameter of the follower.
fn strips<P: Point3>(
    network: &Network<P>,
    round: &Round<P>,
    seam: usize,
    side: usize,
    follower: &BSplineSurface<P>,
) -> Result<Leader, NetworkError> {
    let (leader, joint) = (network.seams[seam].patches[1 - side], network.seams[seam].joint(side));
    let knots = follower.knots(along(joint.first)).to_f64();
    let strip = |patch: &BSplineSurface<P>| {
        let strip = Strip::new(&patch.clamped(), joint.second)?;
        strip.mapped::<P::Scalar>(knots.domain(), joint.orientation, &knots)
    };
    let wrong = |error| NetworkError::Seam { seam, error };
    let old = strip(&network.patches[leader]).map_err(wrong)?;
    let new = match &round.patches[leader] {
        Some(patch) => strip(patch).map_err(wrong)?,
        None => old.clone(),
    };
    // The row next to the edge stands for the derivative: it has to do so over the same width.
    let new = new.with_factor(old.factor);
    Ok(Leader { old, new })
}

/// A follower over knots in which the changes of its leaders can be written, with the rows along all of its seams
/// changed.
fn adjust<P: Point3>(
    network: &Network<P>,
    round: &mut Round<P>,
    follower: usize,
    patch: &BSplineSurface<P>,
    seams: &[(usize, usize)],
    inserted: &Inserted<P::Scalar>,
) -> Result<BSplineSurface<P>, NetworkError> {
    let wrong = |seam| move |error: KnotError| NetworkError::Seam { seam, error: SpliceError::Knots(error) };
    let first = seams[0].0;
    let mut patch = patch.clamped();
    for direction in [Direction::U, Direction::V] {
        // Two rows at each edge, so that the opposite edges keep theirs.
        while patch.knots(direction).degree() < 2 {
            patch = patch.elevate(direction).map_err(wrong(first))?;
        }
        while patch.knots(direction).functions() < 4 {
            let finer = patch.refined(direction);
            if finer == patch {
                return Err(NetworkError::Seam { seam: first, error: SpliceError::OneRow });
            }
            patch = finer;
        }
    }
    for &(seam, side) in seams {
        let direction = along(network.seams[seam].joint(side).first);
        let leader = strips(network, round, seam, side, &patch)?;
        let degree = leader.new.knots.degree().max(leader.old.knots.degree());
        while patch.knots(direction).degree() < degree {
            patch = patch.elevate(direction).map_err(wrong(seam))?;
        }
        let degree = patch.knots(direction).degree();
        for strip in [&leader.old, &leader.new] {
            let strip = strip.elevated(degree).map_err(|error| NetworkError::Seam { seam, error })?;
            let missing =
                rows::missing(&patch.knots(direction).to_f64(), &strip.knots).map_err(wrong(seam))?;
            let missing: Vec<_> = missing.into_iter().map(P::Scalar::of).collect();
            patch = patch.insert_knots(direction, &missing).map_err(wrong(seam))?;
        }
    }
    for direction in [Direction::U, Direction::V] {
        let new = inserted.of(follower, direction).iter().copied();
        let new: Vec<_> = new.filter(|&t| patch.knots(direction).multiplicity(t) == 0).collect();
        patch = patch.insert_knots(direction, &new).map_err(wrong(first))?;
    }

    // The change of each control point, and the seam that asks for it; the mean where two do.
    let columns = patch.net().columns();
    let mut changes: Vec<Option<(Vector, usize)>> = vec![None; patch.net().as_slice().len()];
    let mut overlaps: Vec<Overlap> = Vec::new();
    for &(seam, side) in seams {
        let edge = network.seams[seam].joint(side).first;
        let seam_error = |error| NetworkError::Seam { seam, error };
        let leader = strips(network, round, seam, side, &patch)?;
        let strip = Strip::new(&patch, edge).map_err(seam_error)?;
        let rows = leader.transported(&strip).map_err(seam_error)?;
        for (layer, row) in rows.iter().enumerate() {
            for (j, &change) in row.iter().enumerate() {
                let [a, b] = place(&patch, edge, layer, j);
                let entry = &mut changes[a * columns + b];
                *entry = Some(match entry.take() {
                    None => (change, seam),
                    Some((other, before)) => {
                        let mismatch = length(change.minus(other));
                        let angle = mismatch / distance_from_edge(&patch, edge, layer, j);
                        let seams = [before, seam];
                        match overlaps.iter_mut().find(|overlap| overlap.seams == seams) {
                            Some(overlap) => {
                                overlap.mismatch = overlap.mismatch.max(mismatch);
                                overlap.angle = overlap.angle.max(angle);
                            }
                            None => overlaps.push(Overlap { patch: follower, seams, mismatch, angle }),
                        }
                        (change.add_weighted(other, 1.0).scale(0.5), before)
                    }
                });
            }
        }
    }
    round.overlaps.extend(overlaps);
    for (point, change) in patch.control_points_mut().iter_mut().zip(&changes) {
        if let Some((change, _)) = change
            && *change != [0.0; 3]
        {
            *point = P::from_components(|i| P::Scalar::of(point.component(i).to_f64() + change[i]));
        }
    }
    Ok(patch)
}

/// How far a control point is from the one of the edge row beside it; infinite in that row itself.
fn distance_from_edge<P: Point3>(patch: &BSplineSurface<P>, edge: Edge, layer: usize, j: usize) -> f64 {
    if layer == 0 {
        return f64::INFINITY;
    }
    let [here, beside] = [layer, 0].map(|layer| patch.net()[place(patch, edge, layer, j)]);
    length(here.minus(beside)).to_f64()
}

/// How much the rows along any edge changed, at most.
fn largest_change<P: Point3>(old: &BSplineSurface<P>, new: &BSplineSurface<P>) -> f64 {
    let Ok([old, new]) = old.merged(new) else { return 0.0 };
    let pairs = old.net().as_slice().iter().zip(new.net().as_slice());
    pairs.map(|(a, b)| length(b.minus(*a)).to_f64()).fold(0.0, f64::max)
}

/// The figures of all seams of changed patches, and those of the pieces of each.
type Figures = Vec<(usize, JointBounds, Vec<Piece>)>;

fn figures<P: Point3>(network: &Network<P>, round: &Round<P>) -> Result<Figures, NetworkError> {
    let mut all = Vec::new();
    for (index, seam) in network.seams.iter().enumerate() {
        let wrong = |error| NetworkError::Seam { seam: index, error };
        if !seam.patches.iter().any(|&patch| round.patches[patch].is_some()) {
            continue;
        }
        // From the side that followed, whose spans are divided.
        let side = round.followed[index].unwrap_or(0);
        let joint = seam.joint(side);
        let patch = |side: usize| {
            let patch = seam.patches[side];
            round.patches[patch].as_ref().unwrap_or(&network.patches[patch]).clamped()
        };
        let strip = Strip::new(&patch(side), joint.first).map_err(wrong)?;
        let other = Strip::new(&patch(1 - side), joint.second).map_err(wrong)?;
        let other = other
            .mapped::<P::Scalar>(strip.knots.domain(), joint.orientation, &strip.knots)
            .map_err(wrong)?;
        let (measured, pieces) = measure(&strip, &other, Continuity::G1).map_err(wrong)?;
        all.push((index, measured, pieces));
    }
    Ok(all)
}

/// Chooses knots for the followers whose seams are not good enough; false if that cannot help.
fn refine<P: Point3>(
    network: &Network<P>,
    round: &Round<P>,
    figures: &Figures,
    options: &FollowOptions,
    inserted: &mut Inserted<P::Scalar>,
) -> bool {
    let mut any = false;
    for (seam, _, pieces) in figures {
        let Some(side) = round.followed[*seam] else { continue };
        let described = &network.seams[*seam];
        let (follower, direction) = (described.patches[side], along(described.joint(side).first));
        let Some(patch) = &round.patches[follower] else { continue };
        let knots = patch.knots(direction).to_f64();
        let new = middles::<P::Scalar>(&knots, pieces, AIM * options.gap, AIM * options.angle);
        if knots.spans().count() + new.len() > options.spans {
            return false;
        }
        any |= !new.is_empty();
        inserted.add(follower, direction, new.into_iter().map(P::Scalar::of));
    }
    any
}

/// Why a seam is not good enough.
fn explain<P: Point3>(
    network: &Network<P>,
    round: &Round<P>,
    worst: usize,
    achieved: JointBounds,
    options: &FollowOptions,
) -> NetworkError {
    let seam = &network.seams[worst];
    if seam.patches[0] == seam.patches[1] && seam.patches[0] == round.changed[0] {
        return NetworkError::Ring { seam: worst, achieved };
    }
    let changed = |side: usize| round.patches[seam.patches[side]].is_some();
    if round.followed[worst].is_none() && changed(0) && changed(1) {
        return NetworkError::Corner { seam: worst, achieved };
    }
    let torn = |overlap: &&Overlap| {
        achieved.angle > options.angle
            && overlap.angle > options.angle
            && is_next_to(network, round, overlap, worst, achieved.angle_at)
    };
    match round.overlaps.iter().find(torn) {
        Some(&Overlap { patch, seams, mismatch, .. }) => {
            NetworkError::Twist { patch, seams, mismatch, worst, achieved }
        }
        None => NetworkError::NotReached { seam: worst, achieved },
    }
}

/// Whether the place at that parameter of a seam is within reach of the control points of an overlap.
fn is_next_to<P: Point3>(
    network: &Network<P>,
    round: &Round<P>,
    overlap: &Overlap,
    seam: usize,
    parameter: f64,
) -> bool {
    let edge = |index: usize| {
        let seam = &network.seams[index];
        seam.joint(usize::from(round.followed[index] == Some(1))).first
    };
    let other = match overlap.seams {
        [a, b] if a == seam => b,
        [a, b] if b == seam => a,
        _ => return false,
    };
    let Some(patch) = &round.patches[overlap.patch] else { return false };
    let knots = patch.knots(along(edge(seam))).to_f64();
    let breakpoints = knots.breakpoints();
    let reach = knots.degree().min(breakpoints.len() - 1);
    if edge(other).is_end() {
        parameter >= breakpoints[breakpoints.len() - 1 - reach]
    } else {
        parameter <= breakpoints[reach]
    }
}

fn followed<P: Point3>(network: &Network<P>, round: &Round<P>, figures: &Figures) -> Followed<P> {
    let patches = network.patches.iter().zip(&round.patches);
    let patches = patches.map(|(old, new)| new.as_ref().unwrap_or(old).clone()).collect();
    Followed {
        network: Network { patches, seams: network.seams.clone() },
        changed: round.changed.clone(),
        seams: figures.iter().map(|(seam, measure, _)| (*seam, *measure)).collect(),
    }
}

//! The change of a follower's two rows with which a seam keeps its contact.

use alloc::vec::Vec;

use crate::Point;
use crate::bspline::SpliceError;
use crate::bspline::splice::dense::fit;
use crate::bspline::splice::strip::{Frame, Strip, Vector};
use crate::vector::{cross, direction, dot, length};

/// Coefficients below this part of the largest one are rounding errors of the fit: such control points do not move.
const NOISE: f64 = 1e-12;

/// The leader of a seam before and after its change, over the follower's parameter.
pub(super) struct Leader {
    pub(super) old: Strip,
    pub(super) new: Strip,
}

impl Leader {
    /// The largest change of a point of the edge or of the row next to it.
    pub(super) fn change(&self) -> f64 {
        let mut parameters = self.old.knots.breakpoints();
        parameters.extend(self.new.knots.breakpoints());
        parameters.sort_by(f64::total_cmp);
        parameters.dedup();
        let mut largest = 0.0_f64;
        for ends in parameters.windows(2) {
            for i in 0..=6 {
                let t = ends[0] + (ends[1] - ends[0]) * f64::from(i) / 6.0;
                let (old, new) = (self.old.at(t), self.new.at(t));
                let edge = new.point.minus(old.point);
                let inner = edge.add_scaled(new.across.minus(old.across), 1.0);
                largest = largest.max(length(edge)).max(length(inner));
            }
        }
        largest
    }

    /// The changes of the edge row and of the row next to it of the follower, as control points over its knots.
    ///
    /// Before, at each parameter, the follower's difference `X` of the two rows was `-α L + γ T + δ n`: `L` that of the
    /// leader, `T` the tangent along the edge, `n` the normal. The same `α, γ, δ` are kept:
    ///
    /// ```text
    /// ΔX = -α ΔL + γ ΔT + δ Δn
    /// ```
    ///
    /// so tangent planes that agreed agree afterwards. The four patches around a corner agree about its twist if `γ` is
    /// 0 in the corner: both ways around it then give the fourth patch `c S_uv + a S_u + b S_v` of the first one, with
    /// the same `c`, the product of the ratios; and the same `a` and `b`, because the patches agreed before and `S_u`,
    /// `S_v` are independent. With `γ ≠ 0` second derivatives along the edges come in as well, which nothing
    /// determines.
    pub(super) fn transported(&self, follower: &Strip) -> Result<[Vec<Vector>; 2], SpliceError> {
        let edge = fit(&follower.knots, |t| Ok(self.new.at(t).point.minus(self.old.at(t).point)), None)?;
        let across = fit(
            &follower.knots,
            |t| {
                let (old, new) = (self.old.at(t), self.new.at(t));
                if old.across == new.across && old.tangent == new.tangent {
                    return Ok([0.0; 3]);
                }
                let [alpha, gamma, delta] =
                    contact(&old, &follower.at(t)).ok_or(SpliceError::Degenerate { parameter: t })?;
                let normals = [&old, &new].map(normal);
                let [Some(n), Some(m)] = normals else {
                    return Err(SpliceError::Degenerate { parameter: t });
                };
                let change = new.across.minus(old.across).scale(-alpha);
                let change = change.add_scaled(new.tangent.minus(old.tangent), gamma);
                Ok(change.add_scaled(m.minus(n), delta))
            },
            None,
        )?;
        let inner = edge.iter().zip(&across).map(|(a, b)| a.add_weighted(*b, 1.0)).collect();
        let mut rows = [edge, inner];
        let largest = rows.iter().flatten().map(|&p| length(p)).fold(0.0, f64::max);
        for point in rows.iter_mut().flatten() {
            if length(*point) <= NOISE * largest {
                *point = [0.0; 3];
            }
        }
        Ok(rows)
    }
}

fn normal(frame: &Frame) -> Option<Vector> {
    direction(cross(direction(frame.across)?, direction(frame.tangent)?))
}

/// `α, γ, δ` with `follower.across = -α leader.across + γ leader.tangent + δ n`.
fn contact(leader: &Frame, follower: &Frame) -> Option<[f64; 3]> {
    let (across, tangent, n) = (leader.across, leader.tangent, normal(leader)?);
    let x = follower.across;
    let delta = dot(x, n);
    // In the plane: two equations with the Gram matrix of `across` and `tangent`.
    let (aa, at, tt) = (dot(across, across), dot(across, tangent), dot(tangent, tangent));
    let determinant = aa * tt - at * at;
    if determinant <= 1e-14 * aa * tt {
        return None;
    }
    let (xa, xt) = (dot(x, across), dot(x, tangent));
    Some([-(xa * tt - xt * at) / determinant, (xt * aa - xa * at) / determinant, delta])
}

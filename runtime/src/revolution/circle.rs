//! The rational half-turn, and the parameter that belongs to an angle.

use crate::Scalar;

/// The parameter `t` at which the rational half-turn
///
/// ```text
/// cos α = (1 - 2t) / (1 - 2t + 2t²),   sin α = 2t (1 - t) / (1 - 2t + 2t²),   0 <= t <= 1
/// ```
///
/// has turned by the angle `α`, `0 <= α <= π`:
///
/// ```text
/// t = sin(α/2) / (sin(α/2) + cos(α/2)),   since tan(α/2) = t / (1 - t)
/// ```
///
/// The half-turn is that of "Surfaces of revolution with shape parameters from quartic λ-Bézier generatrices", which takes
/// `t = α/π`; that is right only for 0, π/2 and π, and off by up to 8.1° between them.
///
/// ```
/// use basis_runtime::half_turn_parameter;
///
/// assert_eq!(half_turn_parameter(0.0), 0.0);
/// let third = half_turn_parameter(std::f64::consts::FRAC_PI_3); // 1 / (1 + √3), not 1/3
/// assert!((third - 0.366_025_403_784_438_6).abs() < 1e-15);
/// ```
pub fn half_turn_parameter<S: Scalar>(angle: S) -> S {
    let (sin, cos) = (angle * S::of(0.5)).sin_cos();
    // The cosine of the float next to π/2 is not zero.
    if angle >= S::PI { S::ONE } else { sin / (sin + cos) }
}

/// `[cos α, sin α]`, and exactly `[1, 0]` after a full turn.
pub(super) fn direction<S: Scalar>(angle: S) -> [S; 2] {
    if angle == S::of(2.0) * S::PI {
        return [S::ONE, S::ZERO];
    }
    let (sin, cos) = angle.sin_cos();
    [cos, sin]
}

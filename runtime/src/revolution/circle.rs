//! Circular arcs as rational curves, and the parameter that belongs to an angle.

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
/// The half-turn is that of "Surfaces of revolution with shape parameters from quartic λ-Bézier generatrices", which
/// takes `t = α/π`; that is right only for 0, π/2 and π, and off by up to 8.1° between them.
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

/// A turn by an angle of at most 2π, divided into the fewest equal arcs of at most π/2, each a rational quadratic.
///
/// The arc from `α0` to `α1` has the weights 1, `w = cos((α1 - α0)/2)`, 1; the middle control point is where the
/// tangents of its ends meet. So the coefficients of `w cos α` and `w sin α` are cosine and sine of `α0`,
/// `(α0 + α1)/2`, `α1`.
#[cfg(feature = "alloc")]
pub(crate) struct Arcs<S> {
    angle: S,
    count: usize,
}

#[cfg(feature = "alloc")]
impl<S: Scalar> Arcs<S> {
    pub(crate) fn new(angle: S) -> Self {
        let quarters = angle / (S::PI * S::of(0.5));
        // At most four: the angle is at most 2π.
        let count = (1..4).find(|&n| quarters <= S::from_usize(n)).unwrap_or(4);
        Self { angle, count }
    }

    pub(crate) fn count(&self) -> usize {
        self.count
    }

    /// The angle after that many halves of an arc; after the last one exactly the whole angle.
    fn angle(&self, halves: usize) -> S {
        if halves == 2 * self.count {
            self.angle
        } else {
            self.angle * S::from_usize(halves) / S::from_usize(2 * self.count)
        }
    }

    /// The angles at the ends of the arcs, from 0 on, each but the first and the last twice: breakpoints of a quadratic
    /// spline.
    #[cfg(feature = "bspline")]
    pub(crate) fn breakpoints(&self) -> alloc::vec::Vec<S> {
        (1..=2 * self.count).map(|k| self.angle(k / 2 * 2)).collect()
    }

    /// `[w cos α, w sin α, w]` at a control point, the ends of arcs being those with even numbers.
    pub(crate) fn control_point(&self, halves: usize) -> [S; 3] {
        let [cos, sin] = direction(self.angle(halves));
        let weight = if halves.is_multiple_of(2) {
            S::ONE
        } else {
            (self.angle * S::of(0.5) / S::from_usize(self.count)).sin_cos().1
        };
        [cos, sin, weight]
    }
}

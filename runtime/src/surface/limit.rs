//! Limits of normals where the product of the first partial derivatives vanishes.
//!
//! With the Taylor coefficients `c[i][j]` of the surface at the point, in steps `p`, `q` of the parameters,
//!
//! ```text
//! S_u × S_v = Σ N[a][b] p^a q^b,   N[a][b] = Σ (i+1) (l+1) c[i+1][j] × c[k][l+1]   over i + k = a, j + l = b
//! ```
//!
//! After the common factor `p^α q^β` is taken out, the terms of the lowest total order m decide: the normal has a limit
//! if they are all multiples `h[a][b]` of one vector and the form `Σ h[a][b] p^a q^b`, times the sign of the common
//! factor, has one sign for all steps into the domain.

use crate::numeric::binomial::row;
use crate::vector::{cross, direction, dot, largest_component};
use crate::{Point, Scalar, SurfaceDomain};

/// Where a parameter lies in its range, which decides on the steps into the domain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Side {
    /// At the lower end: steps are positive.
    Start,
    /// Steps have both signs.
    Inside,
    /// At the upper end: steps are negative.
    End,
}

impl Side {
    /// The side on which `t` lies. Near an end the derivatives cannot tell whether a pole is at `t` or at the end.
    pub(crate) fn of<S: Scalar>(t: S, [lo, hi]: [S; 2]) -> Self {
        let near = S::of(8.0) * S::EPSILON.sqrt() * (hi - lo);
        if (t - lo).abs() <= near {
            Self::Start
        } else if (t - hi).abs() <= near {
            Self::End
        } else {
            Self::Inside
        }
    }

    /// The signs of the steps into the domain.
    fn signs(self) -> &'static [bool] {
        match self {
            Self::Start => &[false],
            Self::Inside => &[false, true],
            Self::End => &[true],
        }
    }
}

/// A bound of the rounding error of a derivative of a surface of that size.
pub(crate) fn rounding<S: Scalar>(size: S) -> S {
    S::of(64.0) * S::EPSILON * size
}

/// The limit of the direction of `S_u × S_v` at a point of the domain, from the partial derivatives there.
pub(crate) fn limit_normal<P: Point<Vector = P>, const K: usize>(
    partials: &[[P; K]; K],
    domain: SurfaceDomain<P::Scalar>,
    at: [P::Scalar; 2],
) -> Option<P> {
    let orders = K - 1;
    let (turned, sides, known) = match domain {
        SurfaceDomain::Rectangle([u, v]) => (*partials, [Side::of(at[0], u), Side::of(at[1], v)], 2 * K),
        SurfaceDomain::Triangle => {
            let (partials, sides) = on_triangle(partials, at);
            (partials, sides, orders - 1)
        }
    };
    let coefficients = taylor(&turned, domain.widths())?;
    let (product, mut zero) = products(&coefficients);
    for (a, row) in zero.iter_mut().enumerate() {
        row.iter_mut().skip((known + 1).saturating_sub(a)).for_each(|zero| *zero = true);
    }
    let alpha = (0..orders).find(|&a| (0..orders).any(|b| !zero[a][b]))?;
    let beta = (0..orders).find(|&b| (0..orders).any(|a| !zero[a][b]))?;
    // Total orders for which all coefficients are known.
    let unknown = (orders - alpha.max(beta)).min((known + 1).saturating_sub(alpha + beta));
    let lowest = (0..unknown).find(|&m| (0..=m).any(|a| !zero[alpha + a][beta + m - a]))?;
    let form: [P; K] =
        core::array::from_fn(|a| if a <= lowest { product[alpha + a][beta + lowest - a] } else { P::zero() });
    let form = &form[..=lowest];

    let reference = form.iter().copied().fold(P::zero(), |largest, vector| {
        if largest_component(vector) > largest_component(largest) { vector } else { largest }
    });
    let normal = direction(reference)?;
    let tolerance = largest_component(reference) * P::Scalar::EPSILON.sqrt();
    if form.iter().any(|&vector| largest_component(cross(normal, vector)) > tolerance) {
        return None;
    }
    let mut heights = [P::Scalar::ZERO; K];
    for (a, &vector) in form.iter().enumerate() {
        heights[a] = dot(normal, vector);
    }
    let sign = sign_on_steps(&heights[..=lowest], [alpha, beta], sides)?;
    Some(normal.scale(sign))
}

/// The partial derivatives of a surface over a triangle in two barycentric coordinates that stand in the order of `u, v, w`
/// around the triangle, so that the normal stays, the third one not small; with the sides of both. Those of a total order
/// from `K` on are not known, and left zero.
fn on_triangle<P: Point<Vector = P>, const K: usize>(
    partials: &[[P; K]; K],
    [u, v]: [P::Scalar; 2],
) -> ([[P; K]; K], [Side; 2]) {
    let w = P::Scalar::ONE - u - v;
    let unit = [P::Scalar::ZERO, P::Scalar::ONE];
    // No coordinate is large, but all three are not small together.
    let side = |x: P::Scalar| if Side::of(x, unit) == Side::Start { Side::Start } else { Side::Inside };
    // Of both coordinates the derivatives along u and v.
    let (directions, sides) = if side(w) == Side::Inside {
        ([[1, 0], [0, 1]], [u, v])
    } else if side(u) == Side::Inside {
        ([[-1, 1], [-1, 0]], [v, w])
    } else {
        ([[0, -1], [1, -1]], [w, u])
    };
    let mut turned = [[P::zero(); K]; K];
    for (i, row) in turned.iter_mut().enumerate() {
        for (j, slot) in row.iter_mut().enumerate().take(K - i) {
            // (a ∂u + b ∂v)^i (c ∂u + d ∂v)^j by powers of ∂v.
            let mut powers = [P::Scalar::ZERO; K];
            powers[0] = P::Scalar::ONE;
            let factors =
                core::iter::repeat_n(directions[0], i).chain(core::iter::repeat_n(directions[1], j));
            for [along_u, along_v] in factors.map(|d| d.map(|x| P::Scalar::of(f64::from(x)))) {
                for k in (0..K).rev() {
                    let below = if k > 0 { powers[k - 1] } else { P::Scalar::ZERO };
                    powers[k] = powers[k] * along_u + below * along_v;
                }
            }
            for (k, &factor) in powers.iter().enumerate().take(i + j + 1) {
                *slot = slot.add_weighted(partials[i + j - k][k], factor);
            }
        }
    }
    (turned, sides.map(side))
}

/// The Taylor coefficients on the unit square, scaled so that the largest component is 1; `None` if one is not finite
/// or all are zero.
fn taylor<P: Point, const K: usize>(partials: &[[P; K]; K], widths: [P::Scalar; 2]) -> Option<[[P; K]; K]> {
    let mut coefficients = *partials;
    let mut largest = P::Scalar::ZERO;
    let mut u_factor = P::Scalar::ONE;
    for (i, row) in coefficients.iter_mut().enumerate() {
        if i > 0 {
            u_factor = u_factor * widths[0] / P::Scalar::from_usize(i);
        }
        let mut factor = u_factor;
        for (j, coefficient) in row.iter_mut().enumerate() {
            if j > 0 {
                factor = factor * widths[1] / P::Scalar::from_usize(j);
            }
            *coefficient = coefficient.scale(factor);
            let size = largest_component(*coefficient);
            if !size.is_finite() {
                return None;
            }
            if size > largest {
                largest = size;
            }
        }
    }
    if largest == P::Scalar::ZERO {
        return None;
    }
    Some(coefficients.map(|row| row.map(|c| P::from_components(|i| c.component(i) / largest))))
}

/// The coefficients `N[a][b]`, `a, b <= K - 2`, and which of them are zero up to rounding errors.
#[allow(clippy::type_complexity)] // two tables of one shape
fn products<P: Point<Vector = P>, const K: usize>(c: &[[P; K]; K]) -> ([[P; K]; K], [[bool; K]; K]) {
    let mut product = [[P::zero(); K]; K];
    let mut zero = [[true; K]; K];
    let error = rounding(P::Scalar::ONE);
    for a in 0..K - 1 {
        for b in 0..K - 1 {
            let mut bound = P::Scalar::ZERO;
            for i in 0..=a {
                for j in 0..=b {
                    let (k, l) = (a - i, b - j);
                    let factor = P::Scalar::from_usize((i + 1) * (l + 1));
                    let (along_u, along_v) = (c[i + 1][j], c[k][l + 1]);
                    product[a][b] = product[a][b].add_weighted(cross(along_u, along_v), factor);
                    bound = bound
                        + factor * error * (largest_component(along_u) + largest_component(along_v) + error);
                }
            }
            zero[a][b] = largest_component(product[a][b]) <= bound;
        }
    }
    (product, zero)
}

/// The sign, ±1, of `p^α q^β Σ_a heights[a] p^a q^(m-a)` if it is the same for all steps into the domain.
fn sign_on_steps<S: Scalar>(heights: &[S], [alpha, beta]: [usize; 2], sides: [Side; 2]) -> Option<S> {
    let m = heights.len() - 1;
    let mut common = None;
    for &p_negative in sides[0].signs() {
        for &q_negative in sides[1].signs() {
            // The form on the segment p = x, q = 1 - x of this quadrant, in Bernstein form.
            let mut coefficients = [S::ZERO; 16];
            for ((a, &height), binomial) in heights.iter().enumerate().zip(row(m)) {
                let odd = (p_negative && (alpha + a) % 2 == 1) ^ (q_negative && (beta + m - a) % 2 == 1);
                coefficients[a] = if odd { -height } else { height } / S::of(binomial);
            }
            let sign = one_sign(&mut coefficients[..=m], 8)?;
            if *common.get_or_insert(sign) != sign {
                return None;
            }
        }
    }
    common
}

/// The sign that a polynomial with these Bernstein coefficients has on the whole of the unit interval; `None` if it is
/// zero somewhere, or nearly.
fn one_sign<S: Scalar>(coefficients: &mut [S], depth: usize) -> Option<S> {
    if coefficients.iter().all(|&c| c > S::ZERO) {
        return Some(S::ONE);
    }
    if coefficients.iter().all(|&c| c < S::ZERO) {
        return Some(-S::ONE);
    }
    let (first, last) = (coefficients[0], coefficients[coefficients.len() - 1]);
    if depth == 0 || first * last <= S::ZERO {
        return None;
    }
    // De Casteljau's algorithm at 1/2: the right half is left in place.
    let mut left = [S::ZERO; 16];
    let len = coefficients.len();
    for (k, slot) in left.iter_mut().enumerate().take(len) {
        *slot = coefficients[0];
        for i in 0..len - 1 - k {
            coefficients[i] = (coefficients[i] + coefficients[i + 1]) * S::of(0.5);
        }
    }
    let sign = one_sign(&mut left[..len], depth - 1)?;
    (one_sign(coefficients, depth - 1)? == sign).then_some(sign)
}

#[cfg(test)]
mod tests {
    use super::{Side, one_sign, sign_on_steps};

    #[test]
    fn signs_of_polynomials() {
        assert_eq!(one_sign(&mut [1.0, -0.9, 1.0], 8), Some(1.0));
        assert_eq!(one_sign(&mut [-1.0, 0.5, -1.0], 8), Some(-1.0));
        assert_eq!(one_sign(&mut [1.0, -1.0, 1.0], 8), None); // (1 - 2x)²
        assert_eq!(one_sign(&mut [1.0, -2.0, 1.0], 8), None);
        assert_eq!(one_sign(&mut [0.0], 8), None);
        assert_eq!(one_sign(&mut [f64::NAN], 8), None);
    }

    #[test]
    fn signs_of_forms() {
        let both = [Side::Inside, Side::Inside];
        let corner = [Side::Start, Side::End];
        // p² + q² everywhere; p q at a corner with p > 0 > q; p + q nowhere but at a corner.
        assert_eq!(sign_on_steps(&[1.0, 0.0, 1.0], [0, 0], both), Some(1.0));
        assert_eq!(sign_on_steps(&[1.0], [1, 1], corner), Some(-1.0));
        assert_eq!(sign_on_steps(&[1.0], [1, 1], both), None);
        assert_eq!(sign_on_steps(&[1.0], [2, 0], both), Some(1.0));
        assert_eq!(sign_on_steps(&[1.0, 1.0], [0, 0], [Side::Start, Side::Start]), Some(1.0));
        assert_eq!(sign_on_steps(&[1.0, 1.0], [0, 0], corner), None);
        assert_eq!(sign_on_steps(&[-1.0, 1.0], [0, 0], corner), Some(1.0));
    }
}

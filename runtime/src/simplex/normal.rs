//! Normals of triangular patches, at points where the product of the partial derivatives vanishes as a limit.
//!
//! Such a point cuts the triangle into up to three that have it as a corner. With the Bernstein points of one of them,
//! and y, z the coordinates of the two other corners,
//!
//! ```text
//! S_y × S_z = Σ N[j][k] y^j z^k (1 - y - z)^(D - j - k),   D = 2 (degree - 1)
//! ```
//!
//! For y, z → 0 the terms on the lower left boundary of the Newton polygon of the N[j][k] ≠ 0 prevail; common powers of
//! y and z, which an edge that has shrunk to a point makes, only move the polygon. The direction has a limit if all
//! these terms are multiples of one vector and the polynomial of every side of the boundary has one sign for y, z > 0.

use super::TriangularBasis;
use super::index::TriangleIndex;
use super::net::{contract, moved_corner};
use crate::numeric::binomial::binomial;
use crate::vector::{cross, direction, dot, largest_component};
use crate::{Array, Point, Scalar};

/// The unit normal at a point of the triangle.
pub(crate) fn normal<B: TriangularBasis, P: Point<Scalar = B::Scalar, Vector = P>>(
    net: B::Bernstein<P>,
    degree: usize,
    at: [B::Scalar; 3],
) -> Option<P> {
    let (net, error) = normalized::<B, P>(net, degree)?;
    if degree == 0 {
        return None;
    }
    let mut last = net;
    for m in (2..=degree).rev() {
        contract(last.as_mut(), m, &at);
    }
    let corners = last.as_ref();
    // In lexicographic order the corner w comes first, the corner u last.
    let (along_u, along_v) = (corners[2].minus(corners[0]), corners[1].minus(corners[0]));
    let product = cross(along_u, along_v);
    let [a, b] = [along_u, along_v].map(largest_component);
    if largest_component(product) > error * (a + b) {
        return direction(product);
    }
    // Near an edge the sign of a coordinate, or whether it is zero, is noise.
    let near = P::Scalar::of(8.0) * P::Scalar::EPSILON.sqrt();
    let mut point = at.map(|x| if x.abs() <= near { P::Scalar::ZERO } else { x });
    let sum = point[0] + point[1] + point[2];
    point = point.map(|x| x / sum);
    let mut limit: Option<P> = None;
    for (place, &x) in point.iter().enumerate() {
        if x == P::Scalar::ZERO {
            continue;
        }
        // A triangle behind the point, outside of the domain, is turned over.
        let part = moved_corner(net, degree, place, point);
        let normal = corner_limit(part.as_ref(), degree, error, place)?;
        let normal = if x < P::Scalar::ZERO { normal.scale(-P::Scalar::ONE) } else { normal };
        match limit {
            Some(other) if dot(other, normal) < P::Scalar::of(0.999_999) => return None,
            Some(_) => {}
            None => limit = Some(normal),
        }
    }
    limit
}

/// The net moved to the origin and scaled to the size 1, and a bound of the rounding errors of its differences; `None`
/// if it is a point, infinite or NaN.
fn normalized<B: TriangularBasis, P: Point<Scalar = B::Scalar, Vector = P>>(
    net: B::Bernstein<P>,
    degree: usize,
) -> Option<(B::Bernstein<P>, B::Scalar)> {
    let origin = net.as_ref()[0];
    let mut size = P::Scalar::ZERO;
    for point in net.as_ref() {
        let distance = largest_component(point.minus(origin));
        if !distance.is_finite() {
            return None;
        }
        if distance > size {
            size = distance;
        }
    }
    if size == P::Scalar::ZERO {
        return None;
    }
    let moved = B::Bernstein::from_fn(|k| {
        let moved = net.as_ref()[k].minus(origin);
        P::from_components(|i| moved.component(i) / size)
    });
    // Far from the origin the points themselves are rounded.
    let own = P::Scalar::of(16.0) * P::Scalar::from_usize(degree) * P::Scalar::EPSILON;
    Some((moved, own + P::Scalar::EPSILON * (largest_component(origin) / size)))
}

/// The coefficients N[j][k] of the product of the derivatives at a corner.
struct Product<'a, P: Point<Vector = P>> {
    net: &'a [P],
    degree: usize,
    /// A bound of the rounding errors of differences of points.
    error: P::Scalar,
    /// The corner, and the two others in their order around the triangle.
    corners: [usize; 3],
}

impl<P: Point<Vector = P>> Product<'_, P> {
    /// Where the index with these components at the two other corners stands.
    fn point(&self, j: usize, k: usize) -> P {
        let mut components = [0; 3];
        components[self.corners[0]] = self.degree - j - k;
        components[self.corners[1]] = j;
        components[self.corners[2]] = k;
        self.net[TriangleIndex::new(components).position()]
    }

    /// The coefficient N[j][k]; `None` if it is zero up to rounding errors.
    fn coefficient(&self, j: usize, k: usize) -> Option<P> {
        let n = self.degree - 1;
        let error = self.error;
        let (mut sum, mut bound) = (P::zero(), P::Scalar::ZERO);
        for p in j.saturating_sub(n)..=j.min(n) {
            for q in k.saturating_sub(n)..=k.min(n) {
                let (r, s) = (j - p, k - q);
                if p + q > n || r + s > n {
                    continue;
                }
                let factor = multinomial::<P::Scalar>(n, p, q) * multinomial::<P::Scalar>(n, r, s);
                let along_y = self.point(p + 1, q).minus(self.point(p, q));
                let along_z = self.point(r, s + 1).minus(self.point(r, s));
                sum = sum.add_scaled(cross(along_y, along_z), factor);
                bound = bound
                    + factor * error * (largest_component(along_y) + largest_component(along_z) + error);
            }
        }
        (largest_component(sum) > bound).then_some(sum)
    }
}

/// n!/(p! q! (n - p - q)!)
fn multinomial<S: Scalar>(n: usize, p: usize, q: usize) -> S {
    binomial::<S>(n, p) * binomial::<S>(n - p, q)
}

/// The limit of the normal at a corner.
fn corner_limit<P: Point<Vector = P>>(
    net: &[P],
    degree: usize,
    error: P::Scalar,
    corner: usize,
) -> Option<P> {
    let product = Product { net, degree, error, corners: [corner, (corner + 1) % 3, (corner + 2) % 3] };
    let top = 2 * (degree - 1);
    // The lowest power of z for each power of y, as far as it falls.
    let lowest = |j: usize| (0..=top - j).find(|&k| product.coefficient(j, k).is_some());
    let mut at = (0..=top).find_map(|j| Some((j, lowest(j)?)))?;
    let bottom = (0..=top).find(|&k| (0..=top - k).any(|j| product.coefficient(j, k).is_some()))?;
    let normal = direction(product.coefficient(at.0, at.1)?)?;
    while at.1 > bottom {
        // The next corner of the polygon: the steepest way down, and the farthest along it.
        let mut best: Option<(usize, usize)> = None;
        for j in at.0 + 1..=top {
            let Some(k) = lowest(j).filter(|&k| k < at.1) else { continue };
            let steeper = best.is_none_or(|(bj, bk)| (at.1 - k) * (bj - at.0) >= (at.1 - bk) * (j - at.0));
            if steeper {
                best = Some((j, k));
            }
        }
        let next = best?;
        if !same_direction(&product, normal, at, next) {
            return None;
        }
        at = next;
    }
    Some(normal)
}

/// Whether all coefficients on a side of the polygon are multiples of the normal, and the polynomial they make is
/// positive.
fn same_direction<P: Point<Vector = P>>(
    product: &Product<'_, P>,
    normal: P,
    from: (usize, usize),
    to: (usize, usize),
) -> bool {
    let (width, height) = (to.0 - from.0, from.1 - to.1);
    let points = gcd(width, height);
    let mut heights = [P::Scalar::ZERO; MAX_SIDE + 1];
    if points > MAX_SIDE {
        return false;
    }
    for (m, slot) in heights.iter_mut().enumerate().take(points + 1) {
        let Some(c) = product.coefficient(from.0 + m * width / points, from.1 - m * height / points) else {
            continue;
        };
        let across = largest_component(cross(normal, c));
        if across > P::Scalar::EPSILON.sqrt() * P::Scalar::of(16.0) * largest_component(c) {
            return false;
        }
        *slot = dot(normal, c);
    }
    let heights = &mut heights[..=points];
    if heights[0] <= P::Scalar::ZERO || heights[points] <= P::Scalar::ZERO {
        return false;
    }
    // Σ h[m] x^m, x > 0, in Bernstein form on x = r/(1 - r).
    for (m, h) in heights.iter_mut().enumerate() {
        *h = *h / multinomial::<P::Scalar>(points, m, 0);
    }
    positive(heights, 12)
}

/// The longest side of a polygon whose polynomial is looked at.
const MAX_SIDE: usize = 64;

/// Whether a polynomial with these Bernstein coefficients is positive on the unit interval; `false` where it nearly is
/// zero.
fn positive<S: Scalar>(coefficients: &mut [S], depth: usize) -> bool {
    let last = coefficients.len() - 1;
    if coefficients[0] <= S::ZERO || coefficients[last] <= S::ZERO {
        return false;
    }
    if coefficients.iter().all(|&c| c >= S::ZERO) {
        return true;
    }
    if depth == 0 {
        return false;
    }
    // De Casteljau's algorithm at 1/2; the right half stays in place.
    let mut left = [S::ZERO; MAX_SIDE + 1];
    for (k, slot) in left.iter_mut().enumerate().take(last + 1) {
        *slot = coefficients[0];
        for i in 0..last - k {
            coefficients[i] = (coefficients[i] + coefficients[i + 1]) * S::of(0.5);
        }
    }
    positive(&mut left[..=last], depth - 1) && positive(coefficients, depth - 1)
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::positive;

    #[test]
    fn positive_polynomials() {
        assert!(positive(&mut [1.0], 8));
        assert!(positive(&mut [1.0, 0.0, 1.0], 8));
        assert!(positive(&mut [1.0, -0.9, 1.0], 8));
        assert!(!positive(&mut [1.0, -1.0, 1.0], 8)); // (1 - 2x)²
        assert!(!positive(&mut [0.0, 1.0], 8));
        assert!(!positive(&mut [f64::NAN], 8));
    }
}

//! Bounds of second derivatives, from which meshes know how fine they must be.

use alloc::vec::Vec;

use super::{BSplineSurface, Direction};
use crate::vector::length;
use crate::{BoundedSurface, Point, Scalar};

/// From the control points of the second derivatives of each polynomial piece that meets the part: the derivatives are
/// convex combinations of them. Infinite if the part has a crease inside.
impl<P: Point> BoundedSurface for BSplineSurface<P> {
    fn second_derivative_bounds(&self, u: [P::Scalar; 2], v: [P::Scalar; 2]) -> [P::Scalar; 3] {
        let mut bounds = [P::Scalar::ZERO; 3];
        let (Some(rows), Some(columns)) =
            (self.smooth_spans(Direction::U, u), self.smooth_spans(Direction::V, v))
        else {
            return [P::Scalar::INFINITY; 3];
        };
        for &row in &rows {
            for &column in &columns {
                for (bound, orders) in bounds.iter_mut().zip([[2, 0], [1, 1], [0, 2]]) {
                    let largest = self.largest_derivative([row, column], orders);
                    // Written so that NaN, once met, stays.
                    if !(largest <= *bound || bound.is_nan()) {
                        *bound = largest;
                    }
                }
            }
        }
        bounds
    }
}

impl<P: Point> BSplineSurface<P> {
    /// The spans that meet a part of the domain; `None` if a tangent may jump inside of it.
    fn smooth_spans(&self, direction: Direction, [from, to]: [P::Scalar; 2]) -> Option<Vec<usize>> {
        let knots = self.knots(direction);
        let (k, all) = (knots.degree(), knots.as_slice());
        let inside = &all[all.partition_point(|&t| t <= from)..];
        let inside = &inside[..inside.partition_point(|&t| t < to)];
        let inside = inside.iter().filter(|&&t| t > knots.domain()[0] && t < knots.domain()[1]);
        let inside: Vec<_> = inside.copied().collect();
        if inside.chunk_by(|a, b| a == b).any(|group| group.len() >= k.max(1)) {
            return None;
        }
        let first = knots.span(from);
        let last = knots.span(to).max(first);
        let meets = |&span: &usize| span == first || all[span] < to;
        Some(knots.spans().filter(|span| (first..=last).contains(span)).filter(meets).collect())
    }

    /// The largest length of a control point of that partial derivative of one piece.
    fn largest_derivative(&self, spans: [usize; 2], orders: [usize; 2]) -> P::Scalar {
        let [ku, kv] = self.degrees();
        if orders[0] > ku || orders[1] > kv {
            return P::Scalar::ZERO;
        }
        let first = [spans[0] - ku, spans[1] - kv];
        let mut rows: Vec<Vec<P>> =
            (first[0]..=spans[0]).map(|i| self.net().row(i)[first[1]..=spans[1]].to_vec()).collect();
        let (u, v) = (self.knots(Direction::U).as_slice(), self.knots(Direction::V).as_slice());
        // P[i]' = k (P[i+1] - P[i]) / (t[i+k+1] - t[i+1]), the derivative's own degree falling each time.
        for order in 0..orders[0] {
            let degree = ku - order;
            for i in 0..degree {
                let index = spans[0] - degree + i;
                let factor = P::Scalar::from_usize(degree) / (u[index + degree + 1] - u[index + 1]);
                let (head, tail) = rows.split_at_mut(i + 1);
                for (a, b) in head[i].iter_mut().zip(&tail[0]) {
                    *a = b.minus(*a).scale(factor);
                }
            }
            rows.truncate(degree);
        }
        for order in 0..orders[1] {
            let degree = kv - order;
            for row in &mut rows {
                for j in 0..degree {
                    let index = spans[1] - degree + j;
                    let factor = P::Scalar::from_usize(degree) / (v[index + degree + 1] - v[index + 1]);
                    row[j] = row[j + 1].minus(row[j]).scale(factor);
                }
                row.truncate(degree);
            }
        }
        rows.iter().flatten().fold(P::Scalar::ZERO, |largest, &point| {
            let size = length(point);
            if size <= largest || largest.is_nan() { largest } else { size }
        })
    }
}

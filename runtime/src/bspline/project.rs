//! The point of a surface that is nearest to a given one.

use alloc::vec::Vec;

use super::{BSplineSurface, Direction};
use crate::vector::dot;
use crate::{Point, Scalar};

/// How many starting points are improved by Newton's method.
const STARTS: usize = 24;
/// The most steps of Newton's method; it needs five or six unless the surface is singular there.
const STEPS: usize = 60;

/// A point of a surface with its parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection<P: Point> {
    /// The parameters `[u, v]`.
    pub parameters: [P::Scalar; 2],
    /// The point of the surface.
    pub point: P,
    /// Its distance from the given point.
    pub distance: P::Scalar,
}

impl<P: Point> BSplineSurface<P> {
    /// The point of the surface that is nearest to `point`.
    ///
    /// Each polynomial piece is sampled with `2 degree + 2` parameters in each direction; the samples that are nearer than those around them are improved by
    /// Newton's method for `(S - point)·S_u = (S - point)·S_v = 0`, one piece after the other, so that creases are no
    /// obstacle. What is found is a minimum of the distance to about half of the digits of the scalar type; it is the
    /// smallest one unless a piece has several between neighbouring samples.
    ///
    /// `None` if the point, or the surface everywhere, is not finite.
    pub fn project(&self, point: P) -> Option<Projection<P>> {
        let spans = [Direction::U, Direction::V].map(|d| self.knots(d).spans().collect::<Vec<_>>());
        let samples = [self.samples(Direction::U), self.samples(Direction::V)];
        let parameters = [0, 1].map(|i| samples[i].iter().map(|(_, t)| *t).collect::<Vec<_>>());
        let grid = self.eval_grid(&parameters[0], &parameters[1]).ok()?;
        let squares = grid.map(|sample| {
            let from = sample.minus(point);
            dot(from, from).to_f64()
        });
        // Samples that are nearer than those around them.
        let mut starts: Vec<Place<P>> = Vec::with_capacity(STARTS + 1);
        for (i, &(span_u, u)) in samples[0].iter().enumerate() {
            for (j, &(span_v, v)) in samples[1].iter().enumerate() {
                let square = squares[[i, j]];
                let lowest = (i.saturating_sub(1)..=(i + 1).min(squares.rows() - 1)).all(|a| {
                    (j.saturating_sub(1)..=(j + 1).min(squares.columns() - 1))
                        .all(|b| squares[[a, b]] >= square || !squares[[a, b]].is_finite())
                });
                if square.is_finite() && lowest {
                    let rank = starts.partition_point(|other| other.square <= square);
                    starts.insert(rank, Place { square, piece: [span_u, span_v], at: [u, v] });
                    starts.truncate(STARTS);
                }
            }
        }
        let mut best: Option<Place<P>> = None;
        for start in starts {
            let mut place = self.descend(point, start);
            for _ in 0..STEPS {
                let neighbours = self.neighbours(&place, &spans);
                let moved = neighbours.into_iter().map(|start| self.descend(point, start));
                let Some(better) = moved.into_iter().find(|next| next.square < place.square) else { break };
                place = better;
            }
            if best.as_ref().is_none_or(|best| place.square < best.square) {
                best = Some(place);
            }
        }
        let Place { square, at, .. } = best?;
        let place = self.eval(at[0], at[1]);
        // Evaluated on one side of a knot or the other, the point is the same unless the surface jumps.
        let from = place.minus(point);
        let square = if from.component(0).is_finite() { dot(from, from).to_f64() } else { square };
        Some(Projection { parameters: at, point: place, distance: P::Scalar::of(Scalar::sqrt(square)) })
    }

    /// `2 degree + 2` parameters in each span, and the upper end; each with its span.
    fn samples(&self, direction: Direction) -> Vec<(usize, P::Scalar)> {
        let knots = self.knots(direction);
        let steps = 2 * knots.degree() + 2;
        let all = knots.as_slice();
        let inside = knots.spans().map(|span| (span, all[span], all[span + 1]));
        let inside = inside.flat_map(|(span, lo, hi)| {
            let part = move |i| P::Scalar::from_usize(i) / P::Scalar::from_usize(steps);
            (0..steps).map(move |i| (span, lo + (hi - lo) * part(i)))
        });
        let end = knots.domain()[1];
        inside.chain([(knots.span(end), end)]).collect()
    }

    /// The same place in the pieces on the other sides of the knots on which it is, across a corner too.
    fn neighbours(&self, place: &Place<P>, spans: &[Vec<usize>; 2]) -> Vec<Place<P>> {
        let mut choices = [Vec::new(), Vec::new()];
        for (i, direction) in [Direction::U, Direction::V].into_iter().enumerate() {
            let (span, knots) = (place.piece[i], self.knots(direction).as_slice());
            choices[i].push(span);
            let Ok(rank) = spans[i].binary_search(&span) else { continue };
            let below = (place.at[i] <= knots[span]).then(|| rank.checked_sub(1)).flatten();
            let above = (place.at[i] >= knots[span + 1]).then_some(rank + 1);
            choices[i].extend([below, above].into_iter().flatten().filter_map(|rank| spans[i].get(rank)));
        }
        let [u, v] = &choices;
        let pieces = u.iter().flat_map(|&u| v.iter().map(move |&v| [u, v])).skip(1);
        pieces.map(|piece| Place { piece, ..*place }).collect()
    }

    /// Newton's method inside of one piece, with steps halved until the distance falls; where it is not a descent, that of
    /// Gauss and Newton.
    fn descend(&self, point: P, start: Place<P>) -> Place<P> {
        let Place { mut square, piece, mut at } = start;
        let ends = [Direction::U, Direction::V].map(|direction| self.knots(direction).as_slice());
        let ends = [0, 1].map(|i| [ends[i][piece[i]].to_f64(), ends[i][piece[i] + 1].to_f64()]);
        let product = |a: P, b: P| dot(a, b).to_f64();
        for _ in 0..STEPS {
            let partial = |orders| self.partial_on(piece, at, orders);
            let from = partial([0, 0]).minus(point);
            let (along_u, along_v) = (partial([1, 0]), partial([0, 1]));
            let gradient = [product(from, along_u), product(from, along_v)];
            // Directions in which the piece ends are left out.
            let free = [0, 1].map(|i| {
                let t = at[i].to_f64();
                !(t <= ends[i][0] && gradient[i] > 0.0 || t >= ends[i][1] && gradient[i] < 0.0)
            });
            let first = [product(along_u, along_u), product(along_u, along_v), product(along_v, along_v)];
            let second = [
                first[0] + product(from, partial([2, 0])),
                first[1] + product(from, partial([1, 1])),
                first[2] + product(from, partial([0, 2])),
            ];
            let downhill = |step: &[f64; 2]| step[0] * gradient[0] + step[1] * gradient[1] < 0.0;
            let steps = [second, first].into_iter().filter_map(|matrix| newton_step(matrix, gradient, free));
            let Some(step) = steps.into_iter().find(downhill) else { break };
            let (mut factor, mut moved) = (1.0, false);
            while factor > 1e-10 && !moved {
                let next = [0, 1].map(|i| {
                    let t = at[i].to_f64() + factor * step[i];
                    P::Scalar::of(t.max(ends[i][0]).min(ends[i][1]))
                });
                let from = self.partial_on(piece, next, [0, 0]).minus(point);
                let candidate = product(from, from);
                moved = candidate < square && next != at;
                if moved {
                    (at, square) = (next, candidate);
                }
                factor *= 0.5;
            }
            if !moved {
                break;
            }
        }
        Place { square, piece, at }
    }
}

/// A point of the surface on the way to the nearest one.
#[derive(Clone, Copy)]
struct Place<P: Point> {
    /// The square of its distance.
    square: f64,
    /// The spans of the piece it belongs to.
    piece: [usize; 2],
    at: [P::Scalar; 2],
}

/// `-M⁻¹ gradient` in the free directions, for the symmetric matrix `[[a, b], [b, c]]` if it is positive definite there.
fn newton_step([a, b, c]: [f64; 3], gradient: [f64; 2], free: [bool; 2]) -> Option<[f64; 2]> {
    match free {
        [true, true] => {
            let determinant = a * c - b * b;
            (a > 0.0 && determinant > 1e-14 * a * c).then(|| {
                let [x, y] = gradient;
                [(b * y - c * x) / determinant, (b * x - a * y) / determinant]
            })
        }
        [true, false] => (a > 0.0).then(|| [-gradient[0] / a, 0.0]),
        [false, true] => (c > 0.0).then(|| [0.0, -gradient[1] / c]),
        [false, false] => None,
    }
}

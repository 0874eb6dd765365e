//! Stretches of a parallel curve put together: joins at corners, caps at ends.

use alloc::vec::Vec;

use super::super::{Path, PathSegment};
use super::parallel::{Part, Place, Stretch, V, dot, left, length, plus, unit, wedge};
use super::{LineCap, LineJoin};
use crate::{ParametricCurve, Scalar};

/// How the sides of an inner corner are connected.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Inner {
    /// By a straight line.
    Straight,
    /// By way of the corner, so that the outline of a stroke covers the same points as the stroke.
    ByCorner,
}

/// What the joins need to know.
#[derive(Clone, Copy)]
pub(super) struct Joins {
    pub(super) distance: f64,
    pub(super) join: LineJoin<f64>,
    pub(super) inner: Inner,
    /// Ends that are as near are the same.
    pub(super) noise: f64,
}

impl Joins {
    /// All stretches, one after the other, with joins between them and, of a closed curve, from the last to the first.
    pub(super) fn outline(&self, stretches: Vec<Stretch>, closed: bool) -> Vec<Part> {
        let mut parts: Vec<Part> = Vec::new();
        let first = stretches.first().map(|stretch| stretch.ends[0]);
        let mut before: Option<Place> = None;
        for stretch in stretches {
            if let Some(before) = before {
                self.join(&mut parts, before, stretch.ends[0]);
            }
            before = Some(stretch.ends[1]);
            parts.extend(stretch.parts);
        }
        if let (true, Some(before), Some(first)) = (closed, before, first) {
            self.join(&mut parts, before, first);
        }
        connect(&mut parts, closed);
        parts
    }

    fn join(&self, parts: &mut Vec<Part>, before: Place, after: Place) {
        let d = self.distance;
        let (base, u, v) = (after.base, before.tangent, after.tangent);
        let [from, to] = [(before.base, u), (base, v)].map(|(base, t)| plus(base, left(t), d));
        if length(plus(to, from, -1.0)) <= self.noise {
            return;
        }
        let (sine, cosine) = (wedge(u, v), dot(u, v));
        let mut push = |segment: PathSegment<V>, reversed: bool, least: f64| {
            parts.push(Part { segment, reversed, least });
        };
        let turned_back = cosine < 0.0 && sine.abs() <= 1e-9;
        if d * sine > 0.0 && !turned_back {
            if self.inner == Inner::ByCorner {
                push(PathSegment::line(from, base), true, 0.0);
                push(PathSegment::line(base, to), true, 0.0);
            } else {
                push(PathSegment::line(from, to), true, 0.0);
            }
            return;
        }
        // The cosine of half of the turn.
        let half = Scalar::sqrt(((1.0 + cosine) * 0.5).max(0.0));
        match self.join {
            LineJoin::Round => {
                let angle = Scalar::atan2(sine.abs(), cosine);
                for segment in arc(base, plus([0.0; 2], left(u), d), -angle * sign(d)) {
                    push(segment, false, d.abs());
                }
            }
            LineJoin::Miter { limit } if half * limit >= 1.0 => {
                let middle = plus(left(u), left(v), 1.0);
                let corner = plus(base, middle, d / (1.0 + cosine));
                push(PathSegment::line(from, corner), false, d.abs());
                push(PathSegment::line(corner, to), false, d.abs());
            }
            _ => push(PathSegment::line(from, to), false, d.abs() * half),
        }
    }

    /// The cap behind an end of a stroke, from its left side to its right one; `distance` is half of the width.
    pub(super) fn cap(&self, end: Place, cap: LineCap) -> Vec<Part> {
        let h = self.distance.abs();
        let [from, to] = [h, -h].map(|h| plus(end.base, left(end.tangent), h));
        let segments = match cap {
            LineCap::Butt => alloc::vec![PathSegment::line(from, to)],
            LineCap::Round => arc(end.base, plus([0.0; 2], left(end.tangent), h), -core::f64::consts::PI),
            LineCap::Square => {
                let [a, b] = [from, to].map(|p| plus(p, end.tangent, h));
                [[from, a], [a, b], [b, to]].map(|[p, q]| PathSegment::line(p, q)).to_vec()
            }
        };
        segments.into_iter().map(|segment| Part { segment, reversed: false, least: 0.0 }).collect()
    }

    /// The parts in the other direction.
    pub(super) fn reversed(parts: Vec<Part>) -> Vec<Part> {
        let turned = |part: Part| Part { segment: part.segment.reversed(), ..part };
        parts.into_iter().rev().map(turned).collect()
    }
}

/// Makes each part begin exactly where the one before it ends.
pub(super) fn connect(parts: &mut [Part], closed: bool) {
    for k in 1..parts.len() {
        let end = parts[k - 1].segment.end();
        parts[k].segment = parts[k].segment.started(end);
    }
    if closed && let [first, .., last] = parts {
        last.segment = last.segment.reversed().started(first.segment.start()).reversed();
    }
}

fn sign(x: f64) -> f64 {
    if x < 0.0 { -1.0 } else { 1.0 }
}

/// The arc around a centre from that vector, by that angle.
fn arc(centre: V, radius: V, turn: f64) -> Vec<PathSegment<V>> {
    match unit(radius) {
        Some(_) => Path::ellipse_arc(centre, [radius, left(radius)], 0.0, turn).segments().to_vec(),
        None => Vec::new(),
    }
}

/// The circle of that radius around a point.
pub(super) fn circle(centre: V, radius: f64) -> Vec<crate::CurvePiece> {
    Path::circle(centre, radius).pieces()
}

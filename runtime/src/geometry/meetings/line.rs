//! Where a polynomial piece in the plane crosses a straight one: the zeros of one polynomial, its height above the
//! line.
//!
//! The heights of the control points are the Bernstein coefficients of that polynomial `h`. Parts whose heights are
//! all on one side, or that lie before or behind the straight piece, are put aside. Where all differences of the
//! heights have one sign `h` is monotone, so a part whose ends are on both sides meets the line at one place. Other
//! parts are divided. Nothing is allocated. Whatever is not clear by more than the accuracy, contacts, overlaps and
//! ends on the line, is left to the search for curves of any form.

use super::clipping::{Net, View, net, range, restrict, value_and_slope};
use crate::CurvePiece;
use crate::Scalar;

/// The most parts that are looked at, and the number of those that can be open at a time.
const WORK: usize = 40;
const DEPTH: usize = 12;

/// Where parts are divided: not in the middle, where symmetric curves meet lines.
const DIVISION: f64 = 0.515_625;

/// A bound of the rounding errors of heights, of which the components are at most 2.
const NOISE: f64 = 512.0 * f64::EPSILON;

/// A crossing is flatter than this if it may be a contact: the slope of the height.
const FLAT: f64 = 1e-5;

/// The places of both pieces at which they cross; there are no more than the degree.
#[derive(Default)]
pub(super) struct Crossings {
    at: [[f64; 2]; 8],
    len: usize,
}

impl Crossings {
    #[inline]
    pub(super) fn as_slice(&self) -> &[[f64; 2]] {
        &self.at[..self.len]
    }
}

/// All places, between 0 and 1, at which a piece and a straight one come nearer to each other than the accuracy, if
/// all of them are crossings; `None` if that is not certain. Both pieces are ones that clipping suits.
#[inline]
pub(super) fn crossings(
    curve: &CurvePiece,
    line: &CurvePiece,
    view: View<'_>,
    accuracy: f64,
) -> Option<Crossings> {
    if line.degree() != 1 || curve.dimension() != 2 {
        return None;
    }
    if curve.degree() < 4 {
        run::<4>(curve, line, view, accuracy)
    } else {
        run::<8>(curve, line, view, accuracy)
    }
}

/// A part of the curve, the heights and the places along the line of its control points.
#[derive(Clone, Copy)]
struct Part<const N: usize> {
    range: [f64; 2],
    rows: Net<N, 2>,
}

#[inline]
fn run<const N: usize>(
    curve: &CurvePiece,
    line: &CurvePiece,
    view: View<'_>,
    accuracy: f64,
) -> Option<Crossings> {
    let ends = [0, 1].map(|i| [0, 1].map(|d| (line.control(i, d) - view.origin(d)) / view.unit));
    let mut direction = [ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]];
    let length = Scalar::sqrt(direction[0] * direction[0] + direction[1] * direction[1]);
    if length.is_nan() || length < 1e-3 {
        return None;
    }
    direction = direction.map(|c| c / length);
    let mut whole = net::<N, 2>(curve, view);
    let [first, second] = &mut whole;
    for (height, along) in first.iter_mut().zip(second) {
        let [x, y] = [*height - ends[0][0], *along - ends[0][1]];
        *height = direction[0] * y - direction[1] * x;
        *along = direction[0] * x + direction[1] * y;
    }
    let apart = accuracy + 2.0 * NOISE;
    let mut found = Crossings::default();
    let mut part = Part { range: [0.0, 1.0], rows: whole };
    let mut open = [part; DEPTH];
    let mut count = 0;
    for _ in 0..WORK {
        if !is_aside(&part, length, apart) && !take(&part, &whole, length, apart, &mut found) {
            if count == DEPTH {
                return None;
            }
            let [before, after] = divided(&part);
            open[count] = after;
            count += 1;
            part = before;
            continue;
        }
        if count == 0 {
            return Some(found);
        }
        count -= 1;
        part = open[count];
    }
    None
}

/// Whether a part is farther from the straight piece than a distance.
#[inline]
fn is_aside<const N: usize>(part: &Part<N>, length: f64, apart: f64) -> bool {
    let ([low, high], [from, to]) = (range(&part.rows[0]), range(&part.rows[1]));
    low > apart || high < -apart || from > length + apart || to < -apart
}

/// Adds the only place at which a part meets the line, unless that is not on the straight piece; `false` if there may
/// be more than one, or it is not clear.
#[inline]
fn take<const N: usize>(
    part: &Part<N>,
    whole: &Net<N, 2>,
    length: f64,
    apart: f64,
    found: &mut Crossings,
) -> bool {
    let [heights, along] = &part.rows;
    let sign = if heights[N - 1] > heights[0] { 1.0 } else { -1.0 };
    if !(sign * heights[0] < -apart && sign * heights[N - 1] > apart) {
        return false;
    }
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for i in 1..N {
        least = least.min(sign * (heights[i] - heights[i - 1]));
        most = most.max((along[i] - along[i - 1]).abs());
    }
    // Both derivatives by the parameter of the whole.
    let [lo, hi] = part.range;
    let scale = (N - 1) as f64 / (hi - lo);
    if least.is_nan() || least <= 4.0 * NOISE || scale * least < FLAT {
        return false;
    }
    let x = zero(&whole[0], part.range, heights[0] / (heights[0] - heights[N - 1]), sign);
    // What is nearer to the line than the distance is nearer than this to the place along it.
    let room = apart * (1.0 + (most + 4.0 * NOISE) / (least - 2.0 * NOISE));
    let place = value_and_slope(&whole[1], x)[0];
    if place < -room || place > length + room {
        return true;
    }
    if !(place > room && place < length - room) || found.len == found.at.len() {
        return false;
    }
    found.at[found.len] = [x, place / length];
    found.len += 1;
    true
}

/// The zero of a function that is monotone in an interval and has different signs at its ends, from a place between
/// them: Newton's method, and a bisection wherever that leaves what is known.
#[inline]
fn zero<const N: usize>(heights: &[f64; N], [mut lo, mut hi]: [f64; 2], share: f64, sign: f64) -> f64 {
    let mut x = lo + share * (hi - lo);
    for _ in 0..64 {
        let [value, slope] = value_and_slope(heights, x);
        if sign * value < 0.0 {
            lo = x;
        } else {
            hi = x;
        }
        let step = value / slope;
        let next = x - step;
        if next >= lo && next <= hi {
            x = next;
            // What is left is of the order of its square.
            if step.abs() < 5e-9 {
                break;
            }
        } else {
            // Newton's step from a zero leads nowhere but by rounding errors.
            if step.abs() < 4.0 * f64::EPSILON {
                break;
            }
            x = 0.5 * (lo + hi);
        }
    }
    x
}

#[inline]
fn divided<const N: usize>(part: &Part<N>) -> [Part<N>; 2] {
    let [lo, hi] = part.range;
    let middle = lo + DIVISION * (hi - lo);
    let (mut before, mut after) = (*part, *part);
    (before.range[1], after.range[0]) = (middle, middle);
    restrict(&mut before.rows, [0.0, DIVISION]);
    restrict(&mut after.rows, [DIVISION, 1.0]);
    [before, after]
}

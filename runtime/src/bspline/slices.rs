//! Splines at many parameters, in vector instructions.
//!
//! Where many parameters after each other lie in one span, its polynomial is evaluated in the form of
//! [`EndpointForm`](crate::EndpointForm), which is made from its Bézier points. The lines of a grid are mixed from the
//! curves over the rows of the net, which are evaluated once for all lines that need them.

// Compiled once for each set of vector instructions, inside of the functions that name them.
#![allow(clippy::inline_always)]

use alloc::vec::Vec;

use super::KnotVector;
use super::functions::combine;
use super::net::Net;
use crate::form::{EndpointPoints, MOST_COMPONENTS, endpoint_coefficients, horner};
use crate::numeric::simd::{Kernel, dispatch};
use crate::vector::lerp;
use crate::{Point, Scalar};

/// The number of parameters in one span from which on its Bézier points cost less than they save.
const WORTHWHILE: usize = 16;

/// The number of parameters that are mapped to the unit interval together.
const TILE: usize = 128;

/// Runs a function with the number of functions over one span as a constant, for the degrees that occur, or another one.
macro_rules! with_order {
    ($degree:expr, $function:ident($($argument:expr),*), $otherwise:expr) => {
        match $degree {
            1 => $function::<_, 2>($($argument),*),
            2 => $function::<_, 3>($($argument),*),
            3 => $function::<_, 4>($($argument),*),
            4 => $function::<_, 5>($($argument),*),
            5 => $function::<_, 6>($($argument),*),
            6 => $function::<_, 7>($($argument),*),
            _ => $otherwise,
        }
    };
}

/// `out[i] = Σ_j N[j](ts[i]) points[j]`; what has no partner in the other slice is left alone.
pub(super) fn eval<P: Point>(knots: &KnotVector<P::Scalar>, points: &[P], ts: &[P::Scalar], out: &mut [P]) {
    with_order!(
        knots.degree(),
        in_runs(knots, points, ts, out),
        for (&t, out) in ts.iter().zip(out) {
            let span = knots.span(t);
            *out = combine(&knots.values_on(span, t), &points[span - knots.degree()..=span]);
        }
    );
}

/// How many of these parameters, the first of which is in that span, are there one after the other; 1 for one outside of
/// the domain.
#[inline]
fn run<S: Scalar>(knots: &KnotVector<S>, span: usize, ts: &[S]) -> usize {
    let [lo, hi] = [0, 1].map(|k| knots.as_slice()[span + k]);
    let is_last = hi == knots.domain()[1];
    ts.iter().take_while(|&&t| t >= lo && (t < hi || t == hi && is_last)).count().max(1)
}

fn in_runs<P: Point, const N: usize>(
    knots: &KnotVector<P::Scalar>,
    points: &[P],
    ts: &[P::Scalar],
    out: &mut [P],
) {
    let (mut ts, mut out) = (&ts[..ts.len().min(out.len())], out);
    let mut xs = [P::Scalar::ZERO; TILE];
    while let Some(&first) = ts.first() {
        let span = knots.span(first);
        let (inside, later) = ts.split_at(run(knots, span, ts));
        let (points_inside, points_later) = out.split_at_mut(inside.len());
        if inside.len() < WORTHWHILE {
            for (&t, out) in inside.iter().zip(points_inside) {
                *out = combine(&knots.values_of::<N>(span, t), &points[span + 1 - N..=span]);
            }
        } else {
            let piece = Piece::<P, N>::new(knots, points, span);
            for (inside, out) in inside.chunks(TILE).zip(points_inside.chunks_mut(TILE)) {
                let xs = &mut xs[..inside.len()];
                for (x, &t) in xs.iter_mut().zip(inside) {
                    *x = place(knots, span, t);
                }
                piece.eval(xs, out);
            }
        }
        (ts, out) = (later, points_later);
    }
}

/// A parameter as a number between 0 and 1 of a span.
#[inline]
fn place<S: Scalar>(knots: &KnotVector<S>, span: usize, t: S) -> S {
    let [lo, hi] = [0, 1].map(|k| knots.as_slice()[span + k]);
    (t - lo) / (hi - lo)
}

/// The polynomial over one span, in the form of which many points are evaluated.
struct Piece<P, const N: usize> {
    ends: [P; 2],
    inner: [P; N],
}

impl<P: Point, const N: usize> Piece<P, N> {
    fn new(knots: &KnotVector<P::Scalar>, points: &[P], span: usize) -> Self {
        let (ends, inner) = endpoint_coefficients(&bezier::<P, N>(knots, points, span));
        Self { ends, inner }
    }

    fn eval(&self, xs: &[P::Scalar], out: &mut [P]) {
        let Self { ends, inner } = *self;
        if P::DIM > MOST_COMPONENTS {
            dispatch(xs.len(), EndpointPoints::<P, _, 2> { ends, inner, xs, out });
        } else {
            dispatch(xs.len(), PiecePoints { ends, inner, xs, out });
        }
    }
}

/// What [`EndpointPoints`] computes, with all arithmetic before a point is made: that of a point within a point, as
/// [`Homogeneous`](super::Homogeneous) ones are, would not be compiled for the instructions.
struct PiecePoints<'a, P: Point, const N: usize> {
    ends: [P; 2],
    inner: [P; N],
    xs: &'a [P::Scalar],
    out: &'a mut [P],
}

impl<P: Point, const N: usize> Kernel for PiecePoints<'_, P, N> {
    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        let Self { ends: [start, end], inner, xs, out } = self;
        let inner = inner.get(2..).unwrap_or_default();
        for (point, &x) in out.iter_mut().zip(xs) {
            let s = P::Scalar::ONE - x;
            let (y, w) = (x - s, s * x);
            let mut sums = [x; MOST_COMPONENTS];
            for (d, sum) in sums.iter_mut().enumerate().take(P::DIM) {
                *sum = end.component(d).fma::<FUSED>(x, start.component(d) * s);
                if let Some((last, rest)) = inner.split_last() {
                    *sum = horner::<FUSED, P>(*last, rest, y, d).fma::<FUSED>(w, *sum);
                }
            }
            *point = P::from_components(
                #[inline(always)]
                |d| sums[d],
            );
        }
    }
}

/// The Bézier points of the polynomial over a span `[lo, hi]`: with its blossom `f` and the knots `a[1], …, a[2k]` around the
/// span the control points are `f(a[i+1], …, a[i+k])`, which become `f(a[i+1], …, a[k], hi, …, hi)` and then
/// `f(lo, …, lo, hi, …, hi)`.
fn bezier<P: Point, const N: usize>(knots: &KnotVector<P::Scalar>, points: &[P], span: usize) -> [P; N] {
    let k = N - 1;
    let a = |j: usize| knots.as_slice()[span + j - k];
    let (lo, hi) = (a(k), a(k + 1));
    let mut c: [P; N] = core::array::from_fn(|i| points[span - k + i]);
    for r in 1..=k {
        for i in (r..=k).rev() {
            let (from, to) = (a(i), a(i + k - r + 1));
            c[i] = lerp(c[i - 1], c[i], (hi - from) / (to - from));
        }
    }
    for r in 1..=k {
        for i in 0..=k - r {
            let from = a(i + r);
            c[i] = lerp(c[i], c[i + 1], (lo - from) / (hi - from));
        }
    }
    c
}

/// What the points of all lines of a grid have in common: the functions at the parameters along them.
struct Columns<'a, S> {
    knots: &'a KnotVector<S>,
    count: usize,
    /// The spans with the numbers of parameters in them, one after the other.
    runs: Vec<(usize, usize)>,
    /// For each parameter of a long run its place in the span, for each of a short one the values of all functions.
    numbers: Vec<S>,
}

impl<'a, S: Scalar> Columns<'a, S> {
    fn new(knots: &'a KnotVector<S>, ts: &[S]) -> Self {
        let is_low = (1..=6).contains(&knots.degree());
        let (mut runs, mut numbers) = (Vec::new(), Vec::new());
        let mut rest = ts;
        while let Some(&first) = rest.first() {
            let span = knots.span(first);
            let (inside, later) = rest.split_at(run(knots, span, rest));
            if is_low && inside.len() >= WORTHWHILE {
                numbers.extend(inside.iter().map(|&t| place(knots, span, t)));
            } else {
                for &t in inside {
                    numbers.extend_from_slice(&knots.values_on(span, t));
                }
            }
            runs.push((span, inside.len()));
            rest = later;
        }
        Self { knots, count: ts.len(), runs, numbers }
    }

    /// The points of the curve over these control points.
    fn eval<P: Point<Scalar = S>>(&self, points: &[P], out: &mut [P]) {
        with_order!(self.knots.degree(), columns(self, points, out), {
            let order = self.knots.degree() + 1;
            let spans = self.runs.iter().flat_map(|&(span, count)| core::iter::repeat_n(span, count));
            for ((out, values), span) in out.iter_mut().zip(self.numbers.chunks_exact(order)).zip(spans) {
                *out = combine(values, &points[span + 1 - order..=span]);
            }
        });
    }
}

fn columns<P: Point, const N: usize>(columns: &Columns<'_, P::Scalar>, points: &[P], mut out: &mut [P]) {
    let mut numbers = &columns.numbers[..];
    for &(span, count) in &columns.runs {
        let is_long = count >= WORTHWHILE;
        let (here, later) = numbers.split_at(if is_long { count } else { count * N });
        let (inside, out_later) = out.split_at_mut(count.min(out.len()));
        if is_long {
            Piece::<P, N>::new(columns.knots, points, span).eval(here, inside);
        } else {
            for (out, values) in inside.iter_mut().zip(here.chunks_exact(N)) {
                *out = combine(values, &points[span + 1 - N..=span]);
            }
        }
        (numbers, out) = (later, out_later);
    }
}

/// The lines of a grid of a surface, one after the other.
pub(super) struct Lines<'a, P: Point> {
    knots: &'a KnotVector<P::Scalar>,
    net: &'a Net<P>,
    columns: Columns<'a, P::Scalar>,
    /// The points of the curves over as many rows of the net as a line needs; row `i` is the one of number `i` modulo their
    /// number. Empty if they would be used too rarely.
    kept: Vec<P>,
    /// Which row each of them is.
    rows: Vec<Option<usize>>,
    /// The control points of one line.
    line: Vec<P>,
}

impl<'a, P: Point> Lines<'a, P> {
    pub(super) fn new(
        [u, v]: [&'a KnotVector<P::Scalar>; 2],
        net: &'a Net<P>,
        us: &[P::Scalar],
        vs: &[P::Scalar],
    ) -> Self {
        let is_low = (1..=6).contains(&u.degree()) && P::DIM <= MOST_COMPONENTS;
        let is_dense = is_low && us.len() >= 2 * net.rows() && us.is_sorted();
        let count = if is_dense { u.degree() + 1 } else { 0 };
        Self {
            knots: u,
            net,
            columns: Columns::new(v, vs),
            kept: alloc::vec![P::zero(); count * vs.len()],
            rows: alloc::vec![None; count],
            line: alloc::vec![P::zero(); net.columns()],
        }
    }

    /// The points `out[j] = S(u, vs[j])`.
    pub(super) fn eval(&mut self, u: P::Scalar, out: &mut [P]) {
        let Self { knots, net, columns, kept, rows, line } = self;
        let span = knots.span(u);
        let first = span - knots.degree();
        let factors = knots.values_on(span, u);
        if rows.is_empty() {
            line.fill(P::zero());
            for (i, &factor) in factors.iter().enumerate() {
                for (sum, &point) in line.iter_mut().zip(net.row(first + i)) {
                    *sum = sum.add_weighted(point, factor);
                }
            }
            return columns.eval(line, out);
        }
        for row in first..=span {
            let place = row % rows.len();
            if rows[place] != Some(row) {
                rows[place] = Some(row);
                let width = columns.count;
                columns.eval(net.row(row), &mut kept[place * width..][..width]);
            }
        }
        with_order!(knots.degree(), mix(kept, first, &factors, out), ());
    }
}

/// The sums of kept rows, from that of number `first` on, times the factors.
fn mix<P: Point, const N: usize>(kept: &[P], first: usize, factors: &[P::Scalar], out: &mut [P]) {
    let width = kept.len() / N;
    let rows: [&[P]; N] = core::array::from_fn(|i| &kept[(first + i) % N * width..][..width]);
    let factors: [P::Scalar; N] = core::array::from_fn(|i| factors[i]);
    dispatch(out.len(), Mix { rows, factors, out });
}

/// `out[j] = Σ_i factors[i] rows[i][j]`.
struct Mix<'a, P: Point, const N: usize> {
    rows: [&'a [P]; N],
    factors: [P::Scalar; N],
    out: &'a mut [P],
}

impl<P: Point, const N: usize> Kernel for Mix<'_, P, N> {
    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        let Self { rows, factors, out } = self;
        let len = rows.iter().fold(out.len(), |len, row| len.min(row.len()));
        let rows = rows.map(|row| &row[..len]);
        for (j, out) in out[..len].iter_mut().enumerate() {
            let mut sums = [factors[0]; MOST_COMPONENTS];
            for (d, sum) in sums.iter_mut().enumerate().take(P::DIM) {
                *sum = *sum * rows[0][j].component(d);
                for i in 1..N {
                    *sum = rows[i][j].component(d).fma::<FUSED>(factors[i], *sum);
                }
            }
            *out = P::from_components(
                #[inline(always)]
                |d| sums[d],
            );
        }
    }
}

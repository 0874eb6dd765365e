//! The functions of which a fitted curve is a sum, in double precision.

use alloc::vec::Vec;

use crate::bspline::KnotVector;
use crate::{Basis, RationalBasis, Scalar, SpannedBasis};

/// Functions `b[0], …, b[count - 1]` of one variable.
pub(super) trait Functions {
    /// Their number.
    fn count(&self) -> usize;

    /// How many neighbours at most are not zero at a parameter.
    fn width(&self) -> usize;

    /// The ends of the spans on which all are analytic, at least two, in increasing order.
    fn breakpoints(&self) -> Vec<f64>;

    /// The number of Gauss nodes on a span for the integrals of products of second derivatives: exact for polynomials.
    fn nodes(&self) -> usize;

    /// The first function that may not be zero at `t`, and the derivatives of that order of it and those after it.
    fn row(&self, t: f64, order: usize) -> (usize, Vec<f64>);
}

impl Functions for KnotVector<f64> {
    fn count(&self) -> usize {
        self.functions()
    }

    fn width(&self) -> usize {
        self.degree() + 1
    }

    fn breakpoints(&self) -> Vec<f64> {
        self.breakpoints()
    }

    fn nodes(&self) -> usize {
        self.degree().saturating_sub(1)
    }

    fn row(&self, t: f64, order: usize) -> (usize, Vec<f64>) {
        self.derivatives(self.clamp(t), order).unwrap_or((0, Vec::new()))
    }
}

/// A family on an interval.
pub(super) struct Polynomial<B>(pub(super) B);

/// A family with denominators, angles or exponentials.
pub(super) struct Rational<B>(pub(super) B);

/// A family on several spans.
pub(super) struct Spanned<B>(pub(super) B);

/// Nodes on a span of a family that is not polynomial: its second derivatives are analytic, and the error of the rule falls
/// geometrically.
fn nodes_beyond_polynomials(degree: usize) -> usize {
    8 + 2 * degree
}

macro_rules! families {
    ($($wrapper:ident: $basis:ident, $breakpoints:expr, $nodes:expr;)+) => {$(
        impl<B: $basis> Functions for $wrapper<B> {
            fn count(&self) -> usize {
                B::LEN
            }

            fn width(&self) -> usize {
                B::LEN
            }

            fn breakpoints(&self) -> Vec<f64> {
                let breakpoints: fn(&B) -> Vec<B::Scalar> = $breakpoints;
                breakpoints(&self.0).into_iter().map(Scalar::to_f64).collect()
            }

            fn nodes(&self) -> usize {
                $nodes
            }

            fn row(&self, t: f64, order: usize) -> (usize, Vec<f64>) {
                let t = B::Scalar::of(t);
                let values = if order == 0 { self.0.values(t) } else { self.0.derivatives(t, order) };
                (0, values.as_ref().iter().map(|value| value.to_f64()).collect())
            }
        }
    )+};
}
families! {
    Polynomial: Basis, |_| B::domain().to_vec(), B::DEGREE.saturating_sub(1);
    Rational: RationalBasis, |basis| basis.domain().to_vec(), nodes_beyond_polynomials(B::DEGREE);
    Spanned: SpannedBasis, |basis| {
        let charts = basis.charts();
        let ends = charts.as_ref().iter().map(|chart| chart.domain()[1]);
        core::iter::once(basis.domain()[0]).chain(ends).collect()
    }, nodes_beyond_polynomials(B::DEGREE);
}

/// The ends of the domain of functions.
pub(super) fn ends_of_domain(functions: &dyn Functions) -> [f64; 2] {
    let breakpoints = functions.breakpoints();
    [breakpoints[0], breakpoints[breakpoints.len() - 1]]
}

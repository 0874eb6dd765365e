//! Polynomials in place of functions in which the domain variable stands beside its sine or exponential, such as t − sin t.

mod parameter;
mod points;
#[cfg(any(test, feature = "rounding"))]
mod residual;
mod truncation;
mod waves;

use std::rc::Rc;

use crate::algebra::poly::Poly;
use crate::model::{Family, Truncations};

/// The shape parameter whose range is too long for [`in_polynomials`] on some span, or has no end, and a range that is not.
pub(crate) fn longest(family: &Family) -> Option<(String, String)> {
    if family.pieces.is_empty() {
        return parameter::longest(family);
    }
    family.pieces.iter().find_map(|piece| longest(piece))
}

/// A family whose functions are polynomials on each of its spans, as near as floats can tell to those of a family in which
/// the variable stands beside its sine or exponential; `None` where no way to these is known.
pub(crate) fn in_polynomials(family: &Family, truncations: Truncations) -> Option<Family> {
    let on_span = |span: &Family| {
        points::in_polynomials(span, truncations)
            .or_else(|| Some(vec![Rc::new(parameter::in_polynomials(span, truncations)?)]))
    };
    let pieces = if family.pieces.is_empty() {
        on_span(family)?
    } else {
        let all = family.pieces.iter().map(|piece| on_span(piece)).collect::<Option<Vec<_>>>()?;
        all.concat()
    };
    let first = (*pieces[0]).clone();
    let mut domain = family.domain.clone();
    domain[0].range = first.domain[0].range.clone();
    let (functions, analytic) = (first.functions, first.analytic);
    Some(Family { domain, analytic, functions, over: Poly::one(), pieces, ..family.clone() })
}

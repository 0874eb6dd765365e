//! Statements from text, so that tests read like mathematics: variables x0, x1, …, simplices as `x0 + x1 + rest = 1`.

use std::rc::Rc;

use basis_kernel::algebra::poly::Poly;
use basis_kernel::algebra::range::Region;
use basis_kernel::algebra::rational::Rational;
use basis_kernel::{Domain, Quotient, Relation, Simplex, Statement};
use basis_test_support::Names;

/// The variables of all statements.
const NAMES: Names = Names(&["x0", "x1", "x2", "x3", "x4", "x5", "x6", "x7"]);

pub(crate) fn poly(text: &str) -> Poly {
    NAMES.poly(text)
}

pub(crate) fn region(text: &str) -> Region {
    NAMES.region(text)
}

/// A domain: ranges, and simplices such as `simplex x0 x1`.
pub(crate) fn domain(text: &str) -> Domain {
    let (simplices, ranges): (Vec<&str>, Vec<&str>) =
        text.split(',').map(str::trim).partition(|s| s.starts_with("simplex"));
    let simplices = simplices.into_iter().map(|s| {
        let variables = s.split_whitespace().skip(1).map(|v| NAMES.var(v));
        Simplex { variables: variables.collect(), sum: Rational::ONE }
    });
    Domain { region: region(&ranges.join(",")), simplices: simplices.collect(), premises: Vec::new() }
}

/// A claim such as `x0^2/(1 + x0) >= 0` on a domain.
pub(crate) fn sign(claim: &str, on: &str) -> Rc<Statement> {
    let (text, relation) = match claim.split_once(">=") {
        Some((text, _)) => (text, Relation::NonNegative),
        None => (claim.split_once('>').expect("a relation").0, Relation::Positive),
    };
    let (above, below) = text.split_once("//").unwrap_or((text, "1"));
    let value = Quotient { numerator: poly(above), denominator: poly(below) };
    Rc::new(Statement::Sign { value, relation, domain: Rc::new(domain(on)) })
}

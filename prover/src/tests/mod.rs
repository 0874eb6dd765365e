//! What must be decided, and how.

mod examples;
mod hard;
#[cfg(feature = "ranges")]
mod independence;
pub(crate) mod letters;
mod random;
mod text;

use std::rc::Rc;

use basis_kernel::{Certificate, Domain, Proof, Quotient, Relation, Statement};

use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::counterexample::{Counterexample, refute};
use crate::decide::{Failure, Shown, decide};
use crate::sign::{Found, search};
use crate::{Budget, Coordinate, Method};
use text::{NAMES, poly, region};

/// The statement p ≥ 0 or p > 0.
fn statement(p: &Poly, relation: Relation, region: &Region) -> Rc<Statement> {
    let domain = Rc::new(Domain::of(region.clone()));
    Rc::new(Statement::Sign { value: Quotient::from(p.clone()), relation, domain })
}

/// What a search finds, as the kernel accepts it: the method of a proof, or a counterexample.
fn accepted(
    p: &Poly,
    relation: Relation,
    region: &Region,
    budget: &mut Budget,
) -> Result<Method, Option<Box<Counterexample>>> {
    let statement = statement(p, relation, region);
    match search(p, relation, region, budget) {
        Found::Proof(method, numerator) => {
            let certificate = Certificate::Sign { denominator: None, numerator };
            let text = basis_kernel::text::certificate_text(&certificate);
            assert_eq!(basis_kernel::text::certificate(&text).as_ref(), Ok(&certificate));
            let proof = Proof::new(statement, certificate, &mut Work::usual(1));
            assert!(proof.is_ok(), "{p:?} {region:?} {text}: {:?}", proof.err());
            Ok(method)
        }
        Found::Point(mut point) => {
            let vars = p.variables();
            point.retain(|(v, _)| vars.contains(v) || region.ranges.iter().any(|(w, _)| w == v));
            let found = refute(&statement, &point, &mut Work::unlimited());
            Err(Some(Box::new(found.unwrap_or_else(|| panic!("{p:?} {region:?} {point:?} is refused")))))
        }
        Found::Nothing(_) => Err(None),
    }
}

/// The verdict in short: `proved: method`, `refuted: t = 1/2, λ = 0: value`, `undecided`.
fn verdict(p: &Poly, relation: Relation, region: &Region) -> String {
    match accepted(p, relation, region, &mut Budget::default()) {
        Ok(method) => format!("proved: {method}"),
        Err(Some(found)) => {
            let mut vars = p.variables();
            vars.extend(region.ranges.iter().map(|(v, _)| *v));
            vars.sort();
            vars.dedup();
            assert_eq!(found.point.iter().map(|(v, _)| *v).collect::<Vec<_>>(), vars);
            let point: Vec<String> = found.point.iter().map(|(v, c)| c.describe(NAMES[v.0])).collect();
            let value = found.refutation.value().expect("a rational value");
            format!("refuted: {}: {value}", point.join(", "))
        }
        Err(None) => String::from("undecided"),
    }
}

/// p ≥ 0 or p > 0, written as `p >= 0`.
fn claim(text: &str, ranges: &str) -> String {
    let (p, relation) = match text.split_once(">=") {
        Some((p, q)) => (format!("{p} - ({q})"), Relation::NonNegative),
        None => {
            let (p, q) = text.split_once('>').expect("a relation");
            (format!("{p} - ({q})"), Relation::Positive)
        }
    };
    verdict(&poly(&p), relation, &region(ranges))
}

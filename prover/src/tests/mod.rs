//! What must be decided, and how.

mod examples;
mod independence;
mod random;
mod text;

use super::*;
use text::{NAMES, poly, region};

/// The verdict in short: `proved: method`, `refuted: t = 1/2, λ = 0: value`, `undecided: …`.
fn verdict(p: &Poly, relation: Relation, region: &Region) -> String {
    let mut budget = Budget::default();
    let decision = decide(p, relation, region, &mut budget);
    match decision {
        Decision::Proved(proof) => {
            assert_eq!(
                verify(p, relation, region, &proof.certificate, 1).err(),
                None,
                "{:?}",
                proof.certificate
            );
            format!("proved: {}", proof.method)
        }
        Decision::Refuted(witness) => {
            check_witness(p, relation, region, &witness);
            let point: Vec<String> = witness.point.iter().map(|(v, c)| c.describe(NAMES[v.0])).collect();
            format!("refuted: {}: {}", point.join(", "), witness.value)
        }
        Decision::Undecided(left) => format!("undecided: {left}"),
    }
}

/// A witness lies in the region and contradicts the claim.
fn check_witness(p: &Poly, relation: Relation, region: &Region, witness: &Witness) {
    let mut vars = p.variables();
    vars.extend(region.ranges.iter().map(|(v, _)| *v));
    vars.sort();
    vars.dedup();
    assert_eq!(witness.point.iter().map(|(v, _)| *v).collect::<Vec<_>>(), vars);
    assert!(!relation.holds(&witness.value));
    let mut rest = p.clone();
    let mut algebraic = Vec::new();
    for (v, c) in &witness.point {
        match c {
            Coordinate::Rational(x) => {
                assert!(region.range(*v).contains(x), "{x} is in the range");
                rest = rest.at(*v, x);
            }
            Coordinate::Algebraic(x) => {
                assert!(region.range(*v).contains(x.low()) && region.range(*v).contains(x.high()));
                algebraic.push((*v, x.clone()));
            }
        }
    }
    if algebraic.is_empty() {
        assert_eq!(rest.as_constant(), Some(witness.value.clone()));
    } else {
        assert!(witness.value.is_zero());
        let work = &mut crate::algebra::work::Work::unlimited();
        assert_eq!(zeros::is_zero(&rest, &algebraic, work), Some(true));
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

//! What a certificate says before any proof: what it is about, and what is claimed. It is written from a spec, and
//! compared with the spec when it is read.

use basis_engine::{Claim, Subject};
use serde_json::{Map, Value};

/// The first field of every certificate.
pub(super) const FORMAT: &str = "basis certificate 3";

/// How the alternatives of an obligation are marked, in their order.
pub(super) const SIGNS: [Option<&str>; 3] = [None, Some("negative"), Some("square")];

/// What the claims are about.
pub(super) fn subject(subject: &Subject) -> Map<String, Value> {
    let order: Map<String, Value> =
        subject.order().iter().map(|(n, v)| (n.clone(), Value::from(*v))).collect();
    Map::from_iter([
        (String::from("kind"), Value::from(subject.kind())),
        (String::from("name"), Value::from(subject.name())),
        (String::from("order"), if order.is_empty() { Value::Null } else { Value::Object(order) }),
        (String::from("variables"), Value::from(subject.names())),
    ])
}

/// What a claim says.
pub(super) fn claim(claim: &Claim, line: Option<usize>) -> Map<String, Value> {
    Map::from_iter([
        (String::from("claim"), Value::from(claim.text.as_str())),
        (String::from("line"), Value::from(line)),
        (String::from("declared"), Value::from(claim.expected.keyword())),
    ])
}

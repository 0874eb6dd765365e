//! Items, claims and statements as JSON: everything in a certificate that the spec says.

use basis_engine::algebra::poly::{Poly, Var};
use basis_engine::algebra::range::Region;
use basis_engine::decide::{Relation, Table, Values};
use basis_engine::model::Parameter;
use basis_engine::prove::{Assertion, Statement};
use basis_engine::{Family, Theorem};
use serde_json::{Map, Value, json};

use super::fields::{Fields, list, position, text};
use super::text::{name, number, polynomial, region, variable};
use crate::check::prove::Subject;

/// The names of the variables of a family, and on a simplex of the coordinates s1, s2, … of the unit box that is mapped to it.
pub(super) fn names(subject: &Subject) -> Vec<String> {
    let family = match subject {
        Subject::Family(family) => family,
        Subject::Theorem(theorem) => return theorem.names.clone(),
    };
    let mut names = family.names.clone();
    if family.is_simplex() {
        let known = |prefix: &str, names: &[String]| {
            names.iter().chain(family.dependent.iter().map(|p| &p.name)).any(|n| n.starts_with(prefix))
        };
        let mut prefix = String::from("s");
        while known(&prefix, &names) {
            prefix.push('_');
        }
        names.extend((1..=family.domain.len()).map(|k| format!("{prefix}{k}")));
    }
    names
}

/// What the claims are about, without the claims.
pub(super) fn subject(subject: &Subject) -> Map<String, Value> {
    let order: Map<String, Value> =
        subject.order().iter().map(|(n, v)| (n.clone(), Value::from(*v))).collect();
    let mut fields = Map::from_iter([
        (String::from("kind"), Value::from(subject.kind())),
        (String::from("name"), Value::from(subject.name())),
        (String::from("order"), if order.is_empty() { Value::Null } else { Value::Object(order) }),
        (String::from("variables"), Value::from(names(subject))),
    ]);
    fields.extend(match subject {
        Subject::Family(family) => self::family(family),
        Subject::Theorem(theorem) => self::theorem(theorem),
    });
    fields
}

fn ranges(parameters: &[Parameter]) -> Value {
    parameters.iter().map(|p| Value::from(p.range.display(&p.name).to_string())).collect()
}

/// The ranges of the scalars, and the control points in terms of the given ones.
fn theorem(theorem: &Theorem) -> Map<String, Value> {
    let points = theorem.points.iter().map(|p| Value::from(p.name.clone())).collect();
    Map::from_iter([(String::from("scalars"), ranges(&theorem.scalars)), (String::from("given"), points)])
}

/// The ranges and functions of a family.
fn family(family: &Family) -> Map<String, Value> {
    let function = |k: usize| {
        let value = family.functions[k].value.display(&family.names);
        (family.function_label(k), Value::from(value))
    };
    let mut fields = Map::new();
    let mut put = |key: &str, value: Value| fields.insert(String::from(key), value);
    put("shape", ranges(&family.shapes));
    let coordinates: Vec<&str> = family.domain_variables().map(|p| p.name.as_str()).collect();
    put("domain", if family.is_simplex() { json!({"simplex": coordinates}) } else { ranges(&family.domain) });
    put("functions", Value::Object((0..family.functions.len()).map(function).collect()));
    fields
}

/// A statement.
pub(super) fn statement(names: &[String], statement: &Statement) -> Map<String, Value> {
    let boxed = |region: &Region| {
        region.ranges.iter().map(|(v, r)| r.display(name(names, *v)).to_string()).collect::<Vec<_>>()
    };
    let value = match &statement.assertion {
        Assertion::Zero(value) => json!({"kind": "identity", "difference": value.display(names)}),
        Assertion::Sign { polynomial, relation, region } => json!({
            "kind": "sign",
            "polynomial": polynomial.display(names).to_string(),
            "relation": relation_text(*relation),
            "box": boxed(region),
        }),
        Assertion::Squares { polynomial, relation, products } => {
            let pair = |(var, (p, q)): &(Var, (usize, usize))| (name(names, *var).to_string(), json!([p, q]));
            json!({
                "kind": "dot products",
                "polynomial": polynomial.display(names).to_string(),
                "relation": relation_text(*relation),
                "points": products.iter().map(pair).collect::<Map<String, Value>>(),
            })
        }
        Assertion::Independent { table, except, region } => {
            let row = |row: &Vec<Poly>| row.iter().map(|p| p.display(names).to_string()).collect::<Vec<_>>();
            let values = |values: &Values| -> Map<String, Value> {
                values
                    .iter()
                    .map(|(v, x)| (name(names, *v).to_string(), Value::from(x.to_string())))
                    .collect()
            };
            json!({
                "kind": "independence",
                "rows": table.rows.iter().map(row).collect::<Vec<_>>(),
                "except": except.iter().map(values).collect::<Vec<_>>(),
                "box": boxed(region),
            })
        }
    };
    let mut fields = Map::from_iter([(String::from("of"), Value::from(statement.of.clone()))]);
    fields.extend(value.as_object().cloned().unwrap_or_default());
    fields
}

const fn relation_text(relation: Relation) -> &'static str {
    match relation {
        Relation::NonNegative => ">= 0",
        Relation::Positive => "> 0",
    }
}

fn read_relation(text: &str) -> Result<Relation, String> {
    match text {
        ">= 0" => Ok(Relation::NonNegative),
        "> 0" => Ok(Relation::Positive),
        other => Err(format!("there is no relation `{other}`")),
    }
}

/// Reads a statement from its fields; how much its proof may take is not among them.
pub(super) fn read(fields: &mut Fields<'_>, names: &[String], budget: u32) -> Result<Statement, String> {
    let of = fields.text("of")?.to_string();
    let assertion = match fields.text("kind")? {
        "identity" => match fields.text("difference")? {
            "0" => Assertion::Zero(basis_engine::algebra::fraction::Fraction::zero()),
            other => return Err(format!("the difference is not 0, but `{other}`")),
        },
        "sign" => Assertion::Sign {
            polynomial: polynomial(fields.text("polynomial")?, names)?,
            relation: read_relation(fields.text("relation")?)?,
            region: region(fields.texts("box")?.into_iter(), names)?,
        },
        "dot products" => {
            let points = |(n, pair): (&String, &Value)| match list(pair)? {
                [p, q] => Ok((variable(n, names)?, (position(p)?, position(q)?))),
                _ => Err(String::from("two points are expected")),
            };
            let object = fields.take("points")?.as_object().ok_or("the points are not an object")?;
            Assertion::Squares {
                polynomial: polynomial(fields.text("polynomial")?, names)?,
                relation: read_relation(fields.text("relation")?)?,
                products: object.iter().map(points).collect::<Result<_, String>>()?,
            }
        }
        "independence" => {
            let row = |v: &Value| {
                list(v)?.iter().map(|p| polynomial(text(p)?, names)).collect::<Result<Vec<_>, String>>()
            };
            let rows = fields.list("rows")?.iter().map(row).collect::<Result<_, _>>()?;
            let values = |v: &Value| {
                let values = v.as_object().ok_or("an exception is not an object")?;
                values
                    .iter()
                    .map(|(n, x)| Ok((variable(n, names)?, number(text(x)?)?)))
                    .collect::<Result<Values, String>>()
            };
            let except = fields.list("except")?.iter().map(values).collect::<Result<_, _>>()?;
            let region = region(fields.texts("box")?.into_iter(), names)?;
            Assertion::Independent { table: Table::new(rows), except, region }
        }
        other => return Err(format!("there are no statements of the kind `{other}`")),
    };
    Ok(Statement { of, assertion, budget })
}

//! Proofs of statements as JSON, and back.

use basis_engine::algebra::poly::Poly;
use basis_engine::decide::{ChangeOfBasis, Combination, Computed, Method, Minors, Piece, Proof};
use basis_engine::prove::{Assertion, RankProof, Square, Statement, StepProof, check};
use serde_json::{Map, Value, json};

use super::fields::{Fields, list, position, text};
use super::signs::{Reader, Writer};
use super::text::{name, number, region};

/// The proof of a statement; an identity needs none but its expansion.
///
/// # Errors
/// What is wrong with the proof; that would be a mistake in the search.
pub(super) fn proof(statement: &Statement, proof: &StepProof, names: &[String]) -> Result<Value, String> {
    let computed = check::proof(statement, proof)?;
    let (cells, minors) = (computed.cells.into_iter(), computed.minors.into_iter());
    let mut writer = Writer { names, cells, minors };
    Ok(match proof {
        StepProof::Identity => Value::from("expansion"),
        StepProof::Sign(proof) => writer.certificate(&proof.certificate),
        StepProof::Independence(proof) => independence(&mut writer, proof),
        StepProof::Squares(squares) => Value::from(squares.iter().map(square).collect::<Vec<_>>()),
    })
}

/// A square of a vector with its factor.
fn square(Square { factor, vector }: &Square) -> Value {
    let parts = vector.iter().map(|(k, x)| json!([k, x.to_string()])).collect::<Vec<_>>();
    json!({"factor": factor.to_string(), "vector": parts})
}

fn read_square(value: &Value) -> Result<Square, String> {
    let mut fields = Fields::of(value)?;
    let factor = number(fields.text("factor")?)?;
    let vector = read_combination(fields.take("vector")?)?;
    fields.end()?;
    Ok(Square { factor, vector })
}

fn independence(writer: &mut Writer<'_>, proof: &RankProof) -> Value {
    let combination = |c: &Vec<Poly>| c.iter().map(|p| writer.poly(p)).collect::<Vec<_>>();
    let exceptions: Vec<Vec<Value>> = proof.exceptions.iter().map(combination).collect();
    let pieces: Vec<Value> = proof.pieces.iter().map(|p| piece(writer, p)).collect();
    json!({"exceptions": exceptions, "pieces": pieces})
}

fn piece(writer: &mut Writer<'_>, piece: &Piece) -> Value {
    let ranges = piece.region.ranges.iter().map(|(v, r)| r.display(name(writer.names, *v)).to_string());
    let mut fields = Map::from_iter([(String::from("box"), Value::from(ranges.collect::<Vec<_>>()))]);
    if let Some(change) = &piece.change {
        fields.insert(String::from("rows"), bases(&change.rows));
        fields.insert(String::from("columns"), bases(&change.columns));
    }
    let blocks = piece.blocks.iter().map(|Minors { rows, columns, certificate }| {
        let minors: Vec<Value> = columns
            .iter()
            .map(|columns| {
                let value = writer.minors.next().unwrap_or_default();
                json!({"columns": columns, "value": writer.poly(&value)})
            })
            .collect();
        json!({"rows": rows, "minors": minors, "proof": writer.certificate(certificate)})
    });
    let blocks: Vec<Value> = blocks.collect();
    fields.insert(String::from("blocks"), Value::from(blocks));
    Value::Object(fields)
}

/// Combinations as lists of positions with their factors.
fn bases(combinations: &[Combination]) -> Value {
    let one = |c: &Combination| c.iter().map(|(k, x)| json!([k, x.to_string()])).collect::<Vec<_>>();
    Value::from(combinations.iter().map(one).collect::<Vec<_>>())
}

/// Reads the proof of a statement, with the coefficients on the cells of its certificates and the minors.
pub(super) fn read(
    statement: &Statement,
    value: &Value,
    names: &[String],
) -> Result<(StepProof, Computed), String> {
    let mut reader = Reader { names, computed: Computed::default() };
    let proof = match &statement.assertion {
        Assertion::Zero(_) => match text(value)? {
            "expansion" => StepProof::Identity,
            other => return Err(format!("`{other}` is no proof of an identity")),
        },
        Assertion::Sign { .. } => {
            // The method is not part of the proof.
            StepProof::Sign(Proof { method: Method::Constant, certificate: reader.certificate(value)? })
        }
        Assertion::Squares { .. } => {
            StepProof::Squares(list(value)?.iter().map(read_square).collect::<Result<_, _>>()?)
        }
        Assertion::Independent { .. } => StepProof::Independence(read_independence(&mut reader, value)?),
    };
    Ok((proof, reader.computed))
}

fn read_independence(reader: &mut Reader<'_>, value: &Value) -> Result<RankProof, String> {
    let mut fields = Fields::of(value)?;
    let combination = |v: &Value| list(v)?.iter().map(|p| reader.poly(p)).collect::<Result<Vec<_>, String>>();
    let exceptions = fields.list("exceptions")?.iter().map(combination).collect::<Result<_, _>>()?;
    let pieces = fields.list("pieces")?.iter().map(|p| read_piece(reader, p)).collect::<Result<_, _>>()?;
    fields.end()?;
    Ok(RankProof { pieces, exceptions })
}

fn read_piece(reader: &mut Reader<'_>, value: &Value) -> Result<Piece, String> {
    let mut fields = Fields::of(value)?;
    let region = region(fields.texts("box")?.into_iter(), reader.names)?;
    let change = match fields.take_if_any("rows") {
        None => None,
        Some(rows) => {
            Some(ChangeOfBasis { rows: read_bases(rows)?, columns: read_bases(fields.take("columns")?)? })
        }
    };
    let mut blocks = Vec::new();
    for block in fields.list("blocks")? {
        let mut own = Fields::of(block)?;
        let rows = own.list("rows")?.iter().map(position).collect::<Result<_, _>>()?;
        let mut columns = Vec::new();
        for minor in own.list("minors")? {
            let mut fields = Fields::of(minor)?;
            columns.push(fields.list("columns")?.iter().map(position).collect::<Result<_, _>>()?);
            let value = reader.poly(fields.take("value")?)?;
            reader.computed.minors.push(value);
            fields.end()?;
        }
        let certificate = reader.certificate(own.take("proof")?)?;
        own.end()?;
        blocks.push(Minors { rows, columns, certificate });
    }
    fields.end()?;
    Ok(Piece { region, change, blocks })
}

fn read_bases(value: &Value) -> Result<Vec<Combination>, String> {
    list(value)?.iter().map(read_combination).collect()
}

fn read_combination(value: &Value) -> Result<Combination, String> {
    let entry = |v: &Value| match list(v)? {
        [k, x] => Ok((position(k)?, number(text(x)?)?)),
        _ => Err(String::from("a position with its factor is expected")),
    };
    list(value)?.iter().map(entry).collect()
}

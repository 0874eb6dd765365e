//! Certificates for signs of polynomials as JSON, and back.

use basis_engine::algebra::poly::{Poly, Var};
use basis_engine::algebra::rational::Rational;
use basis_engine::decide::{
    Base, CellCoefficients, Cells, Certificate, Computed, Factor, Sample, Section, Slices, Subdivision,
};
use serde_json::{Value, json};

use super::fields::{Fields, list, text};
use super::text::{name, number, polynomial, variable};

/// Cells within each other.
const MAX_DEPTH: usize = 2000;

/// Writes certificates; the coefficients on their cells, and the minors, come in the order in which they stand in them.
pub(super) struct Writer<'a> {
    pub(super) names: &'a [String],
    pub(super) cells: std::vec::IntoIter<CellCoefficients>,
    pub(super) minors: std::vec::IntoIter<Poly>,
}

impl Writer<'_> {
    pub(super) fn poly(&self, p: &Poly) -> Value {
        Value::from(p.display(self.names).to_string())
    }

    fn polys(&self, levels: &[Vec<Poly>]) -> Vec<Vec<Value>> {
        levels.iter().map(|level| level.iter().map(|p| self.poly(p)).collect()).collect()
    }

    fn vars(&self, order: &[Var]) -> Vec<&str> {
        order.iter().map(|v| name(self.names, *v)).collect()
    }

    pub(super) fn certificate(&mut self, certificate: &Certificate) -> Value {
        match certificate {
            Certificate::Empty => json!({"kind": "empty"}),
            Certificate::Constant => json!({"kind": "constant"}),
            Certificate::Bernstein(tree) => {
                let mut parts = Vec::new();
                self.subdivision(tree, &mut parts);
                json!({"kind": "bernstein", "parts": parts})
            }
            Certificate::Corners { var, low, high, middle } => {
                let (low, high) = (self.certificate(low), self.certificate(high));
                let middle =
                    middle.as_ref().map(|(x, c)| json!({"at": x.to_string(), "proof": self.certificate(c)}));
                json!({"kind": "corners", "variable": name(self.names, *var), "low": low, "high": high, "middle": middle})
            }
            Certificate::Factors { number, factors } => {
                let factors: Vec<Value> = factors.iter().map(|f| self.factor(f)).collect();
                json!({"kind": "factors", "number": number.to_string(), "factors": factors})
            }
            Certificate::Faces(faces) => {
                let faces: Vec<Value> = faces.iter().map(|c| self.certificate(c)).collect();
                json!({"kind": "faces", "faces": faces})
            }
            Certificate::Cells(Cells { order, levels, samples }) => {
                let samples: Vec<Value> = samples.iter().map(sample).collect();
                json!({"kind": "cells", "order": self.vars(order), "levels": self.polys(levels), "samples": samples})
            }
            Certificate::Slices(Slices { bases, boxes }) => {
                let bases: Vec<Value> = bases.iter().map(|b| self.base(b)).collect();
                let ends = |(a, b): &(Rational, Rational)| [a.to_string(), b.to_string()];
                let boxes: Vec<Vec<[String; 2]>> =
                    boxes.iter().map(|b| b.iter().map(ends).collect()).collect();
                json!({"kind": "slices", "bases": bases, "boxes": boxes})
            }
        }
    }

    /// In one list: a cut, then its lower, then its upper part.
    fn subdivision(&mut self, tree: &Subdivision, parts: &mut Vec<Value>) {
        let mut waiting = vec![tree];
        while let Some(tree) = waiting.pop() {
            match tree {
                Subdivision::Leaf => {
                    let coefficients = self.cells.next().unwrap_or_default();
                    let texts: Vec<String> = coefficients.iter().map(Rational::to_string).collect();
                    parts.push(json!({"coefficients": texts}));
                }
                Subdivision::Split { var, at, low, high } => {
                    parts.push(json!({"cut": name(self.names, *var), "at": at.to_string()}));
                    waiting.push(high);
                    waiting.push(low);
                }
            }
        }
    }

    fn factor(&mut self, Factor { base, exponent, sign }: &Factor) -> Value {
        let mut value = json!({"base": self.poly(base), "exponent": exponent});
        if let (Some((negative, certificate)), Some(fields)) = (sign, value.as_object_mut()) {
            fields.insert(String::from("sign"), Value::from(if *negative { "-" } else { "+" }));
            fields.insert(String::from("proof"), self.certificate(certificate));
        }
        value
    }

    fn base(&mut self, Base { order, levels, sections, sectors }: &Base) -> Value {
        let sectors: Vec<Value> =
            sectors.iter().map(|(x, c)| json!({"at": x.to_string(), "proof": self.certificate(c)})).collect();
        let sections: Vec<Value> = sections
            .iter()
            .map(|section| match section {
                Section::Exact(x, c) => json!({"at": x.to_string(), "proof": self.certificate(c)}),
                Section::Between(a, b) => json!({"between": [a.to_string(), b.to_string()]}),
            })
            .collect();
        json!({"order": self.vars(order), "levels": self.polys(levels), "sectors": sectors, "sections": sections})
    }
}

fn sample(Sample { value, above }: &Sample) -> Value {
    if above.is_empty() {
        return json!({"at": value.to_string()});
    }
    json!({"at": value.to_string(), "above": above.iter().map(sample).collect::<Vec<_>>()})
}

/// Reads certificates, and collects the coefficients on their cells and the minors.
pub(super) struct Reader<'a> {
    pub(super) names: &'a [String],
    pub(super) computed: Computed,
}

impl Reader<'_> {
    pub(super) fn poly(&self, value: &Value) -> Result<Poly, String> {
        polynomial(text(value)?, self.names)
    }

    pub(super) fn certificate(&mut self, value: &Value) -> Result<Certificate, String> {
        let mut fields = Fields::of(value)?;
        let certificate = match fields.text("kind")? {
            "empty" => Certificate::Empty,
            "constant" => Certificate::Constant,
            "bernstein" => Certificate::Bernstein(self.subdivision(fields.list("parts")?)?),
            "corners" => {
                let var = variable(fields.text("variable")?, self.names)?;
                let low = Box::new(self.certificate(fields.take("low")?)?);
                let high = Box::new(self.certificate(fields.take("high")?)?);
                let middle = match fields.take("middle")? {
                    Value::Null => None,
                    middle => {
                        let (x, c) = self.slice(middle)?;
                        Some((x, Box::new(c)))
                    }
                };
                Certificate::Corners { var, low, high, middle }
            }
            "factors" => {
                let number = number(fields.text("number")?)?;
                let factors =
                    fields.list("factors")?.iter().map(|f| self.factor(f)).collect::<Result<_, _>>()?;
                Certificate::Factors { number, factors }
            }
            "faces" => {
                let faces = fields.list("faces")?.iter().map(|c| self.certificate(c));
                Certificate::Faces(faces.collect::<Result<_, _>>()?)
            }
            "cells" => {
                let (order, levels) = self.projections(&mut fields)?;
                let samples = fields.list("samples")?.iter().map(read_sample).collect::<Result<_, _>>()?;
                Certificate::Cells(Cells { order, levels, samples })
            }
            "slices" => {
                let bases = fields.list("bases")?.iter().map(|b| self.base(b)).collect::<Result<_, _>>()?;
                let ends = |v: &Value| pair(v);
                let one = |b: &Value| list(b)?.iter().map(ends).collect::<Result<Vec<_>, String>>();
                let boxes = fields.list("boxes")?.iter().map(one).collect::<Result<_, _>>()?;
                Certificate::Slices(Slices { bases, boxes })
            }
            other => return Err(format!("there are no certificates of the kind `{other}`")),
        };
        fields.end()?;
        Ok(certificate)
    }

    fn subdivision(&mut self, parts: &[Value]) -> Result<Subdivision, String> {
        // Cuts whose upper, or whose both parts are still to come.
        let mut open: Vec<(Var, Rational, Option<Box<Subdivision>>)> = Vec::new();
        for (k, part) in parts.iter().enumerate() {
            let mut fields = Fields::of(part)?;
            if let Some(cut) = fields.take_if_any("cut") {
                open.push((variable(text(cut)?, self.names)?, number(fields.text("at")?)?, None));
                fields.end()?;
                if open.len() > MAX_DEPTH {
                    return Err(String::from("the subdivision is too deep"));
                }
                continue;
            }
            let coefficients = fields.texts("coefficients")?;
            fields.end()?;
            self.computed.cells.push(coefficients.into_iter().map(number).collect::<Result<_, _>>()?);
            let mut done = Subdivision::Leaf;
            loop {
                match open.pop() {
                    None if k + 1 == parts.len() => return Ok(done),
                    None => return Err(String::from("there are parts beyond the whole")),
                    Some((var, at, None)) => {
                        open.push((var, at, Some(Box::new(done))));
                        break;
                    }
                    Some((var, at, Some(low))) => {
                        done = Subdivision::Split { var, at, low, high: Box::new(done) };
                    }
                }
            }
        }
        Err(String::from("a part of the subdivision is missing"))
    }

    fn factor(&mut self, value: &Value) -> Result<Factor, String> {
        let mut fields = Fields::of(value)?;
        let base = self.poly(fields.take("base")?)?;
        let exponent = fields.take("exponent")?.as_u64().and_then(|e| u32::try_from(e).ok());
        let exponent = exponent.ok_or("an exponent is not a number")?;
        let sign = match fields.take_if_any("sign") {
            None => None,
            Some(sign) => {
                let negative = match text(sign)? {
                    "+" => false,
                    "-" => true,
                    other => return Err(format!("`{other}` is not a sign")),
                };
                Some((negative, Box::new(self.certificate(fields.take("proof")?)?)))
            }
        };
        fields.end()?;
        Ok(Factor { base, exponent, sign })
    }

    /// A number with a certificate.
    fn slice(&mut self, value: &Value) -> Result<(Rational, Certificate), String> {
        let mut fields = Fields::of(value)?;
        let x = number(fields.text("at")?)?;
        let certificate = self.certificate(fields.take("proof")?)?;
        fields.end()?;
        Ok((x, certificate))
    }

    fn projections(&self, fields: &mut Fields<'_>) -> Result<(Vec<Var>, Vec<Vec<Poly>>), String> {
        let order =
            fields.texts("order")?.into_iter().map(|n| variable(n, self.names)).collect::<Result<_, _>>()?;
        let level = |v: &Value| list(v)?.iter().map(|p| self.poly(p)).collect::<Result<Vec<_>, String>>();
        let levels = fields.list("levels")?.iter().map(level).collect::<Result<_, _>>()?;
        Ok((order, levels))
    }

    fn base(&mut self, value: &Value) -> Result<Base, String> {
        let mut fields = Fields::of(value)?;
        let (order, levels) = self.projections(&mut fields)?;
        let sectors = fields.list("sectors")?.iter().map(|s| self.slice(s)).collect::<Result<_, _>>()?;
        let mut sections = Vec::new();
        for section in fields.list("sections")? {
            let mut own = Fields::of(section)?;
            sections.push(match own.take_if_any("between") {
                Some(ends) => {
                    own.end()?;
                    let (a, b) = pair(ends)?;
                    Section::Between(a, b)
                }
                None => {
                    let (x, certificate) = self.slice(section)?;
                    Section::Exact(x, Box::new(certificate))
                }
            });
        }
        fields.end()?;
        Ok(Base { order, levels, sections, sectors })
    }
}

fn read_sample(value: &Value) -> Result<Sample, String> {
    let mut fields = Fields::of(value)?;
    let at = number(fields.text("at")?)?;
    let above = match fields.take_if_any("above") {
        None => Vec::new(),
        Some(above) => list(above)?.iter().map(read_sample).collect::<Result<_, _>>()?,
    };
    fields.end()?;
    Ok(Sample { value: at, above })
}

fn pair(value: &Value) -> Result<(Rational, Rational), String> {
    match list(value)? {
        [a, b] => Ok((number(text(a)?)?, number(text(b)?)?)),
        _ => Err(String::from("two numbers are expected")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn certificates_come_back() {
        let names = ["t".to_string(), "λ".to_string()];
        let p = |text: &str| polynomial(text, &names).expect("a polynomial");
        let half = || Rational::new(1, 2);
        let base = Base {
            order: vec![Var(1), Var(0)],
            levels: vec![vec![p("-2 + λ^2")], vec![p("t - λ")]],
            sections: vec![
                Section::Between(Rational::ONE, Rational::from(2)),
                Section::Exact(half(), Box::new(Certificate::Constant)),
            ],
            sectors: vec![(Rational::ZERO, Certificate::Empty)],
        };
        let cut = Subdivision::Split {
            var: Var(0),
            at: half(),
            low: Box::new(Subdivision::Leaf),
            high: Box::new(Subdivision::Leaf),
        };
        let samples =
            vec![Sample { value: half(), above: vec![Sample { value: Rational::ONE, above: Vec::new() }] }];
        let all = Certificate::Faces(vec![
            Certificate::Slices(Slices { bases: vec![base], boxes: vec![vec![(Rational::ZERO, half())]] }),
            Certificate::Bernstein(cut),
            Certificate::Cells(Cells { order: vec![Var(0)], levels: vec![vec![p("1 - t")]], samples }),
            Certificate::Corners {
                var: Var(1),
                low: Box::new(Certificate::Constant),
                high: Box::new(Certificate::Constant),
                middle: Some((half(), Box::new(Certificate::Empty))),
            },
            Certificate::Factors {
                number: -half(),
                factors: vec![
                    Factor { base: p("t"), exponent: 2, sign: None },
                    Factor {
                        base: p("λ"), exponent: 1, sign: Some((true, Box::new(Certificate::Constant)))
                    },
                ],
            },
        ]);
        let cells = vec![vec![Rational::ONE, half()], vec![Rational::ZERO]];
        let written =
            Writer { names: &names, cells: cells.clone().into_iter(), minors: Vec::new().into_iter() }
                .certificate(&all);
        let mut reader = Reader { names: &names, computed: Computed::default() };
        assert_eq!(reader.certificate(&written), Ok(all));
        assert_eq!(reader.computed.cells, cells);
    }

    #[test]
    fn subdivisions_have_all_their_parts_and_no_more() {
        let names = ["t".to_string()];
        let read = |parts: Value| {
            Reader { names: &names, computed: Computed::default() }
                .certificate(&json!({"kind": "bernstein", "parts": parts}))
        };
        let (cut, cell) = (json!({"cut": "t", "at": "1/2"}), json!({"coefficients": ["1"]}));
        assert!(read(json!([cell])).is_ok() && read(json!([cut, cell, cell])).is_ok());
        assert!(read(json!([cut, cell, cut, cell, cell])).is_ok());
        for parts in [json!([]), json!([cut]), json!([cut, cell]), json!([cell, cell]), json!([cell, cut])] {
            assert!(read(parts.clone()).is_err(), "{parts}");
        }
        let deep: Vec<Value> = std::iter::repeat_n(cut, 100_000).collect();
        assert!(read(Value::from(deep)).is_err());
    }
}

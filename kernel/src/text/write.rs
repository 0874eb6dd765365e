//! Writes certificates and witnesses.

use core::fmt::Write as _;

use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::univariate::Univariate;
use crate::certificate::{
    Base, Certificate, Combination, Cuts, FactorSign, Piece, Rank, Sample, Section, SignProof, Signed,
};
use crate::point::{Point, Root};
use crate::proof::Witness;

/// The text of a certificate.
pub fn certificate_text(certificate: &Certificate) -> String {
    match certificate {
        Certificate::Direct => String::from("direct"),
        Certificate::Sign { denominator, numerator } => {
            let below = denominator.as_ref().map_or_else(|| String::from("_"), signed);
            list(&["sign", &below, &proof(numerator)])
        }
        Certificate::Minors(proofs) => headed("minors", proofs.iter().map(proof)),
        Certificate::Rank(rank) => self::rank(rank),
    }
}

/// The text of a witness.
pub fn witness_text(witness: &Witness) -> String {
    match witness {
        Witness::At(point) => self::point(point),
        Witness::Dependent(point, factors) => {
            headed("dependent", [self::point(point)].into_iter().chain(factors.iter().map(value)))
        }
        Witness::Independent(point, number) => {
            list(&["independent", &self::point(point), &number.to_string()])
        }
        Witness::OnLine(point, numbers) => {
            let number = |(p, x): &(usize, Rational)| format!("{p} {x}");
            headed("line", [self::point(point)].into_iter().chain(numbers.iter().map(number)))
        }
    }
}

fn list(parts: &[&str]) -> String {
    format!("({})", parts.join(" "))
}

fn all(parts: impl Iterator<Item = String>) -> String {
    let parts: Vec<String> = parts.collect();
    format!("({})", parts.join(" "))
}

fn headed(head: &str, parts: impl Iterator<Item = String>) -> String {
    all([String::from(head)].into_iter().chain(parts))
}

fn var(var: Var) -> String {
    format!("x{}", var.0)
}

pub(super) fn poly(p: &Poly) -> String {
    let names: Vec<String> =
        (0..p.variables().last().map_or(0, |v| v.0 + 1)).map(|k| format!("x{k}")).collect();
    p.display(&names).to_string().replace(' ', "")
}

fn numbers<'a>(numbers: impl Iterator<Item = &'a Rational>) -> String {
    all(numbers.map(Rational::to_string))
}

fn proof(proof: &SignProof) -> String {
    match proof {
        SignProof::Cuts(tree) => {
            let mut text = String::new();
            cuts(tree, &mut text);
            text
        }
        SignProof::Corners { var, low, high, middle } => {
            let mut parts = vec![self::var(*var), self::proof(low), self::proof(high)];
            if let Some((x, proof)) = middle {
                parts.extend([x.to_string(), self::proof(proof)]);
            }
            headed("corners", parts.into_iter())
        }
        SignProof::Factors { factors, rest } => {
            let factor = |(base, sign): &(Poly, FactorSign)| match sign {
                FactorSign::Any => list(&[&poly(base), "^"]),
                FactorSign::Known(sign) => list(&[&poly(base), &signed(sign)]),
            };
            headed("factors", factors.iter().map(factor).chain([signed(rest)]))
        }
        SignProof::Squares { squares, rest } => {
            let square = |(factor, base): &(Rational, Poly)| list(&[&factor.to_string(), &poly(base)]);
            headed("squares", squares.iter().map(square).chain([self::proof(rest)]))
        }
        SignProof::Faces(faces) => headed("faces", faces.iter().map(self::proof)),
        SignProof::Cells(cells) => {
            let samples = all(cells.samples.iter().map(sample));
            list(&["cells", &all(cells.order.iter().copied().map(var)), &levels(&cells.levels), &samples])
        }
        SignProof::Slices(slices) => {
            let ends = |ends: &Vec<(Rational, Rational)>| numbers(ends.iter().flat_map(|(a, b)| [a, b]));
            let bases = all(slices.bases.iter().map(base));
            list(&["slices", &bases, &all(slices.boxes.iter().map(ends))])
        }
    }
}

fn cuts(tree: &Cuts, text: &mut String) {
    match tree {
        Cuts::None => text.push('.'),
        Cuts::At { var, low, high } => {
            let _ = write!(text, "(cut x{} ", var.0);
            cuts(low, text);
            text.push(' ');
            cuts(high, text);
            text.push(')');
        }
    }
}

fn signed(signed: &Signed) -> String {
    let (sign, proof) = match signed {
        Signed::Positive(proof) => ("+", proof),
        Signed::Negative(proof) => ("-", proof),
    };
    if *proof == SignProof::direct() { String::from(sign) } else { list(&[sign, &self::proof(proof)]) }
}

fn levels(levels: &[Vec<Poly>]) -> String {
    all(levels.iter().map(|level| all(level.iter().map(poly))))
}

fn sample(sample: &Sample) -> String {
    if sample.above.is_empty() {
        return sample.value.to_string();
    }
    headed(&sample.value.to_string(), sample.above.iter().map(self::sample))
}

fn base(base: &Base) -> String {
    let section = |section: &Section| match section {
        Section::Exact(x, proof) => list(&["=", &x.to_string(), &self::proof(proof)]),
        Section::Between(a, b) => numbers([a, b].into_iter()),
    };
    let sector = |(x, proof): &(Rational, SignProof)| list(&[&x.to_string(), &self::proof(proof)]);
    list(&[
        &all(base.order.iter().copied().map(var)),
        &levels(&base.levels),
        &all(base.sections.iter().map(section)),
        &all(base.sectors.iter().map(sector)),
    ])
}

fn rank(rank: &Rank) -> String {
    let exception = |combination: &Vec<Poly>| all(combination.iter().map(poly));
    list(&["rank", &all(rank.pieces.iter().map(piece)), &all(rank.exceptions.iter().map(exception))])
}

fn piece(piece: &Piece) -> String {
    let places = |places: &Vec<usize>| all(places.iter().map(usize::to_string));
    let blocks = piece.blocks.iter().map(|block| {
        let columns = all(block.columns.iter().map(places));
        list(&[&places(&block.rows), &columns, &signed(&block.sign)])
    });
    let combination = |c: &Combination| all(c.iter().flat_map(|(k, x)| [k.to_string(), x.to_string()]));
    match &piece.change {
        None => all(blocks),
        Some(change) => {
            let bases = [&change.rows, &change.columns].map(|b| all(b.iter().map(combination)));
            headed("change", bases.into_iter().chain(blocks))
        }
    }
}

fn value(value: &Univariate) -> String {
    if value.is_constant() { value.leading().to_string() } else { numbers(value.coefficients().iter()) }
}

fn point(point: &Point) -> String {
    let root = point.root.iter().map(|Root { polynomial, low, high }| {
        list(&["root", &numbers(polynomial.coefficients().iter()), &low.to_string(), &high.to_string()])
    });
    let coordinates = point.coordinates.iter().map(|(v, x)| list(&[&var(*v), &value(x)]));
    headed("at", root.chain(coordinates))
}

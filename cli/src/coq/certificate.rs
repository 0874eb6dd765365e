//! Certificates of the kernel as those of `Basis.v`.

use std::rc::Rc;

use basis_engine::algebra::range::{End, Range};
use basis_engine::algebra::rational::Rational;
use basis_kernel::algebra::poly::{Poly, Var};
use basis_kernel::algebra::work::Work;
use basis_kernel::{Certificate, Chart, Cuts, FactorSign, Proof, Relation, SignProof, Signed, Statement};

use super::formula::{polynomial_data, rational};

/// Why there is no certificate for Coq.
type Missing = &'static str;

/// The proof of a sign with that of the denominator, for the independent variables in their order; what there is no
/// counterpart for.
pub(super) fn of(certificate: &Certificate, variables: &[(Var, Range)]) -> Result<(String, String), Missing> {
    match certificate {
        Certificate::Direct => Ok((String::from("Direct"), String::from("Direct"))),
        Certificate::Sign { denominator, numerator } => {
            let below = match denominator {
                None => String::from("Direct"),
                Some(Signed::Positive(proof) | Signed::Negative(proof)) => sign(proof, variables)?,
            };
            Ok((sign(numerator, variables)?, below))
        }
        _ => Err("another kind of certificate"),
    }
}

/// How Coq sees a sign: by certificates for the numerator and the denominator, either those of the formula as Coq expands it, or
/// those of a quotient that is given.
pub(super) struct Signs {
    by: String,
    over: Option<String>,
}

impl Signs {
    /// The proof of a sign for the variables of a box in their order. What is shown by cuts alone holds of every multiple by a
    /// positive number; for other proofs the quotient of the kernel is given, with the polynomials of its chart.
    pub(super) fn of(proof: &Proof, chart: &Chart, variables: &[(Var, Range)]) -> Result<Self, Missing> {
        let found = by_cuts(proof, variables);
        let (Err(_), Certificate::Sign { denominator, numerator }, Statement::Sign { value, relation, .. }) =
            (&found, proof.certificate(), proof.statement())
        else {
            return found.map(|(numerator, denominator)| Self {
                by: format!("{numerator} {denominator}"),
                over: None,
            });
        };
        let in_box = |p: &Poly| {
            let by = chart.variables().iter();
            by.fold(p.clone(), |p, (var, by)| p.substitute(*var, by))
        };
        let (mut above, mut below) = (in_box(&value.numerator), in_box(&value.denominator));
        let negative = match denominator {
            None => below.as_constant().is_some_and(|x| x.is_negative()),
            Some(signed) => matches!(signed, Signed::Negative(_)),
        };
        if negative {
            (above, below) = (-&above, -&below);
        }
        let denominator = match denominator {
            None => String::from("Direct"),
            Some(Signed::Positive(proof) | Signed::Negative(proof)) => {
                polynomial(&below, Relation::NonNegative, proof, variables)?
            }
        };
        let numerator = polynomial(&above, *relation, numerator, variables)?;
        let over = format!("({}) ({})", data(&above, variables), data(&below, variables));
        Ok(Self { by: format!("{numerator} {denominator}"), over: Some(over) })
    }

    /// The lemma by which a difference has the sign, `le` or `lt`, with its arguments up to the two sides.
    pub(super) fn lemma(&self, comparison: &str, common: &str) -> String {
        match &self.over {
            None => format!("{comparison}_by {common} {}", self.by),
            Some(over) => format!("{comparison}_over {common} {} {over}", self.by),
        }
    }
}

/// A polynomial in the independent variables.
fn data(p: &Poly, variables: &[(Var, Range)]) -> String {
    let order: Vec<Var> = variables.iter().map(|(v, _)| *v).collect();
    polynomial_data(p, &order)
}

/// The proof of the sign of a polynomial, with the polynomials that are left of it.
fn polynomial(
    p: &Poly,
    relation: Relation,
    proof: &SignProof,
    variables: &[(Var, Range)],
) -> Result<String, Missing> {
    match proof {
        SignProof::Corners { var, low, high, middle: None } => {
            let place = variables.iter().position(|(v, _)| v == var).ok_or("a corner of another variable")?;
            let range = &variables[place].1;
            let slope = p.derivative(*var);
            let part = |end: &End, sign: i64, proof: &SignProof| {
                let part = end.value().map_or_else(|| slope.scale(&Rational::from(sign)), |x| p.at(*var, x));
                let relation = if end.is_included() { relation } else { Relation::NonNegative };
                polynomial(&part, relation, proof, variables)
            };
            let (low, high) = (part(&range.low, -1, low)?, part(&range.high, 1, high)?);
            Ok(format!("(Corner {place} {low} {high})"))
        }
        SignProof::Corners { .. } => Err("a proof by corners and a number between them"),
        SignProof::Factors { factors, rest } => product(p, relation, (factors, rest), variables),
        SignProof::Squares { squares, rest } => {
            let is_fixed =
                |(v, range): &(Var, Range)| p.depends_on(*v) && range.finite().is_some_and(|(a, b)| a == b);
            if variables.iter().any(is_fixed) {
                return Err("a sum of squares with a variable of one value");
            }
            let (mut left, mut text) = (p.clone(), String::new());
            for (factor, base) in squares {
                left = &left - &(base * base).scale(factor);
                text += &format!("(Plus {} ({}) ", rational(factor), data(base, variables));
            }
            text += &polynomial(&left, relation, rest, variables)?;
            Ok(text + &")".repeat(squares.len()))
        }
        _ => sign(proof, variables),
    }
}

/// The proof of the sign of a product: of each factor, and of what is left.
fn product(
    p: &Poly,
    relation: Relation,
    (factors, rest): (&[(Poly, FactorSign)], &Signed),
    variables: &[(Var, Range)],
) -> Result<String, Missing> {
    const DIVIDES: Missing = "a factor of a polynomial at a single number";
    let Some(((base, known), others)) = factors.split_first() else {
        let (Signed::Positive(proof) | Signed::Negative(proof)) = rest;
        return polynomial(p, relation, proof, variables);
    };
    let (factor, own) = match known {
        FactorSign::Any => (base.clone(), None),
        FactorSign::Known(signed) => match &**signed {
            Signed::Positive(proof) => (base.clone(), Some(polynomial(base, relation, proof, variables)?)),
            Signed::Negative(proof) => {
                let base = -base;
                let proof = polynomial(&base, relation, proof, variables)?;
                (base, Some(proof))
            }
        },
    };
    let (mut left, mut parts) = (p.clone(), Vec::new());
    while let Some(quotient) = left.div_exact(&factor) {
        parts.push(quotient.clone());
        left = quotient;
    }
    if parts.is_empty() {
        return Err(DIVIDES);
    }
    let mut text = product(&left, relation, (others, rest), variables)?;
    match own {
        Some(own) => {
            for quotient in parts.iter().rev() {
                text = format!(
                    "(Product false ({}) ({}) {own} {text})",
                    data(&factor, variables),
                    data(quotient, variables)
                );
            }
        }
        None => {
            for quotient in parts.iter().skip(1).step_by(2).rev() {
                text =
                    format!("(Square ({}) ({}) {text})", data(&factor, variables), data(quotient, variables));
            }
        }
    }
    Ok(text)
}

/// The certificate of a proof of a sign, or else one by cuts alone that the kernel accepts for the same statement.
pub(super) fn by_cuts(proof: &Proof, variables: &[(Var, Range)]) -> Result<(String, String), Missing> {
    let found = of(proof.certificate(), variables);
    let (Err(_), Certificate::Sign { denominator, .. }) = (&found, proof.certificate()) else { return found };
    let statement = Rc::new(proof.statement().clone());
    for depth in 1..=MAX_CUTS {
        for (var, _) in variables {
            let numerator = SignProof::Cuts(halved(*var, depth));
            let certificate = Certificate::Sign { denominator: denominator.clone(), numerator };
            if let Ok(proof) = Proof::new(Rc::clone(&statement), certificate, &mut Work::usual(1)) {
                return of(proof.certificate(), variables);
            }
        }
    }
    found
}

/// How often a side is halved where the proof has no counterpart.
const MAX_CUTS: u32 = 3;

/// A side that is halved, and its halves in turn, `depth` times.
fn halved(var: Var, depth: u32) -> Cuts {
    match depth {
        0 => Cuts::None,
        _ => Cuts::At { var, low: Box::new(halved(var, depth - 1)), high: Box::new(halved(var, depth - 1)) },
    }
}

/// The proof of a sign.
pub(super) fn sign(proof: &SignProof, variables: &[(Var, Range)]) -> Result<String, Missing> {
    match proof {
        SignProof::Cuts(tree) => cuts(tree, &mut variables.to_vec()),
        SignProof::Corners { .. } => Err("independence by the corners of a range"),
        SignProof::Factors { .. } => Err("independence by factors"),
        SignProof::Squares { .. } => Err("independence by squares"),
        SignProof::Faces(_) => Err("a proof by faces"),
        SignProof::Cells(_) => Err("a proof by cells"),
        SignProof::Slices(_) => Err("a proof by slices"),
    }
}

fn cuts(tree: &Cuts, variables: &mut [(Var, Range)]) -> Result<String, Missing> {
    let Cuts::At { var, low, high } = tree else { return Ok(String::from("Direct")) };
    let place = variables.iter().position(|(v, _)| v == var).ok_or("a cut along another variable")?;
    let range = variables[place].1.clone();
    let at = middle(&range);
    let mut part = |range: Range, tree: &Cuts| {
        variables[place].1 = range;
        cuts(tree, variables)
    };
    let below = part(Range { low: range.low.clone(), high: End::Included(at.clone()) }, low)?;
    let above = part(Range { low: End::Included(at.clone()), high: range.high.clone() }, high)?;
    variables[place].1 = range;
    Ok(format!("(Cut {place} {} {below} {above})", rational(&at)))
}

/// Where a side is cut: in the middle, 1 beyond the end of an infinite side, and at 0 on a side without ends.
fn middle(range: &Range) -> Rational {
    match (range.low.value(), range.high.value()) {
        (Some(a), Some(b)) => &(a + b) * &Rational::new(1, 2),
        (Some(a), None) => a + &Rational::ONE,
        (None, Some(b)) => b - &Rational::ONE,
        (None, None) => Rational::ZERO,
    }
}

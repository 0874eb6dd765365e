//! Reads certificates and witnesses.

use super::tree::Tree;
use super::write::{certificate_text, witness_text};
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::univariate::Univariate;
use crate::certificate::{
    Base, Cells, Certificate, ChangeOfBasis, Combination, Cuts, FactorSign, Minors, Piece, Rank, Sample,
    Section, SignProof, Signed, Slices,
};
use crate::point::{Point, Root};
use crate::proof::Witness;
use crate::refusal::{Refusal, fits};

/// The largest number of a row or a column.
const MAX_PLACE: usize = 1_000_000;
/// The largest number of a variable: a monomial has an exponent for each up to its last.
const MAX_VARIABLE: usize = 4096;

/// Reads a certificate.
///
/// # Errors
/// When the text is not the one text of a certificate.
pub fn certificate(text: &str) -> Result<Certificate, Refusal> {
    let tree = Tree::read(text)?;
    let certificate = match (&tree, tree.headed()) {
        (Tree::Word("direct"), _) => Certificate::Direct,
        (_, ("sign", [below, numerator])) => Certificate::Sign {
            denominator: match below {
                Tree::Word("_") => None,
                other => Some(signed(other)?),
            },
            numerator: proof(numerator)?,
        },
        (_, ("minors", proofs)) => Certificate::Minors(all(proofs, proof)?),
        (_, ("rank", [pieces, exceptions])) => Certificate::Rank(Rank {
            pieces: all(pieces.list()?, piece)?,
            exceptions: all(exceptions.list()?, |e| all(e.list()?, poly))?,
        }),
        _ => return Err(Refusal::Unfit("there is no such certificate")),
    };
    fits(certificate_text(&certificate) == text, "the text is not as it would be written")?;
    Ok(certificate)
}

/// Reads a witness.
///
/// # Errors
/// When the text is not the one text of a witness.
pub fn witness(text: &str) -> Result<Witness, Refusal> {
    let tree = Tree::read(text)?;
    let witness = match tree.headed() {
        ("at", _) => Witness::At(point(&tree)?),
        ("dependent", [at, factors @ ..]) => Witness::Dependent(point(at)?, all(factors, value)?),
        ("independent", [at, number]) => Witness::Independent(point(at)?, place(number)?),
        ("line", [at, numbers @ ..]) => Witness::OnLine(point(at)?, pairs(numbers)?),
        _ => return Err(Refusal::Unfit("there is no such witness")),
    };
    fits(witness_text(&witness) == text, "the text is not as it would be written")?;
    Ok(witness)
}

fn all<'t, T>(trees: &[Tree<'t>], one: impl Fn(&Tree<'t>) -> Result<T, Refusal>) -> Result<Vec<T>, Refusal> {
    trees.iter().map(one).collect()
}

fn number(tree: &Tree<'_>) -> Result<Rational, Refusal> {
    Rational::parse(tree.word()?).ok_or(Refusal::Unfit("a number is expected"))
}

fn place(tree: &Tree<'_>) -> Result<usize, Refusal> {
    let place = tree.word()?.parse().ok().filter(|k| *k <= MAX_PLACE);
    place.ok_or(Refusal::Unfit("a whole number is expected"))
}

fn var(tree: &Tree<'_>) -> Result<Var, Refusal> {
    variable(tree.word()?).ok_or(Refusal::Unfit("a variable is expected"))
}

fn variable(word: &str) -> Option<Var> {
    word.strip_prefix('x')?.parse().ok().filter(|k| *k <= MAX_VARIABLE).map(Var)
}

fn poly(tree: &Tree<'_>) -> Result<Poly, Refusal> {
    polynomial(tree.word()?).ok_or(Refusal::Unfit("an expanded polynomial is expected"))
}

/// A polynomial such as `-1/2+3*x0-x0*x1^2`.
fn polynomial(word: &str) -> Option<Poly> {
    let (mut negative, mut rest) = match word.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, word),
    };
    let mut terms = Vec::new();
    loop {
        let next = rest.find(['+', '-']).unwrap_or(rest.len());
        let (monomial, coefficient) = term(&rest[..next])?;
        terms.push((monomial, if negative { -coefficient } else { coefficient }));
        if next == rest.len() {
            return Some(Poly::from_terms(terms));
        }
        negative = rest[next..].starts_with('-');
        rest = &rest[next + 1..];
    }
}

/// A product such as `3/2*x0*x1^2`.
fn term(text: &str) -> Option<(Monomial, Rational)> {
    let mut monomial = Monomial::one();
    let mut coefficient = Rational::ONE;
    for (k, factor) in text.split('*').enumerate() {
        if k == 0 && factor.starts_with(|c: char| c.is_ascii_digit()) {
            coefficient = Rational::parse(factor)?;
            continue;
        }
        let (name, exponent) = match factor.split_once('^') {
            Some((name, exponent)) => (name, exponent.parse::<u16>().ok()?),
            None => (factor, 1),
        };
        monomial = monomial.with_exponent(variable(name)?, exponent);
    }
    Some((monomial, coefficient))
}

fn proof(tree: &Tree<'_>) -> Result<SignProof, Refusal> {
    if let Tree::Word(".") = tree {
        return Ok(SignProof::direct());
    }
    Ok(match tree.headed() {
        ("cut", _) => SignProof::Cuts(cuts(tree)?),
        ("corners", [x, low, high, middle @ ..]) => SignProof::Corners {
            var: var(x)?,
            low: Box::new(proof(low)?),
            high: Box::new(proof(high)?),
            middle: match middle {
                [] => None,
                [x, own] => Some((number(x)?, Box::new(proof(own)?))),
                _ => return Err(Refusal::Unfit("corners have one middle at most")),
            },
        },
        ("factors", [factors @ .., rest]) => SignProof::Factors {
            factors: all(factors, |f| match f.list()? {
                [base, Tree::Word("^")] => Ok((poly(base)?, FactorSign::Any)),
                [base, sign] => Ok((poly(base)?, FactorSign::Known(Box::new(signed(sign)?)))),
                _ => Err(Refusal::Unfit("a factor with its sign is expected")),
            })?,
            rest: Box::new(signed(rest)?),
        },
        ("squares", [squares @ .., rest]) => SignProof::Squares {
            squares: all(squares, |square| match square.list()? {
                [factor, base] => Ok((number(factor)?, poly(base)?)),
                _ => Err(Refusal::Unfit("a number with a polynomial is expected")),
            })?,
            rest: Box::new(proof(rest)?),
        },
        ("faces", faces) => SignProof::Faces(all(faces, proof)?),
        ("cells", [order, own, samples]) => SignProof::Cells(Cells {
            order: all(order.list()?, var)?,
            levels: levels(own)?,
            samples: all(samples.list()?, sample)?,
        }),
        ("slices", [bases, boxes]) => SignProof::Slices(Slices {
            bases: all(bases.list()?, base)?,
            boxes: all(boxes.list()?, |ends| {
                let pair = |ends: &[Tree<'_>]| match ends {
                    [a, b] => Ok((number(a)?, number(b)?)),
                    _ => Err(Refusal::Unfit("two ends are expected")),
                };
                ends.list()?.chunks(2).map(pair).collect()
            })?,
        }),
        _ => return Err(Refusal::Unfit("there is no such proof of a sign")),
    })
}

fn cuts(tree: &Tree<'_>) -> Result<Cuts, Refusal> {
    match (tree, tree.headed()) {
        (Tree::Word("."), _) => Ok(Cuts::None),
        (_, ("cut", [x, low, high])) => {
            Ok(Cuts::At { var: var(x)?, low: Box::new(cuts(low)?), high: Box::new(cuts(high)?) })
        }
        _ => Err(Refusal::Unfit("a cell or a cut is expected")),
    }
}

fn signed(tree: &Tree<'_>) -> Result<Signed, Refusal> {
    Ok(match (tree, tree.headed()) {
        (Tree::Word("+"), _) => Signed::Positive(SignProof::direct()),
        (Tree::Word("-"), _) => Signed::Negative(SignProof::direct()),
        (_, ("+", [own])) => Signed::Positive(proof(own)?),
        (_, ("-", [own])) => Signed::Negative(proof(own)?),
        _ => return Err(Refusal::Unfit("a sign is expected")),
    })
}

fn levels(tree: &Tree<'_>) -> Result<Vec<Vec<Poly>>, Refusal> {
    all(tree.list()?, |level| all(level.list()?, poly))
}

fn sample(tree: &Tree<'_>) -> Result<Sample, Refusal> {
    match tree {
        Tree::Word(_) => Ok(Sample { value: number(tree)?, above: Vec::new() }),
        Tree::List(list) => match list.split_first() {
            Some((value, above)) => Ok(Sample { value: number(value)?, above: all(above, sample)? }),
            None => Err(Refusal::Unfit("a sample is expected")),
        },
    }
}

fn base(tree: &Tree<'_>) -> Result<Base, Refusal> {
    let [order, own, sections, sectors] = tree.list()? else {
        return Err(Refusal::Unfit("the slices along one variable are expected"));
    };
    Ok(Base {
        order: all(order.list()?, var)?,
        levels: levels(own)?,
        sections: all(sections.list()?, |section| match section.list()? {
            [Tree::Word("="), x, own] => Ok(Section::Exact(number(x)?, Box::new(proof(own)?))),
            [a, b] => Ok(Section::Between(number(a)?, number(b)?)),
            _ => Err(Refusal::Unfit("a section is expected")),
        })?,
        sectors: all(sectors.list()?, |sector| match sector.list()? {
            [x, own] => Ok((number(x)?, proof(own)?)),
            _ => Err(Refusal::Unfit("a number with a proof is expected")),
        })?,
    })
}

fn piece(tree: &Tree<'_>) -> Result<Piece, Refusal> {
    let (change, blocks) = match tree.headed() {
        ("change", [rows, columns, blocks @ ..]) => {
            let [rows, columns] = [rows, columns].map(|basis| all(basis.list()?, |c| pairs(c.list()?)));
            (Some(ChangeOfBasis { rows: rows?, columns: columns? }), blocks)
        }
        _ => (None, tree.list()?),
    };
    let places = |tree: &Tree<'_>| all(tree.list()?, place);
    let block = |block: &Tree<'_>| match block.list()? {
        [rows, columns, sign] => {
            Ok(Minors { rows: places(rows)?, columns: all(columns.list()?, places)?, sign: signed(sign)? })
        }
        _ => Err(Refusal::Unfit("a block is expected")),
    };
    Ok(Piece { change, blocks: all(blocks, block)? })
}

fn pairs(trees: &[Tree<'_>]) -> Result<Combination, Refusal> {
    let pair = |pair: &[Tree<'_>]| match pair {
        [k, x] => Ok((place(k)?, number(x)?)),
        _ => Err(Refusal::Unfit("an index with its factor is expected")),
    };
    trees.chunks(2).map(pair).collect()
}

fn value(tree: &Tree<'_>) -> Result<Univariate, Refusal> {
    match tree {
        Tree::Word(_) => Ok(Univariate::new(vec![number(tree)?])),
        Tree::List(list) => Ok(Univariate::new(all(list, number)?)),
    }
}

fn point(tree: &Tree<'_>) -> Result<Point, Refusal> {
    let ("at", parts) = tree.headed() else { return Err(Refusal::Unfit("a point is expected")) };
    let (root, coordinates) = match parts.split_first().map(|(first, rest)| (first.headed(), rest)) {
        Some((("root", [polynomial, low, high]), rest)) => {
            let polynomial = value(polynomial)?;
            (Some(Root { polynomial, low: number(low)?, high: number(high)? }), rest)
        }
        _ => (None, parts),
    };
    let coordinates = all(coordinates, |coordinate| match coordinate.list()? {
        [x, own] => Ok((var(x)?, value(own)?)),
        _ => Err(Refusal::Unfit("a coordinate is expected")),
    })?;
    Ok(Point { root, coordinates })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn certificates_come_back() {
        for text in [
            "direct",
            "(sign _ .)",
            "(sign (- (cut x1 . (cut x0 . .))) (corners x0 . . 1/2 (faces . . .)))",
            "(sign + (factors (-1+x0 ^) (x0-x1 -) (+ (cut x0 . .))))",
            "(sign _ (cells (x0 x1) ((-2+x0^2) (-1/3+x0*x1)) ((-3 0 1) 2)))",
            "(sign _ (slices (((x0 x1) ((x0) (x1)) ((= 0 .) (1 3/2)) ((-1 .) (1/2 .) (2 .)))) ((1 3/2 0 1))))",
            "(minors . (cut x0 . .))",
            "(rank ((((0 2) ((0 1) (1 2)) +) ((1) ((3)) -))) ((1 -x0)))",
            "(rank ((change ((0 1 2 -1/2) (2 1)) ((0 1)) ((0) ((0)) +))) ())",
        ] {
            let read = certificate(text).unwrap_or_else(|e| panic!("{text}: {e}"));
            assert_eq!(certificate_text(&read), text);
        }
        for text in [
            "(at)",
            "(at (x0 1/2) (x3 -2))",
            "(at (root (-2 0 1) 1 3/2) (x0 (0 1)) (x1 3))",
            "(dependent (at (x0 1)) 1 0 -1/2)",
            "(dependent (at (root (-2 0 1) 1 3/2) (x0 (0 1))) (1 -1/2) 1)",
            "(independent (at (x0 1)) 0)",
            "(line (at (x0 1)) 0 1 3 -1/2)",
        ] {
            let read = witness(text).unwrap_or_else(|e| panic!("{text}: {e}"));
            assert_eq!(witness_text(&read), text);
        }
    }

    #[test]
    fn only_the_one_text_is_read() {
        for text in [
            "",
            "direct ",
            "(direct)",
            "(sign _  .)",
            "(sign _ .))",
            "(sign _ (.)",
            "(sign _ (cut x0 .))",
            "(sign _ (cut 0 . .))",
            "(sign _ (cut x00 . .))",
            "(sign (+ .) .)",
            "(sign _ (factors))",
            "(sign _ (cells (x0) ((1+x0)) (2/4)))",
            "(sign _ (cells (x0) ((x0+1)) (1)))",
            "(sign _ (cells (x0) ((x0^0)) (1)))",
            "(rank ((((0) ((0)) +))))",
            "(rank ((((99999999999) ((0)) +))) ())",
        ] {
            assert!(certificate(text).is_err(), "{text}");
        }
        let deep = format!("(sign _ {}.{})", "(faces ".repeat(5000), ")".repeat(5000));
        assert!(certificate(&deep).is_err());
        for text in ["(at (x0 1", "(at (x0 2/4))", "(at (x0 (1)))", "(at (x0 1 2))", "at", "(dependent 1)"] {
            assert!(witness(text).is_err(), "{text}");
        }
    }
}

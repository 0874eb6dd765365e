//! Independence, exceptional sets and largest ranges of the families of the papers.

use basis_kernel::Values;

use super::*;
use crate::algebra::univariate::ToPoly;
use crate::range::{LargestRange, largest_range};
use crate::rank::{Exceptional, Independence, Table, exceptional_set, independent};
use text::var;

/// The coefficients of polynomials in t.
fn rows(functions: &[&str]) -> Vec<Vec<Poly>> {
    let all: Vec<Vec<Poly>> = functions.iter().map(|f| poly(f).coefficients_in(var("t"))).collect();
    let width = all.iter().map(Vec::len).max().unwrap_or(0);
    let filled = all.into_iter().map(|mut r| {
        r.resize(width, Poly::zero());
        r
    });
    filled.collect()
}

const QUARTIC: [&str; 4] =
    ["(1 - λ*t)*(1 - t)^3", "(3 + λ - λ*t)*t*(1 - t)^2", "(3 + λ*t)*t^2*(1 - t)", "(1 - λ + λ*t)*t^3"];
const QUADRATIC: [&str; 3] = ["(1 - λ*t)*(1 - t)^2", "(2 + λ)*(1 - t)*t", "(1 - λ + λ*t)*t^2"];

fn check(rows: &[Vec<Poly>], except: &[Values], ranges: &str) -> String {
    let region = region(ranges);
    let statement =
        Statement::Independent { rows: rows.to_vec(), except: except.to_vec(), region: region.clone() };
    match decide(statement, &Vec::new(), 1) {
        Ok(_) => match independent(Table { rows, symmetries: &Vec::new() }, except, &region, 1) {
            Independence::Proved(rank) => {
                let minors = |p: &basis_kernel::Piece| {
                    p.blocks.iter().map(|b| b.columns.len().to_string()).collect::<Vec<_>>().join("+")
                };
                format!("proved with {}", rank.pieces.iter().map(minors).collect::<Vec<_>>().join(", "))
            }
            other => panic!("{other:?}"),
        },
        Err(Failure::Refuted(found)) => {
            let point: Vec<String> = found.point.iter().map(|(v, c)| c.describe(NAMES[v.0])).collect();
            let names = [String::from("x")];
            let factors = match found.refutation.witness() {
                basis_kernel::Witness::Dependent(_, factors) => {
                    factors.iter().map(|c| c.to_poly(Var(0)).display(&names).to_string()).collect()
                }
                other => vec![format!("{other:?}")],
            };
            format!("dependent at {}: {}", point.join(", "), factors.join(" "))
        }
        Err(Failure::Undecided(left)) => format!("undecided: {left}"),
    }
}

fn exceptions(rows: &[Vec<Poly>], ranges: &str) -> Vec<String> {
    let set = exceptional_set(Table { rows, symmetries: &Vec::new() }, &region(ranges), 1);
    let names = NAMES.map(String::from);
    let one = |e: &Exceptional| {
        let values: Vec<String> = e.values.iter().map(|(v, c)| c.describe(NAMES[v.0])).collect();
        let c = e
            .combination
            .as_ref()
            .map(|c| c.iter().map(|p| p.display(&names).to_string()).collect::<Vec<_>>());
        format!("{}: {}", values.join(", "), c.map_or("-".into(), |c| c.join(" ")))
    };
    let mut lines: Vec<String> = set.exceptions.iter().map(one).collect();
    lines.extend(set.open.map(|o| format!("open: {o}")));
    lines
}

#[test]
fn quartic_family() {
    let rows = rows(&QUARTIC);
    assert_eq!(check(&rows, &[], "-3<=λ<=1"), "dependent at λ = -3: 0 1 -1 0");
    assert_eq!(check(&rows, &[], "-3<λ<=1"), "proved with 2+1+1+1");
    let at = vec![(var("λ"), Rational::from(-3))];
    assert_eq!(check(&rows, core::slice::from_ref(&at), "-3<=λ<=1"), "proved with 2+1+1+1");
    assert_eq!(check(&rows, core::slice::from_ref(&at), ""), "proved with 1+1+1+1, 2+1+1+1");
    assert_eq!(exceptions(&rows, "-3<=λ<=1"), ["λ = -3: 0 1 -1 0"]);
    assert_eq!(exceptions(&rows, "-2<=λ<=1"), [""; 0]);
    // λ = −3 is outside of the range, and no matter; λ = 0 is no exception.
    assert_eq!(check(&rows, &[at], "-3<λ<=1"), "proved with 2+1+1+1");
    let other = vec![(var("λ"), Rational::ZERO)];
    let found = check(&rows, &[other], "-3<λ<=1");
    assert!(found.starts_with("dependent at λ = 0: Independent("), "{found}");
}

#[test]
fn quadratic_family() {
    let rows = rows(&QUADRATIC);
    assert_eq!(check(&rows, &[], "-2<=λ<=1"), "dependent at λ = -2: 0 1 0");
    assert_eq!(check(&rows, &[], "-2<λ"), "proved with 2");
    assert_eq!(exceptions(&rows, ""), ["λ = -2: 0 1 0"]);
}

#[test]
fn exceptions_that_need_several_minors() {
    // Rank 1 rows: every minor vanishes somewhere, all of them nowhere …
    assert_eq!(check(&rows(&["λ + (λ - 1)*t"]), &[], ""), "proved with 2");
    // … and here at √2 only.
    let irrational = rows(&["(λ^2 - 2)*(λ + (λ - 1)*t)"]);
    assert_eq!(check(&irrational, &[], "0<=λ<=1"), "proved with 2");
    assert_eq!(check(&irrational, &[], "0<=λ"), "dependent at λ = sqrt(2): 1");
    assert_eq!(exceptions(&irrational, "0<=λ"), ["λ = sqrt(2): -"]);
    // The minors λ, μ and λ μ vanish together at the origin only.
    let origin = rows(&["λ + μ*t"]);
    assert_eq!(check(&origin, &[], "0<=λ<=1, 0<=μ<=1"), "dependent at λ = 0, μ = 0: 1");
    assert_eq!(check(&origin, &[], "0<=λ<=1, 0<μ<=1"), "proved with 1");
    assert_eq!(exceptions(&origin, "0<=λ<=1, 0<=μ<=1"), ["λ = 0, μ = 0: 1"]);
    let both = vec![(var("λ"), Rational::ZERO), (var("μ"), Rational::ZERO)];
    assert_eq!(check(&origin, &[both], ""), "proved with 1, 1, 1, 1");
}

#[test]
fn flats_of_exceptions() {
    // Dependent where λ = 0 and where μ = 1.
    let table = rows(&["1 + t", "1 + t + λ*(μ - 1)*t^2", "t^3"]);
    let found = exceptions(&table, "0<=λ<=1, 0<=μ<=1");
    assert_eq!(found, ["λ = 0: 1 -1 0", "μ = 1: 1 -1 0"]);
    let except = [vec![(var("λ"), Rational::ZERO)], vec![(var("μ"), Rational::ONE)]];
    assert_eq!(check(&table, &except, "0<=λ<=1, 0<=μ<=1"), "proved with 1+1+1");
    assert_eq!(exceptions(&rows(&["1 + λ*t", "λ + λ^2*t"]), ""), [": λ -1"]);
}

fn largest(functions: &[&str], name: &str, ranges: &str) -> String {
    let polys: Vec<Poly> = functions.iter().map(|f| poly(f)).collect();
    match largest_range(&polys, var(name), &region(ranges), &mut Budget::default()) {
        LargestRange::Between(a, b) => {
            let text = |c: Option<Coordinate>| c.map_or("none".into(), |c| c.describe(name));
            format!("{} to {}", text(a), text(b))
        }
        LargestRange::Negative => "negative".into(),
        LargestRange::Undecided(left) => format!("undecided: {left}"),
    }
}

#[test]
fn largest_ranges() {
    assert_eq!(largest(&QUADRATIC, "λ", "0<=t<=1, -2<=λ<=1"), "λ = -2 to λ = 1");
    assert_eq!(largest(&QUADRATIC, "λ", "0<=t<=1, -1/2<=λ<=1/2"), "λ = -2 to λ = 1");
    assert_eq!(largest(&QUARTIC, "λ", "0<=t<=1, -3<=λ<=1"), "λ = -3 to λ = 1");
    assert_eq!(largest(&QUARTIC, "λ", "0<=t<=1, -3<=λ<=2"), "negative");
    assert_eq!(largest(&["2 - λ^2 + t"], "λ", "0<=t<=1, 0<=λ<=1"), "λ = -sqrt(2) to λ = sqrt(2)");
    assert_eq!(largest(&["t^2 + 1", "t + λ"], "λ", "0<=t<=1, 0<=λ<=1"), "λ = 0 to none");
    // (t − λ)² + μ λ − …: not of degree 1 in t.
    assert_eq!(largest(&["t^2 - λ*t + 1"], "λ", "0<=λ<=1"), "λ = -2 to λ = 2");
    assert_eq!(largest(&["t^2 - λ*t + μ"], "λ", "0<=λ<=1, 1<=μ<=4"), "λ = -2 to λ = 2");
}

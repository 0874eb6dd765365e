//! Certificates of independence, of sums of dot products, and of identities.

use std::rc::Rc;

use basis_kernel::algebra::poly::Var;
use basis_kernel::algebra::rational::Rational;
use basis_kernel::{Domain, Quotient, Refusal, Relation, Statement, Values, text};

use crate::signs::offer;
use crate::text::{domain, poly, region};

/// Rows such as `x0 1, 0 x0 - 1`, with exceptions such as `x0 = 1 x1 = 2, x0 = 3`.
pub(crate) fn independent(rows: &str, except: &str, on: &str) -> Rc<Statement> {
    let rows = rows.split(';').map(|row| row.split(',').map(poly).collect()).collect();
    let value = |text: &str| -> (Var, Rational) {
        let (var, x) = text.split_once('=').expect("a value");
        (Var(var.trim()[1..].parse().expect("a number")), Rational::parse(x.trim()).expect("a number"))
    };
    let values = |text: &str| -> Values { text.split('&').map(value).collect() };
    let except = except.split(',').filter(|s| !s.trim().is_empty()).map(values).collect();
    Rc::new(Statement::Independent { rows, except, region: region(on) })
}

fn accepted(statement: &Rc<Statement>, certificate: &str) -> bool {
    let read = text::certificate(certificate).unwrap_or_else(|e| panic!("{certificate}: {e}"));
    offer(statement, &read).is_ok()
}

#[test]
fn tables_of_numbers() {
    assert!(accepted(&independent("1, 2; 3, 4", "", ""), "direct"));
    assert!(!accepted(&independent("1, 2; 2, 4", "", ""), "direct"));
    assert!(!accepted(&independent("1, 2, 3; 3, 4", "", ""), "direct"));
    assert!(!accepted(&independent("1; 2", "", ""), "direct"));
    assert!(!accepted(&independent("1, x0; 3, 4", "", "0 <= x0 <= 1"), "direct"));
    assert!(accepted(&independent("1, 2; 2, 4", "", "0 <= x0 < 0"), "direct"));
    // Determinants that vanish modulo primes, and one that does not though all entries do.
    assert!(accepted(&independent("1, 0; 1, 2147483647", "", ""), "direct"));
    assert!(accepted(&independent("2147483647, 0; 1/2147483629, 4611685975477714963", "", ""), "direct"));
    assert!(!accepted(&independent("1/3, 2147483648; 2147483647, 1", "", ""), "(rank ((((0) ((0)) +))) ())"));
    assert!(!accepted(&independent("1, 2, 3; 4, 5, 6; 7, 8, 9", "", ""), "direct"));
    assert!(accepted(&independent("1, 2, 3; 4, 5, 6; 7, 8, 10", "", ""), "direct"));
    assert!(accepted(&independent("1/2, 1/3; 1/3, 1/2", "", ""), "direct"));
    let long = "1000000000000000000000000000000";
    assert!(accepted(&independent(&format!("{long}, 1; 0, 1"), "", ""), "direct"));
    assert!(accepted(&independent(&format!("-{long}, 1; 0, 1"), "", ""), "direct"));
    assert!(!accepted(&independent("1, 2; 3, 4; 5, 6", "", ""), "direct"));
    assert!(!accepted(&independent("0, 0; 3, 4", "", ""), "direct"));
    assert!(!accepted(&independent("1, 2; 3, 4", "x0 = 0", "0 <= x0 <= 1"), "direct"));
    assert!(accepted(&independent("1, 2; 3, 4", "", ""), "(rank ((((0 1) ((0 1)) -))) ())"));
    assert!(!accepted(&independent("1, 2; 3, 4", "", ""), "(rank ((((0 1) ((0 1)) +))) ())"));
}

/// Exceptions cut a box into as many parts as are allowed, or into none.
#[test]
fn boxes_without_exceptions() {
    let Statement::Independent { except, region, .. } = &*independent("1", "x0 = 1/2", "0 <= x0 <= 1") else {
        panic!("independence");
    };
    let parts = basis_kernel::pieces(region, except, 2).expect("two parts");
    assert_eq!(parts, [crate::text::region("0 <= x0 < 1/2"), crate::text::region("1/2 < x0 <= 1")]);
    assert_eq!(basis_kernel::pieces(region, except, 3).expect("two parts").len(), 2);
    assert_eq!(basis_kernel::pieces(region, except, 1), None);
}

/// Determinants without a number to divide by, and with rows and columns exchanged.
#[test]
fn determinants_of_polynomials() {
    let table = independent("x0 + 1, x0; x0, x0 + 1", "", "0 <= x0 <= 1");
    assert!(accepted(&table, "(rank ((((0 1) ((0 1)) +))) ())"));
    assert!(!accepted(&table, "(rank ((((0 1) ((0 1)) -))) ())"));
    let cyclic = independent("x0 + 1, x0, 0; 0, x0 + 1, x0; x0, 0, x0 + 1", "", "0 <= x0 <= 1");
    assert!(accepted(&cyclic, "(rank ((((0 1 2) ((0 1 2)) +))) ())"));
    assert!(!accepted(&cyclic, "(rank ((((0 1 2) ((0 1 2)) -))) ())"));
}

/// What a variable with a single value makes zero, and columns that are given twice.
#[test]
fn blocks_in_form() {
    let at_zero = independent("1, x0; 5, 1", "", "0 <= x0 <= 0");
    let certificate = "(rank ((((0) ((0)) +) ((1) ((1)) +))) ())";
    assert!(accepted(&at_zero, certificate));
    assert!(!accepted(&independent("1, x0; 5, 1", "", "0 <= x0 <= 1/1000"), certificate));
    let twice = text::certificate("(rank ((((0 1) ((1 1)) +))) ())").expect("a certificate");
    let refusal = offer(&at_zero, &twice).err();
    assert_eq!(refusal, Some(Refusal::Unfit("columns are not in increasing order")));
}

/// λ + 3 and 1 − λ in a triangle of blocks.
#[test]
fn blocks_and_minors() {
    let rows = "x0 + 3, 0, 0; 1, 1 - x0, 1; 0, x0, 2";
    let statement = independent(rows, "", "-3 < x0 < 0");
    let certificate = "(rank ((((1 2) ((1 2)) +) ((0) ((0)) +))) ())";
    // The rows 1 and 2 are not zero in column 0, in which the later block has its minor: the order matters.
    assert!(!accepted(&statement, certificate));
    let certificate = "(rank ((((0) ((0)) +) ((1 2) ((1 2)) +))) ())";
    assert!(accepted(&statement, certificate));
    for other in [
        "(rank () ())",
        "(rank (()) ())",
        "(rank ((((0) ((0)) +))) ())",
        "(rank ((((0) ((0)) +) ((1 2) ((1 2)) -))) ())",
        "(rank ((((0) ((0)) -) ((1 2) ((1 2)) +))) ())",
        "(rank ((((0) ((0)) +) ((1 2) ((2 1)) +))) ())",
        "(rank ((((0) ((0)) +) ((1 2) ((1 1)) +))) ())",
        "(rank ((((0) ((0)) +) ((1 2) ((1 3)) +))) ())",
        "(rank ((((0) ((0)) +) ((1 2) ((0 1)) +))) ())",
        "(rank ((((0) ((0)) +) ((1 2) ((1)) +))) ())",
        "(rank ((((0) ((0)) +) ((1 2) () +))) ())",
        "(rank ((((0) ((0)) +) ((1 1) ((1 2)) +))) ())",
        "(rank ((((0) ((0)) +) ((0) ((0)) +) ((1 2) ((1 2)) +))) ())",
        "(rank ((((0) ((0)) +) ((1 2) ((1 2)) +)) (((0) ((0)) +) ((1 2) ((1 2)) +))) ())",
        "(rank ((((0) ((0)) +) ((1 2) ((1 2)) +))) ((1 0 0)))",
    ] {
        assert!(!accepted(&statement, other), "{other}");
    }
    for (rows, on) in [(rows, "-3 <= x0 < 0"), (rows, "-3 < x0 <= 1"), (rows, "")] {
        assert!(!accepted(&independent(rows, "", on), certificate), "{on}");
    }
    assert!(!accepted(&independent("x0 + 3, 1, 0; 1, 1 - x0, 1; 0, x0, 2", "", "-3 < x0 < 0"), certificate));
}

/// x and 1 − x do not vanish together, though each of them does.
#[test]
fn several_minors() {
    let statement = independent("x0, 1 - x0", "", "");
    let certificate = "(rank ((((0) ((0) (1)) (+ (cut x0 . (cut x0 (cut x0 . .) .)))))) ())";
    assert!(accepted(&statement, certificate));
    assert!(!accepted(&statement, "(rank ((((0) ((0)) (+ (cut x0 . (cut x0 (cut x0 . .) .)))))) ())"));
    assert!(!accepted(&statement, "(rank ((((0) ((0) (1)) (- (cut x0 . (cut x0 (cut x0 . .) .)))))) ())"));
    assert!(!accepted(&independent("x0, x0^2", "", ""), certificate));
}

#[test]
fn other_bases() {
    // The sum and the difference of the rows, and of the columns: 3 + x and 1 − x.
    let statement = independent("2, 1 + x0; 1 + x0, 2", "", "-3 < x0 < 1");
    let certificate = |rows: &str, columns: &str| {
        format!("(rank ((change ({rows}) ({columns}) ((0) ((0)) +) ((1) ((1)) +))) ())")
    };
    assert!(accepted(&statement, &certificate("(0 1 1 1) (0 1 1 -1)", "(0 1 1 1) (0 1 1 -1)")));
    for (rows, columns) in [
        ("(0 1 1 1) (0 2 1 2)", "(0 1 1 1) (0 1 1 -1)"),
        ("(0 1 1 1)", "(0 1 1 1) (0 1 1 -1)"),
        ("(0 1 1 1) (0 1 1 -1) (0 1)", "(0 1 1 1) (0 1 1 -1)"),
        ("(0 1 1 1) (0 1 1 -1)", "(0 1 1 1) (0 1 1 1)"),
        ("(0 1 1 1) (0 1 1 -1)", "(0 1 1 1)"),
        ("(0 1 1 1) (0 1 1 -1)", "(0 1 1 1) (0 1 1 -1) (0 1)"),
        ("(0 1 2 1) (0 1 1 -1)", "(0 1 1 1) (0 1 1 -1)"),
        ("(0 1 1 1) ()", "(0 1 1 1) (0 1 1 -1)"),
    ] {
        assert!(!accepted(&statement, &certificate(rows, columns)), "{rows} {columns}");
    }
    let wider = independent("2, 1 + x0; 1 + x0, 2", "", "-3 < x0 <= 1");
    assert!(!accepted(&wider, &certificate("(0 1 1 1) (0 1 1 -1)", "(0 1 1 1) (0 1 1 -1)")));
}

#[test]
fn exceptions_are_shown_and_left_out() {
    let rows = "x0 - 1, x1; 0, 1";
    let statement = independent(rows, "x0 = 1", "0 <= x0 <= 2");
    let parts = "(((1) ((1)) +) ((0) ((0)) -)) (((1) ((1)) +) ((0) ((0)) +))";
    assert!(accepted(&statement, &format!("(rank ({parts}) ((1 -x1)))")));
    for combination in ["0 0", "1 x1", "1 0", "1", "1 -x1 0", "x0 -x0*x1", ""] {
        assert!(!accepted(&statement, &format!("(rank ({parts}) (({combination})))")), "{combination}");
    }
    assert!(!accepted(&statement, &format!("(rank ({parts}) ())")));
    assert!(!accepted(&statement, &format!("(rank ({parts}) ((1 -x1) (1 -x1)))")));
    assert!(!accepted(&statement, "(rank ((((1) ((1)) +) ((0) ((0)) +))) ((1 -x1)))"));
    // The exception is another one, has another variable, lies outside, or takes everything.
    for (except, on) in [("x0 = 1/2", "0 <= x0 <= 2"), ("x1 = 1", "0 <= x0 <= 2"), ("x0 = 3", "0 <= x0 <= 2")]
    {
        for combination in ["1 -x1", "1 -1", ""] {
            let certificate = format!("(rank ({parts}) (({combination})))");
            assert!(!accepted(&independent(rows, except, on), &certificate), "{except}: {combination}");
        }
    }
    // Two values of one variable are no point at all.
    let twice = independent(rows, "x0 = 1 & x0 = 2", "0 <= x0 <= 2");
    for parts in ["", parts, "(((1) ((1)) +) ((0) ((0)) -))"] {
        assert!(!accepted(&twice, &format!("(rank ({parts}) ((1 -x1)))")), "{parts}");
    }
}

/// Both factors vanish: the point is an exception, the lines through it are not.
#[test]
fn joint_exceptions() {
    let statement = independent("x0, x1", "x0 = 0 & x1 = 0", "");
    let certificate = "(rank ((((0) ((0)) -)) (((0) ((0)) +)) (((0) ((1)) -)) (((0) ((1)) +))) ((1)))";
    assert!(accepted(&statement, certificate));
    assert!(!accepted(&independent("x0, x1", "x0 = 0", ""), certificate));
    assert!(!accepted(&independent("x0, x0", "x0 = 0 & x1 = 0", ""), certificate));
    assert!(!accepted(&independent("x0, x1", "x0 = 0 & x1 = 1", ""), certificate));
}

/// Dot products p₀·p₀ = x0, p₀·p₁ = x1, p₁·p₁ = x2.
pub(crate) fn products(value: &str, relation: Relation, on: &str) -> Rc<Statement> {
    let products = vec![(Var(0), (0, 0)), (Var(1), (0, 1)), (Var(2), (1, 1))];
    Rc::new(Statement::Products { value: poly(value), relation, products, domain: Rc::new(domain(on)) })
}

#[test]
fn sums_of_dot_products() {
    use Relation::{NonNegative, Positive};
    let accepted = |value: &str, relation, on: &str, certificate: &str| {
        accepted(&products(value, relation, on), certificate)
    };
    // |p₀ − p₁|²
    let square = "x0 - 2*x1 + x2";
    assert!(accepted(square, NonNegative, "", "direct"));
    assert!(accepted(square, NonNegative, "", "(minors . . .)"));
    assert!(accepted(&format!("{square} + 1"), Positive, "", "direct"));
    assert!(!accepted(square, Positive, "", "direct"));
    // |2·p₀ + p₁|²/2, and less.
    assert!(accepted("2*x0 + 2*x1 + 1/2*x2", NonNegative, "", "direct"));
    assert!(!accepted("2*x0 + 2*x1 + 499/1000*x2", NonNegative, "", "direct"));
    assert!(!accepted(square, Positive, "", "(minors . . .)"));
    assert!(!accepted(&format!("{square} - 1"), NonNegative, "", "direct"));
    assert!(!accepted("x0 - 2*x1 + 999999/1000000*x2", NonNegative, "", "direct"));
    assert!(!accepted("x0 - 2*x1 + 999999/1000000*x2", NonNegative, "", "(minors . . .)"));
    assert!(!accepted("x1", NonNegative, "", "direct"));
    assert!(!accepted("x0^2", NonNegative, "", "direct"));
    assert!(!accepted("x0*x2 - x1", NonNegative, "", "direct"));
    for number in ["(minors . .)", "(minors)", "(minors . . . .)", "(sign _ .)"] {
        assert!(!accepted(square, NonNegative, "", number), "{number}");
    }
    // |p₀ − p₁|² + 2(1 − λ) p₀·p₁ for −1 ≤ λ ≤ 1.
    let family = "x0 - 2*x3*x1 + x2";
    assert!(accepted(family, NonNegative, "-1 <= x3 <= 1", "direct"));
    assert!(!accepted(family, NonNegative, "-1 <= x3 <= 2", "direct"));
    assert!(!accepted(family, NonNegative, "", "direct"));
    // On a triangle: u p₀² + 2 u v p₀·p₁ + v p₁², with u v ≥ u²v².
    let on_triangle = "x3*x0 + 2*x3*x4*x1 + x4*x2";
    assert!(accepted(on_triangle, NonNegative, "simplex x3 x4", "direct"));
    assert!(!accepted(on_triangle, NonNegative, "0 <= x3 <= 2, 0 <= x4 <= 2", "direct"));
    // One variable for two products is no dot product.
    let products = vec![(Var(0), (0, 0)), (Var(0), (1, 1))];
    let domain = Rc::new(Domain::default());
    let statement = Statement::Products { value: poly("x0"), relation: NonNegative, products, domain };
    assert!(!self::accepted(&Rc::new(statement), "direct"));
}

#[test]
fn identities() {
    let zero = |value: &str, below: &str| {
        let value = Quotient { numerator: poly(value), denominator: poly(below) };
        Rc::new(Statement::Zero { value, domain: Rc::default() })
    };
    assert!(accepted(&zero("(x0 + 1)^2 - x0^2 - 2*x0 - 1", "x0"), "direct"));
    assert!(!accepted(&zero("(x0 + 1)^2 - x0^2 - 2*x0", "x0"), "direct"));
    assert!(!accepted(&zero("x0 - x0", "x0 - x0"), "direct"));
    assert!(!accepted(&zero("1/1000000000000000000000000000000", "1"), "direct"));
    for other in ["(sign _ .)", "(minors .)", "(rank () ())"] {
        assert!(!accepted(&zero("x0 - x0", "1"), other));
    }
}

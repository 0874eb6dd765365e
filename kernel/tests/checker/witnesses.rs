//! Witnesses: points at which statements fail, and points at which they do not.

use std::rc::Rc;

use basis_kernel::algebra::rational::Rational;
use basis_kernel::algebra::work::Work;
use basis_kernel::{Domain, Quotient, Refutation, Relation, Statement, text};

use crate::tables::{independent, products};
use crate::text::{poly, sign};

/// The value at the witness as text, `-` for none; nothing when it is refused.
fn refuted(statement: &Rc<Statement>, witness: &str) -> Option<String> {
    let read = text::witness(witness).unwrap_or_else(|e| panic!("{witness}: {e}"));
    let refutation = Refutation::new(Rc::clone(statement), read, &mut Work::usual(1)).ok()?;
    Some(refutation.value().map_or_else(|| String::from("-"), Rational::to_string))
}

#[test]
fn signs() {
    let statement = sign("x0^2 - 2 >= 0", "1 <= x0 < 2");
    assert_eq!(refuted(&statement, "(at (x0 1))").as_deref(), Some("-1"));
    for witness in [
        "(at (x0 3/2))",
        "(at (x0 1/2))",
        "(at)",
        "(at (x1 1))",
        "(at (x0 1) (x0 1))",
        "(at (root (-2 0 1) 5/4 3/2) (x0 (0 1)))",
        "(dependent (at (x0 1)) 1)",
        "(independent (at (x0 1)) 0)",
        "(line (at (x0 1)))",
    ] {
        assert_eq!(refuted(&statement, witness), None, "{witness}");
    }
    // Zero at √2 is a counterexample to > 0 alone.
    let strict = sign("x0^2 - 2 > 0", "1 < x0");
    let root = "(at (root (-2 0 1) 5/4 3/2) (x0 (0 1)))";
    assert_eq!(refuted(&strict, root).as_deref(), Some("0"));
    assert_eq!(refuted(&statement, root), None);
    for witness in [
        "(at (root (-2 0 1) 3/2 2) (x0 (0 1)))",
        "(at (root (-2 0 1) 3/2 1) (x0 (0 1)))",
        "(at (root (-2 0 1) -2 2) (x0 (0 1)))",
        "(at (root (-3 0 1) 1 2) (x0 (0 1)))",
        "(at (root (-2 0 1) 5/4 3/2) (x0 (0 0 1)))",
        "(at (root (2) 1 3/2) (x0 (0 1)))",
        "(at (x0 (0 1)))",
    ] {
        assert_eq!(refuted(&strict, witness), None, "{witness}");
    }
    // The ends are not the root itself, and a coordinate is reduced.
    let linear = sign("x0 - 3 > 0", "");
    for witness in [
        "(at (root (-1 0 1) 0 1) (x0 (0 1)))",
        "(at (root (1 0 -1) 1 2) (x0 (0 1)))",
        "(at (root (-2 0 1) 5/4 3/2) (x0 (0 0 1)))",
        "(at (root (-2 0 1) 3/2 5/4) (x0 (0 1)))",
    ] {
        assert_eq!(refuted(&linear, witness), None, "{witness}");
    }
    assert!(refuted(&linear, "(at (root (-2 0 1) 5/4 3/2) (x0 (0 1)))").is_some());
    // Excluded ends, rational and irrational.
    let open = sign("x0 - 3 > 0", "1 < x0 < 2");
    assert_eq!(refuted(&open, "(at (x0 1))"), None);
    assert_eq!(refuted(&open, "(at (x0 2))"), None);
    assert_eq!(refuted(&open, "(at (x0 3/2))").as_deref(), Some("-3/2"));
    assert_eq!(refuted(&open, root).as_deref(), Some("-"));
    // A variable that does not matter has some value of its range, if there is one.
    assert!(refuted(&sign("x0 - 3 > 0", "0 <= x0 <= 1, 0 <= x1 < 1"), "(at (x0 1))").is_some());
    assert_eq!(refuted(&sign("x0 - 3 > 0", "0 <= x0 <= 1, 1 <= x1 < 1"), "(at (x0 1))"), None);
    assert_eq!(refuted(&sign("x0 - 3 > 0", "0 <= x0 <= 1, 0 <= x1 <= 1, 2 <= x1 <= 3"), "(at (x0 1))"), None);
    // A denominator that is negative, and one that vanishes.
    let quotient = sign("x0 // x0 - 1 >= 0", "0 <= x0 <= 2");
    assert_eq!(refuted(&quotient, "(at (x0 1/2))").as_deref(), Some("-1"));
    assert_eq!(refuted(&quotient, "(at (x0 1))"), None);
    assert_eq!(refuted(&quotient, "(at (x0 3/2))"), None);
}

#[test]
fn simplices_and_premises() {
    let triangle = sign("x0*x1*(1 - x0 - x1) > 0", "simplex x0 x1");
    assert_eq!(refuted(&triangle, "(at (x0 1/2) (x1 1/2))").as_deref(), Some("0"));
    for witness in ["(at (x0 1/2) (x1 2/3))", "(at (x0 -1) (x1 1))", "(at (x0 1/3) (x1 1/3))", "(at (x0 0))"]
    {
        assert_eq!(refuted(&triangle, witness), None, "{witness}");
    }
    let value = Quotient::from(poly("x0"));
    for (premise, relation, accepted) in [
        ("1 + x0", Relation::NonNegative, true),
        ("1 + x0", Relation::Positive, false),
        ("x0", Relation::NonNegative, false),
        ("2 + x0", Relation::Positive, true),
    ] {
        let domain = Domain { premises: vec![(poly(premise), relation)], ..Domain::default() };
        let domain = Rc::new(domain);
        let statement = Statement::Sign { value: value.clone(), relation: Relation::NonNegative, domain };
        assert_eq!(refuted(&Rc::new(statement), "(at (x0 -1))").is_some(), accepted, "{premise}");
    }
}

#[test]
fn identities() {
    let value = Quotient { numerator: poly("x0^2 - 2"), denominator: poly("x0 - 2") };
    let statement = Rc::new(Statement::Zero { value, domain: Rc::new(crate::text::domain("0 <= x0")) });
    assert_eq!(refuted(&statement, "(at (x0 1))").as_deref(), Some("1"));
    for witness in ["(at (x0 2))", "(at (x0 -1))", "(at (root (-2 0 1) 5/4 3/2) (x0 (0 1)))"] {
        assert_eq!(refuted(&statement, witness), None, "{witness}");
    }
}

#[test]
fn dependent_and_independent_rows() {
    let statement = independent("x0 - 1, x1; 0, 1", "x0 = 2 & x1 = 0", "0 <= x0 <= 2");
    assert_eq!(refuted(&statement, "(dependent (at (x0 1) (x1 3)) 1 -3)").as_deref(), Some("-"));
    assert_eq!(refuted(&statement, "(independent (at (x0 2) (x1 0)) 0)").as_deref(), Some("-"));
    for witness in [
        "(dependent (at (x0 1) (x1 3)) 1 -2)",
        "(dependent (at (x0 1) (x1 3)) 0 0)",
        "(dependent (at (x0 1) (x1 3)) 1)",
        "(dependent (at (x0 1) (x1 3)) 1 -3 0)",
        "(dependent (at (x0 1)) 1 -3)",
        "(dependent (at (x0 3/2) (x1 3)) 1 -3)",
        "(independent (at (x0 2) (x1 1)) 0)",
        "(independent (at (x0 2) (x1 0)) 1)",
        "(independent (at (x0 2)) 0)",
        "(at (x0 1) (x1 3))",
    ] {
        assert_eq!(refuted(&statement, witness), None, "{witness}");
    }
    // A dependence at an exception refutes nothing, nor does one outside.
    let joint = independent("x0 - 1, x1; 0, 1", "x0 = 1", "0 <= x0 <= 2");
    assert_eq!(refuted(&joint, "(dependent (at (x0 1) (x1 3)) 1 -3)"), None);
    assert_eq!(refuted(&independent("x0 - 3; 0", "", "0 <= x0 <= 2"), "(dependent (at (x0 3)) 1 1)"), None);
    assert_eq!(refuted(&joint, "(independent (at (x0 1) (x1 0)) 0)"), None);
    // Over Q(√2): (1, θ) and (θ, 2).
    let irrational = independent("1, x0; x0, 2", "", "1 < x0 < 2");
    let root = "(at (root (-2 0 1) 5/4 3/2) (x0 (0 1)))";
    assert!(refuted(&irrational, &format!("(dependent {root} (0 1) -1)")).is_some());
    assert!(refuted(&irrational, &format!("(dependent {root} (0 1) (0 -1))")).is_none());
    assert!(refuted(&irrational, &format!("(dependent {root} (0 1) 1)")).is_none());
}

#[test]
fn dot_products_on_a_line() {
    let statement = products("x0 - 2*x1 + x2 - x3", Relation::NonNegative, "0 <= x3 <= 1");
    assert_eq!(refuted(&statement, "(line (at (x3 1)) 0 1 1 1)").as_deref(), Some("-1"));
    assert_eq!(refuted(&statement, "(line (at (x3 1)))").as_deref(), Some("-1"));
    // Every point has its own number.
    let lengths = products("x0 - x2", Relation::NonNegative, "");
    assert_eq!(refuted(&lengths, "(line (at) 0 1 1 2)").as_deref(), Some("-3"));
    assert_eq!(refuted(&lengths, "(line (at) 0 2 1 1)"), None);
    let ranged = products("x0 - 2*x1 + x2 - 1", Relation::NonNegative, "2 <= x0 <= 3");
    assert_eq!(refuted(&ranged, "(line (at))"), None);
    for witness in [
        "(line (at (x3 1)) 0 1 1 3)",
        "(line (at (x3 2)) 0 1 1 1)",
        "(line (at (x3 0)) 0 1 1 1)",
        "(line (at) 0 1 1 1)",
        "(line (at (x1 5) (x3 1)) 0 1 1 1)",
        "(at (x0 1) (x1 1) (x2 1) (x3 1))",
    ] {
        assert_eq!(refuted(&statement, witness), None, "{witness}");
    }
}

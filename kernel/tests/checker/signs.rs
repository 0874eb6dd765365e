//! Certificates of signs: each kind once, with near misses.

use std::rc::Rc;

use basis_kernel::algebra::poly::{Monomial, Poly, Var};
use basis_kernel::algebra::range::{End, Range, Region};
use basis_kernel::algebra::rational::Rational;
use basis_kernel::algebra::work::Work;
use basis_kernel::{
    Certificate, Chart, Domain, Proof, Quotient, Rank, Refusal, Refutation, Relation, SignProof, Simplex,
    Statement, Witness, text,
};

use crate::text::sign;

/// A true claim with a certificate of it, statements that are false or that this certificate does not prove, and
/// certificates that do not prove the claim.
pub(crate) struct Case {
    pub(crate) claim: &'static str,
    pub(crate) on: &'static str,
    pub(crate) certificate: &'static str,
    /// A point of the domain, for statements that are made false there.
    pub(crate) point: &'static [(i64, i64)],
    pub(crate) statements: &'static [(&'static str, &'static str)],
    pub(crate) certificates: &'static [&'static str],
}

/// A number by which true claims become false at a zero.
const TINY: &str = "1/1000000000000000000000000000000";

/// A positive polynomial, with the irrational number √2 among the roots of both projections.
pub(crate) const IRRATIONAL: Case = Case {
    claim: "1 + x0^2 - x0*x1 + x1^2 > 0",
    on: "0 < x0 < 2, 0 < x1 < 2",
    certificate: "(sign _ (slices (\
                  ((x0 x1) ((-2+x0^2 1+x0^2 4+3*x0^2 5-2*x0+x0^2) (1+x0^2-x0*x1+x1^2)) ((5/4 3/2)) ((1 .) (7/4 .))) \
                  ((x1 x0) ((-2+x1^2 1+x1^2 4+3*x1^2 5-2*x1+x1^2) (1+x0^2-x0*x1+x1^2)) ((5/4 3/2)) ((1 .) (7/4 .)))) \
                  ((5/4 3/2 5/4 3/2))))",
    point: &[(1, 1), (1, 1)],
    statements: &[
        ("1 + x0^2 - x0*x1 + x1^2 > 0", "0 < x0 < 2, 0 < x1 <= 2"),
        ("1 + x0^2 - x0*x1 + x1^2 > 0", "0 < x0 < 2, 0 < x1"),
        ("1 + x0^2 - x0*x1 + x1^2 >= 0", "0 < x0 < 2, 0 < x1 < 2"),
        ("1 + x0^2 - 3*x0*x1 + x1^2 > 0", "0 < x0 < 2, 0 < x1 < 2"),
    ],
    certificates: &["(sign _ (slices () ()))", "(sign _ (cells (x0 x1) ((x0) (x1)) ()))"],
};

pub(crate) const CASES: &[Case] = &[
    Case {
        claim: "x0*(1 - x0) >= 0",
        on: "0 <= x0 <= 1",
        certificate: "direct",
        point: &[(1, 1)],
        statements: &[
            ("x0*(1 - x0) >= 0", "0 <= x0 <= 1000000001/1000000000"),
            ("x0*(1 - x0) >= 0", "0 <= x0"),
            ("x0*(1 - x0) > 0", "0 <= x0 < 1"),
            ("x0*(1 - x0) > 0", "0 < x0 <= 1"),
        ],
        certificates: &[
            "(sign + .)",
            "(sign _ (cut x1 . .))",
            "(sign _ (faces . . .))",
            "(minors .)",
            "(rank () ())",
        ],
    },
    Case {
        claim: "x0 - 1/3 // x0^2 - x0 + 1 > 0",
        on: "1/3 < x0",
        certificate: "(sign (+ (cut x0 . .)) .)",
        point: &[(1, 2)],
        statements: &[
            ("x0 - 1/3 // x0^2 - x0 + 1 > 0", "1/3 <= x0"),
            ("x0 - 1/3 // x0^2 - x0 - 1 > 0", "1/3 < x0"),
            ("x0 - 1/3 // x0 - x0 > 0", "1/3 < x0"),
        ],
        certificates: &[
            "(sign _ .)",
            "(sign - .)",
            "(sign (- (cut x0 . .)) .)",
            "(sign (+ (cut x0 . .)) (cut x1 . .))",
        ],
    },
    Case {
        claim: "x0^2 - x0 + 1/3 > 0",
        on: "0 <= x0 <= 1",
        certificate: "(sign _ (cut x0 . .))",
        point: &[(1, 2)],
        statements: &[("x0^2 - x0 + 1/3 > 0", "-1 <= x0 <= 1"), ("x0^2 - x0 + 1/4 > 0", "0 <= x0 <= 1")],
        certificates: &["direct", "(sign _ .)", "(sign _ (cut x0 . (cut x1 . .)))", "(sign _ (factors +))"],
    },
    Case {
        claim: "x0^2*x1 + (1 - x1)*(x0 - 1/3)^2 > 0",
        on: "0 < x0 < 1, 0 < x1 < 1",
        certificate: "(sign _ (corners x1 (factors (-1+3*x0 ^) +) . 1/2 (cut x0 (cut x0 . .) .)))",
        point: &[(1, 3), (1, 2)],
        statements: &[
            ("x0^2*x1 + (1 - x1)*(x0 - 1/3)^2 > 0", "0 < x0 < 1, 0 <= x1 < 1"),
            ("x0^2*x1 + (1 - x1)*(x0 - 1/3)^2 > 0", "0 <= x0 < 1, 0 < x1 <= 1"),
            ("x0^2*x1 + (1 - x1)*(x0 - 1/3)^2 > 0", "0 < x0 < 1, 0 < x1"),
            ("x0^2*x1 + (1 - x1)*(x0 - 1/3)^2 > 0", "0 < x0 < 1"),
        ],
        certificates: &[
            "(sign _ (corners x1 (factors (-1+3*x0 ^) +) .))",
            "(sign _ (corners x1 (factors (-1+3*x0 ^) +) . 1 (cut x0 (cut x0 . .) .)))",
            "(sign _ (corners x1 (factors (-1+3*x0 ^) +) . 3/2 (cut x0 (cut x0 . .) .)))",
            "(sign _ (corners x1 (factors (-1+3*x0 ^) -) . 1/2 (cut x0 (cut x0 . .) .)))",
            "(sign _ (corners x1 (factors (-1+2*x0 ^) +) . 1/2 (cut x0 (cut x0 . .) .)))",
            "(sign _ (corners x1 . (factors (-1+3*x0 ^) +) 1/2 (cut x0 (cut x0 . .) .)))",
            "(sign _ (corners x1 (factors (-1+3*x0 ^) +) . 1/2 .))",
            "(sign _ (corners x0 (factors (-1+3*x0 ^) +) . 1/2 (cut x0 (cut x0 . .) .)))",
        ],
    },
    Case {
        claim: "x0 - x0*x1 + 1 >= 0",
        on: "0 <= x0, x1 <= 1",
        certificate: "(sign _ (corners x1 . .))",
        point: &[(1, 1), (1, 1)],
        statements: &[
            ("x0 - x0*x1 + 1 >= 0", "0 <= x0, x1 <= 2"),
            ("x0 - x0*x1 + 1 >= 0", "x1 <= 1"),
            ("x0 - x0*x1 + 1 >= 0", "0 <= x0"),
        ],
        certificates: &["(sign _ (corners x2 . .))", "(sign _ (corners x1 . . 1 .))"],
    },
    Case {
        claim: "(x0 - x1)^2*(x0 + 1) >= 0",
        on: "0 <= x0 <= 1, 0 <= x1 <= 1",
        certificate: "(sign _ (factors (x0-x1 ^) +))",
        point: &[(1, 2), (1, 2)],
        statements: &[
            ("(x0 - x1)^2*(x0 + 1) >= 0", "-2 <= x0 <= 1, 0 <= x1 <= 1"),
            ("(x0 - x1)^2*(x0 + 1) > 0", "0 <= x0 <= 1, 0 <= x1 <= 1"),
            ("(x0 - x1)^3*(x0 + 1) >= 0", "0 <= x0 <= 1, 0 <= x1 <= 1"),
            ("-1*(x0 - x1)^2*(x0 + 1) >= 0", "0 <= x0 <= 1, 0 <= x1 <= 1"),
        ],
        certificates: &[
            "(sign _ (factors (x0-x1 ^) -))",
            "(sign _ (factors (x0+x1 ^) +))",
            "(sign _ (factors (1+x0 ^) +))",
            "(sign _ (factors (x0-x1 +) +))",
            "(sign _ (factors (2 +) (x0-x1 ^) +))",
        ],
    },
    Case {
        claim: "x0^2 - x0*x1 + x1^2 > 0",
        on: "0 < x0 <= 1, 0 <= x1 <= 1",
        certificate: "(sign _ (faces (slices (((x0 x1) ((x0 1-x0+x0^2) (x0^2-x0*x1+x1^2)) () ((1/2 .)))) ()) . . . . .))",
        point: &[(1, 2), (1, 2)],
        statements: &[
            ("x0^2 - x0*x1 + x1^2 > 0", "0 <= x0 <= 1, 0 <= x1 <= 1"),
            ("x0^2 - x0*x1 + x1^2 > 0", "-1 < x0 <= 1, 0 <= x1 <= 1"),
            ("x0^2 - 2*x0*x1 + x1^2 > 0", "0 < x0 <= 1, 0 <= x1 <= 1"),
        ],
        certificates: &[
            "(sign _ (faces (slices (((x0 x1) ((x0 1-x0+x0^2) (x0^2-x0*x1+x1^2)) () ((1/2 .)))) ()) . . . .))",
            "(sign _ (faces (slices (((x0 x1) ((x0 1-x0+x0^2) (x0^2-x0*x1+x1^2)) () ((3/2 .)))) ()) . . . . .))",
            "(sign _ (faces (slices (((x0 x1) ((x0 1-x0+x0^2) (x0^2-x0*x1+x1^2)) () ())) ()) . . . . .))",
            "(sign _ (faces (slices (((x0 x1) ((1-x0+x0^2) (x0^2-x0*x1+x1^2)) () ((1/2 .)))) ()) . . . . .))",
            "(sign _ (faces (slices (((x0 x1) ((x0) (x0^2-x0*x1+x1^2)) () ((1/2 .)))) ()) . . . . .))",
            "(sign _ (faces (slices (((x1 x0) ((x0 1-x0+x0^2) (x0^2-x0*x1+x1^2)) () ((1/2 .)))) ()) . . . . .))",
            "(sign _ (faces (slices () ()) . . . . .))",
            "(sign _ (faces (slices () (())) . . . . .))",
            "(sign _ (slices (((x0 x1) ((x0 1-x0+x0^2) (x0^2-x0*x1+x1^2)) () ((1/2 .)))) ()))",
        ],
    },
    Case {
        claim: "x0^2 - x0*x1 + x1^2 >= 0",
        on: "0 <= x0 <= 1, 0 <= x1 <= 1",
        certificate: "(sign _ (cells (x0 x1) ((x0 1-x0+x0^2) (x0^2-x0*x1+x1^2)) ((1/2 1/2))))",
        point: &[(0, 1), (0, 1)],
        statements: &[
            ("x0^2 - x0*x1 + x1^2 >= 0", "-1 <= x0 <= 1, 0 <= x1 <= 1"),
            ("x0^2 - x0*x1 + x1^2 > 0", "0 <= x0 <= 1, 0 <= x1 <= 1"),
            ("x0^2 - 3*x0*x1 + x1^2 >= 0", "0 <= x0 <= 1, 0 <= x1 <= 1"),
            ("x0^2 - 2*x0*x1 + x1^2 - 1/1000 >= 0", "0 <= x0 <= 1, 0 <= x1 <= 1"),
        ],
        certificates: &[
            "(sign _ (cells (x1 x0) ((x0 1-x0+x0^2) (x0^2-x0*x1+x1^2)) ((1/2 1/2))))",
            "(sign _ (cells (x0) ((x0 1-x0+x0^2) (x0^2-x0*x1+x1^2)) ((1/2 1/2))))",
            "(sign _ (cells (x0 x1) ((x0) (x0^2-x0*x1+x1^2)) ((1/2 1/2))))",
            "(sign _ (cells (x0 x1) ((1-x0+x0^2) (x0^2-x0*x1+x1^2)) ((1/2 1/2))))",
            "(sign _ (cells (x0 x1) ((x0 1-x0+x0^2) ()) ((1/2 1/2))))",
            "(sign _ (cells (x0 x1) ((x0 1-x0+x0^2) (x0^2-x0*x1+x1^2)) ()))",
            "(sign _ (cells (x0 x1) ((x0 1-x0+x0^2) (x0^2-x0*x1+x1^2)) (1/2)))",
            "(sign _ (cells (x0 x1) ((x0 1-x0+x0^2) (x0^2-x0*x1+x1^2)) ((1/2 (1/2 1/2)))))",
            "(sign _ (cells (x0 x1) ((x0 1-x0+x0^2) (x0^2-x0*x1+x1^2)) ((1/2 3/2))))",
            "(sign _ (cells (x0 x1) ((x0 1-x0+x0^2) (x0^2-x0*x1+x1^2)) ((1/2 1/2) (2/3 1/2))))",
        ],
    },
    Case {
        claim: "1 + x0^4*x1^2 + x0^2*x1^4 - 3*x0^2*x1^2 >= 0",
        on: "",
        certificate: "(sign _ (cells (x0 x1) ((x0 -4+x0^2 -1+x0^2) (1-3*x0^2*x1^2+x0^4*x1^2+x0^2*x1^4)) \
                      ((-3 0) (-3/2 0) (-1/2 0) (1/2 0) (3/2 0) (3 0))))",
        point: &[(1, 1), (1, 1)],
        statements: &[
            ("1 + x0^4*x1^2 + x0^2*x1^4 - 3*x0^2*x1^2 > 0", ""),
            ("1 + x0^4*x1^2 + x0^2*x1^4 - 301/100*x0^2*x1^2 >= 0", ""),
        ],
        certificates: &[
            "(sign _ (cells (x0 x1) ((x0 -4+x0^2 -1+x0^2) (1-3*x0^2*x1^2+x0^4*x1^2+x0^2*x1^4)) \
             ((-3 0) (-3/2 0) (-1/2 0) (1/2 0) (3/2 0))))",
            "(sign _ (cells (x0 x1) ((x0 -4+x0^2) (1-3*x0^2*x1^2+x0^4*x1^2+x0^2*x1^4)) ((-3 0) (-1/2 0) (1/2 0) (3 0))))",
        ],
    },
    Case {
        claim: "(x0*x1 - 1)^2 + x0^2 > 0",
        on: "",
        certificate: "(sign _ (slices (((x0 x1) ((x0) (1+x0^2-2*x0*x1+x0^2*x1^2)) ((= 0 .)) \
                      ((-1 (cut x1 (cut x1 . .) .)) (1 (cut x1 . (cut x1 . .)))))) ()))",
        point: &[(1, 2), (2, 1)],
        statements: &[("(x0*x1 - 1)^2 + x0^2 > 0", "0 <= x0"), ("(x0*x1 - 1)^2 > 0", "")],
        certificates: &[
            "(sign _ (slices (((x0 x1) ((x0) (1+x0^2-2*x0*x1+x0^2*x1^2)) ((0 1/2)) \
             ((-1 (cut x1 (cut x1 . .) .)) (1 (cut x1 . (cut x1 . .)))))) ()))",
            "(sign _ (slices (((x0 x1) ((x0) (1+x0^2-2*x0*x1+x0^2*x1^2)) ((= 1/2 .)) \
             ((-1 (cut x1 (cut x1 . .) .)) (1 (cut x1 . (cut x1 . .)))))) ()))",
            "(sign _ (slices (((x0 x1) ((x0) (1+x0^2-2*x0*x1+x0^2*x1^2)) ((-1/2 1/2)) \
             ((-1 (cut x1 (cut x1 . .) .)) (1 (cut x1 . (cut x1 . .)))))) ()))",
            "(sign _ (slices (((x0 x1) ((x0) (1+x0^2-2*x0*x1+x0^2*x1^2)) () ((-1 (cut x1 (cut x1 . .) .))))) ()))",
        ],
    },
    Case {
        claim: "x0*x1*(1 - x0 - x1) >= 0",
        on: "simplex x0 x1",
        certificate: "direct",
        point: &[(1, 2), (1, 2)],
        statements: &[
            ("x0*x1*(1 - x0 - x1) >= 0", "0 <= x0 <= 1, 0 <= x1 <= 1"),
            ("x0*x1*(1 - x0 - x1) > 0", "simplex x0 x1"),
            ("x0*x1*(1 - x0 - x1) >= 0", "simplex x0 x0"),
            ("x0*x1*(1 - x0 - x1) >= 0", "simplex x0, simplex x1"),
            ("x0*x1*(1 - x0 - x1) >= 0", "simplex x0 x1, 0 <= x0 <= 1"),
            ("x0*x1*(999/1000 - x0 - x1) >= 0", "simplex x0 x1"),
        ],
        certificates: &["(sign _ (cut x0 . .))", "(sign _ (faces .))"],
    },
    Case {
        claim: "x0 - 2 > 0",
        on: "0 <= x0 < 0",
        certificate: "direct",
        point: &[],
        statements: &[("x0 - 2 > 0", "0 <= x0 <= 0"), ("x0 - 2 > 0", "0 <= x0 < 1/1000")],
        certificates: &["(sign _ (cut x0 . .))", "(sign + .)"],
    },
];

pub(crate) fn offer(statement: &Rc<Statement>, certificate: &Certificate) -> Result<Proof, Refusal> {
    Proof::new(Rc::clone(statement), certificate.clone(), &mut Work::usual(1))
}

fn read(certificate: &str) -> Certificate {
    text::certificate(certificate.trim()).unwrap_or_else(|e| panic!("{certificate}: {e}"))
}

#[test]
fn true_claims_are_accepted_and_near_misses_refused() {
    for case in CASES.iter().chain([&IRRATIONAL]) {
        let statement = sign(case.claim, case.on);
        let certificate = read(case.certificate);
        if let Err(refusal) = offer(&statement, &certificate) {
            panic!("{} on {}: {refusal}", case.claim, case.on);
        }
        for (claim, on) in case.statements {
            assert!(offer(&sign(claim, on), &certificate).is_err(), "{claim} on {on}");
        }
        for other in case.certificates {
            assert!(offer(&statement, &read(other)).is_err(), "{} by {other}", case.claim);
        }
        for other in CASES {
            // One of another statement proves this one only where it says nothing that is special to that one.
            if other.certificate.contains("cells") && other.certificate != case.certificate {
                assert!(
                    offer(&statement, &read(other.certificate)).is_err(),
                    "{} by {}",
                    case.claim,
                    other.certificate
                );
            }
        }
    }
}

#[test]
fn a_claim_that_fails_by_next_to_nothing_is_refused() {
    for case in CASES.iter().filter(|c| !c.claim.contains("//") && !c.point.is_empty()) {
        let (text, relation) = case.claim.split_once('>').expect("a relation");
        let statement = sign(case.claim, case.on);
        let Statement::Sign { value, .. } = &*statement else { panic!("a sign") };
        let point: Vec<_> = case.point.iter().map(|(n, d)| Rational::new(*n, *d)).collect();
        let least = crate::value(&value.numerator, &point);
        let lowered = sign(&format!("{text} - ({least}) - {TINY} >{relation}"), case.on);
        assert!(offer(&lowered, &read(case.certificate)).is_err(), "{} on {}", case.claim, case.on);
        let strict = sign(&format!("{text} - ({least}) > 0"), case.on);
        assert!(offer(&strict, &read(case.certificate)).is_err(), "{} on {}", case.claim, case.on);
    }
}

/// Every number of the certificate with irrational sections is changed, every list loses an element.
#[test]
fn no_field_of_a_certificate_with_irrational_sections_may_change() {
    let statement = sign(IRRATIONAL.claim, IRRATIONAL.on);
    let whole = read(IRRATIONAL.certificate);
    let written = text::certificate_text(&whole);
    for (from, to) in [
        ("((5/4 3/2)) ((1 ", "((3/2 5/4)) ((1 "),
        ("((5/4 3/2)) ((1 ", "((5/4 11/8)) ((1 "),
        ("((5/4 3/2)) ((1 ", "((3/2 7/4)) ((1 "),
        ("((5/4 3/2)) ((1 ", "((1/2 3/2)) ((1 "),
        ("((5/4 3/2)) ((1 ", "((5/4 15/8)) ((1 "),
        ("((5/4 3/2)) ((1 ", "((= 7/5 .)) ((1 "),
        ("((5/4 3/2)) ((1 ", "((5/4 3/2) (5/4 3/2)) ((1 "),
        ("((5/4 3/2)) ((1 ", "() ((1 "),
        ("((1 .) (7/4 .))", "((1/2 .) (1 .))"),
        ("((1 .) (7/4 .))", "((1 .) (3 .))"),
        ("((1 .) (7/4 .))", "((7/4 .) (1 .))"),
        ("((1 .) (7/4 .))", "((1 .))"),
        ("((1 .) (7/4 .))", "((1 (cut x0 . .)) (7/4 .))"),
        ("((5/4 3/2 5/4 3/2))", "()"),
        ("((5/4 3/2 5/4 3/2))", "((5/4 3/2))"),
        ("((5/4 3/2 5/4 3/2))", "((5/4 11/8 5/4 3/2))"),
        ("((5/4 3/2 5/4 3/2))", "((5/4 3/2 23/16 3/2))"),
        ("((5/4 3/2 5/4 3/2))", "((3/2 5/4 5/4 3/2))"),
        ("((5/4 3/2 5/4 3/2))", "((5/4 5/3 5/4 3/2))"),
        ("((5/4 3/2 5/4 3/2))", "((5/4 3/2 5/4 3/2) (5/4 3/2 5/4 3/2))"),
        (" 1+x0^2 4+3*x0^2", " 4+3*x0^2"),
        (" 4+3*x0^2", ""),
        (" 5-2*x0+x0^2", ""),
        (" 4+3*x0^2", " 4-3*x0^2"),
        ("(-2+x0^2 ", "("),
        ("(-2+x0^2 ", "(0 "),
        ("(-2+x0^2 ", "(-2+x1^2 "),
        ("(-2+x0^2 ", "(-2+x0^2 -3+x0^2 "),
        ("(-2+x0^2 ", "(-2+x0^2 -2+x0^2 "),
        ("(1+x0^2-x0*x1+x1^2)", "()"),
        ("(1+x0^2-x0*x1+x1^2)", "(2+x0^2-x0*x1+x1^2)"),
        ("(x0 x1)", "(x1 x0)"),
        ("(x1 x0)", "(x0 x1)"),
    ] {
        let changed = written.replacen(from, to, 1);
        assert_ne!(changed, written, "{from}");
        let certificate = text::certificate(&changed).unwrap_or_else(|e| panic!("{from} as {to}: {e}"));
        assert!(offer(&statement, &certificate).is_err(), "{from} as {to}");
    }
    for base in 0..2 {
        let mut less = whole.clone();
        let Certificate::Sign { numerator: SignProof::Slices(slices), .. } = &mut less else {
            panic!("slices")
        };
        slices.bases.remove(base);
        assert!(offer(&statement, &less).is_err());
    }
}

/// A sum of squares that vanish together at an irrational point: all is as it has to be but for the box around it.
#[test]
fn boxes_around_irrational_points_are_checked() {
    let zero = sign("(x0^2 - 2)^2 + (x1^2 - 2)^2 > 0", "0 < x0 < 2, 0 < x1 < 2");
    let base = |x: &str, y: &str| {
        let p = "8-4*x0^2-4*x1^2+x0^4+x1^4";
        let cuts = |y| format!("(cut {y} (cut {y} . .) (cut {y} . .))");
        format!(
            "(({x} {y}) ((-2+{x}^2 8-4*{x}^2+{x}^4) ({p})) ((5/4 3/2)) ((1 {}) (7/4 {})))",
            cuts(y),
            cuts(y)
        )
    };
    let certificate =
        |box_: &str| read(&format!("(sign _ (slices ({} {}) ({box_})))", base("x0", "x1"), base("x1", "x0")));
    let refused = |statement, box_: &str| offer(statement, &certificate(box_)).err();
    let found = Some(Refusal::Unproved("a Bernstein coefficient on a box is not positive"));
    assert_eq!(refused(&zero, "(5/4 3/2 5/4 3/2)"), found);
}

/// Two irrational sections of one variable: a box for each combination, in order.
#[test]
fn boxes_stand_in_order() {
    let statement = sign(IRRATIONAL.claim, IRRATIONAL.on);
    let with = |boxes: &str| {
        let mut certificate = String::from(IRRATIONAL.certificate);
        for variable in ["x0", "x1"] {
            let (from, to) = (format!("((-2+{variable}^2 "), format!("((-2+{variable}^2 -3+{variable}^2 "));
            let sections = "((5/4 3/2) (8/5 15/8)) ((1 .) (31/20 .) (19/10 .))";
            certificate =
                certificate.replacen(&from, &to, 1).replacen("((5/4 3/2)) ((1 .) (7/4 .))", sections, 1);
        }
        certificate.replacen("((5/4 3/2 5/4 3/2))", boxes, 1)
    };
    let accepted = |boxes: &str| offer(&statement, &read(&with(boxes))).is_ok();
    let (two, three) = ("5/4 3/2", "8/5 15/8");
    assert!(accepted(&format!("(({two} {two}) ({two} {three}) ({three} {two}) ({three} {three}))")));
    assert!(!accepted(&format!("(({two} {two}) ({three} {two}) ({two} {three}) ({three} {three}))")));
    assert!(!accepted(&format!("(({two} {two}) ({two} {three}) ({three} {two}) ({two} {two}))")));
    assert!(!accepted(&format!("(({two} {two}) ({two} {three}) ({three} {two}))")));
    let one = offer(
        &sign("1 + x0^2 > 0", "0 < x0 < 1"),
        &read("(sign _ (slices (((x0) ((1+x0^2)) () ((1/2 .)))) ()))"),
    );
    assert_eq!(one.err(), Some(Refusal::Unfit("slices are for two variables or more")));
}

/// Rational sections are the roots between the sectors, in order.
#[test]
fn rational_sections_stand_in_order() {
    let refused = |sections: &str| {
        let levels = "((-1+x0 -5+4*x0 1+x0^2 5+x0^2) (1+x0^2+x1^2))";
        let by = format!("(sign _ (slices (((x0 x1) {levels} ({sections}) ((1/2 .) (9/8 .) (3/2 .)))) ()))");
        offer(&sign("1 + x0^2 + x1^2 > 0", "0 < x0 < 2, 0 < x1 < 2"), &read(&by)).err()
    };
    assert_eq!(refused("(= 1 .) (= 5/4 .)"), None);
    let wrong = Some(Refusal::Unproved("a section is not a root"));
    assert_eq!(refused("(= 5/4 .) (= 1 .)"), wrong);
    assert_eq!(refused("(= 1 .) (= 4/3 .)"), wrong);
    assert_eq!(refused("(= 1 .) (= 1 .)"), wrong);
}

/// Signs of factors multiply, and each face has its own proof.
#[test]
fn factors_and_faces() {
    let square = "0 <= x0 <= 1, 0 <= x1 <= 1";
    let refused = |claim, by: &str| offer(&sign(claim, square), &read(by)).err();
    let both = "(x0 - 2)*(x1 - 3) >= 0";
    assert_eq!(refused(both, "(sign _ (factors (-2+x0 -) (-3+x1 -) +))"), None);
    assert_eq!(refused(both, "(sign _ (factors (-2+x0 -) -))"), None);
    let negative = Some(Refusal::Unproved("the product of the signs is negative"));
    assert_eq!(refused("(x0 - 2)*(3 - x1) >= 0", "(sign _ (factors (-2+x0 -) +))"), negative);
    assert_eq!(refused("x0*(1 + x1) >= 0", "(sign _ (factors (x0 +) +))"), None);
    let foreign = Some(Refusal::Unfit("a factor does not divide the polynomial"));
    assert_eq!(refused("x0 >= 0", "(sign _ (factors (1+x0 +) +))"), foreign);
    let bowl = "x0^2 - x0 + 1/3 + x1 > 0";
    let cut = "(cut x0 . .)";
    assert_eq!(refused(bowl, &format!("(sign _ (faces {cut} {cut} {cut} . . . . . .))")), None);
    for other in [format!(". {cut} {cut} . . . . . ."), format!("{cut} . . {cut} . . {cut} . .")] {
        assert!(refused(bowl, &format!("(sign _ (faces {other}))")).is_some(), "{other}");
    }
}

/// Certificates with as many parts within each other as are allowed, and one more.
#[test]
fn certificates_have_a_largest_depth() {
    use basis_kernel::{Cuts, SignProof};
    let positive = sign("1 + x0 > 0", "0 <= x0 <= 1");
    let nested = |depth: usize, lower: bool| {
        (0..depth).fold(Cuts::None, |inner, _| {
            let (low, high) = if lower { (inner, Cuts::None) } else { (Cuts::None, inner) };
            Cuts::At { var: Var(0), low: Box::new(low), high: Box::new(high) }
        })
    };
    let by = |cuts| Certificate::Sign { denominator: None, numerator: SignProof::Cuts(cuts) };
    for lower in [false, true] {
        assert_eq!(offer(&positive, &by(nested(300, lower))).err(), None);
        let refused = offer(&positive, &by(nested(301, lower))).err();
        assert_eq!(refused, Some(Refusal::Unfit("the cells are nested too deeply")));
    }
    // 1 + x₀ + x₁ + … at the lower ends of its variables, one after the other.
    for (count, refused) in [(100, None), (101, Some(Refusal::Unfit("the proof is nested too deeply")))] {
        let variables: Vec<Var> = (0..count).map(Var).collect();
        let sum = variables.iter().fold(Poly::one(), |sum, v| &sum + &Poly::var(*v));
        let proof = variables.iter().rev().fold(SignProof::direct(), |inner, var| SignProof::Corners {
            var: *var,
            low: Box::new(inner),
            high: Box::new(SignProof::direct()),
            middle: None,
        });
        let ranges =
            variables.iter().map(|v| (*v, Range { low: End::Included(Rational::ZERO), high: End::Infinite }));
        let domain = Rc::new(Domain::of(Region { ranges: ranges.collect() }));
        let statement = Statement::Sign { value: sum.into(), relation: Relation::Positive, domain };
        let certificate = Certificate::Sign { denominator: None, numerator: proof };
        assert_eq!(offer(&Rc::new(statement), &certificate).err(), refused, "{count}");
    }
}

/// The point between the ends at which a polynomial of degree 1 is positive is not an end.
#[test]
fn a_middle_lies_inside() {
    for claim in ["1 - x0 > 0", "x0 > 0"] {
        let statement = sign(claim, "0 < x0 < 1");
        let at = |middle: &str| read(&format!("(sign _ (corners x0 . . {middle} .))"));
        assert!(offer(&statement, &at("1/2")).is_ok());
        assert!(offer(&statement, &at("0")).is_err());
        assert!(offer(&statement, &at("1")).is_err());
    }
}

/// Squares have positive factors, and what is left of the polynomial has to be as claimed.
#[test]
fn sums_of_squares_are_subtracted() {
    let refused = |claim: &str, by: &str| offer(&sign(claim, ""), &read(by)).err();
    let by = "(sign _ (squares (2 1/2*x0-x1) (1 x0) .))";
    assert_eq!(refused("3/2*x0^2 - 2*x0*x1 + 2*x1^2 >= 0", by), None);
    assert_eq!(refused("3/2*x0^2 - 2*x0*x1 + 2*x1^2 + 1 > 0", by), None);
    assert_eq!(
        refused("3/2*x0^2 - 2*x0*x1 + 2*x1^2 > 0", by),
        Some(Refusal::Unproved("a number is not as claimed"))
    );
    assert_eq!(
        refused("3/2*x0^2 - 2*x0*x1 + 2*x1^2 - 1 >= 0", by),
        Some(Refusal::Unproved("a number is not as claimed"))
    );
    // Less of one square is what is left, in which no square may be missing.
    assert!(refused("x0^2 + x1^2 - x0*x1 >= 0", "(sign _ (squares (1 x0) .))").is_some());
    for factor in ["0", "-1"] {
        let by = format!("(sign _ (squares ({factor} x0-x1) .))");
        let message = "a square is multiplied by a number that is not positive";
        assert_eq!(refused("-x0^2 + 2*x0*x1 - x1^2 >= 0", &by), Some(Refusal::Unproved(message)));
    }
    let other = refused("x0^2 >= 0", "(sign _ (squares (1 x2) .))");
    assert_eq!(other, Some(Refusal::Unfit("a part has other variables than the whole")));
}

/// What has to be made of the polynomials of lower levels, and what has not.
#[test]
fn projections_are_complete() {
    let square = "0 <= x0 <= 1, 0 <= x1 <= 1";
    let refused = |claim, on, by: &str| offer(&sign(claim, on), &read(by)).err();
    // An end may be a root everywhere, as a factor of its own.
    let by = "(sign _ (cells (x0 x1) ((x0 1-x0+x0^2) (-1+x1 x0^2-x0*x1+x1^2)) ((1/2 1/2))))";
    assert_eq!(refused("(1 - x1)*(x0^2 - x0*x1 + x1^2) >= 0", square, by), None);
    let by = "(sign _ (cells (x0 x1) ((x0 1+x0) (x0+x1-x0*x1-x1^2)) ((1/2 1/2))))";
    let zero = Some(Refusal::Unproved("a projection is zero"));
    assert_eq!(refused("(1 - x1)*(x0 + x1) >= 0", square, by), zero);
    let by = "(sign _ (cells (x0 x1) ((x0) (1+x0 x0+x1)) ((1/2 1/2))))";
    let wrong = Some(Refusal::Unfit("a polynomial is on the wrong level"));
    assert_eq!(refused("x0 + x1 >= 0", square, by), wrong);
    // With three variables the trailing coefficients are projected too, but for a variable itself.
    let by = "(sign _ (slices (((x0 x1 x2) ((x0 1+x0) (x1 1+x0*x1) (x2+x0*x1)) () ((1/2 .)))) ()))";
    assert_eq!(refused("x0*x1 + x2 > 0", "0 < x0 < 1, 0 < x1 < 1, 0 < x2 < 1", by), None);
    let base = |of_x1: &str| {
        let levels = format!("((x0 1+x0 2+x0) ({of_x1}1+x0*x1 2+x0*x1) (x2+x0*x1))");
        format!("(sign _ (slices (((x0 x1 x2) {levels} () ((1/2 .)))) ()))")
    };
    let on = "0 < x0 < 1, 0 < x1 < 1, 1 < x2 < 2";
    assert_eq!(refused("x0*x1 + x2 > 0", on, &base("x1 ")), None);
    let lacks = Some(Refusal::Unproved("a projection has a factor that the levels lack"));
    assert_eq!(refused("x0*x1 + x2 > 0", on, &base("")), lacks);
}

/// The combination would vanish if exponents wrapped: x^65535 times x is not 1.
#[test]
fn exponents_do_not_wrap() {
    let x = crate::text::poly("x0");
    let high = Poly::term(Monomial::one().with_exponent(Var(0), u16::MAX), Rational::ONE);
    let rows = vec![vec![x, Poly::one()], vec![Poly::one(), high.clone()]];
    let except = vec![vec![(Var(1), Rational::ZERO)]];
    let region = crate::text::region("0 <= x1 <= 0");
    let statement = Rc::new(Statement::Independent { rows, except, region });
    let rank = Rank { pieces: Vec::new(), exceptions: vec![vec![high.clone(), -&Poly::one()]] };
    assert_eq!(offer(&statement, &Certificate::Rank(rank)).err(), Some(Refusal::Spent));
    // u^40000 (1 − u − v)^40000 on a triangle.
    let power = |v| Poly::term(Monomial::one().with_exponent(Var(v), 40_000), Rational::ONE);
    let value = Quotient::from(&power(0) * &power(1));
    let domain = Rc::new(crate::text::domain("simplex x0 x1"));
    let statement = Statement::Sign { value, relation: Relation::NonNegative, domain };
    assert_eq!(offer(&Rc::new(statement), &Certificate::Direct).err(), Some(Refusal::Spent));
}

/// Long numbers to high powers are counted before they are computed.
#[test]
fn work_is_counted_before_it_is_done() {
    let huge = format!("1{}", "0".repeat(50_000));
    let p = "x0^60*x1^60 + 1";
    for certificate in [
        format!("(sign _ (corners x0 . . {huge} .))"),
        format!("(sign _ (slices (((x0 x1) ((x0) (x1)) () (({huge} .)))) ()))"),
        format!("(sign _ (cells (x0 x1) ((x0) (1+x0^60*x1^60)) (({huge} {huge}))))"),
    ] {
        let statement = sign(&format!("{p} >= 0"), "0 <= x0, 0 <= x1");
        assert!(offer(&statement, &read(&certificate)).is_err());
        let statement = sign(&format!("{p} > 0"), "0 < x0, 0 < x1");
        assert!(offer(&statement, &read(&certificate)).is_err());
    }
    // The work itself is too large for a machine word.
    let far = Rational::from(2).pow(40_000_000);
    let terms = (60_000..65_000).map(|e| (Monomial::one().with_exponent(Var(0), e), Rational::ONE));
    assert_eq!(Work::new(u64::MAX - 1).spend_at(&Poly::from_terms(terms), Var(0), &far), None);
    let point = format!("(at (root (-2 0 1) 1 {huge}) (x0 (0 1)) (x1 {huge}))");
    let Ok(Witness::At(point)) = text::witness(&point) else { panic!("a point") };
    let value = Quotient::from(crate::text::poly("-1*x0^60*x1^60"));
    let domain = Rc::new(Domain::default());
    let statement = Rc::new(Statement::Sign { value, relation: Relation::NonNegative, domain });
    let refused = Refutation::new(statement, Witness::At(point), &mut Work::new(1_000_000));
    assert_eq!(refused.err(), Some(Refusal::Spent));
}

/// Nothing but computing shows which sign the denominator has, if the certificate says nothing more; a certificate of a
/// sign says it.
#[test]
fn denominators_of_direct_certificates() {
    let direct = Certificate::Direct;
    let said =
        |denominator: &str| text::certificate(&format!("(sign {denominator} .)")).expect("a certificate");
    for (claim, sign_of_denominator) in [("x0 // 1 + x0 >= 0", "+"), ("-x0 // -1 - x0 >= 0", "-")] {
        let statement = sign(claim, "0 <= x0 <= 1");
        assert!(offer(&statement, &direct).is_ok(), "{claim}");
        assert!(offer(&statement, &said(sign_of_denominator)).is_ok(), "{claim}");
        assert!(offer(&statement, &said("_")).is_err(), "{claim}");
    }
    assert!(offer(&sign("-x0 // 1 + x0 >= 0", "0 <= x0 <= 1"), &direct).is_err());
    assert!(offer(&sign("x0 // x0 - 1/2 >= 0", "0 <= x0 <= 1"), &direct).is_err());
    assert!(offer(&sign("x0 // 2 >= 0", "0 <= x0 <= 1"), &said("_")).is_ok());
    assert!(offer(&sign("x0 // 2 >= 0", "0 <= x0 <= 1"), &said("+")).is_err());
}

/// x₁ = c(1 − s₁), x₂ = c·s₁(1 − s₂), in variables of the box that occur nowhere else.
#[test]
fn a_simplex_is_the_image_of_a_box() {
    let [x, y] = [Var(0), Var(1)];
    let triangle = Simplex { variables: vec![x, y], sum: Rational::from(3) };
    let domain =
        Domain { region: Region { ranges: Vec::new() }, simplices: vec![triangle], premises: Vec::new() };
    let value = &Poly::var(x) + &Poly::var(y);
    let chart = Chart::new(&domain, [&value, &Poly::one()]).expect("a triangle");
    let [s1, s2] = [2, 3].map(|k| Poly::var(Var(k)));
    let (one, c) = (Poly::one(), Poly::integer(3));
    let first = &c * &(&one - &s1);
    let second = &(&c * &s1) * &(&one - &s2);
    assert_eq!(chart.variables(), [(x, first), (y, second)]);
    let box_variables: Vec<Var> = chart.region().ranges.iter().map(|(var, _)| *var).collect();
    assert_eq!(box_variables, [Var(2), Var(3)]);
}

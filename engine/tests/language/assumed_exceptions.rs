//! Independence with exceptions where what is assumed is no part of a box.

use basis_engine::{Source, Verdict, check};

use crate::assumed::refuted;

#[test]
fn exceptions_where_assumptions_hold() {
    let found = refuted(
        "family Disk {
            domain 0 <= t <= 1;
            shape p, q;
            assume p^2 + q^2 <= 1;
            b[0] = 1 + p*t;
            b[1] = t + p;
            prove independent except p = 1, p = -1;
            refute independent except p = 1;
            refute independent except p = 1, p = -1, q = 0;
            refute independent;
        }
        family Apart {
            domain 0 <= t <= 1;
            shape p, q;
            assume p^2 + q^2 <= 1;
            b[0] = 1 + p*t;
            b[1] = t + q;
            prove independent;
            refute independent except (p = 0, q = 1);
        }
        family Hyperbola {
            domain 0 <= t <= 1;
            shape p, q;
            assume p*q >= 1;
            assume p <= 1;
            b[0] = p + t;
            b[1] = 1 + t;
            prove independent except p = 1;
            refute independent except (p = 1, q = 1);
        }
        family Quotients {
            domain 0 <= t <= 1;
            shape 0 <= p <= 1, 0 <= q <= 1;
            assume p*q >= 1/4;
            b[0] = (1 - t)/(p + q - 1/2);
            b[1] = (p - q)*t;
            refute independent except p = 1;
            refute independent except (p = 1, q = 1);
        }",
    );
    assert!(found[0].starts_with("0 at p = -1, q = 0"), "{found:?}");
    assert!(found[3].starts_with("1 at p = 0, q = 1"), "{found:?}");
}

/// What is wrong with an exception is said in words.
#[test]
fn an_exception_that_is_none() {
    let spec = "family F {
        domain 0 <= t <= 1;
        shape p, q;
        assume p^2 + q^2 <= 1;
        b[0] = 1 + p*t;
        b[1] = t + q;
        refute independent except (p = 0, q = 1);
    }";
    let report = check(Source::text("exception.basis", spec));
    let [(_, Verdict::Refuted(witness))] = &report.items[0].claims[..] else { panic!("refuted") };
    let note = "the functions are independent at p = 0, q = 1, so (p = 0, q = 1) is no exception";
    assert_eq!(witness.notes, [note]);
}

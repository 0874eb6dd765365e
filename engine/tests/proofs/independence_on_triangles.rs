//! Independence of families whose coefficient tables are too large for one determinant: their symmetries cut them into
//! small blocks.

use std::rc::Rc;

use basis_engine::algebra::rational::Rational;
use basis_engine::algebra::work::Work;
use basis_engine::{Disk, Library, Prover, Source, Subject, state};
use basis_kernel::{Certificate, Proof, Statement};
use basis_prover::{Failure, decide};

#[test]
fn symmetric_families_fall_apart() {
    let spec = include_str!("../../../specs/triangular.basis");
    let report = |name: &str, n: i64| {
        let library = Library::from_source(&Disk, &Prover, Source::text("triangular.basis", spec));
        let item = library.item(name, &[n]).expect("an order of the family");
        let Subject::Family(family) = &item.subject else { panic!("a family") };
        let state::Table { rows, symmetries } = state::table(family);
        let statement = Statement::Independent { rows, except: Vec::new(), region: family.shape_region() };
        match decide(statement.clone(), &symmetries, 1) {
            Ok(shown) => {
                // A change of one number of the bases shows.
                if let Certificate::Rank(rank) = shown.proof.certificate() {
                    let mut wrong = rank.clone();
                    if let Some(change) = &mut wrong.pieces[0].change {
                        change.columns[0][0].1 = &change.columns[0][0].1 + &Rational::ONE;
                        let statement = Rc::new(statement);
                        let proof = Proof::new(statement, Certificate::Rank(wrong), &mut Work::usual(1));
                        assert!(proof.is_err());
                    }
                }
                String::from("proved")
            }
            Err(Failure::Refuted(found)) => {
                let point: Vec<String> =
                    found.point.iter().map(|(v, c)| c.describe(&family.names[v.0])).collect();
                point.join(", ")
            }
            Err(Failure::Undecided(left)) => format!("undecided: {left}"),
        }
    };
    for n in [2, 3, 5, 8] {
        assert_eq!(report("TriangularI", n), "proved", "n = {n}");
    }
    assert_eq!(report("TriangularII", 3), "λ1 = 1, λ2 = 0");
    assert_eq!(report("TriangularII", 4), "proved");
    assert_eq!(report("TriangularII", 5), "λ1 = 1/2, λ2 = 1");
    assert_eq!(report("TriangularII", 6), "λ1 = -31/18 + 5/18*sqrt(73), λ2 = 1");
}

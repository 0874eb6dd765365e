//! Independence of families whose coefficient tables are too large for one determinant: their symmetries cut them into
//! small blocks.

use basis_engine::algebra::rational::Rational;
use basis_engine::decide::{Budget, Independence, independent, verify_independence};
use basis_engine::prove::coefficient_table;
use basis_engine::{Disk, Library, Source};

#[test]
fn symmetric_families_fall_apart() {
    let spec = include_str!("../../specs/triangular.basis");
    let report = |name: &str, n: i64| {
        let library = Library::from_source(&Disk, Source::text("triangular.basis", spec));
        let item = library.item(name, &[n]).expect("an order of the family");
        let table = coefficient_table(&item.family);
        let region = item.family.shape_region();
        match independent(&table, &[], &region, &mut Budget::default()) {
            Independence::Proved(pieces) => {
                assert_eq!(verify_independence(&table.rows, &[], &region, &pieces, 1).err(), None);
                // A change of one number of the bases shows.
                let mut wrong = pieces.clone();
                if let Some(change) = &mut wrong[0].change {
                    change.columns[0][0].1 = &change.columns[0][0].1 + &Rational::ONE;
                    assert!(verify_independence(&table.rows, &[], &region, &wrong, 1).is_err());
                }
                String::from("proved")
            }
            Independence::Refuted(d) => {
                let names = &item.family.names;
                let point: Vec<String> = d.point.iter().map(|(v, c)| c.describe(&names[v.0])).collect();
                point.join(", ")
            }
            Independence::Undecided(left) => format!("undecided: {left}"),
        }
    };
    for n in [2, 3, 5, 8] {
        assert_eq!(report("TriangularI", n), "proved", "n = {n}");
    }
    assert_eq!(report("TriangularII", 3), "λ1 = 1, λ2 = 0");
    assert_eq!(report("TriangularII", 4), "proved");
    assert_eq!(report("TriangularII", 5), "λ1 = 1/2, λ2 = 1");
    assert_eq!(
        report("TriangularII", 6),
        "λ1 = root of -24 + 31*λ1 + 9*λ1^2 between 0.651 and 0.652, λ2 = 1"
    );
}

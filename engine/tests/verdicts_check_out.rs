//! Every verdict on the shipped specs checks out: proofs against their statements, witnesses against their expressions.

use std::path::Path;

use basis_engine::prove::check;
use basis_engine::{Disk, Verdict, source};

#[test]
fn shipped_specs() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs");
    let mut counts = [0, 0];
    for entry in std::fs::read_dir(folder).expect("the folder of specs") {
        let path = entry.expect("an entry").path();
        if path.extension().is_none_or(|e| e != "basis") {
            continue;
        }
        let name = path.to_str().expect("Unicode");
        let report = basis_engine::check(source::read(&Disk, name, &[]).expect("a spec"));
        for item in &report.items {
            for (claim, verdict) in &item.claims {
                let title = format!("{}: {}", item.family.title(), claim.text);
                match verdict {
                    Verdict::Proved(evidence) => {
                        assert_eq!(check::evidence(&item.family, claim, evidence), Ok(()), "{title}");
                        counts[0] += 1;
                    }
                    Verdict::Refuted(witness) => {
                        assert_eq!(
                            check::witness(&item.family, claim, witness),
                            Ok(()),
                            "{title}: {witness:?}"
                        );
                        counts[1] += 1;
                    }
                    Verdict::Undecided(left) => panic!("{title}: {left}"),
                }
            }
        }
    }
    assert!(counts[0] > 1000 && counts[1] > 20, "{counts:?}");
}

//! Every verdict on the shipped specs checks out again from the text of its certificate.

use std::path::Path;

use crate::support::recheck;
use basis_engine::{Disk, Verdict, source};

#[test]
fn shipped_specs() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs");
    let mut counts = [0, 0];
    let mut folders = vec![folder];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("the folder of specs") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            if path.extension().is_none_or(|e| e != "basis") {
                continue;
            }
            let name = path.to_str().expect("Unicode");
            let report = basis_engine::check(source::read(&Disk, name, &[]).expect("a spec"));
            for item in &report.items {
                for (claim, verdict) in &item.claims {
                    let title = format!("{}: {}", item.subject.title(), claim.text);
                    assert_eq!(recheck(&item.subject, claim, verdict), Ok(()), "{title}");
                    match verdict {
                        Verdict::Proved(_) => counts[0] += 1,
                        Verdict::Refuted(_) => counts[1] += 1,
                        Verdict::Undecided(_) if claim.expected.keyword() == "conjecture" => {}
                        Verdict::Undecided(left) => panic!("{title}: {left}"),
                    }
                }
            }
        }
    }
    assert!(counts[0] > 4000 && counts[1] > 200, "{counts:?}");
}

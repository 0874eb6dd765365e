//! A checker in Python, `tests/oracle/verify.py`, against the kernel: both accept the certificates and witnesses of all
//! shipped specs, and of corrupted ones both refuse the same.
//!
//! `cargo test` sends a sample; all of it, with a fresh seed or the one in `SEED`, and `CORRUPTED` for another number than
//! 10 000: `cargo test -p basis-engine --features tools --test proofs oracle -- --ignored --nocapture`. `KEEP` names a file for
//! what was sent. Without Python nothing is compared.

use std::collections::{BTreeMap, HashSet};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::rc::Rc;

use basis_engine::algebra::poly::Poly;
use basis_engine::algebra::range::{End, Range};
use basis_engine::algebra::rational::Rational;
use basis_engine::algebra::work::Work;
use basis_engine::{Disk, Verdict, source};
use basis_kernel::{Domain, Proof, Refutation, Relation, Statement, text};
use basis_test_support::{Random, statement_text};

/// What is offered for a statement.
#[derive(Clone)]
enum Offer {
    Certificate(String),
    Witness(String),
}

/// A statement with what is offered for it.
struct Entry {
    statement: Statement,
    offer: Offer,
}

impl Entry {
    /// The line for Python: with `true`, or why the kernel refuses.
    fn line(&self, work: &mut Work) -> String {
        let statement = Rc::new(self.statement.clone());
        let (key, offered, verdict) = match &self.offer {
            Offer::Certificate(own) => {
                let read = text::certificate(own);
                ("certificate", own, read.and_then(|own| Proof::new(statement, own, work).map(|_| ())))
            }
            Offer::Witness(own) => {
                let read = text::witness(own);
                ("witness", own, read.and_then(|own| Refutation::new(statement, own, work).map(|_| ())))
            }
        };
        let kernel = match verdict {
            Ok(()) => String::from("true"),
            Err(refusal) => format!("{:?}", refusal.to_string()),
        };
        let statement = statement_text(&self.statement);
        format!("{{\"statement\": {statement:?}, \"{key}\": {offered:?}, \"kernel\": {kernel}}}\n")
    }
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The files of specs below a folder, in the order of their names.
fn specs(folder: &Path, found: &mut Vec<PathBuf>) {
    let entries = std::fs::read_dir(folder).expect("a folder");
    let mut paths: Vec<PathBuf> = entries.map(|e| e.expect("an entry").path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            specs(&path, found);
        } else if path.extension().is_some_and(|e| e == "basis") {
            found.push(path);
        }
    }
}

/// Every statement of the specs with the certificate or the witness that was found for it, each once.
fn shipped() -> Vec<Entry> {
    let mut paths = vec![root().join("tests/oracle/kinds.basis")];
    specs(&root().join("specs"), &mut paths);
    let mut seen = HashSet::new();
    let mut entries = Vec::new();
    for path in paths {
        let report =
            basis_engine::check(source::read(&Disk, path.to_str().expect("Unicode"), &[]).expect("a spec"));
        for item in &report.items {
            for (claim, verdict) in &item.claims {
                let mut put = |statement: &Statement, offer: Offer| {
                    let (Offer::Certificate(own) | Offer::Witness(own)) = &offer;
                    if seen.insert(format!("{} {own}", statement_text(statement))) {
                        entries.push(Entry { statement: statement.clone(), offer });
                    }
                };
                match verdict {
                    Verdict::Proved(evidence) => {
                        for (_, proof) in evidence.steps() {
                            let own = text::certificate_text(proof.certificate());
                            put(proof.statement(), Offer::Certificate(own));
                        }
                    }
                    Verdict::Refuted(witness) => {
                        let refutation = witness.refutation();
                        let own = text::witness_text(refutation.witness());
                        put(refutation.statement(), Offer::Witness(own));
                    }
                    Verdict::Undecided(_) if claim.expected.keyword() == "conjecture" => {}
                    Verdict::Undecided(left) => panic!("{}: {left}", claim.text),
                }
            }
        }
    }
    entries
}

/// Random changes.
struct Corruption<'r>(&'r mut Random);

impl Corruption<'_> {
    fn one(&mut self, in_how_many: usize) -> bool {
        self.0.below(in_how_many) == 0
    }

    fn number(&mut self) -> Rational {
        let n = self.0.between(-4, 4);
        if self.one(6) { Rational::new(n, 1_000_000_000) } else { Rational::new(n, self.0.between(1, 4)) }
    }

    fn poly(&mut self, p: &Poly) -> Poly {
        let variables = p.variables();
        match self.0.below(6) {
            0 => -p,
            1 => p + &Poly::constant(self.number()),
            2 if !variables.is_empty() => p.derivative(variables[self.0.below(variables.len())]),
            3 if !variables.is_empty() => {
                let x = Poly::var(variables[self.0.below(variables.len())]);
                &(p * &x) + &Poly::constant(self.number())
            }
            _ => {
                let (at, number) = (self.0.below(p.len()), self.number());
                let term = p.terms().nth(at).map(|(m, _)| Poly::term(m.clone(), number));
                p + &term.unwrap_or_default()
            }
        }
    }

    fn range(&mut self, range: &mut Range) {
        let mut x = self.number();
        let end = if self.one(2) { &mut range.low } else { &mut range.high };
        if let Some(old) = end.value()
            && self.0.below(3) > 0
        {
            x = if self.one(2) { old.clone() } else { old + &x };
        }
        *end = match self.0.below(5) {
            0 => End::Infinite,
            1 | 2 => End::Included(x),
            _ => End::Excluded(x),
        };
    }

    fn domain(&mut self, domain: &Domain) -> Rc<Domain> {
        let mut domain = domain.clone();
        let (n, m) = (domain.region.ranges.len(), domain.simplices.len());
        if m > 0 && self.one(2) {
            let simplex = &mut domain.simplices[self.0.below(m)];
            if self.one(2) {
                simplex.sum = self.number();
            } else {
                let _ = simplex.variables.pop();
            }
        } else if n > 0 {
            let k = self.0.below(n);
            if self.one(5) {
                domain.region.ranges.remove(k);
            } else {
                self.range(&mut domain.region.ranges[k].1);
            }
        }
        Rc::new(domain)
    }

    fn statement(&mut self, statement: &mut Statement) {
        match statement {
            Statement::Zero { value, domain } | Statement::Sign { value, domain, .. } if self.one(3) => {
                if self.one(3) {
                    value.denominator = self.poly(&value.denominator);
                } else {
                    *domain = self.domain(domain);
                }
            }
            Statement::Zero { value, .. } => value.numerator = self.poly(&value.numerator),
            Statement::Sign { value, relation, .. } => {
                if self.one(3) {
                    *relation = other(*relation);
                } else {
                    value.numerator = self.poly(&value.numerator);
                }
            }
            Statement::Products { value, relation, products, domain } => match self.0.below(4) {
                0 => *relation = other(*relation),
                1 => *domain = self.domain(domain),
                2 if !products.is_empty() => {
                    let k = self.0.below(products.len());
                    products[k].1.0 = self.0.below(3);
                }
                _ => *value = self.poly(value),
            },
            Statement::Independent { rows, except, region } => match self.0.below(6) {
                0 if !except.is_empty() => {
                    let _ = except.pop();
                }
                1 if !except.is_empty() => {
                    let k = self.0.below(except.len());
                    if let Some((_, x)) = except[k].first_mut() {
                        *x = self.number();
                    }
                }
                2 if !region.ranges.is_empty() => {
                    let k = self.0.below(region.ranges.len());
                    self.range(&mut region.ranges[k].1);
                }
                3 => {
                    let (i, j) = (self.0.below(rows.len()), self.0.below(rows.len()));
                    rows[i] = rows[j].clone();
                }
                _ => {
                    let i = self.0.below(rows.len());
                    if !rows[i].is_empty() {
                        let j = self.0.below(rows[i].len());
                        rows[i][j] = self.poly(&rows[i][j]);
                    }
                }
            },
        }
    }

    /// A text with some of its brackets, blanks and words changed.
    fn text(&mut self, text: &mut String) {
        const WORDS: [&str; 24] = [
            ".",
            "+",
            "-",
            "^",
            "_",
            "=",
            "x0",
            "x1",
            "x2",
            "0",
            "1",
            "-1",
            "1/2",
            "1/3",
            "()",
            "direct",
            "(sign _ .)",
            "(cut x0 . .)",
            "(cut x1 . .)",
            "(cut x0 . (cut x0 . .))",
            "(corners x0 . .)",
            "(corners x1 . . 1/2 .)",
            "(faces . . .)",
            "1-x0",
        ];
        let mut words: Vec<String> = Vec::new();
        let mut in_word = false;
        for c in text.chars() {
            let own = !matches!(c, '(' | ')' | ' ');
            match words.last_mut() {
                Some(word) if own && in_word => word.push(c),
                _ => words.push(c.to_string()),
            }
            in_word = own;
        }
        let is_word = |w: &String| !matches!(w.as_str(), "(" | ")" | " ");
        let places: Vec<usize> = (0..words.len()).filter(|k| is_word(&words[*k])).collect();
        let Some(k) = places.get(self.0.below(places.len())).copied() else { return };
        match self.0.below(12) {
            0..=3 => words[k] = String::from(WORDS[self.0.below(WORDS.len())]),
            4 | 5 => {
                let other = words[places[self.0.below(places.len())]].clone();
                words[k] = other;
            }
            6 | 7 => {
                if let Some(x) = Rational::parse(&words[k]) {
                    words[k] = (&x + &self.number()).to_string();
                } else {
                    words[k] = String::from(WORDS[self.0.below(6)]);
                }
            }
            8 if k > 0 => drop(words.drain(k - 1..=k)),
            9 => {
                let own = words[k].clone();
                words.splice(k..k, [own, String::from(" ")]);
            }
            10 => {
                // A list instead of one of its words, or a list twice.
                let opens: Vec<usize> = (0..words.len()).filter(|k| words[*k] == "(").collect();
                if let Some(start) = opens.get(self.0.below(opens.len())).copied() {
                    let mut depth = 0;
                    let length = words[start..].iter().position(|w| {
                        depth += i32::from(w == "(") - i32::from(w == ")");
                        depth == 0
                    });
                    let list: Vec<String> = words[start..=start + length.unwrap_or(0)].to_vec();
                    words.splice(k..=k, list);
                }
            }
            _ => {
                let any = self.0.below(words.len());
                words[any] = String::from(["(", ")", " ", "", "  "][self.0.below(5)]);
            }
        }
        *text = words.concat();
    }

    fn entry(&mut self, entry: &Entry) -> Entry {
        let mut new = Entry { statement: entry.statement.clone(), offer: entry.offer.clone() };
        let is_direct = matches!(&entry.offer, Offer::Certificate(own) if own == "direct");
        loop {
            if self.0.below(5) < if is_direct { 4 } else { 2 } {
                self.statement(&mut new.statement);
            } else {
                let (Offer::Certificate(own) | Offer::Witness(own)) = &mut new.offer;
                self.text(own);
            }
            if !self.one(4) {
                return new;
            }
        }
    }
}

const fn other(relation: Relation) -> Relation {
    match relation {
        Relation::NonNegative => Relation::Positive,
        Relation::Positive => Relation::NonNegative,
    }
}

/// Has Python look at every `step`-th statement of the specs and at corrupted ones.
fn compare(seed: u64, step: usize, corrupted: usize) {
    if !Command::new("python3").arg("--version").output().is_ok_and(|said| said.status.success()) {
        eprintln!("skipped: there is no python3");
        return;
    }
    eprintln!("SEED={seed}");
    let entries = shipped();
    let mut lines = String::new();
    for entry in entries.iter().step_by(step) {
        let line = entry.line(&mut Work::usual(1));
        assert!(line.ends_with("\"kernel\": true}\n"), "{line}");
        lines += &line;
    }
    // What is short is corrupted; every third time what is only computed, else each kind of certificate as often.
    let mut kinds: BTreeMap<Vec<&str>, Vec<&Entry>> = BTreeMap::new();
    for entry in entries.iter().filter(|e| statement_text(&e.statement).len() < 3000) {
        let (Offer::Certificate(own) | Offer::Witness(own)) = &entry.offer;
        let mut words: Vec<&str> =
            own.split(|c: char| !c.is_ascii_lowercase()).filter(|w| w.len() > 1).collect();
        words.sort_unstable();
        words.dedup();
        kinds.entry(words).or_default().push(entry);
    }
    let direct = &kinds[&vec!["direct"]];
    let kinds: Vec<&Vec<&Entry>> = kinds.values().collect();
    let random = &mut Random::new(seed);
    for k in 0..corrupted {
        let from = if k % 3 == 0 { direct } else { kinds[random.below(kinds.len())] };
        let entry = from[random.below(from.len())];
        lines += &Corruption(random).entry(entry).line(&mut Work::new(3_000_000));
    }
    let file = std::env::temp_dir().join(format!("basis-oracle-{}-{step}", std::process::id()));
    std::fs::write(&file, lines).expect("a temporary file");
    let said = Command::new("python3").arg(root().join("tests/oracle/verify.py")).arg(&file).output();
    let said = said.expect("python3 runs");
    if let Some(kept) = std::env::var_os("KEEP") {
        std::fs::copy(&file, kept).expect("a place to keep it");
    }
    std::fs::remove_file(&file).expect("the temporary file");
    let text = String::from_utf8_lossy(&said.stdout);
    println!("{text}");
    assert!(said.status.success(), "SEED={seed}\n{text}{}", String::from_utf8_lossy(&said.stderr));
    assert!(
        text.contains("certificate refused by both") && text.contains("witness refused by both"),
        "{text}"
    );
}

#[test]
fn a_sample() {
    compare(20_261_122, 23, 500);
}

#[test]
#[ignore = "a minute: all certificates of the shipped specs, and 10 000 corrupted ones"]
fn everything() {
    let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).expect("after 1970");
    let setting = |name| std::env::var(name).ok().and_then(|value| value.parse().ok());
    let corrupted = setting("CORRUPTED").unwrap_or(10_000);
    compare(setting("SEED").unwrap_or(now.as_secs()), 1, corrupted as usize);
}

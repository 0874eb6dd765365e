//! The grammar in `editors` knows the words of the language.

use std::fs;
use std::path::PathBuf;

use basis_engine::query::{WORDS, WordKind};
use serde_json::Value;

fn read(name: &str) -> String {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../editors").join(name);
    fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

#[test]
fn the_grammar_knows_every_word() {
    let text = read("basis.tmLanguage.json");
    let grammar: Value = serde_json::from_str(&text).expect("it is JSON");
    let mut words: Vec<String> = Vec::new();
    for rule in ["items", "claims", "words", "functions", "numbers"] {
        let rule = grammar["repository"][rule].to_string();
        let parts = rule.split(|c: char| !c.is_ascii_alphanumeric() && c != '_' && c != 'π');
        words.extend(parts.map(String::from));
    }
    for word in WORDS {
        assert!(words.iter().any(|known| known == word.text), "{}", word.text);
    }
    assert!(WORDS.iter().any(|word| word.kind == WordKind::Property));
}

#[test]
fn the_extension_has_the_same_grammar() {
    assert_eq!(read("basis.tmLanguage.json"), read("vscode/syntaxes/basis.tmLanguage.json"));
}

//! What is open, and the questions about it.

use basis_engine::query::{self, Analysis, Document};
use basis_engine::{Library, Prover, Source, Subject, published};
use serde_json::{Value, json};

use crate::places::Places;
use crate::text::{NAME, NoFiles};
use crate::{code, drawing, facts, report};

/// A text with the verdicts so far.
#[derive(Debug, Default)]
pub(crate) struct Session {
    text: String,
    places: Places,
    analysis: Option<Analysis>,
    decided: usize,
}

impl Session {
    pub(crate) fn answer(&mut self, question: &Value) -> Value {
        let ask = question["ask"].as_str().unwrap_or_default();
        match ask {
            "open" => self.open(question["text"].as_str().unwrap_or_default()),
            "decide" => self.decide(),
            "verdicts" => self.with(|s, analysis| report::verdicts(analysis, &s.places)),
            "draw" | "facts" | "ends" => self.with(|_, analysis| {
                let place = question["item"].as_u64().unwrap_or(0) as usize;
                match analysis.items.get(place).map(|item| &item.subject) {
                    Some(Subject::Family(family)) if ask == "draw" => drawing::family(family),
                    Some(Subject::Family(family)) if ask == "ends" => facts::ends(family),
                    Some(Subject::Family(family)) => facts::family(family),
                    Some(Subject::Theorem(theorem)) => facts::theorem(theorem),
                    None => json!({ "error": "the spec has no such family" }),
                }
            }),
            "holds" => self.with(|s, analysis| {
                let place = question["item"].as_u64().unwrap_or(0) as usize;
                let name = analysis.items.get(place).map_or("", |item| item.subject.name());
                facts::holds(&s.text, &s.places, name)
            }),
            "code" => self.with(|s, analysis| {
                let to = question["to"].as_str().unwrap_or_default();
                let place = question["item"].as_u64().unwrap_or(0) as usize;
                match analysis.items.get(place) {
                    Some(item) => code::emit(&s.text, &item.subject, to),
                    None => json!({ "error": "the spec has no such family" }),
                }
            }),
            "format" => match query::format(question["text"].as_str().unwrap_or_default()) {
                Ok(text) => json!({ "text": text }),
                Err(error) => json!({ "error": error.to_string() }),
            },
            "complete" => complete(question),
            "published" => claims_of_papers(question["text"].as_str().unwrap_or_default()),
            "library" => library(),
            "spec" => spec(question["name"].as_str().unwrap_or_default()),
            _ => json!({ "error": format!("there is no question `{ask}`") }),
        }
    }

    fn with(&self, answer: impl FnOnce(&Self, &Analysis) -> Value) -> Value {
        match &self.analysis {
            Some(analysis) => answer(self, analysis),
            None => json!({ "error": "no spec is open" }),
        }
    }

    fn open(&mut self, text: &str) -> Value {
        // What was open is freed first.
        self.analysis = None;
        query::forget_tokens();
        self.text = String::from(text);
        self.places = Places::new(text);
        self.decided = 0;
        let analysis = Analysis::new(&NoFiles, Source::text(NAME, text));
        let answer = report::items(&analysis);
        self.analysis = Some(analysis);
        answer
    }

    fn decide(&mut self) -> Value {
        let Some(analysis) = &mut self.analysis else { return json!({ "error": "no spec is open" }) };
        let more = analysis.decide_next();
        self.decided += usize::from(more);
        json!({ "decided": self.decided, "more": more })
    }
}

/// What can be typed at a place.
fn complete(question: &Value) -> Value {
    let document = Document::new(question["text"].as_str().unwrap_or_default());
    let places = Places::new(&document.text);
    let at = places.byte(question["at"].as_u64().unwrap_or(0) as u32);
    let mut families = Vec::new();
    for import in document.imports.iter().filter(|i| i.library) {
        let known = Document::new(basis_specs::text(&import.path).unwrap_or_default());
        let own = known.symbols.iter().filter(|s| s.kind == query::SymbolKind::Family);
        families.extend(own.map(|s| (s.name.clone(), s.doc.lines().next().unwrap_or_default().to_string())));
    }
    let library = basis_specs::SPECS.iter().map(|(name, _)| name.to_string()).collect();
    let around = query::Around { families, library, files: Vec::new() };
    let suggestions = query::suggestions(&document, at, &around);
    let one = |s: query::Suggestion| {
        json!({
            "label": s.label,
            "insert": s.insert,
            "meaning": s.meaning,
            "from": places.at(s.replaces.start),
            "to": places.at(s.replaces.end)
        })
    };
    json!({ "suggestions": suggestions.into_iter().map(one).collect::<Vec<_>>() })
}

/// The shipped specs with the families and theorems that they declare, and the languages of code.
fn library() -> Value {
    let spec = |(name, text): &(&str, &str)| {
        let text = alone(name, text);
        let document = Document::new(text.as_str());
        let one = |entry: &query::Entry| {
            let symbol = document.symbols.get(entry.symbol?)?;
            let kind = match symbol.kind {
                query::SymbolKind::Family => "family",
                query::SymbolKind::Theorem => "theorem",
                query::SymbolKind::Join => "join",
                _ => return None,
            };
            Some(json!({ "kind": kind, "name": symbol.name, "doc": symbol.doc }))
        };
        let items: Vec<Value> = document.entries.iter().filter_map(one).collect();
        json!({ "name": name, "text": text, "items": items })
    };
    let specs: Vec<Value> = basis_specs::SPECS.iter().map(spec).collect();
    let words: Vec<(&str, String)> = query::WORDS.iter().map(|w| (w.text, format!("{:?}", w.kind))).collect();
    json!({ "specs": specs, "languages": code::languages(), "words": words })
}

/// The text of one shipped spec: what the page begins with, without reading all others first.
fn spec(name: &str) -> Value {
    match basis_specs::text(name) {
        Some(text) => json!({ "text": alone(name, text) }),
        None => json!({ "error": format!("the library has no spec `{name}`") }),
    }
}

/// A spec of the library without the folder that it lies in: what it uses by path it uses as part of the library.
pub(crate) fn alone(name: &str, text: &str) -> String {
    let mut all = String::from(text);
    for import in Document::new(text).imports.iter().rev().filter(|import| !import.library) {
        let mut parts: Vec<&str> = name.split('/').collect();
        parts.pop();
        for part in import.path.trim_end_matches(".basis").split('/') {
            match part {
                "." => {}
                ".." => drop(parts.pop()),
                part => parts.push(part),
            }
        }
        all.replace_range(import.place.clone(), &format!("library \"{}\"", parts.join("/")));
    }
    all
}

/// The published statements that a spec expresses, and which of them are true; decides all claims of the spec.
fn claims_of_papers(text: &str) -> Value {
    let library = Library::from_source(&NoFiles, &Prover, Source::text(NAME, text));
    let one = |s: published::Published| {
        json!({
            "id": s.id,
            "statement": s.statement,
            "verdict": s.fate.word(),
            "remark": s.remark()
        })
    };
    json!({ "statements": published::statements(&library).into_iter().map(one).collect::<Vec<_>>() })
}

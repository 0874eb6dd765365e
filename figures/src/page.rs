//! `index.html`: the figures by paper, with the published claims and their verdicts beside them.

use std::fmt::Write as _;

use basis_engine::published::Published;

use crate::figure::{Facts, shown};
use crate::papers::Paper;

/// A figure as the page shows it.
pub(crate) struct Entry<'a> {
    pub(crate) id: &'a str,
    pub(crate) title: &'a str,
    pub(crate) file: &'a str,
    pub(crate) params: &'a Facts,
    pub(crate) facts: &'a Facts,
    pub(crate) note: &'a str,
}

const STYLE: &str = "
:root { color-scheme: light; }
body { font: 16px/1.5 system-ui, sans-serif; margin: 0 auto; max-width: 1240px; padding: 1.5rem; color: #1c1f24; background: #fafafa; }
h1 { margin-bottom: .2rem; } h2 { margin-top: 3rem; border-bottom: 2px solid #d5d8de; padding-bottom: .3rem; }
nav a { margin-right: 1.2rem; }
.figures { display: grid; grid-template-columns: repeat(auto-fill, minmax(380px, 1fr)); gap: 1.2rem; }
figure { margin: 0; background: white; border: 1px solid #e1e4ea; border-radius: 6px; padding: .8rem; }
figure img { width: 100%; height: auto; }
figcaption h3 { margin: .4rem 0 .2rem; font-size: 1rem; } figcaption p { margin: .3rem 0; font-size: .9rem; }
dl { display: grid; grid-template-columns: minmax(7rem, max-content) 1fr; gap: .1rem .8rem; font-size: .85rem; margin: .4rem 0; }
dt { color: #5c6470; max-width: 14rem; } dd { margin: 0; overflow-wrap: anywhere; }
details { font-size: .85rem; } summary { cursor: pointer; color: #5c6470; }
table { border-collapse: collapse; width: 100%; font-size: .9rem; background: white; }
th, td { text-align: left; vertical-align: top; padding: .35rem .6rem; border-bottom: 1px solid #e6e8ec; }
td:first-child { white-space: nowrap; font-family: ui-monospace, monospace; }
.proved { color: #17692f; } .refuted { color: #a3211b; } .undecided, .not-expressed { color: #7a6410; }
";

/// The whole page.
pub(crate) fn html(papers: &[(&Paper, Vec<Published>, Vec<Entry<'_>>)]) -> String {
    let mut page = String::from(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width\">\n\
         <title>Figures and claims of five papers</title>\n<style>",
    );
    page += STYLE;
    page += "</style>\n<h1>Figures and claims of five papers</h1>\n\
             <p>Every figure is drawn from the families that <code>basis!</code> generates, and every number under it was measured \
             in it. The verdicts are exact proofs and refutations.</p>\n<nav>";
    for (paper, _, _) in papers {
        let _ = write!(page, "<a href=\"#{}\">{}</a>", paper.id, escaped(paper.title));
    }
    page += "</nav>\n";
    for (paper, statements, figures) in papers {
        let _ = writeln!(page, "<section id=\"{}\">\n<h2>{}</h2>", paper.id, escaped(paper.title));
        if !figures.is_empty() {
            page += "<div class=\"figures\">\n";
            for figure in figures {
                page += &entry(figure);
            }
            page += "</div>\n";
        }
        page += &table(statements);
        page += "</section>\n";
    }
    page += "</html>\n";
    page
}

fn entry(figure: &Entry<'_>) -> String {
    let mut text = format!(
        "<figure id=\"{id}\">\n<a href=\"{file}\"><img src=\"{file}\" alt=\"{title}\" loading=\"lazy\"></a>\n\
         <figcaption><h3>{title}</h3>\n<p>{note}</p>\n",
        id = figure.id,
        file = figure.file,
        title = escaped(figure.title),
        note = escaped(figure.note),
    );
    // Nets are long; shape values and angles are not.
    let (long, brief): (Vec<_>, Vec<_>) =
        figure.params.0.iter().partition(|(_, value)| shown(value).len() > 90);
    text += &list(brief.iter().chain(&[]).map(|(name, value)| (name.as_str(), shown(value))));
    text += &list(figure.facts.0.iter().map(|(name, value)| (name.as_str(), shown(value))));
    if !long.is_empty() {
        text += "<details><summary>control points</summary>";
        text += &list(long.iter().map(|(name, value)| (name.as_str(), shown(value))));
        text += "</details>\n";
    }
    text + "</figcaption>\n</figure>\n"
}

fn list<'a>(pairs: impl Iterator<Item = (&'a str, String)>) -> String {
    let mut text = String::from("<dl>");
    for (name, value) in pairs {
        let _ = write!(text, "<dt>{}</dt><dd>{}</dd>", escaped(name), escaped(&value));
    }
    text + "</dl>\n"
}

fn table(statements: &[Published]) -> String {
    let mut text = String::from(
        "<h3>Published claims</h3>\n<table>\n<tr><th>claim</th><th>as published</th><th>verdict</th><th>corrected</th></tr>\n",
    );
    for statement in statements {
        let class = statement.fate.word().replace(' ', "-");
        let _ = writeln!(
            text,
            "<tr id=\"{id}\"><td>{id}</td><td>{published}</td><td class=\"{class}\">{verdict}</td><td>{corrected}</td></tr>",
            id = statement.id,
            published = escaped(&statement.statement),
            verdict = statement.fate.word(),
            corrected = escaped(statement.remark()),
        );
    }
    text + "</table>\n"
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

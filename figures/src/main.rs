//! The figures of the papers, drawn from generated families, with what was measured in them.

mod draw;
mod figure;
mod page;
mod papers;

use std::error::Error;
use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use serde::Serialize;

use crate::figure::{Drawing, Facts, Figure, Picture};
use crate::papers::PAPERS;

/// A figure in `figures.json`.
#[derive(Debug, Serialize)]
struct Record {
    id: String,
    paper: &'static str,
    title: String,
    file: String,
    params: serde_json::Map<String, serde_json::Value>,
    facts: serde_json::Map<String, serde_json::Value>,
    #[serde(skip)]
    note: String,
}

/// Draws the figures of the papers, with their claims and verdicts
///
/// Curves with their control polygons as SVG, shaded surfaces with their nets as PNG, an `index.html` that shows them
/// beside the published claims, and `figures.json` with their parameters and what was measured in them.
#[derive(Debug, Parser)]
#[command(name = "basis-figures", version, after_help = HELP, max_term_width = 100)]
struct Arguments {
    /// The folder for the pictures and the page; it is made if it does not exist
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// Draw only the figures whose identifier contains this text
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
}

const HELP: &str = "\
Exit status:
  0  everything is drawn
  2  a file cannot be written, or the command is used wrongly

Examples:
  cargo run --release -p basis-figures -- pictures
  cargo run --release -p basis-figures -- pictures --only quart-fig-join";

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    match draw_all(&arguments.folder, arguments.only.as_deref().unwrap_or_default()) {
        Ok(count) => {
            let folder = arguments.folder.display();
            progress(&format!("{count} figures, index.html and figures.json in {folder}"));
            ExitCode::SUCCESS
        }
        Err(problem) => {
            progress(&format!("error: {problem}"));
            ExitCode::from(2)
        }
    }
}

/// Prints a line to standard error; a closed pipe is no reason to stop.
fn progress(line: &str) {
    let _ = writeln!(io::stderr(), "{line}");
}

fn draw_all(folder: &Path, only: &str) -> Result<usize, Box<dyn Error>> {
    fs::create_dir_all(folder).map_err(|e| format!("cannot make the folder `{}`: {e}", folder.display()))?;
    let all = PAPERS.each_ref().map(|paper| {
        let mut figures = paper.figures();
        figures.retain(|figure| figure.id.contains(only));
        figures
    });
    let total: usize = all.iter().map(Vec::len).sum();
    let mut records: Vec<Record> = Vec::with_capacity(total);
    for (paper, figures) in PAPERS.iter().zip(&all) {
        for figure in figures {
            progress(&format!("[{:>2}/{total}] {}", records.len() + 1, figure.title));
            let drawing =
                figure.draw().map_err(|e| format!("the figure `{}` cannot be drawn: {e}", figure.id))?;
            records.push(record(folder, paper.id, figure, drawing)?);
        }
    }
    progress("deciding the published claims");
    let page = page(&records)?;
    write(folder, "index.html", page.as_bytes())?;
    let mut json = serde_json::to_string_pretty(&records)?;
    json.push('\n');
    write(folder, "figures.json", json.as_bytes())?;
    Ok(total)
}

fn record(
    folder: &Path,
    paper: &'static str,
    figure: &Figure,
    drawing: Drawing,
) -> Result<Record, Box<dyn Error>> {
    let caption = drawing.params.caption();
    let (file, bytes) = match drawing.picture {
        Picture::Curves(plot) => {
            (format!("{}.svg", figure.id), plot.svg(&figure.title, &caption).into_bytes())
        }
        Picture::Surfaces(scene, view) => {
            (format!("{}.png", figure.id), scene.png(view, &figure.title, &caption)?)
        }
    };
    write(folder, &file, &bytes)?;
    Ok(Record {
        id: figure.id.clone(),
        paper,
        title: figure.title.clone(),
        file,
        params: drawing.params.0,
        facts: drawing.facts.0,
        note: drawing.note,
    })
}

fn page(records: &[Record]) -> Result<String, Box<dyn Error>> {
    let facts: Vec<(Facts, Facts)> =
        records.iter().map(|r| (Facts(r.params.clone()), Facts(r.facts.clone()))).collect();
    let mut papers = Vec::with_capacity(PAPERS.len());
    for paper in &PAPERS {
        let of = records.iter().zip(&facts).filter(|(record, _)| record.paper == paper.id);
        let entries = of.map(|(record, facts)| page::Entry {
            id: &record.id,
            title: &record.title,
            file: &record.file,
            params: &facts.0,
            facts: &facts.1,
            note: &record.note,
        });
        papers.push((paper, paper.statements()?, entries.collect()));
    }
    Ok(page::html(&papers))
}

fn write(folder: &Path, name: &str, bytes: &[u8]) -> Result<(), Box<dyn Error>> {
    let path = folder.join(name);
    fs::write(&path, bytes).map_err(|e| format!("cannot write `{}`: {e}", path.display()).into())
}

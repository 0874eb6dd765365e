//! The command, run on specs in a temporary folder.

mod angles;
mod certificates;
mod check_files;
mod check_table;
mod check_verdicts;
mod coq;
mod coq_spans;
mod editor;
mod emit;
mod eval_errors;
mod eval_values;
mod explain;
mod explain_assumed;
mod explain_claims;
mod explain_formats;
mod extrema;
mod library;
mod lsp;
mod plot;
mod rational;
mod reproducible;
mod spans;
mod start;
mod streams;
#[path = "../support/mod.rs"]
mod support;

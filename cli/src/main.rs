//! The command `basis`: everything that the macro does during a build, and more, at a terminal.
//!
//! `basis check` proves the claims of spec files, `basis emit` writes their families as source files, `basis eval`
//! evaluates a family exactly, `basis explain` shows what follows from its formulas, `basis lsp` serves an editor,
//! `basis table` lists families with their proved properties, `basis verify` checks certificates of proofs. All are
//! thin: the mathematics is in basis-engine; here are arguments, files, clocks and tables.

mod args;
mod catalogue;
mod certificates;
mod check;
mod coq;
mod domain;
mod emit;
mod eval;
mod explain;
mod layout;
mod lsp;
mod name;
mod new;
mod output;
mod plot;
mod shell;
mod spec;
mod table;

use std::process::ExitCode;

use clap::Parser;

use args::{Arguments, Command};

fn main() -> ExitCode {
    let status = match Arguments::parse().command {
        Command::Check(arguments) => check::run(&arguments),
        Command::Emit(arguments) => emit::run(&arguments),
        Command::Eval(arguments) => eval::run(&arguments),
        Command::Explain(arguments) => explain::run(&arguments),
        Command::Fmt(arguments) => layout::run(&arguments),
        Command::Lsp(_) => lsp::run(),
        Command::New(arguments) => new::run(&arguments),
        Command::Plot(arguments) => plot::run(&arguments),
        Command::Table(arguments) => catalogue::run(&arguments),
        Command::Verify(arguments) => certificates::verify(&arguments),
        Command::Completions(arguments) => shell::completions(&arguments),
        Command::Man(arguments) => shell::man(&arguments),
    };
    status.into()
}

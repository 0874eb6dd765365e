//! What a shell and its manual know about the command, from the same texts as `--help`.

use std::fs;

use basis_engine::Sources;
use clap::{Command, CommandFactory as _};
use clap_mangen::Man;

use crate::args::{Arguments, CompletionsArguments, ManArguments};
use crate::name;
use crate::output::{self, Status};

/// Prints the completions of a shell.
pub(crate) fn completions(arguments: &CompletionsArguments) -> Status {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut Arguments::command(), "basis", &mut script);
    output::print(&String::from_utf8_lossy(&script))
}

/// Prints a manual page, or writes all pages into a folder.
pub(crate) fn man(arguments: &ManArguments) -> Status {
    let written = match &arguments.output {
        None => {
            // Built, a subcommand has its whole name, `basis-check`.
            let mut all = Arguments::command().disable_help_subcommand(true);
            all.build();
            let wanted = match &arguments.command {
                None => &all,
                Some(name) => match all.find_subcommand(name) {
                    Some(command) => command,
                    None => return unknown(name, &all),
                },
            };
            let mut page = Vec::new();
            Man::new(wanted.clone())
                .render(&mut page)
                .map(|()| output::print(&String::from_utf8_lossy(&page)))
        }
        Some(folder) => fs::create_dir_all(folder)
            .and_then(|()| clap_mangen::generate_to(Arguments::command(), folder))
            .map(|()| Status::Fine),
    };
    written.unwrap_or_else(|e| {
        let error = output::error(format!("cannot write the manual: {e}"));
        output::complain(&(error.render(&Sources::default(), true) + "\n"));
        Status::Unusable
    })
}

fn unknown(name: &str, all: &Command) -> Status {
    let names: Vec<&str> = all.get_subcommands().map(Command::get_name).collect();
    let error = output::error(format!("`{name}` is no command of `basis`"));
    let error = error.help(format!("the commands are {}", name::list(&names)));
    output::complain(&(error.render(&Sources::default(), true) + "\n"));
    Status::Unusable
}

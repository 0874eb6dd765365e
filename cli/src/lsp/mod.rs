//! `basis lsp`: the language server. It speaks the Language Server Protocol on standard input and output.
//!
//! Names, layout and outline are answered at once from the text. Claims are decided in small pieces between the
//! messages of the editor, so that a newer version of a text stops the work on an older one, and an answer that needs
//! verdicts waits for them.

mod answers;
mod files;
mod position;
mod server;
mod workspace;

use lsp_server::Connection;

use crate::output::{self, Status};

/// Serves an editor until it says goodbye.
pub(crate) fn run() -> Status {
    let (connection, threads) = Connection::stdio();
    let served = server::serve(&connection);
    drop(connection);
    match served.map_err(|e| e.to_string()).and_then(|()| threads.join().map_err(|e| e.to_string())) {
        Ok(()) => Status::Fine,
        Err(e) => {
            let error = output::error(format!("the language server stops: {e}"))
                .help("`basis lsp` is started by an editor, which talks to it on standard input and output");
            output::complain(&(error.render(&basis_engine::Sources::default(), true) + "\n"));
            Status::Unusable
        }
    }
}

//! The loop: messages of the editor first, and in between the claims of the texts.

use std::error::Error;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use basis_engine::Files;
use basis_engine::query;
use lsp_server::{Connection, ErrorCode, Message, Notification, Request, RequestId, Response};
use lsp_types::{
    CodeActionKind, DocumentHighlight, Position, PublishDiagnosticsParams, Range, SemanticTokens,
    TextDocumentContentChangeEvent, TextDocumentSyncKind, TextEdit, Uri,
};
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

use super::answers::{actions, complete, hover, marks, names, outline, words};
use super::files::{self, Overlay};
use super::position::Lines;
use super::workspace::{Shown, Text, Workspace};
use basis_engine::query::{Analysis, forget_tokens};

/// How long claims are decided before messages are looked at again.
const SLICE: Duration = Duration::from_millis(5);

/// After this time a request is answered with what is known.
const PATIENCE: Duration = Duration::from_millis(1500);

/// After this time errors are shown although not all claims are decided.
const INTERIM: Duration = Duration::from_millis(500);

/// The state of the server.
struct Server {
    workspace: Workspace,
    /// Requests that wait for verdicts, with the time of their arrival.
    waiting: Vec<(Request, Instant)>,
    snippets: bool,
    refreshes: bool,
    /// The number of the last request to the editor.
    asked: i32,
}

type Failure = Box<dyn Error + Send + Sync>;

/// Serves an editor until it says goodbye.
pub(super) fn serve(connection: &Connection) -> Result<(), Failure> {
    let parameters = connection.initialize(capabilities())?;
    let mut server = Server::new(&parameters);
    loop {
        let message = if server.has_work() {
            match connection.receiver.try_recv() {
                Ok(message) => Some(message),
                Err(e) if e.is_empty() => None,
                Err(_) => return Ok(()),
            }
        } else {
            match connection.receiver.recv() {
                Ok(message) => Some(message),
                Err(_) => return Ok(()),
            }
        };
        let replies = match message {
            Some(Message::Request(request)) => {
                if request.method == "shutdown" {
                    connection.sender.send(Response::new_ok(request.id, Value::Null).into())?;
                    return goodbye(connection);
                }
                server.request(request)
            }
            Some(Message::Notification(note)) => server.note(&note),
            Some(Message::Response(_)) => Vec::new(),
            None => server.work(),
        };
        for reply in replies {
            connection.sender.send(reply)?;
        }
    }
}

/// Waits for the end. What an editor sent before it had the answer to its goodbye, such as answers of its own, may still
/// arrive.
fn goodbye(connection: &Connection) -> Result<(), Failure> {
    for message in &connection.receiver {
        match message {
            Message::Notification(note) if note.method == "exit" => return Ok(()),
            Message::Request(request) => {
                let code = ErrorCode::InvalidRequest as i32;
                let refusal = Response::new_err(request.id, code, String::from("the server is about to end"));
                connection.sender.send(refusal.into())?;
            }
            Message::Notification(_) | Message::Response(_) => {}
        }
    }
    Ok(())
}

/// What the server does. This and what an editor says of itself are read and written field by field: with the types of the
/// protocol, which know everything that any editor may say, the command is a third of a megabyte larger.
fn capabilities() -> Value {
    json!({
        "textDocumentSync": TextDocumentSyncKind::INCREMENTAL,
        "hoverProvider": true,
        "completionProvider": { "triggerCharacters": ["\\", "\""] },
        "definitionProvider": true,
        "referencesProvider": true,
        "documentHighlightProvider": true,
        "renameProvider": { "prepareProvider": true },
        "documentSymbolProvider": true,
        "foldingRangeProvider": true,
        "documentFormattingProvider": true,
        "semanticTokensProvider": { "legend": words::legend(), "full": true },
        "inlayHintProvider": true,
        "codeActionProvider": {
            "codeActionKinds": [CodeActionKind::QUICKFIX, CodeActionKind::SOURCE],
            "resolveProvider": true,
        },
    })
}

impl Server {
    /// Starts with what the editor says of itself.
    fn new(parameters: &Value) -> Self {
        let has = |path: &str| {
            let value = parameters.pointer("/capabilities").and_then(|c| c.pointer(path));
            value.is_some_and(|v| *v != Value::Bool(false) && !v.is_null())
        };
        let file = |uri: &Value| files::path(&uri.as_str()?.parse().ok()?);
        let folders = parameters.get("workspaceFolders").and_then(Value::as_array).into_iter().flatten();
        let folders = folders.filter_map(|f| file(f.get("uri")?));
        let root = parameters.get("rootUri").and_then(file); // older editors name one folder only
        let mut roots: Vec<PathBuf> = folders.chain(root).collect();
        roots.dedup();
        Self {
            workspace: Workspace {
                texts: Vec::new(),
                files: Overlay::default(),
                roots,
                resolves: has("/textDocument/codeAction/resolveSupport"),
            },
            waiting: Vec::new(),
            snippets: has("/textDocument/completion/completionItem/snippetSupport"),
            refreshes: has("/workspace/inlayHint/refreshSupport"),
            asked: 0,
        }
    }

    fn has_work(&self) -> bool {
        self.workspace.texts.iter().any(|t| t.shown != Shown::All) || !self.waiting.is_empty()
    }

    /// Decides some claims, and says what is known then.
    fn work(&mut self) -> Vec<Message> {
        let mut replies = Vec::new();
        if let Some(k) = self.workspace.texts.iter().rposition(|t| t.shown != Shown::All) {
            if self.workspace.texts[k].analysis.is_none() {
                let source = self.workspace.texts[k].source();
                forget_tokens();
                self.workspace.texts[k].analysis = Some(Analysis::new(&self.workspace.files, source));
            }
            let text = &mut self.workspace.texts[k];
            if let Some(analysis) = &mut text.analysis {
                let start = Instant::now();
                while analysis.decide_next() && start.elapsed() < SLICE {}
            }
            let done = text.is_done();
            if done || text.shown == Shown::No && text.since.elapsed() > INTERIM {
                text.shown = if done { Shown::All } else { Shown::Interim };
                replies.extend(publish(text));
                if done && self.refreshes {
                    self.asked += 1;
                    let id = RequestId::from(self.asked);
                    let method = String::from("workspace/inlayHint/refresh");
                    replies.push(Message::Request(Request::new(id, method, Value::Null)));
                }
            }
        }
        // What waits for verdicts that are there now, or has waited long enough.
        let waiting = core::mem::take(&mut self.waiting);
        for (request, since) in waiting {
            if self.is_ready(&request) || since.elapsed() > PATIENCE {
                replies.push(self.answer(request));
            } else {
                self.waiting.push((request, since));
            }
        }
        replies
    }

    /// Whether the verdicts that a request needs are there.
    fn is_ready(&self, request: &Request) -> bool {
        let uri = request.params.pointer("/textDocument/uri").and_then(Value::as_str).unwrap_or_default();
        self.workspace.text(uri).is_none_or(Text::is_done)
    }

    fn note(&mut self, note: &Notification) -> Vec<Message> {
        let word = |path: &str| note.params.pointer(path).and_then(Value::as_str);
        let uri = word("/textDocument/uri");
        let version = note.params.pointer("/textDocument/version").and_then(Value::as_i64).map(|v| v as i32);
        match (note.method.as_str(), uri) {
            ("textDocument/didOpen", Some(uri)) => {
                if let Some(text) = word("/textDocument/text") {
                    self.open(uri, text, version);
                }
            }
            ("textDocument/didChange", Some(uri)) => {
                let changes = note.params.get("contentChanges").cloned().unwrap_or_default();
                let changes = serde_json::from_value::<Vec<TextDocumentContentChangeEvent>>(changes);
                if let (Some(text), Ok(changes)) = (self.workspace.text(uri), changes) {
                    let text = changed(&text.document.text, &changes);
                    self.open(uri, &text, version);
                }
            }
            ("textDocument/didClose", Some(uri)) => {
                let Some(k) = self.workspace.texts.iter().position(|t| t.uri.as_str() == uri) else {
                    return Vec::new();
                };
                let text = self.workspace.texts.remove(k);
                if let Some(path) = &text.path {
                    self.workspace.files.open.remove(path);
                }
                let none = PublishDiagnosticsParams::new(text.uri, Vec::new(), None);
                let method = String::from("textDocument/publishDiagnostics");
                return vec![Message::Notification(Notification::new(method, none))];
            }
            ("workspace/didChangeWatchedFiles" | "textDocument/didSave", _) => {
                // A file that others use may have changed.
                for text in &mut self.workspace.texts {
                    if !text.document.imports.is_empty() {
                        (text.analysis, text.shown, text.since) = (None, Shown::No, Instant::now());
                    }
                }
            }
            ("$/cancelRequest", _) => {
                let id =
                    note.params.get("id").and_then(|id| serde_json::from_value::<RequestId>(id.clone()).ok());
                let found = self.waiting.iter().position(|(request, _)| Some(&request.id) == id.as_ref());
                if let Some(k) = found {
                    let (request, _) = self.waiting.remove(k);
                    let code = ErrorCode::RequestCanceled as i32;
                    let response = Response::new_err(request.id, code, String::from("canceled"));
                    return vec![Message::Response(response)];
                }
            }
            _ => {}
        }
        Vec::new()
    }

    /// A text is opened or changed.
    fn open(&mut self, uri: &str, content: &str, version: Option<i32>) {
        let Ok(parsed) = uri.parse::<Uri>() else { return };
        self.workspace.texts.retain(|t| t.uri.as_str() != uri);
        let text = Text::new(parsed, content, version);
        if let Some(path) = &text.path {
            self.workspace.files.open.insert(path.clone(), text.document.text.clone());
        }
        // Texts that use this one have to be checked again.
        for other in &mut self.workspace.texts {
            let folder = other.path.as_deref().and_then(std::path::Path::parent);
            let uses = other.document.imports.iter().any(|i| {
                let path = folder.map(|f| f.join(&i.path));
                !i.library && path.is_some_and(|p| Some(self.workspace.files.canonical(&p)) == text.path)
            });
            if uses {
                (other.analysis, other.shown, other.since) = (None, Shown::No, Instant::now());
            }
        }
        self.workspace.texts.push(text);
    }

    fn request(&mut self, request: Request) -> Vec<Message> {
        let verdicts = matches!(
            request.method.as_str(),
            "textDocument/hover" | "textDocument/inlayHint" | "textDocument/codeAction"
        );
        if verdicts && !self.is_ready(&request) {
            self.waiting.push((request, Instant::now()));
            return Vec::new();
        }
        vec![self.answer(request)]
    }

    fn answer(&self, request: Request) -> Message {
        let result = self.result(&request);
        let id = request.id;
        Message::Response(match result {
            Ok(result) => Response::new_ok(id, result),
            Err((code, message)) => Response::new_err(id, code as i32, message),
        })
    }

    fn result(&self, request: &Request) -> Result<Value, (ErrorCode, String)> {
        let (method, params) = (request.method.as_str(), &request.params);
        if method == "codeAction/resolve" {
            return value(actions::resolve(&self.workspace, params.clone()));
        }
        let Some(uri) = params.pointer("/textDocument/uri").and_then(Value::as_str) else {
            return Err((ErrorCode::MethodNotFound, format!("`{method}` is not known")));
        };
        let Some(text) = self.workspace.text(uri) else {
            return Err((ErrorCode::InvalidParams, format!("{uri} is not open")));
        };
        let analysis = text.analysis.as_ref();
        let position = || read::<Position>(params, "/position");
        let range = || read::<Range>(params, "/range");
        match method {
            "textDocument/hover" => {
                let position = position()?;
                value(analysis.and_then(|a| hover::hover(&self.workspace, text, a, position)))
            }
            "textDocument/inlayHint" => {
                let range = range()?;
                value(analysis.map(|a| marks::hints(text, a, range)))
            }
            "textDocument/codeAction" => {
                let range = range()?;
                value(analysis.map(|a| actions::actions(&self.workspace, text, a, range)))
            }
            "textDocument/completion" => {
                value(complete::complete(&self.workspace, text, self.snippets, position()?))
            }
            "textDocument/definition" => value(names::definition(&self.workspace, text, position()?)),
            "textDocument/references" => {
                let declared = read(params, "/context/includeDeclaration")?;
                value(names::references(&self.workspace, text, position()?, declared))
            }
            "textDocument/documentHighlight" => {
                let all = names::references(&self.workspace, text, position()?, true)
                    .unwrap_or_default()
                    .into_iter();
                let own = all.filter(|l| l.uri == text.uri);
                value(own.map(|l| DocumentHighlight { range: l.range, kind: None }).collect::<Vec<_>>())
            }
            "textDocument/prepareRename" => {
                let range = names::prepare(&self.workspace, text, position()?);
                value(range.map_err(|e| (ErrorCode::RequestFailed, e))?)
            }
            "textDocument/rename" => {
                let name: String = read(params, "/newName")?;
                let edit = names::rename(&self.workspace, text, position()?, &name);
                value(edit.map_err(|e| (ErrorCode::RequestFailed, e))?)
            }
            "textDocument/documentSymbol" => value(outline::outline(text)),
            "textDocument/foldingRange" => value(outline::folds(text)),
            "textDocument/formatting" => value(formatting(text)),
            "textDocument/semanticTokens/full" => {
                value(SemanticTokens { result_id: None, data: words::tokens(text) })
            }
            _ => Err((ErrorCode::MethodNotFound, format!("`{method}` is not known"))),
        }
    }
}

/// A text after some changes, each at places of the text that the one before it left.
fn changed(text: &str, changes: &[TextDocumentContentChangeEvent]) -> String {
    let mut text = text.to_string();
    for change in changes {
        match change.range {
            Some(range) => {
                let bytes = Lines::new(&text).bytes(&text, range);
                text.replace_range(bytes, &change.text);
            }
            None => text.clone_from(&change.text),
        }
    }
    text
}

/// A part of what an editor sends with a request.
fn read<T: DeserializeOwned>(params: &Value, path: &str) -> Result<T, (ErrorCode, String)> {
    let part = params.pointer(path).cloned().unwrap_or_default();
    serde_json::from_value(part).map_err(|e| (ErrorCode::InvalidParams, format!("`{}`: {e}", &path[1..])))
}

fn value(result: impl serde::Serialize) -> Result<Value, (ErrorCode, String)> {
    serde_json::to_value(result).map_err(|e| (ErrorCode::InternalError, e.to_string()))
}

/// The edit that gives a text its standard layout; none where it has it, or a bracket has no partner.
fn formatting(text: &Text) -> Option<Vec<TextEdit>> {
    let new_text = query::format(&text.document.text).ok()?;
    if new_text == text.document.text {
        return Some(Vec::new());
    }
    Some(vec![TextEdit { range: text.span(&(0..text.document.text.len())), new_text }])
}

fn publish(text: &Text) -> Option<Message> {
    let diagnostics = marks::diagnostics(text, text.analysis.as_ref()?);
    let params = json!(PublishDiagnosticsParams::new(text.uri.clone(), diagnostics, text.version));
    let method = String::from("textDocument/publishDiagnostics");
    Some(Message::Notification(Notification::new(method, params)))
}

//! An editor that drives `basis lsp`: messages on standard input, answers on standard output.

#![allow(clippy::needless_pass_by_value)] // `json!` is written where it is used

use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::Duration;

use crate::support::Folder;
use serde_json::{Value, json};

/// An editor with a language server.
pub(crate) struct Editor {
    server: Child,
    input: ChildStdin,
    messages: Receiver<Value>,
    id: i64,
    folder: Folder,
}

impl Editor {
    /// An editor that shows a folder.
    pub(crate) fn open(folder: Folder) -> Self {
        let mut command = folder.command(&["lsp"]);
        let mut server =
            command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().expect("the command starts");
        let input = server.stdin.take().expect("it has an input");
        let mut output = BufReader::new(server.stdout.take().expect("it has an output"));
        let (sender, messages) = channel();
        thread::spawn(move || {
            loop {
                let mut length = 0;
                loop {
                    let mut line = String::new();
                    if output.read_line(&mut line).unwrap_or(0) == 0 {
                        return;
                    }
                    if let Some(n) = line.strip_prefix("Content-Length: ") {
                        length = n.trim().parse().expect("a length is a number");
                    }
                    if line.trim().is_empty() {
                        break;
                    }
                }
                let mut content = vec![0; length];
                if output.read_exact(&mut content).is_err() {
                    return;
                }
                let message = serde_json::from_slice(&content).expect("a message is JSON");
                if sender.send(message).is_err() {
                    return;
                }
            }
        });
        let mut editor = Self { server, input, messages, id: 0, folder };
        let capabilities = json!({
            "textDocument": {
                "codeAction": { "resolveSupport": { "properties": ["edit"] } },
                "completion": { "completionItem": { "snippetSupport": true } }
            },
            "workspace": { "inlayHint": { "refreshSupport": true } }
        });
        let root = editor.uri("");
        let folders = json!([{ "uri": root, "name": "specs" }]);
        let parameters = json!({ "capabilities": capabilities, "workspaceFolders": folders });
        let answer = editor.ask("initialize", parameters);
        assert!(answer["capabilities"]["hoverProvider"].as_bool().expect("it says what it can"));
        editor.tell("initialized", json!({}));
        editor
    }

    /// An editor that shows a folder, with one file open.
    pub(crate) fn showing(folder: Folder, name: &str, text: &str) -> Self {
        let mut editor = Self::open(folder);
        editor.show(name, text);
        editor
    }

    pub(crate) fn uri(&self, name: &str) -> String {
        let path = self.folder.path().canonicalize().expect("the folder is there").join(name);
        format!("file://{}", path.display())
    }

    pub(crate) fn send(&mut self, message: &Value) {
        let text = message.to_string();
        write!(self.input, "Content-Length: {}\r\n\r\n{text}", text.len()).expect("the server reads");
        self.input.flush().expect("the server reads");
    }

    pub(crate) fn tell(&mut self, method: &str, params: Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    pub(crate) fn next(&self) -> Value {
        self.messages.recv_timeout(Duration::from_secs(60)).expect("the server answers")
    }

    /// The answer to a request, whole.
    pub(crate) fn response(&mut self, method: &str, params: Value) -> Value {
        self.id += 1;
        let id = self.id;
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }));
        loop {
            let message = self.next();
            if message["id"] == id && message.get("method").is_none() {
                return message;
            }
        }
    }

    /// The result of a request.
    pub(crate) fn ask(&mut self, method: &str, params: Value) -> Value {
        let response = self.response(method, params);
        assert!(response.get("error").is_none(), "{method}: {response}");
        response["result"].clone()
    }

    /// The result of a request about a place: where `mark` stands in a text, `after` bytes further.
    pub(crate) fn ask_at(
        &mut self,
        method: &str,
        name: &str,
        text: &str,
        mark: &str,
        after: usize,
        more: Value,
    ) -> Value {
        let mut params = json!({
            "textDocument": { "uri": self.uri(name) },
            "position": position(text, text.find(mark).expect("the mark is there") + after)
        });
        let more = more.as_object().cloned().unwrap_or_default();
        params.as_object_mut().expect("it is an object").extend(more);
        self.ask(method, params)
    }

    /// What a pointer shows where `mark` stands in a text, `after` bytes further; empty if nothing.
    pub(crate) fn hover(&mut self, name: &str, text: &str, mark: &str, after: usize) -> String {
        let hover = self.ask_at("textDocument/hover", name, text, mark, after, json!({}));
        hover["contents"]["value"].as_str().unwrap_or_default().to_string()
    }

    pub(crate) fn show(&mut self, name: &str, text: &str) {
        let document = json!({ "uri": self.uri(name), "languageId": "basis", "version": 1, "text": text });
        self.tell("textDocument/didOpen", json!({ "textDocument": document }));
    }

    pub(crate) fn edit(&mut self, name: &str, version: i64, text: &str) {
        let document = json!({ "uri": self.uri(name), "version": version });
        let changes = json!([{ "text": text }]);
        self.tell("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes }));
    }

    /// The messages about the version of a text.
    pub(crate) fn errors(&self, version: i64) -> Vec<Value> {
        loop {
            let message = self.next();
            if message["method"] == "textDocument/publishDiagnostics"
                && message["params"]["version"] == version
            {
                return message["params"]["diagnostics"].as_array().expect("they are a list").clone();
            }
        }
    }

    pub(crate) fn actions(&mut self, name: &str, text: &str, mark: &str) -> Vec<Value> {
        let at = position(text, text.find(mark).expect("the mark is there"));
        let params = json!({
            "textDocument": { "uri": self.uri(name) },
            "range": { "start": at, "end": at },
            "context": { "diagnostics": [] }
        });
        self.ask("textDocument/codeAction", params).as_array().expect("they are a list").clone()
    }

    /// The text after the action with some title.
    pub(crate) fn act(&mut self, name: &str, text: &str, mark: &str, title: &str) -> String {
        let actions = self.actions(name, text, mark);
        let action = actions.iter().find(|a| a["title"] == title).unwrap_or_else(|| panic!("{actions:?}"));
        let action = if action.get("edit").is_some() {
            action.clone()
        } else {
            self.ask("codeAction/resolve", action.clone())
        };
        match &action["edit"]["changes"][self.uri(name)] {
            Value::Null => text.to_string(),
            edits => apply(text, edits),
        }
    }

    pub(crate) fn close(mut self) {
        assert_eq!(self.ask("shutdown", Value::Null), Value::Null);
        // What is on its way meanwhile: an answer to the server, a change, another question.
        self.send(&json!({ "jsonrpc": "2.0", "id": 7, "result": null }));
        self.tell("$/setTrace", json!({ "value": "off" }));
        assert!(self.response("textDocument/hover", Value::Null)["error"]["message"].is_string());
        self.tell("exit", Value::Null);
        assert!(self.server.wait().expect("it ends").success());
    }
}

impl Drop for Editor {
    fn drop(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

/// Line and UTF-16 unit of a byte.
pub(crate) fn position(text: &str, offset: usize) -> Value {
    let line = text[..offset].matches('\n').count();
    let start = text[..offset].rfind('\n').map_or(0, |at| at + 1);
    json!({ "line": line, "character": text[start..offset].encode_utf16().count() })
}

pub(crate) fn offset(text: &str, position: &Value) -> usize {
    let number = |name: &str| position[name].as_u64().expect("it is a number") as usize;
    let start: usize = text.split_inclusive('\n').take(number("line")).map(str::len).sum();
    let mut units = number("character");
    for (at, c) in text[start..].char_indices() {
        if units == 0 {
            return start + at;
        }
        units -= c.len_utf16();
    }
    text.len()
}

/// The text at a range.
pub(crate) fn slice<'t>(text: &'t str, range: &Value) -> &'t str {
    &text[offset(text, &range["start"])..offset(text, &range["end"])]
}

/// The text after some edits.
pub(crate) fn apply(text: &str, edits: &Value) -> String {
    let mut edits = edits.as_array().expect("they are a list").clone();
    edits.sort_by_key(|e| core::cmp::Reverse(offset(text, &e["range"]["start"])));
    let mut result = text.to_string();
    for edit in edits {
        let range = offset(text, &edit["range"]["start"])..offset(text, &edit["range"]["end"]);
        result.replace_range(range, edit["newText"].as_str().expect("it is a text"));
    }
    result
}

//! The engine for the page: one question as JSON, one answer as JSON, and the spec that is being decided meanwhile.
//!
//! The page writes a question into the bytes that `alloc` gives, calls `answer`, and reads as many bytes as that
//! says from where `text` begins. [`reply`] is the same for Rust, and lists the questions.

mod code;
mod drawing;
mod facts;
mod layout;
mod places;
mod report;
mod session;
mod text;

use std::cell::RefCell;

use serde_json::{Value, json};

use session::Session;

thread_local! {
    static SESSION: RefCell<Session> = RefCell::default();
    /// A question, and then its answer.
    #[cfg(target_family = "wasm")]
    static TEXT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Room for a question with this number of bytes.
#[cfg(target_family = "wasm")] // elsewhere `free` is the name of another function
#[allow(unsafe_code)] // SAFETY: no other symbol of the page has the name; there is no unsafe block here
#[unsafe(no_mangle)]
pub extern "C" fn alloc(length: usize) -> *mut u8 {
    TEXT.with_borrow_mut(|text| {
        *text = vec![0; length];
        text.as_mut_ptr()
    })
}

/// Answers the question; the number of bytes of the answer.
#[cfg(target_family = "wasm")]
#[allow(unsafe_code)] // SAFETY: as for `alloc`
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> usize {
    let question = TEXT.take();
    let answer = reply(&String::from_utf8_lossy(&question)).into_bytes();
    let length = answer.len();
    TEXT.set(answer);
    length
}

/// Where the answer begins; valid until the next question.
#[cfg(target_family = "wasm")]
#[allow(unsafe_code)] // SAFETY: as for `alloc`
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    TEXT.with_borrow(Vec::as_ptr)
}

/// Frees the answer.
#[cfg(target_family = "wasm")]
#[allow(unsafe_code)] // SAFETY: as for `alloc`
#[unsafe(no_mangle)]
pub extern "C" fn free() {
    TEXT.set(Vec::new());
}

/// The answer to a question, an object whose `ask` is one of
///
/// | question | answer |
/// | --- | --- |
/// | `open`, with `text` | reads and expands a spec; its families and theorems, and how many claims they make |
/// | `decide` | decides one claim of the open spec; `done` and `of`, numbers of claims |
/// | `verdicts` | what is known by now: statements with verdicts, messages with places |
/// | `draw`, with `item` | the functions of a family in floating point, as sums that can be evaluated |
/// | `facts`, with `item` | formulas, in LaTeX |
/// | `ends`, with `item` | the ends of a curve and its derivatives there, in LaTeX |
/// | `holds`, with `item` | claims that hold and that the spec does not make |
/// | `code`, with `to` and `item` | generated code, or why there is none |
/// | `format`, with `text` | the text in its standard layout |
/// | `complete`, with `text` and `at` | what can be typed there |
/// | `published`, with `text` | the published statements that a spec expresses, and which of them are true |
/// | `spec`, with `name` | the text of a shipped spec |
/// | `library` | the shipped specs, and the languages of `code` |
///
/// Places are counted in UTF-16 code units, as in JavaScript. What cannot be answered is `{"error": …}`.
pub fn reply(question: &str) -> String {
    let answer = match serde_json::from_str::<Value>(question) {
        Ok(question) => SESSION.with_borrow_mut(|session| session.answer(&question)),
        Err(e) => json!({ "error": format!("the question is not JSON: {e}") }),
    };
    answer.to_string()
}

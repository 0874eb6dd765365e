//! What names in claims stand for.

use basis_prover::collections::list::Listed;

use crate::claim::Claim;
use crate::model::Library;
use crate::query::{TokenKind, tokens};
use crate::subject::Subject;

/// What `let` gives a name to and the claims of a family or theorem name, as both sides of `w = u^2 + v^2`; also what these
/// definitions name. Control points that a theorem determines are no names.
pub fn definitions(library: &Library<'_>, subject: &Subject, claims: &[&Claim]) -> Vec<(String, String)> {
    let mut all = library.definitions(subject.name());
    if let Subject::Theorem(theorem) = subject {
        all.retain(|(name, _)| theorem.patches.iter().all(|patch| patch.name != *name));
    }
    let mut names: Vec<String> = claims.iter().flat_map(|claim| words(&claim.statement.text)).listed();
    let mut known = 0;
    while known < names.len() {
        let meant = all.iter().filter(|(name, _)| *name == names[known]);
        let more =
            meant.flat_map(|(_, written)| words(written)).filter(|word| !names.contains(word)).listed();
        names.extend(more);
        known += 1;
    }
    all.retain(|(name, _)| names.contains(name));
    all.iter().filter_map(|(_, written)| sides(written)).listed()
}

fn words(text: &str) -> Vec<String> {
    let is_word = |token: &&crate::query::Token| token.kind == TokenKind::Word;
    tokens(text).iter().filter(is_word).map(|token| token.text(text).to_owned()).listed()
}

/// Both sides of a definition, each in one line and without comments.
fn sides(written: &str) -> Option<(String, String)> {
    let all = tokens(written);
    let all = all.iter().filter(|token| !token.is_comment()).listed();
    let sign = all.iter().position(|token| token.text(written) == "=")?;
    let line = |part: &[&crate::query::Token]| {
        let mut line = String::new();
        let mut end = None;
        for token in part {
            if end.is_some_and(|end| token.range.start > end) {
                line.push(' ');
            }
            line += token.text(written);
            end = Some(token.range.end);
        }
        line
    };
    let [name, value] = [&all[..sign], &all[sign + 1..]].map(line);
    Some((name, value))
}

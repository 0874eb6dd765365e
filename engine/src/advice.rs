//! What was probably meant, and what to write instead.

use crate::ascii::lowercase;
use basis_prover::collections::list::Listed;

/// The candidate that differs least from `word`, if it is near enough to be meant (Damerau–Levenshtein).
pub fn closest<'a>(word: &str, candidates: &[&'a str]) -> Option<&'a str> {
    let length = word.chars().count();
    // Two names of one letter have nothing in common.
    let limit = (length / 3).max(1).min(length.saturating_sub(1));
    let exact = candidates.iter().find(|c| **c == word);
    if exact.is_some() || limit == 0 {
        return exact.copied();
    }
    let word = lowercase(word);
    let mut best: Option<(usize, &str)> = None;
    // In a spec with thousands of names the last ones are not looked at.
    let mut left = MAX_COMPARED;
    for candidate in candidates {
        let other = candidate.chars().count();
        if other.abs_diff(length) > limit {
            continue;
        }
        left = left.saturating_sub(other.min(64) * length.min(64));
        if left == 0 {
            break;
        }
        let distance = distance(&word, &lowercase(candidate));
        if distance <= limit && best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// The most pairs of letters that are compared to find what was meant.
const MAX_COMPARED: usize = 500_000;

/// The advice for an unknown word: the candidate that was probably meant, else what can be written.
pub(crate) fn did_you_mean(word: &str, candidates: &[&str], otherwise: &dyn Fn() -> String) -> String {
    closest(word, candidates).map_or_else(otherwise, |near| format!("did you mean `{near}`?"))
}

/// What is written for a word that other languages or papers have; each entry begins with words that are separated by
/// spaces.
pub(crate) fn translated(word: &str, entries: &[(&str, &str)]) -> Option<String> {
    let (_, help) = entries.iter().find(|(words, _)| words.split(' ').any(|known| known == word))?;
    Some(String::from(*help))
}

fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().take(64).listed(), b.chars().take(64).listed());
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for (i, row) in rows.iter_mut().enumerate() {
        row[0] = i;
    }
    for (j, cell) in rows[0].iter_mut().enumerate() {
        *cell = j;
    }
    for i in 1..=a.len() {
        for j in 1..=b.len() {
            let change = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut best = change.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(rows[i - 2][j - 2] + 1);
            }
            rows[i][j] = best;
        }
    }
    rows[a.len()][b.len()]
}

/// How derivatives along the edges of a simplex are written, for those who differentiate by the last coordinate.
pub(crate) fn along_edges(function: &str, independent: &[&str], last: &str) -> String {
    let [first, second, ..] = independent else { return String::new() };
    let d = |name: &str| format!("D({function}, {name})");
    format!(
        "along the edge from the corner {last} = 1 to {first} = 1 it is `{}`, from {second} = 1 to {first} = 1 `{} - {}`",
        d(first),
        d(first),
        d(second)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_what_was_meant() {
        assert_eq!(closest("symetric", &["symmetric", "nonnegative"]), Some("symmetric"));
        assert_eq!(closest("porve", &["prove", "refute"]), Some("prove"));
        assert_eq!(closest("zebra", &["prove", "refute"]), None);
    }
}

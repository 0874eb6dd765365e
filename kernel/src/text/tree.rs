//! Nested lists.

use crate::refusal::Refusal;

/// Brackets within each other.
const MAX_DEPTH: usize = 1000;
/// The longest word; a longer number is refused before any arithmetic.
const MAX_WORD: usize = 100_000;

/// A word or a list.
pub(super) enum Tree<'t> {
    Word(&'t str),
    List(Vec<Tree<'t>>),
}

impl<'t> Tree<'t> {
    /// Reads a text that is one tree.
    pub(super) fn read(text: &'t str) -> Result<Self, Refusal> {
        // The lists that are open, the outermost first.
        let mut open: Vec<Vec<Self>> = vec![Vec::new()];
        let mut rest = text;
        while let Some(c) = rest.chars().next() {
            match c {
                '(' => {
                    if open.len() > MAX_DEPTH {
                        return Err(Refusal::Unfit("the text is nested too deeply"));
                    }
                    open.push(Vec::new());
                    rest = &rest[1..];
                }
                ')' => {
                    let done = open.pop().filter(|_| !open.is_empty());
                    let list = done.ok_or(Refusal::Unfit("a bracket is closed that is not open"))?;
                    if let Some(outer) = open.last_mut() {
                        outer.push(Self::List(list));
                    }
                    rest = &rest[1..];
                }
                ' ' => rest = &rest[1..],
                _ => {
                    let end = rest.find(['(', ')', ' ']).unwrap_or(rest.len());
                    if end > MAX_WORD {
                        return Err(Refusal::Unfit("a word is too long"));
                    }
                    if let Some(list) = open.last_mut() {
                        list.push(Self::Word(&rest[..end]));
                    }
                    rest = &rest[end..];
                }
            }
        }
        let outermost = open.pop().filter(|_| open.is_empty());
        let mut all = outermost.ok_or(Refusal::Unfit("a bracket is not closed"))?;
        let only = all.pop().filter(|_| all.is_empty());
        only.ok_or(Refusal::Unfit("the text is not one list or word"))
    }

    pub(super) fn list(&self) -> Result<&[Self], Refusal> {
        match self {
            Self::List(list) => Ok(list),
            Self::Word(_) => Err(Refusal::Unfit("a list is expected")),
        }
    }

    pub(super) fn word(&self) -> Result<&'t str, Refusal> {
        match self {
            Self::Word(word) => Ok(word),
            Self::List(_) => Err(Refusal::Unfit("a word is expected")),
        }
    }

    /// The word with which a list begins, and the rest of it; a word alone begins with nothing.
    pub(super) fn headed(&self) -> (&'t str, &[Self]) {
        match self {
            Self::List(list) => match list.split_first() {
                Some((Self::Word(head), rest)) => (head, rest),
                _ => ("", list),
            },
            Self::Word(_) => ("", &[]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn depth_and_words_have_limits() {
        let nested = |depth: usize| format!("{}x{}", "(".repeat(depth), ")".repeat(depth));
        assert!(Tree::read(&nested(MAX_DEPTH)).is_ok());
        for deeper in [1, 2, 100] {
            assert!(Tree::read(&nested(MAX_DEPTH + deeper)).is_err());
        }
        assert!(Tree::read(&"1".repeat(MAX_WORD)).is_ok());
        for longer in [1, 2, 100] {
            assert!(Tree::read(&"1".repeat(MAX_WORD + longer)).is_err());
        }
    }
}

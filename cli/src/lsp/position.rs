//! Positions of the protocol: lines and UTF-16 units, both counted from zero, beside bytes of a text.

use core::ops::Range;

use lsp_types::{Position, Range as Span};

/// Where the lines of a text begin.
#[derive(Debug, Default)]
pub(super) struct Lines {
    starts: Vec<usize>,
}

impl Lines {
    /// Of a text with `\n` line ends.
    pub(super) fn new(text: &str) -> Self {
        let next = text.bytes().enumerate().filter(|(_, b)| *b == b'\n').map(|(at, _)| at + 1);
        Self { starts: [0].into_iter().chain(next).collect() }
    }

    /// The position of a byte; of one inside of a character that of the character.
    pub(super) fn position(&self, text: &str, offset: usize) -> Position {
        let mut offset = offset.min(text.len());
        while !text.is_char_boundary(offset) {
            offset -= 1;
        }
        let line = self.starts.partition_point(|start| *start <= offset) - 1;
        let units = text[self.starts[line]..offset].encode_utf16().count();
        Position::new(line as u32, units as u32)
    }

    /// The range of some bytes.
    pub(super) fn span(&self, text: &str, range: &Range<usize>) -> Span {
        Span::new(self.position(text, range.start), self.position(text, range.end))
    }

    /// The byte at a position; a position behind a line is the end of the line, one behind the text that of the text.
    pub(super) fn offset(&self, text: &str, position: Position) -> usize {
        let line = position.line as usize;
        let Some(start) = self.starts.get(line).copied() else { return text.len() };
        let end = self.starts.get(line + 1).map_or(text.len(), |next| next - 1);
        let mut units = 0;
        for (at, c) in text[start..end].char_indices() {
            if units >= position.character as usize {
                return start + at;
            }
            units += c.len_utf16();
        }
        end
    }

    /// The bytes of a range.
    pub(super) fn bytes(&self, text: &str, span: Span) -> Range<usize> {
        let start = self.offset(text, span.start);
        start..self.offset(text, span.end).max(start)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_utf_16() {
        let text = "λ𝔸x\nb";
        let lines = Lines::new(text);
        assert_eq!(lines.position(text, 2), Position::new(0, 1));
        assert_eq!(lines.position(text, 6), Position::new(0, 3));
        assert_eq!(lines.position(text, 4), Position::new(0, 1));
        assert_eq!(lines.position(text, 99), Position::new(1, 1));
        assert_eq!(lines.offset(text, Position::new(0, 3)), 6);
        assert_eq!(lines.offset(text, Position::new(0, 99)), 7);
        assert_eq!(lines.offset(text, Position::new(7, 0)), text.len());
    }
}

//! Places in a text, counted as JavaScript counts them.

/// The UTF-16 code units before each byte of a text.
#[derive(Debug, Default)]
pub(crate) struct Places(Vec<u32>);

impl Places {
    pub(crate) fn new(text: &str) -> Self {
        let mut before = Vec::with_capacity(text.len() + 1);
        let mut units = 0;
        for c in text.chars() {
            before.extend(std::iter::repeat_n(units, c.len_utf8()));
            units += c.len_utf16() as u32;
        }
        before.push(units);
        Self(before)
    }

    /// The place of a byte; of one beyond the text its end.
    pub(crate) fn at(&self, byte: usize) -> u32 {
        self.0.get(byte).or(self.0.last()).copied().unwrap_or(0)
    }

    /// The byte at a place; of a place beyond the text its end.
    pub(crate) fn byte(&self, place: u32) -> usize {
        self.0.partition_point(|before| *before < place).min(self.0.len().saturating_sub(1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_of_any_length() {
        let text = "aλ𝛼b";
        let places = Places::new(text);
        let starts: Vec<u32> = text.char_indices().map(|(byte, _)| places.at(byte)).collect();
        assert_eq!(starts, [0, 1, 2, 4]);
        assert_eq!(places.at(text.len()), 5);
        assert_eq!(places.at(99), 5);
        let back: Vec<usize> = starts.iter().map(|place| places.byte(*place)).collect();
        assert_eq!(back, [0, 1, 3, 7]);
        assert_eq!(places.byte(99), text.len());
        assert_eq!(Places::new("").byte(3), 0);
    }
}

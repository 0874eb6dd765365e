//! What can be wrong with the text of a path.

use core::error::Error;
use core::fmt::{self, Display, Formatter};

/// A text that is no path of SVG, with the place of the mistake.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SvgError {
    mistake: SvgMistake,
    offset: usize,
}

impl SvgError {
    #[cold]
    pub(super) fn new(mistake: SvgMistake, offset: usize) -> Self {
        Self { mistake, offset }
    }

    /// What is wrong.
    pub fn mistake(&self) -> SvgMistake {
        self.mistake
    }

    /// The place in the text, as the number of bytes before it.
    pub fn offset(&self) -> usize {
        self.offset
    }
}

/// What is wrong with the text of a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SvgMistake {
    /// A character that begins no command.
    Command(char),
    /// A path does not begin with `M` or `m`.
    NoMove,
    /// A command has too few numbers: here is not the next one.
    Number {
        /// The letter of the command.
        command: char,
        /// How many numbers the command takes at a time.
        takes: usize,
    },
    /// A flag of an arc is neither 0 nor 1.
    Flag,
    /// A number is too large.
    Size,
}

impl Display for SvgError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "byte {}: ", self.offset)?;
        match self.mistake {
            SvgMistake::Command(found) => {
                write!(
                    f,
                    "`{found}` begins no command of a path; those are M L H V C S Q T A Z and the small letters"
                )
            }
            SvgMistake::NoMove => write!(f, "a path begins with `M` or `m` and a point"),
            SvgMistake::Number { command, takes } => {
                write!(f, "a number is missing: the command `{command}` takes {takes} at a time")
            }
            SvgMistake::Flag => {
                write!(f, "a flag is missing: the fourth and the fifth number of an arc are 0 or 1")
            }
            SvgMistake::Size => write!(f, "the number is too large"),
        }
    }
}

impl Error for SvgError {}

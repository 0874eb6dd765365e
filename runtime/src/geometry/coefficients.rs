//! A list of numbers of which short ones need no allocation.

use alloc::vec::Vec;
use core::ops::{Deref, DerefMut};

/// The longest list that is kept in place: a rational cubic in space.
const INLINE: usize = 16;

/// The coefficients of a piece of a curve.
#[derive(Clone, Debug)]
pub(super) enum Coefficients {
    Short(usize, [f64; INLINE]),
    Long(Vec<f64>),
}

impl Coefficients {
    /// An empty list with room for `count` numbers.
    #[inline]
    pub(super) fn with_capacity(count: usize) -> Self {
        if count <= INLINE { Self::Short(0, [0.0; INLINE]) } else { Self::Long(Vec::with_capacity(count)) }
    }

    #[inline]
    pub(super) fn push(&mut self, number: f64) {
        match self {
            Self::Short(len, numbers) if *len < INLINE => {
                numbers[*len] = number;
                *len += 1;
            }
            Self::Short(_, numbers) => {
                let mut long = numbers.to_vec();
                long.push(number);
                *self = Self::Long(long);
            }
            Self::Long(numbers) => numbers.push(number),
        }
    }

    #[inline]
    pub(super) fn truncate(&mut self, count: usize) {
        match self {
            Self::Short(len, _) => *len = count.min(*len),
            Self::Long(numbers) => numbers.truncate(count),
        }
    }
}

impl Extend<f64> for Coefficients {
    #[inline]
    fn extend<I: IntoIterator<Item = f64>>(&mut self, numbers: I) {
        for number in numbers {
            self.push(number);
        }
    }
}

impl From<Vec<f64>> for Coefficients {
    #[inline]
    fn from(numbers: Vec<f64>) -> Self {
        if numbers.len() > INLINE {
            return Self::Long(numbers);
        }
        let mut short = [0.0; INLINE];
        short[..numbers.len()].copy_from_slice(&numbers);
        Self::Short(numbers.len(), short)
    }
}

impl Deref for Coefficients {
    type Target = [f64];

    #[inline]
    fn deref(&self) -> &[f64] {
        match self {
            Self::Short(len, numbers) => &numbers[..*len],
            Self::Long(numbers) => numbers,
        }
    }
}

impl DerefMut for Coefficients {
    #[inline]
    fn deref_mut(&mut self) -> &mut [f64] {
        match self {
            Self::Short(len, numbers) => &mut numbers[..*len],
            Self::Long(numbers) => numbers,
        }
    }
}

impl PartialEq for Coefficients {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

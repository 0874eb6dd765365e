//! A short list of numbers or points on the stack, for the degrees that occur, or on the heap for all others.

use alloc::vec;
use alloc::vec::Vec;
use core::ops::{Deref, DerefMut};

/// Enough for degree 15.
const STACK: usize = 16;

pub(super) enum Buffer<T> {
    Stack([T; STACK], usize),
    Heap(Vec<T>),
}

impl<T: Copy> Buffer<T> {
    /// That many copies of `value`.
    #[inline]
    pub(super) fn filled(value: T, len: usize) -> Self {
        if len <= STACK { Self::Stack([value; STACK], len) } else { Self::Heap(vec![value; len]) }
    }
}

impl<T> Deref for Buffer<T> {
    type Target = [T];

    #[inline]
    fn deref(&self) -> &[T] {
        match self {
            Self::Stack(array, len) => &array[..*len],
            Self::Heap(list) => list,
        }
    }
}

impl<T> DerefMut for Buffer<T> {
    #[inline]
    fn deref_mut(&mut self) -> &mut [T] {
        match self {
            Self::Stack(array, len) => &mut array[..*len],
            Self::Heap(list) => list,
        }
    }
}

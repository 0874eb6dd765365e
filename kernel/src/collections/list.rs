//! Lists from lists, at little cost to compile.
//!
//! `iter().map(f).collect()` compiles some ten functions for each closure, and every user of the macro builds them all;
//! so a slice is `mapped`.

/// What a list can be made into.
pub trait Mapped<T> {
    /// The values of a function for all elements.
    fn mapped<'a, U>(&'a self, f: impl FnMut(&'a T) -> U) -> Vec<U>
    where
        T: 'a;
}

impl<T> Mapped<T> for [T] {
    fn mapped<'a, U>(&'a self, mut f: impl FnMut(&'a T) -> U) -> Vec<U>
    where
        T: 'a,
    {
        let mut list = Vec::with_capacity(self.len());
        for element in self {
            list.push(f(element));
        }
        list
    }
}

//! Lists from lists and iterators, at little cost to compile: a slice is `mapped`, and where an iterator says more, its
//! elements are `listed`.

pub use basis_kernel::collections::list::Mapped;

/// What an iterator can be made into without the code by which `collect` reserves room.
pub trait Listed: Iterator + Sized {
    /// All elements.
    #[expect(clippy::while_let_on_iterator, reason = "`for` compiles another function for each iterator")]
    fn listed(mut self) -> Vec<Self::Item> {
        let mut list = Vec::new();
        while let Some(element) = self.next() {
            list.push(element);
        }
        list
    }
}

impl<I: Iterator> Listed for I {}

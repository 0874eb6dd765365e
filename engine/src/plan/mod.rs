//! stub
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input { Coordinate(usize), Shape(usize), Point(usize), Derivative(usize), Bound(usize) }

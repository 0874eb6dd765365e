//! What is asked of curves: where they are, how long, how they bend, and their parts.

mod extents;
mod frames;
mod length;
mod nearest;
mod parts;
mod piecewise;
mod shape;

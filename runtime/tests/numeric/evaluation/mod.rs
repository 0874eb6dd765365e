//! Values of functions and points of curves.

mod accuracy;
mod derivatives;
mod domain;
mod ends;
mod extrapolation;
mod infer;
mod not_a_number;
mod points;
mod slices;
mod values;

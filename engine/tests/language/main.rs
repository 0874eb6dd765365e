//! Specs and what is said of them: verdicts on claims, messages, names of the library.

mod assumed;
mod assumed_denominators;
mod assumed_exceptions;
mod assumed_otherwise;
mod assumed_without_ends;
mod beside;
mod chebyshev;
mod ends_at_sums;
mod finer_parts;
mod integrals;
mod language_reference;
mod library_of_specs;
mod literature;
mod many_variables;
mod one_mistake;
mod over_spans;
mod parts_of_a_turn;
mod rechecked;
mod related;
mod rendering;
#[path = "../support/mod.rs"]
mod support;
mod touching;
mod verdicts;

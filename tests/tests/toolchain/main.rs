//! What a build does with a spec: messages, generated code, budgets, and when it runs again.

mod diagnostics;
mod expansion;
mod hostile_specs;
mod rebuild;

//! stub
#![allow(missing_docs)]
use crate::algebra::{poly::*, range::*, rational::*};
#[derive(Clone, Debug)] pub enum Coordinate { Rational(Rational) }
impl Coordinate { pub fn describe(&self, n: &str) -> String { let Self::Rational(r) = self; format!("{n} = {r}") } }
#[derive(Clone, Debug)] pub struct Witness { pub point: Vec<(Var, Coordinate)>, pub value: Rational }
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)] pub enum Method { A }
impl core::fmt::Display for Method { fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result { write!(f, "stub") } }
#[derive(Clone, Debug)] pub struct Proof { pub method: Method }
#[derive(Clone, Copy, Debug)] pub enum Relation { NonNegative, Positive }
pub enum Decision { Proved(Proof), Refuted(Witness), Undecided(String) }
pub struct Budget; impl Budget { pub fn scaled(_: u32) -> Self { Budget } }
pub fn decide(_: &Poly, _: Relation, _: &Region, _: &mut Budget) -> Decision { Decision::Undecided("stub".into()) }

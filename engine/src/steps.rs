//! stub
use crate::algebra::rational::Rational;
use crate::plan::Input;
#[derive(Clone, Debug, PartialEq)]
pub enum Step { Input(Input), Number(Rational), Neg(usize), Sum(usize, usize), Difference(usize, usize), Product(usize, usize), Quotient(usize, usize) }
impl Step {
    /// The steps that it is made of.
    pub fn operands(&self) -> Vec<usize> {
        match self { Self::Input(_) | Self::Number(_) => vec![], Self::Neg(a) => vec![*a], Self::Sum(a,b)|Self::Difference(a,b)|Self::Product(a,b)|Self::Quotient(a,b) => vec![*a,*b] }
    }
}
#[derive(Clone, Debug)]
pub struct Steps { pub steps: Vec<Step>, pub outputs: Vec<usize> }

//! stub
use crate::algebra::rational::Rational;
use crate::plan::Input;
#[derive(Clone, Debug, PartialEq)]
pub enum Step { Input(Input), Constant(Rational), Neg(usize), Add(usize, usize), Sub(usize, usize), Mul(usize, usize), Div(usize, usize) }
impl Step {
    /// The steps that it is made of.
    pub fn operands(&self) -> Vec<usize> {
        match self { Self::Input(_) | Self::Constant(_) => vec![], Self::Neg(a) => vec![*a], Self::Add(a,b)|Self::Sub(a,b)|Self::Mul(a,b)|Self::Div(a,b) => vec![*a,*b] }
    }
}
#[derive(Clone, Debug)]
pub struct Steps { pub steps: Vec<Step>, pub outputs: Vec<usize> }

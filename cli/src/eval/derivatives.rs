//! All partial derivatives up to an order.

use basis_engine::algebra::fraction::Fraction;
use basis_engine::algebra::work::Work;
use basis_engine::{Diagnostic, Family};

use crate::output::error;

/// More values than this are refused.
const MAX_VALUES: usize = 100_000;

/// One derivative of all functions.
#[derive(Debug)]
pub(super) struct Derivative {
    /// How often each domain variable is differentiated in; all zero for the functions themselves.
    pub(super) orders: Vec<u32>,
    /// The derivative of each function.
    pub(super) functions: Vec<Fraction>,
}

/// The functions and all their partial derivatives of orders 1, …, `order`: by order, within one order those in
/// the first variable first, each mixed derivative once.
///
/// # Errors
/// There are too many of them.
pub(super) fn up_to(
    family: &Family,
    functions: Vec<Fraction>,
    order: u32,
) -> Result<Vec<Derivative>, Diagnostic> {
    let variables = family.domain.len();
    let most =
        (0..=order).take_while(|k| number(functions.len(), variables, *k) <= MAX_VALUES).last().unwrap_or(0);
    if most < order {
        let message = format!("there are too many derivatives up to order {order}");
        return Err(error(message)
            .help(format!("ask for --order {most} at most; above the degree all derivatives are zero")));
    }
    let mut all = vec![Derivative { orders: vec![0; variables], functions }];
    let mut first_of_last = 0;
    for _ in 0..order {
        let last = first_of_last..all.len();
        first_of_last = all.len();
        for from in last {
            // Differentiating in the last variable that occurs, or a later one, reaches each derivative once.
            let start = all[from].orders.iter().rposition(|k| *k > 0).unwrap_or(0);
            for k in start..variables {
                let mut orders = all[from].orders.clone();
                orders[k] += 1;
                let var = family.domain[k].var;
                let derivative = |f| family.derivative_within(f, var, &mut Work::unlimited());
                let functions = all[from].functions.iter().filter_map(derivative).collect();
                all.push(Derivative { orders, functions });
            }
        }
    }
    Ok(all)
}

/// The number of values up to an order: functions · binomial(order + variables, variables).
fn number(functions: usize, variables: usize, order: u32) -> usize {
    let steps =
        (1..=variables).try_fold(1_usize, |product, k| Some(product.checked_mul(order as usize + k)? / k));
    steps.and_then(|n| n.checked_mul(functions)).unwrap_or(usize::MAX)
}

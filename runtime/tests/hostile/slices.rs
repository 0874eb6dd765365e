//! Polynomials as slices of Bernstein coefficients, of every length down to none.

use basis_runtime::bernstein::{
    bounds, centred_powers, differentiate, dot, elevate, eval, eval_with_derivs, keep_left, keep_right,
    multiply, restrict, roots, split,
};

use crate::{Case, P, check};

const SLICES: &[Case<Vec<P>>] = &[
    ("eval", |p, a, _| {
        let _ = eval(p, a);
        true
    }),
    ("eval_with_derivs", |p, a, _| {
        for count in [0, 1, 3, 9] {
            eval_with_derivs(p, a, &mut p.clone(), &mut vec![[0.0; 3]; count]);
        }
        true
    }),
    ("keep_left", |p, a, _| {
        keep_left(&mut p.clone(), a);
        true
    }),
    ("keep_right", |p, a, _| {
        keep_right(&mut p.clone(), a);
        true
    }),
    ("split", |p, a, _| {
        split(&mut p.clone(), a, &mut p.clone());
        true
    }),
    ("restrict", |p, a, b| {
        restrict(&mut p.clone(), a, b);
        true
    }),
    ("elevate", |p, _, _| {
        elevate(p, &mut vec![[0.0; 3]; p.len() + 3]);
        true
    }),
    ("centred_powers", |p, _, _| {
        centred_powers(&mut p.clone());
        true
    }),
    ("differentiate", |p, _, _| differentiate(&mut p.clone()).len() <= p.len()),
    ("multiply", |p, a, _| {
        let x: Vec<f64> = p.iter().map(|p| p[0] + a).collect();
        multiply(&x, &x, &mut vec![0.0; (2 * x.len()).saturating_sub(1)]);
        true
    }),
    ("dot", |p, _, _| {
        dot(p, p, &mut vec![0.0; (2 * p.len()).saturating_sub(1)]);
        true
    }),
    ("bounds", |p, a, _| {
        let x: Vec<f64> = p.iter().map(|p| p[0] + a).collect();
        let [low, high] = bounds(&x);
        low <= high || low.is_nan() || high.is_nan() || x.is_empty()
    }),
    ("roots", |p, a, b| {
        let x: Vec<f64> = p.iter().map(|p| p[0] * a + b).collect();
        roots(&x).iter().all(|root| (0.0..=1.0).contains(&root.x))
    }),
];

pub(crate) const NAMES: &[&str] = &{
    let mut names = [""; SLICES.len()];
    let mut k = 0;
    while k < names.len() {
        names[k] = SLICES[k].0;
        k += 1;
    }
    names
};

#[test]
fn slices() {
    for count in [0, 1, 2, 5, 12] {
        check(SLICES, |net| Some((0..count).map(net).collect()));
    }
}

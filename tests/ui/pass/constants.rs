//! Constants with the names of local names: a pattern must not match against them.
#![allow(dead_code, non_upper_case_globals)]

const s: f64 = 1.0;
const x: f64 = 2.0;
const t: f64 = 3.0;
const lambda: f64 = 4.0;
const beta1: f64 = 4.0;
const c0: f64 = 5.0;
const c1: f64 = 5.0;
const r0: f64 = 6.0;
const s2: f64 = 7.0;
const x2: f64 = 7.0;
const points: f64 = 8.0;
const order: f64 = 9.0;
const weights: f64 = 10.0;
const i: f64 = 11.0;
const j: f64 = 12.0;
static k: f64 = 12.0;

basis_runtime::basis!("../../../specs/quartic.basis");
basis_runtime::basis!("../../../specs/beta_spline.basis");

fn main() {
    let quartic = QuarticBernstein::new(0.5).unwrap();
    assert_eq!(quartic.values(0.0), [1.0, 0.0, 0.0, 0.0]);
    assert!(BetaSpline::<f64>::new(1.0, 0.0).is_ok());
}

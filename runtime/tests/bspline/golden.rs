//! Against scipy: `tests/golden/bspline.py` writes the data.

use basis_runtime::bspline::{BSplineCurve, BSplineSurface, KnotVector, Net};
use serde_json::Value;

pub(crate) fn golden(kind: &str) -> Vec<Value> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/bspline.json");
    let text = std::fs::read_to_string(path).expect("the golden data is in the repository");
    let data: Value = serde_json::from_str(&text).expect("the golden data is JSON");
    let cases = data[kind].as_array().expect("a list of cases").clone();
    assert!(!cases.is_empty());
    cases
}

pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

pub(crate) fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(number).collect()
}

pub(crate) fn points<const D: usize>(value: &Value) -> Vec<[f64; D]> {
    let point = |value: &Value| numbers(value).try_into().expect("D components");
    value.as_array().expect("a list").iter().map(point).collect()
}

pub(crate) fn index(value: &Value) -> usize {
    usize::try_from(value.as_u64().expect("an index")).expect("a small number")
}

pub(crate) fn knots(degree: &Value, knots: &Value) -> KnotVector<f64> {
    KnotVector::new(index(degree), numbers(knots)).expect("scipy's knots are valid")
}

pub(crate) fn curve<const D: usize>(case: &Value) -> BSplineCurve<[f64; D]> {
    let knots = knots(&case["degree"], &case["knots"]);
    BSplineCurve::new(knots, points(&case["points"])).expect("a valid curve")
}

/// Checks components against scipy's, relative to the largest of them.
#[track_caller]
pub(crate) fn assert_near<const D: usize>(found: &[[f64; D]], expected: &[[f64; D]], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    let size = expected.iter().flatten().fold(1.0, |size: f64, x| size.max(x.abs()));
    for (index, (a, b)) in found.iter().zip(expected).enumerate() {
        for (x, y) in a.iter().zip(b) {
            assert!((x - y).abs() <= tolerance * size, "{index}: {a:?} is not scipy's {b:?}");
        }
    }
}

#[test]
fn curves_and_their_derivatives() {
    for case in golden("curves") {
        let curve = curve::<3>(&case);
        let parameters = numbers(&case["parameters"]);
        for (order, expected) in case["derivatives"].as_array().unwrap().iter().enumerate() {
            let expected = points::<3>(expected);
            let found: Vec<_> = parameters.iter().map(|&t| curve.derivative(t, order)).collect();
            assert_near(&found, &expected, 2e-13);
        }
        let all: Vec<[_; 4]> = parameters.iter().map(|&t| curve.eval_with_derivs(t)).collect();
        assert!(parameters.iter().zip(&all).all(|(&t, all)| all[2] == curve.derivative(t, 2)));
    }
}

#[test]
fn surfaces_and_their_partial_derivatives() {
    for case in golden("surfaces") {
        let (u, v) = (knots(&case["degrees"][0], &case["u"]), knots(&case["degrees"][1], &case["v"]));
        let rows: Vec<_> = case["net"].as_array().unwrap().iter().map(points::<3>).collect();
        let surface = BSplineSurface::new(u, v, Net::from_rows(rows).unwrap()).unwrap();
        let parameters = points::<2>(&case["parameters"]);
        let orders = case["orders"].as_array().unwrap();
        for (order, expected) in orders.iter().zip(case["partials"].as_array().unwrap()) {
            let order = [index(&order[0]), index(&order[1])];
            let found: Vec<_> = parameters.iter().map(|&[u, v]| surface.partial(u, v, order)).collect();
            assert_near(&found, &points::<3>(expected), 2e-13);
        }
    }
}

#[test]
fn inserted_knots() {
    for case in golden("insertions") {
        let finer = curve::<2>(&case).insert_knots(&numbers(&case["inserted"])).unwrap();
        assert_near(finer.control_points(), &points::<2>(&case["finer"]), 1e-14);
    }
}

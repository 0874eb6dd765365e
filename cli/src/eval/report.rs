//! Values as JSON and as a table.

use basis_engine::Family;
use basis_engine::algebra::rational::Rational;
use serde::Serialize;
use serde_json::{Map, Value};

use super::derivatives::Derivative;
use super::point::Point;
use crate::table::{self, Row, STRONG, styled};

/// The exact values of a family at a point.
#[derive(Debug)]
pub(super) struct Values {
    /// The family and the point, such as `QuarticBernstein at λ = 1/2, t = 1/3`.
    heading: String,
    /// `b[0]` and so on, with their values.
    functions: Vec<(String, Rational)>,
    /// `D(b[0])`, `D(b[0],2)` or `D(b[0,0],u,v)` and so on, with their values.
    derivatives: Vec<(String, Rational)>,
}

/// What `basis eval --format json` prints.
#[derive(Debug, Serialize)]
pub(super) struct Report {
    values: Map<String, Value>,
    derivatives: Map<String, Value>,
}

impl Values {
    /// The values of functions and derivatives at a point.
    pub(super) fn new(family: &Family, point: &Point, all: &[Derivative]) -> Self {
        let labels = (0..family.functions.len()).map(|k| family.function_label(k));
        let labels: Vec<String> = labels.collect();
        let evaluated = |derivative: &Derivative| -> Vec<(String, Rational)> {
            let values = labels.iter().zip(&derivative.functions);
            values
                .filter_map(|(label, f)| {
                    // A point at which a denominator vanishes has been refused.
                    Some((key(family, label, &derivative.orders), f.eval(point.values())?))
                })
                .collect()
        };
        let mut tables = all.iter().map(evaluated);
        let parameters = family.shapes.iter().chain(family.domain_variables());
        Self {
            heading: format!("{} at {}", family.title(), point.describe(parameters)),
            functions: tables.next().unwrap_or_default(),
            derivatives: tables.flatten().collect(),
        }
    }

    /// Fractions as strings, by function.
    pub(super) fn json(&self) -> Report {
        let map = |values: &[(String, Rational)]| {
            values.iter().map(|(key, value)| (key.clone(), Value::from(value.to_string()))).collect()
        };
        Report { values: map(&self.functions), derivatives: map(&self.derivatives) }
    }

    /// A table of fractions and decimals.
    pub(super) fn text(&self, width: Option<u16>) -> String {
        let all = || self.functions.iter().chain(&self.derivatives);
        // Numbers with and without a sign stand below one another.
        let pad = if all().any(|(_, value)| value.is_negative()) { " " } else { "" };
        let signed = |text: String| if text.starts_with('-') { text } else { format!("{pad}{text}") };
        let rows: Vec<_> = all()
            .map(|(key, value)| Row {
                mark: None,
                cells: vec![key.clone(), signed(value.to_string()), signed(decimal(value))],
            })
            .collect();
        let table = table::layout(&["function", "exact", "decimal"], &rows, &[], width);
        format!("{}\n{table}", styled(STRONG, &self.heading))
    }
}

/// `b[0]`, `D(b[0])`, `D(b[0],2)`; on several domain variables `D(b[0,0],u,u,v)`.
fn key(family: &Family, label: &str, orders: &[u32]) -> String {
    match (family.domain.as_slice(), orders) {
        (_, orders) if orders.iter().all(|k| *k == 0) => label.to_string(),
        ([_], [1]) => format!("D({label})"),
        ([_], [order]) => format!("D({label},{order})"),
        (domain, _) => {
            let names = domain.iter().zip(orders).flat_map(|(p, k)| (0..*k).map(|_| p.name.as_str()));
            format!("D({label},{})", names.collect::<Vec<_>>().join(","))
        }
    }
}

/// The nearest decimal with twelve digits after the point, fewer where they are zero.
fn decimal(value: &Rational) -> String {
    let x = value.to_f64();
    if x == 0.0 || (1e-6..1e15).contains(&x.abs()) {
        let text = format!("{x:.12}");
        return text.trim_end_matches('0').trim_end_matches('.').to_string();
    }
    if x.is_finite() { format!("{x:.9e}") } else { String::new() }
}

#[cfg(test)]
mod tests {
    use basis_engine::algebra::rational::parse;

    use super::*;

    #[test]
    fn decimals_are_as_short_as_they_can_be() {
        let of = |text: &str| decimal(&parse(text).expect("a number"));
        assert_eq!([of("0"), of("-3"), of("1/4"), of("-2/3")], ["0", "-3", "0.25", "-0.666666666667"]);
        assert_eq!([of("1/3000000000"), of("12345678901234567890")], ["3.333333333e-10", "1.234567890e19"]);
    }
}

//! Values as JSON, as CSV, and as tables.

use basis_engine::Family;
use basis_engine::algebra::rational::{Rational, ToFloat as _};
use serde::Serialize;
use serde_json::{Map, Value};

use super::derivatives::Derivative;
use super::number::Number;
use super::point::Point;
use crate::table::{self, Row, STRONG, styled};

/// A number, perhaps rounded to fifty digits.
#[derive(Clone, Debug)]
pub(super) struct Cell {
    value: Rational,
    rounded: bool,
}

impl Cell {
    /// The fraction, or the nearest decimal of one that is rounded.
    fn text(&self) -> String {
        if self.rounded { self.value.to_f64().to_string() } else { self.value.to_string() }
    }

    /// The fraction; nothing for one that is rounded.
    fn exact(&self) -> String {
        if self.rounded { String::new() } else { self.value.to_string() }
    }

    /// The nearest decimal with twelve digits.
    fn decimal(&self) -> String {
        decimal(&self.value)
    }

    /// As text with a fraction or as decimal.
    fn shown(&self, decimals: bool) -> String {
        if decimals || self.rounded { self.decimal() } else { self.text() }
    }
}

/// The values of a family at a point.
#[derive(Debug)]
pub(super) struct Values {
    /// The span of several on which the point lies, such as `1 <= x <= 3`.
    span: Option<String>,
    /// The names of the parameters with their values as they were typed: the shape parameters, then the domain variables.
    parameters: Vec<(String, String)>,
    /// `b[0]` and so on, with their values.
    functions: Vec<(String, Cell)>,
    /// `D(b[0])`, `D(b[0],2)` or `D(b[0,0],u,v)` and so on, with their values.
    derivatives: Vec<(String, Cell)>,
    /// `C`, `D(C)` and so on, with their coordinates; nothing without control points.
    points: Vec<(String, Vec<Cell>)>,
}

/// The values of a family at one point or at several.
#[derive(Debug)]
pub(super) struct Report {
    /// The family with its order.
    pub(super) title: String,
    /// The points.
    pub(super) rows: Vec<Values>,
    /// Whether one point was asked for, and not several.
    pub(super) single: bool,
}

/// What is printed of a point as JSON.
#[derive(Debug, Serialize)]
pub(super) struct Record {
    at: Map<String, Value>,
    #[serde(skip_serializing_if = "Option::is_none")]
    span: Option<String>,
    values: Map<String, Value>,
    derivatives: Map<String, Value>,
    #[serde(skip_serializing_if = "Map::is_empty")]
    curve: Map<String, Value>,
}

/// What `basis eval --format json` prints.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub(super) enum Json {
    /// Of one point.
    One(Box<Record>),
    /// Of several.
    Several { points: Vec<Record> },
}

impl Values {
    /// The values of functions and derivatives at a point, and of the curve or surface with some control points;
    /// `None` where a denominator vanishes.
    pub(super) fn new(
        whole: &Family,
        point: &Point,
        all: &[Derivative],
        control: &[Vec<Rational>],
    ) -> Option<Self> {
        let family: &Family = &point.family;
        let labels: Vec<String> = (0..family.functions.len()).map(|k| family.function_label(k)).collect();
        let mut tables = Vec::new();
        let mut points = Vec::new();
        for derivative in all {
            let mut table = Vec::new();
            for (k, (label, f)) in labels.iter().zip(&derivative.functions).enumerate() {
                let rounded = point.is_rounded(f) || point.is_rounded(&family.functions[k].value);
                let cell = Cell { value: point.value(f)?, rounded: rounded && !f.is_zero() };
                table.push((key(family, label, &derivative.orders), cell));
            }
            if !control.is_empty() {
                let name = if family.domain.len() == 1 { "C" } else { "S" };
                let coordinate = |axis: usize| {
                    let terms = table.iter().zip(control);
                    let terms = terms.filter(|((_, _), p)| p.get(axis).is_some_and(|x| !x.is_zero()));
                    let mut sum = Cell { value: Rational::ZERO, rounded: false };
                    for ((_, cell), p) in terms {
                        sum.value = &sum.value + &(&cell.value * &p[axis]);
                        sum.rounded |= cell.rounded;
                    }
                    sum
                };
                let dimension = control.first().map_or(0, Vec::len);
                points
                    .push((key(family, name, &derivative.orders), (0..dimension).map(coordinate).collect()));
            }
            tables.push(table);
        }
        let mut tables = tables.into_iter();
        Some(Self {
            span: point.span(whole),
            parameters: family
                .shapes
                .iter()
                .chain(family.domain_variables())
                .map(|p| point.named(p))
                .collect(),
            functions: tables.next().unwrap_or_default(),
            derivatives: tables.flatten().collect(),
            points,
        })
    }

    fn record(&self) -> Record {
        let map = |values: &[(String, Cell)]| {
            values.iter().map(|(key, cell)| (key.clone(), Value::from(cell.text()))).collect()
        };
        let coordinates = |cells: &[Cell]| cells.iter().map(Cell::text).collect::<Vec<_>>();
        Record {
            at: self
                .parameters
                .iter()
                .map(|(name, value)| (name.clone(), Value::from(value.clone())))
                .collect(),
            span: self.span.clone(),
            values: map(&self.functions),
            derivatives: map(&self.derivatives),
            curve: self.points.iter().map(|(key, p)| (key.clone(), Value::from(coordinates(p)))).collect(),
        }
    }

    /// The columns of a line for this point: coordinates of points if there are control points, functions otherwise.
    fn columns(&self) -> Vec<(String, &Cell)> {
        if self.points.is_empty() {
            let all = self.functions.iter().chain(&self.derivatives);
            return all.map(|(key, cell)| (key.clone(), cell)).collect();
        }
        let axis = |k: usize, dimension: usize| match ["x", "y", "z"].get(k) {
            Some(axis) if dimension <= 3 => (*axis).to_string(),
            _ => (k + 1).to_string(),
        };
        let coordinates = |(key, p): &'_ (String, Vec<Cell>)| -> Vec<String> {
            (0..p.len()).map(|k| format!("{key}.{}", axis(k, p.len()))).collect()
        };
        let names = self.points.iter().flat_map(coordinates);
        names.zip(self.points.iter().flat_map(|(_, p)| p)).collect()
    }
}

impl Report {
    /// Fractions as strings, by function; what is not rational as a decimal.
    pub(super) fn json(&self) -> Json {
        match self.rows.as_slice() {
            [one] if self.single => Json::One(Box::new(one.record())),
            rows => Json::Several { points: rows.iter().map(Values::record).collect() },
        }
    }

    /// A line for each point, with a header: parameters, then values.
    pub(super) fn csv(&self, decimals: bool) -> String {
        let mut text = String::new();
        let quoted = |field: &str| {
            if field.contains([',', '"']) {
                format!("\"{}\"", field.replace('"', "\"\""))
            } else {
                field.to_string()
            }
        };
        let mut line = |fields: Vec<String>| {
            let fields: Vec<String> = fields.iter().map(|field| quoted(field)).collect();
            text += &(fields.join(",") + "\n");
        };
        if let Some(first) = self.rows.first() {
            let names = first.parameters.iter().map(|(name, _)| name.clone());
            line(names.chain(first.columns().into_iter().map(|(key, _)| key)).collect());
        }
        for row in &self.rows {
            let values = row.parameters.iter().map(|(_, value)| typed(value, decimals));
            line(values.chain(row.columns().iter().map(|(_, cell)| cell.shown(decimals))).collect());
        }
        text
    }

    /// Of one point a table of fractions and decimals, of several one with a line for each.
    pub(super) fn text(&self, decimals: bool, width: Option<u16>) -> String {
        match self.rows.as_slice() {
            [one] if self.single => self.of_one(one, width),
            rows => self.of_several(rows, decimals, width),
        }
    }

    fn of_one(&self, values: &Values, width: Option<u16>) -> String {
        let mut rows: Vec<(String, String, String)> = Vec::new();
        let numbers = values.functions.iter().chain(&values.derivatives);
        // Numbers with and without a sign stand below one another.
        let pad = if numbers.clone().any(|(_, cell)| cell.value.is_negative()) { " " } else { "" };
        let signed = |text: String| if text.starts_with('-') { text } else { format!("{pad}{text}") };
        if values.points.is_empty() {
            rows.extend(
                numbers.map(|(key, cell)| (key.clone(), signed(cell.exact()), signed(cell.decimal()))),
            );
        }
        for (key, p) in &values.points {
            let joined = |texts: Vec<String>| format!("({})", texts.join(", "));
            let exact = p.iter().all(|cell| !cell.rounded);
            let fractions = if exact { joined(p.iter().map(Cell::exact).collect()) } else { String::new() };
            rows.push((key.clone(), fractions, joined(p.iter().map(Cell::decimal).collect())));
        }
        // At a knot two spans meet.
        let span = values.span.as_ref().map_or_else(String::new, |span| format!(" on {span}"));
        let heading = format!("{}{span} at {}", self.title, assignments(&values.parameters));
        let first = if values.points.is_empty() { "function" } else { "point" };
        // Of sines and exponentials nothing may be exact.
        let exact = rows.iter().any(|(_, exact, _)| !exact.is_empty());
        let header = if exact { vec![first, "exact", "decimal"] } else { vec![first, "decimal"] };
        let cells = |(a, b, c)| if exact { vec![a, b, c] } else { vec![a, c] };
        let rows: Vec<Row> = rows.into_iter().map(|row| Row { mark: None, cells: cells(row) }).collect();
        let table = table::layout(&header, &rows, &[], width);
        format!("{}\n{table}", styled(STRONG, &heading))
    }

    fn of_several(&self, rows: &[Values], decimals: bool, width: Option<u16>) -> String {
        let Some(first) = rows.first() else { return String::new() };
        let varies = |k: usize| rows.iter().any(|row| row.parameters[k].1 != first.parameters[k].1);
        let all = 0..first.parameters.len();
        let (varying, common): (Vec<usize>, Vec<usize>) = all.partition(|k| varies(*k));
        let common: Vec<(String, String)> = common.iter().map(|k| first.parameters[*k].clone()).collect();
        let heading = if common.is_empty() {
            self.title.clone()
        } else {
            format!("{} at {}", self.title, assignments(&common))
        };
        let columns = first.columns();
        let mut header: Vec<&str> = varying.iter().map(|k| first.parameters[*k].0.as_str()).collect();
        header.extend(columns.iter().map(|(key, _)| key.as_str()));
        let line = |row: &Values| {
            let mut cells: Vec<String> =
                varying.iter().map(|k| typed(&row.parameters[*k].1, decimals)).collect();
            cells.extend(row.columns().iter().map(|(_, cell)| cell.shown(decimals)));
            Row { mark: None, cells }
        };
        let lines: Vec<Row> = rows.iter().map(line).collect();
        let right: Vec<usize> = (0..header.len()).collect();
        format!("{}\n{}", styled(STRONG, &heading), table::layout(&header, &lines, &right, width))
    }
}

/// The value of a parameter as it was typed, or as a decimal.
fn typed(value: &str, decimals: bool) -> String {
    let number = Number::parse(value).filter(|_| decimals);
    number.map_or_else(|| value.to_string(), |number| decimal(&number.value()))
}

/// `λ = 1/2, t = 1/3`.
fn assignments(parameters: &[(String, String)]) -> String {
    parameters.iter().map(|(name, value)| format!("{name} = {value}")).collect::<Vec<_>>().join(", ")
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

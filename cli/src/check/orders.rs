//! Values of index parameters as text: `n = 1..=30`.

use basis_kernel::collections::sort::sort_unique;

/// The most orders that are listed when they do not form a range.
const FEW: usize = 4;

/// The values of one order, such as `m = 2, n = 3`.
pub(crate) fn values(order: &[(String, i64)]) -> String {
    let parts: Vec<String> = order.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    parts.join(", ")
}

/// Several orders of one family: `n = 1..=4, 7`, or `m = 1..=3, n = 1..=2` for all pairs of them, or else a list,
/// `(m, n) = (1, 2), (3, 1)`.
pub(crate) fn describe<'o>(orders: impl Iterator<Item = &'o [(String, i64)]>) -> String {
    let mut all: Vec<&[(String, i64)]> = orders.collect();
    sort_unique(&mut all);
    let Some(first) = all.first() else { return String::new() };
    let axes: Vec<Vec<i64>> = (0..first.len())
        .map(|k| {
            let mut axis: Vec<i64> = all.iter().map(|o| o[k].1).collect();
            sort_unique(&mut axis);
            axis
        })
        .collect();
    if axes.iter().map(Vec::len).product::<usize>() == all.len() {
        let parts: Vec<String> =
            first.iter().zip(&axes).map(|((name, _), axis)| format!("{name} = {}", spans(axis))).collect();
        return parts.join(", ");
    }
    let names: Vec<&str> = first.iter().map(|(name, _)| name.as_str()).collect();
    let tuple = |order: &&[(String, i64)]| {
        let values: Vec<String> = order.iter().map(|(_, value)| value.to_string()).collect();
        format!("({})", values.join(", "))
    };
    let tuples: Vec<String> = all.iter().take(FEW).map(tuple).collect();
    let rest = if all.len() > FEW { format!(", … ({} orders)", all.len()) } else { String::new() };
    format!("({}) = {}{rest}", names.join(", "), tuples.join(", "))
}

/// Increasing numbers, neighbours together: `1..=4, 7`.
fn spans(numbers: &[i64]) -> String {
    let mut spans: Vec<(i64, i64)> = Vec::new();
    for &n in numbers {
        match spans.last_mut() {
            Some((_, last)) if *last + 1 == n => *last = n,
            _ => spans.push((n, n)),
        }
    }
    let parts: Vec<String> = spans
        .iter()
        .map(|(first, last)| match last - first {
            0 => first.to_string(),
            1 => format!("{first}, {last}"),
            _ => format!("{first}..={last}"),
        })
        .collect();
    parts.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(orders: &[&[(&str, i64)]]) -> String {
        let orders: Vec<Vec<(String, i64)>> =
            orders.iter().map(|o| o.iter().map(|(n, v)| (String::from(*n), *v)).collect()).collect();
        describe(orders.iter().map(Vec::as_slice))
    }

    #[test]
    fn neighbours_stand_together() {
        assert_eq!(of(&[&[("n", 3)]]), "n = 3");
        assert_eq!(of(&[&[("n", 2)], &[("n", 1)], &[("n", 3)], &[("n", 7)]]), "n = 1..=3, 7");
        assert_eq!(of(&[&[("n", 1)], &[("n", 2)], &[("n", 2)]]), "n = 1, 2");
    }

    #[test]
    fn several_parameters_span_a_box_or_a_list() {
        let all: [&[(&str, i64)]; 4] =
            [&[("m", 1), ("n", 4)], &[("m", 1), ("n", 5)], &[("m", 2), ("n", 4)], &[("m", 2), ("n", 5)]];
        assert_eq!(of(&all), "m = 1, 2, n = 4, 5");
        assert_eq!(of(&all[1..3]), "(m, n) = (1, 5), (2, 4)");
    }
}

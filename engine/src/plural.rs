//! Counts, lists and long formulas as messages have them.

/// `found 1`: how many there are instead.
pub(crate) fn here(n: usize) -> String {
    format!("found {n}")
}

/// `1 index`, `2 indices`.
pub(crate) fn indices(n: usize) -> String {
    if n == 1 { String::from("1 index") } else { format!("{n} indices") }
}

/// `a`, `b` and `c`; of very many words the first.
pub fn list(words: &[String]) -> String {
    const MOST: usize = 40;
    match words {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] if words.len() <= MOST => format!("{} and {last}", first.join(", ")),
        _ => format!("{} and {} others", words[..MOST].join(", "), words.len() - MOST),
    }
}

/// A count with its noun: `1 function`, `4 functions`, `2 families`.
pub fn count(n: usize, noun: &str) -> String {
    match noun.strip_suffix('y') {
        _ if n == 1 => format!("1 {noun}"),
        Some(stem) => format!("{n} {stem}ies"),
        None => format!("{n} {noun}s"),
    }
}

/// A formula, cut after a term when it is longer than a message should be.
pub(crate) fn abbreviated(formula: &str) -> String {
    const LONGEST: usize = 300;
    let Some((limit, _)) = formula.char_indices().nth(LONGEST) else { return formula.to_string() };
    let sign = |text: &str| text.rfind(" + ").max(text.rfind(" - "));
    let Some(end) = sign(&formula[..limit]) else { return formula.to_string() };
    let rest = &formula[end..];
    let left = rest.matches(" + ").count() + rest.matches(" - ").count();
    format!("{} + …, {} more", &formula[..end], count(left, "term"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_formulas_end_after_a_term() {
        assert_eq!(abbreviated("1 - t"), "1 - t");
        let long: Vec<String> = (0..100).map(|k| format!("t^{k}")).collect();
        let short = abbreviated(&long.join(" + "));
        assert!(short.starts_with("t^0 + t^1") && short.ends_with(" + …, 56 terms more"), "{short}");
    }
}

//! Matrices on a page: entries that do not fit beside each other get letters, which are explained below.

use basis_engine::query::latex::{escape, math};

use super::lines::{Fractions, width};

/// The width of a page in tenths of the width of a digit, in the usual size and in small print. In smaller print fractions
/// are no narrower.
const SIZES: [(&str, usize); 2] = [("", 600), ("\\footnotesize\n", 660)];

/// What stands between two columns, in the same unit.
const GAP: usize = 20;

/// The same where columns stand close together.
const NARROW: usize = 8;

/// A matrix of expressions as a display, and the equations of the letters in it.
pub(super) fn matrix(entries: &[Vec<String>]) -> (String, Vec<String>) {
    let formula = |entry: &String| math(entry).unwrap_or_else(|| format!("\\text{{{}}}", escape(entry)));
    let full: Vec<Vec<String>> = entries.iter().map(|row| row.iter().map(formula).collect()).collect();
    if let Some(display) = fitted(&full) {
        return (display, Vec::new());
    }
    let (short, letters) = lettered(entries, &full, usize::MAX);
    if let Some(display) = fitted(&short) {
        return (display, letters);
    }
    let (short, letters) = lettered(entries, &full, 3);
    let smallest = SIZES[SIZES.len() - 1].0;
    (fitted(&short).unwrap_or_else(|| printed(&short, smallest, true)), letters)
}

/// A matrix with letters in place of its different entries, in the order in which they are read, and what they stand for.
/// Numbers of at most some characters stay.
fn lettered(
    entries: &[Vec<String>],
    full: &[Vec<String>],
    longest: usize,
) -> (Vec<Vec<String>>, Vec<String>) {
    let letter = free_letter(entries);
    let is_number = |entry: &str| entry.chars().all(|c| c.is_ascii_digit() || matches!(c, '-' | '/'));
    let mut named: Vec<&String> = Vec::new();
    let mut short = Vec::new();
    for (row, formulas) in entries.iter().zip(full) {
        let mut cells = Vec::new();
        for (entry, formula) in row.iter().zip(formulas) {
            if is_number(entry) && entry.len() <= longest {
                cells.push(formula.clone());
                continue;
            }
            let k = named.iter().position(|known| *known == formula).unwrap_or_else(|| {
                named.push(formula);
                named.len() - 1
            });
            cells.push(format!("{letter}_{{{}}}", k + 1));
        }
        short.push(cells);
    }
    let equations =
        named.iter().enumerate().map(|(k, formula)| format!("{letter}_{{{}}} &= {formula}", k + 1));
    (short, equations.collect())
}

/// A matrix in the largest print in which it fits on a page.
fn fitted(cells: &[Vec<String>]) -> Option<String> {
    let columns = cells.iter().map(Vec::len).max().unwrap_or(0);
    let widest = |k: usize| {
        cells.iter().filter_map(|row| row.get(k)).map(|c| width(c, Fractions::Small)).max().unwrap_or(0)
    };
    let all: usize = (0..columns).map(widest).sum();
    let choices = SIZES.iter().flat_map(|(size, page)| [(size, page, GAP), (size, page, NARROW)]);
    let (size, _, gap) = choices.into_iter().find(|(_, page, gap)| all + columns * gap <= **page)?;
    Some(printed(cells, size, gap == NARROW))
}

fn printed(cells: &[Vec<String>], size: &str, narrow: bool) -> String {
    let rows: Vec<String> = cells.iter().map(|row| row.join(" & ")).collect();
    let close = if narrow { "\\setlength{\\arraycolsep}{2pt}\n" } else { "" };
    format!("{{{size}{close}\\[ \\begin{{pmatrix}} {} \\end{{pmatrix}} \\]}}\n", rows.join(" \\\\ "))
}

/// A letter for entries that stands for nothing else.
fn free_letter(entries: &[Vec<String>]) -> char {
    let taken = |letter: char| {
        let names = entries.iter().flatten().flat_map(|e| e.split(|c: char| !c.is_alphanumeric()));
        names.into_iter().any(|name| name.starts_with(letter))
    };
    "cmaegpqrs".chars().find(|letter| !taken(*letter)).unwrap_or('c')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entries(rows: &[&[&str]]) -> Vec<Vec<String>> {
        rows.iter().map(|row| row.iter().map(ToString::to_string).collect()).collect()
    }

    #[test]
    fn a_matrix_that_fits_stays_as_it_is() {
        let (display, letters) = matrix(&entries(&[&["1", "λ/2"], &["0", "c"]]));
        assert_eq!(display, "{\\[ \\begin{pmatrix} 1 & \\frac{\\lambda}{2} \\\\ 0 & c \\end{pmatrix} \\]}\n");
        assert!(letters.is_empty());
    }

    #[test]
    fn what_is_too_wide_gets_letters_once() {
        let long = "1/30 + 1/420*c + 1/5040*c^2 + 1/77*c^3";
        let other = "2/30 + 1/420*c + 1/5040*c^2 + 1/77*c^3";
        let row: [&str; 6] = [long, other, long, other, long, "1/2"];
        let (display, letters) = matrix(&entries(&[&row]));
        assert!(display.contains("m_{1} & m_{2} & m_{1} & m_{2} & m_{1} & \\frac{1}{2}"), "{display}");
        assert_eq!(letters.len(), 2);
        assert!(letters[1].starts_with("m_{2} &= \\frac{2}{30}"), "{letters:?}");
    }
}

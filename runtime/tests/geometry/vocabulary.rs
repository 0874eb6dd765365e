//! The tables of the front page: which type answers which question.

/// The rows of the table that begins with this head: their cells.
fn table(head: &str) -> Vec<Vec<String>> {
    let page = include_str!("../../src/lib.rs");
    let lines = page.lines().map(|line| line.trim_start_matches("//!").trim());
    let rows = lines.skip_while(|line| !line.starts_with(head)).take_while(|line| line.starts_with('|'));
    rows.map(|row| row.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect()).collect()
}

/// The functions of a trait, from its source, but for those that its documentation hides.
fn functions(source: &str, name: &str) -> Vec<String> {
    let body = source.split(&format!("pub trait {name}")).nth(1).expect("the trait is there");
    let body = body.split("\n}").next().expect("it ends");
    let (mut names, mut hidden) = (Vec::new(), false);
    for line in body.lines() {
        hidden |= line == "    #[doc(hidden)]";
        if let Some(head) = line.strip_prefix("    fn ") {
            if !hidden {
                names.push(head.split(['(', '<']).next().unwrap_or_default().to_owned());
            }
            hidden = false;
        }
    }
    names
}

/// Every function of the traits has a row, every row is one, and an empty cell or a "no" has a reason.
fn agree(head: &str, traits: &[(&str, &str)]) {
    let rows = table(head);
    assert!(rows.len() > 8, "the table {head} is there");
    let mut listed = Vec::new();
    for row in &rows[2..] {
        assert_eq!(row.len(), rows[0].len(), "{row:?}");
        listed.extend(row[0].split('`').skip(1).step_by(2).map(str::to_owned));
        for cell in &row[1..] {
            let reason = cell.strip_prefix("no: ").is_some_and(|reason| reason.split(' ').count() > 2);
            assert!(cell == "yes" || reason, "{row:?}: {cell}");
        }
    }
    let mut expected: Vec<String> =
        traits.iter().flat_map(|&(source, name)| functions(source, name)).collect();
    listed.sort();
    expected.sort();
    assert_eq!(listed, expected);
}

#[test]
fn of_curves() {
    agree("| a curve's", &[(include_str!("../../src/geometry/parametric.rs"), "ParametricCurve")]);
}

#[test]
fn of_surfaces() {
    let [surface, bounded] =
        [include_str!("../../src/surface/mod.rs"), include_str!("../../src/surface/pieces.rs")];
    agree("| a surface's", &[(surface, "Surface"), (bounded, "BoundedSurface")]);
}

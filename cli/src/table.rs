//! Tables without lines: columns aligned by the width of their glyphs, cells wrapped in a narrow terminal.

use anstyle::{AnsiColor, Style};
use comfy_table::{Cell, CellAlignment, ContentArrangement, Table, presets};

/// Words that matter.
pub(crate) const STRONG: Style = Style::new().bold();
/// Words that can be overlooked.
pub(crate) const FAINT: Style = Style::new().dimmed();
/// What is as it should be.
pub(crate) const GOOD: Style = AnsiColor::Green.on_default();
/// What is wrong.
pub(crate) const BAD: Style = AnsiColor::Red.on_default().bold();
/// What is not known.
pub(crate) const OPEN: Style = AnsiColor::Yellow.on_default().bold();

/// Terminals narrower than this cut lines as they like.
const NARROWEST: u16 = 40;

/// The text in a style.
pub(crate) fn styled(style: Style, text: &str) -> String {
    format!("{style}{text}{style:#}")
}

/// The mark of a row, and the style in which it is shown.
pub(crate) type Mark = (&'static str, Style);

/// A row of a table, beginning with a mark.
#[derive(Debug)]
pub(crate) struct Row {
    /// The mark; none in a table without marks.
    pub(crate) mark: Option<Mark>,
    /// The text of each column.
    pub(crate) cells: Vec<String>,
}

/// Lays out rows under a header; `right` lists the columns that are flush right. With a `width` the lines fit
/// into it.
pub(crate) fn layout(header: &[&str], rows: &[Row], right: &[usize], width: Option<u16>) -> String {
    let mut table = Table::new();
    table.load_style(presets::NOTHING);
    match width {
        Some(width) => {
            table.set_content_arrangement(ContentArrangement::Dynamic).set_width(width.max(NARROWEST))
        }
        None => table.set_content_arrangement(ContentArrangement::Disabled),
    };
    let has_marks = rows.iter().any(|row| row.mark.is_some());
    let cells = |mark: Option<Mark>, texts: &mut dyn Iterator<Item = &str>| {
        let mut cells: Vec<Cell> =
            has_marks.then(|| Cell::new(mark.map_or("", |m| m.0))).into_iter().collect();
        cells.extend(texts.enumerate().map(|(k, text)| {
            let cell = Cell::new(text);
            if right.contains(&k) { cell.set_alignment(CellAlignment::Right) } else { cell }
        }));
        cells
    };
    table.set_header(cells(None, &mut header.iter().copied()));
    for row in rows {
        table.add_row(cells(row.mark, &mut row.cells.iter().map(String::as_str)));
    }
    if let (true, Some(first)) = (has_marks, table.column_mut(0)) {
        first.set_padding((1, 0));
    }
    let mut marks = rows.iter().filter_map(|row| row.mark);
    let (mut text, mut in_header) = (String::new(), true);
    for (k, line) in table.lines().enumerate() {
        let line = line.trim_end();
        // Where a cell is wrapped, the lines after the first have no mark.
        let mark =
            if has_marks && line.chars().nth(1).is_some_and(|c| c != ' ') { marks.next() } else { None };
        in_header = in_header && mark.is_none() && (has_marks || k == 0);
        text += &match mark {
            _ if in_header => styled(FAINT, line),
            Some((mark, style)) => line.replacen(mark, &styled(style, mark), 1),
            None => line.to_string(),
        };
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows() -> Vec<Row> {
        let row =
            |mark, claim: &str, time: &str| Row { mark: Some(mark), cells: vec![claim.into(), time.into()] };
        vec![
            row(("✓", GOOD), "曲線 = 形", "12 µs"),
            row(("✗", BAD), "b[0] + b[1] + b[2] + b[3] + b[4] + b[5] = 1", "3.4 ms"),
        ]
    }

    /// The text as it is seen where there are no styles.
    fn plain(width: Option<u16>) -> String {
        anstream::adapter::strip_str(&layout(&["claim", "time"], &rows(), &[1], width)).to_string()
    }

    #[test]
    fn columns_are_as_wide_as_their_glyphs() {
        assert_eq!(
            plain(None),
            concat!(
                "   claim                                          time\n",
                " ✓ 曲線 = 形                                     12 µs\n",
                " ✗ b[0] + b[1] + b[2] + b[3] + b[4] + b[5] = 1  3.4 ms\n",
            )
        );
    }

    #[test]
    fn cells_are_wrapped_in_a_terminal() {
        assert_eq!(
            plain(Some(40)),
            concat!(
                "   claim                           time\n",
                " ✓ 曲線 = 形                      12 µs\n",
                " ✗ b[0] + b[1] + b[2] + b[3] +   3.4 ms\n",
                "   b[4] + b[5] = 1\n",
            )
        );
    }

    #[test]
    fn only_marks_and_the_header_are_styled() {
        let text = layout(&["claim", "time"], &rows(), &[1], Some(40));
        assert!(text.starts_with(&format!("{FAINT}   claim")));
        assert_eq!(text.matches(&styled(GOOD, "✓")).count(), 1);
        assert_eq!(text.matches(&styled(BAD, "✗")).count(), 1);
        assert_eq!(text.matches('\u{1b}').count(), 2 + 2 + 3);
    }
}

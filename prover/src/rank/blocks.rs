//! Block triangular form of a matrix, from the places of its zeros alone.

use crate::algebra::poly::Poly;
use crate::collections::list::{Listed, Mapped};
use crate::collections::sort::{sort_by, sort_unique};

/// Some rows and columns of a matrix.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Block {
    pub(super) rows: Vec<usize>,
    pub(super) columns: Vec<usize>,
}

/// Blocks with all rows, each row in one of them, and no column in two, such that the rows of a block are zero in the
/// columns of all later blocks: when the rows of every block are independent in its own columns, all rows are.
///
/// `None` when there are no such blocks with as many columns as rows: then the rows are dependent whatever stands in
/// the places that are not zero.
///
/// Every row is matched with a column in which it is not zero. Rows that need each other's columns form a block: these
/// are the strongly connected components of the graph with an edge from a row to the row of each column in which it is
/// not zero (Dulmage and Mendelsohn 1958). Columns without a row go to the first block that they touch.
pub(super) fn triangular(rows: &[Vec<Poly>]) -> Option<Vec<Block>> {
    let support: Vec<Vec<usize>> = rows.mapped(|row| (0..row.len()).filter(|c| !row[*c].is_zero()).listed());
    let width = rows.first().map_or(0, Vec::len);
    let owner = matching(&support, width)?;
    let mut taken = vec![false; width];
    let mut blocks = Vec::new();
    for rows in Components::of(&support, &owner) {
        let mut columns = Vec::new();
        for row in &rows {
            for column in &support[*row] {
                let own = owner[*column].is_none_or(|other| rows.contains(&other));
                if own && !taken[*column] {
                    taken[*column] = true;
                    columns.push(*column);
                }
            }
        }
        sort_unique(&mut columns);
        blocks.push(Block { rows, columns });
    }
    Some(blocks)
}

/// By column the row that is matched with it, such that every row is matched; `None` when that is impossible.
fn matching(support: &[Vec<usize>], width: usize) -> Option<Vec<Option<usize>>> {
    let mut users = vec![0; width];
    for column in support.iter().flatten() {
        users[*column] += 1;
    }
    // Columns that few rows share first: that leaves the others to the rows that have no choice.
    let ordered: Vec<Vec<usize>> = support.mapped(|columns| {
        let mut columns = columns.clone();
        sort_by(&mut columns, |a, b| (users[*a], a).cmp(&(users[*b], b)));
        columns
    });
    let mut owner = vec![None; width];
    let mut order: Vec<usize> = (0..support.len()).listed();
    sort_by(&mut order, |a, b| (support[*a].len(), a).cmp(&(support[*b].len(), b)));
    for row in order {
        // An augmenting path; the way back stands on a list, so that many rows cost no stack.
        let mut reached_from: Vec<Option<usize>> = vec![None; width];
        let mut waiting = vec![row];
        let mut next = 0;
        let free = loop {
            let current = *waiting.get(next)?;
            next += 1;
            let mut free = None;
            for &column in &ordered[current] {
                if reached_from[column].is_some() {
                    continue;
                }
                reached_from[column] = Some(current);
                match owner[column] {
                    None => {
                        free = Some(column);
                        break;
                    }
                    Some(other) => waiting.push(other),
                }
            }
            if let Some(column) = free {
                break column;
            }
        };
        // Along the path every row takes over the column through which it was reached.
        let mut column = free;
        while let Some(current) = reached_from[column] {
            let before = owner.iter().position(|o| *o == Some(current));
            owner[column] = Some(current);
            match before {
                Some(previous) if current != row => column = previous,
                _ => break,
            }
        }
    }
    Some(owner)
}

/// Tarjan's algorithm: strongly connected components, every one after those that it leads to.
struct Components<'a> {
    support: &'a [Vec<usize>],
    owner: &'a [Option<usize>],
    number: Vec<Option<usize>>,
    lowest: Vec<usize>,
    open: Vec<usize>,
    is_open: Vec<bool>,
    count: usize,
    found: Vec<Vec<usize>>,
}

impl<'a> Components<'a> {
    fn of(support: &'a [Vec<usize>], owner: &'a [Option<usize>]) -> Vec<Vec<usize>> {
        let n = support.len();
        let mut search = Self {
            support,
            owner,
            number: vec![None; n],
            lowest: vec![0; n],
            open: Vec::new(),
            is_open: vec![false; n],
            count: 0,
            found: Vec::new(),
        };
        for row in 0..n {
            if search.number[row].is_none() {
                search.visit(row);
            }
        }
        search.found
    }

    fn enter(&mut self, row: usize) {
        self.number[row] = Some(self.count);
        self.lowest[row] = self.count;
        self.count += 1;
        self.open.push(row);
        self.is_open[row] = true;
    }

    /// Depth first, with a list in place of the stack: the place in the support of each row on the way.
    fn visit(&mut self, start: usize) {
        self.enter(start);
        let mut way = vec![(start, 0)];
        while let Some((row, place)) = way.last_mut() {
            let row = *row;
            if let Some(column) = self.support[row].get(*place) {
                *place += 1;
                let Some(next) = self.owner[*column] else { continue };
                match self.number[next] {
                    None => {
                        self.enter(next);
                        way.push((next, 0));
                    }
                    Some(number) if self.is_open[next] => self.lowest[row] = self.lowest[row].min(number),
                    Some(_) => {}
                }
                continue;
            }
            way.pop();
            if let Some((before, _)) = way.last() {
                self.lowest[*before] = self.lowest[*before].min(self.lowest[row]);
            }
            if Some(self.lowest[row]) == self.number[row] {
                let mut component = Vec::new();
                while let Some(last) = self.open.pop() {
                    self.is_open[last] = false;
                    component.push(last);
                    if last == row {
                        break;
                    }
                }
                sort_unique(&mut component);
                self.found.push(component);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pattern(rows: &[&str]) -> Vec<Vec<Poly>> {
        let entry = |c| if c == '.' { Poly::zero() } else { Poly::one() };
        rows.iter().map(|row| row.chars().map(entry).collect()).collect()
    }

    /// The blocks as text, after a check that they are what they should be.
    fn blocks(rows: &[&str]) -> Option<String> {
        let rows = pattern(rows);
        let blocks = triangular(&rows)?;
        let mut all: Vec<usize> = blocks.iter().flat_map(|b| b.rows.clone()).collect();
        all.sort_unstable();
        assert!(all.iter().copied().eq(0..rows.len()));
        for (k, block) in blocks.iter().enumerate() {
            assert!(block.columns.len() >= block.rows.len());
            for later in &blocks[k + 1..] {
                assert!(block.rows.iter().all(|r| later.columns.iter().all(|c| rows[*r][*c].is_zero())));
                assert!(later.columns.iter().all(|c| !block.columns.contains(c)));
            }
        }
        Some(blocks.iter().map(|b| format!("{:?}{:?}", b.rows, b.columns)).collect::<Vec<_>>().join(" "))
    }

    #[test]
    fn blocks_by_the_places_of_zeros() {
        assert_eq!(blocks(&["x..", ".x.", "..x"]).as_deref(), Some("[0][0] [1][1] [2][2]"));
        assert_eq!(blocks(&["xx.", "xx.", "xxx"]).as_deref(), Some("[0, 1][0, 1] [2][2]"));
        assert_eq!(blocks(&["xxx", ".xx", ".xx"]).as_deref(), Some("[1, 2][1, 2] [0][0]"));
        assert_eq!(blocks(&[".xx.", "x..x"]).as_deref(), Some("[0][1, 2] [1][0, 3]"));
        assert_eq!(blocks(&["x.x", "x..", ".x."]).as_deref(), Some("[1][0] [0][2] [2][1]"));
        assert_eq!(blocks(&["x..", "x..", ".xx"]), None);
        assert_eq!(blocks(&["...", "x.."]), None);
        assert_eq!(blocks(&[]).as_deref(), Some(""));
    }

    #[test]
    fn a_row_takes_over_along_a_long_path() {
        // A matching exists only as a chain of exchanges.
        assert!(blocks(&["xx...", ".xx..", "..xx.", "x....", "...xx"]).is_some());
        assert_eq!(blocks(&["xx", "xx", "xx"]), None);
    }
}

//! Columns that line up: text at its left, numbers at their decimal point.

use unicode_width::UnicodeWidthStr;

/// What stands in one place of a table.
#[derive(Clone, Debug)]
pub(super) enum Cell {
    /// Nothing.
    Blank,
    /// Words.
    Text(String),
    /// Words over several columns, the others of which are blank: they widen none.
    Over(String),
    /// A number, aligned with the others of its column at the decimal point.
    Number(String),
}

impl Cell {
    pub(super) fn text(text: impl Into<String>) -> Cell {
        Cell::Text(text.into())
    }

    pub(super) fn number(value: f64) -> Cell {
        Cell::Number(super::number::shown(value))
    }
}

/// Words that are wider do not widen their column: what stands to their right goes to a line of its own.
const WIDEST: usize = 32;

/// Rows of cells. Each column says how many blanks stand before it, unless it is empty; rows may be shorter than the
/// table.
#[derive(Debug)]
pub(super) struct Table {
    gaps: Vec<usize>,
    rows: Vec<Vec<Cell>>,
}

/// How wide a column is: its texts, and its numbers before and from the decimal point on.
#[derive(Clone, Copy, Default)]
struct Width {
    text: usize,
    whole: usize,
    fraction: usize,
}

impl Width {
    fn total(self) -> usize {
        self.text.max(self.whole + self.fraction)
    }

    /// With the blanks before it, which an empty column does not have.
    fn total_after(self, gap: usize) -> usize {
        if self.total() == 0 { 0 } else { gap + self.total() }
    }
}

impl Table {
    pub(super) fn new(gaps: impl Into<Vec<usize>>) -> Table {
        Table { gaps: gaps.into(), rows: Vec::new() }
    }

    pub(super) fn push(&mut self, row: Vec<Cell>) {
        self.rows.push(row);
    }

    fn widths(&self) -> Vec<Width> {
        let mut widths = vec![Width::default(); self.gaps.len()];
        for row in &self.rows {
            for (cell, width) in row.iter().zip(&mut widths) {
                match cell {
                    Cell::Blank | Cell::Over(_) => {}
                    Cell::Text(text) if text.width() > WIDEST => {}
                    Cell::Text(text) => width.text = width.text.max(text.width()),
                    Cell::Number(number) => {
                        let (whole, fraction) = split(number);
                        width.whole = width.whole.max(whole.len());
                        width.fraction = width.fraction.max(fraction.len());
                    }
                }
            }
        }
        widths
    }

    /// How wide the lines are, the columns up to the last one filled.
    pub(super) fn width(&self) -> usize {
        self.widths().iter().zip(&self.gaps).map(|(width, gap)| width.total_after(*gap)).sum()
    }

    /// The lines, without blanks at their ends.
    pub(super) fn lines(&self) -> Vec<String> {
        self.rows().into_iter().flatten().collect()
    }

    /// The lines of each row: more than one where a name is very wide.
    pub(super) fn rows(&self) -> Vec<Vec<String>> {
        let widths = self.widths();
        let lines = |row: &Vec<Cell>| {
            let mut lines = vec![String::new()];
            let (mut start, mut filled) = (0, 0);
            for ((cell, width), gap) in row.iter().zip(&widths).zip(&self.gaps) {
                let end = start + width.total_after(*gap);
                start = end - width.total();
                let indent = match cell {
                    Cell::Blank | Cell::Text(_) | Cell::Over(_) => 0,
                    Cell::Number(number) => width.whole - split(number).0.len(),
                };
                if let Cell::Text(text) | Cell::Over(text) | Cell::Number(text) = cell {
                    // Words over several columns may reach further than these; very wide ones end the line.
                    if matches!(cell, Cell::Text(_) | Cell::Number(_)) && filled >= start + indent && filled > 0 {
                        lines.push(String::new());
                        filled = 0;
                    }
                    let blanks = (start + indent).saturating_sub(filled);
                    if let Some(line) = lines.last_mut() {
                        line.extend(std::iter::repeat_n(' ', blanks));
                        line.push_str(text);
                    }
                    filled += blanks + text.width();
                }
                start = end;
            }
            lines.iter_mut().for_each(|line| line.truncate(line.trim_end().len()));
            lines
        };
        self.rows.iter().map(lines).collect()
    }
}

/// A number before its decimal point, and the rest.
fn split(number: &str) -> (&str, &str) {
    number.split_at(number.find(['.', 'e']).unwrap_or(number.len()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_line_up() {
        let mut table = Table::new([2, 3, 1]);
        table.push(vec![Cell::text("name"), Cell::text("Ka")]);
        table.push(vec![Cell::text("é球"), Cell::number(10.25), Cell::number(-1.0)]);
        table.push(vec![Cell::Blank, Cell::number(0.5)]);
        table.push(vec![Cell::text("a"), Cell::Blank, Cell::number(0.125)]);
        assert_eq!(table.lines(), ["  name   Ka", "  é球    10.25 -1", "          0.5", "  a             0.125"]);
        assert_eq!(table.width(), 21);
    }

    #[test]
    fn a_very_wide_name_stands_on_a_line_of_its_own() {
        let wide = "球".repeat(17);
        let mut table = Table::new([2, 3, 1]);
        table.push(vec![Cell::text("name"), Cell::text("Ka")]);
        table.push(vec![Cell::text(wide.clone()), Cell::number(1.5), Cell::number(2.0)]);
        table.push(vec![Cell::text("a"), Cell::text(wide.clone())]);
        let rows = [
            vec!["  name   Ka".to_owned()],
            vec![format!("  {wide}"), "         1.5 2".into()],
            vec![format!("  a      {wide}")],
        ];
        assert_eq!(table.rows(), rows);
        assert_eq!(table.width(), 14);
    }
}

//! The widths of tables: smaller letters, and columns in which lines break, for cells that are too wide.

/// Letters in a line of a table, where they are small.
pub const LINE: usize = 88;
/// Letters in a line of the smallest size.
const SMALLEST: usize = 112;
/// No column of paragraphs is narrower.
const NARROWEST: usize = 8;

/// The size of the letters, and the columns of the environment: where the smallest letters do not fit, the widest columns
/// are paragraphs.
pub fn fitted(columns: &str, heading: &str, rows: &[String]) -> (&'static str, String) {
    let widths = widths(heading, rows);
    match total(&widths, usize::MAX) {
        0..=LINE => ("", columns.to_owned()),
        letters if letters <= LINE * 5 / 4 => ("\\acutilesmaller", columns.to_owned()),
        letters if letters <= SMALLEST => ("\\acutilesmallest", columns.to_owned()),
        _ => ("\\acutilesmallest", as_paragraphs(columns, &widths)),
    }
}

/// Letters of the widest cell of each column.
fn widths(heading: &str, rows: &[String]) -> Vec<usize> {
    let mut widest: Vec<usize> = Vec::new();
    for row in rows.iter().map(String::as_str).chain([heading]) {
        for (column, cell) in row.split('&').enumerate() {
            if widest.len() <= column {
                widest.push(0);
            }
            if !cell.contains("multicolumn") {
                widest[column] = widest[column].max(width(cell));
            }
        }
    }
    widest
}

/// Letters of a line whose columns have at most `most` letters.
fn total(widths: &[usize], most: usize) -> usize {
    widths.iter().map(|w| w.min(&most) + 2).sum()
}

/// The columns of which the widest are paragraphs, as wide as the line allows.
fn as_paragraphs(columns: &str, widths: &[usize]) -> String {
    let most = (NARROWEST..=SMALLEST)
        .rev()
        .find(|&most| total(widths, most) <= SMALLEST)
        .unwrap_or(NARROWEST);
    let paragraph = format!("p{{.{:03}\\linewidth}}", most * 1000 / SMALLEST);
    let (mut text, mut column, mut depth) = (String::new(), 0, 0);
    for letter in columns.chars() {
        match letter {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        let is_column = depth == 0 && matches!(letter, 'l' | 'c' | 'r' | 'p');
        let is_wide = is_column && widths.get(column).is_some_and(|&w| w > most);
        if is_wide && letter != 'p' {
            text.push_str(&paragraph)
        } else {
            text.push(letter)
        }
        column += usize::from(is_column);
    }
    text
}

/// About how many letters wide a formula is: commands count one, signs two, braces nothing.
pub fn width(formula: &str) -> usize {
    let mut width = 0;
    let mut characters = formula.chars().peekable();
    while let Some(c) = characters.next() {
        if c == '\\' {
            while characters.next_if(char::is_ascii_alphabetic).is_some() {}
            width += 1;
        } else if "+-=<".contains(c) {
            width += 2;
        } else if !"{}^_ ".contains(c) {
            width += 1;
        }
    }
    width
}

#[cfg(test)]
mod tests {
    use super::fitted;

    #[test]
    fn the_widest_columns_become_paragraphs() {
        let rows = |digits: usize| vec![format!("1 & ${}$ & $2$", "7".repeat(digits))];
        assert_eq!(
            fitted("r@{\\quad}ll", "a & b & c", &rows(50)).1,
            "r@{\\quad}ll"
        );
        // Of 112 letters 1 + 2 and 3 + 2 go to the other columns, with gaps, and 2 to the gap of this one: 102 are left.
        let wide = fitted("r@{\\quad}ll", "a & b & c", &rows(200));
        assert_eq!(wide.1, "r@{\\quad}p{.910\\linewidth}l");
    }
}

//! Small pieces of TeX: escaped text, counts, corners, facets, tables.

use super::columns::{LINE, fitted, width};
use acutile_core::tiling::{Corner, Mate};
use acutile_exact::number::radical::with_radicals;

/// Text in which nothing is a command. Letters beyond Latin-1 that have no place in
/// plain pdfLaTeX are named by their number.
pub fn escape(text: &str) -> String {
    with_radicals(text, escape_plain, |tex| format!("${tex}$"))
}

fn escape_plain(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\\' => escaped.push_str("\\textbackslash{}"),
            '^' => escaped.push_str("\\textasciicircum{}"),
            '~' => escaped.push_str("\\textasciitilde{}"),
            '<' | '>' | '|' => escaped.push_str(&format!("${c}$")),
            '"' => escaped.push_str("{''}"),
            '#' | '$' | '%' | '&' | '_' | '{' | '}' => escaped.extend(['\\', c]),
            'σ' => escaped.push_str("$\\sigma$"),
            'μ' | 'µ' => escaped.push_str("$\\mu$"),
            '²' => escaped.push_str("$^2$"),
            '≥' => escaped.push_str("$\\ge$"),
            '≤' => escaped.push_str("$\\le$"),
            'ε' => escaped.push_str("$\\varepsilon$"),
            'À'..='Ö' | 'Ø'..='ö' | 'ø'..='ÿ' if !matches!(c, 'Ð' | 'Þ' | 'ð' | 'þ') => {
                escaped.push(c);
            }
            '–' => escaped.push_str("--"),
            ' '..='~' => escaped.push(c),
            c if c.is_whitespace() => escaped.push(' '),
            _ => escaped.push_str(&format!("[U+{:04X}]", u32::from(c))),
        }
    }
    escaped
}

/// A name as a file name and as part of a label: ASCII letters, digits and hyphens.
pub fn slug(name: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric();
    let text: String = name
        .chars()
        .map(|c| if is_plain(c) { c } else { '-' })
        .collect();
    match text.trim_matches('-') {
        "" => "tiling".to_owned(),
        trimmed => trimmed.to_owned(),
    }
}

/// The word for a simplex of dimension D.
pub fn simplices(dimension: usize, count: usize) -> &'static str {
    match (dimension, count) {
        (2, 1) => "triangle",
        (2, _) => "triangles",
        (_, 1) => "tetrahedron",
        _ => "tetrahedra",
    }
}

/// The word for a face of dimension D - 1.
pub fn facet_word(dimension: usize) -> &'static str {
    if dimension == 2 { "edge" } else { "facet" }
}

/// The word for the circle or sphere through the corners of a simplex.
pub fn sphere_word(dimension: usize) -> &'static str {
    if dimension == 2 {
        "circumcircle"
    } else {
        "circumsphere"
    }
}

/// `1 orbit`, `3 orbits`.
pub fn counted(count: usize, noun: &str) -> String {
    match (count, noun) {
        (1, _) => format!("$1$ {noun}"),
        (_, "vertex") => format!("${count}$ vertices"),
        (_, "class") => format!("${count}$ classes"),
        _ => format!("${count}$ {noun}s"),
    }
}

/// A shift as crystallographers write directions, `1\bar10`; with commas where an entry
/// has two digits; nothing for zero.
pub fn moved(shift: &[i32]) -> String {
    if shift.iter().all(|&s| s == 0) {
        return String::new();
    }
    if shift.iter().any(|s| s.unsigned_abs() > 9) {
        let entries: Vec<String> = shift.iter().map(i32::to_string).collect();
        return format!("^{{({})}}", entries.join(","));
    }
    let entry = |s: &i32| {
        if *s < 0 {
            format!("\\bar{}", s.unsigned_abs())
        } else {
            s.to_string()
        }
    };
    format!("^{{{}}}", shift.iter().map(entry).collect::<String>())
}

/// `5^{1\bar10}`: vertex 5 moved by b_1 - b_2.
pub fn corner<const D: usize>(corner: &Corner<D>, rank: usize) -> String {
    format!("{}{}", corner.vertex, moved(&corner.shift[..rank]))
}

/// `12_3^{1\bar10}`: the facet of tetrahedron 12 opposite its corner 3, moved.
pub fn mate<const D: usize>(mate: &Mate<D>, rank: usize) -> String {
    format!(
        "{}_{{{}}}{}",
        mate.facet.simplex,
        mate.facet.opposite,
        moved(&mate.shift[..rank])
    )
}

/// Whether a table with these columns fits into a line.
pub fn table_fits(rows: &[Vec<&str>]) -> bool {
    let columns = rows.first().map_or(0, Vec::len);
    let widest = |column: usize| rows.iter().map(|row| width(row[column])).max();
    (0..columns)
        .map(|k| widest(k).unwrap_or(0) + 2)
        .sum::<usize>()
        <= LINE
}

/// Items as they are read in a sentence.
pub fn list(items: &[String]) -> String {
    match items {
        [] => String::new(),
        [one] => one.clone(),
        [first, last] => format!("{first} and {last}"),
        [first @ .., last] => format!("{}, and {last}", first.join(", ")),
    }
}

/// A longtable with a caption above; `mark` is a comment by which programs find it.
pub struct Table<'t> {
    pub mark: String,
    pub columns: &'t str,
    pub caption: String,
    pub label: String,
    pub heading: String,
    pub rows: Vec<String>,
}

impl Table<'_> {
    /// The environment; nothing where there are no rows.
    pub fn tex(&self) -> String {
        let Table {
            mark,
            columns,
            caption,
            label,
            heading,
            rows,
        } = self;
        // A starred row end keeps a short table on one page.
        let end = if rows.len() <= SHORT {
            "\\\\*\n"
        } else {
            "\\\\\n"
        };
        let (size, columns) = fitted(columns, heading, rows);
        let rows = rows.join(&format!(" {end}"));
        format!(
            "{{\\acutiletables{size}\n% acutile:table {mark}\n\\begin{{longtable}}{{{columns}}}\n\
             \\caption{{{caption}}}\\label{{{label}}}\\\\\n\
             \\toprule\n{heading} \\\\\n\\midrule\n\\endfirsthead\n\
             \\toprule\n{heading} \\\\\n\\midrule\n\\endhead\n\
             \\bottomrule\n\\endlastfoot\n{rows} \\\\\n\\end{{longtable}}}}\n"
        )
    }
}

/// Tables with no more rows are not broken.
const SHORT: usize = 16;

/// A centred table in the text, without a caption.
pub fn tabular(mark: &str, columns: &str, heading: &str, rows: &[String]) -> String {
    format!(
        "\\nopagebreak\n% acutile:table {mark}\n\\begin{{center}}\\acutilefit{{\\acutiletables\\begin{{tabular}}{{{columns}}}\n\\toprule\n{heading} \\\\\n\\midrule\n{} \\\\\n\\bottomrule\n\\end{{tabular}}}}\\end{{center}}\n",
        rows.join(" \\\\\n")
    )
}

/// A matrix; in displays that are not too wide.
pub fn matrix(rows: &[Vec<String>]) -> String {
    let rows: Vec<String> = rows.iter().map(|row| row.join(" & ")).collect();
    format!(
        "\\begin{{pmatrix}} {} \\end{{pmatrix}}",
        rows.join(" \\\\ ")
    )
}

/// Whether a matrix of these entries fits into a line, `letters` wide.
pub fn fits(rows: &[Vec<String>], letters: usize) -> bool {
    let columns = rows.first().map_or(0, Vec::len);
    let widest = |column: usize| rows.iter().map(|row| width(&row[column])).max();
    (0..columns)
        .map(|k| widest(k).unwrap_or(0) + 2)
        .sum::<usize>()
        <= letters
}

#[cfg(test)]
mod tests {
    use super::*;
    use acutile_core::tiling::VertexId;

    #[test]
    fn text_is_escaped() {
        let cases = [
            ("3^2.4.3.4", "3\\textasciicircum{}2.4.3.4"),
            ("a_b & 50% #1 {x}", "a\\_b \\& 50\\% \\#1 \\{x\\}"),
            (
                "\\input{/etc/passwd}",
                "\\textbackslash{}input\\{/etc/passwd\\}",
            ),
            ("Üngör, σ", "Üngör, $\\sigma$"),
            ("東\n$", "[U+6771] \\$"),
        ];
        for (text, expected) in cases {
            assert_eq!(escape(text), expected);
        }
    }

    #[test]
    fn corners_carry_their_shift() {
        let at = |shift| Corner {
            vertex: VertexId::new(5),
            shift,
        };
        assert_eq!(corner(&at([0, 0, 0]), 3), "5");
        assert_eq!(corner(&at([1, -1, 0]), 3), "5^{1\\bar10}");
        assert_eq!(corner(&at([-1, 0, 0]), 2), "5^{\\bar10}");
        assert_eq!(corner(&at([12, -1, 0]), 3), "5^{(12,-1,0)}");
        assert_eq!(corner(&at([0, 0, 0]), 0), "5");
    }

    #[test]
    fn slugs_are_plain() {
        assert_eq!(slug("kagome:z+"), "kagome-z");
        assert_eq!(slug("../x"), "x");
        assert_eq!(slug("!"), "tiling");
    }
}

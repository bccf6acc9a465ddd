//! A drawing as a `tikzpicture`, to `\input` where TikZ and xcolor are loaded, or as a
//! document of its own for pdfLaTeX. Colours and line weights are written in place, so the fragment defines
//! nothing.

use super::drawing::{Colour, Drawing, FONT, Item, Place};
use std::fmt::Write;

/// Points of TeX in a millimetre.
const POINTS: f64 = 72.27 / 25.4;

/// The fragment, or the document where `is_standalone`.
pub fn tikz(drawing: &Drawing, is_standalone: bool) -> String {
    let title: String = drawing.title.chars().filter(|c| !c.is_control()).collect();
    let [width, height] = drawing.size;
    let mut text = format!("% {}\n", ascii(&title));
    if is_standalone {
        let _ = write!(
            text,
            "\\documentclass{{article}}\n\\usepackage[paperwidth={width:.3}mm,paperheight={height:.3}mm,margin=0mm]{{geometry}}\n\
             \\usepackage{{xcolor}}\n\\usepackage{{tikz}}\n\\pagestyle{{empty}}\n\\parindent=0pt\n\
             \\topskip=0pt\n\\begin{{document}}\n\\vbox to 0pt{{%\n"
        );
    }
    let _ = write!(
        text,
        "\\begin{{tikzpicture}}[x=1mm,y=1mm,line cap=round,line join=round]\n\
         \\useasboundingbox (0,0) rectangle ({width:.3},{height:.3});\n"
    );
    for item in &drawing.items {
        let _ = writeln!(text, "{}", command(item));
    }
    text.push_str("\\end{tikzpicture}%\n");
    if is_standalone {
        text.push_str("\\vss}\n\\end{document}\n");
    }
    text
}

fn command(item: &Item) -> String {
    let pair = |p: &Place| format!("({:.3},{:.3})", p[0], p[1]);
    match item {
        Item::Polygon { corners, fill } => {
            let points: Vec<String> = corners.iter().map(pair).collect();
            let colour = rgb(*fill);
            format!(
                "\\filldraw[draw={colour},fill={colour},line width=0.05mm] {} -- cycle;",
                points.join(" -- ")
            )
        }
        Item::Line { ends, stroke } => {
            let dash = stroke.dash().map_or(String::new(), |length| {
                format!(",dash pattern=on {length}mm off {length}mm")
            });
            format!(
                "\\draw[draw={},line width={}mm{dash}] {} -- {};",
                rgb(stroke.colour()),
                stroke.weight(),
                pair(&ends[0]),
                pair(&ends[1])
            )
        }
        Item::Dot { at, radius, fill } => format!(
            "\\filldraw[draw=black,fill={},line width=0.15mm] {} circle[radius={radius}mm];",
            rgb(*fill),
            pair(at)
        ),
        Item::Label { at, text, has_halo } => {
            let size = FONT * POINTS;
            let halo = if *has_halo { "fill=white," } else { "" };
            format!(
                "\\node[{halo}inner sep=0.25mm,font=\\fontsize{{{size:.1}}}{{{:.1}}}\\selectfont] \
                 at {} {{{}}};",
                size * 1.2,
                pair(at),
                escaped(text)
            )
        }
    }
}

fn rgb([r, g, b]: Colour) -> String {
    format!("{{rgb,255:red,{r};green,{g};blue,{b}}}")
}

/// TeX's ten special characters and some signs are written by commands; others outside of ASCII
/// are `?`.
fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for letter in text.chars() {
        match letter {
            '\\' => escaped.push_str("\\textbackslash{}"),
            '~' => escaped.push_str("\\textasciitilde{}"),
            '^' => escaped.push_str("\\textasciicircum{}"),
            '<' => escaped.push_str("\\ensuremath{<}"),
            '>' => escaped.push_str("\\ensuremath{>}"),
            '°' => escaped.push_str("\\ensuremath{^\\circ}"),
            '\u{2212}' => escaped.push_str("\\ensuremath{-}"),
            '#' | '$' | '%' | '&' | '_' | '{' | '}' => {
                escaped.push('\\');
                escaped.push(letter);
            }
            _ if letter.is_control() => escaped.push(' '),
            _ => escaped.push_str(&ascii(&letter.to_string())),
        }
    }
    escaped
}

fn ascii(text: &str) -> String {
    let plain = |c: char| if c.is_ascii() { c } else { '?' };
    text.chars().map(plain).collect()
}

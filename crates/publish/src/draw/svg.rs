//! A drawing as SVG 1.1, in millimetres; words have a white halo so that no line runs
//! through them.

use super::drawing::{Colour, Drawing, FONT, Item, Place};
use std::fmt::Write;

/// The whole file.
pub fn svg(drawing: &Drawing) -> String {
    let [width, height] = drawing.size;
    let mut text = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.3}mm\" height=\"{height:.3}mm\" \
         viewBox=\"0 0 {width:.3} {height:.3}\" stroke-linecap=\"round\" stroke-linejoin=\"round\" \
         font-family=\"Helvetica, Arial, sans-serif\" font-size=\"{FONT}\" text-anchor=\"middle\">\n\
         <title>{}</title>\n",
        escaped(&drawing.title)
    );
    for item in &drawing.items {
        // Writing to a string does not fail.
        let _ = writeln!(text, "{}", element(item, height));
    }
    text + "</svg>\n"
}

fn element(item: &Item, height: f64) -> String {
    let pair = |p: &Place| format!("{:.3},{:.3}", p[0], height - p[1]);
    match item {
        Item::Polygon { corners, fill } => {
            let points: Vec<String> = corners.iter().map(pair).collect();
            let fill = hex(*fill);
            format!(
                "<polygon points=\"{}\" fill=\"{fill}\" stroke=\"{fill}\" stroke-width=\"0.05\"/>",
                points.join(" ")
            )
        }
        Item::Line { ends, stroke } => {
            let dash = stroke.dash().map_or(String::new(), |length| {
                format!(" stroke-dasharray=\"{length} {length}\"")
            });
            format!(
                "<path d=\"M{} L{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{dash}/>",
                pair(&ends[0]),
                pair(&ends[1]),
                hex(stroke.colour()),
                stroke.weight()
            )
        }
        Item::Dot { at, radius, fill } => format!(
            "<circle cx=\"{:.3}\" cy=\"{:.3}\" r=\"{radius}\" fill=\"{}\" stroke=\"#000000\" \
             stroke-width=\"0.15\"/>",
            at[0],
            height - at[1],
            hex(*fill)
        ),
        Item::Label { at, text, has_halo } => {
            let halo = if *has_halo {
                " stroke=\"#ffffff\" stroke-width=\"0.7\" paint-order=\"stroke\""
            } else {
                ""
            };
            // Half the height of capital letters below the middle.
            let base = height - at[1] + 0.35 * FONT;
            let text = escaped(text);
            format!(
                "<text x=\"{:.3}\" y=\"{base:.3}\"{halo}>{text}</text>",
                at[0]
            )
        }
    }
}

fn hex([r, g, b]: Colour) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// As character data of XML 1.0, which has no control characters but tab and line ends.
fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for letter in text.chars() {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '\u{fffe}' | '\u{ffff}' => escaped.push('\u{fffd}'),
            _ if letter.is_control() => escaped.push(' '),
            _ => escaped.push(letter),
        }
    }
    escaped
}

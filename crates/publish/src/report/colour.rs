//! Colours as the pages write them.

use crate::palette::Colour;

/// Red, green and blue from 0 to 1.
pub fn part([r, g, b]: Colour) -> [f64; 3] {
    [r, g, b].map(|x| f64::from(x) / 255.0)
}

/// `#56b4e9`
pub fn hex(colour: [f64; 3]) -> String {
    let [r, g, b] = colour.map(|c| (c * 255.0).round() as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}

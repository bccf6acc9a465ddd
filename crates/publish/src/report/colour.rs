//! The colours of congruence classes.

/// Colours that the colour-blind tell apart (M. Okabe, K. Ito 2008), without black: red, green,
/// blue from 0 to 1.
const COLOURS: [[f64; 3]; 7] = [
    [0.34, 0.71, 0.91],
    [0.90, 0.62, 0.00],
    [0.00, 0.62, 0.45],
    [0.94, 0.89, 0.26],
    [0.80, 0.47, 0.65],
    [0.00, 0.45, 0.70],
    [0.84, 0.37, 0.00],
];

/// The colour of a congruence class: the seven, then lighter, then darker, then again.
pub fn colour(class: usize) -> [f64; 3] {
    let plain = COLOURS[class % COLOURS.len()];
    match class / COLOURS.len() % 3 {
        0 => plain,
        1 => plain.map(|c| 1.0 - 0.5 * (1.0 - c)),
        _ => plain.map(|c| 0.6 * c),
    }
}

/// `#56b4e9`
pub fn hex(colour: [f64; 3]) -> String {
    let [r, g, b] = colour.map(|c| (c * 255.0).round() as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}

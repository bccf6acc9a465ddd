//! The letters of words in PDF and PNG: Arimo, which has the widths of Helvetica. It is part of the program, so figures do not
//! depend on the fonts of a machine.

use super::DrawError;
use ttf_parser::{Face, GlyphId, OutlineBuilder};

/// A part of Arimo Regular, in TrueType. Its licence is beside it.
pub const FILE: &[u8] = include_bytes!("arimo.ttf");

/// The letter in the place of one that the font does not have.
const REPLACEMENT: char = '?';

/// The font.
pub struct Font {
    face: Face<'static>,
}

/// A letter of a line.
#[derive(Clone, Copy, Debug)]
pub struct Glyph {
    /// The number of its outline in the font.
    pub id: u16,
    /// The letter.
    pub letter: char,
    /// Where it begins, in heights of the letters' bodies.
    pub at: f64,
}

/// A part of an outline, in heights of the letters' bodies, y up.
#[derive(Clone, Copy, Debug)]
pub enum Part {
    /// A contour begins.
    Move([f64; 2]),
    /// A line to a point.
    Line([f64; 2]),
    /// A quadratic curve: control point and end.
    Curve([f64; 2], [f64; 2]),
    /// The contour is closed.
    Close,
}

impl Font {
    /// The font of the program.
    ///
    /// # Errors
    /// The file is damaged.
    pub fn new() -> Result<Font, DrawError> {
        let face = Face::parse(FILE, 0).map_err(|error| DrawError::NoFont(error.to_string()))?;
        Ok(Font { face })
    }

    /// The letters of a line and its width. Letters that the font does not have are `?`.
    pub fn line(&self, text: &str) -> (Vec<Glyph>, f64) {
        let mut at = 0.0;
        let glyphs = text.chars().map(|letter| {
            let known = |letter: char| self.face.glyph_index(letter).map(|id| (letter, id));
            let (letter, id) = known(letter)
                .or_else(|| known(REPLACEMENT))
                .unwrap_or((REPLACEMENT, GlyphId(0)));
            let glyph = Glyph {
                id: id.0,
                letter,
                at,
            };
            at += self.advance(id.0);
            glyph
        });
        let glyphs = glyphs.collect();
        (glyphs, at)
    }

    /// How far the next letter is.
    pub fn advance(&self, id: u16) -> f64 {
        f64::from(self.face.glyph_hor_advance(GlyphId(id)).unwrap_or(0)) / self.unit()
    }

    /// The outline of a letter.
    pub fn outline(&self, id: u16) -> Vec<Part> {
        let mut outline = Outline {
            unit: self.unit(),
            parts: Vec::new(),
        };
        // A blank has no outline.
        self.face.outline_glyph(GlyphId(id), &mut outline);
        outline.parts
    }

    /// Units of the file in the height of the letters' bodies.
    fn unit(&self) -> f64 {
        f64::from(self.face.units_per_em())
    }

    /// Ascender, descender, height of capital letters, and the box around all letters, in heights of the bodies.
    pub fn sizes(&self) -> ([f64; 3], [f64; 4]) {
        let face = &self.face;
        let capital = face.capital_height().unwrap_or(face.ascender());
        let around = face.global_bounding_box();
        let scaled = |x: i16| f64::from(x) / self.unit();
        (
            [face.ascender(), face.descender(), capital].map(scaled),
            [around.x_min, around.y_min, around.x_max, around.y_max].map(scaled),
        )
    }
}

struct Outline {
    unit: f64,
    parts: Vec<Part>,
}

impl Outline {
    fn place(&self, x: f32, y: f32) -> [f64; 2] {
        [x, y].map(|x| f64::from(x) / self.unit)
    }
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        self.parts.push(Part::Move(self.place(x, y)));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.parts.push(Part::Line(self.place(x, y)));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.parts
            .push(Part::Curve(self.place(x1, y1), self.place(x, y)));
    }

    /// TrueType has no cubic curves.
    fn curve_to(&mut self, _: f32, _: f32, _: f32, _: f32, x: f32, y: f32) {
        self.line_to(x, y);
    }

    fn close(&mut self) {
        self.parts.push(Part::Close);
    }
}

#[cfg(test)]
mod tests {
    use super::Font;

    /// The widths of Helvetica in Adobe's metrics, in thousandths.
    #[test]
    fn letters_are_as_wide_as_those_of_helvetica() {
        let font = Font::new().expect("the font");
        let widths = [
            (' ', 278),
            ('0', 556),
            ('°', 400),
            ('A', 667),
            ('m', 833),
            ('i', 222),
        ];
        for (letter, width) in widths {
            let (glyphs, found) = font.line(&letter.to_string());
            assert_eq!((found * 1000.0).round() as i32, width, "{letter}");
            assert_eq!(glyphs[0].letter, letter);
            assert_eq!(font.outline(glyphs[0].id).is_empty(), letter == ' ');
        }
        let (glyphs, width) = font.line("A東m");
        assert_eq!((width * 1000.0).round() as i32, 667 + 556 + 833);
        assert_eq!(glyphs[1].letter, '?');
    }
}

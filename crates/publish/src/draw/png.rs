//! A drawing as PNG, on white, with 300 dots per inch.
//!
//! tiny-skia paints. The file is a signature, four chunks and a zlib stream, and needs no library but flate2.

use super::DrawError;
use super::drawing::{Colour, Drawing, FONT, Item, Place, WHITE};
use super::font::{Font, Part};
use flate2::{Compression, Crc, write::ZlibEncoder};
use std::io::Write;
use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, StrokeDash,
    Transform,
};

/// Dots in a metre: 300 in an inch.
const DOTS: u32 = 11_811;
/// No picture has more dots.
const DOT_LIMIT: f64 = 100_000_000.0;

/// The whole file.
///
/// # Errors
/// The picture is too large.
pub fn png(drawing: &Drawing) -> Result<Vec<u8>, DrawError> {
    let scale = f64::from(DOTS) / 1000.0;
    let [width, height] = drawing.size.map(|x| (x * scale).ceil().max(1.0));
    if width * height > DOT_LIMIT {
        return Err(DrawError::TooManyDots(width, height, DOT_LIMIT));
    }
    let mut canvas = Canvas {
        pixels: Pixmap::new(width as u32, height as u32).ok_or(DrawError::TooLarge)?,
        transform: Transform::from_row(
            scale as f32,
            0.0,
            0.0,
            -scale as f32,
            0.0,
            (drawing.size[1] * scale) as f32,
        ),
        font: Font::new()?,
    };
    canvas.pixels.fill(Color::WHITE);
    for item in &drawing.items {
        canvas.paint(item);
    }
    Ok(encoded(&canvas.pixels))
}

struct Canvas {
    pixels: Pixmap,
    /// From millimetres, y up.
    transform: Transform,
    font: Font,
}

impl Canvas {
    fn paint(&mut self, item: &Item) {
        match item {
            Item::Polygon { corners, fill } => {
                let path = polygon(corners);
                self.fill(path.as_ref(), *fill);
                self.stroke(path.as_ref(), *fill, 0.05, None);
            }
            Item::Line { ends, stroke } => {
                let mut path = PathBuilder::new();
                move_to(&mut path, ends[0]);
                line_to(&mut path, ends[1]);
                let path = path.finish();
                self.stroke(
                    path.as_ref(),
                    stroke.colour(),
                    stroke.weight(),
                    stroke.dash(),
                );
            }
            Item::Dot { at, radius, fill } => {
                let path = PathBuilder::from_circle(at[0] as f32, at[1] as f32, *radius as f32);
                self.fill(path.as_ref(), *fill);
                self.stroke(path.as_ref(), [0; 3], 0.15, None);
            }
            Item::Label { at, text, has_halo } => {
                let path = words(&self.font, *at, text);
                if *has_halo {
                    self.stroke(path.as_ref(), WHITE, 0.7, None);
                }
                self.fill(path.as_ref(), [0; 3]);
            }
        }
    }

    fn fill(&mut self, path: Option<&Path>, colour: Colour) {
        if let Some(path) = path {
            self.pixels.fill_path(
                path,
                &paint(colour),
                FillRule::Winding,
                self.transform,
                None,
            );
        }
    }

    fn stroke(&mut self, path: Option<&Path>, colour: Colour, weight: f64, dash: Option<f64>) {
        let dash = dash.and_then(|length| StrokeDash::new(vec![length as f32; 2], 0.0));
        let stroke = Stroke {
            width: weight as f32,
            line_cap: LineCap::Round,
            line_join: LineJoin::Round,
            dash,
            ..Stroke::default()
        };
        if let Some(path) = path {
            self.pixels
                .stroke_path(path, &paint(colour), &stroke, self.transform, None);
        }
    }
}

fn paint(colour: Colour) -> Paint<'static> {
    let mut paint = Paint {
        anti_alias: true,
        ..Paint::default()
    };
    let [r, g, b] = colour;
    paint.set_color_rgba8(r, g, b, 255);
    paint
}

fn polygon(corners: &[Place]) -> Option<Path> {
    let mut path = PathBuilder::new();
    for (index, corner) in corners.iter().enumerate() {
        match index {
            0 => move_to(&mut path, *corner),
            _ => line_to(&mut path, *corner),
        }
    }
    path.close();
    path.finish()
}

/// The outlines of words centred at a place.
fn words(font: &Font, at: Place, text: &str) -> Option<Path> {
    let mut path = PathBuilder::new();
    for (start, part) in outlines(font, at, text) {
        let place = |p: [f64; 2]| [0, 1].map(|k| start[k] + FONT * p[k]);
        match part {
            Part::Move(to) => move_to(&mut path, place(to)),
            Part::Line(to) => line_to(&mut path, place(to)),
            Part::Curve(by, to) => {
                let [by, to] = [by, to].map(|p| place(p).map(|x| x as f32));
                path.quad_to(by[0], by[1], to[0], to[1]);
            }
            Part::Close => path.close(),
        }
    }
    path.finish()
}

/// The parts of the outlines of words centred at a place, each with the start of its letter.
pub(super) fn outlines(font: &Font, at: Place, text: &str) -> Vec<(Place, Part)> {
    let (glyphs, width) = font.line(text);
    let start = start_of_words(at, width);
    let parts = glyphs.iter().flat_map(|glyph| {
        let start = [start[0] + FONT * glyph.at, start[1]];
        let parts = font.outline(glyph.id).into_iter();
        parts.map(move |part| (start, part))
    });
    parts.collect()
}

/// Where words of this width begin, on their base line: half the height of capital letters below the middle.
pub(super) fn start_of_words(at: Place, width: f64) -> Place {
    [at[0] - FONT * width / 2.0, at[1] - 0.35 * FONT]
}

fn move_to(path: &mut PathBuilder, to: Place) {
    path.move_to(to[0] as f32, to[1] as f32);
}

fn line_to(path: &mut PathBuilder, to: Place) {
    path.line_to(to[0] as f32, to[1] as f32);
}

/// Red, green and blue with eight bits; nothing is transparent on white.
fn encoded(pixels: &Pixmap) -> Vec<u8> {
    let mut rows = Vec::new();
    for row in pixels.data().chunks(4 * pixels.width() as usize) {
        // No filter.
        rows.push(0);
        rows.extend(row.chunks(4).flat_map(|pixel| &pixel[..3]));
    }
    let mut header = [pixels.width(), pixels.height()]
        .map(u32::to_be_bytes)
        .concat();
    header.extend([8, 2, 0, 0, 0]);
    let mut density = [DOTS, DOTS].map(u32::to_be_bytes).concat();
    density.push(1);
    let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
    add_chunk(&mut file, b"IHDR", &header);
    add_chunk(&mut file, b"pHYs", &density);
    add_chunk(&mut file, b"IDAT", &compressed(&rows));
    add_chunk(&mut file, b"IEND", &[]);
    file
}

/// A zlib stream.
pub(super) fn compressed(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
    // Writing to memory does not fail.
    let _ = encoder.write_all(bytes);
    encoder.finish().unwrap_or_default()
}

fn add_chunk(file: &mut Vec<u8>, kind: &[u8; 4], data: &[u8]) {
    file.extend((data.len() as u32).to_be_bytes());
    let mut crc = Crc::new();
    for part in [&kind[..], data] {
        crc.update(part);
        file.extend(part);
    }
    file.extend(crc.sum().to_be_bytes());
}

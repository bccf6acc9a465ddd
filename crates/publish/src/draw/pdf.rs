//! A drawing as PDF: one page of its size, with words that can be searched, in an embedded font.
//!
//! The bytes depend on the drawing alone: there is no date.

use super::DrawError;
use super::drawing::{Colour, Drawing, FONT, Item, Place, WHITE};
use super::font::{FILE, Font, Glyph, Part};
use super::png::{compressed, outlines, start_of_words};
use pdf_writer::types::{
    CidFontType, FontFlags, LineCapStyle, LineJoinStyle, SystemInfo, UnicodeCmap,
};
use pdf_writer::{Content, Filter, Finish, Name, Pdf, Rect, Ref, Str, TextStr};
use std::collections::BTreeMap;

/// Points of PostScript in a millimetre.
const POINTS: f64 = 72.0 / 25.4;
const CATALOG: Ref = Ref::new(1);
const PAGES: Ref = Ref::new(2);
const PAGE: Ref = Ref::new(3);
const CONTENT: Ref = Ref::new(4);
const FONT_OBJECT: Ref = Ref::new(5);
const CID_FONT: Ref = Ref::new(6);
const DESCRIPTOR: Ref = Ref::new(7);
const FONT_FILE: Ref = Ref::new(8);
const CMAP: Ref = Ref::new(9);
const INFO: Ref = Ref::new(10);
/// The name of the font on the page, and that of the typeface.
const ON_PAGE: Name = Name(b"F1");
const FACE: Name = Name(b"Arimo");
const IDENTITY: SystemInfo = SystemInfo {
    registry: Str(b"Adobe"),
    ordering: Str(b"Identity"),
    supplement: 0,
};

/// The whole file.
///
/// # Errors
/// The font of the program is damaged.
pub fn pdf(drawing: &Drawing) -> Result<Vec<u8>, DrawError> {
    let font = Font::new()?;
    let mut page = Page {
        content: Content::new(),
        font: &font,
        glyphs: BTreeMap::new(),
    };
    page.content
        .transform([POINTS as f32, 0.0, 0.0, POINTS as f32, 0.0, 0.0])
        .set_line_cap(LineCapStyle::RoundCap)
        .set_line_join(LineJoinStyle::RoundJoin);
    for item in &drawing.items {
        page.paint(item);
    }
    let Page {
        content, glyphs, ..
    } = page;
    let mut pdf = Pdf::new();
    pdf.catalog(CATALOG).pages(PAGES);
    pdf.pages(PAGES).kids([PAGE]).count(1);
    let [width, height] = drawing.size.map(|x| (x * POINTS) as f32);
    let mut written = pdf.page(PAGE);
    written
        .media_box(Rect::new(0.0, 0.0, width, height))
        .parent(PAGES)
        .contents(CONTENT);
    written.resources().fonts().pair(ON_PAGE, FONT_OBJECT);
    written.finish();
    pdf.stream(CONTENT, &compressed(content.finish().as_slice()))
        .filter(Filter::FlateDecode);
    add_font(&mut pdf, &font, &glyphs);
    pdf.document_info(INFO)
        .title(TextStr(&drawing.title))
        .creator(TextStr("acutile"));
    Ok(pdf.finish())
}

struct Page<'f> {
    content: Content,
    font: &'f Font,
    /// The letters that occur, by the numbers of their outlines.
    glyphs: BTreeMap<u16, char>,
}

impl Page<'_> {
    fn paint(&mut self, item: &Item) {
        match item {
            Item::Polygon { corners, fill } => {
                self.set_fill(*fill);
                self.set_stroke(*fill, 0.05, None);
                for (index, corner) in corners.iter().enumerate() {
                    match index {
                        0 => self.move_to(*corner),
                        _ => self.line_to(*corner),
                    }
                }
                self.content.close_fill_nonzero_and_stroke();
            }
            Item::Line { ends, stroke } => {
                self.set_stroke(stroke.colour(), stroke.weight(), stroke.dash());
                self.move_to(ends[0]);
                self.line_to(ends[1]);
                self.content.stroke();
            }
            Item::Dot { at, radius, fill } => {
                self.set_fill(*fill);
                self.set_stroke([0; 3], 0.15, None);
                self.circle(*at, *radius);
                self.content.close_fill_nonzero_and_stroke();
            }
            Item::Label { at, text, has_halo } => {
                if *has_halo {
                    self.halo(*at, text);
                }
                self.words(*at, text);
            }
        }
    }

    fn set_fill(&mut self, colour: Colour) {
        let [r, g, b] = parts(colour);
        self.content.set_fill_rgb(r, g, b);
    }

    fn set_stroke(&mut self, colour: Colour, weight: f64, dash: Option<f64>) {
        let [r, g, b] = parts(colour);
        self.content
            .set_stroke_rgb(r, g, b)
            .set_line_width(weight as f32)
            .set_dash_pattern(dash.iter().flat_map(|x| [*x as f32; 2]), 0.0);
    }

    fn move_to(&mut self, to: Place) {
        self.content.move_to(to[0] as f32, to[1] as f32);
    }

    fn line_to(&mut self, to: Place) {
        self.content.line_to(to[0] as f32, to[1] as f32);
    }

    fn cubic_to(&mut self, [a, b, c]: [Place; 3]) {
        let [a, b, c] = [a, b, c].map(|p| p.map(|x| x as f32));
        self.content.cubic_to(a[0], a[1], b[0], b[1], c[0], c[1]);
    }

    /// Four curves; the error is less than a thousandth of the radius.
    fn circle(&mut self, [x, y]: Place, radius: f64) {
        let (r, k) = (radius, 0.552_284_75 * radius);
        self.move_to([x + r, y]);
        self.cubic_to([[x + r, y + k], [x + k, y + r], [x, y + r]]);
        self.cubic_to([[x - k, y + r], [x - r, y + k], [x - r, y]]);
        self.cubic_to([[x - r, y - k], [x - k, y - r], [x, y - r]]);
        self.cubic_to([[x + k, y - r], [x + r, y - k], [x + r, y]]);
    }

    /// White around the outlines, which is no text, so that words are found once.
    fn halo(&mut self, at: Place, text: &str) {
        self.set_stroke(WHITE, 0.7, None);
        let mut last = at;
        for (start, part) in outlines(self.font, at, text) {
            let place = |p: [f64; 2]| [0, 1].map(|k| start[k] + FONT * p[k]);
            match part {
                Part::Move(to) => {
                    last = place(to);
                    self.move_to(last);
                }
                Part::Line(to) => {
                    last = place(to);
                    self.line_to(last);
                }
                Part::Curve(by, to) => {
                    let (by, to) = (place(by), place(to));
                    let between = |p: Place| [0, 1].map(|k| p[k] + 2.0 / 3.0 * (by[k] - p[k]));
                    self.cubic_to([between(last), between(to), to]);
                    last = to;
                }
                Part::Close => {
                    self.content.close_path();
                }
            }
        }
        self.content.stroke();
    }

    fn words(&mut self, at: Place, text: &str) {
        let (glyphs, width) = self.font.line(text);
        let [x, y] = start_of_words(at, width);
        let codes: Vec<u8> = glyphs
            .iter()
            .flat_map(|glyph: &Glyph| glyph.id.to_be_bytes())
            .collect();
        self.glyphs
            .extend(glyphs.iter().map(|glyph| (glyph.id, glyph.letter)));
        self.set_fill([0; 3]);
        self.content
            .begin_text()
            .set_font(ON_PAGE, FONT as f32)
            .set_text_matrix([1.0, 0.0, 0.0, 1.0, x as f32, y as f32])
            .show(Str(&codes))
            .end_text();
    }
}

fn parts(colour: Colour) -> [f32; 3] {
    colour.map(|x| f32::from(x) / 255.0)
}

/// The font with its file, the widths of the letters, and which letters they are.
fn add_font(pdf: &mut Pdf, font: &Font, glyphs: &BTreeMap<u16, char>) {
    pdf.type0_font(FONT_OBJECT)
        .base_font(FACE)
        .encoding_predefined(Name(b"Identity-H"))
        .descendant_font(CID_FONT)
        .to_unicode(CMAP);
    let thousandths = |x: f64| (x * 1000.0) as f32;
    let mut described = pdf.cid_font(CID_FONT);
    described
        .subtype(CidFontType::Type2)
        .base_font(FACE)
        .system_info(IDENTITY)
        .font_descriptor(DESCRIPTOR)
        .default_width(0.0)
        .cid_to_gid_map_predefined(Name(b"Identity"));
    let mut widths = described.widths();
    for &id in glyphs.keys() {
        widths.consecutive(id, [thousandths(font.advance(id))]);
    }
    widths.finish();
    described.finish();
    let ([ascent, descent, capital], around) = font.sizes();
    let [left, bottom, right, top] = around.map(thousandths);
    pdf.font_descriptor(DESCRIPTOR)
        .name(FACE)
        .flags(FontFlags::NON_SYMBOLIC)
        .bbox(Rect::new(left, bottom, right, top))
        .italic_angle(0.0)
        .ascent(thousandths(ascent))
        .descent(thousandths(descent))
        .cap_height(thousandths(capital))
        .stem_v(88.0)
        .font_file2(FONT_FILE);
    pdf.stream(FONT_FILE, &compressed(FILE))
        .filter(Filter::FlateDecode)
        .pair(Name(b"Length1"), FILE.len() as i32);
    let mut cmap = UnicodeCmap::new(Name(b"Custom"), IDENTITY);
    for (&id, &letter) in glyphs {
        cmap.pair(id, letter);
    }
    pdf.cmap(CMAP, cmap.finish().as_slice());
}

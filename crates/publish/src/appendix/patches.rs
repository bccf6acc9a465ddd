//! The section on a system of patches: the theorem, and a part for each tile of the base. A part has
//! a picture of the piece, vertices, tetrahedra with their determinants, and pyramids.

use super::numeral::Numerals;
use super::subject::Subject;
use super::tex::{self, Table, list, matrix};
use super::{bibliography, claim, names, recheck};
use crate::draw::{self, Figure, tikz};
use acutile_core::patches::{Pyramid, System, Tile};
use acutile_core::tiling::{AnyTiling, Corner, SimplexId};

/// The section.
pub fn section(subject: &Subject, system: &System, words: &str) -> String {
    let page = Page {
        subject,
        system,
        numerals: Numerals::of(&system.field),
    };
    let citation = bibliography::citation(&subject.name, subject.source);
    let tiles: String = system
        .tiles
        .iter()
        .enumerate()
        .map(|(number, tile)| page.tile(number, tile))
        .collect();
    [
        format!(
            "\\acutilesection{{{}}}\\label{{{}}}\n",
            names::heading(subject),
            page.label("section")
        ),
        names::introduction(subject, &citation),
        "\n\n".to_owned(),
        page.theorem(words),
        tiles,
        recheck::recheck(subject),
    ]
    .concat()
}

struct Page<'s> {
    subject: &'s Subject,
    system: &'s System,
    numerals: Numerals,
}

impl Page<'_> {
    fn label(&self, what: &str) -> String {
        format!("acutile:{}:{what}", self.subject.slug())
    }

    fn theorem(&self, words: &str) -> String {
        let gram: Vec<Vec<String>> = self
            .system
            .gram
            .iter()
            .map(|row| row.iter().map(|x| self.numerals.number(x)).collect())
            .collect();
        let items: String = self
            .subject
            .statements()
            .iter()
            .filter_map(|statement| claim::in_words::<3>(&self.numerals, statement))
            .map(|words| format!("\\item {words}\n"))
            .collect();
        let items = match items.trim_end().strip_suffix(';') {
            None => String::new(),
            Some(items) => format!(
                " Moreover (where an angle is attained, a tile that has it must occur):\n\
                 \\begin{{itemize}}\\setlength{{\\itemsep}}{{0pt}}\\setlength{{\\parskip}}{{0pt}}\n{items}.\n\\end{{itemize}}"
            ),
        };
        let (base, copies) = match self.system.rank {
            1 => (
                "the plane spanned by $b_2$ and $b_3$",
                "edge-to-edge tiling of the plane by moved and turned copies of the polygons",
            ),
            _ => (
                "the line spanned by $b_3$",
                "division of the line into moved copies of the segments",
            ),
        };
        format!(
            "\\begin{{acutiletheorem}}[{name}]\\label{{{label}}}\nLet $b_1$, $b_2$, and $b_3$ be a basis of Euclidean space with the inner products\n\
             \\[ \\acutilefit{{$\\bigl(\\langle b_i,b_j\\rangle\\bigr)={gram}.$}} \\]\n\
             The base is {base}. Take any {copies} below in which sides of one class meet, periodic or not. Over each of its tiles place the piece and the pyramids of that tile, as Theorem~\\ref{{acutile:patches}} says, and for two pyramids over one polygon the tetrahedra of their join. \
             The tetrahedra tile space face to face: they cover it, their interiors are disjoint, and any two of them meet in a common face of both or not at all.{items}\n\\end{{acutiletheorem}}\n\n\
             In the words of the certificate: {words}.\n\n",
            name = names::human_name(self.subject),
            label = self.label("theorem"),
            gram = matrix(&gram),
            words = tex::escape(words),
        )
    }

    fn corner(&self, corner: &Corner<3>) -> String {
        tex::corner(corner, self.system.rank)
    }

    fn tile(&self, number: usize, tile: &Tile) -> String {
        let corners: Vec<String> = tile
            .corners
            .iter()
            .map(|corner| {
                let entries: Vec<String> = corner.iter().map(|x| self.numerals.inline(x)).collect();
                format!("$({})$", entries.join(",\\,"))
            })
            .collect();
        let pairs = tile.classes.iter().zip(&tile.patch.offsets).enumerate();
        let sides: Vec<String> = pairs
            .map(|(side, (class, offset))| {
                let entries: Vec<String> = offset.iter().map(|x| self.numerals.inline(x)).collect();
                format!(
                    "${side}$: class ${class}$, offset $({})$",
                    entries.join(",\\,")
                )
            })
            .collect();
        format!(
            "\\acutileparagraph{{Tile {number}.}} In the base it has the corners {corners}. Its sides are {sides}.\n\n{picture}{vertices}{cells}{pyramids}",
            corners = list(&corners),
            sides = sides.join("; "),
            picture = self.picture(number, tile),
            vertices = self.vertices(number, tile),
            cells = self.cells(number, tile),
            pyramids = self.pyramids(number, tile),
        )
    }

    /// The piece as it is, and with its tetrahedra moved apart.
    fn picture(&self, number: usize, tile: &Tile) -> String {
        let piece = AnyTiling::Space(self.system.piece(tile));
        let options = draw::Options {
            width: 70.0,
            ..draw::Options::default()
        };
        let name = format!("tile {number}");
        let drawings = [Figure::Cell, Figure::Exploded]
            .into_iter()
            .filter_map(|figure| draw::draw(&name, &piece, figure, &options).ok())
            .map(|drawing| tikz::tikz(&drawing, false));
        let pictures: Vec<String> = drawings.collect();
        if pictures.is_empty() {
            return String::new();
        }
        format!(
            "\\begin{{center}}\n\\acutilefit{{%\n{}}}\n\nThe piece over tile {number}, and its tetrahedra moved apart. Colours are congruence classes.\n\\end{{center}}\n\n",
            pictures.join("\\qquad\n")
        )
    }

    fn vertices(&self, number: usize, tile: &Tile) -> String {
        let rows = tile.patch.vertices.iter().enumerate().map(|(v, point)| {
            let cells: String = point
                .iter()
                .map(|x| format!(" & ${}$", self.numerals.cell(x)))
                .collect();
            format!("{v}{cells}")
        });
        Table {
            mark: format!("patch-vertices {} {number}", self.subject.slug()),
            columns: "rlll",
            caption: format!("Vertices over tile {number}, in coordinates of the basis."),
            label: self.label(&format!("vertices-{number}")),
            heading: "vertex & $x_1$ & $x_2$ & $x_3$".to_owned(),
            rows: rows.collect(),
        }
        .tex()
    }

    fn cells(&self, number: usize, tile: &Tile) -> String {
        let piece = self.system.piece(tile);
        let rows = tile
            .patch
            .simplices
            .iter()
            .enumerate()
            .map(|(cell, corners)| {
                let cells: String = corners
                    .iter()
                    .map(|c| format!(" & ${}$", self.corner(c)))
                    .collect();
                let det = piece.shape(SimplexId::at(cell)).determinant;
                format!(
                    "$T_{{{cell}}}${cells} & ${}$",
                    self.numerals.justified(&det)
                )
            });
        Table {
            mark: format!("patch-cells {} {number}", self.subject.slug()),
            columns: "rrrrrl",
            caption: format!("The tetrahedra of the piece over tile {number}."),
            label: self.label(&format!("cells-{number}")),
            heading: "& \\multicolumn{4}{c}{corners} & $\\det$ $(>0)$".to_owned(),
            rows: rows.collect(),
        }
        .tex()
    }

    fn pyramids(&self, number: usize, tile: &Tile) -> String {
        let row = |(place, pyramid): (usize, &Pyramid)| {
            let polygon: Vec<String> = pyramid
                .polygon
                .iter()
                .map(|c| format!("${}$", self.corner(c)))
                .collect();
            format!(
                "{place} & ${}$ & {}",
                self.corner(&pyramid.apex),
                polygon.join(", ")
            )
        };
        Table {
            mark: format!("patch-pyramids {} {number}", self.subject.slug()),
            columns: "rrl",
            caption: format!(
                "The pyramids over tile {number}: apex $a$ and polygon $h_0,h_1,\\dots$"
            ),
            label: self.label(&format!("pyramids-{number}")),
            heading: "& apex & polygon".to_owned(),
            rows: tile.patch.pyramids.iter().enumerate().map(row).collect(),
        }
        .tex()
    }
}

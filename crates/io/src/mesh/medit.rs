//! MEDIT's `.mesh` in text and `.meshb` in binary, the Gamma Mesh Format (P. Frey, "MEDIT: an
//! interactive mesh visualization software", INRIA RT-0253; L. Maréchal, libMeshb).

use super::Mesh;
use super::draft::{Draft, Element};
use super::error::{MeshError, Place};
use super::source::{Encoding, Source};

/// Reads the text format: keywords, each followed by a number of items and the items.
/// Coordinates are doubles whatever the version.
pub fn read_text(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let mut source = Source::with_comments(bytes, b'#');
    source.expect("MeshVersionFormatted")?;
    let version = source.int("a version from 1 to 4")?;
    check_version(&source, version)?;
    let mut medit = Medit::default();
    while let Some(word) = source.try_word() {
        match word {
            b"End" => match source.try_word() {
                None => break,
                Some(word) => return Err(source.unexpected(word, "the end of the file after End")),
            },
            b"Dimension" => medit.dimension = dimension(&mut source)?,
            b"Vertices" => {
                let count = source.int("the number of vertices")?;
                medit.vertices(&mut source, count, Source::double)?;
            }
            b"Tetrahedra" => {
                let count = source.int("the number of tetrahedra")?;
                medit.cells::<4>(&mut source, count)?;
            }
            b"TetrahedraP2" => {
                let count = source.int("the number of tetrahedra")?;
                medit.cells::<10>(&mut source, count)?;
            }
            b"TetrahedraP2Ordering" => return Err(other_order(&source, "tetrahedra")),
            b"TrianglesP2Ordering" => {
                medit.other_triangles = Some(other_order(&source, "triangles"));
                skip_numbers(&mut source);
            }
            b"TrianglesP2" => {
                let count = source.int("the number of triangles")?;
                medit.cells::<6>(&mut source, count)?;
            }
            b"Triangles" => {
                let count = source.int("the number of triangles")?;
                medit.cells::<3>(&mut source, count)?;
            }
            [b'A'..=b'Z' | b'a'..=b'z', ..] => {
                let name = String::from_utf8_lossy(word).into_owned();
                let first = skip_numbers(&mut source);
                medit.pass(&name, first);
            }
            _ => return Err(source.unexpected(word, "a keyword like Vertices, or End")),
        }
    }
    medit.finish()
}

/// Passes over words that are no keywords; gives the first of them as a number.
fn skip_numbers(source: &mut Source) -> usize {
    let mut first = None;
    loop {
        let mut ahead = source.clone();
        match ahead.try_word() {
            None | Some([b'A'..=b'Z' | b'a'..=b'z', ..]) => return first.unwrap_or(0),
            Some(word) => {
                let number = || std::str::from_utf8(word).ok()?.parse().ok();
                first = first.or_else(|| Some(number().unwrap_or(0)));
                *source = ahead;
            }
        }
    }
}

/// Reads the binary format: each keyword is a number, followed by the position of the next
/// one. Version 1 has numbers of single precision; positions have 64 bits from version 3 on,
/// integers in version 4.
pub fn read_binary(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let mut source = Source::new(bytes);
    source.encoding = match source.take(4, "the integer 1")? {
        [1, 0, 0, 0] => Encoding::Little,
        [0, 0, 0, 1] => Encoding::Big,
        found => {
            let problem = format!("found {found:?}, expected the integer 1 in four bytes");
            return Err(MeshError::at(Place::Byte(0), problem));
        }
    };
    let version = source.int("a version from 1 to 4")?;
    check_version(&source, version)?;
    let mut medit = Medit {
        is_wide: version == 4,
        ..Medit::default()
    };
    loop {
        if source.remaining() == 0 {
            return Err(source.error("the file ends, expected the keyword End (54)"));
        }
        let keyword = source.int("a keyword")?;
        if keyword == 54 {
            // Some writers add the position of a next keyword, which is 0.
            let rest = source.take(source.remaining(), "the end")?;
            if rest.iter().any(|byte| *byte != 0) {
                return Err(source.error("found bytes after the keyword End (54), expected none"));
            }
            return medit.finish();
        }
        let next = match version {
            3.. => source.long("the position of the next keyword")?,
            _ => source.int("the position of the next keyword")?,
        };
        match keyword {
            3 => medit.dimension = dimension(&mut source)?,
            4 => {
                let count = medit.integer(&mut source, "the number of vertices")?;
                let number = if version == 1 {
                    Source::single
                } else {
                    Source::double
                };
                medit.vertices(&mut source, count, number)?;
            }
            8 => {
                let count = medit.integer(&mut source, "the number of tetrahedra")?;
                medit.cells::<4>(&mut source, count)?;
            }
            30 => {
                let count = medit.integer(&mut source, "the number of tetrahedra")?;
                medit.cells::<10>(&mut source, count)?;
            }
            TETRAHEDRA_P2_ORDERING => return Err(other_order(&source, "tetrahedra")),
            24 => {
                let count = medit.integer(&mut source, "the number of triangles")?;
                medit.cells::<6>(&mut source, count)?;
            }
            TRIANGLES_P2_ORDERING => {
                medit.other_triangles = Some(other_order(&source, "triangles"));
                go_to(&mut source, next)?;
            }
            6 => {
                let count = medit.integer(&mut source, "the number of triangles")?;
                medit.cells::<3>(&mut source, count)?;
            }
            _ => {
                let count = medit.integer(&mut source, "the number of items")?;
                medit.pass(&keyword_name(keyword), usize::try_from(count).unwrap_or(0));
                go_to(&mut source, next)?;
                continue;
            }
        }
        if next != source.position() as i64 {
            let problem = format!("the next keyword should be at byte {next}, expected it here");
            return Err(source.error(problem));
        }
    }
}

fn go_to(source: &mut Source, next: i64) -> Result<(), MeshError> {
    let position = source.position();
    match usize::try_from(next)
        .ok()
        .and_then(|next| next.checked_sub(position))
    {
        Some(length) => source
            .take(length, "what comes before the next keyword")
            .map(drop),
        None => Err(source.error(format!(
            "the next keyword is said to be at byte {next}, expected it after byte {position}"
        ))),
    }
}

/// The numbers of the keywords by which a file gives the nodes of second-order cells another order
/// (libmeshb7.h).
const TETRAHEDRA_P2_ORDERING: i64 = 133;
const TRIANGLES_P2_ORDERING: i64 = 129;

fn other_order(source: &Source, cells: &str) -> MeshError {
    let keyword = match cells {
        "triangles" => "TrianglesP2Ordering",
        _ => "TetrahedraP2Ordering",
    };
    MeshError {
        is_limit: true,
        ..source.error(format!(
            "found {keyword}, expected second-order {cells} with the nodes in the usual order"
        ))
    }
}

fn keyword_name(keyword: i64) -> String {
    match keyword {
        5 => "Edges".to_owned(),
        7 => "Quadrilaterals".to_owned(),
        9 => "Prisms".to_owned(),
        10 => "Hexahedra".to_owned(),
        49 => "Pyramids".to_owned(),
        _ => format!("keyword {keyword}"),
    }
}

fn check_version(source: &Source, version: i64) -> Result<(), MeshError> {
    match version {
        1..=4 => Ok(()),
        _ => Err(source.error(format!("found version {version}, expected 1 to 4"))),
    }
}

fn dimension(source: &mut Source) -> Result<i64, MeshError> {
    match source.int("the dimension")? {
        found @ 2..=3 => Ok(found),
        other => Err(source.error(format!("found dimension {other}, expected 2 or 3"))),
    }
}

/// The parts that have been read.
struct Medit {
    draft: Draft,
    /// Cells may stand before the vertices: nodes, reference, number and place.
    cells: Vec<(Vec<i64>, i64, i64, Place)>,
    has_vertices: bool,
    /// 2 where vertices have no third coordinate.
    dimension: i64,
    /// Whether integers have 64 bits.
    is_wide: bool,
    /// The refusal of triangles with another order of nodes, if they are the cells.
    other_triangles: Option<MeshError>,
}

impl Default for Medit {
    fn default() -> Self {
        Medit {
            draft: Draft::default(),
            cells: Vec::new(),
            has_vertices: false,
            dimension: 3,
            is_wide: false,
            other_triangles: None,
        }
    }
}

impl Medit {
    fn integer(&self, source: &mut Source, what: &str) -> Result<i64, MeshError> {
        if self.is_wide {
            source.long(what)
        } else {
            source.int(what)
        }
    }

    /// `x y z reference` for each vertex; vertices are numbered from 1.
    fn vertices<'a>(
        &mut self,
        source: &mut Source<'a>,
        count: i64,
        number: fn(&mut Source<'a>, &str) -> Result<f64, MeshError>,
    ) -> Result<(), MeshError> {
        if std::mem::replace(&mut self.has_vertices, true) {
            return Err(source.error("found Vertices a second time"));
        }
        let count = source.count(count, source.least_bytes(4, 4), "vertices")?;
        self.draft.mesh.points.reserve(count);
        let mut referenced = false;
        for tag in 1..=count as i64 {
            let point = [
                number(source, "the coordinate x")?,
                number(source, "the coordinate y")?,
                match self.dimension {
                    2 => 0.0,
                    _ => number(source, "the coordinate z")?,
                },
            ];
            referenced |= self.integer(source, "a reference")? != 0;
            self.draft.add_node(tag, point, source.place())?;
        }
        if referenced {
            self.draft.pass("references of vertices");
        }
        Ok(())
    }

    /// `node … reference` for each tetrahedron or triangle. Of second order, they have their middle
    /// nodes in VTK's order, as Gmsh writes them.
    fn cells<const N: usize>(&mut self, source: &mut Source, count: i64) -> Result<(), MeshError> {
        let count = source.count(count, source.least_bytes(N + 1, 4), "cells")?;
        self.cells.reserve(count);
        for tag in 1..=count as i64 {
            let mut nodes = Vec::with_capacity(N);
            for _ in 0..N {
                nodes.push(self.integer(source, "a node number")?);
            }
            let place = source.place();
            let reference = self.integer(source, "a reference")?;
            self.cells.push((nodes, reference, tag, place));
        }
        Ok(())
    }

    /// Elements of other types are counted, other things are named.
    fn pass(&mut self, keyword: &str, count: usize) {
        let name = match keyword {
            "Edges" => "lines",
            "Quadrilaterals" => "quadrangles",
            "Prisms" => "prisms",
            "Hexahedra" | "Hexaedra" => "hexahedra",
            "Pyramids" => "pyramids",
            "TrianglesP3" => "third-order triangles",
            "TetrahedraP3" => "third-order tetrahedra",
            "TrianglesP4" => "fourth-order triangles",
            "TetrahedraP4" => "fourth-order tetrahedra",
            _ => return self.draft.pass(format!("{count} {keyword}")),
        };
        self.draft.count_other(name, count);
    }

    fn finish(mut self) -> Result<Mesh, MeshError> {
        let has_tetrahedra = self
            .cells
            .iter()
            .any(|(nodes, ..)| matches!(nodes.len(), 4 | 10));
        if let (Some(error), false) = (self.other_triangles, has_tetrahedra) {
            return Err(error);
        }
        let index = self.draft.node_index()?;
        for (nodes, label, tag, place) in &self.cells {
            let element = Element {
                tag: *tag,
                label: *label,
                entity: 0,
                nodes,
                place: *place,
            };
            self.draft.add(&index, &element)?;
        }
        self.draft.finish()
    }
}

//! Surfaces of triangles, STL and OBJ, to be compared with the boundary of a mesh.

use super::error::{MeshError, Place};
use super::lines::{Line, Lines, words};
use super::source::{Encoding, Source, shown, without_mark};
use super::{Family, load};
use acutile_core::tiling::{Corner, Facet, Matching, Tiling};
use std::collections::BTreeMap;
use std::path::Path;

/// Triangles in space by the coordinates of their corners.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Three corners each, in the order of the file.
    pub triangles: Vec<[[f64; 3]; 3]>,
    /// Whether coordinates have single precision.
    pub is_single: bool,
}

/// The boundary of a mesh against a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Boundary facets that are no triangles of the surface.
    pub missing: Vec<Facet>,
    /// Triangles of the surface, by their indices, that are no boundary facets.
    pub surplus: Vec<usize>,
    /// Triangles whose corners are in the opposite order.
    pub reversed: usize,
    /// Whether coordinates of the mesh were rounded to single precision.
    pub is_rounded: bool,
}

/// Compares the boundary of a bounded mesh with a surface, triangle by triangle. Against a surface of
/// single precision, the mesh's coordinates are rounded if they do not agree as they are.
pub fn compare(tiling: &Tiling<3>, matching: &Matching<3>, surface: &Surface) -> Comparison {
    let plain = compare_as(tiling, matching, surface, |x| x);
    if !surface.is_single || (plain.missing.is_empty() && plain.surplus.is_empty()) {
        return plain;
    }
    let rounded = compare_as(tiling, matching, surface, |x| f64::from(x as f32));
    Comparison {
        is_rounded: true,
        ..rounded
    }
}

fn compare_as(
    tiling: &Tiling<3>,
    matching: &Matching<3>,
    surface: &Surface,
    rounded: fn(f64) -> f64,
) -> Comparison {
    let point = |corner: &Corner<3>| {
        // Coordinates of a bounded mesh are doubles.
        tiling
            .position(corner)
            .each_ref()
            .map(|x| rounded(x.approximate()))
    };
    let mut facets: BTreeMap<Form, Vec<(Facet, bool)>> = BTreeMap::new();
    let single = matching.mismatches.iter().filter(|m| m.uses.len() == 1);
    for mismatch in single {
        let facet = mismatch.uses[0].0;
        let opposite = usize::from(facet.opposite);
        let corners = tiling.simplex(facet.simplex);
        let mut triangle = [0, 1, 2].map(|k| point(&corners[k + usize::from(k >= opposite)]));
        if opposite % 2 == 1 {
            triangle.swap(1, 2);
        }
        let (form, is_even) = form(&triangle);
        facets.entry(form).or_default().push((facet, is_even));
    }
    let mut comparison = Comparison {
        missing: Vec::new(),
        surplus: Vec::new(),
        reversed: 0,
        is_rounded: false,
    };
    for (index, triangle) in surface.triangles.iter().enumerate() {
        let (form, is_even) = form(triangle);
        match facets.get_mut(&form).and_then(Vec::pop) {
            Some((_, facet_is_even)) => {
                comparison.reversed += usize::from(is_even != facet_is_even);
            }
            None => comparison.surplus.push(index),
        }
    }
    let missing = facets.into_values().flatten().map(|(facet, _)| facet);
    comparison.missing = missing.collect();
    comparison.missing.sort_unstable();
    comparison
}

type Form = [[u64; 3]; 3];

/// The corners in order, by the bits of their coordinates with one zero, and whether they were in an
/// even permutation of it.
fn form(triangle: &[[f64; 3]; 3]) -> (Form, bool) {
    let mut corners = triangle.map(|corner| corner.map(|x| (x + 0.0).to_bits()));
    let pairs = [(0, 1), (0, 2), (1, 2)];
    let odd = pairs
        .iter()
        .filter(|(i, j)| corners[*i] > corners[*j])
        .count()
        % 2
        == 1;
    corners.sort_unstable();
    (corners, !odd)
}

/// Reads an STL or OBJ file by its extension, or the triangles of a mesh file.
///
/// # Errors
/// With the line or byte, what was expected and what was found.
pub fn load_surface(path: &Path) -> Result<Surface, MeshError> {
    let name = path.to_string_lossy().to_ascii_lowercase();
    let name = name.strip_suffix(".gz").unwrap_or(&name);
    if name.ends_with(".stl") || name.ends_with(".obj") {
        let bytes = load::bytes(path)?;
        let surface = if name.ends_with(".stl") {
            read_stl(&bytes)
        } else {
            read_obj(&bytes)
        };
        return surface.and_then(|surface| {
            if surface.triangles.is_empty() {
                Err(MeshError::of_file("has no triangles"))
            } else {
                Ok(surface)
            }
        });
    }
    let family = Family::of_path(path).ok_or_else(|| {
        MeshError::of_file(
            "found no surface, expected a file .stl or .obj, or a mesh file of triangles",
        )
    })?;
    let mesh = load::load(path, family)?.mesh;
    if mesh.dimension() != 2 {
        return Err(MeshError::of_file(
            "a mesh of tetrahedra, expected a surface of triangles",
        ));
    }
    if !mesh.curved.is_empty() {
        let count = mesh.curved.len();
        return Err(MeshError::limit(format!(
            "has {}, expected a surface of plane triangles",
            super::counted(count, "curved triangles")
        )));
    }
    let point = |index: u32| mesh.points[index as usize];
    Ok(Surface {
        triangles: mesh.triangles.iter().map(|t| t.map(point)).collect(),
        is_single: false,
    })
}

/// STL, binary if its length is that of its number of triangles.
pub fn read_stl(bytes: &[u8]) -> Result<Surface, MeshError> {
    let count = bytes.get(80..84).map(|count| {
        let count: [u8; 4] = count.try_into().unwrap_or_default();
        u32::from_le_bytes(count) as usize
    });
    match count {
        Some(count) if bytes.len() == 84 + 50 * count => binary_stl(bytes, count),
        _ if without_mark(bytes).trim_ascii_start().starts_with(b"solid") => text_stl(bytes),
        _ => Err(MeshError::of_file(format!(
            "no STL: a text begins with \"solid\", a binary file of {} triangles has {} bytes, \
             this one has {}",
            count.unwrap_or(0),
            84 + 50 * count.unwrap_or(0),
            bytes.len()
        ))),
    }
}

/// A head of 80 bytes, the number of triangles; for each a normal, three corners, two bytes.
fn binary_stl(bytes: &[u8], count: usize) -> Result<Surface, MeshError> {
    let mut source = Source::new(&bytes[84..]);
    source.encoding = Encoding::Little;
    let mut triangles = Vec::with_capacity(count);
    for _ in 0..count {
        source.take(12, "a normal")?;
        let mut corners = [[0.0; 3]; 3];
        for x in corners.as_flattened_mut() {
            *x = source.single("a coordinate").map_err(|error| MeshError {
                place: Place::Byte(84 + source.position() as u64),
                ..error
            })?;
        }
        source.take(2, "an attribute")?;
        triangles.push(corners);
    }
    Ok(Surface {
        triangles,
        is_single: true,
    })
}

/// `facet normal x y z`, `outer loop`, three times `vertex x y z`, `endloop`, `endfacet`.
fn text_stl(bytes: &[u8]) -> Result<Surface, MeshError> {
    let mut triangles = Vec::new();
    let mut corners: Vec<[f64; 3]> = Vec::new();
    for line in words(bytes, 0) {
        match line.words[0].to_ascii_lowercase().as_slice() {
            b"vertex" => corners.push(point(&line)?),
            b"endloop" => {
                let found = corners.len();
                let triangle = std::mem::take(&mut corners)
                    .try_into()
                    .map_err(|_| line.error(format!("a facet has {found} corners, expected 3")))?;
                triangles.push(triangle);
            }
            b"solid" | b"endsolid" | b"facet" | b"endfacet" | b"outer" => {}
            _ => {
                let found = shown(line.words[0]);
                return Err(line.error(format!("found {found}, expected facet or vertex")));
            }
        }
    }
    if corners.is_empty() {
        Ok(Surface {
            triangles,
            is_single: false,
        })
    } else {
        Err(MeshError::of_file("the file ends inside of a facet"))
    }
}

fn point(line: &Line) -> Result<[f64; 3], MeshError> {
    Ok([
        line.coordinate(1)?,
        line.coordinate(2)?,
        line.coordinate(3)?,
    ])
}

/// `v x y z` for points and `f a b c` for triangles, with numbers from 1, or from the end if negative.
pub fn read_obj(bytes: &[u8]) -> Result<Surface, MeshError> {
    let mut lines = Lines::new(words(bytes, b'#'), bytes.len());
    let mut points: Vec<[f64; 3]> = Vec::new();
    let mut triangles = Vec::new();
    while let Ok(line) = lines.next("a line") {
        match line.words[0] {
            b"v" => points.push(point(&line)?),
            b"f" => {
                let corners = &line.words[1..];
                if corners.len() != 3 {
                    return Err(MeshError {
                        is_limit: true,
                        ..line.error(format!(
                            "a face has {} corners, expected 3: other polygons are not read",
                            corners.len()
                        ))
                    });
                }
                let mut triangle = [[0.0; 3]; 3];
                for (corner, word) in triangle.iter_mut().zip(corners) {
                    *corner = obj_corner(&line, word, &points)?;
                }
                triangles.push(triangle);
            }
            _ => {}
        }
    }
    Ok(Surface {
        triangles,
        is_single: false,
    })
}

/// `7`, `7/1`, `7//3` or `-1`.
fn obj_corner(line: &Line, word: &[u8], points: &[[f64; 3]]) -> Result<[f64; 3], MeshError> {
    let number = word.split(|&byte| byte == b'/').next().unwrap_or_default();
    let number: Option<i64> = std::str::from_utf8(number)
        .ok()
        .and_then(|n| n.parse().ok());
    let index = number.and_then(|number| match number {
        1.. => usize::try_from(number - 1).ok(),
        _ => points.len().checked_sub(usize::try_from(-number).ok()?),
    });
    index
        .and_then(|index| points.get(index).copied())
        .ok_or_else(|| {
            line.error(format!(
                "found the corner {}, expected 1 to {}",
                shown(word),
                points.len()
            ))
        })
}

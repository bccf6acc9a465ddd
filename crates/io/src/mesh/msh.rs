//! Gmsh's MSH format: header and sections. The versions differ in `msh2` and `msh4`.
//! (Gmsh reference manual, "MSH file format", and "Legacy formats" for version 2.)

use super::error::{MeshError, Place};
use super::numbering::Index;
use super::source::{Encoding, Source, shown};
use super::{Mesh, msh2, msh4};

/// Reads a file of version 2.0 to 2.2 or 4.1, text or binary.
pub fn read(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let mut source = Source::new(bytes);
    let version = header(&mut source)?;
    let mut mesh = Mesh::default();
    let mut index = None;
    let mut has_elements = false;
    while let Some(name) = section(&mut source)? {
        match name.as_str() {
            "Nodes" if index.is_some() => return Err(second(&source, "Nodes")),
            "Nodes" => {
                match version {
                    Version::Two => msh2::nodes(&mut source, &mut mesh)?,
                    Version::Four => msh4::nodes(&mut source, &mut mesh)?,
                }
                index = Some(mesh.node_index()?);
            }
            "Elements" if has_elements => return Err(second(&source, "Elements")),
            "Elements" => {
                let index = after_nodes(&index, &source, "Elements")?;
                match version {
                    Version::Two => msh2::elements(&mut source, index, &mut mesh)?,
                    Version::Four => msh4::elements(&mut source, index, &mut mesh)?,
                }
                has_elements = true;
            }
            "Periodic" => {
                let index = after_nodes(&index, &source, "Periodic")?;
                match version {
                    Version::Two => msh2::periodic(&mut source, index, &mut mesh)?,
                    Version::Four => msh4::periodic(&mut source, index, &mut mesh)?,
                }
            }
            _ => {
                skip(&mut source, &name)?;
                mesh.unread.push(format!("section ${name}"));
                continue;
            }
        }
        end(&mut source, &name)?;
    }
    match (index, has_elements) {
        (None, _) => Err(MeshError::of_file("has no section $Nodes")),
        (_, false) => Err(MeshError::of_file("has no section $Elements")),
        _ => mesh.checked(),
    }
}

enum Version {
    Two,
    Four,
}

/// `$MeshFormat`, version, 0 for text or 1 for binary, and the bytes of a number; then,
/// for binary, the integer 1, which shows the order of bytes.
fn header(source: &mut Source) -> Result<Version, MeshError> {
    source.expect("$MeshFormat")?;
    let word = source.word("a version like 2.2 or 4.1")?;
    let version = match word {
        b"2" | b"2.0" | b"2.1" | b"2.2" => Version::Two,
        b"4.1" => Version::Four,
        _ => {
            let problem = format!(
                "found MSH version {}, expected 2.0 to 2.2, or 4.1 (Gmsh converts others)",
                shown(word)
            );
            return Err(source.error(problem));
        }
    };
    let kind = source.int("0 for text or 1 for binary")?;
    let size = source.int("the bytes of a number")?;
    if !(0..=1).contains(&kind) || size != 8 {
        let problem =
            format!("found file type {kind} and data size {size}, expected type 0 or 1 and size 8");
        return Err(source.error(problem));
    }
    source.rest_of_line();
    if kind == 1 {
        let one = source.take(4, "the integer 1")?;
        source.encoding = match one {
            [1, 0, 0, 0] => Encoding::Little,
            [0, 0, 0, 1] => Encoding::Big,
            _ => {
                let place = Place::Byte(source.position() as u64 - 4);
                let problem = format!("found {one:?}, expected the integer 1 in four bytes");
                return Err(MeshError::at(place, problem));
            }
        };
    }
    source.expect("$EndMeshFormat")?;
    Ok(version)
}

/// The name of the next section; the cursor goes behind its line.
fn section(source: &mut Source) -> Result<Option<String>, MeshError> {
    let Some(word) = source.try_word() else {
        return Ok(None);
    };
    match word {
        [b'$', name @ ..] if !name.starts_with(b"End") => {
            source.rest_of_line();
            Ok(Some(String::from_utf8_lossy(name).into_owned()))
        }
        _ => Err(source.unexpected(word, "a section like $Nodes, or the end of the file")),
    }
}

fn end(source: &mut Source, name: &str) -> Result<(), MeshError> {
    source.expect(&format!("$End{name}"))
}

fn skip(source: &mut Source, name: &str) -> Result<(), MeshError> {
    let place = source.place();
    source
        .skip_past_line(&format!("$End{name}"))
        .ok_or_else(|| {
            let problem = format!("the section ${name} has no end, expected $End{name}");
            MeshError::at(place, problem)
        })
}

fn second(source: &Source, name: &str) -> MeshError {
    source.error(format!("found a second section ${name}, expected one"))
}

fn after_nodes<'i>(
    index: &'i Option<Index>,
    source: &Source,
    name: &str,
) -> Result<&'i Index, MeshError> {
    index
        .as_ref()
        .ok_or_else(|| source.error(format!("${name} comes before $Nodes, expected it after")))
}

//! Gmsh's MSH format: header and sections. The versions differ in `msh1`, `msh2`, `msh40` and
//! `msh4`. (Gmsh reference manual, "MSH file format" and "Legacy formats".)

use super::draft::Draft;
use super::error::{MeshError, Place};
use super::msh_sections::{self, Entities};
use super::numbering::Index;
use super::source::{Encoding, Source, shown};
use super::{Mesh, msh1, msh2, msh4, msh40};

/// Reads a file of version 1, 2, 4.0 or 4.1, text or binary.
pub fn read(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let mut source = Source::new(bytes);
    let mut reading = Reading::default();
    while let Some(name) = section(&mut source)? {
        reading.section(&mut source, &name)?;
    }
    reading.finish()
}

/// The versions that differ in their sections.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Version {
    One,
    Two,
    FourZero,
    FourOne,
}

#[derive(Default)]
struct Reading {
    version: Option<Version>,
    draft: Draft,
    entities: Entities,
    index: Option<Index>,
    has_elements: bool,
}

impl Reading {
    fn section(&mut self, source: &mut Source, name: &str) -> Result<(), MeshError> {
        match name {
            "MeshFormat" if self.version.is_some() => {
                return Err(second(source, "MeshFormat"));
            }
            "MeshFormat" => self.version = Some(header(source)?),
            "NOD" | "ParametricNodes" | "Nodes" => self.nodes(source, name)?,
            "ELM" | "Elements" => self.elements(source, name)?,
            "Periodic" => {
                let version = self.known_version(source, name)?;
                let index = after_nodes(&self.index, source, name)?;
                match version {
                    Version::One | Version::Two => msh2::periodic(source, index, &mut self.draft)?,
                    Version::FourZero => msh40::periodic(source, index, &mut self.draft)?,
                    Version::FourOne => msh4::periodic(source, index, &mut self.draft)?,
                }
            }
            "PhysicalNames" => msh_sections::physical_names(source, &mut self.draft)?,
            "Entities" => match self.known_version(source, name)? {
                Version::FourZero => self.entities = Entities::read(source, true)?,
                Version::FourOne => self.entities = Entities::read(source, false)?,
                Version::One | Version::Two => return self.pass(source, name),
            },
            "NodeData" | "ElementData" | "ElementNodeData" if is_binary(source) => {
                msh_sections::skip_data(source, name)?;
                self.draft.pass(format!("section ${name}"));
            }
            _ => return self.pass(source, name),
        }
        let end = match name {
            "NOD" | "ELM" => format!("$END{name}"),
            _ => format!("$End{name}"),
        };
        source.expect(&end)
    }

    fn nodes(&mut self, source: &mut Source, name: &str) -> Result<(), MeshError> {
        if self.index.is_some() {
            return Err(second(source, name));
        }
        let draft = &mut self.draft;
        if name == "NOD" {
            // Version 1 has no header. Gmsh writes the other sections into such files as into those of version 2.
            self.version.get_or_insert(Version::One);
            msh1::nodes(source, draft)?;
        } else {
            let is_parametric = name == "ParametricNodes";
            match self.version.ok_or_else(|| no_version(source, name))? {
                Version::One => return Err(no_version(source, name)),
                Version::Two => msh2::nodes(source, draft, is_parametric)?,
                Version::FourZero => msh40::nodes(source, draft)?,
                Version::FourOne => msh4::nodes(source, draft)?,
            }
        }
        self.index = Some(self.draft.node_index()?);
        Ok(())
    }

    fn elements(&mut self, source: &mut Source, name: &str) -> Result<(), MeshError> {
        if std::mem::replace(&mut self.has_elements, true) {
            return Err(second(source, name));
        }
        let index = after_nodes(&self.index, source, name)?;
        let (draft, entities) = (&mut self.draft, &self.entities);
        if name == "ELM" {
            return msh1::elements(source, index, draft);
        }
        match self.version.ok_or_else(|| no_version(source, name))? {
            Version::One => Err(no_version(source, name)),
            Version::Two => msh2::elements(source, index, draft),
            Version::FourZero => msh40::elements(source, index, entities, draft),
            Version::FourOne => msh4::elements(source, index, entities, draft),
        }
    }

    fn known_version(&self, source: &Source, name: &str) -> Result<Version, MeshError> {
        self.version.ok_or_else(|| no_version(source, name))
    }

    /// Passes over a section. Text and binary are searched for its end.
    fn pass(&mut self, source: &mut Source, name: &str) -> Result<(), MeshError> {
        let place = source.place();
        source.skip_past(&format!("$End{name}")).ok_or_else(|| {
            let problem = format!("the section ${name} has no end, expected $End{name}");
            MeshError::at(place, problem)
        })?;
        self.draft.pass(format!("section ${name}"));
        Ok(())
    }

    fn finish(self) -> Result<Mesh, MeshError> {
        match (self.index, self.has_elements) {
            (None, _) => Err(MeshError::of_file(
                "has no section $Nodes, expected a mesh that Gmsh saved whole",
            )),
            (_, false) => Err(MeshError::of_file(
                "has no section $Elements, expected a mesh that Gmsh saved whole",
            )),
            _ => self.draft.finish(),
        }
    }
}

fn is_binary(source: &Source) -> bool {
    source.encoding != Encoding::Text
}

/// The version, 0 for text or 1 for binary, and the bytes of a number. In a binary file the integer 1
/// follows, which shows the order of bytes.
fn header(source: &mut Source) -> Result<Version, MeshError> {
    let word = source.word("a version like 2.2 or 4.1")?;
    let number = std::str::from_utf8(word)
        .ok()
        .and_then(|word| word.parse::<f64>().ok());
    // Versions are decimals, and 2.200000 is 2.2.
    let version = match number {
        Some(number) if (2.0..3.0).contains(&number) => Version::Two,
        Some(4.0) => Version::FourZero,
        Some(4.1) => Version::FourOne,
        _ => {
            let problem = format!(
                "found MSH version {}, expected 1, 2.0 to 2.2, 4.0 or 4.1 (Gmsh and meshio \
                 convert others)",
                shown(word)
            );
            return Err(source.error(problem));
        }
    };
    let kind = source.int("0 for text or 1 for binary")?;
    let size = source.int("the bytes of a number")?;
    if !(0..=1).contains(&kind) || (kind == 1 && size != 8) {
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
    Ok(version)
}

/// The name of the next section; the cursor goes to the line after it.
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

fn second(source: &Source, name: &str) -> MeshError {
    source.error(format!("found a second section ${name}, expected one"))
}

fn no_version(source: &Source, name: &str) -> MeshError {
    source.error(format!(
        "${name} comes before $MeshFormat, expected it after: the version is not known"
    ))
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

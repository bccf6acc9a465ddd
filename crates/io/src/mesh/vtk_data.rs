//! Data of VTK legacy files: arrays of one integer for each cell are kept, others are passed over.

use super::draft::Draft;
use super::error::MeshError;
use super::source::{Encoding, Source};
use super::vtk_cells::Cells;

/// The type of an array's numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Single,
    Double,
    /// An integer of this many bytes, signed or not.
    Integer(usize, bool),
    /// Bits, eight in a byte.
    Bit,
    /// Texts, one on a line; in binary a length before each.
    Text,
    /// A type and a text on a line, in binary files too.
    Variant,
}

/// The next word as a type, in any case.
pub fn kind(source: &mut Source) -> Result<Kind, MeshError> {
    let word = source.word("a type of numbers like double")?;
    Ok(match word.to_ascii_lowercase().as_slice() {
        b"float" => Kind::Single,
        b"double" => Kind::Double,
        b"bit" => Kind::Bit,
        b"string" | b"utf8_string" => Kind::Text,
        b"variant" => Kind::Variant,
        b"char" | b"signed_char" | b"vtktypeint8" => Kind::Integer(1, true),
        b"unsigned_char" | b"vtktypeuint8" => Kind::Integer(1, false),
        b"short" | b"vtktypeint16" => Kind::Integer(2, true),
        b"unsigned_short" | b"vtktypeuint16" => Kind::Integer(2, false),
        b"int" | b"vtktypeint32" | b"vtkidtype" => Kind::Integer(4, true),
        b"unsigned_int" | b"vtktypeuint32" => Kind::Integer(4, false),
        b"long" | b"long_long" | b"vtktypeint64" => Kind::Integer(8, true),
        b"unsigned_long" | b"unsigned_long_long" | b"vtktypeuint64" => Kind::Integer(8, false),
        _ => return Err(source.unexpected(word, "a type of numbers like double")),
    })
}

impl Kind {
    /// The bytes of a number.
    pub fn bytes(self) -> usize {
        match self {
            Kind::Single => 4,
            Kind::Double => 8,
            Kind::Integer(bytes, _) => bytes,
            Kind::Bit | Kind::Text | Kind::Variant => 1,
        }
    }

    /// A coordinate; an integer is taken as a double where that is exact.
    pub fn coordinate(self, source: &mut Source) -> Result<f64, MeshError> {
        match self {
            Kind::Single => source.single("a coordinate"),
            Kind::Double => source.double("a coordinate"),
            _ => {
                let value = self.integer(source)?;
                if value.unsigned_abs() <= 1 << 53 {
                    Ok(value as f64)
                } else {
                    Err(source.error(format!(
                        "found the coordinate {value}, expected an integer that is a double"
                    )))
                }
            }
        }
    }

    /// An integer.
    pub fn integer(self, source: &mut Source) -> Result<i64, MeshError> {
        let Kind::Integer(bytes, signed) = self else {
            return Err(source.error("found a type that is none of integers, expected integers"));
        };
        match source.encoding {
            Encoding::Text => source.int("an integer"),
            encoding => {
                let digits = source.take(bytes, "an integer")?;
                super::vtu_data::integer(digits, encoding, signed)
                    .ok_or_else(|| source.error("found an integer of more than 63 bits"))
            }
        }
    }

    /// Passes over numbers or texts.
    fn skip(self, source: &mut Source, count: usize) -> Result<(), MeshError> {
        match (source.encoding, self) {
            (Encoding::Text, Kind::Text) | (_, Kind::Variant) => {
                (0..count).try_for_each(|_| skip_line(source))
            }
            (_, Kind::Text) => (0..count).try_for_each(|_| skip_text(source)),
            (Encoding::Text, _) => (0..count).try_for_each(|_| source.word("a number").map(drop)),
            (_, Kind::Bit) => source.take(count.div_ceil(8), "an array").map(drop),
            _ => source
                .take(count.saturating_mul(self.bytes()), "an array")
                .map(drop),
        }
    }
}

fn skip_line(source: &mut Source) -> Result<(), MeshError> {
    match source.remaining() {
        0 => Err(source.error("the file ends, expected a text")),
        _ => {
            source.rest_of_line();
            Ok(())
        }
    }
}

/// Passes over a text in binary. The two highest bits of its first byte tell that its length has 1, 2, 4
/// or 8 bytes, the first one included (vtkDataWriter, `VTK_STRING`).
fn skip_text(source: &mut Source) -> Result<(), MeshError> {
    let first = source.take(1, "the length of a text")?[0];
    let further = [7, 3, 1, 0][usize::from(first >> 6)];
    let digits = source.take(further, "the length of a text")?;
    let length = digits
        .iter()
        .fold(usize::from(first & 0x3f), |value, &digit| {
            value.saturating_mul(256).saturating_add(usize::from(digit))
        });
    source.take(length, "a text").map(drop)
}

/// Passes over metadata, which end with an empty line.
pub fn skip_metadata(source: &mut Source) {
    source.rest_of_line();
    while source.remaining() > 0 && !source.rest_of_line().is_empty() {}
}

/// `CELL_DATA n` or `POINT_DATA n` and all that follows. Where something unknown comes, the rest
/// is passed over, for nothing else follows data.
pub fn data(
    source: &mut Source,
    first: &[u8],
    cells: &mut Cells,
    draft: &mut Draft,
) -> Result<(), MeshError> {
    let mut head = Some(first.to_vec());
    let mut of_cells = false;
    let mut count = 0;
    while let Some(word) = head
        .take()
        .or_else(|| source.try_word().map(<[u8]>::to_vec))
    {
        match word.to_ascii_uppercase().as_slice() {
            name @ (b"CELL_DATA" | b"POINT_DATA") => {
                of_cells = name == b"CELL_DATA";
                count = in_text(source, |source| source.int("the number of tuples"))?;
            }
            b"METADATA" => skip_metadata(source),
            b"FIELD" => {
                let arrays = fields(source)?;
                for _ in 0..arrays {
                    let array = Array::of_field(source)?;
                    array.read(source, of_cells, cells, draft)?;
                }
            }
            keyword => match Array::of_attribute(source, keyword, count)? {
                Some(array) => array.read(source, of_cells, cells, draft)?,
                None => {
                    let name = String::from_utf8_lossy(&word).into_owned();
                    draft.pass(format!("the data from {name} on"));
                    return Ok(());
                }
            },
        }
    }
    Ok(())
}

/// Passes over `FIELD name arrays` with its arrays.
pub fn skip_field(source: &mut Source, draft: &mut Draft) -> Result<(), MeshError> {
    for _ in 0..fields(source)? {
        let array = Array::of_field(source)?;
        let count = array.count(source)?;
        array.kind.skip(source, count)?;
        draft.pass(format!("field {}", array.name));
    }
    Ok(())
}

fn fields(source: &mut Source) -> Result<usize, MeshError> {
    let arrays = in_text(source, |source| {
        source.word("a name")?;
        source.int("the number of arrays")
    })?;
    source.count(arrays, 8, "arrays")
}

/// An array before its numbers.
struct Array {
    name: String,
    components: i64,
    tuples: i64,
    kind: Kind,
}

impl Array {
    /// `name components tuples type`
    fn of_field(source: &mut Source) -> Result<Array, MeshError> {
        if source.skip_word("METADATA") {
            skip_metadata(source);
        }
        in_text(source, |source| {
            Ok(Array {
                name: name(source)?,
                components: source.int("the number of components")?,
                tuples: source.int("the number of tuples")?,
                kind: kind(source)?,
            })
        })
    }

    /// `SCALARS name type components`, a line with `LOOKUP_TABLE` and the like.
    fn of_attribute(
        source: &mut Source,
        keyword: &[u8],
        tuples: i64,
    ) -> Result<Option<Array>, MeshError> {
        let array = |source: &mut Source, components: i64| {
            in_text(source, |source| {
                Ok(Some(Array {
                    name: name(source)?,
                    components,
                    tuples,
                    kind: kind(source)?,
                }))
            })
        };
        match keyword {
            b"SCALARS" => {
                let (name, kind, rest) = {
                    let encoding = std::mem::replace(&mut source.encoding, Encoding::Text);
                    let name = name(source)?;
                    let kind = kind(source)?;
                    let rest = source.rest_of_line();
                    source.encoding = encoding;
                    (name, kind, rest)
                };
                let rest = std::str::from_utf8(rest).unwrap_or("");
                let components = rest.trim().parse().unwrap_or(1);
                let mut ahead = source.clone();
                ahead.encoding = Encoding::Text;
                let word = ahead.try_word().unwrap_or_default();
                if word.eq_ignore_ascii_case(b"LOOKUP_TABLE") {
                    in_text(source, |source| source.word("LOOKUP_TABLE").map(drop))?;
                }
                Ok(Some(Array {
                    name,
                    components,
                    tuples,
                    kind,
                }))
            }
            b"VECTORS" | b"NORMALS" => array(source, 3),
            b"TENSORS" => array(source, 9),
            b"TENSORS6" => array(source, 6),
            b"GLOBAL_IDS" | b"PEDIGREE_IDS" | b"EDGE_FLAGS" => array(source, 1),
            _ => Ok(None),
        }
    }

    fn count(&self, source: &mut Source) -> Result<usize, MeshError> {
        let count = self.components.saturating_mul(self.tuples);
        let least = match (source.encoding, self.kind) {
            (_, Kind::Bit | Kind::Text | Kind::Variant) => 1,
            (Encoding::Text, _) => 2,
            _ => self.kind.bytes(),
        };
        let items = match self.kind {
            Kind::Bit if count >= 0 => count / 8,
            _ => count,
        };
        source.count(items, least.max(1), "numbers of an array")?;
        usize::try_from(count).map_err(|_| source.error("found a negative number of numbers"))
    }

    /// Keeps one integer for each cell, and passes over all else.
    fn read(
        self,
        source: &mut Source,
        of_cells: bool,
        cells: &mut Cells,
        draft: &mut Draft,
    ) -> Result<(), MeshError> {
        let count = self.count(source)?;
        let is_label = of_cells && self.components == 1 && matches!(self.kind, Kind::Integer(..));
        if !is_label {
            let owner = if of_cells { "cells" } else { "points" };
            draft.pass(format!("array {} of {owner}", self.name));
            return self.kind.skip(source, count);
        }
        let mut values = Vec::with_capacity(count);
        for _ in 0..count {
            values.push(self.kind.integer(source)?);
        }
        cells.arrays.push((self.name, values));
        Ok(())
    }
}

fn name(source: &mut Source) -> Result<String, MeshError> {
    Ok(String::from_utf8_lossy(source.word("a name")?).into_owned())
}

/// Reads in text what stands in text in a binary file, too: the rest of a line of words.
pub fn in_text<T>(
    source: &mut Source,
    read: impl FnOnce(&mut Source) -> Result<T, MeshError>,
) -> Result<T, MeshError> {
    let encoding = std::mem::replace(&mut source.encoding, Encoding::Text);
    let value = read(source)?;
    source.rest_of_line();
    source.encoding = encoding;
    Ok(value)
}

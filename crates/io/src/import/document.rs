//! The project's own tiling and point-set files as they stand in JSON, numbers
//! still as text. The format is described in docs/format.md.

use serde::de::{MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};
use serde_json::value::RawValue;
use std::collections::BTreeMap;
use std::fmt;
use std::marker::PhantomData;

/// The first members of every file of the project's own formats.
#[derive(Deserialize)]
pub struct Header {
    pub format: String,
    pub version: u64,
}

/// A tiling file, or a point-set file: the latter has `points` where the former
/// has `vertices` and `simplices`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Document<'a> {
    #[serde(rename = "format")]
    _format: String,
    #[serde(rename = "version")]
    _version: u64,
    /// For editors; it has no meaning here.
    #[serde(rename = "$schema", default)]
    _schema: Option<String>,
    /// Free text; never part of what is proved.
    #[serde(default)]
    pub name: Option<String>,
    #[serde(default)]
    pub description: Option<String>,
    pub dimension: usize,
    #[serde(borrow, default, deserialize_with = "generators")]
    pub generators: BTreeMap<String, Generator<'a>>,
    /// Parameters of a family, in the order of the file.
    #[serde(borrow, default)]
    pub parameters: Parameters<'a>,
    #[serde(borrow, default)]
    pub lattice: Option<Lattice<'a>>,
    #[serde(default)]
    pub coordinates: Coordinates,
    #[serde(borrow, default)]
    pub domain: Domain<'a>,
    #[serde(borrow, default)]
    pub vertices: Option<Vec<Vec<Text<'a>>>>,
    /// Names of the vertices or points; never part of what is proved.
    #[serde(default)]
    pub labels: Option<Vec<String>>,
    #[serde(default)]
    pub simplices: Option<Vec<Vec<CornerEntry>>>,
    #[serde(borrow, default)]
    pub points: Option<Vec<Vec<Text<'a>>>>,
}

/// A named real algebraic number: the only root of a polynomial in an interval.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Generator<'a> {
    /// Integer coefficients, constant term first.
    #[serde(borrow)]
    pub polynomial: Vec<Text<'a>>,
    /// Rational ends of the interval.
    #[serde(borrow)]
    pub root: (Text<'a>, Text<'a>),
}

/// The generators by name. A map would keep the last of two definitions of one name, so a
/// repeated name is an error.
fn generators<'de: 'a, 'a, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<BTreeMap<String, Generator<'a>>, D::Error> {
    deserializer.deserialize_map(GeneratorsVisitor)
}

struct GeneratorsVisitor;

impl<'de> Visitor<'de> for GeneratorsVisitor {
    type Value = BTreeMap<String, Generator<'de>>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("an object of generators by name")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        let mut generators = BTreeMap::new();
        while let Some(name) = map.next_key::<String>()? {
            if generators.contains_key(&name) {
                let problem =
                    format!("the generator {name:?} is defined twice; keep one definition");
                return Err(serde::de::Error::custom(problem));
            }
            generators.insert(name, map.next_value()?);
        }
        Ok(generators)
    }
}

/// The parameters of a family with their intervals. A repeated name is an error.
#[derive(Default)]
pub struct Parameters<'a>(pub Vec<(String, ParameterEntry<'a>)>);

/// The interval of a parameter: `[low, high]` is closed, or a record says which ends are left out.
pub struct ParameterEntry<'a> {
    pub low: Text<'a>,
    pub high: Text<'a>,
    pub open: Vec<EndName>,
}

impl<'de: 'a, 'a> Deserialize<'de> for ParameterEntry<'a> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ParameterVisitor(PhantomData))
    }
}

struct ParameterVisitor<'a>(PhantomData<&'a ()>);

impl<'de: 'a, 'a> Visitor<'de> for ParameterVisitor<'a> {
    type Value = ParameterEntry<'a>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("two ends like [\"0\", \"1/2\"], or low, high and open")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut array: A) -> Result<Self::Value, A::Error> {
        let mut ends: Vec<Text> = Vec::new();
        while let Some(end) = array.next_element()? {
            ends.push(end);
        }
        let [low, high] = ends[..] else {
            return Err(serde::de::Error::invalid_length(ends.len(), &self));
        };
        Ok(ParameterEntry {
            low,
            high,
            open: Vec::new(),
        })
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        use serde::de::Error;
        let (mut low, mut high, mut open) = (None, None, None);
        while let Some(member) = map.next_key::<String>()? {
            let is_repeated = match member.as_str() {
                "low" => low.replace(map.next_value()?).is_some(),
                "high" => high.replace(map.next_value()?).is_some(),
                "open" => open.replace(map.next_value()?).is_some(),
                _ => return Err(Error::unknown_field(&member, &["low", "high", "open"])),
            };
            if is_repeated {
                return Err(Error::custom(format!("the member {member:?} is repeated")));
            }
        }
        Ok(ParameterEntry {
            low: low.ok_or_else(|| Error::missing_field("low"))?,
            high: high.ok_or_else(|| Error::missing_field("high"))?,
            open: open.unwrap_or_default(),
        })
    }
}

/// An end of an interval.
#[derive(Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum EndName {
    Low,
    High,
}

impl<'de: 'a, 'a> Deserialize<'de> for Parameters<'a> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(ParametersVisitor(PhantomData))
    }
}

struct ParametersVisitor<'a>(PhantomData<&'a ()>);

impl<'de: 'a, 'a> Visitor<'de> for ParametersVisitor<'a> {
    type Value = Parameters<'a>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("an object of parameters by name")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        let mut parameters: Vec<(String, ParameterEntry)> = Vec::new();
        while let Some(name) = map.next_key::<String>()? {
            if parameters.iter().any(|(other, _)| *other == name) {
                let problem =
                    format!("the parameter {name:?} is defined twice; keep one definition");
                return Err(serde::de::Error::custom(problem));
            }
            parameters.push((name, map.next_value()?));
        }
        Ok(Parameters(parameters))
    }
}

/// The basis: its Gram matrix, or its vectors in Cartesian coordinates.
#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Lattice<'a> {
    #[serde(borrow)]
    Gram(Vec<Vec<Text<'a>>>),
    #[serde(borrow)]
    Vectors(Vec<Vec<Text<'a>>>),
}

/// In which coordinates points are given.
#[derive(Clone, Copy, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Coordinates {
    #[default]
    Fractional,
    Cartesian,
}

/// The domain.
#[derive(Default)]
pub enum Domain<'a> {
    #[default]
    Space,
    /// Lower and upper bound of the last coordinate.
    Slab(Vec<Text<'a>>),
    /// The corners of a polygon, in the last two coordinates.
    Prism(PolytopeEntry<'a>),
    Solid(PolytopeEntry<'a>),
    /// The union of the simplices and their translates by a lattice of this rank.
    Region(usize),
}

/// A word, or an object with one member; `"region"` is `{"region": 0}`.
impl<'de: 'a, 'a> Deserialize<'de> for Domain<'a> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(DomainVisitor)
    }
}

struct DomainVisitor;

const DOMAINS: &[&str] = &["space", "slab", "prism", "solid", "region"];

impl<'de> Visitor<'de> for DomainVisitor {
    type Value = Domain<'de>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("\"space\", \"region\", or an object with slab, prism, solid or region")
    }

    fn visit_str<E: serde::de::Error>(self, word: &str) -> Result<Self::Value, E> {
        match word {
            "space" => Ok(Domain::Space),
            "region" => Ok(Domain::Region(0)),
            "slab" => Err(E::custom(
                "a slab has bounds, expected an object like {\"slab\": [\"0\", \"1\"]}",
            )),
            "prism" | "solid" => Err(E::custom(format!(
                "a {word} has corners, expected an object {{{word:?}: {{\"vertices\": ...}}}}"
            ))),
            _ => Err(E::unknown_variant(word, DOMAINS)),
        }
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        use serde::de::Error;
        let Some(kind) = map.next_key::<String>()? else {
            return Err(A::Error::invalid_length(0, &self));
        };
        let domain = match kind.as_str() {
            "slab" => Domain::Slab(map.next_value()?),
            "prism" => Domain::Prism(map.next_value()?),
            "solid" => Domain::Solid(map.next_value()?),
            "region" => Domain::Region(map.next_value()?),
            _ => return Err(A::Error::unknown_variant(&kind, DOMAINS)),
        };
        match map.next_key::<String>()? {
            None => Ok(domain),
            Some(_) => Err(A::Error::invalid_length(2, &self)),
        }
    }
}

/// A polygon by its corners in cyclic order, or a polyhedron with faces.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PolytopeEntry<'a> {
    #[serde(borrow)]
    pub vertices: Vec<Vec<Text<'a>>>,
    #[serde(default)]
    pub faces: Option<Vec<Vec<usize>>>,
}

/// A number as it stands in the file: a JSON number or a string.
#[derive(Clone, Copy, Deserialize)]
#[serde(transparent)]
pub struct Text<'a>(#[serde(borrow)] pub &'a RawValue);

/// A corner: `3`, or `[3, 0, 0, 1]` with its shift.
pub struct CornerEntry {
    pub vertex: u64,
    pub shift: Vec<i64>,
}

impl<'de> Deserialize<'de> for CornerEntry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(CornerVisitor)
    }
}

struct CornerVisitor;

impl<'de> Visitor<'de> for CornerVisitor {
    type Value = CornerEntry;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a corner: a vertex number like 3, or [3, 0, 0, 1] with its shift")
    }

    fn visit_u64<E>(self, vertex: u64) -> Result<CornerEntry, E> {
        Ok(CornerEntry {
            vertex,
            shift: Vec::new(),
        })
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut array: A) -> Result<CornerEntry, A::Error> {
        let vertex = array
            .next_element()?
            .ok_or_else(|| serde::de::Error::invalid_length(0, &"a vertex number and its shift"))?;
        let mut shift = Vec::new();
        while let Some(step) = array.next_element()? {
            shift.push(step);
        }
        if shift.is_empty() {
            return Err(serde::de::Error::invalid_length(
                1,
                &"a vertex number and its shift",
            ));
        }
        Ok(CornerEntry { vertex, shift })
    }
}

//! The columns of the loop of sites that are read.

use super::block::{Block, Column};
use super::token::{Value, at_line};
use crate::import::ImportError;
use crate::import::atoms::element::{self, Kind};

const FRACTIONS: [&str; 3] = [
    "_atom_site_fract_x",
    "_atom_site_fract_y",
    "_atom_site_fract_z",
];
const LABELS: [&str; 3] = [
    "_atom_site_label",
    "_atom_site_id",
    "_atom_site_type_symbol",
];
const MULTIPLICITIES: [&str; 2] = [
    "_atom_site_site_symmetry_multiplicity",
    "_atom_site_symmetry_multiplicity",
];

/// Whether a block has sites.
pub fn has_sites(block: &Block) -> bool {
    block.exact(FRACTIONS[0]).is_some()
}

/// Whether a block has sites in Cartesian coordinates.
pub fn has_cartesian_sites(block: &Block) -> bool {
    block.exact("_atom_site_cartn_x").is_some()
}

/// The columns that are read of the loop of sites.
pub struct Table<'b, 't> {
    pub coordinates: [Column<'b, 't>; 3],
    pub label: Option<Column<'b, 't>>,
    pub symbol: Option<Column<'b, 't>>,
    pub occupancy: Option<Column<'b, 't>>,
    pub flag: Option<Column<'b, 't>>,
    pub multiplicity: Option<Column<'b, 't>>,
    pub assembly: Option<Column<'b, 't>>,
    pub group: Option<Column<'b, 't>>,
}

/// The value of a column in a row, if it is known.
pub fn known<'t>(column: Option<Column<'_, 't>>, row: usize) -> Option<Value<'t>> {
    column
        .map(|column| column.value(row))
        .filter(|value| !value.is_missing())
}

impl<'b, 't> Table<'b, 't> {
    /// The columns of the sites of a block.
    ///
    /// # Errors
    /// Coordinates are missing, or stand in different loops.
    pub fn of(block: &'b Block<'t>) -> Result<Self, ImportError> {
        let coordinate = |tag| {
            let missing =
                || ImportError::entry(format!("data_{}", block.name), format!("{tag} is missing"));
            block.column(&[tag]).ok_or_else(missing)
        };
        let [x, y, z] = FRACTIONS.map(coordinate);
        let (x, y, z) = (x?, y?, z?);
        if y.group != x.group || z.group != x.group {
            return Err(at_line(
                x.value(0).line,
                "the coordinates of the sites stand in different loops",
            ));
        }
        let beside = |tags: &[&str]| block.column(tags).filter(|column| column.group == x.group);
        Ok(Table {
            coordinates: [x, y, z],
            label: beside(&LABELS),
            symbol: beside(&["_atom_site_type_symbol"]),
            occupancy: beside(&["_atom_site_occupancy"]),
            flag: beside(&["_atom_site_calc_flag"]),
            multiplicity: beside(&MULTIPLICITIES),
            assembly: beside(&["_atom_site_disorder_assembly"]),
            group: beside(&["_atom_site_disorder_group"]),
        })
    }

    /// The line of a row.
    pub fn line(&self, row: usize) -> u32 {
        self.coordinates[0].value(row).line
    }

    /// The label of a row; without one, its place in the loop.
    pub fn label(&self, row: usize) -> String {
        known(self.label, row)
            .map_or_else(|| format!("site{}", row + 1), |value| value.text.to_owned())
    }

    /// The element of the type symbol; without a type symbol, that of the label.
    pub fn element(&self, row: usize, label: &str) -> Option<&'static str> {
        match known(self.symbol, row).map(|value| element::kind(value.text)) {
            Some(Kind::Element(element)) => Some(element),
            Some(_) => None,
            None => element::of_label(label),
        }
    }
}

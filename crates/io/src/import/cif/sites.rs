//! The sites of a data block: labels and coordinates, chosen, snapped and checked.

use super::block::{Block, Column};
use super::decimal::{Decimal, Snapped};
use super::options::CifOptions;
use super::token::{Value, at_line, short};
use crate::import::ImportError;
use malachite::Rational;

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
const ADVICE: &str = "disorder cannot be a point set; choose sites with --only, or take each as an atom with --ignore-occupancy";

/// A site of the asymmetric unit.
pub struct Site {
    pub label: String,
    pub line: u32,
    pub position: [Rational; 3],
    /// One unit of the last written digit of each coordinate, zero where that is exact.
    pub units: [Rational; 3],
    /// How many atoms the file says that it stands for.
    pub multiplicity: Option<usize>,
}

/// The chosen sites, and what was done to their numbers.
#[derive(Default)]
pub struct Sites {
    pub sites: Vec<Site>,
    /// How many the file lists.
    pub listed: usize,
    /// Replaced and ambiguous numbers, in words.
    pub notes: Vec<String>,
    /// How many numbers had an uncertainty.
    pub uncertain: usize,
}

/// Whether a block has sites.
pub fn has_sites(block: &Block) -> bool {
    block.column(&FRACTIONS[..1]).is_some()
}

/// The sites of a block that the options choose.
///
/// # Errors
/// What is missing, unreadable or disordered.
pub fn sites(block: &Block, options: &CifOptions) -> Result<Sites, ImportError> {
    let columns = FRACTIONS.map(|tag| block.column(&[tag]).ok_or(tag));
    let mut coordinates = Vec::new();
    for column in columns {
        let missing =
            |tag| ImportError::entry(format!("data_{}", block.name), format!("{tag} is missing"));
        coordinates.push(column.map_err(missing)?);
    }
    let [x, y, z] = coordinates[..] else {
        return Ok(Sites::default());
    };
    let table = Table {
        coordinates: [x, y, z],
        label: beside(x, block.column(&LABELS)),
        occupancy: beside(x, block.column(&["_atom_site_occupancy"])),
        flag: beside(x, block.column(&["_atom_site_calc_flag"])),
        multiplicity: beside(x, block.column(&MULTIPLICITIES)),
    };
    if y.group != x.group || z.group != x.group {
        return Err(at_line(
            x.value(0).line,
            "the coordinates of the sites stand in different loops",
        ));
    }
    table.read(options)
}

/// A column of the same loop.
fn beside<'b, 't>(x: Column<'b, 't>, column: Option<Column<'b, 't>>) -> Option<Column<'b, 't>> {
    column.filter(|column| column.group == x.group)
}

struct Table<'b, 't> {
    coordinates: [Column<'b, 't>; 3],
    label: Option<Column<'b, 't>>,
    occupancy: Option<Column<'b, 't>>,
    flag: Option<Column<'b, 't>>,
    multiplicity: Option<Column<'b, 't>>,
}

impl Table<'_, '_> {
    fn read(&self, options: &CifOptions) -> Result<Sites, ImportError> {
        let rows = self.coordinates[0].len();
        let labels: Vec<String> = (0..rows).map(|row| self.label(row)).collect();
        for wanted in &options.only {
            if !labels.contains(wanted) {
                let problem = format!(
                    "there is no site {wanted}; the sites are {}",
                    listed(&labels)
                );
                return Err(ImportError::entry("--only", problem));
            }
        }
        let mut sites = Sites {
            listed: rows,
            ..Sites::default()
        };
        for (row, label) in labels.into_iter().enumerate() {
            if options.only.is_empty() || options.only.contains(&label) {
                self.check_ordered(row, &label, options)?;
                let site = self.site(row, label, options, &mut sites)?;
                sites.sites.push(site);
            }
        }
        Ok(sites)
    }

    fn label(&self, row: usize) -> String {
        let given = self
            .label
            .map(|column| column.value(row))
            .filter(|value| !value.is_missing());
        given.map_or_else(|| format!("site{}", row + 1), |value| value.text.to_owned())
    }

    fn check_ordered(
        &self,
        row: usize,
        label: &str,
        options: &CifOptions,
    ) -> Result<(), ImportError> {
        let wrong = |value: &Value, problem: String| {
            Err(at_line(value.line, format!("site {label} {problem}")))
        };
        let flag = self.flag.map(|column| column.value(row));
        if let Some(value) = flag.filter(|value| value.text.eq_ignore_ascii_case("dum")) {
            let problem =
                "is a dummy (_atom_site_calc_flag dum), no atom: leave it out with --only";
            return wrong(&value, problem.to_owned());
        }
        let Some(value) = self
            .occupancy
            .map(|column| column.value(row))
            .filter(|value| !value.is_missing())
        else {
            return Ok(());
        };
        match Decimal::parse(value.text) {
            Err(problem) => wrong(
                &value,
                format!("has an occupancy that cannot be read: {problem}"),
            ),
            Ok(number) if number.value != 1 && !options.ignore_occupancy => wrong(
                &value,
                format!("has the occupancy {}: {ADVICE}", value.text),
            ),
            Ok(_) => Ok(()),
        }
    }

    fn site(
        &self,
        row: usize,
        label: String,
        options: &CifOptions,
        sites: &mut Sites,
    ) -> Result<Site, ImportError> {
        let mut numbers = Vec::new();
        for (column, axis) in self.coordinates.iter().zip(["x", "y", "z"]) {
            let value = column.value(row);
            let number = coordinate(&value, axis, &label)?;
            sites.uncertain += usize::from(number.uncertain);
            numbers.push(snapped(
                number,
                &value,
                axis,
                &label,
                options.snap,
                &mut sites.notes,
            ));
        }
        let multiplicity = self
            .multiplicity
            .and_then(|column| column.value(row).text.parse().ok());
        Ok(Site {
            label,
            line: self.coordinates[0].value(row).line,
            position: std::array::from_fn(|k| numbers[k].0.clone()),
            units: std::array::from_fn(|k| numbers[k].1.clone()),
            multiplicity,
        })
    }
}

fn coordinate(value: &Value, axis: &str, label: &str) -> Result<Decimal, ImportError> {
    let wrong = |problem: String| at_line(value.line, format!("{axis} of site {label}: {problem}"));
    if value.is_missing() {
        return Err(wrong(format!(
            "is not known ({}); leave the site out with --only",
            value.text
        )));
    }
    Decimal::parse(value.text).map_err(wrong)
}

/// The value and the unit that are used; a replaced number is exact.
fn snapped(
    number: Decimal,
    value: &Value,
    axis: &str,
    label: &str,
    snap: Option<u32>,
    notes: &mut Vec<String>,
) -> (Rational, Rational) {
    match snap.map_or(Snapped::Kept, |n| number.snap(n)) {
        Snapped::To(fraction) => {
            notes.push(format!(
                "{label}: {axis} = {} replaced by {fraction}",
                value.text
            ));
            (fraction, Rational::from(0))
        }
        Snapped::Ambiguous => {
            let n = snap.unwrap_or_default();
            notes.push(format!(
                "{label}: {axis} = {} kept, it agrees with more than one multiple of 1/{n}",
                value.text
            ));
            (number.value, number.unit)
        }
        Snapped::Kept => (number.value, number.unit),
    }
}

/// The first labels, for a message.
fn listed(labels: &[String]) -> String {
    let shown: Vec<String> = labels.iter().take(20).map(|label| short(label)).collect();
    let more = if labels.len() > shown.len() {
        ", …"
    } else {
        ""
    };
    format!("{}{more}", shown.join(", "))
}

//! Rows about all members of a construction: a family, or a system of patches.
//!
//! The figures of a family are infima and suprema over its box. The enclosures are computed by the prover,
//! and no certificate states them. The figures of a system of patches are bounds that the row's certificate
//! states; some member attains each of them.

use super::{Figure, Row};
use crate::survey::General;
use acutile_catalog::{self as catalog, Theorem};
use acutile_core::family::AnyFamily;
use acutile_core::family::spans::{Extreme, Span, spans};
use acutile_core::limits::own_limits;
use acutile_core::patches::prove_bounds;
use acutile_core::predicates::Model;
use acutile_core::quality::{Exact, Range, Ranges, exact_ranges};
use acutile_core::tiling::AnyTiling;
use acutile_core::with_family;

impl Row {
    /// The row of a family or a system of patches of the catalogue.
    ///
    /// # Errors
    /// Why it is not proved, in a message that names it.
    pub fn of_general(name: &str) -> Result<Row, String> {
        match catalog::theorem(name) {
            Some(theorem) => of_patches(theorem).map_err(|error| format!("{name}: {error}")),
            None => of_family(name, &General::of_entry(name)?),
        }
    }
}

/// The row of a proved family.
///
/// # Errors
/// If it is no family.
pub fn of_family(name: &str, general: &General) -> Result<Row, String> {
    let family = general.family.as_ref();
    let family = family.ok_or_else(|| format!("{name}: no family"))?;
    Ok(Row {
        name: name.to_owned(),
        label: name.to_owned(),
        dimension: with_family!(family, f => f.frame.gram.len()),
        simplices: Some(with_family!(family, f => f.len())),
        shapes: None,
        certificate: general.certificate.clone(),
        figures: figures_of_family(family),
    })
}

/// Infimum and supremum of radius-edge ratio, smallest and largest dihedral angle of a proved family over
/// its box; `None` where no bound is found.
pub fn figures_of_family(family: &AnyFamily) -> [(Option<Figure>, Option<Figure>); 3] {
    let spans = with_family!(family, f => spans(f));
    [
        of_span(&spans.radius_edge),
        of_span(&spans.smallest_dihedral),
        of_span(&spans.largest_dihedral),
    ]
}

fn of_span<T: Exact + PartialEq>(span: &Span<T>) -> (Option<Figure>, Option<Figure>) {
    (of_extreme(&span.infimum), of_extreme(&span.supremum))
}

/// Between the bound and a value of the closed box; exact where they agree.
fn of_extreme<T: Exact + PartialEq>(extreme: &Extreme<T>) -> Option<Figure> {
    let [bound, seen] = [&extreme.bound, &extreme.seen].map(|x| x.as_ref());
    let (bound, seen) = bound.zip(seen)?;
    if bound == seen {
        return Some(Figure::of(seen));
    }
    let [bound, seen] = [bound, seen].map(Figure::of);
    let low = bound.bounds.0.min(seen.bounds.0);
    let high = bound.bounds.1.max(seen.bounds.1);
    Some(Figure {
        bounds: (low, high),
        closed_form: None,
    })
}

/// Members in which all cells of a system occur; the kernel confirms that no cell is beyond theirs.
fn members(theorem: &Theorem) -> &'static [&'static str] {
    match theorem.family {
        "kagome:" => &["z", "+", "-", "z+", "z-", "+-", "z+-"],
        _ => &["3", "4", "32434", "33344"],
    }
}

fn of_patches(theorem: &Theorem) -> Result<Row, String> {
    let words = members(theorem).iter();
    let ranges = words.map(|word| ranges(&format!("{}{word}", theorem.family)));
    let ranges = ranges.collect::<Result<Vec<Ranges>, String>>()?;
    let ranges = ranges.into_iter().reduce(widest).ok_or("no members")?;
    let system = (theorem.system)().map_err(|error| error.to_string())?;
    let proved =
        prove_bounds(&system, &ranges, &own_limits()).map_err(|error| error.to_string())?;
    Ok(Row {
        name: theorem.name.to_owned(),
        label: theorem.name.to_owned(),
        dimension: 3,
        simplices: None,
        shapes: None,
        certificate: proved.sha256(),
        figures: [
            super::figures(&ranges.radius_edge),
            super::figures(&ranges.smallest_dihedral),
            super::figures(&ranges.largest_dihedral),
        ],
    })
}

fn ranges(name: &str) -> Result<Ranges, String> {
    match catalog::build(name).map_err(|error| error.to_string())? {
        AnyTiling::Space(tiling) => exact_ranges(&Model::new(&tiling)),
        AnyTiling::Plane(tiling) => exact_ranges(&Model::new(&tiling)),
    }
    .ok_or_else(|| format!("{name}: has no simplices"))
}

fn widest(a: Ranges, b: Ranges) -> Ranges {
    fn of<T: Ord>(a: Range<T>, b: Range<T>) -> Range<T> {
        Range {
            min: a.min.min(b.min),
            max: a.max.max(b.max),
        }
    }
    Ranges {
        radius_edge: of(a.radius_edge, b.radius_edge),
        smallest_dihedral: of(a.smallest_dihedral, b.smallest_dihedral),
        largest_dihedral: of(a.largest_dihedral, b.largest_dihedral),
    }
}

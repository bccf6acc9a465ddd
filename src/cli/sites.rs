//! The points of a set, in words and as JSON: Delaunay cells, neighbours of each site, space group.

use super::named::InputError;
use super::output::Output;
use super::points::outcome_of;
use super::words::one_line;
use acutile_core::classify::{Surroundings, polyhedra, surroundings};
use acutile_core::delaunay::{Cell, cells_and_triangulation};
use acutile_core::tiling::{PointSet, Tiling};
use acutile_crystal::identify::{Identified, identify};
use acutile_crystal::symmetry::{Symmetry, symmetry};
use acutile_crystal::wyckoff::wyckoff;
use acutile_exact::number::Number;
use malachite::Rational;
use serde_json::{Map, Value, json};
use std::collections::{BTreeMap, HashMap};

/// Sites that are printed; JSON has all.
const PRINTED: usize = 40;

/// Points with what is known of them.
pub struct Sites<'a> {
    pub set: &'a PointSet<3>,
    /// One for each point, or none.
    pub labels: &'a [String],
    /// One for each point, or none.
    pub elements: &'a [Option<&'static str>],
}

impl Sites<'_> {
    /// The Delaunay cells, and the triangulation where all are tetrahedra.
    ///
    /// # Errors
    /// There is no Delaunay triangulation.
    pub fn cells(&self, name: &str) -> Result<(Vec<Cell<3>>, Option<Tiling<3>>), InputError> {
        cells_and_triangulation(self.set).map_err(|error| InputError {
            message: format!("{name}: {error}"),
            outcome: outcome_of(&error),
        })
    }

    /// Members of a report on points with these Delaunay cells.
    pub fn report(&self, cells: &[Cell<3>]) -> Map<String, Value> {
        let around = surroundings(cells, self.set.points.len());
        let group = self.group();
        let mut report = Map::new();
        report.insert("cells".into(), json!(polyhedra(cells)));
        report.insert("points".into(), json!(self.set.points.len()));
        report.insert("sites".into(), self.sites(&around, group.as_ref()));
        report.insert("volume".into(), json!(self.volume()));
        report.insert(
            "space_group".into(),
            json!(group.map(|(_, identified)| json!({
                "number": identified.setting.number,
                "symbol": identified.setting.short,
            }))),
        );
        report
    }

    /// The volume of a cell of the lattice.
    fn volume(&self) -> f64 {
        let gram = &self.set.frame.gram;
        acutile_exact::geometry::linear::determinant(gram)
            .approximate()
            .sqrt()
    }

    /// One entry for the points with the same label and the same surroundings.
    fn sites(&self, around: &[Surroundings], group: Option<&(Symmetry, Identified)>) -> Value {
        let mut classes: BTreeMap<(usize, &Surroundings), Vec<usize>> = BTreeMap::new();
        let mut first: HashMap<&str, usize> = HashMap::new();
        for (point, surroundings) in around.iter().enumerate() {
            // Labels keep the order of the file.
            let label = self.labels.get(point).map_or("", String::as_str);
            let order = *first.entry(label).or_insert(point);
            classes
                .entry((order, surroundings))
                .or_default()
                .push(point);
        }
        let entries = classes.into_iter().map(|((_, surroundings), points)| {
            let wyckoff = group.and_then(|group| self.wyckoff(group, points[0]));
            json!({
                "label": self.labels.get(points[0]),
                "element": self.elements.get(points[0]).copied().flatten(),
                "atoms": points.len(),
                "neighbours": surroundings.neighbours(),
                "type": surroundings.is_frank_kasper.then(|| format!("Z{}", surroundings.neighbours())),
                "voronoi_index": surroundings.voronoi_index(),
                "surroundings": surroundings.to_string(),
                "wyckoff": wyckoff,
            })
        });
        entries.collect()
    }

    fn wyckoff(
        &self,
        (symmetry, identified): &(Symmetry, Identified),
        point: usize,
    ) -> Option<String> {
        let position = rational(&self.set.points[point])?;
        let changed = std::array::from_fn(|i| {
            let terms = symmetry.change[i].iter().zip(&position);
            terms.fold(Rational::from(0), |sum, (a, x)| sum + a * x)
        });
        let found = wyckoff(identified, &changed)?;
        Some(format!("{}{}", found.multiplicity, found.letter))
    }

    /// The group of all isometries that keep the points and their elements; `None` if the numbers
    /// are not rational, or beyond the limits.
    fn group(&self) -> Option<(Symmetry, Identified)> {
        let gram = self.set.frame.gram.each_ref().map(rational);
        let [Some(a), Some(b), Some(c)] = gram else {
            return None;
        };
        let points: Vec<[Rational; 3]> = self
            .set
            .points
            .iter()
            .map(rational)
            .collect::<Option<_>>()?;
        let symmetry = symmetry(&[a, b, c], &points, &self.kinds())?;
        let identified = identify(&symmetry.group, &symmetry.gram)?;
        Some((symmetry, identified))
    }

    /// Points of one kind have the same element; without an element, the same label.
    fn kinds(&self) -> Vec<usize> {
        let mut numbers: HashMap<(bool, &str), usize> = HashMap::new();
        (0..self.set.points.len())
            .map(|point| {
                let element = self.elements.get(point).copied().flatten();
                let label = self.labels.get(point).map_or("", String::as_str);
                let key = (element.is_some(), element.unwrap_or(label));
                let fresh = numbers.len();
                *numbers.entry(key).or_insert(fresh)
            })
            .collect()
    }
}

fn rational(row: &[Number; 3]) -> Option<[Rational; 3]> {
    let [x, y, z] = row.each_ref().map(|x| x.to_rational().cloned());
    Some([x?, y?, z?])
}

/// `1 octahedron`, `2 octahedra`, `3 square pyramids`
fn counted(kind: &str, count: u64) -> String {
    let plural = match kind {
        kind if count == 1 => kind.to_owned(),
        kind if kind.contains("hedron") => kind.replacen("hedron", "hedra", 1),
        kind => format!("{kind}s"),
    };
    format!("{count} {plural}")
}

/// The number of cells that are no tetrahedra.
pub fn polytopes(cells: &[Cell<3>]) -> usize {
    cells.iter().filter(|cell| !cell.is_simplex()).count()
}

/// Prints the cells, the sites and the group of a report.
pub fn in_words(name: &str, report: &Value, output: &mut Output) {
    let points = report["points"].as_u64().unwrap_or(1);
    let cells: Vec<(&String, u64)> = report["cells"]
        .as_object()
        .into_iter()
        .flatten()
        .map(|(kind, count)| (kind, count.as_u64().unwrap_or(0)))
        .collect();
    let counts: Vec<String> = cells
        .iter()
        .map(|(kind, count)| counted(kind, *count))
        .collect();
    let share = if points > 1 && cells.iter().all(|(_, count)| count % points == 0) {
        let each: Vec<String> = cells
            .iter()
            .map(|(_, count)| (count / points).to_string())
            .collect();
        format!("; {} for each point", each.join(" and "))
    } else {
        String::new()
    };
    output.line(format!(
        "{name}: {} in a cell; Delaunay cells: {}{share}",
        counted("point", points),
        counts.join(", ")
    ));
    let group = &report["space_group"];
    if let (Some(number), Some(symbol)) = (group["number"].as_u64(), group["symbol"].as_str()) {
        output.line(format!(
            "space group of the points: {symbol} (number {number})"
        ));
    }
    let sites = report["sites"].as_array().map_or(&[][..], Vec::as_slice);
    for site in sites.iter().take(PRINTED) {
        let label = one_line(site["label"].as_str().unwrap_or("points"));
        let wyckoff = site["wyckoff"]
            .as_str()
            .map_or_else(String::new, |w| format!(", {w}"));
        output.line(format!(
            "site {label} ({} in a cell{wyckoff}): {}",
            site["atoms"],
            site["surroundings"].as_str().unwrap_or_default()
        ));
    }
    if sites.len() > PRINTED {
        output.line(format!(
            "and {} more sites, which --json lists",
            sites.len() - PRINTED
        ));
    }
}

//! The polynomials of a family whose signs prove it, each once, with the places where it occurs.

use super::numeral::Numerals;
use super::polynomial::polynomial;
use super::subject::Subject;
use super::tex::list;
use acutile_core::family::{Family, Tree};
use acutile_core::statement::Statement;
use acutile_core::tiling::{Corner, Facet, SimplexId, match_facets};
use acutile_exact::geometry::{RingElement, Simplex, linear};
use acutile_exact::number::Number;
use acutile_exact::polynomial::Polynomial;
use malachite::Rational;
use std::collections::BTreeMap;

/// What is written about a family.
pub struct Section<'f, const D: usize> {
    pub subject: &'f Subject,
    pub family: &'f Family<D>,
    pub tree: &'f Tree,
    pub numerals: Numerals,
}

impl<const D: usize> Section<'_, D> {
    pub fn rank(&self) -> usize {
        self.family.frame.rank()
    }

    pub fn label(&self, what: &str) -> String {
        format!("acutile:{}:{what}", self.subject.slug())
    }

    pub fn polynomial(&self, p: &Polynomial) -> String {
        polynomial(&self.numerals, &self.family.names(), p)
    }
}

/// A polynomial that is positive on the box, or at least zero.
pub struct Condition {
    pub polynomial: Polynomial,
    pub is_strict: bool,
    /// Where it occurs, in TeX.
    pub uses: String,
}

/// All conditions but the pairing and the volumes.
pub fn conditions<const D: usize>(section: &Section<D>) -> Vec<Condition> {
    let mut found = Found {
        places: BTreeMap::new(),
        order: Vec::new(),
    };
    let gram = &section.family.frame.gram;
    for k in 1..=D {
        let minor = match k {
            1 => gram[0][0].clone(),
            2 => gram[0][0]
                .times(&gram[1][1])
                .minus(&gram[0][1].times(&gram[1][0])),
            _ => linear::determinant(gram),
        };
        found.add(section, minor, true, "", format!("minor ${k}$"));
    }
    add_tiles(section, &mut found);
    add_boundary(section, &mut found);
    found.finish()
}

struct Found {
    places: BTreeMap<(bool, Polynomial), BTreeMap<String, Vec<String>>>,
    order: Vec<(bool, Polynomial)>,
}

impl Found {
    fn add<const D: usize>(
        &mut self,
        section: &Section<D>,
        polynomial: Polynomial,
        is_strict: bool,
        kind: &str,
        place: String,
    ) {
        if polynomial.is_zero() {
            return;
        }
        let numbers: Vec<Number> = polynomial.terms().iter().map(|(_, c)| c.clone()).collect();
        let factor = Number::from(section.numerals.primitive_factor(&numbers));
        let key = (is_strict, polynomial.map(|c| c * &factor));
        if !self.places.contains_key(&key) {
            self.order.push(key.clone());
        }
        let kinds = self.places.entry(key).or_default();
        kinds.entry(kind.to_owned()).or_default().push(place);
    }

    fn finish(mut self) -> Vec<Condition> {
        let mut conditions = Vec::new();
        for key in std::mem::take(&mut self.order) {
            let kinds = self.places.remove(&key).unwrap_or_default();
            let uses: Vec<String> = kinds
                .iter()
                .map(|(kind, places)| format!("{kind}{}", places.join(", ")))
                .collect();
            conditions.push(Condition {
                polynomial: key.1,
                is_strict: key.0,
                uses: uses.join("; "),
            });
        }
        conditions
    }
}

fn position<const D: usize>(section: &Section<D>, corner: &Corner<D>) -> [Polynomial; D] {
    let vertex = &section.family.vertices[corner.vertex.index()];
    std::array::from_fn(|k| {
        let shift = Number::from(Rational::from(corner.shift[k]));
        vertex[k].plus(&Polynomial::constant(shift))
    })
}

fn simplex<const D: usize>(section: &Section<D>, tile: SimplexId) -> Simplex<Polynomial, D> {
    let first = tile.index() * (D + 1);
    let corners: Vec<[Polynomial; D]> = section.family.corners[first..=first + D]
        .iter()
        .map(|corner| position(section, corner))
        .collect();
    Simplex::new(&corners)
}

fn add_tiles<const D: usize>(section: &Section<D>, found: &mut Found) {
    let statements = section.subject.statements();
    let is_acute = statements.contains(&Statement::Acute);
    let has_angles = is_acute || statements.contains(&Statement::Nonobtuse);
    let is_strict = statements.contains(&Statement::Delaunay);
    let has_powers = is_strict || statements.contains(&Statement::WeaklyDelaunay);
    let cogram = linear::cofactors(&section.family.frame.gram);
    let member = section.family.at(&section.family.cuboid().center());
    let matching = match_facets(&member);
    for tile in section.family.simplices() {
        let shape = simplex(section, tile);
        found.add(
            section,
            shape.determinant.clone(),
            true,
            "$\\det$ ",
            format!("$T_{{{tile}}}$"),
        );
        if has_angles {
            let products = shape.normal_products(&cogram);
            for (i, j, product) in products.pairs() {
                let edge: String = (0..=D)
                    .filter(|k| *k != i && *k != j)
                    .map(|k| k.to_string())
                    .collect();
                let kind = if D == 2 { "corners " } else { "edges " };
                let place = format!("${edge}$ of $T_{{{tile}}}$");
                found.add(section, product.negated(), is_acute, kind, place);
            }
        }
        if !has_powers {
            continue;
        }
        for i in 0..=D {
            let facet = Facet::new(tile, i);
            let (Some(apex), Some(other)) =
                (matching.apex(&member, facet), matching.neighbour(facet))
            else {
                continue;
            };
            if (other.simplex, other.opposite) < (tile, facet.opposite) {
                continue;
            }
            let origin = position(section, &section.family.corners[tile.index() * (D + 1)]);
            let offset = linear::subtract(&position(section, &apex), &origin);
            let power = shape.power(&section.family.frame.gram, &offset);
            found.add(
                section,
                power,
                is_strict,
                "power at ",
                format!("${i}$ of $T_{{{tile}}}$"),
            );
        }
    }
}

fn add_boundary<const D: usize>(section: &Section<D>, found: &mut Found) {
    let frame = &section.family.frame;
    let Some(polytope) = frame.domain.polytope() else {
        return;
    };
    let center = section.family.cuboid().center();
    for face in 0..polytope.faces.len() {
        let Some(plane) = polytope.unturned_plane(face) else {
            continue;
        };
        let inner = polytope
            .vertices
            .iter()
            .map(|v| plane.value(v).value(&center).sign())
            .find(|sign| sign.is_ne());
        let plane = if inner.is_some_and(|sign| sign.is_lt()) {
            plane.turned()
        } else {
            plane
        };
        for (v, vertex) in section.family.vertices.iter().enumerate() {
            let value = plane.value(frame.cross_section(vertex));
            found.add(
                section,
                value,
                false,
                "",
                format!("vertex ${v}$, face ${face}$"),
            );
        }
    }
}

/// The sentence on the sum of the determinants.
pub fn volume<const D: usize>(section: &Section<D>) -> String {
    let sum = section
        .family
        .simplices()
        .map(|tile| simplex(section, tile).determinant)
        .fold(Polynomial::zero(), |sum, det| sum.plus(&det));
    let others: Vec<String> = section
        .subject
        .statements()
        .iter()
        .filter(|statement| {
            matches!(
                statement,
                Statement::LargestAngle(..)
                    | Statement::SmallestAngle(..)
                    | Statement::RadiusEdge(..)
            )
        })
        .map(|statement| match statement {
            Statement::RadiusEdge(..) => "the quotients of circumradius and edge".to_owned(),
            _ => "the angles".to_owned(),
        })
        .collect::<std::collections::BTreeSet<_>>()
        .into_iter()
        .collect();
    let rest = if others.is_empty() {
        String::new()
    } else {
        format!(
            " The bounds on {} are not printed here; they rest on the check of the certificate.",
            list(&others)
        )
    };
    format!(
        "The determinants sum up to ${}$ identically, which is ${D}!$ times the volume{}.{rest}",
        section.polynomial(&sum),
        if section.family.frame.domain.polytope().is_some() {
            " of the domain for a cell of the lattice"
        } else {
            " of a cell, in cells"
        }
    )
}

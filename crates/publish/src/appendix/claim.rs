//! The statements of a claim in words, with their numbers.

use super::columns::width;
use super::numeral::Numerals;
use super::rational::{interval, rational};
use super::tex::{facet_word, sphere_word};
use acutile_core::quality::{DihedralAngle, Exact, RadiusEdge};
use acutile_core::statement::{Relation, Statement};
use malachite::Rational;

/// A statement beyond the tiling.
pub fn in_words<const D: usize>(numerals: &Numerals, statement: &Statement) -> Option<String> {
    let (angle, angles) = match D {
        2 => ("angle", "angles"),
        _ => ("dihedral angle", "dihedral angles"),
    };
    let (sphere, facet) = (sphere_word(D), facet_word(D));
    Some(match statement {
        Statement::FaceToFaceTiling => return None,
        Statement::Acute => format!("all {angles} are acute;"),
        Statement::Nonobtuse => format!("no {angle} is obtuse;"),
        Statement::LargestAngle(relation, bound) => {
            let bound = angle_text(numerals, bound);
            match relation {
                Relation::Maximum => format!("the largest {angle} is {bound};"),
                Relation::Minimum => {
                    format!("the least among the largest {angles} of the tiles is {bound};")
                }
                _ => format!("the largest {angle} of each is {} {bound};", relation.text()),
            }
        }
        Statement::SmallestAngle(relation, bound) => {
            let bound = angle_text(numerals, bound);
            match relation {
                Relation::Minimum => format!("the smallest {angle} is {bound};"),
                Relation::Maximum => {
                    format!("the greatest among the smallest {angles} of the tiles is {bound};")
                }
                _ => format!("the smallest {angle} of each is {} {bound};", relation.text()),
            }
        }
        Statement::RadiusEdge(relation, bound) => {
            let bound = ratio_text(numerals, bound);
            let quotient = "quotient of circumradius and shortest edge of a tile";
            match relation {
                Relation::Maximum => format!("the largest {quotient} is {bound};"),
                Relation::Minimum => format!("the least {quotient} is {bound};"),
                _ => format!("each {quotient} is {} {bound};", relation.text()),
            }
        }
        Statement::UncrossedPlane(plane) => {
            let plane = plane.to_string().replace('x', "x_");
            format!("no tile crosses ${plane}$ or a translate of it by the lattice;")
        }
        Statement::Delaunay => {
            format!("it is the Delaunay triangulation of its vertices: no vertex of the tiling but a tile's own corners is on its \
             {sphere}, and none is inside of it;")
        }
        Statement::WeaklyDelaunay => {
            format!("it is a Delaunay triangulation of its vertices: inside of no {sphere} is a vertex;")
        }
        Statement::LocallyDelaunay => {
            format!("at each {facet} that two tiles share, the other corner of the one is outside of the {sphere} of the other;")
        }
        Statement::LocallyWeaklyDelaunay => {
            format!("at each {facet} that two tiles share, the other corner of the one is not inside of the {sphere} of the other;")
        }
        Statement::NotDelaunay => {
            format!("it is no Delaunay triangulation of its vertices: a vertex is inside of the {sphere} of some tile;")
        }
        Statement::Tcp => "it is tetrahedrally close packed: every edge is in five or six tetrahedra, and no triangle has \
             two edges that are in six;"
            .to_owned(),
    })
}

/// An exact number with more letters gives place to a decimal enclosure.
const WIDE: usize = 30;

/// `$\arccos 1/5$`, `$60^\circ$`, or an enclosure in degrees.
fn angle_text(numerals: &Numerals, angle: &DihedralAngle) -> String {
    if let Some(degrees) = angle.rational() {
        return format!("${}^\\circ$", rational(&degrees));
    }
    let root = numerals.root(&angle.signed_square.abs());
    let sign = if angle.against_right().is_gt() {
        "-"
    } else {
        ""
    };
    if width(&root) > WIDE {
        let bounds = angle.enclosure(&Rational::from_signeds(1, 1_000_000_000));
        return format!("$\\theta^\\circ$ with $\\theta\\in{}$", interval(&bounds));
    }
    format!("$\\arccos({sign}{root})$")
}

/// The ratio, or an enclosure.
fn ratio_text(numerals: &Numerals, ratio: &RadiusEdge) -> String {
    let root = numerals.root(&ratio.square);
    if width(&root) > WIDE {
        let bounds = ratio.enclosure(&Rational::from_signeds(1, 1_000_000_000));
        return format!("some $\\sigma\\in{}$", interval(&bounds));
    }
    format!("${root}$")
}

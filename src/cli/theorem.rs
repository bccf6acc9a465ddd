//! Theorems about all members of a family: proved by a system of patches, and cited for a member.

use super::certify::CertifyArguments;
use super::output::Output;
use acutile_catalog::{self as catalog, CatalogError, Theorem as Entry, plane_file};
use acutile_core::limits::own_limits;
use acutile_core::patches::{Theorem, in_words, prove};
use acutile_core::quality::compare_with_degrees;
use acutile_core::statement::{Relation, Requirement, Statement};
use acutile_core::{format, format::patches};
use acutile_io::import::{read_text, without_comments};
use std::path::Path;

/// A theorem for an input of `certify`.
pub struct Proof {
    pub entry: &'static Entry,
    pub theorem: Theorem,
    /// The member for which the theorem is cited, in words.
    pub cited: Option<String>,
}

/// The theorem with the name `input`, or with `--cite` the one about the member `input`. `None` if
/// there is none.
///
/// # Errors
/// A message that names the input.
pub fn of_input(input: &str, arguments: &CertifyArguments) -> Option<Result<Proof, String>> {
    let named = |message: String| format!("{input}: {message}");
    if let Some(entry) = catalog::theorem(input) {
        return Some(proved(entry, None, arguments).map_err(named));
    }
    if !arguments.cite {
        return None;
    }
    let of_family = |entry: &&Entry| input.starts_with(entry.family);
    let Some(entry) = catalog::THEOREMS.iter().find(of_family) else {
        let families: Vec<&str> = catalog::THEOREMS.iter().map(|entry| entry.family).collect();
        let expected = families.join("WORD or ");
        return Some(Err(named(format!("--cite expects {expected}WORD"))));
    };
    let word = &input[entry.family.len()..];
    let member = match entry.family {
        "kagome:" => catalog::kagome_blocks(word).map(|n| format!("{n} blocks in a period")),
        _ => tiles(word),
    };
    let proof = member
        .map_err(|error| error.to_string())
        .and_then(|member| proved(entry, Some(member), arguments));
    Some(proof.map_err(named))
}

/// The tiles of a plane tiling, after it has been checked to be one.
fn tiles(word: &str) -> Result<String, CatalogError> {
    let path = Path::new(word);
    let plane = match catalog::plane_tiling::named(word) {
        Some(plane) => plane,
        None if path.exists() || word.contains(['/', '.']) => {
            let text = read_text(path).map_err(|error| CatalogError::File(error.to_string()))?;
            plane_file::parse(&without_comments(&text))?
        }
        None => catalog::plane_tiling::built_in(word)?,
    };
    let stars = plane.stars()?;
    let corners = stars.iter().flatten();
    let squares = corners.clone().filter(|corner| corner.is_square()).count() / 4;
    let triangles = corners.filter(|corner| !corner.is_square()).count() / 3;
    Ok(format!(
        "{squares} squares and {triangles} triangles in a cell, edge to edge"
    ))
}

fn proved(
    entry: &'static Entry,
    cited: Option<String>,
    arguments: &CertifyArguments,
) -> Result<Proof, String> {
    let system = (entry.system)().map_err(|error| error.to_string())?;
    let limits = arguments.limits.limits();
    let theorem = prove(&system, &limits).map_err(|error| error.to_string())?;
    let missing = arguments
        .required
        .iter()
        .find(|required| !meets(required, theorem.statements()));
    match missing {
        None => Ok(Proof {
            entry,
            theorem,
            cited,
        }),
        Some(required) => Err(format!(
            "{required} is not among the statements of the theorem {}",
            entry.name
        )),
    }
}

/// Whether the statements of a theorem imply a requirement.
fn meets(required: &Requirement, statements: &[Statement]) -> bool {
    let has = |statement| statements.contains(&statement);
    match required {
        Requirement::Tiling => true,
        Requirement::Acute => has(Statement::Acute),
        Requirement::Nonobtuse => has(Statement::Acute) || has(Statement::Nonobtuse),
        Requirement::Delaunay => has(Statement::Delaunay),
        Requirement::WeaklyDelaunay => has(Statement::Delaunay) || has(Statement::WeaklyDelaunay),
        Requirement::Tcp => has(Statement::Tcp),
        Requirement::DihedralBelow(degrees) => statements.iter().any(|statement| {
            matches!(statement, Statement::LargestAngle(Relation::Maximum, angle)
                if compare_with_degrees(angle, degrees).is_lt())
        }),
        Requirement::DihedralAbove(_)
        | Requirement::RadiusEdgeBelow(_)
        | Requirement::UncrossedPlane(_)
        | Requirement::Connected
        | Requirement::NoCavities
        | Requirement::ManifoldBoundary => false,
    }
}

/// Tells what a theorem of the catalogue is about: its tiles with their patches.
pub fn show_entry(entry: &Entry, output: &mut Output) -> Result<(), String> {
    let system = (entry.system)().map_err(|error| format!("{}: {error}", entry.name))?;
    let theorem = prove(&system, &own_limits()).map_err(|error| error.to_string())?;
    output.line(format!("{}: {}", entry.name, entry.description));
    show_certificate(entry.name, theorem.certificate(), output)
}

/// Tells what a certificate of the kind `patches` contains, without judging it.
///
/// # Errors
/// If the bytes are none.
pub fn show_certificate(name: &str, cbor: &[u8], output: &mut Output) -> Result<(), String> {
    let named = |error: &dyn std::fmt::Display| format!("{name}: {error}");
    let certificate = patches::certificate(cbor).map_err(|error| named(&error))?;
    let words = in_words(&certificate.claim).map_err(|error| named(&error))?;
    output.line(format!("a theorem: {words}"));
    let tiles = certificate.claim.tiles.iter().zip(&certificate.witness);
    for (number, (tile, patch)) in tiles.enumerate() {
        let polygons: Vec<String> = patch
            .pyramids
            .iter()
            .map(|pyramid| pyramid.polygon.len().to_string())
            .collect();
        output.line(format!(
            "tile {number}: {} sides; {} tetrahedra, {} vertices, pyramids over polygons with {} corners",
            tile.classes.len(),
            patch.simplices.len(),
            patch.vertices.len(),
            polygons.join(", ")
        ));
    }
    Ok(())
}

/// Whether a certificate in CBOR is of the kind `patches`.
pub fn is_theorem(cbor: &[u8]) -> bool {
    format::kind(cbor) == Some(patches::KIND)
}

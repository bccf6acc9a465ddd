//! Theorems about all members of a family: proved by a system of patches, and cited for a member.

use super::answer::{Answer, Written, unwritten};
use super::certify_arguments::{CertifyArguments, Takes};
use super::document::check_for_crystal;
use super::input::check_for_mesh;
use super::name::InputName;
use super::named::InputError;
use super::plane;
use super::prove::encoding;
use super::target::Target;
use acutile_catalog::{self as catalog, CatalogError, Theorem as Entry};
use acutile_core::patches::{Theorem, prove};
use acutile_core::quality::compare_with_degrees;
use acutile_core::statement::{Relation, Requirement, Statement};
use std::borrow::Cow;

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
pub fn of_input(
    input: &InputName,
    arguments: &CertifyArguments,
) -> Option<Result<Proof, InputError>> {
    let named = |message: String| InputError::from(format!("{input}: {message}"));
    if let Some(entry) = catalog::theorem(input) {
        let proof = check_options(input, arguments).map_err(InputError::from);
        return Some(proof.and_then(|()| proved(entry, None, arguments).map_err(named)));
    }
    if !arguments.cite {
        return None;
    }
    let of_family = |entry: &&Entry| input.starts_with(entry.family);
    let Some(entry) = catalog::THEOREMS.iter().find(of_family) else {
        let families: Vec<&str> = catalog::THEOREMS.iter().map(|entry| entry.family).collect();
        let expected = families.join("WORD or ");
        return Some(Err(named(format!(
            "--cite is for a member of a theorem, expected {expected}WORD"
        ))));
    };
    if let Err(message) = check_options(input, arguments) {
        return Some(Err(message.into()));
    }
    let word = &input[entry.family.len()..];
    let member = match entry.family {
        "kagome:" => catalog::kagome_blocks(word)
            .map(|n| format!("{n} blocks in a period"))
            .map_err(|error| named(error.to_string())),
        _ => tiles(input, word),
    };
    Some(member.and_then(|member| proved(entry, Some(member), arguments).map_err(named)))
}

/// No option is given that means nothing for a theorem.
fn check_options(input: &InputName, arguments: &CertifyArguments) -> Result<(), String> {
    check_for_crystal(input, &arguments.file.points)?;
    check_for_mesh(input, &arguments.file.mesh)?;
    arguments.check_for(input, Takes::default())?;
    if arguments.param.is_some() {
        Err(format!(
            "{input}: a theorem takes no parameter, expected no --param"
        ))
    } else {
        Ok(())
    }
}

/// The tiles of a plane tiling, after it has been checked to be one.
fn tiles(input: &InputName, word: &str) -> Result<String, InputError> {
    let named = |error: CatalogError| InputError::from(format!("{input}: {error}"));
    let plane = match catalog::plane_tiling::named(word) {
        Some(plane) => plane,
        None => match plane::of_file(input)? {
            Some(plane) => plane,
            None => catalog::plane_tiling::built_in(word).map_err(named)?,
        },
    };
    let stars = plane.stars().map_err(named)?;
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
        | Requirement::NotDelaunay
        | Requirement::Connected
        | Requirement::NoCavities
        | Requirement::ManifoldBoundary => false,
    }
}

/// A theorem, with its own certificate; a member gets a note that says so.
pub fn answer(
    proof: Proof,
    target: &Target,
    arguments: &CertifyArguments,
    notes: &mut Vec<String>,
) -> Answer {
    if let Some(member) = &proof.cited {
        notes.push(format!(
            "proved by citing the theorem {}, whose certificate this is: the input has {member}",
            proof.entry.name
        ));
    }
    let cbor = proof.theorem.certificate().to_vec();
    let bytes = encoding(target, arguments).encode(&cbor);
    match bytes.map(Cow::into_owned) {
        Ok(bytes) => Answer::Proved {
            verified: proof.theorem.into_verified(),
            certificate: Written::Bytes(bytes),
        },
        Err(error) => unwritten(target, &error),
    }
}

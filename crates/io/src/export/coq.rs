//! A certificate as a file for Coq that ends in its claim, a theorem about real space or the real plane.
//!
//! The file contains the certificate's own bytes, and its claim as a term of `Denote.v`. Coq's kernel
//! runs the checker of `Bytes.v`, which is proved sound. So nothing here is trusted: the theorem is
//! about the bytes and the claim that the file shows, and a mistake makes `coqc` fail.

use acutile_core::format::family::{End, FamilyClaim, Parameter, Term, Value};
use acutile_core::format::patches;
use acutile_core::format::{
    self, Claim, Cosine, Domain, Field, Fraction, Number, Polytope, Relation, Statement,
};
use malachite::Integer;

/// The SHA-256 of the files that define the words of the theorem, as `sha256sum` prints them.
const STATEMENT_FILES: &str = include_str!("statements.sha256");

/// Bytes on one line. Coq's parser needs stack in proportion to the longest list.
const BYTES_PER_LINE: usize = 64;

/// The file for a certificate of any kind.
///
/// # Errors
/// The bytes are no certificate.
pub fn coq_file(cbor: &[u8]) -> Result<String, String> {
    if format::kind(cbor) == Some(format::FAMILY) {
        let certificate = format::family::certificate(cbor).map_err(|error| error.to_string())?;
        return Ok(coq_family_theorem(cbor, &certificate.claim));
    }
    if format::kind(cbor) == Some(patches::KIND) {
        let certificate = patches::certificate(cbor).map_err(|error| error.to_string())?;
        return Ok(coq_patches_theorem(cbor, &certificate.claim));
    }
    let certificate = format::read::certificate(cbor).map_err(|error| error.to_string())?;
    Ok(coq_theorem(cbor, &certificate.claim))
}

/// The file for the certificate with these bytes and this claim, whether or not it is true.
pub fn coq_theorem(certificate: &[u8], claim: &Claim) -> String {
    let members = claim_members(claim);
    theorem(certificate, "", &format!("OfTiling {members}"))
}

/// The file for a certificate of the kind `family`, as [`coq_theorem`].
pub fn coq_family_theorem(certificate: &[u8], claim: &FamilyClaim) -> String {
    let parameters = list(&claim.parameters, parameter);
    let members = claim_members(&claim.claim);
    theorem(
        certificate,
        "String ",
        &format!("OfFamily {parameters}\n  {members}"),
    )
}

/// The file for a certificate of the kind `patches`, as [`coq_theorem`].
pub fn coq_patches_theorem(certificate: &[u8], claim: &patches::Claim) -> String {
    let tile = |tile: &patches::Tile| {
        format!(
            "(Polygon {} {} {})",
            integer(&tile.denominator),
            points(&tile.vertices),
            list(&tile.classes, |class| integer(&Integer::from(*class)))
        )
    };
    let members = format!(
        "OfPatches (PatchesClaim\n  {}\n  {}\n  {}\n  {}\n  {})",
        field(&claim.field),
        points(&claim.gram),
        claim.rank,
        list(&claim.tiles, tile),
        list(&claim.statements, statement),
    );
    theorem(certificate, "", &members)
}

/// Names are texts, which need the library `String`. It is imported before `List`, whose `length` and
/// `concat` then have these short names.
fn theorem(certificate: &[u8], strings: &str, claim: &str) -> String {
    let lines = certificate.chunks(BYTES_PER_LINE);
    let bytes: Vec<String> = lines
        .map(|line| list(line, |b| format!("x{b:02x}")))
        .collect();
    format!(
        "(* The claim of an acutile certificate, as a theorem about real space or the real plane.\n   \
         [certificate] is the certificate: its CBOR, byte by byte. [claimed] is its claim.\n   \
         Denote.v defines certificates and the meaning of claims, in the words of the five\n   \
         statement files. The SHA-256 of these files:\n{}   Bytes.v is not imported, so it cannot change how the theorem is read.\n   \
         The last line prints the axioms. *)\n\
         From Coq Require Import {}List NArith ZArith.\nFrom Coq Require Import Init.Byte.\n\
         From Acutile Require Import Statement Denote.\nFrom Acutile Require Bytes.\nImport ListNotations.\nLocal Open Scope Z_scope.\n\n\
         Definition certificate : bytes := concat [\n{}].\n\n\
         Definition claimed : claim := {}.\n\n\
         Lemma checked : Acutile.Bytes.accepts certificate = Some claimed.\n\
         Proof. vm_cast_no_check (eq_refl (Some claimed)). Qed.\n\n\
         Theorem claim : exists c, certificate = print c /\\ claim_of c = claimed /\\ shows c /\\ meaning claimed.\n\
         Proof. exact (Acutile.Bytes.accepted certificate claimed checked). Qed.\n\
         Print Assumptions claim.\n",
        indented(STATEMENT_FILES),
        strings,
        bytes.join(";\n"),
        claim,
    )
}

fn indented(lines: &str) -> String {
    lines.lines().map(|line| format!("     {line}\n")).collect()
}

fn list<T>(items: &[T], term: impl Fn(&T) -> String) -> String {
    let terms: Vec<String> = items.iter().map(term).collect();
    format!("[{}]", terms.join(";"))
}

/// A term of type `tiling_claim`.
fn claim_members<V: Numeric>(claim: &Claim<V>) -> String {
    format!(
        "(TilingClaim {}\n  {}\n  {}\n  {}\n  {})",
        claim.dimension,
        field(&claim.field),
        points(&claim.gram),
        domain(&claim.domain),
        list(&claim.statements, statement),
    )
}

/// An integer, in parentheses if it is negative.
fn integer(value: &Integer) -> String {
    if *value < 0 {
        format!("({value})")
    } else {
        value.to_string()
    }
}

fn coefficients(value: &Number) -> String {
    list(&value.0, integer)
}

/// A number of a certificate as a term of Coq's type `number`.
trait Numeric {
    fn number(&self) -> String;
}

impl Numeric for Number {
    fn number(&self) -> String {
        format!("Plain {}", coefficients(self))
    }
}

impl Numeric for Value {
    fn number(&self) -> String {
        let term = |term: &Term| {
            let exponents = list(&term.exponents, u8::to_string);
            format!("({},{exponents}%N)", coefficients(&term.coefficient))
        };
        format!("Polynomial {}", list(&self.0, term))
    }
}

fn points<V: Numeric>(rows: &[Vec<V>]) -> String {
    list(rows, |row| list(row, V::number))
}

fn parameter(parameter: &Parameter) -> String {
    let Parameter { name, low, high } = parameter;
    format!("Range \"{name}\"%string {} {}", end(low), end(high))
}

fn end(end: &End) -> String {
    let is_closed = !end.is_open;
    let numerator = coefficients(&end.value.numerator);
    let divisor = integer(&end.value.denominator);
    format!("(Limit {is_closed} {numerator} {divisor})")
}

fn field(field: &Field) -> String {
    match field {
        Field::Rationals => "Rationals".to_owned(),
        Field::Algebraic(root) => format!(
            "(Root {} {} {} {})",
            list(&root.polynomial, integer),
            integer(&root.low),
            integer(&root.high),
            integer(&root.denominator)
        ),
    }
}

fn domain<V: Numeric>(domain: &Domain<V>) -> String {
    match domain {
        Domain::Space => "Space".to_owned(),
        Domain::Slab(polytope) => format!("(Slab {})", polytope_term(polytope)),
        Domain::Prism(polytope) => format!("(Prism {})", polytope_term(polytope)),
        Domain::Solid(polytope) => format!("(Solid {})", polytope_term(polytope)),
        Domain::Region(rank) => format!("(Region {rank})"),
    }
}

fn polytope_term<V: Numeric>(polytope: &Polytope<V>) -> String {
    let face = |face: &Vec<u32>| list(face, |i| format!("{i}%N"));
    format!(
        "(Polytope {} {} {})",
        integer(&polytope.denominator),
        points(&polytope.vertices),
        list(&polytope.faces, face)
    )
}

fn statement(statement: &Statement) -> String {
    match statement {
        Statement::FaceToFaceTiling => "FaceToFaceTiling".to_owned(),
        Statement::Acute => "IsAcute".to_owned(),
        Statement::Nonobtuse => "IsNonobtuse".to_owned(),
        Statement::LargestAngle(relation, cosine) => angle("LargestAngle", *relation, cosine),
        Statement::SmallestAngle(relation, cosine) => angle("SmallestAngle", *relation, cosine),
        Statement::SquaredRatio(relation, bound) => {
            format!(
                "SquaredRatio {} {}",
                relation_term(*relation),
                fraction(bound)
            )
        }
        Statement::UncrossedPlane(plane) => format!(
            "UncrossedPlane {} {} {}",
            list(&plane.normal, |c| integer(&Integer::from(*c))),
            integer(&plane.offset),
            integer(&plane.denominator)
        ),
        Statement::Delaunay => "IsDelaunay".to_owned(),
        Statement::WeaklyDelaunay => "IsWeaklyDelaunay".to_owned(),
        Statement::LocallyDelaunay => "IsLocallyDelaunay".to_owned(),
        Statement::LocallyWeaklyDelaunay => "IsLocallyWeaklyDelaunay".to_owned(),
        Statement::NotDelaunay => "IsNotDelaunay".to_owned(),
        Statement::Tcp => "IsTCP".to_owned(),
    }
}

fn angle(quantity: &str, relation: Relation, cosine: &Cosine) -> String {
    let sign = integer(&Integer::from(cosine.sign));
    let square = fraction(&cosine.square);
    format!("{quantity} {} {sign} {square}", relation_term(relation))
}

/// Numerator and denominator.
fn fraction(fraction: &Fraction) -> String {
    let numerator = fraction.numerator.number();
    format!("({numerator}) {}", integer(&fraction.denominator))
}

fn relation_term(relation: Relation) -> &'static str {
    match relation {
        Relation::LessThan => "LessThan",
        Relation::AtMost => "AtMost",
        Relation::Maximum => "Maximum",
        Relation::MoreThan => "MoreThan",
        Relation::AtLeast => "AtLeast",
        Relation::Minimum => "Minimum",
    }
}

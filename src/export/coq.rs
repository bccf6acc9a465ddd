//! A certificate as a file for Coq that ends in its claim, a theorem about real three-space.
//!
//! The file holds the certificate's integers, denominators cleared, states the
//! claim with the words of proofs/theories/Statement.v and the claim's numbers, and
//! lets Coq's kernel run the checker of proofs/theories/Checker.v, which is proved
//! sound. So nothing here is trusted: a mistake makes `coqc` fail, or state
//! something else in plain sight. Called by `acutile export --coq`.

use crate::certificate::{
    AlgebraicField, Certificate, Domain, Field, Mate, Number, Place, Statement,
};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::Ratio;
use num_traits::{One, Signed, Zero};
use std::fmt::{self, Write};

type BigRational = Ratio<BigInt>;

/// Why a certificate has no such file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NotATheorem {
    /// The development treats dimension 3 only.
    Dimension(usize),
    /// The exported theorem is about all of space only.
    Domain,
    /// A text that is not a rational number, or a list of the wrong length.
    Malformed(String),
}

impl fmt::Display for NotATheorem {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            NotATheorem::Dimension(d) => {
                write!(f, "the Coq development is about dimension 3, not {d}")
            }
            NotATheorem::Domain => f.write_str("the Coq export is about tilings of space only"),
            NotATheorem::Malformed(what) => write!(f, "not a certificate: {what}"),
        }
    }
}

impl std::error::Error for NotATheorem {}

/// The file for `certificate`, whether or not its claim is true. Statements that the
/// development does not treat are left out and named in a comment.
pub fn coq_theorem(certificate: &Certificate) -> Result<String, NotATheorem> {
    let claim = &certificate.claim;
    if claim.dimension != 3 {
        return Err(NotATheorem::Dimension(claim.dimension));
    }
    if claim.domain != Domain::Space {
        return Err(NotATheorem::Domain);
    }
    let field = RootOf::new(&claim.field)?;
    let mut text = HEAD.to_owned() + &untreated(certificate);
    text += &data(certificate, field.is_some())?;
    text += &match field {
        None => over_the_rationals(certificate)?,
        Some(root) => over_a_field(certificate, &root)?,
    };
    Ok(text)
}

const HEAD: &str = "\
(* The claim of an acutile certificate, as a theorem about real three-space. The
   words are defined in Statement.v; the last line prints the axioms. *)
From Coq Require Import Reals ZArith List Lra.
From Acutile Require Import Statement Checker Soundness Numbers.
Import ListNotations.
Local Open Scope Z_scope.

";

/// The certificate's integers as a term of type `cert`.
fn data(certificate: &Certificate, algebraic: bool) -> Result<String, NotATheorem> {
    let (claim, witness) = (&certificate.claim, &certificate.witness);
    let (vertices, den) = cleared(&witness.vertices, algebraic)?;
    let (gram, gram_den) = cleared(&claim.gram, algebraic)?;
    let ring = if algebraic { "list Z" } else { "Z" };
    let vertices: Vec<String> = vertices
        .iter()
        .map(|x| match x.as_slice() {
            [x, y, z] => Ok(format!("V3 _ {x} {y} {z}")),
            _ => Err(NotATheorem::Malformed("a vertex".to_owned())),
        })
        .collect::<Result<_, _>>()?;
    let rows = witness.simplices.iter().zip(&witness.mates);
    let simplices: Vec<String> = rows.map(|(s, m)| simplex(s, m)).collect::<Result<_, _>>()?;
    if gram.len() != 3
        || gram.iter().any(|row| row.len() != 3)
        || witness.mates.len() != witness.simplices.len()
    {
        return Err(NotATheorem::Malformed(
            "the Gram matrix, or the mates".to_owned(),
        ));
    }
    let g = |i: usize, j: usize| &gram[i][j];
    let mut text = format!(
        "(* {den} times the coordinates of the vertices, in the basis. *)\n\
         Definition verts : list (v3 ({ring})) := [\n  {}].\n\n\
         (* Four corners (vertex, lattice vector), four mates (simplex, facet, lattice vector). *)\n\
         Definition tets : list ctet := [\n  {}].\n\n",
        vertices.join(";\n  "),
        simplices.join(";\n  ")
    );
    let entries = [g(0, 0), g(1, 1), g(2, 2), g(0, 1), g(0, 2), g(1, 2)].map(String::as_str);
    let _ = write!(
        text,
        "Definition c : cert ({ring}) :=\n  Cert _ {den} verts tets {gram_den} (KG _ {}) 3 [] (ByVolume _).\n\
         Definition statements : list statement := [{}].\n\n",
        entries.join(" "),
        claimed(certificate, |_| String::new())?.0.join("; ")
    );
    Ok(text)
}

/// m T with the least positive integer m that makes it integral, as Coq terms, and m.
fn cleared(
    table: &[Vec<Number>],
    algebraic: bool,
) -> Result<(Vec<Vec<String>>, BigInt), NotATheorem> {
    let mut numbers = Vec::new();
    for row in table {
        numbers.push(
            row.iter()
                .map(coefficients)
                .collect::<Result<Vec<_>, _>>()?,
        );
    }
    let all = numbers.iter().flatten().flatten();
    let common = all.fold(BigInt::one(), |m, c| m.lcm(c.denom()));
    let term = |cs: &Vec<BigRational>| {
        let integers: Vec<String> = cs
            .iter()
            .map(|c| integer(&(c.numer() * (&common / c.denom()))))
            .collect();
        match algebraic {
            true => format!("[{}]", integers.join(";")),
            false => integers.join(" "),
        }
    };
    let rows = numbers
        .iter()
        .map(|row| row.iter().map(term).collect())
        .collect();
    Ok((rows, common))
}

fn coefficients(number: &Number) -> Result<Vec<BigRational>, NotATheorem> {
    number.0.iter().map(|text| rational(text)).collect()
}

fn rational(text: &str) -> Result<BigRational, NotATheorem> {
    let zero_denominator = text
        .split_once('/')
        .is_some_and(|(_, q)| q.trim_start_matches('0').is_empty());
    match text.parse() {
        Ok(value) if !zero_denominator => Ok(value),
        _ => Err(NotATheorem::Malformed(format!("the number {text:?}"))),
    }
}

fn integer(value: &BigInt) -> String {
    match value.is_negative() {
        true => format!("({value})"),
        false => value.to_string(),
    }
}

fn simplex(corners: &[Place], mates: &[Mate]) -> Result<String, NotATheorem> {
    let wrong = || NotATheorem::Malformed("a simplex or its mates".to_owned());
    if corners.len() != 4 || mates.len() != 4 {
        return Err(wrong());
    }
    let mut text = "CT".to_owned();
    for Place(place) in corners {
        let [v, x, y, z] = place.as_slice() else {
            return Err(wrong());
        };
        let _ = write!(text, " ({v}%N,({x},{y},{z}))");
    }
    for Mate(mate) in mates {
        let [t, j, x, y, z] = mate.as_slice() else {
            return Err(wrong());
        };
        let _ = write!(text, " (Some ({t}%N,{j}%N,({x},{y},{z})))");
    }
    Ok(text)
}

/// The statements of which the development says nothing. They are left out of the
/// theorem, and the file says so.
fn untreated(certificate: &Certificate) -> String {
    let names = certificate.claim.statements.iter().filter_map(|s| match s {
        Statement::DihedralAbove(_) => Some("all dihedral angles above"),
        Statement::RadiusEdgeBelow(_) => Some("all radius-edge ratios below"),
        Statement::Tcp => Some("TCP"),
        _ => None,
    });
    match names.collect::<Vec<_>>().as_slice() {
        [] => String::new(),
        names => format!(
            "(* NOT PART OF THIS THEOREM, though claimed: {}. *)\n\n",
            names.join(", ")
        ),
    }
}

/// The statements but the first, as terms of type `statement` and as propositions
/// about the simplices `of`.
fn claimed(
    certificate: &Certificate,
    about: impl Fn(&str) -> String,
) -> Result<(Vec<String>, Vec<String>), NotATheorem> {
    let (mut terms, mut propositions) = (Vec::new(), Vec::new());
    for statement in &certificate.claim.statements {
        let (term, proposition) = match statement {
            Statement::FaceToFaceTiling => continue,
            Statement::Acute => ("Acute".to_owned(), about("acute")),
            Statement::Nonobtuse => ("Nonobtuse".to_owned(), about("nonobtuse")),
            Statement::DihedralBelow(degrees) => {
                let q = rational(degrees)?;
                let (p, q) = (integer(q.numer()), integer(q.denom()));
                (
                    format!("DihedralBelow {p} {q}"),
                    format!("{} ({p} / {q})", about("dihedral_below")),
                )
            }
            Statement::Delaunay => ("Delaunay".to_owned(), about("delaunay")),
            Statement::WeaklyDelaunay => ("WeaklyDelaunay".to_owned(), about("weakly_delaunay")),
            Statement::DihedralAbove(_) | Statement::RadiusEdgeBelow(_) | Statement::Tcp => {
                continue;
            }
        };
        terms.push(term);
        propositions.push(proposition);
    }
    Ok((terms, propositions))
}

/// "l1, l2, l3 have the Gram matrix, and for all such the statements hold".
fn conclusion(
    certificate: &Certificate,
    gram: &str,
    tetrahedra: &str,
) -> Result<String, NotATheorem> {
    let n = certificate.witness.simplices.len();
    let about = |word: &str| format!("{word} l1 l2 l3 3 {n} ({tetrahedra} l1 l2 l3)");
    let (_, propositions) = claimed(certificate, about)?;
    let mut text = format!(
        "(exists l1 l2 l3, has_gram {gram} l1 l2 l3) /\\\n  \
         forall l1 l2 l3, has_gram {gram} l1 l2 l3 ->\n    \
         face_to_face_tiling l1 l2 l3 3 (domain l1 l2 l3 []) {n} ({tetrahedra} l1 l2 l3)"
    );
    for proposition in propositions {
        let _ = write!(text, " /\\\n    {proposition}");
    }
    Ok(text + ".\n")
}

/// The end of both proofs: the k-th statement by its place in the list.
fn last_steps(statements: usize) -> String {
    let mut text = "  intros l1 l2 l3 L. destruct (T l1 l2 l3 L) as [T1 T2].\n".to_owned();
    let mut place = "(or_introl eq_refl)".to_owned();
    let mut proof = "T1".to_owned();
    let others = statements;
    for _ in 0..others {
        let _ = writeln!(text, "  split; [exact {proof}|].");
        proof = format!("(T2 _ {place})");
        place = format!("(or_intror {place})");
    }
    text + &format!("  exact {proof}.\nQed.\nPrint Assumptions claim.\n")
}

fn gram(certificate: &Certificate) -> Result<String, NotATheorem> {
    let mut entries = Vec::new();
    for (i, j) in [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)] {
        entries.push(real(&coefficients(&certificate.claim.gram[i][j])?, "a"));
    }
    Ok(format!("Gram {}", entries.join(" ")))
}

/// c_0 + a (c_1 + a (…)) over the real numbers.
fn real(coefficients: &[BigRational], a: &str) -> String {
    let fraction = |c: &BigRational| match c.is_integer() {
        true => integer(c.numer()),
        false => format!("({} / {})", integer(c.numer()), c.denom()),
    };
    match coefficients {
        [] => "0".to_owned(),
        [c] => fraction(c),
        [c, rest @ ..] => format!("({} + {a} * {})", fraction(c), real(rest, a)),
    }
}

const SAME_GRAM: &str = "unfold dgram, c; cbn [Checker.c_gram Checker.c_gden Checker.k11 Checker.k22 Checker.k33 Checker.k12 Checker.k13 Checker.k23 ev]; unfold G; f_equal; field";

fn over_the_rationals(certificate: &Certificate) -> Result<String, NotATheorem> {
    Ok(format!(
        "Local Open Scope R_scope.\nDefinition G : gram := {}.\n\
         (* Corner (v, n) is the point with the coordinates of vertex v, plus n, in the basis. *)\n\
         Definition tetrahedra : point -> point -> point -> nat -> tetrahedron := dtet Z idZ IZR c.\n\n\
         Theorem claim :\n  {}\
         Proof.\n  assert (E : dgram Z IZR c = G) by ({SAME_GRAM}).\n  \
         assert (K : zcheck c statements = true) by (vm_cast_no_check (eq_refl true)).\n  \
         destruct (z_theorem c statements K) as [B T]. rewrite E in B, T.\n  split; [exact B|].\n{}",
        gram(certificate)?,
        conclusion(certificate, "G", "tetrahedra")?,
        last_steps(claimed(certificate, str::to_owned)?.0.len())
    ))
}

fn over_a_field(certificate: &Certificate, root: &RootOf) -> Result<String, NotATheorem> {
    let polynomial: Vec<BigRational> = root
        .polynomial
        .iter()
        .cloned()
        .map(BigRational::from_integer)
        .collect();
    let between = |x: &str| {
        format!(
            "{} <= {x} <= {}",
            real(std::slice::from_ref(&root.low), x),
            real(std::slice::from_ref(&root.high), x)
        )
    };
    let ladder = root.ladder();
    let terms: Vec<String> = ladder.iter().map(Enclosure::term).collect();
    let (finest, coarse) = terms
        .split_last()
        .ok_or_else(|| NotATheorem::Malformed("the root".to_owned()))?;
    let low_terms: Vec<String> = root.polynomial[..root.polynomial.len() - 1]
        .iter()
        .map(integer)
        .collect();
    Ok(format!(
        "(* The lower coefficients of the polynomial, the interval of the claim, and enclosures. *)\n\
         Definition fl : list Z := [{}].\nDefinition interval := {}.\n\
         Definition es : list encl := [{}].\nDefinition e0 := {finest}.\n\n\
         Local Open Scope R_scope.\nDefinition p (x : R) : R := {}.\nDefinition G (a : R) : gram := {}.\n\
         (* Corner (v, n) is the point with the coordinates of vertex v, plus n, in the basis. *)\n\
         Definition tetrahedra (a : R) : point -> point -> point -> nat -> tetrahedron := dtet (list Z) lofZ (ev a) c.\n\n\
         Theorem claim : exists a : R, p a = 0 /\\ {} /\\ (forall x, p x = 0 -> {} -> x = a) /\\\n  {}\
         Proof.\n  assert (K1 : isolated fl e0 es interval = true) by (vm_cast_no_check (eq_refl true)).\n  \
         assert (K2 : nfcheck fl e0 es c statements = true) by (vm_cast_no_check (eq_refl true)).\n  \
         destruct (nf_theorem fl e0 es interval c statements K1 K2) as [a [A1 [A2 [A3 [B T]]]]].\n  \
         assert (P : forall x, ev x (fl ++ [1%Z]) = p x) by (intros; unfold p, fl; cbn [app ev]; ring).\n  \
         assert (I : forall x, in_claimed interval x <-> {}) by (intros; unfold in_claimed, interval; cbn [e_lo e_hi e_S]; lra).\n  \
         assert (E : dgram (list Z) (ev a) c = G a) by ({SAME_GRAM}).\n  rewrite E in B, T. rewrite P in A1. exists a.\n  \
         split; [exact A1|]. split; [apply I; exact A2|].\n  \
         split; [intros x X1 X2; apply A3; [rewrite P; exact X1 | apply I; exact X2]|]. split; [exact B|].\n{}",
        low_terms.join(";"),
        root.enclosure().term(),
        coarse.join("; "),
        real(&polynomial, "x"),
        gram(certificate)?,
        between("a"),
        between("x"),
        conclusion(certificate, "(G a)", "tetrahedra a")?,
        between("x"),
        last_steps(claimed(certificate, str::to_owned)?.0.len())
    ))
}

/// The field's polynomial, constant term first, and the interval of its root.
struct RootOf {
    polynomial: Vec<BigInt>,
    low: BigRational,
    high: BigRational,
}

/// The root lies in [low, high] / scale.
#[derive(Clone)]
struct Enclosure {
    low: BigInt,
    high: BigInt,
    scale: BigInt,
}

impl Enclosure {
    fn term(&self) -> String {
        format!(
            "Encl {} {} {}",
            integer(&self.low),
            integer(&self.high),
            self.scale
        )
    }
}

impl RootOf {
    fn new(field: &Field) -> Result<Option<RootOf>, NotATheorem> {
        let Field::Algebraic(AlgebraicField { polynomial, root }) = field else {
            return Ok(None);
        };
        let coefficients = polynomial
            .iter()
            .map(|c| rational(c))
            .collect::<Result<Vec<_>, _>>()?;
        if coefficients.len() < 3 || coefficients.iter().any(|c| !c.is_integer()) {
            return Err(NotATheorem::Malformed("the polynomial".to_owned()));
        }
        let polynomial = coefficients.iter().map(BigRational::to_integer).collect();
        let (low, high) = (rational(&root.0)?, rational(&root.1)?);
        Ok(Some(RootOf {
            polynomial,
            low,
            high,
        }))
    }

    fn enclosure(&self) -> Enclosure {
        Enclosure {
            low: self.low.numer() * self.high.denom(),
            high: self.high.numer() * self.low.denom(),
            scale: self.low.denom() * self.high.denom(),
        }
    }

    /// Enclosures after 32, 64, …, 512 halvings: coarse ones are cheap and mostly do.
    fn ladder(&self) -> Vec<Enclosure> {
        let mut at = self.enclosure();
        let right = self.sign(&at.high, &at.scale);
        let mut ladder = Vec::new();
        for step in 1..=512u32 {
            let middle = &at.low + &at.high;
            at = Enclosure {
                low: at.low * 2,
                high: at.high * 2,
                scale: at.scale * 2,
            };
            let sign = self.sign(&middle, &at.scale);
            if sign.is_zero() || sign != right {
                at.low = middle.clone();
            }
            if sign.is_zero() || sign == right {
                at.high = middle;
            }
            if step >= 32 && step.is_power_of_two() {
                ladder.push(at.clone());
            }
        }
        ladder
    }

    /// The sign of the polynomial at x / scale, for scale > 0.
    fn sign(&self, x: &BigInt, scale: &BigInt) -> BigInt {
        let mut power = BigInt::one();
        let mut value = BigInt::zero();
        for c in self.polynomial.iter().rev() {
            value = value * x + c * &power;
            power *= scale;
        }
        value.signum()
    }
}

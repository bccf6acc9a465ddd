//! The theorem itself: the claim in the words of Statement.v, and the proof by the checker.

use super::NotATheorem;
use super::numbers::{coefficients, integer, rational, real, table};
use super::root::{Enclosure, RootOf};
use crate::certificate::{Certificate, Statement};
use std::fmt::Write;

/// The theorem over the rational numbers.
pub(super) fn over_the_rationals(certificate: &Certificate) -> Result<String, NotATheorem> {
    let conclusion = conclusion(certificate, "G", "W", "tetrahedra")?;
    Ok(format!(
        "{}Local Open Scope R_scope.\nDefinition G : gram := {}.\n\
         Definition W : list point := {}.\n\
         {CORNERS}Definition tetrahedra : point -> point -> point -> nat -> tetrahedron := dtet Z idZ IZR c.\n\n\
         Theorem claim :\n  {conclusion}\
         Proof.\n  assert (E : dgram Z IZR c = G) by ({}).\n  \
         assert (D : map (dpoint Z IZR c) (c_polytope Z c) = W) by ({}).\n  \
         assert (K : zcheck c statements = true) by (vm_cast_no_check (eq_refl true)).\n  \
         destruct (z_theorem c statements K) as [B T]. unfold ddomain in T. rewrite E, D in *.\n  split; [exact B|].\n{}",
        statements(certificate)?,
        gram(certificate)?,
        polytope(certificate)?,
        same_gram("zcert", "G"),
        same_polytope("zcert", "W"),
        last_steps(terms(certificate)?.len())
    ))
}

/// The theorem over Q(a): there is one root in the interval, and it is the a of the claim.
pub(super) fn over_a_field(
    certificate: &Certificate,
    root: &RootOf,
) -> Result<String, NotATheorem> {
    let between = |x: &str| {
        let end = |e| real(std::slice::from_ref(e), x);
        format!("{} <= {x} <= {}", end(&root.low), end(&root.high))
    };
    let conclusion = conclusion(certificate, "(G a)", "(W a)", "tetrahedra a")?;
    Ok(format!(
        "{}Local Open Scope R_scope.\nDefinition p (x : R) : R := {}.\nDefinition G (a : R) : gram := {}.\n\
         Definition W (a : R) : list point := {}.\n\
         {CORNERS}Definition tetrahedra (a : R) : point -> point -> point -> nat -> tetrahedron := dtet (list Z) lofZ (ev a) c.\n\n\
         Theorem claim : exists a : R, p a = 0 /\\ {} /\\ (forall x, p x = 0 -> {} -> x = a) /\\\n  {conclusion}\
         Proof.\n  assert (K1 : isolated fl e0 es interval = true) by (vm_cast_no_check (eq_refl true)).\n  \
         assert (K2 : nfcheck fl e0 es c statements = true) by (vm_cast_no_check (eq_refl true)).\n  \
         destruct (nf_theorem fl e0 es interval c statements K1 K2) as [a [A1 [A2 [A3 [B T]]]]].\n  \
         assert (P : forall x, ev x (fl ++ [1%Z]) = p x) by (intros; unfold p, fl; cbn [app ev]; ring).\n  \
         assert (I : forall x, in_claimed interval x <-> {}) by (intros; unfold in_claimed, interval; cbn [e_lo e_hi e_S]; lra).\n  \
         assert (E : dgram (list Z) (ev a) c = G a) by ({}).\n  \
         assert (D : map (dpoint (list Z) (ev a) c) (c_polytope (list Z) c) = W a) by ({}).\n  \
         unfold ddomain in T. rewrite E, D in *. rewrite P in A1. exists a.\n  \
         split; [exact A1|]. split; [apply I; exact A2|].\n  \
         split; [intros x X1 X2; apply A3; [rewrite P; exact X1 | apply I; exact X2]|]. split; [exact B|].\n{}",
        statements(certificate)?,
        real(&root.rational_polynomial(), "x"),
        gram(certificate)?,
        polytope(certificate)?,
        between("a"),
        between("x"),
        between("x"),
        same_gram("nfcert", "G"),
        same_polytope("nfcert", "W"),
        last_steps(terms(certificate)?.len())
    ))
}

/// The field's polynomial, the interval of the claim, and enclosures of the root.
pub(super) fn field(root: &RootOf) -> Result<String, NotATheorem> {
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
         Definition es : list encl := [{}].\nDefinition e0 := {finest}.\n\n",
        low_terms.join(";"),
        root.enclosure().term(),
        coarse.join("; "),
    ))
}

const CORNERS: &str =
    "(* Corner (v, n) is the point with the coordinates of vertex v, plus n, in the basis. *)\n";

/// A statement but the first: its term of type `statement`, and its proposition but for the tiling.
fn named(statement: &Statement) -> Result<Option<(String, String)>, NotATheorem> {
    let plain = |term: &str, word: &str| Ok(Some((term.to_owned(), format!("{word} @"))));
    let bounded = |term: &str, word: &str, bound: &str| {
        let bound = rational(bound)?;
        let (p, q) = (integer(bound.numer()), integer(bound.denom()));
        Ok(Some((
            format!("{term} {p} {q}"),
            format!("{word} @ ({p} / {q})"),
        )))
    };
    match statement {
        Statement::FaceToFaceTiling => Ok(None),
        Statement::Acute => plain("Acute", "acute"),
        Statement::Nonobtuse => plain("Nonobtuse", "nonobtuse"),
        Statement::DihedralBelow(q) => bounded("DihedralBelow", "dihedral_below", q),
        Statement::DihedralAbove(q) => bounded("DihedralAbove", "dihedral_above", q),
        Statement::RadiusEdgeBelow(q) => bounded("RadiusEdgeBelow", "radius_edge_below", q),
        Statement::Delaunay => plain("Delaunay", "delaunay"),
        Statement::WeaklyDelaunay => plain("WeaklyDelaunay", "weakly_delaunay"),
        Statement::Tcp => plain("TCP", "tcp"),
    }
}

fn all_named(certificate: &Certificate) -> Result<Vec<(String, String)>, NotATheorem> {
    let statements = certificate.claim.statements.iter();
    statements.filter_map(|s| named(s).transpose()).collect()
}

fn terms(certificate: &Certificate) -> Result<Vec<String>, NotATheorem> {
    Ok(all_named(certificate)?
        .into_iter()
        .map(|(t, _)| t)
        .collect())
}

fn statements(certificate: &Certificate) -> Result<String, NotATheorem> {
    Ok(format!(
        "Definition statements : list statement := [{}].\n\n",
        terms(certificate)?.join("; ")
    ))
}

/// "l1, l2, l3 have the Gram matrix, and for all such the statements hold".
fn conclusion(
    certificate: &Certificate,
    gram: &str,
    polytope: &str,
    tetrahedra: &str,
) -> Result<String, NotATheorem> {
    let n = certificate.witness.simplices.len();
    let r = certificate.claim.domain.rank(3);
    let of = format!("l1 l2 l3 {r} {n} ({tetrahedra} l1 l2 l3)");
    let mut text = format!(
        "(exists l1 l2 l3, has_gram {gram} l1 l2 l3) /\\\n  \
         forall l1 l2 l3, has_gram {gram} l1 l2 l3 ->\n    \
         face_to_face_tiling l1 l2 l3 {r} (domain l1 l2 l3 {r} {polytope}) {n} ({tetrahedra} l1 l2 l3)"
    );
    for (_, proposition) in all_named(certificate)? {
        let _ = write!(text, " /\\\n    {}", proposition.replace('@', &of));
    }
    Ok(text + ".\n")
}

/// The end of both proofs: the k-th statement by its place in the list.
fn last_steps(statements: usize) -> String {
    let mut text = "  intros l1 l2 l3 L. destruct (T l1 l2 l3 L) as [T1 T2].\n".to_owned();
    let mut place = "(or_introl eq_refl)".to_owned();
    let mut proof = "T1".to_owned();
    for _ in 0..statements {
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

/// The vertices of the polytope as points, in the basis.
fn polytope(certificate: &Certificate) -> Result<String, NotATheorem> {
    let vertices = certificate.claim.domain.polytope().map(|p| &p.vertices);
    let rows = table(vertices.map_or(&[], Vec::as_slice))?;
    let point = |row: &Vec<Vec<_>>| {
        let zeros = std::iter::repeat_n("0".to_owned(), 3 - row.len());
        let all: Vec<String> = zeros.chain(row.iter().map(|c| real(c, "a"))).collect();
        format!("Point {}", all.join(" "))
    };
    let points: Vec<String> = rows.iter().map(point).collect();
    Ok(format!("[{}]", points.join("; ")))
}

/// The data's Gram matrix, divided by its denominator, is that of the claim.
fn same_gram(constructor: &str, gram: &str) -> String {
    format!(
        "unfold dgram, c, {constructor}, faces_cert; cbn [Checker.c_gram Checker.c_gden \
         Checker.k11 Checker.k22 Checker.k33 Checker.k12 Checker.k13 Checker.k23 ev]; unfold {gram}; f_equal; field"
    )
}

/// And the polytope likewise.
fn same_polytope(constructor: &str, polytope: &str) -> String {
    format!(
        "unfold dpoint, c, {constructor}, faces_cert; cbn [Checker.c_polytope Checker.c_den \
         Checker.vX Checker.vY Checker.vZ map ev]; unfold {polytope}; repeat (apply f_equal2; [f_equal; field|]); reflexivity"
    )
}

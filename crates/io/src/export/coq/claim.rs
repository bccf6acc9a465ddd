//! The theorem itself: the claim in the words of Statement.v, and the proof by the checker.

use super::error::NotATheorem;
use super::numbers::real;
use super::root::RootOf;
use super::statements::{Named, named};
use acutile_core::format::Certificate;
use malachite::Integer;
use malachite::base::num::basic::traits::One;
use std::fmt::Write;

/// The words of Statement.v, or of PlaneStatement.v.
pub(super) struct Words {
    pub(super) dimension: usize,
    basis: &'static str,
    /// The numeral that the names of the plane end in.
    suffix: &'static str,
    tiling: &'static str,
    simplices: &'static str,
    simplices_type: &'static str,
    denotation: &'static str,
    point: &'static str,
    /// The entries of the Gram matrix, in the order of the record.
    entries: &'static [(usize, usize)],
    /// The definitions to unfold, to see that the data are the claim's: over Z, over a field.
    unfolded: [&'static str; 2],
    computed: &'static str,
    /// The polytope of a certificate.
    polytope: &'static str,
}

pub(super) const SPACE: Words = Words {
    dimension: 3,
    basis: "l1 l2 l3",
    suffix: "",
    tiling: "face_to_face_tiling",
    simplices: "tetrahedra",
    simplices_type: "point -> point -> point -> nat -> tetrahedron",
    denotation: "dtet",
    point: "point",
    entries: &[(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)],
    unfolded: ["c, zcert, faces_cert", "c, nfcert, faces_cert"],
    computed: "Checker.c_gram Checker.k11 Checker.k22 Checker.k33 Checker.k12 Checker.k13 Checker.k23 \
               Checker.c_polytope Checker.c_den Checker.vX Checker.vY Checker.vZ map ev",
    polytope: "c_polytope",
};

pub(super) const PLANE: Words = Words {
    dimension: 2,
    basis: "l1 l2",
    suffix: "2",
    tiling: "edge_to_edge_tiling",
    simplices: "triangles",
    simplices_type: "point2 -> point2 -> nat -> triangle2",
    denotation: "dtriangle",
    point: "point2",
    entries: &[(0, 0), (1, 1), (0, 1)],
    unfolded: ["c", "c"],
    computed: "PlaneChecker.e_gram PlaneChecker.e_polytope PlaneChecker.e_den fst snd map ev",
    polytope: "e_polytope",
};

/// A certificate and the words for it.
pub(super) struct Theorem<'a> {
    pub(super) certificate: &'a Certificate,
    pub(super) words: &'static Words,
}

impl Theorem<'_> {
    /// The theorem over the rational numbers.
    pub(super) fn over_the_rationals(&self) -> Result<String, NotATheorem> {
        let Words {
            suffix,
            simplices,
            simplices_type,
            denotation,
            point,
            polytope,
            ..
        } = self.words;
        let named = named(&self.certificate.claim)?;
        Ok(format!(
            "{}Local Open Scope R_scope.\nDefinition G : gram{suffix} := {}.\n\
             Definition W : list {point} := {}.\nDefinition claimed : list statement := {}.\n\
             {CORNERS}Definition {simplices} : {simplices_type} := {denotation} Z idZ IZR c.\n\n\
             Lemma checked : zcheck{suffix} c statements = true.\n{BY_COMPUTATION}\n\
             Theorem claim :\n  {}\
             Proof.\n  assert (E : dgram{suffix} Z IZR c = G) by ({same}; reflexivity).\n  \
             assert (D : map (dpoint{suffix} Z IZR c) ({polytope} Z c) = W) by ({same}; unfold W; {POINTWISE}).\n  \
             assert (S : map (dstatement Z IZR) statements = claimed) by reflexivity.\n  \
             destruct (z_theorem{suffix} c statements checked) as [B T]. unfold ddomain{suffix} in T. rewrite E, D, S in *.\n  \
             split; [exact B|].\n{}",
            statements("Z", &named),
            self.gram()?,
            self.polytope()?,
            claimed(&named),
            self.conclusion("G", "W", simplices, &named),
            self.last_steps(&named),
            same = self.same(0),
        ))
    }

    /// The theorem over Q(a): there is one root in the interval, and it is the a of the claim.
    pub(super) fn over_a_field(&self, root: &RootOf) -> Result<String, NotATheorem> {
        let Words {
            suffix,
            simplices,
            simplices_type,
            denotation,
            point,
            polytope,
            ..
        } = self.words;
        let named = named(&self.certificate.claim)?;
        Ok(format!(
            "{}Local Open Scope R_scope.\nDefinition p (x : R) : R := {}.\nDefinition G (a : R) : gram{suffix} := {}.\n\
             Definition W (a : R) : list {point} := {}.\nDefinition claimed (a : R) : list statement := {}.\n\
             {CORNERS}Definition {simplices} (a : R) : {simplices_type} := {denotation} (list Z) lofZ (ev a) c.\n\n\
             Lemma root_isolated : isolated fl e0 es interval = true.\n{BY_COMPUTATION}\
             Lemma checked : nfcheck{suffix} fl e0 es c statements = true.\n{BY_COMPUTATION}\n\
             Theorem claim : exists a : R, p a = 0 /\\ {} /\\ (forall x, p x = 0 -> {between_x} -> x = a) /\\\n  {}\
             Proof.\n  \
             destruct (nf_theorem{suffix} fl e0 es interval c statements root_isolated checked) as [a [A1 [A2 [A3 [B T]]]]].\n  \
             assert (P : forall x, ev x (fl ++ [1%Z]) = p x) by (intros; unfold p, fl; cbn [app ev]; ring).\n  \
             assert (I : forall x, in_claimed interval x <-> {between_x}) by (intros; unfold in_claimed, interval; cbn [e_lo e_hi e_S]; lra).\n  \
             assert (E : dgram{suffix} (list Z) (ev a) c = G a) by ({same}; unfold G; f_equal; field).\n  \
             assert (D : map (dpoint{suffix} (list Z) (ev a) c) ({polytope} (list Z) c) = W a) by ({same}; unfold W; {POINTWISE}).\n  \
             assert (S : map (dstatement (list Z) (ev a)) statements = claimed a)\n    \
             by (unfold statements, claimed; cbn [map dstatement]; unfold dangle; cbn [ev]; repeat f_equal; ring).\n  \
             unfold ddomain{suffix} in T. rewrite E, D, S in *. rewrite P in A1. exists a.\n  \
             split; [exact A1|]. split; [apply I; exact A2|].\n  \
             split; [intros x X1 X2; apply A3; [rewrite P; exact X1 | apply I; exact X2]|]. split; [exact B|].\n{}",
            statements("list Z", &named),
            root.polynomial("x"),
            self.gram()?,
            self.polytope()?,
            claimed(&named),
            root.between("a"),
            self.conclusion("(G a)", "(W a)", &format!("{simplices} a"), &named),
            self.last_steps(&named),
            between_x = root.between("x"),
            same = self.same(1),
        ))
    }

    /// The tactic that computes what the data denote; over a ring: 0 is Z, 1 a field.
    fn same(&self, ring: usize) -> String {
        let Words {
            suffix,
            unfolded,
            computed,
            ..
        } = self.words;
        format!(
            "unfold dgram{suffix}, dpoint{suffix}, {}; cbn [{computed}]",
            unfolded[ring]
        )
    }

    /// "l1, l2, l3 have the Gram matrix, and for all such the statements hold".
    fn conclusion(&self, gram: &str, polytope: &str, simplices: &str, named: &[Named]) -> String {
        let Words {
            dimension,
            basis,
            suffix,
            tiling,
            ..
        } = self.words;
        let rank = self.certificate.claim.rank();
        let count = self.certificate.witness.simplices.len() / (dimension + 1);
        let of = format!("{basis} {rank} {count} ({simplices} {basis})");
        let mut text = format!(
            "(exists {basis}, has_gram{suffix} {gram} {basis}) /\\\n  \
             forall {basis}, has_gram{suffix} {gram} {basis} ->\n    \
             {tiling} {basis} {rank} (domain{suffix} {basis} {rank} {polytope}) {count} ({simplices} {basis})"
        );
        for statement in named {
            // A String takes every text.
            let _ = write!(
                text,
                " /\\\n    {}",
                statement.proposition.replace('@', &of)
            );
        }
        text + ".\n"
    }

    /// The end of both proofs: the k-th statement by its place in the list.
    fn last_steps(&self, named: &[Named]) -> String {
        let basis = self.words.basis;
        let mut text = format!("  intros {basis} L. destruct (T {basis} L) as [T1 T2].\n");
        let mut place = "(or_introl eq_refl)".to_owned();
        let mut proof = "T1".to_owned();
        for _ in named {
            let _ = writeln!(text, "  split; [exact {proof}|].");
            proof = format!("(T2 _ {place})");
            place = format!("(or_intror {place})");
        }
        text + &format!("  exact {proof}.\nQed.\nPrint Assumptions claim.\n")
    }

    fn gram(&self) -> Result<String, NotATheorem> {
        let claim = &self.certificate.claim;
        let wrong = NotATheorem::Malformed("the shape of the Gram matrix");
        let mut entries = Vec::new();
        for &(i, j) in self.words.entries {
            let entry = claim.gram.get(i).and_then(|row| row.get(j - i));
            let entry = entry.ok_or_else(|| wrong.clone())?;
            entries.push(real(entry, &Integer::ONE, &claim.field, "a")?);
        }
        Ok(format!("Gram{} {}", self.words.suffix, entries.join(" ")))
    }

    /// The vertices of the polytope as points, in the basis.
    fn polytope(&self) -> Result<String, NotATheorem> {
        let claim = &self.certificate.claim;
        let Some(polytope) = claim.domain.polytope() else {
            return Ok("[]".to_owned());
        };
        let mut points = Vec::new();
        for vertex in &polytope.vertices {
            let mut coordinates = vec!["0".to_owned(); claim.rank()];
            for x in vertex {
                coordinates.push(real(x, &polytope.denominator, &claim.field, "a")?);
            }
            points.push(format!(
                "Point{} {}",
                self.words.suffix,
                coordinates.join(" ")
            ));
        }
        Ok(format!("[{}]", points.join("; ")))
    }
}

/// The statements for the checker.
fn statements(ring: &str, named: &[Named]) -> String {
    let terms: Vec<&str> = named.iter().map(|s| s.checked.as_str()).collect();
    let terms = terms.join("; ");
    format!("Definition statements : list (cstatement ({ring})) := [{terms}].\n\n")
}

/// The same with real numbers.
fn claimed(named: &[Named]) -> String {
    let terms: Vec<&str> = named.iter().map(|s| s.claimed.as_str()).collect();
    format!("[{}]", terms.join("; "))
}

const CORNERS: &str =
    "(* Corner (v, n) is the point with the coordinates of vertex v, plus n, in the basis. *)\n";

/// Coq's virtual machine runs the checker, in the kernel.
const BY_COMPUTATION: &str = "Proof. vm_cast_no_check (eq_refl true). Qed.\n";

/// Two lists of points, entry by entry.
const POINTWISE: &str = "repeat (apply f_equal2; [f_equal; field|]); reflexivity";

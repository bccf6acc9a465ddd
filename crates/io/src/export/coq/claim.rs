//! The theorem itself: the claim in the words of Statement.v, and the proof by the checker.

use super::NotATheorem;
use super::numbers::{coefficients, integer, rational, real, table};
use super::root::{Enclosure, RootOf};
use acutile_format1::certificate::{Certificate, Statement};
use std::fmt::Write;

/// The words of Statement.v, or of PlaneStatement.v.
pub(super) struct Words {
    dimension: usize,
    basis: &'static str,
    /// The numeral that the names of the plane end in.
    suffix: &'static str,
    tiling: &'static str,
    simplices: &'static str,
    simplices_type: &'static str,
    denotation: &'static str,
    point: &'static str,
    entries: &'static [(usize, usize)],
    /// What to unfold and to compute, to see that the data are the claim's.
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
    computed: "Checker.c_gram Checker.c_gden Checker.k11 Checker.k22 Checker.k33 Checker.k12 Checker.k13 Checker.k23 \
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
    computed: "PlaneChecker.e_gram PlaneChecker.e_gden PlaneChecker.e_polytope PlaneChecker.e_den fst snd map ev",
    polytope: "e_polytope",
};

/// A certificate and the words for it.
pub(super) struct Theorem<'a> {
    pub(super) certificate: &'a Certificate,
    pub(super) words: &'static Words,
}

impl Theorem<'_> {
    fn rank(&self) -> usize {
        self.certificate.claim.domain.rank(self.words.dimension)
    }

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
        let conclusion = self.conclusion("G", "W", simplices)?;
        let same = self.same(0);
        Ok(format!(
            "{}Local Open Scope R_scope.\nDefinition G : gram{suffix} := {}.\n\
             Definition W : list {point} := {}.\n\
             {CORNERS}Definition {simplices} : {simplices_type} := {denotation} Z idZ IZR c.\n\n\
             Lemma checked : zcheck{suffix} c statements = true.\n{BY_COMPUTATION}\n\
             Theorem claim :\n  {conclusion}\
             Proof.\n  assert (E : dgram{suffix} Z IZR c = G) by ({same}; unfold G; f_equal; field).\n  \
             assert (D : map (dpoint{suffix} Z IZR c) ({polytope} Z c) = W) by ({same}; unfold W; {POINTWISE}).\n  \
             destruct (z_theorem{suffix} c statements checked) as [B T]. unfold ddomain{suffix} in T. rewrite E, D in *.\n  split; [exact B|].\n{}",
            self.statements()?,
            self.gram()?,
            self.polytope()?,
            self.last_steps()?
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
        let between = |x: &str| {
            let end = |e| real(std::slice::from_ref(e), x);
            format!("{} <= {x} <= {}", end(&root.low), end(&root.high))
        };
        let conclusion = self.conclusion("(G a)", "(W a)", &format!("{simplices} a"))?;
        let same = self.same(1);
        Ok(format!(
            "{}Local Open Scope R_scope.\nDefinition p (x : R) : R := {}.\nDefinition G (a : R) : gram{suffix} := {}.\n\
             Definition W (a : R) : list {point} := {}.\n\
             {CORNERS}Definition {simplices} (a : R) : {simplices_type} := {denotation} (list Z) lofZ (ev a) c.\n\n\
             Lemma root_isolated : isolated fl e0 es interval = true.\n{BY_COMPUTATION}\
             Lemma checked : nfcheck{suffix} fl e0 es c statements = true.\n{BY_COMPUTATION}\n\
             Theorem claim : exists a : R, p a = 0 /\\ {} /\\ (forall x, p x = 0 -> {} -> x = a) /\\\n  {conclusion}\
             Proof.\n  \
             destruct (nf_theorem{suffix} fl e0 es interval c statements root_isolated checked) as [a [A1 [A2 [A3 [B T]]]]].\n  \
             assert (P : forall x, ev x (fl ++ [1%Z]) = p x) by (intros; unfold p, fl; cbn [app ev]; ring).\n  \
             assert (I : forall x, in_claimed interval x <-> {}) by (intros; unfold in_claimed, interval; cbn [e_lo e_hi e_S]; lra).\n  \
             assert (E : dgram{suffix} (list Z) (ev a) c = G a) by ({same}; unfold G; f_equal; field).\n  \
             assert (D : map (dpoint{suffix} (list Z) (ev a) c) ({polytope} (list Z) c) = W a) by ({same}; unfold W; {POINTWISE}).\n  \
             unfold ddomain{suffix} in T. rewrite E, D in *. rewrite P in A1. exists a.\n  \
             split; [exact A1|]. split; [apply I; exact A2|].\n  \
             split; [intros x X1 X2; apply A3; [rewrite P; exact X1 | apply I; exact X2]|]. split; [exact B|].\n{}",
            self.statements()?,
            real(&root.rational_polynomial(), "x"),
            self.gram()?,
            self.polytope()?,
            between("a"),
            between("x"),
            between("x"),
            self.last_steps()?
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

    fn all_named(&self) -> Result<Vec<(String, String)>, NotATheorem> {
        let statements = self.certificate.claim.statements.iter();
        let named = |s| named(s, self.words).transpose();
        statements.filter_map(named).collect()
    }

    fn statements(&self) -> Result<String, NotATheorem> {
        let terms: Vec<String> = self.all_named()?.into_iter().map(|(t, _)| t).collect();
        Ok(format!(
            "Definition statements : list statement := [{}].\n\n",
            terms.join("; ")
        ))
    }

    /// "l1, l2, l3 have the Gram matrix, and for all such the statements hold".
    fn conclusion(
        &self,
        gram: &str,
        polytope: &str,
        simplices: &str,
    ) -> Result<String, NotATheorem> {
        let (n, r) = (self.certificate.witness.simplices.len(), self.rank());
        let Words {
            basis,
            suffix,
            tiling,
            ..
        } = self.words;
        let of = format!("{basis} {r} {n} ({simplices} {basis})");
        let mut text = format!(
            "(exists {basis}, has_gram{suffix} {gram} {basis}) /\\\n  \
             forall {basis}, has_gram{suffix} {gram} {basis} ->\n    \
             {tiling} {basis} {r} (domain{suffix} {basis} {r} {polytope}) {n} ({simplices} {basis})"
        );
        for (_, proposition) in self.all_named()? {
            let _ = write!(text, " /\\\n    {}", proposition.replace('@', &of));
        }
        Ok(text + ".\n")
    }

    /// The end of both proofs: the k-th statement by its place in the list.
    fn last_steps(&self) -> Result<String, NotATheorem> {
        let basis = self.words.basis;
        let mut text = format!("  intros {basis} L. destruct (T {basis} L) as [T1 T2].\n");
        let mut place = "(or_introl eq_refl)".to_owned();
        let mut proof = "T1".to_owned();
        for _ in self.all_named()? {
            let _ = writeln!(text, "  split; [exact {proof}|].");
            proof = format!("(T2 _ {place})");
            place = format!("(or_intror {place})");
        }
        Ok(text + &format!("  exact {proof}.\nQed.\nPrint Assumptions claim.\n"))
    }

    fn gram(&self) -> Result<String, NotATheorem> {
        let mut entries = Vec::new();
        for &(i, j) in self.words.entries {
            entries.push(real(
                &coefficients(&self.certificate.claim.gram[i][j])?,
                "a",
            ));
        }
        Ok(format!("Gram{} {}", self.words.suffix, entries.join(" ")))
    }

    /// The vertices of the polytope as points, in the basis.
    fn polytope(&self) -> Result<String, NotATheorem> {
        let polytope = self.certificate.claim.domain.polytope();
        let rows = table(polytope.map_or(&[], |p| p.vertices.as_slice()))?;
        let point = |row: &Vec<Vec<_>>| {
            let zeros = std::iter::repeat_n("0".to_owned(), self.rank());
            let all: Vec<String> = zeros.chain(row.iter().map(|c| real(c, "a"))).collect();
            format!("Point{} {}", self.words.suffix, all.join(" "))
        };
        let points: Vec<String> = rows.iter().map(point).collect();
        Ok(format!("[{}]", points.join("; ")))
    }
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

/// Coq's virtual machine runs the checker, in the kernel.
const BY_COMPUTATION: &str = "Proof. vm_cast_no_check (eq_refl true). Qed.\n";

/// Two lists of points, entry by entry.
const POINTWISE: &str = "repeat (apply f_equal2; [f_equal; field|]); reflexivity";

/// A statement but the first: its term of type `statement`, and its proposition about the
/// tiling `@`.
fn named(statement: &Statement, words: &Words) -> Result<Option<(String, String)>, NotATheorem> {
    let suffix = words.suffix;
    let angles = match words.dimension {
        3 => "dihedral",
        _ => "angles",
    };
    let plain = |term: &str, word: &str| Ok(Some((term.to_owned(), format!("{word}{suffix} @"))));
    let bounded = |term: &str, word: &str, bound: &str| {
        let bound = rational(bound)?;
        let (p, q) = (integer(bound.numer()), integer(bound.denom()));
        let proposition = format!("{word}{suffix} @ ({p} / {q})");
        Ok(Some((format!("{term} {p} {q}"), proposition)))
    };
    match statement {
        Statement::FaceToFaceTiling => Ok(None),
        Statement::Acute => plain("Acute", "acute"),
        Statement::Nonobtuse => plain("Nonobtuse", "nonobtuse"),
        Statement::DihedralBelow(q) => bounded("DihedralBelow", &format!("{angles}_below"), q),
        Statement::DihedralAbove(q) => bounded("DihedralAbove", &format!("{angles}_above"), q),
        Statement::RadiusEdgeBelow(q) => bounded("RadiusEdgeBelow", "radius_edge_below", q),
        Statement::Delaunay => plain("Delaunay", "delaunay"),
        Statement::WeaklyDelaunay => plain("WeaklyDelaunay", "weakly_delaunay"),
        Statement::Tcp if words.dimension == 3 => plain("TCP", "tcp"),
        Statement::Tcp => Err(NotATheorem::Malformed("TCP in the plane".to_owned())),
    }
}

//! Section 3.1: the acuteness lemmas, as polynomial identities and on random exact
//! tetrahedra.
//!
//! Tetrahedra are a = 0, b, c, d with integer coordinates in space; the lemmas are
//! invariant under translation. For facets X and Y the program decides acuteness by the sign
//! of <g_X, g_Y>; `program_product` is that number.

use super::identity::{Vector, cross, dot, is_zero, minus, vector};
use super::random::{SAMPLES, tetrahedra};
use super::row::Row;
use acutile_core::quality::{DihedralAngle, Exact, RadiusEdge, decimal_range, display_width};
use acutile_exact::geometry::{NormalProducts, Simplex, linear};
use acutile_exact::number::Number;
use malachite::{Integer, Rational};

/// The rows of section 3 up to 3.1.
pub fn rows() -> Vec<Row> {
    let row = |section, id, statement, printed| Row::new(section, id, statement, printed);
    vec![
        row(
            "3",
            "acute-but-long",
            "an acute tetrahedron can have an arbitrarily large radius-edge ratio",
            "need not have high quality",
        )
        .found(Ok(spires())),
        row(
            "3.1",
            "lemma-1-projection",
            "lemma 1, first half: the dihedral angle at ab is that between the projections of ac and ad \
             along ab",
            "lemma 1",
        )
        .found(Ok(projection_identity())),
        row(
            "3.1",
            "lemma-1-thales",
            "lemma 1, second half: it is acute exactly when the projection of a lies strictly outside \
             of the circle with diameter cd (Thales)",
            "lemma 1",
        )
        .found(Ok(thales())),
        row(
            "3.1",
            "lemma-2-projection-inside",
            "lemma 2: a tetrahedron is acute exactly when each vertex projects strictly inside the \
             opposite facet",
            "lemma 2",
        )
        .found(Ok(vertex_projections())),
        row(
            "3.1",
            "lemma-2-edge",
            "in the proof of lemma 2: a vertex that projects to an edge of the opposite facet has a \
             dihedral angle of exactly 90 degrees there",
            "exactly 90°",
        )
        .found(Ok(right_angles())),
        row(
            "3.1",
            "lemma-2-acute-facets",
            "lemma 2: acute tetrahedra have acute facets",
            "lemma 2",
        )
        .found(Ok(acute_facets())),
        row(
            "3.1",
            "lemma-2-not-sufficient",
            "lemma 2: acute facets do not make a tetrahedron acute",
            "not sufficient",
        )
        .found(Ok(sliver())),
        row(
            "3.1",
            "obtuse-projections",
            "figure (b): if the dihedral angle at ab is obtuse, both c and d project outside of their \
             opposite triangles",
            "figure caption",
        )
        .found(Ok(obtuse_projections())),
        row(
            "3.1",
            "facet-angle-against-dihedral",
            "figure (d) and the proof of lemma 2: if d projects inside the triangle abc, then the face angle \
             bac is smaller than the dihedral angle on ad",
            "cos d' < cos bac",
        )
        .found(Ok(facet_angle_against_dihedral())),
        row(
            "3.1",
            "dual-cosine-law",
            "the spherical law of cosines for dihedral angles",
            "cos d' = -cos b' cos c' + sin b' sin c' cos bac",
        )
        .found(Ok(dual_cosine_law())),
    ]
}

/// The products <g_i, g_j> that the program decides by.
fn program(t: &[Vector; 4]) -> NormalProducts<Integer, 3> {
    let corners = t.map(|point| point.map(Integer::from));
    let unit: [[Integer; 3]; 3] =
        std::array::from_fn(|i| std::array::from_fn(|j| Integer::from(i32::from(i == j))));
    Simplex::new(&corners).normal_products(&unit)
}

/// Whether the program calls a tetrahedron acute.
fn is_acute(t: &[Vector; 4]) -> bool {
    program(t).pairs().all(|(_, _, product)| *product < 0)
}

/// Pyramids over an equilateral triangle, in the basis of two of its sides and the height: the
/// corners (0,0,0), (1,0,0), (0,1,0), (1/3,1/3,1), with squared side 2 and squared height n².
fn spires() -> (bool, String) {
    let third = Rational::from_signeds(1, 3);
    let number = |n: i64| Number::from(Rational::from(n));
    let base = [[0, 0, 0], [1, 0, 0], [0, 1, 0]].map(|p| p.map(number));
    let apex = [Number::from(third.clone()), Number::from(third), number(1)];
    let [a, b, c] = base;
    let spire = Simplex::new(&[a, b, c, apex]);
    let is_acute_and_long = |height: i64| {
        let gram = [[2, 1, 0], [1, 2, 0], [0, 0, height * height]].map(|row| row.map(number));
        let products = spire.normal_products(&linear::cofactors(&gram));
        let ratio = RadiusEdge::of(&spire, &gram).expect("the spire is not flat");
        let acute = products
            .pairs()
            .all(|(_, _, product)| product.sign().is_lt());
        // R is at least half of the height, and the side is √2.
        acute && ratio.square > number(height * height / 16)
    };
    let holds = [100, 10_000, 1_000_000].into_iter().all(is_acute_and_long);
    let proved = "acute pyramids over an equilateral triangle whose radius-edge ratio exceeds 25, 2500, 250000";
    (holds, proved.to_owned())
}

/// With x = b - a along the edge and P the projection, |x|² Pc · Pd = (x × c) · (x × d) =
/// (c · d)|x|² - (c · x)(d · x), and the latter is -<g_c, g_d>.
fn projection_identity() -> (bool, String) {
    let degrees = [2, 2, 2, 1, 1, 1, 1, 1, 1];
    let difference = |p: &[i128]| {
        let [x, c, d] = [0, 1, 2].map(|k| vector(p, k));
        dot(c, d) * dot(x, x) - dot(c, x) * dot(d, x) - dot(cross(x, c), cross(x, d))
    };
    let is_identity = is_zero(&degrees, difference);
    let agrees = tetrahedra().all(|t| {
        let [x, c, d] = [1, 2, 3].map(|k| minus(t[k], t[0]));
        *program(&t).get(2, 3) == -dot(cross(x, c), cross(x, d))
    });
    let proved = format!(
        "identity (c·d)|x|² - (c·x)(d·x) = (x×c)·(x×d); the program's product is its \
         negative on {SAMPLES} random tetrahedra"
    );
    (is_identity && agrees, proved)
}

/// For p in the plane, seen from a = 0: |(c+d)/2|² - |(c-d)/2|² = c · d.
fn thales() -> (bool, String) {
    let difference = |p: &[i128]| {
        let (c, d) = ([p[0], p[1], 0], [p[2], p[3], 0]);
        let sum = std::array::from_fn(|k| c[k] + d[k]);
        dot(sum, sum) - dot(minus(c, d), minus(c, d)) - 4 * dot(c, d)
    };
    let proved = "identity |(c+d)/2|² - |(c-d)/2|² = c·d: power of a and cosine at a have one sign";
    (is_zero(&[2; 4], difference), proved.to_owned())
}

/// With x = b, y = c, z = d from a = 0 and n = x × y the foot of d has the barycentric coordinate
/// ((z·x)(y·y) - (z·y)(x·y)) / |n|² at b (normal equations); it is -<g_b, g_d> / |n|²
/// for g_d = n and g_b = y × z. The other coordinates follow by renaming.
fn vertex_projections() -> (bool, String) {
    let degrees = [1, 1, 1, 2, 2, 2, 1, 1, 1];
    let difference = |p: &[i128]| {
        let [x, y, z] = [0, 1, 2].map(|k| vector(p, k));
        let foot = dot(z, x) * dot(y, y) - dot(z, y) * dot(x, y);
        foot + dot(cross(y, z), cross(x, y))
    };
    let agrees = tetrahedra().all(|t| is_acute(&t) == (0..4).all(|k| projects_inside(&t, k)));
    let acute = tetrahedra().filter(is_acute).count();
    let proved = format!(
        "identity between the foot's barycentric coordinates and -<g_i, g_d>/|g_d|²; both sides agree on \
         {SAMPLES} random tetrahedra, {acute} of them acute"
    );
    (
        is_zero(&degrees, difference) && agrees && acute * 10 > SAMPLES,
        proved,
    )
}

/// Whether a corner projects strictly inside the opposite triangle, decided by the foot's place at
/// each side of the triangle.
fn projects_inside(t: &[Vector; 4], corner: usize) -> bool {
    let triangle: Vec<Vector> = (0..4).filter(|&k| k != corner).map(|k| t[k]).collect();
    let normal = cross(
        minus(triangle[1], triangle[0]),
        minus(triangle[2], triangle[0]),
    );
    (0..3).all(|k| {
        let (p, q) = (triangle[k], triangle[(k + 1) % 3]);
        // The inner side of pq in the triangle's plane; the normal does not change the product.
        dot(cross(normal, minus(q, p)), minus(t[corner], p)) > 0
    })
}

fn right_angles() -> (bool, String) {
    let mut count = 0;
    let holds = tetrahedra().all(|t| {
        let [x, y, z] = [1, 2, 3].map(|k| minus(t[k], t[0]));
        // The foot of d lies on the line ab: in the triangle its coordinate at c is zero.
        let at_c = dot(z, y) * dot(x, x) - dot(z, x) * dot(x, y);
        let product = program(&t);
        count += usize::from(at_c == 0);
        (at_c == 0) == (*product.get(2, 3) == 0)
    });
    let proved =
        format!("follows from the identity of lemma 2; {count} such random tetrahedra agree");
    (holds && count > 0, proved)
}

/// A facet angle at a is acute if (b-a)·(c-a) > 0.
fn has_acute_facets(t: &[Vector; 4]) -> bool {
    (0..4).all(|a| {
        let others: Vec<usize> = (0..4).filter(|&k| k != a).collect();
        (0..3).all(|k| {
            let (b, c) = (others[k], others[(k + 1) % 3]);
            dot(minus(t[b], t[a]), minus(t[c], t[a])) > 0
        })
    })
}

/// By the dual law of cosines with acute b', c', d': det² (x·y) = <g_c,g_d><g_b,g_d> -
/// <g_b,g_c><g_d,g_d> is the sum of two positive numbers.
fn acute_facets() -> (bool, String) {
    let (identity, _) = dual_cosine_law();
    let holds = tetrahedra().filter(is_acute).all(|t| has_acute_facets(&t));
    let proved = format!(
        "from the identity of the law of cosines: det² (b-a)·(c-a) is a sum of two positive \
         products; holds for the acute ones of {SAMPLES} random tetrahedra"
    );
    (identity && holds, proved)
}

/// The foot's coordinates of d at c and of c at d have the sign of -<g_c, g_d> by the identity of
/// lemma 2.
fn obtuse_projections() -> (bool, String) {
    let mut count = 0;
    let holds = tetrahedra().filter(|t| *program(t).get(2, 3) > 0).all(|t| {
        count += 1;
        !projects_inside(&t, 2) && !projects_inside(&t, 3)
    });
    let proved =
        format!("follows from the identity of lemma 2; {count} such random tetrahedra agree");
    (holds && count > 0, proved)
}

/// cos d' = -cos b' cos c' + sin b' sin c' cos bac is less than cos bac where the latter is positive. The
/// proof of lemma 2 is about negative values. There sin b' sin c' < 1 brings the product closer to zero,
/// and a flat triangle decides.
fn facet_angle_against_dihedral() -> (bool, String) {
    let flat = [[0, 0, 0], [-200, -20, 0], [200, -20, 0], [-100, -11, 6]];
    let is_counterexample = |t: &[Vector; 4]| {
        let facet = facet_angle(t);
        projects_inside(t, 3) && dihedral_angle(t) < facet
    };
    let acute_case = tetrahedra()
        .filter(|t| projects_inside(t, 3) && facet_angle(t) < right_angle())
        .all(|t| facet_angle(&t) < dihedral_angle(&t));
    let both = |t: &[Vector; 4]| {
        [facet_angle(t), dihedral_angle(t)]
            .map(|angle| decimal_range(&angle.enclosure(&display_width())))
    };
    let [facet, dihedral] = both(&flat);
    let (identity, _) = dual_cosine_law();
    let proved = format!(
        "false for the nonacute bac of the proof: a = (0,0,0), b = (-200,-20,0), c = (200,-20,0), \
         d = (-100,-11,6) has bac = {facet}° and the dihedral angle {dihedral}° on ad. True for acute bac{}. \
         Lemma 2 stands: bac >= 90° and b', c' < 90° give cos d' < 0 by the law of cosines",
        if acute_case && identity {
            " (random tetrahedra agree)"
        } else {
            ": not confirmed"
        }
    );
    (!is_counterexample(&flat), proved)
}

fn right_angle() -> DihedralAngle {
    DihedralAngle::of_rational(Rational::from(0))
}

/// The angle bac: cos² = (x·y)²/(|x|²|y|²) with x = b - a, y = c - a.
fn facet_angle(t: &[Vector; 4]) -> DihedralAngle {
    let (x, y) = (minus(t[1], t[0]), minus(t[2], t[0]));
    let product = dot(x, y);
    let square = Rational::from_integers(
        Integer::from(product * product.abs()),
        Integer::from(dot(x, x) * dot(y, y)),
    );
    DihedralAngle::of_rational(square)
}

/// The dihedral angle on ad, where the facets opposite b and c meet.
fn dihedral_angle(t: &[Vector; 4]) -> DihedralAngle {
    let [b, c] = [minus(t[1], t[0]), minus(t[2], t[0])];
    let d = minus(t[3], t[0]);
    // (d × b) · (d × c) has the sign of the cosine, as in lemma 1.
    let (u, v) = (cross(d, b), cross(d, c));
    let product = dot(u, v);
    let square = Rational::from_integers(
        Integer::from(product * product.abs()),
        Integer::from(dot(u, u) * dot(v, v)),
    );
    DihedralAngle::of_rational(square)
}

fn sliver() -> (bool, String) {
    let sliver = [[2, 0, 1], [-2, 0, 1], [0, 2, -1], [0, -2, -1]];
    let oriented = [sliver[0], sliver[1], sliver[3], sliver[2]];
    let holds = has_acute_facets(&oriented) && !is_acute(&oriented);
    (
        holds,
        "the sliver (±2, 0, 1), (0, ±2, -1) has acute facets and is not acute".to_owned(),
    )
}

/// With x = b, y = c, z = d from a = 0, the normals g_b = y × z, g_c = z × x, g_d = x × y and
/// v = x · (y × z): g_c × g_d = v x and g_d × g_b = v y, hence <g_c,g_d><g_d,g_b> -
/// <g_c,g_b><g_d,g_d> = v² (x·y), <g_c,g_c><g_d,g_d> - <g_c,g_d>² = v² |x|², and the same for y. Divided
/// by lengths this is the law: cos d' = -<g_b,g_c>/(|g_b||g_c|) and so on.
fn dual_cosine_law() -> (bool, String) {
    let normals = |p: &[i128]| {
        let [x, y, z] = [0, 1, 2].map(|k| vector(p, k));
        (
            x,
            y,
            [cross(y, z), cross(z, x), cross(x, y)],
            dot(x, cross(y, z)),
        )
    };
    let cosine = |p: &[i128]| {
        let (x, y, [b, c, d], v) = normals(p);
        dot(c, d) * dot(d, b) - dot(c, b) * dot(d, d) - v * v * dot(x, y)
    };
    let sine = |p: &[i128]| {
        let (x, _, [_, c, d], v) = normals(p);
        dot(c, c) * dot(d, d) - dot(c, d) * dot(c, d) - v * v * dot(x, x)
    };
    let holds = is_zero(&[3, 3, 3, 3, 3, 3, 2, 2, 2], cosine)
        && is_zero(&[4, 4, 4, 2, 2, 2, 2, 2, 2], sine);
    let proved = "identities det² (b-a)·(c-a) = <g_c,g_d><g_b,g_d> - <g_b,g_c><g_d,g_d> and det² |b-a|² = \
                  <g_c,g_c><g_d,g_d> - <g_c,g_d>², by evaluation on grids";
    (holds, proved.to_owned())
}

//! Families: proved on a box, refuted at a point, and the exact intervals of the literature and of
//! hand calculations.

use acutile_catalog as catalog;
use acutile_core::checker::Options;
use acutile_core::family::conditions::{Atom, Conditions};
use acutile_core::family::maximal::{Maximal, maximal};
use acutile_core::family::tree::{Effort, Limit, NoTree, Tree, grow};
use acutile_core::family::{
    AnyFamily, Family, NotProvable, ProvedFamily, examine, free, point_in_words, prove,
};
use acutile_core::format::{self, print};
use acutile_core::proved::prove as prove_tiling;
use acutile_core::statement::Statement;
use acutile_core::tiling::AnyTiling;
use acutile_core::transcribe;
use acutile_exact::geometry::RingElement;
use acutile_exact::number::{Field, Number, numbers};
use acutile_exact::polynomial::line::{Extent, Place};
use acutile_exact::polynomial::{Cuboid, End, Polynomial, Side};
use acutile_kernel::Limits;
use malachite::Rational;

fn family(name: &str) -> AnyFamily {
    let entry = catalog::find(name).expect("a name of the catalogue");
    entry
        .build_family()
        .expect("a family")
        .expect("it is built")
}

fn space(name: &str) -> Family<3> {
    match family(name) {
        AnyFamily::Space(family) => family,
        AnyFamily::Plane(_) => panic!("{name} is a family of tilings of space"),
    }
}

fn options(required: &[&str]) -> Options {
    Options {
        required: required
            .iter()
            .map(|text| text.parse().expect("a requirement"))
            .collect(),
        ..Options::default()
    }
}

fn number(text: &str) -> Number {
    numbers(&[text]).expect("a number")[0].clone()
}

fn shown(extent: &Extent) -> String {
    match extent {
        Extent::Unbounded => "none".to_owned(),
        Extent::At { place, is_open } => {
            let bracket = if *is_open { "open" } else { "closed" };
            match place {
                Place::Number(value) => format!("{bracket} {value}"),
                Place::Root { .. } => {
                    let polynomial = place.polynomial().expect("a root");
                    format!("{bracket} root of {}", polynomial.shown(&["t".to_owned()]))
                }
            }
        }
    }
}

fn interval(name: &str, required: &str, point: &str) -> [String; 2] {
    let fraction = Rational::from_signeds(1, 16);
    let found = maximal(
        &space(name),
        &[number(point)],
        &options(&[required]),
        &fraction,
    );
    match found {
        Ok((Maximal::Interval(low, high), _)) => [shown(&low), shown(&high)],
        other => panic!("{name}: {other:?}"),
    }
}

#[test]
fn exact_intervals() {
    // No angle of Goldberg's first family is obtuse exactly for e² >= 2a², s = e²/(a² + e²) >= 2/3.
    assert_eq!(
        interval("goldberg-1-all", "nonobtuse", "3/4"),
        ["closed 2/3", "open 1"]
    );
    assert_eq!(
        interval("goldberg-1-all", "tiling", "1/2"),
        ["open 0", "open 1"]
    );
    assert_eq!(interval("z-all", "acute", "1"), ["open 1/2", "open 3"]);
    assert_eq!(interval("a15-all", "acute", "1"), ["open 2/5", "open 16/5"]);
    assert_eq!(
        interval("slab-stretch-all", "acute", "36"),
        ["open 100/3", "open 64"]
    );
    // The sphere through abcd passes e exactly for 9 ε² + 6 ε = 1.
    let root = number("(sqrt(2)-1)/3");
    assert_eq!(
        interval("two-corners-all", "acute", "1/10"),
        ["open 0", "none"]
    );
    let [low, high] = interval("two-corners-all", "weakly-delaunay", "1/2");
    assert_eq!(
        [low, high],
        [
            "closed root of 9*t^2 + 6*t - 1".to_owned(),
            "none".to_owned()
        ]
    );
    assert!((&root * &root * number("9") + &root * number("6") - number("1")).is_zero());
}

/// The statements of a family that the kernel confirms, and its certificate again from JSON.
fn proved<const D: usize>(family: &Family<D>, required: &[&str]) -> Vec<Statement> {
    let options = options(required);
    let proved = prove(family, &options, &|_| {}).expect("a proof that the kernel confirms");
    let json = print::to_json(proved.certificate()).expect("canonical CBOR");
    assert_eq!(
        format::json::to_cbor(&json).expect("canonical JSON"),
        proved.certificate()
    );
    let (again, read) = ProvedFamily::of_certificate(&json, &Limits::DEFAULT).expect("it is read");
    assert_eq!(again.statements(), proved.statements());
    // The family of a certificate has the same certificate.
    let certificate = match read {
        AnyFamily::Plane(f) => prove(&f, &options, &|_| {})
            .expect("a proof")
            .certificate()
            .to_vec(),
        AnyFamily::Space(f) => prove(&f, &options, &|_| {})
            .expect("a proof")
            .certificate()
            .to_vec(),
    };
    assert!(certificate == proved.certificate(), "another certificate");
    assert!(certificate.len() < 200_000);
    proved.statements().to_vec()
}

#[test]
fn the_catalogue_is_proved() {
    let required: [(&str, &[&str]); 10] = [
        ("goldberg-1-all", &[]),
        ("goldberg-1-nonobtuse", &["nonobtuse"]),
        ("goldberg-2-all", &[]),
        ("triangle-tiling-all", &["acute", "delaunay"]),
        ("two-corners-all", &["acute", "not-delaunay"]),
        ("slab-all", &["acute"]),
        ("slab-stretch-all", &["acute"]),
        ("z-all", &["acute", "tcp"]),
        ("a15-all", &["acute", "tcp"]),
        ("c14-all", &["acute", "tcp", "delaunay"]),
    ];
    assert_eq!(catalog::family_names().count(), required.len());
    for (name, required) in required {
        let statements = match family(name) {
            AnyFamily::Plane(family) => proved(&family, required),
            AnyFamily::Space(family) => proved(&family, required),
        };
        let has = |statement| statements.contains(&statement);
        assert_eq!(has(Statement::Acute), required.contains(&"acute"), "{name}");
        assert_eq!(has(Statement::Tcp), required.contains(&"tcp"), "{name}");
        assert_eq!(
            has(Statement::NotDelaunay),
            required.contains(&"not-delaunay"),
            "{name}"
        );
    }
}

/// By lemma 4 of the paper the two tetrahedra are weakly Delaunay from epsilon = (√2 - 1)/3 on. With a larger box
/// the claim that they are not Delaunay is false, and so it is for acute triangles.
#[test]
fn not_delaunay_is_refuted() {
    let mut wide = space("two-corners-all");
    wide.parameters[0].side.high = End::closed(number("1/2"));
    match examine(&wide, &options(&["not-delaunay"]), &|_| {}) {
        Err(NotProvable::Refuted { point, .. }) => {
            assert!(point[0] >= number("(sqrt(2)-1)/3") && point[0] <= number("1/2"));
        }
        other => panic!("{other:?}"),
    }
    let AnyFamily::Plane(triangles) = family("triangle-tiling-all") else {
        panic!("a family of the plane");
    };
    let answer = examine(&triangles, &options(&["not-delaunay"]), &|_| {});
    assert!(
        matches!(answer, Err(NotProvable::Refuted { .. })),
        "{answer:?}"
    );
    let AnyTiling::Space(a15) = catalog::build("a15").expect("a15") else {
        panic!("a tiling of space");
    };
    assert!(prove_tiling(&a15, &options(&["not-delaunay"]), &|_| {}).is_err());
}

/// The ideal Laves phase and the icosahedra in layers, whose numbers are in Q(√5).
#[test]
fn c14_contains_both_structures() {
    let family = space("c14-all");
    let ideal = ["8/3", "1/16", "5/6"].map(number);
    assert!(family.cuboid().contains(&ideal));
    let Ok(AnyTiling::Space(expected)) = catalog::build("icosahedral") else {
        panic!("a tiling of space");
    };
    // The golden ratio.
    let phi = expected.frame.field.generator();
    assert_eq!(&phi * &phi, &phi + &number("1"));
    let quotient = |x: &Number, y: Number| x.divide(&y).expect("not zero");
    let square = &phi * &phi;
    let third = quotient(&number("1/3"), phi.clone());
    let icosahedra = [
        &square * &number("4/3"),
        quotient(&number("1/4"), &square * &phi),
        &number("1") - &third,
    ];
    assert!(family.cuboid().contains(&icosahedra));
    // Turned by 180 degrees around the axis, every point of the member is one of the structure, up to
    // a lattice vector.
    let member = family.at(&icosahedra);
    let is_same = |p: &[Number; 3], q: &[Number; 3]| {
        (0..3).all(|k| {
            let difference = &p[k] - &q[k];
            difference
                .to_rational()
                .is_some_and(|x| *x.denominator_ref() == 1)
        })
    };
    assert_eq!(member.vertices.len(), expected.vertices.len());
    for [x, y, z] in member.vertices.iter() {
        let point = [-x, -y, z];
        assert!(
            expected
                .vertices
                .iter()
                .any(|other| is_same(&point, &other)),
            "{point:?}"
        );
    }
}

#[test]
fn a_refutation_names_a_point() {
    let mut family = space("z-all");
    family.parameters[0].side = Side {
        low: End::closed(number("1")),
        high: End::closed(number("3")),
    };
    let error = examine(&family, &options(&["acute"]), &|_| {}).expect_err("a right angle at 3");
    let NotProvable::Refuted { point, findings } = error else {
        panic!("{error:?}");
    };
    assert_eq!(point, [number("3")]);
    assert!(findings.counts().contains_key("right-angle"));
    // Without the end the same is proved.
    family.parameters[0].side.high.is_open = true;
    assert!(examine(&family, &options(&["acute"]), &|_| {}).is_ok());
    // Bounds in degrees: at t = 1 the largest angle of Z is about 78.46, arccos(1/5) at t = 1.
    family.parameters[0].side.high = End::closed(number("5/4"));
    assert!(examine(&family, &options(&["dihedral<89"]), &|_| {}).is_ok());
    let error = examine(&family, &options(&["dihedral<75"]), &|_| {}).expect_err("too small");
    assert!(matches!(error, NotProvable::Refuted { .. }), "{error:?}");
}

#[test]
fn a_zero_on_a_facet_of_an_open_box_is_named() {
    let AnyFamily::Plane(mut family) = family("triangle-tiling-all") else {
        panic!("a family of tilings of the plane");
    };
    // No corner belongs to the box: x is open at both ends. At y = 0 the first basis vector is zero.
    let open = |n: &str| End::open(number(n));
    let side = |low, high| Side { low, high };
    family.parameters[0].side = side(open("1/4"), open("1/2"));
    family.parameters[1].side = side(End::closed(number("0")), End::closed(number("1")));
    let (x, y) = (Polynomial::parameter(0), Polynomial::parameter(1));
    let one = x.integer(1);
    let xy = x.times(&y);
    family.frame.gram = [
        [y.clone(), xy.clone()],
        [xy.clone(), one.minus(&y).plus(&xy)],
    ];
    let error = examine(&family, &options(&[]), &|_| {}).expect_err("no metric at y = 0");
    let NotProvable::Refuted { point, findings } = error else {
        panic!("{error:?}");
    };
    assert_eq!(point, [number("3/8"), number("0")]);
    assert!(findings.counts().contains_key("metric-not-positive"));
}

/// Rectangles with these squares of the sides, for t in [0, 1].
fn rectangles(square: &Polynomial) -> Family<2> {
    let AnyFamily::Plane(mut family) = family("triangle-tiling-all") else {
        panic!("a family of tilings of the plane");
    };
    family.parameters.truncate(1);
    family.parameters[0].side = Side {
        low: End::closed(number("0")),
        high: End::closed(number("1")),
    };
    let constant = |n: &str| Polynomial::constant(number(n));
    family.frame.gram = [
        [square.clone(), constant("0")],
        [constant("0"), constant("1")],
    ];
    family
}

#[test]
fn a_zero_inside_is_named_or_a_smaller_box_is_proved() {
    let t = Polynomial::parameter(0);
    let linear = t.times(&t.integer(3)).minus(&t.integer(1));
    let third = rectangles(&linear.times(&linear));
    let error = examine(&third, &options(&[]), &|_| {}).expect_err("no metric at 1/3");
    let NotProvable::Refuted { point, .. } = error else {
        panic!("{error:?}");
    };
    assert_eq!(point, [number("1/3")]);
    // 1 - 2 t² is zero at an irrational point, and its square does not change its sign there.
    let irrational = rectangles(&at_half_root().times(&at_half_root()));
    let error = examine(&irrational, &options(&[]), &|_| {}).expect_err("no metric at √2/2");
    let NotProvable::Refuted { point, findings } = error else {
        panic!("{error:?}");
    };
    assert_eq!(&point[0] * &point[0], number("1/2"));
    assert!(point[0].sign().is_gt());
    assert_eq!(
        findings.counts().keys().collect::<Vec<_>>(),
        [&"metric-not-positive"]
    );
    assert_eq!(
        point_in_words(&irrational.names(), &point),
        "x = 0.707106781..., a root of 2*x^2 - 1"
    );
}

/// 1 - 2 t²
fn at_half_root() -> Polynomial {
    let t = Polynomial::parameter(0);
    t.integer(1).minus(&t.times(&t).times(&t.integer(2)))
}

/// The angle of which the cosine is (1 - 2 t²)²/4 is right at √2/2 alone. So acute is false, and nonobtuse is true; a
/// zero inside cannot be proved to be none by Bernstein coefficients. 1 - 2 t² has the roots ±√2/2.
#[test]
fn an_irrational_zero_refutes_or_is_named() {
    let square = at_half_root().times(&at_half_root());
    let quarter = square.times(&Polynomial::constant(number("1/4")));
    let one = Polynomial::constant(number("1"));
    let mut family = rectangles(&one);
    family.frame.gram[0][1] = quarter.clone();
    family.frame.gram[1][0] = quarter;
    let error = examine(&family, &options(&["acute"]), &|_| {}).expect_err("a right angle");
    let NotProvable::Refuted { point, findings } = error else {
        panic!("{error:?}");
    };
    assert_eq!(&point[0] * &point[0], number("1/2"));
    assert!(findings.counts().contains_key("right-angle"));
    let error = examine(&family, &options(&["nonobtuse"]), &|_| {}).expect_err("a limit");
    let NotProvable::Declined(reason) = error else {
        panic!("{error:?}");
    };
    assert!(
        reason.starts_with("a sign vanishes at x = 0.707106781..., a root of 2*x^2 - 1, and"),
        "{reason}"
    );
    assert!(reason.contains("proved is the smaller box"), "{reason}");
    // A part of the box without the zero is proved, also next to it.
    family.parameters[0].side.high = End::closed(number("7/10"));
    assert!(examine(&family, &options(&["acute"]), &|_| {}).is_ok());
}

#[test]
fn a_search_ends_at_each_limit() {
    let t = Polynomial::parameter(0);
    let shifted = |n: i64| t.plus(&t.integer(n));
    let mut conditions = Conditions::default();
    conditions.add(Atom::positive(shifted(1)));
    conditions.add(Atom::positive(shifted(2)));
    let whole = (Rational::from(0), Rational::from(1));
    let cuboid = Cuboid::closed(&[whole]);
    let effort = |leaves, cost| Effort {
        leaves,
        cost,
        report: &|_, _| {},
    };
    let limit = |conditions: &Conditions, effort: &Effort| match grow(
        conditions,
        &cuboid,
        &Tree::Leaf,
        effort,
    ) {
        Ok(tree) => Ok(tree.leaves()),
        Err(NoTree::Undecided(_, limit)) => Err(limit),
        Err(NoTree::Violated(point)) => panic!("{point:?}"),
    };
    assert_eq!(limit(&conditions, &effort(1, 1000)), Ok(1));
    // The first look costs more than 1, and there is no other one.
    assert_eq!(limit(&conditions, &effort(1, 1)), Err(Limit::Cost));
    // (1 - 2 t²)² + 1/1000 has a negative Bernstein coefficient on [0, 1], and needs some parts.
    let quadratic = t.integer(1).minus(&t.times(&t).times(&t.integer(2)));
    let least = Polynomial::constant(number("1/1000"));
    let mut narrow = Conditions::default();
    narrow.add(Atom::positive(quadratic.times(&quadratic).plus(&least)));
    assert_eq!(limit(&narrow, &effort(1, 1000)), Err(Limit::Leaves));
    assert!(limit(&narrow, &effort(100, 1_000_000)).is_ok_and(|leaves| leaves > 1));
}

#[test]
fn a_parameter_is_not_named_like_the_generator() {
    let mut family = space("c14-all");
    family.parameters[0].name = "a".to_owned();
    assert!(family.check().is_ok());
    family.frame.field = Field::adjoin_root(
        &[-3, 0, 1].map(malachite::Integer::from),
        Rational::from(1),
        Rational::from(2),
    )
    .expect("a field")
    .0;
    let error = family.check().expect_err("a is √3");
    assert!(error.to_string().contains("choose another name"));
}

#[test]
fn free_vertices_and_metric() {
    let Ok(AnyTiling::Space(a15)) = catalog::build("a15") else {
        panic!("a tiling of space");
    };
    let near = Rational::from_signeds(1, 1000);
    let vertex = free::family(&a15, &[free::Free::Vertex(0)], &near).expect("a family");
    assert_eq!(vertex.names(), ["x0", "y0", "z0"]);
    assert!(examine(&vertex, &options(&["acute"]), &|_| {}).is_ok());
    let far = Rational::from_signeds(1, 4);
    let vertex = free::family(&a15, &[free::Free::Vertex(0)], &far).expect("a family");
    let error = examine(&vertex, &options(&["acute"]), &|_| {}).expect_err("too far");
    assert!(matches!(error, NotProvable::Refuted { .. }), "{error:?}");
    assert!(free::family(&a15, &[free::Free::Vertex(1000)], &near).is_err());
    let gram = free::family(&a15, &[free::Free::Gram], &near).expect("a family");
    assert_eq!(gram.names(), ["g12", "g13", "g22", "g23", "g33"]);
    assert!(examine(&gram, &options(&["acute"]), &|_| {}).is_ok());
    // A15 with the Gram matrix diag(16, 16, 16 t) is acute for 2/5 < t < 16/5 only; 6 < 16 · 2/5.
    let wide = free::family(&a15, &[free::Free::Gram], &Rational::from(10)).expect("a family");
    let error = examine(&wide, &options(&["acute"]), &|_| {}).expect_err("too wide");
    assert!(matches!(error, NotProvable::Refuted { .. }), "{error:?}");
}

/// The triangle tiling is acute exactly for x and y between 0 and 1. A box that is proved lies inside, and
/// one that cannot be moved out by 1/16 of a side reaches that near to each end.
#[test]
fn largest_boxes_in_several_parameters() {
    let AnyFamily::Plane(triangles) = family("triangle-tiling-all") else {
        panic!("a family of the plane");
    };
    let fraction = Rational::from_signeds(1, 16);
    for point in [["1/2", "1/3"], ["1/10", "9/10"]] {
        let point = point.map(number);
        let (found, cuboid) = maximal(&triangles, &point, &options(&["acute"]), &fraction)
            .unwrap_or_else(|error| panic!("{error:?}"));
        assert!(
            matches!(found, Maximal::Box(ref grown) if *grown == fraction),
            "{found:?}"
        );
        let grown = triangles.with_box(&cuboid);
        assert!(examine(&grown, &options(&["acute"]), &|_| {}).is_ok());
        assert_eq!(grown.parameters.len(), 2);
        for (parameter, value) in grown.parameters.iter().zip(&point) {
            let Side { low, high } = &parameter.side;
            assert!(low.value <= *value && *value <= high.value, "{parameter:?}");
            assert!(
                low.value >= number("0") && high.value <= number("1"),
                "{parameter:?}"
            );
            let step = (&high.value - &low.value) * Number::from(fraction.clone());
            assert!(&low.value - &step <= number("0"), "{parameter:?}");
            assert!(&high.value + &step >= number("1"), "{parameter:?}");
        }
    }
}

#[test]
fn a_claim_in_words() {
    let family = space("z-all");
    let proof = examine(&family, &options(&[]), &|_| {}).expect("a proof");
    let certificate = transcribe::family::to_certificate(&family, &proof);
    let claim = format::family::certificate(&certificate)
        .expect("a certificate")
        .claim;
    let words = transcribe::family::claim_in_words(&claim, family.len()).expect("words");
    assert!(
        words.starts_with("for all t in (1/2, 3): three-space is tiled face to face by "),
        "{words}"
    );
    assert!(words.contains("all dihedral angles are acute"), "{words}");
}

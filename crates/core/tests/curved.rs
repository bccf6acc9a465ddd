//! Triangles and tetrahedra of second order: the Jacobian, against hand calculations.

use acutile_core::curved::{Element, Validity, coefficients};
use malachite::Rational;

/// The unit tetrahedron with its middle nodes.
fn straight() -> [[f64; 3]; 10] {
    let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let middle = |a: usize, b: usize| -> [f64; 3] {
        std::array::from_fn(|k| (corners[a][k] + corners[b][k]) / 2.0)
    };
    let [a, b, c, d] = corners;
    [
        a,
        b,
        c,
        d,
        middle(0, 1),
        middle(1, 2),
        middle(0, 2),
        middle(0, 3),
        middle(1, 3),
        middle(2, 3),
    ]
}

/// For x = λ the Jacobian is 1 everywhere, in each of the 20 coefficients.
#[test]
fn a_straight_element_has_a_constant_jacobian() {
    let exact = straight().map(|node| node.map(|x| Rational::try_from(x).expect("finite")));
    let coefficients = coefficients(&exact);
    assert_eq!(coefficients.len(), 20);
    assert!(coefficients.values().all(|c| *c == 1));
    assert_eq!(Element::Tetrahedron(straight()).validity(), Validity::Valid);
}

/// Moving the node on the edge 01 from (1/2, 0, 0) to (t, 0, 0) makes x_1 = λ_1 + (4 t - 2) λ_0 λ_1
/// with the derivative 1 + (4 t - 2)(λ_0 - λ_1) along the edge, which is 3 - 4 t at corner 1.
#[test]
fn a_middle_node_at_three_quarters_is_the_limit() {
    let with = |t: f64| {
        let mut nodes = straight();
        nodes[4][0] = t;
        Element::Tetrahedron(nodes).validity()
    };
    assert_eq!(with(0.7), Validity::Valid);
    let zero = Rational::from(0);
    let invalid = |jacobian| Validity::Invalid {
        corner: 1,
        jacobian,
    };
    assert_eq!(with(0.75), invalid(zero));
    assert_eq!(with(1.0), invalid(Rational::from(-1)));
}

/// The unit triangle with middle nodes on the edges 01 and 02.
fn triangle(first: [f64; 2], last: [f64; 2]) -> [[f64; 2]; 6] {
    [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], first, [0.5, 0.5], last]
}

#[test]
fn a_straight_triangle_has_a_constant_jacobian() {
    let nodes = triangle([0.5, 0.0], [0.0, 0.5]);
    let exact = nodes.map(|node| node.map(|x| Rational::try_from(x).expect("finite")));
    let coefficients = coefficients(&exact);
    assert_eq!(coefficients.len(), 6);
    assert!(coefficients.values().all(|c| *c == 1));
    assert_eq!(Element::Triangle(nodes).validity(), Validity::Valid);
}

/// As for the tetrahedron, the Jacobian is 3 - 4 t at corner 1.
#[test]
fn three_quarters_is_the_limit_for_a_triangle() {
    let with = |t: f64| Element::Triangle(triangle([t, 0.0], [0.0, 0.5])).validity();
    assert_eq!(with(0.7), Validity::Valid);
    let invalid = |jacobian| Validity::Invalid {
        corner: 1,
        jacobian,
    };
    assert_eq!(with(0.75), invalid(Rational::from(0)));
    assert_eq!(with(1.0), invalid(Rational::from(-1)));
}

/// With middle nodes (1/2, u) and (v, 1/2) the Jacobian is (1 - 4 v λ_2)(1 - 4 u λ_1) - 16 u v (λ_0 - λ_2)
/// (λ_0 - λ_1). Its coefficients are 1 - 16 u v, 1 - 4 u, 1 - 4 v at the corners, and 1 - 2 u + 8 u v,
/// 1 - 2 u - 2 v, 1 - 2 v + 8 u v on the edges 01, 12, 02.
#[test]
fn a_triangle_with_a_negative_coefficient_is_undecided() {
    let nodes = triangle([0.5, -0.5], [0.1875, 0.5]);
    let exact = nodes.map(|node| node.map(|x| Rational::try_from(x).expect("finite")));
    let found = coefficients(&exact);
    let eighths = |n: i32| Rational::from(n) / Rational::from(8);
    for (key, expected) in [
        ([0, 0], 20),
        ([1, 1], 24),
        ([2, 2], 2),
        ([0, 1], 10),
        ([1, 2], 13),
        ([0, 2], -1),
    ] {
        assert_eq!(found[&key], eighths(expected), "{key:?}");
    }
    assert_eq!(
        Element::Triangle(nodes).validity(),
        Validity::Undecided {
            coefficient: eighths(-1)
        }
    );
}

/// Far from the origin, doubles cannot decide: the exact numbers do.
#[test]
fn a_small_triangle_far_away_is_decided_exactly() {
    let far = |t: f64| {
        let nodes = triangle([t, 0.0], [0.0, 0.5]);
        let moved = nodes.map(|[x, y]| [x + 1048576.0, y - 1048576.0]);
        Element::Triangle(moved).validity()
    };
    assert_eq!(far(0.625), Validity::Valid);
    assert_eq!(
        far(0.75),
        Validity::Invalid {
            corner: 1,
            jacobian: Rational::from(0)
        }
    );
}

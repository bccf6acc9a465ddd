//! Tetrahedra of second order: the Jacobian, against hand calculations.

use acutile_core::curved::{Nodes, Validity, coefficients, validity};
use malachite::Rational;

/// The unit tetrahedron with its middle nodes.
fn straight() -> Nodes {
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
    assert_eq!(validity(&straight()), Validity::Valid);
}

/// Moving the node on the edge 01 from (1/2, 0, 0) to (t, 0, 0) makes x_1 = λ_1 + (4 t - 2) λ_0 λ_1
/// with the derivative 1 + (4 t - 2)(λ_0 - λ_1) along the edge, which is 3 - 4 t at corner 1.
#[test]
fn a_middle_node_at_three_quarters_is_the_limit() {
    let with = |t: f64| {
        let mut nodes = straight();
        nodes[4][0] = t;
        validity(&nodes)
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

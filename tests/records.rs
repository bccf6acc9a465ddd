//! `acutile records`: certified values, the literature, lower bounds.

use crate::common::{acutile, code, stderr, stdout};
use serde_json::Value;

/// The values of the cube and the dodecahedron, 86.7531 and 81.4031, are those of prototypes in another
/// language. The values of C14, 74.147706, and of the slab, 77.336565, are optima; the catalogue's rational
/// coordinates come near. Each digest is that of the certificate that `certify` writes.
#[test]
fn values_come_from_certificates() {
    let run = acutile(["records", "--json"]);
    assert_eq!(code(&run), 0, "{}", stderr(&run));
    let table: Value = serde_json::from_str(&stdout(&run)).expect("JSON");
    let row = |domain: &str| {
        let rows = table["records"].as_array().expect("rows").iter();
        let mut rows = rows.filter(|row| row["domain"] == domain);
        rows.next().unwrap_or_else(|| panic!("{domain}")).clone()
    };
    let degrees = |domain: &str, end: usize| -> f64 {
        let text = row(domain)["best"]["largest_dihedral"][end].clone();
        text.as_str()
            .expect("a decimal")
            .parse()
            .expect("a decimal")
    };
    assert!(degrees("cube", 1) <= 86.80 && degrees("cube", 0) >= 86.753);
    assert!(degrees("regular dodecahedron", 1) <= 81.41);
    assert!(degrees("space", 1) <= 74.1478 && degrees("space", 0) >= 74.147706);
    assert!(degrees("slab", 1) <= 77.34 && degrees("slab", 0) >= 77.336565);
    assert!(degrees("regular tetrahedron", 1) <= 85.81);
    assert!(degrees("regular octahedron", 1) <= 87.10);
    let bound = row("space")["lower_bound"]["statement"].clone();
    assert!(bound.as_str().expect("a sentence").contains("73.31°"));
    let name = row("regular dodecahedron")["best"]["name"].clone();
    let certified = acutile(["certify", name.as_str().expect("a name"), "--json"]);
    let certified: Value = serde_json::from_str(&stdout(&certified)).expect("JSON");
    assert_eq!(
        certified["certificate"]["sha256"],
        row("regular dodecahedron")["best"]["sha256"]
    );
}

//! Square/triangle tilings of the plane: inflation, files, refusals.

use acutile_catalog::{
    CatalogError, build_over, plane_file::PlaneDocument, plane_tiling, plane_tiling::PlaneTiling,
};
use acutile_core::tiling::AnyTiling;

#[test]
fn inflation_gives_hundreds_of_points() {
    let sizes = [
        plane_tiling::triangles(),
        plane_tiling::squares(),
        plane_tiling::snub(),
    ]
    .map(|plane| plane.inflated().point_set().unwrap().points.len());
    assert!(sizes[0] >= 90 && sizes[2] >= 400, "{sizes:?}");
    // The area grows by (2 + sqrt 3)² = 7 + 4 sqrt 3: a triangle, sqrt 3/4, becomes 7 triangles
    // and 3 squares, so Z's two triangles become 14 and 6: 49 + 48 points.
    assert_eq!(sizes[0], 97);
}

#[test]
fn what_is_no_square_triangle_tiling_is_refused() {
    let mut holed = plane_tiling::rhombitrihexagonal();
    holed.vertices.remove(0);
    assert!(matches!(
        holed.structure(),
        Err(CatalogError::NotSquareTriangle { angle: 120, .. })
    ));
    let mut flat = plane_tiling::squares();
    flat.lattice[1] = [3, 0, 0, 0];
    assert!(flat.structure().is_err());
    // Two square grids, moved against each other by 5 z.
    let mut twice = plane_tiling::squares();
    twice.vertices.push([0, 5, 0, 0]);
    assert!(matches!(
        twice.structure(),
        Err(CatalogError::NotACover {
            triangles: 0,
            squares: 2
        })
    ));
}

/// The square tiling as a file; zeta^3 is perpendicular to 1.
const SQUARES: &str = r#"{"format": "acutile-plane-tiling", "version": 1,
    "lattice": [[1, 0, 0, 0], [0, 0, 0, 1]], "vertices": [[0, 0, 0, 0]]}"#;

fn built_from(text: &str) -> Result<AnyTiling, CatalogError> {
    let document: PlaneDocument =
        serde_json::from_str(text).map_err(|error| CatalogError::File(error.to_string()))?;
    build_over(
        "square-triangle:plane.json",
        &PlaneTiling::try_from(document)?,
    )
}

#[test]
fn a_plane_tiling_file_gives_a15() {
    assert!(matches!(built_from(SQUARES), Ok(AnyTiling::Space(tiling)) if tiling.len() == 46));
}

proptest::proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig::with_cases(128))]

    #[test]
    fn changed_plane_tiling_files_never_panic(
        changes in proptest::collection::vec((proptest::prelude::any::<proptest::sample::Index>(), "[ -~]"), 1..4),
    ) {
        let mut text = SQUARES.as_bytes().to_vec();
        for (index, character) in &changes {
            let place = index.index(text.len());
            text[place] = character.as_bytes()[0];
        }
        let _ = built_from(&String::from_utf8_lossy(&text));
    }

    #[test]
    fn random_plane_tilings_never_panic(
        numbers in proptest::collection::vec(-3i64..4, 16),
    ) {
        let rows: Vec<String> = numbers.chunks(4).map(|row| format!("{row:?}")).collect();
        let text = format!(
            r#"{{"format": "acutile-plane-tiling", "version": 1, "lattice": [{}, {}], "vertices": [{}, {}]}}"#,
            rows[0], rows[1], rows[2], rows[3]
        );
        let _ = built_from(&text);
    }
}

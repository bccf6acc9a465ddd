//! Statements about all members of a construction, and their rows of the table.

use acutile_paper::paper::{Verdict, rows};
use acutile_paper::survey::{General, Survey};
use acutile_paper::table::Row;

/// The rows about constructions cite a certificate that states them.
#[test]
fn rows_are_proved_for_all() {
    let survey = Survey::of(&[]);
    let rows = rows(&survey);
    let cited = |id: &str| -> Vec<String> {
        let row = rows.iter().find(|row| row.id == id).expect("a row");
        assert_eq!(row.verdict, Verdict::ProvedForAll, "{row}");
        row.certificates
            .iter()
            .map(|(name, _)| name.clone())
            .collect()
    };
    assert_eq!(cited("goldberg-sides"), ["goldberg-1-all"]);
    assert_eq!(
        cited("acute-triangles-tile-the-plane"),
        ["triangle-tiling-all"]
    );
    assert_eq!(cited("delaunay"), ["square-triangle-all"]);
    assert_eq!(cited("tcp/square-triangle"), ["square-triangle-all"]);
    assert_eq!(cited("tcp-acute"), ["square-triangle-all", "kagome-all"]);
    assert_eq!(cited("lemma-4-acute"), ["two-corners-all"]);
    assert_eq!(cited("lemma-4-not-delaunay"), ["two-corners-all"]);
    assert_eq!(cited("slab-heights"), ["slab-all"]);
    assert_eq!(cited("slab-stretch"), ["slab-stretch-all"]);
    // The printed row names the certificate, whose SHA-256 is that of the proved family.
    let row = rows
        .iter()
        .find(|row| row.id == "slab-heights")
        .expect("a row");
    let hash = General::of_entry("slab-all").expect("proved").certificate;
    assert!(
        row.to_string()
            .contains(&format!("slab-all, SHA-256 {hash}")),
        "{row}"
    );
}

/// By hand: squares of Z stretched by t in (1/2, 3) have right angles at both ends, so the largest angles
/// come near 90 degrees. Acute triangles have largest angles from 60 to 90 degrees, and smallest ones from 0
/// to 60; the equilateral triangle has both.
#[test]
fn figures_over_a_box() {
    let row = Row::of_general("z-all").expect("a row");
    let form = |figure: &Option<acutile_paper::table::Figure>| {
        figure.as_ref().and_then(|f| f.closed_form.clone())
    };
    assert_eq!(form(&row.figures[2].1).as_deref(), Some("90"));
    let row = Row::of_general("triangle-tiling-all").expect("a row");
    let bounds = |figure: &Option<acutile_paper::table::Figure>| {
        figure.as_ref().expect("a bound").bounds.clone()
    };
    assert_eq!(bounds(&row.figures[2].1).1, 90);
    let (low, high) = bounds(&row.figures[2].0);
    assert!(low <= 60 && 60 <= high, "{low} {high}");
    let (low, high) = bounds(&row.figures[1].1);
    assert!(low <= 60 && 60 <= high, "{low} {high}");
    assert_eq!(bounds(&row.figures[1].0).0, 0);
}

/// The largest angle is arccos(1/5), as the theorem states; the smallest of A15 is arccos(3/5) = 53.13.
#[test]
fn figures_over_all_mosaics() {
    let row = Row::of_general("square-triangle-all").expect("a row");
    let forms: Vec<Option<String>> = row
        .figures
        .iter()
        .flat_map(|(min, max)| [min, max])
        .map(|figure| figure.as_ref().and_then(|f| f.closed_form.clone()))
        .collect();
    assert_eq!(forms[5].as_deref(), Some("arccos(1/5)"));
    assert_eq!(forms[2].as_deref(), Some("arccos(3/5)"));
    assert!(Row::of_general("kagome-all").is_ok());
}

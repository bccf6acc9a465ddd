//! Pages of families and systems of patches beyond `acutile report NAME`: those of `certify`, of certificates that are rejected, and of
//! families that are refuted.

use crate::answers::FAMILY;
use crate::common::{acutile, code, file, stderr, stdout};
use crate::report::data;
use serde_json::json;

/// `certify --report` shows what `report` shows.
#[test]
fn certify_has_pages_of_families_and_systems_of_patches() {
    let directory = tempfile::tempdir().expect("a directory");
    let target = directory.path().join("page.html");
    let target = target.to_str().expect("UTF-8");
    let output = acutile(["certify", "z-all", "kagome-all", "--report", target]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let page = std::fs::read_to_string(target).expect("a page");
    assert!(page.contains("For all t in (1/2, 3): three-space is tiled face to face"));
    assert!(page.contains("Over every division of the line into moved copies of 3 segments"));
}

/// The middle of the box 2/5 < t < 16/5 is 9/5.
#[test]
fn a_certificate_of_a_family_that_the_kernel_rejects_has_a_page() {
    let directory = tempfile::tempdir().expect("a directory");
    let certificate = std::fs::read_to_string("certificates/a15-all.json").expect("a15-all");
    let start = certificate.find("\"simplices\":[").expect("simplices");
    let (head, rows) = certificate.split_at(start);
    let text = format!("{head}{}", rows.replacen("[3,-1,-1,-1]", "[3,-1,-1,0]", 1));
    assert_ne!(text, certificate);
    let path = file(directory.path(), "false.json", &text);
    let output = acutile(["report", path.to_str().expect("UTF-8")]);
    assert_eq!(code(&output), 1, "{}", stderr(&output));
    assert!(
        stderr(&output).contains("rejected ["),
        "{}",
        stderr(&output)
    );
    let page = stdout(&output);
    assert!(page.contains("Not proved"));
    assert!(!page.contains("What is proved"));
    assert!(page.contains("The picture shows the member of the family at t = 9/5."));
    let data = data(&page);
    assert_eq!(data["tilings"][0]["simplices"], json!(46));
    // The page's own verifier has the certificate to refuse.
    assert_eq!(data["tilings"][0]["certificate"], json!(text));
}

/// With y from -1/2 to 1 the Gram matrix [[y, x y], [x y, 1 - y + x y]] has the entry 0 at y = 0.
#[test]
fn a_family_that_is_refuted_has_a_page_of_a_member() {
    let directory = tempfile::tempdir().expect("a directory");
    let wrong = FAMILY.replace("\"y\": {\"low\": 0", "\"y\": {\"low\": \"-1/2\"");
    assert_ne!(wrong, FAMILY);
    let path = file(directory.path(), "wrong.json", &wrong);
    let path = path.to_str().expect("UTF-8");
    let target = directory.path().join("page.html");
    let target = target.to_str().expect("UTF-8");
    for arguments in [
        ["report", path, "-o", target],
        ["certify", path, "--report", target],
    ] {
        let output = acutile(arguments);
        assert_eq!(code(&output), 1, "{}", stderr(&output));
        let page = std::fs::read_to_string(target).expect("a page");
        std::fs::remove_file(target).expect("removed");
        assert!(page.contains("Refuted: 1 metric-not-positive."));
        assert!(page.contains("The picture shows the member of the family at x = 1/2, y = 0."));
        assert!(!page.contains("What is proved"));
    }
    for command in ["appendix", "bundle"] {
        let output = acutile([command, path, "-o", target]);
        assert_ne!(code(&output), 0, "{command}");
    }
}

//! `acutile report`: what is in a page, and what never comes into one.

use crate::common::{acutile, code, file, kuhn, stderr, stdout};
use acutile_core::checker::Options;
use acutile_core::proved::prove;
use acutile_core::tiling::AnyTiling;
use acutile_core::{format, transcribe};
use serde_json::{Value, json};

/// The text of the page for these inputs.
fn page(inputs: &[&str]) -> String {
    let output = acutile(["report"].iter().chain(inputs));
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    stdout(&output)
}

/// The data that the page's program reads.
pub fn data(page: &str) -> Value {
    let start = page.find("id=\"data\">").expect("data") + "id=\"data\">".len();
    let end = page[start..].find("</script>").expect("its end");
    serde_json::from_str(&page[start..start + end]).expect("JSON")
}

#[test]
fn the_certificate_in_the_page_is_the_file_byte_for_byte() {
    for name in ["sigma", "slab", "square-10", "two-corners"] {
        let certificate = std::fs::read_to_string(format!("certificates/{name}.json")).expect(name);
        let data = data(&page(&[name]));
        assert_eq!(data["tilings"][0]["certificate"], json!(certificate));
        let from_file = data_of_file(name);
        assert_eq!(
            from_file["tilings"][0]["cells"],
            data["tilings"][0]["cells"]
        );
        assert_eq!(
            from_file["tilings"][0]["sha256"],
            data["tilings"][0]["sha256"]
        );
    }
}

fn data_of_file(name: &str) -> Value {
    data(&page(&[&format!("certificates/{name}.json")]))
}

#[test]
fn pages_are_small_and_name_no_other_host() {
    let page = page(&["sigma"]);
    assert!(page.len() < 1_500_000, "{} bytes", page.len());
    assert!(page.contains("default-src 'none'"));
    // The only addresses are names of XML vocabularies, which nothing loads.
    for (at, _) in page.match_indices("http") {
        let rest = &page[at..];
        let names = [
            "http://www.w3.org/2000/svg",
            "http://www.w3.org/1998/Math/MathML",
            "http://schemas.microsoft.com/3dmanufacturing/",
            "http://schemas.openxmlformats.org/package/2006/",
        ];
        let is_name = names.iter().any(|name| rest.starts_with(name));
        let is_meta = rest.starts_with("http-equiv");
        assert!(is_name || is_meta, "{}", &rest[..60.min(rest.len())]);
    }
    for loading in ["src=", "@import", "url(", "<link rel=\"stylesheet\""] {
        let markup = page.split("<script").next().expect("markup");
        assert!(!markup.contains(loading), "{loading}");
    }
}

/// Table 1 of the paper for A15: largest dihedral angle between 73.40 and 78.46 degrees,
/// smallest between 53.13 and 67.79, hence cosines 2/7 … 1/5 and 3/5 … √(1/7).
#[test]
fn exact_values_of_a15() {
    let page = page(&["a15"]);
    for text in [
        "cos = <math alttext=\"1/5\">",
        "cos = <math alttext=\"2/7\">",
        "√(125/256)",
        "√(5/12)",
        "√(1/2)",
        "1/48",
        "3/128",
    ] {
        assert!(page.contains(text), "{text}");
    }
    let data = data(&page);
    let tiling = &data["tilings"][0];
    assert_eq!(tiling["typeNames"], json!(["Z12", "Z14"]));
    assert_eq!(tiling["cells"].as_array().expect("cells").len(), 46);
    let cosines: Vec<&str> = tiling["angles"]
        .as_array()
        .expect("angles")
        .iter()
        .filter_map(|angle| angle["cosine"].as_str())
        .collect();
    assert!(
        cosines.contains(&"3/5") && cosines.contains(&"√(1/7)"),
        "{cosines:?}"
    );
}

/// z-all: t in (1/2, 3), with right angles at both ends (docs/families.md).
#[test]
fn pages_of_families_and_systems_of_patches() {
    for name in ["z-all", "kagome-all"] {
        let certificate = std::fs::read_to_string(format!("certificates/{name}.json")).expect(name);
        let page = page(&[name]);
        assert!(page.len() < 1_000_000, "{name}: {} bytes", page.len());
        assert_eq!(
            data(&page)["tilings"][0]["certificate"],
            json!(certificate),
            "{name}"
        );
    }
    let family = page(&["z-all"]);
    assert!(family.contains("For all t in (1/2, 3): three-space is tiled face to face"));
    assert!(family.contains("The box is not cut"));
    assert!(
        family.contains("90.000000°"),
        "the supremum is a right angle"
    );
    assert_eq!(data(&family)["tilings"][0]["kind"], json!("family"));
    let system = page(&["kagome-all"]);
    assert!(system.contains("Over every division of the line into moved copies of 3 segments"));
    assert!(system.contains("Tile 0, letter z: a segment"));
    assert_eq!(data(&system)["tilings"][0]["letters"], json!("z+-"));
}

#[test]
fn hostile_names_are_text() {
    let directory = tempfile::tempdir().expect("a directory");
    let mut tiling = kuhn();
    tiling["name"] = json!("</script><script>alert(1)</script>{{data}}");
    tiling["description"] = json!("<!-- \"'&\u{2028}\u{0}");
    let path = file(directory.path(), "a<b>&\"'.json", &tiling.to_string());
    let page = page(&[path.to_str().expect("UTF-8")]);
    assert!(!page.contains("<script>alert"));
    assert!(page.contains("&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;{{data}}"));
    assert!(!page.contains("<!--") && !page.contains('\u{0}'));
    // the first line, data and program
    assert_eq!(
        page.matches("<script").count(),
        page.matches("</script>").count()
    );
    assert_eq!(page.matches("</script>").count(), 3);
    assert!(!page.contains("a<b>"));
    assert_eq!(data(&page)["tilings"][0]["name"], json!("a<b>&\"'"));
}

#[test]
fn what_the_kernel_refuses_is_on_no_page_as_proved() {
    let directory = tempfile::tempdir().expect("a directory");
    let target = directory.path().join("page.html");
    let certificate = std::fs::read_to_string("certificates/a15.json").expect("a15");
    let head = certificate.find("\"witness\"").expect("a witness");
    let (claim, witness) = certificate.split_at(head);
    let moved = format!("{claim}{}", witness.replacen("[0,0,2]", "[0,0,1]", 1));
    let future = certificate.replacen("\"version\":2", "\"version\":7", 1);
    let cases = [
        ("false.json", moved, 1, "rejected ["),
        (
            "malformed.json",
            format!(" {certificate}"),
            2,
            "malformed [canonical]",
        ),
        ("future.json", future, 3, "declined [version]"),
        (
            "half.json",
            certificate[..300].to_owned(),
            2,
            "malformed [json]",
        ),
    ];
    for (name, text, expected, words) in cases {
        assert_ne!(text, certificate);
        let path = file(directory.path(), name, &text);
        let output = acutile([
            "report".as_ref(),
            "a15".as_ref(),
            path.as_os_str(),
            "-o".as_ref(),
            target.as_os_str(),
        ]);
        assert_eq!(code(&output), expected, "{name}: {}", stderr(&output));
        assert!(
            stderr(&output).contains(words),
            "{name}: {}",
            stderr(&output)
        );
        // A claim that is false has a page that says so. A file that cannot be read has none.
        assert_eq!(target.exists(), expected == 1, "{name}");
        if expected == 1 {
            let page = std::fs::read_to_string(&target).expect("a page");
            assert!(page.contains("Not proved"), "{name}");
            std::fs::remove_file(&target).expect("removed");
        }
    }
}

#[test]
fn a_false_tiling_is_on_no_page_of_proofs() {
    let directory = tempfile::tempdir().expect("a directory");
    let mut tiling = kuhn();
    tiling["simplices"].as_array_mut().expect("simplices").pop();
    let path = file(directory.path(), "hole.json", &tiling.to_string());
    let output = acutile(["report", path.to_str().expect("UTF-8")]);
    assert_eq!(code(&output), 1, "{}", stderr(&output));
    assert!(stderr(&output).contains("refuted"));
    assert!(!stdout(&output).contains("What is proved"));
    for command in ["appendix", "bundle"] {
        let target = directory.path().join(command);
        let output = acutile([
            command.as_ref(),
            path.as_os_str(),
            "-o".as_ref(),
            target.as_os_str(),
        ]);
        assert_eq!(code(&output), 1, "{}", stderr(&output));
        assert!(!target.exists());
    }
}

#[test]
fn a_page_does_not_replace_its_input() {
    let directory = tempfile::tempdir().expect("a directory");
    let path = file(directory.path(), "kuhn.json", &kuhn().to_string());
    let output = acutile([
        "report".as_ref(),
        path.as_os_str(),
        "-o".as_ref(),
        path.as_os_str(),
    ]);
    assert_eq!(code(&output), 2);
    assert!(stderr(&output).contains("would overwrite"));
    let text = std::fs::read_to_string(&path).expect("it is there");
    assert_eq!(text, kuhn().to_string());
}

/// A certificate in a file that bears a construction's name is not presented as that.
#[test]
fn file_names_promise_nothing() {
    let directory = tempfile::tempdir().expect("a directory");
    let bcc = std::fs::read_to_string("certificates/bcc.json").expect("bcc");
    let path = file(directory.path(), "sigma.json", &bcc);
    let page = page(&[path.to_str().expect("UTF-8")]);
    assert!(!page.contains("TCP structure sigma"));
    assert!(page.contains("as a file of this name has it"));
}

/// A tiling whose text speaks of certificates is none.
#[test]
fn a_tiling_file_is_known_by_its_format() {
    let directory = tempfile::tempdir().expect("a directory");
    let mut tiling = kuhn();
    tiling["description"] = json!("not an \"acutile-certificate\"");
    let path = file(directory.path(), "kuhn.json", &tiling.to_string());
    assert!(page(&[path.to_str().expect("UTF-8")]).contains("6 tetrahedra"));
}

/// The tiling read from a certificate, proved again, gives the certificate.
#[test]
fn certificates_are_read_back() {
    let mut read = 0;
    for entry in std::fs::read_dir("certificates").expect("certificates") {
        let path = entry.expect("an entry").path();
        let json = std::fs::read(&path).expect("it can be read");
        if json.len() > 12_000 {
            continue;
        }
        let cbor = format::to_cbor(&json).expect("a certificate");
        if format::kind(&cbor) != Some(format::KIND) {
            continue;
        }
        let (tiling, _) = transcribe::of_certificate(&cbor).expect("its tiling");
        let again = match &tiling {
            AnyTiling::Plane(tiling) => prove(tiling, &Options::default(), &|_| {}),
            AnyTiling::Space(tiling) => prove(tiling, &Options::default(), &|_| {}),
        };
        assert_eq!(
            again.expect("proved").certificate(),
            &cbor[..],
            "{}",
            path.display()
        );
        read += 1;
    }
    assert!(read >= 30, "{read} certificates");
}

/// Certificates that are wrong are tilings that are wrong, or errors; nothing panics.
#[test]
fn wrong_certificates_are_read_or_not() {
    let (mut read, mut refused) = (0, 0);
    for folder in ["malformed", "false", "declined", "cbor"] {
        for entry in std::fs::read_dir(format!("tests/certificates/{folder}")).expect(folder) {
            let bytes = std::fs::read(entry.expect("an entry").path()).expect("it can be read");
            let Ok(cbor) = format::to_cbor(&bytes) else {
                continue;
            };
            match transcribe::of_certificate(&cbor) {
                Ok(_) => read += 1,
                Err(error) => {
                    assert!(!error.to_string().is_empty());
                    refused += 1;
                }
            }
        }
    }
    assert!(read > 200 && refused > 20, "{read} read, {refused} refused");
}

#[test]
fn several_tilings_and_what_is_missing() {
    let page = page(&["equilateral", "slab", "cube-corner"]);
    let data = data(&page);
    let ranks: Vec<&Value> = data["tilings"]
        .as_array()
        .expect("tilings")
        .iter()
        .map(|tiling| &tiling["rank"])
        .collect();
    assert_eq!(ranks, [&json!(2), &json!(2), &json!(0)]);
    for index in 0..3 {
        assert!(page.contains(&format!("href=\"#tiling-{index}\"")));
        assert!(page.contains(&format!("id=\"tiling-{index}\"")));
    }
    let output = acutile(["report", "no-such-tiling"]);
    assert_eq!(code(&output), 2);
}

/// Three tetrahedra on one facet: two of them overlap, and the facet is used three times.
#[test]
fn a_refuted_mesh_has_a_page_with_its_defects() {
    let mesh = "tests/meshes/cases/three_on_a_facet.msh";
    let output = acutile(["report", mesh]);
    assert_eq!(code(&output), 1);
    assert!(stderr(&output).contains("refuted: "), "{}", stderr(&output));
    let text = stdout(&output);
    let data = data(&text);
    let defects = data["tilings"][0]["defects"].as_array().expect("defects");
    let overused: Vec<&Value> = defects
        .iter()
        .filter(|defect| defect["facets"].as_array().is_some_and(|f| f.len() == 3))
        .collect();
    assert_eq!(overused.len(), 1);
    assert_eq!(overused[0]["simplices"], json!([0, 1, 2]));
    assert!(text.contains("class=\"verdict bad\">Refuted: "));
    assert!(!text.contains("Confirmed by the kernel"));
    let path = std::env::temp_dir().join(format!("acutile-refuted-{}.html", std::process::id()));
    let certify = acutile(["certify", mesh, "--report", path.to_str().expect("a path")]);
    assert_eq!(code(&certify), 1);
    let written = std::fs::read_to_string(&path).expect("the page");
    std::fs::remove_file(&path).expect("remove");
    assert_eq!(written, text);
}

//! Tiling files that are read, and files that are refused, with the message. Also the checker's answers
//! about tilings with one fault each.

use crate::kuhn::kuhn;
use acutile_core::checker::{Defect, Findings, Options, examine};
use acutile_core::format;
use acutile_core::proved::prove;
use acutile_core::quality::{DihedralAngle, RadiusEdge};
use acutile_core::statement::{Relation, Requirement, Statement};
use acutile_core::tiling::{AnyTiling, SimplexId, VertexId};
use acutile_core::with_dimension;
use acutile_exact::number::{Number, parse_rational};
use acutile_io::import::{Content, read_bytes, read_native, read_text};
use serde_json::{Value, json};

fn tiling(document: &Value) -> AnyTiling {
    match read_native(&document.to_string()).map(|file| file.content) {
        Ok(Content::Tiling(tiling)) => tiling,
        Ok(_) => panic!("no tiling"),
        Err(error) => panic!("{error}"),
    }
}

/// The statements that are proved, or what is wrong.
fn judge(document: &Value, required: &[Requirement]) -> Result<Vec<Statement>, Findings> {
    let options = Options {
        required: required.to_vec(),
        ..Options::default()
    };
    with_dimension!(&tiling(document), AnyTiling, t => {
        let proof = examine(t, &options, &|_| ())?;
        prove(t, &options, &|_| ()).unwrap_or_else(|reason| panic!("examined, but {reason}"));
        Ok(proof.statements)
    })
}

/// The kinds of defects with their counts, as `code count` in alphabetical order.
fn defects(document: &Value) -> Vec<String> {
    defects_requiring(document, &[])
}

fn defects_requiring(document: &Value, required: &[Requirement]) -> Vec<String> {
    let refutation = judge(document, required).expect_err("it is wrong");
    refutation
        .counts()
        .iter()
        .map(|(code, count)| format!("{code} {count}"))
        .collect()
}

fn error(document: &str) -> String {
    read_native(document)
        .err()
        .expect("it cannot be read")
        .to_string()
}

#[test]
fn the_kuhn_cube_is_a_nonobtuse_weakly_delaunay_tiling() {
    // The angles of all are 45, 45, 60, 90, 90, 90 degrees (the paper's Table 1, "Cube VI"); the
    // circumradius is √3/2 and the shortest edge 1.
    let (right, half) = (angle("0"), angle("1/2"));
    let ratio = ratio("3/4");
    let expected = [
        Statement::FaceToFaceTiling,
        Statement::Nonobtuse,
        Statement::LargestAngle(Relation::Maximum, right.clone()),
        Statement::LargestAngle(Relation::Minimum, right),
        Statement::SmallestAngle(Relation::Maximum, half.clone()),
        Statement::SmallestAngle(Relation::Minimum, half),
        Statement::RadiusEdge(Relation::Maximum, ratio.clone()),
        Statement::RadiusEdge(Relation::Minimum, ratio),
        Statement::WeaklyDelaunay,
    ];
    assert_eq!(judge(&kuhn(), &[]).expect("it is a tiling"), expected);
}

/// The angle whose cosine has this square.
fn angle(square: &str) -> DihedralAngle {
    DihedralAngle::of_rational(parse_rational(square).unwrap())
}

fn ratio(square: &str) -> RadiusEdge {
    RadiusEdge {
        square: Number::from(parse_rational(square).unwrap()),
    }
}

#[test]
fn requirements_that_fail_name_every_angle() {
    // Each path tetrahedron has three right angles: at its first, middle and last step.
    assert_eq!(
        defects_requiring(&kuhn(), &[Requirement::Acute]),
        ["right-angle 18"]
    );
    let sixty = Requirement::DihedralBelow(60.into());
    // The six angles are 45, 45, 60, 90, 90, 90, and 60 is not less than 60.
    assert_eq!(defects_requiring(&kuhn(), &[sixty]), ["angle-not-below 24"]);
    // Two facets of each lie inside of the cube, whose corners are cospherical.
    assert_eq!(
        defects_requiring(&kuhn(), &[Requirement::Delaunay]),
        ["on-circumsphere 12"]
    );
}

#[test]
fn one_simplex_missing() {
    let mut document = kuhn();
    document["simplices"].as_array_mut().unwrap().remove(0);
    assert_eq!(defects(&document), ["unmatched-facet 4", "volume-sum 1"]);
}

#[test]
fn one_simplex_doubled() {
    let mut document = kuhn();
    let simplex = document["simplices"][3].clone();
    document["simplices"].as_array_mut().unwrap().push(simplex);
    assert_eq!(defects(&document), ["duplicate 1", "volume-sum 1"]);
}

#[test]
fn one_simplex_moved_by_a_lattice_vector_is_still_right() {
    let mut document = kuhn();
    document["simplices"][2] = json!([[0, 5, -7, 2], [0, 5, -7, 3], [0, 6, -7, 3], [0, 6, -6, 3]]);
    assert!(judge(&document, &[]).is_ok());
}

#[test]
fn two_tilings_overlaid_fail_by_their_volume_alone() {
    let mut document = kuhn();
    document["vertices"] = json!([[0, 0, 0], ["1/3", "1/4", "1/5"]]);
    let mut simplices = document["simplices"].as_array().unwrap().clone();
    for simplex in kuhn()["simplices"].as_array().unwrap() {
        let corners = simplex
            .as_array()
            .unwrap()
            .iter()
            .map(|corner| match corner {
                Value::Array(shifted) => json!([1, shifted[1], shifted[2], shifted[3]]),
                _ => json!(1),
            });
        simplices.push(corners.collect());
    }
    document["simplices"] = Value::Array(simplices);
    let refutation = judge(&document, &[]).expect_err("it covers twice");
    match refutation.kept() {
        [Defect::VolumeSum { sum, expected }] => {
            assert_eq!(
                (sum.to_string(), expected.to_string()),
                ("2".into(), "1".into())
            );
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_facet_used_three_times() {
    let mut document = kuhn();
    document["vertices"] = json!([[0, 0, 0], ["1/2", "1/3", "1/7"]]);
    let extra = json!([0, [0, 1, 0, 0], [0, 1, 1, 0], 1]);
    document["simplices"].as_array_mut().unwrap().push(extra);
    assert_eq!(
        defects(&document),
        ["overused-facet 1", "unmatched-facet 3", "volume-sum 1"]
    );
}

#[test]
fn simplices_that_are_no_simplices() {
    let mut document = kuhn();
    document["simplices"][0] = json!([0, [0, 1, 0, 0], [0, 1, 1, 0], [0, 1, 0, 0]]);
    assert_eq!(defects(&document), ["repeated-corner 1"]);
    document["simplices"][0] = json!([0, [0, 1, 0, 0], [0, 2, 0, 0], [0, 1, 1, 1]]);
    assert!(defects(&document).contains(&"flat 1".to_owned()));
    document["simplices"] = json!([]);
    assert_eq!(defects(&document), ["no-simplices 1", "unused-vertex 1"]);
}

#[test]
fn negative_orientation_is_reported_with_its_remedy_and_mended() {
    let mut document = kuhn();
    document["simplices"][1] = json!([0, [0, 0, 1, 0], [0, 1, 1, 1], [0, 0, 1, 1]]);
    let refutation = judge(&document, &[]).expect_err("it is negatively oriented");
    let AnyTiling::Space(mut read) = tiling(&document) else {
        panic!("dimension 3")
    };
    let sentence = acutile_core::checker::describe::<3>(
        &acutile_core::checker::Names::of(&read),
        &refutation.kept()[0],
    );
    assert_eq!(
        sentence,
        "simplex 1 [0, 0+(0, 1, 0), 0+(1, 1, 1), 0+(0, 1, 1)] is negatively oriented: its \
         determinant is -1, expected a positive number; the order [0, 0+(0, 1, 0), 0+(0, 1, 1), \
         0+(1, 1, 1)] mends it (--reorient does)"
    );
    assert_eq!(read.orient(), [SimplexId::new(1)]);
    assert!(examine(&read, &Options::default(), &|_| ()).is_ok());
}

#[test]
fn unused_vertices_are_named() {
    let mut document = kuhn();
    document["vertices"] = json!([[0, 0, 0], ["1/2", "1/2", "1/2"]]);
    assert_eq!(defects(&document), ["unused-vertex 1"]);
}

#[test]
fn dependent_vectors_are_a_degenerate_metric() {
    let mut document = kuhn();
    document["lattice"] = json!({ "vectors": [[1, 0, 0], [0, 1, 0], [1, 1, 0]] });
    assert_eq!(defects(&document), ["metric-not-positive 1"]);
}

#[test]
fn metrics_that_are_none() {
    for gram in [
        json!([[1, 1, 0], [1, 1, 0], [0, 0, 1]]),
        json!([[1, 2, 0], [2, 1, 0], [0, 0, 1]]),
        json!([[-1, 0, 0], [0, 1, 0], [0, 0, 1]]),
        json!([[0, 0, 0], [0, 0, 0], [0, 0, 0]]),
    ] {
        let mut document = kuhn();
        document["lattice"]["gram"] = gram;
        assert_eq!(defects(&document), ["metric-not-positive 1"]);
    }
}

#[test]
fn all_defects_are_counted_and_the_first_are_kept() {
    let options = Options {
        required: vec![Requirement::Acute],
        defect_limit: 2,
        ..Options::default()
    };
    let AnyTiling::Space(read) = tiling(&kuhn()) else {
        panic!("dimension 3")
    };
    let refutation = examine(&read, &options, &|_| ()).expect_err("right angles");
    assert_eq!(refutation.kept().len(), 2);
    assert_eq!(refutation.counts()["right-angle"], 18);
}

#[test]
fn cartesian_and_fractional_coordinates_give_the_same_tiling() {
    // The equilateral lattice, Cartesian over Q(sqrt 3) and by its Gram matrix over Q.
    let cartesian = json!({
        "format": "acutile-tiling", "version": 1, "dimension": 2,
        "lattice": { "vectors": [[1, 0], ["1/2", "sqrt(3)/2"]] },
        "coordinates": "cartesian",
        "vertices": [["1/4", "sqrt(3)/4"]],
        "simplices": [[0, [0, 1, 0], [0, 0, 1]], [[0, 1, 0], [0, 1, 1], [0, 0, 1]]],
    });
    let AnyTiling::Plane(plane) = tiling(&cartesian) else {
        panic!("dimension 2")
    };
    assert_eq!(
        plane
            .vertices
            .vertex(VertexId::new(0))
            .map(|x| x.to_string()),
        ["0", "1/2"]
    );
    let statements = judge(&cartesian, &[]).expect("a tiling");
    assert_eq!(statements[1], Statement::Acute);
    // Angles of 60 degrees; the squared ratio is 1/3.
    let sixty = angle("1/4");
    assert_eq!(
        statements[2],
        Statement::LargestAngle(Relation::Maximum, sixty.clone())
    );
    assert_eq!(
        statements[5],
        Statement::SmallestAngle(Relation::Minimum, sixty)
    );
    assert_eq!(
        statements[6],
        Statement::RadiusEdge(Relation::Maximum, ratio("1/3"))
    );
    assert_eq!(statements[8], Statement::Delaunay);
    // Its numbers are rational but for a factor of the Gram matrix.
    let proved = prove(&plane, &Options::default(), &|_| ()).expect("a tiling");
    let certificate = format::read::certificate(proved.certificate()).unwrap();
    assert_eq!(certificate.claim.field, format::Field::Rationals);
}

#[test]
fn messages_name_the_place_and_what_was_expected() {
    let with = |edit: &dyn Fn(&mut Value)| {
        let mut document = kuhn();
        edit(&mut document);
        error(&document.to_string())
    };
    let number = |text: Value| with(&|d| d["vertices"] = json!([[0, text, 0]]));
    let begins = |message: String, start: &str| {
        assert!(
            message.starts_with(start),
            "{message:?} does not begin with {start:?}"
        );
    };
    for bad in [
        "1/0",
        "0x10",
        "1e999999999",
        "--5",
        "\u{0663}",
        "\u{ff11}",
        "NaN",
        "inf",
        "",
        "sqrt(-1)",
        "sqrt(2",
        "b",
    ] {
        begins(number(json!(bad)), "vertices[0][1]: ");
    }
    begins(
        number(json!(null)),
        "vertices[0][1]: found null, expected a number",
    );
    begins(
        number(json!([1])),
        "vertices[0][1]: found [1], expected a number",
    );
    begins(
        number(json!(true)),
        "vertices[0][1]: found true, expected a number",
    );
    assert_eq!(
        with(&|d| d["vertices"] = json!([[0, 0]])),
        "vertices[0]: has 2 entries, expected 3"
    );
    assert_eq!(
        with(&|d| d["simplices"][4][1] = json!(7)),
        "simplices[4][1]: vertex 7 is out of range, expected 0 to 0"
    );
    assert_eq!(
        with(&|d| d["simplices"][4][1] = json!([0, 1, 0])),
        "simplices[4][1]: the shift has 2 entries, expected 3"
    );
    assert_eq!(
        with(&|d| d["simplices"][4] = json!([0, 0, 0])),
        "simplices[4]: has 3 corners, expected 4"
    );
    begins(
        with(&|d| d["simplices"][4][1] = json!([0, 99999999999i64, 0, 0])),
        "simplices[4][1]: the shift",
    );
    begins(
        with(&|d| d["simplices"][4][1] = json!(-1)),
        "simplices[4][1]: found the number -1, expected a corner",
    );
    assert_eq!(
        with(&|d| d["lattice"]["gram"] = json!([[1]])),
        "lattice: has 1 rows, expected 3"
    );
    begins(
        with(&|d| d["lattice"]["gram"][0][1] = json!(5)),
        "lattice[1][0]: the Gram matrix is not symmetric",
    );
    begins(
        with(&|d| {
            d["lattice"] = json!({ "vectors": [[1, 0, 0], [0, 1, 0], [1, 1, 0]] });
            d["coordinates"] = json!("cartesian");
        }),
        "lattice: the lattice vectors are linearly dependent",
    );
    begins(
        with(&|d| d["coordinates"] = json!("cartesian")),
        "coordinates: Cartesian",
    );
    begins(
        with(&|d| d["color"] = json!("red")),
        "color: the member \"color\" is not known here",
    );
    assert_eq!(
        with(&|d| d["version"] = json!(2)),
        "version is 2, expected 1"
    );
    begins(
        with(&|d| d["format"] = json!("stl")),
        "format is \"stl\", expected",
    );
    begins(
        with(&|d| d["dimension"] = json!(4)),
        "dimension: found 4, expected 2 or 3",
    );
    begins(
        with(&|d| drop(d.as_object_mut().unwrap().remove("vertices"))),
        "vertices: is missing",
    );
    begins(with(&|d| d["points"] = json!([])), "points: has no place");
}

#[test]
fn limits_are_told_from_errors() {
    let is_limit = |edit: &dyn Fn(&mut Value)| {
        let mut document = kuhn();
        edit(&mut document);
        read_native(&document.to_string())
            .err()
            .expect("it cannot be read")
            .is_limit()
    };
    assert!(is_limit(&|d| d["version"] = json!(2)));
    assert!(is_limit(&|d| d["vertices"][0][0] = json!("1e999999999")));
    assert!(!is_limit(&|d| d["vertices"][0][0] = json!("1/0")));
    assert!(!is_limit(&|d| d["vertices"] = json!([[0]])));
}

/// Nested roots of degree 32: read, or declined as too large, but not for minutes.
#[test]
fn nested_roots_end() {
    for nested in [
        "sqrt(sqrt(sqrt(2)))",
        "sqrt(sqrt(sqrt(sqrt(2))))",
        "sqrt(sqrt(sqrt(sqrt(sqrt(2)))))",
    ] {
        let mut document = kuhn();
        document["lattice"] = json!({ "gram": [["sqrt(3)", 0, 0], [0, 1, 0], [0, 0, 1]] });
        document["vertices"] = json!([[nested, 0, 0]]);
        match read_native(&document.to_string()) {
            Ok(_) => {}
            Err(error) => assert!(error.is_limit(), "{error}"),
        }
    }
}

#[test]
fn bounds_hold_far_from_the_origin() {
    let mut document = kuhn();
    document["vertices"] = json!([["(sqrt(2)+1)^200", 0, 0]]);
    let statements = judge(&document, &[]).expect("it is a tiling");
    assert!(statements.contains(&Statement::LargestAngle(Relation::Maximum, angle("0"))));
}

#[test]
fn text_that_is_no_document() {
    assert_eq!(
        error(""),
        "is empty, expected an input file; acutile new writes examples"
    );
    assert_eq!(
        error("  \n"),
        "is empty, expected an input file; acutile new writes examples"
    );
    let whole = kuhn().to_string();
    for end in (1..whole.len()).step_by(7) {
        assert!(!error(&whole[..end]).is_empty());
    }
    assert!(error(&"[".repeat(100_000)).contains("line 1"));
    let deep = format!("{}1{}", "(".repeat(100_000), ")".repeat(100_000));
    assert!(
        error(&whole.replacen("[0,0,0]", &format!("[\"{deep}\",0,0]"), 1))
            .starts_with("vertices[0][0]: ")
    );
}

/// A generator may be defined once; numbers are printed by its name.
#[test]
fn generators() {
    let text = |generators: &str| {
        let document = kuhn().to_string();
        let vertices = "\"vertices\":[[0,0,0]]";
        assert!(document.contains(vertices), "{document}");
        document.replacen(
            vertices,
            &format!("\"generators\":{{{generators}}},\"vertices\":[[\"t/2\",0,0]]"),
            1,
        )
    };
    let golden = "\"t\":{\"polynomial\":[-1,-1,1],\"root\":[1,2]}";
    let file = read_native(&text(golden)).expect("a tiling");
    let Content::Tiling(AnyTiling::Space(tiling)) = file.content else {
        panic!("a tiling of space");
    };
    assert_eq!(
        tiling.vertices.vertex(VertexId::new(0))[0].to_string(),
        "1/2 t"
    );
    let twice = format!("{golden},\"t\":{{\"polynomial\":[-2,0,1],\"root\":[1,2]}}");
    let message = error(&text(&twice));
    assert!(
        message.contains("the generator \"t\" is defined twice"),
        "{message}"
    );
}

/// A small compressed file does not become a large text.
#[test]
fn compressed_files_that_grow() {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        let file = std::fs::File::create(&path).expect("a file");
        let mut packed = flate2::write::GzEncoder::new(file, flate2::Compression::best());
        std::io::Write::write_all(&mut packed, bytes).expect("written");
        packed.finish().expect("written");
        path
    };
    let bomb = write("bomb.json.gz", &vec![b' '; 30 << 20]);
    let error = read_text(&bomb).expect_err("grows by a factor of 1,000");
    assert!(error.is_limit());
    assert!(
        error.to_string().contains("decompress the file first"),
        "{error}"
    );
    let honest = write("honest.json.gz", &vec![b' '; 1 << 20]);
    assert_eq!(
        read_text(&honest).expect("one MiB is allowed").len(),
        1 << 20
    );
}

/// No space is reserved for a file beyond the limit.
#[test]
fn a_sparse_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("sparse.msh");
    std::fs::File::create(&path)
        .and_then(|file| file.set_len(40 << 30))
        .expect("a sparse file");
    for limit in [1 << 20, 1 << 30] {
        let bytes = read_bytes(&path, limit);
        assert!(bytes.expect_err("40 GiB").is_limit());
    }
}

/// A strip of triangles whose height is a parameter, with changes to the document.
fn parameter_error(change: impl Fn(&mut Value)) -> String {
    let mut document = json!({
        "format": "acutile-tiling", "version": 1, "dimension": 2,
        "parameters": {"h": ["1/2", "2"]},
        "lattice": {"gram": [[1, "1/2"], ["1/2", "h"]]},
        "vertices": [[0, 0]],
        "simplices": [[0, [0, 1, 0], [0, 0, 1]], [[0, 1, 0], [0, 1, 1], [0, 0, 1]]]
    });
    change(&mut document);
    match read_native(&document.to_string()).map(|file| file.content) {
        Ok(Content::Family(_)) => "a family".to_owned(),
        Ok(_) => "something else".to_owned(),
        Err(error) => error.to_string(),
    }
}

#[test]
fn parameters() {
    assert_eq!(parameter_error(|_| ()), "a family");
    let set =
        |entry: Value| move |document: &mut Value| document["parameters"]["h"] = entry.clone();
    let interval = json!({"low": "1/2", "high": "sqrt(2)", "open": ["low", "high"]});
    assert_eq!(parameter_error(set(interval)), "a family");
    assert_eq!(
        parameter_error(set(json!([2, 1]))),
        "parameters: box ends exchanged: the lower end of \"h\" is above the upper end; exchange them"
    );
    assert_eq!(
        parameter_error(set(json!([1, 1]))),
        "parameters: empty box: the ends of \"h\" are equal; replace the parameter by its value"
    );
    assert_eq!(
        parameter_error(|document| document["parameters"]["k"] = json!([0, 1])),
        "parameters: unused parameter: \"k\" occurs in no Gram entry and no coordinate; remove it"
    );
    assert_eq!(
        parameter_error(|document| document["vertices"] = json!([["h^16", 0]])),
        "vertices[0][0]: column 2: polynomial of too high degree: 16 in one parameter, expected at most 15"
    );
    assert!(parameter_error(set(json!([1]))).contains("parameters.h"));
    assert!(parameter_error(set(json!({"low": 1}))).contains("the member \"high\" is missing"));
    assert!(
        parameter_error(set(json!(["h", 2]))).starts_with("parameters.h.low: column 1: found 'h'")
    );
    let bad_name = |document: &mut Value| {
        document["parameters"] = json!({"H": [1, 2]});
        document["lattice"]["gram"][1][1] = json!("H");
    };
    assert!(parameter_error(bad_name).contains("\"H\" cannot name a parameter"));
}

/// A letter that is not declared may be meant as a parameter, in a family and in a tiling.
#[test]
fn unknown_letters() {
    let advice = |u: &str| {
        format!("to add a parameter, write \"parameters\": {{\"{u}\": [0, 1]}} with its ends")
    };
    let found = |u: &str| {
        format!(
            "column 1: found '{u}', expected a number like 3/7 or sqrt(2)/4, or a declared name"
        )
    };
    let unknown = |document: &mut Value| document["vertices"] = json!([["u", "h"]]);
    assert_eq!(
        parameter_error(unknown),
        format!(
            "vertices[0][0]: {}; the parameter is h and there is no generator; {}",
            found("u"),
            advice("u")
        )
    );
    let several = |document: &mut Value| {
        document["parameters"]["s"] = json!([0, 1]);
        document["generators"] = json!({"c": {"polynomial": [-2, 0, 1], "root": [1, 2]}});
        document["vertices"] = json!([["s", "0"], ["t*c", 0]]);
    };
    assert_eq!(
        parameter_error(several),
        format!(
            "vertices[1][0]: {}; the parameters are h and s and the generator is c; {}",
            found("t"),
            advice("t")
        )
    );
    let none = |document: &mut Value| {
        document["parameters"] = json!({});
    };
    assert_eq!(
        parameter_error(none),
        format!(
            "lattice[1][1]: {}; there is no parameter and there is no generator; {}",
            found("h"),
            advice("h")
        )
    );
}

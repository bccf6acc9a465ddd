//! Certificate format 2: the two encodings of one certificate, and bytes that are none.

use acutile_core::format::cbor::{self, Item, Items};
use acutile_core::format::json::{self, JsonCode};
use acutile_core::format::{
    Certificate, Claim, Corner, Cosine, Domain, Encoding, Field, Fraction, Number, Relation,
    Statement, Witness, print, read, recognise, write,
};
use malachite::Integer;

fn integer(n: i64) -> Integer {
    Integer::from(n)
}

fn number(n: i64) -> Number {
    Number(vec![integer(n)])
}

/// The plane by equilateral triangles: one vertex, two triangles for a cell.
fn triangles() -> Certificate {
    let corner = |shift: [i32; 3]| Corner { vertex: 0, shift };
    Certificate {
        claim: Claim {
            dimension: 2,
            field: Field::Rationals,
            gram: vec![vec![number(2), number(1)], vec![number(2)]],
            domain: Domain::Space,
            statements: vec![
                Statement::FaceToFaceTiling,
                Statement::Acute,
                Statement::LargestAngle(
                    Relation::Maximum,
                    Cosine {
                        sign: 1,
                        square: Fraction {
                            numerator: number(1),
                            denominator: integer(4),
                        },
                    },
                ),
            ],
        },
        witness: Witness {
            denominator: integer(1),
            vertices: vec![vec![number(0), number(0)]],
            boundary: Vec::new(),
            simplices: vec![
                corner([0, 0, 0]),
                corner([1, 0, 0]),
                corner([0, 1, 0]),
                corner([0, 0, 0]),
                corner([1, 0, 0]),
                corner([1, -1, 0]),
            ],
            sixes: Vec::new(),
        },
    }
}

const TRIANGLES: &str = r#"{
"format":"acutile-certificate",
"version":2,
"kind":"tiling",
"claim":{
"dimension":2,
"field":"Q",
"gram":[
[2,1],
[2]
],
"domain":"space",
"statements":[
"face-to-face tiling",
"acute",
["largest dihedral angle","maximum",1,[1,4]]
]
},
"witness":{
"denominator":1,
"vertices":[
[0,0]
],
"boundary":[],
"simplices":[
[0,[0,1,0],[0,0,1]],
[0,[0,1,0],[0,1,-1]]
]
}
}
"#;

#[test]
fn example_in_both_encodings() {
    let cbor = write::to_bytes(&triangles());
    // 85: an array of five; 73: a text of 19 bytes; 02: the version; 66: a text of six.
    assert_eq!(cbor[..2], [0x85, 0x73]);
    assert_eq!(&cbor[2..21], b"acutile-certificate");
    assert_eq!(cbor[21..30], *b"\x02\x66tiling\x85");
    let json = print::to_json(&cbor).unwrap();
    assert_eq!(String::from_utf8(json.clone()).unwrap(), TRIANGLES);
    assert_eq!(json::to_cbor(&json).unwrap(), cbor);
    assert_eq!(read::certificate(&cbor).unwrap(), triangles());
}

#[test]
fn encodings_are_recognised() {
    let cbor = write::to_bytes(&triangles());
    assert_eq!(recognise(&cbor), Some(Encoding::Cbor));
    assert_eq!(recognise(&cbor[..64]), Some(Encoding::Cbor));
    assert_eq!(recognise(TRIANGLES.as_bytes()), Some(Encoding::Json));
    assert_eq!(
        recognise(b" {\n \"format\" : \"acutile-certificate\""),
        Some(Encoding::Json)
    );
    for other in [
        &b""[..],
        b"{",
        b"{\"format\":\"acutile-tiling\"}",
        b"\x85\x61a",
        b"\xff",
    ] {
        assert_eq!(recognise(other), None, "{other:?}");
    }
}

#[test]
fn claim_file_has_the_same_layout() {
    let claim = triangles().claim;
    let cbor = write::claim_file(&claim);
    assert_eq!(read::claim_file(&cbor).unwrap(), claim);
    let json = print::claim_to_json(&cbor).unwrap();
    let text = String::from_utf8(json.clone()).unwrap();
    assert!(text.starts_with("{\n\"format\":\"acutile-claim\",\n\"version\":2,\n\"kind\":"));
    assert!(text.ends_with("[1,4]]\n]\n}\n}\n"));
    assert_eq!(json::claim_to_cbor(&json).unwrap(), cbor);
}

/// RFC 8949, appendix A, and 3.4.3.
#[test]
fn integers() {
    let cases: [(&str, &[u8]); 13] = [
        ("0", b"\x00"),
        ("23", b"\x17"),
        ("24", b"\x18\x18"),
        ("1000", b"\x19\x03\xe8"),
        ("1000000", b"\x1a\x00\x0f\x42\x40"),
        ("1000000000000", b"\x1b\x00\x00\x00\xe8\xd4\xa5\x10\x00"),
        (
            "18446744073709551615",
            b"\x1b\xff\xff\xff\xff\xff\xff\xff\xff",
        ),
        (
            "18446744073709551616",
            b"\xc2\x49\x01\x00\x00\x00\x00\x00\x00\x00\x00",
        ),
        (
            "-18446744073709551616",
            b"\x3b\xff\xff\xff\xff\xff\xff\xff\xff",
        ),
        (
            "-18446744073709551617",
            b"\xc3\x49\x01\x00\x00\x00\x00\x00\x00\x00\x00",
        ),
        ("-1", b"\x20"),
        ("-100", b"\x38\x63"),
        (
            "9223372036854775808",
            b"\x1b\x80\x00\x00\x00\x00\x00\x00\x00",
        ),
    ];
    for (text, bytes) in cases {
        let value: Integer = text.parse().unwrap();
        let mut written = Vec::new();
        cbor::integer(&mut written, &value).unwrap();
        assert_eq!(written, bytes, "{text}");
        assert_eq!(Items::new(bytes).integer().unwrap(), value, "{text}");
    }
}

#[test]
fn bytes_that_are_not_deterministic() {
    let cases: [&[u8]; 10] = [
        b"\x18\x17",                                     // 23 in two bytes
        b"\x19\x00\xff",                                 // 255 in three
        b"\x1b\x00\x00\x00\x00\xff\xff\xff\xff",         // 2^32 - 1 in nine
        b"\xc2\x48\xff\xff\xff\xff\xff\xff\xff\xff",     // a big integer of eight bytes
        b"\xc2\x49\x00\xff\xff\xff\xff\xff\xff\xff\xff", // a leading zero
        b"\x9f\xff",                                     // an indefinite length
        b"\xf9\x00\x00",                                 // a float
        b"\xa0",                                         // a map
        b"\xc0\x00",                                     // another tag
        b"\x61\x0a",                                     // a line feed in a text
    ];
    for bytes in cases {
        assert!(Items::new(bytes).next_item().is_err(), "{bytes:02x?}");
    }
    assert_eq!(Items::new(b"\x61a").next_item(), Ok(Item::Text("a")));
}

#[test]
fn json_that_is_not_canonical() {
    let with = |from: &str, to: &str| {
        assert!(TRIANGLES.contains(from), "{from}");
        TRIANGLES.replacen(from, to, 1)
    };
    let cases = [
        (with("\"version\":2", "\"version\": 2"), JsonCode::Canonical),
        (with("[0,0]", "[-0,0]"), JsonCode::Canonical),
        (with("[0,0]", "[\"7\",0]"), JsonCode::Canonical),
        (with("[0,0]", "[9007199254740992,0]"), JsonCode::Canonical),
        (with("[0,0]", "[1.0,0]"), JsonCode::Canonical),
        (with("[0,0]", "[1.5,0]"), JsonCode::Json),
        (with("[0,0]", "[01,0]"), JsonCode::Json),
        (with("[0,0]", "[null,0]"), JsonCode::Json),
        (with("[0,0]", "[1e3,0]"), JsonCode::Canonical),
        (with("[0,0]", "[1e-3,0]"), JsonCode::Json),
        (with("[0,0]", "[1e999999999999,0]"), JsonCode::Json),
        (with("\"Q\"", "\"\\u0051\""), JsonCode::Canonical),
        (with("\"Q\"", "\"\u{e9}\""), JsonCode::Json),
        (
            with("\"boundary\":[],", "\"boundary\":[\n],"),
            JsonCode::Canonical,
        ),
        (with("\"boundary\":[],", ""), JsonCode::Json),
        (
            with("\"boundary\":[],", "\"boundary\":[],\"boundary\":[],"),
            JsonCode::Canonical,
        ),
        (
            with(
                "\"version\":2,\n\"kind\":\"tiling\"",
                "\"kind\":\"tiling\",\n\"version\":2",
            ),
            JsonCode::Canonical,
        ),
        (with("\"version\":2", "\"version\":1"), JsonCode::Version),
        (TRIANGLES.trim_end().to_owned(), JsonCode::Canonical),
        (format!("{TRIANGLES}\n"), JsonCode::Canonical),
        (format!("{TRIANGLES}x"), JsonCode::Json),
        ("[".repeat(100_000), JsonCode::Json),
        (String::new(), JsonCode::Json),
    ];
    for (text, code) in cases {
        let error = json::to_cbor(text.as_bytes()).unwrap_err();
        assert_eq!(error.code, code, "{text}: {error}");
    }
    let large = with("[0,0]", "[\"9007199254740992\",0]");
    let cbor = json::to_cbor(large.as_bytes()).unwrap();
    assert_eq!(print::to_json(&cbor).unwrap(), large.as_bytes());
}

/// A string of digits that JSON writes as "0" is a text, and a number is an array or an integer.
#[test]
fn shapes_that_are_no_certificate() {
    let zero = TRIANGLES.replacen("[0,0]", "[[0],0]", 1);
    let cbor = json::to_cbor(zero.as_bytes()).unwrap();
    assert!(read::certificate(&cbor).is_err());
    let cbor = write::to_bytes(&triangles());
    for end in 0..cbor.len() {
        assert!(read::certificate(&cbor[..end]).is_err(), "{end}");
        assert!(print::to_json(&cbor[..end]).is_err(), "{end}");
    }
    let longer = [&cbor[..], b"\x00"].concat();
    assert!(read::certificate(&longer).is_err());
    assert!(print::to_json(&longer).is_err());
}

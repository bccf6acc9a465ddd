//! Statements as `--require` takes them.

use acutile_exact::number::parse_rational;
use acutile_format1::certificate::Statement;

/// Reads a statement as `--require` takes it.
pub fn statement(text: &str) -> Result<Statement, String> {
    let bounded = |prefix: &str, largest: u8, statement: fn(String) -> Statement| {
        text.strip_prefix(prefix)
            .map(|bound| bound_text(bound, largest).map(statement))
    };
    match text {
        "tiling" => Ok(Statement::FaceToFaceTiling),
        "acute" => Ok(Statement::Acute),
        "nonobtuse" => Ok(Statement::Nonobtuse),
        "delaunay" => Ok(Statement::Delaunay),
        "weakly-delaunay" => Ok(Statement::WeaklyDelaunay),
        "tcp" => Ok(Statement::Tcp),
        _ => bounded("dihedral<", 180, Statement::DihedralBelow)
            .or_else(|| bounded("dihedral>", 180, Statement::DihedralAbove))
            .or_else(|| bounded("radius-edge<", u8::MAX, Statement::RadiusEdgeBelow))
            .unwrap_or_else(|| {
                Err(
                    "expected acute, nonobtuse, delaunay, weakly-delaunay, tcp, tiling, \
                     dihedral<DEGREES, dihedral>DEGREES or radius-edge<RATIO"
                        .to_owned(),
                )
            }),
    }
}

fn bound_text(text: &str, largest: u8) -> Result<String, String> {
    let bound = parse_rational(text).map_err(|error| error.to_string())?;
    if bound <= 0 || bound > largest {
        return Err(format!(
            "found {text}, expected more than 0 and at most {largest}"
        ));
    }
    Ok(bound.to_string())
}

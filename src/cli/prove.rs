//! From a tiling to an answer of `acutile certify`: the prover, the certificate, the kernel.

use super::answer::{Answer, Examined, Written};
use super::certify_arguments::CertifyArguments;
use super::encoding::Encoding;
use super::files::Staged;
use super::progress::Progress;
use super::refutation::{LISTED, SHOWN};
use super::target::Target;
use acutile_catalog as catalog;
use acutile_core::checker::{self, Defect, Names, Options};
use acutile_core::format::{self, print};
use acutile_core::proved::{Confirmed, NotProved, prove_to};
use acutile_core::statement::{contradiction, counted, in_words as statement_in_words};
use acutile_core::tiling::Tiling;
use acutile_core::transcribe;
use serde_json::Value;
use std::io::Cursor;

fn options(arguments: &CertifyArguments, is_json: bool) -> Options {
    Options {
        required: arguments.required.clone(),
        defect_limit: defect_limit(arguments, is_json),
        limits: arguments.limits.limits(),
        ..Options::default()
    }
}

/// What is required: by the options, and by what the certificate of a construction states. The largest
/// interval is about the options alone.
pub fn required(
    input: &str,
    arguments: &CertifyArguments,
    is_json: bool,
) -> Result<Options, String> {
    if let Some((x, y)) = contradiction(&arguments.required) {
        return Err(format!(
            "no tiling is both {x} and {y}, expected requirements that agree; leave out one of them"
        ));
    }
    let mut options = options(arguments, is_json);
    if let Some(entry) = catalog::find(input)
        && arguments.family.maximal.is_none()
    {
        options.required.extend(entry.requirements()?);
    }
    Ok(options)
}

/// Twenty defects of each kind for people, all for machines and files, if not said otherwise.
fn defect_limit(arguments: &CertifyArguments, is_json: bool) -> usize {
    if arguments.defects.is_some() {
        usize::MAX
    } else if arguments.report.is_some() {
        arguments.max_defects.unwrap_or(LISTED)
    } else if is_json {
        arguments.max_defects.unwrap_or(usize::MAX)
    } else {
        arguments.max_defects.unwrap_or(SHOWN)
    }
}

pub fn in_words<const D: usize>(tiling: &Tiling<D>, defect: &Defect) -> String {
    checker::describe::<D>(&Names::of(tiling), defect)
}

/// The prover's word alone.
pub fn examine_tiling<const D: usize>(
    tiling: &Tiling<D>,
    name: &str,
    options: &Options,
) -> Result<Answer, NotProved> {
    let progress = Progress::of(name);
    let proof = checker::examine(tiling, options, &|step| progress.step(step))?;
    let claim = transcribe::claim(proof.parts(tiling));
    let statements = proof.statements.iter();
    let boundary = tiling.frame.domain.is_region().then(|| {
        let kind = if tiling.frame.rank() > 0 {
            "a periodic region"
        } else {
            "a bounded region"
        };
        let facets = match D {
            2 => counted(proof.boundary_facets(), "edge", "edges"),
            _ => counted(proof.boundary_facets(), "triangle", "triangles"),
        };
        format!("{kind} with a boundary of {facets}")
    });
    let words = statements.map(|s| statement_in_words(s, D));
    let words: Vec<String> = boundary.into_iter().chain(words).collect();
    Ok(Answer::Examined(Box::new(Examined {
        vertices: tiling.vertices.len(),
        simplices: tiling.len(),
        words: words.join("; "),
        statements: statements_json(&claim),
    })))
}

/// The statements of a claim as its JSON has them.
fn statements_json(claim: &format::Claim) -> Value {
    let json = print::claim_to_json(&format::write::claim_file(claim)).unwrap_or_default();
    let file: Value = serde_json::from_slice(&json).unwrap_or_default();
    file["claim"]["statements"].clone()
}

/// The kernel decides: nothing is called proved that it does not confirm.
pub fn prove_tiling<const D: usize>(
    tiling: &Tiling<D>,
    name: &str,
    options: &Options,
    target: &Target,
    arguments: &CertifyArguments,
) -> Result<Answer, NotProved> {
    let encoding = encoding(target, arguments);
    let has_page = arguments.report.is_some();
    let progress = Progress::of(name);
    let step = |step: &str| progress.step(step);
    // CBOR that has a place goes there, and is in memory only for a page.
    if let (Encoding::Cbor, Target::File(path), false) = (encoding, target, has_page)
        && let Some(staged) = Staged::new(path).map_err(NotProved::Io)?
    {
        let confirmed = prove_to(tiling, options, &step, &mut staged.file())?;
        return Ok(answer(confirmed, Written::File(staged)));
    }
    let mut storage = Cursor::new(Vec::new());
    let confirmed = prove_to(tiling, options, &step, &mut storage)?;
    let cbor = storage.into_inner();
    let bytes = match (encoding, target) {
        (_, Target::Nowhere) if !has_page => Vec::new(),
        (encoding, _) => {
            let bytes = encoding.encode(&cbor).map_err(NotProved::Io)?;
            bytes.into_owned()
        }
    };
    Ok(answer(confirmed, Written::Bytes(bytes)))
}

fn answer(confirmed: Confirmed, certificate: Written) -> Answer {
    Answer::Proved {
        verified: confirmed.into_verified(),
        certificate,
    }
}

/// As asked for, or else as the name of the file says.
pub fn encoding(target: &Target, arguments: &CertifyArguments) -> Encoding {
    let by_name = match target {
        Target::File(path) => Encoding::of_path(path),
        _ => None,
    };
    arguments.format.or(by_name).unwrap_or(Encoding::Json)
}

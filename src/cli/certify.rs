//! `acutile certify`: proves tilings and writes their certificates.

use super::answer::{Answer, Beside, Examined, Written, unwritten};
use super::defects;
use super::encoding::Encoding;
use super::family::{self, FamilyArguments};
use super::input::{self, FileArguments, Loaded};
use super::limits::LimitArguments;
use super::named::InputError;
use super::outcome::Outcome;
use super::output::{Output, Staged, write_file};
use super::progress::Progress;
use super::proved::{overwritten, refused, stem};
use super::refutation::{Refuted, SHOWN};
use super::refuted_page::LISTED;
use super::report::{self, Article};
use super::second::{self, SecondLook};
use super::target::{Target, targets};
use super::theorem;
use acutile_catalog as catalog;
use acutile_core::checker::{self, Defect, Names, Options};
use acutile_core::family::AnyFamily;
use acutile_core::format::{self, print};
use acutile_core::proved::{Confirmed, NotProved, prove_to};
use acutile_core::statement::{Requirement, in_words as statement_in_words};
use acutile_core::tiling::Tiling;
use acutile_core::transcribe;
use acutile_core::with_dimension;
use acutile_publish::report::Proved;
use clap::Args;
use serde_json::Value;
use std::io::{self, Cursor};
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct CertifyArguments {
    /// Names of the catalogue, tiling files, mesh files, or point sets (CIF too), whose
    /// Delaunay triangulation is certified (`-` for standard input)
    #[arg(value_name = "NAME|FILE", required_unless_present = "all")]
    pub inputs: Vec<String>,
    #[command(flatten)]
    pub file: FileArguments,
    /// The whole catalogue
    #[arg(long)]
    pub all: bool,
    /// The number that the construction depends on, like 3/7 or sqrt(2)/4: a/e of
    /// goldberg-1, -2 and -3, epsilon of two-corners
    #[arg(
        long,
        value_name = "VALUE",
        conflicts_with = "all",
        allow_hyphen_values = true
    )]
    pub param: Option<String>,
    /// Write the certificate to this file (`-` for standard output), or the
    /// certificates into this directory
    #[arg(short, long, value_name = "FILE|DIR")]
    pub output: Option<PathBuf>,
    /// The encoding; without it CBOR for a file whose name ends in .cbor, and else JSON
    #[arg(long, value_enum, conflicts_with = "no_certificate")]
    pub format: Option<Encoding>,
    /// Statements that must hold: tiling, acute, nonobtuse, delaunay, weakly-delaunay, tcp,
    /// dihedral-below=DEGREES, dihedral-above=DEGREES, radius-edge-below=RATIO; in quotes also
    /// 'dihedral<DEGREES', 'dihedral>DEGREES', 'radius-edge<RATIO'; plane:EQUATION in basis
    /// coordinates, like plane:x2+x3=1/2, for a plane that no simplex crosses; and, by the prover alone,
    /// connected, no-cavities, manifold-boundary
    #[arg(
        long = "require",
        value_name = "STATEMENT,STATEMENT",
        value_delimiter = ','
    )]
    pub required: Vec<Requirement>,
    /// For square-triangle:NAME, square-triangle:FILE and kagome:WORD: check only that the input
    /// belongs to the family, and cite the theorem about all its members
    #[arg(long, conflicts_with_all = ["param", "no_certificate"])]
    pub cite: bool,
    /// Give negatively oriented simplices positive orientation
    #[arg(long)]
    pub reorient: bool,
    /// Prove and tell, but make no certificate and do not ask the kernel: for large meshes that
    /// are to be checked and not to be published
    #[arg(long, conflicts_with_all = ["output", "report"])]
    pub no_certificate: bool,
    /// How many defects of each kind to tell; all are counted. Without it 20, and with --json all
    #[arg(long, value_name = "N")]
    pub max_defects: Option<usize>,
    /// Write exact numbers in full; without it only about, where they are long. JSON has them anyway
    #[arg(long)]
    pub exact: bool,
    /// Decline where the mesh has elements of types that are not checked
    #[arg(long)]
    pub strict: bool,
    /// Facets may lie against each other (cohesive zones, contact): prove that interiors are disjoint,
    /// and count the pairs
    #[arg(long)]
    pub allow_contact: bool,
    /// Compare the boundary of a bounded mesh with the triangles of a surface: STL, OBJ, or a mesh file
    /// of triangles
    #[arg(long, value_name = "SURFACE")]
    pub fills: Option<PathBuf>,
    /// Write the cells of the defects to this VTU file, for ParaView
    #[arg(long, value_name = "FILE.vtu")]
    pub defects: Option<PathBuf>,
    /// Write a page to look at to this file: what is proved, and the defects of what is refuted, in red
    #[arg(long, value_name = "FILE.html")]
    pub report: Option<PathBuf>,
    /// One JSON object a line: one for each input, and for a refuted one then one for each defect
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    pub family: FamilyArguments,
    #[command(flatten)]
    pub limits: LimitArguments,
}

/// Certifies every input; the outcome is the worst of all.
pub fn run(arguments: &CertifyArguments, output: &mut Output) -> Outcome {
    let mut inputs: Vec<String> = Vec::new();
    let theorems = catalog::THEOREMS.iter().map(|theorem| theorem.name);
    let all = catalog::names()
        .chain(catalog::large_names())
        .chain(catalog::family_names())
        .chain(theorems)
        .filter(|_| arguments.all)
        .map(str::to_owned);
    for input in arguments.inputs.iter().cloned().chain(all) {
        if !inputs.contains(&input) {
            inputs.push(input);
        }
    }
    let targets = match targets(&inputs, arguments) {
        Ok(targets) => targets,
        Err(message) => {
            output.complain(format!("acutile: {message}"));
            return Outcome::Failed;
        }
    };
    if let Some(input) = overwritten(&inputs, arguments.report.as_deref()) {
        output.complain(format!(
            "acutile: --report would overwrite the input {input}"
        ));
        return Outcome::Failed;
    }
    let mut worst = Outcome::Done;
    let mut articles = Vec::new();
    for (input, target) in inputs.iter().zip(targets) {
        let mut notes = Vec::new();
        let mut beside = Beside::default();
        let answer = prove(input, &target, arguments, &mut notes, &mut beside, output);
        if arguments.report.is_some() {
            match article(input, &answer, arguments) {
                Ok(article) => articles.push(article),
                Err(error) => {
                    output.complain(format!("acutile: not on the page: {}", error.message));
                    worst = worst.and(error.outcome);
                }
            }
        }
        let answer = answer.write(&target, output);
        answer.report(input, &target, arguments, &notes, &beside, output);
        worst = worst.and(strictly(answer.outcome(), arguments, &beside));
    }
    match &arguments.report {
        Some(path) if !articles.is_empty() => {
            worst.and(report::write(&articles, Some(path.as_path()), output))
        }
        _ => worst,
    }
}

/// What the page of --report has of an input.
fn article(
    input: &str,
    answer: &Answer,
    arguments: &CertifyArguments,
) -> Result<Article, InputError> {
    match answer {
        Answer::Refuted(refuted) => Ok(Article::Refuted(Box::new(refuted.article(&stem(input))))),
        Answer::Failed(message) | Answer::Declined(message) => {
            let message = message.clone();
            let outcome = answer.outcome();
            Err(InputError { message, outcome })
        }
        Answer::Proved {
            certificate: Written::Bytes(bytes),
            ..
        } => {
            let limits = arguments.limits.limits();
            Proved::of_certificate(stem(input), String::new(), bytes, &limits)
                .map(|proved| Article::Proved(Box::new(proved)))
                .map_err(|error| refused(input, &error))
        }
        _ => Err(format!("{input}: there is no page without a certificate").into()),
    }
}

/// With --strict a proof counts as declined if elements that fill space were not checked.
fn strictly(outcome: Outcome, arguments: &CertifyArguments, beside: &Beside) -> Outcome {
    let is_partial = beside.others.as_ref().is_some_and(|(_, fills)| *fills);
    match outcome {
        Outcome::Done if arguments.strict && is_partial => Outcome::Declined,
        outcome => outcome,
    }
}

/// Proves or refutes; `notes` gets what was done to the input before, `beside` what is said more.
fn prove(
    input: &str,
    target: &Target,
    arguments: &CertifyArguments,
    notes: &mut Vec<String>,
    beside: &mut Beside,
    output: &mut Output,
) -> Answer {
    match theorem::of_input(input, arguments) {
        Some(Ok(proof)) => return theorem_answer(proof, target, arguments, notes),
        Some(Err(message)) => return Answer::Failed(message),
        None => {}
    }
    let loaded = input::open(input, arguments.param.as_deref(), &arguments.file, output);
    let named = match loaded {
        Ok(Loaded::Family(named)) => {
            return prove_family(&named.family, input, target, arguments, notes, output);
        }
        Ok(loaded) => loaded.tiling(input, &arguments.file, output),
        Err(error) => Err(error),
    };
    let mut named = match named {
        Ok(named) => named,
        Err(error) if error.outcome == Outcome::Declined => {
            return Answer::Declined(error.message);
        }
        Err(error) => return Answer::Failed(error.message),
    };
    notes.append(&mut named.notes);
    if let Some(note) = with_dimension!(&named.tiling, AnyTiling, t => second::note_on_boundary(t))
    {
        output.complain(format!("{input}: {note}"));
        notes.push(note);
    }
    if arguments.reorient {
        let mended = with_dimension!(&mut named.tiling, AnyTiling, t => t.orient());
        if let Some(origin) = &mut named.origin {
            origin.reoriented(&mended);
        }
        if !mended.is_empty() {
            let note = format!("{} simplices reoriented", mended.len());
            output.complain(format!("{input}: {note}"));
            notes.push(note);
        }
    }
    beside.others = second::others(&named);
    if !named.curved.is_empty() {
        return second::curved(input, &named, !arguments.required.is_empty());
    }
    match arguments.family.freed(&named.tiling) {
        Ok(None) => {}
        Ok(Some(family)) => {
            return prove_family(&family, input, target, arguments, notes, output);
        }
        Err(message) => return Answer::Failed(format!("{input}: {message}")),
    }
    let mut options = Options {
        sides: std::mem::take(&mut named.sides),
        ..options(arguments)
    };
    match planes(input) {
        Ok(planes) => options.required.extend(planes),
        Err(message) => return Answer::Failed(format!("{input}: {message}")),
    }
    let proved = with_dimension!(&named.tiling, AnyTiling, t => match arguments.no_certificate {
        true => examine_tiling(t, input, &options),
        false => prove_tiling(t, input, &options, target, arguments),
    });
    let findings = match proved {
        Ok(answer) => return second::after_proof(answer, &named, arguments, beside),
        Err(NotProved::Refuted(findings)) => findings,
        Err(NotProved::Declined(findings)) => {
            let message = findings.kept().first().map_or(
                String::new(),
                |defect| with_dimension!(&named.tiling, AnyTiling, t => in_words(t, defect)),
            );
            return Answer::Declined(format!("{input}: {message}"));
        }
        Err(NotProved::Io(error)) => return unwritten(target, &error),
        Err(reason) => {
            // The tiling is right by the prover; a certificate that is not confirmed proves nothing.
            return Answer::Declined(format!("{input}: {reason}"));
        }
    };
    if arguments.allow_contact
        && let Some(answer) = second::contact(&findings, &named, &options, target)
    {
        return answer;
    }
    let second: SecondLook = with_dimension!(&named.tiling, AnyTiling, t => {
        second::look(t, &findings, &options)
    });
    let refuted = Refuted {
        tiling: named.tiling,
        origin: named.origin,
        point: None,
        notes: notes.clone(),
        findings,
        second,
        is_exact: arguments.exact,
        shown: arguments.max_defects.unwrap_or(SHOWN),
    };
    if let Some(path) = &arguments.defects
        && let Err(error) = write_file(path, defects::vtu(&refuted).as_bytes())
    {
        return Answer::Failed(format!("{}: cannot be written: {error}", path.display()));
    }
    Answer::Refuted(Box::new(refuted))
}

/// The planes that the certificate of a construction states.
fn planes(input: &str) -> Result<Vec<Requirement>, String> {
    let planes = catalog::find(input).map_or(&[][..], |entry| entry.planes);
    planes.iter().map(|plane| plane.parse()).collect()
}

/// Proves or refutes a family, and tells what else is found.
fn prove_family(
    any: &AnyFamily,
    input: &str,
    target: &Target,
    arguments: &CertifyArguments,
    notes: &mut Vec<String>,
    output: &mut Output,
) -> Answer {
    let first = notes.len();
    let answer = family::prove(any, input, target, arguments, notes);
    for note in &notes[first..] {
        output.complain(format!("{input}: {note}"));
    }
    answer
}

pub(super) fn options(arguments: &CertifyArguments) -> Options {
    Options {
        required: arguments.required.clone(),
        defect_limit: defect_limit(arguments),
        limits: arguments.limits.limits(),
        ..Options::default()
    }
}

/// A theorem, with its own certificate; a member gets a note that says so.
fn theorem_answer(
    proof: theorem::Proof,
    target: &Target,
    arguments: &CertifyArguments,
    notes: &mut Vec<String>,
) -> Answer {
    if let Some(member) = &proof.cited {
        notes.push(format!(
            "proved by citing the theorem {}, whose certificate this is: the input has {member}",
            proof.entry.name
        ));
    }
    let cbor = proof.theorem.certificate().to_vec();
    let bytes = match encoding(target, arguments) {
        Encoding::Cbor => Ok(cbor),
        Encoding::Json => print::to_json(&cbor),
    };
    match bytes {
        Ok(bytes) => Answer::Proved {
            verified: proof.theorem.into_verified(),
            certificate: Written::Bytes(bytes),
        },
        Err(error) => unwritten(target, &io::Error::other(error)),
    }
}

pub(super) fn in_words<const D: usize>(tiling: &Tiling<D>, defect: &Defect) -> String {
    checker::describe::<D>(&Names::of(tiling), defect)
}

/// Twenty defects of each kind for people, all for machines and files, if not said otherwise.
fn defect_limit(arguments: &CertifyArguments) -> usize {
    if arguments.defects.is_some() {
        usize::MAX
    } else if arguments.report.is_some() {
        arguments.max_defects.unwrap_or(LISTED)
    } else if arguments.json {
        arguments.max_defects.unwrap_or(usize::MAX)
    } else {
        arguments.max_defects.unwrap_or(SHOWN)
    }
}

/// The prover's word alone.
fn examine_tiling<const D: usize>(
    tiling: &Tiling<D>,
    name: &str,
    options: &Options,
) -> Result<Answer, NotProved> {
    let progress = Progress::of(name);
    let proof = checker::examine(tiling, options, &|step| progress.step(step))?;
    let claim = transcribe::claim(proof.parts(tiling));
    let statements = proof.statements.iter();
    let boundary = tiling.frame.domain.is_region().then(|| {
        let (kind, facets) = (
            (tiling.frame.rank() > 0),
            if D == 2 { "edges" } else { "triangles" },
        );
        let kind = if kind {
            "a periodic region"
        } else {
            "a bounded region"
        };
        format!(
            "{kind} with a boundary of {} {facets}",
            proof.boundary_facets()
        )
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

/// The kernel has the last word: what it does not confirm is not called proved.
fn prove_tiling<const D: usize>(
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
        (Encoding::Cbor, _) => cbor,
        (Encoding::Json, _) => {
            let json = print::to_json(&cbor);
            json.map_err(|error| NotProved::Io(io::Error::other(error)))?
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
pub(super) fn encoding(target: &Target, arguments: &CertifyArguments) -> Encoding {
    let by_name = match target {
        Target::File(path) => Encoding::of_path(path),
        _ => None,
    };
    arguments.format.or(by_name).unwrap_or(Encoding::Json)
}

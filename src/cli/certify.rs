//! `acutile certify`: proves tilings and writes their certificates.

use super::answer::{Answer, Beside, Written, unwritten};
use super::article::{self, Article};
use super::certify_arguments::{CertifyArguments, Takes};
use super::counts::Counts;
use super::defects;
use super::extension;
use super::family::{self, NO_UNCERTAINTIES, Subject, within_su};
use super::files::is_standard;
use super::input::{self, Loaded};
use super::name::InputName;
use super::named::InputError;
use super::outcome::Outcome;
use super::output::{Output, write_bytes};
use super::overwriting::{check_different, check_output};
use super::prove::{examine_tiling, in_words, prove_tiling, required};
use super::proved::{self, title};
use super::record::verdict;
use super::refutation::{Refuted, SecondLook};
use super::second;
use super::target::{Target, targets};
use super::theorem;
use acutile_catalog as catalog;
use acutile_core::checker::Options;
use acutile_core::family::AnyFamily;
use acutile_core::proved::NotProved;
use acutile_core::statement::counted;
use acutile_core::with_dimension;

/// Certifies every input; the outcome is the worst of all.
pub fn run(arguments: &CertifyArguments, output: &mut Output) -> Outcome {
    let mut inputs: Vec<InputName> = Vec::new();
    let theorems = catalog::THEOREMS.iter().map(|theorem| theorem.name);
    let all = catalog::names()
        .chain(catalog::large_names())
        .chain(catalog::family_names())
        .chain(theorems)
        .filter(|_| arguments.all)
        .map(InputName::from);
    for input in arguments.inputs.iter().cloned().chain(all) {
        if !inputs.contains(&input) {
            inputs.push(input);
        }
    }
    let targets = check(&inputs, arguments).and_then(|()| targets(&inputs, arguments));
    let targets = match targets {
        Ok(targets) => targets,
        Err(message) => return output.fail_with(None, message),
    };
    let moves = arguments.file.mesh.moves.as_ref();
    let files = [arguments.report.as_ref(), arguments.defects.as_ref(), moves];
    let is_used = files.into_iter().flatten().any(|path| is_standard(path));
    if is_used || matches!(targets[..], [Target::StandardOutput]) {
        output.document_goes_to(None);
    }
    let mut worst = Outcome::Done;
    let mut counts = Counts::default();
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
        if let (Answer::Proved { .. }, Some(raised)) = (&answer, arguments.limits.raised()) {
            let note = format!(
                "the certificate is confirmed with {raised}; acutile-verify may need the same options"
            );
            output.complain(format!("{input}: {note}"));
            notes.push(note);
        }
        let answer = answer.write(&target, output);
        answer.report(input, &target, arguments, &notes, &beside, output);
        counts.add(verdict(answer.outcome()));
        worst = worst.and(strictly(answer.outcome(), arguments, &beside));
    }
    counts.tell(output);
    if let Some(path) = arguments.report.as_deref().filter(|_| !articles.is_empty()) {
        worst = worst.and(article::write(&articles, Some(path), output));
        output.tell_files();
    }
    worst
}

/// The names of all files that are written promise what is written, and are no inputs.
fn check(inputs: &[InputName], arguments: &CertifyArguments) -> Result<(), String> {
    let moves = arguments.file.mesh.moves.as_deref();
    for (path, option, words, extensions) in [
        (
            arguments.report.as_deref(),
            "--report",
            "a page",
            extension::PAGE,
        ),
        (
            arguments.defects.as_deref(),
            "--defects",
            "VTU",
            &["vtu"][..],
        ),
        (moves, "--moves", "CSV", &["csv", "txt"][..]),
    ] {
        check_output(path, option, inputs)?;
        extension::check(path, words, extensions)
            .map_err(|problem| format!("{option} {problem}"))?;
    }
    check_different(&[
        ("-o", arguments.output.as_deref()),
        ("--report", arguments.report.as_deref()),
        ("--defects", arguments.defects.as_deref()),
        ("--moves", moves),
    ])
}

/// The part of the page of --report about an input.
fn article(
    input: &InputName,
    answer: &Answer,
    arguments: &CertifyArguments,
) -> Result<Article, InputError> {
    match answer {
        Answer::Refuted(refuted) => Ok(Article::Refuted(Box::new(refuted.article(&title(input))))),
        Answer::Failed(message) | Answer::Declined(message) => {
            let message = message.clone();
            let outcome = answer.outcome();
            Err(InputError { message, outcome })
        }
        Answer::Proved {
            certificate: Written::Bytes(bytes),
            ..
        } => proved::article(input, String::new(), bytes, &arguments.limits.limits()),
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

/// Which options mean something for an input.
fn takes(input: &str, loaded: &Loaded) -> Takes {
    let Loaded::Tiling(named) = loaded else {
        return Takes::default();
    };
    Takes {
        has_given_simplices: catalog::find(input).is_none(),
        is_mesh_file: named.origin.is_some(),
        is_region: with_dimension!(&named.tiling, AnyTiling, t => t.frame.domain.is_region()),
    }
}

/// Proves or refutes; `notes` gets what was done to the input before, `beside` what is said more.
fn prove(
    input: &InputName,
    target: &Target,
    arguments: &CertifyArguments,
    notes: &mut Vec<String>,
    beside: &mut Beside,
    output: &mut Output,
) -> Answer {
    match theorem::of_input(input, arguments) {
        Some(Ok(proof)) => {
            return match arguments.family.check(Subject::Theorem) {
                Ok(()) => theorem::answer(proof, target, arguments, notes),
                Err(message) => Answer::Failed(format!("{input}: {message}")),
            };
        }
        Some(Err(error)) => return error.into(),
        None => {}
    }
    let mut file = arguments.file.clone();
    file.points.within_su = arguments.family.within_su;
    let loaded = input::open(input, arguments.param.as_deref(), &file, output);
    if let Ok(loaded) = &loaded
        && let Err(message) = arguments.check_for(input, takes(input, loaded))
    {
        return Answer::Failed(message);
    }
    let varied = match &loaded {
        Ok(Loaded::Points(points)) => points.variation.clone().map(|v| (points.set.clone(), v)),
        _ => None,
    };
    let named = match loaded {
        Ok(Loaded::Family(_)) if arguments.family.within_su => {
            return Answer::Failed(format!("{input}: {NO_UNCERTAINTIES}"));
        }
        Ok(Loaded::Family(named)) => {
            if let Err(message) = arguments.family.check(Subject::Family) {
                return Answer::Failed(format!("{input}: {message}"));
            }
            return prove_family(&named.family, input, target, arguments, notes, output);
        }
        Ok(loaded) => loaded.tiling(input, &file, output),
        Err(error) => Err(error),
    };
    let mut named = match named {
        Ok(named) => named,
        Err(error) => return error.into(),
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
        for (simplex, element) in &mut named.curved {
            if mended.binary_search(simplex).is_ok() {
                element.turn();
            }
        }
        if !mended.is_empty() {
            let note = format!(
                "{} reoriented",
                counted(mended.len(), "simplex", "simplices")
            );
            output.complain(format!("{input}: {note}"));
            notes.push(note);
        }
    }
    beside.others = second::others(&named);
    if !named.curved.is_empty() {
        return second::curved(input, &named, arguments);
    }
    if let Err(message) = arguments.family.check(Subject::Tiling) {
        return Answer::Failed(format!("{input}: {message}"));
    }
    let freed = match varied {
        Some((points, variation)) => within_su(&named.tiling, &points, &variation).map(Some),
        None if arguments.family.within_su => Err(NO_UNCERTAINTIES.to_owned()),
        None => arguments.family.freed(&named.tiling),
    };
    match freed {
        Ok(None) => {}
        Ok(Some(family)) => {
            return prove_family(&family, input, target, arguments, notes, output);
        }
        Err(message) => return Answer::Failed(format!("{input}: {message}")),
    }
    let options = match required(input, arguments, output.is_json()) {
        Ok(options) => Options {
            sides: std::mem::take(&mut named.sides),
            ..options
        },
        Err(message) => return Answer::Failed(format!("{input}: {message}")),
    };
    let proved = with_dimension!(&named.tiling, AnyTiling, t => if arguments.no_certificate {
        examine_tiling(t, input, &options)
    } else {
        prove_tiling(t, input, &options, target, arguments)
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
        shown: arguments.max_defects,
    };
    if let Some(path) = &arguments.defects
        && let Err(error) = write_bytes(Some(path), defects::vtu(&refuted).as_bytes(), output)
    {
        return Answer::Failed(error.message);
    }
    Answer::Refuted(Box::new(refuted))
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
    let options = match required(input, arguments, output.is_json()) {
        Ok(options) => options,
        Err(message) => return Answer::Failed(format!("{input}: {message}")),
    };
    let answer = family::prove(any, input, target, (arguments, options), notes);
    for note in &notes[first..] {
        output.complain(format!("{input}: {note}"));
    }
    answer
}

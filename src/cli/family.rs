//! `acutile certify` for families: a tiling for each point of a box of parameters.

use super::certify::{Answer, CertifyArguments, Written, defect_limit, encoding};
use super::encoding::Encoding;
use super::progress::Progress;
use super::refutation::Refuted;
use super::target::Target;
use acutile_core::checker::Options;
use acutile_core::family::{
    self, AnyFamily, FamilyNotProved, NotProvable, ProvedFamily, point_in_words,
};
use acutile_core::format::print;
use acutile_core::refusal;
use acutile_core::tiling::AnyTiling;
use acutile_core::with_family;
use acutile_exact::number::Number;

/// Proves or refutes; `notes` gets what else is to be said.
pub fn prove(
    family: &AnyFamily,
    input: &str,
    target: &Target,
    arguments: &CertifyArguments,
    notes: &mut Vec<String>,
) -> Answer {
    let options = Options {
        required: arguments.required.clone(),
        defect_limit: defect_limit(arguments),
        limits: arguments.limits.limits(),
    };
    let progress = Progress::of(input);
    let step = |step: &str| progress.step(step);
    let proved = with_family!(family, f => family::prove(f, &options, &step));
    match proved {
        Ok(proved) => answer(proved, target, arguments, notes),
        Err(error) => refused(family, input, error, notes),
    }
}

fn answer(
    proved: ProvedFamily,
    target: &Target,
    arguments: &CertifyArguments,
    notes: &mut Vec<String>,
) -> Answer {
    let leaves = proved.tree().leaves();
    if leaves > 1 {
        notes.push(format!("the box is cut into {leaves} parts"));
    }
    let bytes = match (encoding(target, arguments), target) {
        (_, Target::Nowhere) => Vec::new(),
        (Encoding::Cbor, _) => proved.certificate().to_vec(),
        (Encoding::Json, _) => match print::to_json(proved.certificate()) {
            Ok(json) => json,
            Err(error) => return Answer::Failed(error.to_string()),
        },
    };
    Answer::Proved {
        verified: proved.into_verified(),
        certificate: Written::Bytes(bytes),
    }
}

fn refused(family: &AnyFamily, input: &str, error: FamilyNotProved, notes: &[String]) -> Answer {
    let names = with_family!(family, f => f.names());
    match error {
        FamilyNotProved::Prover(NotProvable::Malformed(error)) => {
            Answer::Failed(format!("{input}: {error}"))
        }
        FamilyNotProved::Prover(NotProvable::Declined(reason)) => {
            Answer::Declined(format!("{input}: {reason}"))
        }
        FamilyNotProved::Prover(NotProvable::Refuted { point, findings }) => {
            Answer::Refuted(Box::new(Refuted {
                tiling: member(family, &point),
                point: Some(point_in_words(&names, &point)),
                origin: None,
                notes: notes.to_vec(),
                findings,
            }))
        }
        FamilyNotProved::Unconfirmed(refusal) => Answer::Declined(format!(
            "{input}: the kernel does not confirm the certificate: {}",
            refusal::in_words(&refusal)
        )),
    }
}

fn member(family: &AnyFamily, point: &[Number]) -> AnyTiling {
    match family {
        AnyFamily::Plane(family) => AnyTiling::Plane(family.at(point)),
        AnyFamily::Space(family) => AnyTiling::Space(family.at(point)),
    }
}

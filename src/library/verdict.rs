//! Statements, and the prover's verdict on a tiling.

use super::{Certificate, Error, Limits, Tiling};
use acutile_core::checker::{self, Findings};
use acutile_core::proved::{NotProved, prove};
use acutile_core::statement::Requirement;
use acutile_core::tiling;
use acutile_core::with_dimension;
use std::fmt;
use std::str::FromStr;

/// A statement that a tiling must have, in the words of `acutile certify --require`.
///
/// ```
/// use acutile::Statement;
///
/// let acute: Statement = "acute".parse()?;
/// let bound: Statement = "dihedral<77.08".parse()?;
/// assert!("dihedral<ninety".parse::<Statement>().is_err());
/// # Ok::<(), acutile::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Statement(Requirement);

impl FromStr for Statement {
    type Err = Error;

    fn from_str(text: &str) -> Result<Statement, Error> {
        let requirement = text.parse().map_err(|error: String| Error::new(error))?;
        Ok(Statement(requirement))
    }
}

impl fmt::Display for Statement {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// Statements that must hold, and the limits within which they are proved.
///
/// ```
/// use acutile::{Limits, Options};
///
/// let options = Options::default()
///     .require("acute".parse()?)
///     .require("dihedral<78.47".parse()?)
///     .limits(Limits::default().simplices(1_000));
/// let a15 = acutile::Tiling::named("a15")?;
/// assert!(matches!(acutile::certify(&a15, &options)?, acutile::Verdict::Proved(_)));
/// # Ok::<(), acutile::Error>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Options {
    required: Vec<Statement>,
    limits: Option<Limits>,
}

impl Options {
    /// As they are, and the statement must hold.
    pub fn require(mut self, statement: Statement) -> Options {
        self.required.push(statement);
        self
    }

    /// As they are, with these limits of the kernel.
    pub fn limits(mut self, limits: Limits) -> Options {
        self.limits = Some(limits);
        self
    }
}

/// The prover's answer. "Declined" is not "refuted".
///
/// ```
/// use acutile::{Options, Tiling, Verdict, certify};
///
/// # let a15 = Tiling::named("a15")?;
/// let words = match certify(&a15, &Options::default())? {
///     Verdict::Proved(certificate) => format!("proved in {} bytes", certificate.as_bytes().len()),
///     Verdict::Refuted(findings) => format!("refuted: {}", findings[0]),
///     Verdict::Declined(findings) => format!("not decided: {}", findings[0]),
///     _ => "an answer of a later version".to_owned(),
/// };
/// assert!(words.starts_with("proved"));
/// # Ok::<(), acutile::Error>(())
/// ```
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Verdict {
    /// The kernel has confirmed the certificate. It contains the required statements, and the
    /// strongest of the others that hold.
    Proved(Certificate),
    /// Something required does not hold; each finding has an exact witness.
    Refuted(Vec<Finding>),
    /// Neither proved nor refuted.
    Declined(Vec<Finding>),
}

/// One reason why a tiling is not proved.
///
/// ```
/// use acutile::{Options, Tiling, Verdict, certify};
///
/// // Two tetrahedra on the same side of their common facet.
/// let points = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.], [0., 0., 2.]];
/// let mesh = Tiling::mesh(&points, &[[0, 1, 2, 3], [0, 1, 2, 4]])?;
/// let Verdict::Refuted(findings) = certify(&mesh, &Options::default())? else {
///     panic!("the tetrahedra overlap");
/// };
/// assert_eq!(findings[0].code, "same-side");
/// # Ok::<(), acutile::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Finding {
    /// The kind, a word that stays the same between versions, such as `right-angle`.
    pub code: String,
    /// One sentence with the place, the expected and the exact found value.
    pub message: String,
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Finding {}

/// Proves that a tiling is one and that the required statements hold.
///
/// ```
/// use acutile::{Options, Tiling, Verdict, certify};
///
/// // The largest angles of Sommerville's tetrahedra are right angles.
/// let bcc = Tiling::named("bcc")?;
/// let nonobtuse = certify(&bcc, &Options::default().require("nonobtuse".parse()?))?;
/// assert!(matches!(nonobtuse, Verdict::Proved(_)));
/// let Verdict::Refuted(findings) = certify(&bcc, &Options::default().require("acute".parse()?))?
/// else {
///     panic!("a right angle is not acute");
/// };
/// assert_eq!(findings[0].code, "right-angle");
/// # Ok::<(), acutile::Error>(())
/// ```
///
/// # Errors
/// A certificate that the kernel does not confirm, which is a fault of this library.
pub fn certify(tiling: &Tiling, options: &Options) -> Result<Verdict, Error> {
    let settings = options.settings(tiling);
    let answer = with_dimension!(tiling.any(), AnyTiling, t => {
        prove(t, &settings, &|_| {}).map_err(|error| match error {
            NotProved::Refuted(found) => Ok((true, described(tiling, t, &found))),
            NotProved::Declined(found) => Ok((false, described(tiling, t, &found))),
            other => Err(Error::new(other)),
        })
    });
    match answer {
        Ok(proved) => Ok(Verdict::Proved(Certificate::of_cbor(
            proved.certificate().to_vec(),
        ))),
        Err(Ok((true, findings))) => Ok(Verdict::Refuted(findings)),
        Err(Ok((false, findings))) => Ok(Verdict::Declined(findings)),
        Err(Err(error)) => Err(error),
    }
}

impl Options {
    fn settings(&self, tiling: &Tiling) -> checker::Options {
        let mut settings = checker::Options {
            required: self
                .required
                .iter()
                .map(|statement| statement.0.clone())
                .collect(),
            sides: tiling.sides().clone(),
            ..checker::Options::default()
        };
        if let Some(limits) = &self.limits {
            settings.limits = limits.0.clone();
        }
        settings
    }
}

fn described<const D: usize>(
    input: &Tiling,
    tiling: &tiling::Tiling<D>,
    findings: &Findings,
) -> Vec<Finding> {
    let names = input.names(tiling);
    let found = findings.kept().iter().map(|defect| Finding {
        code: defect.code().to_owned(),
        message: checker::describe::<D>(&names, defect),
    });
    found.collect()
}

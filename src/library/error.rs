//! Why something cannot be read or is not confirmed.

use std::fmt::{self, Display};

/// A message for people, in the words of the command line.
///
/// ```
/// use acutile::{Error, Tiling};
///
/// let error: Error = Tiling::named("a51").unwrap_err();
/// assert!(error.to_string().starts_with("a51: "), "{error}");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error(String);

impl Error {
    pub(crate) fn new(message: impl Display) -> Error {
        Error(message.to_string())
    }

    /// The same message about `source`, a file or a name.
    pub(crate) fn of(source: &impl Display, message: impl Display) -> Error {
        Error(format!("{source}: {message}"))
    }
}

impl Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Error {}

//! Errors as Python exceptions, in the words of the command line.

use pyo3::create_exception;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::fmt::Display;

create_exception!(
    acutile,
    Failed,
    PyValueError,
    "An input that cannot be read, or a certificate that is not confirmed."
);

/// An exception with these words.
pub fn failed(message: impl Display) -> PyErr {
    Failed::new_err(message.to_string())
}

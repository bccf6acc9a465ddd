//! Errors as Python exceptions, in the words of the command line.

use acutile_kernel::Refusal;
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

/// The kernel's refusal of a certificate.
pub fn refusal(refusal: &Refusal) -> PyErr {
    failed(acutile_core::refusal::in_words(refusal))
}

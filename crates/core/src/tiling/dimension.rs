//! Casts for code that is compiled once for each dimension.
//!
//! A generic function is compiled anew in every crate that calls it, and the prover would be
//! compiled six times. So its largest functions only cast to the plane or to space. They then call
//! a function without parameters, which is compiled in this crate alone.

use std::any::Any;

/// A reference to `value` by another name of its type.
///
/// # Panics
/// If the types differ, as in a dimension that is neither 2 nor 3.
pub(crate) fn same<A: 'static, B: 'static>(value: &A) -> &B {
    let value: &dyn Any = value;
    value.downcast_ref().expect("dimension 2 or 3")
}

/// As [`same`], for the value itself.
pub(crate) fn same_value<A: 'static, B: 'static>(value: A) -> B {
    let mut slot = Some(value);
    let any: &mut dyn Any = &mut slot;
    let slot: Option<&mut Option<B>> = any.downcast_mut();
    slot.and_then(Option::take).expect("dimension 2 or 3")
}

//! Indices of the parts of a tiling, one type for each kind of part.
//!
//! They are all small integers, so a plain integer would let one kind stand for another.

use std::fmt;

macro_rules! index {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(transparent)]
        pub struct $name(u32);

        impl $name {
            /// The index with this number, from 0.
            pub const fn new(number: u32) -> Self {
                $name(number)
            }

            /// The index of a place in a list.
            ///
            /// # Panics
            /// If the list is longer than 2^32.
            pub fn at(place: usize) -> Self {
                $name(u32::try_from(place).expect("a tiling has less than 2^32 of each part"))
            }

            /// The place in a list.
            pub const fn index(self) -> usize {
                self.0 as usize
            }

            /// The number, from 0.
            pub const fn number(self) -> u32 {
                self.0
            }
        }

        impl From<u32> for $name {
            fn from(number: u32) -> Self {
                $name(number)
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
                self.0.fmt(f)
            }
        }
    };
}

index! {
    /// Index into [`Tiling::vertices`](super::Tiling::vertices).
    VertexId
}
index! {
    /// Index of a simplex of a tiling.
    SimplexId
}
index! {
    /// The number s (D + 1) + i of the facet opposite to corner i of simplex s.
    FacetId
}

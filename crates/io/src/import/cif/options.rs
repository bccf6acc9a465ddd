//! The options of the reader.

/// How a CIF is read.
#[derive(Clone, Debug, Default)]
pub struct CifOptions {
    /// The data block, where several have sites.
    pub block: Option<String>,
    /// Decimals become the multiple of 1/snap that agrees with all of their digits.
    pub snap: Option<u32>,
    /// Labels of the sites that are taken; all where there is none.
    pub only: Vec<String>,
    /// Sites of any occupancy are atoms, and those at one place are one.
    pub ignore_occupancy: bool,
}

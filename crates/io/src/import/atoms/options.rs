//! The options of the reader.

/// How a crystal structure is read.
#[derive(Clone, Debug, Default)]
pub struct CifOptions {
    /// The data block, where several have sites.
    pub block: Option<String>,
    /// Decimals become the multiple of 1/snap that agrees with all of their digits.
    pub snap: Option<u32>,
    /// Labels or elements of the sites that are taken; all if there is none.
    pub only: Vec<String>,
    /// Labels or elements of the sites that are left out.
    pub except: Vec<String>,
    /// Sites of any occupancy but zero are atoms, and those at one place are one.
    pub ignore_occupancy: bool,
    /// Sites that lie on a special position within their digits.
    pub special: Special,
    /// Make the free numbers with standard uncertainties parameters.
    pub within_su: bool,
}

/// The treatment of a site that an operation moves by less than the site's written digits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Special {
    /// The file is refused: the number of atoms is not certain.
    #[default]
    Refuse,
    /// The site is moved onto the mean of its images.
    Move,
    /// The site stays as it is written.
    AsWritten,
}

//! The command line as clap reads it: the commands, each with its arguments.

use super::appendix::AppendixArguments;
use super::bundle::BundleArguments;
use super::certify::CertifyArguments;
use super::classify::ClassifyArguments;
use super::convert::ConvertArguments;
use super::delaunay::DelaunayArguments;
use super::draw::DrawArguments;
use super::export::ExportArguments;
use super::gallery::GalleryArguments;
use super::list::ListArguments;
use super::lower_bound::LowerBoundArguments;
use super::new::NewArguments;
use super::paper::PaperArguments;
use super::quality::QualityArguments;
use super::report::ReportArguments;
use super::show::ShowArguments;
use super::table::TableArguments;
use super::verify::VerifyArguments;
use clap::{Args, Parser, Subcommand};

/// Proves, in exact arithmetic, that tilings by tetrahedra are valid and acute.
#[derive(Debug, Parser)]
#[command(name = "acutile", version, about, max_term_width = 100)]
#[command(
    after_help = "Exit codes: 0 proved or verified, 1 refuted or rejected, \
    2 usage or unreadable input, 3 declined."
)]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    /// List the catalogue of constructions
    List(ListArguments),
    /// Tell what a tiling is: counts, lattice, field, shapes
    Show(ShowArguments),
    /// Write a commented starting example of a kind of file
    New(NewArguments),
    /// Prove a tiling and write its certificate
    Certify(CertifyArguments),
    /// Re-check certificates with the independent kernel
    Verify(VerifyArguments),
    /// Compute the periodic Delaunay triangulation of a point set
    Delaunay(DelaunayArguments),
    /// Write a tiling, or a supercell of it, as a tiling file, or a certificate for Coq
    Export(ExportArguments),
    /// Turn a mesh or a tiling into a mesh file of another format, or a tiling file
    Convert(ConvertArguments),
    /// The paper's table, as rigorous enclosures, and rows it does not have
    Table(TableArguments),
    /// Every checkable statement of the paper, with a verdict
    ///
    /// The exit code is 0 when every statement was settled, misprints included, and 3 when one
    /// was not.
    Paper(PaperArguments),
    /// Lower bounds for the largest dihedral angle of any tiling: the finite part of the proof
    ///
    /// Decides every numerical inequality, box and combinatorial lemma of docs/lower-bound.md in
    /// exact arithmetic. The exit code is 1 when one fails, and 3 when one is undecided.
    LowerBound(LowerBoundArguments),
    /// How good the simplices are: dihedral angles, radius-edge and aspect ratios
    Quality(QualityArguments),
    /// Write a page to look at: the tiling in three dimensions, its exact data, its certificate
    ///
    /// One HTML file that loads nothing. A tiling that is no certificate yet is proved first;
    /// nothing is written that the kernel does not confirm.
    Report(ReportArguments),
    /// Write a static site of the whole catalogue
    Gallery(GalleryArguments),
    /// Figures for print, as SVG or TikZ, with hidden lines found exactly
    Draw(DrawArguments),
    /// Valences, vertex types, TCP or why not, and what the tiling is isomorphic to
    Classify(ClassifyArguments),
    /// A LaTeX appendix about certificates: theorem, numbers, and how to check them
    Appendix(AppendixArguments),
    /// An archive to deposit: certificates, appendix, page, meshes, verifiers, checksums
    ///
    /// A tiling that is no certificate yet is proved first; nothing is written that the kernel does
    /// not confirm. The same input gives the same bytes.
    Bundle(BundleArguments),
    /// Print a completion script for a shell
    Completions(CompletionsArguments),
    /// Print the manual page
    Man,
}

#[derive(Debug, Args)]
pub struct CompletionsArguments {
    /// The shell
    #[arg(value_enum)]
    pub shell: clap_complete::Shell,
}

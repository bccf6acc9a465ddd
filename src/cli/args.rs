//! The command line as clap reads it: the commands, each with its arguments.

use super::appendix::AppendixArguments;
use super::bundle::BundleArguments;
use super::certify_arguments::CertifyArguments;
use super::cite::CiteArguments;
use super::classify::ClassifyArguments;
use super::convert::ConvertArguments;
use super::delaunay::DelaunayArguments;
use super::draw::DrawArguments;
use super::export::ExportArguments;
use super::gallery::GalleryArguments;
use super::list::ListArguments;
use super::lower_bound::LowerBoundArguments;
use super::new::NewArguments;
use super::optimize_arguments::OptimizeArguments;
use super::paper::PaperArguments;
use super::quality::QualityArguments;
use super::records::RecordsArguments;
use super::report::ReportArguments;
use super::search::SearchArguments;
use super::show::ShowArguments;
use super::table::TableArguments;
use super::verify::VerifyArguments;
use clap::{Args, Parser, Subcommand};
use std::path::PathBuf;

/// The end of a long help: examples, and exit codes.
macro_rules! examples {
    ($lines:literal) => {
        concat!(
            "Examples:",
            $lines,
            "\n\nExit codes: 0 proved or verified, 1 refuted or rejected, 2 usage or unreadable \
             input, 3 declined."
        )
    };
}

/// Proves in exact arithmetic that tilings and meshes of tetrahedra are valid, acute or Delaunay.
#[derive(Debug, Parser)]
#[command(name = "acutile", version, about, max_term_width = 100)]
#[command(
    after_help = "Exit codes: 0 proved or verified, 1 refuted or rejected, \
    2 usage or unreadable input, 3 declined."
)]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Command,
    /// Answer in JSON: one object a line, one for each input (docs/json.md)
    #[arg(long, global = true)]
    pub json: bool,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    /// List the catalogue of constructions
    #[command(after_long_help = examples!("\n  acutile list"))]
    List(ListArguments),
    /// Show a tiling: counts, lattice, field, shapes
    #[command(after_long_help = examples!("\n  acutile show a15\n  acutile show mine.json"))]
    Show(ShowArguments),
    /// Write a commented starting example of a kind of file
    #[command(after_long_help = examples!("\n  acutile new slab > mine.json"))]
    New(NewArguments),
    /// Prove a tiling and write its certificate
    #[command(after_long_help = examples!("\n  acutile certify a15 --require acute -o a15.cbor\n  acutile certify mine.json --require acute,delaunay\n  acutile certify part.msh --require dihedral-above=10 --json\n  acutile certify sigma.cif --snap 3\n  acutile certify --all -o certificates"))]
    Certify(CertifyArguments),
    /// Re-check certificates with the independent kernel
    #[command(after_long_help = examples!("\n  acutile verify a15.cbor\n  acutile verify certificates/a15.json certificates/z.json --json"))]
    Verify(VerifyArguments),
    /// Compute the periodic Delaunay triangulation of a point set
    #[command(after_long_help = examples!("\n  acutile delaunay points.json -o tiling.json"))]
    Delaunay(DelaunayArguments),
    /// Write a tiling, or a supercell of it, as a tiling file or for Sage, Mathematica, GAP or Lean; a certificate for Coq
    #[command(after_long_help = examples!("\n  acutile export a15 --supercell 3,3,3 -o big.json\n  acutile export sigma -o sigma.sage\n  acutile export a15.cbor --coq -o a15.v"))]
    Export(ExportArguments),
    /// Turn a mesh or a tiling into a mesh file of another format, or a tiling file
    #[command(after_long_help = examples!("\n  acutile convert part.msh part.vtu\n  acutile convert a15 a15.vtu --supercell 3,3,3\n  acutile convert a15.json a15.cbor"))]
    Convert(ConvertArguments),
    /// The paper's table, as rigorous enclosures, and rows it does not have
    #[command(after_long_help = examples!("\n  acutile table\n  acutile table a15 z --format latex"))]
    Table(TableArguments),
    /// Every checkable statement of the paper, with a verdict
    ///
    /// The exit code is 0 when every statement was settled, misprints included, and 3 when one
    /// was not.
    #[command(after_long_help = examples!("\n  acutile paper"))]
    Paper(PaperArguments),
    /// Lower bounds for the largest dihedral angle of any tiling: the finite part of the proof
    ///
    /// Decides every numerical inequality, box and combinatorial lemma of docs/lower-bound.md in
    /// exact arithmetic. The exit code is 1 when one fails, and 3 when one is undecided.
    #[command(after_long_help = examples!(
        "\n  acutile lower-bound\n  acutile lower-bound --json > lower-bound.json"
    ))]
    LowerBound(LowerBoundArguments),
    /// Move vertices and lattice for better angles, and prove the result
    ///
    /// Doubles search; the result is rational and proved. The combinatorics, the symmetry and the boundary
    /// stay. The exit code is 3 if nothing better is found, and with --goal acute if the result is not
    /// acute. The best so far is written in any case. Ctrl-C ends the search with the best so far.
    #[command(after_long_help = examples!("\n  acutile optimize c14 -o c14-best.cbor\n  acutile optimize part.msh --goal acute -o part.cbor\n  acutile optimize slab --denominator 100 --json"))]
    Optimize(OptimizeArguments),
    /// The best certified tilings of each kind of domain, the literature, and lower bounds
    ///
    /// Every value comes from a certificate that is proved in the run, every lower bound from checks that are
    /// decided in it.
    #[command(after_long_help = examples!("\n  acutile records\n  acutile records --format latex -o records.tex"))]
    Records(RecordsArguments),
    /// Search for acute slabs over plane tilings, or for polyhedra in the 600-cell
    ///
    /// Says what was tried. The exit code is 3 when no acute slab is found.
    #[command(after_long_help = examples!("\n  acutile search slab\n  acutile search balls"))]
    Search(SearchArguments),
    /// How good the simplices are: dihedral angles, radius-edge and aspect ratios
    #[command(after_long_help = examples!("\n  acutile quality part.vtu\n  acutile quality part.vtu --format svg -o angles.svg"))]
    Quality(QualityArguments),
    /// Write a page to look at: the tiling in three dimensions, its exact data, its certificate
    ///
    /// One HTML file that loads nothing. A tiling without a certificate is proved first.
    /// A refuted tiling gets a page with its defects.
    #[command(after_long_help = examples!("\n  acutile report a15 slab -o report.html"))]
    Report(ReportArguments),
    /// Write a static site of the whole catalogue
    #[command(after_long_help = examples!("\n  acutile gallery -o site"))]
    Gallery(GalleryArguments),
    /// Figures for print, as SVG or TikZ, with hidden lines found exactly
    #[command(after_long_help = examples!("\n  acutile draw a15 -o a15.svg\n  acutile draw slab --figure steps --format tikz -o slab.tex"))]
    Draw(DrawArguments),
    /// Valences, vertex types, TCP or why not, and what the tiling is isomorphic to
    ///
    /// Of a point set or a crystal structure also its Delaunay cells, the Voronoi neighbours of each site,
    /// and the space group.
    #[command(after_long_help = examples!("\n  acutile classify mine.json\n  acutile classify sigma.cif --snap 3 --json"))]
    Classify(ClassifyArguments),
    /// A LaTeX appendix about certificates: theorem, numbers, and how to check them
    #[command(after_long_help = examples!("\n  acutile appendix a15 slab -o appendix"))]
    Appendix(AppendixArguments),
    /// An archive to deposit: certificates, appendix, page, meshes, verifiers, checksums
    ///
    /// A tiling that is no certificate yet is proved first; nothing is written that the kernel does
    /// not confirm. The same input gives the same bytes.
    #[command(after_long_help = examples!("\n  acutile bundle a15 slab -o artefact.zip\n  acutile bundle a15 --author 'Carberry, Josiah <0000-0002-1825-0097>' --licence CC-BY-4.0 -o a15.zip"))]
    Bundle(BundleArguments),
    /// How to cite a certificate: BibTeX, and a paragraph on what was proved by what, and what was not
    ///
    /// A tiling that is no certificate yet is proved first. The text is a .bib file as it is.
    #[command(after_long_help = examples!("\n  acutile cite a15\n  acutile cite mine.cbor -o mine.bib"))]
    Cite(CiteArguments),
    /// Print a completion script for a shell
    ///
    /// Every shell completes commands, options and names of the catalogue. Elvish and PowerShell complete one
    /// name for each command, and no values of options.
    #[command(after_long_help = examples!("\n  acutile completions bash > acutile.bash"))]
    Completions(CompletionsArguments),
    /// Print the manual page, or write one for each command
    #[command(after_long_help = examples!("\n  acutile man | man -l -\n  acutile man man1"))]
    Man(ManArguments),
}

#[derive(Debug, Args)]
pub struct CompletionsArguments {
    /// The shell
    #[arg(value_enum)]
    pub shell: clap_complete::Shell,
}

#[derive(Debug, Args)]
pub struct ManArguments {
    /// Write acutile.1 and a page for each command, such as acutile-certify.1, into this folder
    #[arg(value_name = "DIR")]
    pub folder: Option<PathBuf>,
    /// Replace files that are there, even if they are others'
    #[arg(long)]
    pub force: bool,
}

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
    /// Check certificates with the independent kernel
    #[command(after_long_help = examples!("\n  acutile verify a15.cbor\n  acutile verify certificates/a15.json certificates/z.json --json"))]
    Verify(VerifyArguments),
    /// Compute the periodic Delaunay triangulation of a point set
    #[command(after_long_help = examples!("\n  acutile delaunay points.json -o tiling.json"))]
    Delaunay(DelaunayArguments),
    /// Write a tiling as a tiling file or for Sage, Mathematica, GAP or Lean, or a certificate for Coq
    #[command(after_long_help = examples!("\n  acutile export a15 --supercell 3,3,3 -o big.json\n  acutile export sigma -o sigma.sage\n  acutile export a15.cbor --coq -o a15.v"))]
    Export(ExportArguments),
    /// Convert a mesh, a tiling or a certificate to another format
    #[command(after_long_help = examples!("\n  acutile convert part.msh part.vtu\n  acutile convert a15 a15.vtu --supercell 3,3,3\n  acutile convert a15.json a15.cbor"))]
    Convert(ConvertArguments),
    /// Print Table 1 of the paper for any tilings: proved bounds of angles and ratios
    #[command(after_long_help = examples!("\n  acutile table\n  acutile table a15 z --format latex"))]
    Table(TableArguments),
    /// Decide every checkable statement of the paper
    ///
    /// The exit code is 0 if every statement is settled, misprints included, and otherwise 3.
    #[command(after_long_help = examples!("\n  acutile paper"))]
    Paper(PaperArguments),
    /// Decide the finite part of the proof that every tiling has a large dihedral angle
    ///
    /// Decides every numerical inequality, box and combinatorial lemma of docs/lower-bound.md in
    /// exact arithmetic. The exit code is 1 if one fails, and 3 if one is undecided.
    #[command(after_long_help = examples!(
        "\n  acutile lower-bound\n  acutile lower-bound --json > lower-bound.json"
    ))]
    LowerBound(LowerBoundArguments),
    /// Move vertices and lattice for better angles, and prove the result
    ///
    /// The search uses floating-point numbers. The result has exact coordinates, and it is proved. The
    /// combinatorial type, the symmetry and the boundary do not change. The exit code is 3 if nothing better
    /// is found, or if the result of --goal acute is not acute. In any case the best tiling found is written.
    /// Ctrl-C ends the search, and the best tiling found so far is proved and written.
    #[command(after_long_help = examples!("\n  acutile optimize c14 -o c14-best.cbor\n  acutile optimize part.msh --goal acute -o part.cbor\n  acutile optimize slab --denominator 100 --json"))]
    Optimize(OptimizeArguments),
    /// List the best certified tilings of each kind of domain, the literature, and lower bounds
    ///
    /// The command proves the certificate of every value, and decides the checks of every lower bound.
    #[command(after_long_help = examples!("\n  acutile records\n  acutile records --format latex -o records.tex"))]
    Records(RecordsArguments),
    /// Search for acute slabs over plane tilings, or for polyhedra in the 600-cell
    ///
    /// Prints the number of candidates. The exit code is 3 if nothing acute is found.
    #[command(after_long_help = examples!("\n  acutile search slab\n  acutile search balls"))]
    Search(SearchArguments),
    /// Measure the simplices: dihedral angles, radius-edge ratios and aspect ratios
    #[command(after_long_help = examples!("\n  acutile quality part.vtu\n  acutile quality part.vtu --format svg -o angles.svg"))]
    Quality(QualityArguments),
    /// Write an HTML page: the tiling in three dimensions, its exact data and its certificate
    ///
    /// The page is one file, and works without network access. A tiling without a certificate is proved
    /// first. The page of a refuted tiling shows its defects.
    #[command(after_long_help = examples!("\n  acutile report a15 slab -o report.html"))]
    Report(ReportArguments),
    /// Write a static site of the whole catalogue
    #[command(after_long_help = examples!("\n  acutile gallery -o site"))]
    Gallery(GalleryArguments),
    /// Draw figures for print: SVG, TikZ, PDF or PNG, with hidden lines found exactly
    #[command(after_long_help = examples!("\n  acutile draw a15 -o a15.svg\n  acutile draw slab --figure steps --format tikz -o slab.tex"))]
    Draw(DrawArguments),
    /// Find valences, vertex types, whether a tiling is TCP, and isomorphic constructions
    ///
    /// For a point set or a crystal structure the answer also has the Delaunay cells, the Voronoi neighbours
    /// of each site, and the space group.
    #[command(after_long_help = examples!("\n  acutile classify mine.json\n  acutile classify sigma.cif --snap 3 --json"))]
    Classify(ClassifyArguments),
    /// Write a LaTeX appendix about certificates: theorem, numbers, and how to check them
    #[command(after_long_help = examples!("\n  acutile appendix a15 slab -o appendix"))]
    Appendix(AppendixArguments),
    /// Write an archive to deposit: certificates, appendix, page, meshes, verifiers, checksums
    ///
    /// A tiling without a certificate is proved first. The archive is written only if the kernel confirms
    /// every certificate. The same input gives the same bytes.
    #[command(after_long_help = examples!("\n  acutile bundle a15 slab -o artefact.zip\n  acutile bundle a15 --author 'Carberry, Josiah <0000-0002-1825-0097>' --licence CC-BY-4.0 -o a15.zip"))]
    Bundle(BundleArguments),
    /// Write a citation of a certificate: BibTeX, and a paragraph on the scope of the proof
    ///
    /// A tiling without a certificate is proved first. The output is a .bib file.
    #[command(after_long_help = examples!("\n  acutile cite a15\n  acutile cite mine.cbor -o mine.bib"))]
    Cite(CiteArguments),
    /// Print a completion script for a shell
    ///
    /// Every shell completes commands, options and names of the catalogue. In Elvish
    /// and PowerShell the script completes one name for each command, and no values of options.
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
    /// Replace existing files, even if acutile did not write them
    #[arg(long)]
    pub force: bool,
}

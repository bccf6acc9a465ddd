//! Mesh files as tilings, and notes about them on standard error.

use super::named::{InputError, Named};
use super::output::{Output, write_bytes};
use super::words::printable;
use acutile_core::statement::counted;
use acutile_io::mesh::Family;
use acutile_io::mesh::load::Loaded;
use acutile_io::mesh::{Converted, Lattice, Mesh, Move, periodic_tiling, region_tiling};
use clap::Args;
use std::fmt::Write;
use std::path::PathBuf;

/// How a mesh file becomes a tiling. Coordinates in text mean the nearest double, and every
/// double is taken as the exact number that it is.
#[derive(Clone, Debug, Default, Args)]
pub struct MeshArguments {
    /// The mesh is a cell of a periodic tiling or region with these lattice vectors: one to three, or for
    /// triangles one or two. Integers, fractions and decimals are exact as written
    #[arg(help_heading = "Mesh files", long, value_name = "A1,A2,A3[;B1,B2,B3[;C1,C2,C3]]", value_parser = Lattice::parse,
        allow_hyphen_values = true)]
    pub lattice: Option<Lattice>,
    /// The mesh is bounded, even if the file has periodic links
    #[arg(help_heading = "Mesh files", long, conflicts_with = "lattice")]
    pub bounded: bool,
    /// Move each node within this distance of a lattice translate of another node exactly onto it. In a
    /// bounded mesh move it onto the other node. The proof is about the moved mesh
    #[arg(help_heading = "Mesh files", long, value_name = "TOLERANCE", value_parser = tolerance)]
    pub identify: Option<f64>,
    /// Write every move of --identify to this file, as CSV
    #[arg(
        help_heading = "Mesh files",
        long,
        value_name = "FILE",
        requires = "identify"
    )]
    pub moves: Option<PathBuf>,
    /// The format of a mesh file, if its name and first bytes do not show it: msh, vtk, vtu, medit,
    /// meshb, tetgen, abaqus, nastran, mfem
    #[arg(help_heading = "Mesh files", long = "from", value_name = "FORMAT", value_parser = Family::parse)]
    pub mesh_format: Option<Family>,
}

/// A distance in doubles.
fn tolerance(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() && value >= 0.0 => Ok(value),
        _ => Err(format!(
            "found {text}, expected a number that is not negative"
        )),
    }
}

/// The tiling of a mesh, as the options say.
///
/// # Errors
/// A message that names the input.
pub fn tiling(
    input: &str,
    loaded: Loaded,
    options: &MeshArguments,
    output: &mut Output,
) -> Result<Named, InputError> {
    let description = format!(
        "a mesh of {} nodes and {} {}",
        loaded.mesh.points.len(),
        loaded.mesh.cell_count(),
        loaded.mesh.cell_name()
    );
    let others = loaded.mesh.others.clone();
    let curved = loaded.mesh.curved_elements();
    let (converted, notes) = converted(input, loaded.mesh, options)?;
    for note in &notes {
        output.note(input, note);
    }
    if let Some(path) = &options.moves {
        write_bytes(Some(path), moves_text(&converted.moves).as_bytes(), output)?;
    }
    Ok(Named {
        name: input.to_owned(),
        description,
        tiling: converted.tiling,
        origin: Some(converted.origin),
        sides: converted.sides,
        others,
        curved,
        notes,
        labels: Vec::new(),
    })
}

/// The lattice of the options or of the file; none for a bounded mesh.
pub fn lattice(
    input: &str,
    mesh: &Mesh,
    options: &MeshArguments,
) -> Result<Option<Lattice>, InputError> {
    match &options.lattice {
        Some(lattice) if lattice.is_of_plane() && mesh.dimension() == 3 => Err(format!(
            "--lattice has a vector with two entries, but {input} is a mesh of tetrahedra: expected three entries in each"
        )
        .into()),
        Some(lattice) => Ok(Some(lattice.clone())),
        None if options.bounded || mesh.periodic.is_empty() => Ok(None),
        None => Lattice::of_links(mesh)
            .map(Some)
            .map_err(|error| InputError::of_mesh(input, &error)),
    }
}

/// The tiling with the file's numbers, and notes for the user.
///
/// # Errors
/// A message that names the input.
pub fn converted(
    input: &str,
    mesh: Mesh,
    options: &MeshArguments,
) -> Result<(Converted, Vec<String>), InputError> {
    let mut notes = mesh_notes(&mesh);
    let lattice = lattice(input, &mesh, options)?;
    if let (Some(lattice), None) = (&lattice, &options.lattice) {
        notes.push(format!("the lattice of $Periodic: {lattice}"));
    }
    let converted = match &lattice {
        Some(lattice) => periodic_tiling(mesh, lattice, options.identify),
        None => region_tiling(mesh, options.identify),
    };
    let converted = converted.map_err(|error| InputError::of_mesh(input, &error))?;
    let is_exact = options.identify.is_none();
    if let Some(numbers) = lattice
        .filter(|_| is_exact)
        .map(|lattice| lattice.inexact())
        && !numbers.is_empty()
    {
        notes.push(format!(
            "{} in the lattice: no double, so no node is the exact image of another one; \
             --identify moves nodes",
            numbers.join(", ")
        ));
    }
    notes.extend(conversion_notes(&converted, options));
    Ok((converted, notes))
}

fn mesh_notes(mesh: &Mesh) -> Vec<String> {
    let mut notes = Vec::new();
    if !mesh.others.is_empty() {
        notes.push(format!("not checked: {}", mesh.other_counts()));
    }
    if !mesh.curved.is_empty() {
        notes.push(format!(
            "{} curved; all but certify takes the straight ones with the same corners",
            counted(
                mesh.curved.len(),
                "element of second order is",
                "elements of second order are"
            )
        ));
    }
    if mesh.turned > 0 {
        notes.push(format!(
            "all {} tetrahedra have negative orientation, as TetGen files may; their last two \
             corners are exchanged",
            mesh.turned
        ));
    }
    notes
}

fn conversion_notes(converted: &Converted, options: &MeshArguments) -> Vec<String> {
    let mut notes = Vec::new();
    if converted.unused > 0 {
        notes.push(format!(
            "{} left out",
            counted(
                converted.unused,
                "node is no corner of a cell, and is",
                "nodes are no corners of cells, and are"
            )
        ));
    }
    if converted.coincident > 0 {
        notes.push(format!(
            "{}; --identify 0 makes them one",
            counted(
                converted.coincident,
                "node has the coordinates of another node and is a vertex of its own",
                "nodes have the coordinates of another node and are vertices of their own"
            )
        ));
    }
    let moves = &converted.moves;
    if !moves.is_empty() {
        let largest = moves.iter().map(|m| m.distance).fold(0.0, f64::max);
        let list = match &options.moves {
            Some(path) => format!("listed in {}", printable(path)),
            None => "--moves lists them".to_owned(),
        };
        notes.push(format!(
            "{} by at most {largest:.3e} ({list}); what follows is about the moved mesh",
            counted(
                moves.len(),
                "node moved to an exact image,",
                "nodes moved to exact images,"
            )
        ));
    }
    notes
}

/// One line for each node that was moved; the new coordinates are exact.
fn moves_text(moves: &[Move]) -> String {
    let mut text = String::from("node,x,y,z,new_x,new_y,new_z,distance\n");
    for m in moves {
        let [x, y, z] = m.from;
        let [a, b, c] = &m.to;
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{},{x},{y},{z},{a},{b},{c},{:e}", m.node, m.distance);
    }
    text
}

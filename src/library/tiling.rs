//! Makes a tiling of a user's data: points and tetrahedra, a tiling file's text, a file, or a
//! name of the catalogue.

use super::Error;
use acutile_catalog as catalog;
use acutile_core::checker::{Names, Sides};
use acutile_core::delaunay::{Ties, triangulate};
use acutile_core::tiling::{self, AnyPointSet, AnyTiling};
use acutile_core::{format, transcribe, with_dimension};
use acutile_io::import::cif::CifOptions;
use acutile_io::import::crystal::{self, text_of};
use acutile_io::import::{BYTE_LIMIT, Content, read_bytes, read_native, uncompressed_name};
use acutile_io::mesh::{
    Family, Lattice, Mesh, Numbering, Origin, load, periodic_tiling, region_tiling,
};
use std::path::Path;

/// A tiling by triangles or tetrahedra, with the numbers of the mesh that it was made from.
/// Nothing is proved of it before [`crate::certify`].
///
/// ```
/// use acutile::{ReadOptions, Tiling};
///
/// let cube = Tiling::named("cube-6")?;
/// assert_eq!((cube.dimension(), cube.simplices()), (3, 6));
/// assert!(Tiling::from_text("{}", &ReadOptions::default()).is_err());
/// # Ok::<(), acutile::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Tiling {
    tiling: AnyTiling,
    /// The numbers of a mesh; nothing for other inputs.
    origin: Option<Origin>,
    sides: Sides,
    notes: Vec<String>,
}

/// How a name or a file is read.
///
/// ```
/// use acutile::{ReadOptions, Tiling};
///
/// // Sommerville's second tetrahedra, in prisms of this height.
/// let options = ReadOptions::default().parameter("3/2");
/// let tiling = Tiling::read("goldberg-1", &options)?;
/// assert_eq!(tiling.dimension(), 3);
/// # Ok::<(), acutile::Error>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct ReadOptions {
    parameter: Option<String>,
    lattice: Option<String>,
    tolerance: Option<f64>,
    is_cut: bool,
}

impl ReadOptions {
    /// The number that a construction of the catalogue depends on, such as `3/2` or `sqrt(2)`.
    pub fn parameter(mut self, value: impl Into<String>) -> Self {
        self.parameter = Some(value.into());
        self
    }

    /// The lattice of a periodic mesh: `a1,a2,a3;b1,b2,b3;c1,c2,c3`.
    pub fn lattice(mut self, vectors: impl Into<String>) -> Self {
        self.lattice = Some(vectors.into());
        self
    }

    /// The distance within which nodes of a mesh become one vertex.
    pub fn tolerance(mut self, distance: f64) -> Self {
        self.tolerance = Some(distance);
        self
    }

    /// Cuts Delaunay cells with cospherical vertices into simplices, where points are read.
    pub fn triangulate(mut self) -> Self {
        self.is_cut = true;
        self
    }
}

impl Tiling {
    /// A construction of the catalogue (`acutile list`).
    ///
    /// ```
    /// let a15 = acutile::Tiling::named("a15")?;
    /// assert_eq!((a15.vertices(), a15.simplices()), (8, 46));
    /// # Ok::<(), acutile::Error>(())
    /// ```
    ///
    /// # Errors
    /// A name that the catalogue does not have.
    pub fn named(name: &str) -> Result<Tiling, Error> {
        construction(name, None)
    }

    /// A name of the catalogue, or any file that `acutile certify` reads as one tiling.
    ///
    /// # Errors
    /// The file or name, and the problem with it.
    pub fn read(source: &str, options: &ReadOptions) -> Result<Tiling, Error> {
        if catalog::find(source).is_some() {
            return construction(source, options.parameter.as_deref());
        }
        let path = Path::new(source);
        if !path.exists() {
            let advice = catalog::suggestion(source).filter(|_| !source.contains(['/', '.']));
            let advice = advice.map(|name| format!("; did you mean {name}?"));
            let problem = "neither a name of the catalogue nor a file".to_owned();
            return Err(Error::of(&source, problem + &advice.unwrap_or_default()));
        }
        of_file(path, options).map_err(|error| Error::of(&source, error))
    }

    /// A tiling file, or the Delaunay triangulation of a point-set file, from its text.
    ///
    /// # Errors
    /// The line and column of the first fault.
    pub fn from_text(text: &str, options: &ReadOptions) -> Result<Tiling, Error> {
        match read_native(text).map_err(Error::new)?.content {
            Content::Tiling(tiling) => Ok(Tiling::of(tiling)),
            Content::Points(points) => of_points(&points, options),
            Content::Family(_) => Err(Error::new(
                "a file with parameters is a family, expected a single tiling; \
                 the command line takes it",
            )),
        }
    }

    /// A mesh of the region that its tetrahedra cover. Points have three finite coordinates, which are
    /// taken exactly. A tetrahedron is the indices of its four corners.
    ///
    /// ```
    /// use acutile::{Options, Tiling, Verdict, certify};
    ///
    /// let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    /// let corner = Tiling::mesh(&points, &[[0, 1, 2, 3]])?;
    /// let options = Options::default().require("nonobtuse".parse()?);
    /// assert!(matches!(certify(&corner, &options)?, Verdict::Proved(_)));
    /// # Ok::<(), acutile::Error>(())
    /// ```
    ///
    /// # Errors
    /// A coordinate that is not finite, or an index without a point.
    pub fn mesh(points: &[[f64; 3]], cells: &[[u32; 4]]) -> Result<Tiling, Error> {
        let mesh = Mesh {
            points: points.to_vec(),
            nodes: Numbering::consecutive(0, points.len()),
            tetrahedra: cells.to_vec(),
            elements: Numbering::consecutive(0, cells.len()),
            ..Mesh::default()
        };
        Tiling::of_mesh(mesh, &ReadOptions::default())
    }

    /// 2 or 3.
    pub fn dimension(&self) -> usize {
        match self.tiling {
            AnyTiling::Plane(_) => 2,
            AnyTiling::Space(_) => 3,
        }
    }

    /// The number of vertices, up to the lattice.
    pub fn vertices(&self) -> usize {
        with_dimension!(&self.tiling, AnyTiling, t => t.vertices.len())
    }

    /// The number of simplices, up to the lattice.
    pub fn simplices(&self) -> usize {
        with_dimension!(&self.tiling, AnyTiling, t => t.len())
    }

    /// Notes on changes to the input, and on parts that are left out.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }
}

/// For the other packages of this workspace, whose types may change.
#[doc(hidden)]
impl Tiling {
    /// A tiling that comes from no mesh.
    pub fn of(tiling: AnyTiling) -> Tiling {
        Tiling {
            tiling,
            origin: None,
            sides: Sides::default(),
            notes: Vec::new(),
        }
    }

    /// A bounded mesh, or with a lattice a periodic one.
    pub fn of_mesh(mesh: Mesh, options: &ReadOptions) -> Result<Tiling, Error> {
        check_mesh(&mesh)?;
        let lattice = match &options.lattice {
            Some(text) => Some(Lattice::parse(text).map_err(|e| Error::of(&"lattice", e))?),
            None if mesh.periodic.is_empty() => None,
            None => Some(Lattice::of_links(&mesh).map_err(Error::new)?),
        };
        let converted = match &lattice {
            Some(lattice) => periodic_tiling(mesh, lattice, options.tolerance),
            None => region_tiling(mesh, options.tolerance),
        };
        let converted = converted.map_err(Error::new)?;
        let counts = [
            (
                converted.unused,
                "nodes belong to no tetrahedron and are left out",
            ),
            (
                converted.coincident,
                "nodes have the coordinates of another node",
            ),
            (converted.moves.len(), "nodes are moved onto others"),
        ];
        let notes = counts.iter().filter(|(count, _)| *count > 0);
        Ok(Tiling {
            tiling: converted.tiling,
            origin: Some(converted.origin),
            sides: converted.sides,
            notes: notes
                .map(|(count, words)| format!("{count} {words}"))
                .collect(),
        })
    }

    /// The tiling.
    pub fn any(&self) -> &AnyTiling {
        &self.tiling
    }

    /// Knowledge about the sides of a periodic mesh.
    pub fn sides(&self) -> &Sides {
        &self.sides
    }

    /// The words for simplices and vertices: as the mesh numbers them, else by index.
    pub fn names<'a, const D: usize>(&'a self, tiling: &'a tiling::Tiling<D>) -> Names<'a> {
        match &self.origin {
            None => Names::of(tiling),
            Some(origin) => Names::new(
                |simplex| format!("element {}", origin.tetrahedron(simplex).tag),
                |simplex, corner| origin.corner(simplex, corner).to_string(),
                |vertex| format!("node {}", origin.vertex(vertex)),
            )
            .with_points(|point| origin.cartesian(point)),
        }
    }
}

fn construction(name: &str, parameter: Option<&str>) -> Result<Tiling, Error> {
    let tiling = match parameter {
        Some(parameter) => catalog::build_with(name, parameter),
        None => catalog::build(name),
    };
    tiling
        .map(Tiling::of)
        .map_err(|error| Error::of(&name, error))
}

fn of_file(path: &Path, options: &ReadOptions) -> Result<Tiling, Error> {
    if let Some(family) = Family::of_path(path) {
        let loaded = load(path, family).map_err(Error::new)?;
        return Tiling::of_mesh(loaded.mesh, options);
    }
    let bytes = read_bytes(path, BYTE_LIMIT).map_err(Error::new)?;
    if let Some(family) = Family::of_content(&bytes) {
        return Tiling::of_mesh(family.read(&bytes).map_err(Error::new)?, options);
    }
    if format::recognise(&bytes).is_some() {
        let cbor = format::to_cbor(&bytes).map_err(Error::new)?;
        let read = transcribe::of_certificate(&cbor).map_err(Error::new)?;
        return Ok(Tiling::of(read.0));
    }
    let name = uncompressed_name(path);
    let text = text_of(&name, bytes).map_err(Error::new)?;
    let Some(kind) = crystal::kind(&name, &text) else {
        return Tiling::from_text(&text, options);
    };
    let structure = crystal::read(kind, &text, &CifOptions::default()).map_err(Error::new)?;
    let mut tiling = of_points(&AnyPointSet::Space(structure.points), options)?;
    tiling.notes.splice(0..0, structure.notes);
    Ok(tiling)
}

fn of_points(points: &AnyPointSet, options: &ReadOptions) -> Result<Tiling, Error> {
    let ties = if options.is_cut {
        Ties::Pull
    } else {
        Ties::Refuse
    };
    let tiling = match points {
        AnyPointSet::Plane(points) => triangulate(points, ties).map(AnyTiling::Plane),
        AnyPointSet::Space(points) => triangulate(points, ties).map(AnyTiling::Space),
    };
    let tiling = tiling.map_err(|error| match ties {
        Ties::Refuse => Error::new(format!(
            "{error}; the option triangulate cuts cells with cospherical vertices"
        )),
        Ties::Pull => Error::new(error),
    })?;
    let count = with_dimension!(points, AnyPointSet, p => p.points.len());
    let note = format!("the tiling is the Delaunay triangulation of {count} points in a cell");
    Ok(Tiling {
        notes: vec![note],
        ..Tiling::of(tiling)
    })
}

/// The indices are those of points, the coordinates are finite, and no cell is curved.
fn check_mesh(mesh: &Mesh) -> Result<(), Error> {
    if !mesh.curved.is_empty() {
        return Err(Error::new(format!(
            "{} {} of second order are curved; the command `acutile certify` says whether \
             each is valid",
            mesh.curved.len(),
            mesh.cell_name()
        )));
    }
    let mut coordinates = mesh.points.iter().enumerate();
    let infinite = coordinates.find_map(|(row, point)| {
        let column = point.iter().position(|x| !x.is_finite())?;
        Some((row, column, point[column]))
    });
    if let Some((row, column, value)) = infinite {
        return Err(Error::new(format!(
            "points[{row}, {column}] is {value}, expected a finite number"
        )));
    }
    let count = mesh.points.len();
    let mut cells = mesh.tetrahedra.iter().enumerate();
    let missing = cells.find_map(|(row, cell)| {
        let column = cell.iter().position(|vertex| *vertex as usize >= count)?;
        Some((row, column, cell[column]))
    });
    match missing {
        None => Ok(()),
        Some((row, column, value)) => Err(Error::new(format!(
            "cells[{row}, {column}] is {value}, expected an index below {count}, the number of points"
        ))),
    }
}

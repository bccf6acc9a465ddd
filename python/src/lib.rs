//! The compiled part of the Python package `acutile`.
//!
//! It takes arrays, texts and file names, and answers with JSON, bytes and arrays. The classes that
//! users see are written in Python, in `acutile/`.

mod answer;
mod error;
mod input;
mod measures;
mod optimize;
mod work;

use acutile::Tiling as Input;
use acutile_catalog as catalog;
use acutile_core::format;
use acutile_core::proved::{hexadecimal, in_words};
use acutile_core::refusal::Refused;
use acutile_core::tiling::{Coordinates, Corner};
use acutile_core::with_dimension;
use acutile_exact::number::Number;
use acutile_kernel::{Limits, Verified};
use acutile_paper::survey::Survey;
use acutile_paper::table::{self, Row};
use acutile_publish::report::{Proved, page};
use error::{Failed, failed};
use numpy::{IntoPyArray, PyArray2, PyArrayMethods, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::sync::Arc;
use work::work;

/// An array of numpy with two axes.
type Table<'py, T> = Bound<'py, PyArray2<T>>;

/// A tiling that Python holds. It is never changed.
#[pyclass(frozen, module = "acutile._native")]
struct Tiling(Arc<Input>);

#[pymethods]
impl Tiling {
    /// A mesh from an array of points (n x 3) and an array of tetrahedra (m x 4).
    #[staticmethod]
    #[pyo3(signature = (points, cells, lattice=None, tolerance=None))]
    fn of_mesh(
        py: Python<'_>,
        points: PyReadonlyArray2<f64>,
        cells: PyReadonlyArray2<u32>,
        lattice: Option<String>,
        tolerance: Option<f64>,
    ) -> PyResult<Tiling> {
        // One copy of the arrays, so that the conversion runs without the interpreter's lock.
        let mesh = input::mesh(points.as_array(), cells.as_array())?;
        let options = input::options(None, lattice, tolerance, false);
        let input = work(py, None, move |_| {
            Input::of_mesh(mesh, &options).map_err(failed)
        })??;
        Ok(Tiling(Arc::new(input)))
    }

    /// A tiling file or point-set file of the project, as text.
    #[staticmethod]
    #[pyo3(signature = (text, triangulate=false))]
    fn of_text(py: Python<'_>, text: String, triangulate: bool) -> PyResult<Tiling> {
        let input = work(py, None, move |_| {
            let options = input::options(None, None, None, triangulate);
            Input::from_text(&text, &options).map_err(failed)
        })??;
        Ok(Tiling(Arc::new(input)))
    }

    /// A name of the catalogue, or the name of a file.
    #[staticmethod]
    #[pyo3(signature = (source, parameter=None, lattice=None, tolerance=None, triangulate=false))]
    fn open(
        py: Python<'_>,
        source: String,
        parameter: Option<String>,
        lattice: Option<String>,
        tolerance: Option<f64>,
        triangulate: bool,
    ) -> PyResult<Tiling> {
        let options = input::options(parameter, lattice, tolerance, triangulate);
        let read = move |_: &dyn Fn(&str)| Input::read(&source, &options).map_err(failed);
        let input = work(py, None, read)??;
        Ok(Tiling(Arc::new(input)))
    }

    /// 2 or 3.
    #[getter]
    fn dimension(&self) -> usize {
        self.0.dimension()
    }

    /// Notes on changes to the input, and on parts that are left out.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.0.notes().to_vec()
    }

    /// The vertices in basis coordinates, rounded to doubles.
    fn vertices<'py>(&self, py: Python<'py>) -> PyResult<Table<'py, f64>> {
        let entries = with_dimension!(self.0.any(), AnyTiling, t => doubles(&t.vertices));
        array(py, entries, self.0.dimension())
    }

    /// The inner products of the basis vectors, rounded to doubles.
    fn gram<'py>(&self, py: Python<'py>) -> PyResult<Table<'py, f64>> {
        let entries = with_dimension!(self.0.any(), AnyTiling, t => {
            t.frame.gram.iter().flatten().map(Number::approximate).collect()
        });
        array(py, entries, self.0.dimension())
    }

    /// For each simplex the numbers of its vertices, and the lattice translations of these.
    fn corners<'py>(&self, py: Python<'py>) -> PyResult<(Table<'py, i64>, Table<'py, i64>)> {
        let (vertices, shifts) =
            with_dimension!(self.0.any(), AnyTiling, t => indices_and_shifts(&t.corners));
        let dimension = self.0.dimension();
        let width = dimension + 1;
        Ok((
            array(py, vertices, width)?,
            array(py, shifts, width * dimension)?,
        ))
    }

    /// Proves the tiling with the required statements. The answer is JSON, with the certificate
    /// where it is asked for and there is one.
    #[pyo3(signature = (require, certificate=true, max_defects=10_000, progress=None))]
    fn certify<'py>(
        &self,
        py: Python<'py>,
        require: Vec<String>,
        certificate: bool,
        max_defects: usize,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<(String, Option<Bound<'py, PyBytes>>)> {
        let mut options = answer::options(&require, max_defects)?;
        options.sides.clone_from(self.0.sides());
        let input = Arc::clone(&self.0);
        let (json, cbor) = work(py, progress, move |step| {
            answer::certify(&input, &options, certificate, step)
        })??;
        Ok((json, cbor.map(|cbor| PyBytes::new(py, &cbor))))
    }

    /// Moves vertices and lattice for better angles: the best tiling, the answer as JSON, and the certificate.
    // The arguments are those that Python passes.
    #[allow(clippy::too_many_arguments)]
    #[pyo3(signature = (goal, symmetry, fixed_lattice=false, fixed_boundary=false, denominator=None, progress=None))]
    fn optimize<'py>(
        &self,
        py: Python<'py>,
        goal: &str,
        symmetry: &str,
        fixed_lattice: bool,
        fixed_boundary: bool,
        denominator: Option<u64>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<(Tiling, String, Bound<'py, PyBytes>)> {
        let options = acutile_optimize::Options {
            goal: optimize::goal(goal)?,
            keep: optimize::symmetry(symmetry)?,
            freedom: acutile_optimize::Freedom {
                lattice: !fixed_lattice,
                boundary: !fixed_boundary,
            },
            denominator: denominator.filter(|d| *d > 0),
            sides: self.0.sides().clone(),
            ..acutile_optimize::Options::default()
        };
        let input = Arc::clone(&self.0);
        let (best, json, cbor) = work(py, progress, move |step| {
            optimize::best(&input, &options, step)
        })??;
        Ok((Tiling(Arc::new(best)), json, PyBytes::new(py, &cbor)))
    }

    /// The dihedral angles of each simplex, in degrees: lower and upper ends of enclosures.
    fn angles<'py>(&self, py: Python<'py>) -> PyResult<(Table<'py, f64>, Table<'py, f64>)> {
        let input = Arc::clone(&self.0);
        let (lower, upper) = work(py, None, move |_| measures::angles(input.any()))??;
        let width = measures::angles_of_simplex(self.0.dimension());
        Ok((array(py, lower, width)?, array(py, upper, width)?))
    }

    /// The combinatorial class, as `acutile classify --json` prints it.
    fn classify(&self, py: Python<'_>) -> PyResult<String> {
        let input = Arc::clone(&self.0);
        work(py, None, move |_| answer::classify(&input))?
    }

    /// A picture in SVG.
    fn picture(&self, name: &str) -> PyResult<String> {
        answer::picture(&self.0, name)
    }
}

fn doubles<const D: usize>(vertices: &Coordinates<D>) -> Vec<f64> {
    let rows = vertices.iter();
    rows.flat_map(|row| row.map(|x| x.approximate())).collect()
}

/// The vertices of all corners, and their shifts one after the other.
fn indices_and_shifts<const D: usize>(corners: &[Corner<D>]) -> (Vec<i64>, Vec<i64>) {
    let vertices = corners
        .iter()
        .map(|corner| i64::from(corner.vertex.number()));
    let shifts = corners
        .iter()
        .flat_map(|corner| corner.shift.map(i64::from));
    (vertices.collect(), shifts.collect())
}

/// An array of rows with `width` entries. The entries are not copied.
fn array<T: numpy::Element>(
    py: Python<'_>,
    entries: Vec<T>,
    width: usize,
) -> PyResult<Table<'_, T>> {
    let rows = entries.len() / width;
    entries.into_pyarray(py).reshape([rows, width])
}

/// Checks a certificate in either encoding; the answer is JSON.
#[pyfunction]
#[pyo3(signature = (certificate, claim=None))]
fn verify(py: Python<'_>, certificate: Vec<u8>, claim: Option<Vec<u8>>) -> PyResult<String> {
    work(py, None, move |_| {
        if format::recognise(&certificate).is_none() {
            return Err(failed(
                "found no certificate, expected CBOR or JSON with the format acutile-certificate; certify(...).certificate is one",
            ));
        }
        let cbor = format::to_cbor(&certificate).map_err(failed)?;
        let verified = acutile_kernel::verify(&mut &cbor[..], &Limits::DEFAULT);
        let verified =
            verified.map_err(|refusal| failed(Refused::of_file(&certificate, &cbor, refusal)))?;
        answer::verified(&verified, claim.as_deref())
    })?
}

/// Names and descriptions of the catalogue.
#[pyfunction]
fn names() -> Vec<(String, String)> {
    let entries = catalog::entries().iter();
    entries
        .map(|entry| (entry.name.to_owned(), entry.description.to_owned()))
        .collect()
}

/// The table of constructions of the catalogue, in `text`, `markdown`, `latex`, `csv` or `json`.
#[pyfunction]
fn table_of(py: Python<'_>, names: Vec<String>, format: String) -> PyResult<String> {
    work(py, None, move |_| -> Result<String, PyErr> {
        let wanted: Vec<&str> = names.iter().map(String::as_str).collect();
        if let Some(wrong) = wanted.iter().find(|name| catalog::find(name).is_none()) {
            return Err(failed(format!(
                "{wrong}: found no name of the catalogue; names() lists them"
            )));
        }
        let survey = Survey::of(&wanted);
        let row = |name: &&str| survey.get(name).map(|study| Row::of(name, study));
        let rows: Vec<Row> = wanted
            .iter()
            .map(row)
            .collect::<Result<_, _>>()
            .map_err(failed)?;
        match format.as_str() {
            "text" => Ok(table::text(&rows)),
            "markdown" => Ok(table::markdown(&rows)),
            "latex" => Ok(table::latex(&rows)),
            "csv" => Ok(table::csv(&rows)),
            "json" => Ok(table::json(&rows).to_string()),
            other => Err(failed(format!(
                "the format is \"{other}\", expected text, markdown, latex, csv or json"
            ))),
        }
    })?
}

/// A page in HTML about certificates, each with a name.
#[pyfunction]
fn report(py: Python<'_>, certificates: Vec<(String, Vec<u8>)>) -> PyResult<String> {
    work(py, None, move |_| -> Result<String, PyErr> {
        let proved = certificates.into_iter().map(|(name, bytes)| {
            Proved::of_certificate(name, String::new(), &bytes, &Limits::DEFAULT)
        });
        let proved: Vec<Proved> = proved.collect::<Result<_, _>>().map_err(failed)?;
        Ok(page(&proved, None))
    })?
}

/// The verified claim in words, with the digest of the certificate.
fn words_and_digest(verified: &Verified) -> (String, String) {
    (in_words(verified), hexadecimal(&verified.sha256))
}

#[pymodule]
fn _native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("Failed", module.py().get_type::<Failed>())?;
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<Tiling>()?;
    module.add_function(wrap_pyfunction!(verify, module)?)?;
    module.add_function(wrap_pyfunction!(names, module)?)?;
    module.add_function(wrap_pyfunction!(table_of, module)?)?;
    module.add_function(wrap_pyfunction!(report, module)?)?;
    Ok(())
}

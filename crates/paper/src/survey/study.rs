//! A proved tiling and its consequences.

use acutile_catalog as catalog;
use acutile_core::checker::Options;
use acutile_core::classify::{
    NotTcp, Ridges, Star, Symbol, check_tcp, combinatorial_symbol, metric_symbol, stars,
};
use acutile_core::delaunay::{Ties, triangulate};
use acutile_core::proved::{NotProved, prove};
use acutile_core::quality::{Measures, Ranges, Shape, measures_of_shapes, shapes, squared_edges};
use acutile_core::statement::{Statement, ranges};
use acutile_core::tiling::{AnyTiling, Matching, PointSet, Tiling, match_facets};
use acutile_exact::number::Number;
use std::collections::BTreeMap;
use std::fmt;
use std::sync::OnceLock;

/// A tiling that is proved; the kernel has confirmed its certificate.
#[derive(Debug)]
pub struct Study<const D: usize> {
    /// The tiling.
    pub tiling: Tiling<D>,
    /// Which facets coincide.
    pub matching: Matching<D>,
    /// The statements of the certificate.
    pub statements: Vec<Statement>,
    /// The SHA-256 of the certificate's bytes, in hexadecimal digits.
    pub certificate: String,
    /// Congruence classes, once they are asked for.
    shapes: OnceLock<Vec<Shape>>,
    /// How many vertices of a cell have each star, once this is asked for.
    stars: OnceLock<BTreeMap<Star, usize>>,
    /// The measures of each class, once they are asked for.
    measures: OnceLock<Vec<Measures>>,
    /// The exact ranges that the certificate claims.
    pub ranges: Ranges,
    /// Vertices of the plane, edges of space, with the simplices around each.
    pub ridges: Ridges<D>,
}

impl<const D: usize> Study<D> {
    /// Proves a tiling and studies it.
    ///
    /// # Errors
    /// The first defect, in words.
    pub fn of(tiling: Tiling<D>) -> Result<Self, NotStudied> {
        // The kernel uses one core.
        let combinatorics = || {
            let matching = match_facets(&tiling);
            let ridges = Ridges::of(&tiling, &matching);
            (matching, ridges)
        };
        let proof = || prove(&tiling, &Options::default(), &|_| {});
        let (proved, (matching, ridges)) = rayon::join(proof, combinatorics);
        let proved = proved.map_err(|reason| NotStudied {
            message: reason.in_words(&tiling),
            is_refuted: matches!(reason, NotProved::Refuted(_)),
        })?;
        Ok(Study {
            ranges: ranges(proved.statements())
                .ok_or_else(|| NotStudied::open("the certificate has no exact bounds"))?,
            ridges,
            certificate: proved.sha256(),
            statements: proved.statements().to_vec(),
            matching,
            shapes: OnceLock::new(),
            stars: OnceLock::new(),
            measures: OnceLock::new(),
            tiling,
        })
    }

    /// Congruence classes.
    pub fn shapes(&self) -> &[Shape] {
        self.shapes.get_or_init(|| shapes(&self.tiling))
    }

    /// The measures of each class. They take far longer than the classes.
    ///
    /// # Panics
    /// Never: a proved tiling has no flat simplex, which alone has no measures.
    pub fn measures(&self) -> &[Measures] {
        self.measures.get_or_init(|| {
            measures_of_shapes(&self.tiling, self.shapes()).expect("no simplex is flat")
        })
    }

    /// Whether the certificate makes this statement.
    pub fn states(&self, statement: &Statement) -> bool {
        self.statements.contains(statement)
    }

    /// The study of a tiling of space that a point set's Delaunay triangulation gives.
    ///
    /// # Errors
    /// Why there is none.
    pub fn of_points(points: &PointSet<D>) -> Result<Self, NotStudied> {
        let tiling = triangulate(points, Ties::Refuse).map_err(NotStudied::open)?;
        Study::of(tiling)
    }

    /// The minimal symbol with edge lengths, equal exactly for similar tilings of the
    /// same field; `None` for a domain with boundary.
    pub fn metric_symbol(&self) -> Option<Symbol<(usize, Vec<Number>), D>> {
        metric_symbol(&self.tiling, &self.matching, &self.ridges, |simplex| {
            squared_edges(&self.tiling, simplex)
        })
    }

    /// The minimal combinatorial symbol; `None` for a domain with boundary.
    pub fn symbol(&self) -> Option<Symbol<usize, D>> {
        combinatorial_symbol(&self.tiling, &self.matching, &self.ridges)
    }
}

impl Study<3> {
    /// Whether the triangulation is TCP.
    ///
    /// # Errors
    /// The first edge or triangle that violates the definition.
    pub fn check_tcp(&self) -> Result<(), NotTcp> {
        check_tcp(&self.tiling, &self.ridges)
    }

    /// How many vertices of a cell have each star.
    pub fn star_counts(&self) -> &BTreeMap<Star, usize> {
        self.stars.get_or_init(|| {
            let mut counts = BTreeMap::new();
            for star in stars(&self.tiling) {
                *counts.entry(star).or_insert(0) += 1;
            }
            counts
        })
    }
}

/// Why there is no study.
#[derive(Clone, Debug)]
pub struct NotStudied {
    /// The first defect, or the other obstacle.
    pub message: String,
    /// Whether something is wrong with the tiling. Otherwise nothing is decided.
    pub is_refuted: bool,
}

impl NotStudied {
    /// Nothing is known to be wrong with the tiling.
    fn open(message: impl fmt::Display) -> Self {
        NotStudied {
            message: message.to_string(),
            is_refuted: false,
        }
    }
}

impl fmt::Display for NotStudied {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl From<NotStudied> for String {
    fn from(error: NotStudied) -> String {
        error.message
    }
}

/// A study in either dimension.
#[derive(Debug)]
pub enum AnyStudy {
    /// D = 2
    Plane(Study<2>),
    /// D = 3
    Space(Study<3>),
}

impl AnyStudy {
    /// Builds, proves and studies a construction of the catalogue.
    ///
    /// # Errors
    /// A message that names the construction.
    pub fn of_entry(name: &str) -> Result<AnyStudy, String> {
        let entry = catalog::find(name).ok_or_else(|| format!("{name}: not in this build"))?;
        let tiling = entry.build().map_err(|error| format!("{name}: {error}"))?;
        AnyStudy::of(tiling).map_err(|error| format!("{name}: {error}"))
    }

    /// The SHA-256 of the certificate.
    pub fn certificate(&self) -> &str {
        match self {
            AnyStudy::Plane(study) => &study.certificate,
            AnyStudy::Space(study) => &study.certificate,
        }
    }

    /// Whether the certificate makes this statement.
    pub fn states(&self, statement: &Statement) -> bool {
        match self {
            AnyStudy::Plane(study) => study.states(statement),
            AnyStudy::Space(study) => study.states(statement),
        }
    }

    /// Proves and studies a tiling.
    ///
    /// # Errors
    /// The first defect, in words.
    pub fn of(tiling: AnyTiling) -> Result<AnyStudy, NotStudied> {
        Ok(match tiling {
            AnyTiling::Plane(tiling) => AnyStudy::Plane(Study::of(tiling)?),
            AnyTiling::Space(tiling) => AnyStudy::Space(Study::of(tiling)?),
        })
    }
}

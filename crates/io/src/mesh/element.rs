//! Types of elements other than the tetrahedron with four nodes.
//! Each has a name and a number of nodes, and is found by its number in Gmsh or in VTK.

/// The tetrahedron with four nodes in Gmsh's numbering.
pub const GMSH_TETRAHEDRON: i64 = 4;
/// The tetrahedron with four nodes in VTK's numbering.
pub const VTK_TETRAHEDRON: i64 = 10;
/// The triangle with three nodes, in Gmsh's numbering and in VTK's.
pub const GMSH_TRIANGLE: i64 = 2;
pub const VTK_TRIANGLE: i64 = 5;
/// Triangles and tetrahedra of first and of second order, in Gmsh's numbering.
pub const GMSH_CELLS: [i64; 4] = [GMSH_TRIANGLE, GMSH_TETRAHEDRON, 9, 11];
/// The same in VTK's, with the number of their nodes.
pub const VTK_CELLS: [(i64, usize); 4] =
    [(VTK_TRIANGLE, 3), (VTK_TETRAHEDRON, 4), (22, 6), (24, 10)];

/// The nodes of a cell in VTK's order. Gmsh has the last two middle nodes of a tetrahedron of second
/// order in the other order.
pub fn gmsh_order(nodes: &mut [i64]) -> &[i64] {
    if nodes.len() == 10 {
        nodes.swap(8, 9);
    }
    nodes
}

/// Name and number of nodes of a Gmsh element type (Gmsh reference manual, section
/// "MSH file format").
pub fn gmsh_element(kind: i64) -> Option<(&'static str, usize)> {
    Some(match kind {
        1 => ("lines", 2),
        2 => ("triangles", 3),
        3 => ("quadrangles", 4),
        4 => ("tetrahedra", 4),
        5 => ("hexahedra", 8),
        6 => ("prisms", 6),
        7 => ("pyramids", 5),
        8 => ("second-order lines", 3),
        9 => ("second-order triangles", 6),
        10 => ("second-order quadrangles", 9),
        11 => ("second-order tetrahedra", 10),
        12 => ("second-order hexahedra", 27),
        13 => ("second-order prisms", 18),
        14 => ("second-order pyramids", 14),
        15 => ("points", 1),
        16 => ("second-order quadrangles", 8),
        17 => ("second-order hexahedra", 20),
        18 => ("second-order prisms", 15),
        19 => ("second-order pyramids", 13),
        20 => ("third-order triangles", 9),
        21 => ("third-order triangles", 10),
        22 => ("fourth-order triangles", 12),
        23 => ("fourth-order triangles", 15),
        24 => ("fifth-order triangles", 15),
        25 => ("fifth-order triangles", 21),
        26 => ("third-order lines", 4),
        27 => ("fourth-order lines", 5),
        28 => ("fifth-order lines", 6),
        29 => ("third-order tetrahedra", 20),
        30 => ("fourth-order tetrahedra", 35),
        31 => ("fifth-order tetrahedra", 56),
        32 => ("incomplete fourth-order tetrahedra", 22),
        33 => ("incomplete fifth-order tetrahedra", 28),
        36 => ("third-order quadrangles", 16),
        37 => ("fourth-order quadrangles", 25),
        38 => ("fifth-order quadrangles", 36),
        39 => ("incomplete third-order quadrangles", 12),
        40 => ("incomplete fourth-order quadrangles", 16),
        41 => ("incomplete fifth-order quadrangles", 20),
        42 => ("sixth-order triangles", 28),
        43 => ("seventh-order triangles", 36),
        62 => ("sixth-order lines", 7),
        63 => ("seventh-order lines", 8),
        71 => ("sixth-order tetrahedra", 84),
        72 => ("seventh-order tetrahedra", 120),
        84 => ("zeroth-order lines", 1),
        85 => ("zeroth-order triangles", 1),
        86 => ("zeroth-order quadrangles", 1),
        90 => ("third-order prisms", 40),
        91 => ("fourth-order prisms", 75),
        92 => ("third-order hexahedra", 64),
        93 => ("fourth-order hexahedra", 125),
        94 => ("fifth-order hexahedra", 216),
        118 => ("third-order pyramids", 30),
        119 => ("fourth-order pyramids", 55),
        _ => return None,
    })
}

/// Name of a VTK cell type (vtkCellType.h).
pub fn vtk_cell(kind: i64) -> String {
    let name = match kind {
        1 => "points",
        2 => "polyvertices",
        3 => "lines",
        4 => "polylines",
        5 => "triangles",
        6 => "triangle strips",
        7 => "polygons",
        8 => "pixels",
        9 => "quadrangles",
        10 => "tetrahedra",
        11 => "voxels",
        12 => "hexahedra",
        13 => "prisms",
        14 => "pyramids",
        21 => "second-order lines",
        22 => "second-order triangles",
        23 | 28 => "second-order quadrangles",
        24 => "second-order tetrahedra",
        25 | 29 => "second-order hexahedra",
        26 => "second-order prisms",
        27 => "second-order pyramids",
        42 => "polyhedra",
        69 => "Lagrange triangles",
        71 => "Lagrange tetrahedra",
        76 => "Bezier triangles",
        78 => "Bezier tetrahedra",
        _ => return format!("cells of VTK type {kind}"),
    };
    name.to_owned()
}

/// `2 lines`, `1 line`: names of elements are plural.
pub fn counted(count: usize, name: &str) -> String {
    if count != 1 {
        return format!("{count} {name}");
    }
    let (of, kind) = match name.strip_prefix("elements of type") {
        Some(kind) => return format!("1 element of type{kind}"),
        None => name.rsplit_once(' ').unwrap_or(("", name)),
    };
    let one = match (kind.strip_suffix("hedra"), kind.strip_suffix('s')) {
        (Some(stem), _) => format!("{stem}hedron"),
        (None, Some("vertice")) => "vertex".to_owned(),
        (None, Some(stem)) => stem.to_owned(),
        (None, None) => kind.to_owned(),
    };
    match of {
        "" => format!("1 {one}"),
        of => format!("1 {of} {one}"),
    }
}

/// Whether elements of this name are tetrahedra with more than four nodes, which need
/// not have plane facets.
pub fn is_curved_tetrahedron(name: &str) -> bool {
    name.ends_with("tetrahedra") && name != "tetrahedra"
}

"""Writes the files of this folder that other programs make: meshio 5.3.5, Gmsh 4.15.2 and VTK 9.7.2.

    python3 -m venv venv && venv/bin/pip install meshio==5.3.5 lxml gmsh==4.15.2 vtk==9.7.2 && venv/bin/python make.py

The other files are public mesh files cut down to the fault that they show, or written by hand from the documentation
of their format (`cube.mesh`). tests/mesh_cases.rs has the right answers.
"""

import gmsh
import meshio
import numpy as np
import vtk

POINTS = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=float)
CELLS = np.array([[0, 1, 3, 7], [0, 1, 7, 5], [0, 2, 7, 3], [0, 2, 6, 7], [0, 4, 5, 7], [0, 4, 7, 6]])
cube = meshio.Mesh(POINTS, [("tetra", CELLS)])
cube.write("cube.inp")
cube.write("cube.bdf")
meshio.gmsh.write("cube40.msh", cube, fmt_version="4.0", binary=False)
meshio.gmsh.write("cube40_binary.msh", cube, fmt_version="4.0", binary=True)
cube.write("cube_lzma.vtu", compression="lzma", binary=True)

# The boundary of the cube: facets of one tetrahedron, in an order whose normal points out.
facets = {}
for cell in CELLS:
    for opposite in range(4):
        facet = [cell[k] for k in range(4) if k != opposite]
        if opposite % 2:
            facet[1], facet[2] = facet[2], facet[1]
        facets.setdefault(tuple(sorted(facet)), []).append(facet)
boundary = np.array([uses[0] for uses in facets.values() if len(uses) == 1])
surface = meshio.Mesh(POINTS, [("triangle", boundary)])
surface.write("cube.stl", binary=False)
surface.write("cube_binary.stl", binary=True)
surface.write("cube.obj")

SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=float)
square = meshio.Mesh(SQUARE, [("triangle", np.array([[0, 1, 2], [0, 2, 3]]))])
square.write("square.vtk", binary=False)

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
EDGES = [(0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)]


def second_order(move):
    """One tetrahedron of second order whose first middle node is moved."""
    middles = np.array([(CORNERS[a] + CORNERS[b]) / 2 for a, b in EDGES])
    middles[0] += move
    return meshio.Mesh(np.vstack([CORNERS, middles]), [("tetra10", np.arange(10)[None, :])])


second_order([0, 0, 0]).write("straight10.vtu", binary=False, compression=None)
second_order([0, -0.1, -0.05]).write("curved10.vtu", binary=False, compression=None)
meshio.gmsh.write("curved10.msh", second_order([0, -0.1, -0.05]), fmt_version="2.2", binary=False)
second_order([0.4, 0, 0]).write("invalid10.vtu", binary=False, compression=None)

# The unit disk in seven triangles of second order. Gmsh's own least value of the Jacobian is 0.78.
gmsh.initialize()
gmsh.model.occ.addDisk(0, 0, 0, 1, 1)
gmsh.model.occ.synchronize()
for name, value in (("MeshSizeMin", 0.9), ("MeshSizeMax", 0.9), ("ElementOrder", 2)):
    gmsh.option.setNumber(f"Mesh.{name}", value)
gmsh.model.mesh.generate(2)
for extension in ("msh", "mesh", "vtk", "bdf", "inp"):
    gmsh.write(f"gmsh_disk2.{extension}")

# Arrays of texts and of variants before and after the labels of two tetrahedra, as VTK 9.7.2 writes them. The
# texts have 0, 3 and 100 letters: their lengths have one and two bytes.
points = vtk.vtkPoints()
for point in ([0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, -1]):
    points.InsertNextPoint(point)
grid = vtk.vtkUnstructuredGrid()
grid.SetPoints(points)
for cell in ([0, 1, 2, 3], [0, 2, 1, 4]):
    corners = vtk.vtkIdList()
    for corner in cell:
        corners.InsertNextId(corner)
    grid.InsertNextCell(vtk.VTK_TETRA, corners)


def array(kind, name, values):
    made = kind()
    made.SetName(name)
    for value in values:
        made.InsertNextValue(value)
    return made


variants = array(vtk.vtkVariantArray, "variants", [vtk.vtkVariant("a b"), vtk.vtkVariant(1.5)])
for made in (
    array(vtk.vtkStringArray, "texts", ["", "x" * 100]),
    variants,
    array(vtk.vtkIntArray, "material", [7, 8]),
):
    grid.GetCellData().AddArray(made)
grid.GetPointData().AddArray(array(vtk.vtkStringArray, "names", ["", "a b", "%", "", "y" * 100]))
for version in (42, 51):
    for is_binary in (False, True):
        writer = vtk.vtkUnstructuredGridWriter()
        writer.SetInputData(grid)
        writer.SetFileVersion(version)
        writer.SetFileType(2 if is_binary else 1)
        writer.SetFileName(f"vtk_texts_{version}{'_binary' if is_binary else ''}.vtk")
        writer.Write()

# Formats of other programs, and a second-order tetrahedron with meshio's name for it in Nastran files.
meshio.write("fluent.msh", cube, file_format="ansys", binary=False)
second_order([0, -0.1, -0.05]).write("curved10.bdf")

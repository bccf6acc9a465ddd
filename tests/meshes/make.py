"""Writes the meshes of this folder with other programs, and what these programs say of them.

    python3 -m venv venv && venv/bin/pip install meshio==5.3.5 gmsh==4.15.2 pyvista==0.49.1
    venv/bin/python make.py

Every mesh is first a list of points and tetrahedra in this file, or made by Gmsh. meshio, Gmsh and VTK
(through pyvista) write it; oracle.json has the counts, points and tetrahedra as meshio reads them back, or VTK
for the files of VTK. The files are checked by tests/meshes.rs.
"""

import json
import pathlib
import warnings

import gmsh
import meshio
import numpy as np
import pyvista

HERE = pathlib.Path(__file__).parent
warnings.simplefilter("ignore")

# The cube of side 1 cut along its main diagonal into six tetrahedra (Kuhn): the paths from (0,0,0) to
# (1,1,1) along the axes, in the order of the six permutations. Scaled by 1/10 and moved, so that
# coordinates are no short binary fractions; and two triangles of its boundary beside them.
CUBE = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=float)
KUHN = []
for a, b, c in [(0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)]:
    path, corner = [0], 0
    for axis in (a, b, c):
        corner |= 1 << axis
        path.append(corner)
    p = CUBE[path]
    if np.linalg.det(p[1:] - p[0]) < 0:
        path[2], path[3] = path[3], path[2]
    KUHN.append(path)
KUHN = np.array(KUHN)
POINTS = CUBE * 0.1 + np.array([0.3, -1e-7, 12345.678])
TRIANGLES = np.array([[0, 1, 3], [0, 3, 2]])

ORACLE = {}


def record(name, points, tetrahedra, others, note):
    ORACLE[name] = {
        "points": [[float(x).hex() for x in p] for p in points],
        "tetrahedra": [[int(i) for i in t] for t in tetrahedra],
        "others": others,
        "note": note,
    }


def read_back(name, note):
    again = meshio.read(HERE / name)
    others = {}
    for cells in again.cells:
        if cells.type != "tetra":
            others[cells.type] = others.get(cells.type, 0) + len(cells.data)
    tetrahedra = np.vstack([cells.data for cells in again.cells if cells.type == "tetra"])
    record(name, again.points, tetrahedra, others, note)


def by_meshio(name, note, **options):
    mesh = meshio.Mesh(POINTS, [("triangle", TRIANGLES), ("tetra", KUHN)])
    if name.endswith(".ele") or "meshio-4" in name and ".msh" in name:
        mesh = meshio.Mesh(POINTS, [("tetra", KUHN)])
    if "meshio-2" in name:
        mesh.cell_data = {
            "gmsh:physical": [np.array([7, 7]), np.array([1, 1, 1, 2, 2, 2])],
            "gmsh:geometrical": [np.array([7, 7]), np.array([1, 1, 1, 2, 2, 2])],
        }
    if name.endswith(("mesh", "meshb")):
        mesh.cell_data = {"medit:ref": [np.array([7, 7]), np.array([1, 1, 1, 2, 2, 2])]}
    path = HERE / name
    mesh.write(path, **options)
    read_back(name, note)


def by_pyvista(name, note, edit=None, binary=True):
    cells = np.concatenate([np.insert(TRIANGLES, 0, 3, axis=1).ravel(), np.insert(KUHN, 0, 4, axis=1).ravel()])
    grid = pyvista.UnstructuredGrid(cells, [5, 5] + [10] * 6, POINTS)
    grid.cell_data["region"] = np.arange(8)
    path = str(HERE / name)
    if edit is None:
        grid.save(path, binary=binary)
    else:
        edit(grid, path)
    again = pyvista.read(path)
    tetrahedra = again.cells_dict[10]
    record(name, again.points, tetrahedra, {"triangle": len(again.cells_dict[5])}, note)


def vtu_writer(mode, compressor, head):
    def write(grid, path):
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter as Writer

        writer = Writer()
        writer.SetFileName(path)
        writer.SetInputData(grid)
        getattr(writer, f"SetDataModeTo{mode}")()
        writer.SetCompressorTypeToZLib() if compressor else writer.SetCompressorTypeToNone()
        writer.SetHeaderTypeToUInt32() if head == 32 else writer.SetHeaderTypeToUInt64()
        writer.SetEncodeAppendedData(mode == "Appended" and head == 64)
        writer.SetByteOrderToBigEndian() if head == 64 and not compressor else writer.SetByteOrderToLittleEndian()
        writer.Write()

    return write


def vtk_writer(version, binary):
    def write(grid, path):
        from vtkmodules.vtkIOLegacy import vtkUnstructuredGridWriter as Writer

        writer = Writer()
        writer.SetFileName(path)
        writer.SetInputData(grid)
        writer.SetFileVersion(version)
        writer.SetFileTypeToBinary() if binary else writer.SetFileTypeToASCII()
        writer.Write()

    return write


def by_gmsh():
    """A box with three pairs of periodic sides, meshed by Gmsh, in all its formats."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.model.occ.addBox(0, 0, 0, 1, 1, 1)
    gmsh.model.occ.synchronize()
    gmsh.option.setNumber("Mesh.MeshSizeMin", 0.6)
    gmsh.option.setNumber("Mesh.MeshSizeMax", 0.6)

    def side(axis, at):
        low, high = [-0.1] * 3, [1.1] * 3
        low[axis], high[axis] = at - 0.1, at + 0.1
        return [tag for _, tag in gmsh.model.getEntitiesInBoundingBox(*low, *high, 2)]

    for axis in range(3):
        shift = np.eye(4)
        shift[axis, 3] = 1
        gmsh.model.mesh.setPeriodic(2, side(axis, 1), side(axis, 0), shift.ravel().tolist())
    gmsh.model.mesh.generate(3)
    gmsh.option.setNumber("Mesh.SaveAll", 1)
    for name, version, binary in [
        ("gmsh-periodic-2.msh", 2.2, 0),
        ("gmsh-periodic-2-binary.msh", 2.2, 1),
        ("gmsh-periodic-4.msh", 4.1, 0),
        ("gmsh-periodic-4-binary.msh", 4.1, 1),
    ]:
        gmsh.option.setNumber("Mesh.MshFileVersion", version)
        gmsh.option.setNumber("Mesh.Binary", binary)
        gmsh.write(str(HERE / name))
        read_back(name, "Gmsh 4.15.2, read by meshio 5.3.5")
    gmsh.option.setNumber("Mesh.Binary", 0)
    for name in ["gmsh-box.mesh", "gmsh-box.vtk"]:
        gmsh.write(str(HERE / name))
        read_back(name, "Gmsh 4.15.2, read by meshio 5.3.5")
    gmsh.finalize()


by_meshio("meshio-2.msh", "meshio 5.3.5", file_format="gmsh22", binary=False)
by_meshio("meshio-2-binary.msh", "meshio 5.3.5", file_format="gmsh22", binary=True)
by_meshio("meshio-4.msh", "meshio 5.3.5", file_format="gmsh", binary=False)
by_meshio("meshio-4-binary.msh", "meshio 5.3.5", file_format="gmsh", binary=True)
by_meshio("meshio.mesh", "meshio 5.3.5")
by_meshio("meshio.meshb", "meshio 5.3.5")
by_meshio("meshio.ele", "meshio 5.3.5, with meshio.node")
by_meshio("meshio-42.vtk", "meshio 5.3.5", file_format="vtk42", binary=True)
by_meshio("meshio-51.vtk", "meshio 5.3.5", file_format="vtk51", binary=False)
by_meshio("meshio-base64.vtu", "meshio 5.3.5", binary=True, compression=None)
by_meshio("meshio-zlib.vtu", "meshio 5.3.5", binary=True, compression="zlib")
by_meshio("meshio-text.vtu", "meshio 5.3.5", binary=False)
for version in (42, 51):
    for binary in (False, True):
        kind = "binary" if binary else "text"
        by_pyvista(f"vtk-{version}-{kind}.vtk", "VTK 9.7.2", vtk_writer(version, binary))
for mode in ("Ascii", "Binary", "Appended"):
    for compressor in (False, True):
        for head in (32, 64):
            if mode == "Ascii" and (compressor or head == 64):
                continue
            name = f"vtk-{mode.lower()}{'-zlib' if compressor else ''}-{head}.vtu"
            by_pyvista(name, "VTK 9.7.2", vtu_writer(mode, compressor, head))
by_gmsh()
lines = [f"{json.dumps(name)}: {json.dumps(entry)}" for name, entry in ORACLE.items()]
(HERE / "oracle.json").write_text("{\n" + ",\n".join(lines) + "\n}\n")

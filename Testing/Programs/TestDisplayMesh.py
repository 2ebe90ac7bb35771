"""TestDisplayMesh.py SOLIDS SAMPLE [pyvista]: solidmoments.display_mesh() gives closed meshes of the parts, and the reader for PyVista the same.

Without the word pyvista the reader gets a stand-in for that package, which only keeps what it is given.
"""
import importlib.metadata
import os
import sys
import types

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check, check_equal, check_true, finish  # noqa: E402

import numpy  # noqa: E402

import solidmoments  # noqa: E402

folder, sample = sys.argv[1:3]
manifest = Manifest(folder)


def get_volume(points, triangles):
    a, b, c = (points[triangles[:, i]].astype(float) for i in range(3))
    return float((a * numpy.cross(b, c)).sum()) / 6.0


def check_mesh(what, mesh, volume, share):
    """A closed mesh with that volume within a share of it."""
    # Points of the mesh that are in one place are the corners of neighbours.
    places = numpy.unique(mesh.points, axis=0, return_inverse=True)[1].reshape(-1)[mesh.triangles]
    edges = numpy.concatenate([places[:, [0, 1]], places[:, [1, 2]], places[:, [2, 0]]])
    edges = edges[edges[:, 0] != edges[:, 1]]
    forth, back = (sorted(map(tuple, each)) for each in (edges, edges[:, ::-1]))
    check_true(f"{what}: every edge is used in both directions", forth == back and len(forth) > 0, f"{len(forth)} edges")
    check(f"{what}: volume", volume, get_volume(mesh.points, mesh.triangles), share * volume, "the deflection")
    check_true(f"{what}: a face index for each triangle", len(mesh.cell_data["FaceIndex"]) == len(mesh.triangles))
    check_equal(f"{what}: shapes", ((len(mesh.points), 3), (len(mesh.triangles), 3), (len(mesh.points), 2)),
                (mesh.points.shape, mesh.triangles.shape, mesh.point_data["Parameters"].shape))


exact = solidmoments.mass_properties(sample)
mesh, = solidmoments.display_mesh(sample)
check_mesh("sample", mesh, exact.volume, 0.01)
check_equal("sample: unit", "mm", mesh.length_unit)
fine, = solidmoments.display_mesh(sample, deflection=1e-4)
check_mesh("fine", fine, exact.volume, 0.002)
check_true("fine: more triangles", len(fine.triangles) > 2 * len(mesh.triangles), f"{len(fine.triangles)} {len(mesh.triangles)}")
inch, = solidmoments.display_mesh(sample, unit="inch")
check_mesh("inch", inch, exact.volume / 25.4 ** 3, 0.01)
check_equal("inch: unit", "inch", inch.length_unit)
two = manifest.special("two_solids")["path"]
solids = solidmoments.mass_properties(two).solids
for i, (solid, part) in enumerate(zip(solids, solidmoments.display_mesh(two))):
    check_mesh(f"two solids: {i}", part, solid.volume, 0.02)
    check_equal(f"two solids: name {i}", solid.name, part.name)
check_equal("a deflection as small as the reader's", 2, len(solidmoments.display_mesh(two, deflection=1e-30)))


def raised(error, *arguments, **options):
    try:
        solidmoments.display_mesh(*arguments, **options)
    except error as found:
        return found
    return None


check_true("a missing file", raised(FileNotFoundError, os.path.join(folder, "no such file.step")))
found = raised(solidmoments.SolidMomentsError, os.path.abspath(__file__))
check_true("a file that is not a STEP file", found and found.status == "unreadable" and found.messages, str(found))
for wrong in ({"unit": "mile"}, {"input_unit": "file"}, {"deflection": 0.0}):
    check_true(f"{wrong} is refused", raised(ValueError, sample, **wrong))

# PyVista finds the reader by entry points.
points = {point.name: point for point in importlib.metadata.entry_points(group="pyvista.readers") if point.value.startswith("solidmoments")}
check_equal("extensions", [".brep", ".brp", ".p21", ".step", ".stp"], sorted(points))
if sys.argv[3:] == ["pyvista"]:
    import pyvista

    blocks = pyvista.read(two)
else:
    class Mesh:
        def __init__(self, points, faces):
            self.points, self.regular_faces = points, faces.reshape(-1, 4)[:, 1:]
            self.volume = get_volume(points, self.regular_faces)
            self.point_data, self.cell_data, self.field_data = {}, {}, {}

    class Blocks(list):
        def append(self, block, name):
            super().append(block)
            self.names = getattr(self, "names", []) + [name]

        def keys(self):
            return self.names

    sys.modules["pyvista"] = types.SimpleNamespace(MultiBlock=Blocks, PolyData=Mesh)
    blocks = points[".step"].load()(two)
check_equal("PyVista: blocks", [solid.name for solid in solids], list(blocks.keys()))
for solid, block in zip(solids, blocks):
    check(f"PyVista: volume of {solid.name}", solid.volume, block.volume, 0.02 * solid.volume, "the deflection")
    check_true("PyVista: arrays", len(block.cell_data["FaceIndex"]) == len(block.regular_faces) and "Parameters" in block.point_data)
    check_equal("PyVista: unit", ["mm"], list(block.field_data["LengthUnit"]))
finish()

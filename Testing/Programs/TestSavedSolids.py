"""TestSavedSolids.py SOLIDS FOLDER: solids that are read and saved have the right volume in gmsh, by OpenCASCADE's integrals at their default.

Planes, cylinders, cones, spheres and tori must arrive as such: as rational B-splines their volumes are wrong there by up to 1 %.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check, check_equal, finish  # noqa: E402

import gmsh  # noqa: E402

from solidmoments.smReadersKernel import vtkBREPWriter, vtkSTEPWriter  # noqa: E402
from solidmoments.smReadersSTEP import vtkSTEPReader  # noqa: E402

manifest, folder = Manifest(sys.argv[1]), sys.argv[2]
os.makedirs(folder, exist_ok=True)
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.option.setString("Geometry.OCCTargetUnit", "MM")
EXPECTED = {"sphere": {"Sphere"}, "cylinder": {"Cylinder", "Plane"}, "cone": {"Cone", "Plane"}, "torus": {"Torus"},
            "hollow_sphere": {"Sphere"}, "bicylinder": {"Cylinder"}, "slanted_hole": {"Cylinder", "Plane"}, "box": {"Plane"}}
for solid, kinds in EXPECTED.items():
    for variant in ("plain", "turned", "mirrored"):
        source = manifest.solid(solid, variant)
        reader = vtkSTEPReader()
        reader.SetFileName(source["path"])
        reader.SetOutputUnit("mm")
        for writer, extension in ((vtkSTEPWriter(), "step"), (vtkBREPWriter(), "brep")):
            name = f"{solid}-{variant}.{extension}"
            path = os.path.join(folder, name)
            writer.SetInputConnection(reader.GetOutputPort())
            writer.SetFileName(path)
            check_equal(f"{name}: written", 1, writer.Write())
            gmsh.clear()
            gmsh.model.occ.importShapes(path)
            gmsh.model.occ.synchronize()
            volume = sum(gmsh.model.occ.getMass(3, tag) for _, tag in gmsh.model.getEntities(3))
            found = {gmsh.model.getType(2, tag) for _, tag in gmsh.model.getEntities(2)}
            check_equal(f"{name}: kinds of faces", kinds, found)
            check(f"{name}: volume in gmsh", source["volume"], volume, 1e-9 * source["volume"],
                  "OpenCASCADE's Gauss rules on elementary faces with edges of degree 12")
gmsh.finalize()
finish()

"""read_freecad.py LIB FILE...: prints what FreeCAD takes of STEP and BREP files, as JSON. LIB: the folder of its FreeCAD.so.

Kinds are those of the faces' surfaces, as gmsh calls them; volume, centre and tensor are FreeCAD's, of all solids, for density 1 in mm.
"""
import json
import os
import sys

sys.path[:0] = [sys.argv[1]] + [os.path.join(sys.argv[1], "..", "..", "freecad", name) for name in ("lib", "Mod")]
import FreeCAD  # noqa: E402
import Part  # noqa: E402

KINDS = {"SurfaceOfRevolution": "Surface of Revolution", "Toroid": "Torus", "BSplineSurface": "BSpline surface"}
found = {"version": ".".join(FreeCAD.Version()[:3]), "OpenCASCADE": Part.OCC_VERSION, "files": {}}
for path in sys.argv[2:]:
    shape = Part.Shape()
    shape.read(path)
    solids = shape.Solids
    volume = sum(solid.Volume for solid in solids)
    center = [sum(solid.Volume * solid.CenterOfMass[i] for solid in solids) / volume for i in range(3)] if volume else None
    tensor = [[0.0] * 3 for _ in range(3)]
    for solid in solids if volume else ():
        m = solid.MatrixOfInertia
        own = ((m.A11, m.A12, m.A13), (m.A21, m.A22, m.A23), (m.A31, m.A32, m.A33))
        d = [solid.CenterOfMass[i] - center[i] for i in range(3)]
        for i in range(3):
            for k in range(3):
                tensor[i][k] += own[i][k] + solid.Volume * ((sum(x * x for x in d) if i == k else 0.0) - d[i] * d[k])
    kinds = sorted({KINDS.get(type(face.Surface).__name__, type(face.Surface).__name__) for face in shape.Faces})
    found["files"][path] = {"volume": volume, "center": center, "inertia": tensor, "solids": len(solids), "kinds": kinds, "valid": shape.isValid()}
print(json.dumps(found))

#!/usr/bin/env python3
"""
FreeCAD's way, for comparison: the solids of a STEP or BREP file by its shapes' Volume, Area, CenterOfMass and MatrixOfInertia, as JSON on the
standard output.

  python3 freecad_mass_properties.py part.step [LIB]        (Debian: freecad-python3)

LIB is the folder of FreeCAD.so, /usr/lib/freecad-python3/lib unless it is given.

Lengths are mm. The inertia is about the centre of mass of all solids, with negative products of inertia. FreeCAD states no error.
Exit status: 0; 1 wrong usage; 2 a file that cannot be read or has no solid.
"""
import json
import os
import sys


def compute(path, library="/usr/lib/freecad-python3/lib"):
    """The result, or None where the file has no solid."""
    sys.path[:0] = [library] + [os.path.join(library, "..", "..", "freecad", name) for name in ("lib", "Mod")]
    import FreeCAD  # noqa: F401  (Part needs it)
    import Part

    shape = Part.Shape()
    try:
        shape.read(path)
    except Exception:  # FreeCAD has no narrower one
        return None
    solids = shape.Solids
    volume = sum(solid.Volume for solid in solids)
    if not volume:
        return None
    center = [sum(solid.Volume * solid.CenterOfMass[i] for solid in solids) / volume for i in range(3)]
    inertia = [[0.0] * 3 for _ in range(3)]
    for solid in solids:
        m = solid.MatrixOfInertia
        own = ((m.A11, m.A12, m.A13), (m.A21, m.A22, m.A23), (m.A31, m.A32, m.A33))
        d = [solid.CenterOfMass[i] - center[i] for i in range(3)]
        for i in range(3):
            for k in range(3):
                inertia[i][k] += own[i][k] + solid.Volume * ((sum(x * x for x in d) if i == k else 0.0) - d[i] * d[k])
    return {"file": path, "length_unit": "mm", "volume": volume, "area": sum(solid.Area for solid in solids), "center_of_mass": center, "inertia": inertia}


def main():
    if not 2 <= len(sys.argv) <= 3 or sys.argv[1].startswith("-"):
        print(__doc__, file=sys.stderr)
        return 1
    result = compute(*sys.argv[1:])
    if result is None:
        print(f"{sys.argv[1]}: no solid can be read", file=sys.stderr)
        return 2
    print(json.dumps(result))
    return 0


if __name__ == "__main__":
    sys.exit(main())

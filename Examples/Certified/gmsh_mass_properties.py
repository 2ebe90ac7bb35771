#!/usr/bin/env python3
"""
gmsh's way, for comparison: the solids of a STEP or BREP file by OpenCASCADE's integrals at their default, as JSON on the standard output.

  python3 gmsh_mass_properties.py part.step        (Debian: python3-gmsh)

Lengths are mm. The inertia is about the centre of mass of all solids, with negative products of inertia. gmsh states no error.
Exit status: 0; 1 wrong usage; 2 a file that cannot be read or has no solid.
"""
import json
import sys

import gmsh


def compute(path):
    """The result, or None where the file has no solid."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setString("Geometry.OCCTargetUnit", "MM")
    occ = gmsh.model.occ
    try:
        occ.importShapes(path)
        occ.synchronize()
    except Exception:  # gmsh has no narrower one
        return None
    solids = [tag for _, tag in gmsh.model.getEntities(3)]
    volumes = [occ.getMass(3, tag) for tag in solids]
    volume = sum(volumes)
    if not volume:
        return None
    centers = [occ.getCenterOfMass(3, tag) for tag in solids]
    center = [sum(v * c[i] for v, c in zip(volumes, centers)) / volume for i in range(3)]
    inertia = [[0.0] * 3 for _ in range(3)]
    for tag, v, c in zip(solids, volumes, centers):
        own = occ.getMatrixOfInertia(3, tag)
        d = [c[i] - center[i] for i in range(3)]
        for i in range(3):
            for k in range(3):
                inertia[i][k] += own[3 * i + k] + v * ((sum(x * x for x in d) if i == k else 0.0) - d[i] * d[k])
    return {"file": path, "length_unit": "mm", "volume": volume, "area": sum(occ.getMass(2, tag) for _, tag in gmsh.model.getEntities(2)),
            "center_of_mass": center, "inertia": inertia}


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        print(__doc__, file=sys.stderr)
        return 1
    result = compute(sys.argv[1])
    if result is None:
        print(f"{sys.argv[1]}: no solid can be read", file=sys.stderr)
        return 2
    print(json.dumps(result))
    return 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""
The VTK way, for comparison: the solids of a STEP file as triangles, then vtkMassProperties, as JSON on the standard output.

  PYTHONPATH=PREFIX/lib/python3.11/site-packages python3 vtk_mass_properties.py [--deflection REL] part.step

The triangles are vtkSTEPReader's display mesh, whose chords are within the deflection, relative to the diagonal of each body (default:
that of the reader). vtkMassProperties computes volume and area only, and states no error.
Exit status: 0; 1 wrong usage; 2 a file that cannot be read.
"""
import argparse
import json
import sys

from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkMassProperties, vtkTriangleFilter
from solidmoments.smReadersSTEP import vtkSTEPReader


def compute(path, deflection):
    """The result, or None where the file has no solid."""
    reader = vtkSTEPReader()
    reader.SetFileName(path)
    if deflection is not None:
        reader.SetLinearDeflection(deflection)
    reader.Update()
    collection = reader.GetOutput()
    leaves = vtkAppendPolyData()
    for i in range(collection.GetNumberOfPartitionedDataSets()):
        leaves.AddInputData(collection.GetPartition(i, 0))
    if reader.GetErrorCode() or not leaves.GetNumberOfInputConnections(0):
        return None
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(leaves.GetOutputPort())
    triangles.PassVertsOff()
    triangles.PassLinesOff()
    mass = vtkMassProperties()
    mass.SetInputConnection(triangles.GetOutputPort())
    mass.Update()
    return {"file": path, "length_unit": "mm", "volume": mass.GetVolume(), "area": mass.GetSurfaceArea()}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", help="STEP file")
    parser.add_argument("--deflection", type=float, metavar="REL", help="largest distance of the chords")
    try:
        arguments = parser.parse_args()
    except SystemExit as stop:
        return 1 if stop.code else 0
    vtkObject.GlobalWarningDisplayOff()
    result = compute(arguments.file, arguments.deflection)
    if result is None:
        print(f"{arguments.file}: no solid can be read", file=sys.stderr)
        return 2
    print(json.dumps(result))
    return 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""
The volume of the solids in a STEP file, and its bound:

  PYTHONPATH=PREFIX/lib/python3.11/site-packages python3 volume.py part.step

PREFIX: where SolidMoments is installed, or its build folder. mass_properties.py is the complete script, with every quantity, CSV and
pictures.
"""
# [ten lines]
import sys
from solidmoments.smFiltersMassProperties import vtkMassPropertiesGPU
from solidmoments.smReadersSTEP import vtkSTEPReader
reader = vtkSTEPReader()
reader.SetFileName(sys.argv[1])
mass = vtkMassPropertiesGPU()
mass.SetInputConnection(reader.GetOutputPort())
mass.Update()
print("volume", mass.GetVolume(), "+/-", mass.GetVolumeBound(), mass.GetStatus())
# [ten lines]
sys.exit(0 if mass.GetStatus() == "ok" else 3)

#!/usr/bin/env python3
"""
Mass properties of a STEP file by one call:

  PYTHONPATH=PREFIX/lib/python3.11/site-packages python3 one_call.py part.step

PREFIX: where SolidMoments is installed, or its build folder.
"""
import sys
# [one call]
import solidmoments

part = solidmoments.mass_properties(sys.argv[1], density=7850.0)
print("volume", part.volume, "+/-", part.volume_bound, part.units["volume"], part.status)
print("mass", part.mass, "+/-", part.mass_bound, part.units["mass"])
for solid in part.solids:
    print(solid.name, solid.center_of_mass, solid.length_unit)
# [one call]
sys.exit(0 if part.status == "ok" else 3)

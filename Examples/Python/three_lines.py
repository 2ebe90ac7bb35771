#!/usr/bin/env python3
"""
The mass of the part in part.step, of steel, in the current folder:

  PYTHONPATH=PREFIX/lib/python3.11/site-packages python3 three_lines.py

PREFIX: where SolidMoments is installed, or its build folder. one_call.py takes any file and prints more.
"""
# [three lines]
import solidmoments
part = solidmoments.mass_properties("part.step", density=7850)
print(part.mass, "+/-", part.mass_bound, part.units["mass"], part.status)
# [three lines]

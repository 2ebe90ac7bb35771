"""Mass properties of STEP files with error bounds.

>>> import solidmoments
>>> part = solidmoments.mass_properties("part.step", density=7850.0)
>>> part.volume, part.volume_bound, part.units["volume"]

`mass_properties` reads one file, `to_dataframe` several into a table of pandas. Numbers are those of the program `solidmoments`, bit for
bit. The VTK classes behind them are in the extension modules of this package, for example `solidmoments.smFiltersMassProperties`, and
load with the first call.
"""
from ._results import FlaggedResultWarning, MassProperties, SolidMomentsError
from ._run import mass_properties, to_dataframe
from ._version import __version__

__all__ = ["FlaggedResultWarning", "MassProperties", "SolidMomentsError", "__version__", "mass_properties", "to_dataframe"]

"""TestPluginLoads.py PLUGIN.so FILE.step VOLUME: the plugin loads and computes without a display."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check, finish  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

plugin, path, volume = sys.argv[1:4]
simple.LoadPlugin(plugin, ns=globals())
mass = MassProperties(Input=simple.OpenDataFile(path))  # noqa: F821
fields = servermanager.Fetch(mass, idx=0).GetFieldData()
check("volume", float(volume), fields.GetArray("Volume").GetValue(0), 1e-9 * float(volume))
finish()

"""TestPluginHostile.py PLUGIN.so SOLIDMOMENTS FOLDER SAMPLE.step: one session survives every damaged file of a folder, with the status that
the command line gives; a sound file afterwards has its volume."""
import glob
import json
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check, check_equal, check_true, finish  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

plugin, program, folder, sample = sys.argv[1:5]
simple.LoadPlugin(plugin, ns=globals())


def weigh_here(path):
    """Status and volume."""
    reader = simple.OpenDataFile(path)
    mass = MassProperties(Input=reader)  # noqa: F821
    mass.UpdatePipeline()
    fields = servermanager.Fetch(mass, idx=0).GetFieldData()
    result = fields.GetAbstractArray("Status").GetValue(0), fields.GetArray("Volume").GetValue(0)
    simple.Delete(mass)
    simple.Delete(reader)
    return result


paths = sorted(glob.glob(os.path.join(folder, "*.step"))) + [sample]
done = subprocess.run([program, "--quiet", "--json", "-", *paths], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False)
entries = json.loads(done.stdout)["files"]
check_equal("files", len(paths), len(entries))
check_true("some are flagged", sum(entry["status"] in ("suspect", "open") for entry in entries) > 5)
for path, entry in zip(paths, entries):
    status, volume = weigh_here(path)
    name = os.path.basename(path)
    check_equal(name + ": status", entry["status"], status)
    expected = entry["total"]["volume"] if entry["total"] else None
    if expected is None:
        check_true(name + ": no volume", volume != volume, str(volume))
    else:
        check(name + ": volume", expected, volume, 2e-9 * abs(expected))
finish()

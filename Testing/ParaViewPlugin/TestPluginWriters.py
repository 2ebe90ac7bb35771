"""TestPluginWriters.py PLUGIN.so SOLIDS OUTPUT [PVSERVER]: Save Data writes exact geometry, here or on a server."""
import atexit
import os
import socket
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check, check_equal, check_true, finish  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

plugin, solids, output = sys.argv[1:4]
server = None
prefix = "server" if len(sys.argv) > 4 else "plugin"
if len(sys.argv) > 4:
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        port = probe.getsockname()[1]
    server = subprocess.Popen([sys.argv[4], f"--server-port={port}"], stdout=subprocess.PIPE, text=True)
    atexit.register(server.kill)
    while "Accepting" not in (server.stdout.readline() or "Accepting"):
        pass
    simple.Connect("localhost", port)
    simple.LoadPlugin(plugin, remote=True, ns=globals())
simple.LoadPlugin(plugin, remote=False, ns=globals())
manifest = Manifest(solids)


def weigh(source):
    mass = MassProperties(Input=source)  # noqa: F821
    fields = servermanager.Fetch(mass, idx=0).GetFieldData()
    return fields.GetArray("Volume").GetValue(0), fields.GetArray("SurfaceArea").GetValue(0), \
        fields.GetAbstractArray("Status").GetValue(0)


for solid, variant in (("slanted_hole", "inch"), ("torus", "turned"), ("hollow_sphere", "mirrored")):
    part = manifest.solid(solid, variant)
    reader = simple.OpenDataFile(part["path"])
    path = os.path.join(output, f"{prefix}-{solid}.step")
    if os.path.exists(path):
        os.remove(path)
    # Clip calls Modified() on the points of its input, which keeps its exact faces.
    clip = simple.Clip(Input=reader)
    clip.UpdatePipeline()
    simple.SaveData(path, proxy=reader)
    again = simple.OpenDataFile(path)
    check_equal(f"{solid}: our reader opens it", "STEPReader", again.GetXMLName())
    before, after = weigh(reader), weigh(again)
    check_equal(f"{solid}: status", "ok", after[2])
    check(f"{solid}: volume", before[0], after[0], 1e-13 * before[0])
    check(f"{solid}: area", before[1], after[1], 1e-13 * before[1])
    check(f"{solid}: exact volume", part["volume"], after[0], 1e-9 * part["volume"])
    with open(path, encoding="utf-8") as file:
        text = file.read()
    kinds = ("CYLINDRICAL_SURFACE", "SPHERICAL_SURFACE", "TOROIDAL_SURFACE", "B_SPLINE_SURFACE")
    check_true(f"{solid}: curved faces, no triangles", any(kind in text for kind in kinds) and text.count("ADVANCED_FACE") <= 8,
               str(text.count("ADVANCED_FACE")))
    check_equal(f"{solid}: the file's own unit", variant == "inch", "INCH" in text)

# The writer's property OutputUnit, and the BREP writer.
reader = simple.OpenDataFile(manifest.solid("box")["path"])
path = os.path.join(output, f"{prefix}-metres.step")
simple.SaveData(path, proxy=reader, OutputUnit="m")
with open(path, encoding="utf-8") as file:
    check_true("in metres", "SI_UNIT($,.METRE.)" in file.read().replace(" ", ""))
check("the same box", weigh(reader)[0], weigh(simple.OpenDataFile(path))[0], 1e-12 * weigh(reader)[0])

brep = os.path.join(output, f"{prefix}-box.brep")
simple.SaveData(brep, proxy=reader)
with open(brep, encoding="utf-8") as file:
    check_true("BREP", "CASCADE Topology" in file.read(200))
again = simple.OpenDataFile(brep)
check_equal("BREP: our reader opens it", "BREPReader", again.GetXMLName())
check("BREP: volume", weigh(reader)[0], weigh(again)[0], 1e-13 * weigh(reader)[0])
again.InputUnit = "cm"
check("BREP: volume in cm", 1000.0 * weigh(reader)[0], weigh(again)[0], 1e-10 * weigh(reader)[0])
if server:
    check_true("this was remote", servermanager.ActiveConnection.IsRemote())
finish()

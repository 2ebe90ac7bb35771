"""TestPluginFilters.py PLUGIN.so FOLDER [URL]: choosing solids, integrals, edits, and which inputs the filters take; on a server."""
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check, check_equal, check_true, finish  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

plugin, folder = sys.argv[1:3]
if len(sys.argv) > 3:
    host, port = sys.argv[3].split(":")
    simple.Connect(host, int(port))
    simple.LoadPlugin(plugin, remote=True, ns=globals())
simple.LoadPlugin(plugin, remote=False, ns=globals())
manifest = Manifest(folder)


def total(filter_proxy, name):
    array = servermanager.Fetch(filter_proxy, idx=0).GetFieldData().GetArray(name)
    return array.GetValue(0) if array else math.nan


def is_accepted(proxy_name, source, port=0):
    """What the Filters menu asks before it offers a filter."""
    prototype = servermanager.ProxyManager().SMProxyManager.GetPrototypeProxy("filters", proxy_name)
    inputs = prototype.GetProperty("Input")
    inputs.RemoveAllUncheckedProxies()
    inputs.AddUncheckedInputConnection(source.SMProxy, port)
    accepted = inputs.IsInDomains()
    inputs.RemoveAllUncheckedProxies()
    return bool(accepted)


# Choosing: what the tree of the panel sets, from the product structure and from the blocks.
pair = manifest.special("two_solids")
ball = 4.0 / 3.0 * math.pi * 10.0 ** 3
reader = simple.OpenDataFile(pair["path"])
reader.UpdatePipeline()
mass = MassPropertiesGPU(Input=reader)  # noqa: F821
mass.UpdatePipeline()
check("everything is weighed by default", pair["volume"], total(mass, "Volume"), 1e-9 * pair["volume"])
check_equal("what can be chosen from", ["Hierarchy", "Assembly"], list(mass.GetProperty("Assembly").GetAvailable()))
domain = mass.SMProxy.GetProperty("Selectors").FindDomain("vtkSMDataAssemblyDomain")
domain.Update(None)
assembly = domain.GetDataAssembly()
leaves = [assembly.GetNodePath(node) for node in assembly.SelectNodes(["//*"]) if assembly.GetDataSetIndices(node, False)]
check_true("the tree has nodes to tick", len(leaves) >= 1, str(leaves))
mass.Assembly = "Hierarchy"
domain.Update(None)
hierarchy = domain.GetDataAssembly()
solids = [hierarchy.GetNodePath(node) for node in hierarchy.GetChildNodes(0, False)]
check_equal("blocks to tick", 2, len(solids))
volumes = []
for solid in solids:
    mass.Selectors = [solid]
    volumes.append(total(mass, "Volume"))
check("a block at a time: the ball", ball, min(volumes), 1e-9 * ball)
check("a block at a time: the box", 6000.0 if max(volumes) > 5000 else math.nan, max(volumes), 1e-5)
check_equal("rows of the table", 1, servermanager.Fetch(mass, idx=1).GetNumberOfRows())
mass.Selectors = []
check("everything again", pair["volume"], total(mass, "Volume"), 1e-9 * pair["volume"])
mass.Density = 2000.0
check("one density for all, kg", pair["volume"] * 2e-6, total(mass, "Mass"), 1e-12 * pair["volume"])

# Any integral.
sphere = manifest.solid("sphere")
source = simple.OpenDataFile(sphere["path"])
integral = SurfaceIntegralGPU(Input=source)  # noqa: F821
radius = (sphere["volume"] * 0.75 / math.pi) ** (1.0 / 3.0)
integral.Integrands = "willmore = meanCurvature * meanCurvature * dA\nflux = position.x ; 0 ; 0"
integral.MomentDegree = 2
integral.BendingEnergy = 1
integral.ProjectedAreaDirection = [0.0, 0.0, 2.0]
for name, expected in (("willmore", 4.0 * math.pi), ("flux", sphere["volume"]), ("moment_0_0_0", sphere["volume"]),
                       ("BendingEnergy", 8.0 * math.pi), ("ProjectedArea", math.pi * radius ** 2)):
    check(name, expected, total(integral, name), 1e-8 * expected)
check_true("the summary has them", "BendingEnergy = 25.13" in servermanager.Fetch(integral, idx=2).GetValueByName(
    0, "Text").ToString())
integral.Integrands = ""
integral.MomentDegree = -1
check_true("what is switched off is gone", math.isnan(total(integral, "willmore")) and math.isnan(total(integral, "moment_0_0_0")))
check_true("the solids can be coloured by it", servermanager.OutputPort(integral, 5).CellData["BendingEnergy"] is not None)

# Edits follow one another and are weighed.
moved = NURBSTransform(Input=source, Translation=[1.0, 2.0, 3.0], Rotation=[10.0, 20.0, 30.0])  # noqa: F821
deformed = NURBSDeform(Input=moved, Displacement=[radius, 0.0, 0.0], Radius=0.0)  # noqa: F821
weighed = MassPropertiesGPU(Input=deformed)  # noqa: F821
check("moved and pushed: the volume stays", sphere["volume"], total(weighed, "Volume"), 1e-9 * sphere["volume"])
check_equal("a centre that a script gives is kept", [0.0, 0.0, 0.0], list(NURBSDeform(  # noqa: F821
    Input=moved, Center=[0.0, 0.0, 0.0]).Center))
deformed.Center = [1.0 + radius, 2.0, 3.0]
deformed.Radius = radius
check_true("a bulge adds to it", total(weighed, "Volume") > 1.001 * sphere["volume"], str(total(weighed, "Volume")))
deformed.Displacement = [0.0, 0.0, 0.0]
check("and the part is back", sphere["volume"], total(weighed, "Volume"), 1e-9 * sphere["volume"])

# The filters accept exact faces and nothing else.
filters = ("MassPropertiesGPU", "SurfaceIntegralGPU", "NURBSTransform", "NURBSDeform")
plain = simple.Transform(Input=source)
plain.Transform.Translate = [1.0, 0.0, 0.0]
wavelet = simple.Wavelet()
extracted = simple.ExtractBlock(Input=reader, Selectors=[solids[0]])
tessellated = simple.Sphere()
for each in (source, plain, wavelet, extracted, tessellated, moved, deformed, mass):
    each.UpdatePipeline()
for name in filters:
    for what, each, port, expected in (("the reader", source, 0, True), ("NURBS Transform", moved, 0, True),
                                       ("NURBS Deform", deformed, 0, True), ("an extracted block", extracted, 0, True),
                                       ("the bodies of Mass Properties", mass, 5, True), ("its marker", mass, 0, False),
                                       ("its table", mass, 1, False), ("ParaView's Transform", plain, 0, False),
                                       ("a wavelet", wavelet, 0, False), ("a mesh", tessellated, 0, False)):
        check_equal(f"{name} takes {what}", expected, is_accepted(name, each, port))
check("and weighs what was extracted", volumes[0], total(MassPropertiesGPU(Input=extracted), "Volume"),  # noqa: F821
      1e-12 * pair["volume"])
finish()

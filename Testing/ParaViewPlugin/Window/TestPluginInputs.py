"""TestPluginInputs.py PLUGIN.so STEP: the filters that the menu offers for an input."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Support"))
from smcheck import check_equal, finish  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

plugin, part = sys.argv[1:3]
simple.LoadPlugin(plugin, ns=globals())
manager = servermanager.ProxyManager()
# A filter of a module that is not built is not in the plugin.
FILTERS = [name for name in ("MassPropertiesGPU", "SurfaceIntegralGPU", "SchemeMassProperties", "Buoyancy", "SolidSection", "SolidStability",
                             "NURBSTransform", "NURBSDeform") if manager.SMProxyManager.HasDefinition("filters", name)]
check_equal("no entry that only explains", False, bool(manager.SMProxyManager.HasDefinition("filters", "WhyNotThisInput")))


def is_offered(name, source):
    """The check of pqFiltersMenuReaction: the prototype's domains with this input."""
    prototype = manager.GetPrototypeProxy("filters", name)
    source = source.SMProxy
    source.UpdatePipeline()
    prototype_input = prototype.GetProperty("Input")
    prototype_input.RemoveAllUncheckedProxies()
    prototype_input.AddUncheckedInputConnection(source, 0)
    offered = prototype_input.IsInDomains() != 0
    prototype_input.RemoveAllUncheckedProxies()
    return offered


reader = simple.OpenDataFile(part)
inputs = [("STEP Reader", reader, True)]
if "NURBSTransform" in FILTERS:
    inputs.append(("NURBS Transform", NURBSTransform(Input=reader, Translation=[1.0, 2.0, 3.0]), True))  # noqa: F821
sphere = simple.Sphere()
dropped = simple.Transform(Input=reader)
dropped.Transform.Translate = [1.0, 0.0, 0.0]
inputs += [("Sphere", sphere, False), ("Transform, which drops the faces", dropped, False), ("Wavelet", simple.Wavelet(), False)]
for what, source, exact in inputs:
    for name in FILTERS:
        check_equal(f"{what}: {name}", exact, is_offered(name, source))
finish()

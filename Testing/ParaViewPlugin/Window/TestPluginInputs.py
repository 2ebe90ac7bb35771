"""TestPluginInputs.py PLUGIN.so STEP: which filters the menu offers for which input, and what it says about the others."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Support"))
from smcheck import check_equal, check_true, finish  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

plugin, part = sys.argv[1:3]
simple.LoadPlugin(plugin, ns=globals())
manager = servermanager.ProxyManager()
OURS = ("MassPropertiesGPU", "SurfaceIntegralGPU", "SolidStability", "NURBSTransform", "NURBSDeform")


def is_offered(name, source):
    """As pqFiltersMenuReaction asks: the prototype's domains with this input."""
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
moved = NURBSTransform(Input=reader)  # noqa: F821
moved.Translation = [1.0, 2.0, 3.0]
sphere = simple.Sphere()
dropped = simple.Transform(Input=reader)
dropped.Transform.Translate = [1.0, 0.0, 0.0]
for what, source, exact in (("STEP Reader", reader, True), ("NURBS Transform", moved, True), ("Sphere", sphere, False),
                            ("Transform, which drops the faces", dropped, False), ("Wavelet", simple.Wavelet(), False)):
    for name in OURS:
        check_equal(f"{what}: {name}", exact, is_offered(name, source))
    check_equal(f"{what}: the entry that explains", not exact, is_offered("WhyNotThisInput", source))

why = manager.GetPrototypeProxy("filters", "WhyNotThisInput")
for name in OURS:
    hint = manager.GetPrototypeProxy("filters", name).GetHints().FindNestedElementByName("ShowInMenu")
    check_equal(f"{name}: the same menu", why.GetHints().FindNestedElementByName("ShowInMenu").GetAttribute("category"),
                hint.GetAttribute("category"))
check_true("the entry itself says what to feed", "STEP" in why.GetXMLLabel(), why.GetXMLLabel())
text = why.GetHints().FindNestedElementByName("WarnOnCreate").GetCharacterData()
for word in ("STEP Reader", ".step", "NURBS Transform", "NURBS Deform", "File > Open"):
    check_true(f"what it asks says '{word}'", word in text)
check_true("no mark-up: ParaView shows it as it is", "<" not in text and "*" not in text and "\n\n" not in text.strip(), repr(text[:60]))
finish()

"""TestPluginInputs.py PLUGIN.so STEP OUTPUT: the filters that the menu offers for an input; files that are none; an edit that tears the part."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Support"))
from smcheck import check_equal, check_true, finish  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

plugin, part, output = sys.argv[1:4]
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


def collect(source, event):
    """The texts of a source's events, also of those to come."""
    texts = []

    def note(_caller, _event, text):
        texts.append(text)

    note.CallDataType = "string0"
    source.GetClientSideObject().AddObserver(event, note)
    return texts


def weigh(source):
    mass = MassProperties(Input=source)  # noqa: F821
    mass.UpdatePipeline()
    status = servermanager.Fetch(mass, idx=0).GetFieldData().GetAbstractArray("Status").GetValue(0)
    return status, " ".join(servermanager.Fetch(mass, idx=2).GetValueByName(0, "Text").ToString().split())


# A file that is empty or a text is a STEP file by its name: no other reader is asked for, and the view says
# what is wrong.
for name, content, words in (("empty", "", "it is empty; export it again"), ("letter", "Dear reader,\n" * 40, "it is not a STEP file")):
    path = os.path.join(output, f"PluginInputs_{name}.step")
    with open(path, "w", encoding="utf-8") as file:
        file.write(content)
    opened = simple.OpenDataFile(path)
    check_equal(f"{name}: the reader", "STEPReader", opened.GetXMLName() if opened else None)
    errors = collect(opened, "ErrorEvent")
    status, summary = weigh(opened)
    check_true(f"{name}: the message, once", len(errors) == 1 and words in errors[0], str(errors))
    check_true(f"{name}: the view says so", status == "unreadable" and words in summary, summary)

# A displacement of 25 mm tears faces of the sample part from their edges.
if "NURBSDeform" in FILTERS:
    torn = NURBSDeform(Input=reader, Center=[110.0, 18.0, 17.0], Radius=45.0, Displacement=[0.0, 25.0, 0.0])  # noqa: F821
    warnings = collect(torn, "WarningEvent")
    status, summary = weigh(torn)
    check_true("torn: the filter says so, and the remedy", len(warnings) == 1 and "tears faces from their edges" in warnings[0] and
               "Remedy: " in warnings[0], str(warnings))
    check_true("torn: so do the mass properties", status == "suspect" and "gap" in summary, f"{status}: {summary}")
    torn.Displacement = [0.0, 0.1, 0.0]
    warnings.clear()
    check_equal("a small displacement: the status", "ok", weigh(torn)[0])
    check_equal("a small displacement: warnings", [], warnings)
finish()

"""TestPluginDefaults.py PLUGIN.so: every property in the XML has the default and the limits of its C++ class, and says so; texts of the GUI."""
import glob
import importlib
import importlib.util
import math
import os
import re
import sys
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check_equal, check_true, finish  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

# Group, proxy, label, Python module and class.
PROXIES = (("sources", "STEPReader", "STEP Reader", "smReadersSTEP", "vtkSTEPReader"),
           ("sources", "BREPReader", "BREP Reader", "smReadersBREP", "vtkBREPReader"),
           ("writers", "STEPWriter", "STEP (exact NURBS solids)", "smReadersKernel", "vtkSTEPWriter"),
           ("filters", "MassPropertiesGPU", "Mass Properties", "smFiltersMassProperties", "vtkMassPropertiesGPU"),
           ("filters", "MassSensitivity", "Mass Sensitivity", "smFiltersMassProperties", "vtkMassSensitivity"),
           ("filters", "MassTolerances", "Mass Tolerances", "smFiltersMassProperties", "vtkMassTolerances"),
           ("filters", "SurfaceIntegralGPU", "Surface Integral", "smFiltersSurfaceIntegrals", "vtkSurfaceIntegralGPU"),
           ("filters", "SchemeMassProperties", "Mass Properties by Paper Schemes", "smFiltersMomentSchemes", "vtkSchemeMassPropertiesGPU"),
           ("filters", "Buoyancy", "Buoyancy", "smFiltersBuoyancy", "vtkBuoyancy"),
           ("filters", "SolidSection", "Section", "smFiltersSection", "vtkSolidSection"),
           ("filters", "NURBSTransform", "NURBS Transform", "smFiltersNURBSEdit", "vtkNURBSTransform"),
           ("filters", "NURBSDeform", "NURBS Deform", "smFiltersNURBSEdit", "vtkNURBSDeform"),
           ("filters", "MomentGradient", "Moment Gradient", "smFiltersMomentGradient", "vtkMomentGradient"),
           ("filters", "SolidStability", "Static Stability", "smFiltersStability", "vtkSolidStability"))

simple.LoadPlugin(sys.argv[1], ns=globals())
manager = servermanager.ProxyManager().SMProxyManager
folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "ParaViewPlugin", "SolidMoments")
# (group, name): the element.
DEFINITIONS = {(group.get("name"), element.get("name")): element for path in sorted(glob.glob(os.path.join(folder, "*.xml")))
               for group in ElementTree.parse(path).getroot() for element in group}


def collect_hierarchy(element):
    """The element and those that it is derived from, the last base first."""
    base = (element.get("base_proxygroup"), element.get("base_proxyname"))
    return (collect_hierarchy(DEFINITIONS[base]) if base in DEFINITIONS else []) + [element]


check_equal("every proxy of the XML is tested", sorted(proxy[:2] for proxy in PROXIES) + [("writers", name) for name in ("CADTableWriter", "BREPWriter")], sorted(
    key for key in DEFINITIONS if key[0] in ("sources", "filters") and key[1] not in ("ConvertSelection", "MassPropertiesByWords")) + sorted(key for key in DEFINITIONS if key[0] == "writers")[::-1])
# ParaView's search knows labels only: a second label has the words of a user, and makes the filter itself.
label = DEFINITIONS["filters", "MassPropertiesByWords"].get("label").lower()
check_equal("words of the search", [], [word for word in ("volume", "inertia", "gravity", "centre of", "center of mass", "mass properties") if word not in label])
manager = servermanager.ProxyManager().SMProxyManager
check_equal("the menu has this label", label, manager.GetPrototypeProxy("filters", "MassPropertiesByWords").GetXMLLabel().lower())
made = manager.NewProxy("filters", "MassPropertiesByWords")
made.UpdateVTKObjects()
check_equal("what it makes", ("MassPropertiesGPU", "Mass Properties"), (made.GetXMLName(), made.GetXMLLabel()))
check_true("with the hints of the filter", made.GetHints().FindNestedElementByName("HighlightRows") is not None)

# The errors of classes about values that they refuse: ParaView shows them in its messages.
refusals = []


def refuse(instance, element):
    """Gives the property values that are not numbers, and a direction of length 0."""
    def note(_caller, _event, text):
        refusals.append(re.sub(r"^ERROR: In .*, line \d+\n\w+ \(0x[0-9a-f]+\): ", "", text).strip())

    note.CallDataType = "string0"
    tag = instance.AddObserver("ErrorEvent", note)
    count = int(element.get("number_of_elements") or element.get("number_of_elements_per_command"))
    for value in (math.nan, 0.0, -1.0):
        try:
            getattr(instance, element.get("command"))(*[value] * count)
        except (TypeError, ValueError):  # of another type
            pass
    instance.RemoveObserver(tag)


for group, proxy_name, label, module, class_name in PROXIES:
    # A module that is switched off has no proxy.
    built = importlib.util.find_spec("solidmoments." + module) is not None
    check_equal(f"{proxy_name}: in the plugin if its module is built", built, bool(manager.HasDefinition(group, proxy_name)))
    if not built:
        continue
    instance = getattr(importlib.import_module("solidmoments." + module), class_name)()
    source = DEFINITIONS[group, proxy_name]
    proxy = manager.NewProxy(group, proxy_name)
    check_equal(f"{proxy_name}: class", class_name, source.get("class"))
    check_equal(f"{proxy_name}: label", label, proxy.GetXMLLabel())
    hierarchy = collect_hierarchy(source)
    properties = [each for element in hierarchy for each in element
                  if each.tag.endswith(("VectorProperty", "TableProperty")) and each.get("information_only") != "1"]
    check_equal(f"{proxy_name}: every property of the XML", set(), {each.get("name") for each in properties if not
                                                                   proxy.GetProperty(each.get("name"))})
    if group == "filters":
        menu = source.find("Hints/ShowInMenu")
        check_true(f"{proxy_name}: in a menu of its own", menu.get("icon") and menu.get("category") == (
            "Mass Properties, Paper Schemes" if proxy_name == "SchemeMassProperties" else "Mass Properties"))
        # The menu of ParaView 5.11 gives no reason for a filter that it disables.
        check_true(f"{proxy_name}: says what it requires", "Requires STEP solids" in proxy.GetDocumentation().GetShortHelp(),
                   proxy.GetDocumentation().GetShortHelp())
        check_true(f"{proxy_name}: says which inputs it takes", all(word in proxy.GetProperty("Input").GetDocumentation().GetDescription()
                                                                    for word in ("STEP Reader", "NURBS Transform", "NURBS Deform")))
    grouped = [each.get("name") for element in hierarchy for group_element in element.findall("PropertyGroup")
               for each in group_element.findall("Property")]
    check_true("groups name properties", set(grouped) <= {element.get("name") for element in properties} | {"Input"}, str(grouped))
    check_true("properties", len(properties) >= 2, str(len(properties)))
    for element in properties:
        name = element.get("name")
        if element.tag == "DoubleVectorProperty":
            refuse(getattr(importlib.import_module("solidmoments." + module), class_name)(), element)
        documentation = " ".join((element.findtext("Documentation") or "").split())
        check_true(f"{name} is documented with its default", len(documentation) > 20 and "efault" in documentation)
        if name == "FileName" or not element.get("command"):  # without a command it is the client's only
            continue
        if element.get("repeat_command"):
            check_equal(f"{name}: empty", 0, proxy.GetProperty(name).GetNumberOfElements())
            check_true(f"{name}: commands", all(hasattr(instance, element.get(command)) for command in ("command", "clean_command")))
            continue
        actual = getattr(instance, "Get" + name)()
        smproperty = proxy.GetProperty(name)
        if isinstance(actual, tuple):
            values = tuple(smproperty.GetElement(i) for i in range(smproperty.GetNumberOfElements()))
            check_equal(f"{name}: the proxy's defaults are the class's", actual, values)
            continue
        value = smproperty.GetElement(0)
        # ParaView asks for arrays and sizes before it draws.
        expected = {"DisplayMesh": 1, "CoarseAbove": 5000000}.get(name, type(value)(actual))
        check_equal(f"{name}: the proxy's default is the class's", expected, value)
        limits = element.find("DoubleRangeDomain[@min]")
        whole = element.find("IntRangeDomain")
        for limit, step in (("min", -1), ("max", 1)) if whole is not None else ():
            getattr(instance, "Set" + name)(int(whole.get(limit)) + step)
            check_equal(f"{name}: the class clamps at {limit}", int(whole.get(limit)), getattr(instance, "Get" + name)())
        for limit in ("min", "max") if limits is not None else ():
            if limits.get(limit) is None:
                continue
            bound = float(limits.get(limit))
            # A little outside: what makes no sense at all (0, negative) may mean the default instead.
            outside = (bound / 2 if limit == "min" else bound * 2) if bound > 0 else bound + (-1 if limit == "min" else 1)
            getattr(instance, "Set" + name)(outside)
            check_equal(f"{name}: the class clamps at {limit}", bound, getattr(instance, "Get" + name)())
        # Above a maximum, ParaView 5.11 calls values valid where there is a minimum too, in its own sources
        # as well.
        if limits is not None:
            smproperty.SetUncheckedElement(0, 0.0 if float(limits.get("min")) > 0.0 else -1.0)
            check_equal(f"{name}: the domain refuses less than its minimum", 0, smproperty.IsInDomains())
            smproperty.ClearUncheckedElements()

# No text of the GUI names a class or a method, the device in a name, or a word that the project has replaced
# by the field's own.
UNWANTED = re.compile(r"\bvtk[A-Z]|\b(?-i:([GS]et|Add)[A-Z]\w*)|\(GPU\)|\b(leak|plumb|sanity|turned|hush|remark|outcome|deflection|glyph|isolated|cache|partitioned dataset|shaders?)\b|what comes out|does it stand",
                      re.IGNORECASE)
check_true("the pattern finds what it seeks", all(UNWANTED.search(text) for text in ("Mass Properties (GPU)", "see GetMessage()", "Turned", "Glyph Scale")))
count = 0
for path in sorted(glob.glob(os.path.join(folder, "*.xml"))):
    for element in ElementTree.parse(path).iter():
        texts = [element.get(key) or "" for key in ("label", "short_help", "long_help", "text")]
        texts += [element.text or ""] if element.tag == "Documentation" else []
        for text in filter(None, texts):
            count += 1
            found = UNWANTED.search(text)
            if found:
                check_true(f"{os.path.basename(path)}: no '{found.group()}'", False, " ".join(text.split()))
check_true("texts of the GUI", count > 100, str(count))
for text in sorted(set(refusals)):
    check_true("a refusal names no class or method, and the remedy", not UNWANTED.search(text) and ": give " in text, text)
check_true("refusals", len(set(refusals)) > 8, str(len(set(refusals))))
finish()

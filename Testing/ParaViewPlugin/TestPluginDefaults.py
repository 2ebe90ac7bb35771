"""TestPluginDefaults.py PLUGIN.so: what the XML says about a property is what the C++ class does, and says it in full."""
import os
import sys
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check_equal, check_true, finish  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

from solidmoments.smFiltersMassProperties import (  # noqa: E402
    vtkMassPropertiesGPU, vtkSolidStability, vtkSurfaceIntegralGPU)
from solidmoments.smFiltersNURBS import vtkNURBSDeform, vtkNURBSTransform  # noqa: E402
from solidmoments.smReadersSTEP import vtkSTEPReader, vtkSTEPWriter  # noqa: E402

simple.LoadPlugin(sys.argv[1], ns=globals())
# No function of simple makes a writer: SaveData looks for one.
writer = type("Writer", (), {"SMProxy": servermanager.ProxyManager().NewProxy("writers", "STEPWriter")})
folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "ParaViewPlugin", "SolidMoments")


def find_proxies(file, matches):
    """Proxies of a file that match, whatever group they are in."""
    root = ElementTree.parse(os.path.join(folder, file)).getroot()
    return [(group.get("name"), element) for group in root for element in group if matches(group, element)]


def collect_properties(file, source):
    """The properties of a proxy, those of the one it is derived from first."""
    base = source.get("base_proxyname")
    inherited = [] if not base else collect_properties(file, find_proxies(
        file, lambda group, element: group.get("name") == source.get("base_proxygroup") and element.get("name") == base)[0][1])
    return inherited + [element for element in source if element.tag.endswith("VectorProperty")]


for file, instance, proxy in (("readers.xml", vtkSTEPReader(), STEPReader()),  # noqa: F821
                              ("writers.xml", vtkSTEPWriter(), writer),
                              ("filters.xml", vtkMassPropertiesGPU(), MassPropertiesGPU()),  # noqa: F821
                              ("filters.xml", vtkSurfaceIntegralGPU(), SurfaceIntegralGPU()),  # noqa: F821
                              ("filters.xml", vtkNURBSTransform(), NURBSTransform()),  # noqa: F821
                              ("filters.xml", vtkNURBSDeform(), NURBSDeform()),  # noqa: F821
                              ("stability.xml", vtkSolidStability(), SolidStability())):  # noqa: F821
    sources = find_proxies(file, lambda group, element: group.get("name") in ("sources", "filters", "writers") and
                           element.get("class") == instance.GetClassName())
    check_equal("proxies of the class " + instance.GetClassName(), 1, len(sources))
    group, source = sources[0]
    check_true("in a menu of its own, or a reader or writer", group in ("sources", "writers") or
               source.find("Hints/ShowInMenu").get("category") == "Mass Properties" and source.find("Hints/ShowInMenu").get("icon"))
    properties = collect_properties(file, source)
    # Every property has its place in a group, or is one of the few at the top.
    base = [] if not source.get("base_proxyname") else [element for _, element in find_proxies(
        file, lambda group, element: element.get("name") == source.get("base_proxyname"))]
    grouped = [each.get("name") for element in base + [source] for group in element.findall("PropertyGroup")
               for each in group.findall("Property")]
    check_true("groups name properties", set(grouped) <= {element.get("name") for element in properties} | {"Input"}, str(grouped))
    check_true("properties", len(properties) >= 2, str(len(properties)))
    for element in properties:
        name = element.get("name")
        documentation = " ".join((element.findtext("Documentation") or "").split())
        check_true(f"{name} is documented with its default", len(documentation) > 20 and "efault" in documentation)
        if name == "FileName":
            continue
        if element.get("repeat_command"):
            check_equal(f"{name}: empty", 0, proxy.SMProxy.GetProperty(name).GetNumberOfElements())
            check_true(f"{name}: commands", all(hasattr(instance, element.get(command))
                                                for command in ("command", "clean_command")))
            continue
        actual = getattr(instance, "Get" + name)()
        smproperty = proxy.SMProxy.GetProperty(name)
        if isinstance(actual, tuple):
            values = tuple(smproperty.GetElement(i) for i in range(smproperty.GetNumberOfElements()))
            check_equal(f"{name}: the proxy's defaults are the class's", actual, values)
            continue
        value = smproperty.GetElement(0)
        check_equal(f"{name}: the proxy's default is the class's", type(value)(actual), value)
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
        # Above a maximum, ParaView 5.11 calls values valid where there is a minimum too, in its own sources as well.
        if limits is not None:
            smproperty.SetUncheckedElement(0, 0.0 if float(limits.get("min")) > 0.0 else -1.0)
            check_equal(f"{name}: the domain refuses less than its minimum", 0, smproperty.IsInDomains())
            smproperty.ClearUncheckedElements()
finish()

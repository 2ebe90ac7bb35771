"""TestPluginInstances.py PLUGIN.so FOLDER: single instances of parts with one name, in both trees, for every filter with Selectors, and their names.

The product is machine = 2 x arm + base + a-b + ab; arm = 2 x nut + rod. Names of nodes that VTK makes of "a-b" and "ab" are equal.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check, check_equal, check_true, finish  # noqa: E402
from smproduct import Assembly, Part, write_product  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

plugin, folder = sys.argv[1:3]
simple.LoadPlugin(plugin, remote=False, ns=globals())
NUT, ROD, BASE, FIRST, SECOND = 8.0, 27.0, 1000.0, 64.0, 125.0
nut, rod, base = Part("nut", [((0, 0, 0), (2, 2, 2))], "7.85", "g/cm^3"), Part("rod", [((0, 0, 0), (3, 3, 3))]), Part("base", [((0, 0, 0), (10, 10, 10))])
first, second = Part("a-b", [((0, 0, 0), (4, 4, 4))]), Part("ab", [((0, 0, 0), (5, 5, 5))])
arm = Assembly("arm", [(nut, (0, 0, 0), None), (nut, (5, 0, 0), None), (rod, (10, 0, 0), None)])
machine = Assembly("machine", [(arm, (0, 20, 0), None), (arm, (0, 30, 0), None), (base, (0, 0, 0), None), (first, (30, 0, 0), None),
                               (second, (40, 0, 0), None)])
path = os.path.join(folder, "instances.step")
write_product(path, machine)
reader = simple.OpenDataFile(path)
reader.UpdatePipeline()
tree = reader.GetDataInformation().GetDataAssembly()
blocks = reader.GetDataInformation().GetHierarchy()


def list_paths(assembly):
    """Node names from the root, of all nodes with datasets, by the numbers of these."""
    return [assembly.GetNodePath(node) for node in assembly.GetChildNodes(0, True) if assembly.GetDataSetIndices(node, False)]


def get_labels(assembly, parent):
    return [assembly.GetAttributeOrDefault(node, "label", "") for node in assembly.GetChildNodes(parent, False)]


top = tree.GetChildNodes(0, False)[0]
check_equal("labels of siblings", ["arm (1)", "arm (2)", "base", "a-b (1)", "ab (2)"], get_labels(tree, top))
check_equal("labels of nuts", ["nut (1)", "nut (2)", "rod"], get_labels(tree, tree.GetChildNodes(top, False)[1]))
check_equal("the name in the file with it", "nut",
            tree.GetAttributeOrDefault(tree.GetChildNodes(tree.GetChildNodes(top, False)[1], False)[1], "name", ""))
check_equal("labels of blocks", ["nut (1)", "nut (2)", "rod (1)", "nut (3)", "nut (4)", "rod (2)", "base", "a-b (1)", "ab (2)"], get_labels(blocks, 0))
for name, assembly in (("Assembly", tree), ("Hierarchy", blocks)):
    paths = list_paths(assembly)
    check_equal(f"{name}: paths", (9, 9), (len(paths), len(set(paths))))

VOLUMES = [NUT, NUT, ROD, NUT, NUT, ROD, BASE, FIRST, SECOND]
MAKERS = [(name, arguments, array) for name, arguments, array in (
    ("MassProperties", {}, "Volume"), ("MassPropertiesbyPaperSchemes", {}, "Volume"), ("SurfaceIntegral", {"MomentDegree": 0}, None),
    ("Buoyancy", {"Point": [0.0, 0.0, 100.0]}, "DisplacedVolume"), ("Section", {"Point": [0.0, 0.0, 100.0]}, "VolumeBelow"))
    if name in globals()]
check_true("filters with Selectors", len(MAKERS) >= 2 and MAKERS[0][0] == "MassProperties", str([maker[0] for maker in MAKERS]))


def list_solids(filter):
    table = servermanager.Fetch(filter, idx=1)
    return [table.GetValueByName(row, "Path").ToString() for row in range(table.GetNumberOfRows())]


PATHS = ["arm (1)/nut (1)", "arm (1)/nut (2)", "arm (1)/rod", "arm (2)/nut (1)", "arm (2)/nut (2)", "arm (2)/rod", "base", "a-b (1)", "ab (2)"]
for name, arguments, array in MAKERS:
    make = globals()[name]
    everything = make(Input=reader, **arguments)
    check_equal(f"{name}: paths of all", PATHS, list_solids(everything))
    for assembly_name, assembly in (("Assembly", tree), ("Hierarchy", blocks)) if name == "MassProperties" else (("Assembly", tree),):
        for i, node_path in enumerate(list_paths(assembly)):
            one = make(Input=reader, Assembly=assembly_name, Selectors=[node_path], **arguments)
            check_equal(f"{name}, {node_path}: one solid", [PATHS[i]], list_solids(one))
            if array and name != "MassPropertiesbyPaperSchemes":
                fields = servermanager.Fetch(one, idx=0).GetFieldData()
                check(f"{name}, {node_path}: its {array}", VOLUMES[i], fields.GetArray(array).GetValue(0), 1e-9 * VOLUMES[i])
            simple.Delete(one)
    simple.Delete(everything)

# Names of the file in selectors keep their meaning: all instances.
for assembly_name, selector, expected in (
        ("Assembly", "/STEP/machine/arm", [0, 1, 2, 3, 4, 5]), ("Assembly", "/STEP/machine/arm/nut", [0, 1, 3, 4]), ("Assembly", "//nut", [0, 1, 3, 4]),
        ("Assembly", "/STEP/machine/arm[2]/nut[1]", [3]), ("Assembly", "//rod", [2, 5]), ("Assembly", "/STEP/machine/ab", [7, 8]),
        ("Assembly", "//base", [6]), ("Hierarchy", "/Root/nut", [0, 1, 3, 4]), ("Hierarchy", "/Root/ab", [7, 8]), ("Hierarchy", "//rod", [2, 5])):
    mass = MassProperties(Input=reader, Assembly=assembly_name, Selectors=[selector])  # noqa: F821
    check_equal(f"{assembly_name}, {selector}: as before", [PATHS[i] for i in expected], list_solids(mass))
    simple.Delete(mass)

# What the bodies of a filter are called, and a second filter behind it.
mass = MassProperties(Input=reader, Selectors=[list_paths(tree)[4]])  # noqa: F821
mass.UpdatePipeline()
bodies = servermanager.OutputPort(mass, 5)
check_equal("a block keeps its name", ["nut (4)"], get_labels(bodies.GetDataInformation().GetHierarchy(), 0))
check_equal("and its path", [PATHS[4]], list_solids(MassProperties(Input=bodies)))  # noqa: F821

# ParaView's own extraction takes one.
for assembly_name, assembly in (("Assembly", tree), ("Hierarchy", blocks)):
    extracted = simple.ExtractBlock(Input=reader, Assembly=assembly_name, Selectors=[list_paths(assembly)[1]])
    check_equal(f"Extract Block, {assembly_name}", [PATHS[1]], list_solids(MassProperties(Input=extracted)))  # noqa: F821

# Names of the file elsewhere: materials, the parts list, files that are saved.
mass = MassProperties(Input=reader, Materials=["nut", "steel", ""])  # noqa: F821
solids, parts = servermanager.Fetch(mass, idx=1), servermanager.Fetch(mass, idx=7)
names = [solids.GetValueByName(row, "Name").ToString() for row in range(9)]
check_equal("names of solids", ["nut", "nut", "rod", "nut", "nut", "rod", "base", "a-b", "ab"], names)
check_equal("materials by name", ["steel" if name == "nut" else "" for name in names],
            [solids.GetValueByName(row, "Material").ToString() for row in range(9)])
listed = [(parts.GetValueByName(row, "Name").ToString().strip(), parts.GetValueByName(row, "CountInAll").ToInt()) for row in range(parts.GetNumberOfRows())]
check_true("the parts list", ("nut", 4) in listed and ("arm", 2) in listed and not [name for name, _ in listed if "(" in name], str(listed))
saved = os.path.join(folder, "instances_saved.step")
simple.SaveData(saved, proxy=reader)
again = simple.OpenDataFile(saved)
check_equal("saved and read again", PATHS, list_solids(MassProperties(Input=again)))  # noqa: F821
finish()

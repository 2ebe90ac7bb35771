"""TestPluginTables.py PLUGIN.so STEP OUTPUT: the order of the spreadsheet's columns; other tables are shown as ParaView does."""
import csv
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Support"))
from smcheck import check_equal, check_true, finish  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

plugin, part, output = sys.argv[1:4]
manager = servermanager.ProxyManager()


def describe_view():
    """Names and default values of the properties of the spreadsheet view."""
    proxy = manager.NewProxy("views", "SpreadSheetView")
    properties = {}
    iterator = proxy.NewPropertyIterator()
    iterator.Begin()
    while not iterator.IsAtEnd():
        each = iterator.GetProperty()
        count = each.GetNumberOfElements() if hasattr(each, "GetNumberOfElements") else 0
        properties[iterator.GetKey()] = (each.GetClassName(), [each.GetElement(i) for i in range(count)], each.GetPanelVisibility())
        iterator.Next()
    return proxy.GetXMLLabel(), proxy.GetXMLName(), properties


before = describe_view()
check_true("ParaView's own view has its properties", len(before[2]) > 8, str(len(before[2])))
simple.LoadPlugin(plugin, ns=globals())
after = describe_view()
check_equal("label and name", before[:2], after[:2])
check_equal("properties", sorted(before[2]), sorted(after[2]))
for name, value in before[2].items():
    check_equal(name, value, after[2].get(name))

sheet = simple.CreateView("SpreadSheetView")


def show(source, port, association):
    """The view on the client, and the columns that a user sees."""
    for shown in list(sheet.Representations):
        shown.Visibility = 0
    simple.Show(servermanager.OutputPort(source, port), sheet)
    sheet.FieldAssociation = association
    simple.Render(sheet)
    client = sheet.SMProxy.GetClientSideObject()
    count = client.GetNumberOfColumns()
    return client, [client.GetColumnName(i) for i in range(count) if client.GetColumnVisibility(i)]


reader = simple.OpenDataFile(part)
mass = MassProperties(Input=reader, Density=7850.0)  # noqa: F821
client, columns = show(mass, 1, "Row Data")
check_equal("solids: first columns", [
    "vtkOriginalIndices", "Name", "Path", "Id", "Status", "Volume", "VolumeBound", "Mass", "MassBound", "Density", "Material", "SurfaceArea",
    "SurfaceAreaBound", "CenterOfMass_0", "CenterOfMass_1", "CenterOfMass_2", "CenterOfMassBound"], columns[:17])
check_equal("solids: no magnitudes", [], [name for name in columns if name.endswith("_Magnitude")])
table = servermanager.Fetch(mass, idx=1)
flat = sorted(name for i in range(table.GetNumberOfColumns()) for name in (
    [table.GetColumnName(i)] if table.GetColumn(i).GetNumberOfComponents() == 1 else
    [f"{table.GetColumnName(i)}_{k}" for k in range(table.GetColumn(i).GetNumberOfComponents())]))
check_equal("solids: every column once", ["vtkOriginalIndices"] + flat, sorted(columns, key=lambda name: (name[0] != "v", name)))
labels = {client.GetColumnName(i): client.GetColumnLabel(i) for i in range(client.GetNumberOfColumns())}
for name, label in (("Volume", "Volume (mm^3)"), ("VolumeBound", "VolumeBound (mm^3)"), ("Mass", "Mass (kg)"), ("Name", "Name"),
                    ("Density", "Density (kg/m^3)")):
    check_equal(f"solids: header of {name}", label, labels[name])
check_true("solids: header of a component", labels["CenterOfMass_0"].endswith(" (mm)") and labels["MassInertia_4"].endswith(" (kg mm^2)"),
           labels["CenterOfMass_0"] + labels["MassInertia_4"])
# Values by index and by name agree.
for index in range(client.GetNumberOfColumns()):
    name = client.GetColumnName(index)
    by_index, by_name = client.GetValue(0, index).ToString(), client.GetValueByName(0, name).ToString()
    if by_index != by_name or not client.IsDataValid(0, index):
        check_equal(f"solids: the value of {name}", by_name, by_index)
for name in ("Volume", "Mass", "Name"):
    index = [client.GetColumnName(i) for i in range(client.GetNumberOfColumns())].index(name)
    exact, seen = table.GetValueByName(0, name), client.GetValue(0, index).ToString()
    check_equal(f"solids: {name}", exact.ToDouble() if exact.IsNumeric() else exact.ToString(), float(seen) if exact.IsNumeric() else seen)

path = os.path.join(output, "PluginTables.csv")
simple.ExportView(path, view=sheet)
with open(path, encoding="utf-8") as file:
    rows = list(csv.reader(file))
check_equal("export: first columns", ["Row ID", "Name", "Path", "Id", "Status", "Volume", "VolumeBound", "Mass"], rows[0][:8])
check_equal("export: no magnitudes", 0, sum(name.endswith("_Magnitude") for name in rows[0]))
check_equal("export: values", ["ok"] + [table.GetValueByName(0, name).ToDouble() for name in ("Volume", "VolumeBound", "Mass")],
            rows[1][4:5] + [float(value) for value in rows[1][5:8]])

# What Save Data writes: all digits, units in the headings.
saved = os.path.join(output, "PluginTables_saved.csv")
for port, expected in ((1, ["Name", "Path", "Id", "Status", "Volume (mm^3)", "VolumeBound (mm^3)"]),
                       (3, ["Solid", "Name", "Id", "FaceIndex", "FaceId", "Volume (mm^3)", "VolumeBound (mm^3)", "SurfaceArea (mm^2)"])):
    simple.SaveData(saved, proxy=servermanager.OutputPort(mass, port))
    with open(saved, encoding="utf-8") as file:
        rows = list(csv.reader(file))
    check_equal(f"saved table of port {port}: headings", expected, rows[0][:len(expected)])
    table = servermanager.Fetch(mass, idx=port)
    check_equal(f"saved table of port {port}: the same bits", table.GetValueByName(0, "Volume").ToDouble(), float(rows[1][expected.index("Volume (mm^3)")]))
    check_equal(f"saved table of port {port}: rows", table.GetNumberOfRows(), len(rows) - 1)

check_equal("faces", ["vtkOriginalIndices", "Solid", "FaceIndex", "FaceId", "Name", "Id", "Volume", "VolumeBound", "SurfaceArea", "SurfaceAreaBound",
                      "LengthUnit", "MaxGap", "BoundsEstimated"], show(mass, 3, "Row Data")[1])
# ParaView fits the widths of columns when their number has changed: not before it has the columns.
numbers = []
observer = client.AddObserver("UpdateEvent", lambda *_: numbers.append(client.GetNumberOfColumns()))
client, columns = show(mass, 7, "Row Data")
check_true("widths: no columns while other ones are fetched, then all", numbers[0] == 0 and client.GetNumberOfColumns() >= len(columns) > 16, str(numbers))
numbers.clear()
client.ClearCache()
count = client.GetNumberOfColumns()
check_true("widths: all columns while the same are fetched again", numbers and set(numbers) == {count} and count >= len(columns), str(numbers))
client.RemoveObserver(observer)
check_equal("parts", ["vtkOriginalIndices", "Name", "Status", "Kind", "Count", "CountInAll", "Volume", "VolumeBound", "Mass", "MassBound", "MassInAll",
                      "MassInAllBound", "Density", "Material", "SurfaceArea", "SurfaceAreaBound"], columns[:16])
labels = {client.GetColumnName(i): client.GetColumnLabel(i) for i in range(client.GetNumberOfColumns())}
check_equal("parts: headers", ("Volume (mm^3)", "MassInAll (kg)"), (labels["Volume"], labels["MassInAll"]))
client, columns = show(mass, 4, "Row Data")
check_equal("edges", ["vtkOriginalIndices", "Solid", "EdgeIndex", "EdgeId", "Name", "Id", "LengthUnit", "Uses", "Open", "MaxGap", "GapArea", "GapSquared", "ClosureSpread"], columns)
# Rows that are sorted by a column stay so.
sheet.ColumnToSort, sheet.InvertOrder = "EdgeId", 1
simple.Render(sheet)
client.ClearCache()  # ParaView 5.13 shows the rows that it has until the data change
place = [client.GetColumnName(i) for i in range(client.GetNumberOfColumns())].index("EdgeId")
ids = [client.GetValue(row, place).ToInt() for row in range(client.GetNumberOfRows())]
check_true("edges: sorted by a column", len(set(ids)) > 5 and ids in (sorted(ids), sorted(ids, reverse=True)), str(ids[:9]))
sheet.ColumnToSort = ""
if manager.SMProxyManager.HasDefinition("filters", "SolidStability"):
    standing = StaticStability(Input=reader)  # noqa: F821
    check_equal("stability", ["vtkOriginalIndices", "Name", "Id", "Status", "Stability", "Support", "DecidedBy", "StabilityMargin",
                              "StabilityMarginBound"], show(standing, 1, "Row Data")[1][:9])
if manager.SMProxyManager.HasDefinition("filters", "Buoyancy"):
    afloat = Buoyancy(Input=reader, Point=[0.0, 0.0, 5.0])  # noqa: F821
    check_equal("buoyancy", ["vtkOriginalIndices", "Name", "Path", "Id", "Status", "DisplacedVolume", "DisplacedVolumeBound", "CenterOfBuoyancy_0",
                             "CenterOfBuoyancy_1", "CenterOfBuoyancy_2", "CenterOfBuoyancyBound", "DisplacedFirstMoments_0"],
                show(afloat, 1, "Row Data")[1][:12])
if manager.SMProxyManager.HasDefinition("filters", "SolidSection"):
    cut = Section(Input=reader, Point=[0.0, 0.0, 5.0])  # noqa: F821
    check_equal("section", ["vtkOriginalIndices", "Name", "Path", "Id", "Status", "SectionArea", "SectionAreaBound", "SectionCentroid_0",
                            "SectionCentroid_1", "SectionCentroid_2", "SectionCentroidBound", "SectionPrincipalMoments_0"],
                show(cut, 1, "Row Data")[1][:12])
integral = SurfaceIntegral(Input=reader, BendingEnergy=1, MomentDegree=0, Integrands="a = dA")  # noqa: F821
check_equal("integrals", ["vtkOriginalIndices", "Name", "Path", "Id", "Status", "BendingEnergy", "BendingEnergyBound", "a", "aBound",
                          "moment_0_0_0", "moment_0_0_0Bound", "LengthUnit"], show(integral, 1, "Row Data")[1][:12])

# A table of another origin.
sphere = simple.Sphere()
named = simple.Calculator(Input=sphere, ResultArrayName="Volume", Function="coordsX")
check_equal("another table: as ParaView shows it", ["vtkOriginalIndices", "Normals_0", "Normals_1", "Normals_2", "Normals_Magnitude", "Points_0",
                                                 "Points_1", "Points_2", "Points_Magnitude", "Volume"], show(named, 0, "Point Data")[1])
finish()

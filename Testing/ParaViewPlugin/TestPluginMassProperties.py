"""TestPluginMassProperties.py PLUGIN.so FOLDER: values of Mass Properties for a STEP file in ParaView's pipeline."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check, check_equal, check_true, check_values, finish  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

plugin, folder = sys.argv[1:3]
simple.LoadPlugin(plugin, ns=globals())
manifest = Manifest(folder)


def numbers(data, name):
    array = data.GetFieldData().GetArray(name)
    return [array.GetComponent(0, i) for i in range(array.GetNumberOfComponents())] if array else []


def text(data, name):
    array = data.GetFieldData().GetAbstractArray(name)
    return array.GetValue(0) if array else None


part = manifest.solid("slanted_hole", "moved")
reader = simple.OpenDataFile(part["path"])
check_equal("OpenDataFile chooses our reader", "STEPReader", reader.GetXMLName())
mass = MassProperties(Input=reader, Device="OpenGL")  # noqa: F821
view = simple.CreateRenderView()
simple.Show(reader, view)
display = simple.Show(servermanager.OutputPort(mass, 0), view)
simple.Show(servermanager.OutputPort(mass, 2), view)
simple.Render(view)
check_true("the input stays visible", simple.GetRepresentation(reader, view).Visibility == 1)

# ParaView 5.11 fetches a collection as empty; the glyph and the tables are plain data.
glyph = servermanager.Fetch(mass, idx=0)
check_equal("status", "ok", text(glyph, "Status"))
check_equal("backend", "opengl", text(glyph, "Backend"))
inertia = numbers(glyph, "VolumeInertia")
check_values(part, numbers(glyph, "Volume")[0], numbers(glyph, "SurfaceArea")[0], numbers(glyph, "CenterOfMass"),
             [inertia[0:3], inertia[3:6], inertia[6:9]])
check_true("volume bound", 0 < numbers(glyph, "VolumeBound")[0] <= 1e-9 * part["volume"])
check_true("the glyph has points", glyph.GetNumberOfPoints() > 10, str(glyph.GetNumberOfPoints()))
bounds = glyph.GetBounds()
for axis in range(3):
    # The tessellated sphere is symmetric to a few percent of its radius of 0.02 diagonals.
    check(f"the glyph is at the centre, axis {axis}", part["center_of_mass"][axis],
          (bounds[2 * axis] + bounds[2 * axis + 1]) / 2, 1e-3 * part["size"])

table = servermanager.Fetch(mass, idx=1)
check_equal("rows of the table", 1, table.GetNumberOfRows())
check("volume in the table", numbers(glyph, "Volume")[0], table.GetValueByName(0, "Volume").ToDouble(), 0.0)
summary = servermanager.Fetch(mass, idx=2)
check_true("summary", summary.GetNumberOfRows() == 1 and "olume" in summary.GetValueByName(0, "Text").ToString(),
           summary.GetValueByName(0, "Text").ToString())
faces = servermanager.Fetch(mass, idx=3)
check_equal("rows of faces", 7, faces.GetNumberOfRows())
edges = servermanager.Fetch(mass, idx=4)
check_true("a row for every edge", edges.GetNumberOfRows() >= 12 and edges.GetColumnByName("MaxGap") is not None,
           str(edges.GetNumberOfRows()))

# A property reaches the filter.
mass.Density = 1000.0
glyph = servermanager.Fetch(mass, idx=0)
check("mass of water, kg", part["volume"] * 1e-9 * 1000.0, numbers(glyph, "Mass")[0], 1e-9 * part["volume"] * 1e-6)
reader.OutputUnit = "cm"
glyph = servermanager.Fetch(mass, idx=0)
check("volume in cm^3", part["volume"] * 1e-3, numbers(glyph, "Volume")[0], 1e-12 * part["volume"])
check_equal("unit", "cm", text(glyph, "LengthUnit"))

# Another file in the same reader.
sphere = manifest.solid("sphere")
reader.OutputUnit = "mm"
reader.FileName = sphere["path"]
glyph = servermanager.Fetch(mass, idx=0)
check("volume of the sphere", sphere["volume"], numbers(glyph, "Volume")[0], 1e-9 * sphere["volume"])

# An assembly of 500 instances passes ParaView's composite copies, bounds and geometry filter.
assembly = manifest.special("assembly")
many = MassProperties(Input=simple.OpenDataFile(assembly["path"]))  # noqa: F821
glyph = servermanager.Fetch(many, idx=0)
check("volume of the assembly", assembly["volume"], numbers(glyph, "Volume")[0], 1e-9 * assembly["volume"])
check_equal("rows of the assembly, without a total", 500, servermanager.Fetch(many, idx=1).GetNumberOfRows())
finish()

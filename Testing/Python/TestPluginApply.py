"""TestPluginApply.py PLUGIN.so FILE.step: what the GUI's Apply shows: sphere and summary in the render view, no table by itself."""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from smcheck import check_equal, check_true, finish  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

plugin, path = sys.argv[1:3]
simple.LoadPlugin(plugin, ns=globals())
reader = simple.OpenDataFile(path)
view = simple.CreateRenderView()
simple.Show(reader, view)
mass = MassPropertiesGPU(Input=reader)  # noqa: F821

# pqApplyBehavior::showData: every port is shown in the view that its hints prefer, and a view is made if there is none.
controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
source = mass.SMProxy
names = ["Center of Mass", "Solids", "Summary", "Faces", "Edges"]
check_equal("ports", names, [source.GetOutputPortName(port) for port in range(source.GetNumberOfOutputPorts())])
for port, expected in enumerate(("GeometryRepresentation", None, "TextSourceRepresentation", None)):
    shown = controller.ShowInPreferredView(source, port, view.SMProxy)
    check_equal(f"{names[port]}: shown", expected is not None, shown is not None)
    representation = view.SMProxy.FindRepresentation(source, port)
    check_equal(f"{names[port]}: representation in the render view", expected,
                representation.GetXMLName() if representation else None)
check_equal("views", ["RenderView"], [each.GetXMLName() for each in simple.GetViews()])
hint = source.GetHints().FindNestedElementByName("Visibility")
check_true("the input stays visible", hint is not None and hint.GetAttribute("replace_input") == "0")
simple.Render(view)

# A table that the user asks for does open.
sheet = simple.CreateView("SpreadSheetView")
for port in (1, 3):
    check_true(f"{names[port]}: opens in a spreadsheet", sheet.SMProxy.CanDisplayData(source, port)
               and controller.Show(source, port, sheet.SMProxy) is not None)
finish()

"""show_ports.py PLUGIN OUT.json PORT FILE FILTER...: shows and draws every port of filters of exact solids, one after another, as a user clicks eyes.

Writes what was drawn for each filter and port. With PORT > 0 the pipeline is on the pvserver that listens there.
"""
import json
import sys

from paraview import servermanager, simple

plugin, path, port, file = sys.argv[1:5]
if int(port) > 0:
    simple.Connect("localhost", int(port))
    simple.LoadPlugin(plugin, remote=False, ns=globals())
simple.LoadPlugin(plugin, remote=True, ns=globals())
view = simple.CreateRenderView(ViewSize=[300, 200])
reader = simple.OpenDataFile(file)
reader.UpdatePipeline()
shown = {}
for name in sys.argv[5:]:
    filter = globals()[name](Input=reader)
    filter.UpdatePipeline()
    for i in range(filter.SMProxy.GetNumberOfOutputPorts()):
        output = servermanager.OutputPort(filter, i)
        information = output.GetDataInformation()
        if information.GetDataSetTypeAsString() != "vtkTable":
            simple.Show(output, view)
            simple.Render(view)
            simple.Hide(output, view)
        shown[f"{name} {i}"] = [information.GetDataClassName(), information.GetNumberOfPoints(), information.GetNumberOfRows()]
    simple.Delete(filter)
with open(path, "w", encoding="utf-8") as out:
    json.dump(shown, out)

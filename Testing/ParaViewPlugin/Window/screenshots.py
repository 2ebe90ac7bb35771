"""Run by screenshots.sh in ParaView's window: opens SM_FILE and sets the scene SM_SCENE; then makes the file SM_READY."""
import os

from paraview import servermanager, simple
from smselection import select_rows  # of Testing/Support

scene, path, ready = (os.environ[name] for name in ("SM_SCENE", "SM_FILE", "SM_READY"))
reader = simple.OpenDataFile(path)
view = simple.GetActiveViewOrCreate("RenderView")
simple.Show(reader, view)
mass = simple.MassProperties(Input=reader, Density=7850.0)
# Shows the outputs as the Apply button does.
controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
for port in range(mass.SMProxy.GetNumberOfOutputPorts()):
    controller.ShowInPreferredView(mass.SMProxy, port, view.SMProxy)
simple.Hide(reader, view)
view.Update()
view.CameraPosition = [-1.0, -1.7, 1.1]
view.CameraFocalPoint = [0.0, 0.0, 0.0]
view.CameraViewUp = [0.0, 0.0, 1.0]
simple.ResetCamera(view)

bodies = servermanager.OutputPort(mass, 5)
shown = simple.GetRepresentation(bodies, view)
if scene == "volume":
    shown.Opacity = 1.0
    simple.ColorBy(shown, ("CELLS", "VolumeOfWholeSolid"))
    shown.RescaleTransferFunctionToDataRange(False, True)
    shown.SetScalarBarVisibility(view, True)
    simple.GetColorTransferFunction("VolumeOfWholeSolid").MapControlPointsToLogSpace()
    simple.GetColorTransferFunction("VolumeOfWholeSolid").UseLogScale = 1
    simple.SetActiveSource(mass)
elif scene in ("table", "parts"):
    layout = simple.GetLayout(view)
    layout.SplitVertical(0, 0.6)
    sheet = simple.CreateView("SpreadSheetView")
    layout.AssignView(2, sheet)
    view.Update()
    simple.Show(servermanager.OutputPort(mass, 1 if scene == "table" else 7), sheet)
    simple.SetActiveView(view)
    simple.ResetCamera(view)
    if scene == "table":
        select_rows(mass, 1, (1, 3))
    simple.SetActiveSource(mass)
elif scene == "materials":
    mass.Density = 0.0
    mass.UpdatePipeline()
    # Without the total, and the titles that are a row where the plugin has no library for Qt.
    parts = [part for part in list(mass.MaterialTable)[:-4:4] if part != "Part"]
    # All but the last part get a material or a density.
    given = (("steel", ""), ("aluminium", ""), ("brass", ""), ("", "7900"))
    mass.Materials = [cell for i, part in enumerate(parts[:-1]) for cell in (part, *given[i % 4])]
    shown.PartLabels = "Name and mass"
    simple.SetActiveSource(mass)
else:
    simple.SetActiveSource(mass)
# Zooms in, as a user does after Apply; out in the low view, where the text would cover the solids.
simple.GetActiveCamera().Zoom({"table": 0.9, "parts": 0.9, "materials": 1.0}.get(scene, 1.4))
simple.Render(view)
with open(ready, "w", encoding="utf-8") as file:
    file.write("ready\n")

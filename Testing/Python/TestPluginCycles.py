"""TestPluginCycles.py PLUGIN.so FILE.step CYCLES: opening, applying, choosing, selecting and deleting again leaves no memory behind."""
import gc
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from smcheck import check_true, finish  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

plugin, path, cycles = sys.argv[1], sys.argv[2], int(sys.argv[3])
simple.LoadPlugin(plugin, ns=globals())
controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
manager = servermanager.ProxyManager().SMProxyManager
view = simple.CreateRenderView()
view.ViewSize = [200, 150]


def get_resident():
    """Bytes of this process that are in memory."""
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


# Made once: what scripts make of these is theirs to give back.
rows = manager.NewProxy("sources", "IDSelectionSource")
rows.GetProperty("FieldType").SetElement(0, 5)  # rows
rows.GetProperty("IDs").SetNumberOfElements(2)
rows.UpdateVTKObjects()
selection = servermanager.vtkSMSelectionHelper.NewAppendSelectionsFromSelectionSource(rows)


def cycle(i):
    reader = simple.OpenDataFile(path)
    simple.Show(reader, view)
    mass = MassPropertiesGPU(Input=reader)  # noqa: F821
    for port in range(6):
        controller.ShowInPreferredView(mass.SMProxy, port, view.SMProxy)
    simple.Hide(reader, view)
    simple.Render(view)
    # The result is flagged, and is not any more; one solid is chosen, then all.
    mass.RelativeTolerance = 1e-3 if i % 2 else 1e-12
    mass.Assembly = "Hierarchy"
    mass.Selectors = ["/Root/*[@number_of_partitions][1]"]
    simple.Render(view)
    mass.Selectors = []
    simple.Render(view)
    mass.SMProxy.SetSelectionInput(1, selection, 0)
    simple.Render(view)
    mass.SMProxy.CleanSelectionInputs(1)
    mesh = servermanager.OutputPort(mass, 5).GetDataInformation().GetMemorySize()
    simple.Delete(mass)
    simple.Delete(reader)
    simple.Render(view)
    gc.collect()
    return mesh


# Caches, ParaView's own and the driver's, fill first.
warm = max(4, cycles // 4)
for i in range(warm):
    cycle(i)
before = get_resident()
for i in range(cycles):
    mesh = cycle(i)
growth = (get_resident() - before) / cycles
print(f"{before / 1e6:.1f} MB before, {growth / 1e3:.1f} kB a cycle, a mesh of {mesh} kB")
# ParaView's own growth was 190 kB a cycle in which three spheres were shown and deleted; a mesh of the sample part has 1064 kB, and as
# much again on the GPU.
check_true("growth of a cycle", growth < 200e3, f"{growth:.0f} bytes, limit 200000")
finish()

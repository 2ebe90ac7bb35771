"""TestPluginCycles.py PLUGIN.so FILE.step CYCLES [brief]: repeated opening, applying, selecting and deleting leaks no memory, OpenGL
object, thread or open file. brief: opening, applying and deleting only, for long runs. With - for PLUGIN.so the brief cycles use
ParaView's own sources, as a reference for ParaView's own growth.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check_equal, finish  # noqa: E402
from smresources import Process, check_counting, check_held, count_errors, count_objects, run_counted  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

plugin, path, cycles = sys.argv[1], sys.argv[2], int(sys.argv[3])
stock = plugin == "-"
brief = stock or "brief" in sys.argv[4:]
if not stock:
    simple.LoadPlugin(plugin, ns=globals())
controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
manager = servermanager.ProxyManager().SMProxyManager
view = simple.CreateRenderView()
view.ViewSize = [200, 150]
window = view.GetRenderWindow()

# Made once: a script does not free its selection proxies.
rows = manager.NewProxy("sources", "IDSelectionSource")
rows.GetProperty("FieldType").SetElement(0, 5)  # rows
rows.GetProperty("IDs").SetNumberOfElements(2)
rows.UpdateVTKObjects()
selection = servermanager.vtkSMSelectionHelper.NewAppendSelectionsFromSelectionSource(rows)


def open_and_apply():
    """A file and its mass properties, shown as Apply does."""
    if stock:
        reader = simple.Sphere()
        mass = simple.Shrink(Input=reader)
    else:
        reader = simple.OpenDataFile(path)
        mass = MassProperties(Input=reader)  # noqa: F821
    simple.Show(reader, view)
    for port in range(mass.SMProxy.GetNumberOfOutputPorts()):
        controller.ShowInPreferredView(mass.SMProxy, port, view.SMProxy)
    simple.Hide(reader, view)
    simple.Render(view)
    return reader, mass


def use(mass, i):
    # The result is flagged, then ok; one solid is chosen, then all.
    mass.RelativeTolerance = 1e-3 if i % 2 else 1e-12
    mass.Assembly = "Hierarchy"
    mass.Selectors = ["/Root/*[@number_of_partitions][1]"]
    simple.Render(view)
    mass.Selectors = []
    simple.Render(view)
    mass.SMProxy.SetSelectionInput(1, selection, 0)
    simple.Render(view)
    mass.SMProxy.CleanSelectionInputs(1)


def cycle(i):
    global errors
    reader, mass = open_and_apply()
    if not brief:
        use(mass, i)
    simple.Delete(mass)
    simple.Delete(reader)
    simple.Render(view)
    errors += count_errors(window)


def count():
    return Process(), count_objects(window)


# The caches of ParaView and of the driver fill first.
errors = 0
warm = max(6, min(50, cycles // 10 * 2))
for i in range(warm):
    cycle(i)
    if i % 10 == 4:
        count()
check_counting(window)
start, end, growth = run_counted(cycle, warm, cycles, count, lambda objects: f"view: {sum(objects.values())} objects")
check_equal("OpenGL errors", 0, errors)
# In brief cycles of its own sources ParaView keeps 25 to 60 kB of the heap, and takes 0.5 MB of memory at
# first and 0.1 MB after fifty; these cycles take 1 to 2 MB at first, 0.2 MB after fifty. A mesh of the sample
# part has 1 MB, and its faces 600 kB on the GPU, which with Mesa's llvmpipe is the heap too; what a driver
# maps itself shows only in memory.
check_held(start, end, growth, heap=150e3, resident=4e6)
finish()

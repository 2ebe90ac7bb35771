"""TestPluginCycles.py PLUGIN.so FILE.step CYCLES [brief]: opening, applying, choosing, selecting and deleting again leaves no memory, no OpenGL
object, no thread and no open file behind. brief: opening, applying and deleting only, for long runs. With - for PLUGIN.so the
brief cycles are of ParaView's own sources: what grows then is none of ours.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from smcheck import check_equal, check_true, finish  # noqa: E402
from smresources import Process, count_errors, count_objects, free_buffer, get_growth, make_buffer  # noqa: E402

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

# Made once: what scripts make of these is theirs to give back.
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
        mass = MassPropertiesGPU(Input=reader)  # noqa: F821
    simple.Show(reader, view)
    for port in range(mass.SMProxy.GetNumberOfOutputPorts()):
        controller.ShowInPreferredView(mass.SMProxy, port, view.SMProxy)
    simple.Hide(reader, view)
    simple.Render(view)
    return reader, mass


def use(mass, i):
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


def report(done, held):
    print(f"after {done:4} cycles: {held[0]}; view: {sum(held[1].values())} objects")
    sys.stdout.flush()


# Caches, ParaView's own and the driver's, fill first.
errors = 0
warm = max(6, min(50, cycles // 10 * 2))
for i in range(warm):
    cycle(i)
    if i % 10 == 4:
        count()
name = make_buffer(window)
more = count_objects(window)["buffers"]
free_buffer(window, name)
check_equal("an object more is seen", more - 1, count_objects(window)["buffers"])
start = count()
report(0, start)
for i in range(1, cycles + 1):
    cycle(warm + i - 1)
    if i == cycles // 2:
        middle = (i, Process())
    if i % max(10, cycles // 10) == 0 and i < cycles:
        report(i, count())
end = count()
report(cycles, end)
check_equal("OpenGL errors", 0, errors)
# VTK's timers, a pool as large as the driver is late.
check_true("queries of the view", end[1].pop("queries") <= 64)
start[1].pop("queries")
check_equal("other objects of the view", start[1], end[1])
check_equal("threads", start[0].threads, end[0].threads)
check_equal("files", start[0].files, end[0].files)
heap, resident = (get_growth(what, (0, start[0]), middle, (cycles, end[0])) for what in ("heap", "resident"))
# Of the brief cycles of its own sources ParaView keeps 30 to 60 kB of the heap, and takes 0.5 MB of memory at first and 0.1 MB after a hundred.
# A mesh of the sample part has 1 MB, and its faces 600 kB on the GPU, which with Mesa's llvmpipe is the heap too.
check_true("growth of the heap", heap <= 150e3, f"{heap:.0f} bytes a cycle, limit 150000")
check_true("growth in memory", resident <= 1.5e6, f"{resident:.0f} bytes a cycle, limit 1500000")
finish()

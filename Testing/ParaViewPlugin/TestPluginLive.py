"""TestPluginLive.py PLUGIN.so FILE OUTPUT: Section follows the plane of the view while it is dragged, without Apply, as its property Follow Plane says.

The plane's proxy sends the events of a drag here, as it does in ParaView's window. The last lines print how many
updates a second the machine does, each with a picture of 800 x 500 pixels.
"""
import gzip
import os
import statistics
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check, check_equal, check_true, finish  # noqa: E402

from paraview import servermanager, simple  # noqa: E402
from vtkmodules.vtkCommonCore import vtkSMPTools  # noqa: E402

plugin, path, output = sys.argv[1:4]
if path.endswith(".gz"):
    with gzip.open(path) as packed, open(os.path.join(output, os.path.basename(path)[:-3]), "wb") as unpacked:
        unpacked.write(packed.read())
    path = unpacked.name
simple.LoadPlugin(plugin, remote=False, ns=globals())
view = simple.CreateRenderView(ViewSize=[800, 500])
reader = simple.OpenDataFile(path)
cut = Section(Input=reader)  # noqa: F821
check_equal("what a new section does", "Where a run is fast", cut.FollowPlane)
for port in (2, 7):
    simple.Show(servermanager.OutputPort(cut, port), view)
simple.SetActiveSource(cut)


def show_plane(kind):
    """Adds a plane to the view, as ParaView's panel does: one kind or the other, by its version."""
    added = servermanager.ProxyManager().SMProxyManager.NewProxy("representations", kind)
    added.UpdateVTKObjects()
    view.SMProxy.GetProperty("HiddenRepresentations").AddProxy(added)
    view.SMProxy.UpdateVTKObjects()
    simple.Render(view)
    return added


plane = show_plane("ImplicitPlaneWidgetRepresentation")
bottom, top = reader.GetDataInformation().GetBounds()[4:6]
POINT = list(cut.Point)
runs, threads, seconds = [], [], []
cut.SMProxy.AddObserver("UpdateDataEvent", lambda *_: runs.append(time.monotonic()))
algorithm, backend = cut.SMProxy.GetClientSideObject(), vtkSMPTools.GetBackend()


def note_start(*_):
    threads.append(vtkSMPTools.GetEstimatedNumberOfThreads())
    seconds.append(-time.monotonic())


def note_end(*_):
    seconds[-1] += time.monotonic()


algorithm.AddObserver("StartEvent", note_start)
algorithm.AddObserver("EndEvent", note_end)


def get_area(section=cut):
    return servermanager.Fetch(section, idx=0).GetFieldData().GetArray("SectionArea").GetValue(0)


def place(share):
    """Moves the plane to a share of the part's height, as a step of a drag."""
    height = bottom + share * (top - bottom)
    for name, values in (("Origin", POINT[:2] + [height]), ("Normal", [0.0, 0.0, 1.0])):
        for i, value in enumerate(values):
            plane.GetProperty(name).SetElement(i, value)
    plane.InvokeEvent("InteractionEvent")
    return height


def compute_area(height):
    """By a filter of its own."""
    other = Section(Input=reader, Point=POINT[:2] + [height])  # noqa: F821
    area = get_area(other)
    simple.Delete(other)
    simple.SetActiveSource(cut)
    return area


def drag(steps):
    """Drags the plane through the part. Returns the heights."""
    del runs[:]
    plane.InvokeEvent("StartInteractionEvent")
    heights = [place(0.1 + 0.8 * step / steps) for step in range(steps)]
    plane.InvokeEvent("EndInteractionEvent")
    return heights


first = get_area()
cut.FollowPlane = "Never"
drag(3)
check_equal("Never: the section stays", (0, first, POINT), (len(runs), get_area(), list(cut.Point)))
cut.FollowPlane = "Always"
begin, busy = time.monotonic(), time.process_time()
heights = drag(20)
elapsed, busy = time.monotonic() - begin, time.process_time() - busy
check_equal("Always: a run for each step", 20, len(runs))
check("the point of the plane", heights[-1], cut.Point[2], 0.0)
area = get_area()
check("the area at the plane", compute_area(heights[-1]), area, 0.0)
check_true("which is another one", abs(area - first) > 1e-6 * first, f"{area} {first}")
median = statistics.median(seconds[-20:])
# ParaView's own loops run on one thread, if the environment does not say otherwise.
check_equal("threads of the runs", {len(os.sched_getaffinity(0))}, set(threads))
check_equal("what VTK has after them", backend, vtkSMPTools.GetBackend())
plane = show_plane("DisplaySizedImplicitPlaneWidgetRepresentation")
drag(3)
check_equal("the other kind of plane", 3, len(runs))
cut.FollowPlane = "Where a run is fast"
drag(20)
followed = len(runs)
slow = algorithm.AddObserver("StartEvent", lambda *_: time.sleep(0.2))
last = drag(4)[-1]
algorithm.RemoveObserver(slow)
check_true("runs that become slow: none, or the results are those of the last plane", not runs or cut.Point[2] == last, f"{len(runs)} runs")

# Another source is active: its plane is not this one.
simple.SetActiveSource(reader)
drag(3)
check_equal("of a filter that is not active nothing follows", 0, len(runs))
print(f"{20 / elapsed:.1f} updates a second, {busy / 20:.3f} s of all cores for each; a run {median:.3f} s; "
      f"where a run is fast: {followed} of 20 steps")
finish()

"""TestPluginLive.py PLUGIN.so FILE: Section follows the plane of the view while it is dragged, without Apply, as its property Follow Plane says.

The plane's proxy sends the events of a drag here, as it does in ParaView's window.
"""
import os
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check, check_equal, check_true, finish  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

plugin, path = sys.argv[1:3]
simple.LoadPlugin(plugin, remote=False, ns=globals())
view = simple.CreateRenderView(ViewSize=[300, 200])
reader = simple.OpenDataFile(path)
cut = Section(Input=reader)  # noqa: F821
check_equal("what a new section does", "Where a run is fast", cut.FollowPlane)
for port in (2, 7):
    simple.Show(servermanager.OutputPort(cut, port), view)
simple.SetActiveSource(cut)
plane = servermanager.ProxyManager().SMProxyManager.NewProxy("representations", "ImplicitPlaneWidgetRepresentation")
plane.UpdateVTKObjects()
view.SMProxy.GetProperty("HiddenRepresentations").AddProxy(plane)
view.SMProxy.UpdateVTKObjects()
simple.Render(view)
bottom, top = reader.GetDataInformation().GetBounds()[4:6]
POINT = list(cut.Point)
runs = []
cut.SMProxy.AddObserver("UpdateDataEvent", lambda *_: runs.append(time.monotonic()))


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
seconds = time.monotonic() - begin
check_equal("Always: a run for each step", 20, len(runs))
check("the point of the plane", heights[-1], cut.Point[2], 0.0)
area = get_area()
check("the area at the plane", compute_area(heights[-1]), area, 0.0)
check_true("which is another one", abs(area - first) > 1e-6 * first, f"{area} {first}")
print(f"{20 / seconds:.1f} updates a second, {(time.process_time() - busy) / 20:.3f} s of all cores for each")

# Another source is active: its plane is not this one.
simple.SetActiveSource(reader)
drag(3)
check_equal("of a filter that is not active nothing follows", 0, len(runs))
finish()

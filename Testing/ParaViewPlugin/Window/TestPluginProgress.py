"""TestPluginProgress.py PLUGIN.so STEP ASSEMBLY [HOST:PORT]: progress as the status bar receives it, and runs that are stopped.

In this process: the progress of every source and filter goes from 0 to 1, never decreases and has the label as its text; a run that is
stopped half way ends within a few more reports and says so, and the next run gives the bits of an undisturbed one. On a server: progress
arrives, and MaximumSeconds stops a run, since ParaView 5.11 has no other way. Filters of modules that are not built are left out.
"""
import os
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Support"))
from smcheck import check, check_equal, check_true, finish  # noqa: E402

from paraview import servermanager, simple  # noqa: E402
from paraview.vtk import vtkDataObject  # noqa: E402,F401

plugin, part, assembly = sys.argv[1:4]
server = sys.argv[4].split(":") if len(sys.argv) > 4 else None
if server:
    simple.Connect(server[0], int(server[1]))
    simple.LoadPlugin(plugin, remote=True, ns=globals())
simple.LoadPlugin(plugin, remote=False, ns=globals())


COMPILING = ": compiling shaders"


def has(name):
    return bool(servermanager.ProxyManager().SMProxyManager.HasDefinition("filters", name))


class Watch:
    """Records the progress of an algorithm in this process; stops it at the report number `stop_at`."""

    def __init__(self, proxy, stop_at=None):
        self.algorithm = proxy.SMProxy.GetClientSideObject()
        self.stop_at = stop_at
        self.values, self.texts, self.ended = [], set(), False
        self.tags = [self.algorithm.AddObserver("ProgressEvent", self.progress), self.algorithm.AddObserver("EndEvent", self.end)]

    def progress(self, _caller, _event):
        # The executive reports 1 after the end of an undisturbed run.
        self.values.append(self.algorithm.GetProgress())
        self.texts.add(self.algorithm.GetProgressText())
        if len(self.values) == self.stop_at:
            self.algorithm.SetAbortExecute(1)

    def end(self, _caller, _event):
        self.ended = True

    def remove(self):
        for tag in self.tags:
            self.algorithm.RemoveObserver(tag)


def fields_of(proxy):
    return servermanager.Fetch(proxy, idx=0).GetFieldData()


def run(proxy, stop_at=None):
    watch = Watch(proxy, stop_at)
    proxy.UpdatePipeline()
    watch.remove()
    return watch


def check_progress(what, label, watch, least):
    values = watch.values
    check_true(f"{what}: reports", len(values) >= least, f"{len(values)}, at least {least}")
    check_true(f"{what}: from 0 to 1", values and min(values) >= 0.0 and max(values) == 1.0, f"{min(values)} to {max(values)}")
    check_true(f"{what}: never backwards", all(a <= b for a, b in zip(values, values[1:])), str(values[:20]))
    check_equal(f"{what}: text", {label}, watch.texts - {label + COMPILING})


def check_filter(what, label, make, change, result, slack):
    """An undisturbed run, one that is stopped, and another one of the same filter. `change` makes it run again."""
    whole = make()
    full = run(whole)
    check_progress(what, label, full, 5)
    expected = result(whole)
    again = make()
    half = len(full.values) // 2
    stopped = run(again, half)
    # The last report of an undisturbed run is the executive's own.
    check_true(f"{what}: stopped at the report {half}, it ends", half <= len(stopped.values) <= half + slack,
               f"after {len(stopped.values)} of {len(full.values)}")
    partial = result(again)
    check_true(f"{what}: what it has then is flagged", partial != expected and partial["status"] not in ("ok", expected["volume"]),
               str(partial))
    change(again)
    run(again)
    check_equal(f"{what}: the next run", expected, result(again))
    return expected


def mass_result(proxy):
    data = fields_of(proxy)
    return {"status": data.GetAbstractArray("Status").GetValue(0), "volume": data.GetArray("Volume").GetValue(0),
            "area": data.GetArray("SurfaceArea").GetValue(0), "inertia": [data.GetArray("VolumeInertia").GetComponent(0, i) for i in range(9)]}


def summary_of(proxy):
    return servermanager.Fetch(proxy, idx=2).GetValueByName(0, "Text").ToString()


if not server:
    reader = STEPReader(FileName=assembly)  # noqa: F821
    check_progress("reader", "STEP Reader", run(reader), 10)
    broken = STEPReader(FileName=assembly)  # noqa: F821
    stopped = run(broken, 20)
    # OpenCASCADE asks now and then.
    check_true("reader: stopped at the report 20, it ends", len(stopped.values) <= 32, str(len(stopped.values)))
    check_equal("reader: nothing then", 0, broken.GetDataInformation().GetNumberOfCells())
    broken.MeshDeviation = 0.002
    run(broken)
    check_true("reader: all of it in the next run", broken.GetDataInformation().GetNumberOfCells() > 0)

    reader = STEPReader(FileName=part)  # noqa: F821
    reader.UpdatePipeline()

    def make_mass(**options):
        # Without the cache, so that every run evaluates all faces.
        return lambda: MassProperties(Input=reader, RelativeTolerance=1e-11, ReuseFaceResults=0, **options)  # noqa: F821

    def larger_marker(proxy):
        proxy.MarkerSize = 0.03

    check_filter("mass properties", "Mass Properties", make_mass(Device="OpenGL"), larger_marker, mass_result, 3)
    check_filter("mass properties on the CPU", "Mass Properties", make_mass(Device="CPU"), larger_marker, mass_result, 3)
    # A filter builds its shaders in its first run, which takes seconds where the driver has not kept them.
    compiling = make_mass(Device="OpenGL")()
    handler = servermanager.ActiveConnection.Session.GetProgressHandler()
    interval = handler.GetProgressInterval()
    shown = []
    tag = handler.AddObserver("ProgressEvent", lambda *_: shown.append(handler.GetLastProgressText()))
    check_true("the first run says that shaders are compiled", "Mass Properties" + COMPILING in run(compiling).texts)
    handler.RemoveObserver(tag)
    check_true("and ParaView shows it", "Mass Properties" + COMPILING in shown, str(shown))
    check_equal("ParaView's interval is as before", interval, handler.GetProgressInterval())
    larger_marker(compiling)
    check_equal("the next one does not", {"Mass Properties"}, run(compiling).texts)
    check_equal("nor the CPU", {"Mass Properties"}, run(make_mass(Device="CPU")()).texts)
    if has("SchemeMassProperties"):
        check_filter("the paper's scheme", "Mass Properties by Paper Schemes", lambda: MassPropertiesbyPaperSchemes(  # noqa: F821
            Input=reader, Scheme="3-point Gauss", SubPatchFactor=12), larger_marker,
            lambda proxy: dict(mass_result(proxy), status=summary_of(proxy).split("\n")[1]), 3)
    if has("Buoyancy"):
        afloat = Buoyancy(Input=reader, Point=[0.0, 0.0, 5.0], RelativeTolerance=1e-11)  # noqa: F821
        full = run(afloat)
        check_progress("buoyancy", "Buoyancy", full, 5)
        volume = fields_of(afloat).GetArray("DisplacedVolume").GetValue(0)
        afloat = Buoyancy(Input=reader, Point=[0.0, 0.0, 5.0], RelativeTolerance=1e-11)  # noqa: F821
        half = len(full.values) // 2
        stopped = run(afloat, half)
        check_true("buoyancy: stopped half way, it ends", half <= len(stopped.values) <= half + 3,
                   f"after {len(stopped.values)} of {len(full.values)}")
        check_true("buoyancy: the summary says why", "abort" in summary_of(afloat) or "stopped" in summary_of(afloat), summary_of(afloat))
        afloat.SMProxy.GetClientSideObject().Modified()
        afloat.SMProxy.MarkDirty(None)
        run(afloat)
        check_equal("buoyancy: the next run", volume, fields_of(afloat).GetArray("DisplacedVolume").GetValue(0))
    some = make_mass()()
    run(some, 2)
    check_true("mass properties: the summary says why", "abort" in summary_of(some), summary_of(some))

    everything = STEPReader(FileName=assembly)  # noqa: F821
    everything.UpdatePipeline()
    edits = [("transform", "NURBS Transform", NURBSTransform(Input=everything, Mirror="Across x")),  # noqa: F821
             ("deform", "NURBS Deform", NURBSDeform(Input=everything, Displacement=[0.1, 0.0, 0.0]))  # noqa: F821
             ] if has("NURBSTransform") else []
    for what, label, proxy in edits:
        full = run(proxy)
        check_progress(what, label, full, 100)
        cells = proxy.GetDataInformation().GetNumberOfCells()
        proxy.SMProxy.GetClientSideObject().Modified()
        proxy.SMProxy.MarkDirty(None)
        stopped = run(proxy, 50)
        check_true(f"{what}: stopped at the report 50, it ends", len(stopped.values) <= 52, str(len(stopped.values)))
        check_equal(f"{what}: nothing then", 0, proxy.GetDataInformation().GetNumberOfCells())
        proxy.SMProxy.GetClientSideObject().Modified()
        proxy.SMProxy.MarkDirty(None)
        run(proxy)
        check_equal(f"{what}: all of it in the next run", cells, proxy.GetDataInformation().GetNumberOfCells())

    integral = SurfaceIntegral(Input=reader, MomentDegree=3, RelativeTolerance=1e-11)  # noqa: F821
    check_progress("integrals", "Surface Integral", run(integral), 5)
    if has("SolidStability"):
        standing = StaticStability(Input=reader, Bodies="Each")  # noqa: F821
        check_progress("stability", "Static Stability", run(standing), 5)
        standing = StaticStability(Input=reader, GravityDirection=[0.0, 1.0, 0.0])  # noqa: F821
        stopped = run(standing, 3)
        check_true("stability: stopped at the report 3, it ends", len(stopped.values) <= 5, str(len(stopped.values)))
        check_true("stability: no verdict", "stable" not in summary_of(standing), summary_of(standing))
elif has("SchemeMassProperties"):
    reader = STEPReader(FileName=part)  # noqa: F821
    reader.UpdatePipeline()
    # Without the limit the run takes hours on two cores.
    seconds = 4.0
    mass = MassPropertiesbyPaperSchemes(Input=reader, Scheme="3-point Gauss", SubPatchFactor=1024,  # noqa: F821
                                        MaximumEvaluations=10**15, MaximumSeconds=seconds)
    reports = []
    handler = servermanager.ActiveConnection.Session.GetProgressHandler()
    handler.AddObserver("ProgressEvent", lambda *_: reports.append((handler.GetLastProgress(), handler.GetLastProgressText())))
    start = time.monotonic()
    mass.UpdatePipeline()
    passed = time.monotonic() - start
    ours = [progress for progress, text in reports if text == "Mass Properties by Paper Schemes"]
    check_true("server: its progress arrives with its label", len(ours) >= 1, str(reports))
    check_true("server: in percent, never backwards", ours == sorted(ours) and all(0 <= each <= 100 for each in ours), str(ours))
    # The excess is the part of the preparation that is not interruptible, on a machine that may be busy.
    check("server: seconds", seconds, passed, 25.0, "(the run would take hours)")
    check_true("server: stopped by MaximumSeconds", passed >= seconds, f"{passed:.1f} s")
    check_equal("server: status", "not-computed", fields_of(mass).GetAbstractArray("Status").GetValue(0))
    check_true("server: the summary says why", "maximum seconds" in summary_of(mass), summary_of(mass))
    mass.SubPatchFactor, mass.MaximumSeconds = 1, 0.0
    mass.UpdatePipeline()
    check_true("server: the next run", fields_of(mass).GetArray("Volume").GetValue(0) > 1000.0)
    check_true("this was remote", servermanager.ActiveConnection.IsRemote())
finish()

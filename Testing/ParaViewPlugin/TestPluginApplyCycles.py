"""TestPluginApplyCycles.py PLUGIN.so FILE.step CYCLES: an open part is applied repeatedly, with other properties and another shape
upstream; OpenGL objects in the contexts of view and filter, memory, threads and files do not grow.

Before that: a run of the filter does not change a byte of the view's picture.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check_equal, check_true, finish  # noqa: E402
from smresources import Process, check_counting, check_held, count_errors, count_objects, run_counted  # noqa: E402

import solidmoments.smFiltersMassProperties  # noqa: E402, F401  (the Python class of the filter)
import solidmoments.smRenderingCompute  # noqa: E402, F401
from paraview import servermanager, simple  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402

plugin, path, cycles = sys.argv[1], sys.argv[2], int(sys.argv[3])
simple.LoadPlugin(plugin, ns=globals())
controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
view = simple.CreateRenderView(ViewSize=[200, 150])
window = view.GetRenderWindow()


def capture():
    simple.Render(view)
    return vtk_to_numpy(view.CaptureWindow(1).GetPointData().GetScalars()).tobytes()


reader = simple.OpenDataFile(path)
simple.Show(reader, view)
simple.Show(simple.Text(Text="SolidMoments"), view)
simple.ResetCamera(view)
before = capture()
check_true("a picture", len(set(before)) > 50, f"{len(set(before))} values of {len(before)}")
check_true("is repeated", capture() == before)
bend = NURBSDeform(Input=reader)  # noqa: F821
mass = MassProperties(Input=bend, Device="OpenGL")  # noqa: F821
mass.UpdatePipeline()
check_true("nothing changed after the filter ran", capture() == before)
mass.RelativeTolerance = 1e-7
mass.UpdatePipeline()
check_true("nor after it ran again", capture() == before)
algorithm = mass.GetClientSideObject()
check_equal("it ran on", "opengl", algorithm.GetBackendName())
own = algorithm.GetComputeContext().GetRenderWindow()
check_true("in a context of its own", own is not None and own is not window)

simple.Hide(reader, view)
for port in range(6):
    controller.ShowInPreferredView(mass.SMProxy, port, view.SMProxy)
check_true("its own picture is another", capture() != before)
errors = 0
evaluations = 0


def cycle(i):
    global errors, evaluations
    # Another shape with new faces; another tolerance, then the first again; a density, which needs no
    # evaluation.
    if i % 4 == 0:
        bend.Displacement = [1e-3 * (1 + i % 50), 0.0, 0.0]
    elif i % 4 == 2:
        mass.Density = 1000.0 + i % 8
    else:
        mass.RelativeTolerance = 1e-7 if i % 4 == 1 else 1e-9
    simple.Render(view)
    evaluations += algorithm.GetEvaluations() > 0
    errors += count_errors(window) + count_errors(own)
    own.ReleaseCurrent()


def count():
    held = Process(), count_objects(window), count_objects(own)
    own.ReleaseCurrent()
    return held


# Counts are taken in the same phase of the four steps if the number of cycles is a multiple of 4.
warm = max(32, cycles // 40 * 8)
for i in range(warm):
    cycle(i)
check_counting(own)
evaluations = 0
start, end, growth = run_counted(cycle, warm, cycles, count, lambda view_objects, own_objects:
                                 f"view: {sum(view_objects.values())} objects, filter: {sum(own_objects.values())}")
check_equal("OpenGL errors", 0, errors)
check_true("runs that evaluated", evaluations >= 0.4 * cycles, f"{evaluations} of {cycles}")
check_equal("objects of the filter", start[2], end[2])
# Measured: 4 and 100. A page of the part's faces has 600 kB, its mesh 1 MB.
check_held(start, end, growth, heap=5e3, resident=2e4)
finish()

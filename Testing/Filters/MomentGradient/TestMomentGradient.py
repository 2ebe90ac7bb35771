"""TestMomentGradient.py FOLDER: the filter of VTK and moment_gradient() of the package: arrays, shapes, progress, abort, errors."""
import math
import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Support"))
from smcheck import Manifest, check, check_equal, check_true, finish  # noqa: E402
from smstepbody import EMPTY, Body, format_real  # noqa: E402

import numpy  # noqa: E402
import solidmoments  # noqa: E402
from solidmoments.smFiltersMomentGradient import vtkMomentGradient  # noqa: E402
from solidmoments.smReadersSTEP import vtkSTEPReader  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402

BOX = Manifest(sys.argv[1]).solid("box", "plain")
CONE = Manifest(sys.argv[1]).solid("cone", "plain")


def check_package():
    """The identities of the volume on the arrays, and their shapes."""
    gradient = solidmoments.moment_gradient(BOX["path"], tied=False)
    check_equal("status", "ok", gradient.status)
    check_equal("unit", "mm", gradient.length_unit)
    check_equal("quantities", 23, len(gradient.quantities))
    check_equal("the last one", ("SurfaceArea", 2), (gradient.quantities[-1], gradient.length_powers[-1]))
    check_equal("faces", list(range(6)), [face.face for face in gradient.faces])
    q = gradient.index("Volume")
    euler = error = 0.0
    for face in gradient.faces:
        check_equal("shapes", [(2, 2, 4, 23), (2, 2, 4, 23), (2, 2, 3), (2, 2), (2, 2), (2, 2)],
                    [array.shape for array in (face.values, face.bounds, face.points, face.weights, face.point_variables, face.weight_variables)])
        euler += float((face.points * face.values[..., :3, q]).sum())
        error += float((abs(face.points) * face.bounds[..., :3, q]).sum())
    check("sum of P . dV/dP = 3 V", 3.0 * BOX["volume"], euler, error + 3e-15 * BOX["volume"])
    check_true("whose bound is small", error < 1e-7 * BOX["volume"], str(error))
    tied = solidmoments.moment_gradient(BOX["path"])
    check_equal("8 corners are the variables", 8, len({int(i) for face in tied.faces for i in face.point_variables.ravel()}))
    one = solidmoments.moment_gradient(BOX["path"], faces=[3])
    check_equal("one face", [3], [face.face for face in one.faces])
    check_true("has the numbers of the whole", numpy.array_equal(one.faces[0].values, tied.faces[3].values, equal_nan=True))
    device = solidmoments.moment_gradient(BOX["path"], faces=[3], backend="opengl")
    # A driver that takes subnormal numbers for 0 leaves gradients to the CPU.
    flushes = "takes numbers below 2.3e-308 for 0" in device.backend_reason
    check_equal("by shaders", "cpu" if flushes else "opengl", device.used_backend)
    check_true("without a reason", flushes or not device.backend_reason, device.backend_reason)
    check_equal("by the processor", ("cpu", ""), (tied.used_backend, tied.backend_reason))
    cone = solidmoments.moment_gradient(CONE["path"])
    check_true("coinciding moments are NaN, and said so", any("coincide" in text for text in cone.messages) and
               numpy.isnan(cone.faces[0].values[..., cone.index("PrincipalMoment_2")]).any())
    for text, call in (("no such face", lambda: solidmoments.moment_gradient(BOX["path"], faces=[6])),
                       ("backend", lambda: solidmoments.moment_gradient(BOX["path"], backend="gpu")),
                       ("tolerance", lambda: solidmoments.moment_gradient(BOX["path"], tolerance=2.0))):
        try:
            call()
            check_true(text, False)
        except ValueError as error_:
            check_true(text, True, str(error_))
    try:
        solidmoments.moment_gradient(os.path.join(sys.argv[1], "no such file.step"))
        check_true("a file that does not exist", False)
    except FileNotFoundError:
        check_true("a file that does not exist", True)


def write_cap(path, body, radius, low):
    """Writes the part of a ball about the body's origin above z = low, with a seam that ends at the pole."""
    rim = math.sqrt(radius * radius - low * low)
    start, pole = body.vertex((rim, 0, low)), body.vertex((0, 0, radius))

    def arc(end, center, size, z):
        circle = body.add(f"CIRCLE({EMPTY},{body.axes(center, z)},{format_real(size)})")
        return body.add(f"EDGE_CURVE('',{start},{end},{circle},.T.)")

    border, seam = arc(start, (0, 0, low), rim, (0, 0, 1)), arc(pole, (0, 0, 0), radius, (0, -1, 0))
    faces = [body.face([body.loop([(border, True), (seam, True), (seam, False)])],
                       body.add(f"SPHERICAL_SURFACE('',{body.axes((0, 0, 0))},{format_real(radius)})")),
             body.face([body.loop([(border, False)])], body.add(f"PLANE('',{body.axes((0, 0, low), (0, 0, -1))})"))]
    body.product("cap", body.shape([body.identity, body.solid(faces)]))
    with open(path, "w", encoding="ascii") as file:
        file.write(body.get_text())


def check_cap():
    """The area of a spherical cap by a factor about the centre, 2 A = 4 pi r h: in frames in which the pole is a point to rounding only."""
    radius = 5.0
    with tempfile.TemporaryDirectory() as folder:
        for origin in ((0.0, 0.0, 0.0), (1.0, 2.0, 3.0), (11.8, -17.6, 30.0)):
            for low in (0.0, 2.0, 4.0):
                path = os.path.join(folder, "cap.step")
                write_cap(path, Body(0.4 if any(origin) else 0.0, origin), radius, low)
                gradient = solidmoments.moment_gradient(path, tied=False, backend="cpu")
                q = gradient.index("SurfaceArea")
                face, away = gradient.faces[0], gradient.faces[0].points - origin
                value = float((away * face.values[..., :3, q]).sum())
                bound = float((abs(away) * face.bounds[..., :3, q]).sum())
                twice = 4.0 * math.pi * radius * (radius - low)
                check(f"cap above {low} at {origin}: the area by its size", twice, value, min(bound, 1e-9 * twice))
                check_true("whose bound is small", bound < 5e-4 * twice, f"{bound:.2g} of {twice:.4g}")
                check_true("without a message about it", not any("SurfaceArea" in text for text in gradient.messages))


def check_filter():
    """The dataset, progress, abort and errors."""
    reader = vtkSTEPReader()
    reader.SetFileName(BOX["path"])
    reader.Update()
    gradient = vtkMomentGradient()
    gradient.SetInputConnection(reader.GetOutputPort())
    seen = []
    gradient.AddObserver("ProgressEvent", lambda caller, _event: seen.append(caller.GetProgress()))
    gradient.Update()
    check_true("progress grows", len(seen) > 3 and seen == sorted(seen), str(seen[:3]))
    output = gradient.GetOutput()
    check_equal("points", 24, output.GetNumberOfPoints())
    check_equal("lines", 24, output.GetNumberOfLines())
    data = output.GetPointData()
    check_equal("vectors", "VolumeByPoint", data.GetVectors().GetName())
    values = numpy.array(vtk_to_numpy(gradient.GetValues(2))).reshape(2, 2, 4, 23)
    for q in range(gradient.GetNumberOfQuantities()):
        name = gradient.GetQuantityName(q)
        for suffix, components in (("ByPoint", 3), ("ByPointBound", 3), ("ByWeight", 1), ("ByWeightBound", 1)):
            array = data.GetArray(name + suffix)
            check_true(name + suffix, array is not None and array.GetNumberOfComponents() == components)
        check_true(name + " agrees with the array of its face", numpy.array_equal(
            vtk_to_numpy(data.GetArray(name + "ByPoint"))[8:12].reshape(2, 2, 3), values[..., :3, q], equal_nan=True))
    check_equal("backend", (gradient.CPU, ""), (gradient.GetUsedBackend(), gradient.GetBackendReason()))
    gradient.SetBackend(gradient.OPENGL)
    gradient.Update()
    flushes = "takes numbers below 2.3e-308 for 0" in gradient.GetBackendReason()
    check_equal("by OpenGL", gradient.CPU if flushes else gradient.OPENGL, gradient.GetUsedBackend())
    bounds = vtk_to_numpy(gradient.GetBounds(2)).reshape(values.shape)
    apart = numpy.abs(vtk_to_numpy(gradient.GetValues(2)).reshape(values.shape) - values)
    check_true("within the bounds", bool(numpy.all((apart <= 2 * bounds) | numpy.isnan(bounds))))
    check_equal("no such face", (None, 0, -1), (gradient.GetValues(6), gradient.GetCountU(6), gradient.GetSolid(-1)))
    check_equal("no such quantity", "", gradient.GetQuantityName(23))

    errors = []

    def note(_caller, _event, text):
        errors.append(text)

    note.CallDataType = "string0"
    gradient.AddObserver("ErrorEvent", note)
    gradient.SetRelativeTolerance(0.0)
    check_true("a tolerance of 0 is refused", len(errors) == 1 and gradient.GetRelativeTolerance() == 1e-9, errors[-1])
    gradient.AddFace(17)
    gradient.Update()
    check_true("a face that does not exist", len(errors) > 1 and "face 17" in errors[1], errors[-1])
    check_equal("no points then", 0, gradient.GetOutput().GetNumberOfPoints())
    check_equal("status", "not-computed", gradient.GetStatus())
    gradient.ClearFaces()
    count = len(errors)
    stop = gradient.AddObserver("ProgressEvent", lambda caller, _event: caller.SetAbortExecute(1))
    gradient.Update()
    check_equal("stopped", ("not-computed", 0, count), (gradient.GetStatus(), gradient.GetOutput().GetNumberOfPoints(), len(errors)))
    gradient.RemoveObserver(stop)
    gradient.Modified()
    gradient.Update()
    check_equal("and again", ("ok", 24), (gradient.GetStatus(), gradient.GetOutput().GetNumberOfPoints()))


check_package()
check_cap()
check_filter()
finish()

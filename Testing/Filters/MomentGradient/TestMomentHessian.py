"""TestMomentHessian.py FOLDER LEVER: moment_hessian_product() of the package: shapes, closed forms of a box, faces with holes, errors."""
import importlib.util
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Support"))
from smcheck import Manifest, check, check_equal, check_true, finish  # noqa: E402

import numpy  # noqa: E402
import solidmoments  # noqa: E402
from solidmoments.smFiltersMomentGradient import vtkMomentHessian  # noqa: E402
from vtkmodules.vtkCommonCore import vtkDoubleArray  # noqa: E402

BOX = Manifest(sys.argv[1]).solid("box", "plain")


def check_box():
    """Sides a, b, c: the second derivative of V by a and b is c; along all of them it is H P = 2 grad V."""
    gradient = solidmoments.moment_gradient(BOX["path"])
    points = numpy.concatenate([face.points.reshape(-1, 3) for face in gradient.faces])
    low, high = points.min(axis=0), points.max(axis=0)

    def get_direction(axis):
        return {face.face: (abs(face.points[..., axis] - high[axis]) < 1e-9)[..., None] * numpy.eye(3)[axis] for face in gradient.faces}

    product = solidmoments.moment_hessian_product(BOX["path"], get_direction(0))
    check_equal("status", "ok", product.status)
    check_equal("unit", "mm", product.length_unit)
    check_equal("quantities", ("Volume", 3, 10), (product.quantities[0], product.length_powers[0], len(product.quantities)))
    check_equal("faces", list(range(6)), [face.face for face in product.faces])
    check_true("all are whole nets", all(face.has_tied_border is True for face in product.faces))
    q = product.index("Volume")
    for axis, expected in ((1, (high - low)[2]), (2, (high - low)[1]), (0, 0.0)):
        total = bound = 0.0
        seen = set()
        for net, face, first in zip(get_direction(axis).values(), product.faces, gradient.faces):
            check_equal("shapes", [(2, 2, 3, 10)] * 2, [face.values.shape, face.bounds.shape])
            for place, variable in numpy.ndenumerate(first.point_variables):
                if int(variable) not in seen:
                    seen.add(int(variable))
                    total += float(net[place] @ face.values[place][:, q])
                    bound += float(abs(net[place]) @ face.bounds[place][:, q])
        check(f"by sides 0 and {axis}", float(expected), total, bound + 1e-14 * abs(expected))
        check_true("with a small bound", bound < 1e-7, str(bound))
    separate = solidmoments.moment_hessian_product(BOX["path"], {face.face: face.points for face in gradient.faces}, tied=False)
    first = solidmoments.moment_gradient(BOX["path"], tied=False)
    worst = max(float(abs(a.values[..., q] - 2.0 * b.values[..., :3, 0]).max()) for a, b in zip(separate.faces, first.faces))
    check("H P = 2 grad V", 0.0, worst, 1e-9)


def check_lever():
    """The faces above and below have a hole, so that theirs is not the Hessian of the solid."""
    spec = importlib.util.spec_from_file_location("lighten_lever", sys.argv[2])
    lever = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(lever)
    start = numpy.tile([lever.HALF_WIDTH, lever.HALF_WIDTH, lever.HALF_HEIGHT, lever.HALF_HEIGHT], (len(lever.FREE), 1))
    model = lever.build(lever.make_lattice(start))
    gradient = solidmoments.moment_gradient(model)
    product = solidmoments.moment_hessian_product(model, {face.face: numpy.ones((*face.weights.shape, 3)) for face in gradient.faces})
    check_equal("whole nets", [True] * 4 + [False] * 2, [face.has_tied_border for face in product.faces[:6]])
    check_true("and said so", len(product.messages) == 1 and " 4 of 8 faces are not " in product.messages[0], str(product.messages))
    q = product.index("Volume")
    worst = max(float(abs(face.values[..., q]).max() - face.bounds[..., q].max()) for face in product.faces)
    check_true("a translation changes no derivative of the volume", worst <= 0.0, str(worst))


def check_errors():
    ones = numpy.ones((2, 2, 3))
    for text, call in (("no face", lambda: solidmoments.moment_hessian_product(BOX["path"], {})),
                       ("a face that does not exist", lambda: solidmoments.moment_hessian_product(BOX["path"], {6: ones})),
                       ("a solid that does not exist", lambda: solidmoments.moment_hessian_product(BOX["path"], {(1, 0): ones})),
                       ("a shape", lambda: solidmoments.moment_hessian_product(BOX["path"], {0: ones[0]})),
                       ("a number of points", lambda: solidmoments.moment_hessian_product(BOX["path"], {0: ones[:1]})),
                       ("torn ties", lambda: solidmoments.moment_hessian_product(BOX["path"], {0: ones})),
                       ("tolerance", lambda: solidmoments.moment_hessian_product(BOX["path"], {0: ones}, tolerance=0.0))):
        try:
            call()
            check_true(text, False)
        except ValueError as error:
            check_true(text, len(str(error)) > 20, str(error)[:150])
    hessian = vtkMomentHessian()
    check_true("no array", not hessian.AddDisplacements(0, 0, None) and not hessian.AddDisplacements(0, 0, vtkDoubleArray()))
    check_true("no input", not hessian.Compute(None) and hessian.GetStatus() == "not-computed", hessian.GetReason())
    check_equal("no results", (0, None, 0, -1, False, ""), (hessian.GetNumberOfFaces(), hessian.GetValues(0), hessian.GetCountU(0),
                                                          hessian.GetFace(-1), hessian.HasTiedBorder(3), hessian.GetMessage(0)))


check_box()
check_lever()
check_errors()
finish()

"""TestPythonArguments.py SAMPLE BOX OUTPUT: every public function of the package refuses arguments of a wrong type by TypeError and wrong values by
ValueError, with the name of the argument and what is expected, and nothing on the console."""
import contextlib
import decimal
import os
import pathlib
import sys
import tempfile
import warnings

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check_equal, check_true, finish  # noqa: E402

import numpy  # noqa: E402
import solidmoments as sm  # noqa: E402
from solidmoments import autodiff  # noqa: E402

sample, box, output = sys.argv[1:4]
NAN = float("nan")
KNOTS = [0, 0, 1, 1]
NET = numpy.array([[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 0]]], dtype=float)
LINE = [[0, 0, 0], [1, 0, 0]]


@contextlib.contextmanager
def capture_console(found):
    """Appends what the process writes to its standard error, also from C++."""
    sys.stderr.flush()
    kept = os.dup(2)
    with tempfile.TemporaryFile() as file:
        os.dup2(file.fileno(), 2)
        try:
            yield
        finally:
            sys.stderr.flush()
            os.dup2(kept, 2)
            os.close(kept)
            file.seek(0)
            found.append(file.read().decode(errors="replace"))


def refuse(what, kind, said, call):
    """The call raises exactly this kind of error, whose text has `said`, and prints nothing."""
    what, console, error = " ".join(what.split()), [], None
    with capture_console(console):
        try:
            call()
        except Exception as raised:  # noqa: BLE001 any other kind is a failure
            error = raised
    check_true(what, type(error) is kind and said in str(error), f"{type(error).__name__}: {error}")
    check_equal(f"{what}: console", "", console[0])


def refuse_all(name, call, types=(), values=()):
    """call(value) raises TypeError for each of types, ValueError for each of values; the text begins with the name."""
    for kind, wrong in ((TypeError, types), (ValueError, values)):
        for value in wrong:
            refuse(f"{name} {str(value)[:40]!r}", kind, name, lambda value=value: call(value))


def check_files():
    def mass(**options):
        return lambda value: sm.mass_properties(sample, **{name: value if given is None else given for name, given in options.items()})

    refuse_all("density", mass(density=None), ("steel", "7850", [7850], True, {}, b"1", 1j, numpy.array([1.0, 2.0])), (NAN, -1, 0, float("inf"), 1e-310))
    refuse_all("tolerance", mass(tolerance=None), ("x", None, [1], True), (NAN, -1, 2))
    refuse_all("density_tolerance", mass(density_tolerance=None), ("x", None, [1], True), (NAN, -1, 2))
    refuse_all("max_seconds", mass(max_seconds=None), ("x", [1], True), (NAN, -1, 0))
    for name in ("unit", "input_unit", "backend", "repair", "hidden"):
        refuse_all(name, mass(**{name: None}), (), (None, 3, [1], "x", ["mm"]))
    refuse_all("strict", mass(strict=None), ("no", None, 3, 0.5))
    refuse_all("content", mass(content=None), ("text", 3, [1]))
    refuse_all("materials", mass(materials=None), (None, 3, "steel", {"*": 7850}))
    refuse_all("a row of materials", mass(materials=None), (["steel"], [("a",)], [("a", "steel", 1, 2, 3, 4)], [None]))
    for row, kind in ((("*", 3, 1.0), TypeError), ((3, "steel", 1.0), TypeError), (("*", "x", [1]), TypeError), (("*", "x", True), TypeError),
                      (("*", "x", "abc"), ValueError), (("*", "x", NAN), ValueError), (("*", "x", None), ValueError)):
        refuse(f"materials {row}", kind, "", lambda row=row: sm.mass_properties(sample, materials=[row]))
    for name, call in (("mass_properties", sm.mass_properties), ("parts_list", sm.parts_list), ("validation", sm.validation), ("robot", sm.robot),
                       ("display_mesh", sm.display_mesh), ("compare", lambda file: sm.compare(sample, file))):
        for value in (None, 3, [sample]):
            refuse(f"{name} {value!r}", TypeError, "file is ", lambda value=value, call=call: call(value))
        refuse(f"{name} of nothing", FileNotFoundError, "there is no such file: ''", lambda call=call: call(""))
        refuse(f"{name} of a folder", IsADirectoryError, "it is a folder; name a file in it", lambda call=call: call(output))
    refuse_all("files", sm.to_dataframe, (None, 3, {}))
    refuse("files [3]", TypeError, "an entry of files is 3", lambda: sm.to_dataframe([3]))
    for call in (lambda value: sm.compare(sample, sample, limit=value), lambda value: sm.validation(sample, limit=value)):
        refuse_all("limit", call, ("x", None, [1], True), (NAN, -1, 1))
    refuse_all("format", lambda value: sm.robot(sample, value), (), (3, "x", None))
    refuse_all("joints", lambda value: sm.robot(sample, joints=value), (3, None, ["a,b,fixed"]))
    refuse_all("fuse", lambda value: sm.robot(sample, fuse=value), (3, None))
    refuse("fuse [3]", TypeError, "an entry of fuse is 3", lambda: sm.robot(sample, fuse=[3]))
    refuse_all("deflection", lambda value: sm.display_mesh(sample, deflection=value), ("x", None, [1], True), (NAN, -1, 2))


def check_gradients():
    for name in ("solids", "faces"):
        refuse_all(name, lambda value, name=name: sm.moment_gradient(box, **{name: value}), (3, None, "x"))
        for value in ([1.5], ["0"], [True]):
            refuse(f"{name} {value}", TypeError, f"an entry of {name} is", lambda value=value, name=name: sm.moment_gradient(box, **{name: value}))
        for value in ([-1], [700], [2**40]):
            refuse(f"{name} {value}", ValueError, str(value[0]), lambda value=value, name=name: sm.moment_gradient(box, **{name: value}))
    refuse_all("tied", lambda value: sm.moment_gradient(box, tied=value), ("no", 3, None))
    refuse_all("source", sm.moment_gradient, (None, 3, [], object(), NET, {}))
    gradient = sm.moment_gradient(box, faces=[0])
    for value in ("volume", 3):
        refuse(f"index({value!r})", ValueError, "give one of Volume, ", lambda value=value: gradient.index(value))
    zero = numpy.zeros(gradient.faces[0].points.shape)
    for value in (None, 3, []):
        refuse(f"direction {value}", TypeError, "direction is ", lambda value=value: sm.moment_hessian_product(box, value))
    for value, kind, said in (({}, ValueError, "no face moves"), ({0: None}, TypeError, "the displacements of face 0"), ({0: 3}, ValueError, "has the shape"),
                              ({0: numpy.full(zero.shape, NAN)}, ValueError, "not finite"), ({"a": zero}, TypeError, "a key of direction"),
                              ({(0, 0, 0): zero}, ValueError, "(solid, face)"), ({0.5: zero}, TypeError, "a key of direction"), ({700: zero}, ValueError, "700"),
                              ({(9, 0): zero}, ValueError, "there is no solid 9"), ({0: numpy.ma.masked_equal(zero, 0.0)}, ValueError, "masked")):
        refuse(f"direction {str(value)[:40]}", kind, said.replace("has the shape", "shape"), lambda value=value: sm.moment_hessian_product(box, value))
    for call in (sm.moment_gradient, lambda source, **options: sm.moment_hessian_product(source, {0: zero}, **options)):
        refuse_all("tolerance", lambda value, call=call: call(box, tolerance=value), ("x", None, [1]), (NAN, 0))


def make_edge():
    model = sm.Model()
    model.add_edge([0, 1], LINE)
    return model


def make_sheet():
    model = make_edge()
    model.add_face(1, KNOTS, 1, KNOTS, NET)
    return model


def check_models():
    # Without a face there is no result.
    for make in (sm.Model, make_edge):
        try:
            make().mass_properties()
            check_true("a model without faces has no result", False)
        except sm.SolidMomentsError as error:
            check_true("a model without faces", "it has no faces" in str(error) and error.status == "suspect", str(error))
    refuse_all("name", sm.Model, (None, 3, [1]))
    refuse_all("length_unit", lambda value: sm.Model("a", value), (), (None, 3, "kg", ""))
    refuse_all("breaks", lambda value: make_sheet().add_edge(value, LINE), (None, "x", ["0", "1"]), ())
    refuse_all("coefficients", lambda value: make_sheet().add_edge([0, 1], value), (None, "x", [[0, 0, 0], [1, 0, "x"]], [[0j, 0, 0], [1, 1, 1]], [[0, 0, None], LINE[1]]),
               ([], 3, [[0, 0], [1, 1]], [[0, 0, 0], [1, 0]]))
    for values in ([], [0], [1, 0], [0, NAN], [[0, 1]]):
        refuse(f"breaks {values}", ValueError, "break", lambda values=values: make_sheet().add_edge(values, LINE))
    refuse_all("residual", lambda value: make_sheet().add_edge([0, 1], LINE, value), (None, "x", [0]))
    for name, wrong in (("degree_u", (None, "x", 1.5, True, [1])), ("knots_u", (None, "x")), ("control_points", (None, "x")), ("reversed", ("x", None, 3))):
        refuse_all(name, lambda value, name=name: make_sheet().add_face(**{"degree_u": 1, "knots_u": KNOTS, "degree_v": 1, "knots_v": KNOTS, "control_points": NET, name: value}), wrong)
    for name, value in (("knots_u", []), ("knots_u", [0, 1]), ("knots_u", [KNOTS]), ("control_points", NET[:1]), ("control_points", NET[..., :2]), ("degree_u", 2), ("degree_u", 99)):
        refuse(f"{name} {str(value)[:30]!r}", ValueError, "", lambda name=name, value=value: make_sheet().add_face(
            **{"degree_u": 1, "knots_u": KNOTS, "degree_v": 1, "knots_v": KNOTS, "control_points": NET, name: value}))
    for name, wrong in (("face", (None, "x", 0.5, [0])), ("loop", (None, "x", 0.5)), ("edge", (None, "x", 0.5)), ("reversed", ("x", None, 3)), ("residual", (None, "x"))):
        refuse_all(name, lambda value, name=name: make_sheet().add_coedge(
            **{"face": 0, "loop": 0, "edge": 0, "reversed": False, "breaks": [0, 1], "coefficients": [[0, 0], [1, 0]], name: value}), wrong)
    refuse_all("density", lambda value: make_sheet().mass_properties(value), ("steel",), (NAN,))


def check_variants():
    from solidmoments.smReadersSTEP import vtkSTEPReader

    reader = vtkSTEPReader()
    reader.SetFileName(box)
    reader.Update()
    base = reader.GetOutput().GetPartition(0, 0).GetModel()
    zero = numpy.zeros((2, 2, 3))
    refuse_all("base", lambda value: sm.Variants(value, [0]), (None, 3, "x", box))
    refuse_all("directions", lambda value: sm.Variants(base, value), (None, 3, "x", {0: zero}), ([],))
    for value in ([None], ["x"], [0.5], [True], [(base,)], [(base, "x")], [(3, 1.0)], [(None, 1.0)], [{"a": zero}], [{0: None}]):
        refuse(f"directions {str(value)[:40]}", TypeError, "direction" if value != [{0: None}] else "displacements", lambda value=value: sm.Variants(base, value))
    for value in ([99], [-1], [2**40], [(base, 0.0)], [{}], [{0: numpy.zeros(4)}], [{0: numpy.full((2, 2, 3), NAN)}], [{99: zero}]):
        refuse(f"directions {str(value)[:40]}", ValueError, "", lambda value=value: sm.Variants(base, value))
    refuse_all("ranges", lambda value: sm.Variants(base, [0], value), (3, "x"))
    refuse_all("an entry of ranges", lambda value: sm.Variants(base, [0], value), ([None], ["x"], [[1]]))
    for value in ([], [-1], [0], [NAN], [1, 2]):
        refuse(f"ranges {value}", ValueError, "range", lambda value=value: sm.Variants(base, [0], value))
    for name in ("method", "backend"):
        refuse_all(name, lambda value, name=name: sm.Variants(base, [0], **{name: value}), (), (3, None, "x", [1]))
    refuse_all("expected", lambda value: sm.Variants(base, [0], expected=value), (None, "x", [1], True), (-1, 0, 1.5, NAN, float("inf"), 2**70))
    refuse_all("progress", lambda value: sm.Variants(base, [0], progress=value), (3, "x"))
    variants = sm.Variants(base, [0, 1], backend="cpu", expected=1e6)
    refuse_all("c", variants.evaluate, (None, "x", [["a", 1]], [[1j, 1]]), ([], [1], [1, 2, 3], [[1], [2]], numpy.zeros((2, 2, 2)), 3))
    refuse_all("bounds", lambda value: variants.evaluate([0, 0], bounds=value), ("x", None))
    check_true("what is not finite gives NaN", numpy.isnan(variants.evaluate([[1, NAN]]).values).all())
    refuse_all("points", lambda value: autodiff.mass_properties(lambda points: make_sheet(), value, []), (None, "x"), ([], [[1, 2]], [[0, 0, NAN]], 3))
    for name, value, said in (("build", None, "build is None"), ("build", lambda points: None, "build(points) returned None"), ("nets", None, "nets is None"),
                              ("nets", "x", "nets is 'x'"), ("quantities", 3, "quantities is 3"), ("quantities", "Volume", "quantities is 'Volume'")):
        refuse(said, TypeError, said, lambda name=name, value=value: autodiff.mass_properties(
            **{"build": lambda points: make_sheet(), "points": LINE, "nets": [], name: value}))
    refuse_all("moments", lambda value: autodiff.variants(value, [0, 0]), (None, 3))
    refuse_all("the cotangent", lambda value: autodiff.variants(variants, [0, 0])[1](value), (None, "x"), ([1],))


def check_what_is_taken():
    """Numbers of other libraries, paths as objects and bytes, and what is a number of variants."""
    expected = sm.mass_properties(box, density=7850.0).mass
    for value in (7850, numpy.float32(7850), numpy.int64(7850), numpy.array(7850.0), decimal.Decimal("7850")):
        check_equal(f"density {value!r}", expected, sm.mass_properties(box, density=value).mass)
    for value in (pathlib.Path(box), os.fsencode(box)):
        check_equal(f"{type(value).__name__}: the file", (expected, box), (sm.mass_properties(value, 7850).mass, sm.mass_properties(value).file))
    with open(box, "rb") as file:
        content = file.read()
    for value in (content, bytearray(content), memoryview(content)):
        check_equal(f"{type(value).__name__}: the content", expected, sm.mass_properties("box.step", 7850, content=value).mass)
    check_equal("strict as numpy's bool", expected, sm.mass_properties(box, 7850, strict=numpy.bool_(True)).mass)
    model = make_sheet()
    model.add_coedge(0, 0, numpy.int32(0), 0, (0, 1), numpy.array([[0, 0], [1, 0]]))


warnings.simplefilter("ignore", sm.FlaggedResultWarning)
check_files()
check_gradients()
check_models()
check_variants()
check_what_is_taken()
finish()

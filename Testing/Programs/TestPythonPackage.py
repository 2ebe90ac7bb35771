"""TestPythonPackage.py PROGRAM SOLIDS SAMPLE VERSION: solidmoments.mass_properties() and to_dataframe() give what the program prints as
JSON, bit for bit, and raise where it has no result."""
import dataclasses
import gzip
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import types
import warnings
import zipfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check, check_equal, check_true, finish  # noqa: E402

import solidmoments  # noqa: E402

program, folder, sample, version = sys.argv[1:5]
manifest = Manifest(folder)
NUMBERS = ("volume", "area", "center_of_mass", "inertia", "inertia_at_origin", "principal_moments", "principal_axes", "radii_of_gyration",
           "mass", "mass_center", "mass_inertia")


def run(*arguments):
    result = subprocess.run([program, *arguments, "--json", "-"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=200, check=False)
    return json.loads(result.stdout)["files"]


def lists(value):
    return [lists(item) for item in value] if isinstance(value, tuple) else value


def check_row(what, expected, row):
    """A row against an entry of the JSON; == of numbers, no tolerance."""
    wrong = []
    for name in NUMBERS:
        value = expected[name]
        pairs = [(value, lists(getattr(row, name)))]
        if name in expected["bounds"]:
            pairs.append((expected["bounds"][name], getattr(row, name + "_bound")))
        wrong += [f"{name}: {a!r}, {b!r}" for a, b in pairs if a != b]
    for name in ("closure_correction", "gap_squared", "max_gap", "gap_area", "closure_residual", "open_edges"):
        if expected[name] != getattr(row, name):
            wrong.append(f"{name}: {expected[name]!r}, {getattr(row, name)!r}")
    for name, value in expected["closure_spread"].items():
        if name != "mass_principal_moments" and value != getattr(row, name + "_spread"):
            wrong.append(f"spread of {name}: {value!r}, {getattr(row, name + '_spread')!r}")
    check_equal(what + ": numbers that differ from the program's", [], wrong)


def quietly(*arguments, **options):
    """The result and the texts of its warnings."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        result = solidmoments.mass_properties(*arguments, **options)
    return result, [str(warning.message) for warning in caught if warning.category is solidmoments.FlaggedResultWarning]


def check_same():
    two = manifest.special("two_solids")["path"]
    for path, options, more in ((sample, (), {}), (sample, ("--density", "7850", "--unit", "inch"), {"density": 7850.0, "unit": "inch"}),
                                (sample, ("--backend", "cpu", "--tolerance", "1e-6"), {"backend": "cpu", "tolerance": 1e-6}),
                                (sample, ("--repair", "always"), {"repair": "always"}),
                                (two, ("--density", "1000"), {"density": 1000.0})):
        expected = run(path, *options)[0]
        result, flags = quietly(path, **more)
        name = f"{os.path.basename(path)} {' '.join(options)}"
        check_equal(name + ": status", expected["status"], result.status)
        check_equal(name + ": warned when it is flagged", expected["status"] != "ok", bool(flags))
        check_row(name + ", total", expected["total"], result)
        check_equal(name + ": solids", len(expected["solids"]), len(result.solids))
        for i, (solid, row) in enumerate(zip(expected["solids"], result.solids)):
            check_row(f"{name}, solid {i}", solid, row)
            check_equal(f"{name}, solid {i}: name and id", (solid["name"], solid["id"], solid["status"]), (row.name, row.id, row.status))


def check_brep_and_memory():
    """BREP files, plain and compressed, and bytes in memory."""
    from solidmoments.smReadersKernel import vtkBREPWriter
    from solidmoments.smReadersSTEP import vtkSTEPReader

    with open(sample, "rb") as file:
        check_row("STEP in memory", run(sample)[0]["total"], quietly("sample", content=file.read())[0])
    reader, writer = vtkSTEPReader(), vtkBREPWriter()
    reader.SetFileName(sample)
    writer.SetInputConnection(reader.GetOutputPort())
    with tempfile.TemporaryDirectory() as output:
        brep = os.path.join(output, "part.brep")
        writer.SetFileName(brep)
        check_equal("BREP is written", 1, writer.Write())
        expected = run(brep)[0]["total"]
        check_row("BREP", expected, quietly(brep)[0])
        volume = run(sample)[0]["total"]["volume"]
        check("BREP: volume of the STEP file", volume, expected["volume"], 1e-13 * volume)
        check_row("BREP in inches", run(brep, "--input-unit", "in")[0]["total"], quietly(brep, input_unit="inch")[0])
        check("BREP in inches: volume", volume * 25.4 ** 3, quietly(brep, input_unit="inch")[0].volume, 1e-12 * volume * 25.4 ** 3)
        with open(brep, "rb") as file:
            content = file.read()
        result = quietly("a name", content=bytearray(content))[0]
        check_row("BREP in memory", expected, result)
        check_equal("its name", "a name", result.file)
        try:
            solidmoments.mass_properties(sample, content=b"")
            check_true("an empty file is not a BREP file", False)
        except solidmoments.SolidMomentsError as error:
            check_true("an empty file is not a STEP file", "it is empty" in str(error), str(error))
        with open("/proc/self/maps", encoding="utf-8") as maps:
            check_equal("OpenCASCADE is not loaded here", [], [line for line in maps if "libTK" in line])
        step = os.path.join(output, "step.brep")
        shutil.copy(sample, step)
        check_row("a STEP file of another name", run(sample)[0]["total"], quietly(step)[0])
        check_equal("by the program, too", volume, run(step)[0]["total"]["volume"])
        os.remove(step)
        with zipfile.ZipFile(os.path.join(output, "both.zip"), "w") as file:
            file.writestr("part.brep", content)
            file.write(sample, "part.step")
        check_equal("the STEP file of an archive with both", volume, run(os.path.join(output, "both.zip"))[0]["total"]["volume"])
        os.remove(os.path.join(output, "both.zip"))
        with gzip.open(brep + ".gz", "wb") as file:
            file.write(content)
        check_row("BREP, compressed", run(brep + ".gz")[0]["total"], quietly(brep)[0])
        check_equal("a folder has both formats", 2, len(run(output)))
        kept = os.path.join(output, "kept.brep")
        os.rename(brep, kept)
        found = subprocess.run([program, sample, "--json", kept], capture_output=True, text=True, timeout=200, check=False)
        check_true("no output overwrites a BREP file", found.returncode == 1 and "would overwrite" in found.stderr, found.stderr)
        found = subprocess.run([program, kept, "--write-validation", os.path.join(output, "out.step")], capture_output=True, text=True,
                               timeout=200, check=False)
        check_true("validation properties go into STEP files only", found.returncode == 1 and "not a STEP file" in found.stderr, found.stderr)


def check_failures():
    def raised(error, *arguments, **options):
        try:
            solidmoments.mass_properties(*arguments, **options)
        except error as found:
            return found
        return None

    check_true("a missing file", raised(FileNotFoundError, os.path.join(folder, "no such file.step")))
    here = os.path.abspath(__file__)
    found = raised(solidmoments.SolidMomentsError, here)
    check_true("a file that is not a STEP file", found and found.status == "unreadable" and found.messages and str(found).startswith(here), str(found))
    found = raised(solidmoments.SolidMomentsError, os.path.join(folder, "no_geometry.step"))
    check_equal("a file without solids", "empty", found and found.status)
    for wrong in ({"density": -1.0}, {"density": 0.0}, {"density": math.nan}, {"density_tolerance": 2.0}, {"density_tolerance": math.nan}, {"tolerance": 2.0}, {"unit": "mile"}, {"input_unit": "file"}, {"backend": "gpu"},
                  {"repair": "sometimes"}, {"max_seconds": 0.0}, {"materials": [("*", "unobtainium", None)]}, {"materials": [("*", "oak", -5.0)]},
                  {"materials": [("*", "", None, -1.0)]}, {"materials": [("*", "", 700.0, 2.0)]}, {"materials": [("*", "oak", 700.0, None, 0.1)]},
                  {"materials": [("*", "", None, 2.0, 1.5)]}, {"hidden": "sometimes"}):
        found = raised(ValueError, sample, **wrong)
        check_true(f"{wrong} is refused", found is not None, str(found))
    # A Python without VTK, as of another installation.
    package = os.path.dirname(os.path.dirname(solidmoments.__file__))
    code = f"import sys; sys.path.append({package!r}); import solidmoments; solidmoments.mass_properties({sample!r})"
    done = subprocess.run([sys.executable, "-I", "-S", "-c", code], capture_output=True, text=True, timeout=200, check=False)
    last = done.stderr.strip().splitlines()[-1:]
    check_true("a Python without VTK names what to do",
               done.returncode == 1 and last and last[0].startswith("ImportError: solidmoments needs VTK's Python modules") and "PYTHONPATH" in last[0], str(last))
    # A tolerance that no run meets flags the result.
    result, flags = quietly(sample, tolerance=1e-15)
    check_equal("a tolerance that is not met", "tolerance-not-met", result.status)
    check_true("gives one warning with the status", len(flags) == 1 and "tolerance-not-met" in flags[0], str(flags))
    found = raised(solidmoments.SolidMomentsError, sample, tolerance=1e-15, strict=True)
    check_true("and an error with strict=True", found and found.properties and found.properties.volume == result.volume, str(found))


def check_texts():
    result, _ = quietly(sample, density=7850.0)
    check_equal("version", version, solidmoments.__version__)
    # The interpreter of display_mesh() has its version in its name, where there is such a name.
    python = solidmoments._version.PYTHON
    versioned = os.path.join(os.path.dirname(python), f"python{sys.version_info.major}.{sys.version_info.minor}")
    check_true("the interpreter", python == versioned or not os.path.exists(versioned), python)
    check_true("docstrings", all(getattr(solidmoments, name).__doc__ for name in solidmoments.__all__ if name != "__version__"))
    check_equal("units", ("mm^3", "mm^2", "mm", "mm^5", "kg", "kg mm^2", "1"),
                tuple(result.units[name] for name in ("volume", "area", "center_of_mass", "inertia", "mass", "mass_inertia", "principal_axes")))
    fields = {field.name for field in dataclasses.fields(result)}
    check_equal("every quantity with a bound has a unit", set(), {name[:-6] for name in fields if name.endswith("_bound")} - set(result.units))
    page = result._repr_html_()
    check_true("HTML: value, bound and unit", all(text in page for text in ("<td>volume</td>", "mm^3", "<td>mass</td>", "kg", "e-")), page[:120])
    check_true("HTML: names are escaped", "<b>&lt;a&gt;" in dataclasses.replace(result, name="<a>")._repr_html_())
    steel, _ = quietly(sample, materials=[("*", "oak", 700.0)])
    check_equal("a material of one's own", ("oak", 700.0), (steel.solids[0].material, steel.solids[0].density))
    stated, _ = quietly(sample, materials=[("*", "", None, 2.5, 0.01)])
    check_equal("a stated mass", (2.5, 2.5), (stated.mass, stated.overridden_mass))
    check_equal("in doubt by its tolerance", 0.025, stated.mass_uncertainty[4])
    scale = 2.5 / stated.volume
    check_true("the inertia is scaled to it", abs(stated.mass_inertia[0][0] - scale * stated.inertia[0][0]) <= stated.mass_inertia_bound)
    stated, _ = quietly(sample, materials=[("*", "", None, "250 g", "5 g")])
    check_equal("a mass as a text", (0.25, 0.25), (stated.mass, stated.overridden_mass))
    check("its tolerance", 0.005, stated.mass_uncertainty[4], 1e-17)
    check_equal("a mass in place of the density", 0.25, quietly(sample, materials=[("*", "", "250 g")])[0].mass)
    check_equal("a density as a text", 700.0, quietly(sample, materials=[("*", "oak", "700")])[0].solids[0].density)
    once, _ = quietly(sample, materials=[("*", "counted once", None), ("*", "oak", 700.0)])
    check_equal("one of each, with the material of another row", (True, "oak"),
                (any("no product occurs several times that the pattern * counts once" in text for text in once.messages), once.solids[0].material))
    for row, said in ((("*", "left out", 7850), "neither density nor mass"), (("*", "left out", None, 2.0), "neither density nor mass"),
                      (("*", "counted once", 7850), "states no material"), (("*", "counted once in place", None, 2.0), "states no material"),
                      (("*", "", None, "250 Mg"), "write t for 1000 kg"), (("*", "", None, 2.0, -0.5), "not a relative tolerance"),
                      (("*", "", None, 2.0, -1.0), "not a relative tolerance"), (("*", "", 7850, 2.0), "contradict each other"),
                      (("*", "", None, -2.0), "not a mass"), (("*", "unobtainium", None), "needs a density")):
        try:
            solidmoments.mass_properties(sample, materials=[row])
            check_true(f"{row} is refused", False)
        except ValueError as error:
            check_true(f"{row} is refused", said in str(error), str(error))
    hidden, _ = quietly(sample, hidden="skip")
    check_equal("nothing is hidden", result.volume, hidden.volume)


def check_table():
    try:
        import pandas
    except ImportError:  # the rows, without pandas to hold them
        print("pandas is not installed: a stand-in takes the rows")
        pandas = types.ModuleType("pandas")
        pandas.DataFrame = lambda rows: rows
        sys.modules["pandas"] = pandas
    missing = os.path.join(folder, "no such file.step")
    two = manifest.special("two_solids")["path"]
    table = solidmoments.to_dataframe([sample, missing, two], density=7850.0)
    rows = table if isinstance(table, list) else table.to_dict("records")
    check_equal("rows", [(sample, "total"), (sample, "solid"), (missing, "total"), (two, "total"), (two, "solid"), (two, "solid")],
                [(row["file"], row["row"]) for row in rows])
    check_equal("a missing file: status", "unreadable", rows[2]["status"])
    expected = run(sample, "--density", "7850")[0]["total"]
    check_equal("columns of components", (expected["center_of_mass"][1], expected["inertia"][0][2], expected["principal_axes"][2][0], expected["mass"]),
                (rows[0]["center_of_mass_y"], rows[0]["inertia_xz"], rows[0]["principal_axes_3_x"], rows[0]["mass"]))
    check_equal("one path", 2, len(solidmoments.to_dataframe(sample)))


def check_variants(box):
    """Faces of the box 2 x 3 x 5 that move along their normals, their edges stay: the volume is linear in the offsets."""
    import numpy

    areas = numpy.array([15.0, 15.0, 10.0, 10.0, 6.0, 6.0])
    c = numpy.random.default_rng(5).uniform(-0.2, 0.2, (1000, 6))
    for method in ("points", "polynomial"):
        variants = solidmoments.Variants(box, numpy.arange(6), [0.2] * 6, method=method)
        check_equal("method", method, variants.used_method)
        values, bounds, gradients = variants.evaluate(c, gradients=method == "polynomial")
        check_equal("shapes", ((1000, 10), (1000, 10)), (values.shape, bounds.shape))
        check_true("1000 volumes within their bounds", bool((abs(values[:, 0] - 30.0 - c @ areas) <= bounds[:, 0] + 1e-14).all()))
        check_true("bounds are small", bool((bounds[:, 0] < 1e-9).all()), f"up to {bounds[:, 0].max()}")
        if gradients is not None:
            check_equal("shape of the gradients", (1000, 10, 6), gradients.shape)
            check_true("derivatives are areas", bool((abs(gradients[:, 0] - areas) <= 1e-11).all()))
    for backend in ("cpu", "opengl"):
        device = solidmoments.Variants(box, numpy.arange(6), [0.2] * 6, method="points", backend=backend)
        check_true(f"{backend}: used, or the reason why not", device.used_backend == backend or "no OpenGL" in device.reason, device.reason)
        values, bounds, _ = device.evaluate(c)
        check_true(f"{backend}: 1000 volumes within their bounds", bool((abs(values[:, 0] - 30.0 - c @ areas) <= bounds[:, 0] + 1e-14).all()))
    fractions = []
    solidmoments.Variants(box, [0], method="points", progress=fractions.append)
    check_true("progress", len(fractions) > 0 and sorted(fractions) == fractions, str(fractions))

    def fail(fraction):
        raise KeyError("own")

    for what, words, call in (("stopped", "stopped", lambda fraction: False), ("an exception of progress", "own", fail)):
        try:
            solidmoments.Variants(box, [0], method="points", progress=call)
            check_true(what, False, "nothing was raised")
        except (ValueError, KeyError) as error:
            check_true(what, words in str(error), str(error))
    up = numpy.tile([0.0, 0.0, 1.0], (2, 2, 1))
    rise = solidmoments.Variants(box, [{1: up}], method="polynomial")
    check("a face that slides along its edges", 30.0, float(rise.evaluate([0.5]).values[0, 0]), 1e-11)
    for what, words, call in (("numbers of another shape", "shape", lambda: rise.evaluate([0.5, 0.1])), ("ranges that do not fit", "ranges", lambda: solidmoments.Variants(box, [0], [1, 2])),
                              ("a face that is not there", "face 9", lambda: solidmoments.Variants(box, [9])),
                              ("no such backend", "backend", lambda: solidmoments.Variants(box, [0], backend="fast")),
                              ("no such method", "method", lambda: solidmoments.Variants(box, [0], method="fast"))):
        try:
            call()
            check_true(what, False, "nothing was raised")
        except ValueError as error:
            check_true(what, words in str(error), str(error))


def check_model():
    """A box from NumPy arrays, with a face of degree 2 in u: exact, and refused arrays."""
    import numpy

    size = numpy.array([2.0, 3.0, 5.0])
    model = solidmoments.Model("a box", length_unit="cm")
    corners = numpy.array([[i & 1, i >> 1 & 1, i >> 2] for i in range(8)]) * size
    edges = {}
    for first in range(8):
        for axis in (1, 2, 4):
            if not first & axis:
                edges[first, first | axis] = model.add_edge([0.0, 1.0], corners[[first, first | axis]])
    knots = numpy.array([0.0, 0.0, 1.0, 1.0])
    unit = numpy.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    for axis, u, v in ((1, 2, 4), (2, 4, 1), (4, 1, 2)):
        for base in (0, axis):  # on the far side of the axis the normal is outward
            points = corners[[[base, base | u], [base | v, base | u | v]]]
            if axis == 4:  # the same plane by three columns of rational points
                middle = numpy.concatenate([points[:, :1], points.mean(axis=1, keepdims=True), points[:, 1:]], axis=1)
                weights = numpy.array([1.0, 2.0, 1.0])[None, :, None] * numpy.ones((2, 1, 1))
                face = model.add_face(2, numpy.repeat([0.0, 1.0], 3), 1, knots, numpy.concatenate([middle * weights, weights], axis=2), base == 0)
            else:
                face = model.add_face(1, knots, 1, knots, points, reversed=base == 0)
            ring = [base, base | u, base | u | v, base | v]
            for k in range(4):
                ends = ring[k], ring[(k + 1) % 4]
                backwards = ends[0] > ends[1]
                line = unit[[k, (k + 1) % 4]]
                model.add_coedge(face, 0, edges[min(ends), max(ends)], backwards, [0.0, 1.0], line[::-1] if backwards else line)
    box = model.mass_properties(density=1000.0)
    check_equal("box: status, name, unit", ("ok", "a box", "cm"), (box.status, box.solids[0].name, box.length_unit))
    check("box: volume", size.prod(), box.volume, box.volume_bound)
    check("box: area", 2.0 * (size[0] * size[1] + size[1] * size[2] + size[2] * size[0]), box.area, box.area_bound)
    check("box: mass, kg", 1e-3 * size.prod(), box.mass, box.mass_bound)
    for i in range(3):
        check(f"box: centre {i}", 0.5 * size[i], box.center_of_mass[i], box.center_of_mass_bound)
    check_variants(model)
    for what, words, call in (("knots that decrease", "decrease", lambda: model.add_face(1, knots[::-1], 1, knots, numpy.zeros((2, 2, 3)))),
                              ("a net that is reversed", "shape (2, 3, 3)", lambda: model.add_face(1, numpy.array([0.0, 0, 1, 1]), 1, numpy.array([0.0, 0, 0.5, 1, 1]), numpy.zeros((2, 3, 3)))),
                              ("a missing control point", "control points", lambda: model.add_face(1, knots, 1, knots, numpy.zeros((3, 3)))),
                              ("a flat curve", "shape", lambda: model.add_edge([0.0, 1.0], [0.0, 1.0])),
                              ("an edge that is not there", "does not exist", lambda: model.add_coedge(0, 0, 12, False, [0.0, 1.0], unit[:2])),
                              ("a unit", "mile", lambda: solidmoments.Model(length_unit="mile"))):
        try:
            call()
            check_true(what + " is refused", False)
        except ValueError as error:
            check_true(what + " is refused", words in str(error), str(error))
    check_equal("the model stays", box.volume, model.mass_properties().volume)


check_same()
check_model()
check_brep_and_memory()
check_failures()
check_texts()
check_table()
finish()

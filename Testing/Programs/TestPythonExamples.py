"""TestPythonExamples.py FLAVOUR ...: the scripts of Examples/Python as a user runs them.

FLAVOUR: vtk (mass_properties.py) or paraview (paraview_mass_properties.py). Values are those of `solidmoments`, bit for bit, and of
formulas; the picture is that of BASELINES/TestPythonExamples_FLAVOUR.png; mistakes end with sentences and the right exit status.
"""
import argparse
import csv
import io
import json
import os
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check, check_equal, check_true, check_values, finish  # noqa: E402
from smpicture import check_noticed, check_picture, read_picture  # noqa: E402

parser = argparse.ArgumentParser()
parser.add_argument("flavour", choices=["vtk", "paraview"])
parser.add_argument("--without-errors", action="store_true")
for name in ("--interpreter", "--examples", "--plugin", "--program", "--solids", "--output", "--baselines"):
    parser.add_argument(name, required=True)
options = parser.parse_args()
manifest = Manifest(options.solids)
is_paraview = options.flavour == "paraview"
script = os.path.join(options.examples, "Python", "paraview_mass_properties.py" if is_paraview else "mass_properties.py")
sample = os.path.join(options.examples, "Models", "sample_part.step")


def run(*arguments, **environment):
    """`environment`: variables to set, or with None to take away."""
    variables = dict(os.environ, PYTHONDONTWRITEBYTECODE="1")
    for variable, value in environment.items():
        variables.pop(variable, None)
        if value is not None:
            variables[variable] = value
    command = [options.interpreter, script] + (["--plugin", options.plugin] if is_paraview else []) + list(arguments)
    result = subprocess.run(command, capture_output=True, text=True, timeout=200, env=variables, check=False)
    print("$", os.path.basename(script), *arguments, environment or "", "->", result.returncode)
    return result


def run_often(argument_lists):
    """One result for each list of arguments, of one interpreter: it takes seconds to start."""
    plugin = ["--plugin", options.plugin] if is_paraview else []
    command = [options.interpreter, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support", "run_script_often.py"),
               script, json.dumps([plugin + arguments for arguments in argument_lists])]
    result = subprocess.run(command, capture_output=True, text=True, timeout=200,
                            env=dict(os.environ, PYTHONDONTWRITEBYTECODE="1"), check=False)
    lines = [line for line in result.stdout.splitlines() if line.startswith('[{"status"')]
    if not check_equal("exit status of the interpreter, results", (0, 1), (result.returncode, len(lines))):
        print(result.stdout, result.stderr, sep="\n")
        finish()
    for arguments, one in zip(argument_lists, json.loads(lines[0])):
        print("$", os.path.basename(script), *arguments, "->", one["status"])
        yield subprocess.CompletedProcess(arguments, one["status"], one["stdout"], one["stderr"])


def check_status(expected, result):
    if not check_equal("exit status", expected, result.returncode):
        print(result.stdout, result.stderr, sep="\n")


def in_output(name):
    where = "display" if os.environ.get("DISPLAY") else "none"
    path = os.path.join(options.output, f"python_example_{options.flavour}_{os.path.basename(options.interpreter)}_{where}_{name}")
    if os.path.isdir(path):
        shutil.rmtree(path)
    elif os.path.exists(path):
        os.remove(path)
    return path


def check_row(row, entry):
    """A row of the CSV against an entry of the JSON: equal as doubles, so in every bit."""
    inertia = entry["inertia"]
    expected = {"volume": entry["volume"], "area": entry["area"], "mass": entry["mass"], "mass_bound": entry["bounds"]["mass"]}
    expected.update(zip(("center_x", "center_y", "center_z"), entry["center_of_mass"]))
    expected.update({"inertia_xx": inertia[0][0], "inertia_yy": inertia[1][1], "inertia_zz": inertia[2][2],
                     "inertia_xy": inertia[0][1], "inertia_yz": inertia[1][2], "inertia_xz": inertia[0][2]})
    expected.update({column + "_bound": entry["bounds"][key] for column, key in
                     (("volume", "volume"), ("area", "area"), ("center", "center_of_mass"), ("inertia", "inertia"))})
    expected.update({f"principal_{i + 1}": entry["principal_moments"][i] for i in range(3)})
    expected.update({column: entry[column] for column in
                     ("closure_correction", "gap_squared", "max_gap", "gap_area", "open_edges", "closure_residual")})
    for column, value in expected.items():
        check(f"{row['row']} {row['id']} {column}", value, float(row[column]), 0.0, "(same bits)")


# The functions below yield lists of arguments, and get the results of one interpreter for all of them.


def values():
    part = manifest.solid("slanted_hole", "moved")
    paths = [part["path"], manifest.special("two_solids")["path"]]
    table = in_output("table.csv")
    results = yield [["--density", "7850", "--csv", table, *paths], ["--csv", "-", "--unit", "cm", part["path"]]]
    result = next(results)
    check_status(0, result)
    with open(table, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    program = subprocess.run([options.program, "--density", "7850", "--json", "-", *paths], capture_output=True, text=True,
                             timeout=200, check=True)
    entries = []
    for file in json.loads(program.stdout)["files"]:
        backend = file["backend"]
        entries += [dict(file["total"], status=file["status"], name="", id="")] + file["solids"]
    check_equal("rows", [("total", ""), ("solid", "1"), ("total", ""), ("solid", "1"), ("solid", "2")],
                [(row["row"], row["id"]) for row in rows])
    for row, entry in zip(rows, entries):
        check_equal("file, name, status, unit", [entry["name"], entry["status"], "mm"],
                    [row["name"], row["status"], row["length_unit"]])
        check_row(row, entry)
    # One schema: the columns are some of the program's, with its values.
    listed = subprocess.run([options.program, "--density", "7850", "--csv", "-", *paths], capture_output=True, text=True, timeout=200,
                            check=True)
    for row, other in zip(rows, csv.DictReader(io.StringIO(listed.stdout))):
        check_equal("columns that the program does not have", [], sorted(set(row) - set(other)))
        check_equal("columns with another value", [], [column for column in row if row[column] != other[column] and
                                                       float(row[column] or "nan") != float(other[column] or "nan")])
    first = {column: float(rows[0][column]) for column in rows[0] if column.startswith(("volume", "area", "center", "inertia"))}
    xx, yy, zz, xy, yz, xz = (first["inertia_" + axes] for axes in ("xx", "yy", "zz", "xy", "yz", "xz"))
    check_values(part, first["volume"], first["area"], [first["center_" + axis] for axis in "xyz"],
                 [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])

    lines = result.stdout.splitlines()
    for words in ([f"by {backend} on"], ["solid", "volume mm^3", "area mm^2", "mass kg", "centre of mass mm", "status"],
                  ["13789.2036", "0.1082452488", "ok"], ["total", "10188.7902"]):
        check_true(f"a line has {words}", any(all(word in line for word in words) for line in lines), result.stdout)
    # CSV on the standard output is alone there; the unit is what was asked for.
    result = next(results)
    check_status(0, result)
    rows = list(csv.DictReader(io.StringIO(result.stdout)))
    check_equal("rows on the standard output", 2, len(rows))
    check("volume in cm^3", part["volume"] / 1000.0, float(rows[1]["volume"]), 1e-9 * part["volume"] / 1000.0)
    check_equal("no mass without a density", "", rows[1]["mass"])
    check_true("the table is on the other stream", "volume cm^3" in result.stderr, result.stderr)


def picture():
    expected = read_picture(os.path.join(options.baselines, f"TestPythonExamples_{options.flavour}.png"))
    alone, path = in_output("part.png"), in_output("several.png")
    opened = manifest.special("open_solid")["path"]
    # Each of several files has a picture of its own; an open solid's text is red.
    results = yield [["--density", "7850", "--png", alone, sample], ["--density", "7850", "--png", path, sample, opened]]
    for status, result in zip((0, 3), results):
        check_status(status, result)
    check_picture("the sample part", expected, read_picture(alone))
    check_picture("the first of two", expected, read_picture(path[:-4] + "-sample_part.png"))
    other = read_picture(path[:-4] + "-open_solid.png")
    check_noticed("the second is another part", expected, other)
    red = int(((other[:, :, 0] > other[:, :, 1] + 100) & (other[:, :, 0] > other[:, :, 2] + 100)).sum())
    check_true("red pixels of its text", red > 300, str(red))


def errors():
    box = manifest.solid("box")["path"]
    mistakes = [([], "required"), (["--density", "-1", box], "density"), (["--density", "nan", box], "density"),
                (["--png", "a.png", "a/x.step", "b/x.step"], "one picture")]
    if is_paraview:  # both have the same parser
        del mistakes[1:]
    results = yield ([["missing.step", box], [os.path.join(options.solids, "not_step.step")],
                         [manifest.special("open_shell")["path"]], [manifest.special("open_solid")["path"], "missing.step"],
                         ["--csv", "/nonexistent/table.csv", box], ["--png", "/nonexistent/part.png", box]]
                        + [arguments for arguments, words in mistakes])
    result = next(results)
    check_status(2, result)
    check_true("names the file", "missing.step is unreadable" in result.stderr, result.stderr)
    check_true("the next one is weighed", "6000" in result.stdout, result.stdout)
    result = next(results)
    check_status(2, result)
    check_true("says why", "it is not a STEP file" in result.stderr, result.stderr)
    check_status(3, next(results))
    check_status(2, next(results))
    result = next(results)
    check_status(1, result)
    check_true("no table", "/nonexistent/table.csv cannot be written" in result.stderr, result.stderr)
    result = next(results)
    check_status(1, result)
    check_true("no picture", "no picture /nonexistent/part.png: " in result.stderr, result.stderr)
    check_true("but numbers", "6000" in result.stdout, result.stdout)
    for _, words in mistakes:
        result = next(results)
        check_status(1, result)
        check_true("says what is wrong", words in result.stderr, result.stderr)

    # A VTK that does not load.
    broken = in_output("broken_vtk")
    for package in ("vtkmodules", "paraview"):
        os.makedirs(os.path.join(broken, package), exist_ok=True)
        with open(os.path.join(broken, package, "__init__.py"), "w", encoding="ascii") as file:
            file.write('raise ImportError("it is broken")\n')
    for name in (["paraview_mass_properties.py"] if is_paraview else ["mass_properties.py", "mass_properties_batch.py"]):
        result = subprocess.run([sys.executable, os.path.join(options.examples, "Python", name), box], capture_output=True, text=True,
                                timeout=100, env=dict(os.environ, PYTHONPATH=broken, PYTHONDONTWRITEBYTECODE="1"), check=False)
        check_status(1, result)
        check_true(name + " names PYTHONPATH", "PYTHONPATH" in result.stderr, result.stderr)
        check_true(name + " prints no stack", "Traceback" not in result.stderr, result.stderr)

    # The script needs something that it does not find.
    if is_paraview:
        options.plugin = "/nonexistent/SolidMoments.so"
        result, words = run(box), "/nonexistent/SolidMoments.so"
    else:
        vtk_alone = os.environ["PYTHONPATH"].split(":", 1)[1]  # the first is ours
        result, words = run(box, PYTHONPATH=vtk_alone), "PYTHONPATH has to name"
    check_status(1, result)
    check_true("says what is missing", words in result.stderr, result.stderr)


def nowhere_to_draw():
    """The numbers are there all the same."""
    box = manifest.solid("box")["path"]
    path = in_output("nowhere.png")
    if is_paraview:
        nowhere = [{"DISPLAY": None}, {"DISPLAY": ":98765"}]
    else:
        nowhere = [{"DISPLAY": display, "__EGL_VENDOR_LIBRARY_DIRS": "/nonexistent"} for display in (None, ":98765")]
    for environment in nowhere:
        result = run("--png", path, box, **environment)
        check_status(1, result)
        check_true("no picture", f"no picture {path}: " in result.stderr, result.stderr)
        check_true("no file", not os.path.exists(path))
        check_true("but numbers", "6000" in result.stdout, result.stdout)
        check_true("by what there is", is_paraview or "by cpu on" in result.stdout, result.stdout)


parts = [values(), picture()] + ([] if options.without_errors else [errors()])
lists = [next(part) for part in parts]
results = run_often([arguments for some in lists for arguments in some])
if not options.without_errors:
    nowhere_to_draw()
for part, some in zip(parts, lists):
    try:
        part.send(iter([next(results) for _ in some]))
    except StopIteration:
        pass
finish()

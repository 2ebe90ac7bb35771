"""TestStartLibraries.py --program SOLIDMOMENTS --libraries FOLDER --wrong FOLDER --file FILE.step --output FOLDER [--python PYTHON]

What is loaded on demand. The program, and Python, read and integrate a STEP file on the CPU without OpenGL, X11 and VTK's classes for drawing and
filters; OpenGL, pictures, meshes and sections bring their libraries. If one of these is missing, damaged or of another version, everything else
is computed as ever, and the reason is reported.
"""
import argparse
import json
import os
import re
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check_equal, check_true, finish  # noqa: E402

parser = argparse.ArgumentParser()
for option in ("--program", "--libraries", "--wrong", "--file", "--output"):
    parser.add_argument(option, required=True)
parser.add_argument("--python")
options = parser.parse_args()
FINDER = "libsmFiltersCommon.so"  # looks for the other libraries in its folder
OPENGL = "libsmRenderingOpenGL.so"
EXTRAS = "libsmExtras.so"
# A context of the user's takes OpenGL where it can.
FALL_BACK = """
import sys
from solidmoments.smFiltersMassProperties import vtkMassPropertiesGPU
from solidmoments.smReadersSTEP import vtkSTEPReader
from solidmoments.smRenderingCompute import vtkComputeContext
reader = vtkSTEPReader()
reader.SetFileName(sys.argv[1])
mass = vtkMassPropertiesGPU()
mass.SetInputConnection(reader.GetOutputPort())
mass.GetComputeContext().SetSource(vtkComputeContext.EGL)
mass.Update()
print(mass.GetBackendName(), mass.GetBackendReason(), sep="\\n")
"""
SELDOM = re.compile(r"lib(GL|GLX|EGL|GLEW|OpenGL|X11|xcb|mpi|freetype|TK\w*|vtkRendering\w+|vtkFilters\w+|vtkCharts\w+|vtkIO(Image|XML|Geometry|PLY)|"
                    r"smRenderingOpenGL|smExtras)[.-]")


def run(arguments, libraries=None):
    """The exit status, the entry of the file in JSON, and what is printed besides."""
    environment = dict(os.environ)
    if libraries:
        environment["LD_LIBRARY_PATH"] = libraries + ":" + environment.get("LD_LIBRARY_PATH", "")
    result = subprocess.run([options.program, "--json", "-", *arguments, options.file], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            env=environment, check=False, timeout=300, encoding="utf-8")
    return result.returncode, json.loads(result.stdout)["files"][0] if result.stdout else None, result.stderr


def list_loaded(command):
    """Names of the libraries that a command and its processes have loaded, by the loader's own account, and the exit status."""
    log = os.path.join(options.output, "start_libraries")
    for name in os.listdir(options.output):
        if name.startswith("start_libraries."):
            os.remove(os.path.join(options.output, name))
    done = subprocess.run(command, env={**os.environ, "LD_DEBUG": "files", "LD_DEBUG_OUTPUT": log}, stdout=subprocess.DEVNULL, check=False,
                          timeout=300)
    loaded = set()
    for name in os.listdir(options.output):
        if name.startswith("start_libraries."):
            with open(os.path.join(options.output, name), encoding="utf-8", errors="replace") as file:
                loaded.update(os.path.basename(path) for path in re.findall(r"calling init: (\S+)", file.read()))
            os.remove(os.path.join(options.output, name))
    return loaded, done.returncode


def check_loaded(what, command, wanted, unwanted=SELDOM):
    """The command loads the libraries whose names begin as wanted, and none that matches unwanted."""
    loaded, code = list_loaded(command)
    check_equal(f"{what}: exit status", 0, code)
    check_true(f"{what}: the loader's account", any(name.startswith("libc.so") for name in loaded), f"{len(loaded)} libraries")
    for name in wanted:
        check_true(f"{what}: {name} is loaded", any(other.startswith(name) for other in loaded))
    found = sorted(name for name in loaded if unwanted and unwanted.match(name))
    check_equal(f"{what}: seldom needed libraries of {len(loaded)}", [], found)


def make_libraries(name, replaced):
    """A folder with links to all libraries, but those of `replaced`: path of the file in the place of one, or None."""
    folder = os.path.join(options.output, name)
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    for library in os.listdir(options.libraries):
        if library.startswith("libsm") and library not in replaced:
            make = shutil.copy if library == FINDER else os.symlink
            make(os.path.join(options.libraries, library), os.path.join(folder, library))
    for library, path in replaced.items():
        if path:
            shutil.copy(path, os.path.join(folder, library))
    return folder


def get_values(entry):
    """What must not depend on a library for something else."""
    return [entry["status"], entry["backend"], entry["total"]["volume"], entry["total"]["bounds"], entry["solids"][0]["inertia"]]


def check_problem(what, library, path, reason):
    """A library that is missing or wrong is a reason, and no crash."""
    folder = make_libraries("start_" + re.sub(r"\W", "_", what), {library: path})
    plain = run(["--backend", "cpu"])
    code, entry, errors = run([], folder)
    check_equal(f"{what}: exit status without the library", 0, code)
    check_equal(f"{what}: values", get_values(plain[1]), get_values(entry))
    if library == OPENGL:
        code, entry, errors = run(["--backend", "opengl"], folder)
        check_equal(f"{what}: OpenGL", [3, "not-computed", "none"], [code, entry["status"], entry["backend"]])
        check_true(f"{what}: its reason", any(reason in message for message in entry["messages"]), str(entry["messages"]))
        code, entry, errors = run(["--integral", "east=normal.x * dA"], folder)
        check_true(f"{what}: the reason of an expression, which wants OpenGL", any(reason in message for message in entry["messages"]),
                   str(entry["messages"]))
        if options.python:
            printed = subprocess.run([options.python, "-c", FALL_BACK, options.file], env={**os.environ, "LD_LIBRARY_PATH": folder},
                                     stdout=subprocess.PIPE, check=False, timeout=300, encoding="utf-8").stdout.split("\n")
            check_equal(f"{what}: the backend in place of OpenGL", "cpu", printed[0])
            check_true(f"{what}: its reason", reason in printed[1], printed[1])
        return
    mesh = os.path.join(options.output, "start.stl")
    if os.path.exists(mesh):
        os.remove(mesh)
    code, entry, errors = run(["--backend", "cpu", "--mesh", mesh], folder)
    check_equal(f"{what}: a mesh", [1, False], [code, os.path.exists(mesh)])
    check_true(f"{what}: its reason", reason in errors, errors)
    check_equal(f"{what}: the values with it", get_values(plain[1]), get_values(entry))
    code, entry, errors = run(["--backend", "cpu", "--section", "0,0,1,0,0,1"], folder)
    check_equal(f"{what}: a section", [3, "not-computed"], [code, entry["status"]])
    check_true(f"{what}: its reason", any(reason in message for message in entry["messages"]), str(entry["messages"]))


cpu = [options.program, "--quiet", "--backend", "cpu"]
check_loaded("--version", [options.program, "--version"], ["libsmFiltersMassProperties"])
check_loaded("a file on the CPU", [*cpu, options.file], ["libsmReadersSTEP"])
check_loaded("by the estimate", [options.program, "--quiet", options.file], ["libsmReadersSTEP"])
# They are seen where they are needed.
check_loaded("a mesh", [*cpu, "--mesh", os.path.join(options.output, "start.stl"), options.file], [EXTRAS, "libvtkIOGeometry"], None)
check_loaded("a section", [*cpu, "--section", "0,0,1,0,0,1", options.file], [EXTRAS, "libvtkFiltersGeneral"], None)
check_loaded("OpenGL", [options.program, "--quiet", "--backend", "opengl", options.file], [OPENGL, "libvtkRenderingOpenGL2", "libEGL"], None)
if options.python:
    python = ["import solidmoments", f"solidmoments.mass_properties({options.file!r}, backend='cpu')"]
    check_loaded("import solidmoments", [options.python, "-c", python[0]], ["libc.so"], re.compile(r"lib(vtk|sm)"))
    late = subprocess.run([options.python, "-c", f"{python[0]}, sys; print(sorted({{'decimal', 'html', 'json', 'numpy', 'subprocess', 'tempfile'}} & set(sys.modules)))"],
                          stdout=subprocess.PIPE, check=True, timeout=300, encoding="utf-8").stdout
    check_equal("import solidmoments: modules that functions import", "[]\n", late)
    check_loaded("mass_properties()", [options.python, "-c", "; ".join(python)], ["libsmFiltersMassProperties"])

damaged = os.path.join(options.output, "start_damaged.so")
with open(damaged, "w", encoding="utf-8") as text:
    text.write("not a library\n")
for file_name, entry_name in ((OPENGL, "smWrongOpenGL"), (EXTRAS, "smWrongExtras")):
    check_problem(f"{file_name} is missing", file_name, None, f"the library {file_name} was not found in ")
    check_problem(f"{file_name} is damaged", file_name, damaged, f"the library {file_name} cannot be loaded (")
    check_problem(f"{file_name} is old", file_name, os.path.join(options.wrong, f"lib{entry_name}.so"), f"the library {file_name} is of 0.0.0, not of ")
    check_problem(f"{file_name} is another one", file_name, os.path.join(options.libraries, "libsmFiltersBezier.so"), "is of an unknown version, not of ")
finish()

"""Proves by the compiler that a module includes headers of the rooms below it and none of those above or next to it, and that vtk.module
files and the table of Documentation/DeveloperGuide.md name the same rooms. Checks that the path of a header says who includes it.

    check_arrows.py --compiler C++ --modules FILE --source FOLDER

FILE has a line "name|include directories separated by ;|definitions separated by ;" for every module, as CMake compiles it. With
these directories one file that includes a header of each room below is compiled, and one for each header that must not be found.
"""
import argparse
import glob
import os
import re
import subprocess
import sys
import tempfile

# Room -> folder, rooms it includes; what these include is allowed, too.
ROOMS = {
    "FiltersCommon": ("Filters/Common", []),
    "FiltersBezier": ("Filters/Bezier", ["FiltersCommon"]),
    "FiltersNURBS": ("Filters/NURBS", ["FiltersBezier"]),
    "FiltersQuadrature": ("Filters/Quadrature", ["FiltersNURBS"]),
    "FiltersSurfaceIntegrals": ("Filters/SurfaceIntegrals", ["FiltersQuadrature", "RenderingCompute", "RenderingNURBS"]),
    "FiltersMassProperties": ("Filters/MassProperties", ["FiltersSurfaceIntegrals"]),
    "FiltersProducts": ("Filters/Products", ["FiltersMassProperties"]),
    "FiltersStability": ("Filters/Stability", ["FiltersMassProperties"]),
    "FiltersBuoyancy": ("Filters/Buoyancy", ["FiltersSurfaceIntegrals"]),
    "FiltersSection": ("Filters/Section", ["FiltersBuoyancy"]),
    "FiltersMomentSchemes": ("Filters/MomentSchemes", ["FiltersMassProperties", "RenderingCompute", "RenderingNURBS"]),
    "FiltersNURBSEdit": ("Filters/NURBSEdit", ["FiltersNURBS"]),
    "FiltersMomentGradient": ("Filters/MomentGradient", ["FiltersMassProperties", "FiltersNURBSEdit", "RenderingCompute", "RenderingNURBS"]),
    "FiltersVariants": ("Filters/Variants", ["FiltersMassProperties", "RenderingCompute"]),
    "FiltersTessellation": ("Filters/Tessellation", ["FiltersNURBS"]),
    "RenderingCompute": ("Rendering/Compute", ["FiltersCommon"]),
    "RenderingOpenGL": ("Rendering/OpenGL", ["RenderingCompute"]),
    "RenderingNURBS": ("Rendering/NURBS", ["RenderingCompute", "FiltersNURBS"]),
    "ReadersFaces": ("Readers/Faces", ["FiltersNURBS"]),
    "ReadersPart21": ("Readers/Part21", ["FiltersCommon"]),
    "ReadersKernel": ("Readers/Kernel", ["ReadersFaces", "FiltersNURBS"]),
    "ReadersSTEP": ("Readers/STEP", ["ReadersFaces", "ReadersKernel", "ReadersPart21", "FiltersTessellation", "FiltersNURBS"]),
    "ReadersBREP": ("Readers/BREP", ["ReadersKernel", "ReadersSTEP"]),
}


def below(room):
    """All rooms that a room may include."""
    found = set()
    for other in ROOMS[room][1]:
        found |= {other} | below(other)
    return found


def choose_header(source, room):
    """The first class of VTK of a room, or else its first header."""
    headers = sorted(glob.glob(os.path.join(source, ROOMS[room][0], "*.h")), key=lambda path: (not os.path.basename(path).startswith("vtk"), path))
    headers = [path for path in headers if not path.endswith("Internals.h")]
    return os.path.basename(headers[0]) if headers else None


def compile_includes(compiler, includes, definitions, headers, folder):
    path = os.path.join(folder, "arrow.cxx")
    with open(path, "w", encoding="utf-8") as file:
        file.writelines(f'#include "{header}"\n' for header in headers)
    command = [compiler, "-std=c++17", "-fsyntax-only"] + ["-D" + word for word in definitions]
    command += ["-I" + word for word in includes] + [path]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def check_room(options, modules, room, folder):
    """Problems in words: what the room may include compiles, and each header that it may not include is not found."""
    headers = {other: choose_header(options.source, other) for other in modules}
    if None in headers.values():
        return [f"{other} has no header" for other in modules if headers[other] is None]
    problems = []
    allowed = [headers[other] for other in modules if other == room or other in ROOMS[room][1]]
    done = compile_includes(options.compiler, *modules[room], allowed, folder)
    if done.returncode != 0:
        problems.append(f"{room} cannot include one of {', '.join(allowed)}:\n{done.stderr}")
    for other in set(modules) - below(room) - {room}:
        done = compile_includes(options.compiler, *modules[room], [headers[other]], folder)
        # The compiler must not find this very header; another error would prove nothing.
        if not re.search(f"{re.escape(headers[other])}'?:? (No such file|file not found)", done.stderr):
            problems.append(f"{room} can include {headers[other]} of {other}")
    return problems


def check_statements(source):
    """Problems in words: a vtk.module file or the table of the developer guide that names other rooms than ROOMS."""
    problems = []
    with open(os.path.join(source, "Documentation", "DeveloperGuide.md"), encoding="utf-8") as file:
        table = file.read().split("| Folder | Includes headers of |")[1].split("\n\n")[0]
    rows = dict(re.findall(r"^\| `([^`]+)` \| ([^|]*) \|", table, re.MULTILINE))
    for room, (folder, rooms) in ROOMS.items():
        with open(os.path.join(source, folder, "vtk.module"), encoding="utf-8") as file:
            text = file.read()
        named = re.findall(r"SolidMoments::(\w+)", text[text.index("\nDEPENDS"):])
        if sorted(named) != sorted(rooms):
            problems.append(f"{folder}/vtk.module names {sorted(named)}, not {sorted(rooms)}")
        folders = sorted(ROOMS[other][0] for other in rooms)
        named = sorted(re.findall(r"`([^`]+)`", rows.get(folder, "")))
        if folder not in rows or named != folders:
            problems.append(f"DeveloperGuide.md gives {folder} the arrows {named}, not {folders}")
    return problems


def list_installed(folder):
    """The headers that the CMakeLists.txt of a module installs."""
    with open(os.path.join(folder, "CMakeLists.txt"), encoding="utf-8") as file:
        text = file.read()
    listed = " ".join(re.findall(r"set\((?:nowrap_)?headers([^)]*)\)", text)).split()
    return listed + [name + ".h" for name in " ".join(re.findall(r"set\(classes([^)]*)\)", text)).split()]


def check_header_kinds(source):
    """Problems in words: the path of a header says who includes it. Those in a folder below the one of their module are the module's own (and
    its tests'); others are installed, or another module or program includes them."""
    problems = []
    users = {}
    for room in ("Filters", "Rendering", "Readers", "ParaViewPlugin", "Examples"):
        for path in glob.glob(os.path.join(source, room, "**", "*.*"), recursive=True):
            if path.endswith((".h", ".cxx")):
                with open(path, encoding="utf-8") as file:
                    for name in re.findall(r'#include "(?:.*/)?([^"/]+)"', file.read()):
                        users.setdefault(name, []).append(os.path.relpath(path, source))
    for folder, _ in ROOMS.values():
        # The rooms of the readers are not parted yet.
        if folder.startswith("Readers/"):
            continue
        root = os.path.join(source, folder)
        installed = list_installed(root)
        for path in glob.glob(os.path.join(root, "**", "*.h"), recursive=True):
            name = os.path.relpath(path, root)
            others = [user for user in users.get(os.path.basename(path), []) if not user.startswith(folder + "/")]
            if "/" in name and (others or name in installed):
                problems.append(f"{folder}/{name} is not its module's own: {', '.join(others) or 'it is installed'}")
            elif "/" not in name and not others and name not in installed:
                problems.append(f"{folder}/{name} is its module's own and belongs into a folder below, Detail/ for example")
    return problems


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("--compiler", "--modules", "--source"):
        parser.add_argument(name, required=True)
    options = parser.parse_args()
    modules = {}
    with open(options.modules, encoding="utf-8") as file:
        for line in file:
            name, includes, definitions = line.rstrip("\n").split("|")
            modules[name] = ([word for word in includes.split(";") if word], [word for word in definitions.split(";") if word])
    problems = [f"{name} is not a room of the table" for name in modules if name not in ROOMS] + check_statements(options.source)
    problems += check_header_kinds(options.source)
    with tempfile.TemporaryDirectory() as folder:
        for room in set(modules) & set(ROOMS):
            problems += check_room(options, modules, room, folder)
    for problem in problems:
        print("FAIL", problem)
    print(f"{len(modules)} modules, {len(problems)} failures")
    return 1 if problems or len(modules) < 6 else 0


if __name__ == "__main__":
    sys.exit(main())

"""The display mesh of a file as NumPy arrays, read by another process.

That process has the VTK that this package was built with. This process may have loaded another VTK, for example that of PyVista's wheel,
and two VTKs in one process do not work. Only bytes are passed between the two processes.
"""
import dataclasses
import os
import sys

from . import _arguments as arguments
from ._results import SolidMomentsError
from ._version import PYTHON, VTK_FOLDER


@dataclasses.dataclass(frozen=True)
class SolidMesh:
    """Triangles of a solid or shell, for display: within a deflection of the exact faces, which the mass properties are computed from.

    points: (n, 3), in `length_unit`. triangles: (m, 3), indices of points. cell_data and point_data: arrays by name, among them FaceIndex (the face
    in the file's order, from 0), Color (red, green, blue, 0 to 255) and, of points, Parameters (u, v of the face).
    """

    file: str
    name: str
    length_unit: str
    points: "numpy.ndarray"  # noqa: F821
    triangles: "numpy.ndarray"  # noqa: F821
    cell_data: dict
    point_data: dict


def display_mesh(file, *, unit="mm", input_unit="mm", deflection=0.001):
    """The SolidMesh of each solid and shell of a STEP or BREP file, in the order of `mass_properties(file).solids`. Needs NumPy.
    Shells are oriented as in the file: mass_properties() reverses those that are inside out, and says so in its messages.

    file: path. unit: of lengths, mm, cm, m, um, inch, ft, or file. input_unit: that of a BREP file, which states none. deflection: largest distance from
    the exact faces as a fraction of the diagonal of the solid, at least 1e-30; below 1e-5 the mesh is that of 1e-5.

    Raises FileNotFoundError and IsADirectoryError, TypeError and ValueError for a wrong argument, and SolidMomentsError when the file cannot be read.
    """
    # Imported here, as in other functions: they take a third of the time to import the package.
    import json
    import subprocess
    import tempfile

    from ._run import check_unit

    check_unit(unit, input_unit)
    deflection = arguments.share("deflection", deflection, minimum=1e-30, expected="from 1e-30 to 1")
    file = arguments.existing("file", file)
    here = os.path.dirname(os.path.abspath(__file__))
    python = PYTHON if os.path.exists(PYTHON) else sys.executable
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONHOME"}
    # A wheel may have put another VTK next to this package.
    environment["PYTHONPATH"] = os.pathsep.join([VTK_FOLDER, os.path.dirname(here)])
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "mesh")
        done = subprocess.run([python, "-B", os.path.join(here, "_write_mesh.py"), file, output, unit, input_unit, repr(float(deflection))],
                              env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, encoding="utf-8", errors="replace", check=False)
        if done.returncode != 0 or not os.path.exists(output):
            reason = f"the process that reads it ended with {done.returncode}: {done.stderr.strip()[-500:]}"
            raise SolidMomentsError(f"{file}: {reason}", "unreadable", (reason,))
        with open(output, "rb") as stream:
            head = json.loads(stream.readline())
            if head["messages"] is not None:
                raise SolidMomentsError(f"{file}: unreadable" + "".join("\n" + text for text in head["messages"]), "unreadable",
                                        tuple(head["messages"]))
            return [_take_mesh(file, solid, stream) for solid in head["solids"]]


def _take_mesh(file, solid, stream):
    import numpy

    def take(array):
        values = numpy.frombuffer(stream.read(array["bytes"]), dtype=numpy.dtype(array["type"]))
        return values.reshape(-1, array["components"]) if array["components"] > 1 else values

    points, triangles = (take(solid[name]) for name in ("points", "triangles"))
    cell_data, point_data = ({name: take(array) for name, array in solid[kind].items()} for kind in ("cell_data", "point_data"))
    return SolidMesh(file, solid["name"], solid["length_unit"], points, triangles, cell_data, point_data)

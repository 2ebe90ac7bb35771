"""Mass properties of all STEP files of a folder, spread over the ranks of an MPI run, into one CSV:

    mpirun -np 4 pvbatch mass_properties_batch.py FOLDER --csv OUT.csv

It also runs by pvbatch or pvpython without mpirun, and by `mpirun -np 4 pvbatch --sym ...`. PYTHONPATH must name the folder
of the package `solidmoments`: PYTHONPATH=PREFIX/lib/python3.11/site-packages.

The faces of a file that is larger than the share of one rank are divided among all ranks; the other files are divided among the
ranks by size. The rows are in the order of the file names and the same, digit for digit, for any number of ranks of equal
devices: a row `total` for every file, then one for each of its solids. Columns are named as those of `solidmoments --csv`; a
value that does not exist is empty; `message` is the first message about the file.

A file that cannot be read has a row with the status `unreadable`, and the others are computed. Where a file may crash the
reader, use `solidmoments`, which reads each in a process of its own. Exit status: 0 all files ok, 1 wrong usage or nothing
written, 2 some file unreadable, 3 some result flagged.
"""
import argparse
import json
import os
import signal
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import mass_table  # noqa: E402

try:
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    from vtkmodules.vtkParallelCore import vtkMultiProcessController
except ImportError as missing:
    mass_table.exit_without_package(missing)

TAG = 551310
STATUS_UNREADABLE = "unreadable"
HEAD = mass_table.HEAD + ["faces", "evaluations", "message"]


class Ranks:
    """JSON between the ranks of the global controller; one rank where there is none."""

    def __init__(self):
        self.controller = vtkMultiProcessController.GetGlobalController()
        self.count = self.controller.GetNumberOfProcesses() if self.controller else 1
        self.rank = self.controller.GetLocalProcessId() if self.controller else 0

    def _send(self, value, rank):
        text = numpy.frombuffer(json.dumps(value).encode(), dtype=numpy.uint8)
        self.controller.Send(numpy_to_vtk(text, deep=True), rank, TAG)

    def _receive(self, rank):
        array = numpy_to_vtk(numpy.zeros(1, dtype=numpy.uint8), deep=True)
        self.controller.Receive(array, rank, TAG)
        return json.loads(vtk_to_numpy(array).tobytes())

    def broadcast(self, value):
        """The value of rank 0, on all ranks."""
        if self.rank != 0:
            return self._receive(0)
        for rank in range(1, self.count):
            self._send(value, rank)
        return value

    def gather(self, value):
        """The values of all ranks on rank 0; None on the others."""
        if self.rank != 0:
            self._send(value, 0)
            return None
        return [value] + [self._receive(rank) for rank in range(1, self.count)]


def compute(path, name, options, ranks, together):
    """The rows of a file; with `together` on all ranks at once, and rows on rank 0 alone."""
    from solidmoments.smFiltersMassProperties import vtkMassPropertiesGPU
    from solidmoments.smReadersSTEP import vtkSTEPReader

    reader = vtkSTEPReader()
    reader.SetFileName(path)
    reader.SetOutputUnit(options["unit"])
    mass = vtkMassPropertiesGPU()
    mass.SetInputConnection(reader.GetOutputPort())
    mass.SetRelativeTolerance(options["tolerance"])
    mass.SetDensity(options["density"])
    mass.SetBackend({"auto": 0, "opengl": 1, "cpu": 2}[options["backend"]])
    for algorithm in (reader, mass):
        # The rows have the messages, so VTK prints none.
        for event in ("ErrorEvent", "WarningEvent"):
            algorithm.AddObserver(event, lambda *_: None)
        algorithm.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    if together:
        mass.UpdatePiece(ranks.rank, ranks.count, 0)
    else:
        mass.Update()
    if together and ranks.rank != 0:
        return []
    messages = [reader.GetMessage(i) for i in range(reader.GetNumberOfMessages())]
    if reader.GetStatusAsString() != "ok":
        return [{"file": name, "row": "total", "status": reader.GetStatusAsString(),
                 "message": messages[-1] if messages else "nothing was read"}]
    messages = [mass.GetMessage(i) for i in range(mass.GetNumberOfMessages())] + messages
    totals = mass.GetOutput()
    rows = mass_table.read_rows(name, totals, mass.GetOutputDataObject(1))
    for column, array in (("faces", "Faces"), ("evaluations", "Evaluations")):
        rows[0][column] = mass_table.get_number(totals.GetFieldData(), 0, array)
    rows[0]["message"] = messages[0] if messages else ""
    return rows


def compute_safely(path, name, options, ranks, together):
    try:
        return compute(path, name, options, ranks, together)
    except Exception as error:  # pylint: disable=broad-except
        return [{"file": name, "row": "total", "status": STATUS_UNREADABLE, "message": str(error)}]


def divide(files, count):
    """Indices of files whose faces are to be divided, and of whole files for each rank; (name, bytes) each."""
    total = sum(size for _, size in files)
    together = [i for i, (_, size) in enumerate(files) if count > 1 and size * count > total]
    loads = [0] * count
    shares = [[] for _ in range(count)]
    for i in sorted(set(range(len(files))) - set(together), key=lambda i: (-files[i][1], i)):
        least = loads.index(min(loads))
        loads[least] += max(files[i][1], 1)
        shares[least].append(i)
    return together, shares


def run(job=None):
    """Computes a job; must be called on all ranks. Rank 0 passes the job and gets the rows of all files, in the order of the files."""
    ranks = Ranks()
    job = ranks.broadcast(job)
    files, folder, options = job["files"], job["folder"], job["options"]
    together, shares = divide(files, ranks.count)
    rows = {}
    start = time.monotonic()
    busy = time.process_time()
    for i in together:
        rows[i] = compute_safely(os.path.join(folder, files[i][0]), files[i][0], options, ranks, True)
    if ranks.rank != 0:
        rows = {}
    for i in shares[ranks.rank]:
        rows[i] = compute_safely(os.path.join(folder, files[i][0]), files[i][0], options, ranks, False)
    gathered = ranks.gather([sorted(rows.items()), time.monotonic() - start, time.process_time() - busy])
    if gathered is None:
        return None
    by_file = {}
    for rank, (some, seconds, processor) in enumerate(gathered):
        by_file.update({int(i): found for i, found in some})
        print(f"rank {rank}: {len(shares[rank])} whole files, {len(together)} shared with all, {seconds:.1f} s, "
              f"{processor:.1f} s of processor time")
    return [row for i in sorted(by_file) for row in by_file[i]]


def get_status(rows):
    statuses = {row["status"] for row in rows if row["row"] == "total"}
    if statuses & {STATUS_UNREADABLE, "empty", "aborted"}:
        return mass_table.UNREADABLE
    return mass_table.FLAGGED if statuses - {"ok"} else mass_table.ALL_OK


def run_on_satellites(job):
    """Does the same as run() if this script runs on rank 0 only: all ranks execute a programmable source that calls run()."""
    from paraview import simple

    run_as_source.job = job
    source = simple.ProgrammableSource(OutputDataSetType="vtkTable", Script=(
        "import sys\n"
        f"sys.path.insert(0, {os.path.dirname(os.path.abspath(__file__))!r})\n"
        "import mass_properties_batch\n"
        "mass_properties_batch.run_as_source()\n"))
    source.UpdatePipeline()
    return run_as_source.rows


def run_as_source():
    # mpirun ends the other ranks when rank 0 exits with a status; they should print no stack then.
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    run_as_source.rows = run(run_as_source.job)


run_as_source.job = None
run_as_source.rows = None


class Parser(argparse.ArgumentParser):
    def error(self, message):
        self.print_usage(sys.stderr)
        self.exit(1, f"{self.prog}: {message}\n")


def parse(arguments):
    parser = Parser(prog="mass_properties_batch.py", description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", help="folder of .step, .stp and .p21 files")
    parser.add_argument("--csv", required=True, help="file to write")
    parser.add_argument("--tolerance", type=float, default=1e-9, help="relative, in (0, 1]; default 1e-9")
    parser.add_argument("--density", type=float, default=0.0, help="kg/m^3; default: the file's own")
    parser.add_argument("--unit", default="mm", help="mm, cm, m, um, inch, ft or file; default mm")
    parser.add_argument("--backend", choices=("auto", "opengl", "cpu"), default="auto")
    options = parser.parse_args(arguments)
    if not os.path.isdir(options.folder):
        parser.error(f"{options.folder} is not a folder")
    return options


def main(arguments):
    options = parse(arguments)
    try:
        import solidmoments.smReadersSTEP  # noqa: F401  pylint: disable=unused-import
        import solidmoments.smFiltersMassProperties  # noqa: F401  pylint: disable=unused-import
    except ImportError as error:
        mass_table.exit_without_package(error)
    names = sorted(name for name in os.listdir(options.folder)
                   if name.lower().endswith((".step", ".stp", ".p21")))
    if not names:
        print(f"There is no STEP file in {options.folder}.", file=sys.stderr)
        return 1
    job = {"folder": os.path.abspath(options.folder),
           "files": [(name, os.path.getsize(os.path.join(options.folder, name))) for name in names],
           "options": {"tolerance": options.tolerance, "density": options.density, "unit": options.unit,
                       "backend": options.backend}}
    ranks = Ranks()
    is_alone = False
    if ranks.count > 1:
        from paraview.modules.vtkRemotingCore import vtkProcessModule
        is_alone = not vtkProcessModule.GetProcessModule().GetSymmetricMPIMode()
    rows = run_on_satellites(job) if is_alone else run(job)
    if rows is None:
        # The exit status is that of rank 0.
        return ranks.broadcast(None)
    status = get_status(rows)
    try:
        mass_table.write_csv(options.csv, rows, HEAD)
    except OSError as error:
        print(f"{options.csv} cannot be written: {error.strerror}.", file=sys.stderr)
        status = 1
    return status if is_alone else ranks.broadcast(status)


if __name__ == "__main__":
    # Imported as a module, because ParaView's Python sources add names to __main__.
    sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
    import mass_properties_batch
    exit_status = mass_properties_batch.main(sys.argv[1:])
    if exit_status:
        sys.exit(exit_status)

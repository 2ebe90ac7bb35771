"""TestPluginWritersRanks.py PLUGIN.so STEP OUTPUT [PVPYTHON MPIRUN PVBATCH]: on two ranks the first one writes the file, once.

With all six it drives, outside of ParaView, which would hand its own MPI down: itself in PVPYTHON, on two ranks of PVBATCH, and the
writer with pieces.
"""
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Support"))
from smcheck import check_equal, check_true, finish  # noqa: E402

plugin, part, output = sys.argv[1:4]


def get_paths(ranks):
    return {end: os.path.join(output, f"ranks-{ranks}.{end}") for end in ("step", "brep")}


def write():
    """Writes files of both formats by ParaView's Save Data."""
    from paraview import servermanager, simple
    simple.LoadPlugin(plugin)
    ranks = servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
    reader = simple.OpenDataFile(part)
    moved = simple.NURBSTransform(Input=reader, Translation=[1.0, 2.0, 3.0])
    for path in get_paths(ranks).values():
        if os.path.exists(path):
            os.remove(path)
        simple.SaveData(path, proxy=moved)
        name = os.path.basename(path)
        check_true(f"{ranks} ranks: {name}", os.path.getsize(path) > 1000)
        check_equal("nothing next to it", [name], [each for each in os.listdir(output) if each.startswith(name)])


def read_lines(path):
    """Returns the lines of the file, without its name and the time that it was written."""
    with open(path, encoding="utf-8") as file:
        return [line for line in file if not line.startswith("FILE_NAME")]


def drive(pvpython, mpirun, pvbatch):
    for ranks, launcher in ((1, [pvpython]), (2, [mpirun, "-np", "2", pvbatch])):
        for path in get_paths(ranks).values():
            if os.path.exists(path):
                os.remove(path)
        done = subprocess.run(launcher + [os.path.abspath(__file__), plugin, part, output], capture_output=True, text=True,
                              timeout=140, check=False)
        print(done.stdout[-4000:])
        check_equal(f"{ranks} ranks: status", 0, done.returncode)
        check_true(f"{ranks} ranks: no error and no warning", "ERR|" not in done.stderr and "WARN|" not in done.stderr,
                   done.stderr[-3000:])
        check_true(f"{ranks} ranks: as many", f"{ranks} ranks: ranks-{ranks}.step" in done.stdout)
    for (end, path), other in zip(get_paths(1).items(), get_paths(2).values()):
        if check_true(f"two ranks: {end} is there", os.path.exists(path) and os.path.exists(other)):
            check_true(f"two ranks: {end} as one rank writes it", read_lines(path) == read_lines(other))


def check_pieces():
    """A rank that is not the first updates its piece and writes nothing."""
    from solidmoments.smReadersKernel import vtkSTEPWriter
    from solidmoments.smReadersSTEP import vtkSTEPReader
    source = vtkSTEPReader()
    source.SetFileName(part)
    writer = vtkSTEPWriter()
    writer.SetInputConnection(source.GetOutputPort())
    writer.SetNumberOfPieces(2)
    path = os.path.join(output, "ranks-pieces.step")
    writer.SetFileName(path)
    for piece, written in ((1, False), (0, True)):
        if os.path.exists(path):
            os.remove(path)
        writer.SetPiece(piece)
        check_equal(f"piece {piece}: Write() returns", 1, writer.Write())
        check_equal(f"piece {piece}: a file", written, os.path.exists(path))
        check_equal(f"piece {piece}: faces", written, writer.GetNumberOfFaces() > 0)
        check_equal(f"piece {piece}: of the reader", written, source.GetOutput().GetNumberOfPartitionedDataSets() > 0)


if len(sys.argv) > 4:
    drive(*sys.argv[4:7])
    check_pieces()
else:
    write()
finish()

"""TestModules.py FOLDER [NURBSEdit] [Stability]: the modules, the named optional ones too, import, wrap their methods and compute, in
python3 and in pvpython."""
import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check, check_equal, check_true, check_values, finish  # noqa: E402
from smproduct import Assembly, Part, write_product  # noqa: E402

from solidmoments.smFiltersMassProperties import vtkMassPropertiesGPU  # noqa: E402
from solidmoments.smFiltersNURBS import vtkNURBSDataSet, vtkTrimmedNURBSModel  # noqa: E402
from solidmoments.smFiltersSurfaceIntegrals import vtkSurfaceIntegralGPU  # noqa: E402
from solidmoments.smReadersBREP import vtkBREPReader  # noqa: E402
from solidmoments.smReadersKernel import vtkBREPWriter, vtkSTEPWriter  # noqa: E402
from solidmoments.smReadersSTEP import vtkSTEPReader  # noqa: E402
from solidmoments.smRenderingCompute import vtkComputeContext  # noqa: E402
from solidmoments.smRenderingNURBS import vtkNURBSPointEvaluatorGPU  # noqa: E402
from vtkmodules.vtkCommonTransforms import vtkTransform  # noqa: E402

PART = Manifest(sys.argv[1]).solid("slanted_hole", "moved")


def check_edits(reader, mass, leaf, center):
    """Deformed and mirrored parts; VTK's own objects go in and come out."""
    from solidmoments.smFiltersNURBSEdit import vtkNURBSDeform, vtkNURBSTransform
    deform = vtkNURBSDeform()
    deform.SetInputConnection(reader.GetOutputPort())
    deform.SetDisplacement(0.0, 0.0, 1.0)
    deform.Update()
    evaluator = deform.GetPointEvaluator()
    check_true("display points by the GPU's class", isinstance(evaluator, vtkNURBSPointEvaluatorGPU), evaluator.GetClassName())
    check_equal("which used", "opengl", evaluator.GetBackendName())
    moved = deform.GetOutputDataObject(0).GetPartition(0, 0)
    distance = max(abs(moved.GetPoint(i)[2] - leaf.GetPoint(i)[2] - 1.0) for i in range(leaf.GetNumberOfPoints()))
    check_true("points moved by 1", distance < 1e-5, str(distance))

    mirror = vtkTransform()
    mirror.Scale(-1.0, 1.0, 1.0)
    mirrored = vtkNURBSTransform()
    mirrored.SetInputConnection(reader.GetOutputPort())
    mirrored.SetTransform(mirror)
    twin = vtkMassPropertiesGPU()
    twin.SetInputConnection(mirrored.GetOutputPort())
    twin.Update()
    twin_center = [0.0] * 3
    twin.GetCenterOfMass(twin_center)
    check("volume of the mirror image", mass.GetVolume(), twin.GetVolume(), mass.GetVolumeBound() + twin.GetVolumeBound())
    check("centre of the mirror image", -center[0], twin_center[0], mass.GetCenterOfMassBound() + twin.GetCenterOfMassBound())


def check_parts():
    """The parts list on port 7: two stations with two bolts each, and a rail without density."""
    bolt = Part("bolt", [((0, 0, 0), (2, 2, 10))], "7.85", "g/cm^3")
    plate = Part("Plate", [((0, 0, 0), (20, 10, 5))], "2700.")
    station = Assembly("station", [(plate, (0, 0, 0), None), (bolt, (5, 5, 5), None), (bolt, (12, 5, 5), None)])
    rail = Part("rail", [((0, 0, 0), (200, 10, 10))])
    machine = Assembly("machine", [(station, (0, 0, 10), None), (rail, (0, 0, 0), None), (station, (100, 0, 10), None)])
    mass = vtkMassPropertiesGPU()
    with tempfile.TemporaryDirectory() as folder:
        reader = vtkSTEPReader()
        reader.SetFileName(write_product(os.path.join(folder, "machine.step"), machine))
        mass.SetInputConnection(reader.GetOutputPort())
        mass.Update()
    table = mass.GetOutputDataObject(7)
    rows = [[table.GetValueByName(i, name).ToString() for name in ("Name", "Kind", "Level", "Count", "CountInAll", "Solids", "SolidsWithMass", "Status")]
            for i in range(table.GetNumberOfRows())]
    check_equal("parts list", [["machine", "assembly", "1", "1", "1", "7", "6", "ok"], ["    rail", "part", "2", "1", "1", "1", "0", "ok"],
                               ["    station", "assembly", "2", "2", "2", "3", "3", "ok"], ["        bolt", "part", "3", "2", "4", "1", "1", "ok"],
                               ["        Plate", "part", "3", "1", "2", "1", "1", "ok"]], rows)
    bolts, plates = 4 * 40 * 7850e-9, 2 * 1000 * 2700e-9
    for name, values in (("Volume", (22160.0, 20000.0, 1080.0, 40.0, 1000.0)),
                         ("MassInAll", (None, None, bolts + plates, bolts, plates)),
                         ("KnownMassInAll", (bolts + plates, None, bolts + plates, bolts, plates)), ("Mass", (None, None, (bolts + plates) / 2, bolts / 4, plates / 2))):
        for i, value in enumerate(values):
            number = table.GetValueByName(i, name).ToDouble()
            check_true(f"{name} of row {i}", number != number if value is None else
                       abs(number - value) <= table.GetValueByName(i, name + "Bound").ToDouble() + 1e-15 * value, f"{number}, {value}")
    check_true("no layers", table.GetColumnByName("Layer") is None)
    tree = reader.GetOutput().GetDataAssembly()
    for node in tree.SelectNodes(["//*[@label='Plate']"]):
        tree.SetAttribute(node, "layer", "sheet metal")
    mass.Modified()
    mass.Update()
    check_equal("layers", ["", "", "", "", "sheet metal"], [table.GetValueByName(i, "Layer").ToString() for i in range(5)])
    mass.AddSelector("//*[@label='station']")
    mass.Update()
    check_equal("of selected solids", ["machine", "    station", "        bolt", "        Plate"],
                [table.GetValueByName(i, "Name").ToString() for i in range(mass.GetOutputDataObject(7).GetNumberOfRows())])


def check_stability():
    """A box on its bottom."""
    from solidmoments.smFiltersStability import vtkSolidStability
    box = Manifest(sys.argv[1]).solid("box")
    boxes = vtkSTEPReader()
    boxes.SetFileName(box["path"])
    standing = vtkSolidStability()
    standing.SetInputConnection(boxes.GetOutputPort())
    standing.Update()
    check_equal("a box", "stable", standing.GetStability())
    check("its margin", min(box["center_of_mass"][:2]), standing.GetStabilityMargin(), standing.GetStabilityMarginBound())  # a corner is the origin


reader = vtkSTEPReader()
reader.SetFileName(PART["path"])
mass = vtkMassPropertiesGPU()
mass.SetInputConnection(reader.GetOutputPort())
mass.Update()
check_equal("status", "ok", mass.GetStatus())
center = [0.0] * 3
inertia = [0.0] * 9
mass.GetCenterOfMass(center)
mass.GetVolumeInertia(inertia)
check_values(PART, mass.GetVolume(), mass.GetSurfaceArea(), center, [inertia[0:3], inertia[3:6], inertia[6:9]])

check_equal("points before anything shows them", 0, reader.GetOutputDataObject(0).GetPartition(0, 0).GetNumberOfPoints())
reader.Update()
leaf = reader.GetOutputDataObject(0).GetPartition(0, 0)
check_true("points for the reader's own update", leaf.GetNumberOfPoints() > 0)
check_true("a leaf is a vtkNURBSDataSet", isinstance(leaf, vtkNURBSDataSet), leaf.GetClassName())
check_true("with its model", isinstance(leaf.GetModel(), vtkTrimmedNURBSModel))
check_equal("faces", 7, leaf.GetModel().GetNumberOfFaces())
check_true("context", isinstance(mass.GetComputeContext(), vtkComputeContext), mass.GetRenderer())

integral = vtkSurfaceIntegralGPU()
integral.SetInputConnection(reader.GetOutputPort())
integral.AddIntegrand("area", "length(normal)")
integral.Update()
check_true("own integrand", abs(integral.GetIntegral("area") / PART["area"] - 1) < 1e-9, str(integral.GetIntegral("area")))

check_parts()
if "NURBSEdit" in sys.argv[2:]:
    check_edits(reader, mass, leaf, center)
if "Stability" in sys.argv[2:]:
    check_stability()
with tempfile.TemporaryDirectory() as output:
    for writer, name in ((vtkSTEPWriter(), "part.step"), (vtkBREPWriter(), "part.brep")):
        writer.SetInputConnection(reader.GetOutputPort())
        writer.SetFileName(os.path.join(output, name))
        check_equal(name, 1, writer.Write())
        check_equal(name + ": faces", 7, writer.GetNumberOfFaces())
        check_equal(name + ": messages", 0, writer.GetNumberOfMessages())
    volume = mass.GetVolume()
    for again, name in ((vtkSTEPReader(), "part.step"), (vtkBREPReader(), "part.brep")):
        again.SetFileName(os.path.join(output, name))
        mass.SetInputConnection(again.GetOutputPort())
        mass.Update()
        check_true(name + " read", abs(mass.GetVolume() / volume - 1) < 1e-14, str(mass.GetVolume() / volume - 1))
        with open(os.path.join(output, name), "rb") as file:
            again.SetContent(file.read())
        again.SetFileName(None)
        check_true("it has content", again.HasContent())
        mass.Update()
        check_true(name + " from bytes", abs(mass.GetVolume() / volume - 1) < 1e-14, str(mass.GetVolume() / volume - 1))
finish()

"""TestPluginPicks.py PLUGIN.so FOLDER [HOST:PORT]: picks that are added, subtracted, toggled and inverted, and what the rows and the view say of them."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check_equal, check_true, finish  # noqa: E402
from smselection import combine_picks, count_selected_cells, get_selected_rows, pick, select_rows  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

plugin, folder = sys.argv[1:3]
if len(sys.argv) > 3:
    host, port = sys.argv[3].split(":")
    simple.Connect(host, int(port))
    simple.LoadPlugin(plugin, remote=True, ns=globals())
simple.LoadPlugin(plugin, remote=False, ns=globals())
view = simple.CreateRenderView()
reader = simple.OpenDataFile(Manifest(folder).special("assembly")["path"])
mass = MassProperties(Input=reader, Density=2700.0)  # noqa: F821
# The summary alone: drawing what is highlighted would take most of the time.
servermanager.vtkSMParaViewPipelineControllerWithRendering().ShowInPreferredView(mass.SMProxy, 2, view.SMProxy)
simple.Render(view)
SOLIDS = servermanager.OutputPort(mass, 5).GetDataInformation().GetNumberOfCells()
ONE = SOLIDS // 500
faces = servermanager.Fetch(mass, idx=3)
SOLID_OF = [faces.GetValueByName(row, "Solid").ToInt() for row in range(faces.GetNumberOfRows())]
summary = simple.GetRepresentation(servermanager.OutputPort(mass, 2), view).SMProxy.GetProperty("SelectedText")


def get_text():
    """Returns the text that the view shows for the selection, in one line."""
    return " ".join(summary.GetElement(0).split())


def select(selection):
    """Selects as a click in the view does."""
    mass.SMProxy.SetSelectionInput(5, selection, 0)


def blocks(*solids):
    return pick("BlockSelectionSource", "Blocks", [2 * solid + 2 for solid in solids])


def cells(*pairs):
    return pick("CompositeDataIDSelectionSource", "IDs", [number for solid, cell in pairs for number in (2 * solid + 2, 0, cell)])


def check_selection(what, solids, number_of_cells):
    """The rows of the solids, and what ParaView highlights."""
    check_equal(f"{what}: cells", number_of_cells, count_selected_cells(mass, 5))
    check_equal(f"{what}: rows", solids, get_selected_rows(mass, 1))


def check_section():
    """Picks on *Clipped* of Section: whole faces, their rows, the same faces after the plane has moved."""
    box = Manifest(folder).special("assembly")["path"]
    section = Section(Input=simple.OpenDataFile(box))  # noqa: F821
    servermanager.vtkSMParaViewPipelineControllerWithRendering().ShowInPreferredView(section.SMProxy, 2, view.SMProxy)
    section.UpdatePipeline()
    shown = simple.GetRepresentation(servermanager.OutputPort(section, 2), view).SMProxy.GetProperty("SelectedText")

    def get_faces():
        """The face of each cell of each block, by its index; -1 is the section."""
        merged = servermanager.Fetch(simple.MergeBlocks(Input=servermanager.OutputPort(section, 7))).GetCellData()
        faces = [[] for _ in range(500)]
        for cell in range(merged.GetArray("Solid").GetNumberOfTuples()):
            faces[int(merged.GetArray("Solid").GetTuple1(cell))].append(int(merged.GetArray("FaceIndex").GetTuple1(cell)))
        return faces

    faces = get_faces()
    block = next(block for block, found in enumerate(faces) if -1 in found)
    cells_of = faces[block]
    face = next(face for face in cells_of if face >= 0 and 1 < cells_of.count(face) < len(cells_of))
    section.SMProxy.SetSelectionInput(7, cells((block, cells_of.index(face))), 0)
    check_equal("Clipped: all cells of the face", cells_of.count(face), count_selected_cells(section, 7))
    rows = get_selected_rows(section, 3)
    table = servermanager.Fetch(section, idx=3)
    check_equal("Clipped: the row of the face", [(block, face)],
                [(table.GetValueByName(row, "Solid").ToInt(), table.GetValueByName(row, "FaceIndex").ToInt()) for row in rows])
    check_true("Clipped: the text", shown.GetElement(0).startswith(f"face {face} (#"), shown.GetElement(0))
    # The window clears the rows of the tables after each pick.
    for port in (1, 3, 4):
        section.SMProxy.CleanSelectionInputs(port)
    check_equal("Clipped: the rows are back", rows, get_selected_rows(section, 3))
    section.Point = [x + 0.01 for x in section.Point]
    section.UpdatePipeline()
    moved = get_faces()[block]
    check_equal("the plane has moved: the same face", (moved.count(face), rows), (count_selected_cells(section, 7), get_selected_rows(section, 3)))
    section.SMProxy.SetSelectionInput(7, cells((block, moved.index(-1))), 0)
    check_equal("the section as a whole, without a row of the faces", (moved.count(-1), []), (count_selected_cells(section, 7), get_selected_rows(section, 3)))
    section.SMProxy.SetSelectionInput(5, cells((block, 0)), 0)
    check_equal("a pick on Bodies ends that on Clipped", (True, 1), (section.SMProxy.GetSelectionInput(7) is None, len(get_selected_rows(section, 3))))
    section.SMProxy.CleanSelectionInputs(5)
    select_rows(section, 3, rows)
    check_equal("a row of a face: its cells on Clipped", (moved.count(face), True),
                (count_selected_cells(section, 7), section.SMProxy.GetSelectionInput(5) is None))
    section.SMProxy.CleanSelectionInputs(3)
    check_equal("cleared", (True, ""), (section.SMProxy.GetSelectionInput(7) is None, shown.GetElement(0)))


select(blocks(2, 4, 6))
check_selection("three solids", [2, 4, 6], 3 * ONE)
check_true("three solids: the text", "3 solids: mass" in get_text(), get_text())
select(combine_picks(blocks(2, 4, 6), "Subtract", blocks(4)))
check_selection("one of three subtracted", [2, 6], 2 * ONE)
check_true("one of three subtracted: the text", "2 solids: mass" in get_text() and "(solid 5)" not in get_text(), get_text())
select(combine_picks(blocks(2, 4, 6), "Toggle", blocks(4, 8)))
check_selection("one of three toggled, and another", [2, 6, 8], 3 * ONE)
select(combine_picks(combine_picks(combine_picks(blocks(1, 2, 3), "Subtract", blocks(2)), "Add", cells((9, 0))), "Toggle", blocks(3, 4)))
# Of a face that is picked by a cell all cells light up.
ONE_FACE = count_selected_cells(mass, 5) - 2 * ONE
check_true("several steps: a whole face", 1 < ONE_FACE < ONE, str(ONE_FACE))
check_selection("several steps", [1, 4, 9], 2 * ONE + ONE_FACE)
check_true("several steps: the text", "face 0 (#" in get_text() and "3 solids: mass" in get_text(), get_text())
select_rows(mass, 3, [SOLID_OF.index(9)])
check_equal("as many cells as the row of that face has", ONE_FACE, count_selected_cells(mass, 5))
select(blocks(3))
select(combine_picks(blocks(3), "Subtract", cells((3, 0), (3, 1))))
check_selection("a solid without two cells of a face: without the face", [3], ONE - ONE_FACE)
select(combine_picks(blocks(3), "Subtract", blocks(3)))
check_selection("nothing is left", [], 0)
check_equal("nothing is left: the text", "", get_text())
inverted = cells((7, 0))
inverted.GetProperty("InsideOut").SetElement(0, 1)
inverted.UpdateVTKObjects()
select(inverted)
check_selection("all but a cell: the others light up its face", list(range(500)), SOLIDS)
check_true("all but a cell: the text", "500 solids: mass" in get_text(), get_text())
inverted = blocks(7)
inverted.GetProperty("InsideOut").SetElement(0, 1)
inverted.UpdateVTKObjects()
select(inverted)
check_selection("all but a solid", [solid for solid in range(500) if solid != 7], SOLIDS - ONE)

# Blocks by their names in a tree.
for tree, selector in (("Hierarchy", "/Root/*[@number_of_partitions][6]"), ("Assembly", "//*[dataset[@id='5']]")):
    named = pick("BlockSelectorsSelectionSource", "BlockSelectors", [selector])
    source = named.GetProperty("Input").GetProxy(0)
    source.GetProperty("BlockSelectorsAssemblyName").SetElement(0, tree)
    source.UpdateVTKObjects()
    select(named)
    check_selection(f"a solid of the tree {tree}", [5], ONE)

# A selection of a kind that the filter cannot interpret leaves the selected rows and the text as they are.
before = get_text()
for name, value in (("FieldType", 1), ("NumberOfLayers", 1), ("InsideOut", 1)):
    other = cells((8, 0))
    source = other.GetProperty("Input").GetProxy(0)
    source.GetProperty(name).SetElement(0, value)
    source.UpdateVTKObjects()
    select(other)
    check_equal(f"{name}: rows and text stay", ([5], before), (get_selected_rows(mass, 1), get_text()))
mass.SMProxy.CleanSelectionInputs(5)
check_equal("cleared", ([], ""), (get_selected_rows(mass, 1), get_text()))

# Rows of a table.
rows = [pick("IDSelectionSource", "IDs", [number for row in some for number in (0, row)], 5) for some in ((1, 2, 3), (2, 9))]
mass.SMProxy.SetSelectionInput(1, combine_picks(rows[0], "Toggle", rows[1]), 0)
check_equal("toggled rows: cells", 3 * ONE, count_selected_cells(mass, 5))
check_true("toggled rows: the text", "(solid 10)" in get_text() and "(solid 3)" not in get_text(), get_text())
mass.SMProxy.CleanSelectionInputs(1)
check_equal("toggled rows: cleared", "", get_text())


def get_sources():
    """The kinds of what is highlighted."""
    sources = mass.SMProxy.GetSelectionInput(5).GetProperty("Input")
    return sorted(sources.GetProxy(i).GetXMLName() for i in range(sources.GetNumberOfProxies()))


# Many faces: ParaView takes minutes for thousands of cells in hundreds of solids.
select_rows(mass, 3, [row for row, solid in enumerate(SOLID_OF) if solid in (4, 5)] + [SOLID_OF.index(499)])
check_equal("faces of whole solids, and another", ["BlockSelectorsSelectionSource", "CompositeDataIDSelectionSource"], get_sources())
some = count_selected_cells(mass, 5)
check_true("faces of whole solids, and another: cells", 2 * ONE < some < 3 * ONE, str(some))
select_rows(mass, 3, range(len(SOLID_OF)))
check_equal("all faces: whole solids", (["BlockSelectorsSelectionSource"], SOLIDS), (get_sources(), count_selected_cells(mass, 5)))
check_true("all faces: no word of it", "whole solids" not in get_text(), get_text())
select_rows(mass, 3, [SOLID_OF.index(solid) for solid in range(400)])
check_equal("a face of 400 solids: whole solids", (["BlockSelectorsSelectionSource"], 400 * ONE), (get_sources(), count_selected_cells(mass, 5)))
check_true("a face of 400 solids: the text says so", "their whole solids are highlighted" in get_text(), get_text())
select_rows(mass, 4, range(1200))
check_true("many edges: the text says what is drawn", "The first 1000 edges are drawn" in get_text(), get_text())
mass.SMProxy.CleanSelectionInputs(4)

# After a run faces have other cells.
row = SOLID_OF.index(3) + 1
select_rows(mass, 3, [row])
fine = count_selected_cells(mass, 5)
chosen = mass.SMProxy.GetSelectionInput(5)
mass.Density = 2800.0
mass.UpdatePipeline()
check_true("another density: the same highlight", mass.SMProxy.GetSelectionInput(5) == chosen)


def mesh_again(deflection):
    """The number of cells of a solid in the new mesh."""
    reader.MeshDeviation = deflection
    mass.UpdatePipeline()
    return servermanager.OutputPort(mass, 5).GetDataInformation().GetNumberOfCells() // 500


coarse = mesh_again(0.1)
renewed = count_selected_cells(mass, 5)
select_rows(mass, 3, [row + 1])
select_rows(mass, 3, [row])
check_equal("a coarser mesh: the cells of the same face", count_selected_cells(mass, 5), renewed)
check_true("a coarser mesh: other cells", renewed != fine, f"{renewed} {fine}")
mass.SMProxy.CleanSelectionInputs(3)
check_equal("the fine mesh again", ONE, mesh_again(0.001))
select(cells((3, ONE - 1)))
before = get_selected_rows(mass, 3), get_text()
check_true("the last cell: its face", len(before[0]) == 1 and "(#" in before[1] and before[1].startswith("face "), str(before))
check_true("a coarser mesh: the last cell is gone", mesh_again(0.1) == coarse < ONE)
check_equal("a coarser mesh: the same face", before, (get_selected_rows(mass, 3), get_text()))
check_true("a coarser mesh: cells of the face", 0 < count_selected_cells(mass, 5) < coarse)
mass.Selectors = ["//*[dataset[@id='5']]"]
mass.UpdatePipeline()
check_equal("another solid: the pick is gone", (True, [], ""), (mass.SMProxy.GetSelectionInput(5) is None, get_selected_rows(mass, 3), get_text()))
if "Section" in globals():
    check_section()
finish()

"""TestPluginMaterials.py PLUGIN.so FOLDER PROGRAM [HOST:PORT]: the table of parts and materials of Mass Properties, here or on a server.

Boxes: two plates with a density in the file, four bolts with another one, and a rail without one. PROGRAM lists the common materials.
"""
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check, check_equal, check_true, finish  # noqa: E402
from smproduct import Assembly, Part, write_product  # noqa: E402

from paraview import servermanager, simple, smtrace, smstate  # noqa: E402

plugin, folder, program = sys.argv[1:4]
folder = os.path.join(folder, "materials_server" if len(sys.argv) > 4 else "materials")
os.makedirs(folder, exist_ok=True)
if len(sys.argv) > 4:
    host, port = sys.argv[4].split(":")
    simple.Connect(host, int(port))
    simple.LoadPlugin(plugin, remote=True, ns=globals())
simple.LoadPlugin(plugin, remote=False, ns=globals())
VOLUMES = {"bolt": 4 * 40.0, "plate": 2 * 50.8 * 25.4 * 6.35, "rail": 20000.0, "nut": 8.0}  # mm^3 of all of a part


def write(name, *more):
    bolt = Part("bolt", [((0, 0, 0), (2, 2, 10))], "7.85", "g/cm^3")
    plate = Part("plate", [((0, 0, 0), (2, 1, "0.25"))], "2700.", "kg/m^3", "inch")
    station = Assembly("station", [(plate, (0, 0, 0), None), (bolt, (5, 5, "6.35"), None), (bolt, (20, 5, "6.35"), None)])
    rail = Part("rail", [((0, 0, 0), (200, 10, 10))])
    uses = [(station, (0, 0, 10), None), (station, (100, 0, 10), None), (rail, (0, 0, 0), None)]
    return write_product(os.path.join(folder, name), Assembly("machine", uses + [(part, (0, 0, 50), None) for part in more]))


def get_rows(filter_proxy):
    """The first row of every part, without the titles."""
    cells = list(filter_proxy.MaterialTable)
    rows = {}
    for i in range(4, len(cells), 4):
        rows.setdefault(cells[i], cells[i + 1:i + 4])
    return rows


def edit(filter_proxy, part, **cells):
    """Types into cells of the row of a part, and runs the filter."""
    table = list(filter_proxy.MaterialTable)
    row = table.index(part, 4)
    for column, text in cells.items():
        table[row + {"material": 1, "density": 2}[column]] = text
    filter_proxy.MaterialTable = table
    filter_proxy.UpdatePipeline()


def check_table(what, filter_proxy, expected, rules):
    """expected: {part: (material, density, density as number)}; checks texts, masses to their six digits, and the total."""
    rows = get_rows(filter_proxy)
    check_equal(f"{what}: rows", list(expected) + ["Total"], list(rows))
    total = 0.0
    for part, (material, density, value) in expected.items():
        check_equal(f"{what}: {part}", [material, density], rows[part][:2])
        if value is None or part not in VOLUMES:
            check_equal(f"{what}: {part} has no mass", "", rows[part][2])
        else:
            mass = VOLUMES[part] * value * 1e-9
            check(f"{what}: mass of {part}", mass, float(rows[part][2]), 5.1e-6 * mass, "six digits")
            total += mass
    check(f"{what}: total", total, float(rows["Total"][2].split()[0]), 5.1e-6 * total, "six digits")
    check_equal(f"{what}: rules", rules, list(filter_proxy.Materials))


def get_mass(filter_proxy, name="Mass"):
    return servermanager.Fetch(filter_proxy, idx=0).GetFieldData().GetArray(name).GetValue(0)


reader = simple.OpenDataFile(write("materials_machine.step"))
reader.UpdatePipeline()
mass = MassProperties(Input=reader)  # noqa: F821
FILE = {"plate": ("", "2700 (file)", 2700.0), "bolt": ("", "7850 (file)", 7850.0), "rail": ("", "", None)}
check_equal("before the first run: titles", ["Part", "Material", "kg/m^3", "kg"], list(mass.MaterialTable)[:4])
check_equal("before the first run: densities of the file", [[cells[1], ""] for cells in FILE.values()],
            [get_rows(mass)[part][1:] for part in FILE])
mass.UpdatePipeline()
check_table("file", mass, FILE, [])
check_true("file: not all have a mass", get_rows(mass)["Total"][2].endswith(" (6 of 7 solids)"), get_rows(mass)["Total"][2])
summary = servermanager.Fetch(mass, idx=2).GetValueByName(0, "Text").ToString()
check_true("file: summary", "Mass of 6 of 7 solids: 0.0455" in summary and "Centre of volume:" in summary and "mm^5" in summary, summary)

edit(mass, "rail", material="Steel")
check_table("a material", mass, {**FILE, "rail": ("Steel", "7850", 7850.0)}, ["rail", "Steel", "7850"])
check_true("a material: all have a mass", "(" not in get_rows(mass)["Total"][2], get_rows(mass)["Total"][2])
summary = servermanager.Fetch(mass, idx=2).GetValueByName(0, "Text").ToString()
check_true("a material: summary", "\nMass: 0.2025" in summary and "Centre of volume:" in summary and "Centre of mass:" in summary and
           " kg mm^2" in summary and "mm^5" not in summary, summary)
edit(mass, "rail", material="aluminium")
check_table("another material", mass, {**FILE, "rail": ("aluminium", "2700", 2700.0)}, ["rail", "aluminium", "2700"])
edit(mass, "bolt", density="8000.5")
mixed = {**FILE, "bolt": ("", "8000.5", 8000.5), "rail": ("aluminium", "2700", 2700.0)}
check_table("a density", mass, mixed, ["bolt", "", "8000.5", "rail", "aluminium", "2700"])
edit(mass, "bolt", material="my alloy")
mixed["bolt"] = ("my alloy", "8000.5", 8000.5)
check_table("a name for it", mass, mixed, ["bolt", "my alloy", "8000.5", "rail", "aluminium", "2700"])
check("a name for it: full digits elsewhere", (VOLUMES["bolt"] * 8000.5 + (VOLUMES["plate"] + VOLUMES["rail"]) * 2700.0) * 1e-9, get_mass(mass),
      get_mass(mass, "MassBound"), "its bound")
edit(mass, "rail", density="2 stone")
check_equal("a unit that is not known", "no density", get_rows(mass)["rail"][2])
edit(mass, "rail", density="50 g")
check("a mass in place of a density", 0.05, float(get_rows(mass)["rail"][2]), 0.0)
check("a mass: overridden", 0.05, get_mass(mass, "OverriddenMass"), 0.0)
edit(mass, "rail", material="left out", density="")
check_equal("left out", ["left out", "", ""], get_rows(mass)["rail"])
check("left out: mass", (VOLUMES["bolt"] * 8000.5 + VOLUMES["plate"] * 2700.0) * 1e-9, get_mass(mass), get_mass(mass, "MassBound"), "its bound")
edit(mass, "rail", material="aluminium", density="2700")
check_table("and back", mass, mixed, ["bolt", "my alloy", "8000.5", "rail", "aluminium", "2700"])
edit(mass, "plate", density="2710 (file)")
mixed["plate"] = ("", "2710", 2710.0)
check_table("digits in front of where a density comes from", mass, mixed, ["plate", "", "2710", "bolt", "my alloy", "8000.5", "rail", "aluminium", "2700"])
edit(mass, "plate", density="")
mixed["plate"] = FILE["plate"]
edit(mass, "rail", material="unobtainium", density="")
check_equal("a material without a density", ["unobtainium", "", "no density"], get_rows(mass)["rail"])
edit(mass, "rail", material="aluminium")
edit(mass, "Total", material="lead", density="3")
check_table("what is typed next to the total", mass, mixed, ["bolt", "my alloy", "8000.5", "rail", "aluminium", "2700"])

# States have the rules.
states = [os.path.join(folder, "PluginMaterials." + end) for end in ("pvsm", "py")]
if len(sys.argv) == 4:
    simple.SaveState(states[0])
    with open(states[1], "w", encoding="utf-8") as file:
        file.write(smstate.get_state())
    del reader, mass
    for state in states:
        simple.ResetSession()
        simple.LoadPlugin(plugin, ns=globals())
        if state.endswith("pvsm"):
            simple.LoadState(state)
        else:
            with open(state, encoding="utf-8") as file:
                exec(compile(file.read(), state, "exec"), {"__name__": "__main__"})
        mass, = [source for source in simple.GetSources().values() if source.GetXMLName() == "MassPropertiesGPU"]
        mass.UpdatePipeline()
        check_table(os.path.splitext(state)[1], mass, mixed, ["bolt", "my alloy", "8000.5", "rail", "aluminium", "2700"])
    reader = mass.Input

edit(mass, "bolt", material="", density="")
edit(mass, "rail", material="", density="")
check_table("cleared", mass, FILE, [])
mass.Density = 1000.0
mass.UpdatePipeline()
check_table("density of all", mass, {part: ("", "1000 (Density)", 1000.0) for part in FILE}, [])
edit(mass, "plate", material="Lead")
check_table("but of one", mass, {**{part: ("", "1000 (Density)", 1000.0) for part in FILE}, "plate": ("Lead", "11340", 11340.0)},
            ["plate", "Lead", "11340"])
mass.Density = 0.0

# A material that is not known gives no rule; a message says so. The row keeps what was typed.
edit(mass, "rail", material="unobtainium")
check_equal("an unknown material: the row", ["unobtainium", "", "no density"], get_rows(mass)["rail"])
check_equal("an unknown material: the others have theirs", ["Lead", "11340"], get_rows(mass)["plate"][:2])
edit(mass, "rail", density="123.5")
check("an unknown material and a density", VOLUMES["rail"] * 123.5e-9, float(get_rows(mass)["rail"][2]), 1.3e-8, "six digits")

# A rule for no part of the input.
mass.Materials = ["nut*", "steel", "", "b*", "lead", ""]
mass.UpdatePipeline()
check_equal("a rule that fits no part", ["steel", "7850", "fits no part"], get_rows(mass)["nut*"])
check_equal("a rule that fits one", ["lead", "11340", ""], get_rows(mass)["b*"])

# Rules of a script stay as they are.
rules = ["b*", "lead", "", "plate", "", "1000", "bol?", "zinc", ""]
mass.Materials = rules
mass.UpdatePipeline()
cells = get_rows(mass)
check_equal("a script's rules", rules, list(mass.Materials))
check_equal("a script's rules: rows", ["plate", "bolt", "rail", "b*", "bol?", "Total"], list(cells))
check_equal("a script's rules: bolt", ["lead (below)", "11340 (below)"], cells["bolt"][:2])
check("a script's rules: mass of bolts", VOLUMES["bolt"] * 11340e-9, float(cells["bolt"][2]), 5.1e-6 * 2e-3, "six digits")
edit(mass, "rail", material="gold")
check_equal("an edit after a script: the first rule of a pattern counts", ["plate", "", "1000", "rail", "gold", "19300", "b*", "lead", "11340", "bol?", "zinc", "7140"],
            list(mass.Materials))
check_equal("an edit after a script: bolt", ["lead (below)", "11340 (below)"], get_rows(mass)["bolt"][:2])
edit(mass, "bolt", material="zinc")
check_equal("a rule of the very name goes before patterns", ["zinc", "7140"], get_rows(mass)["bolt"][:2])
check("a rule of the very name: mass of bolts", VOLUMES["bolt"] * 7140e-9, float(get_rows(mass)["bolt"][2]), 5.1e-6 * 2e-3, "six digits")

# A row that is added, and one that is removed.
table = list(mass.MaterialTable)
mass.MaterialTable = table[:4] + ["*", "brass", "", ""] + [cell for i in range(4, len(table), 4) if table[i] != "plate" for cell in table[i:i + 4]]
mass.UpdatePipeline()
check_true("a row above all", list(mass.Materials)[:3] == ["*", "brass", "8500"] and "plate" not in list(mass.Materials), str(list(mass.Materials)))
check_equal("a row above all: plate", ["brass (below)", "8500 (below)"], get_rows(mass)["plate"][:2])
mass.MaterialTable = []
mass.UpdatePipeline()
check_table("all rows removed", mass, FILE, [])

# Other inputs: the file is another one, or the reader.
edit(mass, "rail", material="steel")
nut = Part("nut", [((0, 0, 0), (2, 2, 2))], "8900.")
reader.FileName = write("materials_with_nut.step", nut)
mass.UpdatePipeline()
after = {**FILE, "rail": ("steel", "7850", 7850.0), "nut": ("", "8900 (file)", 8900.0)}
check_table("a file with one part more", mass, after, ["rail", "steel", "7850"])
other = simple.OpenDataFile(write_product(os.path.join(folder, "materials_nut.step"), nut))
other.UpdatePipeline()
mass.Input = other
check_equal("another input: its part", ["", "8900 (file)", ""], get_rows(mass)["nut"])
mass.UpdatePipeline()
check_equal("another input: the rule stays", ["rail", "steel", "7850"], list(mass.Materials))
check_equal("another input: rows", ["nut", "rail", "Total"], list(get_rows(mass)))

# Ticked solids only: both totals say so.
some = MassProperties(Input=reader, Density=1000.0, TotalRow=1)  # noqa: F821
some.UpdatePipeline()
everything = servermanager.Fetch(some, idx=1)
check_equal("total row", "Total", everything.GetValueByName(everything.GetNumberOfRows() - 1, "Name").ToString())
domain = some.SMProxy.GetProperty("Selectors").FindDomain("vtkSMDataAssemblyDomain")
some.Assembly = "Hierarchy"
domain.Update(None)
hierarchy = domain.GetDataAssembly()
some.Selectors = [hierarchy.GetNodePath(node) for node in hierarchy.GetChildNodes(0, False)[:2]]
some.UpdatePipeline()
ticked = servermanager.Fetch(some, idx=1)
solids, chosen = everything.GetNumberOfRows() - 1, ticked.GetNumberOfRows() - 1
check_true("several solids are ticked, not all", 1 < chosen < solids, f"{chosen} of {solids}")
check_equal("total row of ticked solids", f"Total of {chosen} of {solids} solids", ticked.GetValueByName(chosen, "Name").ToString())
check_equal("material table of ticked solids", "Total of ticked solids", list(some.MaterialTable)[-4])
expected = sum(ticked.GetValueByName(row, "Mass").ToDouble() for row in range(chosen))
check("mass in the total row", expected, ticked.GetValueByName(chosen, "Mass").ToDouble(), 1e-14 * expected, "rounding")
check("mass in the material table", expected, float(list(some.MaterialTable)[-1]), 5.1e-6 * expected, "six digits")
some.MaterialTable = list(some.MaterialTable)[:-4] + ["Total of ticked solids", "lead", "", ""]
check_equal("no rule of a total", [], list(some.Materials))
some.Selectors = []
some.UpdatePipeline()
check_equal("all again", "Total", list(some.MaterialTable)[-4])

# A trace has what was typed as rules, and not the cells of the table, which hold results.
smtrace.start_trace()
typed = smtrace.PropertiesModified(some.SMProxy)
some.MaterialTable = [list(some.MaterialTable)[0], "lead", "", ""] + list(some.MaterialTable)[4:]
typed.finalize()
trace = smtrace.stop_trace()
check_true("a trace has the rules", "Materials = [" in trace and "lead" in trace, trace)
check_true("a trace does not have the table", "MaterialTable" not in trace, trace)
some.Materials = []

# Sums downstream do not count a total that nobody asked for, and what was not computed has none.
some.TotalRow = 0
check_equal("no total row", solids, servermanager.Fetch(some, idx=1).GetNumberOfRows())
check_true("the summary keeps the total", "Mass: " in servermanager.Fetch(some, idx=2).GetValueByName(0, "Text").ToString())
limited = MassProperties(Input=reader, TotalRow=1, MaximumSeconds=1e-9)  # noqa: F821
check_equal("nothing computed: no total row", solids, servermanager.Fetch(limited, idx=1).GetNumberOfRows())

# Parts have a total: the product that is all, or a row of its own.
def get_parts(filter_proxy):
    table = servermanager.Fetch(filter_proxy, idx=7)
    return [{table.GetColumnName(i): table.GetValue(row, i) for i in range(table.GetNumberOfColumns())} for row in range(table.GetNumberOfRows())]


whole = get_parts(MassProperties(Input=reader))[0]  # noqa: F821
check_equal("parts: all is one product", ("machine", "assembly", 8, 7), (whole["Name"].ToString(), whole["Kind"].ToString(), whole["Solids"].ToInt(),
                                                                        whole["SolidsWithMass"].ToInt()))
path = write_product(os.path.join(folder, "materials_loose.step"), nut, Part("cube", [((0, 0, 20), (10, 10, 10))], "1.5", "g/cm^3"))
parts = get_parts(MassProperties(Input=simple.OpenDataFile(path)))  # noqa: F821
check_equal("parts: several", [("Total", "total", 2), ("cube", "part", 1), ("nut", "part", 1)],
            [(part["Name"].ToString(), part["Kind"].ToString(), part["Solids"].ToInt()) for part in parts])
for column, expected in (("Volume", 1008.0), ("MassInAll", 8.0 * 8900e-9 + 1000.0 * 1500e-9)):
    value = parts[0][column].ToDouble()
    check(f"parts: {column} of all", expected, value, parts[0][column + "Bound"].ToDouble() + 1e-15 * value, "its bound")

listed = subprocess.run([program, "--list-materials"], stdout=subprocess.PIPE, text=True, check=True).stdout
names = [" ".join(line.split()[:-2]) for line in listed.splitlines() if line.endswith(" kg/m^3")]
text = " ".join(mass.SMProxy.GetProperty("MaterialTable").GetDocumentation().GetDescription().split())
check_true("the tooltip lists the common materials", len(names) > 30 and f": {', '.join(names)}." in text, str(names))
finish()

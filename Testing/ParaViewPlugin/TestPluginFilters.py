"""TestPluginFilters.py PLUGIN.so FOLDER [HOST:PORT]: selected solids, values and inputs of every filter, in this process or on a server.

Filters of modules that are not built are left out.
"""
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check, check_equal, check_true, finish  # noqa: E402

from paraview import servermanager, simple  # noqa: E402

plugin, folder = sys.argv[1:3]
if len(sys.argv) > 3:
    host, port = sys.argv[3].split(":")
    simple.Connect(host, int(port))
    simple.LoadPlugin(plugin, remote=True, ns=globals())
simple.LoadPlugin(plugin, remote=False, ns=globals())
manifest = Manifest(folder)


def total(filter_proxy, name):
    array = servermanager.Fetch(filter_proxy, idx=0).GetFieldData().GetArray(name)
    return array.GetValue(0) if array else math.nan


def vector(filter_proxy, name):
    array = servermanager.Fetch(filter_proxy, idx=0).GetFieldData().GetArray(name)
    return [array.GetComponent(0, i) for i in range(3)] if array else 3 * [math.nan]


def has(proxy_name):
    return bool(servermanager.ProxyManager().SMProxyManager.HasDefinition("filters", proxy_name))


def is_accepted(proxy_name, source, port=0):
    """The check of the Filters menu before it offers a filter."""
    prototype = servermanager.ProxyManager().SMProxyManager.GetPrototypeProxy("filters", proxy_name)
    inputs = prototype.GetProperty("Input")
    inputs.RemoveAllUncheckedProxies()
    inputs.AddUncheckedInputConnection(source.SMProxy, port)
    accepted = inputs.IsInDomains()
    inputs.RemoveAllUncheckedProxies()
    return bool(accepted)


# Selected solids, as the tree of the panel sets them, from the product structure and from the blocks.
pair = manifest.special("two_solids")
ball = 4.0 / 3.0 * math.pi * 10.0 ** 3
reader = simple.OpenDataFile(pair["path"])
reader.UpdatePipeline()
mass = MassProperties(Input=reader)  # noqa: F821
mass.UpdatePipeline()
check("all solids by default", pair["volume"], total(mass, "Volume"), 1e-9 * pair["volume"])
check_equal("the trees to choose from", ["Hierarchy", "Assembly"], list(mass.GetProperty("Assembly").GetAvailable()))
domain = mass.SMProxy.GetProperty("Selectors").FindDomain("vtkSMDataAssemblyDomain")
domain.Update(None)
assembly = domain.GetDataAssembly()
leaves = [assembly.GetNodePath(node) for node in assembly.SelectNodes(["//*"]) if assembly.GetDataSetIndices(node, False)]
check_true("the tree has nodes to tick", len(leaves) >= 1, str(leaves))
mass.Assembly = "Hierarchy"
domain.Update(None)
hierarchy = domain.GetDataAssembly()
solids = [hierarchy.GetNodePath(node) for node in hierarchy.GetChildNodes(0, False)]
check_equal("blocks to tick", 2, len(solids))
volumes = []
for solid in solids:
    mass.Selectors = [solid]
    volumes.append(total(mass, "Volume"))
check("a block at a time: the ball", ball, min(volumes), 1e-9 * ball)
check("a block at a time: the box", 6000.0 if max(volumes) > 5000 else math.nan, max(volumes), 1e-5)
check_equal("rows of the table", 1, servermanager.Fetch(mass, idx=1).GetNumberOfRows())
mass.Selectors = []
check("all solids again", pair["volume"], total(mass, "Volume"), 1e-9 * pair["volume"])
mass.Density = 2000.0
check("one density for all, kg", pair["volume"] * 2e-6, total(mass, "Mass"), 1e-12 * pair["volume"])
mass.Materials = ["no such solid", "lead", "", "*", "made up", "3000.5"]
check("a material by a pattern, kg", pair["volume"] * 3000.5e-9, total(mass, "Mass"), 1e-12 * pair["volume"])
check_equal("its name", "made up", servermanager.Fetch(mass, idx=1).GetValueByName(0, "Material").ToString())
mass.Materials = ["*", "Water", ""]
check("a common one", pair["volume"] * 1e-6, total(mass, "Mass"), 1e-12 * pair["volume"])
mass.Materials = []
check("none again", pair["volume"] * 2e-6, total(mass, "Mass"), 1e-12 * pair["volume"])

# Integrals.
sphere = manifest.solid("sphere")
source = simple.OpenDataFile(sphere["path"])
integral = SurfaceIntegral(Input=source)  # noqa: F821
radius = (sphere["volume"] * 0.75 / math.pi) ** (1.0 / 3.0)
integral.Integrands = "willmore = meanCurvature * meanCurvature * dA\nflux = position.x ; 0 ; 0"
integral.MomentDegree = 2
integral.BendingEnergy = 1
integral.ProjectedAreaDirection = [0.0, 0.0, 2.0]
for name, expected in (("willmore", 4.0 * math.pi), ("flux", sphere["volume"]), ("moment_0_0_0", sphere["volume"]),
                       ("BendingEnergy", 8.0 * math.pi), ("ProjectedArea", math.pi * radius ** 2)):
    check(name, expected, total(integral, name), 1e-8 * expected)
check_true("the summary has them", "BendingEnergy = 25.13" in servermanager.Fetch(integral, idx=2).GetValueByName(
    0, "Text").ToString())
integral.Integrands = "willmore = meanCurvature * meanCurvature * dA\nwrong = dA * sine\nworse = 2 * (dA"
summary = servermanager.Fetch(integral, idx=2).GetValueByName(0, "Text").ToString()
for words in ("wrong was not computed", "column 6", "sine", "worse was not computed", "column 5"):
    check_true(f"the summary says {words}", words in summary, summary)
integral.Integrands = "foo = position.x\none = 1"
summary = servermanager.Fetch(integral, idx=2).GetValueByName(0, "Text").ToString()
check_equal("integrands without area element are refused, with the remedy", 2, " ".join(summary.split()).count("multiply it by dA, or a vector by normal"))
check_true("each mistake begins a line", "\nfoo was not computed" in summary and "\none was not computed" in summary, summary)
integral.Integrands = ""
integral.MomentDegree = -1
check_true("integrals that were removed have no array", math.isnan(total(integral, "willmore")) and math.isnan(total(integral, "moment_0_0_0")))
check_true("a cell array to colour by", servermanager.OutputPort(integral, 5).CellData["BendingEnergy"] is not None)

plain_volume = total(MassProperties(Input=source), "Volume")  # noqa: F821

# Below a waterline through the centre of the sphere: half of it, whose centre is 3/8 of the radius below.
center = sphere["center_of_mass"]
if has("Buoyancy"):
    afloat = Buoyancy(Input=source, Point=center, Normal=[0.0, 0.0, 2.0])  # noqa: F821
    half = 0.5 * sphere["volume"]
    check("displaced volume", half, total(afloat, "DisplacedVolume"), 1e-9 * sphere["volume"])
    check_true("displaced volume: its bound", 0.0 < total(afloat, "DisplacedVolumeBound") <= 1e-9 * sphere["volume"])
    lowered = [center[0], center[1], center[2] - 0.375 * radius]
    for axis in range(3):
        check(f"centre of buoyancy, axis {axis}", lowered[axis], vector(afloat, "CenterOfBuoyancy")[axis], 1e-8 * radius)
        check(f"displaced first moment, axis {axis}", half * lowered[axis], vector(afloat, "DisplacedFirstMoments")[axis],
              1e-8 * half * (radius + max(abs(each) for each in center)))
    check_true("the summary has it", "Displaced volume: " in servermanager.Fetch(afloat, idx=2).GetValueByName(0, "Text").ToString())
    for side, sign in (("below", 1.0), ("above", -1.0)):
        afloat.Point = [center[0], center[1], center[2] + sign * 2.0 * radius]
        text = servermanager.Fetch(afloat, idx=2).GetValueByName(0, "Text").ToString()
        check_true(f"wholly {side}", f"The solids lie wholly {side} the plane.\n" in text, text)
    afloat.Point = center
    afloat.Normal = [0.0, 0.0, -1.0]
    check("the half above", half, total(afloat, "DisplacedVolume"), 1e-9 * sphere["volume"])
    check("its centre", center[2] + 0.375 * radius, vector(afloat, "CenterOfBuoyancy")[2], 1e-8 * radius)

# The section with the same plane.
if has("SolidSection"):
    cut = Section(Input=source, Point=center, Normal=[0.0, 0.0, 2.0], Density=1000.0)  # noqa: F821
    check("section area", math.pi * radius ** 2, total(cut, "SectionArea"), 1e-8 * radius ** 2)
    check_true("section area: its bound", 0.0 < total(cut, "SectionAreaBound") <= 2e-8 * radius ** 2, str(total(cut, "SectionAreaBound")))
    for axis in range(3):
        check(f"centroid, axis {axis}", center[axis], vector(cut, "SectionCentroid")[axis], 1e-8 * radius)
    check("second moment", math.pi * radius ** 4 / 4, vector(cut, "SectionSecondMoments")[0], 1e-7 * radius ** 4)
    check("half of the mass, kg", 0.5e-6 * sphere["volume"], total(cut, "MassBelow"), 1e-14 * sphere["volume"])
    check("the other half", 0.5e-6 * sphere["volume"], total(cut, "MassAbove"), 1e-14 * sphere["volume"])
    clipped = servermanager.OutputPort(cut, 7)
    check("the clipped mesh ends at the plane", center[2], clipped.GetDataInformation().GetBounds()[5], 1e-6 * radius)
    check_equal("it has a section", (0.0, 1.0), clipped.CellData["Cap"].GetRange())
    check_true("the summary has it", "Section area: " in servermanager.Fetch(cut, idx=2).GetValueByName(0, "Text").ToString())
    check_equal("and the volume of the input stays", total(MassProperties(Input=source), "Volume"), plain_volume)  # noqa: F821

# A value that a script gives stays, 0 0 0 too, whether the input has run or not; without one there is the
# same value in both cases.
for name, property_name in (("Buoyancy", "Point"), ("Section", "Point"), ("NURBSDeform", "Displacement")):
    make = globals().get(name)
    values = []
    for has_run in (False, True) if make else ():
        input_of_both = simple.OpenDataFile(sphere["path"])
        if has_run:
            input_of_both.UpdatePipeline()
        given = make(Input=input_of_both, **{property_name: [0.0, 0.0, 0.0]})
        check_equal(f"{name}, input has run: {has_run}: 0 0 0 is kept", [0.0, 0.0, 0.0], list(getattr(given, property_name)))
        check_equal(f"{name}: and is in traces and states", 0, given.SMProxy.GetProperty(property_name).IsValueDefault())
        values.append(list(getattr(make(Input=input_of_both), property_name)))
    check_true(f"{name}: the same default", not make or (values[0] == values[1] and (values[0] != [0.0, 0.0, 0.0] or name == "NURBSDeform")), str(values))

# ParaView's filters call Modified() on the points that they read (Clip does): their input stays what it is.
# Two have other names in 6.1.
manager = servermanager.ProxyManager().SMProxyManager
filters = [name for name in ("Clip", "Cut", "Threshold", "PolyDataNormals", "SurfaceNormals", "CleanPolyData", "ExtractEdges", "FeatureEdges", "ElevationFilter",
                             "CellSize", "DecimatePro", "QuadricClustering", "MeshQuality", "GenerateIdScalars", "PointAndCellIds", "OutlineFilter", "ConvertToPointCloud")
           if manager.GetProxyDefinitionManager().HasDefinition("filters", name)]
check_true("filters of ParaView", len(filters) >= 14, str(filters))
for name in filters:
    beside = servermanager._getPyProxy(manager.NewProxy("filters", name))
    beside.Input = source
    beside.UpdatePipeline()
    check_true(f"after {name} the reader has exact solids", is_accepted("MassPropertiesGPU", source))
    check_equal(f"and the same volume after {name}", total(MassProperties(Input=source), "Volume"), plain_volume)  # noqa: F821

# The paper's scheme has no bounds and is not exact, but near with many sub-patches.
if has("SchemeMassProperties"):
    scheme = MassPropertiesbyPaperSchemes(Input=source, Scheme="3-point Gauss", SubPatchFactor=8, Density=1000.0)  # noqa: F821
    check("by the paper's scheme: volume", sphere["volume"], total(scheme, "Volume"), 1e-6 * sphere["volume"])
    check("by the paper's scheme: mass, kg", sphere["volume"] * 1e-6, total(scheme, "Mass"), 1e-12 * sphere["volume"])
    check_true("by the paper's scheme: no bound", math.isnan(total(scheme, "VolumeBound")))
    check_true("by the paper's scheme: its estimate", total(scheme, "PaperErrorEstimate") > 0.0)
    few = total(scheme, "SubPatches")
    scheme.SubPatchFactor = 16
    check("by the paper's scheme: sub-patches", 4.0 * few, total(scheme, "SubPatches"), 0.0)

# Edits follow one another, and the result is integrated.
edited = []
if has("NURBSTransform"):
    moved = NURBSTransform(Input=source, Translation=[1.0, 2.0, 3.0], Rotation=[10.0, 20.0, 30.0])  # noqa: F821
    deformed = NURBSDeform(Input=moved, Displacement=[radius, 0.0, 0.0], Radius=0.0)  # noqa: F821
    weighed = MassProperties(Input=deformed)  # noqa: F821
    check("moved and displaced: the volume stays", sphere["volume"], total(weighed, "Volume"), 1e-9 * sphere["volume"])
    check_equal("a centre that a script gives is kept", [0.0, 0.0, 0.0], list(NURBSDeform(  # noqa: F821
        Input=moved, Center=[0.0, 0.0, 0.0]).Center))
    deformed.Center = [1.0 + radius, 2.0, 3.0]
    deformed.Radius = radius
    check_true("a bulge adds to it", total(weighed, "Volume") > 1.001 * sphere["volume"], str(total(weighed, "Volume")))
    deformed.Displacement = [0.0, 0.0, 0.0]
    check("and without it the volume is as before", sphere["volume"], total(weighed, "Volume"), 1e-9 * sphere["volume"])
    edited = [("NURBS Transform", moved, 0, True), ("NURBS Deform", deformed, 0, True)]

# Ids: the number of a solid in the tables is the one that NURBS Deform takes, and so is that of a face.
if has("NURBSDeform"):
    columns = servermanager.Fetch(MassProperties(Input=reader), idx=1)  # noqa: F821
    ids = [columns.GetValueByName(row, "Id").ToString() for row in range(2)]
    check_equal("ids of the solids", ["1", "2"], ids)
    centers = [columns.GetColumnByName("CenterOfMass").GetComponent(row, 2) for row in range(2)]
    for row in range(2):
        lifted = NURBSDeform(Input=reader, SolidId=int(ids[row]), Displacement=[0.0, 0.0, 5.0])  # noqa: F821
        after = servermanager.Fetch(MassProperties(Input=lifted), idx=1).GetColumnByName("CenterOfMass")  # noqa: F821
        for other in range(2):
            check(f"solid {ids[row]} is lifted: height of solid {ids[other]}", centers[other] + (5.0 if other == row else 0.0),
                  after.GetComponent(other, 2), 1e-8 * radius)

# Inputs: exact faces are accepted, everything else is refused.
filters = [name for name in ("MassPropertiesGPU", "SurfaceIntegralGPU", "SchemeMassProperties", "Buoyancy", "SolidSection", "SolidStability",
                             "NURBSTransform", "NURBSDeform") if has(name)]
plain = simple.Transform(Input=source)
plain.Transform.Translate = [1.0, 0.0, 0.0]
wavelet = simple.Wavelet()
extracted = simple.ExtractBlock(Input=reader, Assembly="Hierarchy", Selectors=[solids[0]])
tessellated = simple.Sphere()
for each in [source, plain, wavelet, extracted, tessellated, mass] + [edit[1] for edit in edited]:
    each.UpdatePipeline()
for name in filters:
    for what, each, port, expected in edited + [("the reader", source, 0, True), ("an extracted block", extracted, 0, True),
                                                ("the bodies of Mass Properties", mass, 5, True), ("its marker", mass, 0, False),
                                                ("its table", mass, 1, False), ("ParaView's Transform", plain, 0, False),
                                                ("a wavelet", wavelet, 0, False), ("a mesh", tessellated, 0, False)]:
        check_equal(f"{name} takes {what}", expected, is_accepted(name, each, port))
check("the extracted block: volume", volumes[0], total(MassProperties(Input=extracted), "Volume"),  # noqa: F821
      1e-12 * pair["volume"])
# Without a display mesh, and then with one: the numbers stay.
def count_points(source, port=0):
    """In what the server holds: a filter connected here to look at it would be one that needs the mesh."""
    source.SMProxy.GetOutputPort(port).InvalidateDataInformation()
    return source.SMProxy.GetOutputPort(port).GetDataInformation().GetNumberOfPoints()


for port in (None, 5):
    reader = simple.OpenDataFile(pair["path"])
    check_equal("ParaView's default", "Always", reader.DisplayMesh)
    reader.DisplayMesh = "Never"
    mass = MassProperties(Input=reader)  # noqa: F821
    mass.UpdatePipeline()
    volume = total(mass, "Volume")
    check("volume without a mesh", pair["volume"], volume, 1e-9 * pair["volume"])
    check_equal("points without a filter of ParaView", [0, 0], [count_points(reader), count_points(mass, 5)])
    reader.DisplayMesh = "Always"
    elevation = simple.Elevation(Input=reader if port is None else servermanager.OutputPort(mass, port))
    elevation.UpdatePipeline()
    points = count_points(elevation)
    check_true("points of the filter", points > 0)
    check_equal("points of the reader then", points, count_points(reader))
    mass.UpdatePipeline()
    check_equal("volume with a mesh", volume, total(mass, "Volume"))
    check_equal("points of the solids with a mesh", points, count_points(mass, 5))

finish()

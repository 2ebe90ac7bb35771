"""TestSavedSolids.py SOLIDS FOLDER READER PROGRAM: solids that are read and saved have the right volume in another program.

READER: gmsh (Python's module; PROGRAM: any), freecad (PROGRAM: the folder of FreeCAD.so), both by OpenCASCADE's integrals at their default, or
occt-import-js (PROGRAM: its occt-import-js.js), whose triangles have the volume of those of the file that was read. Planes, cylinders, cones,
spheres and tori must arrive as such: as rational B-splines their volumes are wrong there by up to 1 %.
"""
import json
import math
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check, check_equal, check_true, finish  # noqa: E402
from smstepbody import EMPTY, Body, format_real  # noqa: E402

from solidmoments.smFiltersMassProperties import vtkMassPropertiesGPU  # noqa: E402
from solidmoments.smFiltersNURBSEdit import vtkNURBSDeform, vtkNURBSTransform  # noqa: E402
from solidmoments.smReadersKernel import vtkBREPWriter, vtkSTEPWriter  # noqa: E402
from solidmoments.smReadersSTEP import vtkSTEPReader  # noqa: E402

manifest, folder, reader_name, program = Manifest(sys.argv[1]), sys.argv[2], sys.argv[3], sys.argv[4]
os.makedirs(folder, exist_ok=True)
certified = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Certified", "solids")
EXPECTED = {"sphere": {"Sphere"}, "cylinder": {"Cylinder", "Plane"}, "cone": {"Cone", "Plane"}, "torus": {"Torus"},
            "hollow_sphere": {"Sphere"}, "bicylinder": {"Cylinder"}, "slanted_hole": {"Cylinder", "Plane"}, "box": {"Plane"}}
# Assemblies and parts with several kinds, whose volumes certified.json has.
CERTIFIED = {"assembly": {"Plane"}, "mirror_pair": {"Plane"}, "groove": {"Cylinder", "Plane", "Torus"}, "bored_sphere": {"Cylinder", "Sphere"},
             "capsule": {"Cylinder", "Sphere"}, "lens": {"Sphere"}}


def read_gmsh(paths):
    """Solids, volumes in mm^3 and kinds of faces."""
    import gmsh

    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setString("Geometry.OCCTargetUnit", "MM")
    found = {}
    for path in paths:
        gmsh.clear()
        gmsh.model.occ.importShapes(path)
        gmsh.model.occ.synchronize()
        solids = gmsh.model.getEntities(3)
        found[path] = {"volume": sum(gmsh.model.occ.getMass(3, tag) for _, tag in solids), "solids": len(solids),
                       "kinds": sorted({gmsh.model.getType(2, tag) for _, tag in gmsh.model.getEntities(2)})}
    gmsh.finalize()
    return found


def read_others(paths):
    """What read_freecad.py or read_occt_import.mjs print."""
    here = os.path.dirname(os.path.abspath(__file__))
    command = {"freecad": [sys.executable, "-B", os.path.join(here, "read_freecad.py")], "occt-import-js": ["node", os.path.join(here, "read_occt_import.mjs")]}
    # Python's modules of this build are none of FreeCAD's.
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    result = subprocess.run(command[reader_name] + [program] + paths, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment,
                            universal_newlines=True, timeout=600, check=False)
    check_equal(f"exit status of {reader_name}", 0, result.returncode)
    check_true(f"what {reader_name} prints", result.returncode == 0, result.stderr[-600:])
    lines = [line for line in result.stdout.splitlines() if line.startswith("{")]
    answer = json.loads(lines[-1]) if lines else {"files": {}}
    print(reader_name, answer.get("version", ""), answer.get("OpenCASCADE", ""))
    return answer["files"]


def save(source, name):
    """Writes what a filter has, in three units and as BREP. Returns the paths."""
    paths = []
    for unit in ("mm", "inch", "m", "brep"):
        writer = vtkBREPWriter() if unit == "brep" else vtkSTEPWriter()
        if unit != "brep":
            writer.SetOutputUnit(unit)
        paths.append(os.path.join(folder, f"{name}-{unit}.{'brep' if unit == 'brep' else 'step'}"))
        writer.SetInputConnection(source.GetOutputPort())
        writer.SetFileName(paths[-1])
        check_equal(f"{paths[-1]}: written", 1, writer.Write())
    return paths


def read(path):
    reader = vtkSTEPReader()
    reader.SetFileName(path)
    reader.SetOutputUnit("mm")
    return reader


def move(reader, mirror):
    moved = vtkNURBSTransform()
    moved.SetInputConnection(reader.GetOutputPort())
    moved.SetMirror(mirror)
    moved.SetRotation(31.0, -17.0, 53.0)
    moved.SetTranslation(3.3, -1.7, 2.9)
    return moved


def prism(body, ring, low, high):
    """A shell; the ring is anticlockwise."""
    count = len(ring)
    ends = [[(x, y, z) for x, y in ring] for z in (low, high)]
    vertices = [[body.vertex(p) for p in points] for points in ends]
    flat = [[body.line_edge(v[i], v[(i + 1) % count], p[i], p[(i + 1) % count]) for i in range(count)] for v, p in zip(vertices, ends)]
    up = [body.line_edge(vertices[0][i], vertices[1][i], ends[0][i], ends[1][i]) for i in range(count)]

    def plane(point, normal, direction):
        return body.add(f"PLANE('',{body.axes(point, normal, direction)})")

    faces = [body.face([body.loop([(edge, False) for edge in reversed(flat[0])])], plane(ends[0][0], (0.0, 0.0, -1.0), (1.0, 0.0, 0.0))),
             body.face([body.loop([(edge, True) for edge in flat[1]])], plane(ends[1][0], (0.0, 0.0, 1.0), (1.0, 0.0, 0.0)))]
    for i, (x, y) in enumerate(ring):
        j = (i + 1) % count
        length = math.hypot(ring[j][0] - x, ring[j][1] - y)
        along = ((ring[j][0] - x) / length, (ring[j][1] - y) / length)
        sides = body.loop([(flat[0][i], True), (up[j], True), (flat[1][i], False), (up[i], False)])
        faces.append(body.face([sides], plane(ends[0][i], (along[1], -along[0], 0.0), (*along, 0.0))))
    return body.add(f"CLOSED_SHELL('',({','.join(faces)}))")


def write_sink(path):
    """A heat sink, whose volume is small for its area, with an L-shaped void and a box within the L's box. Returns its volume."""
    body = Body()
    ring = [(0.0, 0.0), (100.0, 0.0)]
    for k in reversed(range(100)):
        ring += [(k + 1.0, 100.0), (k + 0.8, 100.0), (k + 0.8, 30.0), (float(k), 30.0)]
    outer = prism(body, ring, 0.0, 100.0)
    angle = prism(body, [(5.0, 5.0), (95.0, 5.0), (95.0, 8.0), (8.0, 8.0), (8.0, 25.0), (5.0, 25.0)], 10.0, 90.0)
    room = prism(body, [(40.0, 12.0), (60.0, 12.0), (60.0, 22.0), (40.0, 22.0)], 30.0, 60.0)
    voids = [body.add(f"ORIENTED_CLOSED_SHELL('',*,{shell},.F.)") for shell in (angle, room)]
    body.product("sink", body.shape([body.identity, body.add(f"BREP_WITH_VOIDS('sink',{outer},({','.join(voids)}))")]))
    with open(path, "w", encoding="ascii") as text:
        text.write(body.get_text())
    return 100.0 * (100.0 * 30.0 + 100 * 0.2 * 70.0) - 80.0 * (90.0 * 3.0 + 3.0 * 17.0) - 20.0 * 10.0 * 30.0


def circle_edge(body, start, end, center, radius, z, x):
    return body.add(f"EDGE_CURVE('',{start},{end},{body.add(f'CIRCLE({EMPTY},{body.axes(center, z, x)},{format_real(radius)})')},.T.)")


def write_slice(path, kind):
    """A hundredth of a turn or less of a ring: its control points determine no axis to rounding. Returns its volume."""
    angle, inner, outer = 0.01, 8.0, 10.0
    height = 6.0 if kind == "sphere" else 2.0
    body = Body()
    turns = [(math.cos(a), math.sin(a)) for a in (0.0, angle)]
    points = [[(radius * c, radius * s, z) for radius, z in ((inner, 0.0), (outer, 0.0), (inner, height))] for c, s in turns]
    vertices = [[body.vertex(p) for p in row] for row in points]
    rims = [circle_edge(body, vertices[0][k], vertices[1][k], (0.0, 0.0, points[0][k][2]), math.hypot(*points[0][k][:2]), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0))
            for k in range(3)]
    profiles = []
    for (c, s), v, p in zip(turns, vertices, points):
        lines = [body.line_edge(v[k], v[(k + 1) % 3], p[k], p[(k + 1) % 3]) for k in (0, 2)]
        center = {"torus": p[0], "sphere": (0.0, 0.0, 0.0)}.get(kind)
        round_edge = circle_edge(body, v[1], v[2], center, outer if kind == "sphere" else 2.0, (s, -c, 0.0), (c, s, 0.0)) if center else None
        profiles.append([lines[0], round_edge or body.line_edge(v[1], v[2], p[1], p[2]), lines[1]])
    axes = body.axes((0.0, 0.0, 0.0), (0.0, 0.0, -1.0 if kind == "cone" else 1.0))
    round_surface = {"cone": f"CONICAL_SURFACE('',{axes},10.,{format_real(math.pi / 4.0)})", "torus": f"TOROIDAL_SURFACE('',{axes},8.,2.)",
                     "sphere": f"SPHERICAL_SURFACE('',{axes},10.)"}[kind]
    surfaces = [body.add(f"PLANE('',{body.axes((0.0, 0.0, 0.0), (0.0, 0.0, -1.0))})"), body.add(round_surface),
                body.add(f"CYLINDRICAL_SURFACE('',{body.axes((0.0, 0.0, 0.0))},8.)")]
    faces = []
    for k, surface in enumerate(surfaces):
        loop = body.loop([(profiles[0][k], False), (rims[k], True), (profiles[1][k], True), (rims[(k + 1) % 3], False)])
        faces.append(body.face([loop], surface, k != 2))
    for side, (c, s) in enumerate(turns):
        way = 1.0 if side else -1.0
        plane = body.add(f"PLANE('',{body.axes((0.0, 0.0, 0.0), (-way * s, way * c, 0.0), (c, s, 0.0))})")
        uses = [(edge, side == 0) for edge in profiles[side]]
        faces.append(body.face([body.loop(uses[::-1] if side else uses)], plane))
    body.product("slice", body.shape([body.identity, body.solid(faces)]))
    with open(path, "w", encoding="ascii") as text:
        text.write(body.get_text())
    return angle * {"cone": 2.0 * (8.0 + 2.0 / 3.0), "torus": 8.0 * math.pi + 8.0 / 3.0, "sphere": 72.0}[kind]


def write_apple(path):
    """The upper half of an apple: a torus that crosses its axis, and a plane. Returns its volume."""
    body = Body()
    top = math.sqrt(21.0)
    rim, apex = body.vertex((7.0, 0.0, 0.0)), body.vertex((0.0, 0.0, top))
    circle = circle_edge(body, rim, rim, (0.0, 0.0, 0.0), 7.0, (0.0, 0.0, 1.0), (1.0, 0.0, 0.0))
    seam = circle_edge(body, rim, apex, (2.0, 0.0, 0.0), 5.0, (0.0, -1.0, 0.0), (1.0, 0.0, 0.0))
    torus = body.add(f"TOROIDAL_SURFACE('',{body.axes((0.0, 0.0, 0.0))},2.,5.)")
    plane = body.add(f"PLANE('',{body.axes((0.0, 0.0, 0.0), (0.0, 0.0, -1.0))})")
    faces = [body.face([body.loop([(circle, True), (seam, True), (seam, False)])], torus), body.face([body.loop([(circle, False)])], plane)]
    body.product("apple", body.shape([body.identity, body.solid(faces)]))
    with open(path, "w", encoding="ascii") as text:
        text.write(body.get_text())
    # Of rings between the outer and, above the apex, the inner radius 2 +- sqrt(25 - z^2).
    return math.pi * (18.0 * top - 50.0 * math.asin(top / 5.0) + 50.0 * math.pi)


# By path: the volume, the kinds of faces, the number of solids, and the file that was read.
saved = {}
sources = [(manifest.solid(solid, variant)["path"], f"{solid}-{variant}", manifest.solid(solid, variant)["volume"], kinds, 1)
           for solid, kinds in EXPECTED.items() for variant in ("plain", "turned", "mirrored")]
with open(os.path.join(certified, "certified.json"), encoding="utf-8") as text:
    content = json.load(text)
for solid, kinds in CERTIFIED.items():
    entry = next(item for item in content["solids"] if item["file"] == f"{solid}.step")
    middle = sum(float(x) for x in entry["volume"]) / 2
    sources.append((os.path.join(certified, f"{solid}.step"), solid, middle, kinds, {"assembly": 3, "mirror_pair": 2}.get(solid, 1)))
sink = os.path.join(folder, "sink.step")
sources.append((sink, "sink", write_sink(sink), {"Plane"}, 1))
for kind in ("cone", "sphere", "torus"):
    path = os.path.join(folder, f"slice-{kind}.step")
    sources.append((path, f"slice-{kind}", write_slice(path, kind), {"Cylinder", "Plane", kind.capitalize()}, 1))
apple = os.path.join(folder, "apple.step")
sources.append((apple, "apple", write_apple(apple), {"Plane", "Surface of Revolution"}, 1))
readers = {}
for path, name, volume, kinds, count in sources:
    readers[name] = read(path)
    variants = {"": readers[name]}
    if "-" not in name or name.endswith("-plain"):
        variants.update({"-moved": move(readers[name], 0), "-reflected": move(readers[name], 1)})
    for variant, source in variants.items():
        saved.update({item: (volume, kinds, count, path) for item in save(source, name + variant)})
# An edit of one corner of a box: the faces that it did not move stay planes, and the others are B-splines
# without weights.
edited = vtkNURBSDeform()
edited.SetInputConnection(readers["box-plain"].GetOutputPort())
bounds = [0.0] * 6
readers["box-plain"].GetOutputDataObject(0).GetBounds(bounds)
edited.SetCenter(*bounds[1::2])
edited.SetRadius(15.0)
edited.SetDisplacement(1.2, 0.9, 0.6)
mass = vtkMassPropertiesGPU()
mass.SetBackend(vtkMassPropertiesGPU.CPU)
mass.SetInputConnection(edited.GetOutputPort())
mass.Update()
volume = mass.GetOutputDataObject(0).GetFieldData().GetArray("Volume").GetValue(0)
check_true("the edit changes the volume", abs(volume - manifest.solid("box")["volume"]) > 1.0, str(volume))
saved.update({item: (volume, {"BSpline surface", "Plane"}, 1, None) for item in save(edited, "box-edited")})

paths = sorted(saved)
if reader_name == "occt-import-js":
    # Its triangles of an edited face have no file to be compared with.
    paths = [path for path in paths if saved[path][3]]
    found = read_others(sorted({saved[path][3] for path in paths}) + paths)
else:
    found = read_gmsh(paths) if reader_name == "gmsh" else read_others(paths)
for path in paths:
    volume, kinds, count, source = saved[path]
    name = os.path.basename(path)
    if path not in found:
        check_true(f"{name}: read by {reader_name}", False)
        continue
    check_equal(f"{name}: solids in {reader_name}", count, found[path]["solids"])
    if reader_name == "occt-import-js":
        check(f"{name}: the triangles of the file that was read", found[source]["volume"], found[path]["volume"], 1e-5 * volume, "some diagonals depend on roundings")
        check(f"{name}: volume of triangles", volume, found[path]["volume"], 1e-2 * volume, "angles of 0.2: a disc of triangles lacks 0.2^2 / 6")
        check_true(f"{name}: triangles", found[path]["triangles"] > 10)
        continue
    check_equal(f"{name}: kinds of faces", sorted(kinds), found[path]["kinds"])
    check_true(f"{name}: valid", found[path].get("valid", True))
    check(f"{name}: volume in {reader_name}", volume, found[path]["volume"], 1e-9 * volume,
          "OpenCASCADE's Gauss rules on elementary faces with edges of degree 12")
finish()

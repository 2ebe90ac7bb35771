"""TestExternalFiles.py --program SOLIDMOMENTS --output FOLDER: assemblies whose parts are in other STEP files.

Parts are boxes of known size and place; each assembly names files by APPLIED_DOCUMENT_REFERENCE. What is found is weighed in its place,
what is not is named and flagged, and nothing outside the folders is opened.
"""
import argparse
import json
import os
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check, check_equal, check_true, finish  # noqa: E402
from smproduct import Assembly, Part, write_product  # noqa: E402

parser = argparse.ArgumentParser()
for option in ("--program", "--output"):
    parser.add_argument(option, required=True)
options = parser.parse_args()
folder = os.path.join(options.output, "external")
shutil.rmtree(folder, ignore_errors=True)
os.makedirs(os.path.join(folder, "library", "deep"))

HEADER = ("ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
          "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n")


def write_assembly(path, parts, unit="MILLI"):
    """`parts`: (file as it is written, (x, y, z) in the unit)."""
    lines = []

    def add(text):
        lines.append(text)
        return f"#{len(lines)}"

    def frame(x, y, z):
        point = add(f"CARTESIAN_POINT('',({float(x)},{float(y)},{float(z)}))")
        return add(f"AXIS2_PLACEMENT_3D('',{point},$,$)")

    context = add("PRODUCT_CONTEXT('',$,'mechanical')")
    design = add("PRODUCT_DEFINITION_CONTEXT('part definition',$,'design')")
    length = add(f"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT({'.MILLI.' if unit == 'MILLI' else '$'},.METRE.))")
    angle = add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
    units = add(f"(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle}))REPRESENTATION_CONTEXT('',''))")

    def product(name, items):
        entity = add(f"PRODUCT('{name}','{name}','',({context}))")
        formation = add(f"PRODUCT_DEFINITION_FORMATION('','',{entity})")
        definition = add(f"PRODUCT_DEFINITION('design','',{formation},{design})")
        shape = add(f"SHAPE_REPRESENTATION('',({','.join(items)}),{units})")
        add(f"SHAPE_DEFINITION_REPRESENTATION({add(f'PRODUCT_DEFINITION_SHAPE($,$,{definition})')},{shape})")
        return definition, shape

    places = [frame(*place) for _, place in parts]
    whole, whole_shape = product("whole", places + [frame(0, 0, 0)])
    for k, (file, _) in enumerate(parts):
        origin = frame(0, 0, 0)
        part, shape = product(f"part{k}", [origin])
        usage = add(f"NEXT_ASSEMBLY_USAGE_OCCURRENCE('{k}','part{k}','',{whole},{part},$)")
        motion = add(f"ITEM_DEFINED_TRANSFORMATION('','',{origin},{places[k]})")
        relation = add(f"(REPRESENTATION_RELATIONSHIP('','',{shape},{whole_shape})REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({motion})"
                       "SHAPE_REPRESENTATION_RELATIONSHIP())")
        add(f"CONTEXT_DEPENDENT_SHAPE_REPRESENTATION({relation},{add(f'PRODUCT_DEFINITION_SHAPE($,$,{usage})')})")
        document = add(f"DOCUMENT_FILE('{file}','','',{add('DOCUMENT_TYPE($)')},'',$)")
        add(f"APPLIED_DOCUMENT_REFERENCE({document},'',({part}))")
        role = add("OBJECT_ROLE('mandatory',$)")
        add(f"ROLE_ASSOCIATION({role},#{len(lines) - 1})")
    with open(path, "w", encoding="ascii") as text:
        text.write(HEADER + "".join(f"#{k}={line};\n" for k, line in enumerate(lines, 1)) + "ENDSEC;\nEND-ISO-10303-21;\n")
    return path


def run(path, *more):
    done = subprocess.run([options.program, "--quiet", "--backend", "cpu", *more, "--json", "-", path], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, encoding="utf-8", timeout=100, check=False)
    return done.returncode, json.loads(done.stdout)["files"][0]


def check_whole(name, path, volume, center, *more):
    code, entry = run(path, *more)
    check_equal(name + ": status", "ok", entry["status"])
    check_equal("  exit status", 0, code)
    check("  volume", volume, entry["total"]["volume"], 1e-12 * volume)
    for c in range(3):
        check("  centre", center[c], entry["total"]["center_of_mass"][c], 1e-10)
    return entry


def check_flagged(name, path, words, volume=None):
    code, entry = run(path)
    check_true(name + ": flagged", entry["status"] not in ("ok", "tolerance-not-met") and code in (2, 3), f"{entry['status']} {code}")
    text = "\n".join(entry["messages"])
    for word in words:
        check_true(f"  says {word!r}", word in text, text)
    if volume is not None:
        check("  the others are weighed", volume, entry["total"]["volume"], 1e-12 * volume)


plate = write_product(os.path.join(folder, "plate.step"), Part("plate", [((0, 0, 0), (2, 3, 4))]))
write_product(os.path.join(folder, "library", "bolt.step"), Part("bolt", [((0, 0, 0), (1, 1, 2))]))
shutil.copy(plate, os.path.join(folder, "library", "deep", "plate.step"))
write_product(os.path.join(folder, "inch.step"), Part("inch", [((0, 0, 0), (1, 1, 1))], unit="inch"))
write_product(os.path.join(folder, "pair.step"), Assembly("pair", [(Part("a", [((0, 0, 0), (1, 1, 1))]), (0, 0, 0), None),
                                                                   (Part("b", [((0, 0, 0), (1, 1, 1))]), (3, 0, 0), None)]))
with open(os.path.join(folder, "note.txt"), "w", encoding="ascii") as note:
    note.write("not a STEP file\n")
at = os.path.join

entry = check_whole("a part twice", write_assembly(at(folder, "twice.step"), [("plate.step", (10, 0, 0)), ("plate.step", (20, 0, 0))]), 48.0, (16, 1.5, 2))
check_true("  says which numbers it has", any("plate.step was read with this one" in text for text in entry["messages"]), str(entry["messages"]))
check_equal("  it is one body", 2, len(entry["solids"]))
check_whole("a folder in the name", write_assembly(at(folder, "below.step"), [("library/bolt.step", (0, 0, 5))]), 2.0, (0.5, 0.5, 6))
check_whole("backslashes", write_assembly(at(folder, "slashed.step"), [("library\\\\bolt.step", (0, 0, 5))]), 2.0, (0.5, 0.5, 6))
check_whole("--search", write_assembly(at(folder, "search.step"), [("bolt.step", (1, 0, 0)), ("plate.step", (0, 0, 0))]), 26.0,
            ((1.5 * 2 + 24) / 26, (1 + 36) / 26, (2 + 48) / 26), "--search", at(folder, "library"))
check_whole("an inch in an assembly of metres", write_assembly(at(folder, "metres.step"), [("inch.step", (1, 0, 0))], "METRE"), 25.4 ** 3,
            (1012.7, 12.7, 12.7))
check_whole("an assembly as a part", write_assembly(at(folder, "nested.step"), [("pair.step", (0, 10, 0)), ("plate.step", (0, 0, 0))]), 26.0,
            ((0.5 + 3.5 + 24) / 26, (10.5 * 2 + 36) / 26, (1 + 48) / 26))
check_whole("a file that names others", write_assembly(at(folder, "upper.step"), [("twice.step", (0, 0, 100))]), 48.0, (16, 1.5, 102))
check_whole("an absolute name: its last part", write_assembly(at(folder, "absolute.step"), [("C:/of/the/author/plate.step", (0, 0, 0))]), 24.0, (1, 1.5, 2))

many = [(f"part{k}.step", (0, 0, 10 * k)) for k in range(15)]
for file, _ in many:
    write_product(at(folder, file), Part("part", [((0, 0, 0), (1, 1, 1))]))
check_whole("fifteen files", write_assembly(at(folder, "many.step"), many), 15.0, (0.5, 0.5, 70.5))

check_flagged("a missing file", write_assembly(at(folder, "missing.step"), [("plate.step", (0, 0, 0)), ("nowhere.step", (9, 0, 0))]), ["nowhere.step"], 24.0)
check_flagged("a file of another kind", write_assembly(at(folder, "other.step"), [("plate.step", (0, 0, 0)), ("note.txt", (9, 0, 0))]), ["note.txt of product #40 is not a STEP file"], 24.0)
check_flagged("the file itself", write_assembly(at(folder, "itself.step"), [("plate.step", (0, 0, 0)), ("itself.step", (9, 0, 0))]),
              ["itself.step, which contains it"], 24.0)
for name, other in (("first.step", "second.step"), ("second.step", "first.step")):
    write_assembly(at(folder, name), [("plate.step", (0, 0, 0)), (other, (50, 0, 0))])
check_flagged("files that contain each other", at(folder, "first.step"), ["which contains it"], 48.0)

# Nothing outside the folders is read: neither by a name, nor by a link.
inner = at(folder, "library", "deep")
os.remove(at(inner, "plate.step"))
check_flagged("a climbing name", write_assembly(at(inner, "climbing.step"), [("../../plate.step", (0, 0, 0))]), ["plate.step"])
check_flagged("an absolute name", write_assembly(at(inner, "rooted.step"), [(os.path.abspath(plate), (0, 0, 0))]), ["plate.step"])
os.symlink(os.path.abspath(plate), at(inner, "link.step"))
check_flagged("a link", write_assembly(at(inner, "linked.step"), [("link.step", (0, 0, 0))]), ["link.step"])
finish()

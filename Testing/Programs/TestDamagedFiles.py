"""TestDamagedFiles.py --program SOLIDMOMENTS --output DIR (--solids FOLDER | --hostile FOLDER): a file that declares more than was read,
or that contradicts itself, is not ok.

--solids    exact solids, damaged in one place each; the same file without the damage is ok
--hostile   the files of a folder of damaged and contradictory files, with what each must get
"""
import argparse
import glob
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check, check_equal, check_true, finish  # noqa: E402
from smprogram import compute  # noqa: E402

parser = argparse.ArgumentParser()
for option in ("program", "output", "solids", "hostile"):
    parser.add_argument("--" + option)
options = parser.parse_args()
FLAGGED = {"suspect", "open"}


def run(path, *more):
    """Exit status and the entry of the file; every file ends within a minute."""
    return compute(options.program, path, *more, timeout=60)


def expect(name, path, statuses, words, volume=None):
    code, entry = run(path)
    check_true(name + ": status", entry["status"] in statuses, f"{entry['status']}, {sorted(statuses)} expected")
    exits = {"ok": 0, "unreadable": 2}
    check_equal(name + ": exit status", exits.get(entry["status"], 3), code)
    text = "\n".join(entry["messages"])
    for word in words:
        check_true(f"{name}: says {word!r}", word in text, text)
    if "was lost" in words:
        check_true(name + ": says it before what is damaged", text.index(" was lost") < (text + "\nEntity #").index("\nEntity #"), text)
    if volume is not None:
        check(name + ": volume", volume, entry["total"]["volume"], 3e-12 * volume)


def replace(text, pattern, new):
    """Replaces the first match, which must exist."""
    changed, count = re.subn(pattern, new, text, count=1)
    check_true(f"{pattern} is there", count == 1)
    return changed


def damage(source, name, changes, statuses, words, volume=None):
    with open(os.path.join(options.solids, source), encoding="utf-8") as file:
        text = file.read()
    for pattern, new in changes:
        text = replace(text, pattern, new)
    path = os.path.join(options.output, f"damaged_{name}.step")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    expect(name, path, statuses, words, volume)


def check_unread():
    """Damage between two parts that know nothing of each other: nothing refers to what is skipped."""
    texts = []
    for source in ("sphere-plain.step", "box-plain.step"):
        with open(os.path.join(options.solids, source), encoding="utf-8") as file:
            texts.append(file.read())
    start = re.search(r"DATA;\s*", texts[1]).end()
    second = re.sub(r"#(\d+)", lambda number: f"#{int(number[1]) + 100000}", texts[1][start : texts[1].rindex("ENDSEC;")])
    at = texts[0].rindex("ENDSEC;")
    path = os.path.join(options.output, "damaged_unread.step")
    cases = {"sound": second, "early end": "ENDSEC;\n" + second, "section without a name": "ENDSEC;\nDA TA;\n" + second,
             "no =": second.replace(" = ", " "), "no numbers": second.replace("#", "-"), "numbers too large": second.replace("#", "#99999999999999999999"),
             "anchors": "ENDSEC;\nANCHOR;\n" + second}
    for name, text in cases.items():
        check_true(name + " is another text", (text == second) == (name == "sound"))
        with open(path, "w", encoding="utf-8") as file:
            file.write(texts[0][:at] + text + texts[0][at:])
        expect("two parts, " + name, path, {"ok"} if name == "sound" else FLAGGED, [] if name == "sound" else ["was not read", "Line "])


def check_parameter_curves():
    """Parameter curves off the curves of their edges, which are taken. What they prefer is stated by each curve."""
    cylinder, said = "cylinder-plain.step", "which is taken, although the file prefers the parameter curve"
    for name, edge, change in (("circle", 21, (r"(#49 = CIRCLE\('',#\d+,)8\.", r"\g<1>6.")), ("line", 21, (r"(#38 = CARTESIAN_POINT\('',\([^,]*,)2\.5", r"\g<1>2.0")),
                               ("seam", 55, (r"(#66 = CARTESIAN_POINT\('',\()6\.", r"\g<1>5."))):
        damage(cylinder, "parameter_" + name, [change], FLAGGED, [f"Edge #{edge} of the file: its parameter curve", said])
    damage(cylinder, "parameter_circle_not_preferred", [(r"(#49 = CIRCLE\('',#\d+,)8\.", r"\g<1>6."), (r"(#24 = SURFACE_CURVE.*\.)PCURVE_S1", r"\1CURVE_3D")],
           {"ok"}, ["its parameter curve #42 lies 2 mm from its curve #25, which is taken."])
    damage("wavy_plate-plain.step", "parameter_spline", [(r"(#98 = CARTESIAN_POINT\('',\()0\.0", r"\g<1>0.3")], FLAGGED, [said])
    # Whole turns are not difference, and angles may be in radians where the file's unit is a degree.
    degree = (r"\( NAMED_UNIT\(\*\) PLANE_ANGLE_UNIT\(\) SI_UNIT\(\$,\.RADIAN\.\) \);", "(CONVERSION_BASED_UNIT('DEGREE',#901)NAMED_UNIT(*)PLANE_ANGLE_UNIT());\n"
              "#901=PLANE_ANGLE_MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(0.0174532925199432958),#902);\n#902=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));")
    for name, changes in (("turned", [(r"(#66 = CARTESIAN_POINT\('',\()6\.2831853071795862", r"\g<1>12.5663706143591725")]), ("in_degrees", [degree, (
            r"(#66 = CARTESIAN_POINT\('',\()6\.2831853071795862", r"\g<1>360.")]), ("in_radians", [degree])):
        damage(cylinder, "parameter_curve_" + name, changes, {"ok"}, [])
        code, entry = run(os.path.join(options.output, f"damaged_parameter_curve_{name}.step"))
        check_equal("nothing is reported", (0, []), (code, entry["messages"]))


def check_solids():
    for source in ("box-plain.step", "cylinder-plain.step", "two_solids.step", "hollow_sphere-plain.step"):
        expect(source, os.path.join(options.solids, source), {"ok"}, [])
    box = "box-plain.step"
    damage(box, "bound_of_another_face", [(r"(#137 = ADVANCED_FACE\('',\()#\d+", r"\1#18")], FLAGGED, ["#137", "#18"])
    damage(box, "face_of_nothing", [(r"(#16 = CLOSED_SHELL\('',\()#17,", r"\1")], FLAGGED, ["#17"])
    damage(box, "face_undefined", [(r"(#16 = CLOSED_SHELL\('',\()#17,", r"\g<1>#99999,")], FLAGGED, ["#16", "undefined reference"])
    damage(box, "solid_twice", [(r"(#10 = ADVANCED_BREP_SHAPE_REPRESENTATION\('',\(#11,#15)", r"\1,#15")], FLAGGED,
           ["#15", "item twice in a representation"])
    damage(box, "tilted_plane", [(r"(#35 = DIRECTION\('',\()1\.0+E\+00,0\.0+E\+00,\s*0\.0+E\+00", r"\g<1>1.,0.,0.4")], FLAGGED,
           ["closing the gaps between its faces changes the volume by"])
    # The planes are right, and so is the volume; the edge's own line leads elsewhere, or its circle does not
    # reach its vertex.
    damage(box, "line_elsewhere", [(r"(#30 = DIRECTION\('',\()[^)]*", r"\g<1>.6,.64,.48")],
           FLAGGED, ["Entity #21 of the file: a curve does not pass through the vertices of its edge", "export it again"])
    damage("cylinder-plain.step", "circle_beside_its_vertex", [(r"(CIRCLE\('',#\d+,)8\.0+E\+00", r"\g<1>9.")], FLAGGED,
           ["Entity #21 of the file: a curve does not pass through the vertices of its edge", "#25"])
    # The vertex of a closed circle may be rounded, but the circle lies off its faces.
    damage("cylinder-plain.step", "circle_beside_its_faces", [(r"(CIRCLE\('',#\d+,)8\.0+E\+00", r"\g<1>8.2")], FLAGGED, ["Edge #21", "#25"])
    # The same points in both directions.
    damage(box, "line_reversed", [(r"(#21 = EDGE_CURVE\('',#\d+,#\d+,#\d+,)\.T\.", r"\1.F.")], {"ok"},
           ["run against their loops or their curves, with the same points, in 1 entity, first #21", "export the file again"])
    damage("wavy_plate-plain.step", "spline_reversed", [(r"(#62 = EDGE_CURVE\('',#\d+,#\d+,#\d+,)\.T\.", r"\1.F.")], {"ok"}, ["in 1 entity, first #62"])
    check_parameter_curves()
    damage("box-nopcurves.step", "composite_edge", [(r"(EDGE_CURVE\('',#\d+,#\d+,)(#\d+)(,\.T\.\);)", r"\1#901\3\n#901=COMPOSITE_CURVE('',(#902),.F.);\n"
           r"#902=COMPOSITE_CURVE_SEGMENT(.DISCONTINUOUS.,.T.,#903);\n#903=TRIMMED_CURVE('',\2,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(10.)),.T.,.PARAMETER.);")],
           {"ok"}, [], 6000.0)
    # The same occurrences with a record for each of their types; a quantity next to them is another usage.
    parts = (r"NEXT_ASSEMBLY_USAGE_OCCURRENCE\(([^;]*),\s*(\$)\s*\);", r"(ASSEMBLY_COMPONENT_USAGE(\2)NEXT_ASSEMBLY_USAGE_OCCURRENCE()"
             r"PRODUCT_DEFINITION_RELATIONSHIP(\1)PRODUCT_DEFINITION_USAGE());")
    damage("assembly.step", "occurrence_in_parts", [parts], {"ok"}, [])
    entries = [run(path)[1] for path in (os.path.join(options.output, "damaged_occurrence_in_parts.step"), os.path.join(options.solids, "assembly.step"))]
    check_equal("an occurrence in parts: the same", entries[1]["total"], entries[0]["total"])
    check_equal("an occurrence in parts: nothing is reported", entries[1]["messages"], entries[0]["messages"])
    damage("assembly.step", "occurrence_with_another_type", [parts, (r"PRODUCT_DEFINITION_USAGE\(\)", "PRODUCT_DEFINITION_USAGE()QUANTIFIED_ASSEMBLY_COMPONENT_USAGE($)")],
           FLAGGED, ["placement of other products"])
    # References to nothing, numbers out of range and lists that are too short. OpenCASCADE alone survives
    # each of them.
    damage("bicylinder-plain.step", "edge_of_nothing", [(r"(#\d+) = (ORIENTED_EDGE\('',\*,\*,)#\d+", r"\1 = \2#99999")],
           FLAGGED, ["undefined reference", "left out"])
    damage(box, "surface_of_nothing", [(r"(#\d+) = PLANE\('',#\d+\)", r"\1 = RECTANGULAR_TRIMMED_SURFACE('',#99999,0.,1.,0.,1.,.T.,.T.)")], FLAGGED,
           ["undefined reference", "left out"])
    damage("bicylinder-plain.step", "vertex_of_nothing", [(r"#84 = VERTEX_POINT[^;]*;", "")], FLAGGED, ["undefined reference", "left out"])
    damage("bicylinder-plain.step", "ellipse_of_negative_width", [(r"(ELLIPSE\('',#\d+,[^,]*,)[^)]*\)", r"\g<1>-1.)")], FLAGGED, ["value out of range", "left out"])
    damage(box, "entity_behind_the_end", [(r"(END-ISO-10303-21;)", r"\1\n#900=PRODUCT('','','',());")], FLAGGED, ["stand behind its end"])
    damage(box, "undefined_trim_curve", [(r"(DEFINITIONAL_REPRESENTATION\('',\()#\d+", r"\g<1>#9999")], FLAGGED, ["undefined reference", "left out"])
    damage(box, "face_in_parameters", [(r"(DEFINITIONAL_REPRESENTATION\('',\()#\d+", r"\1#17")], FLAGGED, ["wrong type", "left out"])
    damage(box, "huge_vector", [(r"(VECTOR\('',#\d+,)[^)]*", r"\g<1>1.E101")], FLAGGED, ["too large a number", "left out"])
    damage(box, "short_edge", [(r"EDGE_CURVE\('',(#\d+),(#\d+),(#\d+),\.T\.\)", r"EDGE_CURVE('',\1,\2,\3)")], FLAGGED,
           ["too few parameters", "left out"])
    code, entry = run(os.path.join(options.output, "damaged_tilted_plane.step"), "--gap-limit", "1")
    text = "\n".join(entry["messages"])
    check_equal("gaps that are accepted do not make up for a face that its edges contradict", (3, "suspect"), (code, entry["status"]))
    check_true("which is said, and nothing of the gaps", "was not read as its edges bound it" in text and "closing the gaps" not in text, text)
    check_true("every gap has its edge", entry["solids"][0]["worst_edges"][0]["max_gap"] == entry["total"]["max_gap"])
    damage(box, "no_unit", [(r"LENGTH_UNIT\(\)", "MASS_UNIT()")], FLAGGED | {"ok"}, ["unit"])
    # OpenCASCADE reads sections that the census does not know.
    damage(box, "section_in_small_letters", [(r"DATA;", "data;")], {"ok"}, [], 6000.0)
    # Brackets that the header opens and a context closes.
    damage(box, "lines_swapped", [(r"(HEADER;\s*FILE_DESCRIPTION\(\('[^']*')\)", r"\1,(("), (r"(GEOMETRIC_REPRESENTATION_CONTEXT\(3\))", r"\1 ')'))")],
           FLAGGED, ["damaged entity (context)"])
    # OpenCASCADE ignores a unit with a parameter too many: metres for millimetres.
    damage(box, "unit_with_another_star", [(r"(LENGTH_UNIT\(\) NAMED_UNIT\(\*)\)", r"\1,*)")], FLAGGED, ["wrong unit", "#346"])
    damage("box-inch.step", "inch_with_another_factor", [(r"(CONVERSION_BASED_UNIT\('INCH',)(#\d+)", r"\1\2,\2")], FLAGGED, ["wrong unit"])
    # Not a unit any more, or another entity: millimetres were assumed for inches.
    damage("box-inch.step", "inch_with_a_digit_before_it", [(r"\( CONVERSION_BASED_UNIT", "(8CONVERSION_BASED_UNIT")], FLAGGED, ["wrong unit", "#346"])
    damage("box-inch.step", "a_face_for_the_inch", [(r"(GLOBAL_UNIT_ASSIGNED_CONTEXT\s*\(\()#\d+", r"\1#17")], FLAGGED, ["wrong unit", "#17"])
    # A file that was cut before its context: millimetres were assumed for inches.
    damage("box-inch.step", "context_lost", [(r"#\d+\s*=\s*\(\s*GEOMETRIC_REPRESENTATION_CONTEXT\(3\)[^;]*;", "")], FLAGGED,
           ["undefined reference (context"])
    # A length in steradians next to one in millimetres: OpenCASCADE takes metres.
    damage(box, "two_units_of_length", [(r"SOLID_ANGLE_UNIT\(\)", "LENGTH_UNIT()")], FLAGGED, ["wrong unit"])
    # No finite box is left.
    damage("ellipsoid-plain.step", "huge_weight", [(r"(\(1\.0+E\+00,7\.0710678118654757E-01\s*,)1\.0+E\+00", r"\g<1>99999999999999999999")],
           FLAGGED | {"unreadable", "not-computed", "tolerance-not-met"}, [])
    # All trim curves of a face lie on a knot of its surface.
    damage("torus-nurbs.step", "knots_shuffled", [(r"(B_SPLINE_CURVE_WITH_KNOTS\(\(1,2,2,2,2,1\),\()[^)]*", r"\g<1>4.2,2.1,6.3,8.4,0.,-2.1")],
           FLAGGED | {"unreadable"}, ["knots"])
    # The loop of the cylinder is that of its top: no winding numbers, and points outside of all loops.
    damage("cylinder-plain.step", "loop_of_another_face", [(r"(#18 = FACE_BOUND\('',)#19", r"\1#107")], FLAGGED, ["not bounded in (u,v)", "#17"])
    damage("cylinder-plain.step", "radius_below_zero", [(r"(CYLINDRICAL_SURFACE\('',#\d+,)", r"\1-")], FLAGGED, ["value out of range"])
    damage("two_solids.step", "solid_lost", [(r"(CLOSED_SHELL\('',)\(#\d+[^)]*\)", r"\1()")], FLAGGED, ["shell without faces"])
    damage("assembly.step", "instance_of_nothing", [(r"(NEXT_ASSEMBLY_USAGE_OCCURRENCE\('3','[^']*','',)#\d+", r"\1#1")], FLAGGED,
           ["#2136"])


# The expected result of each file: statuses, words of its messages, volume.
HOSTILE = {
    "01c_plain_solid_tet": (FLAGGED, ["#15, #17"], None),
    "01e_plain_solid_screw": (FLAGGED, ["#1052"], None),
    "01g_plain_solid_odri_motor": (FLAGGED, ["#190", "left out"], None),
    "02a_solid_lost_silently": (FLAGGED, ["#57", "#255", "were lost"], None),
    "02d_instance_lost_silently": (FLAGGED, ["#219"], None),
    # A context is damaged, behind which OpenCASCADE's lexer loses seven of eight solids.
    "02e_solid_lost_silently": (FLAGGED, ["Entity #1076 of the file: damaged entity (context)", "mm is assumed"], None),
    "02f_three_solids_lost": (FLAGGED, ["#503", "were lost"], None),
    "03_tilted_plane": (FLAGGED, ["at edge #72", "% of its size"], None),
    "05a_crash_empty_body_then_body": (FLAGGED, ["#47"], None),
    "05b_crash": (FLAGGED, ["#11"], None),
    "05d_crash": (FLAGGED, ["#202"], None),
    "07_assembly_bomb": ({"unreadable"}, ["393214 instances"], None),
    "void_outside": (FLAGGED, ["a void lies outside the outer shell"], None),
    "same_solid_listed_twice": (FLAGGED, ["#157"], None),
    "one_shell_overlapping_boxes": (FLAGGED, ["its winding number is 2"], None),
    "two_coincident": ({"ok"}, ["they overlap"], None),
    "unit_NONE": ({"ok"}, ["mm is assumed"], None),
    "unit_INCH_-25.4": (FLAGGED, ["unit"], None),
    "10_damaged_text_sound_solid": ({"ok"}, [], 272534.934224255),
}


def check_hostile():
    paths = sorted(glob.glob(os.path.join(options.hostile, "*.step")))
    names = [os.path.splitext(os.path.basename(path))[0] for path in paths]
    check_equal("the files of the folder", sorted(HOSTILE), names)
    for name, path in zip(names, paths):
        expect(name, path, *HOSTILE[name])
    # A body that lost every face has no values, and what it is a part of has no bound.
    name = "05a_crash_empty_body_then_body"
    _, entry = run(os.path.join(options.hostile, name + ".step"))
    lost = [s for s in entry["solids"] if s["status"] == "suspect"]
    check_true(name + ": lost bodies have no values", lost and all(s["volume"] is s["area"] is s["max_gap"] is None for s in lost))
    check_equal(name + ": bound of the total", None, entry["total"]["bounds"]["volume"])
    check(name + ": volume of the total", 486.2935001, entry["total"]["volume"], 1e-7)


if options.hostile:
    check_hostile()
else:
    check_solids()
    check_unread()
finish()

"""The parts of Table 1: made alike twice, valid and closed, computed with status ok, with the volumes that formulas give.

    TestPaperParts.py --make make_paper_parts --occt occt_mass_properties --program solidmoments --folder PARTS --output FOLDER
                      values | errors

PARTS is what make_paper_parts wrote.
"""
import argparse
import filecmp
import json
import math
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check, check_equal, check_true, finish  # noqa: E402

PARTS = ["quarter_cylinder", "slanted_block", "trefoil_tube", "free_form", "propeller", "crank", "engine_block", "gear_train"]
# Cheap ones, of every way to model; the rest are made by the same functions.
MADE_AGAIN = ["quarter_cylinder", "slanted_block", "trefoil_tube", "free_form", "crank"]


def run(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, check=False)


def measure(options, name):
    path = os.path.join(options.folder, name + ".step")
    done = run(options.program, "--quiet", "--tolerance", "1e-9", "--json", "-", path)
    check_equal(f"{name}: exit status", 0, done.returncode)
    return json.loads(done.stdout)["files"][0]


def ask_occt(options, name, *arguments):
    done = run(options.occt, *arguments, os.path.join(options.folder, name + ".step"))
    check_equal(f"{name}: OCCT's exit status", 0, done.returncode)
    return json.loads(done.stdout)


def get_trefoil_volume():
    """Returns the volume of a tube around the knot in mm^3: section area times length, as the section's centroid lies on the knot
    (Pappus)."""
    size, radius, count = 30.0, 14.0, 20000
    length = 0.0
    for i in range(count):
        t = 2.0 * math.pi * (i + 0.5) / count
        x = math.cos(t) + 4.0 * math.cos(2.0 * t)
        y = -math.sin(t) + 4.0 * math.sin(2.0 * t)
        z = -3.0 * math.cos(3.0 * t)
        length += size * math.sqrt(x * x + y * y + z * z) * 2.0 * math.pi / count
    return math.pi * radius * radius * length


def check_exact(part, total):
    """At rounding level: the file holds 17 digits, but the block's trim curves are OpenCASCADE's intersections, good to 1e-7 mm."""
    gap = total["gap_squared"]
    check(part["id"] + ": volume", part["volume"], total["volume"], 1e-12 * part["volume"] + gap)
    check(part["id"] + ": area", part["area"], total["area"], 1e-11 * part["area"] + total["gap_area"])
    for i in range(3):
        check(f"{part['id']}: centre {i}", part["center_of_mass"][i], total["center_of_mass"][i], 1e-10)


def check_values(options):
    with open(os.path.join(options.folder, "parts.json"), encoding="utf-8") as file:
        parts = {part["id"]: part for part in json.load(file)["parts"]}
    check_equal("parts", PARTS, list(parts))
    documents = {}
    for name, part in parts.items():
        documents[name] = measure(options, name)
        total = documents[name]["total"]
        check_equal(f"{name}: status", "ok", documents[name]["status"])
        check_equal(f"{name}: faces", part["faces"], documents[name]["faces"])
        check_equal(f"{name}: solids", part["solids"], len(documents[name]["solids"]))
        if "volume" in part:
            check_exact(part, total)
        # OpenCASCADE's adaptive integration is another program's answer; far off its claim, but not by a
        # thousandth.
        occt = ask_occt(options, name, "--eps", "1e-6")
        check(f"{name}: volume by OCCT", occt["volume"], total["volume"], 1e-3 * total["volume"])
        check_equal(f"{name}: solids of OCCT", part["solids"], occt["solids"])
        check_true(f"{name}: OCCT claims an error", occt["claimed"] is not None and 0.0 <= occt["claimed"] < 1e-2, str(occt["claimed"]))
    check("trefoil_tube: Pappus", get_trefoil_volume(), documents["trefoil_tube"]["total"]["volume"],
          1e-3 * get_trefoil_volume(), "the spline leaves the knot")
    check_true("gear_train: trimmed faces", parts["gear_train"]["trimmed_faces"] > 1000, str(parts["gear_train"]["trimmed_faces"]))
    check_true("free_form: nothing but trimmed faces", parts["free_form"]["trimmed_faces"] == parts["free_form"]["faces"])
    balls = [solid for solid in documents["gear_train"]["solids"] if "ball" in solid["name"]]
    check_equal("gear_train: balls", 72, len(balls))
    for ball in balls[:2]:
        exact = 4.0 / 3.0 * math.pi * 2.4 ** 3
        check("gear_train: " + ball["name"], exact, ball["volume"], 1e-12 * exact)
    check_true("OCCT's default states no error", ask_occt(options, "slanted_block")["claimed"] is None)


def check_repetition(options):
    again = os.path.join(options.output, "paper_parts_again")
    check_equal("made again", 0, run(options.make, again, *MADE_AGAIN).returncode)
    for name in MADE_AGAIN:
        same = filecmp.cmp(os.path.join(options.folder, name + ".step"), os.path.join(again, name + ".step"), shallow=False)
        check_true(f"{name}: the same bytes", same)


def check_refusal(what, code, sentence, done):
    check_equal(what + ": exit status", code, done.returncode)
    check_true(what + ": a sentence", sentence in done.stderr, done.stderr.strip())


def check_errors(options):
    slanted = os.path.join(options.folder, "slanted_block.step")
    file_in_the_way = os.path.join(options.output, "no_folder")
    with open(file_in_the_way, "w", encoding="utf-8"):
        pass
    check_refusal("make_paper_parts without folder", 1, "FOLDER is required", run(options.make))
    check_refusal("make_paper_parts of no part", 1, "no part has the name hammer", run(options.make, os.path.join(options.output, "none"), "hammer"))
    check_refusal("make_paper_parts into a file", 1, "cannot be written",
                  run(options.make, os.path.join(file_in_the_way, "deeper"), "quarter_cylinder"))
    check_refusal("occt_mass_properties without file", 1, "FILE is required", run(options.occt))
    check_refusal("occt_mass_properties of a wrong eps", 1, "--eps: the relative error", run(options.occt, "--eps", "x", slanted))
    check_refusal("occt_mass_properties of no file", 2, "cannot read", run(options.occt, slanted + ".none"))
    check_refusal("occt_mass_properties of JSON", 2, "cannot read", run(options.occt, os.path.join(options.folder, "parts.json")))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("make", "occt", "program", "folder", "output"):
        parser.add_argument("--" + name, required=True)
    parser.add_argument("mode", choices=("values", "errors"))
    options = parser.parse_args()
    if options.mode == "values":
        check_values(options)
        check_repetition(options)
    else:
        check_errors(options)
    finish()


main()

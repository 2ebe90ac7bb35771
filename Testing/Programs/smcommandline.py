"""smcommandline.py: the options of the tests of the command line, and runs of the program."""
import argparse
import functools
import json
import os
import shutil
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
import smprogram  # noqa: E402
from smcheck import Manifest, check, check_equal, check_true  # noqa: E402

parser = argparse.ArgumentParser()
parser.add_argument("mode")
for name in ("--program", "--solids", "--output", "--sample"):
    parser.add_argument(name, required=True)
options = parser.parse_args()
manifest = Manifest(options.solids)

BODY_KEYS = {"volume", "area", "center_of_mass", "inertia", "principal_moments", "principal_axes", "mass", "bounds",
             "closure_spread", "closure_correction", "gap_squared", "max_gap", "gap_area", "open_edges", "closure_residual", "flipped_shells",
             "paper_error_estimate", "paper_error_estimate_with_boundary", "sub_patches", "stability", "density", "material",
             "mass_center", "mass_inertia", "mass_principal_moments", "mass_principal_axes", "radii_of_gyration",
             "mass_radii_of_gyration", "inertia_at_origin", "about", "bounding_box"}
BOUND_KEYS = {"volume", "area", "center_of_mass", "inertia", "mass", "mass_center", "mass_inertia", "radii_of_gyration",
              "inertia_at_origin", "bounding_box"}
FILE_KEYS = {"file", "file_bytes", "length_unit", "status", "messages", "scheme", "scheme_options", "backend", "renderer",
             "backend_reason", "estimate", "frame", "total", "solids", "faces", "free_faces", "integrals", "waterlines", "sections", "diagonal",
             "evaluations", "dispatches", "seconds"}
# Names of files may not be UTF-8.
run = functools.partial(smprogram.run, options.program, errors="surrogateescape")


def run_json(*arguments):
    """Standard output must be JSON and nothing else, with every documented key."""
    result = run("--json", "-", *arguments)
    try:
        document = json.loads(result.stdout, parse_constant=lambda text: (_ for _ in ()).throw(ValueError(text)))
    except ValueError as error:
        check_true("JSON is valid", False, f"{error}: {result.stdout[:300]} {result.stderr[:300]}")
        sys.exit(1)
    check_equal("version", 2, document["version"])
    check_true("loading the program takes its time", 0.0 < document["process_start"] < 60.0, str(document["process_start"]))
    for file in document["files"]:
        check_equal("keys of a file", [], sorted(FILE_KEYS - set(file)))
        check_equal("keys of the total", [], sorted(BODY_KEYS - set(file["total"])))
        check_equal("keys of the bounds", [], sorted(BOUND_KEYS - set(file["total"]["bounds"])))
        seconds = file["seconds"]
        sums = {"prepare": ["convert", "cut", "mesh", "plan", "upload"], "read": ["parse", "transfer", "trims"]}
        keys = sum(sums.values(), list(sums)) + ["analyse", "integrate", "start"]
        check_equal("keys of the seconds", sorted(keys), sorted(seconds))
        if None not in seconds.values():
            for whole, parts in sums.items():
                check(f"parts of {whole}", seconds[whole], sum(seconds[part] for part in parts), 1e-9, "the same numbers added up")
            check_true("every stage takes its time", all(seconds[key] >= 0.0 for key in keys) and
                       min(seconds["read"], seconds["parse"], seconds["analyse"]) > 0.0, str(seconds))
        for solid in file["solids"]:
            check_equal("keys of a solid", [], sorted((BODY_KEYS | {"name", "id", "worst_edges"}) - set(solid)))
    return result, document["files"]


def check_unreadable(file):
    check_equal("status", "unreadable", file["status"])
    total = file["total"]
    check_true("no numbers", all(total[key] is None for key in ("volume", "area", "center_of_mass", "inertia")))
    check_true("a message names the file", any(os.path.basename(file["file"]) in text for text in file["messages"]),
               str(file["messages"]))


def make_folder(name):
    folder = os.path.join(options.output, name)
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    return folder

"""TestCommandLineSchemes.py --program P --solids DIR --output DIR: the paper's schemes on the command line."""
import argparse
import functools
import json
import math
import os
import shutil
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
import smprogram  # noqa: E402
from smcheck import Manifest, check, check_equal, check_true, finish  # noqa: E402
from smpicture import read_bytes  # noqa: E402

parser = argparse.ArgumentParser()
for option in ("--program", "--solids", "--output"):
    parser.add_argument(option, required=True)
options = parser.parse_args()
manifest = Manifest(options.solids)
HOLE = manifest.solid("slanted_hole", "moved")
SPHERE = manifest.solid("sphere")
ESTIMATES = ("paper_error_estimate", "paper_error_estimate_with_boundary", "sub_patches")

run = functools.partial(smprogram.run, options.program)


def run_json(*arguments):
    result = run("--json", "-", *arguments)
    check_true("JSON is there", result.stdout.startswith("{"), result.stderr)
    return result, json.loads(result.stdout)["files"]


def check_numbers():
    for scheme, points, limit in (("midpoint", 1, 1e-1), ("gauss2", 2, 1e-3), ("gauss3", 3, 1e-3)):
        result, files = run_json("--scheme", scheme, "--subpatches", "8", HOLE["path"], SPHERE["path"])
        check_equal("exit status", 3, result.returncode)
        for expected, file in zip((HOLE, SPHERE), files):
            total = file["total"]
            check_equal("scheme", scheme, file["scheme"])
            check_equal("its options", {"sub_patch_factor": 8, "texture_factor": 4, "chord_tolerance": 1e-8,
                                        "deviation": "bounded"}, file["scheme_options"])
            check_equal("status", "tolerance-not-met", file["status"])
            check_equal("why, once and of no body", 1, sum(text.startswith(scheme.upper() + " has no error bound")
                                                           for text in file["messages"]))
            check("volume", expected["volume"], total["volume"], limit * expected["volume"])
            check_true("the centre and the inertia are there", total["center_of_mass"] and total["inertia"])
            for body in [total] + file["solids"]:
                check_equal("no bounds", [], [key for key, bound in body["bounds"].items() if bound is not None])
                check_true("of any quantity", {"volume", "area", "center_of_mass", "inertia", "mass"} <= set(body["bounds"]))
                check_equal("what is not known", [None] * 4,
                            [body[key] for key in ("closure_correction", "max_gap", "gap_area", "closure_residual")])
                check_true("an estimate", 0 <= body["paper_error_estimate"] <= body["paper_error_estimate_with_boundary"])
                check_true("sub-patches", body["sub_patches"] % 64 == 0 and body["sub_patches"] > 0)
            check_true("evaluations", 0 < file["evaluations"] <= points**2 * total["sub_patches"])
    radius = (SPHERE["volume"] * 0.75 / math.pi) ** (1.0 / 3.0)
    check("the sphere's diagonal", 2.0 * radius * math.sqrt(3.0), files[1]["diagonal"], 0.1 * radius, "by its mesh")
    # A sphere without a trim curve that crosses a sub-patch: both estimates are one.
    check("the sphere's estimates", files[1]["total"]["paper_error_estimate"],
          files[1]["total"]["paper_error_estimate_with_boundary"], 0.0)


def check_options():
    _, (adaptive,) = run_json(HOLE["path"])
    check_equal("the default", "adaptive", adaptive["scheme"])
    check_equal("has none of it", [None] * 4, [adaptive["total"][key] for key in ESTIMATES] + [adaptive["scheme_options"]])
    totals = []
    for more in ([], ["--backend", "cpu"], ["--deviation", "sampled"], ["--trim-texture", "16"], ["--chord", "1e-2"],
                 ["--subpatches", "3"]):
        _, (file,) = run_json("--scheme", "Gauss2", *more, HOLE["path"])
        check_equal("in any case", "gauss2", file["scheme"])
        totals.append(file["total"])
        given = dict(zip(more[::2], more[1::2]))
        check_equal("its options", [int(given.get("--subpatches", 2)), int(given.get("--trim-texture", 4)),
                                    float(given.get("--chord", 1e-8)), given.get("--deviation", "bounded")],
                    list(file["scheme_options"].values()))
    plain, cpu, sampled, texture, chord, three = totals
    check("the CPU", plain["volume"], cpu["volume"], 1e-13 * plain["volume"])
    check("sampled: the volume", plain["volume"], sampled["volume"], 0.0)
    check_true("sampled: less", sampled["paper_error_estimate"] < plain["paper_error_estimate"])
    check_true("a finer texture", texture["volume"] != plain["volume"])
    check_true("coarser chords", chord["volume"] != plain["volume"])
    check_equal("sub-patches", [16, 36], [plain["sub_patches"], three["sub_patches"]])
    # Exactly once in a table and in a CSV for people.
    csv = os.path.join(options.output, "schemes.csv")
    result = run("--scheme", "gauss2", "--csv", csv, HOLE["path"])
    check_true("its options in the table", "gauss2, k = 2, 4 x 4 texels per sub-patch, chords of planes to 1e-08, "
               "deviations bounded" in result.stdout, result.stdout)
    check_true("the table", "the paper's error estimate of the volume (not a bound)" in result.stdout, result.stdout)
    check_true("and no bound in it", "+/-" not in result.stdout, result.stdout)
    with open(csv, encoding="utf-8") as file:
        lines = file.read().splitlines()
    row = dict(zip(lines[0].split(","), lines[1].split(",")))
    check("the CSV", plain["paper_error_estimate"], float(row["paper_error_estimate"]), 0.0)
    check_equal("no bound in the CSV", "", row["volume_bound"])
    check_equal("its scheme in every row", ["gauss2"] * (len(lines) - 1),
                [line.split(",")[lines[0].split(",").index("scheme")] for line in lines[1:]])
    result, (file,) = run_json("--scheme", "gauss3", "--subpatches", "1024", "--max-evaluations", "1e6", HOLE["path"])
    check_equal("too costly", (3, None, None), (result.returncode, file["total"]["volume"],
                                                file["total"]["paper_error_estimate"]))
    check_true("it says so", any("divide into fewer sub-patches" in text for text in file["messages"]))


def check_usage():
    for arguments in (["--scheme", "gauss4"], ["--scheme", "gauss2", "--subpatches", "0"],
                      ["--scheme", "gauss2", "--subpatches", "2.5"], ["--scheme", "gauss2", "--subpatches", "1025"],
                      ["--scheme", "gauss2", "--trim-texture", "17"], ["--scheme", "gauss2", "--chord", "0"],
                      ["--scheme", "gauss2", "--chord", "1"], ["--scheme", "gauss2", "--deviation", "guessed"],
                      ["--subpatches", "4"], ["--trim-textures", options.output],
                      ["--scheme", "gauss2", "--trim-textures", ""],
                      ["--scheme", "gauss2", "--tolerance", "1e-6"],
                      ["--scheme", "GAUSS3", "--tolerance-of", "volume=1e-6"],
                      ["--scheme", "ADAPTIVE", "--subpatches", "4"],
                      ["--scheme", "gauss2", "--trim-textures", HOLE["path"]]):
        result = run(*arguments, HOLE["path"])
        check_equal("exit status of wrong usage", 1, result.returncode)
        check_true("it says why", len(result.stderr) > 20 and not result.stdout, result.stderr)
    result = run("--compare", HOLE["path"], HOLE["path"], "--scheme", "midpoint")
    check_true("a comparison excludes schemes", result.returncode == 1 and "excludes --scheme" in result.stderr and not result.stdout,
               result.stderr)


def check_textures():
    folder = os.path.join(options.output, "trim", "textures")
    shutil.rmtree(folder, ignore_errors=True)
    twin = os.path.join(options.output, "twin")
    os.makedirs(twin, exist_ok=True)
    shutil.copy(HOLE["path"], twin)
    again = os.path.join(twin, os.path.basename(HOLE["path"]))
    result = run("-q", "--scheme", "gauss2", "--subpatches", "8", "--trim-textures", folder, HOLE["path"], again)
    check_equal("exit status", 3, result.returncode)
    names = sorted(os.listdir(folder))
    check_equal("a picture of the cylinder for each file", 2, len(names))
    check_true("named after file and face", all(name.startswith("slanted_hole-moved-") and name.endswith(".png")
                                                for name in names), str(names))
    texels = read_bytes(os.path.join(folder, names[0]))
    check_equal("one grey value a texel", (2, 4 * 64 * 16), (texels.ndim, texels.size))
    check_equal("black and white", {0, 255}, set(texels.flat))
    # The hole's wall is less than its cylinder, which begins and ends beyond the block.
    check("white", 0.5, (texels == 255).mean(), 0.45)


check_numbers()
check_options()
check_usage()
check_textures()
finish()

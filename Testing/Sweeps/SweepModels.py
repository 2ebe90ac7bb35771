"""Reads every real file of the models folder once, judges all stages with it, and compares with its reference values.

    SweepModels.py --program SweepFile --models FOLDER --folder UNPACKED --output FOLDER [--exceptions FILE] [--only ID ...]
                   [--without STAGE ...] [--jobs N] [--markdown FILE] [--csv FILE] [--document FILE.md]

The program SweepFile does what `solidmoments --json` does at the default tolerance of 1e-9 and at 1e-12, and what STAGES names. What
must hold of volume, area, centre and inertia alike (SweepJudge.py):
- |value - reference| <= bound + uncertainty of the reference, and its squared gap where that is large;
- bound <= 1e-9 on every file at the default tolerance, <= 1e-12 at 1e-12 on at least 68 of 87, areas 62 (rounding of decimals, and what trim
  curves miss of edges, are more on the others);
- closure residual <= 1e-12 on 82 of 87;
- the status fits the bounds, the open edges and the exit status; every solid has its own reference volume; nothing crashes;
  what cannot be read is called unreadable, and surfaces open;
- on the files whose CAD system wrote a precise volume, the distance from it is at least 50 times less than that of
  OpenCASCADE's BRepGProp with Eps = 1e-9;
- faces, trim curves and edges are those of OpenCASCADE, point by point; numbers of solids, faces and open edges are the reference's;
  the display mesh has about the volume.

Prints a row per file while it runs and the summary that Documentation/Numerics.md shows; --markdown and --csv write the table
(SweepTable.py), --document puts the summary between the marks of that document.
Exit status 0 when all of this holds. SweepExceptions.json names the files that may miss a condition, each with the reason:
{"id": {"volume": "why", "status": "why"}}. An exception that is not needed is an error, too.
"""
import argparse
import concurrent.futures
import json
import os
import subprocess
import sys
import time

import SweepJudge
import SweepTable

EXPECTED_FILES = 98
EXPECTED_SOLIDS = 87
# The smallest number, out of the 87 files with solids, whose bound of each quantity is at most 1e-12 at that
# tolerance. Areas carry what the reader's trim curves miss of the file's edges, up to 1e-10 of their size.
TIGHT_FILES = {"volume": 68, "area": 62, "center": 68, "inertia": 68}
CLOSED_FILES = 82
# CAD systems wrote these two volumes with twelve digits, and their gaps move them by far more.
CLOSER_THAN_OCCT = {"nist_ctc_01": 50, "nist_ftc_06": 50}
SECONDS_A_FILE = 900
# Further checks on some of the files: both backends; below and above a waterline; saved and read again.
STAGES = {
    "backends": {"build123d_screw", "nist_pmi_05_brl", "gmsh_fusee", "occt_linkrods", "caxif_dm1_id_214", "nist_ctc_01",
                 "geouned_torus_design1", "pygem_pipe", "gmsh_ujoint"},
    "buoyancy": {"gmsh_fusee", "nist_ctc_01", "occt_linkrods", "caxif_dm1_id_214", "odri_pulley", "geouned_dobleCodo"},
    "writers": {"build123d_screw", "caxif_as1_oc_214", "caxif_dm1_id_214", "cq_red_blue", "geouned_torus_design1", "nist_ctc_01",
                "occt_linkrods"},
}


def run(options, identifier):
    """The runs of a file, what else SweepFile found, and the failures of the stages."""
    path = os.path.join(options.output, identifier + ".json")
    if os.path.exists(path):
        os.remove(path)
    stages = [stage for stage, names in STAGES.items() if identifier in names and stage not in options.without]
    command = [options.program, os.path.join(options.folder, identifier + ".step"), path, options.output, *stages]
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True,
                              errors="replace", timeout=SECONDS_A_FILE, check=False)
        code, text = done.returncode, done.stdout
    except subprocess.TimeoutExpired:
        code, text = None, f"not done in {SECONDS_A_FILE} s"
    if code != 0:
        return [SweepJudge.Run(tolerance, code, None, text, 0.0) for tolerance in SweepJudge.TOLERANCES], {}, []
    with open(path, encoding="utf-8") as file:
        result = json.load(file)
    runs = [SweepJudge.Run(one["tolerance"], one["exit_status"], one["document"], "", one["seconds"]) for one in result["runs"]]
    failures = [line for line in text.splitlines() if line.startswith("FAIL")]
    if len(failures) != result["checks"]["failures"] or bool(stages) != bool(result["checks"]["number"]):
        failures.append(f"stages {stages}: {result['checks']}, {len(failures)} lines FAIL")
    return runs, result, [f"{identifier}: {line}" for line in failures]


def check_exceptions(identifier, allowed, runs):
    """Prints what a file misses; returns the failures among it."""
    failures = []
    missed_somewhere = set()
    for one in runs:
        for condition, found in one.missed.items():
            missed_somewhere.add(condition)
            what = f"{condition} at {one.tolerance:g}: {found}"
            if condition in allowed:
                print(f"     {what} (expected: {allowed[condition]})")
            else:
                print(f"FAIL {what}")
                failures.append(f"{identifier}: {what}")
    for condition in allowed:
        if condition not in missed_somewhere:
            failures.append(f"{identifier}: the exception for {condition} is not needed any more")
    return failures


def check_counts(swept):
    """Failures of the conditions that count files."""
    failures = []
    solids = [entry for entry in swept if entry.has_solids()]
    for number, expected, what in ((len(swept), EXPECTED_FILES, "files"), (len(solids), EXPECTED_SOLIDS, "files with solids")):
        if number != expected:
            failures.append(f"{number} {what} swept, {expected} expected")
    for index, tolerance in enumerate(SweepJudge.TOLERANCES):
        closed = sum(1 for entry in solids if entry.runs[index].is_closed())
        if closed < CLOSED_FILES:
            failures.append(f"closure residual <= {SweepJudge.CLOSURE_LIMIT:g} at {tolerance:g} on {closed} files, {CLOSED_FILES} expected")
        if tolerance == SweepJudge.DEFAULT_TOLERANCE:
            continue  # judged file by file
        for name in SweepJudge.QUANTITIES:
            tight = [entry for entry in solids if entry.runs[index].is_tight(name)]
            if len(tight) < TIGHT_FILES[name]:
                loose = [entry.reference["id"] for entry in solids if entry not in tight]
                failures.append(f"bound of the {name} <= {tolerance:g} on {len(tight)} files, {TIGHT_FILES[name]} expected; above: "
                                + " ".join(loose))
    return failures


def check_cad_volumes(swept):
    failures = []
    for entry in swept:
        least = CLOSER_THAN_OCCT.get(entry.reference["id"])
        if least is None:
            continue
        closer = SweepJudge.closer_than_occt(entry.reference, entry.runs[0])
        if closer is None or not closer >= least:
            failures.append(f"{entry.reference['id']}: {closer} times closer to the CAD system's volume than OCCT, "
                            f"{least} expected")
    return failures


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, help="path of SweepFile")
    parser.add_argument("--models", required=True, help="folder with reference.jsonl and unpack.sh")
    parser.add_argument("--folder", required=True, help="where the files are unpacked")
    parser.add_argument("--output", required=True, help="where results and saved files go")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="files at a time")
    parser.add_argument("--exceptions", help="JSON, what may be missed and why")
    parser.add_argument("--only", action="append", help="this file only; may be given several times")
    parser.add_argument("--without", action="append", default=[], choices=list(STAGES), help="a stage that the program does not have")
    parser.add_argument("--markdown", help="write the table and its summary there")
    parser.add_argument("--csv", help="write a row per file and tolerance there")
    parser.add_argument("--document", help="put the summary there")
    options = parser.parse_args()
    subprocess.run(["sh", os.path.join(options.models, "unpack.sh"), options.folder], check=True)
    with open(os.path.join(options.models, "reference.jsonl"), encoding="utf-8") as file:
        references = [json.loads(line) for line in file if line.strip()]
    exceptions = {}
    if options.exceptions:
        with open(options.exceptions, encoding="utf-8") as file:
            exceptions = json.load(file)
    os.makedirs(options.output, exist_ok=True)
    known = {reference["id"] for reference in references}
    failures = [f"{name}: no such file, but named" for name in set(exceptions).union(options.only or [], *STAGES.values())
                if name not in known]
    if options.only:
        references = [reference for reference in references if reference["id"] in options.only]

    start = time.monotonic()
    swept = []
    print(SweepTable.console_header())
    types = {}
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        results = pool.map(lambda reference: run(options, reference["id"]), references)
        for reference, (runs, result, found) in zip(references, results):
            for one in runs:
                SweepJudge.judge(reference, one)
            if result:
                runs[0].missed.update(SweepJudge.judge_kernel(reference, result["kernel"], result["mesh"]))
            swept.append(SweepJudge.Swept(reference, runs))
            print(SweepTable.console_row(swept[-1]), flush=True)
            failures += check_exceptions(reference["id"], exceptions.get(reference["id"], {}), runs)
            failures += found
            if result:
                SweepTable.add_types(types, result["kernel"])
    if not options.only:
        failures += check_counts(swept)
    failures += check_cad_volumes(swept)

    summary = SweepTable.summary(swept)
    print("\n" + SweepTable.types(types))
    print(f"\n{summary}\n\n{time.monotonic() - start:.0f} s")
    if options.markdown:
        with open(options.markdown, "w", encoding="utf-8") as file:
            file.write(SweepTable.markdown(swept, summary))
    if options.csv:
        with open(options.csv, "w", encoding="utf-8", newline="") as file:
            SweepTable.write_csv(swept, file)
    if options.document:
        with open(options.document, encoding="utf-8") as file:
            text = file.read()
        with open(options.document, "w", encoding="utf-8") as file:
            file.write(SweepTable.replace_summary(text, summary))
    for failure in failures:
        print("FAIL", failure)
    print(f"{len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Runs programs over the certified set and compares what they print with the intervals of certified.json.

    check_program.py [options] [NAME=]COMMAND...

COMMAND computes the mass properties of the file that stands for {file}, and prints JSON:

    {"length_unit": "mm", "volume": 30.0, "area": 62.0, "center_of_mass": [1.0, 1.5, 2.5],
     "inertia": [[85.0, 0.0, 0.0], [0.0, 72.5, 0.0], [0.0, 0.0, 32.5]],
     "bounds": {"volume": 1e-12, "area": 1e-12, "center_of_mass": 1e-13, "inertia": 1e-11}, "status": "ok"}

Of these keys any may be missing. "length_unit" is that of the numbers (default mm); inertia is about the centre of mass, for density 1,
with the negative products off the diagonal. "bounds" are the errors that the program states, the largest of any component;
"claimed" is a relative one of the volume. What `solidmoments --json -` and occt_mass_properties print is understood as it is.

The true error is the distance to the interval, in exact arithmetic: a violation, an error above the stated one, is certain. "In gaps" are
violations that a program covers by gaps between faces that it states in addition to its bounds ("gap_area", "gap_squared"). "Flagged" are
results whose status is not ok; they are judged like all others. Exit status: 0; 1 wrong usage; 2 a program that gave no result at all;
3 a violation that no gap covers.
"""
import argparse
import json
import os
import re
import shlex
import subprocess
import sys
from fractions import Fraction

ROUNDING = 1e-12  # relative; violations above it are counted apart
HERE = os.path.dirname(os.path.abspath(__file__))
QUANTITIES = {"volume": ("volume", 3), "area": ("area", 2), "center_of_mass": ("centre", 1), "inertia": ("inertia", 5)}
UNITS = {"mm": Fraction(1), "cm": Fraction(10), "m": Fraction(1000), "um": Fraction(1, 1000), "in": Fraction(254, 10),
         "inch": Fraction(254, 10), "ft": Fraction(3048, 10)}


def flatten(value):
    return [x for part in value for x in flatten(part)] if isinstance(value, list) else [value]


def run(command, path, seconds):
    """Runs a program for a file. Returns its JSON as one dictionary, and an error message or an empty string."""
    words = [word.replace("{file}", path) for word in shlex.split(command)]
    try:
        done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=seconds, check=False)
    except subprocess.TimeoutExpired:
        return {}, f"more than {seconds:g} s"
    text = done.stdout.decode("utf-8", "replace")
    try:
        result = json.loads(text[text.index("{"):], parse_float=read_number, parse_int=Fraction, parse_constant=lambda _: None)
    except ValueError:
        return {}, f"no JSON, exit status {done.returncode}"
    if "files" in result:
        result = result["files"][0]
        result = {**(result.get("total") or {}), **{key: result.get(key) for key in ("length_unit", "status")}}
    return result, ""


def read_number(text):
    """The number of a text, exactly; None for one that exceeds the range of double."""
    return Fraction(text) if abs(float(text)) < float("inf") else None


def get_stated(result, quantity):
    """The error that the program states for a quantity; None if it states none."""
    stated = (result.get("bounds") or {}).get(quantity)
    if stated is None and quantity == "volume" and result.get("claimed") is not None:
        stated = abs(result["claimed"] * result["volume"])
    return stated


def get_gaps(result, quantity, scale):
    """The error that gaps between faces may cause, from the figures that the program states. `scale`: a length of the solid, in its
    unit."""
    gaps, volume = result.get("gap_squared") or 0, abs(result.get("volume") or 0)
    if quantity == "area":
        return result.get("gap_area") or 0
    return gaps * {"volume": 1, "center_of_mass": scale / volume if volume else 0, "inertia": scale ** 2}[quantity]


def judge(certificate, result):
    """Returns for every quantity the error and the stated error relative to the scale, and a verdict."""
    unit = UNITS[result.get("length_unit") or "mm"] / UNITS[certificate["length_unit"]]
    area, volume = (Fraction(certificate[name][0]) for name in ("area", "volume"))
    length = Fraction(float(area) ** 0.5)
    scales = {"volume": volume, "area": area, "center_of_mass": length,
              "inertia": sum(Fraction(certificate["inertia"][i][i][0]) for i in range(3))}
    rows = {}
    for quantity, (_, power) in QUANTITIES.items():
        ends = flatten(certificate[quantity])
        values, scale = flatten(result.get(quantity)), scales[quantity]
        if len(values) * 2 != len(ends) or None in values:
            rows[quantity] = {"error": None, "stated": None, "verdict": "missing"}
            continue
        factor = unit ** power
        intervals = [(Fraction(low), Fraction(high)) for low, high in zip(ends[::2], ends[1::2])]
        error = max(max(low - x * factor, x * factor - high, Fraction(0)) for x, (low, high) in zip(values, intervals))
        stated = get_stated(result, quantity)
        verdict = "no statement"
        if stated is not None:
            stated *= factor
            gaps = get_gaps(result, quantity, length / unit) * factor
            verdict = "holds" if error <= stated else "in gaps" if error <= stated + gaps else "violation"
        rows[quantity] = {"error": float(error / scale), "stated": None if stated is None else float(stated / scale),
                          "verdict": verdict}
    return rows


def check(command, options, certificates):
    """Runs a program over all files; returns the outcome for every file."""
    outcomes = []
    for certificate in certificates:
        result, trouble = run(command, os.path.join(options.set, certificate["file"]), options.seconds)
        status = result.get("status") or "ok"
        outcomes.append({"file": certificate["file"], "status": trouble or status, "flagged": not trouble and status != "ok",
                         "quantities": judge(certificate, result)})
    return outcomes


def short(value):
    return "-" if value is None else "0" if value == 0 else f"{value:.0e}"


def make_file_table(outcomes):
    lines = ["| file | volume | area | centre | inertia | |", "|---|---|---|---|---|---|"]
    marks = {"violation": " **!**", "in gaps": " *"}
    for outcome in outcomes:
        cells = [f"{short(cell['error'])} / {short(cell['stated'])}{marks.get(cell['verdict'], '')}"
                 for cell in outcome["quantities"].values()]
        remark = "" if outcome["status"] == "ok" else outcome["status"]
        lines.append(f"| {outcome['file'][:-5]} | {' | '.join(cells)} | {remark} |")
    return "\n".join(lines)


def count(outcomes, quantity):
    """Collects the errors, and counts the verdicts, of a quantity."""
    cells = [outcome["quantities"][quantity] for outcome in outcomes]
    errors = sorted(cell["error"] for cell in cells if cell["error"] is not None)
    return {"results": len(errors), "median": errors[len(errors) // 2] if errors else None, "worst": errors[-1] if errors else None,
            "large": sum(cell["verdict"] == "violation" and cell["error"] > ROUNDING for cell in cells),
            **{verdict: sum(cell["verdict"] == verdict for cell in cells)
               for verdict in ("holds", "in gaps", "violation", "no statement", "missing")}}


def make_summary(reports):
    lines = ["| program | quantity | results | median error | largest error | stated errors | violations (above 1e-12) | in gaps "
             "| flagged |", "|---|---|---|---|---|---|---|---|---|"]
    for name, outcomes in reports.items():
        flagged = sum(outcome["flagged"] for outcome in outcomes)
        for quantity, (title, _) in QUANTITIES.items():
            c = count(outcomes, quantity)
            stated = c["holds"] + c["in gaps"] + c["violation"]
            verdicts = f"{stated} | {c['violation']} ({c['large']}) | {c['in gaps']}" if stated else "none | - | -"
            lines.append(f"| {name} | {title} | {c['results']} | {short(c['median'])} | {short(c['worst'])} | {verdicts} | {flagged} |")
    return "\n".join(lines)


def write_document(path, table):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    begin, end = "<!-- CertifiedTable -->\n", "<!-- /CertifiedTable -->"
    before, rest = text.split(begin)
    with open(path, "w", encoding="utf-8") as file:
        file.write(before + begin + table + "\n" + end + rest.split(end)[1])


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", nargs="+", metavar="[NAME=]COMMAND", help="a program; {file} stands for the STEP file")
    parser.add_argument("--set", default=os.path.join(HERE, "solids"), metavar="FOLDER", help="of certified.json (default: solids)")
    parser.add_argument("--only", default="", metavar="REGEX", help="only files whose names match")
    parser.add_argument("--seconds", type=float, default=60.0, help="largest time for a file (default 60)")
    parser.add_argument("--summary", action="store_true", help="no table by file")
    parser.add_argument("--json", metavar="FILE", help="write everything as JSON; - for standard output, and then no table")
    parser.add_argument("--document", metavar="FILE", help="put the summary between the marks of a Markdown file")
    try:
        return parser.parse_args()
    except SystemExit as stop:
        sys.exit(1 if stop.code else 0)


def main():
    options = parse()
    with open(os.path.join(options.set, "certified.json"), encoding="ascii") as file:
        certificates = [each for each in json.load(file)["solids"] if re.search(options.only, each["file"])]
    if not certificates:
        print("no file matches", file=sys.stderr)
        return 1
    reports = {}
    for program in options.programs:
        name, command = re.fullmatch(r"(?:([\w ,.-]+)=)?(.*)", program, re.DOTALL).groups()
        reports[name or shlex.split(command)[0]] = check(command, options, certificates)
    if options.json:
        text = json.dumps(reports, indent=1)
        if options.json == "-":
            print(text)
        else:
            with open(options.json, "w", encoding="utf-8") as file:
                file.write(text + "\n")
    if options.json != "-":
        for name, outcomes in reports.items():
            if not options.summary:
                print(f"{name}: true error / stated error, relative; **!** a violation, * one in the stated gaps\n\n"
                      f"{make_file_table(outcomes)}\n")
        print(make_summary(reports))
    if options.document:
        write_document(options.document, make_summary(reports))
    cells = [[cell["verdict"] for outcome in outcomes for cell in outcome["quantities"].values()] for outcomes in reports.values()]
    if any(set(verdicts) == {"missing"} for verdicts in cells):
        return 2
    return 3 if any("violation" in verdicts for verdicts in cells) else 0


if __name__ == "__main__":
    sys.exit(main())

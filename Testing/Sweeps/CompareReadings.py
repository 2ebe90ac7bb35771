"""Reads real files as they are, and as OpenCASCADE repairs them all (--repair always), and compares the results.

    CompareReadings.py --program SOLIDMOMENTS --folder MODELS [--other PROGRAM [--brep]] [--only ID ...] [--changed ID ...] [--moved ID ...]

What must hold: the same status, solids and faces; volume, area, centre and inertia within both bounds and both closing spreads, since another
trim curve within the gap is another way of closing it. The area of open bodies, which have no spread, may differ by both gap areas. The last line counts files whose volumes differ by more than both bounds alone, by
more than bounds and spreads, and those whose numbers are equal. --changed names files whose status or counts may differ, --moved those whose
numbers may, because OpenCASCADE puts something else in the place of a surface or an edge. Prints a row per file: the differences relative to
what is allowed, seconds of reading, and what is repaired. A file whose status or counts differ is followed by what only one of both readings says
of faces and edges, with their numbers. Exit status 0 when all of this holds.

With --other, a program whose solidmoments-kernel was built with another OpenCASCADE, that one reads the files with --repair always, and then
--program does. --brep takes the files .brep of the folder, which both programs read by OpenCASCADE.
"""
import argparse
import glob
import json
import os
import subprocess
import sys

WAYS = (["--repair", "always"], ["--repair", "needed"])


def run(program, path, way):
    done = subprocess.run([program, "--quiet", "--backend", "cpu", *way, "--json", "-", path], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, universal_newlines=True, errors="replace", timeout=600, check=False)
    return json.loads(done.stdout)["files"][0]


def flatten(value):
    return [x for part in value for x in flatten(part)] if isinstance(value, list) else [value]


def compare(first, second):
    """Differences of the quantities relative to what is allowed."""
    one, other = first["total"], second["total"]
    ratios = {}
    for name in ("volume", "area", "center_of_mass", "inertia"):
        if one[name] is None or other[name] is None:
            ratios[name] = 0.0 if one[name] == other[name] else float("inf")
            continue
        allowed = sum(total["bounds"][name] or 0.0 for total in (one, other))
        spreads = [total["closure_spread"][name] for total in (one, other)]
        # Open bodies have no spread; what their boundaries differ by is measured.
        gaps = "gap_area" if name == "area" else "gap_squared"
        allowed += sum(total[gaps] or 0.0 for total in (one, other)) if None in spreads else sum(spreads)
        difference = max(abs(x - y) for x, y in zip(flatten(one[name]), flatten(other[name])))
        ratios[name] = difference / allowed if difference else 0.0
    return ratios


def is_apart(first, second):
    """True if the intervals of volume and bound have no common point."""
    totals = (first.get("total") or {}, second.get("total") or {})
    volumes = [total.get("volume") for total in totals]
    bounds = [(total.get("bounds") or {}).get("volume") for total in totals]
    return None not in volumes + bounds and abs(volumes[0] - volumes[1]) > sum(bounds)


def name_entities(first, second, ways):
    """What only one reading says of faces and edges, with their numbers: the entities that were changed."""
    texts = []
    for way, one, other in zip(ways, (first, second), (second, first)):
        texts += [f"    {way}: {message}" for message in one["messages"] if "#" in message and message not in other["messages"]]
    return texts or ["    no message of either names an entity"]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--folder", required=True)
    parser.add_argument("--other")
    parser.add_argument("--brep", action="store_true")
    parser.add_argument("--only", nargs="*")
    parser.add_argument("--changed", nargs="*", default=[])
    parser.add_argument("--moved", nargs="*", default=[])
    options = parser.parse_args()
    ending = ".brep" if options.brep else ".step"
    names = options.only or sorted(os.path.basename(path)[:-5] for path in glob.glob(os.path.join(options.folder, "*" + ending)))
    runs = [(options.program, way) for way in WAYS]
    said = [" ".join(way) for way in WAYS]
    if options.other:
        runs, said = [(program, WAYS[0]) for program in (options.other, options.program)], [options.other, options.program]
    failures, repaired, apart, beyond, equal, seconds = [], 0, 0, 0, 0, [0.0, 0.0]
    for name in names:
        results = [run(program, os.path.join(options.folder, name + ending), way) for program, way in runs]
        for i, result in enumerate(results):
            seconds[i] += result["seconds"].get("read") or 0.0
        told = [message for message in results[1]["messages"] if "repaired by OpenCASCADE" in message]
        repaired += bool(told)
        apart += is_apart(*results)
        counts = [(result["status"], len(result.get("solids") or []), result.get("faces")) for result in results]
        if counts[0] != counts[1] and name not in options.changed:
            failures.append("\n".join([f"{name}: status, solids and faces {counts[0]} with {said[0]}, {counts[1]} with {said[1]}"]
                                      + name_entities(*results, said)))
        ratios = compare(*results) if all("total" in result for result in results) else {}
        equal += bool(ratios) and not any(ratios.values())
        beyond += ratios.get("volume", 0.0) > 1.0
        failures += [] if name in options.moved else [f"{name}: {key} differs by {ratio:.2g} times what is allowed" for key, ratio in ratios.items() if not ratio <= 1.0]
        print(f"{name:28s}", *(f"{ratio:8.2g}" for ratio in ratios.values()),
              f"{results[0]['seconds'].get('read') or 0:7.2f} {results[1]['seconds'].get('read') or 0:7.2f} s", *told, flush=True)
    print(f"{len(names)} files, {repaired} with a body that is repaired; reading takes {seconds[1]:.1f} s, {seconds[0]:.1f} s with "
          f"{said[0]}; the numbers of {equal} are equal, and the volumes of {apart} are apart by more than both "
          f"bounds, which leave out gaps, those of {beyond} by more than bounds and spreads")
    for failure in failures:
        print("FAIL", failure)
    return 1 if failures or not names else 0


if __name__ == "__main__":
    sys.exit(main())

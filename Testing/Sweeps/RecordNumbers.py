"""Records every number that `solidmoments` prints, and compares two recordings to the bit:

    RecordNumbers.py record --program build-dev/bin/solidmoments --output before.json FILE.step...
    RecordNumbers.py compare before.json after.json

A recording holds, for every file and every way of running, the JSON of the command line without its seconds. A change that must
not move a number is shown not to by a recording before it and one after it. `compare` prints every difference and exits 1 if there
is any, 2 if a recording cannot be read. Keys that were renamed between JSON versions 1 and 2 are compared under their new names.
"""
import argparse
import json
import os
import subprocess
import sys

VARIANTS = {
    "opengl": ["--backend", "egl"],
    "cpu": ["--backend", "cpu"],
    "gauss2": ["--backend", "cpu", "--scheme", "gauss2"],
    "waterline": ["--backend", "cpu", "--waterline", "1", "--up", "0,0.1,1"],
    "moments": ["--backend", "cpu", "--moments", "3"],
    "stability": ["--backend", "cpu", "--stability", "-z"],
}
RENAMED = {"moved_by_closing": "closure_correction", "leak": "closure_residual", "plumb_foot": "projected_center_of_mass",
           "work_to_tip": "center_of_mass_rise", "margin": "stability_margin"}
# Seconds differ from run to run; names of files, versions and dispatches are not numbers of the solids.
LEFT_OUT = {"seconds", "file", "version", "messages", "dispatches", "renderer", "backend_reason", "estimate"}


def clean(value):
    """Returns the entry without LEFT_OUT, with old names of keys replaced by today's."""
    if isinstance(value, dict):
        return {RENAMED.get(key, key): clean(item) for key, item in value.items() if key not in LEFT_OUT}
    return [clean(item) for item in value] if isinstance(value, list) else value


def record(arguments):
    """One run per file and variant."""
    runs = {}
    for name in arguments.variants or VARIANTS:
        for path in arguments.files:
            key = f"{name} {os.path.basename(path)}"
            try:
                done = subprocess.run([arguments.program, "--json", "-", *VARIANTS[name], path], stdout=subprocess.PIPE,
                                      stderr=subprocess.DEVNULL, timeout=600, check=False)
                files = json.loads(done.stdout)["files"]
            except (subprocess.TimeoutExpired, ValueError) as error:
                files = [{"failed": type(error).__name__}]
                done = None
            runs[key] = {"exit": done.returncode if done else None, "result": files[0]}
            print(key, runs[key]["exit"], files[0].get("status"), flush=True)
    with open(arguments.output, "w", encoding="utf-8") as file:
        json.dump(runs, file)


def differences(path, before, after):
    """Lines that say where two values differ."""
    if isinstance(before, dict) and isinstance(after, dict):
        for key in sorted(set(before) | set(after)):
            if key not in after or key not in before:
                # A quantity that one version does not have is not a difference of numbers.
                continue
            yield from differences(f"{path}.{key}", before[key], after[key])
    elif isinstance(before, list) and isinstance(after, list) and len(before) == len(after):
        for i, (one, other) in enumerate(zip(before, after)):
            yield from differences(f"{path}[{i}]", one, other)
    elif before != after:
        yield f"{path}: {before!r} became {after!r}"


def compare(arguments):
    """Prints what differs."""
    recordings = []
    for path in (arguments.before, arguments.after):
        try:
            with open(path, encoding="utf-8") as file:
                recordings.append(json.load(file))
        except (OSError, ValueError) as error:
            print(f"{path}: {error}", file=sys.stderr)
            return 2
    before, after = recordings
    count = 0
    for key in sorted(set(before) & set(after)):
        for line in differences(key, clean(before[key]), clean(after[key])):
            print(line)
            count += 1
    only = sorted(set(before) ^ set(after))
    print(f"{len(set(before) & set(after))} runs compared, {count} differences" + (f"; in one recording only: {only}" if only else ""))
    return 1 if count or only else 0


def main():
    """Runs what the command line names."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    recording = commands.add_parser("record")
    recording.add_argument("--program", required=True)
    recording.add_argument("--output", required=True)
    recording.add_argument("--variants", nargs="*", choices=VARIANTS, help="default: all")
    recording.add_argument("files", nargs="+")
    comparing = commands.add_parser("compare")
    comparing.add_argument("before")
    comparing.add_argument("after")
    arguments = parser.parse_args()
    if arguments.command == "compare":
        return compare(arguments)
    record(arguments)
    return 0


if __name__ == "__main__":
    sys.exit(main())

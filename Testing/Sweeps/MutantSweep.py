#!/usr/bin/env python3
"""Damages or rewrites STEP files and judges what solidmoments says of them.

A mutant is (file, kind, seed); the seed chooses file and kind, too. With --mutants damage, whatever the program calls ok must be all that
the mutated text declares (MutantOracle.py), and hold together. --mutants rewrites mean the same, and must get the same status and
numbers within both bounds; --mutants flags have one flag of a face reversed, and must not be ok with other numbers (MutantRewrites.py). Exit
status 1 if a mutant violates that, crashes the program or makes it hang. One mutant again, with all that is said of it, and kept in --keep:

  MutantSweep.py --program solidmoments --solids FOLDER --seed 4711 --keep .
"""
import argparse
import collections
import json
import multiprocessing
import os
import random
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time

from MutantJudge import Baseline, integrals, judge, judge_other
from MutantKinds import KINDS, Source
from MutantRewrites import FLAG_MODE, REWRITE_MODE

SOLIDS = ("bicylinder-plain block_4_3_2-plain box-plain box-inch cone-plain cylinder-plain ellipsoid-plain hollow_sphere-plain "
          "moebius_1000-plain rational_block-plain rational_graph-plain slanted_hole-plain sphere-plain spline_ring-plain "
          "torus-plain torus-nurbs two_solids wavy_plate-plain").split()
BATCH = 20
FINE = (0, 2, 3)
# Each file has a process of its own, which may take so many seconds of the processor; the wall clock only
# ends what sleeps.
LOAD = 10
Finding = collections.namedtuple("Finding", "seed file kind status violation name text")


class Damage(Source):
    """A file that is damaged, and what is known of it."""

    def __init__(self, name, text, entry):
        super().__init__(name, text)
        self.original = text
        self.baseline = Baseline(text, entry)


class DamageMode:
    """Makes damaged files and judges them; the modes of MutantRewrites.py have the same members."""

    kinds = list(KINDS)

    def source(self, name, text, entry):
        return Damage(name, text, entry)

    def mutate(self, kind, seed, source):
        text = KINDS[kind](random.Random(seed), source)
        return (text, True) if text and text != source.text else None

    def judge(self, source, mutant, entry):
        """(what came of the independent integrals, findings)"""
        if entry["status"] != "ok":
            return "", []
        found = judge(source.baseline, mutant[0], entry)
        compared, differing = integrals(source.baseline, mutant[0], entry)
        return compared, found + differing


MODES = {"damage": DamageMode(), "rewrites": REWRITE_MODE, "flags": FLAG_MODE}


class Sweep:
    """Sources with their baselines, and the programs."""

    def __init__(self, options):
        self.options, self.mode = options, MODES[options.mutants]
        self.sources, self.skipped = {}, []
        solids = [s for s in SOLIDS if s not in (options.without or [])] if options.solids else []
        paths = [os.path.join(options.solids, s + ".step") for s in solids]
        for folder in options.models or []:
            paths += sorted(os.path.join(folder, n) for n in os.listdir(folder) if n.endswith((".step", ".stp"))
                            and os.path.getsize(os.path.join(folder, n)) <= options.max_bytes)
        for path, (code, entries) in zip(paths, self.weigh_each(paths)):
            with open(path, encoding="latin-1", newline="") as file:
                text = file.read()
            name = os.path.basename(path)
            source = self.mode.source(name, text, entries[0]) if code in FINE and entries and entries[0]["status"] == "ok" else None
            if source:
                self.sources[name] = source
            else:
                self.skipped.append(name)
        self.names = sorted(self.sources)

    def mutate(self, seed):
        """(file, kind, (text, what is to be known of it)) of a seed; another kind where the file has nothing of the first."""
        chooser = random.Random(seed)
        name = self.options.file or chooser.choice(self.names)
        for _ in range(100):
            kind = self.options.kind or chooser.choice(sorted(self.mode.kinds))
            mutant = self.mode.mutate(kind, f"{name} {kind} {seed} {chooser.random()}", self.sources[name])
            if mutant:
                return name, kind, mutant
        raise ValueError(f"seed {seed}: nothing of this kind in {name}")

    def weigh(self, paths, limit):
        """(exit status or 'hang' or 'crash N', entries of the files that were finished)."""
        command = [self.options.program, "--backend", "cpu", "--quiet", "--json", "-", *paths]
        seconds = int(self.options.limit)
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, preexec_fn=lambda:
                              resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))) as process:
            try:
                code, output = None, process.communicate(timeout=limit)[0]
                code = process.returncode
            except subprocess.TimeoutExpired:
                # Asked to end, the program writes what it has.
                code, output = "hang", self.ended(process)
        try:
            entries = json.loads(output)["files"]
        except (ValueError, KeyError):
            entries = []
        if code in FINE and len(entries) != len(paths):
            code = -1
        return (code if code in FINE or code == "hang" else f"crash {code}"), entries

    def ended(self, process):
        process.terminate()
        try:
            return process.communicate(timeout=10)[0]
        except subprocess.TimeoutExpired:
            process.kill()
            return b""

    def weigh_each(self, paths):
        """weigh() of each: as many as possible in one run of the program."""
        results = []
        while len(results) < len(paths):
            rest = paths[len(results):]
            code, entries = self.weigh(rest, LOAD * self.options.limit)
            results += [(FINE[0], [entry]) for entry in entries[:len(rest)]]
            if code not in FINE and len(results) < len(paths):
                results.append(self.weigh(paths[len(results):][:1], LOAD * self.options.limit))
        return results

    def other_volume(self, path):
        try:
            run = subprocess.run([self.options.occt, path], capture_output=True, timeout=self.options.limit, check=False)
            return json.loads(run.stdout)["volume"]
        except (ValueError, KeyError, subprocess.TimeoutExpired):
            return None

    def batch(self, seeds):
        """[(seed, file, kind, status, findings, what the independent integrals say)] of some seeds: in one run of the program."""
        with tempfile.TemporaryDirectory() as folder:
            mutants = [(seed, *self.mutate(seed)) for seed in seeds]
            paths = [os.path.join(folder, f"{seed}.step") for seed in seeds]
            for path, mutant in zip(paths, mutants):
                with open(path, "w", encoding="latin-1", newline="") as file:
                    file.write(mutant[3][0])
            return [self.result(m, p, *run) for m, p, run in zip(mutants, paths, self.weigh_each(paths))]

    def result(self, mutant, path, code, entries):
        seed, name, kind, made = mutant
        if code not in FINE:
            return seed, name, kind, code.split()[0], [Finding(seed, name, kind, code, True, code.split()[0], code)], ""
        entry = entries[0]
        found, compared = [], ""
        signals = [m for m in entry["messages"] if re.search(r"ended by signal", m)]
        if signals and f"signal {int(signal.SIGXCPU)} " in signals[0]:
            return seed, name, kind, "hang", [Finding(seed, name, kind, "hang", True, "hang", signals[0][-120:])], ""
        if signals:
            found.append(("child", False, signals[0][-120:] + (self.classify(path) if self.options.classify else "")))
            if "in our code" in found[0][2]:
                found[0] = ("child", True, found[0][2])
        else:
            compared, found = self.mode.judge(self.sources[name], made, entry)
            if self.options.occt and entry["status"] == "ok" and self.options.mutants == "damage":
                found += judge_other(self.sources[name].baseline, entry, self.other_volume(path))
        status = "crashed" if signals else entry["status"]
        if self.options.seed is not None:
            print(json.dumps({k: entry[k] for k in ("status", "messages", "faces", "total")}, indent=1))
        return seed, name, kind, status, [Finding(seed, name, kind, status, v, c, t) for c, v, t in found], compared

    def classify(self, path):
        """Whose code a crash of the reading process lies in, by the innermost frames that gdb names."""
        command = ["gdb", "-batch", "-ex", "set follow-fork-mode child", "-ex", "run", "-ex", "bt 12", "--args",
                   self.options.program, "--backend", "cpu", "--quiet", "--json", "-", path]
        try:
            run = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=120, check=False)
        except (OSError, subprocess.TimeoutExpired):
            return "; no stack"
        frames = [re.sub(r"^#\d+\s+(0x\w+ in )?", "", line) for line in run.stdout.split("\n") if re.match(r"#\d+ ", line)]
        frames = [f for f in frames if not re.search(r"raise|abort|__|std::|libc|\?\?", f[:60])]
        ours = bool(frames) and bool(re.match(r"(sm::|vtk(STEP|NURBS|Mass|Moment|Surface|Solid)|\(anonymous)", frames[0]))
        return f"; in {'our code' if ours else 'OpenCASCADE'}: " + " < ".join(f[:70] for f in frames[:3])


SWEEP = None


def run_batch(seeds):
    return SWEEP.batch(seeds)


def run_all(options, seeds):
    """Results of all batches until the time is over, in the order of seeds."""
    results, start = [], time.monotonic()
    batches = [seeds[i:i + BATCH] for i in range(0, len(seeds), BATCH)]
    with multiprocessing.get_context("fork").Pool(options.jobs) as pool:
        for part in pool.imap(run_batch, batches):
            results += part
            if options.log:
                with open(options.log, "a", encoding="utf8") as file:
                    file.writelines(json.dumps(r) + "\n" for r in part)
            if options.minutes and time.monotonic() - start > 60 * options.minutes:
                pool.terminate()
                break
    return results


def report(options, results):
    """Prints the table and the findings; the number of violations."""
    statuses = sorted({r[3] for r in results})
    table = collections.Counter((r[2], r[3]) for r in results)
    width = max(map(len, SWEEP.mode.kinds)) + 1
    print("kind".ljust(width) + "".join(s.rjust(len(s) + 3) for s in statuses) + "   all")
    for kind in [*sorted({r[2] for r in results}), "all"]:
        row = [sum(n for (k, s), n in table.items() if s == status and kind in (k, "all")) for status in statuses]
        print(kind.ljust(width) + "".join(str(n).rjust(len(s) + 3) for n, s in zip(row, statuses)) + str(sum(row)).rjust(6))
    compared = collections.Counter(re.sub(r"[-+.\d]+(e[-+]?\d+)?", "0", r[5]) for r in results if r[5])
    if options.mutants == "damage":
        print(f"\nIndependent integrals: {compared['agrees'] + compared['differs']} of {sum(compared.values())} compared " +
              str(dict(compared.most_common())))
    else:
        print(f"\nNumbers: {compared['same']} the same, {compared['differs']} other ones, {compared['flagged']} flagged, "
              f"{compared['wider']} the same with a bound above the tolerance")
    known = set(options.known or [])
    findings = [f for r in results for f in r[4]]
    violations = [f for f in findings if f.violation and f.seed not in known]
    for title, some in (("Violations", violations), ("Known violations, not counted", [f for f in findings if f.violation
                        and f.seed in known]), ("For a person to look at", [f for f in findings if not f.violation])):
        print(f"\n{title}: {len(some)} " + str(dict(collections.Counter(f.name for f in some)) if some else ""))
        for f in some if title != "For a person to look at" or options.verbose else []:
            print(f"  seed {f.seed}  {f.name}  {f.file}  {f.kind}  {f.status}: {f.text}")
    if options.json:
        with open(options.json, "w", encoding="utf8") as file:
            json.dump({"mutants": len(results), "statuses": dict(collections.Counter(r[3] for r in results)),
                       "table": [[*k, n] for k, n in sorted(table.items())],
                       "integrals": dict(compared.most_common()),
                       "findings": [f._asdict() for f in findings]}, file, indent=1)
    return len(violations)


def show_changes(source, text, name, kind, seed, folder):
    """Prints what a mutation changed, and keeps the mutant."""
    first = next((i for i, (a, b) in enumerate(zip(source, text)) if a != b), min(len(source), len(text)))
    last = next((i for i, (a, b) in enumerate(zip(source[::-1], text[::-1])) if a != b), 0)
    last = min(last, len(source) - first, len(text) - first)
    print(f"{name}, {kind}, seed {seed}, at byte {first}:")
    print("- ", source[max(0, first - 60):min(len(source) - last + 30, first + 600)].replace("\n", " "))
    print("+ ", text[max(0, first - 60):min(len(text) - last + 30, first + 600)].replace("\n", " "))
    if folder:
        with open(os.path.join(folder, f"mutant-{seed}.step"), "w", encoding="latin-1", newline="") as file:
            file.write(text)


def read_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, help="solidmoments")
    parser.add_argument("--occt", help="occt_mass_properties, for a second value of what changed")
    parser.add_argument("--solids", help="folder of the test solids")
    parser.add_argument("--models", action="append", help="folder of real files, unpacked; may be given several times")
    parser.add_argument("--mutants", choices=sorted(MODES), default="damage", help="what is done to the files (default damage)")
    parser.add_argument("--without", nargs="*", choices=SOLIDS, help="test solids to leave out; a seed means another mutant then")
    parser.add_argument("--max-bytes", type=int, default=300000, help="largest real file (default 300000)")
    parser.add_argument("--first", type=int, default=1, help="first seed")
    parser.add_argument("--count", type=int, default=1000, help="number of mutants")
    parser.add_argument("--minutes", type=float, help="stop after so long")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--limit", type=float, default=60, help="seconds of the processor a mutant may take (default 60)")
    parser.add_argument("--seed", type=int, help="this mutant alone")
    parser.add_argument("--file", help="mutate this file only")
    parser.add_argument("--kind", choices=sorted({k for m in MODES.values() for k in m.kinds}), help="this kind only")
    parser.add_argument("--keep", help="folder for the mutant of --seed")
    parser.add_argument("--known", type=int, nargs="*", help="seeds of known violations")
    parser.add_argument("--classify", action="store_true", help="run crashes of the reading process again in gdb")
    parser.add_argument("--json", help="write all findings")
    parser.add_argument("--log", help="append every result, as it comes")
    parser.add_argument("--verbose", action="store_true", help="print what is for a person to look at")
    return parser.parse_args()


def main():
    global SWEEP
    options = read_options()
    SWEEP = Sweep(options)
    if not SWEEP.names:
        print("No file to mutate.")
        return 1
    if options.seed is not None:
        name, kind, made = SWEEP.mutate(options.seed)
        show_changes(SWEEP.sources[name].original, made[0], name, kind, options.seed, options.keep)
        options.verbose = True
    print(f"{len(SWEEP.names)} files; not ok and left out: {', '.join(SWEEP.skipped) or 'none'}")
    if options.mutants == "damage":
        baselines = {n: SWEEP.sources[n].baseline for n in SWEEP.names}
        bare = [f"{n} ({b.no_reference})" for n, b in baselines.items() if b.no_reference is not None]
        for title, names in (("without independent integrals", bare), ("solids and faces not comparable", [n for n, b in baselines.items()
                             if not b.counts]), ("polyhedra", [n for n, b in baselines.items() if b.is_polyhedral])):
            print(f"{title}: {', '.join(names) or 'none'}")
    seeds = [options.seed] if options.seed is not None else list(range(options.first, options.first + options.count))
    return 1 if report(options, run_all(options, seeds)) else 0


if __name__ == "__main__":
    sys.exit(main())

"""TestBatch.py --script PY --pvbatch P --mpirun P --solids FOLDER --sample FILE --output DIR: the batch script on one rank, and on
several in both of pvbatch's modes: one CSV, the same bytes; a bad file costs its row; the exit status."""
import argparse
import csv
import os
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check, check_equal, check_true, finish  # noqa: E402

parser = argparse.ArgumentParser()
for option in ("script", "pvbatch", "mpirun", "solids", "sample", "output"):
    parser.add_argument("--" + option)
options = parser.parse_args()
folder = os.path.join(options.output, "batch")
shutil.rmtree(folder, ignore_errors=True)
os.makedirs(os.path.join(folder, "empty"))
manifest = Manifest(options.solids)
good = ["sphere-plain.step", "slanted_hole-moved.step", "torus-plain.step", "two_solids.step"]
for name in good + ["not_step.step"]:
    shutil.copy(os.path.join(options.solids, name), folder)
# By far the largest, so that its faces are shared.
shutil.copy(options.sample, os.path.join(folder, "part.STP"))


def run(name, launcher, source, *more):
    out = os.path.join(options.output, f"batch_{name}.csv")
    if os.path.exists(out):
        os.remove(out)
    done = subprocess.run(launcher + [options.script, source, "--csv", out] + list(more), capture_output=True, text=True,
                          timeout=240, check=False)
    text = ""
    if os.path.exists(out):
        with open(out, encoding="utf-8", newline="") as file:
            text = file.read()
    return done, text


done, alone = run("alone", [options.pvbatch], folder)
check_equal("exit status with an unreadable file", 2, done.returncode)
rows = list(csv.DictReader(alone.splitlines()))
totals = {row["file"]: row for row in rows if row["row"] == "total"}
check_equal("files, in order", sorted(good + ["not_step.step", "part.STP"]), list(totals))
check_equal("rows of solids", 2, sum(row["row"] == "solid" and row["file"] == "two_solids.step" for row in rows))
sphere = manifest.solid("sphere")
check("volume of the sphere", sphere["volume"], float(totals["sphere-plain.step"]["volume"]), 1e-9 * sphere["volume"])
check_equal("status of the bad file", "unreadable", totals["not_step.step"]["status"])
check_true("and why", "not_step.step" in totals["not_step.step"]["message"], totals["not_step.step"]["message"])
check_equal("no volume of the bad file", "", totals["not_step.step"]["volume"])

for name, launcher in (("ranks", [options.mpirun, "-np", "2", options.pvbatch]),
                       ("symmetric", [options.mpirun, "-np", "3", options.pvbatch, "--sym"])):
    done, text = run(name, launcher, folder)
    check_equal(f"{name}: exit status", 2, done.returncode)
    check_true(f"{name}: the same bytes", text == alone and text != "", (done.stdout + done.stderr)[-2000:] if text != alone else "")
    check_true(f"{name}: faces are shared", "1 shared with all, " in done.stdout and "processor time" in done.stdout, done.stdout[-300:])

os.remove(os.path.join(folder, "not_step.step"))
done, text = run("good", [options.mpirun, "-np", "2", options.pvbatch], folder, "--tolerance", "1e-6")
check_equal("exit status of good files", 0, done.returncode)
check_equal("rows of good files", len(rows) - 1, len(list(csv.DictReader(text.splitlines()))))
done, text = run("empty", [options.pvbatch], os.path.join(folder, "empty"))
check_equal("exit status of an empty folder", 1, done.returncode)
done, text = run("usage", [options.pvbatch], folder, "--backend", "abacus")
check_equal("exit status of wrong usage", 1, done.returncode)
check_true("and what is wrong", "abacus" in done.stderr, done.stderr[-300:])
packages = os.environ.pop("PYTHONPATH")
done, text = run("lost", [options.mpirun, "-np", "2", options.pvbatch], folder)
check_equal("exit status without the package", 1, done.returncode)
check_true("and what is missing", "PYTHONPATH" in done.stderr, done.stderr[-300:])
os.environ["PYTHONPATH"] = packages
finish()

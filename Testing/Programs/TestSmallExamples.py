"""TestSmallExamples.py [--solids FOLDER] half-ball|volume|one-call|three-lines|tolerance COMMAND...: the short examples as a user runs them.

half-ball: BuildByHand or build_by_hand.py. What it prints is compared here with the closed forms of half a ball; bounds must hold and must
be small; a wrong argument ends with a sentence and exit status 1.
volume: volume.py or OneCall on a box of the generated solids, and on a file that does not exist.
one-call: one_call.py on that box, with its mass.
three-lines: three_lines.py where that box is part.step.
tolerance: tolerance_parts.py on that box, whose volume is linear in the offsets of its faces.
"""
import argparse
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check, check_equal, check_true, finish  # noqa: E402

NUMBER = r"(-?[0-9.]+(?:e[-+]?[0-9]+)?)"


def run(*arguments, folder=None):
    result = subprocess.run([*options.command, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
                            timeout=200, env=dict(os.environ, PYTHONDONTWRITEBYTECODE="1"), cwd=folder, check=False)
    print("$", os.path.basename(options.command[-1]), *arguments, "->", result.returncode)
    return result


def check_half_ball(r, *arguments):
    result = run(*arguments)
    if not check_equal("exit status", 0, result.returncode):
        print(result.stdout, result.stderr)
    # `scale` is that of the tolerance: the bound is at most 1e-9 of it.
    for what, exact, scale in (("volume", 2 / 3 * math.pi * r ** 3, r ** 3), ("area", 3 * math.pi * r ** 2, r ** 2),
                               ("height of the centre", 3 / 8 * r, r)):
        found = re.search(rf"^{what} {NUMBER} \+/- {NUMBER}, ", result.stdout, re.MULTILINE)
        if check_true(what + " is printed", found, "" if found else result.stdout):
            value, bound = map(float, found.groups())
            # 15 digits are printed.
            check(what, exact, value, bound + 1e-14 * exact, "(its bound)")
            check_true(what + ": the bound is a small one", 0.0 < bound <= 2e-9 * scale, f"{bound} of {scale}")
    check_true("status", "status ok" in result.stdout)


def half_ball():
    check_half_ball(10.0)
    check_half_ball(0.25, "0.25")
    result = run("--help")
    check_equal("--help: exit status", 0, result.returncode)
    check_true("--help: on the standard output", result.stdout.startswith("usage: ") and not result.stderr, result.stderr.strip())
    for wrong in (["-1"], ["nan"], ["x"], ["1", "2"]):
        result = run(*wrong)
        check_equal("a wrong argument", 1, result.returncode)
        check_true("is explained", result.stderr.startswith("usage: "), result.stderr.strip())


def tolerance():
    box = Manifest(options.solids).solid("box")
    parts, sigma = 4000, 1e-3
    result = run(box["path"], "--parts", str(parts), "--sigma", str(sigma))
    if not check_equal("exit status", 0, result.returncode):
        print(result.stdout, result.stderr)
    found = re.search(rf"^volume: mean {NUMBER}, deviation {NUMBER}; linear prediction: {NUMBER}, {NUMBER}$", result.stdout, re.MULTILINE)
    if check_true("the volume is printed", found, "" if found else result.stdout):
        mean, deviation, linear, predicted = map(float, found.groups())
        check("predicted mean", box["volume"], linear, 1e-10 * box["volume"], "(12 digits)")
        check("mean", linear, mean, 5.0 * predicted / math.sqrt(parts), "(5 standard errors)")
        check("deviation", predicted, deviation, 5.0 * predicted / math.sqrt(2.0 * parts), "(5 standard errors)")
        # Six independent offsets: between those of equal areas and of one face alone.
        check_true("sum of the squared areas", box["area"] / math.sqrt(6.0) * (1.0 - 1e-5) <= predicted / sigma <= box["area"], str(predicted / sigma))
    check_equal("no file: exit status", 1, run(box["path"] + ".missing").returncode)


def volume():
    box = Manifest(options.solids).solid("box")
    result = run(box["path"])
    check_equal("exit status", 0, result.returncode)
    found = re.fullmatch(rf"volume {NUMBER} \+/- {NUMBER} ok\n", result.stdout)
    if check_true("one line", found, result.stdout + result.stderr):
        value, bound = map(float, found.groups())
        check("volume", box["volume"], value, bound, "(its bound)")
        check_true("the bound is a small one", 0.0 < bound <= 1e-9 * box["volume"], str(bound))
    check_equal("no file: exit status", 3, run(box["path"] + ".missing").returncode)


def one_call():
    box = Manifest(options.solids).solid("box")
    result = run(box["path"])
    check_equal("exit status", 0, result.returncode)
    found = re.match(rf"volume {NUMBER} \+/- {NUMBER} mm\^3 ok\nmass {NUMBER} \+/- {NUMBER} kg\n.* mm\n$", result.stdout)
    if check_true("volume, mass and a solid", found, result.stdout + result.stderr):
        volume, bound, mass, mass_bound = map(float, found.groups())
        check("volume", box["volume"], volume, bound, "(its bound)")
        check("mass in kg", 7850e-9 * box["volume"], mass, mass_bound, "(its bound)")


def three_lines():
    box = Manifest(options.solids).solid("box")
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(box["path"], os.path.join(folder, "part.step"))
        result = run(folder=folder)
    check_equal("exit status", 0, result.returncode)
    found = re.fullmatch(rf"{NUMBER} \+/- {NUMBER} kg ok\n", result.stdout)
    if check_true("one line", found, result.stdout + result.stderr):
        mass, bound = map(float, found.groups())
        check("mass in kg", 7850e-9 * box["volume"], mass, bound, "(its bound)")


parser = argparse.ArgumentParser()
parser.add_argument("mode", choices=("half-ball", "volume", "one-call", "three-lines", "tolerance"))
parser.add_argument("--solids")
parser.add_argument("command", nargs=argparse.REMAINDER)
options = parser.parse_args()
{"half-ball": half_ball, "volume": volume, "one-call": one_call, "three-lines": three_lines, "tolerance": tolerance}[options.mode]()
finish()

"""TestTolerances.py --program P --output DIR: tolerances of faces and the budget of the mass, by the command line, of boxes."""
import argparse
import csv
import functools
import os
import sys
import threading
from fractions import Fraction

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
import smprogram  # noqa: E402
from smcheck import check, check_equal, check_true, finish  # noqa: E402
from smpicture import read_picture  # noqa: E402
from smproduct import Assembly, Part, make_box, write_product  # noqa: E402

parser = argparse.ArgumentParser()
for name in ("--program", "--output"):
    parser.add_argument(name, required=True)
options = parser.parse_args()
folder = os.path.join(options.output, "tolerances")
os.makedirs(folder, exist_ok=True)
run = functools.partial(smprogram.run, options.program)
run_json = functools.partial(smprogram.run_json, options.program)
points, faces = make_box(Fraction(4), Fraction(5), Fraction(6), (Fraction(0),) * 3)
file = os.path.join(folder, "box.step")
write_product(file, Part("cube", [((0, 0, 0), (10, 10, 10))]))

# A tolerance for all faces; a table, of which "all" is for what no other line fits.
answer = run_json(file, "--face-tolerance", "0.1", "--density", "7850")
total = answer["total"]
solid = answer["solids"][0]
for body in (total, solid):
    volume = body["tolerance"]["volume"]
    check("upper volume", 10.2 ** 3, volume["maximum"], 1e-9)
    check("lower volume", 9.8 ** 3, volume["minimum"], 1e-9)
    check("deviation", (6 * 100.0 ** 2 * 0.01 / 3) ** 0.5, volume["deviation"], 1e-9)
    check("upper mass", 7850e-9 * 10.2 ** 3, body["tolerance"]["mass"]["maximum"], 1e-14)
    check_equal("five faces", 5, len(body["tolerance"]["faces"]))
    check("the share of a face", 10.0, body["tolerance"]["faces"][0]["volume"], 1e-9)
table = os.path.join(folder, "tolerances.csv")
with open(table, "w", encoding="utf-8") as out:
    out.write("# kind, pattern, limits\npart,sphere*,7\nall,-0.1,0.2\n")
answer = run_json(file, "--face-tolerance", table, "--tolerance-distribution", "normal")
volume = answer["total"]["tolerance"]["volume"]
check("upper volume of a table", 10.4 ** 3, volume["maximum"], 1e-9)
check("lower volume of a table", 9.8 ** 3, volume["minimum"], 1e-9)
check("normal deviation", (6 * 100.0 ** 2 * 0.05 ** 2) ** 0.5, volume["deviation"], 1e-9)
check_true("the line without a face is named", any("sphere*" in message for message in answer["messages"]))
# A table from a pipe can be read once; outputs must not overwrite it.
pipe = os.path.join(folder, "pipe")
if os.path.exists(pipe):
    os.remove(pipe)
os.mkfifo(pipe)


def feed():
    with open(pipe, "w", encoding="utf-8") as out:
        out.write("all,0.1\n")


thread = threading.Thread(target=feed)
thread.start()
answer = run_json(file, "--face-tolerance", pipe)
thread.join()
check("upper volume by a pipe", 10.2 ** 3, answer["total"]["tolerance"]["volume"]["maximum"], 1e-9)
result = run(file, "--face-tolerance", table, "--csv", table)
check_true("the table is not an output", result.returncode == 1 and "would overwrite" in result.stderr, result.stderr)
rows = os.path.join(folder, "rows.csv")
run(file, "--face-tolerance", "0.1", "--csv", rows)
with open(rows, encoding="utf-8", newline="") as text:
    lengths = [len(row) for row in csv.reader(text)]
check_equal("rows of the head, the total and the solid", [lengths[0]] * 3, lengths)
result = run(file, "--face-tolerance", "0.1")
check_equal("exit status", 0, result.returncode)
check_true("rows of the table", "within tolerances     volume 941.19 to 1061.21 mm^3" in result.stdout and "centre within" in result.stdout, result.stdout)
for wrong, word in (("-1", "not a tolerance"), (os.path.join(folder, "missing.csv"), "neither a number")):
    result = run(file, "--face-tolerance", wrong)
    check_true(f"refused: {wrong}", result.returncode == 1 and word in result.stderr, result.stderr)
for line, word in (("edge,#1,0.1", "is not face, part, colour or all"), ("face,#1", "KIND,PATTERN"), ("face,,0.1", "pattern is empty"),
                   ("face,#1,0.2,0.1", "lower one first"), ("face,#1,x", "lower one first"), ("face,#1,0.1,0.2", "without 0")):
    with open(table, "w", encoding="utf-8") as out:
        out.write("\n" + line + "\n")
    result = run(file, "--face-tolerance", table)
    check_true(f"refused: {line}", result.returncode == 1 and "line 2" in result.stderr and word in result.stderr, result.stderr)
result = run(file, "--tolerance-distribution", "normal")
check_true("a distribution of nothing", result.returncode == 1 and "--face-tolerance" in result.stderr, result.stderr)
answer = run_json(file, "--tolerances")
check_equal("a file without tolerances", [], answer["total"]["tolerance"]["drawing"])
check_true("says so", any("0 of 0 tolerances" in message for message in answer["messages"]), str(answer["messages"]))

# The budget is the sum of its lines, and the bars of the picture have their heights.
picture = os.path.join(folder, "budget.png")
if os.path.exists(picture):
    os.remove(picture)
answer = run_json(file, "--face-tolerance", "0.1", "--density", "7850", "--density-tolerance", "2%", "--budget", picture)
budget = answer["total"]["budget"]
lines = {line["name"]: line["mass"] for line in budget["lines"]}
check_equal("lines", ["numerical", "closing", "density", "tolerance"], list(lines))
check("tolerance", 1.02 * 7850e-9 * (10.2 ** 3 - 1e3), lines["tolerance"], 1e-12)
check("density", 0.02 * 7850e-6, lines["density"], 1e-15)
check("closing", 0.0, lines["closing"], 0.0)
check("sum", sum(lines.values()), budget["mass"], 1e-11 * budget["mass"], "rounded up")
pixels = read_picture(picture)
if check_true("there is a picture", pixels is not None):
    bars = (abs(pixels - [60, 110, 180]).max(axis=2) < 20).sum(axis=0)
    # Columns of the two bars that can be seen, from left to right.
    columns = [x for x in range(len(bars)) if bars[x] > 20]
    parts = [[x for x in columns if x < columns[0] + 60], [x for x in columns if x > columns[-1] - 60]]
    heights = [max(bars[x] for x in part) for part in parts]
    check("heights of the bars", lines["density"] / lines["tolerance"], heights[0] / heights[1], 0.03, "pixels of 300")
result = run(file, "--density", "7850", "--budget", picture)
check_true("rows of the budget", "which is the sum of" in result.stdout and "numerical" in result.stdout, result.stdout)
check_equal("another ending", 1, run(file, "--budget", "budget.jpg").returncode)
check_equal("two files", 1, run(file, file, "--budget", picture).returncode)
result = run(file, "--budget", picture)
check_true("no density", result.returncode != 0 and "the mass is not known" in result.stdout, result.stdout)
result = run(file, "--density", "7850", "--budget", os.path.join(folder, "missing", "b.png"))
check_true("a folder that is missing", result.returncode == 1 and "cannot be written" in result.stderr, result.stderr)
result = run(file, "--density", "7850", "--budget", picture, "--png", picture)
check_true("two outputs of one name", result.returncode == 1 and "would overwrite" in result.stderr, result.stderr)

# What tolerances change is in the mass in doubt without --budget, too.
result = run(file, "--face-tolerance", "0.1", "--density", "7850", "--density-tolerance", "2%")
share = 1.02 * 7850e-9 * (10.2 ** 3 - 1e3)
check_true("in the table", "tolerances 0.0005\n" in result.stdout and "mass in doubt         0.00065 kg: density 0.00016, gaps 0" in result.stdout, result.stdout)
answer = run_json(file, "--face-tolerance", "0.1", "--density", "7850", "--density-tolerance", "2%")
for body in (answer["total"], answer["solids"][0]):
    doubt = body["mass_uncertainty"]
    check("share of the tolerances", share, doubt["tolerance"], 1e-14)
    check("sum", doubt["density"] + doubt["gaps"] + doubt["numerical"] + doubt["overridden"] + doubt["tolerance"], doubt["total"], 2e-12 * doubt["total"])
answer = run_json(file, "--density", "7850")
check_true("no tolerances, no share", answer["total"]["mass_uncertainty"]["tolerance"] is None, str(answer["total"]["mass_uncertainty"]))

# Pictures are coloured by what faces add: a block with faces of 200, 400 and 800 mm^2, pale to dark.
block = os.path.join(folder, "block.step")
write_product(block, Part("block", [((0, 0, 0), (10, 20, 40))]))


def draw(*arguments):
    """The pixels of a picture: those of the bar's column, and the number of dark ones of the block."""
    name = os.path.join(folder, "colours.png")
    if os.path.exists(name):
        os.remove(name)
    run("-q", block, "--png", name, *arguments)
    pixels = read_picture(name)
    if not check_true("there is a picture", pixels is not None):
        finish()
    column = pixels[:, 800].astype(int)
    return column, int((pixels[100:600, 100:750].sum(axis=2) < 160).sum())


def count(column, color):
    return int((abs(column - color).max(axis=1) < 12).sum())


plain, dark = draw()
check_true("no bar, no dark face", count(plain, (38, 5, 51)) == 0 and dark < 500, str(dark))
for arguments in (("--sensitivity",), ("--face-tolerance", "0.1")):
    bar, dark = draw(*arguments)
    check_true(f"{arguments[0]}: the bar has both ends", count(bar, (38, 5, 51)) > 2 and count(bar, (250, 245, 184)) > 2, str(bar[::20]))
    check_true(f"{arguments[0]}: the largest faces are dark", dark > 5000, str(dark))
# A tolerance of one face alone leaves all others pale.
with open(table, "w", encoding="utf-8") as out:
    out.write("part,nothing,0.1\n")
bar, dark = draw("--face-tolerance", table)
check_true("no face has a tolerance: the colours of the file", count(bar, (38, 5, 51)) == 0 and dark < 500, str(dark))

# A part that is as wide as its picture leaves the bar free, from pixel 784 on.
wide, name = os.path.join(folder, "wide.step"), os.path.join(folder, "wide.png")
write_product(wide, Part("wide", [((0, 0, 0), (100, 100, 1))]))
run("-q", wide, "--png", name, "--sensitivity")
pixels = read_picture(name)
check_true("the part is not behind the bar", int((pixels[180:500, 772:782].min(axis=2) < 180).sum()) == 0 and
           int((pixels[180:500, 700:730].min(axis=2) < 180).sum()) > 20, "pixels left of the bar")

# A line of the budget that is not known is neither 0 nor added.
lid = write_product(os.path.join(folder, "open.step"), Part("open", [], polyhedra=[(points, faces[1:])]))
result = run(lid, "--density", "1000", "--density-tolerance", "1%", "--budget", picture)
check_true("not known", all(line in result.stdout for line in ("mass in doubt         not known, as is closing; the other lines 1.1e-06 kg in all\n",
                                                               "    closing             not known\n")), result.stdout)
check_true("there is a picture", read_picture(picture) is not None)

# The tolerance of a total is that of its solids, each at its own largest density.
pair = os.path.join(folder, "pair.step")
write_product(pair, Assembly("pair", [(Part("a", [((0, 0, 0), (10, 10, 10))]), (0, 0, 0), None),
                                      (Part("b", [((0, 0, 0), (10, 10, 10))]), (20, 0, 0), None)]))
weights = os.path.join(folder, "weights.csv")
with open(weights, "w", encoding="utf-8") as out:
    out.write("a,light,1e6,50%\nb,heavy,9e6\n")
with open(table, "w", encoding="utf-8") as out:
    out.write("part,a,0.1\n")
answer = run_json(pair, "--materials", weights, "--face-tolerance", table, "--budget", picture)
lines = {line["name"]: line["mass"] for line in answer["total"]["budget"]["lines"]}
check("mass", 10.0, answer["total"]["mass"], 1e-9)
check("density of a pair", 0.5, lines["density"], 1e-9)
check("tolerance of a pair", 1.5 * (1.02 ** 3 - 1.0), lines["tolerance"], 1e-9)
finish()

"""TestEqualBodies.py MODE --program SOLIDMOMENTS --solids FOLDER --output FOLDER: bodies of a file that equal another one are integrated once.

`values`: solids of the certified set, four times in one file, moved; each copy has the certified values, which do not depend on its place,
within its bounds, and the file takes the evaluations of one. `changes`: the second of two solids differs by one number or flag; it has the
values that it has in a file of its own.
"""
import argparse
import json
import os
import random
import re
import sys
from decimal import Decimal, localcontext

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check_true, finish  # noqa: E402
from smprogram import compute  # noqa: E402

MOVES = (("0", "0", "0"), ("31.7", "-0.3", "12.9"), ("0.1", "250", "0"), ("-1234.567", "0", "-76.25"))
# Solids with other than one body.
OTHERS = ("assembly.step", "mirror_pair.step")
ENTITY = re.compile(r"^#(\d+)=(.*);$")
POINT = re.compile(r"^CARTESIAN_POINT\('',\(([^,()]+),([^,()]+),([^,()]+)\)\)$")
NUMBER = re.compile(r"(?<![#\w'.])-?\d+\.\d*(?:E[-+]?\d+)?")
ULP = 2.0 ** -52


class Part:
    """A file with one solid, and the entities that make it, without those of its product."""

    def __init__(self, path):
        with open(path, encoding="ascii") as file:
            self.lines = file.read().split("\n")
        self.entities = {int(match[1]): match[2] for match in map(ENTITY.match, self.lines) if match}
        self.root = next(i for i, text in self.entities.items() if text.startswith(("MANIFOLD_SOLID_BREP", "BREP_WITH_VOIDS")))
        self.reached = set()
        self.reach(self.root, self.reached)
        # What the rest of the file needs, of the solid maybe an axis.
        self.kept = {self.root}
        for entity in set(self.entities) - self.reached:
            self.reach(entity, self.kept)
        self.kept.remove(self.root)

    def reach(self, entity, reached):
        if entity not in reached:
            reached.add(entity)
            for other in re.findall(r"#(\d+)", self.entities[entity]):
                self.reach(int(other), reached)

    def copy(self, index, move, changes=()):
        """The lines of a copy, with numbers of its own, and the number of its solid."""
        first = index * (max(self.entities) + 1)
        lines = []
        for entity in sorted(self.reached):
            text = dict(changes).get(entity, self.entities[entity])
            point = POINT.match(text)
            if point:
                with localcontext() as context:
                    context.prec = 60
                    moved = [format_decimal(Decimal(x) + Decimal(d)) for x, d in zip(point.groups(), move)]
                text = f"CARTESIAN_POINT('',({','.join(moved)}))"
            lines.append(f"#{entity + first}=" + re.sub(r"#(\d+)", lambda match: f"#{int(match[1]) + first}", text) + ";")
        return lines, self.root + first

    def write(self, path, copies):
        """Writes the file with these copies, (move, changes), in the place of its solid."""
        made = [self.copy(k + 1, move, changes) for k, (move, changes) in enumerate(copies)]
        with open(path, "w", encoding="ascii") as file:
            for line in self.lines:
                match = ENTITY.match(line)
                if match and f"#{self.root}" in match[2] and "REPRESENTATION(" in match[2]:
                    roots = ",".join(f"#{root}" for _, root in made)
                    line = re.sub(rf"#{self.root}(?!\d)", roots, line)
                if not match or int(match[1]) in self.kept:
                    file.write(line + "\n")
                if line == "DATA;":
                    file.writelines(text + "\n" for lines, _ in made for text in lines)


def format_decimal(number):
    text = f"{number:f}"
    return text if "." in text else text + "."


def is_within(value, interval, bound):
    low, high = (float(end) for end in interval)
    slack = bound + 4.0 * ULP * max(abs(low), abs(high))
    return low - slack <= value <= high + slack


def find_mistakes(solid, truth, move):
    """The values of a copy that are not within the certified interval and the bound."""
    bounds = solid["bounds"]
    mistakes = [name for name in ("volume", "area") if not is_within(solid[name], truth[name], bounds[name])]
    for c in range(3):
        interval = [Decimal(end) + Decimal(move[c]) for end in truth["center_of_mass"][c]]
        if not is_within(solid["center_of_mass"][c], interval, bounds["center_of_mass"]):
            mistakes.append(f"center {c}")
        for d in range(3):
            if not is_within(solid["inertia"][c][d], truth["inertia"][c][d], bounds["inertia"]):
                mistakes.append(f"inertia {c} {d}")
    return mistakes


def check_values(options):
    with open(os.path.join(options.solids, "certified.json"), encoding="utf-8") as file:
        truths = [truth for truth in json.load(file)["solids"] if truth["file"] not in OTHERS]
    shared = []
    for truth in truths:
        part = Part(os.path.join(options.solids, truth["file"]))
        path = os.path.join(options.output, "equal_" + truth["file"])
        part.write(path, [(move, ()) for move in MOVES])
        # Small solids far from the origin do not meet the tolerance, in a file of their own neither.
        entry = compute(options.program, path, "--unit", "file")[1]
        os.remove(path)
        alone = compute(options.program, os.path.join(options.solids, truth["file"]), "--unit", "file")[1]
        solids = entry["solids"]
        mistakes = [find_mistakes(solid, truth, move) for solid, move in zip(solids, MOVES)]
        check_true(truth["file"], entry["status"] in ("ok", "tolerance-not-met") and len(solids) == len(MOVES) and not any(mistakes),
                   f"{entry['status']} {mistakes}")
        evaluations = [result["evaluations"] for result in (entry, alone)]
        if evaluations[0] < 1.5 * evaluations[1]:
            shared.append(truth["file"])
    print("integrated once:", " ".join(shared))
    # Not those that are so thin or so far away that the places of copies would count.
    check_true("most solids are integrated once", len(shared) > 0.6 * len(truths), f"{len(shared)} of {len(truths)}")


def change(part, entity, number):
    """Changes one number of an entity by a millionth of it or of a millimetre, or one flag; `number` chooses it."""
    text = part.entities[entity]
    places = list(NUMBER.finditer(text)) + list(re.finditer(r"\.[TF]\.", text))
    if not places:
        return None
    place = places[number % len(places)]
    old = place[0]
    new = {".T.": ".F.", ".F.": ".T."}.get(old) or format_decimal(Decimal(old) * Decimal("1.000001") if float(old) else Decimal("0.000001"))
    return text[:place.start()] + new + text[place.end():]


def describe(entry, index):
    """Status, volume, area and bounds of a solid; its status is that of the file if there is no such solid."""
    if index >= len(entry["solids"]):
        return entry["status"], None
    solid = entry["solids"][index]
    return solid["status"], (solid["volume"], solid["bounds"]["volume"], solid["area"], solid["bounds"]["area"])


def is_same(one, other):
    if one is None or other is None or None in one or None in other:
        return one == other
    return abs(one[0] - other[0]) <= one[1] + other[1] and abs(one[2] - other[2]) <= one[3] + other[3]


def check_changes(options):
    rng = random.Random(20261128)
    changed = 0
    for name in ("sphere", "torus_one_face", "box", "cylinder", "cone_revolved", "dome", "box_with_hole", "wing_bspline"):
        part = Part(os.path.join(options.solids, name + ".step"))
        path = os.path.join(options.output, f"equal_changed_{name}.step")
        unchanged = compute(options.program, os.path.join(options.solids, name + ".step"))[1]["solids"][0]
        for _ in range(options.count):
            entity = rng.choice(sorted(part.reached))
            text = change(part, entity, rng.randrange(1000))
            if text is None:
                continue
            part.write(path, [(MOVES[0], ()), (MOVES[1], ((entity, text),))])
            pair = compute(options.program, path)[1]
            part.write(path, [(MOVES[1], ((entity, text),))])
            alone = compute(options.program, path)[1]
            one, other = describe(pair, len(pair["solids"]) - 1 if len(alone["solids"]) else 1), describe(alone, 0)
            check_true(f"{name}: #{entity}={text[:50]}", one[0] == other[0] and is_same(one[1], other[1]), f"{one} {other}")
            changed += other[1] is not None and other[1][0] is not None and abs(other[1][0] - unchanged["volume"]) > other[1][1]
            os.remove(path)
    check_true("changes of the volume were seen", changed >= 3, f"{changed}")


MODES = {"values": check_values, "changes": check_changes}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("mode", choices=sorted(MODES))
    parser.add_argument("--program", required=True)
    parser.add_argument("--solids", required=True)
    parser.add_argument("--output", required=True)
    parser.add_argument("--count", type=int, default=5, help="changes of each solid")
    options = parser.parse_args()
    MODES[options.mode](options)
    finish()


if __name__ == "__main__":
    main()

"""Prints a Markdown table of solidmoments' errors on the generated solids, whose mass properties are known exactly.

    AccuracyTable.py --program build/bin/solidmoments --solids build/Testing/solids [--variant plain]
                     [--document Documentation/Numerics.md]

Every cell is "error / bound", both relative: volume and area to themselves, the centre to the size of the solid,
inertia to its trace. The bounds are those the program states; gaps between faces and edges, which it states apart, and
the file's own digits are not part of them. Where an error exceeds its bound but not all three together, the cell has a `*` and a
line below the table says how much the file leaves open; "est." is a bound that is an estimate. Exit status 1 when an error
exceeds bound, gaps and digits together. --document also puts the table between the document's marks.
"""
import argparse
import json
import os
import subprocess
import sys


TITLES = {"volume": "volume", "area": "area", "center_of_mass": "centre", "inertia": "inertia"}


def run(program, path, tolerance):
    result = subprocess.run([program, "--quiet", "--tolerance", tolerance, "--json", "-", path],
                            stdout=subprocess.PIPE, check=False)
    return json.loads(result.stdout)["files"][0]


def largest(actual, expected):
    return max(abs(a - e) for a, e in zip(actual, expected))


def short(value):
    return f"{value:.0e}" if value else "0"


def quantities(total, entry):
    """Name, error, bound, what is allowed besides, and the scale of each."""
    trace = sum(entry["inertia"][i][i] for i in range(3))
    size = entry["size"]
    gap = total["gap_squared"]
    center = largest(total["center_of_mass"], entry["center_of_mass"])
    inertia = max(largest(a, e) for a, e in zip(total["inertia"], entry["inertia"]))
    errors = {
        "volume": (abs(total["volume"] - entry["volume"]), gap, entry["volume"]),
        "area": (abs(total["area"] - entry["area"]), total["gap_area"], entry["area"]),
        "center_of_mass": (center, gap * size / entry["volume"], size),
        "inertia": (inertia, gap * size * size, trace),
    }
    for name, (error, doubt, scale) in errors.items():
        yield name, error, total["bounds"][name], doubt + entry["file_accuracy"][name], scale


def find_solids(manifest, variant):
    """Title and entry of every solid of the variant, and with the plain ones of a cone with an apex, to all digits and to 12."""
    # Lengths come out in mm.
    solids = [(entry["solid"].replace("_", " "), entry) for entry in manifest["solids"]
              if entry["variant"] == variant and entry["unit"] == "MM"]
    if variant == "plain":
        tips = [("cone with an apex", "cone_tip"), ("cone with an apex, 12 digits", "cone_tip_digits12")]
        after = 1 + [title for title, _ in solids].index("cone")
        solids[after:after] = [(title, manifest["special"][name]) for title, name in tips]
    return solids


class Table:
    """Lines of Markdown; failures are errors that nothing allows."""

    def __init__(self):
        self.lines = ["| solid | volume | area | centre | inertia | evaluations |", "|---|---|---|---|---|---|"]
        # By solid: what its file leaves open, of the quantities that it matters for.
        self.notes = {}
        self.failures = []

    def add(self, title, entry, document):
        total = document["total"]
        cells = []
        for name, error, bound, allowance, scale in quantities(total, entry):
            cell = f"{short(error / scale)} / {short(bound / scale)}"
            if name == "area" and total["bounds_estimated"]:
                cell += " est."
            if not error <= bound + allowance:
                self.failures.append(f"{entry['file']}: {name} is off by {error}, more than its bound {bound}")
            elif error > bound:
                cell += "\\*"
                left = f"{TITLES[name]} {short(allowance / scale)}"
                self.notes[title] = f"{self.notes[title]}, {left}" if title in self.notes else left
            cells.append(cell)
        self.lines.append(f"| {title} | {' | '.join(cells)} | {document['evaluations']} |")

    def text(self):
        lines = list(self.lines)
        if self.notes:
            lines += ["", "\\* Beyond the bound, within what the gaps between faces and edges and the digits of the file leave open:",
                      "; ".join(f"{title} ({note})" for title, note in self.notes.items()) + "."]
        return "\n".join(lines) + "\n"


def put_into(document, text):
    with open(document, encoding="utf-8") as stream:
        old = stream.read()
    before, mark, rest = old.partition("<!-- AccuracyTable -->\n")
    _, end, after = rest.partition("<!-- /AccuracyTable -->\n")
    if not mark or not end:
        raise ValueError(f"{document} has no marks <!-- AccuracyTable --> and <!-- /AccuracyTable -->")
    with open(document, "w", encoding="utf-8") as stream:
        stream.write(before + mark + text + end + after)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, help="path of solidmoments")
    parser.add_argument("--solids", required=True, help="folder that smMakeSolids wrote")
    parser.add_argument("--variant", default="plain", help="plain, nopcurves, nurbs, moved, mirrored, far, ...")
    parser.add_argument("--tolerance", default="1e-9", help="relative tolerance, default 1e-9")
    parser.add_argument("--document", help="put the table there")
    options = parser.parse_args()
    with open(os.path.join(options.solids, "manifest.json"), encoding="utf-8") as stream:
        manifest = json.load(stream)

    table = Table()
    solids = find_solids(manifest, options.variant)
    for title, entry in solids:
        table.add(title, entry, run(options.program, os.path.join(options.solids, entry["file"]), options.tolerance))
    print(table.text(), end="")
    for failure in table.failures:
        print(failure, file=sys.stderr)
    if not solids:
        print(f"no solid has the variant {options.variant}", file=sys.stderr)
    elif options.document:
        put_into(options.document, table.text())
    return 1 if table.failures or not solids else 0


if __name__ == "__main__":
    sys.exit(main())

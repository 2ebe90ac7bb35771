#!/usr/bin/env python3
"""Random product structures of boxes whose volumes and centres are known: what is ok must have them.

Parts have their solids in one or two representations, plain, related or related with a motion; assemblies place parts and other assemblies by
occurrences with a relationship in either order, by mapped items, by both together, or by a relationship alone, in several units. Forms that
the standard does not define, or that leave open what is counted, may be flagged. Exit status 1 if an ok file has other numbers, or if fewer
than a quarter of the files are ok.

  RandomAssemblies.py --program solidmoments --output FOLDER --count 200
"""
import argparse
import collections
import json
import math
import os
import random
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smstepbody import EMPTY, Body, triple  # noqa: E402

MILLIMETRES = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "inch": 25.4}
# Of the volume, and of the extent of an assembly in mm for its centre.
ACCURACY, EXTENT = 1e-9, 1000.0
IDENTITY = (((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), (0.0, 0.0, 0.0))
SOLIDS = "ADVANCED_BREP_SHAPE_REPRESENTATION"
Product = collections.namedtuple("Product", "definition shape unit solids")


def compose(first, second):
    (a, p), (b, q) = first, second
    return (tuple(tuple(sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)) for i in range(3)), move(first, q))


def move(motion, point):
    a, p = motion
    return tuple(sum(a[i][k] * point[k] for k in range(3)) + p[i] for i in range(3))


def invert(motion):
    a, p = motion
    turned = tuple(zip(*a))
    return turned, tuple(-sum(row[k] * p[k] for k in range(3)) for row in turned)


class Assembly(Body):
    """Writes a random product structure. `roots` are the products that are parts of nothing."""

    def __init__(self, seed):
        super().__init__()
        self.chance = random.Random(seed)
        self.units = ["mm"] if self.chance.random() < 0.5 else sorted(MILLIMETRES)
        self.contexts = {"mm": self.context}
        products = [self.add_part(f"part{k}") for k in range(self.chance.randint(1, 3))]
        used = set()
        for k in range(self.chance.randint(1, 3)):
            children = [self.chance.choice(products) for _ in range(self.chance.randint(1, 3))]
            children += [] if products[-1] in children else [products[-1]]
            used.update(child.definition for child in children)
            products.append(self.add_assembly(f"assembly{k}", children))
        self.roots = [p for p in products if p.definition not in used]

    def get_context(self, name):
        if name not in self.contexts:
            prefixes = {"cm": ".CENTI.", "m": "$"}
            if name in prefixes:
                unit = self.add(f"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT({prefixes[name]},.METRE.))")
            else:
                base = self.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))")
                measure = self.add(f"LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),{base})")
                unit = self.add(f"(CONVERSION_BASED_UNIT('INCH',{measure})LENGTH_UNIT()NAMED_UNIT({self.add('DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)')}))")
            angle = self.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
            self.contexts[name] = self.add(f"(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT(({unit},{angle}))REPRESENTATION_CONTEXT('',''))")
        return self.contexts[name]

    def make_motion(self):
        axis = [self.chance.gauss(0.0, 1.0) for _ in range(3)]
        x, y, z = (a / math.hypot(*axis) for a in axis)
        angle = self.chance.uniform(0.0, 3.0) if self.chance.random() < 0.8 else 0.0
        c, s = math.cos(angle), math.sin(angle)
        d = 1.0 - c
        rows = ((c + x * x * d, x * y * d - z * s, x * z * d + y * s), (y * x * d + z * s, c + y * y * d, y * z * d - x * s),
                (z * x * d - y * s, z * y * d + x * s, c + z * z * d))
        return rows, tuple(self.chance.uniform(-50.0, 50.0) for _ in range(3))

    def frame(self, motion, unit):
        rows, origin = motion
        z, x = (self.add(triple("DIRECTION", [row[k] for row in rows])) for k in (2, 0))
        point = self.add(triple("CARTESIAN_POINT", [p / MILLIMETRES[unit] for p in origin]))
        return self.add(f"AXIS2_PLACEMENT_3D('',{point},{z},{x})")

    def represent(self, items, unit, kind="SHAPE_REPRESENTATION"):
        return self.add(f"{kind}('',({','.join(items)}),{self.get_context(unit)})")

    def relate(self, first, second, frames=None):
        if not frames:
            return self.add(f"SHAPE_REPRESENTATION_RELATIONSHIP('','',{first},{second})")
        motion = self.add(f"ITEM_DEFINED_TRANSFORMATION('','',{frames[0]},{frames[1]})")
        return self.add(f"(REPRESENTATION_RELATIONSHIP('','',{first},{second})REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({motion})"
                        "SHAPE_REPRESENTATION_RELATIONSHIP())")

    def add_box(self, unit):
        """A solid, and its [(volume, centre)]."""
        corner = [self.chance.uniform(-5.0, 5.0) for _ in range(3)]
        size = [self.chance.uniform(1.0, 4.0) for _ in range(3)]
        factor = MILLIMETRES[unit]
        solid = self.solid(self.box([c / factor for c in corner], [s / factor for s in size]))
        return solid, [(math.prod(size), tuple(c + s / 2.0 for c, s in zip(corner, size)))]

    def add_part(self, name):
        unit, form = self.chance.choice(self.units), self.chance.choice(("plain", "two", "related", "related backwards", "two related", "moved"))
        unit_of_solids = self.chance.choice(self.units) if form == "moved" else unit
        origin, (solid, solids) = self.frame(IDENTITY, unit), self.add_box(unit_of_solids)
        items = [[solid]]
        if form.startswith("two"):
            other, others = self.add_box(unit)
            items, solids = [[solid, other]] if form == "two" else [[solid], [other]], solids + others
        if form in ("plain", "two"):
            shape = self.represent([origin, *items[0]], unit, SOLIDS)
        elif form == "moved":
            inner, outer = self.make_motion(), self.make_motion()
            frames = self.frame(inner, unit_of_solids), self.frame(outer, unit)
            shape = self.represent([origin, frames[1]], unit)
            self.relate(self.represent([solid, frames[0]], unit_of_solids, SOLIDS), shape, frames)
            solids = [(v, move(compose(outer, invert(inner)), c)) for v, c in solids]
        else:
            shape = self.represent([origin], unit)
            for some in items:
                pair = [shape, self.represent([*some, origin], unit, SOLIDS)]
                self.relate(*(pair[::-1] if form == "related backwards" else pair))
        return Product(self.product(name, shape), shape, unit, solids)

    def add_assembly(self, name, children):
        unit, items, solids, places = self.chance.choice(self.units), [], [], []
        for child in children:
            form = self.chance.choices(("occurrence", "occurrence backwards", "mapped", "mapped occurrence", "relationship"), (8, 4, 4, 2, 1))[0]
            form = "occurrence" if form.startswith("mapped") and child.unit != unit else form
            inner, outer = self.make_motion() if self.chance.random() < 0.3 else IDENTITY, self.make_motion()
            solids += [(v, move(compose(outer, invert(inner)), c)) for v, c in child.solids]
            frames = self.frame(inner, child.unit), self.frame(outer, unit)
            if form.startswith("mapped"):
                source = self.add(f"REPRESENTATION_MAP({frames[0]},{child.shape})")
                items.append(self.add(f"MAPPED_ITEM('',{source},{frames[1]})"))
            else:
                items.append(frames[1])
            places.append((child, form, frames))
        shape = self.represent([self.frame(IDENTITY, unit), *items], unit)
        definition = self.product(name, shape)
        for child, form, frames in places:
            occurrence = self.add(f"NEXT_ASSEMBLY_USAGE_OCCURRENCE('{len(self.lines)}','','',{definition},{child.definition},$)") if "occurrence" in form else None
            if form.startswith("mapped"):
                continue
            pair = (shape, child.shape, frames[::-1]) if form == "occurrence backwards" else (child.shape, shape, frames)
            relationship = self.relate(*pair)
            if occurrence:
                described = self.add(f"PRODUCT_DEFINITION_SHAPE({EMPTY},{EMPTY},{occurrence})")
                self.add(f"CONTEXT_DEPENDENT_SHAPE_REPRESENTATION({relationship},{described})")
        return Product(definition, shape, unit, solids)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for option in ("--program", "--output"):
        parser.add_argument(option, required=True)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--first", type=int, default=1, help="first seed")
    parser.add_argument("--verbose", action="store_true", help="print the reasons of files that are flagged")
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    expected = {}
    for seed in range(options.first, options.first + options.count):
        assembly = Assembly(seed)
        path = os.path.join(options.output, f"assembly_{seed}.step")
        with open(path, "w", encoding="ascii") as file:
            file.write(assembly.get_text())
        expected[path] = [solid for root in assembly.roots for solid in root.solids]
    out = subprocess.run([options.program, "--quiet", "--backend", "cpu", "--unit", "mm", "--json", "-", *expected], stdout=subprocess.PIPE,
                         stderr=subprocess.DEVNULL, check=False).stdout
    counts, reasons = collections.Counter(), collections.Counter()
    for entry in json.loads(out)["files"]:
        solids, total = expected[entry["file"]], entry["total"] or {}
        volume = sum(v for v, _ in solids)
        center = [sum(v * c[k] for v, c in solids) / volume for k in range(3)]
        value, middle = total.get("volume"), total.get("center_of_mass")
        is_same = value is not None and abs(value - volume) <= ACCURACY * volume and math.dist(middle, center) <= ACCURACY * EXTENT
        if entry["status"] == "ok" and is_same:
            os.remove(entry["file"])
        elif entry["status"] == "ok":
            print("FAIL", entry["file"], "volume", value, "for", volume, "centre", middle, "for", center, "solids", len(entry["solids"]), "for", len(solids),
                  entry["messages"])
        else:
            os.remove(entry["file"])
            reasons[" ".join(word for word in entry["messages"][0].split() if "#" not in word)] += 1
        counts["wrong" if entry["status"] == "ok" and not is_same else entry["status"]] += 1
    for reason, number in reasons.most_common() if options.verbose else ():
        print(number, reason)
    print(f"{len(expected)} assemblies: {dict(counts)}")
    return 1 if counts["wrong"] or 4 * counts["ok"] < len(expected) else 0


sys.exit(main())

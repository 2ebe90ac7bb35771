#!/usr/bin/env python3
"""Reads solids of SolveSpace, which has a kernel and a STEP writer of its own, and compares their volumes with closed forms.

Prisms and solids of revolution of random sketches, or unions and differences of prisms, are written as .slvs files and exported by
solvespace-cli, which writes an edge of its own for each face (Debian 12: solvespace). Exit status 1 if a solid is not ok, or its volume is not that of the
formula within bound, spread and the ten decimals of the file, or if a file that lacks faces is ok; 77 if no file was exported.

  SolveSpaceSolids.py --program solidmoments --solvespace solvespace-cli --output FOLDER --count 12
"""
import argparse
import json
import math
import os
import random
import re
import subprocess
import sys

# Of the coordinates, which have ten decimals and sizes of 5 to 40 mm.
DIGITS = 1e-10


class Sketches:
    """The text of a .slvs file: groups, requests and the values of their parameters."""

    def __init__(self):
        self.groups, self.values, self.requests = [], [], []
        self.last_group, self.last_request = 0, 0
        self.group(5000)
        for turn in ((1.0, 0.0, 0.0, 0.0), (0.5, 0.5, 0.5, 0.5), (0.5, -0.5, -0.5, -0.5)):
            number = self.request(1, None, 100, [])
            for k in range(3):
                self.value(number << 16 | 16 + k, 0.0)
            for k, component in enumerate(turn):
                self.value(number << 16 | 32 + k, component)

    def value(self, handle, number):
        self.values.append(f"Param.h.v.={handle:08x}\nParam.val={number:.20f}\nAddParam\n")

    def group(self, kind, **fields):
        self.last_group += 1
        lines = [f"Group.h.v={self.last_group:08x}", f"Group.type={kind}", f"Group.order={self.last_group - 1}", f"Group.name=g{self.last_group}",
                 *(f"Group.{name.replace('__', '.')}={text}" for name, text in fields.items()), "Group.visible=1", "Group.scale=1.0",
                 "Group.remap={", "}", "AddGroup"]
        self.groups.append("\n".join(lines) + "\n")
        return self.last_group

    def plane(self, turn):
        """A sketch in a plane through the origin, rotated by a unit quaternion: its group and its plane."""
        plane = f"{0x80000000 | self.last_group + 1 << 16:08x}"
        names = ("w", "vx", "vy", "vz")
        return self.group(5001, activeWorkplane__v=plane, subtype=6000, predef__origin__v="00010001",
                          **{f"predef__q__{name}": f"{q:.20f}" for name, q in zip(names, turn)}), plane

    def request(self, group, plane, kind, points, radius=None, helper=False):
        self.last_request += 1
        number = self.last_request
        where = f"Request.workplane.v={plane}\n" if plane else ""
        self.requests.append(f"Request.h.v={number:08x}\nRequest.type={kind}\n{where}Request.group.v={group:08x}\n"
                             f"Request.construction={int(helper)}\nAddRequest\n")
        for k, point in enumerate(points):
            for d in range(2):
                self.value(number << 16 | 16 + 3 * k + d, point[d])
        if radius is not None:
            self.value(number << 16 | 64, radius)
        return number

    def polygon(self, sketch, points):
        for start, end in zip(points, points[1:] + points[:1]):
            self.request(*sketch, 200, [start, end])

    def extrude(self, sketch, vector, combine=0):
        """`combine` with the solid so far: 0 is the union, 1 the difference."""
        group = self.group(5100, opA__v=f"{sketch[0]:08x}", subtype=7000, meshCombine=combine, predef__entityB__v=sketch[1])
        for d in range(3):
            # A prism on one side is as long as two of its steps.
            self.value(0x80000000 | group << 16 | d, 0.5 * vector[d])

    def turn(self, sketch, axis):
        self.group(5101, opA__v=f"{sketch[0]:08x}", meshCombine=0, predef__origin__v="00010001", predef__entityB__v=f"{axis << 16:08x}")

    def write(self, path):
        with open(path, "w", encoding="latin-1", newline="\n") as file:
            file.write("\xb1\xb2\xb3SolveSpaceREVa\n\n" + "\n".join(self.groups + self.values + self.requests))


def star(chance, center, radius):
    count = chance.randrange(3, 9)
    angles = [2.0 * math.pi * k / count for k in range(count)]
    return [(center + radius * r * math.cos(a), radius * r * math.sin(a)) for a, r in ((a, chance.uniform(0.7, 1.2)) for a in angles)]


def cross(points):
    return [(a[0] * b[1] - a[1] * b[0], a[0] + b[0]) for a, b in zip(points, points[1:] + points[:1])]


def make_turn(chance):
    """A random rotation: its unit quaternion, and the direction of the rotated z axis."""
    axis = [chance.gauss(0.0, 1.0) for _ in range(3)]
    angle = chance.uniform(0.0, 3.0)
    w, x, y, z = math.cos(angle / 2), *(a / math.hypot(*axis) * math.sin(angle / 2) for a in axis)
    return (w, x, y, z), (2.0 * (x * z + w * y), 2.0 * (y * z - w * x), w * w - x * x - y * y + z * z)


def add_prism(chance, file):
    """Adds a prism, and returns its volume."""
    turn, up = make_turn(chance)
    sketch = file.plane(turn)
    kind, radius, height = chance.randrange(4), chance.uniform(6.0, 15.0), chance.uniform(2.0, 40.0)
    if kind == 0:
        points = star(chance, 0.0, radius)
        file.polygon(sketch, points)
        area = sum(c for c, _ in cross(points)) / 2.0
    elif kind == 1:  # a slot
        half = radius / 2.0
        file.request(*sketch, 200, [(-radius, -half), (radius, -half)])
        file.request(*sketch, 500, [(radius, 0.0), (radius, -half), (radius, half)])
        file.request(*sketch, 200, [(radius, half), (-radius, half)])
        file.request(*sketch, 500, [(-radius, 0.0), (-radius, half), (-radius, -half)])
        area = 4.0 * radius * half + math.pi * half ** 2
    else:  # a disc, perhaps with a hole
        file.request(*sketch, 400, [(0.0, 0.0)], radius)
        area = math.pi * radius ** 2
        if kind == 3:
            file.request(*sketch, 400, [(radius / 4.0, 0.0)], radius / 3.0)
            area *= 1.0 - 1.0 / 9.0
    file.extrude(sketch, [height * c for c in up])
    return area * height


def measure_common(radius, center, corner, size):
    """Area that a disc on the lower side of a rectangle has in common with it; the disc meets no other side."""
    rise = center[1] - corner[1]
    assert abs(rise) < radius and corner[0] < center[0] - radius and center[0] + radius < corner[0] + size[0] and rise + radius < size[1]
    return radius ** 2 * (math.pi - math.acos(rise / radius)) + rise * math.sqrt(radius ** 2 - rise ** 2)


def add_combined(chance, file):
    """Adds a block, and one to three prisms on the same plane that are joined with it or cut from it; returns the volume.

    Faces of the result are parts of one plane or of two, and an edge of one face may lie on several edges of others.
    """
    turn, up = make_turn(chance)
    length, width, height = (chance.uniform(20.0, 40.0) for _ in range(3))

    def add(heights, is_cut, draw):
        sketch = file.plane(turn)
        draw(sketch)
        file.extrude(sketch, [heights * c for c in up], int(is_cut))

    def rectangle(low, high):
        return lambda sketch: file.polygon(sketch, [low, (high[0], low[1]), high, (low[0], high[1])])

    add(height, False, rectangle((0.0, 0.0), (length, width)))
    volume = length * width * height
    # Each prism is at another side: none meets another.
    for side in chance.sample(range(3), chance.randint(1, 3)):
        is_cut, rise = chance.random() < 0.5, chance.choice((1.0, chance.uniform(0.3, 0.9), chance.uniform(1.1, 1.4))) * height
        low_part = min(rise, height)
        if side == 2:  # a disc on the lower side
            radius, center = chance.uniform(2.0, 4.0), (0.5 * length + chance.uniform(-1.0, 1.0), chance.uniform(-1.5, 1.5))
            add(rise, is_cut, lambda sketch, c=center, r=radius: file.request(*sketch, 400, [c], r))
            area, common = math.pi * radius ** 2, measure_common(radius, center, (0.0, 0.0), (length, width))
        else:  # a rectangle over the left or the right side, or that touches it
            touches = chance.random() < 0.6
            is_cut = is_cut and not touches
            reach = 0.0 if touches else chance.uniform(1.0, 4.0)
            low, high = (side * length - (reach if side else 4.0), 0.4 * width), (side * length + (4.0 if side else reach), chance.choice((0.8, 1.0, 1.2)) * width)
            add(rise, is_cut, rectangle(low, high))
            area = (high[0] - low[0]) * (high[1] - low[1])
            common = reach * (min(high[1], width) - low[1])
        volume += -common * low_part if is_cut else area * rise - common * low_part
    return volume


def add_turned(chance, file):
    """Adds a solid of revolution about the y axis, and returns its volume."""
    sketch = file.plane((1.0, 0.0, 0.0, 0.0))
    axis = file.request(*sketch, 200, [(0.0, -30.0), (0.0, 30.0)], helper=True)
    kind, center = chance.randrange(3), chance.uniform(9.0, 20.0)
    if kind == 0:
        points = star(chance, center, 6.0)
        file.polygon(sketch, points)
        volume = 2.0 * math.pi * sum(c * s for c, s in cross(points)) / 6.0
    elif kind == 1:  # a ring
        file.request(*sketch, 400, [(center, 1.0)], 5.0)
        volume = 2.0 * math.pi * center * math.pi * 25.0
    else:  # a ball
        file.request(*sketch, 500, [(0.0, 0.0), (0.0, -center), (0.0, center)])
        file.request(*sketch, 200, [(0.0, center), (0.0, -center)])
        volume = 4.0 / 3.0 * math.pi * center ** 3
    file.turn(sketch, axis)
    return volume


def lacks_faces(path):
    """True if the edges of a file do not cancel: SolveSpace loses faces of some sketches.

    The sum of the cross products of the ends of all edges in the directions of their uses is 0 for faces that close.
    """
    with open(path, encoding="latin-1") as file:
        entities = dict(re.findall(r"#(\d+)=(.*?);\n", file.read(), re.DOTALL))

    def get_point(vertex):
        point, = re.findall(r"#(\d+)", entities[vertex])
        return [float(x) for x in re.search(r"\(([-+\d.,eE]+)\)", entities[point]).group(1).split(",")]

    total, size = [0.0, 0.0, 0.0], 0.0
    for text in entities.values():
        use = re.match(r"ORIENTED_EDGE\([^#]*#(\d+),\.(\w)\.", text)
        if use:
            a, b = (get_point(v) for v in re.findall(r"#(\d+)", entities[use.group(1)])[:2])
            sign = 1.0 if use.group(2) == "T" else -1.0
            total = [t + sign * (a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2]) for k, t in enumerate(total)]
            size = max(size, *map(abs, a), *map(abs, b))
    return max(map(abs, total)) > 1e-4 * size ** 2


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for option in ("--program", "--solvespace", "--output"):
        parser.add_argument(option, required=True)
    parser.add_argument("--count", type=int, default=12)
    parser.add_argument("--first", type=int, default=0, help="first seed")
    parser.add_argument("--combined", action="store_true", help="unions and differences of several prisms")
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    volumes = {}
    for seed in range(options.first, options.first + options.count):
        chance, file = random.Random(seed), Sketches()
        path = os.path.join(options.output, f"solvespace_{seed}")
        volume = (add_combined if options.combined else add_prism if seed % 2 else add_turned)(chance, file)
        file.write(path + ".slvs")
        # A file that it does not export is not what is tested.
        subprocess.run([options.solvespace, "export-surfaces", "--output", "%.step", f"solvespace_{seed}.slvs"], cwd=options.output, check=False,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=300)
        if os.path.exists(path + ".step"):
            volumes[path + ".step"] = volume
    if not volumes:
        print("solvespace-cli exported nothing")
        return 77
    out = subprocess.run([options.program, "--json", "-", *volumes], stdout=subprocess.PIPE, check=False).stdout
    failures, incomplete = 0, 0
    for entry in json.loads(out)["files"]:
        total, exact = entry["total"] or {}, volumes[entry["file"]]
        value = total.get("volume")
        limit = total["bounds"]["volume"] + total["closure_spread"]["volume"] + DIGITS * exact if entry["status"] == "ok" else 0.0
        is_incomplete = lacks_faces(entry["file"])
        is_right = entry["status"] != "ok" if is_incomplete else entry["status"] == "ok" and abs(value - exact) <= limit
        incomplete += is_incomplete
        failures += not is_right
        print("ok  " if is_right else "FAIL", entry["file"], entry["status"], value, "exact", exact, "limit", limit, *([] if is_right else entry["messages"]))
    print(f"{len(volumes)} solids, {incomplete} without all faces, {failures} failures")
    return 1 if failures else 0


sys.exit(main())

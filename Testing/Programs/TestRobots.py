"""TestRobots.py --program P --output DIR [--reader R] [--mujoco MODULE]: robots of a machine of boxes have the masses, centres and tensors of
formulas, and so they have in the readers that are there.

R prints what urdfdom, KDL and libsdformat take of a file (robot_readers.cxx), MODULE is the path of MuJoCo's mujoco.js of npm (@mujoco/mujoco).
"""
import argparse
import functools
import json
import os
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
import smprogram  # noqa: E402
from smcheck import check, check_equal, check_true, finish  # noqa: E402
from smproduct import Assembly, Part, expand, get_properties, write_product  # noqa: E402

parser = argparse.ArgumentParser()
for name in ("--program", "--output"):
    parser.add_argument(name, required=True)
for name in ("--reader", "--mujoco"):
    parser.add_argument(name)
options = parser.parse_args()
folder = os.path.join(options.output, "robots")
os.makedirs(folder, exist_ok=True)
run = functools.partial(smprogram.run, options.program)

KG, METRE = 1e-9, 1e-3
QUARTER = ((0, -1, 0), (1, 0, 0), (0, 0, 1))
IDENTITY = ([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.0, 0.0, 0.0])


def numbers(text):
    return [float(x) for x in text.split()]


def multiply(a, b):
    """The pose of b in the frame in which a is, when b is in the frame of a."""
    turn = [[sum(a[0][i][k] * b[0][k][j] for k in range(3)) for j in range(3)] for i in range(3)]
    return turn, [sum(a[0][i][k] * b[1][k] for k in range(3)) + a[1][i] for i in range(3)]


def from_quaternion(w, x, y, z):
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]


def from_angles(roll, pitch, yaw):
    from math import cos, sin

    x = [[1, 0, 0], [0, cos(roll), -sin(roll)], [0, sin(roll), cos(roll)]]
    y = [[cos(pitch), 0, sin(pitch)], [0, 1, 0], [-sin(pitch), 0, cos(pitch)]]
    z = [[cos(yaw), -sin(yaw), 0], [sin(yaw), cos(yaw), 0], [0, 0, 1]]
    none = [0.0] * 3
    return multiply(multiply((z, none), (y, none)), (x, none))[0]


def tensor(six):
    xx, xy, xz, yy, yz, zz = six
    return [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]


def read_urdf(root):
    links = {}
    joints = {joint.find("child").get("link"): joint for joint in root.findall("joint")}

    def get_pose(name):
        if name not in joints:
            return IDENTITY
        origin = joints[name].find("origin")
        own = from_angles(*numbers(origin.get("rpy"))), numbers(origin.get("xyz"))
        return multiply(get_pose(joints[name].find("parent").get("link")), own)

    for link in root.findall("link"):
        inertial = link.find("inertial")
        if inertial is not None:
            check_equal("rotation of the inertia", "0 0 0", inertial.find("origin").get("rpy"))
            six = [float(inertial.find("inertia").get(key)) for key in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")]
            links[link.get("name")] = (get_pose(link.get("name")), float(inertial.find("mass").get("value")),
                                       numbers(inertial.find("origin").get("xyz")), tensor(six), link.find("visual/geometry/mesh").get("filename"))
    return links


def read_sdf(root):
    links = {}
    for link in root.find("model").findall("link"):
        at = numbers(link.find("pose").text)
        inertial = link.find("inertial")
        six = [float(inertial.find("inertia/" + key).text) for key in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")]
        links[link.get("name")] = ((from_quaternion(at[6], *at[3:6]), at[:3]), float(inertial.find("mass").text),
                                   numbers(inertial.find("pose").text)[:3], tensor(six), link.find("visual/geometry/mesh/uri").text)
    return links


def read_mjcf(root):
    links = {}
    meshes = {mesh.get("name"): mesh.get("file") for mesh in root.find("asset").findall("mesh")}

    def add(body, above):
        pose = multiply(above, (from_quaternion(*numbers(body.get("quat"))), numbers(body.get("pos"))))
        inertial = body.find("inertial")
        xx, yy, zz, xy, xz, yz = numbers(inertial.get("fullinertia"))
        links[body.get("name")] = (pose, float(inertial.get("mass")), numbers(inertial.get("pos")), tensor([xx, xy, xz, yy, yz, zz]),
                                   meshes[body.find("geom").get("mesh")])
        for child in body.findall("body"):
            add(child, pose)
    for body in root.find("worldbody").findall("body"):
        add(body, IDENTITY)
    return links


READ = {"urdf": read_urdf, "sdf": read_sdf, "mjcf": read_mjcf}


def get_expected(groups):
    """Mass in kg, centre in m and tensor in kg m^2 about the centre with the axes of the world, of lists of boxes, by formulas."""
    found = []
    for boxes in groups:
        mass, center, get_inertia = get_properties(boxes, [b[1] for b in boxes])
        found.append((float(mass) * KG, [float(x) * METRE for x in center],
                      [[float(x) * KG * METRE ** 2 for x in row] for row in get_inertia(center)]))
    return found


def check_robot(what, links, groups):
    """The links are those bodies, in any order, and their meshes are where the bodies are."""
    left = get_expected(groups)
    check_equal(f"{what}: links", len(left), len(links))
    for name, (pose, mass, center, inertia, mesh) in links.items():
        at = multiply(pose, (IDENTITY[0], center))[1]
        expected = min(left, key=lambda body: sum((a - b) ** 2 for a, b in zip(at, body[1])), default=None)
        if expected is None:
            continue
        left.remove(expected)
        check(f"{what}: mass of {name}", expected[0], mass, 1e-13 * expected[0])
        size = max(abs(x) for row in expected[2] for x in row)
        turned = multiply((pose[0], [0.0] * 3), (inertia, [0.0] * 3))[0]
        back = [list(row) for row in zip(*pose[0])]
        turned = multiply((turned, [0.0] * 3), (back, [0.0] * 3))[0]
        for i in range(3):
            check(f"{what}: centre of {name}", expected[1][i], at[i], 1e-14, "rounding of metres")
            for k in range(3):
                check(f"{what}: tensor of {name}", expected[2][i][k], turned[i][k], 1e-12 * size, "rounding")
        with open(os.path.join(folder, mesh), encoding="ascii") as file:
            points = [multiply(pose, (IDENTITY[0], numbers(line[1:])))[1] for line in file if line.startswith("v ")]
        for i in range(3):
            middle = 0.5 * (min(p[i] for p in points) + max(p[i] for p in points))
            # The boxes of a link are symmetric only where it is one box.
            check_true(f"{what}: the mesh of {name}", len(groups) == 1 or abs(middle - at[i]) < 1e-12, f"{middle} {at[i]}")


def check_readers(what, path, kind, links):
    """All readers take every link with its mass, centre and tensor."""
    takers = {"urdf": ("urdfdom", "kdl", "sdformat"), "sdf": ("sdformat",), "mjcf": ()}[kind] if options.reader else ()
    commands = {taker: [options.reader, taker, path] for taker in takers}
    if options.mujoco and kind in ("urdf", "mjcf"):
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "read_mujoco.mjs")
        meshes = [os.path.join(folder, link[4]) for link in links.values()]
        meshes += [hull for hull in (mesh.replace(".obj", "-hull.obj") for mesh in meshes) if os.path.exists(hull)]
        commands["MuJoCo"] = ["node", script, options.mujoco, path] + meshes
    for taker, command in commands.items():
        result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, timeout=300, check=False)
        check_equal(f"{what}: exit status of {taker}", 0, result.returncode)
        if result.returncode != 0:
            check_true(f"{what}: {taker} reads it", False, result.stderr[-600:])
            continue
        found = {link["name"]: link for link in json.loads(result.stdout)["links"]}
        check_equal(f"{what}: links in {taker}", sorted(links), sorted(found))
        for name in set(links) & set(found):
            _, mass, center, inertia, _ = links[name]
            link = found[name]
            check(f"{what}: mass of {name} in {taker}", mass, link["mass"], 1e-14 * mass)
            size = max(abs(x) for row in inertia for x in row)
            for i in range(3):
                check(f"{what}: centre of {name} in {taker}", center[i], link["center"][i], 1e-14)
                for k in range(3):
                    # MuJoCo keeps principal moments and a quaternion, of an iteration.
                    check(f"{what}: tensor of {name} in {taker}", inertia[i][k], tensor(link["inertia"])[i][k], (1e-9 if taker == "MuJoCo" else 1e-13) * size)


def make_machine(plate_density="2700."):
    """Two stations with a plate and two bolts each, one of them lying, and a bent rail, whose products of inertia are not 0."""
    bolt = Part("bolt", [((1, 2, 3), (2, 2, 10))], "7.85", "g/cm^3")
    plate = Part("plate <1>", [((0, 0, 0), (2, 1, "0.25"))], plate_density, "kg/m^3", "inch")
    station = Assembly("station", [(plate, (0, 0, 0), None), (bolt, (5, 5, "6.35"), None), (bolt, (40, 5, "6.35"), QUARTER)])
    return Assembly("machine", [(station, (0, 0, 10), None), (station, (100, 0, 10), QUARTER)])


machine = make_machine()
boxes = expand(machine)
path = write_product(os.path.join(folder, "machine.step"), machine)
for kind in READ:
    target = os.path.join(folder, f"machine.{kind}" if kind != "mjcf" else "machine.xml")
    for unit in ("mm", "inch"):
        result = run("--unit", unit, "--robot", kind, target, "-q", path)
        check_equal(f"exit status of {kind}", 0, result.returncode)
        links = READ[kind](ElementTree.parse(target).getroot())
        check_robot(f"{kind} in {unit}", links, [[box] for box in boxes])
    check_equal("names", ["bolt", "bolt-2", "bolt-3", "bolt-4", "plate__1_", "plate__1_-2"], sorted(links))
    check_readers(kind, target, kind, links)
    # One link of everything, and one of each station.
    for name, groups in (("machine", [boxes]), ("station", [boxes[:3], boxes[3:]])):
        check_equal("exit status", 0, run("--fuse", name, "--robot", kind, target, "-q", path).returncode)
        links = READ[kind](ElementTree.parse(target).getroot())
        check_equal("names", sorted([name, f"{name}-2"][:len(groups)]), sorted(links))
        left = get_expected(groups)
        for link, expected in zip((links[key] for key in sorted(links)), left):
            check("fused: mass", expected[0], link[1], 1e-13 * expected[0])
            for i in range(3):
                check("fused: centre", expected[1][i], link[2][i], 1e-14, "the frame is that of the file")
                for k in range(3):
                    check("fused: tensor", expected[2][i][k], link[3][i][k], 1e-13 * expected[2][2][2])
            check_true("a product is not 0, so that its sign counts", max(map(abs, (expected[2][0][1], expected[2][0][2], expected[2][1][2]))) > 0.002 * expected[2][2][2],
                       str(expected[2]))
        check_readers(f"{kind} of {name}", target, kind, links)
# A joint: the frame of its child is at its origin, the axis in its frame.
joints = os.path.join(folder, "joints.csv")
with open(joints, "w", encoding="ascii") as file:
    file.write("parent,child,type\n# a hinge\nplate__1_,bolt-2,revolute,0,0,2,42,12,20\nbolt-2,bolt,prismatic,1,0,0\n")
for kind in READ:
    target = os.path.join(folder, f"jointed.{kind}" if kind != "mjcf" else "jointed.xml")
    check_equal("exit status with joints", 0, run("--joints", joints, "--robot", kind, target, "--collision", "hull", "-q", path).returncode)
    root = ElementTree.parse(target).getroot()
    links = READ[kind](root)
    check_robot(f"{kind} with joints", links, [[box] for box in boxes])
    for axis, at in zip(range(3), (0.042, 0.012, 0.020)):
        check("origin of the hinge", at, links["bolt-2"][0][1][axis], 1e-15)
    types = {"urdf": ("continuous", "prismatic"), "sdf": ("revolute", "prismatic"), "mjcf": ("hinge", "slide")}[kind]
    found = [joint.get("type") for joint in root.iter("joint") if joint.get("type") != "fixed"]
    check_equal("joints that move", sorted(types), sorted(found))
    check_true("a convex hull", os.path.getsize(os.path.join(folder, "jointed-bolt-hull.obj")) > 100)
    check_readers(f"{kind} with joints", target, kind, links)
# What readers leave out or refuse, and parts without a mass.
dust = write_product(os.path.join(folder, "dust.step"), Part("dust", [((0, 0, 0), ("0.001", "0.001", "0.001"))], "1000."))
result = run("--robot", "urdf", os.path.join(folder, "dust.urdf"), dust)
for said in ("libsdformat leaves out links below 1e-6 kg", "MuJoCo refuses moments below 1e-14"):
    check_true(f"a message: {said}", said in " ".join(result.stdout.split()), result.stdout)
partial = write_product(os.path.join(folder, "partial.step"), make_machine(plate_density=None))
target = os.path.join(folder, "partial.urdf")
result = run("--robot", "urdf", target, partial)
check_equal("exit status without a mass", 3, result.returncode)
check_true("the reason", "is left out: its mass or inertia is not known" in " ".join(result.stdout.split()), result.stdout)
check_equal("the others are there", 4, len(read_urdf(ElementTree.parse(target).getroot())))
check_equal("a part of it", 0, run("--robot", "urdf", target, "--only", "bolt", "-q", partial).returncode)
# Two files are two robots.
check_equal("two files", 0, run("--robot", "sdf", os.path.join(folder, "two.sdf"), "-q", path, dust).returncode)
check_true("have two names", all(os.path.exists(os.path.join(folder, name)) for name in ("two-machine.sdf", "two-dust.sdf")))
for table, said in (("bolt,rail,fixed\n", "there is no link rail"), ("a,b,loose\n", "there is no type loose"), ("a,b\n", "line 1"),
                    ("plate__1_,bolt,fixed\nbolt,plate__1_,fixed\n", "circle")):
    with open(joints, "w", encoding="ascii") as file:
        file.write(table)
    result = run("--joints", joints, "--robot", "urdf", target, path)
    check_true(f"joints {table!r}", result.returncode in (1, 3) and said in " ".join((result.stdout + result.stderr).split()), result.stdout + result.stderr)
for arguments, said in ((("--robot", "vrml", target, path), "urdf, sdf or mjcf"), (("--fuse", "x", path), "add --robot")):
    result = run(*arguments)
    check_true("wrong usage", result.returncode == 1 and said in result.stderr, result.stderr)
finish()

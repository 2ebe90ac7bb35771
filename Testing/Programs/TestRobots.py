"""TestRobots.py --program P --output DIR [--reader R] [--mujoco MODULE] [--urdf-loader MODULES]: robots of a machine of boxes have the masses, centres and tensors of
formulas, and so they have in the readers that are there.

R prints what urdfdom, KDL and libsdformat take of a file (robot_readers.cxx), MODULE is the path of MuJoCo's mujoco.js of npm (@mujoco/mujoco), MODULES a
node_modules folder with urdf-loader, three and jsdom.
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
for name in ("--reader", "--mujoco", "--urdf-loader"):
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
    if options.urdf_loader and kind == "urdf":
        commands["urdf-loader"] = ["node", os.path.join(os.path.dirname(os.path.abspath(__file__)), "read_urdf_loader.mjs"), options.urdf_loader, path]
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
check_equal("exit status without a mass", 1, result.returncode)
check_true("what is missing", "it is without 2 of its links" in result.stderr, result.stderr)
check_true("the reason", "is left out: its mass or inertia is not known" in " ".join(result.stdout.split()), result.stdout)
check_equal("the others are there", 4, len(read_urdf(ElementTree.parse(target).getroot())))
gone = os.path.join(folder, "gone.urdf")
result = run("--fail-on", "none", "--robot", "urdf", gone, "--only", "plate*", "--json", "-", partial)
check_equal("exit status without a robot", (1, False), (result.returncode, os.path.exists(gone)))
check_true("the reason is shown", f"robot {gone}: not written: no solid has a mass" in result.stderr, result.stderr)
entry = json.loads(result.stdout)["files"][0]
check_equal("the numbers are right all the same", "ok", entry["status"])
check_true("the reason is in the results", any("not written" in text for text in entry["messages"]), str(entry["messages"]))
check_equal("a part of it", 0, run("--robot", "urdf", target, "--only", "bolt", "-q", partial).returncode)
# Two files are two robots.
check_equal("two files", 0, run("--robot", "sdf", os.path.join(folder, "two.sdf"), "-q", path, dust).returncode)
check_true("have two names", all(os.path.exists(os.path.join(folder, name)) for name in ("two-machine.sdf", "two-dust.sdf")))
for table, said in (("bolt,rail,fixed\n", "there is no link rail"), ("a,b,loose\n", "there is no type loose"), ("a,b\n", "line 1"),
                    ("plate__1_,bolt,fixed\nbolt,plate__1_,fixed\n", "circle"), (",bolt,prismatic,1,0,0\n", "line 1: the parent is empty"),
                    ("\n# two\nbolt,,fixed\n", "line 3: the child is empty"), (",,\n", "line 1: the parent is empty"),
                    ("parent,bolt,fixed\n", "there is no link parent"), ("plate <1>,bolt,fixed\n", "several links are of the product plate <1>")):
    with open(joints, "w", encoding="ascii") as file:
        file.write(table)
    result = run("--joints", joints, "--robot", "urdf", target, path)
    check_true(f"joints {table!r}", result.returncode in (1, 3) and said in " ".join((result.stdout + result.stderr).split()), result.stdout + result.stderr)


def write_joints(text):
    with open(joints, "w", encoding="ascii") as file:
        file.write(text)
    return joints


def in_folder(name):
    return os.path.join(folder, name)


def read_robot(kind, *arguments, name="case", status=0):
    """Runs the program. Returns its result, the root element and the links of the robot."""
    target = in_folder(f"{name}.{kind}")
    result = run("--robot", kind, target, *arguments, errors="replace")
    check_equal("exit status", status, result.returncode)
    root = ElementTree.parse(target).getroot()
    return result, root, READ[kind](root)


def check_origin(what, expected, link):
    for i in range(3):
        check(f"{what}: axis {i}", expected[i], link[0][1][i], 1e-15)


# Every occurrence of a product has the hinge of its own line: 45,5,25 and 5,5,25 mm.
base, wheel = Part("base", [((0, 0, 0), (60, 10, 20))], "1000."), Part("wheel", [((0, 0, 0), (10, 10, 10))], "2000.")
car = Assembly("car", [(base, (0, 0, 0), None), (wheel, (0, 0, 20), None), (wheel, (40, 0, 20), None)])
car_path = write_product(in_folder("car.step"), car)
table = write_joints("base,wheel-2,revolute,0,1,0,45,5,25\nbase,wheel,revolute,0,1,0,5,5,25\n")
for kind in READ:
    result, _, links = read_robot(kind, "--joints", table, car_path)
    check_robot(f"two hinges in {kind}", links, [[box] for box in expand(car)])
    check_origin(f"hinge of wheel-2 in {kind}", (0.045, 0.005, 0.025), links["wheel-2"])
    check_origin(f"hinge of wheel in {kind}", (0.005, 0.005, 0.025), links["wheel"])
    check_true("the first one is named", "wheel is one link, the first of 2 of the product" in " ".join(result.stdout.split()), result.stdout)
# A joint of one occurrence leaves the other where it is.
_, _, links = read_robot("sdf", "--joints", write_joints("base,wheel-2,revolute,0,1,0,45,5,25\n"), car_path)
check_origin("the other wheel", (0.0, 0.0, 0.020), links["wheel"])
# A product may have the name of the heading of a column.
parents = write_product(in_folder("parents.step"), Assembly("top", [(Part("parent", [((0, 0, 0), (1, 2, 3))], "1."), (0, 0, 0), None),
                                                                   (Part("child", [((0, 0, 0), (1, 2, 3))], "1."), (9, 0, 0), None)]))
_, root, _ = read_robot("urdf", "--joints", write_joints("parent,child,type,x,y,z\nparent,child,prismatic,1,0,0\n"), parents)
check_equal("a product called parent", ["prismatic"], [joint.get("type") for joint in root.iter("joint") if joint.get("type") != "fixed"])
# Names of links, meshes and joints differ, whatever the products are called.
names = ("A", "A-hull", "A_hull", "A_joint", "a", "A_JOINT")
twins = write_product(in_folder("twins.step"), Assembly("twins", [(Part(name, [((0, 0, 0), (1, 2, 3 + i))], "1000."), (10 * i, 0, 0), None)
                                                                 for i, name in enumerate(names)]))
for kind in READ:
    _, root, links = read_robot(kind, "--collision", "hull", twins, name="twins")
    check_equal("links", 6, len(links))
    meshes = [element.get("filename") or element.get("file") or element.findtext("uri") for element in root.iter("mesh")]
    meshes = [mesh for mesh in meshes if mesh]
    check_equal(f"{kind}: meshes", (12, 12), (len(meshes), len({mesh.lower() for mesh in meshes})))
    called = [element.get("name") for element in root.iter() if element.tag in ("link", "joint", "body")]
    check_equal(f"{kind}: names", len(called), len(set(called)))
    if kind == "mjcf":
        called = [mesh.get("name") for mesh in root.find("asset").findall("mesh")]
        check_equal("names of meshes", (12, 12), (len(called), len(set(called))))
    for name, (pose, _, center, _, mesh) in links.items():
        with open(in_folder(mesh), encoding="ascii") as file:
            heights = [float(line.split()[3]) for line in file if line.startswith("v ")]
        check(f"{kind}: the mesh of {name}", 2.0 * center[2], max(heights) - min(heights), 1e-15)
# A long name is cut, and so are those that would be equal then.
long = write_product(in_folder("long.step"), Assembly("long", [(Part("x" * 300 + end, [((0, 0, 0), (1, 2, 3))], "1000."), (9 * i, 0, 0), None) for i, end in enumerate("ab")]))
_, _, links = read_robot("sdf", long, name="long")
check_equal("long names", ["x" * 100, "x" * 100 + "-2"], sorted(links))
# A mesh replaces no other file of the run.
result = run("--mesh", in_folder("robot-wheel.obj"), "--robot", "urdf", in_folder("robot.urdf"), car_path)
check_true("a mesh that is an output", result.returncode == 1 and "robot-wheel.obj is another file of this run" in result.stderr, result.stderr)
check_true("is not replaced", os.path.getsize(in_folder("robot-wheel.obj")) > 100 and not os.path.exists(in_folder("robot.urdf")))
first = write_product(in_folder("a.step"), Part("b-X", [((0, 0, 0), (1, 1, 1))], "1000."))
second = write_product(in_folder("a-b.step"), Part("X", [((0, 0, 0), (2, 2, 2))], "1000."))
result = run("--robot", "urdf", in_folder("r.urdf"), first, second)
check_true("a mesh of two robots", result.returncode == 1 and "r-a-b-X.obj could be a mesh of the robot" in result.stderr, result.stderr)
check_equal("neither is written", [False, False], [os.path.exists(in_folder(name)) for name in ("r-a.urdf", "r-a-b.urdf")])
# Any name of a file gives XML, with the meshes at their places.
for name in ("a&b", 'quote"', "less<", "tab\tline\n", "umlaut\u00e4", os.fsdecode(b"latin\xe4")):
    for kind in READ:
        _, _, links = read_robot(kind, "-q", car_path, name=name)
        check_robot(ascii(name), links, [[box] for box in expand(car)])
# A fused link has the frame of --about, and a name.
one = write_product(in_folder("one.step"), Part("cube", [((1, 2, 3), (4, 4, 4))], "1000."))
_, _, links = read_robot("sdf", "--fuse", "cube", "--about", "0,0,7", one)
check_origin("a fused product", (0.0, 0.0, 0.007), links["cube"])
check_robot("a fused product", links, [[box] for box in expand(Part("cube", [((1, 2, 3), (4, 4, 4))], "1000."))])
result, _, _ = read_robot("sdf", "--about", "0,0,7", one)
check_true("a frame of no link", "no link has the frame of --about" in " ".join(result.stdout.split()), result.stdout)
_, _, links = read_robot("sdf", "--fuse", "*", car_path)
check_equal("everything is one link", 1, len(links))
check_true("with a name", "link_" not in links, str(list(links)))
result = run("--urdf", in_folder("old.urdf"), one)
check_true("an option that is gone", result.returncode == 1 and "--urdf is gone: write --robot urdf FILE, and --fuse '*' for one link" in result.stderr, result.stderr)
for arguments, said in ((("--robot", "vrml", target, path), "urdf, sdf or mjcf"), (("--fuse", "x", path), "add --robot")):
    result = run(*arguments)
    check_true("wrong usage", result.returncode == 1 and said in result.stderr, result.stderr)
finish()

"""RobotRoots.py [--reader R] [--mujoco MODULE] [--urdf-loader MODULES] [--output FOLDER]: the table of Documentation/Products.md, which masses readers
take of URDF files of one or two links, by root and joint.

R is robot_readers of the build, MODULE mujoco.js of npm's @mujoco/mujoco, MODULES a node_modules folder with urdf-loader, three and jsdom. Link `a` has 2 kg,
`b` 3 kg and hangs at the root. A cell lists the links with their kg as read, or the exit status of a reader that refuses the file; 3 is libsdformat's with errors.
"""
import argparse
import json
import os
import subprocess

HERE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Programs")
LINK = '<link name="{name}"><inertial><origin xyz="0 0 0" rpy="0 0 0"/><mass value="{mass}"/>' \
       '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>'
LIMITS = '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/>'
JOINTS = ("fixed", "revolute", "continuous", "prismatic", "floating", "planar")


def make_joint(parent, child, kind):
    more = LIMITS if kind in ("revolute", "prismatic") else '<axis xyz="0 0 1"/>' if kind in ("continuous", "planar") else ""
    return f'<joint name="{parent}_{child}" type="{kind}"><parent link="{parent}"/><child link="{child}"/><origin xyz="0 0 0" rpy="0 0 0"/>{more}</joint>'


def list_cases():
    """(what, XML of the robot without its root element) of each row."""
    a, b = LINK.format(name="a", mass=2), LINK.format(name="b", mass=3)
    yield "two roots", a + b
    yield "a alone", a
    for kind in JOINTS:
        yield f"a, {kind}", a + b + make_joint("a", "b", kind)
    for root in ("base_link", "world"):
        for kind in JOINTS:
            yield f"empty {root}, {kind}", f'<link name="{root}"/>' + b + make_joint(root, "b", kind)


def read(command):
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, universal_newlines=True, timeout=120, check=False)
    lines = result.stdout[result.stdout.find("{"):]
    try:
        links = {link["name"]: link["mass"] for link in json.loads(lines)["links"] if link["mass"] > 0.0} if "{" in result.stdout else None
    except ValueError:
        links = None
    text = "no result" if links is None else " ".join(f"{name} {mass:g}" for name, mass in sorted(links.items())) or "none"
    return text if result.returncode == 0 else f"{text} (status {result.returncode})"


def main():
    parser = argparse.ArgumentParser()
    for name in ("--reader", "--mujoco", "--urdf-loader"):
        parser.add_argument(name)
    parser.add_argument("--output", default="/tmp")
    options = parser.parse_args()
    path = os.path.join(options.output, "roots.urdf")
    readers = {}
    if options.reader:
        readers.update({name: [options.reader, name, path] for name in ("urdfdom", "kdl", "sdformat")})
    if options.mujoco:
        readers["MuJoCo"] = ["node", os.path.join(HERE, "read_mujoco.mjs"), options.mujoco, path]
    if options.urdf_loader:
        readers["urdf-loader"] = ["node", os.path.join(HERE, "read_urdf_loader.mjs"), options.urdf_loader, path]
    print("| root, joint | " + " | ".join(readers) + " |\n|" + "---|" * (len(readers) + 1))
    for what, body in list_cases():
        with open(path, "w", encoding="ascii") as file:
            file.write(f'<?xml version="1.0"?>\n<robot name="roots">{body}</robot>\n')
        # KDL's parser is not given what urdfdom refuses.
        print(f"| {what} | " + " | ".join("-" if (what, name) == ("two roots", "kdl") else read(command) for name, command in readers.items()) + " |", flush=True)


if __name__ == "__main__":
    main()

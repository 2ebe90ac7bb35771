"""TestCommandLineErrors.py errors|outputs --program P --solids DIR --output DIR --sample FILE: wrong input, and what is left of a run."""
import collections
import json
import math
import os
import re
import shutil
import signal
import struct
import subprocess
import sys
import urllib.parse

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check, check_equal, check_true, finish  # noqa: E402
from smcommandline import check_unreadable, make_folder, manifest, options, run, run_json  # noqa: E402


def check_inputs_that_are_no_files():
    """Reading a pipe or a device may never end: each is refused at once."""
    pipe = os.path.join(make_folder("special"), "pipe.step")
    os.mkfifo(pipe)
    for path, said in ((pipe, "it is not a regular file; "), ("/dev/zero", "it is not a regular file; "),
                       (make_folder("no-steps"), "it is a folder without STEP or BREP files; name a file")):
        result, files = run_json(path)
        check_equal(f"exit status of {path}", 2, result.returncode)
        check_unreadable(files[0])
        check_true("it says what is wrong", said in files[0]["messages"][0], str(files[0]["messages"]))


def check_quiet_reason(good):
    """Checks, without a display, that --quiet prints no more than the reason of a failure."""
    result = run("-q", "--backend", "x", good)
    check_equal("exit status without a display", 3, result.returncode)
    check_equal("nothing on standard output", "", result.stdout)
    check_true("the reason is reported", "nothing was computed" in result.stderr and "display" in result.stderr, result.stderr)
    for wanted, said in ((("--tolerance", "1e-300"), "is tolerance-not-met: .*bounds above the tolerance.*"), (("--require", "mass"), "has no mass$"),
                         (("--require", "mass", "--tolerance", "1e-300"), "has no mass, and is tolerance-not-met: .*")):
        result = run("-q", "--backend", "cpu", *wanted, good)
        check_equal(f"exit status with {wanted}", 3, result.returncode)
        check_equal("nothing on standard output", "", result.stdout)
        check_true("one line reports what fails", re.fullmatch(f"solidmoments: {re.escape(good)} {said}", result.stderr.rstrip("\n")) is not None,
                   result.stderr)
        result = run("--backend", "cpu", *wanted, good)
        check_equal("a table has it, and nothing is reported twice", (3, ""), (result.returncode, result.stderr))
    result = run("-q", "--backend", "cpu", "--tolerance", "1e-300", "--fail-on", "suspect", good)
    check_equal("what does not fail is not reported", (0, ""), (result.returncode, result.stderr))


def check_name_that_is_not_utf8(good):
    folder = make_folder("not-utf8")
    path = os.path.join(folder, os.fsdecode(b"b\xff.step"))
    shutil.copy(good, path)
    target = os.path.join(folder, "out.json")
    result = run("--json", target, "--png", os.path.join(folder, "out.png"), path)
    check_equal("exit status of a name that is not UTF-8", 0, result.returncode)
    check_true("the table has the name as it is", result.stdout.startswith(path), ascii(result.stdout[:200]))
    check_true("the picture exists", os.path.exists(os.path.join(folder, "out.png")), ascii(result.stderr))
    with open(target, encoding="utf-8") as file:
        document = json.load(file)["files"][0]
    check_equal("name in JSON", "b\ufffd.step", os.path.basename(document["file"]))
    check_equal("bytes of the name", os.fsencode(path), urllib.parse.unquote_to_bytes(document["file_bytes"] or ""))
    check_equal("status", "ok", document["status"])
    missing = os.path.join(folder, os.fsdecode(b"\xfe 100%.step"))
    document = run_json(missing)[1][0]
    check_equal("bytes of a missing name", os.fsencode(missing), urllib.parse.unquote_to_bytes(document["file_bytes"] or ""))


def check_facts_once():
    """An assembly of 500 instances whose one part has a loop that does not close."""
    path = os.path.join(make_folder("facts"), "damaged.step")
    with open(manifest.special("assembly")["path"], encoding="ascii") as file:
        text = file.read()
    with open(path, "w", encoding="ascii") as file:
        file.write(re.sub(r"(= EDGE_LOOP\('',\()#\d+,(#\d+)", r"\1\2,\2", text, count=1))
    _, files = run_json(path)
    messages = files[0]["messages"]
    facts = [re.sub(r"^.*?[Ff]ace #", "face #", message.split(": ", 1)[-1]) for message in messages]
    check_true("there is something to report", len(facts) > 1, str(messages))
    check_equal("facts reported twice", [], sorted(fact for fact in set(facts) if facts.count(fact) > 1))
    check_true("the body's name is not said for every instance", len(messages) < 10, f"{len(messages)} messages")
    check_equal("messages on the loop", 1, sum("does not close" in message for message in messages))


def check_termination(good):
    """SIGTERM ends the run like Ctrl-C: what was finished is written."""
    target = os.path.join(make_folder("termination"), "out.json")
    count = 300
    with subprocess.Popen([options.program, "--json", target, *[good] * count], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE) as process:
        process.stdout.readline()  # the first file's table
        process.send_signal(signal.SIGTERM)
        _, complaint = process.communicate(timeout=100)
    check_equal("ended by", -signal.SIGTERM, process.returncode)
    check_true("it says so", b"interrupted" in complaint, str(complaint))
    check_true("the output is there", os.path.exists(target))
    if os.path.exists(target):
        with open(target, encoding="utf-8") as file:
            finished = len(json.load(file)["files"])
        check_true("it holds the finished files", 1 <= finished < count, str(finished))


def find_children(parent):
    """The processes that a process started and that are no more than forks of it."""
    found = []
    for name in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{name}/stat", encoding="utf-8", errors="replace") as file:
                after = file.read().rpartition(")")[2].split()
        except OSError:
            continue
        if int(after[1]) == parent and after[0] != "Z":
            found.append(int(name))
    return found


def check_shared_process(good):
    """Small files share a process: their results are those of a process each, and its end costs one file."""
    names = [good, manifest.solid("torus")["path"], manifest.special("open_solid")["path"], good, manifest.special("not_step")["path"], good]
    _, together = run_json(*names)
    for name, file in zip(names, together):
        alone = run_json(name)[1][0]
        for key in ("status", "messages", "total", "solids", "evaluations"):
            check_equal(f"{key} of {name} among others", alone[key], file[key])

    target = os.path.join(make_folder("killed"), "out.json")
    count = 200

    def check_killed(what, process, children):
        """Kills children of a run and returns the files that have no results."""
        for child in children:
            os.kill(child, signal.SIGKILL)
        process.communicate(timeout=100)
        with open(target, encoding="utf-8") as file:
            files = json.load(file)["files"]
        check_equal(f"files of a run whose process was killed {what}", count, len(files))
        return [file for file in files if file["status"] != "ok"]

    with subprocess.Popen([options.program, "-q", "--json", target, *[good] * count], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as process:
        children = []
        while not children and process.poll() is None:
            children = find_children(process.pid)
        others = check_killed("at once", process, children)
    check_true("files that killed processes cost", len(others) <= len(children), str(others))
    for file in others:
        check_true("the reason is reported", "ended by signal 9" in file["messages"][0], str(file["messages"]))
    # A process may have the damage of files before: the next one gets a process of its own.
    with subprocess.Popen([options.program, "-j", "1", "--json", target, *[good] * count], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as process:
        process.stdout.readline()
        others = check_killed("after a file", process, find_children(process.pid))
    check_equal("a file that is not the first one of its process is repeated", [], others)


def read_bytes(path):
    with open(path, "rb") as file:
        return file.read()


def check_refused(what, folder, *arguments):
    """Exit 1 with a sentence, and every file of the folder as it was."""
    before = {name: read_bytes(os.path.join(folder, name)) for name in os.listdir(folder)}
    result = run(*arguments, cwd=folder)
    check_equal(f"exit status of {what}", 1, result.returncode)
    check_true("it says why", result.stderr.startswith("solidmoments: ") and len(result.stderr) > 30, result.stderr)
    check_equal("nothing was computed", "", result.stdout)
    check_true("no file changed", before == {name: read_bytes(os.path.join(folder, name))
                                             for name in os.listdir(folder)})


def check_closed(triangles):
    """Every side is there in both directions; the volume inside."""
    volume, sides = 0.0, collections.Counter()
    for a, b, c in triangles:
        volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                   + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6.0
        for start, end in ((a, b), (b, c), (c, a)):
            sides[start, end] += 1
            sides[end, start] -= 1
    check_true("closed", volume > 0.0 and not any(sides.values()), str(sum(map(abs, sides.values()))))
    return volume


def outputs():
    good = manifest.solid("box")["path"]
    folder = make_folder("outputs")
    for name in ("a.step", "b.stp", "part", "out-a.png"):
        shutil.copy(good, os.path.join(folder, name))
    os.symlink("a.step", os.path.join(folder, "link.json"))
    os.link(os.path.join(folder, "a.step"), os.path.join(folder, "hard.png"))
    for flag in ("--json", "--csv"):
        check_refused("an input as output", folder, "a.step", flag, "./a.step")
        check_refused("a STEP file as output", folder, flag, "b.stp", "a.step")
        check_refused("a STEP file without extension as output", folder, "a.step", flag, "part")
        check_refused("a link to the input as output", folder, "a.step", flag, "link.json")
        check_refused("an empty name as output", folder, "a.step", flag, "")
    check_refused("another name of the input as picture", folder, "a.step", "--png", "hard.png")
    check_refused("an input as a derived picture", folder, "a.step", "out-a.png", "--png", "out.png")
    check_refused("one file for two outputs", folder, "a.step", "--json", "x.txt", "--csv", "./x.txt")
    check_refused("a picture in another format", folder, "a.step", "--png", "x.jpg")
    check_refused("triangles in another format", folder, "a.step", "--mesh", "x.png")
    check_refused("an empty name", folder, "")

    # An option in the place of a file name.
    for option in ("--json", "--csv", "--png", "--trim-textures"):
        other = "--csv" if option == "--json" else "--json"
        before = sorted(os.listdir(folder))
        result = run("--scheme", "gauss2", option, other, "a.step", cwd=folder)
        check_equal(f"exit status of {option} {other}", 1, result.returncode)
        check_true("it says why", "a file name is missing" in result.stderr and other in result.stderr, result.stderr)
        check_equal("no file was written", before, sorted(os.listdir(folder)))

    # Stems a, a, a-2: three pictures.
    for name in ("one", "two"):
        os.mkdir(os.path.join(folder, name))
    paths = [os.path.join(folder, "a.step"), os.path.join(folder, "one", "a.step"),
             os.path.join(folder, "two", "a-2.step")]
    for path in paths[1:]:
        shutil.copy(good, path)
    result = run("-q", "--png", os.path.join(folder, "view.png"), *paths)
    check_equal("exit status of three pictures", 0, result.returncode)
    check_equal("pictures", 3, sum(name.startswith("view") for name in os.listdir(folder)))

    # Triangles: closed, and within the deflection that was asked for.
    ball = manifest.solid("sphere")
    volumes = {}
    for deflection in ("1", "0.1"):
        target = os.path.join(folder, f"ball-{deflection}.stl")
        result = run("-q", "--mesh", target, "--deflection", deflection, ball["path"])
        check_equal("exit status with triangles", 0, result.returncode)
        with open(target, "rb") as file:
            header, count = file.read(80), struct.unpack("<I", file.read(4))[0]
            corners = [struct.unpack("<12fH", file.read(50))[3:12] for _ in range(count)]
        check_true("the unit", b"lengths in mm" in header, header)
        volume = volumes[deflection] = check_closed((corner[0:3], corner[3:6], corner[6:9]) for corner in corners)
        error = abs(volume / ball["volume"] - 1.0)
        check_true(f"volume with a deflection of {deflection}", error < 3.5 * float(deflection) / 10.0, str(error))
    check_true("finer triangles are nearer", volumes["1"] < volumes["0.1"] < ball["volume"], str(volumes))
    # A deflection that no mesh keeps: 1e-5 of the diagonal is the smallest.
    for deflection, is_kept in (("0.01", True), ("1e-4", False)):
        _, files = run_json("--mesh", os.path.join(folder, "fine.obj"), "--deflection", deflection, ball["path"])
        said = [message for message in files[0]["messages"] if re.search(r"as fine as it can be, .* up to 0\.000346 mm", message)]
        check_equal(f"a deflection of {deflection}: messages that it is not kept", 0 if is_kept else 1, len(said))
    for name in ("ball.obj", "ball.ply", "ball.vtp"):
        target = os.path.join(folder, name)
        check_equal(f"exit status with {name}", 0, run("-q", "--mesh", target, ball["path"]).returncode)
        check_true(name, os.path.getsize(target) > 1000)

    # At 1e7 single precision would move points by 0.5 and more: an origin is subtracted and stated.
    far = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Certified", "solids", "box_far_1e7.step")
    target = os.path.join(folder, "far.stl")
    result, files = run_json("--tolerance", "1e-6", far, "--mesh", target)
    check_equal("exit status far away", 0, result.returncode)
    with open(target, "rb") as file:
        header, count = file.read(80), struct.unpack("<I", file.read(4))[0]
        corners = [struct.unpack("<12fH", file.read(50))[3:12] for _ in range(count)]
    stated = re.search(rb"lengths in mm, add (\S+) (\S+) ([^\s\0]+)", header)
    check_true("the header states an origin", stated, header)
    origin = [float(number) for number in stated.groups()] if stated else [0.0] * 3
    check("far away: volume", 30.0, check_closed((corner[0:3], corner[3:6], corner[6:9]) for corner in corners), 30 * 3e-7,
          "corners are single precision, relative to a point nearby")
    sides = [[corner[i + axis] for corner in corners for i in (0, 3, 6)] for axis in range(3)]
    for axis, center in enumerate(files[0]["total"]["center_of_mass"]):
        check(f"far away: middle {axis}", center, origin[axis] + 0.5 * (min(sides[axis]) + max(sides[axis])), 3e-7, "single precision of 5")
    check_true("a message states it", any("far.stl: its points are relative to (10000014.0, -10000061.0, 10000028.0) mm" in message for message in files[0]["messages"]),
               str(files[0]["messages"]))
    target = os.path.join(folder, "far.ply")
    run("-q", "--tolerance", "1e-6", "--mesh", target, far)
    with open(target, "rb") as file:
        check_true("a comment of .ply states it", b"comment add to all points: 10000014.0 -10000061.0 10000028.0" in file.read(400))
    result, files = run_json("--tolerance", "1e-6", far, "--mesh", os.path.join(folder, "far.obj"))
    check_true("doubles have nothing to state", not any("relative to" in message for message in files[0]["messages"]), str(files[0]["messages"]))

    # Binary glTF: metres, y upwards, normals, closed by coordinates.
    target = os.path.join(folder, "ball.glb")
    check_equal("exit status with ball.glb", 0, run("-q", "--mesh", target, ball["path"]).returncode)
    with open(target, "rb") as file:
        content = file.read()
    magic, version, length, size, kind = struct.unpack_from("<4sIII4s", content)
    check_equal("header of a glb file", (b"glTF", 2, len(content), b"JSON"), (magic, version, length, kind))
    scene = json.loads(content[20:20 + size])
    check_equal("second chunk", b"BIN\0", content[24 + size:28 + size])

    def read_accessor(index, code, width):
        accessor = scene["accessors"][index]
        start = 28 + size + scene["bufferViews"][accessor["bufferView"]]["byteOffset"]
        return list(struct.iter_unpack(f"<{width}{code}", content[start:start + 4 * width * accessor["count"]]))

    root, node = scene["nodes"]
    primitive = scene["meshes"][node["mesh"]]["primitives"][0]
    points = read_accessor(primitive["attributes"]["POSITION"], "f", 3)
    normals = read_accessor(primitive["attributes"]["NORMAL"], "f", 3)
    corners = [index for (index,) in read_accessor(primitive["indices"], "I", 1)]
    volume = check_closed([points[corner] for corner in corners[first:first + 3]] for first in range(0, len(corners), 3))
    check_equal("scale from mm to metres", [0.001] * 3, root["scale"])
    check_true("volume of the ball", abs(volume / ball["volume"] - 1.0) < 0.01, str(volume))
    x, y, z, w = root["rotation"]
    check_true("z becomes y", abs(2.0 * (y * z - x * w) - 1.0) < 1e-12 and y == z == 0.0, str(root["rotation"]))
    radius = (3.0 * ball["volume"] / 4.0 / math.pi) ** (1.0 / 3.0)
    # The ball's box, and so the centre of its node, is known to the deflection.
    worst = max(abs(p[k] / radius - n[k]) for p, n in zip(points, normals) for k in range(3))
    check_true("normals of a ball", worst < 0.01, str(worst))

    # A table that goes nowhere.
    with open("/dev/full", "w", encoding="utf-8") as full:
        result = run(good, stdout=full)
    check_equal("exit status of a table on a full device", 1, result.returncode)
    check_true("it says so", "standard output" in result.stderr, result.stderr)
    result = subprocess.run(["sh", "-c", '"$0" "$1" >&-', options.program, good], stderr=subprocess.PIPE,
                            universal_newlines=True, timeout=100, check=False)
    check_equal("exit status of a table on a closed stream", 1, result.returncode)
    check_true("it says so", "standard output" in result.stderr, result.stderr)

    # Bounds are shown with two digits, and never below what they bound and its rounding, a twentieth; units
    # in any case.
    target = os.path.join(folder, "bounds.json")
    result = run("--unit", "INCH", "--json", target, manifest.solid("slanted_hole", "moved")["path"])
    check_equal("exit status with INCH", 0, result.returncode)
    with open(target, encoding="utf-8") as file:
        document = json.load(file)["files"][0]
    check_equal("unit", "inch", document["length_unit"])
    bounds = document["total"]["bounds"]
    shown = [float(text) for text in re.findall(r"\+/- (\S+)", result.stdout)]
    keys = ("volume", "area", "center_of_mass", "inertia", "inertia", "radii_of_gyration")
    check_equal("bounds in the table", len(keys), len(shown))
    for key, number in zip(keys, shown):
        check_true(f"bound of {key}", 1.05 * bounds[key] <= number <= 1.16 * bounds[key], f"{bounds[key]} shown as {number}")


def errors():
    good = manifest.solid("box")["path"]
    for name in ("empty", "not_step"):
        result, files = run_json(manifest.special(name)["path"])
        check_equal(f"exit status of {name}", 2, result.returncode)
        check_unreadable(files[0])
    missing = os.path.join(options.solids, "there_is_no_such_file.step")
    for path in (missing, make_folder("empty-folder")):
        result, files = run_json(path)
        check_equal("exit status", 2, result.returncode)
        check_unreadable(files[0])
    for name in ("no_geometry", "points_only"):
        result, files = run_json(manifest.special(name)["path"])
        check_equal(f"exit status of {name}", 3, result.returncode)
        check_equal("status", "empty", files[0]["status"])
        check_true("no volume", files[0]["total"]["volume"] is None)
        check_true("a message", files[0]["messages"])
    for name in ("open_shell", "open_solid"):
        result, files = run_json(manifest.special(name)["path"])
        check_equal(f"exit status of {name}", 3, result.returncode)
        check_equal("status", "open", files[0]["status"])
        check("area", 2000.0, files[0]["total"]["area"], 2e-6)
    result, files = run_json(manifest.special("truncated")["path"])
    check_equal("exit status of a truncated file", 3, result.returncode)
    check_equal("status", "open", files[0]["status"])
    check_true("no volume", files[0]["total"]["volume"] is None)
    check_true("a message says what may be missing", "part of it may be missing" in files[0]["messages"][0], str(files[0]["messages"]))
    result, files = run_json(manifest.special("junk_header")["path"])
    check_equal("exit status of junk before the header", 0, result.returncode)
    check_true("a message reports the junk", files[0]["messages"], str(files[0]["messages"]))

    # One bad file does not cost the others, and 2 wins over 3.
    result, files = run_json(missing, good, manifest.special("open_solid")["path"])
    check_equal("exit status of a mixture", 2, result.returncode)
    check_equal("statuses", ["unreadable", "ok", "open"], [file["status"] for file in files])
    result = run(missing)
    check_true("the message goes to people, too", "there_is_no_such_file" in result.stdout + result.stderr, result.stderr)

    check_inputs_that_are_no_files()
    check_quiet_reason(good)
    check_name_that_is_not_utf8(good)
    check_facts_once()
    check_termination(good)
    check_shared_process(good)

    # Wrong usage.
    for arguments in ([], ["--no-such-option", good], ["--tolerance-of", "volume=1e-6"], ["--tolerance-of", good],
                      ["--tolerance", "none", good], ["--unit", "cubit", good],
                      ["--density", "-1", good], ["--json", "/nonexistent/folder/x.json", good],
                      ["--backend", "abacus", good], ["--scheme", "guess", good]):
        result = run(*arguments)
        check_equal("exit status of wrong usage", 1, result.returncode)
        check_true("it says why", len(result.stderr + result.stdout) > 20)

    # An option takes one value, and files after it are files.
    other = manifest.solid("torus")["path"]
    one = ("--tolerance-of", "volume=1e-6")
    for arguments in ((*one, good, other), (good, *one, other), (good, "--tolerance-of", "area=1e-8", other, *one)):
        result, files = run_json(*arguments)
        check_equal("exit status of files after an option", 0, result.returncode)
        check_equal("the files", [good, other], [file["file"] for file in files])

    # A folder that cannot be written (root may write anywhere, so a folder that is not there stands in for
    # it).
    folder = os.path.join(options.output, "read-only")
    os.makedirs(folder, exist_ok=True)
    os.chmod(folder, 0o555)
    if os.access(folder, os.W_OK):
        folder = os.path.join("/proc", "solidmoments")
    for flag, name in (("--json", "x.json"), ("--csv", "x.csv"), ("--png", "x.png")):
        target = os.path.join(folder, name)
        result = run(flag, target, good)
        check_equal(f"exit status of {flag} into a read-only folder", 1, result.returncode)
        check_true("the message names the file", target in result.stderr, result.stderr)
    # Reading needs no permission to write where the program runs.
    result = run("--json", "-", good, cwd="/proc")
    check_equal("exit status in a read-only working directory", 0, result.returncode)


{"errors": errors, "outputs": outputs}[options.mode]()
finish()

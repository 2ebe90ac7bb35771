"""TestEditProgram.py --program P --events FILE --solids DIR --output DIR [--display]: edit_part as a user starts it."""
import argparse
import json
import math
import os
import shutil
import struct
import subprocess
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check, check_equal, check_true, finish  # noqa: E402

parser = argparse.ArgumentParser()
parser.add_argument("--display", action="store_true")
for name in ("--program", "--events", "--solids", "--output"):
    parser.add_argument(name, required=True)
options = parser.parse_args()
folder = os.path.join(options.output, "edit_part_display" if options.display else "edit_part")
shutil.rmtree(folder, ignore_errors=True)
os.makedirs(folder)


def run(*arguments):
    result = subprocess.run([options.program, *arguments], capture_output=True, encoding="utf-8", timeout=200, cwd=folder,
                            check=False)
    print("$ edit_part", " ".join(arguments), "->", result.returncode)
    return result


def write_events(name, *lines):
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(("# StreamVersion 1.2",) + lines) + "\n")
    return path


def key(symbol, modifiers=0):
    return f"KeyPressEvent 5 5 {modifiers} 0 0 {symbol}"


def size_of_png(name):
    with open(os.path.join(folder, name), "rb") as file:
        head = file.read(24)
    return struct.unpack(">II", head[16:]) if head[:8] == b"\x89PNG\r\n\x1a\n" else None


def play():
    # The stream that is shipped, with every output; then two pictures by the key, none over the other.
    result = run("--size", "720", "560", "--play", options.events, "--json", "values.json", "--screenshot", "after.png",
                 "--before-after", "both.png", "--no-times")
    check_equal("exit status", 0, result.returncode)
    with open(os.path.join(folder, "values.json"), encoding="utf-8") as file:
        values = json.load(file)
    check_equal("version", 2, values["version"])
    check_true("bounds", {"area", "center_of_mass", "inertia", "mass", "volume"} <= set(values["last"]["bounds"]))
    check_equal("status", "ok", values["status"])
    check_equal("backend", "opengl", values["backend"])
    check_equal("faces", 40, values["faces"])
    check_equal("nothing opened", [], values["opened"])
    with open(options.events, encoding="utf-8") as file:
        moves = sum(" 0 0 0" in line and line.startswith("MouseMoveEvent") for line in file)
    check_true("an update for most moves", 0.7 * moves < values["updates"] <= moves, f"{values['updates']} of {moves}")
    first, last = values["first"], values["last"]
    check_true("the volume grew", last["volume"] > 1.01 * first["volume"], f"{first['volume']} {last['volume']}")
    check_true("bounds", all(0 < body["bounds"]["volume"] < 1e-9 * body["volume"] for body in (first, last)))
    # The file is symmetric in x, except for the digits that it was written with; what was dragged is not.
    check("first centre", 0.0, first["center_of_mass"][0], 1e-10)
    check_true("last centre", abs(last["center_of_mass"][0]) > 0.1)
    axes = last["principal_axes"]
    check("axes are unit vectors", 1.0, math.fsum(x * x for x in axes[0]), 1e-12)
    seconds = values["seconds"]
    check_true("times", all(0 < seconds[name]["best"] <= seconds[name]["median"] <= seconds[name]["worst"]
                            for name in ("edit", "display_points", "moments", "computing", "picture")), seconds)
    check_true("computing is the sum of its parts", seconds["computing"]["best"] >= seconds["moments"]["best"])
    check_equal("picture", (720, 560), size_of_png("after.png"))
    check_equal("both pictures", (1440, 560), size_of_png("both.png"))
    print(f"median of an update: {1e3 * seconds['computing']['median']:.1f} ms, with its picture "
          f"{1e3 * (seconds['computing']['median'] + seconds['picture']['median']):.0f} ms")

    result = run("--hold-volume", "--size", "720", "560", "--play", options.events, "--json", "-")
    check_equal("held: exit status", 0, result.returncode)
    held = json.loads(result.stdout)
    check("held: the volume", held["first"]["volume"], held["last"]["volume"], 1e-9 * held["first"]["volume"])
    check_true("held: at each update", 0 < held["hold"]["largest_deviation"] < 1e-9, held["hold"])
    check_true("not held without the option", values["hold"] is None and last["volume"] > 1.01 * first["volume"])
    print(f"median of an update with the volume held: {1e3 * held['seconds']['computing']['median']:.1f} ms, a drag begins in "
          f"{1e3 * held['hold']['begin_seconds']:.0f} ms")

    result = run("--size", "400", "300", "--play", write_events("keys", key("s"), key("s"), key("h"), key("r"), key("f")),
                 "--json", "-")
    check_equal("exit status", 0, result.returncode)
    check_equal("no updates", 0, json.loads(result.stdout)["updates"])
    check_equal("no times", None, json.loads(result.stdout)["seconds"]["edit"])
    for name in ("free_form_part_1.png", "free_form_part_2.png"):
        check_equal(name, (400, 300), size_of_png(name))
    return values


def errors():
    manifest = Manifest(options.solids)
    events = write_events("nothing", key("h"))

    def refused(what, status, says, *arguments):
        result = run(*arguments)
        check_equal(what + ": exit status", status, result.returncode)
        check_true(what + ": says why", says in result.stderr, result.stderr.strip()[:300])

    result = run("--help")
    check_equal("help: exit status", 0, result.returncode)
    check_true("help", "Exit status:" in result.stdout and "--play" in result.stdout)
    refused("unknown option", 1, "--nonsense", "--nonsense")
    refused("too small a window", 1, "--size", "--size", "10", "10")
    refused("play and record", 1, "excludes", "--play", events, "--record", "x")
    refused("no such file", 2, "nothing to edit", "missing.step", "--play", events)
    refused("no geometry", 2, "nothing to edit", manifest.special("no_geometry")["path"], "--play", events)
    refused("no such stream", 1, "cannot be read", "--play", "missing.events")
    refused("an empty stream", 1, "no events", "--play", write_events("empty"))
    refused("an unknown event", 1, "line 2: there is no event Mouse", "--play", write_events("bad", "Mouse 1 2 0 0 0 0"))
    refused("another size", 1, "leave out --size, or give --size 720 560", "--size", "900", "700", "--play", options.events)
    refused("outside the window", 1, "outside the window of 400 x 300 pixels", "--size", "400", "300", "--play",
            write_events("outside", "LeftButtonPressEvent 500 100 0 0 0 0"))
    refused("an option for a file", 1, "a file name is missing", "--play", "--json", "x.step")
    recorded = write_events("recorded", "# WindowSize 720 560", key("h"))
    result = run("--play", recorded, "--screenshot", "own_size.png")
    check_equal("the size of the recording: exit status", 0, result.returncode)
    check_equal("the size of the recording", (720, 560), size_of_png("own_size.png"))
    refused("no numbers", 1, "line 3", "--play", write_events("bad", key("h"), "MouseMoveEvent 1 two 0 0 0 0"))
    refused("a folder that is not there", 1, "cannot be written", "--play", events, "--screenshot", "no/where.png")
    refused("JSON that cannot be written", 1, "cannot be written", "--play", events, "--json", "no/where.json")
    if not options.display:
        refused("no display", 1, "there is no display")
        kept = write_events("kept", key("h"))
        with open(kept, encoding="utf-8") as file:
            before = file.read()
        refused("no display to record on", 1, "there is no display", "--record", kept)
        with open(kept, encoding="utf-8") as file:
            check_equal("the recording that was there stays", before, file.read())


def leave():
    """The picture of a window that its user left with q is that of one which nobody touched."""
    from smx11 import Display
    key_q = 24  # the keycode of q on every PC keyboard, also of Xvfb's
    size = ["--size", "1280", "1024", "--no-times"]  # the whole display, because a key goes to the window below the pointer
    still = run(*size, "--play", write_events("still", "RenderEvent 0 0 0 0 0 0"), "--screenshot", "still.png")
    check_equal("a still picture", 0, still.returncode)
    process = subprocess.Popen([options.program, *size, "--screenshot", "left.png"], cwd=folder, stderr=subprocess.PIPE, encoding="utf-8")
    display = Display()
    end = time.monotonic() + 120
    while process.poll() is None and time.monotonic() < end:
        display.tap(key_q)
        time.sleep(2)
    if process.poll() is None:
        process.kill()
    check_equal("q ends it", 0, process.wait())
    pictures = []
    for name in ("still.png", "left.png"):
        with open(os.path.join(folder, name), "rb") as file:
            pictures.append(file.read())
    check_true("the picture of the end", pictures[0] == pictures[1], f"{len(pictures[0])} and {len(pictures[1])} bytes")


values = play()
if options.display:
    leave()
    with open(os.path.join(options.output, "edit_part", "values.json"), encoding="utf-8") as file:
        other = json.load(file)
    # Off screen the same, bit for bit: the same driver, and a camera that asks no window.
    check_equal("as off screen", other["last"], values["last"])
else:
    errors()
finish()

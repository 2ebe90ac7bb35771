#!/usr/bin/env python3
"""All value tests, and the speed of models, on a machine with a GPU, by EGL without a display.

    python3 Testing/gpu.py run BUILD [FILE.step...]       on the machine that has the build
    python3 Testing/gpu.py pack BUILD FOLDER [FILE.step...]
    python3 FOLDER/gpu.py run FOLDER                      on one that has a GPU, Python 3.8 and an OpenGL driver, and no VTK

`pack` copies the programs with their shared libraries (all but the C library and OpenGL, which are the other machine's), the files that
tests read, and the models. `run` runs the tests with the label `value` that open no window, then integrates every model to 1e-9 with
--backend opengl and --backend cpu, and prints for each the least seconds of three runs, evaluations a second, and with --peak the
share of the GPU's rate of double precision, at --operations floating-point operations for an evaluation. Behind a slash is what
--backend auto estimates; "with start" adds context, shaders and upload. Where estimates are far from what is measured, the rates in
Filters/SurfaceIntegrals/Items/smBackendCost.h want correcting. --only REGEX chooses tests, --no-tests leaves them out. A software
rasterizer is told as such: its times say nothing about a GPU.

Exit status 1: a test failed, a model has no result, or the context is not OpenGL.
"""
import argparse
import json
import os
import re
import shutil
import subprocess
import sys

SOFTWARE = ("llvmpipe", "softpipe", "swrast", "swiftshader", "software rasterizer")
# The other machine's own: the C library, and OpenGL with what its driver brings.
SYSTEM = re.compile(r"^(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|util|nsl|GL|GLX|EGL|OpenGL|GLdispatch|GLESv2|drm|gbm)\.so.*)$")
# An evaluation of a bicubic rational patch with ten moments and the area, counted in smPanel.glsl: an estimate.
OPERATIONS = 300


def find_tests(build, only):
    """Commands of the tests with the label value that need no window, without their launcher."""
    listing = json.loads(subprocess.run(["ctest", "--show-only=json-v1", "-L", "value"], cwd=build, check=True,
                                        stdout=subprocess.PIPE, encoding="utf-8").stdout)
    tests = []
    for test in listing["tests"]:
        command = list(test.get("command", []))
        properties = {entry["name"]: entry["value"] for entry in test["properties"]}
        if command[1:3] == ["-E", "env"]:
            command = command[3:]
            while command and command[0].startswith("--"):
                command.pop(0)
        text = " ".join(command)
        if not command or "xvfb-run" in text or "pvpython" in text or "mpirun" in text or "gpu.py" in text or not re.search(only, test["name"]):
            continue
        tests.append({"name": test["name"], "command": command, "environment": properties.get("ENVIRONMENT", []),
                      "timeout": properties.get("TIMEOUT", 300)})
    return tests


def get_source(build):
    with open(os.path.join(build, "CMakeCache.txt"), encoding="utf-8") as cache:
        return re.search(r"^CMAKE_HOME_DIRECTORY:INTERNAL=(.*)$", cache.read(), re.M).group(1)


def find_libraries(program):
    """Paths of the shared libraries that are packed with a program."""
    lines = subprocess.run(["ldd", program], stdout=subprocess.PIPE, encoding="utf-8", check=False).stdout.splitlines()
    found = [match.group(1) for match in (re.search(r"=> (/\S+)", line) for line in lines) if match]
    return [path for path in found if not SYSTEM.match(os.path.basename(path))]


def pack(options):
    build, folder = os.path.realpath(options.build), os.path.realpath(options.folder)
    source = get_source(build)
    tests = [] if options.no_tests else find_tests(build, options.only)
    for part in ("bin", "lib", "files", "models", "output"):
        os.makedirs(os.path.join(folder, part), exist_ok=True)
    programs = {os.path.join(build, "bin", name) for name in ("solidmoments", "solidmoments-read")}
    for test in tests:
        programs |= {word for word in test["command"] if os.path.dirname(word) == os.path.join(build, "bin")}
    copied = {}

    def place(path):
        """Where a file or folder that a test names lies in the pack, relative to it."""
        if path not in copied:
            name = os.path.join("files", os.path.relpath(path, build if path.startswith(build + os.sep) else source))
            target = os.path.join(folder, name)
            os.makedirs(os.path.dirname(target), exist_ok=True)
            if os.path.isdir(path):
                shutil.copytree(path, target, dirs_exist_ok=True)
            else:
                shutil.copy2(path, target)
            copied[path] = name
        return copied[path]

    output = os.path.join(build, "Testing", "output")
    for test in tests:
        words = []
        for word in test["command"]:
            if word in programs:
                words.append(os.path.join("{pack}", "bin", os.path.basename(word)))
            elif word.startswith(output):
                words.append("{pack}/output" + word[len(output):])
            elif re.search(r"/python[0-9.]*$", word):
                words.append("{python}")
            elif word.startswith((build + os.sep, source + os.sep)) and os.path.exists(word):
                words.append(os.path.join("{pack}", place(word)))
            else:
                words.append(word)
        test["command"] = words
    # Scripts of tests import their neighbours, and those of Support.
    folders = {os.path.dirname(path) for path in copied if path.endswith(".py")}
    for near in folders | ({os.path.join(source, "Testing", "Support")} if folders else set()):
        for name in os.listdir(near):
            if name.endswith((".py", ".json")):
                place(os.path.join(near, name))
    for program in sorted(programs):
        shutil.copy2(program, os.path.join(folder, "bin"))
        for library in find_libraries(program):
            shutil.copy2(library, os.path.join(folder, "lib"))
    for path in options.files:
        shutil.copy2(path, os.path.join(folder, "models"))
    with open(os.path.join(folder, "tests.json"), "w", encoding="utf-8") as file:
        json.dump(tests, file, indent=1)
    shutil.copy2(os.path.realpath(__file__), os.path.join(folder, "gpu.py"))
    print(f"{len(programs)} programs, {len(tests)} tests, {len(options.files)} models in {folder}")
    return 0


def make_environment(folder, is_pack):
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    if is_pack:
        environment["LD_LIBRARY_PATH"] = os.path.join(folder, "lib") + ":" + environment.get("LD_LIBRARY_PATH", "")
    return environment


def run_tests(tests, folder, environment):
    failed = []
    for test in tests:
        command = [word.replace("{pack}", folder).replace("{python}", sys.executable) for word in test["command"]]
        own = dict(environment, **dict(entry.split("=", 1) for entry in test["environment"]))
        try:
            result = subprocess.run(command, env=own, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=test["timeout"],
                                    check=False, cwd=folder)
            status, text = result.returncode, result.stdout.decode("utf-8", "replace")
        except (subprocess.TimeoutExpired, OSError) as error:
            status, text = -1, str(error)
        word = {0: "passed", 77: "skipped"}.get(status, "FAILED")
        print(f"{word:8} {test['name']}", flush=True)
        if word == "FAILED":
            failed.append(test["name"])
            print("\n".join(text.splitlines()[-5:]))
    print(f"{len(tests)} tests, {len(failed)} failed")
    return not failed


def measure(program, path, backend, environment):
    """The entry of the fastest of three runs, each a process of its own; the first may compile shaders."""
    result = subprocess.run([program, "--json", "-", "--backend", backend, path, path, path], env=environment,
                            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False)
    try:
        files = [file for file in json.loads(result.stdout)["files"] if file["seconds"]["integrate"] is not None]
    except ValueError:
        files = []
    return min(files, key=lambda file: file["seconds"]["integrate"], default=None)


def get_whole(entry):
    """Milliseconds of the integration with all that a backend needs before it: context, shaders, upload."""
    return 1e3 * sum(entry["seconds"][key] for key in ("start", "upload", "integrate"))


def run_models(paths, program, environment, options):
    heads = ["model", "faces", "evaluations / estimated", "opengl: ms", "cpu: ms", "opengl: million evaluations/s",
             "opengl with start: ms / estimated", "cpu with start: ms / estimated", "auto"]
    heads += ["share of the fp64 rate"] if options.peak else []
    print("| " + " | ".join(heads) + " |\n" + "|---" * len(heads) + "|")
    renderers = set()
    good = True
    within = measured = faster = 0
    for path in paths:
        entries = {backend: measure(program, path, backend, environment) for backend in ("opengl", "cpu")}
        gpu, cpu = entries["opengl"], entries["cpu"]
        if not gpu or not cpu or gpu["backend"] != "opengl":
            print(f"| {os.path.basename(path)} | no result |")
            good = False
            continue
        renderers.add(gpu["renderer"])
        seconds = max(gpu["seconds"]["integrate"], 1e-9)
        rate = gpu["evaluations"] / seconds
        measured += 1
        within += seconds < 3e-3
        whole = {backend: get_whole(entry) for backend, entry in entries.items()}
        estimate = {backend: 1e3 * gpu["estimate"][backend + "_seconds"] for backend in entries}
        auto = min(("cpu", "opengl"), key=estimate.get)
        faster += whole[auto] == min(whole.values())
        cells = [os.path.basename(path), gpu["faces"], f"{gpu['evaluations']} / {gpu['estimate']['evaluations']}", f"{1e3 * seconds:.2f}",
                 f"{1e3 * cpu['seconds']['integrate']:.2f}", f"{1e-6 * rate:.1f}", f"{whole['opengl']:.2f} / {estimate['opengl']:.2f}",
                 f"{whole['cpu']:.2f} / {estimate['cpu']:.2f}", auto]
        cells += [f"{rate * options.operations / (1e12 * options.peak):.3f}"] if options.peak else []
        print("| " + " | ".join(map(str, cells)) + " |", flush=True)
    print(f"{within} of {measured} models integrated in less than 3 ms; {', '.join(sorted(renderers))}")
    print(f"the estimate takes the backend that was faster, with its start, for {faster} of {measured} models")
    if any(name in renderer.lower() for renderer in renderers for name in SOFTWARE):
        print("This is a software rasterizer, no GPU: its times say nothing about one.")
    return good


def run(options):
    folder = os.path.realpath(options.build)
    packed = os.path.join(folder, "tests.json")
    is_pack = os.path.exists(packed)
    if options.no_tests:
        tests = []
    elif is_pack:
        with open(packed, encoding="utf-8") as file:
            tests = [test for test in json.load(file) if re.search(options.only, test["name"])]
    else:
        tests = find_tests(folder, options.only)
    models = os.path.join(folder, "models")
    paths = options.files or sorted(os.path.join(models, name) for name in (os.listdir(models) if is_pack else []))
    environment = make_environment(folder, is_pack)
    passed = run_tests(tests, folder, environment)
    measured = run_models(paths, os.path.join(folder, "bin", "solidmoments"), environment, options)
    return 0 if passed and measured else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("run", "pack"))
    parser.add_argument("build", help="a build folder, or a pack")
    parser.add_argument("files", nargs="*", help="for pack, first the folder; then models")
    parser.add_argument("--only", default="", help="a regular expression for the names of tests")
    parser.add_argument("--no-tests", action="store_true")
    parser.add_argument("--peak", type=float, help="double precision rate of the GPU in 10^12 operations a second")
    parser.add_argument("--operations", type=float, default=OPERATIONS, help="floating-point operations of an evaluation")
    options = parser.parse_intermixed_args()
    if options.what == "run":
        return run(options)
    if not options.files:
        parser.error("pack needs a folder")
    options.folder = options.files.pop(0)
    return pack(options)


if __name__ == "__main__":
    sys.exit(main())

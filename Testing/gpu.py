#!/usr/bin/env python3
"""All value tests, the agreement of GPU and CPU, and the speed of models, on a machine with a GPU, by EGL without a display.

    python3 Testing/gpu.py run BUILD [FILE.step...]             on the machine that has the build
    python3 Testing/gpu.py pack BUILD ARCHIVE.tar.xz [FILE.step...]
    python3 gpu.py run ARCHIVE.tar.xz                           on one with a GPU, its driver and Python 3.8; no VTK, no compiler

`pack` writes one archive, by default of at most 40 MB: the programs with their shared libraries, stripped (all but the C library, and
OpenGL, of which only the loader is added for machines that lack it), the tracked files of the tree, what tests read, and the models. Tests
that open a window or import this machine's Python modules are left out; the report names the latter. Tests that read real files from
../shared need that folder on the other machine, too: run --shared DIR.

`run` unpacks the archive next to itself, or takes the unpacked folder, which has this script, too. It prints
 - the driver, and the table of the program's own probe (solidmoments --opengl-probe);
 - for the sample parts, the certified solids and the models: whether --backend opengl prints the same bits twice, and how far its volumes are
   from those of --backend cpu: --relative is allowed, and the measured rounding error where that is much larger (solids like a long wire);
 - the tests, on all cores, each with an output folder of its own: what failed with its last lines, then what was skipped or not run, then
   the counts. A test has reached a shader when a process of it dispatched a compute program (SOLIDMOMENTS_DISPATCH_LOG);
 - alone on the machine, for each model and sample part the smallest seconds of three runs, evaluations a second, and with --peak the share
   of the GPU's rate of double precision, at --operations floating-point operations for an evaluation. Behind a slash is what --backend auto
   estimates; "with start" adds context, shaders and upload.
--seconds ends all of it in that time: what was not run is listed. --json FILE takes everything (default: report.json in the output folder).

Exit status 1: a test failed, was skipped or not run, bits differ, a volume is too far off, a probe failed, a model has no result, or the
context is not OpenGL.
"""
import argparse
import concurrent.futures
import ctypes
import gzip
import json
import lzma
import os
import re
import shutil
import signal
import stat
import subprocess
import sys
import tarfile
import tempfile
import threading
import time

SOFTWARE = ("llvmpipe", "softpipe", "swrast", "swiftshader", "software rasterizer")
# The other machine's own: the C library, and OpenGL with what its driver brings.
SYSTEM = re.compile(r"^(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|util|nsl|GL|GLX|EGL|OpenGL|GLdispatch|GLESv2|drm|gbm)\.so.*)$")
# Libraries that drivers may use, too, so that the machine's own are taken where they are as new as the packed
# ones: all but these.
OWN = re.compile(r"^lib(sm|vtk|TK)")
# The loader of OpenGL (libglvnd), used only where the machine has none.
LOADER = ("libEGL.so.1", "libGL.so.1", "libOpenGL.so.0", "libGLX.so.0", "libGLdispatch.so.0")
# An evaluation of a bicubic rational patch with ten moments and the area, counted in smPanel.glsl: an
# estimate.
OPERATIONS = 300
# Seconds, names of files and estimates differ from run to run; everything else has to be the same.
NO_RESULT = {"seconds", "file", "process_start", "backend_reason", "estimate"}
SKIPPED = 77
# Above this share of the volume the rounding error that a run measures says that the volume is a small
# difference of large terms: there both backends only have to agree within what they measure.
ILL_CONDITIONED = 1e-12
# Replaced by libraries whose functions end the process when they are called: OpenCASCADE's viewer and VTK
# would read pictures with them, which no test does. They bring 25 others.
EMPTY = ("libfreeimage.so.3", "libtiff.so.6")
LAUNCHER = """#!/bin/sh
here=${0%%/*}/..
LD_LIBRARY_PATH=$here/lib:$here/lib/chosen${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export LD_LIBRARY_PATH
exec "$here/programs/%s" "$@"
"""


# Finding tests
# ----------------------------------------------------------------------------------------------------

def get_source(build):
    with open(os.path.join(build, "CMakeCache.txt"), encoding="utf-8") as cache:
        return re.search(r"^CMAKE_HOME_DIRECTORY:INTERNAL=(.*)$", cache.read(), re.M).group(1)


def read_costs(build):
    """Mean seconds of the tests that CTest has run."""
    costs = {}
    try:
        with open(os.path.join(build, "Testing", "Temporary", "CTestCostData.txt"), encoding="utf-8") as file:
            for line in file:
                words = line.split()
                if len(words) == 3:
                    costs[words[0]] = float(words[2])
    except OSError:
        pass
    return costs


class Catalogue:
    """The tests of a build that need no window, with placeholders for the places that differ between build and pack."""

    def __init__(self, build, only):
        self.build, self.source = build, get_source(build)
        listing = json.loads(subprocess.run(["ctest", "--show-only=json-v1", "-L", "value"], cwd=build, check=True,
                                            stdout=subprocess.PIPE, encoding="utf-8").stdout)
        costs = read_costs(build)
        entries = []
        for test in listing["tests"]:
            properties = {entry["name"]: entry["value"] for entry in test["properties"]}
            command = list(test.get("command", []))
            if command[1:3] == ["-E", "env"]:
                command = command[3:]
                while command and command[0].startswith("--"):
                    command.pop(0)
            text = " ".join(command)
            if re.search(r"xvfb-run|pvpython|pvbatch|mpirun|gpu\.py", text):
                continue
            entries.append({"name": test["name"], "command": command, "environment": properties.get("ENVIRONMENT", []),
                            "labels": properties.get("LABELS", []), "timeout": properties.get("TIMEOUT", 300),
                            "setup": properties.get("FIXTURES_SETUP", []), "required": properties.get("FIXTURES_REQUIRED", []),
                            "cost": costs.get(test["name"], 0)})
        self.missing = [entry["name"] for entry in entries if not entry["command"]]
        entries = [entry for entry in entries if entry["command"]]
        isolated = [entry for entry in entries if any(value.startswith("PYTHONPATH=") for value in entry["environment"])]
        self.left_out = [entry["name"] for entry in isolated]
        tests = [entry for entry in entries if "value" in entry["labels"] and entry not in isolated and re.search(only, entry["name"])]
        needed = {fixture for test in tests for fixture in test["required"]}
        wanted = []
        while any(needed & set(entry["setup"]) and entry not in wanted for entry in entries):
            wanted += [entry for entry in entries if needed & set(entry["setup"]) and entry not in wanted]
            needed |= {fixture for entry in wanted for fixture in entry["required"]}
        self.setups = []
        while wanted:
            # Those first that require nothing of the others.
            ready = [entry for entry in wanted if not any(set(entry["required"]) & set(other["setup"]) for other in wanted if other != entry)]
            self.setups += ready
            wanted = [entry for entry in wanted if entry not in ready]
        self.tests = [test for test in tests if test not in self.setups]
        self.common = {match for entry in self.setups for word in entry["command"]
                       for match in re.findall(re.escape(build) + r"/Testing/(output/[^/' ]+|models)", word)}
        for entry in self.tests + self.setups:
            entry["command"] = [self.abstract(word) for word in entry["command"]]
            entry["environment"] = [self.abstract(word) for word in entry["environment"]]
        # What users of a GPU want to know first, and what takes long.
        self.tests.sort(key=lambda test: (bool(test["required"]), "gpu" not in test["labels"], -test["cost"], test["name"]))

    def abstract(self, word):
        """A word of a command with placeholders for folders."""
        if re.search(r"/python[0-9.]*$", word) and " " not in word:
            return "{python}"
        for folder in sorted(self.common, key=len, reverse=True):
            word = re.sub(re.escape(f"{self.build}/Testing/{folder}") + r"(?![\w.-])", "{common}/" + folder.split("/")[-1], word)
        shared = os.path.join(self.source, "..", "shared")
        for path, placeholder in ((f"{self.build}/Testing/output", "{output}"), (f"{self.build}/bin/", "{bin}/"), (self.build, "{build}"),
                                  (shared, "{shared}"), (os.path.realpath(shared), "{shared}"), (self.source, "{source}")):
            word = word.replace(path, placeholder)
        return word

    def get_places(self, output):
        return {"bin": os.path.join(self.build, "bin"), "build": self.build, "source": self.source,
                "shared": os.path.realpath(os.path.join(self.source, "..", "shared")), "common": os.path.join(output, "common")}

    def get_words(self):
        return [word for entry in self.tests + self.setups for word in entry["command"] + entry["environment"]]


def fill(word, places):
    for name, path in places.items():
        word = word.replace("{" + name + "}", path)
    return word


# Packing
# ----------------------------------------------------------------------------------------------------

def find_libraries(program, found, needed):
    """Adds the paths of the shared libraries that a program loads to `found`, by name, without those that only EMPTY libraries need;
    `needed` keeps what each library names."""
    lines = subprocess.run(["ldd", program], stdout=subprocess.PIPE, encoding="utf-8", check=False).stdout.splitlines()
    missing = [line.strip() for line in lines if "not found" in line]
    if missing:
        raise SystemExit(f"{program}: {missing}")
    matches = filter(None, (re.match(r"\s*(\S+) => (/\S+)", line) for line in lines))
    paths = {match.group(1): match.group(2) for match in matches}
    waiting = [program]
    seen = set()
    while waiting:
        path = waiting.pop()
        if path not in needed:
            text = subprocess.run(["objdump", "-p", path], stdout=subprocess.PIPE, encoding="utf-8", check=True).stdout
            needed[path] = re.findall(r"^\s*NEEDED\s+(\S+)", text, re.M)
        for name in needed[path]:
            if name in paths and name not in seen:
                seen.add(name)
                found[name] = paths[name]
                # What the C library and OpenGL need is the other machine's, too, except for the loader.
                if name not in EMPTY and (name in LOADER or not SYSTEM.match(name)):
                    waiting.append(paths[name])


def list_symbols(path, kind):
    """Names of dynamic symbols with their versions, as TIFFOpen and LIBTIFF_4.0."""
    lines = subprocess.run(["nm", "-D", kind, path], stdout=subprocess.PIPE, encoding="utf-8", check=True).stdout.splitlines()
    return {tuple(re.sub("@+", "@", line.split()[-1] + "@").split("@")[:2]) for line in lines if line.strip()}


def make_empty(path, target, users):
    """A library with those functions of another one that the users name; each ends the process when it is called."""
    wanted = {name for user in users for name, _ in list_symbols(user, "--undefined-only")}
    symbols = sorted(symbol for symbol in list_symbols(path, "--defined-only") if symbol[0] in wanted)
    code = "".join(f"void {name}(void) {{ __builtin_trap(); }}\n" for name, _ in symbols)
    versions = sorted({version for _, version in symbols if version})
    with tempfile.NamedTemporaryFile("w", suffix=".map", encoding="utf-8") as script:
        script.write("".join(f"{version} {{ global: {' '.join(name + ';' for name, own in symbols if own == version)} }};\n" for version in versions)
                     or "{ global: *; };\n")
        script.flush()
        subprocess.run([os.environ.get("CC", "cc"), "-shared", "-nostdlib", "-fno-builtin", "-w", f"-Wl,-soname,{os.path.basename(target)}",
                        f"-Wl,--version-script={script.name}", "-o", target, "-xc", "-"], input=code, encoding="utf-8", check=True)


def copy_stripped(path, target):
    shutil.copyfile(path, target)
    os.chmod(target, 0o755)
    subprocess.run(["strip", "--strip-unneeded", target], check=True, stderr=subprocess.DEVNULL)


def copy_tree(catalogue, folder):
    """Tracked files of the source tree but those that are only compiled; without git all that do not look like a build."""
    source = catalogue.source
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=source, stdout=subprocess.PIPE,
                            stderr=subprocess.DEVNULL, check=False)
    names = [name for name in listed.stdout.decode("utf-8").split("\0") if name] if listed.returncode == 0 else [
        os.path.relpath(os.path.join(where, name), source) for where, _, names in os.walk(source) for name in names
        if not re.match(r"(\.git|build[^/]*|install)(/|$)", os.path.relpath(where, source))]
    compiled = re.compile(r"^(Filters|Readers|Rendering|ParaViewPlugin|Testing)/.*\.(cxx|h|xml|cmake)$")
    for name in names:
        if os.path.isfile(os.path.join(source, name)) and not compiled.match(name):
            target = os.path.join(folder, "source", name)
            os.makedirs(os.path.dirname(target), exist_ok=True)
            shutil.copy2(os.path.join(source, name), target)


def copy_named(catalogue, folder):
    """Files and folders of the build that commands name, and what setups make that run no program of ours."""
    places = catalogue.get_places(folder)
    for word in catalogue.get_words():
        for name in re.findall(r"\{build\}/([^'\" ]+)", word):
            path, target = os.path.join(catalogue.build, name), os.path.join(folder, "build", name)
            if os.path.isdir(path):
                shutil.copytree(path, target, dirs_exist_ok=True)
            elif os.path.exists(path):
                os.makedirs(os.path.dirname(target), exist_ok=True)
                shutil.copy2(path, target)
    for setup in [entry for entry in catalogue.setups if not re.search(r"\{(bin|shared)\}", " ".join(entry["command"]))]:
        command = [fill(word, places) for word in setup["command"]]
        os.makedirs(os.path.join(folder, "common"), exist_ok=True)
        for word in command[1:]:
            if word.startswith(places["common"] + os.sep):
                os.makedirs(os.path.dirname(word), exist_ok=True)
        done = subprocess.run(command, check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode:
            raise SystemExit(f"{setup['name']}: {done.stdout.decode('utf-8', 'replace')}")
        catalogue.setups.remove(setup)


def copy_beside(catalogue, folder):
    """What tests and edit_part look for next to the programs."""
    for path, target in ((os.path.join(catalogue.build, "Examples/solidmoments/solidmoments.1"), "Examples/solidmoments/solidmoments.1"),
                         (os.path.join(catalogue.source, "Examples/Models/free_form_part.step"), "share/solidmoments/free_form_part.step")):
        os.makedirs(os.path.dirname(os.path.join(folder, target)))
        shutil.copy2(path, os.path.join(folder, target))


def compress(folder, archive, preset):
    """Writes the archive, similar files together, with the filter for machine code."""
    filters = [{"id": lzma.FILTER_X86}, {"id": lzma.FILTER_LZMA2, "preset": preset}]
    with lzma.open(archive, "wb", format=lzma.FORMAT_XZ, check=lzma.CHECK_CRC64, filters=filters) as file:
        with tarfile.open(fileobj=file, mode="w|", format=tarfile.GNU_FORMAT) as tar:
            for part in ("lib", "programs"):
                tar.add(os.path.join(folder, part), f"solidmoments-gpu/{part}")
            for part in sorted(set(os.listdir(folder)) - {"lib", "programs"}):
                tar.add(os.path.join(folder, part), f"solidmoments-gpu/{part}")


def unpack_model(path, folder):
    """The path of a model; of one that ends in .gz that of its content in the folder."""
    if not path.endswith(".gz"):
        return os.path.realpath(path)
    target = os.path.join(folder, os.path.basename(path)[:-3])
    with gzip.open(path) as packed, open(target, "wb") as file:
        shutil.copyfileobj(packed, file)
    return target


def pack(options):
    build = os.path.realpath(options.build)
    catalogue = Catalogue(build, options.only if not options.no_tests else "(?!)")
    with tempfile.TemporaryDirectory() as folder:
        for part in ("bin", "programs", "lib/loader", "lib/system", "models", "common", "build", "source"):
            os.makedirs(os.path.join(folder, part))
        programs = {"solidmoments", "solidmoments-read"} | {
            name for word in catalogue.get_words() for name in re.findall(r"\{bin\}/([\w.-]+)", word)}
        libraries, needed, versions = {}, {}, {}
        for name in sorted(programs):
            program = os.path.join(build, "bin", name)
            find_libraries(program, libraries, needed)
            copy_stripped(program, os.path.join(folder, "programs", name))
            with open(os.path.join(folder, "bin", name), "w", encoding="utf-8") as file:
                file.write(LAUNCHER % name)
            os.chmod(os.path.join(folder, "bin", name), 0o755)
        for name, path in libraries.items():
            if name in EMPTY:
                make_empty(path, os.path.join(folder, "lib", name), [user for user, names in needed.items() if name in names])
            elif name in LOADER:
                copy_stripped(path, os.path.join(folder, "lib", "loader", name))
            elif not SYSTEM.match(name):
                copy_stripped(path, os.path.join(folder, "lib" if OWN.match(name) else "lib/system", name))
                if not OWN.match(name):
                    versions[name] = os.path.basename(os.path.realpath(path))
        copy_tree(catalogue, folder)
        copy_named(catalogue, folder)
        copy_beside(catalogue, folder)
        for path in options.files:
            if path.endswith(".gz"):
                unpack_model(path, os.path.join(folder, "models"))
            else:
                shutil.copy2(path, os.path.join(folder, "models"))
        commit = subprocess.run(["git", "describe", "--always", "--dirty"], cwd=catalogue.source, stdout=subprocess.PIPE,
                                stderr=subprocess.DEVNULL, encoding="utf-8", check=False).stdout.strip()
        with open(os.path.join(folder, "tests.json"), "w", encoding="utf-8") as file:
            json.dump({"commit": commit, "tests": catalogue.tests, "setups": catalogue.setups, "left_out": catalogue.left_out,
                       "versions": versions}, file, indent=1)
        shutil.copy2(os.path.realpath(__file__), os.path.join(folder, "gpu.py"))
        compress(folder, options.archive, options.preset)
    size = os.path.getsize(options.archive)
    print(f"{options.archive}: {size / 1e6:.1f} MB, {len(programs)} programs, {len(libraries)} libraries, {len(catalogue.tests)} tests with "
          f"{len(catalogue.setups)} setups, {len(options.files)} models, commit {commit}")
    print(f"{len(catalogue.left_out)} value tests without a window are left out, since they import Python modules: "
          + ", ".join(catalogue.left_out))
    if catalogue.missing:
        print(f"{len(catalogue.missing)} tests are not built: {', '.join(catalogue.missing)}")
    if size > 1e6 * options.limit:
        print(f"The archive is larger than {options.limit} MB.")
    return 1 if size > 1e6 * options.limit or catalogue.missing else 0


# The other machine
# ----------------------------------------------------------------------------------------------------

def can_load(name):
    try:
        ctypes.CDLL(name)
        return True
    except OSError:
        return False


def get_version(name):
    """The numbers behind a library's .so, as in libstdc++.so.6.0.30."""
    return [int(number) for number in re.findall(r"\d+", name.split(".so", 1)[-1])]


def choose_libraries(folder, versions):
    """Links those packed libraries that the machine lacks, or has in an older version, into the folder that the launchers search."""
    chosen = os.path.join(folder, "lib", "chosen")
    shutil.rmtree(chosen, ignore_errors=True)
    os.makedirs(chosen)
    places = [f"{root}/{name}" for root in ("/lib", "/usr/lib") for name in ("x86_64-linux-gnu", "")] + ["/lib64", "/usr/lib64", "/usr/local/lib"]
    own = []
    for name, version in versions.items():
        found = [os.path.realpath(os.path.join(place, name)) for place in places if os.path.exists(os.path.join(place, name))]
        if found and get_version(os.path.basename(found[0])) >= get_version(version):
            own.append(os.path.basename(found[0]))
        else:
            os.symlink(os.path.join("..", "system", name), os.path.join(chosen, name))
    if versions:
        print(f"{len(own)} of {len(versions)} common libraries are the machine's own, for the sake of its driver: {', '.join(sorted(own))}")


def make_environment(pack_folder, output):
    """Without displays. On a machine without a loader of OpenGL the packed one is used, on one that does not say where its driver is, NVIDIA's."""
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    environment.setdefault("HOME", output)
    if pack_folder and not all(can_load(name) for name in LOADER[:3]):
        print("The machine has no loader of OpenGL: the packed one is used.")
        environment["LD_LIBRARY_PATH"] = ":".join(filter(None, [os.path.join(pack_folder, "lib", "loader"), environment.get("LD_LIBRARY_PATH")]))
    vendors = [folder for folder in ("/etc/glvnd/egl_vendor.d", "/usr/share/glvnd/egl_vendor.d") if os.path.isdir(folder) and os.listdir(folder)]
    if not vendors and not any(name.startswith("__EGL_VENDOR_LIBRARY") for name in environment) and can_load("libEGL_nvidia.so.0"):
        path = os.path.join(output, "10_nvidia.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump({"file_format_version": "1.0.0", "ICD": {"library_path": "libEGL_nvidia.so.0"}}, file)
        print(f"The machine names no driver for EGL: {path} does.")
        environment["__EGL_VENDOR_LIBRARY_FILENAMES"] = path
    return environment


class Jobs:
    """Runs commands in a pool until a deadline; then those that run are ended, and no others begin."""

    def __init__(self, count, environment):
        self.count, self.environment = count, environment
        self.deadline = float("inf")
        self.lock = threading.Lock()

    def run(self, command, timeout, environment=None, cwd=None, separate=False):
        """(status, output); the status is None when the deadline was there first, and a text when there is none."""
        left = self.deadline - time.monotonic()
        if left <= 0:
            return None, ""
        try:
            process = subprocess.Popen(command, env=dict(self.environment, **(environment or {})), stdin=subprocess.DEVNULL,
                                       stdout=subprocess.PIPE, stderr=subprocess.DEVNULL if separate else subprocess.STDOUT, cwd=cwd,
                                       start_new_session=True)
        except OSError as error:
            return str(error), ""
        try:
            text = process.communicate(timeout=min(timeout, left))[0]
            return process.returncode, text.decode("utf-8", "replace")
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            text = process.communicate()[0].decode("utf-8", "replace")
            return (None if left < timeout else f"no end after {timeout:g} s"), text

    def map(self, function, items):
        with concurrent.futures.ThreadPoolExecutor(self.count) as pool:
            return list(pool.map(function, items))


# Tests
# ----------------------------------------------------------------------------------------------------

def run_test(test, jobs, places, output):
    own = os.path.join(output, "tests", test["name"])
    os.makedirs(own, exist_ok=True)
    log = own + ".dispatches"
    mine = dict(places, output=own, python=sys.executable)
    environment = dict(fill(entry, mine).split("=", 1) for entry in test["environment"])
    environment["SOLIDMOMENTS_DISPATCH_LOG"] = log
    if "__EGL_VENDOR_LIBRARY_DIRS" in environment:
        environment["__EGL_VENDOR_LIBRARY_FILENAMES"] = ""
    begin = time.monotonic()
    status, text = jobs.run([fill(word, mine) for word in test["command"]], test["timeout"], environment, own)
    word = "not run" if status is None else {0: "passed", SKIPPED: "skipped"}.get(status, "failed")
    programs, renderers = set(), set()
    if os.path.exists(log):
        with open(log, encoding="utf-8", errors="replace") as file:
            lines = [line.rstrip("\n").split("\t") for line in file]
        lines = [line for line in lines if len(line) == 3 and not line[0].startswith("smProbe")]
        programs, renderers = {line[0] for line in lines}, {f"{line[1]}, OpenGL {line[2]}" for line in lines}
    result = {"name": test["name"], "result": word, "status": status, "seconds": round(time.monotonic() - begin, 3),
              "programs": sorted(programs), "renderers": sorted(renderers)}
    if word != "passed":
        result["text"] = text[-4000:]
    with open(own + ".txt", "w", encoding="utf-8") as file:
        file.write(text)
    if word == "passed":
        shutil.rmtree(own, ignore_errors=True)
    return result


def run_tests(tests, setups, jobs, places, output, lines):
    os.makedirs(places["common"], exist_ok=True)
    broken = {}
    results = []
    for setup in setups:
        result = run_test(setup, jobs, dict(places), output)
        if result["result"] != "passed":
            broken.update({fixture: setup["name"] for fixture in setup["setup"]})
        if result["result"] != "passed" or "value" in setup["labels"]:
            results.append(result)

    def run_one(test):
        missing = [broken[fixture] for fixture in test["required"] if fixture in broken]
        if missing:
            return {"name": test["name"], "result": "not run", "status": None, "seconds": 0, "programs": [], "renderers": [],
                    "text": f"{missing[0]}, which makes its input, did not pass"}
        return run_test(test, jobs, places, output)

    results += jobs.map(run_one, tests)
    groups = {word: [result for result in results if result["result"] == word] for word in ("failed", "skipped", "not run", "passed")}
    for result in groups["failed"]:
        print(f"FAILED {result['name']} (status {result['status']}, {result['seconds']} s)")
        said = result["text"].splitlines()
        marked = [line for line in said if line.startswith("FAIL")]
        for line in (marked + [line for line in said[-1:] if line not in marked])[:lines] if marked else said[-lines:]:
            print("    " + line[:300])
    for word in ("skipped", "not run"):
        if groups[word]:
            print(f"{word}: " + ", ".join(result["name"] for result in groups[word]))
    reached = [result for result in results if result["programs"]]
    print(f"{len(results)} tests found, {len(reached)} reached a shader, {len(groups['passed'])} passed, {len(groups['failed'])} failed, "
          f"{len(groups['skipped'])} skipped, {len(groups['not run'])} not run")
    print(f"of those that reached a shader {sum(result['result'] == 'passed' for result in reached)} passed, with "
          f"{len({program for result in reached for program in result['programs']})} compute programs on "
          + ("; ".join(sorted({renderer for result in reached for renderer in result["renderers"]})) or "no renderer"))
    return results


# Models
# ----------------------------------------------------------------------------------------------------

def integrate(jobs, program, backend, paths, timeout=300):
    """The entries of the program's JSON, one for each path; none where there is no result."""
    status, text = jobs.run([program, "--json", "-", "--backend", backend, *paths], timeout, separate=True)
    try:
        return status, json.loads(text)["files"]
    except ValueError:
        return status, []


def clean(value):
    if isinstance(value, dict):
        return {key: clean(item) for key, item in value.items() if key not in NO_RESULT}
    return [clean(item) for item in value] if isinstance(value, list) else value


def find_differences(path, one, other):
    if isinstance(one, dict) and isinstance(other, dict) and one.keys() == other.keys():
        for key in one:
            yield from find_differences(f"{path}.{key}" if path else key, one[key], other[key])
    elif isinstance(one, list) and isinstance(other, list) and len(one) == len(other):
        for index, pair in enumerate(zip(one, other)):
            yield from find_differences(f"{path}[{index}]", *pair)
    elif one != other:
        yield f"{path}: {one!r} and {other!r}"


def get_relative(one, other, key):
    values = [entry["total"][key] for entry in (one, other)]
    if None in values:
        return None if values[0] != values[1] else 0.0
    return abs(values[0] - values[1]) / max(abs(values[1]), sys.float_info.min) if values[0] != values[1] else 0.0


def get_volume_errors(gpu, cpu):
    """How far the volumes are apart, and what both runs together measure as rounding and say as bound; NaN where there is no number."""
    def add(key):
        values = [(entry["total"].get(key) or {}).get("volume") for entry in (gpu, cpu)]
        return sum(values) if None not in values else float("nan")
    volumes = [entry["total"]["volume"] for entry in (gpu, cpu)]
    if volumes[0] == volumes[1]:
        return 0.0, 0.0, 0.0
    return abs(volumes[0] - volumes[1]) if None not in volumes else float("nan"), add("bounds_measured"), add("bounds")


def compare_models(paths, program, jobs, relative):
    """Same bits twice on the GPU, and the volumes of both backends."""
    def compare(path):
        row = {"model": os.path.basename(path), "problems": []}
        runs = [(backend, *integrate(jobs, program, backend, [path])) for backend in ("opengl", "opengl", "cpu")]
        if any(status is None for _, status, _ in runs):
            return dict(row, result="not run")
        for backend, status, entries in runs:
            if not entries or entries[0].get("backend") != backend or not entries[0].get("total"):
                said = f", backend {entries[0].get('backend')}: {entries[0].get('messages')}" if entries else ""
                row["problems"].append(f"no result of {backend} (status {status}{said})")
                return dict(row, result="failed")
        first, second, cpu = (entries[0] for _, _, entries in runs)
        row["differences"] = list(find_differences("", clean(first), clean(second)))
        row.update(volume=cpu["total"]["volume"], relative=get_relative(first, cpu, "volume"), relative_area=get_relative(first, cpu, "area"),
                   evaluations={"opengl": first["evaluations"], "cpu": cpu["evaluations"]}, dispatches=first["dispatches"],
                   status={"opengl": first["status"], "cpu": cpu["status"]}, renderer=first["renderer"])
        if row["differences"]:
            row["problems"].append(f"{len(row['differences'])} numbers differ between two runs: {row['differences'][0]}")
        difference, measured, bounds = get_volume_errors(first, cpu)
        row["ill_conditioned"] = measured > ILL_CONDITIONED * abs(cpu["total"]["volume"] or 0)
        allowed = measured if row["ill_conditioned"] else relative * abs(cpu["total"]["volume"] or 0)
        if not difference <= min(allowed, bounds):
            row["problems"].append(f"volume {first['total']['volume']!r}, on the CPU {cpu['total']['volume']!r}: {difference:.3g} apart, relative "
                                   f"{row['relative']}, allowed {allowed:.3g}, bounds {bounds:.3g}")
        if first["status"] != cpu["status"]:
            row["problems"].append(f"status {first['status']}, on the CPU {cpu['status']}")
        return dict(row, result="failed" if row["problems"] else "passed")

    rows = jobs.map(compare, paths)
    failed = [row for row in rows if row["problems"]]
    for row in failed[:10]:
        print(f"FAILED {row['model']}: " + "; ".join(row["problems"])[:600])
    if len(failed) > 10:
        print(f"FAILED, too, as the report says: {', '.join(row['model'] for row in failed[10:])}")
    missing = [row["model"] for row in rows if row["result"] == "not run"]
    if missing:
        print("not compared: " + ", ".join(missing))
    done = [row for row in rows if "relative" in row]
    if done:
        plain = [row for row in done if not row["ill_conditioned"]]
        within = [row for row in done if row["relative"] is not None and row["relative"] <= relative]
        area = max(row["relative_area"] or 0 for row in done)
        print(f"{len(rows)} models: {sum(not row['differences'] for row in done)} the same bits twice; {len(within)} volumes of GPU and CPU within "
              f"{relative:g} of each other, farthest of the well-conditioned {max((row['relative'] or 0 for row in plain), default=0):.2g}; areas "
              f"within {area:.2g}")
        apart = sorted((row for row in done if row not in within), key=lambda row: -(row["relative"] or 0))
        if apart:
            print("farther apart: " + ", ".join(f"{row['model']} {row['relative']:.2g}" + (" (ill-conditioned)" if row["ill_conditioned"] else "")
                                                for row in apart if row["relative"] is not None))
    return rows


def measure(jobs, program, path, backend):
    """The entry of the fastest of three runs, each a process of its own; the first may compile shaders."""
    _, files = integrate(jobs, program, backend, [path, path, path])
    files = [file for file in files if (file.get("seconds") or {}).get("integrate") is not None]
    return min(files, key=lambda file: file["seconds"]["integrate"], default=None)


def get_whole(entry):
    """Milliseconds of the integration with all that a backend needs before it: context, shaders, upload."""
    return 1e3 * sum(entry["seconds"][key] for key in ("start", "upload", "integrate"))


def measure_models(paths, program, jobs, options):
    heads = ["model", "faces", "evaluations / estimated", "dispatches", "opengl: ms", "cpu: ms", "opengl: million evaluations/s",
             "opengl with start: ms / estimated", "cpu with start: ms / estimated", "auto"]
    heads += ["share of the fp64 rate"] if options.peak else []
    print("| " + " | ".join(heads) + " |\n" + "|---" * len(heads) + "|")
    renderers, rows = set(), []
    within = measured = faster = 0
    for path in paths:
        name = os.path.basename(path)
        if time.monotonic() >= jobs.deadline:
            print(f"| {name} | not run |")
            rows.append({"model": name, "result": "not run"})
            continue
        entries = {backend: measure(jobs, program, path, backend) for backend in ("opengl", "cpu")}
        gpu, cpu = entries["opengl"], entries["cpu"]
        if not gpu or not cpu or gpu["backend"] != "opengl":
            print(f"| {name} | no result |")
            rows.append({"model": name, "result": "failed"})
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
        cells = [name, gpu["faces"], f"{gpu['evaluations']} / {gpu['estimate']['evaluations']}", gpu["dispatches"], f"{1e3 * seconds:.2f}",
                 f"{1e3 * cpu['seconds']['integrate']:.2f}", f"{1e-6 * rate:.1f}", f"{whole['opengl']:.2f} / {estimate['opengl']:.2f}",
                 f"{whole['cpu']:.2f} / {estimate['cpu']:.2f}", auto]
        cells += [f"{rate * options.operations / (1e12 * options.peak):.3f}"] if options.peak else []
        print("| " + " | ".join(map(str, cells)) + " |", flush=True)
        rows.append({"model": name, "result": "passed", "evaluations": gpu["evaluations"], "dispatches": gpu["dispatches"],
                     "opengl": gpu["seconds"], "cpu": cpu["seconds"], "estimate": gpu["estimate"]})
    print(f"{within} of {measured} models integrated in less than 3 ms; {', '.join(sorted(renderers))}")
    print(f"the estimate takes the backend that was faster, with its start, for {faster} of {measured} models")
    if any(name in renderer.lower() for renderer in renderers for name in SOFTWARE):
        print("This is a software rasterizer, no GPU: its times say nothing about one.")
    return rows


# Running
# ----------------------------------------------------------------------------------------------------

def probe(program, jobs):
    """The program's table of what the driver computes right."""
    status, text = jobs.run([program, "--opengl-probe"], 120)
    if status == 1 and "opengl-probe" in text and len(text.splitlines()) < 6:
        print("This solidmoments has no --opengl-probe: no table of the driver.")
        return {"status": None, "text": text}
    print(text.rstrip())
    if status != 0:
        print(f"FAILED the probe ends with status {status}")
    return {"status": status, "text": text}


def unpack(archive):
    """Unpacks next to the archive, or where one can write."""
    near = os.path.dirname(os.path.realpath(archive))
    target = near if os.access(near, os.W_OK) else tempfile.mkdtemp()
    shutil.rmtree(os.path.join(target, "solidmoments-gpu"), ignore_errors=True)
    with tarfile.open(archive, "r:xz") as tar:
        tar.extractall(target, **({"filter": "tar"} if hasattr(tarfile, "tar_filter") else {}))
    return os.path.join(target, "solidmoments-gpu")


def describe_machine():
    """Name of the processor, number of threads and C library."""
    name = "?"
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            name = re.search(r"^model name\s*: (.*)$", file.read(), re.M).group(1)
    except (OSError, AttributeError):
        pass
    return f"{name}, {os.cpu_count()} threads, {os.confstr('CS_GNU_LIBC_VERSION')}, Python {sys.version.split()[0]}"


def run(options):
    begin = time.monotonic()
    folder = unpack(options.build) if os.path.isfile(options.build) else os.path.realpath(options.build)
    is_pack = os.path.exists(os.path.join(folder, "tests.json"))
    output = os.path.realpath(options.output or os.path.join(folder, "output" if is_pack else "Testing/output/gpu"))
    shutil.rmtree(os.path.join(output, "tests"), ignore_errors=True)
    os.makedirs(output, exist_ok=True)
    only = "(?!)" if options.no_tests else options.only
    if is_pack:
        with open(os.path.join(folder, "tests.json"), encoding="utf-8") as file:
            content = json.load(file)
        choose_libraries(folder, content.get("versions", {}))
        content["tests"] = [test for test in content["tests"] if re.search(only, test["name"])]
        places = {name: os.path.join(folder, name) for name in ("bin", "build", "source", "common")}
        places["shared"] = os.path.realpath(options.shared) if options.shared else ""
    else:
        catalogue = Catalogue(folder, only)
        content = {"commit": "", "tests": catalogue.tests, "setups": catalogue.setups, "left_out": catalogue.left_out}
        places = catalogue.get_places(output)
    needed = {fixture for test in content["tests"] for fixture in test["required"]}
    setups = [setup for setup in content["setups"] if needed & set(setup["setup"]) or any(
        set(setup["setup"]) & set(other["required"]) for other in content["setups"] if needed & set(other["setup"]))]
    absent = []
    if not places["shared"]:
        names = {fixture for setup in setups if "{shared}" in " ".join(setup["command"]) for fixture in setup["setup"]}
        absent = [test for test in content["tests"] if names & set(test["required"]) or "{shared}" in " ".join(test["command"])]
        content["tests"] = [test for test in content["tests"] if test not in absent]
        setups = [setup for setup in setups if not names & set(setup["setup"])]
    program = os.path.join(places["bin"], "solidmoments")
    samples = [os.path.join(places["source"], "Examples", "Models", name) for name in ("sample_part.step", "free_form_part.step")]
    options.files = [unpack_model(path, output) for path in options.files]
    models = options.files or (sorted(os.path.join(folder, "models", name) for name in os.listdir(os.path.join(folder, "models")))
                               if is_pack else [])
    certified = os.path.join(places["source"], "Examples", "Certified", "solids")
    compared = [] if options.no_compare else samples + sorted(
        os.path.join(certified, name) for name in os.listdir(certified) if name.endswith(".step") and re.search(options.solids, name)) + models
    measured = [] if options.no_speed else models + samples
    jobs = Jobs(options.jobs or os.cpu_count() or 1, make_environment(folder if is_pack else None, output))
    end = begin + options.seconds if options.seconds else float("inf")
    jobs.deadline = end
    report = {"machine": describe_machine(), "commit": content["commit"], "left_out": content["left_out"],
              "without_shared": [test["name"] for test in absent]}
    print(f"{report['machine']}; {'commit ' + report['commit'] if report['commit'] else folder}", flush=True)
    report["probe"] = probe(program, jobs)
    report["comparison"] = compare_models(compared, program, jobs, options.relative) if compared else []
    sys.stdout.flush()
    if measured and options.seconds:
        # A fifth of the time is kept for what is measured alone.
        jobs.deadline = end - 0.2 * options.seconds
    report["tests"] = run_tests(content["tests"], setups, jobs, places, output, options.lines) if content["tests"] else []
    if content["left_out"] and content["tests"]:
        print(f"{len(content['left_out'])} value tests are left out, since they import Python modules of VTK: {', '.join(content['left_out'])}")
    if absent:
        print(f"{len(absent)} value tests are left out, since they read real files (--shared): {', '.join(test['name'] for test in absent)}")
    sys.stdout.flush()
    jobs.deadline = end
    report["speed"] = measure_models(measured, program, jobs, options) if measured else []
    report["seconds"] = round(time.monotonic() - begin, 1)
    path = options.json or os.path.join(output, "report.json")
    with open(path, "w", encoding="utf-8") as file:
        json.dump(report, file, indent=1)
    bad = [row for key in ("comparison", "tests", "speed") for row in report[key] if row["result"] != "passed"]
    passed = not bad and report["probe"]["status"] in (0, None)
    print(f"{'passed' if passed else 'FAILED'} after {report['seconds']} s; {path}")
    return 0 if passed else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("run", "pack"))
    parser.add_argument("build", help="a build folder, an archive, or a folder with one's content")
    parser.add_argument("files", nargs="*", help="for pack, first the archive; then models")
    parser.add_argument("--only", default="", help="a regular expression for the names of tests")
    parser.add_argument("--no-tests", action="store_true")
    parser.add_argument("--limit", type=float, default=40, help="pack: the largest size of the archive in MB")
    parser.add_argument("--preset", type=int, default=9, help="pack: xz's preset, 0 (fast) to 9")
    parser.add_argument("--shared", help="run: the folder ../shared with the real files that some tests read")
    parser.add_argument("--jobs", type=int, help="run: tests at a time; default: as many as there are threads")
    parser.add_argument("--seconds", type=float, help="run: ends after this time; what was not run is listed")
    parser.add_argument("--output", help="run: folder for what tests write")
    parser.add_argument("--json", help="run: the report")
    parser.add_argument("--lines", type=int, default=5, help="run: lines printed of a test that failed")
    parser.add_argument("--relative", type=float, default=1e-14, help="run: allowed difference of volumes of both backends")
    parser.add_argument("--no-compare", action="store_true", help="run: leaves out the comparison of both backends")
    parser.add_argument("--solids", default="", help="run: a regular expression for the names of certified solids")
    parser.add_argument("--no-speed", action="store_true", help="run: measures nothing")
    parser.add_argument("--peak", type=float, help="double precision rate of the GPU in 10^12 operations a second")
    parser.add_argument("--operations", type=float, default=OPERATIONS, help="floating-point operations of an evaluation")
    options = parser.parse_intermixed_args()
    if options.what == "run":
        return run(options)
    if not options.files:
        parser.error("pack needs the name of the archive")
    options.archive = options.files.pop(0)
    return pack(options)


if __name__ == "__main__":
    sys.exit(main())

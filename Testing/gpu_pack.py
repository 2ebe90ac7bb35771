"""The tests of a build, and the archive of them that gpu.py runs on a machine with a GPU.

Stays where the build is.
"""
import json
import lzma
import os
import re
import shutil
import subprocess
import tarfile
import tempfile

import gpu

# The other machine's own: the C library, and OpenGL with what its driver brings.
SYSTEM = re.compile(r"^(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|util|nsl|GL|GLX|EGL|OpenGL|GLdispatch|GLESv2|drm|gbm)\.so.*)$")
# Libraries that drivers may use, too, so that the machine's own are taken where they are as new as the packed
# ones: all but these.
OWN = re.compile(r"^lib(sm|vtk|TK)")
# Replaced by libraries whose functions end the process when they are called: OpenCASCADE's viewer and VTK
# would read pictures with them, which no test does. They bring 25 others.
EMPTY = ("libfreeimage.so.3", "libtiff.so.6")
# Loaded when something is wanted of them.
ON_DEMAND = ("libsmRenderingOpenGL.so", "libsmExtras.so")
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
                       for match in re.findall(re.escape(build) + r"/Testing/(output/[^/' ]+|models)", word)
                       if match != f"output/{entry['name']}"}
        for entry in self.tests + self.setups:
            for part in ("command", "environment"):
                entry[part] = [self.abstract(word, entry["name"]) for word in entry[part]]
        # What users of a GPU want to know first, and what takes long.
        self.tests.sort(key=lambda test: (bool(test["required"]), "gpu" not in test["labels"], -test["cost"], test["name"]))

    def abstract(self, word, test):
        """A word of a test's command with placeholders for folders."""
        if re.search(r"/python[0-9.]*$", word) and " " not in word:
            return "{python}"
        for folder in sorted(self.common, key=len, reverse=True):
            word = re.sub(re.escape(f"{self.build}/Testing/{folder}") + r"(?![\w.-])", "{common}/" + folder.split("/")[-1], word)
        shared = os.path.join(self.source, "..", "shared")
        output = f"{self.build}/Testing/output"
        for path, placeholder in ((f"{output}/{test}", "{output}"), (output, "{output}"), (f"{self.build}/bin/", "{bin}/"), (self.build, "{build}"),
                                  (shared, "{shared}"), (os.path.realpath(shared), "{shared}"), (self.source, "{source}")):
            word = word.replace(path, placeholder)
        return word

    def get_places(self, output):
        return {"bin": os.path.join(self.build, "bin"), "build": self.build, "source": self.source,
                "shared": os.path.realpath(os.path.join(self.source, "..", "shared")), "common": os.path.join(output, "common")}

    def get_words(self):
        return [word for entry in self.tests + self.setups for word in entry["command"] + entry["environment"]]


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
                if name not in EMPTY and (name in gpu.LOADER or not SYSTEM.match(name)):
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
        command = [gpu.fill(word, places) for word in setup["command"]]
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


def pack(options):
    build = os.path.realpath(options.build)
    catalogue = Catalogue(build, options.only if not options.no_tests else "(?!)")
    with tempfile.TemporaryDirectory() as folder:
        for part in ("bin", "programs", "lib/loader", "lib/system", "models", "common", "build", "source"):
            os.makedirs(os.path.join(folder, part))
        programs = {"solidmoments", "solidmoments-kernel"} | {
            name for word in catalogue.get_words() for name in re.findall(r"\{bin\}/([\w.-]+)", word)}
        libraries, needed, versions = {}, {}, {}
        for name in sorted(programs):
            program = os.path.join(build, "bin", name)
            find_libraries(program, libraries, needed)
            copy_stripped(program, os.path.join(folder, "programs", name))
            with open(os.path.join(folder, "bin", name), "w", encoding="utf-8") as file:
                file.write(LAUNCHER % name)
            os.chmod(os.path.join(folder, "bin", name), 0o755)
        for name in ON_DEMAND:
            libraries[name] = os.path.join(build, "lib", name)
            find_libraries(libraries[name], libraries, needed)
        for name, path in libraries.items():
            if name in EMPTY:
                make_empty(path, os.path.join(folder, "lib", name), [user for user, names in needed.items() if name in names])
            elif name in gpu.LOADER:
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
                gpu.unpack_model(path, os.path.join(folder, "models"))
            else:
                shutil.copy2(path, os.path.join(folder, "models"))
        commit = subprocess.run(["git", "describe", "--always", "--dirty"], cwd=catalogue.source, stdout=subprocess.PIPE,
                                stderr=subprocess.DEVNULL, encoding="utf-8", check=False).stdout.strip()
        with open(os.path.join(folder, "tests.json"), "w", encoding="utf-8") as file:
            json.dump({"commit": commit, "tests": catalogue.tests, "setups": catalogue.setups, "left_out": catalogue.left_out,
                       "versions": versions}, file, indent=1)
        shutil.copy2(os.path.realpath(gpu.__file__), os.path.join(folder, "gpu.py"))
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

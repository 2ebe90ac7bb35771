"""TestInputFiles.py MODE --program P --output DIR: compressed files, folders and the standard input; the manual page and the completion."""
import argparse
import functools
import gzip
import os
import re
import shutil
import subprocess
import sys
import zipfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
import smprogram  # noqa: E402
from smcheck import check_equal, check_true, finish  # noqa: E402
from smproduct import Part, write_product  # noqa: E402

parser = argparse.ArgumentParser()
parser.add_argument("mode", choices=["inputs", "help"])
for name in ("--program", "--output"):
    parser.add_argument(name, required=True)
options = parser.parse_args()
folder = os.path.join(options.output, "input_files")
os.makedirs(folder, exist_ok=True)

run = functools.partial(smprogram.run, options.program)
run_json = functools.partial(smprogram.run_json, options.program)


def inputs():
    """Compressed files and the standard input: the numbers of the plain file, and no copy is left."""
    path = write_product(os.path.join(folder, "input.step"), Part("plate", [((0, 0, 0), (2, 1, "0.25"))], "2700.", "kg/m^3", "inch"))
    with open(path, "rb") as file:
        content = file.read()
    volume = run_json(path)["total"]["volume"]
    temporary = os.path.join(folder, "temporary")
    os.makedirs(temporary, exist_ok=True)
    os.environ["TMPDIR"] = temporary
    packed = gzip.compress(content)

    def write(name, data):
        target = os.path.join(folder, name)
        with open(target, "wb") as file:
            file.write(data)
        return target

    def zip_up(name, members, method):
        target = os.path.join(folder, name)
        with zipfile.ZipFile(target, "w", method) as archive:
            for member, data in members:
                archive.writestr(member, data)
        return target
    members = [("docs/readme.txt", b"x" * 1000), ("parts/a.STEP", content)]
    for name in (write("a.step.gz", packed), write("b.stpz", packed), write("gzip without a name", packed), write("two.stpz", gzip.compress(content[:999]) +
                 gzip.compress(content[999:])), zip_up("c.stpz", members, zipfile.ZIP_DEFLATED), zip_up("d.zip", members, zipfile.ZIP_STORED)):
        file = run_json("--validate", "--bom", name)
        check_equal("file, volume, messages", (name, volume, []), (file["file"], file["total"]["volume"], file["messages"]))
    for data in (content, packed):
        result = subprocess.run([options.program, "--print", "volume", "-"], input=data, stdout=subprocess.PIPE, timeout=200, check=False)
        check_equal("from the standard input", (0, volume), (result.returncode, float(result.stdout or "nan")))
    for name, said in ((write("cut.step.gz", packed[:-200]), "ends in the middle"), (write("bad.step.gz", packed[:500] + b"!" * 99 + packed[600:]), "damaged"),
                       (zip_up("none.zip", members[:1], zipfile.ZIP_STORED), "0 STEP or BREP files"), (write("cut.zip", b"PK\x03\x04" + bytes(40)), "damaged"),
                       (zip_up("both.zip", members + [("b.stp", content)], zipfile.ZIP_DEFLATED), "2 STEP or BREP files"),
                       (write("text.step.gz", gzip.compress(b"no STEP file")), "text.step.gz")):
        file = run_json(name, status=2)
        check_true("it says why", file["status"] == "unreadable" and any(said in text for text in file["messages"]), str(file["messages"]))
        check_true("by the name that was given", not any(temporary in text for text in file["messages"]), str(file["messages"]))
    check_equal("no copy is left", [], os.listdir(temporary))
    nowhere = os.path.join(folder, "nowhere")
    for data, given, said in ((b"", temporary, "it is empty; write a STEP or BREP file to the standard input"),
                              (content, nowhere, f"its content cannot be kept in the folder for temporary files, {nowhere} (No such file or directory); set TMPDIR")):
        result = subprocess.run([options.program, "--quiet", "-"], input=data, stderr=subprocess.PIPE, env=dict(os.environ, TMPDIR=given), timeout=200, check=False)
        check_equal("standard input: exit status", 2, result.returncode)
        check_true("standard input: it says why", said in result.stderr.decode(), result.stderr.decode())
    result = subprocess.run([options.program, "--quiet", write("packed.step.gz", packed)], stderr=subprocess.PIPE, env=dict(os.environ, TMPDIR=nowhere), timeout=200, check=False)
    check_true("a packed file without TMPDIR", result.returncode == 2 and f"{nowhere} (No such file" in result.stderr.decode(), result.stderr.decode())
    # A folder stands for the STEP files in it, but not for those of its folders.
    shelf = os.path.join(folder, "shelf")
    os.makedirs(os.path.join(shelf, "below"), exist_ok=True)
    for name in ("b.STP", "a.step", "notes.txt", "below/c.step"):
        shutil.copy(path, os.path.join(shelf, name))
    with open(os.path.join(shelf, "c.step.gz"), "wb") as file:
        file.write(packed)
    result = run("--print", "file,volume", shelf)
    check_equal("files of a folder", [f"{os.path.join(shelf, name)} {volume!r}" for name in ("a.step", "b.STP", "c.step.gz")], result.stdout.splitlines())
    # One that may not be read is not an empty one. Root reads every folder, unless the program has not these
    # capabilities.
    os.chmod(shelf, 0)
    without = [f"--{kind}=-dac_override,-dac_read_search" for kind in ("bounding-set", "inh-caps")]
    command = (["setpriv", *without] if os.geteuid() == 0 else []) + [options.program, "--quiet", shelf]
    result = subprocess.run(command, stderr=subprocess.PIPE, timeout=200, check=False)
    os.chmod(shelf, 0o755)
    check_true("a folder that may not be read", result.returncode == 2 and "may not be read" in result.stderr.decode(), result.stderr.decode())


def help_pages():
    """-V, the manual page and the completion."""
    version = run("-V")
    check_true("-V", version.returncode == 0 and version.stdout == run("--version").stdout and version.stdout.startswith("solidmoments "))
    names = sorted(set(re.findall(r"(?<![\w-])--[a-z-]+", run("--help").stdout)))
    check_true("options", len(names) > 40, str(names))
    with open(os.path.join(os.path.dirname(options.program), "..", "Examples", "solidmoments", "solidmoments.1"), encoding="utf-8") as file:
        manual = file.read()
    check_equal("options that the manual page lacks", [], [name for name in names if name.replace("-", "\\-") not in manual])
    check_true("no line is taken for a request", all(line.startswith((".TH ", ".SH ", ".nf", ".fi")) for line in manual.splitlines() if line[:1] in (".", "'")))
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "solidmoments", "solidmoments.bash")

    def complete(*words):
        code = (f'. "{script}"; COMP_WORDS=({options.program} {" ".join(words)}); COMP_CWORD={len(words)}; _solidmoments; '
                'printf "%s\\n" "${COMPREPLY[@]}"')
        return subprocess.run(["bash", "-c", code], stdout=subprocess.PIPE, encoding="utf-8", timeout=60, check=True).stdout.split()
    check_equal("all options", names, sorted(set(complete("--"))))
    check_equal("one of them", ["--validate", "--validation-limit"], sorted(set(complete("--val"))))
    check_equal("values", ["mm", "m"], [word for word in complete("--unit", "m")])
    check_equal("files", [script], complete(script[:-3]))


{"inputs": inputs, "help": help_pages}[options.mode]()
finish()

"""TestSavedResults.py MODE --program P --solids DIR --output DIR --sample FILE: what is left of a run that does not reach its end.

outputs   signals, full disks and limits of files: every output is whole, and has the files that were finished
stages    a job that ends in the middle: what it had computed, and whose fault it is
limits    --max-seconds and limited memory
"""
import argparse
import csv
import json
import os
import pty
import resource
import shutil
import signal
import subprocess
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check, check_equal, check_true, finish  # noqa: E402

parser = argparse.ArgumentParser()
parser.add_argument("mode", choices=["outputs", "stages", "limits"])
for name in ("--program", "--solids", "--output", "--sample"):
    parser.add_argument(name, required=True)
options = parser.parse_args()
manifest = Manifest(options.solids)
GOOD = manifest.solid("box")["path"]
MANY = 300


def make_folder(name):
    folder = os.path.join(options.output, name)
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    return folder


def run(*arguments, prepare=None, **more):
    """`prepare` runs in the new process before the program."""
    return subprocess.run([options.program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8", timeout=300,
                          check=False, preexec_fn=prepare, **more)


def children_of(process):
    with open(f"/proc/{process.pid}/task/{process.pid}/children", encoding="ascii") as file:
        return [int(child) for child in file.read().split()]


def child_of(process):
    children = children_of(process)
    return children[0] if children else None


def read_text(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def read_json(path):
    return json.loads(read_text(path))["files"]


def count_totals(path):
    with open(path, encoding="utf-8", newline="") as file:
        return sum(row["row"] == "total" for row in csv.DictReader(file))


def leftovers(folder):
    return [name for name in os.listdir(folder) if "saving" in name]


def check_signal(number, tables):
    """The signal comes when so many tables are there."""
    folder = make_folder("saved")
    paths = [os.path.join(folder, name) for name in ("out.json", "out.csv")]
    with subprocess.Popen([options.program, "--json", paths[0], "--csv", paths[1], *[GOOD] * MANY], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, encoding="utf-8",
                          preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_DFL)) as process:
        seen = 0
        for line in process.stdout:
            seen += line.startswith(GOOD)
            if seen == tables:
                break
        process.send_signal(number)
        process.communicate(timeout=100)
    what = f"{signal.Signals(number).name} after {tables} tables"
    check_equal(what + ": ended by", -number, process.returncode)
    for path, count in ((paths[0], lambda path: len(read_json(path))), (paths[1], count_totals)):
        finished = count(path)
        check_true(f"{what}: {os.path.basename(path)} has the finished files", tables <= finished < MANY, str(finished))
    if number != signal.SIGKILL:
        check_equal(what + ": temporary files", [], leftovers(folder))


def check_hangup_that_is_ignored():
    folder = make_folder("nohup")
    path = os.path.join(folder, "out.json")
    with subprocess.Popen([options.program, "--json", path, GOOD, GOOD, GOOD], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                          preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN)) as process:
        process.stdout.readline()
        process.send_signal(signal.SIGHUP)
        process.communicate(timeout=100)
    check_equal("nohup: exit status", 0, process.returncode)
    check_equal("nohup: files", 3, len(read_json(path)))


def check_reader_of_the_table_that_has_gone():
    folder = make_folder("pipe")
    path = os.path.join(folder, "out.json")
    with subprocess.Popen([options.program, "--json", path, GOOD, GOOD, GOOD], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        process.stdout.close()
        complaint = process.stderr.read()
        process.wait(timeout=100)
    check_equal("a closed pipe: exit status", 1, process.returncode)
    check_true("a closed pipe: it says so", b"standard output" in complaint, str(complaint))
    check_equal("a closed pipe: files", 3, len(read_json(path)))


def check_file_limit():
    """ulimit -f: the JSON of one file fits, that of all does not."""
    folder = make_folder("limit")
    target, picture = (os.path.join(folder, name) for name in ("out.json", "out.png"))
    check_equal("one file: exit status", 0, run("--json", target, GOOD).returncode)
    size = os.path.getsize(target)
    with open(picture, "w", encoding="ascii") as file:
        file.write("as before")
    limit = 2 * size + size // 2
    done = run("--json", target, *[GOOD] * 5, prepare=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
    check_equal("ulimit -f: exit status", 1, done.returncode)
    check_true("ulimit -f: it says so", "out.json cannot be written" in done.stderr and "first 2 files" in done.stderr, done.stderr)
    check_equal("ulimit -f: the files that fit", 2, len(read_json(target)))
    check_equal("ulimit -f: tables", 5, done.stdout.count(GOOD))
    done = run("-q", "--png", picture, options.sample, prepare=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4000, 4000)))
    check_equal("ulimit -f: exit status of a picture", 1, done.returncode)
    check_true("ulimit -f: why", "no picture" in done.stderr and "too large" in done.stderr, done.stderr)
    with open(picture, encoding="latin-1") as file:
        check_equal("ulimit -f: the picture that was there", "as before", file.read())
    # Writers of VTK that do not report that their file is cut.
    for extension in ("obj", "ply", "stl", "vtp"):
        mesh = os.path.join(folder, "out." + extension)
        with open(mesh, "w", encoding="ascii") as file:
            file.write("as before")
        done = run("-q", "--mesh", mesh, options.sample, prepare=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4000, 4000)))
        check_equal(f"ulimit -f: exit status of a mesh, {extension}", 1, done.returncode)
        check_true(f"ulimit -f: why, {extension}", "no mesh" in done.stderr, done.stderr)
        with open(mesh, encoding="latin-1") as file:
            check_equal(f"ulimit -f: the mesh that was there, {extension}", "as before", file.read())
    check_equal("ulimit -f: temporary files", [], leftovers(folder))


def check_full_disk():
    for flag in ("--json", "--csv"):
        done = run(flag, "/dev/full", GOOD)
        check_equal(f"{flag} /dev/full: exit status", 1, done.returncode)
        check_true(f"{flag} /dev/full: why", "/dev/full cannot be written" in done.stderr and "No space" in done.stderr, done.stderr)
        check_true(f"{flag} /dev/full: the table", "volume" in done.stdout)
    # A disk of a few pages, in a namespace of its own.
    folder = make_folder("disk")
    script = ('mount -t tmpfs -o size=16k none "$1" && cd "$1" && { "$0" -q --json out.json "$2" "$2" "$2" "$2" "$2" "$2" "$2" "$2"; '
              'echo "exit $?"; ls; cat out.json; }')
    done = subprocess.run(["unshare", "-rm", "sh", "-c", script, options.program, folder, GOOD], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, encoding="utf-8", timeout=300, check=False)
    if "exit " not in done.stdout:
        print("not checked: no small disk can be mounted here:", done.stderr.strip())
        return
    head, text = done.stdout.split("{", 1)
    check_equal("full disk: exit status and files", ["exit", "1", "out.json"], head.split())
    check_true("full disk: it says so", "No space" in done.stderr, done.stderr)
    check_true("full disk: the files that fit", 1 <= len(json.loads("{" + text)["files"]) < 8, text[:200])


def check_streams():
    """Devices, pipes and open files are written directly."""
    done = subprocess.run(["sh", "-c", '"$0" -q --json /dev/stdout "$1" | cat; "$0" -q --json /dev/null "$1" && echo " fine"',
                           options.program, GOOD], stdout=subprocess.PIPE, encoding="utf-8", timeout=100, check=False)
    text, _, end = done.stdout.rpartition("}")
    check_equal("/dev/stdout: files", 1, len(json.loads(text + "}")["files"]))
    check_equal("/dev/null", "fine", end.strip())
    folder = make_folder("modes")
    path = os.path.join(folder, "out.json")
    with open(path, "w", encoding="ascii"):
        pass
    os.chmod(path, 0o640)
    os.symlink("out.json", os.path.join(folder, "link.json"))
    check_equal("a link: exit status", 0, run("-q", "--json", os.path.join(folder, "link.json"), GOOD).returncode)
    check_true("a link stays", os.path.islink(os.path.join(folder, "link.json")))
    check_equal("its file is written", 1, len(read_json(path)))
    check_equal("with the permissions it had", 0o640, os.stat(path).st_mode & 0o777)


def check_several_at_a_time():
    """--jobs: the outputs of one at a time, in the same order, whatever ends first; what is finished behind a job that is interrupted."""
    folder = make_folder("jobs")
    good = [options.sample, GOOD, manifest.special("assembly")["path"], os.path.join(folder, "missing.step"), GOOD]
    texts = []
    for jobs in ("1", "3", "0"):
        table = os.path.join(folder, f"out-{jobs}.csv")
        done = run("-j", jobs, "--backend", "cpu", "--csv", table, "--fields", "file,row,name,status,volume,volume_bound,center_x",
                   "--print", "volume,volume_bound", *good)
        check_equal(f"{jobs} at a time: exit status", 2, done.returncode)
        with open(table, encoding="utf-8", newline="") as file:
            texts.append(done.stdout + file.read())
    check_true("the same output for every number of jobs", texts[0] == texts[1] == texts[2] and texts[0].count("\n") > 8, texts[0][:300])

    target = os.path.join(folder, "out.json")
    with subprocess.Popen([options.program, "-q", "--jobs", "2", "--json", target, "--backend", "cpu", "--moments", "16", options.sample, GOOD, GOOD, GOOD],
                          stderr=subprocess.PIPE, encoding="utf-8") as process:
        child = None
        while child is None and process.poll() is None:
            child = child_of(process)
        os.kill(child, signal.SIGSTOP)
        # The other files are read meanwhile, too fast to be seen: at last the stopped child is alone for 3 s.
        alone = time.monotonic()
        while time.monotonic() < alone + 3.0:
            alone = alone if len(children_of(process)) == 1 else time.monotonic()
            time.sleep(0.01)
        process.send_signal(signal.SIGTERM)
        complaint = process.communicate(timeout=100)[1]
    check_equal("interrupted: ended by", -signal.SIGTERM, process.returncode)
    check_equal("interrupted: files that were finished", [GOOD] * 3, [entry["file"] for entry in read_json(target)])
    check_true("interrupted: how many", "3 of 4 files" in complaint, complaint)
    check_equal("wrong number: exit status", 1, run("-j", "-1", GOOD).returncode)

    # The result of a file is written before the next file, which may come late, is read.
    target = os.path.join(folder, "early.csv")
    with subprocess.Popen([options.program, "-q", "--backend", "cpu", "--csv", target, GOOD, "-"], stdin=subprocess.PIPE) as process:
        deadline = time.monotonic() + 100
        while not (os.path.exists(target) and GOOD in read_text(target)) and time.monotonic() < deadline:
            time.sleep(0.05)
        told = read_text(target)
        with open(GOOD, "rb") as file:
            process.communicate(file.read(), timeout=100)
    check_true("a file is reported before standard input ends", GOOD in told)
    check_true("standard input, too", read_text(target).count("\n") > told.count("\n"))


def outputs():
    check_several_at_a_time()
    for number in (signal.SIGHUP, signal.SIGTERM, signal.SIGINT, signal.SIGKILL):
        for tables in (1, 4):
            check_signal(number, tables)
    check_hangup_that_is_ignored()
    check_reader_of_the_table_that_has_gone()
    check_file_limit()
    check_full_disk()
    check_streams()


def run_and_kill(stage, number, *arguments):
    """Kills the child when the progress on the terminal names the stage. Returns the exit status and what the terminal showed."""
    terminal, end = pty.openpty()
    with subprocess.Popen([options.program, *arguments], stdout=subprocess.PIPE, stderr=end) as process:
        os.close(end)
        shown = ""
        while f" {stage} " not in shown:
            shown += os.read(terminal, 4096).decode()
        os.kill(child_of(process), number)
        process.communicate(timeout=100)
    os.close(terminal)
    return process.returncode


def check_stage(stage, number, *arguments):
    target = os.path.join(make_folder("stages"), "out.json")
    code = run_and_kill(stage, number, "--json", target, *arguments, GOOD, manifest.solid("torus")["path"])
    return code, read_json(target)[0]


def stages():
    box = manifest.solid("box")
    # Shaders of hundreds of integrals take minutes to compile.
    code, entry = check_stage("integrals", signal.SIGSEGV, "--moments", "16", "--backend", "opengl", "--max-seconds", "40")
    message = entry["messages"][-1]
    check_equal("integrals: exit status", 3, code)
    check_equal("integrals: status", "not-computed", entry["status"])
    check("integrals: volume", box["volume"], entry["total"]["volume"], 1e-9 * box["volume"])
    check_true("integrals: the bound", entry["total"]["bounds"]["volume"] < 1e-6 * box["volume"])
    check_equal("integrals: none", {"value": None, "bound": None}, entry["integrals"]["moment_0_0_16"])
    check_equal("integrals: none of the solid", 969, len(entry["solids"][0]["integrals"]))
    check_true("integrals: where", 'in stage "integrals"' in message and "signal 11" in message, message)
    check_true("integrals: not the file's fault", "none of the file" in message and "malformed" not in message, message)

    code, entry = check_stage("integrals", signal.SIGXCPU, "--moments", "16", "--backend", "opengl", "--max-seconds", "40")
    message = entry["messages"][-1]
    check_equal("processor time: status", "not-computed", entry["status"])
    check_true("processor time: why", "ulimit -t" in message and "defect" not in message, message)

    # The system sends SIGKILL when memory runs out: neither the file nor the program is at fault.
    code, entry = check_stage("integrals", signal.SIGKILL, "--moments", "16", "--backend", "opengl", "--max-seconds", "40")
    message = entry["messages"][-1]
    check_equal("killed: status", "not-computed", entry["status"])
    check_true("killed: why", "memory" in message and "defect" not in message and "malformed" not in message, message)

    target = os.path.join(make_folder("drawing"), "out.json")
    picture = os.path.join(os.path.dirname(target), "out.png")
    code = run_and_kill("draw", signal.SIGKILL, "--json", target, "--png", picture, GOOD)
    entry = read_json(target)[0]
    text = "\n".join(entry["messages"])
    check_equal("draw: exit status", 1, code)
    check_equal("draw: status", "ok", entry["status"])
    check("draw: volume", box["volume"], entry["total"]["volume"], 1e-9 * box["volume"])
    check_true("draw: why", "no picture" in text and "signal 9" in text and "malformed" not in text, text)


def check_job_without_end():
    """A job that hangs, here because it is stopped as soon as it is there, is ended; the next file is computed."""
    target = os.path.join(make_folder("slow"), "out.json")
    with subprocess.Popen([options.program, "-q", "--json", target, "--max-seconds", "10", "--backend", "cpu", options.sample, GOOD],
                          stderr=subprocess.DEVNULL) as process:
        child = None
        while not child:
            child = child_of(process)
        os.kill(child, signal.SIGSTOP)
        process.communicate(timeout=200)
    slow, box = read_json(target)
    text = "\n".join(slow["messages"])
    check_equal("a job without end: exit status", 3, process.returncode)
    check_equal("a job without end: status", "not-computed", slow["status"])
    check_true("a job without end: why", "10 s of --max-seconds" in text and "malformed" not in text, text)
    check_equal("the next file", "ok", box["status"])


def check_no_time():
    done = run("--json", "-", "--max-seconds", "1e-9", GOOD)
    entry = json.loads(done.stdout)["files"][0]
    check_equal("no time: exit status", 3, done.returncode)
    check_equal("no time: status", "not-computed", entry["status"])
    check_true("no time: why", any("maximum seconds" in text for text in entry["messages"]), str(entry["messages"]))
    done = run("--max-seconds", "0", GOOD)
    check_true("0 seconds are none, as in Python", done.returncode == 1 and "above 0" in done.stderr, done.stderr)


def write_many_points():
    """A box with so many points next to it that the index of the file takes most of the memory."""
    text = read_text(GOOD)
    points = "".join(f"#{10 ** 6 + i}=CARTESIAN_POINT('',({i}.,0.,0.));\n" for i in range(150000))
    at = text.rindex("ENDSEC;")
    path = os.path.join(make_folder("scarce"), "points.step")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text[:at] + points + text[at:])
    return path


def check_memory(path, limits_in_megabytes):
    """From too little to enough: a result, or the word memory."""
    said = 0
    for megabytes in limits_in_megabytes:
        limit = megabytes << 20
        done = run("--json", "-", "--backend", "cpu", path,
                   prepare=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
        if not done.stdout.startswith("{"):
            continue  # the program itself does not start
        entry = json.loads(done.stdout)["files"][0]
        text = "\n".join(entry["messages"])
        print(megabytes, entry["status"], ascii(text[:300]))
        if entry["status"] != "ok":
            said += 1
            check_true(f"{megabytes} MB: it says so", "memory" in text, text)
            check_true(f"{megabytes} MB: its status", entry["status"] in ("not-computed", "suspect"), entry["status"])
            check_true(f"{megabytes} MB: not the file's fault", "malformed" not in text and "export it" not in text, text)
    check_true("some limits were too low", said > 0)


def check_stack():
    """A stack that is too small is not the file's fault."""
    said = 0
    for kilobytes in (128, 256, 8192):
        done = run("--json", "-", "--backend", "cpu", options.sample,
                   prepare=lambda: resource.setrlimit(resource.RLIMIT_STACK, (kilobytes << 10, kilobytes << 10)))
        entry = json.loads(done.stdout)["files"][0] if done.stdout.startswith("{") else None
        if entry and entry["status"] != "ok":
            said += 1
            text = "\n".join(entry["messages"])
            check_equal(f"a stack of {kilobytes} kB: status", "not-computed", entry["status"])
            check_true(f"a stack of {kilobytes} kB: why", f"a stack of {kilobytes} kB (ulimit -s)" in text and "malformed" not in text, text)
    check_true("some stacks were too small, and 8 MB are enough", said > 0 and entry["status"] == "ok")


def limits():
    check_job_without_end()
    check_stack()
    check_no_time()
    check_memory(manifest.special("assembly")["path"], range(52, 401, 12))
    check_memory(write_many_points(), range(56, 241, 8))


globals()[options.mode]()
finish()

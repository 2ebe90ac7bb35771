"""What gpu.py's `run` makes of tests and models that pass, fail, are skipped, take too long or differ: TestGPUScript.py GPU.PY

A pack of scripts takes the place of the programs, so that every kind of failure is seen to be reported.
"""
import json
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check, check_equal, check_true, finish  # noqa: E402

SCRIPT = os.path.abspath(sys.argv[1])
# Stands in for solidmoments: one entry for a file, which holds what the entry says of each backend.
PROGRAM = r"""#!/usr/bin/env python3
import json, os, sys
if "--opengl-probe" in sys.argv:
    print(os.environ.get("PROBE_TEXT", "unknown option --opengl-probe"))
    sys.exit(int(os.environ.get("PROBE_STATUS", "1")))
backend = sys.argv[sys.argv.index("--backend") + 1]
entries = []
for path in sys.argv[5:]:
    with open(path) as file:
        said = json.load(file)
    marker = path + ".once"
    again = backend == "opengl" and os.path.exists(marker)
    open(marker, "w").close()
    said = dict(said, **said.get(backend, {}), **(said.get("again", {}) if again else {}))
    if said.get("crash"):
        os.abort()
    volume = said["volume"]
    entries.append({"file": path, "status": said.get("status", "ok"), "backend": said.get("ran", backend), "renderer": "none",
        "messages": [], "faces": 6, "evaluations": 100, "dispatches": 3, "seconds": {"start": 0.1, "upload": 0.1, "integrate": 0.001},
        "estimate": {"evaluations": 90, "cpu_seconds": 0.1, "opengl_seconds": 0.2},
        "total": {"volume": volume, "area": 6.0, "bounds": {"volume": said.get("bound", 1e-9)},
                  "bounds_measured": {"volume": said.get("measured", 1e-15)}}})
print(json.dumps({"files": entries}))
"""
DISPATCH = "import os; open(os.environ['SOLIDMOMENTS_DISPATCH_LOG'], 'a').write('{}\\tCard\\t4.5\\n')"


def make_pack(folder, tests, models, setups=()):
    """Writes a pack of the given Python one-liners and models."""
    for name in ("bin", "models", "source/Examples/Models", "source/Examples/Certified/solids"):
        os.makedirs(os.path.join(folder, name))
    program = os.path.join(folder, "bin", "solidmoments")
    with open(program, "w", encoding="utf-8") as file:
        file.write(PROGRAM)
    os.chmod(program, 0o755)
    for name in ("sample_part", "free_form_part"):
        with open(os.path.join(folder, "source/Examples/Models", name + ".step"), "w", encoding="utf-8") as file:
            json.dump({"volume": 1.0}, file)
    for name, content in models.items():
        with open(os.path.join(folder, "models", name + ".step"), "w", encoding="utf-8") as file:
            json.dump(content, file)

    def entry(name, code, required=(), setup=(), timeout=60):
        return {"name": name, "command": ["{python}", "-c", code], "environment": ["MARK={output}"], "labels": ["value"], "timeout": timeout,
                "setup": list(setup), "required": list(required), "cost": 0}

    with open(os.path.join(folder, "tests.json"), "w", encoding="utf-8") as file:
        json.dump({"commit": "abc", "left_out": ["Imported"], "tests": [entry(*test) for test in tests],
                   "setups": [entry(*setup) for setup in setups]}, file)


def run(tests, models, *options, setups=(), environment=None):
    """(status, what it printed, the report)."""
    with tempfile.TemporaryDirectory() as folder:
        make_pack(folder, tests, models, setups)
        done = subprocess.run([sys.executable, SCRIPT, "run", folder, *options], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              encoding="utf-8", env=dict(os.environ, **(environment or {})), check=False)
        path = os.path.join(folder, "output", "report.json")
        report = None
        if os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                report = json.load(file)
        print(f"$ run {' '.join(options)} -> {done.returncode}\n{done.stdout}")
        return done.returncode, done.stdout, report


GOOD = [("Plain", "print('nothing')"), ("Shader", DISPATCH.format("smPanelCS 1x1")), ("Probe", DISPATCH.format("smProbeCS"))]

status, text, report = run(GOOD, {"cube": {"volume": 8.0}})
check_equal("all passed", 0, status)
check_true("counts", "3 tests found, 1 reached a shader, 3 passed, 0 failed, 0 skipped, 0 not run" in text)
check_true("the renderer", "1 compute programs on Card, OpenGL 4.5" in text)
check_true("models", "3 models: 3 the same bits twice; 3 volumes of GPU and CPU within 1e-14" in text)
check_true("speed", "| cube.step | 6 | 100 / 90 | 3 | 1.00 | 1.00 | 0.1 |" in text)
check_true("no probe yet", "This solidmoments has no --opengl-probe" in text)
check_true("what is left out", "Imported" in text)
check_equal("the report", ["passed"] * 3, [test["result"] for test in report["tests"]])

# Each kind of failure alone ends with status 1 and is named.
status, text, report = run([*GOOD, ("Broken", "print('FAIL the value'); raise SystemExit(3)")], {}, "--no-speed", "--no-compare")
check_equal("a test failed", 1, status)
check_true("its name, status and line", "FAILED Broken (status 3" in text and "    FAIL the value" in text)
check_true("failures come before the counts", text.index("FAILED Broken") < text.index("4 tests found"))

status, text, report = run([*GOOD, ("Skipping", "raise SystemExit(77)")], {}, "--no-speed", "--no-compare")
check_equal("a test was skipped", 1, status)
check_true("its name", "skipped: Skipping" in text and "1 skipped" in text)

status, text, report = run([*GOOD, ("Endless", "import time; time.sleep(100)", (), (), 1)], {}, "--no-speed", "--no-compare")
check_equal("a test took too long", 1, status)
check_true("its reason", "FAILED Endless (status no end after 1 s" in text)

slow = [(f"Slow{i}", "import time; time.sleep(100)") for i in range(3)]
status, text, report = run(slow, {"cube": {"volume": 8.0}}, "--seconds", "20", "--jobs", "1", "--no-compare")
check_equal("the time was over", 1, status)
check_true("what was not run", "not run: Slow0, Slow1, Slow2" in text and "3 not run" in text)
check_true("within the time", report["seconds"] < 60, str(report["seconds"]))
check_true("models were measured all the same", "| cube.step | 6" in text)

status, text, report = run([("Needs", "pass", ("made",))], {}, "--no-speed", "--no-compare",
                           setups=[("Make", "raise SystemExit(1)", (), ("made",))])
check_equal("a setup failed", 1, status)
check_true("both are named", "FAILED Make" in text and "not run: Needs" in text)
status, text, report = run([("Needs", "import os, sys; sys.exit(not os.path.exists('{common}/made'))", ("made",))], {}, "--no-speed",
                           "--no-compare", setups=[("Make", "open('{common}/made', 'w').close()", (), ("made",))])
check_true("a setup made the input, and counts as the value test that it is", status == 0 and "2 tests found" in text and "2 passed" in text)

status, text, report = run([("Real", "open('{shared}/models/x')"), GOOD[0]], {}, "--no-speed", "--no-compare")
check_equal("a test without its real files is left out", 0, status)
check_true("and named", "1 value tests are left out, since they read real files (--shared): Real" in text)
with tempfile.TemporaryDirectory() as shared:
    os.makedirs(os.path.join(shared, "models"))
    with open(os.path.join(shared, "models", "x"), "w", encoding="utf-8"):
        pass
    status, text, report = run([("Real", "open('{shared}/models/x')")], {}, "--no-speed", "--no-compare", "--shared", shared)
check_true("with them it runs", status == 0 and "1 tests found, 0 reached a shader, 1 passed" in text)

MODELS = {
    "other bits": ({"volume": 8.0, "again": {"volume": 8.0 * (1 + 2 ** -52)}}, "numbers differ between two runs"),
    "far apart": ({"volume": 8.0, "opengl": {"volume": 8.0 * (1 + 1e-13)}}, "volume 8.000000000000"),
    "outside the bounds": ({"volume": 8.0, "bound": 1e-17, "opengl": {"volume": 8.0 * (1 + 2 ** -52)}}, "bounds 2e-17"),
    "no number": ({"volume": 8.0, "opengl": {"volume": None}}, "volume None"),
    "another status": ({"volume": 8.0, "opengl": {"status": "suspect"}}, "status suspect, on the CPU ok"),
    "another backend": ({"volume": 8.0, "opengl": {"ran": "cpu"}}, "no result of opengl"),
    "a crash": ({"volume": 8.0, "opengl": {"crash": True}}, "no result of opengl (status -6)"),
    "far apart in spite of a large error": ({"volume": 8.0, "measured": 1e-10, "opengl": {"volume": 8.0 + 1e-9}}, "allowed 2e-10"),
}
for name, (model, clue) in MODELS.items():
    status, text, report = run([], {"model": model}, "--no-tests", "--no-speed")
    check_equal(f"{name}: exit status", 1, status)
    check_true(f"{name}: its line", "FAILED model.step: " in text and clue in text, clue)
status, text, report = run([], {"wire": {"volume": 8.0, "measured": 1e-10, "opengl": {"volume": 8.0 + 1.6e-10}}}, "--no-tests", "--no-speed")
check_equal("apart within a large measured error", 0, status)
check_true("is named", "wire.step 2e-11 (ill-conditioned)" in text)
check("its difference in the report", 2e-11, report["comparison"][2]["relative"], 1e-15, "rounding of 8 + 1.6e-10")
status, text, report = run([], {"model": {"volume": 8.0, "opengl": {"crash": True}}}, "--no-tests", "--no-compare")
check_true("nothing to measure", status == 1 and "| model.step | no result |" in text)

status, text, report = run([], {}, "--no-tests", "--no-speed", environment={"PROBE_TEXT": "array of doubles | FAIL", "PROBE_STATUS": "3"})
check_true("a probe failed", status == 1 and "array of doubles | FAIL" in text and "FAILED the probe ends with status 3" in text)
status, text, report = run([], {}, "--no-tests", "--no-speed", environment={"PROBE_TEXT": "array of doubles | ok", "PROBE_STATUS": "0"})
check_true("a probe passed", status == 0 and "array of doubles | ok" in text)
finish()

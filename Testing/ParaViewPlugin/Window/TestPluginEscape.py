"""TestPluginEscape.py PARAVIEW PLUGIN.so STEP OUTPUT: Esc stops a long run in ParaView's window, and the next run is whole.

Started without CHILD it drives; ParaView runs it again as its --script, with CHILD set, in its own process.
"""
import json
import os
import subprocess
import sys
import time

child = os.environ.get("SM_ESCAPE_CHILD")
if child:
    # In ParaView: a run that would take hours, and an undisturbed one after it.
    with open(child, encoding="utf-8") as file:
        task = json.load(file)
    from paraview import servermanager, simple

    def run(mass, label):
        texts = []
        handler = servermanager.ActiveConnection.Session.GetProgressHandler()
        tag = handler.AddObserver("ProgressEvent", lambda *_: texts.append(handler.GetLastProgressText()))
        start = time.monotonic()
        mass.UpdatePipeline()
        seconds = time.monotonic() - start
        handler.RemoveObserver(tag)
        fields = servermanager.Fetch(mass, idx=0).GetFieldData()
        return {"seconds": seconds, "texts": sorted(set(texts)), "status": fields.GetAbstractArray("Status").GetValue(0),
                "volume": repr(fields.GetArray("Volume").GetValue(0)),
                "summary": servermanager.Fetch(mass, idx=2).GetValueByName(0, "Text").ToString(), "label": label}

    reader = simple.OpenDataFile(task["part"])
    mass = simple.MassPropertiesGPU(Input=reader, Scheme="3-point Gauss", SubPatchFactor=1024, MaximumEvaluations=10**15)
    with open(task["ready"], "w", encoding="utf-8") as file:
        file.write("ready\n")
    results = [run(mass, "stopped")]
    with open(task["stopped"], "w", encoding="utf-8") as file:
        file.write("stopped\n")
    mass.Scheme = "Adaptive"
    results.append(run(mass, "next"))
    simple.Delete(mass)
    results.append(run(simple.MassPropertiesGPU(Input=reader), "undisturbed"))
    with open(task["results"] + ".part", "w", encoding="utf-8") as file:
        json.dump(results, file)
    os.replace(task["results"] + ".part", task["results"])
    sys.exit(0)

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Support"))
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from smcheck import check_equal, check_true, finish  # noqa: E402
from smx11 import Display  # noqa: E402

paraview, plugin, part, output = sys.argv[1:5]
ESCAPE = 9  # the keycode of every PC keyboard, also of Xvfb's
task = {name: os.path.join(output, "PluginEscape." + name) for name in ("task", "ready", "stopped", "results")}
for path in task.values():
    if os.path.exists(path):
        os.remove(path)
with open(task["task"], "w", encoding="utf-8") as file:
    json.dump(dict(task, part=part), file)
log = open(os.path.join(output, "PluginEscape.log"), "w", encoding="utf-8")
window = subprocess.Popen(
    [paraview, "--dr", "--plugin-search-paths=" + os.path.dirname(plugin), "--plugins=SolidMoments", "--script=" + os.path.abspath(__file__)],
    env=dict(os.environ, SM_ESCAPE_CHILD=task["task"]), stdout=log, stderr=log)
try:
    display = Display()
    deadline = time.monotonic() + 200.0
    tapped = None
    while time.monotonic() < deadline and window.poll() is None and not os.path.exists(task["results"]):
        # One tap, once the run has gone on for a while; more, should that one come before it.
        if os.path.exists(task["ready"]) and (tapped is None or time.monotonic() - tapped > 10.0):
            time.sleep(3.0)
            if not os.path.exists(task["stopped"]):
                display.tap(ESCAPE)
            tapped = time.monotonic()
        time.sleep(0.1)
    if check_true("the script in the window came to its end", os.path.exists(task["results"]), "see PluginEscape.log"):
        with open(task["results"], encoding="utf-8") as file:
            stopped, following, undisturbed = json.load(file)
        check_equal("stopped: status", "tolerance-not-met", stopped["status"])
        check_true("stopped: the summary says why", "the run was aborted" in stopped["summary"], stopped["summary"])
        check_true("stopped: the status bar said how", "Mass Properties (GPU), Esc stops it" in stopped["texts"], str(stopped["texts"]))
        check_equal("the next run: status", "ok", following["status"])
        check_equal("the next run: the bits of an undisturbed one", undisturbed["volume"], following["volume"])
finally:
    window.kill()
    window.wait()
    log.close()
finish()

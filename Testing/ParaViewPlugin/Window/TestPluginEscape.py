"""TestPluginEscape.py PARAVIEW PLUGIN.so STEP OUTPUT: Esc stops a long run in ParaView's window, and the next run is complete.

Without SM_ESCAPE_CHILD it starts ParaView and presses the key; ParaView runs it as its --script with SM_ESCAPE_CHILD set.
"""
import json
import os
import subprocess
import sys
import time

child = os.environ.get("SM_ESCAPE_CHILD")
if child:
    # In ParaView: a run that would take hours, a short one of the same filter, and one of another filter.
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
    mass = simple.MassPropertiesbyPaperSchemes(Input=reader, Scheme="3-point Gauss", SubPatchFactor=1024, MaximumEvaluations=10**15)
    with open(task["ready"], "w", encoding="utf-8") as file:
        file.write("ready\n")
    results = [run(mass, "stopped")]
    with open(task["stopped"], "w", encoding="utf-8") as file:
        file.write("stopped\n")
    mass.SubPatchFactor = 1
    results.append(run(mass, "next"))
    simple.Delete(mass)
    results.append(run(simple.MassPropertiesbyPaperSchemes(Input=reader, Scheme="3-point Gauss", SubPatchFactor=1), "undisturbed"))
    with open(task["results"] + ".part", "w", encoding="utf-8") as file:
        json.dump(results, file)
    os.replace(task["results"] + ".part", task["results"])
    sys.exit(0)

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Support"))
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
        # One key press 3 s after the start, repeated every 10 s in case the first came before the filter
        # listened.
        if os.path.exists(task["ready"]) and (tapped is None or time.monotonic() - tapped > 10.0):
            time.sleep(3.0)
            if not os.path.exists(task["stopped"]):
                display.tap(ESCAPE)
            tapped = time.monotonic()
        time.sleep(0.1)
    if check_true("the script in the window ended", os.path.exists(task["results"]), "see PluginEscape.log"):
        with open(task["results"], encoding="utf-8") as file:
            stopped, following, undisturbed = json.load(file)
        check_equal("stopped: status", "not-computed", stopped["status"])
        check_true("stopped: the summary says why", "the run was aborted" in stopped["summary"], stopped["summary"])
        check_true("stopped: the status bar said how", "Mass Properties by Paper Schemes, Esc stops it" in stopped["texts"], str(stopped["texts"]))
        check_true("the next run: not aborted", "abort" not in following["summary"], following["summary"])
        check_true("the next run: a volume", 1000.0 < float(following["volume"]), following["volume"])
        check_equal("the next run: the bits of an undisturbed one", undisturbed["volume"], following["volume"])
finally:
    window.kill()
    window.wait()
    log.close()
finish()

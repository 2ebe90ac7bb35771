"""TestPluginSweep.py PLUGIN.so STEP OUTPUT PVPYTHON: after each of ParaView's filters, its input has exact solids, and Mass Properties the same bits.

The inputs are STEP Reader, NURBS Transform and NURBS Deform; every filter of ParaView that takes one of them runs on it. Some of them end the
process: this script runs itself with SM_SWEEP_CHILD, a file to which the child writes the name of each filter before it runs, and the next
child goes on behind that filter. Such a filter then runs in a ParaView without the plugin, on the same triangles read from a file: it has
to end that process, too, for then the fault is ParaView's.
"""
import json
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check_equal, check_true, finish  # noqa: E402

plugin, part = sys.argv[1:3]
child = os.environ.get("SM_SWEEP_CHILD")
INPUTS = ("STEP Reader", "NURBS Transform", "NURBS Deform")


def run_child(path, task):
    """Its exit status, and the task with what it did."""
    with open(path, "w", encoding="utf-8") as file:
        json.dump(task, file)
    status = subprocess.call([sys.argv[4], os.path.abspath(__file__), plugin, part], env=dict(os.environ, SM_SWEEP_CHILD=path),
                             stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=300)
    with open(path, encoding="utf-8") as file:
        return status, json.load(file)


if not child:
    path = os.path.join(sys.argv[3], "PluginSweep.json")
    mesh = os.path.join(sys.argv[3], "PluginSweep.vtpc")
    task = {"done": {name: [] for name in INPUTS}, "crashed": [], "failed": [], "lost": [], "mesh": mesh}
    for _ in range(20):
        status, task = run_child(path, task)
        if status >= 0 or "last" not in task:
            break
        task["crashed"].append(task["last"])
    check_equal("the last child ended with", 0, status)
    check_equal("filters that take the exact solids from their input", [], task["lost"])
    for name in INPUTS:
        check_equal(f"{name}: Mass Properties has the same bits", "same", task.get("bits", {}).get(name))
        check_true(f"{name}: filters that ran", len(task["done"][name]) > 100, str(len(task["done"][name])))
    check_true("filters with errors", len(task["failed"]) < 20, str(task["failed"]))
    for name in task["crashed"]:
        status, done = run_child(path, {"alone": name, "mesh": mesh})
        check_true(f"{name} ends ParaView without the plugin, too", done.get("last") == name and status < 0, f"with {status}")
    # That a filter of sound mind does not end the process shows that the others do.
    check_equal("a process without the plugin that clips", 0, run_child(path, {"alone": "Clip", "mesh": mesh})[0])
    finish()
    sys.exit(0)

from paraview import servermanager, simple  # noqa: E402

with open(child, encoding="utf-8") as file:
    task = json.load(file)


def keep():
    with open(child + ".part", "w", encoding="utf-8") as file:
        json.dump(task, file)
    os.replace(child + ".part", child)


simple.Connect()
manager = servermanager.ProxyManager().SMProxyManager


def make(name):
    return servermanager._getPyProxy(manager.NewProxy("filters", name))


def run(name, source):
    """Runs a filter with its default properties; False when it has an error."""
    task["last"] = name
    keep()
    each = make(name)
    each.Input = source
    try:
        each.UpdatePipeline()
    except RuntimeError:
        return False
    return True


if "alone" in task:
    mesh = simple.OpenDataFile(task["mesh"])
    mesh.UpdatePipeline()
    run(task["alone"], mesh)
    os._exit(0)


def list_filters():
    definitions = manager.GetProxyDefinitionManager().NewSingleGroupIterator("filters", 0)
    definitions.InitTraversal()
    names = []
    while not definitions.IsDoneWithTraversal():
        names.append(definitions.GetProxyName())
        definitions.GoToNextItem()
    return sorted(names)


# Filters that ParaView has without the plugin, except for those that run scripts of the user.
SKIPPED = {"ProgrammableFilter", "PythonCalculator", "PythonAnnotation", "PythonView", "LiveProgrammableFilter"}
filters = [name for name in list_filters() if name not in SKIPPED]
simple.LoadPlugin(plugin, ns=globals())


def accepts(name, source):
    """The check of the Filters menu; of filters with one input."""
    prototype = manager.GetPrototypeProxy("filters", name)
    inputs = prototype.GetProperty("Input")
    others = [each for each in ("Source", "Input2", "Selection", "Locations") if prototype.GetProperty(each)]
    if not inputs or not inputs.IsA("vtkSMInputProperty") or others:
        return False
    inputs.RemoveAllUncheckedProxies()
    inputs.AddUncheckedInputConnection(source.SMProxy, 0)
    accepted = inputs.IsInDomains()
    inputs.RemoveAllUncheckedProxies()
    return bool(accepted)


def read_bits(source):
    """Everything that Mass Properties says of the whole input."""
    mass = MassProperties(Input=source, Density=1000.0)  # noqa: F821
    mass.UpdatePipeline()
    fields = servermanager.Fetch(mass, idx=0).GetFieldData()
    bits = {}
    for i in range(fields.GetNumberOfArrays()):
        array = fields.GetAbstractArray(i)
        count = array.GetNumberOfValues()
        bits[array.GetName()] = [float(array.GetValue(k)).hex() if array.IsNumeric() else array.GetValue(k) for k in range(count)]
    simple.Delete(mass)
    return bits


def sweep():
    """A function: what some of the filters do in Python overwrites names of this module."""
    reader = simple.OpenDataFile(part)
    reader.MeshDeviation, reader.MeshAngle = 0.05, 1.0  # filters take time by triangles, which the solids do not depend on
    if not os.path.exists(task["mesh"]) or not task["crashed"]:
        simple.SaveData(task["mesh"], proxy=reader)
    moved = NURBSTransform(Input=reader, Translation=[1.0, 2.0, 3.0], Rotation=[10.0, 20.0, 30.0])  # noqa: F821
    deformed = NURBSDeform(Input=reader, Displacement=[0.0, 0.0, 0.5])  # noqa: F821
    sources = dict(zip(INPUTS, (reader, moved, deformed)))
    for source in sources.values():
        source.UpdatePipeline()
    before = {key: read_bits(source) for key, source in sources.items()}
    for name in filters:
        for key, source in sources.items():
            if name in task["done"][key] or name in task["crashed"] or not accepts(name, source):
                continue
            task["done"][key].append(name)
            if not run(name, source):
                task["failed"].append(f"{key}: {name}")
            task["lost"] += [f"{other}: {name}" for other in INPUTS if not accepts("MassPropertiesGPU", sources[other])]
    task["bits"] = {key: "same" if bits["Status"] == ["ok"] and bits == read_bits(sources[key]) else "others" for key, bits in before.items()}


sweep()
keep()
os._exit(0)  # some of the filters end the process when they are deleted

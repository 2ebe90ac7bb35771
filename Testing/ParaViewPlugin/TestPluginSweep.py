"""TestPluginSweep.py PLUGIN.so STEP OUTPUT PVPYTHON: after each of ParaView's filters, its input has exact solids, and Mass Properties the same bits.

The inputs are STEP Reader, NURBS Transform and NURBS Deform; every filter of ParaView that takes one of them runs on it. Some of them end the
process: this script runs itself with SM_SWEEP_CHILD, a file to which the child writes the name of each filter before it runs, and the next
child goes on behind that filter.
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
if not child:
    path = os.path.join(sys.argv[3], "PluginSweep.json")
    for name in INPUTS:
        task = {"input": name, "done": [], "crashed": [], "failed": []}
        for _ in range(20):
            with open(path, "w", encoding="utf-8") as file:
                json.dump(task, file)
            status = subprocess.call([sys.argv[4], os.path.abspath(__file__), plugin, part], env=dict(os.environ, SM_SWEEP_CHILD=path),
                                     stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=300)
            with open(path, encoding="utf-8") as file:
                task = json.load(file)
            if status == 0:
                break
            task["crashed"].append(task["done"][-1] if task["done"] else "the start")
        check_equal(f"{name}: the last child ended with", 0, status)
        check_equal(f"{name}: filters that take the exact solids from their input", [], task.get("lost"))
        check_equal(f"{name}: Mass Properties has the same bits", "same", task.get("bits"))
        check_true(f"{name}: filters that ran", len(task["done"]) > 100, f"{len(task['done'])}; with errors {task['failed']}; ended the process: {task['crashed']}")
        check_true(f"{name}: few end the process", len(task["crashed"]) <= 5, str(task["crashed"]))
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


def list_filters():
    definitions = manager.GetProxyDefinitionManager().NewSingleGroupIterator("filters", 0)
    definitions.InitTraversal()
    names = []
    while not definitions.IsDoneWithTraversal():
        names.append(definitions.GetProxyName())
        definitions.GoToNextItem()
    return sorted(names)


# Filters that ParaView has without the plugin, but for those that run scripts of the user.
SKIPPED = {"ProgrammableFilter", "PythonCalculator", "PythonAnnotation", "PythonView", "LiveProgrammableFilter"}
filters = [name for name in list_filters() if name not in SKIPPED]
simple.LoadPlugin(plugin, ns=globals())


def make(name):
    return servermanager._getPyProxy(manager.NewProxy("filters", name))


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


source = simple.OpenDataFile(part)
source.MeshDeviation, source.MeshAngle = 0.05, 1.0  # filters take time by triangles, which the solids do not depend on
if task["input"] == "NURBS Transform":
    source = NURBSTransform(Input=source, Translation=[1.0, 2.0, 3.0], Rotation=[10.0, 20.0, 30.0])  # noqa: F821
elif task["input"] == "NURBS Deform":
    source = NURBSDeform(Input=source, Displacement=[0.0, 0.0, 0.5])  # noqa: F821
source.UpdatePipeline()
before = read_bits(source)
task.setdefault("lost", [])
for name in filters:
    if name in task["done"] or not accepts(name, source):
        continue
    task["done"].append(name)
    keep()
    each = make(name)
    each.Input = source
    try:
        each.UpdatePipeline()
    except RuntimeError:
        task["failed"].append(name)
    if not accepts("MassPropertiesGPU", source):
        task["lost"].append(name)
    del each
task["bits"] = "same" if before["Status"] == ["ok"] and before == read_bits(source) else "others"
keep()
os._exit(0)  # some of the filters end the process when they are deleted

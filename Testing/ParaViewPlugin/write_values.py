"""write_values.py PLUGIN OUT.json PORT FILE...: what the plugin's mass filter puts out for each file, bit for bit.

With PORT > 0 the pipeline is on the pvserver that listens there; what is written is what the client fetched.
"""
import json
import sys

from paraview import servermanager, simple

plugin, path, port = sys.argv[1:4]
if int(port) > 0:
    simple.Connect("localhost", int(port))
    simple.LoadPlugin(plugin, remote=False, ns=globals())
simple.LoadPlugin(plugin, remote=True, ns=globals())


def exact(value):
    return float(value).hex() if isinstance(value, float) else value


def write_array(array):
    if array.IsA("vtkStringArray"):
        return [array.GetValue(i) for i in range(array.GetNumberOfValues())]
    return [exact(array.GetComponent(i // array.GetNumberOfComponents(), i % array.GetNumberOfComponents()))
            for i in range(array.GetNumberOfValues())]


def write_fields(fields):
    return {fields.GetArrayName(i): write_array(fields.GetAbstractArray(i)) for i in range(fields.GetNumberOfArrays())}


values = {}
for file in sys.argv[4:]:
    mass = MassProperties(Input=simple.OpenDataFile(file))  # noqa: F821
    glyph = servermanager.Fetch(mass, idx=0)
    found = {"totals": write_fields(glyph.GetFieldData()), "points": glyph.GetNumberOfPoints()}
    for index, name in ((1, "solids"), (2, "text"), (3, "faces"), (4, "edges")):
        table = servermanager.Fetch(mass, idx=index)
        found[name] = {"rows": table.GetNumberOfRows(), "columns": write_fields(table.GetRowData())}
    values[file] = found
with open(path, "w", encoding="utf-8") as out:
    json.dump(values, out)

"""_write_mesh.py FILE OUTPUT UNIT INPUT_UNIT DEFLECTION: writes the display mesh of FILE as a line of JSON and the bytes of its arrays.

Run by _mesh.py in a process of its own.
"""
import json
import sys


def main(file, output, unit, input_unit, deflection):
    from solidmoments.smReadersBREP import vtkBREPReader
    from solidmoments.smReadersSTEP import vtkSTEPReader
    from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet

    reader = vtkBREPReader() if vtkBREPReader.CanReadFile(file) else vtkSTEPReader()
    for event in ("ErrorEvent", "WarningEvent"):
        reader.AddObserver(event, lambda *_: None)
    reader.SetFileName(file)
    reader.SetOutputUnit(unit)
    if reader.IsA("vtkBREPReader"):
        reader.SetInputUnit(input_unit)
    reader.SetLinearDeflection(float(deflection))
    reader.Update()
    if reader.GetStatus() not in (reader.OK, reader.EMPTY):
        messages = [reader.GetMessage(i) for i in range(reader.GetNumberOfMessages())]
        write(output, {"messages": messages}, [])
        return
    arrays, solids = [], []

    def describe(array):
        data = memoryview(array).tobytes()
        arrays.append(data)
        kind = {"f": "f", "d": "f", "B": "u"}.get(memoryview(array).format, "i")
        return {"bytes": len(data), "type": f"{kind}{array.GetDataTypeSize()}", "components": array.GetNumberOfComponents()}

    def describe_all(attributes):
        found = (attributes.GetArray(i) for i in range(attributes.GetNumberOfArrays()))
        return {array.GetName(): describe(array) for array in found if array}

    collection = reader.GetOutput()
    for i in range(collection.GetNumberOfPartitionedDataSets()):
        mesh = collection.GetPartition(i, 0)
        triangles = mesh.GetPolys().GetConnectivityArray()
        assert mesh.GetPolys().GetMaxCellSize() in (0, 3)
        name = collection.GetMetaData(i).Get(vtkCompositeDataSet.NAME()) if collection.HasMetaData(i) else None
        solid = {"name": mesh.GetPartName() or name or "", "length_unit": mesh.GetModel().GetLengthUnit(), "points": describe(mesh.GetPoints().GetData())}
        solid["triangles"] = {**describe(triangles), "components": 3}
        solid["cell_data"], solid["point_data"] = describe_all(mesh.GetCellData()), describe_all(mesh.GetPointData())
        solids.append(solid)
    write(output, {"messages": None, "solids": solids}, arrays)


def write(output, head, arrays):
    with open(output, "wb") as stream:
        stream.write(json.dumps(head).encode() + b"\n")
        for array in arrays:
            stream.write(array)


if __name__ == "__main__":
    main(*sys.argv[1:])

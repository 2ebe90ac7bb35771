"""InstanceBenchmark.py FILE.step LEVELS: what instances of one solid cost with and without a display mesh.

The solid of the file becomes an assembly of 2^LEVELS instances. Each line is a process of its own, with the seconds of its processor, the
memory that it holds at its end and at most, and the triangles of the reader's output: mass properties alone (on demand), with a mesh
(always), and a reader for a view, with its coarse mesh above 100,000 triangles, and refined.
"""
import os
import re
import resource
import subprocess
import sys
import tempfile

MODES = ("need", "always", "coarse", "refined")


def write_assembly(source, levels, target):
    """Writes a file of nested products, each of which has the one before twice, side by side."""
    with open(source, encoding="utf-8") as file:
        text = file.read()
    entities = {int(number): " ".join(body.split()) for number, body in re.findall(r"#(\d+)\s*=\s*([^;]*);", text)}

    def find(start):
        return next((number, body) for number, body in entities.items() if body.startswith(start))

    lines = []
    last = max(entities)

    def add(body):
        nonlocal last
        last += 1
        lines.append(f"#{last}={body};")
        return f"#{last}"

    def add_place(x):
        point = add(f"CARTESIAN_POINT('',({x:.1f},0.,0.))")
        return add(f"AXIS2_PLACEMENT_3D('',{point},$,$)")

    definition = "#%d" % find("PRODUCT_DEFINITION(")[0]
    product_context = "#%d" % find("PRODUCT_CONTEXT(")[0]
    definition_context = "#%d" % find("PRODUCT_DEFINITION_CONTEXT(")[0]
    shape = re.search(r",(#\d+)\)$", find("SHAPE_DEFINITION_REPRESENTATION(")[1]).group(1)
    context = re.search(r",(#\d+)\)$", entities[int(shape[1:])]).group(1)
    for level in range(levels):
        product = add(f"PRODUCT('level {level}','level {level}','',({product_context}))")
        formation = add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
        whole = add(f"PRODUCT_DEFINITION('design','',{formation},{definition_context})")
        origin = add_place(0.0)
        places = [add_place(0.0), add_place(1000.0 * 2 ** level)]
        own = add(f"SHAPE_REPRESENTATION('',({','.join([origin] + places)}),{context})")
        whole_shape = add(f"PRODUCT_DEFINITION_SHAPE('','',{whole})")
        add(f"SHAPE_DEFINITION_REPRESENTATION({whole_shape},{own})")
        for number, place in enumerate(places):
            use = add(f"NEXT_ASSEMBLY_USAGE_OCCURRENCE('{level}.{number}','','',{whole},{definition},$)")
            move = add(f"ITEM_DEFINED_TRANSFORMATION('','',{origin},{place})")
            relation = add(f"(REPRESENTATION_RELATIONSHIP('','',{shape},{own})REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({move})"
                           "SHAPE_REPRESENTATION_RELATIONSHIP())")
            use_shape = add(f"PRODUCT_DEFINITION_SHAPE('','',{use})")
            add(f"CONTEXT_DEPENDENT_SHAPE_REPRESENTATION({relation},{use_shape})")
        definition, shape = whole, own
    end = text.rindex("ENDSEC;")
    with open(target, "w", encoding="utf-8") as file:
        file.write(text[:end] + "\n".join(lines) + "\n" + text[end:])


def run(path, mode):
    from solidmoments.smFiltersMassProperties import vtkMassPropertiesGPU
    from solidmoments.smReadersSTEP import vtkSTEPReader
    reader = vtkSTEPReader()
    reader.SetFileName(path)
    volume = ""
    if mode in ("need", "always"):
        reader.SetDisplayMesh(reader.MESH_ALWAYS if mode == "always" else reader.MESH_BY_NEED)
        mass = vtkMassPropertiesGPU()
        mass.SetBackend(mass.CPU)
        mass.SetInputConnection(reader.GetOutputPort())
        mass.Update()
        volume = f"volume {mass.GetVolume()!r} {mass.GetStatus()}"
    else:
        reader.SetCoarseAbove(100000)
        reader.SetRefined(mode == "refined")
        reader.Update()
    with open("/proc/self/statm", encoding="utf-8") as file:
        held = int(file.read().split()[1]) * resource.getpagesize()
    usage = resource.getrusage(resource.RUSAGE_SELF)
    print(f"{mode:8} {usage.ru_utime + usage.ru_stime:7.2f} s {held / 1e6:8.1f} MB held {usage.ru_maxrss * 1024 / 1e6:8.1f} MB at most "
          f"{reader.GetNumberOfInstances()} instances {reader.GetOutput().GetNumberOfCells()} triangles {volume}", flush=True)


if sys.argv[1] == "--run":
    run(*sys.argv[2:4])
else:
    with tempfile.TemporaryDirectory() as folder:
        assembly = os.path.join(folder, "assembly.step")
        write_assembly(sys.argv[1], int(sys.argv[2]), assembly)
        volumes = set()
        for each in MODES:
            line = subprocess.run([sys.executable, __file__, "--run", assembly, each], check=True, capture_output=True, text=True).stdout
            print(line, end="", flush=True)
            volumes |= set(re.findall("volume .*", line))
        print("the same bits" if len(volumes) == 1 else f"different results: {volumes}")
        sys.exit(0 if len(volumes) == 1 else 1)

"""The reader of STEP and BREP files for PyVista, which finds it by the entry points of this package."""


def read(path, **options):
    """A pyvista.MultiBlock with the display mesh of every solid and shell as a pyvista.PolyData, by its name.

    Lengths are in mm unless `unit` says otherwise; the field LengthUnit of each mesh has their unit. Options are those of
    `solidmoments.display_mesh`; arrays are those of its SolidMesh.
    """
    import numpy
    import pyvista

    from ._mesh import display_mesh

    blocks = pyvista.MultiBlock()
    for solid in display_mesh(path, **options):
        counts = numpy.full((len(solid.triangles), 1), 3)
        mesh = pyvista.PolyData(solid.points, numpy.hstack([counts, solid.triangles]).ravel())
        for name, values in solid.point_data.items():
            mesh.point_data[name] = values
        for name, values in solid.cell_data.items():
            mesh.cell_data[name] = values
        mesh.field_data["LengthUnit"] = [solid.length_unit]
        blocks.append(mesh, solid.name)
    return blocks

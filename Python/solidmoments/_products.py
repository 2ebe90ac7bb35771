"""Products as plain values: parts list, materials, comparison of two files, validation properties, robots."""
import os
import warnings

from . import _arguments as arguments
from ._run import make_result, run_filter


def _parse(text):
    import json
    return json.loads(text)


def _run(file, density, options):
    """Reader and filter after their run. Errors and warnings are those of mass_properties()."""
    strict = arguments.truth("strict", options.pop("strict", False))
    file = arguments.path("file", file)
    reader, mass = run_filter(file, density, **options)
    make_result(file, (reader, mass), strict, level=4)
    return reader, mass


def _check_limit(limit):
    limit = arguments.number("limit", limit, "a number from 0 to below 1")
    if not 0.0 <= limit < 1.0:
        raise ValueError(f"limit is {limit:g}; it has to be from 0 to below 1")
    return limit


def materials():
    """The densities of common materials in kg/m^3 by their names: a dict."""
    arguments.require_vtk()
    from .smFiltersProducts import vtkProducts

    return {entry["name"]: entry["density"] for entry in _parse(vtkProducts.GetMaterials())}


def parts_list(file, density=None, **options):
    """The parts list of a STEP or BREP file: a list of dicts, each of which has its children below `children`.

    Keys are those of `parts` in the JSON of the program `solidmoments`: name, kind (part or assembly), count and count_in_all, solids,
    status, material, density, and the sums `each` and `in_all` of volume, area and mass with their bounds. A value that is not known is
    None. density and options are those of `mass_properties`, and so are errors and warnings.
    """
    arguments.require_vtk()
    from .smFiltersProducts import vtkProducts

    reader, mass = _run(file, density, options)
    return _parse(vtkProducts.GetPartsList(mass))


def compare(old, new, density=None, *, limit=1e-9, **options):
    """The differences of the solids of two files by their geometry: a dict.

    Keys are those of `comparison` in the JSON of the program `solidmoments`: equal, limit, length_unit, counts (solids by their state:
    unchanged, moved, mirrored, changed, added, removed), total, and parts, a list of dicts with state, name, count, notes, difference and bodies.
    limit: largest relative difference, in addition to the bounds, that counts as equal. density and options are those of
    `mass_properties`, for both files, and so are errors and warnings.
    """
    arguments.require_vtk()
    from .smFiltersProducts import vtkProducts

    limit = _check_limit(limit)
    before = _run(old, density, dict(options))
    after = _run(new, density, dict(options))
    text = vtkProducts.Compare(before[1], after[1], limit)
    if not text:
        raise ValueError(f"{old} and {new} have different length units; give one by unit")
    return _parse(text)


def validation(file, density=None, *, limit=1e-3, **options):
    """The validation properties that a STEP file states, compared with the results: a list of dicts, empty if it states none.

    Keys are those of `validation` in the JSON of the program `solidmoments`: product, definition (entity number), quantity (volume, area
    or centroid), stated, computed, bound, difference, limit, result (pass, fail or not-comparable) and reason. Volume and area may differ
    by `limit` of the stated value, the centroid by `limit` of the cube root of the volume, and all by their bounds. density and options
    are those of `mass_properties`, and so are errors and warnings.
    """
    arguments.require_vtk()
    from vtkmodules.vtkCommonDataModel import vtkTable

    from .smFiltersProducts import vtkProducts
    from .smReadersSTEP import vtkSTEPReader

    limit = _check_limit(limit)
    reader, mass = _run(file, density, options)
    stated = vtkTable()
    if not vtkSTEPReader.ReadStatedProducts(arguments.path("file", file), stated):
        return []
    return _parse(vtkProducts.CompareValidation(mass, stated, limit))


def robot(file, format="urdf", density=None, *, joints="", fuse=(), **options):
    """The products of a STEP or BREP file as a robot: the text of a URDF, SDF or MJCF file, in kg and m, without meshes.

    There is a link for every occurrence of a product that has solids, in its own frame. joints: lines
    "parent,child,type,axis x,y,z,origin x,y,z", where axis or origin may be missing, the types fixed, revolute and prismatic, and lengths
    in the unit of the options; links without a line are fixed to the first. fuse: names of products, also with * and ?, of which each is
    one link with all below it. Warns of links that are left out or that readers refuse. Raises ValueError for a table or a format that is
    wrong, and where no product has a mass. density and options are those of `mass_properties`, and so are other errors and warnings.
    """
    arguments.require_vtk()
    from .smFiltersProducts import vtkProducts

    arguments.choice("format", format, ("urdf", "sdf", "mjcf"))
    arguments.text("joints", joints, "a text with a line for each joint")
    if isinstance(fuse, str):
        fuse = [fuse]
    if isinstance(fuse, (bytes, dict)) or not hasattr(fuse, "__iter__"):
        raise TypeError(f"fuse is {arguments.show(fuse)}; it has to be the name of a product, or a list of names")
    fuse = [arguments.text("an entry of fuse", name, "the name of a product") for name in fuse]
    reader, mass = _run(file, density, options)
    name = os.path.splitext(os.path.basename(arguments.path("file", file)))[0]
    found = _parse(vtkProducts.MakeRobot(mass, name, format, joints, "\n".join(fuse)))
    if found["problem"]:
        raise ValueError(f"{file}: {found['problem']}")
    for message in found["messages"]:
        warnings.warn(f"{file}: {message}", stacklevel=2)
    return found["text"]

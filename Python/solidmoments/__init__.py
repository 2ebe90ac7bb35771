"""Mass properties of STEP files with error bounds.

>>> import solidmoments
>>> part = solidmoments.mass_properties("part.step", density=7850.0)
>>> part.volume, part.volume_bound, part.units["volume"]

`mass_properties` reads one file, `to_dataframe` several into a table of pandas, `parts_list` gives the products of a file, `compare` the
differences of two, `validation` what a file states against the results, `robot` a URDF, SDF or MJCF file, `materials` common
densities, `Model` is a solid built from NumPy arrays, `moment_gradient` and `moment_hessian_product` give derivatives by control points, `Variants` the moments
of a million parts of one design, `autodiff` both as functions with vector-Jacobian products, `display_mesh` the triangles as NumPy arrays, and
`pyvista.read("part.step")` as PyVista's meshes (PyVista 0.48 or later). Numbers are
bitwise equal to those of the program `solidmoments`. The VTK classes behind them are in the extension modules of this package, for example
`solidmoments.smFiltersMassProperties`, and load with the first call.
"""
from . import autodiff
from ._gradient import FaceGradient, MomentGradient, moment_gradient
from ._hessian import FaceHessianProduct, MomentHessianProduct, moment_hessian_product
from ._mesh import SolidMesh, display_mesh
from ._model import Model
from ._products import compare, materials, parts_list, robot, validation
from ._results import FlaggedResultWarning, MassProperties, SolidMomentsError
from ._run import mass_properties, to_dataframe
from ._variants import Variants
from ._version import __version__

__all__ = ["FaceGradient", "FaceHessianProduct", "FlaggedResultWarning", "MassProperties", "Model", "MomentGradient", "MomentHessianProduct",
           "SolidMesh", "SolidMomentsError", "Variants", "__version__", "autodiff", "compare", "display_mesh", "mass_properties", "materials",
           "moment_gradient", "moment_hessian_product", "parts_list", "robot", "to_dataframe", "validation"]

"""A picture against its baseline; the Python sibling of smPictureTesting.h, where the reasons are."""
import os

import numpy
from matplotlib.image import imread

from smcheck import check_true

COLOR_TOLERANCE = 24
LIMIT = 3e-4


def to_colors(image):
    """Rows of pixels of red, green, blue of a vtkImageData, from the bottom."""
    from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: PLC0415
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[:, :, :3].astype(int)


def read_picture(path):
    """Returns the pixels of a PNG file as to_colors(), or None when there is no such file."""
    if not os.path.exists(path):
        return None
    return read_bytes(path)[::-1, :, :3].astype(int)


def read_bytes(path):
    """The 8-bit values of a PNG file, rows from the top: of grey, or of red, green and blue, and opacity if there is one."""
    return (255.0 * imread(path)).round().astype(numpy.uint8)


def write_picture(image, path):
    from vtkmodules.vtkIOImage import vtkPNGWriter  # noqa: PLC0415
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.Write()


def _lacks(picture, other):
    """Returns a mask of the pixels of `other` whose colour `picture` has neither there nor at one of the eight neighbours."""
    height, width, _ = other.shape
    around = numpy.pad(picture, ((1, 1), (1, 1), (0, 0)), constant_values=-1000)
    lacks = numpy.ones((height, width), dtype=bool)
    for j in range(3):
        for i in range(3):
            lacks &= abs(around[j:j + height, i:i + width] - other).max(axis=2) > COLOR_TOLERANCE
    return lacks


def share_of_other_pixels(one, other):
    """Returns the part, 0 to 1, of the pixels whose colour the other picture has neither there nor at a neighbour; 1 where sizes differ."""
    if one is None or other is None or one.shape != other.shape:
        return 1.0
    return float((_lacks(one, other) | _lacks(other, one)).mean())


def check_picture(what, expected, actual):
    share = share_of_other_pixels(actual, expected)
    return check_true(f"{what}: pixels unlike the baseline's", share <= LIMIT, f"share {share:.2g}, limit {LIMIT:g}")


def check_noticed(what, expected, wrong):
    """Checks that check_picture() would reject a picture that is known to be wrong and has the right size."""
    share = share_of_other_pixels(wrong, expected)
    return check_true(f"{what}: noticed", 2 * LIMIT <= share <= 0.9, f"share {share:.2g}, limit {LIMIT:g}")

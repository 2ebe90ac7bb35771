"""Arrays of other libraries as NumPy arrays, without importing those libraries."""

_CPU = 1  # kDLCPU of DLPack


def to_numpy(values, name="the array"):
    """A float64 NumPy array of numbers, of sequences of them, or of any array with __array_interface__, __array__, the buffer protocol or DLPack.

    Memory is shared where it holds float64 already. ValueError for an array in the memory of a device: its library has a method that copies it;
    for masked values, and for rows of different lengths. TypeError for texts, None and complex numbers. Messages begin with `name`.
    """
    import numpy

    if type(values) is numpy.ndarray and values.dtype == float:
        return values

    if not isinstance(values, numpy.ndarray) and hasattr(values, "__dlpack__") and not hasattr(values, "__array_interface__"):
        device = values.__dlpack_device__()
        if int(device[0]) != _CPU:
            raise ValueError(f"an array of {type(values).__module__}.{type(values).__name__} is in the memory of a device (DLPack's type "
                             f"{int(device[0])}); copy it to the processor first")
        try:
            values = numpy.from_dlpack(values)
        except (AttributeError, BufferError, TypeError) as error:
            # An old NumPy, or memory that is read-only, which NumPy before 2.1 does not take by DLPack.
            if not hasattr(values, "__array__"):
                raise ValueError(f"an array of {type(values).__module__}.{type(values).__name__} cannot be taken by DLPack: {error}; give it as a "
                                 "NumPy array") from error
    return _convert(values, name)


def _convert(values, name):
    import numpy

    from ._arguments import show

    if isinstance(values, numpy.ma.MaskedArray) and numpy.ma.is_masked(values):
        raise ValueError(f"{name} has masked values; fill them, or leave them out")
    try:
        array = numpy.asarray(values)
        if array.dtype.kind in "biuf":
            return array.astype(float, copy=False)
        if array.dtype.kind == "O" and not any(value is None or isinstance(value, (str, bytes)) for value in array.flat):
            return array.astype(float)
    except (TypeError, ValueError) as error:
        raise type(error)(f"{name} is {show(values)}, which is not an array of numbers: {error}") from error
    raise TypeError(f"{name} is {show(values)}; it has to be an array of numbers")

"""Numbers in and out: numpy's arrays if numpy is installed, lists if not."""

import ctypes

try:
    import numpy
except ImportError:
    numpy = None


def flat(values):
    """Numbers of any nesting, one after the other; a number is a list of one."""
    if isinstance(values, (int, float)):
        return [float(values)]
    return [number for value in values for number in flat(value)]


def doubles(values):
    """(pointer, how many, what keeps them alive) of any numbers, in the order of C."""
    if numpy is not None:
        array = numpy.ascontiguousarray(values, dtype=numpy.float64)
        return array.ctypes.data_as(ctypes.POINTER(ctypes.c_double)), array.size, array
    numbers = flat(values)
    array = (ctypes.c_double * len(numbers))(*numbers)
    return ctypes.cast(array, ctypes.POINTER(ctypes.c_double)), len(numbers), array


def column(values):
    """A list as a column of a table."""
    return values if numpy is None else numpy.array(values)


def shaped(buffer, columns=None):
    """A buffer of C doubles as an array of its own, with `columns` numbers to a row if said."""
    if numpy is not None:
        array = numpy.array(buffer, dtype=numpy.float64)
        return array if columns is None else array.reshape(-1, columns)
    numbers = list(buffer)
    return numbers if columns is None else [numbers[i : i + columns] for i in range(0, len(numbers), columns)]

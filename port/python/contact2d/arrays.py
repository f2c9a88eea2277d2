"""Numbers in and out: numpy's arrays if numpy is installed, lists if not. `where` names an argument in what is raised."""

import ctypes
import math
import operator
from typing import Any

numpy: Any = None
try:
    import numpy
except ImportError:
    pass


def integer(where, value, kind=ctypes.c_int32, least=None):
    """A whole number that fits a type of C, and is not below `least`."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError("%s is %r, expected a whole number" % (where, value)) from None
    bits, signed = 8 * ctypes.sizeof(kind), kind(-1).value < 0
    low, high = (-(1 << (bits - 1)), (1 << (bits - 1)) - 1) if signed else (0, (1 << bits) - 1)
    low = low if least is None else least
    if not low <= number <= high:
        raise ValueError("%s is %d, expected %d to %d" % (where, number, low, high))
    return number


def real(where, value):
    """A number that is not nan. Infinity is one; the library refuses it where it cannot be meant."""
    is_number = hasattr(type(value), "__float__") or hasattr(type(value), "__index__")
    if isinstance(value, complex) or not is_number:
        raise TypeError("%s is %r, expected a number" % (where, value))
    try:
        number = float(value)
    except (OverflowError, TypeError, ValueError):
        raise ValueError("%s is %r, expected a number within the range of a double" % (where, value)) from None
    if math.isnan(number):
        raise ValueError("%s is nan, expected a number" % where)
    return number


def is_list(value):
    """Something to be gone through that is neither text nor a mapping; arrays of numpy without axes are numbers."""
    if isinstance(value, (str, bytes, dict)) or getattr(value, "shape", None) == ():
        return False
    return hasattr(type(value), "__iter__")


def listed(where, values):
    """One number, or a list of numbers, as a list."""
    return [real(where, value) for value in values] if is_list(values) else [real(where, values)]


def flat(values):
    """Numbers of any nesting, one after the other; nan is one."""
    return [number for value in values for number in flat(value)] if is_list(values) else [float(values)]


def pairs(where, values):
    """Rows (x, y), or the same numbers one after the other, as numbers one after the other."""
    out = []
    rows = list(values) if is_list(values) else [values]
    for row in rows:
        if is_list(row) != is_list(rows[0]):
            raise TypeError("%s: expected rows (x, y)" % where)
        numbers = listed(where, row)
        if is_list(row) and len(numbers) != 2:
            raise TypeError("%s: expected rows (x, y), not %d numbers" % (where, len(numbers)))
        out += numbers
    if len(out) % 2:
        raise TypeError("%s: expected rows (x, y), not %d numbers" % (where, len(out)))
    return out


def fast(where, values, columns):
    """The same for a numpy array of real numbers, as an array; else None."""
    if numpy is None or not isinstance(values, numpy.ndarray) or values.dtype.kind not in "iuf" or not values.ndim:
        return None
    if values.ndim > columns or (values.ndim == 2 and values.shape[1] != 2):
        raise TypeError("%s: an array of shape %s, expected %s" %
                        (where, values.shape, "rows (x, y)" if columns == 2 else "a list of numbers"))
    if columns == 2 and values.size % 2:
        raise TypeError("%s: expected rows (x, y), not %d numbers" % (where, values.size))
    array = numpy.ascontiguousarray(values, dtype=numpy.float64)
    if numpy.isnan(array).any():
        raise ValueError("%s has a nan, expected numbers" % where)
    return array


def doubles(where, values, columns=1):
    """(pointer, how many, what keeps them alive) of numbers, in the order of C; columns = 2: rows (x, y)."""
    array = fast(where, values, columns)
    if array is not None:
        return array.ctypes.data_as(ctypes.POINTER(ctypes.c_double)), array.size, array
    numbers = pairs(where, values) if columns == 2 else listed(where, values)
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

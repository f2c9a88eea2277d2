"""Finds and loads the shared library and the program: those in this package, of the tree it stands in, or of the system.

CONTACT2D_LIBRARY and CONTACT2D_PROGRAM name others.
"""

import ctypes
import glob
import os
import pathlib
import shutil

from . import header

VERSION = "%d.%d.%d" % (header.C2D_VERSION_MAJOR, header.C2D_VERSION_MINOR, header.C2D_VERSION_PATCH)
HERE = pathlib.Path(__file__).resolve().parent


def tree():
    """The project's build folder, if this package is used where its source stands."""
    root = HERE.parents[2]
    return root / "build" if (root / "include" / "contact2d.h").exists() else None


def library_names():
    if os.environ.get("CONTACT2D_LIBRARY"):
        return [os.environ["CONTACT2D_LIBRARY"]]
    names = [str(name) for name in [HERE / "bin" / "libcontact2d.so"] if name.exists()]
    if tree() is not None:
        names += glob.glob(str(tree() / ("libcontact2d.so." + VERSION)))
    so_version = VERSION.rsplit(".", 1)[0] if header.C2D_VERSION_MAJOR == 0 else str(header.C2D_VERSION_MAJOR)
    return names + ["libcontact2d.so." + so_version]


def load():
    tried = []
    for name in library_names():
        try:
            loaded = ctypes.CDLL(name)  # a call through CDLL lets other threads of Python run
        except OSError as why:
            tried.append(str(why))
            continue
        for function, (result, arguments, _) in header.FUNCTIONS.items():
            getattr(loaded, function).restype = result
            getattr(loaded, function).argtypes = [kind for _, kind, _, _ in arguments]
        found = loaded.c2d_version().decode()
        if found != VERSION:
            raise ImportError("%s is contact2d %s, this package is of %s" % (name, found, VERSION))
        return loaded
    how = "" if tree() is None else ("`make python` in %s builds it; " % tree().parent)
    raise ImportError("there is no shared library of contact2d: " + how + "; ".join(tried))


def program():
    """The path of the program `contact2d`."""
    named = os.environ.get("CONTACT2D_PROGRAM")
    places = [named] if named else [HERE / "bin" / "contact2d"] + ([tree() / "contact2d"] if tree() is not None else [])
    for place in places:
        if os.access(place, os.X_OK):
            return str(place)
    found = None if named else shutil.which("contact2d")
    if found is None:
        raise FileNotFoundError("there is no program contact2d: not " + ", not ".join(str(place) for place in places))
    return found


lib = load()

"""Builds the Python package: a backend for pip (PEP 517, PEP 660) that needs a C++17 compiler and nothing else.

Compiles the library and the program from src/sources.mk, as the Makefile does, and puts them into the package beside its
modules; for `pip install -e` into the build folder of the project, where `make python` renews them. CXX, CPPFLAGS, CXXFLAGS and
LDFLAGS are those of the environment. CONTACT2D_BUILD names a folder in which `make python` has built both already: nothing is
compiled then. A relative one is looked for where pip was called, and in the project. CONTACT2D_ONE_FILE names what `make amalgamation` has made of the core: one file to
compile.
"""

import base64
import concurrent.futures
import hashlib
import io
import os
import pathlib
import platform
import re
import shlex
import shutil
import subprocess
import tarfile
import tempfile
import zipfile

import wheel_tag

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE / "source" if (HERE / "source").exists() else HERE.parents[1]  # in the archive of the package; in the project
NAME = "contact2d"
ENTRY_POINTS = "[console_scripts]\ncontact2d = contact2d.program:main\n"


def version():
    header = (ROOT / "include" / "contact2d.h").read_text(encoding="utf-8")
    return ".".join(re.findall(r"^#define C2D_VERSION_\w+ (\d+)$", header, re.M)[:3])


def metadata():
    return ("Metadata-Version: 2.1\nName: %s\nVersion: %s\n"
            "Summary: Plane elastic contact with Coulomb friction by boundary elements\nLicense: MIT\n"
            "Requires-Python: >=3.8\nDescription-Content-Type: text/markdown\n\n%s" %
            (NAME, version(), (HERE / "README.md").read_text(encoding="utf-8")))


# ---- compiling
def listed(name):
    text = (ROOT / "src" / "sources.mk").read_text(encoding="utf-8")
    return re.findall(r"^%s \+= (\S+)$" % name, text, re.M)


def flags(name, default=""):
    return shlex.split(os.environ.get(name, default))


def compiler():
    found = os.environ.get("CXX") or next((name for name in ("c++", "g++", "clang++") if shutil.which(name)), None)
    if found is None:
        raise RuntimeError("contact2d: there is no C++ compiler (c++, g++ or clang++); CXX names another")
    return shlex.split(found)


def run(words):
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode != 0:
        raise RuntimeError("%s\n%s" % (" ".join(str(word) for word in words), done.stdout.decode("utf-8", "replace")))


def core_flags(source):
    """What the Makefile says of the core and of the files named after an instruction set."""
    name = pathlib.Path(source).stem
    out = ["-fPIC", "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics", "-fno-math-errno"]
    if name.startswith("kernel_"):
        out.append("-ffp-contract=fast")
        if platform.machine() in ("x86_64", "AMD64"):
            out += {"kernel_avx2": ["-mavx2", "-mfma"], "kernel_avx512": ["-mavx512f", "-mfma"]}.get(name, [])
    return out


def batches(sources, folder):
    """Sources that include ten or more each, as the headers of the C++ library take longer to compile than what follows them."""
    out = []
    size = max(10, len(sources) // (2 * (os.cpu_count() or 2)) + 1)
    for i in range(0, len(sources), size):
        out.append(folder / ("program%d.cpp" % i))
        out[-1].write_text("".join('#include "%s"\n' % source for source in sources[i:i + size]), encoding="utf-8")
    return out


def compile_all(folder):
    """libcontact2d.so and contact2d in `folder`."""
    cxx, common = compiler(), ["-std=c++17", "-Isrc", "-Iinclude"] + ["-Iport/" + port for port in listed("PORTS")]
    one = os.environ.get("CONTACT2D_ONE_FILE")
    ports = [source for source in listed("PORT_SOURCES") if not (one and source.startswith("port/memory/"))]
    core = ([str(ROOT / one)] if one else listed("CORE_SOURCES")) + ports
    program = batches(listed("POST_SOURCES") + listed("REPORT_SOURCES") + listed("PROGRAM_SOURCES"), folder)
    objects = {source: folder / (source.replace("/", "_") + ".o") for source in core}
    objects.update((source, source.with_suffix(".o")) for source in program)

    def build(source):
        words = cxx + flags("CPPFLAGS") + common + flags("CXXFLAGS", "-O2") + ["-ffp-contract=off"]
        special = ["-I."] if source in program else core_flags(source)
        done = subprocess.run(words + special + ["-c", str(source), "-o", str(objects[source])], cwd=str(ROOT),
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != 0:
            raise RuntimeError("%s\n%s" % (source, done.stdout.decode("utf-8", "replace")))

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 2) as pool:
        for _ in pool.map(build, core + program):
            pass
    core, program = [objects[source] for source in core], [objects[source] for source in program]
    exports = ["-Wl,--version-script," + str(ROOT / "port" / "packaging" / "contact2d.map"), "-Wl,--as-needed"]
    run(cxx + ["-shared"] + flags("LDFLAGS") + (exports if platform.system() == "Linux" else []) +
        ["-o", folder / "libcontact2d.so"] + core + ["-lm", "-pthread"])
    link = cxx + flags("LDFLAGS") + ["-o", folder / "contact2d"] + program + core + ["-lm", "-pthread"]
    try:
        run(link + ["-static-libstdc++", "-static-libgcc"])
    except RuntimeError:  # where there is no static C++ run-time
        run(link)


def built_files(folder):
    """Library and program in a build folder of make, by their names in the package."""
    return {"libcontact2d.so": folder / ("libcontact2d.so." + version()), "contact2d": folder / "contact2d"}


def given_build():
    """The folder that CONTACT2D_BUILD names; None: there is none named."""
    name = os.environ.get("CONTACT2D_BUILD")
    if not name:
        return None
    places = [pathlib.Path(begin) / name for begin in (os.environ.get("PWD", "."), ROOT, ".")]
    for place in places:
        if all(path.exists() for path in built_files(place).values()):
            return place
    raise RuntimeError("contact2d: CONTACT2D_BUILD=%s: expected libcontact2d.so.%s and contact2d of `make python` in %s" %
                       (name, version(), " or ".join(dict.fromkeys(str(place.absolute()) for place in places))))


def binaries(folder):
    """The files that belong into contact2d/bin, by name."""
    built = given_build()
    if built is not None:
        return built_files(built)
    compile_all(folder)
    return {name: folder / name for name in ("libcontact2d.so", "contact2d")}


# ---- the wheel
class Wheel:
    def __init__(self, file):
        self.archive, self.record = zipfile.ZipFile(str(file), "w", zipfile.ZIP_DEFLATED), []

    def add(self, name, data, mode=0o644):
        info = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
        info.external_attr, info.compress_type = (0o100000 | mode) << 16, zipfile.ZIP_DEFLATED
        self.archive.writestr(info, data)
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        self.record.append("%s,sha256=%s,%d" % (name, digest, len(data)))

    def close(self, folder):
        name = folder + "/RECORD"
        self.add(name, ("\n".join(self.record + [name + ",,"]) + "\n").encode())
        self.archive.close()


MODULES = ("*.py", "*.pyi", "py.typed")


def modules():
    return sorted(path for pattern in MODULES for path in (HERE / NAME).glob(pattern))


def finish(wheel, tag, is_pure):
    """What a wheel says of itself; its name."""
    info = "%s-%s.dist-info" % (NAME, version())
    wheel.add(info + "/METADATA", metadata().encode("utf-8"))
    wheel.add(info + "/WHEEL", ("Wheel-Version: 1.0\nGenerator: build_contact2d\nRoot-Is-Purelib: %s\nTag: %s\n" %
                                (str(is_pure).lower(), tag)).encode())
    wheel.add(info + "/entry_points.txt", ENTRY_POINTS.encode())
    wheel.add(info + "/LICENSE", (ROOT / "LICENSE").read_bytes())
    wheel.close(info)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    with tempfile.TemporaryDirectory() as folder:
        found = binaries(pathlib.Path(folder))
        tag = "py3-none-" + wheel_tag.platform_tag(found.values(), os.environ.get("CXXFLAGS", ""))
        files = {name: path.read_bytes() for name, path in found.items()}
    name = "%s-%s-%s.whl" % (NAME, version(), tag)
    wheel = Wheel(pathlib.Path(wheel_directory) / name)
    for module in modules():
        wheel.add("%s/%s" % (NAME, module.name), module.read_bytes())
    for binary, data in files.items():
        wheel.add("%s/bin/%s" % (NAME, binary), data, 0o755)
    finish(wheel, tag, False)
    return name


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    """A wheel that names the folder of the modules; library and program lie where these look for them."""
    if ROOT == HERE / "source":
        targets = {name: HERE / NAME / "bin" / name for name in built_files(ROOT)}
    else:
        targets = built_files(ROOT / "build")
    if not all(path.exists() for path in targets.values()):
        with tempfile.TemporaryDirectory() as folder:
            for name, path in binaries(pathlib.Path(folder)).items():
                targets[name].parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(str(path), str(targets[name]))
    name = "%s-%s-py3-none-any.whl" % (NAME, version())
    wheel = Wheel(pathlib.Path(wheel_directory) / name)
    wheel.add("__editable__.%s.pth" % NAME, (str(HERE) + "\n").encode("utf-8"))
    finish(wheel, "py3-none-any", True)
    return name


def build_sdist(sdist_directory, config_settings=None):
    """The package with the sources that it is compiled from."""
    base = "%s-%s" % (NAME, version())
    with tarfile.open(str(pathlib.Path(sdist_directory) / (base + ".tar.gz")), "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for name in ("pyproject.toml", "build_contact2d.py", "wheel_tag.py", "README.md"):
            archive.add(str(HERE / name), base + "/" + name)
        for module in modules():
            archive.add(str(module), "%s/%s/%s" % (base, NAME, module.name))
        kept = ["LICENSE", "port/packaging/contact2d.map"]
        for pattern in ("include/*.h", "src/sources.mk", "src/**/*.[ch]pp", "src/**/*.inc", "port/*/*.[ch]*"):
            kept += [str(path.relative_to(ROOT)) for path in ROOT.glob(pattern)]
        for name in sorted(set(kept)):
            archive.add(str(ROOT / name), "%s/source/%s" % (base, name))
        info = tarfile.TarInfo(base + "/PKG-INFO")
        data = metadata().encode("utf-8")
        info.size = len(data)
        archive.addfile(info, io.BytesIO(data))
    return base + ".tar.gz"

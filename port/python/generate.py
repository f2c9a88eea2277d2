"""Writes contact2d/header.py from the C headers: every constant, struct, callback and function, with its comment.

    python3 port/python/generate.py          writes it
    python3 port/python/generate.py --check  says whether it is up to date (exit status 1: no)
"""

import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
OUTPUT = HERE / "contact2d" / "header.py"
FIRST = ["include/contact2d_codes.h", "include/contact2d.h"]  # which the others need
LEFT_OUT = ["include/contact2d_memory.h"]  # constants of the preprocessor for arrays: c2d_memory_need and c2d_tape_need tell
HEADERS = FIRST + sorted(name for pattern in ("include/*.h", "port/[!c]*/c2d_*.h")  # (port/cortex-m is not in the library)
                         for name in (str(path.relative_to(ROOT)) for path in ROOT.glob(pattern))
                         if name not in FIRST + LEFT_OUT)
SCALARS = {"int32_t": "c_int32", "uint32_t": "c_uint32", "int64_t": "c_int64", "uint64_t": "c_uint64",
           "size_t": "c_size_t", "double": "c_double", "char": "c_char", "c2d_status": "c_int32",
           "c2d_outcome": "c_int32"}
HEAD = '''"""The C interface of contact2d, name by name: constants, structs, callbacks and functions of its headers.

Made by port/python/generate.py from the headers; do not edit.
"""

from ctypes import CFUNCTYPE, POINTER, Structure, c_char, c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint32
from ctypes import c_uint64, c_void_p, sizeof


class Struct(Structure):
    """A struct of the interface; one that grows (struct_size) knows its size, as C2D_INIT makes it."""

    def __init__(self, *values, **members):
        if not values and hasattr(type(self), "struct_size"):
            members.setdefault("struct_size", sizeof(self))
        super().__init__(*values, **members)

    def __repr__(self):
        return "%s(%s)" % (type(self).__name__, ", ".join("%s=%r" % (m[0], getattr(self, m[0])) for m in self._fields_))

'''


def statements(text):
    """(comment before it, statement) of a header, without the preprocessor's lines and what only C++ sees."""
    text = re.sub(r"\\\n", " ", text)
    text = re.sub(r"#ifdef __cplusplus\n.*?#(?:else|endif)[^\n]*\n", "", text, flags=re.S)
    comments = []

    def keep(match):
        comments.append(match.group(0)[2:-2])
        return "\1%d\2" % (len(comments) - 1)

    text = re.sub(r"/\*.*?\*/", keep, text, flags=re.S)
    text = "\n".join(line for line in text.split("\n") if not line.startswith("#"))
    for part in split(text, ";"):
        numbers = re.findall("\1(\\d+)\2", re.split(r"\{", part)[0])
        comment = comments[int(numbers[-1])] if numbers else ""
        code = " ".join(re.sub("\1\\d+\2", " ", part).split())
        if code and code != "}":
            yield " ".join(comment.split()), code


def split(text, separator):
    """Parts between separators outside of brackets."""
    parts, depth, begin = [], 0, 0
    for i, c in enumerate(text):
        depth += (c in "([{") - (c in ")]}")
        if c == separator and depth == 0:
            parts.append(text[begin:i].strip())
            begin = i + 1
    parts.append(text[begin:].strip())
    return [part for part in parts if part]


def argument(declaration):
    """(name, type, is const, length of the array or None) of a declaration."""
    function = re.match(r"(.*?)\(\*(\w+)\)\s*\((.*)\)$", declaration)
    if function:
        return function.group(2), callback(function.group(1), function.group(3)), False, None
    name, lengths = re.search(r"(\w+)((?:\[\w+\])*)$", declaration).groups()
    kind = declaration[: declaration.rindex(name + lengths)].strip()
    is_const = kind.startswith("const ")
    kind = kind[6:] if is_const else kind
    stars = kind.count("*")
    kind = kind.replace("*", "").strip()
    length = lengths[1:-1] or None
    return name, pointer_to(kind, stars, is_const), is_const, length


def pointer_to(kind, stars, is_const):
    if stars == 0:
        return SCALARS.get(kind, kind)
    if kind in ("void", "unsigned char", "c2d_solver"):
        return "c_void_p" if stars == 1 else "POINTER(c_void_p)"
    if kind == "char":
        return "c_char_p" if is_const else "c_void_p"
    return "POINTER(%s)" % SCALARS.get(kind, kind)


def arguments(text):
    return [argument(each) for each in split(text, ",")] if text.strip() != "void" else []


def callback(result, text):
    """CFUNCTYPE(...); strings stay addresses, which the function called can write to or measure."""
    kinds = [kind.replace("c_char_p", "c_void_p") for _, kind, _, _ in arguments(text)]
    result = result.strip()
    return "CFUNCTYPE(%s)" % ", ".join(["None" if result == "void" else SCALARS[result]] + kinds)


class Reader:
    def __init__(self):
        self.out, self.functions, self.names = [HEAD], [], {}

    def read(self, text):
        for name, value in re.findall(r"^#define (C2D_\w+) (\d+|\"[^\"]*\")\s*$", text, flags=re.M):
            self.constant(name, value)
        for comment, code in statements(text):
            if code.startswith("enum"):
                self.enum(code)
            elif re.match(r"typedef struct \w+ \{", code):
                self.struct(code)
            elif code.startswith("typedef"):
                self.typedef(code)
            elif "(" in code:
                self.function(comment, code)

    def constant(self, name, value):
        self.names[name] = value
        self.out.append("%s = %s\n" % (name, value))

    def enum(self, code):
        for each in split(code[code.index("{") + 1 : code.rindex("}")], ","):
            name, value = (part.strip() for part in each.split("="))
            self.constant(name, value)

    def struct(self, code):
        name = re.match(r"typedef struct (\w+)", code).group(1)
        members = []
        for declaration in split(code[code.index("{") + 1 : code.rindex("}")], ";"):
            kind = re.match(r"(?:const )?(?:unsigned )?\w+\s*\**", declaration).group(0)
            first, *others = split(declaration, ",") if "(*" not in declaration else [declaration]
            for each in [first] + [kind.replace("*", "") + " " + other for other in others]:
                member, ctype, _, length = argument(each)
                ctype = ctype.replace("c_char_p", "c_void_p")
                members.append('("%s", %s)' % (member, "%s * %s" % (ctype, length) if length else ctype))
        self.out.append("\n\nclass %s(Struct):\n    _fields_ = [\n        %s,\n    ]\n\n\n" %
                        (name, ",\n        ".join(members)))

    def typedef(self, code):
        function = re.match(r"typedef (\w+) \(\*(\w+)\)\s*\((.*)\)$", code)
        if function:
            self.out.append("%s = %s\n" % (function.group(2), callback(function.group(1), function.group(3))))
            return
        task = re.match(r"typedef (void) \(\*(\w+)\)\((.*)\)$", code)
        assert task or re.match(r"typedef (int32_t c2d_\w+|struct c2d_solver c2d_solver)$", code), code

    def function(self, comment, code):
        head, text = code[: code.index("(")], code[code.index("(") + 1 : code.rindex(")")]
        result, function = re.match(r"(.*?)(\w+)$", head).groups()
        result = result.strip()
        ctype = "None" if result == "void" else "c_char_p" if result == "const char*" else SCALARS[result]
        described = ",\n        ".join('("%s", %s, %s, %s)' % (name, "POINTER(%s)" % kind if length else kind, is_const, length)
                                       for name, kind, is_const, length in arguments(text))
        doc = "%s\n\n%s" % (code + ";", comment) if comment else code + ";"
        self.functions.append('    "%s": (%s, [%s], """%s"""),\n' %
                              (function, ctype, "\n        " + described + ",\n    " if described else "", doc))

    def text(self):
        table = ("\n\n# Of every function: what it returns; name, type, whether it is only read, and length of every argument; the\n"
                 "# declaration and the header's comment.\nFUNCTIONS = {\n" + "".join(self.functions) + "}\n")
        return re.sub(r"\n{4,}", "\n\n\n", "".join(self.out) + table)


def made():
    reader = Reader()
    for header in HEADERS:
        reader.read((ROOT / header).read_text(encoding="utf-8"))
    return reader.text()


def write(words, output, text):
    """The command: writes the text, or with --check says whether it stands there; the exit status."""
    if words == ["--check"]:
        same = output.exists() and output.read_text(encoding="utf-8") == text
        print("%s is %s" % (output.name, "up to date" if same else "out of date: python3 " + sys.argv[0]))
        return 0 if same else 1
    output.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(write(sys.argv[1:], OUTPUT, made()))

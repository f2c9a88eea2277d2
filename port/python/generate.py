"""Writes contact2d/header.py from the C headers: every constant, struct, callback and function, with its comment; and
contact2d/methods.pyi, the methods of Solver and Model for type checkers.

    python3 port/python/generate.py          writes them
    python3 port/python/generate.py --check  says whether they are up to date (exit status 1: no)
"""

import ast
import keyword
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
OUTPUT = HERE / "contact2d" / "header.py"
METHODS = HERE / "contact2d" / "methods.pyi"
MODEL = ("set_", "add_", "tie_", "clear_")  # how calls that make a model begin (contact2d/model.py)
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
from typing import Any, Dict, List, Tuple


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
                 "# declaration and the header's comment.\nFUNCTIONS: Dict[str, Tuple[Any, List[Tuple[str, Any, bool, Any]], str]] = {\n" + "".join(self.functions) + "}\n")
        return re.sub(r"\n{4,}", "\n\n\n", "".join(self.out) + table)


def made():
    reader = Reader()
    for header in HEADERS:
        reader.read((ROOT / header).read_text(encoding="utf-8"))
    return reader.text()


# ---- the methods, for type checkers
PLAIN = {"c_int32": "int", "c_uint32": "int", "c_int64": "int", "c_uint64": "int", "c_size_t": "int", "c_double": "float",
         "c_char_p": "Union[str, bytes]", "c_void_p": "Any"}
COUNTS = ("cases", "zones")  # of the list before them, as contact2d/calls.py has it
PYI = '''"""Made by port/python/generate.py from the headers; do not edit."""

from types import SimpleNamespace
from typing import Any, Iterable, List, Optional, Tuple, Union

Numbers = Any  # a number, a list of numbers or an array of numpy


'''


def written_methods():
    """Those of class Solver that contact2d/solver.py itself has."""
    tree = ast.parse((HERE / "contact2d" / "solver.py").read_text(encoding="utf-8"))
    solver = next(node for node in tree.body if isinstance(node, ast.ClassDef) and node.name == "Solver")
    return {node.name for node in solver.body if isinstance(node, ast.FunctionDef)}


def hint_of(kind, length):
    """(type, may it be left out?) of what is given for an argument."""
    pointed = re.match(r"POINTER\((\w+)\)", kind)
    if not pointed:
        return PLAIN.get(kind, "Any"), False
    if pointed.group(1).startswith("c2d_"):
        return "Any", True
    hint = "Iterable[int]" if pointed.group(1) == "c_int32" else "Numbers"
    return "Optional[%s]" % hint if length else hint, length is not None


def returned(kind, length):
    value = PLAIN.get(re.match(r"POINTER\((\w+)\)", kind).group(1), "SimpleNamespace")
    return "List[%s]" % value if length else value


def stub(name, described, returns=None):
    """The declaration of one method; outputs are what it returns unless `returns` says so."""
    words, out, is_last = [], [], True
    for argument_name, kind, is_const, length in reversed(described[1:]):
        if kind.startswith("POINTER") and not is_const:
            out.insert(0, returned(kind, length))
        elif argument_name not in COUNTS:
            hint, is_optional = hint_of(kind, length)
            is_last = is_last and is_optional
            words.insert(0, "%s: %s%s" % (argument_name, hint, " = ..." if is_last else ""))
    if any(is_const and kind.startswith("POINTER(c2d_") for _, kind, is_const, _ in described):
        words.append("**members: Any")
    if any(keyword.iskeyword(word.split(":")[0]) for word in words):
        words = ["*given: Any", "**named: Any"]
    result = returns or (out[0] if len(out) == 1 else "Tuple[%s]" % ", ".join(out) if out else "None")
    return "    def %s(%s) -> %s: ...\n" % (name, ", ".join(["self"] + words), result)


def made_methods():
    functions = {}
    for header in HEADERS:
        text = (ROOT / header).read_text(encoding="utf-8")
        for _, code in statements(text):
            if re.match(r"(?!typedef|enum).*\w+\(", code) and "{" not in code:
                head, given = code[: code.index("(")], code[code.index("(") + 1 : code.rindex(")")]
                described = [(name, "POINTER(%s)" % kind if length else kind, is_const, length)
                             for name, kind, is_const, length in arguments(given)]
                functions[re.search(r"(\w+)$", head).group(1)] = described
    own = {name[4:]: described for name, described in functions.items() if described and described[0][0] == "solver"}
    out, written = [PYI, "class SolverCalls:\n"], written_methods()
    out += [stub(name, described) for name, described in own.items() if name not in written]
    out += ["\n\nclass ModelCalls:\n"]
    out += [stub(name, described, "None") for name, described in own.items() if name.startswith(MODEL) and name != "set_nodes"]
    return "".join(out) + "    def set_nodes(self, body: int, first: int, xy: Any) -> None: ...\n"


def write(words, output, text):
    """The command: writes the text, or with --check says whether it stands there; the exit status."""
    if words == ["--check"]:
        same = output.exists() and output.read_text(encoding="utf-8") == text
        print("%s is %s" % (output.name, "up to date" if same else "out of date: python3 " + sys.argv[0]))
        return 0 if same else 1
    output.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(write(sys.argv[1:], OUTPUT, made()) or write(sys.argv[1:], METHODS, made_methods()))

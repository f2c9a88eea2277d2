"""Writes contact2d.f90 from the C headers: every constant, struct, callback and function.

    python3 port/fortran/generate.py          writes it
    python3 port/fortran/generate.py --check  says whether it is up to date (exit status 1: no)

What is not a matter of the headers (how texts become strings) stands in contact2d.f90.in, with @DECLARATIONS@ in the place of the rest.
"""

import ctypes
import importlib.util
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
OUTPUT = HERE / "contact2d.f90"
WIDTH = 118
KINDS = {"int32_t": "integer(c_int32_t)", "uint32_t": "integer(c_int32_t)", "int64_t": "integer(c_int64_t)",
         "uint64_t": "integer(c_int64_t)", "size_t": "integer(c_size_t)", "double": "real(c_double)",
         "char": "character(kind=c_char)", "c2d_status": "integer(c_int32_t)", "c2d_outcome": "integer(c_int32_t)"}
FIRST_VALUES = {"integer": "0", "real": "0", "character": "c_null_char", "type(c_ptr)": "c_null_ptr",
                "type(c_funptr)": "c_null_funptr"}
SHARED = {"read": "transfer", "write": "transfer", "sync": "tape", "close": "tape", "start_read": "start",
          "start_write": "start"}  # members of c2d_port of one interface
COUNTS = ("cases", "zones", "size")  # an argument of these names is the length of the array before it


def headers():
    """The reader of the headers that the Python package has."""
    at = HERE.parent / "python" / "generate.py"
    spec = importlib.util.spec_from_file_location("c2d_headers", str(at))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


READ = headers()


def sizes():
    """Bytes of every struct: as ctypes lays out what the same reader makes of it."""
    names = {}
    exec(READ.made(), names)  # pylint: disable=exec-used
    return {name: ctypes.sizeof(kind) for name, kind in names.items()
            if isinstance(kind, type) and issubclass(kind, names["Struct"]) and
            hasattr(kind, "_fields_")}


class Declaration:
    """A member or an argument in C: its type without stars, how many there are, its name and the lengths of an array."""

    def __init__(self, text):
        function = re.match(r"(.*?)\(\*(\w+)\)\s*\((.*)\)$", text)
        self.function = (function.group(1).strip(), function.group(3)) if function else None
        if function:
            self.name, self.lengths, kind = function.group(2), [], ""
        else:
            self.name, lengths = re.search(r"(\w+)((?:\[\w+\])*)$", text).groups()
            self.lengths = re.findall(r"\[(\w+)\]", lengths)
            kind = text[: text.rindex(self.name + lengths)].strip()
        self.is_const = kind.startswith("const ")
        kind = kind[6:] if self.is_const else kind
        self.stars, self.kind = kind.count("*"), kind.replace("*", "").strip()

    def fortran(self, callbacks):
        """The type that a value of this kind has."""
        if self.function or self.kind in callbacks:
            return "type(c_funptr)"
        return KINDS.get(self.kind, "type(c_ptr)" if self.kind in ("void", "c2d_solver", "FILE", "unsigned char")
                         else "type(%s)" % self.kind)


def declarations(text):
    return [Declaration(each) for each in READ.split(text, ",")] if text.strip() not in ("", "void") else []


def wrapped(line, indent):
    """The line, continued where it is too long."""
    out, rest = [], line
    while len(rest) > WIDTH:
        cut = rest.rindex(", ", 0, WIDTH) + 2
        out.append(rest[:cut] + "&")
        rest = " " * (indent + 4) + rest[cut:]
    return out + [rest]


class Module:
    def __init__(self):
        self.constants, self.structs, self.callbacks, self.functions = [], [], [], []
        self.callback_names, self.interfaces = set(), set()
        self.bytes = sizes()

    def read(self, name, text):
        self.constants += ["", "  ! ---- numbers of " + name]
        for constant, value in re.findall(r"^#define (C2D_(?!VERSION)\w+) (\d+)\s*$", text, flags=re.M):
            self.number([(constant, value)])
        if self.constants[-1].startswith("  ! ----") and "enum" not in text:
            del self.constants[-2:]
        for _, code in READ.statements(text):
            if code.startswith("enum"):
                self.number([tuple(part.strip() for part in each.split("="))
                             for each in READ.split(code[code.index("{") + 1 : code.rindex("}")], ",")])
            elif re.match(r"typedef struct \w+ \{", code):
                self.struct(code)
            elif code.startswith("typedef"):
                self.typedef(code)
            elif "(" in code:
                self.function(code)

    def number(self, values):
        line = "  integer(c_int32_t), parameter :: " + ", ".join("%s = %s" % each for each in values)
        self.constants += wrapped(line, 2)

    def struct(self, code):
        name = re.match(r"typedef struct (\w+)", code).group(1)
        self.structs += ["", "  type, bind(C) :: " + name]
        for text in READ.split(code[code.index("{") + 1 : code.rindex("}")], ";"):
            kind = re.match(r"(?:const )?(?:unsigned )?\w+\s*\**", text).group(0)
            first, *others = READ.split(text, ",") if "(*" not in text else [text]
            for each in [first] + [kind.replace("*", "") + " " + other for other in others]:
                self.member(name, Declaration(each))
        self.structs.append("  end type")

    def member(self, struct, member):
        kind = "type(c_ptr)" if member.stars else member.fortran(self.callback_names)
        shape = "(%s)" % ", ".join(reversed(member.lengths)) if member.lengths else ""
        first = self.bytes[struct] if member.name == "struct_size" else FIRST_VALUES.get(kind.split("(")[0], FIRST_VALUES.get(kind))
        self.structs.append("    %s :: %s%s%s" % (kind, member.name, shape, "" if first is None else " = %s" % first))
        if member.function and struct == "c2d_port" and member.name != "log":  # which is a c2d_report
            name = "c2d_port_" + SHARED.get(member.name, member.name)
            for argument in declarations(member.function[1]):
                if argument.function:
                    self.callback("c2d_port_" + argument.name, *argument.function)
            self.callback(name, *member.function)

    def typedef(self, code):
        function = re.match(r"typedef (\w+) \(\*(\w+)\)\s*\((.*)\)$", code)
        if function:
            self.callback_names.add(function.group(2))
            self.callback(function.group(2), function.group(1), function.group(3))

    def callback(self, name, result, text):
        if name not in self.interfaces:
            self.interfaces.add(name)
            self.callbacks += self.procedure(name, result, declarations(text), "bind(C)")

    def function(self, code):
        head, text = code[: code.index("(")], code[code.index("(") + 1 : code.rindex(")")]
        result, name = re.match(r"(.*?)(\w+)$", head).groups()
        text_result = result.strip() == "const char*"  # the module's own function of that name makes a string of it
        self.functions += self.procedure(name + "_address" if text_result else name, result.strip(), declarations(text),
                                         "bind(C, name='%s')" % name if text_result else "bind(C)")

    def procedure(self, name, result, arguments, binding):
        word = "subroutine" if result == "void" else "function"
        names = [a.name for a in arguments]
        answer = next(each for each in ("status", "answer", "result_") if each not in names)
        head = "    %s %s(%s) %s%s" % (word, name, ", ".join(names), binding,
                                       "" if result == "void" else " result(%s)" % answer)
        kinds = [(self.kind(a, arguments[i + 1 :]), a.name, self.shape(a, arguments[i + 1 :])) for i, a in enumerate(arguments)]
        kinds.sort(key=lambda each: each[2] != "")  # lengths before the arrays that have them
        out = wrapped(head, 4) + (["      import"] if names or result != "void" else [])
        out += ["      %s :: %s%s" % each for each in kinds]
        if result != "void":
            out.append("      %s :: %s" % ("type(c_ptr)" if "*" in result else KINDS[result], answer))
        return out + ["    end " + word]

    def shape(self, a, after):
        if a.lengths:
            return "(%s)" % ", ".join(reversed(a.lengths))
        following = after[0].name if after else ""
        if a.stars != 1 or a.fortran(self.callback_names).startswith("type(c_"):
            return ""
        if following in ("stride", a.name + "_stride"):
            return "(%s,*)" % following
        if following in COUNTS:
            return "(%s)" % following
        return "(*)" if following == "bodies" or a.kind == "char" else ""

    def kind(self, a, after):
        kind = a.fortran(self.callback_names)
        if a.stars == 2:
            return "type(c_ptr), intent(out)"
        if (a.stars == 0 and not a.lengths) or (a.stars == 1 and kind == "type(c_ptr)"):
            return kind + ", value"
        if a.is_const:
            return kind + ", intent(in)"
        whole = not kind.startswith("type(") and "*" not in self.shape(a, after) and a.name != "text"
        return kind + (", intent(out)" if whole else ", intent(inout)")

    def text(self):
        parts = (self.constants[1:] +
                 ["", "  ! ---- structs: each is a first value of itself, `type(c2d_limits) :: limits`, as C2D_INIT makes it"] +
                 self.structs[1:] +
                 ["", "  ! ---- functions of the caller's. None of them may STOP.", "  abstract interface"] + self.callbacks +
                 ["  end interface", "", "  ! ---- functions", "  interface"] + self.functions + ["  end interface"])
        return (HERE / "contact2d.f90.in").read_text(encoding="utf-8").replace("@DECLARATIONS@", "\n".join(parts))


def made():
    module = Module()
    for header in READ.HEADERS:
        module.read(header.split("/")[-1], (ROOT / header).read_text(encoding="utf-8"))
    return module.text()


if __name__ == "__main__":
    sys.exit(READ.write(sys.argv[1:], OUTPUT, made()))

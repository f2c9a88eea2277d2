"""Runs the cells of a notebook (.ipynb) without any other package, and compares their outputs with those kept in it.

    python3 tests/python/notebook.py examples/hertz.ipynb           says what differs (exit status 1: something does)
    python3 tests/python/notebook.py examples/hertz.ipynb --write   keeps the outputs

Numbers are compared to 1 %, text to the letter.
"""

import ast
import contextlib
import io
import json
import os
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, os.environ.get("C2D_PYTHON_PACKAGE", str(ROOT / "port" / "python")))
NUMBER = re.compile(r"[-+]?\d+\.?\d*(?:e[-+]?\d+)?")
SHOWN = {"image/svg+xml": "_repr_svg_", "text/html": "_repr_html_"}


def lines_of(text):
    return text.splitlines(keepends=True)


def shown(value):
    """What a notebook keeps of the value of a cell's last expression."""
    data = {kind: lines_of(getattr(value, name)()) for kind, name in SHOWN.items() if hasattr(value, name)}
    data["text/plain"] = lines_of(repr(value))
    return data


def run_cell(source, names, count):
    """The outputs of a cell."""
    tree, printed, value = ast.parse(source), io.StringIO(), None
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, "cell %d" % count, "exec"), names)
        if last is not None:
            value = eval(compile(ast.Expression(last.value), "cell %d" % count, "eval"), names)
    outputs = []
    if printed.getvalue():
        outputs.append({"name": "stdout", "output_type": "stream", "text": lines_of(printed.getvalue())})
    if value is not None:
        outputs.append({"data": shown(value), "execution_count": count, "metadata": {}, "output_type": "execute_result"})
    return outputs


def run(notebook):
    """A list of the outputs of every cell that is code."""
    names, out = {"__name__": "__main__"}, []
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            out.append(run_cell("".join(cell["source"]), names, len(out) + 1))
    return out


def is_same(kept, made):
    """The same text with the same numbers, to 1 % of their size (of 1 in pictures, whose numbers are places)?"""
    if NUMBER.sub("#", kept) != NUMBER.sub("#", made):
        return False
    pairs = zip(map(float, NUMBER.findall(kept)), map(float, NUMBER.findall(made)))
    return all(abs(a - b) <= 0.01 * max(abs(a), abs(b), 1.0 if "<svg" in kept else 0.0) for a, b in pairs)


def texts(outputs):
    for output in outputs:
        parts = {"stream": output["text"]} if output["output_type"] == "stream" else output["data"]
        for kind, text in parts.items():
            yield kind, "".join(text)


def differences(notebook, made):
    codes = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    for i, (cell, outputs) in enumerate(zip(codes, made), 1):
        kept, now = list(texts(cell["outputs"])), list(texts(outputs))
        if [kind for kind, _ in kept] != [kind for kind, _ in now]:
            yield "cell %d shows %s, kept is %s" % (i, [kind for kind, _ in now], [kind for kind, _ in kept])
            continue
        for (kind, before), (_, text) in zip(kept, now):
            if not is_same(before, text):
                yield "cell %d, %s: %r, kept is %r" % (i, kind, text[:300], before[:300])


def main(words):
    path = pathlib.Path(words[0]).resolve()
    notebook = json.loads(path.read_text(encoding="utf-8"))
    os.chdir(str(path.parent))
    made = run(notebook)
    if words[1:] == ["--write"]:
        codes = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
        for i, (cell, outputs) in enumerate(zip(codes, made), 1):
            cell["outputs"], cell["execution_count"] = outputs, i
        path.write_text(json.dumps(notebook, indent=1, sort_keys=True) + "\n", encoding="utf-8")
        return 0
    found = list(differences(notebook, made))
    print("\n".join(found) or "%s: the outputs are those kept" % path.name)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

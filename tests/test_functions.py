"""How long functions are."""

import ast
from pathlib import Path

_ROOT = Path(__file__).parents[1]
_MOST_LINES = 59


def lines_of(function):
    """Lines of a function, those of its docstring left out."""
    first = function.body[0]
    documented = ast.get_docstring(function, clean=False) is not None
    of_docstring = first.end_lineno - first.lineno + 1 if documented else 0
    return function.end_lineno - function.lineno + 1 - of_docstring


def test_functions_fit_on_a_screen():
    files = [file for room in ("workbench", "ui") for file in (_ROOT / room).rglob("*.py")]
    functions = {
        f"{file.relative_to(_ROOT)}:{node.lineno} {node.name}": lines_of(node)
        for file in files
        for node in ast.walk(ast.parse(file.read_text("utf-8")))
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
    }
    assert len(functions) > 1000
    assert {name: count for name, count in functions.items() if count > _MOST_LINES} == {}

"""Functions that stand twice: the same body, but for the names of what is local to it."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence
from itertools import islice

from benchmarks.modules import File, Function

FEWEST_NODES = 40  # of a body: two that are shorter may well say the same by chance


def duplicates(files: Sequence[File]) -> list[str]:
    """A line for every function whose body stands in an earlier one too."""
    first: dict[str, str] = {}
    found = []
    for file in files:
        for function in file.functions():
            place = f"{file.path.as_posix()}:{function.lineno} {function.name}"
            for body in _bodies(function):
                if body in first:
                    found.append(f"{place}: stands in {first[body]} too")
                first.setdefault(body, place)
    return found


def _bodies(function: Function) -> Iterator[str]:
    """The body as a text in which local names are numbered; nothing where it is short."""
    described = ast.get_docstring(function) is not None
    statements = function.body[1:] if described else function.body
    nodes = (node for statement in statements for node in ast.walk(statement))
    if next(islice(nodes, FEWEST_NODES - 1, None), None) is None:
        return
    numbers = _numbers(function)
    yield "\n".join(_dump(statement, numbers) for statement in statements)


def _numbers(function: Function) -> dict[str, str]:
    """A number for each local name, in the order in which they first stand."""
    parameters = [node.arg for node in ast.walk(function.args) if isinstance(node, ast.arg)]
    stored = [
        node.id
        for node in ast.walk(function)
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)
    ]
    names = dict.fromkeys([*parameters, *stored])
    return {name: f"local {number}" for number, name in enumerate(names)}


def _dump(node: object, numbers: dict[str, str]) -> str:
    match node:
        case ast.Name(id=name):
            return numbers.get(name, name)
        case ast.AST():
            fields = (_dump(value, numbers) for _, value in ast.iter_fields(node))
            return f"{type(node).__name__}({', '.join(fields)})"
        case list():
            return f"[{', '.join(_dump(each, numbers) for each in node)}]"
        case _:
            return repr(node)

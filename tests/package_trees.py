"""The modules of the package as trees, and who imports whom."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from pathlib import Path

import kinegrade
from tests.package_files import package_files

PACKAGE = Path(kinegrade.__file__).parent
ROOT = PACKAGE.parent
LOBBY = {"kinegrade", "kinegrade.__main__"}  # the entrances, which call any floor


def module_name(file: Path) -> str:
    parts = file.relative_to(ROOT).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


@cache
def read_texts() -> Mapping[str, str]:
    """The modules of the package."""
    return {module_name(ROOT / file.path): file.text for file in package_files()}


@cache
def read_trees() -> Mapping[str, ast.Module]:
    """The modules of the package, parsed."""
    return {module_name(ROOT / file.path): file.tree for file in package_files()}


@cache
def list_nodes(tree: ast.AST) -> tuple[ast.AST, ...]:
    """All nodes of a tree, found once: many laws ask each of them."""
    return tuple(ast.walk(tree))


def imported(nodes: Iterable[ast.AST]) -> Iterator[str]:
    """The modules that import statements name; `from package import module` names the module."""
    for node in nodes:
        if isinstance(node, ast.Import):
            yield from (name.name for name in node.names)
        elif isinstance(node, ast.ImportFrom):
            module = node.module or ""
            for name in node.names:
                inner = f"{module}.{name.name}"
                yield inner if inner in read_trees() else module


def floor(module: str) -> str:
    return module.split(".")[1]


def edges() -> Iterator[tuple[str, str]]:
    """Who imports whom inside the package, wherever in the file."""
    for module, tree in read_trees().items():
        for target in imported(list_nodes(tree)):
            if target.startswith("kinegrade.") and not {module, target} & LOBBY:
                yield module, target


def texts_without_docstrings(tree: ast.AST) -> Iterator[str]:
    """The string constants of a module, parts of f-strings too; no docstrings."""
    documented = ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef
    docstrings = {
        id(node.body[0].value)
        for node in list_nodes(tree)
        if isinstance(node, documented) and node.body and isinstance(node.body[0], ast.Expr)
    }
    for node in list_nodes(tree):
        match node:
            case ast.Constant(value=str(text)) if id(node) not in docstrings:
                yield text

"""The descriptions that stand beside the words of a table: comments that begin with `#:`."""

from __future__ import annotations

import ast
import io
import tokenize
from collections.abc import Iterator, Mapping
from functools import cache
from importlib import import_module
from pathlib import Path

_MARK = "#:"


def read_words(module: str, name: str) -> Mapping[str, str]:
    """The words of the table under that name of a module, each with its description.

    The table is a tuple, a literal type, the keys of a dictionary or the fields of a class. Raises
    KeyError for a word that has no description.

    >>> read_words("kinegrade.exam.bank.keys", "FAMILY")
    {'family': 'Draws from the shipped templates of this family, once for the class.'}
    """
    comments, tree = _read_module(module)
    (table,) = (node for node in tree.body if name in _names(node))
    return {word: comments[line] for word, line in _list_words(table)}


def read_constants(module: str) -> Mapping[str, str]:
    """The constants of a module that have a description, by name."""
    comments, tree = _read_module(module)
    return {
        name: comments[node.lineno]
        for node in tree.body
        for name in _names(node)
        if node.lineno in comments
    }


@cache
def _read_module(module: str) -> tuple[Mapping[int, str], ast.Module]:
    """The descriptions of a module by the line below them, and what stands in it."""
    text = Path(str(import_module(module).__file__)).read_text(encoding="utf-8")
    return dict(_read_comments(text)), ast.parse(text)


def _read_comments(text: str) -> Iterator[tuple[int, str]]:
    lines: list[str] = []
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT and token.string.startswith(_MARK):
            lines.append(token.string.removeprefix(_MARK).strip())
        elif lines and token.type not in (tokenize.NL, tokenize.COMMENT):
            yield token.start[0], " ".join(lines)
            lines = []


def _names(node: ast.stmt) -> list[str]:
    """What a statement gives a name to."""
    match node:
        case ast.Assign(targets=targets):
            return [target.id for target in targets if isinstance(target, ast.Name)]
        case ast.AnnAssign(target=ast.Name(id=name)) | ast.ClassDef(name=name):
            return [name]
        case _:
            return []


def _list_words(table: ast.stmt) -> Iterator[tuple[str, int]]:
    """The words of a table with their lines."""
    match table:
        case ast.ClassDef(body=fields):
            for field in fields:
                if isinstance(field, ast.AnnAssign) and isinstance(field.target, ast.Name):
                    yield field.target.id, field.lineno
        case ast.Assign(value=value) | ast.AnnAssign(value=ast.expr() as value):
            yield from _list_constants(value)


def _list_constants(value: ast.expr) -> Iterator[tuple[str, int]]:
    match value:
        case ast.Subscript(slice=inner):
            yield from _list_constants(inner)
        case ast.Tuple(elts=entries) | ast.Dict(keys=entries):
            for entry in entries:
                if isinstance(entry, ast.Constant):
                    yield str(entry.value), entry.lineno

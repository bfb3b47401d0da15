"""Finds the words of a language that stand in code instead of in the catalogues."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass

FILLED = "{}"  # what an f-string fills in
FOR_PROGRAMMERS = {
    "ArithmeticError",
    "AssertionError",
    "IndexError",
    "LookupError",
    "NotImplementedError",
    "TypeError",
    "ValueError",
}
CODE = (
    re.compile(r"<[?!/]?[\w:]+(?:\s[^<>]*)?/?>?"),  # of XML, HTML and SVG
    re.compile(r"\s[\w:-]+=\"[^\"]*\"?"),  # an attribute whose tag is written elsewhere
    re.compile(r"^#.*|^\s*(?:set|place)[ (].*", re.MULTILINE),  # of Typst
    re.compile(r"[\w-]+\("),  # a call: in a sentence a space stands before the bracket
    re.compile(r"\\(?!text)[a-zA-Z]+(?:\{[^{}]*\})*"),  # a command of TeX and its arguments
    re.compile(r".*(?:\(\?|\\[wdbs(]|\.[*+]).*", re.DOTALL),  # a regular expression
)
SPOKEN = re.compile(r"\b(?:alt|title|aria-label)=\"([^\"]*)")  # what readers of a page are told
WORDS = re.compile(r"[^\W\d_]{2,}[,:;]? (?:[^\W\d_]{2,}|\{\})|\{\}[,:;]? [^\W\d_]{2,}")
FOREIGN = re.compile(r"[À-ÖØ-öø-ʯ぀-ヿ㐀-鿿]")


@dataclass(frozen=True)
class Found:
    """A text that has words, and its line."""

    line: int
    text: str


def find_words(tree: ast.Module) -> Iterator[Found]:
    """The texts of a module that have words of a language, docstrings and errors for programmers
    left out.
    """
    passed = set(_list_passed(tree))
    for node in ast.walk(tree):
        if node not in passed and isinstance(node, ast.Constant | ast.JoinedStr):
            text = _read_text(node)
            if has_words(text):
                yield Found(node.lineno, text)


def has_words(text: str) -> bool:
    """Whether a text says something, after what is code in it is taken out."""
    spoken = " ".join(SPOKEN.findall(text))
    for code in CODE:
        text = code.sub("", text)
    return any(WORDS.search(each) or FOREIGN.search(each) for each in (text, spoken))


def _list_passed(tree: ast.Module) -> Iterator[ast.AST]:
    """What is read as part of something else, and what users never see."""
    for node in ast.walk(tree):
        match node:
            case ast.Expr(value=ast.Constant() as docstring):
                yield docstring
            case ast.JoinedStr():
                yield from (value for value in node.values if isinstance(value, ast.Constant))
            case ast.Raise(exc=ast.Call(func=ast.Name(id=name)) as error):
                if name in FOR_PROGRAMMERS:
                    yield from ast.walk(error)
            case ast.Call(func=ast.Attribute(value=ast.Constant() as names, attr="split")):
                yield names  # one after another, not a sentence


def _read_text(node: ast.Constant | ast.JoinedStr) -> str:
    """A text with `{}` where something is filled in."""
    match node:
        case ast.JoinedStr():
            parts = (v.value if isinstance(v, ast.Constant) else FILLED for v in node.values)
            return "".join(map(str, parts))
        case ast.Constant(value=str() as text):
            return text
        case _:
            return ""

"""Brackets in Typst math, which matches those itself that have their other half in the same row."""

from __future__ import annotations

from collections.abc import Iterable

from kinegrade.language.math.letters import SIGNS
from kinegrade.language.math.tree import Node, Row, Scripts, Sign

TYPED = {sign: sign for sign in "()[]"} | {r"\{": "{", r"\}": "}"}  # Typst matches these itself


def find_matched(row: Row) -> Iterable[int]:
    """The places of the brackets that have their other half in the same row."""
    open_brackets: list[int] = []
    for place, node in enumerate(row):
        match find_bracket(node):
            case "opening":
                open_brackets.append(place)
            case "closing" if open_brackets:
                yield from (open_brackets.pop(), place)


def find_bracket(node: Node) -> str:
    """Which half of brackets a node is, with or without scripts; "" for all else."""
    if isinstance(node, Sign) and node.latex in TYPED:
        return SIGNS[node.latex].kind
    carrier = node.base if isinstance(node, Scripts) else None
    if isinstance(carrier, Sign) and SIGNS[carrier.latex].kind == "closing":
        return "closing"
    return ""

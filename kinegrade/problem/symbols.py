"""Symbols as authors write them: LaTeX math without dollar signs, from a small alphabet, so that
every back end can set them and none can be led astray.
"""

from __future__ import annotations

import re

from kinegrade.errors import TypesetError, did_you_mean
from kinegrade.language.math.letters import GREEK
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Group, Node, Scripts, list_nodes

_COMMANDS = frozenset(
    (
        *GREEK,
        "mathrm",
        "mathbf",
        "boldsymbol",
        "vec",
        "dot",
        "ddot",
        "bar",
        "sqrt",
        "frac",
        "prime",
        "circ",
        "cdot",
        "infty",
    )
)
_LETTERS = re.compile(r"(?:\\[A-Za-z]+|[A-Za-z0-9 _^{}'()+\-=.,])+")


def find_symbol_fault(symbol: str) -> str | None:
    """What is wrong with a symbol, or None: LaTeX math from the small alphabet, braces balanced."""
    if not symbol.strip():
        return "a blank symbol - write LaTeX math without dollar signs, such as '\\omega_{AB}'"
    if not _LETTERS.fullmatch(symbol):
        return (
            f"{symbol!r} has characters no symbol needs - use letters, digits, _ ^ {{ }} ' and "
            "LaTeX commands"
        )
    unknown = sorted(set(re.findall(r"\\([A-Za-z]+)", symbol)) - _COMMANDS)
    if unknown:
        return f"unknown LaTeX command \\{unknown[0]} - {did_you_mean(unknown[0], _COMMANDS)}"
    if not _is_complete(symbol):
        return f"{symbol!r} is incomplete - close every brace, give every _ and ^ one thing"
    return None


def _is_complete(symbol: str) -> bool:
    """Whether braces close, every script and every command has what it acts on, and no script comes
    twice.
    """
    try:
        row = read_math(symbol, "symbol")
    except TypesetError:
        return False
    return not any(_is_bare(node) for node in list_nodes(row))


def _is_bare(node: Node) -> bool:
    """Whether scripts stand on nothing, or on scripts, as the second of `a_1_2` does."""
    match node:
        case Scripts(base=None | Group((Scripts(),))):
            return True
        case _:
            return False

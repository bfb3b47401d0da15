"""Symbols as authors write them: LaTeX math without dollar signs, from a small alphabet, so that
every back end can set them and none can be led astray.
"""

from __future__ import annotations

from string import ascii_letters, digits

from kinegrade.errors import TypesetError, suggest
from kinegrade.language.math.letters import GREEK
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tokens import split_tokens
from kinegrade.language.math.tree import Group, Node, Scripts, list_nodes
from kinegrade.language.message import Message, Quoted

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
        "angle",
        "perp",
        "parallel",
        "left",
        "right",
    )
)
_CHARACTERS = frozenset((*ascii_letters, *digits, *"_^{}'()|+-/=.,", "{,}"))


def find_symbol_fault(symbol: str) -> Message | None:
    """What is wrong with a symbol, or None: LaTeX math from the small alphabet, braces balanced."""
    if not symbol.strip():
        return Message("template.symbol-blank")
    tokens = split_tokens(symbol)
    commands = {token.removeprefix("\\") for token in tokens if token.startswith("\\")}
    if any(token not in _CHARACTERS and not token.startswith("\\") for token in tokens):
        return Message("template.symbol-characters", symbol=Quoted(symbol))
    unknown = sorted(commands - _COMMANDS)
    if unknown:
        hint = suggest(unknown[0], _COMMANDS)
        return Message("template.symbol-command", command=f"\\{unknown[0]}", hint=hint)
    if not _is_complete(symbol):
        return Message("template.symbol-incomplete", symbol=Quoted(symbol))
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
    if not isinstance(node, Scripts):
        return False
    carrier = node.base.row if isinstance(node.base, Group) else ()
    return node.base is None or (len(carrier) == 1 and isinstance(carrier[0], Scripts))

"""The room a label takes, estimated from its tree, never too small, in em.

Labels are placed by it, and what cannot be placed is not dealt: to change a number here is to
change which papers are dealt.
"""

from __future__ import annotations

from typing import assert_never

from kinegrade.language.math.tree import (
    Accent,
    Environment,
    Fenced,
    Function,
    Group,
    Letter,
    Lettering,
    LineBreak,
    Mark,
    Node,
    Number,
    Quotient,
    Root,
    Row,
    Scripts,
    Sign,
    Space,
    Text,
    Unit,
    list_nodes,
    list_parts,
)

_WIDE = {
    "m": 0.92,
    "w": 0.78,
    "M": 1.05,
    "W": 1.05,
    "omega": 0.72,
    "infty": 1.05,
    "Omega": 0.82,
    "=": 1.35,
    "+": 1.3,
    "-": 1.3,
}
_NARROW = {
    "i": 0.4,
    "j": 0.45,
    "l": 0.38,
    "t": 0.42,
    ",": 0.45,
    "{,}": 0.45,
    ".": 0.33,
    "prime": 0.3,
    "(": 0.42,
    ")": 0.42,
    "I": 0.55,
}
_RISING_AND_FALLING = frozenset(("beta", "psi", "phi", "zeta", "xi", "f", "j", "Q"))
_SCRIPT = 0.72
_PRIME = 0.3
_TALL = 1.15  # times the height of a capital
_SIDES = 0.12
_BOLDER = 0.1


def measure_label(row: Row) -> tuple[float, float]:
    """Width and height of a label, in em."""
    nodes = tuple(list_nodes(row))
    tall = 1.9 if any(isinstance(node, Quotient) for node in nodes) else 1.0
    if any(isinstance(node, Letter | Sign) and _rises_and_falls(node) for node in nodes):
        tall = max(tall, _TALL)
    scripts = sum(
        (node.lower is not None) + (node.upper is not None)
        for node in nodes
        if isinstance(node, Scripts)
    )
    return measure_advance(row) + _SIDES, 0.8 * tall + 0.28 * min(scripts, 2)


def measure_advance(row: Row) -> float:
    """The width of a row, in em. The scripts of one base stand one above the other."""
    return sum(_measure(node) for node in row)


def _measure(node: Node) -> float:
    match node:
        case Scripts(base, lower, primes, upper):
            carried = 0.0 if base is None else _measure(base)
            scripts = max(_add_all(lower or ()), _add_all(upper or ()))
            return carried + _PRIME * primes + _SCRIPT * scripts
        case Group() | Quotient() | Root() | Lettering() | Accent() | Fenced() | Environment():
            return _measure_alone(node) + sum(map(measure_advance, list_parts(node)))
        case Letter() | Number() | Sign() | Function() | Text() | Unit():
            return _measure_alone(node)
        case Space() | LineBreak() | Mark():
            return _measure_alone(node)
        case _:
            assert_never(node)


def _add_all(row: Row) -> float:
    """The width of all letters of a script side by side, as if none of them were smaller."""
    return sum(_measure_alone(node) for node in list_nodes(row))


def _measure_alone(node: Node) -> float:
    """The width of a node without its parts."""
    match node:
        case Letter(name) | Sign(name):
            return _find_width(name.removeprefix("\\"))
        case Number(text) | Text(text) | Unit(text) | Function(text):
            return sum(map(_find_width, text))
        case Scripts(primes=primes):
            return _PRIME * primes
        case Lettering("boldsymbol", _):
            return _BOLDER
        case Quotient() | Root() | Space() | LineBreak():
            return _find_width("")
        case Fenced():
            return 2 * _find_width("")
        case Lettering() | Accent() | Group() | Environment() | Mark():
            return 0.0
        case _:
            assert_never(node)


def _rises_and_falls(node: Letter | Sign) -> bool:
    """Whether a letter or a sign reaches from above the small letters to below the line."""
    match node:
        case Sign():
            return node.latex in "()"
        case Letter():
            return node.name.removeprefix("\\") in _RISING_AND_FALLING
        case _:
            assert_never(node)


def _find_width(name: str) -> float:
    return _WIDE.get(name, _NARROW.get(name, 0.78 if name.isupper() else 0.62))

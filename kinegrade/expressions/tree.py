"""An expression as a tree of frozen values."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Literal, assert_never

from flint import fmpq

Mark = Literal["+", "-", "*", "/"]
Operator = Literal["+", "-", "*", "/", "**"]
SUMS: tuple[Mark, ...] = ("+", "-")
PRODUCTS: tuple[Mark, ...] = ("*", "/")
# The functions that `left of A->B` and `right of A->B` call; no name has a blank
SIDES_OF: Mapping[str, str] = {"left": "left of", "right": "right of"}


@dataclass(frozen=True)
class Number:
    """A rational literal."""

    value: Any


@dataclass(frozen=True)
class Name:
    """A parameter, a point, a body or `pi`."""

    name: str


@dataclass(frozen=True)
class Operation:
    """left sign right; sign is one of + - * / **."""

    sign: Operator
    left: Expression
    right: Expression


@dataclass(frozen=True)
class Call:
    """A function or construction applied to its arguments; the pair (x, y) is the call of ""."""

    function: str
    arguments: tuple[Expression, ...]


Expression = Number | Name | Operation | Call


def list_parts(tree: Expression) -> tuple[Expression, ...]:
    """The direct parts of an expression, in order; none for a number or a name."""
    match tree:
        case Number() | Name():
            return ()
        case Operation(left=left, right=right):
            return (left, right)
        case Call(arguments=arguments):
            return arguments
        case _:
            assert_never(tree)


def walk(tree: Expression) -> Iterator[Expression]:
    """The expression itself and, depth first, all its parts."""
    yield tree
    for part in list_parts(tree):
        yield from walk(part)


def find_names(tree: Expression) -> Iterator[str]:
    """The names (not the functions) that occur, in order."""
    return (part.name for part in walk(tree) if isinstance(part, Name))


def is_literal_zero(tree: Expression) -> bool:
    """Whether the tree is the zero of a sign: 0 - x, which points and vectors may have too."""
    return isinstance(tree, Operation) and tree.left == Number(fmpq(0))

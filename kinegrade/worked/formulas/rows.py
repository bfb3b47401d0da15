"""Pieces of a math tree that printed formulas are put together from: digits, brackets, powers."""

from __future__ import annotations

from msgspec.structs import replace

from kinegrade.language.math.tree import (
    Fenced,
    Letter,
    Lettering,
    Node,
    Number,
    Quotient,
    Row,
    Scripts,
    Sign,
    list_nodes,
)

PLUS, MINUS, DOT = Sign("+"), Sign("-"), Sign(r"\cdot")
OPEN, CLOSE = Sign("("), Sign(")")


def print_decimal(digits: str, mark: str) -> Row:
    """A decimal with the decimal mark of a language, and a power of ten where it has one.

    >>> print_decimal("-0.5", ",")[1:]
    (Number(digits='0'), Sign(latex='{,}'), Number(digits='5'))
    """
    size, _, exponent = digits.removeprefix("-").partition("e")
    sign: Row = (MINUS,) if digits.startswith("-") else ()
    whole, point, decimals = size.partition(".")
    shown: Row = (Number(size),)
    if point and mark != ".":
        shown = (Number(whole), Sign(f"{{{mark}}}"), Number(decimals))
    if not exponent:
        return (*sign, *shown)
    power = Scripts(Number("10"), None, 0, print_decimal(exponent.removeprefix("+"), mark))
    return (*sign, *shown, DOT, power)


def enclose(row: Row) -> Row:
    """A row in brackets, as high as it is where it is higher than a letter."""
    if any(isinstance(node, Quotient) or _is_raised(node) for node in row):
        return (Fenced("(", row, ")"),)
    return (OPEN, *row, CLOSE)


def _is_raised(node: Node) -> bool:
    """Whether a letter carries a letter above, as a normal acceleration does."""
    upper = node.upper if isinstance(node, Scripts) else None
    return upper is not None and any(isinstance(part, Lettering) for part in upper)


def ends_raised(row: Row) -> bool:
    """Whether there is no room for an exponent at the end of a row."""
    last = row[-1]
    return isinstance(last, Scripts) and last.upper is not None


def raise_last(row: Row, exponent: Row) -> Row:
    """A row with an exponent at its end."""
    *before, last = row
    if isinstance(last, Scripts) and last.upper is None:
        return (*before, replace(last, upper=exponent))
    return (*before, Scripts(last, None, 0, exponent))


def is_segment(row: Row) -> bool:
    """Whether letters side by side are the ends of a line, as OA, and no product, as kb."""
    letters = ([one for one in list_nodes((node,)) if isinstance(one, Letter)] for node in row)
    return all(of_one and of_one[0].name.isupper() for of_one in letters)

"""Parts of a formula and how they are joined: signs, brackets, dots."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Literal, assert_never

Kind = Literal["number", "symbol", "function", "closed", "fraction", "product", "sum"]
TRIGONOMETRY = {"sin": r"\sin", "cos": r"\cos", "tan": r"\tan"}
INVERSE = {"asin": r"\arcsin", "acos": r"\arccos", "atan": r"\arctan"}
_OPERATORS = (*TRIGONOMETRY.values(), *INVERSE.values())
_APART = ("(", "|", r"\sqrt", r"\cdot", *_OPERATORS)  # marks of a product that needs brackets


@dataclass(frozen=True)
class Piece:
    """A part of a formula: its text without the sign, and how it behaves next to others."""

    text: str
    kind: Kind
    negative: bool = False

    @property
    def signed(self) -> str:
        """The text as it stands alone or first; a number keeps its minus sign."""
        if self.negative and self.text.startswith("-"):
            return "-" + write_bracketed(self.text)
        return ("-" if self.negative else "") + self.text


def make_numeral(text: str) -> Piece:
    """A number already printed in LaTeX math that replaces a symbol and keeps its minus sign."""
    body = text.removeprefix("-")
    if _is_sum(text):
        return Piece(text, "sum")
    return Piece(
        text,
        "fraction" if body.startswith(r"\frac") else "number" if body[:1].isdigit() else "closed",
    )


def _is_sum(text: str) -> bool:
    """Whether a printed number consists of several terms."""
    depth = 0
    for place, letter in enumerate(text):
        depth += (letter in "{(") - (letter in "})")
        if letter in "+-" and place and not depth:
            return True
    return False


def split_sign(piece: Piece) -> Piece:
    """A factor whose minus sign is moved to the product."""
    if piece.kind == "sum" or not piece.text.startswith("-"):
        return piece
    return replace(piece, text=piece.text[1:], negative=not piece.negative)


def write_following(piece: Piece) -> str:
    """A term with the sign that joins it to those before; a negative number keeps its sign, in
    brackets.
    """
    if piece.text.startswith("-"):
        return (" - " if piece.negative else " + ") + write_bracketed(piece.text)
    return (" - " if piece.negative else " + ") + piece.text


def join_factors(factors: list[Piece]) -> str:
    """A product of magnitudes; the signs are left to the caller."""
    if len(factors) == 1:
        return factors[0].text
    pieces = [hold_together(replace(piece, negative=False)) for piece in factors]
    text = pieces[0].text
    for before, piece in pairwise(pieces):
        text += _choose_product_sign(before, piece) + piece.text
    return text


def _choose_product_sign(before: Piece, piece: Piece) -> str:
    """The separator of two factors: a dot where they would run into one another, else a thin space
    or nothing.
    """
    operator = piece.text.startswith(_OPERATORS)
    if piece.kind == "number" or before.text == "1" or (before.kind == "function" and not operator):
        return r" \cdot "
    if before.kind in ("number", "fraction") and piece.kind == "fraction":
        return r" \cdot "
    if operator or (before.kind == "number" and piece.kind == "symbol"):
        return " "
    return r"\,"


def apply_function(name: str, argument: Piece) -> Piece:
    """A sine, cosine ... of its argument, in brackets unless the argument is simple."""
    signed = argument.signed.startswith("-")
    plain = argument.kind in ("number", "symbol", "fraction") and not signed
    if plain or (
        argument.kind == "product"
        and not signed
        and not any(mark in argument.text for mark in _APART)
    ):
        return Piece(write_operator(name, argument.text), "function")
    return Piece(name + write_bracketed(argument.signed), "closed")


def write_operator(name: str, argument: str) -> str:
    """A sine, cosine ... before an argument that needs no brackets."""
    return name + ("" if argument.startswith("\\") else " ") + argument


def hold_together(piece: Piece) -> Piece:
    """A piece that holds together next to others: a sum in brackets, anything else unchanged."""
    match piece.kind:
        case "sum":
            return _enclose_in_brackets(piece)
        case "number" | "symbol" | "function" | "closed" | "fraction" | "product":
            return piece
        case _:
            assert_never(piece.kind)


def _enclose_in_brackets(piece: Piece) -> Piece:
    """A sum, or a negative number, in brackets."""
    return Piece(write_bracketed(piece.signed), "closed")


def write_bracketed(text: str) -> str:
    """Text in brackets of sufficient height."""
    return rf"\left({text}\right)" if r"\frac" in text else f"({text})"

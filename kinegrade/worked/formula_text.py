"""Expressions of templates as textbook formulas in LaTeX math, with symbols or with an instance's numbers.

    l*sin(theta)*cos(psi)/sin(psi)     \\frac{l \\sin\\theta \\cos\\psi}{\\sin\\psi}
    x(A) + k*r*cos(phi + pi/2)         x_{A} + k\\,r \\cos(\\varphi + 90^\\circ)

A leaf is whatever is printed by a symbol or a number; `Writer` is told what the leaves are and knows all the rest:
precedence, fractions, roots, signs and where a product needs its dot.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any, Literal

from kinegrade.exact.field import Field
from kinegrade.exact.text import decimal_text
from kinegrade.expression import (
    Call,
    Expression,
    Name,
    Number,
    Operation,
    evaluate,
    is_literal_zero,
    names,
    read,
)
from kinegrade.problem.notation import point_symbol, symbol
from kinegrade.problem.quantity import is_short_decimal
from kinegrade.problem.template import Template

Kind = Literal["number", "symbol", "function", "closed", "fraction", "product", "sum"]
TRIGONOMETRY = {"sin": r"\sin", "cos": r"\cos", "tan": r"\tan"}
INVERSE = {"asin": r"\arcsin", "acos": r"\arccos", "atan": r"\arctan"}
ONE = read("1")
OPERATORS = (*TRIGONOMETRY.values(), *INVERSE.values())


@dataclass(frozen=True)
class Piece:
    """A part of a formula: its text without the sign, and what kind of thing it is to its neighbours."""

    text: str
    kind: Kind
    negative: bool = False

    @property
    def signed(self) -> str:
        """The text as it stands alone or first; a number keeps its own minus."""
        if self.negative and self.text.startswith("-"):
            return "-" + bracketed(self.text)
        return ("-" if self.negative else "") + self.text


APART = (
    "(",
    "|",
    r"\sqrt",
    r"\cdot",
    *OPERATORS,
)  # marks of a product that needs brackets behind a sine
Leaf = Callable[[Expression, bool], Piece | None]


def latex_of(
    expression: Expression,
    symbols: Mapping[str, str],
    degrees: bool = False,
    points: Collection[str] = (),
) -> str:
    """LaTeX math (no dollar signs) of an expression; `symbols` gives the LaTeX of its names, see `symbols_of`.

    `pi` prints as such, but in degrees within sines and cosines, and everywhere if the expression is an angle that is
    to be printed with `degrees`. A name without a symbol prints as `problem.notation.symbol` has it. The difference
    of two of the `points` prints as a vector with an arrow.

    >>> from kinegrade.expression import read
    >>> print(latex_of(read("-l_1*sin(psi)/sin(theta + pi/2)"), {}))
    -\\frac{l_{1} \\sin\\psi}{\\sin(\\theta + 90^\\circ)}
    """
    return symbol_writer(symbols, points).write(expression, degrees).signed


def symbol_writer(symbols: Mapping[str, str], points: Collection[str] = ()) -> Writer:
    """The writer of formulas in symbols."""
    return Writer(
        lambda tree, angular: vector_between(tree, points) or symbolic(tree, angular, symbols)
    )


def symbols_of(template: Template) -> dict[str, str]:
    """The LaTeX symbols of everything that a template's expressions may name."""
    return {
        **{name: point_symbol(name) for name in template.points},
        **{name: symbol(name) for name in template.lengths},
        **{name: parameter.symbol for name, parameter in template.parameters.items()},
        "pi": r"\pi",
    }


def symbolic(tree: Expression, angular: bool, symbols: Mapping[str, str]) -> Piece | None:
    """The leaves of a formula in symbols: names, coordinates and distances of points, angles of so many degrees."""
    if angular and (half_turns := constant_half_turns(tree)) is not None:
        return Piece(decimal_text(abs(half_turns * 180), 6) + r"^\circ", "number", half_turns < 0)
    if isinstance(tree, Name):
        return Piece(symbols.get(tree.name, named(tree.name)), "symbol")
    if isinstance(tree, Call) and tree.function in ("x", "y", "distance", "direction"):
        return measured(tree, symbols)
    return None


def named(name: str) -> str:
    """The symbol of a name that was given none."""
    return r"\pi" if name == "pi" else symbol(name)


def measured(tree: Call, symbols: Mapping[str, str]) -> Piece | None:
    """x_A, y_A, the distance AB, the angle from the x axis to AB; None where the points are not named."""
    points = [
        symbols.get(part.name, point_symbol(part.name))
        for part in tree.arguments
        if isinstance(part, Name)
    ]
    if len(points) != len(tree.arguments):
        return None
    if tree.function == "direction":
        return Piece(rf"\angle(x, \overrightarrow{{{''.join(points)}}})", "symbol")
    if tree.function == "distance":
        return Piece("".join(points), "closed" if "_" in points[-1] else "symbol")
    return Piece(f"{tree.function}_{{{points[0]}}}", "symbol")


def vector_between(tree: Expression, points: Collection[str]) -> Piece | None:
    """The difference of two points as the vector from the second to the first; None for anything else."""
    if not isinstance(tree, Operation) or tree.sign != "-":
        return None
    if not (isinstance(tree.left, Name) and isinstance(tree.right, Name)):
        return None
    ends = (tree.right.name, tree.left.name)
    return Piece(arrow(*ends), "symbol") if set(ends) <= set(points) else None


def arrow(start: str, end: str) -> str:
    """The vector from one named point to another, in LaTeX math."""
    return rf"\overrightarrow{{{point_symbol(start)}{point_symbol(end)}}}"


def quarter_turns(tree: Expression) -> int | None:
    """How many right angles an angle made of numbers and `pi` comes to, 0 to 3; None where it is no such angle."""
    half_turns = constant_half_turns(tree)
    quarters = None if half_turns is None else half_turns * 2
    return None if quarters is None or quarters != int(quarters) else int(quarters) % 4


def constant_half_turns(tree: Expression) -> Any:
    """An angle made of numbers and `pi` alone, over pi; None for any other expression."""
    if set(names(tree)) - {"pi"} or has_call(tree):
        return None
    field = Field()
    value = evaluate(tree, {"pi": field.turns(1)}, {}, field)
    return getattr(value, "half_turns", value if value == 0 else None)


def has_call(tree: Expression) -> bool:
    """Whether a function is called anywhere in an expression."""
    return isinstance(tree, Call) or (
        isinstance(tree, Operation) and (has_call(tree.left) or has_call(tree.right))
    )


@dataclass(frozen=True)
class Writer:
    """Writes expressions; `leaf` gives the piece of what is printed whole, or None for what is to be taken apart.

    `angular` says that the expression is an angle, to be printed in degrees.
    """

    leaf: Leaf

    def write(self, tree: Expression, angular: bool = False) -> Piece:
        """The formula of an expression."""
        found = self.leaf(tree, angular)
        if found is not None:
            return found
        match tree:
            case Number():
                return literal(tree)
            case Name():
                return Piece(named(tree.name), "symbol")
            case Call():
                return self.call(tree)
            case Operation(sign="**"):
                return self.power(tree)
            case Operation(sign="*" | "/"):
                return self.product(tree, angular)
        return self.sum(tree, angular)

    def sum(self, tree: Operation, angular: bool) -> Piece:
        """Terms with their signs; a lone minus belongs to what follows it."""
        terms = list(self.terms(tree, angular))
        if len(terms) == 1:
            return closed(terms[0]) if terms[0].kind == "sum" else terms[0]
        return Piece(
            "".join(
                following(piece) if place else piece.signed for place, piece in enumerate(terms)
            ),
            "sum",
        )

    def terms(self, tree: Expression, angular: bool) -> Iterator[Piece]:
        """The terms of a sum; brackets after a plus are dropped."""
        if self.leaf(tree, angular) is None and isinstance(tree, Operation) and tree.sign in "+-":
            if not is_literal_zero(tree):
                yield from self.terms(tree.left, angular)
            if tree.sign == "+":
                yield from self.terms(tree.right, angular)
                return
            piece = self.write(tree.right, angular)
            piece = closed(piece) if piece.kind == "sum" else piece
            yield replace(piece, negative=not piece.negative)
            return
        yield self.write(tree, angular)

    def product(self, tree: Operation, angular: bool) -> Piece:
        """Factors side by side, over the divisors where there are any; all signs before the whole."""
        above, below = ([positive(piece) for piece in part] for part in self.factors(tree, angular))
        negative = sum(piece.negative for piece in above + below) % 2 == 1
        top = joined(above)
        if not below:
            return Piece(top, "product" if len(above) > 1 else above[0].kind, negative)
        return Piece(rf"\frac{{{top}}}{{{joined(below)}}}", "fraction", negative)

    def factors(self, tree: Expression, angular: bool) -> tuple[list[Piece], list[Piece]]:
        """What stands above and below the line."""
        if self.leaf(tree, angular) is not None or not isinstance(tree, Operation):
            return [self.write(tree, angular)], []
        if tree.sign == "-" and is_literal_zero(tree):
            (first, *more), below = self.factors(tree.right, angular)
            return [replace(first, negative=not first.negative), *more], below
        if tree.sign not in ("*", "/"):
            return [self.write(tree, angular)], []
        if tree.sign == "*" and tree.left == ONE:
            return self.factors(tree.right, angular)
        above, below = self.factors(tree.left, angular)
        if tree.sign == "*":
            more, under = self.factors(tree.right, angular)
            return above + more, below + under
        more, under = self.factors(tree.right, angular)
        return (
            (above, below + more)
            if not under
            else (above, [*below, self.write(tree.right, angular)])
        )

    def power(self, tree: Operation) -> Piece:
        """A power; that of a sine stands behind its name."""
        exponent = self.write(tree.right).signed
        if (
            isinstance(tree.left, Call)
            and tree.left.function in TRIGONOMETRY
            and not exponent.startswith("-")
        ):
            base = self.write(tree.left)
            name = TRIGONOMETRY[tree.left.function]
            return replace(base, text=f"{name}^{{{exponent}}}" + base.text.removeprefix(name))
        base = self.write(tree.left)
        simple = (
            base.kind in ("number", "symbol")
            and not base.signed.startswith("-")
            and "^" not in base.text
        )
        if not simple:
            return Piece(f"{bracketed(base.signed)}^{{{exponent}}}", "closed")
        return Piece(f"{base.text}^{{{exponent}}}", base.kind)

    def call(self, tree: Call) -> Piece:
        """A function of its arguments."""
        if tree.function == "sqrt" and len(tree.arguments) == 1:
            return Piece(rf"\sqrt{{{self.write(tree.arguments[0]).signed}}}", "closed")
        if tree.function == "abs" and len(tree.arguments) == 1:
            return Piece(rf"\left|{self.write(tree.arguments[0]).signed}\right|", "closed")
        if tree.function in TRIGONOMETRY or tree.function in INVERSE:
            return applied(
                {**TRIGONOMETRY, **INVERSE}[tree.function],
                self.write(tree.arguments[0], tree.function in TRIGONOMETRY),
            )
        inner = r",\ ".join(self.write(part).signed for part in tree.arguments)
        name = tree.function.replace("_", r"}\ \mathrm{")
        return Piece((rf"\mathrm{{{name}}}" if name else "") + bracketed(inner), "closed")


def literal(tree: Number) -> Piece:
    """A number as it stands in a template: a short decimal, or a fraction."""
    size, negative = abs(tree.value), bool(tree.value < 0)
    if is_short_decimal(size):
        return Piece(decimal_text(size, 12), "number", negative)
    return Piece(rf"\frac{{{size.p}}}{{{size.q}}}", "fraction", negative)


def numeral(text: str) -> Piece:
    """A number already printed, in LaTeX math, that takes the place of a symbol and keeps its minus to itself."""
    body = text.removeprefix("-")
    if is_sum(text):
        return Piece(text, "sum")
    return Piece(
        text,
        "fraction" if body.startswith(r"\frac") else "number" if body[:1].isdigit() else "closed",
    )


def is_sum(text: str) -> bool:
    """Whether a printed number consists of several terms."""
    depth = 0
    for place, letter in enumerate(text):
        depth += (letter in "{(") - (letter in "})")
        if letter in "+-" and place and not depth:
            return True
    return False


def positive(piece: Piece) -> Piece:
    """A factor whose own minus is handed to the product."""
    if piece.kind == "sum" or not piece.text.startswith("-"):
        return piece
    return replace(piece, text=piece.text[1:], negative=not piece.negative)


def following(piece: Piece) -> str:
    """A term with the sign that joins it to those before; a negative number keeps its own, in brackets."""
    if piece.text.startswith("-"):
        return (" - " if piece.negative else " + ") + bracketed(piece.text)
    return (" - " if piece.negative else " + ") + piece.text


def joined(factors: list[Piece]) -> str:
    """A product of sizes; the signs are left to the caller."""
    if len(factors) == 1:
        return factors[0].text
    pieces = [
        closed(replace(piece, negative=False)) if piece.kind == "sum" else piece
        for piece in factors
    ]
    text = pieces[0].text
    for before, piece in pairwise(pieces):
        text += between(before, piece) + piece.text
    return text


def between(before: Piece, piece: Piece) -> str:
    """The mark between two factors: a dot where they would run into one another, else a little room or none."""
    operator = piece.text.startswith(OPERATORS)
    if piece.kind == "number" or before.text == "1" or (before.kind == "function" and not operator):
        return r" \cdot "
    if before.kind in ("number", "fraction") and piece.kind == "fraction":
        return r" \cdot "
    if operator or (before.kind == "number" and piece.kind == "symbol"):
        return " "
    return r"\,"


def applied(name: str, argument: Piece) -> Piece:
    """A sine, cosine ... of its argument, in brackets unless that is simple."""
    signed = argument.signed.startswith("-")
    plain = argument.kind in ("number", "symbol", "fraction") and not signed
    if plain or (
        argument.kind == "product"
        and not signed
        and not any(mark in argument.text for mark in APART)
    ):
        return Piece(operated(name, argument.text), "function")
    return Piece(name + bracketed(argument.signed), "closed")


def operated(name: str, argument: str) -> str:
    """A sine, cosine ... before an argument that needs no brackets."""
    return name + ("" if argument.startswith("\\") else " ") + argument


def closed(piece: Piece) -> Piece:
    """A sum, or a negative number, in brackets."""
    return Piece(bracketed(piece.signed), "closed")


def bracketed(text: str) -> str:
    """Text in brackets as high as it needs."""
    return rf"\left({text}\right)" if r"\frac" in text else f"({text})"

"""Expressions of templates as textbook formulas in LaTeX math, with symbols or with an instance's
numbers.

    l*sin(theta)*cos(psi)/sin(psi)     \\frac{l \\sin\\theta \\cos\\psi}{\\sin\\psi}
    x(A) + k*r*cos(phi + pi/2)         x_{A} + k\\,r \\cos(\\varphi + 90^\\circ)

A leaf is whatever is printed by a symbol or a number; `Writer` is given the leaves and does
everything else: precedence, fractions, roots, signs and the dots of products.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any, assert_never

from kinegrade.expressions.expression import (
    Call,
    Expression,
    Name,
    Number,
    Operation,
    evaluate,
    find_names,
    is_literal_zero,
    read_expression,
    walk,
)
from kinegrade.numbers.field import Field
from kinegrade.numbers.text import write_decimal
from kinegrade.problem.quantity import is_short_decimal
from kinegrade.problem.template.notation import write_point_symbol, write_symbol
from kinegrade.problem.template.template import Template
from kinegrade.worked.formulas.pieces import (
    INVERSE,
    TRIGONOMETRY,
    Piece,
    apply_function,
    hold_together,
    join_factors,
    split_sign,
    write_bracketed,
    write_following,
)

_ONE = read_expression("1")


Leaf = Callable[[Expression, bool], Piece | None]


def write_latex(
    expression: Expression,
    symbols: Mapping[str, str],
    degrees: bool = False,
    points: Collection[str] = (),
) -> str:
    """LaTeX math (no dollar signs) of an expression; `symbols` gives the LaTeX of its names, see
    `collect_symbols`.

    `pi` prints as such, but in degrees within sines and cosines, and everywhere if the expression
    is an angle to be printed in `degrees`. A name without a symbol prints as
    `problem.notation.write_symbol` gives it. The difference of two of the `points` prints as a
    vector with an arrow.

    >>> from kinegrade.expressions.expression import read_expression
    >>> print(write_latex(read_expression("-l_1*sin(psi)/sin(theta + pi/2)"), {}))
    -\\frac{l_{1} \\sin\\psi}{\\sin(\\theta + 90^\\circ)}
    """
    return make_symbol_writer(symbols, points).write(expression, degrees).signed


def make_symbol_writer(symbols: Mapping[str, str], points: Collection[str] = ()) -> Writer:
    """The writer of formulas in symbols."""
    return Writer(
        lambda tree, angular: (
            _find_vector_between(tree, points) or _write_leaf(tree, angular, symbols)
        )
    )


def collect_symbols(template: Template) -> dict[str, str]:
    """The LaTeX symbols of everything that a template's expressions may name."""
    return {
        **{name: write_point_symbol(name) for name in template.scheme.points},
        **{name: write_symbol(name) for name in template.scheme.lengths},
        **{name: parameter.symbol for name, parameter in template.parameters.items()},
        "pi": r"\pi",
    }


def _write_leaf(tree: Expression, angular: bool, symbols: Mapping[str, str]) -> Piece | None:
    """The leaves of a formula in symbols: names, coordinates and distances of points, angles in
    whole degrees.
    """
    if angular and (half_turns := _count_half_turns(tree)) is not None:
        return Piece(write_decimal(abs(half_turns * 180), 6) + r"^\circ", "number", half_turns < 0)
    match tree:
        case Name(name=name):
            return Piece(symbols.get(name, _write_name(name)), "symbol")
        case Call(function="x" | "y" | "distance" | "direction"):
            return _write_measure(tree, symbols)
        case Number() | Operation() | Call():
            return None
        case _:
            assert_never(tree)


def _write_name(name: str) -> str:
    """The symbol of a name that has been given none."""
    return r"\pi" if name == "pi" else write_symbol(name)


def _write_measure(tree: Call, symbols: Mapping[str, str]) -> Piece | None:
    """x_A, y_A, the distance AB, the angle from the x axis to AB; None where the points are not
    named.
    """
    points = [
        symbols.get(part.name, write_point_symbol(part.name))
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


def _find_vector_between(tree: Expression, points: Collection[str]) -> Piece | None:
    """The difference of two points as the vector from the second to the first; None for any other
    expression.
    """
    if not isinstance(tree, Operation) or tree.sign != "-":
        return None
    if not (isinstance(tree.left, Name) and isinstance(tree.right, Name)):
        return None
    ends = (tree.right.name, tree.left.name)
    return Piece(_write_arrow(*ends), "symbol") if set(ends) <= set(points) else None


def _write_arrow(start: str, end: str) -> str:
    """The vector from one named point to another, in LaTeX math."""
    return rf"\overrightarrow{{{write_point_symbol(start)}{write_point_symbol(end)}}}"


def count_quarter_turns(tree: Expression) -> int | None:
    """The number of right angles, 0 to 3, in an angle made of numbers and `pi`; None for any other
    angle.
    """
    half_turns = _count_half_turns(tree)
    quarters = None if half_turns is None else half_turns * 2
    return None if quarters is None or quarters != int(quarters) else int(quarters) % 4


def _count_half_turns(tree: Expression) -> Any:
    """An angle made of numbers and `pi` alone, divided by pi; None for any other expression."""
    if set(find_names(tree)) - {"pi"} or _has_call(tree):
        return None
    field = Field()
    value = evaluate(tree, {"pi": field.turns(1)}, {}, field)
    return getattr(value, "half_turns", value if value == 0 else None)


def _has_call(tree: Expression) -> bool:
    """Whether a function is called anywhere in an expression."""
    return any(isinstance(part, Call) for part in walk(tree))


@dataclass(frozen=True)
class Writer:
    """Writes expressions; `leaf` gives the piece for whatever is printed whole, or None for an
    expression to be taken apart.

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
                return _write_literal(tree)
            case Name():
                return Piece(_write_name(tree.name), "symbol")
            case Call():
                return self.call(tree)
            case Operation():
                return self.operation(tree, angular)
            case _:
                assert_never(tree)

    def operation(self, tree: Operation, angular: bool) -> Piece:
        """A power, a product or a quotient, a sum or a difference."""
        match tree.sign:
            case "**":
                return self.power(tree)
            case "*" | "/":
                return self.product(tree, angular)
            case "+" | "-":
                return self.sum(tree, angular)
            case _:
                assert_never(tree.sign)

    def sum(self, tree: Operation, angular: bool) -> Piece:
        """Terms with their signs; a unary minus belongs to the term after it."""
        terms = list(self.terms(tree, angular))
        if len(terms) == 1:
            return hold_together(terms[0])
        return Piece(
            "".join(
                write_following(piece) if place else piece.signed
                for place, piece in enumerate(terms)
            ),
            "sum",
        )

    def terms(self, tree: Expression, angular: bool) -> Iterator[Piece]:
        """The terms of a sum; brackets after a plus are dropped."""
        if self.leaf(tree, angular) is not None or not isinstance(tree, Operation):
            yield self.write(tree, angular)
            return
        match tree.sign:
            case "+":
                yield from () if is_literal_zero(tree) else self.terms(tree.left, angular)
                yield from self.terms(tree.right, angular)
            case "-":
                yield from () if is_literal_zero(tree) else self.terms(tree.left, angular)
                piece = hold_together(self.write(tree.right, angular))
                yield replace(piece, negative=not piece.negative)
            case "*" | "/" | "**":
                yield self.write(tree, angular)
            case _:
                assert_never(tree.sign)

    def product(self, tree: Operation, angular: bool) -> Piece:
        """Factors side by side, over the divisors if there are any, with all signs in front."""
        above, below = (
            [split_sign(piece) for piece in part] for part in self.factors(tree, angular)
        )
        negative = sum(piece.negative for piece in above + below) % 2 == 1
        top = join_factors(above)
        if not below:
            return Piece(top, "product" if len(above) > 1 else above[0].kind, negative)
        return Piece(rf"\frac{{{top}}}{{{join_factors(below)}}}", "fraction", negative)

    def factors(self, tree: Expression, angular: bool) -> tuple[list[Piece], list[Piece]]:
        """The factors of the numerator and of the denominator."""
        if self.leaf(tree, angular) is not None or not isinstance(tree, Operation):
            return [self.write(tree, angular)], []
        match tree.sign:
            case "-" if is_literal_zero(tree):
                (first, *more), below = self.factors(tree.right, angular)
                return [replace(first, negative=not first.negative), *more], below
            case "+" | "-" | "**":
                return [self.write(tree, angular)], []
            case "*":
                if tree.left == _ONE:
                    return self.factors(tree.right, angular)
                above, below = self.factors(tree.left, angular)
                more, under = self.factors(tree.right, angular)
                return above + more, below + under
            case "/":
                above, below = self.factors(tree.left, angular)
                more, under = self.factors(tree.right, angular)
                divisor = [self.write(tree.right, angular)] if under else more
                return above, below + divisor
            case _:
                assert_never(tree.sign)

    def power(self, tree: Operation) -> Piece:
        """A power; the exponent of a sine stands directly after its name."""
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
            return Piece(f"{write_bracketed(base.signed)}^{{{exponent}}}", "closed")
        return Piece(f"{base.text}^{{{exponent}}}", base.kind)

    def call(self, tree: Call) -> Piece:
        """A function call with its arguments."""
        if tree.function == "sqrt" and len(tree.arguments) == 1:
            return Piece(rf"\sqrt{{{self.write(tree.arguments[0]).signed}}}", "closed")
        if tree.function == "abs" and len(tree.arguments) == 1:
            return Piece(rf"\left|{self.write(tree.arguments[0]).signed}\right|", "closed")
        if tree.function in TRIGONOMETRY or tree.function in INVERSE:
            return apply_function(
                {**TRIGONOMETRY, **INVERSE}[tree.function],
                self.write(tree.arguments[0], tree.function in TRIGONOMETRY),
            )
        inner = r",\ ".join(self.write(part).signed for part in tree.arguments)
        name = tree.function.replace("_", r"}\ \mathrm{")
        return Piece((rf"\mathrm{{{name}}}" if name else "") + write_bracketed(inner), "closed")


def _write_literal(tree: Number) -> Piece:
    """A number as it stands in a template: a short decimal, or a fraction."""
    size, negative = abs(tree.value), bool(tree.value < 0)
    if is_short_decimal(size):
        return Piece(write_decimal(size, 12), "number", negative)
    return Piece(rf"\frac{{{size.p}}}{{{size.q}}}", "fraction", negative)

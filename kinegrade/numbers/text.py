"""How numbers print: exact text that the expression grammar reads back, LaTeX, and decimals to any
number of digits.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from flint import fmpq
from msgspec import Struct

from kinegrade.numbers.angle import Angle
from kinegrade.numbers.pi_multiple import split_pi
from kinegrade.numbers.square_roots import split_square
from kinegrade.numbers.surd import Real, Root, Surd, sign


class Form(Struct, frozen=True):
    """The marks of one notation."""

    root: str
    product: str
    fraction: str
    pi: str
    power: str
    arctangent: str
    bracket: str

    def write_pi(self, power: int) -> str:
        """A positive power of pi."""
        return self.pi if power == 1 else self.power.format(self.pi, power)

    def divide(self, above: str, below: list[str]) -> str:
        """A product over the product of `below`."""
        product = self.product.join(below)
        single = len(below) == 1
        return self.fraction.format(above, product if single else self.bracket.format(product))


_PLAIN = Form("sqrt({})", "*", "{}/{}", "pi", "{}**{}", "atan({})", "({})")
LATEX = Form(
    r"\sqrt{{{}}}",
    " ",
    r"\frac{{{}}}{{{}}}",
    r"\pi",
    "{}^{{{}}}",
    r"\arctan\left({}\right)",
    "{}",
)


def write_exact(number: Real, form: Form = _PLAIN) -> str:
    """An exact number as text, e.g. `2*sqrt(3)/3`; `form=LATEX` gives LaTeX math.

    >>> from kinegrade.numbers.field import Field
    >>> write_exact(2 / Field().sqrt(fmpq(3)))
    '2*sqrt(3)/3'
    """
    parts = [_write_signed_term(term, form) for term in expand_radicals(number)]
    return _join_terms(parts) if parts else "0"


def _join_terms(parts: list[tuple[bool, str]]) -> str:
    """Signed terms written one after the other."""
    first_negative, first = parts[0]
    text = ("-" if first_negative else "") + first
    for negative, body in parts[1:]:
        text += (" - " if negative else " + ") + body
    return text


class Term(Struct, frozen=True):
    """factor * sqrt(free) * the nested roots * pi**power: a rational factor and an integer `free`,
    1 where there is no plain root.
    """

    factor: Any
    free: int
    nested: tuple[Root, ...]
    power: int


def expand_radicals(number: Real) -> list[Term]:
    """The number as a sum, in the order in which it is written."""
    number, power = split_pi(number)
    collected: dict[tuple[int, tuple[Root, ...]], Any] = {}
    for factor, roots in _expand_products(number):
        plain = 1
        for root in roots:
            plain *= int(root.radicand.p) if not isinstance(root.radicand, Surd) else 1
        nested = tuple(root for root in roots if isinstance(root.radicand, Surd))
        square, free = split_square(plain)
        key = (free, nested)
        collected[key] = collected.get(key, fmpq(0)) + factor * square
    terms = (
        Term(factor, free, nested, power)
        for (free, nested), factor in collected.items()
        if factor != 0
    )
    return sorted(terms, key=_order_term)


def _order_term(term: Term) -> tuple[bool, tuple[str, ...], int]:
    """Positive terms first, then by their roots."""
    return term.factor < 0, tuple(write_exact(root.radicand) for root in term.nested), term.free


def _expand_products(
    number: Real, roots: tuple[Root, ...] = ()
) -> Iterator[tuple[Any, tuple[Root, ...]]]:
    """The number multiplied out: rational factors of products of roots of its tower."""
    if isinstance(number, Surd):
        yield from _expand_products(number.a, roots)
        yield from _expand_products(number.b, (*roots, number.root))
    elif number != 0:
        yield number, roots


def _write_signed_term(term: Term, form: Form) -> tuple[bool, str]:
    """(negative, text of the absolute value) of one term."""
    factors = [form.root.format(term.free)] if term.free != 1 else []
    factors += [form.root.format(write_exact(root.radicand, form)) for root in term.nested]
    factors += [form.write_pi(term.power)] if term.power > 0 else []
    size = abs(term.factor)
    above = form.product.join(([str(size.p)] if size.p != 1 or not factors else []) + factors)
    below = [str(size.q)] if size.q != 1 else []
    below += [form.write_pi(-term.power)] if term.power < 0 else []
    return term.factor < 0, form.divide(above, below) if below else above


def write_angle(angle: Angle, degrees: bool, form: Form = _PLAIN) -> str:
    """An exact angle in radians or degrees, e.g. `pi/3`, `60`, `atan(1/3)`, `180*atan(1/3)/pi`."""
    if not angle.parts:
        return (
            write_exact(angle.half_turns * 180, form)
            if degrees
            else write_multiple_of_pi(angle.half_turns, form)
        )
    terms = [(factor, _write_arctangent(y, x, form)) for factor, (x, y) in angle.parts]
    turns = count_turns_beside(angle)
    parts = [(factor < 0, _write_multiple(abs(factor), text, form)) for factor, text in terms]
    if turns != 0:
        parts.append((turns < 0, write_multiple_of_pi(abs(turns), form)))
    text = _join_terms(parts)
    if not degrees:
        return text
    body = f"({text})" if len(parts) > 1 else text
    return f"180*{body}/pi" if form is _PLAIN else rf"\frac{{180}}{{\pi}}\,{body}"


def count_turns_beside(angle: Angle) -> Any:
    """The half turns that are added to the arctangents y/x of an angle's parts."""
    return angle.half_turns + sum(
        (factor * _offset(y, x) for factor, (x, y) in angle.parts), fmpq(0)
    )


def _offset(y: Real, x: Real) -> Any:
    """Half turns by which the direction of (x, y) differs from atan(y/x)."""
    if sign(x) > 0:
        return fmpq(0)
    if x == 0:
        return fmpq(sign(y), 2)
    return fmpq(1) if sign(y) >= 0 else fmpq(-1)


def _write_arctangent(y: Real, x: Real, form: Form) -> str:
    """atan(y/x), or zero for the vertical direction, whose quarter turn `_offset` gives."""
    return "0" if x == 0 else form.arctangent.format(write_exact(y / x, form))


def _write_multiple(factor: Any, text: str, form: Form) -> str:
    """A positive rational multiple of a text."""
    if factor == 1:
        return text
    return form.product.join([write_exact(factor, form), text])


def write_multiple_of_pi(half_turns: Any, form: Form = _PLAIN) -> str:
    """A rational multiple of pi.

    >>> write_multiple_of_pi(fmpq(5, 6))
    '5*pi/6'
    """
    if half_turns == 0:
        return "0"
    size = abs(half_turns)
    above = form.pi if size.p == 1 else form.product.join([str(size.p), form.pi])
    return ("-" if half_turns < 0 else "") + (
        above if size.q == 1 else form.fraction.format(above, size.q)
    )

"""Exact numbers as formulas: sums of roots with their fractions, and angles."""

from __future__ import annotations

from typing import Any

from kinegrade.numbers.angle import Angle
from kinegrade.numbers.surd import Real
from kinegrade.numbers.text import Term, count_turns_beside, expand_radicals
from kinegrade.worked.formulas.atoms import Number, add_terms, multiply_factors
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.functions import Function, Root
from kinegrade.worked.formulas.symbols import PI


def make_exact(number: Real) -> Formula:
    """An exact number of the field as a formula.

    >>> from kinegrade.numbers.field import Field
    >>> make_exact(-Field().sqrt(Field().number(3)))
    Negative(inner=Root(radicand=Number(digits='3')))
    """
    return add_terms(
        _make_multiple(term.factor, _list_roots(term), term.power)
        for term in expand_radicals(number)
    )


def _list_roots(term: Term) -> tuple[Formula, ...]:
    plain = (Root(Number(str(term.free))),) if term.free != 1 else ()
    return (*plain, *(Root(make_exact(root.radicand)) for root in term.nested))


def _raise_pi(power: int) -> Formula:
    """A positive power of pi."""
    return PI if power == 1 else PI ** Number(str(power))


def _make_multiple(factor: Any, roots: tuple[Formula, ...], power: int = 0) -> Formula:
    """A rational multiple of a product, which may be empty, and of a power of pi."""
    size = abs(factor)
    parts = (*roots, _raise_pi(power)) if power > 0 else roots
    count = (Number(str(size.p)),) if size.p != 1 or not parts else ()
    above = multiply_factors((*count, *parts))
    under = (Number(str(size.q)),) if size.q != 1 else ()
    below = (*under, _raise_pi(-power)) if power < 0 else under
    formula = above / multiply_factors(below) if below else above
    return -formula if factor < 0 else formula


def make_exact_angle(angle: Angle) -> Formula:
    """An exact angle in radians as a formula: arctangents and a multiple of pi."""
    terms = [
        _make_multiple(factor, (Function("arctan", make_exact(y / x)),))
        for factor, (x, y) in angle.parts
        if x != 0
    ]
    turns = count_turns_beside(angle)
    return add_terms((*terms, *([_make_multiple(turns, (PI,))] if turns != 0 else [])))

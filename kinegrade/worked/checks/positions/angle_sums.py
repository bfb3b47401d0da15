"""Checks of three angles that have been found apart: two of them, one after the other, make the
third one, but for full turns.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import permutations
from math import pi

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation, walk
from kinegrade.language.message import Message
from kinegrade.problem.template.template import Ask
from kinegrade.worked.case import Case
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.formulas.atoms import TWO
from kinegrade.worked.formulas.formula import Formula, Product
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.formulas.symbols import PI, read_symbol


@dataclass(frozen=True)
class _Angle:
    """An angle that is asked for: its letter, from which line to which one, and its value."""

    letter: Formula
    start: Expression
    end: Expression
    value: float


def list_angle_sums(asked: Sequence[Ask], case: Case) -> Iterator[Check]:
    """The checks of all angles in radians that lead from one line over another one to a third."""
    angles = tuple(_list_angles(asked, case))
    for first, second, whole in permutations(angles, 3):
        ends = first.end == second.start, first.start == whole.start, second.end == whole.end
        if all(ends):
            yield _check(first, second, whole, case)


def _list_angles(asked: Sequence[Ask], case: Case) -> Iterator[_Angle]:
    for ask in asked:
        for call in walk(ask.quantity):
            match call:
                case Call(function="angle", arguments=(start, end)):
                    answer = case.solution.answers[ask.name]
                    if not answer.measure.degrees:
                        letter = read_symbol(ask.symbol)
                        yield _Angle(letter, start, end, float(answer.value))
                case Name() | Number() | Operation() | Call():
                    continue


def _check(first: _Angle, second: _Angle, whole: _Angle, case: Case) -> Check:
    """phi_1 + theta_2 = phi_2, with full turns where these are left out."""
    total = first.value + second.value
    turns = round((whole.value - total) / (2 * pi))
    letters, numbers = first.letter + second.letter, _measure(first) + _measure(second)
    if turns:
        full = Product((TWO, PI)).signed(turns)
        letters, numbers = letters + full, numbers + full
    way = Message(
        "solution.sum-of-angles",
        **{
            name: case.text(one.letter)
            for name, one in (("first", first), ("second", second), ("whole", whole))
        },
    )
    left = Side(numbers, total + 2 * pi * turns, letters)
    return compare(way, left, Side(_measure(whole), whole.value, whole.letter), "rad")


def _measure(angle: _Angle) -> Formula:
    return measure(angle.value, "rad")

"""A deduction as equations: in symbols, with this paper's numbers, and with its results, exact and
as decimals.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from kinegrade.language.message import Message
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.relations import Term
from kinegrade.mechanics.vector_equation import Level, Part, VectorEquation
from kinegrade.worked.document import Block, Display
from kinegrade.worked.formulas.numbers import double, length, write_angle, write_number, write_short
from kinegrade.worked.formulas.width import chain_lines
from kinegrade.worked.steps.projection import Deduction, Projection, Share
from kinegrade.worked.steps.vectors import (
    find_arm,
    find_track_ends,
    write_letters,
    write_magnitude_formula,
    write_symbol,
)
from kinegrade.worked.words.senses import write_rotation_sense, write_sense_along
from kinegrade.worked.words.solution_case import Case

_NUMBER = re.compile(r"-?[0-9.]+")
_AXES = {0.0: Message("solution.projection-x"), 90.0: Message("solution.projection-y")}
UNITS: dict[tuple[Level, bool], str] = {
    ("velocity", False): "m/s",
    ("acceleration", False): "m/s^2",
    ("velocity", True): "rad/s",
    ("acceleration", True): "rad/s^2",
}


@dataclass(frozen=True)
class Stage:
    """The vector equations of one step, which share their unknowns."""

    equations: tuple[VectorEquation, ...]
    level: Level
    case: Case

    def occurrences(self, rate: Rate) -> list[tuple[VectorEquation, Part]]:
        """The places where an unknown stands."""
        return [
            (equation, part)
            for equation in self.equations
            for part in equation.parts
            if part.unknown == rate
        ]

    def _unknown_text(self, equation: VectorEquation, part: Part) -> str:
        """An unknown as equations write it: the vector's symbol, or arm times rate where several
        vectors share it.
        """
        formula = write_magnitude_formula(equation, part, self.case)
        alone = part.unknown is not None and len(self.occurrences(part.unknown)) == 1
        return write_symbol(equation, part, self.case) if alone or not formula else formula

    def _share_size(
        self, equation: VectorEquation, part: Part, solved: Collection[Rate] | None
    ) -> str:
        """The magnitude of a share of a projection, without its cosine: in symbols, or in numbers
        where the rates `solved` are known.

        An unknown one stays a symbol in numbers too, with its numeric factor.
        """
        if solved is None:
            return (
                self._unknown_text(equation, part)
                if part.unknown
                else write_symbol(equation, part, self.case)
            )
        if part.unknown is None or part.term is None:
            return write_short(length(part.value, self.case.arithmetic))
        if part.unknown in solved:
            return write_short(measure_along_direction(part.term, self.case, self.level))
        if len(self.occurrences(part.unknown)) == 1 or part.term.kind == "sliding":
            return write_symbol(equation, part, self.case)
        arm = write_short(length(part.term.vector, self.case.arithmetic))
        return rf"{arm}\,{_write_rate_symbol(part.term, self)}"

    def sides(self, projection: Projection, solved: Collection[Rate] | None) -> tuple[str, str]:
        """The two sides of a projection, in symbols or in numbers."""
        return (
            self._side(projection, projection.left, solved),
            self._side(projection, projection.right, solved),
        )

    def _side(
        self, projection: Projection, shares: Sequence[Share], solved: Collection[Rate] | None
    ) -> str:
        text = ""
        for share in shares:
            size = self._share_size(projection.equation, share.part, solved)
            if size in ("0", "-0"):
                continue
            sign = "-" if (share.sign < 0) != size.startswith("-") else "+" if text else ""
            text += sign + write_with_cosine(size.removeprefix("-"), share.angle)
        return text or "0"


def write_with_cosine(size: str, angle: float) -> str:
    """A size times the cosine of an angle in degrees, without a factor of one.

    >>> write_with_cosine("1", 30.0), write_with_cosine("0.5", 0.0)
    ('\\\\cos 30^\\\\circ', '0.5')
    """
    if angle == 0:
        return size
    return rf"{'' if size == '1' else size}\cos {write_angle(angle)}"


def _write_rate_symbol(term: Term, stage: Stage) -> str:
    """The symbol of the rotation in a term; of a circling point, whose rate has none, the vector's
    length.
    """
    if term.kind != "rotation":
        return ""
    body = term.rate.body
    return stage.case.naming.turning(body, stage.level)


def explain_deduction(
    stage: Stage, deduction: Deduction, solved: Collection[Rate]
) -> Iterator[Block]:
    """A deduction in words and equations; relations between rates have been written before."""
    case, single = stage.case, len(deduction.unknowns) == 1 and not deduction.scalars
    for projection in deduction.projections:
        yield case.say(_announce_axis(stage, projection))
        yield Display(
            tuple(
                write_solution(stage, projection, solved, deduction.unknowns[0])
                if single
                else _write_projection(stage, projection, solved)
            )
        )
    if not single:
        yield case.say(Message("solution.together"))
        yield Display(
            tuple(line for rate in deduction.unknowns for line in _write_results(stage, rate))
        )


def _write_projection(
    stage: Stage, projection: Projection, solved: Collection[Rate]
) -> Iterator[str]:
    """A projection in symbols, and in numbers where that adds something."""
    symbols, numbers = stage.sides(projection, None), stage.sides(projection, solved)
    yield " &= ".join(symbols)
    if numbers != symbols:
        yield " &= ".join(numbers)


def write_solution(
    stage: Stage, projection: Projection, solved: Collection[Rate], rate: Rate
) -> Iterator[str]:
    """A projection with one unknown and its result; as one chain where the unknown stands alone on
    a side.
    """
    left, value = next(_write_results(stage, rate)).split(" &= ", 1)
    sides, numbers = stage.sides(projection, None), stage.sides(projection, solved)
    if left not in sides:
        yield from _write_projection(stage, projection, solved)
        yield from _write_results(stage, rate)
        return
    place = 1 - sides.index(left)
    steps = [
        text
        for text in dict.fromkeys((sides[place], numbers[place]))
        if not _NUMBER.fullmatch(text)
    ]
    yield from chain_lines(left, tuple(("=", text) for text in (*steps, value)))
    yield from list(_write_results(stage, rate))[1:]


def _announce_axis(stage: Stage, projection: Projection) -> Message:
    """On which axis the equation is projected, and why."""
    axis = _name_axis(projection.axis)
    if projection.dropped is None:
        return Message("solution.project-along", axis=axis)
    dropped = write_letters(projection.equation, projection.dropped, stage.case, bold=True)
    return Message("solution.project-drop", axis=axis, dropped=dropped)


def _name_axis(angle: float) -> Message:
    """The axis at an angle in degrees."""
    return _AXES.get(angle) or Message("solution.projection-at", angle=write_angle(angle))


def _write_results(stage: Stage, rate: Rate) -> Iterator[str]:
    """The value of a vector along its direction, and of the rotation it belongs to."""
    case, level = stage.case, stage.level
    found = stage.occurrences(rate)
    turning = rate.kind == "turning"
    if found and (len(found) == 1 or not turning):
        equation, part = found[0]
        yield f"{write_symbol(equation, part, case)} &= {_write_vector_value(part, case, level)}"
        if not turning:
            return
        yield write_rotation_result(
            rate,
            case,
            level,
            f"\\frac{{{write_symbol(equation, part, case)}}}{{{find_arm(part, case)}}} = ",
        )
    elif turning:
        yield write_rotation_result(rate, case, level, "")


def write_rotation_result(rate: Rate, case: Case, level: Level, how: str) -> str:
    """The value of an angular velocity or acceleration with its sense."""
    letters = case.naming.turning(rate.body, level)
    value = case.rates(level)[rate]
    return (
        f"{letters} &= {how}{write_number(value, UNITS[level, True])}"
        f"{write_rotation_sense(value, case)}"
    )


def _write_vector_value(part: Part, case: Case, level: Level) -> str:
    """The algebraic value of an unknown vector along its positive direction, with its sense in
    words.
    """
    if part.term is None or part.coefficient is None:
        return write_number(length(part.value, case.arithmetic), UNITS[level, False])
    value = measure_along_direction(part.term, case, level)
    return write_number(value, UNITS[level, False]) + write_sense_along(
        double(value), part.coefficient, _find_path_ends(part, case), case
    )


def _find_path_ends(part: Part, case: Case) -> tuple[str, str] | None:
    """The points that give the line along which a part lies, in its positive sense; None where no
    two points do.
    """
    ends = find_track_ends(part.term, case) if part.term and part.term.kind == "sliding" else None
    if ends is None or part.coefficient is None:
        return None
    start, end = (case.motion.points[point] for point in ends)
    return ends if float((end - start).dot(part.coefficient)) > 0 else (ends[1], ends[0])


def measure_along_direction(term: Term, case: Case, level: Level) -> Any:
    """A term's signed value along its positive direction: exact where the field holds it."""
    rate = case.rates(level)[term.rate]
    size = length(term.vector, case.arithmetic)
    return float(rate) * size if isinstance(size, float) else rate * size

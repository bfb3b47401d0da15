"""A deduction as equations: in symbols, with this paper's numbers, and with its results, exact and
as decimals.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from kinegrade.mechanics.relations import Term
from kinegrade.mechanics.vector_equation import Level, Part, VectorEquation
from kinegrade.worked.document import Block, Display, Prose
from kinegrade.worked.formula_width import chained
from kinegrade.worked.numbers import angle_text, double, length, short, stated
from kinegrade.worked.phrases import phrase
from kinegrade.worked.projection import Deduction, Projection, Share
from kinegrade.worked.senses import sense_along, sense_of_rotation
from kinegrade.worked.solution_case import Case
from kinegrade.worked.vectors import arm, ends_of_track, letters_of, magnitude_formula, symbol

NUMBER = re.compile(r"-?[0-9.]+")
AXES = {0.0: "axis_x", 90.0: "axis_y"}
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

    def occurrences(self, rate: str) -> list[tuple[VectorEquation, Part]]:
        """The places where an unknown stands."""
        return [
            (equation, part)
            for equation in self.equations
            for part in equation.parts
            if part.unknown == rate
        ]

    def unknown_text(self, equation: VectorEquation, part: Part) -> str:
        """An unknown as equations write it: the vector's symbol, or arm times rate where several
        vectors share it.
        """
        formula = magnitude_formula(equation, part, self.case)
        alone = len(self.occurrences(part.unknown or "")) == 1
        return symbol(equation, part, self.case) if alone or not formula else formula

    def share_size(
        self, equation: VectorEquation, part: Part, solved: Collection[str] | None
    ) -> str:
        """The magnitude of a share of a projection, without its cosine: in symbols, or in numbers
        where the rates `solved` are known.

        An unknown one stays a symbol in numbers too, with its numeric factor.
        """
        if solved is None:
            return (
                self.unknown_text(equation, part)
                if part.unknown
                else symbol(equation, part, self.case)
            )
        if part.unknown is None or part.term is None:
            return short(length(part.value, self.case.arithmetic))
        if part.unknown in solved:
            return short(along_direction(part.term, self.case, self.level))
        if len(self.occurrences(part.unknown)) == 1 or part.term.kind == "sliding":
            return symbol(equation, part, self.case)
        arm = short(length(part.term.vector, self.case.arithmetic))
        return rf"{arm}\,{rate_symbol(part.term, self)}"

    def sides(self, projection: Projection, solved: Collection[str] | None) -> tuple[str, str]:
        """The two sides of a projection, in symbols or in numbers."""
        return (
            self._side(projection, projection.left, solved),
            self._side(projection, projection.right, solved),
        )

    def _side(
        self, projection: Projection, shares: Sequence[Share], solved: Collection[str] | None
    ) -> str:
        text = ""
        for share in shares:
            size = self.share_size(projection.equation, share.part, solved)
            if size in ("0", "-0"):
                continue
            sign = "-" if (share.sign < 0) != size.startswith("-") else "+" if text else ""
            text += sign + with_cosine(size.removeprefix("-"), share.angle)
        return text or "0"


def with_cosine(size: str, angle: float) -> str:
    """A size times the cosine of an angle in degrees, without a factor of one.

    >>> with_cosine("1", 30.0), with_cosine("0.5", 0.0)
    ('\\\\cos 30^\\\\circ', '0.5')
    """
    if angle == 0:
        return size
    return rf"{'' if size == '1' else size}\cos {angle_text(angle)}"


def rate_symbol(term: Term, stage: Stage) -> str:
    """The symbol of the rotation in a term; of a circling point, whose rate has none, the vector's
    length.
    """
    if term.kind != "rotation":
        return ""
    body = term.rate.removeprefix("omega ")
    return stage.case.naming.turning(body, stage.level)


def deduced(stage: Stage, deduction: Deduction, solved: Collection[str]) -> Iterator[Block]:
    """A deduction in words and equations; relations between rates have been written before."""
    case, single = stage.case, len(deduction.unknowns) == 1 and not deduction.scalars
    for projection in deduction.projections:
        yield Prose(announced(stage, projection))
        yield Display(
            tuple(
                solved_lines(stage, projection, solved, deduction.unknowns[0])
                if single
                else projected_lines(stage, projection, solved)
            )
        )
    if not single:
        yield Prose(phrase("together", case.language))
        yield Display(tuple(line for rate in deduction.unknowns for line in results(stage, rate)))


def projected_lines(stage: Stage, projection: Projection, solved: Collection[str]) -> Iterator[str]:
    """A projection in symbols, and in numbers where that adds something."""
    symbols, numbers = stage.sides(projection, None), stage.sides(projection, solved)
    yield " &= ".join(symbols)
    if numbers != symbols:
        yield " &= ".join(numbers)


def solved_lines(
    stage: Stage, projection: Projection, solved: Collection[str], rate: str
) -> Iterator[str]:
    """A projection with one unknown and its result; as one chain where the unknown stands alone on
    a side.
    """
    left, value = next(results(stage, rate)).split(" &= ", 1)
    sides, numbers = stage.sides(projection, None), stage.sides(projection, solved)
    if left not in sides:
        yield from projected_lines(stage, projection, solved)
        yield from results(stage, rate)
        return
    place = 1 - sides.index(left)
    steps = [
        text for text in dict.fromkeys((sides[place], numbers[place])) if not NUMBER.fullmatch(text)
    ]
    yield from chained(left, tuple(("=", text) for text in (*steps, value)))
    yield from list(results(stage, rate))[1:]


def announced(stage: Stage, projection: Projection) -> str:
    """On which axis the equation is projected, and why."""
    key = AXES.get(projection.axis, "axis_at")
    axis = phrase(key, stage.case.language, angle=angle_text(projection.axis))
    if projection.dropped is None:
        return phrase("project_along", stage.case.language, axis=axis)
    dropped = letters_of(projection.equation, projection.dropped, stage.case, bold=True)
    return phrase("project_drop", stage.case.language, axis=axis, dropped=dropped)


def results(stage: Stage, rate: str) -> Iterator[str]:
    """The value of a vector along its direction, and of the rotation it belongs to."""
    case, level = stage.case, stage.level
    found = stage.occurrences(rate)
    turning = rate.startswith("omega ")
    if found and (len(found) == 1 or not turning):
        equation, part = found[0]
        yield f"{symbol(equation, part, case)} &= {vector_value(part, case, level)}"
        if not turning:
            return
        yield rotation_result(
            rate, case, level, f"\\frac{{{symbol(equation, part, case)}}}{{{arm(part, case)}}} = "
        )
    elif turning:
        yield rotation_result(rate, case, level, "")


def rotation_result(rate: str, case: Case, level: Level, how: str) -> str:
    """The value of an angular velocity or acceleration with its sense."""
    body = rate.removeprefix("omega ")
    letters = case.naming.turning(body, level)
    value = case.rates(level)[rate]
    return f"{letters} &= {how}{stated(value, UNITS[level, True])}{sense_of_rotation(value, case)}"


def vector_value(part: Part, case: Case, level: Level) -> str:
    """The algebraic value of an unknown vector along its positive direction, with its sense in
    words.
    """
    if part.term is None or part.coefficient is None:
        return stated(length(part.value, case.arithmetic), UNITS[level, False])
    value = along_direction(part.term, case, level)
    return stated(value, UNITS[level, False]) + sense_along(
        double(value), part.coefficient, ends_of_path(part, case), case
    )


def ends_of_path(part: Part, case: Case) -> tuple[str, str] | None:
    """The points that give the line along which a part lies, in its positive sense; None where no
    two points do.
    """
    ends = ends_of_track(part.term, case) if part.term and part.term.kind == "sliding" else None
    if ends is None or part.coefficient is None:
        return None
    start, end = (case.motion.points[point] for point in ends)
    return ends if float((end - start).dot(part.coefficient)) > 0 else (ends[1], ends[0])


def along_direction(term: Term, case: Case, level: Level) -> Any:
    """A term's signed value along its positive direction: exact where the field holds it."""
    rate = case.rates(level)[term.rate]
    size = length(term.vector, case.arithmetic)
    return float(rate) * size if isinstance(size, float) else rate * size

"""The idea of a vector equation: which magnitudes are unknown, and which projection gives which."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kinegrade.language.message import Message, Text, list_all, list_plainly
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.vector_equation import Part
from kinegrade.worked.deductions.deductions import name_line
from kinegrade.worked.deductions.projected_angles import AXIS_NAMES
from kinegrade.worked.formulas.symbols import join_letters
from kinegrade.worked.steps.titles import select_scalars
from kinegrade.worked.vectors.inclinations import find_ends
from kinegrade.worked.vectors.projection import Deduction, Projection, find_deductions
from kinegrade.worked.vectors.stage import Stage
from kinegrade.worked.vectors.vectors import name_part, vanishes

_MOST = 3  # projections that a sentence names
_HALF = 180.0  # degrees
_MANY = 7  # vectors that a sentence does not name


def explain_unknowns(step: Step, stage: Stage) -> Iterator[Message]:
    """What is unknown in the equations of a step, and which projections leave it alone; nothing
    where they have to be solved together, or are too many for a sentence.
    """
    scalars = select_scalars(step, stage.case)
    found = tuple(find_deductions(stage.equations, scalars, step.unknowns))
    kept = [one for one in found if not stage.spares(one)]
    alone = all(len(one.unknowns) == 1 and not one.scalars for one in found)
    if not alone or not 0 < len(kept) <= _MOST:
        return
    unknown = list_all(f"${name_unknown(rate, stage)}$" for one in found for rate in one.unknowns)
    ways = list_plainly(_state_way(one, stage) for one in kept)
    yield Message("solution.idea-unknown", unknown=unknown, ways=ways, count=len(found))


def name_unknown(rate: Rate, stage: Stage) -> str:
    """The letter of an unknown: of its vector, or of the rotation that several vectors share."""
    case, places = stage.case, stage.occurrences(rate)
    (equation, part), *others = places
    if others and rate.kind == "turning":
        return case.text(case.naming.turning(rate.body, stage.level))
    return case.text(name_part(equation, part, case))


def _state_way(deduction: Deduction, stage: Stage) -> Message:
    """The projection that leaves one unknown alone."""
    (projection,), (rate,) = deduction.projections, deduction.unknowns
    sought = name_unknown(rate, stage)
    return Message(
        "solution.projection-leaves", axis=_name_axis(projection, sought, stage), sought=sought
    )


def _name_axis(projection: Projection, sought: str, stage: Stage) -> Text:
    """The axis: x or y, the line of two points, the normal to the vector that drops out, or along
    the one that is sought.
    """
    case, part = stage.case, projection.dropped
    named = AXIS_NAMES.get(projection.axis % _HALF)
    if named is not None:
        return named
    if part is None:
        return Message("solution.projection-of", vector=sought)
    if name_line(projection.axis, part, case) is not None:
        ends = find_ends(part, case) or ()
        return f"${case.text(join_letters(map(case.naming.letter, ends)))}$"
    dropped = case.text(name_part(projection.equation, part, case, bold=True))
    return Message("solution.across-line", line=dropped)


def explain_accelerations(stages: Iterable[Stage]) -> Message:
    """Which parts of the accelerations are known from the velocities, and which are sought by the
    same projections; without their names where these are many.
    """
    known, sought = list[str](), list[str]()
    for stage in stages:
        for equation in stage.equations:
            for part in equation.parts:
                letters = stage.case.text(name_part(equation, part, stage.case))
                if part.unknown is not None and not stage.leaves_out(part.unknown):
                    sought.append(f"${letters}$")
                elif part.unknown is None and _follows_from_velocities(part):
                    known.append(f"${letters}$")
    known, sought = list(dict.fromkeys(known)), list(dict.fromkeys(sought))
    if not known or not sought or len(known) + len(sought) > _MANY:
        return Message("solution.idea-accelerations")
    parts = {"known": list_all(known), "sought": list_all(sought)}
    return Message("solution.idea-accelerations-of", **parts)


def _follows_from_velocities(part: Part) -> bool:
    return not vanishes(part) and (part.part == "n" or part.role == "coriolis")

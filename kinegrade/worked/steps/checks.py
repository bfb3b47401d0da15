"""The check at the end of a chapter: the last vector equation projected on an axis that has not
been used, both sides worked out.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from kinegrade.language.math.width import measure_row
from kinegrade.language.message import Message
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.relations import add_vectors
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.atoms import AxisName
from kinegrade.worked.formulas.equation import WIDEST, Equation, approximate
from kinegrade.worked.formulas.exactness import is_rounded
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.numbers import state_number
from kinegrade.worked.steps.couplers import choose_method, find_coupler
from kinegrade.worked.vectors.deductions import AXIS_NAMES
from kinegrade.worked.vectors.inclinations import is_angle_known
from kinegrade.worked.vectors.projection import Projection, Share, find_deductions
from kinegrade.worked.vectors.stage import Stage, find_share_cosine
from kinegrade.worked.vectors.summands import PLACES
from kinegrade.worked.vectors.vectors import UNITS

_SAME = 1e-6  # degrees within which two axes are one
_LONGEST = 2 * WIDEST  # letters of both sides: what is read at a glance
_AXES: Mapping[float, AxisName] = {0.0: "x", 90.0: "y"}


def check_last(stages: Mapping[Step, Stage]) -> Iterator[Block]:
    """The check of the last step that has one, with the values printed before; nothing where no
    axis is left on which both sides have a part, by angles that the solution has named, and short.
    """
    for step, stage in reversed(tuple(stages.items())):
        projection = _find_unused(step, stage)
        sides = _state_sides(projection, step, stage) if projection else ()
        if projection and sum(_measure(side) for side in sides) <= _LONGEST:
            left, right = map(stage.case.tell, sides)
            axis = AXIS_NAMES[projection.axis]
            yield stage.case.say(Message("solution.check", axis=axis, left=left, right=right))
            return


def _find_unused(step: Step, stage: Stage) -> Projection | None:
    """A projection of the step's equation that its deductions have not used; None for steps that
    are not solved by projections of one equation.
    """
    coupler = find_coupler(stage)
    by_projections = coupler is None or choose_method(coupler, stage.case) == "base-point"
    if len(stage.equations) != 1 or len(stage.equations[0].unknowns) != 2 or not by_projections:
        return None
    (equation,) = stage.equations
    deductions = find_deductions(stage.equations, (), step.unknowns)
    used = [one.axis for deduction in deductions for one in deduction.projections]
    unused = (Projection(equation, axis, None) for axis in AXIS_NAMES if not _is_among(axis, used))
    return next((one for one in unused if _can_be_told(one, stage)), None)


def _is_among(axis: float, used: Sequence[float]) -> bool:
    return any(abs((axis - other + 90) % 180 - 90) < _SAME for other in used)


def _can_be_told(projection: Projection, stage: Stage) -> bool:
    """Whether both sides have a part, and the solution has found every angle that they use."""
    shares = (*projection.left, *projection.right)
    oblique = (share for share in shares if share.angle)
    return bool(projection.left and projection.right) and all(
        find_share_cosine(projection, share, stage.case) is not None
        and is_angle_known(share.part, stage.case)
        for share in oblique
    )


def _state_sides(projection: Projection, step: Step, stage: Stage) -> tuple[Equation, Equation]:
    """Each side in numbers, and what it amounts to."""
    stated = stage.project(projection, step.unknowns)
    return (
        _work_out(stated.left, projection, projection.left, stage),
        _work_out(stated.links[0].right, projection, projection.right, stage),
    )


def _work_out(
    side: Formula, projection: Projection, shares: Sequence[Share], stage: Stage
) -> Equation:
    """A side with its value; alone where it is nothing but a value."""
    if side.is_decimal:
        return Equation(side, ())
    total = add_vectors(share.part.value for share in shares)
    value = total[PLACES[_AXES[projection.axis]]]
    *_, decimal = state_number(value, UNITS[stage.level, False])
    links = approximate(decimal.right) if is_rounded(side) else (decimal,)
    return Equation(side, links)


def _measure(side: Equation) -> float:
    """The letters of a side and its value."""
    return measure_row(side.print_inline("."))

"""The check at the end of a chapter: the last vector equation projected on an axis that has not
been used.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from kinegrade.language.message import Message
from kinegrade.mechanics.plan import Step
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.equation import Equation, approximate
from kinegrade.worked.steps.couplers import choose_method, find_coupler
from kinegrade.worked.vectors.deductions import AXIS_NAMES
from kinegrade.worked.vectors.projection import Projection, find_deductions
from kinegrade.worked.vectors.stage import Stage

_SAME = 1e-6  # degrees within which two axes are one


def check_last(stages: Mapping[Step, Stage]) -> Iterator[Block]:
    """The check of the last step that has one, with the values printed before; nothing where no
    axis is left on which both sides have a part.
    """
    for step, stage in reversed(tuple(stages.items())):
        projection = _find_unused(step, stage)
        if projection is not None:
            sides = stage.project(projection, step.unknowns)
            equation = Equation(sides.links[0].right, approximate(sides.left))
            told = stage.case.tell(equation)
            axis = AXIS_NAMES[projection.axis]
            yield stage.case.say(Message("solution.check", axis=axis, equation=told))
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
    return next((one for one in unused if one.left and one.right), None)


def _is_among(axis: float, used: Sequence[float]) -> bool:
    return any(abs((axis - other + 90) % 180 - 90) < _SAME for other in used)

"""Drums: rims of a gear's body on which a rope winds, beside the pitch circle with which it
meshes.
"""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.mechanics.laws import NoSlip, find_rims
from kinegrade.mechanics.shapes import Circle
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.words.body_names import BodyNames

_WOUND = frozenset({"rope", "cord"})


def is_drum(roll: NoSlip, case: Case) -> bool:
    """Whether a rope winds on another rim of a gear than that with which this meshes."""
    if BodyNames(case.template).label(roll.of).word not in _WOUND:
        return False
    pitches = [double(circle.radius) for circle in _list_pitch_circles(roll.body, case)]
    return bool(pitches) and double(roll.circle.radius) not in pitches


def _list_pitch_circles(body: str, case: Case) -> Iterator[Circle]:
    """The circles with which a body meshes with others."""
    for relation in case.motion.frames.relations:
        rims = find_rims(relation.source)
        if rims is not None and rims.body == body:
            yield rims.circle
        if rims is not None and rims.of == body:
            yield rims.on

"""What a relation of rates alone links: a belt, a mesh, a rotation that is given relative to a
body.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.drivers.imposed import select_imposed
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import (
    Imposed,
    ImposedCircling,
    ImposedComponent,
    ImposedMotion,
    ImposedRotation,
    Law,
    find_rims,
)
from kinegrade.worked.case import Case
from kinegrade.worked.rates.rims import say_of_carrier


def explain_link(law: Law | None, case: Case) -> Iterator[Message]:
    """What a relation of rates alone links; nothing for what is given, or turns alike."""
    if law is None:
        return
    imposed, rims = select_imposed(law), find_rims(law)
    if imposed is not None:
        yield from _explain_imposed(imposed, case)
    if rims is not None:
        what = "idea-belts" if rims.is_belt else "idea-meshes"
        yield say_of_carrier(what, rims.carrier, case)


def _explain_imposed(law: Imposed, case: Case) -> Iterator[Message]:
    """What a given rotation of one body relative to another links; nothing for other givens."""
    match law:
        case ImposedRotation(body=body, of=of) if of != GROUND:
            yield _explain_relative_rotation(body, of, case)
        case ImposedRotation() | ImposedMotion() | ImposedComponent() | ImposedCircling():
            return
        case _:
            assert_never(law)


def _explain_relative_rotation(body: str, of: str, case: Case) -> Message:
    """What an imposed relative rotation links, and from where the body's points follow."""
    return Message(
        "solution.idea-relative-rotation",
        body=case.naming.body(body),
        other=case.naming.body(of),
        base=case.naming.point(case.motion.frames.bases[body].point),
    )

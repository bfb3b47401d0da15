"""Faces of translating bodies on the rims that drive them: the edge of such a face touches the rim,
which does not sink into it.
"""

from __future__ import annotations

from collections.abc import Sequence

from msgspec.structs import replace

from kinegrade.figure.mechanism.straight_parts import Bar, Part, Rod
from kinegrade.figure.scene import BOLD, FIRM

_OFF_RIM = (BOLD.width + FIRM.width) / 2  # millimetres from the axis of a face to that of the rim


def rest_faces(parts: Sequence[Part]) -> tuple[Part, ...]:
    """All parts, where the faces of rods lie on their rims, with their rods."""
    rods = {part.body for part in parts if isinstance(part, Rod)}
    faces = [part for part in parts if isinstance(part, Bar) and part.use == "face"]
    lifts = {face.body: face.back * _OFF_RIM for face in faces if face.body in rods}
    return tuple(
        replace(
            part,
            start=part.start + lifts[part.body],
            end=part.end + lifts[part.body],
            free=tuple(end + lifts[part.body] for end in part.free),
        )
        if isinstance(part, Bar | Rod) and part.body in lifts
        else part
        for part in parts
    )

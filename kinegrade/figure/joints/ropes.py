"""What a body that hangs on a wheel looks like: the rope, from where it leaves the wheel to its
end, and the load there.
"""

from __future__ import annotations

from collections.abc import Mapping

from kinegrade.figure.joints.symbol import Hanging
from kinegrade.figure.plane import length, on_line
from kinegrade.mechanics.joints import GROUND, Line
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import ROPES


def is_rope(shapes: Mapping[str, str], body: str) -> bool:
    """Whether a body is a rope, alone or with a load at its end."""
    return body != GROUND and shapes.get(body) in ROPES


def find_rope(
    mechanism: Mechanism, body: str, line: Line, touch: Vector, shapes: Mapping[str, str]
) -> Hanging:
    """The rope of a body along a line, from a touching point to the farthest marked point on it."""
    points = [mechanism.points[name] for name in mechanism.body(body).points]
    stations = [touch, *(at for at in points if on_line(at, line))]
    end = max(stations, key=lambda at: length(at - touch))
    return Hanging(body, line, touch, end, shapes.get(body) == "load")

"""Whether a figure can be read as it is printed: everything on paper, no symbol crowded,
no part too small to be seen.
"""

from __future__ import annotations

from itertools import combinations
from math import hypot, inf

from kinegrade.figure.marks.dimensions import find_measured_direction
from kinegrade.figure.mechanism.fitting import HEIGHT, WIDTH, measure_span
from kinegrade.figure.mechanism.view import crop_to_view
from kinegrade.figure.sketch import Sketcher, sketch
from kinegrade.language.message import Message
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.problem.template.hints import FigureHints

SMALLEST = 4.0  # millimetres on paper of a crank, an eccentricity, the radius of a wheel
_NOTHING = 1e-6  # metres: points nearer than this are one


def find_illegible(
    mechanism: Mechanism, hints: FigureHints, sketcher: Sketcher = sketch
) -> Message | None:
    """Why the figure that `sketcher` draws of a mechanism (floats, metres) cannot be read well;
    None where it can.

    Nothing is drawn where a part would be too small even if the mechanism filled the paper. Raises
    TemplateError as `sketch` does.
    """
    smallest = _measure_smallest_part(mechanism, hints)
    width, height = measure_span(crop_to_view(mechanism, hints), hints)
    if smallest * WIDTH < SMALLEST * width or smallest * HEIGHT < SMALLEST * height:
        return Message("figure.part-too-small", least=f"{SMALLEST:g}")
    scene = sketcher(mechanism, hints)
    if scene.width > WIDTH or scene.height > HEIGHT:
        return Message("figure.too-large", width=f"{WIDTH:g}", height=f"{HEIGHT:g}")
    if smallest * scene.scale < SMALLEST:
        return Message("figure.part-too-small", least=f"{SMALLEST:g}")
    if scene.crowded:
        return Message("figure.symbol-crowded", symbol=scene.crowded[0])
    return None


def _measure_smallest_part(mechanism: Mechanism, hints: FigureHints) -> float:
    """The least distance in metres between points of one body or the ends of a length with a
    symbol, or the least radius.
    """
    pairs = {pair for body in mechanism.bodies for pair in combinations(body.points, 2)}
    at = mechanism.points
    sizes = [hypot(*(at[start] - at[end])) for start, end in pairs]
    for given in hints.lengths:
        start, end = at[given.start], at[given.end]
        sizes.append(abs((end - start).dot(find_measured_direction(given.along, start, end))))
    sizes += [circle.radius for joint in mechanism.joints for circle in joint.list_circles()]
    return min((size for size in sizes if size > _NOTHING), default=inf)

"""How large the drawings of a cycle are: where the mechanism goes, and what of its centrodes is
shown beside it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from kinegrade.figure.scene import Box
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.motion.path import Array

WIDTH, HEIGHT = 120.0, 90.0  # millimetres
WIDEST, HIGHEST = 158.0, 138.0  # millimetres, with centrodes
_SURROUND = 16.0  # millimetres that symbols take beside the mechanism
_BESIDE = 0.5  # of the mechanism's extent, on each side: as far out centrodes are shown
_LEAST = 1e-9  # metres


def find_extent(mechanisms: Sequence[Mechanism]) -> Box:
    """Where the mechanism is in any of its positions, in m."""
    places = [place for each in mechanisms for place in each.points.values()]
    radii = [circle.radius for joint in mechanisms[0].joints for circle in joint.list_circles()]
    reach = max(radii, default=0.0)
    xs, ys = [place.x for place in places], [place.y for place in places]
    return Box(min(xs) - reach, min(ys) - reach, max(xs) + reach, max(ys) + reach)


def widen(extent: Box) -> Box:
    """The frame within which centrodes are shown."""
    beside = _BESIDE * max(extent.width, extent.height)
    return Box(
        extent.left - beside, extent.bottom - beside, extent.right + beside, extent.top + beside
    )


def scale_box(box: Box, scale: float) -> Box:
    """A box at a scale."""
    return Box(box.left * scale, box.bottom * scale, box.right * scale, box.top * scale)


def enclose(extent: Box, frame: Box, curves: Iterable[Array]) -> Box:
    """The extent with what the frame holds of curves, rows of x and y."""
    shown = np.concatenate(
        [
            [[extent.left, extent.right], [extent.bottom, extent.top]],
            *(curve.reshape(2, -1)[:, is_inside(curve, frame).ravel()] for curve in curves),
        ],
        axis=1,
    )
    (left, bottom), (right, top) = shown.min(axis=1).tolist(), shown.max(axis=1).tolist()
    return Box(left, bottom, right, top)


def is_inside(places: Array, frame: Box) -> Array:
    """Which of the places, rows of x and y, lie in a frame; none that is not finite does."""
    x, y = places
    across = (frame.left <= x) & (x <= frame.right)
    return np.asarray(across & (frame.bottom <= y) & (y <= frame.top))


def choose_scale(extent: Box, width: float, height: float) -> float:
    """Millimetres on paper per metre, at which the symbols beside it have room as well."""
    across = (width - _SURROUND) / max(extent.width, _LEAST)
    return float(min(across, (height - _SURROUND) / max(extent.height, _LEAST)))

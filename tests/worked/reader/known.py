"""Templates whose worked solutions break a law of print, law by law, with the reason: to be
shrunk, never to grow. A law is listed without its templates where it is not broken.
"""

from __future__ import annotations

from collections.abc import Mapping

from tests.worked.reader.laws import Law

KNOWN: Mapping[Law, frozenset[str]] = {
    # rounded numbers put in lose a digit
    "equal": frozenset(("two-wheels-on-cylinder",)),
    "rounded": frozenset(),
    "exact": frozenset(),
    "settled": frozenset(),
    "short": frozenset(),
    "unit": frozenset(),
    # a length or a component is used that was not derived
    "symbol": frozenset(
        (
            "bar-through-swivelling-sleeve",
            "bent-rod-two-sleeves",
            "crank-slider-in-floating-link",
            "flat-faced-follower-curvature-radius",
            "flat-faced-follower-eccentric-circle",
            "guided-rack-and-gear",
            "pole-sleeve-slider-rod",
            "rod-sliding-on-driven-wheel",
            "roller-rolling-on-rotating-bar",
            "square-on-two-fixed-points",
            "stone-crusher",
            "triangle-pose-three-frames",
        )
    ),
    # directions by their angle from x
    "angle": frozenset(
        (
            "crank-bar-through-sleeve-with-arm",
            "extended-rod-driving-rocker",
            "flat-faced-follower-curvature-radius",
            "planetary-gear-external-rim-accelerations",
            "planetary-gear-external-rim-velocities",
            "rolling-wheel-pin-slotted-rocker",
            "stone-crusher",
            "wheel-inside-circular-track",
        )
    ),
    # points of the construction alone
    "point": frozenset(
        (
            "crank-rocker-towed-wheel",
            "guided-rack-and-gear",
            "rolling-wheel-pin-slotted-rocker",
            "stone-crusher",
            "triangle-pose-three-frames",
        )
    ),
    "closed": frozenset(),
    # short arrows between others leave a symbol no place of its own
    "label": frozenset(
        (
            "bar-pushing-rolling-disc",
            "crank-rocker-towed-wheel",
            "crank-rod-over-translating-pin",
            "crank-slider-in-floating-link",
            "parallelogram-with-sliding-rod",
            "pin-in-disc-slot-and-rod",
            "pin-in-two-rings",
            "slider-driven-gear-on-rack",
            "slotted-bar-between-two-rods",
            "square-on-two-fixed-points",
            "two-rods-driven-ends",
        )
    ),
}

# Those that break a law at some draws, and not at the two that `make test` looks at
RARE: Mapping[Law, frozenset[str]] = {
    # the direction beside a velocity, in degrees from the x axis
    "angle": frozenset(("two-rods-driven-ends", "wheel-on-circular-track")),
    # the unknown of a projection in which no vector stands on the left
    "symbol": frozenset(("bar-pushing-rolling-disc",)),
    # one draw in ten, of 515
    "label": frozenset(
        (
            "bar-through-swivelling-sleeve",
            "bent-coupler-instant-translation",
            "bent-rod-two-sleeves",
            "crank-bar-through-sleeve-with-arm",
            "eccentric-cam-offset-follower",
            "extended-rod-driving-rocker",
            "four-bar-parallel-coupler",
            "roller-rolling-on-rotating-bar",
            "slider-crank-relative-rotation-driver",
            "slotted-rocker-and-slider-two-drivers",
        )
    ),
}

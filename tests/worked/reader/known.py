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
    # a component, or the rotation of a body that translates, is used that was not derived
    "symbol": frozenset(
        (
            "bent-rod-two-sleeves",
            "triangle-pose-three-frames",
        )
    ),
    # directions by their angle from x
    "angle": frozenset(("planetary-gear-external-rim-velocities", "two-wheels-on-cylinder")),
    # points of the construction alone
    "point": frozenset(("rolling-wheel-pin-slotted-rocker",)),
    "closed": frozenset(),
    # short arrows along others leave a symbol no place of its own
    "label": frozenset(("crank-slider-in-floating-link",)),
}

# Those that break a law at some draws, and not at the two that `make test` looks at
RARE: Mapping[Law, frozenset[str]] = {
    # one draw in 400
    "label": frozenset(("bent-rod-two-sleeves",)),
}

"""Templates whose worked solutions break a law of print, law by law, with the reason: to be
shrunk, never to grow. A law is listed without its templates where it is not broken.
"""

from __future__ import annotations

from collections.abc import Mapping

from tests.worked.reader.laws import Law

KNOWN: Mapping[Law, frozenset[str]] = {
    "equal": frozenset(),
    "rounded": frozenset(),
    "exact": frozenset(),
    "settled": frozenset(),
    "short": frozenset(),
    "unit": frozenset(),
    "symbol": frozenset(),
    "angle": frozenset(),
    "point": frozenset(),
    "closed": frozenset(),
    "label": frozenset(),
    "corner": frozenset(),
    # of all that may be asked together: a speed of which only the components are used
    "used": frozenset(("flat-faced-follower-eccentric-circle",)),
    # each of three angles is placed by the signs of its sine and cosine; in the roller's case a
    # velocity is found among the accelerations, by the same way as an acceleration before
    "once": frozenset(
        (
            "triangle-pose-three-frames",
            "roller-rolling-on-rotating-bar",
        )
    ),
    "inclined": frozenset(),
    "between": frozenset(),
    "sense": frozenset(),
    "early": frozenset(),
    "way": frozenset(),
    "marked": frozenset(),
    "named": frozenset(),
    "size": frozenset(),
    # found by its rotation, the velocity of a point lies along a track by chance; -a_{D,y} or
    # -v_{A,x} is asked
    "senses": frozenset(
        (
            "crank-rocker-towed-wheel",
            "elliptic-trammel-end-driven",
            "slider-driven-gear-on-rack",
        )
    ),
    "lettered": frozenset(),
    "doubled": frozenset(),
    "signed": frozenset(),
    "zero": frozenset(),
    "redone": frozenset(),
    "figure": frozenset(),
    "sign": frozenset(),
    "independent": frozenset(),
    "given": frozenset(),
    # two of three angles have vectors called u and v
    "solved": frozenset(("triangle-pose-three-frames",)),
}

# Those that break a law at some draws, and not at the two that `make test` looks at
RARE: Mapping[Law, frozenset[str]] = {
    # one draw in 400; short arrows along others leave a symbol no place of its own
    "label": frozenset(("bent-rod-two-sleeves", "crank-slider-in-floating-link")),
}

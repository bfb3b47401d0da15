"""Templates whose figures are not yet without flaws, each with the reason; the list only shrinks.

The proof passes them over; whoever removes the cause removes the line.
"""

from __future__ import annotations

from collections.abc import Mapping

KNOWN: Mapping[str, str] = {
    "crank-rocker-towed-wheel": "the letter of a small wheel's centre stands outside, too far from it",
    "guided-rack-and-gear": "the dot of the contact lies among the teeth",
    "pose-cam-tappet": "the letter of an axis meets the leg of an angle",
    "ring-gear-planet-relative-spin": "the letter of the planet's centre stands too far from it",
    "rod-sliding-on-driven-wheel": "the letter of the wheel's centre stands too far from it",
    "triangle-pose-three-frames": "the letter of a body's axis meets the leg of an angle",
}

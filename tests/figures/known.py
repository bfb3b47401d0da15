"""Templates whose figures are not yet without flaws, each with the reason; the list only shrinks.

The proof passes them over; whoever removes the cause removes the line.
"""

from __future__ import annotations

from collections.abc import Mapping

KNOWN: Mapping[str, str] = {
    "bent-rod-tangent-disc": "psi in a narrow angle",
    "crank-rocker-towed-wheel": "a wheel under 4 mm",
    "crossed-belt-drive": "the radius r1 reaches over the rim",
    "eccentric-cam-offset-follower": "letters crowd about the eccentricity",
    "flat-faced-follower-eccentric-circle": "an eccentricity under 4 mm",
    "pose-cam-tappet": "an eccentricity under 4 mm",
    "ring-gear-planet-relative-spin": "a planet under 4 mm",
    "rolling-wheel-rim-points": "a step of the rim under 4 mm",
    "stone-crusher": "a crank under 4 mm",
    "two-rods-driven-ends": "B comes near O",
    "two-wheels-on-cylinder": "wheels under 4 mm",
    "wheel-inside-circular-track": "a wheel under 4 mm",
    "wheel-on-circular-track": "a wheel under 4 mm",
}

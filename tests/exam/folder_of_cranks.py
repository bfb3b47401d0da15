"""Templates to draw from: three cranks, two gears whose acceleration is asked, a cam with a tag of
its own.
"""

from __future__ import annotations

from pathlib import Path

from tests.problem.crank import crank_text

ACCELERATION = (
    'v_y = { quantity = "y(velocity(A))", unit = "m/s", sign = "+y"',
    'a_x = { quantity = "x(acceleration(A))", unit = "m/s^2", points = 4, sign = "+x"',
)
FAMILIES = {
    "crank-1": "crank",
    "crank-2": "crank",
    "crank-3": "crank",
    "gear-1": "gear",
    "gear-2": "gear",
}


def write_shelf(folder: Path) -> Path:
    """crank-1 to crank-3 and cam (velocity), gear-1 and gear-2 (acceleration)."""
    folder.mkdir()
    for name, family in FAMILIES.items():
        changes = [('family = "crank"', f'family = "{family}"')] + [ACCELERATION] * (
            family == "gear"
        )
        (folder / f"{name}.toml").write_text(crank_text(*changes), encoding="utf-8")
    cam = crank_text(('family = "crank"', 'family = "cam"\ntags = ["round"]'))
    (folder / "cam.toml").write_text(cam, encoding="utf-8")
    return folder

"""Of two wheels about one axle the smaller lies in front, whichever of them is fixed."""

from __future__ import annotations

import pytest

from kinegrade.figure.scene import Disc, Outline
from kinegrade.mechanics.joints import GROUND, Circle, Mesh, Pin, Roll
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from tests.figure.mechanisms import RIGHT, Case, hinted
from tests.figure.test_bodies import drawing_of, layer

ORIGIN = Vector(0.0, 0.0)
ARM = 0.4


def stepped_planet(fixed: float, turning: float) -> Case:
    """A planet with two rims on the arm OA: it rolls on a fixed gear of one radius about O, and
    drives a gear of the other radius about O.
    """
    joints = (
        Pin("O", ("arm", "sun", GROUND)),
        Pin("A", ("arm", "planet")),
        Roll("planet", Circle("A", ARM - fixed), GROUND, Circle("O", fixed)),
        Mesh("planet", Circle("A", ARM - turning), "sun", Circle("O", turning), "arm"),
    )
    bodies = (Body("arm", ("O", "A")), Body("sun", ("O",)), Body("planet", ("A",)))
    mechanism = Mechanism({"O": ORIGIN, "A": RIGHT * ARM}, bodies, joints, ())
    return hinted(mechanism, shapes={"planet": "gear"})


@pytest.mark.parametrize(("fixed", "turning"), [(0.2, 0.3), (0.3, 0.2)])
def test_the_smaller_of_two_coaxial_gears_is_not_hidden(fixed: float, turning: float) -> None:
    """A fixed one lay below all others, and a larger one that turns covered it whole."""
    drawing = drawing_of(stepped_planet(fixed, turning))
    small, large = sorted((fixed * 100.0, turning * 100.0))
    pitches = {
        part.radius: layer(drawing, part)
        for part in drawing.primitives
        if isinstance(part, Disc) and part.fill == "none" and abs(part.centre.x) < 1e-9
    }
    covering = [
        layer(drawing, part)
        for part in drawing.primitives
        if isinstance(part, Outline)
        and part.fill == "grey"
        and max(corner.x for corner in part.corners) > large - 2.0
        and min(corner.x for corner in part.corners) < 2.0 - large
    ]
    assert small in pitches
    assert max(covering) < pitches[small]

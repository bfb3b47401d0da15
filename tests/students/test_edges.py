"""What follows from what on every template: the list as a person read it, and every edge with four
wrong values.
"""

from __future__ import annotations

import pytest

from kinegrade.errors import MechanismError
from kinegrade.problem.template.library.library import load_template
from kinegrade.students.following.connections import choose_generic_values, find_connections
from kinegrade.students.following.follow_through import Follower
from tests.golden_files import Hold
from tests.laws.cases import moving_templates

FACTORS = (1.3, 0.7, -1.0, 3.0)
MOVING = moving_templates()


def test_what_follows_from_what(hold: Hold) -> None:
    lines = [
        f"{name}: {later} from {' '.join(others)}"
        for name in MOVING
        for later, others in find_connections(
            load_template(name), load_template(name).asked()
        ).items()
    ]
    hold("following.txt", "\n".join(lines) + "\n")


@pytest.mark.sampled(8)
@pytest.mark.parametrize("name", MOVING)
def test_every_edge_holds_for_every_wrong_value(name: str) -> None:
    """Of a reversed value what follows may be right, as a normal acceleration is; and no magnitude
    is smaller than a part of it that stays as it was.
    """
    template = load_template(name)
    asked = template.asked()
    follower = find_follower(name)
    for later, others in find_connections(template, asked).items():
        for earlier in others:
            right = follower.right(earlier)
            silent = {
                factor
                for factor in FACTORS
                if right and not follower.consequences({earlier: factor * right}, later)
            }
            assert silent == set(FACTORS) or silent <= {0.7, -1.0}, (earlier, later, silent)


def find_follower(name: str) -> Follower:
    """An instance of a template, drawn at large."""
    template = load_template(name)
    for number in range(1, 8):
        follower = Follower(template, choose_generic_values(template, number))
        try:
            if follower.right_motion is not None:
                return follower
        except MechanismError:
            continue
    raise AssertionError(name)

"""The supports of a shipped template stand on the same sides in every draw: below their pins, or
where its figure says.
"""

from __future__ import annotations

from random import Random

import pytest
from shapely import LineString, Point

from kinegrade.errors import MechanismError
from kinegrade.figure.joints.symbol import find_fixed_pins
from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.mechanism.fitting import measure_span
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.mechanism.stands import (
    choose_upright,
    draw_stands,
    draw_stands_of_sleeves,
)
from kinegrade.figure.mechanism.view import crop_to_view
from kinegrade.figure.plane import SIDE_VECTORS, unit
from kinegrade.figure.scene import Strokes
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names
from kinegrade.problem.template.template import Template
from tests.laws.cases import first_fulfilling, shipped

DRAWS = 15
ROOM = 62.0, 44.0  # millimetres that symbols and marks usually leave the mechanism


def draw_anatomy(template: Template, seed: int) -> Anatomy:
    """The anatomy of a mechanism, about as large as it is printed. Raises MechanismError."""
    numbers = Random(seed)
    values = first_fulfilling(template, lambda given: numbers.choice(given.choices))
    motion = solve_template(template, values).motion
    mechanism = crop_to_view(motion.frames.mechanism.map(float), template.figure)
    spans = measure_span(mechanism, template.figure)
    scale = min(room / max(span, 1e-9) for room, span in zip(ROOM, spans, strict=True))
    return Anatomy.of(scale_to_paper(mechanism, scale), template.figure)


@pytest.mark.sampled(8, first=3)
@pytest.mark.parametrize("name", find_template_names())
def test_a_support_is_on_one_side_in_all_draws(name: str) -> None:
    template = shipped(name)
    for seed in range(DRAWS):
        try:
            anatomy = draw_anatomy(template, seed)
        except MechanismError:
            continue
        for pin in find_fixed_pins(anatomy.symbols):
            side = SIDE_VECTORS[template.figure.supports.get(pin, "down")]
            if pin not in anatomy.knife_edges:
                assert unit(choose_upright(pin, anatomy)) == side, (seed, pin)


@pytest.mark.parametrize("name", ["bent-rod-tangent-disc"])
def test_the_support_of_an_eccentric_disc_does_not_cross_its_rim(name: str) -> None:
    template = shipped(name)
    for seed in range(2 * DRAWS):
        anatomy = draw_anatomy(template, seed)
        rims = [Point(rim.at).buffer(rim.radius, 60) for rim in anatomy.rims]
        for stand in (*draw_stands(anatomy), *draw_stands_of_sleeves(anatomy)):
            lines = stand.lines if isinstance(stand, Strokes) else ()
            crossed = [rim for rim in rims for line in lines if LineString(line).crosses(rim)]
            assert crossed == [], seed

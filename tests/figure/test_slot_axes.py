"""The axis of a slot, which shows the side of an angle, stops at what slides in the slot."""

from __future__ import annotations

from operator import attrgetter

import pytest
from msgspec.structs import replace
from shapely import LineString, Point, Polygon

from kinegrade.figure.scene import FIRM, PITCH, Disc, Outline, Scene, Strokes
from kinegrade.figure.sketch import sketch
from kinegrade.figure.symbols.pins import PIN
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template

ROCKER = ("extended-rod-driving-rocker", {"r": "1/5", "L": "1/2", "L_BD": "2/5"})
DISC = ("pin-in-disc-slot-and-rod", {"b": "1/10"})
CORNERS_OF_BLOCK = 4


def draw_slot(template: tuple[str, dict[str, str]], **angles: str) -> Scene:
    """A mechanism with an angle at the foot of a slotted bar."""
    name, sizes = template
    loaded = load_template(name)
    solution = solve_template(loaded, {**sizes, **angles})
    mechanism = solution.motion.frames.mechanism.map(float)
    return sketch(mechanism, mark_question(loaded, loaded.asked()))


def list_axes(scene: Scene) -> list[LineString]:
    pitch = (part for part in scene.primitives if isinstance(part, Strokes) and part.pen == PITCH)
    lines = (line for strokes in pitch for line in strokes.lines)
    return [LineString([(start.x, start.y), (end.x, end.y)]) for start, end in lines]


CASES = [
    (ROCKER, {"phi": "60", "delta": "45"}),
    (ROCKER, {"phi": "90", "delta": "60"}),
    (ROCKER, {"phi": "45", "delta": "80"}),
    (DISC, {"phi": "30"}),
    (DISC, {"phi": "60"}),
    (DISC, {"phi": "135"}),
]


@pytest.mark.parametrize(("template", "angles"), CASES)
def test_the_axis_of_a_slot_is_drawn_in_no_open_pin(
    template: tuple[str, dict[str, str]], angles: dict[str, str]
) -> None:
    scene = draw_slot(template, **angles)
    discs = [part for part in scene.primitives if isinstance(part, Disc) and part.fill == "white"]
    pins = [disc for disc in discs if disc.radius <= PIN]
    first = min(map(scene.primitives.index, pins))  # what is drawn before is covered by the pins
    axes = list_axes(replace(scene, primitives=scene.primitives[first:]))
    assert axes
    assert min(axis.distance(Point(*pin.centre)) for axis in axes for pin in pins) > PIN + 0.1


@pytest.mark.parametrize("phi", ["30", "60", "135"])
def test_a_slot_beside_the_centre_of_its_disc_shows_the_axis_to_which_its_distance_is_measured(
    phi: str,
) -> None:
    scene = draw_slot(DISC, phi=phi)
    disc = max(
        (part for part in scene.primitives if isinstance(part, Disc)), key=attrgetter("radius")
    )
    longest = max(list_axes(scene), key=attrgetter("length"))
    assert longest.distance(Point(*disc.centre)) == pytest.approx(0.1 * scene.scale)
    assert longest.length > disc.radius


@pytest.mark.parametrize(("template", "angles"), CASES[:3])
def test_the_axis_of_a_slot_is_not_drawn_across_the_block_in_it(
    template: tuple[str, dict[str, str]], angles: dict[str, str]
) -> None:
    scene = draw_slot(template, **angles)
    outlines = (part for part in scene.primitives if isinstance(part, Outline))
    blocks = [
        Polygon(part.corners)
        for part in outlines
        if part.pen == FIRM and part.fill == "white" and len(part.corners) == CORNERS_OF_BLOCK
    ]
    assert len(blocks) > 1
    assert all(axis.disjoint(block) for axis in list_axes(scene) for block in blocks)

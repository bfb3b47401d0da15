"""Nothing ends at the edge of a block, a slot or a wheel, and every point of contact is seen."""

from __future__ import annotations

from math import hypot

import pytest

from kinegrade.figure.mechanism.layers import Drawing, draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.mechanism.straight_parts import Bar
from kinegrade.figure.plane import length
from kinegrade.figure.scene import FIRM, THIN, TOOTHED, Disc, Outline, Primitive, Strokes
from kinegrade.figure.symbols.bars import BAR_WIDTH
from kinegrade.mechanics.joints import GROUND, Circle, Line, Mesh, Pin, Roll, Slide
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from tests.figure.guided_mechanisms import pin_in_two_slots, sliding_plate
from tests.figure.mechanisms import RIGHT, UP, Case, hinted
from tests.figure.wheel_mechanisms import rack_and_gear

ORIGIN = Vector(0.0, 0.0)


def drawing_of(case: Case) -> Drawing:
    return draw(scale_to_paper(case[0], 100.0), case[1])


def layer(drawing: Drawing, shown: Primitive) -> int:
    return drawing.primitives.index(shown)


def blocks_at(drawing: Drawing, at: Vector) -> list[Outline]:
    return [
        part
        for part in drawing.primitives
        if isinstance(part, Outline)
        and part.fill == "white"
        and len(part.corners) == 4
        and hypot(*(sum(part.corners, ORIGIN) / 4 - at)) < 0.01
    ]


def discs_at(drawing: Drawing, at: Vector) -> list[Disc]:
    discs = [part for part in drawing.primitives if isinstance(part, Disc)]
    return [disc for disc in discs if hypot(*(disc.centre - at)) < 0.01]


def slotted_link(**shapes: str) -> Case:
    """A link with a slot, pinned to a block on the floor; a crank's pin slides in the slot."""
    points = {"B": ORIGIN, "A": UP * 0.2, "O": Vector(0.2, 0.2)}
    joints = (
        Slide("B", "link", Line(ORIGIN, RIGHT), GROUND),
        Pin("O", ("OA", GROUND)),
        Slide("A", "OA", Line(ORIGIN, UP), "link"),
    )
    bodies = (Body("link", ("B",)), Body("OA", ("O", "A")))
    return hinted(Mechanism(points, bodies, joints, ()), shapes=shapes)


@pytest.mark.parametrize(
    ("case", "point"), [(slotted_link(), "B"), (sliding_plate(), "B"), (rack_and_gear(), "A")]
)
def test_a_broad_body_runs_over_the_block_on_the_ground_to_its_pin(case: Case, point: str) -> None:
    drawing, at = drawing_of(case), case[0].points[point] * 100.0
    (block,) = blocks_at(drawing, at)
    (body, *_) = (
        part
        for part in drawing.primitives
        if isinstance(part, Outline) and part.fill == "grey"
        if min(hypot(*(corner - at)) for corner in part.corners) < 3.0
    )
    pin = discs_at(drawing, at)[-1]
    assert layer(drawing, block) < layer(drawing, body) < layer(drawing, pin)


def test_a_rack_has_an_eye_about_its_pin_and_none_at_its_free_end() -> None:
    case = rack_and_gear()
    drawing = drawing_of(case)
    eyes = [part for part in drawing.primitives if isinstance(part, Disc) and part.radius == 1.75]
    assert [eye.centre for eye in eyes] == [case[0].points["A"] * 100.0]


def test_the_outline_of_a_rack_runs_on_in_that_of_its_eye() -> None:
    drawing = drawing_of(rack_and_gear())
    (eye,) = [part for part in drawing.primitives if isinstance(part, Disc) and part.radius == 1.75]
    (inside,) = [
        part
        for part in drawing.primitives
        if isinstance(part, Disc) and part.centre == eye.centre and part.pen is None
    ]
    (rack,) = [
        part
        for part in drawing.primitives
        if isinstance(part, Outline) and part.pen == eye.pen == TOOTHED
        if min(length(corner - eye.centre) for corner in part.corners) < eye.radius
    ]
    assert layer(drawing, eye) < layer(drawing, rack) < layer(drawing, inside)
    assert 1.6 < inside.radius < eye.radius


@pytest.mark.parametrize(("shapes", "blocks"), [({}, 1), ({"link": "bare"}, 0)])
def test_a_pin_in_a_slot_has_no_block_where_the_author_says_so(
    shapes: dict[str, str], blocks: int
) -> None:
    assert len(blocks_at(drawing_of(slotted_link(**shapes)), UP * 20.0)) == blocks


def test_what_lies_behind_a_slotted_bar_is_seen_through_its_slot() -> None:
    case = slotted_link()
    white = [
        part
        for part in drawing_of(case).primitives
        if isinstance(part, Outline) and part.fill == "white" and len(part.corners) > 4
    ]
    (ground,) = [
        part
        for part in drawing_of(case).primitives
        if isinstance(part, Outline) and part.fill == "grey" and part.pen is None
    ]
    assert white == []
    steps = zip(ground.corners, (*ground.corners[1:], ground.corners[0]), strict=True)
    area = abs(sum(start.cross(end) for start, end in steps)) / 2
    size = max(length(corner - ground.corners[0]) for corner in ground.corners)
    assert area < 0.75 * size * BAR_WIDTH


def test_a_slotted_bar_in_front_of_a_disc_is_white_and_grey_elsewhere() -> None:
    def fills(case: Case) -> list[str]:
        return [part.fill for part in drawing_of(case).parts if isinstance(part, Bar)]

    assert fills(pin_in_two_slots()) == ["white"]
    assert set(fills(slotted_link())) == {"grey"}


def test_a_particle_in_two_slots_is_a_pin_without_blocks() -> None:
    case = pin_in_two_slots()
    drawing, at = drawing_of(case), case[0].points["M"] * 100.0
    assert blocks_at(drawing, at) == []
    assert [disc.fill for disc in discs_at(drawing, at)] == ["white"]


def test_the_point_at_which_gears_touch_is_a_dot_that_leaves_their_teeth_whole() -> None:
    case = rack_and_gear()
    drawing, at = drawing_of(case), case[0].points["C"] * 100.0
    (dot,) = discs_at(drawing, at)
    gear, *_ = (
        part for part in drawing.primitives if isinstance(part, Outline) and part.pen == TOOTHED
    )
    tooth = sorted(gear.corners, key=lambda corner: length(corner - at))[:2]
    assert (dot.fill, dot.pen) == ("black", None)
    assert [corner for corner in tooth if not length(corner - at) > dot.radius] == []


@pytest.mark.parametrize("inside", [True, False])
def test_the_hatching_of_a_fixed_gear_stands_on_a_circle_behind_its_teeth(inside: bool) -> None:
    far = 0.1 if inside else 0.3
    mesh = Mesh("W", Circle("A", 0.1), GROUND, Circle("O", 0.2), "arm", inside=inside)
    joints = (Pin("O", ("arm", GROUND)), Pin("A", ("arm", "W")), mesh)
    bodies = (Body("arm", ("O", "A")), Body("W", ("A",)))
    drawing = drawing_of(hinted(Mechanism({"O": ORIGIN, "A": UP * far}, bodies, joints, ())))
    hatching = next(
        part
        for part in drawing.primitives
        if isinstance(part, Strokes) and part.pen == THIN and len(part.lines) > 20
    )
    radii = {round(hypot(*start), 6) for start, _ in hatching.lines}
    edges = {round(disc.radius, 6) for disc in discs_at(drawing, ORIGIN) if disc.pen == FIRM}
    assert radii <= edges
    assert {radius > 20.0 for radius in radii} == {inside}


def test_the_track_of_a_wheel_with_a_flange_is_longer_than_it_is_wide() -> None:
    points = {"O": UP * 0.2, "A": UP * 0.6}
    roll = Roll("W", Circle("O", 0.2), GROUND, Line(ORIGIN, RIGHT))
    case = hinted(
        Mechanism(points, (Body("W", ("O", "A")),), (roll,), ()),
        circles=[{"body": "W", "centre": "O", "through": "A"}],
    )
    (start, end) = next(
        part.lines[0]
        for part in drawing_of(case).primitives
        if isinstance(part, Strokes) and part.pen == FIRM
    )
    assert min(abs(start.x), abs(end.x)) > 40.0 + 2.0

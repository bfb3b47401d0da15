"""What a body looks like: how its bars meet blocks and pins, and how its rigid corners show."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from math import atan2, degrees, hypot

import pytest
from shapely import LineString, Point, Polygon

from kinegrade.figure.mechanism.layers import Drawing, draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.mechanism.straight_parts import Rod
from kinegrade.figure.scene import BOLD, FIRM, PITCH, THIN, Disc, Outline, Primitive, Strokes
from kinegrade.figure.sketch import sketch
from kinegrade.mechanics.joints import GROUND, Line, Parallel, Pin, Slide
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from tests.figure.guided_mechanisms import (
    bent_coupler,
    corner_in_two_sleeves,
    parallelogram_with_sleeve,
    plate_on_fixed_corners,
    sleeve_with_arm,
    sliding_plate,
    swivelling_rod,
)
from tests.figure.mechanisms import RIGHT, UP, Case, hinted, polar, slider_crank, slotted_rocker
from tests.figure.wheel_mechanisms import meshing_gears

ORIGIN = Vector(0.0, 0.0)


def drawing_of(case: Case, scale: float = 100.0) -> Drawing:
    return draw(scale_to_paper(case[0], scale), case[1])


def place(case: Case, name: str) -> Vector:
    return case[0].points[name] * 100.0


def near(one: Vector, other: Vector, within: float = 0.01) -> bool:
    return hypot(*(one - other)) < within


def layer(drawing: Drawing, shown: Primitive) -> int:
    return drawing.primitives.index(shown)


def bold_line_to(drawing: Drawing, at: Vector) -> Strokes:
    """The bold line that ends at a point."""
    return next(
        part
        for part in drawing.primitives
        if isinstance(part, Strokes)
        and part.pen == BOLD
        and any(near(end, at) for end in part.lines[0])
    )


def runs_on_through(bar: Strokes, at: Vector) -> bool:
    """Whether a bar passes a point a centimetre before either of its ends."""
    start, end = (LineString(bar.lines[0]).project(Point(at)), LineString(bar.lines[0]).length)
    on_it = LineString(bar.lines[0]).distance(Point(at)) < 0.01
    return on_it and 2.0 < start < end - 2.0


def blocks_about(drawing: Drawing, at: Vector) -> list[Outline]:
    return [
        part
        for part in drawing.primitives
        if isinstance(part, Outline)
        and len(part.corners) == 4
        and near(sum(part.corners, ORIGIN) / 4, at)
    ]


def circles_at(drawing: Drawing, at: Vector) -> list[Disc]:
    return [part for part in drawing.primitives if isinstance(part, Disc) and near(part.centre, at)]


@pytest.mark.parametrize(
    ("case", "point"), [(slider_crank(0.2, 2.0, 60), "B"), (slotted_rocker(0.2, 30, 75), "A")]
)
def test_a_bar_runs_over_a_block_to_its_pin(case: Case, point: str) -> None:
    drawing, at = drawing_of(case), place(case, point)
    (block,) = blocks_about(drawing, at)
    (pin,) = circles_at(drawing, at)
    assert layer(drawing, block) < layer(drawing, bold_line_to(drawing, at)) < layer(drawing, pin)


def lever(joined: Vector) -> Case:
    """A bar CBD about the ground pin C, with a link from the middle of it to a ground pin."""
    points = {"C": ORIGIN, "B": RIGHT * 0.2, "D": RIGHT * 0.5, "A": RIGHT * 0.2 + joined}
    joints = (Pin("C", ("CD", GROUND)), Pin("B", ("CD", "AB")), Pin("A", ("AB", GROUND)))
    bodies = (Body("CD", ("C", "B", "D")), Body("AB", ("A", "B")))
    return hinted(Mechanism(points, bodies, joints, ()))


def half_circles(drawing: Drawing) -> list[Outline]:
    return [
        part
        for part in drawing.primitives
        if isinstance(part, Outline) and part.fill == "white" and len(part.corners) > 8
    ]


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_pin_on_a_bar_that_runs_on_is_a_half_circle_on_the_side_of_the_other_bar(
    side: float,
) -> None:
    case = lever(Vector(0.1, 0.2 * side))
    drawing, at = drawing_of(case), place(case, "B")
    (half,) = half_circles(drawing)
    assert circles_at(drawing, at) == []
    heights = [(corner - at).y * side for corner in half.corners]
    assert min(heights) == pytest.approx(BOLD.width / 2)  # it leaves the bar whole
    assert max(heights) > 1.0
    assert layer(drawing, half) > layer(drawing, bold_line_to(drawing, at))  # over the link


def test_the_slider_of_a_bar_that_runs_on_has_its_half_circle_below_the_bar() -> None:
    points = {"A": ORIGIN, "B": RIGHT * 0.3, "D": RIGHT * 0.5}
    joints = (Pin("A", ("AD", GROUND)), Slide("B", "AD", Line(RIGHT * 0.3, RIGHT), GROUND))
    case = hinted(Mechanism(points, (Body("AD", ("A", "B", "D")),), joints, ()))
    (half,) = half_circles(drawing_of(case))
    assert max(corner.y for corner in half.corners) < 0


def test_the_pin_of_a_sleeve_is_a_half_circle_in_it_beside_its_bar_towards_what_is_pinned() -> None:
    case = parallelogram_with_sleeve()
    drawing, at, toward = drawing_of(case), place(case, "F"), place(case, "E")
    (half,), (sleeve,) = half_circles(drawing), blocks_about(drawing, at)
    assert layer(drawing, sleeve) < layer(drawing, half)
    aside = {round(corner.x - at.x, 3) for corner in half.corners}
    assert toward.x > at.x
    assert min(aside) == BOLD.width / 2
    assert max(aside) < max(corner.x for corner in sleeve.corners) - at.x - FIRM.width / 2


def test_the_legs_of_a_stand_lead_over_the_sleeve_that_turns_on_it_up_to_the_pin() -> None:
    case = swivelling_rod()
    drawing, at = drawing_of(case), place(case, "D")
    (sleeve,), (half,) = blocks_about(drawing, at), half_circles(drawing)
    outlines = [part for part in drawing.primitives if isinstance(part, Outline)]
    (stand,) = (part for part in outlines if part.corners[0] == at)
    assert layer(drawing, sleeve) < layer(drawing, stand) < layer(drawing, half)


def test_the_pin_of_a_sleeve_with_an_arm_is_a_half_circle_beside_the_bar_away_from_the_arm() -> (
    None
):
    case = sleeve_with_arm()
    drawing, at = drawing_of(case), place(case, "B")
    (sleeve,), (half,) = blocks_about(drawing, at), half_circles(drawing)
    (through,) = [
        part
        for part in drawing.primitives
        if isinstance(part, Strokes) and part.pen == BOLD and runs_on_through(part, at)
    ]
    assert layer(drawing, sleeve) < layer(drawing, half) < layer(drawing, through)
    assert circles_at(drawing, at) == []
    toward = place(case, "D") - at
    assert [corner for corner in half.corners if not (corner - at).dot(toward) < 0] == []


def test_a_bar_ends_at_the_pin_of_a_sleeve_not_at_what_slides_there() -> None:
    case = parallelogram_with_sleeve()
    drawing, at = drawing_of(case), place(case, "F")
    (pin,) = half_circles(drawing)
    assert layer(drawing, bold_line_to(drawing, at)) < layer(drawing, pin)


def test_a_dot_on_the_arm_tells_where_two_gears_mesh_and_leaves_their_teeth_whole() -> None:
    mechanism, hints = meshing_gears()
    points = {**mechanism.points, "D": polar(0.25, 20)}
    arm, sun, _ = mechanism.bodies
    bodies = (arm, sun, Body("planet", ("A", "D")))
    case = replace(mechanism, points=points, bodies=bodies), hints
    drawing, at = drawing_of(case), place(case, "D")
    (dot,) = circles_at(drawing, at)
    assert dot.fill == "black"
    assert dot.radius > BOLD.width / 2


@pytest.mark.parametrize("turn", [90.0, 60.0, -75.0])
def test_the_rod_of_a_yoke_is_welded_to_the_edge_of_its_bar_whose_slot_runs_on_past_it(
    turn: float,
) -> None:
    along = polar(1.0, turn)
    points = {"O": RIGHT * 0.3, "A": along * 0.2, "B": ORIGIN}
    joints = (
        Pin("O", ("OA", GROUND)),
        Parallel("yoke", GROUND),
        Slide("B", "yoke", Line(ORIGIN, RIGHT), GROUND),
        Slide("A", "OA", Line(ORIGIN, along), "yoke"),
    )
    bodies = (Body("OA", ("O", "A")), Body("yoke", ("B",)))
    case = hinted(Mechanism(points, bodies, joints, ()))
    drawing, width = drawing_of(case), 3.5
    (rod,) = [part for part in drawing.parts if isinstance(part, Rod)]
    edge = LineString([along * -20.0, along * 20.0]).buffer(width / 2).boundary
    assert Point(rod.start).distance(edge) == pytest.approx(0.0, abs=0.01)
    gussets = [Polygon(part.corners) for part in black_triangles_of(case)]
    assert len(gussets) == 2
    assert [gusset for gusset in gussets if not edge.buffer(0.01).intersects(gusset)] == []
    slots = [part for part in drawing.primitives if isinstance(part, Outline) and part.pen == THIN]
    assert any(Polygon(slot.corners).contains(Point(along * -2.0)) for slot in slots), slots


def test_a_marked_point_does_not_interrupt_its_bar() -> None:
    case = lever(Vector(0.0, 0.2))
    (dot,) = circles_at(drawing_of(case), place(case, "D"))
    assert (dot.fill, dot.pen) == ("black", None)
    assert dot.radius > BOLD.width / 2


def list_black_triangles(primitives: Iterable[Primitive]) -> list[Outline]:
    return [
        part
        for part in primitives
        if isinstance(part, Outline) and part.fill == "black" and len(part.corners) == 3
    ]


def black_triangles_of(case: Case) -> list[Outline]:
    return list_black_triangles(drawing_of(case).primitives)


def angle_between(gusset: Outline) -> float:
    """Degrees between the two sides of a gusset at its corner."""
    corner, *ends = gusset.corners
    one, other = (end - corner for end in ends)
    return degrees(atan2(abs(one.cross(other)), one.dot(other)))


def test_a_bent_rod_has_a_gusset_that_reaches_out_from_under_its_pin() -> None:
    case = bent_coupler()
    (gusset,) = black_triangles_of(case)
    assert near(gusset.corners[0], place(case, "B"))
    assert angle_between(gusset) == pytest.approx(110.0)
    assert hypot(*((gusset.corners[1] + gusset.corners[2]) / 2 - place(case, "B"))) > 1.5


def test_the_corner_of_two_legs_in_sleeves_is_rigid_and_no_mark_sits_on_it() -> None:
    case = corner_in_two_sleeves()
    at_corner = [
        gusset for gusset in black_triangles_of(case) if near(gusset.corners[0], place(case, "M"))
    ]
    assert len(at_corner) == 1
    assert circles_at(drawing_of(case), place(case, "M")) == []


def test_an_arm_ends_at_the_edge_of_its_sleeve_with_a_gusset_on_either_side() -> None:
    case = sleeve_with_arm()
    drawing, at = drawing_of(case), place(case, "B")
    (sleeve,) = blocks_about(drawing, at)
    arm = next(
        part
        for part in drawing.primitives
        if isinstance(part, Strokes)
        and part.pen == BOLD
        and {near(end, place(case, "D")) for end in part.lines[0]} == {True, False}
    )
    bar = bold_line_to(drawing, place(case, "A"))
    assert layer(drawing, arm) < layer(drawing, sleeve) < layer(drawing, bar)
    first, second = black_triangles_of(case)
    assert near(first.corners[0], second.corners[0])
    assert hypot(*(first.corners[0] - at)) == pytest.approx(2.2)  # half the sleeve's width
    assert [angle_between(each) for each in (first, second)] == [pytest.approx(90.0)] * 2


def coupler_plate() -> Case:
    """A plate pinned at each of its three corners to a bar that turns about the ground."""
    points = {"A": ORIGIN, "B": RIGHT * 0.4, "C": Vector(0.1, 0.3)}
    grounds = {f"{name}0": at + Vector(-0.1, 0.2) for name, at in points.items()}
    pins = [Pin(name, ("ABC", name)) for name in points]
    stands = [Pin(f"{name}0", (name, GROUND)) for name in points]
    bars = [Body(name, (name, f"{name}0")) for name in points]
    plate = Body("ABC", ("A", "B", "C"))
    return hinted(Mechanism({**points, **grounds}, (plate, *bars), (*pins, *stands), ()))


def plate_of(case: Case) -> Outline:
    return next(
        part
        for part in drawing_of(case).primitives
        if isinstance(part, Outline) and part.fill == "grey"
    )


def test_a_plate_pinned_at_its_corners_is_round_about_its_pins() -> None:
    case = coupler_plate()
    outline = plate_of(case).corners
    assert len(outline) > 9
    for name in "ABC":
        gaps = [hypot(*(corner - place(case, name))) for corner in outline]
        assert min(gaps) == pytest.approx(1.9)


@pytest.mark.parametrize(("case", "corners"), [(sliding_plate(), 3), (plate_on_fixed_corners(), 4)])
def test_a_plate_of_a_stated_shape_keeps_it(case: Case, corners: int) -> None:
    assert len(plate_of(case).corners) == corners


def test_the_corners_of_a_plate_need_no_dots_and_its_middle_has_one() -> None:
    case = plate_on_fixed_corners()
    drawing = drawing_of(case)
    assert [len(circles_at(drawing, place(case, name))) for name in "DEFGO"] == [0, 0, 0, 0, 1]


def test_the_fixed_points_of_a_plate_are_black_points_and_no_hinges() -> None:
    case = plate_on_fixed_corners()
    tips = [wedge.corners[0] for wedge in black_triangles_of(case)]
    assert [any(near(tip, place(case, name)) for tip in tips) for name in "AB"] == [True, True]


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("pivot", ["A", "B"])
def test_the_teeth_of_a_jaw_and_the_fixed_jaw_are_away_from_what_moves_it(
    side: float, pivot: str
) -> None:
    """The fixed jaw is nearest to the end of the moving one that is not pinned to the ground."""
    points = {"A": Vector(0.0, 0.5), "B": ORIGIN, "G": RIGHT * (0.4 * side)}
    hinge = "B" if pivot == "A" else "A"
    joints = (Pin(pivot, ("jaw", GROUND)), Pin(hinge, ("jaw", "bar")))
    bodies = (Body("jaw", ("A", "B")), Body("bar", (hinge, "G")))
    drawing = drawing_of(hinted(Mechanism(points, bodies, joints, ()), shapes={"jaw": "jaw"}))
    jaw = next(
        part for part in drawing.primitives if isinstance(part, Outline) and part.fill == "grey"
    )
    levels = [corner.x * side for corner in jaw.corners]
    assert (max(levels), min(levels)) == (pytest.approx(1.75), pytest.approx(-2.65))
    axes = [part for part in drawing.primitives if isinstance(part, Strokes) and part.pen == PITCH]
    assert [set(axis) for part in axes for axis in part.lines] == [{ORIGIN, UP * 50.0}]
    wall = max(
        (
            line
            for part in drawing.primitives
            if isinstance(part, Strokes) and part.pen == FIRM
            for line in part.lines
        ),
        key=lambda line: hypot(*(line[1] - line[0])),
    )
    low, high = sorted(wall, key=lambda end: end.y)
    assert max(low.x * side, high.x * side) < min(levels)
    assert ((low.x - high.x) * side > 0) == (pivot == "A")


def test_an_extension_line_is_no_bar_beside_which_a_length_could_be_written() -> None:
    """Two distances from a corner of a plate, where the extension line of the first lies along the
    second.
    """
    points = {"D": Vector(0.0, 0.0), "E": Vector(0.5, 0.0), "G": Vector(0.0, 0.5)}
    points |= {"A": Vector(0.0, 0.2), "B": Vector(0.08, 0.0)}
    joints = (
        Slide("A", GROUND, Line(points["A"], UP), "plate"),
        Slide("B", GROUND, Line(points["B"], RIGHT), "plate"),
    )
    mechanism = Mechanism(points, (Body("plate", ("D", "E", "G")),), joints, ())
    lengths = [{"symbol": name.lower(), "from": "D", "to": name} for name in "AB"]
    drawn = sketch(*hinted(mechanism, lengths=lengths)).primitives
    fixed_points, ends = 2, 4
    assert len(list_black_triangles(drawn)) == fixed_points + ends


def test_a_point_in_the_hollow_of_a_slot_is_a_cross_not_a_dot_like_a_pin() -> None:
    points = {"O": ORIGIN, "A": polar(0.3, 60), "B": RIGHT * 0.15}
    yoke = Line(points["B"], UP)
    joints = (
        Pin("O", ("OA", GROUND)),
        Parallel("yoke", GROUND),
        Slide("B", "yoke", Line(ORIGIN, RIGHT), GROUND),
        Slide("A", "OA", yoke, "yoke"),
    )
    bodies = (Body("OA", ("O", "A")), Body("yoke", ("B",)))
    case = hinted(Mechanism(points, bodies, joints, ()))
    assert circles_at(drawing_of(case), place(case, "B")) == []

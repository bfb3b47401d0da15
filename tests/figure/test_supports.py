"""Supports look alike in all postures of a mechanism: below, unless something is in the way."""

from __future__ import annotations

import pytest
from msgspec.structs import replace
from shapely import LineString, MultiLineString, MultiPolygon, Polygon

from kinegrade.errors import TemplateError
from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.mechanism.rails import Rail, find_rails
from kinegrade.figure.mechanism.sliders import draw_ground_sliders
from kinegrade.figure.mechanism.stands import (
    choose_upright,
    draw_stands,
    draw_stands_of_sleeves,
)
from kinegrade.figure.plane import length, unit
from kinegrade.figure.scene import THIN, Outline, Strokes
from kinegrade.figure.sketch import sketch
from kinegrade.mechanics.joints import GROUND, Belt, Circle, Line, Mesh, Pin, Roll, Slide
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import FigureHints
from tests.figure.mechanisms import RIGHT, UP, follower_circle, hinted, polar

ORIGIN = Vector(0.0, 0.0)
DOWN = -UP


def anatomy_of(mechanism: Mechanism) -> Anatomy:
    """The anatomy at 100 mm per metre."""
    drawn, hints = hinted(mechanism)
    return Anatomy.of(scale_to_paper(drawn, 100.0), hints)


def uprights_of_stands(mechanism: Mechanism) -> list[Vector]:
    """The vectors from the fixed pins to the ground of their stands."""
    anatomy = anatomy_of(mechanism)
    drawn = (*draw_stands(anatomy), *draw_stands_of_sleeves(anatomy))
    stands = [part for part in drawn if isinstance(part, Outline)]
    return [(part.corners[1] + part.corners[2]) / 2 - part.corners[0] for part in stands]


def sides_of_stands(mechanism: Mechanism) -> list[Vector]:
    """The sides on which the stands of fixed pins are, in whole numbers."""
    toward = map(unit, uprights_of_stands(mechanism))
    return [Vector(float(round(side.x)), float(round(side.y))) for side in toward]


def test_a_support_where_nothing_is_fixed_is_refused() -> None:
    anatomy = replace(anatomy_of(crank(30)), hints=FigureHints(supports={"A": "up"}))
    message = "^figure.supports.A: this point is not fixed to the ground; name the point of a"
    with pytest.raises(TemplateError, match=message):
        list(draw_stands(anatomy))


def sleeve(angle: float) -> Mechanism:
    points = {"O": ORIGIN, "A": polar(0.4, angle)}
    joints = (Slide("O", GROUND, Line(ORIGIN, points["A"]), "AB"),)
    return Mechanism(points, (Body("AB", ("A",)),), joints, ())


def crank(angle: float) -> Mechanism:
    points = {"O": ORIGIN, "A": polar(0.3, angle)}
    return Mechanism(points, (Body("OA", ("O", "A")),), (Pin("O", ("OA", GROUND)),), ())


@pytest.mark.parametrize("angle", [0, 60, 135, 180, -45, -135])
def test_a_stand_is_below_a_bar_that_leaves_it_free(angle: float) -> None:
    assert sides_of_stands(crank(angle)) == [DOWN]


@pytest.mark.parametrize("angle", [-50, -62, -70, -90, -110])
def test_a_stand_hangs_above_a_bar_that_leaves_downward(angle: float) -> None:
    assert sides_of_stands(crank(angle)) == [UP]


@pytest.mark.parametrize("angle", range(-180, 180, 15))
def test_a_stand_is_of_one_size_beside_every_bar(angle: float) -> None:
    assert list(map(length, uprights_of_stands(crank(angle)))) == [3.6]
    assert list(map(length, uprights_of_stands(sleeve(angle)))) == [6.2]


def pulleys(one: float, other: float) -> Mechanism:
    """Two pulleys of those radii with a belt."""
    points = {"O": ORIGIN, "A": RIGHT * 0.4, "B": RIGHT * 0.42, "C": RIGHT * 0.02}
    bodies = (Body("I", ("O", "C")), Body("II", ("A", "B")))
    belt = Belt("I", Circle("O", one), "II", Circle("A", other), GROUND)
    return Mechanism(points, bodies, (Pin("O", ("I", GROUND)), Pin("A", ("II", GROUND)), belt), ())


def test_the_stands_of_all_wheels_fit_into_the_smallest() -> None:
    assert list(map(length, uprights_of_stands(pulleys(0.12, 0.07)))) == [3.6, 3.6]
    assert list(map(length, uprights_of_stands(pulleys(0.12, 0.05)))) == [2.2, 2.2]


@pytest.mark.parametrize(("angle", "side"), [(180, UP), (-30, UP), (90, DOWN)])
def test_a_stand_is_where_the_author_wants_it_unless_something_is_in_the_way(
    angle: float, side: Vector
) -> None:
    anatomy = replace(anatomy_of(crank(angle)), hints=FigureHints(supports={"O": "up"}))
    (stand,) = (part for part in draw_stands(anatomy) if isinstance(part, Outline))
    upright = (stand.corners[1] + stand.corners[2]) / 2 - stand.corners[0]
    assert unit(upright) == side


@pytest.mark.parametrize(("angle", "side"), [(30, DOWN), (62, DOWN), (118, DOWN), (75, -RIGHT)])
def test_a_sleeve_turns_on_a_floor_unless_its_rod_is_nearly_upright(
    angle: float, side: Vector
) -> None:
    assert sides_of_stands(sleeve(angle)) == [side]


def test_a_stand_keeps_clear_of_a_wheel_beside_its_pin() -> None:
    points = {"O": ORIGIN, "A": Vector(0.15, -0.11)}
    bodies = (Body("OA", ("O", "A")), Body("W", ("A",)))
    joints = (Pin("O", ("OA", GROUND)), Pin("A", ("OA", "W")))
    wheel = Roll("W", Circle("A", 0.15), GROUND, Line(Vector(0.0, -0.26), RIGHT))
    assert sides_of_stands(Mechanism(points, bodies, joints, ())) == [DOWN]
    assert sides_of_stands(Mechanism(points, bodies, (*joints, wheel), ())) == [UP]


@pytest.mark.parametrize(("angle", "side"), [(60, DOWN), (-30, DOWN), (-60, UP), (-95, UP)])
def test_a_stand_does_not_hide_the_marked_centre_of_an_eccentric_disc(
    angle: float, side: Vector
) -> None:
    mechanism, _ = follower_circle(0.2, 0.05, 90 - angle)
    assert sides_of_stands(mechanism)[:1] == [side]


def test_a_stand_leaves_the_axes_at_its_pin_free() -> None:
    anatomy = anatomy_of(crank(-90))
    assert unit(choose_upright("O", anatomy)) == UP
    with_axes = replace(anatomy, hints=FigureHints(axes="origin"))
    assert unit(choose_upright("O", with_axes)) == -RIGHT


def test_the_pin_of_a_fixed_gear_has_a_stand_where_there_is_room() -> None:
    def fixed_gear(radius: float) -> Mechanism:
        points = {"O": ORIGIN, "A": Vector(0.0, radius + 0.1)}
        mesh = Mesh("W", Circle("A", 0.1), GROUND, Circle("O", radius), "arm")
        joints = (Pin("O", ("arm", GROUND)), Pin("A", ("arm", "W")), mesh)
        return Mechanism(points, (Body("arm", ("O", "A")), Body("W", ("A",))), joints, ())

    assert sides_of_stands(fixed_gear(0.2)) == [DOWN]
    assert sides_of_stands(fixed_gear(0.05)) == []


def slider(step: Vector, along: Vector = RIGHT) -> Rail:
    """The rail of a block whose rod leaves by a step to A."""
    points = {"B": ORIGIN, "A": step}
    joints = (Slide("B", "AB", Line(ORIGIN, along), GROUND),)
    (rail,) = find_rails(anatomy_of(Mechanism(points, (Body("AB", ("A", "B")),), joints, ())))
    return rail


@pytest.mark.parametrize("angle", [170, 30, 90, -165, -10])
def test_the_floor_is_below_its_block(angle: float) -> None:
    assert slider(polar(0.4, angle)).side == DOWN


@pytest.mark.parametrize("angle", [-30, -90, -150])
def test_a_block_hangs_on_its_guide_where_the_rod_leaves_downward(angle: float) -> None:
    assert slider(polar(0.4, angle)).side == UP


@pytest.mark.parametrize("angle", [160, -160])
def test_a_wall_is_on_the_side_away_from_the_rod(angle: float) -> None:
    assert slider(polar(0.4, angle), UP).side == RIGHT


@pytest.mark.parametrize("angle", [-165, -150, -120])
def test_a_floor_ends_near_where_a_rod_would_cross_it_but_not_at_the_block(angle: float) -> None:
    free, cut = slider(polar(0.4, 170)), slider(polar(0.4, angle))
    assert (free.start.x, free.end.x) == (-7.5, 7.5)
    ends = sorted(abs(end.x) for end in (cut.start, cut.end))
    assert ends[0] >= 4.5
    assert ends[1] == 7.5


def lay_through(angle: float) -> Rail:
    """The rail of a block through which a rod passes at an angle."""
    points = {"B": ORIGIN, "A": polar(0.4, angle), "C": polar(-0.4, angle)}
    joints = (Slide("B", "AC", Line(ORIGIN, RIGHT), GROUND),)
    (rail,) = find_rails(anatomy_of(Mechanism(points, (Body("AC", ("A", "B", "C")),), joints, ())))
    return rail


def list_ground(rail: Rail) -> list[LineString]:
    """The lines of the ground and the strokes of its hatching."""
    strokes = [part for part in draw_ground_sliders([rail]) if isinstance(part, Strokes)]
    return [LineString(line) for part in strokes for line in part.lines]


@pytest.mark.parametrize("angle", [70, 80, 90, 100, 110])
def test_the_floor_is_open_for_a_steep_rod_through_its_block(angle: float) -> None:
    rail = lay_through(angle)
    assert rail.side == DOWN
    assert (rail.start.x, rail.end.x) == (-7.5, 7.5)
    (white,) = (
        part
        for part in draw_ground_sliders([rail])
        if isinstance(part, Outline) and part.pen is None and part.fill == "white"
    )
    gap = [abs((corner - ORIGIN).cross(polar(1.0, angle))) for corner in white.corners]
    assert min(gap) == pytest.approx(max(gap)) == pytest.approx(1.2)
    assert min(corner.y for corner in white.corners) < rail.start.y - 1.4


@pytest.mark.parametrize("angle", [70, 80, 90, 100, 110])
def test_a_stroke_that_the_opening_of_a_floor_would_cut_is_left_out_whole(angle: float) -> None:
    hatching, _, white, _ = draw_ground_sliders([lay_through(angle)])
    assert isinstance(hatching, Strokes)
    assert isinstance(white, Outline)
    strokes = [LineString(stroke) for stroke in hatching.lines]
    assert strokes
    assert [stroke for stroke in strokes if not Polygon(white.corners).disjoint(stroke)] == []


SLANTED = (10, 15, 20, 25, 30, 45, 55, 125, 135, 150, 160, 170)


def see_ground(rail: Rail) -> MultiLineString:
    """What is seen of the lines of the ground."""
    walls = [line for line in list_ground(rail) if line.length > 2.5]
    whites = [
        Polygon(part.corners)
        for part in draw_ground_sliders([rail])
        if isinstance(part, Outline) and part.pen is None
    ]
    return MultiLineString(walls).difference(MultiPolygon(whites))


@pytest.mark.parametrize("angle", SLANTED)
def test_the_guide_of_a_block_is_alike_on_both_sides_of_a_slanted_rod_through_it(
    angle: float,
) -> None:
    ground = see_ground(lay_through(angle))
    left, bottom, right, top = ground.bounds
    assert (left, bottom) == pytest.approx((-right, -top))
    floor, ceiling = (line for line in list_ground(lay_through(angle)) if line.length > 2.5)
    assert sorted(floor.coords.xy[0]) == pytest.approx(sorted(ceiling.coords.xy[0]))


@pytest.mark.parametrize("angle", SLANTED)
def test_the_guide_of_a_block_is_clear_of_a_slanted_rod_through_it(angle: float) -> None:
    rod = LineString([polar(-20.0, angle), polar(20.0, angle)]).buffer(0.4)
    assert see_ground(lay_through(angle)).distance(rod) > 0.75


@pytest.mark.parametrize("angle", range(10, 175, 5))
def test_the_ground_is_seen_on_both_sides_of_a_block_through_which_a_rod_passes(
    angle: float,
) -> None:
    rail = lay_through(angle)
    assert rail.block is not None
    left, _, right, _ = see_ground(rail).bounds
    assert min(-left, right) >= 0.75 * rail.block.length / 2


@pytest.mark.parametrize(("through", "use"), [(True, "link"), (False, "slot"), (False, "link")])
def test_a_block_is_seen_around_what_is_pinned_to_it(through: bool, use: str) -> None:
    points = {"B": ORIGIN, "A": UP * 0.4, "C": -UP * 0.2 if through else UP * 0.2, "D": RIGHT * 0.2}
    joints = [Slide("B", "AC", Line(ORIGIN, RIGHT), GROUND)]
    if use == "slot":
        joints.append(Slide("C", "CD", Line(ORIGIN, UP), "AC"))
    bodies = (Body("AC", ("A", "B", "C") if through else ("A", "B")), Body("CD", ("C", "D")))
    anatomy = anatomy_of(Mechanism(points, bodies, tuple(joints), ()))
    (rail,) = find_rails(anatomy)
    assert rail.block is not None
    assert (rail.block.width > 4.0) == (through or use == "slot")
    assert (rail.block.length > 6.0) == (use == "slot")
    assert rail.level > rail.block.width / 2


@pytest.mark.parametrize(
    ("away", "level", "end"), [(0.1, 0.0, 5.8), (0.1, 0.07, 7.5), (0.2, 0.0, 7.5)]
)
def test_a_floor_ends_before_the_stand_of_a_pin(away: float, level: float, end: float) -> None:
    points = {"B": ORIGIN, "A": Vector(-0.3, 0.1), "O": Vector(away, level)}
    points["C"] = points["O"] + UP * 0.3
    joints = (Slide("B", "AB", Line(ORIGIN, RIGHT), GROUND), Pin("O", ("OC", GROUND)))
    bodies = (Body("AB", ("A", "B")), Body("OC", ("O", "C")))
    (rail,) = find_rails(anatomy_of(Mechanism(points, bodies, joints, ())))
    assert (rail.start.x, rail.end.x) == (-7.5, pytest.approx(end))


def trammel(a: Vector, b: Vector, *names: str, shape: str = "bare") -> tuple[Rail, ...]:
    """The rails of a rod AB on the floor and at the wall, with these points at the corner."""
    points = {"A": a, "B": b, **dict.fromkeys(names, ORIGIN)}
    joints = (
        Slide("A", "AB", Line(ORIGIN, RIGHT), GROUND),
        Slide("B", "AB", Line(ORIGIN, UP), GROUND),
    )
    mechanism = Mechanism(points, (Body("AB", ("A", "B")),), joints, ())
    drawn, hints = hinted(mechanism, shapes={"AB": shape} if shape else {})
    return find_rails(Anatomy.of(scale_to_paper(drawn, 100.0), hints))


def test_the_grounds_of_bare_ends_meet_in_a_corner_at_a_marked_point() -> None:
    floor, wall = trammel(Vector(0.4, 0.0), Vector(0.0, 0.3), "O")
    assert floor.start == wall.start == ORIGIN


def test_the_guides_of_blocks_cross_without_a_corner() -> None:
    floor, wall = trammel(Vector(0.4, 0.0), Vector(0.0, 0.3), "O", shape="")
    assert floor.start.x == pytest.approx(32.5)
    assert wall.start.y == pytest.approx(22.5)


@pytest.mark.parametrize(("shapes", "blocks", "reach"), [({}, 2, 1.7), ({"AB": "bare"}, 0, 0.0)])
def test_a_bare_end_slides_on_the_ground_itself(
    shapes: dict[str, str], blocks: int, reach: float
) -> None:
    points = {"A": Vector(0.4, 0.0), "B": Vector(0.0, 0.3)}
    joints = (
        Slide("A", "AB", Line(ORIGIN, RIGHT), GROUND),
        Slide("B", "AB", Line(ORIGIN, UP), GROUND),
    )
    trammel = Mechanism(points, (Body("AB", ("A", "B")),), joints, ())
    drawn, hints = hinted(trammel, shapes=shapes)
    anatomy = Anatomy.of(scale_to_paper(drawn, 100.0), hints)
    floor, _ = rails = find_rails(anatomy)
    assert -floor.start.y == pytest.approx(reach)
    drawings = draw_ground_sliders(rails)
    assert sum(isinstance(part, Outline) for part in drawings) == blocks


def test_guides_that_meet_at_no_marked_point_stay_apart() -> None:
    floor, wall = trammel(Vector(0.4, 0.0), Vector(0.0, 0.3))
    assert length(floor.start - wall.start) > 10


def test_guides_that_run_on_beyond_their_crossing_have_no_corner() -> None:
    floor, wall = trammel(Vector(0.03, 0.0), Vector(0.0, 0.3), "O")
    assert length(floor.start - wall.start) > 3


def test_the_lines_of_a_dimension_begin_outside_the_stands_of_its_points() -> None:
    points = {"O": ORIGIN, "C": RIGHT * 0.4, "A": Vector(0.1, 0.3), "B": Vector(0.5, 0.3)}
    names = {"OA": ("O", "A"), "AB": ("A", "B"), "CB": ("C", "B")}
    joints = (
        Pin("O", ("OA", GROUND)),
        Pin("C", ("CB", GROUND)),
        Pin("A", ("OA", "AB")),
        Pin("B", ("AB", "CB")),
    )
    bodies = tuple(Body(name, own) for name, own in names.items())
    distance = {"symbol": "d", "from": "O", "to": "C"}
    mechanism, hints = hinted(Mechanism(points, bodies, joints, ()), lengths=[distance])
    primitives = sketch(mechanism, hints).primitives
    stands = [part for part in primitives if isinstance(part, Outline) and part.fill == "white"]
    base = min(corner.y for stand in stands for corner in stand.corners)
    (level,) = {
        part.corners[0].y
        for part in primitives
        if isinstance(part, Outline) and part.fill == "black"
    }
    upright = [
        line
        for part in primitives
        if isinstance(part, Strokes) and part.pen == THIN
        for line in part.lines
        if abs(line[0].x - line[1].x) < 1e-9 and min(line[0].y, line[1].y) < level
    ]
    assert len(upright) == 2
    assert level < base - 1.2
    assert [(start, end) for start, end in upright if not max(start.y, end.y) < base - 1.0] == []

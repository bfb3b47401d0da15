"""Frames of reference, and measures that may be negative: where they stand and which way they
point.
"""

from __future__ import annotations

from dataclasses import replace
from math import hypot

import pytest
from shapely import LineString, Point, Polygon

from kinegrade.figure.marks.frames import add_axes_aside, add_frames
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.obstacles import Obstacles
from kinegrade.figure.plane import length, nearest_of, unit
from kinegrade.figure.scene import BOLD, FIRM, THIN, Bow, Disc, Label, Outline, Scene, Strokes
from kinegrade.figure.sketch import sketch
from kinegrade.figure.symbols.arrows import HEAD_LENGTH
from kinegrade.figure.symbols.pins import PIN
from kinegrade.mechanics.joints import GROUND, Line, Slide
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Angle, Axes, BodyFrame, FigureHints, Length
from tests.figure.clear import faults, heads, lines
from tests.figure.guided_mechanisms import sliding_plate
from tests.figure.mechanisms import RIGHT, UP, follower_circle, slider_crank

EMPTY = Drawing((), (), (), (), (), ())


def draw_crank(phi: float = 60, **marks: object) -> Scene:
    """The slider-crank with these marks only."""
    mechanism, _ = slider_crank(0.2, 1.75, phi)
    return sketch(mechanism, replace(FigureHints(), **marks))  # type: ignore[arg-type]


def list_directions(scene: Scene) -> list[Vector]:
    """The unit vectors of the arrowheads, in the order in which they are drawn."""
    found = []
    for head in heads(scene):
        tip, left, right = head.corners
        step = tip - (left + right) / 2
        found.append(step / step.squared() ** 0.5)
    return found


@pytest.mark.parametrize("axes", ["origin", "aside"])
def test_axes_point_to_the_right_and_upwards(axes: Axes) -> None:
    scene = draw_crank(axes=axes)
    right, up = list_directions(scene)
    assert (right.x, up.y) == (pytest.approx(1.0), pytest.approx(1.0))
    assert {"x", "y"} <= {label.symbol for label in scene.labels}
    assert faults(scene, 80, 60) == []


def list_pins(scene: Scene) -> list[Vector]:
    return [part.centre for part in scene.primitives if isinstance(part, Disc)]


def test_axes_stand_at_the_origin_or_apart_from_everything() -> None:
    at_origin, aside = (draw_crank(axes=axes) for axes in ("origin", "aside"))
    right, up = (head.corners[0] for head in heads(at_origin))
    assert min(hypot(pin.x - up.x, pin.y - right.y) for pin in list_pins(at_origin)) < 1e-6
    right, up = (head.corners[0] for head in heads(aside))
    assert min(hypot(pin.x - up.x, pin.y - right.y) for pin in list_pins(aside)) > 8.0


@pytest.mark.parametrize(("along", "x", "y"), [("x", 1.0, 1.0), ("y", -1.0, 1.0)])
def test_the_frame_of_a_body_has_y_a_quarter_turn_after_x(along: str, x: float, y: float) -> None:
    frame = BodyFrame("x_1", "y_1", "A", "O", "A", along)  # type: ignore[arg-type]
    first, second = list_directions(draw_crank(frames=(frame,)))
    assert first.turned().dot(second) == pytest.approx(1.0)
    named = first if along == "x" else second
    assert (named.x, named.y) == (pytest.approx(0.5), pytest.approx(3**0.5 / 2))


@pytest.mark.parametrize("origin", ["O", "A"])
def test_an_axis_along_a_long_link_runs_through_it_from_its_origin_and_beyond(origin: str) -> None:
    far = "A" if origin == "O" else "O"
    mechanism, _ = slider_crank(1.0, 1.75, 60)
    frame = BodyFrame("x_1", "y_1", origin, origin, far)
    scene = sketch(mechanism, FigureHints(frames=(frame,)))
    toward = unit(mechanism.points[far] - mechanism.points[origin])
    first, second = (head.corners[0] for head in heads(scene))
    link = find_link(scene)
    lines = [line for part in scene.primitives if isinstance(part, Strokes) for line in part.lines]
    along = [end - start for start, end in lines if link.contains(Point((start + end) * 0.5))]
    assert any(abs(way.cross(toward)) < 1e-6 and way.dot(toward) > 19.0 for way in along), along
    assert not link.contains(Point(first))
    assert (first - second).dot(toward) > 19.0
    (letter,) = (label for label in scene.labels if label.symbol == "x_1")
    assert not link.intersects(Point(letter.centre).buffer(1.0))


def test_the_length_of_a_broad_link_stands_beside_it() -> None:
    mechanism, _ = slider_crank(1.0, 1.75, 60)
    frame, measured = BodyFrame("x_1", "y_1", "O", "O", "A"), Length("r", "O", "A")
    scene = sketch(mechanism, FigureHints(frames=(frame,), lengths=(measured,)))
    (letter,) = (label for label in scene.labels if label.symbol == "r")
    assert 1.0 < find_link(scene).distance(Point(letter.centre)) < 3.0
    assert len(heads(scene)) == 2


def find_link(scene: Scene) -> Polygon:
    """The only broad link of a figure."""
    (link,) = (
        each for each in scene.primitives if isinstance(each, Outline) and each.fill == "grey"
    )
    return Polygon(link.corners)


def nearest_end(line: tuple[Vector, Vector], at: Vector) -> Vector:
    return min(line, key=lambda end: length(end - at))


def test_an_axis_along_a_short_bar_ends_beyond_it_and_does_not_cross_the_pin_there() -> None:
    mechanism, _ = slider_crank(0.2, 4.0, 60)
    scene = sketch(mechanism, FigureHints(frames=(BodyFrame("x_1", "y_1", "O", "O", "A"),)))
    tip, crank = heads(scene)[0].corners[0], lines(scene, BOLD)[0]
    along = (crank[1] - crank[0]) / hypot(*(crank[1] - crank[0]))
    assert abs(along.cross(tip - crank[0])) < 1e-6
    assert (tip - crank[1]).dot(along) == pytest.approx(6.0)
    nearest = min(hypot(*(nearest_of(crank[1], *line) - crank[1])) for line in lines(scene, THIN))
    assert nearest > 0.8


def test_an_axis_along_bare_ground_runs_on_beyond_it() -> None:
    points = {"O": Vector(0.0, 0.0), "A": Vector(0.4, 0.0), "B": Vector(0.0, 0.3)}
    joints = (
        Slide("A", "AB", Line(points["O"], RIGHT), GROUND),
        Slide("B", "AB", Line(points["O"], UP), GROUND),
    )
    rod = Mechanism(points, (Body("AB", ("A", "B")),), joints, ())
    scene = sketch(rod, FigureHints(shapes={"AB": "bare"}, axes="origin", labels={"O": "O"}))
    (floor,) = (line for line in lines(scene, FIRM) if line[0].y == line[1].y)
    tip = heads(scene)[0].corners[0]
    assert tip.y == pytest.approx(floor[1].y)
    assert tip.x - max(floor[0].x, floor[1].x) == pytest.approx(6.0)


def test_an_axis_that_is_the_leg_of_an_angle_reaches_beyond_its_arc() -> None:
    frame = BodyFrame("x_1", "y_1", "A", "O", "A")
    mechanism, _ = slider_crank(0.2, 1.75, 15)
    beyond = {**mechanism.points, "X": mechanism.points["A"] * 1.2}
    angle = Angle(r"\varphi", "A", "right", "X")
    scene = sketch(
        replace(mechanism, points=beyond),
        FigureHints(frames=(frame,), angles=(angle,), labels={"X": None}),
    )
    (arc,) = (part for part in scene.primitives if isinstance(part, Bow) and part.pen == THIN)
    tip = heads(scene)[0].corners[0]
    assert hypot(*(tip - arc.centre)) > arc.radius + 1.0


@pytest.mark.parametrize(
    ("start", "end", "symbol"), [("O", "A", "x_A"), ("A", "O", r"\left|x_A\right|")]
)
def test_a_negative_coordinate_is_dimensioned_by_its_size(
    start: str, end: str, symbol: str
) -> None:
    length = Length("x_A", start, end, "horizontal", signed=True)
    assert symbol in {label.symbol for label in draw_crank(lengths=(length,)).labels}


@pytest.mark.parametrize("phi", [40.0, -40.0])
def test_the_arc_of_a_signed_angle_has_an_arrowhead_at_its_end(phi: float) -> None:
    angle = Angle(r"\varphi", "O", "right", "A", signed=True)
    scene = draw_crank(phi, angles=(angle,))
    (head,) = heads(scene)
    (arc,) = (part for part in scene.primitives if isinstance(part, Bow) and part.pen == THIN)
    assert (arc.sweep > 0) == (phi > 0)
    assert head.corners[0] == pytest.approx(arc.path()[-1])
    assert heads(draw_crank(phi, angles=(replace(angle, signed=False),))) == []


def test_an_axis_along_the_edge_of_a_plate_lies_with_its_letter_within_a_firm_outline() -> None:
    frames = (BodyFrame("x_2", "y_2", "B", "B", "C"),)
    edge = Length("l", "B", "C")
    scene = sketch(sliding_plate()[0], FigureHints(frames=frames, lengths=(edge,)))
    plate = next(
        part for part in scene.primitives if isinstance(part, Outline) and part.fill == "grey"
    )
    assert plate.pen == FIRM
    tip, area = Point(heads(scene)[0].corners[0]), Polygon(plate.corners)
    assert area.contains(tip)
    assert area.boundary.distance(tip) > 1.0
    letters = {label.symbol: Point(label.centre) for label in scene.labels}
    assert area.contains(letters["x_2"])
    assert tip.distance(letters["x_2"]) < 5.0
    assert not area.contains(letters["l"])  # the edge from corner to corner, not a part of it


def test_an_axis_along_the_edge_of_a_plate_has_a_shaft_and_a_tip_of_its_own() -> None:
    mechanism, _ = sliding_plate()
    frames = (BodyFrame("x_2", "y_2", "B", "B", "C"), BodyFrame("x_3", "y_3", "C", "C", "B"))
    scene = sketch(mechanism, FigureHints(frames=frames))
    firm = [LineString(line) for line in lines(scene, FIRM)]
    outlines = [part for part in scene.primitives if isinstance(part, Outline) and part.pen == FIRM]
    firm += [LineString((*part.corners, part.corners[0])) for part in outlines if part.closed]
    points = mechanism.points
    toward = unit(points["C"] - points["B"])
    on_edge = [
        head.corners[0]
        for head in heads(scene)
        if abs(unit(head.corners[0] - (head.corners[1] + head.corners[2]) / 2).cross(toward)) < 0.01
    ]
    assert len(on_edge) == 2
    for tip in on_edge:
        assert min(line.distance(Point(tip)) for line in firm) > 0.8


@pytest.mark.parametrize(("corner", "gap"), [("A", 0.0), ("B", PIN)])
def test_an_axis_starts_at_a_corner_that_is_no_pin(corner: str, gap: float) -> None:
    frame = BodyFrame("x_1", "y_1", corner, "C", corner)
    scene = sketch(sliding_plate()[0], FigureHints(frames=(frame,)))
    tip = heads(scene)[0].corners[0]
    shafts = [
        line
        for part in scene.primitives
        if isinstance(part, Strokes) and part.pen == THIN
        for line in part.lines
        if length(line[1] - tip) < HEAD_LENGTH
    ]
    gaps = [
        length(shafts[0][0] - corner)
        for part in scene.primitives
        if isinstance(part, Outline) and part.fill == "grey"
        for corner in part.corners
    ]
    assert min(gaps) == pytest.approx(gap)


def test_an_axis_to_a_block_on_a_line_runs_on_beyond_the_block() -> None:
    mechanism, _ = slider_crank(0.2, 1.75, 60)
    plain = sketch(mechanism, FigureHints(axes="origin"))
    lined = sketch(mechanism, FigureHints(axes="origin", lines=(("O", "B"),)))
    for scene, beyond in ((plain, False), (lined, True)):
        tip, block = heads(scene)[0].corners[0], list_blocks(scene)[0]
        assert (tip.x > max(corner.x for corner in block.corners)) == beyond


def list_blocks(scene: Scene) -> list[Outline]:
    return [
        part
        for part in scene.primitives
        if isinstance(part, Outline) and part.fill == "white" and len(part.corners) == 4
    ]


def test_an_axis_ends_before_the_plate_of_a_follower() -> None:
    mechanism, _ = follower_circle(0.2, 0.05, 30)
    scene = sketch(mechanism, FigureHints(axes="origin"))
    tip = heads(scene)[-1].corners[0]
    faces = [
        line
        for part in scene.primitives
        if isinstance(part, Strokes) and part.pen == BOLD
        for line in part.lines
        if abs(line[0].y - line[1].y) < 0.01
    ]
    assert tip.y < min(start.y for start, _ in faces)


def test_two_axes_along_one_edge_each_end_nearer_to_their_own_origin() -> None:
    mechanism, _ = sliding_plate()
    frames = (BodyFrame("x_2", "y_2", "B", "B", "C"), BodyFrame("x_3", "y_3", "C", "C", "B"))
    scene = sketch(mechanism, FigureHints(frames=frames))
    (first, _, second, _) = (head.corners[0] for head in heads(scene))
    at = {label.symbol: label.centre for label in scene.labels}
    assert length(first - at["B"]) < length(first - at["C"])
    assert length(second - at["C"]) < length(second - at["B"])


def test_the_letter_of_an_axis_keeps_clear_of_a_line_that_is_still_to_come() -> None:
    at = {"A": Vector(0.0, 0.0), "B": Vector(20.0, 5.0)}
    hints = FigureHints(frames=(BodyFrame("x_1", "y_1", "A", "A", "B"),))
    leg = Strokes(((at["A"], at["B"]),), THIN)
    letters = {}
    for sparing in ((), (leg,)):
        layout = add_frames(Layout.of(()), at, hints, EMPTY, sparing)
        letters[sparing] = next(label for label in layout.labels if label.symbol == "x_1")
    drawn = Obstacles.of((leg,))
    covered = [drawn.under_box(*each.centre, each.width, each.height) for each in letters.values()]
    assert covered[0] > 0
    assert covered[1] == 0


def test_axes_aside_keep_clear_of_a_letter_at_the_edge_of_a_full_figure() -> None:
    full = [
        Strokes(((Vector(4.0, y), Vector(60.0, y)),), FIRM) for y in map(float, range(0, 60, 4))
    ]
    letter = Label("R", Vector(1.5, 1.5), 3.0, 3.0)
    layout = add_axes_aside(Layout.of([*full, letter]), FigureHints(axes="aside"))
    [name] = [label for label in layout.labels if label.symbol == "x"]
    [tip, _] = [part.corners[0] for part in layout.lines if isinstance(part, Outline)]
    assert max(tip.x, name.centre.x + name.width / 2) < -1.0


def test_an_axis_is_short_where_a_bar_stands_farther_along_it() -> None:
    stem = Strokes(((Vector(0.0, 10.5), Vector(0.0, 60.0)),), BOLD)
    hints = FigureHints(axes="origin")
    layout = add_frames(Layout.of([stem]), {}, hints, EMPTY, ())
    assert max(part.corners[0].y for part in layout.lines if isinstance(part, Outline)) < 9.0


def test_an_axis_reaches_beyond_the_arrow_of_a_motion_that_lies_on_it() -> None:
    hints = FigureHints(axes="origin")
    motion = (RIGHT * 8.0, RIGHT * 18.0)
    layout = add_frames(Layout.of(()), {}, hints, EMPTY, (), likely=(motion,))
    tips = [part.corners[0] for part in layout.lines if isinstance(part, Outline)]
    assert [max(tip.x for tip in tips) > 22.0, max(tip.y for tip in tips) < 15.0] == [True, True]


@pytest.mark.parametrize("far", [0.1, 2.0])
def test_an_axis_reaches_beyond_the_point_that_gives_the_side_of_an_angle(far: float) -> None:
    mechanism, _ = sliding_plate()
    points = {**mechanism.points, "X": mechanism.points["A"] + Vector(far, 0.0)}
    hints = FigureHints(
        frames=(BodyFrame("x_1", "y_1", "A", "A", "X"),),
        angles=(Angle("u", "A", "up", "X"),),
    )
    scene = sketch(replace(mechanism, points=points), hints)
    thin = [part for part in scene.primitives if isinstance(part, Strokes) and part.pen == THIN]
    level = [line for part in thin for line in part.lines if abs(line[0].y - line[1].y) < 1e-6]
    tip = max(corner.x for head in heads(scene) for corner in head.corners)
    assert max(end.x for line in level for end in line) < tip

"""The arrows of a point whose own rod, or the ground, lies along its motion."""

from __future__ import annotations

import pytest
from shapely import LineString, Point

from kinegrade.figure.scene import FIRM, THIN, Disc, Label, Scene, Strokes
from kinegrade.figure.sketch import sketch
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.printed_givens import mark_question
from tests.figure.clear import heads
from tests.figures.sheet import deal

SEEDS = ("rod-1", "rod-2", "rod-3", "rod-4", "rod-5", "rod-6", "rod-7", "rod-8")
AT_PIN, ON_DOT = 1.3, 1.0  # millimetres between a point and the tail that is seen at it


def draw(template: str, seed: str) -> Scene:
    solution = deal(template, seed)
    mechanism = solution.motion.frames.mechanism.map(float)
    return sketch(mechanism, mark_question(solution.template, solution.template.asked()))


def find_shaft(scene: Scene, symbol: str) -> LineString:
    """The shaft nearest to a symbol that has a head at its end."""
    [label] = [each for each in scene.labels if each.symbol == symbol]
    shafts = [
        LineString([part.lines[0][0], part.lines[0][1]])
        for part in scene.primitives
        if isinstance(part, Strokes) and part.pen == FIRM and len(part.lines) == 1
    ]
    necks = [_find_neck(head.corners) for head in heads(scene)]
    headed = [line for line in shafts if any(line.distance(neck) < 0.5 for neck in necks)]
    return min(headed, key=Point(label.centre).distance)


def _find_neck(corners: tuple[Vector, ...]) -> Point:
    return Point((corners[1] + corners[2]) / 2)


def measure_off(label: Label, line: LineString) -> float:
    """How far above a level line a symbol stands."""
    return label.centre.y - line.coords[0][1]


@pytest.mark.parametrize("seed", SEEDS)
def test_arrows_begin_at_the_pin_from_which_a_rod_leaves_in_their_direction(seed: str) -> None:
    scene = draw("slotted-bar-between-two-rods", seed)
    pins = [part.centre for part in scene.primitives if isinstance(part, Disc)]
    for symbol in ("v_{A}", "a_{A}"):
        tail = Point(find_shaft(scene, symbol).coords[0])
        assert min(tail.distance(Point(pin)) for pin in pins) < AT_PIN


@pytest.mark.parametrize("seed", SEEDS)
def test_arrows_on_the_ground_begin_on_their_dot_with_their_symbols_above(seed: str) -> None:
    scene = draw("rod-ground-and-incline", seed)
    dots = [part.centre for part in scene.primitives if isinstance(part, Disc)]
    dot = min(dots, key=lambda at: at.y)
    arcs = [label for label in scene.labels if label.symbol == r"\theta"]
    assert arcs
    assert find_shaft(scene, "v_{A}").distance(Point(dot)) < ON_DOT
    for symbol in ("v_{A}", "a_{A}"):
        shaft = find_shaft(scene, symbol)
        [label] = [each for each in scene.labels if each.symbol == symbol]
        assert 0 < measure_off(label, shaft) < 3.5
        assert [
            arc for arc in arcs if not abs(label.centre.x - dot.x) < abs(arc.centre.x - dot.x)
        ] == []


@pytest.mark.parametrize(
    ("template", "seed", "symbol"),
    [
        ("two-wheels-on-cylinder", "v71a", "v_{A}"),
        ("toggle-press", "w81a", "v"),
    ],
)
def test_an_arrow_begins_at_the_centre_of_its_wheel_and_beside_a_short_rod(
    template: str, seed: str, symbol: str
) -> None:
    # one stood at a point of the rolling wheel that moves otherwise, one above the rod on a stalk
    scene = draw(template, seed)
    pins = [part.centre for part in scene.primitives if isinstance(part, Disc)]
    tail = Point(find_shaft(scene, symbol).coords[0])
    assert min(tail.distance(Point(pin)) for pin in pins) < AT_PIN


@pytest.mark.parametrize("seed", ["v71b", *SEEDS[:4]])
def test_an_arrow_ends_at_no_axis_and_its_symbol_is_on_its_side_of_the_floor(seed: str) -> None:
    # one ended at the y axis, as the dimension of OA would, and a symbol stood below the hatching
    scene = draw("elliptic-trammel-end-driven", seed)
    [name] = [label.centre for label in scene.labels if label.symbol == "A"]
    floor = find_floor(scene)
    for symbol in ("v_{A}", "a_{A}"):
        shaft = find_shaft(scene, symbol)
        [label] = [each for each in scene.labels if each.symbol == symbol]
        beside = label.centre.x - label.width / 2, label.centre.x + label.width / 2
        assert label.centre.y > floor[0].y or beside[1] < floor[0].x or beside[0] > floor[1].x
        for line in list_upright_lines(scene):
            assert shaft.distance(line) > 1.0 or abs(line.coords[0][0] - name.x) < 5.0


def find_floor(scene: Scene) -> tuple[Vector, Vector]:
    """The lowest firm level line of some length, from left to right."""
    lines = [part.lines[0] for part in scene.primitives if isinstance(part, Strokes)]
    level = [(start, end) for start, end in lines if start.y == end.y and abs(end.x - start.x) > 9]
    start, end = min(level, key=lambda line: line[0].y)
    return (start, end) if start.x < end.x else (end, start)


def list_upright_lines(scene: Scene) -> list[LineString]:
    """The thin lines that stand upright."""
    thin = [part for part in scene.primitives if isinstance(part, Strokes) and part.pen == THIN]
    lines = [line for part in thin for line in part.lines]
    return [LineString(line) for line in lines if abs(line[0].x - line[1].x) < 1e-6]

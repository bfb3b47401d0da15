"""A body that is a wheel and reaches beyond its rim: bars lead from the wheel to the points outside
it, rigid with it; no point of a body hangs in the air.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest
from shapely import LineString, Point, Polygon
from shapely.geometry.base import BaseGeometry

from kinegrade.errors import MechanismError
from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.mechanism.plates import Plate
from kinegrade.figure.mechanism.straight_parts import Bar, GenevaWheel, Rod, SlottedDisc
from kinegrade.figure.mechanism.wheels.outlines import trace_outlines
from kinegrade.figure.plane import length
from kinegrade.figure.scene import BOLD, Disc, Outline
from kinegrade.mechanics.joints import (
    GROUND,
    Belt,
    Circle,
    Line,
    Mesh,
    Parallel,
    Pin,
    Roll,
    Slide,
)
from kinegrade.mechanics.mechanism import Body, Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.library.library import find_template_names
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.template import Template
from tests.figure.mechanisms import RIGHT, UP, Case, hinted, polar
from tests.figure.test_bodies import bold_line_to, drawing_of, layer, list_black_triangles, place
from tests.figure.test_shipped_supports import draw_anatomy
from tests.laws.cases import shipped

ORIGIN = Vector(0.0, 0.0)
AUTHORED = sorted((Path(__file__).parents[1] / "authored").glob("*.toml"))
SIGHT = 1.0  # millimetres from a part up to which a point is seen to be on it
DRAWS = 4


def geared_rod(angle: float = 130.0) -> Case:
    """The rod AB with a gear about A, on the arm OA, about a gear on the axle of the arm."""
    points = {"O": ORIGIN, "A": polar(0.25, 20)}
    points["B"] = points["A"] + polar(0.5, angle)
    points["C"] = points["B"] + RIGHT * 0.3
    joints = (
        Pin("O", ("OA", "sun", GROUND)),
        Pin("A", ("OA", "AB")),
        Pin("B", ("AB", "BC")),
        Pin("C", ("BC", GROUND)),
        Mesh("AB", Circle("A", 0.1), "sun", Circle("O", 0.15), "OA"),
    )
    bodies = (
        Body("OA", ("O", "A")),
        Body("AB", ("A", "B")),
        Body("BC", ("B", "C")),
        Body("sun", ("O",)),
    )
    return hinted(Mechanism(points, bodies, joints, ()))


def pulley_with_forearm() -> Case:
    """The forearm AB welded to the second of two pulleys, whose arm is OA."""
    points = {"O": ORIGIN, "A": RIGHT * 0.5, "B": RIGHT * 0.5 + UP * 0.3}
    joints = (
        Pin("O", ("OA", GROUND)),
        Pin("A", ("OA", "AB")),
        Belt("AB", Circle("A", 0.1), GROUND, Circle("O", 0.15), "OA"),
    )
    bodies = (Body("OA", ("O", "A")), Body("AB", ("A", "B")))
    return hinted(Mechanism(points, bodies, joints, ()))


def wheel_with(*offsets: Vector, shapes: dict[str, str] | None = None) -> Case:
    """A wheel that rolls on the ground, with points at these places from its centre A."""
    names = [f"B{number}" for number, _ in enumerate(offsets)]
    points = {"A": ORIGIN, **dict(zip(names, offsets, strict=True))}
    joints = (Roll("wheel", Circle("A", 0.1), GROUND, Line(UP * -0.1, RIGHT)),)
    bodies = (Body("wheel", ("A", *names)),)
    return hinted(Mechanism(points, bodies, joints, ()), shapes=shapes or {})


def eccentric_with_lever() -> Case:
    """A disc about C that turns about O, with a lever OB; a follower runs on it."""
    points = {"O": ORIGIN, "C": RIGHT * 0.05, "B": UP * 0.4, "F": RIGHT * 0.05 - UP * 0.12}
    joints = (
        Pin("O", ("disc", GROUND)),
        Parallel("follower", GROUND),
        Slide("F", "follower", Line(points["F"], UP), GROUND),
        Roll("disc", Circle("C", 0.12), "follower", Line(points["F"], RIGHT)),
    )
    bodies = (Body("disc", ("O", "C", "B")), Body("follower", ("F",)))
    return hinted(Mechanism(points, bodies, joints, ()))


@pytest.mark.parametrize(
    ("case", "body"),
    [(geared_rod(), "AB"), (geared_rod(-20.0), "AB"), (pulley_with_forearm(), "AB")],
)
def test_a_bar_leads_from_the_centre_of_a_wheel_to_a_point_outside_it(
    case: Case, body: str
) -> None:
    drawing = drawing_of(case)
    bar = bold_line_to(drawing, place(case, "B"))
    assert min(length(end - place(case, "A")) for end in bar.lines[0]) < 1e-6
    (part,) = [part for part in drawing.parts if part.body == body]
    assert isinstance(part, Bar)
    (pin,) = [disc for disc in discs_at(case, "A") if disc.fill == "white"]
    rim = next(rim for rim in drawing.rims if rim.body == body)
    shown = [each for each in drawing.primitives if is_wheel(each, rim.at)]
    assert max(layer(drawing, each) for each in shown) < layer(drawing, bar) < layer(drawing, pin)


def is_wheel(part: object, at: Vector) -> bool:
    """Whether a primitive is a grey wheel or gear about that place."""
    if isinstance(part, Disc):
        return part.fill == "grey" and length(part.centre - at) < 1e-6
    if isinstance(part, Outline) and part.fill == "grey":
        middle = sum(part.corners, ORIGIN) / len(part.corners)
        return length(middle - at) < 1e-3
    return False


def discs_at(case: Case, name: str) -> list[Disc]:
    at = place(case, name)
    discs = (part for part in drawing_of(case).primitives if isinstance(part, Disc))
    return [disc for disc in discs if length(disc.centre - at) < 1e-6]


@pytest.mark.parametrize("case", [geared_rod(), pulley_with_forearm(), wheel_with(UP * 0.3)])
def test_a_neck_beneath_the_wheel_and_its_bar_tells_that_they_are_one(case: Case) -> None:
    """The teeth of a gear lie over it, so that none is hidden; a black gusset on its rim would
    hide some, and look like the head of an arrow.
    """
    drawing, centre = drawing_of(case), place(case, "A")
    rim = next(rim for rim in drawing.rims if length(rim.at - centre) < 1e-6)
    (bar,) = [part for part in drawing.parts if isinstance(part, Bar) and part.body == rim.body]
    shown = next(each for each in drawing.primitives if is_wheel(each, rim.at))
    (neck,) = [
        each
        for each in drawing.primitives
        if isinstance(each, Outline) and each.fill == "grey" and len(each.corners) == 4
    ]
    assert layer(drawing, neck) < layer(drawing, shown)
    shape, axis = Polygon(neck.corners), LineString([bar.start, bar.end])
    assert shape.intersection(Point(centre).buffer(rim.radius - 1.05)).area > 0
    assert 3.0 < shape.intersection(axis).length < axis.length - 3.0


def test_points_on_both_sides_of_a_wheel_have_one_bar_that_runs_through_it() -> None:
    case = wheel_with(UP * 0.3, UP * -0.25, UP * 0.2)
    (bar,) = [part for part in drawing_of(case).parts if isinstance(part, Bar)]
    ends = sorted((bar.start.y, bar.end.y))
    assert ends == [pytest.approx(-25.0), pytest.approx(30.0)]


def test_points_in_two_directions_have_a_bar_each_with_a_gusset_between_them() -> None:
    case = wheel_with(UP * 0.3, RIGHT * 0.25)
    drawing = drawing_of(case)
    assert len([part for part in drawing.parts if isinstance(part, Bar)]) == 2
    corners = [each.corners[0] for each in list_black_triangles(drawing.primitives)]
    assert len([at for at in corners if length(at) < 1e-6]) == 1


def test_a_bent_rod_on_a_wheel_leads_through_its_points_in_order() -> None:
    case = wheel_with(UP * 0.3, UP * 0.3 + RIGHT * 0.2, shapes={"wheel": "bent"})
    bars = [part for part in drawing_of(case).parts if isinstance(part, Bar)]
    assert [(bar.start, bar.end) for bar in bars] == [
        (ORIGIN, UP * 30.0),
        (UP * 30.0, UP * 30.0 + RIGHT * 20.0),
    ]


@pytest.mark.parametrize(("shape", "use"), [("bar", "bar"), ("bare", "slot")])
def test_what_slides_on_a_wheel_outside_its_rim_has_a_bar_to_slide_on(shape: str, use: str) -> None:
    """A block on the lever of a rolling wheel hung in the air."""
    mechanism, _ = wheel_with(UP * 0.4)
    points = {**mechanism.points, "P": UP * 0.3, "Q": UP * 0.3 + RIGHT * 0.3}
    slide = Slide("P", "PQ", Line(ORIGIN, UP), "wheel")
    joints = (*mechanism.joints, slide, Pin("Q", ("PQ", GROUND)))
    bodies = (*mechanism.bodies, Body("PQ", ("P", "Q")))
    case = hinted(Mechanism(points, bodies, joints, ()), shapes={"wheel": shape})
    anatomy = Anatomy.of(scale_to_paper(case[0], 100.0), case[1])
    assert len(anatomy.necks) == (use == "bar")  # one would be seen through a slot
    (bar,) = [part for part in anatomy.parts if part.body == "wheel"]
    assert isinstance(bar, Bar)
    assert (bar.use, bar.start, bar.end) == (use, ORIGIN, UP * 40.0)


@pytest.mark.parametrize("share", [0.3, 0.99, 1.0])
def test_points_on_a_wheel_and_on_its_rim_have_no_bar(share: float) -> None:
    drawing = drawing_of(wheel_with(polar(0.1 * share, 35)))
    assert [part for part in drawing.parts if isinstance(part, Bar)] == []


def test_a_lever_of_an_eccentric_disc_begins_at_its_pivot() -> None:
    (bar,) = [part for part in drawing_of(eccentric_with_lever()).parts if part.body == "disc"]
    assert isinstance(bar, Bar)
    assert {bar.start, bar.end} == {ORIGIN, UP * 40.0}


def list_material(anatomy: Anatomy, body: str) -> Iterator[BaseGeometry]:
    """What is drawn of a body."""
    for part in anatomy.parts:
        if part.body == body:
            match part:
                case Bar() | Rod():
                    yield LineString([part.start, part.end]).buffer(BOLD.width / 2)
                case Plate():
                    yield Polygon(part.corners)
                case SlottedDisc() | GenevaWheel():
                    yield Point(part.centre).buffer(part.radius)
    own = [rim for rim in anatomy.rims if rim.body == body]
    shapes = anatomy.hints.shapes
    for outline in trace_outlines(anatomy.mechanism, shapes, anatomy.symbols, own):
        yield Polygon(outline)
    for symbol in anatomy.symbols:
        if symbol.hanging and symbol.hanging.body == body:
            yield LineString([symbol.hanging.start, symbol.hanging.end])
        if symbol.sleeve and symbol.carrier == body:
            yield Point(symbol.sleeve.point)


def find_hanging(anatomy: Anatomy) -> list[tuple[str, str]]:
    """The bodies with their points that lie on nothing that is drawn of them; a body of one point
    is drawn as that.
    """
    return [
        (body.name, name)
        for body in anatomy.mechanism.bodies
        if len(body.points) > 1
        for name in body.points
        if min(
            Point(anatomy.mechanism.points[name]).distance(each)
            for each in (Point(1e6, 1e6), *list_material(anatomy, body.name))
        )
        > SIGHT
    ]


def list_hanging(template: Template) -> list[tuple[int, list[tuple[str, str]]]]:
    """Of the draws that can be put together, each with what hangs in the air of it."""
    found = []
    for seed in range(DRAWS):
        with suppress(MechanismError):
            found.append((seed, find_hanging(draw_anatomy(template, seed))))
    return found


@pytest.mark.sampled(8, first=3)
@pytest.mark.parametrize("name", find_template_names())
def test_no_point_of_a_shipped_template_hangs_in_the_air(name: str) -> None:
    found = list_hanging(shipped(name))
    assert found, "no draw could be put together"
    assert [each for each in found if each[1]] == []


@pytest.mark.parametrize("path", AUTHORED, ids=lambda path: path.stem)
def test_no_point_of_an_authored_template_hangs_in_the_air(path: Path) -> None:
    found = list_hanging(read_template(path.stem, path.read_text(encoding="utf-8")))
    assert found, "no draw could be put together"
    assert [each for each in found if each[1]] == []

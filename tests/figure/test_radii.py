"""The arrow of a radius keeps away from other lines, other wheels and points on the rim."""

from __future__ import annotations

from collections.abc import Sequence
from math import acos, degrees

import pytest
from msgspec.structs import replace
from shapely import LineString, Point, Polygon, union_all

from kinegrade.errors import TemplateError
from kinegrade.figure.joints.symbol import Kind, Rim
from kinegrade.figure.marks.angle_arc import AngleArc
from kinegrade.figure.marks.radii import add_radii
from kinegrade.figure.marks.radius_arrows import RadiusFromOutside
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.plane import angle_of, length, nearest_of, shorter_way, unit
from kinegrade.figure.scene import BOLD, FIRM, THIN, TOOTHED, Bow, Disc, Outline, Primitive, Strokes
from kinegrade.figure.symbols.ground import HATCHING, list_round_hatching
from kinegrade.figure.teeth import trace_gear
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Angle, Radius
from tests.figure.clear import heads
from tests.figure.mechanisms import polar

ORIGIN = Vector(0.0, 0.0)
FAR = Vector(99.0, 0.0)
GEARS = [  # a body, the radius of its gear, and whether that has its teeth inward
    ("W", 20.0, False),
    ("W", 6.0, False),
    ("W", 30.0, True),
    (GROUND, 20.0, False),
]
BESIDE = 15.0 - 1e-6  # degrees between two lines that are told apart at once


def make_rim(at: Vector, radius: float, centre: str = "O") -> Rim:
    return Rim("W", centre, at, radius, "wheel", False, at, at)


def mark(rims: Sequence[Rim], drawn: Sequence[Primitive] = (), *, at: Vector = FAR) -> Layout:
    """The radius R of the first rim; a point P is marked as well."""
    circles = [Disc(rim.at, rim.radius, FIRM) for rim in rims]
    layout = Layout.of((*circles, *drawn))
    hint = Radius("R", rims[0].centre)
    return add_radii(layout, {"O": ORIGIN, "P": at}, tuple(rims), [hint])


def find_tip(layout: Layout) -> Vector:
    [head] = heads(layout)
    return head.corners[0]


def turned(layout: Layout, toward: Vector) -> float:
    """Degrees between the arrow and a direction."""
    return degrees(acos(unit(find_tip(layout)).dot(unit(toward))))


def test_an_arrow_stands_at_an_angle_to_the_lines_from_its_centre() -> None:
    preferred = find_tip(mark([make_rim(ORIGIN, 20.0)]))
    for offset in (-8.0, 0.0, 8.0):
        leg = polar(12.0, degrees(angle_of(preferred)) + offset)
        layout = mark([make_rim(ORIGIN, 20.0)], [Strokes(((ORIGIN, leg),), THIN)])
        assert turned(layout, leg) >= BESIDE


def test_an_arrow_does_not_prolong_a_line_through_its_centre_to_a_diameter() -> None:
    preferred = find_tip(mark([make_rim(ORIGIN, 20.0)]))
    line = Strokes(((-unit(preferred) * 1.3, -preferred),), THIN)
    layout = mark([make_rim(ORIGIN, 20.0)], [line])
    assert turned(layout, preferred) >= BESIDE


def test_an_arrow_and_its_letter_keep_out_of_other_wheels() -> None:
    preferred = find_tip(mark([make_rim(ORIGIN, 30.0)]))
    other = make_rim(preferred * 0.6, 9.0, "P")
    layout = mark([make_rim(ORIGIN, 30.0), other])
    [label] = layout.labels
    assert length(nearest_of(other.at, ORIGIN, find_tip(layout)) - other.at) > 9.0
    assert length(label.centre - other.at) > 9.0


def test_an_arrow_does_not_lie_on_the_rim_of_another_wheel() -> None:
    preferred = find_tip(mark([make_rim(ORIGIN, 30.0)]))
    other = make_rim(preferred * 0.5 + unit(preferred).turned() * 9.6, 9.0, "P")
    tip = find_tip(mark([make_rim(ORIGIN, 30.0), other]))
    assert length(nearest_of(other.at, ORIGIN, tip) - other.at) > 10.0


def test_an_arrow_does_not_end_at_a_point_of_the_rim() -> None:
    preferred = find_tip(mark([make_rim(ORIGIN, 20.0)]))
    layout = mark([make_rim(ORIGIN, 20.0)], at=preferred)
    assert length(find_tip(layout) - preferred) > 4.0


def test_an_arrow_does_not_end_in_the_wedge_between_the_rim_and_a_bar_that_touches_it() -> None:
    preferred = find_tip(mark([make_rim(ORIGIN, 20.0)]))
    contact = polar(20.0, degrees(angle_of(preferred)) + 20.0)
    along = unit(contact).turned() * 15.0
    bar = Strokes(((contact - along, contact + along),), BOLD)
    assert turned(mark([make_rim(ORIGIN, 20.0)], [bar], at=contact), contact) > 25.0


def test_radii_of_circles_that_overlap_point_away_from_each_other() -> None:
    for way in (Vector(6.0, 0.0), Vector(-6.0, 0.0), Vector(0.0, 6.0)):
        layout = mark([make_rim(ORIGIN, 20.0), make_rim(way, 20.0, "P")])
        assert find_tip(layout).dot(way) <= 1e-6


def test_an_arrow_from_outside_does_not_end_on_a_bar() -> None:
    preferred = find_tip(mark([make_rim(ORIGIN, 5.0)]))
    across = unit(preferred).turned() * 3.0
    bar = Strokes(((preferred * 1.1 - across, preferred * 1.1 + across),), BOLD)
    assert turned(mark([make_rim(ORIGIN, 5.0)], [bar]), preferred) > BESIDE


def test_an_arrow_does_not_lie_between_the_sides_of_an_angle_at_its_centre() -> None:
    preferred = angle_of(find_tip(mark([make_rim(ORIGIN, 20.0)])))
    for sweep in (1.2, -1.2):
        arc = Bow(ORIGIN, 5.0, preferred - sweep / 2, sweep, THIN)
        tip = find_tip(mark([make_rim(ORIGIN, 20.0)], [arc]))
        assert abs(shorter_way(angle_of(tip) - preferred)) > 0.6


def test_an_arrow_does_not_cross_the_arc_of_an_angle_at_another_point() -> None:
    preferred = find_tip(mark([make_rim(ORIGIN, 20.0)]))
    bow = Bow(preferred * 0.3 + Vector(0.0, 4.0), 6.0, angle_of(preferred) - 1.5, 3.0, THIN)
    arc = AngleArc(bow, (), Angle("x", "P", "right", "up"), 0.0)
    layout = replace(Layout.of([Disc(ORIGIN, 20.0, FIRM)]), marks=(arc,))
    layout = add_radii(layout, {"O": ORIGIN}, (make_rim(ORIGIN, 20.0),), [Radius("R", "O")])
    drawn = LineString(bow.path(0.1))
    assert LineString([ORIGIN, preferred]).crosses(drawn)
    assert not LineString([ORIGIN, find_tip(layout)]).crosses(drawn)


def test_an_arrow_comes_from_outside_where_everything_is_in_its_way_within() -> None:
    spokes = [polar(6.0, turn) for turn in range(0, 360, 5)]
    fence = Strokes(tuple((spoke, spoke * 1.05) for spoke in spokes), FIRM)
    layout = mark([make_rim(ORIGIN, 20.0)], [fence])
    [head], [label] = heads(layout), layout.labels
    assert head.corners[1].squared() > 20.0**2
    assert label.centre.squared() > 20.0**2


@pytest.mark.parametrize("radius", [18.3, 20.0, 23.1, 27.7])
def test_the_strokes_of_hatching_that_the_head_of_an_arrow_meets_are_left_out_whole(
    radius: float,
) -> None:
    layout = mark([replace(make_rim(ORIGIN, radius), body=GROUND)])
    head, edge = Polygon(heads(layout)[0].corners), Point(ORIGIN).buffer(radius, 64).boundary
    whites = [each for each in layout.lines if isinstance(each, Outline) and each.fill == "white"]
    white = union_all([Polygon(each.corners) for each in whites])
    strokes = list_round_hatching(ORIGIN, radius, outward=False)
    left = [LineString(stroke).difference(white.union(edge.buffer(0.4))) for stroke in strokes]
    cut = [stroke for stroke in left if 0.0 < stroke.length < HATCHING * 0.8]
    assert whites
    assert cut == []
    assert head.distance(union_all(left)) > 0.4
    assert white.disjoint(edge.buffer(FIRM.width / 2))


@pytest.mark.parametrize("radius", [24.0, 32.0, 48.0])
def test_strokes_of_hatching_are_left_between_the_head_of_an_arrow_and_the_end_of_an_arc(
    radius: float,
) -> None:
    contacts = (polar(radius, 60.0), polar(radius, 110.0))
    rim = replace(make_rim(ORIGIN, radius), body=GROUND, contacts=contacts)
    layout = mark([rim])
    whites = [each for each in layout.lines if isinstance(each, Outline) and each.fill == "white"]
    white = union_all([Polygon(each.corners) for each in whites])
    strokes = list(list_round_hatching(ORIGIN, radius, outward=False, arc=rim.find_arc()))
    hidden = [number for number, each in enumerate(strokes) if white.intersects(LineString(each))]
    assert min(hidden) >= 3
    assert max(hidden) <= len(strokes) - 4


@pytest.mark.parametrize("outward", [True, False])
def test_the_hatching_of_an_arc_reaches_both_ends_and_is_not_beyond_one(outward: bool) -> None:
    arc = (0.5, 1.5)
    strokes = list_round_hatching(ORIGIN, 28.0, outward, arc)
    ends = [28.0 * (angle_of(at) - arc[0]) for stroke in strokes for at in stroke]
    assert -1e-6 <= min(ends) < 1.0
    assert -1.0 < max(ends) - 28.0 * arc[1] <= 1e-6


def test_no_crumb_of_a_stroke_that_is_left_out_is_left_at_the_edge() -> None:
    layout = mark([replace(make_rim(ORIGIN, 23.1), body=GROUND)])
    whites = [each for each in layout.lines if isinstance(each, Outline) and each.fill == "white"]
    white, edge = union_all([Polygon(each.corners) for each in whites]), FIRM.width / 2 + 0.05
    strokes = [LineString(each) for each in list_round_hatching(ORIGIN, 23.1, outward=False)]
    inside = Point(ORIGIN).buffer(23.1 - edge, 256)
    left_out = [each for each in strokes if each.intersection(white).length > HATCHING / 2]
    assert left_out
    for stroke in left_out:
        assert stroke.intersection(inside).difference(white.buffer(0.01)).is_empty


def test_the_head_of_an_arrow_at_a_moving_wheel_has_no_white() -> None:
    layout = mark([make_rim(ORIGIN, 20.0)])
    assert [each.fill for each in layout.lines if isinstance(each, Outline)] == ["black"]


def test_the_head_of_an_arrow_has_no_white_where_the_hatching_is_behind_the_edge() -> None:
    layout = mark([replace(make_rim(ORIGIN, 20.0), body=GROUND, ring=True)])
    assert [each.fill for each in layout.lines if isinstance(each, Outline)] == ["black"]


@pytest.mark.parametrize("turn", range(0, 360, 37))
@pytest.mark.parametrize(("body", "radius", "ring"), GEARS)
def test_the_head_of_an_arrow_at_a_gear_crosses_no_flank(
    turn: int, body: str, radius: float, ring: bool
) -> None:
    tooth = polar(radius, turn)
    layout = mark([Rim(body, "O", ORIGIN, radius, "gear", ring, tooth, tooth)])
    flanks = LineString([*trace_gear(ORIGIN, tooth, ring), trace_gear(ORIGIN, tooth, ring)[0]])
    [head] = heads(layout)
    assert len([each for each in layout.lines if isinstance(each, Outline)]) == 1
    assert Polygon(head.corners).distance(flanks) > 0.05


def test_the_tip_of_an_arrow_keeps_clear_of_an_arrow_along_the_rim() -> None:
    preferred = find_tip(mark([make_rim(ORIGIN, 20.0)]))
    along = Bow(ORIGIN, 18.9, angle_of(preferred) - 0.1, 0.2, FIRM)
    layout = mark([make_rim(ORIGIN, 20.0)], [along])
    assert turned(layout, preferred) > 10.0


@pytest.mark.parametrize("kind", ["wheel", "gear"])
def test_an_arrow_at_a_gear_comes_from_outside_as_at_a_wheel(kind: Kind) -> None:
    tooth = polar(12.0, 0.0)
    rim = Rim("W", "O", ORIGIN, 12.0, kind, False, tooth, tooth)
    teeth = Outline(trace_gear(ORIGIN, tooth, inward=False), TOOTHED)
    drawn = teeth if kind == "gear" else Disc(ORIGIN, 12.0, FIRM)
    layout = Layout.of([Disc(ORIGIN, 8.0, THIN), drawn])
    layout = add_radii(layout, {"O": ORIGIN}, (rim,), [Radius("R", "O")])
    assert isinstance(layout.marks[-1], RadiusFromOutside)
    assert layout.crowded == ()


def test_the_symbol_of_a_small_circle_takes_its_place_before_that_of_a_large_one() -> None:
    at = {"O": ORIGIN, "P": Vector(0.0, 13.0)}
    ring = Rim("ring", "O", ORIGIN, 20.0, "wheel", True, ORIGIN, ORIGIN)
    wheel = Rim("wheel", "P", at["P"], 6.0, "wheel", False, ORIGIN, ORIGIN)
    layout = add_radii(Layout.of(()), at, (ring, wheel), [Radius("R", "O"), Radius("r", "P")])
    assert [label.symbol for label in layout.labels] == ["r", "R"]


def test_an_arrow_does_not_span_the_ring_between_two_circles_about_one_centre() -> None:
    """It would read as the difference of their radii."""

    def comes_from_outside(*rims: Rim) -> bool:
        [head] = heads(mark(rims))
        tip, *others = (length(corner) for corner in head.corners)
        return min(others) > tip

    small = make_rim(ORIGIN, 7.0)
    assert comes_from_outside(small)
    assert not comes_from_outside(small, make_rim(ORIGIN, 14.0, "A"))
    assert comes_from_outside(small, make_rim(ORIGIN, 40.0, "A"))


def test_several_circles_about_a_centre_are_told_apart_by_what_helps() -> None:
    large, small = make_rim(ORIGIN, 20.0), make_rim(ORIGIN, 10.0)
    for other, helps in (
        (small, 'through = "POINT", a point on it'),
        (replace(small, body="V"), 'of = "BODY" or through = "POINT"'),
    ):
        with pytest.raises(TemplateError) as error:
            mark([large, other])
        assert str(error.value).endswith(f"say which one, by {helps}")

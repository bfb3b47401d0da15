"""Gears and racks have teeth of one size, and where they meet, a tooth stands in a gap."""

from __future__ import annotations

from math import hypot, pi

import pytest

from kinegrade.figure.joints.symbol import Rim, Symbol
from kinegrade.figure.mechanism.layers import draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.mechanism.rims import find_gap_of_rack, find_rims
from kinegrade.figure.mechanism.straight_parts import Bar
from kinegrade.figure.placing.obstacles import Obstacles
from kinegrade.figure.plane import length, polar
from kinegrade.figure.scene import FIRM, PITCH, TOOTHED, Disc, Outline, Strokes
from kinegrade.figure.symbols.pins import PIN
from kinegrade.figure.symbols.teeth import RACK_DEPTH
from kinegrade.figure.teeth import TOOTH_ROOT, TOOTH_TIP, find_teeth_of_rack, trace_gear, trace_rack
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from tests.figure.mechanisms import Case
from tests.figure.wheel_mechanisms import planet_in_ring, rack_and_gear, rack_in_a_guide

ORIGIN = Vector(0.0, 0.0)


def contours(case: Case) -> list[Outline]:
    primitives = draw(scale_to_paper(case[0], 100.0), case[1]).primitives
    return [part for part in primitives if isinstance(part, Outline) and part.pen == TOOTHED]


def gear(body: str, at: Vector, radius: float, touch: Vector, ring: bool = False) -> Rim:
    return Rim(body, body, at, radius, "gear", ring, touch, touch)


def meshed(*pairs: tuple[Rim, Rim]) -> dict[str, Rim]:
    nothing = Mechanism({}, (), (), ())
    return {rim.body: rim for rim in find_rims(nothing, [Symbol(rims=pair) for pair in pairs], ())}


def depth_at(rim: Rim, touch: Vector) -> float:
    """How far from the centre the corner of the contour is that is nearest in direction."""
    contour = trace_gear(rim.at, rim.tooth, rim.ring)
    away = (touch - rim.at) / length(touch - rim.at)
    near = max(contour, key=lambda corner: (corner - rim.at).dot(away) / length(corner - rim.at))
    return length(near - rim.at) - rim.radius


@pytest.mark.parametrize("inward", [False, True])
def test_a_gear_has_whole_teeth_on_both_sides_of_its_pitch_circle(inward: bool) -> None:
    contour = trace_gear(ORIGIN, Vector(12.0, 0.0), inward)
    radii = {round(hypot(*corner), 6) for corner in contour}
    outward = -1 if inward else 1
    assert radii == {12.0 + outward * TOOTH_TIP, 12.0 - outward * TOOTH_ROOT}
    assert len(contour) % 4 == 0
    assert 2 * pi * 12.0 / (len(contour) / 4) == pytest.approx(4.0, rel=0.05)


def test_where_two_gears_meet_one_has_a_tooth_and_the_other_a_gap() -> None:
    touch = Vector(10.0, 0.0)
    found = meshed((gear("I", ORIGIN, 10.0, touch), gear("II", Vector(17.0, 0.0), 7.0, touch)))
    assert depth_at(found["I"], touch) > 0 > depth_at(found["II"], touch)


def test_a_ring_gear_has_a_gap_where_its_planet_has_a_tooth() -> None:
    touch = Vector(0.0, 20.0)
    planet = gear("planet", Vector(0.0, 12.0), 8.0, touch)
    found = meshed((planet, gear("ring", ORIGIN, 20.0, touch, ring=True)))
    assert depth_at(found["planet"], touch) > 0 < depth_at(found["ring"], touch)


def test_the_third_gear_of_a_train_meets_the_second_as_it_stands() -> None:
    one = gear("I", ORIGIN, 10.0, Vector(10.0, 0.0))
    two = gear("II", Vector(18.0, 0.0), 8.0, Vector(10.0, 0.0))
    elsewhere = Vector(18.0, 0.0) + polar(0.9, 8.0)
    third = gear("III", Vector(18.0, 0.0) + polar(0.9, 14.0), 6.0, elsewhere)
    second = Rim("II", "II", two.at, 8.0, "gear", False, elsewhere, elsewhere)
    found = meshed((one, two), (second, third))
    assert found["II"].tooth != elsewhere
    ahead = trace_gear(found["II"].at, found["II"].tooth, False)
    behind = trace_gear(found["III"].at, found["III"].tooth, False)
    tips = [tip for tip in ahead if length(tip - found["II"].at) > 8.0]
    inside = [tip for tip in tips if length(tip - found["III"].at) < 6.0]
    roots = [root for root in behind if length(root - found["III"].at) < 6.0]
    middles = [(roots[index - 1] + roots[index]) / 2 for index in range(0, len(roots), 2)]
    assert inside
    assert [
        tip for tip in inside if not min(length(tip - middle) for middle in middles) < 1.0
    ] == []


def contour_of_rack(*eyes: Vector) -> tuple[Vector, ...]:
    ends, contact = (ORIGIN, Vector(30.0, 0.0)), Vector(13.0, 0.0)
    teeth = find_teeth_of_rack(*ends, contact, eyes)
    return trace_rack(ends, Vector(0.0, -1.0), teeth, 2.0, eyes)


def test_a_rack_has_a_gap_at_its_contact_and_its_back_away_from_the_gear() -> None:
    contour = contour_of_rack()
    near = [corner for corner in contour if abs(corner.x - 13.0) < 1.0]
    assert near == []
    beside = [corner for corner in contour if abs(corner.x - 13.0) < 1.9]
    assert {corner.y for corner in beside} == {-TOOTH_ROOT, TOOTH_TIP}
    amid = {corner.y for corner in contour if 1.0 < corner.x < 29.0}
    assert amid == {TOOTH_TIP, -TOOTH_ROOT}
    assert [corner for corner in contour if not -1e-9 <= corner.x <= 30.0 + 1e-9] == []


def test_a_rack_is_solid_up_to_the_point_at_an_end_without_an_eye() -> None:
    assert {ORIGIN, Vector(30.0, 0.0)} <= set(contour_of_rack())
    assert ORIGIN not in contour_of_rack(ORIGIN)


def test_a_rack_narrows_towards_the_eye_about_its_pin_and_has_no_tooth_there() -> None:
    contour, plain = contour_of_rack(ORIGIN), contour_of_rack()
    tips = [corner.x for corner in contour if corner.y == TOOTH_TIP]
    assert min(tips) > 4.0
    assert len(tips) < len([corner for corner in plain if corner.y == TOOTH_TIP])
    assert min(corner.x for corner in contour if corner.y == -2.0) > 4.0
    assert min(corner.x for corner in plain if corner.y == -2.0) == 0.0


def test_a_rack_ends_in_an_arm_about_the_pin_and_without_a_hook() -> None:
    contour = contour_of_rack(ORIGIN)
    assert {corner.y for corner in contour if corner.x == 0.0} == {-1.2, 1.2}
    solid = [corner.x for corner in contour if corner.y == 0.0]
    assert (min(solid), max(solid)) == pytest.approx((27.8, 30.0))
    assert max(corner.x for corner in contour if corner.y == TOOTH_TIP) < 27.0


def test_a_rack_that_slides_in_a_guide_has_the_ground_along_its_back_and_no_pin() -> None:
    mechanism, hints = rack_in_a_guide()
    drawing = draw(scale_to_paper(mechanism, 100.0), hints)
    [rack] = [part for part in drawing.parts if isinstance(part, Bar)]
    [rail] = drawing.rails
    assert rack.free == (rack.start, rack.end)
    assert rail.surface.point.y == pytest.approx(rack.start.y - RACK_DEPTH - FIRM.width / 2)
    assert rail.start.x < rack.start.x
    assert rail.end.x > rack.end.x
    assert not [part for part in drawing.primitives if part == Disc(rack.start, PIN, FIRM, "white")]


def test_gears_and_racks_of_a_mechanism_are_drawn_with_teeth_and_pitch_lines() -> None:
    assert len(contours(planet_in_ring())) == 2
    assert len(contours(rack_and_gear())) == 2
    primitives = draw(scale_to_paper(rack_and_gear()[0], 100.0), rack_and_gear()[1]).primitives
    pitched = [
        type(part) for part in primitives if isinstance(part, Disc | Strokes) and part.pen == PITCH
    ]
    assert pitched == [Disc, Strokes]


def test_no_letter_finds_a_place_between_teeth() -> None:
    (planet, *_) = contours(planet_in_ring())
    obstacles = Obstacles.of([planet])
    for tip, root in zip(planet.corners[1::4], planet.corners[3::4], strict=True):
        for x, y in (tip, root):
            assert obstacles.under_box(x, y, 0.1, 0.1) > 0


def test_no_letter_finds_a_place_on_the_back_of_a_rack() -> None:
    rack, *_ = contours(rack_and_gear())[::-1]
    obstacles, (end, start) = Obstacles.of([rack]), (rack.corners[-1], rack.corners[0])
    for share in (0.1, 0.5, 0.9):
        x, y = start + (end - start) * share
        assert obstacles.under_box(x, y, 0.1, 0.1) > 0


@pytest.mark.parametrize("teeth", [15, 16, 17, 18])
def test_a_rack_has_a_gap_where_its_gear_has_a_tooth_nearest_to_their_contact(teeth: int) -> None:
    radius = 4.0 * teeth / (2 * pi)
    contact = Vector(0.0, radius)
    gap = find_gap_of_rack([gear("I", ORIGIN, radius, Vector(0.0, -radius))], contact)
    aside = 0.0 if teeth % 2 == 0 else 2.0  # half a pitch where a gap is opposite to the tooth
    assert gap.y == radius
    assert abs(gap.x) == pytest.approx(aside, abs=1e-9)

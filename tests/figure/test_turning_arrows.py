"""The arrows of rotations: told from one another, and clear of what dimension lines will need."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import copysign, cos, degrees, hypot, pi

import pytest
from msgspec import structs

from kinegrade.figure.joints.symbol import Rim
from kinegrade.figure.marks.lengths.dimensions import find_extension_angles
from kinegrade.figure.marks.turning_arrow import Company, TurningArrow
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.obstacles import Obstacles
from kinegrade.figure.placing.ownership import Claims
from kinegrade.figure.plane import angle_of, length, polar, shorter_way
from kinegrade.figure.scene import BOLD, FIRM, PITCH, THIN, Bow, Disc, Scene, Strokes
from kinegrade.figure.sketch import sketch
from kinegrade.mechanics.drivers import Rotation
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.given_marks import mark_givens
from kinegrade.problem.template.hints import Length, Turning
from kinegrade.problem.template.library.library import load_template
from tests.figure.mechanisms import slider_crank
from tests.problem.draws import draw_filter, drawn

ORIGIN = Vector(0.0, 0.0)
ALONE = Company((), (), (), ())
BESIDE = Vector(10.0, 5.0)
DISC = Rim("W", "C", BESIDE, 8.0, "wheel", ring=False, touch=BESIDE, tooth=BESIDE)


def arc(start: float, sweep: float, radius: float = 5.0) -> Bow:
    """An arc about the origin, its angles in degrees."""
    return Bow(ORIGIN, radius, start * pi / 180, sweep * pi / 180, THIN)


@pytest.mark.parametrize(
    "company",
    [
        structs.replace(ALONE, arcs=(arc(80, 40, 7.0),)),
        structs.replace(ALONE, arcs=(arc(0, 100, 10.0),)),
        structs.replace(ALONE, twins=(arc(120, -40),)),
        structs.replace(ALONE, twins=(arc(0, 70, 11.1),)),
        structs.replace(ALONE, rims=(6.0,)),
        structs.replace(ALONE, discs=(DISC,)),
        structs.replace(ALONE, lines=(pi / 3,)),
        structs.replace(ALONE, bars=((Vector(0.0, 4.0), Vector(5.0, 0.5)),)),
        structs.replace(ALONE, bars=((Vector(1.0, 7.0), Vector(7.0, 5.0)),)),
    ],
    ids=[
        "after the arc of an angle",
        "within the arc of an angle",
        "tip to tip",
        "within another",
        "beside a rim",
        "in a disc",
        "on a line to come",
        "beyond a bar",
        "at a bar",
    ],
)
def test_an_arrow_that_could_be_misread_is_worse(company: Company) -> None:
    assert company.rate(arc(0, 70)) > ALONE.rate(arc(0, 70)) == 0
    assert company.rate(arc(0, 70)) > company.rate(arc(230, 70, 12.0)) == 0


def test_a_bar_beside_an_arrow_or_at_its_pivot_does_not_part_them() -> None:
    beside, from_pivot = (Vector(0.0, 14.0), Vector(14.0, 0.0)), (ORIGIN, Vector(9.0, 6.0))
    assert structs.replace(ALONE, bars=(beside, from_pivot)).rate(arc(0, 70)) == 0


def test_two_arrows_one_right_after_the_other_read_as_one() -> None:
    touching, after = (structs.replace(ALONE, twins=(arc(start, 70),)) for start in (80, 100))
    assert touching.rate(arc(0, 70)) > after.rate(arc(0, 70)) + 6.0


def test_the_symbol_of_an_arrow_is_not_beside_another_one_first() -> None:
    arrow = TurningArrow(arc(0, 70), Turning(r"\omega", "AB"), 0.0)
    other = TurningArrow(arc(0, 70, 10.0), Turning(r"\alpha", "AB"), 0.0)
    wish = arrow.wish_apart([other])
    assert wish.demerits is not None
    along = len(arrow.wish().spots)
    rated = list(zip(wish.spots.tolist(), wish.demerits.tolist(), strict=True))[:along]
    assert {demerit for (x, y), demerit in rated if hypot(x, y) > 8.0} == {8.0}
    assert {demerit for (x, y), demerit in rated if hypot(x, y) < 5.0} == {0.0}


def test_a_symbol_without_room_at_its_arrow_does_not_go_to_another_one() -> None:
    arrow = TurningArrow(arc(0, 70), Turning(r"\omega", "AB"), 0.0)
    other = TurningArrow(arc(0, 70, 11.0), Turning(r"\alpha", "AB"), 0.0)
    pin = Disc(ORIGIN, 2.9, FIRM, "black")
    drawn = Layout.of([pin, *arrow.primitives(), *other.primitives()])
    [letter] = drawn.captioned(arrow.wish_apart([other])).labels
    gaps = [
        min(hypot(*(letter.centre - at)) for at in each.bow.path(0.05)) for each in (arrow, other)
    ]
    assert gaps[0] < gaps[1] - 0.3


def test_no_circle_parts_a_symbol_from_its_arrow_first() -> None:
    arrow = TurningArrow(arc(0, 70), Turning(r"\omega", "AB"), 0.0)
    around = Claims(circles=(Disc(ORIGIN, 6.0, FIRM),))
    wish = structs.replace(arrow, around=around).wish_apart([])
    assert wish.demerits is not None
    assert {demerit > 0 for demerit in wish.demerits.tolist()} == {False, True}
    for (x, y), demerit in zip(wish.spots.tolist(), wish.demerits.tolist(), strict=True):
        assert (demerit > 0) == (hypot(x, y) > 6.0)


def test_an_arrow_rather_stands_nearer_to_its_own_pivot_than_to_another_pin() -> None:
    beside = structs.replace(ALONE, pins=(ORIGIN, polar(0.6, 9.0)))
    assert beside.rate(arc(0, 70, 8.0)) > beside.rate(arc(180, 70, 8.0)) == 0.0


def test_a_dimension_needs_lines_across_it_unless_a_bar_is_there() -> None:
    at = {"O": ORIGIN, "A": Vector(10.0, 0.0), "B": Vector(0.0, 20.0)}
    bar = Obstacles.of([Strokes(((at["O"], at["A"]),), BOLD)])

    def find(*lengths: Length) -> list[float]:
        return sorted(
            round(degrees(turn)) for turn in find_extension_angles(at, lengths, ORIGIN, bar)
        )

    assert find(Length("l", "O", "A")) == []
    assert find(Length("l", "O", "A", "horizontal")) == [-90, 90]
    assert {turn % 180 for turn in find(Length("h", "O", "B"))} == {0}
    assert find(Length("c", "A", "B")) == []


def list_arrows(scene: Scene) -> list[Bow]:
    return [part for part in scene.primitives if isinstance(part, Bow) and part.pen == FIRM]


def test_a_relative_arrow_ends_before_the_body_that_turns() -> None:
    mechanism, hints = slider_crank(0.2, 2.0, 130)
    arrows = (Turning(r"\omega", "AB", None, "velocity", "OA"),)
    driven = replace(mechanism, drivers=(Rotation("AB", 2.0, 0.0, "OA"),))
    scene = sketch(driven, replace(hints, arrows=arrows))
    (arrow,) = list_arrows(scene)
    assert 0 < arrow.sweep * arrow.radius < 9.0


def _draw_arrows(name: str, **fixed: tuple[str, ...]) -> Iterator[tuple[Mechanism, list[Bow]]]:
    """Some draws of a template in millimetres, and the arrows of rotations in their figures."""
    template = load_template(name)
    for draw in drawn(draw_filter(template, fixed=fixed), 4):
        mechanism = draw.solution.assembly.mechanism.map(float)
        scene = sketch(mechanism, mark_givens(template))
        yield scale_to_paper(mechanism, scene.scale), list_arrows(scene)


def test_the_arrow_of_an_arm_begins_on_it_where_a_pulley_turns_about_the_same_pivot() -> None:
    for mechanism, (of_pulley, *of_arm) in _draw_arrows("crossed-belt-drive"):
        arm = angle_of(mechanism.points["A"] - mechanism.points["O"])
        assert len(of_arm) == 2
        reach = max(arrow.radius for arrow in of_arm)
        assert reach < 1.1 * of_pulley.radius  # at O, not down the arm
        assert [arrow.start for arrow in of_arm] == pytest.approx([arm, arm])


def test_the_arrow_of_an_arm_beneath_gears_goes_ahead_of_its_planet() -> None:
    for mechanism, (arrow,) in _draw_arrows("epicyclic-train-by-tooth-counts"):
        reach = mechanism.points["P"] - mechanism.points["O"]
        assert abs(arrow.radius - length(reach)) < 3.1
        ahead = shorter_way(arrow.start - angle_of(reach)) * copysign(1, arrow.sweep)
        assert 0 < ahead < pi / 3


def test_the_arrow_of_an_arm_is_not_in_the_disc_of_its_planet() -> None:
    for mechanism, (arrow, *_) in _draw_arrows("planetary-gear-external-rim-velocities"):
        assert arrow.radius < length(mechanism.points["D"] - mechanism.points["O"])


def test_the_arrows_of_an_arm_in_a_fixed_ring_are_at_its_pivot() -> None:
    for _, arrows in _draw_arrows("ring-gear-planet-relative-spin", phi_3=("60", "120", "220")):
        assert [arrow for arrow in arrows if arrow.radius > 9.0] == []


def test_the_arrow_of_a_cam_stands_off_its_base_circle() -> None:
    template = load_template("flat-faced-follower-curvature-radius")
    (draw,) = drawn(draw_filter(template), 1)
    mechanism = draw.solution.assembly.mechanism.map(float)
    scene = sketch(mechanism, mark_givens(template))
    omega, *_ = list_arrows(scene)
    discs = [part for part in scene.primitives if isinstance(part, Disc)]
    base = [disc.radius for disc in discs if disc.centre == omega.centre and disc.radius > 3]
    assert [radius for radius in base if not abs(omega.radius - radius) > 1.9] == []
    assert base


def test_the_symbol_of_an_arrow_is_on_its_side_of_the_base_circle() -> None:
    template = load_template("tangent-cam-with-roller")
    for draw in drawn(draw_filter(template), 4):
        scene = sketch(draw.solution.assembly.mechanism.map(float), mark_givens(template))
        (arrow,) = list_arrows(scene)
        discs = [part for part in scene.primitives if isinstance(part, Disc) and part.pen == PITCH]
        (base,) = (disc for disc in discs if disc.centre == arrow.centre)
        (symbol,) = (label for label in scene.labels if label.symbol == "n")
        away = length(symbol.centre - base.centre)
        assert (away < base.radius) == (arrow.radius < base.radius)


def test_an_arrow_goes_farther_out_rather_than_where_a_dimension_may_need_a_line() -> None:
    company, turning = structs.replace(ALONE, lines=(-pi / 2,)), Turning("a", "b")
    across, beside = (
        TurningArrow(bow, turning, worse).among(company)
        for bow, worse in ((arc(240, 60), 0.0), (arc(290, 40, 8.0), 4.5))
    )
    assert beside.demerit < across.demerit


def test_the_arrow_of_a_cam_is_not_beyond_the_line_to_its_centre_of_curvature() -> None:
    for mechanism, arrows in _draw_arrows("flat-faced-follower-curvature-radius"):
        side = mechanism.points["K"].x - mechanism.points["O"].x
        for arrow in arrows:
            reach = polar(arrow.start + arrow.sweep / 2, arrow.radius)
            assert reach.x * side < side * side


def test_the_letter_of_a_knife_edge_stands_outside_the_disc() -> None:
    template = load_template("pose-cam-tappet")
    for draw in drawn(draw_filter(template), 4):
        scene = sketch(draw.solution.assembly.mechanism.map(float), mark_givens(template))
        disc = max((part for part in scene.primitives if isinstance(part, Disc)), key=_measure)
        (letter,) = (label for label in scene.labels if label.symbol == "A")
        assert length(letter.centre - disc.centre) > disc.radius


def _measure(disc: Disc) -> float:
    return disc.radius


def test_the_arrow_of_a_ring_is_not_between_its_pivot_and_its_centre() -> None:
    for _, arrows in _draw_arrows("pin-in-two-rings"):
        middle = sum(arrow.centre.x for arrow in arrows) / len(arrows)
        assert len(arrows) == 4
        for arrow in arrows:
            aside = arrow.radius * cos(arrow.start + arrow.sweep / 2)
            assert aside * (arrow.centre.x - middle) > 0


def turn_both(of: str, phi: float) -> list[Bow]:
    """The arrows of an angular velocity and acceleration of one body."""
    mechanism, hints = slider_crank(0.2, 1.75, phi)
    body = "OA" if of == "ground" else "AB"
    arrows = (
        Turning(r"\omega", body, None, "velocity", of),
        Turning(r"\alpha", body, None, "acceleration", of),
    )
    drivers = (Rotation(body, 2.0, -1.0, of),)
    scene = sketch(replace(mechanism, drivers=drivers), replace(hints, arrows=arrows))
    return [part for part in scene.primitives if isinstance(part, Bow) and part.pen == FIRM]


@pytest.mark.parametrize("phi", [20.0, 60.0, 120.0])
def test_the_two_arrows_of_a_body_do_not_follow_one_another_on_one_arc(phi: float) -> None:
    one, other = turn_both("ground", phi)
    turned = shorter_way(one.start + one.sweep / 2 - other.start - other.sweep / 2)
    assert abs(degrees(turned)) > 85.0 or abs(one.radius - other.radius) >= 2.5


@pytest.mark.parametrize("phi", [30.0, 60.0, 120.0])
def test_two_arrows_of_a_relative_rotation_have_radii_that_differ(phi: float) -> None:
    one, other = turn_both("OA", phi)
    assert abs(one.radius - other.radius) >= 2.5

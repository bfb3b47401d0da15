"""The polygon of a vector equation is to scale, closed, and readable whatever the vectors."""

from __future__ import annotations

from itertools import accumulate
from math import cos, hypot, log10, sin

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kinegrade.figure.scene import DASHED, FIRM, THIN, Outline, Scene
from kinegrade.figure.vectors.chains import Arrow, find_order
from kinegrade.figure.vectors.corners import FAR
from kinegrade.figure.vectors.plain_mechanism import LARGE, PICTURE
from kinegrade.figure.vectors.polygon import HIGH, draw_polygon
from kinegrade.mechanics.vector import Vector
from kinegrade.round_numbers import STEPS
from tests.figure.clear import dots, faults, heads, lines, symbols

A, B = Vector(3.0, 4.0), Vector(6.0, 0.0)
TRIANGLE = ([Arrow("v_B", B, False)], [Arrow("v_A", A), Arrow("v_{BA}", B - A, False)])
CORNERS = {"a": A, "b": B}


def tips(scene: Scene) -> list[Vector]:
    """The tips of all arrows, from the origin, in the unit of the vectors."""
    (origin,) = dots(scene)
    return [
        (head.corners[0] - origin) / scene.scale
        for fill in ("black", "white")
        for head in heads(scene, fill)
    ]


def same(found: list[Vector], wanted: list[Vector]) -> bool:
    pairs = zip(found, wanted, strict=True)
    return all(hypot(*(one - other)) < 1e-9 for one, other in pairs)


def test_both_sides_lead_from_one_origin_to_one_end() -> None:
    scene = draw_polygon(*TRIANGLE, CORNERS)
    assert same(tips(scene), [A, B, B])
    assert symbols(scene) == ["a", "b", "o", "v_A", "v_B", "v_{BA}"]


def test_known_and_unknown_are_told_apart() -> None:
    scene = draw_polygon(*TRIANGLE)
    assert (len(lines(scene, FIRM)), len(lines(scene, DASHED))) == (1, 2)
    assert (len(heads(scene, "black")), len(heads(scene, "white"))) == (1, 2)


@pytest.mark.parametrize("factor", [1e-3, 1.0, 37.0, 1e4])
def test_the_scale_is_a_round_number_for_vectors_of_any_size(factor: float) -> None:
    left, right = (
        [Arrow(arrow.symbol, arrow.value * factor) for arrow in side] for side in TRIANGLE
    )
    scene = draw_polygon(left, right)
    figures = scene.scale / 10 ** int(log10(scene.scale) // 1)
    assert min(abs(figures - leading) for leading in STEPS) < 1e-6
    assert max(scene.width, scene.height) > 30.0
    assert faults(scene, PICTURE.width, PICTURE.height) == []


def test_what_is_zero_or_negligible_is_not_drawn_and_not_named() -> None:
    tiny = Vector(0.02, 0.03)
    scene = draw_polygon(
        [Arrow("a_B", A + tiny)],
        [Arrow("a_1", A), Arrow("a_2", tiny), Arrow("a_3", Vector(0.0, 0.0))],
        {"b": A + tiny},
    )
    assert symbols(scene) == ["a_1", "a_B", "b", "o"]


def test_the_arrow_before_a_negligible_one_leads_to_its_tip_so_that_the_polygon_is_closed() -> None:
    left, (first, second) = TRIANGLE
    tiny = Vector(0.02, 0.03)
    shorter = Arrow("v_{BA}", second.value - tiny, False)
    scene = draw_polygon(left, [first, shorter, Arrow("v_1", tiny)], CORNERS)
    assert same(tips(scene), [A, B, B])


def test_an_equation_of_zeros_is_its_origin() -> None:
    scene = draw_polygon([Arrow("v_B", Vector(0.0, 0.0))], [Arrow("v_A", Vector(0.0, 0.0))])
    assert symbols(scene) == ["o"]
    assert scene.scale == 1.0
    assert faults(scene, PICTURE.width, PICTURE.height) == []


def test_of_vectors_on_one_line_the_longer_is_an_outline_around_the_shorter_in_its_place() -> None:
    scene = draw_polygon(
        [Arrow("v_B", B)],
        [Arrow("v_A", B * 1.5), Arrow("v_2", B * 0.3, False), Arrow("v_1", B * -0.8)],
    )
    starts = [start for start, _ in (*lines(scene, FIRM), *lines(scene, DASHED))]
    outlines = [
        part for part in scene.primitives if isinstance(part, Outline) and len(part.corners) == 7
    ]
    assert (len(starts), len(outlines)) == (2, 2)
    (origin,) = dots(scene)
    tips = [one.corners[0] for one in (*heads(scene, "black"), *heads(scene, "white"))]
    for one in outlines:
        starts.append((one.corners[0] + one.corners[-1]) / 2)
        tips.append(one.corners[3])
    for start in starts:
        assert min(hypot(*(start - place)) for place in (origin, *tips)) < 0.01
    assert scene.crowded == ()
    assert faults(scene, PICTURE.width, PICTURE.height) == []


def test_of_two_equal_vectors_one_is_an_outline_around_the_other() -> None:
    """What their difference is made of is too short to draw."""
    tiny = Arrow("a_r", Vector(0.02, 0.0))
    right = [Arrow("a_A", A), tiny]
    scene = draw_polygon([Arrow("a_B", A + tiny.value, False)], right)
    assert symbols(scene) == ["a_A", "a_B", "o"]
    corners = [len(one.corners) for one in scene.primitives if isinstance(one, Outline)]
    assert (sorted(corners), len(heads(scene, "white"))) == ([3, 7], 1)


def test_of_many_vectors_of_a_side_one_changes_places() -> None:
    # A bent rod in two sleeves: of eight vectors the seventh would go back along the fifth
    sizes = ((-19.99, -4.18), (-0.35, 1.67), (-6.64, 7.91), (-12.41, -10.41))
    second = ((19.99, 16.78), (1.4, -1.67), (5.59, 4.69), (12.41, -14.79))
    right = [Arrow(f"a_{place}", Vector(*size)) for place, size in enumerate((*sizes, *second))]
    _, order = find_order([], right)
    assert list(order) != [*range(8)]
    for places, outlined in ((range(8), True), (order, False)):
        scene = draw_polygon([], [right[place] for place in places])
        longest = max(len(one.corners) for one in scene.primitives if isinstance(one, Outline))
        assert (longest == 7) is outlined


def test_a_lengthy_equation_is_within_the_paper_with_all_its_symbols() -> None:
    right = [
        Arrow(rf"a_{{{number}}}^{{\mathrm{{n}}}}", Vector(cos(number), sin(2 * number)))
        for number in range(9)
    ]
    total = sum((arrow.value for arrow in right), Vector(0.0, 0.0))
    scene = draw_polygon([Arrow("a_B", total)], right)
    assert sum(len(label.symbol) > 1 for label in scene.labels) == 10
    assert faults(scene, PICTURE.width, PICTURE.height) == []


@settings(max_examples=25, deadline=None)
@given(st.lists(st.tuples(st.integers(-12, 12), st.floats(0.0, 10.0)), min_size=2, max_size=4))
def test_polygons_of_any_vectors_are_clear(polar: list[tuple[int, float]]) -> None:
    right = [
        Arrow(f"v_{number}", Vector(cos(turn * 0.2618), sin(turn * 0.2618)) * size, number % 2 == 0)
        for number, (turn, size) in enumerate(polar)
    ]
    total = sum((arrow.value for arrow in right), Vector(0.0, 0.0))
    assert (
        faults(draw_polygon([Arrow("v_B", total, False)], right), LARGE.width, LARGE.height) == []
    )


def test_vectors_change_places_rather_than_run_along_one_another() -> None:
    # In the order given, v_2 and v_3 would go back along v_1
    across, back, up = Vector(6.0, 0.0), Vector(-4.0, 0.0), Vector(0.0, 5.0)
    total = across + back + up
    left = [Arrow("v", total)]
    right = [Arrow("v_1", across), Arrow("v_2", back), Arrow("v_3", up)]
    assert find_order(left, right) == ((0,), (0, 2, 1))
    scene = draw_polygon(left, [right[0], right[2], right[1]])
    assert lines(scene, THIN) == []
    assert [tip for tip in tips(scene) if same([tip], [total])], tips(scene)


def test_vectors_that_change_places_pass_through_the_corners_that_have_letters() -> None:
    # v_1 and v_3 lie on one line; a is reached by v_1 and v_2 alone
    one, two, three = Vector(6.0, 0.0), Vector(0.0, 3.0), Vector(-4.0, 0.0)
    right = [Arrow("v_2", two), Arrow("v_1", one), Arrow("v_3", three)]
    left = [Arrow("v", one + two + three)]
    assert find_order(left, right, {"a": one + two}) == ((0,), (1, 0, 2))


def test_of_many_vectors_those_change_places_that_lie_between_the_same_letters() -> None:
    # The tangential part at another place left the rotation of m' about a without its corner
    first = ((3.4035, -19.3022), (1.1818, 0.2084), (-12.3641, -26.5149))
    second = ((-43.0557, 20.0772), (19.2157, 41.2082), (33.6188, -15.6767))
    sides = [Vector(*size) for size in (*first, *second)]
    at = [*accumulate(sides)]
    left, vertices = [Arrow("a_a", at[5])], {"m": at[5], "a": at[1], "m'": at[3]}
    right = [Arrow(f"a_{place}", side) for place, side in enumerate(sides)]
    assert find_order(left, right, vertices) == ((0,), (0, 1, 3, 2, 5, 4))


def test_vectors_keep_their_places_where_none_runs_along_another() -> None:
    assert find_order(*TRIANGLE) == (range(1), range(2))


def test_a_corner_past_a_vector_that_is_not_drawn_keeps_its_letter() -> None:
    tiny = Vector(0.02, 0.03)
    right = [Arrow("a_1", A), Arrow("a_2", tiny), Arrow("a_3", B - A - tiny)]
    assert {"a", "b"} < set(symbols(draw_polygon([Arrow("a_B", B)], right, {"a": A, "b": B})))


def test_a_polygon_whose_symbols_find_no_place_is_high() -> None:
    # A pin in two rings: six short arrows in a heap beside two long ones
    sizes = {
        r"a_{\mathrm{e}1}^{\mathrm{n}}": (-2.08, -1.526),
        r"a_{\mathrm{e}1}^{\mathrm{t}}": (-1.908, 2.6),
        r"a_{\mathrm{r}1}^{\mathrm{n}}": (-0.213, -0.678),
        r"a_{\mathrm{r}1}^{\mathrm{t}}": (8.513, -2.677),
        r"a_{\mathrm{Cor}1}": (-0.64, -2.035),
        r"a_{\mathrm{e}2}^{\mathrm{n}}": (8.32, -6.105),
        r"a_{\mathrm{e}2}^{\mathrm{t}}": (1.145, 1.56),
        r"a_{\mathrm{r}2}^{\mathrm{n}}": (6.453, -20.52),
        r"a_{\mathrm{r}2}^{\mathrm{t}}": (-5.206, -1.637),
        r"a_{\mathrm{Cor}2}": (-7.04, 22.386),
    }
    arrows = [Arrow(symbol, Vector(*size)) for symbol, size in sizes.items()]
    vertices = {
        "m'": Vector(-3.988, 1.074),
        "m": Vector(3.672, -4.316),
        "m''": Vector(9.465, -4.545),
    }
    scene = draw_polygon(arrows[:5], arrows[5:], vertices, 1.0)
    assert (scene.scale, scene.crowded) == (2.0, ())
    assert LARGE.height < scene.height <= HIGH.height


def test_a_corner_that_is_no_points_has_no_letter() -> None:
    left, right = TRIANGLE
    assert symbols(draw_polygon(left, right, {"b": B})) == ["b", "o", "v_A", "v_B", "v_{BA}"]


def test_the_letter_of_a_corner_is_nearest_to_it() -> None:
    # A short vector from the origin: its tip and the origin are 3 mm apart
    first, across = Vector(3.0, 1.0), Vector(0.0, -30.0)
    scene = draw_polygon(
        [Arrow("a", first + across)], [Arrow("a_1", first), Arrow("a_2", across)], {"m'": first}
    )
    (origin,) = dots(scene)
    (label,) = (label for label in scene.labels if label.symbol == "o")
    tip = origin + first * scene.scale
    assert hypot(*(label.centre - origin)) < hypot(*(label.centre - tip))


def test_the_letter_of_the_origin_is_nearer_to_it_than_the_tip_of_a_short_arrow() -> None:
    # 1.4 mm apart: the letter stood beyond the tip, as if the long arrow there began at o
    short, across = Vector(1.2965, 0.6046), Vector(-7.863, 16.863)
    normal, tangential = Vector(-5.963, -12.787), Vector(10.0385, -4.6806)
    whole = short + across + normal + tangential
    right = [
        Arrow("a_A^n", short),
        Arrow("a_A^t", across, False),
        Arrow("a_{BA}^n", normal),
        Arrow("a_{BA}^t", tangential, False),
    ]
    vertices = {"a": short + across, "b": whole}
    scene = draw_polygon([Arrow("a_B", whole, False)], right, vertices, 1.0)
    (origin,) = dots(scene)
    (label,) = (label for label in scene.labels if label.symbol == "o")
    tip = origin + short * scene.scale
    assert hypot(*(label.centre - origin)) < hypot(*(label.centre - tip))


def test_a_vector_that_would_be_a_dot_has_a_larger_scale_at_which_none_is_drawn_aside() -> None:
    # The cam of an offset follower: at the scale of smaller pictures, 5 mm per m/s, the two long
    # arrows would look like one
    follower, cam = Vector(0.0, 0.147), Vector(-5.764, -1.92)
    right = [Arrow("v_e", cam), Arrow("v_r", follower - cam, False)]
    scene = draw_polygon([Arrow("v_a", follower, False)], right, {"a": follower, "a'": cam})
    assert scene.scale == 10.0
    assert PICTURE.width < scene.width <= LARGE.width
    (origin,) = dots(scene)
    assert {round(hypot(*(start - origin)), 6) for start, _ in lines(scene, FIRM)} == {0.0}


def test_letters_stand_beside_their_corners_where_arrows_are_short() -> None:
    # A slotted rocker with two drivers: of seven vectors four are a tenth of the longest
    left = [
        Arrow("a_B", Vector(2.0, 0.0)),
        Arrow(r"a_{AB}^{\mathrm{n}}", Vector(2.65, -1.85)),
        Arrow(r"a_{AB}^{\mathrm{t}}", Vector(-9.74, -13.91), False),
    ]
    right = [
        Arrow(r"a_{\mathrm{e}}^{\mathrm{n}}", Vector(-0.03, -0.172)),
        Arrow(r"a_{\mathrm{e}}^{\mathrm{t}}", Vector(-0.688, 0.121)),
        Arrow(r"a_{\mathrm{Cor}}", Vector(-1.553, 0.274)),
    ]
    total = sum((arrow.value for arrow in left), Vector(0.0, 0.0))
    found = sum((arrow.value for arrow in right), Vector(0.0, 0.0))
    right.insert(2, Arrow(r"a_{\mathrm{r}}", total - found, False))
    vertices = {"b": left[0].value, "a": total, "a'": right[0].value + right[1].value}
    scene = draw_polygon(left, right, vertices)
    (origin,) = dots(scene)
    for label in scene.labels:
        if label.symbol in vertices:
            off = label.centre - origin - vertices[label.symbol] * scene.scale
            beyond = (abs(off.x) - label.width / 2, abs(off.y) - label.height / 2)
            assert hypot(*(max(each, 0.0) for each in beyond)) <= FAR


def test_corners_have_the_letters_of_their_points() -> None:
    scene = draw_polygon(*TRIANGLE, {"a": A, "b": B, "c": Vector(1.0, 1.0), "d": Vector(0.0, 0.0)})
    assert symbols(scene) == ["a", "b", "o", "v_A", "v_B", "v_{BA}"]


def test_a_polygon_has_at_most_the_scale_of_the_others() -> None:
    alone = draw_polygon(*TRIANGLE)
    assert draw_polygon(*TRIANGLE, scale=alone.scale / 2).scale == alone.scale / 2
    assert draw_polygon(*TRIANGLE, scale=alone.scale * 10).scale == alone.scale


def test_the_origin_has_another_letter_where_a_corner_is_o() -> None:
    assert symbols(draw_polygon(*TRIANGLE, {"o": A, "b": B}))[:3] == ["b", "o", "p"]


def test_a_symbol_without_a_place_beside_its_arrow_is_led_to_it() -> None:
    # The second arrow is a twentieth of the others, both of its ends are corners
    tick = Vector(0.25, -0.1)
    right = [Arrow("v_1", A), Arrow(r"v_{2A}^{\mathrm{t}}", tick), Arrow("v_3", B - A)]
    total = B + tick
    scene = draw_polygon([Arrow("v", total)], right)
    ((start, foot),) = lines(scene, THIN)
    (led,) = [label for label in scene.labels if label.symbol.startswith("v_{2A}")]
    (origin,) = dots(scene)
    middle = origin + (A + tick * 0.5) * scene.scale
    assert hypot(*(foot - middle)) < 0.5 * hypot(*tick) * scene.scale
    assert hypot(*(start - led.centre)) < hypot(led.width, led.height) / 2 + 0.5
    assert scene.crowded == ()


def test_symbols_without_places_at_the_scale_of_the_others_have_a_larger_one() -> None:
    small = [
        Arrow(f"a_{{{n}A}}^{{\\mathrm{{t}}}}", Vector(cos(1.3 * n), sin(1.3 * n))) for n in range(8)
    ]
    total = sum((arrow.value for arrow in small), Vector(0.0, 0.0))
    alone = draw_polygon([Arrow("a", total)], small)
    shared = draw_polygon([Arrow("a", total)], small, scale=alone.scale / 2)
    assert shared.crowded == alone.crowded == ()
    assert shared.scale == alone.scale

"""Vectors on the mechanism: to one scale, at their points, beside the bars, with nothing else than
letters.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot

import pytest

from kinegrade.figure.back_ends.typst import write_typst
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.scene import BOLD, DASHED, FIRM, OPEN, THIN, Bow, Disc, Strokes
from kinegrade.figure.vectors import mechanism as vectors_on_mechanisms
from kinegrade.figure.vectors.arrows import VectorArrow
from kinegrade.figure.vectors.mechanism import (
    CROWDED,
    LARGE,
    LONGEST,
    PointArrow,
    add_symbols,
    draw_with_vectors,
    place_arrows,
)
from kinegrade.figure.vectors.plain_mechanism import PICTURE
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Turning
from kinegrade.problem.template.library.library import find_template_names, load_template
from tests.figure.clear import faults, heads, lines, symbols
from tests.figure.mechanisms import slider_crank
from tests.problem.draws import draw_filter, drawn

MECHANISM, HINTS = slider_crank(0.2, 1.75, 60)
AT_A, AT_B = MECHANISM.points["A"], MECHANISM.points["B"]
ALONG = (AT_A - MECHANISM.points["O"]) * (1 / 0.2)
ARROWS = [
    PointArrow("v_A", AT_A, ALONG.turned() * 2.0),
    PointArrow("v_B", AT_B, Vector(-1.0, 0.0), False),
]


def test_arrows_are_to_one_scale_and_start_at_their_points() -> None:
    long, short = place_arrows(ARROWS, 100.0)
    assert (long.symbol, short.symbol) == ("v_A", "v_B")
    assert hypot(*(long.end - long.start)) == pytest.approx(LONGEST)
    assert hypot(*(short.end - short.start)) == pytest.approx(LONGEST / 2)
    assert long.start == AT_A * 100.0
    assert not short.known


def test_the_letters_stay_and_the_givens_go() -> None:
    scene = draw_with_vectors(MECHANISM, HINTS, ARROWS)
    assert symbols(scene) == ["A", "B", "O", "v_A", "v_B"]
    assert faults(scene, PICTURE.width, PICTURE.height) == []


def test_an_arrow_along_a_bar_is_drawn_upon_it_and_the_bar_is_grey() -> None:
    along = PointArrow(r"a_{A}^{\mathrm{n}}", AT_A, ALONG * -3.0)
    (arrow,) = place_arrows([along], 100.0)
    assert arrow.aside == Vector(0.0, 0.0)
    parts = draw_with_vectors(MECHANISM, HINTS, [along]).primitives
    pens = [part.pen for part in parts if isinstance(part, Strokes)]
    assert {pen.ink for pen in pens if pen.width >= BOLD.width} == {"grey"}
    assert {pen.ink for pen in pens if pen.width < BOLD.width} == {"black"}


def test_arrows_come_out_from_under_the_pin_at_which_they_start() -> None:
    parts = draw_with_vectors(MECHANISM, HINTS, ARROWS).primitives
    last_shaft = max(
        place for place, part in enumerate(parts) if isinstance(part, Strokes) and part.pen == FIRM
    )
    assert "white" in [part.fill for part in parts[last_shaft:] if isinstance(part, Disc)]


def test_what_is_zero_or_too_short_is_left_out() -> None:
    arrows = [
        *ARROWS,
        PointArrow("v_O", Vector(0.0, 0.0), Vector(0.0, 0.0)),
        PointArrow("v_D", AT_A, Vector(0.1, 0.0)),
    ]
    assert symbols(draw_with_vectors(MECHANISM, HINTS, arrows)) == ["A", "B", "O", "v_A", "v_B"]


def test_without_vectors_the_bare_mechanism_is_drawn() -> None:
    assert symbols(draw_with_vectors(MECHANISM, HINTS, [])) == ["A", "B", "O"]


def test_an_arrow_that_would_end_at_the_point_of_another_is_shorter() -> None:
    mechanism, hints = slider_crank(0.2, 2.75, 60)
    crank = mechanism.points["A"] - mechanism.points["O"]
    scene = draw_with_vectors(mechanism, hints, [PointArrow("v_A", mechanism.points["A"], -crank)])
    assert hypot(*crank) * scene.scale == pytest.approx(LONGEST, abs=1.5)
    ((tip, *_),) = (head.corners for head in heads(scene))
    start, _ = min(lines(scene, FIRM), key=lambda line: hypot(*(line[1] - tip)))
    assert hypot(*(tip - start)) == pytest.approx(0.75 * LONGEST)


def test_many_arrows_at_one_point_are_longer_and_all_named() -> None:
    names = [rf"a_{{\mathrm{{{letter}}}}}" for letter in "aerC"]
    arrows = [
        PointArrow(name, AT_A, Vector(1.0 - number, 1.0 + number))
        for number, name in enumerate(names)
    ]
    longest = place_arrows(arrows, 100.0)[0]
    assert hypot(*(longest.end - longest.start)) == pytest.approx(CROWDED)
    scene = draw_with_vectors(MECHANISM, HINTS, arrows)
    assert set(names) < set(symbols(scene))
    assert faults(scene, PICTURE.width, PICTURE.height) == []


def test_arrows_to_all_sides_do_not_make_the_mechanism_small() -> None:
    sides = {"N": Vector(0.0, 1.0), "E": Vector(1.0, 0.0)}
    sides |= {"S": Vector(0.0, -1.0), "W": Vector(-1.0, 0.0)}
    arrows = [PointArrow(f"a_{name}", AT_A, side) for name, side in sides.items()]
    scene = draw_with_vectors(MECHANISM, HINTS, arrows)
    assert scene.scale > 0.6 * draw_with_vectors(MECHANISM, HINTS, []).scale
    assert faults(scene, LARGE.width, LARGE.height) == []


@pytest.mark.parametrize("sense", ["ccw", "cw"])
def test_a_rotation_has_its_sense(sense: str) -> None:
    turning = Turning(r"\omega_{AB}", "AB", sense)  # type: ignore[arg-type]
    scene = draw_with_vectors(MECHANISM, HINTS, ARROWS, [turning])
    (bow,) = (part for part in scene.primitives if isinstance(part, Bow) and part.pen != THIN)
    assert (bow.sweep > 0) == (sense == "ccw")
    assert r"\omega_{AB}" in symbols(scene)
    assert len(heads(scene)) == 2


def test_a_rotation_that_is_sought_is_dashed_like_the_vectors() -> None:
    turning = Turning(r"\omega_{AB}", "AB", "cw", sought=True)
    scene = draw_with_vectors(MECHANISM, HINTS, ARROWS[:1], [turning])
    (bow,) = (part for part in scene.primitives if isinstance(part, Bow) and part.pen != THIN)
    (head,) = (one for one in heads(scene, "white") if one.pen == OPEN)
    assert bow.pen == DASHED
    assert abs(hypot(*(head.corners[0] - bow.centre)) - bow.radius) < 0.01


@pytest.mark.sampled(8)
@pytest.mark.parametrize("name", find_template_names())
def test_velocities_and_accelerations_of_shipped_templates_are_clear(name: str) -> None:
    template = load_template(name)
    motion = drawn(draw_filter(template), 1)[0].solution.motion
    if not motion.rates:
        pytest.skip("a problem of pose alone")
    mechanism = motion.frames.mechanism.map(float)
    for letter, vector, rate in (
        ("v", motion.velocity, motion.omega),
        ("a", motion.acceleration, motion.alpha),
    ):
        bodies = {point: body.name for body in mechanism.bodies for point in body.points}
        arrows = [
            PointArrow(
                f"{letter}_{{{point}}}", mechanism.points[point], vector(point, body).map(float)
            )
            for point, body in bodies.items()
        ]
        rates = [
            (body.name, float(rate(body.name))) for body in mechanism.bodies if not body.particle
        ]
        turnings = [
            Turning(r"\omega", body, "ccw" if size > 0 else "cw") for body, size in rates if size
        ]
        scene = draw_with_vectors(mechanism, template.figure, arrows, turnings)
        assert faults(scene, LARGE.width, LARGE.height) == []
        assert write_typst(scene).startswith("#box(")


def test_labels_of_an_ordinary_picture_are_placed_once(monkeypatch: pytest.MonkeyPatch) -> None:
    rounds = []

    def count(layout: Layout, arrows: Sequence[VectorArrow]) -> Layout:
        rounds.append(len(arrows))
        return add_symbols(layout, arrows)

    monkeypatch.setattr(vectors_on_mechanisms, "add_symbols", count)
    draw_with_vectors(MECHANISM, HINTS, ARROWS)
    assert rounds == [len(ARROWS)]

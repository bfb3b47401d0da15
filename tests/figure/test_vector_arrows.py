"""Arrows are told apart: known from unknown, one from another on the same line, a symbol from its
neighbours'.
"""

from __future__ import annotations

import json

import numpy as np
import pytest
import typst

from kinegrade.figure.back_ends.typst import translate_symbol
from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.place import CLEARANCE
from kinegrade.figure.scene import DASHED, FIRM, Outline, Strokes
from kinegrade.figure.vectors.arrows import (
    VectorArrow,
    look_like_one,
    put_side_by_side,
)
from kinegrade.figure.vectors.symbols import rate_nearness_to_lines, wish_at_tip
from kinegrade.mechanics.vector import Vector

HERE, X = Vector(0.0, 0.0), Vector(10.0, 0.0)


def test_known_is_solid_and_filled_unknown_dashed_and_open() -> None:
    for known, pen, fill in ((True, FIRM, "black"), (False, DASHED, "white")):
        shaft, head = VectorArrow("v", HERE, X, known).primitives()
        assert isinstance(shaft, Strokes)
        assert isinstance(head, Outline)
        assert (shaft.pen, head.fill) == (pen, fill)
        assert head.corners[0] == X


def test_a_short_arrow_keeps_a_shaft() -> None:
    shaft, head = VectorArrow("v", HERE, Vector(1.0, 0.0)).primitives()
    assert isinstance(shaft, Strokes)
    assert isinstance(head, Outline)
    assert head.corners[1].x == pytest.approx(0.4)
    assert shaft.lines[0][0] == HERE


@pytest.mark.parametrize(
    ("start", "end", "one"),
    [
        (Vector(2.0, 0.0), Vector(7.0, 0.0), True),
        (Vector(7.0, 0.0), Vector(2.0, 0.0), True),  # doubling back
        (Vector(10.0, 0.0), Vector(20.0, 0.0), False),  # tip to tail
        (HERE, Vector(-10.0, 0.0), False),
        (HERE, Vector(10.0, 0.8), True),  # nearly on it
        (HERE, Vector(10.0, 2.0), False),
        (Vector(0.0, 1.5), Vector(10.0, 1.5), False),
        (Vector(5.0, -5.0), Vector(5.0, 5.0), False),
    ],
)
def test_lines_look_like_one_when_they_run_close_over_a_stretch(
    start: Vector, end: Vector, one: bool
) -> None:
    assert look_like_one((HERE, X), (start, end)) is one
    assert look_like_one((start, end), (HERE, X)) is one


def test_arrows_on_one_line_stand_side_by_side_on_its_upper_side() -> None:
    first, second, third = put_side_by_side(
        [
            VectorArrow("a", HERE, X),
            VectorArrow("b", X, HERE),
            VectorArrow("c", HERE, Vector(0.0, 5.0)),
        ],
        (2.0,),
    )
    assert (first.aside, second.aside, third.aside) == (HERE, Vector(0.0, 2.0), HERE)


def test_without_any_room_an_arrow_stays_where_it_belongs() -> None:
    _, second = put_side_by_side([VectorArrow("a", HERE, X), VectorArrow("b", HERE, X)], (0.3,))
    assert second.aside == HERE


def test_arrows_of_one_point_and_direction_stay_there_where_their_tips_are_apart() -> None:
    long, short = VectorArrow("a", HERE, X), VectorArrow("b", HERE, X * 0.5)
    almost = VectorArrow("c", HERE, X * 0.9)
    placed = put_side_by_side([long, short, almost], (1.5,), nested=True)
    assert [arrow.aside for arrow in placed] == [HERE, HERE, Vector(0.0, 1.5)]
    label = wish_at_tip(short, [long, short])
    assert label.demerits is not None
    assert not label.demerits[:8].all()


def test_a_symbol_is_to_be_nearer_to_its_own_arrow() -> None:
    spots = np.array([[5.0, 2.0], [5.0, 8.0], [5.0, 5.0]])
    assert rate_nearness_to_lines(
        "v", spots, [(HERE, X)], [(Vector(0.0, 10.0), Vector(10.0, 10.0))]
    ).tolist() == [0.0, 1.0, 1.0]
    assert rate_nearness_to_lines("v", spots, [(HERE, X)], []).tolist() == [0.0, 0.0, 0.0]


SYMBOLS = [
    "v_{BA}",
    r"a_{BA}^{\mathrm{n}}",
    r"a_{\mathrm{Cor}}",
    r"\omega_{AB}",
    r"\alpha_{AB}",
    r"a_{\mathrm{e}}^{\mathrm{t}}",
    r"a_{O_1A}^{\mathrm{n}}",
    r"a_{A'B}^{\mathrm{t}}",
    r"\boldsymbol{v}_{BA}",
    r"\boldsymbol{a}_{BA}^{\mathrm{n}}",
    r"\boldsymbol{\omega}_{AB}",
    r"\boldsymbol{M}",
    r"P_{\infty}",
    r"v_{\mathrm{r}2}",
    "o",
]


def test_the_room_estimated_for_vectors_holds_them_and_is_not_wasted() -> None:
    measured = ",".join(f"measure({translate_symbol(symbol)})" for symbol in SYMBOLS)
    page = f"#set text(size: 9pt)\n#context [#metadata(({measured}).map(s => s.width.mm()))<size>]"
    found = json.loads(typst.query(page.encode(), "<size>", field="value", one=True))
    for symbol, width in zip(SYMBOLS, found, strict=True):
        assert width <= measure_symbol(symbol)[0] + CLEARANCE, symbol
        assert measure_symbol(symbol)[0] < 1.4 * width + 1.0, symbol


def test_scripts_of_one_base_stand_above_each_other() -> None:
    assert measure_symbol(r"a_{BA}^{\mathrm{n}}")[0] == measure_symbol("a_{BA}")[0]
    assert measure_symbol(r"a_{BA}^{\mathrm{n}}")[1] > measure_symbol("a_{BA}")[1]

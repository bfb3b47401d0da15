"""What a figure marks of the givens follows from the inputs and from what is printed."""

from __future__ import annotations

import dataclasses
from collections.abc import Collection
from pathlib import Path

import pytest
from msgspec.structs import replace

from kinegrade.problem.template.given_marks import mark_givens
from kinegrade.problem.template.hints import Angle, Axes, FigureHints, Length, Moving, Turning
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.translated import Translated
from tests.problem.crank import crank

FASTER = ('velocity = "omega"', 'velocity = "-omega", acceleration = "h"')


def test_each_rate_that_is_a_parameter_has_one_arrow_with_its_symbol() -> None:
    assert mark_givens(crank()).arrows == (Turning(r"\omega", "OA"),)
    assert mark_givens(crank(FASTER, kept=True)).arrows == (
        Turning(r"\omega", "OA"),
        Turning("h", "OA", None, "acceleration"),
    )


def test_a_driven_point_has_its_arrow_at_the_point() -> None:
    moved = crank(("OA turns", "A of OA moves along +x"), kept=True)
    assert mark_givens(moved).arrows == (Moving(r"\omega", "A", driver=0),)


def test_what_turns_relative_to_a_body_is_marked_so() -> None:
    two = crank(
        ('OA = "O A"', 'OA = "O A"\nOP = "O P"'),
        ('"pin O: ground OA"', '"pin O: ground OA", "pin O: ground OP"'),
        (
            'motion = "OA turns", velocity = "omega"',
            'motion = "OA turns relative to OP", velocity = "omega" }, { motion = "OP turns", velocity = "3"',
        ),
    )
    assert mark_givens(two).arrows == (Turning(r"\omega", "OA", None, "velocity", "OP"),)


def hinted(*arrows: Turning | Moving, rate: str = "omega") -> tuple[Turning | Moving, ...]:
    """The arrows of the crank turned at a rate, with an author's hints."""
    template = crank(('velocity = "omega"', f'velocity = "{rate}"'))
    return mark_givens(replace(template, figure=FigureHints(arrows=arrows))).arrows


def test_a_hint_for_an_input_gives_its_symbol_and_never_the_sense() -> None:
    assert hinted(Turning("w", "OA", "cw")) == (Turning("w", "OA"),)
    assert hinted(Turning("2w", "OA", "cw"), rate="2*omega") == (Turning("2w", "OA"),)


def test_a_rate_of_several_factors_without_a_hint_has_no_arrow() -> None:
    assert hinted(rate="2*omega") == ()


def test_a_hint_for_what_no_input_moves_stands_as_it_is() -> None:
    free = Moving("u", "A", "left")
    assert hinted(free) == (Turning(r"\omega", "OA"), free)


def led(*arrows: Turning | Moving) -> list[tuple[str, int | None]]:
    """The symbols of the arrows of a point that is led along x at v and along y at w, and the
    inputs whose motion they show, with an author's hints.
    """
    path = Path(__file__).parents[1] / "authored" / "led-arm.toml"
    template = read_template("led-arm", path.read_text(encoding="utf-8"))
    figure = dataclasses.replace(template.figure, arrows=arrows)
    marked = replace(template, figure=figure)
    shown = mark_givens(marked).arrows
    return [(each.symbol, each.driver) for each in shown if isinstance(each, Moving)]


@pytest.mark.parametrize("symbol", ["u", "w"])
def test_a_hint_for_one_of_two_motions_of_a_point_is_that_of_its_symbol(symbol: str) -> None:
    """The first arrow took the hint of the second: both were labelled w."""
    assert led(Moving(symbol, "P", "up")) == [("u", 0), ("w", 1)]


def test_hints_for_two_motions_of_a_point_have_one_input_each() -> None:
    assert led(Moving("w", "P"), Moving("u", "P")) == [("u", 0), ("w", 1)]
    assert led(Moving("w", "P"), Moving("u_x", "P")) == [("u_x", 0), ("w", 1)]


def axes_for(*changes: tuple[str, str], asked: Collection[str] | None = None) -> Axes | None:
    return mark_givens(crank(*changes), asked=asked).axes


HEIGHT = ('quantity = "y(velocity(A))", unit = "m/s"', 'quantity = "y(A)", unit = "m"')
SPEED = (
    'quantity = "x(velocity(A))", unit = "m/s", sign = "+x"',
    'quantity = "magnitude(velocity(A))", unit = "m/s", sign = "magnitude"',
)


def test_components_have_a_small_frame_and_coordinates_axes_at_the_origin() -> None:
    assert axes_for() == "aside"
    assert axes_for(HEIGHT, asked=["v_y"]) == "origin"
    assert axes_for(HEIGHT) == "aside"  # asked only where a bank names it
    assert axes_for(SPEED, ('gives = { v_x = "-omega*h" }', 'gives = { v_x = "omega*r" }')) is None


def test_an_x_axis_that_the_statement_names_is_drawn_and_lettered() -> None:
    still = SPEED, ('gives = { v_x = "-omega*h" }', 'gives = { v_x = "omega*r" }')
    assert axes_for(*still) is None
    named = replace(crank(*still).words, statement=Translated(plain="The $x$ axis points right."))
    assert mark_givens(replace(crank(*still), words=named)).axes == "aside"


def test_the_author_may_want_axes_at_the_origin_or_aside() -> None:
    assert axes_for(("[asks]", '[figure]\naxes = "origin"\n[asks]')) == "origin"
    assert axes_for(("[asks]", '[figure]\naxes = "aside"\n[asks]'), asked=[]) == "aside"


def test_a_given_coordinate_has_axes_at_the_origin_unless_it_is_not_printed() -> None:
    negative = ('draw = [0, "1/2", 3]', 'draw = [0, "-1/2", 3]')
    assert axes_for(negative, asked=[]) == "origin"
    assert mark_givens(crank(negative), {"r", "omega"}, []).axes is None


def test_what_may_be_negative_is_marked_with_its_sense() -> None:
    template = crank(('draw = [0, "1/2", 3]', 'draw = [0, "-1/2", 3]'))
    lengths = (Length("h", "O", "P"), Length("r", "O", "A"))
    figure = FigureHints(lengths=lengths, angles=(Angle("h", "O", "up", "A"),))
    marked = mark_givens(replace(template, figure=figure))
    assert [mark.signed for mark in (*marked.lengths, *marked.angles)] == [True, False, True]


def test_a_length_whose_side_is_said_in_words_is_no_coordinate() -> None:
    told = crank(
        ('draw = [0, "1/2", 3]', 'draw = [0, "-1/2", 3]'),
        ("{{ h.value }} above", "{{ h.size }} {{ side }}"),
        ("高于 $O$ {{ h.value }}", "在 $O$ {{ side }} {{ h.size }}"),
        (
            "[parameters]",
            '[text]\nside = [{ if = "h > 0", en = "above", zh = "上方" }, { en = "below", zh = "下方" }]'
            "\n\n[parameters]",
        ),
    )
    figure = FigureHints(lengths=(Length("h", "O", "P"),))
    [length] = mark_givens(replace(told, figure=figure)).lengths
    assert not length.signed
    assert mark_givens(told, asked=[]).axes is None


def test_marks_of_what_is_not_printed_are_left_out() -> None:
    template = crank()
    lengths = (
        Length("r", "O", "A"),
        Length("2 r", "O", "A"),
        Length("r h", "O", "P"),
        Length("AB", "O", "P"),
    )
    marked = replace(template, figure=dataclasses.replace(template.figure, lengths=lengths))
    without_r = mark_givens(marked, {"h", "omega"})
    assert [length.symbol for length in without_r.lengths] == ["r h", "AB"]
    assert mark_givens(marked, {"r", "h"}).arrows == ()
    assert mark_givens(marked).lengths == lengths

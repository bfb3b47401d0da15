"""Dimension lines go round what they measure and start at its ends; a symbol beside a line that
joins the two points replaces one that has no clear place.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from msgspec.structs import replace

from kinegrade.figure.marks.lengths.dimension_lines import DimensionLine
from kinegrade.figure.marks.lengths.dimensions import add_length
from kinegrade.figure.marks.lengths.extension_gaps import Around
from kinegrade.figure.marks.names import keep_from_marks
from kinegrade.figure.marks.turning_arrow import TurningArrow
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.obstacles import Obstacles
from kinegrade.figure.placing.place import Wish
from kinegrade.figure.scene import BOLD, FIRM, THIN, Bow, Disc, Label, Outline, Primitive, Strokes
from kinegrade.figure.symbols.pins import STAND, draw_pivot
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import Length, Turning
from tests.figure.clear import heads

A, B = Vector(-20.0, 0.0), Vector(20.0, 0.0)
AB = {"A": A, "B": B}
DOWN = Vector(0.0, -1.0)
ROD = Strokes(((A, B),), BOLD)
# Firm lines on both sides of the rod, which every dimension line of AB has to cross
FENCES = Strokes(tuple((Vector(15.0, level), Vector(25.0, level)) for level in (5.0, -5.0)), FIRM)


def _add(
    length: Length,
    drawn: Iterable[Primitive],
    ground: Iterable[Primitive] = (),
    marks: Iterable[Primitive] = (),
) -> Layout:
    ground, layout = tuple(ground), Layout.of((*drawn, *ground))
    marked = layout.drawn(tuple(marks))
    return add_length(marked, AB, length, Around(layout.obstacles, Obstacles.of(ground)))


def _find_extensions(layout: Layout) -> list[tuple[Vector, Vector]]:
    """The thin vertical lines of a mark that was added last."""
    lines = [line for each in layout.lines if isinstance(each, Strokes) for line in each.lines]
    return [(start, end) for start, end in lines[-3:] if abs(start.x - end.x) < 1e-9]


def test_a_dimension_line_goes_round_a_large_wheel() -> None:
    marked = _add(Length("d", "A", "B"), (Disc(Vector(0.0, 0.0), 18.0, BOLD),))
    tips = [head.corners[0] for head in heads(marked)]
    assert [round(tip.x, 6) for tip in tips] == [-20.0, 20.0]
    assert [tip for tip in tips if not abs(tip.y) > 18.0] == []
    assert marked.crowded == ()


def test_extension_lines_start_at_their_points_and_keep_off_a_bar_in_between() -> None:
    bar = Strokes(((Vector(-30.0, 5.0), Vector(30.0, 4.0)),), BOLD)
    for start, end in _find_extensions(_add(Length("d", "A", "B"), (bar,))):
        assert 0.85 < abs(start.y) < 2.0
        assert end.y < 0


def test_an_extension_line_does_not_begin_in_a_letter() -> None:
    [free, _] = _find_extensions(_add(Length("d", "A", "B"), ()))
    side = 1.0 if free[1].y > 0 else -1.0
    letter = Label("C", Vector(B.x + 0.5, side * 3.0), 2.0, 2.0)
    layout = replace(Layout.of((letter,)), labels=(letter,))
    bare = Obstacles.of(())
    moved = add_length(layout, AB, Length("d", "A", "B"), Around(bare, bare))
    assert [end.y * side < 0 for _, end in _find_extensions(moved)] == [True, True]


def test_a_dimension_line_keeps_off_a_letter_that_it_would_own() -> None:
    bare = Obstacles.of(())
    [free, _] = _find_extensions(_add(Length("d", "A", "B"), ()))
    letter = Label("C", Vector(0.0, free[1].y + 2.0), 2.0, 2.0)
    layout = replace(Layout.of((letter,)), labels=(letter,))
    moved = add_length(layout, AB, Length("d", "A", "B"), Around(bare, bare))
    assert [end.y * free[1].y < 0 for _, end in _find_extensions(moved)] == [True, True]


def test_extension_lines_start_outside_the_supports_of_their_points() -> None:
    ground = (*draw_pivot(A, DOWN * STAND), *draw_pivot(B, DOWN * STAND))
    bar = Strokes(((Vector(-30.0, 5.0), Vector(30.0, 4.0)),), BOLD)
    for start, _ in _find_extensions(_add(Length("d", "A", "B"), (bar,), ground)):
        assert -6.5 < start.y < -5.1


def test_an_extension_line_does_not_begin_between_the_strokes_of_hatching() -> None:
    strokes = tuple(
        (Vector(at.x + aside, -3.2), Vector(at.x + aside, -5.2))
        for at in (A, B)
        for aside in (-0.6, 0.6)
    )
    bar = Strokes(((Vector(-30.0, 5.0), Vector(30.0, 4.0)),), BOLD)
    for start, _ in _find_extensions(
        _add(Length("d", "A", "B"), (bar,), (Strokes(strokes, THIN),))
    ):
        assert start.y < -5.2


def test_a_dimension_line_stands_short_of_guides_beside_a_broad_bar() -> None:
    guides = Strokes(
        tuple((Vector(-30.0, level), Vector(30.0, level)) for level in (6.6, -6.6)), FIRM
    )
    for _, end in _find_extensions(_add(Length("d", "A", "B"), (guides,))):
        assert abs(end.y) < 6.6


def test_parallel_dimension_lines_stand_apart() -> None:
    points = {**AB, "C": Vector(-20.0, 1.3), "D": Vector(5.0, 1.3)}
    layout = Layout.of((Strokes(((Vector(-25.0, -2.0), Vector(25.0, -2.0)),), BOLD),))
    for ends in ("AB", "CD"):
        length = Length(ends.lower(), *ends)
        layout = add_length(layout, points, length, Around(layout.obstacles, Obstacles((), ())))
    levels = sorted({round(head.corners[0].y, 6) for head in heads(layout)})
    assert len(levels) == 2
    assert levels[1] - levels[0] > 3.5


def test_a_thin_line_between_the_points_takes_the_symbol_where_a_dimension_would_cross() -> None:
    leg = Strokes(((A, B),), THIN)
    length = Length("d", "A", "B")
    assert len(heads(_add(length, (), marks=(leg,)))) == 2
    plain = _add(length, (FENCES,), marks=(leg,))
    [label] = plain.labels
    assert heads(plain) == []
    assert abs(label.centre.y) < 3.0


def test_a_part_of_a_bar_is_dimensioned_if_a_dimension_crosses_no_bar() -> None:
    longer = Strokes(((A, Vector(40.0, 0.0)),), BOLD)
    across = [Strokes(((Vector(10.0, level), Vector(30.0, level)),), BOLD) for level in (5.0, -5.0)]
    length = Length("d", "A", "B")
    assert len(heads(_add(length, (longer,)))) == 2
    plain = _add(length, (longer, *across))
    assert heads(plain) == []
    assert abs(plain.labels[0].centre.y) < 3.0


def test_the_halves_of_a_rod_take_their_symbol_alone() -> None:
    at, around = {**AB, "M": Vector(0.0, 0.0)}, Around(Obstacles.of((ROD,)), Obstacles.of(()))
    halves = Length("l/2", "A", "M"), Length("l/2", "M", "B")
    for half in halves:
        assert heads(add_length(Layout.of((ROD,)), at, half, around)) != []
        assert heads(add_length(Layout.of((ROD,)), at, half, around, halves)) == []
    unlike = (halves[0], Length("r", "M", "B"))
    assert heads(add_length(Layout.of((ROD,)), at, halves[0], around, unlike)) != []


def test_the_symbol_of_a_dimension_does_not_seem_to_name_a_pin_beside_it() -> None:
    bare, line = Obstacles.of(()), Length("d", "A", "B")
    [free] = _add(line, ()).labels
    for side in (-2.5, 2.5):
        pin = free.centre + Vector(0.0, side)
        marked = add_length(Layout.of(()), {**AB, "C": pin}, line, Around(bare, bare))
        assert abs(marked.labels[-1].centre.y - pin.y) > 3.5


def test_a_rod_between_the_points_takes_the_symbol_alone() -> None:
    plain = _add(Length("d", "A", "B"), (ROD,))
    assert heads(plain) == []
    assert abs(plain.labels[0].centre.y) < 3.0


def test_extension_lines_cross_an_outline_rather_than_the_dimension_line() -> None:
    upright = Strokes(
        tuple((Vector(0.0, 2.0 * side), Vector(0.0, 9.0 * side)) for side in (1, -1)), FIRM
    )
    level = Strokes(
        tuple((Vector(15.0, 9.5 * side), Vector(25.0, 9.5 * side)) for side in (1, -1)), FIRM
    )
    for _, end in _find_extensions(_add(Length("d", "A", "B"), (upright, level))):
        assert abs(end.y) > 10.0


def test_a_dimension_crosses_an_outline_rather_than_the_arrow_of_a_motion() -> None:
    lower = Strokes(
        tuple(
            (Vector(15.0, level), Vector(25.0, level)) for level in (-4.8, -4.5, -4.2, -3.9, -3.6)
        ),
        FIRM,
    )
    arrow = TurningArrow(Bow(A, 5.0, 1.2, 1.3, THIN), Turning(r"\omega", "b"), 0.0)
    layout = Layout.of((lower,))
    for marked, sign in ((layout, 1.0), (layout.chosen([arrow])[0], -1.0)):
        found = add_length(
            marked, AB, Length("d", "A", "B"), Around(layout.obstacles, Obstacles.of(()))
        )
        assert {sign * end.y > 0 for _, end in _find_extensions(found)} == {True}


def test_two_dimensions_along_a_bar_stand_in_one_line_where_their_heads_meet() -> None:
    at = {"A": A, "M": Vector(0.0, 0.0), "B": B, "N": Vector(0.0, -9.0)}
    around = Around(Obstacles.of((ROD,)), Obstacles.of(()))
    layout = Layout.of((ROD, Strokes(((at["M"], at["N"]),), BOLD)))
    for length in (Length("c", "M", "A"), Length("d", "M", "B")):
        layout = add_length(layout, at, length, around)
    tips = [head.corners[0] for head in heads(layout)]
    assert len({round(tip.y, 6) for tip in tips}) == 1
    assert sorted(round(tip.x, 6) for tip in tips) == [-20.0, 0.0, 0.0, 20.0]


CROSSED = DimensionLine((A, B), (Vector(-20.0, 6.0), Vector(20.0, 6.0)), "d", 0.0, (1.6, 1.6))


def test_an_extension_line_that_cuts_another_dimension_line_is_told_from_one_beside_it() -> None:
    upward = DimensionLine(
        (Vector(0.0, 0.0), Vector(0.0, 14.0)),
        (Vector(9.0, 0.0), Vector(9.0, 14.0)),
        "h",
        0.0,
        (1, 1),
    )
    across = replace(
        CROSSED, points=(Vector(0.0, 0.0), B), feet=(Vector(0.0, 9.0), Vector(20.0, 9.0))
    )
    assert upward.cuts(CROSSED) is True
    assert CROSSED.cuts(upward) is True
    assert across.cuts(CROSSED) is True
    assert (
        replace(across, points=(A, B), feet=(Vector(-20.0, 9.0), Vector(20.0, 9.0))).cuts(CROSSED)
        is False
    )


def test_an_extension_line_does_not_seem_to_begin_at_a_point_beside_it() -> None:
    [free, _] = _find_extensions(_add(Length("d", "A", "B"), ()))
    side = 1.0 if free[1].y > 0 else -1.0
    bare = Obstacles.of(())
    at = AB | {"E": Vector(B.x + 1.5, side * 4.0)}
    moved = add_length(Layout.of(()), at, Length("d", "A", "B"), Around(bare, bare))
    assert [end.y * side < 0 for _, end in _find_extensions(moved)] == [True, True]


def test_a_dimension_keeps_off_the_mark_of_a_right_angle() -> None:
    [free, _] = _find_extensions(_add(Length("d", "A", "B"), ()))
    side = 1.0 if free[1].y > 0 else -1.0
    square = Outline(
        (Vector(17.4, 0.0), Vector(17.4, side * 2.6), Vector(20.4, side * 2.6)), THIN, closed=False
    )
    moved = _add(Length("d", "A", "B"), (), marks=(square,))
    assert [end.y * side < 0 for _, end in _find_extensions(moved)] == [True, True]


def test_a_letter_does_not_stand_beyond_a_dimension_line() -> None:
    wish = Wish("A", np.array([[0.0, 8.0]]), names=Vector(0.0, 3.0))
    kept = keep_from_marks(wish, [CROSSED])
    assert kept.walls == (CROSSED.line(),)


def test_the_letter_of_a_dimension_near_a_pin_stands_on_the_side_without_pins() -> None:
    pin = Vector(19.0, 0.0)
    for start, end in ((0.0, 40.0), (40.0, 0.0)):
        points, feet = ((Vector(start, y), Vector(end, y)) for y in (-8.0, 5.0))
        mark = DimensionLine(points, feet, "d", 1.0, (0.0, 0.0), pins=(pin,))
        wish = mark.wish()
        assert wish.demerits is not None
        below = wish.spots[:, 1] < 5.0
        assert min(wish.demerits[below]) > 0 == min(wish.demerits[~below])
        far = replace(mark, pins=(Vector(19.0, -9.0),)).wish().demerits
        assert far is not None
        assert max(far) == 0

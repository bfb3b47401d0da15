"""How worked solutions are laid out before any typesetter sees them: what stands on one line, what
beside which drawing.
"""

from __future__ import annotations

import pytest

from kinegrade.figure.scene import Scene
from kinegrade.figure.vectors.polygon import draw_polygon
from kinegrade.language.math.tree import LineBreak, Mark, Row, list_nodes
from kinegrade.press.sheet import WorkedQuestion
from kinegrade.press.solutions.chains import Placed, chain_blocks, join_sentences
from kinegrade.press.solutions.course import TextArea, arrange_courses
from kinegrade.press.solutions.drawing_rows import DrawingRow
from kinegrade.press.solutions.equations import MeasuredDisplay, arrange_equations, measure_display
from kinegrade.press.solutions.settings import (
    EM,
    TIGHT,
    Column,
    EquationGroups,
    Paragraph,
    Setting,
    Terms,
    fits,
)
from kinegrade.press.solutions.terms import arrange_terms
from kinegrade.worked.document import Block, Display, Heading, Picture, Pictures, Prose
from tests.press.solutions import long_equation, polygon_scene
from tests.worked.telling import read_display

PAGE = Column(174.0, "latin")
SAID = Prose("The point $A$ moves to the right along the guide.")
LONG_SAID = Prose(" ".join([SAID.text] * 8))
SHORT, LONG = r"v_A &= 2", "x &= " + " + ".join(["a_{BA}"] * 40)


def rows(lines: list[str], room: float) -> list[Row]:
    """The rows of all groups."""
    groups = arrange_equations(measure(lines), room)
    return [row for group in groups for row in group.rows]


def course(
    *blocks: Block, figure: Scene | None = None, height: float = 260.0
) -> list[Setting | DrawingRow]:
    """The parts of a question with these blocks, without its statement."""
    question = WorkedQuestion(1, "q1", "A crank", "It turns.", blocks, figure)
    (parts,) = arrange_courses([question], TextArea(PAGE, height)).parts
    return list(parts)[0 if figure else 1 :]


def measure(lines: list[str]) -> MeasuredDisplay:
    return measure_display(read_display(lines))


def pictures(count: int) -> Pictures:
    return Pictures((Picture(polygon_scene(), "velocity polygon"),) * count)


def test_short_equations_stand_on_one_row_as_far_as_there_is_room() -> None:
    assert len(rows([SHORT] * 3, 40.0)) == 1
    assert len(rows([SHORT] * 3, 12.0)) == 2
    assert len(rows([SHORT] * 3, 5.0)) == 3


def test_rows_are_aligned_at_their_first_relation() -> None:
    aligned = rows([SHORT, LONG, SHORT], 20.0)
    assert len(aligned) > 3
    assert {row.count(Mark()) for row in aligned} == {1}


def test_a_line_that_goes_on_with_a_relation_continues_the_one_before() -> None:
    assert len(rows([r"v &= a", r"&= b", r"&\approx 2"], 40.0)) == 1


def test_an_equation_with_a_long_left_side_is_not_aligned_with_others() -> None:
    left = " + ".join(["a"] * 12)
    groups = arrange_equations(measure([f"{left} &= b", SHORT]), 40.0)
    assert [len(group.rows) for group in groups] == [1, 1]
    broken = arrange_equations(measure([f"{left} &= {left}"]), 20.0)
    assert [row[0] for row in broken[0].rows] == [Mark()] * len(broken[0].rows)
    assert len(broken[0].rows) > 2


def test_a_piece_wider_than_the_room_is_reported() -> None:
    (group,) = arrange_equations(measure([r"x &= \sqrt{" + "a" * 60 + "}"]), 20.0)
    assert not group.fits


def test_an_equation_stands_on_the_line_of_its_sentence_where_both_have_room() -> None:
    (together,) = course(Prose("So"), read_display([SHORT]))
    assert isinstance(together, Setting)
    assert isinstance(together.body, Paragraph)
    assert together.body.equation
    said, shown = course(LONG_SAID, read_display([SHORT]))
    assert isinstance(said, Setting)
    assert said.stays
    assert isinstance(shown, Setting)
    assert isinstance(shown.body, EquationGroups)


def test_a_heading_runs_into_its_sentence() -> None:
    (part,) = course(Heading("Positions", 1), SAID)
    assert isinstance(part, Setting)
    assert part.body == Paragraph(Heading("Positions", 1), SAID.text)


def test_sentences_become_a_paragraph_up_to_one_that_announces_an_equation() -> None:
    said, announced = Prose("So."), Prose("Projected:")
    one_line = read_display([SHORT])
    assert list(join_sentences([said, said, announced, one_line])) == [
        Prose("So. So."),
        announced,
        one_line,
    ]
    assert list(join_sentences([Prose("因此。"), Prose("于是")])) == [Prose("因此。于是")]


def test_the_statement_stands_beside_the_figure_and_so_does_what_has_room_there() -> None:
    row, *others = course(SAID, *[Heading("Step", 2), LONG_SAID] * 8, figure=polygon_scene())
    assert isinstance(row, DrawingRow)
    assert len(row.beside) > 1
    assert others


@pytest.mark.parametrize("height", range(80, 200, 8))
def test_a_statement_stays_with_its_figure_wherever_the_page_ends(height: float) -> None:
    # the statement was set at the end of one page, and its figure on the next
    first = WorkedQuestion(1, "q1", "A crank", "It turns.", (LONG_SAID,) * 3, None)
    second = WorkedQuestion(2, "q2", "A rod", LONG_SAID.text, (LONG_SAID, SAID), polygon_scene())
    _, (row, *_) = arrange_courses([first, second], TextArea(PAGE, height)).parts
    assert isinstance(row, DrawingRow)
    assert row.whole
    assert row.beside[0].body == Paragraph(None, LONG_SAID.text)


def test_text_beside_drawings_ends_at_the_next_chapter() -> None:
    parts = course(pictures(1), SAID, Heading("Accelerations", 1), SAID)
    row = parts[0]
    assert isinstance(row, DrawingRow)
    assert [setting.body for setting in row.beside] == [Paragraph(None, SAID.text)]
    assert len(parts) == 2


def test_drawings_without_text_stand_side_by_side() -> None:
    (row,) = course(pictures(2))
    assert isinstance(row, DrawingRow)
    assert len(row.drawings) == 2
    assert row.beside == ()


def test_a_heading_before_drawings_stands_beside_them() -> None:
    row, *_ = course(Heading("1. The rod", 2), pictures(1), SAID)
    assert isinstance(row, DrawingRow)
    assert row.beside[0].body == Paragraph(Heading("1. The rod", 2), SAID.text)
    heading, *_ = course(Heading("1. The rod", 2), pictures(1))
    assert isinstance(heading, Setting)


def test_a_table_of_many_terms_has_narrower_columns_then_further_bands() -> None:
    assert len(arrange_terms(long_equation(3), 168.0)) == 1
    bands = arrange_terms(long_equation(9), 168.0)
    assert len(bands) > 1
    widths = [sum(column.width for column in band) for band in bands]
    assert max(widths) < 168.0
    narrow = arrange_terms(long_equation(2), 30.0)
    assert [len(band) for band in narrow] == [1, 1]


def test_a_table_beside_a_drawing_is_whole() -> None:
    wide = next(chain_blocks([long_equation(9)]))
    narrow = next(chain_blocks([long_equation(2)]))
    assert isinstance(wide, tuple)
    assert isinstance(narrow, tuple)
    assert [each for each in Column(60.0, "latin").set_chain(wide) if not fits(each)]
    set_narrow = list(PAGE.set_chain(narrow))
    assert set_narrow
    assert [each for each in set_narrow if not fits(each)] == []


def test_text_goes_on_above_drawings_that_have_no_room_on_the_page() -> None:
    said = [SAID, read_display([LONG])] * 3
    roomy, narrow = (course(*said, pictures(1), *said, height=height) for height in (260.0, 120.0))
    assert find_drawings(narrow) > find_drawings(roomy)
    assert len(narrow) >= len(roomy)


def find_drawings(parts: list[Setting | DrawingRow]) -> int:
    """The place of the first row of drawings."""
    return [isinstance(part, DrawingRow) for part in parts].index(True)


def test_a_high_equation_beside_its_sentence_has_room_above_and_below() -> None:
    # the fraction of an angle's tangent ran into the lines around it
    low, high = (
        course(Prose("It is:"), read_display((line,)))[0]
        for line in (r"x &= 1", r"x &= \frac{1}{2}")
    )
    assert isinstance(low, Setting)
    assert isinstance(high, Setting)
    assert isinstance(low.body, Paragraph)
    assert isinstance(high.body, Paragraph)
    assert (low.body.is_tall, high.body.is_tall) == (False, True)
    assert high.height > low.height + 2


def test_closer_blocks_and_lines_take_less_room_but_a_line_is_as_high_as_before() -> None:
    usual, tight = Column(174.0, "latin"), Column(174.0, "latin", TIGHT)
    once, often = ((Placed(said, stays=False),) for said in (SAID, LONG_SAID))
    saved = [
        usual.set_chain(said)[0].height - tight.set_chain(said)[0].height for said in (once, often)
    ]
    assert saved[0] == pytest.approx(0.3 * 1.7)  # of the gap below, nothing of the line
    lines = round((usual.set_chain(often)[0].height - usual.set_chain(once)[0].height) / 1.27 / EM)
    assert saved[1] - saved[0] == pytest.approx(lines * 0.15 * 0.62 * EM)


def test_a_table_stands_beside_its_drawings_where_that_takes_less_of_the_page() -> None:
    """Where what follows from the table is too wide, nothing stood beside the drawings."""
    row, *_ = course(SAID, long_equation(2), pictures(1), SAID)
    assert isinstance(row, DrawingRow)
    assert [type(setting.body) for setting in row.beside] == [Paragraph, Terms, Paragraph]


def test_a_table_too_wide_stays_above_its_drawings() -> None:
    """It stood at the foot of a page, and all that is done with it on the next."""
    table, *others = course(long_equation(5), pictures(1), SAID)
    assert isinstance(table, Setting)
    assert table.stays
    assert isinstance(others[0], DrawingRow)


def test_equations_go_on_on_the_next_page_rather_than_leave_one_half_empty() -> None:
    rows = read_display([LONG.replace("x", name) for name in "xyz"])
    question = WorkedQuestion(1, "q1", "A crank", "It turns.", (SAID, rows), None)
    parted, whole = (
        arrange_courses([question], TextArea(PAGE, 40.0, parts_chains=parts)).pages
        for parts in (True, False)
    )
    assert parted < whole - 0.05


def test_a_long_paragraph_goes_on_on_the_next_page_with_the_equation_it_announces() -> None:
    """A page ended a sixth early before the angles that a projection takes."""
    said = [SAID, read_display([LONG])]
    angles = [Prose(" ".join([SAID.text] * 12)), read_display([LONG])]
    parts = course(*said, pictures(1), *angles, *said, height=62.0)
    assert find_drawings(parts) > find_drawings(course(*said, pictures(1), *angles, *said))


def test_the_givens_of_a_chapter_stay_with_its_first_step() -> None:
    """The heading of the accelerations stood alone with them at the foot of a page."""
    given = [Prose("Given:"), read_display([SHORT])]
    opening, step = Heading("Accelerations", 1), [Heading("1. The rod", 2), SAID]
    *stay, last = course(opening, *given, *given, *step)
    assert [part for part in stay if not (isinstance(part, Setting) and part.stays)] == []
    assert isinstance(last, Setting)
    assert not last.stays


def test_a_chapter_without_steps_or_with_much_before_them_may_be_parted() -> None:
    given = [Prose("Given:"), read_display([SHORT])]
    for blocks in (given, [*given * 4, Heading("1. The rod", 2), SAID]):
        opening = course(Heading("Velocities", 1), *blocks)[0]
        assert isinstance(opening, Setting)
        assert not opening.stays


def test_what_stays_together_begins_a_page_where_it_has_no_room() -> None:
    """So that the drawings below know how full the page is."""
    together = [LONG_SAID, read_display([LONG, LONG])]
    question = WorkedQuestion(
        1, "q1", "A crank", "It turns.", (read_display([SHORT]), *together), None
    )
    high = sum(part.height for part in course(*together))
    area = TextArea(PAGE, high + 1, parts_chains=False)
    courses = arrange_courses([question], area)
    assert courses.pages == pytest.approx(1 + high / (high + 1))


def test_a_compact_paragraph_has_the_full_width_rather_than_many_lines_beside_a_drawing() -> None:
    long, short = (Prose(" ".join([SAID.text] * count), compact=True) for count in (8, 3))
    row, below = course(pictures(1), long)
    assert isinstance(row, DrawingRow)
    assert row.beside == ()
    assert isinstance(below, Setting)
    assert len(course(pictures(1), short)) == 1
    assert len(course(pictures(1), LONG_SAID)) == 1


def test_a_compact_paragraph_is_no_part_of_the_one_before() -> None:
    check = Prose("Check.", compact=True)
    assert list(join_sentences([SAID, SAID, check])) == [
        Prose(f"{SAID.text} {SAID.text}"),
        check,
    ]


def _fraction(terms: int) -> Display:
    return read_display([r"x &= \frac{" + " + ".join(["a_{BA}"] * terms) + "}{b}"])


def test_an_equation_is_folded_where_nothing_else_would_stand_beside_a_drawing() -> None:
    wide = _fraction(16)
    alone, row = course(wide, pictures(1), wide)
    assert isinstance(row, DrawingRow)
    for setting in (alone, *row.beside):
        assert isinstance(setting, Setting)
        assert isinstance(setting.body, EquationGroups)
        assert fits(setting)
        assert LineBreak() in list_nodes(setting.body.groups[0].rows[0])
    first, *_ = course(pictures(1), LONG_SAID, Heading("2. The rod", 2), SAID, wide)
    assert isinstance(first, DrawingRow)
    assert [setting for setting in first.beside if isinstance(setting.body, EquationGroups)] == []


def test_an_equation_that_would_have_three_lines_beside_a_drawing_stands_below() -> None:
    row, below = course(pictures(1), _fraction(18))
    assert isinstance(row, DrawingRow)
    assert row.beside == ()
    assert isinstance(below, Setting)


def test_a_caption_is_narrow_where_only_so_an_equation_has_room_beside_the_drawing() -> None:
    slim = Pictures((Picture(draw_polygon([], []), "velocity polygon"),))
    for terms, narrow in ((16, False), (18, True)):
        equation = read_display([r"x &= \frac{" + " + ".join(["a"] * terms) + "}{b}"])
        (row,) = course(slim, equation)
        assert isinstance(row, DrawingRow)
        assert row.drawings[0].narrow == narrow
        (setting,) = row.beside
        assert isinstance(setting.body, EquationGroups)
        assert LineBreak() not in list_nodes(setting.body.groups[0].rows[0])

"""What is not printed in a statement stands in no figure, and what is printed does."""

from __future__ import annotations

import pytest
from msgspec.structs import replace

from kinegrade.exam.printing.pages import QuestionPlace, lay_out_question
from kinegrade.exam.quiz.paper import show_instance
from kinegrade.figure.scene import Label
from kinegrade.language import Language
from kinegrade.press.sheet import QuestionSheet
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.translated import Translated

EN = Language("en")
VALUES = {"r": "1/10", "k": "2", "phi": "60", "omega": "5", "alpha": "10"}


def lay_out(template_name: str, values: dict[str, str], *asks: str) -> QuestionSheet:
    shown = show_instance(load_template(template_name), values, asks)
    return lay_out_question(QuestionPlace(1, "q1"), shown, (), EN)


def letters(sheet: QuestionSheet) -> set[str]:
    """The letters in the figure of a question."""
    assert sheet.figure is not None
    return {mark.symbol for mark in sheet.figure.primitives if isinstance(mark, Label)}


@pytest.mark.parametrize(
    ("ask", "printed"), [("v_B", False), ("omega_AB", False), ("a_B", True), ("alpha_AB", True)]
)
def test_a_given_acceleration_is_shown_where_an_ask_needs_it(ask: str, printed: bool) -> None:
    sheet = lay_out("slider-crank", VALUES, ask)
    assert (r"\alpha" in sheet.statement) == printed
    assert (r"\alpha" in letters(sheet)) == printed
    assert r"\omega" in letters(sheet)


def test_axes_stand_for_components_that_this_question_asks_for() -> None:
    rolling = {"r": "3/10", "R": "27/50", "v_O": "1", "a_O": "-9"}
    assert "x" not in letters(lay_out("rolling-wheel-rim-points", rolling, "omega"))
    assert "x" in letters(lay_out("rolling-wheel-rim-points", rolling, "v_C_x"))


@pytest.mark.parametrize("name", find_template_names())
def test_a_figure_marks_the_same_where_texts_are_written_once_in_no_stated_language(
    name: str,
) -> None:
    """Whoever wrote one plain text got a figure without any dimension, and nothing said so."""
    template = load_template(name)
    words, asks = template.words, template.asked()
    texts = {
        key: tuple(replace(one, text=plainly(one.text)) for one in wordings)
        for key, wordings in words.texts.items()
    }
    plain = replace(words, statement=plainly(words.statement), texts=texts)
    assert mark_question(replace(template, words=plain), asks) == mark_question(template, asks)


def plainly(text: Translated) -> Translated:
    return Translated(plain=text.in_language(EN))

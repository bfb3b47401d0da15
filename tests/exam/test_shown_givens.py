"""What is not printed in a statement stands in no figure, and what is printed does."""

from __future__ import annotations

import pytest

from kinegrade.exam.printing.pages import QuestionPlace, lay_out_question
from kinegrade.exam.quiz.paper import show_instance
from kinegrade.figure.scene import Label
from kinegrade.language import Language
from kinegrade.press.sheet import QuestionSheet
from kinegrade.problem.template.library.library import load_template

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
    assert "x" not in letters(lay_out("slider-crank", VALUES, "omega_AB"))
    assert "x" in letters(lay_out("slider-crank", VALUES, "a_B"))

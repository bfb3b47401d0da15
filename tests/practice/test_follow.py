"""What the page says follows from wrong answers, where several could be the reason."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

import kinegrade
from kinegrade.language import ENGLISH
from kinegrade.practice.document import (
    PracticeAsk,
    PracticeDraw,
    PracticeQuestion,
    PracticeRule,
    PracticeSheet,
)
from kinegrade.practice.making import make_practice_sheet
from tests.practice.node import Shown, judge_in_node

ASKS = tuple(
    PracticeAsk(name, name, "1", "", None, "", points, 0.0, stage)
    for name, points, stage in (("omega", 2.0, 0), ("alpha", 4.0, 1), ("a", 3.0, 1))
)
# alpha = 2 omega, alpha = a / 3 and a = 3 alpha
DRAW = PracticeDraw(
    (), (("1", 0, ""), ("2", 0, ""), ("6", 0, "")), ("0 1 0 2 0", "2 1 0 0.333333333 0", "1 2 0 3 0"), None
)  # fmt: skip
SHEET = PracticeSheet(
    "", "", (), {},
    (PracticeQuestion("", ASKS, (PracticeRule(0.01, 0.0, None),), (), (DRAW,), None, ()),),
)  # fmt: skip


def test_what_follows_as_a_magnitude_is_never_negative() -> None:
    rod = replace(ASKS[1], convention="magnitude")
    follows = ("0 1 3 -1 0 +",)  # |3 - omega|, which is 2 for the right omega
    draw = replace(DRAW, follows=follows)
    question = replace(SHEET.questions[0], asks=(ASKS[0], rod, ASKS[2]), draws=(draw,))
    sheet = replace(SHEET, questions=(question,))
    typed = [("5", "-2.05", "6"), ("8", "5", "6")]
    kinds = [judge_in_node(sheet, [[each]])[0][0][1].kind for each in typed]
    assert kinds == ["wrong", "follow-through"]


def judge(*typed: str) -> list[Shown]:
    """What is said of answers to the asks."""
    return judge_in_node(SHEET, [[typed]])[0][0]


def test_what_follows_from_one_wrong_answer_is_taken() -> None:
    assert [said.kind for said in judge("1.2", "2.4", "6")] == ["wrong", "follow-through", "right"]
    assert [said.kind for said in judge("1", "2.4", "7.2")] == ["right", "follow-through", "wrong"]


def test_an_answer_does_not_follow_from_one_that_may_follow_from_it() -> None:
    omega, alpha, a = judge("1.2", "2.4", "7.2")
    assert (omega.kind, alpha.kind, a.kind) == ("wrong", "follow-through", "wrong")
    assert a.is_cut_off


def test_what_no_way_tells_from_leaving_terms_out_does_not_follow() -> None:
    """By the second way 5.06 follows from a tenth of the right omega, but the first leads to 5.03
    without any.
    """
    draw = replace(DRAW, follows=("0 1 5 0 -3", "0 1 6 -10 6"))
    sheet = replace(SHEET, questions=(replace(SHEET.questions[0], draws=(draw,)),))
    (judged,) = judge_in_node(sheet, [[("0.1", "5.03", "6")]])[0]
    assert judged[1].kind == "wrong"
    (judged,) = judge_in_node(sheet, [[("0.1", "5.09", "6")]])[0]
    assert judged[1].kind == "follow-through"


def test_where_only_values_of_the_right_sign_are_known_the_page_says_so() -> None:
    draw = replace(DRAW, follows=("0 1 0 2 0 +",))
    sheet = replace(SHEET, questions=(replace(SHEET.questions[0], draws=(draw,)),))
    (judged,) = judge_in_node(sheet, [[("-1.2", "2.4", "6")]])[0]
    assert judged[1].kind == "wrong"
    assert judged[1].is_cut_off


def test_where_something_else_follows_with_a_right_answer_the_page_says_so() -> None:
    draw = replace(DRAW, follows=("0 1 0 2 0", "0&2 1"))
    sheet = replace(SHEET, questions=(replace(SHEET.questions[0], draws=(draw,)),))

    def judge_second(*typed: str) -> tuple[str, bool]:
        said = judge_in_node(sheet, [[typed]])[0][0][1]
        return said.kind, said.is_cut_off

    assert judge_second("1.2", "2.9", "6") == ("wrong", True)
    assert judge_second("1.2", "2.9", "") == ("wrong", False)
    assert judge_second("1.2", "2.4", "6")[0] == "follow-through"


def test_beside_right_answers_that_are_rounded_the_page_does_not_say_what_does_not_follow() -> None:
    """With 6.04 for the right 6 something else may follow than with 6, as far as 6.04 is off."""

    def judge_second(*typed: str) -> tuple[str, bool]:
        said = judge(*typed)[1]
        return said.kind, said.is_cut_off

    assert judge_second("1.2", "2.45", "6.04") == ("wrong", True)
    assert judge_second("1.2", "2.45", "6") == ("wrong", False)
    assert judge_second("1.2", "2.45", "") == ("wrong", False)
    assert judge_second("1.2", "2.9", "6.04") == ("wrong", False)
    assert judge_second("1.2", "-2.45", "6.04") == ("wrong", False)


def make_question(template: str, folder: Path, draws: int = 1) -> PracticeQuestion:
    """A template's question with so many draws."""
    bank = folder / "bank.toml"
    bank.write_text(
        f'title = "T"\ncourse = "C"\n\n[[questions]]\ntemplate = "{template}"\n', encoding="utf-8"
    )
    blueprint = kinegrade.Bank.read(bank).blueprint
    (question,) = make_practice_sheet(blueprint, draws, "practice", ENGLISH).sheet.questions
    return question


def test_a_right_answer_beside_a_wrong_one_is_known_to_matter(tmp_path: Path) -> None:
    """From a component of the velocity of a pin and its speed along a bar follows the other one."""
    question = make_question("pin-in-disc-slot-and-rod", tmp_path)
    place = {ask.name: number for number, ask in enumerate(question.asks)}
    known = f"{place['v_M_x']}&{place['v_rel_2']} {place['v_M_y']}"
    assert known in question.draws[0].follows


@pytest.mark.left(beside="test_a_right_answer_beside_a_wrong_one_is_known_to_matter")
def test_which_right_answers_matter_depends_on_the_draw(tmp_path: Path) -> None:
    """At some draws a component vanishes or values agree: one draw does not tell of the others."""
    question = make_question("crank-slider-in-floating-link", tmp_path, draws=8)
    told = {frozenset(way for way in draw.follows if "&" in way) for draw in question.draws}
    assert len(told) > 1


def test_a_speed_follows_from_an_angular_velocity_of_the_wrong_sense_too(tmp_path: Path) -> None:
    question = make_question("planetary-gear-external-rim-velocities", tmp_path)
    names = [ask.name for ask in question.asks]
    pair = f"{names.index('omega_II')} {names.index('v_C')} "
    ways = [text for text in question.draws[0].follows if text.startswith(pair)]
    assert len(ways) == 2  # the pole on the sun gear, and the base point A
    assert [way for way in ways if way.endswith("+")] == []


def test_a_right_answer_is_known_to_matter_beside_one_of_the_wrong_sense(tmp_path: Path) -> None:
    """From an angular velocity of the wrong sense and the right speed of C follows a rod that turns
    the other way.
    """
    question = make_question("pole-four-bar-coupler", tmp_path, draws=2)
    names = [ask.name for ask in question.asks]
    omega, speed, rod = (names.index(name) for name in ("omega_BC", "v_C", "omega_CD"))
    assert [draw for draw in question.draws if f"{omega}&{speed} {rod}" not in draw.follows] == []

"""What the page says follows from wrong answers, where several could be the reason."""

from __future__ import annotations

from dataclasses import replace

from kinegrade.practice.document import (
    PracticeAsk,
    PracticeDraw,
    PracticeQuestion,
    PracticeRule,
    PracticeSheet,
)
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

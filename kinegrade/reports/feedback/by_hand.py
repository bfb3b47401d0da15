"""Marks by hand on a feedback sheet: the points of a question, the reason that was given for them,
and what comes on top.
"""

from __future__ import annotations

from collections.abc import Mapping

from kinegrade.exam.folder.records import HandQuestion
from kinegrade.language.catalogue import Catalogue
from kinegrade.language.message import Message
from kinegrade.marks_folder.hand_marks import EXTRA, HandMark
from kinegrade.press.sheet import FeedbackQuestion
from kinegrade.reports.feedback.points import (
    head_question,
    say_bonus,
    write_points,
    write_share,
)


def explain_hand_mark(mark: HandMark | None, catalogue: Catalogue) -> str:
    """That a question was marked by hand, and why so; "" where it was not."""
    if mark is None:
        return ""
    if mark.comment:
        return catalogue.write(Message("feedback.hand-comment", comment=mark.comment))
    return catalogue.text("feedback.marked-by-hand")


def make_extra(marks: Mapping[str, HandMark], catalogue: Catalogue) -> FeedbackQuestion | None:
    """The points on top of everything; None where there are none."""
    mark = marks.get(EXTRA)
    if mark is None:
        return None
    heading, points = catalogue.text("feedback.extra"), write_points(mark.points, catalogue)
    return FeedbackQuestion(heading, "", f"+{points}", "", (), mark.comment)


def make_by_hand(
    number: int, question: HandQuestion, title: str, mark: HandMark | None, catalogue: Catalogue
) -> FeedbackQuestion:
    """A question that only hands mark, with that number on the paper."""
    heading = catalogue.write(head_question(question.question, number))
    if mark is None:
        points = write_points(question.points, catalogue)
        worth = say_bonus(points, catalogue) if question.bonus else points
        said = catalogue.text("feedback.by-hand", points=worth)
        return FeedbackQuestion(heading, title, said, "", ())
    share = write_share(mark.points, question.points, catalogue)
    worth = say_bonus(share, catalogue) if question.bonus else share
    return FeedbackQuestion(heading, title, worth, "", (), mark.comment)


def make_left_out(
    number: int, question: HandQuestion, title: str, catalogue: Catalogue
) -> FeedbackQuestion:
    """A question that only hands mark, which a policy dropped."""
    heading = catalogue.write(head_question(question.question, number))
    return FeedbackQuestion(heading, title, "", "", (), catalogue.text("feedback.void"))

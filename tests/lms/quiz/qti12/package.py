"""A package for Canvas, and what its items take for right."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from xml.etree.ElementTree import Element

from kinegrade.exam.quiz.document import Quiz, QuizAsk, QuizPaper
from tests.lms.quiz import a_quiz
from tests.lms.quiz.packages import bare, files_of

# the part of the standard's DTD that is used, with Canvas's own <points_per_item> where the DTD
# allows anything
MODELS = {
    "questestinterop": "assessment ",
    "assessment": "qtimetadata section ",
    "qtimetadata": "(qtimetadatafield )+",
    "qtimetadatafield": "fieldlabel fieldentry ",
    "fieldlabel": "#",
    "fieldentry": "#",
    "section": "(selection_ordering )?(item |section )*",
    "selection_ordering": "selection ",
    "selection": "selection_number selection_extension ",
    "selection_number": "#",
    "selection_extension": "points_per_item ",
    "points_per_item": "#",
    "item": "itemmetadata presentation resprocessing (itemfeedback )*",
    "itemmetadata": "qtimetadata ",
    "presentation": "material response_str ",
    "material": "mattext ",
    "mattext": "#",
    "response_str": "render_fib ",
    "render_fib": "response_label ",
    "response_label": "",
    "resprocessing": "outcomes (respcondition )+",
    "outcomes": "decvar ",
    "decvar": "",
    "respcondition": "conditionvar (setvar )?(displayfeedback )?",
    "conditionvar": "or |vargte varlte |other ",
    "or": "varequal and ",
    "and": "vargte varlte ",
    "other": "",
    "varequal": "#",
    "vargte": "#",
    "varlte": "#",
    "setvar": "#",
    "displayfeedback": "",
    "itemfeedback": "flow_mat ",
    "flow_mat": "material ",
}
ATTRIBUTES = {
    "assessment": "ident! title!",
    "section": "ident! title",
    "item": "ident! title!",
    "mattext": "texttype!",
    "response_str": "ident! rcardinality!",
    "render_fib": "fibtype!",
    "response_label": "ident!",
    "decvar": "maxvalue minvalue varname! vartype!",
    "respcondition": "continue!",
    "setvar": "action! varname!",
    "varequal": "respident!",
    "vargte": "respident!",
    "varlte": "respident!",
    "itemfeedback": "ident!",
    "displayfeedback": "feedbacktype! linkrefid!",
}
EXACT = ("v_D", "v_E", "a_C", "phi")  # whose numbers a double holds with all their digits


def quizzes(package: Path) -> list[Element]:
    """The assessments of a package."""
    return [bare(text) for text in files_of(package).values() if "<questestinterop" in text]


def items(package: Path) -> dict[str, Element]:
    """All items by their identifiers."""
    return {item.get("ident", ""): item for quiz in quizzes(package) for item in quiz.iter("item")}


def intervals(item: Element) -> list[tuple[Fraction | None, Fraction, Fraction]]:
    """What an item takes as right, read as Canvas reads it: the exact answer if there is one, and
    the bounds.
    """
    found = []
    for condition in item.iter("respcondition"):
        if condition.find("setvar") is not None:
            value = condition.find(".//varequal")
            low, high = (
                Fraction(node.text or "")
                for tag in ("vargte", "varlte")
                for node in condition.iter(tag)
            )
            found.append((None if value is None else Fraction(value.text or ""), low, high))
    return found


def one_ask(ask: QuizAsk) -> Quiz:
    """A quiz of nothing but this ask."""
    return Quiz(
        "en", "", "Test", [QuizPaper("P", "1", "Bo", (a_quiz.question("P", "q1", (ask,)),))]
    )

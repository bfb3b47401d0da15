"""A numerical question of QTI 1.2 as Canvas itself writes it, which Classic and New Quizzes both
read.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from kinegrade.lms.quiz.decimals import decimal_text
from kinegrade.lms.quiz.intervals import RightInterval
from kinegrade.lms.quiz.xml_text import Xml, element

RESPONSE = "response1"
HAIR = Fraction(1, 10**12)  # of the larger bound: more than doubles lose, less than students type
SOLUTION = "general_fb"  # Canvas's name of the feedback that is shown whatever the answer


@dataclass(frozen=True)
class NumericalItem:
    """One numerical question; `text` and `solution` are HTML, any of the intervals is right."""

    identifier: str
    title: str
    text: str
    points: Fraction
    intervals: Sequence[RightInterval]
    solution: str = ""

    def unsolved(self) -> NumericalItem:
        """The same without a solution."""
        return replace(self, solution="")


def item_element(item: NumericalItem) -> Xml:
    """The `item` element."""
    parts = (_metadata(item), _presentation(item), _processing(item))
    return element("item", *parts, *_solution(item), ident=item.identifier, title=item.title)


def metadata_field(label: str, entry: str) -> Xml:
    """A `qtimetadatafield`."""
    return element("qtimetadatafield", element("fieldlabel", label), element("fieldentry", entry))


def _metadata(item: NumericalItem) -> Xml:
    return element(
        "itemmetadata",
        element(
            "qtimetadata",
            metadata_field("question_type", "numerical_question"),
            metadata_field("points_possible", decimal_text(item.points)),
            metadata_field("original_answer_ids", ""),
            metadata_field("assessment_question_identifierref", f"{item.identifier}-bank"),
        ),
    )


def _presentation(item: NumericalItem) -> Xml:
    box = element("render_fib", element("response_label", ident="answer1"), fibtype="Decimal")
    return element(
        "presentation",
        element("material", element("mattext", item.text, texttype="text/html")),
        element("response_str", box, ident=RESPONSE, rcardinality="Single"),
    )


def _solution(item: NumericalItem) -> Iterator[Xml]:
    if item.solution:
        shown = element("mattext", item.solution, texttype="text/html")
        yield element(
            "itemfeedback", element("flow_mat", element("material", shown)), ident=SOLUTION
        )


def _processing(item: NumericalItem) -> Xml:
    score = element("decvar", maxvalue="100", minvalue="0", varname="SCORE", vartype="Decimal")
    return element("resprocessing", element("outcomes", score), *_conditions(item))


def _conditions(item: NumericalItem) -> Iterator[Xml]:
    """The solution whatever the answer, then all points for a number in one of the intervals."""
    if item.solution:
        shown = element("displayfeedback", feedbacktype="Response", linkrefid=SOLUTION)
        yield element(
            "respcondition", element("conditionvar", element("other")), shown, continue_="Yes"
        )
    for interval in item.intervals:
        full = element("setvar", "100", action="Set", varname="SCORE")
        yield element(
            "respcondition", element("conditionvar", *_condition(interval)), full, continue_="No"
        )


def _condition(interval: RightInterval) -> Iterator[Xml]:
    """An answer with its margin where the interval is symmetric; of two different margins, Canvas
    and New Quizzes would not use the same one.
    """
    if interval.symmetric:
        exact = element("varequal", interval.value_text, respident=RESPONSE)
        bounds = _bounds(_hair_lower(interval), interval.high_text)
        yield element("or", exact, element("and", *bounds))
    else:
        yield from _bounds(interval.low_text, interval.high_text)


def _bounds(low: str, high: str) -> tuple[Xml, Xml]:
    return (
        element("vargte", low, respident=RESPONSE),
        element("varlte", high, respident=RESPONSE),
    )


def _hair_lower(interval: RightInterval) -> str:
    """The lower bound, lowered by a hair; Classic Quizzes take the margin from the upper one.

    New Quizzes compute the margin as the answer minus the lower bound, in doubles, which would lose
    every third right answer at a bound. An exact answer has no margin, and loses nothing.
    """
    if interval.low == interval.high:
        return interval.low_text
    hair = HAIR * max(abs(interval.low), abs(interval.high))
    return decimal_text(interval.low - hair, "down")

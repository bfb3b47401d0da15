"""A numerical question of QTI 1.2 as Canvas itself writes it, which Classic and New Quizzes both
read.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from kinegrade.lms.quiz.decimals import write_decimal
from kinegrade.lms.quiz.intervals import RightInterval
from kinegrade.lms.quiz.xml_text import Xml, write_element

_RESPONSE = "response1"
_HAIR = Fraction(1, 10**12)  # of the larger bound: more than doubles lose, less than students type
_SOLUTION = "general_fb"  # Canvas's name of the feedback that is shown whatever the answer


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


def write_item_element(item: NumericalItem) -> Xml:
    """The `item` element."""
    parts = (_write_metadata(item), _write_presentation(item), _write_processing(item))
    return write_element(
        "item", *parts, *_write_solution(item), ident=item.identifier, title=item.title
    )


def _write_metadata_field(label: str, entry: str) -> Xml:
    """A `qtimetadatafield`."""
    return write_element(
        "qtimetadatafield", write_element("fieldlabel", label), write_element("fieldentry", entry)
    )


def _write_metadata(item: NumericalItem) -> Xml:
    return write_element(
        "itemmetadata",
        write_element(
            "qtimetadata",
            _write_metadata_field("question_type", "numerical_question"),
            _write_metadata_field("points_possible", write_decimal(item.points)),
            _write_metadata_field("original_answer_ids", ""),
            _write_metadata_field("assessment_question_identifierref", f"{item.identifier}-bank"),
        ),
    )


def _write_presentation(item: NumericalItem) -> Xml:
    box = write_element(
        "render_fib", write_element("response_label", ident="answer1"), fibtype="Decimal"
    )
    return write_element(
        "presentation",
        write_element("material", write_element("mattext", item.text, texttype="text/html")),
        write_element("response_str", box, ident=_RESPONSE, rcardinality="Single"),
    )


def _write_solution(item: NumericalItem) -> Iterator[Xml]:
    if item.solution:
        shown = write_element("mattext", item.solution, texttype="text/html")
        yield write_element(
            "itemfeedback",
            write_element("flow_mat", write_element("material", shown)),
            ident=_SOLUTION,
        )


def _write_processing(item: NumericalItem) -> Xml:
    score = write_element(
        "decvar", maxvalue="100", minvalue="0", varname="SCORE", vartype="Decimal"
    )
    return write_element(
        "resprocessing", write_element("outcomes", score), *_write_conditions(item)
    )


def _write_conditions(item: NumericalItem) -> Iterator[Xml]:
    """The solution whatever the answer, then all points for a number in one of the intervals."""
    if item.solution:
        shown = write_element("displayfeedback", feedbacktype="Response", linkrefid=_SOLUTION)
        yield write_element(
            "respcondition",
            write_element("conditionvar", write_element("other")),
            shown,
            continue_="Yes",
        )
    for interval in item.intervals:
        full = write_element("setvar", "100", action="Set", varname="SCORE")
        yield write_element(
            "respcondition",
            write_element("conditionvar", *_write_condition(interval)),
            full,
            continue_="No",
        )


def _write_condition(interval: RightInterval) -> Iterator[Xml]:
    """An answer with its margin where the interval is symmetric; of two different margins, Canvas
    and New Quizzes would not use the same one.
    """
    if interval.symmetric:
        exact = write_element("varequal", interval.value_text, respident=_RESPONSE)
        bounds = _write_bounds(_write_hair_lower(interval), interval.high_text)
        yield write_element("or", exact, write_element("and", *bounds))
    else:
        yield from _write_bounds(interval.low_text, interval.high_text)


def _write_bounds(low: str, high: str) -> tuple[Xml, Xml]:
    return (
        write_element("vargte", low, respident=_RESPONSE),
        write_element("varlte", high, respident=_RESPONSE),
    )


def _write_hair_lower(interval: RightInterval) -> str:
    """The lower bound, lowered by a hair; Classic Quizzes take the margin from the upper one.

    New Quizzes compute the margin as the answer minus the lower bound, in doubles, which would lose
    every third right answer at a bound. An exact answer has no margin, and loses nothing.
    """
    if interval.low == interval.high:
        return interval.low_text
    hair = _HAIR * max(abs(interval.low), abs(interval.high))
    return write_decimal(interval.low - hair, "down")

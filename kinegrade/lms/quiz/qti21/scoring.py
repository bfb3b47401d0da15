"""What a QTI 2.1 item does with the answers: points for each ask, feedback for known mistakes, the
total.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache

from kinegrade.exam.quiz.document import QuizAsk
from kinegrade.lms.quiz.decimals import write_decimal
from kinegrade.lms.quiz.intervals import RightInterval, find_right_intervals
from kinegrade.lms.quiz.wrong_numbers import find_wrong_numbers
from kinegrade.lms.quiz.xml_text import Xml, write_element, write_on_lines

SOLUTION = "SOLUTION"


def name_response(place: int) -> str:
    """The variable that holds the answer to an ask; asks are counted from 1."""
    return f"RESPONSE_{place}"


def _name_points(place: int) -> str:
    """The variable that holds the points of an ask."""
    return f"POINTS_{place}"


def name_mistake(place: int, mistake: int) -> str:
    """The name of a known mistake's feedback; mistakes are counted from 1."""
    return f"MISTAKE_{place}_{mistake}"


def write_declarations(asks: tuple[QuizAsk, ...]) -> Iterator[Xml]:
    """Responses with the right numbers, then the outcomes: feedback, points of each ask, total and
    maximum.
    """
    for place, ask in enumerate(asks, start=1):
        right = write_element("correctResponse", write_element("value", write_decimal(ask.value)))
        yield write_element(
            "responseDeclaration",
            right,
            identifier=name_response(place),
            cardinality="single",
            baseType="float",
        )
    yield write_element(
        "outcomeDeclaration", identifier="FEEDBACK", cardinality="multiple", baseType="identifier"
    )
    for place, ask in enumerate(asks, start=1):
        yield _write_number(_name_points(place), Fraction(0), ask.row.points)
    total = sum((ask.row.points for ask in asks), Fraction(0))
    yield _write_number("SCORE", Fraction(0), total)
    yield _write_number("MAXSCORE", total, total)


def write_processing(asks: tuple[QuizAsk, ...], *, solved: bool) -> Xml:
    """The conditions of all asks, the total, and the solution where it is to be shown."""
    rules = [_write_condition(place, ask) for place, ask in enumerate(asks, start=1)]
    points = (
        write_element("variable", identifier=_name_points(place))
        for place in range(1, len(asks) + 1)
    )
    rules.append(
        write_element("setOutcomeValue", write_element("sum", *points), identifier="SCORE")
    )
    if solved:
        rules.append(_write_feedback(SOLUTION))
    return write_element("responseProcessing", write_on_lines(rules))


def _write_number(name: str, default: Fraction, most: Fraction) -> Xml:
    value = write_element("defaultValue", write_element("value", write_decimal(default)))
    return write_element(
        "outcomeDeclaration",
        value,
        identifier=name,
        cardinality="single",
        baseType="float",
        normalMaximum=write_decimal(most),
    )


def _write_condition(place: int, ask: QuizAsk) -> Xml:
    """Right, or else the known mistakes that lead to the answer."""
    branches = [
        write_element(
            "responseIf",
            _write_any(place, find_right_intervals(ask)),
            _write_points(place, ask.row.points),
        )
    ]
    for wrong in find_wrong_numbers(ask):
        given = [_write_points(place, ask.row.points * wrong.credit)] if wrong.credit else []
        numbers = {each.identifier: ask.mistakes.index(each) + 1 for each in wrong.mistakes}
        shown = (_write_feedback(name_mistake(place, number)) for number in numbers.values())
        branches.append(
            write_element("responseElseIf", _write_any(place, wrong.intervals), *given, *shown)
        )
    return write_element("responseCondition", write_on_lines(branches))


def _write_any(place: int, intervals: tuple[RightInterval, ...]) -> Xml:
    tests = [_write_equal(place, interval) for interval in intervals]
    return tests[0] if len(tests) == 1 else write_element("or", *tests)


def _write_equal(place: int, interval: RightInterval) -> Xml:
    """The test for a closed interval, which may extend further on one side of the value."""
    margins = interval.margin_texts
    mode = (
        {"toleranceMode": "exact"}
        if margins == ("0", "0")
        else {"toleranceMode": "absolute", "tolerance": " ".join(margins)}
    )
    value = write_element("baseValue", interval.value_text, baseType="float")
    return write_element("equal", _write_answer(place), value, **mode)


@lru_cache(maxsize=64)
def _write_answer(place: int) -> Xml:
    return write_element("variable", identifier=name_response(place))


@lru_cache(maxsize=256)
def _write_points(place: int, points: Fraction) -> Xml:
    given = write_element("baseValue", write_decimal(points), baseType="float")
    return write_element("setOutcomeValue", given, identifier=_name_points(place))


@lru_cache(maxsize=256)
def _write_feedback(name: str) -> Xml:
    """Adds a name to those whose feedback is shown."""
    both = write_element(
        "multiple",
        write_element("variable", identifier="FEEDBACK"),
        write_element("baseValue", name, baseType="identifier"),
    )
    return write_element("setOutcomeValue", both, identifier="FEEDBACK")

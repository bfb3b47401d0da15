"""What a QTI 2.1 item does with the answers: points for each ask, feedback for known mistakes, the
total.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache

from kinegrade.exam.quiz_document import QuizAsk
from kinegrade.lms.quiz.decimals import decimal_text
from kinegrade.lms.quiz.intervals import RightInterval, right_intervals
from kinegrade.lms.quiz.wrong_numbers import wrong_numbers
from kinegrade.lms.quiz.xml_text import Xml, element, on_lines

SOLUTION = "SOLUTION"


def response_name(place: int) -> str:
    """The variable that holds the answer to an ask; asks are counted from 1."""
    return f"RESPONSE_{place}"


def points_name(place: int) -> str:
    """The variable that holds the points of an ask."""
    return f"POINTS_{place}"


def mistake_name(place: int, mistake: int) -> str:
    """The name of a known mistake's feedback; mistakes are counted from 1."""
    return f"MISTAKE_{place}_{mistake}"


def declarations(asks: tuple[QuizAsk, ...]) -> Iterator[Xml]:
    """Responses with the right numbers, then the outcomes: feedback, points of each ask, total and
    maximum.
    """
    for place, ask in enumerate(asks, start=1):
        right = element("correctResponse", element("value", decimal_text(ask.value)))
        yield element(
            "responseDeclaration",
            right,
            identifier=response_name(place),
            cardinality="single",
            baseType="float",
        )
    yield element(
        "outcomeDeclaration", identifier="FEEDBACK", cardinality="multiple", baseType="identifier"
    )
    for place, ask in enumerate(asks, start=1):
        yield _number(points_name(place), Fraction(0), ask.points)
    total = sum((ask.points for ask in asks), Fraction(0))
    yield _number("SCORE", Fraction(0), total)
    yield _number("MAXSCORE", total, total)


def processing(asks: tuple[QuizAsk, ...], *, solved: bool) -> Xml:
    """The conditions of all asks, the total, and the solution where it is to be shown."""
    rules = [_condition(place, ask) for place, ask in enumerate(asks, start=1)]
    points = (
        element("variable", identifier=points_name(place)) for place in range(1, len(asks) + 1)
    )
    rules.append(element("setOutcomeValue", element("sum", *points), identifier="SCORE"))
    if solved:
        rules.append(_feedback(SOLUTION))
    return element("responseProcessing", on_lines(rules))


def _number(name: str, default: Fraction, most: Fraction) -> Xml:
    value = element("defaultValue", element("value", decimal_text(default)))
    return element(
        "outcomeDeclaration",
        value,
        identifier=name,
        cardinality="single",
        baseType="float",
        normalMaximum=decimal_text(most),
    )


def _condition(place: int, ask: QuizAsk) -> Xml:
    """Right, or else the known mistakes that lead to the answer."""
    branches = [
        element("responseIf", _any(place, right_intervals(ask)), _points(place, ask.points))
    ]
    for wrong in wrong_numbers(ask):
        given = [_points(place, ask.points * wrong.credit)] if wrong.credit else []
        numbers = (ask.mistakes.index(mistake) + 1 for mistake in wrong.mistakes)
        shown = (_feedback(mistake_name(place, number)) for number in numbers)
        branches.append(element("responseElseIf", _any(place, wrong.intervals), *given, *shown))
    return element("responseCondition", on_lines(branches))


def _any(place: int, intervals: tuple[RightInterval, ...]) -> Xml:
    tests = [_equal(place, interval) for interval in intervals]
    return tests[0] if len(tests) == 1 else element("or", *tests)


def _equal(place: int, interval: RightInterval) -> Xml:
    """The test for a closed interval, which may extend further on one side of the value."""
    margins = interval.margin_texts
    mode = (
        {"toleranceMode": "exact"}
        if margins == ("0", "0")
        else {"toleranceMode": "absolute", "tolerance": " ".join(margins)}
    )
    value = element("baseValue", interval.value_text, baseType="float")
    return element("equal", _answer(place), value, **mode)


@lru_cache(maxsize=64)
def _answer(place: int) -> Xml:
    return element("variable", identifier=response_name(place))


@lru_cache(maxsize=256)
def _points(place: int, points: Fraction) -> Xml:
    given = element("baseValue", decimal_text(points), baseType="float")
    return element("setOutcomeValue", given, identifier=points_name(place))


@lru_cache(maxsize=256)
def _feedback(name: str) -> Xml:
    """Adds a name to those whose feedback is shown."""
    both = element(
        "multiple",
        element("variable", identifier="FEEDBACK"),
        element("baseValue", name, baseType="identifier"),
    )
    return element("setOutcomeValue", both, identifier="FEEDBACK")

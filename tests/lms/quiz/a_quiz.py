"""A small quiz by hand with what is hard to write: zero, tiny and uneven answers, whole turns,
texts made of markup.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from typing import Literal

from kinegrade.description.said import Description
from kinegrade.exam.quiz.document import Quiz, QuizAsk, QuizMistake, QuizPaper, QuizQuestion
from kinegrade.figure.scene import FIRM, Scene, Strokes
from kinegrade.mechanics.vector import Vector
from kinegrade.press.html.solution import NOT_SHOWN, Illustrated
from kinegrade.press.sheet import AnswerRow, QuestionSheet
from kinegrade.worked.document import Picture, Prose

ROOT = Fraction("1.732050807568877293527446341505872366943")  # sqrt(3)
CORNERS = (Vector(5.0, 45.0), Vector(30.0, 10.0), Vector(75.0, 45.0))
FIGURE = Scene(80.0, 50.0, 1.0, (Strokes(tuple(pairwise(CORNERS)), FIRM),))
_IN_ROW = {"symbol", "meaning", "unit", "sign", "points"}
HOSTILE = 'Bars ]]> & **AB** "x" \\<script\\>alert(1)\\</script\\>'


def ask(name: str, value: Fraction, low: Fraction, high: Fraction, **more: object) -> QuizAsk:
    """An ask worth 2 points, in m/s unless said otherwise."""
    meaning, sign = f"speed of ${name[-1]}$", "magnitude, not negative"
    row = AnswerRow(name, meaning, "m/s", sign, Fraction(2))
    return alter(QuizAsk(name, row, value, low, high), **more)


def alter(ask: QuizAsk, **more: object) -> QuizAsk:
    """The ask with other parts, of itself or of its row."""
    printed = {part: more.pop(part) for part in _IN_ROW & more.keys()}
    return replace(ask, row=replace(ask.row, **printed), **more)  # type: ignore[arg-type]


def relative(
    name: str, value: Fraction, share: Fraction = Fraction(1, 50), **more: object
) -> QuizAsk:
    """An ask right within a share of its value."""
    room = abs(value) * share
    return ask(name, value, value - room, value + room, **more)


CORIOLIS = QuizMistake(
    "coriolis",
    Fraction(-7),
    Fraction(1, 2),
    "Coriolis term < left out & more ]]>",
    Fraction("-7.14"),
    Fraction("-6.86"),
)
REVERSED = QuizMistake("sense", Fraction("12.345"), Fraction(0), "wrong sense")

SPEED = relative("v_B", Fraction(5, 2) * ROOT, mistakes=(), points=Fraction(5, 2))
ACCELERATION = relative(
    "a_C",
    Fraction("-12.345"),
    Fraction(1, 100),
    unit="m/s^2",
    sign="positive along $+x$",
    mistakes=(CORIOLIS, REVERSED),
    symbol=r"a_{C}^{\mathrm{n}}",
)
ZERO = ask("v_D", Fraction(0), Fraction(-1, 100), Fraction(1, 100), sign="")
UNEVEN = ask("v_E", Fraction(10), Fraction(9), Fraction("12.5"))
ANGLE = ask(
    "phi",
    Fraction(30),
    Fraction("29.5"),
    Fraction("30.5"),
    unit="deg",
    symbol=r"\varphi",
    meaning="angle of $AB$",
    sign="counter-clockwise positive",
    period=Fraction(360),
)
RATIO = relative(
    "k", Fraction(7, 3), unit="1", meaning="ratio of speeds", sign="", points=Fraction(1)
)
TINY = relative("v_F", Fraction("0.00425"), Fraction(1, 100), meaning="speed of $F$")
LOST = relative("omega", Fraction("0.00004"), unit="rad/s", symbol=r"\omega_{AB}")

STATEMENT = {
    "en": HOSTILE
    + "\n\nThe crank $OA$ turns with $\\omega = 3\\,\\unit{rad/s}$ and $a < b$.\n\n1. one\n2. two",
    "zh": "曲柄 $OA$ 以匀角速度 $\\omega = 3\\,\\unit{rad/s}$ 转动，且 $a < b$。\n求：",
}
TITLE = {"en": "Slider-crank $OAB$ & co.", "zh": "曲柄滑块机构 $OAB$"}
RULE = {"en": "Right within 2 %.", "zh": "误差不超过 2% 为正确。"}
PICTURE = Picture(FIGURE, "velocity polygon of $AB$ & co.")
SOLUTION_TEXT = (
    "<h4>Solution</h4>\n<p>\\(v_B = v_A &lt; 1\\)</p>\n<table><tbody>\n"
    '<tr><th scope="row">magnitude</th><td style="padding:0 '
    '.5em">\\(r\\)</td></tr>\n</tbody></table>\n'
    '<ol start="3"><li>so <em>it</em> is</li></ol>\n'
)
SOLUTION = Illustrated((SOLUTION_TEXT, PICTURE, "<p>Hence it is so.</p>\n"))


def question(
    paper: str,
    name: str,
    asks: tuple[QuizAsk, ...],
    language: Literal["en", "zh"] = "en",
    **more: object,
) -> QuizQuestion:
    """A question of a paper, with a figure."""
    sheet = make_sheet(name, TITLE[language], STATEMENT[language], asks, FIGURE)
    printed = {part: more.pop(part) for part in ("statement", "figure") if part in more}
    sheet = replace(sheet, **printed)  # type: ignore[arg-type]
    made = QuizQuestion(f"exam-{paper}-{name}", sheet, asks, NOT_SHOWN, RULE[language])
    return replace(made, **more)  # type: ignore[arg-type]


def make_sheet(
    name: str,
    title: str,
    statement: str,
    asks: Sequence[QuizAsk],
    figure: Scene | None = None,
) -> QuestionSheet:
    """The sheet of a question that asks for these."""
    rows = tuple(ask.row for ask in asks)
    points = sum((row.points for row in rows), Fraction(0))
    described = Description(f"{name} in words & numbers", (Prose("$A$ lies to the right."),))
    sheet = QuestionSheet(int(name[1:]), name, title, points, statement, figure, rows)
    return sheet if figure is None else replace(sheet, described=described)


def papers(language: Literal["en", "zh"] = "en") -> tuple[QuizPaper, ...]:
    """Two students' papers."""
    first = question("P1", "q1", (SPEED, ACCELERATION, ZERO, UNEVEN), language, solution=SOLUTION)
    second = question("P1", "q2", (ANGLE, RATIO, TINY), language, figure=None)
    other = replace(SPEED, value=Fraction(3), low=Fraction("2.94"), high=Fraction("3.06"))
    return (
        QuizPaper("P1", "0012345", '王伟 <&> "Bo"', (first, second)),
        QuizPaper(
            "P2",
            "=1+1",
            "O'Neil",
            (question("P2", "q1", (other, ACCELERATION, ZERO, UNEVEN), language),),
        ),
    )


def quiz(language: Literal["en", "zh"] = "en") -> Quiz:
    """A quiz with a paper for every student."""
    return Quiz(language, "Mechanics I", "Kinematics & <quiz> ]]>", iter(papers(language)), "4711")


def pooled(language: Literal["en", "zh"] = "en") -> Quiz:
    """The same questions for everybody, two variants of the first and one of the second."""
    variants = (replace(paper, student="", name="") for paper in papers(language))
    return Quiz(language, "Mechanics I", "Kinematics", variants, "4711")


def all_asks() -> dict[str, QuizAsk]:
    """The asks of the first paper."""
    return {one.identifier: one for question in papers()[0].questions for one in question.asks}

"""Papers and keys as an exam's setting would fill them, for the tests of typesetting."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from kinegrade.press.sheet import (
    AnswerRow,
    KeyAnswer,
    KeyBook,
    KeyEntry,
    KeyPaper,
    KeyParameter,
    Paper,
    QuestionSheet,
)

ENGLISH_QUESTION = QuestionSheet(
    number=1,
    identifier="q1",
    title="Slider-crank: velocity of the slider $B$",
    points=Fraction(7),
    statement=r"""The crank $OA$ of length $r = 0.25\,\mathrm{m}$ turns **clockwise** about $O$ with the
constant angular velocity $\omega = 8\,\mathrm{rad/s}$; $\varphi = 60^\circ$.

1. Find the velocity of the *slider*.
2. Find the angular velocity of the rod, by $$\boldsymbol{v}_B = \boldsymbol{v}_A + \boldsymbol{v}_{BA}$$""",
    figure=None,
    rows=(
        AnswerRow("v_B", "speed of the slider $B$", "m/s", "", Fraction(4)),
        AnswerRow(
            r"\omega_{AB}",
            "angular velocity of $AB$",
            "rad/s",
            "counter-clockwise positive",
            Fraction(3),
        ),
    ),
    source="Example 3",
)

CHINESE_QUESTION = replace(
    ENGLISH_QUESTION,
    title="曲柄滑块机构：滑块 $B$ 的速度",
    statement=r"""曲柄 $OA$ 长 $r = 0.25\,\mathrm{m}$，以匀角速度 $\omega$ 绕 $O$ 轴**顺时针**转动。
求“图示瞬时”滑块的速度。""",
    rows=(AnswerRow("v_B", "滑块 $B$ 的速度大小", "m/s", "向右为正", Fraction(7)),),
    source="例 3",
)

ENGLISH = Paper(
    language="en",
    course="Theoretical Mechanics",
    title="Midterm examination",
    date="14 November 2025",
    student="00123456",
    name="Đặng Thị Hồng",
    code="A-0001",
    rules=(r"An answer is right within 1 % of the exact value.", r"Write $0.866$ or $0{,}866$."),
    questions=(ENGLISH_QUESTION,),
)

CHINESE = replace(
    ENGLISH,
    language="zh",
    course="理论力学",
    title="期中考试",
    name="欧阳修远",
    rules=("答案与精确值相差不超过 1 % 判为正确。",),
    questions=(CHINESE_QUESTION,),
)

KEY_ENTRY = KeyEntry(
    identifier="q1",
    title="Slider-crank",
    parameters=(
        KeyParameter("r", r"\frac{1}{4}", "0.25", "m"),
        KeyParameter(r"\varphi", None, "60", "deg"),
        KeyParameter("k", None, "1.73205", "1"),
    ),
    answers=(
        KeyAnswer("v_B", r"\frac{2\sqrt{3}}{3}", "1.15470", "m/s", "[1.14315, 1.16625]", "4"),
        KeyAnswer(r"\omega_{AB}", None, "-0.957427", "rad/s", "[-0.967, -0.948]", "2.5"),
    ),
)


def key_book(papers: int) -> KeyBook:
    """A key of that many papers with one question each."""
    students = tuple(
        KeyPaper(f"{index:05}", "张喆", f"A-{index:04}", (KEY_ENTRY,)) for index in range(papers)
    )
    return KeyBook("en", "Theoretical Mechanics", "Key", "INSTRUCTOR ONLY", students)


# Papers of a class of unlike lengths, in two languages and in large print
SHORT, LONG = ENGLISH, replace(ENGLISH, questions=ENGLISH.questions * 5)
UNEVEN = {
    "early": SHORT,
    "long": LONG,
    "late": replace(SHORT, code="B-0002"),
    "chinese": CHINESE,
    "large": replace(LONG, large=True),
}
BOUNDS = [(None, 0), (None, 3), (1, 3), (3, 0)]  # pages asked for, and those of earlier papers

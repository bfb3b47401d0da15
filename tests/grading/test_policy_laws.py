"""What holds of every policy and every class: the laws of marking by one."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from kinegrade.grading.marks import Marks
from tests.grading.policies import (
    marked,
    marks_of,
    policy_of,
)

RESPONSES = st.sampled_from(
    [
        "2",
        "2.03",
        "2.1",
        "-2",
        "3",
        "3.2",
        "0",
        "0.003",
        "5",
        "30",
        "31",
        "390",
        "60",
        "",
        "abc",
        "2 rad/s",
        "2 m/s",
        "√3",
    ]
)


ROWS = st.lists(
    st.tuples(st.sampled_from(["007", "S9", "12"]), RESPONSES, RESPONSES, RESPONSES), max_size=5
)


HUNDREDTHS = st.lists(st.integers(0, 60), min_size=2, max_size=2)


REST = st.sampled_from(
    [
        "",
        "attempts = 'best'",
        "attempts = 'first'",
        "credit.wrong-unit = 0.5",
        "credit.mistakes = { transport-for-absolute = 0.5, sense-reversed = 1 }",
    ]
)


QUICK = settings(suppress_health_check=[HealthCheck.function_scoped_fixture])


def totals(marks: Marks) -> list[Fraction]:
    return [grade.total for grade in marks.grades]


def text_of(rows: list[tuple[str, ...]]) -> str:
    return "".join(",".join(row) + "\n" for row in rows)


@QUICK
@given(ROWS, HUNDREDTHS, REST, st.sampled_from(["relative", "absolute"]))
def test_a_wider_tolerance_lowers_nobody(
    tmp_path: Path, rows: list[tuple[str, ...]], hundredths: list[int], rest: str, kind: str
) -> None:
    sizes = [
        f"'{size} %'" if kind == "relative" else str(size / 100) for size in sorted(hundredths)
    ]
    narrow, wide = (
        marked(text_of(rows), policy_of(f"{rest}\ntolerance.{kind} = {size}", tmp_path))
        for size in sizes
    )
    assert [
        (old, new) for old, new in zip(totals(narrow), totals(wide), strict=True) if old > new
    ] == []


@QUICK
@given(ROWS, REST, st.sampled_from(["q1", "q2", "q1.asks.v_B", "q2.asks.phi"]))
def test_a_void_ask_gives_everybody_at_least_as_much(
    tmp_path: Path, rows: list[tuple[str, ...]], rest: str, place: str
) -> None:
    before = marked(text_of(rows), policy_of(rest, tmp_path))
    after = marked(
        text_of(rows), policy_of(f"{rest}\n[questions.{place}]\nvoid = 'full'", tmp_path)
    )
    assert [
        (old, new) for old, new in zip(totals(before), totals(after), strict=True) if old > new
    ] == []


@QUICK
@given(
    ROWS,
    REST,
    st.sampled_from(["", "[questions.q1]\nvoid = 'drop'", "[questions.q2]\nvoid = 'full'"]),
)
def test_every_typed_answer_comes_out_and_points_add_up(
    tmp_path: Path, rows: list[tuple[str, ...]], rest: str, void: str
) -> None:
    marks = marked(text_of(rows), policy_of(f"{rest}\n{void}", tmp_path))
    kept = {complaint.content for complaint in marks.complaints}
    students = [grade.student for grade in marks.grades]
    counted = {(who, *(mark.reading.typed for mark in marks_of(marks, who))) for who in students}
    assert [row for row in rows if not (row in counted or ",".join(row) in kept)] == []
    for grade in marks.grades:
        own = marks_of(marks, grade.student)
        assert grade.total == sum(mark.points for mark in own) <= grade.out_of
        assert [mark for mark in own if not (0 <= mark.points <= mark.ask.points)] == []

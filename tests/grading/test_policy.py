"""Marking by a policy: what each of its words does to an answer, and what no policy may do."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import PolicyError
from kinegrade.exam.folder.keys import Key
from kinegrade.grading.judging.decision import decide
from kinegrade.grading.judging.judge import judge
from kinegrade.grading.policy.policy import Ruling
from kinegrade.grading.policy.reading import read_policy, stated_policy
from kinegrade.grading.typed.answers import Reading
from kinegrade.numbers.tolerance import Tolerance
from tests.grading.policies import (
    ACCEPTED,
    drawn_exam,
    folder_of,
    marked,
    marks_of,
    policy_of,
    regraded,
    told,
)
from tests.said import said

ATTEMPTS = "007,9,0,1\n007,2,0,30\n007,2,9,30\n"


def test_an_empty_policy_changes_nothing(tmp_path: Path) -> None:
    rows = "007,2.02,0.002,389\nS9,abc,1 m,\n"
    assert marked(rows, policy_of("# nothing\n", tmp_path)) == marked(rows)


@pytest.mark.parametrize(
    "policy",
    [
        "tolerance = { relative = '5 %' }",
        "[questions.q1]\ntolerance = { relative = 0.05 }",
        "[questions.q1.asks.v_B]\ntolerance = { relative = '1/20' }",
        "tolerance.relative = 0\n[questions.q1.asks.v_B]\ntolerance.relative = '5%'",
        "tolerance.absolute = 0.1",
    ],
)
def test_a_tolerance_of_the_policy_is_closed(tmp_path: Path, policy: str) -> None:
    marks = marked("007,2.1,,\nS9,2.1000000000000000000000001,,\n", policy_of(policy, tmp_path))
    assert told(marks, "007") == ("right", 4, "key 2, difference 0.1, allowed 0.1 by the policy")
    assert told(marks, "S9")[0] == "wrong"


def test_what_a_policy_does_not_say_of_a_tolerance_stays(tmp_path: Path) -> None:
    relative = marked(
        "007,,0.002,\nS9,,0.0021,\n", policy_of("tolerance.relative = '2 %'", tmp_path)
    )
    assert told(relative, "007", 1) == (
        "right",
        3,
        "key 0, difference 0.002, allowed 0.002 by the policy",
    )
    assert told(relative, "S9", 1)[0] == "wrong"
    figures = marked("007,2.5,,\nS9,1.49,,\n", policy_of("tolerance.figures = 1", tmp_path))
    assert told(figures, "007")[2] == "key 2, difference 0.5, right from 1.5 to 2.5 by the policy"
    assert told(figures, "S9")[0] == "wrong"


def test_a_void_ask_gives_full_points_to_whoever_handed_in(tmp_path: Path) -> None:
    marks = marked(
        "007,1,,\nS9,,,\n", policy_of("[questions.q1.asks.v_B]\nvoid = 'full'", tmp_path)
    )
    by_key = "by the key: wrong (key 2, difference 1, allowed 0.02)"
    assert told(marks, "007") == ("void", 4, f"full points to everybody who handed in; {by_key}")
    assert told(marks, "S9") == (
        "void",
        0,
        "full points to everybody who handed in; nothing was handed in",
    )
    assert told(marks, "12") == (
        "void",
        0,
        "full points to everybody who handed in; nothing was handed in",
    )
    assert [grade.out_of for grade in marks.grades] == [Fraction(19, 2)] * 3


def test_a_dropped_question_leaves_the_total(tmp_path: Path) -> None:
    marks = marked("007,2,0,30\n", policy_of("[questions.q1]\nvoid = 'drop'", tmp_path))
    assert told(marks, "007") == (
        "void",
        0,
        "no part of the total; by the key: right (key 2, difference 0, allowed 0.02)",
    )
    assert (marks.grades[0].points, marks.grades[0].out_of) == ((0, Fraction(5, 2)), Fraction(5, 2))
    assert marks.grades[0].percent == 100


def test_points_are_weighed_anew(tmp_path: Path) -> None:
    marks = marked("007,2,9,30\n", policy_of("[questions.q1.asks.v_B]\npoints = 1.5", tmp_path))
    assert (marks.grades[0].points, marks.grades[0].out_of) == (
        (Fraction(3, 2), Fraction(5, 2)),
        Fraction(7),
    )


@pytest.mark.parametrize(
    ("accepted", "typed", "points", "said"),
    [
        ("{ value = '2*sqrt(3)' }", "√12", 4, "2*sqrt(3) = 3.4641, difference 0, allowed 0.034641"),
        (
            "{ value = '360', unit = 'cm/s', credit = '1/2' }",
            "3.6",
            2,
            "360 = 3.6, difference 0, allowed 0.036",
        ),
        ("{ value = '-v_B' }", "-2.02", 4, "-v_B = -2, difference 0.02, allowed 0.02"),
        (
            "{ value = 'sin(pi/6) + v_B' }",
            "2.5",
            4,
            "sin(pi/6) + v_B = 2.5, difference 0, allowed 0.025",
        ),
        ("{ value = 7, student = '007' }", "7", 4, "7 = 7, difference 0, allowed 0.07"),
        (
            "{ value = 7.25, credit = '25 %', student = ['S9', '007'] }",
            "7.25",
            1,
            "7.25 = 7.25, difference 0, allowed 0.0725",
        ),
    ],
)
def test_an_accepted_answer_counts_and_the_reason_says_which(
    tmp_path: Path, accepted: str, typed: str, points: int, said: str
) -> None:
    marks = marked(f"007,{typed},,\n", policy_of(ACCEPTED.format(accepted), tmp_path))
    assert told(marks, "007") == ("accepted", points, f"accepted answer 1 of the policy, {said}")


@pytest.mark.parametrize(
    ("value", "typed"),
    [
        ("2*sqrt(3)", "√12"),
        ("sqrt(2) + sqrt(3) + sqrt(5) + sqrt(7)", "√2+√3+√5+√7"),
        ("1/3", "1/3"),
        ("cos(pi/6)", "√3/2"),
    ],
)
def test_an_accepted_answer_is_exact(tmp_path: Path, value: str, typed: str) -> None:
    policy = policy_of(
        f"tolerance.relative = 0\n{ACCEPTED.format(f'{{ value = {value!r} }}')}", tmp_path
    )
    marks = marked(f"007,{typed},,\nS9,({typed})*1.000000000000000000000000000001,,\n", policy)
    assert [told(marks, student)[0] for student in ("007", "S9")] == ["accepted", "wrong"]


def test_an_accepted_answer_may_be_for_some_students_only(tmp_path: Path) -> None:
    policy = policy_of(ACCEPTED.format("{ value = 7, student = 'S9' }"), tmp_path)
    marks = marked("007,7,,\nS9,7,,\n", policy)
    assert [told(marks, student)[0] for student in ("007", "S9")] == ["wrong", "accepted"]


@pytest.mark.parametrize("value", ["pi/3", "2*phi", "acos(1/2)", "phi + pi/6", "atan2(sqrt(3), 1)"])
def test_an_accepted_angle_is_an_angle_whatever_its_unit(tmp_path: Path, value: str) -> None:
    policy = policy_of(f"[questions.q2.asks.phi]\naccept = [{{ value = '{value}' }}]", tmp_path)
    marks = marked("007,,,60\nS9,,,-300\n12,,,1.0472\n", policy)
    assert [told(marks, student, 2)[0] for student in ("007", "S9", "12")] == [
        "accepted",
        "accepted",
        "wrong",
    ]


@pytest.mark.parametrize("unit", ["", ', unit = "rpm"', ', unit = "rad/s"'])
def test_an_accepted_answer_may_use_the_numbers_of_each_paper(tmp_path: Path, unit: str) -> None:
    exam = drawn_exam(tmp_path / "EXAM")
    (tmp_path / "answers.csv").write_text(
        "student,q1.v_B,q1.omega_AB,q2.a_B\n007,π,15 rpm,\n0012,2π,30 rpm,\nS9,3π,π/2,\n12,-4π,,\n",
        encoding="utf-8",
    )
    policy = f"""
        [questions.q1.asks.v_B]
        accept = [{{ value = "r*omega" }}, {{ value = "-r*omega + 0*h*omega", credit = 0.5 }}]
        [questions.q1.asks.omega_AB]
        accept = [{{ value = "omega*sin(phi)"{unit} }}]
    """
    regraded(exam, "MARKS", policy)
    lines = (tmp_path / "MARKS" / "grades.csv").read_text(encoding="utf-8").splitlines()
    assert [line.split(",")[-6:-4] for line in lines[1:]] == [
        ["7", "0"],
        ["4", "0"],
        ["7", "0"],
        ["2", "0"],
    ]


@pytest.mark.parametrize(
    ("typed", "policy", "expected"),
    [
        ("3", "", ("mistake", 0)),
        ("3", "credit.mistakes = { transport-for-absolute = '1/2' }", ("mistake", 2)),
        ("-2", "credit.mistakes = { transport-for-absolute = '1/2' }", ("mistake", 0)),
        ("3.03", "credit.mistakes = { transport-for-absolute = 1 }", ("mistake", 4)),
        ("3.04", "credit.mistakes = { transport-for-absolute = 1 }", ("wrong", 0)),
        (
            "3",
            "credit.mistakes.transport-for-absolute = "
            "1\n[questions.q1.credit.mistakes]\ntransport-for-absolute = 0.25",
            ("mistake", 1),
        ),
    ],
)
def test_a_known_mistake_is_named_and_gets_its_credit(
    tmp_path: Path, typed: str, policy: str, expected: tuple[str, int]
) -> None:
    assert told(marked(f"007,{typed},,\n", policy_of(policy, tmp_path)), "007")[:2] == expected


def unread(typed: str) -> Reading:
    """Nothing that was typed is read again here."""
    return Reading("unreadable", typed)


@given(
    st.fractions(-100, 100, max_denominator=1000),
    st.fractions(-100, 100, max_denominator=1000),
    st.sampled_from([None, 1, 2, 3]),
    st.sampled_from(["0", "1/100", "1/2"]),
    st.sampled_from(["0", "1/10"]),
)
def test_no_mistake_within_the_tolerance_is_overlooked(
    typed: Fraction, wrong: Fraction, figures: int | None, relative: str, absolute: str
) -> None:
    stated = Tolerance(Fraction(relative), Fraction(absolute), figures)
    bounds = [*Key(wrong, stated).interval, typed]
    for value in bounds:
        reading = Reading("number", "x", value)
        right = judge(reading, Key(wrong, stated)).kind == "right"
        decided = decide(
            reading, Key(Fraction(1000), stated, None, {"slip": wrong}), Ruling(), (), unread
        )
        assert decided[0].kind == ("mistake" if right else "wrong")


def test_the_reason_names_the_mistake_and_the_best_credit_counts(tmp_path: Path) -> None:
    assert told(marked("007,3.01,,\n"), "007")[2] == (
        "transport-for-absolute: leads to 3, difference 0.01, allowed 0.03"
    )
    both = (
        ACCEPTED.format("{ value = 3, credit = 0.25 }")
        + "credit.mistakes = { transport-for-absolute = 0.5 }\n"
    )
    assert told(marked("007,3,,\n", policy_of(both, tmp_path)), "007")[:2] == ("mistake", 2)
    assert (
        told(marked("007,3,,\n", policy_of(both.replace("0.5", "0.25"), tmp_path)), "007")[0]
        == "accepted"
    )


@pytest.mark.parametrize(
    ("typed", "points"),
    [
        ("2 rad/s", 2),
        ("2.02m", 2),
        ("√4 m/s²", 2),
        ("2.1 rad", 0),
        ("2 m/s", 4),
        ("2 apples", 0),
        ("v_B = 2 Hz", 2),
    ],
)
def test_the_right_number_in_a_wrong_unit_may_get_credit(
    tmp_path: Path, typed: str, points: int
) -> None:
    marks = marked(f"007,{typed},,\n", policy_of("credit.wrong-unit = '50 %'", tmp_path))
    assert told(marks, "007")[1] == points
    assert told(marks, "007")[2].endswith("; the number is right, credit by the policy") == (
        points == 2
    )


@pytest.mark.parametrize(
    ("attempts", "line", "total"),
    [("last", 4, Fraction(13, 2)), ("first", 2, 3), ("best", 3, Fraction(19, 2))],
)
def test_of_several_rows_the_policy_says_which_counts(
    tmp_path: Path, attempts: str, line: int, total: Fraction
) -> None:
    marks = marked(ATTEMPTS, policy_of(f"attempts = '{attempts}'", tmp_path))
    assert marks.grades[0].total == total
    rows = [
        complaint
        for complaint in marks.complaints
        if said(complaint.problem).startswith("another row")
    ]
    assert [complaint.line for complaint in rows] == [
        number for number in (2, 3, 4) if number != line
    ]
    assert {said(complaint.done) for complaint in rows} == {
        f"line {line} counts; this row is kept here only"
    }
    assert [complaint.content for complaint in rows] == [
        row for number, row in enumerate(ATTEMPTS.splitlines(), 2) if number != line
    ]


def test_of_equally_good_rows_the_last_counts(tmp_path: Path) -> None:
    marks = marked("007,2,,\n007,2.01,,\n007,,,30\n", policy_of("attempts = 'best'", tmp_path))
    assert [mark.reading.typed for mark in marks_of(marks, "007")] == ["2.01", "", ""]


def test_numbers_drawn_are_needed_only_where_a_policy_names_them(exam_folder: Path) -> None:
    (exam_folder.parent / "answers.csv").write_text("student,q1.v_B\n007,1\n", encoding="utf-8")
    regraded(exam_folder, "MARKS", ACCEPTED.format("{ value = 1 }"))
    with pytest.raises(PolicyError, match='unknown name "r" - known here: omega_AB, v_B$'):
        regraded(exam_folder, "MARKS2", ACCEPTED.format("{ value = 'r' }"))


def test_the_policy_is_kept_beside_the_marks_and_the_same_one_gives_the_same_bytes(
    exam_folder: Path,
) -> None:
    (exam_folder.parent / "answers.csv").write_text(
        "student,q1.v_B\n007,9\n007,1.7\n", encoding="utf-8"
    )
    policy = "attempts = 'best' # 先\r\n" + ACCEPTED.format("{ value = 'v_B/2' }")
    first, second = (regraded(exam_folder, name, policy) for name in ("MARKS", "MARKS2"))
    contents = [
        {file.name: file.read_bytes() for file in folder.iterdir()} for folder in (first, second)
    ]
    assert contents[0] == contents[1]
    assert contents[0]["policy.toml"] == (exam_folder.parent / "MARKS.toml").read_bytes()
    without = regraded(exam_folder, "MARKS3") / "policy.toml"
    assert without.read_text(encoding="utf-8") == "# No policy: marked as the papers say.\n"


def test_the_credit_of_the_bank_holds_until_a_policy_says_otherwise(tmp_path: Path) -> None:
    bank = {"wrong-unit": "1/2", "follow-through": "0", "mistakes": {"sense-reversed": "1/4"}}
    exam = folder_of(tmp_path, credit=bank)
    printed = stated_policy(exam).ruling("q1.v_B")
    assert (printed.wrong_unit, printed.follow_through) == (Fraction(1, 2), 0)
    assert printed.mistakes == {"sense-reversed": Fraction(1, 4)}
    (tmp_path / "policy.toml").write_text("credit = { wrong-unit = 0 }", encoding="utf-8")
    regraded_by = read_policy(tmp_path / "policy.toml", exam).ruling("q1.v_B")
    assert (regraded_by.wrong_unit, regraded_by.follow_through) == (0, 0)
    assert regraded_by.mistakes == printed.mistakes

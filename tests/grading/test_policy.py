"""Marking by a policy: what each of its words does to an answer, and what no policy may do."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from kinegrade.errors import PolicyError
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.folder.keys import Key
from kinegrade.grading.grade import MarkingWishes
from kinegrade.grading.grade import grade as mark_class
from kinegrade.grading.judging.decision import decide
from kinegrade.grading.judging.judge import judge
from kinegrade.grading.marks import Marks
from kinegrade.grading.policy.policy import Ruling
from kinegrade.grading.policy.reading import read_policy, stated_policy
from kinegrade.grading.typed.answers import Reading
from kinegrade.numbers.tolerance import Tolerance
from tests.grading.policies import (
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
ACCEPTED = "[questions.q1.asks.v_B]\naccept = [{}]\n"


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
        accept = [{{ value = "r*omega" }}, {{ value = "-r*omega + 0*h", credit = 0.5 }}]
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


SHARE = 'expected a share from 0 to 1, like 0.5, "50 %" or "1/2"'
AMOUNT = (
    "expected a number of zero or more like 2.5, at most 9 digits before the point and 12 after it"
)
HONEST = (
    "an honest tolerance is found as an exam is set, from the numbers of each paper - expected a "
    'tolerance for all papers, like { relative = "3 %" } - write honest in the bank of the next '
    "exam"
)
TOLERANCES = '{ relative = "1 %" }, { absolute = 0.01 } or { figures = 3 }'
CONTENT = """
attempts = "lst"
tolerence = 3
credit = { wrong_unit = 2, mistakes = { sense-revers = 1 }, wrong-unit = 1.5 }
[questions.q9]
[questions.q1]
tolerance = { relative = "200 %", figures = 0, absolute = -1 }
[questions.q1.asks]
vB.points = 3
v_B = { points = true, void = true, accept = [{ value = "r*(", credit = "1/0" }, 7, { value = "r3", unit = "rad" }] }
omega_AB = { accept = [{ value = "2", unit = "x", student = ["008", 7] }, { value = "1", unit = 3 }] }
[questions.q2]
asks = 3
"""


def test_all_faults_of_a_policy_are_told_at_once(tmp_path: Path) -> None:
    (tmp_path / "key.jsonl").write_text(
        '{"student": "007", "questions": [{"question": "q1", "parameters": {}, "asks": {}}]}',
        encoding="utf-8",
    )
    with pytest.raises(PolicyError) as caught:
        policy_of(CONTENT, tmp_path)
    assert [
        problem.removeprefix(str(tmp_path / "policy.toml")) for problem in caught.value.problems
    ] == [
        ':2: attempts: "lst" - expected last, first or best',
        ':3: tolerence: unknown key - did you mean "tolerance"? '
        "(known here: attempts, credit, late, questions, scale, tolerance, tries)",
        ':4: credit.wrong_unit: unknown key - did you mean "wrong-unit"? '
        "(known here: follow-through, mistakes, wrong-unit)",
        ':4: credit.mistakes.sense-revers: unknown mistake - did you mean "sense-reversed"? '
        "(known here: sense-reversed, transport-for-absolute)",
        f":4: credit.wrong-unit: 1.5 - {SHARE}",
        ":5: questions.q9: unknown question - known here: q1, q2",
        f':7: questions.q1.tolerance.relative: "200 %" - {SHARE}',
        f":7: questions.q1.tolerance.absolute: -1 - {AMOUNT}",
        ":7: questions.q1.tolerance.figures: 0 - expected a whole number from 1 to 15",
        ':9: questions.q1.asks.vB: unknown ask - did you mean "v_B"? (known here: omega_AB, v_B)',
        ":10: questions.q1.asks.v_B.void: true - expected full or drop",
        f":10: questions.q1.asks.v_B.points: true - {AMOUNT}",
        ':10: questions.q1.asks.v_B.accept[2]: 7 - expected a table like { value = "2*sqrt(3)" }',
        f':10: questions.q1.asks.v_B.accept[1].credit: "1/0" - {SHARE}',
        ':10: questions.q1.asks.v_B.accept[1].value: "r*(", character 4: found the end, '
        "expected a number, a name or a bracket",
        ':10: questions.q1.asks.v_B.accept[3].value: unknown name "r3" - known here: omega_AB, v_B',
        ':10: questions.q1.asks.v_B.accept[3].unit: "rad" measures an angle; a speed was expected, '
        'in "m/s"',
        ':11: questions.q1.asks.omega_AB.accept[1].student[1]: no student "008" '
        '- did you mean "007"?',
        ":11: questions.q1.asks.omega_AB.accept[1].student[2]: 7 - expected a student's id in "
        "quotation marks",
        ':11: questions.q1.asks.omega_AB.accept[1].unit: "x" stands after the number; the unit '
        '"rad/s" was expected',
        ':11: questions.q1.asks.omega_AB.accept[2].unit: 3 - expected a unit like "rad/s"',
        ":13: questions.q2.asks: 3 - expected a table",
    ]


@pytest.mark.parametrize(
    ("content", "problem"),
    [
        ("accept = 1", 'accept: 1 - expected a list of tables like [{ value = "2*sqrt(3)" }]'),
        (
            "accept = [{ student = '0' }]",
            'accept[1].student: no student "0" - check the id against the roster',
        ),
        (
            "accept = [{ student = 7 }]",
            "accept[1].student: 7 - expected a student's id in quotation marks",
        ),
        (
            "accept = [{ value = true }]",
            'accept[1].value: true - expected a number or an expression like "2*sqrt(3)"',
        ),
        (
            "accept = [{ valeu = 1 }]",
            'accept[1].valeu: unknown key - did you mean "value"? '
            "(known here: credit, student, unit, value)",
        ),
        (
            "accept = [{ unit = 'm/s' }]",
            'accept[1].value: missing - expected a number or an expression like "2*sqrt(3)"',
        ),
        ("tolerance = 1", f"tolerance: 1 - expected a table like {TOLERANCES}"),
        ('tolerance = "honest"', f"tolerance: {HONEST}"),
        ("tolerance = { relative = 0.01, honest = true }", f"tolerance: {HONEST}"),
        ("tolerance.relative = nan", f"tolerance.relative: nan - {SHARE}"),
        ("points = 1e9", f"points: 1e9 - {AMOUNT}"),
        ("points = 0.1234567890123", f"points: 0.1234567890123 - {AMOUNT}"),
    ],
)
def test_a_fault_of_a_policy_says_what_was_expected(
    tmp_path: Path, content: str, problem: str
) -> None:
    with pytest.raises(PolicyError) as caught:
        policy_of(f"[questions.q1.asks.v_B]\n\n{content}", tmp_path)
    file = tmp_path / "policy.toml"
    assert caught.value.problems[0] == f"{file}:3: questions.q1.asks.v_B.{problem}"


@pytest.mark.parametrize(
    ("value", "reason"),
    [
        ("1/(v_B - 2)", "division by zero: check the values given"),
        ("sqrt(-v_B)", "sqrt(...): square root of a negative number: check the values given"),
        ("(1, 2)", "a pair (x, y): expected a number or an angle here"),
        ("1e99*1e99", "a value beyond 1e99 or below 1e-99"),
        ("9**16**16", "a power must be a whole number of at most 16: for roots write sqrt(...)"),
        (
            "v_B + pi",
            '"+" between things that do not go together: '
            "angles go with angles, points with points, numbers with numbers",
        ),
    ],
)
def test_an_accepted_answer_without_a_value_is_refused(
    tmp_path: Path, value: str, reason: str
) -> None:
    policy = policy_of(ACCEPTED.format(f"{{ value = '{value}' }}"), tmp_path)
    with pytest.raises(PolicyError) as caught:
        marked("007,1,,\n", policy)
    assert str(caught.value) == (
        f'policy: q1.v_B: accepted answer 1, "{value}", has no value for student "007" and 2 '
        f"more ({reason}) - expected one number - fix it"
    )


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (
            b"attempts = ",
            "Invalid value (at end of document) - expected a policy file in TOML - fix it",
        ),
        (
            b"\xff",
            "not UTF-8 at byte 0 - expected a policy file in UTF-8 - fix it",
        ),
        (
            b"#" * 1_000_001,
            "too large - expected a policy file of at most 1000000 bytes - check the name",
        ),
        (
            None,
            "cannot be read (No such file or directory) - expected a policy file - check the name",
        ),
    ],
    ids=["not TOML", "not UTF-8", "too large", "missing"],
)
def test_a_file_that_is_no_policy_is_refused_and_leaves_nothing(
    exam_folder: Path, content: bytes | None, reason: str
) -> None:
    file = exam_folder.parent / "policy.toml"
    if content is not None:
        file.write_bytes(content)
    (exam_folder.parent / "answers.csv").write_text("student,q1.v_B\n007,1\n", encoding="utf-8")
    with pytest.raises(PolicyError) as caught:
        mark_class(
            open_exam(exam_folder),
            exam_folder.parent / "answers.csv",
            exam_folder.parent / "MARKS",
            MarkingWishes(policy=file),
        )
    assert str(caught.value) == f"{file}: {reason}"
    assert not (exam_folder.parent / "MARKS").exists()


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
    assert all(old <= new for old, new in zip(totals(narrow), totals(wide), strict=True))


@QUICK
@given(ROWS, REST, st.sampled_from(["q1", "q2", "q1.asks.v_B", "q2.asks.phi"]))
def test_a_void_ask_gives_everybody_at_least_as_much(
    tmp_path: Path, rows: list[tuple[str, ...]], rest: str, place: str
) -> None:
    before = marked(text_of(rows), policy_of(rest, tmp_path))
    after = marked(
        text_of(rows), policy_of(f"{rest}\n[questions.{place}]\nvoid = 'full'", tmp_path)
    )
    assert all(old <= new for old, new in zip(totals(before), totals(after), strict=True))


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
    assert all(row in counted or ",".join(row) in kept for row in rows)
    for grade in marks.grades:
        own = marks_of(marks, grade.student)
        assert grade.total == sum(mark.points for mark in own) <= grade.out_of
        assert all(0 <= mark.points <= mark.ask.points for mark in own)


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


def test_a_broken_credit_of_the_bank_is_told(tmp_path: Path) -> None:
    with pytest.raises(PolicyError) as caught:
        stated_policy(folder_of(tmp_path, credit={"wrong-unit": "2"}))
    assert str(caught.value) == (
        f'{tmp_path / "exam.json"}: credit.wrong-unit: "2" - expected a share from 0 to 1, like '
        '0.5, "50 %" or "1/2" '
        "- restore the exam folder as it was generated"
    )


def test_an_accepted_answer_that_cannot_be_told_from_zero_is_refused(tmp_path: Path) -> None:
    value = "sqrt((sin(1)**2 + cos(1)**2 - 1)*10**16*10**16*10**16)"
    with pytest.raises(PolicyError, match="a value cannot be distinguished from zero") as caught:
        marked("007,1,,\n", policy_of(ACCEPTED.format(f"{{ value = '{value}' }}"), tmp_path))
    assert len(caught.value.faults) == 1

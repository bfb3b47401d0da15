"""What is wrong with a policy, all of it told at once, and what is no policy at all."""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.errors import PolicyError
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.grading.grade import MarkingWishes
from kinegrade.grading.grade import grade as mark_class
from kinegrade.grading.policy.reading import stated_policy
from tests.grading.policies import (
    ACCEPTED,
    folder_of,
    marked,
    policy_of,
)

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
            "accept = [{ value = '(1, 2)' }]",
            "accept[1].value: a pair (x, y) - expected a number or an angle here",
        ),
        (
            "accept = [{ value = 'omega_AB' }]",
            'accept[1].value: this is an angular velocity (rad/s): it cannot be counted in "m/s" - fix it',
        ),
        (
            "accept = [{ value = 'v_B*cos(60)' }]",
            "accept[1].value: 60 radians - did you mean 60 degrees? write pi/3",
        ),
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
            "(known here: credit, leads, student, unit, value)",
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
        ("v_B*v_B/(v_B - 2)", "division by zero: check the values given"),
        ("sqrt(-v_B*v_B)", "sqrt(...): square root of a negative number: check the values given"),
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


def test_a_broken_credit_of_the_bank_is_told(tmp_path: Path) -> None:
    with pytest.raises(PolicyError) as caught:
        stated_policy(folder_of(tmp_path, credit={"wrong-unit": "2"}))
    assert str(caught.value) == (
        f'{tmp_path / "exam.json"}: credit.wrong-unit: "2" - expected a share from 0 to 1, like '
        '0.5, "50 %" or "1/2" '
        "- restore the exam folder as it was generated"
    )


def test_an_accepted_answer_that_cannot_be_told_from_zero_is_refused(tmp_path: Path) -> None:
    value = "sqrt((sin(pi/180)**2 + cos(pi/180)**2 - 1)*10**16*10**16*10**16)"
    with pytest.raises(PolicyError, match="a value cannot be distinguished from zero") as caught:
        marked("007,1,,\n", policy_of(ACCEPTED.format(f"{{ value = '{value}' }}"), tmp_path))
    assert len(caught.value.faults) == 1


def test_a_policy_that_drops_all_that_counts_is_refused(tmp_path: Path) -> None:
    dropped = '[questions.q1]\nvoid = "drop"\n[questions.q2]\nvoid = "drop"\n'
    with pytest.raises(PolicyError) as caught:
        policy_of(dropped, tmp_path)
    assert str(caught.value) == (
        f"{tmp_path / 'policy.toml'}: every question that counts is dropped - leave one that counts, "
        'or give all points for it with void = "full"'
    )

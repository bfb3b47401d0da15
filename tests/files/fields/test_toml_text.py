"""What people type that is no TOML is named by its line, with what to write instead."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from kinegrade.cli import main
from kinegrade.errors import TomlError
from kinegrade.files.fields.toml_text import read_toml
from tests.grading.small_exam import STUDENTS, exam, paper, write_exam
from tests.problem.crank import crank_text


@pytest.mark.parametrize(
    ("text", "slip"),
    [
        ("title = “Quiz”", '“: a curly quotation mark: write straight ones, "..."'),
        ("a = { unit = ”m” }", '”: a curly quotation mark: write straight ones, "..."'),
        ("title = « Quiz »", '«: a curly quotation mark: write straight ones, "..."'),
        (
            "draw = [30°, 60°]",
            '30°: a number without its unit is expected: write 30, and unit = "deg"',
        ),
        (
            "date = 3.12.2026",
            '3.12.2026: write a date as 2026-12-03, or as a text in quotation marks, "3.12.2026"',
        ),
        (
            "date = 3/12/2026",
            "3/12/2026: write a date as year-month-day, like 2026-05-01, "
            'or as a text in quotation marks, "3/12/2026"',
        ),
        (
            "date = 2026-5-1",
            "2026-5-1: write a date as year-month-day, like 2026-05-01, "
            'or as a text in quotation marks, "2026-5-1"',
        ),
        ("points＝3", '＝: a full-width character: write "="'),
        ("points = 0,5", "0,5: a decimal comma: write a point, 0.5"),
        ("relative = 2 %", '2 %: write a percentage in quotation marks, "2 %"'),
        ("title: Quiz", "title: write = between a name and its value, not a colon"),
        ("unit = m", 'm: a text or an expression needs quotation marks: write "m"'),
        ("draw = [1/2, 3]", '1/2: a text or an expression needs quotation marks: write "1/2"'),
        ("shuffle = True", "True: write true"),
        ("shuffle = yes", "yes: write true"),
        ("solutions = No", "No: write false"),
        ('date = "2026', '"2026: a quotation mark without its partner: close it'),
        ("a = 'it's'", "': a quotation mark without its partner: close it"),
        ('t = "slider”', '”: a curly quotation mark: write straight ones, "..."'),
        ("a = { v = 3; w = 2 }", ";: write a comma between entries, not a semicolon"),
        (
            "asks = { v_B = 3, omega_AB = 2",
            "{ is not closed: write } at the end of the table, in the same line",
        ),
        (
            'i = { m = "OA turns", velocity = omega, acceleration = "0" }',
            'omega: a text or an expression needs quotation marks: write "omega"',
        ),
        ("first = 1", "first: stands in this table before: leave one of the two out"),
    ],
)
def test_a_usual_slip_is_named_with_its_line(text: str, slip: str) -> None:
    with pytest.raises(TomlError) as refusal:
        read_toml(f'first = "“fine”, 30°"  # 3.12.2026\n{text}\nlast = 1\n')
    assert (refusal.value.line, str(refusal.value)) == (2, slip)


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ("a = ", "Invalid value (at end of document)"),
        ("[a]\n[a]", "Cannot declare ('a',) twice"),
        ("a = " + "1" * 5000, "a whole number of more than 60 digits: round it"),
        ("a = " + "[" * 20000, "nested too deeply: write it more simply"),
        (".".join("a" * 5000) + " = 1", "nested too deeply: write it more simply"),
    ],
)
def test_any_other_fault_keeps_the_parsers_words(text: str, fault: str) -> None:
    with pytest.raises(TomlError) as refusal:
        read_toml(text)
    assert str(refusal.value) == fault


def test_a_template_a_bank_and_a_policy_name_the_slip(tmp_path: Path) -> None:
    exam_folder = write_exam(tmp_path / "EXAM", exam(), [paper(student) for student in STUDENTS])
    template = tmp_path / "crank.toml"
    template.write_text(crank_text(("draw = [1, 2]", "draw = [30°]")), encoding="utf-8")
    shown = CliRunner().invoke(main, ["check", str(template)])
    assert shown.exit_code == 2
    assert shown.stderr.strip().endswith(
        "crank.toml:14: 30°: a number without its unit is expected: "
        'write 30, and unit = "deg" - expected a template in TOML - fix it'
    )

    bank, roster = tmp_path / "bank.toml", tmp_path / "roster.csv"
    bank.write_text('title = "Quiz"\ndate = 3.12.2026\n', encoding="utf-8")
    roster.write_text("id,name\n007,Ada\n", encoding="utf-8")
    shown = CliRunner().invoke(
        main, ["generate", str(bank), str(roster), "-o", str(tmp_path / "exam")]
    )
    assert shown.exit_code == 2
    assert shown.stderr.strip().endswith(
        "bank.toml:2: 3.12.2026: write a date as 2026-12-03, "
        'or as a text in quotation marks, "3.12.2026" - expected a bank file in TOML - fix it'
    )
    assert not (tmp_path / "exam").exists()

    policy, answers = tmp_path / "policy.toml", tmp_path / "answers.csv"
    policy.write_text("attempts = “best”\n", encoding="utf-8")
    answers.write_text("student,q1.v_B\n007,1\n", encoding="utf-8")
    shown = CliRunner().invoke(
        main,
        [
            "grade",
            str(exam_folder),
            str(answers),
            "--policy",
            str(policy),
            "-o",
            str(tmp_path / "marks"),
        ],
    )
    assert shown.exit_code == 2
    assert shown.stderr.strip().endswith(
        'policy.toml:1: “: a curly quotation mark: write straight ones, "..." '
        "- expected a policy file in TOML - fix it"
    )

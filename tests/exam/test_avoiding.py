"""`kinegrade generate --avoid`: nobody gets numbers that anybody had in an earlier exam."""

from __future__ import annotations

import json
from pathlib import Path

from click.testing import Result

from kinegrade.draws.deck import make_deck
from kinegrade.draws.earlier import find_earlier_draws
from kinegrade.problem.template.library.library import load_template
from tests.problem.crank import crank, crank_text
from tests.small_class import contents, key_lines, kinegrade

BANK = """title = "Quiz"
course = "Mechanics"
[[questions]]
template = "crank.toml"
draw = {{ h = [1], r = [2], omega = {omega} }}
"""
EIGHT = '"1 .. 8 step 1"'


def write(folder: Path, students: int, omega: str = EIGHT) -> Path:
    """A bank that has eight combinations, and a roster."""
    (folder / "bank.toml").write_text(BANK.format(omega=omega), encoding="utf-8")
    (folder / "crank.toml").write_text(crank_text(), encoding="utf-8")
    rows = "".join(f"s{number},Ann {number}\n" for number in range(students))
    (folder / "roster.csv").write_text(f"student,name\n{rows}", encoding="utf-8")
    return folder


def generate(folder: Path, exam: str, *options: str | Path) -> Result:
    files = folder / "bank.toml", folder / "roster.csv"
    return kinegrade("generate", *files, "-o", folder / exam, *options)


def generated(folder: Path, exam: str, *options: str | Path) -> set[str]:
    """The angular velocities that a class was dealt."""
    result = generate(folder, exam, *options)
    assert result.exit_code == 0, result.stderr
    return dealt(folder / exam)


def dealt(exam: Path) -> set[str]:
    return {line["questions"][0]["drawn"]["omega"] for line in key_lines(exam)}


def test_nobody_gets_what_anybody_had(tmp_path: Path) -> None:
    write(tmp_path, 3)
    first = generated(tmp_path, "2025")
    result = generate(tmp_path, "2026", "--avoid", tmp_path / "2025")
    note = "q1 (crank): 3 combinations were dealt in earlier exams and are avoided, 5 are left"
    assert note in result.stderr.splitlines()
    second = dealt(tmp_path / "2026")
    assert (len(first), len(second), first & second) == (3, 3, set())
    write(tmp_path, 2)
    avoided = ("--avoid", tmp_path / "2025", "--avoid", tmp_path / "2026")
    third = generated(tmp_path, "2027", *avoided)
    assert third == set("12345678") - first - second


def test_late_students_keep_to_it(tmp_path: Path) -> None:
    write(tmp_path, 3)
    first = generated(tmp_path, "2025")
    generated(tmp_path, "2026", "--avoid", tmp_path / "2025")
    late = tmp_path / "late.csv"
    late.write_text("student,name\nz1,Late\nz2,Later\n", encoding="utf-8")
    result = generate(tmp_path, "2026", "--add", late)
    assert result.exit_code == 0, result.stderr
    assert dealt(tmp_path / "2026") == set("12345678") - first
    refused = generate(tmp_path, "2026", "--add", late, "--avoid", tmp_path / "2025")
    assert refused.exit_code == 2
    assert "--avoid" in refused.stderr


def test_a_class_that_is_generated_again_keeps_to_it(tmp_path: Path) -> None:
    write(tmp_path, 3)
    first = generated(tmp_path, "2025")
    second = generated(tmp_path, "2026", "--avoid", tmp_path / "2025")
    write(tmp_path, 5)
    grown = generated(tmp_path, "2026", "--force")
    assert grown == set("12345678") - first
    assert second < grown


def test_papers_that_stay_with_numbers_of_an_earlier_exam_are_named(tmp_path: Path) -> None:
    write(tmp_path, 3)
    generated(tmp_path, "2025", "--reproducible", "spring")
    generated(tmp_path, "2026", "--reproducible", "spring")
    result = generate(tmp_path, "2026", "--force", "--avoid", tmp_path / "2025")
    assert result.exit_code == 1
    assert "complaint: q1: 3 papers that stay have numbers of an earlier exam" in result.stderr
    again = generated(tmp_path, "2026", "--force", "--new-numbers", "--avoid", tmp_path / "2025")
    assert not again & dealt(tmp_path / "2025")


def test_too_few_are_refused_and_nothing_is_written(tmp_path: Path) -> None:
    write(tmp_path, 5)
    generated(tmp_path, "2025")
    before = contents(tmp_path)
    result = generate(tmp_path, "2026", "--avoid", tmp_path / "2025")
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr == (
        "error: q1 (crank): 3 of the 8 combinations of values are fit for 5 students, so some have "
        "the same numbers - expected one for each - widen the values to draw, ask for another template, or "
        "leave out an exam of --avoid\n"
    )
    assert contents(tmp_path) == before


def test_where_none_is_left_the_reason_is_said(tmp_path: Path) -> None:
    write(tmp_path, 8)
    generated(tmp_path, "2025")
    result = generate(tmp_path, "2026", "--avoid", tmp_path / "2025")
    assert result.exit_code == 2
    assert (
        "q1 (crank): none of the 8 combinations of values is fit for students (earlier exam 8)"
        in result.stderr
    )


def test_the_same_number_in_another_form_is_the_same(tmp_path: Path) -> None:
    write(tmp_path, 1, omega='["1/2"]')
    generated(tmp_path, "2025")
    write(tmp_path, 1, omega='["0.5", 3]')
    assert generated(tmp_path, "2026", "--avoid", tmp_path / "2025") == {"3"}


def test_what_is_avoided_is_no_exam_folder(tmp_path: Path) -> None:
    write(tmp_path, 1)
    result = generate(tmp_path, "2026", "--avoid", tmp_path / "2025")
    assert result.exit_code == 2
    assert result.stderr.startswith(f"error: {tmp_path / '2025'}")


def test_the_folder_holds_what_it_keeps_to(tmp_path: Path) -> None:
    write(tmp_path, 1)
    (omega,) = generated(tmp_path, "2025")
    generated(tmp_path, "2026", "--avoid", tmp_path / "2025")
    head = json.loads((tmp_path / "2026" / "exam.json").read_text(encoding="utf-8"))
    assert head["earlier"] == {"crank": [{"r": "2", "h": "1", "omega": omega}]}
    assert "earlier" not in (tmp_path / "2025" / "exam.json").read_text(encoding="utf-8")


def test_a_given_that_no_student_reads_does_not_make_other_numbers() -> None:
    template = load_template("slider-crank")
    deck = make_deck(template, "secret", "q1")
    had = {"r": "0.2", "k": "2", "phi": "30", "omega": "2", "alpha": "5"}
    other = {**had, "alpha": "10"}
    velocities = find_earlier_draws(template, ["v_B"], deck, [had])
    assert velocities.has(other)
    assert velocities.count(deck) == 3  # one for each angular acceleration
    accelerations = find_earlier_draws(template, ["a_B"], deck, [had])
    assert accelerations.has(had)
    assert not accelerations.has(other)


def test_values_of_another_template_of_that_name_are_no_hindrance() -> None:
    deck = make_deck(crank(), "secret", "q1")
    had = [{"r": "9", "h": "0", "omega": "2"}, {"radius": "1"}]
    found = find_earlier_draws(crank(), ["v_x"], deck, had)
    assert (found.count(deck), found.has(deck.combination(0))) == (0, False)

"""The identifiers in a quiz tell an exam from others, and nothing of its secret."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.exam.quizzes import papers, quiz_of
from tests.small_class import generate, write_class


def test_identifiers_are_stable_and_tell_nothing_of_the_secret(small_class: Path) -> None:
    first, again = (papers(small_class / "EXAM") for _ in range(2))
    identifiers = [question.identifier for paper in first for question in paper.questions]
    assert len(set(identifiers)) == len(identifiers) == 12
    assert identifiers == [question.identifier for paper in again for question in paper.questions]
    assert [
        identifier for identifier in identifiers if " " in identifier or "spring" in identifier
    ] == []


def test_a_late_student_leaves_the_exam_s_identifier_as_it_is(tmp_path: Path) -> None:
    write_class(tmp_path)
    assert generate(tmp_path).exit_code == 0
    before = quiz_of(tmp_path / "EXAM").identifier
    with (tmp_path / "roster.csv").open("a", encoding="utf-8") as roster:
        roster.write("late,Lee,\n")
    assert generate(tmp_path, "EXAM", "--force").exit_code == 0
    quiz = quiz_of(tmp_path / "EXAM")
    assert quiz.identifier == before
    assert len({student.student for student in quiz.papers}) == 5


def test_a_reordered_roster_leaves_the_exam_s_identifier_as_it_is(tmp_path: Path) -> None:
    write_class(tmp_path)
    assert generate(tmp_path, "EXAM").exit_code == 0
    head, *students = (tmp_path / "roster.csv").read_text(encoding="utf-8").splitlines()
    reordered = "\n".join([head, *reversed(students)])
    (tmp_path / "roster.csv").write_text(f"{reordered}\n", encoding="utf-8")
    assert generate(tmp_path, "AGAIN").exit_code == 0
    first, again = (quiz_of(tmp_path / name) for name in ("EXAM", "AGAIN"))
    assert first.identifier == again.identifier
    assert next(iter(first.papers)).code != next(iter(again.papers)).code


def test_versions_are_identified_by_their_letters_and_by_no_student(tmp_path: Path) -> None:
    write_class(tmp_path)
    bank = (tmp_path / "bank.toml").read_text(encoding="utf-8")
    (tmp_path / "bank.toml").write_text(f"versions = 2\n{bank}", encoding="utf-8")
    assert generate(tmp_path, "EXAM").exit_code == 0
    for variants in (None, 2):
        quiz = quiz_of(tmp_path / "EXAM", variants=variants)
        found = [question.identifier for paper in quiz.papers for question in paper.questions]
        assert found == [
            f"{quiz.identifier}-{letter}-q{place}" for letter in "AB" for place in (1, 2, 3)
        ]


def test_the_identifier_does_not_come_from_the_secret_that_draws(tmp_path: Path) -> None:
    write_class(tmp_path)
    assert generate(tmp_path, "EXAM", "--seed", "s").exit_code == 0
    before = quiz_of(tmp_path / "EXAM").identifier
    head = json.loads((tmp_path / "EXAM" / "exam.json").read_text(encoding="utf-8"))
    other = dict(head, secret="0" * 64)
    (tmp_path / "EXAM" / "exam.json").write_text(json.dumps(other), encoding="utf-8")
    assert quiz_of(tmp_path / "EXAM").identifier == before
    for name in ("secret", "codes"):
        assert before not in head[name]
    renewed = dict(head, codes="1" * 64)
    (tmp_path / "EXAM" / "exam.json").write_text(json.dumps(renewed), encoding="utf-8")
    assert quiz_of(tmp_path / "EXAM").identifier != before


@pytest.mark.parametrize("kept", [{"seed": "spring"}, {}])
def test_folders_of_earlier_versions_and_without_a_secret_have_an_identifier(
    tmp_path: Path, kept: dict[str, str]
) -> None:
    write_class(tmp_path)
    assert generate(tmp_path, "EXAM", "--seed", "s").exit_code == 0
    head = json.loads((tmp_path / "EXAM" / "exam.json").read_text(encoding="utf-8"))
    older = {name: value for name, value in head.items() if name not in ("secret", "codes")}
    (tmp_path / "EXAM" / "exam.json").write_text(json.dumps({**older, **kept}), encoding="utf-8")
    assert len(quiz_of(tmp_path / "EXAM").identifier) == 8

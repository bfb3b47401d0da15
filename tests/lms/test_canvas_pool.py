"""A pool in Canvas from the file that `kinegrade quiz` wrote to the marks: every ask is drawn by
itself.
"""

from __future__ import annotations

import shutil
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html import unescape
from pathlib import Path
from random import Random

import pytest

from kinegrade.language import Language
from tests.lms.pooled_quiz import TAG
from tests.lms.quiz.packages import bare, files_of
from tests.lms.quiz.test_canvas_class import SPEED, set_exam
from tests.lms.response_files import csv_text
from tests.small_class import STUDENTS, kinegrade, table

MOMENT = "2026-05-01 20:01:01 UTC"
BEFORE = ("name", "id", "sis_id", "submitted")
AFTER = ("n correct", "n incorrect", "score")


@dataclass(frozen=True)
class Item:
    """A variant of an ask as Canvas keeps it: its text without tags, and the right answer."""

    text: str
    right: str
    points: str


def groups(package: Path) -> list[list[Item]]:
    """The groups of a pool, from each of which Canvas draws one item."""
    [quiz] = [text for text in files_of(package).values() if "<item " in text]
    return [
        [
            Item(
                TAG.sub(" ", unescape(item.findtext(".//mattext") or "")),
                item.findtext(".//varequal") or "",
                group.findtext(".//points_per_item") or "",
            )
            for item in group.iter("item")
        ]
        for group in bare(quiz).iter("section")
        if group.get("ident") != "root_section"
    ]


def drawn(package: Path, seed: int) -> list[int]:
    """Which variant of each group a student is put."""
    return [
        Random(f"{seed} {place}").randrange(len(group))
        for place, group in enumerate(groups(package))
    ]


def analysis(package: Path, answers: Mapping[str, Sequence[tuple[int, str]]]) -> str:
    """The Student Analysis: by student which variant of each group was put, and what was typed."""
    found = groups(package)
    header = list(BEFORE)
    places = {}
    for number, group in enumerate(found):
        for variant, item in enumerate(group):
            places[number, variant] = len(header)
            header += [f"{100 + len(header)}: {item.text}", item.points]
    rows = []
    for student, typed in answers.items():
        row = ["x", "7", student, MOMENT, *[""] * (len(header) - len(BEFORE))]
        for number, (variant, text) in enumerate(typed):
            place = places[number, variant]
            row[place : place + 2] = [text, "0.0"]  # what Canvas gave is not looked at
        rows.append([*row, "1", "0", "1.0"])
    return csv_text([*header, *AFTER], *rows)


def perfect(package: Path, seed: int) -> list[tuple[int, str]]:
    """The right answers to what a student is put, with four decimals."""
    return [
        (variant, f"{float(group[variant].right):.4f}")
        for variant, group in zip(drawn(package, seed), groups(package), strict=True)
    ]


def pooled(exam: Path, package: Path, count: int, *options: str) -> None:
    done = kinegrade(
        "quiz", exam, "--to", "qti12", "--variants", str(count), "-o", package, *options
    )
    assert done.exit_code in (0, 1), done.stderr


def grade(exam: Path, folder: Path, content: str) -> tuple[int, str, list[dict[str, str]]]:
    (folder / "analysis.csv").write_text(content, encoding="utf-8")
    marks = folder / "MARKS"
    done = kinegrade("grade", exam, folder / "analysis.csv", "-o", marks, "--from", "canvas")
    return done.exit_code, done.stderr, table(marks / "grades.csv") if marks.exists() else []


@pytest.fixture
def exam(small_class: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(small_class / "EXAM", tmp_path / "EXAM"))


@pytest.mark.parametrize("language", ["en", "zh"])
def test_perfect_students_of_a_canvas_pool_get_all_points(
    exam: Path, tmp_path: Path, language: Language
) -> None:
    package = tmp_path / "pool.zip"
    pooled(exam, package, 3, "--lang", language)
    answers = {student: perfect(package, seed) for seed, student in enumerate(STUDENTS)}
    assert len({tuple(variant for variant, _ in each) for each in answers.values()}) > 1
    status, said, grades = grade(exam, tmp_path, analysis(package, answers))
    assert status == 0, said
    assert [(row["total"], row["out_of"]) for row in grades] == [("15.5", "15.5")] * 4


def test_what_a_student_left_blank_is_the_variant_that_was_put(exam: Path, tmp_path: Path) -> None:
    package = tmp_path / "pool.zip"
    pooled(exam, package, 3)
    answers = {student: perfect(package, seed) for seed, student in enumerate(STUDENTS)}
    student = STUDENTS[0]
    other = 1
    answers[student][0] = (other, "")
    status, said, _ = grade(exam, tmp_path, analysis(package, answers))
    assert status == 0, said
    put = {
        (row["student"], row["question"], row["ask"]): row["key_of"]
        for row in table(tmp_path / "MARKS" / "variants.csv")
    }
    assert put[student, "q1", "v_B"] == STUDENTS[other]


def test_an_answer_that_is_right_on_another_variant_is_wrong(exam: Path, tmp_path: Path) -> None:
    package = tmp_path / "pool.zip"
    pooled(exam, package, 3)
    answers = {student: perfect(package, seed) for seed, student in enumerate(STUDENTS)}
    first = groups(package)[0]
    variant, _ = answers[STUDENTS[1]][0]
    answers[STUDENTS[1]][0] = (variant, f"{float(first[(variant + 1) % 3].right):.4f}")
    status, said, grades = grade(exam, tmp_path, analysis(package, answers))
    assert status == 0, said
    assert [row["total"] for row in grades] == ["15.5", "12.5", "15.5", "15.5"]


def test_a_pool_in_a_finer_unit_is_marked_in_that_unit(tmp_path: Path) -> None:
    exam = set_exam(tmp_path, SPEED, "student,name\nS1,Ann\nS2,Bo\n")
    package = tmp_path / "pool.zip"
    pooled(exam, package, 2)
    [group] = groups(package)
    assert [
        item for item in group if "Mind the unit: mm/s here" not in " ".join(item.text.split())
    ] == []
    answers = {"S1": [(1, group[1].right)], "S2": [(0, group[0].right)]}
    status, said, grades = grade(exam, tmp_path, analysis(package, answers))
    assert status == 0, said
    assert "q1.v_y is in mm/s there, and converted" in said
    assert [row["total"] for row in grades] == ["1", "1"]

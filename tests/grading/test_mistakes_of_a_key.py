"""The mistakes that a key lists: what is wrong with them, and which are named."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any

import pytest

from kinegrade.errors import ExamError
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.keyed_exam import read_whole
from kinegrade.grading.grade import grade
from tests.grading.small_exam import STUDENTS, asks, exam, paper, write_exam


def folder_with_mistakes(tmp_path: Path, mistakes: Any) -> Path:
    papers = [paper(student) for student in STUDENTS]
    asks(papers[1])["v_B"]["mistakes"] = mistakes
    return write_exam(tmp_path / "EXAM", exam(), papers)


@pytest.mark.parametrize(
    ("mistakes", "fault"),
    [
        ({"sense-reversed": "fast"}, "\"sense-reversed\" is 'fast'"),
        (3, "mistakes: is broken (Expected `object`, got `int`)"),
    ],
)
def test_what_is_wrong_with_mistakes_is_found_where_an_answer_is_held_against_them(
    tmp_path: Path, mistakes: Any, fault: str
) -> None:
    folder = folder_with_mistakes(tmp_path, mistakes)
    with pytest.raises(ExamError) as caught:
        read_whole(open_exam(folder))
    assert str(caught.value).startswith(
        f'{folder}/key.jsonl: line 2: student "0012": q1.v_B: {fault} - expected '
    )
    assert str(caught.value).endswith(" - restore the exam folder as it was generated")


@pytest.mark.parametrize(
    ("typed", "verdict"),
    [
        ("1.7320508", "right"),
        ("1.9", "mistake"),
        ("0.33333", "mistake"),
        ("2.5", "wrong"),
    ],
)
def test_a_mistake_that_is_written_as_a_fraction_is_compared_too(
    tmp_path: Path, typed: str, verdict: str
) -> None:
    folder = folder_with_mistakes(tmp_path, {"sense-reversed": "1/3", "coriolis-dropped": "1.9"})
    assert mark_of(folder, typed)["verdict"] == verdict


@pytest.mark.parametrize(
    ("typed", "reason"),
    [
        (
            "1.9",
            "coriolis-dropped: leads to 1.9, difference 0, allowed 0.019; so do sense-reversed, "
            "wrong-pole",
        ),
        ("1.92", "wrong-pole: leads to 1.905, difference 0.015, allowed 0.01905"),
        (
            "-5",
            "other-branch: leads to -5, difference 0, allowed 0.05; so does transport-for-absolute",
        ),
    ],
)
def test_all_mistakes_that_lead_to_an_answer_are_named(
    tmp_path: Path, typed: str, reason: str
) -> None:
    folder = folder_with_mistakes(
        tmp_path,
        {
            "wrong-pole": "1.905",
            "sense-reversed": "1.9",
            "coriolis-dropped": "1.9",
            "transport-for-absolute": "-5.04",
            "other-branch": "-5",
        },
    )
    assert mark_of(folder, typed)["reason"] == reason


def mark_of(folder: Path, typed: str) -> dict[str, str]:
    sheet = folder.parent / "answers.csv"
    sheet.write_text(
        f"student,q1.v_B,q1.omega_AB,q2.a_B\n0012,{typed},0,-0.125\n", encoding="utf-8"
    )
    grade(open_exam(folder), sheet, folder.parent / "MARKS")
    with (folder.parent / "MARKS" / "marks.csv").open(encoding="utf-8") as stream:
        return next(
            row for row in csv.DictReader(stream) if (row["student"], row["ask"]) == ("0012", "v_B")
        )

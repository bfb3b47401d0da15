"""Who sat the quiz of another version is told by the file in which the answers are: of 23 students
in the file of version B, two have version C.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.grading.misplaced.class_answers import ClassAnswers
from kinegrade.grading.misplaced.other_versions import OtherVersions
from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from tests.small_class import generate, kinegrade, write_short_class


def told(students: dict[str, tuple[str, str]]) -> list[str]:
    """What is said of students by id, each with a version and the file of the answers."""
    shape = (len(students), 1)
    nothing = np.zeros(shape, dtype=np.bool_)
    files = [file for _, file in students.values()]
    lines = [number if file else 0 for number, file in enumerate(files, 2)]
    answers = ClassAnswers(np.ones(shape), nothing, nothing, nothing, files, lines)
    versions = [version for version, _ in students.values()]
    found = OtherVersions(tuple(students), versions, answers).list_complaints()
    return [open_catalogue(ENGLISH).write(each.fault) for each in found]


def make_class(**counts: int) -> dict[str, tuple[str, str]]:
    """So many students of each version in the file of each, by names such as AB for a student of
    version A in the file of version B.
    """
    return {
        f"{name}{number}": (name[0], f"{name[1:]}.csv" if name[1:] else "")
        for name, count in counts.items()
        for number in range(count)
    }


def test_a_student_in_the_file_of_another_version_is_told() -> None:
    (line,) = told(make_class(AA=12, BB=9, BA=1))
    assert line == (
        "A.csv:23: the student has version B, and 12 of the 13 students in this file have version "
        "A - perhaps the quiz of another version was sat - marked by version B; if version A was "
        "sat: kinegrade exchange EXAM A BA0"
    )


@pytest.mark.parametrize(
    "counts",
    [
        {"AX": 12, "BX": 12},  # one file of all
        {"AA": 12, "BB": 12},  # nobody sat another version
        {"AX": 3, "BX": 1, "AY": 9, "BY": 11},  # few: by chance
        {"AX": 8, "BX": 4, "AY": 4, "BY": 8},  # files of groups
        {"A": 3, "AX": 9, "BX": 9},  # some are absent
    ],
)
def test_files_of_a_class_say_nothing_of_versions(counts: dict[str, int]) -> None:
    assert told(make_class(**counts)) == []


def test_grade_tells_it_by_the_files_of_a_quiz(tmp_path: Path) -> None:
    write_short_class(tmp_path, "versions = 2\n")
    roster = "student,name\n" + "".join(f"S{number},Ann\n" for number in range(1, 21))
    (tmp_path / "roster.csv").write_text(roster, encoding="utf-8")
    result = generate(tmp_path)
    assert result.exit_code == 0, result.stderr
    first, *others = open_exam(tmp_path / "EXAM").head.students
    sat: dict[str, list[str]] = {"A": [], "B": []}
    for each in others:
        sat[each.version].append(each.student)
    other = "A" if first.version == "B" else "B"
    sat[other].append(first.student)
    files = []
    for version, students in sat.items():
        files.append(tmp_path / f"{version}.csv")
        rows = "".join(f"{each},1\n" for each in students)
        files[-1].write_text(f"student,q1.v_x\n{rows}", encoding="utf-8")
    done = kinegrade("grade", tmp_path / "EXAM", *files, "-o", tmp_path / "MARKS")
    assert f"kinegrade exchange EXAM {other} {first.student}" in done.stderr
    assert done.stderr.count("kinegrade exchange") == 1
    assert done.exit_code == 1

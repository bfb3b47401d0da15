"""EXAM and MARKS mixed up on the command line: said in one line that names what was given and what
is expected.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.grading.marked_folder import RIGHT, mark_class
from tests.small_class import kinegrade

ALONE = "{folder}: you gave {given} where {expected} is expected - expected {made} - {way}"
MADE = {
    "EXAM": "an exam folder made by kinegrade generate",
    "MARKS": "a folder of marks made by kinegrade grade",
}


def refusals(folder: Path, *arguments: str) -> list[str]:
    """What a command says; EXAM, MARKS and OUT stand for the paths of a marked class."""
    if not (folder / "EXAM").exists():
        mark_class(folder, {"7": RIGHT})
    places = {name: str(folder / name) for name in ("EXAM", "MARKS", "OUT", "answers.csv")}
    places |= {name: str(folder / name) for name in ("MARKS/grades.csv", "EXAM/exam.json")}
    result = kinegrade(*(places.get(word, word) for word in arguments))
    assert (result.exit_code, result.stdout) == (2, ""), result.stderr
    assert not (folder / "OUT").exists()
    return [line.removeprefix("error: ") for line in result.stderr.splitlines()]


def said(folder: Path, name: str, given: str, expected: str, way: str) -> str:
    return ALONE.format(
        folder=folder / name, given=given, expected=expected, made=MADE[expected], way=way
    )


@pytest.mark.parametrize("command", ["report", "feedback", "sharing"])
def test_exam_and_marks_that_are_swapped_are_one_fault(tmp_path: Path, command: str) -> None:
    assert refusals(tmp_path, command, "MARKS", "EXAM", "-o", "OUT") == [
        said(tmp_path, "MARKS", "MARKS", "EXAM", "swap the two")
    ]


def test_swapped_folders_of_an_export_are_one_fault(tmp_path: Path) -> None:
    arguments = "export", "EXAM", "--to", "generic", "--exam", "MARKS", "-o", "OUT"
    assert refusals(tmp_path, *arguments) == [
        said(tmp_path, "EXAM", "EXAM", "MARKS", "swap the two")
    ]


@pytest.mark.parametrize(
    ("arguments", "given", "expected"),
    [
        ("grade MARKS answers.csv -o OUT", "MARKS", "EXAM"),
        ("grade EXAM answers.csv -o OUT --never-lower EXAM", "EXAM", "MARKS"),
        ("quiz MARKS --to moodle-xml -o OUT", "MARKS", "EXAM"),
        ("export EXAM --to xlsx -o OUT", "EXAM", "MARKS"),
        ("diff MARKS EXAM -o OUT", "EXAM", "MARKS"),
        ("report EXAM EXAM -o OUT", "EXAM", "MARKS"),
        ("feedback MARKS MARKS -o OUT", "MARKS", "EXAM"),
        ("diff EXAM EXAM", "EXAM", "MARKS"),
        ("merge EXAM EXAM -o OUT", "EXAM", "MARKS"),
    ],
)
def test_the_other_kind_of_folder_is_named(
    tmp_path: Path, arguments: str, given: str, expected: str
) -> None:
    assert refusals(tmp_path, *arguments.split()) == [
        said(tmp_path, given, given, expected, "name that folder")
    ]


@pytest.mark.parametrize(
    ("arguments", "given", "expected"),
    [
        ("report EXAM MARKS/grades.csv -o OUT", "MARKS/grades.csv", "MARKS"),
        ("grade EXAM/exam.json answers.csv -o OUT", "EXAM/exam.json", "EXAM"),
    ],
)
def test_a_file_of_a_folder_is_not_the_folder(
    tmp_path: Path, arguments: str, given: str, expected: str
) -> None:
    assert refusals(tmp_path, *arguments.split()) == [
        said(tmp_path, given, "a file", expected, "name that folder")
    ]


@pytest.mark.parametrize("command", ["diff OUT OUT", "merge OUT OUT -o ALL"])
def test_a_missing_folder_that_is_given_twice_is_one_fault(tmp_path: Path, command: str) -> None:
    [fault] = refusals(tmp_path, *command.split())
    assert str(tmp_path / "OUT") in fault


@pytest.mark.parametrize(
    ("arguments", "part", "kind"),
    [
        (
            "quiz EXAM --to moodle-xml --variants 1 -o EXAM/key.jsonl --force",
            "EXAM/key.jsonl",
            "EXAM",
        ),
        ("quiz EXAM --to qti12 -o EXAM/exam.json --force", "EXAM/exam.json", "EXAM"),
        ("report EXAM MARKS -o EXAM/key.jsonl --force", "EXAM/key.jsonl", "EXAM"),
        ("export MARKS --to moodle -o MARKS/grades.csv --force", "MARKS/grades.csv", "MARKS"),
        ("sharing EXAM MARKS -o MARKS/marks.csv --force", "MARKS/marks.csv", "MARKS"),
    ],
)
def test_force_never_replaces_the_key_of_an_exam_by_an_output(
    tmp_path: Path, arguments: str, part: str, kind: str
) -> None:
    mark_class(tmp_path, {"7": RIGHT})
    before = (tmp_path / part).read_bytes()
    words = [
        str(tmp_path / word) if word.startswith(("EXAM", "MARKS")) else word
        for word in arguments.split()
    ]
    result = kinegrade(*words)
    assert (result.exit_code, result.stderr) == (
        2,
        f"error: {tmp_path / part}: is a part of the {kind} folder {kind}, which would be lost - "
        "expected a place of its own for the output - choose another name\n",
    )
    assert (tmp_path / part).read_bytes() == before

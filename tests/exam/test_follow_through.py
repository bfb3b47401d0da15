"""What follows on the papers of an exam folder, from its own templates and the numbers drawn."""

from __future__ import annotations

import json
from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from kinegrade.errors import ExamError
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.follow_through import KEPT, FollowThrough
from kinegrade.problem.template.library.library import find_shipped
from tests.small_class import STUDENTS, key_lines

REMEDY = (
    "expected both to agree - restore the exam folder as it was generated, or use the version "
    "of kinegrade that made it"
)

GIVEN = {
    "r": "1",
    "k": "sqrt(3)",
    "phi": "60",
    "omega": "1",
    "alpha": "0",
}  # omega_AB = 1/3, a_B = -2 omega_AB^2


HEAD = {
    "format": 2,
    "language": "en",
    "questions": [
        {
            "question": "q1",
            "template": "slider-crank",
            "asks": [{"ask": "a_B", "unit": "m/s^2", "points": 1}],
        }
    ],
    "students": [{"student": "007", "name": "Ann"}],
}


def line(student: str, given: Mapping[str, str] = GIVEN) -> str:
    question = {"question": "q1", "drawn": given, "asks": {}}
    return json.dumps({"student": student, "questions": [question]}, ensure_ascii=False)


def write(folder: Path, *lines: str, template: str = "slider-crank") -> FollowThrough:
    """An exam folder of one question, as far as follow-through reads it."""
    (folder / "templates").mkdir()
    text = (find_shipped("templates") / "slider-crank.toml").read_text(encoding="utf-8")
    (folder / "templates" / f"{template}.toml").write_text(text, encoding="utf-8")
    (folder / "exam.json").write_text(json.dumps(HEAD), encoding="utf-8")
    (folder / "key.jsonl").write_bytes("\n".join(lines).encode())
    return FollowThrough(open_exam(folder))


def a_B(follow: FollowThrough, student: str, omega: str = "1/2") -> list[float]:
    """What may follow for a_B, in order."""
    return sorted(map(float, follow(student, "q1", {"omega_AB": Fraction(omega)}, "a_B")))


def test_every_paper_is_worked_out_as_its_key_says(small_class: Path) -> None:
    follow = FollowThrough(open_exam(small_class / "EXAM"))
    for record in key_lines(small_class / "EXAM"):
        for question in record["questions"]:
            follower = follow.instance(record["student"], question["question"])
            assert follower is not None
            for ask, entry in question["asks"].items():
                assert follower.right(ask) == pytest.approx(entry["value"], rel=1e-9, abs=1e-9)
    assert len(follow.instances) == 3 * len(STUDENTS)


def test_what_follows_is_of_the_student_s_own_numbers(tmp_path: Path) -> None:
    follow = write(tmp_path, line("王伟"), "", line("0012", {**GIVEN, "r": "2"}), line("=2"))
    assert pytest.approx(-0.5) in a_B(follow, "王伟")
    assert pytest.approx(-1.0) in a_B(follow, "0012")
    assert pytest.approx(-0.125) in a_B(follow, "=2", "1/4")


@pytest.mark.parametrize(
    ("own", "later"),
    [
        ({}, "a_B"),
        ({"omega_AB": Fraction(0)}, "a_B"),
        ({"omega_XY": Fraction(1)}, "a_B"),
        ({"omega_AB": Fraction(1)}, "a_XY"),
    ],
)
def test_where_nothing_follows(tmp_path: Path, own: Mapping[str, Fraction], later: str) -> None:
    assert write(tmp_path, line("007"))("007", "q1", own, later) == ()


@pytest.mark.parametrize(
    ("student", "content", "template"),
    [
        ("007", line("007", {"r": "1"}), "slider-crank"),
        ("007", line("007", {"r": "1", "phi_0": "60"}), "slider-crank"),
        ("007", '{"student": "007", "questions": []}', "slider-crank"),
        ("007", line("007"), "slider-clank"),
        ("007", line("007", {**GIVEN, "k": "1/10"}), "slider-crank"),
        ("007", line("007", {**GIVEN, "k": "k"}), "slider-crank"),
    ],
)
def test_what_is_not_there_any_more_costs_follow_through_only(
    tmp_path: Path, student: str, content: str, template: str
) -> None:
    assert a_B(write(tmp_path, content, template=template), student) == []


def test_a_line_that_begins_otherwise_is_found_too(tmp_path: Path) -> None:
    turned = json.dumps(dict(reversed(json.loads(line("007")).items())))
    assert pytest.approx(-0.5) in a_B(write(tmp_path, line("1"), turned, line("2")), "007")


def test_only_lines_asked_about_are_read_and_few_are_kept(tmp_path: Path) -> None:
    broken = '{"student": "broken", "questions": 7}'
    follow = write(tmp_path, broken, *(line(str(number)) for number in range(KEPT + 10)))
    assert [number for number in range(KEPT + 10) if not a_B(follow, str(number))] == []
    assert len(follow.instances) == KEPT
    with pytest.raises(ExamError, match=r'key.jsonl: the paper of student "broken": is broken'):
        a_B(follow, "broken")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            None,
            r"key.jsonl: cannot be read \(No such file or directory\) - expected an exam folder",
        ),
        (
            "broken",
            r"key.jsonl: line 1: is broken \(.*\) - expected it as kinegrade generate wrote",
        ),
        (line("008"), r'key.jsonl: no paper of student "007" - expected one'),
    ],
)
def test_a_key_that_cannot_be_read_is_refused(
    tmp_path: Path, text: str | None, message: str
) -> None:
    follow = write(tmp_path, line("007"))
    (tmp_path / "key.jsonl").unlink()
    if text is not None:
        (tmp_path / "key.jsonl").write_text(text)
    with pytest.raises(ExamError, match=message):
        a_B(follow, "007")


RIGHT = {"unit": "m/s^2", "tolerance": {"relative": 0.01, "absolute": 0}, "points": 1}


@pytest.mark.parametrize(
    ("stated", "taken"),
    [
        ({"decimal": "-0.2222222222222222222222222222222222222222"}, True),
        ({"value": -0.22222222222222224}, True),
        ({"decimal": "-0.2222"}, False),
        ({"decimal": "0.2222222222222222222222222222222222222222"}, False),
        ({"decimal": "359.7777777777777777777777777777777777778", "period": "360"}, True),
    ],
)
def test_where_the_key_says_otherwise_nothing_follows_but_a_refusal(
    tmp_path: Path, stated: dict[str, object], taken: bool
) -> None:
    record = json.loads(line("007"))
    record["questions"][0]["asks"] = {"a_B": {**RIGHT, **stated}}
    follow = write(tmp_path, json.dumps(record))
    if taken:
        assert pytest.approx(-0.5) in a_B(follow, "007")
        return
    with pytest.raises(ExamError) as caught:
        a_B(follow, "007")
    assert str(caught.value) == (
        f'{tmp_path / "key.jsonl"}: student "007", q1: a_B is {stated["decimal"]} by the key, but '
        f"-0.222222222222 follows from the values drawn - {REMEDY}"
    )


def test_what_follows_does_not_depend_on_who_was_asked_about_before(tmp_path: Path) -> None:
    students = {str(number): {**GIVEN, "phi": str(15 * number + 15)} for number in range(8)}
    forth = write(tmp_path, *(line(student, given) for student, given in students.items()))
    back = FollowThrough(open_exam(tmp_path))
    found: Any = {student: a_B(forth, student) for student in students}
    assert found == {student: a_B(back, student) for student in reversed(students)}


def test_the_order_of_the_plan(tmp_path: Path) -> None:
    follow = write(tmp_path, line("007"))
    stages = follow.stages("q1", ("a_B", "alpha_AB", "omega_AB"))
    assert stages == [["omega_AB"], ["a_B", "alpha_AB"]]
    assert follow.stages("q9", ("a_B", "omega_AB")) == [("a_B", "omega_AB")]

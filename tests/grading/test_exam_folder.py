"""The exam folder: digits are taken as they stand, and every fault is named."""

from __future__ import annotations

import json
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from kinegrade.errors import ExamError
from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.folder.key import stream as key_stream
from kinegrade.exam.folder.keys import Key
from kinegrade.exam.keyed_exam import read_whole
from kinegrade.numbers.tolerance import ONE_PER_CENT, Tolerance
from tests.grading.small_exam import HALF_ROOT_12, STUDENTS, asks, exam, paper, write_exam

Change = Callable[[dict[str, Any], list[Any]], object]


def test_an_exam_is_read_digit_by_digit(exam_folder: Path) -> None:
    found = read_whole(open_exam(exam_folder))
    assert found.asks == (
        Ask("q1", "v_B", "m/s", Fraction(4)),
        Ask("q1", "omega_AB", "rad/s", Fraction(3)),
        Ask("q2", "a_B", "m/s^2", Fraction(5, 2)),
    )
    assert found.questions == ("q1", "q2")
    assert [(each.student, each.name) for each in found.examinees] == list(STUDENTS.items())
    assert found.examinees[0].keys == {
        "q1.v_B": Key(Fraction(HALF_ROOT_12), ONE_PER_CENT),
        "q1.omega_AB": Key(Fraction(0), Tolerance(Fraction(1, 100), Fraction(2, 1000))),
        "q2.a_B": Key(Fraction(-1, 8), Tolerance(Fraction(1, 10))),
    }


@pytest.mark.parametrize(
    ("stated", "convention"),
    [
        ({"sign": "counter-clockwise positive"}, "ccw"),  # as earlier versions wrote it
        ({"sign": "im Gegenuhrzeigersinn positiv", "convention": "ccw"}, "ccw"),
        ({"sign": "counter-clockwise positive", "convention": None}, None),
    ],
)
def test_a_sign_convention_is_kept(
    stated: dict[str, str | None], convention: str | None, tmp_path: Path
) -> None:
    head = exam()
    head["questions"][1]["asks"][0].update(stated)
    found = open_exam(write_exam(tmp_path / "EXAM", head, [paper(student) for student in STUDENTS]))
    assert [ask.sign for ask in found.asks] == ["", "", stated["sign"]]
    assert [ask.convention for ask in found.asks] == [None, None, convention]


def test_a_unit_that_is_no_proper_text_is_a_fault_of_the_key(tmp_path: Path) -> None:
    head, papers = exam(), [paper(student) for student in STUDENTS]
    for entry in (head["questions"][1]["asks"][0], *(asks(each, 1)["a_B"] for each in papers)):
        entry["unit"] = "\ud800"
    with pytest.raises(ExamError, match=r"key.jsonl: line 1: is broken \(.*\) - expected it as"):
        read_whole(open_exam(write_exam(tmp_path / "EXAM", head, papers)))


def faults(tmp_path: Path, change: Change) -> tuple[str, ...]:
    head, papers = exam(), [paper(student) for student in STUDENTS]
    change(head, papers)
    folder = write_exam(tmp_path / "EXAM", head, papers)
    with pytest.raises(ExamError) as caught:
        read_whole(open_exam(folder))
    return tuple(problem.removeprefix(f"{folder}/") for problem in caught.value.problems)


CHANGES: list[tuple[Change, str]] = [
    (lambda head, _: head.pop("format"), "exam.json: format: missing - expected 1 or 2"),
    (
        lambda head, _: head.pop("questions"),
        "exam.json: questions: missing - expected a list that is not empty",
    ),
    (lambda head, _: head.update(students=[]), "exam.json:1: students: empty - expected a list"),
    (
        lambda head, _: head["students"].append(7),
        "exam.json:1: students[5]: is broken (Expected `object`, got `int`) - expected it as",
    ),
    (
        lambda head, _: head["students"][1].update(student=" "),
        'exam.json:1: students[2]: "student" is empty',
    ),
    (
        lambda head, _: head["students"][1].update(student="００７"),
        'student "007" appears 2 times',
    ),
    (
        lambda head, _: head["questions"][1].update(question="q1"),
        'key.jsonl: line 1: student "007": the asks differ',
    ),
    (
        lambda head, _: head["questions"][1].update(question="total"),
        'questions[2]: "question" is "total"',
    ),
    (
        lambda head, _: head["questions"][1].update(question="<b>"),
        'questions[2]: "question" is "<b>"',
    ),
    (
        lambda head, _: head["questions"][1].update(asks=[]),
        "questions[2]: question q2 asks nothing",
    ),
    (
        lambda head, _: head["questions"][1]["asks"][0].update(points=-1),
        '"points" is -1 - expected zero or more',
    ),
    (
        lambda head, _: head["questions"][1]["asks"][0].update(sign=1),
        "questions[2]: is broken (Expected `str`, got `int` - at `$.asks[0].sign`) - expected",
    ),
    (
        lambda head, _: head["questions"][1]["asks"][0].update(points="many"),
        "\"points\" is 'many' - expected a",
    ),
    (lambda _, papers: papers.pop(2), 'key.jsonl: no line for student "S9" - expected one'),
    (lambda _, papers: papers.append(paper("x")), 'key.jsonl: student "x" is not in exam.json'),
    (
        lambda _, papers: papers.append(paper("007")),
        'key.jsonl: student "007" appears 2 times',
    ),
    (
        lambda _, papers: asks(papers[1]).pop("v_B"),
        'line 2: student "0012": the asks differ from exam.json in q1.v_B',
    ),
    (
        lambda _, papers: asks(papers[1])["v_B"].update(unit="m"),
        "q1.v_B: unit or points differ from exam.json",
    ),
    (
        lambda _, papers: asks(papers[1])["v_B"].update(points=5),
        "q1.v_B: unit or points differ from exam.json",
    ),
    (
        lambda _, papers: asks(papers[1])["v_B"].update(value=1.8),
        "q1.v_B: decimal, value state different numbers",
    ),
    (
        lambda _, papers: asks(papers[1], 1)["a_B"].update(exact="1/8"),
        "q2.a_B: exact, decimal, value state different",
    ),
    (
        lambda _, papers: asks(papers[1])["v_B"].update(decimal="1e"),
        "q1.v_B: \"decimal\" is '1e' - expected a number",
    ),
    (
        lambda _, papers: asks(papers[1])["v_B"].update(value=0, decimal="1e-999"),
        "q1.v_B: \"decimal\" is '1e-999' - expected a number",
    ),
    (
        lambda _, papers: asks(papers[1])["v_B"].update(value=0, decimal=f"0.{101 * '0'}"),
        "000' - expected a number",
    ),
    (
        lambda _, papers: asks(papers[1])["v_B"].update(decimal="inf"),
        "q1.v_B: \"decimal\" is 'inf' - expected a number",
    ),
    (
        lambda _, papers: asks(papers[1])["v_B"].update(decimal=None, value=None),
        'neither "decimal" nor "value"',
    ),
    (
        lambda _, papers: asks(papers[1])["v_B"].pop("tolerance"),
        "line 2: is broken (Object missing required field `tolerance` - at `$.questions[0].asks[",
    ),
    (
        lambda _, papers: asks(papers[1])["v_B"]["tolerance"].update(relative=-1),
        '"relative" is -1 - expected zero',
    ),
    (
        lambda _, papers: asks(papers[1])["v_B"]["tolerance"].update(figures=0),
        '"figures" is 0 - expected a whole number from 1 to 15',
    ),
    (
        lambda _, papers: asks(papers[1])["v_B"]["tolerance"].update(figures="3"),
        "line 2: is broken (Expected `int | null`, got `str` - at",
    ),
    (
        lambda _, papers: asks(papers[1])["v_B"].update(value=float("nan")),
        "line 2: is broken (JSON is malformed: invalid character",
    ),
    (
        lambda _, papers: papers.__setitem__(1, "text"),
        "line 2: is broken (Expected `object`, got `str`) - expected it as",
    ),
]


@pytest.mark.parametrize(("change", "fault"), CHANGES)
def test_each_fault_is_named(tmp_path: Path, change: Change, fault: str) -> None:
    found = faults(tmp_path, change)
    assert any(fault in each for each in found), found
    assert [
        each
        for each in found
        if not each.endswith(" - restore the exam folder as it was generated")
    ] == []


def test_all_faults_are_reported_at_once(tmp_path: Path) -> None:
    def change(_: dict[str, Any], papers: list[Any]) -> None:
        del papers[0]["student"]
        del papers[1]["questions"]
        asks(papers[3])["v_B"]["unit"] = "m"

    assert [each.split(":")[1] for each in faults(tmp_path, change)] == [
        " line 1",
        " line 2",
        " line 4",
    ]


@pytest.mark.parametrize("size", [100, 1500, 2**17])
def test_papers_come_in_the_order_of_the_roster_however_many_lines_are_read_at_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, size: int
) -> None:
    papers = [paper(student) for student in reversed(STUDENTS)]
    del asks(papers[1])["v_B"]["decimal"]
    folder = write_exam(tmp_path / "EXAM", exam(), papers)
    lines = (folder / "key.jsonl").read_text(encoding="utf-8").splitlines()
    (folder / "key.jsonl").write_text("\n \n".join(lines), encoding="utf-8")
    monkeypatch.setattr(key_stream, "_BUFFER", size)
    found = read_whole(open_exam(folder))
    assert found.students == tuple(STUDENTS)
    exact = [each.keys["q1.v_B"].value == Fraction(HALF_ROOT_12) for each in found.examinees]
    assert exact == [True, True, False, True]


def test_a_value_alone_is_a_key(tmp_path: Path) -> None:
    papers = [paper(student) for student in STUDENTS]
    for each in papers:
        del asks(each)["v_B"]["decimal"]
    found = read_whole(open_exam(write_exam(tmp_path / "EXAM", exam(), papers)))
    assert found.examinees[0].keys["q1.v_B"].value == Fraction("1.7320508075688772")


@pytest.mark.parametrize("name", ["exam.json", "key.jsonl"])
@pytest.mark.parametrize(
    ("content", "fault"),
    [
        (
            None,
            "cannot be read (No such file or directory) - expected an exam folder made by "
            "kinegrade generate",
        ),
        (b"\xff", "not UTF-8"),
        (b"{", "broken JSON"),
        (b"[" * 100_000, "nested too deeply"),
        (b'{"format": 1e999999999}', "format: 1e999999999 - expected"),
    ],
)
def test_broken_files_are_named(
    exam_folder: Path, name: str, content: bytes | None, fault: str
) -> None:
    (exam_folder / name).unlink()
    if content is not None:
        (exam_folder / name).write_bytes(content)
    if name == "key.jsonl" and content and content.startswith((b"{", b"[")):
        fault = "line 1: is broken ("
    with pytest.raises(ExamError) as caught:
        read_whole(open_exam(exam_folder))
    assert str(exam_folder / name) in str(caught.value)
    assert fault in str(caught.value)


def test_a_number_too_large_to_be_one_is_refused(exam_folder: Path) -> None:
    text = (
        (exam_folder / "exam.json").read_text().replace('"points": 2.5}', '"points": 1e999999999}')
    )
    (exam_folder / "exam.json").write_text(text)
    with pytest.raises(ExamError, match="expected a number"):
        read_whole(open_exam(exam_folder))
    assert json.loads(text)["format"] == 1


def test_significant_figures_give_the_numbers_that_agree(tmp_path: Path) -> None:
    papers = [paper(student) for student in STUDENTS]
    for each in papers:
        asks(each)["v_B"]["tolerance"] = {"relative": 0, "absolute": 0, "figures": 3}
        asks(each)["omega_AB"]["tolerance"]["figures"] = 3
    keys = read_whole(open_exam(write_exam(tmp_path / "EXAM", exam(), papers))).examinees[0].keys
    assert keys["q1.v_B"].interval == (Fraction("1.725"), Fraction("1.735"))  # of 1.73205
    assert keys["q1.omega_AB"].interval == (
        Fraction("-0.002"),
        Fraction("0.002"),
    )  # zero has no figures


def test_all_faults_of_a_head_stand_with_their_lines(exam_folder: Path) -> None:
    head = exam()
    head["language"] = "la"
    head["title"] = 1
    head["students"][1]["name"] = 7
    head["students"][2]["student"] = " "
    (exam_folder / "exam.json").write_text(json.dumps(head, indent=0), encoding="utf-8")
    with pytest.raises(ExamError) as caught:
        open_exam(exam_folder)
    assert [problem.split("exam.json")[1].split(" - ")[0] for problem in caught.value.problems] == [
        ": is broken (Expected `str`, got `int`",
        ':4: language: "la"',
        ":43: students[2]: is broken (Expected `str`, got `int`",
        ':49: students[3]: "student" is empty',
    ]


def test_a_key_that_stands_twice_in_a_head_is_refused(exam_folder: Path) -> None:
    file = exam_folder / "exam.json"
    file.write_text('{"format": 1, "language": "en", "language": "zh"}', encoding="utf-8")
    with pytest.raises(ExamError) as caught:
        open_exam(exam_folder)
    assert str(caught.value) == (
        f'{file}: "language" stands twice in one object: leave one of the two out - expected an '
        "exam folder made by kinegrade generate in JSON "
        "- restore the exam folder as it was generated"
    )

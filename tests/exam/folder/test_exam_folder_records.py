"""What an exam folder gives of its files: the head, single lines of the key, templates, printed
orders; and how it refuses what is damaged.
"""

from __future__ import annotations

import json
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from kinegrade.errors import ExamError
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.folder.exam_secret import FromWords, RandomSecret
from kinegrade.exam.folder.records import Candidate
from tests.grading.small_exam import STUDENTS, exam, paper, write_exam

RESTORE = "restore the exam folder as it was generated"
TEMPLATES = Path(__file__).parent.parent.parent / "data" / "exam-of-0.1" / "templates"


def folder(path: Path, change: dict[str, Any], line: dict[str, Any]) -> Path:
    """An exam folder whose head and whose every line have these fields too."""
    papers = [{**paper(student), **line} for student in STUDENTS]
    return write_exam(path / "EXAM", {**exam(), **change}, papers)


def test_what_format_2_keeps_is_read(tmp_path: Path) -> None:
    head = {"format": 2, "paper_size": "a4", "engine": "typst", "editable": {"a.tex": "0f"}}
    drawn = {"question": "q1", "asks": {}, "drawn": {"phi": "pi/6"}, "parameters": {}}
    opened = open_exam(folder(tmp_path, head, {"place": 3, "version": "B", "questions": [drawn]}))
    assert (opened.head.format, opened.head.paper_size, opened.head.engine) == (2, "a4", "typst")
    assert opened.head.editable == {"a.tex": "0f"}
    line = opened.keys.line_of("S9")
    assert (line.student, line.place, line.version) == ("S9", 3, "B")
    assert line.questions[0].values == {"phi": "pi/6"}


def test_what_format_1_does_not_keep_is_empty_and_its_values_are_those_of_the_key(
    tmp_path: Path,
) -> None:
    stated = {
        "r": {"exact": "7/20", "value": 0.35, "unit": "m"},
        "h": {"exact": None, "value": 1.20, "unit": "m"},
    }
    question = {"question": "q1", "asks": {}, "parameters": stated}
    opened = open_exam(folder(tmp_path, {}, {"questions": [question]}))
    assert (opened.head.paper_size, opened.head.engine) == ("", "")
    line = opened.keys.line_of("007")
    assert (line.place, line.version, line.questions[0].drawn) == (None, "", {})
    assert line.questions[0].values == {"r": "7/20", "h": "1.2"}


def test_numbers_keep_the_digits_that_stand_there(tmp_path: Path) -> None:
    path = folder(tmp_path, {}, {})
    text = (path / "key.jsonl").read_text(encoding="utf-8")
    (path / "key.jsonl").write_text(
        text.replace('"relative": 0.01', '"relative": 0.0100000000000000000001'), encoding="utf-8"
    )
    (path / "exam.json").write_text(
        json.dumps(exam()).replace('"points": 2.5}', '"points": 2.50000000000000000001}'),
        encoding="utf-8",
    )
    opened = open_exam(path)
    stated = opened.keys.line_of("12").questions[0].asks["v_B"]
    assert stated.tolerance.relative == Decimal("0.0100000000000000000001")
    assert opened.asks[2].points == Fraction("2.50000000000000000001")


@pytest.mark.parametrize(
    ("stated", "secret"),
    [
        ({}, None),
        ({"seed": "spring"}, FromWords("spring")),
        ({"reproducible": ""}, FromWords("")),
        (
            {"secret": 32 * "0f", "codes": 32 * "f0", "label": "B"},
            RandomSecret(32 * "0f", 32 * "f0", "B"),
        ),
        ({"secret": "0f", "codes": "f0", "label": "B"}, None),
    ],
)
def test_the_secret_is_read_and_never_shown(
    tmp_path: Path, stated: dict[str, str], secret: object
) -> None:
    opened = open_exam(folder(tmp_path, stated, {}))
    assert opened.head.drawn_from == secret
    assert "0f" not in repr(opened)
    assert "spring" not in repr(opened)


def test_the_candidates_stand_in_the_order_of_the_roster(tmp_path: Path) -> None:
    opened = open_exam(folder(tmp_path, {}, {}))
    assert opened.students == tuple(STUDENTS)
    assert opened.head.candidates["12"] == Candidate("12", "Ann", paper="K7Q2")
    assert opened.head.columns == ("q1.v_B", "q1.omega_AB", "q2.a_B")
    assert opened.head.units["q2.a_B"] == "m/s^2"


def test_a_line_is_found_wherever_it_stands(tmp_path: Path) -> None:
    path = folder(tmp_path, {}, {})
    lines = (path / "key.jsonl").read_bytes().splitlines(keepends=True)
    (path / "key.jsonl").write_bytes(b"\n".join(reversed(lines)))
    (path / "variants.jsonl").write_text(json.dumps(paper("gone")) + "\n", encoding="utf-8")
    opened = open_exam(path)
    assert [
        student
        for student in (*STUDENTS, "gone")
        if opened.keys.line_of(student).student != student
    ] == []
    assert [line.student for line in opened.keys.lines()] == list(reversed(STUDENTS))
    assert [line.student for line in opened.keys.pool_lines()] == ["gone"]
    assert opened.papers_of(["12", "gone"]).keys() == {"12", "gone"}
    assert opened.keys.find_line("nobody") is None


def test_a_student_without_a_line_is_refused_where_one_is_needed(tmp_path: Path) -> None:
    opened = open_exam(folder(tmp_path, {}, {}))
    message = (
        f'{opened.keys.file}: no paper of student "x" - expected one for every student who is marked - name '
        "the exam folder by which these marks were made"
    )
    for look in (opened.keys.line_of, lambda student: opened.papers_of([student])):
        with pytest.raises(ExamError) as caught:
            look("x")
        assert str(caught.value) == message


@pytest.mark.parametrize("name", ["key.jsonl", "variants.jsonl"])
@pytest.mark.parametrize(
    ("line", "fault"),
    [
        (b"[]", "line 5: is broken (Expected `object`, got `array`)"),
        (b'{"student": "\\ud800"}', "line 5: is broken ("),
        (b'{"student": "x", "questions": 1}', 'the paper of student "x": is broken (Expected'),
    ],
)
def test_a_damaged_line_is_named(tmp_path: Path, name: str, line: bytes, fault: str) -> None:
    path = folder(tmp_path, {}, {})
    four = b"".join((path / "key.jsonl").read_bytes().splitlines(keepends=True))
    (path / name).write_bytes(four + line + b"\n")
    opened = open_exam(path)
    with pytest.raises(ExamError) as caught:
        opened.keys.line_of("x")
    assert str(caught.value).startswith(f"{path / name}: {fault}")
    assert str(caught.value).endswith(f" - expected it as kinegrade generate wrote it - {RESTORE}")


@pytest.mark.parametrize("name", ["key.jsonl", "variants.jsonl"])
def test_a_line_that_is_not_utf_8_is_refused(tmp_path: Path, name: str) -> None:
    path = folder(tmp_path, {}, {})
    (path / name).write_bytes(b'{"student": "x", "questions": [], "a": "\xff"}\n')
    opened = open_exam(path)
    for look in (opened.keys.line_of, lambda student: opened.papers_of([student])):
        with pytest.raises(ExamError, match=rf"{name}: cannot be read \(not UTF-8\) - expected an"):
            look("x")


def test_damaged_lines_are_named_by_their_number_when_all_are_read(tmp_path: Path) -> None:
    path = folder(tmp_path, {}, {})
    (path / "variants.jsonl").write_bytes(b"\n7\n")
    opened = open_exam(path)
    for read in (opened.keys.pool_lines, opened.variants):
        with pytest.raises(
            ExamError, match=r"variants.jsonl: line 2: is broken \(Expected `object"
        ):
            list(read())
    (path / "variants.jsonl").write_bytes(b"\xff\n")
    for read in (opened.keys.pool_lines, opened.variants):
        with pytest.raises(ExamError, match=r"variants.jsonl: cannot be read \(not UTF-8\)"):
            list(read())


def test_files_that_are_missing_are_named(tmp_path: Path) -> None:
    opened = open_exam(folder(tmp_path, {}, {}))
    opened.keys.file.unlink()
    reads = {
        "key.jsonl": (lambda: opened.keys.line_of("7"), lambda: list(opened.keys.lines())),
        "bank.toml": (lambda: opened.bank,),
    }
    reads["key.jsonl"] += (opened.printed_orders, lambda: list(opened.papers()))  # type: ignore[assignment]
    for name, each in reads.items():
        for read in each:
            with pytest.raises(ExamError, match=rf"{name}: cannot be read \(No such file"):
                read()
    with pytest.raises(
        ExamError, match=r"solutions/S9.pdf: cannot be read .* kinegrade solutions EXAM, or"
    ):
        opened.solution("S9")


def test_all_faults_of_a_head_are_reported_at_once(tmp_path: Path) -> None:
    head = exam()
    head["language"] = "fr"
    head["students"] = [{"student": "7"}, {"student": "", "name": "x"}, 3]
    head["questions"][0]["asks"][1]["points"] = -3
    head["questions"][1]["asks"] = []
    path = write_exam(tmp_path / "EXAM", head, [])
    with pytest.raises(ExamError) as caught:
        open_exam(path)
    assert [
        problem.removeprefix(f"{path / 'exam.json'}:1: ").removesuffix(f" - {RESTORE}")
        for problem in caught.value.problems
    ] == [
        'questions[1]: is broken ("points" is -3 - expected zero or more - at `$.asks[1].points`) - '
        "expected it as kinegrade generate wrote it",
        "questions[2]: question q2 asks nothing - expected at least one ask",
        "students[1]: is broken (Object missing required field `name`) - expected it as kinegrade "
        "generate wrote it",
        'students[2]: "student" is empty - expected an id',
        "students[3]: is broken (Expected `object`, got `int`) - expected it as kinegrade generate "
        "wrote it",
        'language: "fr" - expected one of de, en, zh, which this version of kinegrade knows',
    ]


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        (
            '{"format": NaN}',
            ": NaN is no number - expected an exam folder made by kinegrade generate in JSON",
        ),
        ("[]", ": a list - expected one JSON object"),
        (
            '{"format": 1.5}',
            ":1: format: 1.5 - expected 1 or 2, the only ones this kinegrade reads",
        ),
    ],
)
def test_a_head_that_is_none_is_refused(tmp_path: Path, text: str, fault: str) -> None:
    (tmp_path / "exam.json").write_text(text, encoding="utf-8")
    with pytest.raises(ExamError) as caught:
        open_exam(tmp_path)
    assert str(caught.value) == f"{tmp_path / 'exam.json'}{fault} - {RESTORE}"


def test_a_template_that_cannot_be_read_costs_those_who_need_it(tmp_path: Path) -> None:
    path = folder(tmp_path, {}, {})
    (path / "templates").mkdir()
    for file in TEMPLATES.glob("slider-crank.toml"):
        (path / "templates" / file.name).write_bytes(file.read_bytes())
    templates = open_exam(path).templates
    assert list(templates.readable) == ["q1"]
    with pytest.raises(ExamError, match=r'EXAM: no template "bar": known here: slider-crank$'):
        templates.all()


def test_orders_are_told_where_they_differ_from_the_bank_s(tmp_path: Path) -> None:
    orders = (["q1", "q2"], ["q2", "q1"], ["q1", "q2"], ["q2", "q1"])
    papers = [
        {**paper(student), "printed": order}
        for student, order in zip(STUDENTS, orders, strict=True)
    ]
    opened = open_exam(write_exam(tmp_path / "EXAM", exam(), papers))
    assert opened.printed_orders() == {"0012": ("q2", "q1"), "12": ("q2", "q1")}
    assert opened.keys.line_of("0012").order == ("q2", "q1")
    plain = open_exam(folder(tmp_path / "EXAM", {}, {}))
    assert plain.printed_orders() == {}
    assert plain.keys.line_of("0012").order == ("q1", "q2")


def test_what_does_not_print_does_not_break_a_message(tmp_path: Path) -> None:
    papers = [*(paper(student) for student in STUDENTS), paper("x\ny\x1b[2J")]
    opened = open_exam(write_exam(tmp_path / "EXAM", exam(), papers))
    with pytest.raises(ExamError) as caught:
        list(opened.papers())
    assert str(caught.value) == (
        f'{opened.keys.file}: student "x·y·[2J" is not in exam.json - expected only its students - '
        f"{RESTORE}"
    )
    with pytest.raises(ExamError, match='no paper of student "a·b" - expected'):
        opened.keys.line_of("a\nb")

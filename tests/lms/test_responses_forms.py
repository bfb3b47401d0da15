"""Responses of Canvas quizzes, of forms, and of the exam's own answer sheet."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path

import pytest

from kinegrade.errors import ExamError, TableError
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.lms.responses.answer_table import SOURCES, read_responses
from tests.lms.response_files import cells, csv_text, responses, told, workbook, write_asks
from tests.said import all_said, said

CANVAS = ("name", "id", "sis_id", "section", "submitted", "attempt")
QUESTIONS = ("101: Find v_B,\nof the slider", "1.0", "102: omega", "1.0", "103: a_B", "2.0")
GOOGLE = ("Timestamp", "Email Address", "Score")
MICROSOFT = (
    "ID",
    "Start time",
    "Completion time",
    "Email",
    "Name",
    "Total points",
    "Quiz feedback",
)
WJX = ("序号", "提交答卷时间", "所用时间", "来源", "来源详情", "来自IP")


def canvas(sis: str, moment: str, *typed: str) -> tuple[str, ...]:
    return (
        "Wei",
        "77",
        sis,
        "1",
        moment,
        "1",
        *(cell for text in typed for cell in (text, "0.0")),
        "1",
        "2",
        "3",
    )


def test_canvas_is_read_by_position_and_attempts_by_their_time(tmp_path: Path) -> None:
    header = (*CANVAS, *QUESTIONS, "n correct", "n incorrect", "score")
    rows = [
        canvas("0012345", "2026-05-02 20:01:01 UTC", "4", "5", "6"),
        canvas("0012345", "2026-05-01 20:01:01 UTC", "1,5", "", "=2"),
    ]
    read = responses(tmp_path, csv_text(header, *rows))
    assert read.source == "canvas"
    assert cells(read) == [
        ("student", "q1.v_B", "q1.omega_AB", "q2.a_B"),
        ("0012345", "1,5", "", "=2"),
        ("0012345", "4", "5", "6"),
    ]
    assert [row.line for row in read.table.rows] == [4, 3]  # the header takes two lines
    assert (
        said(read.assumed[-1]) == "download.csv: 101 is q1.v_B; 102 is q1.omega_AB; 103 is q2.a_B"
    )


def test_canvas_knows_the_id_of_the_institution_from_its_own(tmp_path: Path) -> None:
    write_asks(tmp_path, students={"77": "", "78": "", "0012345": ""})
    read = responses(
        tmp_path, csv_text((*CANVAS, *QUESTIONS), canvas("0012345", "", "1", "2", "3"))
    )
    assert cells(read)[1][0] == "0012345"


def test_questions_from_a_pool_are_found_by_the_names_of_the_asks(tmp_path: Path) -> None:
    pool = (
        "101: v [q1.v_B]",
        "1",
        "102: v [q1.v_B]",
        "1",
        "103: w [omega_AB]",
        "1",
        "104: (q2.a_B)",
        "1",
    )
    rows = [canvas("S9", "", "", "4", "5", "6"), canvas("0012345", "", "7", "", "8", "")]
    read = responses(tmp_path, csv_text((*CANVAS, *pool), *rows))
    assert [row.cells for row in read.table.rows] == [
        ("S9", "4", "5", "6"),
        ("0012345", "7", "8", ""),
    ]


def test_a_canvas_quiz_with_other_questions_is_refused(tmp_path: Path) -> None:
    with pytest.raises(
        TableError,
        match=r'4 columns may hold answers: "101: Find v_B, of the slider", "102: omega", '
        r'"103: a_B", "104: more" - the exam has 3 asks in 2 questions',
    ):
        responses(
            tmp_path,
            csv_text((*CANVAS, *QUESTIONS, "104: more", "1"), canvas("S9", "", "1", "2", "3", "4")),
        )
    with pytest.raises(TableError, match='has no columns like "12345: text" followed by points'):
        responses(tmp_path, csv_text(CANVAS, ("x",) * 6), "canvas")


def test_a_google_form_by_the_order_of_its_questions(tmp_path: Path) -> None:
    header = (
        *GOOGLE,
        "Your name",
        "Student ID *",
        "speed",
        "turning",
        "turning [Score]",
        "acceleration",
    )
    rows = [
        (
            "2026/05/01 3:00:00 PM GMT+3",
            "x@example.org",
            "4 / 5",
            "Wei",
            "0012345",
            "1 m/s",
            "2",
            "1",
            "=3",
        )
    ]
    read = responses(tmp_path, csv_text(header, *rows))
    assert read.source == "google-forms"
    assert cells(read) == [
        ("student", "q1.v_B", "q1.omega_AB", "q2.a_B"),
        ("0012345", "1 m/s", "2", "=3"),
    ]
    assert 'students are identified by "Student ID *" and "Email Address"' in said(read.assumed[1])


def test_a_google_form_by_the_names_of_the_asks_in_any_order(tmp_path: Path) -> None:
    header = ("Timestamp", "Username", "[a_B] in m/s²", "remarks", "Q: q1.V_B?")
    read = responses(tmp_path, csv_text(header, ("", "ZOE@EXAMPLE.ORG", "3", "hard!", "1")))
    assert cells(read) == [("student", "q1.v_B", "q2.a_B"), ("0012346", "1", "3")]


@pytest.mark.parametrize("timestamp", ["Zeitstempel", "时间戳记"])
def test_a_google_form_in_another_language_is_known_by_its_first_column(
    tmp_path: Path, timestamp: str
) -> None:
    header = (timestamp, "E-Mail-Adresse", "[q1.v_B] Antwort")
    read = responses(tmp_path, csv_text(header, ("", "zoe@example.org", "3")))
    assert read.source == "google-forms"
    assert cells(read) == [("student", "q1.v_B"), ("0012346", "3")]


def test_asks_that_differ_in_case_alone_are_told_by_it(tmp_path: Path) -> None:
    write_asks(tmp_path, {"q1": ("v_A", "v_a", "v_Ab")})
    header = ("Timestamp", "Email Address", "q1.v_Ab", "q1.v_a", "q1.v_A")
    read = responses(tmp_path, csv_text(header, ("", "zoe@example.org", "3", "2", "1")))
    assert cells(read) == [("student", "q1.v_A", "q1.v_a", "q1.v_Ab"), ("0012346", "1", "2", "3")]


def test_an_ask_with_two_columns_is_refused(tmp_path: Path) -> None:
    header = ("Timestamp", "Email Address", "q1.v_B", "q1.v_B", "q2.a_B")
    with pytest.raises(
        TableError,
        match=r'q1.v_B is named by the columns "q1.v_B", "q1.v_B" - expected one column '
        r"for each ask - write the ask's name into each question's title",
    ):
        responses(tmp_path, csv_text(header, ("", "zoe@example.org", "3", "2", "1")))


def test_a_microsoft_form_as_the_workbook_it_comes_as(tmp_path: Path) -> None:
    moment = datetime(2026, 5, 1, 9, 30)
    header = [
        *MICROSOFT,
        "学号",
        "Points - 学号",
        "speed\xa0of B",
        "Points - speed\xa0of B",
        "Feedback - speed\xa0of B",
        "q",
        "Points - q",
        "r",
        "Points - r",
    ]
    row = [
        1,
        moment,
        moment,
        "anonymous",
        None,
        3,
        None,
        "0012345",
        0,
        0.5,
        1,
        None,
        "1,5",
        0,
        "==1+1",
        0,
    ]
    path = workbook(tmp_path / "Form(1-1).xlsx", header, row)
    read = read_responses(path, open_exam(write_asks(tmp_path)))
    assert read.source == "ms-forms"
    assert cells(read)[1] == ("0012345", "0.5", "1,5", "")
    assert told(read) == [
        (
            2,
            "the cell holds the formula =1+1 without its value; open the file in the spreadsheet"
            " program and save it",
            "read as blank",
        )
    ]


def test_a_wenjuanxing_questionnaire(tmp_path: Path) -> None:
    header = (*WJX, "1、姓名", "2、学号", "3、速度", "4、角速度", "5、加速度")
    row = (
        "1",
        "2026/5/1 10:00:00",
        "60秒",
        "链接",
        "直接访问",
        "127.0.0.1",
        "王伟",
        "００12345",
        "1 m/s",
        "2",
        "3",
    )
    read = responses(tmp_path, csv_text(header, row).encode("gb18030"))
    assert read.source == "wjx"
    assert cells(read)[1] == ("0012345", "1 m/s", "2", "3")
    assert "download.csv: read as GB18030" in all_said(read.assumed)
    with pytest.raises(
        TableError, match=r"has no questions like 1、学号 - expected the responses of a 问卷星"
    ):
        responses(tmp_path, csv_text(("序号", "x")), "wjx")


def test_what_wenjuanxing_writes_for_nothing_is_nothing(tmp_path: Path) -> None:
    """It was an unreadable answer, and who left all empty was present."""
    header = (*WJX, "1、学号", "2、速度", "3、角速度", "4、加速度")
    sent = ("1", "2026/5/1 10:00:00", "60秒", "链接", "直接访问", "127.0.0.1")
    row = (*sent, "0012345", "(空)", "（跳过）", " (跳过) ")
    read = responses(tmp_path, csv_text(header, row))
    assert cells(read)[1] == ("0012345", "", "", "")
    assert told(read) == []


@pytest.mark.parametrize("kind", ["csv", "xlsx"])
def test_the_answer_sheet_goes_on_as_it_is(tmp_path: Path, kind: str) -> None:
    rows = [
        ("student", "name", "q1.v_B", "q1.omega_AB", "q2.a_B", "note"),
        ("#S9", "Ann", "1,5", " -2", "3E4", "?"),
    ]
    exam, path = write_asks(tmp_path), tmp_path / f"answers.{kind}"
    if kind == "csv":
        path.write_text(csv_text(*rows), encoding="utf-8")
    else:
        workbook(path, *rows)
    read = read_responses(path, open_exam(exam))
    assert read.source == "sheet"
    assert cells(read) == [
        ("student", "name", "q1.v_B", "q1.omega_AB", "q2.a_B", "note"),
        ("S9", "Ann", "1,5", " -2", "3E4", "?"),
    ]


def test_an_answer_sheet_may_name_people_by_address(tmp_path: Path) -> None:
    read = responses(tmp_path, csv_text(("E-mail", "q1.v_B"), ("WEI@example.org", "1")))
    assert cells(read) == [("student", "E-mail", "q1.v_B"), ("0012345", "WEI@example.org", "1")]
    with pytest.raises(
        TableError, match='no column "student" - expected one with the student ids, or one "email"'
    ):
        responses(tmp_path, csv_text(("who", "q1.v_B"), ("WEI@example.org", "1")), "sheet")


def test_what_no_system_writes_is_refused(tmp_path: Path) -> None:
    with pytest.raises(
        TableError,
        match=r"its columns \(a, b ...\) are those of no system known here - expected one "
        r"of moodle, canvas, wjx, ms-forms, google-forms, long, sheet - say which it is, if it is one of them, as with "
        "--from google-forms",
    ):
        responses(tmp_path, "a,b\n1,2\n")
    with pytest.raises(
        TableError,
        match='download.csv: "blackboard" is no system known here - expected one of moodle',
    ):
        responses(tmp_path, "a,b\n1,2\n", "blackboard")
    assert SOURCES == ("moodle", "canvas", "wjx", "ms-forms", "google-forms", "long", "sheet")


@pytest.mark.parametrize("source", SOURCES)
@pytest.mark.parametrize(
    "content",
    [
        "a\n",
        "\n",
        "student\n\n",
        '"',
        ",,,,\n",
        "q1.v_B,q1.v_B,student,student\n1,2,3\n",
        "Timestamp\n",
        "1: ,1\n",
        "x,x,x,Grade/1,1,1,1\n",
        "Grade/1,Response 1,Response 2,Response 3\n1,1,1,1\n",
        "序号,1、\n",
        "a\x00b,c\n",
        "Timestamp,Email Address,[v_B],[omega_AB],[a_B]\nragged\n,zoe@example.org,1,2,3,4,5\n",
    ],
)
def test_odd_files_are_read_or_refused_and_never_more(
    tmp_path: Path, source: str, content: str
) -> None:
    read, problems = None, ("",)
    try:
        read = responses(tmp_path, content, source)
    except TableError as refusal:
        problems = refusal.problems
    if read is None:
        assert [problem for problem in problems if problem.count(" - ") < 2] == []
    else:
        assert len(read.table.rows) + len(read.table.complaints) >= content.count(
            "\n"
        ) - 1 - content.count("\n\n")


@pytest.mark.sampled(6, by="source")
@pytest.mark.parametrize("source", SOURCES)
def test_a_cell_of_ten_megabytes_is_passed_on(tmp_path: Path, source: str) -> None:
    long = "part 1: a; part 2: " * 500_000
    header = ("a", "b", "student", "Grade/1", "Response 1", "Response 2", "Response 3")
    row = ("x", "y", "S9", "1", long, "2", "3")
    try:
        read = responses(tmp_path, csv_text(header, row), source)
    except TableError:
        pass
    else:
        assert long in read.table.rows[0].cells


def test_a_broken_exam_is_told(tmp_path: Path) -> None:
    exam = write_asks(tmp_path)
    (exam / "exam.json").write_text('{"format": 1, "questions": [1]}')
    with pytest.raises(
        ExamError, match=r"exam.json:1: questions\[1\]: is broken \(.*\) - expected it as kinegrade"
    ):
        responses(tmp_path, "student,q1.v_B\n")
    (exam / "exam.json").unlink()
    with pytest.raises(
        ExamError,
        match=r"exam.json: cannot be read \(No such file or directory\) - expected an exam",
    ):
        responses(tmp_path, "student,q1.v_B\n")

"""Feedback sheets: the numbers, what was typed, how it was read, what is right and why."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Literal

import pytest

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.language.catalogue import Catalogue, open_catalogue
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.press.html.feedback import write_feedback_html
from kinegrade.press.markdown.feedback import write_feedback_markdown
from kinegrade.press.sheet import FeedbackRow
from kinegrade.reports.feedback.feedback import make_feedback_sheets
from tests.grading.feedback_sheets import WORDING, sheets
from tests.grading.marked_folder import RIGHT, mark_class


def test_a_row_says_by_a_shape_whether_it_earned_its_points(tmp_path: Path) -> None:
    (sheet,) = sheets(tmp_path, (RIGHT[0], "", "?"))
    marks = [row.mark for question in sheet.questions for row in question.rows]
    assert marks == ["✓", "–", "✗"]
    page, text = write_feedback_html(sheet), write_feedback_markdown(sheet)
    for mark in marks:
        assert f"<strong>{mark}</strong>" in page
        assert f"| {mark} **" in text


def test_a_sheet_tells_the_numbers_the_sign_and_the_tolerance(tmp_path: Path) -> None:
    wording = replace(
        WORDING,
        conventions={"q1.v_B": "positive to the right"},
        parameters={("q1", "r"): "r"},
        givens={("q1", "r"): "m", ("q1", "gone"): "m"},
    )
    exam, marks = mark_class(tmp_path, {"7": RIGHT}, parameters=lambda student: {"r": 0.2})
    ((_, sheet),) = make_feedback_sheets(MarksFolder(marks), open_exam(exam), wording, "en")  # type: ignore[arg-type]
    question = sheet.questions[0]
    assert question.givens == "$r = 0.2$\u202fm"
    assert question.rows[0].sign == "positive to the right"
    page, text = write_feedback_html(sheet), write_feedback_markdown(sheet)
    for shown in ("positive to the right", question.rows[0].allowed):
        assert shown in page
        assert shown in text
    assert "Your numbers: $r = 0.2$\u202fm" in text


def test_a_sheet_says_what_was_typed_how_it_was_read_what_is_right_and_why(tmp_path: Path) -> None:
    (sheet,) = sheets(tmp_path, ("-1,732 m/s", "7 m/s", " "))
    first, second = sheet.questions
    v_b, omega = first.rows
    assert (v_b.typed, v_b.read_as, v_b.exact, v_b.right, v_b.verdict, v_b.points) == (
        "-1,732 m/s",
        "read as −1.732\u202fm/s",
        r"\sqrt{3}",
        "≈ 1.73205\u202fm/s",
        "wrong",
        "0 / 4",
    )
    assert "the sign is opposite: perhaps" in v_b.remark
    assert (omega.verdict, omega.remark) == (
        "wrong unit",
        "The unit belongs to another kind of quantity.",
    )
    assert '"m/s" measures a speed' in omega.reason
    assert (second.rows[0].typed.strip(), second.rows[0].verdict, second.rows[0].remark) == (
        "",
        "no answer",
        "",
    )
    assert (sheet.total, first.points, second.points) == ("0 / 9.5", "0 / 7", "0 / 2.5")
    assert (first.heading, first.title, second.title) == ("Question 1", "Crank $OA$ & rod", "")


def test_numbers_have_the_decimal_mark_of_the_language(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Catalogue, "decimal_mark", ",")
    (sheet,) = sheets(tmp_path, ("1.760 m/s", "0", "-0.125"))
    (first, _), (second,) = (question.rows for question in sheet.questions)
    assert (first.typed, first.read_as) == ("1.760 m/s", "read as 1,760\u202fm/s")
    assert (first.right, sheet.total) == ("≈ 1,73205\u202fm/s", "5,5 / 9,5")
    assert "off by 1,6 % where" in first.remark
    assert (second.right, second.points) == ("−0,125\u202fm/s²", "2,5 / 2,5")


def test_a_close_answer_is_told_by_how_much_it_is_off(tmp_path: Path) -> None:
    (sheet,) = sheets(tmp_path, ("1.76", "0", "-0.125"))
    assert "off by 1.6 % where 1 % is allowed" in sheet.questions[0].rows[0].remark
    assert sheet.guesses


@pytest.mark.parametrize(
    ("share", "shown", "remark"),
    [("0.005", "±0.0086", "0.5 % is allowed"), ("0.015", "±0.025", "1.5 % is allowed")],
)
def test_what_is_allowed_is_what_the_class_was_marked_by(
    tmp_path: Path, share: str, shown: str, remark: str
) -> None:
    """Not what the paper allows, where a policy says otherwise."""
    exam, marks = mark_class(tmp_path, {"7": ("1.76", "0", "-0.125")})
    policy = f"tolerance = {{ relative = {share} }}\n"
    (marks / "policy.toml").write_text(policy, encoding="utf-8")
    ((_, sheet),) = make_feedback_sheets(MarksFolder(marks), open_exam(exam), WORDING, "en")
    row = sheet.questions[0].rows[0]
    assert row.allowed == f"{shown}\u202fm/s"
    assert remark in row.remark


@pytest.mark.parametrize(
    ("typed", "shown"),
    [
        ("1.76", "off by 1.6 % where 1 % is allowed on this side"),
        ("1.6499", "off by 4.74 % where 4.73 % is allowed on this side"),
    ],
)
def test_where_more_is_allowed_on_one_side_a_sheet_tells_both_bounds(
    tmp_path: Path, typed: str, shown: str
) -> None:
    """By two figures 1.73205 is right from 1.65 to 1.75."""
    exam, marks = mark_class(tmp_path, {"7": (typed, "0", "-0.125")})
    (marks / "policy.toml").write_text("tolerance = { figures = 2 }\n", encoding="utf-8")
    ((_, sheet),) = make_feedback_sheets(MarksFolder(marks), open_exam(exam), WORDING, "en")
    row = sheet.questions[0].rows[0]
    assert row.allowed == "from 1.65 to 1.75\u202fm/s"
    assert shown in row.remark
    for page in (write_feedback_html(sheet), write_feedback_markdown(sheet)):
        assert row.allowed in page


def test_who_was_absent_reads_so(tmp_path: Path) -> None:
    exam, marks = mark_class(tmp_path, {"7": RIGHT, "8": ()})
    found = make_feedback_sheets(MarksFolder(marks), open_exam(exam), WORDING, "en")
    assert [sheet.total for _, sheet in found] == ["9.5 / 9.5", "absent, 0 / 9.5"]


def test_right_answers_get_no_remarks(tmp_path: Path) -> None:
    (sheet,) = sheets(tmp_path, RIGHT)
    assert [
        row for question in sheet.questions for row in question.rows if row.remark or row.reason
    ] == []
    assert sheet.total == "9.5 / 9.5"
    assert not sheet.guesses


@pytest.mark.parametrize(
    ("besides", "language", "remark"),
    [
        ("", "en", "The Coriolis acceleration was left out."),
        (
            "; so does sense-reversed",
            "en",
            "The Coriolis acceleration was left out. Or: The sense is reversed.",
        ),
        (
            "; so do sense-reversed, unheard-of",
            "zh",
            "The Coriolis acceleration was left out.或者：The sense is reversed.",
        ),
    ],
)
def test_known_mistakes_are_told_by_their_sentences(
    tmp_path: Path, besides: str, language: Literal["en", "zh"], remark: str
) -> None:
    marked = f'mistake,2,4,"coriolis-dropped: leads to 1, difference 0, allowed 0.01{besides}"'
    row = row_marked_as(marked, tmp_path, language)
    assert (row.verdict, row.points, row.remark) == (
        {"en": "wrong", "zh": "错误"}[language],
        "2 / 4",
        remark,
    )


@pytest.mark.parametrize(
    ("out_of", "language", "remark"),
    [
        ("0", "en", "This was taken out of the marking."),
        ("4", "en", "This was not marked: everybody who handed in gets the points."),
        ("4", "zh", "该小问不评分，凡交卷者均得满分。"),
    ],
)
def test_a_void_answer_is_told_what_became_of_its_points(
    tmp_path: Path, out_of: str, language: Literal["en", "zh"], remark: str
) -> None:
    assert (
        row_marked_as(f"void,{out_of},{out_of},void by the policy", tmp_path, language).remark
        == remark
    )


@pytest.mark.parametrize(
    ("typed", "verdict", "reason", "note"),
    [
        ("2 kg", "unreadable", '""kg"" stands after the number; the unit ""m/s"" was expected',
         "数后写有 \"kg\"；应为单位 \"m/s\""),
        ("2 s", "wrong unit", "something else", "something else"),
    ],
)  # fmt: skip
def test_the_note_on_an_answer_is_in_the_language_of_the_sheet(
    tmp_path: Path, typed: str, verdict: str, reason: str, note: str
) -> None:
    marked = f'{verdict},0,4,"{reason}"'
    row = row_marked_as(marked, tmp_path, "zh", typed)
    assert row.reason == note
    english = reason.replace('""', '"')
    assert row_marked_as(marked, tmp_path / "en", "en", typed).reason == english


def row_marked_as(
    marked: str, folder: Path, language: Literal["en", "zh"], typed: str = "1"
) -> FeedbackRow:
    """The first row of a sheet whose line in marks.csv ends so: verdict, points, out of, reason."""
    exam, marks = mark_class(folder, {"7": ("1", "2", "3")})
    file = marks / "marks.csv"
    lines = file.read_text(encoding="utf-8").splitlines()
    lines[1] = f"7,q1,v_B,{typed},1,m/s,{marked},,"
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    ((_, sheet),) = make_feedback_sheets(MarksFolder(marks), open_exam(exam), WORDING, language)
    return sheet.questions[0].rows[0]


def test_a_total_that_was_kept_is_told(tmp_path: Path) -> None:
    exam, marks = mark_class(tmp_path, {"7": ("1", "2", "3")})
    grades = (marks / "grades.csv").read_text(encoding="utf-8")
    (marks / "grades.csv").write_text(grades.replace(",0,9.5,0", ",8,9.5,84.21"), encoding="utf-8")
    header = "student,name,before,before_out_of,by_this_marking,out_of,stands,reason"
    (marks / "kept.csv").write_text(f"{header}\n7,A,8,9.5,0,9.5,8,higher\n", encoding="utf-8")
    ((_, sheet),) = make_feedback_sheets(MarksFolder(marks), open_exam(exam), WORDING, "en")
    assert (sheet.total, sheet.kept) == ("8 / 9.5", True)
    kept = open_catalogue(sheet.language).text("feedback.sheet.kept")
    assert kept in write_feedback_markdown(sheet)
    assert kept in write_feedback_html(sheet)

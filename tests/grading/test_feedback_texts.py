"""Feedback in each language, and what a student typed stays text."""

from __future__ import annotations

import json
from pathlib import Path

from markdown_it import MarkdownIt

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.press.html.feedback import write_feedback_html
from kinegrade.press.markdown.feedback import write_feedback_markdown
from kinegrade.reports.feedback.feedback import make_feedback_sheets
from tests.grading.feedback_sheets import HOSTILE, WORDING, sheets
from tests.grading.marked_folder import RIGHT, Page, mark_class


def test_questions_follow_as_on_the_paper(tmp_path: Path) -> None:
    exam, marks = mark_class(tmp_path, {"7": RIGHT}, parameters=lambda student: {"r": 0.2})
    record = json.loads((exam / "key.jsonl").read_text(encoding="utf-8"))
    (exam / "key.jsonl").write_text(
        json.dumps(record | {"printed": ["q2", "q1"]}), encoding="utf-8"
    )
    ((_, sheet),) = make_feedback_sheets(MarksFolder(marks), open_exam(exam), WORDING, "en")
    assert [question.heading for question in sheet.questions] == [
        "Question 1 (no. 2 in the answer sheet)",
        "Question 2 (no. 1 in the answer sheet)",
    ]


def test_chinese_sheets_are_chinese(tmp_path: Path) -> None:
    (sheet,) = sheets(tmp_path, ("3.4641", "7 m/s", "?"), language="zh")
    rows = [row for question in sheet.questions for row in question.rows]
    assert [row.verdict for row in rows] == ["错误", "单位不符", "无法识别"]
    assert [bool(row.reason) for row in rows] == [False, True, True]
    assert rows[0].remark.startswith("等于正确值的两倍：可能")
    assert '<html lang="zh-CN">' in write_feedback_html(sheet)


def test_nothing_a_student_typed_becomes_a_tag(tmp_path: Path) -> None:
    (plain,) = sheets(tmp_path / "1", ("a", "b", "c"))
    (sheet,) = sheets(tmp_path / "2", HOSTILE)
    page = Page(write_feedback_html(sheet))
    assert page.tags == Page(write_feedback_html(plain)).tags
    assert page.tags.isdisjoint({"script", "a", "img", "link", "iframe"})
    for typed in HOSTILE:
        assert typed in page.text


def test_nothing_a_student_typed_becomes_markdown(tmp_path: Path) -> None:
    (sheet,) = sheets(tmp_path, HOSTILE)
    rendered = (
        MarkdownIt("commonmark", {"html": True})
        .enable("table")
        .render(write_feedback_markdown(sheet))
    )
    page = Page(rendered)
    assert page.tags <= {
        "h1",
        "h2",
        "p",
        "strong",
        "em",
        "table",
        "thead",
        "tbody",
        "tr",
        "th",
        "td",
    }
    for typed in HOSTILE:
        assert typed in page.text


def test_what_was_made_safe_for_spreadsheets_is_shown_as_it_was_typed(tmp_path: Path) -> None:
    _, marks = mark_class(tmp_path, {"7": ("=1+1", "'=1", "-1")})
    ((_, answers),) = MarksFolder(marks).answers_by_student()
    assert [answer.typed for answer in answers] == ["=1+1", "'=1", "-1"]
    assert "'=1+1" in (marks / "marks.csv").read_text(encoding="utf-8")

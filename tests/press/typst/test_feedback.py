"""Feedback sheets as PDF, and the words they are made with, from an exam as `generate` writes
it.
"""

from __future__ import annotations

import re
import shutil
from dataclasses import replace
from io import BytesIO
from pathlib import Path

import pikepdf
import pytest
from pypdf import PdfReader

from kinegrade.errors import TypesetError
from kinegrade.exam.exam_wording import ExamWording, read_exam_wording
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.press.sheet import FeedbackSheet
from kinegrade.press.typst.feedback import FeedbackPress
from kinegrade.reports.feedback.feedback import make_feedback_sheets
from kinegrade.reports.feedback.folder import FeedbackWishes, write_feedback
from tests.grading.marked_folder import RIGHT, mark_class

WORDING = ExamWording({"q1": "Crank $OA$"}, {"q1.v_B": "speed of $B$"}, {"q1.v_B": "v_{B}"})


@pytest.fixture(scope="module")
def press() -> FeedbackPress:
    return FeedbackPress()


def sheet_of(
    folder: Path, cells: tuple[str, ...], wording: ExamWording = WORDING, language: str = "en"
) -> FeedbackSheet:
    exam, marks = mark_class(folder, {"7": cells})
    ((_, sheet),) = make_feedback_sheets(MarksFolder(marks), open_exam(exam), wording, language)  # type: ignore[arg-type]
    return sheet


def text_of(pdf: bytes) -> str:
    return " ".join(page.extract_text() for page in PdfReader(BytesIO(pdf)).pages).replace(
        "\u200b", ""
    )


def test_a_sheet_is_printed_with_what_was_typed_and_what_is_right(
    tmp_path: Path, press: FeedbackPress
) -> None:
    text = text_of(press.feedback(sheet_of(tmp_path, ("-1.732", '#read("/etc/passwd")', "$x$"))))
    for part in (
        "Student 7",
        "−1.732",
        "≈ 1.73205",
        "0 / 9.5",
        "the sign is opposite",
        "$x$",
        "not readable",
    ):
        assert part.replace("−1.732", "-1.732") in text
    assert '#read("/etc/passwd")' in text


def test_a_long_answer_stays_inside_its_column(tmp_path: Path, press: FeedbackPress) -> None:
    pdf = press.feedback(sheet_of(tmp_path, ("9" * 500, "张" * 79, "😀\U000e0001")))
    assert len(PdfReader(BytesIO(pdf)).pages) == 1
    assert "[U+1F600]" in text_of(pdf)


def test_a_number_and_its_unit_stand_on_one_line(tmp_path: Path, press: FeedbackPress) -> None:
    sheet = sheet_of(tmp_path, RIGHT)
    question = sheet.questions[0]
    rows = [
        replace(question.rows[0], exact=exact, right="≈ 5.57615\u202fm/s²")
        for exact in (
            r"\sqrt{3}",
            r"4 \sqrt{2} - 4 \sqrt{34}",
            r"4 \sqrt{2} - \frac{4 \sqrt{34}}{289}",
            r"4 \sqrt{2} - \frac{4 \sqrt{34}}{289} + \sqrt{2}",
            r"4 \sqrt{2} - \frac{4 \sqrt{34}}{289} + \frac{23 \sqrt{2}}{17}",
        )
    ]
    text = text_of(press.feedback(replace(sheet, questions=(replace(question, rows=tuple(rows)),))))
    assert len(re.findall(r"≈ 5\.57615\s?m/s²", text.replace("\n", "|"))) == len(rows)


def test_chinese_sheets_are_printed(tmp_path: Path, press: FeedbackPress) -> None:
    text = text_of(press.feedback(sheet_of(tmp_path, ("3.4641", "0", "?"), language="zh")))
    assert "等于正确值的两倍" in text
    assert "无法识别" in text


def test_the_worked_solution_follows(tmp_path: Path, press: FeedbackPress) -> None:
    sheet = sheet_of(tmp_path, RIGHT)
    alone = press.feedback(sheet)
    both = press.feedback(sheet, press.feedback(sheet))
    assert len(pikepdf.open(BytesIO(both)).pages) == 2 * len(pikepdf.open(BytesIO(alone)).pages)
    assert press.feedback(sheet) == alone


def test_words_that_cannot_be_typeset_are_told(tmp_path: Path, press: FeedbackPress) -> None:
    bad = ExamWording(titles={"q1": "# $\\nosuch$"}, meanings={"q2.a_B": "$\\neither$"})
    with pytest.raises(TypesetError) as raised:
        press.feedback(sheet_of(tmp_path, RIGHT, bad))
    first, second = raised.value.problems
    assert first.startswith("Question 1, title: formula $\\nosuch$: unknown command")
    assert second.startswith("Question 2, meaning: formula $\\neither$: unknown command")


def test_the_words_come_from_the_templates_of_the_exam(small_class: Path) -> None:
    wording = read_exam_wording(open_exam(small_class / "EXAM"), "zh")
    assert wording.titles["q1"] == "曲柄滑块机构"
    assert wording.symbols["q3.omega_AB"] == r"\omega_{AB}"
    assert wording.meanings["q1.v_B"] == "滑块 $B$ 的速度大小"
    assert wording.parameters["q1", "phi"] == r"\varphi"
    assert wording.mistakes["coriolis-dropped"] == "漏掉了科氏加速度。"


def test_a_template_that_cannot_be_read_any_more_costs_its_words_only(
    small_class: Path, tmp_path: Path
) -> None:
    exam = Path(shutil.copytree(small_class / "EXAM", tmp_path / "EXAM"))
    (exam / "templates" / "slider-crank.toml").unlink()
    wording = read_exam_wording(open_exam(exam), "en")
    assert (wording.titles.keys(), "q1.v_B" in wording.symbols) == ({"q2", "q3"}, False)


def test_a_whole_class_gets_its_sheets(
    small_class: Path, tmp_path: Path, press: FeedbackPress
) -> None:
    from kinegrade.grading.grade import grade

    exam = small_class / "EXAM"
    grade(open_exam(exam), exam / "answers.csv", tmp_path / "MARKS")
    written = write_feedback(
        open_exam(exam),
        MarksFolder(tmp_path / "MARKS"),
        tmp_path / "OUT",
        read_exam_wording(open_exam(exam), "en"),
        FeedbackWishes(press.feedback, "en"),
    )
    sheets = sorted(path.name for path in (tmp_path / "OUT" / "sheets").iterdir())
    assert (written.sheets, sheets) == (
        4,
        sorted(path.name for path in (exam / "papers").iterdir()),
    )
    assert "no answer" in text_of((tmp_path / "OUT" / "sheets" / sheets[0]).read_bytes())


def test_a_fraction_in_large_print_has_room_above_what_follows(
    tmp_path: Path, press: FeedbackPress
) -> None:
    sheet = sheet_of(tmp_path, RIGHT)
    (question, *_) = sheet.questions
    row = replace(question.rows[0], exact=r"\frac{3}{8}", right="≈ 0.375", allowed="")
    large = replace(sheet, large=True, questions=(replace(question, rows=(row,)),))
    heights = list_heights(press.feedback(large))
    assert heights["8"] - heights["≈ 0.375"] > 18


def list_heights(pdf: bytes) -> dict[str, float]:
    """How high each piece of text stands, in points."""
    found: dict[str, float] = {}

    def note(text: str, cm: list[float], tm: list[float], *_: object) -> None:
        found[text.strip()] = cm[5] + cm[3] * tm[5]

    for page in PdfReader(BytesIO(pdf)).pages:
        page.extract_text(visitor_text=note)
    return found


@pytest.mark.parametrize("large", [False, True])
def test_no_line_ends_within_a_unit(large: bool, tmp_path: Path, press: FeedbackPress) -> None:
    sheet = sheet_of(tmp_path, RIGHT)
    (question, *_) = sheet.questions
    for length in range(1, 12):
        givens = ", ".join(["$a = 1$\u202frad/s²"] * 12) + length * "."
        words = replace(question, givens=f"{'x' * length} {givens}")
        lines = text_of(press.feedback(replace(sheet, large=large, questions=(words,))))
        assert "rad/ s" not in " ".join(lines.split("\n"))

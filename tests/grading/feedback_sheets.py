"""The feedback sheets of a class, its exam worded in English, and answers that are markup elsewhere."""

from __future__ import annotations

from pathlib import Path

from kinegrade.exam.exam_wording import ExamWording
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.press.sheet import FeedbackSheet
from kinegrade.reports.feedback.feedback import make_feedback_sheets
from tests.grading.marked_folder import mark_class

HOSTILE = ("<script>alert(1)</script>", "|_[x](javascript:alert(1))_$a$", "=cmd|' /C calc'!A0")
WORDING = ExamWording(
    titles={"q1": "Crank $OA$ & rod"},
    meanings={"q1.v_B": "speed of $B$"},
    symbols={"q1.v_B": "v_{B}", "q1.omega_AB": r"\omega_{AB}"},
    mistakes={
        "coriolis-dropped": "The Coriolis acceleration was left out.",
        "sense-reversed": "The sense is reversed.",
    },
)


def sheets(folder: Path, *rows: tuple[str, ...], language: str = "en") -> list[FeedbackSheet]:
    exam, marks = mark_class(folder, {str(place): row for place, row in enumerate(rows)})
    return [
        sheet
        for _, sheet in make_feedback_sheets(MarksFolder(marks), open_exam(exam), WORDING, language)
    ]  # type: ignore[arg-type]

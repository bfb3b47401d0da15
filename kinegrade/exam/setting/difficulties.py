"""What is predicted for the papers of an exam: by its draws alone, before anyone has answered."""

from __future__ import annotations

from kinegrade.exam.setting.kept_exam import KeptExam
from kinegrade.exam.setting.setting import Exam
from kinegrade.students.difficulty import Difficulty


def find_difficulty(exam: Exam, question: str) -> Difficulty:
    """What is predicted for draws of a question of an exam, by its asks with their points."""
    asks = next(each.asks for each in exam.bank.questions if each.identifier == question)
    return Difficulty(exam.filters[question].separation, {ask.name: ask.points for ask in asks})


def predict_kept(kept: KeptExam) -> dict[str, dict[str, float]]:
    """For each student of an exam folder, by question, the points that one mistake costs on the
    average: worked out from the values that the folder keeps.

    Raises BankError, ExamError.
    """
    lines = list(kept.exam.lines())
    exam = Exam(kept.bank, "")
    predicted: dict[str, dict[str, float]] = {line.student: {} for line in lines}
    for name in exam.filters:
        draws = [each.values for line in lines for each in line.questions if each.question == name]
        found = find_difficulty(exam, name).predict(draws)
        for line, points in zip(lines, found.tolist(), strict=True):
            predicted[line.student][name] = points
    return predicted

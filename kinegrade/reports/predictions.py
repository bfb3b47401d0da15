"""What an exam folder lets expect of its papers: how hard each question is, and how far rounding
too coarsely leads from each answer.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from kinegrade.errors import KinegradeError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.setting.difficulties import bound_coarse_rounding, list_draws, predict_kept
from kinegrade.exam.setting.kept_exam import KeptExam


@dataclass(frozen=True)
class Predictions:
    """By student: the points that a mistake costs on the average, by question, and how far off
    answers may be that are rounded too coarsely, by column, in the asks' units.

    Both are empty where the folder no longer says it: its bank or a template cannot be read, or it
    is of format 1.
    """

    difficulties: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    rounding: Mapping[str, Mapping[str, float]] = field(default_factory=dict)


def find_predictions(exam: ExamFolder) -> Predictions:
    """What the folder lets expect; nothing where it cannot be worked out."""
    kept = KeptExam(exam)
    try:
        draws = list_draws(kept)
        return Predictions(predict_kept(kept, draws), bound_coarse_rounding(kept, draws))
    except KinegradeError:
        return Predictions()

"""Papers are alike hard for students who know nothing of how hard they are predicted to be."""

from __future__ import annotations

import numpy as np
import pytest

from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.reports.predictions import find_predictions
from tests.by_hand.equality import deviations, lose
from tests.by_hand.school import Exam

HALF = 0.5
LIKE = 0.8  # a correlation
pytestmark = pytest.mark.xdist_group("by_hand")


def test_papers_differ_half_as_much_as_by_chance(four_figures: Exam) -> None:
    dealt, by_chance = deviations(four_figures)
    assert 0 < dealt <= HALF * by_chance


def test_what_is_predicted_is_what_they_lose(four_figures: Exam) -> None:
    predicted = find_predictions(open_exam(four_figures.folder)).difficulties
    unlike = {}
    for question in four_figures.papers[0].questions:
        number = question.number
        known = [predicted[paper.student][number] for paper in four_figures.papers]
        lost = [lose(paper.question(number)) for paper in four_figures.papers]
        if np.ptp(lost) and np.ptp(known):
            unlike[question.template] = float(np.corrcoef(known, lost)[0, 1])
    assert unlike
    assert {name: found for name, found in unlike.items() if found <= LIKE} == {}

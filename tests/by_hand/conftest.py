"""One exam for each rule of marking, with a question of every fourth template that students are
written for; it is made once.
"""

from __future__ import annotations

import pytest

from tests.by_hand.class_list import TAUGHT
from tests.by_hand.exceptions import NEEDS_FOUR_FIGURES
from tests.by_hand.school import FOUR_FIGURES, THREE_FIGURES, Exam, make_exam

# `make prove` has 300 of every template under both rules: these suffice for every pattern of a sheet
# without work and for a correlation
SAMPLE = tuple(TAUGHT)[::4]
STUDENTS, FEW = 20, 10


@pytest.fixture(scope="session")
def four_figures(tmp_path_factory: pytest.TempPathFactory) -> Exam:
    """The exam for students who carry four figures."""
    folder = tmp_path_factory.mktemp("by-hand") / "four"
    return make_exam(folder, SAMPLE, STUDENTS, FOUR_FIGURES, "by hand")


@pytest.fixture(scope="session")
def three_figures(tmp_path_factory: pytest.TempPathFactory) -> Exam:
    """The exam for students who carry three figures, whose tolerances are honest."""
    folder = tmp_path_factory.mktemp("by-hand") / "three"
    templates = [name for name in SAMPLE if name not in NEEDS_FOUR_FIGURES]
    return make_exam(folder, templates, FEW, THREE_FIGURES, "by hand")

"""The fixed words of worked solutions, one table per language."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class SolutionWords:
    """What the layout of worked solutions prints in addition to the solutions' texts; `{}` takes a
    number or a text.
    """

    worked: str
    name: str
    student: str
    paper: str
    question: str
    question_known: str  # takes the number on this paper, and that in the answer sheet
    page: str  # takes the page's number and the number of pages
    statement: str
    magnitude: str
    direction: str
    results: str


_ENGLISH = SolutionWords(
    worked="Worked solutions",
    name="Name",
    student="Student",
    paper="Paper",
    question="Question {}",
    question_known="Question {} (no. {} in the answer sheet)",
    page="page {} of {}",
    statement="Problem",
    magnitude="magnitude",
    direction="direction",
    results="Results",
)

_CHINESE = SolutionWords(
    worked="题解",
    name="姓名",
    student="学号",
    paper="试卷编号",
    question="第 {} 题",
    question_known="第 {} 题（登分表第 {} 题）",
    page="第 {} 页，共 {} 页",
    statement="题目",
    magnitude="大小",
    direction="方向",
    results="答案",
)


def choose_solution_words(language: str) -> SolutionWords:
    """The words of worked solutions in "en" or "zh".

    >>> choose_solution_words("zh").magnitude
    '大小'
    """
    return {"en": _ENGLISH, "zh": _CHINESE}[language]

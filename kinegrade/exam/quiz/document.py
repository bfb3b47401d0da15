"""A quiz as a learning management system presents it: texts, figures, right numbers and their
tolerances.

`kinegrade.exam.quiz.quiz` makes it of an exam folder, the writers of `kinegrade.lms` lay it out. A
question is the sheet of a paper; numbers are exact fractions in the unit of its row.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction

from kinegrade.language import Language
from kinegrade.numbers.tolerance import USUAL_CARRY
from kinegrade.press.html.solution import NOT_SHOWN, Illustrated
from kinegrade.press.sheet import AnswerRow, QuestionSheet


@dataclass(frozen=True)
class QuizMistake:
    """A wrong answer that a known mistake leads to, its share of the points and what it was."""

    identifier: str
    value: Fraction
    credit: Fraction
    sentence: str  # plain
    low: Fraction | None = None
    high: Fraction | None = None

    @property
    def interval(self) -> tuple[Fraction, Fraction]:
        """What is taken for this mistake, both ends included: as far from its value as the ask's
        rule allows.
        """
        return (
            self.value if self.low is None else self.low,
            self.value if self.high is None else self.high,
        )


@dataclass(frozen=True)
class QuizAsk:
    """One number to be found. Right is what lies from `low` to `high`, both included."""

    identifier: str  # "v_B", as in the answer sheet's columns
    row: AnswerRow
    value: Fraction  # of 40 correct digits where the answer is irrational
    low: Fraction
    high: Fraction
    period: Fraction | None = (
        None  # a full turn, of an angle that is right with any number of turns
    )
    mistakes: tuple[QuizMistake, ...] = ()


@dataclass(frozen=True)
class QuizQuestion:
    """A question as one student's paper has it, and what a quiz adds: the numbers of its answers,
    in the order of the rows.
    """

    identifier: str  # stable and without blanks: of the exam, the paper and the question
    sheet: QuestionSheet
    asks: tuple[QuizAsk, ...]
    solution: Illustrated = NOT_SHOWN  # the worked one, empty where it is not to be shown
    rule: str = ""  # prose: when an answer is right
    digits: int = USUAL_CARRY  # the fewest significant digits to be carried and typed


@dataclass(frozen=True)
class QuizPaper:
    """The questions of one student's paper; student and name are "" where questions are pooled for
    all students. `language` and `title` are the paper's own where they are not those of the quiz.
    """

    code: str  # plain, as are student, name and title
    student: str
    name: str
    questions: tuple[QuizQuestion, ...]
    language: Language | None = None
    title: str = ""


@dataclass(frozen=True)
class Quiz:
    """All papers of an exam, which may come one after another so that a large class needs no more
    memory.

    `identifier` distinguishes the exam from others, even those of the same title. `asks` are those
    of all the papers by question, ahead of them and without known mistakes, for what must be the
    same for a whole class.
    """

    language: Language
    course: str  # plain, as is title
    title: str
    papers: Iterable[QuizPaper]
    identifier: str = ""
    asks: Iterable[tuple[str, QuizAsk]] = ()

    def language_of(self, paper: QuizPaper) -> Language:
        """The language of a paper."""
        return paper.language or self.language

    def title_of(self, paper: QuizPaper) -> str:
        """The title of a paper, plain."""
        return paper.title or self.title

"""What stands on the pages of an exam, of its key and of a gallery of templates, free of any
typesetter.

The setting of an exam, the gallery, a quiz and the feedback fill these values; each typesetter has
its layouts of them. Three kinds of text:

* plain: printed as it is, whatever characters it holds (names, course, codes, units like "m/s^2");
* prose: Markdown with `$...$` LaTeX math (statements, titles, meanings, rules, givens);
* math: LaTeX math without dollar signs (symbols, exact values).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import islice
from typing import TYPE_CHECKING, Literal

from kinegrade.description.said import Description
from kinegrade.figure.scene import Scene
from kinegrade.language import Language
from kinegrade.press.paper_head import PLAIN_HEAD, PaperHead

if TYPE_CHECKING:
    from kinegrade.worked.document import Block  # a paper has none

PaperSize = Literal["a4", "letter"]
MOST_FORMULA_PAGES = 10


@dataclass(frozen=True)
class AnswerRow:
    """One box to be filled in: the quantity asked for, its unit and its positive sense."""

    symbol: str  # math: v_B
    meaning: str  # prose
    unit: str  # plain: "m/s^2", "deg"; "1" for a pure number
    sign: str  # prose, "counter-clockwise positive", what else holds for the box; "" for nothing
    points: Fraction
    tolerance: tuple[str, ...] = ()  # prose, a line each; none where a text states it


@dataclass(frozen=True)
class QuestionSheet:
    """One question as a student sees it, with that student's numbers and figure."""

    number: int  # where it stands on this paper
    identifier: str  # "q1", as in the answer sheet's columns
    title: str  # prose, one line
    points: Fraction
    statement: str  # prose
    figure: Scene | None
    rows: tuple[AnswerRow, ...]
    source: str = ""  # plain, where the problem was published; "" prints nothing
    template: str = ""  # plain, named where its texts cannot be typeset
    space: float = 0.0  # millimetres, at least left for working
    bonus: bool = False  # its points come on top of the total
    described: Description | None = None  # the figure in words


@dataclass(frozen=True)
class Paper:
    """One student's whole paper."""

    language: Language
    course: str  # plain, as are title, date, student, name and code
    title: str
    date: str
    student: str
    name: str
    code: str
    rules: tuple[str, ...]  # prose, one sentence or two each
    questions: tuple[QuestionSheet, ...]
    head: PaperHead = PLAIN_HEAD
    pages: int = 0  # at least: pages for working follow where there are fewer
    large: bool = False  # in letters of 18 points, a question a page, as many pages as that takes

    @property
    def points(self) -> Fraction:
        """The total of all questions that are no bonus."""
        return sum((each.points for each in self.questions if not each.bonus), Fraction(0))


@dataclass(frozen=True)
class FormulaSheet:
    """What is bound behind every paper: a `pdf`, or a `text`, prose; one of the two is empty."""

    pdf: bytes = b""
    text: str = ""


@dataclass(frozen=True)
class KeyParameter:
    """A number drawn for one student, as the question states it."""

    symbol: str  # math
    exact: str | None  # math, without unit; None where only a decimal is known
    decimal: str  # plain
    unit: str  # plain


@dataclass(frozen=True)
class KeyAnswer:
    """A right answer, and the closed interval of what is marked right."""

    symbol: str  # math
    exact: str | None  # math, without unit; None where the answer is a certified enclosure
    decimal: str  # plain, six significant digits
    unit: str  # plain
    interval: str  # plain, "[1.143, 1.166]"
    points: str  # plain


@dataclass(frozen=True)
class KeyEntry:
    """The key of one question of one paper."""

    identifier: str
    title: str  # prose
    parameters: tuple[KeyParameter, ...]
    answers: tuple[KeyAnswer, ...]
    note: str = ""  # plain, of a question that is marked by hand


@dataclass(frozen=True)
class KeyPaper:
    """The key of one student's paper."""

    student: str  # plain, as are name and code
    name: str
    code: str
    entries: tuple[KeyEntry, ...]
    version: str = ""  # plain, a letter where there are versions


@dataclass(frozen=True)
class KeyBook:
    """The instructor's book of all keys; `warning` is printed on every page, `name` is what its
    sources are called.
    """

    language: Language
    course: str
    title: str
    warning: str
    papers: Iterable[KeyPaper]  # they may come one after another, while the papers are printed
    name: str = "key"

    def chunks(self, size: int) -> Iterator[KeyBook]:
        """The same book in parts of `size` papers; an empty book is one empty part."""
        papers = iter(self.papers)
        part = tuple(islice(papers, size))
        while True:
            yield replace(self, papers=part)
            part = tuple(islice(papers, size))
            if not part:
                return


@dataclass(frozen=True, eq=False)  # one is itself alone: quick to look up
class WorkedQuestion:
    """A question of a student's paper with its worked solution."""

    number: int  # where it stands on the student's paper
    identifier: str  # "q1", as in the answer sheet's columns
    title: str  # prose, one line
    statement: str  # prose, with the student's numbers
    blocks: tuple[Block, ...]
    figure: Scene | None = None  # as on the paper
    template: str = ""  # plain, named where its texts cannot be typeset


@dataclass(frozen=True)
class SolutionSheet:
    """The worked solutions of one student's whole paper."""

    language: Language
    course: str  # plain, as are title, date, student, name and code
    title: str
    date: str
    student: str
    name: str
    code: str
    questions: tuple[WorkedQuestion, ...]
    large: bool = False  # in letters of 18 points


@dataclass(frozen=True)
class FeedbackRow:
    """One ask: `allowed` is how far off it may be, `reason` the note made on reading the cell."""

    symbol: str  # math
    meaning: str  # prose
    sign: str  # prose
    typed: str  # plain
    read_as: str  # plain: how it was read; "" where nothing was, or exactly what was typed
    exact: str  # math
    right: str  # plain, as are the next four
    allowed: str
    mark: str
    verdict: str
    points: str
    remark: str  # prose
    guess: bool
    reason: str  # plain


@dataclass(frozen=True)
class FeedbackQuestion:
    """One question, in its place on the paper."""

    heading: str  # plain
    title: str  # prose
    points: str  # plain, "4 / 7"
    givens: str  # prose: the numbers drawn for this paper
    rows: tuple[FeedbackRow, ...]
    note: str = ""  # plain: on its points as a whole


@dataclass(frozen=True)
class FeedbackSheet:
    """One student's sheet in a language, plain text except for its questions; `solution` is the
    name of a file beside it, or ""; `grade` is "" where no grades are given, `subtracted`
    says what is missing from the sum of the points, and why.
    """

    language: Language
    course: str
    title: str
    date: str
    student: str
    name: str
    code: str
    total: str
    kept: bool  # whether the total is a higher one from an earlier marking
    questions: tuple[FeedbackQuestion, ...]
    solution: str = ""
    grade: str = ""
    subtracted: str = ""
    large: bool = False  # in letters of 18 points

    @property
    def guesses(self) -> bool:
        """Whether any remark is a guess."""
        return any(row.guess for question in self.questions for row in question.rows)

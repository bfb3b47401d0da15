"""What stands on the report on a class, free of any typesetter: texts that are written already, and
plots as their numbers.

`kinegrade.reports.classes` makes these values, `press.html` prints them. A text is plain unless it
is said to be prose (Markdown with `$...$` LaTeX math) or math (LaTeX without dollar signs).
"""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.files.tables import Complaint
from kinegrade.language import Language
from kinegrade.press.class_charts import Bar, BoxPlot, HistogramPlot, StackedBar

Plot = HistogramPlot | BoxPlot | Bar | StackedBar


@dataclass(frozen=True)
class Symbol:
    """A symbol, math; None where only the name is known."""

    math: str | None
    name: str


@dataclass(frozen=True)
class AskLine:
    """One ask: how its points were earned; `first` is whether it is the first of its question."""

    question: str
    title: str  # prose
    first: bool
    symbol: Symbol
    meaning: str  # prose
    points: str
    facility: str
    bar: Bar
    discrimination: str
    interval: str  # of its confidence
    answers: StackedBar
    verdicts: str
    note: str


@dataclass(frozen=True)
class LossLine:
    """A reason why points were lost, and how often by ask."""

    reason: str
    count: int
    bar: Bar
    asks: tuple[tuple[Symbol, int], ...]


@dataclass(frozen=True)
class QuestionLosses:
    """Why points of a question were lost."""

    question: str
    title: str  # prose
    rows: tuple[LossLine, ...]


@dataclass(frozen=True)
class HandLine:
    """A question or an ask that has marks by hand: how many, and the means of the points by hand
    and of those by the machine in the same places.
    """

    question: str
    title: str  # prose
    symbol: Symbol  # without math and name for a whole question
    count: int
    by_hand: str
    machine: str
    points: str


@dataclass(frozen=True)
class PartLine:
    """The totals of a part of the class, such as a version or a group, and its facility by
    question.
    """

    name: str
    count: int
    mean: str
    sd: str
    questions: tuple[str, ...]


@dataclass(frozen=True)
class Trend:
    """How points vary with a number; a third has its share, its range and its students."""

    thirds: tuple[tuple[str, str, int], ...]
    correlation: str
    p: str
    adjusted: str


@dataclass(frozen=True)
class TrendLine:
    """How points vary with a number drawn."""

    question: str
    symbol: Symbol
    trend: Trend


@dataclass(frozen=True)
class PredictionLine:
    """How points lost of a question, or of whole papers, vary with what was predicted, in points;
    thirds are those of papers as predicted.
    """

    papers: str
    predicted: str
    trend: Trend


@dataclass(frozen=True)
class PredictedHardness:
    """Whether papers that were predicted to be harder were."""

    verdict: str
    lines: tuple[PredictionLine, ...]


@dataclass(frozen=True)
class Hardness:
    """Whether papers were equally hard: by version, or by the numbers drawn; and as predicted."""

    verdict: str
    versions: tuple[PartLine, ...] = ()
    plot: BoxPlot | None = None
    trends: tuple[TrendLine, ...] = ()
    predicted: PredictedHardness | None = None


@dataclass(frozen=True)
class GradeLine:
    """A grade, the percentage from which on it is given, and how many got it."""

    grade: str
    least: str
    count: int
    share: str
    bar: Bar


@dataclass(frozen=True)
class RankLine:
    """A student's place in the class."""

    rank: int
    student: str
    name: str
    points: str
    grade: str


@dataclass(frozen=True)
class ClassFigures:
    """What is known where anybody answered; a card has a figure and its name, the legend the shade
    and the name of each verdict; `groups` are those of the roster, none where there are not two;
    `passed` and `grades` are of a scale, if there is one; `ranks` are for the instructor alone.
    """

    out_of: str
    cards: tuple[tuple[str, str], ...]
    distribution: HistogramPlot
    asks: tuple[AskLine, ...]
    legend: tuple[tuple[str, str], ...]
    losses: tuple[QuestionLosses, ...]
    hardness: Hardness
    groups: tuple[PartLine, ...] = ()
    passed: str = ""
    grades: tuple[GradeLine, ...] = ()
    ranks: tuple[RankLine, ...] = ()
    by_hand: tuple[HandLine, ...] = ()


@dataclass(frozen=True)
class ClassSheet:
    """The report on a class; `questions` are their names, `complaints` the first of so many."""

    language: Language
    course: str
    title: str
    date: str
    counted: str
    silent: str
    few: bool
    questions: tuple[str, ...]
    figures: ClassFigures | None
    complaints: tuple[Complaint, ...]
    number_of_complaints: int
    more_complaints: str

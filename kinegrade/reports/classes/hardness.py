"""The part of the class report on whether papers were equally hard: versions compared with each
other, or drawn numbers compared with points; and what was predicted.

`page` calls it; `equal_hardness` has the tests.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.grading.wording import Wording
from kinegrade.language.catalogue import Catalogue
from kinegrade.language.message import Message, Text
from kinegrade.press.class_charts import BoxPlot, Summary
from kinegrade.press.class_sheet import Hardness, Symbol, TrendLine
from kinegrade.reports.classes.equal_hardness import (
    ENOUGH,
    SIGNIFICANT,
    ParameterTrend,
    compare_groups,
    find_parameter_trends,
)
from kinegrade.reports.classes.figures import write_decimal, write_p, write_trend
from kinegrade.reports.classes.parts import list_parts, summarise_parts
from kinegrade.reports.classes.predicted_hardness import judge_predictions
from kinegrade.reports.classes.tally import ClassTally
from kinegrade.reports.classes.words import name_question

_MOST_TRENDS = 8
_DIGITS = 9  # of shares: equal ones of different maxima are ties
_TOO_FEW = Message("report.too-few", enough=ENOUGH)


def judge_hardness(
    counts: ClassTally, exam: ExamFolder, wording: Wording, catalogue: Catalogue
) -> Hardness:
    """What the report says of it."""
    enough = len(counts.answered) >= ENOUGH
    predicted = judge_predictions(counts, catalogue) if enough else None
    if any(counts.versions):
        return replace(_compare_versions(counts, exam, catalogue), predicted=predicted)
    if not enough:
        return Hardness(catalogue.write(_TOO_FEW))
    shares = {question: counts.share(question) for question in exam.questions}
    trends = find_parameter_trends(counts.parameters, shares)
    lines = (_describe_trend(trend, wording, catalogue) for trend in trends[:_MOST_TRENDS])
    verdict = catalogue.write(_judge_trends(trends))
    return Hardness(verdict, trends=tuple(lines), predicted=predicted)


def _judge_trends(trends: Sequence[ParameterTrend]) -> Message:
    if not trends:
        return Message("report.same-papers")
    clear = trends[0].adjusted < SIGNIFICANT
    conclusion = Message("report.trend-found") if clear else Message("report.no-trend")
    return Message("report.trends", numbers=len(trends), conclusion=conclusion)


def _describe_trend(trend: ParameterTrend, wording: Wording, catalogue: Catalogue) -> TrendLine:
    """One drawn number, and how points vary with it."""
    known = wording.parameters.get((trend.question, trend.parameter))
    return TrendLine(
        name_question(trend.question, catalogue),
        Symbol(known or None, trend.parameter),
        write_trend(trend, trend.thirds, catalogue),
    )


def _compare_versions(counts: ClassTally, exam: ExamFolder, catalogue: Catalogue) -> Hardness:
    """The versions of an exam compared with each other."""
    lines = list_parts(counts, counts.versions, exam, catalogue)
    names = tuple(
        (_name_version(letter, figures, catalogue), figures)
        for letter, figures in summarise_parts(counts, counts.versions)
    )
    axis, label = catalogue.text("report.percent-axis"), catalogue.text("report.page.hardness")
    verdict = catalogue.write(_judge_versions(counts, catalogue))
    return Hardness(verdict, lines, BoxPlot(names, axis, label))


def _name_version(letter: str, figures: Summary, catalogue: Catalogue) -> str:
    return catalogue.write(Message("report.version-of", letter=letter, students=figures.count))


def _judge_versions(counts: ClassTally, catalogue: Catalogue) -> Text:
    if len(counts.answered) < ENOUGH:
        return _TOO_FEW
    lost = np.round(counts.lost, _DIGITS)  # papers may be out of different points
    known = np.isfinite(lost)
    test = compare_groups(lost[known], np.array(counts.versions)[known].tolist())
    if test is None:
        return ""
    differ = test.p < SIGNIFICANT
    return Message(
        "report.test-of-versions",
        statistic=write_decimal(test.statistic, catalogue),
        p=write_p(test.p, catalogue),
        permutations=test.permutations,
        conclusion=Message("report.versions-differ" if differ else "report.versions-alike"),
    )
